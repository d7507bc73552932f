# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact law`: the compiled law of a problem, in a file that codes in C and Fortran read."""

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
    """What the command takes."""
    parser.add_argument("problem", metavar="PROBLEM.toml", help="the problem file")
    parser.add_argument("law", type=Path, metavar="FILE.law", help="the file to write")
    parser.add_argument("--largest-depth", metavar="DEPTH", help='up to which depth, as in "300 nm"')
    parser.add_argument("--smallest-depth", metavar="DEPTH", help="from which depth on; 1e-4 of the largest")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="relative, of F, a and k; %(default)s")
    parser.add_argument("--continue-beyond", action="store_true", help="answer beyond the largest depth too, along the tangent")
    parser.add_argument(
        "--sliders", type=int, default=8, help="with [friction]: for the springs of a contact, 4 to 64; %(default)s"
    )
    parser.add_argument("--table", choices=tuple(FORMATS), metavar="FORM", help="write a table in place of the law: %(choices)s")
    parser.add_argument("--table-error", type=float, default=1e-3, help="of F by linear interpolation; %(default)s of the largest")
    parser.add_argument("--millimetres", action="store_true", help="the table in mm and N; without it in m and N")
    parser.add_argument("--touch", metavar="DISTANCE", help='of "lammps": the distance at first touch, as in "10 mm"')
    parser.add_argument(
        "--area", metavar="AREA", help='of "overclosure": of the surface that one contact stands for, as in "1 mm^2"'
    )
    parser.add_argument(
        "--shear-strength", metavar="STRESS", help='of the contact, constant, in place of [friction], as in "20 MPa"; homogeneous'
    )
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")


def run(arguments: argparse.Namespace) -> None:
    """Compiles, writes, and says what the law is."""
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
    """The table in place of the law."""
    length = 1e-3 if arguments.millimetres else 1.0
    touch, area = _given(arguments, "touch", LENGTH, length), _given(arguments, "area", AREA, length**2)
    text = compiled.table(arguments.table, error=arguments.table_error, length=length, touch=touch, area=area)
    print(f"{'table':<16}{text.splitlines()[0].strip('#* ')}")
    return text


def _given(arguments: argparse.Namespace, name: str, dimension: Dimension, unit: float = 1.0) -> float | None:
    """The quantity of an option in a unit, None where it is not given."""
    text = getattr(arguments, name)
    try:
        return None if text is None else parse(text, dimension) / unit
    except UnitError as problem:
        raise ProblemError(f"--{name.replace('_', '-')}: {problem}") from problem
