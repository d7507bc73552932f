# SPDX-License-Identifier: GPL-3.0-or-later
"""Every public name of Python has a complete docstring in NumPy style, whose examples give what they print."""

from __future__ import annotations

import ast
import contextlib
import doctest
import importlib
import inspect
import io
import re
import sys
import textwrap
from functools import cache, cached_property
from pathlib import Path
from types import FunctionType, SimpleNamespace

import numpy as np
import pytest
from conftest import PUBLIC, ROOT

import mdrcontact as mdr

MODULES = [*PUBLIC, *map(importlib.import_module, ("mdrcontact.studies", "mdrcontact.progress", "mdrcontact.panels.figure"))]
for adapter in ("contactmechanics", "tamaas"):
    with contextlib.suppress(mdr.MDRError):  # of an engine that is not installed
        MODULES.append(importlib.import_module(f"mdrcontact.interop.{adapter}"))
SECTION = re.compile(r"^(\w[\w ]*)\n-{3,}\n", re.MULTILINE)
ENTRY = re.compile(r"^\*{0,2}(\w+(?:, \*{0,2}\w+)*)(?: : .+)?$", re.MULTILINE)
KEY = re.compile(r'<a id="([\w-]+)"></a>')
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def _public() -> dict[str, object]:
    """Every public name with its module; a name that two modules export counts once."""
    found: dict[int, tuple[str, object]] = {}
    for module in MODULES:
        for name in module.__all__:
            thing = getattr(module, name)
            if not inspect.ismodule(thing):
                found.setdefault(id(thing), (f"{module.__name__}.{name}", thing))
    return dict(found.values())


NAMES = _public()
DOCUMENTED = {name: thing for name, thing in NAMES.items() if isinstance(thing, (type, FunctionType))}
CONSTANTS = sorted(name for name, thing in NAMES.items() if not isinstance(thing, (type, FunctionType)))


class Docstring:
    """Summary and sections of a docstring."""

    def __init__(self, text: str | None) -> None:
        self.text = inspect.cleandoc(text or "")
        _, *parts = SECTION.split(self.text)
        self.sections = dict(zip(parts[::2], parts[1::2], strict=True))

    @cached_property
    def entries(self) -> set[str]:
        """The names in the section Parameters."""
        found = ENTRY.findall(self.sections.get("Parameters", ""))
        return {name.strip(" *") for names in found for name in names.split(",")}

    def faults(self) -> list[str]:
        """Of the summary and the order of sections."""
        summary, _, rest = self.text.partition("\n")
        found = []
        if not summary.endswith(".") or len(summary) > 79 or rest and not rest.startswith("\n"):
            found.append(f"the summary must be one line of at most 79 characters with a full stop: {summary!r}")
        if re.search(r"\S -{4,}", self.text):
            found.append("the title of a section must have a line of its own")
        order = ["Parameters", "Returns", "Yields", "Raises", "Notes", "References", "Examples"]
        unknown = set(self.sections) - set(order)
        if unknown or list(self.sections) != [name for name in order if name in self.sections]:
            found.append(f"sections {', '.join(self.sections)} are not those of NumPy style in their order")
        return found


def given_parameters(thing: type | FunctionType) -> set[str]:
    """Names of the parameters of a function, or of a constructor."""
    parameters = inspect.signature(thing).parameters.values()
    return {p.name for p in parameters if p.name not in ("self", "cls") and not p.name.startswith("_")}


@cache
def _tree(path: str) -> ast.Module:
    return ast.parse(Path(path).read_text(encoding="utf-8"))


def described_fields(kind: type) -> set[str]:
    """Fields of a class with a docstring below them."""
    found: set[str] = set()
    for cls in kind.__mro__:
        if not cls.__module__.startswith("mdrcontact"):
            continue
        tree = _tree(sys.modules[cls.__module__].__file__ or "")
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef) and node.name == cls.__name__:
                for field, below in zip(node.body, node.body[1:], strict=False):
                    if isinstance(field, ast.AnnAssign) and isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
                        found.add(ast.unparse(field.target))
    return found


def faults(thing: type | FunctionType, is_method: bool = False) -> list[str]:
    """What the docstring of a class, function or method lacks."""
    doc = Docstring(vars(thing).get("__doc__") if isinstance(thing, type) else thing.__doc__)
    if not doc.text:
        return ["there is no docstring"]
    found, needed = doc.faults(), set() if is_method else {"Examples"}
    if isinstance(thing, type) and issubclass(thing, BaseException):
        return [*found, *(f"the section {name} is missing" for name in sorted(needed - set(doc.sections)))]
    given = given_parameters(thing)
    wrong = doc.entries - given
    missing = given - doc.entries - (described_fields(thing) if isinstance(thing, type) else set())
    found += [f"the parameter {name} is not described" for name in sorted(missing)]
    found += [f"there is no parameter {name}" for name in sorted(wrong)]
    if not isinstance(thing, type):
        if inspect.signature(thing).return_annotation not in (None, "None", inspect.Signature.empty):
            needed.add("Returns")
        if given and not is_method:
            needed.add("Raises")
    elif doc.entries:
        needed.add("Raises")
    return found + [f"the section {name} is missing" for name in sorted(needed - set(doc.sections))]


def members(kind: type) -> dict[str, object]:
    """Public methods and properties of a class and of its bases in the package."""
    found: dict[str, object] = {}
    for cls in reversed([cls for cls in kind.__mro__ if cls.__module__.startswith("mdrcontact")]):
        found.update((name, value) for name, value in vars(cls).items() if not name.startswith("_"))
    return {name: value for name, value in found.items() if name not in getattr(kind, "_fields", ())}


