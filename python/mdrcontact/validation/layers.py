# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that slide on their base, rest on springs or are under stress."""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial.legendre import leggauss

from ..material import RIGID, SMOOTH, Elastic
from ..medium import Interface, Layer, Layered
from .check import Array, Check, Comparison, comparison

_RANGE, _WAVES, _NODES = 40.0, 400, 40
"""Of the integral over waves, in 1/h, and the nodes of both rules."""


def smooth() -> Comparison:
    """A flat punch on a layer without friction on a rigid base: q(x) - (1/pi) int_-a^a G(x - t) q(t) dt = E* d with
    G(y) = int_0^inf (2 u + 1 - exp(-2 u))/(2 u + sinh(2 u)) cos(u y) du, h = 1."""
    a, material = np.array([0.1, 0.3, 1.0, 2.0, 4.0]), Elastic(3.0, 0.3)
    body = Layered([(material, 1.0)], SMOOTH)
    there = material.E / (1.0 - material.nu**2) * np.array([_line_load(radius) for radius in a])
    return comparison("a/h", a, body.stiffness(a), there)


def _line_load(a: float) -> float:
    """int_-a^a q dx under E* d = 1."""
    u, of_u = leggauss(_WAVES)
    u, of_u = 0.5 * _RANGE * (u + 1.0), 0.5 * _RANGE * of_u
    x, of_x = leggauss(_NODES)
    x, of_x = a * x, a * of_x
    waves = (2.0 * u + 1.0 - np.exp(-2.0 * u)) / (2.0 * u + np.sinh(2.0 * u))
    kernel = np.cos(np.subtract.outer(x, x)[..., None] * u) @ (of_u * waves) / math.pi
    return float(of_x @ np.linalg.solve(np.eye(_NODES) - kernel * of_x, np.ones(_NODES)))


def springs() -> Comparison:
    """Waves on a plate on springs, C = 1/(K + D k^4) with D = E h^3/(12 (1 - nu^2)), much longer than the plate is thick."""
    plate, stiffness = Elastic(1.0, 0.3), 1e-4
    k = np.geomspace(3e-3, 0.1, 13)
    body = Layered([Layer(plate, 1.0, interface=Interface(normal=stiffness, tangential=0.0))], RIGID)
    there = 1.0 / (stiffness + plate.E / (12.0 * (1.0 - plate.nu**2)) * k**4)
    return comparison("log10(k h)", np.log10(k), body.compliance(k), there)


def wrinkling() -> Comparison:
    """Stress (E_f/4) (3 E_s/E_f)^(2/3) and length of waves 2 pi h (E_f/(3 E_s))^(1/3) at which a stiff film wrinkles, E* each."""
    base, contrasts = Elastic(1.0, 0.5), np.geomspace(300.0, 3e5, 7)
    found = [Layered([(Elastic(contrast, 0.35), 1.0)], base).wrinkling() for contrast in contrasts]
    film, under = contrasts / (1.0 - 0.35**2), 1.0 / (1.0 - 0.5**2)
    stress, wave = -0.25 * film * (3.0 * under / film) ** (2.0 / 3.0), 2.0 * math.pi * (film / (3.0 * under)) ** (1.0 / 3.0)
    x = np.log10(contrasts)
    return _both(
        "log10 of the contrast: stress, then wave", x, [w.stress for w in found], stress, [w.wavelength for w in found], wave
    )


def _both(name: str, x: Array, one: list[float], of_one: Array, other: list[float], of_other: Array) -> Comparison:
    here = np.concatenate([one / of_one, other / of_other])
    return comparison(name, np.concatenate([x, x + x[-1]]), here, np.ones(here.size))


LAYERS = (
    Check("smooth", "flat punch on a layer that slides on its base", "Lebedev, Ufliand 1958, their equation", 1e-9,
          "rounding and tolerance of the library", smooth),
    Check("springs", "layer on springs", "Hertz 1884; Westergaard 1926, plates", 5e-4,
          "plate theory: no shear, constant thickness", springs),
    Check("wrinkling", "stress at which a film wrinkles", "Allen 1969; Chen, Hutchinson 2004", 2e-2,
          "formulas: for thin films much stiffer than the base", wrinkling),
)  # fmt: skip
