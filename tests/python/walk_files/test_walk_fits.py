# SPDX-License-Identifier: GPL-3.0-or-later
"""Each argument of data, instruments, priors and fits, changed, changes estimates, errors or misfit, or is refused with words."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact._units import dimensions
from mdrcontact.instruments.fitting.problem import LOSSES, make_problem
from mdrcontact.instruments.fitting.weighted import RULES as WEIGHT_RULES
from mdrcontact.loop import RULES

from .commands import difference, numbers_of

SEEN = 1e-7
FILM, BASE = mdr.Elastic(9.1e9, 0.27), mdr.Elastic(3.05e9, 0.34)
BODY = mdr.Coated(FILM, 2.1e-6, BASE)
TIP = mdr.Paraboloid(5.1e-5)
SOFT = mdr.Viscoelastic(0.71e9, [(1.9e9, 0.31)], nu=0.37)
NOISE = np.random.default_rng(11)
BIT = 1.0 + 0.01 * NOISE.standard_normal(40)


class Case(NamedTuple):
    """A fit: what makes its data, with which arguments, and what fit takes besides."""

    name: str
    make: Callable[..., Any]
    data: dict[str, Any]
    fit: dict[str, Any]


def _force_depth() -> dict[str, Any]:
    contact = mdr.Contact(TIP, BODY, work_of_adhesion=0.9)
    depth = np.concatenate([np.linspace(2.1e-8, 1.6e-7, 8), np.linspace(1.5e-7, -2e-9, 7)])
    force = np.concatenate([contact.at_depth(depth[:8], branch="loading").force, contact.at_depth(depth[8:]).force])
    return {"depth": depth + 1.1e-9, "force": force * BIT[:15], "relative_sd": None, "sd": 2.3e-6 * BIT[10:25] ** 9,
            "missing": "raise", "branch": ["loading"] * 8 + ["unloading"] * 7}  # fmt: skip


def _pyramid() -> dict[str, Any]:
    state = mdr.Contact(mdr.Berkovich(), BODY).at_radius(np.linspace(0.7e-6, 5.3e-6, 9))
    ratio = mdi.pyramid_correction(mdr.Berkovich(), BODY, state.radius / BODY.thickness).force
    return {"depth": state.depth + 1.3e-9, "force": ratio * state.force * BIT[:9] + 1.1e-6, "relative_sd": 0.013, "sd": None,
            "missing": "raise", "branch": ["loading"] * 9}  # fmt: skip


def _stiffness_depth() -> dict[str, Any]:
    state = mdr.Contact(TIP, BODY).at_depth(np.linspace(2.1e-8, 1.6e-7, 5))
    return {"depth": state.depth, "force": state.force, "stiffness": state.stiffness * BIT[:5], "sd": None, "relative_sd": 0.013,
            "missing": "raise", "elastic": False}  # fmt: skip


def _in_radius(name: str) -> dict[str, Any]:
    radius = np.linspace(0.7e-6, 5.3e-6, 9)
    values = {"modulus": BODY.modulus(radius), "stiffness": 2.0 * radius * BODY.modulus(radius)}[name]
    return {"radius": radius, name: values * BIT[:9], "sd": None, "relative_sd": 0.013, "missing": "raise"}


def _in_time(last: str) -> dict[str, Any]:
    time = np.linspace(0.1, 2.7, 9)
    path = mdr.Contact(TIP, mdr.Homogeneous(SOFT)).history(time, depth=3e-8 * np.sqrt(time))
    columns = {
        "force": {"depth": path.depth, "force": path.force * BIT[:9]},
        "depth": {"force": path.force, "depth": path.depth * BIT[:9]},
    }
    return {"time": time, **columns[last], "sd": None, "relative_sd": 0.013, "missing": "raise"}


def _dynamic() -> dict[str, Any]:
    omega = np.geomspace(0.1, 30.0, 7)
    found = mdr.Contact(TIP, mdr.Homogeneous(SOFT)).dynamic_stiffness(omega, radius=2.1e-6)
    return {"omega": omega, "stiffness": found * BIT[:7], "radius": np.full(7, 2.1e-6), "sd": None, "relative_sd": 0.013,
            "missing": "raise"}  # fmt: skip


FREE = {"coating.E": mdi.Free(8e9, lower=1e9, upper=1e11),
        "thickness": mdi.Free(2.3e-6, lower=1e-7, upper=1e-5, prior=(2.0e-6, 3e-7))}  # fmt: skip
BINDING = {1e11: 8.05e9, 1e-7: 2.25e-6, 1e9: 1.1e9, 1e-5: 1.1e-5}
"""By the bounds above: others, two of which lie before the estimate."""
INSTRUMENT = mdi.Instrument(depth_offset=1.3e-9, frame_compliance=2e-7, indenter=mdr.Elastic(71e9, 0.21), contact_depth_factor=0.71,
                            stiffness_factor=1.03, contact_depth_scale=1.05, area_factor=0.97)  # fmt: skip
STICKY = mdi.Instrument(work_of_adhesion=0.9, depth_offset=1.3e-9, force_offset=1.1e-6, frame_compliance=2e-7,
                        indenter=mdr.Elastic(71e9, 0.21))  # fmt: skip
OF_RADIUS = mdi.Instrument(frame_compliance=2e-7, indenter=mdr.Elastic(71e9, 0.21), stiffness_factor=1.03, area_factor=0.97)
OF_PATH = mdi.Instrument(depth_offset=1.3e-9, force_offset=1.1e-7)
OF_OSCILLATION = mdi.Instrument(frame_compliance=2e-6, stiffness_factor=1.03, area_factor=0.97)
PRIOR = mdi.JointPrior(("coating.E", "substrate.E"), (8.7e9, 3.3e9), ((9e16, 1.1e16), (1.1e16, 4e16)))
FIT = {"indenter": TIP, "medium": BODY, "free": FREE, "instrument": INSTRUMENT, "loss": "huber", "loss_scale": 0.7,
       "adhesion_rule": "automatic", "sd_is_absolute": False, "max_iterations": 100, "check_units": True, "known": (PRIOR,),
       "contact_weight": 0.0, "contact_weight_rule": "held", "yield_stresses": (), "pyramid_correction": False}  # fmt: skip
PYRAMID = {**FIT, "indenter": mdr.Berkovich(), "instrument": mdi.Instrument(depth_offset=1.3e-9, force_offset=1.1e-6), "known": (),
           "free": {"coating.E": FREE["coating.E"]}, "pyramid_correction": True}  # fmt: skip
OF_TIME = {**FIT, "medium": mdr.Homogeneous(SOFT), "free": ["relaxed_shear_modulus"], "instrument": OF_PATH, "known": (),
           "loss": "cauchy"}  # fmt: skip
WEIGHED = {**FIT, "instrument": STICKY, "loss": "linear", "contact_weight": 3.1e-8, "contact_weight_rule": "moving",
           "free": {**FREE, "depth_offset": mdi.Free(1e-9)}, "known": ()}  # fmt: skip
CASES = [
    Case(
        "force-depth",
        mdi.ForceDepth,
        _force_depth(),
        {**FIT, "instrument": STICKY, "adhesion_rule": "energy", "yield_stresses": (0.13e9, None)},
    ),
    Case("weighed", mdi.ForceDepth, _force_depth(), WEIGHED),
    Case("pyramid", mdi.ForceDepth, _pyramid(), PYRAMID),
    Case("stiffness-depth", mdi.StiffnessDepth, _stiffness_depth(), {**FIT, "yield_stresses": (0.53e9, 0.61e9)}),
    Case("modulus-radius", mdi.ModulusRadius, _in_radius("modulus"), {**FIT, "instrument": mdi.Instrument(area_factor=0.97)}),
    Case("stiffness-radius", mdi.StiffnessRadius, _in_radius("stiffness"), {**FIT, "instrument": OF_RADIUS}),
    Case("force-time", mdi.ForceTime, _in_time("force"), OF_TIME),
    Case("depth-time", mdi.DepthTime, _in_time("depth"), OF_TIME),
    Case("dynamic-stiffness", mdi.DynamicStiffness, _dynamic(), {**OF_TIME, "instrument": OF_OSCILLATION}),
]
WORDS: dict[str, tuple[str, ...]] = {
    "missing": ("raise", "drop"),
    "loss": tuple(LOSSES),
    "adhesion_rule": tuple(RULES),
    "contact_weight_rule": tuple(WEIGHT_RULES),
    "branch": ("loading", "unloading"),
}
ABSENT = {"sd": 1.7e-6, "relative_sd": 0.02, "instrument": INSTRUMENT, "indenter": mdr.Elastic(71e9, 0.21)}
FROM_ZERO = {"viscosity": 3e7, "cohesive_stress": 3e8}

EXCEPTIONS = {
    ("*", "data.missing", "missing = 'drop'"): "there are no gaps",
    ("*", "fit.check_units", "check_units = False"): "the units are right",
    ("*", "fit.medium", "medium.coating.E 10 % more"): "free, and Free(start) says where the search begins",
    ("*", "fit.medium", "medium.thickness 10 % more"): "free, and Free(start) says where the search begins",
    ("*", "fit.free", "free[coating.E.lower = 1100000000.0]"): "a bound beyond the estimate",
    ("*", "fit.free", "free[thickness.upper = 1.1e-05]"): "a bound beyond the estimate",
    ("force-depth", "fit.free", "free[thickness.lower = 2.25e-06]"): "a bound beyond the estimate",
    ("stiffness-radius", "fit.free", "free[thickness.lower = 2.25e-06]"): "a bound beyond the estimate",
    ("weighed", "fit.free", "free[thickness.start 10 % more]"): "another way of the search to the same place",
    ("weighed", "fit.instrument", "instrument.depth_offset 10 % more"): "free, and Free(start) says where the search begins",
    ("weighed", "fit.loss_scale", "loss_scale 10 % more"): "the loss is linear",
    ("weighed", "fit.adhesion_rule", "adhesion_rule = 'energy'"): "what automatic takes for the exact model",
    ("force-depth", "fit.adhesion_rule", "adhesion_rule = 'automatic'"): "it takes energy for the exact model",
    ("force-depth", "fit.contact_weight_rule", "contact_weight_rule = 'moving'"): "there are no weights",
    ("pyramid", "fit.contact_weight_rule", "contact_weight_rule = 'moving'"): "there are no weights",
    ("pyramid", "data.branch", "branch turned round"): "without adhesion both branches are one curve",
    **{(kind, "fit.contact_weight_rule", "contact_weight_rule = 'moving'"): "there are no weights"
       for kind in ("stiffness-depth", "modulus-radius", "stiffness-radius", "force-time", "depth-time", "dynamic-stiffness")},
    **{(kind, "fit.indenter", "indenter.radius 10 % more"): "data at known contact radii do not depend on the tip"
       for kind in ("modulus-radius", "stiffness-radius", "dynamic-stiffness")},
}  # fmt: skip
"""By case, "*" for any that has the change, argument and change: why nothing changes."""


def _answer(case: Case) -> dict[str, Any]:
    found = mdi.fit(case.make(**case.data), **case.fit)
    return numbers_of({"estimates": found.estimates, "covariance": found.covariance, "chi": found.chi_square, "noise": found.noise,
                       "likelihood": found.log_likelihood, "prior": found.prior_chi_square, "yield": found.yield_ratio,
                       "R_Y": [one.ratio for one in found.reverse_yield], "pyramid": found.pyramid_correction})  # fmt: skip


def _others(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    """What else may stand for an argument, part by part."""
    if name in WORDS and (value is None or isinstance(value, str)):
        yield from ((f"{name} = {word!r}", word) for word in WORDS[name] if word != value)
    elif name in WORDS:
        yield f"{name} turned round", value[::-1]
    elif value is None:
        if name in ABSENT:
            yield f"{name} put in", ABSENT[name]
    elif isinstance(value, bool):
        yield f"{name} = {not value}", not value
    elif isinstance(value, int):
        yield f"{name} = 1", 1
    elif name in ("lower", "upper"):
        if value in BINDING:
            yield f"{name} = {BINDING[value]}", BINDING[value]
    elif isinstance(value, float):
        if math.isfinite(value):
            yield f"{name} 10 % more", 1.1 * value if value else FROM_ZERO.get(name, 1e-8)
    elif isinstance(value, np.ndarray):
        for i in {0, len(value) // 2, len(value) - 1}:
            yield f"{name}[{i}] 10 % more", np.where(np.arange(len(value)) == i, 1.1 * value, value)
    elif isinstance(value, (mdi.Instrument, mdi.Free, mdr.Elastic, mdr.Paraboloid)):
        for member in inspect.signature(type(value)).parameters:
            for how, other in _others(member, getattr(value, member)):
                if not (isinstance(value, mdr.Elastic) and member == "conductor"):
                    yield (
                        f"{name}.{how}",
                        type(value)(**{m: getattr(value, m) for m in inspect.signature(type(value)).parameters} | {member: other}),
                    )
    elif isinstance(value, mdi.JointPrior):
        for i in range(2):
            yield (
                f"{name}.values[{i}]",
                mdi.JointPrior(value.names, tuple(1.1 * v if j == i else v for j, v in enumerate(value.values)), value.covariance),
            )
        for i, j in ((0, 0), (0, 1), (1, 1)):
            table = np.array(value.covariance)
            table[[i, j], [j, i]] *= 1.1
            yield f"{name}.covariance[{i}, {j}]", mdi.JointPrior(value.names, value.values, table)
        yield f"{name}.names", mdi.JointPrior(("coating.E", "coating.nu"), value.values, value.covariance)
    elif isinstance(value, dict):
        for key, part in value.items():
            yield from ((f"{name}[{how}]", {**value, key: other}) for how, other in _others(key, part))
        yield f"{name} without {key}", {k: v for k, v in value.items() if k != key}
    elif isinstance(value, tuple):
        for i, part in enumerate(value):
            yield from ((how, (*value[:i], other, *value[i + 1 :])) for how, other in _others(name, part))
    elif isinstance(value, (mdr.Coated, mdr.Homogeneous)):
        for key, number in value.parameters().items():
            yield from ((f"{name}.{how}", _with(value, key, other)) for how, other in _others(key, float(number)))


def _with(body: Any, key: str, value: float) -> Any:
    return body.with_parameters({key: value})


def _effects(case: Case) -> Iterator[tuple[str, str, float]]:
    before = _answer(case)
    for group, call in (("data", case.make), ("fit", mdi.fit)):
        given = getattr(case, group)
        for name in inspect.signature(call).parameters:
            if (group, name) == ("fit", "data"):
                continue
            assert name in given, f"{call.__name__} has a new argument {name}: put it into the case {case.name}"
            for how, other in _others(name, given[name]):
                changed = case._replace(**{group: {**given, name: other}})
                try:
                    yield f"{group}.{name}", how, difference(before, _answer(changed))
                except (mdr.MDRError, TypeError) as refusal:
                    assert len(str(refusal)) > 10
                    yield f"{group}.{name}", how, math.nan


def _check(cases: list[Case]) -> int:
    """The number of changes; each shows, is refused, or is an exception, and no exception is left over."""
    found, used = 0, set()
    for case in cases:
        for place, how, size in _effects(case):
            found += 1
            lines = [key for key in ((case.name, place, how), ("*", place, how)) if key in EXCEPTIONS]
            assert size > SEEN or math.isnan(size) or lines, f"{case.name}: {place}: {how} changes the fit by {size:.1g}"
            used |= {key for key in lines if size <= SEEN}
    names = [case.name for case in cases]
    assert not {key for key in EXCEPTIONS if key[0] in (*names, "*") and key not in used}, "exceptions that cover nothing"
    return found


@pytest.mark.slow
def test_each_argument_changes_a_fit():
    """All kinds of data."""
    print(f"{_check(CASES)} changes of arguments of data and fits, {len(EXCEPTIONS)} exceptions")


def test_some_arguments_change_a_fit():
    """Of the kind of data that is fitted fastest."""
    assert _check([case for case in CASES if case.name == "modulus-radius"]) > 40


def _predicted(case: Case, name: str) -> tuple[float, float]:
    """A value of a number of the instrument that is not its default, and how far it moves what the library predicts; 0 where that
    refuses it. The fit's own checks are not in the way: the value comes after them."""
    problem = make_problem(case.make(**case.data), case.fit["indenter"], case.fit["medium"], case.fit["free"], _bare(case))
    values = problem.table[0].copy()
    place = problem.names.index(name)
    before = problem.predict(values)[0]
    values[place] = OTHER[name]
    try:
        return OTHER[name], float(np.max(np.abs(problem.predict(values)[0] - before)) / np.max(np.abs(before)))
    except mdr.MDRError:
        return OTHER[name], 0.0


