# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [medium] of a problem file."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from .. import medium
from .._units import (
    AREA,
    BENDING,
    DIFFUSIVITY,
    LENGTH,
    MODULUS,
    MODULUS_PER_LENGTH,
    STRETCHING,
    SURFACE_TENSION,
    TIME,
    VISCOSITY,
    Dimension,
)
from ..conductor import SLIDING, Interface
from ..crystals import CRYSTALS
from ..material import RIGID, SMOOTH, Elastic, PowerLawRheology, TransverselyIsotropic, Viscoelastic
from ..medium.models import MODELS, OPTIONS
from ..poroelastic import Poroelastic
from .conductor import CONDUCTING, read_conductor
from .section import ProblemError, Section

MATERIAL: Mapping[str, Dimension | None] = {
    "E": MODULUS,
    "nu": None,
    "material": None,
    **dict.fromkeys(("C11", "C12", "C13", "C33", "C44", "E_t", "E_z", "G_z"), MODULUS),
    "nu_t": None,
    "nu_tz": None,
    "relaxed_shear_modulus": MODULUS,
    "moduli": MODULUS,
    "times": TIME,
    "bulk_modulus": MODULUS,
    "viscosity": VISCOSITY,
    "modulus": MODULUS,
    "time": TIME,
    "exponent": None,
    "shear_modulus": MODULUS,
    "diffusivity": DIFFUSIVITY,
    "permeability": AREA,
    **CONDUCTING,
}
_ELASTIC = ("E", "nu", *CONDUCTING)
_PRONY = ("relaxed_shear_modulus", "moduli", "times", "nu", "bulk_modulus", "viscosity")
_GEL = ("shear_modulus", "nu", "diffusivity")
_GEL_BY_FLOW = ("shear_modulus", "nu", "permeability", "viscosity")
_POWER_LAW = ("modulus", "time", "exponent", "nu")
_SURFACE: Mapping[str, Dimension | None] = {
    "surface_tension": SURFACE_TENSION,
    "surface_bending": BENDING,
    "surface_stretching": STRETCHING,
}
_STIFFNESSES = ("C11", "C12", "C13", "C33", "C44")
_ENGINEERING = ("E_t", "E_z", "nu_t", "nu_tz", "G_z")
_PLACE: Mapping[str, Dimension | None] = {"thickness": LENGTH, "prestress": MODULUS, "interface": None}
"""Keys of a layer beside those of its material."""
_SPRINGS: Mapping[str, Dimension | None] = {"normal": MODULUS_PER_LENGTH, "tangential": MODULUS_PER_LENGTH}
_FILM: Mapping[str, Dimension | None] = {**MATERIAL, **_PLACE}
_MATERIALS = ("material", "coating", "layer", "substrate")
"""Tables in that of a medium."""

KNOWN: Mapping[str, Dimension | None] = {
    "type": None,
    "model": None,
    **dict.fromkeys((*_MATERIALS, *OPTIONS)),
    **_SURFACE,
    "z": LENGTH,
    "E0": MODULUS,
    "z0": LENGTH,
    "a": LENGTH,
    **_FILM,
}


def read_material(section: Section) -> Elastic | TransverselyIsotropic | Viscoelastic | PowerLawRheology | Poroelastic:
    """The material of a table: E and nu of an elastic one, C11 to C44, or E_t, E_z, nu_t, nu_tz, G_z, or the name of a crystal as
    `material` of one with its axis along z, a Prony series with relaxed_shear_modulus, moduli and times, a power law
    with modulus, time and exponent, or a gel with shear_modulus, nu and diffusivity."""
    with section.words():
        if "diffusivity" in section or "permeability" in section:
            return _gel(section)
        if "exponent" in section:
            section.only((*_POWER_LAW, *_PLACE), "a power law, which has an exponent")
            return section.make(PowerLawRheology)
        if "relaxed_shear_modulus" in section:
            section.only((*_PRONY, *_PLACE), "a Prony series, which has a relaxed_shear_modulus")
            return _prony(section)
        if "material" in section:
            section.only(("material", *_PLACE), "a material with a name")
            return CRYSTALS[section.choice("material", CRYSTALS)].material
        if any(name in section for name in _STIFFNESSES):
            section.only((*_STIFFNESSES, *_PLACE), "a material with an axis, which has C11, C12, C13, C33, C44")
            return section.make(TransverselyIsotropic)
        if any(name in section for name in _ENGINEERING):
            section.only((*_ENGINEERING, *_PLACE), f"a material with an axis, which has {', '.join(_ENGINEERING)}")
            return section.make(TransverselyIsotropic.from_engineering)
        section.only((*_ELASTIC, *_PLACE), "an elastic material")
        return Elastic(section.quantity("E"), section.number("nu"), read_conductor(section))


