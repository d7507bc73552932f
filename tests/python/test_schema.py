# SPDX-License-Identifier: GPL-3.0-or-later
"""The schema of problem files: what it says of each key is what the readers do, in every case of the walk through files."""

from __future__ import annotations

import copy
import doctest
import re

import pytest
from conftest import ROOT
from walk_files.cases import CASES, SAMPLES
from walk_files.measured import CALIBRATED, FITS, LABELS, MAPS, read_in
from walk_files.tables import plain_name, table_at, watched
from walk_files.walk import rules

import mdrcontact as mdr
from mdrcontact._units import RATIO, dimensions
from mdrcontact.cli import main
from mdrcontact.cli.keys import TITLE
from mdrcontact.instruments import schema as measured
from mdrcontact.problem import read, schema, structure
from mdrcontact.problem.field import Field, Range, Table

EVERY = {id(one): one for one in (*schema.TABLES.values(), schema.MAP, *measured.TABLES.values())}
"""Each table of the three kinds of files, by identity."""
BY_SPRING = "control", "spring_stiffness"
"""The one default that another key changes."""


def outcome(tables, folder):
    """The problem that tables describe, and the words of a refusal."""
    try:
        if "fit" in tables or "map" in tables:
            return read_in(folder, "fit" if "fit" in tables else "map", tables), ""
        problem = read(tables, folder=folder)
        if problem.conduction:
            problem.conduction.conduction(problem.medium)
        return problem, ""
    except mdr.MDRError as refusal:
        return None, str(refusal)


def cases(folder):
    """Every case, its files written, and what its readers read."""
    for name, content in LABELS.items():
        (folder / name).write_bytes(content)
    for case in (*CASES, *FITS, CALIBRATED, *MAPS):
        for name, text in case.files.items():
            (folder / name).write_text(text, encoding="utf-8")
        with watched() as seen:
            words = outcome(case.tables, folder)[1]
        assert not words, (case.name, words)
        yield case, seen


def table_of(case, path):
    """The table of the schema that has this name in the file of a case."""
    name = "" if path == "the file" else plain_name(path)
    if case.commands == ("fit",):
        return measured.TABLES[name]
    return schema.MAP if case.commands == ("map",) and not name else schema.TABLES[name]


def places(folder):
    """Every table of the cases that differs from others: a case with it, where it stands, and its schema."""
    before = set()
    for case, seen in cases(folder):
        for place, known in seen.known.items():
            found = table_at(case.tables, place)
            if found is not None and isinstance(known, Table) and (place, repr(found)) not in before:
                before.add((place, repr(found)))
                yield case, place, found, known


def with_key(case, place, key, value):
    """The tables of a case with another value of a key, without it where that is None."""
    tables = copy.deepcopy(case.tables)
    inside = table_at(tables, place)
    inside[key] = value
    if value is None:
        inside.pop(key)
    return tables


def belonging(table, found):
    """The fields that belong to a table of a file, by the schema alone."""
    kinds_with = {key: {kind for one in table.fields if one.name == key for kind in one.when.get("", ())} for key in table}
    kinds = set().union(*kinds_with.values()) if "material" not in found else set()
    for key in found:
        kinds &= kinds_with.get(key) or kinds

    def holds(one):
        return not one.when or any(meets(key, words) for key, words in one.when.items())

    def meets(key, words):
        if key == "":
            return bool(kinds & set(words))
        value = found.get(key, table.field(key).default)
        return any(map(holds, (one for one in table.fields if one.name == key))) and (value in words if words else key in found)

    return [one for one in table.fields if holds(one)]


def by_another_table(case, place, key):
    """Whether a key of a fit belongs to its table because of the medium or the kind of data."""
    return key in (*measured.CANTILEVER, "drainage") or (case.name == "gel" and place == "fit")


def in_file(one, value):
    """A value in SI units as it stands in a file."""
    if isinstance(value, (str, bool)) or one.step:
        return value
    return float(value) if one.dimension == RATIO else f"{float(value)!r} {one.dimension.si}"


def sample(place, one):
    found = SAMPLES.get((plain_name(place), one.name)) or SAMPLES.get(("*", one.name)) or one.choices or [one.dimension.example]
    return found[-1]


