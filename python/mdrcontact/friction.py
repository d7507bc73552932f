# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact under Coulomb's law of friction: partial slip, tractions and fretting loops at constant normal force (theory 10)."""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, _native
from ._boundary import FloatOrArray, Handle, call, number, together, whole
from ._partial_slip import Given, Normal, PartialSlip, draw_loop, normal_rows
from ._value import Value
from ._warn import warn
from .contact import Contact
from .errors import ArgumentTypeError, InvalidArgumentError, MDRError, SlipInsideWarning
from .medium import Homogeneous
from .state import State, state_of
from .torsion import Torsion

__all__ = ["Friction", "FrictionHistory", "FrictionLoop", "TangentialState"]

_INSIDE = np.array([0.01, 0.3, 0.6, 0.9])
"""Radii, in stick radii, at which traction and pressure are compared."""
_NOTICEABLE = 1e-3
"""Traction beyond coefficient times pressure by this part of the mean is more than the solver's error."""
_NEARLY = 0.98
"""Part of the sliding shift, at which a contact that slides is looked at."""


class TangentialState(NamedTuple):
    """Tangential states; each entry has the shape of the input, or is a number."""

    shift: FloatOrArray
    """s, displacement of the indenter along the surface [length]"""
    tangential_force: FloatOrArray
    """T, |T| <= coefficient F, of the sign of s [modulus length^2]"""
    stick_radius: FloatOrArray
    """c, radius of the disc of stick, 0 where the contact slides [length]"""
    stiffness: FloatOrArray
    """dT/ds = k_t(c), that of a contact of radius c that sticks all over [modulus length]"""
    dissipated_energy: FloatOrArray
    """energy dissipated since s = 0 [modulus length^3]"""
    sliding: bool | NDArray[np.bool_]
    """whether the whole contact slides"""

    def one(self, index: Any) -> TangentialState:
        """One of several states, as the fields take it: `states.one(3)`."""
        values = [float(np.asarray(value)[index]) for value in self[:5]]
        return TangentialState._make([*values, bool(np.asarray(self.sliding)[index])])


class FrictionLoop(NamedTuple):
    """A cycle between +amplitude and -amplitude at constant normal force."""

    shift: NDArray[np.float64]
    """s, from +amplitude to -amplitude and back in equal steps [length]"""
    tangential_force: NDArray[np.float64]
    """T [modulus length^2]"""
    dissipated_energy: float
    """energy dissipated in the cycle, the area of the loop [modulus length^3]"""
    turn: TangentialState
    """the state at +amplitude when it is reached for the first time; slip is outside its stick radius"""

    def plot(self, axes: Any = None, **look: Any) -> Any:
        """Draws T against s with matplotlib on `axes` (None makes a new figure); `look` is passed on. Returns the axes."""
        return draw_loop(self.shift, self.tangential_force, ("shift s", "tangential force T"), axes, look)


_SLIP = PartialSlip[TangentialState](
    "tangential",
    TangentialState,
    {"shift": _layout.GIVEN_SHIFT, "tangential_force": _layout.GIVEN_TANGENTIAL_FORCE},
    {"shift": "shift", "force": "tangential_force"},
    (_native.friction_states, _native.friction_sliding, _native.friction_loop, _native.friction_field),
)


