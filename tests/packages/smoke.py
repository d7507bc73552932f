# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether an installed package works: smoke.py FOLDER, an empty folder to write into.

Needs what the package itself declares and nothing more. One number of each part against a closed form or a known value, the command
line, and, on Linux, where every numerical library of the process was loaded from.
"""

import math
import os
import platform
import re
import runpy
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import numpy as np

import mdrcontact as mdr
import mdrcontact.instruments as mdi

NUMERICAL = re.compile(r"/lib(gslcblas|gsl|openblas|blas|lapack|gfortran|quadmath|gomp)[^/]*\.so[^/]*$")
"""Libraries that a self-contained package must bring along."""


def check(what, found, expected, relative):
    """Ends the program where `found` is not `expected`; NaN is not."""
    if not abs(found - expected) <= relative * abs(expected):
        sys.exit(f"smoke test: {what} is {found!r}, not {expected!r}")
    print(f"   {what}: {found:.10g}")


def homogeneous():
    """Hertz."""
    E_star, R, d = 72e9 / (1 - 0.17**2), 1e-5, 1e-7
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    check("Hertz's force [N]", contact.at_depth(d).force, 4 / 3 * E_star * math.sqrt(R) * d**1.5, 1e-12)


def exact_coated():
    """A flat punch on an incompressible layer on a rigid base, a = h: k (1 - nu)/(4 G a) = 3.61873585."""
    layer = mdr.Coated(mdr.Elastic(3.0, 0.5), 1.0, mdr.RIGID, "exact")
    check("exact layer, k (1 - nu)/(4 G a)", mdr.Contact(mdr.FlatPunch(1.0), layer).at_depth(0.1).stiffness / 8, 3.61873585, 2e-9)


def adhesive():
    """The pull-off force of Johnson, Kendall and Roberts."""
    contact = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(2e6, 0.5)), work_of_adhesion=0.05)
    check("pull-off force [N]", contact.pull_off().force, -1.5 * math.pi * 0.05 * 1e-5, 1e-10)


def fitted():
    """The modulus under which a curve of Hertz was made."""
    d = np.linspace(1e-8, 1e-7, 20)
    data = mdi.ForceDepth(d, 4 / 3 * (2e9 / 0.91) * math.sqrt(1e-5) * d**1.5)
    start = mdr.Homogeneous(mdr.Elastic(1e9, 0.3))
    check("fitted modulus [Pa]", mdi.fit(data, mdr.Paraboloid(1e-5), start, ["E"]).estimates["E"], 2e9, 1e-8)


def on_threads():
    """A compiled law in batches on two threads."""
    contact = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    d = np.linspace(1e-9, 1e-7, 100_000)
    mdr.set_threads(2)
    force = mdr.ContactLaw(contact, 1e-7).force(d)
    mdr.set_threads(1)
    check("law on two threads, sum of forces [N]", force.sum(), contact.at_depth(d).force.sum(), 1e-8)


def run(*arguments):
    """What the command `mdrcontact` of this environment prints."""
    command = Path(sys.executable).parent / "mdrcontact"
    done = subprocess.run([command, *arguments], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"smoke test: mdrcontact {' '.join(map(str, arguments))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def command_line(folder):
    """Version and a force-depth curve, 17.11 mN at 100 nm as README.md says."""
    version = metadata.version("mdrcontact")
    if not version == mdr.__version__ == run("--version").split()[-1]:
        sys.exit(f"smoke test: version is {version}, {mdr.__version__} and {run('--version')}")
    (folder / "problem.toml").write_text(run("example", "sio2_on_si"), encoding="utf-8")
    run("curve", folder / "problem.toml", "--csv", folder / "curve.csv")
    head, *rows = (line.split(",") for line in (folder / "curve.csv").read_text(encoding="utf-8").splitlines())
    check("mdrcontact curve, last force [mN]", float(rows[-1][head.index("force [mN]")]), 17.11, 3e-4)


def loaded_libraries():
    """Numerical libraries come from this environment, and those of the package's own language are among them."""
    loaded = {line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines() if ".so" in line}
    numerical = sorted(path for path in loaded if NUMERICAL.search(path))
    foreign = [path for path in numerical if not path.startswith(os.path.realpath(sys.prefix) + "/")]
    if foreign:
        sys.exit("smoke test: loaded from outside of the environment: " + ", ".join(foreign))
    ours = {NUMERICAL.search(path)[1] for path in numerical if "/mdrcontact.libs/" in path}
    if not {"gsl", "gfortran"} <= ours or not {"openblas", "lapack"} & ours:
        sys.exit(f"smoke test: mdrcontact brings along {sorted(ours)}: GSL, gfortran's library or LAPACK is not among them")
    print(f"   brought along: {', '.join(sorted(ours))}")


def c_library():
    """The C library of the package by ctypes: examples/clients/law_ctypes.py, or its copy beside this file."""
    here = Path(__file__).resolve()
    copy, original = here.with_name("law_ctypes.py"), here.parents[2] / "examples" / "clients" / "law_ctypes.py"
    runpy.run_path(str(copy if copy.exists() else original), run_name="__main__")


def main(folder):
    """All of it."""
    homogeneous()
    exact_coated()
    adhesive()
    fitted()
    on_threads()
    command_line(folder)
    c_library()
    if platform.system() == "Linux":
        loaded_libraries()
    print("smoke test passed")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
