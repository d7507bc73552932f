# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [data] of a problem file: from a file of measurements to data of a fit."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._units import FORCE, LENGTH, RATIO, VOLTAGE, Dimension, UnitError, is_cyclic, shown
from ...problem.roles import ROLES
from ...problem.section import ProblemError, Section
from ..fitting import (
    DepthTime,
    DynamicStiffness,
    ForceDepth,
    ForceTime,
    ModulusRadius,
    StiffnessDepth,
    StiffnessRadius,
    Unloading,
)
from ..fitting.data import Data
from ..reading.columns import MeasuredTable, TableOptions
from ..reading.formats import Fact
from ..reading.marks import segments_of_marks as marked_segments
from ..records import without_oscillation
from .data_keys import COLUMNS, IN_TIME, KNOWN, RECORDS
from .record import Cantilever, Record, prepare

Array = NDArray[np.float64]


class _Column(NamedTuple):
    """A column of a table: its title, the unit it is in, and its numbers in SI units."""

    title: str
    unit: str
    values: Array
    dimension: Dimension

    def described(self, role: str) -> str:
        """Interpretation of a column: role, title, unit and range."""
        finite = self.values[np.isfinite(self.values)]
        span = " to ".join(shown(float(v), self.dimension) for v in (finite.min(), finite.max())) if finite.size else "no numbers"
        return f"{role} from column {self.title!r}" + (f" in {self.unit}" if self.unit else "") + f": {span}"


_Found = dict[str, _Column]
"""Columns by role."""


def _dynamic_stiffness(omega: Array, radius: Array, loss: Array, storage: Array, **options: Any) -> DynamicStiffness:
    return DynamicStiffness(omega, storage + 1j * loss, radius, **options)


_MAKES: Mapping[str, Callable[..., Data]] = {
    "stiffness-depth": StiffnessDepth,
    "modulus-radius": ModulusRadius,
    "stiffness-radius": StiffnessRadius,
    "dynamic-stiffness": _dynamic_stiffness,
}
TABLES: Mapping[str, tuple[Callable[..., Data], tuple[str, ...]]] = {kind: (_MAKES[kind], roles) for kind, roles in COLUMNS.items()}
"""Kinds whose columns are the data; the others are records of an instrument."""


class NoCantilever(ProblemError):
    """A table has a deflection, and nothing turns it into a force."""


_FEWEST_STEPS, _TURNING = 5, 0.25
"""Steps, and the share of them in the rarer direction, by which rows are in no order."""
OF_A_TABLE = (*ROLES, "columns", "units", "skip", "sheet", "leave_out", "decimal", "sd")
"""Keys that describe how to read a table."""


def check(section: Section) -> None:
    """Raise an error for keys that do not belong to the kind of data."""
    kind = section.value("kind")
    section.only(KNOWN.keys_of("kind", kind), f"kind = {kind!r}")
    for group in KNOWN.at_most_one_of:
        if len(given := [key for key in group if key in section]) > 1:
            rule = f"{given[0]} and {given[1]}: both are the same quantity"
            raise section.error(given[1], rule, "Keep one of them", shows=False)
    if "time" in section and kind in RECORDS and kind not in IN_TIME and "drift" not in section:
        rule = f"kind = {kind!r} reads a time for drift alone"
        raise section.error("time", rule, "Give drift, or leave time out", shows=False)
    if "thickness" in section and "radius_over_thickness" not in section:
        rule = "thickness goes with radius_over_thickness, the column that counts in thicknesses"
        raise section.error("thickness", rule, shows=False)


def read_data(section: Section, cantilever: Cantilever, table: MeasuredTable, kind: str) -> tuple[Data, list[str]]:
    """The data of one table, with notes on how it was interpreted."""
    if kind not in RECORDS:
        return _read_columns(section, table, kind)
    try:
        record = record_of(section, cantilever, table, kind)
        return data_of(section, _with_facts(cantilever, table.facts), record, kind)
    except ProblemError as problem:
        raise problem if str(problem).startswith((str(table.path), "[")) else problem.within(table.path) from problem


def table_options(section: Section) -> TableOptions:
    """Properties of a table that [data] states and the table does not contain."""
    columns = section.plain("columns", [])
    if not isinstance(columns, list) or not all(isinstance(title, str) and title for title in columns):
        remedy = 'Write it as in columns = ["depth [nm]", "load [mN]"]'
        raise section.error("columns", "it must be a list of titles", remedy)
    units = section.plain("units", {})
    if not isinstance(units, dict) or not all(isinstance(unit, str) for unit in units.values()):
        remedy = 'Write it as in units = { Depth = "nm" }'
        raise section.error("units", "it must be a table of units by title", remedy)
    skip = section.plain("skip", 0)
    if isinstance(skip, bool) or not isinstance(skip, int) or skip < 0:
        raise section.error("skip", "it must be a number of lines, at least 0")
    sheet = str(section.plain("sheet", ""))
    decimal = section.value("decimal") or ""
    return TableOptions(tuple(columns), units, skip, sheet, decimal)


