# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that conduct: stacks of conductors, and elastic bodies with conductors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import ComplexOrArray, FloatOrArray, Handle, complex_of, native, number, of_waves
from .._value import Named, Value
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Conductor, check_rows
from ..medium.layer import Interface


class _Base(Named):
    """Base below layers that is not a half-space."""

    def __init__(self, name: str, number: int) -> None:
        super().__init__(name)
        self._code = number


PERFECT: Final = _Base("PERFECT", _layout.BASE_PERFECT)
"""A perfect conductor at potential 0 below all layers."""
INSULATING: Final = _Base("INSULATING", _layout.BASE_INSULATING)
"""No flux below all layers: a body with a transient response, and with a sink also a steady one."""


@dataclass(frozen=True)
class LayeredConductor(Value):
    """Body of layers that conduct.

    Parameters
    ----------
    layers : sequence
        Pairs (Conductor, thickness > 0 [length]) from top to bottom. An `Interface(resistance)` may be between two pairs, and above
        the substrate.
    substrate : Conductor, PERFECT or INSULATING
        Body below the layers.

    Raises
    ------
    ArgumentTypeError
        A layer or the substrate is of another type.
    InvalidArgumentError
        A thickness is not greater than 0, or an interface is at the wrong place or has springs.

    Examples
    --------
    >>> gold, steel = mdr.conduction.Conductor(300.0), mdr.conduction.Conductor(15.0)
    >>> plated = mdr.conduction.LayeredConductor([(gold, 1e-6)], steel)
    >>> print(f"{mdr.conduction.Conduction(plated).at_radius(1e-6).conductance:.4e}")
    4.9782e-04
    >>> cooled = mdr.conduction.LayeredConductor([(steel, 1e-6)], mdr.conduction.PERFECT)
    >>> print(f"{mdr.conduction.Conduction(cooled).at_radius(1e-6).conductance:.4e}")
    9.5747e-05
    """

    layers: tuple[Any, ...]
    substrate: Conductor | _Base

    def __post_init__(self) -> None:
        self._set(layers=tuple(layer if isinstance(layer, Interface) else tuple(layer) for layer in self.layers))
        rows, base = self.rows()
        if base == _layout.BASE_HALF_SPACE:
            rows[-1, 0] = 1.0
        check_rows(rows)

    def _with_resistances(self, resistances: Sequence[float]) -> LayeredConductor:
        """Return the same body with further area resistances below its layers, from top to bottom."""
        layers = [layer for layer in self.layers if not isinstance(layer, Interface)]
        further = [*resistances, *[0.0] * (len(layers) - len(resistances))]
        own = self.rows()[0][: len(layers), 4]
        below = [Interface(float(first) + second) for first, second in zip(own, further, strict=True)]
        return self.replace(layers=[part for pair in zip(layers, below, strict=True) for part in pair])

    def rows(self) -> tuple[NDArray[np.float64], int]:
        """Return the layers as rows of struct mdr_conductor, and the code of the base.

        Returns
        -------
        tuple
            Array of thickness [length], conductivities into the body and along it [conductance/length], capacity and resistance
            below each layer; and the code of the base.
        """
        rows: list[list[float]] = []
        for layer in self.layers:
            if isinstance(layer, Interface):
                if not rows or rows[-1][4]:
                    raise InvalidArgumentError("Interface: it must follow a layer, at most one for each layer")
                if layer.normal is not None or layer.tangential is not None:
                    raise InvalidArgumentError(
                        f"{layer!r}: normal and tangential are springs of elastic layers; give a resistance alone"
                    )
                rows[-1][4] = layer.resistance
            elif len(layer) == 2 and isinstance(layer[0], Conductor):
                rows.append(list(layer[0]._row(number("thickness", layer[1]))))
            else:
                raise ArgumentTypeError(f"{layer!r}: it must be (Conductor, thickness) or an Interface")
        if isinstance(self.substrate, Conductor):
            rows.append(list(self.substrate._row()))
            return np.array(rows), _layout.BASE_HALF_SPACE
        if not isinstance(self.substrate, _Base):
            raise ArgumentTypeError(f"substrate = {self.substrate!r}: it must be a Conductor, PERFECT or INSULATING")
        return np.array(rows).reshape(-1, 5), self.substrate._code


def _conductor(material: Any) -> Conductor:
    """Return the conductor of a material of an elastic body."""
    found = material if isinstance(material, Conductor) else getattr(material, "conductor", None)
    if not isinstance(found, Conductor):
        raise ArgumentTypeError(f"{material!r} has no conductivity: give Elastic(E, nu, conductor=Conductor(...))")
    return found


def _parts(layer: Any) -> Iterator[Any]:
    """The conductor of a layer of an elastic body, and the interface below it."""
    material, thickness = layer
    yield _conductor(material), thickness
    if layer.interface is not None:
        yield Interface(layer.interface.resistance)


def conducting(body: Any) -> LayeredConductor:
    """A conductor, a stack of them, or the conductors of an elastic body."""
    if isinstance(body, LayeredConductor):
        return body
    if isinstance(body, Conductor):
        return LayeredConductor((), body)
    if hasattr(body, "material"):
        return LayeredConductor((), _conductor(body.material))
    if hasattr(body, "substrate"):
        return LayeredConductor(tuple(part for layer in body._stack() for part in _parts(layer)), _conductor(body.substrate))
    raise ArgumentTypeError(f"{body!r}: it must be a Conductor, a LayeredConductor or an elastic body of materials "
                            "with conductors")  # fmt: skip


def _bodies(body: Any, other: Any) -> tuple[LayeredConductor, LayeredConductor | None]:
    """Both sides: a `Pair` has two."""
    if hasattr(body, "lower") and hasattr(body, "upper"):
        if other is not None:
            raise ArgumentTypeError("other: a Pair already has two bodies. Omit it")
        return conducting(body.lower), conducting(body.upper)
    return conducting(body), None if other is None else conducting(other)


def conduction_of(body: Any, other: Any = None, film: float = 0.0, sink: float = 0.0) -> Handle:
    """The library's object of one or two bodies, see `Conduction`."""
    first, second = _bodies(body, other)
    lower, lower_base = first.rows()
    upper, upper_base = (None, 0) if second is None else second.rows()
    count = 0 if upper is None else len(upper)
    return Handle(native.conduction_new(lower, lower_base, count, upper, upper_base, film, sink))


def flux_compliance(conduction: Handle, k: ArrayLike, omega: ArrayLike) -> FloatOrArray | ComplexOrArray:
    """See `Conduction.compliance`."""
    real, imaginary = of_waves(k, omega, partial(native.conduction_compliance, conduction))
    return complex_of(real, imaginary) if np.any(omega) else real
