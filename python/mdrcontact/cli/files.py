# SPDX-License-Identifier: GPL-3.0-or-later
"""Write results to files: all or none, and over an existing file only with --overwrite."""

from __future__ import annotations

import argparse
import importlib
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from .._files import check_place, replace
from ..instruments.fitting import report
from ..instruments.reading import afm
from ..instruments.reading.asylum import is_second
from ..instruments.reading.cells import SHEETS
from ..panels import matplotlib
from ..problem import ProblemError
from ..problem.toml import parse_file, text_of

DATA_SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".hld", *SHEETS, *afm.SUFFIXES)
"""File extensions of measurements."""
_RESULTS = ("csv", "xlsx", "pressure_csv", "plot", "ranges", "json", "report", "npy", "law", "output")
"""Arguments that name a file to be written."""
_NAMES = ("file", "path", "labels")
"""Keys of problem files that name a file to be read."""


class OutputError(Exception):
    """A result cannot be written."""


def add_problem(parser: argparse.ArgumentParser, results: str, has: str = "") -> None:
    """Add the arguments of a command on a contact. results : in the CSV file; has : what the problem file needs"""
    parser.add_argument("problem", metavar="PROBLEM.toml", help=f"problem file; {has}" if has else "problem file")
    add_options(parser, results)


def add_fit(parser: argparse.ArgumentParser, results: str, data: str, tables: str) -> None:
    """Add the arguments of a fit of measurements. data : their meaning; tables : those of the problem file"""
    parser.add_argument("data", type=Path, metavar="DATA", help=data)
    parser.add_argument("--problem", type=Path, required=True, metavar="PROBLEM.toml", help=f"problem file: {tables}")
    add_options(parser, results)
    parser.add_argument("--json", type=Path, metavar="FILE.json", help="write the complete result to a JSON file")
    parser.add_argument(
        "--report", type=Path, metavar="FILE.html", help="write the complete result, with figures, to one HTML file"
    )


def add_options(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the options of a command with results."""
    parser.add_argument("--csv", type=Path, metavar="FILE.csv", help=f"write {what} to a CSV file, with units in the header")
    parser.add_argument("--xlsx", type=Path, metavar="FILE.xlsx", help="write all tables to a workbook; needs openpyxl")
    parser.add_argument("--plot", type=Path, metavar="FILE.png", help="draw the figure (.png, .pdf or .svg); needs matplotlib")
    parser.add_argument("--overwrite", action="store_true", help="replace existing output files")


def check(arguments: argparse.Namespace) -> None:
    """Raise an error before the computation if a result could not be written afterwards."""
    results = [path for path in (getattr(arguments, name, None) for name in _RESULTS) if path is not None]
    pictures = [path for name in ("plot", "ranges") if (path := getattr(arguments, name, None))]
    check_results(results, pictures, arguments.overwrite, draws=bool(getattr(arguments, "report", None)))
    if workbook := getattr(arguments, "xlsx", None):
        _check_workbook(workbook)
    for path in results:
        if path.exists() and any(path.samefile(read) for read in _read_by(arguments) if read.exists()):
            raise OutputError(f"{path}: this command reads it. Give the result another name.")


def check_results(results: Sequence[Path], pictures: Sequence[Path], overwrite: bool, *, draws: bool = False) -> None:
    """Raise an error if results cannot be written. draws : whether another result than `pictures` has figures"""
    _check(results, overwrite)
    for path in pictures:
        matplotlib.form_of(path)
    if pictures or draws:
        try:
            importlib.import_module("matplotlib.figure")
        except ImportError as problem:
            raise OutputError('figures need matplotlib. Install it with pip install "mdrcontact[plot]".') from problem


def _check_workbook(path: Path) -> None:
    if path.suffix.lower() != ".xlsx":
        raise OutputError(f"{path}: the name of a workbook must end in .xlsx.")
    try:
        importlib.import_module("openpyxl")
    except ImportError as problem:
        raise OutputError('workbooks need openpyxl. Install it with pip install "mdrcontact[instruments]".') from problem


def origin(arguments: argparse.Namespace) -> list[str]:
    """Return blocks of a page on the command and the files that it has read."""
    read = {str(path): path.read_bytes() for path in _read_by(arguments) if path.is_file()}
    return report.origin(read, Path(arguments.problem).read_text(encoding="utf-8"), arguments.command)


def _read_by(arguments: argparse.Namespace) -> list[Path]:
    """Return the files that the command reads, by its arguments and its problem file."""
    data, problem = getattr(arguments, "data", []), Path(arguments.problem)
    given = [problem, *(data if isinstance(data, list) else [data])]
    given += named_by(problem).values()
    return [path for one in given for path in ([p for p in one.iterdir() if _may_be_data(p)] if one.is_dir() else [one])]


def named_by(problem: Path) -> dict[str, Path]:
    """Return the files that a problem file names, by their names there."""
    with suppress(ProblemError):  # reported where it is read
        return {name: problem.parent / name for name in _named_in(parse_file(problem))}
    return {}


def first(path: Path | None) -> tuple[str, dict[str, Path]]:
    """Return the text of a problem file that a page shows first, and the files that it may open; of data these alone."""
    if path is None:
        return "", {}
    if not path.is_file():
        raise ProblemError(f"{path}: there is no such file. Name a problem file, or a file of measurements.")
    if path.suffix.lower() != ".toml":
        return "", {path.name: path}
    try:
        return text_of(path), named_by(path)
    except ProblemError as problem:
        raise ProblemError(f"{path}: {problem}") from problem


def _named_in(table: Mapping[str, Any]) -> Iterator[str]:
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _named_in(value)
        elif key in _NAMES and isinstance(value, str):
            yield value


def _check(paths: Sequence[Path], overwrite: bool) -> None:
    if len({os.path.realpath(path) for path in paths}) < len(paths):
        raise OutputError("two results have the same file name. Give each its own.")
    for path in paths:
        check_place(path)
        if path.exists() and not overwrite:
            raise OutputError(f"{path}: the file exists. Use --overwrite to replace it.")


def write(arguments: argparse.Namespace, **results: Callable[[], Any]) -> None:
    """Write the results whose options are given, and report their files.

    results : by option what makes one: bytes, text, a figure, or a dictionary for JSON
    """
    chosen = {path: make for name, make in results.items() if (path := getattr(arguments, name)) is not None}
    save({path: _content(path, make()) for path, make in chosen.items()}, arguments.overwrite)


def save(contents: Mapping[Path, bytes], overwrite: bool) -> None:
    """Write each file, and report it."""
    _check(list(contents), overwrite)
    if contents:
        print()
    for path, content in contents.items():
        replace(path, content)
        print(f"written: {path}")


def _content(path: Path, result: Any) -> bytes:
    if isinstance(result, bytes):
        return result
    if isinstance(result, dict):
        result = json.dumps(result, indent=2, allow_nan=False) + "\n"
    return result.encode() if isinstance(result, str) else matplotlib.rendered(matplotlib.draw(result), matplotlib.form_of(path))


def _may_be_data(path: Path) -> bool:
    """Whether a file may hold measurements, by its ending, or by its begin where the ending is a number."""
    return path.suffix.lower() in DATA_SUFFIXES or afm.is_of_afm(path)


def data_files(folder: Path) -> list[Path]:
    """Return the files of a folder that may be measurements."""
    paths = sorted(p for p in folder.iterdir() if _may_be_data(p) and p.is_file() and not is_second(p))
    if not paths:
        raise ProblemError(f"{folder}: there is no file of measurements. Its name must end in one of {', '.join(DATA_SUFFIXES)}.")
    return paths
