# SPDX-License-Identifier: GPL-3.0-or-later
"""Text of warnings about a fit: no convergence, bounds, parameters that the data do not determine, patterns left."""

from __future__ import annotations

import math

import numpy as np

from ... import medium as media
from ... import profile as profiles
from ..._units import LENGTH, MODULUS, shown
from ...errors import MDRError
from ...loop import BRANCHES
from ...material import Elastic
from .contradictions import contradictions
from .data import ForceDepth, ModulusRadius, StiffnessDepth, StiffnessRadius
from .indent import LOST
from .misfit import SMALL, percent
from .pyramid_fit import corrected
from .pyramids import PYRAMIDS
from .result import FitResult
from .yielding import warning_of

_LARGE_ERROR = 0.3
_STRONG_CORRELATION = 0.98
_UNDETERMINED = 1e-9
_BLUNT = 50e-9
_FAR_APART = 0.15
"""Fraction of the depth by which estimators of the contact point disagree."""
_STRAYS, _STRAY_SHARE = 3, 0.01
"""Readings about a jump that noise may put on the wrong side of it."""
_PLASTIC = 0.7
"""Part of the depth that stays, from which on surfaces may pile up."""
_PYRAMID = 0.1
"""Relative error of the modulus of a film that is fitted as under the cone of a pyramid, from which on fits warn."""
_SMALL_CONTACT, _LARGE_CONTACT = 0.1, 3.0


def advice(result: FitResult) -> list[str]:
    """All warnings about a result."""
    try:
        alone, radius = result.problem.predict(result._values)
    except MDRError:
        alone, radius = result.fitted, np.zeros(0)
    radius = radius[radius > 0.0]
    return [
        *result.data.warnings,
        *_contact_point(result),
        *_search(result),
        *_identifiability(result, radius),
        *_pattern(result),
        *_tip(result, radius),
        *_pyramid(result),
        *_pile_up(result),
        *_forced(result),
        *_yields(result),
        *_branches(result, alone),
        *_softer_than_base(result),
    ]


def _contact_point(result: FitResult) -> list[str]:
    """Depths of first contact that the estimators found in the record before the fit."""
    found = list(result.data.contact_points.values())
    apart, deepest = float(np.ptp(found or [0.0])), float(np.max(result.data.x)) - result.values["depth_offset"]
    if not apart > max(_FAR_APART * deepest, 0.0):
        return []
    share = f"{100.0 * apart / deepest:.0f} % of the depth" if deepest > 0.0 else "more than the depth"
    what = "look at the curve" if "depth_offset" in result.names else "look at the curve, and leave depth_offset free"
    return [f"the estimators of the contact point disagree by {shown(apart, LENGTH)}, {share}: {what}"]


def _search(result: FitResult) -> list[str]:
    words = []
    if not result.converged:
        words.append(
            f"the search did not converge in {result.iterations} iterations; this is the best point found. Begin closer, fix a "
            "parameter, or give it a prior"
        )
    for name, side in result.at_bound.items():
        if side:
            words.append(f"{name} = {result.estimates[name]:.4g} lies {result.bound_words(name)}; it has no standard error")
    return words


def _identifiability(result: FitResult, radius: np.ndarray) -> list[str]:
    words = []
    vague = [name for name in result.names if _relative(result, name) > _LARGE_ERROR]
    correlation = result.correlation
    pairs = [
        (abs(correlation[i, j]), result.names[j], result.names[i], correlation[i, j])
        for i in range(len(result.names))
        for j in range(i)
        if abs(correlation[i, j]) > _STRONG_CORRELATION
        and not (_is_prior(result, result.names[i]) or _is_prior(result, result.names[j]))
    ]
    if not vague and not pairs and result.weakest > _UNDETERMINED:
        return []
    for _, one, other, c in sorted(pairs, reverse=True)[:3]:
        if max(_relative(result, one), _relative(result, other)) < 0.01:
            continue
        how = "against each other" if c > 0 else "for each other"
        direction = "a rise of both" if c > 0 else "a rise of one and a fall of the other"
        words.append(
            f"{one} and {other} trade off {how} (correlation {c:+.4f}): {direction} leaves the curve almost as it is. A prior on "
            "one of them, or data over a wider range of a/h, would separate them"
        )
    for name in [name for name in vague if not _is_prior(result, name)]:
        words.append(
            f"{name} is hardly determined: its standard error is {100.0 * min(_relative(result, name), 1e6):.3g} % of its value"
        )
    if len(result.names) > 1 and result.weakest == 0.0:
        words.insert(
            0,
            f"the data do not determine {' and '.join(result.names)} together: some change of them leaves the curve as it is; fix "
            "one of them, give it a prior, or give more points",
        )
    if words:
        regime = _regime(result, radius)
        weak = ", ".join(f"{name} {100.0 * change:+.0f}" for name, change in result.weakest_direction.items() if abs(change) > 0.02)
        if result.weakest < 0.05 and len(result.names) > 1:
            words.append(f"the data determine this combination least (relative changes): {weak}")
        if regime:
            words.append(regime)
    return words


