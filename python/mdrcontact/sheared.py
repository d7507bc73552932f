# SPDX-License-Identifier: GPL-3.0-or-later
"""States of a contact with friction that are sheared or twisted under constant normal force (theory/friction.md (3.5))."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import FloatOrArray, Handle, call, evaluate, evaluate_all, native, number, numbers, record, whole
from ._choices import code
from ._warn import Caution, is_collected, is_silent, texts_of, warn_all
from .errors import ArgumentTypeError, MDRError, SlipInsideWarning
from .medium import Homogeneous
from .state import State, state_of

_INSIDE = np.array([0.01, 0.3, 0.6, 0.9])
"""Radii, in stick radii, at which traction and pressure are compared."""
_NOTICEABLE = 1e-3
"""Traction beyond coefficient times pressure by this part of the mean is more than the solver's error."""
_NEARLY = 0.98
"""Part of the sliding shift, at which a contact that slides is looked at."""
_MOST_POINTS = 1_000_000

_CONTROLS = {"shift": 0, "force": 1}
"""What is prescribed."""
_NAMES = (("shift", "tangential_force"), ("twist", "torque"))
"""The same in words, along the surface and around the axis."""
_GIVEN = ((_layout.SHIFT, _layout.TANGENTIAL_FORCE), (_layout.TWIST, _layout.TORQUE))


class _ShearNumbers(NamedTuple):
    """The numbers of a `ShearState`."""

    shift: FloatOrArray
    """s, displacement of the indenter along the surface [length]; or phi, its angle about the axis [radian]"""
    tangential_force: FloatOrArray
    """T, |T| <= coefficient F [modulus length^2]; or the torque M [modulus length^3]; of the sign of the shift"""
    stick_radius: FloatOrArray
    """c, radius of the disc of stick, 0 where the contact slides [length]"""
    stiffness: FloatOrArray
    """dT/ds = k_t(c), that of a contact of radius c that sticks all over [modulus length]; or dM/dphi [modulus length^3]"""
    dissipated_energy: FloatOrArray
    """energy dissipated since s = 0 [modulus length^3]"""
    sliding: bool | NDArray[np.bool_]
    """whether the whole contact slides; under a twist whether the disc of stick is smaller than 1e-6 a, which no torque
    distinguishes from 0"""


class ShearState(_ShearNumbers):
    """States of shear; each entry has the shape of the input, or is a number. `states[3]` and `states[mask]` are some of them."""

    _asked_of: ShearedContact | None = None
    """whose states they are, with the normal state of each; None: those of a history, or pickled ones"""
    _texts: tuple[str, ...] = ()
    """of pickled ones: the warnings of all of them"""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Whether slip would begin inside: of several states of the one with the smallest disc of stick; empty where it does not.
        By rings, in a `FrictionHistory`, it may."""
        return self._texts if self._asked_of is None else texts_of(self._asked_of._doubts(self))

    def __reduce__(self) -> tuple[Any, ...]:
        """Numbers and warnings, without the contact."""
        return _with_texts, (tuple(self), self.warnings)

    def __getitem__(self, index: Any) -> ShearState:  # type: ignore[override]
        chosen = [np.asarray(value)[index] for value in self]
        found = ShearState(*(value if value.ndim else value.item() for value in chosen))
        if self._asked_of is not None:
            found._asked_of = self._asked_of._at(np.shape(self.shift), index)
        found._texts = self._texts
        return found


def _with_texts(numbers: tuple[Any, ...], texts: tuple[str, ...]) -> ShearState:
    """States that were pickled."""
    found = ShearState(*numbers)
    found._texts = texts
    return found


class FrictionLoop(NamedTuple):
    """A cycle between +amplitude and -amplitude at constant normal force."""

    shift: NDArray[np.float64]
    """s, or phi, from +amplitude to -amplitude and back in equal steps [length, or radian]"""
    tangential_force: NDArray[np.float64]
    """T [modulus length^2], or M [modulus length^3]"""
    dissipated_energy: float
    """energy dissipated in the cycle, the area of the loop [modulus length^3]"""
    turn: ShearState
    """the state at +amplitude when it is reached for the first time; slip is outside its stick radius"""
    around: bool = False
    """whether it is twisted about the axis"""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Reasons to doubt it; empty where there are none."""
        return self.turn.warnings

    def plot(self, axes: Any = None, **look: Any) -> Any:
        """Draws T against s with matplotlib on `axes` (None makes a new figure); `look` is passed on. Returns the axes."""
        if axes is None:
            import matplotlib.pyplot as plt

            axes = plt.figure(layout="constrained").add_subplot()
            axes.set_xlabel("twist phi" if self.around else "shift s")
            axes.set_ylabel("torque M" if self.around else "tangential force T")
        axes.plot(self.shift, self.tangential_force, **look)
        return axes


