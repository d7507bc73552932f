# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear by Archard's law."""

from __future__ import annotations

import math

import numpy as np

from ..contact import Contact
from ..profile import FlatPunch
from ..wear import Wear
from .bodies import BODY, LIBRARY, MODULUS, RADIUS, ball
from .check import Check, Comparison, comparison

_EIGENVALUE = 1.1577738837


def limit() -> Comparison:
    """Final force of fretting at constant depth: 2 E* (d c - c^3/(3 R)) that a stick zone of radius c keeps."""
    contact, a, c = ball(), 0.1, np.linspace(0.005, 0.095, 10)
    worn, state = Wear(contact, 1.0), contact.at_radius(a)
    here = [float(worn.limit(state, radius).state.force) for radius in c]
    return comparison("c/a", c / a, here, 2.0 * MODULUS * (a**2 / RADIUS * c - c**3 / (3.0 * RADIUS)))


def worn_profile() -> Comparison:
    """The profile there: f(r) = (2/pi) ((r^2 arcsin(c/r) - c sqrt(r^2 - c^2))/(2 R) + (a^2/R) arccos(c/r))."""
    contact, a, c = ball(), 0.1, 0.04
    end = Wear(contact, 1.0).limit(contact.at_radius(a), c)
    r = c + np.geomspace(1e-7 * c, 0.999 * float(end.outer_radius) - c, 33)
    there = (r**2 * np.arcsin(c / r) - c * np.sqrt(r**2 - c**2)) / (2.0 * RADIUS) + a**2 / RADIUS * np.arccos(c / r)
    return comparison("log10((r - c)/c)", np.log10(r / c - 1.0), end.profile.height(r), 2.0 / math.pi * there, a**2 / RADIUS)


def archard() -> Comparison:
    """The worn volume V = k F s under a constant force."""
    contact = ball()
    state = contact.at_radius(0.1)
    force, s, k = float(state.force), np.geomspace(1e-3, 1e-1, 9), 1.7
    states, _ = Wear(contact, k).advance(s, force=force)
    return comparison("s", s, states.worn_volume, k * force * s)


def running_in() -> Comparison:
    """Half of the first eigenvalue of (-Laplace)^(1/2) on (-1, 1): how fast a flat punch at constant depth loses its load."""
    radii = np.array([0.5, 1.0, 2.0])
    punches = [Wear(Contact(FlatPunch(a), BODY), 1.0) for a in radii]
    here = [a / (MODULUS * punch.running_in_length("depth")) for a, punch in zip(radii, punches, strict=True)]
    return comparison("a", radii, here, np.full(3, 0.5 * _EIGENVALUE))


WEARING = (
    Check("limit", "force where fretting ends", "Popov 2014; Dimaki et al. 2014", 1e-8, LIBRARY, limit),
    Check("worn", "worn profile where fretting ends", "Popov 2014; Dimaki et al. 2014", 1e-10, LIBRARY, worn_profile),
    Check("running-in", "running-in length of a flat punch", "Kwasnicki 2012, eigenvalue", 1e-9, "the printed digits",
          running_in),
    Check("archard", "worn volume of a sliding ball", "Archard 1953", 5e-4, "80 intervals of the library", archard),
)  # fmt: skip
