# SPDX-License-Identifier: GPL-3.0-or-later
"""Where fits of forces begin, and when they have converged."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
import mdrcontact.instruments as mdi

BALL, GEL = mdr.Paraboloid(5e-6), mdr.Homogeneous(mdr.Elastic(1.2e3, 0.5))
FREE = ("E", "depth_offset", "force_offset")


def approach(seed=0, tail=0.0, begin=-3e-6, end=2e-6):
    """A curve with its baseline: contact begins at 0, force 2 nN; `tail` repels before it."""
    depth = np.linspace(begin, end, 5000)
    force = np.zeros_like(depth)
    force[depth > 0.0] = np.asarray(mdr.Contact(BALL, GEL).at_depth(depth[depth > 0.0]).force)
    force += tail * np.exp(np.minimum(depth, 0.0) / 6e-7) * (depth < 2e-8) + 2e-9
    return mdi.ForceDepth(depth, force + 2e-12 * np.random.default_rng(seed).standard_normal(len(depth)))


@pytest.mark.parametrize("factor", [1e-9, 1e3, 1e7])
def test_the_modulus_of_a_homogeneous_body_begins_by_division(factor):
    """Wherever the guess lies: it was refused from a factor of 300 on."""
    found = mdi.fit(approach(), BALL, mdr.Homogeneous(mdr.Elastic(1.2e3 * factor, 0.5)), FREE)
    near = mdi.fit(approach(), BALL, GEL, FREE)
    assert found.converged
    assert found.estimates["E"] == pytest.approx(near.estimates["E"], rel=1e-4)
    assert found.estimates["E"] == pytest.approx(1.2e3, rel=0.01)


def test_bounds_hold_where_a_search_begins():
    guess = mdr.Homogeneous(mdr.Elastic(1.0, 0.5))
    found = mdi.fit(approach(), BALL, guess, {"E": mdi.Free(1.0, upper=500.0), "depth_offset": None}, check_units=False)
    assert found.estimates["E"] <= 500.0


@pytest.mark.parametrize("seed", [3, 4, 5])
def test_a_search_that_is_at_the_minimum_has_converged(seed):
    """A force of long range before contact and a baseline two hundred times longer than the contact is deep: differences to one
    side hold half of their step times a large curvature."""
    data = approach(seed, 4e-11, -5e-5, 2.5e-7)
    found = mdi.fit(data, BALL, GEL, FREE)

    def scatter(offset):
        """Least squares over the two parameters in which the model is linear."""
        power = np.maximum(data.x - offset, 0.0) ** 1.5
        design = np.column_stack([power, np.ones_like(power)])
        return float(np.sum((data.y - design @ np.linalg.lstsq(design, data.y)[0]) ** 2))

    assert found.converged
    best, step = found.estimates["depth_offset"], 0.1 * found.standard_errors["depth_offset"]
    assert scatter(best) < scatter(best - step) and scatter(best) < scatter(best + step)


def test_the_scale_of_forces_alone_is_a_division():
    """One parameter: the estimate is the quotient of sums, to rounding of the model."""
    depth = np.linspace(1e-8, 1e-6, 200)
    force = np.asarray(mdr.Contact(BALL, GEL).at_depth(depth).force) * (1.0 + 0.05 * np.sin(40.0 * depth / depth[-1]))
    found = mdi.fit(mdi.ForceDepth(depth, force), BALL, mdr.Homogeneous(mdr.Elastic(1.0, 0.5)), ["E"])
    unit = np.asarray(mdr.Contact(BALL, mdr.Homogeneous(mdr.Elastic(1.0, 0.5))).at_depth(depth).force)
    assert found.estimates["E"] == pytest.approx(float(unit @ force / (unit @ unit)), rel=1e-6)


def test_weights_next_to_contact_leave_other_forces_out():
    """A repulsion before contact moves the modulus by a third of what it does without weights, or less."""
    clean = mdi.fit(approach(), BALL, GEL, FREE).estimates["E"]
    data = approach(tail=2e-10, begin=-4e-6)
    plain = mdi.fit(data, BALL, GEL, FREE)
    weighted = mdi.fit(data, BALL, GEL, FREE, contact_weight=1e-6)
    assert abs(plain.estimates["E"] / clean - 1.0) > 0.003
    assert abs(weighted.estimates["E"] / clean - 1.0) < abs(plain.estimates["E"] / clean - 1.0) / 2.0
    nothing = mdi.fit(approach(), BALL, GEL, FREE, contact_weight=1e-7)
    assert nothing.estimates["E"] == pytest.approx(clean, rel=0.01)


@pytest.mark.parametrize("distance", [3e-7, 1e-6])
def test_weights_that_follow_the_contact_point(distance):
    """The sum of squares whose weights move with the contact point is at a minimum, which those that are held miss; its errors say
    how far the estimates scatter."""
    data = approach(tail=2e-10, begin=-4e-6)
    found = mdi.fit(data, BALL, GEL, FREE, contact_weight=distance, contact_weight_rule="moving")

    def square(values):
        at, modulus, offset = values
        unit = np.asarray(
            mdr.Contact(BALL, GEL.replace(material=GEL.material.replace(E=modulus))).at_depth(np.maximum(data.x - at, 0.0)).force
        )
        return np.sum(((data.y - offset - unit) * np.clip(np.abs(data.x - at) / distance, 0.01, 1.0)) ** 2)

    best = np.array([found.estimates[name] for name in ("depth_offset", "E", "force_offset")])
    errors = np.array([found.standard_errors[name] for name in ("depth_offset", "E", "force_offset")])
    assert (errors > 0.0).all()
    for i in range(3):
        for sign in (-1.0, 1.0):
            away = best.copy()
            away[i] += 0.3 * sign * errors[i]
            assert square(away) > square(best)
    held = mdi.fit(data, BALL, GEL, FREE, contact_weight=distance)
    assert square([held.estimates[name] for name in ("depth_offset", "E", "force_offset")]) > square(best)


@pytest.mark.slow
def test_moving_weights_cover():
    """Curves of noise alone: the modulus scatters as its standard error says."""
    off = []
    for seed in range(30):
        found = mdi.fit(approach(seed=seed), BALL, GEL, FREE, contact_weight=5e-7, contact_weight_rule="moving")
        off.append((found.estimates["E"] - 1.2e3) / found.standard_errors["E"])
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.6
    with pytest.raises(mdr.MDRError, match="contact_weight_rule"):
        mdi.fit(approach(), BALL, GEL, FREE, contact_weight=5e-7, contact_weight_rule="none")


@pytest.mark.parametrize("distance", [-1e-9, float("nan"), float("inf")])
def test_wrong_weights_are_refused(distance):
    with pytest.raises(mdr.errors.InvalidArgumentError, match="contact_weight"):
        mdi.fit(approach(), BALL, GEL, FREE, contact_weight=distance)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="forces against depth"):
        mdi.fit(mdi.ModulusRadius([1e-7, 2e-7, 3e-7], [1e9, 2e9, 1e9]), BALL, GEL, ["E"], contact_weight=1e-9)


def test_a_missing_offset_is_named_where_a_search_loses_a_parameter():
    """A flat punch that touches at 1 mm: terms[0].time was blamed alone."""
    time, depth, force = np.loadtxt(ROOT / "tests" / "data" / "cases" / "prony_start.txt", skiprows=1, unpack=True)
    data, punch = mdi.ForceTime(time, 1e-3 * depth, force), mdr.FlatPunch(4e-3)
    body = mdr.Homogeneous(mdr.Viscoelastic(5e3, [(5e3, 1.0), (5e3, 10.0)], nu=0.49))
    free = ["relaxed_shear_modulus", *(f"terms[{i}].{name}" for i in (0, 1) for name in ("modulus", "time"))]
    with pytest.raises(mdr.MDRError, match="do not depend on it.*if contact does not begin at depth 0, let depth_offset be free"):
        mdi.fit(data, punch, body, free)
    with pytest.raises(mdr.MDRError, match="give it a prior$"):
        mdi.fit(data, punch, body, free, instrument=mdi.Instrument(depth_offset=1e-6))
    deeper = mdi.ForceTime(time, 1e-3 * depth + 1e-3, force)
    with pytest.raises(mdr.MDRError, match=r"relaxed_shear_modulus = 0.*if contact does not begin at depth 0, let depth_offset"):
        mdi.fit(deeper, punch, body, free)
    found = mdi.fit(data, punch, body, [*free, "depth_offset"])
    for name, value in zip([*free, "depth_offset"], (2e3, 3e3, 0.4, 2e3, 5.0, 1e-3), strict=True):
        assert found.estimates[name] == pytest.approx(value, rel=0.06), name
