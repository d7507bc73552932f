# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of many fits."""

from __future__ import annotations

from typing import Any

import numpy as np

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

    if len(good) > 3 and all(curve.place is not None for curve, _ in good):
        return _map(good, names)

    height = max(2.4, 0.25 * len(good) if len(good) <= _MOST_NAMES else 4.0)
    figure = Figure(figsize=(9.0, height * len(names) + 0.6), layout="constrained")
    axes = np.atleast_2d(figure.subplots(len(names), 2, width_ratios=[3, 1], sharey="row"))
    for (each, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] / unit.factor for _, r in good])
        places = np.arange(1, len(v) + 1)
        for describes, colour, label in ((True, _BLUE, "describes its data"), (False, _RED, "does not")):
            keep = np.array([(r.describes_data is not False and r.converged) == describes for _, r in good])
            if keep.any():
                errors = [1.96 * r.standard_errors[name] / unit.factor for (_, r), k in zip(good, keep, strict=True) if k]
                each.errorbar(places[keep], v[keep], errors, fmt=".", color=colour, elinewidth=0.8, label=label)
        each.set_ylabel(f"{words_of(name)} [{unit.symbol}]" if unit.name else words_of(name))
        if len(v) <= _MOST_NAMES:
            each.set_xticks(places, [curve.name for curve, _ in good], rotation=90, fontsize=7)
        else:
            each.set_xlabel("curve")
        histogram.hist(v, bins=20, range=each.get_ylim(), orientation="horizontal", color=_BLUE, alpha=0.6)
        histogram.set_xlabel("curves")
        for axis in (each, histogram):
            axis.spines[["top", "right"]].set_visible(False)
    axes[0][0].legend(frameon=False, fontsize=8, ncols=2, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return figure


def _map(good: list[tuple[Curve, FitResult]], names: tuple[str, ...]) -> Any:
    """Each parameter as a map, places whose fit does not describe its data marked, and its histogram."""
    from matplotlib.figure import Figure

    places = np.array([curve.place for curve, _ in good], dtype=float)
    columns, rows = (np.unique(places[:, i], return_inverse=True)[1] for i in (0, 1))
    figure = Figure(figsize=(8.0, 3.6 * len(names)), layout="constrained")
    axes = np.atleast_2d(figure.subplots(len(names), 2, width_ratios=[2, 1]))
    doubtful = np.array([r.describes_data is False or not r.converged for _, r in good])
    for (image, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] / unit.factor for _, r in good])
        grid = np.full((rows.max() + 1, columns.max() + 1), np.nan)
        grid[rows, columns] = v
        title = f"{words_of(name)} [{unit.symbol}]" if unit.name else words_of(name)
        # a few bad places must not take all the colours
        low, high = np.percentile(v, [2.0, 98.0])
        drawn = image.imshow(grid, origin="lower", vmin=low, vmax=high if high > low else low + 1e-9 * abs(low), cmap="viridis")
        image.figure.colorbar(drawn, ax=image, label=title)
        if doubtful.any():
            image.plot(columns[doubtful], rows[doubtful], "x", color=_RED, markersize=4, label="does not describe its data")
            image.legend(frameon=False, fontsize=8, loc="upper left", bbox_to_anchor=(0.0, 1.12))
        image.set(xlabel="column", ylabel="row")
        histogram.hist(v, bins="auto", color=_BLUE, alpha=0.6)
        histogram.set(xlabel=title, ylabel="curves")
        histogram.spines[["top", "right"]].set_visible(False)
    return figure
