# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear of a contact by Archard's law (docs/wear.md): where fretting ends, the track of a tip, a sliding indenter step by step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import FloatOrArray, Handle, call, evaluate, native, number, numbers, record, row, together, whole, words_of
from ._choices import nearest
from ._value import Value
from .contact import Contact
from .errors import ArgumentTypeError, InvalidArgumentError
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
"""In the order of the library's codes."""
_LONGEST_PAST = 2000
"""Numbers of a saved past at most."""
_ROUNDS, _CLOSE, _PART = 40, 1e-9, 1e-2
"""Steps of a fit, where they end, and the part of a coefficient by which a slope is taken."""


class WearLimit(NamedTuple):
    """Where fretting with a given radius of stick ends."""

    state: State
    """depth, stick radius c, force, stiffness, and as `punch_depth` the depth beyond that of the unworn state at c"""
    outer_radius: float
    """b, up to where the indenter is worn [length]"""
    worn_volume: float
    """of both sides together [length^3]"""
    profile: WornProfile
    """the worn indenter, with the wear of both sides"""


class WearState(NamedTuple):
    """What a history of wear has come to; each entry has the shape of the input, or is a number."""

    sliding: FloatOrArray
    """s since the beginning [length]"""
    depth: FloatOrArray
    """d from the original apex of the indenter [length]"""
    radius: FloatOrArray
    """a [length]"""
    force: FloatOrArray
    """F [modulus length^2]"""
    pressure: FloatOrArray
    """p on the axis [modulus]"""
    worn_depth: FloatOrArray
    """what the indenter has lost on the axis [length]"""
    worn_volume: FloatOrArray
    """what it has lost as a whole [length^3]"""
    body_depth: FloatOrArray
    """what the body has lost on the axis, where both rub on the same places, else 0 [length]"""
    body_volume: FloatOrArray
    """the same as a whole [length^3]"""
    work: FloatOrArray
    """int F ds [modulus length^3]"""
    error: FloatOrArray
    """the largest relative error of a, d, F, p and the worn depth: two resolutions differ by so much"""


class WearFit(NamedTuple):
    """A coefficient of wear from measurements."""

    coefficient: float
    """k [1/modulus]"""
    sd: float
    """its standard deviation from the scatter of the measurements; nan for one measurement"""


