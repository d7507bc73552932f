#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random relations (tests/python/relations), many draws of each: tools/relations.py 100000

Shares so many draws out among the relations, runs them in processes of their own, elsewhere each time or from --seed on. Says
every few seconds how far it is, and prints a table: draws, refusals, findings, the largest deviation over its tolerance. Status 1
if there is a finding; the failing examples are kept in build/relations. A crash and a hang are findings.

    tools/relations.py 2000 --only friction        # those whose name holds a word
    tools/relations.py 100000 --table tests/README.md
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import random
import re
import subprocess
import sys
import time
import traceback
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TESTS = ROOT / "tests" / "python"
KEPT = ROOT / "build" / "relations"
PIECE = 400
"""Draws of a process."""
LONGEST = 1800.0
"""Seconds of a process: one that takes longer hangs."""
EVERY = 5.0
"""Seconds between two lines of progress."""
MARK = "relations: "


def relations() -> dict:
    """Every relation by its name."""
    sys.path.insert(0, str(TESTS))
    found = {}
    for path in sorted((TESTS / "relations").glob("test_*.py")):
        module = importlib.import_module(f"relations.{path.stem}")
        for value in vars(module).values():
            known = getattr(value, "relation", None)
            if known is not None:
                found[known.name] = known
    return found


def one(name: str, draws: int, seed: int, shrink: bool) -> None:
    """A piece of a relation, in a process of its own; prints what came of it."""
    known = relations()[name]
    words = ""
    try:
        tally = known.run(draws, seed, shrink)
    except BaseException as problem:  # noqa: BLE001 - whatever a relation raises is a finding
        words, tally = "".join(traceback.format_exception(problem)), problem.tally
    print(MARK + json.dumps({"draws": tally.draws, "refusals": tally.refusals, "worst": tally.worst, "words": words}))


def piece(name: str, draws: int, seed: int, shrink: bool) -> dict:
    """What a piece came to; a process that crashes or hangs is a finding."""
    command = [sys.executable, __file__, "--one", name, str(draws), "--seed", str(seed), *["--shrink"] * shrink]
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=LONGEST, env=environment)
    except subprocess.TimeoutExpired:
        return {"draws": draws, "refusals": 0, "worst": 0.0, "words": f"no end after {LONGEST:g} s"}
    lines = [line for line in done.stdout.splitlines() if line.startswith(MARK)]
    if not lines:
        return {"draws": draws, "refusals": 0, "worst": 0.0, "words": f"status {done.returncode}\n{done.stdout}{done.stderr}"}
    return json.loads(lines[-1][len(MARK) :])


def pieces(chosen: dict, draws: int, seed: int) -> list[tuple[str, int, int]]:
    """(name, draws, seed): in proportion to what a run of the tests draws of each, which is what each costs."""
    weight = sum(known.draws for known in chosen.values())
    jobs = []
    for name, known in chosen.items():
        left = max(1, round(draws * known.draws / weight))
        while left > 0:
            jobs.append((name, min(left, PIECE), seed + len(jobs)))
            left -= PIECE
    random.Random(seed).shuffle(jobs)
    return jobs


def table(results: dict) -> str:
    """What tests/README.md shows."""
    lines = ["| Relation | Draws | Refusals | Findings | Largest deviation / tolerance |", "|---|---|---|---|---|"]
    rows = [(name, *(sum(r[key] for r in found) for key in ("draws", "refusals")), sum(bool(r["words"]) for r in found),
             max(r["worst"] for r in found)) for name, found in sorted(results.items()) if found]  # fmt: skip
    lines += [
        f"| {name} | {draws} | {refusals} | {findings or 'none'} | {worst:.2g} |" for name, draws, refusals, findings, worst in rows
    ]
    totals = [sum(row[i] for row in rows) for i in (1, 2, 3)]
    return "\n".join([*lines, f"| all {len(rows)} | {totals[0]} | {totals[1]} | {totals[2] or 'none'} | |"])


def keep(name: str, seed: int, words: str) -> None:
    """A finding, in a file."""
    KEPT.mkdir(parents=True, exist_ok=True)
    kept = KEPT / f"{re.sub(r'[^a-z0-9]+', '_', name.lower())}-{seed}.txt"
    kept.write_text(words)
    print(f"finding in {name}: {kept}", file=sys.stderr)


def follow(running: dict[Future[dict], tuple[str, int, int]]) -> dict[str, list[dict]]:
    """What the pieces come to, by relation; says on the way how far they are."""
    start, said, waiting, findings, drawn = time.monotonic(), 0.0, set(running), 0, 0
    total, results = sum(draws for _, draws, _ in running.values()), {name: [] for name, _, _ in running.values()}
    while waiting:
        done, waiting = wait(waiting, EVERY, FIRST_COMPLETED)
        for one in done:
            (name, draws, seed), found = running[one], one.result()
            results[name].append(found)
            drawn += draws
            if found["words"]:
                findings += 1
                keep(name, seed, found["words"])
        spent = time.monotonic() - start
        if spent - said >= EVERY:
            said = spent
            print(f"{spent:.0f} s: {drawn} of {total} draws, {findings} findings", file=sys.stderr, flush=True)
    return results


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("draws", type=int, help="of all relations together")
    parser.add_argument("--only", default="", help="relations whose name holds this")
    parser.add_argument("--seed", type=int, default=None, help="where the draws begin; default: elsewhere each time")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes at a time")
    parser.add_argument(
        "--table", type=Path, help="a page between whose marks <!-- relations --> and <!-- end of relations --> the table goes"
    )
    parser.add_argument("--shrink", action="store_true", help="make the example of a finding as simple as possible")
    parser.add_argument("--one", metavar="NAME", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        one(given.one, given.draws, given.seed, given.shrink)
        return 0
    seed = random.SystemRandom().randrange(10**9) if given.seed is None else given.seed
    chosen = {name: known for name, known in relations().items() if given.only in name}
    if not chosen:
        parser.error(f"no relation has {given.only!r} in its name")
    start, jobs = time.monotonic(), pieces(chosen, given.draws, seed)
    with ThreadPoolExecutor(given.jobs) as pool:
        results = follow({pool.submit(piece, *job, given.shrink): job for job in jobs})
    text = table(results)
    print(f"{text}\n\nseed {seed}, {time.monotonic() - start:.0f} s by {given.jobs} processes")
    if given.table:
        page = given.table.read_text()
        marks = "<!-- relations -->", "<!-- end of relations -->"
        given.table.write_text(f"{page.partition(marks[0])[0]}{marks[0]}\n{text}\n{marks[1]}{page.partition(marks[1])[2]}")
    return int(any(found["words"] for some in results.values() for found in some))


if __name__ == "__main__":
    sys.exit(main())
