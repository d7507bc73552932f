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
    _half_space: Handle

    def __init__(self, E: float, nu: float) -> None:
        E, nu = number("E", E), number("nu", nu)
        # the library's half-space of this material checks E and nu, and knows E*
        object.__setattr__(self, "_half_space", Handle(_native.medium_homogeneous(E, nu), _native.medium_free))
        self._describe(E=E, nu=nu)

    @property
    def contact_modulus(self) -> float:
        """E* = E/(1 - nu^2), equation (2) [pressure]."""
        return float(evaluate(_native.medium_modulus, 1, self._half_space.address, name="a", values=1.0))


class _Rigid:
    """The type of `RIGID`; there is one object of it."""

    def __repr__(self) -> str:
        return "RIGID"

    def __reduce__(self) -> str:
        return "RIGID"


RIGID = _Rigid()
"""A rigid base under a layer: for the models "exact", "dimitriadis" and "garcia"."""
