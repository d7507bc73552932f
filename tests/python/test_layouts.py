# SPDX-License-Identifier: GPL-3.0-or-later
"""Where instruments write titles, units and tests: each layout gives the numbers that stand in its file."""

from __future__ import annotations

import random

import instruments
import numpy as np
import pytest
from conftest import ROOT

import mdrcontact.instruments as mdi
from mdrcontact.instruments.files import data as measured
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.reading.columns import TableOptions, read_tables
from mdrcontact.instruments.reading.units import spelled
from mdrcontact.problem import ProblemError
from mdrcontact.problem.section import Section

CASES = ROOT / "tests" / "data" / "cases"
DEPTH = np.arange(1, 12) * 0.5
FORCE = 0.1 * DEPTH**2 + 0.01
TIME = 0.1 * np.arange(1, 12)


def rows(*columns, separator="\t"):
    return "".join(separator.join(f"{value:.4f}" for value in row) + "\n" for row in zip(*columns, strict=True))


def tables(tmp_path, text, options=None, encoding="utf-8"):
    path = tmp_path / "table.txt"
    path.write_bytes(text.encode(encoding))
    return read_tables(path, options)


def column(table, role, **said):
    return measured.column(Section({"kind": "stiffness-depth", **said}, "data", measured.KNOWN), table, role)


def fitted(data, problem, tmp_path):
    path = tmp_path / "problem.toml"
    path.write_text(problem)
    file = load_fit_file(path)
    return [mdi.fit(curve.read()[0], **file.arguments).estimates["E"] for curve in file.curves(data)]


TITLES = {
    "titles of NumPy": ("# depth [nm] load [mN]\n", " "),
    "titles of NumPy between commas": ("# made by hand\n# depth [nm],load [mN]\n", ","),
    "titles of NumPy without brackets": ("# depth_nm load_mN\n", " "),
    "keys before titles and units": ('# columns: a b\n# fancyNames: "Depth" "Normal load"\n# units: nm mN\n', " "),
    "the sign of another comment": ("% depth [nm]\tload [mN]\n", "\t"),
    "a sign of its own": ("% depth[nm] load[mN]\n", " "),
    "one below the other": ("# column 1: depth (nm)\n# column 2: load (mN)\n", " "),
    "one below the other, no comments": ("made by a program\n0: depth nm\n1: load mN\n", "\t"),
    "a blank before the unit": ("Depth nm\tLoad mN\n", "\t"),
    "a word before the unit": ("Depth in nm;Load in mN\n", ";"),
    "a dash before the unit": ("Depth - nm;Load - mN\n", ";"),
    "a slash": ("Depth/nm\tLoad/mN\n", "\t"),
    "braces": ("Depth {nm}\tLoad {mN}\n", "\t"),
    "symbols behind names": ("Depth h (nm)\tLoad, P (mN)\n", "\t"),
    "a row of units": ("Depth\tLoad\n(nm)\t(mN)\n", "\t"),
    "German": ("Eindringtiefe [nm];Pr\xfcfkraft [mN]\n", ";"),
    "a row of units above": ("nm\tmN\nDepth\tLoad\n", "\t"),
    "the largest values": ("hmax (nm)\tPmax (mN)\n", "\t"),
    "Japanese": ("\u6df1\u3055(nm),\u8377\u91cd(mN)\n", ","),
    "Chinese": ("\u538b\u5165\u6df1\u5ea6[nm],\u8f7d\u8377[mN]\n", ","),
    "French": ("Profondeur (nm);Charge (mN)\n", ";"),
}


@pytest.mark.parametrize("kind", TITLES)
def test_titles_and_units_wherever_they_stand(kind, tmp_path):
    head, separator = TITLES[kind]
    (table,) = tables(tmp_path, head + rows(DEPTH, FORCE, separator=separator))
    assert column(table, "depth").values == pytest.approx(DEPTH * 1e-9)
    assert column(table, "force").values == pytest.approx(FORCE * 1e-3, abs=1e-7)


def test_a_column_of_the_title_of_a_comment(tmp_path):
    (table,) = tables(tmp_path, "#\tDepth [nm]\tLoad [mN]\n" + rows(TIME, DEPTH, FORCE))
    assert table.titles == ["#", "Depth [nm]", "Load [mN]"]


