# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress bars: of loops, and of calls that are marched through time, of which the library writes how far they are."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from ._boundary import call, native

PATIENCE = 2.0
"""Seconds before a progress bar is shown."""
LOOK = 0.2
"""Seconds between two looks at how far it is."""


def bar(total: int, unit: str) -> Any:
    """A bar on a terminal, if it takes long; a context manager."""
    from tqdm import tqdm

    return tqdm(total=total, unit=unit, delay=PATIENCE, disable=None, leave=False)


@contextmanager
def marching(samples: int, shown: bool) -> Iterator[None]:
    """While the calling thread marches through so many samples, in rounds of ever shorter steps: a bar of the present round."""
    if not shown:
        yield
        return
    part, done = np.zeros(1), threading.Event()

    def follow() -> None:
        with bar(samples, "samples") as shown_bar:
            while not done.wait(LOOK):
                rounds, share = divmod(float(part[0]), 1.0)
                shown_bar.total = samples * (int(rounds) + 1)
                shown_bar.set_description(f"round {int(rounds) + 1}", refresh=False)
                shown_bar.update(samples * (int(rounds) + share) - shown_bar.n)

    watcher = threading.Thread(target=follow, daemon=True)
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
    """The time that a call takes of which nothing says how far it is."""
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
