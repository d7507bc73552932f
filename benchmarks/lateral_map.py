# SPDX-License-Identifier: GPL-3.0-or-later
"""Map of a voxel structure at 8 contact radii against its points by direct summation: python benchmarks/lateral_map.py

Prints a Markdown table. Direct summation is timed for a few points and scaled to 100: (a) as Structure.modulus does it, with the
weights of all cells computed for each point; (b) the sum alone, with all weights ready in memory, one radius at a time.

Measured on two cores that five others kept busy as well (load 7), 256 x 256 x 128 voxels, 8 radii; the ratios are what counts:

    boundary   map [s]   100 points [s]   ratio   sums alone, 100 points [s]   stated [MiB]   peak of the process [MiB]
    periodic      32.8             8297     253                         49.6             38                         212
    padded        36.2             2351      65                         30.1             90                         246
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import argparse
import resource
import time

import numpy as np

import mdrcontact as mdr
from mdrcontact import lateral


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, nargs=3, default=(128, 256, 256), metavar=("NZ", "NY", "NX"))
    parser.add_argument("--radii", type=int, default=8)
    arguments = parser.parse_args()
    nz, ny, nx = arguments.size
    labels = (np.random.default_rng(6).random((nz, ny, nx)) < 0.3).astype(np.uint8)
    phases = [mdr.Elastic(3e9, 0.35), mdr.Elastic(70e9, 0.22)]
    radii = np.geomspace(1.0, 40.0, arguments.radii)
    print(f"{nx} x {ny} x {nz} voxels, {len(radii)} radii from 1 to 40 cells, two phases that differ in E and nu\n")
    print("| boundary | map [s] | 100 points [s] | sums alone, 100 points [s] | memory stated [MiB] | peak of the process [MiB] |")
    print("|---|---|---|---|---|---|")
    for name, beside in (("periodic", "periodic"), ("padded", phases[0])):
        voxels = lateral.Voxels(labels, phases, 1.0, beside=beside)
        start = time.perf_counter()
        maps = lateral.effective_map(voxels, radii)
        map_time = time.perf_counter() - start
        stated = lateral.map_memory(voxels, radii) / 2**20
        x, y = voxels.centres()
        # the library's own copy of the array is made before the clock runs
        voxels.modulus(x[0], y[0], radii[0] * 1e-3)
        start = time.perf_counter()
        point = voxels.modulus(x[7], y[9], radii)
        point_time = 100.0 * (time.perf_counter() - start)
        np.testing.assert_allclose(point, maps[:, 9, 7], rtol=1e-7)
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        values, weights = np.array([1.0, 2.0])[labels], np.full(labels.shape, 1e-6)
        start = time.perf_counter()
        for _ in range(3):
            np.vdot(values, weights)
        sum_time = 100.0 * len(radii) * 2 * (time.perf_counter() - start) / 3
        del values, weights
        print(f"| {name} | {map_time:.1f} | {point_time:.0f} | {sum_time:.1f} | {stated:.0f} | {peak:.0f} |", flush=True)


if __name__ == "__main__":
    main()
