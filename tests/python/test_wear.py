# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear from Python: limits, tracks, histories, fits."""

import contextlib
import copy
import csv
import math
import pickle
import time

import numpy as np
import pytest
from conftest import ROOT
from scipy import optimize

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.wear import Wear, WornProfile, wear_coefficient_from_scar, wear_coefficient_from_volume

BALL = mdr.Paraboloid(1.0)
SOFT, HARD = mdr.Elastic(0.091, 0.3), mdr.Elastic(0.91, 0.3)
HERTZ = mdr.Contact(BALL, mdr.Homogeneous(HARD))
COATED = mdr.Contact(BALL, mdr.Coated(HARD, 1.0, SOFT))

LINES = (ROOT / "tests" / "data" / "wear.csv").read_text(encoding="utf-8").splitlines()
ROWS = list(csv.DictReader(line for line in LINES if not line.startswith("#")))


@pytest.mark.slow
@pytest.mark.parametrize("case", sorted({row["case"] for row in ROWS if row["case"].startswith("self")}))
def test_self_similar(case):
    """f = r^n pushed in as s^n: an exact solution with an edge that moves, which the marching knows nothing of; 3e-4 with 80
    intervals and parts of 1 %, in which d or F is led evenly."""
    n, v = int(case.split("n=")[1][0]), float(case.split("V=")[1])
    known = {row["quantity"]: float(row["value"]) for row in ROWS if row["case"] == case}
    tip = {1: mdr.Cone(np.pi / 4.0), 2: mdr.Paraboloid(0.5), 3: mdr.PowerLaw(3.0, 1.0)}[n]
    s = np.geomspace(1e-2, 1.0, 400)
    given, value = ("depth", known["delta"] * s**n) if "delta" in known else ("force", known["phi"] * s ** (n + 1))
    history = Wear(mdr.Contact(tip, HERTZ.medium), 1.0).history(**{given: value[0]})
    history.advance(np.diff(s, prepend=0.0), **{given: value})
    now = history.state
    found = {
        "delta": now.depth,
        "phi": now.force,
        "f(0)": now.worn_depth,
        "f(a/2)": history.profile.height(0.5 * v) + now.worn_depth,
        "lambda": np.arctan(2.0 * v) / np.pi,
    }
    assert now.radius == pytest.approx(v, rel=3e-4)
    for name, value in known.items():
        assert found[name] == pytest.approx(value, rel=3e-4), name


def late_radius(body, force, sliding):
    """Of a uniform pressure under the unworn paraboloid that has worn k F s = V(a); its free surface by a flat punch that has run
    in, which is worn to it."""
    low, high = 1.0, 4.0
    for _ in range(16):
        a = 0.5 * (low + high)
        punch = Wear(mdr.Contact(mdr.FlatPunch(a), body), 1.0)
        history = punch.history(force=force, intervals=40, scheme="rings")
        history.advance(25.0 * punch.running_in_length(), force=force)
        # worn to d - u
        r = a * np.sqrt((np.arange(400) + 0.5) / 400)
        worn = np.asarray(history.profile.worn_depth(r)) - history.profile.worn_depth(a)
        lost = 0.5 * a**2 + worn - 0.5 * r**2
        low, high = (a, high) if np.pi * a**2 * np.mean(lost) < sliding * force else (low, a)
    return a


@pytest.mark.slow
@pytest.mark.parametrize(("substrate", "force"), [(SOFT, 0.792316748517), (mdr.Elastic(9.1, 0.3), 1.62583672745)])
def test_the_late_law_on_films(substrate, force):
    """0.3 and 0.07 % at k E0* s = 10 h, the error of theory/wear.md (4.2)."""
    body = mdr.Coated(HARD, 1.0, substrate)
    states, _ = Wear(mdr.Contact(BALL, body), 1.0).advance(10.0, force=force)
    assert late_radius(body, force, 10.0) == pytest.approx(states.radius, rel=4e-3)


@pytest.mark.parametrize("contact", [HERTZ, COATED])
def test_limit(contact):
    state = contact.at_radius(1.0)
    end = Wear(contact, 0.1).limit(state, 0.5)
    inner = contact.at_radius(0.5)
    assert end.state.force == pytest.approx(inner.force + inner.stiffness * (state.depth - inner.depth), rel=1e-13)
    again = mdr.Contact(end.profile, contact.medium).at_depth(state.depth * 0.99)
    assert again.radius == pytest.approx(0.5, rel=2e-3)
    assert pickle.loads(pickle.dumps(end.profile)).height(0.8) == end.profile.height(0.8)
    r = np.linspace(0.0, 2.0, 9)
    worn = end.profile.worn_depth(r)
    assert np.all(worn[(r > 0.5) & (r < end.outer_radius)] > 0.0)
    np.testing.assert_allclose(worn[(r <= 0.5) | (r > end.outer_radius)], 0.0, atol=1e-12)
    held = Wear(contact, 0.1).limit(state, 0.5, constant="force")
    assert held.state.force == pytest.approx(state.force, rel=1e-13)


