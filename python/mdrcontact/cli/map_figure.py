# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of the command `map`: the structure from above and in section, and a map for each contact radius."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .._units import LENGTH, MODULUS, practical
from ..studies.map import MapResult
from .figures import COLOURS, sheet


def map_figure(found: MapResult) -> Any:
    """Structure and maps, each map with the contact drawn to scale."""
    from matplotlib.patches import Circle

    voxels, radii, maps = found.problem.voxels, found.problem.radii, found.maps
    nz, ny, nx = voxels.labels.shape
    dz, dy, dx = voxels.spacing
    length = practical(LENGTH, [max(nx * dx, ny * dy)])
    modulus = practical(MODULUS, [float(np.max(maps))])
    left, low = (float(length.of(v)) for v in voxels.origin)
    right, high = left + float(length.of(nx * dx)), low + float(length.of(ny * dy))
    deep = float(length.of(nz * dz))
    panels = 2 + len(radii)
    columns = min(3, panels)
    rows = math.ceil(panels / columns)
    with sheet(found.title, rows, columns, (4.0 * columns, 3.7 * rows)) as (figure, panes):
        axes = np.ravel(panes)
        for axis in axes[panels:]:
            axis.set_axis_off()
        E = np.array([material.contact_modulus for material in voxels.phases])
        scale = {"cmap": "cividis", "vmin": float(modulus.of(E.min())), "vmax": float(modulus.of(E.max()))}
        surface = modulus.of(E[np.asarray(voxels.labels[0])])
        axes[0].imshow(surface, origin="lower", extent=(left, right, low, high), interpolation="nearest", **scale)
        axes[0].set_title("structure at the surface")
        section = modulus.of(E[np.asarray(voxels.labels[:, ny // 2, :])])
        picture = axes[1].imshow(section, origin="upper", extent=(left, right, deep, 0.0), interpolation="nearest", **scale)
        axes[1].set_title("structure below the middle line")
        axes[0].axhline(0.5 * (low + high), color=COLOURS[1], linewidth=0.8)
        figure.colorbar(picture, ax=axes[1], label=f"E* of the phase [{modulus.symbol}]", shrink=0.8)
        for axis, a, values in zip(axes[2:panels], radii, maps, strict=True):
            picture = axis.imshow(modulus.of(values), origin="lower", extent=(left, right, low, high), cmap="cividis")
            figure.colorbar(picture, ax=axis, label=rf"$E_\mathrm{{eff}}$ [{modulus.symbol}]", shrink=0.8)
            shown = float(length.of(a))
            axis.add_patch(Circle((left + 0.14 * (right - left), low + 0.14 * (high - low)), shown, fill=False, color="white"))
            axis.set_xlim(left, right)
            axis.set_ylim(low, high)
            axis.set_title(f"contact radius a = {shown:.3g} {length.symbol} (circle)")
        for axis in axes[:panels]:
            axis.grid(False)
            axis.set_xlabel(f"x [{length.symbol}]")
            axis.set_ylabel(f"y [{length.symbol}]")
        axes[1].set_ylabel(f"depth z [{length.symbol}]")
    return figure
