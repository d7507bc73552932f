# SPDX-License-Identifier: GPL-3.0-or-later
"""Laterally heterogeneous media: inclusions, fibres, grains, and maps of them.

    from mdrcontact import Elastic, lateral

    matrix, glass = Elastic(3e9, 0.35), Elastic(70e9, 0.22)
    composite = lateral.Shapes(matrix, [lateral.Ball((0, 0, 8e-6), 5e-6, glass)])
    composite.modulus(0.0, 0.0, [1e-6, 1e-5])           # E_eff(a, x, y) at two contact radii
    medium = lateral.LateralMedium(composite, 0.0, 0.0, 1e-8, 1e-4)

The moduli are averaged to first order in their contrast, as Gao's weights do for layers; `structure.bounds()` gives bounds of E_eff
at any contrast. Maps of voxel arrays by FFT need SciPy.
"""

from .field import Field
from .mapping import effective_map, map_memory, tiled_map, weight_beyond
from .medium import LateralMedium
from .shapes import Ball, Box, Fibre, HalfSpace, Layer, Pillar, Shapes
from .sliding import IndentationMap, Sliding, indentation_map, slide
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
    "IndentationMap",
    "indentation_map",
    "slide",
    "Sliding",
    "density",
    "cell_weights",
]
