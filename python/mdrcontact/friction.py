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
    """Contact with Coulomb friction in partial slip.

    The contact slips where the traction reaches coefficient times pressure and sticks where it is less.

    Parameters
    ----------
    contact : Contact
        A contact without adhesion on a homogeneous medium, on a coated, layered or graded one under the model "exact" or Gao's
        models ("gao", "gao-series", "gao-power"), or on a pair of these.
    coefficient : float
        Coefficient of friction, > 0 [1].

    Raises
    ------
    ArgumentTypeError
        `contact` is not a `Contact`.
    InvalidArgumentError
        The coefficient is not greater than 0, or the contact is adhesive or of a medium without a tangential stiffness.

    Notes
    -----
    The normal force is constant, and the shear does not change the pressure (Cattaneo, Mindlin); the tangential force would be 1 to
    6 % higher with this coupling. The displacement that varies as cos 2 phi around the axis is neglected, at most 0.25 % of the
    force. Apart from this, homogeneous and exact media are solved exactly; Gao's models superpose punches. A negative pressure, or
    slip that begins inside the contact immediately (a flat punch on a stiff coating), raises `DomainError`; slip that begins inside
    later raises a `SlipInsideWarning`.

    References
    ----------
    cattaneo-1938
    mindlin-1949
    jager-1995
    ciavarella-1998b

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> state = contact.at_force(10.0)
    >>> sheared = mdr.Friction(contact, 0.3).shear(state).at_force(1.5)
    >>> print(f"{sheared.stick_radius / state.radius:.4f} {0.5 ** (1 / 3):.4f}")
    0.7937 0.7937
    """

    contact: Contact
    coefficient: float
    _looked_at: set[tuple[int, ...]] = field(init=False, repr=False, compare=False)

    def __init__(self, contact: Contact, coefficient: float) -> None:
        if not isinstance(contact, Contact):
            raise ArgumentTypeError(f"contact = {contact!r}: it must be a Contact")
        mu = number("coefficient", coefficient)
        created = native.friction_new(contact._handle, mu)
        self._set(_handle=Handle(created), contact=contact, coefficient=mu, _looked_at=set())

    def shear(self, state: State) -> ShearedContact:
        """Return the tangential response of normal states under constant normal force.

        Parameters
        ----------
        state : State
            One state of the contact, or several.

        Returns
        -------
        ShearedContact
            The states, to be displaced along the surface.

        Raises
        ------
        ArgumentTypeError
            `state` is not a state of this contact.
        """
        return ShearedContact(self, state)

    def twist(self, state: State) -> ShearedContact:
        """Return the torsional response of normal states under constant normal force.

        Parameters
        ----------
        state : State
            One state of the contact, or several, on a homogeneous medium.

        Returns
        -------
        ShearedContact
            The states, to be twisted about the axis.

        Raises
        ------
        ArgumentTypeError
            `state` is not a state of this contact.
        """
        return ShearedContact(self, state, around=True)

    def history(self, largest_depth: float | None = None, rings: int | None = None) -> FrictionHistory:
        """Return a history of the contact, which has not been loaded yet.

        Parameters
        ----------
        largest_depth : float, optional
            Largest depth of the path, > 0 [length]. It is needed on exact layered bodies, whose contact is divided into rings.
            None, the default, is possible on homogeneous bodies, where every step is exact.
        rings : int, optional
            Number of rings, 10 to 1000. None is 100.

        Returns
        -------
        FrictionHistory
            The history, at depth 0.

        Raises
        ------
        InvalidArgumentError
            `rings` or `largest_depth` is outside its range, or missing.
        """
        return FrictionHistory(self, largest_depth, rings)


class FrictionHistory:
    """Contact with friction along any path of normal and tangential loading.

    `Friction.history` makes it. The object changes as it advances: do not share it between threads. A `copy()` continues
    independently.

    Parameters
    ----------
    friction : Friction
        The contact with friction.
    largest_depth : float, optional
        As in `Friction.history` [length].
    rings : int, optional
        As in `Friction.history`.

    Raises
    ------
    ArgumentTypeError
        `friction` is not a `Friction`.
    InvalidArgumentError
        `rings` or `largest_depth` is outside its range, or missing.

    Notes
    -----
    The springs of homogeneous bodies do not interact: every step in which depth and shift change proportionally is exact, of any
    size. On other bodies rings of the surface each follow Coulomb's law. With 100 rings the error of T is 2e-4 coefficient F, that
    of the stick radius a third of a ring and that of the energy 2e-3; twice the rings at least halve it. Steps are divided where
    the contact edge reaches the edge of a ring, so that a long step equals many short ones. A pickle contains the steps, 32 bytes
    each, and repeats them.

    References
    ----------
    mindlin-1953

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> history = mdr.Friction(contact, 0.3).history()
    >>> loaded = history.advance(force=10.0, shift=0.0)
    >>> shear = history.advance(force=10.0, tangential_force=1.5)
    >>> print(f"{shear.shift:.4e} {shear.dissipated_energy:.4e} {history.state.depth:.4e}")
    6.3720e-08 3.6386e-09 4.7270e-07
    """

    def __init__(self, friction: Friction, largest_depth: float | None = None, rings: int | None = None) -> None:
        if not isinstance(friction, Friction):
            raise ArgumentTypeError(f"friction = {friction!r}: it must be a Friction")
        deepest = 0.0 if largest_depth is None else number("largest_depth", largest_depth)
        count = 0 if rings is None else whole("rings", rings, 1)
        if deepest == 0.0 and (largest_depth is not None or count):
            raise InvalidArgumentError(f"largest_depth = {largest_depth!r}: rings need a largest_depth > 0")
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
        """Advance to a depth or normal force and a shift or tangential force.

        Give one of each two. Arrays of one dimension, which broadcast, are steps one after the other.

        Parameters
        ----------
        depth : array_like, optional
            Depth >= 0 at the end of a step [length].
        force : array_like, optional
            Normal force F >= 0 at the end of a step [modulus length^2].
        shift : array_like, optional
            Shift at the end of a step [length].
        tangential_force : array_like, optional
            Tangential force T at the end of a step, |T| < coefficient F [modulus length^2].

        Returns
        -------
        ShearState
            States at the ends of the steps. `stick_radius` is where the last step did not slip; `dissipated_energy` counts from the
            beginning.

        Raises
        ------
        ArgumentTypeError
            Not exactly one of each two is given.
        UnreachableError
            The tangential force is larger than friction supports. After an error the history is unchanged.
        """
        if (depth is None) == (force is None) or (shift is None) == (tangential_force is None):
            raise ArgumentTypeError("give exactly one of depth and force, and exactly one of shift and tangential_force")
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
        """Return a history with the same past that continues independently.

        Returns
        -------
        FrictionHistory
            The copy.
        """
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
    """Return a history from its steps."""
    history, rows = FrictionHistory(*given), np.array(steps).reshape(-1, 4)
    turns = np.flatnonzero(np.any(np.diff(rows[:, :2], axis=0) != 0.0, axis=1)) + 1
    for part in np.split(rows, turns):
        if not len(part):
            continue
        normal = "force" if part[0, 0] == _layout.FORCE else "depth"
        along = "shift" if part[0, 1] == _layout.SHIFT else "tangential_force"
        history.advance(**{normal: part[:, 2], along: part[:, 3]})
    return history
