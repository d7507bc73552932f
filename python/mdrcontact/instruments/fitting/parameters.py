# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of indenter, medium and instrument by name, in the order in which the library takes them, and back to objects."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import _layout
from ... import medium as media
from ... import profile as profiles
from ..._boundary import Handle, call, native, number, record
from ..._choices import nearest
from ..._units import COMPLIANCE, FORCE, LENGTH, MODULUS, RATIO, WORK_OF_ADHESION
from ..._value import Value
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...material import RIGID, Elastic
from ...medium.viscoelastic import is_viscoelastic
from ...poroelastic import is_poroelastic


@dataclass(frozen=True)
class Free(Value):
    """Free parameter of a fit.

    Parameters
    ----------
    start : float, optional
        Starting value; None is the value in the indenter, medium or instrument [unit of the parameter].
    lower : float, optional
        Lower bound [unit of the parameter].
    upper : float, optional
        Upper bound [unit of the parameter].
    prior : tuple of float, optional
        (value, standard deviation > 0), which enters the fit as an additional measurement [unit of the parameter].

    Raises
    ------
    InvalidArgumentError
        The standard deviation of the prior is not greater than 0.
    ArgumentTypeError
        The prior is not a pair.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth, force, sd=1e-6)
    >>> free = {"E": None, "indenter.radius": mdr.instruments.Free(prior=(10e-6, 0.5e-6))}
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), silica, free)
    >>> print(f"{result.standard_errors['E'] / 1e9:.2f}")
    1.80
    """

    start: float | None = None
    lower: float = field(default=-math.inf, kw_only=True)
    upper: float = field(default=math.inf, kw_only=True)
    prior: tuple[float, float] | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        given = {"lower": self.lower, "upper": self.upper} | ({} if self.start is None else {"start": self.start})
        self._set(**{name: number(name, value) for name, value in given.items()})
        if self.prior is None:
            return
        try:
            mean, sd = self.prior
        except (TypeError, ValueError) as problem:
            raise ArgumentTypeError(f"prior = {self.prior!r}: it must be (value, standard deviation)") from problem
        prior = number("prior value", mean), number("prior standard deviation", sd)
        if not (math.isfinite(prior[0]) and 0.0 < prior[1] < math.inf):
            raise InvalidArgumentError(f"prior = {prior!r}: its standard deviation must be greater than 0")
        self._set(prior=prior)


@dataclass(frozen=True)
class JointPrior(Value):
    """Joint prior of several parameters, as of the coefficients of a calibrated tip.

    Parameters
    ----------
    names : sequence of str
        Names of n parameters, which become free.
    values : sequence of float
        Values, n [units of the parameters].
    covariance : array_like
        Covariance, (n, n), symmetric and positive definite [products of the units].

    Raises
    ------
    InvalidArgumentError
        The shapes do not match, a number is not finite, or the covariance is not positive definite.

    Examples
    --------
    >>> prior = mdr.instruments.JointPrior(["indenter.C0", "indenter.C1"], [24.5, 1e-6], [[0.04, 0.0], [0.0, 1e-14]])
    >>> print(prior.weights()[0, 0] != 0.0, len(prior.names))
    True 2
    """

    names: tuple[str, ...]
    values: tuple[float, ...]
    covariance: tuple[tuple[float, ...], ...]

    def __post_init__(self) -> None:
        names = tuple(self.names)
        values, covariance = np.asarray(self.values, dtype=float), np.asarray(self.covariance, dtype=float)
        if values.shape != (len(names),) or covariance.shape != 2 * (len(names),):
            raise InvalidArgumentError(
                f"values and covariance have the shapes {values.shape} and {covariance.shape}: for {len(names)} names they must be "
                f"({len(names)},) and ({len(names)}, {len(names)})"
            )
        if not (np.isfinite(values).all() and np.isfinite(covariance).all()):
            raise InvalidArgumentError("values and covariance: they must be finite")
        self._set(names=names, values=tuple(values.tolist()), covariance=tuple(map(tuple, covariance.tolist())))
        self.weights()

    def weights(self) -> NDArray[np.float64]:
        """Return W, with W^T W the inverse of the covariance.

        Returns
        -------
        ndarray
            (n, n); W (p - values) has independent entries of variance 1.
        """
        covariance = np.array(self.covariance)
        scale = np.sqrt(np.maximum(np.diag(covariance), 0.0))
        if not (scale > 0.0).all():
            raise InvalidArgumentError("covariance: its diagonal must be greater than 0")
        variances, axes = np.linalg.eigh(covariance / np.outer(scale, scale))
        if variances[0] < -1e-8 or not np.allclose(covariance, covariance.T, rtol=1e-6):
            raise InvalidArgumentError("covariance: it must be symmetric and positive definite")
        # rounding of a covariance that was written to a file must not fix a direction
        return np.asarray((axes / np.sqrt(np.maximum(variances, 1e-12))).T / scale)


