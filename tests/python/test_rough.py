# SPDX-License-Identifier: GPL-3.0-or-later
"""Many contacts from one: what examples/python/rough_joint.py computes, against tests/data/rough.csv."""

import csv
import math
import runpy

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr

FILE = ROOT / "tests" / "data" / "rough.csv"
ROWS = list(csv.DictReader(line for line in FILE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")))
RATIO = {"homogeneous": 1.0, "film G0/G1=10": 10.0, "film G0/G1=0.1": 0.1, "film G0/G1=.1": 0.1}
PLACE = {"area ratio": 0, "u/sd": 1, "stiffness ratio": 2, "sum of radii ratio": 3}


@pytest.fixture(scope="module")
def rough():
    return runpy.run_path(str(ROOT / "examples" / "python" / "rough_joint.py"))


def rows(kind, quantity=""):
    return [row for row in ROWS if row["case"].startswith(kind) and quantity in row["quantity"]]


def ratio_of(case):
    return next(value for name, value in RATIO.items() if case.split(";")[1].strip().split(" ")[:2] == name.split(" ")[:2])


def test_lattice(rough):
    """theory/rough.md (3.1) to the digits of the table; against the solver in the plane the errors that the page states."""
    errors = {}
    for row in rows("lattice"):
        medium = rough["coated"](ratio_of(row["case"]), 0.5, 1.0)
        state = mdr.Contact(mdr.Paraboloid(1.0), medium).at_radius(0.5)
        found = state.depth + rough["lattice_constant"](medium, 1.0, float(row["at"])) * state.force
        if row["quantity"] == "d + c F":
            assert found == pytest.approx(float(row["value"]), rel=3.0 * float(row["accuracy"])), row
        else:
            errors[row["case"], row["at"]] = abs(found - float(row["value"])) / state.depth
    assert len(errors) == 4 and max(errors.values()) < 0.045
    assert errors["lattice; homogeneous", "4"] < 0.0022 and errors["lattice; film G0/G1=.1 h=.5", "4"] < 0.0004


@pytest.mark.slow
def test_greenwood_williamson(rough):
    """All rows to the accuracy that they state, 1e-3."""
    found, worst = {}, 0.0
    for row in rows("gw"):
        ratio, thickness, u = ratio_of(row["case"]), float(row["case"].split("h=")[1]), float(row["at"])
        if (ratio, thickness) not in found:
            found[ratio, thickness] = rough["factors"](ratio, thickness, (1.0, 2.0, 3.0))
        value = found[ratio, thickness][int(u) - 1][PLACE[row["quantity"]]]
        worst = max(worst, abs(value / float(row["value"]) - 1.0))
    assert len(found) == 6 and worst < 1e-3


@pytest.mark.parametrize("separation", [0.0, 1.0, 3.0])
def test_sums_over_asperities(rough, separation):
    """To 1e-6 and better: a homogeneous joint against the integrals of Hertz's formulas on another rule, and a film against
    twice the points over another range."""
    sd = rough["DEVIATION"]
    u = separation * sd
    t = (np.arange(200_000) + 0.5) / 200_000
    z = u + 12.0 * sd * t**2
    weights = 24.0 * sd * t * np.exp(-0.5 * (z / sd) ** 2) / (math.sqrt(2.0 * math.pi) * sd) / t.size
    d = z - u
    exact = [weights @ (4.0 / 3.0 * d**1.5), weights @ (math.pi * d), weights @ (2.0 * d**0.5), weights @ d**0.5]
    bare = rough["joint"](rough["law_of"](rough["coated"](1.0, 1.0, 1.0)), u)
    np.testing.assert_allclose(bare, exact, rtol=1e-8)
    film = rough["law_of"](rough["coated"](10.0, 0.03, 10.0))
    np.testing.assert_allclose(rough["joint"](film, u), rough["joint"](film, u, 400, 8.0), rtol=1e-6)


def by_radius(rough, medium, u, points=240, order=60):
    """Sums over asperities by exact states at Gauss points of the radius, dd = d'(a) da by Chebyshev polynomials: no law."""
    sd = rough["DEVIATION"]
    contact = mdr.Contact(mdr.Paraboloid(1.0), medium)
    largest = contact.at_depth(9.0 * sd - min(u, 0.0)).radius
    t, weights = np.polynomial.legendre.leggauss(points)
    a = 0.5 * largest * (t + 1.0)
    states = contact.at_radius(a)
    fit = np.polynomial.chebyshev.Chebyshev.fit(a, states.depth / a**2, order)
    rise = 2.0 * a * fit(a) + a**2 * fit.deriv()(a)
    weights = 0.5 * largest * weights * rise * np.exp(-0.5 * ((u + states.depth) / sd) ** 2) / (math.sqrt(2.0 * math.pi) * sd)
    return np.array([weights @ states.force, weights @ (math.pi * a**2), weights @ states.stiffness, weights @ a])


@pytest.mark.parametrize(("ratio", "h"), [(10.0, 0.3), (0.1, 3.0)])
def test_greenwood_williamson_two_ways(rough, ratio, h):
    """1e-8 against sums over radii of exact states, which know nothing of the law; the rows of the table, which claim 1e-3, are off
    from both by up to 5e-4."""
    sd = rough["DEVIATION"]
    film = rough["coated"](ratio, h * math.sqrt(sd), ratio)
    for u in (1.0, 3.0):
        ours, theirs = rough["joint"](rough["law_of"](film), u * sd), by_radius(rough, film, u * sd)
        np.testing.assert_allclose(ours, theirs, rtol=1e-8)


def test_persson(rough):
    """Mean gap and area to the accuracy of the rows, the variance of a half-space in closed form, and how far from the solver."""
    bodies = {
        "homogeneous": lambda k: 2.0 / k,
        "film G0/G1=10 nu=.3 h=.1": rough["coated"](10.0, 0.1, 1.0).compliance,
        "film G0/G1=.1 nu=.3 h=.1": rough["coated"](0.1, 0.1, 1.0).compliance,
        "layer on rigid base nu=.4 h=.2": mdr.Layered([(mdr.Elastic(1.0 - 0.16, 0.4), 0.2)], mdr.RIGID).compliance,
    }
    assert rough["persson"](bodies["homogeneous"], 0.1)[0] == pytest.approx(0.25, rel=1e-12)
    gaps = {}
    for row in rows("periodic", "persson"):
        pressure = float(row["at"])
        total, area, gap = rough["persson"](bodies[row["case"].split("; ")[1]], pressure)
        if row["quantity"] == "A persson":
            assert area == pytest.approx(float(row["value"]), rel=3e-4), row
        else:
            gaps[row["case"], row["at"]] = gap
            assert gap == pytest.approx(float(row["value"]), rel=3e-3), row
        assert total > 0.0
    off = [
        abs(gaps[row["case"], row["at"]] / float(row["value"]) - 1.0)
        for row in rows("periodic", "u bem")
        if (row["case"], row["at"]) in gaps and float(row["at"]) < 0.35
    ]
    assert len(off) >= 3 and max(off) < 0.12
