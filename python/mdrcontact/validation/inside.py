# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses inside the bodies."""

from __future__ import annotations

import math

import numpy as np

from .bodies import LIBRARY, NU, ball
from .check import Check, Comparison, comparison

_MISES, _TRESCA, _DEPTH = 1.60, 0.31, 0.48
"""p(0) over the yield stress at first yield, largest shear stress over p(0), and its depth over a, at nu = 0.3."""


def axis() -> Comparison:
    """s_rr and s_zz on the axis under Hertz's pressure."""
    contact = ball()
    state = contact.at_radius(0.1)
    z = np.linspace(0.05, 4.0, 25)
    inside = state.interior(np.zeros(z.size), z * 0.1)
    s_zz = -1.0 / (1.0 + z**2)
    s_rr = -(1.0 + NU) * (1.0 - z * np.arctan(1.0 / z)) + 0.5 / (1.0 + z**2)
    p = float(state.pressure(0.0))
    here = np.concatenate([np.asarray(inside.s_zz), np.asarray(inside.s_rr)]) / p
    return comparison("z/a (s_zz, then s_rr)", np.concatenate([z, z + 4.0]), here, np.concatenate([s_zz, s_rr]), 1.0)


def edge() -> Comparison:
    """s_rr on the surface, inside the contact and outside it, where it opens ring cracks."""
    contact = ball()
    state = contact.at_radius(0.1)
    r = np.concatenate([np.linspace(0.05, 0.99, 13), np.linspace(1.01, 3.0, 12)])
    inside = np.sqrt(np.maximum(1.0 - r**2, 0.0))
    there = (1.0 - 2.0 * NU) / (3.0 * r**2) * (1.0 - inside**3) - inside
    here = np.asarray(state.interior(0.1 * r, np.zeros(r.size)).s_rr) / float(state.pressure(0.0))
    return comparison("r/a", r, here, there, 1.0)


def sliding() -> Comparison:
    """s_xx on the surface along x in the sliding contact: the normal part and -(pi/8) (4 + nu) f p(0) x/a."""
    contact, friction = ball(), 0.4
    state = contact.at_radius(0.1)
    x = np.concatenate([-np.linspace(0.99, 0.05, 13), np.linspace(0.05, 0.99, 13)])
    inside = np.sqrt(1.0 - x**2)
    there = (1.0 - 2.0 * NU) / (3.0 * x**2) * (1.0 - inside**3) - inside - math.pi / 8.0 * (4.0 + NU) * friction * x
    angle = np.where(x < 0.0, math.pi, 0.0)
    field = state.interior(0.1 * np.abs(x), np.zeros(x.size), friction=friction, angle=angle)
    return comparison("x/a", x, np.asarray(field.s_rr) / float(state.pressure(0.0)), there, 1.0)


def first_yield() -> Comparison:
    """Three numbers of Hertz's contact that every textbook prints, to two or three digits."""
    contact = ball()
    state = contact.at_radius(0.1)
    found = state.critical().layers[0]
    p = float(state.pressure(0.0))
    here = [p / found.von_mises.value, found.tresca.value / p, found.tresca.z / 0.1]
    return comparison("p(0)/Y, tau/p(0), z/a", np.arange(3.0), here, [_MISES, _TRESCA, _DEPTH])


INSIDE = (
    Check("axis", "stresses inside, on the axis", "Huber 1904; Johnson 1985, (3.45)", 1e-8, LIBRARY, axis),
    Check("edge", "stress of ring cracks, on the surface", "Huber 1904; Johnson 1985, (3.43)", 1e-8, LIBRARY, edge),
    Check("sliding", "stresses under a sliding ball", "Hamilton 1983", 1e-8, LIBRARY, sliding),
    Check("yield", "load of first yield and its place", "Johnson 1985", 2e-2, "the printed digits", first_yield),
)
