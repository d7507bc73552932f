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
    """radial displacement"""
    u_t: FloatOrArray
    """displacement along the circumference, 0 without friction"""
    u_z: FloatOrArray
    """displacement into the body"""
    s_rr: FloatOrArray
    """radial stress"""
    s_tt: FloatOrArray
    """circumferential (hoop) stress"""
    s_zz: FloatOrArray
    """stress normal to the surface, -p there"""
    s_rz: FloatOrArray
    s_rt: FloatOrArray
    """0 without friction"""
    s_tz: FloatOrArray
    """0 without friction"""


class Interior(_InteriorNumbers):
    """Displacements [length] and stresses [modulus] at points inside a body, in cylinder coordinates; each entry has the shape of
    the input, or is a float. z and u_z point into the body, tension is positive."""

    _doubts: tuple[str, ...] | None = None
    """None: not looked for yet"""
    _asked_of: tuple[Any, str] | None = None
    """the state and the body, while they are not"""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Reasons to doubt these numbers; empty where there are none."""
        doubts, asked_of = self._doubts, self._asked_of  # another thread may look at the same time
        if doubts is None and asked_of is not None:
            state, body = asked_of
            doubts = self._compared(state._owner._doubts.inside(state, body)[0])._doubts
        return doubts or ()

    def __reduce__(self) -> tuple[Any, ...]:
        """Numbers and warnings, without the contact."""
        return _with_doubts, (tuple(self), self.warnings)

    def _compared(self, found: Iterable[Caution]) -> Interior:
        """Itself, whose doubts are known."""
        self._doubts, self._asked_of = texts_of(found), None
        return self

    def _comparable(self, state: Any, body: str) -> Interior:
        """Itself, whose doubts are looked for where `warnings` is read."""
        self._asked_of = state, body
        return self

    @property
    def von_mises(self) -> FloatOrArray:
        """The von Mises stress: a metal yields where it reaches the yield stress."""
        with np.errstate(invalid="ignore"):  # infinite stresses
            differences = np.square(self.s_rr - self.s_tt) + np.square(self.s_tt - self.s_zz) + np.square(self.s_zz - self.s_rr)
        return _like(self.s_rr, np.sqrt(0.5 * differences + 3.0 * self._squared_shear()), self._is_infinite())

    @property
    def tresca(self) -> FloatOrArray:
        """The largest shear stress, (s_1 - s_3)/2. By Tresca's criterion a metal yields where twice this is the yield stress."""
        principal = self.principal
        return _like(self.s_rr, 0.5 * (principal[..., 0] - principal[..., 2]), self._is_infinite())

    @property
    def principal(self) -> NDArray[np.float64]:
        """The principal stresses s_1 >= s_2 >= s_3, along one more axis at the end; NaN where stresses are infinite."""
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
    """What `State.interior` returns."""
    radii, depths, angles = together(r=r, z=z, angle=angle)
    if not radii.size:
        return Interior(*(np.empty(radii.shape) for _ in Interior._fields))
    flat = [np.ascontiguousarray(values, dtype=np.float64).ravel() for values in (radii, depths, angles)]
    given = code("body", body, BODIES), code("side", side, SIDES), number("friction", friction)
    status, field = native.load_interior(state._load, *given, *flat)
    check(status, single=not radii.shape)
    return Interior(*(column.reshape(radii.shape) if radii.shape else float(column[0]) for column in field.T))


def deviation(state: Any, body: str) -> float:
    """By how much the field of a state differs from its contact on the surface; 0 where it is not known there, as near the surface
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
