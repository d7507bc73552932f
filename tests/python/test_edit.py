# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files edited in place: one edit changes one line, all others stay byte for byte."""

import copy
import difflib
import doctest

import pytest
from conftest import ROOT

from mdrcontact.problem import ProblemError
from mdrcontact.problem.toml import parse_text

pytest.importorskip("tomlkit", reason="the extra app is not installed")
from mdrcontact.problem import edit  # noqa: E402

EXAMPLES = {path.stem: path.read_bytes().decode("utf-8") for path in sorted(ROOT.glob("examples/*/*.toml"))}
LAYERS = """\
# a stack
title = "two films"  # of glass

# the tip
[indenter]
shape = "sphere"  # a ball
radius = "10 um"

# the body
[medium]  # from the top
type = "layered"

# hard
[[medium.layer]]
E = "1 GPa"
nu = 0.3
thickness = "1 um"  # measured

# soft
[[medium.layer]]
E = "2 GPa"
nu = 0.3
thickness = "1 um"
[medium.layer.interface]
normal = "4 GPa/um"

# wafer
[medium.substrate]
E = "3 GPa"
nu = 0.3

[compute]
depths = [
  "1 nm",  # shallow
  "2 nm",
]
"""
INLINE = 'medium = { type = "layered", layer = [{ E = "1 GPa", nu = 0.3 }, { E = "2 GPa", nu = 0.2 }], substrate = "rigid" }\n'


def keys_of(tables, path=()):
    """The path of every value that is no table."""
    for step, value in tables.items() if isinstance(tables, dict) else enumerate(tables):
        if isinstance(value, dict) or (isinstance(value, list) and value and isinstance(value[0], dict)):
            yield from keys_of(value, (*path, step))
        else:
            yield (*path, step)


def lines_of(before, after):
    """Lines that an edit takes away, and those that it adds."""
    found = list(difflib.ndiff(before.splitlines(), after.splitlines()))
    return [line[2:] for line in found if line[0] == "-"], [line[2:] for line in found if line[0] == "+"]


def other(value):
    return value + 1 if isinstance(value, (int, float)) and not isinstance(value, bool) else "other # text"


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_value_set_to_itself_changes_nothing(name):
    text = EXAMPLES[name]
    paths = list(keys_of(parse_text(text)))
    assert len(paths) > 5
    for path in paths:
        assert edit.changed(text, path, edit.value(text, path)) == text, path


