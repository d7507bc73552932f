# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [imprint], the study and the command `imprint`: what unloads, how it is shown, and what is refused."""

from __future__ import annotations

import copy

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact import problem, studies
from mdrcontact.cli import main
from mdrcontact.problem import ProblemError

SOFT = {"E": "70 GPa", "nu": 0.33}
METAL = {**SOFT, "yield_stress": "0.35 GPa"}
LARGEST = {"radius": "1 um", "force": "2.84 mN", "depth": "61.5 nm", "residual_depth": "38.8 nm"}
TABLES = {
    "indenter": {"shape": "paraboloid", "radius": "10 um"},
    "medium": {"type": "homogeneous", "material": METAL},
    "imprint": LARGEST,
}
ELASTIC = {"material": SOFT}
"""Without a yield stress: whether it yields in reverse takes the study longest."""
MODULUS = 70e9 / (1.0 - 0.33**2)


def changed(**tables):
    found = copy.deepcopy(TABLES)
    for name, keys in tables.items():
        if keys is None:
            found.pop(name)
        else:
            found[name] = {**found.get(name, {}), **keys}
    return found


def test_unloading_of_two_terms_in_closed_form():
    """theory/plastic.md (2.1)-(2.6): force, depth and radius on a half-space, the work and the residual depth."""
    found = studies.imprint(problem.read(changed(medium=ELASTIC)))
    a = 1e-6
    q0 = MODULUS * (61.5e-9 - 38.8e-9)
    two = (2.84e-3 / (2.0 * a) - 2.0 / 3.0 * q0) / (np.pi / 4.0 - 2.0 / 3.0)
    one = q0 - two
    depth, radius, force, stiffness, energy = found.values("states")
    u = radius / a
    s = np.sqrt(1.0 - u**2)
    y = two * s + one * s**2
    assert depth == pytest.approx(61.5e-9 - y / MODULUS, rel=1e-7)
    assert force == pytest.approx(2.0 * a * (one * (u - u**3 / 3.0) + two * (u * s + np.arcsin(u)) / 2.0 - u * y), rel=1e-6)
    assert stiffness == pytest.approx(2.0 * MODULUS * radius, rel=1e-7)
    work = a / MODULUS * (8.0 / 15.0 * one**2 + 3.0 * np.pi / 8.0 * one * two + 2.0 / 3.0 * two**2)
    assert found.numbers["recovered work"].value == pytest.approx(work, rel=1e-9) == energy[-1]
    assert force == pytest.approx(np.linspace(0.01, 1.0, 100) * 2.84e-3, rel=1e-9)
    assert found.numbers["residual depth"].value == pytest.approx(38.8e-9)


def test_shapes_touch_at_full_load_and_the_surface_starts_at_the_residual_depth():
    found = studies.imprint(problem.read(changed(medium=ELASTIC)))
    r, effective, tip, left = found.values("shapes")
    assert tip == pytest.approx(r**2 / 20e-6) and left[0] == pytest.approx(-38.8e-9)
    assert effective - tip + left == pytest.approx(np.full(len(r), -38.8e-9), abs=1e-16)
    assert np.all(np.diff(effective) > 0.0)
    r, pressure = found.values("pressure")
    assert 2.0 * np.pi * np.trapezoid(pressure * r, r) == pytest.approx(2.84e-3, rel=2e-3)


def test_compute_prescribes_the_states():
    """Depths count from initial contact, forces and radii are those of the contact."""
    by_force = studies.imprint(problem.read(changed(medium=ELASTIC, compute={"forces": ["0.5 mN", "1 mN", "2 mN"]})))
    depth, radius, *_ = by_force.values("states")
    for name, key, values in (("depths", 0, depth), ("radii", 1, radius)):
        table = {name: [f"{1e9 * float(value)!r} nm" for value in values]}
        again = studies.imprint(problem.read(changed(medium=ELASTIC, compute=table)))
        assert again.values("states")[key] == pytest.approx(values, rel=1e-12)
        assert again.values("states")[2] == pytest.approx([0.5e-3, 1e-3, 2e-3], rel=1e-6)


