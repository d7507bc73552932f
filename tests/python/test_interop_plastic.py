# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic laws in numba and JAX, and in the operations of NumPy that the latter uses."""

from __future__ import annotations

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact import interop
from mdrcontact.interop._plastic import Steps
from mdrcontact.plastic import PlasticLaw, Yielding

METAL = Yielding(mdr.Elastic(1.0, 0.3), yield_stress=1e-4)
RISING = Yielding(mdr.Elastic(1.0, 0.3), hardening=[(0.0, 1e-4), (1e-4, 1.5e-4)])
LAWS = {"perfect": METAL, "hardening": RISING}


@pytest.fixture(params=LAWS, scope="module")
def law(request):
    return PlasticLaw(mdr.Paraboloid(1.0), LAWS[request.param], 1e-5)


def path(law):
    """Largest depths before steps, depths after them."""
    rng = np.random.default_rng(5)
    deepest = np.r_[np.zeros(500), law.largest_depth * rng.uniform(0.0, 1.0, 1500) ** 3]
    depth = np.r_[law.largest_depth * rng.uniform(-0.1, 1.0, 1500) ** 3, deepest[1500:] * rng.uniform(0.9, 1.0, 500)]
    return deepest, depth


def expected(law, deepest, depth):
    memory = deepest[:, None].copy()
    return law.advance(memory, depth), memory[:, 0]


def test_operations_of_arrays(law):
    deepest, depth = path(law)
    step, kept = expected(law, deepest, depth)
    force, after = Steps(law, np, np.asarray, np.asarray)(depth, deepest)
    assert np.array_equal(after, kept)
    assert force == pytest.approx(step.force, rel=1e-11, abs=1e-14 * law.largest_force)
    wrong = Steps(law, np, np.asarray, np.asarray)(np.array([1.1e-5, np.nan, 1e-6]), np.array([0.0, 0.0, -1.0]))
    assert np.isnan(wrong).all()


def test_adhesion_is_refused():
    sticky = PlasticLaw(mdr.Paraboloid(1.0), METAL, 1e-5, work_of_adhesion=1e-13)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="without adhesion"):
        Steps(sticky, np, np.asarray, np.asarray)


def test_numba(law):
    pytest.importorskip("numba")
    step_of = interop.numba_plastic_function(law)
    deepest, depth = path(law)
    step, kept = expected(law, deepest, depth)
    found = np.array([step_of(d, m) for d, m in zip(depth, deepest, strict=True)])
    assert np.array_equal(found[:, 2], kept)
    assert found[:, 0] == pytest.approx(step.force, rel=1e-11, abs=1e-14 * law.largest_force)
    assert found[:, 1] == pytest.approx(step.stiffness, rel=1e-11)
    assert np.isnan(step_of(1.1e-5, 0.0)).all() and np.isnan(step_of(np.nan, 0.0)).all()


def test_jax(law):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    steps = jax.jit(interop.jax_plastic_function(law))
    deepest, depth = path(law)
    step, kept = expected(law, deepest, depth)
    force, after = steps(depth, deepest)
    assert np.array_equal(after, kept)
    assert np.asarray(force) == pytest.approx(step.force, rel=1e-11, abs=1e-14 * law.largest_force)
    slope = jax.vmap(jax.grad(lambda d, m: steps(d, m)[0]))(depth, deepest)
    moved = depth != 0.0
    assert np.asarray(slope)[moved] == pytest.approx(step.stiffness[moved], rel=1e-6, abs=1e-9 * np.max(step.stiffness))
