# SPDX-License-Identifier: GPL-3.0-or-later
"""The mean of tests: its interval holds the truth as often as it says."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.instruments.fitting.between import _paule_mandel

TIP, MODULUS, NU = mdr.Paraboloid(1e-5), 72e9, 0.17
RADIUS = np.linspace(1e-7, 1e-6, 12)


def folder(random, tests, scatter, noise=0.01, area=0.0):
    """Fits of tests whose moduli scatter; the tip's area is wrong by the same part in all of them."""
    found = []
    wrong = math.sqrt(1.0 + area * random.standard_normal())
    free = {"E": None, **({"area_factor": mdi.Free(prior=(1.0, area))} if area else {})}
    for _ in range(tests):
        true = MODULUS * (1.0 + scatter * random.standard_normal())
        y = true / (1.0 - NU**2) * wrong * (1.0 + noise * random.standard_normal(len(RADIUS)))
        data = mdi.ModulusRadius(RADIUS, y, relative_sd=noise)
        found.append(mdi.fit(data, TIP, mdr.Homogeneous(mdr.Elastic(60e9, NU)), free))
    return found


@pytest.mark.parametrize(
    ("tests", "scatter", "area"),
    [(3, 0.02, 0.0), (5, 0.01, 0.02)]
    + [pytest.param(*row, marks=pytest.mark.slow) for row in [(8, 0.005, 0.0), (8, 0.02, 0.0), (16, 0.002, 0.0)]],
)
def test_two_hundred_folders(tests, scatter, area):
    """95 % intervals of 200 folders: 91 to 98 % of them hold the truth. Intervals from the errors of the tests alone hold 26 to
    87 % where the tests scatter."""
    random = np.random.default_rng(tests)
    inside = sum(
        mean.interval.lower <= MODULUS <= mean.interval.upper
        for mean in (mdi.mean_of_tests(folder(random, tests, scatter, area=area), "E") for _ in range(200))
    )
    assert 182 <= inside <= 196


def test_the_scatter_between_tests_is_found():
    random = np.random.default_rng(0)
    means = [mdi.mean_of_tests(folder(random, 20, 0.02), "E") for _ in range(20)]
    assert np.sqrt(np.mean([mean.between**2 for mean in means])) == pytest.approx(0.02 * MODULUS, rel=0.1)
    assert all(mean.tests == 20 and mean.common == 0.0 for mean in means)


def test_what_all_tests_share_is_not_averaged():
    """An area known to 4 % leaves the modulus known to 2 %, however many tests there are."""
    mean = mdi.mean_of_tests(folder(np.random.default_rng(1), 30, 0.0, 0.001, 0.04), "E")
    assert mean.common == pytest.approx(0.02 * mean.value, rel=0.02)
    assert mean.standard_error == pytest.approx(mean.common, rel=0.01)


def test_equal_errors_give_students_interval():
    """Hartung and Knapp's is then that of the plain mean."""
    found = folder(np.random.default_rng(2), 6, 0.05)
    values = np.array([r.estimates["E"] for r in found])
    mean = mdi.mean_of_tests(found, "E", 0.9)
    low, high = stats.t.interval(0.9, 5, values.mean(), stats.sem(values))
    assert mean.interval == pytest.approx((low, high), rel=1e-3)


def test_the_variance_between_solves_its_equation():
    random = np.random.default_rng(3)
    own = random.uniform(0.5, 2.0, 12)
    values = random.standard_normal(12) * np.sqrt(own + 4.0)
    between = _paule_mandel(values, own)
    weight = 1.0 / (own + between)
    assert weight @ (values - weight @ values / weight.sum()) ** 2 == pytest.approx(11.0, rel=1e-9)
    assert _paule_mandel(np.ones(5), np.ones(5)) == 0.0


def test_one_test_has_no_mean():
    found = folder(np.random.default_rng(0), 1, 0.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="needs two"):
        mdi.mean_of_tests(found, "E")


def test_a_calibration_that_scatters_is_a_wider_prior():
    """By chi-square over the degrees of freedom."""
    y = MODULUS / (1.0 - NU**2) * (1.0 + 0.04 * np.random.default_rng(0).standard_normal(len(RADIUS)))
    data = mdi.ModulusRadius(RADIUS, y, relative_sd=0.01)
    known = mdr.Homogeneous(mdr.Elastic(MODULUS, NU))
    result = mdi.fit(data, mdr.Paraboloid(1e-5), known, ["area_factor"])
    assert result.scatter == 1
    expected = result.covariance * result.reduced_chi_square
    assert np.array(mdi.as_prior(result).covariance) == pytest.approx(expected)
