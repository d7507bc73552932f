# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of many fits."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._units import practical
from ..instruments.fitting.quantities import dimension_of, words_of
from ..studies.many import Fitted, FittedCurves

_MOST_NAMES = 40
"""Under the picture."""
_TITLE = 24
"""Letters in a line of an axis title."""
_OFF_GRID = 0.25
"""Of the step of a grid: positions that far off are on none."""
_BLUE, _RED = "#0072B2", "#D55E00"

Array = NDArray[np.float64]


def overview(found: FittedCurves) -> Any:
    """Each parameter curve by curve, or place by place of a map, and its histogram."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    fitted = found.fitted
    names = tuple(name for name in found.names if name not in fitted[0].fit.data.also_free) or found.names
    if len(fitted) > 3 and all(one.curve.place is not None for one in fitted):
        places = np.array([one.curve.place for one in fitted], dtype=int)
        if (np.ptp(places, axis=0) > 0).all():
            return _map(fitted, names, places)

    longest = max(len(one.curve.name) for one in fitted) if len(fitted) <= _MOST_NAMES else 0
    figure = Figure(figsize=(9.0, 2.1 * len(names) + 0.7 + 0.075 * longest), layout="constrained")
    axes = figure.subplots(len(names), 2, width_ratios=[3, 1], sharey="row", sharex="col", squeeze=False)
    counts = np.array([one.counts for one in fitted])
    for (each, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(one.fit.estimates[name]) for one in fitted])
        v = np.array([one.fit.estimates[name] / unit.factor for one in fitted])
        errors = np.array([1.96 * one.fit.standard_errors[name] / unit.factor for one in fitted])
        places = np.arange(1, len(v) + 1)
        for keep, colour, label in ((counts, _BLUE, "in the mean"), (~counts, _RED, "left out of the mean")):
            if keep.any():
                each.errorbar(places[keep], v[keep], errors[keep], fmt=".", color=colour, elinewidth=0.8, label=label)
        each.set_ylabel(_axis_title(name, unit.symbol))
        _frame(each, v[counts] if counts.any() else v, errors[counts] if counts.any() else errors)
        histogram.hist(v[counts] if counts.any() else v, bins="rice", orientation="horizontal", color=_BLUE, alpha=0.6)
        for axis in (each, histogram):
            axis.spines[["top", "right"]].set_visible(False)
    each, histogram = axes[-1]
    if len(fitted) <= _MOST_NAMES:
        each.set_xticks(
            np.arange(1, len(fitted) + 1), [one.curve.name for one in fitted], rotation=90, fontsize=7, parse_math=False
        )
    else:
        each.set_xlabel("curve")
    histogram.set_xlabel("curves")
    histogram.xaxis.set_major_locator(MaxNLocator("auto", integer=True))
    axes[0][0].legend(frameon=False, fontsize=8, ncols=2, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return figure


def _axis_title(name: str, symbol: str) -> str:
    """Over several lines: rows of several parameters stand close."""
    return textwrap.fill(f"{words_of(name)} [{symbol}]" if symbol else words_of(name), _TITLE)


def _frame(axis: Any, values: Array, errors: Array) -> None:
    """One estimate that is not determined must not take the whole height."""
    low, high = np.percentile(values, [5.0, 95.0])
    room = 4.0 * max(high - low, float(np.median(errors)), 1e-3 * abs(high))
    ends = max(float((values - errors).min()), low - room), min(float((values + errors).max()), high + room)
    axis.set_ylim(ends[0] - 0.05 * (ends[1] - ends[0]), ends[1] + 0.05 * (ends[1] - ends[0]))


def _map(fitted: Sequence[Fitted], names: Sequence[str], places: NDArray[np.int64]) -> Any:
    """Each parameter as a map, places that are left out of the mean marked, and its histogram. Places without a fit are white."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    first = places.min(axis=0)
    width, height = places.max(axis=0) - first + 1
    figure = Figure(figsize=(8.5, max(2.4, min(3.6, 1.2 + 3.6 * height / width)) * len(names)), layout="constrained")
    axes = np.atleast_2d(figure.subplots(len(names), 2, width_ratios=[2, 1]))
    counts = np.array([one.counts for one in fitted])
    scale = _micrometres(fitted, places)
    for (image, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(one.fit.estimates[name]) for one in fitted])
        v = np.array([one.fit.estimates[name] / unit.factor for one in fitted])
        chosen = v[counts] if counts.any() else v
        grid = np.full((height, width), np.nan)
        grid[places[:, 1] - first[1], places[:, 0] - first[0]] = v
        title = _axis_title(name, unit.symbol)
        # a few bad places must not take all the colours
        low, high = np.percentile(chosen, [2.0, 98.0])
        ends = np.array([first[0] - 0.5, first[0] + width - 0.5, first[1] - 0.5, first[1] + height - 0.5])
        if scale is not None:
            ends = np.repeat(scale.start, 2) + np.repeat(scale.step, 2) * ends
        drawn = image.imshow(grid, origin="lower", extent=ends, vmin=low, vmax=high if high > low else low + 1e-9 * abs(low))
        extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}
        figure.colorbar(drawn, ax=image, label=title, extend=extend[bool(v.min() < low), bool(v.max() > high)])
        if not counts.all():
            marked = places[~counts].T.astype(float)
            if scale is not None:
                marked = scale.start[:, None] + scale.step[:, None] * marked
            image.plot(*marked, "x", color=_RED, markersize=4, label="left out of the mean")
            image.legend(frameon=False, fontsize=8, loc="lower left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.0)
        image.set(xlabel="column" if scale is None else "x [µm]", ylabel="row" if scale is None else "y [µm]")
        histogram.hist(chosen, bins="rice", color=_BLUE, alpha=0.6)
        histogram.set(xlabel=title, ylabel="curves")
        histogram.spines[["top", "right"]].set_visible(False)
        histogram.xaxis.set_major_locator(MaxNLocator(4))
        whole = scale is None
        for axis in (image.xaxis, image.yaxis):
            axis.set_major_locator(MaxNLocator("auto", integer=whole, min_n_ticks=1))
        histogram.yaxis.set_major_locator(MaxNLocator("auto", integer=True, min_n_ticks=1))
    return figure


class _Scale(NamedTuple):
    """Places in µm: start + step * (column, row)."""

    start: Array
    step: Array


def _micrometres(fitted: Sequence[Fitted], places: NDArray[np.int64]) -> _Scale | None:
    """From the positions that the file has, where they are those of a grid along x and y."""
    if any(one.curve.position is None for one in fitted):
        return None
    positions = 1e6 * np.array([one.curve.position for one in fitted], dtype=float)
    start, step = np.zeros(2), np.zeros(2)
    for i in range(2):
        step[i], start[i] = np.polyfit(places[:, i], positions[:, i], 1)
        if not step[i] > 0.0 or np.abs(start[i] + step[i] * places[:, i] - positions[:, i]).max() > _OFF_GRID * step[i]:
            return None
    return _Scale(start, step)