R = np.r_[0.0, np.cumsum(0.03 + 0.02 * np.sin(np.arange(60.0)))]
TIPS = {
    "ball": mdr.Paraboloid(1.0),
    "sphere": mdr.Sphere(1.0),
    "cone": mdr.Cone(0.3),
    "power": mdr.PowerLaw(3.0, 1.0),
    "table": mdr.TabulatedProfile(R, R**2 * (0.5 + 0.1 * R)),
    "corner": mdr.CallableProfile(lambda r: 0.5 * r**2 + 0.5 * max(0.0, r - 0.3), 1.5),
    "flat": mdr.FlatEndedParaboloid(0.1, 1.0),
    "rounded": mdr.RoundedCone(0.35, 0.3),
}
BODIES = {
    "homogeneous": mdr.Homogeneous(HARD),
    "coated": mdr.Coated(HARD, 0.5, SOFT),
    "sliding": mdr.Layered([mdr.Layer(SOFT, 0.2, prestress=0.005, interface=mdr.SLIDING)], HARD),
}


KINKS = {"table": R[1:], "corner": [0.3], "flat": [0.1], "rounded": [0.35]}
"""Radii at which the profiles are not analytic."""
PARTS = np.r_[0.0, 0.2 ** np.arange(9.0, 0.0, -1.0)]


def free_height(tip, d, c, r, breaks):
    """d - (2/pi) int_0^c (d - g)/sqrt(r^2 - x^2) dx, x = r sin(t), by Gauss and Legendre between breaks of g."""
    nodes, weights = np.polynomial.legendre.leggauss(30)
    places = []
    for radius in r:
        ends = np.array([0.0, *np.arcsin(breaks / radius), math.atan2(c, math.sqrt((radius - c) * (radius + c)))])
        # shorter towards the axis and kinks, from which g may rise as any power
        ends = np.append(np.add.outer(ends[:-1], 0.0 * PARTS) + np.outer(np.diff(ends), PARTS), ends[-1])
        t = 0.5 * np.add.outer(ends[1:] + ends[:-1], 0.0 * nodes) + 0.5 * np.outer(np.diff(ends), nodes)
        inner = d - tip.mdr(np.minimum(radius * np.sin(t), c))
        places.append(np.sum(0.5 * np.diff(ends)[:, None] * weights * inner))
    return d - 2.0 / np.pi * np.array(places)


def between(c, b):
    """Radii from beside the disc that sticks to the rim, where no table has its nodes."""
    r = np.r_[c * (1.0 + np.geomspace(1e-15, 1e-2, 40)), c + (b - c) * np.linspace(0.005, 0.9999, 60)]
    return r[(r > c) & (r < b)]


@pytest.mark.parametrize("name", TIPS)
def test_the_worn_profile_is_the_free_surface_everywhere(name):
    """1e-9 of the depth, within rounding of the disc that sticks too; its slope against differences, the worn volume against the
    integral of the profile."""
    tip = TIPS[name]
    contact = mdr.Contact(tip, BODIES["homogeneous"])
    state, kinks = contact.at_radius(0.42), np.array(KINKS.get(name, []))
    nodes, weights = np.polynomial.legendre.leggauss(20)
    for c in (0.15, 0.3):
        end = Wear(contact, 1.0).limit(state, c)
        b, worn = end.outer_radius, end.profile
        r = between(c, b)
        wanted = free_height(tip, end.state.depth, c, r, kinks[kinks < c])
        assert np.abs(worn.height(r) - wanted).max() < 1e-9 * state.depth
        assert worn.worn_depth(r) == pytest.approx(wanted - tip.height(r), abs=1e-9 * state.depth)
        r, step = r[50:-1], 1e-6 * (b - c)
        differences = (worn.height(r + step) - worn.height(r - step)) / (2.0 * step)
        assert worn.slope(r) == pytest.approx(differences, rel=1e-7, abs=1e-8)
        # the volume in the root of the distance from the disc
        ends = np.sqrt(np.r_[0.0, kinks[(kinks > c) & (kinks < b)] - c, b - c] / (b - c))
        t = 0.5 * np.add.outer(ends[1:] + ends[:-1], 0.0 * nodes) + 0.5 * np.outer(np.diff(ends), nodes)
        r = c + (b - c) * t**2
        each = 0.5 * np.diff(ends)[:, None] * weights * 4.0 * np.pi * t * r * worn.worn_depth(r)
        assert end.worn_volume == pytest.approx((b - c) * np.sum(each), rel=1e-9)


@pytest.mark.parametrize("name", TIPS)
@pytest.mark.parametrize("body", ["coated", "sliding"])
def test_the_worn_profile_on_layers_is_the_surface_beside_the_disc(name, body):
    """Against the displacement of the limit state, which itself loses digits within 1e-13 of the disc."""
    contact = mdr.Contact(TIPS[name], BODIES[body])
    state = contact.at_radius(0.42)
    end = Wear(contact, 1.0).limit(state, 0.3)
    r = between(0.3, end.outer_radius)
    r = r[r > 0.3 * (1.0 + 1e-13)]
    surface = end.state.depth - end.state.displacement(r)
    assert np.abs(end.profile.height(r) - surface).max() < 1e-9 * state.depth


