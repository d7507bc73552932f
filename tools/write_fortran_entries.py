# SPDX-License-Identifier: GPL-3.0-or-later
"""The Fortran side of functions of the header that convert, call the core and return, for generate.py.

tools/fortran_entries.txt says what each of them calls, in the names of the header's arguments:

    name [-> type of the new object [by the function that returns it]] [, unchecked | , infinity][: statement]
        statements in order
            the rest of a long one
        a, b, ... = x(#)

A statement is carried out unless there is an error; where it names an input array, for n > 0; after `each: ` for i = 1, n. With #
it is several, a = x(1), b = x(2). In it a handle stands for its object, a user function for one of the library, an array for its n
elements, an output for a variable, two arrays `(x, y)` for a complex one; `@` before an argument leaves it as it is. A declaration
is of one more variable, or of a handle's object where there are two types. Results in arrays must be finite, or at most infinite,
or are not looked at. All outputs are written when all is known.

An indenter `profile_x` whose core has `new_x(self, ..., error)` with the header's arguments needs no line.
"""

import re
from pathlib import Path

from wrap_header import prototypes
from write_open_handle import CORE, EXTENSIONS

TABLE = Path(__file__).parent / "fortran_entries.txt"
SOURCES = Path(__file__).resolve().parents[1] / "src" / "mdrcontact"
LONGEST_LINE = 132
SPDX = "! SPDX-License-Identifier: GPL-3.0-or-later"
TYPES = {
    "double": "real(c_double)",
    "int": "integer(c_int)",
    "mdr_state": "type(contact_state_t)",
    "mdr_wear_state": "type(wear_state_t)",
    "mdr_rate_state": "type(rate_state_t)",
    "mdr_overload_state": "type(overload_state_t)",
    "mdr_cap_state": "type(cap_state_t)",
}
OBJECTS = {kind: (of_type, clause) for part in (*EXTENSIONS.values(), CORE) for kind, of_type, _, clause in reversed(part)}
# The class that a function returns a new object as, where not class(*).
CLASS_OF = {"return_solver": "solver_t", "return_solved": "solver_t", "return_elastic": "body_t"}
C_NAMES = {"c_associated", "c_double", "c_funptr", "c_int", "c_loc", "c_ptr", "c_sizeof"}
UNLESS = "if (.not. allocated(error)"
# A text, a member, a keyword of an argument; or a name, with @ for the argument itself.
WORD = re.compile(r'"[^"]*"|%\w+|\b[A-Za-z]\w*=(?!=)|(@?)\b([A-Za-z]\w*)')
DECLARATION = re.compile(r"((?:type|class|real|integer|character)\b.*) :: (\w+)(.*)")


class Argument:
    """One argument: its declaration, and the variable that it is in statements."""

    def __init__(self, words, rows):
        constant, kind, stars, name, brackets = re.fullmatch(r"(const )?(\w+) (\**)(?:const )?(\w+)(\[\d*\])?", words).groups()
        self.name, self.is_array, self.is_new = name.lower(), bool(brackets), stars == "**"
        self.type = TYPES.get(kind, "real(c_double)" if kind in rows else "type(c_ptr)" if stars or brackets else "type(c_funptr)")
        is_optional = self.is_array or self.is_new or (kind in TYPES and stars != "")
        self.is_output = is_optional and not constant and kind in TYPES
        way = f"intent({'in' if constant else 'inout'}), optional" if is_optional else "value"
        shape = f"({rows[kind]}, *)" if kind in rows and kind not in TYPES else "(*)"
        self.declared = f"{self.type}, {way}", self.name + shape * self.is_array
        self.object, self.kind_inside, self.opened = OBJECTS.get(kind), "", ""
        self.variable = "made" if self.is_new else self.name + f"_value{'s' * self.is_array}" * self.is_output
        if self.object and stars == "*" and not brackets:
            self.variable, self.kind_inside = f"{self.name}_inside", f"{self.object[1]}({self.object[0]}), pointer"
            self.opened = f'call open_handle({self.name}, "{name}", {self.variable}, error)'
        elif kind == "mdr_function":
            self.variable, self.kind_inside = f"{self.name}_function", "type(c_function_t)"
            self.opened = f'call new_c_function({self.variable}, "{name}", {self.name}, context, error)'


def public_names():
    """The modules that have each public name."""
    found = {}
    for path in SOURCES.rglob("*.f90"):
        if path.name.endswith("entries.f90"):
            continue
        text = path.read_text(encoding="utf-8")
        for names in re.findall(r"^    public ::((?:.*&\n)*.*)", text, flags=re.MULTILINE):
            for name in re.findall(r"\w+", names):
                found.setdefault(name, set()).add(re.search(r"^module (\w+)", text, flags=re.MULTILINE)[1])
    return found


