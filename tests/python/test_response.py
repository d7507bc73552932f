# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of a body in space: by a point force, by a pressure on a rectangle, and the limits of its compliance."""

import csv
import math
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss
from scipy.special import j0

import mdrcontact as mdr

DATA = Path(__file__).resolve().parents[1] / "data" / "engines.csv"
BASE = mdr.Elastic(1.0, 0.3)
SPRINGS = mdr.Layer(mdr.Elastic(10.0, 0.3), 1.0, interface=mdr.Interface(normal=0.02, tangential=0.05))


def film(ratio):
    return mdr.Coated(mdr.Elastic(ratio, 0.3), 1.0, BASE)


def rigid(nu):
    return mdr.Layered([(mdr.Elastic(1.0, nu), 1.0)], mdr.RIGID)


BODIES = {
    "film_0.1": film(0.1),
    "film_10": film(10.0),
    "film_100": film(100.0),
    "rigid_nu0.3": rigid(0.3),
    "rigid_nu0.49": rigid(0.49),
}
OTHERS = {
    "graded": mdr.Graded([0.0, 1.0], [4.0, 1.0], [0.3, 0.3]),
    "springs": mdr.Layered([SPRINGS], BASE),
    "layers": mdr.Layered([(mdr.Elastic(10.0, 0.3), 0.1), (mdr.Elastic(1.0, 0.3), 1.0)], mdr.Elastic(5.0, 0.3)),
    "tension": mdr.Homogeneous(mdr.Elastic(1.0, 0.5), surface=mdr.Surface(tension=1.0)),
    "plate": film(10.0).replace(surface=mdr.Surface(tension=0.5, bending=0.1)),
    "sheet": mdr.Homogeneous(BASE, surface=mdr.Surface(stretching=0.5)),
    "axial": mdr.Coated(mdr.TransverselyIsotropic(3.4, 1.2, 1.0, 2.6, 0.8), 1.0, BASE),
    "pair": mdr.Pair(film(0.1), film(10.0)),
}
ROWS = list(csv.DictReader(line for line in DATA.read_text().splitlines() if not line.startswith("#")))


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row['body']}, {row['inputs']}")
def test_point_forces_agree_with_a_quadrature(row):
    medium, r = BODIES[row["body"]], float(row["inputs"].removeprefix("r="))
    # the digits given, and the error stated: of k C/2, at each of the 5 octaves of k that matter
    allowed = 5e-10 * abs(float(row["value"])) + 2.0 * medium.response_error() * max(medium.compliance_limits()[:2]) / r
    assert medium.point_response(r) == pytest.approx(float(row["value"]), rel=0.0, abs=allowed)


@pytest.mark.parametrize("name", [*BODIES, *OTHERS])
def test_a_pressure_that_falls_with_distance_needs_no_images(name):
    """The load r -> exp(-r^2/2), of transform exp(-k^2/2): int k C exp(-k^2/2) dk on the axis is int u(r) exp(-r^2/2) 2 pi r dr."""
    medium = (BODIES | OTHERS)[name]
    x, w = leggauss(60)
    edges = np.geomspace(1e-7, 9.0, 40)
    t = np.concatenate([0.5 * ((b - a) * x + a + b) for a, b in zip(edges[:-1], edges[1:], strict=True)])
    v = np.concatenate([0.5 * (b - a) * w for a, b in zip(edges[:-1], edges[1:], strict=True)])
    by_waves = np.sum(v * t * medium.compliance(t) * np.exp(-0.5 * t**2))
    in_space = np.sum(v * 2.0 * math.pi * t * medium.point_response(t) * np.exp(-0.5 * t**2))
    # the integral in space begins at r = 1e-7
    assert in_space == pytest.approx(by_waves, rel=1e-6)


@pytest.mark.parametrize("r", [0.3, 1.7])
def test_a_point_force_on_a_film_by_hankel_transform(r):
    """1/(pi E* r) and the transform of what the base adds, which falls as exp(-2 k)."""
    medium = film(10.0)
    x, w = leggauss(400)
    k, v = 10.0 * (x + 1.0), 10.0 * w
    own = 2.0 * medium.compliance_limits().short
    added = np.sum(v * (k * medium.compliance(k) - own) * j0(k * r)) / (2.0 * math.pi)
    assert medium.point_response(r) == pytest.approx(own / (2.0 * math.pi * r) + added, rel=1e-9)


