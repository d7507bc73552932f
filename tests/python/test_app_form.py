# SPDX-License-Identifier: GPL-3.0-or-later
"""The form of the page without a browser: what it shows is the text, and each of its changes is an edit of the text."""

import contextlib

import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact import problem
from mdrcontact.problem import schema

for name in ("dash", "dash_ag_grid", "dash_bootstrap_components", "tomlkit", "matplotlib"):
    pytest.importorskip(name)

from mdrcontact.app import form, measure  # noqa: E402
from mdrcontact.problem import edit  # noqa: E402

PROBLEMS = sorted((ROOT / "examples" / "problems").glob("*.toml"))
FITS = sorted((ROOT / "examples" / "fit").glob("*.toml"))
FILM = (ROOT / "examples" / "problems" / "sio2_on_si.toml").read_text(encoding="utf-8")


def inputs(root, text):
    """What the form shows, by path."""
    found = form.form("design", root, text)
    return {one.id["set"]: one.value for one in found._traverse() if isinstance(getattr(one, "id", None), dict) and "set" in one.id}


def changed(text, path, value):
    return form.edited(schema.PROBLEM, text, form.path_of(path), value)


def acted(text, path):
    return form.acted(schema.PROBLEM, text, form.path_of(path))


@pytest.mark.parametrize("path", [*PROBLEMS, *FITS], ids=lambda path: path.stem)
def test_what_the_form_shows_changes_nothing_when_it_is_typed_again(path):
    text = path.read_text(encoding="utf-8")
    root = schema.PROBLEM if path in PROBLEMS else measure._ROOT
    shown = inputs(root, text)
    assert len(shown) > 8
    for key, value in shown.items():
        if value and not form.path_of(key)[-1].startswith("#"):
            table, values = root, edit.value(text, form.path_of(key)[:-1])
            again = form.edited(root, text, form.path_of(key), value)
            assert edit.value(again, form.path_of(key)) is not None and (again == text or key.split("/")[-1] not in values), (
                key,
                table,
            )


def test_the_keys_of_yielding_exclude_each_other():
    text = (ROOT / "examples" / "problems" / "aluminium_on_silicon.toml").read_text(encoding="utf-8")
    film = "medium/coating/"
    before = inputs(schema.PROBLEM, text)
    assert f"{film}yield_stress" in before and f"{film}hardness" not in before
    after = inputs(schema.PROBLEM, changed(changed(text, f"{film}yield_stress", ""), f"{film}hardness", "1 GPa"))
    assert after[f"{film}hardness"] == "1 GPa" and f"{film}yield_stress" not in after and after[f"{film}radius_ratio"] in ("", None)


def test_rough_surfaces_are_a_table_of_conduction():
    text = (ROOT / "examples" / "problems" / "tin_on_copper.toml").read_text(encoding="utf-8")
    text = acted(text, "add/conduction/joint")
    keys = ("roughness", "slope", "hardness", "gas", "jump")
    assert {f"conduction/joint/{key}" for key in keys} <= set(inputs(schema.PROBLEM, text))
    assert problem.read_text(text).conduction.joint is not None
    assert "joint" not in acted(text, "remove/conduction/joint")


@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_a_change_is_one_line(path):
    text = path.read_text(encoding="utf-8")
    again = changed(text, "indenter/radius", "3 um")
    lines = [one for one in zip(text.splitlines(), again.splitlines(), strict=True) if one[0] != one[1]]
    assert len(lines) == 1 and "3 um" in lines[0][1]


def test_layers_are_added_on_top_and_removed():
    two = acted(FILM, "add/medium/layer")
    assert edit.value(two, ("medium", "type")) == "layered" and len(edit.value(two, ("medium", "layer"))) == 2
    assert edit.value(two, ("medium", "layer", 1, "E")) == "72 GPa"
    three = acted(two, "add/medium/layer")
    assert len(problem.read_text(three).medium.layers) == 3
    one = acted(acted(three, "remove/medium/layer/0"), "remove/medium/layer/0")
    assert problem.read_text(one).medium == problem.read_text(FILM).medium
    none = acted(one, "remove/medium/layer/0")
    assert problem.read_text(none).medium.material == problem.read_text(FILM).medium.substrate


@pytest.mark.parametrize("shape", schema.TABLES["indenter"].field("shape").choices)
def test_every_shape_can_be_chosen_and_asks_what_it_needs(shape):
    text = changed(FILM, "indenter/shape", shape)
    shown = inputs(schema.PROBLEM, text)
    assert shown["indenter/shape"] == shape
    if shape not in ("table", "tabulated-profile", "tabulated-mdr-profile", "rounded-cone", "area-function", "power-law"):
        problem.read_text(text)


