# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `imprint`: unloading and reloading of a plastic contact, which are those of an elastic one of another profile."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from .._units import ENERGY, FORCE, LENGTH, MODULUS, RATIO, STIFFNESS
from .._warn import silence
from ..contact import Contact
from ..errors import MDRError
from ..panels import Figure, Line, Panel, Rule, along
from ..plastic import Imprint, Overload, YieldStress
from ..problem import Problem, ProblemError
from ..problem.compute import Control
from ..problem.imprint import Imprinted, unloading
from ..profile import FlatPunch
from ..progress import Progress
from .result import Array, Column, Number, Result, Table, column, study
from .stress import layer_name

_POINTS = 200
"""Points of pressure and shapes over the contact radius."""
_MEANINGS = (
    (1.7, "Unloading is elastic."),
    (2.0, "Unloading is elastic to 0.1 % of the largest force."),
    (2.5, "Unloading yields again, with an error of up to 0.5 % of the largest force."),
    (3.0, "Unloading yields again, with an error of up to 2.5 % of the largest force."),
)
"""By largest R_Y: what finite elements show."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ImprintResult(Result):
    """Unloading of a plastic contact. Tables: "states", "shapes" and "pressure", and "reverse yield" with yield stresses."""

    problem: Problem
    imprint: Imprint
    contact: Contact
    """the elastic contact of the imprint, whose depths count from the residual depth"""

    def figure(self) -> Figure:
        """Return unloading, effective indenter, pressure at the largest load and recovery."""
        panels = (*_unloading(self), *_shapes(self), *_pressure(self), *_recovery(self))
        return Figure(self.title, panels)

    def values(self, table: str) -> list[Array]:
        """Return the numbers of a table, column by column."""
        return [one.values for one in self.tables[table] if isinstance(one, Column)]


def _unloading(found: ImprintResult) -> Iterator[Panel]:
    d, _, f, *_ = found.values("states")
    x, depth = along("indentation depth d", LENGTH, d, low=0.0)
    y, force = along("force F", FORCE, f)
    start = Rule(float(depth.of(found.numbers["residual depth"].value)), vertical=True, name="residual depth")
    yield Panel(x, y._replace(low=None if f.min() < 0.0 else 0.0), (Line(depth.of(d), force.of(f)), start), "unloading, reloading")


def _shapes(found: ImprintResult) -> Iterator[Panel]:
    r, effective, tip, left = found.values("shapes")
    x, side = along("distance from the axis r", LENGTH, r, low=0.0)
    y, deep = along("height z", LENGTH, np.concatenate([effective, tip]))
    shapes = ((effective, "effective indenter", 0, 0), (tip, "indenter", "grey", 1), (left, "surface without load", 1, 0))
    yield Panel(x, y, tuple(Line(side.of(r), deep.of(z), name, colour, dash) for z, name, colour, dash in shapes), "shapes")


def _pressure(found: ImprintResult) -> Iterator[Panel]:
    r, pressure = found.values("pressure")
    x, side = along("distance from the axis r", LENGTH, r, low=0.0)
    y, unit = along("contact pressure p", MODULUS, pressure)
    yield Panel(x, y._replace(low=0.0), (Line(side.of(r), unit.of(pressure)),), "at the largest load")


def _recovery(found: ImprintResult) -> Iterator[Panel]:
    d, energy = found.values("states")[0], found.values("states")[4]
    x, depth = along("indentation depth d", LENGTH, d, low=0.0)
    y, unit = along("energy to be recovered", ENERGY, energy)
    yield Panel(x, y, (Line(depth.of(d), unit.of(energy)),), "recovery")


@study
def imprint(problem: Problem, *, progress: Progress | None = None) -> ImprintResult:
    """Unload a plastic contact from its largest load.

    Parameters
    ----------
    problem : Problem
        A problem with the table [imprint], whose states are those of [compute]; without it the contact unloads to force 0. A
        problem with yield stresses and without [imprint] is loaded to the largest value of [compute] by the overload rule.
    progress : Progress, optional
        Stops the work.

    Returns
    -------
    ImprintResult
        `imprint`, `contact`, tables "states", "shapes", "pressure"; numbers "residual depth", "recovered work" and others.

    Raises
    ------
    ProblemError
        [imprint] and yield stresses are missing; the work of adhesion depends on speed, acts at a distance, or yields the body
        alone; the indenter is a flat punch, or depths of [compute] are not those of the imprint.
    MDRError
        The imprint has no elastic contact, or it yields again on unloading, R_Y > 3.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> metal = {"type": "homogeneous", "material": {"E": "70 GPa", "nu": 0.33, "yield_stress": "0.35 GPa"}}
    >>> largest = {"radius": "1 um", "force": "2.84 mN", "depth": "61.5 nm", "residual_depth": "38.8 nm"}
    >>> found = studies.imprint(problem.read({"indenter": ball, "medium": metal, "imprint": largest}))
    >>> print(found.numbers["recovered work"], found.notes["reverse yield"])
    27.571 pJ R_Y of the half-space: 1.6399. Unloading is elastic.
    """
    problem.check_elastic()
    (progress or Progress()).step(0, None, "imprint")
    made, control = _imprint(problem)
    contact = made.contact(_work_of_adhesion(problem))
    ratios, notes = _reverse_yield(made, problem.yield_stresses)
    numbers = {
        "largest force": Number(made.force, FORCE),
        "largest depth": Number(made.depth, LENGTH),
        "residual depth": Number(made.residual_depth, LENGTH),
        "recovered work": Number(made.recovered_work, ENERGY),
        **ratios,
    }
    recovered = f"Unloading recovers {numbers['recovered work']} and {Number(made.recovery, LENGTH)} of the depth."
    tables: dict[str, Table] = {
        "states": _states(made, contact, control),
        "shapes": _shape_table(problem, made),
        "pressure": _pressure_table(made),
    }
    return ImprintResult(
        title=problem.title,
        numbers=numbers,
        notes={"recovery": recovered, **notes},
        tables=tables,
        problem=problem,
        imprint=made,
        contact=contact,
    )


def _imprint(problem: Problem) -> tuple[Imprint, Control]:
    """Return the imprint of [imprint], or that of loading by the overload rule, and the states on unloading."""
    if isinstance(problem.indenter, FlatPunch):
        remedy = "Use mdrcontact curve: unloading has the stiffness of its states"
        raise ProblemError("the contact radius of a flat punch does not change, and leaves no imprint", remedy, table="indenter")
    if problem.imprint is not None or not problem.yield_stresses:
        given: Imprinted = problem.part("imprint")
        return given.imprint(problem.medium), problem.control
    rule = Overload(Contact(problem.indenter, problem.medium), [y for y, _ in _limits(problem.yield_stresses)])
    _check_adhesion(problem, rule)
    made = getattr(rule, f"at_{problem.control.name}")(float(problem.control.values[-1])).imprint()
    return made, unloading(made.force)


def _check_adhesion(problem: Problem, rule: Overload) -> None:
    """Raise an error if the contact at force 0 yields by adhesion alone, theory/plastic.md (3.6)."""
    work = _work_of_adhesion(problem)
    if not work:
        return
    radius = float(Contact(problem.indenter, problem.medium, work_of_adhesion=work).at_force(0.0).radius)
    try:
        with silence():
            yields = float(rule.at_radius(radius).force_error) > 0.0
    except MDRError:
        yields = True
    if yields:
        remedy = "Decrease it, or measure the indent and write it in [imprint]"
        given = f"{work:g} J/m^2"
        raise ProblemError("adhesion alone yields the body", remedy, table="adhesion", key="work_of_adhesion", value=given)


def _limits(stresses: tuple[YieldStress | None, ...]) -> list[YieldStress]:
    return [YieldStress(np.inf, 0.0) if stress is None else stress for stress in stresses]


def _work_of_adhesion(problem: Problem) -> float:
    adhesion = problem.adhesion
    if adhesion is None:
        return 0.0
    if adhesion.rate is not None or adhesion.cohesive_stress:
        remedy = "Leave out speed, exponent, closing_... and cohesive_stress"
        raise ProblemError("an imprint has adhesion in the JKR limit alone", remedy, table="adhesion")
    return float(adhesion.work_of_adhesion)


def _reverse_yield(made: Imprint, stresses: tuple[YieldStress | None, ...]) -> tuple[dict[str, Number], dict[str, str]]:
    """Return R_Y of each layer that can yield, and notes on what it means; an error above 3."""
    if not stresses:
        return {}, {}
    limits, errors = np.array(_limits(stresses)).T
    most = made.reverse_yield(limits).ratio
    found, notes = {}, {}
    for i in np.flatnonzero(np.isfinite(limits)):
        place = "half-space" if len(limits) == 1 else layer_name(tuple(limits), int(i))
        alone = np.where(np.arange(len(limits)) == i, limits, np.inf)
        with silence():
            found[f"R_Y of the {place}"] = Number(made.reverse_yield(alone).ratio, RATIO)
        if errors[i]:
            words = f"The yield stress of the {place} from its hardness is {Number(float(limits[i]), MODULUS)}"
            notes[f"yield stress of the {place}"] = f"{words}, with an error of {100.0 * errors[i]:.2g} %. R_Y has the same error."
    meaning = next(words for limit, words in _MEANINGS if most <= limit)
    ratios = ", ".join(f"{name}: {number}" for name, number in found.items())
    return found, {"reverse yield": f"{ratios}. {meaning}", **notes}


def _states(made: Imprint, contact: Contact, control: Control) -> Table:
    """States on unloading; depths from initial contact."""
    if control.name == "depth":
        low, high = made.residual_depth, made.depth
        if np.max(control.values) > high * (1.0 + 1e-12) or (not contact.work_of_adhesion and np.min(control.values) < low):
            rule = f"an imprint unloads from {Number(high, LENGTH)} to its residual depth {Number(low, LENGTH)}"
            raise ProblemError(rule, "Write depths between them", table="compute")
        control = control._replace(values=control.values - made.residual_depth)
    states = control.states(contact)
    return [
        column("depth", np.asarray(states.depth) + made.residual_depth, LENGTH),
        column("radius", states.radius, LENGTH),
        column("force", states.force, FORCE),
        column("stiffness", states.stiffness, STIFFNESS),
        column("energy", states.energy(), ENERGY),
    ]


def _shape_table(problem: Problem, made: Imprint) -> Table:
    """Effective indenter, indenter, and what it leaves: the surface without load, which touches both on the axis."""
    r = np.linspace(0.0, made.radius, _POINTS)
    effective, tip = np.asarray(made.profile.height(r)), np.asarray(problem.indenter.height(r))
    return [
        column("r", r, LENGTH),
        column("effective indenter", effective, LENGTH),
        column("indenter", tip, LENGTH),
        column("surface without load", tip - effective - made.residual_depth, LENGTH),
    ]


def _pressure_table(made: Imprint) -> Table:
    # dense towards the edge, where pressures are steep, and a hair inside it
    r = made.radius * (1.0 - 1e-9) * np.sin(np.linspace(0.0, 0.5 * np.pi, _POINTS))
    return [column("r", r, LENGTH), column("pressure", made.contact().at_force(made.force).pressure(r), MODULUS)]
