# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit` of many curves: a folder, or a file with a map."""

from __future__ import annotations

import argparse

from .._progress import on_terminal
from .._text import listed
from ..instruments.files.curves import Curve, first_notes
from ..instruments.files.fit_file import FitFile
from ..studies import many
from . import files, pages
from .table import as_csv, as_text
from .workbook import as_xlsx

_MOST_ROWS = 300
"""Largest number of table rows on the screen."""


def run(arguments: argparse.Namespace, problem: FitFile, curves: list[Curve]) -> None:
    """Fit, print and write the results."""
    print(listed(f"{len(curves)} curves in {arguments.data}; as in", first_notes(curves)))
    with on_terminal() as progress:
        found = many(problem, curves, keep_all=arguments.keep_all, progress=progress)
    if len(curves) < _MOST_ROWS:
        print(as_text(found.tables["curves"], left=1))
    print("\n" + "\n".join(found.notes.values()))
    for words in found.doubts:
        print(f"warning: {words}")
    if "spread" in found.tables:
        print(as_text(found.tables["spread"], left=1))
    files.write(
        arguments,
        csv=lambda: as_csv(found.tables["estimates"]),
        xlsx=lambda: as_xlsx(found, arguments.command),
        json=found.to_dict,
        plot=found.figure,
        report=lambda: pages.many_page(found, files.origin(arguments)),
    )
