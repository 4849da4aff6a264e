# SPDX-License-Identifier: GPL-3.0-or-later
"""What isolines are written as, one module per kind of data-block: `TYPE` of its objects, `new` and `write`."""
