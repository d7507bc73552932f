# SPDX-License-Identifier: GPL-3.0-or-later
"""The keys of problem files and map files that `--help` of a command lists, from the schema."""

from __future__ import annotations

import argparse
import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping
from typing import NoReturn

from .._units import RATIO, shown
from ..instruments import schema as measured
from ..problem.schema import MAP, PROBLEM, TABLES, Field, Table

EXIT_STATUS = """\
exit status:
  0  success
  1  the problem has no solution, or a result cannot be written
  2  the command line or the problem file is wrong
  130  interrupted by Ctrl-C
"""
FILES = {"problem file": PROBLEM, "map file": MAP}
TITLE = re.compile(rf"^({'|'.join(FILES)}|examples):([\w ]*)\n", re.MULTILINE)
_ALL = {**TABLES, **measured.TABLES}
_MARGIN, _WIDTH = " " * 36, 80

Tables = Mapping[str, Table]


class Parser(argparse.ArgumentParser):
    """The arguments of one command. Its text from the first title on follows the options; the tables named there are listed."""

    def format_help(self) -> str:
        """Return the text of `--help`."""
        text = self.description or ""
        if title := TITLE.search(text):
            keys = listing(title[2].split(), FILES[title[1]]) if title[2] else ""
            self.description, self.epilog = text[: title.start()], f"{title[1]}:\n{keys}{text[title.end() :]}\n{EXIT_STATUS}"
        return super().format_help()

    def error(self, message: str) -> NoReturn:
        """Exit with what is wrong; where a problem file for a fit is missing, with the command that writes one."""
        if "required" in message and "--problem" in message:
            message += '; "mdrcontact inspect DATA --problem PROBLEM.toml" writes one to start from'
        super().error(message)


def listing(names: Iterable[str], file: Table = PROBLEM) -> str:
    """Return the lines of a file with every key of these tables, its meaning as a comment.

    A table that several tables contain appears once, below the first of them that is not the indenter.
    """
    names = [*names]
    lines = [_row(file.field("title"), {})]
    chosen = {path: table for path, table in _ALL.items() if path.partition(".")[0] in names}
    for name in names:
        for path, table in chosen.items():
            if path.partition(".")[0] == name and path == _places(table, chosen)[0]:
                lines += ["", *_rows(table, chosen)]
    return re.sub("^(?=.)", "  ", "\n".join(lines), flags=re.MULTILINE) + "\n"


def _places(table: Table, chosen: Tables) -> list[str]:
    return [path for path, one in chosen.items() if one is table and not path.startswith("indenter.")]


def _rows(table: Table, chosen: Tables) -> Iterator[str]:
    heads = ", ".join(_head(path, table) for path in _places(table, chosen))
    base = f"; also the keys of [{_places(table.extends, chosen)[0]}]" if table.extends else ""
    yield _commented(heads, f"{table.meaning}{base}" + (f": {table.guide}" if table.guide else ""))
    own = table.fields[len(table.extends.fields) if table.extends else 0 :]
    for many, groups in (("exactly", table.one_of), ("at most", table.at_most_one_of)):
        yield from (f"# {many} one of {', '.join(group)}" for group in groups if table.field(group[0]) in own)
    yield from (_row(one, chosen) for one in (*own, *table.replaced))


def _head(path: str, table: Table) -> str:
    above, _, name = path.rpartition(".")
    if above and _ALL[above].field(name).many:
        return f"[[{path}]]"
    return f'[{path}."{table.name}"]' if table.name else f"[{path}]"


def _row(one: Field, chosen: Tables) -> str:
    value, words = _value(one), [one.meaning]
    if others := [f'"{word}"' for word in one.choices if f'"{word}"' != value]:
        words.append(f"or {', '.join(others)}")
    if one.table:
        words.append(f"{'or ' * bool(one.choices or one.example)}the keys of {_head(_places(one.table, chosen)[0], one.table)}")
    if one.range and one.dimension == RATIO:
        words.append(str(one.range))
    if one.default is not None:
        default = shown(one.default, one.dimension) if one.kind == "quantity" and one.dimension else value
        words.append("default" if default == value else f"default: {default}")
    elif one.optional and "default:" not in one.meaning:
        words.append("optional")
    when = "; ".join(f"{key or 'material'}: {', '.join(kinds)}" if kinds else f"with {key}" for key, kinds in one.when.items())
    return _commented(f"{one.name} = {value}", "; ".join(words) + (f" ({when})" if when else ""))


def _commented(line: str, comment: str) -> str:
    first = f"{line:<{len(_MARGIN)}}" if len(line) < len(_MARGIN) else f"{line}\n{_MARGIN}"
    return first + f"\n{_MARGIN}".join(f"# {part}" for part in textwrap.wrap(comment, _WIDTH, break_on_hyphens=False))


def _value(one: Field) -> str:
    """Return a value as a file contains it: the default, the first choice, or an example."""
    if one.example:
        return one.example
    if one.is_boolean:
        return str(one.default is not False).lower() if one.default is not None else "true"
    if one.dimension not in (None, RATIO):
        value = f'"{one.dimension.example}"'
    elif one.table and not one.choices:
        value = "{...}"
    elif one.choices:
        value = f'"{one.default or one.choices[0]}"'
    else:
        value = f"{one.default or (one.step and one.range and one.range.least) or 0.3:.4g}"
    return f"[{value}, ...]" if one.many else value
