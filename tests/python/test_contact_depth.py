# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact depths of coated bodies: the surface sinks in as far as the exact contact says, not as that of a half-space."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from conftest import OXIDE, ROOT, SILICON
from records import sink_in

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main

GLASS, STEEL, POLYMER = mdr.Elastic(70e9, 0.22), mdr.Elastic(210e9, 0.3), mdr.Elastic(3e9, 0.4)
DIAMOND = mdr.Elastic(1141e9, 0.07)
THICKNESS = 500e-9
FILMS = {
    "oxide on Si": mdr.Coated(OXIDE, THICKNESS, SILICON),
    "polymer on Si": mdr.Coated(POLYMER, THICKNESS, SILICON),
    "W on glass": mdr.Coated(mdr.Elastic(410e9, 0.28), THICKNESS, GLASS),
    "TiN on steel": mdr.Coated(mdr.Elastic(450e9, 0.25), THICKNESS, STEEL),
    "polymer on glass": mdr.Coated(POLYMER, THICKNESS, GLASS),
    "Al on Si": mdr.Coated(mdr.Elastic(70e9, 0.35), THICKNESS, SILICON),
}
TIPS = {
    "paraboloid": mdr.Paraboloid(5e-6),
    "sphere": mdr.Sphere(1e-6),
    "Berkovich": mdr.Berkovich(),
    "area function": mdr.AreaFunction([24.5, 3e-7], max_height=1e-6),
    "rounded cone": mdr.RoundedCone(1e-7, mdr.Berkovich().inclination),
}
DEPTHS = np.linspace(0.04, 0.3, 30) * THICKNESS


def elastic(film, tip, noise=0.0, seed=0, **options):
    """What the library's own contact reads at depths of 0.04 to 0.3 h."""
    states = mdr.Contact(tip, film).at_depth(DEPTHS)
    read = np.asarray(states.stiffness) * (1.0 + noise * np.random.default_rng(seed).standard_normal(len(DEPTHS)))
    return mdi.StiffnessDepth(DEPTHS, states.force, read, relative_sd=noise or 0.01, **options)


def yielded(film, tip, hardness=9e9, body=None):
    """Readings of an indent that has yielded: f(a) is the contact depth, and a paraboloid's sink-in comes on top."""
    body = body or film
    a = np.geomspace(60e-9, 500e-9, 30)
    load, stiffness = hardness * np.pi * a**2, 2.0 * a * np.asarray(body.modulus(a))
    depth = tip.height(a) + sink_in(body, a) * load / stiffness
    return a, mdi.StiffnessDepth(depth, load, stiffness, relative_sd=0.01, elastic=False)


def start(film):
    return {"coating.E": 0.8 * film.coating.E}


@pytest.mark.parametrize("tip", TIPS)
@pytest.mark.parametrize("film", FILMS)
def test_moduli_of_the_library_s_own_curves(film, tip):
    body = FILMS[film]
    data = elastic(body, TIPS[tip])
    result = mdi.fit(data, TIPS[tip], body, start(body))
    assert result.estimates["coating.E"] == pytest.approx(body.coating.E, rel=1e-6)
    radius = result.problem.predict(result._values)[1]
    assert radius == pytest.approx(mdr.Contact(TIPS[tip], body).at_depth(DEPTHS).radius, rel=1e-6)


@pytest.mark.parametrize("film", FILMS)
def test_intervals_hold_the_modulus(film):
    """Of 20 intervals of 95 % fewer than 16 would hold it with a probability of 3e-3."""
    body, tip = FILMS[film], TIPS["area function"]
    inside = 0
    for seed in range(20):
        lower, upper = mdi.fit(elastic(body, tip, 0.01, seed), tip, body, start(body)).interval("coating.E")
        inside += lower <= body.coating.E <= upper
    assert inside >= 16


