# SPDX-License-Identifier: GPL-3.0-or-later
"""No two files of the package import each other, directly or around a circle, be it late or for a type only."""

import ast
import graphlib
from pathlib import Path

import pytest
from conftest import ROOT


def _imports(folder: Path) -> dict[str, set[str]]:
    """Which modules of the package in `folder` every one of its modules names in import statements."""
    files = [*folder.rglob("*.py"), *folder.rglob("*.pyi")]
    paths = {path.relative_to(folder.parent).with_suffix(""): path for path in files}
    modules = {".".join(part for part in short.parts if part != "__init__"): path for short, path in paths.items()}
    graph: dict[str, set[str]] = {name: set() for name in modules}
    for name, path in modules.items():
        parts = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                graph[name] |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                above = parts[: len(parts) - node.level + 1] if node.level else []
                origin = ".".join(above + ([node.module] if node.module else []))
                whole = {f"{origin}.{alias.name}" for alias in node.names}
                graph[name] |= whole & modules.keys() or {origin}
        graph[name] &= modules.keys()
    return graph


def test_no_imports_in_a_circle():
    graph = _imports(ROOT / "python" / "mdrcontact")
    assert len(graph) > 50 and graph["mdrcontact.contact"] >= {"mdrcontact.medium", "mdrcontact._boundary"}
    graphlib.TopologicalSorter(graph).prepare()


def test_a_circle_would_be_found(tmp_path):
    package = tmp_path / "package"
    (package / "inner").mkdir(parents=True)
    (package / "__init__.py").write_text("from .one import f\n")
    (package / "inner" / "__init__.py").write_text("")
    (package / "inner" / "two.py").write_text("def g():\n    from .. import one\n    return one\n")
    (package / "one.py").write_text("f = 1\n")
    graphlib.TopologicalSorter(_imports(package)).prepare()
    (package / "one.py").write_text("TYPE_CHECKING = False\nif TYPE_CHECKING:\n    from .inner.two import g\nf = 1\n")
    with pytest.raises(graphlib.CycleError):
        graphlib.TopologicalSorter(_imports(package)).prepare()