def _is_prior(result: FitResult, name: str) -> bool:
    """Whether the data add nothing to the prior of a parameter, so that its trade-off is expected."""
    prior = result.problem.free[name].prior
    if prior is not None:
        return result.standard_errors[name] > 0.9 * prior[1]
    return bool(np.any(result.problem.weights[:, result.problem.names.index(name)] != 0.0))


def _relative(result: FitResult, name: str) -> float:
    """The standard error as a part of the value; offsets, stresses and Poisson's ratios have no natural size and are left out."""
    value, error = result.estimates[name], result.standard_errors[name]
    sizeless = name.endswith(("offset", "nu", "nu_t", "nu_tz", "exponent", "prestress", "frame_compliance"))
    if result.at_bound[name] or sizeless:
        return 0.0
    return error / abs(value) if value and math.isfinite(error) else math.inf


def _regime(result: FitResult, radius: np.ndarray) -> str | None:
    """Contact radii relative to the film thickness, which determine the sensitivity to film and substrate."""
    span = _ratio_range(result, radius)
    if span is None:
        return None
    low, high = span
    reach = f"a/h runs from {low:.3g} to {high:.3g}"
    if high < _SMALL_CONTACT:
        return f"{reach}: the contacts are small against the thickness and hardly depend on thickness and substrate"
    if low > _LARGE_CONTACT:
        return f"{reach}: the contacts are wide against the thickness; of the film they show only its stiffness times thickness"
    if high < 0.5:
        return f"{reach}: larger contacts would distinguish the film from the substrate"
    if low > 0.3:
        return f"{reach}: smaller contacts would show the film alone"
    return f"{reach}: the contacts depend on both film and substrate, so the noise limits the estimates"


def _ratio_range(result: FitResult, radius: np.ndarray) -> tuple[float, float] | None:
    """Smallest and largest a/h of the data under the fitted model; None without a film or contact."""
    medium = result.medium
    if not len(radius) or not isinstance(medium, media.Coated | media.Layered):
        return None
    _, h = medium._stack()[0]
    return float(radius.min() / h), float(radius.max() / h)


def _pattern(result: FitResult) -> list[str]:
    words = []
    if result.is_without_noise and not result.noise_is_known:
        words.append(
            "the residuals are no larger than the rounding of data and model: standard errors estimated from them do not hold "
            "for real readings"
        )
    elif result.departure > SMALL:
        widest = max(result.widening.values(), default=1.0)
        errors = f", widened up to {widest:.2g} times for correlated neighbours" if widest > 1.0 else ""
        words.append(
            f"the model {result.misfit_of_readings()}. The standard errors{errors} do not include its effect on the estimates: "
            "check how much they change with the fitted range"
        )
    if result.hidden:
        finite = math.isfinite(result.hidden)
        more = "more readings, or give the standard deviations of the readings, sd or relative_sd" if finite else "more readings"
        words.append(f"{result.hidden_words()}. Take {more}")
    ratio = f"chi-square/dof = {result.reduced_chi_square:.3g}"
    if result.scatter > 0:
        words.append(f"the data deviate from the fit by more than their standard deviations: {ratio}")
    elif result.scatter < 0:
        words.append(
            f"the standard deviations given are {result.excess_words()} the scatter of the data about the fit ({ratio}): they are "
            "too large, or include errors that all readings share. Standard errors and intervals are based on them"
        )
    return words