@pytest.mark.parametrize("tip", TIPS)
@pytest.mark.parametrize("film", FILMS)
def test_moduli_of_indents_that_have_yielded(film, tip):
    body = FILMS[film]
    pair = mdr.Pair(body, DIAMOND)
    a, data = yielded(body, TIPS[tip], 0.02 * body.coating.E, pair)
    result = mdi.fit(data, TIPS[tip], pair, start(body))
    assert result.estimates["coating.E"] == pytest.approx(body.coating.E, rel=1e-6)
    assert result.problem.predict(result._values)[1] == pytest.approx(a, rel=1e-6)


@pytest.mark.parametrize("factor", [-0.3, 0.0, 0.5, 0.7268, 0.75, 0.8, 0.87, 0.95, 1.0])
def test_a_film_of_its_substrate_is_oliver_and_pharr(factor):
    """The half-space: h_c = h - epsilon P/S for any epsilon, whichever way it is computed."""
    same = mdr.Coated(OXIDE, THICKNESS, OXIDE)
    tip, a = TIPS["Berkovich"], np.linspace(50e-9, 600e-9, 20)
    load, stiffness = 5e9 * np.pi * a**2, 2.0 * a * OXIDE.contact_modulus
    data = mdi.StiffnessDepth(tip.height(a) + factor * load / stiffness, load, stiffness)
    tool = mdi.Instrument(contact_depth_factor=factor)
    for body in (same, mdr.Homogeneous(OXIDE)):
        result = mdi.fit(data, tip, body, ["area_factor"], instrument=tool)
        assert result.estimates["area_factor"] == pytest.approx(1.0, rel=1e-7)


@pytest.mark.parametrize("exponent", [1.0, 2.0, 5.0, math.inf])
def test_epsilon_is_an_indenter(exponent):
    """The contact radius under the epsilon of c r^n is where the sink-in of c r^n leaves the depth; a punch's is the tangent's."""
    body, tip = FILMS["polymer on Si"], TIPS["Berkovich"]
    a = np.array([1e-7, 3e-7, 8e-7])
    factor = sigma = 1.0
    if exponent < math.inf:
        shape = mdr.PowerLaw(exponent, 1e-9 / 1e-6**exponent)
        factor, sigma = (
            (state.depth - shape.height(a)) * state.stiffness / state.force
            for state in (mdr.Contact(shape, m).at_radius(a) for m in (mdr.Homogeneous(POLYMER), body))
        )
        factor = float(factor[0])
    load, stiffness = 1e8 * np.pi * a**2, np.asarray(body.stiffness(a))
    data = mdi.StiffnessDepth(tip.height(a) + sigma * load / stiffness, load, stiffness, sd=1.0)
    result = mdi.fit(data, tip, body, start(body), instrument=mdi.Instrument(contact_depth_factor=factor))
    assert result.estimates["coating.E"] == pytest.approx(POLYMER.E, rel=1e-6)


def test_models_have_their_own_contact():
    """Curves of an approximate model give its modulus back: the sink-in is that of the model's contact."""
    for model in ("gao", "doerner-nix"):
        body = FILMS["oxide on Si"].with_model(model)
        result = mdi.fit(elastic(body, TIPS["sphere"]), TIPS["sphere"], body, start(body))
        assert result.estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-5)


def test_whether_a_contact_is_elastic_is_seen_whatever_frame_and_offsets_are():
    body, tip = FILMS["oxide on Si"], TIPS["Berkovich"]
    states = mdr.Contact(tip, body).at_depth(DEPTHS)
    load, frame = np.asarray(states.force), 1e-7
    read = 1.0 / (1.0 / np.asarray(states.stiffness) + frame)
    data = mdi.StiffnessDepth(DEPTHS + frame * load + 3e-9, load + 1e-6, read, relative_sd=0.01)
    assert data.seems_elastic
    tool = mdi.Instrument(frame_compliance=frame, depth_offset=3e-9, force_offset=1e-6)
    assert mdi.fit(data, tip, body, start(body), instrument=tool).estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-6)


