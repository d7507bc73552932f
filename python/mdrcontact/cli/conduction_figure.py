# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of `mdrcontact conduction`: conductance against force, and a section through the bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._units import CONDUCTANCE, FORCE, LENGTH, THERMAL_CONDUCTANCE, practical
from ..conduction import Conduction
from ..contact import State
from ..problem import Problem
from ..problem.conduction import THERMAL
from .figures import COLOURS, sheet

_WIDE, _SHALLOWEST, _DEEPEST, _LAYERS = 2.5, 0.5, 2.5, 5.0
"""Contact radii to the sides that the section shows; into the body so many thicknesses of its layers, between two contact radii."""
_POINTS = 61


def draw(problem: Problem, conduction: Conduction, states: State) -> Any:
    """Conductance along the load curve, and the potential or temperature in a section at the last state, with the layers drawn."""
    found = conduction.along(states)
    kind = problem.conduction.kind if problem.conduction else THERMAL
    dimension = THERMAL_CONDUCTANCE if kind == THERMAL else CONDUCTANCE
    values = np.asarray(found.conductance)
    with sheet(problem.title, 1, 2, (9.0, 3.8)) as (figure, axes):
        force, unit = practical(FORCE, np.asarray(states.force)), practical(dimension, values)
        axes.flat[0].plot(force.of(states.force), unit.of(values), color=COLOURS[0])
        axes.flat[0].set(xlabel=f"force F [{force.symbol}]", ylabel=f"conductance G [{unit.symbol}]")
        _section(figure, axes.flat[1], problem, conduction, states)
    return figure


def _section(figure: Any, axis: Any, problem: Problem, conduction: Conduction, states: State) -> None:
    """What the lower body has at the last state."""
    last = states[-1]
    a = float(last.radius)
    thicknesses = [thickness for _, thickness in problem.medium._stack()]
    deep = float(np.clip(_LAYERS * sum(thicknesses) or np.inf, _SHALLOWEST * a, _DEEPEST * a))
    x, z = np.linspace(-_WIDE, _WIDE, 2 * _POINTS - 1) * a, np.linspace(0.0, deep, _POINTS)
    half = np.abs(x[_POINTS - 1 :])
    heat = problem.conduction.heat if problem.conduction else None
    if heat is None:
        field = conduction.at_radius(a).potential(half[None, :], z[:, None])
        title = "part of the potential"
    else:
        field = conduction.friction_heat(last, *heat).temperature(half[None, :], z[:, None])
        title = "temperature rise [K]"
    whole = np.concatenate([np.asarray(field)[:, :0:-1], np.asarray(field)], axis=1)
    length = practical(LENGTH, [_WIDE * a])
    drawn = axis.contourf(length.of(x), length.of(z), whole, levels=24, cmap="inferno")
    depth = 0.0
    for thickness in thicknesses:
        depth += thickness
        if depth < deep:
            axis.axhline(length.of(depth), color="#ffffff", linewidth=1.2)
    axis.plot(length.of([-a, a]), [0.0, 0.0], color="#56B4E9", linewidth=4.0, solid_capstyle="butt", clip_on=False)
    axis.grid(visible=False)
    axis.set(xlabel=f"x [{length.symbol}]", ylabel=f"depth z [{length.symbol}]", title=title)
    axis.set_ylim(float(length.of(deep)), 0.0)
    figure.colorbar(drawn, ax=axis, shrink=0.85)
