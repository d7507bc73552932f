# SPDX-License-Identifier: GPL-3.0-or-later
"""Files as instruments write them: every test in them is found, marks of the instrument come before guesses, what the header says
is kept."""

from __future__ import annotations

import sys
import time

import instruments
import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.reading import columns
from mdrcontact.instruments.reading.area_function import find_terms
from mdrcontact.instruments.reading.columns import TableOptions, read_table, read_tables
from mdrcontact.instruments.reading.marks import segments_of_marks
from mdrcontact.problem import ProblemError

PROBLEM = """
[indenter]
shape = "sphere"
radius = "10 um"
[medium]
type = "homogeneous"
material = {{ E = "{E}", nu = 0.2 }}
[data]
kind = "{kind}"
{more}
[fit]
free = ["E"]
"""


def problem(tmp_path, kind="unloading", more="", E="70 GPa"):
    path = tmp_path / "problem.toml"
    path.write_text(PROBLEM.format(kind=kind, more=more, E=E))
    return load_fit_file(path)


def written(tmp_path, name):
    path = tmp_path / name
    path.write_bytes(instruments.files()[name])
    return path


def curves(tmp_path, name, **said):
    return problem(tmp_path, **said).curves(written(tmp_path, name))


def test_all_sheets_that_hold_a_test_are_read_by_the_marks_of_the_instrument(tmp_path):
    pytest.importorskip("openpyxl")
    found = curves(tmp_path, "series.xlsx")
    assert [one.name for one in found] == [f"series.xlsx Test 00{i}" for i in (3, 2, 1)]
    for one, i in zip(found, (2, 1, 0), strict=True):
        data, notes = one.read()
        assert "1 unloadings, 1 used" in notes
        assert data.unloadings[0].force == pytest.approx(10e-3 * (i + 1), rel=1e-3)
    assert "5 tables, 3 used; without the columns that are needed: 'Results', 'Required Inputs'" in found[0].read()[1]


def test_readings_that_are_not_used_are_kept_for_the_picture(tmp_path):
    (one,) = curves(tmp_path, "gel.txt", kind="force-depth", more='branch = "loading"', E="100 Pa")
    data, notes = one.read()
    depth, force = data.unused
    assert len(depth) == len(force) == 479 - len(data) and f"{len(data)} of 479 readings are used" in notes
    figure = mdi.fit(data, mdr.Paraboloid(27.5e-6), mdr.Homogeneous(mdr.Elastic(100.0, 0.5)), ["E", "depth_offset"]).plot()
    assert figure.panels[0].parts[0].name == "not used" and len(figure.panels[0].parts[0].x) == len(depth)


def test_one_sheet_of_several(tmp_path):
    pytest.importorskip("openpyxl")
    (one,) = curves(tmp_path, "series.xlsx", more='sheet = "Test 002"')
    assert one.read()[0].unloadings[0].force == pytest.approx(20e-3, rel=1e-3)
    with pytest.raises(ProblemError, match="no sheet 'Test 2'.*Test 002"):
        curves(tmp_path, "series.xlsx", more='sheet = "Test 2"')


def test_tests_that_are_none_are_left_out(tmp_path):
    pytest.importorskip("openpyxl")
    found = curves(tmp_path, "series.xlsx", more='leave_out = ["Test 002"]')
    assert [one.name[-8:] for one in found] == ["Test 003", "Test 001"]
    assert "1 of 3 tests are left out: Test 002" in found[0].read()[1]
    for said, words in (
        ('["Test 2"]', "no test 'Test 2'"),
        ('"Test 2"', "must be a list"),
        ('["Test 001", "Test 002", "Test 003"]', "no test"),
    ):
        with pytest.raises(ProblemError, match=words):
            curves(tmp_path, "series.xlsx", more=f"leave_out = {said}")


def test_an_old_spreadsheet(tmp_path):
    pytest.importorskip("xlrd")
    table = read_table(written(tmp_path, "old.xls"))
    _, h, p, begins = instruments.one_test()
    assert table.values[:, 1] == pytest.approx(h) and table.values[:, 2] == pytest.approx(p)
    assert [(mark.row, mark.kind) for mark in table.marks] == list(
        zip(begins, ["loading", "hold", "unloading", "hold"], strict=False)
    )
    assert np.isnan(table.values[0, 4]), "the largest number stands for none"


