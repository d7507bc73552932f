# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact adhesion`: pull-off, and a loop of approach and retraction."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import adhesion
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute pull-off, and a loop of approach and retraction"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "the loop", "needs the table [adhesion]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = adhesion(problem, progress=progress)
    print(f"{found.title}\n\n{found.notes['adhesion']}\n")
    print(f"{as_text(found.tables['pull-off'])}\n\n{as_text(found.tables['jumps'])}\n\n{found.notes['energy']}")
    files.write(
        arguments, csv=lambda: as_csv(found.tables["loop"]), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure
    )
