# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion: JKR limit, finite range, and rate."""

from __future__ import annotations

import importlib
import math
from typing import Any

import numpy as np

from ..adhesion import RateAdhesion, rate_history
from ..contact import Contact
from ..material import Elastic
from ..medium import Homogeneous, Surface
from ..profile import Paraboloid
from .bodies import BODY, LIBRARY, MODULUS, RADIUS
from .check import Array, Check, Comparison, comparison


def jkr() -> Comparison:
    """F = 4 E* a^3/(3 R) - sqrt(8 pi gamma E* a^3), and the pull-off at -(3/2) pi gamma R."""
    gamma = 1e-3
    contact = Contact(Paraboloid(RADIUS), BODY, work_of_adhesion=gamma)
    a = np.linspace(0.15, 0.6, 25)
    there = 4.0 * MODULUS * a**3 / (3.0 * RADIUS) - np.sqrt(8.0 * math.pi * gamma * MODULUS * a**3)
    pull = -1.5 * math.pi * gamma * RADIUS
    here = np.append(np.asarray(contact.at_radius(a).force), float(contact.pull_off("force").force))
    return comparison("a (last: pull-off)", np.append(a, 0.65), here, np.append(there, pull), -pull)


def maugis() -> Comparison:
    """The zone's radius c = m a from its end's gap, then F = 4 E* a^3/(3 R) - 2 sigma a^2 (m^2 arcsec m + sqrt(m^2 - 1))."""
    gamma, sigma = 1e-3, 0.02
    a = np.linspace(0.05, 0.5, 15)
    there = [4.0 * MODULUS * r**3 / (3.0 * RADIUS) - 2.0 * sigma * r**2 * _zone_force(_zone(r, gamma, sigma)) for r in a]
    contact = Contact(Paraboloid(RADIUS), BODY, work_of_adhesion=gamma, cohesive_stress=sigma)
    return comparison("a", a, contact.at_radius(a).force, there, 1.5 * math.pi * gamma * RADIUS)


def _zone_force(m: float) -> float:
    return m**2 * math.acos(1.0 / m) + math.sqrt(m**2 - 1.0)


def _zone(a: float, gamma: float, sigma: float) -> float:
    """m by bisection."""
    low, high = 1.0, 1e3
    for _ in range(200):
        m = 0.5 * (low + high)
        root, angle = math.sqrt(m**2 - 1.0), math.acos(1.0 / m)
        gap = a**2 / (math.pi * RADIUS) * ((m**2 - 2.0) * angle + root)
        gap += 4.0 * sigma * a / (math.pi * MODULUS) * (root * angle - m + 1.0)
        low, high = (m, high) if gap < gamma / sigma else (low, m)
    return 0.5 * (low + high)


def rate() -> Comparison:
    """Retraction at a constant speed: da/dt = -v0 (G/w - 1)^(1/n), G = E* (a^2/R - d)^2/(2 pi a), integrated by SciPy."""
    work, speed, exponent, retraction = 1e-3, 1e-3, 0.5, 1e-3
    contact = Contact(Paraboloid(RADIUS), BODY, adhesion=RateAdhesion(work, speed, exponent))
    time = np.linspace(0.0, 25.0, 51)
    depth = 0.01 - retraction * time
    found: Any = rate_history(contact, time, depth=depth, start="rest")

    def release(a: Array, d: Array) -> Array:
        return MODULUS * (a**2 / RADIUS - d) ** 2 / (2.0 * math.pi * a)

    def speed_of_edge(t: float, a: Array) -> Array:
        over = np.maximum(release(a, np.asarray(0.01 - retraction * t)) / work - 1.0, 0.0)
        return -speed * over ** (1.0 / exponent)

    integrate: Any = importlib.import_module("scipy.integrate").solve_ivp
    start = [float(np.asarray(found.radius)[0])]
    a = integrate(speed_of_edge, (0.0, time[-1]), start, "LSODA", time, rtol=1e-11, atol=1e-13).y[0]
    there = 4.0 * MODULUS * a**3 / (3.0 * RADIUS) - np.sqrt(8.0 * math.pi * MODULUS * a**3 * release(a, depth))
    return comparison("t", time, found.force, there, float(np.abs(there).max()))


def with_tension() -> Comparison:
    """The depth W R/tau at which a ball rests on a surface that is held by its tension tau alone: the angle of Young and Dupré."""
    work, tip, modulus = 0.01, Paraboloid(RADIUS), np.geomspace(1e-6, 1e-3, 7)
    bodies = [Homogeneous(Elastic(E, 0.5), surface=Surface(tension=1.0)) for E in modulus]
    here = [float(Contact(tip, body, work_of_adhesion=work).at_force(0.0).depth) for body in bodies]
    return comparison("log10(E R/tau)", np.log10(modulus * RADIUS), here, np.full(7, work * RADIUS))


ADHESION = (
    Check("jkr", "adhesion", "Johnson, Kendall, Roberts 1971", 1e-8, LIBRARY, jkr),
    Check("maugis", "finite-range adhesion", "Maugis 1992", 1e-8, LIBRARY, maugis),
    Check("tension", "adhesion on a surface with tension", "Young 1805; Dupré 1869; Style et al. 2013", 1e-3,
          "limit: E R/tau up to 2e-3", with_tension),
    Check("rate", "pull-off that depends on speed", "Maugis, Barquins 1978, integrated by SciPy", 1e-6,
          "step control of SciPy", rate, needs="scipy"),
)  # fmt: skip
