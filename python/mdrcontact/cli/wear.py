# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact wear`: a sliding indenter that wears, at constant force or depth."""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from .._units import LENGTH, VOLUME, WEAR, practical, shown
from ..problem import Problem, load_with
from ..problem.wear import Rubbing
from ..wear import Wear, WearState, WornProfile
from . import files
from .figures import COLOURS, sheet
from .table import as_csv, as_text, columns_of

HELP = "a sliding indenter that wears: radius, depth, worn profile"
DESCRIPTION = """\
Slides the indenter at the largest force or depth of the problem, and wears it by Archard's law, dh = k p ds: contact radius, depth,
force, pressure and worn depth on the axis after each sliding distance, and the worn profile.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact wear problem.toml --csv wear.csv --plot wear.png

The problem file has one table more than for the other commands:

    [wear]
    coefficient = "1e-6 mm^3/(N*m)"           # worn volume per force and sliding distance
    sliding = ["1 m", "10 m", "100 m"]
    intervals = 80                            # 16 to 640; errors fall as their square
    scheme = "disc"                           # or "rings", for flat punches too

The error is stated: the difference from half the intervals.
"""

_ROWS = 24
_COLUMNS = ("sliding", "radius", "depth", "force", "pressure", "worn_depth", "worn_volume", "error")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "radii, depths and forces of the sliding distances", "it has a table [wear]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem, rubbing = load_with(arguments.problem, "wear")
    states, profile = _slide(problem, rubbing)
    table = columns_of(states, *_COLUMNS)
    print(f"{problem.title}\n\n{_words(rubbing, states)}\n\n{as_text(table, _ROWS)}")
    files.write(arguments, csv=lambda: as_csv(table), plot=lambda: _draw(problem, states, profile))


def _slide(problem: Problem, rubbing: Rubbing) -> tuple[WearState, WornProfile]:
    contact, control = problem.contact(), problem.control
    largest = float(np.max(control.values))
    wear, distances = Wear(contact, rubbing.coefficient), np.array(rubbing.sliding)
    intervals, scheme = rubbing.intervals, rubbing.scheme
    if control.name == "depth":
        return wear.advance(distances, depth=largest, intervals=intervals, scheme=scheme)
    force = float(contact.at_radius(largest).force) if control.name == "radius" else largest
    return wear.advance(distances, force=force, intervals=intervals, scheme=scheme)


def _words(rubbing: Rubbing, states: WearState) -> str:
    last = {name: float(np.asarray(value)[-1]) for name, value in states._asdict().items()}
    return (
        f"coefficient of wear {shown(rubbing.coefficient, WEAR)}, after {shown(last['sliding'], LENGTH)}:\n"
        f"worn volume {shown(last['worn_volume'], VOLUME)}, contact radius {shown(last['radius'], LENGTH)}, "
        f"error {last['error']:.1g}"
    )


def _draw(problem: Problem, states: WearState, profile: WornProfile) -> Any:
    """Radius and depth against distance, and the profile before and after."""
    with sheet(problem.title, 1, 2, (9.6, 4.2)) as (figure, axes):
        along = practical(LENGTH, np.asarray(states.sliding))
        length = practical(LENGTH, np.asarray(states.radius))
        height = practical(LENGTH, np.asarray(states.depth))
        axes[0].semilogx(
            along.of(np.asarray(states.sliding)), length.of(np.asarray(states.radius)), "o-", color=COLOURS[0], markersize=4
        )
        axes[0].set(xlabel=f"sliding [{along.symbol}]", ylabel=f"contact radius [{length.symbol}]")
        r = np.linspace(0.0, 1.2 * float(np.asarray(states.radius)[-1]), 200)
        new = np.asarray(problem.indenter.height(r))
        axes[1].plot(length.of(r), height.of(new), color="#707070", linestyle=":", label="new")
        axes[1].plot(length.of(r), height.of(new + np.asarray(profile.worn_depth(r))), color=COLOURS[1], label="worn")
        axes[1].set(xlabel=f"r [{length.symbol}]", ylabel=f"profile [{height.symbol}]")
        axes[1].legend(frameon=False)
    return figure
