# SPDX-License-Identifier: GPL-3.0-or-later
"""Conduction through spots: reference values, limits, laws, refusals."""

import csv
import math
import pickle
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
import scipy.special
import scipy.stats
from conftest import ROOT

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import studies
from mdrcontact.cli import main
from mdrcontact.conduction import INSULATING, PERFECT, Conduction, Conductor, LayeredConductor
from mdrcontact.problem import load

REFERENCE = Path(__file__).parents[1] / "data" / "conduction.csv"
ROUGH_KEYS = '[conduction.joint]\nroughness = "1 um"\nslope = 0.1\nhardness = "1 GPa"\n'
BASES = {"perfect": PERFECT, "insulating": INSULATING}


def rows():
    with REFERENCE.open(encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def body_of(text):
    """A body of the reference file; None for "-"."""
    layers = []
    for word in text.split(";"):
        if word in BASES:
            return LayeredConductor(layers, BASES[word])
        if word == "-":
            return None
        if word.startswith("R="):
            layers.append(mdr.Interface(float(word[2:])))
            continue
        h, sigma, along, capacity = word.split(":")
        conductor = Conductor(float(sigma), float(along), float(capacity))
        if h == "inf":
            return LayeredConductor(layers, conductor)
        layers.append((conductor, float(h)))
    raise AssertionError(text)


def parameters_of(row):
    words = (word.split("=") for word in row["parameters"].split(";") if "=" in word)
    return {name: complex(value) if "j" in value else float(value) for name, value in words}


def value_of(row):
    """By the library."""
    given, a, what = parameters_of(row), float(row["a"]), row["quantity"]
    conduction = Conduction(body_of(row["body1"]), body_of(row["body2"]), given.get("Rc", 0.0), given.get("b"))
    if "Rm" in given:
        contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(0.5 * np.pi / a, 0.0)))
        return conduction.rough(contact.at_radius(a), given["Rm"])
    if what == "j" and "t" in given:
        return conduction.step_flux(given["r"], given["t"], a)
    if "s" in given or "t" in given:
        answer = {
            "G": "conductance",
            "R": "resistance",
            "Ru mean": "mean_potential",
            "Ru centre": "centre_potential",
            "Z gauss": "gaussian_potential",
        }[what]
        if "s" in given:
            return conduction.admittance(given["s"].imag, given.get("w", a), answer)
        return conduction.step(given["t"], a, answer)
    if what.startswith("Ru"):
        return conduction.admittance(0.0, a, {"Ru mean": "mean_potential", "Ru centre": "centre_potential"}[what]).real
    spot = conduction.at_radius(a)
    if what == "series G":
        parts = [Conduction(body_of(row[name])).at_radius(a).conductance for name in ("body1", "body2")]
        return 1.0 / sum(1.0 / part for part in parts)
    if what == "j":
        return spot.flux(given["r"])
    if what.startswith("phi"):
        return spot.potential(given["r"], given["z"], "upper" if what == "phi2" else "lower")
    if what in ("j_z", "j_r"):
        return spot.flux_inside(given["r"], given["z"])[what == "j_r"]
    return {"G": spot.conductance, "dG/da": spot.slope}[what]


def contact_of(given, a, paraboloid=1000.0):
    """The elastic contact of a row."""
    body = mdr.Elastic(given["E1"] if "E1" in given else given["E0"], given.get("n1", given["n0"]))
    film = mdr.Elastic(given["E0"], given["n0"])
    medium = mdr.Coated(film, given["h"], body, tolerance=1e-12) if "h" in given else mdr.Homogeneous(body)
    return mdr.Contact(mdr.Paraboloid(paraboloid), medium)


def heat_of(row):
    """Of the heat of friction."""
    given, a = parameters_of(row), float(row["a"])
    conduction = Conduction(body_of(row["body1"]), body_of(row["body2"]))
    if row["group"].startswith(("moving", "spin")):
        # the largest pressure of a paraboloid is 2 E* a/(pi R)
        contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(0.5 * np.pi / a, 0.0)))
    else:
        contact = contact_of(given, a)
    motion = row["group"].split()[0]
    kind = motion if motion in ("moving", "spinning") else "sliding"
    heat = conduction.friction_heat(contact.at_radius(a), 1.0, 1.0, kind, given.get("v"))
    what = row["quantity"].split()[-1]
    return {"T0": heat.centre, "Tq": heat.flux_mean, "Ta": heat.area_mean, "F": heat.total, "fraction": heat.share}[what]


def coupled(row):
    """A contact and its conductance."""
    state = COUPLED.at_radius(float(row["a"]))
    G = Conduction(body_of(row["body1"])).along(state).conductance
    return {"F": state.force, "k": state.stiffness, "d": state.depth, "G": G}[row["quantity"]]


COUPLED = contact_of({"E0": 50.0, "n0": 0.36, "h": 1.0, "E1": 117.0, "n1": 0.34}, 1.0)


def name_of(row):
    return " ".join(row[key] for key in ("group", "body1", "body2", "a", "parameters", "quantity"))


@pytest.mark.parametrize("row", rows(), ids=name_of)
def test_reference(row):
    expected = complex(float(row["value"]), float(row["imaginary"]))
    if row["group"].startswith(("friction", "moving", "spinning")):
        found = heat_of(row)
    else:
        found = coupled(row) if row["group"].startswith("coupling") else value_of(row)
    assert abs(found - expected) <= max(10.0 * float(row["accuracy"]), 1e-11) * abs(expected)


STACK = LayeredConductor(
    [(Conductor(1.0, 4.0), 0.5), mdr.Interface(0.7), (Conductor(3.0, 1.0), 0.4), mdr.Interface(0.3)],
    Conductor(1.0, 2.0),
)
PAIR = Conduction(STACK, LayeredConductor([(Conductor(0.2), 0.3)], Conductor(3.0)))
CASES = {
    "half-space": Conduction(Conductor(2.0, 8.0)),
    "stack": Conduction(STACK),
    "perfect base": Conduction(LayeredConductor([(Conductor(1.0), 1.0), mdr.Interface(0.2)], PERFECT)),
    "insulating base": Conduction(LayeredConductor([(Conductor(1.0), 1.0)], INSULATING), sink=100.0),
    "pair": PAIR,
    "film: ": PAIR.replace(film=0.2),
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("a", [0.1, 1.0, 7.0])
def test_slope_is_that_of_the_conductance(name, a):
    """By differences of sixth order in a."""
    h = 2e-2 * a
    conductance = [CASES[name].at_radius(a + i * h).conductance for i in (-3, -2, -1, 1, 2, 3)]
    slope = np.dot([-1.0, 9.0, -45.0, 45.0, -9.0, 1.0], conductance) / (60.0 * h)
    assert CASES[name].at_radius(a).slope == pytest.approx(slope, rel=1e-7)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("a", [0.3, 2.0])
def test_flux_adds_up_to_the_conductance(name, a):
    """int j 2 pi r dr with r = a sin theta, where j cos theta is smooth."""
    spot = CASES[name].at_radius(a)
    x, w = np.polynomial.legendre.leggauss(80)
    theta, w = 0.25 * np.pi * (x + 1.0), 0.25 * np.pi * w
    total = np.sum(w * 2.0 * np.pi * a**2 * np.sin(theta) * np.cos(theta) * spot.flux(a * np.sin(theta)))
    # a film's flux bends logarithmically at the edge
    assert total == pytest.approx(spot.conductance, rel=1e-6 if spot.conduction.film else 1e-10)


@pytest.mark.slow
def test_flux_inside_adds_up_to_the_conductance():
    """Through the interface of the stack, whose far part falls as r^-3."""
    spot = CASES["stack"].at_radius(1.0)
    x, w = np.polynomial.legendre.leggauss(24)
    edges = np.concatenate([[0.0], 0.5 * 2.0 ** np.arange(11)])
    r = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (x + 1.0)).ravel()
    weights = (0.5 * np.diff(edges)[:, None] * w).ravel()
    parts = (weights * 2.0 * np.pi * r * spot.flux_inside(r, 0.9)[0]).reshape(len(edges) - 1, -1).sum(axis=1)
    # what lies beyond R goes as 1/R: twice the whole less what lies within R/2
    assert 2.0 * parts.sum() - parts[:-1].sum() == pytest.approx(spot.conductance, rel=1e-5)


def test_potentials_jump_by_the_resistance_of_an_interface():
    spot, r = CASES["stack"].at_radius(1.0), np.array([0.0, 0.3, 1.0, 2.5])
    for z, resistance in ((0.5, 0.7), (0.9, 0.3)):
        above, below = (spot.potential(r, z, side=side) for side in ("above", "below"))
        flux = [spot.flux_inside(r, z, side=side)[0] for side in ("above", "below")]
        assert flux[0] == pytest.approx(flux[1], rel=1e-10)
        assert above - below == pytest.approx(resistance * flux[0], rel=1e-10)


