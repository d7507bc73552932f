# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators of tamaas with the compliance of a layered body; docs/rough.md."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from ..errors import ArgumentTypeError, InvalidArgumentError
from ..medium.base import Medium
from ._grid import Array, Response, engine, folded

__all__ = ["layered_operator", "set_layered"]

_engine = engine("tamaas", __name__)
_OWN = "Westergaard::neumann"
_ORIGINS: WeakKeyDictionary[Any, list[Any]] = WeakKeyDictionary()
"""Models that made the operators of another one, which tamaas does not keep alive."""


def layered_operator(
    model: Any,
    body: Medium,
    name: str = "layered",
    *,
    periodic: bool = False,
    mean: str | float = "layers",
    omega: float | None = None,
    drainage: str | None = None,
) -> Any:
    """Add an operator for normal contacts with a layered body to a model.

    Parameters
    ----------
    model : tamaas.Model
        Model of type basic_2d; if the operator is periodic, also basic_1d for line contacts.
    body : Medium
        Body with a compliance: homogeneous, coated, layered or graded, or a pair of these.
    name : str, optional
        Name of the operator, for `solver.setIntegralOperator(name)`.
    periodic : bool, optional
        Whether the cell repeats. Otherwise it is one contact without neighbours.
    mean : {"layers", "isolated"} or float, optional
        C(0) of a periodic cell, as of `mdrcontact.interop.contactmechanics.LayeredSubstrate` [length/modulus].
    omega : float, optional
        Of a relaxing body: 0 for the relaxed one [1/time].
    drainage : {"surface", "sealed"}, optional
        Of a poroelastic body in a periodic cell.

    Returns
    -------
    tamaas.IntegralOperator
        The operator, from pressure to displacement, which lives as long as the model.

    Raises
    ------
    InvalidArgumentError
        The type of the model is another one, the compliance is complex or not known, or an argument is outside its range.

    Notes
    -----
    Set E and nu of the model before: tamaas computes its own operator again if they change.

    Examples
    --------
    >>> import tamaas
    >>> from mdrcontact.interop.tamaas import layered_operator
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.30))
    >>> model = tamaas.Model(tamaas.model_type.basic_2d, [4e-6, 4e-6], [64, 64])
    >>> print(layered_operator(model, film).kind)
    kind.neumann
    """
    kinds = _engine.model_type
    response = Response(body, omega, drainage)
    if periodic:
        points, sizes = _grid_of(model, kinds.basic_1d, kinds.basic_2d)
        origin = _engine.Model(model.type, sizes, points)
        origin.solveNeumann()
        model.operators[name] = origin.operators[_OWN]
        _ORIGINS.setdefault(model, []).append(origin)
        kernel = response.waves([np.abs(axis) for axis in _waves(points, sizes)], response.mean(mean, sizes))
    else:
        if mean != "layers":
            raise InvalidArgumentError(f"mean = {mean!r}: one contact without neighbours has no C(0). Omit it or set periodic=True")
        points, sizes = _grid_of(model, kinds.basic_2d)
        steps = [size / n for size, n in zip(sizes, points, strict=True)]
        axes = [step * folded(2 * n, 0, 2 * n) for step, n in zip(steps, points, strict=True)]
        # tamaas divides what this operator gives by its modulus
        kernel = model.E_star * np.fft.rfft2(response.pixels(axes, steps))
        _engine.ModelFactory.registerNonPeriodic(model, name)
    model.operators[name]["influence"][...] = kernel
    return model.operators[name]


def set_layered(
    model: Any, body: Medium, *, mean: str | float = "layers", omega: float | None = None, drainage: str | None = None
) -> None:
    """Set the own periodic operator of a model to a layered body, with friction.

    Parameters
    ----------
    model : tamaas.Model
        Model of type surface_1d or surface_2d, whose tractions have all directions.
    body : Medium
        As of `layered_operator`.
    mean : {"layers", "isolated"} or float, optional
        C(0) of the normal direction, as of `layered_operator` [length/modulus]. In the other directions it is that of the layers on
        a rigid base, and 0 on other bases, whose displacement as a whole is not determined.
    omega : float, optional
        As of `layered_operator`.
    drainage : {"surface", "sealed"}, optional
        As of `layered_operator`.

    Raises
    ------
    InvalidArgumentError
        The type of the model is another one, the compliance is complex or not known, or an argument is outside its range.

    Notes
    -----
    The solvers with friction use the operator: Kato, PolonskyKeerTan, BeckTeboulle and Condat. Set E and nu of the model before, as
    for `layered_operator`.

    Examples
    --------
    >>> import tamaas
    >>> from mdrcontact.interop.tamaas import set_layered
    >>> film = mdr.Layered([(mdr.Elastic(1e9, 0.3), 3e-4)], mdr.RIGID)
    >>> model = tamaas.Model(tamaas.model_type.surface_2d, [4e-3, 4e-3], [64, 64])
    >>> set_layered(model, film)
    >>> print(model.operators["Westergaard::neumann"]["influence"].shape)
    (64, 33, 9)
    """
    kinds = _engine.model_type
    points, sizes = _grid_of(model, kinds.surface_1d, kinds.surface_2d)
    response = Response(body, omega, drainage)
    axes = _waves(points, sizes)
    folds = [np.abs(axis) for axis in axes]
    normal = response.waves(folds, response.mean(mean, sizes))
    of_cell = response.shear_mean()
    shear, twist = (response.waves(folds, of_cell, load) for load in ("shear", "twist"))
    tensor = _tensor(axes, normal, 2.0 * shear - twist, twist, response.waves(folds, 0.0, "coupling"))
    model.solveNeumann()
    influence = model.operators[_OWN]["influence"]
    influence[...] = tensor.reshape(influence.shape)


def _grid_of(model: Any, *kinds: Any) -> tuple[list[int], list[float]]:
    """Points and sizes of a model of one of some types."""
    if not isinstance(model, _engine.Model):
        raise ArgumentTypeError(f"model = {model!r}: it must be a tamaas.Model")
    if model.type not in kinds:
        names = " or ".join(kind.name for kind in kinds)
        other = "set_layered" if "surface" in model.type.name else "layered_operator"
        raise InvalidArgumentError(f"model = {model.type.name}: its type must be {names}. Use one of these, or {other}")
    return list(model.boundary_shape), list(model.boundary_system_size)


def _waves(points: list[int], sizes: list[float]) -> list[Array]:
    """Wavenumbers along the axes of a model, of which the last one is halved."""
    axes = [2.0 * np.pi * np.fft.fftfreq(n, size / n) for n, size in zip(points, sizes, strict=True)]
    return [*axes[:-1], np.abs(axes[-1][: points[-1] // 2 + 1])]


def _tensor(axes: list[Array], normal: Array, along: Array, twist: Array, coupling: Array) -> NDArray[np.complex128]:
    """Displacements along the axes and into the body by tractions in these directions."""
    count = len(axes)
    waves = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    k = np.linalg.norm(waves, axis=-1, keepdims=True)
    n = np.divide(waves, k, out=np.zeros_like(waves), where=k > 0.0)
    tensor = np.zeros((*normal.shape, count + 1, count + 1), dtype=complex)
    in_plane = n[..., :, None] * n[..., None, :] * (along - twist)[..., None, None]
    tensor[..., :count, :count] = in_plane + np.eye(count) * twist[..., None, None]
    tensor[..., :count, count] = 1j * n * coupling[..., None]
    tensor[..., count, :count] = -tensor[..., :count, count]
    tensor[..., count, count] = normal
    return tensor
