# SPDX-License-Identifier: GPL-3.0-or-later
"""What must hold for every indenter and every medium, over bodies that hypothesis chooses.

Lengths of the bodies are near 1, moduli near 1; `scale` and `stiffen` take them to any units. `HYPOTHESIS_PROFILE=search` looks
longer and elsewhere each time.
"""

import functools
import math
import os
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

import mdrcontact as mdr

slow = [HealthCheck.too_slow, HealthCheck.filter_too_much]
settings.register_profile("fixed", derandomize=True, deadline=None, database=None, max_examples=60, suppress_health_check=slow)
settings.register_profile("search", deadline=None, max_examples=500, suppress_health_check=slow, print_blob=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "fixed"))

pytestmark = pytest.mark.filterwarnings("ignore::mdrcontact.NotOneDiscWarning")
"""Stiff single films lift off beside the contact: right to be told, and what is checked here holds all the same."""


class Tip(NamedTuple):
    """An indenter in the unit of length `scale`; contacts are asked for between the radii `low` and `high`."""

    build: Callable[[float], mdr.Profile]
    low: float = 0.02
    high: float = 3.0
    flat: bool = False
    corner: float | None = None
    """where f or its curvature has a step"""


class Body(NamedTuple):
    """A medium in the units `scale` of length and `stiffen` of modulus."""

    build: Callable[[float, float], mdr.Medium]
    exact: bool = False
    gradient: bool = False
    """Layers are under the surface, however E_eff is found: its own modulus does not matter alone."""


def _between(low, high):
    """Numbers evenly spread in their logarithm."""
    return st.floats(math.log(low), math.log(high)).map(math.exp)


lengths = _between(0.2, 20.0)
inclinations = st.floats(0.02, 1.2)
flats = _between(0.05, 1.0)

simple_tips = st.one_of(
    lengths.map(lambda R: Tip(lambda s: mdr.Paraboloid(R * s))),
    lengths.map(lambda R: Tip(lambda s: mdr.Sphere(R * s), low=min(0.02, 0.1 * R), high=min(3.0, 0.95 * R))),
    inclinations.map(lambda phi: Tip(lambda s: mdr.Cone(phi))),
    st.tuples(st.floats(0.5, 6.0), lengths).map(lambda v: Tip(lambda s: mdr.PowerLaw(v[0], v[1] * s ** (1.0 - v[0])))),
    st.tuples(flats, inclinations).map(lambda v: Tip(lambda s: mdr.RoundedCone(v[0] * s, v[1]), corner=v[0])),
    st.sampled_from([Tip(lambda s: mdr.Berkovich()), Tip(lambda s: mdr.CubeCorner())]),
    st.tuples(st.floats(5.0, 30.0), flats).map(
        lambda v: Tip(lambda s: mdr.AreaFunction([v[0], v[1] * s], max_height=4.0 * s), high=2.5)
    ),
)


def _flat_ended(build, end_radius):
    return Tip(build, low=1.05 * end_radius, flat=True, corner=end_radius)


flat_ended_tips = st.one_of(
    st.tuples(flats, inclinations).map(lambda v: _flat_ended(lambda s: mdr.FlatEndedCone(v[0] * s, v[1]), v[0])),
    st.tuples(flats, lengths).map(lambda v: _flat_ended(lambda s: mdr.FlatEndedParaboloid(v[0] * s, v[1] * s), v[0])),
)


def _sum(first, second):
    """Contacts reach from the larger flat end to the end of the shorter tip."""
    low, high = max(first.low, second.low), min(first.high, second.high)
    return Tip(lambda s: first.build(s) + second.build(s), low, high, first.flat)


sums = (
    st.tuples(st.one_of(simple_tips, flat_ended_tips), simple_tips)
    .map(lambda v: _sum(*v))
    .filter(lambda tip: tip.low < 0.8 * tip.high)
)
tips = st.one_of(simple_tips, flat_ended_tips, sums)

materials = st.tuples(_between(0.1, 10.0), st.floats(-0.5, 0.5))
"""E and nu."""


def _elastic(material, stiffen):
    return mdr.Elastic(material[0] * stiffen, material[1])


def _coated(film, h, base, model):
    def build(s, t):
        return mdr.Coated(_elastic(film, t), h * s, mdr.RIGID if base is None else _elastic(base, t), model)

    return Body(build, model == "exact", True)


def _layered(layers, base, model):
    def build(s, t):
        return mdr.Layered([(_elastic(material, t), h * s) for material, h in layers], _elastic(base, t), model)

    return Body(build, model == "exact", True)


