# SPDX-License-Identifier: GPL-3.0-or-later
"""States of a contact and their fields (theory/paper.md (4.1), (4.2))."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, critical, interior, sensitivity
from ._boundary import FloatOrArray, Handle, call, evaluate, native, number, numbers, together
from ._choices import code
from ._text import html_table
from ._text import number as number_text
from ._warn import texts_of
from .critical import Critical
from .errors import ArgumentTypeError
from .interior import BODIES, Interior

if TYPE_CHECKING:
    from .panels import Figure

_SHOWN = 20
"""States in a table of a notebook."""
_DISPLACEMENTS = {"lower": _layout.DISPLACEMENT_LOWER, "upper": _layout.DISPLACEMENT_UPPER}


class Columns(dict[str, NDArray[np.float64]]):
    """Columns of one length by their names, as `pandas.DataFrame` takes them; `units` has the unit of each name."""

    units: ClassVar[dict[str, str]] = {
        "depth": "length",
        "radius": "length",
        "force": "modulus length^2",
        "stiffness": "modulus length",
        "slope": "modulus length",
        "punch_depth": "length",
        "zone_radius": "length",
    }
    """in the units of length and modulus in which the contact is described"""


@dataclass(frozen=True, init=False, repr=False, eq=False)
class State:
    """State of a contact, as `Contact.at_depth` returns it, with its fields.

    Several states are `States`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> state = mdr.Contact(mdr.Sphere(10e-6), film).at_depth(50e-9)
    >>> print(f"{state.force:.4e} {state.radius:.4e} {state.stiffness:.4e}")
    5.6227e-03 7.7873e-07 1.8262e+05
    >>> print(f"{state.pressure(0.0):.4e}")
    4.6080e+09
    """

    depth: FloatOrArray
    """d, indentation depth, positive into the medium [length]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    force: FloatOrArray
    """F, normal force, positive in compression [modulus length^2]"""
    stiffness: FloatOrArray
    """k = 2 a E_eff(a), dF/dd at constant contact radius [modulus length]; with adhesion dF/dd is `slope`"""
    punch_depth: FloatOrArray
    """depth beyond that of the non-adhesive state of this radius [length]: 0 without adhesion, negative with it, the whole depth
    under a flat punch
    """
    zone_radius: FloatOrArray
    """c, outer radius of the cohesive zone [length]: the bodies attract each other at a < r < c; 0 without a cohesive stress. With
    radius 0 they attract each other without contact
    """
    contact: ClassVar[Any] = None
    """the contact of the state; None for numbers without fields"""

    def __new__(
        cls,
        depth: FloatOrArray,
        radius: FloatOrArray,
        force: FloatOrArray,
        stiffness: FloatOrArray,
        punch_depth: FloatOrArray = 0.0,
        zone_radius: FloatOrArray = 0.0,
        contact: Any = None,
    ) -> State:
        return state_of((depth, radius, force, stiffness, punch_depth, zone_radius), contact)

    def __repr__(self) -> str:
        numbers = ", ".join(f"{name}={value!r}" for name, value in zip(NAMES, self._numbers(), strict=True))
        return f"{type(self).__name__}({numbers})"

    def _repr_html_(self) -> str:
        """The numbers in a notebook, in the units of the contact."""
        values = self._rows().reshape(-1, len(NAMES))
        titles = [f"{name.replace('_', ' ')} [{Columns.units[name]}]" for name in NAMES]
        rows = [[number_text(float(value)) for value in row] for row in values[:_SHOWN]]
        return html_table([titles, *rows]) + (f"<p>{_SHOWN} of {len(values)} states</p>" if len(values) > _SHOWN else "")

    def __reduce__(self) -> tuple[Any, ...]:
        return state_of, (self._numbers(), self.contact)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, State):
            return NotImplemented
        pairs = zip(self._numbers(), other._numbers(), strict=True)
        return self.contact == other.contact and all(np.array_equal(one, two) for one, two in pairs)

    def __hash__(self) -> int:
        return hash((self._numbers(), self.contact))

    @property
    def slope(self) -> FloatOrArray:
        """dF/dd along the branch of equilibria [modulus length].

        The radius changes with depth on this branch. Without adhesion it is `stiffness`. With adhesion it is smaller: for a
        paraboloid on a half-space k/3 at depth 0, 0 at pull-off under force, infinite at pull-off under depth, and negative between
        the two. It has about eight significant digits, seven with a cohesive stress. At a vertical wall, as under a flat punch, the
        radius is constant and it is `stiffness`.
        """
        rows = self._rows()
        found = call(native.contact_slope, self._owner._handle, rows.reshape(-1, len(NAMES))) if rows.size else np.empty(0)
        return np.reshape(found, rows.shape[:-1]) if rows.ndim > 1 else float(found[0])

    def table(self) -> Columns:
        """Return the numbers as named columns, a row for each state, with `slope`.

        Returns
        -------
        dict
            Columns of one length, as `pandas.DataFrame` takes them; the attribute `units` has the unit of each.

        Examples
        --------
        >>> contact = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
        >>> table = contact.at_depth([1e-8, 2e-8]).table()
        >>> print(table["force"].shape, table.units["force"])
        (2,) modulus length^2
        """
        values = dict(zip(NAMES, self._rows().reshape(-1, len(NAMES)).T, strict=True)) | {"slope": np.ravel(self.slope)}
        return Columns({name: np.array(values[name]) for name in Columns.units})

    def plot(self) -> Figure:
        """Return pressure and displaced surface as a figure.

        The figure of several states shows force, contact radius and stiffness over depth. Numbers are taken as SI.

        Returns
        -------
        Figure
            The figure.

        Raises
        ------
        InvalidArgumentError
            One state is without contact.

        Examples
        --------
        >>> contact = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
        >>> contact.at_depth(1e-8).plot().title
        'd = 10 nm, F = 312.61 uN, a = 316.23 nm'
        """
        from .panels import contacts

        return contacts.of_state(self)

    def pressure(self, r: ArrayLike) -> FloatOrArray:
        """Return the contact pressure p(r), equation (6).

        Parameters
        ----------
        r : array_like
            Radii, 0 <= r <= a, or up to c with a cohesive stress, any shape [length]. Of several states the shape begins with
            theirs.

        Returns
        -------
        float or ndarray
            p, in the shape of `r` [modulus]. It is infinite at the edge of a flat punch and at the apex of a cone, and minus
            infinity at an adhesive edge. With a cohesive stress it is finite at a and -sigma_0 at a < r < c.

        Raises
        ------
        DomainError
            A radius is larger than the contact radius.
        """
        return self._field(_layout.PRESSURE, "r", r)

    def displacement(self, r: ArrayLike, body: str | None = None) -> FloatOrArray:
        """Return the surface displacement u(r), positive into the medium.

        Inside the contact it is d - f(r); outside it is the free surface, with the neck of an adhesive contact.

        Parameters
        ----------
        r : array_like
            Radii >= 0, any shape [length]. Of several states the shape begins with theirs.
        body : {"lower", "upper"}, optional
            Body of a pair; the displacement is positive into this body. None is the sum of both. u(0) of each body is its part of
            the approach. If the lower surface is flat, "lower" is the shape of the interface for r <= a.

        Returns
        -------
        float or ndarray
            u, in the shape of `r` [length].

        Raises
        ------
        InvalidArgumentError
            The displacement of the medium is not known.
        """
        field = _layout.DISPLACEMENT if body is None else code("body", body, _DISPLACEMENTS)
        return self._field(field, "r", r)

    def line_load(self, x: ArrayLike) -> FloatOrArray:
        """Return the line load q(x) of the one-dimensional springs, equations (5), (21).

        Parameters
        ----------
        x : array_like
            Positions, 0 <= x <= a, or up to the end of a cohesive zone, any shape [length]. Of several states the shape begins with
            theirs.

        Returns
        -------
        float or ndarray
            q, in the shape of `x` [modulus length].

        Raises
        ------
        DomainError
            A position is larger than the contact radius.
        """
        return self._field(_layout.LINE_LOAD, "x", x)

    def energy(self, body: str | None = None) -> FloatOrArray:
        """Return the elastic energy of each state.

        It is the work of the force from initial contact. With adhesion the energy gained by the surfaces, pi a^2 work_of_adhesion,
        is additional. With a cohesive stress the energy of the zone is int (sigma_0 h - gamma) dA, with its gap h.

        Parameters
        ----------
        body : {"lower", "upper"}, optional
            Body of a pair; None is both.

        Returns
        -------
        float or ndarray
            Energy, in the shape of the states [modulus length^3].

        Raises
        ------
        InvalidArgumentError
            The energy of the medium is not known.
        """
        if body is not None:
            code("body", body, BODIES)
        found, shape = [], np.shape(self.depth)
        for load in self._loads():
            energies = call(native.load_energy, load)
            found.append(float(sum(energies) if body is None else energies[body == "upper"]))
        return np.reshape(found, shape) if shape else found[0]

    def lowest_pressure(self) -> tuple[float, float]:
        """Return the smallest pressure of one state without adhesion, and its radius.

        If it is negative, the contact is not a single contact area, and the pressure is not the true one; see
        `SeparationInsideWarning`.

        Returns
        -------
        tuple of float
            p [modulus] and r [length]; 0 at the edge if no pressure is negative.
        """
        pressure, r = call(native.load_lowest_pressure, self._load)
        return float(pressure), float(r)

    def interior(
        self,
        r: ArrayLike,
        z: ArrayLike,
        body: str = "lower",
        side: str = "below",
        friction: float = 0.0,
        angle: ArrayLike = 0.0,
    ) -> Interior:
        """Return displacements and stresses inside a body.

        The body is homogeneous, coated, layered or graded.

        Parameters
        ----------
        r : array_like
            Distances from the axis, >= 0 [length]. `r`, `z` and `angle` broadcast. Grids of few distinct r and z, as r[:, None] and
            z[None, :], cost far less than scattered points.
        z : array_like
            Depths into the body, >= 0 [length].
        body : {"lower", "upper"}, optional
            Body of a pair.
        side : {"below", "above"}, optional
            Side of an interface, where s_rr, s_tt and s_rt jump; "below" is that of larger z.
        friction : float, optional
            Coefficient f >= 0 of a sliding contact without adhesion [1]: the traction is f p(r) in +x on the lower body and -f p(r)
            on the upper body, with the pressure of the contact without friction (Goodman).
        angle : array_like, optional
            Azimuth of the points from +x [radian].

        Returns
        -------
        Interior
            Displacements [length] and stresses [modulus], in the broadcast shape.

        Raises
        ------
        InvalidArgumentError
            The medium does not support stresses inside, or a coordinate is negative.
        NoConvergenceError
            A field of 1000 points or more deviates from the contact at the surface by more than 1e-3.

        Notes
        -----
        Stresses are infinite at the surface at the edge of a flat punch, of a flat end or of an adhesive contact, and at the apex
        of a cone. Under an approximate model the field belongs to the pressure of the model, and its surface does not fit the
        indenter. Graded bodies take up to a few seconds for 64 depths. A field of 1000 points or more is compared with the pressure
        and the displacement of the contact at the surface. If it deviates by more than 1e-8 and 10 times the tolerance of the
        medium, an `InteriorAccuracyWarning` is issued. For fewer points the warning comes once they add to 1000; `warnings` of the
        result compares for any number.

        References
        ----------
        goodman-1962
        hamilton-1983
        """
        contact, found = self._owner, interior.interior(self, r, z, body, side, friction, angle)
        if np.size(found.s_zz) >= interior.ENOUGH_POINTS:
            doubts = contact._doubts.inside_or_refused(self, body)
            contact._reported.report(doubts)
            return found._compared(doubts)
        contact._reported.inside(self, body, np.size(found.s_zz))
        return found._comparable(self, body)

    def critical(self, body: str = "lower", friction: float = 0.0) -> Critical:
        """Return the largest stresses in each layer, at the surface and at interfaces.

        They show whether a coating cracks, yields or delaminates.

        Parameters
        ----------
        body : {"lower", "upper"}, optional
            Body of a pair.
        friction : float, optional
            Coefficient of a sliding contact, >= 0 [1]; the search is in the plane of sliding.

        Returns
        -------
        Critical
            Largest stresses with their positions, and the elastic energy of each layer.

        Raises
        ------
        InvalidArgumentError
            The body has no layers and is not homogeneous, or it is rigid.
        """
        return critical.critical(self, body, friction)

    def gradient(self) -> dict[str, float]:
        """Return dF/dp at the depth of the state, for the constants p of the bodies.

        It also has the radius of a paraboloid. It follows from reciprocity, exactly, without further solutions. At a given force
        the depth changes by -dF/dp/k.

        Returns
        -------
        dict
            Derivatives by the names of `medium.parameters()`, as "E", "coating.E", "layers[0].prestress", except for constants that
            are 0; and "radius" of a paraboloid.

        Raises
        ------
        InvalidArgumentError
            The body is not homogeneous, coated or layered and elastic under the model "exact", the contact is adhesive, or its
            radius exceeds 100 thicknesses of the top layer.
        NoConvergenceError
            The line load of the indenter has kinks.
        """
        return sensitivity.gradient(self)

    def warnings(self) -> tuple[str, ...]:
        """Return the warnings about the numbers of the state.

        They concern slopes and strains, moduli in two units, and contacts that are not a single contact area. They depend on the
        state alone, while Python's `warnings` issue each kind once for each contact, as states are made. For several states they
        concern the deepest one, and the largest and some smaller ones if those are not single contact areas.

        Returns
        -------
        tuple of str
            The texts; empty if there are none.
        """
        doubts = self._owner._doubts
        return texts_of([*doubts.about(self), *doubts.one_disc(self)[0]])

    @property
    def _owner(self) -> Any:
        if self.contact is None:
            raise ArgumentTypeError("this State has no contact and no fields. Use a state that a contact returned")
        return self.contact

    def replace(self, **changes: Any) -> State:
        """Return a copy with other numbers, or with another contact.

        Parameters
        ----------
        **changes
            Numbers by name, or `contact`.

        Returns
        -------
        State
            The copy.
        """
        return State(**{**dict(zip(NAMES, self._numbers(), strict=True)), "contact": self.contact, **changes})

    def _numbers(self) -> tuple[Any, ...]:
        """The six numbers in their order."""
        return self.depth, self.radius, self.force, self.stiffness, self.punch_depth, self.zone_radius

    def _rows(self) -> NDArray[np.float64]:
        """The numbers as the library takes them, along one more axis at the end."""
        return np.stack(together(**{f"{name} of the state": getattr(self, name) for name in NAMES}), axis=-1)

    def _row(self) -> list[float]:
        """Return the numbers of one state; raise for several."""
        row = list(self._numbers())
        if all(type(value) is float for value in row):
            return row
        if np.shape(self.depth):
            raise ArgumentTypeError(f"these are states of shape {np.shape(self.depth)}: one is needed, as states[0] is")
        return [number(f"{name} of the state", value) for name, value in zip(NAMES, row, strict=True)]

    @property
    def _load(self) -> Handle:
        """The load of this one state, solved once; if several threads make it simultaneously, one stays."""
        load: Handle | None = self.__dict__.get("_kept")
        return load or self.__dict__.setdefault("_kept", self._load_of(self._row()))

    def _load_of(self, row: ArrayLike) -> Handle:
        return Handle(native.contact_load(self._owner._handle, row))

    def _loads(self) -> Iterator[Handle]:
        """The load of each of the states; those of several are not kept."""
        if not np.shape(self.depth):
            yield self._load
        else:
            yield from map(self._load_of, self._rows().reshape(-1, len(NAMES)))

    def _field(self, field: int, name: str, points: ArrayLike) -> FloatOrArray:
        shape = np.shape(self.depth)
        if not shape:
            return evaluate(name, points, lambda x: native.load_field(self._load, field, x))
        places, loads = numbers(name, points), self._loads()
        if places.shape[: len(shape)] != shape:
            raise ArgumentTypeError(f"{name} has shape {places.shape}: for states of shape {shape} it must begin with that")
        found = np.empty(places.shape)
        for i in np.ndindex(shape):
            load = next(loads)
            found[i] = evaluate(name, places[i], partial(native.load_field, load, field))
        return found

    def _cautions(self) -> tuple[int, list[str]]:
        """Return the sum of the codes, and the texts, of the warnings about one state."""
        buffer = np.zeros(1000, np.uint8)
        found = call(native.contact_warnings, self._owner._handle, self._row(), buffer, buffer.size)
        return found, bytes(buffer).rstrip(b"\0").decode().splitlines()


