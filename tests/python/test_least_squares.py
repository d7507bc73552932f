# SPDX-License-Identifier: GPL-3.0-or-later
"""Least squares of instruments: a straight line and a power, whose answers are known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.instruments.fitting.least_squares import Coordinate, ParameterFit, central_differences, names_of, solve

X = np.linspace(0.0, 2.0, 21)
DESIGN = np.column_stack([np.ones(21), X])
Y = 3.0 - 2.0 * X + 0.1 * np.random.default_rng(2).standard_normal(21)


@pytest.mark.parametrize("is_absolute", [True, False])
@pytest.mark.parametrize("unit", [1.0, 40.0])
def test_a_line_has_the_errors_of_the_normal_equations(is_absolute, unit):
    found = solve(lambda u: (Y - DESIGN @ u) / 0.1, np.zeros(2), is_absolute=is_absolute, unit=unit, method="lm")
    covariance = 0.01 * np.linalg.inv(DESIGN.T @ DESIGN)
    best = covariance @ DESIGN.T @ Y / 0.01
    rest = Y - DESIGN @ best
    if not is_absolute:
        covariance *= rest @ rest / 0.01 / 19
    fields = found.fields([Coordinate("height", False), Coordinate("slope", False, size=5.0, limits=(-9.9, -9.0))])
    assert fields["values"] == pytest.approx({"height": best[0], "slope": 5.0 * best[1]}, rel=1e-7)
    spread = np.sqrt(np.diag(covariance))
    assert fields["errors"] == pytest.approx({"height": spread[0], "slope": 5.0 * spread[1]}, rel=1e-6)
    assert fields["intervals"]["height"] == pytest.approx((best[0] - 1.96 * spread[0], best[0] + 1.96 * spread[0]), rel=1e-6)
    assert -9.9 <= fields["intervals"]["slope"][0] <= fields["intervals"]["slope"][1] <= -9.0
    assert fields["correlation"][0, 1] == pytest.approx(covariance[0, 1] / spread[0] / spread[1], rel=1e-6)
    assert fields["chi_square"] == pytest.approx(float(rest @ rest) / 0.01, rel=1e-9) and fields["points"] == 21


def test_what_the_data_do_not_determine_is_noted():
    def residuals(u):
        y = 3.0 + 1e-3 * X + 0.1 * (-1.0) ** np.arange(21)
        return y - np.exp(u[0]) - np.exp(u[1]) - 1e-3 * X * np.exp(u[2])

    notes = solve(residuals, np.zeros(3), method="lm").fields([Coordinate(name) for name in "abc"])["notes"]
    assert any(note.startswith("c does not follow") for note in notes)
    assert any(note.startswith("a and b follow") for note in notes)


@pytest.mark.parametrize("effect", [0.0, 1e-9])
def test_what_has_no_effect_is_not_known(effect):
    found = solve(lambda u: Y - np.exp(u[0]) - effect * np.cos(u[1]) * X, np.array([0.0, 1.0]), method="lm")
    fields = found.fields([Coordinate("height"), Coordinate("phase", False)])
    assert fields["errors"]["phase"] == np.inf and fields["intervals"]["phase"] == (-np.inf, np.inf)
    assert fields["errors"]["height"] == pytest.approx(np.std(Y) * np.sqrt(1.0 / 19.0), rel=1e-6)
    assert [note.split()[0] for note in fields["notes"]] == ["phase"] and (fields["correlation"] == np.eye(2)).all()
    plain = ParameterFit(**fields).to_dict()["parameters"]["phase"]
    assert plain["standard_error"] is None and plain["interval"] == [None, None]


def test_a_logarithm_has_a_positive_interval():
    one = Coordinate("modulus")
    assert one.interval(np.log(3.0), np.log(2.0)) == pytest.approx((1.5, 6.0))
    assert one.error(np.log(3.0), 0.1) == pytest.approx(0.3)


def test_differences_of_a_quadratic_are_exact():
    found = central_differences(lambda u: np.array([u[0] ** 2, u[0] * u[1]]), np.array([3.0, 5.0]), np.diag([0.5, 0.25]))
    assert found == pytest.approx(np.array([[3.0, 0.0], [2.5, 0.75]]), rel=1e-14)


@pytest.mark.parametrize("free", ["nu", [], ["nu", "nu"], ["mu"]])
def test_wrong_names_are_refused(free):
    with pytest.raises(mdr.errors.InvalidArgumentError, match="each once"):
        names_of(free, ("nu", "E"))


def test_a_search_that_does_not_end_is_refused():
    with pytest.raises(mdr.errors.NoConvergenceError, match="come to rest"):
        solve(lambda u: Y - DESIGN @ np.exp(u), np.zeros(2), max_nfev=1)
