# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [medium] of a problem file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .. import medium
from .._units import (
    AREA,
    ELECTRICAL_CONDUCTIVITY,
    HEAT_CAPACITY,
    LENGTH,
    MODULUS,
    MODULUS_PER_LENGTH,
    RATIO,
    THERMAL_CONDUCTIVITY,
    TIME,
    Dimension,
    dimensions,
)
from ..crystals import CRYSTALS
from ..errors import InvalidArgumentError
from ..material import _ENGINEERING, RIGID, SMOOTH, Conductor, Elastic, PowerLawRheology, TransverselyIsotropic, Viscoelastic
from ..medium.layer import SLIDING, Interface
from ..medium.models import _WEIGHT_NU, MODELS, OPTIONS
from ..poroelastic import Poroelastic
from .field import NOT_NEGATIVE, POISSON, POSITIVE, Field, Range, Table, arguments
from .section import Section

if TYPE_CHECKING:
    from ..plastic import YieldStress


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
        raise InvalidArgumentError("thermal_conductivity and electrical_conductivity exclude each other. Keep one.")
    for name, (into, along) in (("thermal_conductivity", thermal), ("electrical_conductivity", electrical)):
        if along is not None and into is None:
            raise InvalidArgumentError(f"{name}_along needs {name}. Give both.")
    sigma, along = thermal if electrical[0] is None else electrical
    if sigma is not None:
        return Elastic(E, nu, Conductor(sigma, along, heat_capacity or 0.0))
    if heat_capacity is not None:
        raise InvalidArgumentError("heat_capacity needs thermal_conductivity or electrical_conductivity. Give one of them.")
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
        raise InvalidArgumentError(f"moduli has {len(moduli)} and times has {len(times)} entries. Give the same number of both.")
    return Viscoelastic(relaxed_shear_modulus, zip(moduli, times, strict=True), nu, bulk_modulus, viscosity)


