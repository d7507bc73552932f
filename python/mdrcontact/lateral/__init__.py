# SPDX-License-Identifier: GPL-3.0-or-later
"""Laterally heterogeneous media: inclusions, fibres, grains, and the map a virtual indenter sees (theory/lateral.md (1.1)).

    from mdrcontact import Elastic, lateral

    matrix, glass = Elastic(3e9, 0.35), Elastic(70e9, 0.22)
    composite = lateral.Shapes(matrix, [lateral.Ball((0, 0, 8e-6), 5e-6, glass)])
    composite.modulus(0.0, 0.0, [1e-6, 1e-5])           # E_eff(a, x, y) at two contact radii
    medium = lateral.LateralMedium(composite, 0.0, 0.0, 1e-8, 1e-4)

To first order in the contrast of the moduli, as the Gao weights are for layers; structure.bounds() brackets E_eff
beyond. Maps of voxel arrays by FFT need SciPy.
"""

from .field import Field
from .mapping import effective_map, map_memory, tiled_map, weight_beyond
from .medium import LateralMedium
from .shapes import Ball, Box, Fibre, HalfSpace, Layer, Pillar, Shapes
from .sliding import Sliding, indentation_map, slide
from .structure import Bounds, Structure
from .voxels import Voxels
from .weights import cell_weights, density

__all__ = [
    "Structure",
    "Bounds",
    "Shapes",
    "Ball",
    "Box",
    "Fibre",
    "HalfSpace",
    "Layer",
    "Pillar",
    "Voxels",
    "Field",
    "LateralMedium",
    "effective_map",
    "map_memory",
    "tiled_map",
    "weight_beyond",
    "indentation_map",
    "slide",
    "Sliding",
    "density",
    "cell_weights",
]
