# SPDX-License-Identifier: GPL-3.0-or-later
"""Stacks of layers (theory/paper.md (3.6), theory/exact.md (1.2))."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from .._boundary import call, native, number, whole
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Material, _Rigid, material
from .coated import substrate_material
from .layer import Layer, Wrinkling, stack
from .models import UnderModel, settings
from .surface import Surface, given_surface
from .viscoelastic import is_elastic


@dataclass(frozen=True, repr=False)
class Layered(UnderModel):
    """A half-space under any number of layers.

    layers : [(material, thickness), ...] from the surface down, bonded; material an Elastic(E, nu), TransverselyIsotropic(...),
        Viscoelastic(...) or PowerLawRheology(...), thickness > 0 [length]; or Layer(material, thickness, prestress, interface),
        with a stress in its plane, or springs or sliding below it
    substrate : likewise a material; RIGID, or SMOOTH without friction, for the model "exact"
    model : "exact" (default), "gao", "gao-series" or "gao-power"; options as for `Coated`
    surface : Surface(tension, bending) of elastic materials under the model "exact", None for a bare one
    """

    layers: tuple[Layer | tuple[Material, float], ...]
    substrate: Material | _Rigid
    model: str
    options: tuple[tuple[str, float | str], ...]
    surface: Surface | None

    def __init__(
        self,
        layers: Iterable[Layer | tuple[Material, float]],
        substrate: Material | _Rigid,
        model: str = "exact",
        *,
        surface: Surface | None = None,
        **options: float | str,
    ) -> None:
        given = _layers(layers)
        elastic = is_elastic(*(layer.material if isinstance(layer, Layer) else layer[0] for layer in given), substrate)
        surface = given_surface(surface, elastic=elastic)
        chosen = settings(model, options, layers=True)
        below = substrate_material(substrate)
        body = stack([_as_layer(layer) for layer in given], below, surface)
        self._own_with(body, chosen, layers=given, substrate=substrate, model=model, surface=surface)

    def _stack(self) -> tuple[Any, ...]:
        return tuple(map(_as_layer, self.layers))

    def _with_materials(
        self, layer: Callable[[Any], Any], substrate: Callable[[Any], Any], interface: Callable[[Any], Any] | None = None
    ) -> Layered:
        layers = [part.replace(material=layer(part.material)) for part in map(_as_layer, self.layers)]
        if interface is not None:
            layers = [part.replace(interface=interface(part.interface)) for part in layers]
        return self.replace(layers=layers, substrate=substrate(self.substrate))

    def _with_thinner_coating(self, lost: float) -> Layered:
        first, *below = map(_as_layer, self.layers)
        return self.replace(layers=[first.replace(thickness=first.thickness - lost), *below])

    def _constants(self) -> dict[str, Any]:
        return {**super()._constants(), "layers": tuple(map(_as_layer, self.layers))}

    def _rebuilt(self, constants: dict[str, Any]) -> Layered:
        pairs = [isinstance(old, tuple) and new._is_plain() for old, new in zip(self.layers, constants["layers"], strict=True)]
        layers = [tuple(new) if pair else new for pair, new in zip(pairs, constants.pop("layers"), strict=True)]
        return super()._rebuilt({**constants, "layers": layers})

    def wrinkling(self, layer: int = 0) -> Wrinkling:
        """The compression of one layer at which the surface wrinkles, and the wavelength: `.stress` < 0 [modulus] and `.wavelength`
        [length]. All else stays as it is; the layer's own prestress is not used. Refused (UnreachableError) where a constant of the
        layer or the stiffness of its surface vanishes first: then there is no wavelength. docs/coatings.md

        layer : number of the layer from the surface down, 0 the first
        """
        (body,) = self._bodies()
        return Wrinkling(*call(native.body_wrinkling, body, whole("layer", layer, 0, len(self.layers) - 1) + 1))


def _as_layer(part: Layer | tuple[Material, float]) -> Layer:
    return part if isinstance(part, Layer) else Layer(*part)


def _layers(layers: Iterable[Layer | tuple[Material, float]]) -> tuple[Layer | tuple[Material, float], ...]:
    stack: list[Layer | tuple[Material, float]] = []
    for i, layer in enumerate(layers, start=1):
        if isinstance(layer, Layer):
            stack.append(layer)
            continue
        try:
            body, thickness = layer
        except (TypeError, ValueError) as problem:
            words = "it must be a Layer or a pair (material, thickness)"
            raise ArgumentTypeError(f"layer {i} = {layer!r} is not allowed: {words}") from problem
        stack.append((material(f"material of layer {i}", body), number(f"thickness of layer {i}", thickness)))
    if not stack:
        raise InvalidArgumentError("layers is not allowed: it is empty; a body without layers is Homogeneous(material)")
    return tuple(stack)
