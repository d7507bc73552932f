# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact history`: the contact of a viscoelastic body or a gel along a path in time."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import history
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute the contact of a viscoelastic body or a gel along a path in time"
_ROWS = 12


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "the whole path", "needs the table [history]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = history(problem, progress=progress)
    closing = "\n".join(found.notes.values())
    print(f"{found.title}\n\n{as_text(found.tables['path'], _ROWS)}\n\n{closing}")
    files.write(
        arguments, csv=lambda: as_csv(found.tables["path"]), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure
    )
