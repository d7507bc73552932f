# SPDX-License-Identifier: GPL-3.0-or-later
"""Units: read with pint into SI, written in the practical unit that suits the magnitude."""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import fields
from decimal import Decimal
from typing import Any, NamedTuple, SupportsFloat

import numpy as np

from ._choices import nearest


class UnitError(ValueError):
    """A text is not the expected quantity; the message states what is expected."""


class Dimension(NamedTuple):
    """A kind of quantity: its SI unit, an example for messages, and the units in which results are written, ascending."""

    name: str
    si: str
    example: str
    practical: tuple[tuple[str, float], ...]
    others: tuple[str, ...] = ()
    hint: str = ""
    """what else a message states about a unit that does not match"""


LENGTH = Dimension("a length", "m", "500 nm", (("pm", 1e-12), ("nm", 1e-9), ("um", 1e-6), ("mm", 1e-3), ("m", 1.0)), ("angstrom",))
MODULUS = Dimension("a modulus", "Pa", "70 GPa", (("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9)), ("N/m^2", "N/mm^2"))
MODULUS_PER_LENGTH = Dimension(
    "a stiffness per area",
    "Pa/m",
    "20 GPa/um",
    (("Pa/m", 1.0), ("MPa/um", 1e12), ("GPa/um", 1e15), ("GPa/nm", 1e18)),
)
FORCE = Dimension("a force", "N", "2 mN", (("pN", 1e-12), ("nN", 1e-9), ("uN", 1e-6), ("mN", 1e-3), ("N", 1.0), ("kN", 1e3)))
STIFFNESS = Dimension("a stiffness", "N/m", "50 kN/m", (("uN/m", 1e-6), ("mN/m", 1e-3), ("N/m", 1.0), ("kN/m", 1e3), ("MN/m", 1e6)))
WORK_OF_ADHESION = Dimension(
    "a work of adhesion", "J/m^2", "50 mJ/m^2", (("uJ/m^2", 1e-6), ("mJ/m^2", 1e-3), ("J/m^2", 1.0)), ("N/m",)
)
SURFACE_TENSION = Dimension("a surface tension", "N/m", "30 mN/m", (("uN/m", 1e-6), ("mN/m", 1e-3), ("N/m", 1.0)), ("J/m^2",))
STRETCHING = Dimension(
    "a stiffness in the plane", "N/m", "100 N/m", (("mN/m", 1e-3), ("N/m", 1.0), ("kN/m", 1e3), ("MN/m", 1e6)), ("J/m^2",)
)
BENDING = Dimension(
    "a bending stiffness", "N*m", "1 nN*m", (("fN*m", 1e-15), ("pN*m", 1e-12), ("nN*m", 1e-9), ("uN*m", 1e-6), ("N*m", 1.0)), ("J",)
)
COMPLIANCE = Dimension("a compliance", "m/N", "0.5 nm/mN", (("nm/N", 1e-9), ("nm/mN", 1e-6), ("m/N", 1.0)), ("um/N",))
ENERGY = Dimension(
    "an energy", "J", "1 fJ", (("aJ", 1e-18), ("fJ", 1e-15), ("pJ", 1e-12), ("nJ", 1e-9), ("uJ", 1e-6), ("mJ", 1e-3), ("J", 1.0))
)
AREA = Dimension("an area", "m^2", "1 um^2", (("nm^2", 1e-18), ("um^2", 1e-12), ("mm^2", 1e-6), ("m^2", 1.0)))
VOLUME = Dimension("a volume", "m^3", "1 um^3", (("nm^3", 1e-27), ("um^3", 1e-18), ("mm^3", 1e-9), ("m^3", 1.0)))
TIME = Dimension("a time", "s", "10 s", (("us", 1e-6), ("ms", 1e-3), ("s", 1.0)), ("min", "h"))
FREQUENCY = Dimension(
    "an angular frequency", "rad/s", "10 rad/s", (("rad/s", 1.0),), ("Hz", "kHz"), ', or "Hz" where cycles per time are counted'
)
"""Units of cycles per time are taken times 2 pi; 1/s is neither cycles nor radians and raises."""
SPEED = Dimension("a speed", "m/s", "0.05 nm/s", (("pm/s", 1e-12), ("nm/s", 1e-9), ("um/s", 1e-6), ("m/s", 1.0)))
VOLTAGE = Dimension("a voltage", "V", "1 V", (("mV", 1e-3), ("V", 1.0)))
SENSITIVITY = Dimension("a deflection sensitivity", "m/V", "50 nm/V", (("nm/V", 1e-9), ("um/V", 1e-6), ("m/V", 1.0)))
VISCOSITY = Dimension("a viscosity", "Pa*s", "10 kPa*s", (("Pa*s", 1.0), ("kPa*s", 1e3), ("MPa*s", 1e6)))
DIFFUSIVITY = Dimension("a diffusivity", "m^2/s", "1000 um^2/s", (("um^2/s", 1e-12), ("mm^2/s", 1e-6), ("m^2/s", 1.0)), ("cm^2/s",))
THERMAL_CONDUCTIVITY = Dimension("a thermal conductivity", "W/(m*K)", "148 W/(m*K)", (("mW/(m*K)", 1e-3), ("W/(m*K)", 1.0)))
ELECTRICAL_CONDUCTIVITY = Dimension(
    "an electrical conductivity", "S/m", "59.6 MS/m", (("S/m", 1.0), ("kS/m", 1e3), ("MS/m", 1e6)), ("1/(ohm*m)",)
)
HEAT_CAPACITY = Dimension("a heat capacity per volume", "J/(m^3*K)", "1.66 MJ/(m^3*K)", (("J/(m^3*K)", 1.0), ("MJ/(m^3*K)", 1e6)))
CONDUCTANCE = Dimension("a conductance", "S", "1 S", (("nS", 1e-9), ("uS", 1e-6), ("mS", 1e-3), ("S", 1.0), ("kS", 1e3)))
THERMAL_CONDUCTANCE = Dimension(
    "a thermal conductance", "W/K", "1 mW/K", (("nW/K", 1e-9), ("uW/K", 1e-6), ("mW/K", 1e-3), ("W/K", 1.0))
)
AREA_RESISTANCE = Dimension("an area resistance", "ohm*m^2", "1e-12 ohm*m^2", (("ohm*m^2", 1.0),), ("ohm*um^2", "ohm*cm^2"))
THERMAL_AREA_RESISTANCE = Dimension("a thermal area resistance", "m^2*K/W", "1e-8 m^2*K/W", (("m^2*K/W", 1.0),))
TEMPERATURE = Dimension("a temperature difference", "K", "1 K", (("mK", 1e-3), ("K", 1.0)))
ANGLE = Dimension("an angle", "rad", "20 deg", (("rad", 1.0),), ("deg",))
WEAR = Dimension(
    "a coefficient of wear", "m^3/(N*m)", "1e-6 mm^3/(N*m)", (("mm^3/(N*m)", 1e-9), ("m^3/(N*m)", 1.0)), ("Pa^-1", "GPa^-1")
)
RATIO = Dimension("a number", "", "1", (("", 1.0),))
QUANTITIES: Mapping[str, Dimension] = {
    **dict.fromkeys(("depth", "radius", "height", "deflection", "sliding", "shift", "stick_radius", "worn_depth"), LENGTH),
    **dict.fromkeys(("force", "tangential_force"), FORCE),
    **dict.fromkeys(("stiffness", "slope", "storage", "loss"), STIFFNESS),
    **dict.fromkeys(("modulus", "pressure"), MODULUS),
    **{"area": AREA, "worn_volume": VOLUME, "time": TIME, "omega": FREQUENCY, "dissipated_energy": ENERGY, "error": RATIO},
}
"""Dimensions of states, histories and measurements by name."""
_USUAL = (LENGTH, FORCE, STIFFNESS, MODULUS, TIME, AREA, VOLTAGE)
"""Dimensions of the columns of tables; no two of them have a unit in common."""
_USUAL_NAMES = frozenset(name for dimension in _USUAL for name, _ in dimension.practical)

_QUANTITY = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^\W\d_].*?)?\s*")


_MICRO = re.compile(r"(?<![^\W\d_])u(?=[mNJSW]\b)|(?:(?<=\d )|(?<=\[))u(?=s\b)|^u(?=s$)")
"""The letter u that is the prefix of a unit."""
_PLAIN = ("-", "1")
"""Units of plain numbers, as tables write them."""
_LONGEST_UNIT, _LONGEST_TEXT = 60, 200
"""Characters. What is longer is no unit; pint would look for prefixes in it for minutes."""


@functools.cache
def _registry() -> Any:
    import pint  # here, because most programs never read a unit

    # decimal arithmetic: 10 um is then 1e-5 m to the last digit
    return pint.UnitRegistry(non_int_type=Decimal)


def to_si(value: float | str, unit: str, dimension: Dimension) -> float:
    """`value` in `unit` as a number in the SI unit of `dimension`."""
    finite = math.isfinite(float(value))
    factor = _factor(unit, dimension)
    return float(Decimal(str(value)) * factor) if finite else float(value)


def _factor(unit: str, dimension: Dimension) -> Decimal:
    """Return the number of SI units of `dimension` in one `unit`."""
    if len(unit) > _LONGEST_UNIT:
        raise UnitError(f"there is no unit {unit[:20] + '...'!r} of {len(unit)} characters")
    found = _factor_or_reason(unit, dimension)
    if isinstance(found, str):
        raise UnitError(found)
    return found


@functools.lru_cache(maxsize=1000)
def _factor_or_reason(unit: str, dimension: Dimension) -> Decimal | str:
    """Return the number of SI units of `dimension` in one `unit`, or the error.

    pint takes radians, turns and counts for plain numbers. Here they are units of their own: an angle is no ratio.
    """
    for name, factor in dimension.practical:
        if unit == name:  # usual units: pint takes half a second to begin
            return Decimal(repr(factor))
    other = f'{unit!r} is not a unit of {dimension.name}: write it as in "{dimension.example}"{dimension.hint}'
    if dimension in _USUAL and unit in _USUAL_NAMES:
        return other
    try:
        parsed = _registry().Unit("" if unit in _PLAIN else unit)
        one = _registry().Quantity(Decimal(1), _as_turns(parsed) if dimension == FREQUENCY else parsed).to_root_units()
        si = _registry().Quantity(Decimal(1), dimension.si).to_root_units()
        if one.units == si.units:
            return Decimal(one.magnitude / si.magnitude)
    except Exception:  # noqa: BLE001 - what is no unit makes pint raise almost anything, down to tokenizer errors
        known = [name for name, _ in dimension.practical] + list(dimension.others)
        return f"there is no unit {unit!r}: {nearest(unit, known)}"
    return other


def _as_turns(unit: Any) -> Any:
    """A unit of cycles per time - hertz, counts per second, becquerel, with any prefix - as one of turns per time; others as they
    are."""
    registry = _registry()
    root = registry.Quantity(Decimal(1), unit).to_root_units().units
    if root == registry.Unit("count/s"):
        return unit * registry.Unit("turn/count")
    if root != registry.Unit("1/s"):
        return unit
    # hertz is 1/s by definition: its name alone distinguishes cycles
    named = [(registry.parse_unit_name(name)[0][1], power) for name, power in registry.Quantity(1, unit).to_tuple()[1]]
    return unit * registry.turn if ("hertz", 1) in named else unit


def is_cyclic(unit: str) -> bool:
    """Return whether a unit of angular frequency counts cycles per time: its numbers are multiplied by 2 pi."""
    parsed = _registry().Unit(unit)
    return bool(_as_turns(parsed) != parsed)


def is_unit(text: str) -> bool:
    """Return whether a text is a unit, "%" and "-" for plain numbers included."""
    if text == "%" or text in _PLAIN or text in _USUAL_NAMES:
        return True
    return len(text) <= _LONGEST_UNIT and _is_registered(text)


@functools.lru_cache(maxsize=1000)
def _is_registered(text: str) -> bool:
    try:
        _registry().Unit(text)
    except Exception:  # noqa: BLE001 - what is no unit makes pint raise almost anything
        return False
    return True


def parse(text: str, dimension: Dimension) -> float:
    """A text such as "500 nm" as a number in SI units."""
    if len(text) > _LONGEST_TEXT:
        raise UnitError(f"{text[:20] + '...'!r} of {len(text)} characters is not {dimension.name}")
    match = _QUANTITY.fullmatch(text)
    if match is None:
        raise UnitError(f'{text!r} is not {dimension.name}: write it as in "{dimension.example}"')
    if match[2] is None:
        raise UnitError(f'{text!r} has no unit: write {dimension.name} as in "{dimension.example}"')
    return to_si(match[1], match[2], dimension)


def dimensions(*classes: Any) -> dict[str, Dimension]:
    """The fields of classes that are quantities; `RATIO` of plain numbers."""
    return {one.name: one.metadata["dimension"] for cls in classes for one in fields(cls) if "dimension" in one.metadata}


def with_micro(text: str) -> str:
    """Return a text with the micro sign in its units, as a page or a figure has them: "5 um" becomes "5 µm"."""
    return _MICRO.sub("\N{MICRO SIGN}", text)


def without_micro(text: str) -> str:
    """Return a text with "u" for the micro sign, as files have it."""
    return text.replace("\N{MICRO SIGN}", "u").replace("\N{GREEK SMALL LETTER MU}", "u")


class Unit(NamedTuple):
    """A unit results are written in."""

    name: str
    factor: float

    def of(self, values: Any) -> Any:
        """SI values in this unit."""
        return np.asarray(values) / self.factor

    @property
    def symbol(self) -> str:
        """The name as it is printed in a figure."""
        return with_micro(self.name)


def practical(dimension: Dimension, values: Iterable[float]) -> Unit:
    """The unit in which the largest of `values` (SI) is at least 1, where there is one."""
    array = np.abs(np.asarray(list(values), dtype=float))
    finite = array[np.isfinite(array)]
    largest = float(finite.max()) if finite.size else 0.0
    if largest == 0.0:
        return Unit(*next(((n, f) for n, f in dimension.practical if f == 1.0), dimension.practical[0]))
    name, factor = dimension.practical[0]
    for name_, factor_ in dimension.practical:
        # 1 - 1e-9: 1 mN that comes out as 0.9999999999999999 mN is not 1000 uN
        if largest >= factor_ * (1.0 - 1e-9):
            name, factor = name_, factor_
    return Unit(name, factor)


def shown(value: SupportsFloat, dimension: Dimension, figures: int = 5) -> str:
    """An SI value with its practical unit, as it is printed; "-" where it is not finite."""
    number = float(value)
    if not math.isfinite(number):
        return "-"
    unit = practical(dimension, [number])
    return f"{number / unit.factor:.{figures}g} {unit.name}".rstrip()
