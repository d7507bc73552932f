# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a model departs from its data: sizes that were put in come out."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from conftest import OXIDE, SILICON

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.fitting.indent import find_indent
from mdrcontact.instruments.fitting.misfit import measure_misfit

BALL, BODY = mdr.Paraboloid(5e-6), mdr.Homogeneous(mdr.Elastic(1e4, 0.5))
DEPTH = np.linspace(0.0, 1e-6, 2000)
FORCE = np.asarray(mdr.Contact(BALL, BODY).at_depth(DEPTH).force)
LARGEST = float(FORCE.max())


@pytest.mark.parametrize("noise", [0.0, 0.002, 0.05])
@pytest.mark.parametrize("wave", [0.0, 0.03, 0.2])
@pytest.mark.parametrize("before", [0, 3000])
def test_wave_and_noise_are_told_apart(noise, wave, before):
    """A wave over the contact, with a baseline of any length before it."""
    depth = np.concatenate([np.linspace(-20e-6, -1e-9, before), DEPTH])
    model = np.concatenate([np.zeros(before), FORCE])
    random = np.random.default_rng(1).standard_normal(len(depth))
    bend = wave * LARGEST * np.where(depth > 0.0, np.sin(4.0 * np.pi * model / LARGEST), 0.0)
    found = measure_misfit(mdi.ForceDepth(depth, model + bend + noise * LARGEST * random), model)
    share = 1.0 if before == 0 else 1.0 / math.sqrt(2.0)
    assert found.noise == pytest.approx(noise, rel=0.05, abs=0.02 * wave)
    assert found.rms == pytest.approx(wave / math.sqrt(2.0) * share, rel=0.15, abs=0.1 * noise)


def test_the_largest_is_where_it_is():
    bump = 0.1 * LARGEST * np.exp(-(((DEPTH - 6e-7) / 5e-8) ** 2))
    found = measure_misfit(mdi.ForceDepth(DEPTH, FORCE + bump), FORCE)
    assert found.at == pytest.approx(6e-7, abs=3e-8) and found.largest == pytest.approx(0.1, rel=0.1)


def test_an_offset_is_no_force():
    data = mdi.ForceDepth(DEPTH, 1.01 * FORCE + 1.0)
    assert measure_misfit(data, FORCE + 1.0, 1.0).largest == pytest.approx(0.01, rel=0.1)


def test_stiffnesses_count_each_by_itself():
    a = np.geomspace(1e-8, 1e-6, 50)
    data = mdi.StiffnessRadius(a, 1.03 * a)
    assert measure_misfit(data, a).rms == pytest.approx(0.03, rel=1e-6)


@pytest.mark.parametrize(("bend", "verdict"), [(0.0, "describes"), (0.03, "describes to "), (0.3, "misses by ")])
def test_verdicts_by_size(bend, verdict):
    """Capitals for the last alone."""
    noise = 1e-3 * LARGEST * np.random.default_rng(0).standard_normal(len(DEPTH))
    data = mdi.ForceDepth(DEPTH, FORCE + bend * LARGEST * np.sin(9.0 * DEPTH / DEPTH[-1]) + noise)
    result = mdi.fit(data, BALL, BODY, ["E"])
    assert result.verdict.startswith(verdict)
    assert result.describes_data is (bend < 0.05)
    assert ("MISSES" in result.summary()) == (bend > 0.05)
    found = result.to_dict()
    assert found["verdict"] == result.verdict and found["misfit"]["rms"] == result.misfit.rms
    words = [words for words in result.warnings if "of the force" in words]
    assert len(words) == (bend > 0.0), "one warning for one cause"


def test_noise_whose_neighbours_share_errors_is_sized_and_not_shouted_at():
    """Autocorrelation 0.97, 0.3 % of the force: it was THE MODEL MISSES THE DATA."""
    random = np.random.default_rng(0).standard_normal(len(DEPTH))
    noise = np.zeros_like(random)
    for i in range(1, len(noise)):
        noise[i] = 0.97 * noise[i - 1] + math.sqrt(1.0 - 0.97**2) * random[i]
    result = mdi.fit(mdi.ForceDepth(DEPTH, FORCE + 3e-3 * LARGEST * noise), BALL, BODY, ["E"])
    assert result.describes_data and result.departure < 0.005 and result.widening["E"] > 2.0
    assert result.warnings == [] and "MISSES" not in result.summary()