@pytest.mark.parametrize(
    ("sign", "encoding"),
    [
        *(("\N{MICRO SIGN}", "utf-8"), ("\N{GREEK SMALL LETTER MU}", "utf-8"), ("\N{MICRO SIGN}", "latin-1"), ("u", "ascii")),
        *(("\xc2\xb5", "utf-8"), ("\xce\xbc", "utf-8"), ("\u0192\xca", "utf-8"), ("\xa6\xcc", "utf-8"), ("\ufffd", "utf-8")),
    ],
)
def test_a_sign_of_micro_in_any_encoding_names_its_column(sign, encoding, tmp_path):
    """The title could not be named as it stands in the file."""
    (table,) = tables(tmp_path, f"h (nm)\tIndent Load ({sign}N)\n" + rows(DEPTH, FORCE), encoding=encoding)
    for title in (f"Indent Load ({own}N)" for own in ("\N{MICRO SIGN}", "\N{GREEK SMALL LETTER MU}", "u", sign)):
        assert column(table, "force", force=title).values == pytest.approx(FORCE * 1e-6, abs=1e-10)
        options = TableOptions(units={title: "mN"})
        (other,) = tables(tmp_path, f"h (nm)\tIndent Load ({sign}N)\n" + rows(DEPTH, FORCE), options, encoding)
        assert column(other, "force").values == pytest.approx(FORCE * 1e-3, abs=1e-7)


def test_the_case_of_a_sign_of_micro(tmp_path):
    (table,) = read_tables(CASES / "micro_sign.txt")
    assert column(table, "force", force="Indent Load (\N{MICRO SIGN}N)").values[-1] == pytest.approx(7.2e-6)


@pytest.mark.parametrize(
    ("unit", "known"),
    [
        *(("kp/mm2", "kgf/mm^2"), ("kp/mm\xb2", "kgf/mm^2"), ("um2", "um^2"), ("N\xb7mm\u207b\xb9", "N*mm^-1"), ("nJ", "nJ")),
        *(("eV", "eV"), ("\xc5", "angstrom"), ("\N{ANGSTROM SIGN}", "angstrom"), ("Ang", "angstrom"), ("eV/Ang", "eV/angstrom")),
        *(("Mikron", "um"), ("Sek.", "s"), ("s-1", "s^-1"), ("GPA", "GPa"), ("Segment", "Segment"), ("No.", "No.")),
    ],
)
def test_units_as_instruments_spell_them(unit, known):
    assert spelled(unit) == known


def test_lengths_of_atoms(tmp_path):
    (table,) = tables(tmp_path, "depth (\xc5)\tforce (eV/\xc5)\n" + rows(DEPTH, FORCE))
    assert column(table, "depth").values == pytest.approx(DEPTH * 1e-10)
    assert column(table, "force").values == pytest.approx(FORCE * 1.602176634e-9, abs=2e-13)
    lammps = "# Time-averaged data for fix ave\n# TimeStep v_depth v_force\n" + rows(TIME, DEPTH, FORCE, separator=" ")
    (table,) = tables(tmp_path, lammps, TableOptions(units={"v_depth": "angstrom", "v_force": "nN"}))
    assert column(table, "depth").values == pytest.approx(DEPTH * 1e-10)
    assert column(table, "force").values == pytest.approx(FORCE * 1e-9, abs=1e-13)
    (table,) = tables(tmp_path, lammps)
    with pytest.raises(ProblemError, match="'v_depth' should be the depth, but does not state its unit"):
        column(table, "depth")


@pytest.mark.parametrize("head", ["H(GPa)\tE(GPa)\th(nm)\tP(mN)\n", "H\tE\th\tP\nGPa\tGPa\tnm\tmN\n"])
def test_a_hardness_is_no_depth(head, tmp_path):
    (table,) = tables(tmp_path, head + rows(FORCE, FORCE, DEPTH, FORCE))
    assert column(table, "depth").values == pytest.approx(DEPTH * 1e-9)
    (table,) = tables(tmp_path, "H(GPa)\tP(mN)\n" + rows(FORCE, FORCE))
    with pytest.raises(ProblemError, match="no column is the depth"):
        column(table, "depth")


@pytest.mark.parametrize("first", ["Segment", "", "Unit", "[-]"])
def test_a_row_of_units_that_begins_with_a_word(first, tmp_path):
    head = f"Segment\tDisplacement\tLoad\tHardness\n{first}\tnm\tmN\tkp/mm2\n"
    (table,) = tables(tmp_path, head + rows(TIME, DEPTH, FORCE, FORCE))
    assert column(table, "depth").values == pytest.approx(DEPTH * 1e-9)
    assert column(table, "force").values == pytest.approx(FORCE * 1e-3, abs=1e-7)


