# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of AFMs that afmformats does not know: NanoScope, Nanosurf, and waves of Asylum that hold one channel each."""

from __future__ import annotations

import random

import afm_files
import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli.files import data_files
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.reading.afm import read_afm
from mdrcontact.instruments.reading.afm_curve import MissingSettings

PROBLEM = """
[indenter]
shape = "paraboloid"
radius = "2.5 um"
[medium]
type = "homogeneous"
material = {{ E = "1 MPa", nu = 0.5 }}
{instrument}
[data]
kind = "force-depth"
branch = "{branch}"
[fit]
free = ["E", "depth_offset"]
"""


def moduli(path, instrument="", branch="loading"):
    problem = path.parent / "problem.toml"
    problem.write_text(PROBLEM.format(instrument=instrument, branch=branch))
    file = load_fit_file(problem)
    return [mdi.fit(curve.read()[0], **file.arguments).estimates["E"] for curve in file.curves(path)]


def written(tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("name", ["curve.spm", "curve.000", "curve.123"])
@pytest.mark.parametrize("size", [2, 4])
@pytest.mark.parametrize("branch", ["loading", "both"])
def test_a_force_curve_of_nanoscope(branch, size, name, tmp_path):
    path = written(tmp_path, name, afm_files.nanoscope(size))
    assert moduli(path, branch=branch) == pytest.approx([afm_files.MODULUS], rel=2e-3)
    (curve,) = read_afm(path)
    height, deflection = afm_files.curve()
    assert curve.height[:400] == pytest.approx(height) and curve.height[400:] == pytest.approx(height[::-1])
    assert curve.force[:400] == pytest.approx(afm_files.SPRING * deflection, abs=1.2e-11 * afm_files.SPRING)
    assert [(s.kind, s.stop) for s in curve.segments] == [("loading", 400), ("unloading", 800)]


def test_a_way_back_of_nanoscope_may_have_other_readings(tmp_path):
    (curve,) = read_afm(written(tmp_path, "curve.spm", afm_files.nanoscope(samples=(300, 400))))
    assert [(s.kind, s.stop) for s in curve.segments] == [("loading", 400), ("unloading", 700)]
    assert curve.height[[399, 400, 699]] == pytest.approx([1.2e-6, 1.2e-6, 0.0], abs=1e-12)


def test_another_lever_scales_the_forces(tmp_path):
    """Half the spring constant and twice the sensitivity are the same force."""
    paths = [
        written(tmp_path, "curve.spm", afm_files.nanoscope()),
        written(tmp_path, "curve.nid", afm_files.nid()),
        written(tmp_path, "volts.nid", afm_files.nid("V")),
        written(tmp_path, "curve.ibw", afm_files.asylum()[2]),
    ]
    for path in paths[: None if pytest.importorskip("igor2") else 3]:
        plain = read_afm(path)[0]
        for constant, sensitivity, factor in ((0.2, None, 0.5), (None, 120e-9, 2.0), (0.2, 120e-9, 1.0)):
            other = read_afm(path, constant, sensitivity)[0]
            assert other.force == pytest.approx(factor * plain.force, rel=1e-6), path.name
            assert other.spring_constant == pytest.approx(constant or afm_files.SPRING)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (afm_files.nanoscope(mode="Force Volume"), "force volumes of NanoScope are not read: export"),
        (afm_files.nanoscope()[:-400], "end before: export"),
        (afm_files.nanoscope()[:300], "whole header: export"),
        (afm_files.nanoscope().replace(b"[DeflectionError]", b"[HeightSensor...]").replace(b'"Defl', b'"Hght'), "no force curve"),
        (afm_files.nanoscope().replace(b"60.00000 nm/V", b"60.00000 kg/V"), "does not give '@4:Z scale' with a sensitivity"),
        (b"\\*File list\r\n\\*File list end\r\n", "no force curve"),
        (b"", "no file of NanoScope"),
    ],
)
def test_other_files_of_nanoscope_are_refused_with_the_way_to_export_them(content, words, tmp_path):
    path = written(tmp_path, "curve.spm", content)
    with pytest.raises(mdr.errors.FileError, match=words):
        read_afm(path)


def test_counts_of_another_scale_are_refused(tmp_path):
    """In a real volume the integers were 256 times as large as its scale says."""
    content = afm_files.nanoscope()
    path = written(tmp_path, "curve.spm", content[:4096] + (np.frombuffer(content[4096:], "<i4") * 256).astype("<i4").tobytes())
    with pytest.raises(mdr.errors.FileError, match="exceed the range of the instrument"):
        read_afm(path)


