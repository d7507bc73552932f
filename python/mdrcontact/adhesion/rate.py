# SPDX-License-Identifier: GPL-3.0-or-later
"""Rate-dependent work of adhesion, and histories of contacts with it."""

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
    """the times of the path [time]"""
    depth: NDArray[np.float64]
    """d, also that of separated bodies [length]"""
    radius: NDArray[np.float64]
    """a, 0 if the bodies are separated [length]"""
    force: NDArray[np.float64]
    """F [modulus length^2]"""
    speed: NDArray[np.float64]
    """v = -da/dt of the contact edge, > 0 if it opens [length/time]"""
    dissipated: NDArray[np.float64]
    """energy lost at the edge so far, in addition to the work of adhesion at rest [modulus length^3]"""
    work: NDArray[np.float64]
    """int F dd so far [modulus length^3]"""
    end: dict[str, float]
    """state at the last time, from which a history continues (`start=`): "radius", "depth", "force", "dissipated", "work";
    pull-off: "lowest_force", "lowest_time", "lowest_depth", "lowest_radius", "lowest_speed"; the last rupture: "rupture_time",
    "rupture_depth"; their number "ruptures"; the checksum "mark" of all these numbers and of the law
    """


class RateHistory(_RateHistoryNumbers, Warned):
    """Path of a contact whose edge moves at a finite speed, from `rate_history`.

    The first seven entries are arrays of one length.

    Examples
    --------
    >>> law = mdr.adhesion.RateAdhesion(work=0.05, speed=1e-6, exponent=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(1e6, 0.5)), adhesion=law)
    >>> path = mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[0.5e-6, -5e-6], start="rest")
    >>> print(f"{path.end['lowest_force']:.4e} {contact.pull_off('depth').force:.4e}")
    -8.8068e-06 -1.3090e-06
    """


