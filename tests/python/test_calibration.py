# SPDX-License-Identifier: GPL-3.0-or-later
"""Tip and frame from indents into a known body, and the file that later fits read."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import ROOT
from records import REDUCED, indentation

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.fitting.calibration import together, words_of_tests
from mdrcontact.instruments.fitting.quantities import dimension_of

DIAMOND = mdr.Elastic(1141e9, 0.07)
NU = 0.17
SILICA = (1.0 - NU**2) / (1.0 / REDUCED - 1.0 / DIAMOND.contact_modulus)
C1, FRAME = 1500e-9, 2e-7
TIP = mdr.AreaFunction([24.5, 0.0], max_height=1e-6)
TOOL = mdi.Instrument(indenter=DIAMOND)
KNOWN = mdr.Homogeneous(mdr.Elastic(SILICA, NU))

CALIBRATE = f"""
title = "Silica"
[indenter]
shape = "area-function"
coefficients = [24.5, 0]
length_unit = "nm"
max_height = "1 um"
[medium]
type = "homogeneous"
material = {{ E = "{SILICA} Pa", nu = {NU} }}
[instrument]
indenter = {{ E = "1141 GPa", nu = 0.07 }}
[data]
kind = "unloading"
[fit.free]
"indenter.C0" = {{ prior = 24.5, prior_sd = 0.5 }}
"indenter.C1" = {{}}
frame_compliance = {{}}
"""
MEASURE = """
title = "Film"
[indenter]
file = "tip.toml"
[medium]
type = "homogeneous"
material = { E = "60 GPa", nu = 0.17 }
[instrument]
indenter = { E = "1141 GPa", nu = 0.07 }
[data]
kind = "unloading"
[fit.free]
E = {}
"""


def write_curve(path, force, seed):
    _, h, p, _ = indentation(force, c1=C1, frame=FRAME, seed=seed, noise=2e-4 * force, creep=1e-9)
    np.savetxt(path, np.column_stack([1e9 * h, 1e3 * p]), header="Depth (nm)\tLoad (mN)", comments="", delimiter="\t")


@pytest.fixture
def folder(tmp_path):
    """Six indents into silica, one into something else, and the problem files."""
    (tmp_path / "silica").mkdir()
    for i, force in enumerate(np.geomspace(0.5e-3, 10e-3, 6)):
        write_curve(tmp_path / "silica" / f"{i}.txt", force, i)
    write_curve(tmp_path / "film.txt", 3e-3, 17)
    (tmp_path / "calibrate.toml").write_text(CALIBRATE)
    (tmp_path / "measure.toml").write_text(MEASURE)
    return tmp_path


def calibrate(folder, *more):
    given = ["calibrate", str(folder / "silica"), "--problem", str(folder / "calibrate.toml"), "--output", str(folder / "tip.toml")]
    return main([*given, *more])


def test_from_indents_to_a_tip_to_a_modulus(folder, capsys):
    """The calibration finds tip and frame; the measurement reads them, and its interval is wider than with a tip without errors."""
    assert calibrate(folder, "--plot", str(folder / "tip.png"), "--report", str(folder / "tip.html")) == 0
    assert (folder / "tip.png").read_bytes().startswith(b"\x89PNG")
    text = (folder / "tip.toml").read_text()
    assert 'shape = "area-function"' in text and "[calibration]" in text
    assert main(["fit", str(folder / "film.txt"), "--problem", str(folder / "measure.toml"), "--json", str(folder / "a.json")]) == 0
    found = json.loads((folder / "a.json").read_text())["parameters"]
    assert set(found) == {"E", "indenter.C0", "indenter.C1", "frame_compliance"}
    assert abs(found["indenter.C1"]["value"] - C1) < 3.0 * found["indenter.C1"]["standard_error"]
    assert abs(found["frame_compliance"]["value"] - FRAME) < 3.0 * found["frame_compliance"]["standard_error"]
    assert abs(found["E"]["value"] - SILICA) < 3.0 * found["E"]["standard_error"]
    fixed = text.partition("[calibration]")[0]
    (folder / "tip.toml").write_text(fixed)
    frame = found["frame_compliance"]["value"]
    certain = MEASURE.replace("[data]", f'frame_compliance = "{frame} m/N"\n[data]')
    (folder / "measure.toml").write_text(certain)
    assert main(["fit", str(folder / "film.txt"), "--problem", str(folder / "measure.toml"), "--json", str(folder / "b.json")]) == 0
    narrow = json.loads((folder / "b.json").read_text())["parameters"]["E"]
    assert narrow["value"] == pytest.approx(found["E"]["value"], rel=5e-3)
    assert narrow["standard_error"] < 0.9 * found["E"]["standard_error"]


def test_the_tip_presses_in_other_commands_too(folder, capsys):
    assert calibrate(folder) == 0
    problem = MEASURE.partition("[instrument]")[0] + '[compute]\ndepths = ["100 nm"]\n'
    (folder / "curve.toml").write_text(problem)
    capsys.readouterr()
    assert main(["curve", str(folder / "curve.toml")]) == 0
    assert "force [mN]" in capsys.readouterr().out


def test_the_radius_of_a_ball(folder, capsys):
    """A sphere instead: CSM data of a ball of 5 um on silica."""
    ball = mdr.Sphere(5e-6)
    contact_depth = np.linspace(20e-9, 200e-9, 30)
    a = np.sqrt(2.0 * 5e-6 * contact_depth - contact_depth**2)
    stiffness = 2.0 * a * REDUCED * (1.0 + 0.005 * np.random.default_rng(0).standard_normal(30))
    force = 5e9 * np.pi * a**2
    table = np.column_stack([1e9 * (contact_depth + 0.75 * force / (2.0 * a * REDUCED)), 1e3 * force, stiffness])
    np.savetxt(folder / "csm.csv", table, header="h_nm,P_mN,S_N_per_m", comments="", delimiter=",")
    text = CALIBRATE.replace('kind = "unloading"', 'kind = "stiffness-depth"\nrelative_sd = 0.005')
    head, _, tail = text.partition("[medium]")
    tail = tail.partition("[fit.free]")[0] + '[fit.free]\n"indenter.radius" = {}\n'
    (folder / "ball.toml").write_text('title = "Ball"\n[indenter]\nshape = "sphere"\nradius = "4 um"\n[medium]' + tail)
    given = ["calibrate", str(folder / "csm.csv"), "--problem", str(folder / "ball.toml"), "--output", str(folder / "tip.toml")]
    assert main(given) == 0
    from mdrcontact.problem.toml import parse_file

    found = parse_file(folder / "tip.toml")
    radius = float(found["indenter"]["radius"].split()[0])
    sd = float(found["calibration"]["sds"][0].split()[0])
    assert abs(radius - ball.radius) < 3.0 * sd and sd < 0.01 * radius
    # again from this tip, and with the unit in the key
    again = (folder / "ball.toml").read_text()
    for number, indenter in enumerate(('file = "tip.toml"', 'shape = "sphere"\nradius_um = 4')):
        (folder / "ball.toml").write_text(again.replace('shape = "sphere"\nradius = "4 um"', indenter))
        assert main([*given[:-1], str(folder / f"tip{number}.toml")]) == 0
        same = parse_file(folder / f"tip{number}.toml")["indenter"]
        assert set(same) == {"shape", "radius"} and float(same["radius"].split()[0]) == pytest.approx(radius, rel=1e-3)


def test_python_takes_a_calibration_as_a_prior():
    columns = [mdi.Unloading(*indentation(f, c1=C1, seed=i)[1:3]) for i, f in enumerate((1e-3, 3e-3, 9e-3))]
    free = {"indenter.C0": mdi.Free(prior=(24.5, 0.5)), "indenter.C1": None}
    tip = mdi.fit(together(columns), TIP, KNOWN, free, instrument=TOOL)
    prior = mdi.as_prior(tip)
    assert prior.names == ("indenter.C0", "indenter.C1")
    film = mdi.fit(columns[1], tip.indenter, mdr.Homogeneous(mdr.Elastic(60e9, NU)), ["E"], instrument=TOOL, known=[prior])
    assert abs(film.estimates["E"] - SILICA) < 3.0 * film.standard_errors["E"]


def cycles(random, apart):
    """Eight cycles into silica with 0.3 % noise, whose depths are off together by drift."""
    contact_depth = np.linspace(2e-7, 1.5e-6, 8)
    area = 24.5 * contact_depth**2
    stiffness, force = 2.0 * REDUCED * np.sqrt(area / np.pi), 9e9 * area
    depth = (contact_depth + 0.75 * force / stiffness) * (1.0 + apart * random.standard_normal())
    data = mdi.StiffnessDepth(
        depth, force, stiffness * (1.0 + 3e-3 * random.standard_normal(8)), sd=3e-3 * stiffness, elastic=False
    )
    data.unloadings = ("as of a record",)
    return data


@pytest.mark.parametrize("apart", [0.0, 0.02])
def test_tests_that_differ_as_wholes(apart):
    """What a calibration is off is as large as its error, whether the tests agree or drift; by their readings alone it was three
    times that, and nothing said so."""
    random, tip = np.random.default_rng(5), mdr.AreaFunction([24.0], max_height=5e-6)
    off, words = [], []
    for _ in range(30):
        found = mdi.fit(together([cycles(random, apart) for _ in range(6)]), tip, KNOWN, ["indenter.C0"], instrument=TOOL)
        prior = mdi.as_prior(found)
        off.append((prior.values[0] - 24.5) / np.sqrt(prior.covariance[0][0]))
        words += words_of_tests(found)
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.5
    assert (len(words) > 27 and "differ as wholes by" in words[0]) if apart else len(words) < 4


def test_mean_of_dynamic_curves():
    """The standard error of the mean of 9 curves with 3 % scatter is 1 %."""
    depth = np.linspace(50e-9, 200e-9, 40)
    random = np.random.default_rng(3)
    curves = [
        mdi.StiffnessDepth(depth, 1e-3 * depth / 1e-7, 5e4 * depth / 1e-7 * (1.0 + 0.03 * random.standard_normal(40)))
        for _ in range(9)
    ]
    mean = together(curves)
    assert mean.sd is not None and mean.sd / mean.y == pytest.approx(np.full(40, 0.01), rel=0.15)
    with pytest.raises(mdr.MDRError, match="in common"):
        together([curves[0], mdi.StiffnessDepth(depth + 1e-6, depth, depth)])


@pytest.mark.parametrize(
    ("change", "words", "status"),
    [
        (
            lambda f: (f / "calibrate.toml").write_text(CALIBRATE.replace('"indenter.C1" = {}', "E = {}")),
            "'E' is no number of the tip",
            2,
        ),
        (lambda f: (f / "calibrate.toml").write_text(CALIBRATE.replace("unloading", "force-depth")), "kind must be", 2),
        (lambda f: [p.unlink() for p in (f / "silica").iterdir()], "there is no file of measurements", 2),
        (lambda f: (f / "tip.toml").write_text(""), "exists", 1),
    ],
)
def test_what_cannot_be_calibrated(folder, capsys, change, words, status):
    change(folder)
    assert calibrate(folder) == status
    assert words in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "cannot be read"),
        ("junk", "not valid TOML"),
        ("[tip]\n", "no table [indenter]"),
        ('[indenter]\nshape = "sphere"\nradius = "1 um"\n[calibration]\nnames = ["indenter.C9"]\n', "indenter.C9"),
        ('[indenter]\nshape = "sphere"\nradius = "1 um"\n[calibration]\nvalues = []\n', "names"),
        ('[indenter]\nshape = "sphere"\nradius = "1 um"\n[calibration]\nnames = 5\n', "names must be a list"),
        ('[indenter]\nshape = "sphere"\nradius = "1 um"\n[calibration]\nnames = ["frame_compliance"]\nvalues = []\n', "1 entries"),
        ('calibration = 3\n[indenter]\nshape = "sphere"\nradius = "1 um"\n', "must be a table"),
    ],
)
def test_bad_tip_files(folder, capsys, text, words):
    if text is not None:
        (folder / "tip.toml").write_text(text)
    assert main(["fit", str(folder / "film.txt"), "--problem", str(folder / "measure.toml")]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize("given", ["fit = 3", "fit = { joint_prior = 3 }", "instrument = 3"])
def test_tables_beside_a_tip_that_are_none(folder, capsys, given):
    (folder / "tip.toml").write_text('[indenter]\nshape = "sphere"\nradius = "1 um"\n[calibration]\nnames = ["indenter.radius"]\n')
    body = MEASURE.partition("[instrument]")[0] + '[data]\nkind = "unloading"\n'
    (folder / "measure.toml").write_text(f"{given}\n{body}" + ("" if given.startswith("fit") else "[fit.free]\nE = {}\n"))
    assert main(["fit", str(folder / "film.txt"), "--problem", str(folder / "measure.toml")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_units_of_an_area_function():
    """A = C0 h^2 + C1 h + C2 sqrt(h) + ...: C1 is a length, C2 a length^1.5."""
    assert [dimension_of(f"indenter.C{i}").si for i in (1, 2, 3)] == ["m^1", "m^1.5", "m^1.75"]


def test_terms_of_an_area_function_may_begin_at_zero():
    """A term has the size of the whole area: differences of that size once gave it twice its standard error."""
    problem = load_fit_file(ROOT / "examples" / "fit" / "csm_on_silica.toml")
    data, _ = problem.read_data(ROOT / "examples" / "fit" / "csm_on_silica.csv")
    found = mdi.fit(data, problem.indenter, problem.medium, problem.free, instrument=problem.instrument)
    assert found.iterations < 20
    assert found.interval("indenter.C1", method="profile") == pytest.approx(found.interval("indenter.C1"), rel=1e-3)
    assert found.standard_errors["indenter.C1"] == pytest.approx(3.7e-9, rel=0.1)


def test_the_last_term_of_an_area_function_is_an_area():
    """Next to the apex it is all of the area: searches went below 0, where there is no tip, and ended anywhere."""
    points = [
        mdi.Unloading(*indentation(1e-3 * 2.0**i, c1=C1, frame=FRAME, noise=2e-6, seed=10 * seed + i)[1:3])
        for seed in range(6)
        for i in range(6)
    ]
    data = together(points)
    assert np.all(np.diff(data.x) >= 0.0), "by depth"
    names = ["indenter.C0", "indenter.C1", "frame_compliance"]
    tip = mdr.AreaFunction([24.5, 0.0, 0.0], max_height=1e-6)
    few = mdi.fit(data, tip, KNOWN, names, instrument=TOOL)
    more = mdi.fit(data, tip, KNOWN, [*names, "indenter.C2"], instrument=TOOL)
    assert more.converged and more.chi_square <= few.chi_square * (1.0 + 1e-6)
    assert more.estimates["indenter.C2"] == 0.0 and "leave this term out" in more.summary()
    # a least height leaves room for any sign
    tip = mdr.AreaFunction([24.5, 0.0, 0.0], max_height=1e-6, min_height=20e-9)
    free = mdi.fit(data, tip, KNOWN, [*names, "indenter.C2"], instrument=TOOL)
    assert free.converged and not free.at_bound["indenter.C2"]
