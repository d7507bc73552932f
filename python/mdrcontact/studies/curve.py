# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `curve`: force, contact radius, stiffness and pressure of one problem."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from .._units import FORCE, LENGTH, MODULUS, STIFFNESS, Dimension, shown
from ..contact import Contact
from ..errors import InvalidArgumentError, MDRError
from ..material import Elastic
from ..medium import Coated, Homogeneous, Pair
from ..problem import Problem
from ..progress import Progress
from .result import Array, Number, Result, Table, column, spread_over, study
from .states import Curve, columns, crossing, solve, thickness

_PRESSURE_POINTS = 400


class Pressure(NamedTuple):
    """The pressure of one state, where it is finite; SI units."""

    depth: float
    r: Array
    pressure: Array


@dataclass(frozen=True, eq=False, kw_only=True)
class CurveResult(Result):
    """The states of a problem. Table: "states", and "pressures" where there are any."""

    problem: Problem
    states: Curve
    pressures: tuple[Pressure, ...] = ()
    """at a quarter, half and the end of the curve"""
    refusal: InvalidArgumentError | None = None
    """why there are no pressures"""
    references: tuple[tuple[str, Array], ...] = ()
    """"coating" and "substrate", and the forces [N] on bodies of them alone, at the same depths"""


@study
def curve(problem: Problem, *, pressures: bool = False, references: bool = False, progress: Progress | None = None) -> CurveResult:
    """Compute the force-depth curve of a problem.

    The table has depth, contact radius, force, stiffness, effective modulus and mean pressure.

    The stiffness is dF/dd at constant contact radius. With adhesion the table also has the slope, dF/dd along the branch.

    Parameters
    ----------
    problem : Problem
        Indenter, medium and prescribed values, as `mdrcontact.problem.read` returns them.
    pressures : bool, optional
        Compute the pressure at a quarter, half and the end of the curve as well.
    references : bool, optional
        Compute the forces on the coating alone and on the substrate alone as well.
    progress : Progress, optional
        Follows the states, and stops them.

    Returns
    -------
    CurveResult
        `states`, table "states"; notes "thickness" and "rigid" on the contact radius and on a rigid indenter.

    Raises
    ------
    MDRError
        The problem cannot be solved.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "sphere", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.17}}
    >>> tables = {"indenter": ball, "medium": glass, "compute": {"depths": ["50 nm", "100 nm"]}}
    >>> found = studies.curve(problem.read(tables))
    >>> print(found.numbers["force"])
    9.8758 mN
    """
    progress = progress or Progress()
    progress.step(0, None, "contact")
    contact = problem.contact()
    total = len(problem.control.values)
    progress.step(0, total, "states")
    found = solve(contact, problem.control, lambda done: progress.step(done, total, "states"))
    notes = {"thickness": _thickness_note(problem, found), "rigid": _rigid_note(problem, found)}
    distributions, refusal = _pressures(contact, found) if pressures else ((), None)
    tables: dict[str, Table] = {"states": columns(found, problem.medium)}
    if distributions:
        tables["pressures"] = _stacked(distributions)
    return CurveResult(
        title=problem.title,
        numbers={name: Number(float(values[-1]), dimension) for name, values, dimension in _ends(found)},
        notes={about: note for about, note in notes.items() if note},
        tables=tables,
        problem=problem,
        states=found,
        pressures=distributions,
        refusal=refusal,
        references=tuple(homogeneous_forces(problem, found.depth)) if references else (),
    )


def _ends(found: Curve) -> Iterator[tuple[str, Array, Dimension]]:
    yield "depth", found.depth, LENGTH
    yield "radius", found.radius, LENGTH
    yield "force", found.force, FORCE
    yield "stiffness", found.stiffness, STIFFNESS
    if found.has_slope:
        yield "slope", found.slope, STIFFNESS
    yield "effective modulus", found.modulus, MODULUS
    yield "mean pressure", found.mean_pressure, MODULUS


def _thickness_note(problem: Problem, found: Curve) -> str | None:
    """One sentence on where the contact becomes as wide as the coating is thick."""
    h = thickness(problem.medium)
    if h is None:
        return None
    thick = shown(h, LENGTH)
    depth = crossing(found, h)
    if depth is None:
        side = "stays below" if found.radius[-1] <= h else "is always above"
        return f"The contact radius {side} the coating thickness, h = {thick}."
    return f"The contact radius equals the coating thickness, a = h = {thick}, at depth {shown(depth, LENGTH)}."


def _rigid_note(problem: Problem, found: Curve) -> str | None:
    """One sentence on what it would have cost to take a deformable indenter as rigid."""
    if not isinstance(problem.medium, Pair):
        return None
    lower: Any = problem.medium.lower
    rigid = problem._replace(medium=lower).contact()
    ends = zip(found.depth[[0, -1]], found.force[[0, -1]], strict=True)
    try:
        excess = [100.0 * (float(rigid.at_depth(d).force) / float(f) - 1.0) for d, f in ends]
    except MDRError:
        return None
    return f"With a rigid indenter the force would be {excess[0]:+.1f} % off at the first depth, {excess[1]:+.1f} % at the last."


def _pressures(contact: Contact, found: Curve) -> tuple[tuple[Pressure, ...], InvalidArgumentError | None]:
    """The distributions, or why there are none; points where theory gives infinite pressure are left out."""
    result = []
    count = len(found.depth)
    quarters = spread_over(count, 4)
    try:
        for i in (quarters[0], quarters[1], quarters[3]) if count > 3 else range(count):
            # dense towards the edge, where pressures are steep, and a hair inside it: the edge itself is a matter of rounding
            r = found.radius[i] * (1.0 - 1e-9) * np.sin(np.linspace(0.0, np.pi / 2, _PRESSURE_POINTS))
            p = np.asarray(contact.at_depth(float(found.depth[i])).pressure(r))
            finite = np.isfinite(p)
            result.append(Pressure(float(found.depth[i]), r[finite], p[finite]))
    except InvalidArgumentError as refusal:
        return (), refusal
    return tuple(result), None


def _stacked(pressures: tuple[Pressure, ...]) -> Table:
    depth = np.concatenate([np.full(len(one.r), one.depth) for one in pressures])
    return [
        column("depth", depth, LENGTH),
        column("r", np.concatenate([one.r for one in pressures]), LENGTH),
        column("pressure", np.concatenate([one.pressure for one in pressures]), MODULUS),
    ]


def homogeneous_forces(problem: Problem, depth: Array) -> Iterator[tuple[str, Array]]:
    """Forces [N] at depths [m], with the problem's adhesion, on the homogeneous bodies between which a coated one lies."""
    body = problem.medium
    if not isinstance(body, Coated):
        return
    for name, material in (("coating", body.coating), ("substrate", body.substrate)):
        if isinstance(material, Elastic):
            with suppress(MDRError):  # depths beyond the pull-off of the homogeneous body
                yield name, np.asarray(problem._replace(medium=Homogeneous(material)).contact().at_depth(depth).force)
