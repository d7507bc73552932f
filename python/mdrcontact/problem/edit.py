# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit the text of a problem file in place: an edit changes the line of its key, and all others stay byte for byte.

A path leads to a value: ("medium", "layer", 1, "E") is E of the second [[medium.layer]]. tomlkit finds the places in the text. It
belongs to the extra `app`.

Examples
--------
>>> from mdrcontact.problem import edit
>>> text = '''[indenter]  # a ball
... shape = "sphere"
... radius = "10 um"  # measured
... '''
>>> text = edit.changed(text, ("indenter", "radius"), "12 um")
>>> print(edit.changed(text, ("compute", "max_depth"), "90 nm"), end="")
[indenter]  # a ball
shape = "sphere"
radius = "12 um"  # measured
<BLANKLINE>
[compute]
max_depth = "90 nm"
>>> edit.value(text, ("indenter", "radius"))
'12 um'
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import AoT, Array, InlineTable, Null, Table, Trivia

from .named import ProblemError
from .toml import keyed, parse_text, quoted, written

__all__ = ["changed", "inserted", "value", "without"]

Path = tuple["str | int", ...]
_MARK = "\0"
"""Marks a place in a text: TOML has no such character."""
_NOTES = re.compile(r"(?:^#.*\n)*\Z", re.MULTILINE)
_OTHER = "it cannot be edited in place. Edit the text of the file."


def value(text: str, path: Path, default: Any = None) -> Any:
    """Return the value at a path as the text has it, or the default if it is absent."""
    found: Any = parse_text(text)
    try:
        for step in path:
            found = found[step]
    except (KeyError, IndexError, TypeError):
        return default
    return found


def changed(text: str, path: Path, new: Any) -> str:
    """Return the text with another value at a path. Absent tables on the way are added."""
    if new == value(text, path) and written(new) == written(value(text, path)):
        return text

    def assign(tables: Any) -> None:
        for step in path[:-1]:
            tables = tables.setdefault(step, {}) if isinstance(tables, dict) else tables[step]
        tables[path[-1]] = new

    return _checked(text, lambda text: _changed(text, path, new), assign)


def without(text: str, path: Path) -> str:
    """Return the text without the key, the table or the entry of a list at a path. Comments above it stay."""
    if isinstance(path[-1], int) and len(value(text, path[:-1], ())) == 1:
        path = path[:-1]

    def remove(tables: Any) -> None:
        for step in path[:-1]:
            tables = tables[step]
        del tables[path[-1]]

    return _checked(text, lambda text: _without(text, path), remove)


def inserted(text: str, path: Path, place: int, new: Mapping[str, Any]) -> str:
    """Return the text with a table before entry `place` of the list of tables at a path."""

    def insert(tables: Any) -> None:
        for step in path[:-1]:
            tables = tables[step]
        tables.setdefault(path[-1], []).insert(place, new)

    return _checked(text, lambda text: _inserted(text, path, place, new), insert)


def _checked(text: str, edit: Callable[[str], str], expected: Callable[[Any], None]) -> str:
    """Return an edited text; an error if its tables are not those expected."""
    begin, text = text[: text.startswith("\ufeff")], text.removeprefix("\ufeff")
    tables = parse_text(text)
    try:
        expected(tables)
        found = edit(text.replace("\r\n", "\n"))
        same = json.dumps(parse_text(found), sort_keys=True, default=str) == json.dumps(tables, sort_keys=True, default=str)
    except (TOMLKitError, LookupError, TypeError, AttributeError, ValueError) as problem:
        raise ProblemError(_OTHER) from problem
    if not same:
        raise ProblemError(_OTHER)
    return begin + (found.replace("\n", "\r\n") if "\r\n" in text else found)


