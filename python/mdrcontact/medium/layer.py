# SPDX-License-Identifier: GPL-3.0-or-later
"""A layer of a body, what lies below it, and the body of layers of any kind."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, Final, NamedTuple

import numpy as np

from .. import _layout
from .._boundary import Handle, Record, native, number, record, records
from .._parameters import WithParameters
from .._units import LENGTH, MODULUS, MODULUS_PER_LENGTH
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import RIGID, SMOOTH, Elastic, Material, TransverselyIsotropic, check_rows, material
from .surface import Surface, structure_of


@dataclass(frozen=True)
class Interface(WithParameters):
    """What lies between two layers.

    resistance : area resistance >= 0: Kapitza resistance, an oxide [length^2/conductance]
    normal : K_n > 0 of springs per area across it, a glue line of C33/thickness; None: bonded [modulus/length]
    tangential : K_t >= 0 along it, C44/thickness; 0: it slides without friction (`SLIDING`); None: bonded [modulus/length]
    """

    resistance: float = 0.0
    normal: float | None = field(default=None, metadata={"dimension": MODULUS_PER_LENGTH})
    tangential: float | None = field(default=None, metadata={"dimension": MODULUS_PER_LENGTH})

    def __post_init__(self) -> None:
        self._set(resistance=number("resistance", self.resistance))
        check_rows(np.array([(1.0, 1.0, 1.0, 0.0, self.resistance)]))
        for name, least in (("normal", "> 0"), ("tangential", ">= 0")):
            value = getattr(self, name)
            if value is None:
                continue
            value = number(name, value)
            if not value >= 0.0 or (name == "normal" and value == 0.0):
                raise InvalidArgumentError(f"{name} = {value!r} is not allowed: a spring's stiffness must be {least}")
            self._set(**{name: value})

    def _layer(self) -> dict[str, float]:
        """Members of struct mdr_layer: compliances."""
        normal, tangential = self.normal, self.tangential
        return {
            "normal_compliance": 0.0 if normal is None else 1.0 / normal,
            "tangential_compliance": 0.0 if tangential is None else 1.0 / tangential if tangential else math.inf,
        }


SLIDING: Final = Interface(tangential=0.0)
"""An interface that slides without friction and does not open."""


@dataclass(frozen=True)
class Layer(WithParameters):
    """A layer of a `Layered` body. It unpacks as the pair (material, thickness).

    material : Elastic(E, nu) or TransverselyIsotropic(...); where there is no prestress any material
    thickness : > 0 [length]
    prestress : equibiaxial stress in its plane, tension > 0 [modulus]. The material's constants are the tangent moduli of the
        stressed state; with those of the free state the error is of the order prestress/modulus
    interface : between it and what lies below, Interface(normal=K_n, tangential=K_t) or SLIDING, and its resistance to flux;
        None: bonded

    docs/coatings.md
    """

    material: Material
    thickness: float = field(metadata={"dimension": LENGTH})
    prestress: float = field(default=0.0, metadata={"dimension": MODULUS})
    interface: Interface | None = None

    def __post_init__(self) -> None:
        self._set(material=material("material", self.material), thickness=number("thickness", self.thickness))
        self._set(prestress=number("prestress", self.prestress))
        if self.interface is not None and not isinstance(self.interface, Interface):
            words = "it must be an Interface(normal=..., tangential=...), SLIDING or None"
            raise ArgumentTypeError(f"interface = {self.interface!r} is not allowed: {words}")
        if self.prestress and not isinstance(self.material, (Elastic, TransverselyIsotropic)):
            raise InvalidArgumentError("a layer that relaxes is not allowed to have a prestress")

    def __iter__(self) -> Iterator[Any]:
        return iter((self.material, self.thickness))

    def _is_plain(self) -> bool:
        return not self.prestress and self.interface in (None, Interface())


class Wrinkling(NamedTuple):
    """Where the surface of a body wrinkles."""

    stress: float
    """of the layer, < 0: compression [modulus]"""
    wavelength: float
    """of the wrinkles [length]"""


def stack(layers: Sequence[Layer], substrate: Any, surface: Surface | None = None) -> Handle:
    """The library's body of layers of any kind from the surface down."""
    rows, base = _structures(layers, substrate)
    return Handle(native.body_layered(len(layers), rows, base, structure_of(surface)))


def _structures(layers: Sequence[Layer], substrate: Any) -> tuple[Record, Record | None]:
    """Structures mdr_layer of the layers, and of the half-space."""
    rows = []
    for layer in layers:
        below = layer.interface
        if substrate is SMOOTH and layer is layers[-1]:
            if below is not None:
                raise InvalidArgumentError("an interface above a SMOOTH base is not allowed: the base slides by itself")
            below = SLIDING
        springs = {} if below is None else below._layer()
        rows.append({**layer.material._layer(), "thickness": layer.thickness, "prestress": layer.prestress, **springs})
    base = None if substrate is RIGID or substrate is SMOOTH else record(_layout.layer, **substrate._layer())
    return records(_layout.layer, rows), base