def test_potentials_are_continuous_within_and_across_layers():
    film = LayeredConductor([(Conductor(2.0), 1.0)], Conductor(0.5))
    spot, r = Conduction(film).at_radius(1.5), np.array([0.0, 0.7, 1.4, 3.0])
    assert spot.potential(r, 1.0, side="above") == pytest.approx(spot.potential(r, 1.0, side="below"), rel=1e-11)
    # Laplace's equation and Ohm's law by differences
    h = 1e-3
    for z in (0.3, 0.8, 1.6):
        slope = (spot.potential(r, z + h) - spot.potential(r, z - h)) / (2.0 * h)
        assert spot.flux_inside(r, z)[0] == pytest.approx(-(2.0 if z < 1.0 else 0.5) * slope, rel=1e-4)


def test_fields_on_a_grid_are_bitwise_those_of_single_points():
    """A grid takes its Bessel functions and exponentials once for each radius and depth, and waves by blocks."""
    stack = LayeredConductor([(Conductor(2.0), 0.02), mdr.Interface(0.7), (Conductor(1.0, 3.0), 0.9)], PERFECT)
    spot = Conduction(stack).at_radius(1.0)
    r, z = np.linspace(0.0, 2.5, 40), np.append(np.linspace(0.0, 0.92, 39), 0.02)
    # waves follow the largest radius of a call
    for side in ("above", "below"):
        grid = np.array([spot.potential(r[None, :], z[:, None], side=side), *spot.flux_inside(r[None, :], z[:, None], side=side)])
        for i, j in ((0, 0), (1, 7), (39, 20), (38, 0), (38, 31), (20, 39)):
            at, depth = np.array([r[j], r[-1]]), np.array([z[i], 0.0])
            single = np.array([spot.potential(at, depth, side=side), *spot.flux_inside(at, depth, side=side)])
            assert (grid[:, i, j] == single[:, 0]).all()


def test_both_bodies_share_the_potential():
    spot, r = PAIR.at_radius(1.0), np.array([0.0, 0.3, 0.6, 0.95])
    total = spot.potential(r, 0.0) + spot.potential(r, 0.0, body="upper")
    assert total == pytest.approx(np.ones(4), rel=1e-10)
    # surfaces of body and far field
    assert spot.potential(2.0, 0.0) > 0.0 and spot.potential(1e3, 0.0) < 1e-2


def test_equal_layers_are_one():
    whole = LayeredConductor([(Conductor(2.0, 3.0, 0.7), 1.0)], Conductor(1.0, 1.0, 2.0))
    parts = LayeredConductor([(Conductor(2.0, 3.0, 0.7), h) for h in (0.3, 0.5, 0.2)], Conductor(1.0, 1.0, 2.0))
    one, three = Conduction(whole), Conduction(parts)
    for a in (0.1, 1.0, 10.0):
        assert three.at_radius(a).conductance == pytest.approx(one.at_radius(a).conductance, rel=1e-11)
    assert three.step(0.1, 1.0) == pytest.approx(one.step(0.1, 1.0), rel=1e-11)
    same = Conduction(LayeredConductor([(Conductor(2.0), 1.0)], Conductor(2.0)))
    assert same.at_radius(3.0).conductance == pytest.approx(24.0, rel=1e-13)


def test_limits_of_resistances():
    layers, base = (Conductor(2.0), 1.0), Conductor(1.0)
    bonded = Conduction(LayeredConductor([layers], base)).at_radius(1.0).conductance
    film = [Conduction(LayeredConductor([layers, mdr.Interface(r)], base)) for r in (1e-10, 0.5, 5.0)]
    conductance = [c.at_radius(1.0).conductance for c in film]
    assert conductance[0] == pytest.approx(bonded, rel=1e-9)
    assert conductance[0] > conductance[1] > conductance[2]
    # a film in the spot: nothing, and everything; below 1e-2 a/S its edge is too thin
    plain = Conduction(Conductor(1.0))
    assert plain.replace(film=3e-3).at_radius(1.0).conductance == pytest.approx(4.0, rel=2e-2)
    much = plain.replace(film=1e6).at_radius(1.0).conductance
    mean = plain.admittance(0.0, 1.0, "mean_potential").real
    assert 1.0 / much - 1e6 / np.pi == pytest.approx(mean, rel=1e-4)


@pytest.mark.parametrize("name", ["half-space", "stack"])
def test_thin_films_lead_to_the_bare_spot(name):
    """G over delta = S R_c/a goes as 1 + delta (A ln delta + B) + delta^2 (C ln^2 delta + D ln delta + E): its limit, to 1e-4."""
    spot, a = CASES[name], 1.0
    bare = spot.at_radius(a).conductance
    scale = {"half-space": 4.0, "stack": 2.0}[name]
    delta = np.geomspace(6e-3, 6e-2, 8)
    found = [spot.replace(film=d * a / scale).at_radius(a).conductance for d in delta]
    log = np.log(delta)
    terms = np.stack([np.ones(8), delta * log, delta, (delta * log) ** 2, delta**2 * log, delta**2], axis=1)
    assert np.linalg.lstsq(terms, found, rcond=None)[0][0] == pytest.approx(bare, rel=1e-4)
    assert np.all(np.diff(found) < 0.0) and found[0] < bare


def test_pair_of_equals_is_half():
    one = Conduction(STACK).at_radius([0.2, 1.0, 5.0])
    two = Conduction(STACK, STACK).at_radius([0.2, 1.0, 5.0])
    assert 2.0 * two.conductance == pytest.approx(one.conductance, rel=1e-11)


def test_conductance_grows_with_every_layer():
    sigma = np.array([2.0, 0.3, 1.0])
    base = conductance_of(sigma)
    for i in range(3):
        more = sigma.copy()
        more[i] *= 1.1
        assert np.all(conductance_of(more) > base)


def conductance_of(sigma):
    layers = [(Conductor(s), h) for s, h in zip(sigma, (0.4, 0.7), strict=False)]
    return np.asarray(Conduction(LayeredConductor(layers, Conductor(sigma[2]))).at_radius([0.1, 1.0, 10.0]).conductance)


def test_asymptotes():
    """Dryden's thick film, a thin one on a perfect base, an insulated one: theory/conduction.md (2.5), (2.6), (6.3)."""
    film = Conduction(LayeredConductor([(Conductor(5.0), 1.0)], Conductor(1.0)))
    a = 0.02
    expected = 1.0 / (4.0 * 5.0 * a) + np.log(3.0) / (2.0 * np.pi * 5.0)
    assert 1.0 / film.at_radius(a).conductance == pytest.approx(expected, rel=1e-5)
    sheet = Conduction(LayeredConductor([(Conductor(5.0), 1.0)], PERFECT)).at_radius(200.0).conductance
    assert sheet == pytest.approx(5.0 * np.pi * 200.0**2 * (1.0 + 4.0 * np.log(2.0) / np.pi / 200.0), rel=1e-4)
    insulated = LayeredConductor([(Conductor(1.0), 1.0)], INSULATING)
    a = 0.02
    resistance = 1.0 / (4.0 * a) + (np.log(100.0 / 4.0) + np.euler_gamma) / (2.0 * np.pi)
    assert 1.0 / Conduction(insulated, sink=100.0).at_radius(a).conductance == pytest.approx(resistance, rel=1e-4)


def test_short_and_long_times():
    """theory/conduction.md (9.7), (9.8)."""
    body = LayeredConductor([(Conductor(2.0, None, 1.0), 1.0), mdr.Interface(0.2)], Conductor(1.0, None, 3.0))
    spot = Conduction(body)
    t = 1e-4
    assert spot.step(t, 1.0) == pytest.approx(np.pi * np.sqrt(2.0 / (np.pi * t)) + 2.0 * np.pi, rel=1e-3)
    steady, late = spot.at_radius(1.0).conductance, 1e4
    assert spot.step(late, 1.0) == pytest.approx(steady + steady**2 / (2.0 * np.pi) * np.sqrt(3.0 / (np.pi * late)), rel=1e-3)
    assert spot.step(late, 1.0, "resistance") == pytest.approx(
        1.0 / steady - np.sqrt(3.0 / (np.pi * late)) / (2.0 * np.pi), rel=1e-3
    )
    assert spot.admittance(1e-9, 1.0).real == pytest.approx(steady, rel=1e-4)
    assert spot.impedance(3.0, 1.0) == pytest.approx(1.0 / spot.admittance(3.0, 1.0), rel=1e-12)


def test_times_share_parabolas():
    """The same whether they come one by one or together."""
    spot, t = Conduction(STACK.replace(substrate=Conductor(1.0, 2.0, 1.0))), np.geomspace(1e-2, 1e2, 9)
    together = spot.step(t, 1.0)
    assert together == pytest.approx([spot.step(float(x), 1.0) for x in t], rel=1e-11)
    assert np.all(np.diff(together) < 0.0)