@dataclass(frozen=True)
class Wear(Value):
    """A contact without adhesion that wears by Archard's law, dh = k p ds: the worn volume is k times force times distance.

    contact : a `Contact`; a sliding indenter needs a homogeneous or an exact medium
    coefficient : k > 0 of the indenter [1/modulus]; of a coated one those of its layers from the surface and of what lies below
    thickness : of the layers of the indenter, one less than coefficients [length]
    body_coefficient : k >= 0 of the body [1/modulus]

    The layers of the body stay as they are, which makes all of it exact on coatings; `track` and `history(places="same")` say how
    far that goes.
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
            raise ArgumentTypeError(f"contact = {contact!r} is not allowed: it must be a Contact")
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
        """Where fretting ends: a disc of radius c sticks for good, all outside slips and wears until it carries nothing.

        state : one state of the unworn contact
        stick_radius : c, 0 < c <= a [length]
        constant : the "depth" or the "force" of the state is held

        Exact, on coatings too. What c a prescribed shift leads to is not computed: on homogeneous bodies it is the stick radius of
        the first cycle (`Friction`), on coatings it is another one.
        """
        given = _given(constant)
        c, rows = number("stick_radius", stick_radius), _row(state)
        reached, rim, volume, made = call(native.wear_limit, self._handle, rows, c, given)
        profile = WornProfile(self, "limit", (*rows.tolist(), c, float(given)), _made=made)
        return WearLimit(state_of(np.ravel(reached).tolist(), self.contact), rim, volume, profile)

    def track(self, y: ArrayLike, state: State, passes: float = 1.0) -> FloatOrArray:
        """Depth of the track that the sliding indenter leaves in the body after so many passes, k N q(y), at distances y >= 0 from
        its axis, any shape [length]; up to a tenth of the indentation depth, beyond which groove and indenter conform."""
        count, rows = number("passes", passes), _row(state)
        return evaluate("y", y, lambda places: native.wear_track(self._handle, rows, count, places))

    def passes_through(self, state: State, depth: float) -> float:
        """Passes until the track is so deep, > 0 [length]: a coating of this thickness is then worn through on the axis."""
        return float(call(native.wear_passes, self._handle, _row(state), number("depth", depth)))

    def running_in_length(self, constant: str = "force") -> float:
        """l [length]: under a flat punch what the pressure still differs by from that at the end falls as exp(-s/l) after a few l.

        constant : the "force", where the pressure tends to F/(pi a^2), or the "depth", where it tends to 0
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
        """The contact pressed on by a force [modulus length^2] or to a depth [length], that has not slid yet.

        intervals : a multiple of 4, 16 to 640; errors fall as their square or faster
        places : "fresh" places of the body, as a tip that goes its way; or the "same", as both sides do that move back and forth by
            much less than the contact radius: then the body wears too, its coating by a quarter of its thickness at most
        scheme : "disc", which moves with the edge of a contact that does not shrink, of second order; or "rings" that stay on the
            indenter, of first order, for any path of load and depth and for flat punches too
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
        """States at ascending sliding distances from the unworn contact on, under a constant force [modulus length^2] or depth
        [length], and the worn indenter at the last one; `history` goes on from state to state, and says what can be chosen."""
        history = self.history(force=force, depth=depth, intervals=intervals, scheme=scheme)
        distances = numbers("sliding", sliding)
        states = history.advance(np.diff(distances.ravel(), prepend=0.0), force=force, depth=depth)
        return WearState._make(_shaped(values, distances.shape) for values in states), history.profile

    def bracket(
        self,
        sliding: ArrayLike,
        *,
        force: float | None = None,
        depth: float | None = None,
        intervals: int = 80,
        scheme: str = "disc",
    ) -> tuple[WearState, WearState]:
        """What the wear of a coating, or of the first layer, leaves open: states as of `advance`, where both sides rub on the same
        places, with the layers as they were, and with a coating that is thinner by what it loses up to the end.

        With layers as they were wear of the body is of first order in depth lost over thickness. A coating that is thinner by at
        most so much, whatever its shape, stores an energy between those of the two uniform ones: the force at a depth, and the
        depth under a force, lie between. Refused for media without layers, and beyond a loss of a quarter of the thickness.
        """
        distances = numbers("sliding", sliding)
        steps = np.diff(distances.ravel(), prepend=0.0)

        def run(wear: Wear) -> WearState:
            history = wear.history(force=force, depth=depth, intervals=intervals, places="same", scheme=scheme)
            return history.advance(steps, force=force, depth=depth)

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
    """The same with a first layer that is thinner."""
    contact = wear.contact
    return wear.replace(contact=contact.replace(medium=contact.medium._with_thinner_coating(lost)))


def _shaped(values: FloatOrArray, shape: tuple[int, ...]) -> FloatOrArray:
    return np.reshape(values, shape) if shape else float(np.ravel(values)[0])


def _given(constant: str) -> int:
    if constant not in ("depth", "force"):
        raise InvalidArgumentError(f"constant = {constant!r} is not allowed: it must be 'depth' or 'force'")
    return _layout.FORCE if constant == "force" else _layout.DEPTH


def _led(force: Any, depth: Any) -> tuple[str, float]:
    """What is given, and its value."""
    if (force is None) == (depth is None):
        raise ArgumentTypeError("a contact that wears needs one of force and depth, and not both")
    return ("depth", number("depth", depth)) if force is None else ("force", number("force", force))


def _row(state: State) -> NDArray[np.float64]:
    if not isinstance(state, State):
        raise ArgumentTypeError(f"state = {state!r} is not allowed: it must be a State of the contact")
    return np.array(state._row())


@dataclass(frozen=True)
class WornProfile(Profile):
    """A worn indenter, for new contacts with it: `wear.limit(...).profile`, `history.profile`. Depths count from its new apex.

    wear : the contact that wears
    kind : "limit" of fretting or "history"
    numbers : what it was made from
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
        """What wear has taken at radii r >= 0 [length], any shape, measured from the original indenter [length]."""
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


def _restored(wear: Wear, past: Sequence[float]) -> WearHistory:
    kind, value, intervals, places, scheme, *saved = past
    chosen = int(intervals), _PLACES[int(places)], SCHEMES[int(scheme)]
    history = WearHistory(wear, "force" if kind else "depth", value, *chosen)
    return history.restored(saved)


def _native_profile(history: WearHistory) -> int:
    return int(call(native.wear_history_profile, history._handle))


