# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as instruments write them: each file is written here in its format, read, and gives the same numbers."""

from __future__ import annotations

import numpy as np
import pytest

from mdrcontact._units import FORCE, LENGTH
from mdrcontact.instruments.reading.columns import TableOptions, read_table
from mdrcontact.problem import ProblemError

DEPTH = np.linspace(1.0, 20.0, 20)
LOAD = 0.01 * DEPTH**1.5
MICRO = "\N{MICRO SIGN}"
POINT = [f"{d:.4f}\t{p:.6f}" for d, p in zip(DEPTH, LOAD, strict=True)]


def table(lines, separator="\t"):
    return "\n".join(line.replace("\t", separator) for line in lines) + "\n"


FORMATS = {
    "one header line": (table(["depth [nm]\tload [mN]", *POINT], ",").encode(), TableOptions()),
    "a row of units": (
        table(["Displacement Into Surface\tLoad On Sample", "nm\tmN", *POINT]).encode(),
        TableOptions(),
    ),
    "units in brackets of their own, preamble": (
        table(["Instrument: X", "Operator;A", "", "Pd\tFn", "[nm]\t[mN]", *POINT], ";").encode(),
        TableOptions(),
    ),
    "TriboScan: preamble and spaces": (
        table(["Test from a place", "Number of Points = 20", "Depth (nm)\tLoad (mN)", *POINT]).encode(),
        TableOptions(),
    ),
    "Latin-1": (
        table([f"Depth (nm)\tLoad (mN)\tnote {MICRO}", *(p + "\t1" for p in POINT)]).encode("latin-1"),
        TableOptions(),
    ),
    "Latin-1 with a micro sign as unit": (
        table([f"Depth ({MICRO}m)\tLoad (mN)", *(f"{1e-3 * d:.7f}\t{0.01 * d**1.5:.6f}" for d in DEPTH)]).encode("latin-1"),
        TableOptions(),
    ),
    "UTF-16": (table(["depth [nm]\tload [mN]", *POINT]).encode("utf-16"), TableOptions()),
    "decimal commas": (table(["depth [nm]\tload [mN]", *POINT], ";").replace(".", ",").encode(), TableOptions()),
    "groups of thousands": (
        table(["depth [pm]\tload [nN]", *(f"{1e3 * d:,.1f}\t{1e4 * d**1.5:,.1f}" for d in DEPTH)]).encode(),
        TableOptions(),
    ),
    "the same with decimal commas": (
        table(["depth [pm]\tload [nN]", *(f"{1e3 * d:,.1f}\t{1e4 * d**1.5:,.1f}" for d in DEPTH)])
        .translate(str.maketrans(",.", ".,"))
        .encode(),
        TableOptions(),
    ),
    "spaces between words and units": (table(["depth [nm]\tload_[mN]", *POINT], "  ").encode(), TableOptions()),
    "spaces, no header": (
        table(POINT, "   ").encode(),
        TableOptions(columns=("depth [nm]", "load [mN]")),
    ),
    "no units": (table(["depth\tload", *POINT]).encode(), TableOptions(units={"depth": "nm", "load": "mN"})),
    "comments": (table(["# made by x", "depth_nm\tload_mN", *POINT]).encode(), TableOptions()),
    "lines to pass over": (table(["1\t2", "3\t4", "depth [nm]\tload [mN]", *POINT]).encode(), TableOptions(skip=2)),
}


@pytest.mark.parametrize("name", FORMATS)
def test_a_format_is_read(name, tmp_path):
    content, options = FORMATS[name]
    path = tmp_path / "curve.txt"
    path.write_bytes(content)
    found = read_table(path, options)
    depth, _ = found.column(found.find("depth", ("depth", "pd", "displacement into surface"), LENGTH), LENGTH)
    load, _ = found.column(found.find("force", ("load", "fn", "load on sample"), FORCE), FORCE)
    assert depth == pytest.approx(1e-9 * DEPTH, rel=1e-4)
    assert load == pytest.approx(1e-3 * LOAD, rel=1e-3)
    assert "20 rows" in found.notes[0]


