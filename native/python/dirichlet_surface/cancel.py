# SPDX-License-Identifier: GPL-3.0-or-later
"""Stopping work from another thread."""

from . import _native
from ._native import InputError


class CancelToken(_native.CancelToken):
    """A flag that asks work to stop, to be raised from any thread by `cancel()`.

    Work that was given it ends within a fraction of a second by CancelledError. The flag stays raised until `reset()`:
    what begins meanwhile stops at once. `is_cancelled` tells.
    """


def as_token(cancel: CancelToken | None) -> CancelToken:
    """The token, or one that nobody raises. Raises InputError for anything else."""
    if cancel is None:
        return CancelToken()
    if not isinstance(cancel, CancelToken):
        raise InputError(f"this needs a CancelToken, not {type(cancel).__name__}")
    return cancel
