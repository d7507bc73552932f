# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact friction`: fretting loops of a contact with friction and the energy they dissipate."""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from ..problem import ProblemError, load
from ..problem.units import ENERGY, FORCE, LENGTH, RATIO, STIFFNESS, told
from . import files
from .cycles import Cycles, cycles
from .friction_figure import friction_figure
from .table import Column, as_csv, as_text, column

_DESCRIPTION = """\
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
"""

_ROWS = 24


def add(subparsers: Any) -> None:
    """Adds the command to the command line."""
    parser = subparsers.add_parser(
        "friction",
        help="fretting loops: partial slip, sliding, dissipated energy",
        description=_DESCRIPTION,
    )
    parser.add_argument("problem", metavar="PROBLEM.toml", help="the problem file; it has a table [friction]")
    files.add_options(parser, "amplitudes, forces, stick radii and energies")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = load(arguments.problem)
    if problem.friction is None:
        raise ProblemError(f"{arguments.problem}: the table [friction] is missing: write it with coefficient = 0.3")
    found = cycles(problem, problem.friction, with_loops=bool(arguments.plot))
    table = columns(found)
    print(f"{problem.title}\n\n{_words(found)}\n\n{as_text(table, _ROWS)}")
    results = {}
    if arguments.csv:
        results[arguments.csv] = as_csv(table)
    if arguments.plot:
        results[arguments.plot] = friction_figure(problem, found, files.figure_format(arguments.plot))
    files.write(results, arguments.overwrite)


def columns(found: Cycles) -> list[Column]:
    """What the table shows."""
    turns, radius = found.turns, float(found.state.radius)
    return [
        column("shift", np.asarray(turns.shift), LENGTH),
        column("tangential force", np.asarray(turns.tangential_force), FORCE),
        column("T/(mu F)", np.asarray(turns.tangential_force) / found.friction.coefficient / float(found.state.force), RATIO),
        column("stick radius", np.asarray(turns.stick_radius), LENGTH),
        column("c/a", np.asarray(turns.stick_radius) / radius, RATIO),
        column("stiffness", np.asarray(turns.stiffness), STIFFNESS),
        column("energy of a cycle", found.energies, ENERGY),
    ]


def _words(found: Cycles) -> str:
    state, mu = found.state, found.friction.coefficient
    stiffness = float(found.friction.contact.medium.tangential_stiffness(state.radius))
    return (
        f"normal force {told(state.force, FORCE)}, depth {told(state.depth, LENGTH)}, contact radius "
        f"{told(state.radius, LENGTH)}, coefficient of friction {mu:g}\n"
        f"tangential stiffness without slip {told(stiffness, STIFFNESS)}, {stiffness / float(state.stiffness):.4g} of the "
        "normal one\n"
        f"sliding from shift {told(found.sliding_shift, LENGTH)} on, under {told(mu * float(state.force), FORCE)}"
    )
