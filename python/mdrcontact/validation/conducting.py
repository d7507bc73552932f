# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat and current through the contact."""

from __future__ import annotations

import math

import numpy as np

from ..conduction import Conduction
from ..conductor import Conductor, LayeredConductor
from .bodies import LIBRARY, ROUNDING, ball
from .check import Check, Comparison, comparison


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


def heat() -> Comparison:
    """The surface under a heat flux q (1 - r^2/a^2)^(1/2) into both bodies: T = (pi/4) (q a/(S_0 + S_1)) (1 - r^2/(2 a^2))."""
    contact, mu, speed = ball(), 0.3, 0.5
    state = contact.at_radius(0.1)
    found = Conduction(Conductor(2.0), Conductor(5.0)).friction_heat(contact, state, mu, speed)
    r = np.linspace(0.0, 0.95, 11)
    flux = mu * speed * float(contact.pressure(0.0, state))
    there = 0.25 * math.pi * flux * 0.1 / 7.0 * (1.0 - 0.5 * r**2)
    return comparison("r/a", r, found.temperature(0.1 * r, np.zeros(r.size)), there)


CONDUCTING = (
    Check("holm", "conductance of a spot", "Holm 1967", ROUNDING, LIBRARY, holm),
    Check("dryden", "spot on a layered conductor, thick layer", "Dryden 1983", 3e-3, "the limit's next term, (a/H)^2", dryden),
    Check("heat", "temperature by the heat of friction", "Carslaw, Jaeger 1959; Hertz 1882", 1e-8, LIBRARY, heat),
)
