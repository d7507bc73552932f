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
        raise ArgumentTypeError(f"{name} = {value!r} is not allowed: it must be an Elastic(E, nu)")
    return value


@dataclass(frozen=True, repr=False)
class Homogeneous(Medium):
    """A homogeneous half-space of one material: Elastic(E, nu), TransverselyIsotropic(...), Viscoelastic(...),
    PowerLawRheology(...) or Poroelastic(...). The indenter is rigid; for a deformable one see `Pair`. A contact with a viscoelastic
    or poroelastic body answers in time only.

    surface : Surface(tension, bending) of an elastic body, None for a bare one
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
