# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables [data], [instrument] and [fit] of a problem file for `mdrcontact fit`."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._choices import nearest
from ..fitting import ForceDepth, Free, Instrument, ModulusRadius, StiffnessDepth, StiffnessRadius
from ..fitting.data import Data
from ..fitting.parameters import of_indenter, of_instrument, of_medium
from ..fitting.quantities import dimension_of
from . import indenter as indenters
from . import medium as mediums
from .columns import TableOptions, describe, read_table
from .section import ProblemError, Section
from .toml import parse_file
from .units import COMPLIANCE, FORCE, LENGTH, MODULUS, RATIO, STIFFNESS, WORK_OF_ADHESION, Dimension

_KINDS: Mapping[str, tuple[Callable[..., Data], tuple[str, ...]]] = {
    "force-depth": (ForceDepth, ("depth", "force")),
    "stiffness-depth": (StiffnessDepth, ("depth", "force", "stiffness")),
    "modulus-radius": (ModulusRadius, ("radius", "modulus")),
    "stiffness-radius": (StiffnessRadius, ("radius", "stiffness")),
}
_ROLES: Mapping[str, tuple[Dimension, tuple[str, ...]]] = {
    "depth": (
        LENGTH,
        (
            *("depth", "d", "h", "displacement", "indentation", "indentation depth", "displacement into surface", "pd"),
            *("penetration depth", "penetration"),
        ),
    ),
    "force": (FORCE, ("force", "load", "f", "p", "load on sample", "fn", "normal force")),
    "stiffness": (STIFFNESS, ("stiffness", "contact stiffness", "s", "k", "harmonic contact stiffness")),
    "radius": (LENGTH, ("radius", "contact radius", "a")),
    "modulus": (MODULUS, ("modulus", "effective modulus", "e_eff", "eeff", "er", "e_r", "reduced modulus")),
}
_DATA: Mapping[str, Dimension | None] = {
    "kind": None,
    **dict.fromkeys(_ROLES),
    "radius_over_thickness": None,
    "thickness": LENGTH,
    "nu": None,
    "columns": None,
    "units": None,
    "skip": None,
    "sheet": None,
    "sd": None,
    "relative_sd": None,
    "min_depth": LENGTH,
    "max_depth": LENGTH,
    "min_radius": LENGTH,
    "max_radius": LENGTH,
}
_INSTRUMENT: Mapping[str, Dimension | None] = {
    "work_of_adhesion": WORK_OF_ADHESION,
    "depth_offset": LENGTH,
    "force_offset": FORCE,
    "frame_compliance": COMPLIANCE,
    "indenter": None,
    "contact_depth_factor": None,
    "contact_depth_scale": None,
    "stiffness_factor": None,
    "area_factor": None,
}
_FIT: Mapping[str, Dimension | None] = {
    "free": None,
    "loss": None,
    "loss_scale": None,
    "adhesion_rule": None,
    "max_iterations": None,
    "sd_is_absolute": None,
}


class FitFile(NamedTuple):
    """What a problem file for a fit says."""

    title: str
    indenter: Any
    medium: Any
    instrument: Instrument
    free: dict[str, Free]
    options: dict[str, Any]
    data: Section

    def read_data(self, path: Path) -> tuple[Data, list[str]]:
        """The measured data of one file, and what was understood."""
        return _read_data(self.data, path)


def load_fit_file(path: Path) -> FitFile:
    """Reads a problem file; a fault in it is a `ProblemError` that names the file."""
    try:
        return _read(parse_file(path), path.stem)
    except ProblemError as problem:
        raise ProblemError(f"{path}: {problem}") from problem


def _read(table: dict[str, Any], title: str) -> FitFile:
    tables = ("title", "indenter", "medium", "instrument", "data", "fit", "compute")
    whole = Section(table, "the file", dict.fromkeys(tables))
    for name in ("indenter", "medium", "data", "fit"):
        if name not in table:
            raise ProblemError(f"the table [{name}] is missing: a fit has [indenter], [medium], [data] and [fit]")
    shape = Section(table["indenter"], "indenter", indenters.KNOWN)
    body = mediums.read_medium(Section(table["medium"], "medium", mediums.KNOWN), shape)
    instrument = _read_instrument(Section(table.get("instrument", {}), "instrument", _INSTRUMENT))
    tip = indenters.read_indenter(shape)
    fit = Section(table["fit"], "fit", _FIT)
    names = [*of_indenter(tip).names, *of_medium(body).numbers.names, *of_instrument(instrument).names]
    options: dict[str, Any] = {}
    for key, known in (("loss", ("linear", "huber", "cauchy")), ("adhesion_rule", ("automatic", "paper", "energy"))):
        if key in fit:
            options[key] = fit.choice(key, known)
    if "loss_scale" in fit:
        options["loss_scale"] = fit.number("loss_scale")
    if "max_iterations" in fit:
        options["max_iterations"] = fit.count("max_iterations", 100, 100_000)
    if "sd_is_absolute" in fit:
        options["sd_is_absolute"] = bool(fit.plain("sd_is_absolute"))
    data = Section(table["data"], "data", _DATA)
    data.choice("kind", _KINDS)
    if "title" in whole:
        title = str(whole.plain("title"))
    return FitFile(title, tip, body, instrument, _read_free(fit, names), options, data)


