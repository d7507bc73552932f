# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects made from contacts: compiled laws, fits, effective moduli of composites."""

from __future__ import annotations

import math

import numpy as np

from .. import lateral
from ..instruments import fitting
from ..law import ContactLaw
from ..material import Elastic
from ..medium import Homogeneous
from ..profile import Paraboloid
from .bodies import FRICTION, LIBRARY, MODULUS, NU, RADIUS, SHEAR, ball, hertz_force, pressed
from .check import Check, Comparison, comparison

_TOLERANCE = 1e-9
"""Default tolerance of laws."""


def law() -> Comparison:
    """F(d) and U(d) = (2/5) F d of a compiled law."""
    made = ContactLaw(ball(), 0.1)
    d = np.geomspace(1e-5, 1e-1, 41)
    x = np.concatenate([np.log10(d), np.log10(d) + 5.0])
    here = np.concatenate([np.asarray(made.force(d)), np.asarray(made.energy(d))])
    return comparison("log10(d): F, then U", x, here, np.concatenate([hertz_force(d), 0.4 * hertz_force(d) * d]))


def fit_hertz() -> Comparison:
    """Modulus and offset of the depth, from the closed form."""
    d = np.linspace(0.002, 0.1, 60)
    offset = 0.001
    data = fitting.ForceDepth(d, hertz_force(d - offset), relative_sd=0.01)
    start = Homogeneous(Elastic(1.0, NU))
    found = fitting.fit(data, Paraboloid(RADIUS), start, ["E", "depth_offset"]).estimates
    here = [found["E"] / (1.0 - NU**2) / MODULUS, found["depth_offset"] / offset]
    return comparison("E, offset", np.arange(2.0), np.abs(here), np.ones(2))


def fit_jkr() -> Comparison:
    """Modulus and work of adhesion, from the closed form between pull-off and four times that radius."""
    gamma = 1e-3
    a = np.linspace(0.16, 0.5, 60)
    d = a**2 / RADIUS - np.sqrt(2.0 * math.pi * a * gamma / MODULUS)
    F = 4.0 * MODULUS * a**3 / (3.0 * RADIUS) - np.sqrt(8.0 * math.pi * gamma * MODULUS * a**3)
    data = fitting.ForceDepth(d, F, sd=1e-3, branch="unloading")
    free = {"E": 2.0, "work_of_adhesion": 2e-3}
    found = fitting.fit(data, Paraboloid(RADIUS), Homogeneous(Elastic(2.0, NU)), free).estimates
    here = [found["E"] / (1.0 - NU**2) / MODULUS, found["work_of_adhesion"] / gamma]
    return comparison("E, work of adhesion", np.arange(2.0), here, np.ones(2))


def friction_law() -> Comparison:
    """T(s) of a compiled law with friction as a contact is first sheared."""
    friction, state = pressed()
    limit, largest = FRICTION * float(state.force), 0.02
    made = ContactLaw(ball(), largest, friction=friction, sliders=32)
    part = np.linspace(0.05, 0.95, 19)
    shift = 3.0 * limit * (2.0 - NU) / (16.0 * float(state.radius) * SHEAR) * (1.0 - (1.0 - part) ** (2.0 / 3.0))
    memory = made.contacts(part.size)
    made.advance(memory, np.full(part.size, float(state.force)), np.zeros((part.size, 2)))
    found = made.advance(memory, np.full(part.size, float(state.force)), np.column_stack([shift, np.zeros(part.size)]))
    return comparison("T/(mu F)", part, np.abs(found[:, 0]) / limit, part, 1.0)


def instrumented() -> Comparison:
    """E_r and H of an indentation by a paraboloid, of whose contact depth 3/4 F/S is exactly half of the depth."""
    d = np.linspace(0.002, 0.1, 25)
    force = hertz_force(d)
    found = fitting.oliver_pharr(fitting.StiffnessDepth(d, force, 1.5 * force / d), Paraboloid(RADIUS))
    hardness = force / (math.pi * RADIUS * d)
    here = np.concatenate([found.reduced_modulus / MODULUS, found.hardness / hardness])
    return comparison("d: E_r, then H", np.concatenate([d, d + 0.1]), here, np.ones(here.size))


def gao() -> Comparison:
    """A layer as an inclusion: G by the weight I0, nu by I1 of h/a."""
    film, base = Elastic(5.0, 0.25), Elastic(2.0, 0.35)
    a = np.geomspace(0.05, 20.0, 21)
    xi = 1.0 / a
    root = np.log((1.0 + xi**2) / xi**2)
    arc = 2.0 / math.pi * np.arctan(xi)
    first = arc + xi / math.pi * root
    shears = [m.E / (2.0 * (1.0 + m.nu)) for m in (film, base)]
    nu = 0.3
    zeroth = arc + ((1.0 - 2.0 * nu) * xi * root - xi / (1.0 + xi**2)) / (2.0 * math.pi * (1.0 - nu))
    there = 2.0 * (shears[1] + (shears[0] - shears[1]) * zeroth) / (1.0 - base.nu - (film.nu - base.nu) * first)
    body = lateral.Shapes(base, [lateral.Layer(0.0, 1.0, film)], reference_nu=nu)
    return comparison("a/h", a, body.modulus(0.0, 0.0, a), there)


PRODUCTS = (
    Check("law", "compiled law, force and energy", "Hertz 1882", _TOLERANCE, "tolerance of the law", law),
    Check("fit-hertz", "fit of modulus and offset", "Hertz 1882", 1e-6, LIBRARY, fit_hertz),
    Check("fit-jkr", "fit of modulus and work of adhesion", "Johnson, Kendall, Roberts 1971", 1e-6, LIBRARY, fit_jkr),
    Check(
        "friction-law",
        "compiled law with friction, 32 sliders",
        "Cattaneo 1938; Mindlin 1949",
        5e-3,
        "error bound that the law states",
        friction_law,
    ),
    Check("oliver-pharr", "modulus and hardness of an indentation", "Hertz 1882; Oliver, Pharr 1992", 1e-6, LIBRARY, instrumented),
    Check("gao", "effective modulus of a composite, a layer", "Gao, Chiu, Lee 1992", 1e-5, "tolerance of the quadrature", gao),
)