def love(x, y, a, b):
    """(1/pi) int int 1/r over a rectangle of half sides a and b."""

    def corner(X, Y):
        return X * np.arcsinh(Y / np.abs(X)) + Y * np.arcsinh(X / np.abs(Y))

    return (corner(x + a, y + b) - corner(x - a, y + b) - corner(x + a, y - b) + corner(x - a, y - b)) / math.pi


@pytest.mark.parametrize("body", [mdr.Homogeneous(BASE), film(1.0)])
def test_equal_halves_are_loves_rectangle(body):
    # no edge meets a point, where the formula above is 0/0
    x, y = np.meshgrid(np.arange(-40, 41) * 0.7, np.arange(-40, 41) * 0.3)
    exact = love(x, y, 0.33, 0.55) * 0.91
    found = body.rectangle_response(x, y, (0.66, 1.1))
    assert np.abs(found - exact).max() < 1e-12 * exact.max()
    assert body.response_error() == 0.0
    # at a corner and on an edge
    assert body.rectangle_response(0.33, 0.55, (0.66, 1.1)) == pytest.approx(love(0.33, 0.55 - 1e-13, 0.33 - 1e-14, 0.55) * 0.91)
    assert body.rectangle_response(0.0, 0.0, 2.0) == pytest.approx(8.0 * math.asinh(1.0) / math.pi * 0.91, rel=1e-14)


@pytest.mark.parametrize("name", ["film_0.1", "film_10", "rigid_nu0.49", "graded", "pair"])
@pytest.mark.parametrize("point", [(3.0, 1.0), (0.9, 2.0), (14.0, 5.0), (0.0, 0.9)])
def test_a_rectangle_is_the_integral_of_point_forces(name, point):
    medium = (BODIES | OTHERS)[name]
    width, height = 1.2, 0.5
    x, w = leggauss(60)
    along, up = 0.5 * width * x, 0.5 * height * x
    r = np.hypot(point[0] - along[:, None], point[1] - up)
    integral = np.sum(0.25 * width * height * np.outer(w, w) * medium.point_response(r))
    centre = medium.rectangle_response(0.0, 0.0, (width, height))
    # the weights of images reach 1e5
    assert medium.rectangle_response(*point, (width, height)) == pytest.approx(integral, rel=0.0, abs=3e-11 * centre)


@pytest.mark.parametrize("name", ["film_10", "rigid_nu0.49", "layers"])
@pytest.mark.parametrize("around", [2.25, 32.0])
def test_the_ways_to_compute_a_rectangle_join(name, around):
    """Third differences over the distance at which one way replaces the other, and symmetry."""
    medium = (BODIES | OTHERS)[name]
    centre = medium.rectangle_response(0.0, 0.0, 1.0)
    x = around + 1e-4 * np.arange(-10, 11)
    found = medium.rectangle_response(x, 0.0, 1.0)
    assert np.abs(np.diff(found, 3)).max() < 1e-10 * centre
    np.testing.assert_array_equal(found, medium.rectangle_response(-x, -0.0, 1.0))
    np.testing.assert_allclose(found, medium.rectangle_response(0.0, x, 1.0), 0.0, 1e-10 * centre)
    wide, turned = medium.rectangle_response(x, 0.2, (1.0, 2.0)), medium.rectangle_response(0.2, x, (2.0, 1.0))
    np.testing.assert_allclose(wide, turned, 0.0, 1e-10 * centre)


def test_small_rectangles_are_point_forces():
    medium = film(10.0)
    assert medium.rectangle_response(0.7, 0.4, 1e-4) / 1e-8 == pytest.approx(medium.point_response(math.hypot(0.7, 0.4)), rel=1e-8)


@pytest.mark.parametrize("name", [*BODIES, *OTHERS])
def test_the_limits_are_those_of_the_compliance(name):
    medium = (BODIES | OTHERS)[name]
    short, long, rest = medium.compliance_limits()
    k = 1e-3 * np.array([1.0, 0.5, 0.25, 0.125])
    # C - 2 long/k at k = 0 by extrapolation
    values = medium.compliance(k) - 2.0 * long / k
    for order in (1, 2, 3):
        values = (2.0**order * values[1:] - values[:-1]) / (2.0**order - 1.0)
    assert values[0] == pytest.approx(rest, rel=3e-5, abs=1e-9)
    assert 1e12 * medium.compliance(1e12) / 2.0 == pytest.approx(short, rel=1e-6, abs=1e-11)


