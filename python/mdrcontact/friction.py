# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact under Coulomb's law of friction: partial slip, tractions and fretting loops (theory/friction.md (3.1)-(3.7))."""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _layout
from ._boundary import Handle, call, native, number, together, whole
from ._value import Value
from .contact import Contact
from .errors import ArgumentTypeError, InvalidArgumentError
from .sheared import ShearedContact, ShearState
from .state import State, state_of


@dataclass(frozen=True)
class Friction(Value):
    """A contact under Coulomb's law: slip where the traction reaches coefficient times pressure, stick where it is less.

    contact : a `Contact` without adhesion on a homogeneous, exact coated, layered or graded medium, or on one with Gao's weights
        ("gao", "gao-series", "gao-power"), or on a pair of such
    coefficient : of friction, > 0 [1]

    The normal force is constant and the shear does not change the pressure, as with Cattaneo and Mindlin (T would be 1 to 6 %
    higher); the displacement that varies as cos 2 phi around the axis is left out (at most 0.25 % of T). Else homogeneous and exact
    media are exact; Gao's weights superpose punches.

    A pressure that would be negative somewhere, and slip that would begin inside the contact at once (a flat punch on a stiff
    coating), raise DomainError; slip that would begin inside later, a SlipInsideWarning.
    """

    contact: Contact
    coefficient: float
    _looked_at: set[tuple[int, ...]] = field(init=False, repr=False, compare=False)

    def __init__(self, contact: Contact, coefficient: float) -> None:
        if not isinstance(contact, Contact):
            raise ArgumentTypeError(f"contact = {contact!r} is not allowed: it must be a Contact")
        mu = number("coefficient", coefficient)
        created = native.friction_new(contact._handle, mu)
        self._set(_handle=Handle(created), contact=contact, coefficient=mu, _looked_at=set())

    def shear(self, state: State) -> ShearedContact:
        """What happens to states of the contact as the indenter is displaced along the surface."""
        return ShearedContact(self, state)

    def twist(self, state: State) -> ShearedContact:
        """The same as it is twisted about the axis, on homogeneous media."""
        return ShearedContact(self, state, around=True)

    def history(self, largest_depth: float | None = None, rings: int | None = None) -> FrictionHistory:
        """A contact that has not been loaded yet, to be led along any path.

        largest_depth : up to which it can be led, > 0; needed on exact layered bodies, whose contact is cut into rings [length]. On
            homogeneous ones None: every step is exact
        rings : 10 to 1000; None: 100
        """
        return FrictionHistory(self, largest_depth, rings)


class FrictionHistory:
    """A contact with friction and its past, along any path of normal and tangential loading: `friction.history()`.

    Springs of homogeneous bodies do not interact, so that every step in which depth and shift change in proportion is exact,
    whatever its size. Elsewhere rings of the surface each obey Coulomb's law: with 100 of them T is good to 2e-4 coefficient F,
    the stick radius to a third of a ring, the energy to 2e-3. A second history with twice the rings shows the error, which
    becomes half of it or less. A step is divided where the edge of the contact comes to a ring's: a long step gives what many
    short ones give, and costs as much. It changes as it advances: not for several threads at a time. Each `copy()` goes its own
    way. Pickled are its steps, 32 bytes each, which are led again where it is unpickled.
    """

    def __init__(self, friction: Friction, largest_depth: float | None = None, rings: int | None = None) -> None:
        if not isinstance(friction, Friction):
            raise ArgumentTypeError(f"friction = {friction!r} is not allowed: it must be a Friction")
        deepest = 0.0 if largest_depth is None else number("largest_depth", largest_depth)
        count = 0 if rings is None else whole("rings", rings, 1)
        if deepest == 0.0 and (largest_depth is not None or count):
            raise InvalidArgumentError(f"largest_depth = {largest_depth!r} is not allowed: rings need a largest_depth > 0")
        self._own(native.friction_history_new(friction._handle, deepest, count))
        self._given = friction, largest_depth, rings
        self._steps = array("d")
        self.friction = friction
        self.state = state_of([0.0] * 6, friction.contact)
        """the normal state reached"""
        self.shear = ShearState(0.0, 0.0, 0.0, 0.0, 0.0, False)
        """the tangential state reached"""

    def _own(self, created: tuple[int, int]) -> None:
        self._handle = Handle(created)

    def advance(
        self,
        *,
        depth: ArrayLike | None = None,
        force: ArrayLike | None = None,
        shift: ArrayLike | None = None,
        tangential_force: ArrayLike | None = None,
    ) -> ShearState:
        """Goes on to a depth [length] or normal force [modulus length^2], >= 0, and a shift [length] or tangential force
        [modulus length^2], |T| < coefficient F; arrays of one dimension, which broadcast, are steps one after the other.

        Returns the states at the ends of the steps: `stick_radius` is where the last step did not slip, `dissipated_energy` that
        since the beginning. After an error the history is as it was.
        """
        if (depth is None) == (force is None) or (shift is None) == (tangential_force is None):
            raise ArgumentTypeError("a step needs one of depth and force, and one of shift and tangential_force")
        given, normal = (_layout.FORCE, ("force", force)) if depth is None else (_layout.DEPTH, ("depth", depth))
        along_given, along = _layout.SHIFT, ("shift", shift)
        if shift is None:
            along_given, along = _layout.TANGENTIAL_FORCE, ("tangential_force", tangential_force)
        steps, along_steps = together(**{name: values for name, values in (normal, along) if values is not None})
        if steps.ndim > 1:
            raise ArgumentTypeError("steps are numbers or arrays of one dimension")
        if not steps.size:
            return ShearState._make([np.empty(0)] * 5 + [np.empty(0, bool)])
        handle = self._handle
        states, shears = call(native.friction_history_advance, handle, given, along_given, steps.ravel(), along_steps.ravel())
        if steps.ndim:
            kinds = np.full(steps.size, given), np.full(steps.size, along_given)
            self._steps.frombytes(np.column_stack([*kinds, steps, along_steps]).tobytes())
        else:
            self._steps.extend((given, along_given, float(steps), float(along_steps)))
        self.state = state_of(states[-1].tolist(), self.friction.contact)
        self.shear = ShearState._make([*(float(value) for value in shears[-1][:5]), bool(shears[-1][5] > 0.5)])
        if not steps.ndim:
            return self.shear
        return ShearState._make([*shears.T[:5], shears.T[5] > 0.5])

    def copy(self) -> FrictionHistory:
        """The same past, which goes its own way from here."""
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__, _steps=self._steps[:])
        other._own(native.friction_history_copy(self._handle))
        return other

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> FrictionHistory:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return _led_again, (self._given, self._steps)

    def __repr__(self) -> str:
        return f"<FrictionHistory of {self.friction!r} at depth {self.state.depth:g}, shift {self.shear.shift:g}>"


def _led_again(given: tuple[Any, ...], steps: array[float]) -> FrictionHistory:
    """A history from the steps that it was led."""
    history, rows = FrictionHistory(*given), np.array(steps).reshape(-1, 4)
    turns = np.flatnonzero(np.any(np.diff(rows[:, :2], axis=0) != 0.0, axis=1)) + 1
    for part in np.split(rows, turns):
        if not len(part):
            continue
        normal = "force" if part[0, 0] == _layout.FORCE else "depth"
        along = "shift" if part[0, 1] == _layout.SHIFT else "tangential_force"
        history.advance(**{normal: part[:, 2], along: part[:, 3]})
    return history
