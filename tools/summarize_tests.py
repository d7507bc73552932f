#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Count the tests of all suites: summarize_tests.py RESULTS SUITE...

RESULTS holds SUITE.xml (JUnit) for every suite and NAME.check ("passed" or "failed") for every check that has no parts.
A CTest entry that runs a pFUnit file counts as many tests as the file has. The last line is "N passed, N failed"; the exit status
is 1 if one failed, a suite is missing or a suite ran no test.
"""

import re
import sys
from pathlib import Path
from xml.etree import ElementTree

PFUNIT_OK = re.compile(r"^ OK\s+\((\d+) tests?\b", re.MULTILINE)
PFUNIT_FAILURES = re.compile(r"Tests run: (\d+), Failures: (\d+), Errors: (\d+)")


def count_case(case):
    """(passed, failed, skipped) of one JUnit test case."""
    output = case.findtext("system-out") or ""
    if case.find("skipped") is not None or case.get("status") in ("notrun", "disabled"):
        return (0, 1, 0) if case.get("status") == "notrun" else (0, 0, 1)
    if case.find("failure") is not None or case.find("error") is not None:
        inner = PFUNIT_FAILURES.search(output)
        if inner and int(inner[2]) + int(inner[3]) > 0:
            bad = int(inner[2]) + int(inner[3])
            return int(inner[1]) - bad, bad, 0
        return 0, 1, 0
    inner = PFUNIT_OK.search(output)
    return (int(inner[1]) if inner else 1), 0, 0


def count_suite(path):
    """(passed, failed, skipped) of one JUnit file, and the names of what failed."""
    totals, failed = [0, 0, 0], []
    for case in ElementTree.parse(path).iter("testcase"):
        counts = count_case(case)
        totals = [total + count for total, count in zip(totals, counts, strict=True)]
        if counts[1]:
            failed.append(case.get("name"))
    return *totals, failed


def main(results, suites):
    """Print the table and return the exit status."""
    passed = failed = 0
    broken = []
    for check in sorted(results.glob("*.check")):
        good = check.read_text().strip() == "passed"
        passed, failed = passed + good, failed + (not good)
        print(f"   {check.stem:<12} {'passed' if good else 'FAILED'}")
    for suite in suites:
        try:
            good, bad, skipped, names = count_suite(results / f"{suite}.xml")
        except (OSError, ElementTree.ParseError) as problem:
            print(f"   {suite:<12} FAILED: no results ({problem})")
            broken.append(suite)
            continue
        print(f"   {suite:<12} {good} passed, {bad} failed, {skipped} skipped")
        for name in names:
            print(f"      failed: {name}")
        if good + bad == 0:
            print(f"      failed: {suite} ran no test")
            broken.append(suite)
        passed, failed = passed + good, failed + bad
    failed += len(broken)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), sys.argv[2:]))
