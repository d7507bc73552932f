# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether intervals hold what limits them, and whether wrong numbers are loud."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import OXIDE, SILICON
from records import sink_in
from scipy import stats

import mdrcontact as mdr
import mdrcontact.instruments as mdi

FILM = mdr.Coated(OXIDE, 500e-9, SILICON, "exact")
BALL = mdr.Paraboloid(10e-6)
DEPTH = np.linspace(2e-9, 100e-9, 60)
FORCE = np.asarray(mdr.Contact(BALL, FILM).at_depth(DEPTH).force)
DIAMOND = mdr.Elastic(1141e9, 0.07)


def autoregression(random, n, rho):
    """Noise of variance 1 whose neighbours have the correlation rho."""
    noise = random.standard_normal(n)
    for i in range(1, n):
        noise[i] = rho * noise[i - 1] + math.sqrt(1.0 - rho**2) * noise[i]
    return noise


@pytest.mark.parametrize("known", [True, False])
def test_intervals_hold_the_truth_under_correlated_noise(known):
    """Lag-1 correlation 0.9: of 40 intervals of 95 % fewer than 32 would hold the truth with a probability of 5e-4; intervals for
    independent noise hold about 18. The long run is benchmarks/fit_recovery.py."""
    inside = 0
    widest = []
    for seed in range(40):
        noise = 0.01 * autoregression(np.random.default_rng(seed), DEPTH.size, 0.9)
        data = mdi.ForceDepth(DEPTH, FORCE * (1.0 + noise), relative_sd=0.01)
        result = mdi.fit(data, BALL, FILM, ["coating.E"], sd_is_absolute=known)
        lower, upper = result.interval("coating.E")
        inside += lower <= OXIDE.E <= upper
        widest.append(result.widening["coating.E"])
    assert inside >= 32
    assert 2.0 < np.median(widest) < 8.0


def test_the_three_intervals_know_of_the_correlation():
    noise = 0.01 * autoregression(np.random.default_rng(3), DEPTH.size, 0.9)
    result = mdi.fit(mdi.ForceDepth(DEPTH, FORCE * (1.0 + noise), relative_sd=0.01), BALL, FILM, ["coating.E"])
    assert result.lag_correlation > 0.7
    assert "error widened" in result.summary().splitlines()[2], "the doubt stands beside the number"
    width = np.ptp(result.interval("coating.E"))
    assert np.ptp(result.interval("coating.E", method="profile")) == pytest.approx(width, rel=0.05)
    assert np.ptp(result.interval("coating.E", method="monte-carlo", draws=100, seed=1)) == pytest.approx(width, rel=0.4)


def test_widening_of_a_mean():
    """The mean of many readings with the correlation rho is worth as many as (1 - rho)/(1 + rho) says."""
    radius = np.linspace(1e-7, 1e-6, 2000)
    noise = 0.01 * autoregression(np.random.default_rng(0), 2000, 0.9)
    data = mdi.ModulusRadius(radius, 7e10 * (1.0 + noise), sd=np.full(2000, 7e8))
    result = mdi.fit(data, BALL, mdr.Homogeneous(mdr.Elastic(7e10, 0.2)), ["E"], sd_is_absolute=True)
    rho = result.lag_correlation
    assert result.widening["E"] == pytest.approx(math.sqrt((1.0 + rho) / (1.0 - rho)), rel=0.01)


def test_correlation_of_residuals_counts_once():
    """In the standard error; Student's quantile is that of all degrees of freedom."""
    noise = 0.01 * autoregression(np.random.default_rng(3), DEPTH.size, 0.9)
    result = mdi.fit(mdi.ForceDepth(DEPTH, FORCE * (1.0 + noise)), BALL, FILM, ["coating.E"])
    assert result.widening["coating.E"] > 2.0
    quantile = stats.t.ppf(0.975, result.degrees_of_freedom)
    assert np.ptp(result.interval("coating.E")) == pytest.approx(2.0 * quantile * result.standard_errors["coating.E"], rel=1e-9)


def test_a_pattern_in_eleven_residuals_is_seen():
    """Residuals that rise all the way: 11 points, two runs."""
    radius = np.linspace(1e-7, 1e-6, 11)
    modulus = np.asarray(FILM.modulus(radius)) * np.linspace(0.95, 1.05, 11)
    result = mdi.fit(mdi.ModulusRadius(radius, modulus), mdr.Berkovich(), mdr.Homogeneous(OXIDE), ["E"])
    assert np.all(np.diff(result.residuals) > 0.0)
    assert result.pattern_probability < 1e-4
    assert result.describes_data is False
    assert "THE MODEL MISSES THE DATA" in result.summary().splitlines()[2]