def _graded(moduli, nu, model):
    def build(s, t):
        return mdr.Graded([0.5 * s * i for i in range(len(moduli))], [E * t for E in moduli], nu, model)

    return Body(build, model == "exact", True)


def _power_graded(v):
    return Body(lambda s, t: mdr.PowerLawGraded(v[0] * t, v[1] * s, v[2], v[3]))


def _pair(lower, upper):
    exact, gradient = lower.exact and upper.exact, lower.gradient or upper.gradient
    return Body(lambda s, t: mdr.Pair(lower.build(s, t), upper.build(s, t)), exact, gradient)


def _tabulated(moduli):
    a = np.geomspace(1e-3, 10.0, len(moduli))
    return Body(lambda s, t: mdr.TabulatedMedium(a * s, np.array(moduli) * t))


thicknesses = _between(0.05, 20.0)
FORMULAS = ["gao", "gao-series", "doerner-nix", "wave", "mencik-exponential", "mencik-reciprocal", "bec", "perriot-barthel"]
WEIGHTS = st.sampled_from(["gao", "gao-series"])
homogeneous = materials.map(lambda m: Body(lambda s, t: mdr.Homogeneous(_elastic(m, t)), exact=True))
one_coating = st.builds(_coated, materials, thicknesses, materials, st.sampled_from(FORMULAS))
analytic_formulas = st.one_of(
    one_coating,
    st.builds(_pair, one_coating, st.one_of(homogeneous, one_coating)),
    st.builds(_layered, st.lists(st.tuples(materials, thicknesses), min_size=1, max_size=3), materials, WEIGHTS),
    st.builds(_graded, st.lists(_between(0.1, 10.0), min_size=2, max_size=5), st.floats(0.0, 0.5), WEIGHTS),
)
formulas = st.one_of(analytic_formulas, st.lists(_between(0.5, 2.0), min_size=3, max_size=6).map(_tabulated))
# below -0.3 the pressure at a rim is too singular for the quadrature here
power_graded = st.tuples(_between(0.1, 10.0), lengths, st.floats(-0.3, 0.6), st.floats(0.0, 0.5)).map(_power_graded)
single_exact_layers = st.one_of(
    st.builds(_coated, materials, _between(0.1, 20.0), materials, st.just("exact")),
    st.builds(_coated, materials, _between(0.3, 20.0), st.none(), st.just("exact")),
    st.builds(_layered, st.lists(st.tuples(materials, _between(0.2, 20.0)), min_size=1, max_size=2), materials, st.just("exact")),
)
exact_layers = st.one_of(
    single_exact_layers,
    st.builds(_pair, single_exact_layers, st.one_of(homogeneous, single_exact_layers)),
    st.builds(_pair, single_exact_layers, one_coating),
)
bodies = st.one_of(homogeneous, formulas, power_graded)
few = settings(max_examples=max(12, settings().max_examples // 5))
"""For bodies whose states cost milliseconds."""

units = st.tuples(_between(1e-9, 1e6), _between(1e-6, 1e12))
"""scale, stiffen"""


def _radii(tip, share, n=5):
    """n radii that grow by 5 to 50 per cent each."""
    top = tip.low * (tip.high / tip.low) ** share
    if tip.flat:
        return np.linspace(tip.low, top, n)
    return top * (tip.low / tip.high) ** (0.1 * np.arange(n)[::-1])


shares = st.floats(0.5, 1.0)


def _close(found, expected, relative):
    np.testing.assert_allclose(found, expected, rtol=relative, atol=0.0)


def _contact(tip, body, scale=1.0, stiffen=1.0, **options):
    return mdr.Contact(tip.build(scale), body.build(scale, stiffen), **options)


def _states(tip, body, share):
    contact = _contact(tip, body)
    return contact, contact.at_radius(_radii(tip, share))


def _grows(values):
    assert np.all(np.diff(values) > 0.0), values


def check_growth(tip, body, share):
    """F, a and k are positive and grow with d. The stiffness of a formula need not: E_eff may fall faster than 1/a."""
    contact, state = _states(tip, body, share)
    for values in (state.depth, state.radius, state.force):
        assert np.all(np.asarray(values) > 0.0), values
        _grows(values)
    assert np.all(state.stiffness > 0.0)
    if body.exact:
        _grows(state.stiffness)
    _close(state.stiffness, contact.medium.stiffness(state.radius), 1e-9)
    _close(state.stiffness, 2.0 * state.radius * contact.medium.modulus(state.radius), 1e-9)


def check_directions(tip, body, share):
    """Depth, force and radius lead to the same states."""
    contact, state = _states(tip, body, share)
    for same in (contact.at_depth(state.depth), contact.at_force(state.force)):
        for found, expected in zip(same, state, strict=True):
            _close(found, expected, 1e-8)


def check_scaling(tip, body, share, unit):
    """Lengths times s and moduli times t: depths times s, forces times s^2 t, stiffnesses times s t."""
    scale, stiffen = unit
    small = _contact(tip, body).at_radius(_radii(tip, share))
    large = _contact(tip, body, scale, stiffen).at_radius(_radii(tip, share) * scale)
    _close(large.depth, small.depth * scale, 1e-8)
    _close(large.force, small.force * scale**2 * stiffen, 1e-8)
    _close(large.stiffness, small.stiffness * scale * stiffen, 1e-8)


def check_stiffness(tip, body, share):
    """dF/dd along the curve is k."""
    contact, state = _states(tip, body, share)
    step = 2e-3 * state.depth
    force = [contact.at_depth(state.depth + i * step).force for i in (-2, -1, 1, 2)]
    found = (force[0] - 8.0 * force[1] + 8.0 * force[2] - force[3]) / (12.0 * step)
    # a difference that reaches across a corner of the tip is not one of fourth order
    smooth = np.abs(state.radius / (tip.corner or math.inf) - 1.0) > 0.05
    _close(found[smooth], state.stiffness[smooth], 1e-6)


def check_integrals(tip, body, share):
    """The force is twice the integral of the line load, and the integral of the pressure."""
    contact, state = _states(tip, body, share)
    a, force = float(state.radius[-1]), float(state.force[-1])
    ends = [0.0, math.pi / 2] if tip.corner is None or tip.corner >= a else [0.0, math.asin(tip.corner / a), math.pi / 2]
    # tanh-sinh quadrature: there may be a power at the axis, and corners
    line = surface = 0.0
    for low, high in zip(ends[:-1], ends[1:], strict=True):
        t = np.linspace(-2.8 if low else -3.6, 2.8, 241)
        share = 1.0 / (1.0 + np.exp(-math.pi * np.sinh(t)))
        weight = math.pi * np.cosh(t) * share * (1.0 - share) * (t[1] - t[0])
        angle = low + (high - low) * share
        x = np.minimum(a * np.sin(angle), a)
        line += 2.0 * (high - low) * np.sum(weight * contact.line_load(x, radius=a) * a * np.cos(angle))
        surface += 2.0 * math.pi * (high - low) * np.sum(weight * contact.pressure(x, radius=a) * x * a * np.cos(angle))
    _close(line, force, 1e-6)
    _close(surface, force, 1e-5)


def check_surface(tip, body, share):
    """Under the indenter the surface has its shape; it leaves it without a step; pressure pushes."""
    contact, state = _states(tip, body, share)
    a, d = float(state.radius[-1]), float(state.depth[-1])
    r = a * np.linspace(0.01, 0.99, 9)
    _close(contact.displacement(r, radius=a), d - contact.indenter.height(r), 1e-9)
    outside = contact.displacement(a * np.array([1.0 + 1e-9, 2.0, 5.0]), radius=a)
    assert outside[0] == pytest.approx(d - contact.indenter.height(a), abs=2e-4 * d)
    assert np.all(np.isfinite(outside))
    if not body.exact:
        assert np.all(contact.pressure(r, radius=a) > 0.0)


def check_superposition(first, second, body, share):
    """At a given contact radius depths and forces of a sum of indenters are sums."""
    tip = _sum(first, second)
    assume(tip.low < 0.8 * tip.high)
    a = _radii(tip, share)
    both, one, other = (_contact(t, body).at_radius(a) for t in (tip, first, second))
    _close(both.depth, one.depth + other.depth, 1e-8)
    _close(both.force, one.force + other.force, 1e-8)
    _close(both.stiffness, one.stiffness, 1e-8)


def quick_and_exact(check, before, cheap, after):
    """The test of a property over cheap bodies, and a slow one over layers that are solved exactly; `before` and `after` are its
    other arguments."""
    return given(*before, cheap, *after)(check), pytest.mark.slow(few(given(*before, exact_layers, *after)(check)))


test_growth, test_growth_exact = quick_and_exact(check_growth, [tips], bodies, [shares])
test_directions, test_directions_exact = quick_and_exact(check_directions, [tips], bodies, [shares])
test_scaling, test_scaling_exact = quick_and_exact(check_scaling, [tips], bodies, [shares, units])
test_stiffness_is_the_derivative, test_stiffness_is_the_derivative_exact = quick_and_exact(
    check_stiffness, [tips], bodies, [shares]
)
test_integrals, test_integrals_exact = quick_and_exact(check_integrals, [st.one_of(simple_tips, flat_ended_tips)], bodies, [shares])
test_surface, test_surface_exact = quick_and_exact(check_surface, [tips], st.one_of(homogeneous, formulas), [shares])
test_superposition, test_superposition_exact = quick_and_exact(
    check_superposition, [st.one_of(simple_tips, flat_ended_tips), simple_tips], bodies, [shares]
)
# ---- adhesion ----

endless_tips = st.one_of(
    lengths.map(lambda R: Tip(lambda s: mdr.Paraboloid(R * s))),
    inclinations.map(lambda phi: Tip(lambda s: mdr.Cone(phi))),
    st.tuples(st.floats(1.0, 6.0), lengths).map(lambda v: Tip(lambda s: mdr.PowerLaw(v[0], v[1] * s ** (1.0 - v[0])))),
    st.tuples(flats, inclinations).map(lambda v: Tip(lambda s: mdr.RoundedCone(v[0] * s, v[1]))),
)
spheres = lengths.map(lambda R: Tip(lambda s: mdr.Sphere(R * s), low=min(0.02, 0.1 * R), high=min(3.0, 0.95 * R)))
adhesive_tips = st.one_of(endless_tips, spheres)
works = _between(1e-6, 1e-3)
"""Works of adhesion in units of E_eff at the radius 1."""
rules = st.sampled_from(["automatic", "paper", "energy"])


def _adhesive(tip, body, work, rule, scale=1.0, stiffen=1.0):
    gamma = work * body.build(1.0, 1.0).modulus(1.0) * scale * stiffen
    return _contact(tip, body, scale, stiffen, work_of_adhesion=gamma, adhesion_rule=rule)


def where_the_energy_rule_holds(check):
    """`check`, but for formulas whose stiffness falls somewhere: the energy rule refuses them, and says why."""

    @functools.wraps(check)
    def checked(*arguments, **options):
        try:
            check(*arguments, **options)
        except mdr.NoConvergenceError as problem:
            assume("does not grow with the radius" not in str(problem))
            raise

    return checked


@where_the_energy_rule_holds
def check_adhesive_states(tip, body, work, rule, share, n=5):
    """Adhesion takes k times the depth it takes from the force; depth, force and radius lead to states that are the same."""
    contact, a = _adhesive(tip, body, work, rule), _radii(tip, share, n)
    bare, state = _contact(tip, body).at_radius(a), contact.at_radius(a)
    assert np.all(state.depth < bare.depth) and np.all(state.force < bare.force)
    missing = bare.depth - state.depth
    np.testing.assert_allclose(bare.force - state.force, state.stiffness * missing, rtol=1e-8, atol=1e-9 * np.max(bare.force))
    for branch in ("loading", "unloading"):
        held = contact.at_depth(bare.depth, branch)
        again = contact.at_radius(held.radius)
        _close(again.depth, bare.depth, 1e-7)
        np.testing.assert_allclose(again.force, held.force, rtol=1e-7, atol=1e-9 * np.max(bare.force))
        pressed = contact.at_force(bare.force, branch)
        _close(contact.at_radius(pressed.radius).force, bare.force, 1e-7)
        # under given depth the force may fall, between the two pull-offs
        for grown in (held.radius, pressed.radius, pressed.depth):
            _grows(grown)


@where_the_energy_rule_holds
def check_pull_off(tip, body, work, rule, unit):
    """Nothing hangs on below the pull-off force or depth; both scale."""
    scale, stiffen = unit
    small, large = _adhesive(tip, body, work, rule), _adhesive(tip, body, work, rule, scale, stiffen)
    by_force, by_depth = small.pull_off(), small.pull_off("depth")
    assert by_force.force < 0.0 and by_force.force <= by_depth.force and by_depth.depth <= by_force.depth
    assert small.at_force(by_force.force * (1.0 - 1e-6)).force == pytest.approx(by_force.force, rel=2e-6)
    assert small.at_depth(by_depth.depth + 1e-6 * abs(by_depth.depth)).radius >= by_depth.radius * (1.0 - 1e-6)
    with pytest.raises(mdr.UnreachableError):
        small.at_force(by_force.force * 1.0001)
    with pytest.raises(mdr.UnreachableError):
        small.at_depth(by_depth.depth - 1e-4 * abs(by_depth.depth))
    for control, expected in (("force", by_force), ("depth", by_depth)):
        found = large.pull_off(control)
        np.testing.assert_allclose(found.depth, expected.depth * scale, rtol=1e-7, atol=1e-9 * expected.radius * scale)
        _close(found.force, expected.force * scale**2 * stiffen, 1e-7)
        _close(found.radius, expected.radius * scale, 1e-4)  # at a flat minimum a radius is worth half the digits


@given(adhesive_tips, st.one_of(homogeneous, analytic_formulas), works, rules, shares)
def test_adhesive_states(tip, body, work, rule, share):
    check_adhesive_states(tip, body, work, rule, share)


@pytest.mark.slow
@few
@given(adhesive_tips, exact_layers, works, rules, shares)
def test_adhesive_states_exact(tip, body, work, rule, share):
    check_adhesive_states(tip, body, work, rule, share, n=2)


test_pull_off, test_pull_off_exact = quick_and_exact(
    check_pull_off, [adhesive_tips], st.one_of(homogeneous, analytic_formulas), [works, rules, units]
)


@given(lengths, materials, works)
def test_pull_off_of_johnson_kendall_roberts(radius, material, work):
    contact = mdr.Contact(mdr.Paraboloid(radius), mdr.Homogeneous(_elastic(material, 1.0)), work_of_adhesion=work)
    _close(contact.pull_off("force").force, -1.5 * math.pi * work * radius, 1e-9)
    _close(contact.pull_off("depth").force, -5.0 / 6.0 * math.pi * work * radius, 1e-9)


# ---- media, weights, laws, fits ----


@few
@given(materials, _between(0.1, 20.0), materials, _between(1.01, 10.0), st.sampled_from(["gao", "gao-series", "exact"]))
def test_a_stiffer_film_or_base_makes_a_stiffer_body(film, h, base, factor, model):
    a = np.geomspace(0.1, 5.0, 5)
    body = _coated(film, h, base, model).build(1.0, 1.0).modulus(a)
    assert np.all(_coated((film[0] * factor, film[1]), h, base, model).build(1.0, 1.0).modulus(a) > body)
    assert np.all(_coated(film, h, (base[0] * factor, base[1]), model).build(1.0, 1.0).modulus(a) > body)


@given(st.lists(_between(1e-6, 1e6), min_size=2, max_size=20, unique=True), st.floats(-0.99, 0.5))
def test_weights(xi, nu):
    xi = np.array(sorted(xi))
    for above, below in ((mdr.weight_i0(xi, nu), mdr.weight_j0(xi, nu)), (mdr.weight_i1(xi), mdr.weight_j1(xi))):
        np.testing.assert_allclose(above + below, 1.0, rtol=4e-16)
        assert np.all((below > 0.0) & (below <= 1.0) & (np.diff(below, prepend=1.0) <= 0.0))
    assert np.all(mdr.weight_phi(xi, nu) > 0.0)


@few
@given(endless_tips, st.one_of(homogeneous, analytic_formulas), st.one_of(st.just(0.0), works), shares)
def test_a_law_keeps_its_tolerance(tip, body, work, share):
    bare = _contact(tip, body).at_radius(_radii(tip, share))
    contact = _adhesive(tip, body, work, "automatic")
    law = mdr.ContactLaw(contact, float(bare.depth[-1]), tolerance=1e-6)
    depth = bare.depth[bare.depth >= 1e-4 * bare.depth[-1]]  # where the tolerance begins to hold
    expected, found = contact.at_depth(depth), law.at_depth(depth)
    error = np.abs(found.force - expected.force)
    assert np.all(error <= 2e-6 * (np.abs(expected.force) + np.abs(depth * found.slope)))
    _close(found.radius, expected.radius, 2e-6)


@few
@given(materials, thicknesses, materials, st.sampled_from(["gao-series", "hay-crawford", "perriot-barthel"]), _between(0.5, 2.0))
def test_a_fit_finds_the_modulus_that_made_the_data(film, h, base, model, guess):
    d = np.linspace(0.01, 0.2, 15) * h
    force = mdr.Contact(mdr.Paraboloid(h), _coated(film, h, base, model).build(1.0, 1.0)).at_depth(d).force
    start = mdr.Coated(_elastic(film, guess), h, _elastic(base, 1.0), model)
    result = mdr.fit(mdr.ForceDepth(d, force, relative_sd=0.01), mdr.Paraboloid(h), start, ["coating.E"])
    _close(result.estimates["coating.E"], film[0], 1e-6)