def test_a_wrong_body_is_missed():
    film = mdr.Coated(mdr.Elastic(1e9, 0.4), 500e-9, SILICON)
    depth = np.linspace(1e-9, 3e-7, 300)
    force = np.asarray(mdr.Contact(mdr.Paraboloid(1e-5), film).at_depth(depth).force)
    result = mdi.fit(mdi.ForceDepth(depth, force), mdr.Paraboloid(1e-5), mdr.Homogeneous(OXIDE), ["E"])
    assert result.describes_data is False and result.verdict.startswith("misses by")


def indented(power, stays, noise=2e-3):
    """Loading as a power of the depth to 200 nm, and unloading to a part of it; depth and force of both."""
    way = np.linspace(0.0, 1.0, 150)
    back = 1.0 - way
    force = np.r_[way**power, back] + noise * np.random.default_rng(0).standard_normal(300)
    return 200e-9 * np.r_[way, 1.0 - (1.0 - stays) * (1.0 - back ** (1.0 / power))], 1e-2 * force


def record_of(depth, force, branch):
    """Both ways, or one of them with the other outside the fit."""
    data = mdi.ForceDepth(depth, force)
    return data if branch == "both" else data.on(branch)


def warnings_of(depth, force, branch):
    free = ["E", "depth_offset"] if branch == "unloading" else ["E"]
    result = mdi.fit(record_of(depth, force, branch), BALL, mdr.Homogeneous(OXIDE), free)
    return [words for words in result.warnings if "work of loading" in words]


@pytest.mark.parametrize("branch", ["loading", "unloading", "both"])
def test_an_indent_that_stays_is_told(branch):
    """By the triangle of a linear loading: unloading to 60 % of the depth gives back 40 % of the work."""
    (words,) = warnings_of(*indented(1.0, 0.6), branch)
    back, left = (float(re.search(rf"([\d.]+) % of the {what}", words)[1]) for what in ("work", "depth"))
    # at a twentieth of the force, of the depth from there where the start is unknown
    assert back == pytest.approx(40.0, abs=1.0) and left == pytest.approx(60.0 if branch == "unloading" else 57.0, abs=2.0)
    assert ("too high" in words) == (branch == "unloading")
    assert warnings_of(*indented(1.5, 0.0), branch) == [], "an elastic loading"


def test_unloading_with_the_contact_point_of_loading_seems_soft():
    """Its force is below that of loading at every depth; with the contact point free the imprint seems stiff."""
    depth, force = indented(1.0, 0.6)
    moduli = []
    for free, words in ((["E"], "too low"), (["E", "depth_offset"], "too high")):
        result = mdi.fit(record_of(depth, force, "unloading"), BALL, mdr.Homogeneous(OXIDE), free)
        assert any(f"the modulus is {words}" in text for text in result.warnings)
        moduli.append(result.estimates["E"])
    loading = mdi.fit(record_of(depth, force, "loading"), BALL, mdr.Homogeneous(OXIDE), ["E"]).estimates["E"]
    assert moduli[0] < loading < moduli[1]


@pytest.mark.parametrize("noise", [0.02, 0.1])
def test_few_noisy_readings_of_an_elastic_body_are_no_indent(noise):
    random = np.random.default_rng(0)
    way = np.linspace(0.02, 1.0, 12)
    depth = 200e-9 * np.r_[way, way[::-1]]
    for _ in range(200):
        force = 1e-2 * (np.r_[way, way[::-1]] ** 1.5 + noise * random.standard_normal(24))
        assert find_indent(mdi.ForceDepth(depth, force), 0.0, 0.0) is None


def test_a_pull_is_no_indent():
    depth, force = indented(1.0, 0.6)
    force[-20:] = -2e-3
    assert warnings_of(depth, force, "loading") == [], "what adheres"


YOUNG = 120e9
"""Modulus of a body that yields."""


def berkovich_on_metal(readings=200):
    """Loading F = C h^2 of a pyramid, as of an elastic body of 47 GPa; unloading with the stiffness of 120 GPa."""
    tip = mdr.Berkovich()
    elastic = float(mdr.Contact(tip, mdr.Homogeneous(mdr.Elastic(47.2e9, 0.34))).at_depth(1e-6).force)
    way, back = np.linspace(0.0, 1.0, readings), np.linspace(1.0, 0.0, readings)
    # h_c = h - 0.75 P/S and S = 2 E* a, a = tan of the equivalent cone times h_c
    reduced, slope = YOUNG / (1.0 - 0.34**2), 1.0 / math.tan(tip.inclination)
    stiffness = max(np.roots([1.0, -2.0 * reduced * slope * 1e-6, 1.5 * reduced * slope * elastic]).real)
    final = 1e-6 - 1.5 * elastic / stiffness
    depth = np.r_[1e-6 * way, final + (1e-6 - final) * back ** (2.0 / 3.0)]
    noise = 1e-3 * np.random.default_rng(0).standard_normal(2 * readings)
    return tip, depth, elastic * (np.r_[way**2, back] + noise)