@pytest.mark.slow
def test_any_history():
    """Ramps superposed: evenly spaced times as others; two ramps make a step; oscillations end in the admittance."""
    body = LayeredConductor([(Conductor(2.0, None, 1.0), 1.0), mdr.Interface(0.2)], Conductor(1.0, None, 3.0))
    for spot, answer in (
        (Conduction(body), "conductance"),
        (Conduction(body, film=0.3), "resistance"),
        (Conduction(body), "centre_potential"),
    ):
        late, width = 0.7, 1e-3
        steep = spot.follow([0.0, width, late + 0.5 * width], [0.0, 1.0, 1.0], 1.0, answer)
        assert steep[0] == 0.0 and steep[2] == pytest.approx(spot.step(late, 1.0, answer), rel=1e-6)
    spot, omega = Conduction(body), 3.0
    t = np.linspace(0.0, 24.0, 1921)
    found = spot.follow(t, np.sin(omega * t), 1.0)
    y = complex(spot.admittance(omega, 1.0))
    last = t > 18.0
    expected = y.real * np.sin(omega * t) + y.imag * np.cos(omega * t)
    # chords of a sine, and what is left of the beginning
    assert found[last] == pytest.approx(expected[last], abs=2e-3 * abs(y))
    uneven = np.delete(t[:25], [3, 7, 8, 15])
    values = np.interp(t[:25], uneven, np.sin(uneven))
    assert spot.follow(uneven, np.sin(uneven), 1.0)[-1] == pytest.approx(spot.follow(t[:25], values, 1.0)[-1], rel=1e-10)
    for wrong, words in (([0.0, 1.0, 1.0], "ascend"), ([0.0, 1e-7, 1.0], "time"), ([0.0, 1.0], "same length")):
        with pytest.raises(mdr.MDRError, match=words):
            spot.follow(wrong, [0.0, 1.0, 1.0], 1.0)
    with pytest.raises(mdr.MDRError, match="begin with 0"):
        spot.follow([0.0, 1.0], [1.0, 1.0], 1.0)


@pytest.mark.parametrize("gamma", [0.0, 0.3])
def test_conductance_along_a_load(gamma):
    """dG/dF and dG/dd by differences along the curve."""
    contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Coated(mdr.Elastic(5.0, 0.3), 1.0, mdr.Elastic(50.0, 0.3)), gamma)
    spot = Conduction(LayeredConductor([(Conductor(3.0), 1.0)], Conductor(1.0)))
    a, h = 1.5, 1e-3
    found = spot.along(contact.at_radius(a))
    states = contact.at_radius([a - 2 * h, a - h, a + h, a + 2 * h])
    near = spot.along(states).conductance
    rate = lambda y: (8.0 * (y[2] - y[1]) - (y[3] - y[0])) / (12.0 * h)  # noqa: E731
    assert found.by_force == pytest.approx(rate(near) / rate(np.asarray(states.force)), rel=1e-7)
    assert found.by_depth == pytest.approx(rate(near) / rate(np.asarray(states.depth)), rel=1e-7)
    punch = mdr.Contact(mdr.FlatPunch(a), contact.medium)
    assert spot.along(punch.at_depth(0.1))[1:] == (0.0, 0.0)


def test_homogeneous_bodies_obey_barber():
    """theory/conduction.md (8.2)."""
    for profile in (mdr.Cone(0.2), mdr.Paraboloid(3.0), mdr.FlatPunch(0.4)):
        material = mdr.Elastic(3.0, 0.25, Conductor(2.0))
        body = mdr.Homogeneous(material)
        contact = mdr.Contact(profile, body)
        state = contact.at_depth(0.1)
        found = Conduction(body).along(state)
        assert found.conductance == pytest.approx(4.0 * state.stiffness / material.contact_modulus, rel=1e-10)


def test_heat_of_homogeneous_bodies():
    """Closed forms, theory/conduction.md (10.1): of a paraboloid; of a cone T(0) = int p dr/S; shares of half-spaces."""
    body = mdr.Homogeneous(mdr.Elastic(2.0, 0.3))
    contact = mdr.Contact(mdr.Paraboloid(5.0), body)
    state = contact.at_radius(0.4)
    heat = Conduction(Conductor(3.0)).friction_heat(state, 0.2, 7.0)
    assert heat.total == pytest.approx(1.4 * state.force, rel=1e-10)
    assert heat.centre == pytest.approx(3.0 * heat.total / (8.0 * 3.0 * 0.4), rel=1e-10)
    assert heat.flux_mean == pytest.approx(0.8 * heat.centre, rel=1e-10)
    assert heat.area_mean == pytest.approx(0.75 * heat.centre, rel=1e-10)
    assert heat.temperature(0.0, 0.0) == pytest.approx(heat.centre, rel=1e-9)
    both = Conduction(Conductor(3.0), Conductor(1.0)).friction_heat(state, 0.2, 7.0)
    assert both.share == pytest.approx(0.75, rel=1e-12) and both.centre == pytest.approx(0.75 * heat.centre, rel=1e-12)
    cone = mdr.Contact(mdr.Cone(0.1), body)
    state = cone.at_radius(0.4)
    heat = Conduction(Conductor(3.0)).friction_heat(state, 1.0, 1.0)
    assert heat.total == pytest.approx(state.force, rel=1e-9)
    # p = (E* tan(phi)/2) acosh(a/r), int_0^a p dr = (E* tan(phi)/2) a pi/2
    expected = 0.25 * np.pi * 0.4 * np.tan(0.1) * 2.0 / (1.0 - 0.09) / 3.0
    assert heat.centre == pytest.approx(expected, rel=1e-9)
    still = Conduction(Conductor(3.0)).friction_heat(state, 0.0, 1.0)
    assert still.total == 0.0 and still.centre == 0.0


def test_temperatures_near_kinks():
    """Within 2e-3 of the largest: of a cone T(r) = c (pi a/2 - r)/S, kinked on the axis; of a flat end by quadrature."""
    body, S = mdr.Homogeneous(mdr.Elastic(2.0, 0.3)), 3.0
    conduction = Conduction(Conductor(S))
    cone = mdr.Contact(mdr.Cone(0.1), body)
    heat = conduction.friction_heat(cone.at_radius(0.4), 1.0, 1.0)
    r = np.concatenate([[0.0], np.geomspace(1e-6, 0.399, 25)])
    expected = heat.centre * (1.0 - r / (0.2 * np.pi))
    assert heat.temperature(r, 0.0) == pytest.approx(expected, abs=2e-3 * heat.centre)
    assert heat.centre == pytest.approx(expected[0], rel=1e-12)
    assert heat.temperature(0.3, 0.0) == pytest.approx(heat.centre * (1.0 - 1.5 / np.pi), abs=1e-5 * heat.centre)
    b = 0.25
    blunt = mdr.Contact(mdr.FlatEndedCone(b, 0.1), body)
    state = blunt.at_radius(0.4)
    heat = conduction.friction_heat(state, 1.0, 1.0)
    u, w = np.polynomial.legendre.leggauss(60)
    for x in (0.1, 0.24, 0.249, 0.25, 0.251, 0.26, 0.35):
        # x sin t, with the square root that starts at the kink from either side
        ends = sorted({0.0, np.arcsin(min(b / x, 1.0)), 0.5 * np.pi})
        total = 0.0
        for low, high in zip(ends, ends[1:], strict=False):
            t = low + (high - low) * (0.5 * (1.0 + u)) ** 2
            total += np.sum(w * 0.5 * (1.0 + u) * (high - low) * state.line_load(np.minimum(x * np.sin(t), 0.4)))
        assert heat.temperature(x, 0.0) == pytest.approx(total / (np.pi * S), abs=2e-3 * heat.centre)


def test_heat_leaves_both_bodies_at_one_temperature():
    body = mdr.Homogeneous(mdr.Elastic(210.0, 0.3))
    contact = mdr.Contact(mdr.Paraboloid(1000.0), body)
    heat = PAIR.friction_heat(contact.at_radius(1.0), 1.0, 1.0)
    r = np.array([0.0, 0.3, 0.6, 0.9])
    assert heat.temperature(r, 0.0) == pytest.approx(heat.temperature(r, 0.0, body="upper"), rel=1e-7)
    assert heat.temperature(0.0, 0.0) == pytest.approx(heat.centre, rel=1e-9)


def test_a_slow_source_rests():
    body = LayeredConductor([(Conductor(2.0, None, 1.0), 1.0)], Conductor(1.0, None, 3.0))
    contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Homogeneous(mdr.Elastic(2.0, 0.3)))
    state, conduction = contact.at_radius(1.0), Conduction(body)
    rest = conduction.friction_heat(state, 1.0, 1.0)
    slow = conduction.friction_heat(state, 1.0, 1.0, "moving", 1e-7)
    fast = conduction.friction_heat(state, 1.0, 1.0, "moving", 30.0)
    assert slow.largest == pytest.approx(rest.centre, rel=1e-6) and slow.behind < 1e-3
    assert slow.centre == pytest.approx(rest.centre, rel=1e-6) and slow.flux_mean == pytest.approx(rest.flux_mean, rel=1e-6)
    assert fast.flux_mean < 0.6 * rest.flux_mean
    with pytest.raises(mdr.MDRError, match="axisymmetric"):
        slow.temperature(0.0, 0.0)