def test_text_of_jpk(tmp_path):
    """Titles and units in comments; a segment below the other."""
    head = "# exportTool: JPK\n# springConstant: 0.05\n# sensitivity: 6E-8\n#\n# segment: {kind}\n"
    head += '# columns: height vDeflection smoothedHeight time\n# fancyNames: "Height" "Vertical Deflection" '
    head += '"Height (measured & smoothed)" "Series Time"\n# units: {units}\n#\n'
    height = 7e-5 - 1e-6 * DEPTH
    text = ""
    for kind in ("extend", "pause", "retract"):
        text += head.format(kind=kind, units="m N m s")
        text += "".join(f"{z:.6E} {f:.6E} {z:.6E} {t:.4f}\n" for z, f, t in zip(height, 1e-9 * FORCE, TIME, strict=True)) + "\n"
    (table,) = tables(tmp_path, text)
    assert column(table, "height").title == "Height (measured & smoothed)"
    assert column(table, "force").values[: len(FORCE)] == pytest.approx(1e-9 * FORCE)
    assert [(mark.row, mark.kind) for mark in table.marks] == [(0, "loading"), (11, "hold"), (22, "unloading")]
    assert {fact.name: fact.value for fact in table.facts} == {"spring_constant": 0.05, "deflection_sensitivity": 6e-8}
    # volts become a force by the constants in the file
    (table,) = tables(tmp_path, text.replace("m N m s", "m V m s"))
    record = measured.record_of(
        Section({"kind": "force-depth"}, "data", measured.KNOWN), measured.Cantilever(), table, "force-depth"
    )
    assert record.force[:11] == pytest.approx(1e-9 * FORCE * 6e-8 * 0.05)


SIDE_BY_SIDE = {
    "numbers behind names": "Depth 1 [nm]\tLoad 1 [mN]\tDepth 2 [nm]\tLoad 2 [mN]\n",
    "numbers behind units": "Depth [nm] 1\tLoad [mN] 1\tDepth [nm] 2\tLoad [mN] 2\n",
    "copies of pandas": "Depth [nm]\tLoad [mN]\tDepth [nm].1\tLoad [mN].1\n",
    "underscores": "h_nm_1\tF_mN_1\th_nm_2\tF_mN_2\n",
    "words": "Test 1 Depth [nm]\tTest 1 Load [mN]\tTest 2 Depth [nm]\tTest 2 Load [mN]\n",
    "the same in turn": "Depth [nm]\tLoad [mN]\tDepth [nm]\tLoad [mN]\n",
    "the names of tests": "X_A_Depth_[nm]\tY_A_Load_[mN]\tX_B_Depth_[nm]\tY_B_Load_[mN]\n",
    "names of samples": "A_1 Depth [nm]\tA_1 Load [mN]\tB_1 Depth [nm]\tB_1 Load [mN]\n",
    "other units": "X_A_Depth_[nm]\tY_A_Load_[mN]\tX_B_Depth_(nm)\tY_B_Load_(mN)\n",
    "units in a row": "Depth 1\tLoad 1\tDepth 2\tLoad 2\nnm\tmN\tnm\tmN\n",
}


@pytest.mark.parametrize("kind", SIDE_BY_SIDE)
def test_tests_side_by_side(kind, tmp_path):
    text = SIDE_BY_SIDE[kind] + rows(DEPTH, FORCE, DEPTH + 1.0, 2.0 * FORCE) + "9.0\t9.0\t\t\n"
    one, two = tables(tmp_path, text)
    assert len(one.values) == 12 and len(two.values) == 11
    assert column(two, "depth").values == pytest.approx(1e-9 * (DEPTH + 1.0))
    assert column(two, "force").values == pytest.approx(2e-3 * FORCE, abs=1e-7)
    assert tables(tmp_path, text, TableOptions(sheet=two.name))[0].values.tolist() == two.values.tolist()
    # a column is named by its title in the file
    title = SIDE_BY_SIDE[kind].split("\n")[0].split("\t")[3]
    assert column(two, "force", force=title).values == pytest.approx(2e-3 * FORCE, abs=1e-7)


