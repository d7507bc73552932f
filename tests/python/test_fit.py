# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits: recovery, uncertainty, refusals, warnings."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from conftest import OXIDE, ROOT, SILICON
from records import sink_in

import mdrcontact as mdr
import mdrcontact.instruments as mdi

FILM = mdr.Coated(OXIDE, 500e-9, SILICON, "exact")
BALL = mdr.Paraboloid(10e-6)
DEPTH = np.linspace(1e-9, 100e-9, 60)
FORCE = np.asarray(mdr.Contact(BALL, FILM).at_depth(DEPTH).force)
START = FILM.replace(coating=mdr.Elastic(50e9, 0.17))
SHARED = ROOT.parent / "shared" / "data"


def noisy(seed: int, noise: float = 0.01) -> mdi.ForceDepth:
    """A curve with 1 % noise."""
    random = np.random.default_rng(seed)
    return mdi.ForceDepth(DEPTH, FORCE * (1.0 + noise * random.standard_normal(DEPTH.size)), relative_sd=noise)


EVERY = [
    (mdr.Sphere(10e-6), FILM, ["coating.E", "thickness"]),
    (mdr.Cone(0.3), FILM.with_model("gao"), ["coating.E", "substrate.E"]),
    (mdr.PowerLaw(3.0, 1e10), FILM.with_model("gao-series"), ["coating.E", "indenter.coefficient"]),
    (mdr.FlatEndedCone(1e-7, 0.3), FILM.with_model("bec"), ["coating.E", "indenter.end_radius"]),
    (mdr.FlatEndedParaboloid(1e-7, 5e-6), FILM.with_model("perriot-barthel"), ["coating.E", "substrate.E"]),
    (mdr.RoundedCone(1e-7, 0.3), FILM.with_model("hay-crawford"), ["coating.E", "indenter.blend_radius"]),
    (mdr.FlatPunch(1e-6), FILM.with_model("wave"), ["coating.E"]),
    (mdr.Berkovich(), FILM.with_model("doerner-nix"), ["coating.E", "alpha"]),
    (mdr.AreaFunction([24.5, 2e-7], max_height=1e-6), FILM, ["coating.E"]),
    (BALL, mdr.Homogeneous(OXIDE), ["E", "depth_offset", "force_offset"]),
    (BALL, mdr.Layered([(OXIDE, 2e-7), (SILICON, 3e-7)], OXIDE, "exact"), ["layers[0].E", "layers[1].E"]),
    (BALL, mdr.PowerLawGraded(70e9, 1e-6, 0.3, 0.2), ["E0", "exponent"]),
    (BALL, mdr.Graded([0.0, 1e-6], [72e9, 160e9], 0.2, "gao"), ["E[0]", "E[1]"]),
    (BALL, mdr.Coated(mdr.Elastic(2e6, 0.5), 4e-6, mdr.RIGID, "garcia"), ["coating.E", "thickness"]),
    (BALL, FILM, ["coating.E", "frame_compliance"]),
]


def test_information_criteria_are_those_of_akaike_and_schwarz():
    """Of 60 points with known noise and two parameters; of ten with unknown noise one parameter more."""
    found = mdi.fit(noisy(1), BALL, START, ["coating.E", "substrate.E"], sd_is_absolute=True)
    sd = 0.01 * FORCE
    likelihood = -0.5 * np.sum(((found.data.y - found.fitted) / sd) ** 2 + np.log(2.0 * math.pi * sd**2))
    assert found.log_likelihood == pytest.approx(likelihood, rel=1e-3)
    assert found.aic == pytest.approx(-2.0 * found.log_likelihood + 4.0 + 12.0 / 57.0, rel=1e-12)
    assert found.bic == pytest.approx(-2.0 * found.log_likelihood + 2.0 * math.log(60.0), rel=1e-12)
    few = mdi.fit(mdi.ForceDepth(DEPTH[::6], noisy(1).y[::6]), BALL, START, ["coating.E", "substrate.E"])
    assert few.aic == pytest.approx(-2.0 * few.log_likelihood + 6.0 + 24.0 / 6.0, rel=1e-12)


