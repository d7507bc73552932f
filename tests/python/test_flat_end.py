# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure and stresses beside the edge of a flat end, r = b, where they grow as the logarithm of the distance."""

import csv
from pathlib import Path

import numpy as np
import pytest
from scipy import integrate, special

import mdrcontact as mdr

NU = 0.3
UNIT = mdr.Homogeneous(mdr.Elastic(1.0 - NU**2, NU))  # E* = 1
TIN, STEEL = mdr.Elastic(450.0, 0.25), mdr.Elastic(210.0, 0.3)
OFFSETS = [s * 10.0**-n for s in (-1.0, 1.0) for n in range(1, 13)] + [-1.0]  # and the axis


def elliptic(r, b, a):
    """int from max(r, b) to a of dx over sqrt((x^2 - b^2)(x^2 - r^2)), of sqrt((x^2 - b^2)/(x^2 - r^2)) dx."""
    high, low = max(r, b), min(r, b)
    c = high / a
    rest = (high - low) * (high + low) / high**2  # 1 - k^2
    first = special.ellipkm1(rest) - special.ellipkinc(np.arcsin(c), 1.0 - rest)
    second = special.ellipe(1.0 - rest) - special.ellipeinc(np.arcsin(c), 1.0 - rest)
    edge = np.sqrt((1.0 - c**2) * (1.0 - (1.0 - rest) * c**2)) / c
    return first / high, high * (edge - second + (rest * first if r > b else 0.0))


def paraboloid_pressure(r, b, a):
    """Under (r^2 - b^2)/2 with E* = 1: g' = 2 sqrt(x^2 - b^2) + b^2/sqrt(x^2 - b^2)."""
    singular, smooth = elliptic(r, b, a)
    return (2.0 * smooth + b**2 * singular) / np.pi


def cone_pressure(r, b, a):
    """Under r - b with E* = 1: g' = arccos(b/x) + b/sqrt(x^2 - b^2)."""
    low, near = max(r, b), np.sqrt(abs(r - b))

    def smooth(u):
        t = near * np.sinh(u)  # x = low + t^2
        gap, steps = t**2 + (low - b), near * np.cosh(u)
        return 2.0 * np.arctan2(np.sqrt(gap * (gap + 2.0 * b)), b) * (t if r < b else steps) / np.sqrt(t**2 + low + r)

    last = np.arcsinh(np.sqrt(a - low) / near)
    return (b * elliptic(r, b, a)[0] + integrate.quad(smooth, 0.0, last, epsabs=1e-13, limit=200)[0]) / np.pi


