# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures drawn with Plotly, a drawing for each panel: for the page, whose width decides how many are side by side."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from .matplotlib import DECADES, LEGEND_BELOW, colour
from .panel import Array, Axis, Band, Bars, Cells, Label, Line, Panel, Part, Rule, Sheet, limits, place_of, side_of

_DASHES = ("solid", "dash", "dot")
_MARKERS = {"o": "circle", "s": "square", "^": "triangle-up", "x": "x"}
_INK, _SIZE = "#1b1f24", 12
_LAYOUT: dict[str, Any] = {
    "template": "none",
    "font": {"family": "system-ui, sans-serif", "size": _SIZE, "color": _INK},
    "hovermode": "closest",
    "bargap": 0.0,
}
_SIDE: dict[str, Any] = {"gridcolor": "#e6e6e6", "linecolor": "#8a9099", "showline": True, "zeroline": False, "ticks": "outside"}
_SIDE |= {"ticklen": 4, "automargin": True, "exponentformat": "power"}
_WHOLE = 12
"""Counts up to this one each have a tick."""


def draw(figure: Sheet) -> list[Any]:
    """Draw the panels of a figure; a `plotly.graph_objects.Figure` for each."""
    from plotly.graph_objects import Figure

    return [Figure(_panel(panel)) for panel in figure.panels]


def _panel(panel: Panel) -> dict[str, Any]:
    maps = [part for part in panel.parts if isinstance(part, Cells)]
    traces = [trace for part in panel.parts for trace in _trace(panel, part, maps)]
    rules = [part for part in panel.parts if isinstance(part, Rule)]
    shapes = [_rule(part, bool(maps)) for part in rules]
    names_of_rules = [_name(panel, part, 14 * i) for i, part in enumerate(part for part in rules if part.name)]
    names = sum(trace["showlegend"] for trace in traces)
    x, y = _side(panel, panel.x, "x"), _side(panel, panel.y, "y")
    if panel.equal:
        y |= {"scaleanchor": "x", "constrain": "domain"}
        x |= {"constrain": "domain"}
    if panel.downward:
        y |= {"range": y["range"][::-1]} if "range" in y else {"autorange": "reversed"}
    below = {"orientation": "h", "yref": "container", "y": 0.0, "yanchor": "bottom"}
    legend = {"font": {"size": 11}, **(below if names <= LEGEND_BELOW else {})}
    margin = {"l": 64, "r": 16, "t": 40 if panel.title else 16, "b": 84 if 0 < names <= LEGEND_BELOW else 48}
    title = {"text": _plain(panel.title), "font": {"size": _SIZE + 1}, "x": 0.5}
    own = {
        "xaxis": x,
        "yaxis": y,
        "shapes": shapes,
        "annotations": names_of_rules,
        "showlegend": names > 0,
        "legend": legend,
        "margin": margin,
        "title": title,
    }
    return {"data": traces, "layout": {**_LAYOUT, **own}}


def _plain(text: str) -> str:
    """A text in which Plotly finds no tags."""
    return text.replace("&", "&amp;").replace("<", "&lt;")


def _trace(panel: Panel, part: Part, maps: list[Cells]) -> Iterator[dict[str, Any]]:
    if isinstance(part, Line):
        yield _line(part)
    elif isinstance(part, Label):
        yield _label(panel, part, bool(maps))
    elif isinstance(part, Cells):
        yield _cells(part, np.concatenate([np.ravel(one.values) for one in maps]))
    elif isinstance(part, Band):
        yield _band(part)
    elif isinstance(part, Bars):
        width = np.diff(part.edges)
        look = {"color": colour(part.colour), "opacity": 0.6, "line": {"width": 1, "color": "white"}}
        middle = part.edges[:-1] + 0.5 * width
        yield {"type": "bar", "x": middle, "y": part.counts, "width": width, "showlegend": False, "marker": look}


def _line(part: Line) -> dict[str, Any]:
    own = colour(part.colour)
    drawn: dict[str, Any] = {"type": "scatter", "x": part.x, "y": part.y, "name": _plain(part.name), "showlegend": bool(part.name)}
    drawn["mode"] = "+".join(["lines"] * (part.dash >= 0) + ["markers"] * bool(part.marker)) or "none"
    drawn["line"] = {"color": own, "width": 1.25 * part.width, "dash": _DASHES[max(part.dash, 0)]}
    drawn["marker"] = {"color": own, "size": 3 if part.marker == "." else 6, "symbol": _MARKERS.get(part.marker, "circle")}
    if part.error is not None:
        drawn["error_y"] = {"type": "data", "array": part.error, "thickness": 1, "width": 3}
    return drawn if part.name else {**drawn, "hoverinfo": "x+y"}