def test_a_pressure_instead_of_a_record():
    measured = studies.imprint(problem.read(changed(medium=ELASTIC))).imprint
    pressure = {"radius": "1 um", "uniform": f"{measured.uniform!r} Pa", "hertz": f"{measured.hertz!r} Pa", "depth": "61.5 nm"}
    tables = changed(medium=ELASTIC, imprint=None)
    found = studies.imprint(problem.read({**tables, "imprint": pressure}))
    assert found.numbers["residual depth"].value == pytest.approx(38.8e-9, rel=1e-9)
    assert found.numbers["largest force"].value == pytest.approx(2.84e-3, rel=1e-9)
    pressure.pop("depth")
    found = studies.imprint(problem.read({**tables, "imprint": pressure}))
    assert found.values("states")[0][-1] == pytest.approx(0.0, abs=1e-18), "depths count from the largest load"


def test_adhesion_holds_the_edge():
    adhesion = {"work_of_adhesion": "0.5 J/m^2"}
    dry, sticky = (studies.imprint(problem.read(changed(medium=ELASTIC, **more))) for more in ({}, {"adhesion": adhesion}))
    assert sticky.contact.pull_off().force < 0.0
    assert sticky.values("states")[1][50] > dry.values("states")[1][50]


def test_reverse_yield_by_layer():
    """A soft film on a stiff body that may yield, too; the substrate's ratio is that of its own yield stress."""
    coated = {
        "type": "coated",
        "coating": {**METAL, "thickness": "2 um"},
        "substrate": {"E": "163 GPa", "nu": 0.22, "yield_stress": "7 GPa"},
    }
    tables = changed(medium=None, imprint={"depth": "57 nm", "residual_depth": "38.5 nm"})
    found = studies.imprint(problem.read({**tables, "medium": coated}))
    film, base = (found.numbers[f"R_Y of the {name}"].value for name in ("film", "substrate"))
    assert film == found.imprint.reverse_yield([0.35e9, np.inf]).ratio and base == found.imprint.reverse_yield([np.inf, 7e9]).ratio
    assert 1.5 < film < 2.5 and 0.0 < base < 0.2
    assert "R_Y of the film" in found.notes["reverse yield"]
    coated["substrate"].pop("yield_stress")
    found = studies.imprint(problem.read({**tables, "medium": coated}))
    assert "R_Y of the substrate" not in found.numbers
    coated["coating"].pop("yield_stress")
    assert "reverse yield" not in studies.imprint(problem.read({**tables, "medium": coated})).notes


def test_more_than_three_is_refused_and_more_than_two_warned_of():
    softer = changed(medium={"material": {**METAL, "yield_stress": "0.28 GPa"}})
    with pytest.warns(mdr.errors.PlasticityWarning, match="unloading yields again"):
        found = studies.imprint(problem.read(softer))
    assert any("unloading yields again" in words for words in found.warnings) and "yields again" in found.notes["reverse yield"]
    with pytest.raises(mdr.MDRError, match="R_Y"):
        studies.imprint(problem.read(changed(medium={"material": {**METAL, "yield_stress": "0.1 GPa"}})))


