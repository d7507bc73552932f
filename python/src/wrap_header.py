# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiled module from the C headers: wrap_header.py HEADER PYF.

Reads include/mdrcontact/all.h with its parts and writes for f2py a signature file (PYF) of all functions, from which it makes the
module `_native`. The module's types, its structures, constants and the places of its pointers lie in the repository:
tools/generate.py. A file that is up to date is left alone.

In Python a function has the name without mdr_, takes the inputs in the header's order, lengths of arrays excepted, and returns
the status, or another result, followed by the outputs. Types that f2py does not support are passed as an address, a Python int:
handles, functions, texts, structures (which are NumPy records), and arrays that may be missing. `_boundary.native` takes the
objects instead of addresses. A structure of doubles only is a row of doubles.
"""

import re
import sys
from pathlib import Path

# Functions of law_force.c beside those of the header: name, and what they take and give.
SCALARS = {
    "law_force_scalar": "law: Pointer, branch: int, d: float, /) -> float | None",
    "law_state_scalar": "law: Pointer, branch: int, d: float, /) -> tuple[float, float, float, float, float] | None",
}
# Arrays whose size is not n; an empty text: as an address. In C order, as in the header.
POINTS_OF_RULE = "6*order*order*order"
SIZES = {
    "mdr_set_progress": {"part": ""},
    "mdr_conduction_new": {"upper": ""},
    "mdr_conduction_field": {"z": ""},
    "mdr_load_critical": {"out": ""},
    "mdr_contact_first_failure": {"strengths": "", "out": ""},
    "mdr_load_layer_energies": {"out": "capacity"},
    "mdr_contact_pull_off": {"out": "capacity"},
    "mdr_loop_points": {"out": "capacity"},
    "mdr_parameters": {"out": ""},
    "mdr_closed_form": {"constants": ""},
    "mdr_conduction_follow": {"given": ""},
    "mdr_material_viscoelastic": {"moduli": "", "times": ""},
    "mdr_wear_new": {"thickness": ""},
    "mdr_yielding_new": {"yield_stress": ""},
    "mdr_wear_history_save": {"numbers": "capacity"},
    "mdr_structure_shapes": {"parameters": "n, 7"},
    "mdr_structure_voxels": {"labels": "", "E": "phases", "nu": "phases"},
    "mdr_lateral_cells": {"x": "nx + 1", "y": "ny + 1", "shear": "ny, nx", "poisson": "ny, nx"},
    "mdr_lateral_rule": {"points": f"{POINTS_OF_RULE}, 3", "weights": f"{POINTS_OF_RULE}, 2"},
    "mdr_law_advance": {"shift": "n, 3", "tangent": "", "memory": "", "T": "n, 3"},
    "mdr_law_buffer": {"buffer": ""},
    "mdr_law_energies": {"memory": ""},
    "mdr_law_turn": {"normal": "n, 3", "spin": "", "memory": ""},
    "mdr_plastic_law_advance": {"memory": ""},
    "mdr_plastic_law_buffer": {"buffer": ""},
    "mdr_plastic_law_energies": {"memory": ""},
    "mdr_law_values": dict.fromkeys(("d", "a", "F", "k", "slope", "energy"), ""),
    "mdr_fit_solve": dict.fromkeys(
        ("given", "sd", "values", "covariance", "widening", "at_bound", "weakest_direction", "fitted", "residuals"), ""
    ),
    "mdr_fit_parameters": {"out": ""},
    "mdr_fit_predict": {"given": "", "radius": ""},
    "mdr_fit_interval": {"given": "", "sd": ""},
}
# Arguments that are both input and output.
BOTH_WAYS = {"segment"}
# A function: its result, name and arguments.
PROTOTYPE = re.compile(r"^((?:const )?\w+ \**)(mdr_\w+)\(([^)]*)\);", re.MULTILINE)
# Names that mean something to f2py or Python.
RESERVED = {"in": "values", "size": "cells", "kind": "kinds"}
LONGEST_LINE = 132
# The function of interrupted.c, whose address is an attribute of the module.
INTERRUPTED = "int interrupted(void *);"
SET_INTERRUPTED = 'PyDict_SetItemString(d, "interrupted", PyLong_FromVoidPtr((void *)(size_t)interrupted));'
SPDX = "# SPDX-License-Identifier: GPL-3.0-or-later"
NUMBERS = {"int": ("integer", "int"), "double": ("double precision", "float")}
ADDRESS = "integer*8", "int"


class Argument:
    """One argument of a function, as f2py and Python see it."""

    def __init__(self, function, words, rows):
        match = re.fullmatch(r"(const )?(\w+) (\**)(const )?(\w+)(\[(\d*)\])?", words)
        if not match:
            raise SystemExit(f"{function}: cannot read the argument {words!r}")
        constant, kind, stars, _, name, brackets, size = match.groups()
        self.name = RESERVED.get(name, name)
        self.kind, self.way, self.size = "address", "in", None
        self.is_number = kind == "size_t"
        if kind in NUMBERS:
            self.kind = kind
        self.by_value = not (stars or brackets)
        is_row = kind in rows
        if self.kind == "address" and not is_row:
            # a handle, a function, a structure, a text; ** is a handle that is made or freed
            self.by_value = len(stars) < 2 and not brackets
            if brackets:
                self.size = SIZES.get(function, {}).get(name, "n") or None
                self.by_value = not self.size
            elif len(stars) == 2 and name == "out":
                self.way = "out"
        elif brackets or stars:
            self.way = "in" if constant else "in, out" if name in BOTH_WAYS else "out"
            self.kind = "double" if is_row else self.kind
            self.size = (size or SIZES.get(function, {}).get(name, "n")) if brackets else None
            if is_row and self.size != "":
                self.size = f"{self.size}, {rows[kind]}" if self.size else str(rows[kind])
            if self.size == "":
                self.kind, self.way, self.size, self.by_value = "address", "in", None, True

    def length(self):
        """The integer that this array's length determines, and the expression for it."""
        match = re.fullmatch(r"(n|nx|ny|phases)( \+ 1)?(, [3567])?", self.size or "")
        return match and self.way == "in" and (match[1], f"{'shape' if match[3] else 'len'}({self.name}{', 0' if match[3] else ''})"
                                               f"{' - 1' if match[2] else ''}")  # fmt: skip

    def declaration(self):
        """Declaration in f2py's signature file."""
        kind = NUMBERS.get(self.kind, ADDRESS)[0]
        c = "c, " if self.by_value or self.size else ""
        return f"{kind}, intent({c}{self.way}) :: {self.name}" + (f"({self.size})" if self.size else "")

    def type(self):
        """Type for the type checker."""
        if self.kind == "address":
            return "int" if self.is_number or "out" in self.way else "Sequence[Pointer]" if self.size else "Pointer"
        if not self.size:
            return NUMBERS[self.kind][1]
        return {"int": "Integers", "double": "Reals"}[self.kind] if "out" in self.way else "ArrayLike"


