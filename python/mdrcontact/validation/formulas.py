# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms of others, written out beside what the library computes in its own way."""

from __future__ import annotations

import math

import numpy as np

from ..conduction import Conduction
from ..conductor import Conductor, LayeredConductor
from ..contact import Contact, State
from ..friction import Friction
from ..material import Elastic, PowerLawRheology
from ..medium import Coated, Homogeneous
from ..profile import Cone, FlatPunch, Paraboloid
from .check import Array, Check, Comparison, comparison

_G, _NU, _RADIUS = 1.3, 0.3, 2.0
"""Shear modulus, Poisson's ratio and radius of the paraboloid, in any one consistent unit."""
_MATERIAL = Elastic(2.0 * _G * (1.0 + _NU), _NU)
_BODY = Homogeneous(_MATERIAL)
_MODULUS = 2.0 * _G / (1.0 - _NU)
"""E*"""
_FRICTION = 0.3
_ROUNDING = 1e-9
_MEANS = 8
"""Of arithmetic and geometric means, whose error falls by its square."""


def hertz() -> Comparison:
    """F = (4/3) E* sqrt(R) d^(3/2)."""
    d = np.geomspace(1e-4, 1e-1, 25)
    return comparison("d/R", d / _RADIUS, Contact(Paraboloid(_RADIUS), _BODY).at_depth(d).force, _hertz(d))


def _hertz(d: Array) -> Array:
    return 4.0 / 3.0 * _MODULUS * math.sqrt(_RADIUS) * d**1.5


def cone() -> Comparison:
    """F = 2 E* d^2/(pi tan(beta))."""
    d = np.geomspace(1e-4, 1e-1, 25)
    return comparison("d", d, Contact(Cone(0.2), _BODY).at_depth(d).force, 2.0 * _MODULUS * d**2 / (math.pi * math.tan(0.2)))


def surface() -> Comparison:
    """u(r) = ((2 a^2 - r^2) arcsin(a/r) + a sqrt(r^2 - a^2))/(pi R) beside the contact."""
    contact = Contact(Paraboloid(_RADIUS), _BODY)
    a, r = 0.1, np.linspace(0.101, 0.6, 25)
    there = ((2.0 * a**2 - r**2) * np.arcsin(a / r) + a * np.sqrt(r**2 - a**2)) / (math.pi * _RADIUS)
    return comparison("r/a", r / a, contact.displacement(r, contact.at_radius(a)), there)


def axis() -> Comparison:
    """s_rr and s_zz on the axis under Hertz's pressure."""
    contact = Contact(Paraboloid(_RADIUS), _BODY)
    state = contact.at_radius(0.1)
    z = np.linspace(0.05, 4.0, 25)
    inside = contact.interior(np.zeros(z.size), z * 0.1, state)
    s_zz = -1.0 / (1.0 + z**2)
    s_rr = -(1.0 + _NU) * (1.0 - z * np.arctan(1.0 / z)) + 0.5 / (1.0 + z**2)
    p = float(contact.pressure(0.0, state))
    here = np.concatenate([np.asarray(inside.s_zz), np.asarray(inside.s_rr)]) / p
    return comparison("z/a (s_zz, then s_rr)", np.concatenate([z, z + 4.0]), here, np.concatenate([s_zz, s_rr]), 1.0)


def jkr() -> Comparison:
    """F = 4 E* a^3/(3 R) - sqrt(8 pi gamma E* a^3), and the pull-off at -(3/2) pi gamma R."""
    gamma = 1e-3
    contact = Contact(Paraboloid(_RADIUS), _BODY, work_of_adhesion=gamma)
    a = np.linspace(0.15, 0.6, 25)
    there = 4.0 * _MODULUS * a**3 / (3.0 * _RADIUS) - np.sqrt(8.0 * math.pi * gamma * _MODULUS * a**3)
    pull = -1.5 * math.pi * gamma * _RADIUS
    here = np.append(np.asarray(contact.at_radius(a).force), float(contact.pull_off("force").force))
    return comparison("a (last: pull-off)", np.append(a, 0.65), here, np.append(there, pull), -pull)


def maugis() -> Comparison:
    """The zone's radius c = m a from its end's gap, then F = 4 E* a^3/(3 R) - 2 sigma a^2 (m^2 arcsec m + sqrt(m^2 - 1))."""
    gamma, sigma = 1e-3, 0.02
    a = np.linspace(0.05, 0.5, 15)
    there = [4.0 * _MODULUS * r**3 / (3.0 * _RADIUS) - 2.0 * sigma * r**2 * _zone_force(_zone(r, gamma, sigma)) for r in a]
    contact = Contact(Paraboloid(_RADIUS), _BODY, work_of_adhesion=gamma, cohesive_stress=sigma)
    return comparison("a", a, contact.at_radius(a).force, there, 1.5 * math.pi * gamma * _RADIUS)


