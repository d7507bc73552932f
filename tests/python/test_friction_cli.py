# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `mdrcontact friction`."""

import csv

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact._units import ENERGY, FORCE, LENGTH, parse
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
    expected = pair.shear(pair.contact.at_force(5e-3)).at_shift([0.5e-9, 2e-9, 50e-9])
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
        ('coefficient = 0.2\nshifts = ["2 nm", "1 nm"]\n', "entry 2 of shifts", 2),
        ('coefficient = 0.2\nshifts = ["2 nm"]\ntangential_forces = ["1 mN"]\n', "exclude each other", 2),
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


DEPTHS, SHIFTS = np.array([40.0, 60.0, 60.0, 30.0, 50.0, 0.0]), np.array([0.0, 12.0, -8.0, -4.0, 30.0, 0.0])
HALF_SPACE = 'type = "homogeneous"\nmaterial = { E = "165 GPa", nu = 0.22 }\n[friction]\n'


def led(tmp_path, titles, columns, *options, medium=None, keys=""):
    """The command on a path; without [compute], which it does not need."""
    lines = [titles, *(",".join(repr(float(x)) for x in row) for row in zip(*columns, strict=True))]
    (tmp_path / "path.csv").write_text("\n".join(lines) + "\n")
    text = PROBLEM.split("[compute]")[0] + "[friction]\n"
    if medium:
        text = text.split("type = ")[0] + medium
    problem = tmp_path / "problem.toml"
    problem.write_text(f'{text}coefficient = 0.2\npath = "path.csv"\n{keys}')
    return main(["friction", str(problem), *options])


def table_of(path):
    """Columns by name, in SI units."""
    with path.open() as file:
        titles, *rows = csv.reader(file)
    columns = {}
    for i, title in enumerate(titles):
        name, _, unit = title.removesuffix("]").partition(" [")
        columns[name] = np.array([float(row[i]) for row in rows])
        if unit:
            columns[name] *= parse(f"1 {unit}", next(d for d in (LENGTH, FORCE, ENERGY) if unit in dict(d.practical)))
    return columns


def test_a_path_on_a_half_space_is_exact(tmp_path, capsys):
    table, picture = tmp_path / "steps.csv", tmp_path / "path.png"
    options = "--csv", str(table), "--plot", str(picture)
    assert led(tmp_path, "depth [nm],shift [nm]", (DEPTHS, SHIFTS), *options, medium=HALF_SPACE) == 0
    assert "exact springs" in capsys.readouterr().out and picture.read_bytes().startswith(b"\x89PNG")
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(165e9, 0.22))), 0.2)
    expected = friction.history().advance(depth=DEPTHS * 1e-9, shift=SHIFTS * 1e-9)
    found = table_of(table)
    assert found["step"].tolist() == [1, 2, 3, 4, 5, 6]
    force = found["force"]
    np.testing.assert_allclose(force, friction.contact.at_depth(DEPTHS * 1e-9).force, rtol=1e-12)
    scale = 0.2 * force.max()
    np.testing.assert_allclose(found["tangential force"], expected.tangential_force, rtol=0, atol=1e-12 * scale)
    np.testing.assert_allclose(found["stick radius"], expected.stick_radius, rtol=1e-9, atol=1e-20)
    np.testing.assert_allclose(found["dissipated energy"], expected.dissipated_energy, rtol=1e-9, atol=1e-22)
    assert (found["sliding"] > 0.5).tolist() == expected.sliding.tolist() and 0 < expected.sliding.sum() < 6
    # the same path by forces
    other = tmp_path / "forces.csv"
    titles = "normal force [mN],shift [um]"
    assert led(tmp_path, titles, (force * 1e3, SHIFTS * 1e-3), "--csv", str(other), medium=HALF_SPACE) == 0
    again = table_of(other)["tangential force"]
    np.testing.assert_allclose(again, found["tangential force"], rtol=0, atol=1e-9 * scale)