def _bare(case: Case) -> mdi.Instrument:
    return mdi.Instrument(work_of_adhesion=0.9) if case.name == "force-depth" else mdi.Instrument()


OTHER = {"work_of_adhesion": 1.3, "depth_offset": -1e-9, "force_offset": -1e-7, "frame_compliance": 1e-7,
         "contact_depth_factor": 0.71, "stiffness_factor": 1.03, "contact_depth_scale": 1.05, "area_factor": 0.97,
         "cohesive_stress": 3e8}  # fmt: skip


@pytest.mark.parametrize("case", [case for case in CASES if case.name != "weighed"], ids=lambda case: case.name)
def test_a_fit_takes_the_numbers_of_the_instrument_that_its_data_depend_on(case):
    """And refuses all others with words, as values, free and in a joint prior."""
    data, free = case.make(**case.data), dict.fromkeys(case.fit["free"])
    for name in dimensions(mdi.Instrument):
        value, moves = _predicted(case, name)
        known = [mdi.JointPrior((name,), (value,), ((1e-4 * value**2,),))]
        other = _bare(case).replace(**{name: value})
        for more in ({"instrument": other}, {"free": {**free, name: None}}, {"known": known}):
            given = {"free": free, "instrument": _bare(case), **more}
            words = ""
            try:
                problem = make_problem(data, case.fit["indenter"], case.fit["medium"], **given)
                problem.predict(problem.table[0])
            except mdr.MDRError as refusal:
                words = str(refusal)
            assert bool(words) == (moves == 0.0), f"{name}, {more} changes the prediction by {moves:.1g}; {words or 'not refused'}"
            assert not words or name in words


