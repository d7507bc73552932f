# SPDX-License-Identifier: GPL-3.0-or-later
"""States of a contact with friction that are sheared or twisted under constant normal force (theory/friction.md (3.5))."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import FloatOrArray, Handle, call, evaluate, evaluate_all, native, number, numbers, record, whole
from ._choices import code
from ._warn import Caution, is_collected, is_silent, texts_of, warn_all
from .errors import ArgumentTypeError, MDRError, SlipInsideWarning
from .medium import Homogeneous
from .state import State, state_of

if TYPE_CHECKING:
    from .panels import Figure

_INSIDE = np.array([0.01, 0.3, 0.6, 0.9])
"""Radii, in stick radii, at which traction and pressure are compared."""
_NOTICEABLE = 1e-3
"""Traction beyond coefficient times pressure by this part of the mean is more than the solver's error."""
_NEARLY = 0.98
"""Part of the sliding shift, at which a contact that slides is examined."""
_MOST_POINTS = 1_000_000

_CONTROLS = {"shift": 0, "force": 1}
"""Prescribed quantities."""
_NAMES = (("shift", "tangential_force"), ("twist", "torque"))
"""Their names, along the surface and around the axis."""
_GIVEN = ((_layout.SHIFT, _layout.TANGENTIAL_FORCE), (_layout.TWIST, _layout.TORQUE))


class _ShearNumbers(NamedTuple):
    """The numbers of a `ShearState`."""

    shift: FloatOrArray
    """s, displacement of the indenter along the surface [length]; or phi, its angle about the axis [radian]"""
    tangential_force: FloatOrArray
    """T, |T| <= coefficient F [modulus length^2]; or the torque M [modulus length^3]; with the sign of the shift"""
    stick_radius: FloatOrArray
    """c, radius of the stick zone, 0 if the contact slides [length]"""
    stiffness: FloatOrArray
    """dT/ds = k_t(c), that of a contact of radius c without slip [modulus length]; or dM/dphi [modulus length^3]"""
    dissipated_energy: FloatOrArray
    """energy dissipated since s = 0 [modulus length^3]"""
    sliding: bool | NDArray[np.bool_]
    """True if the whole contact slides; under a twist, if the stick zone is smaller than 1e-6 a, the resolution of the torque"""


class ShearState(_ShearNumbers):
    """Tangential states of a contact; each entry has the shape of the input.

    `states[3]` and `states[mask]` select some of several states.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> states = mdr.Friction(contact, 0.3).shear(contact.at_force(10.0)).at_force([0.75, 1.5, 2.9])
    >>> print(np.round(states.shift * 1e9, 2))
    [ 30.05  63.72 154.36]
    """

    _asked_of: ShearedContact | None = None
    """whose states they are, with the normal state of each; None: those of a history, or pickled ones"""
    _texts: tuple[str, ...] = ()
    """of pickled ones: the warnings of all of them"""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings of the state with the smallest stick zone; empty if there are none."""
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
    """Cycle between +amplitude and -amplitude at constant normal force.

    `ShearedContact.loop` returns it.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> cycle = mdr.Friction(contact, 0.3).shear(contact.at_force(10.0)).loop(1.5, "force")
    >>> print(f"{cycle.dissipated_energy:.4e} {cycle.turn.stick_radius:.4e}")
    1.4554e-08 5.4570e-05
    """

    shift: NDArray[np.float64]
    """s, or phi, from +amplitude to -amplitude and back in equal steps [length, or radian]"""
    tangential_force: NDArray[np.float64]
    """T [modulus length^2], or M [modulus length^3]"""
    dissipated_energy: float
    """energy dissipated in the cycle, the area of the loop [modulus length^3]"""
    turn: ShearState
    """the state at +amplitude when it is reached for the first time; the contact slips outside its stick radius"""
    around: bool = False
    """True if the contact is twisted about its axis"""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the cycle; empty if there are none."""
        return self.turn.warnings

    def plot(self) -> Figure:
        """Return the tangential force against the shift as a figure.

        Numbers are taken as SI.

        Returns
        -------
        Figure
            The figure.
        """
        from .panels import Figure, contacts

        return Figure("A cycle of twist" if self.around else "A cycle of shift", (contacts.of_cycle(self),))