def test_an_empty_column_between_tests(tmp_path):
    head = "Depth [nm]\tLoad [mN]\t\tDepth [nm]\tLoad [mN]\n"
    cells = rows(DEPTH, FORCE, DEPTH + 1.0, 2.0 * FORCE).splitlines()
    text = head + "".join("{}\t{}\t\t{}\t{}\n".format(*line.split("\t")) for line in cells)
    assert [len(table.titles) for table in tables(tmp_path, text)] == [2, 2]
    assert column(tables(tmp_path, text)[1], "depth").values == pytest.approx(1e-9 * (DEPTH + 1.0))


def test_each_test_has_its_own_units(tmp_path):
    head = "X_A_Depth_[nm]\tY_A_Load_[mN]\tX_B_Depth_[um]\tY_B_Load_[uN]\n"
    _, two = tables(tmp_path, head + rows(DEPTH, FORCE, DEPTH, FORCE))
    for said in ({}, {"depth": "X_A_Depth_[nm]"}, {"depth": "X_B_Depth_[um]"}):
        assert column(two, "depth", **said).values == pytest.approx(1e-6 * DEPTH)


@pytest.mark.parametrize(("encoding", "name"), [("cp932", "\u6df1\u3055"), ("gb18030", "\u538b\u5165\u6df1\u5ea6")])
def test_encodings_of_japan_and_china(encoding, name, tmp_path):
    (table,) = tables(tmp_path, f"{name}(nm),F(mN)\n" + rows(DEPTH, FORCE, separator=","), encoding=encoding)
    assert column(table, "depth").values == pytest.approx(1e-9 * DEPTH)


def test_a_time_of_all_tests(tmp_path):
    text = "Time [s]\tDepth 1 [nm]\tLoad 1 [mN]\tDepth 2 [nm]\tLoad 2 [mN]\n" + rows(TIME, DEPTH, FORCE, DEPTH, FORCE)
    for table in tables(tmp_path, text):
        assert column(table, "time").values == pytest.approx(TIME)


def test_numbers_in_titles_that_are_no_tests(tmp_path):
    (table,) = tables(tmp_path, "h [nm]\tF [mN]\tk1 [N/m]\tk2 [N/m]\n" + rows(DEPTH, FORCE, FORCE, DEPTH))
    assert len(table.titles) == 4


def test_a_column_that_stands_twice(tmp_path):
    head = "time [s]\tLoad [mN]\ttime [s]\tDepth [nm]\n"
    (table,) = tables(tmp_path, head + rows(TIME, FORCE, TIME, DEPTH))
    assert table.titles == ["time [s]", "Load [mN]", "Depth [nm]"]
    with pytest.raises(ProblemError, match=r'columns = \["time \[s\]", "Load \[mN\]", "column 3 time \[s\]", "Depth \[nm\]"\]'):
        tables(tmp_path, head + rows(TIME, FORCE, TIME + 1.0, DEPTH))


def test_two_times_of_a_test_of_anton_paar(tmp_path):
    """The title that stands in the file is named."""
    head = "X_A_Time_[s]\tY_A_Fn_[mN]\tX_A_Time_[s]\tY_A_Pd_[nm]\n"
    with pytest.raises(ProblemError, match=r"same title, 'X_A_Time_\[s\]', and other numbers"):
        tables(tmp_path, head + rows(TIME, FORCE, TIME + 1.0, DEPTH))


ANTON_PAAR = """
[indenter]
shape = "sphere"
radius = "10 um"
[medium]
type = "homogeneous"
material = {{ E = "100 GPa", nu = 0.3 }}
[instrument]
indenter = {{ E = "1141 GPa", nu = 0.07 }}
[data]
kind = "unloading"
{more}
[fit]
free = ["E"]
"""


@pytest.mark.parametrize("more", ["", 'depth = "Y_Steel_1_Pd_[nm]"\nforce = "Y_Steel_1_Fn_[mN]"', 'sheet = "Steel_2"'])
def test_the_text_of_anton_paar(more, tmp_path):
    """Made with E_r = 98 GPa: E is 97.5 GPa below a diamond."""
    found = fitted(CASES / "anton_paar.TXT", ANTON_PAAR.format(more=more), tmp_path)
    assert found == pytest.approx([97.45e9, 97.49e9][-1 if "sheet" in more else 0 :], rel=1e-4)