def test_the_worn_depth_of_an_indenter_that_ends_soon():
    """Where nothing is worn lies at the edge, and need not be sought at twice its radius."""
    wear = Wear(mdr.Contact(mdr.Sphere(1.0), BODIES["homogeneous"]), 1.0)
    end = wear.limit(wear.contact.at_radius(0.6), 0.4)
    assert 0.5 < end.outer_radius < 1.0
    assert end.profile.worn_depth(0.3) == 0.0
    assert end.profile.worn_depth(0.5) == pytest.approx(end.profile.height(0.5) - mdr.Sphere(1.0).height(0.5), abs=1e-16)
    history = wear.history(depth=0.4, intervals=16)
    history.advance(0.01, depth=0.4)
    assert history.profile.worn_depth(0.0) == pytest.approx(history.state.worn_depth, rel=1e-12)


def test_a_worn_profile_with_a_nearby_axis():
    """A disc that hardly sticks: what is singular at the axis is near, the panels of the surface are short there."""
    state = HERTZ.at_radius(0.4)
    for c in (1e-2, 1e-4, 1e-6):
        end = Wear(HERTZ, 1.0).limit(state, c)
        r = np.r_[c * (1.0 + np.geomspace(1e-15, 1e3, 60)), between(c, end.outer_radius)]
        r = r[(r > c) & (r < end.outer_radius)]
        root = np.sqrt((r - c) * (r + c))
        wanted = 2.0 / np.pi * (0.5 * r**2 * np.arctan2(c, root) - 0.5 * c * root + state.depth * np.arctan2(root, c))
        assert np.abs(end.profile.height(r) - wanted).max() < 1e-11 * state.depth


@pytest.mark.parametrize("contact", [HERTZ, COATED])
def test_track_is_the_line_load(contact):
    state = contact.at_radius(1.0)
    wear = Wear(contact, 0.1, body_coefficient=1e-6)
    y = np.linspace(0.0, 1.0, 7)
    np.testing.assert_allclose(wear.track(y, state, 1000.0), 1e-3 * state.line_load(y), rtol=1e-12, atol=1e-18)
    passes = wear.passes_through(state, 0.01)
    assert wear.track(0.0, state, passes) == pytest.approx(0.01, rel=1e-13)
    with pytest.raises(mdr.errors.DomainError, match="too deep"):
        wear.track(0.0, state, 100.0 * passes)


@pytest.mark.parametrize("contact", [HERTZ, COATED])
def test_history_goes_on_from_where_it_was(contact):
    history = Wear(contact, 1.0).history(force=0.5, intervals=40)
    history.advance([0.1, 0.2], force=0.5)
    others = [copy.deepcopy(history), pickle.loads(pickle.dumps(history)), history.copy()]
    state = history.advance(0.3, force=[0.6])
    for other in others:
        assert other.advance(0.3, force=[0.6]).radius == state.radius
        assert np.array_equal(other.saved(), history.saved())
    profile = history.profile
    assert pickle.loads(pickle.dumps(profile)) == profile
    again = mdr.Contact(profile, contact.medium).at_depth(history.state.depth - history.state.worn_depth)
    assert again.force == pytest.approx(0.6, rel=3e-4)
    r = np.linspace(0.0, 2.0, 5)
    np.testing.assert_allclose(profile.worn_depth(0.0), history.state.worn_depth, rtol=1e-12)
    assert np.all(profile.worn_depth(r) > -1e-12) and history.pressure(2.0) == 0.0


END = mdr.FlatEndedCone


@pytest.mark.parametrize(
    ("tip", "film", "wear", "given", "path"),
    [
        # the coarser rings take the whole step under the small force at its end
        (BALL, None, (1.0,), {"force": 1.0, "scheme": "rings"}, [(1e-3, {"force": 0.03})]),
        (mdr.Cone(0.52), None, (1.0,), {"force": 0.7, "scheme": "rings"}, [(1e-3, {"force": 0.04})]),
        # hats overshoot where the pressure jumps: at the edge of a flat end, and at the end of a coating
        (END(0.7348, 0.8763), 2.9, (1.0,), {"force": 0.044}, [(2.28e-4, {"force": 0.104})]),
        (END(0.8151, 1.2992), 0.387, (1.0, 3.0), {"force": 0.192}, [(0.1, {"force": 0.0476})]),
    ],
)
def test_what_a_history_saves_is_its_past(tip, film, wear, given, path):
    """Whatever the load and the shape: errors of coarse schemes are no sign of altered numbers."""
    medium = HERTZ.medium if film is None else mdr.Coated(mdr.Elastic(film, 0.3), 0.5, mdr.Elastic(1.0, 0.3))
    history = Wear(mdr.Contact(tip, medium), wear, (1e-2,) * (len(wear) - 1)).history(intervals=16, **given)
    for sliding, target in path:
        history.advance(sliding, **target)
        assert np.array_equal(history.restored(history.saved()).saved(), history.saved())


