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
from .data import Data, ForceDepth, ModulusRadius, StiffnessDepth

Array = NDArray[np.float64]

_BLUE, _RED, _GREY = "#0072B2", "#D55E00", "#707070"


def draw(
    data: Data, noise: float, fitted: Array, residuals: Array, label: str, title: list[str], path: str | os.PathLike[str] | None
) -> Any:
    """The figure; numbers are in the units of the problem. Error bars are `noise` times the data's standard deviations."""
    try:
        from matplotlib.figure import Figure
    except ImportError as problem:
        raise MDRError('figures need matplotlib: pip install "mdrcontact[plot]"') from problem
    figure = Figure(figsize=(6.4, 5.6), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    order = np.argsort(data.x, kind="stable")
    x = data.x[order]
    bars = None if data.sd is None else data.sd[order] * noise
    if bars is None or len(x) > 300:
        above.plot(x, data.y[order], ".", color=_GREY, markersize=3, label="data")
    else:
        above.errorbar(x, data.y[order], bars, fmt=".", color=_GREY, markersize=4, elinewidth=0.8, label="data")
    above.plot(x, fitted[order], color=_BLUE, label=label)
    above.set_ylabel(data.y_name)
    above.set_title("\n".join(title), fontsize=9, loc="left")
    above.legend(frameon=False)
    below.axhspan(-1.96, 1.96, color="#eeeeee")
    below.axhline(0.0, color=_BLUE, linewidth=1.0)
    below.plot(x, residuals[order], ".", color=_RED, markersize=3)
    below.set(xlabel=_x_label(data), ylabel="residual / sd")
    for axis in (above, below):
        axis.spines[["top", "right"]].set_visible(False)
    if path is not None:
        drawn = io.BytesIO()
        figure.savefig(drawn, format=Path(path).suffix.lower().removeprefix(".") or "png", dpi=160)
        replace(path, drawn.getvalue())
    return figure


def _x_label(data: Any) -> str:
    if isinstance(data, (ForceDepth, StiffnessDepth)):
        return "indentation depth"
    return "contact radius" if isinstance(data, ModulusRadius) else data.x_name
