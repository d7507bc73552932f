# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact friction`: fretting loops or a path of a contact with friction, and the energy it dissipates."""

from __future__ import annotations

import argparse
from functools import partial

import numpy as np

from .._units import ENERGY, FORCE, LENGTH, RATIO, STIFFNESS, shown
from ..problem import load_with
from . import files
from .cycles import Cycles, cycles
from .friction_figure import friction_figure, path_figure
from .friction_path import LedPath, lead
from .table import Column, as_csv, as_text, column, columns_of

HELP = "fretting loops or any path: partial slip, sliding, dissipated energy"
DESCRIPTION = """\
Displaces the indenter to and fro along the surface, at the largest depth, force or radius of the problem: tangential force, stick
radius and energy dissipated in a cycle for each amplitude, and where sliding begins.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact friction problem.toml
    mdrcontact friction problem.toml --csv energies.csv --plot loops.png

The problem file has one table more than for the other commands:

    [friction]
    coefficient = 0.3
    shifts = ["5 nm", "10 nm", "20 nm"]       # amplitudes; or tangential_forces = ["1 mN", ...];
                                              # without either from 1 % to 150 % of the shift of sliding

or a path on which the normal load changes too, from a table with columns such as "depth [nm]" or "force [mN]", and "shift [nm]" or
"tangential force [mN]"; [compute] is not needed:

    [friction]
    coefficient = 0.3
    path = "path.csv"           # each row is a step, the first one from touch at shift 0 on
    normal = "depth"            # or force: which leads, for a table with both
    tangential = "shift"        # or tangential_force
    rings = 100                 # where springs interact (coated, layered, graded bodies)

It is exact on homogeneous bodies. On others the error is stated: the difference from half the rings.
"""

_ROWS = 24


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "forces, stick radii and energies of amplitudes or steps", "it has a table [friction]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem, sliding = load_with(arguments.problem, "friction")
    if sliding.path is None:
        found = cycles(problem, sliding, with_loops=bool(arguments.plot))
        words, table, draw = _words(found), columns(found), partial(friction_figure, problem, found)
    else:
        led = lead(problem, sliding, sliding.path)
        words, table, draw = _path_words(led), path_columns(led), partial(path_figure, problem, led)
    print(f"{problem.title}\n\n{words}\n\n{as_text(table, _ROWS)}")
    files.write(arguments, csv=lambda: as_csv(table), plot=draw)


def columns(found: Cycles) -> list[Column]:
    """What the table shows."""
    turns, radius = found.turns, float(found.state.radius)
    return [
        *columns_of(turns, "shift", "tangential_force"),
        column("T/(mu F)", np.asarray(turns.tangential_force) / found.friction.coefficient / float(found.state.force), RATIO),
        *columns_of(turns, "stick_radius"),
        column("c/a", np.asarray(turns.stick_radius) / radius, RATIO),
        *columns_of(turns, "stiffness"),
        column("energy of a cycle", found.energies, ENERGY),
    ]


def path_columns(led: LedPath) -> list[Column]:
    """What the table shows of a path."""
    shear = led.shear
    return [
        column("step", np.arange(1.0, len(np.asarray(shear.shift)) + 1.0), RATIO),
        *columns_of(led.state, "depth", "force"),
        *columns_of(shear, "shift", "tangential_force", "stick_radius", "dissipated_energy"),
        column("sliding", np.asarray(shear.sliding, dtype=float), RATIO),
    ]


def _path_words(led: LedPath) -> str:
    forces = np.asarray(led.shear.tangential_force)
    steps, sliding = len(forces), int(np.count_nonzero(led.shear.sliding))
    largest = int(np.argmax(np.abs(forces)))
    means = (
        f"{led.rings} rings; from half the rings T differs by {led.force_error:.1g} of the largest mu F, the "
        f"dissipated energy by {led.energy_error:.1g} of its end value"
        if led.rings
        else "exact springs"
    )
    return (
        f"path of {steps} steps, {sliding} of them end in sliding; coefficient of friction {led.friction.coefficient:g}\n"
        f"largest tangential force {shown(forces[largest], FORCE)} in step {largest + 1}, dissipated energy "
        f"{shown(np.asarray(led.shear.dissipated_energy)[-1], ENERGY)}\n"
        f"{means}"
    )


def _words(found: Cycles) -> str:
    state, mu = found.state, found.friction.coefficient
    stiffness = float(found.friction.contact.medium.tangential_stiffness(state.radius))
    return (
        f"normal force {shown(state.force, FORCE)}, depth {shown(state.depth, LENGTH)}, contact radius "
        f"{shown(state.radius, LENGTH)}, coefficient of friction {mu:g}\n"
        f"tangential stiffness without slip {shown(stiffness, STIFFNESS)}, {stiffness / float(state.stiffness):.4g} of the "
        "normal one\n"
        f"sliding from shift {shown(found.sliding_shift, LENGTH)} on, under {shown(mu * float(state.force), FORCE)}"
    )
