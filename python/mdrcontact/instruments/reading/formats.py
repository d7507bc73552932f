# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats of instruments: facts in their headers, and unsupported files with instructions for their export."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from ..._units import COMPLIANCE, LENGTH, MODULUS, SENSITIVITY, SPEED, STIFFNESS, Dimension, shown
from ...problem.named import ProblemError
from .area_function import dimension_of_term, find_terms


class Fact(NamedTuple):
    """A property of the instrument that a file states, SI units."""

    name: str
    """"indenter.radius", "spring_constant", or a description"""
    value: float
    dimension: Dimension

    def __str__(self) -> str:
        return f"{self.name} {shown(self.value, self.dimension)}"


_NUMBER = r"\s*:?\s*([-+]?[0-9]+(?:[.,][0-9]+)?(?:[eE][-+]?[0-9]+)?)"
_TERM = "indenter.C"
MODULUS_OF_MAKER = "modulus by the maker's program"


class Format(NamedTuple):
    """A format of text files, recognised by a line of its header."""

    name: str
    sign: str
    """pattern of such a line"""
    units: Mapping[str, str] = {}
    """of columns whose titles do not state them"""
    numbers: tuple[tuple[str, str, float, Dimension], ...] = ()
    """name, pattern before the number, its unit in SI, dimension"""

    def facts(self, header: Sequence[Sequence[str]]) -> tuple[Fact, ...]:
        """The facts in the header."""
        lines = [" ".join(row) for row in header]
        found = []
        for name, pattern, unit, dimension in self.numbers:
            match = next((m for line in lines if (m := re.search(pattern + _NUMBER, line))), None)
            value = float(match[1].replace(",", ".")) if match else 0.0
            if value:
                found.append(Fact(name, value * unit, dimension))
        return (*found, *tip_facts(header))


def tip_facts(header: Sequence[Sequence[str]]) -> tuple[Fact, ...]:
    """The area function of the tip, "indenter.C0" and so on."""
    return tuple(Fact(f"{_TERM}{i}", term, dimension_of_term(i)) for i, term in enumerate(find_terms(header)))


def terms_of(facts: Sequence[Fact]) -> dict[int, float]:
    """The area function among facts: terms by their number, SI units."""
    return {int(fact.name[len(_TERM) :]): fact.value for fact in facts if fact.name.startswith(_TERM)}


FORMATS = (
    Format(
        "Optics11",
        r"Tip radius \(um\)",
        numbers=(
            ("indenter.radius", r"Tip radius \(um\)", 1e-6, LENGTH),
            ("spring_constant", r"^k \(N/m\)", 1.0, STIFFNESS),
            (MODULUS_OF_MAKER + ", E_eff", r"E\[eff\] \(Pa\)", 1.0, MODULUS),
            ("position x", r"X-position \(um\)", 1e-6, LENGTH),
            ("position y", r"Y-position \(um\)", 1e-6, LENGTH),
        ),
    ),
    Format(
        "Fischer WIN-HCU",
        r"\.hap\b",
        units={"F": "mN", "h": "um", "t": "s"},
        numbers=((MODULUS_OF_MAKER + ", EIT/(1-vs^2)", r"EIT/\(1-vs\^2\) \[GPa\]", 1e9, MODULUS),),
    ),
    Format(
        "Hysitron .hld",
        r"File Version: Hysitron",
        numbers=(
            ("frame compliance", r"Machine Comp:", 1e-3, COMPLIANCE),
            ("drift rate", r"Drift Rate:", 1e-9, SPEED),
        ),
    ),
    Format("Hysitron text", r"Number of Points ="),
    Format(
        "NanoScope text",
        r"^\\\*Force file list|Calc_Ramp_Ex",
        numbers=(
            ("spring_constant", r"\\Spring Constant", 1.0, STIFFNESS),
            ("deflection_sensitivity", r"\\@Sens\. DeflSens: V", 1e-9, SENSITIVITY),
        ),
    ),
    Format(
        "JPK text",
        r"fancyNames:",
        numbers=(
            ("spring_constant", r"springConstant", 1.0, STIFFNESS),
            ("deflection_sensitivity", r"^sensitivity", 1.0, SENSITIVITY),
        ),
    ),
)


def recognise(header: Sequence[Sequence[str]]) -> Format | None:
    """The format of a table, by the lines above it."""
    lines = [" ".join(row) for row in header]
    return next((one for one in FORMATS if any(re.search(one.sign, line) for line in lines)), None)


class _Foreign(NamedTuple):
    """Unsupported files: endings or first bytes, name and remedy."""

    name: str
    suffixes: str
    begins: tuple[bytes, ...]
    remedy: str


_FOREIGN = (
    _Foreign(
        "a NanoScope file of Bruker",
        r"\.(spm|pfc|[0-9]{3})",
        (b"\\*File list", b"\\*Force file list", b"\\*EC File list"),
        "export the force curve as text in NanoScope Analysis, File > Export > ASCII, with Z or separation and force in units",
    ),
    _Foreign(
        "a binary file of Hysitron", r"\.(hys|hdt)", (), "export it as text in TriboScan or TriboAnalysis, File > Export, as .txt"
    ),
    _Foreign("a binary file of Fischer", r"\.hap", (), "export it as text in WIN-HCU, all blocks with F, h and t"),
    _Foreign("a binary file of NanoSuite", r"\.(nmd|mss|mst)", (), "export the sample to Excel in NanoSuite, with all tests"),
    _Foreign(
        "an HDF5 file",
        r"\.(hdf5|hdf|nxs)",
        (b"\x89HDF\r\n",),
        "of HDF5 only force curves that afmformats wrote are read, under the name .h5; export depth, force and time as text",
    ),
    _Foreign("an archive", r"\.(zip|gz|7z|rar)", (b"PK\x03\x04", b"\x1f\x8b"), "unpack it, and give the folder of its files"),
)


def refuse_foreign(path: Path, content: bytes) -> None:
    """Raise an error for a file of an unsupported format, with instructions for its export."""
    for one in _FOREIGN:
        is_named = re.fullmatch(one.suffixes, path.suffix.lower()) and (not one.begins or b"\0" in content[:4096])
        # a header may precede numbers in text
        if is_named or one.begins and content.startswith(one.begins) and b"\0" in content:
            raise ProblemError(f"{path}: {one.name} is not read: {one.remedy}")
