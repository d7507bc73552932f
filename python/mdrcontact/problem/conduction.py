# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [conduction] of a problem file: resistances, and the heat of friction. Materials have the conductivities."""

from __future__ import annotations

from typing import Any, NamedTuple

from .._units import AREA_RESISTANCE, LENGTH, MODULUS, RATIO, SPEED, THERMAL_AREA_RESISTANCE, THERMAL_CONDUCTIVITY
from ..conduction import Conduction, RoughJoint
from ..conduction.bodies import conducting
from ..medium import Pair
from .field import NOT_NEGATIVE, POSITIVE, Field, Table
from .section import ProblemError, Section

THERMAL, ELECTRICAL = "thermal", "electrical"

_FILM, _INTERFACES = "resistance in the contact area", "resistance below each layer, top to bottom"
_CURRENT, _HEAT = {"kind": (ELECTRICAL,)}, {"kind": (THERMAL,)}
JOINT = Table(
    "rough surfaces in the contact area, which touch at plastic micro-contacts",
    (
        Field("roughness", "root mean square of the heights of both surfaces together", LENGTH, range=POSITIVE),
        Field("slope", "mean absolute slope of both surfaces together", RATIO, range=POSITIVE),
        Field("hardness", "hardness of the softer surface", MODULUS, range=POSITIVE),
        Field(
            "gas",
            "conductivity of the gas between the surfaces, for heat; 0: a vacuum",
            THERMAL_CONDUCTIVITY,
            0.0,
            range=NOT_NEGATIVE,
        ),
        Field("jump", "sum of the temperature jump lengths of both surfaces; needs gas", LENGTH, 0.0, range=NOT_NEGATIVE),
    ),
    "docs/conduction.md",
)
KNOWN = Table(
    "conduction of heat or current; each material needs a conductivity",
    (
        Field("kind", "heat or current", choices=(THERMAL, ELECTRICAL)),
        Field("film", _FILM, AREA_RESISTANCE, 0.0, range=NOT_NEGATIVE, when=_CURRENT),
        Field("interfaces", _INTERFACES, AREA_RESISTANCE, optional=True, range=NOT_NEGATIVE, when=_CURRENT, many=True),
        Field("thermal_film", _FILM, THERMAL_AREA_RESISTANCE, 0.0, range=NOT_NEGATIVE, when=_HEAT),
        Field("thermal_interfaces", _INTERFACES, THERMAL_AREA_RESISTANCE, optional=True, range=NOT_NEGATIVE, when=_HEAT, many=True),
        Field(
            "friction_coefficient",
            "coefficient of friction, for the heat of friction; needs speed",
            RATIO,
            optional=True,
            when=_HEAT,
        ),
        Field("speed", "sliding speed; needs friction_coefficient", SPEED, optional=True, when=_HEAT),
        Field("joint", JOINT.meaning, optional=True, table=JOINT),
    ),
    "docs/conduction.md",
    at_most_one_of=(("film", "joint"), ("thermal_film", "joint")),
)


class Conducting(NamedTuple):
    """The contents of [conduction]."""

    kind: str
    """ "thermal" or "electrical" """
    film: float
    interfaces: tuple[float, ...]
    """below each layer of the lower body, top to bottom"""
    heat: tuple[float, float] | None
    """friction coefficient and speed"""
    joint: RoughJoint | None = None
    """rough surfaces in the contact area, instead of a film"""

    @property
    def prefix(self) -> str:
        """Return the begin of the keys of resistances of this kind."""
        return "thermal_" if self.kind == THERMAL else ""

    def conduction(self, medium: Any) -> Conduction:
        """Return the conduction between the bodies of a medium."""
        lower, upper = (medium.lower, medium.upper) if isinstance(medium, Pair) else (medium, None)
        return Conduction(self._with_interfaces(lower), upper, self.film)

    def _with_interfaces(self, body: Any) -> Any:
        layers = len(body._stack())
        if len(self.interfaces) > layers:
            rule = f"interfaces has {len(self.interfaces)} entries for {layers} layers"
            raise ProblemError(rule, "Give at most one for each layer", table="conduction", key=f"{self.prefix}interfaces")
        return conducting(body)._with_resistances(self.interfaces) if self.interfaces else body


def check_kind(kind: str, table: Any, path: str) -> None:
    """Raise an error for materials with the other kind of conductivity."""
    other = ELECTRICAL if kind == THERMAL else THERMAL
    for key, value in table.items() if isinstance(table, dict) else ():
        if key.startswith(f"{other}_conductivity"):
            rule = f'{key} does not belong to [conduction] kind = "{kind}"'
            raise ProblemError(rule, f"Give {kind}_conductivity", table=path, key=key)
        for i, one in enumerate(value if isinstance(value, list) else [value], start=1):
            check_kind(kind, one, f"{path}.{key}{f' {i}' if isinstance(value, list) else ''}")


def read_conduction(section: Section) -> Conducting:
    """Return the contents of [conduction]."""
    kind = section.value("kind")
    prefix, other = ("thermal_", "") if kind == THERMAL else ("", "thermal_")
    for key in ("film", "interfaces"):
        if f"{other}{key}" in section:
            rule = f"{other}{key} does not belong to kind = {kind!r}"
            raise section.error(f"{other}{key}", rule, f"Write {prefix}{key}", shows=False)
    film = section.quantity(f"{prefix}film", 0.0)
    interfaces = tuple(section.quantities(f"{prefix}interfaces")) if f"{prefix}interfaces" in section else ()
    heat = None
    if "speed" in section or "friction_coefficient" in section:
        if kind != THERMAL:
            key = "speed" if "speed" in section else "friction_coefficient"
            rule = 'speed and friction_coefficient do not belong to kind = "electrical"'
            raise section.error(key, rule, "Leave them out", shows=False)
        heat = section.number("friction_coefficient"), section.quantity("speed")
    joint = _read_joint(section, kind) if "joint" in section else None
    if joint and film:
        raise section.error(f"{prefix}film", f"{prefix}film and joint exclude each other", "Keep one", shows=False)
    if joint and heat:
        raise section.error("speed", "heat of friction between rough surfaces is not supported", "Leave joint out", shows=False)
    return Conducting(kind, film, interfaces, heat, joint)


def _read_joint(section: Section, kind: str) -> RoughJoint:
    """Return the rough surfaces of [conduction.joint]."""
    given: Section = section.value("joint")
    with given.words():
        joint = RoughJoint(*(given.value(one.name) for one in JOINT.fields))
    if joint.gas and kind == ELECTRICAL:
        raise given.error("gas", 'gases conduct heat alone, and kind is "electrical"', "Leave it out")
    return joint
