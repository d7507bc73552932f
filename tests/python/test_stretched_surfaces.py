# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are stiff in their plane, K_m: two discretisations, limits, thin stiff films, what they do not answer."""

import re

import numpy as np
import pytest
from scipy.special import spherical_jn

import mdrcontact as mdr

NU = 0.3
BODY = mdr.Elastic(1.0 - NU**2, NU)
"""E* = 1"""
RATIO = 4.0 * (1.0 - NU) ** 2 / (3.0 - 4.0 * NU)
"""What a surface that cannot move sideways has of E*."""


def stretched(stretching, material=BODY, **others):
    return mdr.Homogeneous(material, surface=mdr.Surface(stretching=stretching, **others))


def in_waves(chi, a, n):
    """E_eff over the modulus of short waves by n even Legendre polynomials, H_ij an integral over k of products of spherical
    Bessel functions, which falls as 1/k^3 with chi."""
    last, length = 4000.0, 0.5
    t, w = np.polynomial.legendre.leggauss(12)
    edges = np.concatenate([[0.0], np.geomspace(1e-8, length, 40), np.arange(2.0 * length, last, length)])
    k = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (1.0 + t)).ravel()
    weight = (0.5 * np.diff(edges)[:, None] * w).ravel() * chi(k / a)
    j = np.arange(n)
    s = np.sqrt((4.0 * j + 1.0) / 2.0) * (-1.0) ** j
    waves = s[:, None] * np.array([spherical_jn(2 * m, k) for m in j])
    matrix = 4.0 / np.pi * (waves * weight) @ waves.T
    # beyond: chi = c/(k l), cos^2 in the mean
    tail = chi(np.array([last / a]))[0] / (4.0 * last)
    matrix += 4.0 / np.pi * np.outer(s, s) * (-1.0) ** (j[:, None] + j) * tail
    matrix += np.eye(n)
    one = np.zeros(n)
    one[0] = np.sqrt(2.0)
    return one @ np.linalg.solve(matrix, one) / 2.0


@pytest.mark.parametrize("nu", [0.0, 0.3, -0.6])
@pytest.mark.parametrize("a", [0.2, 1.0, 4.0])
def test_flat_punches_by_waves(nu, a):
    """l = 1, c = (1 - 2 nu)^2/(3 - 4 nu): chi = c/(1 + k)."""
    c = (1.0 - 2.0 * nu) ** 2 / (3.0 - 4.0 * nu)
    expected = in_waves(lambda k: c / (1.0 + k), a, 30)
    assert stretched(0.5, mdr.Elastic(1.0 - nu**2, nu)).modulus(a) == pytest.approx((1.0 + c) * expected, rel=3e-8)


@pytest.mark.parametrize(
    "body",
    [
        mdr.Coated(mdr.Elastic(1.0, 0.2), 0.7, mdr.RIGID),
        mdr.Layered([(mdr.Elastic(1.0, 0.2), 0.7), (mdr.Elastic(0.1, 0.5), 0.4)], mdr.Elastic(3.0, 0.3)),
        mdr.Layered([mdr.Layer(mdr.TransverselyIsotropic(23.4, 9.06, 9.11, 32.5, 9.12), 0.7, interface=mdr.SLIDING)], BODY),
    ],
)
def test_layers_by_waves(body):
    """The same from the compliance that the medium says it has."""
    medium = body.replace(surface=mdr.Surface(stretching=2.0))
    far = np.array([1e9])
    modulus = (2.0 / (far * medium.compliance(far)))[0]

    def chi(k):
        return 0.5 * modulus * k * medium.compliance(k) - 1.0

    a = 0.8
    assert medium.modulus(a) == pytest.approx(modulus * in_waves(chi, a, 30), rel=3e-8)


def test_compliance_of_a_half_space():
    """k C = 2 (1 + q (1 - r^2))/(1 + q) with q = K_m k C_L and r = (1 - 2 nu)/(2 (1 - nu))."""
    k, stretching, r = np.geomspace(1e-4, 1e4, 9), 0.7, (1.0 - 2.0 * NU) / (2.0 * (1.0 - NU))
    q = stretching * k * 2.0
    assert stretched(stretching).compliance(k) * k == pytest.approx(2.0 * (1.0 + q * (1.0 - r**2)) / (1.0 + q), rel=1e-14)


