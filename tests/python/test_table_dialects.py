# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in every dialect of separators, decimal marks and groups of thousands are read exactly or refused, never otherwise."""

from __future__ import annotations

import os
import subprocess
import sys
import time

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mdrcontact.instruments.reading import cells
from mdrcontact.instruments.reading.columns import TableOptions, read_table
from mdrcontact.problem import ProblemError

GROUPS = {".": ("", "", ",", "'", " ", "\N{NO-BREAK SPACE}"), ",": ("", "", ".", "'", " ", "\N{NARROW NO-BREAK SPACE}")}


def spelled(value, decimals, mark, group):
    """A number in the words of a language, and what it then is."""
    text = f"{value:,.{decimals}f}" if decimals >= 0 else f"{value:.{-decimals}e}"
    exact = float(text.replace(",", ""))
    return text.translate(str.maketrans({",": group, ".": mark})), exact


@st.composite
def dialects(draw):
    """(bytes of a file, its values, whether nothing in it is doubtful)"""
    mark = draw(st.sampled_from(".,"))
    separator = draw(st.sampled_from(["\t", ";", ",", "  "]))
    group = draw(st.sampled_from(GROUPS[mark]))
    decimals = draw(st.lists(st.sampled_from([0, 0, 1, 2, 3, 3, 4, -3, -5]), min_size=2, max_size=4))
    sizes = draw(st.lists(st.sampled_from([1.0, 30.0, 3e3, 4e6]), min_size=len(decimals), max_size=len(decimals)))
    gap = draw(st.sampled_from(["", "nan", "-", "---", "#N/A"]))
    lost = draw(st.booleans())
    rows, values = [], []
    for i in range(draw(st.integers(2, 9))):
        cells = [spelled(draw(st.floats(-s, s)), d, mark, group) for s, d in zip(sizes, decimals, strict=True)]
        missing = draw(st.integers(0, len(cells) - 1)) if lost and i and len(cells) > 2 and draw(st.booleans()) else -1
        rows.append([gap if j == missing else text for j, (text, _) in enumerate(cells)])
        values.append([np.nan if j == missing else exact for j, (_, exact) in enumerate(cells)])
    # between commas nothing but quotes shows a decimal comma
    quoted = (
        draw(st.booleans())
        or separator == mark == ","
        or any(separator in cell or separator == "  " and " " in cell for row in rows for cell in row)
    )
    titles = [f"column_{j}" for j in range(len(decimals))]
    units = draw(st.booleans())
    table = [titles if units else [f"{title} [nm]" for title in titles], *([["nm"] * len(titles)] if units else []), *rows]
    if quoted:
        table = [[f'"{cell}"' for cell in row] for row in table]
    lines = [separator.join(row) for row in table]
    if draw(st.booleans()):
        lines = ["made by a program", *lines]
    if draw(st.booleans()):
        lines.insert(draw(st.integers(0, len(lines))), "# a comment, with 1.5; 2,5 in it")
    if draw(st.booleans()):
        lines.insert(draw(st.integers(0, len(lines))), "")
    text = draw(st.sampled_from(["\n", "\r\n"])).join(lines) + draw(st.sampled_from(["", "\n"]))
    encodings = ["utf-8", "utf-8-sig", "utf-16"] + (["latin-1"] if "\N{NARROW NO-BREAK SPACE}" not in text else [])
    shown = any(d in (1, 2, 4, -3, -5) for d in decimals)
    clear = shown and not (separator == "  " and not quoted and (lost and gap == "" or group.isspace()))
    return text.encode(draw(st.sampled_from(encodings))), np.array(values), clear


@settings(max_examples=int(os.environ.get("MDRCONTACT_DRAWS", "400")), deadline=None, suppress_health_check=list(HealthCheck))
@given(dialects())
def test_a_dialect_is_read_exactly_or_refused(tmp_path_factory, drawn):
    content, values, clear = drawn
    path = tmp_path_factory.getbasetemp() / "dialect.txt"
    path.write_bytes(content)
    try:
        found = read_table(path)
    except ProblemError:
        assert not clear
        return
    np.testing.assert_array_equal(found.values, values)


