# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of layers that are not isotropic, bonded or free of stress: curves of known constants give them back within their errors."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import OXIDE, SILICON

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main

TIP = mdr.Sphere(5e-6)
GAN = mdr.TransverselyIsotropic(390e9, 145e9, 106e9, 398e9, 105e9)
FIBRES = mdr.TransverselyIsotropic.from_engineering(10e9, 25e9, 0.2, 0.15, 3e9)
GLUE = mdr.Interface(normal=2e17, tangential=1e17)
FILM = mdr.Layered([mdr.Layer(GAN, 1e-6, 0.0, GLUE)], SILICON)


def curve(medium, rng, sd=0.003, largest=4e-7):
    depth = np.linspace(largest / 30.0, largest, 30)
    force = np.asarray(mdr.Contact(TIP, medium).at_depth(depth).force)
    return mdi.ForceDepth(depth, force * (1.0 + sd * rng.standard_normal(30)), sd=sd * force)


CASES = [
    (FILM, "layers[0].C44"),
    (FILM, "layers[0].C13"),
    (FILM, "layers[0].interface.normal"),
    (FILM, "layers[0].interface.tangential"),
    (mdr.Layered([mdr.Layer(GAN, 1e-6, 3e9)], mdr.Elastic(20e9, 0.3)), "layers[0].prestress"),
    (mdr.Layered([mdr.Layer(OXIDE, 5e-7, interface=mdr.SLIDING), (SILICON, 2e-7)], FIBRES), "substrate.G_z"),
    (mdr.Coated(FIBRES, 5e-7, mdr.SMOOTH), "coating.nu_tz"),
    (mdr.Coated(GAN, 5e-7, mdr.RIGID), "coating.C33"),
    (mdr.Homogeneous(GAN), "C11"),
    (mdr.Homogeneous(FIBRES), "E_t"),
    (mdr.Pair(mdr.Coated(OXIDE, 5e-7, SILICON), mdr.Homogeneous(GAN)), "upper.C44"),
]


@pytest.mark.parametrize(("medium", "name"), CASES, ids=[name for _, name in CASES])
def test_a_constant_is_found_where_it_was(medium, name):
    """From a start 20 % off, without noise: the value itself."""
    depth = np.linspace(1e-8, 4e-7, 25)
    data = mdi.ForceDepth(depth, np.asarray(mdr.Contact(TIP, medium).at_depth(depth).force), relative_sd=1e-3)
    truth = medium.parameters()[name]
    result = mdi.fit(data, TIP, medium, {name: 0.8 * truth})
    assert result.converged
    assert abs(result.estimates[name] - truth) < 1e-3 * result.standard_errors[name] + 1e-6 * abs(truth)
    assert result.medium.parameters()[name] == pytest.approx(truth, rel=1e-6, abs=1e-3 * result.standard_errors[name])


@pytest.mark.parametrize(
    ("medium", "names"),
    [
        (FILM, ["layers[0].C44"]),
        (FILM, ["layers[0].interface.normal"]),
        (FILM, ["layers[0].C44", "layers[0].interface.normal"]),
        (mdr.Layered([mdr.Layer(GAN, 1e-6, 0.0)], mdr.Elastic(20e9, 0.3)), ["layers[0].prestress", "substrate.E"]),
    ],
)
def test_errors_cover_the_truth_as_often_as_they_say(medium, names):
    """Random readings: two standard errors hold the truth in 95 of 100 curves, and the errors themselves have variance 1."""
    rng = np.random.default_rng(20261)
    z = []
    for _ in range(60):
        result = mdi.fit(curve(medium, rng), TIP, medium, names)
        truth = medium.parameters()
        z.append([(result.estimates[name] - truth[name]) / result.standard_errors[name] for name in names])
    inside = np.mean(np.abs(z) < 1.96)
    assert 0.95 - 3.5 * np.sqrt(0.95 * 0.05 / 60) < inside
    assert 0.65 < np.std(z) < 1.35
    assert abs(np.mean(z)) < 3.5 / np.sqrt(60)


