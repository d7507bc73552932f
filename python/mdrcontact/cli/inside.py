# SPDX-License-Identifier: GPL-3.0-or-later
"""What `mdrcontact stress` finds inside a body, for its tables and its figure."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..contact import Contact, State
from ..critical import Critical
from ..failure import Failure
from ..interior import Interior

_POINTS = 121
_FARTHEST = 2.0
"""How far a map goes beyond the axis, in units of a."""


class Layer(NamedTuple):
    """The field on a grid in one layer, in the plane of sliding."""

    x: NDArray[np.float64]
    z: NDArray[np.float64]
    field: Interior


class Inside(NamedTuple):
    """What the command finds; SI units."""

    state: State
    friction: float
    faces: list[float]
    critical: Critical
    failures: tuple[Failure, ...]
    unreached: list[str]
    """strengths that are not reached"""
    maps: list[Layer]


def layer_map(contact: Contact, state: State, friction: float, faces: list[float], i: int) -> Layer:
    """The field in a layer on the plane of sliding, as far as a map shows it; points where stresses are infinite are left out."""
    a, total = float(state.radius), faces[-1]
    deepest = max(1.6 * a, min(1.5 * total, total + 2.0 * a))
    top, bottom = faces[i], faces[i + 1] if i + 1 < len(faces) else deepest
    bottom = max(min(bottom, deepest), top)
    x = np.linspace(-_FARTHEST * a, _FARTHEST * a, 2 * _POINTS - 1)
    hair = 1e-9 * (a + top)
    z = np.linspace(top + (hair if top else 0.0), bottom - hair if i + 1 < len(faces) else bottom, _POINTS)
    z[0] = z[0] or 1e-3 * (z[1] - z[0])
    # x < 0 lies on the other side of the axis
    field = state.interior(
        np.abs(x)[:, None], z[None, :], side="above", friction=friction, angle=np.where(x < 0.0, math.pi, 0.0)[:, None]
    )
    return Layer(x, z, field)


def layer_name(faces: list[float], i: int) -> str:
    """What a layer is called."""
    if i == len(faces) - 1:
        return "substrate" if i else "body"
    return "film" if len(faces) == 2 else f"layer {i + 1}"


def interface_name(faces: list[float], i: int) -> str:
    """What an interface is called."""
    return "interface" if len(faces) == 2 else f"interface {i + 1}"
