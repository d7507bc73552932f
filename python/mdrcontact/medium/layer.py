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
    """Interface between two layers: springs and an area resistance.

    Parameters
    ----------
    resistance : float, optional
        Area resistance to heat or current, >= 0, as the Kapitza resistance or that of an oxide [length^2/conductance].
    normal : float, optional
        K_n, stiffness per area across the interface, > 0, as C33/thickness of an adhesive layer [modulus/length]. None, the
        default, is a bond.
    tangential : float, optional
        K_t, stiffness per area along the interface, >= 0, as C44/thickness [modulus/length]. 0 slides without friction. None, the
        default, is a bond.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> film, base = mdr.Elastic(200e9, 0.3), mdr.Elastic(200e9, 0.3)
    >>> glued = mdr.Layered([mdr.Layer(film, 1e-6, interface=mdr.Interface(normal=1e17))], base)
    >>> sliding = mdr.Layered([mdr.Layer(film, 1e-6, interface=mdr.SLIDING)], base)
    >>> print(f"{glued.modulus(2e-6):.4e} {sliding.modulus(2e-6):.4e}")
    1.6911e+11 1.8927e+11
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
                raise InvalidArgumentError(f"{name} = {value!r}: a spring's stiffness must be {least}")
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
    """Layer of a `Layered` body; it unpacks as the pair (material, thickness).

    Parameters
    ----------
    material : Elastic, TransverselyIsotropic, Viscoelastic or PowerLawRheology
        Material of the layer. A layer with a prestress must be elastic. Its constants are then the tangent moduli of the stressed
        state; those of the stress-free state cause an error of the order of prestress over modulus.
    thickness : float
        Thickness > 0 [length].
    prestress : float, optional
        Equibiaxial stress in the plane of the layer, positive in tension [modulus].
    interface : Interface, optional
        Interface to the body below. None, the default, is a perfect bond.

    Raises
    ------
    ArgumentTypeError
        The material is not a material, or the interface is not an `Interface`.
    InvalidArgumentError
        A viscoelastic layer has a prestress.

    Examples
    --------
    >>> film = mdr.Layer(mdr.Elastic(200e9, 0.3), 1e-6, prestress=-1e9)
    >>> body = mdr.Layered([film], mdr.Elastic(2e9, 0.4))
    >>> print(f"{body.modulus(5e-6):.4e} {body.wrinkling().stress:.3e}")
    3.2998e+09 -5.858e+09
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
            raise ArgumentTypeError(f"interface = {self.interface!r}: {words}")
        if self.prestress and not isinstance(self.material, (Elastic, TransverselyIsotropic)):
            raise InvalidArgumentError("prestress: it must be 0 in a viscoelastic layer")

    def __iter__(self) -> Iterator[Any]:
        return iter((self.material, self.thickness))

    def _is_plain(self) -> bool:
        return not self.prestress and self.interface in (None, Interface())


class Wrinkling(NamedTuple):
    """Compression at which the surface of a body wrinkles, from `Layered.wrinkling`.

    Examples
    --------
    >>> body = mdr.Layered([(mdr.Elastic(1e9, 0.3), 1e-6)], mdr.Elastic(1e6, 0.3))
    >>> found = body.wrinkling()
    >>> print(f"{found.stress:.4e} {found.wavelength:.4e}")
    -6.2089e+06 4.2154e-05
    """

    stress: float
    """stress of the layer, negative because it is a compression [modulus]"""
    wavelength: float
    """wavelength of the wrinkles [length]"""


def stack(layers: Sequence[Layer], substrate: Any, surface: Surface | None = None) -> Handle:
    """The library's body of layers of any kind from top to bottom."""
    rows, base = _structures(layers, substrate)
    return Handle(native.body_layered(len(layers), rows, base, structure_of(surface)))


def _structures(layers: Sequence[Layer], substrate: Any) -> tuple[Record, Record | None]:
    """Structures mdr_layer of the layers, and of the half-space."""
    rows = []
    for layer in layers:
        below = layer.interface
        if substrate is SMOOTH and layer is layers[-1]:
            if below is not None:
                raise InvalidArgumentError("an interface above a SMOOTH base: the base already slides. Omit the interface")
            below = SLIDING
        springs = {} if below is None else below._layer()
        rows.append({**layer.material._layer(), "thickness": layer.thickness, "prestress": layer.prestress, **springs})
    base = None if substrate is RIGID or substrate is SMOOTH else record(_layout.layer, **substrate._layer())
    return records(_layout.layer, rows), base
