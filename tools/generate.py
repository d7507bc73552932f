# SPDX-License-Identifier: GPL-3.0-or-later
"""All that follows from the C headers and lies in the repository: generate.py [ROOT].

From include/mdrcontact.h and the headers of extensions: the codes and the structures for Fortran; the functions that set the
library's arithmetic, and the procedures that open handles, in a file of the core and one of each extension; the symbols of the
shared library with their versions; and for Python the module's types and layout. ROOT, the repository if none is given, is where
they go. Building the library needs none of this; a file that is up to date is left alone.
"""

import os
import re
import sys
import textwrap
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(REPOSITORY / "python" / "src"), str(REPOSITORY / "tools")]
from wrap_header import (  # noqa: E402
    PROTOTYPE,
    described,
    functions_of,
    layout,
    parts_of,
    structures,
    type_hints,
    with_parts,
    without_comments,
    write,
)
from write_entries import entries  # noqa: E402
from write_fortran_entries import fortran_entries  # noqa: E402
from write_open_handle import open_handles  # noqa: E402

INCLUDE = REPOSITORY / "include"
API = REPOSITORY / "src" / "mdrcontact" / "api"
LONGEST_LINE = 132
SPDX = "! SPDX-License-Identifier: GPL-3.0-or-later"
# Declaration of a member, and its value in a new structure: 0, the default of everything.
FORTRAN = {
    "size_t": ("integer(c_size_t)", "0_c_size_t"),
    "int": ("integer(c_int)", "0_c_int"),
    "double": ("real(c_double)", "0.0_c_double"),
    "address": ("type(c_ptr)", "c_null_ptr"),
    "char": ("character(kind=c_char)", "c_null_char"),
}
# Enumerations whose numbers are no codes: bits of a sum, a format, places in an array.
NO_CODES = {"mdr_warning", "mdr_law_format", "mdr_fit_instrument"}
# Words that the names of the statuses do not give.
STATUS_WORDS = {"ENOCONVERGENCE": "no-convergence", "ENOMEMORY": "no-memory"}
WORD_OF = """\
    !> Name of a code, the same in all languages and problem files; empty for a number that is not a code.
    pure function word_of(code) result(word)
        !> of any enumeration
        integer, intent(in) :: code
        character(len=len(words)) :: word
        integer :: place

        word = ""
        place = findloc(numbers, code, dim=1)
        if (place > 0) word = words(place)
    end function word_of

    !> The codes of the enumeration that a code belongs to; none for a number that is no code.
    pure function codes_beside(code) result(codes)
        integer, intent(in) :: code
        integer, allocatable :: codes(:)

        codes = pack(numbers, numbers - modulo(numbers, 100) == code - modulo(code, 100) .and. any(numbers == code))
    end function codes_beside"""
SINCE = re.compile(r"@since (\d+\.\d+)")


def folded(words, names):
    """`public :: a, b, ...` over as many lines as it takes."""
    lines = [words]
    for i, name in enumerate(names):
        word = f" {name}" + "," * (i + 1 < len(names))
        if len(lines[-1] + word) + 2 > LONGEST_LINE:
            lines[-1] += " &"
            lines.append(" " * len(words))
        lines[-1] += word
    return lines


def enumerations_of(headers):
    """Names, without MDR_, values and meanings of the members of each enumeration."""
    member = r"MDR_(\w+) = (\d+),?(?:\s*/\*\*<(.*?)\*/)?"
    found = re.findall(r"enum (\w+) \{(.*?)\};", headers, flags=re.DOTALL)
    return {name: re.findall(member, body, flags=re.DOTALL) for name, body in found}


