# SPDX-License-Identifier: GPL-3.0-or-later
"""Largest stresses inside a coated body and their positions."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _layout
from ._boundary import call, native, number
from ._choices import code
from ._warn import Warned
from .errors import InvalidArgumentError
from .interior import BODIES, layer_energies
from .material import RIGID, SMOOTH
from .medium import Coated, Homogeneous, Layered, Pair

_OF_LAYER = _layout.VON_MISES, _layout.TRESCA, _layout.TENSION
"""Quantities of a layer in the order of LayerMaxima."""


class Maximum(NamedTuple):
    """Largest stress and its position.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.3))
    >>> state = mdr.Contact(mdr.Sphere(10e-6), film).at_radius(0.5e-6)
    >>> most = state.critical().layers[0].von_mises
    >>> print(f"{most.value:.3e} {most.r:.1e} {most.z:.2e}")
    8.974e+09 0.0e+00 2.38e-07
    """

    value: float
    """the stress, negative if only compression occurs [modulus]"""
    r: float
    """distance from the axis [length]"""
    z: float
    """depth below the surface [length]"""
    angle: float
    """azimuth from the direction of sliding, 0 or pi; 0 without friction [radian]"""


class LayerMaxima(NamedTuple):
    """Largest stresses in one layer, from `State.critical`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.3))
    >>> state = mdr.Contact(mdr.Sphere(10e-6), film).at_radius(0.5e-6)
    >>> coating, substrate = state.critical().layers
    >>> print(f"{coating.tresca.value:.3e} {substrate.tresca.value:.3e} {coating.energy:.3e}")
    4.487e+09 1.231e+09 5.719e-11
    """

    von_mises: Maximum
    """largest von Mises stress [modulus]"""
    tresca: Maximum
    """largest shear stress (s_1 - s_3)/2 [modulus]; twice this is Tresca's equivalent stress"""
    tension: Maximum
    """largest principal stress s_1 [modulus]"""
    energy: float
    """elastic energy without friction [modulus length^3]; 0 in a rigid base"""


class InterfaceMaxima(NamedTuple):
    """Largest tractions at one interface, from `State.critical`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.3))
    >>> state = mdr.Contact(mdr.Sphere(10e-6), film).at_radius(0.5e-6)
    >>> interface = state.critical().interfaces[0]
    >>> print(f"{interface.z:.1e} {interface.shear.value:.3e}")
    1.0e-06 6.674e+08
    """

    z: float
    """depth of the interface [length]"""
    shear: Maximum
    """largest shear traction, sqrt(s_rz^2 + s_tz^2) [modulus]"""
    tension: Maximum
    """largest normal stress s_zz [modulus]"""


class _CriticalNumbers(NamedTuple):
    """The numbers of a `Critical`."""

    layers: tuple[LayerMaxima, ...]
    """largest stresses of each layer from top to bottom, the half-space last"""
    interfaces: tuple[InterfaceMaxima, ...]
    """largest tractions of each interface from top to bottom"""
    surface: Maximum
    """largest principal stress on the free surface a <= r <= 3 a, the tension that opens ring cracks [modulus]"""


class Critical(_CriticalNumbers, Warned):
    """Largest stresses in a body and their positions, from `State.critical`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.3))
    >>> state = mdr.Contact(mdr.Sphere(10e-6), film).at_radius(0.5e-6)
    >>> found = state.critical()
    >>> print(len(found.layers), len(found.interfaces), f"{found.surface.value:.3e}")
    2 1 1.897e+09
    """


def layers_of(medium: Any, body: str = "lower") -> tuple[list[float], bool]:
    """Thicknesses from top to bottom [length], and whether the base is rigid."""
    if isinstance(medium, Pair):
        return layers_of(medium.upper if body == "upper" else medium.lower)
    if isinstance(medium, (Homogeneous, Coated, Layered)):
        return [thickness for _, thickness in medium._stack()], getattr(medium, "substrate", None) in (RIGID, SMOOTH)
    if medium is RIGID:
        raise InvalidArgumentError(f"body = {body!r}: it is rigid")
    raise InvalidArgumentError(f"a {type(medium).__name__} has no layers. Use interior(...) for its stresses")


def critical(state: Any, body: str, friction: float) -> Critical:
    """Return the result of `State.critical`."""
    contact, which, mu = state._owner, code("body", body, BODIES), number("friction", friction)
    found = np.zeros(call(native.load_critical, state._load, which, mu, 0, None), _layout.maximum)
    call(native.load_critical, state._load, which, mu, len(found), found)
    doubts = contact._doubts.inside_or_refused(state, body)
    contact._reported.report(doubts)
    maxima = {(int(one["quantity"]), int(one["place"])): maximum(one) for one in found}
    layers = [i for kind, i in maxima if kind == _layout.VON_MISES]
    interfaces = [(maxima[kind, i], i) for kind, i in maxima if kind == _layout.INTERFACE_SHEAR]
    energies = layer_energies(state, body, len(layers))
    return Critical(
        tuple(LayerMaxima._make([*(maxima[kind, i] for kind in _OF_LAYER), float(energies[i])]) for i in layers),
        tuple(InterfaceMaxima(shear.z, shear, maxima[_layout.INTERFACE_TENSION, i]) for shear, i in interfaces),
        maxima[_layout.FREE_SURFACE_TENSION, 0],
    )._carrying(doubts)


def maximum(found: Any) -> Maximum:
    """Maximum from a structure of the library."""
    return Maximum(*(float(found[name]) for name in Maximum._fields))
