# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of indenters: f(r), g(x) and what was made by sampling."""

import math

import numpy as np
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation
from .references import abel, panels, scales_of, slopes
from .rescale import in_units

shapes = st.one_of(d.one_tip, d.sums)


@relation(60, tip=d.closed_tips, share=d.shares)
def test_one_dimensional_profile(tip, share):
    """g(x) against x int f'/sqrt(x^2 - r^2) dr by Gauss and Legendre in the angle."""
    for x in tip.radii(share, 3):
        ends = [tip.corner or 0.0, *(x * 2.0 ** np.arange(-20.0, 0.0))]
        near(tip.profile.mdr(float(x)), abel(tip.profile.slope, float(x), ends), 1e-11)


@relation(60, tip=d.tips, share=d.shares)
def test_slopes(tip, share):
    """f' and g' against differences of sixth order of f and g."""
    x = float(tip.radii(share)[-1])
    step = 1e-2 * min(x, abs(x - tip.corner) if tip.corner else x, abs(tip.high - x) + 0.02 * x)
    near(tip.profile.slope(x), slopes(tip.profile.height, x, step), 1e-6)
    near(tip.profile.mdr_slope(x), slopes(tip.profile.mdr, x, step), 1e-5)


@relation(40, tip=d.closed_tips, share=d.shares)
def test_the_inverse_transform_gives_the_shape_back(tip, share):
    """f(r) against (2/pi) int g(x)/sqrt(r^2 - x^2) dx by Gauss and Legendre in the angle."""
    r = float(tip.radii(share)[-1])
    corners = [math.asin(tip.corner / r)] if tip.corner and tip.corner < r else []
    graded = [*(0.5 * math.pi * 2.0 ** np.arange(-24.0, 0.0)), 0.5 * math.pi]
    # beside the edge of a flat end g grows as the root of the distance
    beside = [c + (0.5 * math.pi - c) * 2.0**k for c in corners for k in np.arange(-30.0, 0.0)]
    found = 2.0 / math.pi * panels(lambda angle: tip.profile.mdr(r * np.sin(angle)), sorted([0.0, *corners, *graded, *beside]))
    near(tip.profile.height(r), found, 1e-7)


@relation(40, first=d.one_tip, second=d.simple_tips, x=st.floats(0.1, 0.9))
def test_sums(first, second, x):
    """f, f', g and g' of a sum against the sums of its parts."""
    whole, top = first.profile + second.profile, x * min(first.high, second.high)
    for name in ("height", "slope", "mdr", "mdr_slope"):
        parts = [getattr(tip.profile, name)(top) for tip in (first, second)]
        near(getattr(whole, name)(top), sum(parts), 1e-14, size=sum(map(abs, parts)))


@relation(40, tip=d.tips, share=d.shares, s=d.between(1e-12, 1e12))
def test_units_of_shapes(tip, share, s):
    """f and g in another unit of length."""
    other, x = in_units(tip.profile, s), tip.radii(share)
    near(other.height(x * s), tip.profile.height(x) * s, 1e-11)
    near(other.mdr(x * s), tip.profile.mdr(x) * s, 1e-11)


@relation(40, c=st.lists(st.floats(0.0, 2.0), min_size=1, max_size=3), c0=st.floats(2.0, 40.0), f=d.between(1e-5, 0.9))
def test_area_functions(c, c0, f):
    """pi r^2 at the height f against A(f) as it was given."""
    area = c0 * f * f + sum(v * f ** (0.5**k) for k, v in enumerate(c))
    tip = mdr.AreaFunction([c0, *c], max_height=1.0)
    near(tip.height(math.sqrt(area / math.pi)), f, 1e-9)


@relation(40, heights=st.lists(d.between(0.05, 1.0), min_size=2, max_size=8))
def test_tables_of_heights(heights):
    """TabulatedProfile at its knots against the table; between them no overshoot."""
    r, f = np.arange(len(heights) + 1.0), np.concatenate([[0.0], np.cumsum(heights)])
    tip = mdr.TabulatedProfile(r, f)
    near(tip.height(r), f, 1e-12, size=f[-1])
    middle = tip.height(r[:-1] + 0.5)
    assert np.all((middle >= f[:-1] - 1e-12) & (middle <= f[1:] + 1e-12))


@relation(
    40,
    slope=d.between(0.01, 2.0),
    knots=st.lists(st.floats(0.01, 0.99), min_size=2, max_size=9, unique=True),
    a=st.floats(0.2, 0.9),
)
def test_collinear_knots_of_a_table(slope, knots, a):
    """A table of a cone, whatever its knots, against the cone."""
    r = np.unique(np.round(np.array([0.0, *knots, 1.0]), 6))
    cone = mdr.Cone(math.atan(slope))
    table = mdr.TabulatedProfile(r, slope * r)
    near(table.height(a), slope * a, 1e-12)
    near(table.mdr(a), cone.mdr(a), 1e-9)
    near(mdr.TabulatedMDRProfile(r, 0.5 * math.pi * slope * r).height(a), slope * a, 1e-9)


@relation(40, n=st.floats(1.0, 5.0), c=d.between(0.01, 10.0), r_max=d.between(0.1, 100.0), x=st.floats(1e-3, 0.999))
def test_a_users_power_law(n, c, r_max, x):
    """A user's function c r^n against the closed form of PowerLaw."""
    user, known = mdr.CallableProfile(lambda r: c * r**n, r_max), mdr.PowerLaw(n, c)
    near(user.height(x * r_max), known.height(x * r_max), 1e-9)
    near(user.mdr(x * r_max), known.mdr(x * r_max), 1e-9)