@dataclass(frozen=True)
class ShearedContact:
    """Normal states that are sheared, or twisted about the axis, at constant force.

    `Friction.shear` and `Friction.twist` make it. Slip begins at the edge, in an annulus.

    Parameters
    ----------
    friction : Friction
        The contact with friction; for a twist on a homogeneous medium with E and nu, or on a pair of them.
    state : State
        One state of the contact, or several. They broadcast with shifts and forces; fields and loops need one state.
    around : bool, optional
        True for a twist: shifts are then angles phi about the axis [radian], forces are torques M [modulus length^3].

    Raises
    ------
    ArgumentTypeError
        `friction` is not a `Friction`, or `state` is not a state of its contact.

    Notes
    -----
    A twist is Lubkin's problem, solved exactly: a disc around the axis sticks at any angle, and the torque approaches
    `sliding_force`.

    References
    ----------
    lubkin-1951
    jaeger-1942

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> sheared = mdr.Friction(contact, 0.3).shear(contact.at_force(10.0))
    >>> print(f"{sheared.sliding_force:.2f} {sheared.sliding_shift:.4e}")
    3.00 1.7220e-07
    """

    friction: Any
    state: State
    around: bool = False

    def __post_init__(self) -> None:
        contact = getattr(self.friction, "contact", None)
        if contact is None:
            raise ArgumentTypeError(f"friction = {self.friction!r}: it must be a Friction")
        if not isinstance(self.state, State):
            raise ArgumentTypeError(f"state = {self.state!r}: it must be a State")
        if self.state.contact is None:
            object.__setattr__(self, "state", state_of(self.state._numbers(), contact))
        elif self.state.contact is not contact and self.state.contact != contact:
            raise ArgumentTypeError("state: it must be a State of the contact with friction")

    def at_shift(self, shift: ArrayLike) -> ShearState:
        """Return the states after a displacement along the surface, or a twist.

        Parameters
        ----------
        shift : array_like
            s [length] or phi [radian], of either sign, any shape.

        Returns
        -------
        ShearState
            The states, in the broadcast shape.

        Raises
        ------
        ArgumentTypeError
            The shapes of shifts and normal states do not broadcast.
        """
        return self._looked(self._states(0, shift))

    def at_force(self, force: ArrayLike) -> ShearState:
        """Return the states under a tangential force, or a torque.

        Parameters
        ----------
        force : array_like
            T, |T| <= coefficient F [modulus length^2], or M, |M| < `sliding_force` [modulus length^3]; any shape. At |T| =
            coefficient F sliding begins.

        Returns
        -------
        ShearState
            The states, in the broadcast shape.

        Raises
        ------
        UnreachableError
            The force is larger than friction supports.
        """
        return self._looked(self._states(1, force))

    @cached_property
    def sliding_shift(self) -> FloatOrArray:
        """Shift at which the last point begins to slip [length]; infinite for a twist."""
        return self._sliding[0]

    @cached_property
    def sliding_force(self) -> FloatOrArray:
        """Force in sliding, coefficient F [modulus length^2].

        Of a twist it is the limit of the torque, coefficient int r p dA [modulus length^3]: (3 pi/16) coefficient F a under a
        paraboloid.
        """
        return self._sliding[1]

    def loop(self, amplitude: float, control: str = "shift", points: int = 201) -> FrictionLoop:
        """Return the loop of a cycle between +amplitude and -amplitude, of one state.

        Parameters
        ----------
        amplitude : float
            Amplitude > 0 of the shift or the force.
        control : {"shift", "force"}, optional
            What has the amplitude.
        points : int, optional
            Number of points, >= 3, from +amplitude to -amplitude and back.

        Returns
        -------
        FrictionLoop
            The loop, by Masing's rule, which is exact here.

        Raises
        ------
        InvalidArgumentError
            The amplitude is not greater than 0.
        UnreachableError
            The force amplitude is larger than friction supports.
        """
        kind = code("control", control, _CONTROLS)
        self.state._row()  # one state
        size, count = number("amplitude", amplitude), whole("points", points, 3, _MOST_POINTS)
        along, load, energy = call(native.shear_loop, self._handle, _GIVEN[self.around][kind], size, count)
        turn = self._looked(self._states(kind, size))
        return FrictionLoop(along, load, float(energy), turn, self.around)

    def cycle_energy(self, amplitude: ArrayLike, control: str = "shift") -> FloatOrArray:
        """Return the energy dissipated in a cycle, accurate at small amplitudes.

        Parameters
        ----------
        amplitude : array_like
            Amplitudes of either sign, any shape; as in `loop`.
        control : {"shift", "force"}, optional
            What has the amplitude.

        Returns
        -------
        float or ndarray
            Energy in each cycle, in the shape of `amplitude` [modulus length^3].

        Raises
        ------
        UnreachableError
            A force amplitude is larger than friction supports.
        """
        return 4.0 * self._looked(self._states(code("control", control, _CONTROLS), amplitude)).dissipated_energy

    def traction(self, r: ArrayLike, at: ShearState) -> FloatOrArray:
        """Return the shear traction tau(r) on the surface.

        Parameters
        ----------
        r : array_like
            Radii, 0 <= r <= a, any shape [length].
        at : ShearState
            One state of shear.

        Returns
        -------
        float or ndarray
            tau in the direction of the shift, or around the axis, in the shape of `r` [modulus].

        Raises
        ------
        ArgumentTypeError
            `at` is not a `ShearState`.
        DomainError
            A radius is larger than the contact radius.
        """
        return self._field(_layout.TRACTION, "r", r, at)

    def line_load(self, x: ArrayLike, at: ShearState) -> FloatOrArray:
        """Return the tangential line load q_t(x) of the one-dimensional springs.

        Parameters
        ----------
        x : array_like
            Positions, 0 <= x <= a, any shape [length].
        at : ShearState
            One state of shear.

        Returns
        -------
        float or ndarray
            q_t, in the shape of `x` [modulus length]. Of a twist it is 2 x int_x^a tau dr/sqrt(r^2 - x^2), whose torque is 4
            int_0^a x q dx.

        Raises
        ------
        ArgumentTypeError
            `at` is not a `ShearState`.
        DomainError
            A position is larger than the contact radius.
        """
        return self._field(_layout.TANGENTIAL_LINE_LOAD, "x", x, at)

    @cached_property
    def _handle(self) -> Handle:
        """Handle of its one state: slip is solved once."""
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
            raise ArgumentTypeError(f"at = {at!r}: it must be a ShearState")
        members = [number(f"{member} of the state of shear", value) for member, value in list(at._asdict().items())[:-1]]
        members.append(float(at.sliding))
        return evaluate(name, points, lambda x: native.shear_field(self._handle, members, field, x))

    def _looked(self, found: ShearState) -> ShearState:
        """`found`, with a warning if the stick zone would need more than coefficient times pressure. The user reads it once for
        states of about equal size."""
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
        """The state with the smallest stick zone, and its normal state; None if slip cannot begin inside."""
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
        """Return a warning if slip would begin inside the contact."""
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
        """Return the sheared contact of some of the states of this shape."""
        if not np.shape(self.state.depth):
            return self
        columns = [np.broadcast_to(value, shape)[index] for value in self.state._numbers()]
        normal = state_of([column if column.ndim else float(column) for column in columns], self.friction.contact)
        return ShearedContact(self.friction, normal, self.around)

    def _fault(self, shear: ShearState) -> str:
        """Describe where the stick zone of one state has more traction than coefficient times pressure; empty if nowhere, or
        if either is not available."""
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