@pytest.mark.parametrize("branch", ["loading", "unloading", "both"])
def test_a_plastic_record_is_not_elastic_in_silence(branch):
    """Without its unloading the loading is that of 47.2 GPa, which describes it; the stiffness gives the 120 GPa of the body."""
    tip, depth, force = berkovich_on_metal()
    body = mdr.Homogeneous(mdr.Elastic(100e9, 0.34))
    alone = mdi.fit(mdi.ForceDepth(depth[:200], force[:200]), tip, body, ["E"])
    assert alone.verdict == "describes" and alone.estimates["E"] == pytest.approx(47.2e9, rel=2e-3)
    result = mdi.fit(record_of(depth, force, branch), tip, body, ["E", "depth_offset"] if branch == "unloading" else ["E"])
    assert result.is_plastic and result.verdict.startswith("plastic or viscous, ") and result.describes_data is False
    assert "THE CONTACT IS PLASTIC" in result.summary() and "the model is elastic but the contact is plastic" in result.summary()
    found = result.to_dict()
    assert found["verdict"] == result.verdict and found["describes_data"] is False
    assert found["indent"]["share"] == result.indent.share > 0.5 and 0.1 < found["indent"]["returned"] < 0.5
    assert "plastic" in result.report() and result.verdict in mdi.rate(result).reasons
    (many,) = mdi.fit_many([record_of(depth, force, branch)], tip, body, list(result.names))
    assert many.verdict == result.verdict
    stiff = mdi.fit(mdi.Unloading(depth, force), tip, body, ["E"])
    assert stiff.estimates["E"] == pytest.approx(YOUNG, rel=0.01)


def test_the_shallow_part_may_be_elastic():
    """The record is loaded further than the fit goes: what stays then says nothing certain about the shallow part."""
    tip, depth, force = berkovich_on_metal()
    data = mdi.ForceDepth(depth[:80], force[:80], branch="loading")
    data.unused = depth[80:], force[80:]
    result = mdi.fit(data, tip, mdr.Homogeneous(mdr.Elastic(100e9, 0.34)), ["E"])
    assert not result.is_plastic and result.verdict == "describes"
    assert any("loading continues beyond the fitted readings" in words for words in result.warnings)


def test_elastic_against_the_data_is_told():
    """What the data show to be plastic is taken as elastic on demand, with a warning."""
    tip, depth, force = berkovich_on_metal()
    body = mdr.Homogeneous(mdr.Elastic(100e9, 0.34))
    for elastic, count in ((True, 1), (None, 0)):
        result = mdi.fit(mdi.Unloading(depth, force, elastic=elastic), tip, body, ["E"])
        assert sum("elastic = true, but the contact is plastic" in words for words in result.warnings) == count
    h, p = depth[20:200], force[20:200]
    rising = mdi.StiffnessDepth(h, p, 4.0 * p / h, relative_sd=0.01, elastic=True)
    assert any("rises by 5" in words for words in mdi.fit(rising, tip, body, ["E"]).warnings)


def test_the_command_line_says_plastic(tmp_path, capsys):
    """One curve and a folder: the verdict, and no mean."""
    _, depth, force = berkovich_on_metal()
    folder = tmp_path / "curves"
    folder.mkdir()
    for name in ("one", "two"):
        columns = np.c_[depth * 1e9, force * 1e3]
        np.savetxt(folder / f"{name}.csv", columns, delimiter=",", header="depth (nm),force (mN)", comments="")
    problem = tmp_path / "p.toml"
    problem.write_text(
        '[indenter]\nshape = "berkovich"\n[medium]\ntype = "homogeneous"\nmaterial = { E = "100 GPa", nu = 0.34 }\n'
        '[data]\nkind = "force-depth"\nbranch = "loading"\n[fit]\nfree = ["E"]\n'
    )
    assert main(["fit", str(folder / "one.csv"), "--problem", str(problem)]) == 0
    said = capsys.readouterr().out
    assert "THE CONTACT IS PLASTIC" in said and "warning: unloading gives back" in said
    assert main(["fit", str(folder), "--problem", str(problem)]) == 0
    said = capsys.readouterr().out
    assert "plastic or viscous" in said and "left out of the mean" in said and "0 of 2 fits describe" in said