def _g(f_slope, x, inner):
    return abel(f_slope, x, scales_of(inner, x))


@relation(30, inner=d.between(0.2, 1.0), s=d.between(0.1, 2.0), x=st.floats(0.05, 0.95))
def test_a_users_hyperboloid(inner, s, x):
    """g of a user's hyperboloid, its tip as large as its range, against quadrature."""
    tip = mdr.CallableProfile(lambda r: s * r * r / (math.hypot(r, inner) + inner), 1.0)
    near(tip.mdr(x), _g(lambda r: s * r / np.hypot(r, inner), x, inner), 1e-9)


SLIM = d.between(1e-5, 0.3)
"""Radius of a user's tip over the largest radius it is given to."""
shapes_of_two_sizes = {
    "hyperboloid": (lambda r, c: r * r / (math.hypot(r, c) + c), lambda r, c: r / np.hypot(r, c)),
    "r^2/(r + c)": (lambda r, c: r * r / (r + c), lambda r, c: r * (r + 2.0 * c) / (r + c) ** 2),
    "r tanh(r/c)": (
        lambda r, c: r * math.tanh(r / c),
        lambda r, c: np.tanh(r / c) + r / c / np.cosh(np.minimum(r / c, 300.0)) ** 2,
    ),
    "rounded cone": (lambda r, c: r * r / (2.0 * c) if r < c else r - 0.5 * c, lambda r, c: np.minimum(r / c, 1.0)),
}


@relation(
    40,
    shape=st.sampled_from(sorted(shapes_of_two_sizes)),
    c=SLIM,
    slope=d.between(0.05, 2.0),
    reach=st.floats(0.0, 1.0),
    may_refuse=0.5,
)
def test_a_users_tip_of_two_sizes(shape, c, slope, reach):
    """g of a user's tip with an inner radius c far below its range, from c/100 to its end, against quadrature over octaves."""
    f, f_slope = shapes_of_two_sizes[shape]
    tip = mdr.CallableProfile(lambda r: slope * f(r, c), 1.0)
    x = 0.01 * c * (99.0 / c) ** reach
    near(tip.mdr(x), abel(lambda r: slope * f_slope(r, c), x, scales_of(c, x)), 1e-9)


@relation(
    40,
    shape=st.sampled_from(sorted(shapes_of_two_sizes)),
    c=SLIM,
    wider=d.between(1.1, 1e3),
    reach=st.floats(0.0, 1.0),
    may_refuse=0.5,
)
def test_the_range_of_a_users_tip(shape, c, wider, reach):
    """F(a) under a user's function up to one radius against the same function given up to a larger one."""
    f, _ = shapes_of_two_sizes[shape]
    near_one, far_one = (mdr.CallableProfile(lambda r: f(r, c), r_max) for r_max in (1.0, wider))
    a = 0.01 * c * (90.0 / c) ** reach
    body = mdr.Homogeneous(mdr.Elastic(1.0, 0.3))
    one, two = (mdr.Contact(tip, body).at_radius(a) for tip in (near_one, far_one))
    near(two.force, one.force, 2e-9)
    near(two.depth, one.depth, 2e-9)


@relation(
    30,
    n=st.floats(1.0, 5.0),
    bend=st.floats(0.05, 1.0),
    size=d.between(0.3, 3.0),
    medium=st.one_of(d.homogeneous, d.one_coating),
    may_refuse=0.3,
)
def test_a_users_sum_of_powers_in_contact(n, bend, size, medium):
    """F(a) under a user's sum of powers against the sum of closed forms."""
    user = mdr.CallableProfile(lambda r: r**n / size + bend * r * r, 3.0)
    known = mdr.PowerLaw(n, 1.0 / size) + mdr.Paraboloid(0.5 / bend)
    a = np.geomspace(0.02, 2.9, 5)
    one, two = mdr.Contact(user, medium).at_radius(a), mdr.Contact(known, medium).at_radius(a)
    near(one.force, two.force, 1e-9)
    near(one.depth, two.depth, 1e-9)


@relation(30, R=d.between(1e-6, 1e3), share=st.floats(0.01, 0.99), reach=st.floats(0.1, 1.0), may_refuse=0.1)
def test_a_users_sphere(R, share, reach):
    """A user's R - sqrt(R^2 - r^2), with the digits it loses, against Sphere."""
    tip = mdr.CallableProfile(lambda r: R - math.sqrt(R * R - r * r), share * R)
    x = reach * share * R
    near(tip.mdr(x), mdr.Sphere(R).mdr(x), 1e-9, size=mdr.Sphere(R).mdr(x) + 1e-6 * R)


@relation(
    30,
    c0=st.floats(2.0, 40.0),
    c1=d.between(0.01, 2.0),
    zeros=st.integers(2, 6),
    last=d.between(0.01, 2.0),
    f=d.between(1e-4, 0.9),
    may_refuse=0.5,
)
def test_area_functions_of_many_terms(c0, c1, zeros, last, f):
    """pi r^2 at the height f against A(f) with terms to f^(1/128), as it was given."""
    c = [c1, *[0.0] * zeros, last]
    area = c0 * f * f + sum(v * f ** (0.5**k) for k, v in enumerate(c))
    near(mdr.AreaFunction([c0, *c], max_height=1.0).height(math.sqrt(area / math.pi)), f, 1e-9)