def _gel(section: Section) -> Poroelastic:
    keys = _GEL if "diffusivity" in section else _GEL_BY_FLOW
    section.only((*keys, *_PLACE), f"a gel, which has {', '.join(keys)}")
    return section.make(Poroelastic if "diffusivity" in section else Poroelastic.from_permeability)


def _prony(section: Section) -> Viscoelastic:
    moduli = section.quantities("moduli") if "moduli" in section else []
    times = section.quantities("times") if "times" in section else []
    if len(moduli) != len(times):
        raise ProblemError(f"[{section.path}]: moduli has {len(moduli)} and times has {len(times)} entries: give as many of both")
    terms = list(zip(moduli, times, strict=True))
    viscosity = section.quantity("viscosity") if "viscosity" in section else 0.0
    relaxed = section.quantity("relaxed_shear_modulus")
    nu = section.number("nu") if "nu" in section else None
    bulk = section.quantity("bulk_modulus") if "bulk_modulus" in section else None
    return Viscoelastic(relaxed, terms, nu, bulk, viscosity)


def _model(section: Section) -> tuple[str, dict[str, Any]]:
    options = {name: section.plain(name) for name in OPTIONS if name in section}
    return section.choice("model", MODELS, default="exact"), options


def _substrate(section: Section) -> Any:
    if "substrate" in section and isinstance(section.plain("substrate"), str):
        bases: dict[str, Any] = {"rigid": RIGID, "smooth": SMOOTH}
        bases.update((name, crystal.material) for name, crystal in CRYSTALS.items())
        return bases[section.choice("substrate", bases)]
    return read_material(section.child("substrate", MATERIAL))


def _named_or_table(section: Section, key: str) -> Any:
    """A material by the name of a crystal, or by a table."""
    if isinstance(section.plain(key), str):
        return CRYSTALS[section.choice(key, CRYSTALS)].material
    return read_material(section.child(key, MATERIAL))


def _film(section: Section) -> medium.Layer | tuple[Any, float]:
    film: tuple[Any, float] = read_material(section), section.quantity("thickness")
    if "prestress" not in section and "interface" not in section:
        return film
    stress = section.quantity("prestress") if "prestress" in section else 0.0
    with section.words():
        return medium.Layer(*film, stress, _interface(section) if "interface" in section else None)


def _interface(section: Section) -> Interface:
    """ "sliding", or a table of springs."""
    if isinstance(section.plain("interface"), str):
        section.choice("interface", ["sliding"])
        return SLIDING
    return section.child("interface", _SPRINGS).make(Interface)


def _surface(section: Section) -> medium.Surface | None:
    given = {key.removeprefix("surface_"): section.quantity(key) for key in _SURFACE if key in section}
    return medium.Surface(**given) if given else None


def _homogeneous(section: Section) -> medium.Medium:
    return medium.Homogeneous(_named_or_table(section, "material"), _surface(section))


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


def _table(section: Section) -> medium.Medium:
    return medium.TabulatedMedium(section.quantities("a"), section.quantities("moduli"))


_TYPES: Mapping[str, tuple[tuple[str, ...], Callable[[Section], medium.Medium]]] = {
    "coated": (("coating", "substrate", "model", *_SURFACE, *OPTIONS), _coated),
    "layered": (("layer", "substrate", "model", *_SURFACE, *OPTIONS), _layered),
    "graded": (("z", "E", "nu", "model", *OPTIONS), _graded),
    "power-law-graded": (("E0", "z0", "exponent", "nu"), lambda section: section.make(medium.PowerLawGraded)),
    "table": (("a", "moduli"), _table),
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
