# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies one of whose materials is viscoelastic."""

from __future__ import annotations

from ..material import Elastic, TransverselyIsotropic, _Rigid


def is_elastic(*materials: object) -> bool:
    """Return whether none of the materials relaxes."""
    return all(isinstance(material, (Elastic, TransverselyIsotropic, _Rigid)) for material in materials)


def is_viscoelastic(medium: object) -> bool:
    """Return whether the states of a medium depend on time."""
    parts = [getattr(medium, name) for name in ("material", "coating", "substrate") if hasattr(medium, name)]
    return not is_elastic(*parts, *(layer for layer, _ in getattr(medium, "layers", ())))
