# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [history] of a problem file: a path in time."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._units import LENGTH, RATIO, TIME
from ..poroelastic import DRAINAGES
from .compute import DIMENSIONS, MOST_POINTS
from .field import POSITIVE, Field, Range, Table
from .roles import ROLES
from .section import ProblemError, Section

_STEP, _RAMP, _FILE = {"path": ("step",)}, {"path": ("ramp",)}, {"path": ("file",)}
_GIVEN = {"path": ("step", "ramp", "triangle", "sine")}

KNOWN = Table(
    "a path in time",
    (
        *(Field(name, f"largest {name}", one, range=POSITIVE, when=_GIVEN) for name, one in DIMENSIONS.items()),
        Field("path", "form of the path", choices=(*_GIVEN["path"], "file")),
        Field("rise_time", "duration of the rise", TIME, range=POSITIVE, when=_RAMP),
        Field("hold_time", "duration of the hold at the largest value", TIME, range=POSITIVE, when=_STEP),
        Field("hold_time", "duration of the hold at the largest value", TIME, None, True, range=POSITIVE, when=_RAMP),
        Field("fall_time", "duration of the fall", TIME, None, True, range=POSITIVE, when=_RAMP),
        Field("duration", "duration of the path", TIME, range=POSITIVE, when={"path": ("triangle", "sine")}),
        Field("points", "number of steps", RATIO, 200, range=Range(1, MOST_POINTS, True, True), step=1, when=_GIVEN),
        Field("file", "table of a path", is_file=True, example='"path.csv"', when=_FILE),
        Field("time", "title of the column: time", optional=True, example='"time [s]"', when=_FILE),
        Field("control", "column of the prescribed quantity", default="depth", choices=tuple(DIMENSIONS), when=_FILE),
        Field(
            "drainage",
            "where the fluid of a gel may leave: on the whole surface, nowhere, or outside the contact",
            None,
            None,
            True,
            tuple(DRAINAGES),
        ),
        Field("retract_to", "depth at the end of the fall, instead of 0", LENGTH, None, True, when=_RAMP),
    ),
    "docs/time.md",
    one_of=(tuple(DIMENSIONS),),
)


class HistoryPath(NamedTuple):
    """The prescribed quantity, "depth", "force" or "radius", and its path in SI units."""

    name: str
    time: NDArray[np.float64]
    values: NDArray[np.float64]
    drainage: str | None = None
    """of a gel"""


def read_history(section: Section) -> HistoryPath:
    """Return the path that [history] describes."""
    drainage = section.value("drainage")
    return _read_path(section)._replace(drainage=drainage)


def _read_path(section: Section) -> HistoryPath:
    kind = section.value("path")
    keys = KNOWN.keys_of("path", kind)
    if kind == "file":
        section.only(keys, 'path = "file"')
        with section.about("file"):
            return _from_file(section)
    given = [name for name in DIMENSIONS if name in section]
    if len(given) != 1:
        key = given[1] if given else "depth"
        rule = f"it needs exactly one of depth, force and radius, the largest value; it has {' and '.join(given) or 'none'}"
        raise section.error(key, rule, 'Write it as in depth = "200 nm"', shows=False)
    name = given[0]
    section.only([key for key in keys if key == name or key not in DIMENSIONS], f"path = {kind!r}")
    largest, points = section.value(name), section.value("points")
    if kind == "step":
        return HistoryPath(name, *_pieces([0.0, section.value("hold_time")], [largest, largest], points))
    if kind == "sine":
        time = np.linspace(0.0, section.value("duration"), points + 1)
        values = largest * np.sin(np.pi * np.linspace(0.0, 1.0, points + 1))
        values[-1] = 0.0
        return HistoryPath(name, time, values)
    if kind == "triangle":
        half = 0.5 * section.value("duration")
        return HistoryPath(name, *_pieces([0.0, half, 2.0 * half], [0.0, largest, 0.0], points))
    times, values_at = [0.0, section.value("rise_time")], [0.0, largest]
    end_of_fall = 0.0
    if "retract_to" in section:
        end_of_fall = section.quantity("retract_to")
        if name != "depth" or "fall_time" not in section or not end_of_fall < largest:
            raise section.error("retract_to", "it must be less than the largest depth", "Give depth and fall_time with it")
    for key, end in (("hold_time", largest), ("fall_time", end_of_fall)):
        if key in section:
            times.append(times[-1] + section.value(key))
            values_at.append(end)
    return HistoryPath(name, *_pieces(times, values_at, points))


def _pieces(times: list[float], values: list[float], points: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return linear pieces. Half of the points are distributed by duration, half equally, so that a short rise has enough."""
    alike = 1.0 / (len(times) - 1)
    steps = [max(1, round(0.5 * points * ((b - a) / times[-1] + alike))) for a, b in pairwise(times)]
    pieces = [np.linspace(a, b, n + 1)[1:] for (a, b), n in zip(pairwise(times), steps, strict=True)]
    time = np.concatenate([[times[0]], *pieces])
    return time, np.interp(time, times, values)


def _from_file(section: Section) -> HistoryPath:
    table = section.table("file", "path.csv")
    control = section.value("control")
    title = str(section.plain("time")) if "time" in section else table.find("time", ROLES["time"][1], TIME)
    with section.about("time" if "time" in section else "file"):
        time, _ = table.column(title, TIME)
    values, _ = table.column(table.find(control, ROLES[control][1], DIMENSIONS[control]), DIMENSIONS[control])
    whole = np.isfinite(time) & np.isfinite(values)
    if not whole.any():
        raise ProblemError(f"{table.path}: no row has both a time and a {control}. Add such rows.")
    return HistoryPath(control, time[whole], values[whole])