@pytest.mark.parametrize(
    ("tables", "words"),
    [
        (changed(imprint={"force": "0 mN"}), "force = '0 mN': it must be greater than 0"),
        (changed(imprint={"residual_depth": "62 nm"}), "residual_depth"),
        (changed(imprint={"residual_depth": "-1 nm"}), "residual_depth = '-1 nm': it must be at least 0"),
        (changed(imprint={"depth": "0 nm"}), "depth"),
        (changed(imprint={"uniform": "1 GPa"}), "exactly one of force and uniform; it has force and uniform"),
        (changed(imprint={"hertz": "1 GPa"}), "'hertz' does not belong to force"),
        ({**TABLES, "imprint": {"radius": "1 um"}}, "exactly one of force and uniform; it has none"),
        ({**TABLES, "imprint": {"radius": "1 um", "uniform": "1 GPa"}}, "the key 'hertz' is missing"),
        ({**TABLES, "imprint": {"radius": "1 um", "uniform": "0 GPa", "hertz": "0 GPa"}}, "the force of both pressures is 0 N"),
        (
            {
                **changed(imprint=None, compute={"max_force": "1 mN"}),
                "medium": {"type": "homogeneous", "material": {"E": "70 GPa", "nu": 0.33}},
            },
            "table \\[imprint\\] is missing",
        ),
        (changed(compute={"forces": ["3 mN"]}), "3"),
        (changed(adhesion={"work_of_adhesion": "0.1 J/m^2", "cohesive_stress": "10 MPa"}), "Leave out speed"),
        (changed(medium={"material": {**METAL, "yield_stress": "0 GPa"}}), "yield_stress = '0 GPa': it must be greater than 0"),
        (changed(medium={"material": {**METAL, "hardness": "1 GPa"}}), "yield_stress and hardness exclude each other"),
        (changed(medium={"material": {**METAL, "radius_ratio": 0.1}}), "radius_ratio needs hardness"),
        (changed(medium={"material": {**SOFT, "hardness": "0 GPa"}}), "hardness = '0 GPa': it must be greater than 0"),
        (changed(medium={"material": {**SOFT, "hardness": 1.0}}), "hardness = 1.0: it has no unit"),
        (changed(medium={"material": {**SOFT, "hardness": "1 GPa", "radius_ratio": 0.31}}), "radius_ratio = 0.31: it must be > 0"),
        (changed(medium={"material": {**SOFT, "hardness": "9 GPa", "radius_ratio": 0.1}}), "Nothing yields at this a/R"),
        (changed(medium={"material": {**SOFT, "hardness": "1 GPa", "radius_ratio": 0.1, "nu": 0.499}}), "nu = 0.499: it must lie"),
        (changed(indenter={"material": {**SOFT, "hardness": "1 GPa"}}), "the indenter must not yield"),
        (changed(indenter={"material": METAL}), "the indenter must not yield"),
        (changed(indenter={"body": {"type": "homogeneous", "material": METAL}}), "the indenter must not yield"),
        (
            changed(
                medium={"material": {"shear_modulus": "1 MPa", "nu": 0.3, "diffusivity": "1e-9 m^2/s", "yield_stress": "1 MPa"}}
            ),
            "'yield_stress' does not belong to",
        ),
    ],
)
def test_refusals(tables, words):
    with pytest.raises(mdr.MDRError, match=words):
        studies.imprint(problem.read(tables))


def test_the_command_and_its_picture(tmp_path, capsys):
    file = str(ROOT / "examples" / "problems" / "aluminium_on_silicon.toml")
    assert main(["imprint", file, "--csv", str(tmp_path / "a.csv"), "--plot", str(tmp_path / "a.png")]) == 0
    printed = capsys.readouterr().out
    assert "Unloading recovers" in printed and "R_Y of the film" in printed
    assert (tmp_path / "a.csv").read_text(encoding="utf-8").count("\n") == 101
    found = studies.imprint(problem.load(file))
    assert [panel.title for panel in found.figure().panels] == ["unloading, reloading", "shapes", "at the largest load", "recovery"]


def test_other_commands_need_what_to_compute():
    """Without [compute] a problem with [imprint] has the forces of unloading, which are those of no elastic loading."""
    given = problem.read(TABLES)
    assert given.control.name == "force" and given.control.values[-1] == 2.84e-3
    with pytest.raises(ProblemError, match="compute"):
        problem.read(changed(imprint=None))


def test_adhesion_must_not_yield_the_body_alone():
    """a_0 E*/(R Y) = L_y with a_0^3 = 9 pi gamma R^2/(2 E*), theory/plastic.md (3.6)."""
    loaded = {**{name: keys for name, keys in TABLES.items() if name != "imprint"}, "compute": {"forces": ["2.5 mN"]}}
    first = mdr.plastic.PlasticLaw(mdr.Paraboloid(10e-6), mdr.plastic.Yielding(mdr.Elastic(70e9, 0.33), 0.35e9), 1e-8).first_yield
    work = 2.0 * MODULUS / (9.0 * np.pi * 10e-6**2) * (first * 10e-6 * 0.35e9 / MODULUS) ** 3
    found = studies.imprint(problem.read({**loaded, "adhesion": {"work_of_adhesion": f"{0.99 * work} J/m^2"}}))
    assert found.contact.work_of_adhesion == pytest.approx(0.99 * work)
    for much in (1.01, 1e4):
        with pytest.raises(ProblemError, match="work_of_adhesion.*adhesion alone yields the body"):
            studies.imprint(problem.read({**loaded, "adhesion": {"work_of_adhesion": f"{much * work} J/m^2"}}))
    assert studies.imprint(problem.read(changed(adhesion={"work_of_adhesion": f"{much * work} J/m^2"}))), "a measured imprint"


