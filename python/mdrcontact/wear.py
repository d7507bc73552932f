# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear of a contact by Archard's law: limit of fretting, track of a tip, sliding."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import (
    FloatOrArray,
    Handle,
    Refusal,
    call,
    evaluate,
    native,
    number,
    numbers,
    outcome,
    record,
    row,
    together,
    whole,
    words_of,
)
from ._choices import nearest
from ._value import Value
from ._warn import Caution, Warned, collected, warn
from .contact import Contact
from .errors import ArgumentTypeError, DomainError, InvalidArgumentError, NoConvergenceError, PathEndsWarning
from .profile.base import Profile
from .state import State, state_of

__all__ = [
    "Wear",
    "WearFit",
    "WearHistory",
    "WearLimit",
    "WearState",
    "WornProfile",
    "wear_coefficient_from_scar",
    "wear_coefficient_from_volume",
]

_PLACES = tuple(words_of(_layout.WEAR_FRESH, _layout.WEAR_SAME))
SCHEMES = tuple(words_of(_layout.WEAR_DISC, _layout.WEAR_RINGS))
"""Schemes in the order of the library's codes."""
_LONGEST_PAST = 2000
"""Numbers of a saved past at most."""
_ROUNDS, _CLOSE, _PART = 40, 1e-9, 1e-2
"""Steps of a fit, where they end, and the part of a coefficient by which a slope is taken."""


class WearLimit(NamedTuple):
    """Final state of fretting with a constant stick radius, from `Wear.limit`.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(1e-2), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> limit = mdr.wear.Wear(contact, 1e-15).limit(contact.at_radius(1e-4), stick_radius=0.5e-4)
    >>> print(f"{limit.outer_radius:.4e} {limit.worn_volume:.4e} {limit.state.force:.3f}")
    1.2298e-04 7.5930e-15 21.154
    """

    state: State
    """depth, stick radius c as radius, force, stiffness, and as `punch_depth` the depth beyond that of the unworn state at c"""
    outer_radius: float
    """b, radius up to which the indenter is worn [length]"""
    worn_volume: float
    """worn volume of both sides [length^3]"""
    profile: WornProfile
    """the worn indenter, with the wear of both sides"""


