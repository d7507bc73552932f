# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: an isotropic elastic body, and the rigid one."""

from __future__ import annotations

from . import _native
from ._boundary import Handle, evaluate, number
from ._described import Described

__all__ = ["Elastic", "RIGID"]


class Elastic(Described):
    """An isotropic elastic material.

    E : Young's modulus, > 0, in the unit of pressure of the whole problem (Pa with metres and newtons)
    nu : Poisson's ratio, -1 < nu <= 0.5
    """

    E: float
    nu: float

    def __init__(self, E: float, nu: float) -> None:
        self._describe(E=number("E", E), nu=number("nu", nu))
        self._half_space()

    @property
    def contact_modulus(self) -> float:
        """E* = E/(1 - nu^2), equation (2) [pressure]."""
        return float(evaluate(_native.medium_modulus, self._half_space().address, name="a", values=1.0))

    def _half_space(self) -> Handle:
        # made anew each time: it is cheap, and it is how the library checks E and nu
        return Handle(_native.medium_homogeneous(self.E, self.nu), _native.medium_free)


class _Rigid:
    """The type of `RIGID`; there is one object of it."""

    def __repr__(self) -> str:
        return "RIGID"

    def __reduce__(self) -> str:
        return "RIGID"


RIGID = _Rigid()
"""A rigid base under a layer: for the models "exact", "dimitriadis" and "garcia"."""
