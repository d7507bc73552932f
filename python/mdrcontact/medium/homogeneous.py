# SPDX-License-Identifier: GPL-3.0-or-later
"""The homogeneous half-space (theory/paper.md (2.1))."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ..errors import ArgumentTypeError
from ..material import Elastic, Material, material
from ..poroelastic import NoElasticStates, Poroelastic
from .base import Medium
from .layer import stack
from .models import settings
from .surface import Surface, given_surface
from .viscoelastic import is_elastic


def elastic(name: str, value: object) -> Elastic:
    """`value` if it is an elastic material; an exception if it is anything else."""
    if not isinstance(value, Elastic):
        raise ArgumentTypeError(f"{name} = {value!r}: it must be an Elastic(E, nu)")
    return value


@dataclass(frozen=True, repr=False)
class Homogeneous(Medium):
    """Homogeneous half-space of one material.

    Parameters
    ----------
    material : Elastic, TransverselyIsotropic, Viscoelastic, PowerLawRheology or Poroelastic
        The material. A contact with a viscoelastic or poroelastic body has histories in time and no states.
    surface : Surface, optional
        Tension, plate or membrane on an elastic body. None, the default, is a bare surface.

    Raises
    ------
    ArgumentTypeError
        `material` is not a material, or `surface` is not a `Surface`.
    InvalidArgumentError
        A surface is given and the material is not elastic.

    Notes
    -----
    The indenter is rigid. For a deformable indenter use `Pair`.

    Examples
    --------
    >>> glass = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> print(f"{glass.modulus(1e-6):.4e}")
    7.4143e+10
    """

    material: Material | Poroelastic
    surface: Surface | None = None

    def __post_init__(self) -> None:
        if isinstance(self.material, Poroelastic):
            self._set(_handle=NoElasticStates(), surface=given_surface(self.surface, elastic=False))
            return
        body = material("material", self.material)
        surface = given_surface(self.surface, elastic=is_elastic(body))
        half_space = stack([], body, surface)
        self._own(settings("exact", {}).medium_of(half_space), half_space, surface=surface)

    def _with_materials(
        self, layer: Callable[[Any], Any], substrate: Callable[[Any], Any], interface: Callable[[Any], Any] | None = None
    ) -> Homogeneous:
        return self.replace(material=substrate(self.material))
