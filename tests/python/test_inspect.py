# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact inspect`: what a file is, a problem file that runs, and no traceback whatever the damage."""

from __future__ import annotations

import io
import random
import zipfile

import instruments
import numpy as np
import pytest
from conftest import ROOT

from mdrcontact.cli import main

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
    assert 'radius = "27.5 um"  # the file says so' in out and "modulus by the maker's program, E_eff 156.01 Pa" in out
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
        ("afm_on_rubber.csv", "force-depth", ['E = "3.64 MPa"', 'shape = "sphere"']),
    ],
)
def test_what_a_table_is_follows_from_its_readings(name, kind, words, tmp_path, capsys):
    """Small forces that go deep are of a gel under a ball, in time where it is held; the search begins near its modulus."""
    data, start = ROOT / "examples" / "fit" / name, tmp_path / "start.toml"
    assert main(["inspect", str(data)]) == 0
    out = capsys.readouterr().out
    assert f'would be fitted as kind = "{kind}"' in out
    assert [part for part in words if part not in out] == []
    assert main(["inspect", str(data), "--problem", str(start)]) == 0
    # adhesion holds the rubber at its first reading: that needs a work of adhesion
    if name != "afm_on_rubber.csv":
        assert main(["fit", str(data), "--problem", str(start)]) == 0, capsys.readouterr().err
