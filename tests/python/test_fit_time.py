# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of viscoelastic bodies: approach and retraction, creep, dynamic stiffness; what is recovered, and how often it lies within
its interval."""

from __future__ import annotations

import json
import math
from time import process_time

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.__main__ import main
from mdrcontact.instruments.files.fit_file import load_fit_file

TIP = mdr.Paraboloid(5e-6)
TIME = np.linspace(0.0, 2.0, 300)
PATH = np.interp(TIME, [0.0, 0.7, 1.3, 2.0], [-0.1e-6, 0.6e-6, 0.6e-6, -0.1e-6])
GEL = mdr.PowerLawRheology(1e3, 1.0, 0.2, 0.5)
POLYMER = mdr.Viscoelastic(300.0, [(500.0, 0.1), (200.0, 1.0)], bulk_modulus=5e3)


def force_time(medium, noise=1e-11, seed=0, offset=0.1e-6):
    """A curve of the path, with noise of the force."""
    force = mdr.Contact(TIP, medium).history(TIME, depth=PATH).force
    return mdi.ForceTime(TIME, PATH + offset, force + noise * np.random.default_rng(seed).standard_normal(TIME.size), sd=noise)


def within(result, truth, errors=4.0):
    """Each estimate is within so many standard errors, and those say something."""
    for name, value in truth.items():
        assert abs(result.estimates[name] - value) < errors * result.standard_errors[name], name
        assert 0.0 < result.standard_errors[name] < 0.2 * abs(value), name


def test_power_law_from_approach_and_retraction():
    start = mdr.Homogeneous(mdr.PowerLawRheology(400.0, 1.0, 0.35, 0.5))
    instrument = mdi.Instrument(depth_offset=0.09e-6)
    free = ["modulus", "exponent", "depth_offset"]
    result = mdi.fit(force_time(mdr.Homogeneous(GEL)), TIP, start, free, instrument=instrument)
    assert result.converged and result.describes_data
    within(result, {"modulus": 1e3, "exponent": 0.2, "depth_offset": 0.1e-6})
    assert isinstance(result.medium.material, mdr.PowerLawRheology)
    assert result.medium.material.exponent == result.estimates["exponent"]
    assert not result.warnings


def test_prony_terms_and_offsets_of_a_polymer():
    start = mdr.Homogeneous(mdr.Viscoelastic(500.0, [(300.0, 0.05), (300.0, 0.5)], bulk_modulus=5e3))
    truth = {"relaxed_shear_modulus": 300.0, "terms[0].modulus": 500.0, "terms[1].modulus": 200.0, "terms[0].time": 0.1}
    result = mdi.fit(force_time(mdr.Homogeneous(POLYMER), 1e-13, offset=0.0), TIP, start, [*truth, "terms[1].time"])
    within(result, truth)
    assert result.medium.material.bulk_modulus == 5e3


def test_film_with_a_prior_on_its_thickness():
    """The prior's error is in that of the modulus: without it the modulus is several times better known."""
    medium = mdr.Coated(GEL, 3e-6, mdr.RIGID)
    start = medium.replace(coating=GEL.replace(modulus=700.0, exponent=0.25), thickness=2.9e-6)
    free = {"coating.modulus": None, "coating.exponent": None, "thickness": mdi.Free(prior=(3.05e-6, 0.1e-6))}
    data = force_time(medium, 3e-10, offset=0.0)
    result = mdi.fit(data, TIP, start, free)
    within(result, {"coating.modulus": 1e3, "coating.exponent": 0.2, "thickness": 3e-6})
    known = mdi.fit(data, TIP, start.replace(thickness=3e-6), list(free)[:2])
    assert result.standard_errors["coating.modulus"] > 2.0 * known.standard_errors["coating.modulus"]


def test_coverage():
    """95 % intervals of a power law hold the truth in about 95 % of simulated curves (binomial, 1e-4)."""
    start = mdr.Homogeneous(GEL.replace(modulus=1.1e3, exponent=0.22))
    held = []
    for seed in range(60):
        result = mdi.fit(force_time(mdr.Homogeneous(GEL), seed=seed, offset=0.0), TIP, start, ["modulus", "exponent"])
        for name, truth in (("modulus", 1e3), ("exponent", 0.2)):
            lower, upper = result.interval(name)
            held.append(lower < truth < upper)
    assert 0.86 < np.mean(held) < 1.0


