# SPDX-License-Identifier: GPL-3.0-or-later
"""Results into files: all of them or none, and never over an existing file unless the user says so."""

from __future__ import annotations

import argparse
import io
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from .._files import check_place, replace
from ..measurement import afm
from ..problem import ProblemError
from ..problem.cells import SHEETS
from ..problem.toml import parse_file

DATA_SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".hld", *SHEETS, *afm.SUFFIXES)
"""Endings of files that hold measurements."""
_RESULTS = ("csv", "pressure_csv", "plot", "ranges", "json", "report", "npy", "law", "output")
"""Arguments that name a file to be written."""
_NAMES = ("file", "path", "labels")
"""Keys of problem files that name a file to be read."""
FIGURE_FORMATS = ("png", "pdf", "svg")


class OutputError(Exception):
    """A result cannot be written."""


def add_options(parser: argparse.ArgumentParser, what: str) -> None:
    """The options that every command with results has."""
    parser.add_argument("--csv", type=Path, metavar="FILE.csv", help=f"write {what} to a CSV file, units in its header")
    parser.add_argument("--plot", type=Path, metavar="FILE.png", help="draw the figure (.png, .pdf or .svg)")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")


def check(arguments: argparse.Namespace) -> None:
    """Raises before any work is done if a result could not be written afterwards."""
    results = [path for path in (getattr(arguments, name, None) for name in _RESULTS) if path is not None]
    pictures = [path for name in ("plot", "ranges") if (path := getattr(arguments, name, None))]
    check_results(results, pictures, arguments.overwrite, draws=bool(getattr(arguments, "report", None)))
    for path in results:
        if path.exists() and any(path.samefile(read) for read in _read_by(arguments) if read.exists()):
            raise OutputError(f"{path} is what this command reads: give the result another name")


def check_results(results: Sequence[Path], pictures: Sequence[Path], overwrite: bool, *, draws: bool = False) -> None:
    """Raises if results cannot be written, pictures among them, or, if `draws`, within another of them."""
    _check(results, overwrite)
    for path in pictures:
        figure_format(path)
    if pictures or draws:
        try:
            import matplotlib.figure  # noqa: F401
        except ImportError as problem:
            raise OutputError('figures need matplotlib: pip install "mdrcontact[plot]"') from problem


def _read_by(arguments: argparse.Namespace) -> list[Path]:
    """The files that the command line and the problem file name to be read."""
    data, problem = getattr(arguments, "data", []), Path(arguments.problem)
    given = [problem, *(data if isinstance(data, list) else [data])]
    with suppress(ProblemError):  # reported where it is read
        given += [problem.parent / name for name in _named_in(parse_file(problem))]
    return [
        path
        for one in given
        for path in ([p for p in one.iterdir() if p.suffix.lower() in DATA_SUFFIXES] if one.is_dir() else [one])
    ]


def _named_in(table: Mapping[str, Any]) -> Iterator[str]:
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _named_in(value)
        elif key in _NAMES and isinstance(value, str):
            yield value


def _check(paths: Sequence[Path], overwrite: bool) -> None:
    if len({os.path.realpath(path) for path in paths}) < len(paths):
        raise OutputError("two results cannot go to the same file")
    for path in paths:
        check_place(path)
        if path.exists() and not overwrite:
            raise OutputError(f"{path} exists; --overwrite replaces it")


def figure_format(path: Path) -> str:
    """The format that the ending of a figure's file name stands for."""
    suffix = path.suffix.lower().removeprefix(".")
    if suffix not in FIGURE_FORMATS:
        raise OutputError(f"{path}: a figure's name must end in " + ", ".join(f".{name}" for name in FIGURE_FORMATS))
    return suffix


def write(contents: Mapping[Path, bytes], overwrite: bool) -> None:
    """Writes each file, and says so; the command's last act."""
    _check(list(contents), overwrite)
    if contents:
        print()
    for path, content in contents.items():
        replace(path, content)
        print(f"written: {path}")


def rendered(figure: Any, form: str) -> bytes:
    """A matplotlib figure as the content of a file."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format=form, dpi=160)
    return buffer.getvalue()


def data_files(folder: Path) -> list[Path]:
    """The files of a folder that may hold measurements."""
    paths = sorted(p for p in folder.iterdir() if p.suffix.lower() in DATA_SUFFIXES and p.is_file())
    if not paths:
        raise ProblemError(f"{folder}: there is no file that ends in {', '.join(DATA_SUFFIXES)}")
    return paths
