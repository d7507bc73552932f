# SPDX-License-Identifier: GPL-3.0-or-later
"""Stacks of layers (theory 3 and 6)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .. import _native
from .._boundary import number
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Elastic, _Rigid
from .coated import base
from .homogeneous import elastic
from .models import UnderModel, settings


@dataclass(frozen=True, repr=False)
class Layered(UnderModel):
    """A half-space under any number of bonded layers.

    layers : [(material, thickness), ...] from the surface down; material an Elastic(E, nu), thickness > 0 [length]
    substrate : Elastic(E, nu); RIGID for the model "exact"
    model : "exact" (default), "gao", "gao-series" or "gao-power"; options as for `Coated`
    """

    layers: tuple[tuple[Elastic, float], ...]
    substrate: Elastic | _Rigid
    model: str
    options: tuple[tuple[str, float | str], ...]

    def __init__(
        self,
        layers: Iterable[tuple[Elastic, float]],
        substrate: Elastic | _Rigid,
        model: str = "exact",
        **options: float | str,
    ) -> None:
        stack, chosen = _stack(layers), settings(model, options, layers=True)
        E, nu, h = [m.E for m, _ in stack], [m.nu for m, _ in stack], [t for _, t in stack]
        created = _native.medium_layered(E, nu, h, *base(substrate), *chosen.native)
        self._own_with(created, chosen.given, layers=stack, substrate=substrate, model=model)


def _stack(layers: Iterable[tuple[Elastic, float]]) -> tuple[tuple[Elastic, float], ...]:
    stack = []
    for i, layer in enumerate(layers, start=1):
        try:
            material, thickness = layer
        except (TypeError, ValueError) as problem:
            raise ArgumentTypeError(f"layer {i} = {layer!r} is not allowed: it must be a pair (material, thickness)") from problem
        stack.append((elastic(f"material of layer {i}", material), number(f"thickness of layer {i}", thickness)))
    if not stack:
        raise InvalidArgumentError("layers is not allowed: it is empty; a body without layers is Homogeneous(material)")
    return tuple(stack)
