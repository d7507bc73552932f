# SPDX-License-Identifier: GPL-3.0-or-later
"""Poroelastic gels: reference values of tests/data, elastic limits, published curves, relations between the answers."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from scipy import special

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.instruments.fitting import gel
from mdrcontact.poroelastic import Poroelastic

TABLE = Path(__file__).parents[1] / "data" / "poroelastic.csv"
DRAINAGES = {"drained": "surface", "impermeable": "sealed", "mixed": "indenter"}


def rows(*kinds):
    """The reference values of some kinds."""
    with TABLE.open() as lines:
        table = csv.DictReader(line for line in lines if not line.startswith("#"))
        return [{**row, **dict(part.split("=") for part in row["inputs"].split(";"))} for row in table if row["kind"] in kinds]


def body(row, nu=None):
    """The half-space or film of a row."""
    gel = Poroelastic(1.0, float(row["nu"]) if nu is None else nu, 1.0)
    if row["body"].startswith("half"):
        return mdr.Homogeneous(gel)
    return mdr.Coated(gel, float(row["body"].split("h=")[1].split()[0]), mdr.RIGID)


def punch(gel=None, a=1.0):
    return mdr.Contact(mdr.FlatPunch(a), mdr.Homogeneous(gel or Poroelastic(1.0, 0.2, 1.0)))


@pytest.mark.parametrize("row", rows("flat_punch_step_depth"), ids=lambda row: f"{row['body'][:8]} {row['inputs']}")
def test_flat_punch(row):
    contact = mdr.Contact(mdr.FlatPunch(1.0), body(row))
    force = contact.relaxation(float(row["t"]), drainage=DRAINAGES[row["drainage"]])
    scale = 8.0 if row["quantity"].startswith("F/") else 1.0
    assert force / scale == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("row", rows("sphere_held_radius_step_depth"), ids=lambda row: row["inputs"])
def test_held_paraboloid(row):
    contact = mdr.Contact(mdr.Paraboloid(1.0), body(row))
    path = mdr.poroelastic.history(contact, [0.0, float(row["t"])], radius=[1.0, 1.0], drainage=DRAINAGES[row["drainage"]])
    assert path.force[0] == pytest.approx(16.0 / 3.0, rel=1e-12)
    assert path.force[1] / (16.0 / 3.0) == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("row", rows("flat_punch_dynamic_stiffness"), ids=lambda row: row["inputs"] + row["quantity"])
def test_dynamic_stiffness(row):
    stiffness = punch(Poroelastic(1.0, float(row["nu"]), 1.0)).dynamic_stiffness(
        float(row["omega"]), drainage=DRAINAGES[row["drainage"]]
    )
    value = stiffness.real if row["quantity"] == "k_storage" else stiffness.imag
    assert value == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("drainage", DRAINAGES.values())
@pytest.mark.parametrize("nu", [-0.3, 0.0, 0.3, 0.49])
def test_limits_are_elastic(drainage, nu):
    gel = Poroelastic(2.0, nu, 3.0)
    contact = punch(gel, 0.5)
    undrained, drained = (mdr.Homogeneous(material).stiffness(0.5) for material in (gel.undrained, gel.drained))
    assert contact.relaxation(0.0, drainage=drainage) == pytest.approx(undrained, rel=1e-12)
    assert contact.relaxation(1e-22, drainage=drainage) == pytest.approx(undrained, rel=1e-9)
    assert contact.relaxation(1e20, drainage=drainage) == pytest.approx(drained, rel=1e-9)
    assert contact.relaxation(1e30, drainage=drainage) == pytest.approx(drained, rel=1e-12)
    assert contact.creep(0.0, drainage=drainage) == pytest.approx(1.0 / undrained, rel=1e-12)
    assert contact.creep(1e20, drainage=drainage) == pytest.approx(1.0 / drained, rel=1e-9)
    fast, slow = contact.dynamic_stiffness([1e22, 1e-20], drainage=drainage)
    assert fast == pytest.approx(undrained, rel=1e-9)
    assert slow == pytest.approx(drained, rel=1e-9)


@pytest.mark.parametrize("drainage", ["surface", "sealed"])
@pytest.mark.parametrize("ratio", [0.3, 1.0, 3.0])
def test_limits_of_films_are_elastic(drainage, ratio):
    gel = Poroelastic(2.0, 0.2, 3.0)
    contact = mdr.Contact(mdr.FlatPunch(ratio), mdr.Coated(gel, 1.0, mdr.RIGID))
    ends = [mdr.Coated(m, 1.0, mdr.RIGID, tolerance=1e-12).stiffness(ratio) for m in (gel.undrained, gel.drained)]
    assert contact.relaxation(0.0, drainage=drainage) == pytest.approx(ends[0], rel=1e-9)
    assert contact.relaxation(1e30, drainage=drainage) == pytest.approx(ends[1], rel=1e-9)


def test_curve_of_lai_and_hu():
    """theory/poroelastic.md (7.1)."""
    tau = np.geomspace(1e-3, 10.0, 60)
    root = np.sqrt(tau)
    published = 0.242 * np.exp(-3.13 * tau) + 0.536 * np.exp(-1.71 * root)
    published += -0.043 * np.exp(-12.8 * np.cbrt(tau)) + 0.266 * np.exp(-0.892 * np.sqrt(root))
    force = punch(Poroelastic(1.0, 0.0, 1.0)).relaxation(tau, drainage="indenter")
    assert (force - 4.0) / 4.0 == pytest.approx(published, abs=2e-3)


@pytest.mark.parametrize("drainage", DRAINAGES.values())
def test_tail_is_algebraic(drainage):
    tau = np.array([1e3, 1e5])
    rest = punch().relaxation(tau, drainage=drainage) - 5.0
    assert np.diff(np.log(rest))[0] / np.diff(np.log(tau))[0] == pytest.approx(-0.5, rel=0.02)


def test_creep_under_a_jump_and_a_ramp():
    contact = punch()
    t = np.linspace(0.0, 3.0, 31)
    creep = mdr.poroelastic.history(contact, t, force=np.full(t.shape, 2.0), drainage="indenter")
    assert creep.depth == pytest.approx(2.0 * contact.creep(t, drainage="indenter"), rel=1e-12)
    back = mdr.poroelastic.history(contact, t, depth=creep.depth, drainage="indenter")
    # between the samples the depth is linear, which the creep is not
    assert back.force[5:] == pytest.approx(creep.force[5:], rel=5e-3)


@pytest.mark.parametrize("given", ["depth", "force"])
def test_history_is_a_superposition_of_steps(given):
    """Along a path of a jump, straight pieces and a hold, with many small steps in place of each piece."""
    contact = mdr.Contact(mdr.FlatPunch(0.5), FILM)
    t, path = np.array([0.5, 0.7, 1.0, 1.2, 2.0]), np.array([0.1, 0.4, 0.4, 0.2, -0.1])
    found = mdr.poroelastic.history(contact, t, **{given: path}, drainage="sealed")
    fine = np.interp(np.arange(1601) / 400, np.arange(5), t)
    middle, steps = 0.5 * (fine[1:] + fine[:-1]), np.diff(np.interp(fine, t, path))
    answer = contact.relaxation if given == "depth" else contact.creep
    expected = [
        path[0] * answer(now - t[0], drainage="sealed")
        + steps[middle < now] @ np.asarray(answer(now - middle[middle < now], drainage="sealed"))
        for now in t
    ]
    assert (found.force if given == "depth" else found.depth) == pytest.approx(expected, rel=1e-4)


def test_history_names_what_is_wrong():
    for t, depth, words in (
        ([0.0, 1.0, 1.0], [0.0, 1.0, 1.0], "entry 3 of time = 1: time must be strictly ascending"),
        ([0.0, 1.0], [0.0, np.nan], "entry 2 of depth"),
    ):
        with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
            mdr.poroelastic.history(punch(), t, depth=depth, drainage="surface")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="strictly ascending"):
        mdr.poroelastic.history(mdr.Contact(mdr.Paraboloid(1.0), FILM), [1.0, 0.0], radius=[0.1, 0.1], drainage="surface")


def test_permeability_is_the_other_way_to_say_diffusivity():
    gel = Poroelastic.from_permeability(1e4, 0.25, 2e-15, 1e-3)
    assert gel.diffusivity == pytest.approx(2e4 * 0.75 / 0.5 * 2e-15 / 1e-3, rel=1e-14)
    assert gel.undrained.nu == 0.5 and gel.drained.nu == 0.25


def test_early_pressure_is_that_of_the_incompressible_body():
    r = np.array([0.0, 0.5])
    contact = punch()
    total = contact.pressure_in_time("total_pressure", r, 1e-5, depth=1.0, drainage="indenter")
    assert total == pytest.approx(4.0 / np.pi / np.sqrt(1.0 - r**2), rel=1e-2)
    held = mdr.Contact(mdr.Paraboloid(1.0), contact.medium)
    assert held.pressure_in_time("total_pressure", r, 1e-5, radius=1.0, drainage="indenter") == pytest.approx(
        8.0 / np.pi * np.sqrt(1.0 - r**2), rel=1e-2
    )


def test_pore_pressure_of_a_sealed_surface():
    """By SciPy, theory/poroelastic.md (3.2), (5.6): a dense rule in k, waves summed up to k = 4000, another inverse transform
    (16 points)."""
    nu, tau, r = 0.2, 0.1, np.array([0.0, 0.5, 0.9])
    eta, order = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)), np.arange(14)
    edges = np.concatenate([[0.0], 2.0 ** np.arange(-10.0, 2.0), np.arange(8.0, 4000.0, 6.0)])
    node, weight = np.polynomial.legendre.leggauss(14)
    half = 0.5 * np.diff(edges)[:, None]
    k, w = (edges[:-1, None] + half * (1.0 + node)).ravel(), (half * weight).ravel()
    b = (np.sqrt(4.0 * order + 1.0) * (-1.0) ** order)[:, None] * special.spherical_jn(2 * order[:, None], k)
    total = np.zeros(r.shape)
    width, opening = 3.0 / 16, 16 * np.pi / 12.0
    for j in range(16):
        turn = 1.0 + 1j * (j + 0.5) * width
        z = opening * turn**2
        q = np.sqrt(k**2 + z / tau)
        y = 2.0 * eta * k**2 / (q * (q + k))
        matrix = (2.0 / np.pi) * (b * (w * (y / (1.0 - y) - 2.0 * eta / (2.0 - 2.0 * eta)))) @ b.T
        load = np.linalg.solve(matrix + np.eye(14) / (1.0 - eta), np.eye(14)[0])
        flux = z / tau / ((1.0 - 2.0 * eta * k / (q + k)) * k * (q + k))
        wave = w * k * flux / (1.0 + flux) * (load @ b)
        pore = np.array([np.sum(wave * special.j0(k * x)) for x in r])
        total += (np.exp(z) / z * 2j * opening * turn * width / np.pi * pore).imag
    found = punch().pressure_in_time("pore_pressure", r, tau, depth=1.0, drainage="sealed")
    assert found == pytest.approx(4.0 / np.pi * total, rel=1e-6)


def test_late_pressure_is_drained():
    r = np.array([0.0, 0.5, 0.9])
    for drainage in DRAINAGES.values():
        total = punch().pressure_in_time("total_pressure", r, 1e12, depth=1.0, drainage=drainage)
        assert total == pytest.approx(2.0 / 0.8 / np.pi / np.sqrt(1.0 - r**2), rel=1e-5)
        assert punch().pressure_in_time("pore_pressure", r, 1e12, depth=1.0, drainage=drainage) == pytest.approx(0.0, abs=1e-5)


GEL = Poroelastic(1.0, 0.2, 1.0)
FILM = mdr.Coated(GEL, 1.0, mdr.RIGID)


def ramp(indenter):
    return mdr.poroelastic.history(mdr.Contact(indenter, mdr.Homogeneous(GEL)), [0.0, 1.0], depth=[0.0, 1.0], drainage="surface")


def on_film(a, drainage):
    return mdr.Contact(mdr.FlatPunch(a), FILM).relaxation(1.0, drainage=drainage)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Poroelastic(1.0, 0.5, 1.0), "nu = 0.5"),
        (lambda: Poroelastic(1.0, 0.2, 0.0), "diffusivity = 0.0"),
        (lambda: Poroelastic(float("nan"), 0.2, 1.0), "shear_modulus = nan"),
        (lambda: punch().relaxation(1.0), "drainage is missing"),
        (lambda: punch().relaxation(1.0, drainage="drained"), "drainage = 'drained'"),
        (lambda: punch().relaxation(-1.0, drainage="surface"), "time = -1"),
        (lambda: punch().at_depth(1.0), "poroelastic"),
        (lambda: punch().medium.stiffness(1.0), "poroelastic"),
        (lambda: mdr.Coated(GEL, 1.0, mdr.Elastic(1.0, 0.2)), "RIGID"),
        (lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, "gao"), "no other model"),
        (lambda: mdr.Contact(mdr.FlatPunch(1.0), punch().medium, 1.0), "work_of_adhesion"),
        (lambda: ramp(mdr.Cone(0.1)), "Paraboloid"),
        (lambda: ramp(mdr.Paraboloid(1.0)), "not supported"),
        (lambda: mdi.fit(mdi.ForceTime([0.0, 1.0], [1.0, 1.0], [2.0, 1.0]), mdr.FlatPunch(1.0), FILM, ["coating.nu"]), "fit_gel"),
        (lambda: mdr.Pair(FILM, mdr.Homogeneous(mdr.Elastic(1.0, 0.2))), "poroelastic"),
        (lambda: mdr.Friction(punch(), 0.1), "poroelastic"),
        (lambda: punch().relaxation(1.0, 0.3, "surface"), "radius = 0.3: .* flat punch is its radius"),
        (lambda: punch().dynamic_stiffness(1.0, radius=0.3, drainage="surface"), "radius = 0.3: .* flat punch is its radius"),
        (lambda: on_film(9.0, "surface"), "ratio = 9"),
        (lambda: on_film(1.0, "indenter"), "film"),
        (
            lambda: mdr.Contact(mdr.FlatPunch(1.0), FILM).pressure_in_time("pore_pressure", 0.0, 1.0, depth=1.0, drainage="sealed"),
            "film",
        ),
    ],
)
def test_refusals(call, words):
    with pytest.raises(mdr.MDRError, match=words):
        call()


def test_drainage_is_of_gels_alone():
    with pytest.raises(TypeError, match="not poroelastic"):
        mdr.Contact(mdr.FlatPunch(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.2))).relaxation(1.0, drainage="surface")


@pytest.mark.slow
def test_fits_find_what_made_the_data():
    true, noise = Poroelastic(28e3, 0.2, 3e-8), np.random.default_rng(3)
    tip, body = mdr.FlatPunch(1e-3), mdr.Homogeneous(true)
    start = mdr.Homogeneous(Poroelastic(1.0, 0.3, 1.0))
    contact, names = mdr.Contact(tip, body), ("shear_modulus", "nu", "diffusivity")
    time = np.append(0.0, np.geomspace(0.1, 3000.0, 200))
    held = np.full(time.shape, 5e-5)
    force = mdr.poroelastic.history(contact, time, depth=held, drainage="indenter").force
    sd = 1e-3 * force.max()
    omega = np.geomspace(1e-3, 30.0, 60)
    k = contact.dynamic_stiffness(omega, drainage="indenter")
    off = noise.standard_normal((2, omega.size)) @ np.eye(omega.size) * 1e-3 * abs(k).max()
    tests = [
        (tip, mdi.ForceTime(time, held, force + sd * noise.standard_normal(time.size), sd=sd)),
        (tip, mdi.DynamicStiffness(omega, k + off[0] + 1j * off[1], 1e-3, sd=1e-3 * abs(k).max())),
    ]
    depth = mdr.poroelastic.history(contact, time, force=np.full(time.shape, 1.0), drainage="indenter").depth
    sd = 1e-3 * depth.max()
    tests.append((tip, mdi.DepthTime(time, np.full(time.shape, 1.0), depth + sd * noise.standard_normal(time.size), sd=sd)))
    for indenter, data in tests:
        fit = mdi.fit_gel(data, indenter, start, names, drainage="indenter")
        for name in names:
            assert abs(fit.values[name] - getattr(true, name)) < 4.0 * fit.errors[name], (name, fit.summary())
            assert fit.errors[name] < 0.05 * getattr(true, name), (name, fit.summary())
        assert 0.7 < fit.chi_square / fit.points < 1.3
    ramp = np.interp(time, [0.0, 2.0, 3000.0], [0.0, 5e-5, 5e-5])
    force = mdr.poroelastic.history(contact, time, depth=ramp, drainage="surface").force
    fit = mdi.fit_gel(mdi.ForceTime(time, ramp, force, sd=1e-6), tip, body.replace(material=true.replace(diffusivity=1.0)),
                      ["diffusivity"], drainage="surface")  # fmt: skip
    assert fit.values["diffusivity"] == pytest.approx(3e-8, rel=1e-5)


@pytest.mark.slow
def test_ratios_between_the_tables_of_a_fit():
    """Poisson's ratio of a film: the answers between the tables of a fit are those of a table of their own."""
    tip, film = mdr.FlatPunch(1.0), mdr.Coated(Poroelastic(3.0, 0.435, 0.2), 1.0, mdr.RIGID)
    time = np.append(0.0, np.geomspace(1e-4, 1e3, 60))
    held = np.full(time.shape, 1e-3)
    force = mdr.poroelastic.history(mdr.Contact(tip, film), time, depth=held, drainage="sealed").force
    data = mdi.ForceTime(time, held, force, sd=1e-5 * force.max())
    start = mdr.Coated(Poroelastic(1.0, 0.2, 1.0), 1.0, mdr.RIGID)
    fit = mdi.fit_gel(data, tip, start, gel.NAMES, drainage="sealed")
    assert np.abs(fit.fitted / force - 1.0).max() < 5e-6
    assert fit.values["nu"] == pytest.approx(0.435, abs=1e-5)


