# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact adhesion`: the cycle of approach and retraction of an adhesive contact, and where it breaks."""

from __future__ import annotations

import argparse

import numpy as np

from .._progress import waiting
from .._text import aligned
from .._units import ENERGY, FORCE, LENGTH, MODULUS, WORK_OF_ADHESION, practical, shown
from ..adhesion import Loop, PullOff
from ..contact import Contact
from ..problem import Problem, load_with
from ..problem.adhesion import Adhesion
from . import figures, files
from .table import Column, as_csv, column, columns_of, number

HELP = "pull-off, and a loop of approach and retraction"
DESCRIPTION = """\
Computes an adhesive contact: jump-in, pull-off under prescribed force and under prescribed depth, all other ends of
stability of the branch, and a cycle of approach and retraction with the energy it loses.

    mdrcontact example afm_on_pdms > problem.toml
    mdrcontact adhesion problem.toml
    mdrcontact adhesion problem.toml --csv loop.csv --plot loop.png

The problem file has one table more than for the other commands:

    [adhesion]
    work_of_adhesion = "50 mJ/m^2"
    cohesive_stress = "2 MPa"           # adhesion with a range; without it: of no range (JKR)
    control = "spring"                  # or "depth" (default), "force": what the machine prescribes
    spring_stiffness = "0.2 N/m"        # with control = "spring": an AFM cantilever
    adhesion_rule = "automatic"         # or "paper", "energy": the edge opening, see docs/adhesion.md

The motion turns back at the last depth, force or radius of [compute].
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "the loop", "it has a table [adhesion]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem, adhesion = load_with(arguments.problem, "adhesion")
    with waiting("pull-off and cycle"):
        contact = problem.contact()
        pull_offs = [(f"pull-off, {control} prescribed", contact.pull_off(control)) for control in ("force", "depth")]
        loop = cycle(contact, problem, adhesion)
    print(f"{problem.title}\n")
    gamma = shown(adhesion.work_of_adhesion, WORK_OF_ADHESION)
    print(f"work of adhesion: {gamma}, {_law(adhesion)}\n")
    print(_states(pull_offs))
    print(f"\n{_jumps(loop)}")
    print(f"\nenergy lost in the cycle: {shown(loop.dissipated_energy, ENERGY)}")
    ways = ["approach" if i <= loop.turning_point else "retraction" for i in range(len(loop.depth))]
    files.write(
        arguments,
        csv=lambda: as_csv(loop_columns(loop), ("way", ways)),
        plot=lambda: figures.loop_figure(problem, loop, pull_offs),
    )


def _law(adhesion: Adhesion) -> str:
    """What holds the surfaces together at the edge."""
    if not adhesion.cohesive_stress:
        return f"adhesion rule: {adhesion.adhesion_rule}"
    reach = adhesion.work_of_adhesion / adhesion.cohesive_stress
    return f"cohesive stress: {shown(adhesion.cohesive_stress, MODULUS)}, up to a gap of {shown(reach, LENGTH)}"


def cycle(contact: Contact, problem: Problem, adhesion: Adhesion) -> Loop:
    """The cycle that turns back in the last state of [compute]."""
    last = problem.control.states(contact, slice(-1, None))
    depth, force = float(np.asarray(last.depth)[-1]), float(np.asarray(last.force)[-1])
    if adhesion.spring_stiffness is not None:
        largest = depth + force / adhesion.spring_stiffness
    else:
        largest = force if adhesion.control == "force" else depth
    points = max(2, len(problem.control.values))
    return contact.loop(adhesion.control, largest, points, spring_stiffness=adhesion.spring_stiffness)


def loop_columns(loop: Loop) -> list[Column]:
    """What the CSV file holds of a loop."""
    return [
        column("position", loop.position, FORCE if loop.control == "force" else LENGTH),
        *columns_of(loop, "depth", "radius", "force"),
    ]


def _states(pull_offs: list[tuple[str, PullOff]]) -> str:
    rows = []
    for name, state in pull_offs:
        rows.append((name, state))
        rows += [(f"{name}: another stable segment ends", other) for other in state.others]
    table = [
        column("depth", np.array([state.depth for _, state in rows]), LENGTH),
        column("radius", np.array([state.radius for _, state in rows]), LENGTH),
        column("force", np.array([state.force for _, state in rows]), FORCE),
    ]
    body = [[name, *(number(float(c.unit.of(c.values[i]))) for c in table)] for i, (name, _) in enumerate(rows)]
    return aligned([["", *(c.title for c in table)], *body], left=1)


def _jumps(loop: Loop) -> str:
    position = practical(FORCE if loop.control == "force" else LENGTH, loop.position)
    radius, force = practical(LENGTH, loop.radius), practical(FORCE, loop.force)
    rows = [[f"jumps, {loop.control} prescribed", f"at [{position.name}]", f"radius [{radius.name}]", f"force [{force.name}]"]]
    for i in loop.jumps:
        way = "on approach" if i < loop.turning_point else "on retraction"
        radii, forces = radius.of(loop.radius[i : i + 2]), force.of(loop.force[i : i + 2])
        rows.append(
            [
                way,
                number(float(position.of(loop.position[i]))),
                f"{number(float(radii[0]))} to {number(float(radii[1]))}",
                f"{number(float(forces[0]))} to {number(float(forces[1]))}",
            ]
        )
    return aligned(rows, left=1)
