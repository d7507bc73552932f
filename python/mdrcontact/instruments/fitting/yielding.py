# SPDX-License-Identifier: GPL-3.0-or-later
"""What yield stresses tell about a fit: whether the contact was elastic, and whether unloading is, theory/plastic.md (1.9)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._boundary import number
from ..._warn import silence
from ...contact import Contact
from ...critical import layers_of
from ...errors import ArgumentTypeError, DomainError, InvalidArgumentError, MDRError
from ...medium import Pair
from ...plastic import Imprint, YieldStress
from .data import ForceDepth, StiffnessDepth

Array = NDArray[np.float64]

ELASTIC, LARGEST = 2.0, 3.0
"""R_Y up to which unloading is elastic, and beyond which an imprint does not hold."""
_MOST = 12
"""Points of a curve of stiffnesses that are considered."""
_NO_YIELD = 1e6
"""Yield stress over mean pressure of a body that does not yield."""


class LayerYield(NamedTuple):
    """R_Y of a layer, from `FitResult.reverse_yield`.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 100e-9, 60), np.linspace(100e-9, 60e-9, 60)])
    >>> force = 1e-3 * np.concatenate([np.linspace(0.0, 1.0, 60) ** 2, np.linspace(1.0, 0.0, 60) ** 1.2])
    >>> force += 1e-6 * np.random.default_rng(0).standard_normal(120)
    >>> data = mdr.instruments.Unloading(depth, force)
    >>> body = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> result = mdr.instruments.fit(data, mdr.Berkovich(), body, ["E"], yield_stresses=[2.4e9])
    >>> (one,) = result.reverse_yield
    >>> print(one.layer, f"{one.ratio:.2f}")
    0 2.43
    """

    layer: int
    """the layer, 0 at the surface"""
    yield_stress: float
    """Y of the layer [modulus]"""
    ratio: float
    """R_Y, largest von Mises stress of the elastic body under the pressure at the largest force, over Y [1]"""
    error: float = 0.0
    """relative error of Y from a hardness, otherwise 0 [1]"""


def ratio_words(one: LayerYield) -> str:
    """Return R_Y as text, with its error if the yield stress has one."""
    return f"{one.ratio:.2f}" + (f" ± {one.error * one.ratio:.2f}" if one.error else "")


def _read(name: str, given: float | YieldStress | None) -> YieldStress:
    if isinstance(given, YieldStress):
        return given
    return YieldStress(math.inf if given is None else number(name, given), 0.0)


def read_yield_stresses(given: Iterable[float | YieldStress | None], data: Any, medium: Any) -> tuple[YieldStress, ...]:
    """Return the yield stress of each layer, infinite for one that does not yield; () without any."""
    stresses = tuple(_read(f"yield_stresses[{i}]", one) for i, one in enumerate(given))
    if not stresses:
        return ()
    for i, (stress, _) in enumerate(stresses):
        if not stress > 0.0:
            raise InvalidArgumentError(f"yield_stresses[{i}] = {stress:g}: it must be greater than 0, or None if nothing yields")
    if not isinstance(data, (ForceDepth, StiffnessDepth)):
        raise InvalidArgumentError(
            f"data = {type(data).__name__}(...): yield stresses need forces, ForceDepth or StiffnessDepth. Leave them out"
        )
    try:
        count = len(layers_of(medium)[0]) + 1
    except InvalidArgumentError:
        raise InvalidArgumentError(
            f"yield_stresses: a {type(medium).__name__} has no layers whose stresses are known. Leave them out"
        ) from None
    if len(stresses) != count:
        raise InvalidArgumentError(
            f"yield_stresses has {len(stresses)} entries: give one for each of {count}, the layers from the surface down and the "
            "body below them"
        )
    return stresses


def first_yield(result: Any, stresses: tuple[YieldStress, ...]) -> float:
    """Return the largest von Mises stress of the fitted elastic contact over the yield stress, of all layers.

    It is that without adhesion. A yield stress with an error is at its upper end.
    """
    data = result.data
    if not isinstance(data, ForceDepth):
        return 0.0
    with silence():
        try:
            force = float(np.max(data.y)) - result.values["force_offset"]
            layers = Contact(result.indenter, result.medium).at_force(force).critical().layers
        except MDRError:
            return 0.0
    return max(float(one.von_mises.value) / (y * (1.0 + error)) for one, (y, error) in zip(layers, stresses, strict=True))


def reverse_yield(result: Any, stresses: tuple[YieldStress, ...]) -> tuple[LayerYield, ...]:
    """Return the largest R_Y of each layer that can yield, over the curves of an unloading or the points of stiffnesses."""
    data, tool = result.data, result.instrument
    if not isinstance(data, StiffnessDepth) or data.force is None or data.elastic or result.problem.record["is_elastic"][0]:
        return ()
    radius = result.problem.predict(result._values)[1]
    load = data.force - tool.force_offset
    depth = data.x - tool.depth_offset - tool.frame_compliance * load
    left = [q.final_depth - tool.depth_offset for q in data.unloadings] or [math.nan] * len(data)
    both = result.medium if tool.indenter is None else Pair(result.medium, tool.indenter)
    if hasattr(both, "with_model"):
        both = both.with_model("exact")
    body = both.lower if isinstance(both, Pair) else both
    layers = [i for i, (y, _) in enumerate(stresses) if math.isfinite(y)]
    most = np.zeros(len(layers))
    for i in np.unique(np.linspace(0, len(data) - 1, min(len(data), _MOST)).round().astype(int)):
        terms = _pressure(both, radius[i], load[i], left[i], depth[i])
        most = np.maximum(most, _stresses(body, radius[i], *terms, layers=layers, count=len(stresses)))
    given = (stresses[i] for i in layers)
    return tuple(LayerYield(i, y, float(s / y), error) for i, s, (y, error) in zip(layers, most, given, strict=True))


def _pressure(medium: Any, radius: float, force: float, left: float, depth: float) -> tuple[float, float]:
    """Uniform and Hertz's part of the pressure at the largest force; uniform where the residual depth does not give them."""
    with silence():
        try:
            made = Imprint(medium, radius, force, left, depth)
            return made.uniform, made.hertz
        except (InvalidArgumentError, DomainError, ArgumentTypeError):
            return float(force / (math.pi * radius**2)), 0.0