def of_jaeger(x, y, v):
    """T under q = sqrt(1 - r^2), a = 1, lambda = c = 1, moving at v: point sources exp(-v (R + X)/2)/(2 pi R), in polar
    coordinates around the point, along whose rays R cancels."""
    u, w = np.polynomial.legendre.leggauss(200)
    phi = np.pi * np.linspace(0.0, 2.0, 400, endpoint=False)
    # from the edge of the disc behind the point to that before it, or from the point
    b = x * np.cos(phi) + y * np.sin(phi)
    reach = -b + np.sqrt(b**2 + 1.0 - x**2 - y**2)
    rho = 0.5 * reach[:, None] * (1.0 + np.sin(0.5 * np.pi * u))
    weight = 0.25 * np.pi * reach[:, None] * np.cos(0.5 * np.pi * u) * w
    q = np.sqrt(np.maximum(1.0 - (x + rho * np.cos(phi[:, None])) ** 2 - (y + rho * np.sin(phi[:, None])) ** 2, 0.0))
    # the source at x + rho cos phi lies ahead of the point that it heats where cos phi < 0
    fall = np.exp(-0.5 * v * rho * (1.0 + np.cos(phi[:, None])))
    return np.sum(weight * q * fall) * 2.0 * np.pi / len(phi) / (2.0 * np.pi)


