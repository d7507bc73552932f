# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact wear`: wear of a sliding indenter at constant force or depth."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import wear
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute the wear of a sliding indenter: radius, depth, worn profile"
_ROWS = 24


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "radii, depths and forces of the sliding distances", "needs the table [wear]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = wear(problem, progress=progress)
    print(f"{found.title}\n\n{found.notes['end']}\n\n{as_text(found.tables['states'], _ROWS)}")
    files.write(
        arguments, csv=lambda: as_csv(found.tables["states"]), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure
    )
