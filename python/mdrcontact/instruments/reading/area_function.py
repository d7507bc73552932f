# SPDX-License-Identifier: GPL-3.0-or-later
"""The area function of a tip, A = C0 h^2 + C1 h + C2 h^(1/2) + ..., as headers of instruments state it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from ..._units import RATIO, Dimension
from .numerals import number, with_points

_SIGN = r"[-+\u2212]?"
_TERM = re.compile(
    r"(?<![^\W_])(?:tip[\s_]*|area[\s_]*)?(?:coefficients?|coeff\.?|constants?)?[\s_]*C[\s_]?([0-8])(?!\w)[\s:=(\[\])]*"
    rf"({_SIGN}(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE]{_SIGN}[0-9]+)?)(?![\w.]|,\d)\s*([^\s,;]*)",
    re.IGNORECASE,
)
"""A term such as "Tip C1: 1234.5 nm^2/nm" or "C0 = 24.5"."""
_NAME = re.compile(r"(?:tip[\s_]*|area[\s_]*)?C[\s_]?([0-8])", re.IGNORECASE)
_OF_TIP = re.compile(r"\b(?:tip|area|indenter)\b.*C[\s_]?0", re.IGNORECASE)
_SHARPEST, _BLUNTEST = 0.1, 1000.0
"""C0 of tips: a cube corner has 2.6, a blunt cone of 170 degrees 410."""
_UNITS = {"u": 1e-6, "m": 1e-3}
"""Units of coefficients that are not in nm, by prefix."""


def dimension_of_term(i: int) -> Dimension:
    """The dimension of C_i."""
    power = 2.0 - power_of_term(i)
    if power == 0.0:
        return RATIO
    unit = "nm" if power == 1.0 else f"nm^{power:g}"
    return Dimension("a coefficient of an area function", f"m^{power:g}", f"1 {unit}", ((unit, 10.0 ** (-9.0 * power)),))


def power_of_term(i: int) -> float:
    """The power of h in the term of C_i."""
    return 2.0 if i == 0 else 0.5 ** (i - 1)


def find_terms(lines: Sequence[Sequence[str]]) -> list[float]:
    """C0, C1, ... in SI units, up to the last that is not 0; empty if the lines contain no area function."""
    found: dict[int, float] = {}
    for i, value, unit in (*_in_words(lines), *_in_rows(lines)):
        length = next((size for sign, size in _UNITS.items() if re.match(rf"{sign}m\b", unit)), 1e-9)
        found.setdefault(i, value * length ** (2.0 - power_of_term(i)))
    terms = [found[i] for i in range(len(found)) if i in found]
    if len(terms) < len(found) or not terms or not _SHARPEST <= terms[0] <= _BLUNTEST:
        return []
    if len(terms) == 1 and not any(_OF_TIP.search(" ".join(line)) for line in lines):
        return []
    while not terms[-1]:
        terms.pop()
    return terms


def _in_words(lines: Sequence[Sequence[str]]) -> Iterator[tuple[int, float, str]]:
    """Terms whose values follow their names."""
    for line in lines:
        for match in _TERM.finditer(" ".join(line)):
            yield int(match[1]), _value(match[2]), match[3]


def _in_rows(lines: Sequence[Sequence[str]]) -> Iterator[tuple[int, float, str]]:
    """Terms whose values are in the row below their names."""
    for names, values in zip(lines[:-1], lines[1:], strict=True):
        for name, value in zip(names, values, strict=False):
            match = _NAME.fullmatch(name.strip())
            if match and _value(value) == _value(value):
                yield int(match[1]), _value(value), ""


def _value(text: str) -> float:
    (text,) = [text] if "." in text else with_points([text])
    return number(text.replace("\u2212", "-"))


def area(terms: Mapping[int, float], height: float) -> float:
    """A(h) of terms in SI units."""
    return float(sum(term * height ** power_of_term(i) for i, term in terms.items()))