def test_a_fit_compares_its_tables_with_their_source(monkeypatch):
    """Too few tables are seen by the comparison that a fit ends with."""
    monkeypatch.setattr(gel, "_PLACES", gel._PLACES[[0, 4, 8]])
    monkeypatch.setattr(gel, "_TABLES", gel._TABLES[::4])
    tip, body = mdr.FlatPunch(1.0), mdr.Homogeneous(Poroelastic(3.0, 0.3, 0.2))
    time = np.append(0.0, np.geomspace(1e-4, 1e3, 30))
    held = np.full(time.shape, 1e-3)
    data = mdi.ForceTime(
        time, held, mdr.poroelastic.history(mdr.Contact(tip, body), time, depth=held, drainage="sealed").force, sd=1e-6
    )
    with pytest.raises(mdr.MDRError, match="Fix nu"):
        mdi.fit_gel(data, tip, body, gel.NAMES, drainage="sealed")


@pytest.mark.slow
def test_fits_say_what_the_data_do_not_tell():
    true = mdr.Homogeneous(Poroelastic(28e3, 0.2, 3e-8))
    time = np.append(0.0, np.geomspace(1.0, 10.0, 50))
    force = mdr.poroelastic.history(
        mdr.Contact(mdr.FlatPunch(1e-2), true), time, depth=np.full(time.shape, 1e-4), drainage="indenter"
    ).force
    data = mdi.ForceTime(time, np.full(time.shape, 1e-4), force, sd=0.01 * force.max())
    fit = mdi.fit_gel(data, mdr.FlatPunch(1e-2), true, ("shear_modulus", "nu", "diffusivity"), drainage="indenter")
    assert any("does not follow" in note for note in fit.notes)
    assert "drainage" in fit.notes[-1]


