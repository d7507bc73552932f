# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [friction] of a problem file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._units import FORCE, LENGTH, RATIO, Dimension, shown
from .field import POSITIVE, Field, Range, Table
from .roles import ROLES
from .section import ProblemError, Section

if TYPE_CHECKING:
    from ..instruments.reading.columns import MeasuredTable

_NORMAL = {name: ROLES[name] for name in ("depth", "force")}
_TANGENTIAL = {
    "shift": (LENGTH, ("shift", "s", "tangential displacement", "lateral displacement")),
    "tangential_force": (FORCE, ("tangential force", "lateral force", "t", "ft")),
}
"""Dimension and names of the columns of a path."""
_RINGS, _PATH = Range(20, 1000, True, True), {"path": ()}

KNOWN = Table(
    "friction along a path, or in cycles; without amplitudes the cycles have 1 % to 150 % of the shift at sliding",
    (
        Field("coefficient", "coefficient of friction", RATIO, range=POSITIVE),
        Field("shifts", "amplitudes, ascending", LENGTH, optional=True, range=POSITIVE, many=True),
        Field("tangential_forces", "amplitudes, ascending", FORCE, optional=True, range=POSITIVE, many=True),
        Field("path", "table of a path", optional=True, is_file=True, example='"path.csv"'),
        Field("normal", "prescribed quantity, if the table has both", optional=True, choices=tuple(_NORMAL), when=_PATH),
        Field("tangential", "prescribed quantity, if the table has both", optional=True, choices=tuple(_TANGENTIAL), when=_PATH),
        Field("rings", "rings of interacting springs; default: 100", RATIO, None, True, (), _RINGS, _PATH, step=1),
    ),
    "docs/friction.md",
    at_most_one_of=(("shifts", "tangential_forces", "path"),),
)


class SlidingPath(NamedTuple):
    """A path of normal and tangential loading, row by row from initial contact; SI units."""

    file: Path
    name: str
    """"depth" or "force": the prescribed normal quantity"""
    values: NDArray[np.float64]
    along: str
    """"shift" or "tangential_force": the prescribed tangential quantity"""
    along_values: NDArray[np.float64]
    rings: int | None
    """None: 100 if the springs interact"""


class Sliding(NamedTuple):
    """Coefficient of friction, and the amplitudes of cycles or a path; SI units."""

    coefficient: float
    control: str
    """"shift" or "force": what the amplitudes are"""
    amplitudes: tuple[float, ...]
    """ascending; empty if the file gives none"""
    path: SlidingPath | None = None


def read_friction(section: Section) -> Sliding:
    """Return the contents of [friction]."""
    coefficient = section.value("coefficient")
    given = [key for key in KNOWN.at_most_one_of[0] if key in section]
    if len(given) > 1:
        rule = f"{given[0]} and {given[1]} exclude each other"
        raise section.error(given[1], rule, "Keep one of shifts, tangential_forces and path", shows=False)
    if given == ["path"]:
        with section.about("path"):
            return Sliding(coefficient, "shift", (), _read_path(section))
    section.only(("coefficient", "shifts", "tangential_forces"), "cycles without a path")
    if not given:
        return Sliding(coefficient, "shift", ())
    return Sliding(coefficient, "shift" if given[0] == "shifts" else "force", tuple(section.value(given[0])))


def _read_path(section: Section) -> SlidingPath:
    rings = section.value("rings")
    table = section.table("path", "path.csv")
    normal, values = _column(section, table, "normal", _NORMAL)
    along, along_values = _column(section, table, "tangential", _TANGENTIAL)
    # spreadsheets leave empty rows at the end
    last = np.flatnonzero(np.isfinite(values) | np.isfinite(along_values))[-1:] + 1
    values, along_values = (column[: int(last.sum())] for column in (values, along_values))
    for what, column in ((normal, values), (along, along_values)):
        for row in np.flatnonzero(~np.isfinite(column))[:1]:
            raise ProblemError(f"{table.path}: row {row + 1} of the numbers has no {what}. Each row is a step and needs one.")
    for row in np.flatnonzero(values < 0.0)[:1]:
        raise ProblemError(
            f"{table.path}: {normal} = {shown(values[row], _NORMAL[normal][0])} in row {row + 1} of the numbers: it must be at "
            "least 0. Write 0 for separated bodies."
        )
    if not np.any(values > 0.0):
        raise ProblemError(f"{table.path}: the bodies never touch. At least one {normal} must be greater than 0.")
    return SlidingPath(table.path, normal, values, along, along_values, rings)


def _column(
    section: Section, table: MeasuredTable, key: str, kinds: Mapping[str, tuple[Dimension, tuple[str, ...]]]
) -> tuple[str, NDArray[np.float64]]:
    """Return which of two quantities a table prescribes, and its values."""
    there = {kind: [*_titles(table, aliases, dimension)] for kind, (dimension, aliases) in kinds.items()}
    named = [kind for kind in kinds if there[kind]]
    first, second = kinds
    if key not in section and len(named) > 1:
        remedy = f'Choose the prescribed one, as in [{section.path}] {key} = "{first}"'
        raise ProblemError(f"it has both {first} and {second}", remedy, file=str(table.path)).at(section.path, key)
    kind = section.choice(key, kinds, default=named[0] if named else first)
    dimension, aliases = kinds[kind]
    if not there[kind]:
        wanted = kind if key in section else f"{first} or {second}"
        raise ProblemError(
            f'{table.path}: no column is the {wanted}. Give it a title with the unit, as in "{kind} '
            f'[{dimension.example.split()[-1]}]"; {table.those()}.'
        )
    values, _ = table.column(table.find(kind, aliases, dimension), dimension)
    return kind, values


def _titles(table: MeasuredTable, aliases: Sequence[str], dimension: Dimension) -> Iterator[str]:
    """Yield columns with one of these names, except those with the unit of another quantity: t may be a time."""
    for title in table.named(aliases, dimension):
        if title not in table.units or table.unit_of(title, dimension) is not None:
            yield title