SHAPES = {
    "paraboloid": (mdr.FlatEndedParaboloid(0.3, 1.0), paraboloid_pressure, 1e-12),
    "cone": (mdr.FlatEndedCone(0.3, np.pi / 4), cone_pressure, 1e-12),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_pressure_is_that_of_elliptic_integrals(shape):
    indenter, pressure, tolerance = SHAPES[shape]
    contact = mdr.Contact(indenter, UNIT)
    state = contact.at_radius(0.8)
    for offset in OFFSETS:
        r = 0.3 * (1.0 + offset)
        expected = pressure(r, 0.3, 0.8)
        assert state.pressure(r) == pytest.approx(expected, rel=tolerance), offset
        assert -state.interior(r, 0.0).s_zz == pytest.approx(expected, rel=tolerance), offset


@pytest.mark.parametrize("model", ["exact", "gao"])
def test_pressure_and_stress_agree_on_a_coating(model):
    contact = mdr.Contact(mdr.FlatEndedParaboloid(0.5, 1.0), mdr.Coated(TIN, 0.7, STEEL, model))
    state = contact.at_radius(1.0)
    r = 0.5 * (1.0 + np.array(OFFSETS))
    assert -state.interior(r, 0.0).s_zz == pytest.approx(state.pressure(r), rel=1e-9)


def test_stresses_below_the_edge():
    """Sneddon's punches added up in 30 digits (tests/data/flat_edge.py)."""
    rows = list(csv.DictReader((Path(__file__).parents[1] / "data" / "flat_edge.csv").read_text().splitlines()))
    contact = mdr.Contact(mdr.FlatEndedParaboloid(0.5, 1.0), UNIT)
    state = contact.at_radius(1.0)
    assert len(rows) == 21
    for row in rows:
        field = state.interior(float(row["r"]), float(row["z"]))
        for name in ("s_rr", "s_tt", "s_zz", "s_rz"):
            assert getattr(field, name) == pytest.approx(float(row[name]), abs=1e-11 * abs(float(row["s_zz"]))), (row, name)


@pytest.mark.parametrize("shape", [mdr.FlatEndedParaboloid(0.1, 1.0), mdr.FlatEndedCone(0.1, 0.3)])
def test_states_beside_the_end_keep_their_digits(shape):
    """There a film, or zeta, is as good as constant: the same rounding of a as on a homogeneous body, and no more."""
    film = mdr.Coated(mdr.Elastic(1.0, NU), 0.4, mdr.Elastic(3.0, 0.2), "gao")
    b, E, beyond = 0.1, film.modulus(0.1), np.geomspace(1e-9, 1e-5, 300)
    force = mdr.Contact(shape, UNIT).at_radius(b * (1 + beyond)).force
    contact = mdr.Contact(shape, film)
    assert np.all(abs(contact.at_radius(b * (1 + beyond)).force / (E * force) - 1) < 2e-13 + 0.2 * beyond)
    scaled = mdr.Contact(shape, UNIT, zeta=([0.01, 0.5, 1.0], [1.1, 1.1, 1.1])).at_radius(b * (1 + beyond)).force
    np.testing.assert_allclose(scaled, 1.1 * force, rtol=2e-13)
    pair = mdr.Contact(shape, mdr.Pair(film, film))
    for part in beyond[::30]:
        # as the flat punch of radius b
        rtol = 2e-13 + 2.0 * part
        state = contact.at_radius(b * (1 + part))
        outside = np.arcsin(0.5) / np.pi * state.depth
        np.testing.assert_allclose(state.line_load([0.05]), E * state.depth, rtol)
        np.testing.assert_allclose(state.displacement([0.2]), 2 * outside, rtol)
        # g is rounded at the nodes of the rule, as the depth is at a
        np.testing.assert_allclose(state.energy(), b * E * state.depth**2, rtol + 4e-16 / part)
        state = pair.at_radius(b * (1 + part))
        np.testing.assert_allclose(state.displacement([0.05, 0.2], body="upper"), [state.depth / 2, outside], rtol)


def test_every_flat_end_of_a_sum_is_infinite():
    contact = mdr.Contact(mdr.Paraboloid(2.0) + mdr.FlatEndedCone(0.3, 0.2) + mdr.FlatEndedParaboloid(0.6, 1.0), UNIT)
    state = contact.at_radius(0.9)
    for b in (0.3, 0.6):
        assert state.pressure(b) == np.inf and state.interior(b, 0.0).s_zz == -np.inf
        r = b * (1.0 + np.array([-1e-9, 1e-9]))
        assert -state.interior(r, 0.0).s_zz == pytest.approx(state.pressure(r), rel=1e-12)
        # by so much grows E* (slope behind b)/pi ln(1/distance)
        rise = state.pressure(b * (1.0 + 1e-10)) - state.pressure(b * (1.0 + 1e-8))
        assert rise == pytest.approx({0.3: np.tan(0.2), 0.6: 0.6}[b] / (2.0 * np.pi) * np.log(100.0), rel=1e-6)


def test_a_table_with_a_flat_end_has_no_infinite_pressure():
    """Its slope begins at 0: no edge, no logarithm."""
    r = np.linspace(0.0, 1.0, 21)
    contact = mdr.Contact(mdr.TabulatedProfile(r, np.maximum(r - 0.3, 0.0) ** 2), UNIT)
    state = contact.at_radius(0.9)
    beside = state.pressure([0.3 - 1e-9, 0.3, 0.3 + 1e-9])
    assert beside == pytest.approx(beside[0], rel=1e-6)
    assert state.interior(0.3, 0.0).s_zz == pytest.approx(-beside[1], rel=1e-6)


@pytest.mark.parametrize("medium", [UNIT, mdr.Coated(TIN, 0.7, STEEL)], ids=["homogeneous", "coated"])
def test_under_friction_s_rt_jumps_at_the_edge(medium):
    """By f sin(angle) E*/2 times the slope behind the edge; below the edge, where the surface is met, lies half of it."""
    contact = mdr.Contact(mdr.FlatEndedParaboloid(0.5, 1.0), medium)
    state = contact.at_radius(1.0)
    modulus = 1.0 if medium is UNIT else TIN.E / (1.0 - TIN.nu**2)
    r = 0.5 * (1.0 + np.array([-1e-12, 0.0, 1e-12]))
    field = state.interior(r, 0.0, friction=0.3, angle=0.8)
    assert field.s_rt[2] - field.s_rt[0] == pytest.approx(0.3 * np.sin(0.8) * modulus / 2.0 * 0.5, rel=1e-9)
    assert field.s_rt[1] == pytest.approx(0.5 * (field.s_rt[0] + field.s_rt[2]), rel=1e-9)
    assert field.s_rt[1] == pytest.approx(state.interior(0.5, 1e-12, friction=0.3, angle=0.8).s_rt, rel=1e-9)
    assert (field.s_zz[1], field.s_rz[1], field.s_tz[1]) == (-np.inf, -np.inf, np.inf)
    for name in ("u_r", "u_t", "u_z"):
        assert getattr(field, name)[1] == pytest.approx(getattr(field, name)[0], rel=1e-9)


@pytest.mark.parametrize("exponent", [1.00001, 1.003, 1.1, 1.3, 1.9, 2.5])
def test_apex_of_a_power(exponent):
    """p(0) = (E*/pi) int_0^a g'(x)/x dx, finite though g' is a broken power there."""
    contact = mdr.Contact(mdr.PowerLaw(exponent, 1.0), UNIT)
    state = contact.at_radius(1.0)
    mdr_factor = exponent * 0.5 * np.sqrt(np.pi) * special.gamma(0.5 * exponent) / special.gamma(0.5 * exponent + 0.5)
    expected = exponent * mdr_factor / (exponent - 1.0) / np.pi
    assert -state.interior(0.0, 0.0).s_zz == pytest.approx(expected, rel=1e-10)
    assert state.pressure(0.0) == pytest.approx(expected, rel=1e-10)
    for z in (1e-9, 1e-4, 0.1):

        def part(u, z=z):
            x = np.exp(u)
            return x ** (exponent + 1.0) * (x**2 + 3.0 * z**2) / (x**2 + z**2) ** 2

        pieces = [integrate.quad(part, low, low + 5.0)[0] for low in np.arange(-35.0, 0.0, 5.0)]
        expected = exponent * mdr_factor * sum(pieces) / np.pi
        assert -state.interior(0.0, z).s_zz == pytest.approx(expected, rel=1e-10)


def test_pressure_at_the_edge_on_a_power_law_graded_body():
    """p - p(b) goes as |r - b|^m: finite at the edge for m > 0."""
    shape = mdr.FlatEndedParaboloid(0.5, 1.0)
    for exponent, bound in ((0.6, 1e-6), (0.9, 1e-9)):
        contact = mdr.Contact(shape, mdr.PowerLawGraded(1.0, 1.0, exponent, NU))
        state = contact.at_radius(1.0)
        before, at, beyond = state.pressure(0.5 * (1.0 + np.array([-1e-12, 0.0, 1e-12])))
        assert (before, beyond) == pytest.approx((at, at), rel=bound)
    soft = mdr.Contact(shape, mdr.PowerLawGraded(1.0, 1.0, -0.4, NU))
    assert soft.at_radius(1.0).pressure(0.5) == np.inf


@pytest.mark.parametrize(("points", "end"), [(31, 0.5), (31, 1.0), (61, 0.4), (61, 0.7), (121, 0.4)])
def test_tables_that_begin_flat_are_found_from_depth_and_force(points, end):
    # beside the end the table rises as the square of the distance, and rounding leaves nothing of the depth there
    r = np.linspace(0.0, 3.0, points)
    for table in (mdr.TabulatedMDRProfile, mdr.TabulatedProfile):
        contact = mdr.Contact(table(r, 0.1 * np.maximum(r - end, 0.0)), mdr.Homogeneous(mdr.Elastic(100.0, 0.3)))
        state = contact.at_radius(np.array([1.001, 1.1, 1.9]) * end)
        np.testing.assert_allclose(contact.at_depth(state.depth).radius, state.radius, rtol=1e-11)
        np.testing.assert_allclose(contact.at_force(state.force).radius, state.radius, rtol=1e-11)