def test_sheets_of_a_spreadsheet(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.active.title = "Summary"
    book.active.append(["made by", "someone"])
    sheet = book.create_sheet("Test 1")
    sheet.append(["Displacement Into Surface", "Load On Sample"])
    sheet.append(["nm", "mN"])
    for d, p in zip(DEPTH, LOAD, strict=True):
        sheet.append([d, p])
    path = tmp_path / "curve.xlsx"
    book.save(path)
    found = read_table(path)
    assert found.column("Displacement Into Surface", LENGTH)[0] == pytest.approx(1e-9 * DEPTH)
    assert "Test 1" in found.notes[0]
    with pytest.raises(ProblemError, match="Test 1"):
        read_table(path, TableOptions(sheet="Test1"))
    # numbers kept as words, with a decimal comma
    for row in sheet.iter_rows(min_row=3):
        for cell in row:
            cell.value = str(cell.value).replace(".", ",")
    book.create_chartsheet("Chart").add_chart(openpyxl.chart.ScatterChart())
    book.save(path)
    assert read_table(path).column("Load On Sample", FORCE)[0] == pytest.approx(1e-3 * LOAD)
    with pytest.raises(ProblemError, match="no sheet 'Chart'"):
        read_table(path, TableOptions(sheet="Chart"))
    archive = path.read_bytes()
    place = archive.index(b"xl/worksheets/sheet2.xml") + 60
    path.write_bytes(archive[:place] + bytes(len(archive[place : place + 200])) + archive[place + 200 :])
    with pytest.raises(ProblemError, match="cannot be read as a spreadsheet"):
        read_table(path)


BAD = {
    "only its unit is missing": (table(["depth\tload", *POINT]).encode(), TableOptions(), "does not state its unit"),
    "no header": (table(POINT).encode(), TableOptions(), "columns ="),
    "decimal commas between commas": (b"depth [nm],load [mN]\n1,5,2,5\n2,5,3,5\n", TableOptions(), "decimal signs"),
    "some decimal commas between commas": (b"depth [nm],load [mN]\n1,2,5\n2,3,5\n", TableOptions(), "decimal signs"),
    "a cell without end": (b"a" * 200_000 + b"\n1\n2\n", TableOptions(), "no table"),
    "another unit": (b"depth [mN],load [mN]\n1,2\n2,3\n", TableOptions(), "'mN' is no unit of a length"),
    "no numbers": (b"a,b\nc,d\n", TableOptions(), "no table"),
    "empty": (b"", TableOptions(), "no table"),
    "binary": (bytes(range(1, 8)) + b"\0\0abc" * 30, TableOptions(), "not a text file"),
    "wrong number of columns": (table(POINT).encode(), TableOptions(columns=("a",)), "2"),
    "same title twice": (table(["depth [nm]\tdepth [nm]", *POINT]).encode(), TableOptions(), "same title"),
    "units of a column that is not": (table(["depth\tload", *POINT]).encode(), TableOptions(units={"dept": "nm"}), "depth"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_tables_are_refused_in_words(name, tmp_path):
    content, options, words = BAD[name]
    path = tmp_path / "curve.csv"
    path.write_bytes(content)
    with pytest.raises(ProblemError, match=words):
        found = read_table(path, options)
        found.find("depth", ("depth",), LENGTH)


@pytest.mark.parametrize("suffix", [".xlsx", ".xls"])
def test_what_is_no_spreadsheet_is_refused(suffix, tmp_path):
    pytest.importorskip("openpyxl")
    path = tmp_path / f"curve{suffix}"
    path.write_bytes(b"no archive")
    with pytest.raises(ProblemError, match="spreadsheet"):
        read_table(path)
