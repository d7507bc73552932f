# SPDX-License-Identifier: GPL-3.0-or-later
"""Bytes into the readers of problem files, fit files and tables: whatever they hold, the answer is a result or a ProblemError."""

from __future__ import annotations

import atexit
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

import numpy as np

from mdrcontact._units import FORCE, LENGTH, MODULUS, RATIO, STIFFNESS
from mdrcontact.errors import MDRError
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.reading.columns import MeasuredTable, read_table
from mdrcontact.problem import ProblemError, load

SEPARATOR = b"\n=====\n"
"""Between the problem file and the table of a fit or a path."""

_folder = tempfile.mkdtemp()
atexit.register(shutil.rmtree, _folder, ignore_errors=True)


def feed(data: bytes) -> None:
    """The first byte says which reader gets the others."""
    kind = data[0] % 3 if data else 0
    (_read_problem, _read_fit, _read_table)[kind](data[1:])


def _written(name: str, data: bytes) -> Path:
    path = Path(_folder, name)
    path.write_bytes(data)
    return path


def _read_problem(data: bytes) -> None:
    text, _, table = data.partition(SEPARATOR)
    _written("path.csv", table)
    try:
        problem = load(_written("problem.toml", text))
    except ProblemError:
        return
    history, path = problem.history, problem.friction and problem.friction.path
    columns = [problem.control.values]
    if history:
        columns += [history.time, history.values]
    if path:
        columns += [path.values, path.along_values]
    if not all(np.all(np.isfinite(column)) for column in columns):
        raise AssertionError("a problem without an error prescribes values that are not finite")
    try:
        state = problem.contact().at_radius(0.0)
    except MDRError:
        return
    if state.radius != 0.0:
        raise AssertionError("another state than requested")


def _read_fit(data: bytes) -> None:
    problem, _, table = data.partition(SEPARATOR)
    try:
        file = load_fit_file(_written("fit.toml", problem))
        file.read_data(_written("data.csv", table))
    except MDRError:
        return


def _read_table(data: bytes) -> None:
    try:
        table = read_table(_written("data.csv", data))
    except ProblemError:
        return
    if table.values.shape[1] != len(table.titles):
        raise AssertionError("the table has another number of columns than titles")
    _find_columns(table)


def _find_columns(table: MeasuredTable) -> None:
    for dimension in (LENGTH, FORCE, MODULUS, STIFFNESS, RATIO):
        with suppress(ProblemError):
            table.find("force", ["h", "depth", "force", "p"], dimension)
        for title in table.titles:
            try:
                table.column(title, dimension)
            except ProblemError:
                continue
