# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands and the tables of problem files as Markdown, from the command line's parser and the schema."""

from __future__ import annotations

import argparse
import math
import re
import textwrap
from collections.abc import Iterator
from pathlib import Path

from mdrcontact._units import ANGLE, RATIO, shown
from mdrcontact.cli import COMMANDS, make_parser
from mdrcontact.cli.keys import FILES, TITLE
from mdrcontact.instruments import schema as measured
from mdrcontact.problem.schema import MAP, PROBLEM, TABLES, Field, Range, Table

ALL = {**TABLES, **measured.TABLES}
"""Every table of all kinds of files by its path."""
_WIDTH = 132
HEADINGS = ("problem file", "map file", "examples", "see also")


def commands() -> str:
    """Every command: what it does, its arguments, its tables, examples."""
    _, parsers = make_parser()
    lines = ["| Command | Result |", "|---|---|"]
    for module, name in zip(COMMANDS, parsers, strict=True):
        lines.append(f"| [`{name}`](#{name}) | {module.HELP} |")
    for name, parser in parsers.items():
        lines += ["", f"## {name}", "", *_command(name, parser)]
    return "\n".join(lines)


def _command(name: str, parser: argparse.ArgumentParser) -> Iterator[str]:
    parts = re.split(rf"^({'|'.join(HEADINGS)}):(.*)\n", parser.description or "", flags=re.MULTILINE)
    for paragraph in parts[0].strip().split("\n\n"):
        yield from (
            ("```text", *(line[2:] for line in paragraph.splitlines()), "```") if paragraph.startswith("  ") else (paragraph,)
        )
        yield ""
    arguments = [one for one in parser._actions if one.dest != "help"]
    required = [_spelling(one) for one in arguments if one.required]
    yield from ("```text", " ".join(["mdrcontact", name, *required, "[options]"]), "```", "", "| Argument | Meaning |", "|---|---|")
    for one in arguments:
        words = {**vars(one), "choices": ", ".join(map(str, one.choices or ()))}
        yield f"| `{_spelling(one)}` | {(one.help or '') % words} |"
    for title, names, text in zip(parts[1::3], parts[2::3], parts[3::3], strict=True):
        yield ""
        if title in FILES:
            links = ", ".join(f"[`[{one}]`](problem-files.md#{one})" for one in names.split())
            yield _filled(f"Tables of the {title}: {links}.")
        elif title == "examples":
            yield from ("Examples:", "", "```text", *(line[2:] for line in text.strip("\n").splitlines()), "```")
        else:
            yield _filled(f"See also: {'; '.join(map(_reference, text.strip().splitlines()))}.")


def _filled(text: str) -> str:
    return textwrap.fill(text, _WIDTH, break_long_words=False, break_on_hyphens=False)


def _spelling(one: argparse.Action) -> str:
    value = one.metavar or ("{" + ",".join(map(str, one.choices)) + "}" if one.choices else one.dest)
    value = f"{value} ..." if one.nargs == "+" else f"[{value}]" if one.nargs == "?" else str(value)
    return " ".join([*one.option_strings[:1], *([] if one.nargs == 0 else [value])])


def _reference(line: str) -> str:
    place, words = re.split(r"  +", line.strip(), maxsplit=1)
    if place.startswith("docs/"):
        return f"[{words}]({place.removeprefix('docs/')})"
    name = place.removeprefix("mdrcontact ")
    return f"[`{name}`](#{name}), {words}"


def tables_of_keys() -> str:
    """Every table of problem files and map files with its keys."""
    lines = []
    for path, table in ALL.items():
        places = [other for other, one in ALL.items() if one is table and not other.startswith("indenter.")]
        if path and path == next(iter(places), ""):
            lines += ["", *_table(places, table)]
    return "\n".join(lines[1:])