def _stresses(body: Any, radius: float, uniform: float, hertz: float, *, layers: list[int], count: int) -> Array:
    """Largest von Mises stress under a pressure, of some layers out of `count`."""
    rigid = _NO_YIELD * (uniform + abs(hertz))
    try:
        made = Imprint.from_two_terms(body, radius, uniform, hertz)
    except DomainError:
        # the contact would end in a ring: Hertz's pressure has the same force
        made = Imprint.from_two_terms(body, radius, 0.0, 1.5 * uniform + hertz)
    found = []
    for i in layers:
        limits = np.full(count, math.inf)
        limits[i] = rigid
        found.append(made.reverse_yield(limits).ratio * rigid)
    return np.array(found)


def warning_of(found: tuple[LayerYield, ...]) -> list[str]:
    """Return the text of a warning about unloading that yields again."""
    worst = max(found, key=lambda one: one.ratio, default=None)
    if worst is None or worst.ratio <= ELASTIC:
        return []
    force, left = ("2.5 %", "2 %") if worst.ratio <= LARGEST else ("17 %", "24 %")
    return [
        f"R_Y = {ratio_words(worst)} in layer {worst.layer}: unloading yields again. In finite elements the force on unloading "
        f"then has an error of up to {force} of the largest one, and the residual depth of up to {left} of the depth"
    ]


def refuse(found: tuple[LayerYield, ...], has_area: bool) -> None:
    """Raise an error for contact radii that no contact depth gives; a measured area gives them."""
    worst = max(found, key=lambda one: one.ratio, default=None)
    if worst is None or worst.ratio <= LARGEST or has_area:
        return
    raise DomainError(
        f"yield_stresses[{worst.layer}] = {worst.yield_stress:.4g}: R_Y = {ratio_words(worst)} exceeds 3, so the body yields again "
        "while it unloads. In finite elements of a stiff film on a soft body the contact radius from the contact depth is then 34 "
        "to 43 % too large, and the modulus wrong by as much. Measure the contact area and give area_factor a prior, or fit "
        "shallower indents."
    )