def column(section: Section, table: MeasuredTable, role: str) -> _Column:
    dimension, aliases = ROLES[role]
    if role in section:
        title = str(section.plain(role))
    elif role == "force" and _is_deflection_in(table, FORCE) and not _is_found(table, role):
        # of a calibrated cantilever
        title = table.find("deflection", ROLES["deflection"][1], FORCE)
    else:
        title = table.find(role, aliases, dimension)
    with section.about(role):
        values, unit = table.column(title, dimension)
    return _Column(title, unit, values, dimension)


def has(section: Section, table: MeasuredTable, role: str) -> bool:
    """Whether a column is named, or can be found, for a role."""
    return role in section or _is_found(table, role) or role == "force" and _is_deflection_in(table, FORCE)


def _is_found(table: MeasuredTable, role: str) -> bool:
    try:
        table.find(role, ROLES[role][1], ROLES[role][0])
    except ProblemError:
        return False
    return True


def _is_deflection_in(table: MeasuredTable, dimension: Dimension) -> bool:
    """Whether a column is a deflection, in units of this dimension."""
    try:
        table.find("deflection", ROLES["deflection"][1], dimension)
    except ProblemError:
        return False
    return True


def _sd(section: Section, table: MeasuredTable, role: str, found: _Found) -> Array | None:
    if "sd" not in section:
        return None
    title = str(section.plain("sd"))
    with section.about("sd"):
        values, unit = table.column(title, ROLES[role][0])
    found["standard deviation"] = _Column(title, unit, values, ROLES[role][0])
    return values


def _between(section: Section, values: Mapping[str, Array]) -> NDArray[np.bool_]:
    """Mask of the points between the limits of [data]; at least one."""
    keep = np.ones(len(next(iter(values.values()))), dtype=bool)
    for role in ("depth", "radius"):
        if role in values:
            low = section.quantity(f"min_{role}", -math.inf)
            high = section.quantity(f"max_{role}", math.inf)
            keep &= ~((values[role] < low) | (values[role] > high))
            if not keep.any():
                ends = " to ".join(shown(float(v), LENGTH) for v in (np.nanmin(values[role]), np.nanmax(values[role])))
                key = f"min_{role}" if not (values[role] >= low).any() else f"max_{role}"
                rule = f"no reading lies between min_{role} and max_{role}: the {role} runs from {ends}"
                raise section.error(key, rule, "Check the units", shows=False)
    return keep


def _read_columns(section: Section, table: MeasuredTable, kind: str) -> tuple[Data, list[str]]:
    cls, roles = TABLES[kind]
    found: _Found = {}
    for role in roles:
        if role == "radius" and "radius_over_thickness" in section:
            title = str(section.plain("radius_over_thickness"))
            with section.about("radius_over_thickness"):
                ratio, _ = table.column(title, RATIO)
            found[role] = _Column(title, "thicknesses", ratio * section.quantity("thickness"), LENGTH)
        elif role == "radius" and "contact_radius" in section:
            radius = np.full(len(found["omega"].values), section.quantity("contact_radius"))
            found[role] = _Column("contact_radius", "m, of [data]", radius, LENGTH)
        elif role == "radius" and ("area" in section or not has(section, table, role) and has(section, table, "area")):
            title, unit, area, _ = column(section, table, "area")
            found[role] = _Column(title, f"{unit}, as sqrt(area/pi)", np.sqrt(np.maximum(area, 0.0) / math.pi), LENGTH)
        else:
            found[role] = column(section, table, role)
        if role == "omega" and is_cyclic(found[role].unit):
            found[role] = found[role]._replace(unit=f"{found[role].unit}, times 2 pi")
    options: dict[str, object] = {"missing": "drop"}
    last = roles[-1]
    sd = _sd(section, table, last, found)
    _check_units(section, table, found)
    factor = 1.0 / (1.0 - section.number("nu") ** 2) if last == "modulus" and "nu" in section else 1.0
    found[last] = found[last]._replace(values=found[last].values * factor)
    keep = _between(section, {role: found[role].values for role in roles})
    notes = [*table.notes, *(column.described(role) for role, column in found.items())]
    if kind == "stiffness-depth":
        keep &= _loading(section, table, found["depth"].values, found["force"].values, found["stiffness"].values, notes)
    if sd is not None:
        options["sd"] = sd[keep] * factor
    options |= section.given(("relative_sd",))
    if "elastic" in section:
        options["elastic"] = section.value("elastic")
    if not keep.all():
        notes.append(f"{int(keep.sum())} of {len(keep)} rows are fitted")
    columns = [found[role].values[keep] for role in roles]
    if last == "stiffness" and _are_results(columns[0]):
        notes.append(
            "the rows are not ordered, as in a table of results with one indent a row: one body is fitted to all of them; "
            'mdrcontact modulus with kind = "stiffness-depth" gives the modulus of each'
        )
    if "oscillation" in section:
        with section.words():
            depth, force, stiffness, keeps = without_oscillation(
                columns[0], columns[1], columns[2], section.quantity("oscillation")
            )
        notes.append("depth, force and stiffness are those at the top of the oscillation (Pharr, Strader, Oliver 2009)")
        if not keeps.all():
            notes.append(f"{int((~keeps).sum())} points are left out: the oscillation is so large that contact is lost")
            if sd is not None:
                options["sd"] = sd[keep][keeps]
        columns = [values[keeps] for values in (depth, force, stiffness)]
    data = cls(*columns, **options)
    data.warnings += table.warnings
    return data, notes


