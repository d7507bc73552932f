# SPDX-License-Identifier: GPL-3.0-or-later
"""Poroelastic gels: reference values of tests/data, elastic limits, published curves, relations between the answers."""

import csv
from pathlib import Path

import numpy as np
import pytest

import mdrcontact as mdr

TABLE = Path(__file__).parents[1] / "data" / "poroelastic.csv"
DRAINAGES = {"drained": "surface", "impermeable": "sealed", "mixed": "indenter"}


def rows(*kinds):
    """The reference values of some kinds."""
    with TABLE.open() as lines:
        table = csv.DictReader(line for line in lines if not line.startswith("#"))
        return [{**row, **dict(part.split("=") for part in row["inputs"].split(";"))} for row in table if row["kind"] in kinds]


def body(row, nu=None):
    """The half-space or film of a row."""
    gel = mdr.Poroelastic(1.0, float(row["nu"]) if nu is None else nu, 1.0)
    if row["body"].startswith("half"):
        return mdr.Homogeneous(gel)
    return mdr.Coated(gel, float(row["body"].split("h=")[1].split()[0]), mdr.RIGID)


def punch(gel=None, a=1.0):
    return mdr.Contact(mdr.FlatPunch(a), mdr.Homogeneous(gel or mdr.Poroelastic(1.0, 0.2, 1.0)))


@pytest.mark.parametrize("row", rows("flat_punch_step_depth"), ids=lambda row: f"{row['body'][:8]} {row['inputs']}")
def test_flat_punch(row):
    contact = mdr.Contact(mdr.FlatPunch(1.0), body(row))
    force = contact.relaxation(float(row["t"]), drainage=DRAINAGES[row["drainage"]])
    scale = 8.0 if row["quantity"].startswith("F/") else 1.0
    assert force / scale == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("row", rows("sphere_held_radius_step_depth"), ids=lambda row: row["inputs"])
def test_held_paraboloid(row):
    contact = mdr.Contact(mdr.Paraboloid(1.0), body(row))
    path = contact.history([0.0, float(row["t"])], radius=[1.0, 1.0], drainage=DRAINAGES[row["drainage"]])
    assert path.force[0] == pytest.approx(16.0 / 3.0, rel=1e-12)
    assert path.force[1] / (16.0 / 3.0) == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("row", rows("flat_punch_dynamic_stiffness"), ids=lambda row: row["inputs"] + row["quantity"])
def test_dynamic_stiffness(row):
    stiffness = punch(mdr.Poroelastic(1.0, float(row["nu"]), 1.0)).dynamic_stiffness(
        float(row["omega"]), drainage=DRAINAGES[row["drainage"]]
    )
    value = stiffness.real if row["quantity"] == "k_storage" else stiffness.imag
    assert value == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("drainage", DRAINAGES.values())
@pytest.mark.parametrize("nu", [-0.3, 0.0, 0.3, 0.49])
def test_limits_are_elastic(drainage, nu):
    gel = mdr.Poroelastic(2.0, nu, 3.0)
    contact = punch(gel, 0.5)
    undrained, drained = (mdr.Homogeneous(material).stiffness(0.5) for material in (gel.undrained, gel.drained))
    assert contact.relaxation(0.0, drainage=drainage) == pytest.approx(undrained, rel=1e-12)
    assert contact.relaxation(1e-22, drainage=drainage) == pytest.approx(undrained, rel=1e-9)
    assert contact.relaxation(1e20, drainage=drainage) == pytest.approx(drained, rel=1e-9)
    assert contact.relaxation(1e30, drainage=drainage) == pytest.approx(drained, rel=1e-12)
    assert contact.creep(0.0, drainage=drainage) == pytest.approx(1.0 / undrained, rel=1e-12)
    assert contact.creep(1e20, drainage=drainage) == pytest.approx(1.0 / drained, rel=1e-9)
    fast, slow = contact.dynamic_stiffness([1e22, 1e-20], drainage=drainage)
    assert fast == pytest.approx(undrained, rel=1e-9)
    assert slow == pytest.approx(drained, rel=1e-9)


@pytest.mark.parametrize("drainage", ["surface", "sealed"])
@pytest.mark.parametrize("ratio", [0.3, 1.0, 3.0])
def test_limits_of_films_are_elastic(drainage, ratio):
    gel = mdr.Poroelastic(2.0, 0.2, 3.0)
    contact = mdr.Contact(mdr.FlatPunch(ratio), mdr.Coated(gel, 1.0, mdr.RIGID))
    ends = [mdr.Coated(m, 1.0, mdr.RIGID, tolerance=1e-12).stiffness(ratio) for m in (gel.undrained, gel.drained)]
    assert contact.relaxation(0.0, drainage=drainage) == pytest.approx(ends[0], rel=1e-9)
    assert contact.relaxation(1e30, drainage=drainage) == pytest.approx(ends[1], rel=1e-9)


def test_curve_of_lai_and_hu():
    tau = np.geomspace(1e-3, 10.0, 60)
    root = np.sqrt(tau)
    published = 0.242 * np.exp(-3.13 * tau) + 0.536 * np.exp(-1.71 * root)
    published += -0.043 * np.exp(-12.8 * np.cbrt(tau)) + 0.266 * np.exp(-0.892 * np.sqrt(root))
    force = punch(mdr.Poroelastic(1.0, 0.0, 1.0)).relaxation(tau, drainage="indenter")
    assert (force - 4.0) / 4.0 == pytest.approx(published, abs=2e-3)


@pytest.mark.parametrize("drainage", DRAINAGES.values())
def test_tail_is_algebraic(drainage):
    tau = np.array([1e3, 1e5])
    rest = punch().relaxation(tau, drainage=drainage) - 5.0
    assert np.diff(np.log(rest))[0] / np.diff(np.log(tau))[0] == pytest.approx(-0.5, rel=0.02)