@dataclass(frozen=True)
class Friction(Value):
    """A contact under Coulomb's law: slip where the traction reaches coefficient times pressure, stick where it is less.

    contact : a `Contact` without adhesion on a homogeneous, exact coated, layered or graded medium, or on one with Gao's weights
        ("gao", "gao-series", "gao-power"), or on a pair of such
    coefficient : of friction, > 0 [1]

    The normal force is constant and the shear does not change the pressure, as with Cattaneo and Mindlin (T would be 1 to 6 %
    higher); the displacement that varies as cos 2 phi around the axis is left out (at most 0.25 % of T). Else homogeneous and exact
    media are exact; Gao's weights superpose punches.

    The normal state that is sheared is a `State` of the contact, or the one with this force, depth or radius; arrays broadcast with
    the other arguments. A pressure that would be negative somewhere, and slip that would begin inside the contact at once (a flat
    punch on a stiff coating), raise DomainError; slip that would begin inside later, a SlipInsideWarning.
    """

    contact: Contact
    coefficient: float
    _looked_at: set[tuple[int, ...]] = field(init=False, repr=False, compare=False)

    def __init__(self, contact: Contact, coefficient: float) -> None:
        if not isinstance(contact, Contact):
            raise ArgumentTypeError(f"contact = {contact!r} is not allowed: it must be a Contact")
        mu = number("coefficient", coefficient)
        created = _native.friction_new(contact._handle.address, mu)
        self._set(_handle=Handle(created, _native.friction_free), contact=contact, coefficient=mu, _looked_at=set())

    def at_shift(
        self, shift: ArrayLike, state: State | None = None, *, force: Given = None, depth: Given = None, radius: Given = None
    ) -> TangentialState:
        """The states after a displacement s of the indenter along the surface [length], of either sign, any shape."""
        normal = state, force, depth, radius
        return self._looked(_SLIP.states(self, "shift", shift, normal), normal)

    def at_tangential_force(
        self,
        tangential_force: ArrayLike,
        state: State | None = None,
        *,
        force: ArrayLike | None = None,
        depth: ArrayLike | None = None,
        radius: ArrayLike | None = None,
    ) -> TangentialState:
        """The states under a tangential force T [modulus length^2], |T| <= coefficient F, any shape; at the bound the state in
        which sliding begins."""
        normal = state, force, depth, radius
        return self._looked(_SLIP.states(self, "tangential_force", tangential_force, normal), normal)

    def sliding_shift(
        self, state: State | None = None, *, force: Given = None, depth: Given = None, radius: Given = None
    ) -> FloatOrArray:
        """The shift at which the last point begins to slip and the contact slides [length]; T is then coefficient times F."""
        return _SLIP.sliding(self, (state, force, depth, radius))

    def loop(
        self,
        amplitude: float,
        control: str = "shift",
        points: int = 201,
        state: State | None = None,
        *,
        force: float | None = None,
        depth: float | None = None,
        radius: float | None = None,
    ) -> FrictionLoop:
        """The loop of a cycle between +amplitude and -amplitude (Masing's rule, which is exact here).

        amplitude : > 0, of the "shift" [length] or the tangential "force" [modulus length^2] as `control` says
        points : at least 3; from +amplitude to -amplitude and back
        """
        normal = state, force, depth, radius
        loop = FrictionLoop(*_SLIP.loop(self, control, amplitude, points, normal))
        self._looked(loop.turn, normal)
        return loop

    def cycle_energy(
        self,
        amplitude: ArrayLike,
        control: str = "shift",
        state: State | None = None,
        *,
        force: ArrayLike | None = None,
        depth: ArrayLike | None = None,
        radius: ArrayLike | None = None,
    ) -> FloatOrArray:
        """Energy dissipated in a cycle between +amplitude and -amplitude, any shape [modulus length^3], without loss of digits at
        small amplitudes. Arguments as of `loop`."""
        normal = state, force, depth, radius
        turns = _SLIP.states(self, _SLIP.named(control), amplitude, normal)
        return 4.0 * self._looked(turns, normal).dissipated_energy

    def traction(
        self,
        r: ArrayLike,
        shear: TangentialState,
        state: State | None = None,
        *,
        force: float | None = None,
        depth: float | None = None,
        radius: float | None = None,
    ) -> FloatOrArray:
        """Shear traction tau(r) [modulus] along the shift, of one direction, at 0 <= r <= a, any shape.

        shear : one tangential state of this normal state, as `at_shift` gives
        """
        return _SLIP.field(self, _layout.FIELD_TRACTION, ("r", r), ("shear", shear), (state, force, depth, radius))

    def line_load(
        self,
        x: ArrayLike,
        shear: TangentialState,
        state: State | None = None,
        *,
        force: float | None = None,
        depth: float | None = None,
        radius: float | None = None,
    ) -> FloatOrArray:
        """Line load q_t(x) [modulus length] of the springs along the shift, 0 <= x <= a, any shape; arguments as of `traction`."""
        return _SLIP.field(self, _layout.FIELD_TANGENTIAL_LINE_LOAD, ("x", x), ("shear", shear), (state, force, depth, radius))

    def history(self, largest_depth: float | None = None, rings: int | None = None) -> FrictionHistory:
        """A contact that has not been loaded yet, to be led along any path.

        largest_depth : up to which it can be led, > 0; needed on exact layered bodies, whose contact is cut into rings [length]. On
            homogeneous ones None: every step is exact
        rings : 10 to 1000; None: 100
        """
        return FrictionHistory(self, largest_depth, rings)

    @property
    def torsion(self) -> Torsion:
        """The contact twisted about its axis: `.at_twist`, `.at_torque`, `.sliding_torque`, `.loop`, `.traction`, `.line_load`.
        On homogeneous media."""
        return Torsion(self)

    def _looked(self, found: TangentialState, normal: Normal) -> TangentialState:
        """`found`, with a warning where the stuck disc would need more than coefficient times pressure: looks at the state with the
        smallest one, once for states of about the same size."""
        if isinstance(self.contact.medium, Homogeneous) or not np.size(found.shift):
            return found
        place = np.unravel_index(np.argmin(found.stick_radius), np.shape(found.stick_radius))
        shear = found.one(place)
        size = tuple(round(2.0 * math.log2(abs(float(value)))) for value in shear[:3] if value != 0.0)
        if size and size not in self._looked_at:
            self._looked_at.add(size)
            rows = normal_rows(self.contact, normal)
            row = np.broadcast_to(rows, (*np.shape(found.shift), rows.shape[-1]))[place]
            fault = self._fault(shear, state_of(row.tolist(), self.contact))
            if fault:
                warn(
                    f"slip would begin inside this contact: {fault}. Partial slip as an annulus at the edge is not that of the "
                    "true contact; that by rings, friction.history(largest_depth), is",
                    SlipInsideWarning,
                )
        return found

    def _fault(self, shear: TangentialState, state: State) -> str:
        """Where the stuck disc of a state has more traction than coefficient times pressure; empty if nowhere, or if either is
        refused."""
        normal = state, None, None, None
        try:
            if shear.sliding:
                shear = _SLIP.states(self, "shift", _NEARLY * _SLIP.sliding(self, normal), normal)
            r = float(shear.stick_radius) * _INSIDE
            traction = np.abs(self.traction(r, shear, state))
            limit = self.coefficient * np.asarray(state.pressure(r))
        except MDRError:
            return ""
        worst = int(np.argmax(traction - limit))
        area = math.pi * float(state.radius) ** 2
        if (traction[worst] - limit[worst]) * area <= _NOTICEABLE * self.coefficient * float(state.force):
            return ""
        return (
            f"at r = {r[worst]:.3g} the traction would be {traction[worst]:.3g}, more than coefficient times pressure, "
            f"{limit[worst]:.3g} (stick radius {shear.stick_radius:.3g}, contact radius {state.radius:.3g})"
        )


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
        self._own(_native.friction_history_new(friction._handle.address, deepest, count))
        self._given = friction, largest_depth, rings
        self._steps = array("d")
        self.friction = friction
        self.state = state_of([0.0] * 6, friction.contact)
        """the normal state reached"""
        self.shear = TangentialState(0.0, 0.0, 0.0, 0.0, 0.0, False)
        """the tangential state reached"""

    def _own(self, created: tuple[int, int]) -> None:
        self._handle = Handle(created, _native.friction_history_free)

    def advance(
        self,
        *,
        depth: ArrayLike | None = None,
        force: ArrayLike | None = None,
        shift: ArrayLike | None = None,
        tangential_force: ArrayLike | None = None,
    ) -> TangentialState:
        """Goes on to a depth [length] or normal force [modulus length^2], >= 0, and a shift [length] or tangential force
        [modulus length^2], |T| < coefficient F; arrays of one dimension, which broadcast, are steps one after the other.

        Returns the states at the ends of the steps: `stick_radius` is where the last step did not slip, `dissipated_energy` that
        since the beginning. After an error the history is as it was.
        """
        if (depth is None) == (force is None) or (shift is None) == (tangential_force is None):
            raise ArgumentTypeError("a step needs one of depth and force, and one of shift and tangential_force")
        given, normal = (_layout.GIVEN_FORCE, ("force", force)) if depth is None else (_layout.GIVEN_DEPTH, ("depth", depth))
        along_given, along = _layout.GIVEN_SHIFT, ("shift", shift)
        if shift is None:
            along_given, along = _layout.GIVEN_TANGENTIAL_FORCE, ("tangential_force", tangential_force)
        steps, along_steps = together(**{name: values for name, values in (normal, along) if values is not None})
        if steps.ndim > 1:
            raise ArgumentTypeError("steps are numbers or arrays of one dimension")
        if not steps.size:
            return TangentialState._make([np.empty(0)] * 5 + [np.empty(0, bool)])
        handle = self._handle.address
        states, shears = call(_native.friction_history_advance, handle, given, along_given, steps.ravel(), along_steps.ravel())
        if steps.ndim:
            kinds = np.full(steps.size, given), np.full(steps.size, along_given)
            self._steps.frombytes(np.column_stack([*kinds, steps, along_steps]).tobytes())
        else:
            self._steps.extend((given, along_given, float(steps), float(along_steps)))
        self.state = state_of(states[-1].tolist(), self.friction.contact)
        self.shear = TangentialState._make([*(float(value) for value in shears[-1][:5]), bool(shears[-1][5] > 0.5)])
        if not steps.ndim:
            return self.shear
        return TangentialState._make([*shears.T[:5], shears.T[5] > 0.5])

    def copy(self) -> FrictionHistory:
        """The same past, which goes its own way from here."""
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__, _steps=self._steps[:])
        other._own(_native.friction_history_copy(self._handle.address))
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
        normal = "force" if part[0, 0] == _layout.GIVEN_FORCE else "depth"
        along = "shift" if part[0, 1] == _layout.GIVEN_SHIFT else "tangential_force"
        history.advance(**{normal: part[:, 2], along: part[:, 3]})
    return history
