# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenters given as functions: forces and pressures from the first touch up, against quadratures of the formulas themselves."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss
from scipy.interpolate import CubicSpline, PchipInterpolator

import mdrcontact as mdr

B = 1e-7
"""The size of the tips [m]."""
BODY = mdr.Homogeneous(mdr.Elastic(70e9, 0.2))
E_STAR = 70e9 / (1.0 - 0.2**2)
NODES, WEIGHTS = leggauss(24)
KNOTS = B * np.concatenate([[0.0], np.geomspace(0.2, 2e4, 25)])
KNOT_HEIGHTS = 0.4 * KNOTS**2 / (np.sqrt(KNOTS**2 + B**2) + B)
CLAMPED = CubicSpline(KNOTS, KNOT_HEIGHTS, bc_type=((1, 0.0), "not-a-knot"))
MONOTONE = PchipInterpolator(KNOTS, KNOT_HEIGHTS)
BLEND = B * math.sin(0.35)


def sphere_on_cone(r):
    if r < BLEND:
        return r * r / (B + math.sqrt(B * B - r * r))
    return B * (1.0 - math.cos(0.35)) + (r - BLEND) * math.tan(0.35)


def sphere_on_cone_slope(r):
    return np.where(r < BLEND, r / np.sqrt(np.maximum(B * B - r * r, 0.1 * B * B)), math.tan(0.35))


# f(r), f'(r), and the radii where f is not analytic
TIPS = {
    "guide": (lambda r: 0.3 * r**2 / (r + B), lambda r: 0.3 * r * (r + 2 * B) / (r + B) ** 2, ()),
    "hyperboloid": (lambda r: 0.4 * r * r / (math.hypot(r, B) + B), lambda r: 0.4 * r / np.hypot(r, B), ()),
    "hyperboloid, with cancellation": (lambda r: 0.4 * (math.sqrt(r * r + B * B) - B), lambda r: 0.4 * r / np.hypot(r, B), ()),
    "guide, with cancellation": (
        lambda r: 0.3 * (r - B + B * B / (r + B)),
        lambda r: 0.3 * r * (r + 2 * B) / (r + B) ** 2,
        (),
    ),
    "tanh": (
        lambda r: r * math.tanh(r / B),
        lambda r: np.tanh(r / B) + r / B / np.cosh(np.minimum(r / B, 300.0)) ** 2,
        (),
    ),
    "rounded cone": (lambda r: 0.15 * r * r / B if r < B else 0.3 * (r - B / 2), lambda r: 0.3 * np.minimum(r / B, 1.0), (B,)),
    "sphere on a cone": (sphere_on_cone, sphere_on_cone_slope, (BLEND,)),
    "two powers": (lambda r: B * ((r / B) ** 1.5 + (r / B) ** 3), lambda r: 1.5 * np.sqrt(r / B) + 3 * (r / B) ** 2, ()),
    "logarithm": (lambda r: r - B * math.log1p(r / B), lambda r: r / (r + B), ()),
    "a cone of 1e-5 under a paraboloid": (lambda r: 1e-5 * r + r * r / B, lambda r: 1e-5 + 2 * r / B, ()),
    "quartic": (lambda r: (math.sqrt(B**4 + r**4) - B**2) / B, lambda r: 2 * r**3 / np.sqrt(B**4 + r**4) / B, ()),
    "cubic spline": (lambda r: float(CLAMPED(r)), CLAMPED.derivative(), tuple(KNOTS[1:])),
    "monotone cubics": (lambda r: float(MONOTONE(r)), MONOTONE.derivative(), tuple(KNOTS[1:])),
}


def circle(a, corners):
    """Angles and weights of int_0^{pi/2} ... dt with r = a sin(t): fine towards the axis and split at the corners."""
    radii = [0.0, *(a * np.geomspace(1e-15, 0.5, 60)), *(c for c in corners if c < a), a]
    edges = np.arcsin(np.unique(radii) / a)
    edges = np.unique(np.concatenate([np.linspace(left, right, 4) for left, right in zip(edges, edges[1:], strict=False)]))
    half = np.diff(edges) / 2
    return ((edges[:-1] + half)[:, None] + half[:, None] * NODES).ravel(), (half[:, None] * WEIGHTS).ravel()


def depth_and_force(slope, a, corners):
    """d = a int f'(a sin t) dt, F = 2 E* a^2 int f'(a sin t) sin^2 t dt (Sneddon): no derivative, no sampling."""
    t, weights = circle(a, corners)
    values = weights * slope(a * np.sin(t))
    return a * np.sum(values), 2 * E_STAR * a * a * np.sum(values * np.sin(t) ** 2)


