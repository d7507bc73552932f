# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [indenter] of a problem file."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .. import profile
from .._units import ANGLE, LENGTH, Dimension, UnitError, dimensions, to_si
from ..errors import InvalidArgumentError
from .section import Section


def _power_law(exponent: float, coefficient: float, length_unit: str) -> profile.PowerLaw:
    """Its coefficient counts in a unit of length of the file."""
    return profile.PowerLaw(exponent, coefficient * _metres(length_unit) ** (1.0 - exponent))


def _area_function(coefficients: list[float], length_unit: str, max_height: float, min_height: float = 0.0) -> profile.AreaFunction:
    """C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ..., its coefficients in a unit of length of the file."""
    unit = _metres(length_unit)
    terms = [c * unit ** (2.0 - (2.0 if k == 0 else 0.5 ** (k - 1))) for k, c in enumerate(coefficients)]
    return profile.AreaFunction(terms, max_height=max_height, min_height=min_height)


def _metres(length_unit: object) -> float:
    try:
        return to_si(1.0, str(length_unit), LENGTH)
    except UnitError as problem:
        raise InvalidArgumentError(f"length_unit: {problem}") from None


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
    "power-law": _power_law,
    "area-function": _area_function,
}
"""What makes a shape: its keys are the arguments."""

KNOWN: Mapping[str, Dimension | None] = {
    "shape": None,
    **dimensions(*(shape for shape in _SHAPES.values() if isinstance(shape, type)), profile.PowerLaw, profile.AreaFunction),
    "half_angle": ANGLE,
    **dict.fromkeys(("coefficient", "coefficients", "length_unit", "material", "body")),
}


def read_indenter(section: Section) -> profile.Profile:
    """The indenter that [indenter] describes."""
    shape = section.choice("shape", _SHAPES)
    return section.make(_SHAPES[shape], f"the shape {shape!r}", ("shape", "material", "body"))
