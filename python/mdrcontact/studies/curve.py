# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `curve`: force, contact radius, stiffness and pressure of one problem."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._units import FORCE, LENGTH, MODULUS, STIFFNESS, Dimension, practical, shown
from .._warn import silence
from ..contact import Contact
from ..errors import InvalidArgumentError, MDRError
from ..material import Elastic
from ..medium import Coated, Homogeneous, Medium, Pair
from ..panels import Axis, Figure, Label, Line, Panel, Part, Rule, along, marked
from ..panels.contacts import OVER_DEPTH, Pressure, of_pressures, over_depth, pressure_of
from ..problem import Problem
from ..progress import Progress
from ..state import State
from .result import Array, Number, Result, Table, column, spread_over, study
from .states import Curve, columns, solve, thickness

_COMPARABLE = 10.0
"""A reference curve that ends further away than this factor would compress the others."""
_NARROW = 3.0
"""A range of a/h below this factor is not worth a panel."""


@dataclass(frozen=True, eq=False, kw_only=True)
class CurveResult(Result):
    """The states of a problem. Table: "states", and "pressures" where there are any."""

    problem: Problem
    states: Curve
    pressures: tuple[Pressure, ...] = ()
    """at a quarter, half and the end of the curve"""
    refusal: InvalidArgumentError | None = None
    """why there are no pressures"""
    at_thickness: State | None = None
    """the state whose contact is as wide as the coating is thick"""
    references: tuple[tuple[str, Array], ...] = ()
    """"coating" and "substrate", and the forces [N] on bodies of them alone, at the same depths"""

    def figure(self) -> Figure:
        """Return force, contact radius and stiffness over depth, the effective modulus over a/h, and pressures."""
        return Figure(self.title, (*_over_depth(self), *_over_radius(self), *_over_r(self)))


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
        Reports the states, and can stop the work.

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
    at = _at_thickness(contact, problem.medium)
    notes = {"thickness": _thickness_note(problem, found, at), "rigid": _rigid_note(problem, found)}
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
        at_thickness=at,
        references=tuple(homogeneous_forces(problem, found.depth)) if references else (),
    )


def _over_depth(found: CurveResult) -> Iterator[Panel]:
    curve, at = found.states, found.at_thickness
    depth = practical(LENGTH, curve.depth)
    if at is not None and not curve.radius[0] < float(at.radius) < curve.radius[-1]:
        at = None
    for (_, quantity, dimension), panel in zip(OVER_DEPTH, over_depth(curve, _model_name(found.problem)), strict=True):
        unit = practical(dimension, getattr(curve, quantity))
        parts: list[Part] = [*panel.parts]
        if dimension is FORCE:
            parts += [
                Line(depth.of(curve.depth), unit.of(forces), f"{body} alone", "grey", 1 + i, marked(forces, "^s"[i]), 1.0)
                for i, (body, forces) in enumerate(found.references)
                if 1.0 / _COMPARABLE < abs(forces[-1] / curve.force[-1]) < _COMPARABLE
            ]
        if at is not None:
            parts.append(Label(float(depth.of(at.depth)), float(unit.of(getattr(at, quantity))), "a = h", 1))
        is_below = any(np.min(part.y) < 0.0 for part in parts if isinstance(part, Line))
        yield panel._replace(parts=tuple(parts), y=panel.y._replace(low=None) if is_below else panel.y)


def _over_radius(found: CurveResult) -> Iterator[Panel]:
    """The effective modulus, where the contact grows through a part of the thickness that matters."""
    h = thickness(found.problem.medium)
    if not h or found.states.radius[-1] < _NARROW * found.states.radius[0]:
        return
    ratio = found.states.radius / h
    y, unit = along("effective modulus E_eff", MODULUS, found.states.modulus)
    line = Line(ratio, unit.of(found.states.modulus), marker=marked(ratio))
    rule = [Rule(1.0, vertical=True, name="a = h")] if ratio[0] < 1.0 < ratio[-1] else []
    yield Panel(Axis("a/h", log=True), y, (line, *rule))


def _over_r(found: CurveResult) -> Iterator[Panel]:
    if not found.pressures:
        return
    yield of_pressures(found.pressures, found.states.radius)


def _model_name(problem: Problem) -> str:
    model = getattr(problem.medium, "model", None)
    kind = type(problem.medium).__name__.lower()
    return f"{kind}, model {model}" if model else kind


def _ends(found: Curve) -> Iterator[tuple[str, Array, Dimension]]:
    yield "depth", found.depth, LENGTH
    yield "radius", found.radius, LENGTH
    yield "force", found.force, FORCE
    yield "stiffness", found.stiffness, STIFFNESS
    if found.has_slope:
        yield "slope", found.slope, STIFFNESS
    yield "effective modulus", found.modulus, MODULUS
    yield "mean pressure", found.mean_pressure, MODULUS


def _at_thickness(contact: Contact, medium: Medium) -> State | None:
    """Return the state at a = h, None if it does not exist. It may lie beyond the curve, so its warnings are left out."""
    h = thickness(medium)
    with suppress(MDRError), silence():
        return None if h is None else contact.at_radius(h)
    return None


def _thickness_note(problem: Problem, found: Curve, at: State | None) -> str | None:
    """Return a sentence on the state at a = h."""
    h = thickness(problem.medium)
    if h is None:
        return None
    there = "" if at is None else f", at depth {shown(float(at.depth), LENGTH)}"
    if at is not None and found.radius.min() <= h <= found.radius.max():
        return f"The contact radius equals the coating thickness, a = h = {shown(h, LENGTH)}{there}."
    side = "below" if found.radius.max() < h else "above"
    where = f"; it equals h{there}" if there else ""
    return f"In this curve the contact radius stays {side} the coating thickness, h = {shown(h, LENGTH)}{where}."


def _rigid_note(problem: Problem, found: Curve) -> str | None:
    """Return a sentence on the error of a rigid indenter."""
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
    """Return the distributions, or why there are none; points of infinite pressure are omitted."""
    result = []
    count = len(found.depth)
    quarters = spread_over(count, 4)
    try:
        for i in (quarters[0], quarters[1], quarters[3]) if count > 3 else range(count):
            result.append(pressure_of(contact.at_depth(float(found.depth[i])), float(found.radius[i])))
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
