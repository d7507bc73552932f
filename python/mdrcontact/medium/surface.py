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
    """Tension, plate or membrane on the surface of an elastic body.

    It changes the compliance of the surface: `1/C(k)` becomes `1/C(k) + tau k^2 + B k^4`.

    Parameters
    ----------
    tension : float, optional
        tau, surface tension, equal inside and outside the contact [modulus length]; 0.01 to 0.07 N/m for gels. It is > 0; with a
        plate it may be negative down to 0.95 times the tension at which the surface wrinkles.
    bending : float, optional
        B, bending stiffness of a plate that slides on the body, E h^3/(12 (1 - nu^2)), >= 0 [modulus length^3].
    stretching : float, optional
        K_m, in-plane stiffness of a thin bonded sheet, E h/(1 - nu^2), >= 0 [modulus length].

    Raises
    ------
    ArgumentTypeError
        An argument is not a number. The medium that uses the surface checks the ranges.

    Notes
    -----
    Contacts support states, adhesion, surface displacement, laws and fits to 1e-9 (cones 1e-8), and the pressure to 2e-7. Friction,
    subsurface stresses, energies, histories and pairs of deformable bodies are not supported. Slopes are assumed small. Describe a
    stiff bonded film, or one of known thickness, as a layer.

    References
    ----------
    style-2013
    hertz-1884

    Examples
    --------
    >>> gel = mdr.Elastic(5e3, 0.5)
    >>> bare = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(gel))
    >>> tense = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(gel, mdr.Surface(tension=0.03)))
    >>> print(f"{bare.at_depth(1e-6).force:.4e} {tense.at_depth(1e-6).force:.4e}")
    2.8109e-08 8.2633e-08
    """

    tension: float = field(default=0.0, metadata={"dimension": SURFACE_TENSION})
    bending: float = field(default=0.0, metadata={"dimension": BENDING})
    stretching: float = field(default=0.0, metadata={"dimension": STRETCHING})

    def __post_init__(self) -> None:
        self._numbers()


def given_surface(surface: object, *, elastic: bool) -> Surface | None:
    """Return the surface if it has an effect; raise if it is anything else, or if the body is not elastic."""
    if surface is None:
        return None
    if not isinstance(surface, Surface):
        raise ArgumentTypeError(f"surface = {surface!r}: it must be a Surface(tension=..., bending=..., stretching=...) or None")
    if surface == Surface():
        return None
    if not elastic:
        raise InvalidArgumentError("surface: under a surface with tension or a sheet all materials must be Elastic(E, nu)")
    return surface


def structure_of(surface: Surface | None) -> NDArray[Any] | None:
    """The surface as the library takes it."""
    return None if surface is None else record(_layout.surface, **surface._given())
