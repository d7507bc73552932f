# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws as tables that other programs read and interpolate linearly."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._boundary import number
from ._choices import nearest
from .errors import InvalidArgumentError

Reals = NDArray[np.float64]
SMALLEST_ERROR, LARGEST_ERROR = 1e-7, 0.1
_INSIDE = np.linspace(0.0, 1.0, 33)[1:-1]
_FIGURES = "%.9g"


class Table(NamedTuple):
    """Content of a table, in its units."""

    description: str
    length: float
    """the unit of length"""
    error: float
    """of F by linear interpolation, relative to the largest |F|"""
    depth: Reals
    force: Reals
    slope: Reals
    radius: Reals
    stiffness: Reals
    energy: Reals
    adhesive: bool


def table_text(law: Any, form: str, error: float, branch: str, length: float, touch: float | None, area: float | None) -> str:
    """See `ContactLaw.table`."""
    if form not in FORMATS:
        raise InvalidArgumentError(f"form = {form!r}: {nearest(form, FORMATS)}")
    if not SMALLEST_ERROR <= number("error", error) <= LARGEST_ERROR:
        raise InvalidArgumentError(f"error = {error:g}: it must lie between {SMALLEST_ERROR:g} and {LARGEST_ERROR:g}")
    if not number("length", length) > 0.0:
        raise InvalidArgumentError(f"length = {length:g}: it must be greater than 0")
    for name, value, its_form in (("touch", touch, "lammps"), ("area", area, "overclosure")):
        if value is not None and form != its_form:
            raise InvalidArgumentError(f"{name} = {value!r}: it belongs to form = {its_form!r}, not to {form!r}. Omit it")
    table = _table(law, error, branch, length)
    if form != "csv" and table.adhesive:
        raise InvalidArgumentError(
            f"form = {form!r}: it has one force at each depth, so it excludes adhesion. Use csv, which has one branch"
        )
    return FORMATS[form](table, touch, area)


def _table(law: Any, error: float, branch: str, length: float) -> Table:
    """The table of as few rows as a pass from the deepest one upwards finds."""
    lowest, highest = law.depth_range
    adhesive = lowest < 0.0 or law.force_range[0] < 0.0
    lowest = (max(lowest, 0.0) if branch == "loading" else lowest) if adhesive else 0.0

    def force(d: Reals) -> Reals:
        return np.asarray(law.force(d, branch))

    largest = float(np.abs(force(np.linspace(lowest, highest, 1001))).max())
    depth = _nodes(force, lowest, highest, 0.9 * error * largest)
    state = law.at_depth(depth, branch)
    columns = (depth, state.force, state.slope, state.radius, state.stiffness, law.energy(depth, branch))
    units = (length, 1.0, 1.0 / length, length, 1.0 / length, length)
    d, F, slope, a, k, U = (_rounded(np.asarray(column) / unit) for column, unit in zip(columns, units, strict=True))
    return Table(law.description, length, _error(force, d * length, F) / largest, d, F, slope, a, k, U, adhesive)


def _rounded(values: Reals) -> Reals:
    """Values rounded as in the printed table."""
    return np.array([float(_FIGURES % value) for value in values])


def _nodes(force: Callable[[Reals], Reals], lowest: float, highest: float, tolerance: float) -> Reals:
    """Depths between which a straight line has at most the error of the tolerance."""
    nodes = [highest]
    while nodes[-1] > lowest:
        far, near = nodes[-1] - lowest, 0.0
        if _deviation(force, nodes[-1] - far, nodes[-1]) > tolerance:
            while far - near > 0.01 * far:
                middle = 0.5 * (near + far)
                if _deviation(force, nodes[-1] - middle, nodes[-1]) > tolerance:
                    far = middle
                else:
                    near = middle
            far = near if near > 0.0 else far
        next_one = nodes[-1] - far
        nodes.append(next_one if next_one - lowest > 1e-9 * (highest - lowest) else lowest)
    return np.array(nodes[::-1])


