# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary files of AFMs through afmformats, and maps of force curves."""

from __future__ import annotations

import json
import warnings

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact import studies
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.reading.afm import numbered, read_afm
from mdrcontact.instruments.reading.afm_curve import AfmCurve
from mdrcontact.panels import Cells

afmformats = pytest.importorskip("afmformats")
h5py = pytest.importorskip("h5py")

BALL, SPRING = mdr.Paraboloid(5e-6), 0.5
PROBLEM = """
title = "Map"
[indenter]
shape = "paraboloid"
radius = "5 um"
[medium]
type = "coated"
coating = { E = "50 kPa", nu = 0.49, thickness = "2 um" }
substrate = { E = "70 GPa", nu = 0.23 }
[data]
kind = "force-depth"
branch = "loading"
[fit.free]
"coating.E" = { lower = "100 Pa" }
depth_offset = {}
"""


def modulus(i):
    return 20e3 * (1 + i)


def write(path, columns=3, rows=2, **changed):
    """A map whose film modulus grows from place to place, in afmformats' HDF5."""
    depth = np.linspace(-600e-9, 300e-9, 150)
    with h5py.File(path, "w") as file:
        for i in range(columns * rows):
            film = mdr.Coated(mdr.Elastic(modulus(i), 0.49), 2e-6, mdr.Elastic(70e9, 0.23))
            force = np.zeros_like(depth)
            force[depth > 0.0] = np.asarray(mdr.Contact(BALL, film).at_depth(depth[depth > 0.0]).force)
            force += 0.2e-9 + 2e-11 * np.random.default_rng(i).standard_normal(depth.size)
            d, f = (np.concatenate([v, v[::-1]]) for v in (depth, force))
            meta = {
                "spring constant": SPRING,
                "sensitivity": 50e-9,
                "imaging mode": "force-distance",
                "grid index x": i % columns,
                "grid index y": i // columns,
                "enum": i,
                "path": path,
                **changed,
            }
            data = {"force": f, "height (measured)": 5e-6 - d - f / SPRING, "segment": np.repeat([0, 1], 150).astype(np.uint8)}
            afmformats.AFMForceDistance(data=data, metadata=meta).export_data(file, fmt="hdf5")


def test_a_map_is_fitted_place_by_place(tmp_path, capsys):
    write(tmp_path / "map.h5")
    (tmp_path / "problem.toml").write_text(PROBLEM)
    written = {kind: tmp_path / f"map.{kind}" for kind in ("json", "csv", "png", "html")}
    options = [f"--{o}={written[k]}" for o, k in (("json", "json"), ("csv", "csv"), ("plot", "png"), ("report", "html"))]
    assert main(["fit", str(tmp_path / "map.h5"), "--problem", str(tmp_path / "problem.toml"), *options]) == 0
    out = capsys.readouterr().out
    assert "6 of 6 curves fitted; 6 of 6 fits describe their data to 5 % or better" in out and "spring constant 0.5 N/m" in out
    found = json.loads(written["json"].read_text())
    for i in range(6):
        entry = found[f"map.h5 {i + 1}"]["parameters"]["coating.E"]
        assert abs(entry["value"] - modulus(i)) < 4.0 * entry["standard_error"] + 1e-3 * modulus(i)
    assert written["png"].read_bytes().startswith(b"\x89PNG")
    assert "6 of 6 curves fitted" in written["html"].read_text(encoding="utf-8")


def test_curves_of_a_file(tmp_path):
    write(tmp_path / "map.h5")
    curves = read_afm(tmp_path / "map.h5")
    assert [curve.place for curve in curves] == [(x, y) for y in (0, 1) for x in (0, 1, 2)]
    assert curves[0].height[0] < curves[0].height[149], "grows into the sample"
    assert [(s.kind, s.stop) for s in curves[0].segments] == [("loading", 150), ("unloading", 300)]
    soft = read_afm(tmp_path / "map.h5", spring_constant=0.25, deflection_sensitivity=100e-9)[0]
    assert soft.spring_constant == 0.25
    assert soft.force == pytest.approx(curves[0].force, rel=1e-12), "half the spring constant, twice the sensitivity"


MEANDER = ((0, 0), (1, 0), (1, 1), (0, 1))


def test_places_and_numbers_of_a_map_are_those_of_its_file(tmp_path):
    """A map that is recorded in a meander was numbered row by row, and its places were lost."""
    write(tmp_path / "map.h5", 2, 2)
    with h5py.File(tmp_path / "map.h5", "r+") as file:
        for count, (x, y) in enumerate(MEANDER):
            place = {"grid index x": x, "grid index y": y, "position x": 1e-5 * x, "position y": 1e-5 * y}
            file[str(count)].attrs.update(place)
    (tmp_path / "problem.toml").write_text(PROBLEM)
    written = {kind: tmp_path / f"map.{kind}" for kind in ("csv", "json")}
    options = [f"--{kind}={path}" for kind, path in written.items()]
    assert main(["fit", str(tmp_path / "map.h5"), "--problem", str(tmp_path / "problem.toml"), *options]) == 0
    titles, *rows = [line.split(",") for line in written["csv"].read_text().splitlines()]
    assert titles[:6] == ["file", "number", "x [um]", "y [um]", "column", "row"]
    found = json.loads(written["json"].read_text())
    for i, (row, (x, y)) in enumerate(zip(rows, MEANDER, strict=True)):
        assert row[:2] == [f"map.h5 {i + 1}", str(i + 1)] and row[4:6] == [str(x), str(y)]
        assert [float(cell) for cell in row[2:4]] == pytest.approx([10.0 * x, 10.0 * y])
        assert float(row[titles.index("coating.E [kPa]")]) == pytest.approx(1e-3 * modulus(i), rel=2e-3)
        entry = found[f"map.h5 {i + 1}"]
        assert entry["place"] == {
            "number": i + 1,
            "x": pytest.approx(1e-5 * x),
            "y": pytest.approx(1e-5 * y),
            "column": x,
            "row": y,
        }
        assert entry["parameters"]["coating.E"]["value"] == pytest.approx(modulus(i), rel=2e-3)


