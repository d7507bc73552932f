# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals and verdicts of few readings: as long as the readings leave them, and no more said than they can tell."""

from __future__ import annotations

import functools
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import OXIDE, SILICON
from scipy import stats

import mdrcontact as mdr
import mdrcontact.instruments as mdi

STUDY = Path(__file__).parents[2] / "benchmarks"
FILM = mdr.Coated(OXIDE, 500e-9, SILICON, "exact")
POLYMER = mdr.Elastic(10e9, 0.35)
BALL = mdr.Paraboloid(10e-6)


def fit(x, y, medium, free=("coating.E",), **options):
    return mdi.fit(mdi.ModulusRadius(x, y, **options), BALL, medium, free)


def noisy(readings, seed, noise, medium=FILM):
    radius = np.geomspace(50e-9, 2e-6, readings)
    return radius, np.asarray(medium.modulus(radius)) * (1.0 + noise * np.random.default_rng(seed).standard_normal(readings))


@functools.cache
def fits(readings, free):
    """Fits of 200 draws of noise."""
    return [fit(*noisy(readings, seed, 0.01), FILM, free) for seed in range(200)]


def lengths(readings):
    """Mean half length of intervals over 1.96 standard deviations of the estimates, and how often they hold the truth."""
    found = fits(readings, ("coating.E",))
    ends = np.array([one.interval("coating.E") for one in found])
    spread = np.std([one.estimates["coating.E"] for one in found])
    return np.mean(0.5 * np.ptp(ends, axis=1)) / (1.96 * spread), np.mean((ends[:, 0] < OXIDE.E) & (ends[:, 1] > OXIDE.E))


def test_intervals_of_few_readings_are_no_longer_than_they_must_be():
    """8 readings had intervals 15 times the scatter of their estimates. 186 of 200 are 93 %."""
    lengths_of, held = zip(*(lengths(n) for n in (5, 8, 12, 20)), strict=True)
    assert np.all(np.diff(lengths_of) < 0.0) and lengths_of[0] < 3.0 and lengths_of[-1] < 1.45
    assert min(held) >= 0.92


def test_three_intervals_of_eight_readings_agree():
    """The profile was 289 to 589 GPa where the simulations were 406 to 421."""
    result = fit(*noisy(8, 0, 0.01), FILM)
    normal = np.ptp(result.interval("coating.E"))
    assert np.ptp(result.interval("coating.E", method="profile")) == pytest.approx(normal, rel=0.1)
    simulated = np.ptp(result.interval("coating.E", method="monte-carlo", draws=400, seed=1))
    assert 0.4 * normal < simulated < 1.2 * normal


@pytest.mark.parametrize("readings", [5, 8, 30])
@pytest.mark.parametrize("free", [("coating.E",), ("coating.E", "thickness")])
def test_patterns_are_as_rare_as_they_say(readings, free):
    """Probabilities of right models are uniform: Kolmogorov's test of 200 of them fails once in ten thousand."""
    found = [one.pattern_probability for one in fits(readings, free)]
    assert stats.kstest(found, "uniform").pvalue > 1e-4


@pytest.mark.parametrize("seed", range(20))
def test_a_film_on_its_own_substrate_is_found_on_eight_readings(seed):
    """Coating and substrate are swapped: this was "describes the data: misfit 24 %" for all seeds."""
    soft = mdr.Coated(POLYMER, 500e-9, SILICON, "exact")
    result = fit(*noisy(8, seed, 0.02, soft), mdr.Coated(SILICON, 500e-9, POLYMER, "exact"))
    assert result.describes_data is False and result.verdict.startswith("misses by")
    assert any("misses the data" in words for words in result.warnings)


def test_what_five_readings_cannot_tell_is_said():
    soft = mdr.Coated(POLYMER, 500e-9, SILICON, "exact")
    result = fit(*noisy(5, 0, 0.02, soft), mdr.Coated(SILICON, 500e-9, POLYMER, "exact"))
    words = f"5 readings cannot tell a misfit of {100.0 * result.hidden:.0f} % from noise"
    assert result.describes_data is None and result.verdict.startswith("cannot tell") and result.hidden > 0.2
    for text in (result.summary(), *result.warnings[-1:], result.report()):
        assert words in text
    assert result.verdict in mdi.rate(result).reasons


def test_one_reading_shows_no_model():
    result = fit([1e-7], [70e9], FILM, sd=1e9)
    assert result.verdict == "too few points" and result.describes_data is None and result.doubts("coating.E") == []
    assert result.warnings[-1] == "1 reading cannot show whether the model is right. Take more readings"


@pytest.mark.parametrize(("readings", "known"), [(8, False), (8, True), (200, False)])
def test_good_fits_of_few_readings_describe(readings, known):
    result = fit(*noisy(readings, 1, 0.005), FILM, relative_sd=0.005 if known else None)
    assert result.verdict == "describes" and result.describes_data is True and result.hidden == 0.0


def test_numbers_stand_as_people_write_them():
    """A fit to its own model said "misfit 3.4e-08 %" and "noise 6.41e-11 pm"."""
    depth = np.linspace(5e-9, 100e-9, 40)
    result = mdi.fit(mdi.ForceDepth(depth, mdr.Contact(BALL, FILM).at_depth(depth).force), BALL, FILM, ["coating.E"])
    text = result.summary()
    assert "misfit less than 0.01 % of the force" in text and "noise, estimated from the residuals: no more than rounding" in text
    wrong = mdi.fit(mdi.ForceDepth(depth, 1e-3 * (depth / 1e-7) ** 3), BALL, FILM, ["coating.E"]).summary()
    assert "e-" not in text + wrong and "e+" not in text + wrong
    assert "72 to 72 GPa" in text and "72 GPa, error less than 0.0001 %" in text


@pytest.mark.slow
@pytest.mark.skipif(not STUDY.exists(), reason="benchmarks are not in the source package")
@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("readings", [5, 20, 100])
def test_the_study_holds(monkeypatch, readings, known):
    """500 curves of a cell: 91.2 % are four standard errors below 95 %."""
    monkeypatch.syspath_prepend(STUDY)
    monkeypatch.delitem(sys.modules, "few_readings", raising=False)
    import few_readings

    share, length = few_readings.intervals(readings, 0.0, known, 500)
    assert 0.912 <= share <= (0.99 if readings < 20 and not known else 0.985)
    assert 0.85 < length < (2.5 if readings < 20 and not known else 1.45)
    assert few_readings.verdicts(100, "film and base swapped", 0.05, 50)["misses"] == 1.0
