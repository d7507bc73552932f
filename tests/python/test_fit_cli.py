# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit`: the examples, folders with bad curves, refusals."""

from __future__ import annotations

import json
import shutil

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file

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
"""The constants of examples/fit/make_data.py."""


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
    assert "3 of 5 fits describe their data to 5 % or better" in out
    rows = {line.split()[0]: line for line in out.splitlines() if line.startswith(("good", "empty", "words"))}
    assert "not fitted" in rows["empty.csv"] and "not fitted" in rows["words.csv"]
    assert "GPa" in rows["good0.csv"] and rows["good0.csv"].endswith("describes")
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
        (
            "[fit.free]",
            '[[fit.joint_prior]]\nnames = ["coating.nu", "coating.nu"]\nvalues = [0.2, 0.3]\nsds = [0.1, 0.1]\n[fit.free]',
            "Name each parameter once",
        ),
        ("relative_sd = 0.01", 'force = "P"', "there is no column"),
        ("[data]", "[daten]", "data"),
        ("[data]", '[adhesion]\nwork_of_adhesion = "50 mJ/m^2"\n[data]', "Write work_of_adhesion in [instrument]"),
        (
            "[fit.free]",
            '[fit]\nsd_is_absolute = "no"\n[fit.free]',
            "sd_is_absolute = 'no': it must be true or false",
        ),
    ],
)
def test_faults_of_the_problem_file_are_told(old, new, words, tmp_path, capsys):
    text = (FOLDER / "sphere_on_oxide.toml").read_text()
    assert old in text
    problem = tmp_path / "problem.toml"
    problem.write_text(text.replace(old, new))
    assert main(["fit", str(FOLDER / "sphere_on_oxide.csv"), "--problem", str(problem)]) == 2
    assert words in capsys.readouterr().err


def test_intervals_and_moduli_by_depth_stand_in_tables(tmp_path, capsys):
    files = ["--ranges", str(tmp_path / "ranges.png"), "--json", str(tmp_path / "fit.json"), "--interval", "profile"]
    data = FOLDER / "sphere_on_oxide"
    assert main(["fit", f"{data}.csv", "--problem", f"{data}.toml", *files]) == 0
    lines = capsys.readouterr().out.splitlines()
    title = next(i for i, line in enumerate(lines) if "95 % interval (profile)" in line)
    assert "estimate ± standard error" in lines[title] and lines[title + 1].count("GPa") == 2
    found = json.loads((tmp_path / "fit.json").read_text())
    low, high = (end / 1e9 for end in found["parameters"]["coating.E"]["profile_interval"])
    assert f"{low:.2f} to {high:.2f} GPa" in lines[title + 1]
    first = next(i for i, line in enumerate(lines) if line.startswith("end of the depth [nm]"))
    assert "film modulus E [GPa]" in lines[first] and "±" in lines[first + 1]
    assert lines[first + len(found["ranges"])].split()[0] and len(found["ranges"]) >= 5


def test_data_in_wrong_units_are_refused(tmp_path, capsys):
    """mN read as N."""
    data = tmp_path / "curve.csv"
    data.write_text((FOLDER / "sphere_on_oxide.csv").read_text().replace("[mN]", "[N]"))
    assert main(["fit", str(data), "--problem", str(FOLDER / "sphere_on_oxide.toml")]) == 1
    assert "Check the units" in capsys.readouterr().err


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


@pytest.mark.parametrize(("young", "nu"), [(72.0, 0.17), (411.0, 0.28)], ids=["fused silica", "tungsten"])
@pytest.mark.parametrize("kind", ["force-depth", "stiffness-depth"])
def test_tip_calibration_with_a_diamond(young, nu, kind, tmp_path):
    """The radius of a diamond tip from indents in a body whose material is known, against Hertz (1882): no E* is typed."""
    R, reduced = 2e-6, 1e9 / ((1 - nu**2) / young + (1 - 0.07**2) / 1141.0)
    d = np.linspace(5e-9, 80e-9, 30)
    force, stiffness = 4 / 3 * reduced * np.sqrt(R) * d**1.5, 2 * reduced * np.sqrt(R * d)
    curve, problem, result = tmp_path / "curve.csv", tmp_path / "problem.toml", tmp_path / "fit.json"
    header, columns = "depth [nm],force [uN],stiffness [uN/nm]", [d * 1e9, force * 1e6, stiffness * 1e-3]
    np.savetxt(curve, np.transpose(columns), delimiter=",", header=header, comments="")
    # a sphere's depth of contact: h_c = d - 3/4 F/S = d/2 is the height of a paraboloid at the contact radius
    problem.write_text(
        f"""
        [indenter]
        shape = "paraboloid"
        radius = "1 um"
        material = {{ E = "1141 GPa", nu = 0.07 }}
        [medium]
        type = "homogeneous"
        material = {{ E = "{young} GPa", nu = {nu} }}
        [data]
        kind = "{kind}"
        [fit]
        free = ["indenter.radius"]
        """
    )
    assert main(["fit", str(curve), "--problem", str(problem), "--json", str(result)]) == 0
    assert json.loads(result.read_text())["parameters"]["indenter.radius"]["value"] == pytest.approx(R, rel=1e-7)


