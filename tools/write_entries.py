# SPDX-License-Identifier: GPL-3.0-or-later
"""The C side of the functions of the header, for generate.py.

Each function mdr_x sets the arithmetic of the library, calls mdrcontact_entry_x, which Fortran defines, and sets the caller's
arithmetic again. Functions that do not compute, or take nanoseconds, are left to themselves.
"""

import re

from wrap_header import prototypes

# Functions without computation, and states of laws: under another rounding mode these differ in the last digits.
DIRECT = re.compile(
    r"mdr_(version|status_name|last_error|last_failure|set_\w+|free|model_(name|from_name|info)"
    r"|law_(force|values|follow|conductance)|loop_points)"
)
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


def entry(name, words):
    """Both declarations and the body."""
    inner = name.replace("mdr_", "mdrcontact_entry_", 1)
    names = ", ".join(re.fullmatch(r".*?(\w+)(\[\d*\])?", word)[1] for word in words)
    taken = ", ".join(words)
    call = f"{inner}({names});"
    lines = [f"int {inner}({taken});", f"int {name}({taken})", "{", f"    if (arithmetic_is_set()) return {call}"]
    lines += ["    fenv_t callers;", "    mdrcontact_set_arithmetic(&callers);", f"    const int status = {call}"]
    lines += ["    mdrcontact_set_arithmetic_back(&callers);", "    return status;", "}", ""]
    return [part for line in lines for part in folded(line)]


def entries(text):
    """The lines of api/entries.c."""
    functions = [(name, words) for result, name, words in prototypes(text) if result == "int"]
    lines = [line for name, words in functions if not DIRECT.fullmatch(name) for line in entry(name, words)]
    return TOP.split("\n") + lines[:-1]
