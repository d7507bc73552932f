# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts on stiff coatings that are not a single area: the warning, and where it stays away."""

import warnings
from pathlib import Path

import numpy as np
import pytest

import mdrcontact as mdr

STIFF = mdr.Coated(mdr.Elastic(100.0, 0.25), 1.0, mdr.Elastic(1.0, 0.3), "exact")


def test_states_and_fields_warn_once_for_a_contact() -> None:
    contact = mdr.Contact(mdr.PowerLaw(4.0, 1.0), STIFF)
    with pytest.warns(mdr.errors.SeparationInsideWarning, match="at r = 0 .contact radius 2"):
        state = contact.at_radius(2.0)
    pressure, r = state.lowest_pressure()
    assert r == 0.0 and pressure == state.pressure(0.0)
    assert pressure == pytest.approx(-1.9 * state.force / (4.0 * np.pi), rel=0.05)
    with pytest.warns(mdr.errors.SeparationInsideWarning):
        mdr.Contact(mdr.Cone(0.1), STIFF).at_depth(np.linspace(0.0, 1.0, 50))
    with pytest.warns(mdr.errors.SeparationInsideWarning) as shown:
        mdr.Contact(mdr.FlatPunch(1.5), STIFF).at_depth(0.1).pressure([0.0, 1.0])
    assert shown[0].filename == __file__


def test_a_ring_of_contact_farther_out_is_seen() -> None:
    film = mdr.Coated(mdr.Elastic(1000.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "exact")
    contact = mdr.Contact(mdr.Cone(0.1), film)
    with pytest.warns(mdr.errors.SeparationInsideWarning, match="would pass through the indenter, by 0.*contact radius 0.6"):
        state = contact.at_radius(0.6)
    assert state.lowest_pressure() == (0.0, 0.6)
    assert state.displacement(9.0) > 0.0
    # a cone's flank is met by the bent film, u > d - f
    assert state.displacement(9.0) < state.depth - contact.indenter.height(9.0)
    # of several radii with this depth the smallest
    assert contact.at_depth(2.6).radius < 1.0 < 8.0 < contact.at_depth(2.7).radius


@pytest.mark.slow
def test_no_false_alarms() -> None:
    soft = STIFF.replace(coating=mdr.Elastic(0.01, 0.25))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", mdr.errors.LargeStrainWarning)
        for indenter in mdr.Paraboloid(1.0), mdr.Sphere(100.0), mdr.PowerLaw(2.0, 1.0):
            state = mdr.Contact(indenter, STIFF).at_radius([0.1, 1.0, 3.0, 10.0])
            assert state[2].lowest_pressure()[0] == 0.0
        for indenter in mdr.Cone(0.1), mdr.PowerLaw(4.0, 1.0):
            mdr.Contact(indenter, soft).at_radius([0.1, 1.0, 3.0, 10.0])
            mdr.Contact(indenter, STIFF.with_model("gao")).at_radius([0.1, 1.0, 3.0, 10.0])
            mdr.Contact(indenter, STIFF, work_of_adhesion=0.1).at_radius([1.0, 3.0])


def test_the_command_line_warns(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    problem = tmp_path / "problem.toml"
    problem.write_text(
        """[indenter]
shape = "flat-punch"
radius = "1.5 um"
[medium]
type = "coated"
model = "exact"
[medium.coating]
E = "100 GPa"
nu = 0.25
thickness = "1 um"
[medium.substrate]
E = "1 GPa"
nu = 0.3
[compute]
max_depth = "10 nm"
points = 3
"""
    )
    from mdrcontact.cli import main

    assert main(["curve", str(problem)]) == 0
    assert "warning: this contact is not a single area" in capsys.readouterr().err


def test_the_look_at_pressures_of_tiny_contacts():
    """Squares of the radius are 0 there."""
    contact = mdr.Contact(mdr.Cone(0.3), mdr.Coated(mdr.Elastic(3.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3)))
    state = contact.at_radius(1e-300)
    assert state.radius == 1e-300
    assert mdr.Friction(contact, 0.3).shear(state).at_shift(1e-305).shift == 1e-305
