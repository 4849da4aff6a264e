# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m dirichlet_surface MESH --patch ... --out-lines ...`"""

import sys

from .command_line import main

if __name__ == "__main__":
    sys.exit(main())
