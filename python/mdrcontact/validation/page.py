# SPDX-License-Identifier: GPL-3.0-or-later
"""The validation as one HTML file and as a page of the guide."""

from __future__ import annotations

import importlib
import importlib.util
import io
import platform
import re
import unicodedata
from collections import Counter
from collections.abc import Sequence
from importlib import metadata
from typing import Any, NamedTuple

import numpy as np

from .. import __version__
from .._text import html_table
from ..instruments.fitting import report
from ..panels import Axis, Figure, Line, Panel
from ..panels.matplotlib import draw
from . import GROUPS, limits
from .check import Check, Comparison, Group

PROGRAMS = {"scipy": "SciPy", "skfem": "scikit-fem", "tamaas": "tamaas", "ContactMechanics": "ContactMechanics"}
"""Modules of programs of others, and their names; the extra `validate` installs them."""
COMMAND = "mdrcontact validate --full --only"


class Row(NamedTuple):
    """A check and what came out; None where its program is missing or the run is a quick one."""

    check: Check
    found: Comparison | None
    why_not: str = ""
    """why it was not run"""

    @property
    def holds(self) -> bool:
        """Return whether the deviation is within the error of the source; True if nothing was run."""
        return self.found is None or self.found.deviation <= self.check.error

    def cells(self) -> list[str]:
        """Cells of a row of the table."""
        deviation = (
            f"not run: {self.why_not}" if self.found is None else f"{self.found.deviation:.1e}" + ("" if self.holds else " BEYOND")
        )
        one = self.check
        return [one.capability, one.source, deviation, f"{one.error:.0e}", one.whose, f"{COMMAND} {one.name}"]


TITLES = ["quantity", "compared with", "largest deviation", "bound", "origin of the deviation", "command"]


def run(checks: Sequence[Check], full: bool) -> list[Row]:
    """Runs those that can be run."""
    rows = []
    for check in checks:
        if check.needs and not is_installed(check.needs):
            rows.append(Row(check, None, f"{PROGRAMS[check.needs]} is not installed"))
        elif check.is_long and not full:
            rows.append(Row(check, None, "--full"))
        else:
            rows.append(Row(check, check.run()))
    return rows


def is_installed(module: str) -> bool:
    """Return whether a program can be imported."""
    return importlib.util.find_spec(module) is not None


def programs() -> list[str]:
    """Return the versions of the library, of Python and of the installed programs of others."""
    words = [f"mdrcontact {__version__}", f"Python {platform.python_version()}"]
    for module, name in {"numpy": "NumPy", **PROGRAMS}.items():
        try:
            words.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            words += [f"{name} of unknown version"] * is_installed(module)
    return words


def counted(rows: Sequence[Row]) -> list[str]:
    """Return the number of comparisons that did not run with the reasons, if any, and last the number of those that hold."""
    were_run = [row for row in rows if row.found is not None]
    reasons = Counter(row.why_not for row in rows if row.found is None)
    left = [f"{len(rows) - len(were_run)} of {len(rows)} not run: {', '.join(f'{n} ({why})' for why, n in reasons.items())}"]
    return left * bool(reasons) + [f"{sum(row.holds for row in were_run)} of {len(were_run)} within their bounds"]


def sections(rows: Sequence[Row]) -> list[tuple[Group, list[Row]]]:
    """The rows by capability."""
    found = [(group, [row for row in rows if row.check in group.checks]) for group in GROUPS]
    return [(group, held) for group, held in found if held]


def html(rows: Sequence[Row]) -> str:
    """The page, with a picture of each comparison where matplotlib is installed."""
    blocks = []
    for group, held in sections(rows):
        blocks.append(report.heading(group.title))
        if is_installed("matplotlib") and any(row.found for row in held):
            blocks.append(report.picture(figure(held), group.title))
        blocks.append(html_table([TITLES, *(row.cells() for row in held)]))
    blocks += [report.paragraph(f"{words}.") for words in (f"Programs: {', '.join(programs())}", *counted(rows))]
    for title, table in limits.tables():
        blocks += [report.heading(title), html_table(table)]
    return report.page("Validation", blocks)


def pictures(rows: Sequence[Row]) -> dict[str, bytes]:
    """The pictures of the page of the guide, by the names of their files; none without matplotlib."""
    if not is_installed("matplotlib"):
        return {}
    image: Any = importlib.import_module("PIL.Image")
    drawn = {}
    for group, held in sections(rows):
        if any(row.found for row in held):
            whole, small = io.BytesIO(), io.BytesIO()
            draw(figure(held)).savefig(whole, format="png", dpi=75)
            image.open(whole).convert("RGB").quantize(32).save(small, "png", optimize=True)
            drawn[f"validation_{group.name}.png"] = small.getvalue()
    return drawn