@pytest.mark.parametrize(("indenter", "medium", "free"), EVERY, ids=[f"{type(i).__name__}-{f[-1]}" for i, _, f in EVERY])
def test_the_forward_model_is_that_of_contact_and_exact_data_give_the_truth(indenter, medium, free):
    """Every indenter and medium: the curve of Contact, an independent inversion, is met to 1e-8 and its parameters are found."""
    force = np.asarray(mdr.Contact(indenter, medium).at_depth(DEPTH).force)
    truth = mdi.fit(mdi.ForceDepth(DEPTH, force), indenter, medium, free)
    assert np.allclose(truth.fitted, force, rtol=1e-8, atol=1e-9 * force.max())
    scale = {"depth_offset": 3e-9, "force_offset": 1e-3 * force.max(), "frame_compliance": 0.05 * DEPTH[-1] / force.max()}
    start = {name: scale.get(name, 1.2 * truth.values[name]) for name in free}
    found = mdi.fit(mdi.ForceDepth(DEPTH, force), indenter, medium, start)
    assert found.converged
    for name in free:
        assert found.estimates[name] == pytest.approx(truth.values[name], rel=2e-5, abs=1e-4 * scale.get(name, 0.0))


def test_intervals_hold_the_truth_as_often_as_they_say():
    """Over 30 noisy curves: fewer than 24 inside has a probability below 1e-4 if 95 % are right. benchmarks/fit_recovery.py has
    the long run."""
    inside = 0
    for seed in range(30):
        lower, upper = mdi.fit(noisy(seed), BALL, START, ["coating.E", "substrate.E"]).interval("coating.E")
        inside += lower <= OXIDE.E <= upper
    assert inside >= 24


def test_three_ways_to_an_interval_agree():
    """Where the model is nearly linear, normal, profile-likelihood and Monte Carlo intervals are the same."""
    result = mdi.fit(noisy(1), BALL, START, {"coating.E": None, "thickness": mdi.Free(prior=(500e-9, 10e-9))})
    normal, profile = result.interval("coating.E"), result.interval("coating.E", method="profile")
    simulated = result.interval("coating.E", method="monte-carlo", draws=100, seed=1)
    width = normal.upper - normal.lower
    assert np.allclose(profile, normal, atol=0.05 * width)
    assert np.allclose(simulated, normal, atol=0.25 * width)


def test_a_prior_widens_the_interval_of_what_depends_on_it():
    """The uncertainty of the thickness enters that of the modulus: between a known and an unknown thickness."""
    fixed = mdi.fit(noisy(2), BALL, START, ["coating.E"])
    prior = mdi.fit(noisy(2), BALL, START, {"coating.E": None, "thickness": mdi.Free(prior=(500e-9, 5e-9))})
    unknown = mdi.fit(noisy(2), BALL, START, ["coating.E", "thickness"])
    errors = [result.standard_errors["coating.E"] for result in (fixed, prior, unknown)]
    assert errors[0] < errors[1] < errors[2]
    assert prior.standard_errors["thickness"] < 5e-9


def test_adhesion():
    """An adhesive curve on a homogeneous body against JKR in closed form; both parameters are found from another start."""
    star, gamma, R = OXIDE.contact_modulus / 1000.0, 0.05, 5e-6
    a = np.linspace(0.35e-6, 1.2e-6, 3000)
    opening = np.sqrt(2.0 * np.pi * a * gamma / star)
    d, F = a**2 / R - opening, 4.0 * star * a**3 / (3.0 * R) - 2.0 * a * star * opening
    first = int(np.argmin(d)) + 20
    depth = np.linspace(d[first], d[-1], 80)
    force = np.interp(depth, d[first:], F[first:])
    result = mdi.fit(
        mdi.ForceDepth(depth, force),
        mdr.Paraboloid(R),
        mdr.Homogeneous(mdr.Elastic(OXIDE.E / 2000.0, OXIDE.nu)),
        ["E", "work_of_adhesion"],
        instrument=mdi.Instrument(work_of_adhesion=0.03),
    )
    assert result.estimates["E"] == pytest.approx(OXIDE.E / 1000.0, rel=1e-4)
    assert result.estimates["work_of_adhesion"] == pytest.approx(gamma, rel=1e-4)