def test_drainages_are_compared():
    true = mdr.Homogeneous(Poroelastic(28e3, 0.2, 3e-8))
    time = np.append(0.0, np.geomspace(0.1, 3000.0, 100))
    held = np.full(time.shape, 1e-4)
    force = mdr.poroelastic.history(mdr.Contact(mdr.FlatPunch(1e-3), true), time, depth=held, drainage="surface").force
    fits = mdi.compare_drainages(mdi.ForceTime(time, held, force, sd=1e-3 * force.max()), mdr.FlatPunch(1e-3), true)
    assert fits[0].drainage == "surface" and {fit.drainage for fit in fits} == {"surface", "indenter", "sealed"}
    assert fits[0].chi_square < 0.01 * fits[1].chi_square
    # a gel that drains everywhere, taken for one that the indenter seals: D wrong by about 3
    wrong = next(fit for fit in fits if fit.drainage == "indenter")
    assert 2.0 < wrong.values["diffusivity"] / 3e-8 < 4.0


def test_command_line(tmp_path, capsys):
    folder, out, points = ROOT / "examples" / "fit", tmp_path / "fit.json", tmp_path / "points.csv"
    problem = folder / "punch_on_hydrogel.toml"
    wanted = [str(folder / "punch_on_hydrogel.csv"), "--problem", str(problem), "--json", str(out), "--csv", str(points)]
    assert main(["fit", *wanted]) == 0
    found = json.loads(out.read_text())
    assert found["parameters"]["diffusivity"]["value"] == pytest.approx(3e-8, rel=0.03)
    assert found["parameters"]["shear_modulus"]["value"] == pytest.approx(28e3, rel=0.01)
    assert "drainage 'indenter'" in capsys.readouterr().out and len(points.read_text().splitlines()) == 201
    text = problem.read_text()
    for old, new, words in (
        ('drainage = "indenter"', 'drainage = "wet"', "wet"),
        ('"nu", ', '"E", ', "free must name"),
        ('diffusivity = "1e-9 m^2/s"', 'diffusivity = "1e-9 m/s"', "a diffusivity"),
        ('diffusivity = "1e-9 m^2/s"', 'permeability = "1 nm^2"', "viscosity"),
    ):
        wrong = tmp_path / "wrong.toml"
        wrong.write_text(text.replace(old, new))
        assert main(["fit", str(folder / "punch_on_hydrogel.csv"), "--problem", str(wrong)]) == 2
        assert words in capsys.readouterr().err
    assert main(["curve", str(ROOT / "examples" / "problems" / "relaxation_of_gel.toml")]) == 2
    assert "Use mdrcontact history" in capsys.readouterr().err
