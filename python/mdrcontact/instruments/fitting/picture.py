# SPDX-License-Identifier: GPL-3.0-or-later
"""Data, fit and residuals as a figure."""

from __future__ import annotations

import io
import os
import textwrap
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..._files import replace
from ..._units import FORCE, LENGTH, QUANTITIES, practical
from ...errors import MDRError
from .data import Data, StiffnessDepth
from .time_data import DynamicStiffness

Array = NDArray[np.float64]

_AXES = {
    "depth": "indentation depth",
    "radius": "contact radius",
    "force": "force",
    "stiffness": "contact stiffness",
    "modulus": "effective modulus",
    "time": "time",
    "omega": "angular frequency",
}
_LINE = 84
"""Letters in a line of the title."""
_BEFORE, _MARGIN = 2.0, 0.03
"""Length of baseline shown, in depths of the contact, and the margin next to it, as a fraction of the width."""
_BLUE, _RED, _GREY, _PALE = "#0072B2", "#D55E00", "#707070", "#cccccc"


def draw(
    data: Data,
    noise: float,
    fitted: Array,
    residuals: Array,
    label: str,
    title: list[str],
    doubts: list[str],
    path: str | os.PathLike[str] | None,
    contact: float | None = None,
) -> Any:
    """The figure, in practical units of SI numbers. Error bars are `noise` times the data's standard deviations. contact : depth at
    which the fit has found first contact."""
    try:
        from matplotlib.figure import Figure
    except ImportError as problem:
        raise MDRError('figures need matplotlib: pip install "mdrcontact[plot]"') from problem
    figure = Figure(figsize=(6.4, 5.6), layout="constrained")
    if isinstance(data, StiffnessDepth) and data.unloadings:
        _draw_unloadings(figure.subplots(), data, title, doubts)
    else:
        above = _draw_points(figure, data, noise, fitted, residuals, label)
        if contact is not None:
            _draw_contact(above, data, contact)
        _finish(above, title, doubts)
    if path is not None:
        drawn = io.BytesIO()
        figure.savefig(drawn, format=Path(path).suffix.lower().removeprefix(".") or "png", dpi=160)
        replace(path, drawn.getvalue())
    return figure


def _draw_unloadings(axis: Any, data: StiffnessDepth, title: list[str], doubts: list[str]) -> None:
    """The whole test, the part of each unloading curve that is fitted, and the tangent whose slope is the stiffness."""
    assert data.record is not None
    x_unit, y_unit = practical(LENGTH, data.record[0]), practical(FORCE, data.record[1])
    axis.plot(data.record[0] / x_unit.factor, data.record[1] / y_unit.factor, ".", color=_GREY, markersize=3, label="data")
    for i, q in enumerate(data.unloadings):
        h = np.linspace(q.final_depth, q.depth, 100)
        p = q.force * ((h - q.final_depth) / (q.depth - q.final_depth)) ** q.exponent
        tangent = np.array([q.depth - q.force / q.stiffness, q.depth])
        name = {"label": "power law of the unloading"} if i == 0 else {}
        axis.plot(h / x_unit.factor, p / y_unit.factor, color=_BLUE, linewidth=1.0, linestyle=(0, (1, 1.5)))
        axis.plot(q.fitted_depth / x_unit.factor, q.fitted_force / y_unit.factor, color=_BLUE, linewidth=2.5, alpha=0.7, **name)
        name = {"label": "contact stiffness S"} if i == 0 else {}
        axis.plot(tangent / x_unit.factor, np.array([0.0, q.force]) / y_unit.factor, color=_RED, linewidth=1.2, **name)
    axis.set(xlabel=f"indentation depth [{x_unit.symbol}]", ylabel=f"force [{y_unit.symbol}]")
    axis.set_ylim(0.0, None)
    _finish(axis, title, doubts)
    axis.spines[["top", "right"]].set_visible(False)


def _finish(axis: Any, title: list[str], doubts: list[str]) -> None:
    axis.set_title("\n".join(line for words in title for line in textwrap.wrap(words, _LINE)), fontsize=9, loc="left")
    if doubts:
        axis.text(0.5, 0.98, "\n".join(doubts), transform=axis.transAxes, color=_RED, fontsize=9, va="top", ha="center")
    axis.legend(frameon=False, fontsize=8)


def _draw_points(
    figure: Any,
    data: Data,
    noise: float,
    fitted: Array,
    residuals: Array,
    label: str,
) -> Any:
    """Data and fit above, residuals below; the axes above."""
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    order = data.order()
    x_unit = practical(QUANTITIES[data.x_name], data.x)
    y_unit = practical(QUANTITIES[data.y_name], data.y)
    x, y = data.x[order] / x_unit.factor, data.y[order] / y_unit.factor
    # the fit is one line for each branch
    ends = [0, *(np.flatnonzero(np.diff(data.branch[order]) != 0) + 1 if data.branch is not None else []), len(x)]
    bars = None if data.sd is None else data.sd[order] * noise / y_unit.factor
    if data.unused is not None:
        unused = [v / unit.factor for v, unit in zip(data.unused, (x_unit, y_unit), strict=True)]
        above.plot(*unused, ".", color=_PALE, markersize=2, zorder=0.5, label="not used")
    if bars is None or len(x) > 300:
        above.plot(x, y, ".", color=_GREY, markersize=3, label="data")
    else:
        above.errorbar(x, y, bars, fmt=".", color=_GREY, markersize=4, elinewidth=0.8, label="data")
    for first, last in pairwise(ends):
        above.plot(x[first:last], fitted[order][first:last] / y_unit.factor, color=_BLUE, label=label if first == 0 else None)
    above.set_ylabel(f"{_AXES[data.y_name]} [{y_unit.symbol}]")
    if isinstance(data, DynamicStiffness):
        above.set(xscale="log", yscale="log")
        for (first, last), part in zip(pairwise(ends), ("storage", "loss"), strict=False):
            top = first + int(np.argmax(fitted[order][first:last]))
            place = (x[top], fitted[order][top] / y_unit.factor)
            above.annotate(part, place, (0, 6), textcoords="offset points", ha="right" if top == last - 1 else "center")
    below.axhspan(-1.96, 1.96, color="#eeeeee")
    below.axhline(0.0, color=_BLUE, linewidth=1.0)
    below.plot(x, residuals[order], ".", color=_RED, markersize=3)
    below.set(xlabel=f"{_AXES[data.x_name]} [{x_unit.symbol}]", ylabel="residual / sd")
    for axis in (above, below):
        axis.spines[["top", "right"]].set_visible(False)
    return above


def _draw_contact(axis: Any, data: Data, contact: float) -> None:
    """Draw first contact of fit and estimators, and only the near part of a long baseline."""
    unit = practical(QUANTITIES[data.x_name], data.x)
    deepest, first = float(data.x.max()), float(data.x.min())
    places = {"contact point of the fit": contact, **{f"contact point, {name}": at for name, at in data.contact_points.items()}}
    for (words, at), style in zip(places.items(), ("-", "--", ":"), strict=False):
        axis.axvline(at / unit.factor, color=_BLUE if at == contact else _GREY, linewidth=0.9, linestyle=style, label=words)
    begin = min(contact - _BEFORE * (deepest - contact), *places.values())
    if begin > first:
        room = _MARGIN * (deepest - begin)
        axis.set_xlim((begin - room) / unit.factor, (deepest + room) / unit.factor)