@pytest.mark.parametrize("others", [{}, {"tension": 0.05}, {"bending": 0.02}])
def test_limits_of_the_stiffness(others):
    """To a body without the sheet, and to an inextensible surface by ln(l)/l: of X = -(c/l) (ln(y/l) + gamma) a flat punch takes
    (2 c a/(pi l)) (ln(l/(2 a)) + 3/2 - gamma)."""
    bare = mdr.Homogeneous(BODY, surface=mdr.Surface(**others) if others else None).modulus(1.0)
    weak = [stretched(1e-2 * part, **others).modulus(1.0) / bare - 1.0 for part in (1.0, 0.1)]
    assert 0.0 < weak[1] < 0.2 * weak[0] < 1e-2
    held = mdr.Homogeneous(mdr.Elastic(BODY.E * RATIO, NU), surface=mdr.Surface(**others) if others else None).modulus(1.0)
    length = 2.0 * np.array([1e3, 1e4])
    strong = 1.0 - np.array([stretched(0.5 * x, **others).modulus(1.0) / held for x in length])
    expected = 2.0 * (RATIO - 1.0) / (np.pi * length) * (np.log(length / 2.0) + 1.5 - 0.57721566)
    if others:
        assert strong == pytest.approx(expected, rel=0.35)
        assert strong[1] / strong[0] == pytest.approx(expected[1] / expected[0], rel=0.02)
    else:
        assert strong == pytest.approx(expected, rel=1e-3)


def test_incompressible_half_spaces_do_not_mind():
    gel = mdr.Elastic(0.75, 0.5)
    assert stretched(3.0, gel).modulus(2.0) == pytest.approx(1.0, rel=1e-15)
    tense = mdr.Homogeneous(gel, surface=mdr.Surface(0.5)).modulus(2.0)
    assert stretched(3.0, gel, tension=0.5).modulus(2.0) == pytest.approx(tense, rel=1e-13)
    # of a film the surface does move
    film = mdr.Coated(gel, 1.0, mdr.RIGID)
    assert film.replace(surface=mdr.Surface(stretching=3.0)).modulus(2.0) > 1.05 * film.modulus(2.0)


def test_a_thin_stiff_film_tends_to_a_sheet():
    """K_m = E h/(1 - nu^2), bonded: its half-thickness below it is what a sheet leaves out, of the first order."""
    k, stretching, nu = np.array([2.0]), 0.1, 0.3
    sheet = stretched(stretching).compliance(k)
    errors = []
    for h in (1e-3, 1e-4, 1e-5):
        film = mdr.Layer(mdr.Elastic(stretching * (1.0 - nu**2) / h, nu), h)
        errors.append((mdr.Layered([film], BODY).compliance(k) / sheet - 1.0)[0])
    assert 1e-5 < abs(errors[0]) < 2e-3
    assert errors[1] == pytest.approx(0.1 * errors[0], rel=0.02)
    assert errors[2] == pytest.approx(0.01 * errors[0], rel=0.02)


def test_a_thin_stiff_film_under_a_ball():
    """Of a plate with the film's two stiffnesses."""
    stretching, nu = 0.1, 0.3
    ratios = []
    for h in (0.01, 0.005):
        film = mdr.Layered([mdr.Layer(mdr.Elastic(stretching * (1.0 - nu**2) / h, nu), h)], BODY)
        sheet = stretched(stretching, bending=stretching * h**2 / 12.0)
        ball = mdr.Paraboloid(100.0)
        ratios.append(mdr.Contact(ball, film).at_radius(1.0).force / mdr.Contact(ball, sheet).at_radius(1.0).force - 1.0)
    assert abs(ratios[0]) < 0.01
    assert abs(ratios[1]) < 0.5 * abs(ratios[0])


@pytest.mark.parametrize("bending", [1e-3, 1e-6])
def test_wrinkling_of_a_bonded_plate(bending):
    """Its stiffness in the plane fixes the surface: (4 (1 - nu)^2/(3 - 4 nu))^(2/3) times Chen and Hutchinson's stress."""
    with pytest.raises(mdr.errors.InvalidArgumentError, match="wrinkles") as refusal:
        stretched(1e6 * bending ** (1.0 / 3.0), tension=-1e3, bending=bending)
    critical = float(re.search(r"tau_c = (-\S+)", str(refusal.value))[1])
    assert critical / (-3.0 * bending * (0.25 / bending) ** (2.0 / 3.0)) == pytest.approx(RATIO ** (2.0 / 3.0), rel=1e-5)