@pytest.mark.parametrize("scheme", ["disc", "rings"])
def test_random_histories_are_restored(scheme):
    """Shapes, coatings of contrast 1e-2 to 1e2, forces and distances over several decades, with a fixed seed."""
    draw = np.random.default_rng(57)
    restored = 0
    for i in range(60):
        size = 10.0 ** draw.uniform(-1.0, 1.0)
        shapes = [BALL, mdr.Sphere(size), mdr.Cone(draw.uniform(0.05, 1.2)), mdr.PowerLaw(draw.choice([1.5, 3.0, 6.0]), 1.0),
                  END(size, draw.uniform(0.1, 1.4)), mdr.FlatEndedParaboloid(1.0, size), mdr.FlatPunch(size)]  # fmt: skip
        film, thickness = mdr.Elastic(10.0 ** draw.uniform(-2.0, 2.0), 0.3), 10.0 ** draw.uniform(-1.5, 1.0)
        medium = HERTZ.medium if i % 3 == 0 else mdr.Coated(film, thickness, mdr.Elastic(1.0, 0.3))
        k = 10.0 ** draw.uniform(-2.0, 2.0)
        worn = (k, k * 10.0 ** draw.uniform(-2.0, 2.0)) if i % 5 == 0 else (k,)
        force = 10.0 ** draw.uniform(-3.0, 0.5)
        try:
            history = Wear(mdr.Contact(shapes[i % 7], medium), worn, (1e-2,) * (len(worn) - 1)).history(
                force=force, intervals=16, scheme=scheme
            )
        except mdr.errors.MDRError:
            continue
        for _ in range(3):
            # histories that end early are saved, too
            with contextlib.suppress(mdr.errors.MDRError):
                history.advance(10.0 ** draw.uniform(-4.0, 1.5) * history.state.radius / k, force=force)
            saved = history.saved()
            assert np.array_equal(history.restored(saved).saved(), saved), history
            restored += 1
            force *= 10.0 ** draw.uniform(-2.0 if scheme == "rings" else 0.0, 1.0)
    assert restored > 80


@pytest.mark.parametrize("contact", [HERTZ, COATED])
def test_rings_follow_any_path(contact):
    """Falling and rising loads, depth and force in turn, far enough for rings to double: k F s to 1e-12 at each end; where the load
    was least, the contact is within what it was; copies and pickles go on with the same bits."""
    history = Wear(contact, 0.7).history(force=0.5, intervals=80, scheme="rings")
    states = history.advance([0.5, 0.0, 1.0, 0.2, 40.0], force=[0.5, 0.05, 0.05, 0.6, 0.6])
    np.testing.assert_allclose(states.worn_volume, 0.7 * states.work, rtol=1e-12)
    assert states.radius[1] < 0.7 * states.radius[0] and states.radius[2] > states.radius[1]
    assert np.all(np.diff(states.worn_depth) >= 0.0) and states.worn_depth[1] == states.worn_depth[0]
    held = history.advance(0.5, depth=history.state.depth)
    assert held.force < 0.6 and held.worn_volume == pytest.approx(0.7 * held.work, rel=1e-12)
    others = [history.copy(), pickle.loads(pickle.dumps(history))]
    history.advance(0.3, force=0.2)
    for other in others:
        other.advance(0.3, force=0.2)
        assert np.array_equal(other.saved(), history.saved())
    before = history.saved()
    with pytest.raises(mdr.errors.DomainError, match="lift off"):
        history.advance(0.1, depth=0.5 * history.state.worn_depth)
    assert np.array_equal(history.saved(), before)
    again = mdr.Contact(history.profile, contact.medium).at_force(0.2)
    assert again.depth + history.state.worn_depth == pytest.approx(history.state.depth, rel=1e-3)


@pytest.mark.parametrize("contact", [HERTZ, COATED])
@pytest.mark.parametrize("given", ["force", "depth"])
def test_rings_and_disc_agree(contact, given):
    """Two schemes with nothing in common but the body: within what the rings state, which falls as their width."""
    wear, value = Wear(contact, 1.0), {"force": 0.5, "depth": 0.8}[given]
    disc = wear.advance([0.1, 1.0, 5.0], intervals=80, **{given: value})[0]
    before = np.inf
    for intervals in (40, 80, 160):
        rings = wear.advance([0.1, 1.0, 5.0], intervals=intervals, scheme="rings", **{given: value})[0]
        off = [np.abs(np.asarray(a) / b - 1.0) for a, b in zip(rings[1:6], disc[1:6], strict=True)]
        assert np.all(np.max(off, axis=0) < rings.error)
        assert np.max(rings.error) < 0.75 * before
        before = np.max(rings.error)
        np.testing.assert_allclose(rings.worn_volume, rings.work, rtol=1e-12)


@pytest.mark.parametrize(("medium", "modulus"), [(HERTZ.medium, 1.0), (mdr.Coated(SOFT, 1.0, HARD), 0.1)])
def test_a_flat_punch_runs_in(medium, modulus):
    """At constant force to uniform pressure, at constant depth to no force, and to a profile that bears it nowhere else."""
    contact = mdr.Contact(mdr.FlatPunch(1.0), medium)
    wear = Wear(contact, 1.0)
    history = wear.history(force=1.0, intervals=40, scheme="rings")
    assert history.state.depth == pytest.approx(contact.at_force(1.0).depth, rel=1e-4)
    now = history.advance(40.0 / modulus, force=1.0)
    assert now.worn_volume == pytest.approx(40.0 / modulus, rel=1e-12) and now.radius == pytest.approx(1.0, rel=1e-12)
    np.testing.assert_allclose(history.pressure([0.0, 0.5, 0.99]), 1.0 / np.pi, rtol=1e-6)
    assert history.profile.worn_depth(0.0) == pytest.approx(now.worn_depth, rel=1e-12)
    pressed = mdr.Contact(history.profile, medium).at_force(1.0)
    assert pressed.depth + now.worn_depth == pytest.approx(now.depth, rel=1e-3)
    held = wear.advance(15.0 / modulus, depth=0.3, scheme="rings", intervals=40)[0]
    assert held.force < 1e-3 and held.worn_depth == pytest.approx(0.3, rel=1e-3)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="rings"):
        wear.history(force=1.0)


