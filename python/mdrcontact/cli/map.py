# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact map`: effective modulus at every place of a laterally heterogeneous structure."""

from __future__ import annotations

import argparse
import io
from pathlib import Path

import numpy as np

from .. import lateral
from .._progress import on_terminal
from ..problem import load_map
from ..studies import map
from ..studies.result import Array
from . import files
from .table import as_text

HELP = "compute the effective modulus at every place of a heterogeneous structure"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("problem", metavar="MAP.toml", help="map file: structure and contact radii")
    parser.add_argument(
        "--npy", type=Path, metavar="FILE.npy", help="write the maps to a NumPy file, as an array (radii, ny, nx) [Pa]"
    )
    parser.add_argument(
        "--plot", type=Path, metavar="FILE.png", help="draw structure and maps (.png, .pdf or .svg); needs matplotlib"
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing output files")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="number of threads (default: 0, one per core)")
    parser.add_argument("--memory", type=float, metavar="GIB", help="stop with an error if more memory is needed [GiB]")


def run(arguments: argparse.Namespace) -> None:
    """Compute, print and write the results."""
    files.check(arguments)
    problem = load_map(arguments.problem)
    needed = lateral.map_memory(problem.voxels, problem.radii, threads=arguments.threads)
    nz, ny, nx = problem.voxels.labels.shape
    print(f"{problem.title}\n")
    print(f"{nx} x {ny} x {nz} voxels, {len(problem.radii)} radii: at most {needed / 2**20:.0f} MiB of memory", flush=True)
    limit = None if arguments.memory is None else arguments.memory * 2**30
    with on_terminal() as progress:
        found = map(problem, threads=arguments.threads, memory_limit=limit, progress=progress)
    print(f"{as_text(found.tables['moduli'], left=2)}\n\n{found.notes['bounds']}")
    files.write(arguments, npy=lambda: _as_npy(found.maps), plot=found.figure)


def _as_npy(maps: Array) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, maps)
    return buffer.getvalue()
