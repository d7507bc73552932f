# SPDX-License-Identifier: GPL-3.0-or-later
"""Which curves of a folder count, and how warnings of many curves are counted."""

from __future__ import annotations

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.fitting.causes import by_cause

BALL, GEL = mdr.Paraboloid(5e-6), mdr.Homogeneous(mdr.Elastic(1e4, 0.5))
DEPTH = np.linspace(-1e-6, 1e-6, 400)
FORCE = np.where(DEPTH > 0.0, np.asarray(mdr.Contact(BALL, GEL).at_depth(np.maximum(DEPTH, 0.0)).force), 0.0)
LARGEST = float(FORCE.max())
PROBLEM = """
[indenter]
shape = "paraboloid"
radius = "5 um"
[medium]
type = "homogeneous"
material = { E = "10 kPa", nu = 0.5 }
[data]
kind = "force-depth"
[fit]
free = ["E", "depth_offset"]
"""


def curve(noise=0.005, bend=0.0, modulus=1.0, seed=0):
    random = np.random.default_rng(seed).standard_normal(len(DEPTH))
    return modulus * FORCE + LARGEST * (noise * random + bend * np.sin(8e6 * DEPTH) * (DEPTH > 0.0))


def rate(force):
    return mdi.rate(mdi.fit(mdi.ForceDepth(DEPTH, force), BALL, GEL, ["E", "depth_offset"]))


def test_ratings_fall_with_noise_and_misfit():
    good, loud, bent = rate(curve()), rate(curve(noise=0.1)), rate(curve(bend=0.06))
    assert good.is_sound and 9.0 < good.score <= 10.0
    assert loud.is_sound and loud.score < 9.0
    assert bent.score < 7.0


@pytest.mark.parametrize(
    ("options", "reason"), [({"noise": 0.6}, "noise"), ({"bend": 0.3}, "misses by"), ({"modulus": 1e-4}, "noise")]
)
def test_curves_that_say_too_little_do_not_count(options, reason):
    found = rate(curve(**options))
    assert not found.is_sound and found.score < 5.0
    assert any(reason in words for words in found.reasons)


def write(folder, **curves):
    folder.mkdir(exist_ok=True)
    for name, force in curves.items():
        rows = "\n".join(f"{d * 1e9!r},{f * 1e9!r}" for d, f in zip(DEPTH.tolist(), force.tolist(), strict=True))
        (folder / f"{name}.csv").write_text(f"depth [nm],force [nN]\n{rows}\n")


@pytest.fixture
def fitted(tmp_path, capsys):
    def run(*options, **curves):
        write(tmp_path / "curves", **curves)
        (tmp_path / "problem.toml").write_text(PROBLEM)
        assert main(["fit", str(tmp_path / "curves"), "--problem", str(tmp_path / "problem.toml"), *options]) == 0
        return capsys.readouterr().out

    return run


def test_a_folder_leaves_doubtful_curves_out_of_its_mean(fitted):
    curves = {f"good{i}": curve(seed=i) for i in range(6)} | {"bent": curve(bend=0.3)}
    out = fitted(**curves)
    assert "1 curve is left out of the mean" in out and "bent.csv: misses by" in out
    mean = next(line for line in out.splitlines() if line.startswith("modulus E"))
    assert float(mean.split()[3]) == pytest.approx(10.0, rel=0.01)
    kept = fitted("--keep-all", **curves)
    assert "left out of the mean" not in kept


def test_copies_are_told(fitted):
    out = fitted(**{f"copy{i}": curve() for i in range(4)}, other=curve(seed=1))
    (line,) = (line for line in out.splitlines() if "counts twice" in line)
    assert line.startswith("warning: 3 curves, as copy1.csv: ") and "copy0.csv" in line


def test_one_line_for_each_cause():
    lines = by_cause(
        [(f"{i}.csv", f"the estimators disagree by {12.5 + i} nm, {3 * i} % of the depth") for i in range(1, 5)]
        + [("9.csv", "something else")]
    )
    assert lines == ["4 curves, as 1.csv: the estimators disagree by 13.5 nm, 3 % of the depth", "9.csv: something else"]


def test_units_do_not_part_causes():
    assert len(by_cause([("a", "off by 12 nm"), ("b", "off by 1.2 µm"), ("c", "off by -3e-05 m")])) == 1


@pytest.mark.parametrize("scale", [1.0, 0.4])
def test_readings_softer_than_the_bare_base_are_no_film(scale):
    """Force a factor too small, as of a rough tip: the film takes the blame, and is not believed."""
    film = mdr.Layered([(mdr.Elastic(150e9, 0.24), 40e-9), (mdr.Elastic(70e9, 0.35), 500e-9)], mdr.Elastic(165e9, 0.22))
    depth = np.linspace(1e-10, 8e-9, 150)
    force = scale * np.asarray(mdr.Contact(BALL, film).at_depth(depth).force)
    result = mdi.fit(mdi.ForceDepth(depth, force), BALL, film, ["layers[0].E"])
    words = [words for words in result.warnings if "do not determine the film" in words]
    assert len(words) == (scale < 1.0)
    assert ("refused" in result.summary() and " GPa  " not in result.summary()) == (scale < 1.0), "no modulus and no interval"
    assert any("softer than its base" in reason for reason in mdi.rate(result).reasons) == (scale < 1.0)
