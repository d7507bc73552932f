# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays on several threads: the same bits for every number of threads, the first error, callers with threads of their own."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import OXIDE, SILICON

import mdrcontact as mdr
from mdrcontact.lateral import Ball, Shapes, density

MANY = np.geomspace(1e-3, 1e3, 40_001)
SOME = np.linspace(1e-9, 4e-7, 150)
FEW = np.linspace(1e-9, 4e-7, 9)
BALL = mdr.Paraboloid(1e-5)
GAO = mdr.Contact(BALL, mdr.Coated(OXIDE, 5e-7, SILICON, "gao"))
STICKY = mdr.Contact(BALL, mdr.Coated(OXIDE, 5e-7, SILICON, "gao"), work_of_adhesion=0.1)
EXACT = mdr.Contact(BALL, mdr.Coated(OXIDE, 5e-7, SILICON, "exact"))
HERTZ = mdr.Contact(BALL, mdr.Homogeneous(SILICON))
INCLUSION = Shapes(SILICON, [Ball((0.0, 0.0, 1e-6), 5e-7, OXIDE)])

CALLS = {
    "height": lambda t: BALL.height(MANY, threads=t),
    "slope": lambda t: BALL.slope(MANY, threads=t),
    "mdr": lambda t: BALL.mdr(MANY, threads=t),
    "mdr_slope": lambda t: BALL.mdr_slope(MANY, threads=t),
    "modulus": lambda t: GAO.medium.modulus(MANY, threads=t),
    "exact modulus": lambda t: EXACT.medium.modulus(FEW, threads=t),
    "stiffness": lambda t: GAO.medium.stiffness(MANY, threads=t),
    "phi": lambda t: mdr.weight_phi(MANY, 0.3, threads=t),
    "i0": lambda t: mdr.weight_i0(MANY, 0.3, threads=t),
    "i1": lambda t: mdr.weight_i1(MANY, threads=t),
    "j0": lambda t: mdr.weight_j0(MANY, 0.3, threads=t),
    "j1": lambda t: mdr.weight_j1(MANY, threads=t),
    "gao at_depth": lambda t: GAO.at_depth(SOME, threads=t),
    "gao at_force": lambda t: GAO.at_force(SOME, threads=t),
    "gao at_radius": lambda t: GAO.at_radius(SOME, threads=t),
    "sticky at_depth": lambda t: STICKY.at_depth(SOME, "loading", threads=t),
    "exact at_depth": lambda t: EXACT.at_depth(FEW, threads=t),
    "exact at_force": lambda t: EXACT.at_force(FEW, threads=t),
    "exact at_radius": lambda t: EXACT.at_radius(FEW, threads=t),
    "hertz at_force": lambda t: HERTZ.at_force(MANY, threads=t),
    "pressure": lambda t: GAO.pressure(SOME, radius=1e-6, threads=t),
    "exact pressure": lambda t: EXACT.pressure(SOME, depth=1e-7, threads=t),
    "displacement": lambda t: EXACT.displacement(3.0 * SOME, force=1e-4, threads=t),
    "line_load": lambda t: STICKY.line_load(SOME, depth=1e-7, threads=t),
    "paraboloid": lambda t: mdr.coated_paraboloid_force(MANY, 1.0, 3.0, 1.0, 0.5, threads=t),
    "cone": lambda t: mdr.coated_cone_force(MANY, 0.3, 3.0, 1.0, 0.5, threads=t),
    "adhesive": lambda t: mdr.coated_paraboloid_adhesive_depth(MANY, 1.0, 3.0, 1.0, 0.5, 0.1, threads=t),
    "reduced": lambda t: mdr.reduced_adhesive_depth(MANY, 3.0, 0.5, threads=t),
    "density": lambda t: density(MANY, MANY, 0.3, threads=t),
    "structure": lambda t: INCLUSION.modulus(FEW, 0.0, 1e-6, threads=t),
}


@pytest.mark.parametrize("name", CALLS)
def test_same_bits_for_any_number_of_threads(name):
    alone = np.asarray(CALLS[name](1))
    assert np.all(np.isfinite(alone))
    for threads in (2, 3, 0):
        np.testing.assert_array_equal(np.asarray(CALLS[name](threads)), alone)


def test_callers_threads():
    alone = {name: np.asarray(call(1)) for name, call in CALLS.items()}
    with ThreadPoolExecutor(3) as pool:
        for name, found in pool.map(lambda name: (name, np.asarray(CALLS[name](2))), [*CALLS, *CALLS]):
            np.testing.assert_array_equal(found, alone[name])


def test_lock_is_released():
    """Two Python threads run their calls at the same time: each sees the other at work before its own is done."""
    script = """
import threading, numpy as np, mdrcontact as mdr
contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(mdr.Elastic(2.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "gao"))
force, inside, seen = np.linspace(1e-3, 1.0, 20_000), threading.Event(), []
def work():
    inside.set()
    contact.at_force(force)
    inside.clear()
thread = threading.Thread(target=work)
thread.start()
inside.wait()
while inside.is_set():
    seen.append(1)
thread.join()
print(len(seen))
"""
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert int(run.stdout) > 1000


@pytest.mark.parametrize("threads", [1, 2, 3, 0])
def test_first_error_is_named(threads):
    depth = SOME.copy()
    depth[[40, 41, 149]] = [-2.0, -1.0, np.nan]
    for contact in (GAO, EXACT):
        with pytest.raises(mdr.UnreachableError, match="entry 41 of in: depth = -2 "):
            contact.at_depth(depth, threads=threads)
    with pytest.raises(mdr.DomainError, match="r = 5 "):
        GAO.pressure(np.r_[np.zeros(131), 5.0, 6.0, np.zeros(80)], radius=1e-6, threads=threads)
    with pytest.raises(mdr.InvalidArgumentError, match="entry 41 of xi"):
        mdr.weight_i0(depth, threads=threads)


@pytest.mark.parametrize("name", CALLS)
def test_what_is_no_number_of_threads_is_refused(name):
    with pytest.raises(ValueError, match="threads = -1 is not allowed"):
        CALLS[name](-1)
    for wrong in (1.5, "2", True, None):
        with pytest.raises(TypeError, match="threads"):
            CALLS[name](wrong)


def test_shapes_and_numbers():
    assert mdr.weight_i0([], threads=2).shape == (0,)
    assert isinstance(GAO.at_depth(1e-8, threads=2).force, float)
    assert GAO.at_depth(SOME.reshape(10, 15), threads=2).force.shape == (10, 15)


def test_environment_sets_what_0_means():
    """OMP_NUM_THREADS is OpenMP's own: 0 follows it."""
    script = "import numpy as np, mdrcontact as m; print(m.weight_i0(np.linspace(0, 9, 40000), threads=0).sum().hex())"
    found = {
        subprocess.run(
            [sys.executable, "-c", script], env={**os.environ, "OMP_NUM_THREADS": n}, capture_output=True, text=True, check=True
        ).stdout
        for n in ("1", "2", "4")
    }
    assert len(found) == 1
