# SPDX-License-Identifier: GPL-3.0-or-later
"""Dynamic (CSM) data: the modulus at every depth, at zero depth, and the effect of the oscillation."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import OXIDE, ROOT, SILICON
from records import sink_in

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.records import without_oscillation

DIAMOND = mdr.Elastic(1141e9, 0.07)
TIP = mdr.AreaFunction([24.5], max_height=1e-6)
TOOL = mdi.Instrument(indenter=DIAMOND)
START = mdr.Coated(mdr.Elastic(50e9, OXIDE.nu), 500e-9, SILICON)


def dynamic(noise, seed=0, points=30, area=1.0, drop=0.0):
    """CSM data of the oxide film under a tip whose area is `area` times the one assumed; its modulus falls by `drop` per length."""
    a = np.linspace(60e-9, 400e-9, points) * np.sqrt(area)
    films = [START.replace(coating=mdr.Elastic(OXIDE.E * (1.0 - drop * r), OXIDE.nu)) for r in a]
    stiffness = np.array([2.0 * r * float(mdr.Pair(f, DIAMOND).modulus(r)) for r, f in zip(a, films, strict=True)])
    force = 9e9 * np.pi * a**2
    sigma = np.array([float(sink_in(mdr.Pair(f, DIAMOND), r)) for r, f in zip(a, films, strict=True)])
    depth = np.sqrt(np.pi * a**2 / area / 24.5) + sigma * force / stiffness
    noisy = stiffness * (1.0 + noise * np.random.default_rng(seed).standard_normal(points))
    return mdi.StiffnessDepth(depth, force, noisy, relative_sd=noise or 1e-3)


def test_each_point_gives_the_modulus_of_the_film():
    found = mdi.modulus_at_depths(dynamic(0.0), TIP, START, {"coating.E": None}, instrument=TOOL)
    assert found.modulus == pytest.approx(np.full(30, OXIDE.E), rel=1e-5)
    assert found.at_zero == pytest.approx(OXIDE.E, rel=1e-5)
    assert not found.warnings and not found.failures
    assert np.all(np.diff(found.analysis.reduced_modulus) > 0.0), "without the film separated it rises to the substrate"


@pytest.mark.slow
def test_intervals_at_zero_depth_hold_the_truth():
    """Of 20 intervals of 95 % fewer than 16 would hold it with a probability of 2e-3; the tip is off by its standard deviation each
    time, which the common error holds."""
    random = np.random.default_rng(5)
    inside = 0
    for seed in range(20):
        data = dynamic(0.01, seed, points=16, area=1.0 + 0.02 * random.standard_normal())
        free = {"coating.E": None, "area_factor": mdi.Free(prior=(1.0, 0.02))}
        found = mdi.modulus_at_depths(data, TIP, START, free, instrument=TOOL)
        inside += found.interval.lower <= OXIDE.E <= found.interval.upper
    assert inside >= 16


def test_the_error_of_the_tip_is_in_the_modulus_at_zero_depth():
    """S/(2 a) of a homogeneous body under a rigid tip: the modulus goes as the area to the power -1/2, at zero depth too."""
    stiff = mdr.Homogeneous(mdr.Elastic(OXIDE.E, OXIDE.nu))
    a = np.linspace(60e-9, 400e-9, 12)
    stiffness = 2.0 * a * float(stiff.modulus(1.0))
    force = 9e9 * np.pi * a**2
    data = mdi.StiffnessDepth(a * np.sqrt(np.pi / 24.5) + 0.75 * force / stiffness, force, stiffness, relative_sd=1e-6)
    free = {"E": None, "area_factor": mdi.Free(prior=(1.0, 0.02))}
    found = mdi.modulus_at_depths(data, TIP, stiff, free)
    moved = OXIDE.E * (1.0 - 1.02**-0.5)
    assert found.common_error == pytest.approx(np.full(12, moved), rel=1e-5)
    assert found.at_zero_error == pytest.approx(moved, rel=1e-5)


def test_a_joint_prior_is_a_common_error_too():
    data = dynamic(0.01, points=12)
    alone = {"coating.E": None, "area_factor": mdi.Free(prior=(1.0, 0.02)), "thickness": mdi.Free(prior=(500e-9, 1e-8))}
    one = mdi.modulus_at_depths(data, TIP, START, alone, instrument=TOOL)
    joint = mdi.JointPrior(("area_factor", "thickness"), (1.0, 500e-9), ((4e-4, 0.0), (0.0, 1e-16)))
    two = mdi.modulus_at_depths(data, TIP, START, {"coating.E": None}, instrument=TOOL, known=[joint])
    assert two.common_error == pytest.approx(one.common_error, rel=1e-3)
    assert two.at_zero_error == pytest.approx(one.at_zero_error, rel=1e-3)


def test_a_point_without_a_common_error_is_told():
    """One standard deviation of the frame's compliance takes all of the largest stiffness: that point has no common error."""
    data = dynamic(0.0, points=12)
    free = {"coating.E": None, "frame_compliance": mdi.Free(prior=(0.0, 1.05 / data.y.max()))}
    found = mdi.modulus_at_depths(data, TIP, START, free, instrument=TOOL)
    assert list(np.flatnonzero(np.isnan(found.common_error))) == [11] == list(found.failures)
    assert np.all(np.isfinite(found.modulus))
    assert any("1 of 12 points have no common error" in words for words in found.warnings)