def test_what_the_caller_says_of_the_contact_counts():
    body, tip = FILMS["oxide on Si"], TIPS["Berkovich"]
    free = start(body)
    found = {e: mdi.fit(elastic(body, tip, elastic=e), tip, body, free).estimates["coating.E"] for e in (None, True, False)}
    assert found[None] == found[True] == pytest.approx(OXIDE.E, rel=1e-6)
    assert 1.01 < found[False] / OXIDE.E < 1.04, "a paraboloid's epsilon for the cone's"
    cone = mdi.Instrument(contact_depth_factor=2.0 * (math.pi - 2.0) / math.pi)
    assert mdi.fit(elastic(body, tip), tip, body, free, instrument=cone).estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-6)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="contact_depth_factor: with elastic = True"):
        mdi.fit(elastic(body, tip, elastic=True), tip, body, free, instrument=cone)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="elastic = 1:"):
        elastic(body, tip, elastic=1)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda h, p, s: (h, 30.0 * p, s), "must be greater than 0"),
        (lambda h, p, s: (8.0 * h, p, s), "beyond the end of the indenter"),
    ],
)
def test_readings_without_a_contact_radius_are_refused(change, words):
    body, tip = FILMS["oxide on Si"], mdr.AreaFunction([24.5], max_height=600e-9)
    _, data = yielded(body, tip)
    with pytest.raises(mdr.errors.DomainError, match=words):
        mdi.fit(mdi.StiffnessDepth(*change(data.x, data.force, data.y)), tip, body, ["coating.E"], check_units=False)


def record(film, tip, left=0.0):
    """Loading and unloading of the library's own contact; `left` of the largest depth stays when the force is gone."""
    states = mdr.Contact(tip, film).at_depth(np.linspace(1e-3, 0.3, 300) * THICKNESS)
    depth, force = np.asarray(states.depth), np.asarray(states.force)
    back = left * depth[-1] + (1.0 - left) * depth[::-1]
    return np.concatenate([depth, back]), np.concatenate([force, force[::-1]])


@pytest.mark.parametrize("tip", TIPS)
@pytest.mark.parametrize("film", FILMS)
def test_elastic_unloading_curves(film, tip):
    """To 1 %: on a film the curve is no power law, and the slope of the one that is fitted not quite that of the contact."""
    body = FILMS[film]
    data = mdi.Unloading(*record(body, TIPS[tip]))
    assert data.seems_elastic
    result = mdi.fit(data, TIPS[tip], body, start(body))
    assert result.estimates["coating.E"] == pytest.approx(body.coating.E, rel=0.01)


def test_an_unloading_curve_that_leaves_depth_behind_is_not_elastic():
    body, tip = FILMS["oxide on Si"], TIPS["Berkovich"]
    h, p = record(body, tip, 0.3)
    assert not mdi.Unloading(h, p).seems_elastic
    assert not mdi.Unloading(h[300:], p[300:]).seems_elastic, "without loading it is not known"
    assert mdi.Unloading(h, p, elastic=True).elastic


def test_contact_depth_and_area_on_the_body():
    """On the body that is fitted Oliver and Pharr's area is that of the contact; on a half-space it is not."""
    body, tip = FILMS["W on glass"], TIPS["area function"]
    a, data = yielded(body, tip)
    film, half_space = mdi.oliver_pharr(data, tip, medium=body), mdi.oliver_pharr(data, tip)
    assert film.radius == pytest.approx(a, rel=1e-6)
    assert film.contact_depth == pytest.approx(tip.height(a), rel=1e-6)
    assert film.hardness == pytest.approx(np.full(len(a), 9e9), rel=1e-5)
    assert film.reduced_modulus == pytest.approx(body.modulus(a), rel=1e-6)
    assert half_space.contact_depth == pytest.approx(data.x - 0.75 * data.force / data.y, rel=1e-12)
    assert np.all(half_space.hardness[-5:] < 0.95 * 9e9), "a stiff film sinks in more deeply"
    pair = mdr.Pair(body, DIAMOND)
    both = [mdi.oliver_pharr(data, tip, mdi.Instrument(indenter=DIAMOND), medium=m) for m in (pair, body)]
    assert both[0].radius == pytest.approx(both[1].radius, rel=1e-12)


