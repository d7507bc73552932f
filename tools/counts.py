#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes of the project, one line each: counts.py [ROOT].

Rooms, functions of the C headers, lines by hand, statements of the Fortran sources, names of the Python package. Files headed
"Written by tools" count as generated.
"""

import re
import subprocess
import sys
from pathlib import Path

BESIDE = ("instruments", "app", "panels", "validation")
PROTOTYPE = re.compile(r"^[a-z][\w ]*[ *]mdr_\w+\(", re.MULTILINE)
OTHER = re.compile(
    r"(use|implicit|private|public|import|include|contains|procedure|generic|final|interface|abstract|module|submodule|subroutine"
    r"|function|program|type|class|integer|real|complex|logical|character|double|enum|enumerator|end|pure|impure|elemental|recursive"
    r"|external|intrinsic|save|parameter)\b",
    re.IGNORECASE,
)
"""First words of declarations, and of heads and ends of procedures and constructs."""
BRANCH = re.compile(r"(type|class) is\b|class default|end (if|do|select|associate|where|block)|endif|enddo", re.IGNORECASE)
"""Statements that begin with such a word; the ends of constructs are theirs."""
DECLARED = re.compile(r"^(type|class|integer|real|complex|logical|character)\b.*=", re.IGNORECASE)


def is_generated(text: str) -> bool:
    return "Written by tools" in text[:600]


def statements(text: str) -> int:
    """Lines of a Fortran file that are no declaration, use, blank, comment, or head or end of a procedure."""
    count, goes_on = 0, None
    for line in text.splitlines():
        code = line.strip()
        if not code or code.startswith("!"):
            continue
        counted = bool(BRANCH.match(code)) or not OTHER.match(code) if goes_on is None else goes_on
        count += counted
        goes_on = counted if code.split("!")[0].rstrip().endswith("&") else None
    return count


def lines(paths: list[Path]) -> int:
    return sum(len(path.read_text(encoding="utf-8").splitlines()) for path in paths)


def by_hand(folder: Path) -> list[Path]:
    paths = [path for path in folder.rglob("*") if path.suffix in (".f90", ".c", ".h")]
    return [path for path in paths if not is_generated(path.read_text(encoding="utf-8"))]


def functions(header: Path, seen: set[Path]) -> int:
    """Those that a header declares with all that it includes."""
    if header in seen or not header.exists():
        return 0
    seen.add(header)
    text = header.read_text(encoding="utf-8")
    parts = [header.parent / name for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)]
    return len(PROTOTYPE.findall(text)) + sum(functions(part.resolve(), seen) for part in parts)


def names(package: Path) -> int:
    """Length of `__all__`."""
    code = f"import sys; sys.path.insert(0, {str(package.parent)!r}); import mdrcontact; print(len(mdrcontact.__all__))"
    return int(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout)


def main(root: Path) -> None:
    source, package = root / "src" / "mdrcontact", root / "python" / "mdrcontact"
    entries = list(source.iterdir())
    fortran = [*source.rglob("*.f90"), root / "src" / "mdrcontact.f90"]
    counted = sum(statements(path.read_text(encoding="utf-8")) for path in fortran)
    python = [path for path in package.rglob("*.py") if path.relative_to(package).parts[0] not in BESIDE]
    headers = root / "include"
    for name, value in {
        "folders at the top of src/mdrcontact": sum(path.is_dir() for path in entries),
        "files at the top of src/mdrcontact": sum(path.is_file() for path in entries),
        "lines by hand in src": lines(by_hand(root / "src")),
        "lines by hand in src/mdrcontact/api": lines(by_hand(source / "api")),
        "lines of Fortran": lines(fortran),
        "statements of Fortran [%]": round(100 * counted / lines(fortran), 1),
        "functions of mdrcontact.h": functions(headers / "mdrcontact.h", set()),
        "functions of mdrcontact/all.h": functions(headers / "mdrcontact" / "all.h", set()),
        "names of mdrcontact": names(package),
        f"lines of Python without {', '.join(BESIDE)}": lines(python),
    }.items():
        print(f"{value:8}  {name}")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1])