@pytest.mark.parametrize("kind", [*form._KINDS, "crystal"])
def test_every_kind_of_material_can_be_chosen(kind):
    text = changed(FILM, "medium/coating/#kind", kind)
    assert form.material_kind(edit.value(text, ("medium", "coating"))) == kind
    assert inputs(schema.PROBLEM, text)["medium/coating/#kind"] == kind
    assert edit.value(text, ("medium", "coating", "thickness")) == "500 nm"
    assert changed(text, "medium/coating/#kind", "elastic").count("E = ") == FILM.count("E = ")


def test_words_or_tables_and_one_of_several_keys():
    rigid = changed(FILM, "medium/substrate/#or", "rigid")
    assert problem.read_text(rigid).medium.substrate is problem.medium.RIGID
    assert edit.value(changed(rigid, "medium/substrate/#or", "constants"), ("medium", "substrate", "E")) == "70 GPa"
    forces = changed(FILM, "compute/#one", "max_force")
    assert edit.value(forces, ("compute",)) == {"max_force": "2 mN", "points": 100}
    cone = changed(changed(FILM, "indenter/shape", "cone"), "indenter/#one", "half_angle")
    assert [*edit.value(cone, ("indenter",))] == ["shape", "half_angle"]


def test_what_is_typed():
    assert edit.value(changed(FILM, "medium/coating/nu", "0.25"), ("medium", "coating", "nu")) == 0.25
    assert edit.value(changed(FILM, "medium/coating/nu", "a third"), ("medium", "coating", "nu")) == "a third"
    assert edit.value(changed(FILM, "compute/points", "50"), ("compute", "points")) == 50
    assert "points" not in edit.value(changed(FILM, "compute/points", ""), ("compute",))
    lists = changed(changed(FILM, "compute/#one", "depths"), "compute/depths", "10 nm, 20 nm")
    assert (
        edit.value(lists, ("compute", "depths")) == ["10 nm", "20 nm"]
        and inputs(schema.PROBLEM, lists)["compute/depths"] == "10 nm, 20 nm"
    )
    assert edit.value(changed(FILM, "title", "[draft] a film"), ("title",)) == "[draft] a film"
    for typed in ("[", "1e999", "NaN"):  # a text, of which the package raises an error
        text = changed(FILM, "medium/coating/nu", typed)
        with pytest.raises(mdr.MDRError, match="nu = .*it must be a number"):
            problem.read_text(text)
    # a key with its unit
    spelled = FILM.replace('radius = "10 um"', "radius_um = 10")
    assert inputs(schema.PROBLEM, spelled)["indenter/radius"] == "10 \u00b5m"
    assert problem.read_text(changed(spelled, "indenter/radius", "20 um")).indenter.radius == pytest.approx(20e-6)


def test_units_are_shown_with_the_micro_sign_and_written_without():
    assert inputs(schema.PROBLEM, FILM)["indenter/radius"] == "10 \u00b5m"
    for typed in ("12 \u00b5m", "12 \u03bcm", "12 um"):
        assert edit.value(changed(FILM, "indenter/radius", typed), ("indenter", "radius")) == "12 um"
    # what is not changed stays as it is written
    greek = FILM.replace('"10 um"', '"10 \u00b5m"')
    assert changed(greek, "indenter/radius", "10 \u00b5m") == greek and changed(FILM, "indenter/radius", "10 \u00b5m") == FILM
    assert problem.read_text(greek).indenter == problem.read_text(FILM).indenter


def test_only_other_rows_draw_a_part_again():
    before, after = (
        {path: own for path, (_, own) in form.parts_of(form.form("design", schema.PROBLEM, text)).items()}
        for text in (FILM, changed(FILM, "indenter/radius", "3 um"))
    )
    assert before == after
    cone = {
        path: own
        for path, (_, own) in form.parts_of(form.form("design", schema.PROBLEM, changed(FILM, "indenter/shape", "cone"))).items()
    }
    assert {path for path in before if before[path] != cone[path]} in ({"indenter"}, {"indenter", ""})


def test_guesses_are_marked():
    text = FILM.replace('thickness = "500 nm"', 'thickness = "500 nm"  # not in the file: put in yours')
    assert form.guessed(text) == {("medium", "coating", "thickness")}


@pytest.mark.parametrize("text", ["indenter = 'x'", "medium = [1]", "[medium]\nlayer = 3", "compute = {}", "title = 3", ""])
def test_a_strange_text_has_a_form(text):
    assert inputs(schema.PROBLEM, text).keys() > {"title", "indenter/shape"}
    with contextlib.suppress(mdr.MDRError):
        assert edit.value(changed(text, "indenter/shape", "berkovich"), ("indenter", "shape")) == "berkovich"
