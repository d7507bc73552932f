# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat and current through the contact."""

from __future__ import annotations

import math

import numpy as np

from ..conduction import Conduction, Conductor, LayeredConductor
from .bodies import LIBRARY, ROUNDING, ball
from .check import Check, Comparison, comparison


def holm() -> Comparison:
    """Two half-spaces: G = 4 a/(1/S_0 + 1/S_1)."""
    a = np.geomspace(1e-3, 1e3, 13)
    there = 4.0 * a / (1.0 / 2.0 + 1.0 / 5.0)
    return comparison("a", a, Conduction(Conductor(2.0), Conductor(5.0)).at_radius(a).conductance, there)


def dryden() -> Comparison:
    """A layer much thicker than the contact area: 1/G = 1/(4 S_0 a) + ln((1 + S_0/S_1)/2)/(2 pi S_0 H)."""
    a, first, second = np.array([0.01, 0.02, 0.03]), 2.0, 0.1
    spot = Conduction(LayeredConductor(((Conductor(first), 1.0),), Conductor(second))).at_radius(a)
    there = math.log(0.5 * (1.0 + first / second)) / (2.0 * math.pi * first) * np.ones(a.size)
    return comparison("a/H", a, 1.0 / np.asarray(spot.conductance) - 1.0 / (4.0 * first * a), there)


def heat() -> Comparison:
    """The surface under a heat flux q (1 - r^2/a^2)^(1/2) into both bodies: T = (pi/4) (q a/(S_0 + S_1)) (1 - r^2/(2 a^2))."""
    contact, mu, speed = ball(), 0.3, 0.5
    state = contact.at_radius(0.1)
    found = Conduction(Conductor(2.0), Conductor(5.0)).friction_heat(state, mu, speed)
    r = np.linspace(0.0, 0.95, 11)
    flux = mu * speed * float(state.pressure(0.0))
    there = 0.25 * math.pi * flux * 0.1 / 7.0 * (1.0 - 0.5 * r**2)
    return comparison("r/a", r, found.temperature(0.1 * r, np.zeros(r.size)), there)


def moving() -> Comparison:
    """The largest temperature under a source q (1 - r^2/a^2)^(1/2) that moves at any speed: 2.32 qm a/(S sqrt(pi (1.234 + Pe))),
    Pe = v a/(2 D), qm its mean."""
    contact, sigma, capacity = ball(), 2.0, 3.0
    state, speed = contact.at_radius(0.1), np.geomspace(0.1, 1e3, 13)
    body = Conduction(Conductor(sigma, None, capacity))
    heats = [body.friction_heat(state, 0.3, 1.0, "moving", v) for v in speed]
    peclet = 0.5 * speed * 0.1 * capacity / sigma
    there = 2.32 * heats[0].total / (math.pi * 0.1 * sigma * np.sqrt(math.pi * (1.234 + peclet)))
    return comparison("log10(Pe)", np.log10(peclet), [float(heat.largest or 0.0) for heat in heats], there)


def step() -> Comparison:
    """The flux after a step of potential, over the steady one: 0.7854 + 0.8862/sqrt(t) + 0.2146 exp(-0.7823/sqrt(t)), with t in
    units of a^2/(4 D)."""
    sigma, capacity, t = 2.0, 3.0, np.geomspace(1e-3, 1e3, 25)
    here = Conduction(Conductor(sigma, None, capacity)).step(0.25 * t * capacity / sigma, 1.0)
    there = 0.7854 + 0.8862 / np.sqrt(t) + 0.2146 * np.exp(-0.7823 / np.sqrt(t))
    return comparison("log10(4 D t/a^2)", np.log10(t), np.asarray(here) / (4.0 * sigma), there)


CONDUCTING = (
    Check("holm", "conductance of a circular contact area", "Holm 1967", ROUNDING, LIBRARY, holm),
    Check("dryden", "constriction resistance of a thick layer", "Dryden 1983", 3e-3, "next term of the limit, (a/H)^2", dryden),
    Check("heat", "temperature by frictional heat", "Carslaw, Jaeger 1959; Hertz 1882", 1e-8, LIBRARY, heat),
    Check("moving", "largest temperature under a moving source", "Tian, Kennedy 1994, fit", 2e-2, "fit", moving),
    Check("step", "flux after a step of potential", "Shoup, Szabo 1982, fit", 8e-3, "fit, stated as 6e-3", step),
)