def _deviation(force: Callable[[Reals], Reals], low: float, high: float) -> float:
    """Return the largest distance of F from its chord."""
    F = force(np.r_[low, low + (high - low) * _INSIDE, high])
    return float(np.abs(F[1:-1] - (F[0] + (F[-1] - F[0]) * _INSIDE)).max())


def _error(force: Callable[[Reals], Reals], depth: Reals, F: Reals) -> float:
    """The largest error of the rows as they are printed, but where rounding puts an end beyond that of the law."""
    low, high = depth[:-1, None], depth[1:, None]
    d = np.minimum((low + (high - low) * np.linspace(0.0, 1.0, 65)).ravel(), depth[-1])
    d = d[(d >= depth[0] + 1e-9 * abs(depth[0])) & (d <= depth[-1] * (1.0 - 1e-9))]
    return float(np.abs(np.interp(d, depth, F) - force(d)).max())


def _about(table: Table, sign: str) -> str:
    """Return the header of a table, in ASCII for old readers."""
    words = " ".join(table.description.replace("µ", "u").split()) or "compiled law"
    unit = "" if table.length == 1.0 else f"; lengths in {table.length:g} of the law's unit"
    error = f"{table.depth.size} rows{unit}; F by linear interpolation has an error of at most {table.error:.1e} of the largest |F|"
    lines = [error, *textwrap.wrap(words.encode("ascii", "replace").decode(), 100)]
    return "".join(f"{sign} {line}\n" for line in lines)


def _rows(columns: tuple[Reals, ...], separator: str, first: int | None = None) -> str:
    lines = [separator.join(_FIGURES % value for value in row) for row in zip(*columns, strict=True)]
    if first is not None:
        lines = [f"{i}{separator}{line}" for i, line in enumerate(lines, first)]
    return "\n".join(lines) + "\n"


def _csv(table: Table, touch: float | None, area: float | None) -> str:
    names = "depth,force,slope,radius,stiffness,energy\n"
    columns = (table.depth, table.force, table.slope, table.radius, table.stiffness, table.energy)
    return _about(table, "#") + names + _rows(columns, ",")


def _lammps(table: Table, touch: float | None, area: float | None) -> str:
    at = _required("touch", touch, "the distance of two centres, or of a bond, at initial contact, in the unit of the table")
    if not at > table.depth[-1]:
        raise InvalidArgumentError(f"touch = {at:g}: it must exceed the largest depth {table.depth[-1]:g}")
    r = _rounded(at - table.depth[::-1])
    head = f"MDRCONTACT\nN {r.size}\n\n"
    return _about(table, "#") + "\n" + head + _rows((r, table.energy[::-1], table.force[::-1]), " ", 1)


def _spring(table: Table, touch: float | None, area: float | None) -> str:
    elongation, pull = -table.depth[::-1], -table.force[::-1]
    far = -elongation[0]
    rows = _rows((np.r_[pull, 0.0] + 0.0, np.r_[elongation, far] + 0.0), ", ")
    return _about(table, "**") + "*SPRING, ELSET=MDRCONTACT, NONLINEAR\n\n" + rows


def _overclosure(table: Table, touch: float | None, area: float | None) -> str:
    each = _required(
        "area", area, "the area of the surface that one contact represents, in the unit of length of the table squared"
    )
    rows = _rows((table.force / each, table.depth), ", ")
    return _about(table, "**") + "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n" + rows


def _required(name: str, value: float | None, meaning: str) -> float:
    if value is None or not number(name, value) > 0.0:
        raise InvalidArgumentError(f"{name} = {value!r}: it must be given and greater than 0, {meaning}")
    return float(value)


FORMATS: dict[str, Callable[[Table, float | None, float | None], str]] = {
    "csv": _csv,
    "lammps": _lammps,
    "spring": _spring,
    "overclosure": _overclosure,
}
