# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of indenter, medium and instrument by name, in the order in which the library takes them, and back to objects."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import _layout
from .. import medium as media
from .. import profile as profiles
from .._boundary import number
from .._choices import nearest
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import RIGID, SMOOTH, Elastic, TransverselyIsotropic
from ..medium.models import MODELS, settings
from ..medium.viscoelastic import is_viscoelastic
from ..poroelastic import is_poroelastic


@dataclass(frozen=True)
class Free:
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
        given = {"lower": number("lower", self.lower), "upper": number("upper", self.upper), "start": self.start}
        if self.start is not None:
            given["start"] = number("start", self.start)
        for name, value in given.items():
            object.__setattr__(self, name, value)
        if self.prior is None:
            return
        try:
            mean, sd = self.prior
        except (TypeError, ValueError) as problem:
            raise ArgumentTypeError(f"prior = {self.prior!r} is not allowed: it must be (value, standard deviation)") from problem
        prior = number("prior value", mean), number("prior standard deviation", sd)
        if not (math.isfinite(prior[0]) and 0.0 < prior[1] < math.inf):
            raise InvalidArgumentError(f"prior = {prior!r} is not allowed: its standard deviation must be greater than 0")
        object.__setattr__(self, "prior", prior)


@dataclass(frozen=True)
class JointPrior:
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
            raise InvalidArgumentError("values and covariance are not allowed: they must be finite")
        object.__setattr__(self, "names", names)
        object.__setattr__(self, "values", tuple(values.tolist()))
        object.__setattr__(self, "covariance", tuple(map(tuple, covariance.tolist())))
        self.weights()

    def weights(self) -> NDArray[np.float64]:
        """W with W^T W the inverse of the covariance: W (p - values) has independent entries of variance 1."""
        covariance = np.array(self.covariance)
        scale = np.sqrt(np.maximum(np.diag(covariance), 0.0))
        if not (scale > 0.0).all():
            raise InvalidArgumentError("covariance is not allowed: its diagonal must be greater than 0")
        variances, axes = np.linalg.eigh(covariance / np.outer(scale, scale))
        if variances[0] < -1e-8 or not np.allclose(covariance, covariance.T, rtol=1e-6):
            raise InvalidArgumentError("covariance is not allowed: it must be symmetric and positive definite")
        # rounding of a covariance that was written to a file must not fix a direction
        return np.asarray((axes / np.sqrt(np.maximum(variances, 1e-12))).T / scale)


@dataclass(frozen=True, kw_only=True)
class Instrument:
    """What stands between the contact and the data.

    work_of_adhesion : gamma >= 0 [modulus length]; for ForceDepth
    cohesive_stress : sigma >= 0 [modulus], under which the surfaces pull on each other up to a gap of work_of_adhesion/sigma; 0: a
        range of nothing. Free, with work_of_adhesion, where data show the range: bodies that part slowly, or jump in from afar
    depth_offset, force_offset : what the instrument reads at first contact [length], [modulus length^2]
    frame_compliance : of frame and holder, beyond what the instrument has already taken off [1/(modulus length)]
    indenter : material of the indenter, an Elastic, or None for a rigid one: the contact is that of `Pair(medium, indenter)`. An
        indenter that is layered itself stands in the medium, a Pair; its parameters are then called "upper.coating.E" and the like
    contact_depth_factor : epsilon of the contact depth h_c = h - epsilon P/S on a half-space: 0.75, that of a paraboloid, as which
        an indent that has yielded unloads; 0.727 of a cone, 1 of a punch; 0 or less where the surface piles up. On any other body
        the surface sinks in as under the same indenter
    stiffness_factor : beta of S = 2 beta a E_r
    contact_depth_scale : factor of h_c; 1.2 with contact_depth_factor = 1: Loubet's contact depth, the same on all bodies
    area_factor : true over assumed projected area of contact, as a prior on which the uncertainty of the tip enters; for all data
        but ForceDepth
    """

    work_of_adhesion: float = 0.0
    depth_offset: float = 0.0
    force_offset: float = 0.0
    frame_compliance: float = 0.0
    indenter: Elastic | None = None
    contact_depth_factor: float = 0.75
    stiffness_factor: float = 1.0
    contact_depth_scale: float = 1.0
    area_factor: float = 1.0
    cohesive_stress: float = 0.0

    def __post_init__(self) -> None:
        if self.indenter is not None and not isinstance(self.indenter, Elastic):
            raise ArgumentTypeError(f"indenter = {self.indenter!r} is not allowed: it must be an Elastic(E, nu) or None")
        for name, value in vars(self).copy().items():
            if name != "indenter":
                object.__setattr__(self, name, number(name, value))


class Numbers(NamedTuple):
    """A part of the problem as the library takes it: its kind, the names and values of its parameters, and the way back."""

    code: int
    names: list[str]
    values: list[float]
    build: Callable[[Sequence[float]], Any]


