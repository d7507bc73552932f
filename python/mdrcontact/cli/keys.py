# SPDX-License-Identifier: GPL-3.0-or-later
"""What `--help` of a command lists of its problem file: tables and keys, from the schema."""

from __future__ import annotations

import argparse
import re
import textwrap
from collections.abc import Iterable, Iterator

from .._units import RATIO, shown
from ..problem.schema import PROBLEM, TABLES, Field, Table

EXIT_STATUS = """\
exit status:
  0  success
  1  the problem has no solution, or a result cannot be written
  2  the command line or the problem file is wrong
  130  interrupted by Ctrl-C
"""
TITLE = re.compile(r"^(problem file|map file|examples):([\w ]*)\n", re.MULTILINE)
_MARGIN, _WIDTH = " " * 36, 80


class Parser(argparse.ArgumentParser):
    """The arguments of one command. Its text from the first title on follows the options; the tables named there are listed."""

    def format_help(self) -> str:
        """Return the text of `--help`."""
        text = self.description or ""
        if title := TITLE.search(text):
            keys = listing(title[2].split()) if title[2] else ""
            self.description, self.epilog = text[: title.start()], f"{title[1]}:\n{keys}{text[title.end() :]}\n{EXIT_STATUS}"
        return super().format_help()


def listing(names: Iterable[str]) -> str:
    """Return the lines of a problem file with every key of these tables, its meaning as a comment.

    A table inside another stands once, below the first of them that is not the indenter.
    """
    lines = [_row(PROBLEM.field("title"))]
    for name in names:
        for path, table in TABLES.items():
            if path == name or path.startswith(f"{name}.") and path == _places(table)[0]:
                lines += ["", *_rows(table)]
    return re.sub("^(?=.)", "  ", "\n".join(lines), flags=re.MULTILINE) + "\n"


def _places(table: Table) -> list[str]:
    return [path for path, one in TABLES.items() if one is table and not path.startswith("indenter.")]


def _rows(table: Table) -> Iterator[str]:
    above = (TABLES[path.rpartition(".")[0]].field(path.rpartition(".")[2]) for path in _places(table))
    heads = (f"[[{path}]]" if one.many else f"[{path}]" for path, one in zip(_places(table), above, strict=True))
    base = f"; also the keys of [{_places(table.extends)[0]}]" if table.extends else ""
    yield _commented(", ".join(heads), f"{table.meaning}{base}" + (f": {table.guide}" if table.guide else ""))
    own = table.fields[len(table.extends.fields) if table.extends else 0 :]
    for many, groups in (("exactly", table.one_of), ("at most", table.at_most_one_of)):
        yield from (f"# {many} one of {', '.join(group)}" for group in groups if table.field(group[0]) in own)
    yield from map(_row, (*own, *table.replaced))


def _row(one: Field) -> str:
    value, words = _value(one), [one.meaning]
    if others := [f'"{word}"' for word in one.choices if f'"{word}"' != value]:
        words.append(f"or {', '.join(others)}")
    if one.table:
        words.append(f"{'or ' * bool(one.choices)}the keys of [{_places(one.table)[0]}]")
    if one.range and one.dimension == RATIO:
        words.append(str(one.range))
    if one.default is not None:
        default = shown(one.default, one.dimension) if one.kind == "quantity" and one.dimension else value
        words.append("default" if default == value else f"default: {default}")
    elif one.optional:
        words.append("optional")
    when = "; ".join(f"{key or 'material'}: {', '.join(kinds)}" if kinds else f"with {key}" for key, kinds in one.when.items())
    return _commented(f"{one.name} = {value}", "; ".join(words) + (f" ({when})" if when else ""))


def _commented(line: str, comment: str) -> str:
    first = f"{line:<{len(_MARGIN)}}" if len(line) < len(_MARGIN) else f"{line}\n{_MARGIN}"
    return first + f"\n{_MARGIN}".join(f"# {part}" for part in textwrap.wrap(comment, _WIDTH, break_on_hyphens=False))


def _value(one: Field) -> str:
    """A value as it stands in a file: the default, the first of the words, or an example."""
    if one.example:
        return one.example
    if one.dimension not in (None, RATIO):
        value = f'"{one.dimension.example}"'
    elif one.table and not one.choices:
        value = "{...}"
    elif one.choices:
        value = f'"{one.default or one.choices[0]}"'
    else:
        value = f"{one.default or (one.step and one.range and one.range.least) or 0.3:.4g}"
    return f"[{value}, ...]" if one.many else value
