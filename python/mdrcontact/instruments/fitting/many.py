# SPDX-License-Identifier: GPL-3.0-or-later
"""Many curves at once, over all cores: force-volume maps, series of indents."""

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
    """A curve that could not be fitted, and why."""

    position: int
    """of the curve, from 0"""
    error: MDRError

    converged: bool = False


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
    """Fits each curve on its own; takes the arguments of `fit`. A curve that cannot be fitted becomes a `FailedFit` and does not
    stop the others.

    curves : data, or functions that make them (a curve with NaN is then one failure and not the end)
    threads : at least 1, or 0 for one per core. progress : called with the number of curves done after each
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