def member_faults(kind: type) -> list[str]:
    """What the docstrings of the members of a class lack."""
    found = []
    for name, value in members(kind).items():
        function = value.__func__ if isinstance(value, (classmethod, staticmethod)) else value
        if isinstance(function, FunctionType):
            found += [f"{name}: {fault}" for fault in faults(function, is_method=True)]
        elif isinstance(function, (property, cached_property)):
            found += [f"{name}: {fault}" for fault in property_faults(function)]
    return found


def property_faults(value: property | cached_property) -> list[str]:
    """What the docstring of a property lacks."""
    if not value.__doc__:
        return ["there is no docstring"]
    function = value.fget if isinstance(value, property) else value.func
    kind = str(function.__annotations__.get("return"))
    has_unit = "[" in value.__doc__ or not re.search("float|Array", kind, re.IGNORECASE)
    return Docstring(value.__doc__).faults() + ([] if has_unit else ["the unit in brackets is missing"])


@pytest.mark.parametrize("name", DOCUMENTED)
def test_docstring_is_complete(name):
    thing = DOCUMENTED[name]
    found = faults(thing)
    if isinstance(thing, type) and not issubclass(thing, BaseException):
        found += member_faults(thing)
    assert not found, f"{name}: " + "; ".join(found)


SLOW = ("mdrcontact.wear.wear_coefficient_from_scar",)


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.slow) if name in SLOW else name for name in DOCUMENTED])
def test_examples_give_what_they_print(name):
    if name.startswith("mdrcontact.get_") and not (Path(mdr.__file__).parent / "lib").is_dir():
        pytest.skip("the package has no C library: it is not installed")
    text = Docstring(DOCUMENTED[name].__doc__).text
    globs = {"mdr": mdr, "np": np}
    parsed = doctest.DocTestParser().get_doctest(text, globs, name, None, 0)
    out = io.StringIO()
    assert parsed.examples, f"{name} has no example"
    assert any(example.want for example in parsed.examples), f"{name}: the example shows no result"
    assert doctest.DocTestRunner(optionflags=FLAGS).run(parsed, out=out.write).failed == 0, out.getvalue()


@pytest.mark.parametrize("name", CONSTANTS)
def test_constant_stands_in_an_example(name):
    short = name.rpartition(".")[2]
    examples = "\n".join(Docstring(thing.__doc__).sections.get("Examples", "") for thing in DOCUMENTED.values())
    assert re.search(rf"\b{short}\b", examples), f"no example uses {name}"


def test_references_are_in_the_bibliography():
    keys = set(KEY.findall((ROOT / "docs" / "bibliography.md").read_text(encoding="utf-8")))
    cited = {
        (name, line.partition(",")[0].strip())
        for name, thing in DOCUMENTED.items()
        for line in Docstring(thing.__doc__).sections.get("References", "").splitlines()
        if line.strip()
    }
    assert cited and not {(name, key) for name, key in cited if key not in keys}


def test_every_name_is_on_one_page():
    text = "\n".join(page.read_text(encoding="utf-8") for page in sorted((ROOT / "docs" / "python-api").glob("*.md")))
    shown = re.findall(r"^::: ([\w.]+)$", text, re.MULTILINE)
    assert sorted(shown) == sorted(set(shown))
    adapters = {name for name in shown if name.startswith("mdrcontact.interop.")}
    assert set(shown) - adapters == {name for name in NAMES if not name.startswith("mdrcontact.interop.")}
    assert {name for name in NAMES if name.startswith("mdrcontact.interop.")} <= adapters


COMPLETE = '''
def scaled(x, factor=2.0):
    """Scale a number.

    Parameters
    ----------
    x : float
        The number [1].
    factor : float, optional
        Its factor [1].

    Returns
    -------
    float
        Their product [1].

    Raises
    ------
    TypeError
        One of them is not a number.

    Examples
    --------
    >>> scaled(2.0)
    4.0
    """
'''


@pytest.mark.parametrize(
    ("removed", "fault"),
    [
        ("", None),
        ("    x : float\n        The number [1].\n", "the parameter x is not described"),
        ("    factor : float, optional\n        Its factor [1].\n", "the parameter factor is not described"),
        ("    Returns\n    -------\n", "the section Returns is missing"),
        ("    Raises\n    ------\n", "the section Raises is missing"),
        ("    Examples\n    --------\n", "the section Examples is missing"),
        ("Scale a number.", "the summary must be"),
        ("\n    ------\n    TypeError", "the section Raises is missing"),
    ],
)
def test_what_is_removed_is_found(removed, fault):
    space: dict[str, FunctionType] = {}
    text = COMPLETE.replace(removed, "").replace("(x, factor=2.0):", "(x, factor=2.0) -> float:")
    exec(compile(text, "scaled", "exec", dont_inherit=True), space)
    found = faults(space["scaled"])
    assert found == [] if fault is None else any(one.startswith(fault) for one in found), found


def test_a_field_without_a_docstring_is_found(tmp_path, monkeypatch):
    text = textwrap.dedent('''
        from typing import NamedTuple

        class Pair(NamedTuple):
            """Two numbers.

            Examples
            --------
            >>> Pair(1.0, 2.0).first
            1.0
            """

            first: float
            """the first [1]"""
            second: float
    ''')
    path = tmp_path / "mdrcontact_pair.py"
    path.write_text(text, encoding="utf-8")
    monkeypatch.setitem(sys.modules, "mdrcontact_pair", SimpleNamespace(__file__=str(path)))
    space: dict[str, object] = {"__name__": "mdrcontact_pair"}
    exec(compile(text, str(path), "exec", dont_inherit=True), space)
    kind = space["Pair"]
    assert isinstance(kind, type) and faults(kind) == ["the parameter second is not described"]
