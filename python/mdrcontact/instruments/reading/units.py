# SPDX-License-Identifier: GPL-3.0-or-later
"""Units as instruments write them, in the spelling that the library reads."""

from __future__ import annotations

import re
from functools import lru_cache

from ..._units import LENGTH, Dimension, UnitError, is_unit, to_si

_MICRO = re.compile(
    # as UTF-8, Shift-JIS and GBK show it where they are read as Latin-1
    "\xc2\xb5|\xce\xbc|\u0192\xca|\xa6\xcc|[\N{MICRO SIGN}\N{GREEK SMALL LETTER MU}]"
    # as code page 437 and ISO 8859-7 do, and as a lost character, where a unit follows
    "|(?<![^\\W_])[\xe6\xec\N{REPLACEMENT CHARACTER}](?=[NmsVJ](?![^\\W\\d_]))"
)
"""The sign of micro, in both code points and in encodings that are taken for others."""
_SPELLINGS = (
    (_MICRO, "u"),
    (re.compile("\xc2(?=[\N{SUPERSCRIPT TWO}\N{SUPERSCRIPT THREE}\N{DEGREE SIGN}\xa0])"), ""),
    (re.compile("\N{SUPERSCRIPT MINUS}"), "-"),
    (re.compile("(?<=[\\w)\\]])(-?[\N{SUPERSCRIPT ONE}\N{SUPERSCRIPT TWO}\N{SUPERSCRIPT THREE}])"), r"^\1"),
    (re.compile("\N{SUPERSCRIPT ONE}"), "1"),
    (re.compile("\N{SUPERSCRIPT TWO}"), "2"),
    (re.compile("\N{SUPERSCRIPT THREE}"), "3"),
    (re.compile("[\N{MINUS SIGN}\N{NON-BREAKING HYPHEN}]"), "-"),
    (re.compile("[\N{MIDDLE DOT}\N{DOT OPERATOR}\N{MULTIPLICATION SIGN}]"), "*"),
    (re.compile("\N{DIVISION SLASH}"), "/"),
    (re.compile("\N{ANGSTROM SIGN}|A\N{COMBINING RING ABOVE}"), "\N{LATIN CAPITAL LETTER A WITH RING ABOVE}"),
    (re.compile("[\xa0\N{THIN SPACE}\N{NARROW NO-BREAK SPACE}]"), " "),
    (re.compile("\N{RIGHT SINGLE QUOTATION MARK}"), "'"),
)
_WORDS = {
    **dict.fromkeys(("kp", "kilopond"), "kgf"),
    **dict.fromkeys(("Ang", "ang", "Angstrom", "Angstroms", "angstroms", "\N{LATIN CAPITAL LETTER A WITH RING ABOVE}"), "angstrom"),
    **dict.fromkeys(("Sec", "SEC", "seconds", "Seconds", "secs", "Sek", "Sek.", "sek"), "s"),
    **dict.fromkeys(("Micron", "Microns", "Mikron", "mikron"), "um"),
    **dict.fromkeys(("Newton", "Newtons", "newtons"), "N"),
    **dict.fromkeys(("Volt", "Volts", "volts"), "V"),
    **{"MPA": "MPa", "GPA": "GPa", "Gpa": "GPa", "Mpa": "MPa", "KPa": "kPa"},
}
"""Spellings of single units that the registry of units does not have, or takes for others."""
_PARTS = re.compile(r"[^\W\d_]+\.?")
_POWER = re.compile(r"(?<![\w^*-])([^\W\d_]+)(-?[1-4])(?![\w.])")


def like_ascii(text: str) -> str:
    """Replace typographic variants of signs in titles, units and words by plain ones."""
    if text.isascii():
        return text
    for pattern, sign in _SPELLINGS:
        text = pattern.sub(sign, text)
    return text


@lru_cache(maxsize=1000)
def spelled(unit: str) -> str:
    """A unit in the spelling of the library: "kp/mm2" is "kgf/mm^2"; others stay as they are."""
    # a question mark stands for a sign that was lost
    unit = re.sub(r"^\?(?=[NmsVJ]$)", "u", like_ascii(unit).strip())
    if not unit or is_unit(unit) and unit not in _WORDS:
        return unit
    known = _PARTS.sub(lambda part: _WORDS.get(part[0], part[0]), unit)
    known = _POWER.sub(r"\1^\2", known.replace("**", "^"))
    return known if is_unit(known) else unit


def is_any_unit(text: str) -> bool:
    """Whether a text is a unit of anything, however it is spelled."""
    return is_unit(spelled(text))


def factor(unit: str, dimension: Dimension) -> float:
    """How many SI units of `dimension` one `unit` is; `UnitError` if it is not one of these."""
    known = spelled(unit)
    try:
        return to_si(1.0, known, dimension)
    except UnitError:
        # as a length no ampere is meant
        if known != "A" or dimension != LENGTH:
            raise
        return to_si(1.0, "angstrom", dimension)
