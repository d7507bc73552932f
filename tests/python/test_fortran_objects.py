# SPDX-License-Identifier: GPL-3.0-or-later
"""Public Fortran procedures, as their sources have them: errors that are their own, and objects that were made."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src" / "mdrcontact"

# What the library calls itself, in a row of checks or to collect something; types of users may define them.
HOOKS = {
    "add_breaks",
    "set",
    "find_kinks",
    "square_integral",
    "panels",
    "chain_at",
    "find_series",
    "key",
    "compliance",
    "coupling",
    "sublayers",
}
HOOKS |= {"conductance", "check_one_disc", "check_radius", "check_steady", "means"}

# Records that programs fill themselves, and what is read from them; no maker, hence nothing to be made.
RECORDS = (
    "parameter_t bond_t contact_warning_t contact_options_t contact_state_t failure_load_t strength_t maximum_t fit_result_t",
    "fit_parameter_t fit_data_t fit_problem_t tangential_state_t rate_state_t law_point_t law_options_t contact_steps_t heat_t",
    "kernel_cache_t solved_t gao_options_t model_options_t conductor_t wear_state_t wear_limit_t error_t wear_past_t control_t",
    "transverse_t surface_t compliance_t scalar_function_t profile_term_t load_t field_t material_t",
)
NOT_OBJECTS = {name for line in RECORDS for name in line.split()}

# Solvers are evaluated in inner loops on profiles of the library's own; their media are looked at by whoever holds them.
OTHER_ARGUMENTS = {"solve", "load", "zeta", "depth_and_force"}


class Procedure(NamedTuple):
    name: str
    file: str
    arguments: list[str]
    body: str

    @property
    def intent_of_error(self) -> str | None:
        found = re.search(r"type\(error_t\), allocatable, intent\((\w+)\) :: error\b", self.body)
        return found and found[1]

    @property
    def made(self) -> str | None:
        """The type of what a maker makes."""
        found = re.search(r"type\((\w+)\), intent\(out\)(?:, target)? :: self\b", self.body)
        return found and found[1]

    def objects(self) -> list[tuple[str, str]]:
        """Dummy arguments that are objects, with their types."""
        found = []
        for kind, attributes, names in re.findall(r"(?:type|class)\((\w+)\)([^:\n]*)::([^\n!]*)", self.body):
            if kind in NOT_OBJECTS or not is_object(kind) or "intent(out)" in attributes or "intent" not in attributes:
                continue
            found += [(name, kind) for name in re.findall(r"(\w+)(?:\(:\))?", names) if name in self.arguments]
        return found


def joined(text: str) -> str:
    return re.sub(r"&\s*\n\s*&?", "", text)


@cache
def modules() -> dict[str, tuple[str, str]]:
    found = {}
    for path in SOURCES.rglob("*.f90"):
        text = path.read_text()
        if (module := re.search(r"^module (\w+)", text, re.M)) is not None:
            found[module[1]] = (str(path.relative_to(SOURCES)), joined(text))
    return found


@cache
def procedures() -> dict[tuple[str, str], Procedure]:
    kinds = r"(?:(?:pure|impure|elemental|recursive) )*(subroutine|function)"
    pattern = rf"^    {kinds} (\w+)\(([^)]*)\)(.*?)^    end (?:subroutine|function) \2\b"
    found = {}
    for module, (file, text) in modules().items():
        for _, name, arguments, body in re.findall(pattern, text, re.M | re.S):
            found[module, name] = Procedure(name, file, [a.strip() for a in arguments.split(",")], body)
    return found


def exported() -> dict[str, str]:
    """Names of the facade, and their modules."""
    facade = joined((ROOT / "src" / "mdrcontact.f90").read_text())
    found = {}
    for module, names in re.findall(r"^    use (\w+), only: (.*)", facade, re.M):
        found |= {name.split("=>")[-1].strip(): module for name in names.split(",")}
    return found


def behind(module: str, name: str) -> list[Procedure]:
    """The procedure of a name, or those of a generic one."""
    if (module, name) in procedures():
        return [procedures()[module, name]]
    text = modules()[module][1]
    generic = re.search(rf"^    interface {name}\n(.*?)end interface", text, re.M | re.S)
    names = set(re.findall(r"\w+", generic[1])) if generic else set()
    return [procedure for (_, own), procedure in procedures().items() if own in names]


def bound(module: str, kind: str) -> list[tuple[str, Procedure]]:
    """Type-bound procedures and their names."""
    text = modules()[module][1]
    body = re.search(rf"^    type(?:, [^:\n]*?)? *:: *{kind}\n(.*?)^    end type", text, re.M | re.S)
    if body is None or "\n    contains\n" not in body[1]:
        return []
    found = []
    for names in re.findall(r"^ *procedure(?:, [^:\n]*)? *:: (.*)", body[1].split("\n    contains\n")[1], re.M):
        for name in names.split("!")[0].split(","):
            short, _, own = (part.strip() for part in name.partition("=>"))
            if (module, own or short) in procedures():
                found.append((short, procedures()[module, own or short]))
    return found


def public() -> list[tuple[str, Procedure]]:
    found = []
    for name, module in exported().items():
        if name.endswith("_t"):
            found += [(f"{name}%{short}", procedure) for short, procedure in bound(module, name)]
        else:
            found += [(name, procedure) for procedure in behind(module, name)]
    return found


def makers() -> list[Procedure]:
    """Those of objects that contain whether they were made."""
    return [p for (_, name), p in procedures().items() if name.startswith("new_") and is_object(p.made)]


@cache
def types() -> dict[str, tuple[str | None, str]]:
    """Types, what they extend, and their text."""
    found = {}
    for _, text in modules().values():
        for attributes, name, body in re.findall(r"^    type((?:, [^:\n]*?)?) *:: *(\w+)\n(.*?)^    end type", text, re.M | re.S):
            parent = re.search(r"extends\((\w+)\)", attributes)
            found[name] = (parent and parent[1], body)
    return found


def is_object(name: str | None) -> bool:
    """Whether a type, or one that it extends, contains whether it was made."""
    while name is not None and name in types():
        name, body = types()[name]
        if re.search(r"^ *logical(?:, public)? :: is_made", body, re.M):
            return True
    return False


def test_the_sources_are_read():
    names = [name for name, _ in public()]
    assert len(names) > 300
    assert {"new_contact", "contact_t%at_depth", "modulus_values", "wear_history_t%restore"} <= set(names)
    assert len(makers()) > 60


@pytest.mark.parametrize(
    ("name", "procedure"), [(n, p) for n, p in public() if p.intent_of_error and n.split("%")[-1] not in HOOKS]
)
def test_an_error_is_that_of_the_call(name, procedure):
    assert procedure.intent_of_error == "out", f"{name} in {procedure.file}: an earlier error would be taken for its own"


@pytest.mark.parametrize(
    ("name", "procedure"),
    [(n, p) for n, p in public() if p.intent_of_error and p.objects() and n.split("%")[-1] not in HOOKS],
)
def test_objects_that_were_never_made_are_reported(name, procedure):
    for argument, kind in procedure.objects():
        if argument != "self" and name.split("%")[-1] in OTHER_ARGUMENTS and "%" in name:
            continue
        looks = re.search(rf"check_made\(error, \"\w+\", (?:all\()?{argument}\b.*%is_(?:made|given\(\))", procedure.body)
        assert looks, f"{name} in {procedure.file}: {argument}, a {kind}, is used though it may never have been made"


@pytest.mark.parametrize("procedure", makers(), ids=lambda procedure: procedure.name)
def test_makers_say_that_they_made(procedure):
    assert "self%is_made = " in procedure.body or "call new_" in procedure.body, f"{procedure.name} in {procedure.file}"
