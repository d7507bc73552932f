# SPDX-License-Identifier: GPL-3.0-or-later
"""Pyramids against their equivalent cones on a film: the table that `benchmarks/pyramids.py` writes, and what follows from it."""

from __future__ import annotations

import functools
import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ... import medium as media
from ... import profile as profiles
from ..._boundary import numbers
from ..._warn import silence
from ...contact import Contact
from ...errors import ArgumentTypeError, InvalidArgumentError, MDRError, UnreachableError
from ...material import Elastic

Array = NDArray[np.float64]

CONTRAST, A_OVER_H = (0.01, 100.0), (0.1, 10.0)
"""Ranges of the table: contact modulus of the film over that of the base, contact radius of the cone over the thickness."""
_SHAPES: tuple[tuple[type, str], ...] = (
    (profiles.Berkovich, "triangle"),
    (profiles.CubeCorner, "triangle"),
    (profiles.Vickers, "square"),
)
"""Cross-sections: in linear elasticity the slope of the faces does not matter."""
PYRAMIDS = tuple(kind for kind, _ in _SHAPES)
_CUBIC, _LINEAR = 4, 2
"""Nodes along each variable from which a value is interpolated, and from which its errors are."""
_SHARE = 0.15
"""Error of an interpolated area over the difference between the areas around it, which has no smooth dependence where contacts of
a stiff film divide. Errors so found contain those of all entries of tests/data/pyramids_between.csv."""
_REACH = 1e-9
"""Rounding of a ratio at the end of its range."""
_SMALL, _LEAST, _STRIDE, _FARTHEST, _MOST = 1e-7, 1e-4, 0.3, math.log(20.0), 60
"""Search for a modulus: accuracy, least first step, largest step and largest value of its logarithm; largest number of steps."""


class PyramidCorrection(NamedTuple):
    """Pyramid over its equivalent cone at one depth, from `pyramid_correction`.

    The errors are those of the grid and of the interpolation in the table.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(400e9, 0.25), 1e-6, mdr.Elastic(40e9, 0.25))
    >>> found = mdr.instruments.pyramid_correction(mdr.Vickers(), film, 1.0)
    >>> print(f"{found.force:.3f} {found.area:.2f}")
    1.045 0.72
    """

    force: float | Array
    """force over that of the cone [1]"""
    force_error: float | Array
    """largest error of `force` [1]"""
    film_modulus: float | Array
    """modulus of the film over the one that a fit of this force by the cone finds; NaN if that is not within a factor of 20 [1]"""
    film_modulus_error: float | Array
    """largest error of `film_modulus` [1]"""
    area: float | Array
    """contact area over that of the cone [1]"""
    area_error: float | Array
    """largest error of `area` [1]"""


class _Film(NamedTuple):
    """What the ratios depend on, and the thickness."""

    contrast: float
    """contact modulus of the film over that of the base"""
    position: float
    """of the second Dundurs parameter in its range, 0 to 1"""
    thickness: float


class _Table(NamedTuple):
    """Ratios and errors at nodes of ln contrast, position and ln a/h."""

    nodes: tuple[Array, Array, Array]
    values: Array
    """(contrast, position, a/h, 4): force, its error, area, its error"""

    def at(self, contrast: float, position: float, a_over_h: Array) -> Array:
        """Return (n, 4) interpolated values; to the errors of the grid those of the interpolation are added."""
        x = (np.atleast_1d(math.log(contrast)), np.atleast_1d(position), np.log(a_over_h))
        found = self._by(x, (_CUBIC, _CUBIC, _CUBIC))
        found[:, 1::2] = self._by(x, (_LINEAR, _LINEAR, _LINEAR))[:, 1::2]
        for i in range(len(x)):
            widths = tuple(_LINEAR if i == j else _CUBIC for j in range(len(x)))
            found[:, 1::2] += np.abs(self._by(x, widths) - found)[:, ::2]
        found[:, 3] += _SHARE * self._spread(x)
        return found

    def _spread(self, x: tuple[Array, Array, Array]) -> Array:
        """Largest difference between contact areas at the nodes around each point."""
        first, second, third = (_first(nodes, at, _LINEAR) for nodes, at in zip(self.nodes, x, strict=True))
        part = self.values[first[0] : first[0] + _LINEAR, second[0] : second[0] + _LINEAR, :, 2].reshape(-1, len(self.nodes[2]))
        return np.asarray(np.ptp(np.concatenate([part[:, third], part[:, third + 1]]), axis=0))

    def _by(self, x: tuple[Array, Array, Array], widths: tuple[int, ...]) -> Array:
        """Interpolated columns by polynomials through so many nodes along each variable."""
        first, second, third = (_weights(nodes, at, width) for nodes, at, width in zip(self.nodes, x, widths, strict=True))
        part = np.tensordot(second[0], np.tensordot(first[0], self.values, (0, 0)), (0, 0))
        return np.asarray(third @ part)


