# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [compute] of a problem file: the depths, forces or radii of the results."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._units import QUANTITIES, RATIO, Dimension
from ..contact import Contact, States
from ..errors import MDRError
from .field import POSITIVE, Field, Range, Table
from .section import Section

_LISTS = {"depth": "depths", "force": "forces", "radius": "radii"}
DIMENSIONS = {name: QUANTITIES[name] for name in _LISTS}
MOST_POINTS = 100_000
_LARGEST: dict[str, tuple[str, ...]] = {f"max_{name}": () for name in DIMENSIONS}
_EACH = DIMENSIONS.items()

KNOWN = Table(
    "depths, forces or radii of the results; default of min_...: the largest divided by points, or by 1000 if spacing is log",
    (
        *(Field(f"max_{name}", f"largest {name}", one, range=POSITIVE) for name, one in _EACH),
        *(Field(f"min_{name}", f"smallest {name}", one, None, True, (), POSITIVE, {f"max_{name}": ()}) for name, one in _EACH),
        *(Field(_LISTS[name], f"{_LISTS[name]}, ascending", one, many=True) for name, one in _EACH),
        Field("points", "number of points", RATIO, 100, range=Range(1, MOST_POINTS, True, True), step=1, when=_LARGEST),
        Field("spacing", "spacing of the points", default="linear", choices=("linear", "log"), when=_LARGEST),
    ),
    one_of=(tuple(key for name in DIMENSIONS for key in (f"max_{name}", _LISTS[name])),),
)


class Control(NamedTuple):
    """The prescribed quantity, "depth", "force" or "radius", and its values in SI units, ascending."""

    name: str
    values: NDArray[np.float64]

    @property
    def dimension(self) -> Dimension:
        """Dimension of the prescribed quantity."""
        return DIMENSIONS[self.name]

    def states(self, contact: Contact, part: slice = slice(None)) -> States:
        """Return the states of a contact at the prescribed values, or at part of them."""
        at: Any = getattr(contact, f"at_{self.name}")
        try:
            states: States = at(self.values[part])
        except MDRError:
            for value in self.values[part]:
                at(float(value))  # a single value: the error has no index of the part
            raise
        return states


def read_control(section: Section) -> Control:
    """Return the values that [compute] prescribes."""
    starts = [key for key in KNOWN.one_of[0] if key in section]
    if len(starts) != 1:
        said = f"it has {' and '.join(starts) if starts else 'none'}"
        rule = f"it needs exactly one of max_depth, max_force, max_radius, depths, forces and radii; {said}"
        raise section.error(starts[1] if starts else "max_depth", rule, 'Write it as in max_depth = "100 nm"', shows=False)
    key = starts[0]
    if not key.startswith("max_"):
        section.only((key,), f"a list of {key}")
        name = next(name for name, many in _LISTS.items() if many == key)
        return Control(name, np.array(section.value(key)))
    name = key.removeprefix("max_")
    section.only((key, f"min_{name}", "points", "spacing"), key)
    return Control(name, _range(section, name))


def _range(section: Section, name: str) -> NDArray[np.float64]:
    largest = section.quantity(f"max_{name}")
    points, logarithmic = section.value("points"), section.value("spacing") == "log"
    smallest = largest / 1000.0 if logarithmic else largest / points
    if f"min_{name}" in section:
        smallest = section.quantity(f"min_{name}")
    if not 0.0 < smallest <= largest < math.inf:
        raise section.error(f"min_{name}", f"it must lie between 0 and max_{name} = {section.plain(f'max_{name}')!r}")
    space = np.geomspace if logarithmic else np.linspace
    return space(smallest, largest, points) if points > 1 else np.array([largest])
