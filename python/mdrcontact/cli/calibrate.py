# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact calibrate`: find tip and frame from indents into a known body, and write a file for [indenter]."""

from __future__ import annotations

import argparse
from pathlib import Path

from .._progress import on_terminal
from .._text import listed
from ..instruments.files.fit_file import load_fit_file
from ..studies import calibrate
from . import files, pages

HELP = "find area function, tip radius and frame compliance from indents into a known body"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("data", type=Path, nargs="+", metavar="DATA", help="measurements of one indent each, or folders of them")
    parser.add_argument(
        "--problem", type=Path, required=True, metavar="PROBLEM.toml", help="problem file: tip, known body, data and fit"
    )
    parser.add_argument("--output", type=Path, required=True, metavar="TIP.toml", help="write the calibrated tip to this file")
    parser.add_argument("--plot", type=Path, metavar="FILE.png", help="draw the fit (.png, .pdf or .svg)")
    parser.add_argument("--report", type=Path, metavar="FILE.html", help="write the complete result to one HTML file")
    parser.add_argument("--overwrite", action="store_true", help="replace existing output files")


def run(arguments: argparse.Namespace) -> None:
    """Read all curves, fit them together and write the tip."""
    files.check(arguments)
    problem = load_fit_file(arguments.problem)
    print(f"{problem.title}\n")
    paths = [p for given in arguments.data for p in (files.data_files(given) if given.is_dir() else [given])]
    tests = []
    for path in paths:
        for curve in problem.curves(path):
            data, notes = curve.read()
            print(listed(curve.name, notes))
            tests.append((curve.name, data))
    with on_terminal() as progress:
        found = calibrate(problem, tests, progress=progress)
    print("\n".join(["", found.notes["fit"], *(f"warning: {words}" for words in found.doubts)]))
    files.write(
        arguments,
        output=found.tip_file,
        plot=found.figure,
        report=lambda: pages.calibrate_page(found, [f"curves {', '.join(found.tests)}"], files.origin(arguments)),
    )
