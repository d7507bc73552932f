# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps E_eff(a, x, y) of voxel structures: the convolution of theory/lateral.md (1.2), slice by slice, by FFT."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _scipy
from .._boundary import call, native, row, thread_count
from .._interrupt import workers
from ..errors import ArgumentTypeError, InvalidArgumentError, OutOfMemoryError
from ..material import Elastic
from ..progress import Progress
from ..threads import cores
from ..weights import weight_j0, weight_j1
from .structure import PowerMean, shear
from .voxels import Voxels

Array = NDArray[np.float64]


class _Job(NamedTuple):
    """A rectangle of slices to be convolved."""

    layer: Callable[[int], Any]
    """labels (ny, nx) of slice k"""
    shape: tuple[int, int]
    base: Array
    """(nz, 2): phi(G) and nu that each slice is compared with"""
    periodic: bool
    voxels: Voxels


def effective_map(
    voxels: Voxels, a: ArrayLike, *, threads: int = 0, progress: bool | Progress = False, memory_limit: float | None = None
) -> Array:
    """Return E_eff at all cell centres for all contact radii, by FFT.

    One pass over the slices serves all radii. Map and `Voxels.modulus` agree to 1e-7. It needs SciPy.

    Parameters
    ----------
    voxels : Voxels
        The structure.
    a : array_like
        Contact radii > 0, one or more [length].
    threads : int, optional
        Number of threads >= 1, or 0 for one per core.
    progress : bool or Progress, optional
        True shows a progress bar. A `Progress` follows and stops the work.
    memory_limit : float, optional
        Largest memory by `map_memory` [bytes].

    Returns
    -------
    ndarray
        E_eff, (radii, ny, nx) [modulus].

    Raises
    ------
    OutOfMemoryError
        The map needs more than `memory_limit`.
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> labels = np.zeros((4, 8, 8), dtype=np.uint8)
    >>> labels[:, 2:6, 2:6] = 1
    >>> cells = mdr.lateral.Voxels(labels, [mdr.Elastic(3e9, 0.3), mdr.Elastic(70e9, 0.3)], 1e-6)
    >>> moduli = mdr.lateral.effective_map(cells, [0.5e-6, 1e-6])
    >>> print(moduli.shape, f"{moduli[1, 3, 3]:.4e}")
    (2, 8, 8) 5.4608e+10
    """
    radii, team = _radii(a), _team(threads)
    needed = map_memory(voxels, radii, threads=team)
    if memory_limit is not None and not needed <= memory_limit:
        raise OutOfMemoryError(
            f"the map needs {needed / 2**20:.0f} MiB, more than memory_limit = {memory_limit / 2**20:.0f} MiB: use fewer radii or "
            "threads, or tiled_map"
        )
    periodic = voxels.beside == "periodic"
    job = _Job(lambda k: voxels.labels[k], voxels.labels.shape[1:], _bases(voxels), periodic, voxels)
    return _convolve(job, radii, team, progress)


