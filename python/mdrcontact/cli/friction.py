# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact friction`: fretting loops or a path of a contact with friction, and the dissipated energy."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import friction
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute fretting loops or a path: partial slip, sliding, dissipated energy"
_ROWS = 24


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "forces, stick radii and energies of all amplitudes or steps", "needs the table [friction]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = friction(problem, loops=arguments.plot is not None, progress=progress)
    table = found.tables["states"]
    print("\n\n".join([found.title, *found.notes.values(), as_text(table, _ROWS)]))
    files.write(arguments, csv=lambda: as_csv(table), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure)