@pytest.mark.parametrize("medium", [HERTZ.medium, mdr.Coated(SOFT, 0.5, HARD)])
@pytest.mark.parametrize("constant", ["force", "depth"])
def test_a_flat_punch_runs_in_over_its_length(medium, constant):
    """Rings know nothing of eigenvalues; an implicit step of ds leaves 1/(1 + ds/l), and the finer rings take two half as long."""
    wear = Wear(mdr.Contact(mdr.FlatPunch(1.0), medium), 0.5)
    length = wear.running_in_length(constant)
    history = wear.history(**{constant: 1.0}, scheme="rings")
    history.advance(15.0 * length, **{constant: 1.0})
    now = history.advance([0.01 * length] * 9, **{constant: 1.0})
    left = np.asarray(now.force if constant == "depth" else now.pressure - 1.0 / np.pi)
    assert 200.0 * ((left[0] / left[-1]) ** (1.0 / 16.0) - 1.0) == pytest.approx(1.0, rel=2e-3 if constant == "force" else 2e-4)


def test_a_stiff_film_opens_under_a_flat_punch():
    """Its middle carries nothing at first: a contact of a ring, which a disc cannot be; with wear it closes."""
    contact = mdr.Contact(mdr.FlatPunch(1.0), COATED.medium)
    with pytest.warns(mdr.errors.SeparationInsideWarning, match="not a single area"):
        pressed = contact.at_force(1.0)
    history = Wear(contact, 1.0).history(force=1.0, scheme="rings")
    assert history.pressure(0.0) == 0.0 and history.state.radius < 1.0
    assert history.state.depth == pytest.approx(pressed.depth, rel=1e-2)
    now = history.advance(30.0, force=1.0)
    assert now.radius == pytest.approx(1.0, rel=1e-12) and now.pressure == pytest.approx(1.0 / np.pi, rel=1e-3)


def test_a_coated_tip_on_rings():
    wear = Wear(HERTZ, (0.1, 1.0), (0.05,))
    states = [wear.advance([1.0, 4.0, 10.0], force=1.0, scheme=scheme)[0] for scheme in ("disc", "rings")]
    np.testing.assert_allclose(states[1].worn_volume, states[0].worn_volume, rtol=5e-3)
    np.testing.assert_allclose(states[1].worn_depth, states[0].worn_depth, rtol=1e-2)


def test_volume_and_coefficients():
    """The volume identity; k from volumes, and from radii of the scar, is that of the history that made them."""
    s = np.array([0.5, 1.0, 2.0])
    states, profile = Wear(COATED, 0.7).advance(s, force=0.5)
    np.testing.assert_allclose(states.worn_volume, 0.7 * 0.5 * s, rtol=1e-4)
    assert isinstance(profile, WornProfile)
    fit = wear_coefficient_from_volume(states.worn_volume, s, 0.5)
    assert fit.coefficient == pytest.approx(0.7, rel=1e-4) and fit.sd < 1e-4
    fit = wear_coefficient_from_scar(COATED, states.radius, s, 0.5)
    assert fit.coefficient == pytest.approx(0.7, rel=1e-4) and fit.sd < 1e-4


def test_noise_shows_in_the_deviation():
    s = np.linspace(1.0, 20.0, 12)
    noise = 1.0 + 0.02 * np.sin(np.arange(12) * 2.4)
    fit = wear_coefficient_from_volume(0.3 * s * noise, s, 1.0)
    assert abs(fit.coefficient - 0.3) < 3.0 * fit.sd < 0.02


@pytest.mark.parametrize("body", ["coated", "layered"])
def test_the_bracket_of_a_worn_coating(body):
    """With the layers as they were, what `history(places="same")` says; with the thinner coating, what that of the thinner body
    says; they draw together with the loss, and further from each other than from a coating thinner by half as much."""
    thin = {"coated": mdr.Coated(HARD, 1.0, SOFT), "layered": mdr.Layered([(HARD, 1.0), (HARD, 0.5)], SOFT)}[body]
    wear = Wear(mdr.Contact(BALL, thin), 1.0, body_coefficient=0.5)
    first, last = wear.bracket([0.1, 0.4], force=0.5, intervals=40)
    direct = wear.history(force=0.5, places="same", intervals=40)
    direct.advance([0.1, 0.3], force=0.5)
    assert direct.state.depth == pytest.approx(first.depth[-1], rel=1e-10)
    lost = max(first.body_depth[-1], last.body_depth[-1])
    assert 0.0 < lost < 0.1
    depths = []
    for part in (0.5, 1.0):
        if body == "coated":
            other = thin.replace(thickness=1.0 - part * lost)
        else:
            other = thin.replace(layers=((HARD, 1.0 - part * lost), (HARD, 0.5)))
        run = Wear(mdr.Contact(BALL, other), 1.0, body_coefficient=0.5).history(force=0.5, places="same", intervals=40)
        run.advance([0.1, 0.3], force=0.5)
        depths.append(run.state.depth)
    assert depths[1] == pytest.approx(last.depth[-1], rel=1e-6)
    assert first.depth[-1] < depths[0] < last.depth[-1]
    with pytest.raises(mdr.errors.DomainError, match="quarter"):
        wear.bracket(20.0, force=0.5, intervals=16)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="with a coating to lose"):
        Wear(HERTZ, 1.0, body_coefficient=0.5).bracket(1.0, force=0.5)


