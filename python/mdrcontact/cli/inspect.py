# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact inspect`: report what a file of measurements contains."""

from __future__ import annotations

import argparse
from pathlib import Path

from .._progress import on_terminal
from .._text import listed
from ..instruments import schema
from ..problem.section import Section
from ..studies import inspect
from . import files
from .table import as_text

HELP = "report what a file of measurements contains, and write a problem file to start from"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("data", type=Path, metavar="FILE", help="table, spreadsheet or AFM file")
    parser.add_argument(
        "--plot", type=Path, metavar="FILE.png", help="draw the tests and their segments (.png, .pdf or .svg); needs matplotlib"
    )
    parser.add_argument("--problem", type=Path, metavar="START.toml", help="write a problem file to start from")
    parser.add_argument(
        "--columns", nargs="+", metavar="TITLE", default=(), help='titles of the columns with units, as in "depth [nm]"'
    )
    for name, example in (("spring-constant", "0.2 N/m"), ("deflection-sensitivity", "50 nm/V")):
        parser.add_argument(f"--{name}", metavar="VALUE", help=f'{name.replace("-", " ")} of the cantilever, as in "{example}"')
    parser.add_argument("--like", type=Path, metavar="PROBLEM.toml", help="read the file with [data] and [instrument] of this file")
    parser.add_argument("--overwrite", action="store_true", help="replace existing output files")


def run(arguments: argparse.Namespace) -> None:
    """Read the file, print and write the results."""
    pictures = [arguments.plot] if arguments.plot else []
    files.check_results([*pictures, *([arguments.problem] if arguments.problem else [])], pictures, arguments.overwrite)
    said = {name: getattr(arguments, name) for name in schema.CANTILEVER if getattr(arguments, name) is not None}
    cantilever = Section(said, "inspect", schema.INSTRUMENT).given(said)
    with on_terminal() as progress:
        found = inspect(arguments.data, columns=arguments.columns, **cantilever, like=arguments.like, progress=progress)
    print(listed(arguments.data, found.inspection.notes) + "\n")
    if "tests" in found.tables:
        print("\n".join([as_text(found.tables["tests"], left=1), *found.notes.values()]) + "\n")
    for fact in found.facts:
        print(f"stated in the file: {fact}")
    if found.refusal:
        raise found.refusal
    print(listed(f'would be fitted as kind = "{found.inspection.kind}":', found.curves))
    for words in found.doubts:
        print(f"warning: {words}")
    print(f"not in the file, guessed in the problem file: {', '.join(found.guessed)}")
    if not arguments.problem:
        print(f"\nA problem file to begin with (--problem writes it):\n\n{found.inspection.problem}", end="")
    if not found.inspection.tests:
        arguments.plot = None
    files.write(arguments, plot=found.figure, problem=lambda: found.inspection.problem)