def words_of(enumerations):
    """The words that stand for codes, by code. Every enumeration of codes has its own hundred, the statuses the first one: a code
    says what it is one of."""
    found, owners = {}, {}
    for enumeration, members in enumerations.items():
        if enumeration in NO_CODES:
            continue
        names = [name for name, *_ in members]
        prefix = os.path.commonprefix(names)
        prefix = prefix[: prefix.rfind("_") + 1] if len(names) > 1 else ""
        for name, number, _ in members:
            code = int(number)
            is_status = enumeration == "mdr_status"
            if owners.setdefault(code // 100, enumeration) != enumeration or (code < 100) != is_status or code in found:
                raise SystemExit(f"MDR_{name} = {code}: {enumeration} needs a hundred of its own")
            word = STATUS_WORDS.get(name, name.removeprefix("E" if is_status else prefix)).lower()
            found[code] = word if enumeration == "mdr_quantity" else word.replace("_", "-")
    return dict(sorted(found.items()))


def codes(headers):
    """The module of the core's code numbers: those of the enumerations, without MDR_, and the words that stand for them."""
    enumerations = enumerations_of(headers)
    words_by_code = words_of(enumerations)
    longest = max(map(len, words_by_code.values()))
    lines = [SPDX, "!> The numbers of the C header's enumerations, written by tools/generate.py."]
    lines += ["module mdrcontact_codes", "    implicit none (type, external)", "    private"]
    for members in enumerations.values():
        lines += folded("    public ::", [name.lower() for name, *_ in members])
    lines += ["    public :: codes_beside, word_of"]
    for enumeration, members in enumerations.items():
        lines += ["", f"    ! enum {enumeration}"]
        for name, value, words in members:
            means = " ".join(f"MDR_{name}. {words}".split())
            lines += textwrap.wrap(means, LONGEST_LINE, initial_indent="    !> ", subsequent_indent="    !> ")
            lines.append(f"    integer, parameter :: {name.lower()} = {value}")
    lines += ["", "    !> The codes in ascending order, statuses first, and their words."]
    lines += filled("    integer, parameter :: numbers(*) = [", [str(code) for code in words_by_code])
    quoted = [f'"{word}"' for word in words_by_code.values()]
    lines += filled(f"    character(len={longest}), parameter :: words(*) = [character(len={longest}) ::", quoted)
    lines += ["", "contains", "", *WORD_OF.split("\n")]
    return [*lines, "", "end module mdrcontact_codes"]


def names(headers):
    """The C function of the words."""
    lines = ["/* SPDX-License-Identifier: GPL-3.0-or-later */", "/* The names of codes. Written by tools/generate.py. */"]
    lines += ['#include "mdrcontact.h"', "", "const char *mdr_name_of(int code)", "{", "    switch (code) {"]
    lines += [f'    case {code}: return "{word}";' for code, word in words_of(enumerations_of(headers)).items()]
    return [*lines, '    default: return "unknown";', "    }", "}"]


def filled(start, entries):
    """An array constructor over as many lines as it takes."""
    lines, line = [], start
    for i, entry in enumerate(entries):
        word = f"{entry}{', ' if i + 1 < len(entries) else ']'}"
        if len(line + word) + 1 > LONGEST_LINE:
            lines.append(line + "&")
            line = " " * 8
        line += word if line.endswith(("[", " ")) else f" {word}"
    return [*lines, line]


def records(found):
    """The module of the structures. Those of doubles only are rows, of which the core has its own types."""
    kept = {name: members for name, members in found.items() if any(member[::2] != ("double", "") for member in members)}
    types = [f"c_{name.removeprefix('mdr_')}_t" for name in kept]
    lines = [SPDX, "!> The structures of the C header, all 0 at first, written by tools/generate.py."]
    lines += ["module mdrcontact_api_records"]
    lines += ["    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_null_char, c_null_ptr, c_ptr, c_size_t"]
    lines += ["    implicit none (type, external)", "    private", *folded("    public ::", types)]
    for kind, (name, members) in zip(types, kept.items(), strict=True):
        lines += ["", f"    !> struct {name}", f"    type, bind(C) :: {kind}"]
        for member_kind, member, length in members:
            declared, zero = FORTRAN[member_kind]
            lines.append(f"        {declared} :: {member.lower()}{f'({length})' if length else ''} = {zero}")
        lines.append(f"    end type {kind}")
    return [*lines, "", "end module mdrcontact_api_records"]


def versions():
    """Since which version there is each function: its own @since, or that of its header."""
    found = {}
    for path in sorted(INCLUDE.rglob("*.h")):
        parts = re.split(r"/\*\*(.*?)\*/", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        since = next((SINCE.search(part)[1] for part in parts[1:2] if SINCE.search(part)), None)
        for words, code in zip(parts[1::2], parts[2::2], strict=True):
            for _, name, _ in PROTOTYPE.findall(code):
                own = SINCE.search(words)
                if not (own or since):
                    raise SystemExit(f"{path.name}: {name} has no @since, nor has its header")
                found[name] = own[1] if own else since
    return found


def symbols(since):
    """The linker's version script: a node for each version, the older ones before it."""
    lines, before = ["# The exported functions since each version, written by tools/generate.py."], ""
    nodes = sorted(set(since.values()), key=lambda version: tuple(map(int, version.split("."))))
    for version in nodes:
        names = sorted(name for name, first in since.items() if first == version)
        lines += [f"MDR_{version} {{", "    global:", *(f"        {name};" for name in names)]
        lines += [*(["    local: *;"] if version == nodes[0] else []), f"}}{before};"]
        before = f" MDR_{version}"
    return lines


def main(root=REPOSITORY):
    """See the top of this file."""
    core, everything = INCLUDE / "mdrcontact.h", INCLUDE / "mdrcontact" / "all.h"
    text = without_comments(everything)
    found = structures(text)
    functions = functions_of(text, described(found))
    headers = "".join(path.read_text(encoding="utf-8") for path in sorted(INCLUDE.rglob("*.h")))
    of_core = parts_of(core)
    texts = {"mdrcontact.h": with_parts(core)} | {
        f"mdrcontact/{part.name}": part.read_text(encoding="utf-8") for part in parts_of(everything, of_core)[:-1]
    }
    fortran = fortran_entries(texts, described(found))
    by_hand = [path.read_text(encoding="utf-8") for path in sorted(API.glob("*.f90")) if not path.name.endswith("entries.f90")]
    sources = "\n".join([*by_hand, *(line for lines in fortran.values() for line in lines)])
    in_api = entries(texts, sources) | fortran | open_handles()
    made = {
        "src/mdrcontact/base/codes.f90": codes(headers),
        "src/mdrcontact/api/names.c": names(headers),
        "src/mdrcontact/api/records.f90": records(found),
        **{f"src/mdrcontact/api/{name}": lines for name, lines in in_api.items()},
        "cmake/mdrcontact.map": symbols(versions()),
        "python/mdrcontact/_native.pyi": type_hints(functions),
        "python/mdrcontact/_layout.py": layout(text, found, functions),
    }
    for name, lines in made.items():
        path = Path(root) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        write(path, lines)
    return list(made)


if __name__ == "__main__":
    main(*sys.argv[1:])
