# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion with a range: its balance of energy, its limits, its loops, and what it refuses."""

import math
import pickle
import subprocess
import sys
import warnings
from itertools import pairwise

import numpy as np
import pytest
from conftest import numbers_of
from numpy.polynomial.legendre import leggauss
from scipy.integrate import quad

import mdrcontact as mdr
import mdrcontact.instruments as mdi

NODES, WEIGHTS = leggauss(40)
PARABOLOID, CONE = mdr.Paraboloid(1.0), mdr.Cone(math.pi / 4)
HALF_SPACE = mdr.Homogeneous(mdr.Elastic(0.75, 0.0))
FILM = mdr.Coated(mdr.Elastic(2.6, 0.3), 1.0, mdr.Elastic(26.0, 0.3), model="exact")
PAIR = mdr.Pair(FILM, mdr.Homogeneous(mdr.Elastic(3.0, 0.2)))
BODIES = {"half-space": HALF_SPACE, "film": FILM, "pair": PAIR}
"""Fractions of the contact radius at which derivatives are taken, and their weights."""
STEPS = np.array([-2.0, -1.0, 1.0, 2.0]) * 2e-3
DIFFERENCES = np.array([1.0, -8.0, 8.0, -1.0])

pytestmark = pytest.mark.filterwarnings("ignore::mdrcontact.errors.LargeStrainWarning")


def integral(function, low, high):
    """int over r of 2 pi r f(r), whose slope may be a root at both ends."""
    y = 0.5 * (NODES + 1.0)
    r = low + (high - low) * y**2 * (3.0 - 2.0 * y)
    return float(np.sum(2.0 * np.pi * r * function(r) * (high - low) * 3.0 * y * (1.0 - y) * WEIGHTS))


def total_energy(contact, state):
    """Elastic energy, and that of the surfaces: -gamma where they touch, sigma h - gamma where they pull."""
    gamma, sigma = contact.work_of_adhesion, contact.cohesive_stress

    def of_gap(r):
        return sigma * (state.displacement(r) - state.depth + contact.indenter.height(r)) - gamma

    zone = integral(of_gap, state.radius, state.zone_radius)
    return state.energy() + zone - math.pi * state.radius**2 * gamma


@pytest.mark.parametrize("body", [HALF_SPACE, FILM], ids=["half-space", "film"])
@pytest.mark.parametrize("tip", [PARABOLOID, CONE], ids=["paraboloid", "cone"])
@pytest.mark.parametrize("stress", [0.3, 3.0])
def test_force_is_the_slope_of_the_energy(tip, body, stress):
    """F = dU/dd along the branch: with the energy of the gap in the zone, which the solution does not use."""
    contact = mdr.Contact(tip, body, work_of_adhesion=0.5, cohesive_stress=stress)
    for radius in (0.4, 1.1):
        states = [contact.at_radius(radius * (1.0 + step)) for step in STEPS]
        slope = DIFFERENCES @ [total_energy(contact, s) for s in states] / (DIFFERENCES @ [s.depth for s in states])
        assert slope == pytest.approx(contact.at_radius(radius).force, rel=1e-8, abs=1e-8)


