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
from ..panels import Figure, Label, Line, Panel, Rule, along
from ..problem import Problem
from ..problem.adhesion import Adhesion
from ..progress import Progress
from .result import Array, Column, Number, Result, Table, Words, column, columns_of, study


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
    loop, is_spring = found.loop, found.loop.control == "spring"
    position = loop.position if is_spring else loop.depth
    x, length = along("position of the spring's end d + F/K" if is_spring else "indentation depth d", LENGTH, position)
    for name, values, dimension in (("force F", loop.force, FORCE), ("contact radius a", loop.radius, LENGTH)):
        y, unit = along(name, dimension, values, low=0.0 if dimension is LENGTH else None)
        parts: list[Line | Label | Rule] = list(_branches(loop, length.of(position), unit.of(values)))
        if dimension is FORCE:
            parts.append(Rule(0.0, dash=0))
            if not is_spring:
                parts += [Label(float(length.of(at.depth)), float(unit.of(at.force)), text) for text, at in found.pull_offs]
        yield Panel(x, y, tuple(parts))


def _branches(loop: Loop, x: Array, y: Array) -> Iterator[Line]:
    """Approach and retraction in pieces between the jumps, which are dotted."""
    for name, colour, part, width in (
        ("approach", 1, slice(0, loop.turning_point + 1), 3.2),
        ("retraction", 0, slice(loop.turning_point, len(x)), 1.6),
    ):
        starts = [part.start, *(int(j) + 1 for j in loop.jumps if part.start <= j < part.stop - 1)]
        for start, stop in zip(starts, [*starts[1:], part.stop], strict=True):
            yield Line(x[start:stop], y[start:stop], name if start == part.start else "", colour, 0, "", width)
        for start in starts[1:]:
            yield Line(x[start - 1 : start + 1], y[start - 1 : start + 1], "", colour, 2, "", 1.0)


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
