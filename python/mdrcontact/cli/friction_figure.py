# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of the command `friction`: loops, and the energy of a cycle against its amplitude."""

from __future__ import annotations

import numpy as np

from ..problem import Problem
from ..problem.units import ENERGY, FORCE, LENGTH, practical
from .cycles import Cycles
from .figures import COLOURS, _figure, _render, _style


def friction_figure(problem: Problem, found: Cycles, form: str) -> bytes:
    """Tangential force along some cycles, and the energy that each dissipates."""
    with _style():
        figure, axes = _figure(problem.title, 1, 2, (9.6, 4.2))
        length = practical(LENGTH, found.loops[-1].shift)
        force = practical(FORCE, found.loops[-1].tangential_force)
        for i, loop in enumerate(reversed(found.loops)):
            shown = loop._replace(shift=length.of(loop.shift), tangential_force=force.of(loop.tangential_force))
            shown.plot(axes[0], color=COLOURS[i % len(COLOURS)])
        limit = float(force.of(found.friction.coefficient * float(found.state.force)))
        for sign in (-1.0, 1.0):
            axes[0].axhline(sign * limit, color="#707070", linewidth=0.8, linestyle=":")
        axes[0].set(xlabel=f"shift s [{length.symbol}]", ylabel=f"tangential force T [{force.symbol}]")
        shifts, energies = np.asarray(found.turns.shift), found.energies
        positive = energies > 0.0
        energy, along = practical(ENERGY, energies), practical(LENGTH, shifts)
        if positive.any():
            axes[1].loglog(along.of(shifts[positive]), energy.of(energies[positive]), "o-", color=COLOURS[0], markersize=4)
        axes[1].axvline(float(along.of(found.sliding_shift)), color="#707070", linewidth=0.8, linestyle=":")
        axes[1].annotate(
            "sliding", (float(along.of(found.sliding_shift)), 0.02), xycoords=("data", "axes fraction"), ha="right", color="#707070"
        )
        axes[1].set(xlabel=f"amplitude of the shift [{along.symbol}]", ylabel=f"energy of a cycle [{energy.symbol}]")
        return _render(figure, form)