@pytest.mark.parametrize("stress", [0.3, 30.0])
@pytest.mark.parametrize("radius", [0.29, 0.2999999, 0.3, 0.300000001, 0.300001, 0.31, 0.6])
def test_states_beside_the_edge_of_a_flat_end(radius, stress):
    """The zone's gap, the edge and the force on a half-space by adaptive quadrature over x = c cos(theta), split at the edge."""
    modulus, end = HALF_SPACE.material.contact_modulus, 0.3
    contact = mdr.Contact(mdr.FlatEndedParaboloid(end, 1.0), HALF_SPACE, work_of_adhesion=0.5, cohesive_stress=stress)
    state = contact.at_radius(radius)
    a, c = radius, state.zone_radius

    def height(x):
        return x * math.sqrt(max((x - end) * (x + end), 0.0))

    def across(function):
        ends = [0.0, *([math.acos(end / c)] if a < end < c else []), math.acos(a / c)]
        return sum(quad(function, *pair, epsabs=1e-14, epsrel=1e-10, limit=200)[0] for pair in pairwise(ends))

    edge = -2.0 * stress / modulus * math.sqrt((c - a) * (c + a))
    assert state.depth == pytest.approx(height(a) + edge, rel=1e-11)
    gap = across(lambda t: -2.0 * stress / modulus * c * math.sin(t) - state.depth + height(c * math.cos(t)))
    assert 2.0 / math.pi * gap == pytest.approx(0.5 / stress, rel=1e-9)
    inside = quad(lambda x: modulus * (state.depth - height(x)), min(a, end), a, epsrel=1e-11)[0] if a > end else 0.0
    inside += modulus * state.depth * min(a, end)
    zone = across(lambda t: (c * math.sin(t)) ** 2)
    assert state.force == pytest.approx(2.0 * inside - 4.0 * stress * zone, rel=1e-9)


def test_zones_that_end_beside_the_edge_of_a_flat_end():
    """The gap at c in closed form: the work of adhesion with which the zone ends at c gives a zone that ends there."""
    modulus, end, radius = HALF_SPACE.material.contact_modulus, 0.3, 1.0
    random = np.random.default_rng(12)
    for _ in range(200):
        a, c = end * random.uniform(0.0, 1.0) ** 0.5, end * (1.0 + 10.0 ** random.uniform(-12.0, 0.5))
        stress = 10.0 ** random.uniform(-2.0, 1.0)
        pull = 2.0 * stress / modulus
        gap = 2.0 / math.pi * pull * (math.sqrt((c - a) * (c + a)) * math.acos(a / c) - (c - a)) + (c - end) * (c + end) / (
            2.0 * radius
        )
        contact = mdr.Contact(
            mdr.FlatEndedParaboloid(end, radius), HALF_SPACE, work_of_adhesion=stress * gap, cohesive_stress=stress
        )
        state = contact.at_radius(a)
        assert state.zone_radius == pytest.approx(c, rel=1e-9)
        assert state.depth == pytest.approx(-pull * math.sqrt((c - a) * (c + a)), rel=1e-9)


def test_attraction_at_a_distance_beside_the_edge_of_a_flat_end():
    """Without contact d = f(c) - 4 sigma c/(pi E*) - gamma/sigma, F = -pi sigma c^2."""
    modulus, end, radius, work, stress = HALF_SPACE.material.contact_modulus, 0.3, 1.0, 0.5, 0.05
    contact = mdr.Contact(mdr.FlatEndedParaboloid(end, radius), HALF_SPACE, work_of_adhesion=work, cohesive_stress=stress)
    c = end * (1.0 + 10.0 ** np.random.default_rng(13).uniform(-9.0, 0.5, 60))
    state = contact.at_depth((c - end) * (c + end) / (2.0 * radius) - 4.0 * stress * c / (math.pi * modulus) - work / stress)
    assert state.radius == pytest.approx(0.0)
    assert state.zone_radius == pytest.approx(c, rel=1e-11)
    assert state.force == pytest.approx(-math.pi * stress * c**2, rel=1e-11)
    assert contact.pull_off("depth").depth == pytest.approx(-4.0 * stress * end / (math.pi * modulus) - work / stress, rel=1e-11)