@pytest.mark.parametrize("largest", [1.0, 4.0, 30.0, 1e4])
@pytest.mark.parametrize("name", TIPS)
def test_forces_from_first_touch_up(name, largest):
    height, slope, corners = TIPS[name]
    contact = mdr.Contact(mdr.CallableProfile(height, largest * B), BODY)
    for a in B * np.geomspace(1e-7, 0.97 * largest, 30):
        depth, force = depth_and_force(slope, a, corners)
        assert float(contact.at_depth(depth).force) == pytest.approx(force, rel=1e-9), a


@pytest.mark.parametrize("largest", [1.0, 4.0, 1e4])
@pytest.mark.parametrize("name", TIPS)
def test_pressures_add_up_to_the_force(name, largest):
    height, slope, corners = TIPS[name]
    contact = mdr.Contact(mdr.CallableProfile(height, largest * B), BODY)
    for a in B * np.geomspace(1e-4, 0.9 * largest, 4):
        t, weights = circle(a, corners)
        pressure = contact.at_radius(a).pressure(a * np.sin(t))
        force = 2 * math.pi * a * a * np.sum(weights * pressure * np.sin(t) * np.cos(t))
        # at a corner p has a logarithm, which this quadrature does not follow
        accuracy = 2e-8 if corners else 1e-9
        assert force == pytest.approx(depth_and_force(slope, a, corners)[1], rel=accuracy), a


@pytest.mark.parametrize("r_max", [1.25, 2.0, 30.0, 1e4])
def test_pressures_of_a_rounded_cone(r_max):
    """Where the second derivative jumps, quadratures must be split: at r_max = 2 B the corner lies where r_max is halved."""
    ours = mdr.Contact(mdr.CallableProfile(TIPS["rounded cone"][0], r_max * B), BODY)
    closed = mdr.Contact(mdr.RoundedCone(B, math.atan(0.3)), BODY)
    r = np.array([0.05, 0.3, 0.6, 0.8, 0.93, 0.99]) * 1.2 * B
    assert ours.at_radius(1.2 * B).pressure(r) == pytest.approx(closed.at_radius(1.2 * B).pressure(r), rel=1e-10)


def test_the_hyperboloid_has_a_closed_transform():
    """g = tan(phi) x arctan(x/b)."""
    profile = mdr.CallableProfile(TIPS["hyperboloid"][0], 1e4 * B)
    x = B * np.geomspace(1e-8, 9e3, 200)
    assert profile.mdr(x) == pytest.approx(0.4 * x * np.arctan(x / B), rel=1e-12)


@pytest.mark.parametrize("r_max", [1e-6, 5e-6, 9.999e-6])
def test_a_sphere_that_loses_digits_is_continued(r_max):
    written, closed = mdr.CallableProfile(lambda r: 10e-6 - math.sqrt(1e-10 - r * r), r_max), mdr.Sphere(10e-6)
    depth = np.geomspace(1e-22, closed.mdr(0.97 * r_max), 60)
    ours, exact = mdr.Contact(written, BODY).at_depth(depth), mdr.Contact(closed, BODY).at_depth(depth)
    assert ours.force == pytest.approx(exact.force, rel=1e-9)


@pytest.mark.parametrize("r_max", [1e-9, 1e-8])
def test_a_sphere_of_which_nothing_is_left_is_refused(r_max):
    with pytest.raises(mdr.errors.NoConvergenceError, match=r"is inaccurate near the axis: at r = .*Write it without"):
        mdr.CallableProfile(lambda r: 10e-6 - math.sqrt(1e-10 - r * r), r_max)


def test_heights_that_scatter_are_refused():
    with pytest.raises(mdr.errors.NoConvergenceError, match="its values scatter by"):
        mdr.CallableProfile(lambda r: float(np.float32(r * r)), 1.0)


def test_a_constant_is_taken_off():
    """Heights count from the lowest point, also where a formula gives 1e-13 there."""
    ours = mdr.Contact(mdr.CallableProfile(lambda r: 1e-13 + r * r, 1.0), BODY)
    assert ours.at_depth(2e-14).force == pytest.approx(mdr.Contact(mdr.Paraboloid(0.5), BODY).at_depth(2e-14).force, rel=1e-9)


