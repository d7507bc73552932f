# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `conduction`: heat or current through a contact along its loading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .._units import CONDUCTANCE, FORCE, LENGTH, RATIO, TEMPERATURE, THERMAL_CONDUCTANCE, Dimension
from ..conduction import Conduction, ContactConductance
from ..contact import States
from ..panels import Axis, Cells, Figure, Line, Panel, Rule, along
from ..problem import Problem
from ..problem.conduction import THERMAL, Conducting
from ..progress import Progress
from .result import Array, Number, Result, column, columns_of, study

_WIDE, _SHALLOWEST, _DEEPEST, _LAYERS = 2.5, 0.5, 2.5, 5.0
"""Contact radii to the sides of the section; into the body so many thicknesses of its layers, between two contact radii."""
_POINTS = 61


class SectionField(NamedTuple):
    """A field in a section through the lower body."""

    x: Array
    z: Array
    values: Array
    """(z, x): temperature rise [K] with heat of friction, else the share of the potential"""
    is_heated: bool


@dataclass(frozen=True, eq=False, kw_only=True)
class ConductionResult(Result):
    """Conductances along a loading. Table: "states"."""

    problem: Problem
    conduction: Conduction
    states: States
    conductance: ContactConductance
    dimension: Dimension
    """of the conductance"""
    rough: Array | None = None
    """conductance between the rough surfaces of a joint; `conductance` is then that of smooth ones"""
    section: SectionField | None = None
    """of the last state"""

    def figure(self) -> Figure:
        """Return the conductance over the force, and the section through the lower body."""
        x, force = along("force F", FORCE, self.states.force)
        values = np.asarray(self.conductance.conductance)
        y, unit = along("conductance G", self.dimension, values)
        along_force = force.of(np.asarray(self.states.force))
        lines = [Line(along_force, unit.of(values), "" if self.rough is None else "smooth surfaces")]
        lines += [] if self.rough is None else [Line(along_force, unit.of(self.rough), "rough surfaces", 1)]
        panels = [Panel(x, y, tuple(lines))]
        return Figure(self.title, tuple(panels + ([_section_panel(self, self.section)] if self.section else [])))


def _section_panel(found: ConductionResult, section: SectionField) -> Panel:
    """The field in the lower body at the last state; the contact as a bar, the interfaces as lines."""
    a, depth = float(found.states[-1].radius), 0.0
    x, length = along("x", LENGTH, section.x)
    name = Axis("temperature rise", "K") if section.is_heated else Axis("potential over that of the contact")
    parts: list[Cells | Rule | Line] = [Cells(length.of(section.x), length.of(section.z), section.values, name)]
    for _, h in found.problem.medium._stack():
        depth += h
        if depth < section.z[-1]:
            parts.append(Rule(float(length.of(depth)), colour="white", dash=0))
    parts.append(Line(length.of(np.array([-a, a])), np.zeros(2), "", 5, width=5.0))
    title = "section: contact (blue), interfaces (white)" if depth else "section: contact (blue)"
    return Panel(x, Axis("depth z", length.symbol, low=0.0), tuple(parts), title, equal=True, downward=True)