_KINDS: Mapping[str, tuple[str, Callable[..., Any], Iterable[str]]] = {
    "elastic": ("an elastic material", _elastic, ()),
    "gel": ("a gel", Poroelastic, ("diffusivity",)),
    "gel by permeability": ("a gel", Poroelastic.from_permeability, ("permeability",)),
    "power law": ("a power law", PowerLawRheology, ("exponent",)),
    "Prony series": ("a Prony series", _prony, ("relaxed_shear_modulus",)),
    "axis": ("a material with an axis", TransverselyIsotropic, dimensions(TransverselyIsotropic)),
    "axis by engineering constants": ("a material with an axis", TransverselyIsotropic.from_engineering, _ENGINEERING),
}
"""By kind: its name, its constructor, and keys that no later kind has. Without any of these keys a material is elastic."""
_MATERIAL_DIMENSIONS: Mapping[str, Dimension] = {
    **dimensions(Elastic, TransverselyIsotropic, Viscoelastic, PowerLawRheology, Poroelastic),
    **_ENGINEERING,
    **{"moduli": MODULUS, "times": TIME, "permeability": AREA, "heat_capacity": HEAT_CAPACITY},
    **dict.fromkeys(("thermal_conductivity", "thermal_conductivity_along"), THERMAL_CONDUCTIVITY),
    **dict.fromkeys(("electrical_conductivity", "electrical_conductivity_along"), ELECTRICAL_CONDUCTIVITY),
}
_CRYSTALS = tuple(CRYSTALS)
_CONSTANTS = (
    Field("E", "Young's modulus", range=POSITIVE),
    Field("nu", "Poisson's ratio; of a gel that of the drained body", range=POISSON),
    Field("C11", "stiffness in the plane", range=POSITIVE),
    Field("C12", "stiffness between both directions in the plane"),
    Field("C13", "stiffness between plane and axis"),
    Field("C33", "stiffness along the axis z", range=POSITIVE),
    Field("C44", "shear modulus of planes that contain z", range=POSITIVE),
    Field("E_t", "Young's modulus in the plane", range=POSITIVE),
    Field("E_z", "Young's modulus along the axis z", range=POSITIVE),
    Field("nu_t", "Poisson's ratio in the plane", range=Range(-1.0, 1.0)),
    Field("nu_tz", "contraction along z over strain in the plane"),
    Field("G_z", "shear modulus of planes that contain z", range=POSITIVE),
    Field("relaxed_shear_modulus", "shear modulus after a long time; 0: a fluid", range=NOT_NEGATIVE),
    Field("bulk_modulus", "bulk modulus, which does not relax", range=POSITIVE),
    Field("viscosity", "viscosity of a dashpot in parallel, or of the fluid of a gel", range=NOT_NEGATIVE),
    Field("modulus", "shear modulus at time", range=POSITIVE),
    Field("time", "time at which modulus is given", range=POSITIVE),
    Field("exponent", "n of the shear modulus (t/time)^-n", range=Range(0.0, 1.0)),
    Field("shear_modulus", "shear modulus", range=POSITIVE),
    Field("diffusivity", "diffusivity of the fluid", range=POSITIVE),
    Field("material", "crystal with its axis along z, instead of constants", optional=True, choices=_CRYSTALS),
    Field("moduli", "shear moduli that relax", range=POSITIVE),
    Field("times", "relaxation times, one for each modulus", range=POSITIVE),
    Field("permeability", "hydraulic permeability", range=POSITIVE),
    Field("thermal_conductivity", "thermal conductivity into the body", range=POSITIVE),
    Field("thermal_conductivity_along", "conductivity along the surface; default: isotropic", range=POSITIVE),
    Field("electrical_conductivity", "electrical conductivity into the body", range=POSITIVE),
    Field("electrical_conductivity_along", "conductivity along the surface; default: isotropic", range=POSITIVE),
    Field("heat_capacity", "heat capacity per volume", range=NOT_NEGATIVE),
)
_STRESS, _HARDNESS, _RATIO = "yield_stress", "hardness", "radius_ratio"
_ISOTROPIC = {"": ("elastic",)}
_YIELD = (
    Field(
        _STRESS,
        "yield stress, for imprints and fits of unloading; default: none, it does not yield",
        MODULUS,
        optional=True,
        range=POSITIVE,
        when={"": ("elastic", "axis", "axis by engineering constants")},
    ),
    Field(
        _HARDNESS,
        "hardness, instead of yield_stress: that is hardness/2.8 with an error of 8 %",
        MODULUS,
        optional=True,
        range=POSITIVE,
        when=_ISOTROPIC,
    ),
    Field(
        _RATIO,
        "contact radius over radius of the sphere that gave hardness; yield_stress is then that of first loading",
        RATIO,
        optional=True,
        range=Range(0.0, 0.3, has_largest=True),
        when={_HARDNESS: ()},
    ),
)
"""Keys of a material that yields."""
MATERIAL = Table(
    "constants of a material, or its name",
    (*arguments({kind: call for kind, (_, call, _) in _KINDS.items()}, "", _MATERIAL_DIMENSIONS, _CONSTANTS), *_YIELD),
    "docs/media.md",
    one_of=(("nu", "bulk_modulus"),),
    at_most_one_of=(("thermal_conductivity", "electrical_conductivity"), (_STRESS, _HARDNESS)),
)

_INTERFACE = Table(
    "a compliant interface below a layer",
    (
        Field("normal", "normal stiffness per area", MODULUS_PER_LENGTH, optional=True, range=POSITIVE),
        Field("tangential", "tangential stiffness per area; 0: sliding", MODULUS_PER_LENGTH, optional=True, range=NOT_NEGATIVE),
    ),
    "docs/coatings.md",
)
_PLACE = (
    Field("thickness", "thickness", LENGTH, range=POSITIVE),
    Field("prestress", "equibiaxial stress in the plane; positive: tension", MODULUS, optional=True),
    Field("interface", "interface below the layer; default: bonded", optional=True, choices=("sliding",), table=_INTERFACE),
)
_ALONE = tuple(one.name for one in _PLACE)
"""Keys of a layer that do not belong to its material."""
LAYER = Table(
    "a layer", (*MATERIAL.fields, *_PLACE), "docs/coatings.md", MATERIAL.one_of, MATERIAL.at_most_one_of, extends=MATERIAL
)


def read_material(section: Section) -> Any:
    """Return the material of a table: a crystal by its name, with its axis along z, or a material by its constants."""
    if "material" in section:
        section.only(("material", *_ALONE), "a material with a name")
        return CRYSTALS[section.value("material")].material
    kind = next((kind for kind, one in _KINDS.items() if any(key in section for key in one[2])), "elastic")
    what, call, own = _KINDS[kind]
    keys = f", which has {', '.join(section.arguments(call))}" if own else ""
    yields = [one.name for one in _YIELD if kind in one.when.get("", _ISOTROPIC[""])]
    return section.make(call, what + keys, (*_ALONE, *yields))


