# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that yield."""

from __future__ import annotations

import math

import numpy as np

from ..contact import Contact
from ..material import Elastic
from ..medium import Coated
from ..plastic import Imprint, Overload, PlasticLaw, PressureCap, Yielding, truncated_hertz
from ..profile import Paraboloid
from .bodies import BODY, LIBRARY, MATERIAL, MODULUS, RADIUS, ROUNDING, ball
from .check import Array, Check, Comparison, comparison

_YIELD = 1e-4 * MODULUS
"""Yield stress."""
_ELEMENTS = np.array([
    (2.97923, 1.25293, 0.99576),
    (4, 1.54152, 0.957493),
    (5.98615, 1.86215, 0.87207),
    (8, 2.03509, 0.800994),
    (11.9723, 2.25733, 0.714888),
    (16, 2.41075, 0.664032),
    (23.9446, 2.61182, 0.606553),
    (29.3149, 2.70376, 0.581551),
    (42.519, 2.84048, 0.537988),
    (64, 2.93492, 0.492787),
    (95.7785, 2.97987, 0.45277),
    (128, 2.99743, 0.429064),
    (191.557, 3.00756, 0.403676),
    (234.519, 3.01093, 0.393447),
])  # fmt: skip
"""Finite elements of a paraboloid on a half-space, nu = 0.3: a E*/(R Y), F/(pi a^2 Y), d R/a^2."""
_FILM = np.array([
    (7.67, 0.023366, 0.273608),
    (11.67, 0.0474596, 0.762623),
    (13.67, 0.0617794, 1.1042),
    (17.67, 0.0950241, 2.00548),
    (19.67, 0.113974, 2.5828),
    (23.67, 0.15639, 4.0272),
    (25.67, 0.179705, 4.9006),
    (29.67, 0.229904, 6.95615),
    (31.67, 0.256552, 8.13422),
])  # fmt: skip
"""Finite elements of a film (E 1, Y 0.001, h 32) on an elastic body (E 4) under a paraboloid of radius 2197.8: a, d, F."""
_KOGUT_ETSION = np.array([
    (1.2, 1.33558, 1.14402, 0.0058832),
    (2, 2.7657, 2.04387, 0.0670612),
    (3, 4.92873, 3.23961, 0.140719),
    (8, 19.3522, 10.1875, 0.336243),
    (12, 32.2949, 16.2132, 0.411056),
    (35, 124.821, 55.2879, 0.576229),
    (60, 246.566, 102.539, 0.641769),
])  # fmt: skip
_JACKSON_GREEN = np.array([
    (1.2, 1.31453, 1.2, 0.0156174),
    (1.5, 1.83712, 1.5, 0.0378144),
    (3, 4.99829, 3.19811, 0.130987),
    (5, 10.1344, 5.72533, 0.223165),
    (12, 32.9736, 15.5325, 0.41041),
    (20, 64.2269, 27.8067, 0.520659),
    (60, 253.317, 97.2897, 0.718435),
    (100, 465.902, 174.17, 0.786582),
])  # fmt: skip
"""Curve fits of finite elements, nu = 0.3: d/d_y, F/F_y, A/A_y and d_r/d."""


def _law(largest_depth: float) -> PlasticLaw:
    return PlasticLaw(Paraboloid(RADIUS), Yielding(MATERIAL, yield_stress=_YIELD), largest_depth)


def _published(rows: Array) -> tuple[PlasticLaw, Array]:
    """The law, and its depths of some rows."""
    yield_depth = _law(1e-4 * RADIUS).yield_depth
    depth = yield_depth * rows[:, 0]
    return _law(1.01 * float(depth.max())), depth


def _force(rows: Array) -> Comparison:
    law, depth = _published(rows)
    return comparison("log10(d/d_y)", np.log10(rows[:, 0]), law.loading(depth).force / law.yield_force, rows[:, 1])


def _area(rows: Array) -> Comparison:
    law, depth = _published(rows)
    first = float(law.loading(law.yield_depth).radius)
    return comparison("log10(d/d_y)", np.log10(rows[:, 0]), (np.asarray(law.loading(depth).radius) / first) ** 2, rows[:, 2])


def kogut_etsion_force() -> Comparison:
    """F/F_y of their fit to finite elements of a sphere and a rigid flat."""
    return _force(_KOGUT_ETSION)


def kogut_etsion_area() -> Comparison:
    """A/A_y of that fit."""
    return _area(_KOGUT_ETSION)


def jackson_green_force() -> Comparison:
    """F/F_y of their fit to finite elements of a sphere and a rigid flat."""
    return _force(_JACKSON_GREEN)