@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
@pytest.mark.parametrize("tip", [PARABOLOID, CONE, mdr.FlatEndedParaboloid(0.3, 1.0)], ids=["paraboloid", "cone", "flat end"])
def test_pressure_bears_the_force_and_the_gap_closes(tip, body):
    contact = mdr.Contact(tip, body, work_of_adhesion=0.5, cohesive_stress=0.8)
    for radius in (0.5, 1.2):
        state = contact.at_radius(radius)
        c = state.zone_radius

        def pressure(r, state=state):
            return state.pressure(r)

        corners = [0.0, 0.3, radius, c] if tip not in (PARABOLOID, CONE) else [0.0, radius, c]
        borne = sum(integral(pressure, low, high) for low, high in zip(corners[:-1], corners[1:], strict=True))
        # the pressure has a sharp corner at the rim of a flat end
        assert borne == pytest.approx(state.force, rel=1e-8 if tip in (PARABOLOID, CONE) else 1e-6)
        assert state.pressure([radius, 0.5 * (radius + c), c]) == pytest.approx([-0.8] * 3, rel=1e-13)
        r = radius + (c - radius) * np.array([1e-3, 0.2, 0.5, 0.8, 1.0, 1.5, 4.0])
        gap = state.displacement(r) - state.depth + tip.height(r)
        assert np.all(np.diff(gap) > 0.0) and gap[0] > 0.0
        assert gap[4] == pytest.approx(0.5 / 0.8, rel=1e-9)
        if body is not PAIR:
            x = np.linspace(0.0, c, 9)
            assert state.line_load(x)[-1] == 0.0


@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
def test_jkr_is_the_limit_of_a_large_stress(body):
    """What the range changes falls with the square of the stress."""
    jkr = mdr.Contact(PARABOLOID, body, work_of_adhesion=0.5).at_radius(1.0)
    stresses = np.array([30.0, 100.0, 300.0, 1000.0])
    states = [mdr.Contact(PARABOLOID, body, work_of_adhesion=0.5, cohesive_stress=s).at_radius(1.0) for s in stresses]
    scaled = np.array([s.depth - jkr.depth for s in states]) * stresses**2
    assert scaled == pytest.approx(np.full(4, scaled[-1]), rel=2e-2)
    assert scaled[2:] == pytest.approx(np.full(2, scaled[-1]), rel=2e-4)
    forces = np.array([s.force - jkr.force for s in states]) * stresses**2
    assert forces[2:] == pytest.approx(np.full(2, forces[-1]), rel=2e-4)


@pytest.mark.parametrize("body", [HALF_SPACE, FILM], ids=["half-space", "film"])
@pytest.mark.parametrize("stress", [0.1, 0.5, 5.0])
@pytest.mark.parametrize("control", ["depth", "spring"])
def test_loop_loses_what_the_jumps_lose(body, stress, control):
    """The area of a loop is the energy that disappears in its jumps."""
    contact = mdr.Contact(PARABOLOID, body, work_of_adhesion=0.5, cohesive_stress=stress)
    spring = {"spring_stiffness": 3.0} if control == "spring" else {}
    loop = contact.loop(control, 0.5, 60, **spring)

    def energy(i):
        d, a, force = loop.depth[i], loop.radius[i], loop.force[i]
        stored = 0.5 * force**2 / 3.0 if spring else 0.0
        if force == 0.0 and a == 0.0:
            return stored
        if a > 0.0:
            return stored + total_energy(contact, contact.at_radius(a))
        zone = math.sqrt(-force / (math.pi * stress))
        return stored + total_energy(contact, mdr.State(d, 0.0, force, 0.0, d, zone, contact))

    lost = sum(energy(i) - energy(i + 1) for i in loop.jumps)
    assert loop.dissipated_energy == pytest.approx(lost, rel=1e-6, abs=1e-7)
    assert loop.position[loop.jumps[0]] == pytest.approx(-0.5 / stress, rel=1e-12)


