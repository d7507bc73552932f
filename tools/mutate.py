#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the tests notice a wrong coefficient: applies single mutations to the sources and runs the tests that should fail.

    tools/mutate.py --check              whether every mutation still fits the sources
    tools/mutate.py [NUMBER ...]         all of them, or some, in a copy under build/mutants; a table on standard output

A mutation is a file of src/mdrcontact, a text that occurs in it once, what stands there instead, and the tests (a pattern of
ctest). It is caught when the library no longer builds, a test fails, or a test takes more than two minutes.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "mutants"
SOURCE = Path("src/mdrcontact")

MUTATIONS = [
    ("numerics/monotone_table.f90", "abs(slope) > 2.0_wp*abs(first)", "abs(slope) > 3.0_wp*abs(first)", "monotone"),
    ("numerics/monotone_table.f90", "slope = 2.0_wp*first", "slope = 3.0_wp*first", "monotone"),
    ("numerics/monotone_table.f90", "slope = first + (first - second)*share", "slope = first - (first - second)*share", "monotone"),
    ("numerics/monotone_table.f90", "(3.0_wp*rise - 2.0_wp*self%slopes(low)", "(3.0_wp*rise - 1.0_wp*self%slopes(low)", "profile"),
    ("numerics/sampled_function.f90", "do j = size(c), 2, -1\n            b3", "do j = size(c), 3, -1\n            b3", "profile"),
    ("numerics/sampled_function.f90", "smallest_root = 1.0e-5_wp", "smallest_root = 1.0e-1_wp", "profile"),
    ("gsl_handler.c", "while (atomic_load(&handler_state) != SWITCHED) {", "while (0) {", "gsl_handler"),
    ("lateral/voxels.f90", "last = floor(place) + self%images*n", "last = floor(place) + self%images*n + 1", "lateral_structures"),
    ("lateral/voxels.f90", "first = floor(place) - self", "first = floor(place) + 1 - self", "lateral_structures"),
    ("lateral/voxels.f90", "modulo(i, n) + 1", "modulo(i + 1, n) + 1", "lateral_structures"),
    ("lateral/voxels.f90", "most_images = 100", "most_images = 2000000000", "c_lateral"),
    ("lateral/medium.f90", "most_points = 1000000", "most_points = 2147483647", "c_lateral"),
    ("lateral/structure.f90", "value = 2.0_wp*shear/(1.0_wp - poisson)", "value = 2.0_wp*shear/(1.0_wp + poisson)", "lateral"),
    ("contact/loop.f90", "most_points = 1000000", "most_points = 2147483647", "c_loop"),
    ("contact/loop.f90", "0.5_wp*control%force_weight", "1.0_wp*control%force_weight", "adhesion|loop"),
    ("law/sound.f90", "positive = all(b >= 0.0_wp)", "positive = all(b >= -huge(b))", "test_law$"),
    ("law/sound.f90", "all(table%end_values >= 0.0_wp)", "all(table%end_values >= -huge(1.0_wp))", "test_law$"),
    ("law/sound.f90", "all(table%powers >= -rounding)", "all(table%powers >= -huge(1.0_wp))", "test_law$"),
    ("law/sound.f90", "sound = table%end_radius >= 0.0_wp .and.", "sound =", "test_law$"),
    ("law/file.f90", "stat = 1\n        end if\n        if (stat == 0) then\n            allocate", "stat = 0\n        end if\n"
     "        if (stat == 0) then\n            allocate", "test_law$|fuzz_replay_law"),
    ("law/crc32.f90", "-306674912_int32", "-306674911_int32", "test_law$|c_law"),
    ("law/compile.f90", "table%powers(3) = table%powers(1) - 1.0_wp", "table%powers(3) = table%powers(1)", "law"),
    ("law/interval.f90", "even_slope = even + q*c(7)", "even_slope = even + 0.5_wp*q*c(7)", "law"),
    ("law/interval.f90", "self%side*(0.5_wp*rate/max", "self%side*(rate/max", "law"),
    ("file.c", "if (problem == 0 && rename(beside, place) != 0)", "if (0)", "c_files"),
    ("file.c", "if (problem != 0) unlink(beside);", "", "c_files"),
    ("file.c", "if (S_ISREG(facts.st_mode) && access(place, W_OK) == 0) return place;", "return place;", "c_files"),
    ("file.c", "if (S_ISLNK(facts.st_mode)) {", "if (0) {", "c_files"),
    ("file.c", "} else if (!S_ISREG(facts.st_mode)) {", "} else if (0) {", "c_files"),
    ("file.c", "if (mode) fchmod(file, mode);", "", "c_files"),
    ("profile/transform.f90", "if (.not. self%forward) y = y/half_pi", "if (.not. self%forward) y = 1.1_wp*y/half_pi", "profile"),
    ("profile/transform.f90", "separation = 0.25_wp", "separation = 0.75_wp", "profile"),
    ("profile/transform.f90", "far_distance = 3.0_wp", "far_distance = 0.5_wp", "profile"),
    ("profile/transform.f90", "binomial(k - 1, 0)*(2*k - 1)/(2*k)", "binomial(k - 1, 0)*(2*k + 1)/(2*k)", "profile"),
    ("profile/transform.f90", "if (last > child) self%moments", "if (.false.) self%moments", "profile"),
    ("profile/transform.f90", "sum(weights*phi/sqrt(2.0_wp*x - s**2))", "sum(weights*phi/sqrt(2.0_wp*x + s**2))", "profile"),
    ("profile/sampled.f90", "if (here < before - rounding) then", "if (here < -huge(here)) then", "profile"),
    ("profile/sampled.f90", "roots(flat_ends + count + 1:) = .true.", "roots(flat_ends + count + 1:) = .false.", "profile"),
    ("layered/legendre.f90", "real(4*c + 5, wp)*over_odd(j)", "real(4*c + 3, wp)*over_odd(j)", "layered_reference"),
    ("layered/legendre.f90", "even(0) = even(0) + 4.0_wp*moments%shift", "even(0) = even(0) + 2.0_wp*moments%shift", "layered"),
    ("layered/solve.f90", "solution%force = a*(beyond*sums(1) - sums(4))", "solution%force = a*beyond*sums(1)", "layered"),
    ("layered/solve.f90", "solution%modulus = 0.5_wp*sums(1)", "solution%modulus = 0.501_wp*sums(1)", "layered_reference"),
]  # fmt: skip
"""file, text, replacement, tests"""