@pytest.mark.parametrize("said", ["pair", "instrument"])
def test_force_depth_data_of_a_deformable_indenter(said):
    """A diamond on a film: force-depth data take its compliance exactly, however it is said."""
    diamond, tip = mdr.Elastic(1141e9, 0.07), mdr.Paraboloid(5e-6)
    depth = np.linspace(1e-9, 60e-9, 40)
    data = mdi.ForceDepth(depth, mdr.Contact(tip, mdr.Pair(FILM, diamond)).at_depth(depth).force)
    if said == "pair":
        result = mdi.fit(data, tip, mdr.Pair(START, diamond), ["coating.E", "substrate.E"])
        assert result.medium.upper == mdr.Homogeneous(diamond)
    else:
        result = mdi.fit(data, tip, START, ["coating.E", "substrate.E"], instrument=mdi.Instrument(indenter=diamond))
    assert result.estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-6)
    assert result.estimates["substrate.E"] == pytest.approx(SILICON.E, rel=1e-6)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="the upper body of a Pair is the indenter"):
        mdi.fit(data, tip, mdr.Pair(START, diamond), ["coating.E"], instrument=mdi.Instrument(indenter=diamond))


@pytest.mark.parametrize("kind", ["modulus", "stiffness", "depth"])
def test_stiffness_data(kind):
    """E_eff(a), k(a) and dynamic nanoindentation with an elastic indenter: forms written out here, noise-free, give the truth."""
    diamond = mdr.Elastic(1141e9, 0.07)
    tip = mdr.Berkovich()
    h_c = np.linspace(15e-9, 250e-9, 50)
    a = h_c / math.tan(tip.inclination)
    reduced = np.asarray(mdr.Pair(FILM, diamond).modulus(a))
    stiffness = 2.0 * a * reduced
    load = 9e9 * math.pi * a**2
    data = {
        "modulus": mdi.ModulusRadius(a, reduced),
        "stiffness": mdi.StiffnessRadius(a, stiffness),
        "depth": mdi.StiffnessDepth(h_c + sink_in(mdr.Pair(FILM, diamond), a) * load / stiffness, load, stiffness),
    }[kind]
    result = mdi.fit(data, tip, START, ["coating.E", "substrate.E"], instrument=mdi.Instrument(indenter=diamond))
    assert result.converged
    assert result.estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-6)
    assert result.estimates["substrate.E"] == pytest.approx(SILICON.E, rel=1e-6)


def test_noise_of_stiffness_enters_the_contact_depth_too():
    """A stiffness that reads high makes the contact look deeper, so less of its error is left in the residual."""
    h_c = np.linspace(15e-9, 250e-9, 400)
    a = h_c / math.tan(mdr.Berkovich().inclination)
    stiffness = np.asarray(FILM.stiffness(a))
    load = 9e9 * math.pi * a**2
    random = np.random.default_rng(5)
    noisy_stiffness = stiffness * (1.0 + 0.01 * random.standard_normal(a.size))
    data = mdi.StiffnessDepth(h_c + sink_in(FILM, a) * load / stiffness, load, noisy_stiffness, relative_sd=0.01)
    result = mdi.fit(data, mdr.Berkovich(), START, ["coating.E"])
    assert result.chi_square / result.degrees_of_freedom == pytest.approx(1.0, abs=4.0 * math.sqrt(2.0 / 400))


def test_robust_loss_resists_outliers():
    """Five points off by 30 % move a least-squares fit by many standard errors and a robust one hardly."""
    data = noisy(3)
    y = data.y.copy()
    y[10:60:10] *= 1.3
    spoiled = data.with_y(y)
    truth = OXIDE.E
    plain = mdi.fit(spoiled, BALL, START, ["coating.E"])
    for loss in ("huber", "cauchy"):
        robust = mdi.fit(spoiled, BALL, START, ["coating.E"], loss=loss)
        assert abs(robust.estimates["coating.E"] - truth) < 0.2 * abs(plain.estimates["coating.E"] - truth)
        assert robust.converged


