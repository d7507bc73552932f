# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `friction`: fretting loops or a path of a contact with friction, and the energy it dissipates."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._units import ENERGY, FORCE, LENGTH, RATIO, STIFFNESS, shown
from ..contact import State
from ..errors import CancelledError, InvalidArgumentError, MDRError, UnreachableError
from ..friction import Friction, FrictionHistory
from ..panels import Axis, Figure, Line, Panel, Rule, along
from ..problem import Problem
from ..problem.friction import Sliding, SlidingPath
from ..progress import Progress
from ..sheared import FrictionLoop, ShearState
from .result import Array, Number, Result, Table, column, columns_of, study

_FROM, _TO, _COUNT = 0.01, 1.5, 12
"""Amplitudes in units of the shift of sliding, where the problem gives none."""
_RINGS = 100
"""Rings of the surface where springs interact."""


@dataclass(frozen=True, eq=False, kw_only=True)
class FrictionResult(Result):
    """A contact with friction. Table: "states", of the amplitudes of cycles or of the steps of a path."""

    problem: Problem
    friction: Friction
    state: State
    """the normal state: one of cycles, that of each step of a path"""
    shear: ShearState
    """the tangential states at the amplitudes, or after each step"""

    def figure(self) -> Figure:
        """Return the figure of the cycles or of the path."""
        raise NotImplementedError


@dataclass(frozen=True, eq=False, kw_only=True)
class CyclesResult(FrictionResult):
    """The cycles of one normal state."""

    sliding_shift: float
    """where sliding begins [m]"""
    energies: Array
    """dissipated in a cycle of each amplitude [J]"""
    loops: tuple[FrictionLoop, ...] = ()
    """some of the cycles"""

    def figure(self) -> Figure:
        """Return the tangential force along some cycles, and the energy that a cycle dissipates over its amplitude."""
        return Figure(self.title, (_loops_panel(self), _energies_panel(self)))


@dataclass(frozen=True, eq=False, kw_only=True)
class PathResult(FrictionResult):
    """A contact that follows a path."""

    rings: int
    """0: exact springs"""
    force_error: float
    """difference of T from that of half the rings, in units of the largest mu F"""
    energy_error: float
    """the same of the dissipated energy, in units of its end value"""

    def figure(self) -> Figure:
        """Return the tangential force over shift and step, and the dissipated energy."""
        return Figure(self.title, _path_panels(self), columns=3)


def _loops_panel(found: CyclesResult) -> Panel:
    x, length = along("shift s", LENGTH, found.loops[-1].shift)
    y, force = along("tangential force T", FORCE, found.loops[-1].tangential_force)
    lines = [
        Line(length.of(loop.shift), force.of(loop.tangential_force), f"{float(length.of(loop.turn.shift)):.3g} {length.symbol}", i)
        for i, loop in enumerate(reversed(found.loops))
    ]
    limit = float(force.of(found.friction.coefficient * float(found.state.force)))
    return Panel(x, y, (*lines, Rule(limit, name="sliding"), Rule(-limit)))


def _energies_panel(found: CyclesResult) -> Panel:
    shifts, lost = np.asarray(found.shear.shift), found.energies > 0.0
    x, length = along("amplitude of the shift", LENGTH, shifts, log=True)
    y, energy = along("energy of a cycle", ENERGY, found.energies, log=True)
    line = Line(length.of(shifts[lost]), energy.of(found.energies[lost]), marker="o")
    return Panel(x, y, (line, Rule(float(length.of(found.sliding_shift)), vertical=True, name="sliding")))


def _path_panels(found: PathResult) -> tuple[Panel, ...]:
    """T over the shift, T between -mu F and mu F over the steps, and the dissipated energy."""
    shear = found.shear
    shift, force, lost = (
        np.concatenate([[0.0], np.asarray(values, dtype=float)])
        for values in (shear.shift, shear.tangential_force, shear.dissipated_energy)
    )
    limit = found.friction.coefficient * np.concatenate([[0.0], np.asarray(found.state.force)])
    slides = np.concatenate([[False], np.asarray(shear.sliding)])
    steps, step = np.arange(float(len(shift))), Axis("step", whole=True)
    x, length = along("shift s", LENGTH, shift)
    y, newton = along("tangential force T", FORCE, np.concatenate([force, limit]))
    z, energy = along("dissipated energy", ENERGY, lost, low=0.0)
    path = [Line(length.of(shift), newton.of(force))]
    if slides.any():
        path.append(Line(length.of(shift[slides]), newton.of(force[slides]), "sliding", 1, -1, "o"))
    path.append(Line(length.of(shift[-1:]), newton.of(force[-1:]), "end", "black", -1, "s"))
    limits = (Line(steps, newton.of(limit), "\u00b1\u03bcF", "grey", 2), Line(steps, newton.of(-limit), "", "grey", 2))
    return (
        Panel(x, y, tuple(path)),
        Panel(step, y, (Line(steps, newton.of(force), "T"), *limits)),
        Panel(step, z, (Line(steps, energy.of(lost), colour=2),)),
    )