def test_noise_of_the_depth():
    """Depth readings that go back and forth: the path is found, and said so; the estimates stay."""
    rough = PATH + 0.3e-9 * np.random.default_rng(3).standard_normal(TIME.size)
    clean = force_time(mdr.Homogeneous(GEL), offset=0.0)
    data = mdi.ForceTime(TIME, rough, clean.y)
    assert any("back and forth" in words for words in data.warnings)
    assert np.sqrt(np.mean((data.given - PATH) ** 2)) < 0.3e-9
    start = mdr.Homogeneous(GEL.replace(modulus=500.0, exponent=0.3))
    result = mdi.fit(data, TIP, start, ["modulus", "exponent", "depth_offset"])
    assert result.estimates["modulus"] == pytest.approx(1e3, rel=0.02)
    assert result.estimates["exponent"] == pytest.approx(0.2, abs=0.005)


@pytest.mark.parametrize(("count", "noise"), [(200, 1e-9), (200, 5e-9), (1600, 1e-9), (6300, 5e-9)])
@pytest.mark.parametrize("seed", [0, 2])
def test_depths_with_noise_take_no_longer(count, noise, seed):
    """Each step of noise was a contact that shrinks and grows: 42 s for 200 readings, no end for 6,300. The straight pieces are
    those of the path that was prescribed."""
    time = np.linspace(0.0, 2.0, count)
    path = np.interp(time, [0.0, 0.7, 1.3, 2.0], [-0.1e-6, 0.6e-6, 0.6e-6, -0.1e-6])
    force = np.interp(time, TIME, np.asarray(mdr.Contact(TIP, mdr.Homogeneous(GEL)).history(TIME, depth=PATH).force))
    random = np.random.default_rng(seed)
    begun = process_time()
    data = mdi.ForceTime(time, path + noise * random.standard_normal(count), force + 1e-11 * random.standard_normal(count))
    start = mdr.Homogeneous(GEL.replace(modulus=500.0, exponent=0.3))
    result = mdi.fit(data, TIP, start, ["modulus", "exponent", "depth_offset"])
    assert process_time() - begun < 5.0
    assert np.sqrt(np.mean((data.given - path) ** 2)) < 4.0 * noise / math.sqrt(count / 6)
    assert result.estimates["modulus"] == pytest.approx(1e3, rel=0.01)
    assert result.estimates["exponent"] == pytest.approx(0.2, abs=0.004)


def test_creep():
    medium = mdr.Homogeneous(POLYMER)
    time = np.linspace(0.0, 5.0, 200)
    force = np.minimum(time / 0.2, 1.0) * 1e-9
    depth = mdr.Contact(TIP, medium).history(time, force=force).depth
    noisy = depth + 1e-10 * np.random.default_rng(5).standard_normal(time.size) + 20e-9
    data = mdi.DepthTime(time, force + 0.1e-9, noisy, sd=1e-10)
    free = ["relaxed_shear_modulus", "terms[0].modulus", "terms[1].modulus", "terms[1].time", "depth_offset"]
    start = mdr.Homogeneous(mdr.Viscoelastic(400.0, [(400.0, 0.1), (300.0, 2.0)], bulk_modulus=5e3))
    instrument = mdi.Instrument(depth_offset=15e-9, force_offset=0.1e-9)
    result = mdi.fit(data, TIP, start, free, instrument=instrument)
    within(result, {"relaxed_shear_modulus": 300.0, "terms[1].time": 1.0, "depth_offset": 20e-9})


