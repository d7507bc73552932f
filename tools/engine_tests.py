#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests of ContactMechanics with the compliance of layered bodies instead of its own. tools/engine_tests.py CHECKOUT

CHECKOUT is a folder with the sources of ContactMechanics, of the installed version. Its half-spaces become films on bases of equal
material, its bonded layers a layer on a rigid base. A test that passes without this must pass with it, or differ by rounding
alone: `ROUNDING` compares weights to 1e-12 of each one, and those of the engine have lost that to cancellation. Tests that need
files or fetch them are left out; nothing is downloaded.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

DOWNLOADS = "not automatic_offsets and not bearing_area and not hardwall_plastic"
ROUNDING = {"test/test_mpi_free_elastic_half_space.py::test_weights"}
PLUGIN = """
import ContactMechanics.FFTElasticHalfSpace as engine
import mdrcontact as mdr
from mdrcontact.interop._grid import Response
from mdrcontact.interop.contactmechanics import FreeLayeredSubstrate, LayeredSubstrate

PERIODIC, FREE = engine.PeriodicFFTElasticHalfSpace, engine.FreeFFTElasticHalfSpace
OWN = PERIODIC._compute_greens_function
COUNT = {"periodic": 0, "free": 0}


def body_of(self):
    material = mdr.Elastic(self.young, self.poisson)
    size = max(self.physical_sizes)
    return mdr.Coated(material, 0.1 * size, material)


def periodic(self):
    own = OWN(self)
    if not own.size or self.dim == 2 and self.thickness is not None and self.poisson == 0.5:
        return own
    if self.thickness is not None and self.dim == 2:
        self._response = Response(mdr.Layered([(mdr.Elastic(self.young, self.poisson), self.thickness)], mdr.RIGID))
        self._mean = self._response.mean("layers", self.physical_sizes)
    else:
        # the engine has a C(0) of its own on a half-space
        self._response, self._mean = Response(body_of(self)), float(own.ravel()[0].real)
    COUNT["periodic"] += 1
    return LayeredSubstrate._compute_greens_function(self)


def free(self):
    self._response = Response(body_of(self))
    COUNT["free"] += 1
    self._pixels = FreeLayeredSubstrate._pixels.__get__(self)
    return FreeLayeredSubstrate._compute_greens_function(self)


PERIODIC._compute_greens_function, FREE._compute_greens_function = periodic, free


def pytest_terminal_summary(terminalreporter):
    terminalreporter.write_line(f"substrates of mdrcontact: {COUNT['periodic']} periodic, {COUNT['free']} free")
"""


def failures(checkout: Path, folder: Path, options: list[str]) -> tuple[set[str], str]:
    """Names of the tests that fail, and the last lines of the report."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", DOWNLOADS, *options, "test"]
    path = os.pathsep.join(filter(None, [str(folder), os.environ.get("PYTHONPATH")]))
    run = subprocess.run(command, cwd=checkout, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        sys.exit(run.stdout[-3000:] + run.stderr[-3000:])
    report = [line for line in run.stdout.splitlines() if re.search(r"^FAILED|^substrates of| (passed|failed)", line)]
    return set(re.findall(r"^FAILED (\S+)", run.stdout, flags=re.MULTILINE)), "\n".join(report)


def main() -> None:
    """Runs the tests twice and compares."""
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "test").is_dir():
        sys.exit(f"{__doc__}")
    checkout = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "layered_substrates.py").write_text(PLUGIN, encoding="utf-8")
        own, report = failures(checkout, Path(folder), [])
        print(f"substrates of ContactMechanics:\n{report}\n", flush=True)
        layered, report = failures(checkout, Path(folder), ["-p", "layered_substrates"])
        print(f"substrates of layered bodies:\n{report}\n")
    new = layered - own
    wrong = {name for name in new if name.partition("[")[0] not in ROUNDING}
    print(f"tests that fail with layered bodies alone: {len(new)}, of rounding {len(new) - len(wrong)}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
