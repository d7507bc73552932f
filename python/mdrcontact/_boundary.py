# SPDX-License-Identifier: GPL-3.0-or-later
"""The one place where Python meets the compiled library: numbers, arrays, handles and statuses are converted here."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, _native
from .errors import ArgumentTypeError, InvalidArgumentError, MDRError, error_class

FloatOrArray = float | NDArray[np.float64]
"""Result of an evaluation: a float for a number, an array of equal shape for an array."""

ComplexOrArray = complex | NDArray[np.complex128]
"""Result of a complex evaluation."""

_ONE_POINT = np.ones(1)


class Refusal(Exception):
    """Report of a failure of the library, in parts."""

    def __init__(self, status: int) -> None:
        failure = record(_layout.failure)
        native.last_failure(failure)
        self.status = status
        argument, text = (failure[0][name].decode("utf-8", "replace") for name in ("argument", "text"))
        self.entry, self.argument, self.text = int(failure[0]["entry"]), argument, text

    def error(self, *, single: bool = False) -> MDRError:
        """The exception of the user; single : the array in question is one number of the user's, which has no entries."""
        where = "" if single or not self.entry else f"entry {self.entry} of " if self.argument else f"entry {self.entry}: "
        return error_class(self.status)(f"{where}{self.argument}{self.text}")


def check(status: int, *, single: bool = False) -> None:
    """Raise the exception that belongs to `status`, with the library's message; do nothing on success.

    single : whether the array in question is one number of the user's, which has no entry 1
    """
    if status:
        raise Refusal(status).error(single=single)


def number(name: str, value: Any) -> float:
    """Return `value` as a float. The type is checked here, range and sign in the library."""
    array = np.asarray(value)
    if array.ndim or array.dtype.kind not in "iuf":
        raise ArgumentTypeError(f"{name} = {value!r}: it must be a real number")
    return float(array)


def not_zero(name: str, value: Any) -> float:
    """Return `value` as a float; 0 is the default of the library and raises."""
    if number(name, value) == 0.0:
        raise InvalidArgumentError(f"{name} = {value!r}: it must not be 0")
    return float(value)


def whole(name: str, value: Any, smallest: int, largest: int | None = None) -> int:
    """`value` as a whole number of a range."""
    is_whole = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    if not is_whole or not smallest <= value <= (value if largest is None else largest):
        allowed = f", at least {smallest}" if largest is None else f" from {smallest} to {largest}"
        words = f"{name} = {value!r}: it must be a whole number{allowed}"
        raise InvalidArgumentError(words) if is_whole else ArgumentTypeError(words)
    return int(value)


def thread_count(threads: Any) -> int:
    """Return `threads` as a whole number. The library checks its range."""
    if isinstance(threads, bool) or not isinstance(threads, int):
        raise ArgumentTypeError(f"threads = {threads!r}: it must be a whole number")
    return threads