def test_random_bodies_give_their_constants_back():
    rng = np.random.default_rng(7)
    for _ in range(25):
        scale = np.exp(rng.normal(0.0, 0.3, 5))
        layer = mdr.TransverselyIsotropic.from_engineering(*(np.array([300e9, 200e9, 0.2, 0.15, 100e9]) * scale))
        springs = mdr.Interface(normal=10 ** rng.uniform(16.5, 18.0), tangential=10 ** rng.uniform(16.5, 18.0))
        medium = mdr.Layered([mdr.Layer(layer, rng.uniform(3e-7, 1e-6), 0.0, springs), (OXIDE, 3e-7)], SILICON)
        name = ["layers[0].G_z", "layers[0].E_z", "layers[0].interface.normal", "layers[0].prestress"][rng.integers(4)]
        result = mdi.fit(curve(medium, rng), TIP, medium, [name])
        truth = medium.parameters()[name]
        assert abs(result.estimates[name] - truth) < 4.5 * result.standard_errors[name]


def with_noise(values, rng, sd=0.003):
    return np.asarray(values) * (1.0 + sd * rng.standard_normal(len(values))), sd * np.abs(values)


SPRINGS = "layers[0].interface.normal"
DEPTH, RADIUS = np.linspace(1e-8, 4e-7, 30), np.geomspace(1e-7, 3e-6, 25)


def moduli(rng):
    y, sd = with_noise(FILM.modulus(RADIUS), rng)
    return mdi.ModulusRadius(RADIUS, y, sd=sd), TIP, FILM, {}, {}


def stiffnesses(rng):
    y, sd = with_noise(FILM.stiffness(RADIUS), rng)
    return mdi.StiffnessRadius(RADIUS, y, sd=sd), TIP, FILM, {}, {}


def dynamic(rng):
    states = mdr.Contact(TIP, FILM).at_depth(DEPTH)
    y, sd = with_noise(states.stiffness, rng)
    return mdi.StiffnessDepth(DEPTH, np.asarray(states.force), y, sd=sd, elastic=True), TIP, FILM, {}, {}


def calibrated_tip(rng):
    tip = mdr.AreaFunction([24.5, 2e-6], max_height=1e-6)
    y, sd = with_noise(mdr.Contact(tip, FILM).at_depth(DEPTH).force, rng)
    return mdi.ForceDepth(DEPTH, y, sd=sd), tip, FILM, {"indenter.C1": mdi.Free(prior=(2e-6, 1e-8))}, {}


def pair(rng):
    medium = mdr.Pair(FILM, mdr.Elastic(1141e9, 0.07))
    y, sd = with_noise(mdr.Contact(TIP, medium).at_depth(DEPTH).force, rng)
    return mdi.ForceDepth(DEPTH, y, sd=sd), TIP, medium, {}, {"loss": "huber"}


def adhesion(rng):
    layer = mdr.TransverselyIsotropic.from_engineering(10e6, 25e6, 0.2, 0.15, 3e6)
    medium = mdr.Layered([mdr.Layer(layer, 1e-6, 0.0, mdr.Interface(normal=2e13))], mdr.Elastic(50e6, 0.4))
    depth = np.linspace(-2e-8, 3e-7, 40)
    force = np.asarray(mdr.Contact(TIP, medium, work_of_adhesion=0.05).at_depth(depth).force)
    sd = 0.003 * np.max(force)
    data = mdi.ForceDepth(depth, force + sd * rng.standard_normal(40), sd=sd)
    return data, TIP, medium, {"work_of_adhesion": 0.04, "layers[0].G_z": 2.5e6}, {}


@pytest.mark.filterwarnings("ignore::mdrcontact.errors.LargeStrainWarning")
@pytest.mark.parametrize("make", [moduli, stiffnesses, dynamic, calibrated_tip, pair, adhesion])
def test_all_data_tips_pairs_and_adhesion(make):
    """Springs from every kind of data, and with what else may be free or known beforehand."""
    data, tip, medium, also, options = make(np.random.default_rng(3))
    truth = {**medium.parameters(), "work_of_adhesion": 0.05, "indenter.C1": 2e-6}
    result = mdi.fit(data, tip, medium, {SPRINGS: 0.75 * truth[SPRINGS], **also}, **options)
    assert result.converged
    for name in (SPRINGS, *also):
        assert abs(result.estimates[name] - truth[name]) < 3.5 * result.standard_errors[name] < 0.5 * abs(truth[name])