@dataclass(frozen=True, kw_only=True)
class Instrument(Value):
    """Properties of an instrument that connect contact and data.

    A fit rejects parameters that its data do not depend on.

    Parameters
    ----------
    work_of_adhesion : float, optional
        gamma >= 0 [modulus length]; for `ForceDepth`.
    depth_offset : float, optional
        Reading of the depth at initial contact [length]; for data with depths.
    force_offset : float, optional
        Reading of the force without contact [modulus length^2]; for data with depths.
    frame_compliance : float, optional
        Compliance of frame and holder that the instrument has not removed [1/(modulus length)]; for `ForceDepth` and stiffnesses.
    indenter : Elastic, optional
        Material of the indenter; None is a rigid one. The contact is that of `Pair(medium, indenter)`. If the indenter is layered,
        give a `Pair` as the medium; its parameters are then "upper.coating.E" and so on.
    contact_depth_factor : float, optional
        epsilon of the contact depth h_c = h - epsilon P/S on a half-space [1]; for `StiffnessDepth`. 0.75 is that of a paraboloid,
        as which a yielded indent unloads; 0.727 of a cone, 1 of a punch, 0 or less for pile-up. On other bodies the surface sinks
        in as under the same indenter.
    stiffness_factor : float, optional
        beta of S = 2 beta a E_r [1]; for stiffnesses.
    contact_depth_scale : float, optional
        Factor of h_c [1]; for `StiffnessDepth`. 1.2 with `contact_depth_factor` = 1 is Loubet's contact depth, equal on all bodies.
    area_factor : float, optional
        True over assumed projected area of contact [1], whose prior represents the uncertainty of the tip; for stiffnesses and
        moduli.
    cohesive_stress : float, optional
        sigma_0 >= 0 [modulus]; the surfaces attract each other up to a gap of work_of_adhesion/cohesive_stress. 0 is the JKR limit.
        Fit it, with `work_of_adhesion`, if data show the range: slow separation, or a jump from afar.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.
    ArgumentTypeError
        `indenter` is not an `Elastic`.

    References
    ----------
    oliver-1992
    oliver-2004

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth + 2e-9, force, sd=1e-6)
    >>> tool = mdr.instruments.Instrument(depth_offset=0.0)
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), silica, ["E", "depth_offset"], instrument=tool)
    >>> print(f"{result.estimates['depth_offset'] * 1e9:.2f}")
    2.00
    """

    work_of_adhesion: float = field(default=0.0, metadata={"dimension": WORK_OF_ADHESION})
    depth_offset: float = field(default=0.0, metadata={"dimension": LENGTH})
    force_offset: float = field(default=0.0, metadata={"dimension": FORCE})
    frame_compliance: float = field(default=0.0, metadata={"dimension": COMPLIANCE})
    indenter: Elastic | None = None
    contact_depth_factor: float = field(default=0.75, metadata={"dimension": RATIO})
    stiffness_factor: float = field(default=1.0, metadata={"dimension": RATIO})
    contact_depth_scale: float = field(default=1.0, metadata={"dimension": RATIO})
    area_factor: float = field(default=1.0, metadata={"dimension": RATIO})
    cohesive_stress: float = field(default=0.0, metadata={"dimension": MODULUS})

    def __post_init__(self) -> None:
        if self.indenter is not None and not isinstance(self.indenter, Elastic):
            raise ArgumentTypeError(f"indenter = {self.indenter!r}: it must be an Elastic(E, nu) or None")
        self._set(**{name: number(name, value) for name, value in self._given().items() if name != "indenter"})


