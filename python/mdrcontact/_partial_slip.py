# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip, what shift and twist have in common: states, loops and fields that start from a normal state."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._boundary import FloatOrArray, Handle, call, evaluate, evaluate_all, number, numbers, whole
from .adhesion import code
from .contact import Contact, State
from .errors import ArgumentTypeError

S = TypeVar("S")
Given = ArrayLike | None
"""A force, depth or radius, whichever says the normal state; the others are None."""
Normal = tuple[State | None, Given, Given, Given]
"""The state, force, depth and radius, one of which is given."""

MOST_POINTS = 1_000_000
_FLAG = 5
"""Where the states say whether all slides."""


class Rubbing(Protocol):
    """A contact with friction."""

    @property
    def contact(self) -> Contact: ...

    @property
    def _handle(self) -> Handle: ...


@dataclass(frozen=True)
class PartialSlip(Generic[S]):
    """One way to move a contact with friction under constant normal force."""

    kind: str
    """of the states, in words"""
    made: Any
    """the class of its states"""
    given: Mapping[str, int]
    """what can be prescribed, and the library's code for it"""
    controls: dict[str, str]
    """the same by the words of `control`"""
    native: tuple[Callable[..., Any], Callable[..., Any], Callable[..., Any], Callable[..., Any]]
    """for states, sliding, loop and field"""

    def states(self, rubbing: Rubbing, name: str, values: ArrayLike, normal: Normal) -> S:
        """The states at `values`, which broadcast with the normal states."""
        return self._states(rubbing, name, values, normal_rows(rubbing.contact, normal))

    def sliding(self, rubbing: Rubbing, normal: Normal) -> FloatOrArray:
        """Where sliding begins, one number of each normal state."""
        rows = normal_rows(rubbing.contact, normal)
        found = np.empty(rows.shape[:-1])
        for place in np.ndindex(found.shape):
            found[place] = np.ravel(call(self.native[1], rubbing._handle.address, rows[place]))[0]
        return found if found.shape else float(found)

    def named(self, control: str) -> str:
        """What a control prescribes."""
        code("control", control, dict.fromkeys(self.controls, 0))
        return self.controls[control]

    def loop(
        self, rubbing: Rubbing, control: str, amplitude: float, points: int, normal: Normal
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], float, S]:
        """Both quantities along the loop, the energy, and the state at +amplitude."""
        name = self.named(control)
        size, count = number("amplitude", amplitude), whole("points", points, 3, MOST_POINTS)
        row = _one(normal_rows(rubbing.contact, normal))
        along, load, energy = call(self.native[2], rubbing._handle.address, row, self.given[name], size, count)
        return along, load, float(energy), self._states(rubbing, name, size, row)

    def field(
        self, rubbing: Rubbing, field: int, r: tuple[str, ArrayLike], slipped: tuple[str, Any], normal: Normal
    ) -> FloatOrArray:
        """A field of one state; `r` and `slipped`, the place and the state, come with their names."""
        row = _one(normal_rows(rubbing.contact, normal))
        name, state = slipped
        if not isinstance(state, self.made):
            raise ArgumentTypeError(f"{name} = {state!r} is not allowed: it must be a {self.made.__name__}")
        named = zip(self.made._fields[:_FLAG], state[:_FLAG], strict=True)
        members = [*(number(f"{member} of the {self.kind} state", value) for member, value in named), float(state.sliding)]
        return evaluate(*r, lambda x: self.native[3](rubbing._handle.address, row, members, field, x))

    def _states(self, rubbing: Rubbing, name: str, values: ArrayLike, rows: NDArray[np.float64]) -> S:
        handle, given, native = rubbing._handle.address, self.given[name], self.native[0]
        if rows.ndim == 1:
            found = evaluate_all(name, values, lambda v: native(handle, rows, given, v))
        else:
            points = numbers(name, values)
            try:
                shape = np.broadcast_shapes(points.shape, rows.shape[:-1])
            except ValueError as problem:
                raise ArgumentTypeError(f"{name} and the normal state have shapes that do not broadcast: {problem}") from problem
            points, normal = np.broadcast_to(points, shape), np.broadcast_to(rows, (*shape, rows.shape[-1]))
            table = np.empty((*shape, _FLAG + 1))
            for place in np.ndindex(shape):
                table[place] = call(native, handle, normal[place], given, points[place])
            found = list(np.moveaxis(table, -1, 0))
        flags = np.asarray(found[_FLAG]) > 0.5
        slipped: S = self.made(*found[:_FLAG], flags if flags.shape else bool(flags))
        return slipped


def normal_rows(contact: Contact, normal: Normal) -> NDArray[np.float64]:
    """The normal states that are meant, one row each."""
    state, force, depth, radius = normal
    if sum(value is not None for value in normal) != 1:
        raise ArgumentTypeError("a contact with friction needs one of state, force, depth and radius, and not more")
    if force is not None:
        state = contact.at_force(force)
    elif depth is not None:
        state = contact.at_depth(depth)
    elif radius is not None:
        state = contact.at_radius(radius)
    if not isinstance(state, State):
        raise ArgumentTypeError(f"state = {state!r} is not allowed: it must be a State; a force is given as force=...")
    return state._rows()


def _one(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    if rows.ndim != 1:
        raise ArgumentTypeError("fields and loops are those of one normal state, not of several")
    return rows


def draw_loop(x: NDArray[np.float64], y: NDArray[np.float64], labels: tuple[str, str], axes: Any, look: dict[str, Any]) -> Any:
    """One curve with matplotlib on `axes` (None makes a new figure)."""
    if axes is None:
        import matplotlib.pyplot as plt

        axes = plt.figure(layout="constrained").add_subplot()
        axes.set_xlabel(labels[0])
        axes.set_ylabel(labels[1])
    axes.plot(x, y, **look)
    return axes
