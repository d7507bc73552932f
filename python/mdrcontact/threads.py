# SPDX-License-Identifier: GPL-3.0-or-later
"""How many threads share the work on an array."""

from __future__ import annotations

from ._boundary import call, native, thread_count


def set_threads(threads: int) -> None:
    """How many threads the calls of the calling thread may share the work on an array among, from now on; 1 at first.

    threads : at least 1, or 0 for as many as OpenMP offers

    Arrays too small to gain stay on one, and so do structures that are Python functions. The numbers are the same to the last bit
    for any number of threads. Each thread of a program has its own setting.
    """
    call(native.set_threads, thread_count(threads))
