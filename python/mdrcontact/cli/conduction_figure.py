# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of `mdrcontact conduction`: conductance against force, and a section through the bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._units import FORCE, LENGTH, practical
from ..studies.conduction import ConductionResult, SectionField
from .figures import COLOURS, sheet


def draw(found: ConductionResult) -> Any:
    """Conductance along the load curve, and the potential or temperature in a section at the last state, with the layers drawn."""
    values, forces = np.asarray(found.conductance.conductance), np.asarray(found.states.force)
    with sheet(found.title, 1, 2, (9.0, 3.8)) as (figure, axes):
        force, unit = practical(FORCE, forces), practical(found.dimension, values)
        axes.flat[0].plot(force.of(forces), unit.of(values), color=COLOURS[0])
        axes.flat[0].set(xlabel=f"force F [{force.symbol}]", ylabel=f"conductance G [{unit.symbol}]")
        if found.section is not None:
            _draw_section(figure, axes.flat[1], found, found.section)
    return figure


def _draw_section(figure: Any, axis: Any, found: ConductionResult, section: SectionField) -> None:
    """What the lower body has at the last state."""
    a, deep = float(found.states[-1].radius), float(section.z[-1])
    length = practical(LENGTH, [section.x[-1]])
    drawn = axis.contourf(length.of(section.x), length.of(section.z), section.values, levels=24, cmap="inferno")
    depth = 0.0
    for _, thickness in found.problem.medium._stack():
        depth += thickness
        if depth < deep:
            axis.axhline(length.of(depth), color="#ffffff", linewidth=1.2)
    axis.plot(length.of([-a, a]), [0.0, 0.0], color="#56B4E9", linewidth=4.0, solid_capstyle="butt", clip_on=False)
    axis.grid(visible=False)
    title = "temperature rise [K]" if section.is_heated else "part of the potential"
    axis.set(xlabel=f"x [{length.symbol}]", ylabel=f"depth z [{length.symbol}]", title=title)
    axis.set_ylim(float(length.of(deep)), 0.0)
    figure.colorbar(drawn, ax=axis, shrink=0.85)
