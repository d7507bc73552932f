# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of the approximate models of a coated body against the exact solution."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._boundary import number, row
from ._choices import nearest
from ._warn import silence
from .contact import Contact
from .errors import ArgumentTypeError, InvalidArgumentError
from .material import Elastic
from .medium import Coated
from .medium.models import MODELS
from .profile import Paraboloid, Profile


class AccuracyMap(NamedTuple):
    """Relative errors of models against the exact solution, from `accuracy_map`.

    The arrays of errors have the shape (models, modulus ratios, radii).

    Examples
    --------
    >>> errors = mdr.accuracy_map(2.0, [0.1, 1.0], ["gao", "bec"])
    >>> print(errors.modulus_error.shape, np.round(100.0 * errors.force_error[0, 0], 1))
    (2, 1, 2) [ -2.9 -11.7]
    """

    models: tuple[str, ...]
    """names of the models"""
    modulus_ratio: NDArray[np.float64]
    """E0/E1, Young's modulus of the coating over that of the substrate [1]"""
    radius_ratio: NDArray[np.float64]
    """a/h, contact radius over coating thickness [1]"""
    modulus_error: NDArray[np.float64]
    """E_eff(model)/E_eff(exact) - 1 at equal contact radius [1]"""
    force_error: NDArray[np.float64]
    """F(model)/F(exact) - 1 at equal contact radius, the errors of E_eff and of zeta = 1 together [1]"""


@silence()
def accuracy_map(
    modulus_ratio: ArrayLike,
    radius_ratio: ArrayLike,
    models: Iterable[str] | None = None,
    *,
    coating_nu: float = 0.3,
    substrate_nu: float = 0.3,
    indenter: Profile | None = None,
) -> AccuracyMap:
    """Compute the errors of models of a coating on an elastic substrate.

    Parameters
    ----------
    modulus_ratio : array_like
        E0/E1 > 0, one or more [1].
    radius_ratio : array_like
        a/h > 0, one or more [1].
    models : iterable of str, optional
        Names as in `Coated`; None is all models that support an elastic substrate.
    coating_nu : float, optional
        Poisson's ratio of the coating [1].
    substrate_nu : float, optional
        Poisson's ratio of the substrate [1].
    indenter : Profile, optional
        Indenter with lengths in units of the coating thickness. None is a paraboloid, whose radius has no influence.

    Returns
    -------
    AccuracyMap
        Errors of E_eff and of the force.

    Raises
    ------
    InvalidArgumentError
        A model is unknown, or a number is outside its range.
    ArgumentTypeError
        `indenter` is not a profile.

    Examples
    --------
    >>> errors = mdr.accuracy_map([0.5, 2.0], 1.0, ["gao"])
    >>> print(np.round(100.0 * errors.modulus_error[0, :, 0], 1))
    [10.9 10.3]
    """
    known = [name for name, model in MODELS.items() if not model.needs_rigid_base and name != "exact"]
    chosen = tuple(known if models is None else models)
    for name in chosen:
        if name not in known:
            raise InvalidArgumentError(f"model = {name!r}: {nearest(str(name), known)}")
    shape = Paraboloid(1.0) if indenter is None else indenter
    if not isinstance(shape, Profile):
        raise ArgumentTypeError(f"indenter = {indenter!r}: it must be an indenter profile")
    ratios = np.array(row("modulus_ratio", np.atleast_1d(np.asarray(modulus_ratio))))
    a = np.array(row("radius_ratio", np.atleast_1d(np.asarray(radius_ratio))))
    substrate, nu = Elastic(1.0, number("substrate_nu", substrate_nu)), number("coating_nu", coating_nu)
    modulus_error = np.empty((len(chosen), len(ratios), len(a)))
    force_error = np.empty_like(modulus_error)
    for i, ratio in enumerate(ratios):
        exact = Coated(Elastic(float(ratio), nu), 1.0, substrate, "exact")
        modulus, force = exact.modulus(a), Contact(shape, exact).at_radius(a).force
        for j, name in enumerate(chosen):
            body = exact.with_model(name)
            modulus_error[j, i] = body.modulus(a) / modulus - 1.0
            force_error[j, i] = Contact(shape, body).at_radius(a).force / force - 1.0
    return AccuracyMap(chosen, ratios, a, modulus_error, force_error)