def _numbers(code: int, part: Any, entries: Sequence[str | float] = (), prefix: str = "") -> Numbers:
    """Those of an object in the order in which the library takes them: by the object's own names, or numbers that stay."""
    known = part.parameters()
    named = [i for i, entry in enumerate(entries) if isinstance(entry, str)]

    def build(v: Sequence[float]) -> Any:
        return part.with_parameters({entries[i]: v[i] for i in named})

    names = [prefix + entry if isinstance(entry, str) else "" for entry in entries]
    return Numbers(code, names, [known[entry] if isinstance(entry, str) else entry for entry in entries], build)


_SHAPES: Mapping[type, int] = {
    profiles.Paraboloid: 1,
    profiles.Sphere: 2,
    profiles.Cone: 3,
    profiles.PowerLaw: 4,
    profiles.FlatPunch: 5,
    profiles.FlatEndedCone: 6,
    profiles.FlatEndedParaboloid: 7,
    profiles.RoundedCone: 8,
}

INSTRUMENT = (
    "work_of_adhesion",
    "depth_offset",
    "force_offset",
    "frame_compliance",
    "indenter_modulus",
    "contact_depth_factor",
    "stiffness_factor",
    "contact_depth_scale",
    "area_factor",
    "cohesive_stress",
)

AREA_TERMS = 8
"""Coefficients C0, C1, ... that an area function may have in a fit."""


def of_indenter(indenter: Any) -> Numbers:
    """An indenter's parameters; tables, sums and pyramids are fixed as they are."""
    if not isinstance(indenter, profiles.Profile):
        raise ArgumentTypeError(f"indenter = {indenter!r} is not allowed: it must be an indenter profile")
    if isinstance(indenter, profiles.AreaFunction) and len(indenter.coefficients) <= AREA_TERMS:
        return _area_function(indenter)
    if type(indenter) not in _SHAPES:
        return _numbers(0, indenter)
    return _numbers(_SHAPES[type(indenter)], indenter, list(indenter.parameters()), "indenter.")


def _area_function(tip: profiles.AreaFunction) -> Numbers:
    names = list(tip.parameters())
    return _numbers(9, tip, [tip.min_height, tip.max_height, *names, *(AREA_TERMS - len(names)) * [0.0]], "indenter.")


class MediumNumbers(NamedTuple):
    """A medium's parameters and choices."""

    numbers: Numbers
    body: Any
    """the medium itself; of a pair the lower body"""
    model: int = MODELS["exact"].code
    options: NDArray[Any] | None = None
    """those of the model, as the library takes them; None: the defaults"""
    counterbody: MediumNumbers | None = None
    """the upper body of a pair, unless the instrument has it as its indenter"""


def of_medium(medium: Any) -> MediumNumbers:
    """A medium's parameters; tables and functions are fixed as they are."""
    if not isinstance(medium, media.Medium):
        raise ArgumentTypeError(f"medium = {medium!r} is not allowed: it must be a medium")
    if is_poroelastic(medium):
        raise InvalidArgumentError("a poroelastic gel is fitted by fit_gel(data, indenter, medium, free, drainage=...)")
    if is_viscoelastic(medium):
        return _viscoelastic(medium)
    if isinstance(medium, media.Pair) and has_homogeneous_indenter(medium):
        return of_medium(medium.lower)
    if isinstance(medium, media.Pair) and RIGID not in (medium.lower, medium.upper):
        return _two_bodies(of_medium(medium.lower), of_medium(medium.upper))
    if isinstance(medium, media.PowerLawGraded):
        return MediumNumbers(_numbers(_layout.FIT_MEDIUM_POWER_GRADED, medium, ["E0", "z0", "exponent", "nu"]), medium)
    if not medium.parameters():
        return MediumNumbers(_numbers(0, medium), medium)
    return _pattern(medium)


def _two_bodies(lower: MediumNumbers, upper: MediumNumbers) -> MediumNumbers:
    names = [*lower.numbers.names, *(name and f"upper.{name}" for name in upper.numbers.names)]
    n = len(lower.numbers.values)
    numbers = Numbers(
        lower.numbers.code,
        names,
        [*lower.numbers.values, *upper.numbers.values],
        lambda v: media.Pair(lower.numbers.build(v[:n]), upper.numbers.build(v[n:])),
    )
    return lower._replace(numbers=numbers, counterbody=upper)


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
        raise InvalidArgumentError("Instrument(indenter=...) is not allowed with a Pair: its upper body is the indenter")
    return replace(instrument, indenter=medium.upper.material)


