# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact law`: the compiled law of a problem, in a file that codes in C and Fortran read."""

from __future__ import annotations

import argparse
from pathlib import Path

from ..friction import Friction
from ..law import ContactLaw
from ..problem import ProblemError, load
from ..problem.units import FORCE, LENGTH, UnitError, parse, shown
from . import files

HELP = "compile the contact into a file that other codes read"
DESCRIPTION = """\
Compiles the contact of a problem file into a law, F(d) and all that belongs to it, and writes it to a file that a code in C,
Fortran or Python reads by its name. The code needs to know nothing else of the problem; docs/laws.md.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact law problem.toml film.law
    mdrcontact law problem.toml film.law --largest-depth "200 nm" --continue-beyond

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
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")


def run(arguments: argparse.Namespace) -> None:
    """Compiles, writes, and says what the law is."""
    files.check(arguments)
    problem = load(arguments.problem)
    contact = problem.contact()
    if arguments.largest_depth is None:
        largest = float(problem.control.states(contact, slice(-1, None)).one(0).depth)
    else:
        largest = _depth("--largest-depth", arguments.largest_depth)
    smallest = None if arguments.smallest_depth is None else _depth("--smallest-depth", arguments.smallest_depth)
    friction = Friction(contact, problem.friction.coefficient) if problem.friction else None
    law = ContactLaw(
        contact,
        largest,
        friction=friction,
        sliders=arguments.sliders,
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
        off = f"T off by {law.first_shear_error:.1%} of mu F in first shear"
        print(f"{'sliders':<16}{law.sliders}, {law.memory_size} numbers a contact; {off}")
    files.write({arguments.law: law.to_bytes()}, arguments.overwrite)


def _depth(option: str, text: str) -> float:
    try:
        return parse(text, LENGTH)
    except UnitError as problem:
        raise ProblemError(f"{option}: {problem}") from problem
