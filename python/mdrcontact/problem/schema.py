# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a problem file as data: names, dimensions, choices, ranges and defaults of their keys, to make forms from.

Examples
--------
>>> from mdrcontact.problem import schema
>>> [one.name for one in schema.TABLES["wear"].fields]
['coefficient', 'sliding', 'intervals', 'scheme']
>>> schema.TABLES["indenter"].keys_of("shape", "cone")
['shape', 'inclination', 'half_angle', 'material', 'body']
"""

from __future__ import annotations

from collections.abc import Mapping

from . import adhesion, compute, conduction, friction, history, imprint, indenter, medium, strength, structure, wear
from .field import Field, Range, Table

__all__ = ["MAP", "PROBLEM", "TABLES", "Field", "Range", "Table", "tables_of"]

_TABLES: Mapping[str, Table] = {
    "indenter": indenter.KNOWN,
    "medium": medium.KNOWN,
    "compute": compute.KNOWN,
    "adhesion": adhesion.KNOWN,
    "strength": strength.KNOWN,
    "friction": friction.KNOWN,
    "history": history.KNOWN,
    "wear": wear.KNOWN,
    "imprint": imprint.KNOWN,
    "conduction": conduction.KNOWN,
}
PROBLEM = Table(
    "a problem",
    (
        Field("title", "title of the results", optional=True, example='"Sphere on an oxide film"'),
        *(Field(name, one.meaning, optional=name not in ("indenter", "medium"), table=one) for name, one in _TABLES.items()),
    ),
    "docs/problem-files.md",
)
"""The whole file. [compute] may be absent if [history], [imprint] or a path of [friction] is there."""


def tables_of(table: Table, path: str = "") -> dict[str, Table]:
    """Return a table and all tables inside, by their paths: "medium.layer" for [[medium.layer]], "" for the file."""
    found = {path: table}
    for one in table.fields:
        if one.table is not None:
            found |= tables_of(one.table, f"{path}.{one.name}".lstrip("."))
    return found


MAP = structure.KNOWN
"""The file of mdrcontact map."""
TABLES: Mapping[str, Table] = {**tables_of(PROBLEM), **tables_of(MAP), "": PROBLEM}
"""Every table of both files by its path, "medium.coating" for [medium.coating]; "": PROBLEM."""
