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
    strengths = {}
    for key in KNOWN:
        if key not in section:
            continue
        values = section.plain(key)
        if not isinstance(values, list):
            raise ProblemError(
                f'[{section.path}]: {key} = {values!r}: it must be a list, top to bottom. Write it as in {key} = ["3 GPa", "none"].'
            )
        known = [Section({key: value}, section.path, KNOWN).quantity(key) if value != "none" else None for value in values]
        for value, number in zip(values, known, strict=True):
            if number is not None and not number > 0.0:
                raise ProblemError(f'[{section.path}]: {key} = {value!r}: a strength must be greater than 0, or "none".')
        strengths[key] = known
    if not strengths:
        raise ProblemError(f"[{section.path}]: it is empty. Give at least one of {', '.join(KNOWN)}.")
    return strengths