class Pattern(NamedTuple):
    """Pattern of the trial objects of a fit, and all parameters in the order of the library."""

    indenter: Any
    medium: Any
    instrument: Instrument
    names: list[str]
    """empty for numbers that stay as they are"""
    values: list[float]

    def at(self, values: Iterable[float]) -> tuple[Any, Any, Instrument]:
        """Indenter, medium and instrument with these numbers."""
        entries = zip(self.names, map(float, values), self.values, strict=True)
        changed: dict[str, Any] = {name: value for name, value, before in entries if name and value != before}
        tip = {name.removeprefix(_TIP): changed.pop(name) for name in self.names if name in changed and name.startswith(_TIP)}
        tool = {name: changed.pop(name) for name in self.names[-_layout.FIT_INSTRUMENT_COUNT :] if name in changed}
        if _MODULUS in tool:
            tool["indenter"] = Elastic(tool.pop(_MODULUS), 0.0)
        indenter, medium = self.indenter.with_parameters(tip), self.medium.with_parameters(changed)
        instrument = self.instrument.replace(**tool)
        if "indenter" in tool and has_homogeneous_indenter(medium):
            medium = medium.replace(upper=instrument.indenter)
        return indenter, medium, instrument


_TIP, _UPPER, _MODULUS = "indenter.", "upper.", "indenter_modulus"


def pattern_of(indenter: Any, medium: Any, instrument: Instrument) -> Pattern:
    """The parameters of these objects; tables, functions, sums and pyramids have none."""
    if not isinstance(indenter, profiles.Profile):
        raise ArgumentTypeError(f"indenter = {indenter!r}: it must be an indenter profile")
    if not isinstance(medium, media.Medium):
        raise ArgumentTypeError(f"medium = {medium!r}: it must be a medium")
    if not isinstance(instrument, Instrument):
        raise ArgumentTypeError(f"instrument = {instrument!r}: it must be an Instrument(...)")
    if is_poroelastic(medium):
        raise InvalidArgumentError("a poroelastic gel is fitted by fit_gel(data, indenter, medium, free, drainage=...)")
    listed = _listed(record(_layout.fit_problem, **handles_of(indenter, medium)))
    lower, upper = _bodies(medium)
    last = len(listed) - _layout.FIT_INSTRUMENT_COUNT
    tip = sum(name.startswith(_TIP) for name, _ in listed)
    above = sum(name.startswith(_UPPER) for name, _ in listed[tip:last])
    found = [
        *_numbers(indenter, listed[:tip], _TIP),
        *_numbers(lower, listed[tip : last - above]),
        *(_numbers(upper, listed[last - above : last], _UPPER) if above else []),
        *_of_instrument(with_indenter(instrument, medium), listed[last:]),
    ]
    names, values = [name for name, _ in found], [value for _, value in found]
    return Pattern(indenter, medium, with_indenter(instrument, medium), names, values)


def handles_of(indenter: Any, medium: Any) -> dict[str, Handle | None]:
    """The handles of a `mdr_fit_problem`."""
    lower, upper = _bodies(medium)
    return {"profile": indenter._handle, "medium": lower._handle, "counterbody": upper and upper._handle}


def _bodies(medium: Any) -> tuple[Any, Any]:
    """The body that is pressed, and the upper one unless it is rigid or the number indenter_modulus."""
    if not isinstance(medium, media.Pair) or RIGID in (medium.lower, medium.upper):
        return medium, None
    return medium.lower, None if has_homogeneous_indenter(medium) else medium.upper


def _listed(problem: NDArray[Any], room: int = 100) -> list[tuple[str, float]]:
    """Names and values of the parameters as the library has them."""
    found = np.zeros(room, _layout.fit_parameter)
    count = call(native.fit_parameters, problem, room, found)
    if count > room:
        return _listed(problem, count)
    return [(str(entry["name"], "ascii"), float(entry["value"])) for entry in found[:count]]


