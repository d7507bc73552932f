# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [strength] of a problem file: the strengths of layers and interfaces."""

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
    'strengths of layers, top to bottom, the substrate last, and of interfaces; "none": no failure there',
    tuple(
        Field(name, meaning, MODULUS, optional=True, choices=("none",), range=POSITIVE, many=True)
        for name, meaning in _MEANINGS.items()
    ),
    "docs/stress.md",
)

Strengths = dict[str, list[float | None]]


def read_strength(section: Section) -> Strengths:
    """Return the strengths for `Contact.first_failure` in SI units; None for "none"."""
    strengths: Strengths = {}
    for key in KNOWN:
        if key not in section:
            continue
        values = section.plain(key)
        if not isinstance(values, list):
            raise section.error(key, "it must be a list, top to bottom", f'Write it as in {key} = ["3 GPa", "none"]')
        strengths[key] = [None if value == "none" else section.entry(key, i) for i, value in enumerate(values, start=1)]
    if not strengths:
        raise ProblemError("it is empty", f"Give at least one of {', '.join(KNOWN)}", table=section.path)
    return strengths