def test_text_under_the_name_of_a_spreadsheet(tmp_path):
    path = tmp_path / "export.xls"
    path.write_bytes(instruments.hysitron_text())
    assert len(read_table(path).values) == len(instruments.one_test()[1])


def test_stiffness_is_read_where_the_marks_say_that_the_contact_loads(tmp_path):
    pytest.importorskip("openpyxl")
    data, notes = curves(tmp_path, "series.xlsx", kind="stiffness-depth")[-1].read()
    assert len(data) < 60 and data.x.max() <= instruments.one_test()[1][:60].max() * 1e-9
    assert any(words.startswith("segments as the file has them; of 170 readings 60 load") for words in notes)


def test_blocks_of_a_text_are_tests_with_the_units_of_their_program(tmp_path):
    found = curves(tmp_path, "blocks.txt")
    assert [one.name for one in found] == [f"blocks.txt test {i}" for i in (1, 2, 3)]
    for i, one in enumerate(found):
        data, notes = one.read()
        assert data.unloadings[0].force == pytest.approx(10e-3 * (i + 1), rel=1e-3)
        assert data.unloadings[0].depth == pytest.approx(1e-9 * instruments.one_test(i)[1].max(), rel=2e-2)
        assert notes[0].startswith("Fischer WIN-HCU") and "EIT/(1-vs^2) 83.7 GPa" in notes[-1]
    with pytest.raises(ProblemError, match="no test 'test 4'"):
        read_tables(tmp_path / "blocks.txt", TableOptions(sheet="test 4"))


def test_tests_side_by_side(tmp_path):
    found = curves(tmp_path, "beside.txt")
    assert len(found) == 3
    assert [one.read()[0].unloadings[0].force for one in found] == pytest.approx([10e-3, 20e-3, 30e-3], rel=1e-3)
    assert [len(table.values) for table in read_tables(tmp_path / "beside.txt")] == [170, 170, 160]


def test_what_optics11_says_is_held_against_the_problem(tmp_path):
    (one,) = curves(tmp_path, "gel.txt", kind="force-depth", more='branch = "loading"', E="100 Pa")
    assert [(fact.name, fact.value) for fact in one.facts][:2] == [
        ("indenter.radius", pytest.approx(27.5e-6)),
        ("spring_constant", pytest.approx(0.019)),
    ]
    data, notes = one.read()
    assert any("indenter.radius is 10 um in the problem file and 27.5 um" in words for words in data.warnings)
    assert "E_eff 156.01 Pa" in notes[-1]
    # with the file's radius the modulus of the file comes out
    fitted = mdi.fit(data, mdr.Paraboloid(27.5e-6), mdr.Homogeneous(mdr.Elastic(100.0, 0.5)), ["E", "depth_offset"])
    assert fitted.estimates["E"] / 0.75 == pytest.approx(156.0, rel=5e-3)


def test_the_place_that_a_header_says(tmp_path):
    text = (
        instruments.optics11().decode("latin-1").replace("X-position (um)\t5314.320", "X-position (um)\t20\nY-position (um)\t-30")
    )
    (tmp_path / "gel.txt").write_text(text, encoding="latin-1")
    (one,) = problem(tmp_path, "force-depth", E="100 Pa").curves(tmp_path / "gel.txt")
    assert one.position == pytest.approx((20e-6, -30e-6))


def test_the_last_table_of_a_high_load_record_is_the_test(tmp_path):
    table = read_table(written(tmp_path, "high_load.hld"))
    assert table.titles[:3] == ["Time_s", "Disp_nm", "Force_uN"] and len(table.values) == 170
    assert not table.warnings
    assert {fact.name: fact.value for fact in table.facts} == {
        "frame compliance": pytest.approx(6.63947e-6),
        "drift rate": pytest.approx(0.03648e-9),
        "indenter.C0": 24.5,
    }


