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
    """Half-space below any number of layers.

    Parameters
    ----------
    layers : iterable of (material, thickness) or Layer
        Layers from top to bottom, at least one; thickness > 0 [length]. A pair is a bonded layer without stress. A `Layer` can have
        a prestress and an interface below it.
    substrate : Elastic, TransverselyIsotropic, Viscoelastic, PowerLawRheology, RIGID or SMOOTH
        Material below the layers. RIGID and SMOOTH need the model "exact".
    model : {"exact", "gao", "gao-series", "gao-power"}, optional
        How E_eff(a) is computed; options as in `Coated`.
    surface : Surface, optional
        Tension, plate or membrane on elastic materials under the model "exact". None, the default, is a bare surface.
    **options
        Options of the model, as in `Coated`.

    Raises
    ------
    ArgumentTypeError
        A layer is neither a `Layer` nor a pair, or the substrate is not a material.
    InvalidArgumentError
        There are no layers, a thickness is not greater than 0, or the model does not support the body.

    References
    ----------
    popov-2014, section 3
    gao-1992

    Examples
    --------
    >>> nitride, chromium, steel = mdr.Elastic(445e9, 0.25), mdr.Elastic(279e9, 0.21), mdr.Elastic(210e9, 0.3)
    >>> stack = mdr.Layered([(nitride, 1e-6), (chromium, 0.1e-6)], steel)
    >>> print(f"{stack.modulus(2e-6):.4e}")
    2.7225e+11
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
        """Return the compression of one layer at which the surface wrinkles.

        All other layers stay as they are. The prestress of the layer itself is not used.

        Parameters
        ----------
        layer : int, optional
            Number of the layer from top to bottom, 0 is the first.

        Returns
        -------
        Wrinkling
            `stress` < 0 [modulus] and `wavelength` [length].

        Raises
        ------
        UnreachableError
            A constant of the layer or the stiffness of its surface vanishes at a smaller compression, so that there is no
            wavelength.

        References
        ----------
        allen-1969
        chen-2004
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
            raise ArgumentTypeError(f"layer {i} = {layer!r}: {words}") from problem
        stack.append((material(f"material of layer {i}", body), number(f"thickness of layer {i}", thickness)))
    if not stack:
        raise InvalidArgumentError("layers: it is empty; a body without layers is Homogeneous(material)")
    return tuple(stack)
