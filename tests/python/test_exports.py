# SPDX-License-Identifier: GPL-3.0-or-later
"""Workbooks, reports with their origin, and completion: what the command line writes for others."""

import csv
import hashlib
import html
import re
import shutil
import subprocess

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact.cli import COMMANDS, main
from mdrcontact.cli.workbook import as_xlsx
from mdrcontact.instruments.fitting import report
from mdrcontact.studies import Result, Words

PROBLEMS, FITS = ROOT / "examples" / "problems", ROOT / "examples" / "fit"


def sheets(path):
    """Rows of each sheet of a workbook."""
    openpyxl = pytest.importorskip("openpyxl")
    return {sheet.title: [[cell.value for cell in row] for row in sheet.rows] for sheet in openpyxl.load_workbook(path)}


@pytest.mark.parametrize(
    ("command", "name", "table"),
    [
        ("curve", "sio2_on_si", "states"),
        ("compare", "sio2_on_si", "states"),
        ("adhesion", "afm_on_pdms", "loop"),
        ("friction", "tin_on_steel", "states"),
        ("wear", "tin_on_steel", "states"),
        ("conduction", "tin_on_copper", "states"),
        ("history", "creep_of_pmma", "path"),
    ],
)
def test_a_workbook_has_the_rows_of_the_csv_file(command, name, table, tmp_path, capsys):
    pytest.importorskip("openpyxl")
    written = [tmp_path / "a.csv", tmp_path / "a.xlsx"]
    assert main([command, str(PROBLEMS / f"{name}.toml"), "--csv", str(written[0]), "--xlsx", str(written[1])]) == 0
    with written[0].open(newline="", encoding="utf-8") as file:
        titles, *rows = csv.reader(file)
    found = sheets(written[1])
    assert found[table][0] == titles and len(found[table]) == len(rows) + 1
    for cells, row in zip(found[table][1:], rows, strict=True):
        for cell, text in zip(cells, row, strict=True):  # a workbook has 16 digits
            assert cell == (pytest.approx(float(text), rel=1e-15) if isinstance(cell, (int, float)) else text or None)
    about = {row[0]: row[1] for row in found["result"]}
    assert about["command"].startswith(f"mdrcontact {command} ") and about["version"] == f"mdrcontact {mdr.__version__}"


def test_numbers_of_a_workbook_have_units_and_texts_are_no_formulas(tmp_path):
    pytest.importorskip("openpyxl")
    from mdrcontact._units import FORCE
    from mdrcontact.studies import Number

    found = Result(
        title="=1+1",
        numbers={"force": Number(2e-3, FORCE), "none": Number(float("nan"), FORCE)},
        tables={"curves": [Words("file", ['=HYPERLINK("a")', "b\x07c"])]},
        warnings=("-1",),
    )
    (tmp_path / "a.xlsx").write_bytes(as_xlsx(found, "mdrcontact curve"))
    read = sheets(tmp_path / "a.xlsx")
    assert read["result"][1][:3] == ["force", 2.0, "mN"] and read["result"][2][:2] == ["none", None]
    assert read["curves"] == [["file"], ['=HYPERLINK("a")'], ["bc"]]
    import openpyxl

    assert openpyxl.load_workbook(tmp_path / "a.xlsx")["curves"]["A2"].data_type == "s"


def test_a_workbook_that_could_not_be_written_is_refused_before_the_work(tmp_path, capsys, monkeypatch):
    problem = str(PROBLEMS / "sio2_on_si.toml")
    assert main(["curve", problem, "--xlsx", str(tmp_path / "a.xls")]) == 1
    assert capsys.readouterr() == ("", f"mdrcontact: {tmp_path / 'a.xls'}: the name of a workbook must end in .xlsx.\n")
    monkeypatch.setitem(__import__("sys").modules, "openpyxl", None)
    assert main(["curve", problem, "--xlsx", str(tmp_path / "a.xlsx")]) == 1
    assert 'pip install "mdrcontact[instruments]"' in capsys.readouterr().err and not list(tmp_path.iterdir())


def origin_of(path):
    """Hashes by file, and the preformatted texts, of a report."""
    text = path.read_text(encoding="utf-8")
    part = text[text.index("<h2>Origin</h2>") :]
    rows = re.findall(r"<tr><td>(.*?)</td><td>(\d+)</td><td>([0-9a-f]{64})</td></tr>", part)
    return {html.unescape(name): (int(size), digest) for name, size, digest in rows}, [
        html.unescape(words) for words in re.findall(r"<pre>(.*?)</pre>", part, flags=re.DOTALL)
    ]