class Function:
    """One function of the header."""

    def __init__(self, result, name, words, rows):
        self.c_name, self.name = name, name.removeprefix("mdr_")
        self.result = None if result == "void" else NUMBERS.get(result, ADDRESS)
        self.arguments = [Argument(name, word, rows) for word in words]
        self.lengths = {}
        for argument in self.arguments:
            if argument.length():
                self.lengths.setdefault(argument.length()[0], (argument.name, argument.length()[1]))

    def signature(self):
        """The signature for f2py. All functions give the lock of the interpreter back: they do not use Python."""
        kind = f"{self.result[0]} function" if self.result else "subroutine"
        lines = [f"{kind} {self.name}({', '.join(argument.name for argument in self.arguments)})", f"  fortranname {self.c_name}"]
        lines += ["  threadsafe", f"  intent(c) {self.name}"]
        for argument in self.arguments:
            if argument.name in self.lengths:
                source, length = self.lengths[argument.name]
                lines.append(f"  integer, intent(c, hide), depend({source}) :: {argument.name} = {length}")
            else:
                lines.append(f"  {argument.declaration()}")
        return [*lines, f"end {kind.split()[-1]}"]

    def taken(self):
        """The arguments that Python gives."""
        return [argument for argument in self.arguments if "in" in argument.way and argument.name not in self.lengths]

    def pointers(self):
        """Places of pointers among the arguments that Python gives."""
        return [i for i, argument in enumerate(self.taken()) if "Pointer" in argument.type()]

    def typed(self):
        """What the type checker reads."""
        taken = self.taken()
        # f2py puts lengths of outputs where they stand
        given = [argument.type() for argument in self.arguments if "out" in argument.way]
        inputs = ", ".join([f"{argument.name}: {argument.type()}" for argument in taken] + ["/"] * bool(taken))
        results = ([self.result[1]] if self.result else []) + given
        result = "None" if not results else results[0] if len(results) == 1 else f"tuple[{', '.join(results)}]"
        if len(line := f"def {self.name}({inputs}) -> {result}: ...") <= LONGEST_LINE:
            return line
        if len(inputs) + 4 > LONGEST_LINE:
            inputs = ",\n    ".join(inputs.split(", ")) + ","
        return f"def {self.name}(\n    {inputs}\n) -> {result}: ..."


