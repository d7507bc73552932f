# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces of a large force-volume data set by a compiled law inside a Dask map: the same code on one machine and on a cluster.

    python force_volume_dask.py                            # threads or processes of this machine
    python force_volume_dask.py tcp://scheduler:8786       # a running cluster

The law pickles with all it needs (about 60 kB), so that workers neither solve contacts nor read files. Without Dask the same
function runs in a plain loop over the chunks.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

PIXELS, POINTS = 64, 200  # a map of 64 x 64 curves of 200 depths; make it as large as the disk
CHUNK = 16


def depths(row: int) -> np.ndarray:
    """Rows row ... row + CHUNK - 1 of the map [m]; read yours from a file here."""
    ramp = np.linspace(-20e-9, 100e-9, POINTS)
    tilt = 1e-10 * (np.arange(row, row + CHUNK)[:, None, None] + np.arange(PIXELS)[None, :, None])
    return ramp - tilt


def largest_force(row: int, law: mdr.ContactLaw) -> np.ndarray:
    """The largest force of each curve of a chunk [N]."""
    return np.max(law.force(depths(row)), axis=-1)


def main() -> None:
    film = mdr.Coated(mdr.Elastic(3e9, 0.35), 300e-9, mdr.Elastic(163e9, 0.22))
    law = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(200e-9), film), largest_depth=100e-9)
    rows = range(0, PIXELS, CHUNK)
    try:
        import dask
    except ImportError:
        print("without Dask: one chunk after the other")
        chunks = [largest_force(row, law) for row in rows]
    else:
        if len(sys.argv) > 1:
            from dask.distributed import Client

            Client(sys.argv[1])
        chunks = dask.compute(*[dask.delayed(largest_force)(row, law) for row in rows])
    forces = np.concatenate(chunks)
    print(f"{forces.size} curves of {POINTS} depths: largest force {forces.min():.4e} to {forces.max():.4e} N")
    draw(forces)


def draw(forces: np.ndarray) -> None:
    """The map of the largest forces."""
    figure, axes = plt.subplots(figsize=(6, 4.5), layout="constrained")
    image = axes.imshow(1e6 * forces, origin="lower")
    axes.set(xlabel="pixel", ylabel="pixel", title="curves on a tilted film")
    figure.colorbar(image, label="largest force F [µN]")
    path = Path(f"{Path(__file__).stem}.png")
    figure.savefig(path, dpi=120)
    print(f"written: {path}")


if __name__ == "__main__":
    main()