def test_a_modulus_that_changes_with_depth_is_told():
    found = mdi.modulus_at_depths(dynamic(0.005, drop=5e5), TIP, START, {"coating.E": None}, instrument=TOOL)
    assert any("changes with depth" in words for words in found.warnings)
    assert found.slope < 0.0


def test_secant_becomes_slope():
    """P = B (h - h_f)^1.5: what a lock-in amplifier reads over 6 nm of it, about the middle of its force, is put right."""
    B, final, m, rms = 1e8, 100e-9, 1.5, 2e-9
    span = 2.0 * np.sqrt(2.0) * rms
    h = np.array([130e-9, 160e-9, 250e-9])
    top, bottom = B * (h - final) ** m, B * (h - final - span) ** m
    read = (top - bottom) / span
    depth, force, stiffness, keeps = without_oscillation(h - span / 2.0, top - read * span / 2.0, read, rms)
    assert keeps.all()
    assert depth == pytest.approx(h, rel=1e-12) and force == pytest.approx(top, rel=1e-12)
    assert stiffness == pytest.approx(m * B * (h - final) ** (m - 1.0), rel=1e-9)
    assert np.all(stiffness > read)
    *_, keeps = without_oscillation(h, [1e-9, 1.0, 1.0], read, rms)
    assert list(keeps) == [False, True, True], "so little force: the indenter taps"


@pytest.mark.parametrize(
    ("data", "free", "words"),
    [
        (mdi.StiffnessDepth(*np.ones((3, 8))), {"coating.E": None}, "standard deviations"),
        (dynamic(0.01), {"coating.E": None, "thickness": None}, "here are coating.E, thickness"),
        (dynamic(0.01), {"thickness": mdi.Free(prior=(5e-7, 1e-8))}, "here are none"),
        (dynamic(0.01, points=3), {"coating.E": None}, "too few points"),
    ],
)
def test_refusals(data, free, words):
    with pytest.raises(mdr.MDRError, match=words):
        mdi.modulus_at_depths(data, TIP, START, free, instrument=TOOL)


def test_command_line(tmp_path, capsys):
    folder = ROOT / "examples" / "fit"
    written = {kind: tmp_path / f"modulus.{kind}" for kind in ("json", "csv", "png", "html")}
    options = [f"--{o}={written[k]}" for o, k in (("json", "json"), ("csv", "csv"), ("plot", "png"), ("report", "html"))]
    assert main(["modulus", str(folder / "csm_on_oxide.csv"), "--problem", str(folder / "csm_on_oxide.toml"), *options]) == 0
    assert "film modulus E at zero depth: 7" in capsys.readouterr().out
    found = json.loads(written["json"].read_text())
    assert found["interval"][0] < 72e9 < found["interval"][1]
    assert written["csv"].read_text().count("\n") == 81
    assert "data:image/png" in written["html"].read_text(encoding="utf-8")
    text = (folder / "csm_on_oxide.toml").read_text()
    (tmp_path / "p.toml").write_text(text.replace("[fit.free]", 'oscillation = "2 nm"\nmax_depth = "60 nm"\n[fit.free]'))
    assert main(["modulus", str(folder / "csm_on_oxide.csv"), "--problem", str(tmp_path / "p.toml")]) == 0
    assert "top of the oscillation" in capsys.readouterr().out