@pytest.mark.parametrize(
    "coating",
    [
        mdr.Layer(HARD, 1.0, interface=mdr.Interface(normal=0.3, tangential=0.05)),
        mdr.Layer(HARD, 1.0, interface=mdr.SLIDING),
        mdr.Layer(HARD, 1.0, prestress=0.2),
        mdr.Layer(SOFT, 1.0, prestress=-0.01),
    ],
)
def test_the_bracket_of_a_coating_keeps_its_interface_and_prestress(coating):
    """Both runs of it are those of the body given layer by layer; without the interface depths are 5 to 20 % off."""
    body = mdr.Layered([coating, mdr.Layer(HARD, 0.5, interface=mdr.SLIDING)], SOFT)
    wear = Wear(mdr.Contact(BALL, body), 1.0, body_coefficient=0.5)
    first, last = wear.bracket(0.4, force=0.5, intervals=16)
    lost = max(first.body_depth, last.body_depth) * (1.0 + 1e-9)
    for thickness, found in ((1.0, first), (1.0 - lost, last)):
        stack = mdr.Layered([coating.replace(thickness=thickness), body.layers[1]], SOFT)
        run = Wear(mdr.Contact(BALL, stack), 1.0, body_coefficient=0.5)
        wanted = run.history(force=0.5, places="same", intervals=16).advance(0.4, force=0.5)
        assert list(found) == pytest.approx(list(wanted), rel=1e-10)


def test_bad_input_is_refused_with_the_reason():
    wear = Wear(HERTZ, 1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="coefficient = 0"):
        Wear(HERTZ, 0.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="one coefficient more"):
        Wear(HERTZ, [1.0, 2.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="adhesion"):
        Wear(mdr.Contact(BALL, mdr.Homogeneous(HARD), 0.1), 1.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="one of force and depth"):
        wear.history(force=1.0, depth=1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="body_coefficient"):
        wear.track(0.0, HERTZ.at_depth(0.1))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="flat punch"):
        Wear(mdr.Contact(mdr.FlatPunch(1.0), mdr.Homogeneous(HARD)), 1.0).history(force=1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="needs a flat punch"):
        wear.running_in_length()
    corrected = Wear(mdr.Contact(BALL, HERTZ.medium, zeta=([0.1, 1.0, 3.0], [0.9, 0.85, 0.8])), 0.1)
    for scheme in ("disc", "rings"):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="zeta: it is not available with the wear of a sliding indenter"):
            corrected.advance(0.1, depth=0.2, scheme=scheme)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean 'rings'"):
        wear.history(force=1.0, scheme="ring")
    sphere = Wear(mdr.Contact(mdr.Sphere(1.0), mdr.Homogeneous(HARD)), 1.0).history(force=0.1, intervals=16, scheme="rings")
    with pytest.raises(mdr.errors.DomainError, match="indenter ends"):
        sphere.advance(60.0, force=0.1)
    assert sphere.advance(0.1, force=0.05).sliding == 0.1
    history = wear.history(force=1.0, intervals=16)
    before = history.saved()
    with pytest.raises(mdr.errors.DomainError, match="shrink"):
        history.advance(0.1, force=0.1)
    assert np.array_equal(history.saved(), before)
    history.advance(0.1, force=1.0)


STEEL = mdr.Elastic(210e9, 0.3)
BALL_ON_DISC = mdr.Contact(mdr.Paraboloid(3e-3), mdr.Pair(mdr.Homogeneous(STEEL), mdr.Homogeneous(STEEL)))
DISTANCES = np.array([10.0, 100.0, 400.0, 700.0, 1000.0])


def late_radii(force, sliding):
    """theory/wear.md (4.3), solved for the radius; k = 1e-14 m^2/N."""

    def miss(a, s):
        return math.pi * a**4 / (4.0 * 3e-3) - 4.0 * force * a / (3.0 * math.pi * STEEL.E / (2.0 * 0.91)) - 1e-14 * force * s

    return np.array([optimize.brentq(miss, 1e-5, 1e-2, args=(s,), xtol=1e-15) for s in sliding])


