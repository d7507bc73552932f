# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies one of whose materials is viscoelastic."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .. import _layout, _native
from .._boundary import address
from ..errors import InvalidArgumentError
from ..material import SMOOTH, Elastic, Material, TransverselyIsotropic, _Rigid


def is_elastic(*materials: object) -> bool:
    """Whether none of the materials relaxes."""
    return all(isinstance(material, (Elastic, TransverselyIsotropic, _Rigid)) for material in materials)


def is_viscoelastic(medium: object) -> bool:
    """Whether the states of a medium depend on time."""
    parts = [getattr(medium, name) for name in ("material", "coating", "substrate") if hasattr(medium, name)]
    return not is_elastic(*parts, *(layer for layer, _ in getattr(medium, "layers", ())))


def viscoelastic(
    layers: Sequence[Material],
    thicknesses: Sequence[float],
    substrate: Material | _Rigid,
    model: tuple[int, int] = (_layout.MODEL_EXACT, 0),
) -> tuple[int, int]:
    """What the library's constructor returns for layers from the surface down on a substrate."""
    handles: list[Any] = [material._rheology() for material in layers]
    places = np.array([handle.address for handle in handles], np.uintp)
    if substrate is SMOOTH:
        raise InvalidArgumentError("substrate = SMOOTH is not allowed below a layer that relaxes: only RIGID is")
    base = None if isinstance(substrate, _Rigid) else substrate._rheology()
    thickness = np.array(thicknesses, np.float64)
    below = 0 if base is None else base.address
    created: tuple[int, int] = _native.medium_viscoelastic(len(handles), address(places), address(thickness), below, *model)
    return created
