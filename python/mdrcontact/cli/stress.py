# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact stress`: largest stresses inside a body, and the load at first failure."""

from __future__ import annotations

import argparse
import math

from .._progress import on_terminal
from ..problem import load
from ..studies import stress
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute stresses inside a body, and the load at first failure"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("problem", metavar="PROBLEM.toml", help="problem file")
    parser.add_argument(
        "--friction", type=_friction, default=0.0, metavar="F", help="coefficient of friction of a sliding indenter (default: 0)"
    )
    files.add_options(parser, "displacements and stresses on a grid")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    draws = arguments.plot is not None
    with on_terminal() as progress:
        found = stress(
            problem,
            friction=arguments.friction,
            maps=draws or bool(arguments.csv or arguments.xlsx),
            lines=draws,
            progress=progress,
        )
    notes, tables = found.notes, found.tables
    parts = [found.title, notes["state"], as_text(tables["maxima"]), notes["energy"]]
    if "failures" in tables:
        parts += [notes["failures"], as_text(tables["failures"])]
    if "unreached" in notes:
        parts.append(notes["unreached"])
    print("\n\n".join(parts))
    files.write(arguments, csv=lambda: as_csv(tables["grid"]), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure)


def _friction(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0.0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"friction = {text!r}: it must be a number, at least 0")
    return value