def test_tensions_that_vanish_leave_springs():
    """Two solvers: k of tension tau and 2 tau, and what they tend to with tau ln tau."""
    bare = stretched(0.4).modulus(1.0)
    near = [stretched(0.4, tension=tau).modulus(1.0) / bare - 1.0 for tau in (1e-3, 2e-3)]
    # x = l/(pi a) (ln(2 a/l) + gamma + 1), l = 2 tau/E0* with the modulus that the edge meets
    x = [2.0 * tau / RATIO / np.pi * (np.log(RATIO / tau) + 1.57721566) for tau in (1e-3, 2e-3)]
    assert near[0] / near[1] == pytest.approx(x[0] / x[1], rel=5e-3)
    assert near[0] == pytest.approx(x[0], rel=0.1)


@pytest.mark.parametrize("medium", [stretched(0.5), mdr.Coated(BODY, 1.0, mdr.RIGID, surface=mdr.Surface(0.0, 0.0, 0.5))])
def test_states_pressure_and_adhesion(medium):
    contact = mdr.Contact(mdr.Paraboloid(10.0), medium)
    state = contact.at_radius(0.7)
    assert contact.at_depth(state.depth).radius == pytest.approx(0.7, rel=1e-9)
    assert contact.at_force(state.force).radius == pytest.approx(0.7, rel=1e-9)
    t, w = np.polynomial.legendre.leggauss(60)
    angle = 0.25 * np.pi * (1.0 + t)
    r = 0.7 * np.sin(angle)
    total = 2.0 * np.pi * (state.pressure(r) * r * 0.7 * np.cos(angle)) @ w * 0.25 * np.pi
    assert total == pytest.approx(state.force, rel=1e-8)
    sticky = mdr.Contact(mdr.Paraboloid(10.0), medium, work_of_adhesion=1e-3)
    # d - d0 = -sqrt(4 pi a gamma/k'), k' = dk/da by differences
    stiffness = medium.stiffness(0.7 * np.array([1.0 - 1e-4, 1.0 + 1e-4]))
    slope = np.diff(stiffness)[0] / 1.4e-4
    assert sticky.at_radius(0.7).depth == pytest.approx(state.depth - np.sqrt(4.0 * np.pi * 0.7 * 1e-3 / slope), rel=1e-7)
    assert sticky.pull_off("force").force < 0.0
    law = mdr.ContactLaw(contact, 1.2 * float(state.depth))
    assert law.at_depth(0.9 * state.depth).force == pytest.approx(contact.at_depth(0.9 * state.depth).force, rel=1e-6)


def test_refused_answers():
    medium = stretched(0.5)
    contact = mdr.Contact(mdr.Paraboloid(10.0), medium)
    state = contact.at_radius(0.5)
    for request in (
        lambda: medium.tangential_modulus(1.0),
        lambda: medium.torsional_stiffness(1.0),
        lambda: medium.compliance(1.0, load="shear"),
        lambda: mdr.Friction(contact, 0.3),
        lambda: state.interior(0.1, 0.1),
        lambda: state.energy(body="lower"),
        lambda: state.gradient(),
        lambda: mdr.Contact(mdr.Paraboloid(10.0), medium, work_of_adhesion=0.01, cohesive_stress=0.1),
        lambda: mdr.Pair(medium, mdr.Homogeneous(BODY)),
        lambda: mdr.Homogeneous(mdr.PowerLawRheology(1.0, 1.0, 0.2, 0.4), surface=mdr.Surface(stretching=1.0)),
        lambda: contact.at_radius(1200.0),
    ):
        with pytest.raises(mdr.MDRError):
            request()


def test_numbers_too_far_apart_end():
    """The product of bending and stretching is below all numbers: LAPACK balanced the matrix of the poles for ever."""
    with pytest.raises(mdr.errors.NoConvergenceError, match="poles"):
        mdr.Homogeneous(mdr.Elastic(2.8, -0.05), surface=mdr.Surface(2e-313, 1e-207, 5e-192))
