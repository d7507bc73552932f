# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers that are known in two ways, for every indenter on every medium."""

import functools
import math

import numpy as np
import pytest

import mdrcontact as mdr

HARD, SOFT = mdr.Elastic(8.0, 0.25), mdr.Elastic(1.0, 0.4)
Z, E = [0.0, 0.7, 1.5], [1.0, 0.02, 3.0]

TIPS = {
    "paraboloid": lambda: mdr.Paraboloid(2.0),
    "sphere": lambda: mdr.Sphere(2.0),
    "cone": lambda: mdr.Cone(0.3),
    "power": lambda: mdr.PowerLaw(3.0, 0.2),
    "rounded": lambda: mdr.RoundedCone(0.2, 0.3),
}
MEDIA = {
    "homogeneous": lambda: mdr.Homogeneous(SOFT),
    "exact": lambda: mdr.Coated(HARD, 0.5, SOFT),
    "gao": lambda: mdr.Coated(HARD, 0.5, SOFT, "gao"),
    "graded": lambda: mdr.Graded(Z, E, 0.3),
    "graded-series": lambda: mdr.Graded(Z, E, 0.3, "gao-series"),
    "power-graded": lambda: mdr.PowerLawGraded(1.0, 1.0, 0.3, 0.3),
    "table": lambda: mdr.TabulatedMedium([0.1, 0.3, 0.6, 2.0], [1.0, 1.5, 1.7, 3.0]),
    "function": lambda: mdr.CallableMedium(lambda a: 1.0 + 1.0 / (1.0 + ((a - 0.5) / 0.01) ** 2), 0.1, 2.0),
    "pair": lambda: mdr.Pair(mdr.Coated(HARD, 0.5, SOFT), mdr.Homogeneous(HARD)),
}
BREAKS = np.array([0.1, 0.3, 0.4, 0.47, 0.49, 0.5, 0.51, 0.53, 0.6])
X, W = np.polynomial.legendre.leggauss(40)


@functools.cache
def _medium(name):
    return MEDIA[name]()


def _integral(function, low, high, breaks=()):
    """Gauss-Legendre between breaks, by the square of the distance from both ends: roots there are smooth."""
    edges = [low, *sorted(b for b in breaks if low < b < high), high]
    total = 0.0
    for left, right in zip(edges[:-1], edges[1:], strict=True):
        angle = 0.25 * math.pi * (1.0 + X)
        x = left + (right - left) * np.sin(angle) ** 2
        total += np.sum(function(x) * np.sin(2.0 * angle) * W) * 0.25 * math.pi * (right - left)
    return total


@pytest.mark.parametrize("medium", MEDIA)
@pytest.mark.parametrize("tip", TIPS)
def test_force_stiffness_and_loads(tip, medium):
    contact = mdr.Contact(TIPS[tip](), _medium(medium))
    a = 0.72
    state = contact.at_radius(a)
    breaks = [*BREAKS, 0.2]
    # F = 2 int q dx
    assert _integral(lambda x: 2.0 * state.line_load(x), 0.0, a, breaks) == pytest.approx(state.force, rel=1e-9)
    # F = int p dA
    assert _integral(lambda r: 2.0 * math.pi * r * state.pressure(r), 0.0, a, breaks) == pytest.approx(state.force, rel=2e-8)
    # dF/dd = k, by differences of fourth order
    h = 1e-3 * a
    near = contact.at_radius(a + h * np.array([-2.0, -1.0, 1.0, 2.0]))
    weights = np.array([1.0, -8.0, 8.0, -1.0])
    assert weights @ near.force / (weights @ near.depth) == pytest.approx(state.stiffness, rel=1e-8)
    # F(d2) - F(d1) = int k dd, over depths
    low = contact.at_radius(0.62)
    gained = _integral(lambda d: contact.at_depth(d).stiffness, low.depth, state.depth)
    assert gained == pytest.approx(state.force - low.force, rel=1e-9)