@pytest.mark.parametrize(("counts", "numbers"), [((2, 0, 5), (1, 3, 6)), ((0, 0, 1), (1, 2, 3)), ((None, 1, 2), (1, 2, 3))])
def test_numbers_are_those_by_which_a_file_counts(counts, numbers):
    """Where it does not count, or counts two as one, they are those of the order."""
    curve = AfmCurve(np.zeros(2), np.zeros(2), None, None, None, None, ())
    found = numbered([(count, curve._replace(number=-i)) for i, count in enumerate(counts)])
    assert tuple(one.number for one in found) == numbers


@pytest.mark.parametrize("text", ["", "# a\n# b c\n", "\t\n\t\n", "# segment: extend\n# x\n1e-6 2e-6\n2e-6 5e-6\n3e-6 9e-6\n"])
def test_no_warning_of_numpy_reaches_the_reader(text, tmp_path):
    """Of a text without numbers NumPy warned, and it was taken for a curve that does not say its sensitivity."""
    (tmp_path / "curve.txt").write_text(text)
    (tmp_path / "problem.toml").write_text(PROBLEM)
    file = load_fit_file(tmp_path / "problem.toml")
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter("always")
        with pytest.raises(mdr.MDRError, match="no table of numbers|no line above the numbers"):
            file.curves(tmp_path / "curve.txt")
    assert not shown


def test_a_sensitivity_needs_one_to_correct(tmp_path):
    """Of a file that has forces and no sensitivity it was passed over."""
    write(tmp_path / "map.h5", sensitivity=np.nan)
    assert len(read_afm(tmp_path / "map.h5")) == 6
    with pytest.raises(mdr.MDRError, match="deflection_sensitivity: "):
        read_afm(tmp_path / "map.h5", deflection_sensitivity=100e-9)


@pytest.mark.parametrize("key", ['force = "F"', 'sd = "F"', "skip = 3", 'leave_out = ["map.h5 2"]', 'units = { F = "nN" }'])
def test_what_is_said_of_tables_is_no_word_about_an_afm_file(key, tmp_path):
    """It was passed over."""
    write(tmp_path / "map.h5")
    (tmp_path / "problem.toml").write_text(PROBLEM.replace("[fit.free]", f"{key}\n[fit.free]"))
    with pytest.raises(mdr.MDRError, match=f"{key.split()[0]}.*no table"):
        load_fit_file(tmp_path / "problem.toml").curves(tmp_path / "map.h5")


def test_drift_of_a_file_without_times(tmp_path):
    """It asked for a column, which a file of an AFM has not: a rate of sampling gives the times."""
    (tmp_path / "problem.toml").write_text(PROBLEM.replace("[fit.free]", 'drift = "1 nm/s"\n[fit.free]'))
    problem = load_fit_file(tmp_path / "problem.toml")
    write(tmp_path / "rated.h5", 1, 1, **{"rate approach": 1e3, "rate retract": 1e3})
    write(tmp_path / "plain.h5", 1, 1)
    write(tmp_path / "two.h5", 1, 1, **{"rate approach": 1e3, "rate retract": 2e3})
    (taken,) = (note for note in problem.curves(tmp_path / "rated.h5")[0].read()[1] if note.startswith("drift"))
    assert taken == "drift 1 nm/s, 299 pm over the whole test, is subtracted", "300 readings in 0.299 s"
    for name in ("plain.h5", "two.h5"):
        with pytest.raises(mdr.MDRError, match="neither times nor one rate of sampling. Leave drift out"):
            problem.curves(tmp_path / name)[0].read()


@pytest.mark.parametrize("name", ["map.h5", "curve.jpk-force", "curve.ibw", "curve.tab", "map.jpk-force-map"])
def test_damaged_files_are_refused(name, tmp_path, capsys):
    (tmp_path / name).write_bytes(b"\x89HDF\r\n\x1a\nand then nothing")
    (tmp_path / "problem.toml").write_text(PROBLEM)
    assert main(["fit", str(tmp_path / name), "--problem", str(tmp_path / "problem.toml")]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert name in line and "afmformats cannot read it" in line


def test_a_file_that_is_not_there(tmp_path, capsys):
    (tmp_path / "problem.toml").write_text(PROBLEM)
    assert main(["fit", str(tmp_path / "none.h5"), "--problem", str(tmp_path / "problem.toml")]) == 1
    assert "there is no such file" in capsys.readouterr().err


def test_a_line_of_places_is_drawn_curve_by_curve_and_a_map_as_one(tmp_path):
    (tmp_path / "problem.toml").write_text(PROBLEM)
    problem = load_fit_file(tmp_path / "problem.toml")
    for columns, rows, images in ((4, 1, 0), (3, 2, 1)):
        write(tmp_path / f"{columns}.h5", columns, rows)
        found = studies.many(problem, problem.curves(tmp_path / f"{columns}.h5"), keep_all=True)
        assert [curve.place for curve in found.curves] == [(i % columns, i // columns) for i in range(columns * rows)]
        drawn = [part for panel in found.figure().panels for part in panel.parts if isinstance(part, Cells)]
        assert len(drawn) == images
        if images:
            assert found.figure().panels[0].x.title == "column"
            assert drawn[0].values == pytest.approx(np.array([[20.0, 40.0, 60.0], [80.0, 100.0, 120.0]]), rel=2e-3)
