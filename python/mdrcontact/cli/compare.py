# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact compare`: the same problem under every medium model that applies to it."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ..contact import Contact
from ..errors import MDRError
from ..material import RIGID, Elastic
from ..medium import Coated, Graded, Layered, Medium
from ..medium.models import MODELS
from ..problem import Problem, ProblemError, load
from ..problem.units import FORCE, LENGTH, MODULUS, Dimension, practical
from . import files
from .solve import Array, Curve, columns, progress, solve
from .table import Column, aligned, as_csv, number, spread_over

_DESCRIPTION = """\
Computes one problem under every model of the effective modulus that applies to its medium, side by side, and how far the models
are apart. That is the uncertainty of the result as far as the choice of the model goes.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact compare problem.toml
    mdrcontact compare problem.toml --csv compare.csv --plot compare.png

The spread is largest/smallest over the models: "14 %" means that the largest is 14 % above the smallest. Models that refuse the
problem are listed with their reason. The models are measured by the exact one or, where it refuses, by the median of all.
"""

NEARLY_RIGID = 1000.0
"""A substrate this many times stiffer than the coating is also tried as a rigid base, and marked as such."""

_SHOWN = 5


class Answer(NamedTuple):
    """What one model says."""

    model: str
    medium: Medium
    curve: Curve


def add(subparsers: Any) -> None:
    """Adds the command to the command line."""
    parser = subparsers.add_parser(
        "compare",
        help="one problem under every medium model, and the spread between them",
        description=_DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("problem", metavar="PROBLEM.toml", help="the problem file; its medium is coated, layered or graded")
    files.add_options(parser, "all states of all models")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments.csv, arguments.plot, overwrite=arguments.overwrite)
    if arguments.plot:
        from . import figures

        figures.require(arguments.plot)
    problem = load(arguments.problem)
    answers, refusals = ask(problem)
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
    print("\n" if refusals else "")
    results = {}
    if arguments.csv:
        results[arguments.csv] = _long_csv(answers)
    if arguments.plot:
        results[arguments.plot] = figures.compare_figure(problem, answers, files.figure_format(arguments.plot))
    files.write(results, arguments.overwrite)


def ask(problem: Problem) -> tuple[list[Answer], list[tuple[str, str]]]:
    """The answers of all models, and the words of those that refuse."""
    names = candidates(problem.medium)
    if not names:
        kind = type(problem.medium).__name__
        raise ProblemError(f"there is nothing to compare: a {kind} medium has one model; use a coated, layered or graded one")
    answers, refusals = [], []
    with progress(len(names), problem.control) as bar:
        for label, model, base in names:
            try:
                medium = _under(problem.medium, model, base)
                answers.append(Answer(label, medium, solve(Contact(problem.indenter, medium), problem.control, bar)))
            except MDRError as refusal:
                refusals.append((label, str(refusal)))
    if not answers:
        raise MDRError("no model answers this problem: " + "; ".join(f"{model}: {words}" for model, words in refusals))
    return answers, refusals


def candidates(medium: Medium) -> list[tuple[str, str, object]]:
    """(label, model, substrate) of every model worth asking; substrate None leaves it as it is."""
    if isinstance(medium, (Layered, Graded)):
        return [(name, name, None) for name, model in MODELS.items() if model.layers]
    if not isinstance(medium, Coated):
        return []
    if not isinstance(medium.substrate, Elastic):
        return [(name, name, None) for name, model in MODELS.items() if model.needs_rigid_base or name == "exact"]
    found: list[tuple[str, str, object]] = [(name, name, None) for name, m in MODELS.items() if not m.needs_rigid_base]
    if medium.substrate.contact_modulus >= NEARLY_RIGID * medium.coating.contact_modulus:
        found += [(f"{name} (rigid base)", name, RIGID) for name, model in MODELS.items() if model.needs_rigid_base]
    return found


def _under(medium: Any, model: str, base: Any) -> Medium:
    if model == medium.model and base is None:
        return medium  # type: ignore[no-any-return]
    if base is None:
        return medium.with_model(model)  # type: ignore[no-any-return]
    return Coated(medium.coating, medium.thickness, base, model)


def response_of(problem: Problem) -> tuple[str, Any, Dimension]:
    """What the models are compared by: the force, or the depth where the force is prescribed."""
    if problem.control.name == "force":
        return "depth", lambda curve: curve.depth, LENGTH
    return "force", lambda curve: curve.force, FORCE


def spread_text(values: Array) -> str:
    """How far the largest of some values is above the smallest."""
    ratio = float(values.max() / values.min())
    if ratio < 3.0:
        return f"{100.0 * (ratio - 1.0):.1f} %"
    return f"factor {ratio:.1f}" if ratio < 100.0 else f"factor {ratio:.0f}"


def reference(answers: Sequence[Answer], values: Array) -> tuple[str, Array]:
    """What the models are measured by: the exact one, without it their median; `values` has one row for each answer."""
    for answer, row in zip(answers, values, strict=True):
        if answer.model == "exact":
            return "exact", row
    median: Array = np.exp(np.median(np.log(values), axis=0))
    return "median of the models", median


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
