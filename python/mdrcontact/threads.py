# SPDX-License-Identifier: GPL-3.0-or-later
"""Number of threads that share the work on an array."""

from __future__ import annotations

from ._boundary import call, native, thread_count


def set_threads(threads: int) -> None:
    """Set how many threads the calls of this thread share an array among.

    The setting belongs to the calling thread; it is 1 at first. Small arrays, and structures that are Python functions, use one
    thread. Results are bitwise identical for any number of threads.

    Parameters
    ----------
    threads : int
        Number of threads >= 1, or 0 for as many as OpenMP offers.

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