def _zone_force(m: float) -> float:
    return m**2 * math.acos(1.0 / m) + math.sqrt(m**2 - 1.0)


def _zone(a: float, gamma: float, sigma: float) -> float:
    """m by bisection."""
    low, high = 1.0, 1e3
    for _ in range(200):
        m = 0.5 * (low + high)
        root, angle = math.sqrt(m**2 - 1.0), math.acos(1.0 / m)
        gap = a**2 / (math.pi * _RADIUS) * ((m**2 - 2.0) * angle + root)
        gap += 4.0 * sigma * a / (math.pi * _MODULUS) * (root * angle - m + 1.0)
        low, high = (m, high) if gap < gamma / sigma else (low, m)
    return 0.5 * (low + high)


def mindlin() -> Comparison:
    """s = (3 mu F/(16 a)) ((2 - nu)/G) (1 - (1 - T/(mu F))^(2/3))."""
    friction, state = _pressed()
    part = np.linspace(0.02, 0.98, 25)
    limit = _FRICTION * float(state.force)
    there = 3.0 * limit * (2.0 - _NU) / (16.0 * float(state.radius) * _G) * (1.0 - (1.0 - part) ** (2.0 / 3.0))
    return comparison("T/(mu F)", part, friction.at_tangential_force(part * limit, state).shift, there)


def _pressed() -> tuple[Friction, State]:
    contact = Contact(Paraboloid(_RADIUS), _BODY)
    return Friction(contact, _FRICTION), contact.at_depth(0.01)


def cycle() -> Comparison:
    """The energy of a cycle between +T and -T."""
    friction, state = _pressed()
    limit, a = _FRICTION * float(state.force), float(state.radius)
    part = np.linspace(0.2, 0.95, 16)
    there = (
        0.9
        * limit**2
        * (2.0 - _NU)
        / (a * _G)
        * (1.0 - (1.0 - part) ** (5.0 / 3.0) - 5.0 * part / 6.0 * (1.0 + (1.0 - part) ** (2.0 / 3.0)))
    )
    here = [float(friction.cycle_energy(t * limit, "force", state)) for t in part]
    return comparison("T/(mu F)", part, here, there)


def lubkin() -> Comparison:
    """phi = (3 mu F/(4 pi G a^2)) (K - E) of the modulus sqrt(1 - c^2/a^2)."""
    friction, state = _pressed()
    unit = 3.0 * _FRICTION * float(state.force) / (4.0 * math.pi * _G * float(state.radius) ** 2)
    twist = unit * np.geomspace(0.05, 6.0, 25)
    part = np.asarray(friction.torsion.at_twist(twist, state).stick_radius) / float(state.radius)
    there = [unit * _k_less_e(c) for c in part]
    return comparison("phi in units of 3 mu F/(4 pi G a^2)", twist / unit, twist, there)


def _k_less_e(part: float) -> float:
    """K - E of the modulus sqrt(1 - part^2), by arithmetic and geometric means."""
    a, b, c, total, power = 1.0, part, math.sqrt(1.0 - part**2), 0.0, 0.5
    for _ in range(_MEANS):
        total += power * c**2
        a, b, c, power = 0.5 * (a + b), math.sqrt(a * b), 0.5 * (a - b), 2.0 * power
    return 0.5 * math.pi / a * total


def lee_radok() -> Comparison:
    """A power law pressed at a constant rate: F ~ B(3/2, 1 - alpha) t^(3/2 - alpha)."""
    alpha, rate = 0.2, 0.01
    contact = Contact(Paraboloid(_RADIUS), Homogeneous(PowerLawRheology(_G, 1.0, alpha, 0.5)))
    time = np.linspace(0.0, 2.0, 41)
    beta = math.gamma(1.5) * math.gamma(1.0 - alpha) / math.gamma(2.5 - alpha)
    there = 16.0 / 3.0 * _G * math.sqrt(_RADIUS) * rate**1.5 * 1.5 * beta * time ** (1.5 - alpha)
    return comparison("t", time, contact.history(time, depth=rate * time).force, there, float(there[-1]))


def ting() -> Comparison:
    """The same pulled back from t = 1 on: t_1 = t - 2^(1/(1 - alpha)) (t - 1), and the integral ends there."""
    alpha, rate = 0.2, 0.01
    contact = Contact(Paraboloid(_RADIUS), Homogeneous(PowerLawRheology(_G, 1.0, alpha, 0.5)))
    time = np.linspace(1.0, 1.6, 31)
    path = np.concatenate([np.linspace(0.0, 1.0, 21)[:-1], time])
    end = time - 2.0 ** (1.0 / (1.0 - alpha)) * (time - 1.0)
    there = (
        16.0
        / 3.0
        * _G
        * math.sqrt(_RADIUS)
        * rate**1.5
        * 1.5
        * np.array([_part(t, e, alpha) for t, e in zip(time, end, strict=True)])
    )
    here = np.asarray(contact.history(path, depth=rate * (1.0 - np.abs(1.0 - path))).force)[20:]
    return comparison("t", time, here, there, float(there[0]))


