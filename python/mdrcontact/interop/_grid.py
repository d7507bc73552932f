# SPDX-License-Identifier: GPL-3.0-or-later
"""Compliances of bodies on the grids of boundary-element engines: periodic cells, single contacts, the mean of a cell."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._boundary import number, whole
from .._choices import nearest
from ..errors import ArgumentTypeError, InvalidArgumentError, MDRError
from ..medium.base import Medium
from ..poroelastic import is_poroelastic

Array = NDArray[np.float64]
MEANS = ("layers", "isolated")


def engine(name: str, adapter: str) -> Any:
    """The module of an engine, or an exception that names the extra which installs it."""
    try:
        return importlib.import_module(name)
    except ImportError as problem:
        raise MDRError(f'{adapter} needs {name}. Install it with pip install "mdrcontact[bem]"') from problem


def grid_of(numbers: Any, sizes: Any) -> tuple[tuple[int, ...], tuple[float, ...]]:
    """Numbers of points and sizes of a cell, one for each of one or two directions."""
    points = tuple(numbers) if np.ndim(numbers) else (numbers,)
    lengths = tuple(sizes) if np.ndim(sizes) else (sizes,) * len(points)
    if len(points) not in (1, 2) or len(lengths) != len(points):
        raise ArgumentTypeError(
            f"nb_grid_pts = {numbers!r}, physical_sizes = {sizes!r}: each must have one value for each of one or two directions"
        )
    for length in lengths:
        if not 0.0 < number("physical_sizes", length) < math.inf:
            raise InvalidArgumentError(f"physical_sizes = {sizes!r}: each must be finite and greater than 0")
    return tuple(whole("nb_grid_pts", n, 2) for n in points), tuple(map(float, lengths))


@dataclass(frozen=True)
class Response:
    """Surface of a body at the waves and pixels of a grid."""

    body: Medium
    omega: float | None = None
    drainage: str | None = None
    velocity: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.body, Medium):
            raise ArgumentTypeError(f"body = {self.body!r}: it must be a medium. Use Homogeneous, Coated, Layered, Graded or Pair")
        relaxes = self.body._relaxes() or is_poroelastic(self.body)
        if self.velocity is not None:
            self._check_velocity(relaxes)
        elif relaxes and self.omega is None:
            raise InvalidArgumentError("omega = None: this body relaxes. Set omega=0 for the relaxed body")
        if not relaxes and self.omega is not None:
            raise InvalidArgumentError(f"omega = {self.omega!r}: this body does not relax. Omit omega")

    def _check_velocity(self, relaxes: bool) -> None:
        if not relaxes:
            raise InvalidArgumentError(f"velocity = {self.velocity!r}: this body does not relax. Omit velocity")
        if self.omega is not None:
            raise InvalidArgumentError(f"omega = {self.omega!r}: the velocity gives each wave its frequency. Omit omega")
        if not math.isfinite(number("velocity", self.velocity)):
            raise InvalidArgumentError(f"velocity = {self.velocity!r}: it must be finite. Set the speed of the load along x")

    def compliance(self, k: Any, load: str = "normal") -> Array:
        """C at wavenumbers, which must be real to machine precision."""
        values = np.asarray(self.body.compliance(k, load, self.omega or 0.0, self.drainage))
        if np.any(np.abs(values.imag) > 1e-12 * np.abs(values.real)):
            raise InvalidArgumentError(
                f"omega = {self.omega}: the compliance is complex, and the solvers of the engine minimize an energy. "
                "Set omega=0 for the relaxed body, or use an elastic body with the moduli of this frequency"
            )
        return np.asarray(values.real, dtype=np.float64)

    def modulus(self, points: Sequence[int], sizes: Sequence[float]) -> float:
        """2/(k C) of the shortest wave of a grid, E* in estimates of the engine."""
        k = math.pi * max(n / size for n, size in zip(points, sizes, strict=True))
        return 2.0 / (k * float(self.compliance(k)))

    def mean(self, mean: str | float, sizes: Sequence[float]) -> float:
        """C(0), the displacement of a periodic cell by a uniform pressure."""
        value = self._named_mean(mean, sizes) if isinstance(mean, str) else number("mean", mean)
        if -1e-12 * float(self.compliance(2.0 * math.pi / max(sizes))) < value < 0.0:
            return 0.0  # of rounding
        if not 0.0 <= value < math.inf:
            words = "layers that are stiffer than the base reduce its compression" if isinstance(mean, str) else "it is negative"
            raise InvalidArgumentError(
                f"mean = {mean!r}: C(0) = {value:.6g} must be finite and at least 0, and {words}. "
                'Set mean=0.0, the depth below the mean surface, or mean="isolated"'
            )
        return value

    def _named_mean(self, mean: str, sizes: Sequence[float]) -> float:
        if mean not in MEANS:
            raise InvalidArgumentError(f"mean = {mean!r}: {nearest(mean, MEANS)}")
        if is_poroelastic(self.body):
            raise InvalidArgumentError(f"mean = {mean!r}: of a gel C(0) is not known. Set mean to a number [length/modulus]")
        limits = self.body.compliance_limits(self.omega or 0.0)
        long, rest = np.real(limits.long), np.real(limits.rest)
        if mean == "layers" or long == 0.0:
            return float(rest)
        if len(sizes) == 1:
            raise InvalidArgumentError(
                'mean = "isolated": the displacement by a line contact without neighbours is infinite on a half-space. '
                'Set mean="layers" or a number'
            )
        return float(rest + lattice_constant(sizes) * math.prod(sizes) * long / math.pi)

    def shear_mean(self) -> float:
        """C(0) under shear: that of the layers on a rigid base, 0 on others."""
        is_rigid = self.body.compliance_limits(self.omega or 0.0).long == 0.0
        return float(self.compliance(0.0, "twist")) if is_rigid else 0.0

    def waves(self, axes: Sequence[Array], mean: float, load: str = "normal") -> Array:
        """C at the waves of a grid, whose wavenumbers along its axes are given; `mean` at k = 0."""

        def values(*along: Array) -> Array:
            k = np.hypot(*along) if len(along) > 1 else along[0]
            found = np.full(k.shape, mean)
            found[k > 0.0] = self.compliance(k[k > 0.0], load)
            return found

        return on_grid(axes, values)

    def moving_waves(self, axes: Sequence[Array], mean: float) -> NDArray[np.complex128]:
        """C at waves that move along the first axis; the frequency at a point of the body is -k_x times the velocity."""
        along, *across = np.meshgrid(*axes, indexing="ij")
        k = np.hypot(along, across[0]) if across else np.abs(along)
        found = np.full(k.shape, mean, dtype=complex)
        omega = -float(self.velocity or 0.0) * along
        found[k > 0.0] = self.body.compliance(k[k > 0.0], "normal", omega[k > 0.0], self.drainage)
        return found

    def pixels(self, axes: Sequence[Array], size: Sequence[float]) -> Array:
        """Displacement by unit pressure on one pixel, at the distances along both axes from its centre."""
        if self.omega:
            raise InvalidArgumentError(f"omega = {self.omega}: one contact is known on the relaxed body. Set omega=0")
        width, height = size
        return on_grid(axes, lambda x, y: np.asarray(self.body.rectangle_response(x, y, (width, height))))


def folded(points: int, first: int, count: int) -> Array:
    """Distances in steps from the first point of a row that repeats after `points` points, of `count` points of it."""
    index = np.arange(first, first + count)
    return np.minimum(index, points - index).astype(float)


def on_grid(axes: Sequence[Array], function: Callable[..., Array]) -> Array:
    """Values on a grid of a function of distances along its one or two axes, computed once for equal distances."""
    values, places = zip(*(np.unique(axis, return_inverse=True) for axis in axes), strict=True)
    if len(axes) == 1:
        row: Array = function(*values)[places[0]]
        return row
    x, y = values
    if np.array_equal(x, y):
        i, j = np.tril_indices(x.size)
        table = np.empty((x.size, x.size))
        table[i, j] = table[j, i] = function(x[i], x[j])
    else:
        table = function(*map(np.ravel, np.meshgrid(x, y, indexing="ij"))).reshape(x.size, y.size)
    grid: Array = table[np.ix_(*places)]
    return grid


def lattice_constant(sizes: Sequence[float]) -> float:
    """S = lim (1/r - (2 pi/A) sum' exp(i k r)/k) of a rectangular lattice by Ewald's sums [1/length]; 3.900264920/L of a square."""
    area = math.prod(sizes)
    alpha = math.sqrt(math.pi / area)

    def sum_over(steps: Sequence[float], reach: float) -> float:
        """sum' erfc(s d)/d over the points of a lattice except its origin, for s d up to 6.5."""
        rows = [np.arange(-math.ceil(6.5 * reach / step), math.ceil(6.5 * reach / step) + 1) * step for step in steps]
        d = np.hypot(*np.meshgrid(*rows)).ravel()
        return math.fsum(math.erfc(r / reach) / r for r in d[d > 0.0])

    waves = sum_over([2.0 * math.pi / size for size in sizes], 2.0 * alpha)
    points = sum_over(sizes, 1.0 / alpha)
    return 2.0 * alpha / math.sqrt(math.pi) + 2.0 * math.sqrt(math.pi) / (alpha * area) - points - 2.0 * math.pi / area * waves
