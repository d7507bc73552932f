# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit`: find film properties from measured curves."""

from __future__ import annotations

import argparse
from pathlib import Path

from .._progress import on_terminal
from .._text import listed
from ..instruments.files.curves import Curve
from ..instruments.files.fit_file import FitFile, load_fit_file
from ..problem import ProblemError
from ..studies import fit
from . import files, many, pages
from .table import as_csv, as_text, with_errors
from .workbook import as_xlsx

HELP = "find film properties with intervals from measured curves"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    data, tables = "table of measurements, AFM file, or folder of these", "indenter, medium, data and fit"
    files.add_fit(parser, "points and residuals, or for a folder the estimates,", data, tables)
    words = "draw the modulus of one curve against range, branch and contact point"
    parser.add_argument("--ranges", type=Path, metavar="FILE.png", help=words)
    parser.add_argument("--keep-all", action="store_true", help="include curves with warnings in the mean of a folder or map")
    parser.add_argument("--compare", action="store_true", help="also fit with every model of the medium, and rank them")
    words = "take forces on a film as those of the pyramid instead of its equivalent cone, as the key of [fit] does"
    parser.add_argument("--pyramid-correction", action="store_true", help=words)
    parser.add_argument(
        "--interval",
        choices=("normal", "profile", "monte-carlo"),
        default="normal",
        help="method for the intervals (default: normal, from the standard error)",
    )


def run(arguments: argparse.Namespace) -> None:
    """Fit, print and write the results."""
    files.check(arguments)
    problem = load_fit_file(arguments.problem)
    if arguments.pyramid_correction:
        if problem.drainage is not None:
            raise ProblemError("--pyramid-correction: fits of gels do not support it. Omit it.")
        problem = problem._replace(options={**problem.options, "pyramid_correction": True})
    print(f"{problem.title}\n")
    is_folder = arguments.data.is_dir()
    with on_terminal() as progress:
        curves = problem.all_curves(files.data_files(arguments.data), progress) if is_folder else problem.curves(arguments.data)
    if is_folder or len(curves) > 1:
        many.run(arguments, problem, curves)
    else:
        _one(arguments, problem, curves[0])


def _one(arguments: argparse.Namespace, problem: FitFile, curve: Curve) -> None:
    data, notes = curve.read()
    print(listed(arguments.data, notes))
    print(f"  indenter: {problem.indenter!r}\n  medium: {problem.medium!r}\n")
    of_gel = problem.drainage is not None
    if of_gel and arguments.ranges:
        raise ProblemError("--ranges: fits of gels do not support it. Use --report for the fit with its residuals.")
    moves = not of_gel and bool(arguments.ranges or arguments.report)
    options = {"moves": moves, "interval": arguments.interval, "compare": arguments.compare}
    with on_terminal() as progress:
        found = fit(problem, data, **options, progress=progress)
    if found.analysis is not None:
        print(f"{pages.ANALYSIS}:\n{as_text(with_errors(found.tables['points']), left=0)}\n")
    if "ranges" in found.tables:
        print(f"{as_text(with_errors(found.tables['ranges']), left=0)}\n")
    for about, words in found.notes.items():
        print(f"\n{words}" if about == "models" else words)
    if found.refusal:
        raise found.refusal
    files.write(
        arguments,
        csv=lambda: as_csv(found.tables["points"]),
        xlsx=lambda: as_xlsx(found, arguments.command),
        json=lambda: found.to_dict() if of_gel else {**found.to_dict(), "file": str(arguments.data)},
        plot=found.figure,
        ranges=lambda: found.moves and found.moves.plot(found.title),
        report=lambda: pages.fit_page(found, notes, files.origin(arguments)),
    )
