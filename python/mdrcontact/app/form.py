# SPDX-License-Identifier: GPL-3.0-or-later
"""The form of a problem file: its schema decides what is asked, its text what is shown, and each change is an edit of the text."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any, NamedTuple

import dash_bootstrap_components as dbc
from dash import html

from .._units import with_micro, without_micro
from ..errors import MDRError
from ..instruments.files.start_file import MARK
from ..problem import edit
from ..problem.field import Field, Table
from ..problem.medium import MATERIAL

Path = tuple["str | int", ...]
Values = Mapping[str, Any]
_CRYSTAL, _CONSTANTS = "crystal", "constants"
_KIND, _ONE, _OR = "#kind", "#one", "#or"
"""Last steps of the paths of choices that are no keys: kind of a material, one key of a group, and a word or a table."""
_LAYERS = ("homogeneous", "coated", "layered")
_KINDS = tuple(dict.fromkeys(kind for one in MATERIAL.fields for kind in one.when.get("", ())))


def id_of(form: str, what: str, path: Path) -> dict[str, str]:
    """Return the id of a component: "set" for an input, "act" for a button, "error" for words."""
    return {"form": form, what: "/".join(map(str, path))}


def path_of(text: str) -> Path:
    """Return the path of an id."""
    return tuple(int(step) if step.isdigit() else step for step in text.split("/"))


def table_at(root: Table, path: Path) -> Table:
    """Return the table of the schema at a path of a file."""
    for step in path:
        if isinstance(step, str):
            root = root.field(step).table or root
    return root


def material_kind(values: Values) -> str:
    """Return the kind of a material by its keys."""
    if isinstance(values.get("material"), str):
        return _CRYSTAL
    found = set(_KINDS)
    for key in values:
        found &= {kind for one in MATERIAL.fields if one.name == key for kind in one.when.get("", ())} or found
    return next((kind for kind in _KINDS if kind in found), _KINDS[0])


def _is_material(table: Table) -> bool:
    return table is MATERIAL or table.extends is MATERIAL


def fields_of(table: Table, values: Values) -> list[Field]:
    """Return the fields that belong to a table with these values, one of each name."""
    kind = material_kind(values) if _is_material(table) else ""

    def holds(one: Field) -> bool:
        if kind and one.name in MATERIAL and (kind == _CRYSTAL or one.name == "material"):
            return kind == _CRYSTAL and one.name == "material"
        return not one.when or any(meets(key, words) for key, words in one.when.items())

    def meets(key: str, words: tuple[str, ...]) -> bool:
        if not words or not key:
            return key in values if key else kind in words
        return any(values.get(key, one.default) in words for one in table.fields if one.name == key and holds(one))

    found = {one.name: one for one in reversed(table.fields) if holds(one)}
    return [found[key] for key in table if key in found]


def example(one: Field) -> Any:
    """Return a value to begin with."""
    if one.table is not None:
        return [start(one.table)] if one.many else start(one.table)
    if one.choices and not one.dimension:
        return one.default or one.choices[0]
    if one.example:
        return json.loads(one.example)
    value = one.default or (0.3 if one.kind == "number" else one.dimension.example if one.dimension else "")
    return [value] if one.many else value


def start(table: Table, given: Values | None = None) -> dict[str, Any]:
    """Return the values of a table that belong to it, with an example for each key that is missing."""
    made = dict(given or {})
    for _ in range(3):  # what a word chooses belongs only then
        here = fields_of(table, made)
        groups = [[one.name for one in here if one.name in group] for group in table.one_of]
        for one in here:
            group = next((group for group in groups if one.name in group), [one.name])
            if (one.required or group in groups) and group[0] == one.name and not any(key in made for key in group):
                made[one.name] = example(one)
    names = [one.name for one in fields_of(table, made)]
    return {key: value for key, value in made.items() if any(key == name or _is_spelling(table, key, name) for name in names)}


def _is_spelling(table: Table, key: str, name: str) -> bool:
    return key not in table and key.startswith(f"{name}_")


def spelled(one: Field, table: Table, values: Values) -> tuple[str, Any]:
    """Return a key as the file has it, radius_nm for radius, and its value with the unit; None if it is absent."""
    for key, value in values.items():
        if key == one.name:
            return key, value
        if _is_spelling(table, key, one.name):
            unit = key[len(one.name) + 1 :]
            return key, [f"{each} {unit}" for each in value] if isinstance(value, list) else f"{value} {unit}"
    return one.name, None


def shown(value: Any) -> str:
    """Return a value of a file as an input shows it."""
    if isinstance(value, list) and not any(isinstance(one, (list, dict)) for one in value):
        return ", ".join(map(shown, value))
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)


def typed(one: Field, text: str) -> Any:
    """Return the value that a file has for what is typed; what is no number stays a text, of which the package raises an error."""
    if text.startswith(("[", "{")) and one.kind != "text":
        with suppress(MDRError):
            return edit.value(f"given = {text}", ("given",))
    if one.many:
        return [typed(one._replace(many=False), part.strip()) for part in text.split(",")]
    if one.kind in ("number", "whole number", "boolean"):
        with suppress(ValueError, OverflowError):
            value = json.loads(text)
            return value if math.isfinite(value) else text
    return text


def _table_in(text: str, place: Path) -> dict[str, Any]:
    """Return the table at a path, empty where the text has another value."""
    found = edit.value(text, place, {})
    return found if isinstance(found, dict) else {}


def edited(root: Table, text: str, path: Path, value: str) -> str:
    """Return the text after a change of an input of the form."""
    *inside, last = path
    place, key = tuple(inside), str(last)
    if key.startswith("#"):
        return _chosen(root, text, place, key, value)
    table, values = table_at(root, place), _table_in(text, place)
    one = next((one for one in fields_of(table, values) if one.name == key), None)
    if one is None:  # the form was drawn for another text
        return text
    name, old = spelled(one, table, values)
    if one.dimension is not None:
        if old is not None and value == with_micro(shown(old)):
            return text
        value = without_micro(value)
    if not value.strip():
        return text if old is None else edit.without(text, (*place, name))
    new = typed(one, value.strip())
    if not any(key in other.when for other in table.fields):
        text = edit.without(text, (*place, name)) if name != key else text
        return edit.changed(text, (*place, key), new)
    if key == "type" and {values.get("type"), new} <= {*_LAYERS}:
        layers, base = stack_of(values)
        count = _LAYERS.index(new)
        layers = (layers or [example(table.field("coating"))])[: count if count < 2 else None] if count else []
        return _differing(text, place, values, _with_stack(table, values, layers, base, new))
    return _differing(text, place, values, start(table, {**values, key: new}))


def _chosen(root: Table, text: str, place: Path, key: str, value: str) -> str:
    """Return the text after a choice that is no key."""
    if key == _OR:
        return edit.changed(text, place, start(table_at(root, place)) if value == _CONSTANTS else value)
    table, values = table_at(root, place), _table_in(text, place)
    if key == _ONE:
        rest = {name: old for name, old in values.items() if name not in next(group for group in table.one_of if value in group)}
        return _differing(text, place, values, start(table, {**rest, value: example(table.field(value))}))
    rest = {name: old for name, old in values.items() if name not in MATERIAL}
    if value == _CRYSTAL:
        made = {"material": MATERIAL.field("material").choices[0]}
    else:
        needed = [one for one in MATERIAL.fields if value in one.when.get("", ()) and one.required and one.name != "bulk_modulus"]
        made = {one.name: values.get(one.name, example(one)) for one in needed}
    return _differing(text, place, values, {**made, **rest})


def acted(root: Table, text: str, path: Path) -> str:
    """Return the text after a press of a button: its first step is "add" or "remove"."""
    what, *rest = path
    place = tuple(rest)
    if place[-1] == "layer" or (place[-2:-1] == ("layer",)):
        return _restacked(root, text, place, str(what))
    if what == "remove":
        return edit.without(text, place)
    return edit.changed(text, place, example(table_at(root, place[:-1]).field(str(place[-1]))))


def _restacked(root: Table, text: str, place: Path, what: str) -> str:
    """Return the text with another layer on top, or without one."""
    body = place[: place.index("layer")]
    table, values = table_at(root, body), _table_in(text, body)
    layers, base = stack_of(values)
    if what == "add" and values.get("type") == "layered":
        return edit.inserted(text, place, 0, example(table.field("coating")))
    if what == "add":
        layers = [example(table.field("coating")), *layers]
    else:
        layers = [one for i, one in enumerate(layers) if i != place[-1]]
    if values.get("type") == "layered" and len(layers) > 1:
        return edit.without(text, place)
    return _differing(text, body, values, _with_stack(table, values, layers, base))


def stack_of(values: Values) -> tuple[list[Any], Any]:
    """Return the layers of a body, top to bottom, and what is below them."""
    layers = values.get("layer", []) if values.get("type") == "layered" else [values["coating"]] if "coating" in values else []
    return [*layers], values.get("substrate", values.get("material"))


def _with_stack(table: Table, values: Values, layers: list[Any], base: Any, kind: str = "") -> dict[str, Any]:
    kind = kind or _LAYERS[min(len(layers), 2)]
    if base in ("rigid", "smooth", None) and kind == "homogeneous":
        base = start(MATERIAL)
    own: dict[str, dict[str, Any]] = {
        "homogeneous": {"material": base},
        "coated": {"coating": (layers or [None])[0], "substrate": base},
    }
    return start(table, {**values, "type": kind, **own.get(kind, {"layer": layers, "substrate": base})})


def _differing(text: str, place: Path, old: Values, new: Values) -> str:
    """Return the text with other values of a table; what is equal stays as it is."""
    for key in old.keys() - new.keys():
        text = edit.without(text, (*place, key))
    for key, value in new.items():
        if key not in old or old[key] != value:
            text = edit.changed(text, (*place, key), value)
    return text


def form(name: str, root: Table, text: str, used: str = "") -> Any:
    """Return a form. used : path of the button that gets the focus again"""
    return _Form(name, used, guessed(text)).part((), root, edit.value(text, ()))


def guessed(text: str) -> set[Path]:
    """Return the paths of the keys whose lines are marked as guesses."""
    found, place = set[Path](), ()
    for line in text.splitlines():
        header = re.match(r"\[([\w.]+)\]", line)
        place = tuple(header[1].split(".")) if header else place
        if MARK in line:
            found.add((*place, line.partition("=")[0].strip()))
    return found


def parts_of(drawn: Any) -> dict[str, tuple[Any, str]]:
    """Return the parts of a form by their paths, each with its inputs and buttons, but not their order and their values."""
    found, own = {}, list[str]()

    def visit(one: Any) -> None:
        for child in one.children if isinstance(one.children, list) else [one.children]:
            if isinstance(getattr(child, "id", None), dict) and "part" in child.id:
                found.update(parts_of(child))
                own.append(str(child.id))
            elif hasattr(child, "id"):
                own.append(f"{child.id}{getattr(child, 'options', '')}")
            if hasattr(child, "children") and "part" not in (getattr(child, "id", None) or ()):
                visit(child)

    visit(drawn)
    return {drawn.id["part"]: (drawn, "".join(sorted(own))), **found}


class _Form(NamedTuple):
    """Draws the tables of a form. What a word chooses is a part of its own, so that the word keeps the focus."""

    name: str
    used: str
    guesses: set[Path]

    def part(self, path: Path, table: Table, values: Values) -> Any:
        """Return the rows of a table: what is given or needed, then the rest behind a fold."""
        rows: list[Any] = []
        more: list[Any] = []
        fields, hidden = fields_of(table, values), set[str]()
        known = {one.name: spelled(one, table, values)[1] for one in fields}
        for group in (*table.one_of, *table.at_most_one_of):
            here = [key for key in group if key in known]
            given = [key for key in here if known[key] is not None]
            hidden |= {*here} - {*(given or here[: 1 if group in table.one_of else None])}
        for one in fields:
            if one.name in hidden or _chooses(one.name, table):
                continue
            own, value = (*path, one.name), known[one.name]
            if one.table is not None:
                rows += self.nested(one, own, value)
                continue
            is_needed = one.required or (one.choices and one.default) or any(one.name in group for group in table.one_of)
            (rows if value is not None or is_needed else more).append(self.field(one, own, value))
        place = "/".join(map(str, path))
        rows += [html.Details([html.Summary("further keys"), *more], open=self.used.rpartition("/")[0] == place)] if more else []
        return html.Div(rows, id={"form": self.name, "part": place})

    def inside(self, table: Table, path: Path, values: Values) -> list[Any]:
        """Return the rows that choose what belongs to a table, and the part that they choose."""
        rows: list[Any] = []
        if _is_material(table):
            kinds = (*_KINDS, _CRYSTAL)
            rows.append(self.row((*path, _KIND), "kind of material", self.select((*path, _KIND), kinds, material_kind(values))))
        here = fields_of(table, values)
        for group in table.one_of:
            names = [one.name for one in here if one.name in group]
            if len(names) > 1:
                given = next((key for key in names if spelled(table.field(key), table, values)[1] is not None), names[0])
                rows.append(self.row((*path, _ONE), "given by", self.select((*path, _ONE), names, given)))
        rows += [self.field(one, (*path, one.name), spelled(one, table, values)[1]) for one in here if _chooses(one.name, table)]
        return [*rows, self.part(path, table, values)]

    def nested(self, one: Field, path: Path, value: Any) -> Iterator[Any]:
        """Yield the fieldset of a table, one for each of many, or the button that adds it."""
        title, table = one.name.replace("_", " "), one.table
        assert table is not None
        if one.name in ("layer", "coating") or (one.name == "material" and path[-2] in ("medium", "body")):
            yield self.button(("add", *path[:-1], "layer"), "+ layer on top")
        if value is None and not one.required:
            yield self.button(("add", *path), f"+ {title}", one.meaning)
            return
        for i, each in enumerate(value if one.many and isinstance(value, list) else [value]):
            place = (*path, i) if one.many else path
            is_word = isinstance(each, str) and bool(one.choices)
            rows = [] if is_word else self.inside(table, place, each if isinstance(each, dict) else {})
            if one.choices:
                words, given = (*one.choices, _CONSTANTS), each if isinstance(each, str) else _CONSTANTS
                rows = [self.row((*place, _OR), title, self.select((*place, _OR), words, given)), *rows]
            if not one.required or one.many or one.name == "coating":
                gone = (*path[:-1], "layer", i) if one.name == "coating" else place
                rows.append(self.button(("remove", *gone), f"remove {title}"))
            yield html.Fieldset(
                [html.Legend(f"{title} {i + 1}" if one.many else title, title=one.meaning), *rows, self.error(place)]
            )

    def field(self, one: Field, path: Path, value: Any) -> Any:
        """Return the row of a key."""
        default = shown(one.default) if one.default is not None else ""
        if (one.choices and not one.dimension) or one.is_boolean:
            words = one.choices or ("true", "false")
            words = words if default or one.required else ("", *words)
            control = self.select(path, words, shown(value) if value is not None else default)
        else:
            given = "" if value is None else with_micro(shown(value)) if one.dimension else shown(value)
            control = dbc.Input(id=id_of(self.name, "set", path), value=given, placeholder=default, debounce=True)
        return self.row(path, one.meaning, control, one.name)

    def select(self, path: Path, words: Iterable[str], given: str) -> Any:
        """Return a choice; another word is also shown."""
        options = [{"label": word or "not given", "value": word} for word in dict.fromkeys((*words, given))]
        return dbc.Select(id=id_of(self.name, "set", path), options=options, value=given)

    def row(self, path: Path, meaning: str, control: Any, key: str = "") -> Any:
        """Return an input with its label and its error."""
        words, _, rest = meaning.partition(";")
        named: Any = [f"{words} ", html.Code(key)] if key not in ("", words) else words
        label = html.Label(named, title=rest.strip(), htmlFor=dom_id(id_of(self.name, "set", path)))
        return html.Div([label, control, self.error(path)], className="row guess" if path in self.guesses else "row")

    def error(self, path: Path) -> Any:
        """Return the place of an error."""
        return html.Span(id=id_of(self.name, "error", path), className="error")

    def button(self, path: Path, words: str, title: str = "") -> Any:
        """Return a button; it has the focus if it was used."""
        own = id_of(self.name, "act", path)
        return html.Button(words, id=own, title=title, n_clicks=0, type="button", autoFocus=own["act"] == self.used)


def _chooses(name: str, table: Table) -> bool:
    """Whether other keys of a table depend on a word."""
    return bool(table.field(name).choices) and any(name in one.when for one in table.fields)


def dom_id(one: dict[str, str]) -> str:
    """Return the id of a component in the page."""
    return json.dumps(one, sort_keys=True, separators=(",", ":"))
