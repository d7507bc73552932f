# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [medium] of a problem file."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .. import medium
from .._units import (
    AREA,
    ELECTRICAL_CONDUCTIVITY,
    HEAT_CAPACITY,
    MODULUS,
    THERMAL_CONDUCTIVITY,
    TIME,
    Dimension,
    dimensions,
)
from ..conductor import SLIDING, Conductor, Interface
from ..crystals import CRYSTALS
from ..errors import InvalidArgumentError
from ..material import _ENGINEERING, RIGID, SMOOTH, Elastic, PowerLawRheology, TransverselyIsotropic, Viscoelastic
from ..medium.models import MODELS, OPTIONS
from ..poroelastic import Poroelastic
from .section import ProblemError, Section

_CONDUCTING: Mapping[str, Dimension] = {
    "thermal_conductivity": THERMAL_CONDUCTIVITY,
    "thermal_conductivity_along": THERMAL_CONDUCTIVITY,
    "electrical_conductivity": ELECTRICAL_CONDUCTIVITY,
    "electrical_conductivity_along": ELECTRICAL_CONDUCTIVITY,
    "heat_capacity": HEAT_CAPACITY,
}
MATERIAL: Mapping[str, Dimension | None] = {
    **dimensions(Elastic, TransverselyIsotropic),
    **_ENGINEERING,
    **dimensions(Viscoelastic, PowerLawRheology, Poroelastic),
    **{"material": None, "moduli": MODULUS, "times": TIME, "permeability": AREA},
    **_CONDUCTING,
}
_SURFACE = {f"surface_{name}": dimension for name, dimension in dimensions(medium.Surface).items()}
_PLACE: Mapping[str, Dimension | None] = {**dimensions(medium.Layer), "interface": None}
"""Keys of a layer beside those of its material."""
_FILM: Mapping[str, Dimension | None] = {**MATERIAL, **_PLACE}
_MATERIALS = ("material", "coating", "layer", "substrate")
"""Tables in that of a medium."""

KNOWN: Mapping[str, Dimension | None] = {
    "type": None,
    "model": None,
    **dict.fromkeys((*_MATERIALS, *OPTIONS)),
    **_SURFACE,
    **dimensions(medium.Graded, medium.PowerLawGraded, medium.TabulatedMedium),
    **_FILM,
}


def read_material(section: Section) -> Any:
    """The material of a table: the name of a crystal as `material` of one with its axis along z, or what a class makes of keys
    of which one is its own."""
    if "material" in section:
        section.only(("material", *_PLACE), "a material with a name")
        return _crystal(section, "material")
    for key, (what, call) in _KINDS.items():
        if key in section:
            return section.make(call, f"{what}, which has {', '.join(section.arguments(call))}", _PLACE)
    return section.make(_elastic, "an elastic material", _PLACE)


def _elastic(
    E: float,
    nu: float,
    thermal_conductivity: float | None = None,
    thermal_conductivity_along: float | None = None,
    electrical_conductivity: float | None = None,
    electrical_conductivity_along: float | None = None,
    heat_capacity: float | None = None,
) -> Elastic:
    thermal = thermal_conductivity, thermal_conductivity_along
    electrical = electrical_conductivity, electrical_conductivity_along
    if None not in (thermal[0], electrical[0]):
        raise InvalidArgumentError("give thermal_conductivity or electrical_conductivity: one problem conducts one of them")
    for name, (into, along) in (("thermal_conductivity", thermal), ("electrical_conductivity", electrical)):
        if along is not None and into is None:
            raise InvalidArgumentError(f"{name}_along is not allowed without {name}, that into the body")
    sigma, along = thermal if electrical[0] is None else electrical
    if sigma is not None:
        return Elastic(E, nu, Conductor(sigma, along, heat_capacity or 0.0))
    if heat_capacity is not None:
        raise InvalidArgumentError("heat_capacity is not allowed without thermal_conductivity or electrical_conductivity")
    return Elastic(E, nu)


def _prony(
    relaxed_shear_modulus: float,
    moduli: Sequence[float] = (),
    times: Sequence[float] = (),
    nu: float | None = None,
    bulk_modulus: float | None = None,
    viscosity: float = 0.0,
) -> Viscoelastic:
    if len(moduli) != len(times):
        raise InvalidArgumentError(f"moduli has {len(moduli)} and times has {len(times)} entries: give as many of both")
    return Viscoelastic(relaxed_shear_modulus, zip(moduli, times, strict=True), nu, bulk_modulus, viscosity)