def test_bounds():
    """An estimate stops at its bound, says so, and the others follow."""
    result = mdi.fit(noisy(4), BALL, START, {"coating.E": mdi.Free(50e9, upper=60e9), "substrate.E": None})
    assert result.estimates["coating.E"] == pytest.approx(60e9, rel=1e-12)
    assert result.at_bound["coating.E"] == 1
    assert any("upper bound" in words for words in result.warnings)
    inside = mdi.fit(noisy(4), BALL, START, {"coating.E": mdi.Free(50e9, lower=40e9, upper=90e9)})
    free = mdi.fit(noisy(4), BALL, START, ["coating.E"])
    assert inside.estimates["coating.E"] == pytest.approx(free.estimates["coating.E"], rel=1e-6)


def test_what_the_data_do_not_determine_is_said_with_its_reason():
    """Contacts far wider than a film feel its modulus and thickness together."""
    contact = mdr.Contact(BALL, FILM)
    depth = np.linspace(0.02, 0.1, 40) * float(contact.at_radius(20 * 500e-9 * 0.9).depth)
    force = np.asarray(contact.at_depth(depth).force) * (1.0 + 0.01 * np.random.default_rng(6).standard_normal(40))
    result = mdi.fit(mdi.ForceDepth(depth, force, relative_sd=0.01), BALL, FILM, ["coating.E", "thickness", "substrate.E"])
    words = " ".join(result.warnings)
    assert "a/h runs from" in words
    assert "hardly determined" in words or "trade off" in words


def test_wrong_models_are_found_out():
    """The exact model explains its own data, the others do not; the ranking says how far each puts the film's modulus off."""
    ranking = mdi.compare_models(noisy(7), BALL, START, ["coating.E"])
    assert ranking.models[0].model == "exact"
    bias = {entry.model: entry.bias["coating.E"] for entry in ranking.models}
    assert bias["exact"] == 0.0
    assert bias["wave"] > 0.2
    best = ranking.models[0]
    for entry in ranking.models:
        assert entry.weight == pytest.approx(best.weight * math.exp(-0.5 * (entry.result.aic - best.result.aic)), rel=1e-9)
    assert sum(entry.weight for entry in ranking.models) == pytest.approx(1.0, rel=1e-12)
    assert "exact" in ranking.summary()


def test_a_search_that_does_not_converge_says_so_and_gives_its_best_point():
    data = noisy(8)
    result = mdi.fit(data, BALL, START, ["coating.E", "thickness"], max_iterations=1)
    assert not result.converged
    assert "did not converge" in result.warnings[0]
    begin = mdi.fit(data, BALL, FILM, ["coating.E"]).chi_square
    assert result.chi_square < 100 * begin


BAD = [
    (lambda: mdi.ForceDepth(DEPTH, np.where(DEPTH > 9e-8, np.nan, FORCE)), "rows are not finite"),
    (lambda: mdi.ForceDepth(DEPTH[:2], FORCE[:2]), "too few points: 2"),
    (lambda: mdi.ForceDepth([], []), "too few points"),
    (lambda: mdi.ForceDepth(DEPTH, 1e3 * FORCE), "Check the units"),
    (lambda: mdi.ForceDepth(1e-3 * DEPTH, FORCE), "Check the units"),
    (lambda: mdi.ForceDepth(DEPTH, np.full_like(FORCE, 1e-3)), "force: it is .* at all points"),
    (lambda: mdi.ForceDepth(np.full_like(DEPTH, 1e-8), FORCE), "depth: it is .* at all points"),
    (lambda: mdi.ForceDepth(DEPTH, FORCE[:-1]), "same length"),
    (lambda: mdi.ForceDepth(DEPTH, FORCE, sd=0.0), "sd"),
    (lambda: mdi.ForceDepth(DEPTH, FORCE, relative_sd=2.0), "relative_sd"),
]


@pytest.mark.parametrize(("make", "words"), BAD, ids=[words for _, words in BAD])
def test_bad_data_are_refused_in_words(make, words):
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
        mdi.fit(make(), BALL, FILM, ["coating.E", "substrate.E"])


