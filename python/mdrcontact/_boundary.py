# SPDX-License-Identifier: GPL-3.0-or-later
"""The one place where Python meets the compiled library: numbers, arrays, handles and statuses are converted here."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from .errors import ArgumentTypeError, InvalidArgumentError, error_class

FloatOrArray = float | NDArray[np.float64]
"""What an evaluation returns: a float for a number, an array of the same shape for an array."""

_ONE_POINT = np.ones(1)


def check(status: int) -> None:
    """Raises the exception that belongs to `status`, with the library's words; does nothing on success."""
    if status:
        raise error_class(status)(_native.last_error().decode("utf-8", "replace").rstrip("\0 "))


def number(name: str, value: Any) -> float:
    """`value` as a float. Range and sign are the library's business, the type is checked here."""
    array = np.asarray(value)
    if array.ndim or array.dtype.kind not in "iuf":
        raise ArgumentTypeError(f"{name} = {value!r} is not allowed: it must be a real number")
    return float(array)


def thread_count(threads: Any) -> int:
    """`threads` as a whole number. Its range is the library's business."""
    if isinstance(threads, bool) or not isinstance(threads, int):
        raise ArgumentTypeError(f"threads = {threads!r} is not allowed: it must be a whole number")
    return threads


def numbers(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """`values` as a contiguous array of float64 of unchanged shape; integers and shorter floats are widened."""
    if np.ma.is_masked(values):
        raise ArgumentTypeError(f"{name} is not allowed: it has masked elements; fill or remove them first")
    try:
        array = np.asarray(values)
    except ValueError as problem:
        raise ArgumentTypeError(f"{name} is not allowed: it must be a rectangular array of real numbers") from problem
    if array.dtype.kind not in "iuf" and array.size:
        raise ArgumentTypeError(f"{name} is not allowed: it must hold real numbers, not {array.dtype}")
    # ascontiguousarray alone would turn a number into an array of one dimension
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


def row(name: str, values: ArrayLike) -> tuple[float, ...]:
    """`values` as a tuple of floats: for tables that belong to an object. They must have one dimension and not be empty."""
    array = numbers(name, values)
    if array.ndim != 1:
        raise ArgumentTypeError(f"{name} is not allowed: it must have one dimension, not {array.ndim}")
    if not array.size:
        raise InvalidArgumentError(f"{name} is not allowed: it is empty")
    return tuple(array.tolist())


def evaluate(function: Callable[..., Any], *leading: Any, name: str, values: ArrayLike) -> FloatOrArray:
    """Calls a compiled function that maps n numbers to n numbers, for input of any shape."""
    (result,) = evaluate_all(function, *leading, name=name, values=values)
    return result


def evaluate_all(function: Callable[..., Any], *leading: Any, name: str, values: ArrayLike) -> list[FloatOrArray]:
    """The same for a function that gives several results."""
    points = numbers(name, values)
    # f2py takes no empty arrays: for them one harmless point tells how many results there are
    *results, status = function(*leading, points.ravel() if points.size else _ONE_POINT)
    if not points.size:
        return [np.empty(points.shape) for _ in results]
    check(status)
    return [result.reshape(points.shape) if points.shape else float(result[0]) for result in results]


class Handle:
    """Owner of one object of the library: frees it when the last Python reference is gone, in any thread, once."""

    __slots__ = ("address", "__weakref__")

    def __init__(self, created: tuple[int, int], free: Callable[[int], Any]) -> None:
        """`created` is what a compiled constructor returns: address and status."""
        address, status = created
        check(status)
        self.address = int(address)
        weakref.finalize(self, free, self.address)
