# SPDX-License-Identifier: GPL-3.0-or-later
"""A work of adhesion that depends on the speed of the contact's edge, and the histories of such contacts (docs/rate.md)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import FloatOrArray, Handle, call, evaluate, native, number, record
from .._progress import marching
from .._units import RATIO, SPEED, WORK_OF_ADHESION
from .._value import Value
from .._warn import Caution, Warned, warn_all
from ..errors import AdhesionRateWarning, ArgumentTypeError, InvalidArgumentError
from ..loop import CONTROLS
from ..material import Viscoelastic
from ..progress import Progress
from .cohesive import STATE, controlled_path

_FASTEST, _LONGEST = 0.02, 0.03
"""v time/a and zone/a up to which a steady crack gives pull-off to 2 %."""
_ROOM = 1.02
"""Contacts are sampled this much beyond the largest equilibrium of a history."""


class _RateHistoryNumbers(NamedTuple):
    """The numbers of a `RateHistory`."""

    time: NDArray[np.float64]
    """[time]"""
    depth: NDArray[np.float64]
    """d, that of the bodies where they are apart [length]"""
    radius: NDArray[np.float64]
    """a, 0 where they are apart [length]"""
    force: NDArray[np.float64]
    """F [modulus length^2]"""
    speed: NDArray[np.float64]
    """v = -da/dt of the edge, > 0 where it opens [length/time]"""
    dissipated: NDArray[np.float64]
    """energy lost at the edge so far, beyond the work of adhesion of an edge at rest [modulus length^3]"""
    work: NDArray[np.float64]
    """int F dd so far [modulus length^3]"""
    end: dict[str, float]
    """at the last time, from which a history goes on (`start=`): "radius", "depth", "dissipated", "work"; of the lowest force,
    pull-off, "lowest_force", "lowest_time", "lowest_depth", "lowest_radius", "lowest_speed"; of the last time that the contact
    broke "rupture_time", "rupture_depth"; and how often it broke, "ruptures" """


class RateHistory(_RateHistoryNumbers, Warned):
    """The path of a contact whose edge moves at a finite speed: arrays of one length, then what happened once."""


class _Rate(Value):
    """What works of adhesion that depend on speed have in common."""

    work: float

    def at_speed(self, v: ArrayLike) -> FloatOrArray:
        """G [modulus length] of an edge of speed v [length/time], > 0 where it opens, any shape; `work` at v = 0."""
        options = self._options()
        return evaluate("v", v, lambda values: native.rate_work(options, values)[:2])

    def _options(self, **more: float) -> NDArray[Any]:
        """The library's options."""
        return record(_layout.rate_options, **{name: value for name, value in self._given().items() if value is not None}, **more)

    def _scales(self) -> tuple[float, float]:
        """Longest time of creep and length of the cohesive zone; 0 where they are not known."""
        _, time, zone = call(native.rate_work, self._options(), [0.0])
        return float(time), float(zone)


@dataclass(frozen=True)
class RateAdhesion(_Rate):
    """A work of adhesion that depends on the speed v of the contact's edge (Gent and Schultz 1972, Maugis and Barquins 1978).

    work : gamma0 > 0, of an edge that just opens; `Contact.at_depth` and the like are in equilibrium with it [modulus length]
    speed : v0 > 0 at which an edge that opens costs twice that: G = work (1 + (v/speed)^exponent) [length/time]
    exponent : n, 0 < n <= 2 [1]
    closing_work, closing_speed, closing_exponent : of an edge that closes, G = closing_work/(1 + (|v|/closing_speed)^
        closing_exponent); closing_work at most `work`: in between the edge stands still. None: those of the opening edge
    """

    work: float = field(metadata={"dimension": WORK_OF_ADHESION})
    speed: float = field(metadata={"dimension": SPEED})
    exponent: float = field(metadata={"dimension": RATIO})
    closing_work: float | None = field(default=None, metadata={"dimension": WORK_OF_ADHESION})
    closing_speed: float | None = field(default=None, metadata={"dimension": SPEED})
    closing_exponent: float | None = field(default=None, metadata={"dimension": RATIO})

    def __post_init__(self) -> None:
        given = {name: value if value is None else number(name, value) for name, value in self._given().items()}
        self._set(**given)
        for name in ("closing_work", "closing_speed", "closing_exponent"):
            if given[name] == 0.0:
                raise InvalidArgumentError(
                    f"{name} = 0 is not allowed: it must be greater than 0; None is that of the opening edge"
                )
        self.at_speed(0.0)

    @classmethod
    def from_rheology(cls, material: Viscoelastic, work: float, cohesive_stress: float) -> RheologicalAdhesion:
        """The law of a viscoelastic surface, see `RheologicalAdhesion`."""
        return RheologicalAdhesion(material, work, cohesive_stress)


@dataclass(frozen=True)
class RheologicalAdhesion(_Rate):
    """The work of adhesion of a viscoelastic surface whose cohesion does not depend on speed: that of a steady crack (Greenwood
    and Johnson 1981), from 1 to E_glassy/E_relaxed times `work` where it opens, and down to the inverse where it closes.

    material : of the surface layer, with a glassy and a relaxed modulus. The contact's medium has the relaxed ones
    work : gamma0 > 0 [modulus length]
    cohesive_stress : sigma > 0; with it the scale of the speed, E* work/(sigma^2 time) [modulus]

    It holds while the edge is slow against the material, v time/a <= 0.02, and its cohesive zone short, zone/a <= 0.03: pull-off is
    then good to 2 %. Histories beyond give an `AdhesionRateWarning`.
    """

    material: Viscoelastic
    work: float
    cohesive_stress: float

    def __post_init__(self) -> None:
        if not isinstance(self.material, Viscoelastic):
            raise ArgumentTypeError(f"material = {self.material!r} is not allowed: it must be a Viscoelastic")
        stress = number("cohesive_stress", self.cohesive_stress)
        self._set(work=number("work", self.work), cohesive_stress=stress)
        self.at_speed(0.0)

    def _options(self, **more: float) -> NDArray[Any]:
        return record(_layout.rate_options, material=self.material._handle, work=self.work,
                      cohesive_stress=self.cohesive_stress, **more)  # fmt: skip


