# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact inspect`: what a file is, a problem file that runs, and no traceback whatever the damage."""

from __future__ import annotations

import io
import json
import random
import zipfile
from pathlib import Path

import instruments
import numpy as np
import pytest
from conftest import ROOT
from records import indentation, wandering

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.files.start_file import MARK

FIT, CASES = ROOT / "examples" / "fit", ROOT / "tests" / "data" / "cases"

READ = {
    "series.xlsx": ("stiffness-depth", "1 loading, 2 hold, 1 unloading"),
    "blocks.txt": ("unloading", "1 loading, 2 hold, 2 unloading"),
    "gel.txt": ("force-depth", "unloading"),
    "triboscan.txt": ("unloading", "loading"),
    "high_load.hld": ("unloading", "loading"),
    "beside.txt": ("unloading", "loading"),
}


def needs(name):
    if name.endswith(".xlsx"):
        pytest.importorskip("openpyxl")
    if name.endswith(".xls"):
        pytest.importorskip("xlrd")


@pytest.mark.parametrize("name", READ)
def test_the_problem_file_that_is_written_runs(name, tmp_path, capsys):
    needs(name)
    kind, segments = READ[name]
    data, start = tmp_path / name, tmp_path / "start.toml"
    data.write_bytes(instruments.files()[name])
    assert main(["inspect", str(data), "--plot", str(tmp_path / "picture.png"), "--problem", str(start)]) == 0
    out = capsys.readouterr().out
    assert f'would be fitted as kind = "{kind}"' in out and segments in out
    assert (tmp_path / "picture.png").stat().st_size > 5000
    assert main(["fit", str(data), "--problem", str(start)]) == 0, capsys.readouterr().err


def test_what_the_file_says_stands_in_the_problem_file(tmp_path, capsys):
    path = tmp_path / "gel.txt"
    path.write_bytes(instruments.optics11())
    assert main(["inspect", str(path)]) == 0
    out = capsys.readouterr().out
    assert 'radius = "27.5 um"  # stated in the file' in out and "modulus by the maker's program, E_eff 156.01 Pa" in out
    assert "guessed in the problem file: the body" in out


def test_a_table_without_titles_shows_its_columns(tmp_path, capsys):
    path = tmp_path / "bare.txt"
    path.write_bytes(instruments.bare())
    assert main(["inspect", str(path)]) == 2
    words = capsys.readouterr().err
    assert "columns = " in words and "'column 3' 0 to 16.9" in words


def test_other_kinds_are_known_by_their_columns(tmp_path, capsys):
    path = tmp_path / "modulus.csv"
    path.write_text("a [nm],E_eff [GPa]\n" + "".join(f"{10 * i},{70 + i}\n" for i in range(1, 20)))
    assert main(["inspect", str(path)]) == 0
    assert 'kind = "modulus-radius"' in capsys.readouterr().out


def test_settings_of_the_cantilever_that_the_file_lacks_are_marked(tmp_path, capsys):
    """Heights and voltages of NT-MDT: what is missing was named, and no problem file came of it."""
    pytest.importorskip("afmformats")
    path, start = tmp_path / "Curve_DFL_Height_1.txt", tmp_path / "start.toml"
    height = np.linspace(-2000.0, 2000.0, 400)
    volts = 1e-3 * np.maximum(-height, 0.0) ** 1.5 / 50.0 + 1e-4 * np.random.default_rng(0).standard_normal(400)
    path.write_text("".join(f"{z:.4f}\t{u:.4f}\t{u:.4f}\r\n" for z, u in zip(height, volts, strict=True)).replace(".", ","))
    assert main(["inspect", str(path), "--problem", str(start)]) == 0
    out = capsys.readouterr().out
    assert "not in the file: spring constant, taken as 0.2 N/m" in out
    assert "guessed in the problem file: radius, spring_constant, deflection_sensitivity" in out
    assert 'deflection_sensitivity = "50 nm/V"  # not in the file' in start.read_text()
    assert main(["fit", str(path), "--problem", str(start)]) == 0


def test_results_are_not_replaced_unasked(tmp_path, capsys):
    path, start = tmp_path / "triboscan.txt", tmp_path / "start.toml"
    path.write_bytes(instruments.hysitron_text())
    start.write_text("kept")
    assert main(["inspect", str(path), "--problem", str(start)]) == 1
    assert start.read_text() == "kept" and "exists" in capsys.readouterr().err


def cut(draw, new, at, other):
    return new[: draw.randrange(len(new) + 1)]


def flipped(draw, new, at, other):
    for _ in range(draw.randrange(1, 40)):
        new[draw.randrange(len(new))] = draw.randrange(256)
    return new


