# SPDX-License-Identifier: GPL-3.0-or-later
"""Quadratures and closed forms that share nothing with the library."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy import integrate, special

import mdrcontact as mdr

Array = Any


def disc(f: Callable[[Array], Array], a: float, corner: float | None = None, n: int = 241) -> float:
    """int_0^a f dx by tanh-sinh in the angle of x = a sin(angle): f may be a power at the axis and at the rim, with a corner."""
    ends = [0.0, math.pi / 2] if corner is None or corner >= a else [0.0, math.asin(corner / a), math.pi / 2]
    total = 0.0
    for low, high in zip(ends[:-1], ends[1:], strict=True):
        t = np.linspace(-2.8 if low else -3.6, 2.8, n)
        share = 1.0 / (1.0 + np.exp(-math.pi * np.sinh(t)))
        weight = math.pi * np.cosh(t) * share * (1.0 - share) * (t[1] - t[0])
        angle = low + (high - low) * share
        x = np.minimum(a * np.sin(angle), a)
        total += (high - low) * float(np.sum(weight * f(x) * a * np.cos(angle)))
    return total


_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(40)


def panels(f: Callable[[Array], Array], ends: Sequence[float]) -> float:
    """int f dx by 40 points of Gauss and Legendre a panel; f is smooth in each."""
    total = 0.0
    for low, high in zip(ends[:-1], ends[1:], strict=True):
        half = 0.5 * (high - low)
        total += half * float(np.sum(_WEIGHTS * f(low + half * (1.0 + _NODES))))
    return total


def abel(slope: Callable[[Array], Array], x: float, ends: Sequence[float] = ()) -> float:
    """g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr, in panels between the radii `ends` where f' varies, a power at the axis."""
    inner = [t**0.25 for t in sorted({0.0, *(math.asin(r / x) for r in ends if 0.0 < r < x), math.pi / 2})]
    return x * panels(lambda t: slope(x * np.sin(t**4)) * 4.0 * t**3, inner)


def scales_of(size: float, largest: float) -> list[float]:
    """Radii about `size`, by factors of 2, up to the largest: panels for what varies there."""
    count = max(1, math.ceil(math.log2(largest / size)) + 8)
    return [size * 2.0 ** (k - 8) for k in range(count + 1)]


def power_law_contact(n: float, c: float, modulus: float, a: Array) -> tuple[Array, Array]:
    """d and F of f = c r^n on a half-space: d = kappa c a^n, F = 2 E* kappa c n/(n + 1) a^(n + 1) (Galin 1946)."""
    kappa = math.sqrt(math.pi) * n / 2.0 * math.exp(special.gammaln(n / 2.0) - special.gammaln((n + 1.0) / 2.0))
    return kappa * c * a**n, 2.0 * modulus * kappa * c * n / (n + 1.0) * a ** (n + 1.0)


def reduced(material: mdr.Elastic) -> float:
    """E/(1 - nu^2)."""
    return material.E / (1.0 - material.nu**2)


def shear(material: mdr.Elastic) -> float:
    """G."""
    return 0.5 * material.E / (1.0 + material.nu)


def quad(f: Callable[[float], float], low: float, high: float, points: Sequence[float] = ()) -> float:
    """SciPy's adaptive quadrature between break points."""
    ends = [low, *sorted(p for p in points if low < p < high), high]
    return sum(integrate.quad(f, u, v, epsabs=0.0, epsrel=1e-12, limit=200)[0] for u, v in zip(ends[:-1], ends[1:], strict=True))


def slopes(f: Callable[[float], Array], x: float, step: float) -> Array:
    """f'(x) by differences of sixth order."""
    weights = ((1, 45.0), (2, -9.0), (3, 1.0))
    return sum(w * (f(x + k * step) - f(x - k * step)) for k, w in weights) / (60.0 * step)
