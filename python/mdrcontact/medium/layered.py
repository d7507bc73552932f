# SPDX-License-Identifier: GPL-3.0-or-later
"""Stacks of layers (theory 3 and 6)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from .. import _native
from .._boundary import number
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Material, _Rigid, material
from .coated import base, substrate_material
from .models import UnderModel, settings
from .viscoelastic import is_elastic, viscoelastic


@dataclass(frozen=True, repr=False)
class Layered(UnderModel):
    """A half-space under any number of bonded layers.

    layers : [(material, thickness), ...] from the surface down; material an Elastic(E, nu), Viscoelastic(...) or
        PowerLawRheology(...), thickness > 0 [length]
    substrate : likewise a material; RIGID for the model "exact"
    model : "exact" (default), "gao", "gao-series" or "gao-power"; options as for `Coated`
    """

    layers: tuple[tuple[Material, float], ...]
    substrate: Material | _Rigid
    model: str
    options: tuple[tuple[str, float | str], ...]

    def __init__(
        self,
        layers: Iterable[tuple[Material, float]],
        substrate: Material | _Rigid,
        model: str = "exact",
        **options: float | str,
    ) -> None:
        stack, chosen = _stack(layers), settings(model, options, layers=True)
        below = substrate_material(substrate)
        materials: list[Any] = [m for m, _ in stack]
        h = [t for _, t in stack]
        if is_elastic(*materials, below):
            E, nu = [m.E for m in materials], [m.nu for m in materials]
            created = _native.medium_layered(E, nu, h, *base(below), *chosen.native)
        else:
            created = viscoelastic(materials, h, below, chosen.native)
        self._own_with(created, chosen.given, layers=stack, substrate=substrate, model=model)


def _stack(layers: Iterable[tuple[Material, float]]) -> tuple[tuple[Material, float], ...]:
    stack = []
    for i, layer in enumerate(layers, start=1):
        try:
            body, thickness = layer
        except (TypeError, ValueError) as problem:
            raise ArgumentTypeError(f"layer {i} = {layer!r} is not allowed: it must be a pair (material, thickness)") from problem
        stack.append((material(f"material of layer {i}", body), number(f"thickness of layer {i}", thickness)))
    if not stack:
        raise InvalidArgumentError("layers is not allowed: it is empty; a body without layers is Homogeneous(material)")
    return tuple(stack)
