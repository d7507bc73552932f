# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress bars: of loops, and of calls that are integrated in time, whose progress the library writes."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, nullcontext
from typing import Any

import numpy as np

from ._boundary import call, native
from .progress import Progress

PATIENCE = 2.0
"""Seconds before a progress bar is shown."""
LOOK = 0.2
"""Seconds between two readings of the progress."""


def bar(total: int, unit: str) -> Any:
    """A bar on a terminal, if it takes long; a context manager."""
    from tqdm import tqdm

    return tqdm(total=total, unit=unit, delay=PATIENCE, disable=None, leave=False)


@contextmanager
def on_terminal() -> Iterator[Progress]:
    """Progress of work as bars and clocks on a terminal, each phase that takes long in a line of its own."""
    phase, line = "", ExitStack()
    shown: Any = None

    def step(done: float, total: float | None, what: str) -> None:
        nonlocal phase, shown
        if what != phase:
            line.close()
            phase = what
            unit, _, where = what.partition(" in ")
            shown = line.enter_context(waiting(what) if total is None else bar(int(total), unit))
            if total is not None and where:
                shown.set_description(where, refresh=False)
        if total is not None:
            shown.total = total
            shown.update(done - shown.n)

    with line:
        yield Progress(step)


@contextmanager
def marching(samples: int, progress: bool | Progress) -> Iterator[None]:
    """While the calling thread marches through so many samples, in rounds of ever shorter steps: the progress of each round, True
    on a terminal."""
    if not progress:
        yield
        return
    part, done = np.zeros(1), threading.Event()

    def follow(reported: Progress) -> None:
        while not done.wait(LOOK):
            rounds, share = divmod(float(part[0]), 1.0)
            reported.report(round(samples * share), samples, f"samples in round {int(rounds) + 1}")

    def watch() -> None:
        with on_terminal() if progress is True else nullcontext(progress) as reported:
            follow(reported)

    watcher = threading.Thread(target=watch, daemon=True)
    call(native.set_progress, part)
    watcher.start()
    try:
        yield
    finally:
        call(native.set_progress, None)
        done.set()
        watcher.join()


@contextmanager
def waiting(what: str) -> Iterator[None]:
    """The time of a call without a known progress."""
    from tqdm import tqdm

    done = threading.Event()

    def follow() -> None:
        if done.wait(PATIENCE):
            return
        with tqdm(desc=what, bar_format="{desc}: {elapsed}", disable=None, leave=False) as clock:
            if clock.disable:  # no terminal
                return
            clock.start_t -= PATIENCE
            while not done.wait(LOOK):
                clock.refresh()

    watcher = threading.Thread(target=follow, daemon=True)
    watcher.start()
    try:
        yield
    finally:
        done.set()
        watcher.join()
