# SPDX-License-Identifier: GPL-3.0-or-later
"""The C side of the functions of the header, for generate.py.

Where Fortran defines mdrcontact_entry_x, the function mdr_x sets the arithmetic of the library, calls it, and sets the caller's
arithmetic again. Functions that do not compute, or take nanoseconds, have no such entry: they are defined under their own names.
"""

import re

from wrap_header import prototypes

LONGEST_LINE = 132
TOP = """/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../arithmetic.h"
#include "mdrcontact.h"
"""


def folded(line):
    """A line of C, broken after commas where it is too long."""
    lines = [""]
    for part in re.split(r"(?<=, )", line):
        if len(lines[-1] + part.rstrip()) > LONGEST_LINE:
            lines.append("        ")
        lines[-1] += part
    return [line.rstrip() for line in lines]


def entry(result, name, words):
    """Both declarations and the body."""
    inner = name.replace("mdr_", "mdrcontact_entry_", 1)
    names = ", ".join(re.fullmatch(r".*?(\w+)(\[\d*\])?", word)[1] for word in words)
    taken = ", ".join(words)
    call = f"{inner}({names});"
    lines = [f"{result} {inner}({taken});", f"{result} {name}({taken})", "{", f"    if (arithmetic_is_set()) return {call}"]
    lines += ["    fenv_t callers;", "    mdrcontact_set_arithmetic(&callers);", f"    const {result} status = {call}"]
    lines += ["    mdrcontact_set_arithmetic_back(&callers);", "    return status;", "}", ""]
    return [part for line in lines for part in folded(line)]


def entries(text, sources):
    """The lines of api/entries.c, from the header and the Fortran of api/."""
    defined = set(re.findall(r'name="mdrcontact_entry_(\w+)"', sources))
    functions = prototypes(text)
    unknown = defined - {name.removeprefix("mdr_") for _, name, _ in functions}
    if unknown:
        raise SystemExit(f"the header has no {', '.join(sorted(unknown))}")
    lines = [line for function in functions if function[1].removeprefix("mdr_") in defined for line in entry(*function)]
    return TOP.split("\n") + lines[:-1]
