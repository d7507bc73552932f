# SPDX-License-Identifier: GPL-3.0-or-later
"""The keys of [data] in a problem file for a fit."""

from __future__ import annotations

from collections.abc import Mapping

from ..._units import LENGTH, RATIO, SPEED
from ...problem.field import POISSON, POSITIVE, Field, Range, Table
from ..fitting.unloading import UPPER_PART
from ..reading.numerals import MARKS
from ..records.contact_point import METHODS

IN_TIME = ("force-time", "depth-time")
RECORDS = ("force-depth", "unloading", *IN_TIME)
"""Kinds that are records of an instrument."""
COLUMNS: Mapping[str, tuple[str, ...]] = {
    "stiffness-depth": ("depth", "force", "stiffness"),
    "modulus-radius": ("radius", "modulus"),
    "stiffness-radius": ("radius", "stiffness"),
    "dynamic-stiffness": ("omega", "radius", "loss", "storage"),
}
"""Kinds whose columns are the data, in the order in which they are read."""
KINDS = (*RECORDS, *COLUMNS)
BRANCHES = ("loading", "unloading", "both")

Kinds = Mapping[str, tuple[str, ...]]


def _of(*kinds: str) -> Kinds:
    return {"kind": kinds}


def _with(role: str, *more: str) -> Kinds:
    return _of(*more, *(kind for kind, roles in COLUMNS.items() if role in roles))


_OF_RADIUS = _with("radius")
_WITH_SD = _of(*(kind for kind in KINDS if kind != "unloading"))
_COLUMNS: Mapping[str, tuple[str, Kinds]] = {
    "depth": ("depth", _with("depth", *RECORDS)),
    "force": ("force", _with("force", *RECORDS)),
    "stiffness": ("contact stiffness", _with("stiffness")),
    "radius": ("contact radius", _OF_RADIUS),
    "area": ("projected contact area", _OF_RADIUS),
    "modulus": ("effective modulus", _with("modulus")),
    "height": ("height of the piezo; needs [instrument] spring_constant", _of(*RECORDS)),
    "deflection": ("deflection of the cantilever; needs [instrument] spring_constant", _of(*RECORDS)),
    "time": ("time; force-depth and unloading use it for drift alone", _of(*RECORDS)),
    "omega": ("angular frequency, or frequency in Hz", _with("omega")),
    "storage": ("real part of the dynamic stiffness", _with("storage")),
    "loss": ("imaginary part of the dynamic stiffness", _with("loss")),
}
"""Dimension of the column of each role, and the kinds that have it."""
_LIMITS = {
    "min_depth": ("smallest depth to use", _with("depth", *RECORDS)),
    "max_depth": ("largest depth to use", _with("depth", *RECORDS)),
    "min_radius": ("smallest contact radius to use", _OF_RADIUS),
    "max_radius": ("largest contact radius to use", _OF_RADIUS),
}
_FORMAT = (
    Field("columns", "titles of the columns, if the table has none", optional=True, example='["depth [nm]", "load [mN]"]'),
    Field("units", "units of columns by title, if the table has none", optional=True, example='{ Depth = "nm" }'),
    Field("skip", "number of lines before the table", optional=True, example="3"),
    Field("sheet", "sheet of a spreadsheet, or test of a text file; default: all", optional=True, example='"Test 1"'),
    Field("leave_out", "tests that are not used", optional=True, example='["Test 3"]'),
    Field("decimal", "decimal mark; default: found from the numbers", optional=True, choices=tuple(MARKS)),
)
_PREPARED = (
    Field(
        "branch",
        "branch to use; default: both, or loading if the file has heights",
        optional=True,
        choices=BRANCHES,
        when=_of("force-depth"),
    ),
    Field("branch", "branch to use; default: all rows", optional=True, choices=("loading",), when=_of("stiffness-depth")),
    Field(
        "drift",
        "drift of the depth to subtract; hold: drift measured in the last hold below half of the largest force",
        SPEED,
        optional=True,
        choices=("hold",),
        when=_of(*RECORDS),
    ),
    Field(
        "baseline",
        "part of the force before contact to subtract; default: none, or offset if the file has heights",
        optional=True,
        choices=("tilt", "offset", "none"),
        when=_of(*RECORDS),
    ),
    Field(
        "contact_point",
        "method that finds the contact point; default: given, or fit if the file has heights",
        optional=True,
        choices=(*METHODS, "fit", "given"),
        when=_of("force-depth"),
    ),
    Field(
        "contact_point",
        f"method that finds the contact point; default: given, or {METHODS[0]} if the file has heights",
        optional=True,
        choices=(*METHODS, "given"),
        when=_of(*RECORDS[1:]),
    ),
    Field("before_pop_in", "use only readings before the first pop-in", default=False, is_boolean=True, when=_of("force-depth")),
    Field(
        "upper_part",
        "part of the unloading curve to fit, divided by the largest force",
        RATIO,
        optional=True,
        many=True,
        when=_of("unloading"),
        example=f"{[*UPPER_PART]}",
    ),
    Field(
        "oscillation",
        "rms amplitude of the oscillation; its effect is subtracted",
        LENGTH,
        optional=True,
        range=POSITIVE,
        when=_of("stiffness-depth"),
    ),
    Field(
        "elastic",
        "whether nothing yielded; default: found in the data",
        optional=True,
        is_boolean=True,
        when=_of("stiffness-depth", "unloading"),
    ),
)
KNOWN = Table(
    "how to read the file of measurements; name a column by its title if it is not recognized",
    (
        Field("kind", "kind of data", choices=KINDS),
        *(
            Field(role, f"title of the column: {what}", optional=True, when=when, example=f'"{role}"')
            for role, (what, when) in _COLUMNS.items()
        ),
        Field("radius_over_thickness", "title of the column: a/h", optional=True, when=_OF_RADIUS, example='"a/h"'),
        Field("thickness", "thickness h of a/h", LENGTH, range=POSITIVE, when={"radius_over_thickness": ()}),
        Field("contact_radius", "contact radius of all rows", LENGTH, optional=True, range=POSITIVE, when=_with("omega")),
        Field(
            "nu",
            "Poisson's ratio, if the column is E instead of E/(1 - nu^2)",
            RATIO,
            optional=True,
            range=POISSON,
            when=_with("modulus"),
        ),
        *_FORMAT,
        Field("sd", "title of the column: standard deviation of the last quantity", optional=True, when=_WITH_SD, example='"sd"'),
        Field(
            "relative_sd",
            "standard deviation divided by the value; default: estimated from the misfit",
            RATIO,
            optional=True,
            range=Range(0.0, 1.0),
            when=_WITH_SD,
            example="0.01",
        ),
        *(Field(name, what, LENGTH, optional=True, when=when) for name, (what, when) in _LIMITS.items()),
        *_PREPARED,
    ),
    "docs/read-files.md",
    at_most_one_of=(
        ("depth", "height"),
        ("depth", "deflection"),
        ("force", "deflection"),
        ("radius", "area", "radius_over_thickness", "contact_radius"),
        ("sd", "relative_sd"),
    ),
)