def _part(time: float, end: float, alpha: float) -> float:
    """int_0^end (t - u)^-alpha sqrt(u) du, by u = v^2 and t - u = w^(1/(1 - alpha)) where it is steep."""
    if end <= 0.0:
        return 0.0
    nodes, weights = np.polynomial.legendre.leggauss(80)
    middle = 0.5 * end
    v = 0.5 * math.sqrt(middle) * (nodes + 1.0)
    first = 0.5 * math.sqrt(middle) * float(weights @ (2.0 * v**2 * (time - v**2) ** -alpha))
    power = 1.0 - alpha
    low, high = (time - end) ** power, (time - middle) ** power
    w = low + 0.5 * (high - low) * (nodes + 1.0)
    return first + float(0.5 * (high - low) / power) * float(weights @ np.sqrt(time - w ** (1.0 / power)))


def holm() -> Comparison:
    """Two half-spaces: G = 4 a/(1/S_0 + 1/S_1)."""
    a = np.geomspace(1e-3, 1e3, 13)
    there = 4.0 * a / (1.0 / 2.0 + 1.0 / 5.0)
    return comparison("a", a, Conduction(Conductor(2.0), Conductor(5.0)).at_radius(a).conductance, there)


def dryden() -> Comparison:
    """A layer much thicker than the spot: 1/G = 1/(4 S_0 a) + ln((1 + S_0/S_1)/2)/(2 pi S_0 H)."""
    a, first, second = np.array([0.01, 0.02, 0.03]), 2.0, 0.1
    spot = Conduction(LayeredConductor(((Conductor(first), 1.0),), Conductor(second))).at_radius(a)
    there = math.log(0.5 * (1.0 + first / second)) / (2.0 * math.pi * first) * np.ones(a.size)
    return comparison("a/H", a, 1.0 / np.asarray(spot.conductance) - 1.0 / (4.0 * first * a), there)


def punch() -> Comparison:
    """p(r) = E* d/(pi sqrt(a^2 - r^2)) under a flat punch."""
    contact = Contact(FlatPunch(0.5), _BODY)
    r = np.linspace(0.0, 0.495, 25)
    there = _MODULUS * 0.01 / (math.pi * np.sqrt(0.25 - r**2))
    return comparison("r/a", r / 0.5, contact.pressure(r, contact.at_depth(0.01)), there)


def equal() -> Comparison:
    """A film of the substrate's material, by the exact medium of coated bodies, is no film."""
    film = Coated(_MATERIAL, 0.05, _MATERIAL)
    d = np.geomspace(1e-4, 1e-1, 13)
    return comparison("d", d, Contact(Paraboloid(_RADIUS), film).at_depth(d).force, _hertz(d))


_LIBRARY = "rounding and the library's tolerance"
FORMULAS = (
    Check("hertz", "force against depth, paraboloid", "Hertz 1882", _ROUNDING, _LIBRARY, hertz),
    Check("cone", "force against depth, cone", "Love 1939; Sneddon 1965", _ROUNDING, _LIBRARY, cone),
    Check("punch", "pressure, flat punch", "Boussinesq 1885", _ROUNDING, _LIBRARY, punch),
    Check("surface", "displacement beside the contact", "Huber 1904; Johnson 1985, (3.42)", _ROUNDING, _LIBRARY, surface),
    Check("axis", "stresses inside, on the axis", "Huber 1904; Johnson 1985, (3.45)", 1e-8, _LIBRARY, axis),
    Check("equal", "coated bodies, exact, of equal materials", "Hertz 1882", _ROUNDING, _LIBRARY, equal),
    Check("jkr", "adhesion", "Johnson, Kendall, Roberts 1971", 1e-8, _LIBRARY, jkr),
    Check("maugis", "adhesion with a range", "Maugis 1992", 1e-8, _LIBRARY, maugis),
    Check("mindlin", "partial slip", "Cattaneo 1938; Mindlin 1949", 1e-8, _LIBRARY, mindlin),
    Check("cycle", "energy of a cycle of partial slip", "Mindlin, Deresiewicz 1953; Johnson 1985, (7.57)", 1e-7, _LIBRARY, cycle),
    Check("lubkin", "torsion with partial slip", "Lubkin 1951", 1e-8, _LIBRARY, lubkin),
    Check("lee-radok", "viscoelastic contact that grows", "Lee, Radok 1960", 1e-8, _LIBRARY, lee_radok),
    Check("ting", "viscoelastic contact that shrinks", "Ting 1966", 1e-7, _LIBRARY, ting),
    Check("holm", "conductance of a spot", "Holm 1967", _ROUNDING, _LIBRARY, holm),
    Check("dryden", "spot on a layered conductor, thick layer", "Dryden 1983", 3e-3, "the limit's next term, (a/H)^2", dryden),
)