def readers() -> str:
    """The tables that each command reads."""
    lines = ["| Table | Contents | Commands |", "|---|---|---|"]
    read = {name: title[2].split() for name, one in make_parser()[1].items() if (title := TITLE.search(one.description or ""))}
    fields = {one.name: one for file in (PROBLEM, measured.FIT, MAP) for one in file.fields if one.table}
    for name, one in fields.items():
        by = ", ".join(f"`{command}`" for command, names in read.items() if name in names)
        lines.append(f"| [`[{name}]`](#{name}) | {one.meaning} | {by} |")
    return "\n".join(lines)


def _head(path: str, table: Table) -> str:
    above, _, name = path.rpartition(".")
    if above and ALL[above].field(name).many:
        return f"`[[{path}]]`"
    return f'`[{path}."{table.name}"]`' if table.name else f"`[{path}]`"


def _table(places: list[str], table: Table) -> Iterator[str]:
    yield f"### {', '.join(_head(path, table) for path in places)}"
    yield ""
    meaning = f"{table.meaning[0].upper()}{table.meaning[1:]}."
    if table.guide:
        page = Path(table.guide)
        meaning += f" See [{page.stem}]({page.name})."
    if table.extends:
        base = next(path for path, one in ALL.items() if one is table.extends and not path.startswith("indenter."))
        meaning += f" The keys of {_head(base, table.extends)} also belong to it."
    yield _filled(meaning)
    own = table.fields[len(table.extends.fields) if table.extends else 0 :]
    for many, groups in (("Exactly", table.one_of), ("At most", table.at_most_one_of)):
        for group in groups:
            if table.field(group[0]) in own:
                yield f"{many} one of {', '.join(f'`{key}`' for key in group)} is given."
    yield from ("", "| Key | Value | Default | Belongs to | Meaning |", "|---|---|---|---|---|")
    yield from (
        f"| `{one.name}` | {_value(one)} | {_default(one)} | {_when(one)} | {one.meaning} |" for one in (*own, *table.replaced)
    )


def _value(one: Field) -> str:
    words = [f'`"{word}"`' for word in one.choices]
    if one.table:
        place = next(path for path, table in ALL.items() if table is one.table and not path.startswith("indenter."))
        words += [f"`{one.example}`"] if one.example else []
        words.append(f"{'list of tables' if one.many else 'table'} {_head(place, one.table)}")
    elif one.is_boolean:
        words = ["`true`", "`false`"]
    elif one.is_file:
        words = [f"file, `{one.example}`"]
    elif one.dimension == RATIO and not one.choices:
        words = ["whole number" if one.step else f"list, `{one.example or '[0.2, 0.3]'}`" if one.many else "number"]
    elif one.dimension not in (None, RATIO):
        kind = one.dimension.name.split(" ", 1)[1]
        words.append(
            f'list of values, {kind}, `["{one.dimension.example}", ...]`' if one.many else f'{kind}, `"{one.dimension.example}"`'
        )
    elif not one.choices:
        words = [f"`{one.example}`"]
    if one.step > 1:
        words.append(f"multiple of {one.step}")
    bounds = f", {_range(one.range, one)}" if one.range and not one.choices else ""
    return ", ".join(words[:-2] + [" or ".join(words[-2:])]) + bounds


def _range(bounds: Range, one: Field) -> str:
    ends = []
    for sign, closed, value in ((">", bounds.has_least, bounds.least), ("&lt;", bounds.has_largest, bounds.largest)):
        if math.isfinite(value):
            bound = f"{math.degrees(value):g} deg" if value and one.dimension == ANGLE else f"{value:g}"
            ends.append(f"{sign}{'=' * closed} {bound}")
    return " and ".join(ends)


def _default(one: Field) -> str:
    if one.required:
        return "required"
    if one.default is None:
        return ""
    if isinstance(one.default, bool):
        return f"`{str(one.default).lower()}`"
    if isinstance(one.default, str):
        return f'`"{one.default}"`'
    return shown(one.default, one.dimension) if one.kind == "quantity" and one.dimension else f"{one.default:.4g}"


def _when(one: Field) -> str:
    return "; ".join(
        f"{f'`{key}`' if key else 'material'}: {', '.join(kinds)}" if kinds else f"`{key}`" for key, kinds in one.when.items()
    )
