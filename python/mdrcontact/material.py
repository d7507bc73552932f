# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: an isotropic elastic body, and the rigid one."""

from __future__ import annotations

from dataclasses import dataclass

from . import _native
from ._boundary import Handle, evaluate
from ._value import Value

__all__ = ["Elastic", "RIGID"]


@dataclass(frozen=True)
class Elastic(Value):
    """An isotropic elastic material.

    E : Young's modulus, > 0, in the unit of pressure of the whole problem (Pa with metres and newtons)
    nu : Poisson's ratio, -1 < nu <= 0.5
    """

    E: float
    nu: float

    def __post_init__(self) -> None:
        # the library's half-space of this material checks E and nu, and knows E*
        self._set(_handle=Handle(_native.medium_homogeneous(*self._numbers()), _native.medium_free))

    @property
    def contact_modulus(self) -> float:
        """E* = E/(1 - nu^2), equation (2) [modulus]."""
        return float(evaluate("a", 1.0, lambda radii: _native.medium_modulus(self._handle.address, radii)))


class _Rigid:
    """The type of `RIGID`; there is one object of it."""

    def __repr__(self) -> str:
        return "RIGID"

    def __reduce__(self) -> str:
        return "RIGID"


RIGID = _Rigid()
"""A rigid base under a layer: for the models "exact", "dimitriadis" and "garcia"."""