def read(tmp_path, text, options=None):
    path = tmp_path / "table.txt"
    path.write_text(text, encoding="utf-8")
    return read_table(path, options)


def outcome(path):
    """What a table is read as, or the error."""
    try:
        table = read_table(path)
    except ProblemError as problem:
        return str(problem)
    return table.titles, table.values.tobytes(), table.values.shape, table.notes, table.units, table.warnings


@settings(max_examples=int(os.environ.get("MDRCONTACT_DRAWS", "200")), deadline=None, suppress_health_check=list(HealthCheck))
@given(dialects())
def test_numbers_below_words_are_read_as_cells_are(tmp_path_factory, drawn):
    """Lines of numbers alone are read by NumPy, with the same outcome as cell by cell."""
    path = tmp_path_factory.mktemp("table") / "table.txt"
    path.write_bytes(drawn[0])
    found = outcome(path)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(cells, "_words_above", len)
        assert outcome(path) == found


@pytest.mark.parametrize(
    "text",
    [
        "depth [nm],force [mN]\n1,2\n2,3\n3,4\n",
        "depth [nm],force [mN],\n1,2,\n2,3,\n3,4,\n",
        'a,b\n"1\n2",3\n1,2\n2,3\n',
        "depth [nm] force [mN]\n 1  2\n 2  3 \n 3 4\n",
        "a;b\n1,5;2\n2,25;3\n3;4\n",
        "a;b\n1.250;2\n2.125;3\n",
        "a\tb\n1\t2\n1\t2\t3\n2\t3\n",
        "a,b\n1,2\nend,of\n2,3\n3,4\n4,5\n",
        "a,b\ne,E\n1,2\n2,3\n",
        "a;b\n1;\n2;3\n;4\n5;6\n",
    ],
)
def test_lines_of_numbers_are_read_as_cells_are(text, tmp_path, monkeypatch):
    path = tmp_path / "table.txt"
    path.write_text(text)
    found = outcome(path)
    monkeypatch.setattr(cells, "_words_above", len)
    assert outcome(path) == found


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("h [nm]\tF [mN]\n900\t0.5\n950\t0.6\n1,000\t0.7\n1,050\t0.8\n", [900, 950, 1000, 1050]),
        ("h [nm]\tF [mN]\n900\t0,5\n950\t0,6\n1.000\t0,7\n1.050\t0,8\n", [900, 950, 1000, 1050]),
        ("h [nm];F [mN]\n900;0.5\n1'000;0.6\n1,234,567.5;0.7\n", [900, 1000, 1234567.5]),
        ("h [nm],F [mN]\n0.5,1 000.0\n1 000 000,1 000 000.0\n", [0.5, 1e6]),
        ("h [nm],F [mN]\n0,1 000 000.0\n0,1 000 000.0\n", [0.0, 0.0]),
        ("h [nm];F [mN]\n1.5D+03;0.5\n2.5d-01;0.6\n", [1500, 0.25]),
        ('h [nm],F [mN]\n"1,000",0.5\n"1,050",0.6\n', [1000, 1050]),
        ('h [nm],F [mN]\n"1,5","0,5"\n"2,5","0,6"\n', [1.5, 2.5]),
        ("h [nm],F [mN]\n1.000,2.000\n1.050,2.125\n", [1.0, 1.05]),
        ("h [nm]\tF [mN]\n\N{MINUS SIGN}1.25\t2\n1\t3\n", [-1.25, 1.0]),
        ('"h\n[nm]";"F\n[mN]"\n1,5;2,5\n2,5;3,5\n', [1.5, 2.5]),
    ],
)
def test_one_decimal_mark_a_table(text, values, tmp_path):
    assert read(tmp_path, text).values[:, 0].tolist() == values


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("h [nm]\tF [mN]\n1,000\t1,100\n1,050\t1,200\n", r"line 2, column 'h \[nm\]': '1,000' may be 1000 or 1.0000.*decimal ="),
        ("h [nm]\tF [mN]\n1.000\t1.100\n1.050\t1.200\n", "'1.000' may be 1000 or 1.0000"),
        ("h [nm],F [mN]\n900,0\n1.000,1\n", "'1.000' may be 1000 or 1.0000"),
        ("h [nm];F [mN]\n1.5;2,5\n2.5;3,5\n", r"line 2, column 'F \[mN\]': '2,5' does not go with '1.5' in line 2"),
        ("# x\nh [nm];F [mN]\n1,5;2\n1.000.000,5;3\n2.5;4\n", "line 5.*'2.5' does not go with '1,5' in line 3"),
        ("h [nm];F [mN]\n1.5;2\n1,00,000;3\n2.5;4\n", "line 3.*'1,00,000' is no number with a decimal point"),
        ("h[nm] F[mN] t[s]\n1.5 2 3\n1.5 2\n2.5 4 5\n", "line 3 has another number of words"),
        ("h[nm] F[mN] t[s] T[s]\n1.5 2 3 4\n1.5 2\n2.5 4 5 6\n", "line 3 holds numbers, but not one for each of the 4 columns"),
        ("radius of contact[nm]\n1.5 2\n1.5 2\n2.5 4\n", "no line above the numbers has names"),
        ('h [nm];F [mN]\n1;2\n"3;4\n5;6\n7;8\n9;10\n11;12\n', "line 3: a quote begins a cell that does not end"),
    ],
)
def test_what_may_mean_two_things_is_refused(text, words, tmp_path):
    with pytest.raises(ProblemError, match=words):
        read(tmp_path, text)


