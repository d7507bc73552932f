# SPDX-License-Identifier: GPL-3.0-or-later
"""Normal contact without adhesion: closed forms, printed tables and formulas of others."""

from __future__ import annotations

import math

import numpy as np

from ..contact import Contact
from ..material import RIGID, Elastic, TransverselyIsotropic
from ..medium import Coated, Homogeneous, Pair, PowerLawGraded
from ..profile import Cone, FlatPunch, Paraboloid
from .bodies import BODY, LIBRARY, MATERIAL, MODULUS, RADIUS, ROUNDING, ball, hertz_force
from .check import Check, Comparison, comparison

_HAYES = {1.0: 3.609, 2.0: 9.069}
"""k (1 - nu)/(4 G a) of a flat punch on an incompressible layer that is bonded to a rigid base, by a/h."""
_GIBSON = 0.999
"""Exponent of the graded body, near that of Gibson's soil, 1."""


def hertz() -> Comparison:
    """F = (4/3) E* sqrt(R) d^(3/2)."""
    d = np.geomspace(1e-4, 1e-1, 25)
    return comparison("d/R", d / RADIUS, ball().at_depth(d).force, hertz_force(d))


def pair() -> Comparison:
    """Two elastic balls: 1/E* and 1/R are sums."""
    other = Elastic(5.0, 0.2)
    d = np.geomspace(1e-4, 1e-1, 25)
    both = 1.0 / (1.0 / MODULUS + (1.0 - other.nu**2) / other.E)
    here = Contact(Paraboloid(RADIUS), Pair(MATERIAL, other)).at_depth(d).force
    return comparison("d/R", d / RADIUS, here, hertz_force(d) * both / MODULUS)


def cone() -> Comparison:
    """F = 2 E* d^2/(pi tan(beta))."""
    d = np.geomspace(1e-4, 1e-1, 25)
    return comparison("d", d, Contact(Cone(0.2), BODY).at_depth(d).force, 2.0 * MODULUS * d**2 / (math.pi * math.tan(0.2)))


def punch() -> Comparison:
    """p(r) = E* d/(pi sqrt(a^2 - r^2)) under a flat punch."""
    contact = Contact(FlatPunch(0.5), BODY)
    r = np.linspace(0.0, 0.495, 25)
    there = MODULUS * 0.01 / (math.pi * np.sqrt(0.25 - r**2))
    return comparison("r/a", r / 0.5, contact.at_depth(0.01).pressure(r), there)


def surface() -> Comparison:
    """u(r) = ((2 a^2 - r^2) arcsin(a/r) + a sqrt(r^2 - a^2))/(pi R) outside the contact."""
    contact = ball()
    a, r = 0.1, np.linspace(0.101, 0.6, 25)
    there = ((2.0 * a**2 - r**2) * np.arcsin(a / r) + a * np.sqrt(r**2 - a**2)) / (math.pi * RADIUS)
    return comparison("r/a", r / a, contact.at_radius(a).displacement(r), there)


def equal() -> Comparison:
    """A film of the substrate's material, by the exact medium of coated bodies, is no film."""
    film = Coated(MATERIAL, 0.05, MATERIAL)
    d = np.geomspace(1e-4, 1e-1, 13)
    return comparison("d", d, Contact(Paraboloid(RADIUS), film).at_depth(d).force, hertz_force(d))


def with_an_axis() -> Comparison:
    """E* = 2 sqrt((C11 C33 - C13^2)/C11/(1/C44 + 2/(sqrt(C11 C33) + C13))) of hexagonal crystals, the axis along z [GPa]."""
    crystals = ((209.7, 121.1, 105.1, 210.9, 42.5), (390.0, 145.0, 106.0, 398.0, 105.0), (1060.0, 180.0, 15.0, 36.5, 4.5))
    here, there = [], []
    for C11, C12, C13, C33, C44 in crystals:
        here.append(float(Homogeneous(TransverselyIsotropic(C11, C12, C13, C33, C44)).modulus(1.0)))
        there.append(2.0 * math.sqrt((C11 * C33 - C13**2) / C11 / (1.0 / C44 + 2.0 / (math.sqrt(C11 * C33) + C13))))
    return comparison("ZnO, GaN, graphite", np.arange(3.0), here, there)


