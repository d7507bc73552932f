# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of the command `stress`."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._units import FORCE, LENGTH, MODULUS, Unit, practical
from ..critical import Maximum
from ..studies.stress import StressResult, interface_name, layer_name
from .figures import _GREY, COLOURS, sheet

_LEVELS = 24


def stress_figure(found: StressResult) -> Any:
    """Maps of von Mises stress and largest tension, stresses along the axis, along the interfaces and the surface."""
    # maps of equal scales: their width fixes their height
    first, last = found.maps[0], found.maps[-1]
    height = 4.2 * float((last.z[-1] - first.z[0]) / (first.x[-1] - first.x[0])) + 0.7
    with sheet(_title(found), 2, 2, (11.0, 5.0 + height)) as (figure, axes):
        axes[0, 0].get_gridspec().set_height_ratios([height, 4.2])
        length = practical(LENGTH, [found.maps[-1].z[-1]])
        _draw_map(figure, axes[0, 0], found, length, "von_mises")
        _draw_map(figure, axes[0, 1], found, length, "tension")
        _draw_axis(axes[1, 0], found, length)
        _draw_faces(axes[1, 1], found, length)
    return figure


def _title(found: StressResult) -> str:
    force, radius = (practical(d, [float(v)]) for d, v in ((FORCE, found.state.force), (LENGTH, found.state.radius)))
    text = f"{found.title}\nF = {float(force.of(found.state.force)):.4g} {force.symbol}"
    text += f", a = {float(radius.of(found.state.radius)):.4g} {radius.symbol}"
    if found.friction:
        text += f", sliding to the right with friction {found.friction:g}"
    return text


def _draw_map(figure: Any, axis: Any, found: StressResult, length: Unit, what: str) -> None:
    from matplotlib.ticker import MaxNLocator

    values = [np.asarray(layer.field.von_mises if what == "von_mises" else layer.field.principal[..., 0]) for layer in found.maps]
    finite = np.concatenate([v[np.isfinite(v)] for v in values])
    # a singular edge must not use up all colours
    top = min(float(finite.max()), 3.0 * float(np.quantile(finite, 0.99)))
    unit = practical(MODULUS, [top])
    if what == "von_mises":
        levels, colours = np.linspace(0.0, float(unit.of(top)), _LEVELS), "viridis"
    else:
        levels, colours = np.linspace(-1.0, 1.0, 2 * _LEVELS + 1) * float(unit.of(top)), "RdBu_r"
    for layer, value in zip(found.maps, values, strict=True):
        shown = np.clip(unit.of(value), levels[0], levels[-1])
        drawn = axis.contourf(length.of(layer.x), length.of(layer.z), shown.T, levels, cmap=colours)
    # as high as the map, whose height follows from equal scales
    bar = figure.colorbar(drawn, cax=axis.inset_axes((1.03, 0.0, 0.035, 1.0)), ticks=MaxNLocator(6))
    bar.set_label(f"{'von Mises stress' if what == 'von_mises' else 'largest principal stress'} [{unit.symbol}]")
    dark = "#ffffff" if what == "von_mises" else "#000000"
    a = float(found.state.radius)
    for depth in found.faces[1:]:
        if depth < found.maps[-1].z[-1]:
            axis.axhline(length.of(depth), color=dark, linewidth=0.9)
    axis.plot(length.of(np.array([-a, a])), [0.0, 0.0], color="#000000", linewidth=5.0, solid_capstyle="butt", clip_on=False)
    for i, largest in enumerate(found.critical.layers):
        maximum = largest.von_mises if what == "von_mises" else largest.tension
        if what == "von_mises" or maximum.value > 0.0:
            last = i == len(found.critical.layers) - 1
            _mark(axis, maximum, found, length, unit, layer_name(found.faces, i), dark, below=last or maximum.z == 0.0)
    surface = found.critical.surface
    if what == "tension" and surface.value > 0.0 and surface[1:] != found.critical.layers[0].tension[1:]:
        _mark(axis, surface, found, length, unit, "surface", dark, below=True)
    axis.set(xlabel=f"x [{length.symbol}]", ylabel=f"depth z [{length.symbol}]", aspect="equal")
    axis.set_xlim(*length.of(np.array([found.maps[0].x[0], found.maps[0].x[-1]])))
    axis.set_ylim(float(length.of(found.maps[-1].z[-1])), 0.0)
    axis.grid(False)


