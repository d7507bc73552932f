# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of contacts: states over depth, fields of one state, cycles. Numbers are taken as SI."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np

from .._units import ANGLE, BENDING, FORCE, LENGTH, MODULUS, STIFFNESS, Dimension, practical, shown
from ..errors import InvalidArgumentError, MDRError
from .figure import Figure
from .panel import Array, Line, Panel, Rule, along, cut, marked

OVER_DEPTH: Sequence[tuple[str, str, Dimension]] = (
    ("force F", "force", FORCE),
    ("contact radius a", "radius", LENGTH),
    ("contact stiffness k", "stiffness", STIFFNESS),
)
"""Name, field and dimension of what a figure of states shows."""
_POINTS = 400
_BETWEEN = np.array([0.25, 0.5, 0.75])
"""Radii, in contact radii, whose pressures give the scale."""
_OUTSIDE = 2.0
"""Part of the surface next to a contact that is shown, in contact radii."""


class Pressure(NamedTuple):
    """The pressure of one state, where it is finite; SI units."""

    depth: float
    r: Array
    pressure: Array


def pressure_of(state: Any, end: float) -> Pressure:
    """Return the pressure of one state up to the edge, dense towards it, where it is steep."""
    # a hair inside: the edge itself depends on rounding
    r = end * (1.0 - 1e-9) * np.sin(np.linspace(0.0, np.pi / 2, _POINTS))
    p = np.asarray(state.pressure(r))
    finite = np.isfinite(p)
    return Pressure(float(state.depth), r[finite], p[finite])


def of_pressures(pressures: Sequence[Pressure], radius: Any) -> Panel:
    """Return the pressures of some states over r, with their depths if there are several. radius : those of the contacts"""
    x, length = along("distance from the axis r", LENGTH, radius, low=0.0)
    # pressures between apex and edge are finite under every tip; infinite ones at an apex or an edge are cut off
    most = 4.0 * max(float(np.abs(np.interp(_BETWEEN * one.r[-1], one.r, one.pressure)).max()) for one in pressures)
    highest = min(most, max(float(one.pressure.max(initial=0.0)) for one in pressures))
    y, unit = along("contact pressure p", MODULUS, [highest])
    depth = practical(LENGTH, [one.depth for one in pressures])
    names = [f"d = {depth.of(one.depth):.3g} {depth.symbol}" for one in pressures] if len(pressures) > 1 else [""]
    lines = (
        Line(length.of(one.r), unit.of(cut(one.pressure, -most, most)), name, i)
        for i, (name, one) in enumerate(zip(names, pressures, strict=True))
    )
    return Panel(x, y, tuple(lines))


def over_depth(states: Any, label: str = "") -> Iterator[Panel]:
    """Return a panel of each quantity of states, in their order. label : name of the line in the first one"""
    d = np.ravel(states.depth)
    x, depth = along("indentation depth d", LENGTH, d)
    # from 0 on, unless an adhesive curve begins far from it and would fill a corner only
    x = x._replace(low=0.0 if 0.0 <= d.min() < 0.5 * d.max() else None)
    for name, quantity, dimension in OVER_DEPTH:
        values = np.ravel(getattr(states, quantity))
        y, unit = along(name, dimension, values)
        y = y._replace(low=0.0 if 0.0 <= values.min() < 0.5 * values.max() else None)
        yield Panel(x, y, (Line(depth.of(d), unit.of(values), label, marker=marked(values)),))
        label = ""


def of_state(state: Any) -> Figure:
    """Return pressure and surface of one state, force, radius and stiffness of several over their depths."""
    if np.ndim(state._columns()[0] if hasattr(state, "_columns") else 0.0):
        return Figure("States of a contact", tuple(over_depth(state)), columns=3)
    end = max(float(state.radius), float(state.zone_radius))
    if not end > 0.0:
        raise InvalidArgumentError(f"radius = {state.radius!r}: a state without contact has no pressure. Plot a state in contact.")
    found = pressure_of(state, end)
    numbers = (("d", state.depth, LENGTH), ("F", state.force, FORCE), ("a", state.radius, LENGTH))
    title = ", ".join(f"{name} = {shown(float(value), dimension)}" for name, value, dimension in numbers)
    panels = [of_pressures([found], found.r)]
    with suppress(MDRError):  # of a medium whose displacement is not known
        panels.append(_surface(state, _OUTSIDE * end))
    return Figure(title, tuple(panels))


def _surface(state: Any, end: float) -> Panel:
    """The displaced surface, and the indenter where it is above it."""
    r = np.linspace(0.0, end, _POINTS)
    u = np.asarray(state.displacement(r))
    x, length = along("distance from the axis r", LENGTH, [end], low=0.0)
    y, depth = along("displacement u", LENGTH, u)
    gap = np.asarray(state.contact.indenter.height(r)) - float(state.depth)
    room = max(float(np.ptp(u)), float(abs(u).max()))
    lines = (
        Line(length.of(r), depth.of(u), "surface"),
        Line(length.of(r), depth.of(cut(-gap, -room, np.inf)), "indenter", "grey", 1),
    )
    return Panel(x, y, (*lines, Rule(float(length.of(float(state.radius))), vertical=True, name="a")), downward=True)


def of_loop(loop: Any) -> tuple[Panel, Panel]:
    """Return force and contact radius along a cycle of approach and retraction."""
    is_spring = loop.control == "spring"
    position = loop.position if is_spring else loop.depth
    x, length = along("position of the spring's end d + F/K" if is_spring else "indentation depth d", LENGTH, position)
    f, newton = along("force F", FORCE, loop.force)
    a, metre = along("contact radius a", LENGTH, loop.radius, low=0.0)
    forces = tuple(_branches(loop, length.of(position), newton.of(loop.force)))
    radii = tuple(_branches(loop, length.of(position), metre.of(loop.radius)))
    return Panel(x, f, (*forces, Rule(0.0, dash=0))), Panel(x, a, radii)


def _branches(loop: Any, x: Array, y: Array) -> Iterator[Line]:
    """Approach and retraction in pieces between the jumps, which are dotted."""
    for name, colour, part, width in (
        ("approach", 1, slice(0, loop.turning_point + 1), 3.2),
        ("retraction", 0, slice(loop.turning_point, len(x)), 1.6),
    ):
        starts = [part.start, *(int(j) + 1 for j in loop.jumps if part.start <= j < part.stop - 1)]
        for start, stop in zip(starts, [*starts[1:], part.stop], strict=True):
            yield Line(x[start:stop], y[start:stop], name if start == part.start else "", colour, 0, "", width)
        for start in starts[1:]:
            yield Line(x[start - 1 : start + 1], y[start - 1 : start + 1], "", colour, 2, "", 1.0)


def of_cycle(cycle: Any) -> Panel:
    """Return the tangential force, or the torque, along a cycle of shift or twist."""
    shift = along("twist \u03c6", ANGLE, cycle.shift) if cycle.around else along("shift s", LENGTH, cycle.shift)
    name, dimension = ("torque M", BENDING) if cycle.around else ("tangential force T", FORCE)
    (x, one), (y, two) = shift, along(name, dimension, cycle.tangential_force)
    return Panel(x, y, (Line(one.of(cycle.shift), two.of(cycle.tangential_force)), Rule(0.0, dash=0)))
