# SPDX-License-Identifier: GPL-3.0-or-later
"""Which room of python/mdrcontact may import which, and where its public names stand."""

import ast
import functools
import sys
from collections.abc import Iterator
from pathlib import Path

from conftest import PUBLIC, ROOT, run

import mdrcontact as mdr

PACKAGE = ROOT / "python" / "mdrcontact"
ORDER = ("contact", "panels", "problem", "instruments", "studies", "cli", "app")
"""A room imports its own files and the rooms before it. What has none of these names is of the room "contact"."""
BESIDE = ("validation", "interop")
"""These import any room; only `ENTRIES` and themselves import them."""
ENTRIES = {
    "__init__.py": ("instruments",),
    "__main__.py": ("cli",),
    "cli/validate.py": ("validation",),
    "studies/validate.py": ("validation",),
}
"""Files that name a room beyond their own, for its users."""
LATE = {
    ("cli/app.py", "app"),
    ("contact.py", "panels"),
    ("law.py", "panels"),
    ("loop.py", "panels"),
    ("sheared.py", "panels"),
    ("state.py", "panels"),
    ("problem/section.py", "instruments"),
    ("problem/friction.py", "instruments"),
}
"""The command of the page loads it. `plot` of a contact makes a figure.
A path in [history] or [friction] is in a table, which the reader of instruments reads."""


def room(parts: tuple[str, ...]) -> str:
    return parts[0] if parts and parts[0] in (*ORDER, *BESIDE) else "contact"


@functools.cache
def imports(package: Path) -> frozenset[tuple[str, str, bool]]:
    """File, imported room, and whether it is imported when the file is."""
    return frozenset(_imports(package))


def _imports(package: Path) -> Iterator[tuple[str, str, bool]]:
    for path in package.rglob("*.py"):
        file = path.relative_to(package)
        tree = ast.parse(path.read_text(encoding="utf-8"))
        late = {
            id(inner)
            for node in ast.walk(tree)
            if isinstance(node, ast.FunctionDef) or isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
            for inner in ast.walk(node)
        }
        for node in ast.walk(tree):
            for parts in _imported(node, (package.name, *file.parts[:-1])):
                if parts[0] == package.name:
                    yield file.as_posix(), room(parts[1:]), id(node) not in late


def _imported(node: ast.AST, folder: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    if isinstance(node, ast.Import):
        yield from (tuple(alias.name.split(".")) for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        origin = folder[: len(folder) - node.level + 1] if node.level else ()
        origin += tuple(node.module.split(".")) if node.module else ()
        yield from ((*origin, alias.name) for alias in node.names)


def is_allowed(file: str, used: str, at_once: bool) -> bool:
    own = room(tuple(file.split("/")[:-1]))
    if used == own or used in ENTRIES.get(file, ()) or (file, used) in LATE and not at_once:
        return True
    if own in BESIDE:
        return used not in BESIDE
    return used in ORDER and ORDER.index(used) < ORDER.index(own)


def test_rooms_import_only_those_before_them():
    found = imports(PACKAGE)
    assert {(own, used) for own, used, _ in found if own == "instruments/files/fit_file.py"} >= {
        ("instruments/files/fit_file.py", "problem"),
        ("instruments/files/fit_file.py", "contact"),
    }
    assert not {one for one in found if not is_allowed(*one)}


def test_every_exception_is_needed():
    found = imports(PACKAGE)
    assert {(file, used, False) for file, used in LATE} <= found
    assert {(file, used) for file, rooms in ENTRIES.items() for used in rooms} <= {(file, used) for file, used, _ in found}


def test_a_wrong_import_is_found(tmp_path):
    package = tmp_path / "mdrcontact"
    (package / "problem").mkdir(parents=True)
    (package / "problem" / "table.py").write_text("def f():\n    from ..cli import main\nfrom .. import studies, law\n")
    (package / "law.py").write_text("import mdrcontact.problem.table\n")
    wrong = {one for one in imports(package) if not is_allowed(*one)}
    assert wrong == {("problem/table.py", "cli", False), ("problem/table.py", "studies", True), ("law.py", "problem", True)}


MOST_NAMES = 75
"""At the top of the package."""
NAMESPACES = {module.__name__.partition(".")[2]: module for module in PUBLIC[1:]}


def test_the_top_has_few_names():
    assert len(set(mdr.__all__)) == len(mdr.__all__) <= MOST_NAMES


def test_every_extension_has_a_namespace():
    """`instruments` is that of fits."""
    extensions = {path.name for path in (ROOT / "src" / "mdrcontact" / "extensions").iterdir() if path.is_dir()}
    assert {"adhesion", "wear"} <= extensions - {"fit"} <= set(NAMESPACES) == mdr._NAMESPACES <= set(dir(mdr))


def test_every_namespace_is_documented():
    page = (ROOT / "docs" / "python-api" / "index.md").read_text(encoding="utf-8")
    assert all(f"`mdr.{name}`" in page and module.__doc__ for name, module in NAMESPACES.items())


def test_nothing_public_is_in_two_places():
    places: dict[int, set[str]] = {}
    for module in PUBLIC:
        for name in module.__all__:
            places.setdefault(id(getattr(module, name)), set()).add(f"{module.__name__}.{name}")
    twice = [names for names in places.values() if len(names) > 1]
    bases = ("MDRError", "MDRWarning")
    assert sorted(twice, key=min) == [{f"mdrcontact.{name}", f"mdrcontact.errors.{name}"} for name in bases]


def test_what_a_contact_does_not_need_is_loaded_late():
    late = ("closed_forms", "conduction", "instruments", "lateral", "problem", "wear", "weights")
    loaded = run([sys.executable, "-c", "import sys, mdrcontact; print(*sys.modules)"], ROOT).split()
    assert "mdrcontact.contact" in loaded and not {f"mdrcontact.{name}" for name in late} & set(loaded)
