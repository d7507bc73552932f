# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `history`: a contact with a viscoelastic body along a path in time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._units import ENERGY, FORCE, LENGTH, SPEED, TIME, Dimension, shown
from ..adhesion import AdhesiveHistory, RateHistory, adhesive_history, rate_history
from ..contact import Contact
from ..panels import Figure, Line, Panel, along, marked
from ..poroelastic import history as gel_history
from ..poroelastic import is_poroelastic
from ..problem import Problem, ProblemError
from ..problem.history import HistoryPath
from ..progress import Progress
from ..time import History, refuse_drainage
from .result import Number, Result, columns_of, study

_SUDDEN = 0.02
"""A path whose first change takes less than this share of the time is drawn over the logarithm of the time."""
_FEWEST = 60
"""Steps that a path is cut into at least."""


@dataclass(frozen=True, eq=False, kw_only=True)
class HistoryResult(Result):
    """A contact along a path in time. Table: "path", at the times that the problem gives."""

    problem: Problem
    history: History
    """at all times that were computed"""
    edge: RateHistory | AdhesiveHistory | None = None
    """the complete result with rate-dependent or finite-range adhesion"""

    def figure(self) -> Figure:
        """Return what changes in time, and force over depth where both change."""
        return Figure(self.title, tuple(_panels(self)))


def _panels(found: HistoryResult) -> Iterator[Panel]:
    path = found.history
    x, time = along("time t", TIME, path.time)
    moves = [values for values in (path.depth, path.force) if np.ptp(values) > 0.0]
    first = min(float(path.time[np.argmax(np.abs(values - values[0]) >= 0.9 * np.ptp(values))]) for values in moves)
    late = path.time > 0.0
    if first < _SUDDEN * path.time[-1]:
        x = x._replace(log=True)
    shown = late if x.log else np.ones(len(path.time), dtype=bool)
    for i, (name, values, dimension) in enumerate(
        (("indentation depth d", path.depth, LENGTH), ("contact radius a", path.radius, LENGTH), ("force F", path.force, FORCE))
    ):
        if np.ptp(values) > 0.0:  # the radius of a flat punch is constant
            y, unit = along(name, dimension, values)
            yield Panel(x, y, (Line(time.of(path.time[shown]), unit.of(values[shown]), colour=i, marker=marked(values)),))
    if len(moves) == 2:
        depth, metre = along("indentation depth d", LENGTH, path.depth)
        force, newton = along("force F", FORCE, path.force)
        yield Panel(depth, force, (Line(metre.of(path.depth), newton.of(path.force), colour=3),))


@study
def history(problem: Problem, *, progress: Progress | None = None) -> HistoryResult:
    """Compute depth, contact radius and force along a path in time.

    Parameters
    ----------
    problem : Problem
        A problem with the table [history] and a viscoelastic or poroelastic body, or with rate-dependent adhesion.
    progress : Progress, optional
        Reports the samples of each round of the time integration, and can stop the work.

    Returns
    -------
    HistoryResult
        `history`; numbers "largest force" and its "time", and further ones of the notes.

    Raises
    ------
    ProblemError
        The table [history] is missing, or a spring has no path.
    MDRError
        The problem cannot be solved.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> soft = {"relaxed_shear_modulus": "1 MPa", "moduli": ["2 MPa"], "times": ["1 s"], "nu": 0.5}
    >>> ramp = {"path": "ramp", "depth": "500 nm", "rise_time": "1 s", "hold_time": "5 s"}
    >>> tables = {"indenter": ball, "medium": {"type": "homogeneous", "material": soft}, "history": ramp}
    >>> found = studies.history(problem.read(tables))
    >>> print(found.numbers["largest force"])
    14.226 uN
    """
    path: HistoryPath = problem.part("history")
    progress = progress or Progress()
    progress.step(0, None, "history")
    contact = problem.contact(in_time=True)
    spring = problem.adhesion and problem.adhesion.spring_stiffness
    edge: RateHistory | AdhesiveHistory | None = None
    if contact.adhesion is not None or contact.cohesive_stress > 0.0:
        edge = _follow_edge(contact, path, spring, progress)
        found, cuts = History(edge.time, edge.depth, edge.radius, edge.force), 1
        numbers, notes = _of_edge(edge)
    elif spring is not None:
        raise ProblemError(
            f"{problem.path}: [adhesion]: spring_stiffness is of a contact that it leads in time: give speed and exponent, "
            "or of a viscoelastic half-space its cohesive_stress"
        )
    else:
        found, cuts = _follow(contact, path, progress)
        numbers, notes = _of_history(found)
    kept = History(*(values[::cuts] for values in found))
    return HistoryResult(
        title=problem.title,
        numbers={name: Number(value, dimension) for name, (value, dimension) in numbers.items()},
        notes=notes,
        tables={"path": columns_of(kept, "time", "depth", "radius", "force")},
        problem=problem,
        history=found,
        edge=edge,
    )


