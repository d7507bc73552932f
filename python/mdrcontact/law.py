# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled contact laws: F(d), a(d), k(d) and their inverses for the price of a short polynomial."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import FloatOrArray, call, evaluate, evaluate_all, native, not_zero, number, whole
from ._choices import code
from ._law_arrays import LawArrays, law_arrays
from ._law_file import law_options
from ._law_steps import LawSteps
from ._law_table import table_text
from ._warn import Caution, Warned, texts_of, warn_all
from .contact import Contact
from .errors import ArgumentTypeError, BeyondRangeWarning
from .friction import Friction
from .loop import BRANCHES

if TYPE_CHECKING:
    from .conduction import Conduction

_UNLOADING = BRANCHES["unloading"]
_state: Any = tuple.__new__


class _LawNumbers(NamedTuple):
    """The numbers of a `LawState`."""

    depth: FloatOrArray
    """d, indentation depth [length]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    force: FloatOrArray
    """F, normal force [modulus length^2]"""
    stiffness: FloatOrArray
    """k = 2 a E_eff(a), stiffness at constant contact radius [modulus length]"""
    slope: FloatOrArray
    """dF/dd along the branch [modulus length], the derivative that implicit codes need; equal to k without adhesion"""


class LawState(_LawNumbers, Warned):
    """States of a compiled law; each entry has the shape of the input, or is a float. All but the depth is 0 where the bodies are
    apart."""


class ContactLaw(LawSteps):
    """The law of one contact over a range of depths, made once, verified, then evaluated in nanoseconds. It never changes, may be
    shared between threads, and pickles with all it needs: processes on other machines do not solve the contact again.

    contact : the Contact to compile, with or without adhesion
    largest_depth : > 0 [length]. With adhesion, where depth or force fall over some radii, the law goes on to the states from which
        the contact unloads: `depth_range`
    conduction : the `Conduction` of the same bodies: the law has their conductance too, within the tolerance; None: it has none
    friction : the `Friction` of this contact, for tangential forces; None: the law has none
    sliders : with friction or a shear strength, 4 to 64 vector sliders for the springs of a contact; errors fall about as
        sliders^-1.6, time and memory grow in proportion. 16 for finite elements
    shear_strength : > 0, in place of friction: the contact slips where its shear traction reaches this constant [modulus], as
        smooth dry contacts with adhesion do; on homogeneous bodies, with or without adhesion. `advance` then takes contact radii
        in place of normal forces; None: none
    twist : whether the sliders bear the twist of the contact about its normal in place of the shift: `advance` takes twists phi
        and gives torques M. With friction, of paraboloids on homogeneous bodies. A contact that shifts and twists has two laws and
        two memories, which do not know of each other
    smallest_depth : without adhesion, where the tolerance begins to hold [length]; None: 1e-4 of the largest. Nearer to first
        touch the law continues value and slope. With adhesion the law begins at pull-off. None gives way to a medium that begins
        later, as under a plate
    tolerance : relative, of F, a and k; 1e-12 to 1e-2. With adhesion relative to |F| + |d dF/dd|
    description : the problem in words, kept in files; None: the contact's repr
    continue_beyond : whether the law answers beyond its largest depth and force too, along the tangent there, with a warning
        (BeyondRangeWarning): one hard collision then does not end a run. Else it refuses

    Unlike the contact, the law has an answer for bodies that are apart: zero.

    With friction: `contacts` makes the memory of as many contacts as there are, `advance` takes a step of each along any path of
    the shift in the plane and of the normal force and gives the tangential forces: stick, partial slip, sliding, and what earlier
    slip left behind. No path yields energy, T is continuous in F and in the shift, and each step has a derivative. T is off by 1
    % of mu F with 8 sliders, 0.5 % with 16, against the springs of the body, and springs in the plane are a model: docs/laws.md,
    `first_shear_error` and `path_error`. Slip of small amplitude, below the strength of the slider at the edge, is elastic: for
    fretting take `Friction`.
    """

    __slots__ = ("_highest", "warnings")

    warnings: tuple[str, ...]
    """doubts about the contact at the largest depth, found when the law was made. A file does not hold them"""

    _write, _read, _info, _table = native.law_write, native.law_read, native.law_about, _layout.law_facts

    def __init__(
        self,
        contact: Contact,
        largest_depth: float,
        *,
        friction: Friction | None = None,
        sliders: int = 8,
        shear_strength: float | None = None,
        twist: bool = False,
        smallest_depth: float | None = None,
        tolerance: float = 1e-9,
        description: str | None = None,
        continue_beyond: bool = False,
        conduction: Conduction | None = None,
    ) -> None:
        if not isinstance(contact, Contact):
            raise ArgumentTypeError(f"contact = {contact!r} is not allowed: it must be a Contact")
        if friction is not None and not isinstance(friction, Friction):
            raise ArgumentTypeError(f"friction = {friction!r} is not allowed: it must be a Friction")
        options = law_options(description, repr(friction or contact), smallest_depth, tolerance, continue_beyond)
        options["sliders"] = whole("sliders", sliders, 1)
        options["twist"] = bool(twist)
        if friction is not None:
            options["friction"] = friction._handle
        if conduction is not None:
            from .conduction import Conduction

            if not isinstance(conduction, Conduction):
                raise ArgumentTypeError(f"conduction = {conduction!r} is not allowed: it must be a Conduction")
            options["conduction"] = conduction._handle
        if shear_strength is not None:
            options["shear_strength"] = not_zero("shear_strength", shear_strength)
        self._own(native.law_new(contact._handle, number("largest_depth", largest_depth), options))
        self.warnings = texts_of(contact._warn_at(self._highest))

    def _own(self, created: tuple[int, int]) -> None:
        super()._own(created)
        self._highest = float(self._facts["highest_depth"])
        self.warnings = ()

    def __reduce__(self) -> tuple[Any, ...]:
        return _with_warnings, (self.to_bytes(), self.warnings)

    def force(self, depth: ArrayLike, branch: str = "unloading") -> FloatOrArray:
        """F [modulus length^2] at depths d up to the largest one [length], any shape.

        branch : "loading" or "unloading", as in `Contact.at_depth`
        """
        if isinstance(depth, float) and branch == "unloading" and depth <= self._highest:
            F = native.law_force_scalar(self._handle, _UNLOADING, depth)
            if F is not None:
                return F
        chosen = code("branch", branch, BRANCHES)
        F = evaluate("depth", depth, lambda d: self._from_depth(chosen, d, 1))
        self._warn_beyond("depth", depth)
        return F

    def at_depth(self, depth: ArrayLike, branch: str = "unloading") -> LawState:
        """The states at depths d up to the largest one [length], any shape. Further arguments as in `force`."""
        if isinstance(depth, float) and branch == "unloading" and depth <= self._highest:
            state = native.law_state_scalar(self._handle, _UNLOADING, depth)
            if state is not None:
                return _state(LawState, state)
        chosen = code("branch", branch, BRANCHES)
        F, slope, a, k = evaluate_all("depth", depth, lambda d: self._from_depth(chosen, d, 4))
        return LawState(_as_given(depth), a, F, k, slope)._carrying(self._warn_beyond("depth", depth))

    def _from_depth(self, branch: int, depth: NDArray[np.float64], wanted: int) -> tuple[Any, ...]:
        """Status, and the first of F, slope, a and k: F alone is cheapest."""
        columns = [np.empty(depth.shape) for _ in range(wanted)]
        F, slope, a, k = columns + [None] * (4 - wanted)
        status = native.law_values(self._handle, _layout.DEPTH, branch, depth, None, a, F, k, slope, None)
        return status, *columns

    def energy(self, depth: ArrayLike, branch: str = "unloading") -> FloatOrArray:
        """U = int F dd along the branch [modulus length^3] at depths d [length], any shape: without adhesion the elastic energy,
        counted from first touch; with adhesion counted from pull-off, with a cohesive stress from bodies that are apart.
        Further arguments as in `force`."""
        chosen = code("branch", branch, BRANCHES)
        U = evaluate("depth", depth, lambda d: self._energy(chosen, d))
        self._warn_beyond("depth", depth)
        return U

    def _energy(self, branch: int, depth: NDArray[np.float64]) -> tuple[int, NDArray[np.float64]]:
        U = np.empty(depth.shape)
        return native.law_values(self._handle, _layout.DEPTH, branch, depth, None, None, None, None, None, U), U

    def conductance(self, depth: ArrayLike, branch: str = "unloading") -> tuple[FloatOrArray, FloatOrArray]:
        """G [conductance] and dG/dd along the branch [conductance/length] at depths d [length], any shape, of a law that was made
        with a conduction. Further arguments as in `force`."""
        chosen = code("branch", branch, BRANCHES)
        G, slope = evaluate_all("depth", depth, lambda d: native.law_conductance(self._handle, chosen, d))
        self._warn_beyond("depth", depth)
        return G, slope

    def _warn_beyond(self, name: str, given: ArrayLike) -> list[Caution]:
        """Warns of values beyond the range of a law that is continued."""
        if not self._facts["continue_beyond"]:
            return []
        values, largest = np.asarray(given), self._highest if name == "depth" else self.force_range[1]
        beyond = np.count_nonzero(values > largest)
        if not beyond:
            return []
        text = f"{beyond} of {values.size} values of {name} lie beyond {largest:.4g}: the law goes on along its tangent"
        found = [Caution(text, BeyondRangeWarning)]
        warn_all(found)
        return found

    def at_force(self, force: ArrayLike, branch: str = "unloading") -> LawState:
        """The states under forces F of the compiled range [modulus length^2], any shape. Further arguments as in `force`."""
        chosen = code("branch", branch, BRANCHES)
        d, compliance, a, k = evaluate_all("force", force, lambda F: self._from_force(chosen, F))
        slope = np.divide(1.0, compliance, out=np.zeros(np.shape(compliance)), where=np.asarray(compliance) != 0.0)
        found = LawState(d, a, _as_given(force), k, slope if np.ndim(slope) else float(slope))
        return found._carrying(self._warn_beyond("force", force))

    def _from_force(self, branch: int, force: NDArray[np.float64]) -> tuple[Any, ...]:
        """Status, d, dd/dF, a and k."""
        d, compliance, a, k = (np.empty(force.shape) for _ in range(4))
        status = native.law_values(self._handle, _layout.FORCE, branch, force, d, a, None, k, compliance, None)
        return status, d, compliance, a, k

    def buffer(self) -> NDArray[np.float64]:
        """The law as one array of numbers without addresses, which the inline functions of `mdrcontact_law.h` evaluate wherever it
        lies: on a device, in shared memory, in a file. Without friction; its layout: `mdr_law_head` in `mdrcontact.h`."""
        numbers = np.empty(int(self._facts["buffer_size"]))
        call(native.law_buffer, self._handle, numbers.size, numbers)
        return numbers

    def arrays(self) -> LawArrays:
        """The same numbers by parts: NumPy views of segments, intervals, and of the polynomials of each panel. What they mean is
        said in `mdrcontact.h`; `mdrcontact.interop` makes functions of numba, JAX and PyTorch of them."""
        return law_arrays(self.buffer())

    def table(
        self,
        form: str = "csv",
        *,
        error: float = 1e-3,
        branch: str = "unloading",
        length: float = 1.0,
        touch: float | None = None,
        area: float | None = None,
    ) -> str:
        """The law as the text of a table that another program reads and interpolates linearly, from first touch (with adhesion from
        the beginning of the branch) to the largest depth, with as few rows as the error allows.

        form : "csv" with F, dF/dd, a, k and U; "lammps", a section MDRCONTACT for `pair_style table` and `bond_style table`;
            "spring", a nonlinear spring of Abaqus and CalculiX (SPRINGA); "overclosure", pressure-overclosure of both
        error : of F by linear interpolation, relative to the largest |F|; 1e-7 to 0.1. The text states what was found
        branch : of csv, as in `force`; the other forms take laws without adhesion
        length : the unit of length of the table in that of the law: 1e-3 for mm, where the law is in m. Forces stay
        touch : of "lammps": the distance at first touch, to which forces reach [table's length]
        area : of "overclosure": the area of the surface that one contact stands for [table's length^2]
        """
        return table_text(self, form, error, branch, length, touch, area)

    def with_radius(self, radius: float) -> ContactLaw:
        """The law of the same bodies for a paraboloid of another radius R > 0 [length], from this one for R0.

        Without adhesion, on any linear bodies, F(d; R) = (R0/R) F0(d R/R0) with the same a and k, up to the largest depth times
        R0/R. Refused (InvalidArgumentError) with adhesion, where it holds only if work of adhesion times R^2 stays the same; for
        indenters other than paraboloids; and for laws of files that do not hold the radius.
        """
        law = type(self).__new__(type(self))
        law._own(native.law_with_radius(self._handle, number("radius", radius)))
        law.warnings = self.warnings
        return law

    @property
    def depth_range(self) -> tuple[float, float]:
        """The compiled depths [length]: from pull-off on with adhesion."""
        return float(self._facts["lowest_depth"]), float(self._facts["highest_depth"])

    @property
    def force_range(self) -> tuple[float, float]:
        """The compiled forces [modulus length^2]."""
        return float(self._facts["lowest_force"]), float(self._facts["highest_force"])

    @property
    def error(self) -> float:
        """The largest relative error found when the law was verified against the contact."""
        return float(self._facts["error"])

    @property
    def solutions(self) -> int:
        """How many contact states were computed to make and verify the law."""
        return int(self._facts["solutions"])

    def __repr__(self) -> str:
        low, high = self.depth_range
        return f"<ContactLaw of {self.description}, depths {low:.4g} to {high:.4g}, error {self.error:.1e}>"


def _as_given(values: Any) -> FloatOrArray:
    array = np.array(values, dtype=np.float64)
    return array if array.ndim else float(array)


def _with_warnings(content: bytes, warnings: tuple[str, ...]) -> ContactLaw:
    """A law that was pickled."""
    law = ContactLaw.from_bytes(content)
    law.warnings = warnings
    return law