TIP = (24.5, 3000.0, 8000.0, -500.0, 200.0, 0.0)
"""C0 ... C5 of a blunt tip, in nm."""
HEADERS = {
    "of .hld": "".join(f"Tip C{i}: {term} nm^2/nm^x\r\n" for i, term in enumerate(TIP)),
    "in one line": ", ".join(f"C{i} = {term:E}" for i, term in enumerate(TIP)) + "\r\n",
    "decimal commas": "".join(f"C{i}\t{term}\r\n".replace(".", ",") for i, term in enumerate(TIP)),
    "in rows": "\t".join(f"C{i}" for i in range(6)) + "\r\n" + "\t".join(map(str, TIP)) + "\r\n",
}


def blunt_indent():
    """Depth [nm] and force [mN] of an indent by that tip into a half-space of 72 GPa, nu = 0.2, to a contact depth of 60 nm."""
    reduced = 1.0 / ((1.0 - 0.2**2) / 72e9 + (1.0 - 0.07**2) / 1141e9)
    h = 60.0
    area = sum(term * h**power for term, power in zip(TIP, (2.0, 1.0, 0.5, 0.25, 0.125, 0.0625), strict=True))
    stiffness, force = 2e-9 * reduced * np.sqrt(area / np.pi), 8e9 * area * 1e-18
    top = h + 1e9 * 0.75 * force / stiffness
    end = top - 1e9 * 1.4 * force / stiffness
    part = np.linspace(0.0, 1.0, 200)
    depth = [top * part**0.55, np.full(40, top), end + (top - end) * part[::-1] ** (1.0 / 1.4)]
    return np.concatenate(depth), 1e3 * np.concatenate([force * part, np.full(40, force), force * part[::-1]])


@pytest.mark.parametrize("header", HEADERS)
def test_the_area_function_of_a_header_is_that_of_the_tip(header, tmp_path, capsys):
    """It was ignored, and the moduli of shallow indents came out several times too large."""
    lines = "File Version: Hysitron HighLoad\r\n" + HEADERS[header] + "Time_s\tDisp_nm\tForce_mN\r\n"
    depth, force = blunt_indent()
    lines += "".join(f"{0.05 * i:.3f}\t{h:.6f}\t{p:.8f}\r\n" for i, (h, p) in enumerate(zip(depth, force, strict=True)))
    path = tmp_path / "blunt.hld"
    path.write_text(lines, newline="")
    start = tmp_path / "start.toml"
    assert main(["inspect", str(path), "--problem", str(start)]) == 0
    assert "coefficients = [24.5, 3000.0, 8000.0, -500.0, 200.0]" in start.read_text()
    file = load_fit_file(start)
    data, _ = file.read_data(path)
    found = mdi.fit(data, **file.arguments)
    assert found.estimates["E"] == pytest.approx(72e9, rel=0.01)
    assert not any("area function" in words for words in found.warnings)
    # another tip in the problem file is reported
    start.write_text(start.read_text().replace(", 3000.0, 8000.0, -500.0, 200.0]", "]"))
    data, _ = load_fit_file(start).read_data(path)
    assert any("the file gives the area function of its tip" in words for words in data.warnings)


@pytest.mark.parametrize("line", ["Temp C0 5", "C1: 5", "C0: 0", "Compliance C0 and C1", "CO2: 24.5", "C0: 1e9\tC1: 3"])
def test_other_numbers_are_no_area_function(line):
    assert find_terms([[line]]) == []


def test_a_table_without_titles_is_no_file_of_an_afm(tmp_path):
    with pytest.raises(ProblemError, match=r"no line above the numbers has names for the 3 columns.*columns = "):
        curves(tmp_path, "bare.txt", kind="force-depth")
    # heights by equal steps with two deflections are a file of NT-MDT
    pytest.importorskip("afmformats")
    path = tmp_path / "nova.txt"
    path.write_text("".join(f"{-8.0 * i:.4f}\t{1.47 + 0.001 * i * i:.4f}\t{1.46 + 0.001 * i * i:.4f}\n" for i in range(40)))
    with pytest.raises(mdr.MDRError, match="deflection_sensitivity"):
        problem(tmp_path, "force-depth").curves(path)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("nanoscope.spm", "NanoScope Analysis, File > Export > ASCII"),
        ("triboscan.hys", "TriboScan"),
        ("other.hdf5", "afmformats"),
    ],
)
def test_files_that_are_not_read_are_refused_by_name(name, words, tmp_path):
    with pytest.raises(mdr.MDRError, match=words):
        curves(tmp_path, name)