def _are_results(along: Array) -> bool:
    """Whether depths or radii rise and fall at random from row to row; in a record few steps go back."""
    steps = np.diff(along[np.isfinite(along)])
    return len(steps) >= _FEWEST_STEPS and min((steps > 0.0).mean(), (steps < 0.0).mean()) > _TURNING


def _loading(
    section: Section, table: MeasuredTable, depth: Array, force: Array, stiffness: Array, notes: list[str]
) -> NDArray[np.bool_]:
    """Mask of the loading readings of a record with stiffnesses, if the file or [data] branch separates them."""
    if section.value("branch", kind="stiffness-depth") is None and not table.marks:
        return np.ones(len(depth), dtype=bool)
    finite = np.isfinite(depth) & np.isfinite(force)
    record = Record(depth, force, None, None, [])
    record.segments = marked_segments(table.marks, depth, force)
    record.keep(finite)
    segments, words = record.parts()
    loads = np.zeros(int(finite.sum()), dtype=bool)
    for part in segments:
        loads[part.points] = part.kind == "loading"
    keep = np.zeros(len(depth), dtype=bool)
    keep[np.flatnonzero(finite)[loads]] = True
    # in contact the tangent meets force 0 at a depth of at least 0
    contact = keep & (depth > 0.0) & (force > 0.0) & (stiffness * depth > force)
    notes.append(f"{words}; of {len(depth)} readings {int(keep.sum())} load, {int(contact.sum())} of these in contact")
    return contact


def _with_facts(cantilever: Cantilever, facts: Sequence[Fact]) -> Cantilever:
    """The settings of the file where the problem has none."""
    said = {fact.name: fact.value for fact in facts}
    missing = [name for name in cantilever._fields if getattr(cantilever, name) is None]
    return cantilever._replace(**{name: said.get(name) for name in missing})


def record_of(section: Section, cantilever: Cantilever, table: MeasuredTable, kind: str) -> Record:
    """The unchanged content of a table, with the segments that it marks."""
    found: _Found = {}
    depth = height = time = None
    if "height" not in section and has(section, table, "depth") or not has(section, table, "height"):
        found["depth"] = column(section, table, "depth")
        depth = found["depth"].values
    else:
        found["height"] = column(section, table, "height")
        height = found["height"].values
    if depth is None and "force" not in section and has_deflection(section, table):
        force = _force_of_deflection(section, _with_facts(cantilever, table.facts), table, found)
    else:
        found["force"] = column(section, table, "force")
        force = found["force"].values
    if "time" in section or "drift" in section or kind in IN_TIME:
        found["time"] = column(section, table, "time")
        time = found["time"].values
    sd = _sd(section, table, "depth" if kind == "depth-time" else "force", found)
    if "deflection" in section and "deflection" not in found:
        read = ", ".join(f"{role} {one.title!r}" for role, one in found.items())
        rule = f"deflection is not read, as the table has {read}"
        raise section.error("deflection", rule, "Leave it out, or name the height of the piezo instead of a depth", shows=False)
    _check_units(section, table, found)
    _check_cantilever(cantilever, table, found)
    record = Record(
        depth,
        force,
        height,
        time,
        [*table.notes, *(column.described(role) for role, column in found.items())],
        list(table.warnings),
        sd=sd,
    )
    along = height if depth is None else depth
    if table.marks and along is not None:
        record.segments = marked_segments(table.marks, along, force)
    return record


def _check_units(section: Section, table: MeasuredTable, found: _Found) -> None:
    """Raise an error for units of columns that are not read."""
    used = [table.own(one.title) for one in found.values()]
    for title in section.plain("units", {}):
        if table.own(title) not in used:
            rule = f"the column {title!r} of units is not read"
            remedy = f'Leave its unit out, or name its role, as in {next(iter(found))} = "{title}"'
            raise section.error("units", rule, remedy, shows=False)


