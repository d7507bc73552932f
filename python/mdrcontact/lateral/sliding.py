# SPDX-License-Identifier: GPL-3.0-or-later
"""A virtual indenter: maps of force and apparent modulus, and sliding along a line.

See theory/lateral.md (4.1) and Popov (2014), section 6.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _scipy
from .._boundary import number, numbers, whole
from .._warn import Warned, collected, silence, warn_all
from ..contact import Contact
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Elastic
from ..medium import Homogeneous, TabulatedMedium
from ..profile import Profile
from .mapping import effective_map
from .structure import Structure
from .voxels import Voxels

Array = NDArray[np.float64]
_UNIT = Homogeneous(Elastic(0.75, 0.5))
"""A body with E* = 1."""


class _SlidingNumbers(NamedTuple):
    """The numbers of a `Sliding`."""

    x: Array
    """positions of the contact [length]"""
    depth: Array
    """d, indentation depth [length]"""
    force: Array
    """F, normal force [modulus length^2]"""
    radius: Array
    """a, contact radius [length]"""
    energy: Array
    """U, elastic energy [modulus length^3]"""
    lateral_force: Array
    """force of the medium on the indenter along x, -dU/dx at constant depth, -d(U - F d)/dx at constant load [modulus length^2]"""


class Sliding(_SlidingNumbers, Warned):
    """Contact that moves along a line without friction, from `slide`; arrays over x.

    Examples
    --------
    >>> ball = mdr.lateral.Ball((0.0, 0.0, 8e-6), 5e-6, mdr.Elastic(70e9, 0.22))
    >>> composite = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [ball])
    >>> path = mdr.lateral.slide(composite, mdr.Paraboloid(100e-6), np.linspace(-20e-6, 20e-6, 9), depth=200e-9, points=9)
    >>> print(f"{path.force.max():.3e} {path.force.min():.3e}")
    1.649e-02 4.128e-03
    """


class IndentationMap(NamedTuple):
    """Forces and apparent moduli at all cell centres, from `indentation_map`.

    The arrays have the shape (ny, nx).

    Examples
    --------
    >>> labels = np.zeros((4, 8, 8), dtype=np.uint8)
    >>> labels[:, 2:6, 2:6] = 1
    >>> cells = mdr.lateral.Voxels(labels, [mdr.Elastic(3e9, 0.3), mdr.Elastic(70e9, 0.3)], 1e-6)
    >>> found = mdr.lateral.indentation_map(cells, mdr.Paraboloid(10e-6), 100e-9, nodes=2)
    >>> print(found.force.shape, f"{found.force.max():.3e}")
    (8, 8) 8.403e-03
    """

    depth: float
    """d, the given depth [length]"""
    radius: float
    """a, contact radius, equal everywhere [length]"""
    force: Array
    """F at the depth [modulus length^2]"""
    apparent_modulus: Array
    """contact modulus of the homogeneous body with this force at this depth [modulus]"""
    stiffness: Array
    """dF/dd at the depth [modulus length]"""


def indentation_map(
    voxels: Voxels, indenter: Profile, depth: float, *, nodes: int = 8, threads: int = 0, progress: bool = False
) -> IndentationMap:
    """Compute force and apparent modulus at one depth at all cell centres.

    With the rule d = g(a) the force is `F = int_0^a 2 s E_eff(s, x, y) g'(s) ds`, a sum of `nodes` maps in one pass.

    Parameters
    ----------
    voxels : Voxels
        The structure.
    indenter : Profile
        The indenter.
    depth : float
        Indentation depth > 0 [length].
    nodes : int, optional
        Nodes of the quadrature, >= 1.
    threads : int, optional
        As in `effective_map`.
    progress : bool, optional
        True shows a progress bar.

    Returns
    -------
    IndentationMap
        Depth, contact radius, and maps of force, apparent modulus and stiffness.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    popov-2014, section 6

    Examples
    --------
    >>> labels = np.zeros((4, 8, 8), dtype=np.uint8)
    >>> labels[:, 2:6, 2:6] = 1
    >>> cells = mdr.lateral.Voxels(labels, [mdr.Elastic(3e9, 0.3), mdr.Elastic(70e9, 0.3)], 1e-6)
    >>> found = mdr.lateral.indentation_map(cells, mdr.Paraboloid(10e-6), 100e-9, nodes=2)
    >>> print(f"{found.apparent_modulus.max():.3e} {found.apparent_modulus.min():.3e}")
    6.302e+10 4.024e+09
    """
    d = number("depth", depth)
    if not 0.0 < d < np.inf:
        raise InvalidArgumentError(f"depth = {d!r}: it must be finite and greater than 0")
    ideal = Contact(indenter, _UNIT)
    with silence():
        state = ideal.at_depth(d)
        a, first = float(state.radius), float(ideal.at_depth(0.0).radius)
    u, w = np.polynomial.legendre.leggauss(whole("nodes", nodes, 1))
    u, w = 0.5 * (u + 1.0), 0.5 * w
    s = first + (a - first) * u**2
    radii, factors = np.array([a]), np.array([2.0 * a * (d - float(indenter.mdr(a)))])
    if a > first:
        radii = np.append(s, a)
        factors = np.append(4.0 * s * np.asarray(indenter.mdr_slope(s)) * (a - first) * u * w, factors)
    maps = effective_map(voxels, radii, threads=threads, progress=progress)
    # the same sum for E* = 1 instead of the exact force: a homogeneous body returns its own modulus exactly
    apparent = np.tensordot(factors, maps, 1) / factors.sum()
    return IndentationMap(d, a, apparent * float(state.force), apparent, 2.0 * a * maps[-1])


def slide(
    structure: Structure,
    indenter: Profile,
    x: ArrayLike,
    *,
    y: float = 0.0,
    depth: float | None = None,
    force: float | None = None,
    periodic: bool = False,
    points: int = 33,
) -> Sliding:
    """Move an indenter along a line at constant depth or under constant load.

    The line is y = constant. Give one of `depth` and `force`. It needs SciPy.

    Parameters
    ----------
    structure : Structure
        The structure.
    indenter : Profile
        The indenter.
    x : array_like
        Ascending positions, at least 4 [length]. They must resolve the structure: dU/dx follows from a cubic spline.
    y : float, optional
        Position of the line [length].
    depth : float, optional
        Constant depth > 0 [length].
    force : float, optional
        Constant force > 0 [modulus length^2].
    periodic : bool, optional
        True if x is one period without its end, evenly spaced; the spline is then periodic.
    points : int, optional
        Number of radii at which E_eff is sampled, over a factor of 1000 up to the largest contact radius.

    Returns
    -------
    Sliding
        Depth, force, contact radius, energy and lateral force at each position.

    Raises
    ------
    ArgumentTypeError
        Not exactly one of depth and force is given.
    InvalidArgumentError
        `x` does not ascend or is too short, or a number is outside its range.

    References
    ----------
    popov-2014, section 6

    Examples
    --------
    >>> half = mdr.lateral.HalfSpace((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), mdr.Elastic(6e9, 0.35))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [half])
    >>> path = mdr.lateral.slide(body, mdr.Paraboloid(100e-6), np.linspace(-10e-6, 10e-6, 9), depth=200e-9, points=9)
    >>> print(f"{path.force[0]:.3e} {path.force[-1]:.3e}")
    4.338e-03 7.893e-03
    """
    _scipy.require()
    from scipy.interpolate import CubicSpline

    places = numbers("x", x)
    if places.ndim != 1 or places.size < 4 or not np.all(np.diff(places) > 0.0):
        raise InvalidArgumentError("x: it must be ascending, of one dimension, with at least 4 entries")
    if (depth is None) == (force is None):
        raise ArgumentTypeError("give exactly one of depth and force")
    value = number("depth", depth) if force is None else number("force", force)
    if not 0.0 < value < np.inf:
        raise InvalidArgumentError(f"depth or force = {value!r}: it must be finite and greater than 0")
    largest = _largest_radius(structure, indenter, places, number("y", y), depth, force)
    radii = np.geomspace(1e-3 * largest, largest, points)
    moduli = np.asarray(structure.modulus(places[:, None], y, radii))
    # contacts begin at radius 0: below the smallest sample E_eff is constant
    radii, moduli = np.append(1e-9 * largest, radii), np.hstack([moduli[:, :1], moduli])
    with collected() as found:
        states = np.array([_state(indenter, TabulatedMedium(radii, e), depth, force) for e in moduli])
    # one of each kind: the first place that has it
    doubts = list({caution.kind: caution for caution in reversed(found)}.values())
    warn_all(doubts)
    d, F, a, U = states.T
    potential = U if force is None else U - F * d
    if periodic:
        period = places[-1] - places[0] + (places[1] - places[0])
        spline = CubicSpline(np.append(places, places[0] + period), np.append(potential, potential[0]), bc_type="periodic")
    else:
        spline = CubicSpline(places, potential)
    return Sliding(places, d, F, a, U, -spline(places, 1))._carrying(doubts)


def elastic_energy(contact: Contact, depth: float) -> float:
    """U = int_0^d F dd [modulus length^3]."""
    u, w = np.polynomial.legendre.leggauss(24)
    u, w = 0.5 * (u + 1.0), 0.5 * w
    # forces begin as powers of depth, often broken ones: d u^2
    return float(np.asarray(contact.at_depth(depth * u**2).force) @ (2.0 * depth * u * w))


def _state(indenter: Profile, medium: TabulatedMedium, depth: float | None, force: float | None) -> list[float]:
    contact = Contact(indenter, medium)
    state = contact.at_depth(depth) if depth is not None else contact.at_force(0.0 if force is None else force)
    d = float(state.depth)
    return [d, float(state.force), float(state.radius), elastic_energy(contact, d)]


@silence()
def _largest_radius(structure: Structure, indenter: Profile, x: Array, y: float, depth: float | None, force: float | None) -> float:
    """A contact radius that no place on the line exceeds."""
    if depth is not None:
        return 1.0001 * float(Contact(indenter, _UNIT).at_depth(depth).radius)
    assert force is not None
    # the softest material along the line, at the scale of the contact itself, and a margin: the radius follows
    modulus = float(np.min(_sampled_moduli(structure, x, y)))
    widest = Contact(indenter, TabulatedMedium([1e-300, 1.0, 1e300], [modulus] * 3))
    return 1.0001 * float(widest.at_force(force).radius)


def _sampled_moduli(structure: Structure, x: Array, y: float) -> Any:
    span = x[-1] - x[0]
    places = x[:: max(1, len(x) // 16)]
    return 0.5 * np.asarray(structure.modulus(places[:, None], y, np.geomspace(1e-3 * span, span, 7)))
