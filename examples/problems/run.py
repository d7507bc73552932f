#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute every problem of this folder by the commands that its tables are for: run.py OUTPUT_FOLDER

All commands run in one process, because Python takes longer to start than they take to compute.
"""

import re
import sys
from collections.abc import Iterator
from pathlib import Path

from mdrcontact.cli import main

FURTHER = {
    "adhesion": ("adhesion", "-loop"),
    "strength": ("stress", "-stress"),
    "friction": ("friction", "-friction"),
    "wear": ("wear", "-wear"),
    "conduction": ("conduction", "-conduction"),
}
"""Table of a problem: its command, and the end of the names of the files that this writes."""


def commands_of(problem: Path, output: Path) -> Iterator[list[str]]:
    """The commands of a problem with their options."""
    tables = re.findall(r"^\[(\w+)\]", problem.read_text(encoding="utf-8"), re.MULTILINE)

    def writing(command: str, end: str) -> list[str]:
        name = output / f"{problem.stem}{end}"
        return [command, str(problem), "--csv", f"{name}.csv", "--plot", f"{name}.png", "--overwrite"]

    for alone in ("history", "imprint"):
        if alone in tables:
            # a viscoelastic body has no force without its past, and a plastic contact is not loaded elastically
            yield writing(alone, "")
            return
    yield writing("curve", "")
    yield ["compare", str(problem), "--plot", str(output / f"{problem.stem}-models.png"), "--overwrite"]
    for table, (command, end) in FURTHER.items():
        if table in tables:
            yield writing(command, end)


def run(output: Path) -> int:
    """Runs all commands; the exit status of the first one that fails."""
    output.mkdir(parents=True, exist_ok=True)
    for problem in sorted(Path(__file__).parent.glob("*.toml")):
        for words in commands_of(problem, output):
            print("mdrcontact", *words, flush=True)
            status = main(words)
            if status:
                return status
    return 0


if __name__ == "__main__":
    sys.exit(run(Path(sys.argv[1])))
