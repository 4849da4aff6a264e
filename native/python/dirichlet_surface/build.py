# SPDX-License-Identifier: GPL-3.0-or-later
"""How this library was built, and how much of the machine it takes."""

from . import _native
from ._arrays import as_count


def build_information() -> dict[str, str]:
    """What a report of a bug should tell, as names and texts.

    version, compiler, eigen, openmesh, pybind11, instruction_set (that the solver's kernels use here), cores.
    """
    return _native.build_information()


def default_memory_budget() -> int:
    """Bytes that solvers keep to when no memory_budget is given: half of the machine's memory."""
    return _native.default_memory_budget()


def set_thread_limit(count: int | None) -> None:
    """How many threads the library shares its work out to, 1 or more; None for as many as there are cores.

    There are never more than cores, and one beside them may search in the background. With 1, work stays in the thread
    that asks for it. Results do not depend on it, bit for bit. Work that has begun goes on with its own. Raises
    InputError.
    """
    _native.set_thread_limit(0 if count is None else as_count(count, "the number of threads", 2**31 - 1))