def parts_of(header, before=()):
    """The files that a compiler reads for a header, each once and after those that it includes, without those read before."""
    header, found = Path(header).resolve(), []
    for part in re.findall(r'#include "(.*)"', header.read_text(encoding="utf-8")):
        found += parts_of(header.parent / part, [*before, *found])
    return [*found, *([header] if header not in (*before, *found) else [])]


def with_parts(header, before=()):
    """The text of a header and its parts."""
    return "".join(part.read_text(encoding="utf-8") for part in parts_of(header, before))


def without_comments(header):
    """The header and its parts, preprocessed."""
    return re.sub(r"/\*.*?\*/", "", with_parts(header), flags=re.DOTALL)


def prototypes(text):
    """Result, name and arguments of each function."""
    return [
        (result.strip(), name, [] if words == "void" else [" ".join(word.split()) for word in words.split(",")])
        for result, name, words in PROTOTYPE.findall(text)
    ]


def enumerations(text):
    """Names, without MDR_, and values of each enumeration."""
    return [re.findall(r"MDR_(\w+) = (\d+)", body) for body in re.findall(r"enum \w+ \{(.*?)\}", text, flags=re.DOTALL)]


def structures(text):
    """Name and members (type, name, length) of each structure."""
    found = {}
    for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", text, flags=re.DOTALL):
        members = re.findall(r"(?:const )?(?:struct )?(\w+) (\*?)(\w+)(?:\[(\d+)\])?;", body)
        found[name] = [("address" if star else kind, member, length) for kind, star, member, length in members]
    return found


def layout(text, found, functions):
    """The dtypes of the structures, the constants of the enumerations, and where functions take pointers."""
    kinds = {"size_t": "np.uintp", "address": "np.uintp", "double": "np.float64", "int": "np.intc"}
    words = '"""Structures and constants of the C headers, written by tools/generate.py."""'
    lines = [SPDX, words, "", "import numpy as np", ""]
    for name, members in found.items():
        rows = (
            f'("{member}", "S{length}")' if kind == "char" else f'("{member}", {kinds[kind]}{f", ({length},)" if length else ""})'
            for kind, member, length in members
        )
        lines += [f"{name.removeprefix('mdr_')} = np.dtype(", "    ["]
        lines += [f"        {word}," for word in rows] + ["    ],", "    align=True,", ")"]
    for enumeration in enumerations(text):
        lines += [""] + [f"{name} = {value}" for name, value in enumeration]
    places = {function.name: function.pointers() for function in functions}
    lines += ["", "POINTERS = {"]
    lines += [f'    "{name}": ({", ".join(map(str, found))}{"," * (len(found) == 1)}),' for name, found in places.items() if found]
    return [*lines, "}", '"""Places of pointers among the arguments of a function."""']


def write(path, lines):
    """Writes a file that is not up to date."""
    text = "\n".join(lines) + "\n"
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def described(found):
    """How many doubles those structures have that are rows of doubles."""
    return {name: len(members) for name, members in found.items() if all(member[::2] == ("double", "") for member in members)}


def functions_of(text, rows):
    """All functions of the header."""
    return [Function(result, name, words, rows) for result, name, words in prototypes(text)]


def type_hints(functions):
    """The module's types."""
    return [
        SPDX,
        "# The functions of the C headers as `_boundary.native` has them, written by tools/generate.py.",
        "from collections.abc import Sequence",
        "from typing import Any",
        "",
        "import numpy as np",
        "from numpy.typing import ArrayLike, NDArray",
        "",
        "# a handle, a contiguous array or record, a function of ctypes, or None for NULL",
        "Pointer = Any",
        "Integers = NDArray[np.intc]",
        "Reals = NDArray[np.float64]",
        "interrupted: int",
        "",
        *(function.typed() for function in functions),
        *(f"def {name}({words}: ..." for name, words in SCALARS.items()),
    ]


def main(header, pyf):
    """See the top of this file."""
    text = without_comments(header)
    functions = functions_of(text, described(structures(text)))
    signatures = [f"    {line}" for function in functions for line in function.signature()]
    declarations = [f"PyObject *{name}(PyObject *, PyObject *const *, Py_ssize_t);" for name in SCALARS] + [INTERRUPTED]
    methods = [f'{{"{name}", (PyCFunction)(void (*)(void)){name}, METH_FASTCALL, NULL}},' for name in SCALARS]
    write(
        Path(pyf),
        ["python module _native", "  usercode '''", *declarations, "'''", "  pymethoddef '''", *methods, "'''"]
        + ["  interface", "    usercode '''", SET_INTERRUPTED, "'''", *signatures, "  end interface", "end python module _native"],
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