def csm(area_error=0.0, noise=0.0, seed=0):
    """Dynamic nanoindentation by a tip whose true area is larger than the one of its calibration by this part."""
    tip = mdr.Berkovich()
    h_c = np.linspace(20e-9, 250e-9, 60)
    a = h_c / math.tan(tip.inclination) * math.sqrt(1.0 + area_error)
    reduced = np.asarray(mdr.Pair(FILM, mdr.Homogeneous(DIAMOND)).modulus(a))
    stiffness = 2.0 * a * reduced * (1.0 + noise * np.random.default_rng(seed).standard_normal(a.size))
    load = 9e9 * math.pi * a**2
    h_s = sink_in(mdr.Pair(FILM, DIAMOND), a) * load / stiffness
    return mdi.StiffnessDepth(h_c + h_s, load, stiffness, relative_sd=max(noise, 0.005))


def test_an_area_error_is_covered_by_its_prior():
    """The tip's area is known to 2 %: without the prior most intervals miss the truth, with it they hold it."""
    random = np.random.default_rng(5)
    free = {"coating.E": None, "substrate.E": None}
    known = {**free, "area_factor": mdi.Free(prior=(1.0, 0.02))}
    instrument = mdi.Instrument(indenter=DIAMOND)
    inside = {"ignored": 0, "known": 0}
    for seed in range(30):
        data = csm(0.02 * random.standard_normal(), 0.005, seed)
        for name, chosen in (("ignored", free), ("known", known)):
            lower, upper = mdi.fit(data, mdr.Berkovich(), FILM, chosen, instrument=instrument).interval("coating.E")
            inside[name] += lower <= OXIDE.E <= upper
    assert inside["known"] >= 25
    assert inside["ignored"] < inside["known"]


def test_an_area_factor_is_what_it_says():
    """True over assumed area: 10 % too small an area of the calibration is found where the film is known."""
    result = mdi.fit(csm(0.1), mdr.Berkovich(), FILM, ["area_factor"], instrument=mdi.Instrument(indenter=DIAMOND))
    assert result.estimates["area_factor"] == pytest.approx(1.1, rel=1e-5)


def test_an_ideal_tip_is_said_beside_the_result():
    result = mdi.fit(csm(0.0, 0.005), mdr.Berkovich(), FILM, ["coating.E"], instrument=mdi.Instrument(indenter=DIAMOND))
    assert any("ideally sharp" in words for words in result.warnings)
    tip = mdr.AreaFunction([24.5, 3e-7], max_height=1e-6)
    assert not any(
        "sharp" in w for w in mdi.fit(csm(), tip, FILM, ["coating.E"], instrument=mdi.Instrument(indenter=DIAMOND)).warnings
    )


