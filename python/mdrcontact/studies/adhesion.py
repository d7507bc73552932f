# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `adhesion`: the cycle of approach and retraction of an adhesive contact, and where it breaks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .._text import number
from .._units import ENERGY, FORCE, LENGTH, MODULUS, WORK_OF_ADHESION, practical, shown
from ..contact import Contact
from ..loop import Loop, PullOff
from ..panels import Figure, Label, Panel
from ..panels.contacts import of_loop
from ..problem import Problem
from ..problem.adhesion import Adhesion
from ..progress import Progress
from .result import Column, Number, Result, Table, Words, column, columns_of, study


@dataclass(frozen=True, eq=False, kw_only=True)
class AdhesionResult(Result):
    """A cycle of approach and retraction. Tables: "pull-off", "jumps", and "loop"."""

    problem: Problem
    loop: Loop
    pull_offs: tuple[tuple[str, PullOff], ...]
    """by the prescribed quantity, as "pull-off, force prescribed" """

    def figure(self) -> Figure:
        """Return force and contact radius along the cycle, with the pull-offs."""
        return Figure(self.title, tuple(_panels(self)))


def _panels(found: AdhesionResult) -> Iterator[Panel]:
    force, radius = of_loop(found.loop)
    if found.loop.control != "spring":
        depth, newton = (practical(*one) for one in ((LENGTH, found.loop.depth), (FORCE, found.loop.force)))
        labels = (Label(float(depth.of(at.depth)), float(newton.of(at.force)), text) for text, at in found.pull_offs)
        force = force._replace(parts=(*force.parts, *labels))
    yield from (force, radius)


@study
def adhesion(problem: Problem, *, progress: Progress | None = None) -> AdhesionResult:
    """Compute pull-off and a cycle of approach and retraction with its energy loss.

    Parameters
    ----------
    problem : Problem
        A problem with the table [adhesion]. The motion turns back in the last state of [compute].
    progress : Progress, optional
        Can stop the work.

    Returns
    -------
    AdhesionResult
        `loop`, `pull_offs`; numbers "pull-off force", "pull-off depth" and "energy lost".

    Raises
    ------
    ProblemError
        The table [adhesion] is missing.
    MDRError
        The problem cannot be solved.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> rubber = {"type": "homogeneous", "material": {"E": "1 MPa", "nu": 0.5}}
    >>> tables = {"indenter": ball, "medium": rubber, "compute": {"max_depth": "1 um"}}
    >>> found = studies.adhesion(problem.read({**tables, "adhesion": {"work_of_adhesion": "50 mJ/m^2"}}))
    >>> print(found.numbers["pull-off force"])
    -2.3562 uN
    """
    given: Adhesion = problem.part("adhesion")
    (progress or Progress()).step(0, None, "pull-off and cycle")
    contact = problem.contact()
    pull_offs = tuple((f"pull-off, {control} prescribed", contact.pull_off(control)) for control in ("force", "depth"))
    loop = _cycle(contact, problem, given)
    return AdhesionResult(
        title=problem.title,
        numbers={
            "pull-off force": Number(pull_offs[0][1].force, FORCE),
            "pull-off depth": Number(pull_offs[1][1].depth, LENGTH),
            "energy lost": Number(loop.dissipated_energy, ENERGY),
        },
        notes={
            "adhesion": f"work of adhesion: {shown(given.work_of_adhesion, WORK_OF_ADHESION)}, {_law(given)}",
            "energy": f"energy lost in the cycle: {shown(loop.dissipated_energy, ENERGY)}",
        },
        tables={"pull-off": _states(pull_offs), "jumps": _jumps(loop), "loop": _columns(loop)},
        problem=problem,
        loop=loop,
        pull_offs=pull_offs,
    )


def _law(given: Adhesion) -> str:
    """Describe the adhesion at the edge."""
    if not given.cohesive_stress:
        return f"adhesion rule: {given.adhesion_rule}"
    reach = given.work_of_adhesion / given.cohesive_stress
    return f"cohesive stress: {shown(given.cohesive_stress, MODULUS)}, up to a gap of {shown(reach, LENGTH)}"


def _cycle(contact: Contact, problem: Problem, given: Adhesion) -> Loop:
    """The cycle that turns back in the last state of [compute]."""
    last = problem.control.states(contact, slice(-1, None))
    depth, force = float(np.asarray(last.depth)[-1]), float(np.asarray(last.force)[-1])
    if given.spring_stiffness is not None:
        largest = depth + force / given.spring_stiffness
    else:
        largest = force if given.control == "force" else depth
    points = max(2, len(problem.control.values))
    return contact.loop(given.control, largest, points, spring_stiffness=given.spring_stiffness)


def _columns(loop: Loop) -> Table:
    return [
        Words("way", ["approach" if i <= loop.turning_point else "retraction" for i in range(len(loop.depth))]),
        column("position", loop.position, FORCE if loop.control == "force" else LENGTH),
        *columns_of(loop, "depth", "radius", "force"),
    ]


def _states(pull_offs: Sequence[tuple[str, PullOff]]) -> Table:
    rows = []
    for name, state in pull_offs:
        rows.append((name, state))
        rows += [(f"{name}: another stable segment ends", other) for other in state.others]
    states = [state for _, state in rows]
    return [
        Words("", [name for name, _ in rows]),
        column("depth", [state.depth for state in states], LENGTH),
        column("radius", [state.radius for state in states], LENGTH),
        column("force", [state.force for state in states], FORCE),
    ]


def _jumps(loop: Loop) -> Table:
    """Return a table of the jumps, with the states before and after."""
    position = practical(FORCE if loop.control == "force" else LENGTH, loop.position)
    ways = ["on approach" if i < loop.turning_point else "on retraction" for i in loop.jumps]
    table: list[Column | Words] = [
        Words(f"jumps, {loop.control} prescribed", ways),
        Column("at", loop.position[loop.jumps], position),
    ]
    for name, dimension in (("radius", LENGTH), ("force", FORCE)):
        values = getattr(loop, name)
        unit = practical(dimension, values)
        ends = unit.of(values[loop.jumps]), unit.of(values[loop.jumps + 1])
        words = [f"{number(before)} to {number(after)}" for before, after in zip(*ends, strict=True)]
        table.append(Words(f"{name} [{unit.name}]", words))
    return table
