# SPDX-License-Identifier: GPL-3.0-or-later
"""User functions for the library: it calls them while an object is being made, never later."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from .errors import ArgumentTypeError

MDR_FUNCTION = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double, ctypes.POINTER(ctypes.c_double), ctypes.c_void_p)
"""`mdr_function` of mdrcontact.h."""


class Callback:
    """A Python function as a C function.

    An exception must not travel through compiled code: it is kept here, the library gets the status of a failed function, and
    `reraise` raises it after the library has returned and tidied up.
    """

    def __init__(self, name: str, function: Callable[[float], float]) -> None:
        if not callable(function):
            raise ArgumentTypeError(f"{name} = {function!r}: it must be a function of one number")
        self._name = name
        self._function = function
        self._exception: BaseException | None = None
        self.entry = MDR_FUNCTION(self._call)
        """the C function"""

    def reraise(self) -> None:
        """Raises what the user's function raised, if it did."""
        exception, self._exception = self._exception, None
        if exception is not None:
            raise exception

    def _call(self, x: float, y: Any, _context: Any) -> int:
        try:
            value = self._function(x)
            try:
                y[0] = float(value)
            except TypeError as problem:
                raise ArgumentTypeError(f"{self._name}({x!r}) returned {value!r}: it must return a real number") from problem
        except BaseException as exception:  # noqa: BLE001 - KeyboardInterrupt too must wait until the library has returned
            if self._exception is None:
                self._exception = exception
            return 1
        return 0