@pytest.mark.parametrize("unit", ["N", "m", "V"])
@pytest.mark.parametrize("sensor", [True, False])
@pytest.mark.parametrize("bits", [16, 32])
def test_curves_of_nanosurf(unit, sensor, bits, tmp_path):
    path = written(tmp_path, "curves.nid", afm_files.nid(unit, 2, sensor, bits))
    assert moduli(path) == pytest.approx(2 * [afm_files.MODULUS], rel=2e-3)
    one, two = read_afm(path)
    assert (one.number, two.number) == (1, 2) and one.spring_constant == pytest.approx(afm_files.SPRING)
    assert one.height[400:] == pytest.approx(one.height[:400][::-1], abs=1e-12)
    assert one.force[:400] == pytest.approx(afm_files.SPRING * afm_files.curve()[1], abs=1e-11)


def test_a_pause_of_nanosurf_is_a_hold(tmp_path):
    (one,) = read_afm(written(tmp_path, "curves.nid", afm_files.nid(lines=1, pause=True)))
    assert [(s.kind, s.stop) for s in one.segments] == [("loading", 400), ("hold", 800), ("unloading", 1200)]


def test_a_file_of_nanosurf_without_curves(tmp_path):
    path = written(tmp_path, "image.nid", afm_files.nid().replace(b"Frame=Spec", b"Frame=Scan"))
    with pytest.raises(mdr.errors.FileError, match="no force curves, but Scan backward, Scan forward"):
        read_afm(path)


@pytest.fixture
def waves(tmp_path):
    pytest.importorskip("igor2")
    pytest.importorskip("afmformats")
    deflection, height, both = afm_files.asylum()
    for stem in ("Line0002Point0003", "gel"):
        written(tmp_path, f"{stem}Defl.ibw", deflection)
        written(tmp_path, f"{stem}LVDT.ibw", height)
    written(tmp_path, "whole.ibw", both)
    return tmp_path


@pytest.mark.parametrize("name", ["gelDefl.ibw", "gelLVDT.ibw", "Line0002Point0003Defl.ibw", "whole.ibw"])
def test_waves_of_asylum_that_hold_one_channel_each(name, waves):
    """They were refused with KeyError: 'ImagingMode'."""
    assert moduli(waves / name) == pytest.approx([afm_files.MODULUS], rel=2e-3)
    (curve,) = read_afm(waves / name)
    assert curve.spring_constant == afm_files.SPRING and len(curve.force) == 800
    assert curve.place == ((3.0, 2.0) if "Line" in name else None)


def test_two_waves_of_a_folder_are_one_curve(waves):
    found = [path.name for path in data_files(waves)]
    assert found == ["Line0002Point0003Defl.ibw", "gelDefl.ibw", "whole.ibw"]


def test_a_wave_alone_and_a_lever_that_is_not_known(waves):
    (waves / "gelLVDT.ibw").unlink()
    with pytest.raises(mdr.errors.FileError, match="it holds Defl: a curve needs a deflection and a height.*curveLVDT.ibw"):
        read_afm(waves / "gelDefl.ibw")
    note = f"InvOLS: {afm_files.SENSITIVITY}\r"
    path = written(waves, "whole.ibw", afm_files.ibw(afm_files.curve(), ("LVDT", "Defl"), note))
    with pytest.raises(MissingSettings, match="give .instrument. spring_constant"):
        read_afm(path)
    assert read_afm(path, spring_constant=0.4)[0].spring_constant == 0.4


@pytest.mark.parametrize("name", ["curve.spm", "curve.nid", "curve.ibw"])
def test_damaged_files_are_read_or_refused(name, tmp_path):
    if name.endswith("ibw"):
        pytest.importorskip("igor2")
    content = {"spm": afm_files.nanoscope(), "nid": afm_files.nid(), "ibw": afm_files.asylum()[2]}[name[-3:]]
    draw = random.Random(name)
    for _ in range(150):
        begin = draw.randrange(len(content) if draw.random() < 0.5 else 2500)
        part = draw.choice([b"", bytes(draw.randrange(256) for _ in range(8)), b"9" * 12, b"-", b"nan", b"\r\n"])
        damaged = content[:begin] + part + content[begin + draw.choice([0, 1, len(part), 40]) :]
        path = written(tmp_path, name, damaged[: draw.choice([len(damaged), draw.randrange(len(damaged))])])
        try:
            found = read_afm(path)
        except mdr.MDRError as refusal:
            assert "\n" not in str(refusal) and name in str(refusal)
            continue
        assert all(len(curve.height) == len(curve.force) for curve in found)
