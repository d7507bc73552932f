# SPDX-License-Identifier: GPL-3.0-or-later
"""What partial slip under a shift and under a twist have in common: the normal state, and arrays of states that start from it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._boundary import FloatOrArray, call, evaluate, evaluate_all, number, numbers, whole
from .contact import Contact, State
from .errors import ArgumentTypeError

MOST_POINTS = 1_000_000
FLAG = 5
"""Where the states say whether all slides."""


def normal_rows(
    contact: Contact, state: State | None, force: ArrayLike | None, depth: ArrayLike | None, radius: ArrayLike | None
) -> NDArray[np.float64]:
    """The normal states that are meant, one row each."""
    if sum(value is not None for value in (state, force, depth, radius)) != 1:
        raise ArgumentTypeError("a contact with friction needs one of state, force, depth and radius, and not more")
    if force is not None:
        state = contact.at_force(force)
    elif depth is not None:
        state = contact.at_depth(depth)
    elif radius is not None:
        state = contact.at_radius(radius)
    if not isinstance(state, State):
        raise ArgumentTypeError(f"state = {state!r} is not allowed: it must be a State; a force is given as force=...")
    named = zip(state._fields, state, strict=True)
    return np.stack(np.broadcast_arrays(*(numbers(f"{member} of the state", value) for member, value in named)), axis=-1)


def one_row(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    if rows.ndim != 1:
        raise ArgumentTypeError("fields and loops are those of one normal state, not of several")
    return rows


def states(
    function: Callable[..., Any], handle: int, given: int, name: str, values: ArrayLike, rows: NDArray[np.float64]
) -> list[Any]:
    """The members of the states at `values`, which broadcast with the normal states."""
    if rows.ndim == 1:
        found = evaluate_all(name, values, lambda v: function(handle, rows, given, v))
    else:
        points = numbers(name, values)
        try:
            shape = np.broadcast_shapes(points.shape, rows.shape[:-1])
        except ValueError as problem:
            raise ArgumentTypeError(f"{name} and the normal state have shapes that do not broadcast: {problem}") from problem
        points, normal = np.broadcast_to(points, shape), np.broadcast_to(rows, (*shape, rows.shape[-1]))
        table = np.empty((*shape, FLAG + 1))
        for place in np.ndindex(shape):
            table[place] = call(function, handle, normal[place], given, points[place])
        found = list(np.moveaxis(table, -1, 0))
    flags = np.asarray(found[FLAG]) > 0.5
    return [*found[:FLAG], flags if flags.shape else bool(flags)]


def for_each(function: Callable[[NDArray[np.float64]], float], rows: NDArray[np.float64]) -> FloatOrArray:
    """One number of each normal state."""
    found = np.empty(rows.shape[:-1])
    for place in np.ndindex(found.shape):
        found[place] = function(rows[place])
    return found if found.shape else float(found)


def field(
    function: Callable[..., Any],
    handle: int,
    code: int,
    name: str,
    r: ArrayLike,
    kind: str,
    sheared: Any,
    rows: NDArray[np.float64],
) -> FloatOrArray:
    """A field of one state; kind : what the state is, in words."""
    row = one_row(rows)
    named = zip(sheared._fields[:FLAG], sheared[:FLAG], strict=True)
    members = [*(number(f"{member} of the {kind} state", value) for member, value in named), float(sheared.sliding)]
    return evaluate(name, r, lambda x: function(handle, row, members, code, x))


def point_count(points: Any) -> int:
    """Of a loop."""
    return whole("points", points, 3, MOST_POINTS)


def draw_loop(x: NDArray[np.float64], y: NDArray[np.float64], labels: tuple[str, str], axes: Any, look: dict[str, Any]) -> Any:
    """One curve with matplotlib on `axes` (None makes a new figure)."""
    if axes is None:
        import matplotlib.pyplot as plt

        axes = plt.figure(layout="constrained").add_subplot()
        axes.set_xlabel(labels[0])
        axes.set_ylabel(labels[1])
    axes.plot(x, y, **look)
    return axes
