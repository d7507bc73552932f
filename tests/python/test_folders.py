# SPDX-License-Identifier: GPL-3.0-or-later
"""The rooms of src/mdrcontact: which may use which, what their modules are named, and what lies where."""

import re

import pytest
from conftest import ROOT

SOURCE = ROOT / "src" / "mdrcontact"
ROOMS = ["base", "bodies", "solver", "contact", "extensions", "api"]
"""A room may use itself and those before it."""
FOLDERS = {
    "bodies": [{"profile"}, {"material"}, {"body"}],
    "solver": [{"weights"}, {"tension"}, {"line"}, {"medium", "model"}],
    "contact": [{"contact"}, {"inside"}, {"law"}, {"friction"}],
    "extensions": [{"time", "wear", "conduction", "poroelastic", "plastic", "lateral"}, {"adhesion", "fit"}],
}
"""Inside a room, folders and files without a folder: one may use its own group and those before it."""
USE = re.compile(r"^\s*use\s+(mdrcontact_\w+)", re.MULTILINE)
MODULE = re.compile(r"^\s*(?:module|submodule\s*\(\w+\))\s+(mdrcontact\w*)\s*$", re.MULTILINE)
DEFINED = re.compile(r"^\s*type\b[^:(]*(?:\([^)]*\))?[^:(]*::\s*(\w+_t)\s*$", re.MULTILINE)
CASE = re.compile(r"^\s*(?:class|type) is \((\w+)\)", re.MULTILINE)
FILES = {path.relative_to(SOURCE).as_posix(): path.read_text() for path in SOURCE.rglob("*.f90")}
"""Path in src/mdrcontact -> text."""


def room(path: str) -> str:
    return path.split("/")[0]


def folder(path: str) -> str:
    """The room of a file, and where it lies in it if the room has folders of its own."""
    parts = path.removesuffix(".f90").split("/")
    return "/".join(parts[:2]) if parts[0] in FOLDERS else parts[0]


def module(path: str) -> str:
    """A module's name is its path without the room; those of the C layer keep it, for their names are those of the core."""
    parts = path.removesuffix(".f90").split("/")
    return "_".join(["mdrcontact", *parts[0 if parts[0] == "api" else 1 :]])


MODULES = {module(path): path for path in FILES}
USES = [(path, MODULES[name]) for path, text in FILES.items() for name in USE.findall(text)]


def test_six_rooms_and_nothing_else():
    assert sorted(path.name for path in SOURCE.iterdir()) == sorted(ROOMS)
    inside = {name: {place for group in groups for place in group} for name, groups in FOLDERS.items()}
    found = {name: {path.stem for path in (SOURCE / name).iterdir() if path.suffix != ".md"} for name in FOLDERS}
    assert found == inside


def test_a_module_is_named_by_its_path():
    assert len(MODULES) == len(FILES)
    assert {path: MODULE.findall(text) for path, text in FILES.items()} == {path: [module(path)] for path in FILES}


def test_rooms_use_only_those_before_them():
    """Read from all `use` lines. The C layer alone uses an extension that is not named beside another one."""
    assert len(USES) > len(FILES)
    place = {name: i for i, name in enumerate(ROOMS)}
    assert not [(path, used) for path, used in USES if place[room(used)] > place[room(path)]]


def test_folders_of_a_room_use_only_those_before_them():
    rank = {f"{name}/{place}": i for name, groups in FOLDERS.items() for i, group in enumerate(groups) for place in group}
    within = [(path, used) for path, used in USES if room(path) == room(used) in FOLDERS and folder(path) != folder(used)]
    assert within
    assert not [(path, used) for path, used in within if rank[folder(used)] > rank[folder(path)]]
    numerics = "base/numerics/"
    assert not [(path, used) for path, used in USES if used.startswith(numerics) and room(path) == "base" and numerics not in path]


def test_extensions_are_leaves():
    """Adhesion in time and fits use histories; no other extension uses another."""
    pairs = {(folder(path), folder(used)) for path, used in USES if room(path) == room(used) == "extensions"}
    assert {(one, other) for one, other in pairs if one != other} == {
        ("extensions/adhesion", "extensions/time"), ("extensions/fit", "extensions/time")}  # fmt: skip


def test_an_option_leaves_out_all_that_uses_an_extension():
    """In the room api the files whose names begin with that of the extension, as cmake/mdrcontact_extensions.cmake has it."""
    names = {place for group in FOLDERS["extensions"] for place in group}
    options = (ROOT / "cmake" / "mdrcontact_extensions.cmake").read_text()
    assert set(re.findall(r"^option\(MDRCONTACT_(\w+)", options, re.MULTILINE)) == {name.upper() for name in names}
    users = [(path, folder(used).split("/")[1]) for path, used in USES if room(used) == "extensions" != room(path)]
    assert users
    assert not [(path, name) for path, name in users if not re.match(rf"api/{name}[_.]", path)]


def test_types_are_distinguished_in_their_own_folder():
    """A `select type` elsewhere is a question that a procedure of the type should answer; handles of the C layer are its own."""
    home = {name: folder(path) for path, text in FILES.items() for name in DEFINED.findall(text)}
    cases = [(path, name) for path, text in FILES.items() for name in CASE.findall(text) if room(path) != "api"]
    assert cases
    assert not {(path, name) for path, name in cases if home[name] != folder(path)}


def test_unit_tests_lie_as_their_sources_do():
    tests = [path.relative_to(ROOT / "tests" / "unit").parent for path in (ROOT / "tests" / "unit").rglob("test_*.pf")]
    assert tests
    assert not [folder for folder in tests if not (SOURCE / folder).is_dir()]


@pytest.mark.parametrize("name", [*ROOMS, *(f"extensions/{place}" for group in FOLDERS["extensions"] for place in sorted(group))])
def test_a_room_has_its_page(name):
    """At most 30 lines, on the room alone: what it answers, its files, its theory. Every file that it names exists."""
    lines = (SOURCE / name / "README.md").read_text().splitlines()
    assert 5 < len(lines) <= 30
    named = re.findall(r"`([\w/.]+\.(?:f90|c|h|md)|[\w/]+/)`", "\n".join(lines))
    assert named
    there = [path for place in (SOURCE, ROOT / "include", ROOT / "python", ROOT / "tests") for path in place.rglob("*")]
    known = {f"/{path.relative_to(ROOT).as_posix()}" + "/" * path.is_dir() for path in there}
    assert not [path for path in named if not ((ROOT / path).exists() or any(other.endswith(f"/{path}") for other in known))]
    links = re.findall(r"\]\(([^)#:]+)", "\n".join(lines))
    assert not [link for link in links if not (SOURCE / name / link).exists()]