def test_coefficients_of_an_area_function_are_found_and_carry_their_covariance():
    """A known body gives the tip back; the joint prior of its coefficients widens the interval of a film."""
    tip = mdr.AreaFunction([24.5, 3e-7], max_height=1e-6)
    h_c = np.geomspace(10e-9, 400e-9, 50)
    a = np.sqrt((24.5 * h_c**2 + 3e-7 * h_c) / np.pi)
    instrument = mdi.Instrument(indenter=DIAMOND)

    def data(medium):
        reduced = 1.0 / (1.0 / np.asarray(medium.modulus(a)) + 1.0 / DIAMOND.contact_modulus)
        stiffness, load = 2.0 * a * reduced, 9e9 * np.pi * a**2
        return mdi.StiffnessDepth(h_c + sink_in(mdr.Pair(medium, DIAMOND), a) * load / stiffness, load, stiffness, relative_sd=0.01)

    silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    begin = mdr.AreaFunction([20.0, 1e-7], max_height=1e-6)
    calibrated = mdi.fit(data(silica), begin, silica, ["indenter.C0", "indenter.C1"], instrument=instrument)
    assert calibrated.converged
    assert calibrated.estimates["indenter.C0"] == pytest.approx(24.5, rel=1e-5)
    assert calibrated.estimates["indenter.C1"] == pytest.approx(3e-7, rel=1e-4)
    prior = mdi.JointPrior(calibrated.names, tuple(calibrated.estimates.values()), calibrated.covariance)
    sharp = mdi.fit(data(FILM), tip, FILM, ["coating.E"], instrument=instrument)
    blunt = mdi.fit(data(FILM), tip, FILM, ["coating.E"], instrument=instrument, known=[prior])
    assert set(blunt.names) == {"coating.E", "indenter.C0", "indenter.C1"}
    assert blunt.standard_errors["coating.E"] > 1.04 * sharp.standard_errors["coating.E"]
    assert blunt.estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-3)
    # a joint prior of independent numbers is what two priors are
    apart = {n: mdi.Free(prior=(calibrated.estimates[n], calibrated.standard_errors[n])) for n in calibrated.names}
    variances = np.diag(np.square(list(calibrated.standard_errors.values())))
    one = mdi.fit(data(FILM), tip, FILM, {"coating.E": None, **apart}, instrument=instrument)
    joint = mdi.JointPrior(calibrated.names, tuple(calibrated.estimates.values()), variances)
    other = mdi.fit(data(FILM), tip, FILM, ["coating.E"], instrument=instrument, known=iter([joint]))
    assert other.standard_errors["coating.E"] == pytest.approx(one.standard_errors["coating.E"], rel=1e-3)
    assert other.estimates["indenter.C1"] == pytest.approx(one.estimates["indenter.C1"], rel=1e-3)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"names": ("indenter.C0", "indenter.C9")}, "C9"),
        ({"values": (1.0,)}, "shapes"),
        ({"covariance": ((1.0, 2.0), (2.0, 1.0))}, "positive definite"),
        ({"covariance": ((0.0, 0.0), (0.0, 1.0))}, "diagonal"),
    ],
)
def test_wrong_joint_priors_are_refused(change, words):
    given = {"names": ("indenter.C0", "indenter.C1"), "values": (24.5, 3e-7), "covariance": ((1.0, 0.0), (0.0, 1e-14)), **change}
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
        tip = mdr.AreaFunction([24.5, 3e-7], max_height=1e-6)
        mdi.fit(csm(), tip, FILM, ["coating.E"], known=[mdi.JointPrior(**given)])


@pytest.mark.parametrize("epsilon", [0.75, 0.0, -0.3])
def test_contact_deeper_than_the_depth(epsilon):
    """Where the surface piles up, contact begins above it: epsilon of 0 and less."""
    tip, body = mdr.Berkovich(), mdr.Homogeneous(OXIDE)
    h_c = np.linspace(20e-9, 250e-9, 30)
    stiffness = 2.0 * h_c / math.tan(tip.inclination) * OXIDE.contact_modulus
    load = 1e9 * h_c**2
    data = mdi.StiffnessDepth(h_c + epsilon * load / stiffness, load, stiffness)
    result = mdi.fit(data, tip, body, {"E": 50e9}, instrument=mdi.Instrument(contact_depth_factor=epsilon))
    assert result.estimates["E"] == pytest.approx(OXIDE.E, rel=1e-8)


def test_loubets_contact_depth():
    """h_c = 1.2 (h - P/S)."""
    tip = mdr.Berkovich()
    h_c = np.linspace(20e-9, 250e-9, 30)
    stiffness = 2.0 * h_c / math.tan(tip.inclination) * OXIDE.contact_modulus
    load = 1e9 * h_c**2
    data = mdi.StiffnessDepth(h_c / 1.2 + load / stiffness, load, stiffness)
    loubet = mdi.Instrument(contact_depth_factor=1.0, contact_depth_scale=1.2)
    assert mdi.fit(data, tip, mdr.Homogeneous(OXIDE), {"E": 50e9}, instrument=loubet).estimates["E"] == pytest.approx(OXIDE.E)


def test_practical_units_and_names():
    data = mdi.ForceDepth(DEPTH, FORCE * (1.0 + 0.01 * np.random.default_rng(1).standard_normal(60)), relative_sd=0.01)
    result = mdi.fit(data, BALL, FILM, {"coating.E": None, "thickness": mdi.Free(prior=(500e-9, 10e-9))})
    line = result.summary().splitlines()[2]
    assert "film modulus E" in line and " GPa" in line and "±" in line
    found = result.to_dict()["parameters"]
    assert found["coating.E"]["unit"] == "Pa" and found["thickness"]["unit"] == "m"
    figure = result.plot()
    assert figure.panels[0].y.title == "force [mN]"
    assert figure.panels[1].x.title == "indentation depth [nm]"
    assert "film modulus E" in figure.title


