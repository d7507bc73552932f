# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the command `friction`: loops, and the energy of a cycle against its amplitude; a path, and its energy."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._units import ENERGY, FORCE, LENGTH, practical
from ..studies.friction import CyclesResult, FrictionResult, PathResult
from .figures import COLOURS, sheet


def friction_figure(found: FrictionResult) -> Any:
    """The figure of cycles, or that of a path."""
    if isinstance(found, PathResult):
        return _path_figure(found)
    assert isinstance(found, CyclesResult)
    return _cycles_figure(found)


def _cycles_figure(found: CyclesResult) -> Any:
    """Tangential force along some cycles, and the energy that each dissipates."""
    with sheet(found.title, 1, 2, (9.6, 4.2)) as (figure, axes):
        length = practical(LENGTH, found.loops[-1].shift)
        force = practical(FORCE, found.loops[-1].tangential_force)
        for i, loop in enumerate(reversed(found.loops)):
            shown = loop._replace(shift=length.of(loop.shift), tangential_force=force.of(loop.tangential_force))
            shown.plot(axes[0], color=COLOURS[i % len(COLOURS)])
        limit = float(force.of(found.friction.coefficient * float(found.state.force)))
        for sign in (-1.0, 1.0):
            axes[0].axhline(sign * limit, color="#707070", linewidth=0.8, linestyle=":")
        axes[0].set(xlabel=f"shift s [{length.symbol}]", ylabel=f"tangential force T [{force.symbol}]")
        shifts, energies = np.asarray(found.shear.shift), found.energies
        positive = energies > 0.0
        energy, along = practical(ENERGY, energies), practical(LENGTH, shifts)
        if positive.any():
            axes[1].loglog(along.of(shifts[positive]), energy.of(energies[positive]), "o-", color=COLOURS[0], markersize=4)
        axes[1].axvline(float(along.of(found.sliding_shift)), color="#707070", linewidth=0.8, linestyle=":")
        axes[1].annotate(
            "sliding", (float(along.of(found.sliding_shift)), 0.02), xycoords=("data", "axes fraction"), ha="right", color="#707070"
        )
        axes[1].set(xlabel=f"amplitude of the shift [{along.symbol}]", ylabel=f"energy of a cycle [{energy.symbol}]")
    return figure


def _path_figure(found: PathResult) -> Any:
    """Tangential force against shift along a path, and against the steps T between -mu F and mu F, and the energy dissipated."""
    with sheet(found.title, 1, 3, (12.0, 4.0)) as (figure, axes):
        shift, force, lost = (
            np.concatenate([[0.0], np.asarray(values, dtype=float)])
            for values in (found.shear.shift, found.shear.tangential_force, found.shear.dissipated_energy)
        )
        limit = found.friction.coefficient * np.concatenate([[0.0], np.asarray(found.state.force)])
        steps = np.arange(len(shift))
        length, newton, energy = practical(LENGTH, shift), practical(FORCE, np.concatenate([force, limit])), practical(ENERGY, lost)
        slides = np.concatenate([[False], np.asarray(found.shear.sliding)])
        axes[0].plot(length.of(shift), newton.of(force), color=COLOURS[0])
        axes[0].plot(length.of(shift[slides]), newton.of(force[slides]), "o", color=COLOURS[1], markersize=3, label="sliding")
        axes[0].plot(length.of(shift[-1]), newton.of(force[-1]), "s", color="#000000", markersize=4, label="end")
        axes[0].set(xlabel=f"shift s [{length.symbol}]", ylabel=f"tangential force T [{newton.symbol}]")
        axes[0].legend()
        axes[1].fill_between(
            steps,
            -newton.of(limit),
            newton.of(limit),
            color="#eeeeee",
            label="within \N{PLUS-MINUS SIGN}\N{GREEK SMALL LETTER MU}F",
        )
        axes[1].plot(steps, newton.of(force), color=COLOURS[0])
        axes[1].set(xlabel="step", ylabel=f"tangential force T [{newton.symbol}]")
        axes[1].legend()
        axes[2].plot(steps, energy.of(lost), color=COLOURS[2])
        axes[2].set(xlabel="step", ylabel=f"dissipated energy [{energy.symbol}]", ylim=(0, None))
    return figure