def _check_cantilever(cantilever: Cantilever, table: MeasuredTable, found: _Found) -> None:
    """Raise an error for settings of the cantilever that no column needs; those that the file also states may be checked."""
    deflection = found.get("deflection")
    if cantilever.deflection_sensitivity is not None and (deflection is None or deflection.dimension is not VOLTAGE):
        rule = f"deflection_sensitivity belongs to a deflection in volts, and the table gives {', '.join(found)}"
        raise ProblemError(rule, "Leave it out", table="instrument", key="deflection_sensitivity")
    said = any(fact.name == "spring_constant" for fact in table.facts)
    if cantilever.spring_constant is not None and not ("height" in found or deflection is not None or said):
        rule = f"spring_constant belongs to a deflection or the height of the piezo, and the table gives {', '.join(found)}"
        raise ProblemError(rule, "Leave it out", table="instrument", key="spring_constant")


def data_of(section: Section, cantilever: Cantilever, record: Record, kind: str) -> tuple[Data, list[str]]:
    """Data of a fit from a record, with notes on how it was interpreted."""
    prepare(section, cantilever, record, kind)
    assert record.depth is not None
    keep = _between(section, {"depth": record.depth})
    if not keep.all():
        record.keep(keep)
        record.notes.append(f"{int(keep.sum())} rows lie between the limits of [data] and are fitted")
    data = _record_data(section, record, kind)
    data.warnings += record.warnings
    data.contact_points, data.also_free = record.contact_points, record.also_free
    data.pulls = {name: pull.force for name, pull in record.pulls.items()}
    if record.parting is not None:
        data.pulls |= {"last rupture": record.parting.rupture_depth, "energy lost": record.parting.energy}
    if isinstance(data, Unloading):
        record.notes += data.found_and_used()
    else:
        record.notes.append(record.counts())
        if record.unused and isinstance(data, ForceDepth):
            data.unused = tuple(np.concatenate(columns) for columns in zip(*record.unused, strict=True))
    return data, record.notes


def _record_data(section: Section, record: Record, kind: str) -> Data:
    assert record.depth is not None
    if kind == "unloading":
        options: dict[str, Any] = {}
        if "elastic" in section:
            options["elastic"] = section.truth("elastic")
        if "upper_part" in section:
            part = section.numbers("upper_part")
            if len(part) != 2:
                raise section.error("upper_part", "it must be two numbers", "Write it as in upper_part = [0.4, 0.98]")
            options["upper_part"] = (part[0], part[1])
        with section.words():
            return Unloading(record.depth, record.force, segments=record.segments, **options)
    relative = section.number("relative_sd") if "relative_sd" in section else None
    if kind in IN_TIME:
        if record.time is None:
            rule = f"kind = {kind!r} needs the time of each reading, which this file does not have"
            raise ProblemError(rule).at(section.path, "kind")
        with section.words():
            if kind == "force-time":
                return ForceTime(record.time, record.depth, record.force, sd=record.sd, relative_sd=relative)
            return DepthTime(record.time, record.force, record.depth, sd=record.sd, relative_sd=relative)
    branch = section.value("branch") or "both"
    with section.words():
        return ForceDepth(
            record.depth, record.force, sd=record.sd, relative_sd=relative, branch=None if branch == "both" else branch
        )


def has_deflection(section: Section, table: MeasuredTable) -> bool:
    """Whether a deflection is named, or can be found."""
    return "deflection" in section or any(_is_deflection_in(table, dimension) for dimension in (LENGTH, VOLTAGE))


def _force_of_deflection(section: Section, cantilever: Cantilever, table: MeasuredTable, found: _Found) -> Array:
    """Spring constant times deflection, which the file contains as a length or a voltage."""
    if cantilever.spring_constant is None:
        rule = 'a deflection becomes a force by the spring constant: give [instrument] spring_constant = "0.2 N/m"'
        raise NoCantilever(rule).at("instrument", "spring_constant")
    try:
        found["deflection"] = column(section, table, "deflection")
        return found["deflection"].values * cantilever.spring_constant
    except (ProblemError, UnitError) as of_length:
        title = str(section.plain("deflection")) if "deflection" in section else None
        try:
            title = title or table.find("deflection", ROLES["deflection"][1], VOLTAGE)
            values, unit = table.column(title, VOLTAGE)
        except (ProblemError, UnitError):
            raise of_length from None
    if cantilever.deflection_sensitivity is None:
        rule = f'the deflection {title!r} is a voltage: give [instrument] deflection_sensitivity = "50 nm/V"'
        raise NoCantilever(rule).at("instrument", "deflection_sensitivity")
    found["deflection"] = _Column(title, unit, values, VOLTAGE)
    return values * cantilever.deflection_sensitivity * cantilever.spring_constant