@pytest.mark.parametrize(
    ("command", "name"), [("fit", "sphere_on_oxide"), ("modulus", "csm_on_oxide"), ("calibrate", "csm_on_silica")]
)
def test_a_report_states_where_it_comes_from(command, name, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    data, problem = tmp_path / f"{name}.csv", tmp_path / f"{name}.toml"
    for path in (data, problem):
        shutil.copy(FITS / path.name, path)
    words = [command, str(data), "--problem", str(problem), "--report", str(tmp_path / "report.html")]
    words += ["--output", str(tmp_path / "tip.toml")] if command == "calibrate" else []
    assert main(words) == 0
    files, (line, text) = origin_of(tmp_path / "report.html")
    for path in (data, problem):
        content = path.read_bytes()
        assert files[str(path)] == (len(content), hashlib.sha256(content).hexdigest())
    assert line == " ".join(["mdrcontact", *words]) and text == problem.read_text(encoding="utf-8")


def test_files_that_the_problem_names_are_part_of_the_origin(tmp_path, capsys):
    """A calibrated tip, and every file of a folder."""
    pytest.importorskip("matplotlib")
    folder = tmp_path / "curves"
    folder.mkdir()
    for i in range(2):
        shutil.copy(FITS / "csm_on_oxide.csv", folder / f"{i}.csv")
    text = (FITS / "csm_on_oxide.toml").read_text(encoding="utf-8")
    (tmp_path / "problem.toml").write_text(text, encoding="utf-8")
    assert main(["fit", str(folder), "--problem", str(tmp_path / "problem.toml"), "--report", str(tmp_path / "a.html")]) == 0
    files, _ = origin_of(tmp_path / "a.html")
    assert {str(folder / "0.csv"), str(folder / "1.csv"), str(tmp_path / "problem.toml")} == set(files)


def test_a_gel_has_figure_and_report(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    text = (FITS / "punch_on_hydrogel.toml").read_text(encoding="utf-8")
    # a free nu needs tables, which take seconds
    text = text.replace("nu = 0.2\n", "nu = 0.28\n").replace(', "nu", ', ", ")
    (tmp_path / "gel.toml").write_text(text, encoding="utf-8")
    data, problem = str(FITS / "punch_on_hydrogel.csv"), str(tmp_path / "gel.toml")
    written = tmp_path / "gel.png", tmp_path / "gel.html"
    words = ["fit", data, "--problem", problem, "--plot", str(written[0]), "--report", str(written[1]), "--compare"]
    assert main(words) == 0
    assert origin_of(written[1])[1] == [" ".join(["mdrcontact", *words]), text]
    text = written[1].read_text(encoding="utf-8")
    assert written[0].read_bytes().startswith(b"\x89PNG") and "shear modulus G (shear_modulus)" in text
    assert "<h2>Drainages</h2>" in text and "data:image/png;base64," in text
    assert main(["fit", data, "--problem", problem, "--ranges", str(tmp_path / "ranges.png")]) == 2
    assert "--ranges: fits of gels do not support it." in capsys.readouterr().err


def test_an_origin_escapes_what_it_quotes():
    text = "".join(report.origin({"<b>.csv": b"1"}, 'title = "<script>"', "mdrcontact fit '<b>.csv'"))
    assert "<b>" not in text and "<script>" not in text and hashlib.sha256(b"1").hexdigest() in text
    assert "Command:" not in "".join(report.origin({}, ""))


def test_rows_of_many_fits_have_settings_and_reasons(tmp_path, capsys):
    """Each bad curve is named with its reason, each row has the fixed numbers and how its file was read."""
    folder = tmp_path / "curves"
    folder.mkdir()
    shutil.copy(FITS / "sphere_on_oxide.csv", folder / "good.csv")
    (folder / "broken.csv").write_text("depth [nm],load [mN]\n1,x\n2,y\n")
    head, *rows = (FITS / "sphere_on_oxide.csv").read_text(encoding="utf-8").splitlines()
    noisy = np.random.default_rng(5)
    loud = [f"{a},{float(b) + 5.0 * noisy.standard_normal()}" for a, b in (row.split(",")[:2] for row in rows)]
    (folder / "loud.csv").write_text("\n".join([",".join(head.split(",")[:2]), *loud]))
    table = tmp_path / "estimates.csv"
    assert main(["fit", str(folder), "--problem", str(FITS / "sphere_on_oxide.toml"), "--csv", str(table)]) == 0
    with table.open(newline="", encoding="utf-8") as file:
        found = {row["file"]: row for row in csv.DictReader(file)}
    assert found["broken.csv"]["warnings"].startswith("not fitted: ") and "broken.csv" in found["broken.csv"]["warnings"]
    assert found["loud.csv"]["sound"] == "0" and re.match(r"(misses|noise|error)", found["loud.csv"]["warnings"])
    assert found["good.csv"]["sound"] == "1" and found["good.csv"]["model"] == "exact"
    assert float(found["good.csv"]["fixed substrate.E [GPa]"]) == 163.0
    assert "from column" in found["good.csv"]["read"] and "read" in found["broken.csv"]


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_a_shell_completes_each_command(shell, capsys):
    pytest.importorskip("shtab")
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    names = {command.__name__.rpartition(".")[2] for command in COMMANDS}
    assert all(re.search(rf"\b{name}\b", script) for name in names) and "--xlsx" in script
    if shell == "bash" and shutil.which("bash"):
        words = 'COMP_WORDS=(mdrcontact fit --interval p); COMP_CWORD=3; _shtab_mdrcontact; echo "${COMPREPLY[*]}"'
        run = subprocess.run(["bash", "-c", f"{script}\n{words}"], capture_output=True, text=True, check=True)
        assert run.stdout.split() == ["profile"]


def test_without_shtab_the_command_says_what_to_install(monkeypatch, capsys):
    monkeypatch.setitem(__import__("sys").modules, "shtab", None)
    assert main(["completion", "bash"]) == 1
    assert capsys.readouterr() == (
        "",
        'mdrcontact: the script needs shtab. Install it with pip install "mdrcontact[completion]".\n',
    )