def test_a_path_on_a_film_by_rings(tmp_path, capsys):
    table = tmp_path / "steps.csv"
    assert led(tmp_path, "depth [nm],shift [nm]", (DEPTHS, SHIFTS), "--csv", str(table), keys="rings = 40\n") == 0
    words = capsys.readouterr().out
    assert "40 rings" in words
    medium = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(10e-6), medium), 0.2)
    # three times the rings and many more steps, straight between the rows
    rows = np.arange(7)
    fine = np.linspace(0, 6, 6 * 120 + 1)[1:]
    depth, shift = (np.interp(fine, rows, [0.0, *path]) * 1e-9 for path in (DEPTHS, SHIFTS))
    expected = friction.history(depth.max(), 120).advance(depth=depth, shift=shift)
    found, ends = table_of(table), slice(119, None, 120)
    scale = 0.2 * friction.contact.at_depth(60e-9).force
    off = np.abs(found["tangential force"] - expected.tangential_force[ends]).max() / scale
    lost = expected.dissipated_energy[ends]
    lost_off = np.abs(found["dissipated energy"] - lost).max() / lost[-1]
    shown = [float(part.split()[0]) for part in words.split(" by ")[1:]]
    assert 0.0 < shown[0] < 5e-3 and 0.0 < shown[1] < 5e-2
    assert off < shown[0] and lost_off < shown[1], (off, lost_off, shown)
    # the end of each step by its tangential force in place of its shift
    slides = found["sliding"] > 0.5
    first = np.flatnonzero(slides)[0]
    columns = found["force"][:first] * 1e3, found["tangential force"][:first] * 1e6
    other = tmp_path / "forces.csv"
    assert first >= 2 and led(tmp_path, "F [mN],T [uN]", columns, "--csv", str(other), keys="rings = 40\n") == 0
    np.testing.assert_allclose(table_of(other)["shift"], found["shift"][:first], rtol=0, atol=1e-6 * 12e-9)


@pytest.mark.parametrize(
    ("titles", "columns", "keys", "words", "status"),
    [
        ("depth [nm],shift", ([1, 2], [0, 1]), "", "the column 'shift' should be the shift, but does not state its unit", 2),
        ("depth [nm],height [nm]", ([1, 2], [0, 1]), "", "no column is the shift or tangential_force", 2),
        ("depth [nm],shift [nm]", ([1, -2], [0, 1]), "", "depth = -2 nm in row 2 of the numbers: it must be", 2),
        ("depth [nm],shift [nm]", ([0, 0], [0, 1]), "", "never touch", 2),
        ("depth [nm],shift [nm]", ([1, 2, 3], [0, np.nan, 1]), "", "row 2 of the numbers has no shift", 2),
        ("depth [nm],F [mN],shift [nm]", ([1, 2], [1, 2], [0, 1]), "", "both depth and force. Choose the prescribed one", 2),
        ("depth [nm],shift [nm]", ([1, 2], [0, 1]), 'normal = "force"\n', "no column is the force", 2),
        ("depth [nm],shift [nm]", ([1, 2], [0, 1]), "rings = 5\n", "rings = 5: it must be", 2),
        ("depth [nm],shift [nm]", ([1, 2], [0, 1]), 'shifts = ["1 nm"]\n', "shifts and path exclude each other", 2),
        ("force [mN],T [mN]", ([1, 2], [0.1, 0.5]), "", "row 2 of the numbers: tangential_force = 5e-04", 1),
    ],
)
def test_faults_of_paths(tmp_path, capsys, titles, columns, keys, words, status):
    assert led(tmp_path, titles, columns, keys=keys) == status
    error = capsys.readouterr().err
    assert words in error and len(error.splitlines()) == 1


def test_keys_of_a_path_without_one_and_no_file(tmp_path, capsys):
    assert run(tmp_path, "coefficient = 0.2\nrings = 50\n") == 2
    assert "'rings'" in capsys.readouterr().err
    assert run(tmp_path, 'coefficient = 0.2\npath = "none.csv"\n') == 2
    assert "none.csv: it cannot be read" in capsys.readouterr().err


def test_a_table_with_depth_and_force(tmp_path):
    columns = [1, 2], [0.01, 0.02], [0, 1]
    assert led(tmp_path, "depth [nm],F [mN],shift [nm]", columns, keys='normal = "force"\n', medium=HALF_SPACE) == 0


def test_law_with_friction(tmp_path, capsys):
    problem, path = tmp_path / "problem.toml", tmp_path / "ball.law"
    problem.write_text(PROBLEM + "coefficient = 0.2\n")
    assert main(["law", str(problem), str(path), "--sliders", "12", "--tolerance", "1e-6"]) == 0
    assert "12, 59 numbers a contact" in capsys.readouterr().out
    law = mdr.ContactLaw.load(path)
    assert (law.coefficient, law.sliders) == (0.2, 12)
    film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    exact = (
        mdr.Friction(mdr.Contact(mdr.Paraboloid(10e-6), film), 0.2)
        .shear(mdr.Friction(mdr.Contact(mdr.Paraboloid(10e-6), film), 0.2).contact.at_force(4e-3))
        .at_shift(2e-9)
    )
    memory = law.contacts(1)
    law.advance(memory, [4e-3], [[0.0, 0.0]])
    assert law.advance(memory, [4e-3], [[2e-9, 0.0]])[0, 0] == pytest.approx(exact.tangential_force, abs=0.01 * 0.2 * 4e-3)