def _mark(axis: Any, maximum: Maximum, found: StressResult, length: Unit, unit: Unit, name: str, colour: str, below: bool) -> None:
    place = -maximum.r if maximum.angle else maximum.r
    if abs(place) > found.maps[0].x[-1] or maximum.z > found.maps[-1].z[-1]:
        return
    point = float(length.of(place)), float(length.of(maximum.z))
    axis.plot(*point, "o", markersize=6, markerfacecolor="none", markeredgecolor=colour, markeredgewidth=1.4, clip_on=False)
    right = place < 0.6 * found.maps[0].x[-1]
    label = f"{name} {float(unit.of(maximum.value)):.4g}"
    offset = (7 if right else -7, -13 if below else 6)
    axis.annotate(label, point, xytext=offset, textcoords="offset points", color=colour, ha="left" if right else "right")


def _draw_axis(axis: Any, found: StressResult, length: Unit) -> None:
    middle = len(found.maps[0].x) // 2
    names = (("von_mises", "von Mises"), ("s_rr", r"$\sigma_{rr}$"), ("s_zz", r"$\sigma_{zz}$"))
    columns = {name: [np.asarray(getattr(layer.field, name))[middle] for layer in found.maps] for name, _ in names}
    largest = np.concatenate([v for part in columns.values() for v in part])
    unit = practical(MODULUS, largest[np.isfinite(largest)])
    for i, (name, words) in enumerate(names):
        for j, (layer, values) in enumerate(zip(found.maps, columns[name], strict=True)):
            axis.plot(length.of(layer.z), unit.of(values), color=COLOURS[i], label=words if j == 0 else None)
    for depth in found.faces[1:]:
        if depth < found.maps[-1].z[-1]:
            axis.axvline(length.of(depth), color=_GREY, linewidth=0.8, linestyle=":")
    axis.axhline(0.0, color=_GREY, linewidth=0.8)
    axis.set(xlabel=f"depth z on the axis [{length.symbol}]", ylabel=f"stress [{unit.symbol}]", xlim=(0.0, None))
    axis.legend()


def _draw_faces(axis: Any, found: StressResult, length: Unit) -> None:
    a = float(found.state.radius)
    x = found.lines[0].x
    lines = []
    outside = np.abs(x) > a * (1.0 + 1e-6)
    for i, (z, _, field) in enumerate(found.lines):
        if z == 0.0:
            lines.append((r"$\sigma_{rr}$, free surface", np.where(outside, np.asarray(field.s_rr), np.nan)))
            continue
        name = interface_name(found.faces, i - 1)
        lines += [
            (rf"$\tau$, {name}", np.hypot(field.s_rz, field.s_tz)),
            (rf"$\sigma_{{zz}}$, {name}", np.asarray(field.s_zz)),
        ]
    unit = practical(MODULUS, np.concatenate([v[np.isfinite(v)] for _, v in lines]))
    for i, (words, values) in enumerate(lines):
        axis.plot(length.of(x), unit.of(values), color=COLOURS[i % len(COLOURS)], label=words)
    for edge in (-a, a) if found.friction else (a,):
        axis.axvline(length.of(edge), color=_GREY, linewidth=0.8, linestyle=":")
    axis.axhline(0.0, color=_GREY, linewidth=0.8)
    axis.set(xlabel=f"{'x' if found.friction else 'r'} [{length.symbol}]", ylabel=f"stress [{unit.symbol}]")
    axis.legend()
