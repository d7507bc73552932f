# SPDX-License-Identifier: GPL-3.0-or-later
"""Poroelastic gels: the material, and histories of contacts with it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _layout
from ._boundary import (
    ComplexOrArray,
    FloatOrArray,
    Handle,
    call,
    complex_of,
    complex_values,
    evaluate,
    native,
    number,
    of_waves,
    one_path,
    words_of,
)
from ._choices import code
from ._parameters import WithParameters
from ._units import DIFFUSIVITY, MODULUS, RATIO
from .errors import ArgumentTypeError, InvalidArgumentError
from .material import Elastic
from .profile import FlatPunch, Paraboloid, Profile
from .time import History, check_radius

__all__ = ["Poroelastic", "history"]

DRAINAGES = words_of(_layout.DRAINAGE_SURFACE, _layout.DRAINAGE_SEALED, _layout.DRAINAGE_INDENTER)
"""Names and codes of the drainage at the surface."""

_GIVEN = words_of(_layout.DEPTH, _layout.FORCE)

_NO_STATES = (
    "this body is poroelastic, and its states depend on time: take relaxation, creep, dynamic_stiffness, "
    "pressure_in_time or mdrcontact.poroelastic.history, or the undrained or the drained material"
)


class NoElasticStates(Handle):
    """The handle of a gel, of its bodies and of their contacts: they have no elastic states, and its use raises."""

    def __init__(self) -> None:
        pass

    def __del__(self, free: Any = None) -> None:
        """Do nothing: there is no memory to free."""

    @property
    def _address(self) -> int:  # type: ignore[override]
        """Raises."""
        raise InvalidArgumentError(_NO_STATES)


@dataclass(frozen=True)
class Poroelastic(WithParameters):
    """Poroelastic gel: an elastic skeleton filled with a fluid that flows through it.

    Skeleton and fluid are incompressible (Biot). A sudden load meets the `undrained` material, a lasting one the `drained`
    material.

    Parameters
    ----------
    shear_modulus : float
        G > 0, of a sudden and of a lasting load [modulus].
    nu : float
        Drained Poisson's ratio, -1 < nu < 0.5 [1].
    diffusivity : float
        D > 0 [length^2/time]: 2 G (1 - nu)/(1 - 2 nu) times hydraulic permeability over viscosity.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    biot-1941
    hu-2010

    Examples
    --------
    >>> gel = mdr.poroelastic.Poroelastic(shear_modulus=28e3, nu=0.28, diffusivity=3e-8)
    >>> contact = mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(gel))
    >>> print(np.round(contact.relaxation([1.0, 10.0, 100.0], drainage="surface"), 1))
    [199.4 178.6 163.6]
    """

    shear_modulus: float = field(metadata={"dimension": MODULUS})
    nu: float = field(metadata={"dimension": RATIO})
    diffusivity: float = field(metadata={"dimension": DIFFUSIVITY})

    def __post_init__(self) -> None:
        self._numbers()
        self._set(_handle=NoElasticStates())
        for name in ("shear_modulus", "diffusivity"):
            value = getattr(self, name)
            if not 0.0 < value < math.inf:
                raise InvalidArgumentError(f"{name} = {value!r}: it must be finite and greater than 0")
        if not -1.0 < self.nu < 0.5:
            raise InvalidArgumentError(
                f"nu = {self.nu!r}: the drained Poisson's ratio of a gel must be greater than -1 and less than 0.5, "
                "at which nothing drains"
            )

    @classmethod
    def from_permeability(cls, shear_modulus: float, nu: float, permeability: float, viscosity: float) -> Poroelastic:
        """Return the gel with a given hydraulic permeability and fluid viscosity.

        Parameters
        ----------
        shear_modulus : float
            G > 0 [modulus].
        nu : float
            Drained Poisson's ratio, -1 < nu < 0.5 [1].
        permeability : float
            Hydraulic permeability > 0 [length^2].
        viscosity : float
            Viscosity of the fluid > 0 [modulus time].

        Returns
        -------
        Poroelastic
            The gel.

        Raises
        ------
        InvalidArgumentError
            A number is outside its range.
        """
        flow, thickness = number("permeability", permeability), number("viscosity", viscosity)
        for name, value in (("permeability", flow), ("viscosity", thickness)):
            if not 0.0 < value < math.inf:
                raise InvalidArgumentError(f"{name} = {value!r}: it must be finite and greater than 0")
        probe = cls(shear_modulus, nu, 1.0)
        return cls(shear_modulus, nu, probe.longitudinal_modulus * flow / thickness)

    @property
    def longitudinal_modulus(self) -> float:
        """M = 2 G (1 - nu)/(1 - 2 nu), drained modulus of uniaxial strain [modulus]."""
        return 2.0 * self.shear_modulus * (1.0 - self.nu) / (1.0 - 2.0 * self.nu)

    @property
    def undrained(self) -> Any:
        """Elastic material of a sudden load, with nu = 0.5."""
        return self._elastic(0.5)

    @property
    def drained(self) -> Any:
        """Elastic material of a lasting load."""
        return self._elastic(self.nu)

    def _elastic(self, nu: float) -> Any:
        return Elastic(2.0 * self.shear_modulus * (1.0 + nu), nu)


def is_poroelastic(medium: object) -> bool:
    """Return whether a medium is a gel."""
    return isinstance(getattr(medium, "material", getattr(medium, "coating", None)), Poroelastic)


def check_body(coating: object, substrate: object, model: str, options: object, rigid: object) -> bool:
    """Return whether one of the materials of a coated body is a gel; raise for unsupported bodies."""
    if not isinstance(coating, Poroelastic) and not isinstance(substrate, Poroelastic):
        return False
    if not isinstance(coating, Poroelastic) or substrate is not rigid:
        raise InvalidArgumentError(
            "a gel next to another deformable material is not supported: a gel is a half-space, or a film on a RIGID "
            "base that lets no fluid through"
        )
    if model != "exact" or options:
        raise InvalidArgumentError("a film of a gel is solved exactly: it has no other model and no options")
    return True


@lru_cache(maxsize=64)
def table(nu: float, drainage: int, ratio: float) -> Handle:
    """The responses of a gel; those of a half-space, ratio = 0, serve all radii, times and diffusivities."""
    status, _, created = native.poroelastic_new(nu, drainage, ratio)
    return Handle((status, created))


def drainage_code(drainage: str | None) -> int:
    """Return the code of a drainage, which has no default."""
    if drainage is None or drainage not in DRAINAGES:
        given = "drainage is missing" if drainage is None else f"drainage = {drainage!r}"
        raise InvalidArgumentError(
            f'{given}: it must be "surface" (the whole surface drains, under the indenter '
            'too), "sealed" (no flux anywhere) or "indenter" (no flux under the indenter, drained outside it)'
        )
    return DRAINAGES[drainage]


def gel_of(medium: Any) -> Poroelastic:
    """Return the gel of a half-space or a film."""
    gel: Poroelastic = getattr(medium, "material", None) or medium.coating
    return gel


def body_of(medium: Any, gel: Poroelastic) -> Any:
    """Return the same body of another gel."""
    return medium.replace(material=gel) if hasattr(medium, "material") else medium.replace(coating=gel)


def contact_radius(indenter: Profile, radius: float | None) -> float:
    """Return the radius of a flat punch, or the given one."""
    if radius is not None:
        check_radius(indenter, number("radius", radius))
        return float(radius)
    if isinstance(indenter, FlatPunch):
        return float(indenter.radius)
    raise ArgumentTypeError("radius is missing: only a flat punch determines it. Give the contact radius")


def _answers(medium: Any, radius: float, drainage: str | None) -> tuple[Handle, float, float, float]:
    """Return the first arguments of the functions of the library: the table, G, D and a."""
    gel, code = gel_of(medium), drainage_code(drainage)
    thickness = getattr(medium, "thickness", None)
    if not 0.0 < radius < math.inf:
        raise InvalidArgumentError(f"radius = {radius!r}: it must be finite and greater than 0")
    handle = table(gel.nu, code, radius / thickness if thickness else 0.0)
    return handle, gel.shear_modulus, gel.diffusivity, radius


def step(contact: Any, kind: int, time: ArrayLike, radius: float | None, drainage: str | None) -> FloatOrArray:
    """See `Contact.relaxation` and `Contact.creep`."""
    handle, modulus, diffusivity, a = _answers(contact.medium, contact_radius(contact.indenter, radius), drainage)
    answer = _layout.RELAXATION if kind == _layout.RELAXATION else _layout.CREEP
    return evaluate("time", time, lambda t: native.poroelastic_response(handle, answer, modulus, diffusivity, a, t))


def dynamic_stiffness(contact: Any, omega: ArrayLike, radius: float | None, drainage: str | None) -> ComplexOrArray:
    """See `Contact.dynamic_stiffness`."""
    handle, modulus, diffusivity, a = _answers(contact.medium, contact_radius(contact.indenter, radius), drainage)
    return complex_values("omega", omega, lambda w: native.poroelastic_dynamic_stiffness(handle, modulus, diffusivity, a, w))


def compliance(medium: Any, k: ArrayLike, omega: ArrayLike, drainage: str | None) -> ComplexOrArray:
    """See `Medium.compliance`."""
    gel, code = gel_of(medium), drainage_code(drainage)
    constants = gel.nu, code, getattr(medium, "thickness", 0.0), gel.shear_modulus, gel.diffusivity
    return complex_of(*of_waves(k, omega, lambda *waves: native.poroelastic_compliance(*constants, *waves)))


def pressure(
    contact: Any, kind: str, r: ArrayLike, time: float, depth: float | None, radius: float | None, drainage: str | None
) -> FloatOrArray:
    """See `Contact.pressure_in_time`."""
    chosen = code("kind", kind, words_of(_layout.TOTAL_PRESSURE, _layout.PORE_PRESSURE))
    is_flat = isinstance(contact.indenter, FlatPunch)
    _check_held(contact.indenter)
    held = contact_radius(contact.indenter, radius)
    if is_flat and depth is None:
        raise ArgumentTypeError("depth is missing. Give the depth of the step")
    if not is_flat and depth is not None:
        raise ArgumentTypeError("depth: under a paraboloid it follows from the radius. Omit it")
    d = number("depth", depth) if depth is not None else held**2 / contact.indenter.radius
    handle, modulus, diffusivity, a = _answers(contact.medium, held, drainage)
    at = number("time", time)
    return d * evaluate(
        "r", r, lambda points: native.poroelastic_pressure(handle, chosen, int(is_flat), modulus, diffusivity, a, at, points)
    )


def _check_held(indenter: Profile) -> None:
    """Raise for an indenter without a solution at a constant radius."""
    if not isinstance(indenter, (FlatPunch, Paraboloid)):
        raise InvalidArgumentError(
            f"indenter = {indenter!r}: contacts with gels are solved for FlatPunch(...), and for "
            "Paraboloid(...) at a held contact radius, which a sphere is while its contact is small"
        )


def history(
    contact: Any,
    time: ArrayLike,
    *,
    depth: ArrayLike | None = None,
    force: ArrayLike | None = None,
    radius: ArrayLike | None = None,
    drainage: str | None = None,
) -> History:
    """Follow a contact with a gel along a path in time.

    A flat punch can follow any path of depth or force, exactly; the contact supports tension. A paraboloid is pressed in suddenly
    and held at one contact radius. Its true contact radius increases by up to 9 % and decreases again; with drainage "indenter" its
    force then differs by up to 0.05 of the part that relaxes.

    Parameters
    ----------
    contact : Contact
        Contact of a `FlatPunch` or a `Paraboloid` with a gel.
    time : array_like
        Strictly ascending times, one dimension [time]. Before the first time the bodies are at rest.
    depth : array_like, optional
        Depths of a flat punch at these times, linear in between [length]. The first value is reached in a jump.
    force : array_like, optional
        Forces on a flat punch at these times, as `depth` [modulus length^2].
    radius : array_like, optional
        Constant contact radius of a paraboloid, repeated for each time [length].
    drainage : {"surface", "sealed", "indenter"}
        As in `Contact.relaxation`. It has no default.

    Returns
    -------
    History
        Time, depth, contact radius and force.

    Raises
    ------
    InvalidArgumentError
        The body is not a gel, the drainage is missing, or the path is not supported.

    Examples
    --------
    >>> gel = mdr.poroelastic.Poroelastic(shear_modulus=28e3, nu=0.28, diffusivity=3e-8)
    >>> contact = mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(gel))
    >>> path = mdr.poroelastic.history(contact, [0.0, 5.0, 60.0], depth=[0.0, 5e-5, 5e-5], drainage="indenter")
    >>> print((path.force * 1e3).round(2))
    [ 0.   10.24  8.36]
    """
    if not is_poroelastic(contact.medium):
        raise InvalidArgumentError(f"medium = {contact.medium!r}: it must be of a gel. Call contact.history(...) for other bodies")
    given, t, values = one_path(time, depth=depth, force=force, radius=radius)
    _check_held(contact.indenter)
    is_flat = isinstance(contact.indenter, FlatPunch)
    if is_flat and given == "radius":
        raise InvalidArgumentError("radius: the contact radius of a flat punch is constant. Give depth or force")
    if not is_flat and (given != "radius" or not (values == values[:1]).all()):
        raise InvalidArgumentError(
            "this path is not supported: under a paraboloid on a gel the contact radius and the drained surface change with the "
            "pressure of the fluid. Give radius=, the constant contact radius after the step"
        )
    drainage_code(drainage)
    if not t.size:
        return History(t, t.copy(), t.copy(), t.copy())
    held = float(contact.indenter.radius if is_flat else values[0])
    constants = _answers(contact.medium, held, drainage)
    if is_flat:
        other = call(native.poroelastic_history, constants[0], _GIVEN[given], *constants[1:], t, values)
        depths, forces = (values.copy(), other) if given == "depth" else (other, values.copy())
    else:
        if not (np.isfinite(t).all() and (np.diff(t) > 0.0).all()):
            raise InvalidArgumentError("time: it must be finite and strictly ascending")
        depths = np.full(t.shape, held**2 / contact.indenter.radius)
        forces = depths * call(native.poroelastic_response, constants[0], _layout.PARABOLOID_RELAXATION, *constants[1:], t - t[0])
    return History(t, depths, np.full(t.shape, held), forces)