@study
def friction(problem: Problem, *, loops: bool = False, progress: Progress | None = None) -> FrictionResult:
    """Displace the indenter along the surface, in cycles or along a path.

    Parameters
    ----------
    problem : Problem
        A problem with the table [friction]. The cycles belong to the last state of [compute].
    loops : bool, optional
        Compute the tangential force along some of the cycles as well.
    progress : Progress, optional
        Reports the steps of a path, and can stop the work.

    Returns
    -------
    CyclesResult or PathResult
        Table "states"; number "dissipated energy", that of the last cycle or of the path.

    Raises
    ------
    ProblemError
        The table [friction] is missing.
    MDRError
        The problem cannot be solved, or a step of the path cannot be reached.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.3}}
    >>> tables = {"indenter": ball, "medium": glass, "compute": {"max_force": "1 mN"}}
    >>> found = studies.friction(problem.read({**tables, "friction": {"coefficient": 0.3, "shifts": ["1 nm"]}}))
    >>> print(found.numbers["sliding shift"])
    7.5734 nm
    """
    given: Sliding = problem.part("friction")
    progress = progress or Progress()
    progress.step(0, None, "contact")
    pair = Friction(problem.contact(), given.coefficient)
    if given.path is None:
        return _cycles(problem, given, pair, loops)
    return _path(problem, given.path, pair, progress)


