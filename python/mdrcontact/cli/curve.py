# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact curve`: force, contact radius, stiffness and pressure of one problem."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from .._progress import waiting
from .._units import LENGTH, MODULUS, shown
from ..contact import Contact
from ..errors import InvalidArgumentError, MDRError
from ..medium import Pair
from ..problem import Problem, load
from . import figures, files
from .solve import Curve, columns, crossing, progress, solve, thickness
from .table import Column, as_csv, as_text, column, spread_over

HELP = "force, radius, stiffness and pressure of one problem"
DESCRIPTION = """\
Computes one problem: depth, contact radius, force, contact stiffness, effective modulus and mean pressure.

    mdrcontact example sio2_on_si > problem.toml
    mdrcontact curve problem.toml
    mdrcontact curve problem.toml --csv curve.csv --plot curve.png

The table on the screen shows a few rows; the CSV file holds all of them.
"""

_PRESSURE_POINTS = 400


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "all rows of the table")
    parser.add_argument("--pressure-csv", type=Path, metavar="FILE.csv", help="write the pressure distributions to a CSV file")
    parser.add_argument("--rows", type=_rows, default=10, metavar="N", help="rows of the table on the screen (default: 10)")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = load(arguments.problem)
    with waiting("contact"):
        contact = problem.contact()
    with progress(1, problem.control) as bar:
        curve = solve(contact, problem.control, bar)
    table = columns(curve, problem.medium)
    print(f"{problem.title}\n")
    print(as_text(table, arguments.rows))
    for note in (thickness_note(problem, curve), rigid_note(problem, curve)):
        if note:
            print(f"\n{note}")
    pressures: list[tuple[float, Any, Any]] = []
    if arguments.plot or arguments.pressure_csv:
        try:
            pressures = pressure_distributions(contact, curve)
        except InvalidArgumentError as refusal:
            if arguments.pressure_csv:
                raise
            print(f"\nThe picture has no pressures: {refusal}.")
    files.write(
        arguments,
        csv=lambda: as_csv(table),
        pressure_csv=lambda: as_csv(_stacked(pressures)),
        plot=lambda: figures.curve_figure(problem, curve, pressures),
    )


def thickness_note(problem: Problem, curve: Curve) -> str | None:
    """One sentence on where the contact becomes as wide as the coating is thick."""
    h = thickness(problem.medium)
    if h is None:
        return None
    thick = shown(h, LENGTH)
    depth = crossing(curve, h)
    if depth is None:
        side = "stays below" if curve.radius[-1] <= h else "is always above"
        return f"The contact radius {side} the coating thickness, h = {thick}."
    return f"The contact radius equals the coating thickness, a = h = {thick}, at depth {shown(depth, LENGTH)}."


def rigid_note(problem: Problem, curve: Curve) -> str | None:
    """One sentence on what it would have cost to take a deformable indenter as rigid."""
    if not isinstance(problem.medium, Pair):
        return None
    lower: Any = problem.medium.lower
    rigid = problem._replace(medium=lower).contact()
    depths = curve.depth[[0, -1]]
    try:
        excess = [
            100.0 * (float(rigid.at_depth(d).force) / float(f) - 1.0) for d, f in zip(depths, curve.force[[0, -1]], strict=True)
        ]
    except MDRError:
        return None
    return f"With a rigid indenter the force would be {excess[0]:+.1f} % off at the first depth, {excess[1]:+.1f} % at the last."


def pressure_distributions(contact: Contact, curve: Curve) -> list[tuple[float, Any, Any]]:
    """(depth, r, p) at a quarter, half and the end of the curve; points where theory gives infinite pressure are left out."""
    result = []
    count = len(curve.depth)
    quarters = spread_over(count, 4)
    for i in (quarters[0], quarters[1], quarters[3]) if count > 3 else range(count):
        # dense towards the edge, where pressures are steep, and a hair inside it: the edge itself is a matter of rounding
        r = curve.radius[i] * (1.0 - 1e-9) * np.sin(np.linspace(0.0, np.pi / 2, _PRESSURE_POINTS))
        p = np.asarray(contact.at_depth(float(curve.depth[i])).pressure(r))
        finite = np.isfinite(p)
        result.append((float(curve.depth[i]), r[finite], p[finite]))
    return result


def _stacked(pressures: list[tuple[float, Any, Any]]) -> list[Column]:
    depth = np.concatenate([np.full(len(r), d) for d, r, _ in pressures])
    return [
        column("depth", depth, LENGTH),
        column("r", np.concatenate([r for _, r, _ in pressures]), LENGTH),
        column("pressure", np.concatenate([p for _, _, p in pressures]), MODULUS),
    ]


def _rows(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of rows: it must be a whole number, at least 1")
    return int(text)
