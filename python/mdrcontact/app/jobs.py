# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of the page: one long job at a time, which can be cancelled, and the last twenty results."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Any, TypeVar

from .._warn import reported_to
from ..errors import MDRError
from ..progress import Progress
from ..threads import all_cores

KEPT = 20
"""Number of results that are kept."""
T = TypeVar("T")


class BusyError(MDRError):
    """Raised for a job that begins while another one runs."""


def _drop(_text: str, _kind: type[Warning]) -> None:
    """Results contain their warnings; the terminal shows none."""


class Job(threading.Thread):
    """Work in a thread of its own."""

    def __init__(self, key: Hashable, what: str, work: Callable[[Progress], Any]) -> None:
        super().__init__(name=what, daemon=True)
        self.key, self._work, self._stop_soon = key, work, threading.Event()
        self.done: tuple[float, float | None, str] = (0, None, what)
        """parts that are done, all parts if known, and their name"""
        self.result: Any = None
        self.problem: Exception | None = None
        """why there is no result; `CancelledError` if the job was cancelled"""

    def cancel(self) -> None:
        """Let the work end soon."""
        self._stop_soon.set()

    def run(self) -> None:
        """Do the work."""
        try:
            with reported_to(_drop), all_cores():
                self.result = self._work(Progress(self._step, self._stop_soon.is_set))
        except (Exception, MemoryError) as problem:  # noqa: BLE001 - the page shows it
            self.problem = problem

    def _step(self, done: float, total: float | None, what: str) -> None:
        self.done = done, total, what


class Jobs:
    """The job that runs, and the last results by key."""

    def __init__(self) -> None:
        self._lock, self._results = threading.Lock(), OrderedDict[Hashable, Any]()
        self.latest: Job | None = None
        """the job that runs, or ran last"""

    def start(self, key: Hashable, what: str, work: Callable[[Progress], Any]) -> Job:
        """Start a job, named `what`; a `BusyError` if another one runs. `find` returns its result by its key."""
        with self._lock:
            if self.latest is not None and self.latest.is_alive():
                raise BusyError(f"{what}: {self.latest.name} is running. Wait for its end, or cancel it.")
            self.latest = Job(key, what, lambda progress: self.keep(key, work(progress)))
            self.latest.start()
            return self.latest

    def cancel(self, wait: bool = False) -> None:
        """Cancel the job that runs. wait : for its end"""
        if self.latest is not None:
            self.latest.cancel()
            self.latest.join() if wait else None

    def now(self, key: Hashable, work: Callable[[], T]) -> T:
        """Return the result of short work, which is done now unless it is kept."""
        found = self.find(key)
        if found is None:
            with reported_to(_drop):
                found = self.keep(key, work())
        return found  # type: ignore[no-any-return]

    def keep(self, key: Hashable, result: T) -> T:
        """Keep a result, and forget the oldest one."""
        with self._lock:
            self._results[key] = result
            self._results.move_to_end(key)
            while len(self._results) > KEPT:
                self._results.popitem(last=False)
        return result

    def forget(self) -> None:
        """End the job that runs, and forget all results."""
        self.cancel(wait=True)
        with self._lock:
            self._results.clear()

    def find(self, key: Hashable) -> Any:
        """Return the result of a key, or None."""
        with self._lock:
            return self._results.get(key)
