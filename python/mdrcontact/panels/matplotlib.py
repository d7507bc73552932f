# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures drawn with matplotlib: for files, reports and notebooks."""

from __future__ import annotations

import functools
import io
import math
from typing import Any

import numpy as np

from ..errors import MDRError
from .panel import Axis, Cells, Label, Line, Panel, Rule, Sheet, limits, side_of

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8B4513", "#7f7f7f", "#9a9a00")
"""Okabe and Ito's colours, which all eyes tell apart, and four more."""
NAMED = {"grey": "#707070", "black": "#000000", "white": "#ffffff"}
_DASHES = {0: "-", 1: (0, (5, 2)), 2: (0, (1, 1.5)), -1: ""}
_STYLE: dict[Any, Any] = {
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e6e6",
    "legend.frameon": False,
    "svg.hashsalt": "mdrcontact",
}
FORMATS: dict[str, dict[str, Any]] = {
    "png": {"Software": "mdrcontact"},
    "pdf": {"Creator": "mdrcontact", "CreationDate": None},
    "svg": {"Date": None},
}
"""Metadata of a figure without a date, so that the same figure gives the same file."""
_WIDTH, _HEIGHT, _DOTS = 4.6, 3.5, 160
_FLAT = 0.3
"""Height over width of a map below which its bar does not fit next to it."""
_LEGEND_BELOW = 6
"""More names than this are below the figure."""


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
    drawn = _shown()(figsize=(_WIDTH * columns, _HEIGHT * sum(heights) + 0.4), layout="constrained")
    drawn.suptitle(figure.title, parse_math=False)
    axes = drawn.subplots(rows, columns, squeeze=False, height_ratios=heights).ravel()
    names = [part.name for part in figure.panels[0].parts if isinstance(part, Line) and part.name]
    for axis, panel in zip(axes, figure.panels, strict=False):
        _draw_panel(drawn, axis, panel)
        if len(names) <= _LEGEND_BELOW and axis.get_legend_handles_labels()[1]:
            axis.legend()
    for axis in axes[len(figure.panels) :]:
        axis.set_axis_off()
    if len(names) > _LEGEND_BELOW:
        drawn.legend(axes[0].get_legend_handles_labels()[0], names, loc="outside lower center", ncols=5)
    return drawn


def _draw_panel(figure: Any, axis: Any, panel: Panel) -> None:
    for i, part in enumerate(panel.parts):
        if isinstance(part, Line):
            _draw_line(axis, part)
        elif isinstance(part, Rule):
            _draw_rule(axis, part)
        elif isinstance(part, Label):
            _draw_label(axis, panel, part, above=i % 2 == 0)
        elif isinstance(part, Cells):
            _draw_cells(figure, axis, part, panel.equal)
        else:
            axis.stairs(part.counts, part.edges, fill=True, color=colour(part.colour), alpha=0.6)
    axis.set(title=panel.title, xlabel=panel.x.title, ylabel=panel.y.title)
    _set_axis(axis, "x", panel.x)
    _set_axis(axis, "y", panel.y)
    if panel.downward:
        axis.invert_yaxis()
    if panel.equal:
        axis.set_aspect("equal")


def _draw_line(axis: Any, part: Line) -> None:
    look = {"color": colour(part.colour), "linestyle": _DASHES[part.dash], "linewidth": part.width, "marker": part.marker or None}
    look |= {"markersize": 4.0, "label": part.name or None}
    if part.error is None:
        axis.plot(part.x, part.y, **look)
    else:
        axis.errorbar(part.x, part.y, part.error, capsize=2.0, elinewidth=0.8, **look)


def _draw_rule(axis: Any, part: Rule) -> None:
    look = {"color": colour(part.colour), "linestyle": _DASHES[part.dash], "linewidth": 0.9}
    if part.vertical:
        axis.axvline(part.at, **look)
        place = {"xy": (part.at, 1.0), "xycoords": ("data", "axes fraction"), "xytext": (3, -3), "va": "top"}
    else:
        axis.axhline(part.at, **look)
        place = {"xy": (1.0, part.at), "xycoords": ("axes fraction", "data"), "xytext": (-3, 3), "ha": "right"}
    if part.name:
        axis.annotate(part.name, textcoords="offset points", color=colour(part.colour), **place)


def _draw_label(axis: Any, panel: Panel, part: Label, above: bool) -> None:
    from matplotlib.patheffects import withStroke

    axis.plot(part.x, part.y, part.marker, markersize=5, markerfacecolor="none", color=colour(part.colour), zorder=5, clip_on=False)
    right = side_of(panel, part) == "right"
    look: dict[str, Any] = {"color": colour(part.colour), "ha": "left" if right else "right"}
    if any(isinstance(one, Cells) for one in panel.parts):  # legible on any colour
        look["path_effects"] = [withStroke(linewidth=2.0, foreground="black" if part.colour == "white" else "white")]
    place = 7 if right else -7, 6 if above else -12
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
        if last < 300.0 * first:  # below three decades, powers of ten are too few
            one.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
            one.set_major_formatter(StrMethodFormatter("{x:g}"))
            one.set_minor_formatter(NullFormatter())
    elif side.names:
        one.set_ticks(np.arange(1, len(side.names) + 1), side.names, rotation=90, fontsize=7, parse_math=False)
    elif side.whole:
        one.set_major_locator(MaxNLocator("auto", integer=True, min_n_ticks=1))
    getattr(axis, f"set_{name}lim")(side.low, side.high)
