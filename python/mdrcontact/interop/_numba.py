# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws as functions of numba: the inline functions of mdrcontact_law.h again, bitwise identical."""

from __future__ import annotations

import math
from typing import Any

import numba
import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from ..law import ContactLaw
from ._cells import BELOW, OPEN, cells_of, tangent_of


@intrinsic  # type: ignore[untyped-decorator]
def bits_of(_context: Any, number: Any) -> Any:
    """The bits of a number."""
    return types.uint64(types.float64), lambda _, builder, __, given: builder.bitcast(given[0], ir.IntType(64))


@intrinsic  # type: ignore[untyped-decorator]
def number_of(_context: Any, bits: Any) -> Any:
    """The number of some bits."""
    return types.float64(types.uint64), lambda _, builder, __, given: builder.bitcast(given[0], ir.DoubleType())


def _power(x: float, p: float) -> float:
    """mdr_law_power"""
    m, e = math.frexp(x)
    if m < 0.70710678118654757:
        m, e = 2.0 * m, e - 1
    z = (m - 1.0) / (m + 1.0)
    q = z * z
    q2 = q * q
    even = 2.8853900817779268 + q2 * (0.5770780163541355 + q2 * (0.32059873801756367 + q2 * 0.221189987214124))
    odd = 0.961796693925976 + q2 * (0.412198583898078 + q2 * (0.2623236397004895 + q2 * 0.21087079476015172))
    t = p * (e + z * (even + q * odd))
    if t <= -1100.0:
        return 0.0
    n = int(t - 0.5)
    f = t - n
    g = f * f
    whole = 1.0 + g * (0.24022650695910075 + g * (0.009618129107618665 + g * (0.00015403530424776529
                  + g * (1.3215451633221434e-06 + g * 7.070977866508138e-09))))  # fmt: skip
    part = 0.6931471805599462 + g * (0.05550410866465167 + g * (0.0013333558200794592
                  + g * (1.5252672924850737e-05 + g * 1.0205905413765595e-07)))  # fmt: skip
    return math.ldexp(whole + f * part, n)


power = numba.njit(_power)


def _first_touch(lowest: float, first: float, p: float, roots: int, d: float) -> Any:
    """mdr_law_first_touch"""
    share = d / lowest
    if roots == 0:
        force = first * power(share, p)
        return force, p * force / d
    root = math.sqrt(share)
    bend = 2.0 * p - roots
    straight, tilt = 1.0 - bend, bend * root
    rise = first * root if roots % 2 else first
    for _ in range(roots // 2 - 1):
        rise *= share
    return rise * share * (straight + tilt), rise / lowest * (0.5 * roots * straight + (0.5 * roots + 0.5) * tilt)


first_touch = numba.njit(_first_touch)
BITS_OF_ONE = np.uint64(0x3FF0000000000000)


def _force_in(intervals: Any, rows: Any, i: int, d: float) -> Any:
    """mdr_law_state_in, of which F and dF/dd"""
    of = intervals[i]
    scale, offset, last_y, is_root, origin, side = of[2], of[3], of[4], of[5], of[6], of[7]
    smallest, bits, first = of[8], of[9], of[10]
    root = math.sqrt(max(side * (d - origin), 0.0))
    y = min(max(scale * (root if is_root != 0.0 else d) + offset, 1.0), last_y)
    shift = np.uint64(52 - int(bits))
    half = np.uint64(1) << (shift - np.uint64(1))
    of_y = bits_of(y)
    t = y - number_of((of_y & ~(half + half - np.uint64(1))) | half)
    c = rows[int((of_y - BITS_OF_ONE) >> shift) + int(first)]
    q = t * t
    even, odd = c[4] + q * c[6], c[5] + q * c[7]
    even_slope, odd_slope = even + q * c[6], odd + q * c[7]
    even, odd = c[2] + q * even, c[3] + q * odd
    even_slope, odd_slope = even + q * even_slope, odd + q * odd_slope
    even, odd = c[0] + q * even, c[1] + q * odd
    rate = side * (0.5 * scale / max(root, smallest)) if is_root != 0.0 else scale
    return even + t * odd, rate * (odd + (t + t) * (even_slope + t * odd_slope))


force_in = numba.njit(_force_in)


def function(law: ContactLaw, branch: str) -> Any:
    """See `numba_function`."""
    arrays = law.arrays()
    edges, cell_interval = cells_of(arrays, branch)
    highest, last_force, last_slope, _ = tangent_of(arrays, lambda d: (law.at_depth(d, branch), 0.0))
    intervals, rows = np.array(arrays.intervals.tolist()), arrays.force.copy()
    direct = int(arrays.head["direct"])
    first_direct, last_direct = (intervals[direct, 0], intervals[direct, 1]) if direct >= 0 else (1.0, -1.0)
    apart = float(arrays.head[f"open_{branch}"])
    lowest, first, p, roots = (float(arrays.head[name]) for name in ("lowest", "first_force", "force_power", "force_roots"))

    def force_and_slope(d: float) -> Any:
        if first_direct <= d <= last_direct:
            return force_in(intervals, rows, direct, d)
        if -1.7976931348623157e308 <= d <= apart:
            return 0.0, 0.0
        if not abs(d) <= 1.7976931348623157e308:
            return math.nan, math.nan
        if d > highest:
            return last_force + last_slope * (d - highest), last_slope
        i = cell_interval[np.searchsorted(edges, d)]
        if i == OPEN:
            return 0.0, 0.0
        if i == BELOW:
            return first_touch(lowest, first, p, int(roots), d)
        return force_in(intervals, rows, i, d)

    return numba.njit(force_and_slope)