def _first(nodes: Array, x: Array, width: int) -> NDArray[np.intp]:
    """The first of the nodes around each point."""
    return np.clip(np.searchsorted(nodes, x) - width // 2, 0, len(nodes) - width)


def _weights(nodes: Array, x: Array, width: int) -> Array:
    """(n, nodes) weights of the polynomials through the nearest nodes."""
    places = _first(nodes, x, width)[:, None] + np.arange(width)
    near, found = nodes[places], np.zeros((len(x), len(nodes)))
    for j in range(width):
        others = np.delete(near, j, axis=1)
        part = np.prod((x[:, None] - others) / (near[:, j, None] - others), axis=1)
        found[np.arange(len(x)), places[:, j]] = part
    return found


@functools.cache
def _table(shape: str) -> _Table:
    """The table of one cross-section."""
    rows = np.genfromtxt(Path(__file__).with_name("pyramids.csv"), delimiter=",", names=True, dtype=None, encoding="utf-8")
    rows = rows[rows["shape"] == shape]
    contrast, position, ratio = (np.unique(rows[name]) for name in ("contrast", "position", "a_over_h"))
    columns = [rows[name] for name in ("force", "force_error", "area", "area_error")]
    order = np.lexsort((rows["a_over_h"], rows["position"], rows["contrast"]))
    values = np.stack(columns, -1)[order].reshape(len(contrast), len(position), len(ratio), len(columns))
    return _Table((np.log(contrast), position, np.log(ratio)), values)


def shape_of(indenter: Any) -> str:
    """Return the cross-section of a pyramid."""
    if not isinstance(indenter, profiles.Profile):
        raise ArgumentTypeError(f"tip = {indenter!r}: it must be an indenter profile. Use Berkovich(), Vickers() or CubeCorner()")
    for kind, shape in _SHAPES:
        if isinstance(indenter, kind):
            return shape
    raise InvalidArgumentError(f"tip = {indenter!r}: it is no pyramid. Use Berkovich(), Vickers() or CubeCorner()")


def film_of(medium: Any) -> _Film:
    """Return the numbers of one elastic film that is bonded to an elastic half-space."""
    film, thickness, base = _parts(medium)
    if medium.model != "exact":
        raise InvalidArgumentError(f"model = {medium.model!r}: the table of pyramids holds for exact cones. Use model = 'exact'")
    for nu in (film.nu, base.nu):
        if not nu >= 0.0:
            raise InvalidArgumentError(f"nu = {nu:g}: the table of pyramids holds for 0 to 0.5. Fit the force as that of the cone")
    contrast = film.contact_modulus / base.contact_modulus
    film_g, base_g = ((1.0 - 2.0 * nu) / (1.0 - nu) for nu in (film.nu, base.nu))
    return _Film(contrast, (contrast * base_g - film_g + 1.0) / (1.0 + contrast), thickness)


def _parts(medium: Any) -> tuple[Elastic, float, Elastic]:
    """The film, its thickness, and the half-space."""
    if not isinstance(medium, media.Medium):
        raise ArgumentTypeError(f"medium = {medium!r}: it must be a medium. Use Coated(film, thickness, substrate)")
    if isinstance(medium, (media.Coated, media.Layered)) and medium.surface is None:
        layer, *others = medium._stack()
        base = medium.substrate
        is_plain = not others and isinstance(layer, media.Layer) and layer._is_plain()
        if is_plain and isinstance(layer.material, Elastic) and isinstance(base, Elastic):
            return layer.material, layer.thickness, base
    raise InvalidArgumentError(
        f"medium = {medium!r}: the table of pyramids holds for one bonded elastic film without stress on an elastic half-space. "
        "Use Coated(film, thickness, substrate); on a homogeneous body the force is 1.078 times that of the cone for three sides "
        "and 1.027 times for four"
    )


def check_range(film: _Film, a_over_h: ArrayLike = ()) -> None:
    """Raise an error outside the table."""
    low, high = CONTRAST
    if not low * (1.0 - _REACH) <= film.contrast <= high * (1.0 + _REACH):
        raise InvalidArgumentError(
            f"contrast = {film.contrast:.4g}: the table of pyramids holds for contact moduli of film over base from {low:g} to "
            f"{high:g}. Fit the force as that of the cone"
        )
    low, high = A_OVER_H
    for one in np.ravel(a_over_h):
        if not low * (1.0 - _REACH) <= one <= high * (1.0 + _REACH):
            raise InvalidArgumentError(
                f"a_over_h = {one:.4g}: the table of pyramids holds from {low:g} to {high:g}. Leave out other contact radii"
            )


def ratios(shape: str, film: _Film, a_over_h: Array) -> Array:
    """Return (n, 4): force and contact area over those of the cone, each with its error; the ends of the table beyond it."""
    contrast, position = float(np.clip(film.contrast, *CONTRAST)), float(np.clip(film.position, 0.0, 1.0))
    return _table(shape).at(contrast, position, np.clip(a_over_h, *A_OVER_H))


def pyramid_correction(tip: Any, medium: Any, a_over_h: ArrayLike) -> PyramidCorrection:
    """Return how a pyramid on a film differs from its equivalent cone.

    The numbers come from a table of boundary-element solutions, in which contact modulus ratio, second Dundurs parameter and a/h
    vary. Slopes of the faces, thickness and moduli do not matter apart from these.

    Parameters
    ----------
    tip : Berkovich, Vickers or CubeCorner
        The pyramid, of which the library takes the equivalent cone.
    medium : Coated or Layered
        One elastic film that is bonded to an elastic half-space, model "exact". The contact modulus of the film over that of the
        half-space is 0.01 to 100, Poisson's ratios are 0 to 0.5.
    a_over_h : array_like
        Contact radius of the cone over the thickness of the film, 0.1 to 10, any shape [1].

    Returns
    -------
    PyramidCorrection
        Ratios of force, film modulus and contact area with their errors, in the shape of `a_over_h`.

    Raises
    ------
    ArgumentTypeError
        `tip` or `medium` is of another type.
    InvalidArgumentError
        The tip is no pyramid, the body is not one film on a half-space, or a number is outside the table.

    Notes
    -----
    `film_modulus` compares at one depth: multiply the modulus that the equivalent cone finds there by it. `medium` is the body with
    the true modulus. `fit` finds that modulus from all depths with `pyramid_correction=True`.

    References
    ----------
    dundurs-1969

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(200e9, 0.3), 1e-6, mdr.Elastic(20e9, 0.3))
    >>> found = mdr.instruments.pyramid_correction(mdr.Berkovich(), film, 1.0)
    >>> print(f"{found.force:.3f} {found.film_modulus:.2f} {found.area:.2f}")
    1.137 0.61 0.60
    """
    shape, film = shape_of(tip), film_of(medium)
    given = numbers("a_over_h", a_over_h)
    check_range(film, given)
    found = ratios(shape, film, given.ravel())
    moduli = np.array([_film_modulus(tip, medium, a * film.thickness, row) for a, row in zip(given.ravel(), found, strict=True)])
    columns = np.column_stack([found[:, :2], moduli.reshape(-1, 2), found[:, 2:]]).T
    return PyramidCorrection(*(float(column[0]) if given.ndim == 0 else column.reshape(given.shape) for column in columns))


def with_film(medium: Any, factor: float) -> Any:
    """Return the body with another modulus of the film."""
    return medium._with_materials(lambda film: film.replace(E=film.E * factor), lambda base: base)


def _film_modulus(tip: Any, medium: Any, radius: float, row: Array) -> tuple[float, float]:
    """Modulus of the film over that of the cone with the force of the pyramid, and its error."""
    with silence():
        state = Contact(tip, medium).at_radius(radius)
        aim = math.log(row[0])

        def rest(x: float) -> float:
            other = Contact(tip, with_film(medium, math.exp(x))).at_depth(state.depth).force
            return math.log(float(other) / float(state.force)) - aim

        try:
            x, slope = _root(rest, -aim, aim)
        except MDRError:
            return math.nan, math.nan
    factor = math.exp(-x)
    return factor, factor * float(row[1] / row[0]) / slope


def _root(rest: Any, at_zero: float, first: float) -> tuple[float, float]:
    """Zero of a rising function by secants from 0, and its slope there."""
    x, y, other = 0.0, at_zero, math.copysign(max(abs(first), _LEAST), first)
    slope = 0.0
    for _ in range(_MOST):
        value = rest(other)
        slope = (value - y) / (other - x)
        if not slope > 0.0:
            break
        step = float(np.clip(-value / slope, -_STRIDE, _STRIDE))
        if abs(step) <= _SMALL:
            return other + step, slope
        x, y, other = other, value, other + step
        if abs(other) > _FARTHEST:
            break
    raise UnreachableError("the force of the pyramid does not determine a modulus of the film under the cone")