@pytest.mark.parametrize(("intervals", "accuracy"), [(40, 3e-4), (80, 3e-5), (160, 3e-5)])
def test_the_distances_of_a_tribometer(intervals, accuracy):
    """A steel ball over 1000 m at 1e-5 mm^3/(N m), 25,000 radii in k E* s: the late law, good to 3e-4 at 30 radii."""
    started = time.process_time()
    states, _ = Wear(BALL_ON_DISC, 1e-14).advance(DISTANCES, force=5.0, intervals=intervals)
    spent = time.process_time() - started
    np.testing.assert_allclose(states.radius, [209.45e-6, 371.88e-6, 525.80e-6, 604.73e-6, 661.12e-6], rtol=max(2e-5, accuracy))
    np.testing.assert_allclose(states.radius, late_radii(5.0, DISTANCES), rtol=accuracy)
    np.testing.assert_allclose(states.worn_volume, 1e-14 * states.work, rtol=3e-4 if intervals == 40 else 5e-5)
    np.testing.assert_allclose(states.force, 5.0, rtol=1e-11)
    np.testing.assert_allclose(states.pressure * math.pi * states.radius**2, 5.0, rtol=1e-2)
    assert np.all(np.abs(states.radius / late_radii(5.0, DISTANCES) - 1.0) < states.error)
    assert spent < 10.0  # 0.3 s with 80 intervals


@pytest.mark.parametrize(("intervals", "accuracy"), [(40, 1e-2), (80, 3e-3), (160, 1e-3)])
def test_the_distances_of_a_tribometer_by_rings(intervals, accuracy):
    states, _ = Wear(BALL_ON_DISC, 1e-14).advance(DISTANCES, force=5.0, intervals=intervals, scheme="rings")
    np.testing.assert_allclose(states.radius, late_radii(5.0, DISTANCES), rtol=accuracy)
    np.testing.assert_allclose(states.worn_volume, 1e-14 * states.work, rtol=1e-12)
    assert np.all(np.abs(states.radius / late_radii(5.0, DISTANCES) - 1.0) < states.error)


def test_rings_begin_with_the_unworn_radius():
    """Half a ring is 0.9 % with 80 intervals."""
    for intervals, accuracy in ((40, 1e-2), (80, 3e-3), (160, 3e-3)):
        radius = Wear(HERTZ, 1.0).history(force=0.17, scheme="rings", intervals=intervals).state.radius
        assert radius == pytest.approx(HERTZ.at_force(0.17).radius, rel=accuracy)


def test_halved_steps_converge():
    """Parts of the path add ends of steps, and change no more than the error that is stated."""
    wear = Wear(BALL_ON_DISC, 1e-14)
    whole, _ = wear.advance([300.0], force=5.0)
    parts, _ = wear.advance(np.geomspace(0.1, 300.0, 200), force=5.0)
    assert parts.radius[-1] == pytest.approx(whole.radius[0], rel=5e-5)
    assert parts.depth[-1] == pytest.approx(whole.depth[0], rel=1e-4)
    radii = [wear.advance([300.0], force=5.0, intervals=n)[0].radius[0] for n in (24, 40, 80, 160)]
    assert np.all(np.abs(np.array(radii) / late_radii(5.0, [300.0]) - 1.0) < [4e-3, 3e-4, 6e-5, 3e-5])


def test_a_load_that_changes_after_a_long_way():
    """Steps are short again where the force begins to change: against parts of a path that are prescribed short."""
    histories = [Wear(BALL_ON_DISC, 1e-14).history(force=5.0) for _ in range(2)]
    for history in histories:
        history.advance(100.0, force=5.0)
    one = histories[0].advance(20.0, force=10.0)
    other = histories[1].advance(np.full(400, 0.05), force=np.linspace(5.0, 10.0, 401)[1:])
    assert one.radius == pytest.approx(other.radius[-1], rel=1e-4)
    assert one.work == pytest.approx(100.0 * 5.0 + 20.0 * 7.5, rel=1e-9) == other.work[-1]
    assert one.worn_volume == pytest.approx(1e-14 * one.work, rel=2e-4)
    after = histories[0].advance(900.0, force=10.0)
    a = after.radius
    late = math.pi * a**4 / (4.0 * 3e-3) - 4.0 * 10.0 * a / (3.0 * math.pi * STEEL.E / (2.0 * 0.91))
    assert late == pytest.approx(1e-14 * after.work, rel=3e-4)


def test_a_history_after_a_long_way_goes_on_with_the_same_bits():
    history = Wear(BALL_ON_DISC, 1e-14).history(force=5.0, intervals=40)
    history.advance([100.0, 1.0, 50.0], force=[5.0, 6.0, 6.0])
    again = pickle.loads(pickle.dumps(history))
    assert again.advance(500.0, force=6.0) == history.advance(500.0, force=6.0)
    assert np.array_equal(again.saved(), history.saved())