def _follow(contact: Contact, path: HistoryPath, progress: Progress) -> tuple[History, int]:
    """The history, and how many of its steps are one of the path's: between few samples the force bends, and its work would be
    wrong."""
    cuts = max(1, -(-_FEWEST // max(1, len(path.time) - 1)))
    if path.drainage is not None or np.any(np.diff(path.time) <= 0.0) or (path.name != "depth" and np.any(path.values < 0.0)):
        cuts = 1  # raises, with the entry that the user gave
    samples = np.arange(len(path.time))
    places = np.arange((len(path.time) - 1) * cuts + 1) / cuts
    time, values = (np.interp(places, samples, column) for column in (path.time, path.values))
    prescribed: dict[str, Any] = {path.name: values}
    if is_poroelastic(contact.medium):
        return gel_history(contact, time, **prescribed, drainage=path.drainage), cuts
    refuse_drainage(path.drainage)
    return contact.history(time, **prescribed, progress=progress), cuts


def _follow_edge(contact: Contact, path: HistoryPath, spring: float | None, progress: Progress) -> RateHistory | AdhesiveHistory:
    """Return the history with rate-dependent or finite-range adhesion, under depth, force or spring control."""
    name = "position" if spring is not None and path.name == "depth" else path.name
    prescribed: dict[str, Any] = {name: path.values}
    refuse_drainage(path.drainage)
    if contact.adhesion is not None:
        return rate_history(contact, path.time, **prescribed, spring_stiffness=spring, progress=progress)
    return adhesive_history(contact, path.time, **prescribed, spring_stiffness=spring, progress=progress)


_Found = tuple[dict[str, tuple[float, Dimension]], dict[str, str]]
"""Numbers and notes."""


def _of_edge(found: RateHistory | AdhesiveHistory) -> _Found:
    """Pull-off, the last rupture, and the energy lost at an edge."""
    end = found.end
    numbers = {
        "largest force": (float(found.force.max()), FORCE),
        "lowest force": (end["lowest_force"], FORCE),
        "time of the lowest force": (end["lowest_time"], TIME),
    }
    notes = {"largest force": f"largest force: {shown(float(found.force.max()), FORCE)}"}
    notes["lowest force"] = (
        f"lowest force: {shown(end['lowest_force'], FORCE)} at {shown(end['lowest_time'], TIME)}, edge at "
        f"{shown(end['lowest_speed'], SPEED)}"
    )
    if end["ruptures"]:
        numbers["time of rupture"] = end["rupture_time"], TIME
        numbers["depth of rupture"] = end["rupture_depth"], LENGTH
        notes["rupture"] = f"the contact breaks at {shown(end['rupture_time'], TIME)}, depth {shown(end['rupture_depth'], LENGTH)}"
    if isinstance(found, RateHistory):
        numbers["energy lost"] = float(found.dissipated[-1]), ENERGY
        notes["energy"] = f"energy lost at the edge: {shown(float(found.dissipated[-1]), ENERGY)}"
    return numbers, notes


def _of_history(found: History) -> _Found:
    """The largest force, when contact is lost, and the energy lost over a closed path."""
    largest = int(np.argmax(found.force))
    force, time = float(found.force[largest]), float(found.time[largest])
    numbers = {"largest force": (force, FORCE), "time of the largest force": (time, TIME)}
    notes = {"largest force": f"largest force: {shown(force, FORCE)} at {shown(time, TIME)}"}
    touching = np.flatnonzero(found.radius > 0.0)
    if touching.size and touching[-1] < len(found.radius) - 1 and found.depth[touching[-1]] > 0.0:
        lost = float(found.time[touching[-1] + 1])
        numbers["time of separation"] = lost, TIME
        notes["separation"] = f"contact is lost before {shown(lost, TIME)}, while the surface still comes back"
    if touching.size and found.radius[-1] == 0.0:
        numbers["energy lost"] = float(found.work), ENERGY
        notes["energy"] = f"energy lost: {shown(found.work, ENERGY)}"
    return numbers, notes