_KINDS: Mapping[str, tuple[str, Callable[..., Any]]] = {
    "diffusivity": ("a gel", Poroelastic),
    "permeability": ("a gel", Poroelastic.from_permeability),
    "exponent": ("a power law", PowerLawRheology),
    "relaxed_shear_modulus": ("a Prony series", _prony),
    **dict.fromkeys(dimensions(TransverselyIsotropic), ("a material with an axis", TransverselyIsotropic)),
    **dict.fromkeys(_ENGINEERING, ("a material with an axis", TransverselyIsotropic.from_engineering)),
}
"""By a key that others do not have: what it is, and what makes it. All others are elastic."""


def _crystal(section: Section, key: str) -> TransverselyIsotropic:
    return CRYSTALS[section.choice(key, CRYSTALS)].material


def _model(section: Section) -> tuple[str, dict[str, Any]]:
    options = {name: section.plain(name) for name in OPTIONS if name in section}
    return section.choice("model", MODELS, default="exact"), options


def _substrate(section: Section) -> Any:
    if "substrate" in section and isinstance(section.plain("substrate"), str):
        bases: dict[str, Any] = {"rigid": RIGID, "smooth": SMOOTH}
        bases.update((name, crystal.material) for name, crystal in CRYSTALS.items())
        return bases[section.choice("substrate", bases)]
    return read_material(section.child("substrate", MATERIAL))


def _film(section: Section) -> medium.Layer | tuple[Any, float]:
    film: tuple[Any, float] = read_material(section), section.quantity("thickness")
    if "prestress" not in section and "interface" not in section:
        return film
    with section.words():
        return medium.Layer(*film, section.quantity("prestress", 0.0), _interface(section) if "interface" in section else None)


def _interface(section: Section) -> Interface:
    """ "sliding", or a table of springs."""
    if isinstance(section.plain("interface"), str):
        section.choice("interface", ["sliding"])
        return SLIDING
    return section.child("interface", dimensions(Interface)).make(Interface)


def _surface(section: Section) -> medium.Surface | None:
    given = {key.removeprefix("surface_"): value for key, value in section.given(_SURFACE).items()}
    return medium.Surface(**given) if given else None


def _homogeneous(section: Section) -> medium.Medium:
    named = isinstance(section.plain("material"), str)
    body = _crystal(section, "material") if named else read_material(section.child("material", MATERIAL))
    return medium.Homogeneous(body, _surface(section))


def _coated(section: Section) -> medium.Medium:
    film = _film(section.child("coating", _FILM))
    model, options = _model(section)
    surface = _surface(section)
    if isinstance(film, medium.Layer):
        return medium.Layered([film], _substrate(section), model, surface=surface, **options)
    return medium.Coated(*film, _substrate(section), model, surface=surface, **options)


def _layered(section: Section) -> medium.Medium:
    layers = [_film(layer) for layer in section.children("layer", _FILM)]
    model, options = _model(section)
    return medium.Layered(layers, _substrate(section), model, surface=_surface(section), **options)


def _graded(section: Section) -> medium.Medium:
    nu = section.numbers("nu") if "nu" in section and isinstance(section.plain("nu"), list) else section.number("nu")
    model, options = _model(section)
    return medium.Graded(section.quantities("z"), section.quantities("E"), nu, model, **options)


_TYPES: Mapping[str, tuple[tuple[str, ...], Callable[[Section], medium.Medium]]] = {
    "coated": (("coating", "substrate", "model", *_SURFACE, *OPTIONS), _coated),
    "layered": (("layer", "substrate", "model", *_SURFACE, *OPTIONS), _layered),
    "graded": (("z", "E", "nu", "model", *OPTIONS), _graded),
    "power-law-graded": (("E0", "z0", "exponent", "nu"), lambda section: section.make(medium.PowerLawGraded)),
    "table": (("a", "moduli"), lambda section: section.make(medium.TabulatedMedium)),
    "homogeneous": (("material", *_SURFACE), _homogeneous),
}


def read_medium(section: Section, indenter: Section) -> medium.Medium:
    """The medium that [medium] describes, paired with the body of [indenter] where that is not rigid."""
    body = _read_body(section)
    upper: medium.Medium | None = None
    if "material" in indenter and "body" in indenter:
        raise ProblemError(f"[{indenter.path}]: material and body say the same thing twice: keep one")
    if "material" in indenter:
        upper = medium.Homogeneous(read_material(indenter.child("material", MATERIAL)))
    if "body" in indenter:
        upper = _read_body(indenter.child("body", KNOWN))
    if upper is None:
        return body
    with indenter.words():
        return medium.Pair(body, upper)


def _read_body(section: Section) -> medium.Medium:
    kind = section.choice("type", _TYPES)
    keys, build = _TYPES[kind]
    tables = [key for key in keys if key in _MATERIALS]
    for key in _FILM:
        if tables and key not in keys and key in section:
            raise ProblemError(f"[{section.path}]: {key} is not the medium's: write it in [{section.path}.{tables[0]}]")
    section.only(("type", *keys), f"a medium of type {kind!r}")
    with section.words():
        return build(section)
