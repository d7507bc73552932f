# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of layered bodies and of pairs against the reference states of tests/data."""

import csv
import math
from pathlib import Path

import pytest

import mdrcontact as mdr

TABLE = Path(__file__).parents[1] / "data" / "stress.csv"
INDENTERS = {"paraboloid R=1": mdr.Paraboloid(1.0), "cone slope 1": mdr.Cone(math.pi / 4), "r^4": mdr.PowerLaw(1.0, 4.0)}


def surface_rows():
    """The rows inside the contact at the surface, where -s_zz is the contact pressure."""
    with TABLE.open() as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        return [row for row in rows if float(row["z"]) == 0.0 and float(row["r"]) < float(row["a"])]


def body(text):
    """h:E:nu of the layers from the surface down, then the half-space E:nu or 'rigid base'."""
    *layers, last = (part.strip() for part in text.split(";"))
    base = mdr.RIGID if last == "rigid base" else mdr.Elastic(*map(float, last.split(":")))
    if not layers:
        return mdr.Homogeneous(base)
    sizes = [tuple(map(float, layer.split(":"))) for layer in layers]
    return mdr.Layered([(mdr.Elastic(E, nu), h) for h, E, nu in sizes], base, tolerance=1e-12)


@pytest.mark.filterwarnings("ignore::mdrcontact.errors.SeparationInsideWarning")
@pytest.mark.parametrize("row", surface_rows(), ids=lambda row: f"{row['case']} r={row['r']}")
def test_surface_pressure(row):
    a, force = float(row["a"]), float(row["F"])
    medium = body(row["body1"])
    if row["body2"] != "rigid":
        medium = mdr.Pair(medium, body(row["body2"]))
    indenter = INDENTERS.get(row["profile"]) or mdr.FlatPunch(a)
    contact = mdr.Contact(indenter, medium, work_of_adhesion=float(row["gamma"]))
    state = contact.at_depth(float(row["d"])) if isinstance(indenter, mdr.FlatPunch) else contact.at_radius(a)
    assert state.depth == pytest.approx(float(row["d"]), rel=1e-12)
    assert state.force == pytest.approx(force, rel=1e-12)
    mean_pressure = abs(force) / (math.pi * a**2)
    assert state.pressure(float(row["r"])) == pytest.approx(-float(row["s_zz"]), abs=1e-10 * mean_pressure)
