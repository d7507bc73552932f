# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of many curves over all cores: force-volume maps, series of indents."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from ..._boundary import thread_count
from ..._interrupt import workers
from ...errors import InvalidArgumentError, MDRError
from .data import Data
from .result import FitResult
from .solve import fit


class FailedFit(NamedTuple):
    """Curve that could not be fitted, from `fit_many`.

    Examples
    --------
    >>> def damaged():
    ...     return mdr.instruments.ForceDepth([1e-9, 2e-9], [1e-3, float("nan")])
    >>> body = mdr.Homogeneous(mdr.Elastic(50e9, 0.17))
    >>> (failed,) = mdr.instruments.fit_many([damaged], mdr.Paraboloid(10e-6), body, ["E"], threads=1)
    >>> print(failed.position, failed.converged, type(failed.error).__name__)
    0 False InvalidArgumentError
    """

    position: int
    """number of the curve, from 0"""
    error: MDRError
    """the exception"""

    converged: bool = False
    """always False, as of a `FitResult` that did not converge"""


def fit_many(
    curves: Iterable[Data | Callable[[], Data]],
    indenter: Any,
    medium: Any,
    free: Any,
    *,
    threads: int = 0,
    progress: Callable[[int], Any] | None = None,
    **options: Any,
) -> list[FitResult | FailedFit]:
    """Fit each of many curves independently, in several threads.

    A curve that cannot be fitted becomes a `FailedFit` and does not stop the others.

    Parameters
    ----------
    curves : iterable
        Data as for `fit`, or functions that return them; an error in such a function is one failure.
    indenter : Profile
        As in `fit`.
    medium : Medium
        As in `fit`.
    free : mapping or iterable of str
        As in `fit`.
    threads : int, optional
        Number of threads >= 1, or 0 for one per core.
    progress : callable, optional
        Function of the number of completed curves, called after each.
    **options
        Further arguments of `fit`.

    Returns
    -------
    list of FitResult or FailedFit
        One result for each curve, in their order.

    Raises
    ------
    InvalidArgumentError
        `threads` is negative.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> def measured(E):
    ...     contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(E, 0.17)))
    ...     return mdr.instruments.ForceDepth(depth, contact.at_depth(depth).force, sd=1e-6)
    >>> body = mdr.Homogeneous(mdr.Elastic(50e9, 0.17))
    >>> results = mdr.instruments.fit_many([measured(70e9), measured(72e9)], mdr.Paraboloid(10e-6), body, ["E"])
    >>> print([f"{result.estimates['E'] / 1e9:.1f}" for result in results])
    ['70.0', '72.0']
    """
    tasks = list(curves)
    if thread_count(threads) < 0:
        raise InvalidArgumentError(f"threads = {threads!r}: it must be at least 1, or 0 for one per core")
    results: list[FitResult | FailedFit] = []

    def one(index: int) -> FitResult | FailedFit:
        try:
            task = tasks[index]
            return fit(task if isinstance(task, Data) else task(), indenter, medium, free, **options)
        except MDRError as problem:
            return FailedFit(index, problem)

    with workers(threads or os.cpu_count()) as pool:
        for done, result in enumerate(pool.map(one, range(len(tasks))), start=1):
            results.append(result)
            if progress is not None:
                progress(done)
    return results