def test_a_contact_that_is_nowhere_is_named():
    """Not a ratio of 1.667054E+299."""
    data = mdi.ForceDepth(DEPTH - 1e-6, FORCE)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="no point is in contact.*depth_offset"):
        mdi.fit(data, BALL, FILM, ["coating.E"])


def test_a_contact_point_that_is_off_is_named_beside_the_units():
    data = mdi.ForceDepth(DEPTH + 100e-6, FORCE)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="depth_offset"):
        mdi.fit(data, mdr.Paraboloid(1e-3), FILM, ["coating.E"])


def test_what_the_data_do_not_determine_is_no_number():
    """A film far thinner than the contact."""
    wide = np.linspace(2e-5, 4e-5, 30)
    modulus = np.asarray(FILM.modulus(wide)) * (1.0 + 0.05 * np.random.default_rng(2).standard_normal(30))
    result = mdi.fit(mdi.ModulusRadius(wide, modulus, relative_sd=0.05), mdr.Berkovich(), FILM, ["coating.E"])
    assert result.at_bound["coating.E"] or "not determined" in result.summary() or result.standard_errors["coating.E"] < OXIDE.E


def test_a_over_h_is_that_of_the_film():
    """Not of all layers together."""
    stack = mdr.Layered([(OXIDE, 100e-9), (SILICON, 900e-9)], OXIDE, "exact")
    radius = np.linspace(1e-6, 2e-6, 20)
    data = mdi.ModulusRadius(radius, np.asarray(stack.modulus(radius)), relative_sd=0.2)
    words = " ".join(mdi.fit(data, mdr.Berkovich(), stack, ["layers[0].E"]).warnings)
    assert "a/h runs from 10 to 20" in words


def test_the_ranking_marks_models_that_are_wrong_at_these_contacts():
    """The error is that of the accuracy map, at the contact radii of the data."""
    ranking = mdi.compare_models(mdi.ForceDepth(DEPTH, FORCE), BALL, FILM, ["coating.E"], models=["exact", "gao", "gao-series"])
    entries = {entry.model: entry for entry in ranking.models}
    assert entries["exact"].error == 0.0 and not entries["exact"].is_wrong
    a = np.asarray(mdr.Contact(BALL, FILM).at_depth(DEPTH).radius)
    error = np.asarray(FILM.with_model("gao").modulus(a)) / np.asarray(FILM.modulus(a)) - 1.0
    assert entries["gao"].error == pytest.approx(error[np.argmax(np.abs(error))], abs=2e-3)
    assert entries["gao"].is_wrong
    text = ranking.summary()
    assert "WRONG HERE" in next(line for line in text.splitlines() if line.startswith("gao "))
    assert "not the correct model" in text and "GPa" in text


def test_priors_leave_the_correlation_to_be_seen():
    """Ten points and six parameters, five of them known beforehand to parts in a million: the widening is that of one parameter."""
    radius = np.linspace(1e-7, 5e-7, 10)
    noise = 0.02 * autoregression(np.random.default_rng(4), 10, 0.95)
    data = mdi.ModulusRadius(radius, np.asarray(FILM.modulus(radius)) * (1.0 + noise), relative_sd=0.02)
    values = {"thickness": 500e-9, "coating.nu": OXIDE.nu, "substrate.E": SILICON.E, "substrate.nu": SILICON.nu, "area_factor": 1.0}
    known = {name: mdi.Free(prior=(value, 1e-6 * value)) for name, value in values.items()}
    alone = mdi.fit(data, mdr.Berkovich(), FILM, ["coating.E"])
    beside = mdi.fit(data, mdr.Berkovich(), FILM, {"coating.E": None, **known})
    assert alone.widening["coating.E"] > 1.2
    assert beside.widening["coating.E"] == pytest.approx(alone.widening["coating.E"], rel=0.02)


def test_the_end_of_a_search_is_not_called_a_bound_of_the_user():
    """A bound of one's own is called that; what ends where nothing was given is the end of the search."""
    free = {"coating.E": mdi.Free(60e9, upper=65e9)}
    result = mdi.fit(mdi.ForceDepth(DEPTH, FORCE, relative_sd=0.01), BALL, FILM, free)
    assert "at its upper bound" in result.doubts("coating.E")
    result = mdi.fit(mdi.ForceDepth(DEPTH, FORCE, relative_sd=0.01), BALL, FILM, ["coating.E"])
    result.at_bound["coating.E"] = 1
    assert any("end of its range" in words for words in result.doubts("coating.E"))


