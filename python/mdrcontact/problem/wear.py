# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [wear] of a problem file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from .._units import LENGTH, WEAR, Dimension
from ..wear import SCHEMES
from .section import ProblemError, Section

KNOWN: Mapping[str, Dimension | None] = {
    "coefficient": WEAR,
    "sliding": LENGTH,
    "intervals": None,
    "scheme": None,
}

_USUAL_INTERVALS, _FEWEST_INTERVALS, _MOST_INTERVALS = 80, 16, 640


class Rubbing(NamedTuple):
    """A sliding indenter that wears; SI units."""

    coefficient: float
    """k [1/Pa], m^3/(N m)"""
    sliding: tuple[float, ...]
    """ascending distances"""
    intervals: int
    scheme: str


def read_wear(section: Section) -> Rubbing:
    """What [wear] says."""
    intervals = section.count("intervals", default=_USUAL_INTERVALS, largest=_MOST_INTERVALS)
    if intervals < _FEWEST_INTERVALS or intervals % 4:
        raise ProblemError(
            f"[{section.path}]: intervals = {intervals} is not allowed: it must be a multiple of 4 from {_FEWEST_INTERVALS} to "
            f"{_MOST_INTERVALS}"
        )
    scheme = section.choice("scheme", SCHEMES, SCHEMES[0])
    return Rubbing(section.positive("coefficient"), tuple(section.ascending("sliding", positive=True)), intervals, scheme)