class States(State):
    """Several states of a contact: arrays of one shape, and a sequence of states.

    `len` and iteration follow the first axis; `states[3]` and `states[mask]` select states. Fields take positions of shape
    (*shape of the states, ...). A method of one state needs one.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> states = contact.at_depth([20e-9, 50e-9, 100e-9])
    >>> print(len(states), np.round(states.force * 1e3, 3))
    3 [0.884 3.495 9.886]
    >>> print([f"{state.radius:.2e}" for state in states])
    ['4.47e-07', '7.07e-07', '1.00e-06']
    """

    __hash__ = None  # type: ignore[assignment]

    def __len__(self) -> int:
        return len(self._columns()[0])

    def __iter__(self) -> Iterator[State]:
        return (self[i] for i in range(len(self)))

    def __getitem__(self, index: Any) -> State:
        chosen = (column[index] for column in self._columns())
        return state_of([column if column.ndim else float(column) for column in chosen], self.contact)

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[Any]:
        if np.ndim(self._columns()[0]) != 1:
            raise ArgumentTypeError(
                f"states of shape {self._columns()[0].shape} are no array of numbers: read depth, force and the like, or table()"
            )
        found = np.empty(len(self), object)
        found[:] = list(self)
        return found

    def _columns(self) -> list[NDArray[np.float64]]:
        return np.broadcast_arrays(*self._numbers())  # type: ignore[return-value]


NAMES = tuple(field.name for field in fields(State))
"""The numbers of a state, in their order."""
_ONE = {float}


def state_of(numbers: Iterable[Any], contact: Any) -> State:
    """One state from its numbers, or several."""
    depth, radius, force, stiffness, punch_depth, zone_radius = values = tuple(numbers)
    is_one = {*map(type, values)} == _ONE or not any(map(np.shape, values))
    found: State = object.__new__(State if is_one else States)
    found.__dict__.update(
        depth=depth,
        radius=radius,
        force=force,
        stiffness=stiffness,
        punch_depth=punch_depth,
        zone_radius=zone_radius,
        contact=contact,
    )
    return found