def _changed(text: str, path: Path, new: Any) -> str:
    document = tomlkit.parse(text)
    try:
        parent = _at(document, path[:-1])
    except KeyError:
        return _changed(text, path[:-1], {path[-1]: new})
    old = parent.get(path[-1]) if isinstance(parent, dict) else parent[path[-1]]
    if isinstance(old, (Table, AoT)):
        return _changed(_without(text, path), path, new)
    is_dotted = isinstance(parent, Table) and parent.is_super_table() and _keys(parent)
    if old is not None or is_dotted or isinstance(parent, InlineTable):
        parent[path[-1]] = tomlkit.value(written(new))
        return document.as_string()
    blocks = new if isinstance(new, list) and all(isinstance(one, dict) for one in new) else [new]
    if blocks and isinstance(blocks[0], dict):
        block = "\n".join(_block(path, one, blocks is new) for one in blocks)
        *before, after = _around(document, parent) if len(path) > 1 else (text, "")
        return f"{_lined(''.join(before))}\n{block}{after}"
    return _with_line(document, parent, f"{keyed(str(path[-1]), new)}\n")


def _with_line(document: Any, parent: Any, line: str) -> str:
    """Return a document with a line below the keys of a table, or below its header."""
    keys = _keys(parent)
    if keys or not (parent is document or parent.is_super_table()):
        trivia = [parent, *keys][-1].trivia
        trivia.trail = _lined(trivia.trail, always=True) + line
        return str(document.as_string())
    if not parent:
        return _lined(document.as_string()) + line
    before, notes, own, after = _around(document, parent)
    header = "" if parent is document else f"[{parent.name}]\n"
    return f"{before}{header}{line}\n{notes}{own}{after}"


def _inserted(text: str, path: Path, place: int, new: Mapping[str, Any]) -> str:
    document = tomlkit.parse(text)
    try:
        tables: Any = _at(document, path)
    except KeyError:
        return _changed(text, path, [new])
    if isinstance(tables, Array):
        tables.insert(place, tomlkit.value(written(new)))
        return document.as_string()
    block = _block(path, new, True)
    before, notes, own, after = _around(document, tables[max(place, 1) - 1])
    return f"{_lined(before + notes + own)}\n{block}{after}" if place else f"{before}{block}\n{notes}{own}{after}"


def _without(text: str, path: Path) -> str:
    document = tomlkit.parse(text)
    parent = _at(document, path[:-1])
    if not isinstance(parent[path[-1]], (Table, AoT)):
        del parent[path[-1]]
        return document.as_string()
    before, notes, _, after = _around(document, parent[path[-1]])
    return before + notes + (after.removeprefix("\n") if (before + notes).endswith("\n\n") or not before + notes else after)


def _at(document: Any, path: Path) -> Any:
    found = document
    for step in path:
        found = found[step]
    return found


def _items(table: Any) -> list[Any]:
    """Return the items of a table that have a key."""
    body = table.body if isinstance(table, tomlkit.TOMLDocument) else table.value.body
    return [item for key, item in body if key is not None and not isinstance(item, Null)]


def _keys(table: Any) -> list[Any]:
    """Return the items of a table that are no tables of their own."""
    return [item for item in _items(table) if not isinstance(item, (Table, AoT))]


def _ends(item: Any) -> tuple[Trivia, Trivia]:
    """Return what an item has around it where it begins, and at the end of the last key inside."""
    is_plain = not isinstance(item, (Table, AoT, tomlkit.TOMLDocument))
    inside = [] if is_plain else list(item) if isinstance(item, AoT) else _items(item)
    has_header = is_plain or isinstance(item, Table) and not item.is_super_table()
    return item.trivia if has_header else _ends(inside[0])[0], _ends(inside[-1])[1] if inside else item.trivia


def _around(document: Any, item: Any) -> tuple[str, str, str, str]:
    """Return the text before an item, the comment right above it, its own to the end of the last key inside, and the rest."""
    begin, end = _ends(item)
    begin.indent, end.trail = _MARK + begin.indent, end.trail + _MARK
    before, own, after = document.as_string().split(_MARK)
    notes = _NOTES.search(before)
    assert notes is not None
    return before[: notes.start()], notes[0], own, after


def _lined(text: str, always: bool = False) -> str:
    """Return a text that ends with the end of a line; if `always` also an empty one."""
    return text if text.endswith("\n") or not (text or always) else f"{text}\n"


def _block(path: Path, table: Mapping[str, Any], is_listed: bool) -> str:
    name = ".".join(quoted(step) for step in path if isinstance(step, str))
    header = f"[[{name}]]" if is_listed else f"[{name}]"
    return "\n".join([header, *(keyed(key, one) for key, one in table.items()), ""])