def test_a_coated_indenter_may_be_what_is_sought(tmp_path):
    """The film of a coated ball on a known one, from a problem file."""
    tin, steel, dlc = mdr.Elastic(450e9, 0.25), mdr.Elastic(210e9, 0.3), mdr.Elastic(150e9, 0.2)
    pair = mdr.Pair(mdr.Coated(tin, 1e-6, steel), mdr.Coated(dlc, 5e-7, steel))
    d = np.linspace(1e-9, 100e-9, 40)
    curve, problem, result = tmp_path / "curve.csv", tmp_path / "problem.toml", tmp_path / "fit.json"
    columns = [d * 1e9, mdr.Contact(mdr.Paraboloid(5e-6), pair).at_depth(d).force * 1e3]
    np.savetxt(curve, np.transpose(columns), delimiter=",", header="depth [nm],force [mN]", comments="", fmt="%.16g")
    problem.write_text(
        """
        [indenter]
        shape = "paraboloid"
        radius = "5 um"
        [indenter.body]
        type = "coated"
        coating = { E = "100 GPa", nu = 0.2, thickness = "0.5 um" }
        substrate = { E = "210 GPa", nu = 0.3 }
        [medium]
        type = "coated"
        coating = { E = "450 GPa", nu = 0.25, thickness = "1 um" }
        substrate = { E = "210 GPa", nu = 0.3 }
        [data]
        kind = "force-depth"
        [fit]
        free = ["upper.coating.E", "upper.thickness"]
        """
    )
    assert main(["fit", str(curve), "--problem", str(problem), "--json", str(result)]) == 0
    found = json.loads(result.read_text())["parameters"]
    assert found["upper.coating.E"]["value"] == pytest.approx(150e9, rel=1e-4)
    assert found["upper.thickness"]["value"] == pytest.approx(5e-7, rel=1e-4)


def test_a_column_of_areas_gives_radii(tmp_path):
    radius = np.array([1e-6, 2e-6, 5e-6])
    path = tmp_path / "curve.csv"
    rows = [f"{np.pi * (1e6 * a) ** 2:.9g},{i + 1}" for i, a in enumerate(radius)]
    path.write_text("\n".join(["contact area [um^2],stiffness [N/m]", *rows]))
    data, _ = load_fit_file(FOLDER / "punches_on_rubber.toml").read_data(path)
    assert data.x == pytest.approx(radius, rel=1e-8)


def test_printed_moduli_become_contact_moduli_by_the_nu_that_the_instrument_assumed(tmp_path):
    text = (FOLDER / "modulus_of_oxide.toml").read_text().replace('kind = "modulus-radius"', 'kind = "modulus-radius"\nnu = 0.25')
    (tmp_path / "problem.toml").write_text(text)
    path = FOLDER / "modulus_of_oxide.csv"
    data, _ = load_fit_file(tmp_path / "problem.toml").read_data(path)
    plain, _ = load_fit_file(FOLDER / "modulus_of_oxide.toml").read_data(path)
    assert data.y == pytest.approx(plain.y / (1.0 - 0.25**2))


@pytest.mark.parametrize("command", ["fit", "modulus", "calibrate"])
def test_without_a_problem_file_the_command_that_writes_one_is_named(command, capsys):
    with pytest.raises(SystemExit) as ended:
        main([command, "curve.csv"])
    words = capsys.readouterr().err
    assert ended.value.code == 2
    assert "--problem" in words and '"mdrcontact inspect DATA --problem PROBLEM.toml" writes one to start from' in words
