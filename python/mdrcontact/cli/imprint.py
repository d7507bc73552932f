# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact imprint`: unloading of a plastic contact, and the indenter that it is an elastic contact of."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import imprint
from . import files
from .table import as_csv, as_text

HELP = "unload a plastic contact: residual depth, effective indenter, recovered work"
_ROWS = 12


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "all rows of the table", "needs the table [imprint]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = imprint(problem, progress=progress)
    print(f"{found.title}\n\n{as_text(found.tables['states'], _ROWS)}")
    for note in found.notes.values():
        print(f"\n{note}")
    files.write(arguments, csv=lambda: as_csv(found.tables["states"]), plot=found.figure)
