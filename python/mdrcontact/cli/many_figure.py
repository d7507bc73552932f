# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of many fits."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..fitting import FitResult
from ..fitting.quantities import dimension_of, words_of
from ..problem.data import Curve
from ..problem.units import practical

_MOST_NAMES = 40
"""Under the picture."""
_BLUE, _RED = "#0072B2", "#D55E00"


def overview(good: list[tuple[Curve, FitResult]], names: tuple[str, ...]) -> Any:
    """Each parameter curve by curve, or place by place of a map, and its histogram."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    if len(good) > 3 and all(curve.place is not None for curve, _ in good):
        places = np.array([curve.place for curve, _ in good], dtype=int)
        if (np.ptp(places, axis=0) > 0).all():
            return _map(good, names, places)

    longest = max(len(curve.name) for curve, _ in good) if len(good) <= _MOST_NAMES else 0
    figure = Figure(figsize=(9.0, 2.1 * len(names) + 0.7 + 0.075 * longest), layout="constrained")
    axes = figure.subplots(len(names), 2, width_ratios=[3, 1], sharey="row", sharex="col", squeeze=False)
    for (each, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] / unit.factor for _, r in good])
        places = np.arange(1, len(v) + 1)
        for describes, colour, label in ((True, _BLUE, "describes its data"), (False, _RED, "does not describe its data")):
            keep = np.array([(r.describes_data is not False and r.converged) == describes for _, r in good])
            if keep.any():
                errors = [1.96 * r.standard_errors[name] / unit.factor for (_, r), k in zip(good, keep, strict=True) if k]
                each.errorbar(places[keep], v[keep], errors, fmt=".", color=colour, elinewidth=0.8, label=label)
        each.set_ylabel(f"{words_of(name)} [{unit.symbol}]" if unit.name else words_of(name))
        histogram.hist(v, bins="rice", orientation="horizontal", color=_BLUE, alpha=0.6)
        for axis in (each, histogram):
            axis.spines[["top", "right"]].set_visible(False)
    each, histogram = axes[-1]
    if len(good) <= _MOST_NAMES:
        each.set_xticks(np.arange(1, len(good) + 1), [curve.name for curve, _ in good], rotation=90, fontsize=7, parse_math=False)
    else:
        each.set_xlabel("curve")
    histogram.set_xlabel("curves")
    histogram.xaxis.set_major_locator(MaxNLocator("auto", integer=True))
    axes[0][0].legend(frameon=False, fontsize=8, ncols=2, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return figure


def _map(good: list[tuple[Curve, FitResult]], names: tuple[str, ...], places: NDArray[np.int64]) -> Any:
    """Each parameter as a map, places whose fit does not describe its data marked, and its histogram. Places without a fit are
    white."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    first = places.min(axis=0)
    width, height = places.max(axis=0) - first + 1
    figure = Figure(figsize=(8.5, max(2.4, min(3.6, 1.2 + 3.6 * height / width)) * len(names)), layout="constrained")
    axes = np.atleast_2d(figure.subplots(len(names), 2, width_ratios=[2, 1]))
    doubtful = np.array([r.describes_data is False or not r.converged for _, r in good])
    for (image, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] / unit.factor for _, r in good])
        grid = np.full((height, width), np.nan)
        grid[places[:, 1] - first[1], places[:, 0] - first[0]] = v
        title = f"{words_of(name)} [{unit.symbol}]" if unit.name else words_of(name)
        # a few bad places must not take all the colours
        low, high = np.percentile(v, [2.0, 98.0])
        ends = np.array([first[0], first[0] + width, first[1], first[1] + height]) - 0.5
        drawn = image.imshow(grid, origin="lower", extent=ends, vmin=low, vmax=high if high > low else low + 1e-9 * abs(low))
        extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}
        figure.colorbar(drawn, ax=image, label=title, extend=extend[bool(v.min() < low), bool(v.max() > high)])
        if doubtful.any():
            image.plot(*places[doubtful].T, "x", color=_RED, markersize=4, label="does not describe its data")
            image.legend(frameon=False, fontsize=8, loc="lower left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.0)
        image.set(xlabel="column", ylabel="row")
        histogram.hist(v, bins="rice", color=_BLUE, alpha=0.6)
        histogram.set(xlabel=title, ylabel="curves")
        histogram.spines[["top", "right"]].set_visible(False)
        histogram.xaxis.set_major_locator(MaxNLocator(4))
        for axis in (image.xaxis, image.yaxis, histogram.yaxis):
            axis.set_major_locator(MaxNLocator("auto", integer=True, min_n_ticks=1))
    return figure