@pytest.mark.parametrize("rule", ["paper", "energy"])
@pytest.mark.parametrize("case", [case for case in CASES if case.name != "weighed"], ids=lambda case: case.name)
def test_a_rule_of_adhesion_needs_adhesion(case, rule):
    data = case.make(**case.data)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="it needs adhesion"):
        make_problem(data, case.fit["indenter"], case.fit["medium"], case.fit["free"], adhesion_rule=rule)
    if case.name == "force-depth":
        free = {**FREE, "work_of_adhesion": mdi.Free(0.9)}
        make_problem(data, TIP, BODY, free, adhesion_rule=rule)
        make_problem(data, TIP, BODY, FREE, STICKY, adhesion_rule=rule)


def test_a_range_needs_adhesion_that_follows_the_balance_of_energy():
    data = mdi.ForceDepth(**_force_depth())
    ranged = mdi.Instrument(cohesive_stress=3e8)
    for free, instrument in ((FREE, ranged), ({**FREE, "cohesive_stress": 3e8}, None)):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="it needs a work_of_adhesion"):
            make_problem(data, TIP, BODY, free, instrument)
    make_problem(data, TIP, BODY, {**FREE, "work_of_adhesion": 0.9}, ranged)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="has no cohesive zone"):
        make_problem(data, TIP, BODY, FREE, STICKY.replace(cohesive_stress=3e8), adhesion_rule="paper")
