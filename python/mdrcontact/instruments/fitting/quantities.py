# SPDX-License-Identifier: GPL-3.0-or-later
"""Descriptions of the parameters of a fit, and their values with units. Values are taken as SI."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

from ..._parameters import WithParameters
from ..._units import MODULUS, RATIO, Dimension, Unit, dimensions, practical
from ...material import _ENGINEERING
from .parameters import Instrument

_EXACT = 1e-6
"""Standard error, as a part of the value, below which a number is exact to people."""
_WORDS = {
    "coating.E": "film modulus E",
    "coating.nu": "film Poisson's ratio nu",
    "thickness": "film thickness h",
    "substrate.E": "substrate modulus E",
    "substrate.nu": "substrate Poisson's ratio nu",
    "E": "modulus E",
    "nu": "Poisson's ratio nu",
    **{name: f"stiffness {name}" for name in ("C11", "C12", "C13", "C33", "C44")},
    "E_t": "modulus E_t in the plane",
    "E_z": "modulus E_z along the normal",
    "G_z": "shear modulus G_z",
    "nu_t": "Poisson's ratio nu_t in the plane",
    "nu_tz": "Poisson's ratio nu_tz",
    "prestress": "prestress",
    "E0": "modulus E0 at depth z0",
    "relaxed_shear_modulus": "relaxed shear modulus",
    "bulk_modulus": "bulk modulus K",
    "shear_modulus": "shear modulus G",
    "viscosity": "viscosity",
    "modulus": "shear modulus G at the unit of time",
    "time": "unit of time",
    "exponent": "exponent",
    "z0": "depth z0",
    "indenter.radius": "indenter radius R",
    "indenter.inclination": "inclination of the indenter's face",
    "indenter.end_radius": "radius of the indenter's flat end",
    "indenter.blend_radius": "radius of the indenter's rounding",
    "work_of_adhesion": "work of adhesion",
    "depth_offset": "depth at first contact",
    "force_offset": "force at first contact",
    "frame_compliance": "frame compliance",
    "indenter_modulus": "contact modulus of the indenter",
    "contact_depth_factor": "epsilon of the contact depth",
    "contact_depth_scale": "factor of the contact depth",
    "stiffness_factor": "beta of the stiffness",
    "area_factor": "true over assumed contact area",
    "cohesive_stress": "cohesive stress",
    "surface.tension": "surface tension tau",
    "surface.bending": "bending stiffness B of the surface",
    "surface.stretching": "stiffness K_m of the surface in its plane",
}
_LAYER_WORDS = {"E": "modulus E", "nu": "Poisson's ratio nu", "thickness": "thickness h"}


def _below(cls: type[Any]) -> Iterator[type[Any]]:
    for one in cls.__subclasses__():
        yield one
        yield from _below(one)


_DIMENSIONS = {**dimensions(*_below(WithParameters), Instrument), **_ENGINEERING, "indenter_modulus": MODULUS}
"""Descriptions of the fields of classes, and of arguments that replace some of them."""


def words_of(name: str) -> str:
    """Description of a parameter: "film modulus E" for "coating.E"."""
    if name in _WORDS:
        return _WORDS[name]
    layer = re.fullmatch(r"layers\[(\d+)\]\.(E|nu|thickness)", name)
    if layer:
        which = "film" if layer[1] == "0" else f"layer {int(layer[1]) + 1}"
        return f"{which} {_LAYER_WORDS[layer[2]]}"
    springs = re.fullmatch(r"layers\[(\d+)\]\.interface\.(normal|tangential)", name)
    if springs:
        above = "the film" if springs[1] == "0" else f"layer {int(springs[1]) + 1}"
        return f"{springs[2]} stiffness of the interface below {above}"
    term = re.fullmatch(r"(.*)terms\[(\d+)\]\.(modulus|time)", name)
    if term:
        what = "shear modulus" if term[3] == "modulus" else "relaxation time"
        return _of_part(term[1], f"{what} of term {int(term[2]) + 1}")
    part = re.fullmatch(r"(coating\.|substrate\.|layers\[\d+\]\.)(\w+)", name)
    if part and part[2] in _WORDS:
        return _of_part(part[1], _WORDS[part[2]])
    if re.fullmatch(r"indenter\.C\d", name):
        return f"coefficient {name[-2:]} of the area function"
    return name


def _of_part(prefix: str, words: str) -> str:
    """Words about a material with its place before them."""
    layer = re.fullmatch(r"layers\[(\d+)\]\.", prefix)
    place = {"": "", "coating.": "film ", "substrate.": "substrate "}.get(prefix)
    if place is None:
        assert layer is not None
        place = "film " if layer[1] == "0" else f"layer {int(layer[1]) + 1} "
    return place + words


def dimension_of(name: str) -> Dimension:
    """The dimension of a parameter, from its name."""
    coefficient = re.fullmatch(r"indenter\.C([1-7])", name)
    if coefficient:
        power = 2.0 - 0.5 ** (int(coefficient[1]) - 1)
        unit = "nm" if power == 1.0 else f"nm^{power:g}"
        return Dimension("a coefficient of an area function", f"m^{power:g}", f"1 {unit}", ((unit, 10.0 ** (-9.0 * power)),))
    return _DIMENSIONS.get(name.split(".")[-1].split("[")[0], RATIO)


def digits(value: float, error: float) -> str:
    """A value to the second digit of its error, in figures that people read: "72.1"."""
    if not (math.isfinite(value) and math.isfinite(error)) or error <= 0.0:
        return f"{value:.5g}"
    places = 1 - math.floor(math.log10(error))
    if -3 <= places <= 6 and abs(value) < 1e6:
        return f"{round(value, places):.{max(places, 0)}f}"
    return f"{value:.3g}"


def plain(value: float) -> str:
    """A number with four digits as people write it: no power of ten between a thousandth and ten millions."""
    if not math.isfinite(value) or not 1e-3 <= abs(value) < 1e7:
        return f"{value:.3g}"
    return f"{value:.0f}" if abs(value) >= 1e3 else f"{value:.4g}"


def probability(value: float) -> str:
    """A probability as people write it: "p = 0.03", "p < 0.001"."""
    return "p < 0.001" if value < 1e-3 else f"p = {value:.2g}"


def measured(name: str, value: float, error: float) -> str:
    """A value with its standard error and unit: "72.1 +- 1.0 GPa"."""
    unit = practical(dimension_of(name), [value if abs(value) > error else error])
    if 0.0 < error < _EXACT * abs(value):
        return f"{value / unit.factor:.6g} {unit.symbol}".rstrip() + f", error less than {100.0 * _EXACT:.4f} %"
    text = f"{digits(value / unit.factor, error / unit.factor)} ± {digits(error / unit.factor, error / unit.factor)}"
    return f"{text} {unit.symbol}".rstrip()


def unit_of(name: str, value: float) -> Unit:
    """The practical unit of a parameter's value."""
    return practical(dimension_of(name), [value])