def table():
    """Type, function that returns it, results and statements of each function."""
    found, statements = {}, []
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        if line.startswith(" " * 8):
            statements[-1] += f" {line.strip()}"
        elif rows := re.fullmatch(r" +(.*) = (.*)#(.*)", line):
            statements += [f"{word} = {rows[2]}{i + 1}{rows[3]}" for i, word in enumerate(rows[1].split(", "))]
        elif line.startswith(" "):
            statements.append(line.strip())
        elif line and not line.startswith("#"):
            head = r"(\w+)(?: -> (\w+)(?: by (\w+))?)?(?:, ([a-z ]+))?(?:: (.*))?"
            name, made, by, results, first = re.fullmatch(head, line).groups()
            statements = [first] if first else []
            found[name] = (made, by, results, statements)
    return found


def constructor(name, arguments):
    """Type and statement of an indenter's constructor from that of the core; None where the core has none with these arguments."""
    word, names = name.removeprefix("profile_"), ", ".join(argument.name for argument in arguments if not argument.is_new)
    head = re.compile(rf"subroutine new_{word}\((\w+), {names}, error\)\n +type\((\w+)\), intent\(out\) :: \1\n")
    texts = (path.read_text(encoding="utf-8") for path in sorted((SOURCES / "bodies" / "profile").glob("*.f90")))
    found = next(filter(None, map(head.search, texts)), None) if word != name and names else None
    return found and (found[2], None, None, [f"new_{word}(out, {names}, error)"])


def folded(line):
    """A line of Fortran, broken between words where it is too long."""
    indent = line[: len(line) - len(line.lstrip())]
    lines = [""]
    for part in re.split(r'(?<=[ (])(?=(?:[^"]*"[^"]*")*[^"]*$)', line.strip()):
        if len(indent + lines[-1] + part.rstrip()) + 2 > LONGEST_LINE:
            lines[-1] = f"{lines[-1].rstrip()} &"
            lines.append("    ")
        lines[-1] += part
    return [indent + part for part in lines]


def guarded(text, condition):
    """A statement that depends on a condition."""
    is_call = re.match(r"[\w%]+\(", text) and not re.match(r"[\w%]+(\([^()]*\))? = ", text)
    text = f"call {text}" if is_call and not text.startswith("if (") else text
    if not condition:
        return [text]
    if len(f"{condition} {text}") + 8 <= LONGEST_LINE and not text.startswith("if ("):
        return [f"{condition} {text}"]
    return [f"{condition} then", f"    {text}", "end if"]


class Entry:
    """One function: its variables and its lines."""

    def __init__(self, made, by, results, statements, arguments):
        self.arguments, self.by_name = arguments, {argument.name: argument for argument in arguments}
        self.variables, self.lines, self.outputs, self.pairs = {}, [], [], {}
        self.check = {None: "check_results", "infinity": "check_results_or_infinity"}.get(results)
        new = next((argument for argument in arguments if argument.is_new), None)
        if new:
            self.variables["made"] = f"type({made or new.object[0]}), allocatable"
            self.variables["object"] = f"class({CLASS_OF.get(by, '*')}), allocatable"
            self.lines.append("allocate (made)")
        self.variables |= {argument.variable: argument.kind_inside for argument in arguments if argument.kind_inside}
        for match in filter(None, map(DECLARATION.fullmatch, statements)):
            argument = self.by_name.get(match[2])
            self.variables[argument.variable if argument else match[2] + match[3]] = match[1]
        self.lines += [argument.opened for argument in arguments if argument.opened]
        for statement in statements:
            if not DECLARATION.fullmatch(statement):
                self.add(statement)
        self.finish(f"status = {by or 'return_object'}(object, out, error)" if new else "")

    def add(self, statement):
        """A statement, with the room for outputs that it needs first."""
        at, used = "(i)" if statement.startswith("each: ") else "(:n)", []

        def replaced(match):
            """What stands for a word."""
            argument = self.by_name.get(match[2])
            if not argument or match[1]:
                return match[0].removeprefix("@")
            used.append(argument)
            is_whole = not argument.is_array or (argument.is_output and at == "(:n)")
            return argument.variable + ("" if is_whole else at)

        self.pairs |= dict(re.findall(r"(?<=, )\((\w+), (\w+)\)", statement))
        text = re.sub(r"(?<=, )\((\w+), \w+\)", r"\1", statement.removeprefix("each: "))
        text = WORD.sub(replaced, text)
        outputs = [argument for argument in used if argument.is_output]
        for output in outputs:
            if output not in self.outputs:
                self.make_room(output)
        if at == "(i)":
            self.variables["i"] = "integer"
            found = ", ".join(f"{output.variable}(i)" for output in outputs)
            inner = [*guarded(text, ""), f"{UNLESS}) call {self.check}(error, [{found}])"]
            self.lines += ["do i = 1, n", "    if (allocated(error)) exit", *(f"    {line}" for line in inner)]
            self.lines += ["    if (allocated(error)) call raise_at(error, i)", "end do"]
            self.check = None
        elif text.startswith("allocate ("):
            self.allocate(text.removeprefix("allocate (")[:-1])
        else:
            needs_points = any(argument.is_array and not argument.is_output for argument in used)
            may_fail = needs_points or any("error" in line for line in self.lines)
            self.lines += guarded(text, f"{UNLESS}{' .and. n > 0' * needs_points})" if may_fail else "")

    def allocate(self, variable):
        """Memory that a variable needs."""
        self.variables["stat"] = "integer"
        self.lines += [f"{UNLESS}) then", f"    allocate ({variable}, stat=stat)", "    call check_memory(error, stat)", "end if"]

    def make_room(self, output):
        """The variable of an output."""
        self.outputs.append(output)
        kind = "complex(c_double)" if output.name in self.pairs else output.type
        self.variables[output.variable + "(:)" * output.is_array] = kind + ", allocatable" * output.is_array
        if output.is_array and kind.startswith("type"):
            self.allocate(f"{output.variable}(n)")
        elif output.is_array:
            self.lines.append(f"call make_room(error, n, {output.variable})")
        elif kind.startswith("real"):
            self.lines.append(f"{output.variable} = 0.0_c_double")

    def finish(self, returned):
        """The end: results are checked, a new object returned, outputs written."""
        outputs = sorted(self.outputs, key=self.arguments.index)
        if self.pairs:
            ((real, imaginary),) = self.pairs.items()
            self.lines.append(f"call return_parts(error, {real}_values, {real}, {imaginary})")
            outputs = []
        self.lines += [f"{UNLESS}) call {self.check}(error, {it.variable})" for it in outputs if it.is_array and self.check]
        self.lines += ["call move_alloc(made, object)", returned] if returned else ["status = status_of(error)"]
        self.lines += ["if (allocated(error)) return"] * bool(outputs)
        self.lines += [f"if (present({it.name})) {it.name}{'(:n)' * it.is_array} = {it.variable}" for it in outputs]

    def text(self, name):
        """The function."""
        declared = [argument.declared for argument in self.arguments] + [("integer(c_int)", "status")]
        declared += [(kind, variable) for variable, kind in self.variables.items()] + [("type(error_t), allocatable", "error")]
        of_kind = {}
        for kind, variable in declared:
            of_kind.setdefault(kind, []).append(variable)
        lines = [f"function mdr_{name}({', '.join(self.by_name)}) result(status) &", f'    bind(C, name="mdrcontact_entry_{name}")']
        lines += [f"    {kind} :: {', '.join(variables)}" for kind, variables in of_kind.items()]
        lines += ["", *(f"    {line}" for line in self.lines), f"end function mdr_{name}"]
        return [part for line in lines for part in folded(f"    {line}" if line else "")]

    def used(self, name):
        """The words that are not its own."""
        own = {re.match(r"\w+", word)[0] for word in (*self.variables, *self.by_name, "status", "error")}
        return {match[2] for line in self.text(name) for match in WORD.finditer(line)} - own