def test_readers_take_their_keys_and_words_from_the_schema(tmp_path):
    visited, words, free = set(), set(), set()
    for case, seen in cases(tmp_path):
        for path, known in seen.known.items():
            if isinstance(known, Table):
                assert table_of(case, path) is known, path
                visited.add(id(known))
            elif path.startswith("fit.free."):
                free.add(tuple(known))
        for (path, key), choices in seen.choices.items():
            one = next(one for one in table_of(case, path).fields if (one.name, one.choices) == (key, tuple(choices)))
            words.add(id(one))
    assert visited == {*EVERY} - {id(measured.TABLES["fit.free"])} and free == {tuple(measured.TABLES["fit.free"])}
    unread = {one.name for table in EVERY.values() for one in table.fields if one.choices and id(one) not in words}
    # these words are not read by `choice`
    assert unread == {"weight_nu", "drift", *schema.TABLES["strength"]}


def test_keys_belong_where_the_schema_says(tmp_path):
    count = 0
    for case, place, found, table in places(tmp_path):
        here = {one.name for one in belonging(table, found)}
        for key in table:
            # what a crystal has, and what a spring changes
            if (
                key in found
                or ("material" in (key, *found) and "thickness" in table)
                or (key == BY_SPRING[1] and BY_SPRING[0] not in found)
                or by_another_table(case, place, key)
            ):
                continue
            one = table.field(key) if key in {one.name for one in table.fields} else table.inner.field(key)
            _, words = outcome(with_key(case, place, key, sample(place, one)), tmp_path)
            count += 1
            if key in here:
                assert not re.search(rf"\b{key}'? (does not belong|is not the medium's|is not an option)", words), words
            else:
                assert words, (case.name, place, key)
    assert count > 1000


def test_defaults_are_those_of_the_readers(tmp_path):
    """An absent key means what its default says; of bodies by what they answer, since they print what is given."""
    seen = set()
    for case, place, found, table in places(tmp_path):
        for one in belonging(table, found):
            if one.default is None or (one.name == BY_SPRING[0] and BY_SPRING[1] in found):
                continue
            if any(other.when.get(one.name) == () for other in table.fields if other.name in found):
                continue
            if by_another_table(case, place, one.name):
                continue
            before, refusal = outcome(with_key(case, place, one.name, None), tmp_path)
            after, words = outcome(with_key(case, place, one.name, in_file(one, one.default)), tmp_path)
            assert words == refusal, (case.name, place, one.name, words)
            if words:
                continue
            if repr(before) != repr(after):
                assert repr(before._replace(medium=None)) == repr(after._replace(medium=None)), (case.name, place, one.name)
                one_body, other = (problem.medium.modulus([0.7e-6, 2.3e-6]) for problem in (before, after))
                assert one_body == pytest.approx(other, rel=1e-9), (case.name, place, one.name)
            seen.add(one.name)
    assert seen == {one.name for table in EVERY.values() for one in table.fields if one.default is not None}


def test_what_is_required_must_be_there_and_nothing_else(tmp_path):
    absent, required = set(), set()
    for case, place, found, table in places(tmp_path):
        groups = {name for group in table.one_of for name in group}
        for one in belonging(table, found):
            if one.name in found and one.required and one.name not in groups:
                required.add((plain_name(place), one.name))
                assert outcome(with_key(case, place, one.name, None), tmp_path)[1], (case.name, place, one.name)
            if one.name not in found:
                assert not one.required or one.name in groups, (case.name, place, one.name)
            if one.name not in found or not outcome(with_key(case, place, one.name, None), tmp_path)[1]:
                absent.add(one.name)
    assert len(required) > 40
    optional = {one.name for table in EVERY.values() for one in table.fields if not one.required} - {*measured.TABLES["fit.free"]}
    # of these both or none
    assert optional - absent == {"moduli", "times"}


