# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `mdrcontact friction`."""

import csv

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.cli.example import examples

PROBLEM = """\
title = "a ball on oxide"
[indenter]
shape = "paraboloid"
radius = "10 um"
[medium]
type = "coated"
[medium.coating]
E = "72 GPa"
nu = 0.17
thickness = "500 nm"
[medium.substrate]
E = "165 GPa"
nu = 0.22
[compute]
forces = ["5 mN"]
[friction]
"""


def run(tmp_path, table, *options):
    problem = tmp_path / "problem.toml"
    problem.write_text(PROBLEM + table)
    return main(["friction", str(problem), *options])


def test_table_and_files(tmp_path, capsys):
    table, picture = tmp_path / "energies.csv", tmp_path / "loops.png"
    status = run(tmp_path, 'coefficient = 0.2\nshifts = ["0.5 nm", "2 nm", "50 nm"]\n', "--csv", str(table), "--plot", str(picture))
    assert status == 0
    words = capsys.readouterr().out
    assert "a ball on oxide" in words and "sliding from shift" in words
    assert picture.read_bytes().startswith(b"\x89PNG")
    with table.open() as file:
        rows = list(csv.reader(file))
    columns = {name.split(" [")[0]: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0])}
    pair = mdr.Friction(
        mdr.Contact(mdr.Paraboloid(10e-6), mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))), 0.2
    )
    expected = pair.at_shift([0.5e-9, 2e-9, 50e-9], force=5e-3)
    np.testing.assert_allclose(columns["T/(mu F)"], np.asarray(expected.tangential_force) / 1e-3, rtol=1e-6)
    assert columns["T/(mu F)"][2] == pytest.approx(1.0)
    assert columns["stick radius"][2] == 0.0


def test_without_amplitudes_and_under_forces(tmp_path, capsys):
    assert run(tmp_path, "coefficient = 0.2\n") == 0
    assert len(capsys.readouterr().out.splitlines()) > 12
    assert run(tmp_path, 'coefficient = 0.2\ntangential_forces = ["0.1 mN", "0.5 mN"]\n') == 0
    assert "0.5" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("table", "words", "status"),
    [
        ("coefficient = 0.0\n", "greater than 0", 2),
        ("", "'coefficient' is missing", 2),
        ('coefficient = 0.2\nshifts = ["2 nm", "1 nm"]\n', "ascending", 2),
        ('coefficient = 0.2\nshifts = ["2 nm"]\ntangential_forces = ["1 mN"]\n', "not as both", 2),
        ('coefficient = 0.2\ntangential_forces = ["2 mN"]\n', "slides", 1),
        ("coefficient = 0.2\nfriction = 1\n", "unknown key", 2),
    ],
)
def test_faults(tmp_path, capsys, table, words, status):
    assert run(tmp_path, table) == status
    assert words in capsys.readouterr().err


def test_a_problem_without_the_table(tmp_path, capsys):
    problem = tmp_path / "problem.toml"
    problem.write_text(PROBLEM.replace("[friction]\n", ""))
    assert main(["friction", str(problem)]) == 2
    assert "[friction] is missing" in capsys.readouterr().err


def test_the_ready_made_problem(tmp_path):
    problem = tmp_path / "problem.toml"
    problem.write_text(examples()["tin_on_steel"])
    assert main(["friction", str(problem)]) == 0
