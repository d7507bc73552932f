# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact curve`: force, contact radius, stiffness and pressure of one problem."""

from __future__ import annotations

import argparse
from pathlib import Path

from .._progress import on_terminal
from ..problem import load
from ..studies import curve
from . import files
from .table import as_csv, as_text
from .workbook import as_xlsx

HELP = "compute force, contact radius, stiffness and pressure of one problem"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "all rows of the table")
    parser.add_argument(
        "--pressure-csv", type=Path, metavar="FILE.csv", help="write pressure distributions at a few depths to a CSV file"
    )
    parser.add_argument(
        "--rows", type=_rows, default=10, metavar="N", help="number of table rows to print (default: 10); the CSV file has all rows"
    )


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    draws, has_pressures = arguments.plot is not None, bool(arguments.pressure_csv or arguments.xlsx)
    with on_terminal() as progress:
        found = curve(problem, pressures=draws or has_pressures, references=draws, progress=progress)
    print(f"{found.title}\n\n{as_text(found.tables['states'], arguments.rows)}")
    for note in found.notes.values():
        print(f"\n{note}")
    if found.refusal and arguments.pressure_csv:
        raise found.refusal
    if found.refusal:
        print(f"\nThe picture has no pressures: {found.refusal}.")
    files.write(
        arguments,
        csv=lambda: as_csv(found.tables["states"]),
        xlsx=lambda: as_xlsx(found, arguments.command),
        pressure_csv=lambda: as_csv(found.tables["pressures"]),
        plot=found.figure,
    )


def _rows(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"rows = {text!r}: it must be a whole number, at least 1")
    return int(text)
