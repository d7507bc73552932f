# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [wear] of a problem file."""

from __future__ import annotations

from typing import NamedTuple

from .._units import LENGTH, RATIO, WEAR
from ..wear import SCHEMES
from .field import POSITIVE, Field, Range, Table
from .section import Section

KNOWN = Table(
    "wear by Archard's law at the largest depth, force or radius of [compute]",
    (
        Field("coefficient", "worn volume divided by force and distance", WEAR, range=POSITIVE),
        Field("sliding", "sliding distances, ascending", LENGTH, range=POSITIVE, many=True),
        Field("intervals", "intervals of the profile", RATIO, 80, range=Range(16, 640, True, True), step=4),
        Field("scheme", "discretization; a flat punch needs rings", default=SCHEMES[0], choices=SCHEMES),
    ),
    "docs/wear.md",
)


class Rubbing(NamedTuple):
    """A sliding indenter that wears; SI units."""

    coefficient: float
    """k [1/Pa], m^3/(N m)"""
    sliding: tuple[float, ...]
    """ascending distances"""
    intervals: int
    scheme: str


def read_wear(section: Section) -> Rubbing:
    """Return the contents of [wear]."""
    intervals, scheme, coefficient, sliding = map(section.value, ("intervals", "scheme", "coefficient", "sliding"))
    return Rubbing(coefficient, tuple(sliding), intervals, scheme)
