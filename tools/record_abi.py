#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Record the binary interface of a release: record_abi.py [--breaks].

Writes tests/c/test_abi.c from the C headers: prototypes, layouts of structures, values of enumerations. The test `c_abi` compares
each later library with it. Additions are recorded. What a recorded program uses must remain: the tool stops with status 1 if a
declaration has changed or is gone, unless --breaks is given, which is right only for a version that is not published or with a
new minor version.
"""

import ctypes
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "python" / "src"), str(ROOT / "tools")]
from generate import INCLUDE, versions  # noqa: E402
from wrap_header import PROTOTYPE, parts_of  # noqa: E402

RECORD = ROOT / "tests" / "c" / "test_abi.c"
KINDS = {
    "size_t": ctypes.c_size_t,
    "int": ctypes.c_int,
    "double": ctypes.c_double,
    "char": ctypes.c_char,
    "uint64_t": ctypes.c_uint64,
}
HEAD = """\
/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The binary interface of the last release, written by tools/record_abi.py. Programs compiled against that release no longer run
   if a declaration or an assertion does not compile, or if the linker or dlvsym does not find a function. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <stdio.h>

#include "mdrcontact/all.h"
#include "mdrcontact_law.h"
#ifdef MDRCONTACT_PLASTIC_H
#  include "mdrcontact_plastic_law.h"
#endif

#define EXACT(type, bytes) _Static_assert(sizeof(type) == (bytes), #type)
#define GROWS(type, bytes) _Static_assert(sizeof(type) >= (bytes), #type)
#define MEMBER(type, member, place, kind) \\
    _Static_assert(offsetof(type, member) == (place) && _Generic(&((type *)0)->member, kind: 1, default: 0), #type "." #member)
#define VALUE(name, value) _Static_assert((name) == (value), #name)
"""
# Functions by their addresses, and on glibc by the version with which a program was linked.
MAIN = """\
static const struct {
    const char *name, *version;
    void (*address)(void);
} functions[] = {
TABLE
};

int main(void)
{
    const int n = (int)(sizeof functions / sizeof *functions);
    int missing = 0;
    for (int i = 0; i < n; ++i) {
        int is_there = functions[i].address != NULL;
#ifdef __GLIBC__
        is_there = is_there && dlvsym(RTLD_DEFAULT, functions[i].name, functions[i].version);
#endif
        if (!is_there) printf("missing: %s, version %s\\n", functions[i].name, functions[i].version);
        missing += !is_there;
    }
    printf("%d of %d functions, missing: %d\\n", n - missing, n, missing);
    return missing != 0;
}
"""


def members_of(body):
    """Return type, name and length of each member of a structure."""
    found = []
    for words in body.split(";")[:-1]:
        kind, rest = re.fullmatch(r"((?:const )?(?:struct )?\w+) (.*)", " ".join(words.split())).groups()
        for word in rest.split(","):
            stars, member, length = re.fullmatch(r"(\**)(\w+)(?:\[(\d+)\])?", word.strip()).groups()
            found.append((f"{kind} {stars}", member, length))
    return found


def structure(name, body):
    """Return the size of a structure, which may grow if it begins with its size, and the place and type of each member."""
    members, fields = members_of(body), []
    for kind, member, length in members:
        plain = ctypes.c_void_p if "*" in kind else KINDS[kind.strip()]
        fields.append((member, plain * int(length) if length else plain))
    native = KINDS[name] = type(name, (ctypes.Structure,), {"_fields_": fields})
    lines = [f"{'GROWS' if members[0][1] == 'size' else 'EXACT'}({name}, {ctypes.sizeof(native)});"]
    for kind, member, length in members:
        address = f"{kind}(*)[{length}]" if length else f"{kind}*"
        lines.append(f"MEMBER({name}, {member}, {getattr(native, member).offset}, {address});")
    return lines


def declarations(header):
    """Return what a header declares, one declaration a line, and the names of its functions."""
    text = re.sub(r"/\*.*?\*/", "", header.read_text(encoding="utf-8"), flags=re.DOTALL)
    lines = [" ".join(words.split()) for words in re.findall(r"^typedef (?!struct \w+ \{)[^;{}]*;", text, flags=re.MULTILINE)]
    for body in re.findall(r"enum \w+ \{(.*?)\}", text, flags=re.DOTALL):
        lines += [f"VALUE({name}, {value});" for name, value in re.findall(r"(MDR_\w+) = (\d+)", body)]
    lines += [
        f"VALUE((long long){name}, {value});" for name, value in re.findall(r"#define (MDR_\w+) (\d+)\.0$", text, re.MULTILINE)
    ]
    for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", text, flags=re.DOTALL):
        lines += structure(name, body)
    functions = PROTOTYPE.findall(text)
    lines += [f"{result}{name}({' '.join(words.split())});" for result, name, words in functions]
    return lines, [name for _, name, _ in functions]


def guarded(header, lines):
    """Return lines that are compiled if the library has the header."""
    guard = re.search(r"#ifndef (\w+)", header.read_text(encoding="utf-8"))[1]
    return [f"#ifdef {guard}", *lines, "#endif"] if lines else []


def kept(lines):
    """Return the lines that a later record must contain; structures that begin with their size may grow."""
    return {line.partition(", ")[0] if line.startswith("GROWS") else line for line in lines if line.endswith(";")}


def main(words):
    """See the top of this file."""
    recorded, table, since = [], [], versions()
    inline = [INCLUDE / "mdrcontact_law.h", INCLUDE / "mdrcontact_plastic_law.h"]
    for header in [*parts_of(INCLUDE / "mdrcontact" / "all.h"), *inline]:
        lines, names = declarations(header)
        recorded += guarded(header, lines)
        table += guarded(header, [f'    {{"{name}", "MDR_{since[name]}", (void (*)(void)){name}}},' for name in names])
    text = "\n".join([HEAD, *recorded, "", MAIN.replace("TABLE", "\n".join(table))])
    before = RECORD.read_text(encoding="utf-8") if RECORD.exists() else ""
    gone = kept(before.splitlines()) - kept(text.splitlines())
    if gone and "--breaks" not in words:
        raise SystemExit("\n".join([f"{len(gone)} recorded declarations have changed or are gone:", *sorted(gone)]))
    RECORD.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
