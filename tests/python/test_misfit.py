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


def warnings_of(depth, force, branch):
    data = mdi.ForceDepth(depth, force) if branch == "both" else mdi.ForceDepth(depth[:150], force[:150], branch="loading")
    if branch == "loading":
        data.unused = depth[150:], force[150:]
    return [words for words in mdi.fit(data, BALL, mdr.Homogeneous(OXIDE), ["E"]).warnings if "work of loading" in words]


@pytest.mark.parametrize("branch", ["loading", "both"])
def test_an_indent_that_stays_is_told(branch):
    """By the triangle of a linear loading: unloading to 60 % of the depth gives back 40 % of the work."""
    (words,) = warnings_of(*indented(1.0, 0.6), branch)
    back, left = (float(re.search(rf"([\d.]+) % of the {what}", words)[1]) for what in ("work", "depth"))
    assert back == pytest.approx(40.0, abs=1.0) and left == pytest.approx(57.0, abs=2.0), "57 % at a twentieth of the force"
    assert warnings_of(*indented(1.5, 0.0), branch) == [], "an elastic loading"


def test_a_pull_is_no_indent():
    depth, force = indented(1.0, 0.6)
    force[-20:] = -2e-3
    assert warnings_of(depth, force, "loading") == [], "what adheres"
