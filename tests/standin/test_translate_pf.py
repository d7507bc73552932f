#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What translate_pf.py must refuse, and what it must make of what it accepts."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))

from translate_pf import Rejected, Translator  # noqa: E402

FILE = """module test_it
    use funit
contains
    @test
    subroutine works()
        {line}
    end subroutine works
end module test_it
"""


def translate(text, name="test_it.pf"):
    return Translator(Path(name)).translate(text.splitlines())


class Accepted(unittest.TestCase):
    def test_assertions_become_calls_that_know_their_place(self):
        for line, call in (
            ("@assertEqual(1, n)", "call assertEqual(1, n, &"),
            ("@ASSERTTRUE(ok(1))", "call assertTrue(ok(1), &"),
            ("@assertEqual('it''s ) ! &', \"@\")", "call assertEqual('it''s ) ! &', \"@\", &"),
        ):
            fortran = translate(FILE.format(line=line)).splitlines()
            place = fortran.index(call)
            self.assertEqual(fortran[place + 1].strip(), '& location=SourceLocation("test_it.pf", 6))')
            self.assertEqual(fortran[place + 2], "if (anyExceptions()) return")

    def test_the_program_runs_every_test_between_its_fixtures(self):
        text = FILE.format(line="@assertTrue(.true.)").replace(
            "    @test\n",
            "    @before\n    subroutine b()\n    end subroutine b\n    @test\n    @disable\n"
            "    subroutine off()\n    end subroutine off\n    @test\n",
        )
        program = translate(text).split("program run_test_it")[1]
        self.assertIn('call start_test("works")\n    call b()\n    if (.not. anyExceptions()) call works()', program)
        self.assertIn('call skip_test("off")', program)
        self.assertNotIn("call off()", program)


class Refused(unittest.TestCase):
    def refuse(self, text, words, name="test_it.pf"):
        with self.assertRaises(Rejected) as caught:
            translate(text, name)
        self.assertIn(words, str(caught.exception))

    def test_unknown_directives(self):
        for line in ("@fail('no')", "@assertFail('no')", "@assertAny([a])", "@assertExceptionRaised()", "@mpiassert(x)",
                     "@assertequals(1, 2)", "@suite(name='x')", "@testcase", "@testparameter", "@parameters", "@", "@ (1)"):  # fmt: skip
            self.refuse(FILE.format(line=line), "is not known here")

    def test_assertions_that_are_not_on_one_line(self):
        for line in ("@assertEqual(1, &", "@assertEqual(1, 2) ! why", "@assertEqual 1, 2", "@assertEqual(1, 2) + (3)",
                     "@assertEqual(1, 2))", "@assertEqual((1, 2)", "@assertEqual(1, 2); call f()", "@assertTrue()"):  # fmt: skip
            self.refuse(FILE.format(line=line), "must stand on one line")

    def test_long_lines(self):
        line = "@assertTrue(" + "t" * 111 + ")"
        self.assertEqual(len(line) + 8, 132)
        translate(FILE.format(line=line))
        self.refuse(FILE.format(line=" " + line), "line of 133 columns")
        self.refuse(FILE.format(line="! " + "c" * 132), "columns")

    def test_directives_in_the_wrong_place(self):
        good = FILE.format(line="@assertTrue(.true.)")
        self.refuse(good.replace("    @test\n", "    @disable\n    @test\n"), "stands in the wrong place")
        self.refuse(good.replace("    @test\n", "    @test\n    @test\n"), "stands in the wrong place")
        self.refuse(good.replace("    @test\n", "    @test\n    ! why\n"), "must follow @test on the next line")
        self.refuse(good.replace("works()", "works(self)"), "must follow @test on the next line")
        self.refuse(good.replace("@test", "@test(npes=[1])"), "takes nothing behind it")
        self.refuse(good + "    @after\n", "the file ends after @after")
        twice = "    @before\n    subroutine b()\n    end subroutine b\n"
        self.refuse(good.replace("    @test\n", twice + twice + "    @test\n"), "a second @before")

    def test_files_that_test_nothing_or_have_another_name(self):
        self.refuse(FILE.format(line="").replace("    @test\n", ""), "no @test in the file")
        self.refuse(FILE.format(line=""), "the module must have the name of the file", name="test_other.pf")


if __name__ == "__main__":
    unittest.main()
