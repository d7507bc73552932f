# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of a body: tension, plate and membrane (theory/surfaces.md (5.1), (5.2))."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from numpy.typing import NDArray

from .. import _layout
from .._boundary import record
from .._parameters import WithParameters
from .._units import BENDING, STRETCHING, SURFACE_TENSION
from ..errors import ArgumentTypeError, InvalidArgumentError


@dataclass(frozen=True)
class Surface(WithParameters):
    """What the surface of a body adds to it: 1/C(k) becomes 1/C + tension k^2 + bending k^4.

    tension : tau [modulus length], the same under the indenter and beside it: of a gel 0.01 to 0.07 N/m. Greater than 0; with a
        plate greater than 0.95 times the tension tau_c < 0 under which the surface wrinkles
    bending : B >= 0 of a plate that slides on the body, E h^3/(12 (1 - nu^2)) [modulus length^3]
    stretching : K_m >= 0, stiffness in its plane of a thin sheet that is bonded to the body, E h/(1 - nu^2) [modulus length]: C is
        that of a body whose surface moves sideways against K_m k^2

    Contacts with it answer states, adhesion, displacement of the surface, laws and fits to 1e-9 (cones 1e-8), the pressure to 2e-7.
    Friction, stresses inside, energies, time and pairs of deformable bodies are refused. Slopes are taken as small; a stiff film
    that is bonded, or whose thickness is known, is a layer.
    """

    tension: float = field(default=0.0, metadata={"dimension": SURFACE_TENSION})
    bending: float = field(default=0.0, metadata={"dimension": BENDING})
    stretching: float = field(default=0.0, metadata={"dimension": STRETCHING})

    def __post_init__(self) -> None:
        self._numbers()


def given_surface(surface: object, *, elastic: bool) -> Surface | None:
    """The surface if there is one that adds something; an exception if it is anything else, or the body is not elastic."""
    if surface is None:
        return None
    if not isinstance(surface, Surface):
        raise ArgumentTypeError(
            f"surface = {surface!r} is not allowed: it must be a Surface(tension=..., bending=..., stretching=...) or None"
        )
    if surface == Surface():
        return None
    if not elastic:
        raise InvalidArgumentError(
            "surface is not allowed: under a surface with tension or a sheet all materials must be Elastic(E, nu)"
        )
    return surface


def structure_of(surface: Surface | None) -> NDArray[Any] | None:
    """The surface as the library takes it."""
    return None if surface is None else record(_layout.surface, **surface._given())