def test_ranges_hold(tmp_path):
    """A number just outside is refused; one just inside is not, in some case, for its own sake."""
    tried, taken = set(), set()
    for case, place, found, table in places(tmp_path):
        for one in belonging(table, found):
            if one.name not in found or one.range is None:
                continue
            step, old = one.step or 1e-6, found[one.name]
            for end, closed, outwards in (one.range[0], one.range[2], -step), (one.range[1], one.range[3], step):
                if abs(end) == float("inf"):
                    continue
                for value, outside in (end + outwards * closed, True), (end - outwards * (not closed), False):
                    if not outside and (one.name, one.meaning, value) in taken:
                        continue
                    new = in_file(one, int(value) if one.step else value)
                    tables = with_key(case, place, one.name, [new, *old[1:]] if isinstance(old, list) else new)
                    words = outcome(tables, tmp_path)[1]
                    assert words or not outside, (case.name, place, one.name, new)
                    if not outside:
                        tried.add((one.name, one.meaning, value))
                        if not re.search(rf"(?<!entry 2 of )\b{one.name} = ", words):
                            taken.add((one.name, one.meaning, value))
    # these are bounded by other keys, too
    assert len(tried) > 40 and {name for name, _, _ in tried - taken} == {"C11", "nu_t", "min_depth"}


@pytest.mark.parametrize(
    ("table", "classes"),
    [
        ("medium.coating", (mdr.Elastic, mdr.TransverselyIsotropic, mdr.Viscoelastic, mdr.PowerLawRheology, mdr.Layer)),
        ("medium.coating.interface", (mdr.Interface,)),
        ("medium", (mdr.Graded, mdr.PowerLawGraded, mdr.TabulatedMedium)),
        ("indenter", [shape for shape in vars(mdr.profile).values() if isinstance(shape, type)]),
        ("instrument", (mdr.instruments.Instrument,)),
    ],
)
def test_quantities_have_the_dimensions_of_the_classes(table, classes):
    known = {**measured.TABLES, **schema.TABLES}[table]
    assert {name: known[name] for name in dimensions(*classes)} == dimensions(*classes)


TEXTS = {path.stem: path.read_text("utf-8") for path in (ROOT / "python" / "mdrcontact" / "cli" / "help").glob("*.txt")}
READ = {command: title[2].split() for command, text in TEXTS.items() if (title := TITLE.search(text)) and title[2]}


@pytest.mark.parametrize("command", sorted(READ))
def test_help_lists_the_keys_of_the_tables_that_a_command_reads(command, capsys):
    with pytest.raises(SystemExit):
        main([command, "--help"])
    text = capsys.readouterr().out
    for name, table in {**schema.TABLES, **measured.TABLES}.items():
        if name.partition(".")[0] in READ[command]:
            assert not [key for key in (*table.fields, *table.replaced) if not re.search(rf"^  {key.name} = ", text, re.MULTILINE)]
    foreign = {rule.key for rule in rules() if (rule.command, rule.case, rule.table, rule.how) == (command, "*", "the file", "*")}
    if foreign:
        foreign |= {"adhesion"} if command in ("friction", "wear") else set()  # refused
        assert {*READ[command]} == {one.name for one in schema.PROBLEM.fields if one.table} - foreign


@pytest.mark.parametrize("module", [mdr.problem, structure, schema, measured], ids=lambda module: module.__name__)
def test_examples_of_docstrings_run(module):
    found = doctest.testmod(module)
    assert found.attempted and not found.failed


def test_conditions_may_depend_on_conditions():
    """An option of a model belongs to types that have a model."""
    table = Table(
        "a table",
        (
            Field("type", "", choices=("one", "two")),
            Field("model", "", choices=("a", "b"), when={"type": ("one",)}),
            Field("option", "", when={"model": ("a",)}),
            Field("option", "", when={"type": ("three",)}),
        ),
    )
    assert table.keys_of("type", "one") == ["type", "model", "option"] and table.keys_of("type", "two") == ["type"]
    assert list(table) == ["type", "model", "option"] and len(table) == 3


def test_an_interval_has_ends_or_not():
    assert Range(0.0).holds(1e-300) and not Range(0.0).holds(0.0) and not Range(0.0).holds(float("inf"))
    assert Range(0.0, 1.0, True, True).holds(0.0) and Range(0.0, 1.0, True, True).holds(1.0) and not Range().holds(float("nan"))
