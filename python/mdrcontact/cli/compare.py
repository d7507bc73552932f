# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact compare`: one problem under every model that applies to its medium."""

from __future__ import annotations

import argparse

import numpy as np

from .._progress import on_terminal
from .._text import aligned, number
from .._units import MODULUS, Dimension, practical
from ..problem import load
from ..studies import compare
from ..studies.compare import CompareResult
from ..studies.result import Array, spread_over
from . import files
from .table import as_csv, spread_text
from .workbook import as_xlsx

HELP = "compute one problem under every model of its medium, and the spread between them"
_SHOWN = 5


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    files.add_problem(parser, "all states of all models", "needs a coated, layered or graded medium")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load(arguments.problem)
    with on_terminal() as progress:
        found = compare(problem, progress=progress)
    print(f"{found.title}\n")
    if "adhesion" in found.notes:
        print(f"{found.notes['adhesion']}\n")
    print(_side_by_side(found, found.response, found.values, found.dimension) + "\n")
    print(_side_by_side(found, "effective modulus", np.array([a.curve.modulus for a in found.answers]), MODULUS) + "\n")
    print(_measured(found))
    for model, words in found.refusals:
        print(f"\nleft out: {model}: {words}", end="")
    print(end="\n" if found.refusals else "")
    files.write(
        arguments, csv=lambda: as_csv(found.tables["states"]), xlsx=lambda: as_xlsx(found, arguments.command), plot=found.figure
    )


def _picked(found: CompareResult) -> tuple[list[int], list[str]]:
    """Return the places of a few prescribed values, and these values as text."""
    control = found.problem.control
    picked, unit = spread_over(len(control.values), _SHOWN), practical(control.dimension, control.values)
    return picked, [f"{number(float(unit.of(control.values[i])))} {unit.name}" for i in picked]


def _side_by_side(found: CompareResult, name: str, values: Array, dimension: Dimension) -> str:
    """Return a row for each model and one for the spread, a column for each of a few prescribed values."""
    (picked, at), unit = _picked(found), practical(dimension, values.ravel())
    head = [f"{name} [{unit.name}] at {found.problem.control.name}", *at]
    rows = [[a.model, *(number(float(unit.of(v[i]))) for i in picked)] for a, v in zip(found.answers, values, strict=True)]
    last = ["spread", *(spread_text(float(values[:, i].max() / values[:, i].min())) for i in picked)]
    return aligned([head, *rows, last], left=1)


def _measured(found: CompareResult) -> str:
    """Return the deviation of every model from the exact one or, without it, from the median."""
    picked, at = _picked(found)
    rows = [[f"{found.response} against {found.basis}, at {found.problem.control.name}", *at]]
    for answer, row in zip(found.answers, found.values / found.base, strict=True):
        if answer.model != found.basis:
            rows.append([answer.model, *(_deviation_text(float(row[i])) for i in picked)])
    return aligned(rows, left=1)


def _deviation_text(ratio: float) -> str:
    """Return a ratio as a deviation in percent, or as a factor if it is large."""
    return f"{100.0 * (ratio - 1.0):+.1f} %" if 0.1 < ratio < 3.0 else f"factor {ratio:.3g}"
