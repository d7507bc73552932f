# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays on several threads: the same bits for every number of threads, the first error, callers with threads of their own."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import OXIDE, SILICON, numbers_of

import mdrcontact as mdr
from mdrcontact.closed_forms import (
    coated_cone_force,
    coated_paraboloid_adhesive_depth,
    coated_paraboloid_force,
    reduced_adhesive_depth,
)
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
    "height": lambda: BALL.height(MANY),
    "slope": lambda: BALL.slope(MANY),
    "mdr": lambda: BALL.mdr(MANY),
    "mdr_slope": lambda: BALL.mdr_slope(MANY),
    "modulus": lambda: GAO.medium.modulus(MANY),
    "exact modulus": lambda: EXACT.medium.modulus(FEW),
    "stiffness": lambda: GAO.medium.stiffness(MANY),
    "phi": lambda: mdr.weights.weight_phi(MANY, 0.3),
    "i0": lambda: mdr.weights.weight_i0(MANY, 0.3),
    "i1": lambda: mdr.weights.weight_i1(MANY),
    "j0": lambda: mdr.weights.weight_j0(MANY, 0.3),
    "j1": lambda: mdr.weights.weight_j1(MANY),
    "gao at_depth": lambda: GAO.at_depth(SOME),
    "gao at_force": lambda: GAO.at_force(SOME),
    "gao at_radius": lambda: GAO.at_radius(SOME),
    "sticky at_depth": lambda: STICKY.at_depth(SOME, "loading"),
    "exact at_depth": lambda: EXACT.at_depth(FEW),
    "exact at_force": lambda: EXACT.at_force(FEW),
    "exact at_radius": lambda: EXACT.at_radius(FEW),
    "hertz at_force": lambda: HERTZ.at_force(MANY),
    "pressure": lambda: GAO.at_radius(1e-6).pressure(SOME),
    "exact pressure": lambda: EXACT.at_depth(1e-7).pressure(SOME),
    "displacement": lambda: EXACT.at_force(1e-4).displacement(3.0 * SOME),
    "line_load": lambda: STICKY.at_depth(1e-7).line_load(SOME),
    "paraboloid": lambda: coated_paraboloid_force(MANY, 1.0, 3.0, 1.0, 0.5),
    "cone": lambda: coated_cone_force(MANY, 0.3, 3.0, 1.0, 0.5),
    "adhesive": lambda: coated_paraboloid_adhesive_depth(MANY, 1.0, 3.0, 1.0, 0.5, 0.1),
    "reduced": lambda: reduced_adhesive_depth(MANY, 3.0, 0.5),
    "density": lambda: density(MANY, MANY, 0.3),
    "structure": lambda: INCLUSION.modulus(FEW, 0.0, 1e-6),
}


def on(threads, call):
    """What a call gives on so many threads."""
    mdr.set_threads(threads)
    try:
        found = call()
        return np.asarray(numbers_of(found) if isinstance(found, mdr.State) else found)
    finally:
        mdr.set_threads(1)


@pytest.mark.parametrize("name", CALLS)
def test_same_bits_for_any_number_of_threads(name):
    alone = on(1, CALLS[name])
    assert np.all(np.isfinite(alone))
    for threads in (2, 3, 0):
        np.testing.assert_array_equal(on(threads, CALLS[name]), alone)


def test_callers_threads():
    alone = {name: on(1, call) for name, call in CALLS.items()}
    with ThreadPoolExecutor(3) as pool:
        for name, found in pool.map(lambda name: (name, on(2, CALLS[name])), [*CALLS, *CALLS]):
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
        with pytest.raises(mdr.errors.UnreachableError, match="entry 41 of depth = -2: "):
            on(threads, lambda contact=contact: contact.at_depth(depth))
    with pytest.raises(mdr.errors.DomainError, match="r = 5:"):
        on(threads, lambda: GAO.at_radius(1e-6).pressure(np.r_[np.zeros(131), 5.0, 6.0, np.zeros(80)]))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 41 of xi"):
        on(threads, lambda: mdr.weights.weight_i0(depth))


def test_what_is_no_number_of_threads_is_refused():
    with pytest.raises(ValueError, match="threads = -1:"):
        mdr.set_threads(-1)
    for wrong in (1.5, "2", True, None):
        with pytest.raises(TypeError, match="threads"):
            mdr.set_threads(wrong)


def test_shapes_and_numbers():
    mdr.set_threads(2)
    assert mdr.weights.weight_i0([]).shape == (0,)
    assert isinstance(GAO.at_depth(1e-8).force, float)
    assert GAO.at_depth(SOME.reshape(10, 15)).force.shape == (10, 15)
    mdr.set_threads(1)


def test_environment_sets_what_0_means():
    """OMP_NUM_THREADS is OpenMP's own: 0 follows it."""
    script = (
        "import numpy as np, mdrcontact as m; m.set_threads(0); print(m.weights.weight_i0(np.linspace(0, 9, 40000)).sum().hex())"
    )
    found = {
        subprocess.run(
            [sys.executable, "-c", script], env={**os.environ, "OMP_NUM_THREADS": n}, capture_output=True, text=True, check=True
        ).stdout
        for n in ("1", "2", "4")
    }
    assert len(found) == 1