class _WearNumbers(NamedTuple):
    """The numbers of a `WearState`."""

    sliding: FloatOrArray
    """s, sliding distance since the beginning [length]"""
    depth: FloatOrArray
    """d, from the original apex of the indenter [length]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    force: FloatOrArray
    """F, normal force [modulus length^2]"""
    pressure: FloatOrArray
    """p, pressure on the axis [modulus]"""
    worn_depth: FloatOrArray
    """wear depth of the indenter on the axis [length]"""
    worn_volume: FloatOrArray
    """worn volume of the indenter [length^3]"""
    body_depth: FloatOrArray
    """wear depth of the body on the axis, 0 unless both sides rub on the same places [length]"""
    body_volume: FloatOrArray
    """worn volume of the body, 0 unless both sides rub on the same places [length^3]"""
    work: FloatOrArray
    """int F ds [modulus length^3]"""
    error: FloatOrArray
    """largest relative error of a, d, F, p and the wear depth, the difference of two resolutions [1]"""


class WearState(_WearNumbers, Warned):
    """State of a wear history; each entry has the shape of the input.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.3)))
    >>> state, profile = mdr.wear.Wear(contact, 1e-15).advance(1.0, force=1e-3, intervals=16)
    >>> print(f"{state.worn_volume:.4e} {state.radius:.4e} {state.error:.0e}")
    1.0055e-18 1.8984e-06 2e-02
    """


class WearFit(NamedTuple):
    """Wear coefficient from measurements.

    Examples
    --------
    >>> fit = mdr.wear.wear_coefficient_from_volume([1.0e-18, 2.1e-18], sliding=[1.0, 2.0], force=1e-3)
    >>> print(f"{fit.coefficient:.3e} {fit.sd:.1e}")
    1.040e-15 2.0e-17
    """

    coefficient: float
    """k [1/modulus]"""
    sd: float
    """standard deviation of k from the scatter of the measurements; NaN for one measurement [1/modulus]"""


@dataclass(frozen=True)
class Wear(Value):
    """Contact without adhesion that wears by Archard's law, `dh = k p ds`.

    The worn volume is k times force times sliding distance. The layers of the body stay as they are, which makes the result exact
    on coatings.

    Parameters
    ----------
    contact : Contact
        Contact without adhesion; a sliding indenter needs a homogeneous or an exact medium.
    coefficient : float or sequence of float
        k > 0 of the indenter [1/modulus]; of a coated indenter those of its layers from the surface, and of the material below.
    thickness : sequence of float, optional
        Thicknesses of the layers of the indenter, one less than coefficients [length].
    body_coefficient : float, optional
        k >= 0 of the body [1/modulus].

    Raises
    ------
    ArgumentTypeError
        `contact` is not a `Contact`.
    InvalidArgumentError
        A coefficient is outside its range, the numbers of coefficients and thicknesses do not match, or the contact is adhesive.

    References
    ----------
    archard-1953

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.3)))
    >>> wear = mdr.wear.Wear(contact, 1e-15)
    >>> states, profile = wear.advance([0.5, 1.0], force=1e-3, intervals=16)
    >>> print(f"{states.worn_volume[-1]:.4e} {states.error[-1]:.0e}")
    1.0051e-18 2e-02
    """

    contact: Contact
    coefficient: float | tuple[float, ...]
    thickness: tuple[float, ...] = ()
    body_coefficient: float = 0.0

    def __init__(
        self,
        contact: Contact,
        coefficient: float | Sequence[float],
        thickness: Sequence[float] = (),
        body_coefficient: float = 0.0,
    ) -> None:
        if not isinstance(contact, Contact):
            raise ArgumentTypeError(f"contact = {contact!r}: it must be a Contact")
        k = row("coefficient", np.atleast_1d(numbers("coefficient", coefficient)))
        layers = numbers("thickness", thickness).ravel()
        if layers.size != len(k) - 1:
            words = f"thickness has {layers.size} and coefficient {len(k)} entries: give one coefficient more, of what lies below"
            raise InvalidArgumentError(words)
        other = number("body_coefficient", body_coefficient)
        made = native.wear_new(contact._handle, k, layers if layers.size else None, other)
        self._set(
            _handle=Handle(made),
            contact=contact,
            coefficient=k if len(k) > 1 else k[0],
            thickness=tuple(layers.tolist()),
            body_coefficient=other,
        )

    def limit(self, state: State, stick_radius: float, constant: str = "depth") -> WearLimit:
        """Return the final state of fretting with a constant stick radius.

        A disc of radius c sticks permanently and the rest slips; wear continues until the slip zone carries no load. The result is
        exact, also on coatings.

        Parameters
        ----------
        state : State
            One state of the unworn contact.
        stick_radius : float
            c, 0 < c <= a [length]. On homogeneous bodies a prescribed shift gives the stick radius of the first cycle (`Friction`);
            on coatings it is another one.
        constant : {"depth", "force"}, optional
            Which of the two of the state stays constant.

        Returns
        -------
        WearLimit
            The worn state and indenter.

        Raises
        ------
        ArgumentTypeError
            `state` is not a `State`.
        InvalidArgumentError
            `constant` is unknown.
        DomainError
            The stick radius is larger than the contact radius.

        References
        ----------
        popov-2014b
        dimaki-2014
        """
        given = _given(constant)
        c, rows = number("stick_radius", stick_radius), _row(state)
        reached, rim, volume, made = call(native.wear_limit, self._handle, rows, c, given)
        profile = WornProfile(self, "limit", (*rows.tolist(), c, float(given)), _made=made)
        return WearLimit(state_of(np.ravel(reached).tolist(), self.contact), rim, volume, profile)

    def track(self, y: ArrayLike, state: State, passes: float = 1.0) -> FloatOrArray:
        """Return the depth of the track that the sliding indenter leaves in the body.

        The depth is k N q(y) after N passes. It holds up to a tenth of the indentation depth; beyond it groove and indenter
        conform.

        Parameters
        ----------
        y : array_like
            Distances from the axis of the track, >= 0, any shape [length].
        state : State
            One state of the contact.
        passes : float, optional
            N, number of passes [1].

        Returns
        -------
        float or ndarray
            Depth of the track, in the shape of `y` [length].

        Raises
        ------
        ArgumentTypeError
            `state` is not a `State`.
        InvalidArgumentError
            `body_coefficient` is 0.
        """
        count, rows = number("passes", passes), _row(state)
        return evaluate("y", y, lambda places: native.wear_track(self._handle, rows, count, places))

    def passes_through(self, state: State, depth: float) -> float:
        """Return the number of passes until the track has a given depth.

        Parameters
        ----------
        state : State
            One state of the contact.
        depth : float
            Depth of the track on its axis, > 0 [length]; the thickness of a coating that is worn through.

        Returns
        -------
        float
            Number of passes [1].

        Raises
        ------
        InvalidArgumentError
            The depth is not greater than 0, or `body_coefficient` is 0.
        """
        return float(call(native.wear_passes, self._handle, _row(state), number("depth", depth)))

    def running_in_length(self, constant: str = "force") -> float:
        """Return the running-in length l of a flat punch.

        After a few lengths l the deviation of the pressure from the final state decays as exp(-s/l).

        Parameters
        ----------
        constant : {"force", "depth"}, optional
            "force": the pressure tends to F/(pi a^2). "depth": it tends to 0.

        Returns
        -------
        float
            l [length].

        Raises
        ------
        InvalidArgumentError
            The indenter is not a flat punch.
        """
        return float(call(native.wear_running_in, self._handle, _given(constant)))

    def history(
        self,
        *,
        force: float | None = None,
        depth: float | None = None,
        intervals: int = 80,
        places: str = "fresh",
        scheme: str = "disc",
    ) -> WearHistory:
        """Return a history of the loaded contact before it slides.

        Parameters
        ----------
        force : float, optional
            Normal force [modulus length^2]. Give one of `force` and `depth`.
        depth : float, optional
            Depth [length].
        intervals : int, optional
            Resolution, a multiple of 4, 16 to 640; errors decrease as its square or faster.
        places : {"fresh", "same"}, optional
            "fresh": the indenter slides over fresh places of the body. "same": both sides move back and forth by much less than the
            contact radius, so that the body also wears, its coating by at most a quarter of its thickness.
        scheme : {"disc", "rings"}, optional
            "disc" moves with the edge of a contact that does not shrink and is of second order. "rings" stay on the indenter and
            are of first order, for any path of load and depth and for flat punches.

        Returns
        -------
        WearHistory
            The history, at sliding distance 0.

        Raises
        ------
        ArgumentTypeError
            Not exactly one of force and depth is given.
        InvalidArgumentError
            An argument is outside its range.
        """
        return WearHistory(self, *_led(force, depth), intervals, places, scheme)

    def advance(
        self,
        sliding: ArrayLike,
        *,
        force: float | None = None,
        depth: float | None = None,
        intervals: int = 80,
        scheme: str = "disc",
    ) -> tuple[WearState, WornProfile]:
        """Return states at sliding distances under a constant force or depth.

        Parameters
        ----------
        sliding : array_like
            Ascending sliding distances of the unworn contact [length].
        force : float, optional
            Normal force [modulus length^2]. Give one of `force` and `depth`.
        depth : float, optional
            Depth [length].
        intervals : int, optional
            As in `history`.
        scheme : {"disc", "rings"}, optional
            As in `history`.

        Returns
        -------
        tuple of WearState and WornProfile
            The states, in the shape of `sliding`, and the worn indenter at the last distance. If the path ends before its last
            distance, the states of the distances before, in one dimension, with a `PathEndsWarning`.

        Raises
        ------
        ArgumentTypeError
            Not exactly one of force and depth is given.
        InvalidArgumentError
            The distances do not ascend, or an argument is outside its range.
        """
        history = self.history(force=force, depth=depth, intervals=intervals, scheme=scheme)
        distances = numbers("sliding", sliding)
        states, doubts = history._advance(np.diff(distances.ravel(), prepend=0.0), force, depth)
        shape = distances.shape if not doubts else np.shape(states.sliding)
        return WearState._make(_shaped(values, shape) for values in states)._carrying(doubts), history.profile

    def bracket(
        self,
        sliding: ArrayLike,
        *,
        force: float | None = None,
        depth: float | None = None,
        intervals: int = 80,
        scheme: str = "disc",
    ) -> tuple[WearState, WearState]:
        """Return bounds of the states of a coating that wears.

        Both sides rub on the same places. The first states keep the layers as they were; the last ones have a coating that is
        thinner by what it loses up to the end.

        Parameters
        ----------
        sliding : array_like
            As in `advance` [length].
        force : float, optional
            As in `advance` [modulus length^2].
        depth : float, optional
            As in `advance` [length].
        intervals : int, optional
            As in `history`.
        scheme : {"disc", "rings"}, optional
            As in `history`.

        Returns
        -------
        tuple of WearState and WearState
            States with the original and with the thinner coating. The force at a depth, and the depth under a force, lie between
            both.

        Raises
        ------
        InvalidArgumentError
            The medium has no layers, or the coating loses more than a quarter of its thickness.
        """
        distances = numbers("sliding", sliding)
        steps = np.diff(distances.ravel(), prepend=0.0)

        def run(wear: Wear) -> WearState:
            history = wear.history(force=force, depth=depth, intervals=intervals, places="same", scheme=scheme)
            return history._advance_all(steps, force, depth)

        first = last = run(_thinner(self, 0.0))
        lost = 0.0
        for _ in range(_ROUNDS):
            now = float(np.ravel(last.body_depth)[-1])
            if now <= lost:
                break
            lost = now * (1.0 + _CLOSE)
            last = run(_thinner(self, lost))
        first, last = (WearState._make(_shaped(values, distances.shape) for values in states) for states in (first, last))
        return first, last


def _thinner(wear: Wear, lost: float) -> Wear:
    """Return the same contact with a thinner first layer."""
    contact = wear.contact
    return wear.replace(contact=contact.replace(medium=contact.medium._with_thinner_coating(lost)))


def _shaped(values: FloatOrArray, shape: tuple[int, ...]) -> FloatOrArray:
    return np.reshape(values, shape) if shape else float(np.ravel(values)[0])


def _given(constant: str) -> int:
    if constant not in ("depth", "force"):
        raise InvalidArgumentError(f"constant = {constant!r}: it must be 'depth' or 'force'")
    return _layout.FORCE if constant == "force" else _layout.DEPTH


def _led(force: Any, depth: Any) -> tuple[str, float]:
    """Return the name of the given quantity, and its value."""
    if (force is None) == (depth is None):
        raise ArgumentTypeError("give exactly one of force and depth")
    return ("depth", number("depth", depth)) if force is None else ("force", number("force", force))


def _row(state: State) -> NDArray[np.float64]:
    if not isinstance(state, State):
        raise ArgumentTypeError(f"state = {state!r}: it must be a State of the contact")
    return np.array(state._row())


@dataclass(frozen=True)
class WornProfile(Profile):
    """Worn indenter, for new contacts; depths count from its new apex.

    `Wear.limit` and `WearHistory.profile` return it.

    Parameters
    ----------
    wear : Wear
        The contact that wears.
    kind : {"limit", "history"}
        How the indenter was worn.
    numbers : tuple of float
        Numbers from which the profile is made again.

    Raises
    ------
    ValueError
        The numbers are not those of a worn profile.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.3)))
    >>> states, worn = mdr.wear.Wear(contact, 1e-15).advance([0.5, 1.0], force=1e-3, intervals=16)
    >>> print(f"{worn.worn_depth(0.0):.4e} {states.worn_depth[-1]:.4e}")
    1.7822e-07 1.7822e-07
    """

    _is_table = True

    wear: Wear
    kind: str
    numbers: tuple[float, ...]

    def __init__(self, wear: Wear, kind: str, numbers: tuple[float, ...], _made: int | None = None) -> None:
        made = _made
        if made is None and kind == "limit":
            *rows, c, given = numbers
            made = call(native.wear_limit, wear._handle, np.array(rows), c, int(given))[3]
        elif made is None:
            made = _native_profile(_restored(wear, numbers))
        self._own((0, made), wear=wear, kind=kind, numbers=tuple(numbers))

    def worn_depth(self, r: ArrayLike) -> FloatOrArray:
        """Return the wear depth at given radii, measured from the original indenter.

        Parameters
        ----------
        r : array_like
            Radii >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            Wear depth, in the shape of `r` [length].

        Raises
        ------
        DomainError
            The indenter has no surface at a radius.
        """
        return self.height(r) - self.wear.contact.indenter.height(r) + self._worn_on_axis()

    def _worn_on_axis(self) -> float:
        """Nothing within the disc that sticks; of a history where nothing is worn, from the edge on, the heights differ by it."""
        if self.kind == "limit":
            return 0.0
        history = _restored(self.wear, self.numbers)
        if history.scheme == "rings":
            return float(history.state.worn_depth + history.state.body_depth)
        edge = float(history.state.radius)
        return float(self.wear.contact.indenter.height(edge) - self.height(edge))


def _where_it_ends(refusal: Refusal, sliding: NDArray[np.float64]) -> Caution:
    """The warning of a path that ends before its last part; raises where nothing was possible, or the input is wrong."""
    error = refusal.error(single=sliding.size == 1)
    if refusal.entry < 2 or not isinstance(error, (DomainError, NoConvergenceError)):
        raise error
    done = float(np.sum(sliding[: refusal.entry - 1]))
    text = f"the path ends after {refusal.entry - 1} of {sliding.size} parts, {done:g} further: {refusal.argument}{refusal.text}"
    return Caution(text, PathEndsWarning)


def _restored(wear: Wear, past: Sequence[float]) -> WearHistory:
    kind, value, intervals, places, scheme, *saved = past
    chosen = int(intervals), _PLACES[int(places)], SCHEMES[int(scheme)]
    history = WearHistory(wear, "force" if kind else "depth", value, *chosen)
    return history.restored(saved)


def _native_profile(history: WearHistory) -> int:
    return int(call(native.wear_history_profile, history._handle))


class WearHistory:
    """Sliding contact and its wear so far, from `Wear.history`.

    Two resolutions are integrated together; their difference is `state.error`. The results of the scheme "disc" are their
    extrapolation. The object changes as it advances: do not share it between threads. A `copy()` continues independently; a pickle
    continues bitwise identically.

    Parameters
    ----------
    wear : Wear
        The contact that wears.
    constant : {"force", "depth"}
        What `value` is.
    value : float
        Initial force [modulus length^2] or depth [length].
    intervals : int, optional
        As in `Wear.history`.
    places : {"fresh", "same"}, optional
        As in `Wear.history`.
    scheme : {"disc", "rings"}, optional
        As in `Wear.history`.

    Raises
    ------
    ArgumentTypeError
        `wear` is not a `Wear`.
    InvalidArgumentError
        An argument is outside its range.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.3)))
    >>> history = mdr.wear.Wear(contact, 1e-15).history(force=1e-3, intervals=16)
    >>> state = history.advance(0.5, force=1e-3)
    >>> print(f"{state.worn_volume:.4e} {history.pressure(0.0):.3e}")
    5.0272e-19 1.268e+08
    """

    def __init__(
        self, wear: Wear, constant: str, value: float, intervals: int = 80, places: str = "fresh", scheme: str = "disc"
    ) -> None:
        if not isinstance(wear, Wear):
            raise ArgumentTypeError(f"wear = {wear!r}: it must be a Wear")
        for name, word, words in (("places", places, _PLACES), ("scheme", scheme, SCHEMES)):
            if word not in words:
                raise InvalidArgumentError(f"{name} = {word!r}: {nearest(str(word), words)}")
        count = whole("intervals", intervals, 1)
        options = record(_layout.wear_options, intervals=count, places=_layout.WEAR_FRESH + _PLACES.index(places),
                         scheme=_layout.WEAR_DISC + SCHEMES.index(scheme))  # fmt: skip
        given = _given(constant), number(constant, value)
        self._own(native.wear_history_new(wear._handle, *given, options))
        self._made_from = constant, float(value), count, places, scheme
        self.wear, self.scheme = wear, scheme

    def _own(self, made: tuple[int, int]) -> None:
        self._handle = Handle(made)

    def advance(self, sliding: ArrayLike, *, force: ArrayLike | None = None, depth: ArrayLike | None = None) -> WearState:
        """Slide by a distance while force or depth changes linearly to its value.

        Arrays of one dimension, which broadcast, are parts of the path one after the other.

        Parameters
        ----------
        sliding : array_like
            Distances >= 0 of each part [length].
        force : array_like, optional
            Force at the end of each part [modulus length^2]. Give one of `force` and `depth`.
        depth : array_like, optional
            Depth from the original apex at the end of each part [length].

        Returns
        -------
        WearState
            States at the ends of the parts. If a part after the first one is not possible, the states of the parts before it with a
            `PathEndsWarning`; the history is then at the last of them.

        Raises
        ------
        ArgumentTypeError
            Not exactly one of force and depth is given.
        DomainError
            The contact would shrink under the scheme "disc", as under a falling force. After an error the history is unchanged.
        """
        return self._advance(sliding, force, depth)[0]

    def _advance(self, sliding: ArrayLike, force: ArrayLike | None, depth: ArrayLike | None) -> tuple[WearState, list[Caution]]:
        """The states, and why there are fewer than parts."""
        if (force is None) == (depth is None):
            raise ArgumentTypeError("give exactly one of force and depth")
        name, values = ("depth", depth) if force is None else ("force", force)
        distances, targets = together(**{"sliding": sliding, name: np.asarray(values)})
        if distances.ndim > 1:
            raise ArgumentTypeError("parts of a path are numbers or arrays of one dimension")
        if not distances.size:
            return WearState._make([np.empty(0)] * len(WearState._fields)), []
        parts = distances.ravel(), targets.ravel()
        status, found = outcome(native.wear_history_advance, self._handle, _given(name), *parts)
        doubts: list[Caution] = []
        if status:
            refusal = Refusal(status)
            doubts, done = [_where_it_ends(refusal, parts[0])], refusal.entry - 1
            found = call(native.wear_history_advance, self._handle, _given(name), *(part[:done] for part in parts))
            warn(*doubts[0])
        states = WearState._make(float(values[0]) if not distances.ndim else values for values in found.T)
        return states._carrying(doubts), doubts

    def _advance_all(self, sliding: NDArray[np.float64], force: float | None, depth: float | None) -> WearState:
        """The states of all parts, where those of some are of no use."""
        with collected():
            states, doubts = self._advance(sliding, force, depth)
        if doubts:
            raise DomainError(doubts[0].text)
        return states

    @property
    def state(self) -> WearState:
        """Present state of the history."""
        return WearState._make(float(value) for value in np.ravel(call(native.wear_history_state, self._handle, [0.0])[0]))

    def pressure(self, r: ArrayLike) -> FloatOrArray:
        """Return the pressure p(r), with the resolution of the intervals.

        Parameters
        ----------
        r : array_like
            Radii >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            p, in the shape of `r`, 0 outside the contact [modulus].

        Raises
        ------
        InvalidArgumentError
            A radius is negative.
        """
        return evaluate("r", r, lambda radii: native.wear_history_state(self._handle, radii)[::2])

    @property
    def profile(self) -> WornProfile:
        """Present worn indenter, for new contacts; of the gap if both sides wear."""
        constant, value, intervals, places, scheme = self._made_from
        chosen = float(intervals), float(_PLACES.index(places)), float(SCHEMES.index(scheme))
        past = (float(constant == "force"), value, *chosen, *self.saved().tolist())
        return WornProfile(self.wear, "history", past, _made=_native_profile(self))

    def saved(self) -> NDArray[np.float64]:
        """Return the past as numbers.

        `restored` continues from them bitwise identically.

        Returns
        -------
        ndarray
            The numbers.
        """
        values, count = call(native.wear_history_save, self._handle, _LONGEST_PAST)
        return np.array(values[:count])

    def restored(self, past: ArrayLike) -> WearHistory:
        """Return a history of this contact that continues from a saved past.

        Parameters
        ----------
        past : array_like
            What `saved` returned, with the same intervals.

        Returns
        -------
        WearHistory
            The history.

        Raises
        ------
        InvalidArgumentError
            The numbers are not a past of this contact.
        """
        other = self.copy()
        call(native.wear_history_restore, other._handle, numbers("past", past).ravel())
        return other

    def copy(self) -> WearHistory:
        """Return a history with the same past that continues independently.

        Returns
        -------
        WearHistory
            The copy.
        """
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        other._own(native.wear_history_copy(self._handle))
        return other

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> WearHistory:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return _gone_on, (self.wear, *self._made_from, self.saved())

    def __repr__(self) -> str:
        return f"<WearHistory of {self.wear!r} after sliding {self.state.sliding:g}>"


def _gone_on(wear: Wear, constant: str, value: float, intervals: int, places: str, scheme: str, past: ArrayLike) -> WearHistory:
    return WearHistory(wear, constant, value, intervals, places, scheme).restored(past)


def wear_coefficient_from_volume(volume: ArrayLike, sliding: ArrayLike, force: ArrayLike) -> WearFit:
    """Fit the wear coefficient k to worn volumes, `V = k F s`.

    The fit is a straight line through 0 and holds for any bodies.

    Parameters
    ----------
    volume : array_like
        Worn volumes > 0 [length^3].
    sliding : array_like
        Sliding distances > 0 [length].
    force : array_like
        Normal forces > 0 [modulus length^2]. The three broadcast.

    Returns
    -------
    WearFit
        k and its standard deviation.

    Raises
    ------
    InvalidArgumentError
        The data are empty or not greater than 0.

    References
    ----------
    archard-1953

    Examples
    --------
    >>> fit = mdr.wear.wear_coefficient_from_volume([1.0e-18, 2.1e-18], sliding=[1.0, 2.0], force=1e-3)
    >>> print(f"{fit.coefficient:.3e}")
    1.040e-15
    """
    found, work = (values.ravel() for values in together(volume=volume, work=np.multiply(sliding, force)))
    if not found.size or not np.all(work > 0.0) or not np.all(found > 0.0):
        raise InvalidArgumentError("volume, sliding and force must not be empty and must be greater than 0")
    k = float(np.sum(found * work) / np.sum(work**2))
    return WearFit(k, _deviation(found - k * work, work))


def wear_coefficient_from_scar(contact: Contact, radius: ArrayLike, sliding: ArrayLike, force: float) -> WearFit:
    """Fit the wear coefficient k of a sliding indenter to radii of its scar.

    The scar radii are the contact radii under a constant force. The fit uses least squares of the radii, also on layered bodies.

    Parameters
    ----------
    contact : Contact
        The unworn contact.
    radius : array_like
        Radii of the scar, larger than that of the unworn contact [length].
    sliding : array_like
        Sliding distances > 0 [length].
    force : float
        Constant normal force [modulus length^2].

    Returns
    -------
    WearFit
        k and its standard deviation.

    Raises
    ------
    InvalidArgumentError
        A distance is not greater than 0, or a radius is not larger than that of the unworn contact.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.3)))
    >>> fit = mdr.wear.wear_coefficient_from_scar(contact, [1.60e-6, 1.90e-6], [0.5, 1.0], force=1e-3)
    >>> print(f"{fit.coefficient:.2e}")
    1.01e-15
    """
    radii, distances = (values.ravel() for values in together(radius=radius, sliding=sliding))
    start = float(contact.at_force(force).radius)
    if not radii.size or not np.all(distances > 0.0) or not np.all(radii > start):
        words = f"sliding must be greater than 0, and radius greater than that of the unworn contact, {start:g}"
        raise InvalidArgumentError(words)
    order = np.argsort(distances)
    radii, distances = radii[order], distances[order]
    unit = Wear(contact, 1.0)

    def model(k: float) -> NDArray[np.float64]:
        history = unit.history(force=force)
        return np.asarray(history._advance_all(np.diff(k * distances, prepend=0.0), force, None).radius)

    # uniform pressure under the unworn profile, without its elastic part: the volume inside the scar
    r = np.linspace(0.0, float(radii[-1]), 401)
    f = np.asarray(contact.indenter.height(r))
    lost = 2.0 * np.pi * float(np.sum((f[-1] - f) * r)) * float(r[1])
    return _fitted(model, radii, lost / (force * float(distances[-1])))


def _fitted(model: Callable[[float], NDArray[np.float64]], measured: NDArray[np.float64], k: float) -> WearFit:
    """Least squares of one positive number, by steps of its logarithm."""
    for _ in range(_ROUNDS):
        found = model(k)
        slope = (model(k * (1.0 + _PART)) - found) / np.log1p(_PART)
        step = float(np.clip(np.sum(slope * (measured - found)) / np.sum(slope**2), -2.0, 2.0))
        k *= float(np.exp(step))
        if abs(step) < _CLOSE:
            break
    return WearFit(k, k * _deviation(measured - model(k), slope))


def _deviation(residuals: NDArray[np.float64], slope: NDArray[np.float64]) -> float:
    if residuals.size < 2:
        return float("nan")
    return float(np.sqrt(np.sum(residuals**2) / (residuals.size - 1) / np.sum(slope**2)))