def test_limits_have_their_closed_forms():
    """A layer under uniform pressure is h/M softer than the half-space, less what a half-space would have there."""
    G, nu = 1.0 / 2.6, 0.3
    oedometric = 2.0 * G * (1.0 - nu) / (1.0 - 2.0 * nu)
    assert rigid(0.3).compliance_limits() == pytest.approx((0.91, 0.0, 1.0 / oedometric), rel=1e-14)
    assert rigid(0.3).compliance([0.0, 1e-9]) == pytest.approx(1.0 / oedometric, rel=1e-8)
    assert rigid(0.5).compliance(0.0) == 0.0
    springs = mdr.Layered([mdr.Layer(mdr.Elastic(1.0, 0.3), 1.0, interface=mdr.Interface(normal=0.02, tangential=0.05))], mdr.RIGID)
    assert springs.compliance(0.0) == pytest.approx(1.0 / oedometric + 50.0, rel=1e-12)
    assert mdr.Homogeneous(BASE).compliance_limits() == pytest.approx((0.91, 0.91, 0.0), rel=1e-15)
    # shear of a layer on a rigid base: h/G
    assert rigid(0.3).compliance(0.0, "twist") == pytest.approx(1.0 / G, rel=1e-14)
    assert rigid(0.3).compliance(0.0, "shear") == pytest.approx(1.0 / G, rel=1e-12)


def test_a_relaxing_film_at_a_frequency():
    gel = mdr.Viscoelastic(1e3, [(2e3, 0.1)], nu=0.5)
    base = mdr.Elastic(1e4, 0.3)
    medium = mdr.Coated(gel, 0.3, base)
    relaxed = mdr.Coated(mdr.Elastic(3e3, 0.5), 0.3, base)
    assert medium.compliance_limits() == pytest.approx(relaxed.compliance_limits(), rel=1e-9)
    np.testing.assert_allclose(medium.point_response([0.1, 1.0]), relaxed.point_response([0.1, 1.0]), 1e-9)
    short, long, rest = medium.compliance_limits(7.0)
    assert short == pytest.approx(0.25 / gel.complex_modulus(7.0), rel=1e-13)
    k = 1e-4
    assert medium.compliance(k, omega=7.0) - 2.0 * long / k == pytest.approx(rest, rel=1e-3)
    assert abs(rest.imag) > 0.01 * abs(rest)


def test_bad_input_is_refused():
    medium = film(10.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="r = 0"):
        medium.point_response(0.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="width = -1"):
        medium.rectangle_response(0.0, 0.0, (-1.0, 1.0))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="size = "):
        medium.rectangle_response(0.0, 0.0, (1.0, 1.0, 1.0))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="x = NaN"):
        medium.rectangle_response(math.nan, 0.0, 1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="y = infinity"):
        medium.rectangle_response(0.0, math.inf, 1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="tolerance = 0"):
        medium.response_error(0.0)
    with pytest.raises(mdr.errors.NoConvergenceError, match="240 images have an error of"):
        medium.response_error(1e-14)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="k = 0: the compliance is infinite there"):
        medium.compliance(0.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 2 of k = 0"):
        medium.compliance([1.0, 0.0])
    sliding = mdr.Layered([mdr.Layer(BASE, 1.0, interface=mdr.Interface(tangential=0.0))], mdr.RIGID)
    assert sliding.compliance(0.0) == pytest.approx(0.91, rel=1e-12)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="k = 0"):
        sliding.compliance(0.0, "shear")
    for body in (
        mdr.Homogeneous(mdr.poroelastic.Poroelastic(2.0, 0.2, 3.0)),
        mdr.TabulatedMedium([0.1, 0.5, 1.0], [1.0, 1.5, 2.0]),
    ):
        for ask in (body.compliance_limits, body.response_error, lambda body=body: body.point_response(1.0)):
            with pytest.raises(mdr.errors.InvalidArgumentError, match="Use "):
                ask()


def test_shapes():
    medium = film(10.0)
    assert isinstance(medium.point_response(1.0), float)
    assert isinstance(medium.rectangle_response(1.0, 2.0, 1.0), float)
    assert medium.point_response([]).shape == (0,)
    assert medium.rectangle_response([], 1.0, 1.0).shape == (0,)
    assert medium.rectangle_response(np.zeros((3, 1)), np.ones(2), 1.0).shape == (3, 2)
