# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic laws as functions of numba."""

from __future__ import annotations

import math
from typing import Any

import numba
import numpy as np

from ..plastic import PlasticLaw
from ._numba import BITS_OF_ONE, bits_of, first_touch, force_in, number_of
from ._plastic import EVEN, ODD, Numbers


def _polynomial(c: Any, t: float) -> Any:
    """mdr_law_polynomial_with_slope"""
    q = t * t
    even, odd = c[4] + q * c[6], c[5] + q * c[7]
    even_slope, odd_slope = even + q * c[6], odd + q * c[7]
    even, odd = c[2] + q * even, c[3] + q * odd
    even_slope, odd_slope = even + q * even_slope, odd + q * odd_slope
    even, odd = c[0] + q * even, c[1] + q * odd
    return even + t * odd, odd + (t + t) * (even_slope + t * odd_slope)


polynomial = numba.njit(_polynomial)


def _segment(t: float) -> Any:
    """mdr_plastic_segment"""
    x = t - (1.0 - t)
    q = x * x
    even, odd = EVEN[7], ODD[7]
    for i in range(6, -1, -1):
        even, odd = EVEN[i] + q * even, ODD[i] + q * odd
    return even + x * odd


segment = numba.njit(_segment)


def _imprint_force(radius: float, uniform: float, hertz: float, y: float) -> Any:
    """mdr_plastic_edge and mdr_plastic_force_at: F/E*, and a"""
    w = max((hertz + uniform) - radius * y, 0.0)
    b = uniform + 2.0 * hertz
    total = b + math.sqrt(max(b * b - 4.0 * hertz * w, 0.0))
    t, u = 2.0 / total * w, 2.0 / total * math.sqrt(w * (total - w))
    return u * t * (4.0 / 3.0 * hertz * (2.0 - t) + 2.0 * uniform * segment(t)), radius * u


imprint_force = numba.njit(_imprint_force)


def function(law: PlasticLaw) -> Any:
    """See `numba_plastic_function`."""
    of = Numbers(law)
    head, elastic = of.head, of.elastic
    intervals, elastic_rows, rows = np.array(elastic.intervals.tolist()), elastic.force.copy(), of.rows
    lowest, first, p, roots = (float(elastic.head[name]) for name in ("lowest", "first_force", "force_power", "force_roots"))
    yields, highest, scale, offset, modulus = (head[name] for name in ("yield", "highest", "scale", "offset", "modulus"))
    by_bits, edges = of.edges is None, np.zeros(2) if of.edges is None else of.edges
    shift = np.uint64(52 - int(head["bits"]))
    half = np.uint64(1) << (shift - np.uint64(1))

    @numba.njit  # type: ignore[untyped-decorator]
    def place(d: float) -> Any:
        if by_bits:
            y = scale * (d - yields) + offset
            of_y = bits_of(y)
            t = y - number_of((of_y & ~(half + half - np.uint64(1))) | half)
            return int((of_y - BITS_OF_ONE) >> shift), t, scale
        panel = min(max(int(np.searchsorted(edges, d)) - 1, 0), len(edges) - 2)
        width = edges[panel + 1] - edges[panel]
        return panel, ((d - edges[panel]) + (d - edges[panel + 1])) / width, 2.0 / width

    @numba.njit  # type: ignore[untyped-decorator]
    def step(d: float, deepest: float) -> Any:
        if not (abs(d) <= 1.7976931348623157e308 and 0.0 <= deepest <= highest and d <= highest):
            return math.nan, math.nan, math.nan
        kept = d if d > deepest else deepest
        if d >= deepest or deepest <= yields:
            if d > yields:
                panel, t, rate = place(d)
                force, slope = polynomial(rows[panel, :8], t)
                return force, rate * slope, kept
            if d <= 0.0:
                return 0.0, 0.0, kept
            if d < lowest:
                force, slope = first_touch(lowest, first, p, int(roots), d)
                return force, slope, kept
            force, slope = force_in(intervals, elastic_rows, 0, d)
            return force, slope, kept
        panel, t, _ = place(deepest)
        force, _ = polynomial(rows[panel, :8], t)
        radius, _ = polynomial(rows[panel, 8:16], t)
        uniform, _ = polynomial(rows[panel, 16:], t)
        uniform = uniform if uniform > 0.0 else 0.0
        hertz = 0.75 / modulus * force - 1.1780972450961724 * uniform
        over, edge = imprint_force(radius, uniform, hertz, deepest - d)
        return modulus * over, 2.0 * modulus * edge, kept

    return step