@pytest.mark.parametrize("v", [0.3, 5.0, 60.0, 150.0])
def test_largest_temperature_of_a_moving_source(v):
    """Beside Jaeger's source, whose temperatures along the line are integrated at places around the one found."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(0.5 * np.pi, 0.0)))
    heat = Conduction(Conductor(1.0, None, 1.0)).friction_heat(contact.at_radius(1.0), 1.0, 1.0, "moving", v)
    assert heat.centre == pytest.approx(of_jaeger(0.0, 0.0, v), rel=1e-5)
    assert heat.largest == pytest.approx(of_jaeger(heat.behind, 0.0, v), rel=1e-5)
    for step in (-0.05, 0.05):
        assert of_jaeger(heat.behind + step, 0.0, v) < heat.largest
    if v > 50.0:
        assert heat.largest == pytest.approx(1.2346 / np.sqrt(v), rel=0.05)


def test_share_of_a_moving_source():
    """Equal means over the heat: the faster, the more goes into the body that moves; slow, what two bodies at rest share."""
    contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Homogeneous(mdr.Elastic(2.0, 0.3)))
    state, body = contact.at_radius(1.0), Conductor(2.0, None, 1.0)
    both = Conduction(body, Conductor(1.0))
    slow, fast = (both.friction_heat(state, 1.0, 1.0, "moving", v) for v in (1e-7, 20.0))
    assert slow.share == pytest.approx(2.0 / 3.0, rel=1e-6) and fast.share > 0.8
    moved = Conduction(body).friction_heat(state, 1.0, 1.0, "moving", 20.0)
    rest = Conduction(Conductor(1.0)).friction_heat(state, 1.0, 1.0)
    assert fast.flux_mean == pytest.approx(fast.share * moved.flux_mean, rel=1e-12)
    assert fast.flux_mean == pytest.approx((1.0 - fast.share) * rest.flux_mean, rel=1e-9)
    assert fast.largest == pytest.approx(fast.share * moved.largest, rel=1e-12) and fast.behind == moved.behind


def test_heat_of_many_states():
    """As one by one; and the series of the medium gives what sampling gives."""
    coated = mdr.Coated(mdr.Elastic(10.0, 0.3, Conductor(0.1)), 1.0, mdr.Elastic(1.0, 0.3, Conductor(1.0)))
    contact, conduction = mdr.Contact(mdr.Paraboloid(1e3), coated), Conduction(coated)
    states = contact.at_radius([[0.1, 1.0, 3.0], [10.0, 30.0, 100.0]])
    heat = conduction.friction_heat(states, 0.2, 3.0)
    assert heat.centre.shape == (2, 3) and heat.largest is None
    assert heat.total == pytest.approx(0.6 * np.asarray(states.force), rel=1e-10)
    for i in range(6):
        one = conduction.friction_heat(contact.at_radius(float(np.ravel(states.radius)[i])), 0.2, 3.0)
        assert one.centre == heat.centre.flat[i] and one.flux_mean == heat.flux_mean.flat[i]
        assert one.temperature(0.0, 0.0) == pytest.approx(one.centre, rel=1e-8)
    with pytest.raises(mdr.MDRError, match="one state"):
        heat.temperature(0.0, 0.0)


def test_mechanical_bodies_conduct():
    film, base = mdr.Elastic(72.0, 0.17, Conductor(1.4)), mdr.Elastic(165.0, 0.22, Conductor(148.0))
    expected = Conduction(LayeredConductor([(Conductor(1.4), 0.5)], Conductor(148.0)))
    coated, layered = mdr.Coated(film, 0.5, base), mdr.Layered([(film, 0.2), (film, 0.3)], base)
    for body in (coated, layered):
        assert Conduction(body).at_radius(1.0).conductance == pytest.approx(expected.at_radius(1.0).conductance, rel=1e-11)
    pair = Conduction(mdr.Pair(coated, mdr.Homogeneous(base)))
    assert pair.at_radius(1.0).conductance == Conduction(coated, mdr.Homogeneous(base)).at_radius(1.0).conductance


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Conductor(-1.0), "sigma = -1"),
        (lambda: Conductor(1.0, 0.0), "along = 0"),
        (lambda: Conductor(1.0, 1.0, -2.0), "capacity = -2"),
        (lambda: mdr.Interface(-1e-9), "resistance = -1e-09"),
        (lambda: LayeredConductor([(Conductor(1.0), -1.0)], PERFECT), "thickness = -1"),
        (lambda: LayeredConductor([mdr.Interface(1.0)], Conductor(1.0)), "follow a layer"),
        (lambda: LayeredConductor([], PERFECT), "no layer"),
        (lambda: LayeredConductor([], mdr.RIGID), "PERFECT or INSULATING"),
        (lambda: Conduction(Conductor(1.0), film=-1.0), "film = -1"),
        (lambda: Conduction(mdr.Homogeneous(mdr.Elastic(1.0, 0.3))), "no conductivity"),
        (lambda: Conduction(LayeredConductor([(Conductor(1.0), 1.0)], INSULATING)).at_radius(1.0), "sink"),
        (lambda: Conduction(Conductor(1.0), sink=30.0), "sink = 30: only a body on an insulating base"),
        (lambda: Conduction(LayeredConductor([(Conductor(1.0), 1.0)], PERFECT), sink=30.0), "sink = 30"),
        (lambda: Conduction(Conductor(1.0)).friction_heat(None, 0.1, 1.0, source_speed=2.0), "source_speed = 2.0: .* at rest"),
        (lambda: Conduction(Conductor(1.0)).at_radius(-1.0), "radius = -1"),
        (lambda: Conduction(Conductor(1.0, None, 1.0)).step(1e-6, 1.0), "time = 1e-06:"),
        (lambda: Conduction(Conductor(1.0, None, 1.0)).admittance(1e6, 1.0), r"omega = 1e\+06"),
        (lambda: Conduction(Conductor(1.0), film=1e-7).at_radius(1.0), "too thin"),
        (lambda: CASES["stack"].at_radius(1.0).flux(1.0), "r = 1"),
        (lambda: CASES["stack"].at_radius(1.0).potential(0.0, 0.0, body="upper"), "body = 402"),
        (lambda: CASES["perfect base"].at_radius(1.0).potential(0.0, 2.0), "the layers end"),
        (lambda: CASES["insulating base"].at_radius(1.0).potential(0.0, 0.0), "insulating"),
        (lambda: mdr.Elastic(1.0, 0.3, 4.0), "conductor = 4.0"),
    ],
)
def test_refusals(call, words):
    with pytest.raises((mdr.MDRError, TypeError), match=words):
        call()


def test_high_contrast():
    """20 digits of tests/data/conduction_contrast.py."""
    with REFERENCE.with_name("conduction_contrast.csv").open(encoding="utf-8") as lines:
        for row in csv.DictReader(lines):
            film = LayeredConductor([(Conductor(1.0), 1.0)], Conductor(1.0 / float(row["contrast"])))
            assert Conduction(film).at_radius(float(row["a"])).conductance == pytest.approx(float(row["G"]), rel=1e-11)


@pytest.mark.parametrize(
    "name", ["tin_on_copper", "heat_through_silica", pytest.param("dlc_flash_temperature", marks=pytest.mark.slow)]
)
def test_command_line(name, tmp_path, capsys):
    problem, table, picture = ROOT / "examples" / "problems" / f"{name}.toml", tmp_path / "table.csv", tmp_path / "picture.png"
    assert main(["conduction", str(problem), "--csv", str(table), "--plot", str(picture)]) == 0
    assert "conductance at a = " in capsys.readouterr().out
    lines = table.read_text(encoding="utf-8").splitlines()
    loaded = load(problem)
    columns = dict(zip(lines[0].split(","), lines[-1].split(","), strict=True))
    a = float(columns["radius [um]" if "radius [um]" in columns else "radius [nm]"]) * (1e-6 if "radius [um]" in columns else 1e-9)
    unit, value = next((key, float(cell)) for key, cell in columns.items() if key.startswith("conductance"))
    factor = {"conductance [S]": 1.0, "conductance [nW/K]": 1e-9, "conductance [mW/K]": 1e-3}[unit]
    expected = loaded.conduction.conduction(loaded.medium).at_radius(a).conductance
    assert value * factor == pytest.approx(expected, rel=1e-4)
    assert picture.stat().st_size > 10_000


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('kind = "electrical"', 'kind = "wet"', "wet"),
        ('kind = "electrical"', f'kind = "electrical"\nfilm = "1 ohm*m^2"\n{ROUGH_KEYS}', "film and joint exclude each other"),
        ('kind = "electrical"', f'kind = "electrical"\n{ROUGH_KEYS}gas = "1 W/(m*K)"', "gas = '1 W/.*gases conduct heat alone"),
        ('kind = "electrical"', f'kind = "electrical"\n{ROUGH_KEYS}jump = "1 um"', "jump = '1 um': .* Give gas, or omit jump"),
        ('kind = "electrical"', f'kind = "electrical"\n{ROUGH_KEYS.replace("0.1", "0")}', "slope = 0: it must be greater than 0"),
        (
            'kind = "electrical"',
            f'kind = "electrical"\n{ROUGH_KEYS.replace("1 GPa", "1 MPa")}',
            "hardness = .* must exceed twice the pressure",
        ),
        ('kind = "electrical"', 'kind = "electrical"\njoint = {roughness = "1 um", slope = 0.1}', "the key 'hardness' is missing"),
        ('kind = "electrical"', 'kind = "electrical"\nspeed = "1 m/s"', "speed and friction_coefficient do not belong"),
        ('electrical_conductivity = "9.17 MS/m"', 'electrical_conductivity = "9.17 W/(m*K)"', "an electrical conductivity"),
        ('electrical_conductivity = "9.17 MS/m"\n', "", "no conductivity"),
        ('electrical_conductivity = "9.17 MS/m"', 'heat_capacity = "3 MJ/(m^3*K)"', "heat_capacity needs thermal"),
        (
            'electrical_conductivity = "9.17 MS/m"',
            'electrical_conductivity_along = "9 MS/m"',
            "electrical_conductivity_along needs electrical_conductivity",
        ),
        (
            'electrical_conductivity = "9.17 MS/m"',
            'electrical_conductivity = "9.17 MS/m"\nthermal_conductivity_along = "9 W/(m*K)"',
            "thermal_conductivity_along needs thermal_conductivity",
        ),
        ('kind = "electrical"', 'kind = "electrical"\ninterfaces = ["0 ohm*m^2", "1 ohm*m^2"]', "interfaces has 2"),
        ('[conduction]\nkind = "electrical"\n', "", r"\[conduction\] is missing"),
        ('kind = "electrical"', 'kind = "electrical"\nthermal_film = "1e-9 m^2*K/W"', "thermal_film does not belong to kind"),
        ('kind = "electrical"', 'kind = "thermal"\ninterfaces = ["1 ohm*m^2"]', "interfaces does not belong to kind"),
        (
            'kind = "electrical"',
            'kind = "thermal"',
            r"electrical_conductivity does not belong to \[conduction\] kind = \"thermal\"",
        ),
    ],
)
def test_command_line_refuses(old, new, words, tmp_path, capsys):
    text = (ROOT / "examples" / "problems" / "tin_on_copper.toml").read_text(encoding="utf-8")
    assert old in text
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(text.replace(old, new), encoding="utf-8")
    assert main(["conduction", str(wrong)]) in (1, 2)
    assert re.search(words, capsys.readouterr().err)


def test_the_command_joins_rough_surfaces(tmp_path, capsys):
    """Each state by `rough`; smooth surfaces as the limit of small roughness; a gas adds to heat; no heat of friction."""
    text = (ROOT / "examples" / "problems" / "heat_through_silica.toml").read_text(encoding="utf-8")
    text = re.sub(r"thermal_film.*", "", text.replace("points = 40", "points = 3"))
    file, table = tmp_path / "rough.toml", tmp_path / "table.csv"

    def found(joint):
        file.write_text(text + joint, encoding="utf-8")
        return studies.conduction(load(file))

    keys = ROUGH_KEYS.replace("1 um", "1 nm").replace("1 GPa", "40 GPa")
    smooth, rough = found(""), found(keys)
    joint = mdr.conduction.RoughJoint(1e-9, 0.1, 40e9)
    conduction, states = rough.conduction, rough.states
    assert rough.rough == pytest.approx([conduction.rough(states[i], joint) for i in range(3)], rel=1e-12)
    assert rough.numbers["conductance"].value == rough.rough[-1] < smooth.numbers["conductance"].value
    assert rough.numbers["conductance of smooth surfaces"].value == smooth.numbers["conductance"].value
    assert found(keys.replace("1 nm", "1e-10 nm")).rough == pytest.approx(smooth.conductance.conductance, rel=1e-6)
    gas = found(f'{keys}gas = "0.026 W/(m*K)"').rough
    assert np.all(rough.rough < found(f'{keys}gas = "0.026 W/(m*K)"\njump = "40 nm"').rough) and np.all(rough.rough < gas)
    assert main(["conduction", str(file), "--csv", str(table), "--plot", str(tmp_path / "picture.png")]) == 0
    assert "between smooth surfaces" in capsys.readouterr().out and table.read_text(encoding="utf-8").count("smooth surfaces") == 1
    with pytest.raises(mdr.problem.ProblemError, match="heat of friction between rough surfaces is not supported"):
        found('speed = "1 mm/s"\nfriction_coefficient = 0.2\n' + keys)
    with pytest.raises(mdr.problem.ProblemError, match=r"\[conduction.joint\]: jump = '40 nm'.*Give gas, or omit jump"):
        found(f'{keys}jump = "40 nm"')


def test_tables_are_compared_with_the_solution():
    for name in ("stack", "pair", "perfect base"):
        table, a = CASES[name].tabulated(0.05, 20.0, 1e-7), np.geomspace(0.05, 20.0, 171)
        exact, read = CASES[name].at_radius(a), table.at_radius(a)
        assert read.conductance == pytest.approx(exact.conductance, rel=2e-7)
        assert read.slope == pytest.approx(exact.slope, rel=1e-5)
        assert table.at_radius(30.0).conductance == CASES[name].at_radius(30.0).conductance


def test_a_law_and_a_table_conduct():
    """What a discrete-element code does: depth to radius by a law, radius to conductance by a table."""
    contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Coated(mdr.Elastic(5.0, 0.3), 1.0, mdr.Elastic(50.0, 0.3)))
    law = mdr.ContactLaw(contact, 0.5, tolerance=1e-8)
    conduction = Conduction(LayeredConductor([(Conductor(3.0), 1.0)], Conductor(1.0)))
    table, depth = conduction.tabulated(0.05, 3.0), np.linspace(0.02, 0.45, 20)
    found = table.at_radius(np.asarray(law.at_depth(depth).radius)).conductance
    assert found == pytest.approx(conduction.at_radius(np.asarray(contact.at_depth(depth).radius)).conductance, rel=1e-7)


@pytest.mark.parametrize("gamma", [0.0, 0.3])
def test_a_law_conducts(gamma):
    """G and its slope beside the contact's own, from a file and a pickle too."""
    contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Coated(mdr.Elastic(5.0, 0.3), 1.0, mdr.Elastic(50.0, 0.3)), gamma)
    conduction = Conduction(LayeredConductor([(Conductor(3.0), 0.05), (Conductor(0.1), 1.0)], Conductor(1.0)))
    law = mdr.ContactLaw(contact, 0.5, tolerance=1e-8, conduction=conduction)
    depth = np.linspace(0.02, 0.45, 20)
    states = contact.at_depth(depth)
    exact = conduction.along(states)
    found, slope = law.conductance(depth)
    assert found == pytest.approx(exact.conductance, rel=2e-8)
    assert slope == pytest.approx(exact.by_depth, rel=1e-5)
    again = pickle.loads(pickle.dumps(law))
    assert np.array_equal(again.conductance(depth)[0], found)
    assert law.conductance(-1.0) == (0.0, 0.0)
    if not gamma:
        # below the range a power of d goes on with the same value and slope
        lowest = law.depth_range[0]
        ends, slopes = law.conductance([0.999999 * lowest, lowest])
        assert ends[0] == pytest.approx(ends[1] - 1e-6 * lowest * slopes[1], rel=1e-10)
        small = conduction.at_radius(float(contact.at_depth(0.5 * lowest).radius)).conductance
        assert law.conductance(0.5 * lowest)[0] == pytest.approx(small, rel=2e-2)
    plain = mdr.ContactLaw(contact, 0.5, tolerance=1e-8)
    assert plain.force(0.3) == pytest.approx(law.force(0.3), rel=2e-8)
    with pytest.raises(mdr.MDRError, match="has no conductance"):
        plain.conductance(0.3)
    with pytest.raises(TypeError, match="conduction = 3"):
        mdr.ContactLaw(contact, 0.5, conduction=3.0)
    thin = conduction.replace(film=1e-9)
    with pytest.raises(mdr.MDRError, match="too thin"):
        mdr.ContactLaw(contact, 0.5, conduction=thin)


def test_a_law_of_a_punch_conducts():
    body = mdr.Homogeneous(mdr.Elastic(2.0, 0.3))
    law = mdr.ContactLaw(mdr.Contact(mdr.FlatPunch(0.4), body), 0.1, conduction=Conduction(Conductor(3.0)))
    assert law.conductance(0.05) == (pytest.approx(4.8, rel=1e-12), 0.0)