def map_memory(voxels: Voxels, a: ArrayLike, *, threads: int = 0, shape: tuple[int, int] | None = None) -> int:
    """Return the memory that `effective_map` needs in addition to the labels.

    Parameters
    ----------
    voxels : Voxels
        The structure.
    a : array_like
        Contact radii > 0 [length].
    threads : int, optional
        As in `effective_map`.
    shape : tuple of int, optional
        Cells (rows, columns) of a tile with its halo; None is the whole map.

    Returns
    -------
    int
        Upper bound of the memory [bytes].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> cells = mdr.lateral.Voxels(np.zeros((4, 64, 64), dtype=np.uint8), [mdr.Elastic(3e9, 0.3)], 1e-6)
    >>> print(mdr.lateral.map_memory(cells, 1e-6, threads=1))
    700480
    """
    ny, nx = voxels.labels.shape[1:] if shape is None else shape
    periodic = voxels.beside == "periodic" and shape is None
    my, mx = _sizes((ny, nx), periodic)
    radii, kernels = len(_radii(a)), 1 + _needs_poisson(voxels)
    spectrum, plane = 16 * my * (mx // 2 + 1), 8 * my * mx
    reach = voxels.images if periodic else 1
    quadrant = 8 * (reach * ny + 1) * (reach * nx + 1)
    sums = radii * kernels * spectrum
    each = kernels * (spectrum + plane) + 2 * plane + 2 * spectrum + 8 * quadrant
    return int(sums + _team(threads) * each + 3 * radii * 8 * ny * nx + 3 * plane)


def tiled_map(
    voxels: Voxels,
    a: ArrayLike,
    *,
    tile: int | tuple[int, int],
    halo: int | tuple[int, int],
    threads: int = 0,
    progress: bool = False,
    out: Any = None,
) -> Any:
    """Return the map of E_eff in tiles, for arrays larger than the memory.

    Each tile includes `halo` cells around it; cells beyond count with the mean of their slice (periodic) or as the material
    outside. The error in E_eff is at most the contrast there times `weight_beyond`.

    Parameters
    ----------
    voxels : Voxels
        The structure.
    a : array_like
        Contact radii > 0 [length].
    tile : int or tuple of int
        Rows and columns of a tile, >= 1.
    halo : int or tuple of int
        Rows and columns around it, >= 0.
    threads : int, optional
        As in `effective_map`.
    progress : bool, optional
        True shows a progress bar.
    out : array, optional
        Array of shape (radii, ny, nx) for the result, for example a numpy.memmap.

    Returns
    -------
    ndarray or dask.array.Array
        E_eff, (radii, ny, nx) [modulus]. A Dask array of labels gives a Dask array, computed on demand.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range, or `out` has another shape.
    ArgumentTypeError
        `tile` or `halo` is not one or two whole numbers.

    Examples
    --------
    >>> labels = np.zeros((4, 8, 8), dtype=np.uint8)
    >>> labels[:, 2:6, 2:6] = 1
    >>> cells = mdr.lateral.Voxels(labels, [mdr.Elastic(3e9, 0.3), mdr.Elastic(70e9, 0.3)], 1e-6)
    >>> moduli = mdr.lateral.tiled_map(cells, 1e-6, tile=4, halo=4)
    >>> print(moduli.shape, f"{moduli[0, 3, 3]:.4e}")
    (1, 8, 8) 5.4664e+10
    """
    radii, team = _radii(a), _team(threads)
    rows, columns = _pair("tile", tile, 1)
    margin = _pair("halo", halo, 0)
    ny, nx = voxels.labels.shape[1:]
    spans = [(y, min(y + rows, ny), x, min(x + columns, nx)) for y in range(0, ny, rows) for x in range(0, nx, columns)]
    base, periodic = _bases(voxels), voxels.beside == "periodic"
    if hasattr(voxels.labels, "dask"):
        return _dask_map(voxels, radii, spans, margin, base, periodic)
    shape = (len(radii), ny, nx)
    if out is not None and tuple(out.shape) != shape:
        raise InvalidArgumentError(f"out has the shape {tuple(out.shape)}: it must be {shape}")
    result = np.empty(shape) if out is None else out
    for y0, y1, x0, x1 in _bar(spans, progress, "tiles"):
        iy, ix = _window(y0, y1, ny, margin[0], periodic), _window(x0, x1, nx, margin[1], periodic)
        job = _Job(partial(_cut, voxels.labels, np.ix_(iy, ix)), (len(iy), len(ix)), base, False, voxels)
        part = _convolve(job, radii, team, False)
        cy, cx = _inside(y0, iy, margin[0], periodic), _inside(x0, ix, margin[1], periodic)
        result[:, y0:y1, x0:x1] = part[:, cy : cy + y1 - y0, cx : cx + x1 - x0]
    return result


def weight_beyond(a: float, distance: float, depth: float = np.inf, nu: float = 0.5) -> float:
    """Return the share of E_eff from material far from the axis of the contact.

    Parameters
    ----------
    a : float
        Contact radius > 0 [length].
    distance : float
        Distance from the axis beyond which material counts [length].
    depth : float, optional
        Depth down to which material counts [length].
    nu : float, optional
        Poisson's ratio of the weights, -1 < nu <= 0.5 [1].

    Returns
    -------
    float
        Share, accurate to about 1 % [1].

    Raises
    ------
    InvalidArgumentError
        `nu` is outside its range.

    Examples
    --------
    >>> print(f"{mdr.lateral.weight_beyond(1e-6, 10e-6, depth=4e-6):.1e}")
    2.7e-03
    """
    order = 24
    points, weights = (rows.T for rows in call(native.lateral_rule, order, nu))
    counts = (np.hypot(points[0], points[1]) > distance / a) & (points[2] < depth / a)
    return float(weights[0, counts].sum())


def _convolve(job: _Job, radii: Array, threads: int, progress: bool | Progress) -> Array:
    """E_eff at all cells of the job: (radii, ny, nx)."""
    _scipy.require()
    import scipy.fft

    voxels = job.voxels
    slices, (dz, dy, dx) = voxels.labels.shape[0], voxels.spacing
    sizes = _sizes(job.shape, job.periodic)
    kernels = 1 + _needs_poisson(voxels)
    mean = _mean(voxels)
    values = np.array([_row(m, mean) for m in voxels.phases]).T
    under = _row(voxels.below, mean)
    sums = np.zeros((len(radii), kernels, sizes[0], sizes[1] // 2 + 1), dtype=complex)
    locks = [threading.Lock() for _ in radii]
    reach = [voxels.images * n if job.periodic else n - 1 for n in job.shape]
    lines = [(np.arange(n + 2) - 0.5) * h for n, h in zip(reach, (dy, dx), strict=True)]

    def add(k: int) -> None:
        layer = np.asarray(job.layer(k))
        spectra = [scipy.fft.rfft2(values[i][layer] - job.base[k, i], s=sizes) for i in range(kernels)]
        if not any(s.any() for s in spectra):
            return
        # threads begin at different radii, so that they do not wait for each other
        for r in np.roll(np.arange(len(radii)), -k):
            weights = call(native.lateral_cells, voxels.reference_nu, radii[r], k * dz, (k + 1) * dz, lines[1], lines[0])
            for i in range(kernels):
                product = scipy.fft.rfft2(_unfold(weights[i], job.shape, sizes, job.periodic))
                product *= spectra[i]
                with locks[r]:
                    sums[r, i] += product

    with workers(threads) as pool:
        for _ in _bar(pool.map(add, range(slices)), progress, "slices", slices):
            pass
    edges = np.arange(slices + 1) * dz
    result = np.empty((len(radii), *job.shape))
    for r, a in enumerate(radii):
        means = []
        for i, (below, J) in enumerate(
            ((under[0], weight_j0(edges / a, nu=voxels.reference_nu)), (under[1], weight_j1(edges / a)))
        ):
            level = below + float(-np.diff(np.asarray(J)) @ (job.base[:, i] - below))
            if i < kernels:
                means.append(level + scipy.fft.irfft2(sums[r, i], s=sizes)[: job.shape[0], : job.shape[1]])
            else:
                means.append(np.full(job.shape, level))
        result[r] = 2.0 * mean.mean(means[0]) / (1.0 - means[1])
    return result


def _unfold(quadrant: Any, shape: tuple[int, int], sizes: tuple[int, int], periodic: bool) -> Array:
    """Even kernel of a cyclic convolution from its weights at offsets >= 0."""
    kernel: Array = quadrant
    for axis in (0, 1):
        n, size = shape[axis], sizes[axis]
        if periodic:
            # the window of Voxels.modulus: offsets from -images n to images n - 1
            images = (kernel.shape[axis] - 1) // n
            offsets = np.arange(n)
            kernel = sum(np.take(kernel, np.abs(offsets + p * n), axis) for p in range(-images, images))  # type: ignore[assignment]
        else:
            offsets = np.minimum(np.arange(size), size - np.arange(size))
            kernel = np.take(kernel, np.minimum(offsets, n - 1), axis)
            outside = offsets > n - 1
            kernel[(outside, slice(None)) if axis == 0 else (slice(None), outside)] = 0.0
    return kernel


def _sizes(shape: tuple[int, int], periodic: bool) -> tuple[int, int]:
    """Sizes of the transforms."""
    if periodic:
        return shape
    _scipy.require()
    import scipy.fft

    return scipy.fft.next_fast_len(2 * shape[0] - 1, True), scipy.fft.next_fast_len(2 * shape[1] - 1, True)


def _bases(voxels: Voxels) -> Array:
    """Return the reference of each slice: its mean, or the material outside; exactly the common value if all are equal."""
    beside, mean = voxels.beside, _mean(voxels)
    if isinstance(beside, Elastic):
        return np.tile(_row(beside, mean), (voxels.labels.shape[0], 1))
    values = np.array([_row(m, mean) for m in voxels.phases])
    below = np.array(_row(voxels.below, mean))
    bases: Array = below + voxels.slice_shares() @ (values - below)
    return bases


def _mean(voxels: Voxels) -> PowerMean:
    """The mean of G over the voxels and what surrounds them."""
    around = [m for m in (voxels.below, voxels.beside) if isinstance(m, Elastic)]
    return PowerMean(voxels.exponent, np.array([shear(m) for m in (*voxels.phases, *around)]))


def _row(material: Elastic, mean: PowerMean) -> list[float]:
    """Return the summands: phi(G) and nu."""
    return [float(mean.transformed(shear(material))), material.nu]


def _needs_poisson(voxels: Voxels) -> bool:
    ratios = {m.nu for m in voxels.phases}
    if isinstance(voxels.beside, Elastic):
        ratios.add(voxels.beside.nu)
    return len(ratios) > 1


def _radii(a: ArrayLike) -> Array:
    radii = np.array(row("a", np.atleast_1d(a)))
    if not (np.all(np.isfinite(radii)) and np.all(radii > 0.0)):
        raise InvalidArgumentError("a: contact radii must be finite and greater than 0")
    return radii


def _team(threads: int) -> int:
    """Number of threads that `threads` means; 0: one per core."""
    if thread_count(threads) < 0:
        raise InvalidArgumentError(f"threads = {threads!r}: it must be at least 1, or 0 for one per core")
    return threads or cores()


def _pair(name: str, value: Any, least: int) -> tuple[int, int]:
    pair = (value, value) if isinstance(value, int) else tuple(value)
    if len(pair) != 2 or not all(isinstance(n, int) for n in pair):
        raise ArgumentTypeError(f"{name} = {value!r}: it must be one or two whole numbers")
    if min(pair) < least:
        raise InvalidArgumentError(f"{name} = {value!r}: it must be at least {least}")
    return pair


def _window(low: int, high: int, n: int, margin: int, periodic: bool) -> Any:
    """Indices of a tile with its halo: around the array's end where it repeats itself, up to it where it does not."""
    if periodic:
        return np.arange(low - margin, high + margin) % n
    return np.arange(max(0, low - margin), min(n, high + margin))


def _inside(low: int, indices: Any, margin: int, periodic: bool) -> int:
    """Return the position of the tile in its window."""
    return margin if periodic else int(low - indices[0])


def _cut(labels: Any, cells: Any, k: int) -> Any:
    """A window of slice k."""
    return np.asarray(labels[k])[cells]


def _bar(items: Any, progress: bool | Progress, unit: str, total: int | None = None) -> Iterator[Any]:
    if not progress:
        yield from items
        return
    if isinstance(progress, Progress):
        for done, item in enumerate(items, start=1):
            yield item
            progress.step(done, total, unit)
        return
    from tqdm import tqdm

    yield from tqdm(items, unit=f" {unit}", total=total, leave=False)


def _dask_map(
    voxels: Voxels, radii: Array, spans: list[tuple[int, int, int, int]], margin: tuple[int, int], base: Array, periodic: bool
) -> Any:
    """One delayed tile for each span."""
    import importlib

    # imported by name: Dask's functions have no types
    dask_array: Any = importlib.import_module("dask.array")
    delayed: Any = importlib.import_module("dask").delayed

    ny, nx = voxels.labels.shape[1:]
    settings = {n: v for n, v in voxels._given().items() if n != "labels"}
    rows: dict[int, list[Any]] = {}
    for y0, y1, x0, x1 in spans:
        iy, ix = _window(y0, y1, ny, margin[0], periodic), _window(x0, x1, nx, margin[1], periodic)
        corner = _inside(y0, iy, margin[0], periodic), _inside(x0, ix, margin[1], periodic)
        task = delayed(_compute_tile)(voxels.labels[:, iy][:, :, ix], settings, radii, base, corner, (y1 - y0, x1 - x0))
        part = dask_array.from_delayed(task, (len(radii), y1 - y0, x1 - x0), dtype=float)
        rows.setdefault(y0, []).append(part)
    return dask_array.concatenate([dask_array.concatenate(parts, axis=2) for parts in rows.values()], axis=1)


def _compute_tile(
    labels: Any, settings: dict[str, Any], radii: Array, base: Array, corner: tuple[int, int], size: tuple[int, int]
) -> Array:
    """A tile on a worker of the cluster, in one thread: the scheduler has others."""
    voxels = Voxels(labels, **settings)
    job = _Job(lambda k: labels[k], labels.shape[1:], base, False, voxels)
    part = _convolve(job, radii, 1, False)
    return part[:, corner[0] : corner[0] + size[0], corner[1] : corner[1] + size[1]]