def test_depths_and_indenters_of_an_imprint():
    for depths in (["70 nm"], ["30 nm"]):
        with pytest.raises(ProblemError, match=r"\[compute\]: an imprint unloads from 61.5 nm to its residual depth 38.8 nm"):
            studies.imprint(problem.read(changed(compute={"depths": depths})))
    sticky = changed(medium=ELASTIC, compute={"depths": ["38 nm", "61.5 nm"]}, adhesion={"work_of_adhesion": "1 J/m^2"})
    assert studies.imprint(problem.read(sticky)).values("states")[0] == pytest.approx([38e-9, 61.5e-9])
    with pytest.raises(ProblemError, match=r"\[indenter\]: the contact radius of a flat punch does not change"):
        studies.imprint(problem.read({**TABLES, "indenter": {"shape": "flat-punch", "radius": "1 um"}}))


@pytest.mark.parametrize("ratio", [None, 0.1])
def test_a_hardness_instead_of_a_yield_stress(ratio):
    """The same R_Y as with Y by hand, and a note on its error; the overload rule takes it, too."""
    known = mdr.plastic.yield_stress_from_hardness(mdr.Elastic(70e9, 0.33), 1e9, ratio)
    keys = {"hardness": "1 GPa", **({"radius_ratio": ratio} if ratio else {})}
    hard = changed(medium={"type": "homogeneous", "material": {**SOFT, **keys}})
    by_hand = changed(medium={"material": {**SOFT, "yield_stress": f"{known.yield_stress} Pa"}})
    found, expected = studies.imprint(problem.read(hard)), studies.imprint(problem.read(by_hand))
    name = "R_Y of the half-space"
    assert found.numbers[name].value == pytest.approx(expected.numbers[name].value, rel=1e-14)
    assert found.problem.yield_stresses == (known,)
    words = f"MPa, with an error of {100 * known.error:.2g} %"
    assert words in found.notes["yield stress of the half-space"] and "yield stress of the half-space" not in expected.notes
    loaded = [{key: value for key, value in tables.items() if key != "imprint"} for tables in (hard, by_hand)]
    for tables in loaded:
        tables["compute"] = {"forces": ["2.5 mN"]}
    left = [studies.imprint(problem.read(tables)).imprint.residual_depth for tables in loaded]
    assert left[0] == pytest.approx(left[1], rel=1e-12)


def test_loading_by_the_yield_stress_leaves_an_imprint():
    """Without [imprint]: the overload rule is the law of a paraboloid on a half-space."""
    found = studies.imprint(problem.read(changed(imprint=None, compute={"max_force": "2.8 mN"})))
    law = mdr.plastic.PlasticLaw(mdr.Paraboloid(10e-6), mdr.plastic.Yielding(mdr.Elastic(70e9, 0.33), 0.35e9), 70e-9)
    state = law.loading(found.numbers["largest depth"].value)
    assert found.numbers["largest force"].value == pytest.approx(2.8e-3) == state.force
    assert found.numbers["residual depth"].value == pytest.approx(state.residual_depth, rel=0.01)
    assert found.imprint.radius == pytest.approx(state.radius, rel=1e-3)
    assert found.values("states")[2][-1] == pytest.approx(2.8e-3)
    for table in ({"max_depth": "60 nm"}, {"radii": ["0.5 um", "1 um"]}):
        key = "depth" if "max_depth" in table else "radius"
        made = studies.imprint(problem.read(changed(imprint=None, compute=table))).imprint
        assert getattr(made, key) == pytest.approx({"depth": 60e-9, "radius": 1e-6}[key], rel=1e-9)
    with pytest.raises(mdr.MDRError, match="nothing has yielded"):
        studies.imprint(problem.read(changed(imprint=None, compute={"max_depth": "0.1 nm"})))