def test_bad_arguments_are_refused_in_words():
    data = mdi.ForceDepth(DEPTH, FORCE)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean 'coating.E'"):
        mdi.fit(data, BALL, FILM, ["coatin.E"])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="coating.E"):
        mdi.fit(data, BALL, FILM, {"coating.E": mdi.Free(lower=80e9)})
    with pytest.raises(mdr.errors.InvalidArgumentError, match="none is free"):
        mdi.fit(data, BALL, FILM, [])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="loss"):
        mdi.fit(data, BALL, FILM, ["coating.E"], loss="square")


def test_disorder_changes_nothing_and_is_no_warning():
    data = noisy(9)
    order = np.arange(len(DEPTH))
    order[20], order[21] = 21, 20
    mixed = mdi.ForceDepth(DEPTH[order], data.y[order], relative_sd=0.01)
    result, sorted_result = (mdi.fit(d, BALL, START, ["coating.E"]) for d in (mixed, data))
    assert result.warnings == sorted_result.warnings
    assert result.estimates["coating.E"] == pytest.approx(sorted_result.estimates["coating.E"], rel=1e-9)


def test_one_bad_curve_does_not_stop_the_others():
    def bad() -> mdi.ForceDepth:
        return mdi.ForceDepth(DEPTH, np.full_like(FORCE, np.nan))

    counted: list[int] = []
    results = mdi.fit_many([noisy(10), bad, noisy(11)], BALL, START, ["coating.E"], progress=counted.append)
    assert isinstance(results[1], mdi.FailedFit)
    assert "not finite" in str(results[1].error)
    for good in (results[0], results[2]):
        assert good.estimates["coating.E"] == pytest.approx(OXIDE.E, rel=0.02)
    assert counted == [1, 2, 3]


def test_summary_and_json(tmp_path):
    result = mdi.fit(noisy(12), BALL, START, ["coating.E", "thickness"])
    text = result.summary()
    assert "coating.E" in text and "chi-square" in text and "correlation" in text
    written = tmp_path / "fit.json"
    found = json.loads(result.to_json(written))
    assert json.loads(written.read_text()) == found
    assert found["parameters"]["coating.E"]["value"] == result.estimates["coating.E"]
    assert np.allclose(np.diag(result.correlation), 1.0)


@pytest.mark.skipif(not SHARED.is_dir(), reason="the measurements are not here")
@pytest.mark.parametrize(
    ("file", "modulus", "film", "nu", "literature", "error"),
    [
        ("sio2_500nm_on_si_csm.csv", "E_OP_GPa", OXIDE, 0.17, (65e9, 80e9), 2.2e9),
        ("al_500nm_sio2_500nm_on_si_csm.csv", "E_GPa", mdr.Elastic(70e9, 0.35), 0.35, (55e9, 80e9), 7.6e9),
    ],
)
def test_measured_films(file, modulus, film, nu, literature, error):
    """Thermal oxide and PVD aluminium: E_eff against a/h from printed moduli, between tip rounding (50 nm) and 30 % of the film.

    The standard errors are those of docs/fit.md; residuals that run along the curve are in them.
    """
    rows = np.genfromtxt(SHARED / file, delimiter=",", names=True)
    rows = rows[(rows["h_nm"] > 50.0) & (rows["h_nm"] < 150.0)]
    tip = mdr.Elastic(1070e9, 0.07).contact_modulus
    star = rows[modulus] * 1e9 / (1.0 - nu**2)
    radius = 0.5 * rows["S_N_per_m"] * (1.0 / star + 1.0 / tip)
    data = mdi.ModulusRadius(radius, star, sd=rows["sd_" + modulus] * 1e9 / (1.0 - nu**2))
    layers = [(film, 500e-9)] if film is OXIDE else [(film, 500e-9), (OXIDE, 500e-9)]
    free = {"layers[0].E": None, "layers[0].thickness": mdi.Free(prior=(500e-9, 25e-9))}
    result = mdi.fit(data, mdr.Berkovich(), mdr.Layered(layers, SILICON, "exact"), free)
    assert result.converged
    assert literature[0] < result.estimates["layers[0].E"] < literature[1]
    assert result.standard_errors["layers[0].E"] == pytest.approx(error, rel=0.05)
