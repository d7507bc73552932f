# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [indenter] of a problem file."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .. import profile
from .._units import ANGLE, LENGTH, Dimension, UnitError, to_si
from .section import ProblemError, Section, arguments

KNOWN: Mapping[str, Dimension | None] = {
    "shape": None,
    "radius": LENGTH,
    "end_radius": LENGTH,
    "blend_radius": LENGTH,
    "inclination": ANGLE,
    "half_angle": ANGLE,
    "exponent": None,
    "coefficient": None,
    "coefficients": None,
    "length_unit": None,
    "min_height": LENGTH,
    "max_height": LENGTH,
    "r": LENGTH,
    "f": LENGTH,
    "material": None,
    "body": None,
}

_ALWAYS = ("shape", "material", "body")


def _length_unit(section: Section) -> float:
    unit = section.plain("length_unit")
    try:
        return to_si(1.0, str(unit), LENGTH)
    except UnitError as problem:
        raise ProblemError(f"[{section.path}]: length_unit: {problem}") from None


def _power_law(section: Section) -> profile.Profile:
    exponent = section.number("exponent")
    return profile.PowerLaw(exponent, section.number("coefficient") * _length_unit(section) ** (1.0 - exponent))


def _area_function(section: Section) -> profile.Profile:
    unit = _length_unit(section)
    # C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ...
    given = section.numbers("coefficients")
    terms = [c * unit ** (2.0 - (2.0 if k == 0 else 0.5 ** (k - 1))) for k, c in enumerate(given)]
    min_height = section.quantity("min_height") if "min_height" in section else 0.0
    return profile.AreaFunction(terms, max_height=section.quantity("max_height"), min_height=min_height)


_SHAPES: Mapping[str, Callable[..., profile.Profile]] = {
    "sphere": profile.Sphere,
    "paraboloid": profile.Paraboloid,
    "cone": profile.Cone,
    "flat-punch": profile.FlatPunch,
    "flat-ended-cone": profile.FlatEndedCone,
    "flat-ended-paraboloid": profile.FlatEndedParaboloid,
    "rounded-cone": profile.RoundedCone,
    "berkovich": profile.Berkovich,
    "vickers": profile.Vickers,
    "cube-corner": profile.CubeCorner,
    "table": profile.TabulatedProfile,
}
"""Shapes whose keys are the arguments of their class."""
_IN_A_UNIT: Mapping[str, tuple[tuple[str, ...], Callable[[Section], profile.Profile]]] = {
    "power-law": (("exponent", "coefficient", "length_unit"), _power_law),
    "area-function": (("coefficients", "length_unit", "min_height", "max_height"), _area_function),
}
"""Shapes whose coefficients count in a unit of length of the file."""


def read_indenter(section: Section) -> profile.Profile:
    """The indenter that [indenter] describes."""
    shape = section.choice("shape", [*_SHAPES, *_IN_A_UNIT])
    keys = _IN_A_UNIT[shape][0] if shape in _IN_A_UNIT else arguments(_SHAPES[shape], KNOWN)
    section.only((*_ALWAYS, *keys), f"the shape {shape!r}")
    if shape in _SHAPES:
        return section.make(_SHAPES[shape])
    with section.words():
        return _IN_A_UNIT[shape][1](section)
