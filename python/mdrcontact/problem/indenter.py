# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [indenter] of a problem file."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping

from .. import profile
from .._units import ANGLE, LENGTH, RATIO, UnitError, dimensions, to_si
from ..errors import InvalidArgumentError
from .field import NOT_NEGATIVE, POSITIVE, Field, Range, Table, arguments
from .medium import KNOWN as BODY
from .medium import MATERIAL
from .section import Section


def _power_law(exponent: float, coefficient: float, length_unit: str) -> profile.PowerLaw:
    """Return a profile f = c r^n; the unit of c contains length_unit."""
    try:
        return profile.PowerLaw(exponent, coefficient * _metres(length_unit) ** (1.0 - exponent))
    except OverflowError:
        raise InvalidArgumentError(
            f"coefficient = {coefficient:g}: its value in metres must be finite. Give a smaller one."
        ) from None


def _area_function(coefficients: list[float], length_unit: str, max_height: float, min_height: float = 0.0) -> profile.AreaFunction:
    """Return the area function C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ...; the coefficients have powers of length_unit."""
    unit = _metres(length_unit)
    terms = [c * unit ** (2.0 - (2.0 if k == 0 else 0.5 ** (k - 1))) for k, c in enumerate(coefficients)]
    return profile.AreaFunction(terms, max_height=max_height, min_height=min_height)


def _metres(length_unit: object) -> float:
    try:
        return to_si(1.0, str(length_unit), LENGTH)
    except UnitError as problem:
        raise InvalidArgumentError(f"length_unit: {problem}") from None


_OTHERWISE: Mapping[str, Callable[..., profile.Profile]] = {
    "table": profile.TabulatedProfile,
    "power-law": _power_law,
    "area-function": _area_function,
}
"""Shapes whose keys are not the arguments of a class with that name."""
_CLASSES = [getattr(profile, name) for name in (*profile.shapes.__all__, *profile.tips.__all__)]
_SHAPES: Mapping[str, Callable[..., profile.Profile]] = {
    **{re.sub("(?<=[a-z])(?=[A-Z])", "-", shape.__name__).lower(): shape for shape in _CLASSES},
    **_OTHERWISE,
}
"""Constructors of shapes; their arguments are the keys."""
_ACUTE = Range(0.0, math.pi / 2)
_DIMENSIONS = {
    **dimensions(*(shape for shape in _SHAPES.values() if isinstance(shape, type)), profile.PowerLaw, profile.AreaFunction),
    **{"half_angle": ANGLE, "coefficient": RATIO, "coefficients": RATIO},
}
_FIELDS = (
    Field("shape", "shape of the indenter", choices=tuple(_SHAPES)),
    Field("radius", "radius of curvature, or of a flat punch", range=POSITIVE),
    Field("inclination", "angle between face and surface", range=_ACUTE),
    Field("end_radius", "radius of the flat end", range=POSITIVE),
    Field("blend_radius", "radius at which the rounded tip meets the cone", range=POSITIVE),
    Field("r", "radii, from 0, ascending, at least three"),
    Field("f", "heights at these radii, from 0"),
    Field("exponent", "n of f = c r^n", range=Range(0.0, 100.0, has_largest=True)),
    Field("max_height", "largest height of the profile", range=POSITIVE),
    Field("min_height", "height below which the profile is a paraboloid", range=NOT_NEGATIVE),
    Field("half_angle", "angle between face and axis", range=_ACUTE),
    Field("coefficient", "c of f = c r^n, in length_unit^(1 - n)", range=POSITIVE),
    Field("coefficients", "C0, C1, ... of the area function, in powers of length_unit", example="[24.5, 1500.0]"),
    Field("length_unit", "unit of length of the coefficients", example='"nm"'),
    Field("material", "material of a deformable indenter", optional=True, table=MATERIAL),
    Field("body", "body of a deformable indenter with layers or a gradient", optional=True, table=BODY),
)

KNOWN = Table(
    "the indenter; rigid without material and body",
    tuple(arguments(_SHAPES, "shape", _DIMENSIONS, _FIELDS)),
    "docs/indenters.md",
    one_of=(("inclination", "half_angle"),),
    at_most_one_of=(("material", "body"),),
    replaced=(
        Field(
            "file",
            "calibrated tip that mdrcontact calibrate wrote, instead of shape",
            optional=True,
            is_file=True,
            example='"tip.toml"',
        ),
    ),
)


def read_indenter(section: Section) -> profile.Profile:
    """Return the indenter that [indenter] describes."""
    shape = section.value("shape")
    return section.make(_SHAPES[shape], f"the shape {shape!r}", ("shape", "material", "body"))
