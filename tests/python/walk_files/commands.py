# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands say of a problem file, as numbers in SI units and words."""

from __future__ import annotations

import argparse
import contextlib
import csv
import dataclasses
import functools
import io
import math
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

import mdrcontact as mdr
from mdrcontact import _units as units
from mdrcontact import cli, studies
from mdrcontact.cli.files import OutputError

Answer = dict[str, Any]
"""Arrays of numbers and lists of words, by name."""
REFUSALS = (mdr.MDRError, OutputError)
_FACTORS = {
    unit: factor
    for dimension in vars(units).values()
    if isinstance(dimension, units.Dimension)
    for unit, factor in dimension.practical
}


@functools.cache
def _parser(command: str) -> tuple[Any, argparse.ArgumentParser]:
    module = next(one for one in cli.COMMANDS if one.__name__.rpartition(".")[2] == command)
    parser = argparse.ArgumentParser()
    module.add_arguments(parser)
    return module, parser


def run(command: str, *arguments: Any) -> str:
    """What a command prints; it raises where `mdrcontact` prints one line and fails."""
    module, parser = _parser(command)
    with contextlib.redirect_stdout(io.StringIO()) as printed, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        module.run(parser.parse_args([*map(str, arguments), "--overwrite"]))
    return printed.getvalue()


def csv_numbers(path: Path) -> Answer:
    """The columns of a CSV file, in SI units."""
    with path.open(newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    found: Answer = {}
    for title, cells in zip(head, zip(*rows, strict=True), strict=True):
        name, _, unit = title.partition(" [")
        try:
            found[name] = np.array([float(cell) if cell else math.nan for cell in cells]) * _FACTORS[unit.rstrip("]")]
        except ValueError:
            found[name] = list(cells)
    return found


def numbers_of(value: Any, name: str = "") -> Answer:
    """All numbers and words of nested tuples, lists and dictionaries."""
    if value is None or isinstance(value, (str, bool)):
        return {name: [str(value)]}
    if isinstance(value, (int, float, complex, np.ndarray, np.number)):
        return {name: np.atleast_1d(np.asarray(value))}
    if isinstance(value, Mapping):
        parts = value.items()
    elif isinstance(value, mdr.State):
        parts = ((field.name, getattr(value, field.name)) for field in dataclasses.fields(value))
    elif hasattr(value, "_fields"):
        parts = ((field, getattr(value, field)) for field in value._fields)
    else:
        parts = enumerate(value)
    found: Answer = {}
    for key, part in parts:
        found |= numbers_of(part, f"{name}.{key}")
    return found


def difference(one: Answer, other: Answer) -> float:
    """How far two answers are apart in units of the largest number of each column; infinite where words or sizes differ."""
    if one.keys() != other.keys():
        return math.inf
    largest = 0.0
    for name, value in one.items():
        new = other[name]
        if isinstance(value, list) or isinstance(new, list):
            if value != new:
                return math.inf
            continue
        if value.shape != new.shape or np.any(np.isfinite(value) != np.isfinite(new)):
            return math.inf
        finite = np.isfinite(value)
        unit = np.max(np.abs(value[finite]), initial=0.0) or np.max(np.abs(new[finite]), initial=0.0)
        if unit:
            largest = max(largest, float(np.max(np.abs(value - new)[finite])) / unit)
    return largest


def _by_csv(command: str, file: Path) -> Answer:
    run(command, file, "--csv", file.with_suffix(".csv"))
    return csv_numbers(file.with_suffix(".csv"))


def _adhesion(file: Path) -> Answer:
    """The loop, and the ends of stability that are printed alone."""
    printed = run("adhesion", file, "--csv", file.with_suffix(".csv"))
    return {**csv_numbers(file.with_suffix(".csv")), "printed": printed.split("\n", 3)[3].splitlines()}


def _stress(file: Path) -> Answer:
    """Largest stresses and failures; the map would take the time of all others."""
    problem = mdr.problem.load(file)
    found = studies.stress(problem, friction=0.17 if problem.strength else 0.0)
    failures = [(f.mode, f.place, f.strength, f.at_once, f.at, float(f.state.depth)) for f in found.failures]
    return numbers_of({"largest": found.critical, "failures": failures, "unreached": found.notes.get("unreached", "")})


def _law(file: Path) -> Answer:
    """What a law says between its ends."""
    run("law", file, file.with_suffix(".law"))
    law = mdr.ContactLaw.load(file.with_suffix(".law"))
    depth = np.linspace(*law.depth_range, 7)[1:-1]
    return numbers_of({"points": law.at_depth(depth), "ends": law.depth_range, "force": law.force_range, "error": law.tolerance,
                       "friction": [law.sliders, law.coefficient]})  # fmt: skip


def _imprint(file: Path) -> Answer:
    """All tables and numbers: R_Y is printed alone, and the shape of the indenter shows in the surface that it leaves."""
    found = studies.imprint(mdr.problem.load(file))
    tables = {name: found.values(name) for name in ("states", "shapes", "pressure")}
    return numbers_of({**tables, "numbers": {name: number.value for name, number in found.numbers.items()}})


def answer(command: str, file: Path) -> Answer:
    """What a command says of a problem file."""
    own: dict[str, Callable[[Path], Answer]] = {"adhesion": _adhesion, "stress": _stress, "law": _law, "imprint": _imprint}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return own[command](file) if command in own else _by_csv(command, file)
