# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction: partial slip along the surface and about the axis, cycles."""

from __future__ import annotations

import math

import numpy as np

from .bodies import FRICTION, LIBRARY, NU, SHEAR, pressed
from .check import Check, Comparison, comparison

_MEANS = 8
"""Of arithmetic and geometric means, whose error falls by its square."""


def mindlin() -> Comparison:
    """s = (3 mu F/(16 a)) ((2 - nu)/G) (1 - (1 - T/(mu F))^(2/3))."""
    friction, state = pressed()
    part = np.linspace(0.02, 0.98, 25)
    limit = FRICTION * float(state.force)
    there = 3.0 * limit * (2.0 - NU) / (16.0 * float(state.radius) * SHEAR) * (1.0 - (1.0 - part) ** (2.0 / 3.0))
    return comparison("T/(mu F)", part, friction.shear(state).at_force(part * limit).shift, there)


def unloading() -> Comparison:
    """T falls from T1 = 0.8 mu F to -T1: s = (3 mu F (2 - nu)/(16 a G)) (2 (1 - (t1 - t)/2)^(2/3) - (1 - t1)^(2/3) - 1),
    t = T/(mu F)."""
    friction, state = pressed()
    limit, largest = FRICTION * float(state.force), 0.8
    history = friction.history()
    history.advance(depth=float(state.depth), shift=0.0)
    part = np.linspace(largest, -largest, 25)
    history.advance(force=float(state.force), tangential_force=largest * limit)
    here = history.advance(force=np.full(part.size, float(state.force)), tangential_force=part * limit).shift
    bracket = 2.0 * (1.0 - 0.5 * (largest - part)) ** (2.0 / 3.0) - (1.0 - largest) ** (2.0 / 3.0) - 1.0
    there = 3.0 * limit * (2.0 - NU) / (16.0 * float(state.radius) * SHEAR) * bracket
    return comparison("T/(mu F)", part, here, there, float(np.abs(there).max()))


def cycle() -> Comparison:
    """The energy of a cycle between +T and -T."""
    friction, state = pressed()
    limit, a = FRICTION * float(state.force), float(state.radius)
    part = np.linspace(0.2, 0.95, 16)
    there = (
        0.9
        * limit**2
        * (2.0 - NU)
        / (a * SHEAR)
        * (1.0 - (1.0 - part) ** (5.0 / 3.0) - 5.0 * part / 6.0 * (1.0 + (1.0 - part) ** (2.0 / 3.0)))
    )
    here = [float(friction.shear(state).cycle_energy(t * limit, "force")) for t in part]
    return comparison("T/(mu F)", part, here, there)


def lubkin() -> Comparison:
    """phi = (3 mu F/(4 pi G a^2)) (K - E) of the modulus sqrt(1 - c^2/a^2)."""
    friction, state = pressed()
    unit = 3.0 * FRICTION * float(state.force) / (4.0 * math.pi * SHEAR * float(state.radius) ** 2)
    twist = unit * np.geomspace(0.05, 6.0, 25)
    part = np.asarray(friction.twist(state).at_shift(twist).stick_radius) / float(state.radius)
    there = [unit * _k_less_e(c) for c in part]
    return comparison("phi in units of 3 mu F/(4 pi G a^2)", twist / unit, twist, there)


def _k_less_e(part: float) -> float:
    """K - E of the modulus sqrt(1 - part^2), by arithmetic and geometric means."""
    a, b, c, total, power = 1.0, part, math.sqrt(1.0 - part**2), 0.0, 0.5
    for _ in range(_MEANS):
        total += power * c**2
        a, b, c, power = 0.5 * (a + b), math.sqrt(a * b), 0.5 * (a - b), 2.0 * power
    return 0.5 * math.pi / a * total


RUBBING = (
    Check("mindlin", "partial slip", "Cattaneo 1938; Mindlin 1949", 1e-8, LIBRARY, mindlin),
    Check("unloading", "partial slip along a path", "Mindlin, Deresiewicz 1953", 1e-7, LIBRARY, unloading),
    Check("cycle", "energy of a cycle of partial slip", "Mindlin, Deresiewicz 1953; Johnson 1985, (7.57)", 1e-7, LIBRARY, cycle),
    Check("lubkin", "torsion with partial slip", "Lubkin 1951", 1e-8, LIBRARY, lubkin),
)
