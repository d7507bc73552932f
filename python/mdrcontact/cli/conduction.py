# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact conduction`: conductance of a contact along a load curve, and temperatures by friction."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import conduction
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute the conductance of heat or current through a contact along its loading"
_ROWS = 12


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "all rows of the table", "needs the table [conduction]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = conduction(problem, section=arguments.plot is not None, progress=progress)
    print(f"{found.title}\n\n{as_text(found.tables['states'], _ROWS)}\n\n{found.notes['conductance']}")
    files.write(
        arguments, csv=lambda: as_csv(found.tables["states"]), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure
    )