def test_fits_find_what_made_the_data():
    noise = np.random.default_rng(5)
    tin, copper = Conductor(9.17e6), Conductor(59.6e6)
    true = Conduction(LayeredConductor([(tin, 1e-6), mdr.Interface(2e-14)], copper))
    contact = mdr.Contact(mdr.Paraboloid(1e-3), mdr.Coated(mdr.Elastic(50e9, 0.36), 1e-6, mdr.Elastic(117e9, 0.34)))
    force = np.geomspace(1e-4, 1.0, 40)
    conductance = np.asarray(true.along(contact.at_force(force)).conductance)
    measured = conductance * (1.0 + 1e-3 * noise.standard_normal(40))
    start = true.replace(body=LayeredConductor([(Conductor(3e6), 1e-6), mdr.Interface(1e-14)], Conductor(30e6)))
    data = mdi.ConductanceForce(force, measured, contact, 1e-3 * conductance)
    fit = mdi.fit_conduction(data, start, ["layer1.sigma", "layer1.resistance", "substrate.sigma"])
    for name, value in (("layer1.sigma", 9.17e6), ("layer1.resistance", 2e-14), ("substrate.sigma", 59.6e6)):
        assert abs(fit.values[name] - value) < 4.0 * fit.errors[name], fit
    assert fit.errors["layer1.sigma"] < 0.02 * 9.17e6 and 0.4 < fit.chi_square / 40 < 1.8
    silica, silicon = Conductor(1.4, None, 1.66e6), Conductor(148.0, None, 1.66e6)
    true = Conduction(LayeredConductor([(silica, 1e-7), mdr.Interface(2e-8)], silicon))
    omega = np.geomspace(1e4, 1e8, 30)
    z = np.asarray(true.admittance(omega, 3e-6, "gaussian_potential"))
    sd = 1e-3 * abs(z).max()
    z = z + sd * (noise.standard_normal(30) + 1j * noise.standard_normal(30))
    start = true.replace(body=LayeredConductor([(silica, 1e-7), mdr.Interface(5e-9)], silicon.replace(sigma=60.0)))
    fit = mdi.fit_conduction(
        mdi.Impedance(omega, z, 3e-6, "gaussian_potential", sd), start, ["layer1.resistance", "substrate.sigma"]
    )
    for name, value in (("layer1.resistance", 2e-8), ("substrate.sigma", 148.0)):
        assert abs(fit.values[name] - value) < 4.0 * fit.errors[name], fit
        assert fit.errors[name] < 0.1 * value
    with pytest.raises(mdr.MDRError, match="did you mean 'layer1.sigma'"):
        mdi.fit_conduction(data, start, ["layer1.sigm"])


def elastic(sigma, E=1.0):
    return mdr.Elastic(E, 0.3, Conductor(sigma))


FILMS = mdr.Layered(
    [
        mdr.Layer(elastic(0.2), 0.1, interface=mdr.Interface(0.5)),
        mdr.Layer(elastic(0.7), 0.2, interface=mdr.Interface(0.5, tangential=2.0)),
    ],
    elastic(1.0),
)
LAYERS = LayeredConductor([(Conductor(0.2), 0.1), mdr.Interface(0.5), (Conductor(0.7), 0.2), mdr.Interface(0.5)], Conductor(1.0))


def test_an_elastic_body_conducts_with_its_interfaces():
    """Against the stack given layer by layer; G from an independent solver."""
    whole, stack = Conduction(FILMS), Conduction(LAYERS)
    assert whole.at_radius(1.0).conductance == pytest.approx(1.6972, abs=5e-5)
    k = np.array([0.1, 1.0, 10.0])
    contact = mdr.Contact(mdr.Paraboloid(1.0), FILMS)
    state = contact.at_radius(1.0)
    for one, other in ((whole, stack), (Conduction(mdr.Pair(elastic(2.0), FILMS)), Conduction(Conductor(2.0), LAYERS))):
        assert one.at_radius(1.0).conductance == pytest.approx(other.at_radius(1.0).conductance, rel=1e-12)
        assert one.compliance(k) == pytest.approx(other.compliance(k), rel=1e-12)
        assert one.along(state) == pytest.approx(other.along(state), rel=1e-12)
        heats = [conduction.friction_heat(state, 0.3, 1.0) for conduction in (one, other)]
        assert heats[0].flux_mean == pytest.approx(heats[1].flux_mean, rel=1e-12)
        assert heats[0].temperature(0.3, 0.2) == pytest.approx(heats[1].temperature(0.3, 0.2), rel=1e-12)
        assert one.rough(state, 0.1) == pytest.approx(other.rough(state, 0.1), rel=1e-12)
        assert one.tabulated(0.9, 1.1).at_radius(1.0).conductance == pytest.approx(other.at_radius(1.0).conductance, rel=1e-7)
    assert FILMS.compliance(k, "flux") == pytest.approx(stack.compliance(k), rel=1e-12)
    law = mdr.ContactLaw(contact, state.depth, tolerance=1e-6, conduction=whole)
    assert law.conductance(state.depth)[0] == pytest.approx(stack.at_radius(1.0).conductance, rel=1e-5)
    for part in (mdr.Interface(0.7), None):
        changed = FILMS.replace(layers=[FILMS.layers[0], FILMS.layers[1].replace(interface=part)])
        layers = [*LAYERS.layers[:3], *([] if part is None else [part])]
        expected = Conduction(LAYERS.replace(layers=layers)).at_radius(1.0).conductance
        assert Conduction(changed).at_radius(1.0).conductance == pytest.approx(expected, rel=1e-12)


def test_a_problem_files_resistances_lie_beside_springs(tmp_path):
    text = (ROOT / "examples" / "problems" / "tin_on_copper.toml").read_text(encoding="utf-8")
    old = 'electrical_conductivity = "9.17 MS/m"'
    text = text.replace(old, f'{old}\ninterface = {{tangential = "1e15 Pa/m"}}', 1)
    text = text.replace('kind = "electrical"', 'kind = "electrical"\ninterfaces = ["1e-14 ohm*m^2"]')
    problem = tmp_path / "springs.toml"
    problem.write_text(text, encoding="utf-8")
    loaded = load(problem)
    body = loaded.medium.lower if isinstance(loaded.medium, mdr.Pair) else loaded.medium
    (layer,) = body.layers
    assert layer.interface == mdr.Interface(tangential=1e15)
    expected = LayeredConductor([(layer.material.conductor, layer.thickness), mdr.Interface(1e-14)], body.substrate.conductor)
    given = loaded.conduction.conduction(body)
    assert given.at_radius(1e-6).conductance == pytest.approx(Conduction(expected).at_radius(1e-6).conductance, rel=1e-12)
    further = Conduction(LAYERS._with_resistances([0.2])).at_radius(1.0).conductance
    layers = [LAYERS.layers[0], mdr.Interface(0.7), *LAYERS.layers[2:]]
    assert further == pytest.approx(Conduction(LAYERS.replace(layers=layers)).at_radius(1.0).conductance, rel=1e-12)


def depths(thickness):
    """The depth below these layers, summed in several orders and units."""
    units = 1e-6 * thickness
    sums = (
        np.cumsum(thickness)[-1],
        sum(thickness),
        sum(thickness[::-1]),
        np.sum(thickness),
        math.fsum(thickness),
        sum(units) / 1e-6,
    )
    return {float(depth) for depth in sums}


def test_interfaces_have_two_sides_in_any_order_of_summation():
    """The potential jumps by R j, j does not; the heat of friction likewise."""
    draws = np.random.default_rng(7)
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3)))
    state, r = contact.at_radius(1.0), np.array([0.0, 0.7, 1.5])
    for _ in range(3):
        h, sigma = np.exp(draws.uniform(-3.0, 0.0, 4)), np.exp(draws.uniform(-2.0, 2.0, 5))
        layers = [part for s, x in zip(sigma, h, strict=False) for part in ((Conductor(s, 1.0), x), mdr.Interface(0.3))]
        conduction = Conduction(LayeredConductor(layers, Conductor(sigma[-1])))
        spot, heat = conduction.at_radius(1.0), conduction.friction_heat(state, 0.3, 1.0)
        for i in range(4):
            for z in depths(h[: i + 1]):
                above, below = (spot.potential(r, z, side=side) for side in ("above", "below"))
                flux = [spot.flux_inside(r, z, side=side)[0] for side in ("above", "below")]
                assert flux[0] == pytest.approx(flux[1], rel=1e-9)
                assert above - below == pytest.approx(0.3 * flux[0], rel=1e-9)
        middles = np.cumsum(h) - 0.5 * h
        alone = [spot.potential(0.7, z) for z in middles]
        assert spot.potential(0.7, middles) == pytest.approx(alone, rel=1e-13)
        jumps = [heat.temperature(0.5, z, side="above") - heat.temperature(0.5, z, side="below") for z in depths(h)]
        assert jumps[0] > 0.0 and jumps == pytest.approx([jumps[0]] * len(jumps), rel=1e-9)


def test_stresses_have_two_sides_in_any_order_of_summation():
    h = np.array([0.1, 0.2, 0.3, 0.7])
    films = [(mdr.Elastic(E, 0.3), x) for E, x in zip((5.0, 0.5, 5.0, 0.5), h, strict=True)]
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Layered(films, mdr.Elastic(2.0, 0.3))).at_radius(1.0)
    for i in range(1, 5):
        found = [[state.interior(0.3, z, side=side).s_rr for z in depths(h[:i])] for side in ("above", "below")]
        for side in found:
            assert side == pytest.approx([side[0]] * len(side), rel=1e-9)
        assert abs(found[0][0] - found[1][0]) > 1e-3 * abs(found[0][0])


