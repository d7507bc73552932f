# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C during long calls: the library checks now and then whether to stop."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

from ._boundary import call, native
from ._warn import heir

_MDR_CANCEL = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)

# Python handles signals in its main thread alone, which is the one that imports.
if threading.current_thread() is threading.main_thread():
    call(native.set_cancel, _MDR_CANCEL(native.interrupted), None)


@contextmanager
def workers(threads: int | None) -> Iterator[ThreadPoolExecutor]:
    """Threads whose calls into the library end soon where the one that waits for them is interrupted. They warn whom that one
    warns."""
    stop = threading.Event()
    cancel = _MDR_CANCEL(lambda _context: stop.is_set())
    inherit = heir()

    def begin() -> None:
        inherit()
        call(native.set_cancel, cancel, None)

    with ThreadPoolExecutor(threads, initializer=begin) as pool:
        try:
            yield pool
        except BaseException:
            stop.set()
            pool.shutdown(wait=False, cancel_futures=True)
            raise
