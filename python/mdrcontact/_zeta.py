# SPDX-License-Identifier: GPL-3.0-or-later
"""zeta(a) = d/g(a), equation (9): what the user gives, or the exact one of the same body."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ._boundary import row
from .errors import ArgumentTypeError, DomainError, InvalidArgumentError, UnreachableError

Table = tuple[tuple[float, ...], tuple[float, ...]]

_DECADES = 3.0
"""The exact zeta is sampled from h/1000, where the coating alone is felt, to 1000 h, where the substrate is."""
_PER_DECADE = 60


def table(zeta: Any) -> Table:
    """A user's pair (radii, values), checked for its form; the values are the library's business."""
    try:
        radii, values = zeta
    except (TypeError, ValueError) as problem:
        raise ArgumentTypeError(f'zeta = {zeta!r} is not allowed: it must be a pair (radii, values) or "exact"') from problem
    pair = row("radii of zeta", radii), row("values of zeta", values)
    if len(pair[0]) != len(pair[1]):
        raise InvalidArgumentError(f"radii and values of zeta must have the same length; it is {len(pair[0])} and {len(pair[1])}")
    return pair


def exact(indenter: Any, medium: Any, contact: Callable[..., Any]) -> Table:
    """The exact zeta of an indenter on the body of an approximate medium, sampled at logarithmic radii.

    contact : the class Contact
    """
    if not hasattr(medium, "with_model") or getattr(medium, "model", None) == "exact":
        raise InvalidArgumentError(
            'zeta = "exact" is not allowed here: it needs a coated, layered or graded body under an approximate model'
        )
    truth = contact(indenter, medium.with_model("exact"))
    b, h = truth.at_depth(0.0).radius, _thickness(medium)
    beyond = np.geomspace(h * 10.0**-_DECADES, h * 10.0**_DECADES, round(2 * _DECADES * _PER_DECADE) + 1)
    beyond = beyond[beyond > 1e-6 * b]
    radii = _reachable(truth, b, beyond)
    if len(radii) < 3:
        raise InvalidArgumentError(
            'zeta = "exact" is not allowed here: this indenter has but one contact radius, or ends within '
            "a thousandth of the coating thickness"
        )
    values = np.asarray(truth.at_radius(radii).depth) / np.asarray(indenter.mdr(radii))
    return tuple(radii.tolist()), tuple(values.tolist())


def _reachable(contact: Any, b: float, beyond: Any) -> Any:
    """The radii b + beyond as far as the contact has states, and one close to its end."""

    def is_reached(distance: float) -> bool:
        try:
            contact.at_radius(b + distance)
        except (DomainError, UnreachableError):
            return False
        return True

    if is_reached(beyond[-1]):
        return b + beyond
    low, high = 0.0, beyond[-1]
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_reached(middle) else (low, middle)
    kept = beyond[beyond < 0.99 * low]
    return b + np.append(kept, low) if len(kept) else kept


def _thickness(medium: Any) -> float:
    if hasattr(medium, "lower"):
        return max(_thickness(body) for body in (medium.lower, medium.upper) if hasattr(body, "with_model"))
    if hasattr(medium, "thickness"):
        return float(medium.thickness)
    if hasattr(medium, "layers"):
        return float(sum(h for _, h in medium.layers))
    return float(np.max(medium.z))