def main(arguments: list[str]) -> int:
    stale = [f"{name}: {text!r}" for name, text, _, _ in MUTATIONS if (ROOT / SOURCE / name).read_text().count(text) != 1]
    for line in stale:
        print(f"does not fit any more: {line}")
    if stale or arguments == ["--check"]:
        return 1 if stale else 0
    chosen = [int(number) - 1 for number in arguments] or list(range(len(MUTATIONS)))
    _copy_sources()
    caught = 0
    for number in chosen:
        name, text, replacement, tests = MUTATIONS[number]
        place = COPY / SOURCE / name
        original = place.read_text()
        place.write_text(original.replace(text, replacement))
        try:
            outcome = _outcome(tests)
        finally:
            place.write_text(original)
        caught += outcome != "survived"
        print(f"| {number + 1} | {name} | `{' '.join(text.split())}` | `{' '.join(replacement.split())}` | {outcome} |", flush=True)
    print(f"{caught} of {len(chosen)} caught")
    return 0 if caught >= 0.95 * len(chosen) else 1


def _copy_sources() -> None:
    for folder in ("src", "include", "tests", "cmake", "examples"):
        shutil.copytree(ROOT / folder, COPY / folder, dirs_exist_ok=True)
    shutil.copy2(ROOT / "CMakeLists.txt", COPY)
    _run("cmake", "-S", COPY, "-B", COPY / "build", "-G", "Ninja", "-DMDRCONTACT_BUILD_EXAMPLES=OFF", check=True)
    _run("cmake", "--build", COPY / "build", check=True)


def _outcome(tests: str) -> str:
    if _run("cmake", "--build", COPY / "build").returncode:
        return "does not build"
    result = _run(
        "ctest", "--test-dir", COPY / "build", "-R", tests, "-E", "grind|export", "--timeout", "120", "--stop-on-failure",
        "--no-tests=error",
    )  # fmt: skip
    return "caught" if result.returncode else "survived"


def _run(*command: object, check: bool = False) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([str(word) for word in command], capture_output=True, check=check)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
