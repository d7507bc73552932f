# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [strength] of a problem file: what layers and interfaces bear."""

from __future__ import annotations

from .._units import MODULUS
from .field import POSITIVE, Field, Table
from .section import ProblemError, Section

_MEANINGS = {
    "von_mises": "largest von Mises stress of each layer",
    "tension": "largest principal stress of each layer",
    "interface_shear": "largest shear stress of each interface",
    "interface_tension": "largest tension of each interface",
}
KNOWN = Table(
    'strengths, from the surface down, the substrate last; "none": no failure of that layer',
    tuple(
        Field(name, meaning, MODULUS, optional=True, choices=("none",), range=POSITIVE, many=True)
        for name, meaning in _MEANINGS.items()
    ),
    "docs/stress.md",
)

Strengths = dict[str, list[float | None]]


def read_strength(section: Section) -> Strengths:
    """The strengths as `Contact.first_failure` takes them, SI units; "none" where no failure is looked for."""
    strengths = {}
    for key in KNOWN:
        if key not in section:
            continue
        values = section.plain(key)
        if not isinstance(values, list):
            raise ProblemError(f'[{section.path}]: {key} must be a list from the surface down, as in {key} = ["3 GPa", "none"]')
        known = [Section({key: value}, section.path, KNOWN).quantity(key) if value != "none" else None for value in values]
        for value, number in zip(values, known, strict=True):
            if number is not None and not number > 0.0:
                raise ProblemError(f'[{section.path}]: {key} = {value!r} is not allowed: a strength is greater than 0, or "none"')
        strengths[key] = known
    if not strengths:
        raise ProblemError(f"[{section.path}]: it is empty: give at least one of {', '.join(KNOWN)}")
    return strengths
