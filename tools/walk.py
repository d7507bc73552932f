#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The walk (tests/python/walk) as a whole, or scenes whose name holds a word: tools/walk.py [word]

Changes every member of every object of physics and compares every answer. Prints how many triples of class, member and answer
there are, each member that does not matter and is no exception, and exceptions that are not needed. Status 1 if there are any.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "python"))

from walk.run import Report, walk  # noqa: E402
from walk.scenes import all_scenes  # noqa: E402

LONG = 0.5
"""Seconds of a scene that is named."""


def main() -> int:
    """Runs it; the status."""
    word = sys.argv[1] if len(sys.argv) > 1 else ""
    report = Report()
    for scene in all_scenes():
        if word not in scene.name:
            continue
        start = time.process_time()
        found = walk([scene]).cases
        report.cases += found
        took = time.process_time() - start
        if took > LONG or word:
            print(f"{scene.name}: {len(found)} cases in {took:.2f} s")
    wrong = [*map(str, report.findings()), *([] if word else report.wrong_exceptions())]
    print(*wrong, report.summary(), sep="\n")
    return 1 if wrong or not report.cases else 0


if __name__ == "__main__":
    sys.exit(main())
