# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures made of voxels: a micrograph, a tomogram or a discretized structure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import native, number, numbers, record, row, whole
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Elastic
from .shapes import Shapes
from .structure import Structure, elastic, exponent_of_mean


@dataclass(frozen=True, eq=False)
class Voxels(Structure):
    """Structure of cells of one phase each, on a half-space.

    Parameters
    ----------
    labels : array_like
        Phase numbers 0 ... len(phases) - 1, an integer array (nz, ny, nx) with the surface first. It is not copied: a memory-mapped
        file is read slice by slice. Do not change it while the object is in use.
    phases : sequence of Elastic
        Materials of the phases.
    spacing : array_like
        Edge lengths (dz, dy, dx) of a cell, or one number for cubes, > 0 [length].
    beside : "periodic" or Elastic, optional
        "periodic": the array repeats in x and y. Otherwise the material outside the array.
    below : Elastic, optional
        Material of the half-space below the array; None is the most frequent phase of the last slice.
    origin : sequence of float, optional
        (x, y) of the lower corner of the array [length]; the centre of cell (k, j, i) is at x = origin[0] + (i + 1/2) dx.
    images : int, optional
        For "periodic": number of periods that count cell by cell, 1 to 100. Further cells count with the mean of their slice.
    reference_nu : float, optional
        Poisson's ratio of the weights [1]; None is the mean over all voxels.
    exponent : float, optional
        p of the mean `G_eff = [sum of w G^p]^(1/p)`, -1 (series) to 1 (parallel); 0 is the mean of the logarithms [1].

    Raises
    ------
    ArgumentTypeError
        `labels` is not an integer array (nz, ny, nx), or a material is not `Elastic`.
    InvalidArgumentError
        A label has no phase, or a number is outside its range.

    Examples
    --------
    >>> labels = np.zeros((4, 8, 8), dtype=np.uint8)
    >>> labels[:, 2:6, 2:6] = 1
    >>> cells = mdr.lateral.Voxels(labels, [mdr.Elastic(3e9, 0.3), mdr.Elastic(70e9, 0.3)], 1e-6)
    >>> print(f"{cells.modulus(4e-6, 4e-6, 1e-6):.4e}")
    5.6121e+10
    """

    labels: NDArray[Any]
    phases: tuple[Elastic, ...]
    spacing: tuple[float, ...]
    beside: str | Elastic
    below: Elastic
    origin: tuple[float, float]
    images: int
    reference_nu: float
    exponent: float
    _counts: NDArray[np.float64] = field(init=False, repr=False)

    def __init__(
        self,
        labels: Any,
        phases: Sequence[Elastic],
        spacing: ArrayLike,
        *,
        beside: str | Elastic = "periodic",
        below: Elastic | None = None,
        origin: Sequence[float] = (0.0, 0.0),
        images: int = 1,
        reference_nu: float | None = None,
        exponent: float = 1.0,
    ) -> None:
        cells = labels if hasattr(labels, "ndim") and hasattr(labels, "dtype") else np.asarray(labels)
        if cells.ndim != 3 or cells.dtype.kind not in "iu" or not cells.size:
            raise ArgumentTypeError(f"labels: it must be an array (nz, ny, nx) of integers, not {cells.dtype} "
                                    f"of shape {cells.shape}")  # fmt: skip
        materials = tuple(elastic("a phase", phase) for phase in phases)
        counts = _census(cells, len(materials))
        steps = _edges(spacing)
        if beside != "periodic":
            elastic("beside", beside)
        corner: Any = row("origin", origin)
        if len(corner) != 2 or not np.all(np.isfinite(corner)):
            raise InvalidArgumentError(f"origin = {origin!r}: it must be two finite numbers (x, y)")
        base = materials[int(np.argmax(counts[-1]))] if below is None else elastic("below", below)
        poisson = np.array([m.nu for m in materials])
        share = counts.sum(axis=0) / counts.sum()
        mean = float(np.clip(share @ poisson, poisson.min(), poisson.max()))
        nu = mean if reference_nu is None else number("reference_nu", reference_nu)
        if not -1.0 < nu <= 0.5:
            raise InvalidArgumentError(f"reference_nu = {nu!r}: it must be greater than -1 and at most 0.5")
        periods = whole("images", images, 1, 100)
        if beside != "periodic" and periods != 1:
            raise InvalidArgumentError(f"images = {images!r}: a material is outside the array, and no periods. Omit it")
        self._set(labels=cells, phases=materials, spacing=steps, beside=beside, below=base, origin=corner, reference_nu=nu,
                  images=periods, exponent=exponent_of_mean(exponent), _counts=counts)  # fmt: skip

    @classmethod
    def from_shapes(
        cls, shapes: Shapes, spacing: ArrayLike, size: Sequence[int], *, origin: Sequence[float] = (0.0, 0.0), **options: Any
    ) -> Voxels:
        """Return shapes discretized into cells; each cell has the material at its centre.

        Parameters
        ----------
        shapes : Shapes
            The structure.
        spacing : array_like
            As in `Voxels` [length].
        size : sequence of int
            Numbers of cells (nz, ny, nx).
        origin : sequence of float, optional
            As in `Voxels` [length].
        **options
            Further arguments of `Voxels`.

        Returns
        -------
        Voxels
            The cells.

        Raises
        ------
        InvalidArgumentError
            A number is outside its range.
        """
        dz, dy, dx = _edges(spacing)
        nz, ny, nx = size
        phases = [shapes.background]
        number_of = {shapes.background: 0}
        for body in shapes.shapes:
            if body.material not in number_of:
                number_of[body.material] = len(phases)
                phases.append(body.material)
        x = origin[0] + (np.arange(nx) + 0.5) * dx
        y = origin[1] + (np.arange(ny)[:, None] + 0.5) * dy
        labels = np.zeros((nz, ny, nx), dtype=np.uint8 if len(phases) < 256 else np.int32)
        for k in range(nz):
            for body in shapes.shapes:
                labels[k][np.broadcast_to(body.holds(x, y, (k + 0.5) * dz), (ny, nx))] = number_of[body.material]
        options.setdefault("below", shapes.background)
        return cls(labels, phases, (dz, dy, dx), origin=origin, **options)

    def centres(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the coordinates of the centres of the cells, the points of maps.

        Returns
        -------
        tuple of ndarray
            x (nx) and y (ny) [length].
        """
        _, ny, nx = self.labels.shape
        _, dy, dx = self.spacing
        return self.origin[0] + (np.arange(nx) + 0.5) * dx, self.origin[1] + (np.arange(ny) + 0.5) * dy

    def slice_shares(self) -> NDArray[np.float64]:
        """Return the share of each phase in each slice.

        Returns
        -------
        ndarray
            Shares, (nz, phases) [1].
        """
        shares: NDArray[np.float64] = self._counts / self._counts.sum(axis=1, keepdims=True)
        return shares

    def _values(self, x: Any, y: Any, a: Any) -> Any:
        # the library's own copy of the array is made for the first point: maps do not need it
        if self._handle is None:
            padded = isinstance(self.beside, Elastic)
            beside = self.beside if isinstance(self.beside, Elastic) else self.below
            cells = np.ascontiguousarray(self.labels, dtype=np.intc)
            options = record(
                _layout.structure_options, reference_nu=self.reference_nu, padded=padded, images=self.images, beside_E=beside.E,
                beside_nu=beside.nu, origin=self.origin, exponent=self.exponent, reference_nu_is_given=True, exponent_is_given=True,
            )  # fmt: skip
            moduli, ratios = [m.E for m in self.phases], [m.nu for m in self.phases]
            bodies = cells, moduli, ratios, self.spacing[::-1], self.below.E, self.below.nu
            self._own(native.structure_voxels(cells.shape[::-1], *bodies, options))
        return super()._values(x, y, a)

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        mine, its = self._given(), other._given()
        return bool(np.array_equal(mine.pop("labels"), its.pop("labels"))) and mine == its

    def __hash__(self) -> int:
        return hash((self.labels.shape, self.phases, self.spacing))


def _census(cells: Any, phases: int) -> NDArray[np.float64]:
    """Voxels of each phase in each slice, slice by slice."""
    if not phases:
        raise InvalidArgumentError("phases: it is empty")
    counts = np.zeros((cells.shape[0], phases))
    for k in range(cells.shape[0]):
        layer = np.asarray(cells[k]).ravel()
        low, high = int(layer.min()), int(layer.max())
        if low < 0 or high >= phases:
            raise InvalidArgumentError(f"labels from {low} to {high}: there are phases 0 to {phases - 1}")
        counts[k] = np.bincount(layer, minlength=phases)
    return counts


def _edges(spacing: ArrayLike) -> tuple[float, ...]:
    """(dz, dy, dx) of a cell."""
    given = numbers("spacing", spacing)
    if given.shape not in ((), (3,)) or not np.all(np.isfinite(given) & (given > 0.0)):
        raise InvalidArgumentError(
            f"spacing = {spacing!r}: it must be three edge lengths (dz, dy, dx), or one for cubes, finite and greater than 0"
        )
    return row("spacing", np.broadcast_to(given, 3))