def test_a_perfect_base_takes_what_reaches_it():
    """Across its surface the flux goes on, at the potential 0."""
    for resistance in (0.0, 0.4):
        layers = [(Conductor(1.0), 0.5), mdr.Interface(0.2), (Conductor(3.0, 2.0), 0.3), mdr.Interface(resistance)]
        spot, r = Conduction(LayeredConductor(layers, PERFECT)).at_radius(1.0), np.array([0.0, 0.6, 1.8])
        above, below = (spot.flux_inside(r, 0.8, side=side) for side in ("above", "below"))
        assert np.all(above[0] > 0.0) and np.all(below[0] == above[0]) and np.all(below[1] == 0.0)
        assert np.all(spot.potential(r, 0.8) == 0.0)
        assert spot.potential(r, 0.8, side="above") == pytest.approx(resistance * above[0], rel=1e-9, abs=1e-12)


HALF = Conduction(Conductor(1.0))


@pytest.mark.parametrize("motion", ["sliding", "spinning", "moving"])
def test_heat_is_not_made_by_tension(motion):
    """A rim that pulls would cool; a line force on the edge would make an infinite temperature."""
    conduction, body = Conduction(Conductor(1.0, None, 1.0)), mdr.Elastic(1.0, 0.3)
    sticky = {"work_of_adhesion": 0.01}
    tense, plate = (mdr.Homogeneous(body, surface) for surface in (mdr.Surface(0.1), mdr.Surface(0.0, 0.1)))
    for words, profile, medium, adhesion in (
        ("frictional heat: it is not available with adhesion", mdr.Paraboloid(1.0), mdr.Homogeneous(body), sticky),
        (
            "frictional heat: it is not available with adhesion",
            mdr.Paraboloid(1.0),
            mdr.Homogeneous(body),
            {**sticky, "cohesive_stress": 0.3},
        ),
        ("with a line force", mdr.Paraboloid(10.0), plate, {}),
        ("with a line force", mdr.FlatPunch(0.5), tense, {}),
        ("is not a single area", mdr.Cone(0.01), mdr.Coated(mdr.Elastic(1e3, 0.3), 0.3, body), {}),
    ):
        contact = mdr.Contact(profile, medium, **adhesion)
        flat = isinstance(profile, mdr.FlatPunch)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            state = contact.at_depth(0.01) if flat else contact.at_radius(0.5)
        with pytest.raises(mdr.MDRError, match=words):
            conduction.friction_heat(state, 0.3, 1.0, motion)
        if words != "is not a single area":
            with pytest.raises(mdr.MDRError, match="line force|not greater than 0 everywhere"):
                conduction.rough(state, 1.0)
    if motion == "sliding":
        state = mdr.Contact(mdr.Paraboloid(10.0), tense).at_radius(0.5)
        heat = conduction.friction_heat(state, 0.3, 1.0)
        assert heat.total == pytest.approx(0.3 * state.force, rel=2e-7)
        assert heat.temperature(0.0, 0.0) == pytest.approx(heat.centre, rel=1e-6)


def test_the_command_makes_no_heat_by_tension(tmp_path, capsys):
    text = (ROOT / "examples" / "problems" / "heat_through_silica.toml").read_text(encoding="utf-8")
    problem = tmp_path / "sticky.toml"
    text = re.sub(r"thermal_film.*", "", text)
    text = re.sub(r'kind = "thermal"', 'kind = "thermal"\nfriction_coefficient = 0.2\nspeed = "1 mm/s"', text)
    problem.write_text(text + '\n[adhesion]\nwork_of_adhesion = "0.05 J/m^2"\n', encoding="utf-8")
    assert main(["conduction", str(problem)]) in (1, 2)
    assert "frictional heat: it is not available with adhesion" in capsys.readouterr().err


def by_series(state, kappa, terms):
    """G between rough half-spaces of conductivity 1, a = 1: j = w P_n(1 - 2 r^2), its line load by Gauss."""
    u, weight = np.polynomial.legendre.leggauss(2 * terms + 40)
    angle, weight = 0.25 * np.pi * (u + 1.0), 0.25 * np.pi * weight
    x, root = np.sin(angle), np.cos(angle)
    polynomials = np.polynomial.legendre.legvander(1.0 - 2.0 * (x[:, None] ** 2 + (root[:, None] * x) ** 2), terms - 1)
    q = 2.0 * root[:, None] ** 2 * np.einsum("j,ijn->in", weight * root**2, polynomials)
    p = np.polynomial.legendre.legvander(1.0 - 2.0 * x**2, terms - 1)
    springs = np.einsum("i,im,in->mn", weight * root, q, q) / (2.0 * np.pi)
    springs += np.einsum("i,im,in->mn", weight * root**3 * x * kappa / state.pressure(x), p, p)
    f = weight * root @ q / np.pi
    return 2.0 * np.pi * f @ np.linalg.solve(springs, f)


def test_resistances_of_rough_surfaces_may_be_small():
    """Against as many terms as it takes; towards the smooth spot the deficit of G falls as kappa^(2/3); between bounds: j as in the
    smooth spot, j as the pressure."""
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_radius(1.0)
    uneven = mdr.Contact(mdr.PowerLaw(4.0, 10.0), mdr.Coated(mdr.Elastic(5.0, 0.3), 0.5, mdr.Elastic(1.0, 0.3))).at_radius(1.0)
    for one, part, terms in ((state, 1e-2, 40), (state, 2e-3, 60), (state, 1e-4, 110), (uneven, 1e-3, 90)):
        assert HALF.rough(one, part * one.force) == pytest.approx(by_series(one, part * one.force, terms), rel=1e-11)
    kappa = state.force * np.array([1e-6, 1e-9, 1e-12, 1e-300])
    deficit = 1.0 - np.array([HALF.rough(state, k) for k in kappa]) / 4.0
    assert deficit[:3] * kappa[:3] ** (-2.0 / 3.0) == pytest.approx([deficit[2] * kappa[2] ** (-2.0 / 3.0)] * 3, rel=0.02)
    assert abs(deficit[3]) < 1e-13
    films = Conduction(LAYERS)
    smooth, coated = films.at_radius(1.0).conductance, mdr.Contact(mdr.Cone(0.1), FILMS).at_radius(1.0)
    heat = films.friction_heat(coated, 1.0, 1.0)
    for part in (1.0, 1e-2, 1e-5, 1e-14):
        found = 1.0 / films.rough(coated, part * coated.force)
        assert 1.0 / smooth + part <= found * (1.0 + 1e-9)
        assert found <= part + heat.flux_mean / heat.total
    assert found == pytest.approx(1.0 / smooth, rel=1e-8)


