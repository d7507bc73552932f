# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `conduction`: heat or current through a contact along its loading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .._units import CONDUCTANCE, LENGTH, RATIO, TEMPERATURE, THERMAL_CONDUCTANCE, Dimension
from ..conduction import Conduction, ContactConductance
from ..contact import States
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
    """(z, x): temperature rise [K] where friction heats, else the part of the potential"""
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
    section: SectionField | None = None
    """of the last state"""


@study
def conduction(problem: Problem, *, section: bool = False, progress: Progress | None = None) -> ConductionResult:
    """Compute conductance along a loading, and temperatures by the heat of friction.

    Parameters
    ----------
    problem : Problem
        A problem with the table [conduction].
    section : bool, optional
        Compute the potential, or the temperature, in a section through the lower body at the last state as well.
    progress : Progress, optional
        Stops the work.

    Returns
    -------
    ConductionResult
        `states`, `conductance`; numbers "conductance" and "conductance without film" of the last state.

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
    table = [
        *columns_of(states, "depth", "radius", "force"),
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
    numbers = _numbers(conductors, float(np.asarray(states.radius)[-1]), dimension)
    words = f"conductance at a = {numbers['contact radius']}: {numbers['conductance']}"
    if "conductance without film" in numbers:
        words += f"; without the film in the spot {numbers['conductance without film']}"
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
        section=_section(problem, given, conductors, states) if section else None,
    )


def _numbers(conductors: Conduction, radius: float, dimension: Dimension) -> dict[str, Number]:
    """The last conductance, and that without the film in the spot."""
    value = float(np.asarray(conductors.at_radius(radius).conductance))
    numbers = {"contact radius": Number(radius, LENGTH), "conductance": Number(value, dimension)}
    if conductors.film:
        bare = float(np.asarray(conductors.replace(film=0.0).at_radius(radius).conductance))
        numbers["conductance without film"] = Number(bare, dimension)
    return numbers


def _section(problem: Problem, given: Conducting, conductors: Conduction, states: States) -> SectionField:
    """What the lower body has at the last state."""
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
