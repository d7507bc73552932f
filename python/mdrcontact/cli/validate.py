# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact validate`: the library against formulas, tables and programs of others."""

from __future__ import annotations

import argparse
from pathlib import Path

from .. import _progress
from .._choices import nearest
from .._text import aligned
from ..errors import MDRError
from ..problem import ProblemError
from ..validation import CHECKS
from ..validation.page import TITLES, Row, html, markdown, pictures, programs
from ..validation.page import run as run_checks
from . import files

HELP = "compare the library with formulas, tables and programs of others"
DESCRIPTION = """\
Compares what the library computes with closed forms, printed tables and programs that share nothing with it, and says how far it is
off, whose error that is, and by which command a row is repeated:

    mdrcontact validate                            # some seconds
    mdrcontact validate --full --html validation.html

The programs come with pip install "mdrcontact[validate]"; one that is missing is named. Status 1 if a deviation is
larger than the source's own error explains.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("--full", action="store_true", help="run what takes longer, too")
    parser.add_argument("--only", metavar="NAME", help="run one comparison")
    parser.add_argument("--html", type=Path, metavar="FILE.html", help="write one HTML file, with a picture of each row")
    parser.add_argument("--markdown", type=Path, metavar="FILE.md", help="write a page of the guide, its pictures into pictures/")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")


def run(arguments: argparse.Namespace) -> None:
    """Runs, prints, writes."""
    files.check_results([path for path in (arguments.html, arguments.markdown) if path], [], arguments.overwrite)
    chosen = [check for check in CHECKS if arguments.only in (None, check.name)]
    if not chosen:
        raise ProblemError(f"--only {arguments.only}: {nearest(arguments.only, [check.name for check in CHECKS])}")
    with _progress.bar(len(chosen), "comparisons") as bar:
        rows: list[Row] = []
        for check in chosen:
            rows += run_checks([check], arguments.full)
            bar.update()
    print(aligned([TITLES[:5], *(row.cells()[:5] for row in rows)], left=5))
    print(f"\nprograms: {', '.join(programs())}")
    contents = {}
    if arguments.html:
        contents[arguments.html] = html(rows).encode()
    if arguments.markdown:
        contents[arguments.markdown] = markdown(rows).encode()
        folder = arguments.markdown.parent / "pictures"
        folder.mkdir(exist_ok=True)
        contents.update({folder / name: drawn for name, drawn in pictures(rows).items()})
    files.save(contents, arguments.overwrite)
    beyond = [row.check.name for row in rows if not row.holds]
    if beyond:
        raise MDRError(f"beyond what the source's own error explains: {', '.join(beyond)}")