def test_what_the_readings_do_not_depend_on_is_refused():
    rng = np.random.default_rng(3)
    for medium, name in [(FILM, "layers[0].C12"), (mdr.Homogeneous(GAN), "C12")]:
        with pytest.raises(
            mdr.errors.InvalidArgumentError, match=r"C12: it must not be free, because the readings do not depend on it"
        ):
            mdi.fit(curve(medium, rng), TIP, medium, [name])
        known = mdi.Free(prior=(145e9, 5e9))
        assert mdi.fit(curve(medium, rng), TIP, medium, {name: known}).standard_errors[name] == pytest.approx(5e9, rel=1e-3)
    both = mdi.fit(curve(mdr.Homogeneous(GAN), rng), TIP, mdr.Homogeneous(GAN), ["C44", "C11"])
    assert any("do not determine C11 and C44 together" in words for words in both.warnings)


@pytest.mark.parametrize(("medium", "free", "words"), [
    (mdr.Layered([mdr.Layer(GAN, 1e-6)], SILICON), ["layers[0].interface.normal"], "'layers.0..interface.normal': "),
    (mdr.Coated(GAN, 1e-6, SILICON), ["prestress"], "free parameter 'prestress'"),
    (FILM, {"layers[0].interface.normal": 0.0}, "must begin above 0"),
    (mdr.Layered([(OXIDE, 1e-6)], SILICON, "gao"), {"layers[0].prestress": 1e9}, "not isotropic, bonded and free of stress"),
])  # fmt: skip
def test_refusals_say_why(medium, free, words):
    data = curve(FILM, np.random.default_rng(1))
    with pytest.raises(mdr.MDRError, match=words):
        mdi.fit(data, TIP, medium, free)


def test_problem_files_and_the_command_line(tmp_path, capsys):
    data = curve(FILM, np.random.default_rng(5))
    rows = "\n".join(f"{x * 1e9:.9g},{y * 1e3:.9g}" for x, y in zip(data.x, data.y, strict=True))
    measured, problem, found = tmp_path / "curve.csv", tmp_path / "glue.toml", tmp_path / "fit.json"
    measured.write_text(f"depth_nm,force_mN\n{rows}\n")
    problem.write_text(PROBLEM)
    assert main(["fit", str(measured), "--problem", str(problem), "--json", str(found)]) == 0
    text = capsys.readouterr().out
    assert "normal stiffness of the interface below the film" in text and "GPa/\N{MICRO SIGN}m" in text
    answer = json.loads(found.read_text())["parameters"]
    for name in ("layers[0].interface.normal", "layers[0].C44"):
        value, error = answer[name]["value"], answer[name]["standard_error"]
        assert abs(value - FILM.parameters()[name]) < 4.0 * error < value
    problem.write_text(PROBLEM.replace('[fit.free."layers[0].C44"]', '[fit.free."layers[0].C12"]'))
    assert main(["fit", str(measured), "--problem", str(problem)]) == 0
    problem.write_text(PROBLEM.split("[fit.free")[0] + '[fit]\nfree = ["layers[0].C12"]\n')
    assert main(["fit", str(measured), "--problem", str(problem)]) == 1
    assert "layers[0].C12: it must not be free, because the readings do not depend on it" in capsys.readouterr().err


PROBLEM = """
[indenter]
shape = "sphere"
radius = "5 um"

[medium]
type = "coated"
substrate = { E = "163 GPa", nu = 0.22 }
[medium.coating]
material = "GaN"
thickness = "1 um"
interface = { normal = "100 GPa/um", tangential = "100 GPa/um" }

[data]
kind = "force-depth"
relative_sd = 0.003

[fit.free."layers[0].interface.normal"]
lower = "1 GPa/um"
[fit.free."layers[0].C44"]
prior = "100 GPa"
prior_sd = "20 GPa"
"""