def _cycles(problem: Problem, given: Sliding, pair: Friction, with_loops: bool) -> CyclesResult:
    """The cycles of the amplitudes that the problem gives."""
    state = problem.control.states(pair.contact, slice(-1, None))[0]
    sheared = pair.shear(state)
    limit = float(sheared.sliding_shift)
    amplitudes = np.array(given.amplitudes) if given.amplitudes else np.geomspace(_FROM, _TO, _COUNT) * limit
    turns = (sheared.at_shift if given.control == "shift" else sheared.at_force)(amplitudes)
    energies = 4.0 * np.asarray(turns.dissipated_energy)
    chosen = sorted({*range(len(amplitudes) - 1, -1, -max(1, len(amplitudes) // 4))})
    stiffness = float(pair.contact.medium.tangential_stiffness(state.radius))
    largest = given.coefficient * float(state.force)
    words = (
        f"normal force {shown(state.force, FORCE)}, depth {shown(state.depth, LENGTH)}, contact radius "
        f"{shown(state.radius, LENGTH)}, coefficient of friction {given.coefficient:g}\n"
        f"tangential stiffness without slip {shown(stiffness, STIFFNESS)}, {stiffness / float(state.stiffness):.4g} of the "
        "normal one\n"
        f"sliding from shift {shown(limit, LENGTH)} on, under {shown(largest, FORCE)}"
    )
    numbers = {
        "normal force": Number(float(state.force), FORCE),
        "depth": Number(float(state.depth), LENGTH),
        "contact radius": Number(float(state.radius), LENGTH),
        "tangential stiffness": Number(stiffness, STIFFNESS),
        "sliding shift": Number(limit, LENGTH),
        "sliding force": Number(largest, FORCE),
        "dissipated energy": Number(float(energies[-1]), ENERGY),
    }
    table: Table = [
        *columns_of(turns, "shift", "tangential_force"),
        column("T/(mu F)", np.asarray(turns.tangential_force) / given.coefficient / float(state.force), RATIO),
        *columns_of(turns, "stick_radius"),
        column("c/a", np.asarray(turns.stick_radius) / float(state.radius), RATIO),
        *columns_of(turns, "stiffness"),
        column("energy of a cycle", energies, ENERGY),
    ]
    return CyclesResult(
        title=problem.title,
        numbers=numbers,
        notes={"state": words},
        tables={"states": table},
        problem=problem,
        friction=pair,
        state=state,
        shear=turns,
        sliding_shift=limit,
        energies=energies,
        loops=tuple(sheared.loop(amplitudes[i], given.control) for i in chosen) if with_loops else (),
    )


def _path(problem: Problem, path: SlidingPath, pair: Friction, progress: Progress) -> PathResult:
    """The path of a problem; where it is computed by rings, once more with half of them."""
    at: Any = pair.contact.at_depth if path.name == "depth" else pair.contact.at_force
    state: State = at(path.values)
    history = _exact(pair) if path.rings is None else None
    rings, total = 0, len(path.values) * (1 if history else 2)
    force_error = energy_error = 0.0
    progress.step(0, total, "steps")
    if history:
        fine = _along(path, state, history, progress, 0, total)
    else:
        rings, deepest = path.rings or _RINGS, float(np.max(state.depth))
        fine = _along(path, state, pair.history(deepest, rings), progress, 0, total)
        coarse = _along(path, state, pair.history(deepest, rings // 2), progress, len(path.values), total)
        unit = pair.coefficient * float(np.max(state.force))
        force_error = float(np.max(np.abs(np.subtract(fine.tangential_force, coarse.tangential_force)))) / unit
        lost = np.asarray(fine.dissipated_energy)
        apart = float(np.max(np.abs(lost - np.asarray(coarse.dissipated_energy))))
        energy_error = apart / lost[-1] if lost[-1] > 0.0 else 0.0
    table: Table = [
        column("step", np.arange(1.0, len(np.asarray(fine.shift)) + 1.0), RATIO),
        *columns_of(state, "depth", "force"),
        *columns_of(fine, "shift", "tangential_force", "stick_radius", "dissipated_energy"),
        column("sliding", np.asarray(fine.sliding, dtype=float), RATIO),
    ]
    forces = np.asarray(fine.tangential_force)
    largest = int(np.argmax(np.abs(forces)))
    means = (
        f"{rings} rings; from half the rings T differs by {force_error:.1g} of the largest mu F, the "
        f"dissipated energy by {energy_error:.1g} of its end value"
        if rings
        else "exact springs"
    )
    dissipated = float(np.asarray(fine.dissipated_energy)[-1])
    words = (
        f"path of {len(forces)} steps, {int(np.count_nonzero(fine.sliding))} of them end in sliding; coefficient of friction "
        f"{pair.coefficient:g}\n"
        f"largest tangential force {shown(forces[largest], FORCE)} in step {largest + 1}, dissipated energy "
        f"{shown(dissipated, ENERGY)}\n"
        f"{means}"
    )
    return PathResult(
        title=problem.title,
        numbers={
            "largest tangential force": Number(float(forces[largest]), FORCE),
            "dissipated energy": Number(dissipated, ENERGY),
            "force error": Number(force_error, RATIO),
            "energy error": Number(energy_error, RATIO),
        },
        notes={"path": words},
        tables={"states": table},
        problem=problem,
        friction=pair,
        state=state,
        shear=fine,
        rings=rings,
        force_error=force_error,
        energy_error=energy_error,
    )


def _exact(pair: Friction) -> FrictionHistory | None:
    """A history in which every step is exact, None where springs interact."""
    try:
        return pair.history()
    except InvalidArgumentError:
        return None


def _along(path: SlidingPath, state: State, history: FrictionHistory, progress: Progress, before: int, total: int) -> ShearState:
    """The tangential states after each row; `before` of `total` steps are done."""
    shears = []
    for row, (depth, lateral) in enumerate(zip(np.asarray(state.depth), path.along_values, strict=True), start=1):
        try:
            history.advance(**{"depth": depth, path.along: lateral})
        except CancelledError:
            raise
        except MDRError as problem:
            # a row is the only entry of its step
            words = re.sub(r"^(entry \d+ of|entry \d+:) ", "", str(problem))
            if path.along == "tangential_force" and isinstance(problem, UnreachableError):
                words += "; lead a path with sliding by shifts"
            raise type(problem)(f"{path.file}, row {row} of the numbers: {words}") from problem
        shears.append(history.shear)
        progress.step(before + row, total, "steps")
    return ShearState._make(np.array(values) for values in zip(*shears, strict=True))
