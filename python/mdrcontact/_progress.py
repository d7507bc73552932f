# SPDX-License-Identifier: GPL-3.0-or-later
"""A progress bar for calls that are marched through time: the library writes how far it is."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from . import _native
from ._boundary import call

PATIENCE = 2.0
"""Seconds before a progress bar is shown."""
LOOK = 0.2
"""Seconds between two looks at how far it is."""


@contextmanager
def marching(samples: int, shown: bool) -> Iterator[None]:
    """While the calling thread marches through so many samples, in rounds of ever shorter steps: a bar of the present round."""
    if not shown:
        yield
        return
    from tqdm import tqdm

    part, done = np.zeros(1), threading.Event()

    def follow() -> None:
        with tqdm(total=samples, unit="samples", delay=PATIENCE, disable=None, leave=False) as bar:
            while not done.wait(LOOK):
                rounds, share = divmod(float(part[0]), 1.0)
                bar.total = samples * (int(rounds) + 1)
                bar.set_description(f"round {int(rounds) + 1}", refresh=False)
                bar.update(samples * (int(rounds) + share) - bar.n)

    watcher = threading.Thread(target=follow, daemon=True)
    call(_native.set_progress, part.ctypes.data)
    watcher.start()
    try:
        yield
    finally:
        call(_native.set_progress, 0)
        done.set()
        watcher.join()
