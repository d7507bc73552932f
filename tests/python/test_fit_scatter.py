# SPDX-License-Identifier: GPL-3.0-or-later
"""What fits say of the scatter of their data: too much, too little, or as the standard deviations say."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import OXIDE, SILICON
from scipy import stats

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.instruments.fitting.scatter import compare_scatter

FILM = mdr.Coated(OXIDE, 500e-9, SILICON)
RADIUS = np.geomspace(50e-9, 2e-6, 40)
MISSES, TOO_LARGE = "THE MODEL MISSES THE DATA", "errors given are"


def fit(noise, said, points=40, seed=0, bend=0.0, medium=FILM):
    """A film's moduli with noise of one size and standard deviations of another; `bend` is what the model does not have."""
    a = RADIUS[:: len(RADIUS) // points]
    random = np.random.default_rng(seed)
    y = np.asarray(FILM.modulus(a)) * (1.0 + noise * random.standard_normal(len(a)) + bend * np.linspace(-1.0, 1.0, len(a)) ** 2)
    data = mdi.ModulusRadius(a, y, relative_sd=said)
    return mdi.fit(data, mdr.Paraboloid(1e-5), medium, ["coating.E"] if medium is FILM else ["E"])


@pytest.mark.parametrize("said", [1e-6, 0.01, 0.5])
def test_data_without_noise_are_not_missed(said):
    result = fit(0.0, said)
    assert result.chi_square < 1e-3 * result.degrees_of_freedom
    assert result.describes_data is True and result.scatter == -1
    assert result.excess_of_errors**2 * result.chi_square == pytest.approx(result.degrees_of_freedom) or result.chi_square == 0.0
    for text in (result.summary(), result.report()):
        assert MISSES.lower() not in text.lower() and TOO_LARGE in text
    assert any(f"are {result.excess_words()} the scatter" in words for words in result.warnings)
    assert not any("not random" in words for words in result.warnings)


def test_data_without_noise_or_standard_deviations_are_not_missed():
    result = fit(0.0, None)
    assert result.describes_data is True and result.is_without_noise
    assert MISSES not in result.summary()
    assert [words[:40] for words in result.warnings] == ["the residuals are no larger than the rou"]


@pytest.mark.parametrize(("noise", "said", "scatter"), [(0.01, 0.01, 0), (0.01, 0.002, 1), (0.002, 0.01, -1), (0.01, 0.0125, 0)])
def test_both_sides_are_told(noise, said, scatter):
    result = fit(noise, said)
    assert result.scatter == scatter
    assert result.is_random is (scatter <= 0)
    assert result.describes_data is True and MISSES not in result.summary(), "by one part in a hundred"
    assert result.verdict.startswith("describes to") == (scatter > 0)
    assert (TOO_LARGE in result.summary()) == (scatter < 0)
    assert any("deviate from the fit by more" in words for words in result.warnings) == (scatter > 0)


@pytest.mark.parametrize("said", [0.001, None])
def test_a_model_that_misses_is_told(said):
    """A homogeneous body for a film: the misfit is far above rounding, with standard deviations and without."""
    result = fit(1e-3, said, medium=mdr.Homogeneous(SILICON))
    assert result.describes_data is False and MISSES in result.summary()


def test_a_misfit_within_the_errors_is_no_miss():
    result = fit(1e-5, 0.05, bend=1e-3)
    assert result.pattern_probability < 1e-3
    assert result.verdict == "describes" and result.scatter == -1


@pytest.mark.parametrize("points", [1, 2])
def test_few_points_say_nothing(points):
    result = fit(0.01, 0.01, points)
    assert result.scatter == 0 and result.describes_data is None
    assert MISSES not in result.summary() and TOO_LARGE not in result.summary()
    assert math.isnan(result.reduced_chi_square) == math.isnan(result.excess_of_errors) == (points == 1)


def test_one_degree_of_freedom_can_miss():
    """Two moduli of one body, fifty standard deviations apart: chi-square 1250 for one degree of freedom."""
    data = mdi.ModulusRadius([1e-7, 2e-7], [1e10, 1.5e10], sd=1e8)
    result = mdi.fit(data, mdr.Paraboloid(1e-5), mdr.Homogeneous(OXIDE), ["E"])
    assert result.scatter == 1 and result.describes_data is False


@pytest.mark.parametrize("n", [1.0, 1.7, 2.0, 3.0, 8.0, 50.0, 1000.0])
def test_the_scatter_is_judged_as_the_chi_square_distribution_does(n):
    """Never where one in a thousand is as far out; always where one in ten million is."""
    law = stats.chi2(n)
    for p, expected in ((1e-3, 0), (0.5, 0)):
        assert compare_scatter(law.ppf(p), n) == compare_scatter(law.isf(p), n) == expected
    assert compare_scatter(law.isf(1e-7), n) == 1
    assert compare_scatter(law.ppf(1e-7), n) == -1
    assert compare_scatter(0.0, n) == -1 and compare_scatter(0.0, 0.0) == 0 and compare_scatter(1e9, 0.5) == 0
