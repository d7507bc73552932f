# SPDX-License-Identifier: GPL-3.0-or-later
"""[indenter] file = "tip.toml": a calibrated tip, and its calibration of tip and frame."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from ..errors import MDRError
from .indenter import KNOWN, read_indenter
from .named import Files
from .section import ProblemError, Section
from .toml import parse_named


def _error(rule: str, remedy: str = "") -> ProblemError:
    return ProblemError(f"file {rule}", remedy, table="indenter", key="file")


def with_calibration(table: dict[str, Any], files: Files) -> dict[str, Any]:
    """Return the tables of a problem file with [indenter] file = "tip.toml" replaced by the contents of that file.

    These are the indenter, the frame compliance unless [instrument] has one, and for a fit the joint prior. Moduli against contact
    radii depend on neither tip nor frame: their fits do not take the joint prior.
    """
    indenter = table.get("indenter")
    if not isinstance(indenter, dict) or "file" not in indenter:
        return table
    file = Section(indenter, "indenter", dict.fromkeys(indenter), files).file("file", "a tip", "tip.toml")
    try:
        found = parse_named(file)
    except ProblemError as problem:
        raise _error(str(problem)) from problem
    if not isinstance(found.get("indenter"), dict):
        raise _error(f"{file.path}: it has no table [indenter]", "Write the file with mdrcontact calibrate")
    twice = [key for key in indenter if key not in ("file", "material", "body")]
    if twice:
        raise ProblemError(f"{twice[0]} is also in the file {file.path}", "Keep one", table="indenter", key=twice[0])
    try:
        read_indenter(Section(found["indenter"], "indenter", KNOWN))
    except MDRError:
        # its message would repeat the contents of a file that need not be one of a tip
        rule = f"{file.path}: its table [indenter] is not a tip"
        raise _error(rule, "Copy it into the problem file to see the error") from None
    changed = dict(table)
    changed["indenter"] = {**found["indenter"], **{key: value for key, value in indenter.items() if key != "file"}}
    prior = found.get("calibration")
    data = table.get("data")
    if prior is None or "fit" not in table or isinstance(data, dict) and data.get("kind") == "modulus-radius":
        return changed
    instrument, fit = table.get("instrument", {}), table["fit"]
    # the readers check later whether these are tables and lists
    if not isinstance(fit, dict) or not isinstance(instrument, dict) or not isinstance(fit.get("joint_prior", []), list):
        return changed
    changed["fit"] = {**fit, "joint_prior": [*fit.get("joint_prior", []), prior]}
    with suppress(KeyError, TypeError):
        known = dict(zip(prior["names"], prior["values"], strict=False))
        if "frame_compliance" in known and not any(key.startswith("frame_compliance") for key in instrument):
            changed["instrument"] = {**instrument, "frame_compliance": known["frame_compliance"]}
    return changed
