# SPDX-License-Identifier: GPL-3.0-or-later
"""Follow long work, and stop it."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from ._boundary import call, native
from .errors import CancelledError

__all__ = ["Progress"]

Step = Callable[[float, "float | None", str], object]
_STOPPED = "the work was stopped by its caller"
_CANCEL = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)
_NOW = threading.local()
"""the function that the library calls in this thread, which another one may replace for a time"""


def _nothing(done: float, total: float | None, what: str) -> None:
    """The step of work that is not followed."""


def _never() -> bool:
    """The stop of work that runs to its end."""
    return False


class Progress:
    """Progress of long work, for the program that waits for it.

    Parameters
    ----------
    step : callable, optional
        Function of (done, total, what), called when a phase of the work begins and after each of its parts: `done` of `total`
        parts, named `what`, as "states". `total` is None for a phase of unknown length. A viscoelastic history calls it from a
        thread of its own.
    stop : callable, optional
        Function without arguments, called between two parts and, about 20 times a second, within calls into the library, in the
        thread that works. If it returns True, the work ends with `CancelledError`.

    Raises
    ------
    CancelledError
        The work ends because `stop` returned True.

    Examples
    --------
    >>> from mdrcontact.progress import Progress
    >>> progress = Progress(step=lambda done, total, what: print(f"{done} of {total} {what}"))
    >>> progress.step(1, 3, "files")
    1 of 3 files
    """

    def __init__(self, step: Step = _nothing, stop: Callable[[], bool] = _never) -> None:
        self._step, self._stop = step, stop

    def step(self, done: float, total: float | None, what: str) -> None:
        """Report `done` of `total` parts named `what`.

        Parameters
        ----------
        done : float
            Number of completed parts.
        total : float or None
            Number of all parts, if it is known.
        what : str
            Name of the parts.

        Raises
        ------
        CancelledError
            The work must stop.
        """
        if self._stop():
            raise CancelledError(_STOPPED)
        self.report(done, total, what)

    def report(self, done: float, total: float | None, what: str) -> None:
        """Report as `step` does, from a thread that only watches the work.

        Parameters
        ----------
        done : float
            As in `step`.
        total : float or None
            As in `step`.
        what : str
            As in `step`.
        """
        self._step(done, total, what)

    @contextmanager
    def listened(self) -> Iterator[None]:
        """Let `stop` end calls into the library that this thread makes within the block.

        Returns
        -------
        context manager
            The block.

        Raises
        ------
        CancelledError
            `stop` returned True.
        """
        if self._stop is _never:
            yield
            return
        raised: list[BaseException] = []

        def is_over(_context: object) -> int:
            try:
                if self._stop():
                    raised.append(CancelledError(_STOPPED))
            except BaseException as problem:  # noqa: BLE001 - also Ctrl-C: it continues where the call returns
                raised.append(problem)
            return int(bool(raised))

        before, _NOW.cancel = getattr(_NOW, "cancel", None), _CANCEL(is_over)
        call(native.set_cancel, _NOW.cancel, None)
        try:
            yield
        except CancelledError:
            if not raised:
                raise
        finally:
            _NOW.cancel = before
            call(native.set_cancel, before or _usual(), None)
        if raised:  # also where the work took the end of a call for a refusal, and went on
            raise raised[0]


def is_stopped() -> bool:
    """Return whether the `stop` that this thread listens to ends its work."""
    cancel = getattr(_NOW, "cancel", None)
    return cancel is not None and bool(cancel(None))


def _usual() -> Any:
    """Return the usual cancel function of this thread: Ctrl-C in the main one."""
    return _CANCEL(native.interrupted) if threading.current_thread() is threading.main_thread() else None
