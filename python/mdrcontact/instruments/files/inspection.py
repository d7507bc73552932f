# SPDX-License-Identifier: GPL-3.0-or-later
"""What a file of measurements is, what would be fitted, and a problem file to begin with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._units import SENSITIVITY, STIFFNESS, parse
from ...errors import MDRError
from ...problem.section import ProblemError, Section
from ..fitting.unloading import unloading_parts
from ..reading.afm import is_of_afm
from ..reading.afm_curve import MissingSettings
from ..reading.columns import MeasuredTable, TableOptions, read_tables
from ..reading.formats import Fact
from ..records import Segment
from . import data as measured
from .curves import Curve, curves, fits
from .data_keys import KNOWN
from .record import Cantilever, Record
from .start_file import Size, start_file

Array = NDArray[np.float64]

_CANTILEVER = {"spring_constant": "0.2 N/m", "deflection_sensitivity": "50 nm/V"}
"""Usual ones, to begin with where a file does not say its own."""
_DIMENSIONS = {"spring_constant": STIFFNESS, "deflection_sensitivity": SENSITIVITY}
_FEWEST = 5
"""Stiffnesses that make a record a dynamic one."""
_SOFT = 1e8
"""Force over depth squared below which a body is a gel, a cell or rubber, under a ball [Pa]."""
_APART = 0.05
"""Of the largest force: a record that begins with less begins before contact."""
_WIDEST = 9
"""Columns of a table without titles."""


class Test(NamedTuple):
    """One test of a file."""

    name: str
    along: Array
    """depth, or the height of the piezo [m]"""
    along_name: str
    force: Array
    segments: Sequence[Segment]
    said_by: str
    """source of the segments"""
    facts: Sequence[Fact]


@dataclass(frozen=True)
class Inspection:
    """What is known of a file."""

    notes: list[str]
    """of its format, columns and first test"""
    tests: list[Test]
    kind: str
    problem: str
    """a problem file for `mdrcontact fit`"""


def inspect_file(path: Path) -> Inspection:
    """Reads a file without a problem file; what it cannot be is a `ProblemError` that names its columns."""
    try:
        found, guessed = _curves(path)
        records = [_record(one) for one in found]
    except ProblemError as problem:
        return _of_columns(path, problem)
    tests = [_test(one, record) for one, record in zip(found, records, strict=True)]
    options = _options(path, found[0], records[0], tests[0])
    if records[0].depth is None and not found[0].facts and not guessed:
        guessed = {"spring_constant": _CANTILEVER["spring_constant"]}
    facts = [fact for fact in found[0].facts if fact.name not in guessed]
    tests = [test._replace(facts=facts) for test in tests] if guessed else tests
    notes = [*records[0].notes, *(f"not in the file: {name.replace('_', ' ')}, taken as {v}" for name, v in guessed.items())]
    notes += _further_columns(path, str(options["kind"]))
    size = Size(max(float(np.ptp(test.along)) for test in tests), max(float(np.ptp(test.force)) for test in tests))
    return Inspection(notes, tests, str(options["kind"]), start_file(path.name, options, facts, size, guessed))


def _curves(path: Path) -> tuple[list[Curve], Mapping[str, str]]:
    """The curves of a file, and what is taken for settings of the cantilever that it does not say."""
    section = _section({"kind": "force-depth"})
    with suppress(MissingSettings):
        return curves(section, Cantilever(), path), {}
    # what a file says itself is not to be guessed
    with suppress(MDRError):
        return _guessing(section, path, "spring_constant")
    return _guessing(section, path, *_CANTILEVER)


def _guessing(section: Section, path: Path, *names: str) -> tuple[list[Curve], Mapping[str, str]]:
    numbers = {name: parse(_CANTILEVER[name], _DIMENSIONS[name]) for name in names}
    return curves(section, Cantilever(**numbers), path), {name: _CANTILEVER[name] for name in names}


def _section(table: Mapping[str, object]) -> Section:
    return Section(dict(table), "data", KNOWN)


def _record(one: Curve) -> Record:
    assert one.record is not None
    record = one.record()
    columns = [v for v in (record.depth, record.height, record.force) if v is not None]
    record.keep(np.all([np.isfinite(v) for v in columns], axis=0))
    record.leave_out_strays()
    record.turn_deflection()
    return record


def _test(one: Curve, record: Record) -> Test:
    along = record.height if record.depth is None else record.depth
    assert along is not None
    segments, said_by = record.parts()
    name = "depth" if record.height is None else "height"
    return Test(one.name, along, name, record.force, segments, said_by, one.facts)


def _options(path: Path, one: Curve, record: Record, test: Test) -> dict[str, object]:
    """[data] for a file, from what is in it."""
    is_raw = record.depth is None
    in_time = next((note for note in record.notes if "a test of" in note), "")
    if is_of_afm(path):
        return {"kind": "depth-time" if "creep" in in_time else "force-time" if in_time else "force-depth"}
    unloads = unloading_parts(test.segments, test.force, 0.4)
    if not is_raw and _has_stiffness(path):
        return {"kind": "stiffness-depth", "branch": "loading"} if len(test.segments) > 1 else {"kind": "stiffness-depth"}
    says_ball = any(fact.name == "indenter.radius" for fact in one.facts)
    is_soft = not is_raw and not says_ball and _is_soft(test)
    held = max((s for s in test.segments if s.kind == "hold"), key=lambda s: s.stop - s.start, default=None)
    if is_soft and held is not None and _tables_with(path, "time"):
        creeps = np.ptp(test.along[held.points]) / np.ptp(test.along) > np.ptp(test.force[held.points]) / np.ptp(test.force)
        kind: dict[str, object] = {"kind": "depth-time", "branch": "loading"} if creeps else {"kind": "force-time"}
        begins_apart = abs(test.force[0]) < _APART * np.ptp(test.force)
        return {**kind, "contact_point": "piecewise"} if begins_apart else kind
    if not (is_raw or says_ball or is_soft) and unloads:
        return {"kind": "unloading"}
    return {"kind": "force-depth", "branch": "loading"} if len(test.segments) > 1 else {"kind": "force-depth"}


def _is_soft(test: Test) -> bool:
    """Whether so small a force goes so deep: sharp tips are for bodies that are harder."""
    return float(np.ptp(test.force)) < _SOFT * float(np.ptp(test.along)) ** 2


def _has_stiffness(path: Path) -> bool:
    """Whether a table has stiffnesses beside depths and forces."""
    section = _section({"kind": "stiffness-depth"})
    tables = _tables_with(path, "stiffness")
    return any(np.isfinite(measured.column(section, table, "stiffness").values).sum() >= _FEWEST for table in tables)


def _tables_with(path: Path, role: str) -> list[MeasuredTable]:
    """The tables of tests that have a column of this role, too."""
    section = _section({"kind": "stiffness-depth"})
    return [table for table in read_tables(path) if measured.has(section, table, role) and fits(section, table, "unloading")]


def _further_columns(path: Path, kind: str) -> list[str]:
    """What a kind reads beside depth and force, in the first test of a table."""
    role = "stiffness" if kind == "stiffness-depth" else "time"
    if is_of_afm(path) or kind not in ("stiffness-depth", "force-time", "depth-time"):
        return []
    return [measured.column(_section({"kind": kind}), table, role).described(role) for table in _tables_with(path, role)[:1]]


def _of_columns(path: Path, problem: ProblemError) -> Inspection:
    """A table of another kind, by its columns."""
    try:
        tables = read_tables(path)
    except MDRError:
        tables = _without_titles(path)
        if not tables:
            raise problem from None
    for kind, (_, roles) in measured.TABLES.items():
        section = _section({"kind": kind})
        if all(measured.has(section, tables[0], role) for role in roles):
            notes = [*tables[0].notes, *(measured.column(section, tables[0], role).described(role) for role in roles)]
            return Inspection(notes, [], kind, start_file(path.name, {"kind": kind}, tables[0].facts, Size(1e-6, 0.0)))
    raise ProblemError(f"{problem}. {_columns(tables[0])}")


def _without_titles(path: Path) -> list[MeasuredTable]:
    """The table of a file that has no line of titles; none if it has no table at all."""
    for width in range(2, _WIDEST):
        with suppress(MDRError):
            return read_tables(path, TableOptions(columns=tuple(f"column {i + 1}" for i in range(width))))
    return []


def _columns(table: MeasuredTable) -> str:
    """The columns with their ranges, for a refusal."""
    words = []
    for title, values in zip(table.titles, table.values.T, strict=True):
        finite = values[np.isfinite(values)]
        span = f"{finite.min():.4g} to {finite.max():.4g}" if finite.size else "no numbers"
        words.append(f"{title!r} {span}")
    return f"Its columns are {', '.join(words)}"
