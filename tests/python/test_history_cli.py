# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact history`: paths, materials of problem files, pictures, refusals."""

import csv
import io
import sys
import threading

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.problem import ProblemError, load, read

EXAMPLES = [
    path for path in sorted((ROOT / "examples" / "problems").glob("*.toml")) if "[history]" in path.read_text(encoding="utf-8")
]
POLYMER = {"relaxed_shear_modulus": "1 MPa", "moduli": ["2 MPa", "0.5 MPa"], "times": ["300 ms", "3 s"], "nu": 0.4}


def problem(history, material=POLYMER):
    """The tables of a problem."""
    return {
        "indenter": {"shape": "paraboloid", "radius": "1 mm"},
        "medium": {"type": "homogeneous", "material": material},
        "history": history,
    }


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_run_and_draw(path, tmp_path, capsys):
    plot, table = tmp_path / "history.png", tmp_path / "history.csv"
    assert main(["history", str(path), "--plot", str(plot), "--csv", str(table)]) == 0
    out, err = capsys.readouterr()
    assert err == "" and "largest force" in out and plot.stat().st_size > 5000
    with table.open(newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    assert [title.split()[0] for title in head] == ["time", "depth", "radius", "force"]
    wanted = load(path)
    path = wanted.history
    contact, given = wanted.contact(in_time=True), {path.name: path.values}
    if path.drainage is None:
        found = contact.history(path.time, **given)
    else:
        found = mdr.poroelastic.history(contact, path.time, **given, drainage=path.drainage)
    assert float(rows[-1][0]) == pytest.approx(found.time[-1], rel=1e-12) and len(rows) == len(found.time)


def test_paths():
    ramp = read(
        problem({"path": "ramp", "depth": "1 um", "rise_time": "1 s", "hold_time": "2 s", "fall_time": "1 s", "points": 40})
    )
    time, depth = ramp.history.time, ramp.history.values
    assert np.all(np.diff(time) > 0.0) and time[-1] == 4.0 and abs(len(time) - 41) <= 1
    assert depth == pytest.approx(1e-6 * np.interp(time, [0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 1.0, 0.0]), abs=1e-20)
    assert ramp.control.name == "depth" and ramp.control.values == [1e-6]
    short = read(problem({"path": "ramp", "force": "1 mN", "rise_time": "1 s", "hold_time": "999 s", "points": 40})).history
    assert np.count_nonzero(short.time <= 1.0) == 11  # a short rise is drawn with a quarter of the points
    sine = read(problem({"path": "sine", "depth": "1 um", "duration": "2 s"})).history
    assert sine.values[100] == 1e-6 and sine.values[-1] == 0.0
    triangle = read(problem({"path": "triangle", "force": "1 mN", "duration": "2 s"})).history
    assert triangle.name == "force" and triangle.values.max() == 1e-3
    step = read(problem({"path": "step", "depth": "1 um", "hold_time": "2 s", "points": 5})).history
    assert np.all(step.values == 1e-6)


def test_path_from_a_table(tmp_path):
    (tmp_path / "path.csv").write_text("t [ms],load [mN]\n0,0\n500,1\n1000,1\n", encoding="utf-8")
    tables = problem({"path": "file", "file": "path.csv", "control": "force"})
    path = read(tables, folder=tmp_path).history
    assert path.name == "force" and path.time.tolist() == [0.0, 0.5, 1.0] and path.values.tolist() == [0.0, 1e-3, 1e-3]
    for titles, words in (
        ("t [ms],load [g]", r"'load \[g\]' should be the force, but 'g' is no unit"),
        ("t [ms],d [nm]", "no column is the force: give it this title with the unit"),
    ):
        (tmp_path / "path.csv").write_text(f"{titles}\n0,0\n500,1\n1000,1\n", encoding="utf-8")
        with pytest.raises(ProblemError, match=words):
            read(tables, folder=tmp_path)


def test_materials():
    material = read(problem({"path": "step", "depth": "1 um", "hold_time": "2 s"})).medium.material
    assert material == mdr.Viscoelastic(1e6, [(2e6, 0.3), (0.5e6, 3.0)], nu=0.4)
    power = {"modulus": "1 kPa", "time": "1 s", "exponent": 0.2, "nu": 0.5}
    assert read(problem({"path": "step", "depth": "1 um", "hold_time": "2 s"}, power)).medium.material == mdr.PowerLawRheology(
        1e3, 1.0, 0.2, 0.5
    )


@pytest.mark.parametrize(
    ("history", "material", "words"),
    [
        ({"path": "spiral"}, POLYMER, "spiral"),
        ({"path": "ramp", "rise_time": "1 s"}, POLYMER, "one of depth, force and radius"),
        ({"path": "ramp", "depth": "1 um", "rise_time": "0 s"}, POLYMER, "greater than 0"),
        ({"path": "ramp", "depth": "1 um"}, POLYMER, "rise_time"),
        ({"path": "ramp", "depth": "1 um", "rise_time": "1 s", "duration": "1 s"}, POLYMER, "duration"),
        ({"path": "step", "depth": "1 um", "hold_time": "1 m"}, POLYMER, "a time"),
        (
            {"path": "step", "force": "-1 mN", "hold_time": "1 s"},
            POLYMER,
            "force = '-1 mN': it must be greater than 0",
        ),
        ({"path": "step", "depth": "1 um", "hold_time": "1 s"}, {**POLYMER, "bulk_modulus": "1 GPa"}, "either nu or bulk_modulus"),
        ({"path": "file", "file": "none.csv"}, POLYMER, "none.csv"),
        ({"path": "step", "depth": "1 um", "hold_time": "1 s"}, {**POLYMER, "times": ["1 s"]}, "the same number"),
        ({"path": "step", "depth": "1 um", "hold_time": "1 s"}, {**POLYMER, "E": "1 MPa"}, "'E'"),
        ({"path": "step", "depth": "1 um", "hold_time": "1 s"}, {"E": "1 MPa", "nu": 0.3, "times": ["1 s"]}, "'times'"),
    ],
)
def test_refusals(history, material, words):
    with pytest.raises(ProblemError, match=words):
        read(problem(history, material))


def test_commands_say_which_one_takes_time(tmp_path, capsys):
    text = EXAMPLES[0].read_text(encoding="utf-8")
    (tmp_path / "gel.toml").write_text(text, encoding="utf-8")
    for command, *more in ["curve"], ["compare"], ["stress"], ["law", str(tmp_path / "gel.law")]:
        assert main([command, str(tmp_path / "gel.toml"), *more]) == 2
        words = capsys.readouterr().err
        assert "gel.toml: [medium]: this command does not support viscoelastic bodies" in words
        assert "Use mdrcontact history" in words
    (tmp_path / "none.toml").write_text((ROOT / "examples/problems/sio2_on_si.toml").read_text(encoding="utf-8"), encoding="utf-8")
    assert main(["history", str(tmp_path / "none.toml")]) == 2
    assert "[history] is missing" in capsys.readouterr().err


def test_a_long_march_shows_how_far_it_is(monkeypatch):
    from mdrcontact import _progress

    class Terminal(io.StringIO):
        def isatty(self):
            return True

    film = mdr.Coated(mdr.Viscoelastic(1.0, [(2.0, 0.5)], nu=0.5), 1.0, mdr.Viscoelastic(0.6, [(0.4, 2.0)], nu=0.3))
    contact, time = mdr.Contact(mdr.Paraboloid(1.0), film), np.linspace(0.0, 2.0, 201)
    quiet = contact.history(time, depth=0.4 * time, tolerance=1e-4)
    monkeypatch.setattr(_progress, "LOOK", 0.01)
    for patience, shown in ((0.0, True), (60.0, False)):
        monkeypatch.setattr(sys, "stderr", terminal := Terminal())
        monkeypatch.setattr(_progress, "PATIENCE", patience)
        loud = contact.history(time, depth=0.4 * time, tolerance=1e-4, progress=True)
        assert np.array_equal(loud.force, quiet.force)
        assert ("round" in terminal.getvalue()) == shown
    threads = threading.active_count()
    with pytest.raises(mdr.errors.InvalidArgumentError, match="depth"):
        contact.history([0.0, 1.0], depth=[0.0, np.nan], progress=True)
    assert threading.active_count() == threads


def test_few_samples_of_a_path_are_cut(tmp_path, capsys):
    (tmp_path / "path.csv").write_text("time [s],depth [nm]\n0,0\n1,300\n2,600\n3,0\n", encoding="utf-8")
    material = "\n".join(f"{key} = {value!r}" for key, value in POLYMER.items())
    head = '[indenter]\nshape = "paraboloid"\nradius = "1 mm"\n[medium]\ntype = "homogeneous"\n[medium.material]\n' + material
    (tmp_path / "problem.toml").write_text(f'{head}\n[history]\npath = "file"\nfile = "path.csv"\n', encoding="utf-8")
    assert main(["history", str(tmp_path / "problem.toml"), "--csv", str(tmp_path / "out.csv")]) == 0
    lost = float(capsys.readouterr().out.split("energy lost: ")[1].split()[0])
    polymer = mdr.Viscoelastic(1e6, [(2e6, 0.3), (0.5e6, 3.0)], nu=0.4)
    time = np.linspace(0.0, 3.0, 3001)
    fine = mdr.Contact(mdr.Paraboloid(1e-3), mdr.Homogeneous(polymer)).history(time, depth=np.interp(time, [0, 2, 3], [0, 6e-7, 0]))
    assert lost * 1e-12 == pytest.approx(fine.work, rel=2e-3)
    assert len((tmp_path / "out.csv").read_text(encoding="utf-8").splitlines()) == 5
    (tmp_path / "path.csv").write_text("time [s],depth [nm]\n0,0\n1,300\n1,600\n3,0\n", encoding="utf-8")
    assert main(["history", str(tmp_path / "problem.toml")]) != 0
    assert "entry 3 of time" in capsys.readouterr().err
