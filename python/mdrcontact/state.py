# SPDX-License-Identifier: GPL-3.0-or-later
"""States of a contact and their fields, on the surface and inside (theory/paper.md (4.1), (4.2))."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields
from functools import partial
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, critical, interior, sensitivity
from ._boundary import FloatOrArray, Handle, call, evaluate, native, number, numbers, together
from ._choices import code
from ._warn import texts_of
from .critical import Critical
from .errors import ArgumentTypeError
from .interior import BODIES, Interior

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
    """A state of a contact, as `Contact.at_depth` and the like return it, and its fields.

    A record: six numbers, read by their names. Several states are `States`.
    """

    depth: FloatOrArray
    """d, indentation depth, positive into the medium [length]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    force: FloatOrArray
    """F, normal force, positive in compression [modulus length^2]"""
    stiffness: FloatOrArray
    """k = 2 a E_eff(a), dF/dd at constant contact radius [modulus length]: under adhesion dF/dd is `slope`"""
    punch_depth: FloatOrArray
    """depth beyond that of the non-adhesive state of this radius [length]: 0 without adhesion, less than 0 with it, the whole depth
    under a flat punch"""
    zone_radius: FloatOrArray
    """c, outer radius of the cohesive zone [length]: the bodies attract each other where a < r < c; 0 without a cohesive stress.
    With radius 0 they attract each other without contact"""
    contact: ClassVar[Any] = None
    """the contact whose state it is; None: numbers without fields"""

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
        """dF/dd [modulus length] along the branch of equilibria, on which the contact radius changes with the depth.

        Without adhesion it is `stiffness`. With adhesion it is smaller: for a paraboloid on a half-space k/3 at depth 0, 0 at
        pull-off under force, infinite at pull-off under depth, and negative between the two. It has about eight significant
        digits, seven with a cohesive stress. At a vertical wall, as under a flat punch, the radius stays and it is `stiffness`.
        """
        rows = self._rows()
        found = call(native.contact_slope, self._owner._handle, rows.reshape(-1, len(NAMES))) if rows.size else np.empty(0)
        return np.reshape(found, rows.shape[:-1]) if rows.ndim > 1 else float(found[0])

    def table(self) -> Columns:
        """The numbers as named columns, a row for each state, with `slope`; `units` of the result has their units.

        Examples
        --------
        >>> import mdrcontact as mdr
        >>> contact = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
        >>> table = contact.at_depth([1e-8, 2e-8]).table()
        >>> table["force"].shape, table.units["force"]
        ((2,), 'modulus length^2')
        """
        values = dict(zip(NAMES, self._rows().reshape(-1, len(NAMES)).T, strict=True)) | {"slope": np.ravel(self.slope)}
        return Columns({name: np.array(values[name]) for name in Columns.units})

    def pressure(self, r: ArrayLike) -> FloatOrArray:
        """Contact pressure p(r) [modulus], equation (6), at 0 <= r <= a, any shape.

        Infinite where theory says so: at the edge of a flat punch, at the apex of a cone; minus infinity at an adhesive edge.
        With a cohesive stress sigma r goes up to the zone's end c; p is finite at a and -sigma where a < r < c.
        """
        return self._field(_layout.PRESSURE, "r", r)

    def displacement(self, r: ArrayLike, body: str | None = None) -> FloatOrArray:
        """Surface displacement u(r) [length], positive into the medium, at r >= 0, any shape. Inside the contact it is d - f(r),
        outside it is the free surface, with the neck of an adhesive contact.

        body : of two deformable bodies (`Pair`) "lower" or "upper", each positive into its own body; None: their sum. u(0) of
            each is its part of the approach. Where the lower surface was flat, "lower" is the shape of the interface for r <= a
        """
        field = _layout.DISPLACEMENT if body is None else code("body", body, _DISPLACEMENTS)
        return self._field(field, "r", r)

    def line_load(self, x: ArrayLike) -> FloatOrArray:
        """Line load q(x) [modulus length] of the one-dimensional springs, equations (5), (21), at 0 <= x <= a, or up to the end of
        a cohesive zone, any shape."""
        return self._field(_layout.LINE_LOAD, "x", x)

    def energy(self, body: str | None = None) -> FloatOrArray:
        """Elastic energy [modulus length^3] of each state: the work of the force from first touch; with adhesion the energy gained
        by the surfaces, pi a^2 work_of_adhesion, comes on top. With a cohesive stress the energy of the zone is
        int (sigma h - gamma) over it, h its gap.

        body : as of `displacement`; None: of both
        """
        if body is not None:
            code("body", body, BODIES)
        found, shape = [], np.shape(self.depth)
        for load in self._loads():
            energies = call(native.load_energy, load)
            found.append(float(sum(energies) if body is None else energies[body == "upper"]))
        return np.reshape(found, shape) if shape else found[0]

    def lowest_pressure(self) -> tuple[float, float]:
        """The smallest p(r) [modulus] of one state without adhesion, and its r [length]: 0, at the edge, where none is negative.
        Below 0 the contact is not one disc and its pressure not that of the true contact (see `SeparationInsideWarning`)."""
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
        """Displacements and stresses inside a homogeneous, coated, layered or graded body.

        r, z : distance from the axis and depth into the body, >= 0 [length], any shapes that broadcast; grids of few distinct r and
            z, as r[:, None] and z[None, :], cost far less than as many scattered points
        body : "lower", or "upper" of two deformable bodies
        side : at an interface s_rr, s_tt and s_rt jump: the values "below" it (larger z) or "above"
        friction : f >= 0; the contact slides with traction f p(r) in +x on the lower body and -f p(r) on the upper one, p being
            that of the contact without friction (Goodman); not with adhesion
        angle : azimuth of the points from +x [radian]

        Infinite where theory says so: on the surface at the edge of a flat punch or an adhesive contact, at the apex of a cone, at
        the edge of a flat end. Under an approximate model it is the field in the body under the model's own pressure, whose surface
        does not fit the indenter. Graded bodies take up to some seconds for each 64 depths.

        A field of 1000 points or more is compared with the contact's pressure and displacement on the surface: an
        `InteriorAccuracyWarning` where it deviates by more than 1e-8 and 10 times the medium's tolerance, refused beyond 1e-3.
        Of fewer points at a time the warning comes once they are as many; `warnings` of the result compares at any number.
        """
        contact, found = self._owner, interior.interior(self, r, z, body, side, friction, angle)
        if np.size(found.s_zz) >= interior.ENOUGH_POINTS:
            doubts = contact._doubts.inside_or_refused(self, body)
            contact._reported.report(doubts)
            return found._compared(doubts)
        contact._reported.inside(self, body, np.size(found.s_zz))
        return found._comparable(self, body)

    def critical(self, body: str = "lower", friction: float = 0.0) -> Critical:
        """What decides whether a coating cracks, yields or peels: the largest stresses in each layer, at the surface outside the
        contact and at each interface, where they are, and the elastic energy of each layer. Arguments as of `interior`; with
        friction in the plane of sliding."""
        return critical.critical(self, body, friction)

    def gradient(self) -> dict[str, float]:
        """dF/dp at the depth of the state, for the constants p of the bodies and R of a paraboloid: by reciprocity, exact, without
        solving a contact again; for fits, design and propagation of errors. At a given force the depth changes by -dF/dp/k.

        The names are those of `medium.parameters()`: "E", "nu" of a homogeneous body; "coating.E", "coating.C44", "thickness",
        "substrate.nu"; "layers[0].E", "layers[0].prestress", "layers[0].interface.normal" and so on, but for those that are 0; and
        "radius". Of homogeneous, coated and layered elastic bodies under the model "exact", without adhesion, up to contact radii
        of 100 thicknesses of the top layer; all else is refused (InvalidArgumentError), and indenters whose line load has kinks
        (NoConvergenceError).
        """
        return sensitivity.gradient(self)

    def warnings(self) -> tuple[str, ...]:
        """Doubts about the numbers of the state: slopes and strains that are not small, moduli in two units, a contact that is not
        one disc; empty where there are none. They follow from the state alone, whatever was computed before and in which thread,
        while Python's `warnings` give each kind once for each contact, as states are made.

        Of several states those of the deepest, and whether the largest and some smaller ones are one disc.
        """
        doubts = self._owner._doubts
        return texts_of([*doubts.about(self), *doubts.one_disc(self)[0]])

    @property
    def _owner(self) -> Any:
        if self.contact is None:
            raise ArgumentTypeError("this State has no contact: only those that a contact gives have fields")
        return self.contact

    def replace(self, **changes: Any) -> State:
        """A copy with other numbers, or with another contact."""
        return State(**{**dict(zip(NAMES, self._numbers(), strict=True)), "contact": self.contact, **changes})

    def _numbers(self) -> tuple[Any, ...]:
        """The six numbers in their order."""
        return self.depth, self.radius, self.force, self.stiffness, self.punch_depth, self.zone_radius

    def _rows(self) -> NDArray[np.float64]:
        """The numbers as the library takes them, along one more axis at the end."""
        return np.stack(together(**{f"{name} of the state": getattr(self, name) for name in NAMES}), axis=-1)

    def _row(self) -> list[float]:
        """The same of what must be one state."""
        row = list(self._numbers())
        if all(type(value) is float for value in row):
            return row
        if np.shape(self.depth):
            raise ArgumentTypeError(f"these are states of shape {np.shape(self.depth)}: one is needed, as states[0] is")
        return [number(f"{name} of the state", value) for name, value in zip(NAMES, row, strict=True)]

    @property
    def _load(self) -> Handle:
        """The load of this one state, solved once for all that is read from it; where threads make it at a time, one stays."""
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
        """Sum of the codes, and texts, of the doubts about one state."""
        buffer = np.zeros(1000, np.uint8)
        found = call(native.contact_warnings, self._owner._handle, self._row(), buffer, buffer.size)
        return found, bytes(buffer).rstrip(b"\0").decode().splitlines()


class States(State):
    """Several states of a contact: arrays of one shape, and a sequence of states.

    `len` and iteration follow the first axis, `states[3]` and `states[mask]` are some of them. Fields take places of shape
    (*shape of the states, ...); what is of one state needs one.
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


def state_of(numbers: Iterable[Any], contact: Any) -> State:
    """One state from its numbers, or several."""
    values = tuple(numbers)
    is_one = all(type(value) is float or not np.shape(value) for value in values)
    found: State = object.__new__(State if is_one else States)
    found.__dict__.update(zip(NAMES, values, strict=True), contact=contact)
    return found