@study
def conduction(problem: Problem, *, section: bool = False, progress: Progress | None = None) -> ConductionResult:
    """Compute conductance along a loading, and temperatures by the heat of friction.

    Parameters
    ----------
    problem : Problem
        A problem with the table [conduction].
    section : bool, optional
        Compute the potential, or the temperature, in a section through the lower body at the last state as well. Under a joint
        it is not available.
    progress : Progress, optional
        Can stop the work.

    Returns
    -------
    ConductionResult
        `states`, `conductance`; numbers "conductance", and "conductance without film" or "conductance of smooth surfaces", of the
        last state.

    Raises
    ------
    ProblemError
        The table [conduction] is missing.
    MDRError
        The problem cannot be solved.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> silica = {"E": "72 GPa", "nu": 0.17, "thermal_conductivity": "1.4 W/(m*K)"}
    >>> tables = {"indenter": ball, "medium": {"type": "homogeneous", "material": silica}, "compute": {"max_force": "1 mN"}}
    >>> found = studies.conduction(problem.read({**tables, "conduction": {"kind": "thermal"}}))
    >>> print(found.numbers["conductance"])
    2.6093 uW/K
    """
    given: Conducting = problem.part("conduction")
    (progress or Progress()).step(0, None, "conduction")
    contact, conductors = problem.contact(), given.conduction(problem.medium)
    states = problem.control.states(contact)
    found = conductors.along(states)
    dimension = THERMAL_CONDUCTANCE if given.kind == THERMAL else CONDUCTANCE
    rough = _rough(conductors, given, states)
    table = [*columns_of(states, "depth", "radius", "force")]
    if rough is not None:
        table += [column("conductance", rough, dimension), column("smooth surfaces", found.conductance, dimension)]
    else:
        table += [
            column("conductance", found.conductance, dimension),
            column("dlnG/dlnF", np.asarray(found.by_force) * np.asarray(states.force) / np.asarray(found.conductance), RATIO),
        ]
    if given.heat is not None:
        heat = conductors.friction_heat(states, *given.heat)
        table += [
            column("centre", heat.centre, TEMPERATURE),
            column("mean", heat.flux_mean, TEMPERATURE),
            column("share", heat.share, RATIO),
        ]
    numbers = _numbers(conductors, float(np.asarray(states.radius)[-1]), dimension, rough)
    words = f"conductance at a = {numbers['contact radius']}: {numbers['conductance']}"
    if "conductance without film" in numbers:
        words += f"; without the film in the spot {numbers['conductance without film']}"
    if "conductance of smooth surfaces" in numbers:
        words += f"; between smooth surfaces {numbers['conductance of smooth surfaces']}"
    return ConductionResult(
        title=problem.title,
        numbers=numbers,
        notes={"conductance": words},
        tables={"states": table},
        problem=problem,
        conduction=conductors,
        states=states,
        conductance=found,
        dimension=dimension,
        rough=rough,
        section=_section(problem, given, conductors, states) if section and rough is None else None,
    )


def _rough(conductors: Conduction, given: Conducting, states: States) -> Array | None:
    """Return the conductance of each state between rough surfaces; None without a joint."""
    if given.joint is None:
        return None
    return np.array([conductors.rough(states[i], given.joint) for i in range(len(states))])


def _numbers(conductors: Conduction, radius: float, dimension: Dimension, rough: Array | None) -> dict[str, Number]:
    """Return the last conductance, and that without the film in the contact area or of smooth surfaces."""
    value = float(np.asarray(conductors.at_radius(radius).conductance))
    numbers = {"contact radius": Number(radius, LENGTH), "conductance": Number(value if rough is None else rough[-1], dimension)}
    if rough is not None:
        numbers["conductance of smooth surfaces"] = Number(value, dimension)
    if conductors.film:
        bare = float(np.asarray(conductors.replace(film=0.0).at_radius(radius).conductance))
        numbers["conductance without film"] = Number(bare, dimension)
    return numbers


def _section(problem: Problem, given: Conducting, conductors: Conduction, states: States) -> SectionField:
    """Return the field in the lower body at the last state."""
    last = states[-1]
    a = float(last.radius)
    thicknesses = [thickness for _, thickness in problem.medium._stack()]
    deep = float(np.clip(_LAYERS * sum(thicknesses) or np.inf, _SHALLOWEST * a, _DEEPEST * a))
    x, z = np.linspace(-_WIDE, _WIDE, 2 * _POINTS - 1) * a, np.linspace(0.0, deep, _POINTS)
    half = np.abs(x[_POINTS - 1 :])
    if given.heat is None:
        field = conductors.at_radius(a).potential(half[None, :], z[:, None])
    else:
        field = conductors.friction_heat(last, *given.heat).temperature(half[None, :], z[:, None])
    values = np.concatenate([np.asarray(field)[:, :0:-1], np.asarray(field)], axis=1)
    return SectionField(x, z, values, given.heat is not None)
