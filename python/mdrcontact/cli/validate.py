# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact validate`: compare the library with formulas, tables and other programs."""

from __future__ import annotations

import argparse
import textwrap
from pathlib import Path

from .._choices import suggestion
from .._progress import on_terminal
from .._text import aligned, wrapped
from ..errors import MDRError
from ..problem import ProblemError
from ..studies import validate
from ..validation import CHECKS
from ..validation.page import html, markdown, pictures
from . import files
from .table import as_rows

HELP = "compare the library with formulas, tables and other programs"

_WIDTH = 120
"""Characters of a line."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("--full", action="store_true", help="also run long comparisons")
    parser.add_argument("--only", metavar="NAME", help="run only this comparison")
    parser.add_argument("--html", type=Path, metavar="FILE.html", help="write one HTML file with figures")
    parser.add_argument("--markdown", type=Path, metavar="FILE.md", help="write a page of the guide, and its figures to pictures/")
    parser.add_argument("--overwrite", action="store_true", help="replace existing output files")


def run(arguments: argparse.Namespace) -> None:
    """Run, print and write the comparisons."""
    files.check_results([path for path in (arguments.html, arguments.markdown) if path], [], arguments.overwrite)
    names = [check.name for check in CHECKS]
    if arguments.only is not None and arguments.only not in names:
        raise ProblemError(f"--only {arguments.only}: there is no such comparison. {suggestion(arguments.only, names)}")
    with on_terminal() as progress:
        found = validate(full=arguments.full, only=arguments.only, progress=progress)
    print(f"{aligned(wrapped(as_rows(found.tables['comparisons']), _WIDTH))}\n")
    contents = {}
    if arguments.html:
        contents[arguments.html] = html(found.rows).encode()
    if arguments.markdown:
        contents[arguments.markdown] = markdown(found.rows).encode()
        folder = arguments.markdown.parent / "pictures"
        folder.mkdir(exist_ok=True)
        contents.update({folder / name: drawn for name, drawn in pictures(found.rows).items()})
    files.save(contents, arguments.overwrite)
    for note in found.notes.values():
        print(textwrap.fill(note, _WIDTH))
    if found.beyond:
        raise MDRError(f"the deviation exceeds the error of the source: {', '.join(found.beyond)}")