def read_indenter_material(section: Section) -> Any:
    """Return the material of an indenter, which does not yield."""
    for one in _YIELD:
        if one.name in section:
            raise section.error(one.name, "the indenter must not yield", "Leave it out")
    return read_material(section)


def _model(section: Section) -> tuple[str, dict[str, Any]]:
    options = {name: section.plain(name) for name in OPTIONS if name in section}
    return section.value("model"), options


def _substrate(section: Section) -> Any:
    found = section.value("substrate")
    return _BASES[found] if isinstance(found, str) else read_material(found)


def _film(section: Section) -> medium.Layer | tuple[Any, float]:
    film: tuple[Any, float] = read_material(section), section.quantity("thickness")
    if "prestress" not in section and "interface" not in section:
        return film
    with section.words():
        prestress, found = section.value("prestress"), section.value("interface")
        interface = found.make(Interface) if isinstance(found, Section) else SLIDING if found else None
        return medium.Layer(*film, prestress or 0.0, interface)


def _surface(section: Section) -> medium.Surface | None:
    given = {key.removeprefix("surface_"): value for key, value in section.given(one.name for one in _SURFACE).items()}
    return medium.Surface(**given) if given else None


def _homogeneous(section: Section) -> medium.Medium:
    section.plain("material")  # an error if it is missing
    found = section.value("material")
    return medium.Homogeneous(CRYSTALS[found].material if isinstance(found, str) else read_material(found), _surface(section))


def _coated(section: Section) -> medium.Medium:
    film = _film(section.value("coating"))
    model, options = _model(section)
    surface = _surface(section)
    if isinstance(film, medium.Layer):
        return medium.Layered([film], _substrate(section), model, surface=surface, **options)
    return medium.Coated(*film, _substrate(section), model, surface=surface, **options)


def _layered(section: Section) -> medium.Medium:
    layers = [_film(layer) for layer in section.value("layer")]
    model, options = _model(section)
    return medium.Layered(layers, _substrate(section), model, surface=_surface(section), **options)


def _graded(section: Section) -> medium.Medium:
    nu = section.numbers("nu") if "nu" in section and isinstance(section.plain("nu"), list) else section.number("nu")
    model, options = _model(section)
    return medium.Graded(section.quantities("z"), section.quantities("E"), nu, model, **options)


_TYPES: Mapping[str, Callable[[Section], medium.Medium]] = {
    "coated": _coated,
    "layered": _layered,
    "graded": _graded,
    "power-law-graded": lambda section: section.make(medium.PowerLawGraded),
    "table": lambda section: section.make(medium.TabulatedMedium),
    "homogeneous": _homogeneous,
}
_LAYERED, _UNDER_MODEL, _WITH_SURFACE = (
    {"type": types} for types in (("coated", "layered"), ("coated", "layered", "graded"), ("coated", "layered", "homogeneous"))
)
_BASES: Mapping[str, Any] = {"rigid": RIGID, "smooth": SMOOTH, **{name: crystal.material for name, crystal in CRYSTALS.items()}}
_MEANINGS = {
    "alpha": "factor of the exponent of the weight",
    "exponent": "exponent of the mean of the moduli",
    "tolerance": "relative tolerance of the solution; default: 1e-10",
    "wave_factor": "factor of the contact radius in the wave",
    "weight_nu": "Poisson's ratio of the weight, a number or a word",
}


def _option(name: str) -> Field:
    models = {word: model for word, model in MODELS.items() if name in model.options}
    default = next((model.default_constant for model in models.values() if model.constant == name), None)
    words = tuple(_WEIGHT_NU) if name == "weight_nu" else ()
    return Field(
        name, _MEANINGS[name], RATIO, default, True, words, when={"model": tuple(models)}, example="1e-8" * (name == "tolerance")
    )