def work(name: str, value: Any, adhesion: Any) -> float:
    """The work of adhesion of a contact at rest."""
    if adhesion is None:
        return number(name, value)
    if not isinstance(adhesion, _Rate):
        raise ArgumentTypeError(f"adhesion = {adhesion!r} is not allowed: it must be a RateAdhesion")
    if number(name, value) not in (0.0, adhesion.work):
        raise InvalidArgumentError(f"{name} = {value!r} is not allowed beside adhesion=, which has work = {adhesion.work!r}")
    return adhesion.work


def sampled(contact: Handle, adhesion: _Rate, largest: float) -> Handle:
    """The library's contact with a rate, up to a largest contact radius."""
    return Handle(native.rate_new(contact, adhesion._options(largest_radius=largest)))


def rate_history(
    contact: Any,
    time: ArrayLike,
    *,
    depth: ArrayLike | None = None,
    force: ArrayLike | None = None,
    position: ArrayLike | None = None,
    spring_stiffness: float | None = None,
    start: str | Mapping[str, float] = "apart",
    tolerance: float | None = None,
    progress: bool | Progress = False,
) -> RateHistory:
    """Follow a contact whose work of adhesion depends on the speed of its edge.

    Parameters
    ----------
    contact : Contact
        With `adhesion`, on an elastic body (of a viscoelastic one the relaxed moduli).
    time : array_like
        Strictly ascending, one dimension [time]. Before the first the bodies are apart and at rest.
    depth, force, position : array_like
        One of them [length], [modulus length^2], [length]; linear in time in between, the first is reached in a jump. `position`
        is the far end of a spring that presses the indenter, d + F/spring_stiffness.
    spring_stiffness : float, optional
        Of that spring, > 0 [modulus length].
    start : str or mapping, optional
        "apart", the default; "rest": in equilibrium with the first value, the largest stable one; or the `end` of a history that
        this one continues, whose last time and value are the first of this one. A dict with "radius" alone begins at that radius.
    tolerance : float, optional
        Of ln(radius) in each step, 1e-12 to 1e-3; default 1e-9.
    progress : bool or Progress, optional
        True shows a bar on a terminal if it takes more than two seconds; a `Progress` follows each round.

    Returns
    -------
    RateHistory

    Raises
    ------
    InvalidArgumentError
        The contact has no `adhesion`.
    UnreachableError
        There is no stable contact from which to start.
    """
    control, stiffness, accuracy, t, s = controlled_path(
        time, {"position": position, "depth": depth, "force": force}, spring_stiffness, tolerance
    )
    if contact.adhesion is None:
        raise InvalidArgumentError("contact is not allowed: it must have an adhesion, as RateAdhesion(...)")
    row = _start(start)
    handle = contact._rate_handle(contact.adhesion, max(row[0], _largest(contact, control, float(np.max(s)))) * _ROOM)
    with marching(t.size, progress):
        d, a, F, v, lost, done, end = call(native.rate_history, handle, control, stiffness, accuracy, row, t, s)
    found = RateHistory(t, d, a, F, v, lost, done, dict(zip(STATE, end.tolist(), strict=True)))
    doubts = _doubts_of(contact.adhesion, found)
    warn_all(doubts)
    return found._carrying(doubts)


def _doubts_of(adhesion: _Rate, found: RateHistory) -> list[Caution]:
    """Whether a law that follows from a material is beyond its range: at the lowest force, and while the contact is larger than
    half of its largest radius."""
    time, zone = adhesion._scales()
    large = found.radius > 0.5 * np.max(found.radius)
    speeds, radii = np.abs(found.speed[large]), found.radius[large]
    if found.end["lowest_radius"] > 0.0:
        speeds, radii = np.append(speeds, found.end["lowest_speed"]), np.append(radii, found.end["lowest_radius"])
    if not time or not radii.size:
        return []
    fast, long = float(np.max(speeds / radii)) * time, zone / float(np.min(radii))
    if not (fast > _FASTEST or long > _LONGEST):
        return []
    text = (
        f"the work of adhesion of a steady crack is beyond its range: v time/a = {fast:.2g} (at most {_FASTEST}: the solid "
        f"around is relaxed), zone/a = {long:.2g} (at most {_LONGEST}: the cohesive zone is short). Pull-off may be more than "
        "2 % off"
    )
    return [Caution(text, AdhesionRateWarning)]


def _start(start: Any) -> list[float]:
    """The library's record of where a history begins."""
    row = dict.fromkeys(STATE, 0.0)
    if isinstance(start, Mapping):
        row.update({key: number(key, value) for key, value in start.items() if key in row})
    elif start == "rest":
        row["radius"] = -1.0
    elif start != "apart":
        raise InvalidArgumentError(f'start = {start!r} is not allowed: it must be "apart", "rest" or the `end` of a history')
    return list(row.values())


def _largest(contact: Any, control: int, highest: float) -> float:
    """A contact radius that equilibrium does not exceed: the force of a spring is none or pushes where it is pressed in."""
    free = contact._solve("force", _layout.FORCE, 0.0)
    if control == CONTROLS["force"]:
        return max(float(contact._solve("force", _layout.FORCE, max(highest, 0.0)).radius), float(free.radius))
    return float(contact._solve("depth", _layout.DEPTH, max(highest, float(free.depth))).radius)
