# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `inspect`: what a file of measurements is, and what would be fitted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from .._units import FORCE, LENGTH, RATIO, Dimension, shown
from ..errors import CancelledError, MDRError
from ..instruments.files.fit_file import fit_file_of_text
from ..instruments.files.inspection import Given, Inspection, Test, given_by, inspect_file
from ..instruments.files.start_file import MARK
from ..instruments.fitting.causes import by_cause
from ..instruments.reading.formats import Fact
from ..panels import Figure
from ..progress import Progress
from .result import Array, Number, Result, Table, in_turn, in_words, study

_MOST = 60
"""Tests that are examined."""


@dataclass(frozen=True, eq=False, kw_only=True)
class InspectResult(Result):
    """Content of a file of measurements. Table: "tests", of records of an instrument."""

    inspection: Inspection
    facts: tuple[Fact, ...]
    """what the file states about the instrument"""
    curves: tuple[str, ...] = ()
    """what would be fitted of each curve, or the reason why not"""
    doubts: tuple[str, ...] = ()
    """about the curves; `warnings` has them too"""
    guessed: tuple[str, ...]
    """what the file does not contain"""
    refusal: MDRError | None = None
    """why no curve would be fitted"""

    def figure(self) -> Figure:
        """Return force over depth or height of the first tests, coloured by segment."""
        return self.inspection.plot(self.title)


@study
def inspect(
    data: str | Path,
    *,
    columns: Sequence[str] = (),
    spring_constant: float | None = None,
    deflection_sensitivity: float | None = None,
    like: str | Path | None = None,
    progress: Progress | None = None,
) -> InspectResult:
    """Identify a file of measurements, and what would be fitted.

    Parameters
    ----------
    data : str or Path
        A table, a spreadsheet, or a file of an AFM.
    columns : sequence of str, optional
        Titles of the columns with their units, of a table that has none.
    spring_constant, deflection_sensitivity : float, optional
        Of the cantilever [N/m], [m/V]; by default those of the file, or usual ones that are marked.
    like : str or Path, optional
        A problem file whose [data] and [instrument] state how the table is read.
    progress : Progress, optional
        Reports each test, and can stop the work between two of them.

    Returns
    -------
    InspectResult
        `inspection`, with the text of a problem file to begin with; `curves`; numbers "tests" and "curves".

    Raises
    ------
    MDRError
        The file cannot be read, or its columns are not those of a measurement.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> from mdrcontact import studies
    >>> rows = "".join(f"{10 * i},{i**1.5:.4f}\\n" for i in range(40))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder) / "ball.csv"
    ...     _ = path.write_text("depth [nm],load [uN]\\n" + rows)
    ...     found = studies.inspect(path)
    >>> found.inspection.kind
    'force-depth'
    >>> found.curves
    ('ball.csv: 40 points; 40 of 40 readings are used',)
    """
    data, progress = Path(data), progress or Progress()
    progress.step(0, None, "file")
    found = inspect_file(data, _given(columns, spring_constant, deflection_sensitivity, like))
    tests, tables, notes = found.tests, dict[str, Table](), dict[str, str]()
    if tests:
        tables["tests"] = in_words(_rows(tests[:_MOST]))
        notes = {"more": f"and {len(tests) - _MOST} more"} if len(tests) > _MOST else {}
        notes["segments"] = tests[0].said_by
    curves: list[str] = []
    doubts: list[str] = []
    refusal = None
    try:
        curves, doubts = _would_be_fitted(data, found, progress)
    except CancelledError:
        raise
    except MDRError as words:
        refusal = words
    missing = [line.split("=")[0].strip() for line in found.problem.splitlines() if MARK in line]
    return InspectResult(
        title=data.name,
        numbers={"tests": Number(len(tests), RATIO), "curves": Number(len(curves), RATIO)},
        notes=notes,
        tables=tables,
        warnings=tuple(doubts),
        inspection=found,
        facts=tuple(tests[0].facts) if tests else (),
        curves=tuple(curves),
        doubts=tuple(doubts),
        guessed=(*dict.fromkeys(missing), "the body"),
        refusal=refusal,
    )


def _given(columns: Sequence[str], spring_constant: float | None, sensitivity: float | None, like: str | Path | None) -> Given:
    """Return what the file does not contain; arguments override the problem file."""
    given = Given() if like is None else given_by(Path(like))
    said = {"spring_constant": spring_constant, "deflection_sensitivity": sensitivity}
    cantilever = given.cantilever._replace(**{name: value for name, value in said.items() if value is not None})
    return Given(cantilever, {**given.data, **({"columns": [*columns]} if columns else {})})


def _rows(tests: Sequence[Test]) -> list[list[str]]:
    """One row for each test, below the titles."""
    rows = [["test", "readings", tests[0].along_name, "force", "segments"]]
    for test in tests:
        spans = [_span(test.along, LENGTH), _span(test.force, FORCE)]
        counts = Counter(s.kind for s in test.segments)
        kinds = ", ".join(f"{counts[kind]} {kind}" for kind in ("loading", "hold", "unloading") if counts[kind])
        rows.append([test.name, str(len(test.force)), *spans, kinds])
    return rows


def _span(values: Array, dimension: Dimension) -> str:
    return f"{shown(float(values.min()), dimension, 4)} to {shown(float(values.max()), dimension, 4)}"


def _would_be_fitted(path: Path, found: Inspection, progress: Progress) -> tuple[list[str], list[str]]:
    """Return how the start file reads each curve, and the warnings about them."""
    lines: list[str] = []
    warned: list[tuple[str, str]] = []
    curves = fit_file_of_text(found.problem).curves(path)[:_MOST]
    for one in in_turn(progress, curves, len(curves), "curves"):
        try:
            data, notes = one.read()
        except MDRError as refusal:
            lines.append(f"{one.name}: not: {refusal}")
            continue
        used = [note for note in notes if note.endswith((" used", "are fitted", "in contact")) or "not used" in note]
        lines.append(f"{one.name}: {len(data)} points" + (f"; {'; '.join(used)}" if used else ""))
        warned += [(one.name, words) for words in data.warnings]
    return lines, by_cause(warned)
