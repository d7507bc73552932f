# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit`: the examples, folders with bad curves, refusals."""

from __future__ import annotations

import json
import shutil

import pytest
from conftest import ROOT

from mdrcontact.cli import main

FOLDER = ROOT / "examples" / "fit"
TRUTH = {
    "sphere_on_oxide": {"coating.E": 72e9, "thickness": 500e-9, "depth_offset": 1.5e-9},
    "afm_on_rubber": {"coating.E": 2e6, "work_of_adhesion": 0.05},
    "csm_on_oxide": {"coating.E": 72e9, "thickness": 500e-9},
    "modulus_of_oxide": {"coating.E": 72e9, "substrate.E": 163e9},
    "punches_on_rubber": {"coating.E": 2e6, "thickness": 2e-6},
    "indent_on_oxide": {"coating.E": 72e9},
    "raw_afm_on_rubber": {"coating.E": 2e6},
    "csm_on_silica": {"indenter.C1": 1200e-9, "frame_compliance": 1e-7},
}
"""What examples/fit/make_data.py was told."""


@pytest.mark.parametrize("name", TRUTH)
def test_examples_find_what_their_data_were_made_of(name, tmp_path, capsys):
    """Within 3.5 standard errors, and at least one part in 1000 (the adhesive curve was made by numerical differentiation)."""
    written = tmp_path / "fit.json", tmp_path / "points.csv", tmp_path / "fit.png"
    options = ["--json", str(written[0]), "--csv", str(written[1]), "--plot", str(written[2])]
    data = next(path for path in FOLDER.glob(f"{name}.*") if path.suffix != ".toml")
    assert main(["fit", str(data), "--problem", str(FOLDER / f"{name}.toml"), *options]) == 0
    found = json.loads(written[0].read_text())
    assert found["converged"]
    for parameter, true in TRUTH[name].items():
        entry = found["parameters"][parameter]
        assert abs(entry["value"] - true) < max(3.5 * entry["standard_error"], 1e-3 * true)
    assert "from column" in capsys.readouterr().out
    assert written[1].read_text().count("\n") == found["points"] + 1
    assert written[2].read_bytes().startswith(b"\x89PNG")


def test_folder_reports_bad_curves_and_fits_the_rest(tmp_path, capsys):
    curves = tmp_path / "curves"
    curves.mkdir()
    for i in range(3):
        shutil.copy(FOLDER / "sphere_on_oxide.csv", curves / f"good{i}.csv")
    (curves / "empty.csv").write_text("depth [nm],load [mN]\n")
    (curves / "words.csv").write_text("depth [nm],load [mN]\n1,x\n2,y\n3,z\n4,w\n")
    table = tmp_path / "estimates.csv"
    assert main(["fit", str(curves), "--problem", str(FOLDER / "sphere_on_oxide.toml"), "--csv", str(table)]) == 0
    out = capsys.readouterr().out
    assert "3 of 5 curves fitted" in out
    assert "3 of 5 fits describe their data" in out
    rows = {line.split()[0]: line for line in out.splitlines() if line.startswith(("good", "empty", "words"))}
    assert "not fitted" in rows["empty.csv"] and "not fitted" in rows["words.csv"]
    assert "GPa" in rows["good0.csv"] and rows["good0.csv"].endswith("yes")
    written = table.read_text().splitlines()
    assert len(written) == 6, "failures are rows"
    assert any(line.startswith("words.csv,") and "not fitted" in line for line in written)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('kind = "force-depth"', 'kind = "force-dept"', "force-depth"),
        ('thickness = { prior = "500 nm", prior_sd = "10 nm" }', "thicknes = {}", "thickness"),
        ('prior_sd = "10 nm"', 'prior_sd = "10 mN"', "length"),
        (', prior_sd = "10 nm"', "", "prior_sd"),
        ("relative_sd = 0.01", 'force = "P"', "there is no column"),
        ("[data]", "[daten]", "data"),
    ],
)
def test_faults_of_the_problem_file_are_told(old, new, words, tmp_path, capsys):
    text = (FOLDER / "sphere_on_oxide.toml").read_text()
    assert old in text
    problem = tmp_path / "problem.toml"
    problem.write_text(text.replace(old, new))
    assert main(["fit", str(FOLDER / "sphere_on_oxide.csv"), "--problem", str(problem)]) == 2
    assert words in capsys.readouterr().err


def test_data_in_wrong_units_are_refused(tmp_path, capsys):
    """mN read as N."""
    data = tmp_path / "curve.csv"
    data.write_text((FOLDER / "sphere_on_oxide.csv").read_text().replace("[mN]", "[N]"))
    assert main(["fit", str(data), "--problem", str(FOLDER / "sphere_on_oxide.toml")]) == 1
    assert "check the units" in capsys.readouterr().err


def test_separators_and_decimal_commas(tmp_path, capsys):
    """The same curve with tabs, and with semicolons and decimal commas."""
    text = (FOLDER / "sphere_on_oxide.csv").read_text()
    results = []
    for name, content in (
        ("a.csv", text),
        ("b.tsv", text.replace(",", "\t")),
        ("c.csv", text.replace(",", ";").replace(".", ",")),
        ("d.csv", "# made up\n" + text.replace("depth [nm],load [mN]", "h_nm,P_mN")),
    ):
        data, out = tmp_path / name, tmp_path / f"{name}.json"
        data.write_text(content)
        assert main(["fit", str(data), "--problem", str(FOLDER / "sphere_on_oxide.toml"), "--json", str(out)]) == 0
        results.append(json.loads(out.read_text())["parameters"]["coating.E"]["value"])
    assert len(set(results)) == 1
    assert "separated by tabs" in capsys.readouterr().out