def jackson_green_area() -> Comparison:
    """A/A_y of that fit."""
    return _area(_JACKSON_GREEN)


def virgin() -> Comparison:
    """Mean pressure over the yield stress of a paraboloid by finite elements."""
    load, pressure, depth = _ELEMENTS.T
    a = load * RADIUS * _YIELD / MODULUS
    force = _law(1.001 * float(np.max(a**2 * depth / RADIUS))).loading(a**2 * depth / RADIUS).force
    return comparison("log10(a E*/(R Y))", np.log10(load), force / (math.pi * a**2 * _YIELD), pressure)


def film() -> Comparison:
    """Force on a film by the overload rule, against finite elements."""
    a, _, force = _FILM.T
    body = Coated(Elastic(1.0, 0.3), 32.0, Elastic(4.0, 0.3))
    rule = Overload(Contact(Paraboloid(2197.8), body), [1e-3, math.inf])
    return comparison("a/h", a / 32.0, rule.at_radius(a).force, force)


def uniform_imprint() -> Comparison:
    """Unloading of the imprint of a uniform pressure: (2/pi) (arccos y - y (1 - y^2)^(1/2)), y = E* (d_m - d)/(2 p A)."""
    imprint, y = Imprint.from_two_terms(BODY, 0.1, 0.2, 0.0), np.linspace(0.05, 0.95, 19)
    depth = 2.0 * 0.2 * 0.1 / MODULUS * (1.0 - y)
    force = np.asarray(imprint.contact().at_depth(depth).force) / (0.2 * math.pi * 0.1**2)
    return comparison("y", y, force, 2.0 / math.pi * (np.arccos(y) - y * np.sqrt(1.0 - y**2)), 1.0)


def cap() -> Comparison:
    """A cap that is not reached: F = (4/3) E* R^(1/2) d^(3/2)."""
    d = np.linspace(1e-3, 1e-2, 7)
    there = 4.0 / 3.0 * MODULUS * np.sqrt(RADIUS) * d**1.5
    return comparison("d", d, PressureCap(ball(), 1e3 * MODULUS).at_depth(d).force, there)


def cut() -> Comparison:
    """Force of the pressure min(p, H) of Hertz's p, by its line load and by rings: pi H (1 - H^2) + (2/3) pi H^3 at a = p0 = 1."""
    part = np.linspace(0.2, 0.95, 6)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    angle, weights = 0.25 * math.pi * (nodes + 1.0), 0.25 * math.pi * weights
    here = []
    for hardness in part:
        edge = math.asin(math.sqrt(1.0 - hardness**2))
        # with a kink at sin(edge)
        share = edge / (0.5 * math.pi)
        places = share * angle, edge + (1.0 - share) * angle
        loads = [(truncated_hertz(np.sin(x), 1.0, 1.0, hardness) * np.cos(x)) @ weights for x in places]
        here.append(2.0 * (share * loads[0] + (1.0 - share) * loads[1]))
    there = math.pi * part * (1.0 - part**2) + 2.0 / 3.0 * math.pi * part**3
    return comparison("H/p0", part, here, there)


_FIT, _ELEMENT = "fit", "finite elements, theory of plasticity"

YIELDING = (
    Check("kogut-etsion", "force of a sphere beyond yield", "Kogut, Etsion 2002, fit", 5e-2, _FIT, kogut_etsion_force),
    Check("kogut-etsion-area", "contact area of a sphere beyond yield", "Kogut, Etsion 2002, fit", 6e-2, _FIT, kogut_etsion_area),
    Check("jackson-green", "force of a sphere beyond yield", "Jackson, Green 2005, fit", 5e-2, _FIT, jackson_green_force),
    Check(
        "jackson-green-area", "contact area of a sphere beyond yield", "Jackson, Green 2005, fit", 5e-2, _FIT, jackson_green_area
    ),
    Check("virgin", "mean pressure of a paraboloid beyond yield", _ELEMENT, 1e-2, "24 to 48 elements", virgin),
    Check(
        "overload", "force on a film that yields, overload rule", _ELEMENT, 7e-2, "overload rule, 5e-2, and 10 to 32 elements", film
    ),
    Check("imprint", "unloading from a uniform pressure", "Mesarovic, Johnson 2000", ROUNDING, LIBRARY, uniform_imprint),
    Check("cap", "force under a pressure cap that is not reached", "Hertz 1882", 1e-6, "96 intervals of the library", cap),
    Check("truncated", "force of a truncated pressure", "Thornton 1997", 1e-8, "rounding and quadrature", cut),
)
