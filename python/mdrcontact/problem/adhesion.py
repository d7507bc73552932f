# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [adhesion] of a problem file."""

from __future__ import annotations

from typing import NamedTuple

from .._units import MODULUS, STIFFNESS, WORK_OF_ADHESION, dimensions
from ..adhesion import RateAdhesion
from ..loop import CONTROLS, RULES
from .field import NOT_NEGATIVE, Field, Table
from .section import Section

_RATE = tuple(
    Field(name, meaning, dimensions(RateAdhesion)[name], optional=name != "exponent", when={} if name == "speed" else {"speed": ()})
    for name, meaning in {
        "speed": "speed of the edge at which the work of adhesion is twice that at rest; for mdrcontact history",
        "exponent": "n of the work of an opening edge, work_of_adhesion (1 + (v/speed)^n)",
        "closing_work": "work of a closing edge at rest; default: work_of_adhesion",
        "closing_speed": "speed of a closing edge; default: speed",
        "closing_exponent": "exponent of a closing edge; default: exponent",
    }.items()
)

KNOWN = Table(
    "adhesion of the bodies",
    (
        Field("work_of_adhesion", "work of adhesion", WORK_OF_ADHESION, range=NOT_NEGATIVE),
        Field("cohesive_stress", "cohesive stress of finite-range adhesion; 0: JKR limit", MODULUS, 0.0, range=NOT_NEGATIVE),
        Field("adhesion_rule", "critical elongation at the edge", default="automatic", choices=tuple(RULES)),
        Field(
            "control",
            "prescribed quantity of a loop; with spring_stiffness the default is spring",
            None,
            "depth",
            choices=tuple(CONTROLS),
        ),
        Field("spring_stiffness", "stiffness of a spring such as a cantilever", STIFFNESS, when={"control": ("spring",)}),
        *_RATE,
    ),
    "docs/adhesion.md",
)


class Adhesion(NamedTuple):
    """Work of adhesion, cohesive stress, rule of the edge, and the prescribed quantity of a loop; SI units."""

    work_of_adhesion: float
    cohesive_stress: float
    adhesion_rule: str
    control: str
    spring_stiffness: float | None
    rate: RateAdhesion | None = None
    """None: the work of adhesion does not depend on the speed of the edge"""


def read_adhesion(section: Section) -> Adhesion:
    """Return the contents of [adhesion]. The default of control is "spring" with a spring_stiffness, "depth" without."""
    has_spring = "spring_stiffness" in section
    control = "spring" if has_spring and "control" not in section else section.value("control")
    if has_spring and control != "spring":
        raise section.error("control", 'spring_stiffness needs control = "spring"', "Keep one of them")
    spring = section.value("spring_stiffness") if control == "spring" else None
    rule, stress, work = (section.value(key) for key in ("adhesion_rule", "cohesive_stress", "work_of_adhesion"))
    return Adhesion(work, stress, rule, control, spring, _read_rate(section, work))


def _read_rate(section: Section, work: float) -> RateAdhesion | None:
    """Return the work of adhesion as a function of the speed of the edge, if the file has a speed."""
    given = section.given(one.name for one in _RATE)
    if not given:
        return None
    for key in ("speed", "exponent"):
        if key not in given:
            raise section.error(key, f"{[*given][0]} needs the key {key!r}", "Give both, or leave both out", shows=False)
    with section.words(work="work_of_adhesion"):
        return RateAdhesion(work, **given)