def test_bodies_attract_each_other_before_they_touch():
    """From a gap of the range on: on a body so compliant that it jumps, else at once and smoothly."""
    contact = mdr.Contact(PARABOLOID, HALF_SPACE, work_of_adhesion=0.5, cohesive_stress=0.05)
    first = contact.at_depth(-0.5 / 0.05, branch="loading")
    assert first.radius == 0.0 and first.force < 0.0
    touch = contact.at_radius(0.0)
    assert touch.zone_radius > first.zone_radius
    assert touch.force == pytest.approx(-math.pi * 0.05 * touch.zone_radius**2, rel=1e-13)
    gaps = first.displacement([0.0, 0.5 * first.zone_radius, first.zone_radius])
    gaps = gaps - first.depth + PARABOLOID.height(np.array([0.0, 0.5, 1.0]) * first.zone_radius)
    assert np.all(np.diff(gaps) > 0.0) and gaps[-1] == pytest.approx(0.5 / 0.05, rel=1e-9)
    with pytest.raises(mdr.errors.UnreachableError, match="attract each other from depth = -10 on"):
        contact.at_depth(-10.001, branch="loading")
    sharp = mdr.Contact(mdr.Cone(0.2), HALF_SPACE, work_of_adhesion=0.5, cohesive_stress=0.05)
    assert sharp.at_depth(-10.0 + 1e-6, branch="loading").zone_radius < 1e-5
    assert sharp.pull_off("depth").depth == pytest.approx(-10.0, rel=1e-12)


@pytest.mark.parametrize("control", ["force", "depth"])
def test_inversion_gives_the_state_back(control):
    for body in BODIES.values():
        contact = mdr.Contact(PARABOLOID, body, work_of_adhesion=0.5, cohesive_stress=0.7)
        for radius in (2.0, 3.0, 40.0):
            state = contact.at_radius(radius)
            back = contact.at_force(state.force) if control == "force" else contact.at_depth(state.depth)
            assert numbers_of(back) == pytest.approx(numbers_of(state), rel=1e-9)


def test_refusals():
    with pytest.raises(mdr.errors.InvalidArgumentError, match="cohesive_stress"):
        mdr.Contact(PARABOLOID, FILM, work_of_adhesion=0.5, cohesive_stress=-1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="it needs a work_of_adhesion"):
        mdr.Contact(PARABOLOID, FILM, cohesive_stress=1.0)
    for model in ("gao", "perriot-barthel"):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="an effective modulus has no equation"):
            mdr.Contact(PARABOLOID, FILM.with_model(model), work_of_adhesion=0.5, cohesive_stress=1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="vertical wall"):
        mdr.Contact(mdr.FlatPunch(1.0), FILM, work_of_adhesion=0.5, cohesive_stress=1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="paper"):
        mdr.Contact(PARABOLOID, FILM, 0.5, "paper", cohesive_stress=1.0)
    with pytest.raises(mdr.errors.DomainError, match="larger cohesive_stress"):
        mdr.Contact(mdr.Sphere(1.0), HALF_SPACE, work_of_adhesion=0.5, cohesive_stress=0.02)
    contact = mdr.Contact(PARABOLOID, FILM, work_of_adhesion=0.5, cohesive_stress=1.0)
    state = contact.at_radius(1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="cohesive_stress"):
        state.interior(0.0, 0.5)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="zone_radius"):
        state.replace(zone_radius=0.0).pressure(0.5)
    with pytest.raises(mdr.errors.DomainError, match="at most"):
        state.pressure(1.1 * state.zone_radius)


def test_a_zone_too_short_is_none_and_says_so():
    jkr = mdr.Contact(PARABOLOID, FILM, work_of_adhesion=0.5)
    with pytest.warns(mdr.errors.ShortZoneWarning, match="JKR limit"):
        state = mdr.Contact(PARABOLOID, FILM, work_of_adhesion=0.5, cohesive_stress=1e7).at_depth(0.5)
    assert numbers_of(state) == numbers_of(jkr.at_depth(0.5))
    with warnings.catch_warnings():
        warnings.simplefilter("error", mdr.errors.ShortZoneWarning)
        near = mdr.Contact(PARABOLOID, FILM, work_of_adhesion=0.5, cohesive_stress=1e5).at_depth(0.5)
    assert near.force == pytest.approx(jkr.at_depth(0.5).force, rel=1e-8)


def test_pickles_and_problem_files(tmp_path):
    contact = mdr.Contact(PARABOLOID, FILM, work_of_adhesion=0.5, cohesive_stress=1.0)
    again = pickle.loads(pickle.dumps(contact))
    assert again == contact and again.at_radius(1.0) == contact.at_radius(1.0)
    assert "cohesive_stress=1.0" in repr(contact)


