# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [adhesion] of a problem file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from .._units import MODULUS, STIFFNESS, WORK_OF_ADHESION, Dimension, dimensions
from ..adhesion import CONTROLS, RULES
from ..rate_adhesion import RateAdhesion
from .section import ProblemError, Section

_RATE = {name: dimension for name, dimension in dimensions(RateAdhesion).items() if name != "work"}

KNOWN: Mapping[str, Dimension | None] = {
    "work_of_adhesion": WORK_OF_ADHESION,
    "cohesive_stress": MODULUS,
    "adhesion_rule": None,
    "control": None,
    "spring_stiffness": STIFFNESS,
    **_RATE,
}


class Adhesion(NamedTuple):
    """Work of adhesion, cohesive stress, rule of the edge, and what the machine prescribes in a loop; SI units."""

    work_of_adhesion: float
    cohesive_stress: float
    adhesion_rule: str
    control: str
    spring_stiffness: float | None
    rate: RateAdhesion | None = None
    """where the work of adhesion depends on the speed of the edge"""


def read_adhesion(section: Section) -> Adhesion:
    """What [adhesion] says; without a control a given spring means "spring", none means "depth"."""
    has_spring = "spring_stiffness" in section
    control = section.choice("control", CONTROLS, default="spring" if has_spring else "depth")
    if has_spring and control != "spring":
        raise ProblemError(f'[{section.path}]: spring_stiffness belongs to control = "spring", not to {control!r}')
    spring = section.quantity("spring_stiffness") if control == "spring" else None
    rule = section.choice("adhesion_rule", RULES, default="automatic")
    stress = section.positive("cohesive_stress", zero=True) if "cohesive_stress" in section else 0.0
    work = section.positive("work_of_adhesion", zero=True)
    return Adhesion(work, stress, rule, control, spring, _read_rate(section, work))


def _read_rate(section: Section, work: float) -> RateAdhesion | None:
    """The work of adhesion over the speed of the edge, if the file has a speed."""
    given = section.given(_RATE)
    if not given:
        return None
    for key in ("speed", "exponent"):
        if key not in given:
            raise ProblemError(f"[{section.path}]: {key} is missing: {[*given][0]} makes the work of adhesion depend on speed")
    with section.words():
        return RateAdhesion(work, **given)
