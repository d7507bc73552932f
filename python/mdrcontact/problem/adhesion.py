# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [adhesion] of a problem file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from ..adhesion import CONTROLS, RULES
from .section import ProblemError, Section
from .units import MODULUS, STIFFNESS, WORK_OF_ADHESION, Dimension

KNOWN: Mapping[str, Dimension | None] = {
    "work_of_adhesion": WORK_OF_ADHESION,
    "cohesive_stress": MODULUS,
    "adhesion_rule": None,
    "control": None,
    "spring_stiffness": STIFFNESS,
}


class Adhesion(NamedTuple):
    """Work of adhesion, cohesive stress, rule of the edge, and what the machine prescribes in a loop; SI units."""

    work_of_adhesion: float
    cohesive_stress: float
    adhesion_rule: str
    control: str
    spring_stiffness: float | None


def read_adhesion(section: Section) -> Adhesion:
    """What [adhesion] says; without a control a given spring means "spring", none means "depth"."""
    has_spring = "spring_stiffness" in section
    control = section.choice("control", CONTROLS, default="spring" if has_spring else "depth")
    if has_spring and control != "spring":
        raise ProblemError(f'[{section.path}]: spring_stiffness belongs to control = "spring", not to {control!r}')
    spring = section.quantity("spring_stiffness") if control == "spring" else None
    rule = section.choice("adhesion_rule", RULES, default="automatic")
    stress = section.positive("cohesive_stress", zero=True) if "cohesive_stress" in section else 0.0
    return Adhesion(section.positive("work_of_adhesion", zero=True), stress, rule, control, spring)
