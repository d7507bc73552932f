# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a modulus moves with the fitted range, the branch and the contact point."""

from __future__ import annotations

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main

BALL, GEL = mdr.Paraboloid(5e-6), mdr.Homogeneous(mdr.Elastic(1e4, 0.5))
DEPTH = np.linspace(-1e-6, 1e-6, 600)


def force(depth, modulus=1e4):
    body = mdr.Homogeneous(mdr.Elastic(modulus, 0.5))
    return np.where(depth > 0.0, np.asarray(mdr.Contact(BALL, body).at_depth(np.maximum(depth, 0.0)).force), 0.0)


def test_a_model_that_is_right_stays():
    noise = 1e-3 * force(DEPTH).max() * np.random.default_rng(0).standard_normal(len(DEPTH))
    found = mdi.find_moves(mdi.fit(mdi.ForceDepth(DEPTH, force(DEPTH) + noise), BALL, GEL, ["E", "depth_offset"]))
    assert found.name == "E" and len(found.ranges) == 8
    for move in found.ranges:
        assert abs(move.value - 1e4) < 4.0 * move.standard_error
    assert found.ranges[-1].value == pytest.approx(found.result.estimates["E"], rel=1e-6)
    assert found.ranges[0].standard_error > 2.0 * found.ranges[-1].standard_error


def test_a_film_taken_for_a_half_space_moves():
    """Deeper contacts feel more of the base: the modulus grows along the range."""
    film = mdr.Coated(mdr.Elastic(1e4, 0.5), 3e-6, mdr.RIGID)
    depth = np.linspace(1e-8, 1e-6, 200)
    data = mdi.ForceDepth(depth, np.asarray(mdr.Contact(BALL, film).at_depth(depth).force))
    found = mdi.find_moves(mdi.fit(data, BALL, GEL, ["E"]))
    values = [move.value for move in found.ranges]
    assert values == sorted(values) and values[0] < 0.8 * values[-1]
    (line,) = found.summary()
    assert line.startswith("modulus E moves by -") and "with the fitted range" in line
    figure = found.plot()
    (panel,) = figure.panels
    assert (panel.x.title, panel.y.title) == ("end of the range: depth [µm]", "modulus E [kPa]")
    assert 1e3 * panel.parts[0].y == pytest.approx(values, rel=1e-14)


def test_branches_are_fitted_alone():
    data = mdi.ForceDepth(np.r_[DEPTH, DEPTH[::-1]], np.r_[force(DEPTH), force(DEPTH[::-1], 2e4)])
    found = mdi.find_moves(mdi.fit(data, BALL, GEL, ["E"]))
    assert [move.value for move in found.branches] == pytest.approx([1e4, 2e4], rel=1e-6)


def test_contact_points_of_estimators_are_held():
    data = mdi.ForceDepth(DEPTH, force(DEPTH))
    data.contact_points = {"piecewise": 0.0, "ratio-of-variances": -1e-7}
    found = mdi.find_moves(mdi.fit(data, BALL, GEL, ["E", "depth_offset"]))
    assert found.contact_points[0].value == pytest.approx(1e4, rel=1e-6)
    assert found.contact_points[1].value < 9e3


def test_command_line(tmp_path, capsys):
    folder = "examples/fit/sphere_on_oxide"
    picture = tmp_path / "ranges.png"
    assert main(["fit", f"{folder}.csv", "--problem", f"{folder}.toml", "--ranges", str(picture)]) == 0
    assert "film modulus E moves by" in capsys.readouterr().out
    assert picture.read_bytes().startswith(b"\x89PNG")
