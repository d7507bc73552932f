# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacements and stresses inside the bodies of a contact."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import FloatOrArray, call, check, native, number, together, words_of
from ._choices import code
from ._warn import Caution, texts_of
from .errors import NoConvergenceError

BODIES = words_of(_layout.BODY_LOWER, _layout.BODY_UPPER)
SIDES = words_of(_layout.SIDE_BELOW, _layout.SIDE_ABOVE)
USUAL, TOLERANCES = 1e-8, 10.0
"""Deviations up to the larger one of the first and of so many tolerances of the medium bring no warning."""
WRONG = 1e-3
"""A deviation beyond which no field is given."""
ENOUGH_POINTS = 1000
"""A state with fewer points is not compared with the surface, which costs as much as two to three single points."""


class _InteriorNumbers(NamedTuple):
    """The numbers of an `Interior`."""

    u_r: FloatOrArray
    """radial displacement [length]"""
    u_t: FloatOrArray
    """circumferential displacement, 0 without friction [length]"""
    u_z: FloatOrArray
    """displacement into the body [length]"""
    s_rr: FloatOrArray
    """radial stress [modulus]"""
    s_tt: FloatOrArray
    """circumferential (hoop) stress [modulus]"""
    s_zz: FloatOrArray
    """stress normal to the surface, -p at the surface [modulus]"""
    s_rz: FloatOrArray
    """shear stress in planes that contain the axis [modulus]"""
    s_rt: FloatOrArray
    """shear stress in planes parallel to the surface, 0 without friction [modulus]"""
    s_tz: FloatOrArray
    """circumferential shear stress, 0 without friction [modulus]"""


class Interior(_InteriorNumbers):
    """Displacements and stresses at points inside a body, from `State.interior`.

    Components are those of cylinder coordinates; each has the shape of the points. z and u_z point into the body; tension is
    positive.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Sphere(10e-6), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> state = contact.at_radius(1e-6)
    >>> inside = state.interior(0.0, 0.48e-6)
    >>> print(f"{inside.tresca / state.pressure(0.0):.4f}")
    0.3101
    """

    _doubts: tuple[str, ...] | None = None
    """None: not examined yet"""
    _asked_of: tuple[Any, str] | None = None
    """the state and the body, until they are"""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about these numbers; empty if there are none."""
        doubts, asked_of = self._doubts, self._asked_of  # another thread may look at the same time
        if doubts is None and asked_of is not None:
            state, body = asked_of
            doubts = self._compared(state._owner._doubts.inside(state, body)[0])._doubts
        return doubts or ()

    def __reduce__(self) -> tuple[Any, ...]:
        """Numbers and warnings, without the contact."""
        return _with_doubts, (tuple(self), self.warnings)

    def _compared(self, found: Iterable[Caution]) -> Interior:
        """Return itself with the warnings found."""
        self._doubts, self._asked_of = texts_of(found), None
        return self

    def _comparable(self, state: Any, body: str) -> Interior:
        """Return itself; reading `warnings` then finds its warnings."""
        self._asked_of = state, body
        return self

    @property
    def von_mises(self) -> FloatOrArray:
        """von Mises stress; a metal yields if it reaches the yield stress [modulus]."""
        with np.errstate(invalid="ignore"):  # infinite stresses
            differences = np.square(self.s_rr - self.s_tt) + np.square(self.s_tt - self.s_zz) + np.square(self.s_zz - self.s_rr)
        return _like(self.s_rr, np.sqrt(0.5 * differences + 3.0 * self._squared_shear()), self._is_infinite())

    @property
    def tresca(self) -> FloatOrArray:
        """Largest shear stress, half of Tresca's equivalent stress [modulus]."""
        principal = self.principal
        return _like(self.s_rr, 0.5 * (principal[..., 0] - principal[..., 2]), self._is_infinite())

    @property
    def principal(self) -> NDArray[np.float64]:
        """Principal stresses s_1 >= s_2 >= s_3 along an additional last axis [modulus].

        They are NaN at singular points.
        """
        components = np.broadcast_arrays(self.s_rr, self.s_rt, self.s_rz, self.s_rt, self.s_tt, self.s_tz, self.s_rz, self.s_tz,
                                         self.s_zz)  # fmt: skip
        tensor = np.stack(components, axis=-1).reshape(*np.shape(self.s_rr), 3, 3)
        finite = np.isfinite(tensor).all(axis=(-2, -1))
        values = np.linalg.eigvalsh(np.where(finite[..., None, None], tensor, 0.0))[..., ::-1]
        return np.where(finite[..., None], values, np.nan)

    def _squared_shear(self) -> Any:
        return np.square(self.s_rz) + np.square(self.s_rt) + np.square(self.s_tz)

    def _is_infinite(self) -> Any:
        return ~np.isfinite(np.asarray(self.s_rr) + self.s_tt + self.s_zz)


def _like(given: FloatOrArray, values: Any, is_infinite: Any) -> FloatOrArray:
    """Infinite where the stresses are, and a float where they are floats."""
    result = np.where(is_infinite, np.inf, values)
    return result if np.ndim(given) else float(result)


def _with_doubts(numbers: tuple[Any, ...], doubts: tuple[str, ...]) -> Interior:
    """A field that was pickled."""
    found = Interior(*numbers)
    found._doubts = doubts
    return found


def interior(state: Any, r: ArrayLike, z: ArrayLike, body: str, side: str, friction: float, angle: ArrayLike) -> Interior:
    """Return the result of `State.interior`."""
    radii, depths, angles = together(r=r, z=z, angle=angle)
    if not radii.size:
        return Interior(*(np.empty(radii.shape) for _ in Interior._fields))
    flat = [np.ascontiguousarray(values, dtype=np.float64).ravel() for values in (radii, depths, angles)]
    given = code("body", body, BODIES), code("side", side, SIDES), number("friction", friction)
    status, field = native.load_interior(state._load, *given, *flat)
    check(status, single=not radii.shape)
    return Interior(*(column.reshape(radii.shape) if radii.shape else float(column[0]) for column in field.T))


def deviation(state: Any, body: str) -> float:
    """Return the deviation of the field of a state from its contact at the surface; 0 if it is not known, as near the surface
    of a gradient that is too steep."""
    try:
        return float(call(native.load_interior_error, state._load, code("body", body, BODIES)))
    except NoConvergenceError:
        return 0.0


def layer_energies(state: Any, body: str, layers: int) -> NDArray[np.float64]:
    """Elastic energy of each of so many layers, of one state."""
    status, energies, count = native.load_layer_energies(state._load, code("body", body, BODIES), layers)
    check(status)
    return np.array(energies[:count])
