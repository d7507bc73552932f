# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact law`: compile the contact of a problem into a law, in a file that other codes read."""

from __future__ import annotations

import argparse
from pathlib import Path

from .._law_table import FORMATS
from .._progress import on_terminal
from .._units import AREA, LENGTH, MODULUS, Dimension, UnitError, parse
from ..law import ContactLaw
from ..problem import ProblemError, load
from ..studies import law
from . import files

HELP = "compile the contact into a file that other codes read"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("problem", metavar="PROBLEM.toml", help="problem file")
    parser.add_argument("law", type=Path, metavar="FILE.law", help="file of the law, or of the table")
    parser.add_argument("--largest-depth", metavar="DEPTH", help='largest depth of the law, as in "300 nm"')
    parser.add_argument("--smallest-depth", metavar="DEPTH", help="smallest depth of the law (default: 1e-4 of the largest)")
    parser.add_argument(
        "--tolerance", type=float, default=1e-9, metavar="T", help="relative tolerance of F, a and k (default: %(default)s)"
    )
    parser.add_argument("--continue-beyond", action="store_true", help="extrapolate beyond the largest depth along the tangent")
    parser.add_argument(
        "--sliders", type=int, default=8, metavar="N", help="number of sliders with [friction], 4 to 64 (default: %(default)s)"
    )
    parser.add_argument("--table", choices=tuple(FORMATS), metavar="FORM", help="write a table instead of the law: %(choices)s")
    parser.add_argument(
        "--table-error",
        type=float,
        default=1e-3,
        metavar="E",
        help="error of F by linear interpolation, divided by the largest F (default: %(default)s)",
    )
    parser.add_argument("--millimetres", action="store_true", help="write the table in mm and N instead of m and N")
    parser.add_argument(
        "--touch", metavar="DISTANCE", help='distance of the centres at initial contact, for "lammps", as in "10 mm"'
    )
    parser.add_argument("--area", metavar="AREA", help='area of the surface per contact, for "overclosure", as in "1 mm^2"')
    parser.add_argument(
        "--shear-strength",
        metavar="STRESS",
        help='constant shear strength instead of [friction], for homogeneous bodies, as in "20 MPa"',
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing output files")


def run(arguments: argparse.Namespace) -> None:
    """Compile the law, print its data and write it."""
    files.check(arguments)
    problem = load(arguments.problem)
    largest, smallest = (_given(arguments, name, LENGTH) for name in ("largest_depth", "smallest_depth"))
    with on_terminal() as progress:
        found = law(
            problem,
            largest_depth=largest,
            smallest_depth=smallest,
            tolerance=arguments.tolerance,
            continue_beyond=arguments.continue_beyond,
            sliders=arguments.sliders,
            shear_strength=_given(arguments, "shear_strength", MODULUS),
            progress=progress,
        )
    print(f"{found.title}\n")
    for name, words in found.notes.items():
        print(f"{name:<16}{words}")
    files.write(arguments, law=lambda: found.law.to_bytes() if arguments.table is None else _table(found.law, arguments))


def _table(compiled: ContactLaw, arguments: argparse.Namespace) -> str:
    """Return the table that replaces the law."""
    length = 1e-3 if arguments.millimetres else 1.0
    touch, area = _given(arguments, "touch", LENGTH, length), _given(arguments, "area", AREA, length**2)
    text = compiled.table(arguments.table, error=arguments.table_error, length=length, touch=touch, area=area)
    print(f"{'table':<16}{text.splitlines()[0].strip('#* ')}")
    return text


def _given(arguments: argparse.Namespace, name: str, dimension: Dimension, unit: float = 1.0) -> float | None:
    """Return the value of an option in a unit, None without it."""
    text = getattr(arguments, name)
    try:
        return None if text is None else parse(text, dimension) / unit
    except UnitError as problem:
        raise ProblemError(f"--{name.replace('_', '-')}: {problem}") from problem
