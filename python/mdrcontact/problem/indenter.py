# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [indenter] of a problem file."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .. import profile
from .section import ProblemError, Section
from .units import ANGLE, LENGTH, Dimension, UnitError, to_si

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


def _cone(section: Section) -> profile.Profile:
    if "inclination" in section and "half_angle" in section:
        raise ProblemError(f"[{section.path}]: inclination and half_angle say the same thing twice: keep one")
    if "half_angle" in section:
        return profile.Cone(half_angle=section.quantity("half_angle"))
    return profile.Cone(section.quantity("inclination"))


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


_SHAPES: Mapping[str, tuple[tuple[str, ...], Callable[[Section], profile.Profile]]] = {
    "sphere": (("radius",), lambda s: profile.Sphere(s.quantity("radius"))),
    "paraboloid": (("radius",), lambda s: profile.Paraboloid(s.quantity("radius"))),
    "cone": (("inclination", "half_angle"), _cone),
    "power-law": (("exponent", "coefficient", "length_unit"), _power_law),
    "flat-punch": (("radius",), lambda s: profile.FlatPunch(s.quantity("radius"))),
    "flat-ended-cone": (
        ("end_radius", "inclination"),
        lambda s: profile.FlatEndedCone(s.quantity("end_radius"), s.quantity("inclination")),
    ),
    "flat-ended-paraboloid": (
        ("end_radius", "radius"),
        lambda s: profile.FlatEndedParaboloid(s.quantity("end_radius"), s.quantity("radius")),
    ),
    "rounded-cone": (
        ("blend_radius", "inclination"),
        lambda s: profile.RoundedCone(s.quantity("blend_radius"), s.quantity("inclination")),
    ),
    "berkovich": ((), lambda s: profile.Berkovich()),
    "vickers": ((), lambda s: profile.Vickers()),
    "cube-corner": ((), lambda s: profile.CubeCorner()),
    "area-function": (("coefficients", "length_unit", "min_height", "max_height"), _area_function),
    "table": (("r", "f"), lambda s: profile.TabulatedProfile(s.quantities("r"), s.quantities("f"))),
}


def read_indenter(section: Section) -> profile.Profile:
    """The indenter that [indenter] describes."""
    shape = section.choice("shape", _SHAPES)
    keys, build = _SHAPES[shape]
    section.only((*_ALWAYS, *keys), f"the shape {shape!r}")
    with section.words():
        return build(section)
