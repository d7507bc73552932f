# SPDX-License-Identifier: GPL-3.0-or-later
"""Conduction through spots: reference values, limits, laws, refusals."""

import csv
from pathlib import Path

import pytest

import mdrcontact as mdr

REFERENCE = Path(__file__).parents[1] / "data" / "conduction.csv"
BASES = {"perfect": mdr.PERFECT, "insulating": mdr.INSULATING}


def rows():
    with REFERENCE.open(encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def body_of(text):
    """A body of the reference file; None for "-"."""
    layers = []
    for word in text.split(";"):
        if word in BASES:
            return mdr.LayeredConductor(layers, BASES[word])
        if word == "-":
            return None
        if word.startswith("R="):
            layers.append(mdr.Interface(float(word[2:])))
            continue
        h, sigma, along, capacity = word.split(":")
        conductor = mdr.Conductor(float(sigma), float(along), float(capacity))
        if h == "inf":
            return mdr.LayeredConductor(layers, conductor)
        layers.append((conductor, float(h)))
    raise AssertionError(text)


def parameters_of(row):
    words = (word.split("=") for word in row["parameters"].split(";") if "=" in word)
    return {name: complex(value) if "j" in value else float(value) for name, value in words}


def value_of(row):
    """By the library."""
    given, a, what = parameters_of(row), float(row["a"]), row["quantity"]
    conduction = mdr.Conduction(body_of(row["body1"]), body_of(row["body2"]), given.get("Rc", 0.0), given.get("b"))
    if "s" in given or "t" in given:
        answer = {"G": "conductance", "R": "resistance", "Ru mean": "mean", "Ru centre": "centre", "Z gauss": "gaussian"}[what]
        if "s" in given:
            return conduction.admittance(given["s"].imag, given.get("w", a), answer)
        return conduction.step(given["t"], a, answer)
    if what.startswith("Ru"):
        return conduction.admittance(0.0, a, {"Ru mean": "mean", "Ru centre": "centre"}[what]).real
    spot = conduction.at_radius(a)
    if what == "series G":
        parts = [mdr.Conduction(body_of(row[name])).at_radius(a).conductance for name in ("body1", "body2")]
        return 1.0 / sum(1.0 / part for part in parts)
    if what == "j":
        return spot.flux(given["r"])
    if what.startswith("phi"):
        return spot.potential(given["r"], given["z"], "upper" if what == "phi2" else "lower")
    if what in ("j_z", "j_r"):
        return spot.flux_inside(given["r"], given["z"])[what == "j_r"]
    return {"G": spot.conductance, "dG/da": spot.slope}[what]


LATER = ("heat", "moving", "spin", "coupling")
"""Groups that this test leaves to others."""


def is_of_spot(row):
    """Whether a row is an answer of a spot alone."""
    return not (row["group"].startswith(LATER) or "friction" in row["group"] or "Rm" in row["parameters"] or
                ("t=" in row["parameters"] and row["quantity"] == "j"))  # fmt: skip


def name_of(row):
    return " ".join(row[key] for key in ("group", "body1", "body2", "a", "parameters", "quantity"))


@pytest.mark.parametrize("row", [row for row in rows() if is_of_spot(row)], ids=name_of)
def test_reference(row):
    expected = complex(float(row["value"]), float(row["imaginary"]))
    assert abs(value_of(row) - expected) <= max(10.0 * float(row["accuracy"]), 1e-11) * abs(expected)
