# SPDX-License-Identifier: GPL-3.0-or-later
"""Which public Fortran entities have no docstring, by FORD's own parser.

FORD's `warn` wants a docstring on every local variable too, so the question is put here. Every public module, constant, type,
interface and procedure needs one. What the facade module exports is for users: there the components and bindings of types and the
numbers, texts and arrays among the arguments need one as well. An argument of derived type is clear by its type, and a binding
that overrides another one by that.
"""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ford.fortran_project import Project
from ford.settings import ProjectSettings

FACADE = "mdrcontact"


def undocumented(source: Path, excluded: Path) -> list[str]:
    """The names of what lacks a docstring, each with its kind and module."""
    settings = ProjectSettings(src_dir=[source], exclude_dir=[excluded], preprocess=False, display=["public"], quiet=True)
    settings.normalise_paths(source)
    with contextlib.redirect_stdout(io.StringIO()):
        project = Project(settings)
        project.correlate()
    exported = _exports((source / f"{FACADE}.f90").read_text(encoding="utf-8"))
    return sorted(name for module in project.modules for name in _of_module(module, exported))


def _exports(facade: str) -> set[str]:
    """The names after `only:` in the facade module."""
    joined = re.sub(r"&\s*\n\s*", "", facade)
    lists = re.findall(r"^\s*use \w+, only: (.*)$", joined, flags=re.MULTILINE)
    return {name.strip().lower() for names in lists for name in names.split(",")}


def _of_module(module: Any, exported: set[str]) -> Iterator[str]:
    if not module.doc_list:
        yield f"module {module.name}"
    procedures = [*module.functions, *module.subroutines]
    interfaces = [*module.interfaces, *module.absinterfaces]
    for entity in (*module.variables, *module.types, *procedures, *interfaces):
        if not entity.doc_list and not getattr(getattr(entity, "procedure", None), "doc_list", None):
            yield f"{module.name}: {entity.name}"
    for entity in module.types:
        if entity.name.lower() in exported:
            yield from (f"{module.name}: {name}" for name in _of_type(entity))
    for entity in procedures:
        if entity.name.lower() in exported:
            yield from (f"{module.name}: {entity.name}({name})" for name in _arguments(entity))


def _of_type(entity: Any) -> Iterator[str]:
    for component in entity.variables:
        if not component.doc_list:
            yield f"{entity.name}%{component.name}"
    for binding in entity.boundprocs:
        if _overrides(entity, binding.name):
            continue
        procedures = [b for b in binding.bindings if hasattr(b, "doc_list")]
        if not binding.doc_list and not any(procedure.doc_list for procedure in procedures):
            yield f"{entity.name}%{binding.name}"
        for procedure in procedures:
            yield from (f"{entity.name}%{binding.name}({name})" for name in _arguments(procedure))


def _overrides(entity: Any, name: str) -> bool:
    parent = entity.extends
    while hasattr(parent, "boundprocs"):
        if any(binding.name.lower() == name.lower() for binding in parent.boundprocs):
            return True
        parent = parent.extends
    return False


def _arguments(procedure: Any) -> Iterator[str]:
    for argument in getattr(procedure, "args", ()):
        if not argument.doc_list and getattr(argument, "vartype", "class") not in ("type", "class"):
            yield argument.name
