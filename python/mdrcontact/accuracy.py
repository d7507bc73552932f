# SPDX-License-Identifier: GPL-3.0-or-later
"""How good each approximate model of a coated body is, measured against the exact solution."""

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
    """Relative errors of models against the exact solution; the arrays have the shape (models, modulus ratios, radii)."""

    models: tuple[str, ...]
    modulus_ratio: NDArray[np.float64]
    """E0/E1, Young's modulus of the coating over that of the substrate"""
    radius_ratio: NDArray[np.float64]
    """a/h, contact radius over coating thickness"""
    modulus_error: NDArray[np.float64]
    """E_eff(model)/E_eff(exact) - 1 at the same contact radius"""
    force_error: NDArray[np.float64]
    """F(model)/F(exact) - 1 at the same contact radius: the errors of E_eff and of zeta = 1 together"""


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
    """Errors of models of a coating on an elastic substrate.

    modulus_ratio : E0/E1 > 0, one or more
    radius_ratio : a/h > 0, one or more
    models : names as in `Coated`; None: all that allow an elastic substrate
    coating_nu, substrate_nu : Poisson's ratios
    indenter : its lengths in units of the coating thickness; None: a paraboloid, whose radius does not matter
    """
    known = [name for name, model in MODELS.items() if not model.needs_rigid_base and name != "exact"]
    chosen = tuple(known if models is None else models)
    for name in chosen:
        if name not in known:
            raise InvalidArgumentError(f"model = {name!r} is not allowed: {nearest(str(name), known)}")
    shape = Paraboloid(1.0) if indenter is None else indenter
    if not isinstance(shape, Profile):
        raise ArgumentTypeError(f"indenter = {indenter!r} is not allowed: it must be an indenter profile")
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