def _band(part: Band) -> dict[str, Any]:
    around = {"x": np.concatenate([part.x, part.x[::-1]]), "y": np.concatenate([part.low, part.high[::-1]])}
    look = {"mode": "none", "fill": "toself", "fillcolor": colour(part.colour), "opacity": 0.15, "hoverinfo": "skip"}
    return {"type": "scatter", **around, **look, "name": _plain(part.name), "showlegend": bool(part.name)}


def _rule(part: Rule, on_map: bool) -> dict[str, Any]:
    along, across = ("x", "y") if part.vertical else ("y", "x")
    ends = {f"{along}0": part.at, f"{along}1": part.at, f"{across}0": 0, f"{across}1": 1, f"{across}ref": f"{across} domain"}
    line = {"color": colour(part.colour), "width": 1.0, "dash": _DASHES[part.dash]}
    return {"type": "line", **ends, "line": line, "layer": "above" if on_map else "below"}


def _name(panel: Panel, part: Rule, lower: int) -> dict[str, Any]:
    """The name of a rule at its end; it is not cut off at the axes. lower : shift of the name of a vertical rule [px]"""
    at = math.log10(part.at) if (panel.x if part.vertical else panel.y).log else part.at
    place: dict[str, Any] = {"x": 1, "xref": "x domain", "xanchor": "right", "y": at, "yref": "y", "yanchor": "bottom"}
    if part.vertical:
        anchor = "left" if side_of(panel, Label(part.at, 0.0, "")) == "right" else "right"
        place = {"x": at, "xref": "x", "xanchor": anchor, "y": 1, "yref": "y domain", "yanchor": "top", "yshift": -lower}
    font = {"size": 11, "color": colour(part.colour), "shadow": _outline("white")}
    return {"text": _plain(part.name), "showarrow": False, "font": font, **place}


def _outline(of: str) -> str:
    return ", ".join(f"{x}px {y}px 1px {of}" for x in (-1, 1) for y in (-1, 1))


def _label(panel: Panel, part: Label, on_map: bool) -> dict[str, Any]:
    font: dict[str, Any] = {"color": colour(part.colour), "size": 11}
    if on_map:  # legible on any colour
        font["shadow"] = _outline("black" if part.colour == "white" else "white")
    marker = {"symbol": _MARKERS[part.marker], "size": 8, "color": "rgba(0,0,0,0)", "line": {"color": font["color"], "width": 1.5}}
    height, side = place_of(panel, part)
    place = {"textposition": f"{'top' if height == 'above' else 'bottom'} {side}", "cliponaxis": False}
    text = {"text": [_plain(part.text)], "mode": "markers+text", "textfont": font, "marker": marker}
    return {"type": "scatter", "x": [part.x], "y": [part.y], "showlegend": False, "hoverinfo": "text", **text, **place}


def _cells(part: Cells, every: Array) -> dict[str, Any]:
    """A map. every : values of all maps of the panel, which share one bar"""
    low, high = limits(part)
    cut = [f"\u2264 {low:.4g}"] * bool(np.nanmin(every) < low) + [f"\u2265 {high:.4g}"] * bool(np.nanmax(every) > high)
    title = f"{part.axis.title}<br>ends: {', '.join(cut)}" if cut else part.axis.title
    bar = {"title": {"text": title, "side": "right"}, "thickness": 12, "outlinewidth": 0, "exponentformat": "power"}
    look = {"zmin": low, "zmax": high, "showscale": part.bar, "colorbar": bar}
    look["colorscale"] = "RdBu_r" if part.two_sided else "Viridis"
    # for the eye: half the bytes
    return {"type": "heatmap", "x": part.x, "y": part.y, "z": np.float32(part.values), "showlegend": False, **look}


def _side(panel: Panel, axis: Axis, name: str) -> dict[str, Any]:
    """The axis of a panel; ends that are not given follow from the data."""
    made: dict[str, Any] = {**_SIDE, "title": {"standoff": 8, "text": _plain(axis.title)}}
    low, high = axis.low, axis.high
    if axis.log:
        found = np.concatenate([getattr(part, name) for part in panel.parts if isinstance(part, Line)])
        first, last = np.nanmin(found[found > 0.0]), np.nanmax(found)
        steps = [k * 10.0**n for n in range(math.floor(math.log10(first)) - 1, math.ceil(math.log10(last)) + 1) for k in (1, 2, 5)]
        made |= {"type": "log", "dtick": 1}
        made |= {"tickvals": steps, "ticktext": [f"{one:g}" for one in steps]} if last < DECADES * first else {}
        low, high = (end if end is None else math.log10(end) for end in (low, high))
    elif axis.names:
        made |= {"tickvals": [*range(1, len(axis.names) + 1)], "ticktext": [*map(_plain, axis.names)], "tickangle": -90}
    elif axis.whole:
        made |= {"tickformat": "d"} | ({"dtick": 1} if high is not None and high <= _WHOLE else {})
    if low is not None and high is not None:
        return made | {"range": [low, high]}
    return made | {"autorangeoptions": {"minallowed": low, "maxallowed": high}}
