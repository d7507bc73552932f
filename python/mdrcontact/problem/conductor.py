# SPDX-License-Identifier: GPL-3.0-or-later
"""Conductivities in the tables of materials."""

from __future__ import annotations

from collections.abc import Mapping

from .._units import ELECTRICAL_CONDUCTIVITY, HEAT_CAPACITY, THERMAL_CONDUCTIVITY, Dimension
from ..conductor import Conductor
from .section import ProblemError, Section

THERMAL, ELECTRICAL = "thermal", "electrical"
CONDUCTING: Mapping[str, Dimension | None] = {
    "thermal_conductivity": THERMAL_CONDUCTIVITY,
    "thermal_conductivity_along": THERMAL_CONDUCTIVITY,
    "electrical_conductivity": ELECTRICAL_CONDUCTIVITY,
    "electrical_conductivity_along": ELECTRICAL_CONDUCTIVITY,
    "heat_capacity": HEAT_CAPACITY,
}
"""Keys of materials."""


def read_conductor(section: Section) -> Conductor | None:
    """The conductor of a material's table, if it has one."""
    kinds = [kind for kind in (THERMAL, ELECTRICAL) if f"{kind}_conductivity" in section]
    if not kinds:
        return None
    if len(kinds) == 2:
        raise ProblemError(
            f"[{section.path}]: give thermal_conductivity or electrical_conductivity: one problem conducts one of them"
        )
    name = f"{kinds[0]}_conductivity"
    along = section.quantity(f"{name}_along") if f"{name}_along" in section else None
    capacity = section.quantity("heat_capacity") if "heat_capacity" in section else 0.0
    return Conductor(section.quantity(name), along, capacity)
