#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the tests notice a wrong coefficient: applies single mutations to the sources and runs the tests that should fail.

    tools/mutate.py --check              whether every mutation still fits the sources
    tools/mutate.py [NUMBER ...]         all of them, or some, in a copy under build/mutants
    tools/mutate.py --table              the outcomes so far, as the table of tests/README.md

A mutation (tools/mutations.py) is a text that occurs once in a file, what stands there instead, and the tests that should notice.
It is caught when the library no longer builds, a test fails, or a test takes more than two minutes. Only the programs of those
tests are built again. Run it by the Python that has the package installed, from these sources.
"""

from __future__ import annotations

import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from mutations import MUTATIONS

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "mutants"
OUTCOMES = ROOT / "build" / "mutants.json"
PAGE = ROOT / "tests" / "README.md"
MARKS = "<!-- made by tools/mutate.py --table -->", "<!-- end -->"


def main(arguments: list[str]) -> int:
    stale = [f"{i + 1} {m[0]}: {m[1]!r}" for i, m in enumerate(MUTATIONS) if _place(ROOT, m[0]).read_text().count(m[1]) != 1]
    for line in stale:
        print(f"does not fit any more: {line}")
    if stale or arguments == ["--check"]:
        return 1 if stale else 0
    outcomes = json.loads(OUTCOMES.read_text()) if OUTCOMES.exists() else {}
    if arguments != ["--table"]:
        _copy_sources()
        for number in arguments or map(str, range(1, len(MUTATIONS) + 1)):
            mutation = MUTATIONS[int(number) - 1]
            outcomes[_key(mutation)] = _outcome(mutation)
            print(number, mutation[0], mutation[1], outcomes[_key(mutation)], flush=True)
            OUTCOMES.write_text(json.dumps(outcomes))
        return 0
    rows = [[str(i + 1), m[0], _code(m[1]), _code(m[2]), outcomes.get(_key(m), "not run")] for i, m in enumerate(MUTATIONS)]
    caught = sum(row[-1] not in ("survived", "not run") for row in rows)
    lines = [f"{caught} of {len(rows)} are caught.", "", "| | File | Text | Instead | |", "|---|---|---|---|---|"]
    lines += [f"| {' | '.join(row)} |" for row in rows]
    before, after = PAGE.read_text().split(MARKS[0])[0], PAGE.read_text().split(MARKS[1])[1]
    PAGE.write_text(before + "\n".join([MARKS[0], *lines, MARKS[1]]) + after)
    print(lines[0])
    return 0 if caught >= 0.95 * len(rows) else 1


def _key(mutation: tuple[str, ...]) -> str:
    return "\t".join(mutation[:3])


def _code(text: str) -> str:
    words = " ".join(text.split()).replace("|", "\\|")
    return f"`{words}`" if words else ""


def _place(root: Path, name: str) -> Path:
    if name.startswith("python:"):
        return root / "python/mdrcontact" / name.removeprefix("python:")
    return root / "src/mdrcontact" / name


def _copy_sources() -> None:
    for folder in ("src", "include", "tests", "cmake", "examples", "docs", "python"):
        _remove_what_is_gone(folder)
        shutil.copytree(ROOT / folder, COPY / folder, dirs_exist_ok=True, copy_function=_renew)
    shutil.copy2(ROOT / "CMakeLists.txt", COPY)
    shutil.copy2(ROOT / "pyproject.toml", COPY)
    package = find_spec("mdrcontact")
    if package is None or package.origin is None:
        raise SystemExit("the Python package is not installed")
    skipped = shutil.ignore_patterns("__pycache__")
    installed = Path(package.origin).parent
    shutil.copytree(installed, COPY / "python/mdrcontact", dirs_exist_ok=True, ignore=skipped, copy_function=_renew)
    options = ["-DMDRCONTACT_BUILD_EXAMPLES=OFF", "-DMDRCONTACT_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
    _run("cmake", "-S", COPY, "-B", COPY / "build", "-G", "Ninja", *options, check=True)
    built = _run("cmake", "--build", COPY / "build", "--target", "mdrcontact_python")
    if built.returncode:
        raise SystemExit(f"the sources do not build as they are\n{built.stdout}")


def _remove_what_is_gone(folder: str) -> None:
    """Removes copies of files that the sources have no more: with them no mutant builds, which would pass for caught."""
    made = ("_native", "_version", "__pycache__")
    for copy in (COPY / folder).rglob("*"):
        if copy.is_file() and not any(name in str(copy) for name in made) and not (ROOT / copy.relative_to(COPY)).exists():
            copy.unlink()


def _renew(source: str, target: str) -> None:
    """Copies what differs, as of now: with the date of the source a mutated object file would be newer and stay in the library."""
    if not (Path(target).exists() and filecmp.cmp(source, target, shallow=False)):
        shutil.copy(source, target)


def _outcome(mutation: tuple[str, str, str, str]) -> str:
    name, text, replacement, tests = mutation
    place = _place(COPY, name)
    original = place.read_text()
    place.write_text(original.replace(text, replacement))
    try:
        files = [test for test in tests.split() if test.endswith(".py")]
        patterns = [test for test in tests.split() if test not in files]
        outcome = _native_outcome(patterns) if patterns else "survived"
        if outcome == "survived" and files:
            outcome = _python_outcome(files, is_native=not name.startswith("python:"))
        return outcome
    finally:
        place.write_text(original)


def _native_outcome(patterns: list[str]) -> str:
    listed = _run("ctest", "--test-dir", COPY / "build", "-N", "-R", "|".join(patterns), "-E", "grind|export|names|threads")
    tests = re.findall(r"Test +#\d+: (\S+)", listed.stdout)
    if not tests:
        raise SystemExit(f"no test is called {' or '.join(patterns)}")
    targets = [re.sub(r"^c_", "test_c_", re.sub(r"^fuzz_replay_", "replay_", test)) for test in tests]
    if _run("cmake", "--build", COPY / "build", "--target", *targets).returncode:
        return "does not build"
    chosen = "^(" + "|".join(tests) + ")$"
    result = _run("ctest", "--test-dir", COPY / "build", "-R", chosen, "--timeout", "120", "--stop-on-failure")
    return "caught" if result.returncode else "survived"


def _python_outcome(files: list[str], *, is_native: bool) -> str:
    package = COPY / "python/mdrcontact"
    installed = next(Path(find_spec("mdrcontact").origin).parent.glob("_native*.so"))
    if is_native:
        if _run("cmake", "--build", COPY / "build", "--target", "mdrcontact_python").returncode:
            return "does not build"
        installed = COPY / "build/python" / installed.name
    shutil.copy2(installed, package)
    places = [COPY / "tests/python" / name for name in files]
    options = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:randomly"]
    try:
        result = _run(sys.executable, "-m", "pytest", *options, *places, timeout=600)
    except subprocess.TimeoutExpired:
        return "caught"
    if result.returncode not in (0, 1, 2):
        raise SystemExit(result.stdout)
    return "caught" if result.returncode else "survived"


def _run(*command: object, check: bool = False, timeout: float | None = None) -> subprocess.CompletedProcess[str]:
    here = {**os.environ, "PYTHONPATH": str(COPY / "python"), "PYTHONDONTWRITEBYTECODE": "1", "OPENBLAS_NUM_THREADS": "1"}
    words = [str(word) for word in command]
    return subprocess.run(words, capture_output=True, text=True, check=check, timeout=timeout, env=here, cwd=COPY)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
