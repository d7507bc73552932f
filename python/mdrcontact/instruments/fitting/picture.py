# SPDX-License-Identifier: GPL-3.0-or-later
"""Data, fit and residuals as a figure."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..._units import FORCE, LENGTH, QUANTITIES
from ...panels import Axis, Band, Figure, Line, Panel, Rule, along
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
_BEFORE, _MARGIN = 2.0, 0.03
"""Length of baseline shown, in depths of the contact, and the margin next to it, as a fraction of the width."""
_ERROR_BARS = 300
"""Most points that show their standard deviations."""
_HEIGHTS = (1.2, 0.45)
_NORMAL = 1.96
"""Of a standard deviation, on both sides of which 95 % of normal residuals lie."""


def figure_of(
    data: Data,
    noise: float,
    fitted: Array,
    residuals: Array,
    label: str,
    title: Sequence[str],
    doubts: Sequence[str] = (),
    contact: float | None = None,
) -> Figure:
    """The figure, in practical units of SI numbers. Error bars are `noise` times the data's standard deviations. residuals : in
    units of them. contact : depth at which the fit has found first contact."""
    if isinstance(data, StiffnessDepth) and data.unloadings:
        return Figure("\n".join(title), (_unloadings(data),), warnings=tuple(doubts))
    panels = _points(data, noise, fitted, residuals, label, contact)
    return Figure("\n".join(title), panels, 1, _HEIGHTS, tuple(doubts))


def _unloadings(data: StiffnessDepth) -> Panel:
    """The whole test, the part of each unloading curve that is fitted, and the tangent whose slope is the stiffness."""
    assert data.record is not None
    x, length = along(_AXES["depth"], LENGTH, data.record[0])
    y, newton = along(_AXES["force"], FORCE, data.record[1], low=0.0)
    parts = [Line(length.of(data.record[0]), newton.of(data.record[1]), "data", "grey", -1, ".")]
    names = ("power law of the unloading", "contact stiffness S")
    for q in data.unloadings:
        h = np.linspace(q.final_depth, q.depth, 100)
        p = q.force * ((h - q.final_depth) / (q.depth - q.final_depth)) ** q.exponent
        tangent = np.array([q.depth - q.force / q.stiffness, q.depth]), np.array([0.0, q.force])
        parts.append(Line(length.of(h), newton.of(p), "", 0, 2, width=1.0))
        parts.append(Line(length.of(q.fitted_depth), newton.of(q.fitted_force), names[0], 0, width=2.5))
        parts.append(Line(length.of(tangent[0]), newton.of(tangent[1]), names[1], 1, width=1.2))
        names = ("", "")
    return Panel(x, y, tuple(parts))


def _points(data: Data, noise: float, fitted: Array, residuals: Array, label: str, contact: float | None) -> tuple[Panel, Panel]:
    """Data and fit, and residuals below them."""
    is_dynamic = isinstance(data, DynamicStiffness)
    order = data.order()
    x, along_x = along(_AXES[data.x_name], QUANTITIES[data.x_name], data.x, log=is_dynamic)
    y, along_y = along(_AXES[data.y_name], QUANTITIES[data.y_name], data.y, log=is_dynamic)
    low, high = along_x.of(np.array(_ends(data, contact, is_dynamic))).tolist()
    x = x._replace(low=low, high=high)
    parts: list[Line | Rule] = []
    if data.unused is not None and len(data.unused[0]):
        parts.append(Line(along_x.of(data.unused[0]), along_y.of(data.unused[1]), "not used", "pale", -1, "."))
    at, sd = along_x.of(data.x[order]), data.sd if data.sd is not None and len(order) <= _ERROR_BARS else None
    error = None if sd is None else along_y.of(sd[order] * noise)
    parts.append(Line(at, along_y.of(data.y[order]), "data", "grey", -1, ".", error=error))
    parts += _branches(data, at, along_y.of(fitted[order]), label, is_dynamic)
    if contact is not None:
        parts += _contact_points(data, contact, along_x)
    upper = Panel(x, y, tuple(parts))
    band = Band(np.array([low, high]), np.full(2, -_NORMAL), np.full(2, _NORMAL))
    points = Line(at, residuals[order], "", 1, -1, ".")
    below = Panel(x, Axis("residual / sd"), (band, Rule(0.0, colour=0, dash=0), points))
    return upper._replace(x=x._replace(name="", unit="")), below


def _branches(data: Data, x: Array, y: Array, label: str, is_dynamic: bool) -> Iterator[Line]:
    """The fit, a line for each branch."""
    order = data.order()
    turns: Iterable[int] = np.flatnonzero(np.diff(data.branch[order]) != 0) + 1 if data.branch is not None else []
    names = (f"{label}, storage", f"{label}, loss") if is_dynamic else (label,)
    for i, (first, last) in enumerate(pairwise([0, *turns, len(x)])):
        yield Line(x[first:last], y[first:last], names[i] if i < len(names) else "", i if is_dynamic else 0, width=1.2)


def _places(data: Data, contact: float) -> dict[str, float]:
    """First contact of the fit and of the estimators."""
    return {"contact point of the fit": contact, **{f"contact point, {name}": at for name, at in data.contact_points.items()}}


def _contact_points(data: Data, contact: float, unit: Any) -> Iterator[Rule]:
    for i, (name, at) in enumerate(_places(data, contact).items()):
        yield Rule(float(unit.of(at)), True, name, "grey" if i else 0, min(i, 2))


def _ends(data: Data, contact: float | None, is_log: bool) -> tuple[float, float]:
    """Ends of the abscissa: all readings, or the contact and the near part of a long baseline."""
    values = data.x if data.unused is None else np.concatenate([data.x, data.unused[0]])
    first, last = float(values.min()), float(values.max())
    if contact is not None:
        deepest, places = float(data.x.max()), _places(data, contact).values()
        begin = min(contact - _BEFORE * (deepest - contact), *places)
        first, last = (begin, deepest) if begin > first else (min(first, *places), max(last, *places))
    if is_log:
        room = (last / first) ** _MARGIN
        return first / room, last * room
    room = _MARGIN * (last - first) or 1.0
    return first - room, last + room