CAPTION = "*A panel for each row of the table below. Circles: reference. Crosses: mdrcontact. Deviation: the largest one.*"
"""Below each picture of the page of the guide."""


_WORK = re.compile(r"(?P<author>[A-Z]\w+)(?:, [A-Z]\w+| et al\.)* (?P<year>\d{4})")


_THEORY = {"theory of plasticity": "plastic"}
"""Pages of theory whose section 10 describes finite elements."""


def cited(source: str) -> str:
    """Link each work of a source to its entry in the bibliography, and the theory to its page."""

    def linked(found: re.Match[str]) -> str:
        author = unicodedata.normalize("NFKD", found["author"].lower()).encode("ascii", "ignore").decode()
        return f"[{found[0]}](bibliography.md#{author}-{found['year']})"

    text = _WORK.sub(linked, source)
    for words, page in _THEORY.items():
        text = text.replace(words, f"[{words}](theory/{page}.md#10-accuracy)")
    return text


def markdown(rows: Sequence[Row]) -> str:
    """Tables and pictures as a page of the guide."""
    parts = ["# Validation", "", *_opening(rows)]
    for group, some in sections(rows):
        cells = [
            [quantity, cited(source), deviation + _mark(row), *others, f"`{command}`"]
            for row, (quantity, source, deviation, *others, command) in zip(some, (row.cells() for row in some), strict=True)
        ]
        picture = f"![{group.title}: comparison with other sources](pictures/validation_{group.name}.png)<br>{CAPTION}"
        files = sorted({f"`python/{check.run.__module__.replace('.', '/')}.py`" for check in group.checks})
        parts += ["", f"## {group.title}", "", picture, "", *_table([TITLES, *cells]), "", f"Parameters: {', '.join(files)}."]
    for title, table in limits.tables():
        parts += ["", f"## {title}", "", *_table(table)]
    return "\n".join([*parts, ""])


def _opening(rows: Sequence[Row]) -> list[str]:
    """Return the result, what the columns mean, and how to repeat and cite it."""
    *left, held = counted(rows)
    return [
        f"This page compares mdrcontact {__version__} with closed forms, published tables and other programs.",
        "The references share no code with the library. A row names what its reference takes from the library.",
        f"**Result: {held}.** {''.join(f'{words}.' for words in left)}".rstrip(),
        "",
        "* **Largest deviation**: the largest |L - R|/S over all points of the figure, with L of the library and R of the",
        "  reference. S is |R| of the point. A star marks rows in which values pass near zero. Their S is one value for all",
        "  points, such as the largest pressure.",
        "* **Bound**: the deviation that the known error of the reference or of the library explains. The next column names",
        "  this error. `mdrcontact validate` fails if a deviation exceeds its bound.",
        "* **Parameters**: below each table, the files with all input values and reference formulas.",
        "",
        "`mdrcontact validate --full --markdown FILE` writes this page. The command in a row repeats its comparison.",
        '`pip install "mdrcontact[validate]"` installs the other programs. The numbers come from these versions:',
        f"{', '.join(programs())}.",
        "Deviations near 1e-15 are rounding errors and vary with compiler and processor.",
        "",
        "To cite a comparison, cite the library as `CITATION.cff` describes, with its version and the name after `--only`.",
        "The names keep their meaning within a minor version. Sources are in the [bibliography](bibliography.md).",
    ]


def _mark(row: Row) -> str:
    """Return a star if the deviations are relative to one value."""
    return " *" if row.found is not None and np.ndim(row.found.scale) == 0 else ""


def _table(rows: Sequence[Sequence[str]]) -> list[str]:
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return [lines[0], "|" + "---|" * len(rows[0]), *lines[1:]]


_ACROSS = 3
"""Panels side by side."""


def figure(rows: Sequence[Row]) -> Figure:
    """A panel for each row that was run: circles are the reference, crosses the library."""
    panels = tuple(_panel(row, row.found) for row in rows if row.found is not None)
    return Figure("", panels, _ACROSS)


def _panel(row: Row, found: Comparison) -> Panel:
    x, there, here = (np.asarray(values, dtype=float) for values in (found.x, found.there, found.here))
    parts = Line(x, there, colour="pale", dash=-1, marker="o"), Line(x, here, colour=0, dash=-1, marker="x")
    return Panel(
        Axis(f"{found.x_name};  deviation {found.deviation:.0e}"), Axis(""), parts, f"{row.check.capability}\n{row.check.source}"
    )
