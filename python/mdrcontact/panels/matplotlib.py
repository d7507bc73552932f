# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures drawn with matplotlib: for files, reports and notebooks."""

from __future__ import annotations

import functools
import io
import math
import os
import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import InvalidArgumentError, MDRError
from .panel import Axis, Bars, Cells, Label, Line, Panel, Rule, Sheet, limits, place_of

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8B4513", "#7f7f7f", "#9a9a00")
"""Okabe and Ito's colours, which all eyes tell apart, and four more."""
NAMED = {"grey": "#707070", "pale": "#c8c8c8", "black": "#000000", "white": "#ffffff"}
_DASHES = {0: "-", 1: (0, (5, 2)), 2: (0, (1, 1.5)), -1: ""}
_STYLE: dict[Any, Any] = {
    "font.size": 9,
    "axes.titlesize": 10,
    "figure.titlesize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e6e6",
    "legend.framealpha": 0.85,
    "legend.edgecolor": "none",
    "svg.hashsalt": "mdrcontact",
}
FORMATS: dict[str, dict[str, Any]] = {
    "png": {"Software": "mdrcontact"},
    "pdf": {"Creator": "mdrcontact", "CreationDate": None},
    "svg": {"Date": None},
}
"""Metadata of a figure without a date, so that the same figure gives the same file."""
_WIDTH, _HEIGHT, _DOTS = 4.6, 3.5, 160
_LEAST_WIDTH, _LETTERS = 6.0, 12.0
"""Of a figure, and the letters of a title in an inch."""
_TICKS = 7
"""Most intervals along x."""
_WARNING = "#a33c00"
_FLAT = 0.3
"""Height over width of a map below which its bar does not fit next to it."""
LEGEND_BELOW = 6
"""More names than this are below the figure, or next to the panel."""
DECADES = 300.0
"""Ratio of the ends of a logarithmic axis from which on powers of ten are enough."""


def colour(of: int | str) -> str:
    """Return the colour of a number or a name."""
    return NAMED[of] if isinstance(of, str) else COLOURS[of % len(COLOURS)]


def draw(figure: Sheet) -> Any:
    """Draw a figure; a `matplotlib.figure.Figure` that a notebook shows."""
    try:
        import matplotlib
    except ImportError as problem:
        raise MDRError('figures need matplotlib: pip install "mdrcontact[plot]"') from problem
    with matplotlib.rc_context(_STYLE):
        return _drawn(figure)


def form_of(path: str | os.PathLike[str]) -> str:
    """Return the format of a figure by the name of its file."""
    form = Path(path).suffix.lower().removeprefix(".")
    if form not in FORMATS:
        raise InvalidArgumentError(f"{path}: the name of a figure must end in {', '.join(f'.{name}' for name in FORMATS)}.")
    return form


def png(figure: Sheet) -> bytes:
    """Return a figure as a PNG file."""
    return rendered(draw(figure), "png")


def rendered(drawn: Any, form: str) -> bytes:
    """Return a drawn figure as a file, the same bytes whenever it is drawn. form : "png", "pdf" or "svg" """
    import matplotlib

    buffer = io.BytesIO()
    with matplotlib.rc_context(_STYLE):  # ticks are made when the figure is saved
        drawn.savefig(buffer, format=form, dpi=_DOTS, metadata=FORMATS[form])
    return buffer.getvalue()


@functools.cache
def _shown() -> Any:
    from matplotlib.figure import Figure as Drawn

    class Shown(Drawn):
        """A figure that a notebook shows without pyplot."""

        def _repr_png_(self) -> bytes:
            return rendered(self, "png")

    return Shown


def _drawn(figure: Sheet) -> Any:
    columns = min(figure.columns, len(figure.panels))
    rows = math.ceil(len(figure.panels) / columns)
    heights = figure.heights or (1.0,) * rows
    width = max(_WIDTH * columns, _LEAST_WIDTH)
    title, warnings = (_wrapped(lines, width) for lines in (figure.title.splitlines(), figure.warnings))
    text = 0.17 * (len(title) + len(warnings))
    drawn = _shown()(figsize=(width, _HEIGHT * sum(heights) + 0.2 + text), layout="constrained")
    drawn.suptitle("\n".join(title), parse_math=False)
    if warnings:
        drawn.supxlabel("\n".join(warnings), parse_math=False, color=_WARNING, fontsize="medium")
    axes = drawn.subplots(rows, columns, squeeze=False, height_ratios=heights).ravel()
    names = [part.name for part in figure.panels[0].parts if isinstance(part, Line) and part.name]
    for axis, panel in zip(axes, figure.panels, strict=False):
        _draw_panel(drawn, axis, panel)
        if len(names) <= LEGEND_BELOW and axis.get_legend_handles_labels()[1]:
            axis.legend()
    for axis in axes[len(figure.panels) :]:
        axis.set_axis_off()
    if len(names) > LEGEND_BELOW:
        drawn.legend(axes[0].get_legend_handles_labels()[0], names, loc="outside lower center", ncols=5)
    return drawn


def _wrapped(lines: Iterable[str], width: float) -> list[str]:
    return [part for line in lines for part in textwrap.wrap(line, int(_LETTERS * width))]


