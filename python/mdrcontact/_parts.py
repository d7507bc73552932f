# SPDX-License-Identifier: GPL-3.0-or-later
"""Independent parts of a long call, on several threads: results, warnings and errors as on one."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import wait
from contextlib import AbstractContextManager, nullcontext
from typing import Any, TypeVar

from ._interrupt import workers
from ._warn import Caution, is_silent, kept, warn_all
from .errors import CancelledError
from .progress import is_stopped
from .threads import team

T = TypeVar("T")
R = TypeVar("R")

_LOOK = 0.05
"""Seconds between two looks whether to stop."""


def _nothing(_done: int) -> None:
    """The step of parts that nobody follows."""


def share(
    work: Callable[[T], R], parts: Iterable[T], *, threads: int | None = None, done: Callable[[int], Any] = _nothing
) -> list[R]:
    """Return the result of each part, in their order; the first part that fails raises its error.

    Parameters
    ----------
    work : callable
        Function of a part. It changes nothing that another part uses. The calls of its thread use one thread.
    parts : iterable
        Parts.
    threads : int, optional
        Number of threads; None is that of `set_threads`.
    done : callable, optional
        Function of the number of parts that are done, called by this thread after each.

    Returns
    -------
    list
        Results.

    Raises
    ------
    CancelledError
        The program that waits for this thread stops it.
    """
    tasks = list(parts)
    count = min(team() if threads is None else threads, len(tasks))
    if count > 1:
        try:
            return _share(work, tasks, count, done)
        except _RefusedError:
            pass
    results: list[R] = []
    for task in tasks:
        results.append(work(task))
        done(len(results))
    return results


class _RefusedError(Exception):
    """The system starts no more threads."""


def _share(work: Callable[[T], R], tasks: list[T], count: int, done: Callable[[int], Any]) -> list[R]:
    results: list[R] = []
    with workers(count) as pool:
        try:
            futures = [pool.submit(_one, work, task) for task in tasks]
        except RuntimeError as refusal:
            raise _RefusedError from refusal
        for future in futures:
            while not future.done():
                if not wait((future,), _LOOK).done and is_stopped():
                    raise CancelledError("the work was stopped by its caller")
            result, problem, found = future.result()
            warn_all(found)
            if problem is not None:
                raise problem
            results.append(result)
            done(len(results))
    return results


def _one(work: Callable[[Any], Any], part: Any) -> tuple[Any, BaseException | None, list[Caution]]:
    """The result of a part or its error, with its warnings."""
    listening: AbstractContextManager[list[Caution]] = nullcontext([]) if is_silent() else kept()
    with listening as found:
        try:
            return work(part), None, found
        except Exception as problem:  # noqa: BLE001 - the thread that waits raises it in its turn
            return None, problem, found
