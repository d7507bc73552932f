# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesive curves as they are measured: baseline, jumps, both branches. The truth is JKR in closed form, written out here."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

import mdrcontact as mdr
import mdrcontact.instruments as mdi

R, GAMMA, MODULUS = 5e-6, 0.05, mdr.Elastic(2e6, 0.49)
STAR = MODULUS.contact_modulus
LAST_RADIUS = (np.pi * GAMMA * R**2 / (8.0 * STAR)) ** (1.0 / 3.0)
"""a at pull-off under displacement control, where d(a) is smallest"""
BODY = mdr.Homogeneous(mdr.Elastic(1e6, 0.49))


def depth_at(a):
    return a**2 / R - np.sqrt(2.0 * np.pi * a * GAMMA / STAR)


def force_at(d):
    a = brentq(lambda a: depth_at(a) - d, LAST_RADIUS, 1e-5, xtol=1e-22, rtol=1e-15)
    return 4.0 * STAR * a**3 / (3.0 * R) - np.sqrt(8.0 * np.pi * a**3 * GAMMA * STAR)


PULL_OFF = float(depth_at(LAST_RADIUS))
CONTACT = np.linspace(300e-9, 0.999 * PULL_OFF, 300)
FORCE = np.array([force_at(d) for d in CONTACT])


def unloading(baseline):
    """Depth and force, exact, with so many points after pull-off."""
    d = 1.001 * PULL_OFF - np.linspace(0.0, 2e-6, baseline) if baseline else np.zeros(0)
    return np.r_[CONTACT, d], np.r_[FORCE, np.zeros(baseline)]


def loading(points=400):
    """Depth and force from afar: nothing before first touch."""
    d = np.linspace(-500e-9, 300e-9, points)
    return d, np.array([0.0 if x < 0.0 else force_at(x) for x in d])


@pytest.mark.parametrize("start", [0.005, 0.03, 0.5])
@pytest.mark.parametrize("baseline", [0, 20, 100, 600])
def test_a_baseline_does_not_change_the_work_of_adhesion(baseline, start):
    result = mdi.fit(
        mdi.ForceDepth(*unloading(baseline)),
        mdr.Paraboloid(R),
        BODY,
        ["E", "work_of_adhesion"],
        instrument=mdi.Instrument(work_of_adhesion=start),
    )
    assert result.converged
    assert result.estimates["work_of_adhesion"] == pytest.approx(GAMMA, rel=1e-6)
    assert result.estimates["E"] == pytest.approx(MODULUS.E, rel=1e-6)


def test_a_whole_curve_is_taken_as_it_is():
    """Approach from afar, jump into contact, some points of overshoot at the turn, retraction, pull-off, long baseline; noise and
    an offset of either axis. Each point is on its branch."""
    approach, pressed = loading()
    d, f = unloading(600)
    over = np.array([1.0, 3.0, 2.0, 4.0, 3.0]) * 1e-9
    depth = np.r_[approach, 300e-9 + over, d] + 30e-9
    force = np.r_[pressed, [force_at(300e-9 + x) for x in over], f] + 5e-9
    for seed in range(5):
        noise = 20e-9 * np.random.default_rng(seed).standard_normal(depth.size)
        data = mdi.ForceDepth(depth, force + noise)
        assert data.branch is not None and not data.warnings
        result = mdi.fit(
            data,
            mdr.Paraboloid(R),
            BODY,
            ["E", "work_of_adhesion", "depth_offset", "force_offset"],
            instrument=mdi.Instrument(work_of_adhesion=0.03),
        )
        assert result.converged
        truth = {"E": MODULUS.E, "work_of_adhesion": GAMMA, "depth_offset": 30e-9, "force_offset": 5e-9}
        for name, true in truth.items():
            assert abs(result.estimates[name] - true) < 4.0 * result.standard_errors[name]
        assert result.standard_errors["work_of_adhesion"] < 0.01 * GAMMA
        assert not result.warnings


@pytest.mark.parametrize("branch", ["loading", "unloading"])
def test_one_branch_of_a_curve(branch):
    approach, pressed = loading()
    d, f = unloading(100)
    data = mdi.ForceDepth(np.r_[approach, d], np.r_[pressed, f]).on(branch)
    result = mdi.fit(data, mdr.Paraboloid(R), BODY, ["E", "work_of_adhesion"], instrument=mdi.Instrument(work_of_adhesion=0.03))
    assert result.estimates["work_of_adhesion"] == pytest.approx(GAMMA, rel=1e-6)
    again = mdi.ForceDepth(data.x, data.y, branch=branch)
    assert len(again) == len(data)


def test_the_model_is_apart_beyond_pull_off_and_before_first_touch():
    """The prediction alone, without data that would say what is in contact."""
    d = np.array([1.5 * PULL_OFF, 0.9 * PULL_OFF, 100e-9])
    instrument = mdi.Instrument(work_of_adhesion=GAMMA, force_offset=1e-9)
    for branch, expected in (("unloading", [0.0, force_at(d[1]), force_at(d[2])]), ("loading", [0.0, 0.0, force_at(d[2])])):
        data = mdi.ForceDepth(d, [0.0, 1e-9, 2e-9], branch=branch)
        result = mdi.fit(
            data, mdr.Paraboloid(R), mdr.Homogeneous(MODULUS), ["force_offset"], instrument=instrument, check_units=False
        )
        values = np.array(list(result.values.values()))
        values[list(result.values).index("force_offset")] = 1e-9
        assert result.problem.predict(values)[0] == pytest.approx(np.array(expected) + 1e-9, rel=1e-6)


def test_no_adhesion_is_found_as_none():
    """A curve of Hertz: gamma goes to its limit 0, and that is said; it is no estimate with an error."""
    d = np.linspace(1e-9, 300e-9, 200)
    force = 4.0 / 3.0 * STAR * np.sqrt(R) * d**1.5
    noisy = force + 0.002 * force.max() * np.random.default_rng(1).standard_normal(d.size)
    result = mdi.fit(
        mdi.ForceDepth(d, noisy - 0.001 * force.max() * (d > 100e-9)),
        mdr.Paraboloid(R),
        BODY,
        ["E", "work_of_adhesion"],
        instrument=mdi.Instrument(work_of_adhesion=0.03),
    )
    value, error = result.estimates["work_of_adhesion"], result.standard_errors["work_of_adhesion"]
    assert result.at_bound["work_of_adhesion"] == -1 or abs(value) < 4.0 * error
    assert error < 0.05
    assert "6105" not in result.summary()


@pytest.mark.parametrize(("branch", "words"), [("up", "'loading'"), (["loading"], "the same length")])
def test_wrong_branches_are_refused(branch, words):
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
        mdi.ForceDepth([1e-9, 2e-9], [1e-9, 2e-9], branch=branch)