def lost(draw, new, at, other):
    return new[: min(at, other)] + new[max(at, other) :]


def doubled(draw, new, at, other):
    return new[:at] + new[min(at, other) : max(at, other)][:5000] + new[at:]


def zeros(draw, new, at, other):
    return new[:at] + bytes(draw.randrange(1, 200)) + new[at + draw.randrange(200) :]


def replaced(draw, new, at, other):
    return new.replace(draw.choice([b"\t", b".", b"\n", b"0", b"e"]), draw.choice([b"", b",", b" ", b"-"]))


def mixed(draw, new, at, other):
    return new[:at] + bytes(draw.randrange(256) for _ in range(draw.randrange(1, 100))) + new[at:]


def damaged(content, draw):
    """A file as disks, transfers, editors and people damage it."""
    new = bytearray(content)
    for _ in range(draw.randrange(1, 4)):
        if new:
            what = draw.choice([cut, flipped, lost, doubled, zeros, replaced, mixed])
            new = bytearray(what(draw, new, draw.randrange(len(new)), draw.randrange(len(new))))
    return bytes(new)


def damaged_within(content, draw):
    """A spreadsheet one of whose parts is damaged, in an archive that is not."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(content)) as archive, zipfile.ZipFile(out, "w") as new:
        names = archive.namelist()
        struck = draw.choice(names)
        for name in names:
            part = archive.read(name)
            new.writestr(name, damaged(part, draw) if name == struck else part)
    return out.getvalue()


@pytest.mark.parametrize(
    "damages", [pytest.param(range(12), id="some"), pytest.param(range(12, 170), id="all", marks=pytest.mark.slow)]
)
@pytest.mark.parametrize("name", [*instruments.files(), "map.h5"])
def test_damaged_files_are_refused_in_one_line_or_read(name, damages, tmp_path, capsys):
    """2,040 files of twelve formats."""
    needs(name)
    if name == "map.h5":
        write = pytest.importorskip("test_afm").write
        write(tmp_path / name, 1, 1)
        content = (tmp_path / name).read_bytes()
    else:
        content = instruments.files()[name]
    for seed in damages:
        damage = damaged_within if name.endswith(".xlsx") and seed % 2 else damaged
        (tmp_path / name).write_bytes(damage(content, random.Random(f"{name} {seed}")))
        status = main(["inspect", str(tmp_path / name)])
        words = capsys.readouterr().err
        assert status == 0 or status in (1, 2) and words.count("\n") == 1, (seed, words)


@pytest.mark.parametrize(
    ("name", "kind", "words"),
    [
        ("gel_in_time.csv", "force-time", ["time from column 'time [s]' in s", 'modulus = "700 Pa"', 'shape = "sphere"']),
        ("csm_on_silica.csv", "stiffness-depth", ["stiffness from column 'S_N_per_m' in N/m", 'shape = "area-function"']),
        ("afm_on_rubber.csv", "force-depth", ['E = "3.64 MPa"', 'shape = "sphere"', 'work_of_adhesion = "54 mJ/m^2"']),
        ("modulus_of_oxide.csv", "modulus-radius", ['radius_over_thickness = "a/h"', 'free = ["coating.E"]']),
    ],
)
def test_what_a_table_is_follows_from_its_readings(name, kind, words, capsys):
    """Small forces that go deep are of a gel under a ball, in time where it is held; forces below 0 are of adhesion; the search
    begins near the modulus."""
    assert main(["inspect", str(FIT / name)]) == 0
    out = capsys.readouterr().out
    assert f'would be fitted as kind = "{kind}"' in out
    assert [part for part in words if part not in out] == []


TABLES = sorted(path for path in [*FIT.iterdir(), *CASES.iterdir()] if path.suffix in (".csv", ".txt", ".TXT"))
TRUE = {
    "afm_on_rubber.csv": {"radius": "5 um"},
    "gel_in_time.csv": {"radius": "5 um"},
    "jump_in.txt": {"radius": "7.5 um", "spring_constant": "3 N/m"},
    "modulus_of_oxide.csv": {"thickness": "500 nm", "nu": "0.2", "E": "163 GPa"},
    "micro_sign.txt": {"radius": "1 um"},
    "nanoscope.spm.txt": {"radius": "2.5 um"},
    "nanoscope_volts.txt": {"radius": "2.5 um", "spring_constant": "0.4 N/m", "deflection_sensitivity": "60 nm/V"},
    "prony_start.txt": {"radius": "4 mm"},
    "punch_on_hydrogel.csv": {"radius": "1 mm"},
    "raw_afm_on_rubber.txt": {"radius": "5 um", "spring_constant": "30 N/m", "deflection_sensitivity": "50 nm/V"},
    "sphere_on_oxide.csv": {"radius": "10 um"},
    "wandering.txt": {},
}
"""What stands in the marked lines; the other tables have none."""
MODULI = {
    "jump_in.txt": ("E", 1.4e6, 0.03),
    "modulus_of_oxide.csv": ("coating.E", 71.2e9, 0.02),
    "nanoscope.spm.txt": ("E", 1.5e6, 0.01),
    "nanoscope_volts.txt": ("E", 1.5e6, 0.01),
}
"""Parameters that are known, with the differences of what is written: a sphere for a paraboloid, nu of 0.2."""


@pytest.mark.parametrize("data", [*TABLES, Path("wandering.txt")], ids=lambda path: path.name)
def test_every_table_of_measurements_has_a_problem_file_to_begin_with(data, tmp_path, capsys):
    """A record of height and deflection and a table of a/h were refused, with a cure that `inspect` could not be given."""
    start, result = tmp_path / "start.toml", tmp_path / "fit.json"
    if data.name == "wandering.txt":
        data = tmp_path / data
        time, h, p = wandering()
        table = np.column_stack([time, 1e9 * h, 1e6 * p])
        np.savetxt(data, table, header="Time (s)\tDepth (nm)\tLoad (uN)", comments="", delimiter="\t")
    assert main(["inspect", str(data), "--problem", str(start)]) == 0
    marked = TRUE.get(data.name, {})
    assert filled(start, marked) == set(marked)
    assert main(["fit", str(data), "--problem", str(start), "--json", str(result)]) == 0, capsys.readouterr().err
    if data.name in MODULI:
        name, value, rel = MODULI[data.name]
        assert json.loads(result.read_text())["parameters"][name]["value"] == pytest.approx(value, rel=rel)


def filled(start, values):
    """Puts values into the marked lines of a problem file; their keys."""
    keys, lines = set(), []
    for line in start.read_text(encoding="utf-8").splitlines():
        key = line.split(" = ")[0]
        if line.endswith(MARK):
            keys.add(key)
            line = f"{key} = {values[key]}" if values[key][:1] == "{" or values[key] == "0.2" else f'{key} = "{values[key]}"'
        lines.append(line)
    start.write_text("\n".join(lines), encoding="utf-8")
    return keys


@pytest.mark.parametrize("offset", [0.0, 0.5e-9, -2e-9, 20e-9])
@pytest.mark.parametrize("retract", [False, True])
def test_a_force_before_contact_that_is_not_zero_is_fitted(offset, retract, tmp_path):
    """With an offset of 0.5 nN left in, E was 18.15 kPa [17.28, 19.01] for 20."""
    depth = np.linspace(-2e-6, 1e-6, 600)
    force = np.zeros(600)
    body = mdr.Homogeneous(mdr.Elastic(20e3, 0.5))
    force[depth > 0.0] = mdr.Contact(mdr.Sphere(5e-6), body).at_depth(depth[depth > 0.0]).force
    if retract:
        depth, force = np.concatenate([depth, depth[::-1]]), np.concatenate([force, force[::-1]])
    force = force + offset + 0.1e-9 * np.random.default_rng(3).standard_normal(force.size)
    data, start, result = tmp_path / "curve.txt", tmp_path / "start.toml", tmp_path / "fit.json"
    np.savetxt(data, np.column_stack([1e9 * depth, 1e9 * force]), header="depth [nm] force [nN]", comments="")
    assert main(["inspect", str(data), "--problem", str(start)]) == 0
    assert ('contact_point = "fit"' in start.read_text()) == (offset != 0.0)
    filled(start, {"radius": "5 um"})
    assert main(["fit", str(data), "--problem", str(start), "--json", str(result)]) == 0
    found = json.loads(result.read_text())["parameters"]["E"]
    assert found["value"] == pytest.approx(20e3, abs=4.0 * found["standard_error"])
    assert found["value"] == pytest.approx(20e3, rel=2e-3)


def test_an_unloading_curve_with_a_baseline(tmp_path):
    """Contact begins at 40 nm, and the force without it is 0.2 mN: both stood in the depth and in the force of the indent."""
    depths = {}
    for moved in (False, True):
        _, h, p, truth = indentation(seed=5)
        if moved:
            h = np.concatenate([np.linspace(-40e-9, 0.0, 80), h]) + 40e-9
            p = np.concatenate([2e-6 * np.random.default_rng(0).standard_normal(80), p]) + 0.2e-3
        data, start = tmp_path / f"{moved}.txt", tmp_path / f"{moved}.toml"
        np.savetxt(data, np.column_stack([1e9 * h, 1e3 * p]), header="depth [nm] load [mN]", comments="")
        assert main(["inspect", str(data), "--problem", str(start)]) == 0
        assert ('contact_point = "piecewise"\nbaseline = "offset"' in start.read_text()) == moved
        read = load_fit_file(start).curves(data)[0].read()[0]
        depths[moved] = (read.unloadings[0].depth, read.unloadings[0].force)
    assert depths[True][1] == pytest.approx(depths[False][1], rel=0.01)
    # a ball's power, which estimates the contact point, puts it 17 nm deeper than that of a cone
    assert depths[True][0] == pytest.approx(depths[False][0], rel=0.07)
    assert depths[False][0] == pytest.approx(truth["depth"], rel=0.02)


def test_what_the_file_does_not_say_may_be_given(tmp_path, capsys):
    """The settings of the cantilever, the titles, or a problem file that says them."""
    raw, start = str(FIT / "raw_afm_on_rubber.txt"), tmp_path / "start.toml"
    spring = ["--spring-constant", "30 N/m", "--deflection-sensitivity", "0.05 um/V"]
    assert main(["inspect", raw, *spring, "--problem", str(start)]) == 0
    text = start.read_text()
    assert 'spring_constant = "30 N/m"\n' in text and 'deflection_sensitivity = "50 nm/V"\n' in text
    assert main(["inspect", raw, "--like", str(FIT / "raw_afm_on_rubber.toml"), "--problem", str(start), "--overwrite"]) == 0
    assert start.read_text() == text
    assert main(["inspect", raw, "--spring-constant", "30"]) == 2
    assert "spring_constant" in capsys.readouterr().err
    bare = tmp_path / "bare.txt"
    bare.write_bytes(instruments.bare())
    assert main(["inspect", str(bare)]) == 2
    assert "--columns" in capsys.readouterr().err
    titles = ["time [s]", "depth [nm]", "load [mN]"]
    assert main(["inspect", str(bare), "--columns", *titles, "--problem", str(start), "--overwrite"]) == 0
    assert f"columns = {json.dumps(titles)}" in start.read_text()
    assert main(["fit", str(bare), "--problem", str(start)]) == 0


def test_units_that_the_file_lacks_are_marked(tmp_path, capsys):
    data, start = tmp_path / "table.csv", tmp_path / "start.toml"
    data.write_text("Depth,Load\n" + "".join(f"{10 * i},{i**1.5:.4f}\n" for i in range(40)))
    assert main(["inspect", str(data), "--problem", str(start)]) == 0
    assert "guessed in the problem file: radius, units, the body" in capsys.readouterr().out
    filled(start, {"radius": "1 mm", "units": '{ "Depth" = "um", "Load" = "mN" }'})
    assert main(["fit", str(data), "--problem", str(start)]) == 0
    assert "depth from column 'Depth' in um: 0 m to 390 um" in capsys.readouterr().out


@pytest.mark.parametrize(("begin", "words"), [(-20e-6, 'radius = "5 um"'), (-3e-9, 'baseline = "none"')])
def test_a_record_of_heights_far_from_the_surface_and_next_to_it(begin, words, tmp_path):
    """The way through the air was taken for a depth, and a record with two readings before contact was refused."""
    depth = np.concatenate([np.linspace(begin, 0.0, 3 if begin > -1e-8 else 800), np.linspace(2e-9, 400e-9, 200)])
    force = np.zeros(depth.size)
    body = mdr.Homogeneous(mdr.Elastic(50e3, 0.5))
    force[depth > 0.0] = mdr.Contact(mdr.Sphere(5e-6), body).at_depth(depth[depth > 0.0]).force
    deflection = force / 0.2 + 0.02e-9 * np.random.default_rng(1).standard_normal(depth.size)
    data, start, result = tmp_path / "curve.txt", tmp_path / "start.toml", tmp_path / "fit.json"
    table = np.column_stack([1e9 * (depth + deflection), 1e9 * deflection])
    np.savetxt(data, table, header="Height [nm] Deflection [nm]", comments="")
    assert main(["inspect", str(data), "--spring-constant", "0.2 N/m", "--problem", str(start)]) == 0
    assert words in start.read_text()
    filled(start, {"radius": "5 um"})
    assert main(["fit", str(data), "--problem", str(start), "--json", str(result)]) == 0
    assert json.loads(result.read_text())["parameters"]["E"]["value"] == pytest.approx(50e3, rel=0.01)
