# SPDX-License-Identifier: GPL-3.0-or-later
"""A branch of a compiled law as cells of the depth: which interval is valid in each."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._choices import code
from .._law_arrays import LawArrays
from ..loop import BRANCHES

SMALLEST = float(np.finfo(float).tiny)
"""compilers of devices take smaller numbers for 0"""
OPEN, BELOW = -1, -2
"""Instead of an interval: separated bodies; between initial contact and the compiled range."""


class Cells(NamedTuple):
    """The cell of a depth d is that of the first edge that is not below d."""

    edges: NDArray[np.float64]
    """ends of the cells, which belong to the cell below them"""
    interval: NDArray[np.int64]
    """of each cell, and of what lies beyond the last edge"""


def cells_of(arrays: LawArrays, branch: str) -> Cells:
    """The cells of a branch, "loading" or "unloading"."""
    loading = code("branch", branch, BRANCHES) == BRANCHES["loading"]
    just_below = np.nextafter(np.r_[arrays.segments["lowest"], 0.0], -np.inf)
    just_below[np.abs(just_below) < SMALLEST] = -SMALLEST
    edges = np.unique(np.r_[just_below, 0.0, arrays.intervals["highest"]])
    edges = edges[edges <= arrays.head["highest"]]
    interval = [_interval_at(arrays, loading, d) for d in edges]
    return Cells(edges, np.array([*interval, interval[-1]]))


def _interval_at(arrays: LawArrays, loading: bool, d: float) -> int:
    """The interval that is valid at a depth: on loading that of the smallest contact, on unloading of the largest."""
    on = [segment for segment in arrays.segments if segment["lowest"] <= d <= segment["highest"] and not (loading and d < 0.0)]
    if not on:
        return OPEN if d <= 0.0 or arrays.head["adhesive"] else BELOW
    segment = on[0] if loading else on[-1]
    candidates = range(int(segment["first"]), int(segment["last"]) + 1)
    return next((i for i in candidates if d <= arrays.intervals[i]["highest"]), candidates[-1])


def tangent_of(arrays: LawArrays, at: Any) -> tuple[float, float, float, float]:
    """The largest depth, and F, dF/dd and U there; NaN where the law does not continue beyond it. at : state and energy at a
    depth."""
    highest = float(arrays.head["highest"])
    if not arrays.head["continues"]:
        return highest, np.nan, np.nan, np.nan
    state, energy = at(highest)
    return highest, float(state.force), float(state.slope), float(energy)
