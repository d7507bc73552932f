# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a file of measurements: its tests and their segments."""

from __future__ import annotations

from typing import Any

from .._units import FORCE, LENGTH, practical
from ..studies.inspect import InspectResult

_COLOURS = {"loading": "#0072B2", "unloading": "#D55E00", "hold": "#E69F00"}
"""What is drawn later lies above: cycles on their loading."""
_MOST = 12
"""Tests that are drawn."""


def inspect_figure(found: InspectResult) -> Any:
    """Force against depth or height, coloured by segment, one panel for each test."""
    from matplotlib.figure import Figure

    tests = found.inspection.tests[:_MOST]
    columns = min(len(tests), 3 if len(tests) > 2 else 2)
    rows = -(-len(tests) // columns)
    size = 3.6 if columns > 1 else 6.4
    figure = Figure(figsize=(max(columns * size, 6.4), rows * (3.0 if columns > 1 else 4.6)), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axis, test in zip(panels, tests, strict=False):
        x, y = practical(LENGTH, test.along), practical(FORCE, test.force)
        for part in test.segments:
            points = slice(max(part.start - 1, 0), part.stop)
            line = (test.along[points] / x.factor, test.force[points] / y.factor)
            above = 2 + list(_COLOURS).index(part.kind)
            axis.plot(*line, "-", color=_COLOURS[part.kind], linewidth=1.2, marker=".", markersize=2, zorder=above)
        axis.set(xlabel=f"{test.along_name} [{x.symbol}]", ylabel=f"force [{y.symbol}]")
        axis.set_title(test.name, fontsize=8, loc="left", parse_math=False)
        axis.spines[["top", "right"]].set_visible(False)
    for axis in panels[len(tests) :]:
        axis.set_axis_off()
    handles = [panels[0].plot([], [], color=colour, label=kind)[0] for kind, colour in _COLOURS.items()]
    count = len(found.inspection.tests)
    rest = f"{len(tests)} of {count} tests" if len(tests) < count else None
    figure.legend(handles=handles, loc="outside upper right", ncols=3, frameon=False, fontsize=8, title=rest)
    return figure