@pytest.mark.parametrize(("mark", "value"), [(".", 1000.0), (",", 1.0)])
def test_the_decimal_mark_may_be_named(mark, value, tmp_path):
    text = "h [nm]\tF [mN]\n1,000\t1,100\n1,050\t1,200\n"
    assert read(tmp_path, text, TableOptions(decimal=mark)).values[0, 0] == value


def test_rows_without_numbers_keep_their_place(tmp_path):
    found = read(tmp_path, "h [nm],F [mN],\n" + 5000 * "1.5,2,\n" + ",\n" + 5000 * "2.5,3,\n").values
    assert len(found) == 10001 and np.isnan(found[5000]).all() and found[5001].tolist() == [2.5, 3.0]


def test_dates_beside_numbers_are_no_numbers(tmp_path):
    found = read(tmp_path, "day;h [nm];F [mN]\n12.05.2024;1,5;2\n13.05.2024;2,5;3\n").values
    assert np.isnan(found[:, 0]).all() and found[:, 1].tolist() == [1.5, 2.5]


MANY = np.column_stack([np.arange(1_000_000) * 1e-3, np.linspace(0.0, 500.0, 1_000_000)])


@pytest.fixture(scope="module")
def long_file(tmp_path_factory):
    """A million rows."""
    path = tmp_path_factory.mktemp("long") / "long.csv"
    np.savetxt(path, MANY, fmt="%.9g", delimiter=",", header="time [s],depth [nm]", comments="")
    return path


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["as it is", "decimal commas", "separators at the end"])
def test_a_million_rows_take_seconds(kind, long_file, tmp_path):
    text = long_file.read_text()
    changed = {"decimal commas": text.replace(",", ";").replace(".", ","), "separators at the end": text.replace("\n", ",\n")}
    path = tmp_path / "many.csv"
    path.write_text(changed.get(kind, text))
    start = time.process_time()
    found = read_table(path).values
    assert time.process_time() - start < 5.0
    np.testing.assert_allclose(found, MANY, rtol=1e-8)


@pytest.mark.slow
def test_too_little_memory_is_an_error_in_words(long_file):
    """With 40 MB more than the empty program has, a file of 20 MB is too large."""
    program = (
        "import resource, sys\nfrom pathlib import Path\nfrom mdrcontact.instruments.reading import columns\n"
        "pages = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
        "resource.setrlimit(resource.RLIMIT_AS, (pages + 40_000_000, -1))\n"
        "try:\n    columns.read_table(Path(sys.argv[1]))\n"
        "except columns.ProblemError as problem:\n    print(problem)\n"
    )
    done = subprocess.run([sys.executable, "-c", program, long_file], capture_output=True, text=True, check=True)
    assert "there is not enough memory to read its" in done.stdout