def _tip(result: FitResult, radius: np.ndarray) -> list[str]:
    """Effect of a usual tip rounding on the area, if the tip is assumed to be ideal."""
    tip = result.indenter
    inclination = _inclination(tip)
    if inclination is None or isinstance(result.data, (ModulusRadius, StiffnessRadius)):
        return []
    if "area_factor" in result.names or not len(radius):
        return []
    height = math.tan(inclination) * float(np.median(radius))
    # a sphere that is tangent to the cone leaves so much of its tip missing
    missing = _BLUNT * (1.0 / math.cos(inclination) - 1.0)
    share = (1.0 + missing / height) ** 2 - 1.0
    if share < 0.01:
        return []
    return [
        f"the tip is taken as ideally sharp. A rounding of {_BLUNT * 1e9:.0f} nm, usual for a used tip, would make the contact "
        f"area {100.0 * share:.0f} % larger in the middle of the depths, and the moduli wrong by about half of that or more. "
        "The errors do not include this. Use the area function of the tip's calibration, or a prior on area_factor"
    ]


def _inclination(tip: object) -> float | None:
    """Inclination of a tip with a sharp apex, including an area function with only C0; None for others."""
    if isinstance(tip, profiles.AreaFunction):
        area, *others = tip.coefficients
        is_cone = area > 0.0 and tip.min_height == 0.0 and not any(others)
        return math.atan(math.sqrt(math.pi / area)) if is_cone else None
    is_sharp = isinstance(tip, (profiles.Berkovich, profiles.Vickers, profiles.CubeCorner, profiles.Cone))
    return float(tip.inclination) if is_sharp else None  # type: ignore[attr-defined]


def _pyramid(result: FitResult) -> list[str]:
    """Error of the modulus of a film, if the force is that of a pyramid and fitted as that of its cone."""
    films = [name for name in ("coating.E", "layers[0].E") if name in result.names]
    is_force = isinstance(result.data, ForceDepth) and not result.values["work_of_adhesion"]
    if result.pyramid_correction is not None or not isinstance(result.indenter, PYRAMIDS) or not films or not is_force:
        return []
    tip, name = type(result.indenter).__name__, films[0]
    try:
        factor = result.values[name] / corrected(result).values[name]
    except MDRError:
        return _uncorrected(result.medium, tip)
    if abs(factor - 1.0) < _PYRAMID:
        return []
    size = f"{100.0 * abs(factor - 1.0):.0f} % too {'high' if factor > 1.0 else 'low'}"
    is_rigid = result.instrument.indenter is None
    return [
        f"the tip {tip} is taken as its equivalent cone: {name} is about {size}. "
        + ("Set pyramid_correction to true, or fit shallower depths" if is_rigid else "Fit shallower depths")
    ]


def _uncorrected(medium: object, tip: str) -> list[str]:
    """A film stiffer than its base that the table of pyramids does not have."""
    film, _ = medium._stack()[0]  # type: ignore[attr-defined]
    base = medium.substrate  # type: ignore[attr-defined]
    if not (isinstance(film, Elastic) and isinstance(base, Elastic) and film.contact_modulus > base.contact_modulus):
        return []
    return [
        f"the tip {tip} is taken as its equivalent cone, and the film is stiffer than the base: the force of a pyramid is larger, "
        "and the modulus of the film may be too high by a factor of 2. No correction is tabulated for this body. Fit shallower "
        "depths"
    ]


def _softer_than_base(result: FitResult) -> list[str]:
    """A film that began stiffer than what lies below it and ended softer: the readings are softer than the bare base would be."""
    names = contradictions(result)
    problem = result.problem
    return [
        f"{name} = {shown(result.values[name], MODULUS, 3)} is softer than what lies below, where the search began at "
        f"{shown(problem.table[0, problem.names.index(name)], MODULUS, 3)}: the readings are softer than the base would be without "
        "the film. They do not determine the film: check for a blunter or rougher tip, yield, a wrong contact point or radius, or "
        "a softer base"
        for name in names
    ]


def _pile_up(result: FitResult) -> list[str]:
    """Pile-up, which no contact depth includes: an unloading curve of the power 1.5 leaves a residual depth of h - 1.5 P/S."""
    data, tool = result.data, result.instrument
    if not isinstance(data, StiffnessDepth) or data.force is None or {"contact_depth_factor", "area_factor"} & set(result.names):
        return []
    load = data.force - tool.force_offset
    depth = data.x - tool.depth_offset - tool.frame_compliance * load
    stays = float(np.median(1.0 - 1.5 * load * (1.0 / data.y - tool.frame_compliance) / depth))
    if stays < _PLASTIC or tool.contact_depth_factor <= 0.0:
        return []
    return [
        f"the contact is plastic: about {100.0 * stays:.0f} % of the depth stay. Surfaces of materials that hardly harden then "
        f"pile up: the area is up to 60 % larger than at any contact depth (Bolshakov and Pharr 1998), and the modulus up to "
        f"{100.0 * (math.sqrt(1.6) - 1.0):.0f} % too high. The errors do not include this. Inspect an indent, or give "
        "contact_depth_factor or area_factor a prior"
    ]