def test_dynamic_stiffness_of_a_layered_body():
    """Exact, not proportional, with both parts of k* and a frame in series."""
    film = mdr.Viscoelastic(1e6, [(2e6, 0.01)], nu=0.45)
    medium = mdr.Coated(film, 1e-6, mdr.Elastic(1e8, 0.3))
    omega, radius = np.geomspace(1.0, 1e4, 15), 0.7e-6
    k = mdr.Contact(TIP, medium).dynamic_stiffness(omega, radius=radius)
    k = 1.0 / (1.0 / k + 0.02)
    random = np.random.default_rng(7)
    noisy = k + 0.005 * np.abs(k) * (random.standard_normal(15) + 1j * random.standard_normal(15))
    data = mdi.DynamicStiffness(omega, noisy, radius, relative_sd=0.005)
    assert len(data) == 30
    start = medium.replace(coating=mdr.Viscoelastic(2e6, [(1e6, 0.1)], nu=0.45))
    truth = {"coating.relaxed_shear_modulus": 1e6, "coating.terms[0].modulus": 2e6, "coating.terms[0].time": 0.01}
    result = mdi.fit(data, TIP, start, list(truth), instrument=mdi.Instrument(frame_compliance=0.02))
    within(result, truth)
    assert result.describes_data
    figure = result.plot()
    assert all(panel.x.log for panel in figure.panels) and figure.panels[0].y.log
    assert [part.name for part in figure.panels[0].parts] == ["data", "fit (exact), storage", "fit (exact), loss"]


def test_bad_input():
    start = mdr.Homogeneous(GEL)
    good = force_time(start, offset=0.0)

    def refused(words, data=good, medium=start, free=("modulus",), **options):
        with pytest.raises(mdr.MDRError, match=words):
            mdi.fit(data, TIP, medium, free, **options)

    refused("viscoelastic", medium=start, instrument=mdi.Instrument(work_of_adhesion=0.05))
    refused("frame_compliance", instrument=mdi.Instrument(frame_compliance=1e-3))
    refused("rigid", instrument=mdi.Instrument(indenter=mdr.Elastic(1e9, 0.3)))
    refused("body is elastic", medium=mdr.Homogeneous(mdr.Elastic(1e3, 0.5)), free=("E",))
    refused(
        "ForceTime, DepthTime or DynamicStiffness", data=mdi.ForceDepth(np.linspace(1e-8, 6e-7, 50), np.linspace(0.0, 1e-9, 50))
    )
    refused("exponent", free=("exponnt",))
    refused("no point is in contact", instrument=mdi.Instrument(depth_offset=1e-3))
    refused("equal time", medium=mdr.Homogeneous(mdr.Viscoelastic(1.0, [(1.0, 2.0), (1.0, 2.0)], nu=0.5)))
    refused("above 0", medium=mdr.Homogeneous(mdr.Viscoelastic(0.0, [(1.0, 2.0)], nu=0.5)), free=("relaxed_shear_modulus",))
    refused("bounds", free={"exponent": mdi.Free(0.2, lower=0.3)})
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 3 of time = 1: times must ascend"):
        mdi.ForceTime([0.0, 1.0, 1.0], [0.0, 1.0, 2.0], [0.0, 1.0, 2.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="same length"):
        mdi.ForceTime([0.0, 1.0], [0.0, 1.0, 2.0], [0.0, 1.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="one largest value"):
        mdi.ForceTime(TIME, np.sin(10.0 * TIME), TIME)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="same length"):
        mdi.DynamicStiffness([1.0, 2.0], [1.0 + 1j], 1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="same length"):
        mdi.DynamicStiffness([1.0, 2.0], [1.0 + 1j, 2.0 + 1j], 1.0, sd=[0.1, 0.1, 0.1])
    assert len(mdi.ForceTime([float("nan")], [1.0], [1.0], missing="drop")) == 0  # which fits refuse
    data = mdi.DynamicStiffness([1.0, 2.0], [1.0 + 1j, 2.0 + 1j], [1.0, -1.0])
    refused("radius", data=data)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="not finite"):
        mdi.DepthTime([0.0, math.nan], [0.0, 1.0], [0.0, 1.0])