_SURFACE = tuple(
    Field(f"surface_{name}", meaning, dimensions(medium.Surface)[name], 0.0, when=_WITH_SURFACE)
    for name, meaning in {
        "tension": "surface tension",
        "bending": "bending stiffness of a plate that slides freely on the surface",
        "stretching": "stiffness in the plane of a sheet bonded to the surface",
    }.items()
)
_GRADIENTS = {"graded": medium.Graded, "power-law-graded": medium.PowerLawGraded, "table": medium.TabulatedMedium}
_OF_GRADIENTS = (
    Field("z", "depths, from 0, ascending"),
    Field("E", "Young's moduli at these depths", range=POSITIVE),
    Field("nu", "Poisson's ratio; of a graded medium one number or one for each depth", range=POISSON),
    Field("E0", "Young's modulus at depth z0", range=POSITIVE),
    Field("z0", "reference depth", range=POSITIVE),
    Field("exponent", "m of E = E0 (z/z0)^m", range=Range(-1.0, 1.0)),
    Field("a", "contact radii, ascending, at least three", range=POSITIVE),
    Field("moduli", "effective contact moduli at these radii", range=POSITIVE),
)
KNOWN = Table(
    "the body that is indented",
    (
        Field("type", "type of the medium", choices=tuple(_TYPES)),
        Field("model", "model of the effective modulus", default="exact", choices=tuple(MODELS), when=_UNDER_MODEL),
        Field("material", "material of the half-space", choices=_CRYSTALS, table=MATERIAL, when={"type": ("homogeneous",)}),
        Field("coating", "the coating", table=LAYER, when={"type": ("coated",)}),
        Field("layer", "layers, top to bottom", table=LAYER, many=True, when={"type": ("layered",)}),
        Field("substrate", "body below the layers", choices=tuple(_BASES), table=MATERIAL, when=_LAYERED),
        *map(_option, OPTIONS),
        *_SURFACE,
        *arguments(_GRADIENTS, "type", dimensions(*_GRADIENTS.values()), _OF_GRADIENTS),
    ),
    "docs/media.md",
    inner=LAYER,
)


def read_medium(section: Section, indenter: Section) -> medium.Medium:
    """Return the medium that [medium] describes, paired with the body of [indenter] if that is not rigid."""
    body = _read_body(section)
    upper: medium.Medium | None = None
    if "material" in indenter and "body" in indenter:
        raise indenter.error("body", "material and body exclude each other", "Keep one", shows=False)
    if "material" in indenter:
        upper = medium.Homogeneous(read_indenter_material(indenter.value("material")))
    if "body" in indenter:
        upper = _read_body(indenter.value("body"))
        if read_yield_stresses(indenter.value("body")):
            raise indenter.error("body", "the indenter must not yield", "Leave its yield stresses out", shows=False)
    if upper is None:
        return body
    with indenter.words():
        return medium.Pair(body, upper)


def _read_body(section: Section) -> medium.Medium:
    kind = section.value("type")
    keys = KNOWN.keys_of("type", kind)
    tables = [key for key in keys if KNOWN.field(key).table is not None]
    for key in LAYER:
        if tables and key not in keys and key in section:
            remedy = f"Write it in [{section.path}.{tables[0]}]"
            raise section.error(key, f"{key} is a key of another table", remedy, shows=False)
    section.only(keys, f"a medium of type {kind!r}")
    with section.words():
        return _TYPES[kind](section)


_STRATA = {"homogeneous": ("material",), "coated": ("coating", "substrate"), "layered": ("layer", "substrate")}
"""By type of the medium: its tables of materials, top to bottom."""


def read_yield_stresses(section: Section) -> tuple[YieldStress | None, ...]:
    """Return the yield stress of each layer and the substrate, top to bottom, None for what does not yield; () without any."""
    tables: list[Any] = []
    for key in _STRATA.get(section.value("type"), ()):
        found = section.value(key)
        tables += found if isinstance(found, list) else [found]
    stresses = tuple(_yield_stress(one) if isinstance(one, Section) else None for one in tables)
    return stresses if any(stress is not None for stress in stresses) else ()


def _yield_stress(section: Section) -> YieldStress | None:
    """Return the yield stress of a material, given or from its hardness; None: it does not yield."""
    from ..plastic import YieldStress, yield_stress_from_hardness

    if _STRESS in section and _HARDNESS in section:
        raise section.error(_HARDNESS, "yield_stress and hardness exclude each other", "Keep one", shows=False)
    if _HARDNESS in section:
        with section.words():
            ratio = section.value(_RATIO)
            return yield_stress_from_hardness(read_material(section), section.value(_HARDNESS), ratio)
    if _RATIO in section:
        raise section.error(_RATIO, "radius_ratio needs hardness", "Give both, or leave it out", shows=False)
    return YieldStress(section.value(_STRESS), 0.0) if _STRESS in section else None