def test_moduli_at_every_depth():
    """Each point alone gives the modulus, of elastic curves and of indents that have yielded; so does the line through them."""
    body, tip = FILMS["polymer on Si"], TIPS["area function"]
    a, indents = yielded(body, tip, 6e7)
    for data, radius in ((elastic(body, tip), mdr.Contact(tip, body).at_depth(DEPTHS).radius), (indents, a)):
        found = mdi.modulus_at_depths(data, tip, body, start(body))
        assert found.modulus == pytest.approx(np.full(len(data), POLYMER.E), rel=1e-6)
        assert found.analysis.radius == pytest.approx(radius, rel=1e-6)
        assert not found.warnings


def test_a_problem_file_says_whether_it_is_elastic(tmp_path, capsys):
    """[data] elastic = false takes the half-space's epsilon for a curve that looks elastic."""
    body, tip = FILMS["oxide on Si"], TIPS["Berkovich"]
    data = elastic(body, tip)
    table = np.column_stack([1e9 * data.x, 1e3 * data.force, data.y])
    np.savetxt(tmp_path / "csm.csv", table, header="h_nm,P_mN,S_N_per_m", comments="", delimiter=",")
    text = (ROOT / "examples" / "fit" / "csm_on_oxide.toml").read_text()
    text = text.replace("[instrument]", "[none]").replace('indenter = { E = "1141 GPa", nu = 0.07 }', "").replace("[none]\n", "")
    found = {}
    for said in ("", "elastic = true\n", "elastic = false\n"):
        (tmp_path / "p.toml").write_text(text.replace("relative_sd", f"{said}relative_sd"))
        done = main(
            ["fit", str(tmp_path / "csm.csv"), "--problem", str(tmp_path / "p.toml"), "--json", str(tmp_path / f"{said[:12]}.json")]
        )
        assert done == 0
        found[said] = json.loads((tmp_path / f"{said[:12]}.json").read_text())["parameters"]["coating.E"]["value"]
        capsys.readouterr()
    assert found[""] == found["elastic = true\n"] == pytest.approx(OXIDE.E, rel=1e-5)
    assert found["elastic = false\n"] > 1.01 * OXIDE.E


def test_the_summary_says_how_far_the_surface_sinks_in():
    body, tip = FILMS["polymer on Si"], TIPS["area function"]
    a, indents = yielded(body, tip, 2e8)
    result = mdi.fit(indents, tip, body, start(body))
    ends = sink_in(body, a[[-1, 0]])
    assert f"sinks in by {ends[0]:.3g} to {ends[1]:.3g} P/S under the indent, 0.75 on a half-space" in result.summary()
    assert "sinks in by" in result.report()
    assert "under the indenter itself" in mdi.fit(elastic(body, tip), tip, body, start(body)).summary()
    half_space = mdi.fit(indents, tip, mdr.Homogeneous(POLYMER), ["E"])
    assert "sinks in by 0.75 P/S" in half_space.summary()


def test_plastic_contacts_are_told_what_piles_up():
    body, tip = FILMS["Al on Si"], TIPS["area function"]
    said = {}
    for hardness in (0.5e9, 5e9):
        _, data = yielded(body, tip, hardness)
        result = mdi.fit(data, tip, body, start(body))
        said[hardness] = [words for words in result.warnings if "pile up" in words]
        assert not [w for w in mdi.fit(data, tip, body, [*start(body), "area_factor"]).warnings if "pile up" in w]
    assert said[5e9] == []
    assert "modulus up to 26 % too high" in said[0.5e9][0]


def test_readings_beyond_an_elastic_contact_are_answered_or_refused():
    """Forces above those of an elastic contact leave hardly any contact depth: a modulus, or the reason why there is none."""
    body, tip = FILMS["oxide on Si"], TIPS["paraboloid"]
    _, data = yielded(body, tip)
    for seed in range(40):
        noisy = data.with_y(data.y * (1.0 + 0.01 * np.random.default_rng(seed).standard_normal(len(data))))
        try:
            assert mdi.fit(noisy, tip, body, start(body)).estimates["coating.E"] > 0.0
        except mdr.MDRError as refusal:
            assert "no root" not in str(refusal)
            assert "contact depth at depth" in str(refusal)