def gibson() -> Comparison:
    """An incompressible body with G = m z gives way like a bed of springs, p = 2 m u: F = 2 pi m R d^2."""
    slope = 0.7
    d = np.geomspace(1e-3, 1e-1, 13)
    soil = PowerLawGraded(3.0 * slope, 1.0, _GIBSON, 0.5)
    here = Contact(Paraboloid(RADIUS), soil).at_depth(d).force
    return comparison("d", d, here, 2.0 * math.pi * slope * RADIUS * d**2)


def hayes() -> Comparison:
    """The table by which cartilage is reduced, at nu = 1/2."""
    a = np.array(list(_HAYES))
    layer = Coated(Elastic(3.0, 0.5), 1.0, RIGID)
    return comparison("a/h", a, np.asarray(layer.stiffness(a)) * 0.5 / (4.0 * a), list(_HAYES.values()))


def perriot_barthel() -> Comparison:
    """(E_eff - E0*)/(E1* - E0*) = 1/(1 + (x0 h/a)^1.27), log10 x0 = -0.093 + 0.792 L + 0.05 L^2, L = log10(E1*/E0*)."""
    a = np.geomspace(0.01, 100.0, 17)
    here, there = [], []
    for logarithm in (-2.0, -1.0, -0.5, 0.5, 1.0, 2.0):
        film, base = Elastic(0.91, 0.3), Elastic(0.91 * 10.0**logarithm, 0.3)
        part = (np.asarray(Coated(film, 1.0, base).modulus(a)) - 1.0) / (10.0**logarithm - 1.0)
        here.append(part)
        x0 = 10.0 ** (-0.093 + 0.792 * logarithm + 0.05 * logarithm**2)
        there.append(1.0 / (1.0 + (x0 / a) ** 1.27))
    x = np.concatenate([np.log10(a) + 5.0 * i for i in range(len(here))])
    return comparison("log10(a/h), for E1*/E0* = 0.01 to 100", x, np.concatenate(here), np.concatenate(there), 1.0)


NORMAL = (
    Check("hertz", "force against depth, paraboloid", "Hertz 1882", ROUNDING, LIBRARY, hertz),
    Check("pair", "force against depth, two elastic balls", "Hertz 1882", ROUNDING, LIBRARY, pair),
    Check("cone", "force against depth, cone", "Love 1939; Sneddon 1965", ROUNDING, LIBRARY, cone),
    Check("punch", "pressure, flat punch", "Boussinesq 1885", ROUNDING, LIBRARY, punch),
    Check("surface", "displacement outside the contact", "Huber 1904; Johnson 1985, (3.42)", ROUNDING, LIBRARY, surface),
    Check("equal", "coated bodies, exact, of equal materials", "Hertz 1882", ROUNDING, LIBRARY, equal),
    Check("crystals", "transversely isotropic half-space", "Hanson 1992; Delafargue, Ulm 2004", ROUNDING, LIBRARY, with_an_axis),
    Check("gibson", "power-law graded body", "Gibson 1967", 5e-3, "limit: exponent 0.999 instead of 1", gibson),
    Check("hayes", "flat punch on a bonded layer", "Hayes, Keer, Herrmann, Mockros 1972, table", 1e-2,
          "table: 0.3 and 0.9 % low; finite elements agree with the library to 0.006 %", hayes),
    Check("perriot-barthel", "effective modulus of coated bodies", "Perriot, Barthel 2004, fit of their figure",
          0.1, "fit", perriot_barthel),
)  # fmt: skip
