# SPDX-License-Identifier: GPL-3.0-or-later
"""Oliver and Pharr's analysis of unloading curves, and film moduli from it."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import OXIDE, SILICON
from records import HARDNESS, REDUCED, indentation, sink_in

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.records import Segment

TIP = mdr.AreaFunction([24.5], max_height=1e-6)
DIAMOND = mdr.Elastic(1141e9, 0.07)


def test_stiffness_area_modulus_and_hardness_of_a_known_curve():
    """Without noise the numbers are those the curve was made of."""
    _, h, p, truth = indentation(noise=0.0, points=(600, 100, 2000, 80, 20))
    data = mdi.Unloading(h, p)
    (point,) = data.unloadings
    assert point.stiffness == pytest.approx(truth["stiffness"], rel=2e-3)
    assert point.exponent == pytest.approx(1.4, rel=0.02)
    assert point.depth == pytest.approx(truth["depth"], rel=1e-3)
    found = mdi.oliver_pharr(data, TIP)
    assert found.contact_depth[0] == pytest.approx(truth["contact_depth"], rel=2e-3)
    assert found.area[0] == pytest.approx(truth["area"], rel=4e-3)
    assert found.reduced_modulus[0] == pytest.approx(REDUCED, rel=2e-3)
    assert found.hardness[0] == pytest.approx(HARDNESS, rel=4e-3)


def test_standard_errors_are_the_scatter():
    """Over 40 records the deviations in standard errors have a spread of 1; 0.7 and 1.4 are its bounds with a probability of
    0.999."""
    scores = []
    for seed in range(40):
        _, h, p, truth = indentation(seed=seed, noise=5e-6)
        (point,) = mdi.Unloading(h, p).unloadings
        scores.append((point.stiffness - truth["stiffness"]) / point.stiffness_error)
    assert 0.6 < np.std(scores) < 1.4 and abs(np.mean(scores)) < 0.6


def test_the_error_of_the_tip_is_half_in_the_modulus_and_all_in_the_hardness():
    _, h, p, _ = indentation()
    data = mdi.Unloading(h, p)
    sharp, vague = mdi.oliver_pharr(data, TIP), mdi.oliver_pharr(data, TIP, area_sd=0.02)
    added = np.sqrt(vague.reduced_modulus_error**2 - sharp.reduced_modulus_error**2) / sharp.reduced_modulus
    assert added == pytest.approx(0.01, rel=1e-6)
    added = np.sqrt(vague.hardness_error**2 - sharp.hardness_error**2) / sharp.hardness
    assert added == pytest.approx(0.02, rel=1e-6)


def test_loubet_and_pile_up():
    """Loubet: h_c = 1.2 (h - P/S); epsilon < 0: the contact is deeper than the depth."""
    data = mdi.StiffnessDepth([300e-9], [10e-3], [86e3], relative_sd=0.01)
    elastic = 10e-3 / 86e3
    for scale, epsilon in ((1.2, 1.0), (1.0, 0.0), (1.0, -0.3)):
        chosen = mdi.Instrument(contact_depth_scale=scale, contact_depth_factor=epsilon)
        found = mdi.oliver_pharr(data, TIP, chosen)
        assert found.contact_depth[0] == pytest.approx(scale * (300e-9 - epsilon * elastic), rel=1e-12)
        assert found.area[0] == pytest.approx(24.5 * found.contact_depth[0] ** 2, rel=1e-9)


def test_the_stiffness_factor_divides_the_modulus():
    """E_r = S/(2 beta a) at the same contact radius."""
    data = mdi.StiffnessDepth([300e-9], [10e-3], [86e3], relative_sd=0.01)
    one, two = mdi.oliver_pharr(data, TIP), mdi.oliver_pharr(data, TIP, mdi.Instrument(stiffness_factor=1.05))
    assert two.area[0] == pytest.approx(one.area[0], rel=1e-12)
    assert one.reduced_modulus[0] == pytest.approx(86e3 / (2.0 * np.sqrt(one.area[0] / np.pi)), rel=1e-12)
    assert two.reduced_modulus[0] == pytest.approx(one.reduced_modulus[0] / 1.05, rel=1e-12)


def test_frame_compliance_is_taken_off():
    frame = 1e-7
    bare = mdi.StiffnessDepth([300e-9], [10e-3], [86e3], relative_sd=0.01)
    read = mdi.StiffnessDepth([300e-9 + frame * 10e-3], [10e-3], [1.0 / (1.0 / 86e3 + frame)], relative_sd=0.01)
    one, two = mdi.oliver_pharr(bare, TIP), mdi.oliver_pharr(read, TIP, mdi.Instrument(frame_compliance=frame))
    for name in ("stiffness", "contact_depth", "area", "reduced_modulus", "hardness"):
        assert getattr(two, name) == pytest.approx(getattr(one, name), rel=1e-10)


def test_film_modulus_by_the_exact_pair():
    """Stiffnesses of the exact contact of film and diamond at three depths give the film back; one point is enough with priors."""
    film = mdr.Coated(OXIDE, 500e-9, SILICON)
    a = np.array([1e-7, 2e-7, 4e-7])
    stiffness = 2.0 * a * np.asarray(mdr.Pair(film, DIAMOND).modulus(a))
    force = 9e9 * np.pi * a**2
    depth = np.sqrt(np.pi * a**2 / 24.5) + sink_in(mdr.Pair(film, DIAMOND), a) * force / stiffness
    start = film.replace(coating=mdr.Elastic(60e9, OXIDE.nu))
    tool = mdi.Instrument(indenter=DIAMOND)
    for part in (slice(0, 1), slice(0, 3)):
        data = mdi.StiffnessDepth(depth[part], force[part], stiffness[part], relative_sd=0.01)
        known = {"coating.E": None, "area_factor": mdi.Free(prior=(1.0, 0.02))}
        result = mdi.fit(data, TIP, start, known, instrument=tool)
        assert result.estimates["coating.E"] == pytest.approx(OXIDE.E, rel=1e-5)
        assert result.standard_errors["coating.E"] > 0.01 * OXIDE.E, "2 % of area are more than 1 % of the modulus"
        assert not any("trade off" in words for words in result.warnings), "a prior is no fault of the data"


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda h, p: (h[:300], p[:300]), "no unloading"),
        (lambda h, p: (h[:402], p[:402]), "no unloading|too few points"),
        (lambda h, p: (h, -p), "no unloading|not positive"),
        (lambda h, p: (h[::40], p[::40]), "too few points"),
        (lambda h, p: (np.where(np.arange(len(h)) > 300, np.nan, h), p), "finite"),
        (lambda h, p: (h, np.zeros_like(p)), "no curve"),
    ],
)
def test_what_is_no_unloading_is_refused(change, words):
    _, h, p, _ = indentation()
    with pytest.raises(mdr.MDRError, match=words):
        mdi.Unloading(*change(h, p))


def test_creep_that_is_stronger_than_the_unloading_is_told():
    _, h, p, _ = indentation(drift=12e-9)
    with pytest.raises(mdr.MDRError, match="creep or drift|no unloading"):
        mdi.Unloading(h[:600], p[:600])


PROBLEM = """
title = "Unloading"
[indenter]
shape = "area-function"
coefficients = [24.5]
length_unit = "nm"
max_height = "1 um"
[medium]
type = "homogeneous"
material = { E = "60 GPa", nu = 0.17 }
[instrument]
indenter = { E = "1141 GPa", nu = 0.07 }
[data]
kind = "unloading"
drift = "hold"
[fit.free]
E = {}
area_factor = { prior = 1.0, prior_sd = 0.02 }
"""


def test_command_line_with_drift_picture_and_report(tmp_path, capsys):
    (tmp_path / "problem.toml").write_text(PROBLEM)
    time, h, p, _ = indentation(drift=0.05e-9)
    table = np.column_stack([time, 1e9 * h, 1e3 * p])
    np.savetxt(tmp_path / "curve.txt", table, header="Time (s)\tDepth (nm)\tLoad (mN)", comments="", delimiter="\t")
    written = {kind: tmp_path / f"fit.{kind}" for kind in ("json", "csv", "png", "html")}
    options = [f"--{option}={written[kind]}" for option, kind in (("json", "json"), ("csv", "csv"), ("plot", "png"))]
    data, problem = str(tmp_path / "curve.txt"), str(tmp_path / "problem.toml")
    assert main(["fit", data, "--problem", problem, *options, f"--report={written['html']}"]) == 0
    out = capsys.readouterr().out
    assert "drift" in out and "hardness [GPa]" in out
    entry = json.loads(written["json"].read_text())["parameters"]["E"]
    true = (1.0 - 0.17**2) / (1.0 / REDUCED - 1.0 / DIAMOND.contact_modulus)
    assert abs(entry["value"] - true) < 2.5 * entry["standard_error"]
    assert written["csv"].read_text().startswith("depth [nm],force [mN],stiffness [kN/m],standard error [kN/m],contact depth")
    page = written["html"].read_text(encoding="utf-8")
    assert "data:image/png;base64," in page and "modulus E (E)" in page and "mdrcontact 0." in page
    assert "http" not in page.replace("data:image/png;base64,", ""), "nothing is fetched"
    assert "src=" in page and page.count("src=") == page.count("data:image")


def test_a_record_says_where_its_depths_begin_and_in_which_order_it_was_measured():
    _, h, p, _ = indentation(5e-3, noise=1e-6)
    assert not mdi.Unloading(h, p).warnings
    for shift in (-0.15, 0.15):
        assert any("not at 0" in words for words in mdi.Unloading(h + shift * h.max(), p).warnings)
    assert any("reverse order" in words for words in mdi.Unloading(h[::-1], p[::-1]).warnings)
    top = int(np.argmax(h))
    assert mdi.Unloading(h[top:], p[top:]).warnings[0].startswith("the record begins with unloading")


PARTS = [Segment("loading", 0, 60), Segment("unloading", 60, 110)]
CYCLES = """
[indenter]
shape = "area-function"
coefficients = [24.5]
length_unit = "nm"
max_height = "2 um"
[medium]
type = "homogeneous"
material = { E = "70 GPa", nu = 0.2 }
[data]
kind = "unloading"
contact_point = "piecewise"
[fit]
free = ["E"]
"""


def cycles(loads, hold, noise, points=60):
    """A record of load cycles into a plastic body, each to half of its force: depth and force."""
    depth, force = [], []
    start = 0.0
    for load in loads:
        deepest = np.sqrt(load)
        up = np.linspace(start, load, points)[1:]
        down = np.linspace(load, 0.5 * load, points)[1:]
        force += [up, np.full(hold, load), down]
        # elastic as P = B (h - h_f)^1.5 until the depth of the cycle before
        final = 0.7 * deepest
        depth += [np.maximum(np.sqrt(up), depth[-1][-1] if depth else 0.0), np.full(hold, deepest)]
        depth += [final + (deepest - final) * (down / load) ** (1.0 / 1.5)]
        start = 0.5 * load
    random = np.random.default_rng(1)
    h, p = np.concatenate(depth), np.concatenate(force)
    scale = np.array([h.max(), p.max()])
    h, p = (v + noise * s * random.standard_normal(len(v)) for v, s in zip((h, p), scale, strict=True))
    return h / scale[0] * 1e-6, p / scale[1] * 50e-3


@pytest.mark.parametrize("hold", [0, 30])
def test_every_cycle_of_a_record_counts(hold):
    loads = 2.0 ** np.arange(10)
    data = mdi.Unloading(*cycles(loads, hold, 5e-5))
    assert data.found_and_used() == ["10 unloadings, 10 used"]
    forces = [q.force for q in data.unloadings]
    assert forces == pytest.approx(50e-3 * loads / loads[-1], rel=5e-3, abs=20e-6)


def test_a_hold_in_which_the_depth_goes_up_and_down_is_no_unloading():
    h, p = cycles(2.0 ** np.arange(10), 60, 5e-5)
    held = np.flatnonzero(np.abs(p - 0.125 * 50e-3) < 10e-6)
    held = held[np.argmax(np.diff(held) == 1) :][:60]
    wave = np.sin(np.linspace(0.0, 2.0 * np.pi, len(held)))
    h[held] += 0.4e-9 * wave
    p[held] += 8e-6 * wave
    assert mdi.Unloading(h, p).found_and_used() == ["10 unloadings, 10 used"]


def test_depths_of_cycles_begin_where_the_first_loading_does(tmp_path):
    """Later cycles lie on other curves, and a contact point sought among them came out deeper than the first cycle."""
    h, p = cycles(2.0 ** np.arange(8), 30, 1e-6)
    away = np.linspace(-80e-9, 0.0, 60)
    np.savetxt(
        tmp_path / "cycles.txt",
        np.column_stack([1e9 * (np.concatenate([away, h]) + 200e-9), 1e3 * np.concatenate([0.0 * away, p])]),
        header="depth [nm]\tload [mN]",
        comments="",
        delimiter="\t",
    )
    (tmp_path / "p.toml").write_text(CYCLES)
    ((_, data, notes),) = [(one.name, *one.read()) for one in load_fit_file(tmp_path / "p.toml").curves(tmp_path / "cycles.txt")]
    assert "8 unloadings, 8 used" in notes
    assert data.x == pytest.approx([q.depth for q in mdi.Unloading(h, p).unloadings], abs=0.02 * h[60])


def test_an_unloading_that_says_nothing_is_counted_with_its_reason():
    h, p = cycles([1.0, 4.0, 16.0], 30, 1e-6)
    # of the second unloading three readings are left
    second = np.flatnonzero((p < 0.2499 * 50e-3) & (p > 0.126 * 50e-3) & (h < h.max() / 1.99))
    second = second[second > 120][:-3]
    data = mdi.Unloading(np.delete(h, second), np.delete(p, second))
    assert data.found_and_used()[0] == "3 unloadings, 2 used"
    assert "too few points" in data.found_and_used()[1]


@pytest.mark.parametrize("noise", [0.005, 0.02])
def test_short_and_nearly_straight_unloadings_are_all_taken(noise):
    """25 readings of the power 1.15: a third of them was refused, and the stiffness of the others 6.6 % too large in the mean."""
    stiffness, scores = [], []
    truth = 1.15 * 10e-3 / 60e-9
    for seed in range(200):
        random = np.random.default_rng(seed)
        h, p = np.linspace(0.0, 300e-9, 60), 10e-3 * np.linspace(0.0, 1.0, 60) ** 2
        force = np.linspace(1.0, 0.0, 25)
        h, p = (
            np.r_[h, 240e-9 + 60e-9 * force ** (1.0 / 1.15)],
            np.r_[p, 10e-3 * force] + noise * 10e-3 * random.standard_normal(85),
        )
        (point,) = mdi.Unloading(h, p, segments=[Segment("loading", 0, 60), Segment("unloading", 60, 85)]).unloadings
        stiffness.append(point.stiffness / truth)
        scores.append((point.stiffness - truth) / point.stiffness_error)
    assert np.mean(stiffness) == pytest.approx(1.0, abs=0.02)
    assert 0.8 < np.std(scores) < 1.2


def test_an_unloading_that_determines_nothing_is_refused_as_such():
    """Of a steep and noisy one the steps of its errors left the range of numbers, which ended the whole test."""
    words = []
    for seed in range(10):
        random = np.random.default_rng(seed)
        force = np.linspace(2.8e-3, 1.1e-3, 50)
        depth = 200e-9 + 5e-9 * (force / 2.8e-3) ** (1.0 / 3.0) + 3e-9 * random.standard_normal(50)
        try:
            mdi.Unloading(np.r_[np.linspace(0.0, 205e-9, 60), depth], np.r_[np.linspace(0.0, 2.8e-3, 60), force], segments=PARTS)
        except mdr.errors.InvalidArgumentError as problem:
            words.append(str(problem))
    assert any("do not determine a stiffness" in refusal for refusal in words)
