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
    from .panels import Figure

_UNLOADING = BRANCHES["unloading"]
_state: Any = tuple.__new__


class _LawNumbers(NamedTuple):
    """The numbers of a `LawState`."""

    depth: FloatOrArray
    """d, indentation depth [length]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    force: FloatOrArray
    """F, normal force, positive in compression [modulus length^2]"""
    stiffness: FloatOrArray
    """k = 2 a E_eff(a), stiffness at constant contact radius [modulus length]"""
    slope: FloatOrArray
    """dF/dd along the branch, the derivative that implicit codes need; equal to k without adhesion [modulus length]"""


class LawState(_LawNumbers, Warned):
    """States of a compiled law; each entry has the shape of the input.

    All numbers except the depth are 0 if the bodies are separated.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> state = mdr.ContactLaw(contact, 10e-6).at_depth(5e-6)
    >>> print(f"{state.force:.4e} {state.slope:.4e}")
    3.4401e+02 1.0320e+08
    """


class ContactLaw(LawSteps):
    """Compiled law of one contact over a range of depths, evaluated in nanoseconds.

    The law is made once and verified. It is immutable, may be shared between threads, and pickles completely: other processes do
    not solve the contact again. Unlike the contact, the law returns zero force for separated bodies.

    Parameters
    ----------
    contact : Contact
        The contact to compile, with or without adhesion.
    largest_depth : float
        Largest depth > 0 [length]. If depth or force of an adhesive contact decrease over some radii, the law continues to the
        states from which the contact unloads; see `depth_range`.
    friction : Friction, optional
        Friction of this contact, for tangential forces.
    sliders : int, optional
        With friction or a shear strength, 4 to 64 vector sliders, which represent the springs. Errors decrease about as
        sliders^-1.6; time and memory are proportional to them. Use 16 for finite elements.
    shear_strength : float, optional
        Constant shear traction at which the contact slips, > 0 [modulus], instead of `friction`; on homogeneous bodies, with or
        without adhesion. `advance` then takes contact radii instead of normal forces.
    twist : bool, optional
        True if the sliders resist a twist phi about the normal instead of a shift; with friction, of paraboloids on homogeneous
        bodies. A contact that shifts and twists needs two laws and two memories, which are independent.
    smallest_depth : float, optional
        Without adhesion, depth from which the tolerance holds [length]; default 1e-4 of the largest. Closer to initial contact the
        law continues value and slope. An adhesive law begins at pull-off.
    tolerance : float, optional
        Relative tolerance of F, a and k, 1e-12 to 1e-2; with adhesion relative to |F| + |d dF/dd|.
    description : str, optional
        Description of the problem, kept in files; default the repr of the contact.
    continue_beyond : bool, optional
        True continues the law along its tangent beyond its largest depth and force, with a `BeyondRangeWarning`. False raises
        `DomainError` there.
    conduction : Conduction, optional
        Conduction of these bodies; the law then also has their conductance.

    Raises
    ------
    ArgumentTypeError
        An object is of another type.
    InvalidArgumentError
        A number is outside its range.
    NoConvergenceError
        The tolerance cannot be reached.

    Notes
    -----
    With friction, `contacts` makes the memory of contacts, and `advance` takes one step of each along any path of shift and normal
    force. It returns the tangential forces of stick, partial slip and sliding. No path yields energy, T is continuous in F and in
    the shift, and each step has a derivative. With 8 sliders the error of T is 1 % of mu F, with 16 sliders 0.5 %, relative to the
    springs of the body; springs in the plane are a model. See `first_shear_error` and `path_error`. Slip of small amplitude, below
    the strength of the slider at the edge, is elastic: use `Friction` for fretting.

    References
    ----------
    iwan-1967

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> law = mdr.ContactLaw(contact, 10e-6, friction=mdr.Friction(contact, 0.3))
    >>> print(f"{law.force(5e-6):.4e} {contact.at_depth(5e-6).force:.4e}")
    3.4401e+02 3.4401e+02
    >>> memory = law.contacts(1)
    >>> T = law.advance(memory, [200.0], [[1e-6, 0.0]])
    >>> print(np.round(T, 1))
    [[47.3  0. ]]
    """

    __slots__ = ("_highest", "warnings")

    warnings: tuple[str, ...]
    """warnings about the contact at the largest depth, found when the law was made; files do not contain them"""

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
            raise ArgumentTypeError(f"contact = {contact!r}: it must be a Contact")
        if friction is not None and not isinstance(friction, Friction):
            raise ArgumentTypeError(f"friction = {friction!r}: it must be a Friction")
        options = law_options(description, repr(friction or contact), smallest_depth, tolerance, continue_beyond)
        options["sliders"] = whole("sliders", sliders, 1)
        options["twist"] = bool(twist)
        if friction is not None:
            options["friction"] = friction._handle
        if conduction is not None:
            from .conduction import Conduction

            if not isinstance(conduction, Conduction):
                raise ArgumentTypeError(f"conduction = {conduction!r}: it must be a Conduction")
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
        """Return the force F(d).

        Parameters
        ----------
        depth : array_like
            Depths up to the largest one, any shape [length].
        branch : {"unloading", "loading"}, optional
            As in `Contact.at_depth`.

        Returns
        -------
        float or ndarray
            F, in the shape of `depth` [modulus length^2]; 0 for separated bodies.

        Raises
        ------
        DomainError
            A depth exceeds the range, and the law does not continue beyond it.
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
        """Return the states at given depths.

        Parameters
        ----------
        depth : array_like
            Depths up to the largest one, any shape [length].
        branch : {"unloading", "loading"}, optional
            As in `Contact.at_depth`.

        Returns
        -------
        LawState
            The states, in the shape of `depth`.

        Raises
        ------
        DomainError
            A depth exceeds the range, and the law does not continue beyond it.
        """
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
        """Return the energy U = int F dd along the branch.

        Parameters
        ----------
        depth : array_like
            Depths up to the largest one, any shape [length].
        branch : {"unloading", "loading"}, optional
            As in `Contact.at_depth`.

        Returns
        -------
        float or ndarray
            U, in the shape of `depth` [modulus length^3]. It counts from initial contact, the elastic energy; with adhesion from
            pull-off, with a cohesive stress from separated bodies.

        Raises
        ------
        DomainError
            A depth exceeds the range, and the law does not continue beyond it.
        """
        chosen = code("branch", branch, BRANCHES)
        U = evaluate("depth", depth, lambda d: self._energy(chosen, d))
        self._warn_beyond("depth", depth)
        return U

    def _energy(self, branch: int, depth: NDArray[np.float64]) -> tuple[int, NDArray[np.float64]]:
        U = np.empty(depth.shape)
        return native.law_values(self._handle, _layout.DEPTH, branch, depth, None, None, None, None, None, U), U

    def conductance(self, depth: ArrayLike, branch: str = "unloading") -> tuple[FloatOrArray, FloatOrArray]:
        """Return the conductance and its derivative, of a law made with a conduction.

        Parameters
        ----------
        depth : array_like
            Depths up to the largest one, any shape [length].
        branch : {"unloading", "loading"}, optional
            As in `Contact.at_depth`.

        Returns
        -------
        tuple
            G [conductance] and dG/dd along the branch [conductance/length], in the shape of `depth`.

        Raises
        ------
        InvalidArgumentError
            The law was made without a conduction.
        DomainError
            A depth exceeds the range, and the law does not continue beyond it.
        """
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
        text = f"{beyond} of {values.size} values of {name} lie beyond {largest:.4g}: the law continues along its tangent"
        found = [Caution(text, BeyondRangeWarning)]
        warn_all(found)
        return found

    def at_force(self, force: ArrayLike, branch: str = "unloading") -> LawState:
        """Return the states under given forces.

        Parameters
        ----------
        force : array_like
            Forces of the compiled range, any shape [modulus length^2].
        branch : {"unloading", "loading"}, optional
            As in `Contact.at_depth`.

        Returns
        -------
        LawState
            The states, in the shape of `force`.

        Raises
        ------
        DomainError
            A force exceeds the range, and the law does not continue beyond it.
        UnreachableError
            No stable contact has the force.
        """
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
        """Return the law as one array of numbers without addresses.

        The inline functions of `mdrcontact_law.h` evaluate it in any memory: on a device, in shared memory, in a file. It excludes
        friction. Its layout is `mdr_law_head` in `mdrcontact.h`.

        Returns
        -------
        ndarray
            The numbers.
        """
        numbers = np.empty(int(self._facts["buffer_size"]))
        call(native.law_buffer, self._handle, numbers.size, numbers)
        return numbers

    def arrays(self) -> LawArrays:
        """Return the numbers of the law as separate NumPy views.

        `mdrcontact.interop` makes functions of numba, JAX and PyTorch from them.

        Returns
        -------
        LawArrays
            Segments, intervals and polynomials of each panel.
        """
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
        """Return the law as the text of a table for another program.

        The table is interpolated linearly from initial contact (with adhesion from the beginning of the branch) to the largest
        depth. It has as few rows as the error allows.

        Parameters
        ----------
        form : {"csv", "lammps", "spring", "overclosure"}, optional
            "csv": F, dF/dd, a, k and U. "lammps": a section MDRCONTACT for `pair_style table` and `bond_style table`. "spring": a
            nonlinear spring of Abaqus and CalculiX (SPRINGA). "overclosure": pressure-overclosure of both.
        error : float, optional
            Error of F by linear interpolation, relative to the largest |F|, 1e-7 to 0.1 [1]. The text states the error found.
        branch : {"unloading", "loading"}, optional
            Of "csv", as in `Contact.at_depth`; the other forms need a law without adhesion.
        length : float, optional
            Unit of length of the table in that of the law, > 0: 1e-3 for mm if the law is in m. Forces keep their unit.
        touch : float, optional
            Of "lammps": distance at initial contact [length of the table].
        area : float, optional
            Of "overclosure": area of the surface that one contact represents [length^2 of the table].

        Returns
        -------
        str
            The text of the table.

        Raises
        ------
        InvalidArgumentError
            The form is unknown, an argument belongs to another form, or a number is outside its range.
        """
        return table_text(self, form, error, branch, length, touch, area)

    def with_radius(self, radius: float) -> ContactLaw:
        """Return the law of these bodies for a paraboloid of another radius.

        Parameters
        ----------
        radius : float
            R > 0 [length].

        Returns
        -------
        ContactLaw
            The law, F(d; R) = (R0/R) F0(d R/R0) with the same a and k, up to the largest depth times R0/R.

        Raises
        ------
        InvalidArgumentError
            The contact is adhesive, the indenter is not a paraboloid, or the law is from a file that does not contain the radius.
        """
        law = type(self).__new__(type(self))
        law._own(native.law_with_radius(self._handle, number("radius", radius)))
        law.warnings = self.warnings
        return law

    def plot(self, points: int = 200) -> Figure:
        """Return force, contact radius and stiffness over depth as a figure.

        Numbers are taken as SI.

        Parameters
        ----------
        points : int, optional
            Number of depths, at least 2.

        Returns
        -------
        Figure
            The figure.

        Examples
        --------
        >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
        >>> figure = mdr.ContactLaw(contact, 10e-6).plot()
        >>> [panel.y.unit for panel in figure.panels]
        ['N', '\u00b5m', 'MN/m']
        """
        from .panels import Figure, contacts

        states = self.at_depth(np.linspace(*self.depth_range, whole("points", points, 2)))
        return Figure("Contact law", tuple(contacts.over_depth(states)), columns=3)

    @property
    def depth_range(self) -> tuple[float, float]:
        """Smallest and largest compiled depth [length].

        With adhesion the smallest is that of pull-off.
        """
        return float(self._facts["lowest_depth"]), float(self._facts["highest_depth"])

    @property
    def force_range(self) -> tuple[float, float]:
        """Smallest and largest compiled force [modulus length^2]."""
        return float(self._facts["lowest_force"]), float(self._facts["highest_force"])

    @property
    def error(self) -> float:
        """Largest relative error found when the law was verified against the contact [1]."""
        return float(self._facts["error"])

    @property
    def solutions(self) -> int:
        """Number of contact states that were computed to make and verify the law."""
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