BRUKER = """
[indenter]
shape = "sphere"
radius = "2.5 um"
[medium]
type = "homogeneous"
material = {{ E = "1 MPa", nu = 0.5 }}
[instrument]
spring_constant = "0.4 N/m"
{instrument}
[data]
kind = "force-depth"
{data}
[fit]
free = ["E", "depth_offset"]
"""


@pytest.mark.parametrize(
    ("name", "instrument", "data"),
    [
        ("nanoscope.spm.txt", "", ""),
        ("nanoscope.spm.txt", 'deflection_sensitivity = "60 nm/V"', 'deflection = "Defl_V_Ex"'),
        ("nanoscope.spm.txt", "", 'height = "Calc_Ramp_Ex_nm"\ndeflection = "Defl_nm_Ex"'),
        ("nanoscope.spm.txt", "", 'height = "Calc_Ramp_Ex_nm"\nforce = "Defl_pN_Ex"'),
        ("nanoscope.spm.txt", "", 'deflection = "Defl_nm_Ex"\nunits = { "Defl_nm_Ex" = "nm" }'),
        ("nanoscope_volts.txt", 'deflection_sensitivity = "60 nm/V"', 'deflection = "Defl_V_Ex"'),
        ("nanoscope_volts.txt", 'deflection_sensitivity = "60 nm/V"', 'branch = "both"'),
    ],
)
def test_the_export_of_nanoscope(name, instrument, data, tmp_path):
    """E = 1.5 MPa by Hertz's paraboloid; a sphere is 0.9 % blunter at a depth of 0.17 radii."""
    path = CASES / name
    (found,) = fitted(path, BRUKER.format(instrument=instrument, data=data), tmp_path)
    assert found == pytest.approx(1.513e6, rel=2e-3)
    (found,) = fitted(path, BRUKER.format(instrument=instrument, data=data).replace('"sphere"', '"paraboloid"'), tmp_path)
    assert found == pytest.approx(1.5e6, rel=1e-3)


def test_one_deflection_in_three_units_says_the_lever():
    """Of 0.4 N/m and 60 nm/V."""
    (table,) = read_tables(CASES / "nanoscope.spm.txt")
    said = {fact.name: fact.value for fact in table.facts}
    assert said == {"spring_constant": pytest.approx(0.4, rel=1e-3), "deflection_sensitivity": pytest.approx(60e-9, rel=1e-3)}
    (table,) = read_tables(CASES / "nanoscope_volts.txt")
    assert table.facts == ()


def test_an_export_of_nanoscope_with_its_header(tmp_path):
    """The header begins as that of the binary file, and gives sensitivity and spring constant."""
    head = "\\*Force file list\r\n\\Version: 0x0920\r\n\\*Ciao scan list\r\n\\@Sens. DeflSens: V 60.00000 nm/V\r\n"
    head += '\\@4:Image Data: S [DeflectionError] "Deflection Error"\r\n\\@2:TMSetPhase: V (0.005493164 \xba/LSB)       0 \xba\r\n'
    head += "\\Spring Constant: 0.4\r\n\\*File list end\r\n"
    path = tmp_path / "curve.spm.txt"
    path.write_bytes(head.encode("latin-1") + (CASES / "nanoscope_volts.txt").read_bytes())
    problem = BRUKER.format(instrument="", data="").replace('spring_constant = "0.4 N/m"', "")
    (found,) = fitted(path, problem.replace('"sphere"', '"paraboloid"'), tmp_path)
    assert found == pytest.approx(1.5e6, rel=1e-3)


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize(("into", "out"), [("Ex", "Rt"), ("Extend", "Retract"), ("Approach", "Retract"), ("Trace", "Retrace")])
def test_the_way_out_beside_the_way_in(into, out, turned, tmp_path):
    back = slice(None) if turned else slice(None, None, -1)
    text = f"Z_nm_{into}\tZ_nm_{out}\tLoad_nN_{into}\tLoad_nN_{out}\n" + rows(DEPTH, DEPTH[back], FORCE, FORCE[back])
    (table,) = tables(tmp_path, text)
    assert column(table, "height").values == pytest.approx(1e-9 * np.concatenate([DEPTH, DEPTH[::-1]]))
    assert column(table, "force").values == pytest.approx(1e-9 * np.concatenate([FORCE, FORCE[::-1]]), abs=1e-13)
    assert [(mark.row, mark.kind) for mark in table.marks] == [(0, "loading"), (11, "unloading")]


