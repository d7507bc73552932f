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

from collections.abc import Iterator, Mapping

from . import adhesion, compute, conduction, friction, history, indenter, medium, strength, wear
from .field import Field, Range, Table

__all__ = ["PROBLEM", "TABLES", "Field", "Range", "Table"]

_TABLES: Mapping[str, Table] = {
    "indenter": indenter.KNOWN,
    "medium": medium.KNOWN,
    "compute": compute.KNOWN,
    "adhesion": adhesion.KNOWN,
    "strength": strength.KNOWN,
    "friction": friction.KNOWN,
    "history": history.KNOWN,
    "wear": wear.KNOWN,
    "conduction": conduction.KNOWN,
}
PROBLEM = Table(
    "a problem",
    (
        Field("title", "title of the results", optional=True, example='"Sphere on an oxide film"'),
        *(Field(name, one.meaning, optional=name not in ("indenter", "medium"), table=one) for name, one in _TABLES.items()),
    ),
    "docs/problems.md",
)
"""The whole file. [compute] may be absent if [history] or a path of [friction] is there."""


def _below(path: str, table: Table) -> Iterator[tuple[str, Table]]:
    yield path, table
    for one in table.fields:
        if one.table is not None:
            yield from _below(f"{path}.{one.name}".lstrip("."), one.table)


TABLES: Mapping[str, Table] = dict(_below("", PROBLEM))
"""Every table by its path in the file, "medium.coating" for [medium.coating], "medium.layer" for [[medium.layer]]; "": the file."""