@pytest.mark.parametrize(
    "height",
    [
        lambda r: r * r - 1e-5 * r,
        lambda r: max(0.0, r - 0.3),
        CubicSpline(KNOTS / B, KNOT_HEIGHTS / B),
    ],
)
def test_heights_that_do_not_rise_from_the_axis_are_refused(height):
    with pytest.raises(mdr.errors.InvalidArgumentError, match=r"^f = .* at r = .*must be greater than 0"):
        mdr.CallableProfile(lambda r: float(height(r)), 1.0)


def test_a_bump_between_the_nodes_is_seen():
    """A ring of 2 % of the radius, which no node of the widest panels meets."""

    def height(r):
        return r + 5e-3 * math.exp(-(((r - 0.61) / 0.01) ** 2))

    profile = mdr.CallableProfile(height, 1.0)
    r = np.linspace(0.0, 1.0, 4001)
    assert profile.height(r) == pytest.approx([height(x) for x in r], abs=1e-12)


def test_tables_hold_at_the_apex():
    """A table is its stated interpolation down to the axis: the same cubics as a function."""
    r, f = np.array([0.0, 1.0, 2.0, 3.0]), np.array([0.0, 0.1001, 0.4, 0.9])
    table = mdr.Contact(mdr.TabulatedProfile(r, f), BODY)
    first = (f[1] - f[0]) - ((f[2] - f[1]) - (f[1] - f[0])) / 2
    rise = (f[1] - f[0] + f[2] - f[1]) / 2
    second = min(abs(f[1] - f[0]), abs(f[2] - f[1]), abs(rise) / 2) * 2
    c2, c3 = 3 * f[1] - 2 * first - second, first + second - 2 * f[1]
    for a in np.geomspace(1e-12, 0.9, 20):
        depth, force = depth_and_force(lambda x: first + 2 * c2 * x + 3 * c3 * x * x, a, ())
        assert float(table.at_depth(depth).force) == pytest.approx(force, rel=1e-9), a


@pytest.mark.parametrize("largest", [1.0, 16.0, 1e3])
def test_a_corner_far_below_the_largest_radius(largest):
    b = 1.25e-5
    tip = mdr.CallableProfile(lambda r: r * r / (2.0 * b) if r < b else r - 0.5 * b, largest)
    known = mdr.RoundedCone(b, math.atan(1.0))
    x = b * np.array([0.5, 1.0, 1.01, 1.5, 4.0, 366.0, 7e4])
    assert np.max(np.abs(tip.mdr(x) / known.mdr(x) - 1.0)) < 1e-9
    half_space = mdr.Homogeneous(mdr.Elastic(1.0, 0.3))
    of_user, of_shape = (mdr.Contact(profile, half_space).at_radius(x).force for profile in (tip, known))
    assert np.max(np.abs(of_user / of_shape - 1.0)) < 1e-9


def calibration(terms, seed):
    """Coefficients [m] as an instrument fits them to 14 areas of a rounded Berkovich tip that scatter by 2 %."""
    random = np.random.default_rng(seed)
    h = np.linspace(60.0, 300.0, 14)
    areas = 24.5 * (h + 15.0) ** 2 * (1.0 + 0.02 * random.standard_normal(14))
    powers = np.array([2.0, *(0.5**i for i in range(terms - 1))])
    fitted = np.linalg.lstsq(h[:, None] ** powers / areas[:, None], np.ones(14), rcond=None)[0]
    return fitted * 1e-9 ** (2.0 - powers), powers


@pytest.mark.parametrize(("terms", "seed"), [(5, 0), (6, 0), (6, 1), (6, 2)])
@pytest.mark.parametrize("min_height", [60e-9, 100e-9])
def test_area_functions_whose_terms_cancel(terms, seed, min_height):
    """Calibrations of six terms with coefficients of both signs were "not smooth enough": their areas are accurate to 1e-10."""
    coefficients, powers = calibration(terms, seed)
    heights = np.linspace(1.01 * min_height, 299e-9, 50)
    areas = np.array([math.fsum(c * float(f) ** power for c, power in zip(coefficients, powers, strict=True)) for f in heights])
    assert np.all(np.diff(areas) > 0.0) and np.any(coefficients < 0.0)
    tip = mdr.AreaFunction(coefficients, min_height=min_height, max_height=300e-9)
    assert np.asarray(tip.height(np.sqrt(areas / math.pi))) == pytest.approx(heights, rel=1e-8)
    # a tip within 10 % of a cone needs a depth within 10 % of pi/2 times its height
    state = mdr.Contact(tip, BODY).at_radius(math.sqrt(areas[-1] / math.pi))
    assert state.depth == pytest.approx(0.5 * math.pi * heights[-1], rel=0.1)
