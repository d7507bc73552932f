# SPDX-License-Identifier: GPL-3.0-or-later
"""The deviation of a fitted model from its data, as a part of what is measured."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import _layout
from .data import Data

Array = NDArray[np.float64]

_STRETCHES = 40
"""Equal parts of the way along the curve, so that a long baseline counts no more than the contact behind it."""
LARGE = 0.05
"""Deviation, relative to the force, beyond which a model misses its data."""
_LEAST = 0.01
"""Percent that people write."""
SMALL = 0.01
"""Less is not worth a warning."""


class Misfit(NamedTuple):
    """Departure of a fitted model from its data, from `FitResult.misfit`.

    The numbers are relative to the largest force; of stiffnesses and moduli relative to each reading.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 40)
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), film).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth, force)
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)), ["E"])
    >>> print(f"{result.misfit.rms:.4f} {result.misfit.largest:.4f}")
    0.0150 0.0265
    """

    rms: float
    """root mean square of what neighbouring readings share along the curve: residuals without noise [1]"""
    largest: float
    """largest mean over a fortieth of the curve [1]"""
    at: float
    """depth, radius, time or frequency of the largest mean"""
    noise: float
    """root mean square of what changes from reading to reading [1]"""

    @property
    def whole(self) -> float:
        """Root mean square of noise and departure together [1]."""
        return math.hypot(self.rms, self.noise)


def measure_misfit(data: Data, fitted: Array, offset: float = 0.0) -> Misfit:
    """offset : that of the readings y, which is no part of them."""
    order = data.order()
    x, y, model = data.x[order], data.y[order] - offset, fitted[order] - offset
    branch = np.zeros(len(x), np.int32) if data.branch is None else data.branch[order]
    ends = _stretches(x, model, branch)
    sizes = np.diff(ends)
    # not the largest reading, which noise makes larger
    means = np.abs(np.add.reduceat(y, ends[:-1]) / sizes)
    largest = float(np.maximum(means.max(), np.abs(model).max()))
    if not largest > 0.0:
        return Misfit(math.nan, math.nan, math.nan, math.nan)
    each = data.y_name in ("stiffness", "modulus") and data.code != _layout.FIT_DYNAMIC_STIFFNESS and bool((model > 0.0).all())
    left = (y - model) / (model if each else largest)
    same = np.diff(branch) == 0
    # von Neumann: successive differences do not see what neighbours share
    noise = math.sqrt(0.5 * float(np.mean(np.diff(left)[same] ** 2))) if same.any() else 0.0
    noise = min(noise, math.sqrt(float(np.mean(left**2))))
    means = np.add.reduceat(left, ends[:-1]) / sizes
    rms = math.sqrt(max(float(np.mean(means**2 - noise**2 / sizes)), 0.0))
    worst = int(np.argmax(np.abs(means)))
    return Misfit(rms, float(abs(means[worst])), float(x[ends[worst] : ends[worst + 1]].mean()), noise)


def _stretches(x: Array, y: Array, branch: NDArray[np.int32]) -> NDArray[np.intp]:
    """Starts of equal parts of the path along the curve, and the end; each part lies within one branch."""
    steps = np.hypot(np.diff(x) / max(float(np.ptp(x)), 1e-300), np.diff(y) / max(float(np.ptp(y)), 1e-300))
    way = np.concatenate([[0.0], np.cumsum(steps)])
    part = np.minimum(_STRETCHES * way / max(way[-1], 1e-300), _STRETCHES - 1).astype(int)
    begins = np.flatnonzero((np.diff(part) != 0) | (np.diff(branch) != 0)) + 1
    return np.concatenate([[0], begins, [len(x)]]).astype(np.intp)


def percent(share: float) -> str:
    """A part of one as people write it: two digits, no power of ten."""
    part = 100.0 * share
    if not math.isfinite(part):
        return f"{part} %"
    if part < _LEAST:
        return f"less than {_LEAST} %" if part > 0.0 else "0 %"
    rounded = float(f"{part:.2g}")
    return f"{rounded:.0f} %" if rounded >= 10.0 else f"{rounded:.2g} %"
