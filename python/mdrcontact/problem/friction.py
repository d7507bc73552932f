# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [friction] of a problem file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from .section import ProblemError, Section
from .units import FORCE, LENGTH, Dimension

KNOWN: Mapping[str, Dimension | None] = {"coefficient": None, "shifts": LENGTH, "tangential_forces": FORCE}


class Sliding(NamedTuple):
    """Coefficient of friction, and the amplitudes of cycles; SI units."""

    coefficient: float
    control: str
    """"shift" or "force": what the amplitudes are"""
    amplitudes: tuple[float, ...]
    """ascending; empty if the file gives none"""


def read_friction(section: Section) -> Sliding:
    """What [friction] says."""
    coefficient = section.number("coefficient")
    given = [key for key in ("shifts", "tangential_forces") if key in section]
    if len(given) > 1:
        raise ProblemError(f"[{section.path}]: give amplitudes as shifts or as tangential_forces, not as both")
    if not coefficient > 0.0:
        raise ProblemError(f"[{section.path}]: coefficient = {coefficient!r} is not allowed: it must be greater than 0")
    if not given:
        return Sliding(coefficient, "shift", ())
    amplitudes = section.quantities(given[0])
    if not amplitudes or amplitudes[0] <= 0.0 or any(b <= a for a, b in zip(amplitudes, amplitudes[1:], strict=False)):
        raise ProblemError(f"[{section.path}]: {given[0]} must be an ascending list with at least one value, all greater than 0")
    return Sliding(coefficient, "shift" if given[0] == "shifts" else "force", tuple(amplitudes))
