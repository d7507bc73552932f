# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact adhesion`: the cycle of approach and retraction of an adhesive contact, and where it breaks."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from ..problem import load
from ..studies import adhesion
from . import files
from .table import as_csv, as_text

HELP = "pull-off, and a loop of approach and retraction"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "the loop", "it has a table [adhesion]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = adhesion(problem, progress=progress)
    print(f"{found.title}\n\n{found.notes['adhesion']}\n")
    print(f"{as_text(found.tables['pull-off'])}\n\n{as_text(found.tables['jumps'])}\n\n{found.notes['energy']}")
    files.write(arguments, csv=lambda: as_csv(found.tables["loop"]), plot=found.figure)
