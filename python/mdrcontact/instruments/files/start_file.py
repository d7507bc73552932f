# SPDX-License-Identifier: GPL-3.0-or-later
"""A problem file to begin with, for a file of measurements; values that the measurements do not contain are marked."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from ..._units import LENGTH, MODULUS, WORK_OF_ADHESION, shown
from ...problem.toml import keyed
from ..reading.area_function import power_of_term
from ..reading.formats import Fact, terms_of

MARK = "  # not in the file: put in yours"
_RADIUS, _USUAL = 5e-6, 1e4
"""Radius of a ball [m] and E of a body [Pa] that the file does not describe."""
_HARD = 70e9
"""E of a body under a sharp tip that the file does not describe [Pa]."""
BERKOVICH = 24.5
"""Projected area of a Berkovich tip over the square of its depth."""
_HEIGHTS = 2.0
"""A tip is calibrated, and a ball at least as large, to so many times the depth that is reached."""
_IDEAL = 'an ideally sharp Berkovich tip; better: file = "tip.toml", written by mdrcontact calibrate'
_CALIBRATED = "the area function that the file gives"
_FILM = '# a film: type = "coated", with coating = { E, nu, thickness } and substrate = { E, nu }'
_SHARP = ("unloading", "stiffness-depth", "modulus-radius", "stiffness-radius")
_FREE = {
    "force-depth": ("E", "depth_offset"),
    "force-time": ("modulus", "exponent", "depth_offset"),
    "depth-time": ("modulus", "exponent", "depth_offset"),
}


class Size(NamedTuple):
    """Ranges of the readings; 0: not known."""

    depth: float
    """[m]"""
    force: float = 0.0
    """[N]"""
    reached: float = 0.0
    """depth of the contact, at most [m]"""
    modulus: float = 0.0
    """E_eff from the readings without a model [Pa]"""


class Start(NamedTuple):
    """Content of a problem file to start from."""

    name: str
    """of the file of measurements"""
    data: Mapping[str, object]
    """[data]"""
    size: Size
    facts: Sequence[Fact] = ()
    said: Mapping[str, str] = MappingProxyType({})
    """[instrument], as given by the user"""
    guessed: Mapping[str, str] = MappingProxyType({})
    """[instrument], of which nothing is known"""
    marked: Sequence[str] = ()
    """keys of [data] that are guessed"""
    work_of_adhesion: float = 0.0
    """of a record that pulls [J/m^2]"""
    has_tip: bool = True
    """whether the compliance of a sharp tip is in the readings"""
    thickness: float = 0.0
    """of a film, guessed; 0: a homogeneous body [m]"""

    def text(self) -> str:
        """The problem file."""
        kind = str(self.data["kind"])
        title = "".join(sign if sign.isprintable() and sign not in '"\\' else " " for sign in self.name)
        free = list(_FREE.get(kind, ("coating.E",) if self.thickness else ("E",)))
        if self.work_of_adhesion:
            free.insert(1, "work_of_adhesion")
        lines = [f"# mdrcontact fit {self.name} --problem THIS.toml", f'title = "{title}"', ""]
        lines += [*self._indenter(kind), "", *self._medium(kind), ""]
        lines += [f"# stated in the file: {fact}" for fact in self.facts]
        instrument = [*self._instrument(kind)]
        lines += ["[instrument]", *instrument, ""] if instrument else []
        lines += ["[data]", *(_line(key, value, key in self.marked) for key, value in self.data.items()), ""]
        return "\n".join([*lines, "[fit]", f"free = {json.dumps(free)}", ""])

    def _indenter(self, kind: str) -> Iterator[str]:
        if kind in _SHARP:
            height = shown(_HEIGHTS * self.size.depth, LENGTH, 3)
            # in nm, as the file gives them
            terms = [float(f"{term / 1e-9 ** (2.0 - power_of_term(i)):.12g}") for i, term in sorted(terms_of(self.facts).items())]
            yield f"[indenter]                      # {_CALIBRATED if terms else _IDEAL}"
            yield from (
                'shape = "area-function"',
                f"coefficients = {json.dumps(terms or [BERKOVICH])}",
                'length_unit = "nm"',
                f'max_height = "{height}"',
            )
        else:
            note = MARK if self._said_radius is None else "  # stated in the file"
            yield from ("[indenter]", 'shape = "sphere"', f'radius = "{shown(self.radius, LENGTH)}"{note}')

    @property
    def radius(self) -> float:
        """Radius of a ball: that of the file, or one that allows the largest depth [m]."""
        guess = _RADIUS if self.size.reached <= _RADIUS else float(f"{_HEIGHTS * self.size.reached:.1g}")
        return guess if self._said_radius is None else self._said_radius

    @property
    def _said_radius(self) -> float | None:
        return next((fact.value for fact in self.facts if fact.name == "indenter.radius"), None)

    def _medium(self, kind: str) -> Iterator[str]:
        modulus = self._modulus(kind)
        if self.thickness:
            yield from ("[medium]", 'type = "coated"', "", "[medium.coating]")
            yield f'E = "{shown(modulus, MODULUS, 3)}"  # where the search begins'
            yield from (f"nu = 0.2{MARK}", f'thickness = "{shown(self.thickness, LENGTH)}"{MARK}', "", "[medium.substrate]")
            yield from (f'E = "{shown(2.0 * modulus, MODULUS, 3)}"{MARK}', f"nu = 0.2{MARK}")
        elif kind in _SHARP:
            yield from (f"[medium]                        {_FILM}", 'type = "homogeneous"')
            note = "E is where the search begins; nu is not in the file"
            yield f'material = {{ E = "{shown(modulus, MODULUS, 3)}", nu = 0.2 }}  # {note}'
        elif kind.endswith("-time"):
            yield from ("[medium]                        # G = modulus (t/time)^-exponent", 'type = "homogeneous"')
            yield f'material = {{ modulus = "{shown(modulus / 3.0, MODULUS, 3)}", time = "1 s", exponent = 0.1, nu = 0.5 }}'
        else:
            yield from (f"[medium]                        {_FILM}", 'type = "homogeneous"')
            yield f'material = {{ E = "{shown(modulus, MODULUS, 3)}", nu = 0.5 }}  # E is where the search begins'

    def _modulus(self, kind: str) -> float:
        """Start of the search: E from the readings; of an incompressible half-space under a ball that the largest force
        presses to the largest depth (Hertz) [Pa]."""
        if self.size.modulus > 0.0:
            return self.size.modulus
        if kind in _SHARP:
            return _HARD
        if not (self.size.force > 0.0 and self.size.depth > 0.0):
            return _USUAL
        return 0.75 * 0.75 * self.size.force / math.sqrt(self.radius * self.size.depth**3)

    def _instrument(self, kind: str) -> Iterator[str]:
        if kind in _SHARP and self.has_tip:
            yield 'indenter = { E = "1141 GPa", nu = 0.07 }  # diamond'
        if self.work_of_adhesion:
            yield f'work_of_adhesion = "{shown(self.work_of_adhesion, WORK_OF_ADHESION, 2)}"  # where the search begins'
        yield from (f'{key} = "{value}"' for key, value in self.said.items())
        yield from (f'{key} = "{value}"{MARK}' for key, value in self.guessed.items())


def _line(key: str, value: object, is_marked: bool) -> str:
    return keyed(key, value) + (MARK if is_marked else "")