def module(extension, entries, others):
    """The lines of one file. `others` are the extensions whose modules are not its own."""
    publics, used = public_names(), {}
    foreign = tuple(f"mdrcontact_{room}{other}" for other in others for room in ("", "api_"))
    words = set().union(*(entry.used(name) for name, entry in entries.items()))
    # names of one module first: it is then preferred for others
    for word in sorted(words & publics.keys(), key=lambda word: (len(publics[word]), word)):
        homes = publics[word]
        for wanted in (lambda home: not home.startswith(foreign), used.__contains__, lambda home: extension and extension in home):
            homes = homes if len(homes) == 1 else {home for home in homes if wanted(home)} or homes
        if len(homes) > 1:
            raise SystemExit(f"{word} is a name of {', '.join(sorted(homes))}")
        used.setdefault(*homes, set()).add(word)
    name = f"mdrcontact_api_{extension}_entries" if extension else "mdrcontact_api_entries"
    text = [line for word, entry in entries.items() for line in ("", *entry.text(word))]
    of_c = sorted(word for word in C_NAMES if re.search(rf"(\b|\d_){word}\b", "\n".join(text)))
    top = [SPDX, f"!> Functions of {extension or 'the core'} that convert, call and deliver, for C. Written by tools/generate.py."]
    top += [f"module {name}", f"    use, intrinsic :: iso_c_binding, only: {', '.join(of_c)}"]
    for home, names in sorted(used.items()):
        top += folded(f"    use {home}, only: {', '.join(sorted(names))}")
    top += ["    implicit none (type, external)", "    private", *(f"    public :: mdr_{word}" for word in entries)]
    return [*top, "", "contains", *text, "", f"end module {name}"]


def fortran_entries(headers, rows):
    """The lines of each file by its name, of the core and of each extension, from the headers' texts by their names; `rows` are the
    numbers of doubles of structures that have no other members."""
    rest, files = table(), {}
    parts = {header: header.removeprefix("mdrcontact").strip("/").removesuffix(".h") for header in headers}
    for header, extension in parts.items():
        functions = {name.removeprefix("mdr_"): words for _, name, words in prototypes(headers[header])}
        entries = {}
        for name, words in functions.items():
            arguments = [Argument(word, rows) for word in words]
            if row := rest.pop(name, None) or constructor(name, arguments):
                entries[name] = Entry(*row, arguments)
        if entries:
            others = set(parts.values()) - {"", extension}
            files[f"{extension}_entries.f90" if extension else "entries.f90"] = module(extension, entries, others)
    if rest:
        raise SystemExit(f"the headers have no {', '.join(sorted(rest))}")
    return files
