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
    """A parameter that the fit is to find.

    start : where the search begins; default: the value in the indenter, medium or instrument
    lower, upper : bounds, in the unit of the parameter
    prior : (value, standard deviation) known beforehand; enters the fit as one more measurement
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
    """What is known beforehand of several parameters together, such as the coefficients of a calibrated tip.

    names : of the parameters, which become free
    values, covariance : (n,) and (n, n), symmetric and positive definite, in the units of the parameters
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
        """W with W^T W the inverse of the covariance: W (p - values) has independent entries of variance 1."""
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
    """What stands between the contact and the data. A fit refuses what its data do not depend on.

    work_of_adhesion : gamma >= 0 [modulus length]; for ForceDepth
    cohesive_stress : sigma >= 0 [modulus], under which the surfaces pull on each other up to a gap of work_of_adhesion/sigma; 0: a
        range of nothing. Free, with work_of_adhesion, where data show the range: bodies that part slowly, or jump in from afar
    depth_offset, force_offset : what the instrument reads at first contact [length], [modulus length^2]; for data with depths
    frame_compliance : of frame and holder, beyond what the instrument has already taken off [1/(modulus length)]; for ForceDepth
        and stiffnesses
    indenter : material of the indenter, an Elastic, or None for a rigid one: the contact is that of `Pair(medium, indenter)`. An
        indenter that is layered itself stands in the medium, a Pair; its parameters are then called "upper.coating.E" and the like
    contact_depth_factor : epsilon of the contact depth h_c = h - epsilon P/S on a half-space: 0.75, that of a paraboloid, as which
        an indent that has yielded unloads; 0.727 of a cone, 1 of a punch; 0 or less where the surface piles up. On any other body
        the surface sinks in as under the same indenter
        (for StiffnessDepth)
    stiffness_factor : beta of S = 2 beta a E_r; for stiffnesses
    contact_depth_scale : factor of h_c; 1.2 with contact_depth_factor = 1: Loubet's contact depth, the same on all bodies
        (for StiffnessDepth)
    area_factor : true over assumed projected area of contact, as a prior on which the uncertainty of the tip enters; for
        stiffnesses and moduli
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
    """What trials of a fit are like, and all parameters in the order in which the library takes them."""

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
    """Name and value of each number of an object; no name where it stays as it is."""
    known = part.parameters()
    names = _of_relaxing(known) if is_viscoelastic(part) else [_in_python(part, name.removeprefix(prefix)) for name, _ in listed]
    # an interface that slides has no stiffness
    free = {name for name in names if known.get(name) or (name in known and ".interface." not in name)}
    entries = zip(names, listed, strict=True)
    return [(prefix + name, known[name]) if name in free else ("", value) for name, (_, value) in entries]


def _in_python(part: Any, name: str) -> str:
    """What the package calls a number of an elastic object: the one layer of a coated body is its coating."""
    if isinstance(part, media.Coated):
        return name.replace("layers[0].thickness", "thickness").replace("layers[0]", "coating")
    return name


def _of_relaxing(known: Mapping[str, float]) -> list[str]:
    """The numbers of each material from the surface down, behind those of a layer its thickness and interface; terms in
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
    """The free parameters by name; a wrong name is answered with the nearest right one."""
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
