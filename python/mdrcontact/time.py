# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of contacts with viscoelastic bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import ComplexOrArray, FloatOrArray, Handle, check, evaluate, native, number, one_path, together, words_of
from ._progress import marching
from .errors import ArgumentTypeError, InvalidArgumentError
from .material import RIGID, SMOOTH, Elastic, PowerLawRheology, Viscoelastic
from .profile import FlatPunch, Profile
from .progress import Progress

if TYPE_CHECKING:
    from .medium.layer import Interface

__all__ = ["History"]


class History(NamedTuple):
    """Path of a contact in time; arrays of one length.

    `Contact.history` and `poroelastic.history` return it.

    Examples
    --------
    >>> polymer = mdr.Viscoelastic(1e6, [(9e6, 1.0)], nu=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(polymer))
    >>> path = contact.history([0.0, 0.1, 10.0], depth=[0.0, 1e-6, 1e-6])
    >>> print(np.round(path.force * 1e6, 3))
    [  0.    162.753  16.873]
    """

    time: NDArray[np.float64]
    """the times of the path [time]"""
    depth: NDArray[np.float64]
    """d, indentation depth [length]"""
    radius: NDArray[np.float64]
    """a, contact radius, 0 if the bodies are separated [length]"""
    force: NDArray[np.float64]
    """F, normal force [modulus length^2]"""

    @property
    def work(self) -> float:
        """Work of the force along the path, int F dd [modulus length^3].

        It follows from the trapezoidal rule. Over a closed path it is the energy lost in the body.
        """
        return float(np.sum(0.5 * (self.force[1:] + self.force[:-1]) * np.diff(np.maximum(self.depth, 0.0))))


_GIVEN = words_of(_layout.DEPTH, _layout.FORCE, _layout.RADIUS)


def history(
    contact: Handle,
    time: ArrayLike,
    depth: ArrayLike | None,
    force: ArrayLike | None,
    radius: ArrayLike | None,
    tolerance: float,
    progress: bool | Progress,
) -> History:
    """The history of a contact's handle."""
    given, t, values = one_path(time, depth=depth, force=force, radius=radius)
    if not t.size:
        return History(t, t.copy(), t.copy(), t.copy())
    accuracy = number("tolerance", tolerance)
    with marching(t.size, progress):
        status, *columns = native.contact_history(contact, _GIVEN[given], accuracy, t, values)
    check(status)
    return History(t, *columns)


def dynamic_stiffness(
    contact: Any, omega: ArrayLike, radius: ArrayLike | None, depth: ArrayLike | None, force: ArrayLike | None
) -> ComplexOrArray:
    """See `Contact.dynamic_stiffness`."""
    given = {name: value for name, value in (("radius", radius), ("depth", depth), ("force", force)) if value is not None}
    if len(given) > 1:
        raise ArgumentTypeError(f"give only one of radius, depth and force, not {' and '.join(given)}")
    if radius is None:
        radius = _radius(contact, given)
    w, a = together(omega=omega, radius=radius)
    check_radius(contact.indenter, radius)
    if not w.size:
        return np.empty(w.shape, np.complex128)
    # equal frequencies side by side
    order = np.argsort(w, axis=None, kind="stable")
    status, storage, loss = native.contact_dynamic_stiffness(contact._handle, w.ravel()[order], a.ravel()[order])
    check(status, single=not w.ndim)
    values = np.empty(w.size, np.complex128)
    values[order] = storage + 1j * loss
    return values.reshape(w.shape) if w.ndim else complex(values[0])


def step(contact: Any, kind: int, time: ArrayLike, radius: float | None) -> FloatOrArray:
    """See `Contact.relaxation` and `Contact.creep`."""
    a = number("radius", _radius(contact, {}) if radius is None else radius)
    check_radius(contact.indenter, a)
    return evaluate("time", time, lambda t: native.contact_step_response(contact._handle, kind, a, t))


def check_radius(indenter: Profile, radius: ArrayLike) -> None:
    """Raise an error if a contact radius differs from the radius of the flat punch."""
    if isinstance(indenter, FlatPunch) and not np.allclose(radius, indenter.radius, rtol=1e-12, atol=0.0):
        own = f"the contact radius of a flat punch is its radius, {indenter.radius!r}"
        raise InvalidArgumentError(f"radius = {radius!r}: {own}. Leave it out")


def refuse_drainage(drainage: str | None) -> None:
    """Raise if a body without pores has a drainage."""
    if drainage is not None:
        raise ArgumentTypeError(f"drainage = {drainage!r}: the body is not poroelastic")


def _radius(contact: Any, given: dict[str, ArrayLike]) -> Any:
    """The contact radius of a flat punch, or of the relaxed body at a depth or force."""
    if isinstance(contact.indenter, FlatPunch):
        return contact.indenter.radius
    if not given:
        raise ArgumentTypeError("radius is missing: only a flat punch determines it. Give the contact radius")
    resting = contact.replace(medium=_at_rest(contact.medium, needs_modulus="force" in given))
    return (resting.at_force(given["force"]) if "force" in given else resting.at_depth(given["depth"])).radius


def _at_rest(medium: Any, needs_modulus: bool) -> Any:
    """The relaxed body. A power law relaxes without end: under a force it has no relaxed state; at a depth the radius follows from
    the ratios of the moduli, in which what relaxes less is rigid at last, springs too."""
    below = getattr(medium, "material", getattr(medium, "substrate", None))
    materials = [*(material for material, _ in medium._stack()), below]
    exponent = max((m.exponent for m in materials if isinstance(m, PowerLawRheology)), default=0.0)
    is_endless = exponent > 0.0 and not needs_modulus

    def relaxed(material: Any) -> Any:
        if not is_endless:
            return material.relaxed if isinstance(material, (Viscoelastic, PowerLawRheology)) else material
        if isinstance(material, PowerLawRheology) and material.exponent == exponent:
            return Elastic(2.0 * material.modulus * material.time**exponent * (1.0 + material.nu), material.nu)
        return material if material is SMOOTH else RIGID

    def layer(material: Any) -> Any:
        rest = relaxed(material)
        if rest is RIGID:
            raise InvalidArgumentError(
                "a depth: a layer that does not relax, or relaxes by a smaller power, becomes rigid next to a "
                "power law in the end; give the contact radius, radius="
            )
        return rest

    def interface(below: Interface | None) -> Interface | None:
        return None if below is None else below.replace(normal=None, tangential=0.0 if below.tangential == 0.0 else None)

    return medium._with_materials(layer, relaxed, interface if is_endless else None)
