# SPDX-License-Identifier: GPL-3.0-or-later
"""Composite hardness: film and base come back from their own forms; finite elements show the error of each form."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import mdrcontact.instruments as mdi
from mdrcontact.errors import InvalidArgumentError

RATIO = np.array([0.29, 0.54, 0.79, 1.04, 1.29, 1.54, 1.79])
HARD_ON_SOFT = np.array([11.1, 10.2, 8.2, 7.1, 6.3, 5.8, 5.4])
"""Finite elements of a cone: film and base with 4:1 in modulus and yield stress, alone 11.2 and 2.8."""
FILM, BASE = 11.2, 2.8
SHARES = {
    "korsunsky": lambda x: 1.0 / (1.0 + 1.3 * x**2),
    "korsunsky-exponent": lambda x: 1.0 / (1.0 + 0.7 * x**1.4),
    "bhattacharya-nix": lambda x: np.exp(-1.1 * x**2),
    "exponential": lambda x: np.exp(-0.9 * x),
    "jonsson-hogmark": lambda x: np.where(x > 0.5, 1.0 / x - 0.25 / x**2, 1.0),
}
K = {"korsunsky": 1.3, "korsunsky-exponent": 0.7, "bhattacharya-nix": 1.1, "exponential": 0.9, "jonsson-hogmark": 0.5}


@pytest.mark.parametrize("name", SHARES)
@pytest.mark.parametrize("base", [None, 3e9])
def test_each_form_finds_what_made_the_readings(name, base):
    found = mdi.composite_hardness(RATIO, 3e9 + 8e9 * SHARES[name](RATIO), base=base)
    form = found.forms[name]
    assert (found.best, form.film, form.base) == (name, pytest.approx(11e9, rel=1e-7), pytest.approx(3e9, rel=1e-6))
    assert form.k == pytest.approx(K[name], rel=1e-6) and form.residual < 1e-9
    if name == "korsunsky-exponent":
        assert form.exponent == pytest.approx(1.4, rel=1e-6)
    x = np.array([0.1, 3.0])
    assert found.at(x, name) == pytest.approx(3e9 + 8e9 * SHARES[name](x), rel=1e-6)
    assert (form.base_error == 0.0) == (base is not None)


def test_errors_of_the_forms_on_finite_elements():
    """Least squares of the seven rows, weighted by the reading, computed once with SciPy's `least_squares` from five starts."""
    found = mdi.composite_hardness(RATIO, HARD_ON_SOFT)
    residuals = {
        "korsunsky": 1.88,
        "korsunsky-exponent": 1.29,
        "bhattacharya-nix": 1.73,
        "exponential": 2.60,
        "jonsson-hogmark": 1.19,
    }
    films = {"korsunsky": 8.9, "korsunsky-exponent": 2.6, "bhattacharya-nix": 5.4, "exponential": 27.1, "jonsson-hogmark": -0.3}
    bases = {"korsunsky": 37.4, "korsunsky-exponent": 71.6, "bhattacharya-nix": 90.4, "exponential": 38.3, "jonsson-hogmark": -18.4}
    for name, form in found.forms.items():
        assert 100.0 * form.residual == pytest.approx(residuals[name], abs=0.01)
        assert 100.0 * (form.film / FILM - 1.0) == pytest.approx(films[name], abs=0.1)
        assert 100.0 * (form.base / BASE - 1.0) == pytest.approx(bases[name], abs=0.1)
    assert found.shallow == pytest.approx(FILM, rel=0.01), "the shallow reading alone is the better film"
    assert any("the forms disagree about the film by 22 %" in words for words in found.warnings)
    assert found.film == (pytest.approx(11.16, abs=0.01), pytest.approx(14.23, abs=0.01))


def test_a_residual_is_no_measure_of_the_film():
    """Shallow readings left out: each form still follows the others to 2 %, and the films differ by a factor."""
    found = mdi.composite_hardness(RATIO[1:], HARD_ON_SOFT[1:])
    assert max(form.residual for form in found.forms.values()) < 0.02
    assert found.film.upper > 1.5 * FILM
    assert math.isnan(found.shallow) and any("extrapolated by a form" in words for words in found.warnings)


