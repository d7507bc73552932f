# SPDX-License-Identifier: GPL-3.0-or-later
"""A problem file to begin with, for a file of measurements; what the measurements do not say is marked."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from ..._units import LENGTH, MODULUS, shown
from ..reading.area_function import power_of_term
from ..reading.formats import Fact, terms_of

_RADIUS, _USUAL = 5e-6, 1e4
"""Of a ball of which the file says nothing [m], and E of a body of which it says nothing [Pa]."""
_GUESS = "  # not in the file: put in yours"
_BALL = """\
[indenter]
shape = "sphere"
radius = "{radius}"{radius_note}

[medium]                        # a film: type = "coated", with coating = {{ E, nu, thickness }} and substrate = {{ E, nu }}
type = "homogeneous"
material = {{ E = "{modulus}", nu = 0.5 }}  # E is where the search begins
"""
_PYRAMID = """\
[indenter]                      # {tip}
shape = "area-function"
coefficients = {coefficients}
length_unit = "nm"
max_height = "{height}"

[medium]                        # a film: type = "coated", with coating = {{ E, nu, thickness }} and substrate = {{ E, nu }}
type = "homogeneous"
material = {{ E = "70 GPa", nu = 0.2 }}  # E is where the search begins; nu is not in the file

[instrument]
indenter = {{ E = "1141 GPa", nu = 0.07 }}  # diamond
"""
_IDEAL = 'an ideally sharp Berkovich tip; better: file = "tip.toml", written by mdrcontact calibrate'
_CALIBRATED = "the area function that the file gives"
_RELAXING = """\
[indenter]
shape = "sphere"
radius = "{radius}"{radius_note}

[medium]                        # G = modulus (t/time)^-exponent
type = "homogeneous"
material = {{ modulus = "{shear}", time = "1 s", exponent = 0.1, nu = 0.5 }}
"""
_SHARP = ("unloading", "stiffness-depth", "modulus-radius", "stiffness-radius")
_FREE = {
    "force-depth": ("E", "depth_offset"),
    "force-time": ("modulus", "exponent", "depth_offset"),
    "depth-time": ("modulus", "exponent", "depth_offset"),
}


class Size(NamedTuple):
    """Ranges of the readings."""

    depth: float
    """[m]"""
    force: float
    """[N]; 0: not known"""


def start_file(
    name: str, data: Mapping[str, object], facts: Sequence[Fact], size: Size, guessed: Mapping[str, str] = MappingProxyType({})
) -> str:
    """The text of a problem file. data : [data]; guessed : [instrument] of a file that does not say it"""
    kind = str(data["kind"])
    said = {fact.name: fact.value for fact in facts}
    radius = said.get("indenter.radius")
    body = _PYRAMID if kind in _SHARP else _RELAXING if kind.endswith("-time") else _BALL
    # in nm, as the file gives them
    terms = [float(f"{term / 1e-9 ** (2.0 - power_of_term(i)):.12g}") for i, term in sorted(terms_of(facts).items())]
    modulus = _modulus(size, radius or _RADIUS)
    text = body.format(
        radius=shown(radius or _RADIUS, LENGTH),
        radius_note="  # the file says so" if radius else _GUESS,
        tip=_CALIBRATED if terms else _IDEAL,
        coefficients=json.dumps(terms or [24.5]),
        height=shown(2.0 * size.depth, LENGTH, 3),
        modulus=shown(modulus, MODULUS, 3),
        shear=shown(modulus / 3.0, MODULUS, 3),
    )
    lines = [f"# mdrcontact fit {name} --problem THIS.toml", f'title = "{_plain(name)}"', "", text]
    lines += [f"# the file says: {fact}" for fact in facts]
    if guessed:
        lines += ["[instrument]", *(f'{key} = "{value}"{_GUESS}' for key, value in guessed.items()), ""]
    lines += ["[data]", *(f'{key} = "{value}"' for key, value in data.items()), ""]
    lines += ["[fit]", f"free = {json.dumps(_FREE.get(kind, ['E']))}", ""]
    return "\n".join(lines)


def _modulus(size: Size, radius: float) -> float:
    """E of an incompressible half-space under a ball that the largest force presses to the largest depth (Hertz) [Pa]."""
    if not (size.force > 0.0 and size.depth > 0.0):
        return _USUAL
    return 0.75 * 0.75 * size.force / math.sqrt(radius * size.depth**3)


def _plain(name: str) -> str:
    """A name without signs that end a text."""
    return "".join(sign if sign.isprintable() and sign not in '"\\' else " " for sign in name)
