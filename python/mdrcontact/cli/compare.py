# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact compare`: the same problem under every medium model that applies to it."""

from __future__ import annotations

import argparse

import numpy as np

from .._text import aligned
from .._units import FORCE, LENGTH, MODULUS, Dimension, practical
from ..problem import Problem, load
from . import figures, files
from .answers import Answer, answers_of, reference, response_of, spread_text
from .solve import Array, columns
from .table import Column, as_csv, number, spread_over

HELP = "one problem under every medium model, and the spread between them"
DESCRIPTION = """\
Computes one problem under every model of the effective modulus that applies to its medium, side by side, and how far the models
are apart. That is the uncertainty of the result as far as the choice of the model goes.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact compare problem.toml
    mdrcontact compare problem.toml --csv compare.csv --plot compare.png

The spread is largest/smallest over the models: "14 %" means that the largest is 14 % above the smallest. Models that refuse the
problem are listed with their reason. The models are measured by the exact one or, where it refuses, by the median of all.
"""

_SHOWN = 5


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "all states of all models", "its medium is coated, layered or graded")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = load(arguments.problem)
    answers, refusals = answers_of(problem)
    print(f"{problem.title}\n")
    if problem.adhesion:
        print("The models are compared without adhesion.\n")
    name, response, dimension = response_of(problem)
    print(_side_by_side(problem, answers, name, [response(a.curve) for a in answers], dimension))
    print()
    print(_side_by_side(problem, answers, "effective modulus", [a.curve.modulus for a in answers], MODULUS))
    print()
    print(_measured(problem, answers, name, np.array([response(a.curve) for a in answers])))
    for model, words in refusals:
        print(f"\nleft out: {model}: {words}", end="")
    print(end="\n" if refusals else "")
    files.write(arguments, csv=lambda: _long_csv(answers), plot=lambda: figures.compare_figure(problem, answers))


def _side_by_side(problem: Problem, answers: list[Answer], name: str, values: list[Array], dimension: Dimension) -> str:
    """A row for each model and one for the spread, a column for each of a few prescribed values."""
    control = problem.control
    picked = spread_over(len(control.values), _SHOWN)
    unit, given = practical(dimension, np.concatenate(values)), practical(control.dimension, control.values)
    at = [f"{number(float(given.of(control.values[i])))} {given.name}" for i in picked]
    head = [f"{name} [{unit.name}] at {control.name}", *at]
    rows = [[a.model, *(number(float(unit.of(v[i]))) for i in picked)] for a, v in zip(answers, values, strict=True)]
    last = ["spread", *(spread_text(np.array([v[i] for v in values])) for i in picked)]
    return aligned([head, *rows, last], left=1)


def _measured(problem: Problem, answers: list[Answer], name: str, values: Array) -> str:
    """How far every model is from the exact one or, without it, from the median."""
    basis, base = reference(answers, values)
    picked = spread_over(len(problem.control.values), _SHOWN)
    given = practical(problem.control.dimension, problem.control.values)
    at = [f"{number(float(given.of(problem.control.values[i])))} {given.name}" for i in picked]
    rows = [[f"{name} against {basis}, at {problem.control.name}", *at]]
    for answer, row in zip(answers, values, strict=True):
        if answer.model != basis:
            rows.append([answer.model, *(deviation_text(float(row[i] / base[i])) for i in picked)])
    return aligned(rows, left=1)


def deviation_text(ratio: float) -> str:
    """A ratio as a deviation in percent, or as a factor where percents say little."""
    return f"{100.0 * (ratio - 1.0):+.1f} %" if 0.1 < ratio < 3.0 else f"factor {ratio:.3g}"


def _long_csv(answers: list[Answer]) -> bytes:
    """All models below each other, in common units."""
    tables = [columns(a.curve, a.medium) for a in answers]
    labels = [a.model for a in answers for _ in a.curve.depth]
    dimensions = {"depth": LENGTH, "radius": LENGTH, "force": FORCE}
    stacked = []
    for parts in zip(*tables, strict=True):
        values = np.concatenate([part.values for part in parts])
        unit = practical(dimensions[parts[0].name], values) if parts[0].name in dimensions else parts[0].unit
        stacked.append(Column(parts[0].name, values, unit))
    return as_csv(stacked, ("model", labels))
