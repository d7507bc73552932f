# SPDX-License-Identifier: GPL-3.0-or-later
"""The curves of a file of measurements: one of a plain table, all tests of a spreadsheet, a text or a file of an AFM."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..._choices import nearest
from ..._units import STIFFNESS
from ...errors import FileError, MDRError
from ...problem.section import ProblemError, Section
from ..fitting.data import Data
from ..reading.afm import TEXT_SUFFIXES, is_of_afm, read_afm
from ..reading.afm_curve import AfmCurve, MissingSettings
from ..reading.columns import MeasuredTable, read_tables
from ..reading.content import begin_of
from ..reading.formats import Fact
from .data import OF_A_TABLE, TABLES, column, data_of, has, read_data, record_of, table_options
from .data_keys import KNOWN, RECORDS
from .record import Cantilever, Record

_EQUAL = 0.01
"""Largest relative difference between the steps of a height."""


class Curve(NamedTuple):
    """One curve of a file, which is read on demand."""

    name: str
    read: Callable[[], tuple[Data, list[str]]]
    """its data, and notes on how the file was interpreted"""
    place: tuple[float, float] | None = None
    """column and row in a map"""
    position: tuple[float, float] | None = None
    """x and y there [m]"""
    facts: tuple[Fact, ...] = ()
    """the properties of the instrument that the file states"""
    record: Callable[[], Record] | None = None
    """depth or height and force as the file contains them, of records of an instrument"""
    number: int | None = None
    """of the curve, as a file of an AFM counts from 1"""


def curves(section: Section, cantilever: Cantilever, path: Path) -> list[Curve]:
    """The curves of a file: one or more of a table, or of a binary file of an AFM."""
    if not path.exists():
        raise FileError(f"{path}: it cannot be read: there is no such file")
    if is_of_afm(path):
        _check_keys_of_afm(section, path)
        return _afm_curves(section, cantilever, path)
    kind = section.value("kind")
    try:
        tables = _tests(section, read_tables(path, table_options(section)), kind)
    except ProblemError:
        known = _known_to_afmformats(section, cantilever, path) if kind in RECORDS else []
        if len(known) != 1:
            # the message about the table is the more helpful one
            raise
        _check_keys_of_afm(section, path)
        return known
    several = len(tables) > 1
    tables = _without(section, path, tables)
    return [
        Curve(
            f"{path.name} {table.name}" if several else path.name,
            functools.partial(read_data, section, cantilever, table, kind),
            position=_position(table.facts),
            facts=table.facts,
            record=functools.partial(record_of, section, cantilever, table, kind) if kind in RECORDS else None,
        )
        for table in tables
    ]


def first_notes(curves: Iterable[Curve]) -> list[str]:
    """Notes on the interpretation of the first curve that can be read."""
    refusal: MDRError | None = None
    for curve in curves:
        try:
            return [curve.name, *curve.read()[1]]
        except MDRError as of_curve:
            refusal = refusal or of_curve
    assert refusal is not None
    raise refusal


def _position(facts: Iterable[Fact]) -> tuple[float, float] | None:
    """x and y that a header states."""
    said = {fact.name: fact.value for fact in facts}
    return (said["position x"], said["position y"]) if {"position x", "position y"} <= set(said) else None


def _tests(section: Section, tables: list[MeasuredTable], kind: str) -> list[MeasuredTable]:
    """Tables with the columns of this kind of data; sheets with the settings of a method have none."""
    found = [table for table in tables if fits(section, table, kind)]
    if not found and kind in TABLES:
        # results alone: one row for each test is what there is
        found = [table for table in tables if has(section, table, TABLES[kind][1][-1])]
    if not found or kind in RECORDS and not any(has(section, found[0], role) for role in ("depth", "height")):
        column(section, max(tables, key=lambda table: len(table.values)), "depth" if kind in RECORDS else TABLES[kind][1][-1])
    if len(found) < len(tables):
        used = {table.name for table in found}
        others = ", ".join(repr(table.name) for table in tables if table.name not in used)
        found[0].notes.append(f"{len(tables)} tables, {len(found)} used; without the columns that are needed: {others}")
    return found or tables


def _without(section: Section, path: Path, tables: list[MeasuredTable]) -> list[MeasuredTable]:
    """The tests that [data] does not leave out."""
    names = section.plain("leave_out", [])
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise section.error("leave_out", "it must be a list of tests", 'Write it as in leave_out = ["Test 3"]')
    known = [table.name for table in tables]
    for name in names:
        if name not in known:
            raise ProblemError(f"{path}: [data] leave_out: there is no test {name!r}: {nearest(name, known)}").at(
                "data", "leave_out"
            )
    kept = [table for table in tables if table.name not in names]
    if not kept:
        raise ProblemError(f"{path}: [data] leave_out leaves no test").at("data", "leave_out")
    if names:
        kept[0].notes.append(f"{len(tables) - len(kept)} of {len(tables)} tests are left out: {', '.join(names)}")
    return kept


def fits(section: Section, table: MeasuredTable, kind: str) -> bool:
    """Whether a table may be a test; what is missing in the only one of a file is reported where it is read."""
    if not table.name:
        return True
    # one row for each test: results of a program
    if any(title.strip().lower() == "test" for title in table.titles):
        return False
    if kind in RECORDS:
        return any(has(section, table, role) for role in ("depth", "height"))
    return has(section, table, TABLES[kind][1][-1])


def _known_to_afmformats(section: Section, cantilever: Cantilever, path: Path) -> list[Curve]:
    """The curves of a text file of an AFM that is no plain table."""
    if path.suffix.lower() not in TEXT_SUFFIXES or not _may_be_of_afm(path):
        return []
    try:
        return _afm_curves(section, cantilever, path)
    except MissingSettings:
        raise
    except MDRError:
        return []


def _may_be_of_afm(path: Path) -> bool:
    """Whether a text has words, or is the bare table of NT-MDT, whose first column, the height, goes by equal steps."""
    rows = [line.replace(b",", b".").split() for line in begin_of(path, 20_000).splitlines()[:-1]]
    try:
        height = np.array([float(row[0]) for row in rows])
        bare = len({len(row) for row in rows}) == 1 and bool([float(cell) for row in rows for cell in row])
    except (ValueError, IndexError):
        return True
    steps = np.diff(height)
    return not bare or len(steps) > 1 and bool(np.ptp(steps) < _EQUAL * abs(steps.mean()))


def _check_keys_of_afm(section: Section, path: Path) -> None:
    section.only([key for key in KNOWN if key not in OF_A_TABLE], f"a file of an AFM, as {path.name} is, which is no table")


def _afm_curves(section: Section, cantilever: Cantilever, path: Path) -> list[Curve]:
    found = read_afm(path, cantilever.spring_constant, cantilever.deflection_sensitivity)
    names = [path.name] if len(found) == 1 else [f"{path.name} {one.number}" for one in found]
    return [
        Curve(
            name,
            functools.partial(_read_afm_curve, section, path, one),
            one.place,
            one.position,
            _afm_facts(one),
            functools.partial(_afm_record, one),
            one.number,
        )
        for name, one in zip(names, found, strict=True)
    ]


def _afm_facts(one: AfmCurve) -> tuple[Fact, ...]:
    return () if one.spring_constant is None else (Fact("spring_constant", one.spring_constant, STIFFNESS),)


def _read_afm_curve(section: Section, path: Path, one: AfmCurve) -> tuple[Data, list[str]]:
    kind = section.value("kind")
    if kind not in RECORDS:
        rule = f"{path}: an AFM file holds curves of force: kind must be 'force-depth', not {kind!r}"
        raise ProblemError(rule).at("data", "kind")
    return data_of(section, Cantilever(None, one.spring_constant), _afm_record(one), kind)


def _afm_record(one: AfmCurve) -> Record:
    return Record(None, one.force, one.height, one.time, list(one.notes), sign=1, segments=one.segments)
