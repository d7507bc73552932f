# SPDX-License-Identifier: GPL-3.0-or-later
"""A composite like a brake pad: hard grains and fibres in a polymer, and what contacts of three sizes meet at its surface.

Makes the structure itself (96 x 96 x 24 voxels of 2 um), maps E_eff(a, x, y) at a = 2, 10 and 40 um, lets a sphere indent it
virtually, and slides it along a line. Writes brake_pad.npy (structure), brake_pad.toml (the same for `mdrcontact map`) and
brake_pad.png.
"""

from pathlib import Path

import numpy as np

import mdrcontact as mdr
from mdrcontact import lateral, studies
from mdrcontact.problem import MapProblem

RESIN = mdr.Elastic(4e9, 0.36)
ALUMINA = mdr.Elastic(370e9, 0.22)
STEEL = mdr.Elastic(205e9, 0.29)
CELL = 2e-6
SIZE = (24, 96, 96)
RADII = [2e-6, 10e-6, 40e-6]
TOML = """\
title = "Grains and fibres in a resin"

[structure]
labels = "brake_pad.npy"
spacing = ["2 um", "2 um", "2 um"]
beside = "periodic"

[[structure.phase]]     # phenolic resin
E = "4 GPa"
nu = 0.36

[[structure.phase]]     # alumina
E = "370 GPa"
nu = 0.22

[[structure.phase]]     # steel
E = "205 GPa"
nu = 0.29

[map]
radii = ["2 um", "10 um", "40 um"]
"""


def periodic_balls(rng: np.random.Generator, count: int, radius: float) -> list[lateral.Ball]:
    """Balls of alumina anywhere in the array, each with its images across the array's sides."""
    extent = np.array(SIZE[::-1]) * CELL
    balls = []
    for center in rng.random((count, 3)) * extent:
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                x, y, z = center + np.array([i, j, 0]) * extent
                balls.append(lateral.Ball((x, y, z), radius, ALUMINA))
    return balls


def main() -> None:
    """Structure, maps, virtual indentation, sliding, picture."""
    rng = np.random.default_rng(14)
    grains = periodic_balls(rng, 30, 9e-6)
    # fibres along y repeat themselves with the array
    fibres = [lateral.Fibre((x, 0.0, z), (0.0, 1.0, 0.0), 5e-6, STEEL) for x, z in ((40e-6, 6e-6), (130e-6, 15e-6))]
    structure = lateral.Voxels.from_shapes(lateral.Shapes(RESIN, [*grains, *fibres]), CELL, SIZE)
    # from_shapes numbers the phases in the order of the shapes: resin, alumina, steel
    Path("brake_pad.toml").write_text(TOML, encoding="utf-8")
    np.save("brake_pad.npy", structure.labels)

    found = studies.map(MapProblem("Grains and fibres in a resin", structure, np.array(RADII)))
    print("contact radius   least   mean    most   E_eff [GPa]")
    for a, values in zip(RADII, found.maps, strict=True):
        print(f"{a * 1e6:10.0f} um   {values.min() / 1e9:7.2f} {values.mean() / 1e9:7.2f} {values.max() / 1e9:7.2f}")

    seen = lateral.indentation_map(structure, mdr.Sphere(100e-6), 1e-6)
    print(
        f"\na sphere of radius 100 um, 1 um deep: a = {seen.radius * 1e6:.1f} um, "
        f"F from {seen.force.min() * 1e3:.1f} to {seen.force.max() * 1e3:.1f} mN"
    )

    x = (np.arange(24) + 0.5) * SIZE[2] * CELL / 24
    # for a line, the same structure with coarser voxels
    coarse = lateral.Voxels(structure.labels[2::4, 2::4, 2::4], structure.phases, 4 * CELL)
    moved = lateral.slide(coarse, mdr.Sphere(100e-6), x, y=96e-6, force=0.1, periodic=True, points=9)
    print(
        f"sliding under 100 mN: depth from {moved.depth.min() * 1e6:.3f} to {moved.depth.max() * 1e6:.3f} um, "
        f"lateral force up to {np.abs(moved.lateral_force).max() * 1e3:.3f} mN, mean {moved.lateral_force.mean() * 1e3:.1e} mN"
    )

    found.figure().save("brake_pad.png")
    print("written: brake_pad.png")


if __name__ == "__main__":
    main()