@dataclass(frozen=True)
class ShearedContact:
    """What happens to states of a contact with friction as they are sheared, or twisted about the axis: `friction.shear(state)`,
    `friction.twist(state)`. Slip begins at the edge, in an annulus.

    friction : the `Friction` of a contact; for a twist on a homogeneous medium with E and nu, or on a pair of them
    state : one state of its contact, or several; they broadcast with shifts and forces, fields and loops take one
    around : whether it is twisted: shifts are then angles phi about the axis [radian], forces are torques M [modulus length^3]

    A twist is Lubkin's problem, exact: a disc around the axis sticks at any angle, ever smaller, and the torque approaches
    `sliding_force`.
    """

    friction: Any
    state: State
    around: bool = False

    def __post_init__(self) -> None:
        contact = getattr(self.friction, "contact", None)
        if contact is None:
            raise ArgumentTypeError(f"friction = {self.friction!r} is not allowed: it must be a Friction")
        if not isinstance(self.state, State):
            raise ArgumentTypeError(f"state = {self.state!r} is not allowed: it must be a State")
        if self.state.contact is None:
            object.__setattr__(self, "state", state_of(self.state, contact))
        elif self.state.contact is not contact and self.state.contact != contact:
            raise ArgumentTypeError("state is not allowed: it must be a State of the contact with friction")

    def at_shift(self, shift: ArrayLike) -> ShearState:
        """The states after a displacement s of the indenter along the surface [length], or a twist phi [radian], of either sign,
        any shape."""
        return self._looked(self._states(0, shift))

    def at_force(self, force: ArrayLike) -> ShearState:
        """The states under a tangential force T [modulus length^2], |T| <= coefficient F, any shape, at the bound the state in
        which sliding begins; or under a torque M [modulus length^3], |M| < `sliding_force`."""
        return self._looked(self._states(1, force))

    @cached_property
    def sliding_shift(self) -> FloatOrArray:
        """The shift at which the last point begins to slip and the contact slides [length]; infinite for a twist."""
        return self._sliding[0]

    @cached_property
    def sliding_force(self) -> FloatOrArray:
        """coefficient F [modulus length^2]; or the torque that a growing twist approaches, coefficient int r p dA: (3 pi/16)
        coefficient F a under a paraboloid [modulus length^3]."""
        return self._sliding[1]

    def loop(self, amplitude: float, control: str = "shift", points: int = 201) -> FrictionLoop:
        """The loop of a cycle between +amplitude and -amplitude (Masing's rule, which is exact here), of one state.

        amplitude : > 0, of the "shift" or the "force" as `control` says, see `at_shift` and `at_force`
        points : at least 3; from +amplitude to -amplitude and back
        """
        kind = code("control", control, _CONTROLS)
        self.state._row()  # one state
        size, count = number("amplitude", amplitude), whole("points", points, 3, _MOST_POINTS)
        along, load, energy = call(native.shear_loop, self._handle, _GIVEN[self.around][kind], size, count)
        turn = self._looked(self._states(kind, size))
        return FrictionLoop(along, load, float(energy), turn, self.around)

    def cycle_energy(self, amplitude: ArrayLike, control: str = "shift") -> FloatOrArray:
        """Energy dissipated in a cycle between +amplitude and -amplitude, any shape [modulus length^3], without loss of digits at
        small amplitudes. Arguments as of `loop`."""
        return 4.0 * self._looked(self._states(code("control", control, _CONTROLS), amplitude)).dissipated_energy

    def traction(self, r: ArrayLike, at: ShearState) -> FloatOrArray:
        """Shear traction tau(r) [modulus] along the shift, of one direction, or around the axis, at 0 <= r <= a, any shape.

        at : one state of shear, as `at_shift` gives
        """
        return self._field(_layout.TRACTION, "r", r, at)

    def line_load(self, x: ArrayLike, at: ShearState) -> FloatOrArray:
        """Line load q_t(x) [modulus length] of the springs along the shift, 0 <= x <= a, any shape; of a twist
        2 x int_x^a tau dr/sqrt(r^2 - x^2), whose torque is 4 int_0^a x q dx. Arguments as of `traction`."""
        return self._field(_layout.TANGENTIAL_LINE_LOAD, "x", x, at)

    @cached_property
    def _handle(self) -> Handle:
        """Of its one state: slip is solved once."""
        self.state._row()  # one state
        return self._sheared(self.state._load)

    def _sheared(self, load: Handle) -> Handle:
        return Handle(native.shear_new(self.friction._handle, load, _layout.AROUND if self.around else _layout.ALONG))

    def __reduce__(self) -> Any:
        return type(self), (self.friction, self.state, self.around)

    @cached_property
    def _sliding(self) -> tuple[FloatOrArray, FloatOrArray]:
        """Shift and force of sliding of each state."""
        rows = self.state._rows()
        found = np.empty((*rows.shape[:-1], 2))
        for place in np.ndindex(rows.shape[:-1]):
            facts, sheared = record(_layout.shear_facts), self._sheared(self.state._load_of(rows[place])) if place else self._handle
            call(native.shear_about, sheared, facts)
            found[place] = facts[0]["sliding_shift"], facts[0]["sliding_force"]
        return (found[..., 0], found[..., 1]) if rows.ndim > 1 else (float(found[0]), float(found[1]))

    def _states(self, kind: int, values: ArrayLike) -> ShearState:
        name, given, rows = _NAMES[self.around][kind], _GIVEN[self.around][kind], self.state._rows()
        if rows.ndim == 1:
            found = evaluate_all(name, values, lambda v: native.shear_states(self._handle, given, v))
        else:
            points = numbers(name, values)
            try:
                shape = np.broadcast_shapes(points.shape, rows.shape[:-1])
            except ValueError as problem:
                raise ArgumentTypeError(f"{name} and the normal states have shapes that do not broadcast: {problem}") from problem
            points, normal = np.broadcast_to(points, shape), np.broadcast_to(rows, (*shape, rows.shape[-1]))
            table = np.empty((*shape, len(ShearState._fields)))
            for place in np.ndindex(shape):
                sheared = self._sheared(self.state._load_of(normal[place]))
                table[place] = call(native.shear_states, sheared, given, points[place])
            found = list(np.moveaxis(table, -1, 0))
        flags = np.asarray(found[-1]) > 0.5
        return ShearState._make([*found[:-1], flags if flags.shape else bool(flags)])

    def _field(self, field: int, name: str, points: ArrayLike, at: ShearState) -> FloatOrArray:
        self.state._row()  # one state
        if not isinstance(at, ShearState):
            raise ArgumentTypeError(f"at = {at!r} is not allowed: it must be a ShearState")
        members = [number(f"{member} of the state of shear", value) for member, value in list(at._asdict().items())[:-1]]
        members.append(float(at.sliding))
        return evaluate(name, points, lambda x: native.shear_field(self._handle, members, field, x))

    def _looked(self, found: ShearState) -> ShearState:
        """`found`, with a warning where the stuck disc would need more than coefficient times pressure: of states of about the same
        size the user reads it once."""
        found._asked_of = self
        sizes, shear = self.friction._looked_at, self._doubtful(found)
        if shear is None or is_silent():
            return found
        size = tuple(round(2.0 * math.log2(abs(float(value)))) for value in tuple(shear[0])[:3] if value != 0.0)
        if is_collected() or (size and size not in sizes):
            if not is_collected():
                sizes.add(size)
            warn_all(self._doubts(found))
        return found

    def _doubtful(self, found: ShearState) -> tuple[ShearState, State] | None:
        """The state with the smallest stuck disc, and its normal state; None where there is no doubt."""
        contact = self.friction.contact
        if self.around or isinstance(contact.medium, Homogeneous) or not np.size(found.shift):
            return None
        shape = np.shape(found.shift)
        if not shape:
            return found, self.state
        place = np.unravel_index(np.argmin(found.stick_radius), shape)
        smallest: ShearState = found[place]  # type: ignore[assignment]
        return smallest, self._at(shape, place).state

    def _doubts(self, found: ShearState) -> list[Caution]:
        """Whether slip would begin inside the contact."""
        doubtful = self._doubtful(found)
        if doubtful is None or not any(value != 0.0 for value in tuple(doubtful[0])[:3]):
            return []
        fault = ShearedContact(self.friction, doubtful[1])._fault(doubtful[0])
        if not fault:
            return []
        text = (
            f"slip would begin inside this contact: {fault}. Partial slip as an annulus at the edge is not that of the "
            "true contact; that by rings, friction.history(largest_depth), is"
        )
        return [Caution(text, SlipInsideWarning)]

    def _at(self, shape: tuple[int, ...], index: Any) -> ShearedContact:
        """The same of some of the states of this shape."""
        if not np.shape(self.state.depth):
            return self
        columns = [np.broadcast_to(value, shape)[index] for value in self.state]
        normal = state_of([column if column.ndim else float(column) for column in columns], self.friction.contact)
        return ShearedContact(self.friction, normal, self.around)

    def _fault(self, shear: ShearState) -> str:
        """Where the stuck disc of one state has more traction than coefficient times pressure; empty if nowhere, or if either is
        refused."""
        state, mu = self.state, self.friction.coefficient
        try:
            if shear.sliding:
                shear = self._states(0, _NEARLY * self.sliding_shift)
            r = float(shear.stick_radius) * _INSIDE
            traction = np.abs(self.traction(r, shear))
            limit = mu * np.asarray(state.pressure(r))
        except MDRError:
            return ""
        worst = int(np.argmax(traction - limit))
        if (traction[worst] - limit[worst]) * math.pi * float(state.radius) ** 2 <= _NOTICEABLE * mu * float(state.force):
            return ""
        return (
            f"at r = {r[worst]:.3g} the traction would be {traction[worst]:.3g}, more than coefficient times pressure, "
            f"{limit[worst]:.3g} (stick radius {shear.stick_radius:.3g}, contact radius {state.radius:.3g})"
        )