def test_a_missing_file_is_told_at_once(tmp_path, capsys):
    problem(tmp_path)
    for name in ("missing.csv", "missing.txt", "missing.xlsx", "missing.jpk-force"):
        begin = time.process_time()
        assert main(["fit", str(tmp_path / name), "--problem", str(tmp_path / "problem.toml")]) == 1
        assert "no such file" in capsys.readouterr().err
        assert time.process_time() - begin < 0.5


def test_cycles_between_two_marks_are_found():
    """The marks of the last cycle leave those before it to the readings."""
    p = np.concatenate([np.linspace(a, b, 40) for a, b in [(0, 4), (4, 2), (2, 8), (8, 4), (4, 16)]] + [np.linspace(16, 2, 40)])
    h = np.sqrt(np.maximum.accumulate(p)) - 0.02 * (np.maximum.accumulate(p) - p)
    table = read_marks(["Surface Index", "End Of Loading Index"], [0, 200])
    kinds = [s.kind for s in segments_of_marks(table, h, p)]
    assert kinds[:5] == ["loading", "unloading", "loading", "unloading", "loading"]


def read_marks(words, rows):
    from mdrcontact.instruments.reading.marks import Mark

    return [Mark(row, word) for row, word in zip(rows, words, strict=True)]


def test_a_workbook_is_read_once(tmp_path, monkeypatch, capsys):
    """To inspect it was read two or three times, seconds each."""
    pytest.importorskip("openpyxl")
    path = written(tmp_path, "series.xlsx")
    reads = []
    read_sheets = columns.read_sheets
    monkeypatch.setattr(columns, "read_sheets", lambda *given: reads.append(given) or read_sheets(*given))
    assert main(["inspect", str(path), "--problem", str(tmp_path / "start.toml")]) == 0
    first = capsys.readouterr().out
    assert len(reads) == 1
    assert main(["inspect", str(path), "--problem", str(tmp_path / "start.toml"), "--overwrite"]) == 0
    assert capsys.readouterr().out == first, "what is kept is not added to"
    # another content under the same name is another workbook
    path.write_bytes(instruments.series(2))
    assert len(problem(tmp_path).curves(path)) == 2 and len(reads) == 2


@pytest.mark.parametrize("reader", ["python_calamine", "openpyxl"])
def test_both_readers_of_workbooks_give_the_same(reader, tmp_path, monkeypatch):
    pytest.importorskip(reader)
    path = written(tmp_path, "series.xlsx")
    if reader == "openpyxl":
        monkeypatch.setitem(sys.modules, "python_calamine", None)
    tables = read_tables(path)
    assert [table.name for table in tables] == ["Results", "Required Inputs", "Test 003", "Test 002", "Test 001"]
    _, h, p, begins = instruments.one_test()
    assert tables[-1].values[:, 1] == pytest.approx(h) and tables[-1].values[:, 2] == pytest.approx(p)
    assert [mark.row for mark in tables[-1].marks] == [*begins[:4]]


@pytest.mark.slow
def test_a_workbook_of_a_million_cells_is_read(tmp_path):
    """Fifteen sheets of 9,000 rows, as instruments write them."""
    pytest.importorskip("python_calamine")
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook(write_only=True)
    for i in range(15):
        sheet = book.create_sheet(f"Test {i:03}")
        sheet.append(["Segment", "Displacement", "Load", "Time", "Stiffness", "Hardness", "Modulus"])
        sheet.append(["", "nm", "mN", "s", "N/m", "GPa", "GPa"])
        for row in np.random.default_rng(i).random((9000, 6)).round(6).tolist():
            sheet.append([None, *row])
    book.save(tmp_path / "large.xlsx")
    assert [len(table.values) for table in read_tables(tmp_path / "large.xlsx")] == 15 * [9000]