def test_fits_find_the_stress():
    """Modulus, work of adhesion and cohesive stress from one retraction, on a half-space and on a film."""
    rng = np.random.default_rng(1)
    tip, rubber = mdr.Paraboloid(2e-6), mdr.Elastic(2e6, 0.5)
    film = mdr.Coated(rubber, 1e-6, mdr.Elastic(70e9, 0.23), model="exact")
    for body, modulus in ((mdr.Homogeneous(rubber), "E"), (film, "coating.E")):
        contact = mdr.Contact(tip, body, work_of_adhesion=0.05, cohesive_stress=0.3e6)
        depth = np.linspace(-250e-9, 200e-9, 80)
        end = contact.pull_off("depth").depth
        force = np.array([contact.at_depth(d).force if d > end else 0.0 for d in depth])
        instrument = mdi.Instrument(work_of_adhesion=0.045, cohesive_stress=0.25e6)
        for noise, accuracy in ((0.0, 1e-6), (0.005, 0.15)):
            data = mdi.ForceDepth(depth, force + rng.normal(0.0, noise * force.max(), depth.size), branch="unloading")
            result = mdi.fit(data, tip, body, [modulus, "work_of_adhesion", "cohesive_stress"], instrument=instrument)
            assert result.values[modulus] == pytest.approx(2e6, rel=accuracy)
            assert result.values["work_of_adhesion"] == pytest.approx(0.05, rel=accuracy)
            assert result.values["cohesive_stress"] == pytest.approx(0.3e6, rel=2 * accuracy)


@pytest.mark.parametrize("seed", range(3))
def test_fits_end_at_one_minimum(seed):
    """From bodies that let go too early, which must say that they should do so later, and from where one search ends elsewhere."""
    rng = np.random.default_rng(seed)
    tip, size = mdr.Paraboloid(2e-6), 2e-9
    contact = mdr.Contact(tip, mdr.Homogeneous(mdr.Elastic(2e6, 0.5)), work_of_adhesion=0.05, cohesive_stress=0.3e6)
    depth = np.linspace(contact.pull_off("depth").depth + 2e-9, 200e-9, 160)
    data = mdi.ForceDepth(depth, contact.at_depth(depth).force + rng.normal(0.0, size, depth.size), branch="unloading")
    found = [
        mdi.fit(data, tip, mdr.Homogeneous(mdr.Elastic(E, 0.5)), ["E", "work_of_adhesion", "cohesive_stress"], instrument=start)
        for E, start in (
            (2e6, mdi.Instrument(work_of_adhesion=0.05, cohesive_stress=0.3e6)),
            (1.5e6, mdi.Instrument(work_of_adhesion=0.04, cohesive_stress=0.2e6)),
            (1.5e6, mdi.Instrument(work_of_adhesion=0.06, cohesive_stress=0.39e6)),
            (2.6e6, mdi.Instrument(work_of_adhesion=0.035, cohesive_stress=0.6e6)),
            (2e6, mdi.Instrument(work_of_adhesion=0.05, cohesive_stress=1.5e6)),
        )
    ]
    for other in found[1:]:
        assert other.values == pytest.approx(found[0].values, rel=1e-4)


def test_the_stress_in_problem_files_and_on_the_command_line(tmp_path):
    """The key is read in its unit, and the command prints how far adhesion reaches."""

    def run(*words):
        command = [sys.executable, "-m", "mdrcontact", *words]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    problem = tmp_path / "problem.toml"
    problem.write_text(run("example", "afm_on_pdms").replace("[adhesion]", '[adhesion]\ncohesive_stress = "0.4 MPa"'))
    said = run("adhesion", str(problem))
    assert "cohesive stress: 400 kPa, up to a gap of 125 nm" in said
    assert "on approach                -0.125  0 to" in said