def test_a_rough_punch_is_two_resistances_in_series():
    """Under a flat punch on a half-space the flux stays that of the smooth spot: 1/G = 1/(4 S a) + kappa/F,
    theory/conduction.md (4.13)."""
    punch = mdr.Contact(mdr.FlatPunch(0.4), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_depth(0.01)
    for part in (1e-8, 1e-3, 1.0, 100.0):
        assert 1.0 / HALF.rough(punch, part * punch.force) == pytest.approx(1.0 / 1.6 + part, rel=1e-11)


JOINT = mdr.conduction.RoughJoint(1e-6, 0.1, 3e9)
"""Rough surfaces in a vacuum."""
GAS = JOINT.replace(gas=0.026, jump=4e-7)
ALUMINIUM = mdr.conduction.Conductor(200.0)


def test_area_resistance_of_micro_contacts():
    """1.25 k_s m/sigma (p/H)^0.95 with the harmonic mean of both conductivities, and the gas between the mean planes."""
    pressure = 3e9 * np.array([1e-9, 1e-6, 1e-3, 0.0227501319481792, 0.158655253931457, 0.4999])
    contacts = 1.25 * (2.0 / (1 / 200.0 + 1 / 50.0)) * 0.1 / 1e-6 * (pressure / 3e9) ** 0.95
    pair = Conduction(ALUMINIUM, mdr.conduction.Conductor(50.0))
    assert pair.joint_resistance(JOINT, pressure) == pytest.approx(1.0 / contacts, rel=1e-13)
    separation = scipy.stats.norm.isf(pressure / 3e9)
    assert separation[3:5] == pytest.approx([2.0, 1.0], rel=1e-12)
    whole = contacts + 0.026 / (1e-6 * separation + 4e-7)
    assert pair.joint_resistance(GAS, pressure) == pytest.approx(1.0 / whole, rel=1e-12)
    # one body, whose partner conducts perfectly; along and into the body the geometric mean
    uneven = Conduction(mdr.conduction.Conductor(100.0, along=400.0))
    assert uneven.joint_resistance(JOINT, 3e6) == pytest.approx(1e-6 / (1.25 * 400.0 * 0.1 * 0.001**0.95), rel=1e-13)


def by_whole_series(state, resistance, terms=40):
    """G between rough half-spaces of conductivity 1, a = 1, j = P_n and w P_n: for fluxes that may be finite at the edge."""
    u, weight = np.polynomial.legendre.leggauss(2 * terms + 400)
    angle, weight = 0.25 * np.pi * (u + 1.0), 0.25 * np.pi * weight
    x, root = np.sin(angle), np.cos(angle)
    polynomials = np.polynomial.legendre.legvander(1.0 - 2.0 * (x[:, None] ** 2 + (root[:, None] * x) ** 2), terms - 1)
    q = 2.0 * root[:, None] ** 2 * np.einsum("j,ijn->in", weight * root**2, polynomials)
    flux = root[:, None] * np.polynomial.legendre.legvander(1.0 - 2.0 * x**2, terms - 1)
    plain = 2.0 * root[:, None] * np.einsum("j,ijn->in", weight * root, polynomials)
    q, flux = np.hstack((q, plain)), np.hstack((flux, flux / root[:, None]))
    springs = np.einsum("i,im,in->mn", weight * root, q, q) / (2.0 * np.pi)
    springs += np.einsum("i,im,in->mn", weight * root * x * resistance(state.pressure(x)), flux, flux)
    f = weight * root @ q / np.pi
    return 2.0 * np.pi * f @ np.linalg.lstsq(springs, f, rcond=1e-15)[0]


def test_micro_contacts_under_the_pressure_of_a_contact():
    """Against a series by independent quadrature, the smooth contact, and a film of the gas alone."""
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_radius(1.0)
    joint = mdr.conduction.RoughJoint(0.1, 0.2, 100.0)
    gas = joint.replace(gas=0.05, jump=0.02)
    found, with_gas = HALF.rough(state, joint), HALF.rough(state, gas)
    assert found == pytest.approx(by_whole_series(state, lambda p: HALF.joint_resistance(joint, p)), rel=2e-9)
    assert with_gas == pytest.approx(by_whole_series(state, lambda p: HALF.joint_resistance(gas, p)), rel=5e-9)
    smooth = HALF.at_radius(1.0).conductance
    assert 0.0 < found < with_gas < smooth
    finer = [HALF.rough(state, joint.replace(roughness=10.0**-k)) for k in (1, 3, 5, 15)]
    assert np.all(np.diff(finer) > 0.0) and finer[-1] == pytest.approx(smooth, rel=1e-8)
    # a wide gap makes the gas a film of constant resistance: hardly any micro-contacts
    film = joint.replace(slope=1e-12, roughness=1e-6, gas=1.0, jump=1.0)
    assert HALF.rough(state, film) == pytest.approx(Conduction(Conductor(1.0), film=1.0).at_radius(1.0).conductance, rel=1e-4)


def test_rough_joints_that_are_not():
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_radius(1.0)
    for name in ("roughness", "slope", "hardness"):
        for value in (0.0, -1.0, np.nan, np.inf):
            with pytest.raises(mdr.errors.InvalidArgumentError, match=f"^{name} = "):
                JOINT.replace(**{name: value})
    with pytest.raises(mdr.errors.InvalidArgumentError, match="^gas = -1"):
        JOINT.replace(gas=-1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="^jump = 1e-07: .* Give gas"):
        JOINT.replace(jump=1e-7)
    soft = mdr.conduction.RoughJoint(0.1, 0.2, 1.9 * state.pressure(0.0))
    with pytest.raises(mdr.errors.DomainError, match="^hardness = .* twice the pressure"):
        HALF.rough(state, soft)
    for pressure, error in ((0.0, "InvalidArgumentError"), (1.6e9, "DomainError"), (np.nan, "InvalidArgumentError")):
        with pytest.raises(getattr(mdr.errors, error)):
            HALF.joint_resistance(JOINT, pressure)
    for wrong in ("a", None, [1.0]):
        with pytest.raises(mdr.errors.ArgumentTypeError, match="joint"):
            HALF.rough(state, wrong)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="RoughJoint"):
        HALF.joint_resistance(1.0, 1.0)


def test_conductors_have_no_springs():
    """Of an elastic body the springs are left with its mechanics; conductors given layer by layer have none to leave."""
    with pytest.raises(mdr.errors.InvalidArgumentError, match="springs of elastic layers"):
        LayeredConductor([(Conductor(1.0), 1.0), mdr.Interface(0.5, normal=2.0)], Conductor(2.0))
    solid, base = mdr.Elastic(1.0, 0.3, Conductor(1.0)), mdr.Elastic(2.0, 0.3, Conductor(2.0))
    glued = mdr.Layered([mdr.Layer(solid, 1.0, interface=mdr.Interface(0.5, normal=2.0))], base)
    alone = LayeredConductor([(Conductor(1.0), 1.0), mdr.Interface(0.5)], Conductor(2.0))
    assert Conduction(glued).at_radius(1.0).conductance == Conduction(alone).at_radius(1.0).conductance


SPINNING_TIPS = [mdr.Paraboloid(1.0), mdr.Cone(0.4), mdr.FlatEndedParaboloid(0.3, 1.0), mdr.FlatEndedCone(0.01, 0.3)]


@pytest.mark.parametrize("tip", SPINNING_TIPS)
def test_centre_of_a_spinning_contact(tip):
    """mu Omega F/(2 pi kappa) under any pressure: p is infinite at the edge of a flat end, and changes fast above a thin film."""
    media = [
        (mdr.Homogeneous(mdr.Elastic(1.0, 0.3)), 1e-12),
        (mdr.Coated(mdr.Elastic(1.0, 0.3), 0.02, mdr.Elastic(2.0, 0.2)), 1e-11),
        (mdr.PowerLawGraded(1.0, 1.0, 0.4, 0.3), 1e-8),
    ]
    for medium, accuracy in media:
        state = mdr.Contact(tip, medium).at_radius(1.3)
        heat = Conduction(Conductor(0.7)).friction_heat(state, 0.5, 3.0, "spinning")
        expected = 0.5 * 3.0 * state.force / (2.0 * np.pi * 0.7)
        assert heat.centre == pytest.approx(expected, rel=accuracy)


@pytest.mark.parametrize("exponent", [-0.6, -0.3, 0.0, 0.5])
@pytest.mark.parametrize("motion", ["sliding", "spinning"])
def test_heat_on_a_body_graded_by_a_power(exponent, motion):
    """On a half-space T(0) = int j dr/kappa and Q = 2 pi int j r dr, here of p ~ (a^2 - r^2)^((m - 1)/2) under a flat punch."""
    state = mdr.Contact(mdr.FlatPunch(2.0), mdr.PowerLawGraded(1.0, 1.0, exponent, 0.3)).at_force(0.9)
    heat = Conduction(Conductor(0.7)).friction_heat(state, 0.5, 3.0, motion)

    def moment(power):
        """int_0^1 x^power (1 - x^2)^((m - 1)/2) dx"""
        return 0.5 * scipy.special.beta(0.5 * (power + 1.0), 0.5 * (exponent + 1.0))

    first = 0.5 * 3.0 * 0.9 / (2.0 * np.pi * moment(1))
    if motion == "sliding":
        assert heat.centre == pytest.approx(first * moment(0) / (2.0 * 0.7), rel=1e-9)
        assert heat.total == pytest.approx(0.5 * 3.0 * 0.9, rel=1e-9)
    else:
        assert heat.centre == pytest.approx(first * moment(1) / 0.7, rel=1e-9)
        assert heat.total == pytest.approx(2.0 * np.pi * first * moment(2) * 2.0, rel=1e-9)


@pytest.mark.parametrize(
    ("body", "largest", "behind", "centre", "flux_mean"),
    [
        (Conductor(1.0, None, 1.0), 0.04970430660749859, 0.64848895639, 0.039788389886130746, 0.030007734266309528),
        (
            LayeredConductor([(Conductor(2.0, None, 1.0), 0.3)], Conductor(1.0, None, 3.0)),
            *(0.03503149484164056, 0.64486366360, 0.02810220011393175, 0.02119227289193812),
        ),
    ],
)
def test_temperatures_of_a_fast_source(body, largest, behind, centre, flux_mean):
    """By directions that are real, in short panels, of every wave: 14 digits."""
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_radius(1.0)
    heat = Conduction(body).friction_heat(state, 1.0, 1.0, "moving", 300.0)
    assert heat.largest == pytest.approx(largest, rel=1e-12)
    assert heat.behind == pytest.approx(behind, rel=1e-9)
    assert heat.centre == pytest.approx(centre, rel=1e-13) and heat.flux_mean == pytest.approx(flux_mean, rel=1e-13)


@pytest.mark.parametrize("time", [5e-5, 1e-2, 0.3, 10.0])
def test_centre_under_a_step_of_uniform_flux(time):
    """2 q sqrt(D t) [ierfc(0) - ierfc(a/(2 sqrt(D t)))]/kappa of a half-space."""
    diffused, kappa = math.sqrt(2.0 * time), 0.5
    x = 1.0 / (2.0 * diffused)
    rise = 1.0 / math.sqrt(math.pi) - (math.exp(-(x**2)) / math.sqrt(math.pi) - x * math.erfc(x))
    found = Conduction(Conductor(kappa, None, kappa / 2.0)).step(time, 1.0, "centre_potential")
    assert found == pytest.approx(2.0 * diffused * rise / (math.pi * kappa), rel=2e-12)