def test_standard_errors_are_those_of_simulated_readings():
    """Scatter of 200 fits of readings with 1 % of noise, given and not given."""
    random = np.random.default_rng(0)
    x = np.linspace(0.2, 2.0, 20)
    true = 3.0 + 8.0 / (1.0 + 1.3 * x**2)
    films, errors = [], []
    for _ in range(200):
        noisy = true * (1.0 + 0.01 * random.standard_normal(len(x)))
        form = mdi.composite_hardness(x, noisy).forms["korsunsky"]
        films.append(form.film)
        errors.append(form.film_error)
    assert np.mean(errors) == pytest.approx(np.std(films), rel=0.1)
    given = mdi.composite_hardness(x, true, sd=0.01 * true).forms["korsunsky"]
    assert given.film_error == pytest.approx(np.std(films), rel=0.1)
    assert mdi.composite_hardness(x, noisy, sd=1e-4 * true).forms["korsunsky"].film_error == pytest.approx(
        form.film_error, rel=0.05
    )


def test_units_order_and_json():
    mixed = np.random.default_rng(0).permutation(len(RATIO))
    one = mdi.composite_hardness(RATIO, HARD_ON_SOFT)
    two = mdi.composite_hardness(RATIO[mixed], 1e9 * HARD_ON_SOFT[mixed])
    for name in one.forms:
        assert two.forms[name].film == pytest.approx(1e9 * one.forms[name].film, rel=1e-6)
    found = json.loads(json.dumps(two.to_dict(), allow_nan=False))
    assert found["best"] == two.best and found["forms"]["korsunsky"]["film"] == two.forms["korsunsky"].film
    assert found["forms"]["jonsson-hogmark"]["exponent"] is None
    assert "film 12.19 ± 0.39 GPa" in two.summary() and "fits of data, no predictions" in two.summary()


@pytest.mark.parametrize(
    ("arguments", "options", "words"),
    [
        ((RATIO[:4], HARD_ON_SOFT[:4]), {}, "too few contact radii: 4; at least 5"),
        ((RATIO, HARD_ON_SOFT[:6]), {}, "the same length"),
        ((RATIO - 0.29, HARD_ON_SOFT), {}, "ratio = 0.0 in entry 0"),
        ((RATIO, HARD_ON_SOFT * np.nan), {}, "hardness = nan in entry 0"),
        ((RATIO, HARD_ON_SOFT), {"sd": 0.0}, "sd = 0.0 in entry 0"),
        ((RATIO, HARD_ON_SOFT), {"base": -1.0}, "base = -1.0: it must be greater than 0"),
        ((RATIO, HARD_ON_SOFT), {"base": math.inf}, "base = inf: it must be greater than 0"),
        (([1.0] * 9, [2.0] * 9), {}, "too few contact radii: 1"),
    ],
)
def test_refusals(arguments, options, words):
    with pytest.raises(InvalidArgumentError, match=words):
        mdi.composite_hardness(*arguments, **options)


def test_refusals_of_readings_between():
    found = mdi.composite_hardness(RATIO, HARD_ON_SOFT)
    with pytest.raises(InvalidArgumentError, match="form = 'korsunski': did you mean"):
        found.at(1.0, "korsunski")
    with pytest.raises(InvalidArgumentError, match="ratio = 0: it must be greater than 0"):
        found.at([1.0, 0.0])
    assert found.at(RATIO[3]).shape == () and found.at(RATIO[3]) == pytest.approx(HARD_ON_SOFT[3], rel=0.03)


def test_a_constant_hardness_has_no_base():
    """A film as hard as its base: both come out, or a form says that it cannot."""
    found = mdi.composite_hardness(RATIO, np.full(7, 5.0))
    for form in found.forms.values():
        assert form.film == pytest.approx(5.0, rel=1e-6)