class WearHistory:
    """A sliding contact and what it has lost so far: `wear.history(force=...)`.

    Two resolutions march side by side and their difference is `state.error`; a disc's results are their extrapolation. It changes
    as it advances: not for several threads at a time. Each `copy()` goes its own way;
    a pickled one goes on with the same bits.
    """

    def __init__(
        self, wear: Wear, constant: str, value: float, intervals: int = 80, places: str = "fresh", scheme: str = "disc"
    ) -> None:
        if not isinstance(wear, Wear):
            raise ArgumentTypeError(f"wear = {wear!r} is not allowed: it must be a Wear")
        for name, word, words in (("places", places, _PLACES), ("scheme", scheme, SCHEMES)):
            if word not in words:
                raise InvalidArgumentError(f"{name} = {word!r} is not allowed: {nearest(str(word), words)}")
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
        """Slides on by a distance >= 0 [length], while the force [modulus length^2] or the depth from the original apex [length]
        goes evenly to its value; arrays of one dimension, which broadcast, are parts of the path one after the other.

        Returns the states at the ends of the parts. After an error the history is as before and can go on with other values. By
        the scheme "disc" a contact that would shrink, as under a falling force, is refused.
        """
        if (force is None) == (depth is None):
            raise ArgumentTypeError("a contact that wears needs one of force and depth, and not both")
        name, values = ("depth", depth) if force is None else ("force", force)
        distances, targets = together(**{"sliding": sliding, name: np.asarray(values)})
        if distances.ndim > 1:
            raise ArgumentTypeError("parts of a path are numbers or arrays of one dimension")
        if not distances.size:
            return WearState._make([np.empty(0)] * len(WearState._fields))
        found = call(native.wear_history_advance, self._handle, _given(name), distances.ravel(), targets.ravel())
        return WearState._make(float(values[0]) if not distances.ndim else values for values in found.T)

    @property
    def state(self) -> WearState:
        """What it has come to."""
        return WearState._make(float(value) for value in np.ravel(call(native.wear_history_state, self._handle, [0.0])[0]))

    def pressure(self, r: ArrayLike) -> FloatOrArray:
        """p(r) [modulus] at r >= 0 [length], any shape, with the resolution of the intervals; 0 outside the contact."""
        return evaluate("r", r, lambda radii: native.wear_history_state(self._handle, radii)[::2])

    @property
    def profile(self) -> WornProfile:
        """The indenter as it is now, for new contacts; of the gap, where both sides wear."""
        constant, value, intervals, places, scheme = self._made_from
        chosen = float(intervals), float(_PLACES.index(places)), float(SCHEMES.index(scheme))
        past = (float(constant == "force"), value, *chosen, *self.saved().tolist())
        return WornProfile(self.wear, "history", past, _made=_native_profile(self))

    def saved(self) -> NDArray[np.float64]:
        """The past as numbers, from which `restored` goes on with the same bits."""
        values, count = call(native.wear_history_save, self._handle, _LONGEST_PAST)
        return np.array(values[:count])

    def restored(self, past: ArrayLike) -> WearHistory:
        """A history of the same contact and intervals that goes on from a saved past."""
        other = self.copy()
        call(native.wear_history_restore, other._handle, numbers("past", past).ravel())
        return other

    def copy(self) -> WearHistory:
        """The same past, which goes its own way from here."""
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
    """k from worn volumes [length^3] after sliding distances [length] under forces [modulus length^2]: the straight line through 0,
    V = k F s, whatever the bodies are."""
    found, work = (values.ravel() for values in together(volume=volume, work=np.multiply(sliding, force)))
    if not found.size or not np.all(work > 0.0) or not np.all(found > 0.0):
        raise InvalidArgumentError("volume, sliding and force must not be empty and must be greater than 0")
    k = float(np.sum(found * work) / np.sum(work**2))
    return WearFit(k, _deviation(found - k * work, work))


def wear_coefficient_from_scar(contact: Contact, radius: ArrayLike, sliding: ArrayLike, force: float) -> WearFit:
    """k of a sliding indenter from radii of its scar, the contact radii [length], at sliding distances > 0 [length].

    The force [modulus length^2] is constant; least squares of the radii, on layered bodies too."""
    radii, distances = (values.ravel() for values in together(radius=radius, sliding=sliding))
    start = float(contact.at_force(force).radius)
    if not radii.size or not np.all(distances > 0.0) or not np.all(radii > start):
        words = f"sliding must be greater than 0, and radius greater than that of the unworn contact, {start:g}"
        raise InvalidArgumentError(words)
    order = np.argsort(distances)
    radii, distances = radii[order], distances[order]
    unit = Wear(contact, 1.0)

    def model(k: float) -> NDArray[np.float64]:
        return np.asarray(unit.advance(k * distances, force=force)[0].radius)

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
