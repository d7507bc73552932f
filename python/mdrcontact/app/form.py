# SPDX-License-Identifier: GPL-3.0-or-later
"""The form of a problem file: its schema decides what is asked, its text what is shown, and each change is an edit of the text."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

import dash_bootstrap_components as dbc
from dash import html

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
    """Return the value that a file has for what is typed; what is no number stays a text, which the package refuses."""
    if text.startswith(("[", "{")):
        return edit.value(f"given = {text}", ("given",))
    if one.many:
        return [typed(one._replace(many=False), part.strip()) for part in text.split(",")]
    if one.kind in ("number", "whole number", "boolean"):
        try:
            return json.loads(text)
        except ValueError:
            return text
    return text


def edited(root: Table, text: str, path: Path, value: str) -> str:
    """Return the text after a change of an input of the form."""
    *inside, last = path
    place, key = tuple(inside), str(last)
    if key.startswith("#"):
        return _chosen(root, text, place, key, value)
    table, values = table_at(root, place), edit.value(text, place, {})
    one = next(one for one in fields_of(table, values) if one.name == key)
    name, old = spelled(one, table, values)
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
    table, values = table_at(root, place), edit.value(text, place, {})
    if key == _ONE:
        rest = {name: old for name, old in values.items() if name not in next(group for group in table.one_of if value in group)}
        return _differing(text, place, values, start(table, {**rest, value: example(table.field(value))}))
    rest = {name: old for name, old in values.items() if name not in MATERIAL}
    if value == _CRYSTAL:
        made = {"material": MATERIAL.field("material").choices[0]}
    else:
        made = {
            one.name: values.get(one.name, example(one))
            for one in MATERIAL.fields
            if value in one.when.get("", ()) and one.required
        }
        made = {name: new for name, new in made.items() if name != "bulk_modulus"}
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
    table, values = table_at(root, body), edit.value(text, body, {})
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


def form(name: str, root: Table, text: str, skip: tuple[str, ...] = ()) -> list[Any]:
    """Return the components of a form. skip : tables that are shown elsewhere"""
    return [*_inside(name, root, (), edit.value(text, ()), skip)]


def _inside(name: str, table: Table, path: Path, values: Values, skip: tuple[str, ...] = ()) -> Iterator[Any]:
    """The rows of a table: what is given or needed, then the rest behind a fold."""
    more = []
    if _is_material(table):
        choices = (*_KINDS, _CRYSTAL) if len(path) > 1 else _KINDS
        yield _row(name, (*path, _KIND), "kind of material", _select(name, (*path, _KIND), choices, material_kind(values)))
    groups = {key: group for group in (*table.one_of, *table.at_most_one_of) for key in group}
    here = [one for one in fields_of(table, values) if one.name not in skip]
    names = {one.name for one in here}
    for one in here:
        key, value = spelled(one, table, values)
        others = [other for other in groups.get(one.name, ()) if other in names]
        if value is None and any(spelled(table.field(other), table, values)[1] is not None for other in others):
            continue
        if one.name in {key for group in table.one_of for key in group} and len(others) > 1:
            if value is None and others[0] != one.name:
                continue
            yield _row(name, (*path, _ONE), "given by", _select(name, (*path, _ONE), others, one.name))
        if one.table is not None:
            yield from _nested(name, one, (*path, one.name), value)
            continue
        own = _field(name, one, (*path, one.name), value)
        if value is not None or one.required or (one.choices and one.default):
            yield own
        else:
            more.append(own)
    if more:
        yield html.Details([html.Summary("further keys"), *more])


def _nested(name: str, one: Field, path: Path, value: Any) -> Iterator[Any]:
    title = one.name.replace("_", " ")
    if one.name == "layer" or one.name in ("coating", "material") and path[-2:-1] in (("medium",), ("body",)):
        yield _button(name, ("add", *path[:-1], "layer"), "+ layer on top")
    if value is None and not one.required:
        yield _button(name, ("add", *path), f"+ {title}", one.meaning)
        return
    words = [*one.choices, _CONSTANTS] if one.choices else []
    for i, each in enumerate(value if one.many and isinstance(value, list) else [value]):
        place = (*path, i) if one.many else path
        rows = [*_inside(name, one.table, place, each or {})] if not isinstance(each, str) and one.table else []
        if words:
            rows.insert(
                0,
                _row(
                    name, (*place, _OR), title, _select(name, (*place, _OR), words, each if isinstance(each, str) else _CONSTANTS)
                ),
            )
        if not one.required or one.many or one.name == "coating":
            gone = (*path[:-1], "layer", i) if one.name == "coating" else place
            rows.append(_button(name, ("remove", *gone), f"remove {title}"))
        words_of = f"{title} {i + 1}" if one.many else title
        yield html.Fieldset([html.Legend(words_of, title=one.meaning), *rows, _error(name, place)])


def _field(name: str, one: Field, path: Path, value: Any) -> Any:
    if (one.choices and not one.dimension) or one.is_boolean:
        words = one.choices or ("true", "false")
        default = shown(one.default) if one.default is not None else ""
        given = shown(value) if value is not None else default
        control = _select(name, path, words if default or value is not None and one.required else ("", *words), given)
    else:
        hint = shown(one.default) if one.default is not None else ""
        control = dbc.Input(
            id=id_of(name, "set", path), value="" if value is None else shown(value), placeholder=hint, debounce=True
        )
    return _row(name, path, one.meaning, control, one.name)


def _select(name: str, path: Path, words: Any, given: str) -> Any:
    options = [{"label": word or "not given", "value": word} for word in dict.fromkeys((*words, given))]
    return dbc.Select(id=id_of(name, "set", path), options=options, value=given)


def _row(name: str, path: Path, meaning: str, control: Any, key: str = "") -> Any:
    words, _, rest = meaning.partition(";")
    label = html.Label(
        [words, html.Code(key)] if key not in ("", words) else words, title=rest.strip(), htmlFor=_dom(id_of(name, "set", path))
    )
    return html.Div([label, control, _error(name, path)], className="row")


def _error(name: str, path: Path) -> Any:
    return html.Span(id=id_of(name, "error", path), className="error")


def _button(name: str, path: Path, words: str, title: str = "") -> Any:
    return html.Button(words, id=id_of(name, "act", path), title=title, n_clicks=0, type="button")


def _dom(one: dict[str, str]) -> str:
    """Return the id of a component in the page."""
    return json.dumps(one, sort_keys=True, separators=(",", ":"))