def _draw_panel(figure: Any, axis: Any, panel: Panel) -> None:
    for part in panel.parts:
        if isinstance(part, Line):
            _draw_line(axis, part)
        elif isinstance(part, Rule):
            (axis.axvline if part.vertical else axis.axhline)(part.at, **_look(part, 0.9))
        elif isinstance(part, Label):
            _draw_label(axis, panel, part)
        elif isinstance(part, Cells):
            _draw_cells(figure, axis, part, panel.equal)
        elif isinstance(part, Bars):
            axis.stairs(part.counts, part.edges, fill=True, color=colour(part.colour), alpha=0.6)
        else:
            look = {"color": colour(part.colour), "alpha": 0.15, "linewidth": 0.0, "label": part.name or None}
            axis.fill_between(part.x, part.low, part.high, **look)
    axis.set(title="\n".join(_wrapped(panel.title.splitlines(), _WIDTH)), xlabel=panel.x.title, ylabel=panel.y.title)
    _set_axis(axis, "x", panel.x)
    _set_axis(axis, "y", panel.y)
    if panel.downward:
        axis.invert_yaxis()
    if panel.equal:
        axis.set_aspect("equal")
    _name_rules(axis, [part for part in panel.parts if isinstance(part, Rule) and part.name])


def _draw_line(axis: Any, part: Line) -> None:
    look = _look(part, part.width) | {"marker": part.marker or None, "markersize": 4.0, "label": part.name or None}
    if part.error is None:
        axis.plot(part.x, part.y, **look)
    else:
        axis.errorbar(part.x, part.y, part.error, capsize=0.0 if part.marker == "." else 2.0, elinewidth=0.8, **look)


def _look(part: Line | Rule, width: float) -> dict[str, Any]:
    return {"color": colour(part.colour), "linestyle": _DASHES[part.dash], "linewidth": width}


def _outlined(of: str) -> dict[str, Any]:
    from matplotlib.patheffects import withStroke

    return {"path_effects": [withStroke(linewidth=2.0, foreground=of)]}


def _name_rules(axis: Any, rules: list[Rule]) -> None:
    """Write the names at the ends of the rules; those of vertical ones below each other."""
    below = 3
    for part in rules:
        look: dict[str, Any] = {"textcoords": "offset points", "color": colour(part.colour), **_outlined("white")}
        if part.vertical:
            is_left = axis.transAxes.inverted().transform(axis.transData.transform((part.at, 1.0)))[0] < 0.6
            place = {"xytext": (3 if is_left else -3, -below), "va": "top", "ha": "left" if is_left else "right"}
            axis.annotate(part.name, (part.at, 1.0), xycoords=("data", "axes fraction"), **place, **look)
            below += 12
        else:
            axis.annotate(part.name, (1.0, part.at), xycoords=("axes fraction", "data"), xytext=(-3, 3), ha="right", **look)


def _draw_label(axis: Any, panel: Panel, part: Label) -> None:
    axis.plot(part.x, part.y, part.marker, markersize=5, markerfacecolor="none", color=colour(part.colour), zorder=5, clip_on=False)
    height, side = place_of(panel, part)
    look: dict[str, Any] = {"color": colour(part.colour), "ha": "left" if side == "right" else "right"}
    if any(isinstance(one, Cells) for one in panel.parts):  # legible on any colour
        look |= _outlined("black" if part.colour == "white" else "white")
    place = 7 if side == "right" else -7, 6 if height == "above" else -12
    axis.annotate(part.text, (part.x, part.y), xytext=place, textcoords="offset points", **look)


def _draw_cells(figure: Any, axis: Any, part: Cells, is_equal: bool) -> None:
    from matplotlib.ticker import MaxNLocator

    low, high = limits(part)
    ends = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}
    extend = ends[bool(np.nanmin(part.values) < low), bool(np.nanmax(part.values) > high)]
    colours = "RdBu_r" if part.two_sided else "viridis"
    if part.smooth:
        drawn = axis.contourf(part.x, part.y, part.values, np.linspace(low, high, 25), cmap=colours, extend=extend)
    else:
        drawn = axis.pcolormesh(part.x, part.y, part.values, vmin=low, vmax=high, cmap=colours, shading="nearest")
    axis.grid(False)
    if part.bar:
        # of the height of the map, which follows from equal scales; below a flat one
        is_flat = is_equal and np.ptp(part.y) < _FLAT * np.ptp(part.x)
        place: dict[str, Any] = {"ax": axis, "orientation": "horizontal", "aspect": 40.0} if is_flat else {"ax": axis}
        place = {"cax": axis.inset_axes((1.03, 0.0, 0.035, 1.0))} if is_equal and not is_flat else place
        bar = figure.colorbar(drawn, ticks=MaxNLocator(6), extend=None if part.smooth else extend, **place)
        bar.set_label(part.axis.title)


def _set_axis(axis: Any, name: str, side: Axis) -> None:
    from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, StrMethodFormatter

    one = getattr(axis, f"{name}axis")
    if side.log:
        getattr(axis, f"set_{name}scale")("log")
        first, last = getattr(axis, f"get_{name}lim")()
        if last < DECADES * first:
            one.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
            one.set_major_formatter(StrMethodFormatter("{x:g}"))
            one.set_minor_formatter(NullFormatter())
    elif side.names:
        one.set_ticks(np.arange(1, len(side.names) + 1), side.names, rotation=90, fontsize=7, parse_math=False)
    elif side.whole:
        one.set_major_locator(MaxNLocator("auto", integer=True, min_n_ticks=1))
    elif name == "x":
        one.set_major_locator(MaxNLocator(_TICKS, steps=[1, 2, 2.5, 5, 10]))
    getattr(axis, f"set_{name}lim")(side.low, side.high)
