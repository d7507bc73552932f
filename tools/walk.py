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

from walk.run import walk  # noqa: E402
from walk.scenes import all_scenes  # noqa: E402


def main() -> int:
    """Runs it; the status."""
    word = sys.argv[1] if len(sys.argv) > 1 else ""
    whole, cases = None, []
    for scene in all_scenes():
        if word in scene.name:
            start = time.process_time()
            found = walk([scene])
            cases += found.cases
            whole = found
            took = time.process_time() - start
            if took > 0.5 or word:
                print(f"{scene.name}: {len(found.cases)} cases in {took:.2f} s")
    if whole is None:
        print(f"no scene has {word!r} in its name")
        return 1
    whole.cases = cases
    findings, wrong = whole.findings(), [] if word else whole.wrong_exceptions()
    for line in [*map(str, findings), *wrong]:
        print(line)
    print(whole.summary())
    return 1 if findings or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
