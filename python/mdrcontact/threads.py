# SPDX-License-Identifier: GPL-3.0-or-later
"""Number of threads that share the work on an array, or on independent parts of a long call."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from ._boundary import call, native, thread_count

_NOW = threading.local()
"""the number that this thread has set"""


def set_threads(threads: int) -> None:
    """Set how many threads the calls of this thread share their work among.

    The setting belongs to the calling thread; it is 1 at first. It holds for arrays, and for the independent parts of long calls:
    profile intervals, models, drainages and tables of gels, modes of failure. Small arrays, and structures that are Python
    functions, use one thread. Results are bitwise identical for any number of threads.

    Parameters
    ----------
    threads : int
        Number of threads >= 1, or 0 for the number of cores where the work takes long. `OMP_NUM_THREADS` replaces the number of
        cores.

    Raises
    ------
    ArgumentTypeError
        `threads` is not a whole number.
    InvalidArgumentError
        `threads` is negative.

    Examples
    --------
    >>> mdr.set_threads(2)
    >>> glass = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> print(f"{np.sum(glass.modulus(np.linspace(1e-7, 1e-6, 1000))):.6e}")
    7.414272e+13
    >>> mdr.set_threads(1)
    """
    call(native.set_threads, thread_count(threads))
    _NOW.threads = threads


def team() -> int:
    """Return the number of threads for independent parts of a call of this thread."""
    return getattr(_NOW, "threads", 1) or cores()


def cores() -> int:
    """Return the number of cores for this process, or of threads that `OMP_NUM_THREADS` allows."""
    words = os.environ.get("OMP_NUM_THREADS", "").partition(",")[0].strip()
    if words.isdecimal() and int(words) > 0:
        return int(words)
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def all_cores() -> Iterator[None]:
    """Let calls of this thread within the block use all cores."""
    before = getattr(_NOW, "threads", 1)
    set_threads(0)
    try:
        yield
    finally:
        set_threads(before)
