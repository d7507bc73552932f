# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact modulus`: film modulus at every depth of a dynamic measurement, and at zero depth."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from .._text import listed
from ..instruments.files.fit_file import load_fit_file
from ..studies import modulus
from . import files, pages
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "find the film modulus at each depth of dynamic (CSM) data, and at zero depth"
_ROWS = 20


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_fit(parser, "the modulus at each depth", "table of depth, force and stiffness", "indenter, medium, data and fit")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load_fit_file(arguments.problem)
    print(f"{problem.title}\n")
    data, notes = problem.read_data(arguments.data)
    print(listed(arguments.data, notes))
    with on_terminal() as progress:
        found = modulus(problem, data, progress=progress)
    print(f"\n{as_text(found.tables['points'], _ROWS)}")
    for note in found.notes.values():
        print(f"\n{note}")
    for words in found.doubts:
        print(f"warning: {words}")
    files.write(
        arguments,
        csv=lambda: as_csv(found.tables["points"]),
        xlsx=lambda: as_xlsx(found, arguments.command),
        json=found.to_dict,
        plot=found.figure,
        report=lambda: pages.modulus_page(found, notes, files.origin(arguments)),
    )
