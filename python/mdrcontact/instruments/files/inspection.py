# SPDX-License-Identifier: GPL-3.0-or-later
"""The kind of a file of measurements, the data for a fit, and a problem file to begin with."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._units import FORCE, LENGTH, SENSITIVITY, STIFFNESS, parse, shown
from ...errors import InvalidArgumentError, MDRError
from ...panels import Figure, Line, Panel, along
from ...problem.roles import ROLES
from ...problem.section import ProblemError, Section
from ...problem.toml import parse_file
from .. import schema
from ..fitting.unloading import unloading_parts
from ..reading.afm import is_of_afm
from ..reading.afm_curve import MissingSettings
from ..reading.columns import MeasuredTable, TableOptions, read_tables
from ..reading.formats import Fact
from ..records import Segment, depth_from_height, find_baseline, find_contact_point, find_pull
from ..records.contact_point import METHODS
from . import data as measured
from .curves import Curve, curves, fits
from .data_keys import KNOWN
from .record import Cantilever, Record, first_loading
from .start_file import BERKOVICH, Size, Start

Array = NDArray[np.float64]

_CANTILEVER = {"spring_constant": "0.2 N/m", "deflection_sensitivity": "50 nm/V"}
"""Usual ones, as starting values if a file does not state its own."""
_DIMENSIONS = {"spring_constant": STIFFNESS, "deflection_sensitivity": SENSITIVITY}
_UNITS = (("depth", "nm"), ("height", "nm")), (("force", "uN"), ("deflection", "nm"))
"""Roles that a record has once, and units to begin with if no title states one."""
_THICKNESS = 500e-9
"""Thickness of a film that the file does not describe [m]."""
_OVER_THICKNESS = re.compile(r"(a|radius|contact radius)\s*(/|over|_over_|_per_)\s*(h|t|thickness)", re.IGNORECASE)
_REDUCED = re.compile(r"\s*(e_?r\b|reduced)", re.IGNORECASE)
"""A modulus of body and tip together; E_eff is that of the body."""
_FEWEST = 5
"""Stiffnesses that make a record a dynamic one."""
_SOFT = 1e8
"""Force over depth squared below which a body is a gel, a cell or rubber, under a ball [Pa]."""
_APART = 0.05
"""Fraction of the largest force below which a record begins before contact."""
_FREE_READINGS, _CLEAR = 10, 3.0
"""Fewest readings that determine the force before contact, and standard errors or noises beyond which it is not 0 or not level."""
_MOVED = 0.02
"""Distance of first contact from 0, relative to the depth, that counts as an offset."""
_IN_TIME = "time"
"""Kinds of data in time."""
_PULLS = 0.05
"""Fraction of the largest force below which a pull needs no work of adhesion."""
_WIDEST = 9
"""Columns of a table without titles."""
_DRAWN = 12
"""Tests in a figure."""
_COLOURS = {"loading": 0, "hold": 4, "unloading": 1}


class Given(NamedTuple):
    """Information that a file does not contain."""

    cantilever: Cantilever = Cantilever()
    data: Mapping[str, object] = MappingProxyType({})
    """keys of [data] that describe how to read a table"""

    @property
    def said(self) -> dict[str, str]:
        """[instrument]."""
        values = {name: value for name, value in self.cantilever._asdict().items() if value is not None}
        return {name: shown(value, _DIMENSIONS[name], 6) for name, value in values.items()}


def given_by(path: Path) -> Given:
    """Keys of a problem file that describe how to read a file of measurements."""
    table = parse_file(path)
    try:
        whole = {name: table.get(name, {}) for name in ("data", "instrument")}
        data, tool = Section(whole["data"], "data", KNOWN), Section(whole["instrument"], "instrument", schema.INSTRUMENT)
        return Given(Cantilever(**tool.given(_DIMENSIONS)), {key: data.plain(key) for key in measured.OF_A_TABLE if key in data})
    except ProblemError as problem:
        raise problem.within(path) from problem


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
    """Information about a file."""

    notes: list[str]
    """of its format, columns and first test"""
    tests: list[Test]
    kind: str
    problem: str
    """a problem file for `mdrcontact fit`"""

    def plot(self, title: str = "") -> Figure:
        """Return force over depth or height of the first tests as a figure, coloured by segment.

        Parameters
        ----------
        title : str, optional
            Title of the figure.

        Returns
        -------
        Figure
            The figure.

        Raises
        ------
        InvalidArgumentError
            The file is not a record of an instrument.
        """
        if not self.tests:
            raise InvalidArgumentError(f"kind = {self.kind!r}: only records of instruments have segments. Plot the fit instead.")
        rest = f"{_DRAWN} of {len(self.tests)} tests" if len(self.tests) > _DRAWN else ""
        words = ", ".join(part for part in (title, rest) if part)
        return Figure(words, tuple(map(_panel, self.tests[:_DRAWN])), columns=3)


def _panel(test: Test) -> Panel:
    """Loading below what comes after it; the first segment of each kind has its name."""
    x, length = along(test.along_name, LENGTH, test.along)
    y, newton = along("force F", FORCE, test.force)
    lines, named = [], set[str]()
    for part in sorted(test.segments, key=lambda segment: list(_COLOURS).index(segment.kind)):
        points = slice(max(part.start - 1, 0), part.stop)
        name = "" if part.kind in named else part.kind
        named.add(part.kind)
        lines.append(Line(length.of(test.along[points]), newton.of(test.force[points]), name, _COLOURS[part.kind], width=1.2))
    return Panel(x, y, tuple(lines), test.name)


def inspect_file(path: Path, given: Given | None = None) -> Inspection:
    r"""Identify a file of measurements without a problem file.

    Parameters
    ----------
    path : Path
        The file.
    given : Given, optional
        What the file does not contain: settings of the cantilever, and keys of [data] that state how a table is read.

    Returns
    -------
    Inspection
        Notes, tests, kind of the data, and a problem file for a fit.

    Raises
    ------
    ProblemError
        The file is not a measurement; the message names its columns.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> rows = "".join(f"{10 * i},{i**1.5:.4f}\n" for i in range(40))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder) / "ball.csv"
    ...     _ = path.write_text("depth [nm],load [uN]\n" + rows)
    ...     found = mdr.instruments.inspect_file(path)
    >>> print(found.kind, len(found.tests))
    force-depth 1
    """
    given = given or Given()
    units = _missing_units(path, given)
    given = given._replace(data={**given.data, **({"units": units} if units else {})})
    try:
        found, records, guessed = _curves(path, given)
    except ProblemError as problem:
        return _of_columns(path, given, problem)
    tests = [_test(one, record) for one, record in zip(found, records, strict=True)]
    facts = [fact for fact in found[0].facts if fact.name not in guessed]
    tests = [test._replace(facts=facts) for test in tests] if guessed else tests
    options = {**_options(path, given, found[0], records[0], tests[0]), **given.data}
    depth = _depth(records[0], facts, _with_guesses(given.cantilever, guessed))
    if records[0].depth is None:
        options |= _baseline(depth, records[0].force)
    pull = _pull(depth, records[0]) if options["kind"] == "force-depth" else 0.0
    start = Start(path.name, options, _size(tests), facts, given.said, guessed, ("units",) if units else ())
    start = start._replace(work_of_adhesion=pull / (1.5 * math.pi * start.radius))
    notes = [*records[0].notes, *(f"not in the file: {name.replace('_', ' ')}, taken as {v}" for name, v in guessed.items())]
    notes += [f"not in the file: the unit of {title!r}, taken as {unit}" for title, unit in units.items()]
    return Inspection([*notes, *_further_columns(path, given, str(options["kind"]))], tests, str(options["kind"]), start.text())


def _curves(path: Path, given: Given) -> tuple[list[Curve], list[Record], Mapping[str, str]]:
    """The curves of a file, their records, and the values assumed for settings of the cantilever that it lacks."""
    section = _section(given, "force-depth")
    missing: MDRError | None = None
    # values that a file states are not guessed
    for names in ((), ("spring_constant",), ("deflection_sensitivity",), tuple(_CANTILEVER)):
        guessed = {name: _CANTILEVER[name] for name in names}
        if any(getattr(given.cantilever, name) is not None for name in names):
            continue
        try:
            found = curves(section, _with_guesses(given.cantilever, guessed), path)
            records = [_record(one) for one in found]
        except (MissingSettings, measured.NoCantilever) as problem:
            missing = problem
        except MDRError as problem:
            if not names:
                raise
            missing = missing or problem
        else:
            if records[0].depth is None and given.cantilever.spring_constant is None and not (found[0].facts or guessed):
                guessed = {"spring_constant": _CANTILEVER["spring_constant"]}
            return found, records, guessed
    assert missing is not None
    raise missing


def _with_guesses(cantilever: Cantilever, guessed: Mapping[str, str]) -> Cantilever:
    return cantilever._replace(**{name: parse(text, _DIMENSIONS[name]) for name, text in guessed.items()})


def _missing_units(path: Path, given: Given) -> dict[str, str]:
    """Units to begin with of columns whose titles name a quantity without one."""
    if is_of_afm(path):
        return {}
    section, units = _section(given, "force-depth"), dict[str, str]()
    with suppress(MDRError):
        table = read_tables(path, measured.table_options(section))[0]
        for roles in _UNITS:
            if not any(measured.has(section, table, role) for role, _ in roles) and not measured.has_deflection(section, table):
                named = ((table.named(ROLES[role][1], ROLES[role][0]), unit) for role, unit in roles)
                units |= next(({titles[0]: unit} for titles, unit in named if titles), {})
    return units


def _section(given: Given, kind: str) -> Section:
    return Section({"kind": kind, **given.data}, "data", KNOWN)


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


def _options(path: Path, given: Given, one: Curve, record: Record, test: Test) -> dict[str, object]:
    """[data] for a file, from its content."""
    is_raw = record.depth is None
    in_time = next((note for note in record.notes if "a test of" in note), "")
    if is_of_afm(path):
        return {"kind": "depth-time" if "creep" in in_time else "force-time" if in_time else "force-depth"}
    unloads = unloading_parts(test.segments, test.force, 0.4)
    branch = {"branch": "loading"} if len(test.segments) > 1 else {}
    if not is_raw and _has_stiffness(path, given):
        return {"kind": "stiffness-depth", **branch}
    says_ball = any(fact.name == "indenter.radius" for fact in one.facts)
    is_soft = not is_raw and not says_ball and _is_soft(test)
    held = max((s for s in test.segments if s.kind == "hold"), key=lambda s: s.stop - s.start, default=None)
    if is_soft and held is not None and _tables_with(path, given, "time"):
        creeps = np.ptp(test.along[held.points]) / np.ptp(test.along) > np.ptp(test.force[held.points]) / np.ptp(test.force)
        return {**({"kind": "depth-time", "branch": "loading"} if creeps else {"kind": "force-time"}), **_zero(record, _IN_TIME)}
    if not (is_raw or says_ball or is_soft) and unloads:
        return {"kind": "unloading", **_zero(record, "unloading")}
    return {"kind": "force-depth", **branch, **({} if is_raw else _zero(record, "force-depth"))}


def _zero(record: Record, kind: str) -> dict[str, object]:
    """[data] on the contact point and the baseline of a table of depths, where the force before contact is not 0, or contact does
    not begin at the depth 0."""
    assert record.depth is not None
    part = first_loading(record)
    depth, force = record.depth[part], record.force[part]
    try:
        contact = find_contact_point(depth, force)
        line = find_baseline(depth, force, contact)
    except MDRError:
        return {}
    before = depth[: round(0.8 * contact)]
    # a contact that grows as a power begins slowly, and is no baseline
    if len(before) < _FREE_READINGS or abs(line.tilt) * float(np.ptp(before)) > _CLEAR * line.noise:
        return {}
    level = line.at(np.array([before.mean()]))[0]
    is_off = abs(level) > _CLEAR * line.noise / math.sqrt(len(before))
    if kind == "force-depth":
        return {"contact_point": "fit"} if is_off else {}
    is_moved = kind == _IN_TIME or abs(float(depth[contact])) > _MOVED * float(np.ptp(depth))
    return {**({"contact_point": METHODS[0]} if is_moved or is_off else {}), **({"baseline": "offset"} if is_off else {})}


def _depth(record: Record, facts: Sequence[Fact], cantilever: Cantilever) -> Array:
    """The depth of a record, from any zero."""
    if record.depth is not None:
        return record.depth
    said = next((fact.value for fact in facts if fact.name == "spring_constant"), math.inf)
    assert record.height is not None
    return depth_from_height(record.height, record.force / (cantilever.spring_constant or said), record.sign)


def _size(tests: Sequence[Test]) -> Size:
    """Size of the contact in all tests; a height is the travel of the piezo, most of it without contact."""
    reached = (0.0 if test.along_name == "height" else float(test.along.max()) for test in tests)
    return Size(max(float(np.ptp(t.along)) for t in tests), max(float(np.ptp(t.force)) for t in tests), max(reached))


def _baseline(depth: Array, force: Array) -> dict[str, object]:
    """[data] on the baseline of a record of heights that has too few readings before contact for one."""
    rise = slice(0, int(np.argmax(force)) + 1)
    with suppress(MDRError):
        contact = find_contact_point(depth[rise], force[rise])
        try:
            find_baseline(depth[rise], force[rise], contact)
        except MDRError:
            return {"baseline": "none"}
    return {}


def _pull(depth: Array, record: Record) -> float:
    """The largest pull up to the largest force; 0 where it needs no work of adhesion [N]."""
    rise = slice(0, int(np.argmax(record.force)) + 1)
    force = record.force[rise]
    with suppress(MDRError):
        if record.depth is not None and force.max() < 0.0 and not _zero(record, "force-depth"):
            # in tension from end to end, without a baseline
            return -float(force.min())
        found = find_pull(depth[rise], force)
        if found is not None and found.force > _PULLS * float(np.ptp(record.force)):
            return found.force
    return 0.0


def _is_soft(test: Test) -> bool:
    """Whether so small a force goes so deep: sharp tips are for bodies that are harder."""
    return float(np.ptp(test.force)) < _SOFT * float(np.ptp(test.along)) ** 2


def _has_stiffness(path: Path, given: Given) -> bool:
    """Whether a table has stiffnesses in addition to depths and forces."""
    section = _section(given, "stiffness-depth")
    tables = _tables_with(path, given, "stiffness")
    return any(np.isfinite(measured.column(section, table, "stiffness").values).sum() >= _FEWEST for table in tables)


def _tables_with(path: Path, given: Given, role: str) -> list[MeasuredTable]:
    """The tables of tests that also have a column of this role."""
    section = _section(given, "stiffness-depth")
    tables = read_tables(path, measured.table_options(section))
    return [table for table in tables if measured.has(section, table, role) and fits(section, table, "unloading")]


def _further_columns(path: Path, given: Given, kind: str) -> list[str]:
    """Columns that a kind reads in addition to depth and force, in the first test of a table."""
    role = "stiffness" if kind == "stiffness-depth" else "time"
    if is_of_afm(path) or kind not in ("stiffness-depth", "force-time", "depth-time"):
        return []
    section = _section(given, kind)
    return [measured.column(section, table, role).described(role) for table in _tables_with(path, given, role)[:1]]


def _of_columns(path: Path, given: Given, problem: ProblemError) -> Inspection:
    """A table of another kind, by its columns."""
    try:
        tables = read_tables(path, measured.table_options(_section(given, "force-depth")))
    except MDRError:
        tables = _without_titles(path)
        if not tables:
            raise problem from None
    for kind, (_, roles) in measured.TABLES.items():
        options = _of_roles(_section(given, kind), tables[0], kind, roles)
        if options is not None:
            # in addition to the columns, which the user may have named
            data, notes = measured.read_data(_section(Given(data=options), kind), given.cantilever, tables[0], kind)
            size = Size(_depth_of(kind, data), modulus=_modulus_of(kind, data))
            over = "radius_over_thickness" in options
            marked, thickness = (("thickness",), _THICKNESS) if over else ((), 0.0)
            start = Start(path.name, options, size, tables[0].facts, given.said, marked=marked, thickness=thickness)
            if kind == "modulus-radius":
                title = measured.column(_section(Given(data=options), kind), tables[0], "modulus").title
                start = start._replace(has_tip=_REDUCED.match(title) is not None)
            return Inspection(notes, [], kind, start.text())
    raise ProblemError(
        f'{problem}. {_columns(tables[0])}. Name all with --columns "depth [nm]" "load [mN]", or give a problem file whose [data] '
        "names them with --like"
    )


def _of_roles(section: Section, table: MeasuredTable, kind: str, roles: Sequence[str]) -> dict[str, object] | None:
    """[data] of a table that has the columns of a kind; None where it has not."""
    given = {key: section.plain(key) for key in ("kind", *measured.OF_A_TABLE) if key in section}
    missing = [role for role in roles if not measured.has(section, table, role)]
    if missing == ["radius"] and measured.has(section, table, "area"):
        return given
    ratio = next((title for title in table.titles if _OVER_THICKNESS.fullmatch(title.strip())), None)
    if missing == ["radius"] and ratio is not None:
        return {**given, "radius_over_thickness": ratio, "thickness": shown(_THICKNESS, LENGTH)}
    return None if missing else given


def _modulus_of(kind: str, data: Any) -> float:
    """E_eff in the middle of the readings; 0 if they do not determine it [Pa]."""
    if kind == "modulus-radius":
        return float(np.median(data.y))
    return float(np.median(data.y / (2.0 * data.x))) if kind == "stiffness-radius" else 0.0


def _depth_of(kind: str, data: Any) -> float:
    """Depth of a Berkovich tip at contacts of these radii; for other data the measured depth [m]."""
    return float(np.max(data.x)) if kind == "stiffness-depth" else float(np.max(data.x)) / math.sqrt(BERKOVICH / math.pi)


def _without_titles(path: Path) -> list[MeasuredTable]:
    """The table of a file that has no line of titles; none if it has no table at all."""
    for width in range(2, _WIDEST):
        with suppress(MDRError):
            return read_tables(path, TableOptions(columns=tuple(f"column {i + 1}" for i in range(width))))
    return []


def _columns(table: MeasuredTable) -> str:
    """The columns with their ranges, for an error message."""
    words = []
    for title, values in zip(table.titles, table.values.T, strict=True):
        finite = values[np.isfinite(values)]
        span = f"{finite.min():.4g} to {finite.max():.4g}" if finite.size else "no numbers"
        words.append(f"{title!r} {span}")
    return f"Its columns are {', '.join(words)}"