def test_a_table_of_results():
    """Titles, and a row of units of which some are of no interest; one indent a row."""
    pytest.importorskip("openpyxl")
    (table,) = read_tables(CASES / "results.xlsx")
    assert table.units["h"] == "um" and table.units["S"] == "mN/um" and table.units["HV"] == "kp/mm^2"
    assert column(table, "stiffness").values.min() == pytest.approx(133.02e3, rel=1e-4)
    assert column(table, "radius").values.min() == pytest.approx(987.1e-9, rel=1e-4)


RESULTS = """
[indenter]
shape = "area-function"
coefficients = [24.5]
length_unit = "um"
max_height = "2 um"
[medium]
type = "homogeneous"
material = {{ E = "80 GPa", nu = 0.2 }}
[data]
kind = "{kind}"
relative_sd = 0.01
[fit]
free = ["E"]
"""


def test_each_row_of_a_table_of_results(tmp_path):
    """Reduced moduli of 100 and 60 GPa in turn: E = 96 and 57.6 GPa."""
    pytest.importorskip("openpyxl")
    (tmp_path / "problem.toml").write_text(RESULTS.format(kind="stiffness-depth"))
    file = load_fit_file(tmp_path / "problem.toml")
    data, notes = file.read_data(CASES / "results.xlsx")
    assert any("one indent a row" in words and "mdrcontact modulus" in words for words in notes)
    found = mdi.modulus_at_depths(data, file.indenter, file.medium, file.free, instrument=file.instrument)
    assert found.modulus == pytest.approx(np.resize([96.0e9, 57.6e9], 20), rel=3e-4)


def test_results_of_a_series_without_its_tests(tmp_path):
    """The only table of a workbook has one row for each test: there was an IndexError."""
    pytest.importorskip("openpyxl")
    titles, units = ["Test", "Displacement", "Load", "Stiffness"], ["", "nm", "mN", "N/m"]
    path = tmp_path / "results.xlsx"
    path.write_bytes(instruments.xlsx({"Results": [titles, units, *([i, 250.0 + i, 10.0, 9e4] for i in range(1, 9))]}))
    (tmp_path / "problem.toml").write_text(RESULTS.format(kind="stiffness-depth"))
    data, _ = load_fit_file(tmp_path / "problem.toml").read_data(path)
    assert len(data) == 8 and data.x[0] == pytest.approx(251e-9)


PARTS = (
    *(
        b"",
        b"\t",
        b";",
        b",",
        b"#",
        b"[",
        b"(",
        b"nm",
        b"\xb5N",
        b"\n",
        b"\r",
        b'"',
        b"1e999",
        b"nan",
        b"_",
        b" ",
        b"Test 1",
        b".1",
        b"_Ex",
    ),
    *(
        b"_Rt",
        b"# units: m N\n",
        b"# columns: a b\n",
        b"# segment: extend\n",
        b"C0: 24.5\nC1: 3\n",
        b"1: depth\n",
        b"%",
        b"kp/mm2",
        b"?m",
    ),
)


@pytest.mark.parametrize("kind", [*TITLES, *SIDE_BY_SIDE, "anton_paar.TXT", "nanoscope.spm.txt"])
def test_damaged_layouts_are_read_or_refused(kind, tmp_path):
    """Damage found a title that was looked for where it was not, and an overflow."""
    if kind in TITLES:
        head, separator = TITLES[kind]
        content = (head + rows(DEPTH, FORCE, separator=separator)).encode()
    elif kind in SIDE_BY_SIDE:
        content = (SIDE_BY_SIDE[kind] + rows(DEPTH, FORCE, DEPTH, FORCE)).encode()
    else:
        content = b"\n".join((CASES / kind).read_bytes().split(b"\n")[:40])
    draw = random.Random(kind)
    path = tmp_path / "damaged.txt"
    for _ in range(60):
        damaged = content
        for _ in range(draw.randrange(1, 5)):
            place = draw.randrange(min(len(damaged), draw.choice([80, 2000])) + 1)
            damaged = damaged[:place] + draw.choice(PARTS) + damaged[place + draw.choice([0, 0, 1, 3, 30]) :]
        path.write_bytes(damaged)
        try:
            found = read_tables(path)
        except ProblemError as refusal:
            assert "\n" not in str(refusal)
            continue
        assert all(table.values.shape[1] == len(table.titles) for table in found)