def test_rows_before_the_end_of_a_path_are_kept():
    """A sphere that wears to its equator: the states before are returned, and say why there are no more."""
    wear = Wear(mdr.Contact(mdr.Sphere(1.0), mdr.Homogeneous(HARD)), 1.0)
    for scheme in ("disc", "rings"):
        history = wear.history(force=0.1, intervals=16, scheme=scheme)
        with pytest.warns(mdr.errors.PathEndsWarning, match=r"ends after 2 of 4 parts, 0.6 further: .*indenter ends") as caught:
            states = history.advance([0.1, 0.5, 60.0, 1.0], force=np.full(4, 0.1))
        assert len(caught) == 1 and states.warnings == (str(caught[0].message),)
        alone = wear.history(force=0.1, intervals=16, scheme=scheme).advance([0.1, 0.5], force=np.full(2, 0.1))
        assert not alone.warnings and all(np.array_equal(one, two) for one, two in zip(states, alone, strict=True))
        assert history.state.sliding == 0.6
        with pytest.warns(mdr.errors.PathEndsWarning):
            states, profile = wear.advance([[0.1, 0.6], [60.6, 61.6]], force=0.1, intervals=16, scheme=scheme)
        assert states.radius.tolist() == alone.radius.tolist() and states.warnings and profile.worn_depth(0.0) > 0.0
        before = history.saved()
        with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 2 of sliding = -1"):
            history.advance([0.1, -1.0], force=np.full(2, 0.1))
        assert np.array_equal(history.saved(), before)
        with pytest.raises(mdr.errors.DomainError, match="indenter ends"):
            history.advance([60.0, 0.1], force=np.full(2, 0.1))
    with pytest.raises(mdr.errors.DomainError, match="ends after 1 of 2 parts"):
        wear_coefficient_from_scar(wear.contact, [0.9, 0.99999], [1.0, 1e6], 0.1)


TRIBOMETER = """title = "steel ball on flat, ball-on-disc"
[indenter]
shape = "paraboloid"
radius = "3 mm"
material = { E = "210 GPa", nu = 0.3 }
[medium]
type = "homogeneous"
material = { E = "210 GPa", nu = 0.3 }
[wear]
coefficient = "1e-5 mm^3/(N*m)"
sliding = ["10 m", "100 m", "400 m", "700 m", "1000 m"]
[compute]
forces = ["5 N"]
"""


def test_command_over_a_tribometers_distances(tmp_path, capsys):
    problem, table = tmp_path / "ball.toml", tmp_path / "wear.csv"
    problem.write_text(TRIBOMETER)
    assert main(["wear", str(problem), "--csv", str(table)]) == 0
    rows = [line.split(",") for line in table.read_text().splitlines() if line[:1].isdigit()]
    assert [float(row[0]) for row in rows] == [10.0, 100.0, 400.0, 700.0, 1000.0]
    assert [float(row[1]) for row in rows] == pytest.approx([209.1, 371.7, 525.7, 604.6, 661.1], rel=3e-3)
    problem.write_text(TRIBOMETER.replace('"paraboloid"', '"sphere"').replace('"1000 m"', '"1e15 m"'))
    assert main(["wear", str(problem), "--csv", str(table), "--overwrite"]) == 0
    rows = [line.split(",") for line in table.read_text().splitlines() if line[:1].isdigit()]
    assert [float(row[0]) for row in rows] == [10.0, 100.0, 400.0, 700.0]
    assert "the path ends after 4 of 5 parts" in capsys.readouterr().err


def test_command(tmp_path, capsys):
    problem = tmp_path / "ball.toml"
    problem.write_text(
        """[indenter]
shape = "sphere"
radius = "3 mm"

[medium]
type = "coated"
coating = { E = "120 GPa", nu = 0.25, thickness = "2 um" }
substrate = { E = "210 GPa", nu = 0.3 }

[compute]
max_force = "5 N"

[wear]
coefficient = "1e-6 mm^3/(N*m)"
sliding = ["10 m", "50 m"]
intervals = 40
"""
    )
    csv, picture = tmp_path / "wear.csv", tmp_path / "wear.png"
    assert main(["wear", str(problem), "--csv", str(csv), "--plot", str(picture)]) == 0
    assert "worn volume" in capsys.readouterr().out
    steel, dlc = mdr.Elastic(210e9, 0.3), mdr.Elastic(120e9, 0.25)
    contact = mdr.Contact(mdr.Sphere(3e-3), mdr.Coated(dlc, 2e-6, steel))
    states, _ = Wear(contact, 1e-15).advance([10.0, 50.0], force=5.0, intervals=40)
    rows = csv.read_text().splitlines()
    assert len(rows) >= 3 and picture.stat().st_size > 10_000
    assert float(rows[-1].split(",")[0]) == pytest.approx(50.0)
    assert states.radius[-1] > states.radius[0]
    for before, after, words in (
        ("intervals = 40", "intervals = 42", "multiple of 4"),
        ('"1e-6 mm^3/(N*m)"', "1e-15", "has no unit"),
        ('"1e-6 mm^3/(N*m)"', '"1e-15 mm^2"', "not a unit of a coefficient of wear"),
        ('"1e-6 mm^3/(N*m)"', '"0 Pa^-1"', "greater than 0"),
        ("intervals = 40", 'scheme = "disk"', "Did you mean 'disc'"),
    ):
        wrong = tmp_path / "wrong.toml"
        wrong.write_text(problem.read_text().replace(before, after))
        assert main(["wear", str(wrong)]) == 2
        assert words in capsys.readouterr().err
    problem.write_text(problem.read_text().replace('"1e-6 mm^3/(N*m)"', '"1e-6 GPa^-1"').replace("40", '40\nscheme = "rings"'))
    assert main(["wear", str(problem)]) == 0
    assert "1e-06 mm^3/(N*m)" in capsys.readouterr().out
