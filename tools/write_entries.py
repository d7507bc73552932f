# SPDX-License-Identifier: GPL-3.0-or-later
"""The C side of the functions of the header, for generate.py.

Where Fortran defines mdrcontact_entry_x, the function mdr_x refuses what the header says must not be: a negative count, and a
pointer that is NULL where its @param does not speak of NULL. Handles and structures that begin with their size are looked at when
they are opened. Then it sets the arithmetic of the library, calls the entry, and sets the caller's arithmetic again. Functions that
do not compute, or take nanoseconds, have no such entry: they are defined under their own names.
"""

import re

from wrap_header import PROTOTYPE

LONGEST_LINE = 132
TOP = """/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of {header} that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "{header}"
#include "refuse.h"
"""
COUNTS = ("n", "m", "capacity")


def folded(line):
    """A line of C, broken after commas where it is too long."""
    lines = [""]
    for part in re.split(r"(?<=, )", line):
        if len(lines[-1] + part.rstrip()) > LONGEST_LINE:
            lines.append("        ")
        lines[-1] += part
    return [line.rstrip() for line in lines]


def name_of(words):
    """The name of an argument."""
    return re.fullmatch(r".*?(\w+)(\[\d*\])?", words)[1]


def refusals(arguments, said, opened):
    """The lines that refuse counts and pointers. `said` is what the header says of each argument; `opened` are the types that are
    looked at later."""
    lines, names = [], [name_of(words) for words in arguments]
    lengths = {name for words, name in zip(arguments, names, strict=True) if words == f"int {name}"}
    for words, name in zip(arguments, names, strict=True):
        kind, stars = re.fullmatch(r"(?:const )?(\w+) ?(\**).*", words).groups()
        if name in lengths and name in COUNTS:
            # room may be larger than what is written; loops over more entries would end beyond the range of int
            most = "" if name == "capacity" else f" || {name} > MDRCONTACT_MOST_ENTRIES"
            lines.append(f'    if ({name} < 0{most}) return mdrcontact_refuse_count("{name}", {name});')
        if not (stars or "[" in words) or (kind in opened and stars == "*") or "NULL" in said[name]:
            continue
        size = re.search(r"\[.*?\]", said[name])
        length = next((word for word in re.findall(r"\w+", size[0]) if word in lengths), None) if size else None
        condition = f"{length} > 0 && " if length else ""
        lines.append(f'    if ({condition}!{name}) return mdrcontact_refuse_null("{name}");')
    return lines


def entry(result, name, arguments, checks):
    """Both declarations and the body."""
    inner = name.replace("mdr_", "mdrcontact_entry_", 1)
    taken = ", ".join(arguments)
    call = f"{inner}({', '.join(map(name_of, arguments))});"
    lines = [f"{result} {inner}({taken});", f"{result} {name}({taken})", "{", *checks]
    lines += [f"    if (arithmetic_is_set()) return {call}"]
    lines += ["    fenv_t callers;", "    mdrcontact_set_arithmetic(&callers);", f"    const {result} status = {call}"]
    lines += ["    mdrcontact_set_arithmetic_back(&callers);", "    return status;", "}", ""]
    return [part for line in lines for part in folded(line)]


def entries(headers, sources):
    """The lines of each file by its name, api/entries.c of the core and one of each extension, from the headers' texts by their
    names and the Fortran of api/."""
    everything = "".join(headers.values())
    defined = set(re.findall(r'name="mdrcontact_entry_(\w+)"', sources))
    opened = set(re.findall(r"typedef struct (\w+) \1;", everything))
    opened |= set(re.findall(r"typedef struct (\w+) \{\s*size_t size;", everything))
    files = {}
    for header, text in headers.items():
        extension = re.fullmatch(r"mdrcontact/(\w+)\.h", header)
        name = f"{extension[1]}_entries.c" if extension else "entries.c"
        files[name] = entries_of(header, text, defined, opened)
    if defined:
        raise SystemExit(f"the headers have no {', '.join(sorted(defined))}")
    return files


def entries_of(header, text, defined, opened):
    """The lines of one file; takes its functions out of those that are defined."""
    lines = TOP.format(header=header).split("\n")
    parts = re.split(r"/\*\*(.*?)\*/", text, flags=re.DOTALL)
    for words, code in zip(parts[1::2], parts[2::2], strict=True):
        for result, name, taken in PROTOTYPE.findall(code):
            if name.removeprefix("mdr_") not in defined:
                continue
            defined.remove(name.removeprefix("mdr_"))
            arguments = [" ".join(word.split()) for word in taken.split(",")]
            said = dict(re.findall(r"@param (\w+)\s+(.*?)(?=\n \*  @|\Z)", words, flags=re.DOTALL))
            lines += entry(result.strip(), name, arguments, refusals(arguments, said, opened))
    return lines[:-1]