def _read_instrument(section: Section) -> Instrument:
    given: dict[str, Any] = {}
    for key in ("work_of_adhesion", "depth_offset", "force_offset", "frame_compliance"):
        if key in section:
            given[key] = section.quantity(key)
    for key in ("contact_depth_factor", "contact_depth_scale", "stiffness_factor", "area_factor"):
        if key in section:
            given[key] = section.number(key)
    if "indenter" in section:
        given["indenter"] = mediums.read_material(section.child("indenter", mediums.MATERIAL))
    return Instrument(**given)


def _read_free(fit: Section, names: list[str]) -> dict[str, Free]:
    """[fit] free = ["coating.E", ...], or a table [fit.free] with start, lower, upper, prior, prior_sd for each name."""
    given = fit.plain("free") if "free" in fit else None
    if isinstance(given, list) and given and all(isinstance(name, str) for name in given):
        given = {name: {} for name in given}
    if not isinstance(given, dict) or not given:
        raise ProblemError('[fit]: free must name parameters, as in free = ["coating.E"], or be a table [fit.free]')
    free = {}
    for name, entry in given.items():
        known = [n for n in names if n]
        if name not in known:
            raise ProblemError(f"[fit.free]: {name!r} is not a parameter of this problem: {nearest(name, known)}")
        dimension = dimension_of(name)
        keys = ("start", "lower", "upper", "prior", "prior_sd")
        section = Section(entry, f'fit.free."{name}"', dict.fromkeys(keys, dimension if dimension.si else None))
        value = {key: section.quantity(key) if dimension.si else section.number(key) for key in keys if key in section}
        if ("prior" in value) != ("prior_sd" in value):
            raise ProblemError(f"[{section.path}]: prior and prior_sd belong together: give both or none")
        prior = (value["prior"], value["prior_sd"]) if "prior" in value else None
        with section.words():
            free[name] = Free(
                value.get("start"), lower=value.get("lower", -math.inf), upper=value.get("upper", math.inf), prior=prior
            )
    return free


def _table_options(section: Section) -> TableOptions:
    """What [data] says of a table that does not say it itself."""
    columns = section.plain("columns") if "columns" in section else []
    if not isinstance(columns, list) or not all(isinstance(title, str) and title for title in columns):
        raise ProblemError('[data]: columns must be a list of titles, as in columns = ["depth [nm]", "load [mN]"]')
    units = section.plain("units") if "units" in section else {}
    if not isinstance(units, dict) or not all(isinstance(unit, str) for unit in units.values()):
        raise ProblemError('[data]: units must be a table of units by title, as in units = { Depth = "nm" }')
    skip = section.plain("skip") if "skip" in section else 0
    if isinstance(skip, bool) or not isinstance(skip, int) or skip < 0:
        raise ProblemError(f"[data]: skip = {skip!r} is not allowed: it must be a number of lines, at least 0")
    return TableOptions(tuple(columns), units, skip, str(section.plain("sheet")) if "sheet" in section else "")


def _read_data(section: Section, path: Path) -> tuple[Data, list[str]]:
    table = read_table(path, _table_options(section))
    cls, roles = _KINDS[section.choice("kind", _KINDS)]
    found: dict[str, tuple[str, str, NDArray[np.float64]]] = {}
    for role in roles:
        if role == "radius" and "radius_over_thickness" in section:
            title = str(section.plain("radius_over_thickness"))
            ratio, unit = table.column(title, RATIO)
            found[role] = title, "thicknesses", ratio * section.quantity("thickness")
            continue
        dimension, aliases = _ROLES[role]
        chosen = str(section.plain(role)) if role in section else table.find(role, aliases, dimension)
        values, unit = table.column(chosen, dimension)
        found[role] = chosen, unit, values
    options: dict[str, Any] = {"missing": "drop"}
    last = roles[-1]
    if "sd" in section:
        title = str(section.plain("sd"))
        values, unit = table.column(title, _ROLES[last][0])
        found["standard deviation"] = title, unit, values
        options["sd"] = values
    if "relative_sd" in section:
        options["relative_sd"] = section.number("relative_sd")
    if last == "modulus" and "nu" in section:
        factor = 1.0 / (1.0 - section.number("nu") ** 2)
        found[last] = (*found[last][:2], found[last][2] * factor)
        if "sd" in options:
            options["sd"] = options["sd"] * factor
    keep = np.ones(len(table.values), dtype=bool)
    for role in ("depth", "radius"):
        if role in found:
            low = section.quantity(f"min_{role}") if f"min_{role}" in section else -math.inf
            high = section.quantity(f"max_{role}") if f"max_{role}" in section else math.inf
            keep &= ~((found[role][2] < low) | (found[role][2] > high))
    if "sd" in options:
        options["sd"] = options["sd"][keep]
    notes = [*table.notes, *describe(found)]
    if not keep.all():
        notes.append(f"{int(keep.sum())} rows lie between the limits of [data] and are fitted")
    return cls(*(found[role][2][keep] for role in roles), **options), notes