class _Rate(Value):
    """Base of rate-dependent works of adhesion."""

    work: float

    def at_speed(self, v: ArrayLike) -> FloatOrArray:
        """Return the work of adhesion G(v) of a moving edge.

        Parameters
        ----------
        v : array_like
            Speeds, > 0 if the edge opens, any shape [length/time].

        Returns
        -------
        float or ndarray
            G, in the shape of `v` [modulus length]; `work` at v = 0.

        Raises
        ------
        InvalidArgumentError
            A speed is not finite.
        """
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
    """Work of adhesion that depends on the speed v of the contact edge.

    An opening edge costs `G = work (1 + (v/speed)^exponent)`. A closing edge yields `closing_work/(1 +
    (|v|/closing_speed)^closing_exponent)`.

    Parameters
    ----------
    work : float
        gamma_0 > 0, work of an edge that just opens [modulus length]. States of the contact are in equilibrium with it.
    speed : float
        v_0 > 0, speed at which the work is doubled [length/time].
    exponent : float
        n, 0 < n <= 2 [1].
    closing_work : float, optional
        Work of an edge that closes, > 0 and at most `work` [modulus length]. Between both the edge is at rest. None is `work`.
    closing_speed : float, optional
        Speed > 0 of the closing edge [length/time]. None is `speed`.
    closing_exponent : float, optional
        Exponent of the closing edge, 0 < n <= 2 [1]. None is `exponent`.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    gent-1972
    maugis-1978

    Examples
    --------
    >>> law = mdr.adhesion.RateAdhesion(work=0.05, speed=1e-6, exponent=0.5)
    >>> print(np.round(law.at_speed([0.0, 1e-6, 1e-4]), 3))
    [0.05 0.1  0.55]
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
                raise InvalidArgumentError(f"{name} = 0: it must be greater than 0; None is that of the opening edge")
        self.at_speed(0.0)

    @classmethod
    def from_rheology(cls, material: Viscoelastic, work: float, cohesive_stress: float) -> RheologicalAdhesion:
        """Return the law of a viscoelastic surface.

        Parameters
        ----------
        material : Viscoelastic
            As in `RheologicalAdhesion`.
        work : float
            As in `RheologicalAdhesion` [modulus length].
        cohesive_stress : float
            As in `RheologicalAdhesion` [modulus].

        Returns
        -------
        RheologicalAdhesion
            The law.

        Raises
        ------
        ArgumentTypeError
            `material` is not a `Viscoelastic`.
        """
        return RheologicalAdhesion(material, work, cohesive_stress)


@dataclass(frozen=True)
class RheologicalAdhesion(_Rate):
    """Work of adhesion of a viscoelastic surface with a constant cohesive stress.

    It is that of a steady crack: it increases from `work` to E_glassy/E_relaxed times `work` as the edge opens faster, and
    decreases to the inverse as it closes faster.

    Parameters
    ----------
    material : Viscoelastic
        Material of the surface layer, with a glassy and a relaxed modulus. The medium of the contact has the relaxed moduli.
    work : float
        gamma_0 > 0 [modulus length].
    cohesive_stress : float
        sigma_0 > 0 [modulus]. It sets the scale of the speed, E* work/(sigma_0^2 time).

    Raises
    ------
    ArgumentTypeError
        `material` is not a `Viscoelastic`.
    InvalidArgumentError
        A number is outside its range, or the material has no glassy or relaxed modulus.

    Notes
    -----
    The law holds if the edge is slow for the material, v time/a <= 0.02, and its cohesive zone is short, zone/a <= 0.03. The error
    of pull-off is then at most 2 %. Histories outside this range issue an `AdhesionRateWarning`.

    References
    ----------
    greenwood-1981
    schapery-1975

    Examples
    --------
    >>> rubber = mdr.Viscoelastic(1e6, [(9e6, 1e-3)], nu=0.5)
    >>> law = mdr.adhesion.RheologicalAdhesion(rubber, work=0.05, cohesive_stress=1e6)
    >>> print(f"{law.at_speed(0.0):.3f} {law.at_speed(1e3):.3f}")
    0.050 0.500
    """

    material: Viscoelastic
    work: float
    cohesive_stress: float

    def __post_init__(self) -> None:
        if not isinstance(self.material, Viscoelastic):
            raise ArgumentTypeError(f"material = {self.material!r}: it must be a Viscoelastic")
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
        raise ArgumentTypeError(f"adhesion = {adhesion!r}: it must be a RateAdhesion")
    if number(name, value) not in (0.0, adhesion.work):
        raise InvalidArgumentError(f"{name} = {value!r}: adhesion= has work = {adhesion.work!r}. Omit {name}")
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

    Give one of `depth`, `force` and `position`.

    Parameters
    ----------
    contact : Contact
        Contact with `adhesion`, on an elastic body (the relaxed moduli of a viscoelastic one).
    time : array_like
        Strictly ascending times, one dimension [time]. Before the first time the bodies are separated and at rest.
    depth : array_like, optional
        Depths at these times, linear in between [length]. The first value is reached in a jump.
    force : array_like, optional
        Forces at these times, as `depth` [modulus length^2].
    position : array_like, optional
        Positions d + F/spring_stiffness of the far end of a spring that presses the indenter, as `depth` [length].
    spring_stiffness : float, optional
        Stiffness of that spring, > 0 [modulus length].
    start : {"apart", "rest"} or mapping, optional
        "apart": separated bodies. "rest": the largest stable contact in equilibrium with the first value. A mapping is the `end` of
        a history that this one continues, whose last time and value are the first of this one; with "radius" alone the history
        begins at that radius.
    tolerance : float, optional
        Tolerance of ln(radius) in each step, 1e-12 to 1e-3; default 1e-9 [1].
    progress : bool or Progress, optional
        True shows a progress bar on a terminal if the work takes more than two seconds. A `Progress` follows each round.

    Returns
    -------
    RateHistory
        The path, and pull-off.

    Raises
    ------
    InvalidArgumentError
        The contact has no `adhesion`, or `start` is the changed end of a history, or that of another contact.
    UnreachableError
        There is no stable contact from which to start.

    Examples
    --------
    >>> law = mdr.adhesion.RateAdhesion(work=0.05, speed=1e-6, exponent=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(1e6, 0.5)), adhesion=law)
    >>> slow, fast = (
    ...     mdr.adhesion.rate_history(contact, [0.0, duration], depth=[0.5e-6, -5e-6], start="rest").end["lowest_force"]
    ...     for duration in (100.0, 1.0)
    ... )
    >>> print(f"{slow:.3e} {fast:.3e}")
    -3.259e-06 -8.807e-06
    """
    control, stiffness, accuracy, t, s = controlled_path(
        time, {"position": position, "depth": depth, "force": force}, spring_stiffness, tolerance
    )
    if contact.adhesion is None:
        raise InvalidArgumentError("contact: it must have an adhesion, as RateAdhesion(...)")
    row = _start(start)
    handle = contact._rate_handle(contact.adhesion, max(row[0], _largest(contact, control, float(np.max(s)))) * _ROOM)
    with marching(t.size, progress):
        d, a, F, v, lost, done, end = call(native.rate_history, handle, control, stiffness, accuracy, row, t, s)
    found = RateHistory(t, d, a, F, v, lost, done, dict(zip(STATE, end.tolist(), strict=True)))
    doubts = _doubts_of(contact.adhesion, found)
    warn_all(doubts)
    return found._carrying(doubts)


def _doubts_of(adhesion: _Rate, found: RateHistory) -> list[Caution]:
    """Return a warning if a law from rheology is outside its range: at the lowest force, and while the contact is larger than
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
        unknown = next((key for key in start if key not in row), None)
        if unknown is not None:
            raise InvalidArgumentError(f"start = {{{unknown!r}: ...}}: a state has the members {', '.join(row)}. Remove this one")
        row.update({key: number(key, value) for key, value in start.items()})
    elif start == "rest":
        row["radius"] = -1.0
    elif start != "apart":
        raise InvalidArgumentError(f'start = {start!r}: it must be "apart", "rest" or the `end` of a history')
    return list(row.values())


def _largest(contact: Any, control: int, highest: float) -> float:
    """A contact radius that equilibrium does not exceed: the force of a spring is 0 or compressive if it is pressed in."""
    free = contact._solve("force", _layout.FORCE, 0.0)
    if control == CONTROLS["force"]:
        return max(float(contact._solve("force", _layout.FORCE, max(highest, 0.0)).radius), float(free.radius))
    return float(contact._solve("depth", _layout.DEPTH, max(highest, float(free.depth))).radius)