def _pattern(medium: Any) -> MediumNumbers:
    """An elastic body of any kind: what lies in each layer and below it, from the surface down, then what its model and its surface
    have."""
    surface = getattr(medium, "surface", None)
    model = getattr(medium, "model", "exact")
    chosen, constant = settings(model, dict(getattr(medium, "options", ())), surface=surface), MODELS[model].constant
    entries: list[str | float] = []
    if isinstance(medium, media.Homogeneous):
        entries += _of_material(medium.material)
    elif isinstance(medium, media.Graded):
        entries += [f"{name}[{i}]" for i in range(len(medium.parameters()) // 3) for name in ("z", "E", "nu")]
    elif isinstance(medium, media.Coated):
        slides = 0.0 if medium.substrate is SMOOTH else math.inf
        entries += [*_of_material(medium.coating, "coating."), "thickness", 0.0, math.inf, slides]
    else:
        known = medium.parameters()
        for i, (material, _) in enumerate(medium.layers):
            place = f"layers[{i}]."
            entries += [*_of_material(material, place), place + "thickness", place + "prestress"]
            springs = [f"{place}interface.{name}" for name in ("normal", "tangential")]
            entries += [name if known.get(name) else math.inf for name in springs]
            if known.get(springs[1]) == 0.0 or (medium.substrate is SMOOTH and i == len(medium.layers) - 1):
                entries[-1] = 0.0
    if isinstance(getattr(medium, "substrate", None), (Elastic, TransverselyIsotropic)):
        entries += _of_material(medium.substrate, "substrate.")
    entries += [*([constant] if constant else []), *(["surface.tension", "surface.bending"] if surface else [])]
    return MediumNumbers(_numbers(_layout.FIT_MEDIUM_PATTERN, medium, entries), medium, chosen.code, chosen.record)


def _of_material(material: Any, place: str = "") -> list[str | float]:
    """What a contact feels of an elastic material."""
    return [place + name for name in material.parameters() if not name.startswith("conductor.")]


def _viscoelastic(medium: Any) -> MediumNumbers:
    """The numbers of each material from the surface down, behind those of a layer its thickness."""
    known = medium.parameters()
    times = [(name.split("terms[")[0], value) for name, value in known.items() if name.endswith("].time")]
    if len(set(times)) < len(times):
        words = "two terms of equal time are one, which has no two moduli to be fitted"
        raise InvalidArgumentError(f"terms is not allowed: {words}")
    names = [name for name in known if "conductor." not in name and not name.endswith("prestress")]
    return MediumNumbers(_numbers(_layout.FIT_MEDIUM_PATTERN, medium, names), medium)


def of_instrument(instrument: Instrument) -> Numbers:
    """The instrument's parameters."""
    if not isinstance(instrument, Instrument):
        raise ArgumentTypeError(f"instrument = {instrument!r} is not allowed: it must be an Instrument(...)")
    modulus = math.inf if instrument.indenter is None else instrument.indenter.contact_modulus
    values = [modulus if name == "indenter_modulus" else getattr(instrument, name) for name in INSTRUMENT]

    def build(v: Sequence[float]) -> Instrument:
        changed: dict[str, Any] = {name: value for name, value in zip(INSTRUMENT, v, strict=True) if name != "indenter_modulus"}
        if v[4] != modulus:
            changed["indenter"] = Elastic(v[4], 0.0)
        return replace(instrument, **changed)

    return Numbers(0, list(INSTRUMENT), values, build)


def read_free(free: Any, names: Sequence[str]) -> dict[str, Free]:
    """The free parameters by name; a wrong name is answered with the nearest right one."""
    if isinstance(free, str):
        free = [free]
    chosen = dict(free) if isinstance(free, Mapping) else {name: Free() for name in free}
    known = [name for name in names if name]
    for name, entry in chosen.items():
        if name not in known:
            raise InvalidArgumentError(f"free parameter {name!r} is not allowed: {nearest(str(name), known)}")
        if isinstance(entry, Free):
            continue
        if entry is not None and not isinstance(entry, (int, float)):
            raise ArgumentTypeError(f"free[{name!r}] = {entry!r} is not allowed: it must be Free(...), a starting value or None")
        chosen[name] = Free(entry)
    return chosen


def read_known(known: Iterable[JointPrior], names: Sequence[str], free: dict[str, Free]) -> NDArray[np.float64]:
    """The weights of joint priors, (priors, parameters); makes their parameters free."""
    rows = [np.zeros((0, len(names)))]
    taken: set[str] = set()
    for prior in known:
        if not isinstance(prior, JointPrior):
            raise ArgumentTypeError(f"known = {prior!r} is not allowed: it must hold JointPrior(...)")
        for name in prior.names:
            if not name or name not in names:
                raise InvalidArgumentError(f"joint prior of {name!r} is not allowed: {nearest(str(name), [n for n in names if n])}")
            if name in taken or (name in free and free[name].prior is not None):
                raise InvalidArgumentError(f"{name} has two priors: keep one")
            taken.add(name)
        weights = np.zeros((len(prior.names), len(names)))
        weights[:, [names.index(name) for name in prior.names]] = prior.weights()
        rows.append(weights)
        for name in prior.names:
            free.setdefault(name, Free())
    return np.concatenate(rows)
