# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures given by voxels: a micrograph, a tomogram, or any structure cut into cells."""

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
    """Cells of one phase each, over a half-space.

    labels : array (nz, ny, nx) of phase numbers, surface first, as image stacks are; integers 0 ... len(phases) - 1. It is not
        copied: a memory-mapped file is read slice by slice. Leave it unchanged while the object lives
    phases : materials
    spacing : edge lengths (dz, dy, dx) of a cell, or one number for cubes [length]
    beside : "periodic": the array repeats itself in x and y; or the material that lies beside it
    below : material of the half-space under the array; None: the most frequent phase of the last slice
    origin : (x, y) of the array's lower corner: cell (k, j, i) has its centre at x = origin[0] + (i + 1/2) dx [length]
    images : for "periodic", how many periods count cell by cell; beyond them each slice counts with its mean
    reference_nu : Poisson's ratio of the weights; None: the mean over all voxels
    exponent : p of the mean G_eff = [sum of w G^p]^(1/p): 1 in parallel, -1 in series, 0 the mean of the logarithms
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
            raise ArgumentTypeError(f"labels is not allowed: it must be an array (nz, ny, nx) of integers, not {cells.dtype} "
                                    f"of shape {cells.shape}")  # fmt: skip
        materials = tuple(elastic("a phase", phase) for phase in phases)
        counts = _census(cells, len(materials))
        steps = _edges(spacing)
        if beside != "periodic":
            elastic("beside", beside)
        corner: Any = row("origin", origin)
        if len(corner) != 2 or not np.all(np.isfinite(corner)):
            raise InvalidArgumentError(f"origin = {origin!r} is not allowed: it must be two finite numbers (x, y)")
        base = materials[int(np.argmax(counts[-1]))] if below is None else elastic("below", below)
        poisson = np.array([m.nu for m in materials])
        share = counts.sum(axis=0) / counts.sum()
        mean = float(np.clip(share @ poisson, poisson.min(), poisson.max()))
        nu = mean if reference_nu is None else number("reference_nu", reference_nu)
        if not -1.0 < nu <= 0.5:
            raise InvalidArgumentError(f"reference_nu = {nu!r} is not allowed: it must be greater than -1 and at most 0.5")
        periods = whole("images", images, 1, 100)
        if beside != "periodic" and periods != 1:
            raise InvalidArgumentError(
                f"images = {images!r} is not allowed: what lies beside is a material, no periods; leave it out"
            )
        self._set(labels=cells, phases=materials, spacing=steps, beside=beside, below=base, origin=corner, reference_nu=nu,
                  images=periods, exponent=exponent_of_mean(exponent), _counts=counts)  # fmt: skip

    @classmethod
    def from_shapes(
        cls, shapes: Shapes, spacing: ArrayLike, size: Sequence[int], *, origin: Sequence[float] = (0.0, 0.0), **options: Any
    ) -> Voxels:
        """Shapes cut into cells: each cell has the material at its centre. size = (nz, ny, nx); options as of Voxels."""
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
        """x and y of the cells' centres: where maps have their points [length]."""
        _, ny, nx = self.labels.shape
        _, dy, dx = self.spacing
        return self.origin[0] + (np.arange(nx) + 0.5) * dx, self.origin[1] + (np.arange(ny) + 0.5) * dy

    def slice_shares(self) -> NDArray[np.float64]:
        """Share of each phase in each slice, (nz, phases)."""
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
        raise InvalidArgumentError("phases is not allowed: it is empty")
    counts = np.zeros((cells.shape[0], phases))
    for k in range(cells.shape[0]):
        layer = np.asarray(cells[k]).ravel()
        low, high = int(layer.min()), int(layer.max())
        if low < 0 or high >= phases:
            raise InvalidArgumentError(f"labels from {low} to {high} are not allowed: there are phases 0 to {phases - 1}")
        counts[k] = np.bincount(layer, minlength=phases)
    return counts


def _edges(spacing: ArrayLike) -> tuple[float, ...]:
    """(dz, dy, dx) of a cell."""
    given = numbers("spacing", spacing)
    if given.shape not in ((), (3,)) or not np.all(np.isfinite(given) & (given > 0.0)):
        raise InvalidArgumentError(
            f"spacing = {spacing!r} is not allowed: it must be three edge lengths (dz, dy, dx), or one for cubes, finite and "
            "greater than 0"
        )
    return row("spacing", np.broadcast_to(given, 3))