def test_data_that_contradict_a_prior_end_the_search():
    """Loads a hundred times too large for the film: the thickness once ran to atoms, where the exact model took minutes."""
    film = mdr.Coated(mdr.Elastic(60e9, 0.17), 500e-9, mdr.Elastic(163e9, 0.22))
    depth = np.linspace(3e-9, 17e-9, 40)
    data = mdi.ForceDepth(depth, 0.03 + 4.0 * 1e6 * depth, relative_sd=0.01)
    free = {"coating.E": mdi.Free(60e9, upper=4.86e14), "thickness": mdi.Free(prior=(500e-9, 10e-9))}
    result = mdi.fit(data, mdr.Sphere(10e-6), film, free)
    assert result.at_bound["thickness"] == 1
    assert result.estimates["thickness"] == pytest.approx(700e-9)
    assert "20 standard deviations from its prior" in result.summary()


@pytest.mark.parametrize("factor", [1e-2, 1e4, 1e6])
def test_a_start_far_away_gives_the_same_answer(factor):
    """A search that ends at the end of what it tries around its start goes on from there."""
    noise = 1.0 + 0.01 * np.random.default_rng(0).standard_normal(DEPTH.size)
    data = mdi.ForceDepth(DEPTH, FORCE * noise, relative_sd=0.01)
    near = mdi.fit(data, BALL, FILM, ["coating.E", "substrate.E"])
    far = mdi.fit(data, BALL, FILM.replace(coating=mdr.Elastic(OXIDE.E * factor, OXIDE.nu)), ["coating.E", "substrate.E"])
    assert near.converged and far.converged
    for name in near.names:
        assert far.estimates[name] == pytest.approx(near.estimates[name], rel=1e-3)


def test_a_parameter_without_an_optimum_has_not_converged():
    """The modulus of a base that nothing reaches: where its search ended says nothing about it, and no number is given."""
    depth = DEPTH / 100.0
    rigid = np.asarray(mdr.Contact(BALL, mdr.Coated(OXIDE, 500e-9, mdr.RIGID)).at_depth(DEPTH).force)
    with pytest.raises(
        mdr.errors.InvalidArgumentError, match=r"substrate.E: it must not be free, because the readings do not depend on it"
    ):
        mdi.fit(mdi.ForceDepth(DEPTH, rigid), BALL, FILM, ["substrate.E"])
    far = mdi.fit(mdi.ForceDepth(depth, np.asarray(mdr.Contact(BALL, FILM).at_depth(depth).force)), BALL, FILM, ["substrate.E"])
    assert far.estimates["substrate.E"] == pytest.approx(SILICON.E, rel=1e-3) or not far.converged


@pytest.mark.parametrize("options", [{"relative_sd": 1e-300}, {"sd": 1e-20}, {"sd": [1.0, 1e-30, 1.0]}])
def test_errors_finer_than_the_readings_are_refused(options):
    """The squares of the weights would leave the number range: intervals were (nan, nan)."""
    with pytest.raises(mdr.errors.InvalidArgumentError, match="is that fine"):
        mdi.ForceDepth([1.0, 2.0, 3.0], [1.0, 2.8, 5.2], **options)
    mdi.ForceDepth([1.0, 2.0, 3.0], [0.0, 2.8, 5.2], sd=1e-10)


@pytest.mark.parametrize(
    "tip",
    [mdr.Berkovich(), mdr.AreaFunction([24.5], max_height=1e-6), mdr.AreaFunction([24.5, 0.0, 0.0], max_height=1e-6)],
)
def test_tips_that_are_sharp_to_the_apex_are_ideal(tip):
    """An area function of C0 alone is a cone, whatever it is called."""
    words = " ".join(mdi.fit(csm(), tip, FILM, ["coating.E"]).warnings)
    assert "ideally sharp" in words
    blunt = mdr.AreaFunction([24.5, 3e-7], max_height=1e-6)
    assert "ideally sharp" not in " ".join(mdi.fit(csm(), blunt, FILM, ["coating.E"]).warnings)


@pytest.mark.parametrize("factor", [1.0, 1.3])
def test_branches_that_differ_are_named(factor):
    """Approach and retract in one fit without adhesion: the cause is said, with its size."""
    data = mdi.ForceDepth(np.r_[DEPTH, DEPTH[::-1]], np.r_[FORCE, factor * FORCE[::-1]])
    words = [words for words in mdi.fit(data, BALL, FILM, ["coating.E"]).warnings if "loading and unloading differ" in words]
    assert len(words) == (factor > 1.0)
