# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `wear`: a sliding indenter that wears, at constant force or depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._units import LENGTH, RATIO, VOLUME, WEAR, shown
from ..panels import Figure, Line, Panel, along
from ..problem import Problem
from ..problem.wear import Rubbing
from ..progress import Progress
from ..wear import Wear, WearState, WornProfile
from .result import Mixed, Number, Result, Words, column, columns_of, study

_COLUMNS = ("sliding", "radius", "depth", "force", "pressure", "worn_depth", "worn_volume", "error")
_POINTS = 200
"""Points of the profile, up to 1.2 times the last contact radius."""


@dataclass(frozen=True, eq=False, kw_only=True)
class WearResult(Result):
    """An indenter that wears. Tables: "states", and "profile" before and after."""

    problem: Problem
    states: WearState
    profile: WornProfile
    """after the last distance"""

    def figure(self) -> Figure:
        """Return contact radius over sliding distance, and the profile before and after."""
        distance, metre = along("sliding distance s", LENGTH, self.states.sliding, log=True)
        radius, length = along("contact radius a", LENGTH, self.states.radius)
        r, new, worn = (part.values for part in self.tables["profile"] if not isinstance(part, Words | Mixed))
        across, side = along("distance from the axis r", LENGTH, r, low=0.0)
        height, deep = along("profile f", LENGTH, new)
        lines = (Line(side.of(r), deep.of(new), "new", "grey", 2), Line(side.of(r), deep.of(worn), "worn", 1))
        path = Line(metre.of(np.asarray(self.states.sliding)), length.of(np.asarray(self.states.radius)), marker="o")
        return Figure(self.title, (Panel(distance, radius, (path,)), Panel(across, height, lines)))


@study
def wear(problem: Problem, *, progress: Progress | None = None) -> WearResult:
    """Slide the indenter, and wear it by Archard's law.

    Parameters
    ----------
    problem : Problem
        A problem with the table [wear], which slides at the largest force or depth of [compute].
    progress : Progress, optional
        Stops the work.

    Returns
    -------
    WearResult
        `states` after each distance, the worn `profile`; numbers "worn volume", "contact radius", "error".

    Raises
    ------
    ProblemError
        The table [wear] is missing.
    MDRError
        The problem cannot be solved, or a worn contact is not a single disc.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.3}}
    >>> tables = {"indenter": ball, "medium": glass, "compute": {"max_force": "1 mN"}}
    >>> archard = {"coefficient": "1e-6 mm^3/(N*m)", "sliding": ["1 m"]}
    >>> found = studies.wear(problem.read({**tables, "wear": archard}))
    >>> print(found.numbers["worn volume"])
    1 um^3
    """
    given: Rubbing = problem.part("wear")
    (progress or Progress()).step(0, None, "wear")
    states, profile = _slide(problem, given)
    last = {name: float(np.asarray(value)[-1]) for name, value in states._asdict().items()}
    words = (
        f"coefficient of wear {shown(given.coefficient, WEAR)}, after {shown(last['sliding'], LENGTH)}:\n"
        f"worn volume {shown(last['worn_volume'], VOLUME)}, contact radius {shown(last['radius'], LENGTH)}, "
        f"error {last['error']:.1g}"
    )
    r = np.linspace(0.0, 1.2 * last["radius"], _POINTS)
    new = np.asarray(problem.indenter.height(r))
    worn = new + np.asarray(profile.worn_depth(r))
    return WearResult(
        title=problem.title,
        numbers={
            "worn volume": Number(last["worn_volume"], VOLUME),
            "contact radius": Number(last["radius"], LENGTH),
            "error": Number(last["error"], RATIO),
        },
        notes={"end": words},
        tables={
            "states": columns_of(states, *_COLUMNS),
            "profile": [column("r", r, LENGTH), column("new", new, LENGTH), column("worn", worn, LENGTH)],
        },
        problem=problem,
        states=states,
        profile=profile,
    )


def _slide(problem: Problem, given: Rubbing) -> tuple[WearState, WornProfile]:
    contact, control = problem.contact(), problem.control
    largest = float(np.max(control.values))
    process, distances = Wear(contact, given.coefficient), np.array(given.sliding)
    if control.name == "depth":
        return process.advance(distances, depth=largest, intervals=given.intervals, scheme=given.scheme)
    force = float(contact.at_radius(largest).force) if control.name == "radius" else largest
    return process.advance(distances, force=force, intervals=given.intervals, scheme=given.scheme)