def _branches(result: FitResult, alone: np.ndarray) -> list[str]:
    """Whether the readings are in contact where the model is not, or the other way round."""
    data = result.data
    if not isinstance(data, ForceDepth):
        return []
    if words := _indent(result):
        return words
    if not result.values["work_of_adhesion"] > 0.0:
        return _apart(data)
    scale = result.noise * (1.0 if data.sd is None else data.sd)
    differs = int(np.sum(np.abs(alone - result.fitted) > 3.0 * scale))
    if differs <= max(_STRAYS, _STRAY_SHARE * len(data)):
        return []
    return [
        f"{differs} of {len(data)} readings are in contact where the fitted model is apart, or apart where it is in contact: "
        "pull-off or initial contact differs from that of the model. The fit uses the measured state of these readings"
    ]


def _apart(data: ForceDepth) -> list[str]:
    """Loading and unloading, fitted by one law that is the same for both."""
    if data.branch is None or len(np.unique(data.branch)) < 2:
        return []
    ways = [data.on(branch) for branch in ("loading", "unloading")]
    low, high = max(way.x.min() for way in ways), min(way.x.max() for way in ways)
    depth = np.linspace(low, high, 200)
    one, other = (np.interp(depth, way.x[order], way.y[order]) for way in ways for order in [np.argsort(way.x)])
    share = float(np.sqrt(np.mean((one - other) ** 2))) / float(np.ptp(data.y))
    if not share > SMALL:
        return []
    return [
        f"loading and unloading differ by {percent(share)} of the force (root mean square) and are fitted as one elastic curve "
        'without adhesion: fit one of them, branch = "loading", or let work_of_adhesion be free'
    ]


def _indent(result: FitResult) -> list[str]:
    """A body that does not spring back as an elastic one, fitted or not."""
    found = result.indent
    if found is None:
        return []
    left = f"{shown(found.residual_depth, LENGTH, 3)} deeper, {percent(found.share)} of the depth"
    if not found.is_within:
        return [
            f"loading continues beyond the fitted readings, and unloading from there ends {left}: the body yields, or creeps, on "
            "the way. Unloading from the end of the fitted readings would show whether they are elastic"
        ]
    is_loading = result.data.branch is None or BRANCHES["loading"] in result.data.branch
    # from initial contact the force on unloading is below that of loading; from the end of unloading it is that of a blunt indenter
    is_low = is_loading or "depth_offset" not in result.problem.free
    effect = "low" if is_low else "high, as the imprint is blunter than the tip"
    return [
        f"unloading gives back {percent(found.returned)} of the work of loading and ends {left}: the contact is plastic, or the "
        f"body creeps. The fit treats it as elastic, so the modulus is too {effect}. Fit the stiffness of the unloading curve, "
        'kind = "unloading", or the shallow part of loading'
    ]


def _forced(result: FitResult) -> list[str]:
    """A contact that is taken as elastic against the data."""
    data = result.data
    if not isinstance(data, StiffnessDepth) or not data.elastic or data.seems_elastic:
        return []
    if data.unloadings:
        stays = float(np.median([q.final_depth / q.depth for q in data.unloadings]))
        words = f"{percent(stays)} of the depth stays after unloading"
    else:
        rise = data.reversibility()
        stays = 1.0 - rise
        words = f"the force rises by {percent(rise)} of what its stiffness gives"
    if not stays > LOST:
        return []
    return [f"elastic = true, but the contact is plastic: {words}. Contact depths are those of an elastic contact, and too small"]


def _yields(result: FitResult) -> list[str]:
    """What the yield stresses tell."""
    if result.yield_ratio > 1.0:
        return [
            f"under the largest force the von Mises stress of the fitted elastic contact is {result.yield_ratio:.2g} times the "
            "yield stress: the contact is plastic, and its modulus is too low. Fit the stiffness of an unloading curve, kind = "
            '"unloading", or the shallow part'
        ]
    return warning_of(result.reverse_yield)
