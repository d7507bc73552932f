# SPDX-License-Identifier: GPL-3.0-or-later
"""Which folder of src/mdrcontact may use which, and look into its types."""

import re

from conftest import ROOT

SOURCE = ROOT / "src" / "mdrcontact"
ORDER = [
    {"base", "batch", "cancel", "codes", "error", "file", "gsl", "kinds", "lapack", "padded_text", "version", "words"},
    {"numerics"},
    {"profile"},
    {"material"},
    {"body"},
    {"line", "poroelastic", "tension"},
    {"medium", "model", "weights"},
    {"contact"},
    {"inside"},
    {"law"},
    {"friction"},
    {"time"},
    {"adhesion", "wear", "conduction"},
    {"fit"},
    {"lateral"},
    {"api"},
]
"""Folders, and files without a folder, one place each. A file may use its own place and those before it."""
USE = re.compile(r"^\s*use\s+(mdrcontact_\w+)", re.MULTILINE)
DEFINED = re.compile(r"^\s*type\b[^:(]*(?:\([^)]*\))?[^:(]*::\s*(\w+_t)\s*$", re.MULTILINE)
CASE = re.compile(r"^\s*(?:class|type) is \((\w+)\)", re.MULTILINE)


def folder(path: str) -> str:
    return path.split("/")[0].removesuffix(".f90")


def test_folders_use_only_those_before_them():
    """Read from all `use` lines; a module's name is its path."""
    files = {path.relative_to(SOURCE).as_posix(): path.read_text() for path in SOURCE.rglob("*.f90")}
    modules = {"mdrcontact_" + path.removesuffix(".f90").replace("/", "_"): folder(path) for path in files}
    place = {name: i for i, names in enumerate(ORDER) for name in names}
    uses = [(path, modules[module]) for path, text in files.items() for module in USE.findall(text)]
    assert len(uses) > len(files)
    later = {(path, used) for path, used in uses if place[used] > place[folder(path)]}
    assert not later, "these use a folder that comes after theirs"


def test_types_are_distinguished_in_their_own_folder():
    """A `select type` elsewhere is a question that a procedure of the type should answer; handles of the C layer are its own."""
    files = {path.relative_to(SOURCE).as_posix(): path.read_text() for path in SOURCE.rglob("*.f90")}
    home = {name: folder(path) for path, text in files.items() for name in DEFINED.findall(text)}
    cases = [(path, name) for path, text in files.items() for name in CASE.findall(text) if folder(path) != "api"]
    assert cases
    assert not {(path, name) for path, name in cases if home[name] != folder(path)}