def _numbers(part: Any, listed: Sequence[tuple[str, float]], prefix: str = "") -> list[tuple[str, float]]:
    """Name and value of each number of an object; an empty name for numbers that cannot vary."""
    known = part.parameters()
    names = _of_relaxing(known) if is_viscoelastic(part) else [_in_python(part, name.removeprefix(prefix)) for name, _ in listed]
    # an interface that slides has no stiffness
    free = {name for name in names if known.get(name) or (name in known and ".interface." not in name)}
    entries = zip(names, listed, strict=True)
    return [(prefix + name, known[name]) if name in free else ("", value) for name, (_, value) in entries]


def _in_python(part: Any, name: str) -> str:
    """Name of a number of an elastic object in the package: the one layer of a coated body is its coating."""
    if isinstance(part, media.Coated):
        return name.replace("layers[0].thickness", "thickness").replace("layers[0]", "coating")
    return name


def _of_relaxing(known: Mapping[str, float]) -> list[str]:
    """The numbers of each material from top to bottom, behind those of a layer its thickness and interface; terms in
    any order."""
    times = [(name.split("terms[")[0], value) for name, value in known.items() if name.endswith("].time")]
    if len(set(times)) < len(times):
        words = "two terms of equal time are one, which has no two moduli to be fitted"
        raise InvalidArgumentError(f"terms: {words}")
    names: list[str] = []
    for name in known:
        if not any(part in name for part in ("conductor.", "prestress", "interface.")):
            names.append(name)
        if name.endswith("thickness"):
            names += [name.removesuffix("thickness") + spring for spring in ("interface.normal", "interface.tangential")]
    return names


def _of_instrument(instrument: Instrument, listed: Sequence[tuple[str, float]]) -> list[tuple[str, float]]:
    return [(name, _modulus(instrument) if name == _MODULUS else getattr(instrument, name)) for name, _ in listed]


def _modulus(instrument: Instrument) -> float:
    return math.inf if instrument.indenter is None else instrument.indenter.contact_modulus


def has_homogeneous_indenter(medium: Any) -> bool:
    """Whether a medium is a pair whose upper body is the number indenter_modulus to a fit."""
    pair = isinstance(medium, media.Pair)
    upper = getattr(medium, "upper", None)
    return pair and isinstance(getattr(upper, "material", None), Elastic) and isinstance(medium.lower, media.Medium)


def with_indenter(instrument: Instrument, medium: Any) -> Instrument:
    """The instrument with the upper body of a pair as its indenter."""
    if not has_homogeneous_indenter(medium):
        return instrument
    if instrument.indenter is not None:
        raise InvalidArgumentError("Instrument(indenter=...): the upper body of a Pair is the indenter. Omit it")
    return instrument.replace(indenter=medium.upper.material)


def read_free(free: Any, names: Sequence[str]) -> dict[str, Free]:
    """The free parameters by name; the error for a wrong name suggests the nearest right one."""
    if isinstance(free, str):
        free = [free]
    chosen = dict(free) if isinstance(free, Mapping) else {name: Free() for name in free}
    known = [name for name in names if name]
    for name, entry in chosen.items():
        if name not in known:
            raise InvalidArgumentError(f"free parameter {name!r}: {nearest(str(name), known)}")
        if isinstance(entry, Free):
            continue
        if entry is not None and not isinstance(entry, (int, float)):
            raise ArgumentTypeError(f"free[{name!r}] = {entry!r}: it must be Free(...), a starting value or None")
        chosen[name] = Free(entry)
    return chosen


def read_known(known: Iterable[JointPrior], names: Sequence[str], free: dict[str, Free]) -> NDArray[np.float64]:
    """The weights of joint priors, (priors, parameters); makes their parameters free."""
    rows = [np.zeros((0, len(names)))]
    taken: set[str] = set()
    for prior in known:
        if not isinstance(prior, JointPrior):
            raise ArgumentTypeError(f"known = {prior!r}: it must hold JointPrior(...)")
        for name in prior.names:
            if not name or name not in names:
                raise InvalidArgumentError(f"joint prior of {name!r}: {nearest(str(name), [n for n in names if n])}")
            if name in taken or (name in free and free[name].prior is not None):
                raise InvalidArgumentError(f"{name} has two priors: keep one")
            taken.add(name)
        weights = np.zeros((len(prior.names), len(names)))
        weights[:, [names.index(name) for name in prior.names]] = prior.weights()
        rows.append(weights)
        for name in prior.names:
            free.setdefault(name, Free())
    return np.concatenate(rows)
