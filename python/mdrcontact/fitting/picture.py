# SPDX-License-Identifier: GPL-3.0-or-later
"""Data, fit and residuals as a figure."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._files import replace
from ..errors import MDRError
from ..problem.units import practical
from .data import Data
from .quantities import dimension_of_data

Array = NDArray[np.float64]

_AXES = {
    "depth": "indentation depth",
    "radius": "contact radius",
    "force": "force",
    "stiffness": "contact stiffness",
    "modulus": "effective modulus",
}
_BLUE, _RED, _GREY = "#0072B2", "#D55E00", "#707070"


def draw(
    data: Data,
    noise: float,
    fitted: Array,
    residuals: Array,
    label: str,
    title: list[str],
    doubts: list[str],
    path: str | os.PathLike[str] | None,
) -> Any:
    """The figure, in practical units of SI numbers. Error bars are `noise` times the data's standard deviations."""
    try:
        from matplotlib.figure import Figure
    except ImportError as problem:
        raise MDRError('figures need matplotlib: pip install "mdrcontact[plot]"') from problem
    figure = Figure(figsize=(6.4, 5.6), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    order = data.order()
    x_unit = practical(dimension_of_data(data.x_name), data.x)
    y_unit = practical(dimension_of_data(data.y_name), data.y)
    x, y = data.x[order] / x_unit.factor, data.y[order] / y_unit.factor
    # the fit is one line for each branch
    ends = [0, *(np.flatnonzero(np.diff(data.branch[order]) != 0) + 1 if data.branch is not None else []), len(x)]
    bars = None if data.sd is None else data.sd[order] * noise / y_unit.factor
    if bars is None or len(x) > 300:
        above.plot(x, y, ".", color=_GREY, markersize=3, label="data")
    else:
        above.errorbar(x, y, bars, fmt=".", color=_GREY, markersize=4, elinewidth=0.8, label="data")
    for first, last in zip(ends, ends[1:], strict=False):
        above.plot(x[first:last], fitted[order][first:last] / y_unit.factor, color=_BLUE, label=label if first == 0 else None)
    above.set_ylabel(f"{_AXES[data.y_name]} [{y_unit.symbol}]")
    above.set_title("\n".join(title), fontsize=9, loc="left")
    if doubts:
        above.text(0.5, 0.98, "\n".join(doubts), transform=above.transAxes, color=_RED, fontsize=9, va="top", ha="center")
    above.legend(frameon=False)
    below.axhspan(-1.96, 1.96, color="#eeeeee")
    below.axhline(0.0, color=_BLUE, linewidth=1.0)
    below.plot(x, residuals[order], ".", color=_RED, markersize=3)
    below.set(xlabel=f"{_AXES[data.x_name]} [{x_unit.symbol}]", ylabel="residual / sd")
    for axis in (above, below):
        axis.spines[["top", "right"]].set_visible(False)
    if path is not None:
        drawn = io.BytesIO()
        figure.savefig(drawn, format=Path(path).suffix.lower().removeprefix(".") or "png", dpi=160)
        replace(path, drawn.getvalue())
    return figure
