# SPDX-License-Identifier: GPL-3.0-or-later
"""Things many tests need. Units throughout: Pa, m, N."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import mdrcontact as mdr
from mdrcontact.state import NAMES

ROOT = Path(__file__).resolve().parents[2]

PHYSICS = (mdr, mdr.adhesion, mdr.conduction, mdr.lateral, mdr.plastic, mdr.poroelastic, mdr.time, mdr.wear)
"""Modules whose `__all__` holds public classes of physics."""
PUBLIC = (*PHYSICS, mdr.closed_forms, mdr.weights, mdr.errors, mdr.instruments)

OXIDE = mdr.Elastic(72e9, 0.17)
SILICON = mdr.Elastic(163e9, 0.22)
RUBBER = mdr.Elastic(2e6, 0.5)


def numbers_of(state: mdr.State) -> list[Any]:
    """The numbers of a state, or of several, in their order."""
    return [getattr(state, name) for name in NAMES]


def every_profile() -> list[mdr.Profile]:
    """One of each indenter, all about 1 um in size."""
    r = [0.0, 2e-7, 5e-7, 1e-6, 2e-6]
    return [
        mdr.Paraboloid(5e-6),
        mdr.Sphere(5e-6),
        mdr.Cone(0.3),
        mdr.PowerLaw(3.0, 1e10),
        mdr.FlatPunch(1e-6),
        mdr.FlatEndedCone(1e-7, 0.3),
        mdr.FlatEndedParaboloid(1e-7, 5e-6),
        mdr.RoundedCone(1e-7, 0.3),
        mdr.Berkovich(),
        mdr.Vickers(),
        mdr.CubeCorner(),
        mdr.AreaFunction([24.5, 2e-7], max_height=1e-6),
        mdr.TabulatedProfile(r, [x * x / 1e-5 for x in r]),
        mdr.TabulatedMDRProfile(r, [x * x / 5e-6 for x in r]),
        mdr.CallableProfile(parabola, 2e-6),
        mdr.Cone(0.1) + mdr.Paraboloid(5e-6),
    ]


def every_medium() -> list[mdr.Medium]:
    """One of each medium."""
    return [
        mdr.Homogeneous(OXIDE),
        mdr.Pair(mdr.Homogeneous(OXIDE), mdr.Homogeneous(SILICON)),
        *(mdr.Coated(OXIDE, 5e-7, SILICON, model) for model in ELASTIC_MODELS),
        mdr.Coated(OXIDE, 5e-7, SILICON, "gao", weight_nu=0.3),
        mdr.Coated(OXIDE, 5e-7, SILICON, "gao-series", weight_nu="effective"),
        mdr.Coated(OXIDE, 5e-7, SILICON, "gao-power", exponent=-0.3, weight_nu="effective"),
        mdr.Coated(OXIDE, 5e-7, SILICON, "doerner-nix", alpha=0.9),
        mdr.Coated(OXIDE, 5e-7, SILICON, "wave", wave_factor=2.0),
        mdr.Coated(OXIDE, 5e-7, SILICON, "exact"),
        mdr.Coated(OXIDE, 5e-7, mdr.RIGID, "exact", tolerance=1e-8),
        mdr.Coated(RUBBER, 5e-6, mdr.RIGID, "dimitriadis"),
        mdr.Coated(RUBBER, 5e-6, mdr.RIGID, "garcia"),
        mdr.Layered([(OXIDE, 2e-7), (SILICON, 3e-7)], OXIDE, "gao"),
        mdr.Layered([(OXIDE, 2e-7), (SILICON, 3e-7)], mdr.RIGID, "exact"),
        mdr.Graded([0.0, 1e-6, 2e-6], [72e9, 100e9, 163e9], 0.2, "gao"),
        mdr.Graded(2e-6, rising_modulus, 0.2, "gao-series"),
        mdr.PowerLawGraded(70e9, 1e-6, 0.3, 0.2),
        mdr.TabulatedMedium([1e-7, 1e-6, 1e-5], [80e9, 120e9, 160e9]),
        mdr.CallableMedium(rising_modulus, 1e-8, 1e-5),
        mdr.Pair(mdr.Coated(OXIDE, 5e-7, SILICON), mdr.Homogeneous(SILICON)),
        mdr.Pair(mdr.Coated(OXIDE, 5e-7, SILICON), mdr.Layered([(SILICON, 2e-7), (OXIDE, 3e-7)], mdr.RIGID)),
        mdr.Pair(mdr.Coated(OXIDE, 5e-7, SILICON, "bec"), mdr.Coated(SILICON, 2e-7, OXIDE, "gao")),
        mdr.Pair(mdr.Coated(OXIDE, 5e-7, SILICON, "bec"), mdr.Coated(SILICON, 2e-7, OXIDE)),
        mdr.Pair(mdr.PowerLawGraded(70e9, 1e-6, 0.3, 0.2), mdr.PowerLawGraded(90e9, 1e-6, 0.3, 0.3)),
        mdr.Pair(mdr.RIGID, mdr.Coated(OXIDE, 5e-7, SILICON)),
    ]


ELASTIC_MODELS = (
    "gao",
    "gao-series",
    "doerner-nix",
    "wave",
    "mencik-exponential",
    "mencik-reciprocal",
    "bec",
    "perriot-barthel",
    "hay-crawford",
    "gao-power",
)
"""The models of a coating on an elastic substrate."""


def parabola(r: float) -> float:
    """A height that pickles."""
    return r * r / 1e-5


def rising_modulus(z: float) -> float:
    """A modulus that pickles, 72 GPa at the surface."""
    return 72e9 + 91e9 * z / (z + 1e-6)


@pytest.fixture
def coated() -> mdr.Contact:
    """A sphere on an oxide on silicon."""
    return mdr.Contact(mdr.Sphere(10e-6), mdr.Coated(OXIDE, 500e-9, SILICON, "gao"))


def run(command, folder):
    """Runs a command that must succeed; returns what it prints."""
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="session")
def installed(tmp_path_factory):
    """The library as its users have it: in $MDRCONTACT_PREFIX if the caller has installed it, else built and installed here."""
    if "MDRCONTACT_PREFIX" in os.environ:
        return Path(os.environ["MDRCONTACT_PREFIX"])
    if not shutil.which("cmake") or not shutil.which("gfortran"):
        pytest.skip("needs cmake and gfortran, or MDRCONTACT_PREFIX")
    folder = tmp_path_factory.mktemp("library")
    build, prefix = folder / "build", folder / "prefix"
    options = ["-DMDRCONTACT_BUILD_TESTS=OFF", "-DMDRCONTACT_BUILD_EXAMPLES=OFF", f"-DCMAKE_INSTALL_PREFIX={prefix}"]
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    run(["cmake", "-S", ROOT, "-B", build, *generator, "-DCMAKE_BUILD_TYPE=Release", *options], folder)
    run(["cmake", "--build", build, "--parallel", "2"], folder)
    run(["cmake", "--install", build], folder)
    return prefix