def test_command_line(tmp_path):
    """The example's truth lies in its intervals; frequencies in hertz are cycles."""
    from pathlib import Path

    folder = Path(__file__).parents[2] / "examples" / "fit"
    out = tmp_path / "fit.json"
    assert main(["fit", str(folder / "gel_in_time.csv"), "--problem", str(folder / "gel_in_time.toml"), "--json", str(out)]) == 0
    found = json.loads(out.read_text())["parameters"]
    truth = {"coating.modulus": 400.0, "coating.exponent": 0.18, "thickness": 4e-6, "depth_offset": 0.35e-6}
    for name, value in truth.items():
        lower, upper = found[name]["interval"]
        assert lower < value < upper

    omega = np.geomspace(1.0, 100.0, 12)
    k = mdr.Contact(TIP, mdr.Homogeneous(GEL)).dynamic_stiffness(omega, radius=1e-6)
    table = tmp_path / "k.csv"
    columns = np.column_stack([omega / (2.0 * np.pi), k.real, k.imag])
    np.savetxt(table, columns, delimiter=",", header="frequency [Hz],storage [N/m],loss [N/m]", comments="")
    problem = tmp_path / "k.toml"
    problem.write_text(
        '[indenter]\nshape = "flat-punch"\nradius = "1 um"\n[medium]\ntype = "homogeneous"\n'
        'material = { modulus = "1500 Pa", time = "1 s", exponent = 0.25, nu = 0.5 }\n'
        '[data]\nkind = "dynamic-stiffness"\ncontact_radius = "1 um"\n[fit]\nfree = ["modulus", "exponent"]\n'
    )
    assert main(["fit", str(table), "--problem", str(problem), "--json", str(out), "--overwrite"]) == 0
    found = json.loads(out.read_text())["parameters"]
    assert found["modulus"]["value"] == pytest.approx(1e3, rel=1e-5)
    assert found["exponent"]["value"] == pytest.approx(0.2, rel=1e-5)


@pytest.mark.parametrize(("unit", "per_unit"), [("hertz", 1.0), ("cps", 1.0), ("Bq", 1.0), ("kHz", 1e3), ("rpm", 1.0 / 60.0)])
@pytest.mark.parametrize("where", ["title", "row", "key"])
def test_the_unit_of_a_frequency_decides_not_its_spelling(unit, per_unit, where, tmp_path):
    """The time of a relaxation goes as 1 over the frequency: a unit taken for another is an error of 2 pi."""
    head = {"title": f"frequency [{unit}],storage [N/m],loss [N/m]", "row": f"frequency,storage,loss\n{unit},N/m,N/m"}
    table, problem = tmp_path / "k.csv", tmp_path / "k.toml"
    table.write_text(head.get(where, "frequency,storage [N/m],loss [N/m]") + "\n0.5,3,1\n2,4,2\n")
    problem.write_text(
        '[indenter]\nshape = "flat-punch"\nradius = "1 um"\n[medium]\ntype = "homogeneous"\n'
        'material = { modulus = "1500 Pa", time = "1 s", exponent = 0.25, nu = 0.5 }\n'
        '[data]\nkind = "dynamic-stiffness"\ncontact_radius = "1 um"\n'
        + (f'units = {{ frequency = "{unit}" }}\n' if where == "key" else "")
        + '[fit]\nfree = ["modulus", "exponent"]\n'
    )
    data, notes = load_fit_file(problem).read_data(table)
    assert np.unique(data.x) == pytest.approx(2.0 * np.pi * per_unit * np.array([0.5, 2.0]), rel=1e-14)
    if unit != "rpm":
        assert any(f"in {unit}, times 2 pi" in note for note in notes)


@pytest.mark.parametrize("loss", ["linear", "huber"])
@pytest.mark.parametrize("force", [1.45e-6, 1.4829e-6, 1.5e-6, 1.6e-6])
def test_one_reading_does_not_determine_two_moduli(force, loss):
    """The others are 0 whatever the moduli are: the matrix of the fit is singular, and noise of rounding gives no variances."""
    body = mdr.Homogeneous(mdr.Viscoelastic(1e6, [(2e6, 1.0)], nu=0.49))
    data = mdi.ForceTime([0.0, 1.5, 3.0], [0.0, 1.5e-7, 0.3e-7], [0.0, force, 0.0])
    found = mdi.fit(data, mdr.Paraboloid(5e-6), body, ["terms[0].modulus", "relaxed_shear_modulus"], loss=loss)
    assert found.warnings[0].startswith("the data do not determine relaxed_shear_modulus and terms[0].modulus together")
    assert all(found.standard_errors[name] > 100.0 * found.estimates[name] for name in found.names)
    assert found.as_text("terms[0].modulus") == "not determined"
