#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Translate a pFUnit test file (.pf) into Fortran that runs with the assertions of funit.f90.

Knows the subset of pFUnit that the tests of this project use, and refuses everything else, so
that a file that passes here means the same under pFUnit itself:

    @test, @disable (between @test and its subroutine), @before, @after,
    one-line @assert... directives of ASSERTIONS.

usage: translate_pf.py test_name.pf test_name.F90
"""

import re
import sys
from pathlib import Path

LONGEST_LINE = 132
ASSERTIONS = {
    name.lower(): name
    for name in (
        "assertEqual", "assertRelativelyEqual", "assertTrue", "assertFalse", "assertIsNaN", "assertIsFinite",
        "assertLessThan", "assertLessThanOrEqual", "assertGreaterThan", "assertGreaterThanOrEqual",
    )
}  # fmt: skip
SUBROUTINE = re.compile(r"\s*subroutine\s+(\w+)\s*(\(\s*\))?\s*$", re.IGNORECASE)
MODULE = re.compile(r"\s*module\s+(\w+)\s*$", re.IGNORECASE)
DIRECTIVE = re.compile(r"\s*@\s*(\w*)(.*?)\s*$")


class Rejected(Exception):
    """The file uses something outside of the subset."""


def has_balanced_arguments(text):
    """Whether `text` is one parenthesised list: no comment, no continuation and no code behind it."""
    code = re.sub(r"'[^']*'|\"[^\"]*\"", "s", text.strip())
    if not re.fullmatch(r"\([^!&'\"]*\)", code) or not code.strip("()").strip():
        return False
    depth = 0
    for position, character in enumerate(code):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if depth == 0 and position < len(code) - 1:
            return False
    return depth == 0


class Translator:
    """Turns the lines of one file into Fortran and collects its test procedures."""

    def __init__(self, path):
        self.path = path
        self.module = None
        self.tests = []
        self.disabled = set()
        self.fixtures = {}
        self.wanted = []

    def translate(self, lines):
        """The Fortran source: the module with its assertions expanded, then a program that runs its tests."""
        translated = []
        for number, line in enumerate(lines, start=1):
            try:
                translated += self.line(line, number)
            except Rejected as reason:
                raise Rejected(f"{self.path}:{number}: {reason}") from None
        if self.wanted:
            raise Rejected(f"{self.path}: the file ends after @{self.wanted[-1]}")
        if self.module != self.path.stem:
            raise Rejected(f"{self.path}: the module must have the name of the file, {self.path.stem}, not {self.module}")
        if not self.tests:
            raise Rejected(f"{self.path}: no @test in the file")
        return "\n".join(translated + self.program()) + "\n"

    def line(self, line, number):
        """The translation of one line."""
        if len(line) > LONGEST_LINE:
            raise Rejected(f"line of {len(line)} columns, at most {LONGEST_LINE} are allowed")
        directive = DIRECTIVE.match(line)
        if directive:
            return self.directive(directive.group(1), directive.group(2), number)
        if self.wanted:
            self.procedure(line)
        elif self.module is None and MODULE.match(line):
            self.module = MODULE.match(line).group(1)
        return [line]

    def directive(self, name, rest, number):
        """The translation of a line that starts with @."""
        keyword = name.lower()
        if keyword in ASSERTIONS and not self.wanted:
            if not has_balanced_arguments(rest):
                raise Rejected(f"@{name} must stand on one line, with its arguments in parentheses and nothing behind them")
            return [
                f'#line {number} "{self.path.name}"',
                f"call {ASSERTIONS[keyword]}{rest.strip()[:-1]}, &",
                f'    & location=SourceLocation("{self.path.name}", {number}))',
                "if (anyExceptions()) return",
                f'#line {number + 1} "{self.path.name}"',
            ]
        if keyword not in ("test", "disable", "before", "after"):
            raise Rejected(f"directive @{name} is not known here")
        if rest.strip():
            raise Rejected(f"@{name} takes nothing behind it here, found {rest.strip()}")
        if self.wanted != (["test"] if keyword == "disable" else []):
            raise Rejected(f"@{name} stands in the wrong place")
        self.wanted.append(keyword)
        return ["! @" + keyword]

    def procedure(self, line):
        """Take the subroutine that the directives above it name."""
        match = SUBROUTINE.match(line)
        if not match:
            raise Rejected(f"a subroutine without arguments must follow @{self.wanted[-1]} on the next line")
        name = match.group(1)
        if self.wanted[0] == "test":
            self.tests.append(name)
            if self.wanted[-1] == "disable":
                self.disabled.add(name)
        elif self.wanted[0] in self.fixtures:
            raise Rejected(f"a second @{self.wanted[0]}")
        else:
            self.fixtures[self.wanted[0]] = name
        self.wanted = []

    def program(self):
        """The program that runs the tests of the module one after another."""
        lines = ["", f"program run_{self.module}", "    use funit", f"    use {self.module}", "    implicit none (type, external)"]
        for test in self.tests:
            if test in self.disabled:
                lines.append(f'    call skip_test("{test}")')
                continue
            lines.append(f'    call start_test("{test}")')
            if "before" in self.fixtures:
                lines.append(f"    call {self.fixtures['before']}()")
            lines.append(f"    if (.not. anyExceptions()) call {test}()")
            if "after" in self.fixtures:
                lines.append(f"    call {self.fixtures['after']}()")
            lines.append("    call finish_test()")
        return [*lines, "    call finish_suite()", f"end program run_{self.module}"]


def main(arguments):
    """Translate one file; exit status 1 and a line on standard error if it is refused."""
    source, target = (Path(argument) for argument in arguments)
    try:
        target.write_text(Translator(source).translate(source.read_text(encoding="utf-8").splitlines()), encoding="utf-8")
    except Rejected as reason:
        print(reason, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
