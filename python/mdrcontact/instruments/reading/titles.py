# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles of columns: their names and units, in the ways in which instruments write them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ..._units import Dimension, UnitError
from ...problem.roles import ROLES
from . import units

_BRACKETED = re.compile(r"[\s_]*[\[({<]\s*([^\[\](){}<>]*?)\s*[\])}>]")
_WHOLE = re.compile(r"\s*(.*?)[\s_]*[\[(]\s*(.*?)\s*[\])]\s*")
_MARKED = (re.compile(r"\s*(.+?)\s*[,/:;|]\s*(\S+)\s*"), re.compile(r"\s*(.+?)\s+(?:in|/|-)\s+(\S+)\s*"))
"""Name and unit with a sign or a word between them."""
_LAST = re.compile(r"\s*(.+?)\s+(\S+)\s*")
_SYMBOL = re.compile(r"(.+?)[\s,]+[a-z\N{GREEK SMALL LETTER DELTA}]")
"""A name with the symbol of the quantity behind it, as in "load P"."""
_OF_PROGRAM = re.compile(r"(?:[vcf]_|calc )(.+)")
"""Names of variables of LAMMPS, and of channels that a program computes."""
DIRECTIONS = (
    *(("Ex", "Rt"), ("Extend", "Retract"), ("Ext", "Ret"), ("Approach", "Retract"), ("App", "Ret"), ("Trace", "Retrace")),
    *(("Forward", "Backward"), ("Fwd", "Bwd"), ("Loading", "Unloading")),
)
"""Words of titles for loading and unloading in columns side by side."""
_DIRECTION = re.compile(rf"(.+?)[ _](?:{'|'.join(word.lower() for words in DIRECTIONS for word in words)})")


def words(title: str) -> str:
    """A title as it is compared: signs like ASCII, single blanks."""
    return " ".join(units.like_ascii(title).split())


def parts(title: str) -> list[tuple[str, str]]:
    """Name and unit, in every way that a title can be read; the last way has no unit."""
    found = []
    for match in reversed(list(_BRACKETED.finditer(title))):
        name = (title[: match.start()] + title[match.end() :]).strip()
        if match[1] and name:
            found.append((name, match[1]))
    if bracketed(title) and bare(title):
        found.append((bare(title), bracketed(title)))
    if not found:
        found = [(pair[1], pair[2]) for pattern in (*_MARKED, _LAST) if (pair := pattern.fullmatch(title))]
        pieces = title.split("_")
        found += [("_".join(pieces[:i]), "_".join(pieces[i:]).replace("_per_", "/")) for i in range(1, len(pieces))]
    return [*dict.fromkeys(found), (title, "")]


def _within(title: str, dimension: Dimension) -> Iterator[tuple[str, str]]:
    """Name and unit of titles with a usual unit between other words, such as "Defl_nm_Ex"."""
    pieces = title.split("_")
    usual = {name for name, _ in dimension.practical}
    for i in range(1, len(pieces) - 1):
        if pieces[i] in usual:
            yield "_".join([*pieces[:i], *pieces[i + 1 :]]), pieces[i]


def read_title(title: str, dimension: Dimension) -> tuple[str, str | None]:
    """The name of a column, and its unit if that is one of this dimension; "" for plain numbers."""
    for name, unit in [*parts(title)[:-1], *_within(title, dimension)]:
        try:
            units.factor(unit, dimension)
        except UnitError:
            continue
        return name, unit
    return title, None if dimension.si else ""


def unit_in(title: str) -> tuple[str, str] | None:
    """Name and unit of any dimension, where brackets or a sign separate them."""
    marked = [pair for pair in parts(title)[:-1] if "_" not in title or _BRACKETED.search(title)]
    return next(((name, unit) for name, unit in marked if units.is_any_unit(unit)), None)


def bare(title: str) -> str:
    """The name of a title whose unit is given elsewhere: without what is in brackets at its end."""
    match = _WHOLE.fullmatch(title)
    return match[1] if match else title


def bracketed(title: str) -> str:
    """The text in brackets at the end of a title."""
    match = _WHOLE.fullmatch(title)
    return match[2] if match else ""


def is_one_of(name: str, aliases: Sequence[str]) -> bool:
    """Whether a name is one of these, with or without the symbol of the quantity."""
    plain = " ".join(name.lower().split())
    spaced = " ".join(plain.replace("_", " ").split())
    tries = {plain, spaced}
    for pattern in (_OF_PROGRAM, _DIRECTION, _OF_PROGRAM, _SYMBOL):
        tries |= {match[1].strip(" ,_") for one in tries if (match := pattern.fullmatch(one))}
    return not tries.isdisjoint(aliases)


def is_measured(title: str) -> bool:
    """Whether a title names a measured quantity, or has a unit in brackets."""
    match = _WHOLE.fullmatch(title)
    name, unit = (match[1], match[2]) if match else (title, "")
    return bool(unit and units.is_any_unit(unit)) or any(name.lower() in names for _, names in ROLES.values())


def are_symbols(cells: Sequence[str]) -> bool:
    """Whether all of several words are names of columns: F, h and t are no farads, hours and tonnes."""
    names = {name for _, aliases in ROLES.values() for name in aliases}
    return len(cells) > 1 and all(cell.lower() in names for cell in cells)
