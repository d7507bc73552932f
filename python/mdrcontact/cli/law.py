# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact law`: the compiled law of a problem, in a file that codes in C and Fortran read."""

from __future__ import annotations

import argparse
from pathlib import Path

from .._law_table import FORMATS
from .._progress import waiting
from .._units import AREA, FORCE, LENGTH, MODULUS, Dimension, UnitError, parse, shown
from ..friction import Friction
from ..law import ContactLaw
from ..problem import ProblemError, load
from . import files

HELP = "compile the contact into a file that other codes read"
DESCRIPTION = """\
Compiles the contact of a problem file into a law, F(d) and all that belongs to it, and writes it to a file that a code in C,
Fortran or Python reads by its name. The code needs to know nothing else of the problem; docs/laws.md.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact law problem.toml film.law
    mdrcontact law problem.toml film.law --largest-depth "200 nm" --continue-beyond
    mdrcontact law problem.toml film.inp --table spring --millimetres

With --table it writes a table for a program that interpolates linearly: csv, lammps (pair_style table), spring (a nonlinear spring
of Abaqus and CalculiX) or overclosure (their pressure-overclosure), without adhesion but for csv, and states its error.

With [friction] the law has tangential forces, too, and the code leads each contact along its path.
Numbers in the file are in SI units: depths in m, forces in N. Without --largest-depth the law goes to the last depth, force or
radius of [compute].
"""


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
    with waiting("contact"):
        contact = problem.contact()
    if arguments.largest_depth is None:
        largest = float(problem.control.states(contact, slice(-1, None))[0].depth)
    else:
        largest = _number("--largest-depth", arguments.largest_depth, LENGTH)
    given = arguments.smallest_depth
    smallest = None if given is None else _number("--smallest-depth", given, LENGTH)
    given = arguments.shear_strength
    strength = None if given is None else _number("--shear-strength", given, MODULUS)
    friction = Friction(contact, problem.friction.coefficient) if problem.friction else None
    with waiting("law"):
        law = ContactLaw(
            contact,
            largest,
            friction=friction,
            sliders=arguments.sliders,
            shear_strength=strength,
            smallest_depth=smallest,
            tolerance=arguments.tolerance,
            description=f"{problem.title}; {friction or contact!r}; SI units",
            continue_beyond=arguments.continue_beyond,
        )
    print(f"{problem.title}\n")
    for name, ends, dimension in (("depth", law.depth_range, LENGTH), ("force", law.force_range, FORCE)):
        print(f"{name:<16}{shown(ends[0], dimension)} to {shown(ends[1], dimension)}")
    print(f"{'error':<16}{law.error:.0e} relative, tolerance {law.tolerance:.0e}; {law.solutions} contact states")
    if law.sliders:
        off = f"T off by {law.first_shear_error:.1%} of sliding in first shear"
        print(f"{'sliders':<16}{law.sliders}, {law.memory_size} numbers a contact; {off}")
    files.write(arguments, law=lambda: law.to_bytes() if arguments.table is None else _table(law, arguments))


def _table(law: ContactLaw, arguments: argparse.Namespace) -> str:
    """The table in place of the law."""
    length = 1e-3 if arguments.millimetres else 1.0
    touch = None if arguments.touch is None else _number("--touch", arguments.touch, LENGTH) / length
    area = None if arguments.area is None else _number("--area", arguments.area, AREA) / length**2
    text = law.table(arguments.table, error=arguments.table_error, length=length, touch=touch, area=area)
    print(f"{'table':<16}{text.splitlines()[0].strip('#* ')}")
    return text


def _number(option: str, text: str, dimension: Dimension) -> float:
    try:
        return parse(text, dimension)
    except UnitError as problem:
        raise ProblemError(f"{option}: {problem}") from problem
