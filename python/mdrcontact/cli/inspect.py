# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact inspect`: what a file of measurements is, and what would be fitted."""

from __future__ import annotations

import argparse
from collections import Counter
from pathlib import Path

from .._text import aligned, listed
from .._units import FORCE, LENGTH, Dimension, shown
from ..errors import MDRError
from ..instruments.files.fit_file import fit_file_of_text
from ..instruments.files.inspection import Array, Inspection, Test, inspect_file
from ..instruments.fitting.causes import by_cause
from . import files
from .inspect_figure import inspect_figure

HELP = "say what a file of measurements is, and write a problem file to begin with"

_MOST = 60
"""Tests that are printed."""
_MARKED = "put in yours"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("data", type=Path, metavar="FILE", help="a table, a spreadsheet, or a file of an AFM")
    parser.add_argument("--plot", type=Path, metavar="FILE.png", help="draw the tests and their segments (.png, .pdf or .svg)")
    parser.add_argument("--problem", type=Path, metavar="START.toml", help="write a problem file to begin with")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")


def run(arguments: argparse.Namespace) -> None:
    """Reads, prints, writes."""
    pictures = [arguments.plot] if arguments.plot else []
    files.check_results([*pictures, *([arguments.problem] if arguments.problem else [])], pictures, arguments.overwrite)
    found = inspect_file(arguments.data)
    print(listed(arguments.data, found.notes) + "\n")
    if found.tests:
        print(_table(found.tests) + "\n")
    for fact in found.tests[0].facts if found.tests else ():
        print(f"the file says: {fact}")
    print(_would_be_fitted(arguments.data, found))
    if not arguments.problem:
        print(f"\nA problem file to begin with (--problem writes it):\n\n{found.problem}", end="")
    if not found.tests:
        arguments.plot = None
    files.write(arguments, plot=lambda: inspect_figure(found), problem=lambda: found.problem)


def _table(tests: list[Test]) -> str:
    """One row for each test."""
    rows = [["test", "readings", tests[0].along_name, "force", "segments"]]
    for test in tests[:_MOST]:
        spans = [_span(test.along, LENGTH), _span(test.force, FORCE)]
        counts = Counter(s.kind for s in test.segments)
        kinds = ", ".join(f"{counts[kind]} {kind}" for kind in ("loading", "hold", "unloading") if counts[kind])
        rows.append([test.name, str(len(test.force)), *spans, kinds])
    text = aligned(rows, left=1)
    more = f"\nand {len(tests) - _MOST} more" if len(tests) > _MOST else ""
    return f"{text}{more}\n{tests[0].said_by}"


def _span(values: Array, dimension: Dimension) -> str:
    return f"{shown(float(values.min()), dimension, 4)} to {shown(float(values.max()), dimension, 4)}"


def _would_be_fitted(path: Path, found: Inspection) -> str:
    """What the problem file to begin with makes of the file."""
    lines = [f'would be fitted as kind = "{found.kind}":']
    problem = fit_file_of_text(found.problem)
    warned: list[tuple[str, str]] = []
    for one in problem.curves(path)[:_MOST]:
        try:
            data, notes = one.read()
        except MDRError as refusal:
            lines.append(f"  {one.name}: not: {refusal}")
            continue
        used = [note for note in notes if note.endswith((" used", "are fitted", "in contact")) or "not used" in note]
        lines.append(f"  {one.name}: {len(data)} points" + (f"; {'; '.join(used)}" if used else ""))
        warned += [(one.name, words) for words in data.warnings]
    lines += [f"warning: {words}" for words in by_cause(warned)]
    missing = [line.split("=")[0].strip() for line in found.problem.splitlines() if _MARKED in line]
    lines.append(f"not in the file, guessed in the problem file: {', '.join([*missing, 'the body'])}")
    return "\n".join(lines)