def numbers(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """`values` as a contiguous array of float64 of unchanged shape; integers and shorter floats are widened."""
    if type(values) is float:
        return np.array(values)
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ArgumentTypeError(f"{name}: it has masked elements; fill or remove them first")
    try:
        array = np.asarray(values)
    except ValueError as problem:
        raise ArgumentTypeError(f"{name}: it must be a rectangular array of real numbers") from problem
    if array.dtype.kind not in "iuf" and array.size:
        raise ArgumentTypeError(f"{name}: it must hold real numbers, not {array.dtype}")
    # ascontiguousarray alone would turn a number into an array of one dimension
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


def together(**given: ArrayLike) -> tuple[NDArray[np.float64], ...]:
    """Arrays of the one shape to which all of them broadcast, by name."""
    arrays = {name: numbers(name, values) for name, values in given.items()}
    try:
        return tuple(np.broadcast_arrays(*arrays.values()))
    except ValueError as problem:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ArgumentTypeError(f"these shapes do not broadcast: {shapes}") from problem


def row(name: str, values: ArrayLike) -> tuple[float, ...]:
    """`values` as a tuple of floats: for tables that belong to an object. They must have one dimension and not be empty."""
    array = numbers(name, values)
    if array.ndim != 1:
        raise ArgumentTypeError(f"{name}: it must have one dimension, not {array.ndim}")
    if not array.size:
        raise InvalidArgumentError(f"{name}: it is empty")
    return tuple(array.tolist())


def outcome(function: Callable[..., Any], *arguments: Any) -> tuple[Any, ...]:
    """Status and outputs of a compiled function."""
    answer = function(*arguments)
    return answer if isinstance(answer, tuple) else (answer,)


def call(function: Callable[..., Any], *arguments: Any) -> Any:
    """Return the outputs of a compiled function without its status: nothing, its one output, or a list of them."""
    status, *results = outcome(function, *arguments)
    check(status)
    return results[0] if len(results) == 1 else results


def check_memory(memory: Any, size: int, maker: str) -> None:
    """Raise unless it is an array whose rows of `size` numbers compiled code can change; the method that makes one."""
    if not (isinstance(memory, np.ndarray) and memory.dtype == np.float64 and memory.ndim == 2
            and 0 < size == memory.shape[1] and memory.flags.c_contiguous and memory.flags.writeable):  # fmt: skip
        raise ArgumentTypeError(f"memory: it must be an array made by {maker}, or some of its rows in a row")


def evaluate(name: str, values: ArrayLike, function: Callable[[NDArray[np.float64]], Any]) -> FloatOrArray:
    """Calls a compiled function that maps n numbers to n numbers, for input of any shape."""
    (result,) = evaluate_all(name, values, function)
    return result


def evaluate_all(name: str, values: ArrayLike, function: Callable[[NDArray[np.float64]], Any]) -> list[FloatOrArray]:
    """Evaluate a function with several results, as arrays or as the columns of one."""
    points = numbers(name, values)
    # f2py takes no empty arrays: for them one harmless point shows how many results there are
    status, *results = function(points.ravel() if points.size else _ONE_POINT)
    is_table = results[0].ndim > 1
    if not points.shape:
        check(status, single=True)
        return results[0][0].tolist() if is_table else [float(result[0]) for result in results]
    if is_table:
        results = list(results[0].T)
    if not points.size:
        return [np.empty(points.shape) for _ in results]
    check(status)
    return [result.reshape(points.shape) for result in results]


def complex_values(name: str, values: ArrayLike, function: Callable[[NDArray[np.float64]], Any]) -> ComplexOrArray:
    """`evaluate` for a function that gives real and imaginary parts."""
    return complex_of(*evaluate_all(name, values, function))


def complex_of(real: FloatOrArray, imaginary: FloatOrArray) -> ComplexOrArray:
    """Return the number or array of these parts."""
    if isinstance(real, float):
        return complex(real, float(imaginary))
    both = np.empty(real.shape, np.complex128)
    both.real, both.imag = real, imaginary
    return both


def of_waves(k: ArrayLike, omega: ArrayLike, function: Callable[..., Any]) -> list[FloatOrArray]:
    """`evaluate_all` of a function of wavenumbers and angular frequencies, which broadcast: real and imaginary parts."""
    waves, frequencies = together(k=k, omega=omega)
    rates = numbers("omega", frequencies).ravel()
    return evaluate_all("k", waves, lambda q: function(q, rates if rates.size else q))


class Record(np.ndarray):
    """An array of structures of the header, which holds what its members point to."""

    _held: dict[str, list[Any]]

    def __array_finalize__(self, source: Any) -> None:
        self._held = dict(getattr(source, "_held", ()))

    def __setitem__(self, member: Any, value: Any) -> None:
        if isinstance(member, str) and _is_owner(value, self.dtype[member]):
            self._held[member] = [value]
            value = _address(value)
        super().__setitem__(member, value)


def _is_owner(value: Any, kind: np.dtype[Any]) -> bool:
    """Return whether a member of a record points to the value."""
    return (value is None or isinstance(value, (Handle, np.ndarray))) and kind == np.uintp


def record(layout: np.dtype[Any], **members: Any) -> Record:
    """A structure of the header with its size, and members that are not 0: an array of one. A member that is a pointer takes the
    handle or the array, which lives as long as the record."""
    return records(layout, [members])


def records(layout: np.dtype[Any], rows: Sequence[Mapping[str, Any]]) -> Record:
    """Array of structures of the header; one structure of zeros if there are no rows."""
    held: dict[str, list[Any]] = {}
    made = np.zeros(max(len(rows), 1), layout)
    if "size" in (layout.names or ()):
        made["size"] = layout.itemsize
    for i, row in enumerate(rows):
        one = made[i]
        for name, value in row.items():
            if _is_owner(value, layout[name]):
                held.setdefault(name, []).append(value)
                one[name] = _address(value)
            else:
                one[name] = value
    found = made.view(Record)
    found._held = held
    return found


def words_of(*codes: int) -> dict[str, int]:
    """Codes of the library by their names, which are equal in all languages and problem files."""
    return {ctypes.string_at(native.name_of(code)).decode(): code for code in codes}


class Handle:
    """Owner of one object of the library: frees it when the last Python reference is gone, in any thread, once."""

    __slots__ = ("_address", "__weakref__")

    def __init__(self, created: tuple[int, int]) -> None:
        """`created` is what a compiled constructor returns: status and address."""
        self._address = 0
        status, handle = created
        check(status)
        self._address = int(handle)

    def __del__(self, free: Any = _native.free) -> None:
        free(self._address)

    def __reduce__(self) -> Any:
        raise TypeError("a handle belongs to its object: it is neither copied nor pickled")


def _address(value: Any) -> int:
    """Return the address of a handle, a contiguous array, a function of ctypes or None, for one call whose arguments hold it."""
    if isinstance(value, Handle):
        return value._address
    if value is None:
        return 0
    if isinstance(value, np.ndarray):
        if not value.flags.c_contiguous:
            raise ValueError("an array that the library reads must be contiguous")
        return int(value.ctypes.data)
    if isinstance(value, ctypes._CFuncPtr):  # type: ignore[attr-defined]
        return ctypes.cast(value, ctypes.c_void_p).value or 0
    raise TypeError(f"{value!r} is no handle, array or function of ctypes")


def _holding(function: Callable[..., Any], places: tuple[int, ...]) -> Callable[..., Any]:
    """A compiled function whose arguments at some places are pointers. It takes their owners, which its frame holds until the
    function returns: Python keeps no address of what it might free."""

    def held(*arguments: Any) -> Any:
        given = list(arguments)
        for place in places:
            value = given[place]
            if type(value) is Handle:
                given[place] = value._address
            elif value is None:
                given[place] = 0
            else:
                given[place] = [_address(one) for one in value] if isinstance(value, list) else _address(value)
        return function(*given)

    return held


def _library() -> Any:
    """The functions of the compiled library."""
    functions = {name: function for name, function in vars(_native).items() if not name.startswith("_")}
    held = {name: _holding(functions[name], places) for name, places in _layout.POINTERS.items()}
    return SimpleNamespace(**functions | held)


if TYPE_CHECKING:
    native = _native
else:
    native = _library()


def one_path(time: ArrayLike, **given: ArrayLike | None) -> tuple[str, NDArray[np.float64], NDArray[np.float64]]:
    """Return the name of the one prescribed quantity, the times and the values; one dimension, same length."""
    names = [name for name, values in given.items() if values is not None]
    if len(names) != 1:
        choice = ", ".join(list(given)[:-1]) + f" and {list(given)[-1]}"
        raise ArgumentTypeError(f"a history needs one of {choice}, not {' and '.join(names) or 'none'}")
    t, values = numbers("time", time), numbers(names[0], given[names[0]])  # type: ignore[arg-type]
    if t.ndim != 1 or t.shape != values.shape:
        raise InvalidArgumentError(
            f"time and {names[0]} must have one dimension and the same length, not {t.shape} and {values.shape}"
        )
    return names[0], t, values
