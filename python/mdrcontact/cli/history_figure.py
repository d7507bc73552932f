# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of `mdrcontact history`: depth, radius and force in time, and force against depth."""

from __future__ import annotations

from typing import Any

from .._units import FORCE, LENGTH, TIME, practical
from ..studies.history import HistoryResult
from .figures import COLOURS, sheet


def draw(found: HistoryResult) -> Any:
    """Depth, contact radius and force against time, and the loop of force against depth."""
    history = found.history
    with sheet(found.title, 2, 2, (8.4, 6.4)) as (figure, axes):
        time = practical(TIME, history.time)
        panels = (
            ("indentation depth d", history.depth, LENGTH),
            ("contact radius a", history.radius, LENGTH),
            ("force F", history.force, FORCE),
        )
        for axis, colour, (name, values, dimension) in zip(axes.flat, COLOURS, panels, strict=False):
            unit = practical(dimension, values)
            axis.plot(time.of(history.time), unit.of(values), color=colour)
            axis.set(xlabel=f"time t [{time.symbol}]", ylabel=f"{name} [{unit.symbol}]")
        depth, force = practical(LENGTH, history.depth), practical(FORCE, history.force)
        axes.flat[3].plot(depth.of(history.depth), force.of(history.force), color=COLOURS[3])
        axes.flat[3].set(xlabel=f"indentation depth d [{depth.symbol}]", ylabel=f"force F [{force.symbol}]")
    return figure