@pytest.mark.parametrize("name", [*EXAMPLES, "layers", "inline"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_one_edit_changes_one_line(name, end):
    text = {**EXAMPLES, "layers": LAYERS, "inline": INLINE}[name].replace("\n", end)
    for path in keys_of(parse_text(text)):
        old = edit.value(text, path)
        new = [other(entry) for entry in old] if isinstance(old, list) else other(old)
        after = edit.changed(text, path, new)
        assert edit.value(after, path) == new
        away, added = lines_of(text, after)
        if not isinstance(old, list) or len(away) == 1:
            assert len(away) == len(added) == 1, path
            # a comment stays
            assert away[0].partition('" #')[2] in added[0] or "#" not in away[0]
        assert after.count(end) == text.count(end) or isinstance(old, list)
        if not isinstance(old, list):
            # and the way back
            way_back = edit.changed(after, path, old)
            assert way_back == text or lines_of(text, way_back) == (["nu = 0.30"], ["nu = 0.3"]), path


@pytest.mark.parametrize("name", [*EXAMPLES, "layers"])
def test_a_key_is_added_and_removed_in_one_line(name):
    text = {**EXAMPLES, "layers": LAYERS}[name]
    tables = parse_text(text)
    for path in {path[:-1] for path in keys_of(tables)}:
        after = edit.changed(text, (*path, "new key"), "1 um")
        away, added = lines_of(text, after)
        assert len(added) == 1 and len(away) <= 1 and '"new key" = "1 um"' in added[0], path
        assert edit.without(after, (*path, "new key")) == text, path
    for path in keys_of(tables):
        away, added = lines_of(text, edit.without(text, path))
        assert len(added) <= 1 and (len(away) == 1 or isinstance(edit.value(text, path), list)), path


def test_an_entry_of_a_list_of_values_is_one_line():
    after = edit.changed(LAYERS, ("compute", "depths", 0), "1.5 nm")
    assert lines_of(LAYERS, after) == (['  "1 nm",  # shallow'], ['  "1.5 nm",  # shallow'])


@pytest.mark.parametrize("place", [0, 1, 2])
def test_layers_are_inserted_and_removed(place):
    film = {"E": "7 GPa", "nu": 0.2, "thickness": "3 um"}
    for text in (LAYERS, INLINE):
        after = edit.inserted(text, ("medium", "layer"), place, film)
        layers = edit.value(text, ("medium", "layer"))
        assert edit.value(after, ("medium", "layer")) == [*layers[:place], film, *layers[place:]]
        assert edit.without(after, ("medium", "layer", place)) == text
    away, added = lines_of(LAYERS, edit.inserted(LAYERS, ("medium", "layer"), place, film))
    assert not away and sorted(added) == ["", 'E = "7 GPa"', "[[medium.layer]]", "nu = 0.2", 'thickness = "3 um"']


def test_a_new_layer_is_beside_its_neighbours():
    after = edit.inserted(LAYERS, ("medium", "layer"), 2, {"E": "7 GPa"})
    assert 'normal = "4 GPa/um"\n\n[[medium.layer]]\nE = "7 GPa"\n\n# wafer\n[medium.substrate]' in after
    after = edit.inserted(LAYERS, ("medium", "layer"), 1, {"E": "7 GPa"})
    assert 'thickness = "1 um"  # measured\n\n[[medium.layer]]\nE = "7 GPa"\n\n# soft\n[[medium.layer]]' in after


def test_all_layers_and_whole_tables_go_and_come():
    text = LAYERS
    for _ in range(2):
        text = edit.without(text, ("medium", "layer", 0))
    assert "layer" not in edit.value(text, ("medium",))
    text = edit.inserted(text, ("medium", "layer"), 0, {"E": "7 GPa"})
    assert edit.value(text, ("medium", "layer")) == [{"E": "7 GPa"}]
    text = edit.without(text, ("medium",))
    assert [line for line in text.splitlines() if line[:1] == "#"] == ["# a stack", "# the tip", "# the body"]
    assert not edit.value(text, ("medium",))
    away, added = lines_of(LAYERS, edit.changed(LAYERS, ("friction", "coefficient"), 0.3))
    assert not away and added == ["", "[friction]", "coefficient = 0.3"]


def test_a_table_becomes_a_word_and_a_word_a_table():
    word = edit.changed(LAYERS, ("medium", "substrate"), "rigid")
    assert edit.value(word, ("medium", "substrate")) == "rigid" and "[medium.substrate]" not in word
    assert lines_of(word, edit.changed(word, ("medium", "substrate"), {"E": "3 GPa", "nu": 0.3})) == (
        ['substrate = "rigid"'],
        ['substrate = { E = "3 GPa", nu = 0.3 }'],
    )
    assert edit.value(edit.changed(INLINE, ("medium", "substrate"), {"E": "3 GPa"}), ("medium", "substrate", "E")) == "3 GPa"


@pytest.mark.parametrize(
    ("text", "path", "expected"),
    [
        ("", ("title",), 'title = "x"\n'),
        ("# note\n", ("title",), '# note\ntitle = "x"\n'),
        ("a = 1", ("title",), 'a = 1\ntitle = "x"\n'),
        ("[a]", ("b", "c"), '[a]\n\n[b]\nc = "x"\n'),
        ("[a]", ("a", "c"), '[a]\nc = "x"\n'),
        ("[a]\n[a.b]\nc = 1\n", ("a", "d"), '[a]\nd = "x"\n[a.b]\nc = 1\n'),
        ("[a.b]\nc = 1\n", ("a", "d"), '[a]\nd = "x"\n\n[a.b]\nc = 1\n'),
        ("[a.b]\nc = 1\n", ("d",), 'd = "x"\n\n[a.b]\nc = 1\n'),
        ("a.b = 1\n", ("a", "c"), 'a.b = 1\na.c = "x"\n'),
        ("\ufeff[a]\r\nb = 1\r\n", ("a", "c"), '\ufeff[a]\r\nb = 1\r\nc = "x"\r\n'),
        ("[fit.free]\n", ("fit", "free", "coating.E", "start"), '[fit.free]\n\n[fit.free."coating.E"]\nstart = "x"\n'),
    ],
)
def test_keys_come_where_none_is(text, path, expected):
    assert edit.changed(text, path, "x") == expected


def test_values_are_written_as_they_are():
    for new in ("a \"b\" 'c' \\ é\x7f\n", 1e-6, -3, True, ["1 um", "2 um"], [1.0, 2.5], [], {"a b": {"c": [1]}}, {"E": "1 GPa"}):
        for text in ("[t]\nk = 0 # c\n", "t = { k = 0 }\n", "[t]\n", ""):
            assert edit.value(edit.changed(text, ("t", "k"), new), ("t", "k")) == new


def test_what_cannot_be_edited_is_an_error():
    for wrong in ("a = ", "[a\n", "[a]\nb = 1\nb = 2\n"):
        with pytest.raises(ProblemError, match="not valid TOML"):
            edit.changed(wrong, ("a", "b"), 1)
    for path in (("a", "b", "c"), ("a", 3), ("a", "b", 0)):
        with pytest.raises(ProblemError, match="cannot be edited"):
            edit.changed("[a]\nb = 1\n", path, 1)
    with pytest.raises(ProblemError, match="cannot be edited"):
        edit.without("[a]\nb = 1\n", ("a", "c"))
    with pytest.raises(ProblemError, match="cannot be edited"):
        edit.changed("[a]\n", ("a", "b"), float("nan"))


def test_a_value_that_is_absent_has_a_default():
    assert edit.value("[a]\nb = 1\n", ("a", "c", "d")) is None and edit.value("", ("a", 0), 7) == 7


def test_an_edit_leaves_what_it_was_given():
    new = {"E": "1 GPa", "moduli": ["1 GPa"]}
    before = copy.deepcopy(new)
    edit.changed(LAYERS, ("medium", "coating"), new)
    assert new == before


def test_the_example_of_the_page_runs():
    found = doctest.testmod(edit)
    assert found.attempted and not found.failed
