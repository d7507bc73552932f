# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces with tension and plates: objects, limits, refusals, fits, problem files."""

import pickle
import re
import warnings

import numpy as np
import pytest
from scipy.special import j0, j1

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.problem import load

GEL = mdr.Elastic(0.75, 0.5)
"""E* = 1"""
TENSE = mdr.Surface(0.5)
BALL = mdr.Paraboloid(10.0)


STATES = [
    ("smooth", "flat", 0.3, 0.0, 0.019960218651104, 1.0, 0.011976131190662),
    ("smooth", "paraboloid", 0.3, 0.0, 0.019960218651104, 0.15841201552737, 0.0013909432368862),
    ("smooth", "paraboloid", 0.3, 8e-05, 0.019960218651104, 0.055097966922366, 0.00015364063695424),
    ("smooth", "flat", 1.0, 0.0, 0.018419438361791, 1.0, 0.036838876723583),
    ("smooth", "cone", 1.0, 0.0, 0.018419438361791, 1.5643265154427, 0.024864881242176),
    ("smooth", "paraboloid", 1.0, 8e-05, 0.018419438361791, 0.91109676226843, 0.018222939143143),
    ("film", "paraboloid", 0.3, 0.0, 23.406370030544, 0.29039579945618, 3.5076284237758),
    ("film", "cone", 0.3, 0.0, 23.406370030544, 1.1432904732664, 12.10800075081),
    ("film", "flat", 1.0, 0.0, 10.877043623871, 1.0, 21.754087247741),
    ("film", "paraboloid", 1.0, 0.0, 10.877043623871, 2.6621528871031, 47.719346404493),
    ("film", "paraboloid", 1.0, 0.531214776459776, 10.877043623871, 1.8292332399293, 29.599939729515),
]
"""Body, profile, a, work of adhesion, E_eff, d, F, from Chebyshev polynomials in another program."""
BONE = mdr.TransverselyIsotropic(23.4, 9.06, 9.11, 32.5, 9.12)


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
@pytest.mark.parametrize(("body", "profile", "a", "work", "modulus", "depth", "force"), STATES)
def test_reference_states_of_layers(body, profile, a, work, modulus, depth, force):
    """A gel on a smooth base, and a film with an axis; half-spaces and bonded gels are in the Fortran tests."""
    medium = {
        "smooth": lambda: mdr.Coated(mdr.Elastic(0.003, 0.5), 1.0, mdr.SMOOTH, surface=mdr.Surface(0.002)),
        "film": lambda: mdr.Coated(BONE, 1.0, mdr.Elastic(3.0, 0.4), surface=mdr.Surface(4.0)),
    }[body]()
    assert medium.modulus(a) == pytest.approx(modulus, rel=1e-9)
    tip = {"flat": mdr.FlatPunch(a), "cone": mdr.PowerLaw(1.0, 1.0), "paraboloid": mdr.Paraboloid(1.0)}[profile]
    contact = mdr.Contact(tip, medium, work_of_adhesion=work)
    state = contact.at_depth(1.0) if profile == "flat" else contact.at_radius(a)
    allowed = 1e-8 if profile == "cone" else 1e-9
    assert state.depth == pytest.approx(depth, rel=allowed)
    assert state.force == pytest.approx(force, rel=allowed)


@pytest.fixture(scope="module")
def half_space():
    return mdr.Homogeneous(GEL, surface=TENSE)


def test_values(half_space):
    assert half_space.surface == TENSE
    assert pickle.loads(pickle.dumps(half_space)) == half_space
    assert (
        repr(half_space)
        == "Homogeneous(material=Elastic(E=0.75, nu=0.5), surface=Surface(tension=0.5, bending=0.0, stretching=0.0))"
    )
    assert repr(mdr.Homogeneous(GEL)) == "Homogeneous(material=Elastic(E=0.75, nu=0.5))"
    assert mdr.Homogeneous(GEL, surface=mdr.Surface()) == mdr.Homogeneous(GEL)
    film = mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE)
    assert pickle.loads(pickle.dumps(film)) == film == film.replace(thickness=1.0)
    assert film.replace(surface=None) == mdr.Coated(GEL, 1.0, mdr.RIGID)


def test_a_layer_is_a_coating_and_a_thick_one_a_half_space(half_space):
    film = mdr.Coated(GEL, 1.0, mdr.Elastic(3.0, 0.3), surface=TENSE)
    stack = mdr.Layered([(GEL, 0.4), (GEL, 0.6)], mdr.Elastic(3.0, 0.3), surface=TENSE)
    assert stack.stiffness(0.8) == pytest.approx(film.stiffness(0.8), rel=1e-9)
    same = mdr.Coated(GEL, 1.0, GEL, surface=TENSE)
    assert same.stiffness(0.8) == pytest.approx(half_space.stiffness(0.8), rel=1e-10)
    thick = mdr.Coated(GEL, 1e5, mdr.RIGID, surface=TENSE)
    assert thick.stiffness(0.8) == pytest.approx(half_space.stiffness(0.8), rel=3e-5)


def test_a_small_tension_changes_little():
    bare, tense = mdr.Coated(GEL, 1.0, mdr.RIGID), mdr.Coated(GEL, 1.0, mdr.RIGID, surface=mdr.Surface(1e-3))
    ratio = tense.stiffness(0.5) / bare.stiffness(0.5)
    assert 1.0 < ratio < 1.02


def test_compliance(half_space):
    k = np.array([0.1, 1.0, 10.0])
    plate = mdr.Homogeneous(GEL, surface=mdr.Surface(0.5, 0.2))
    assert 1.0 / plate.compliance(k) == pytest.approx(1.0 / mdr.Homogeneous(GEL).compliance(k) + 0.5 * k**2 + 0.2 * k**4, rel=1e-13)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="for a pressure only"):
        half_space.compliance(k, load="shear")


@pytest.mark.parametrize("interface", [mdr.Interface(), mdr.SLIDING])
def test_a_thin_stiff_film_tends_to_a_plate(interface):
    """B = E h^3/(12 (1 - nu^2)); shear of the film, h^2 k^2, is what a plate leaves out: a second order. The base takes no part
    in the film's plane, nu = 1/2."""
    k, bending, nu = np.array([1.0, 3.0]), 0.3, 0.3
    plate = mdr.Homogeneous(GEL, surface=mdr.Surface(0.0, bending)).compliance(k)
    for h in (1e-2, 1e-3, 1e-4, 1e-5):
        film = mdr.Layer(mdr.Elastic(12.0 * bending * (1.0 - nu**2) / h**3, nu), h, interface=interface)
        error = mdr.Layered([film], GEL).compliance(k) / plate - 1.0
        assert np.all(np.abs(error) < 0.2 * (h * k) ** 2)
        assert error[1] > 0.1 * (3.0 * h) ** 2


class ByHankel:
    """What the pressure of a contact and its line force do outside, u = int k p^ C J0(k r) dk, p^ = int p r J0(k r) dr."""

    def __init__(self, contact, state, last=300.0, n=300):
        self.radius, self.compliance = state.radius, contact.medium.compliance
        t, weight = np.polynomial.legendre.leggauss(n)
        angle = 0.25 * np.pi * (1.0 + t)
        inside = 1.0 - 1e-15
        self.r = np.sin(angle)
        pressure = state.pressure(self.radius * self.r * inside)
        # a disc of even pressure and the line force have closed transforms, which need no end of their waves
        self.end = state.pressure(self.radius * inside)
        self.rings = (pressure - self.end) * self.r * np.cos(angle) * weight * 0.25 * np.pi
        self.line = state.force / (2.0 * np.pi * self.radius**2) - self.rings.sum() - 0.5 * self.end
        self.short, self.long = self.waves(last), self.waves(20.0 * last)

    @staticmethod
    def waves(last):
        ends = np.concatenate([[0.0], np.geomspace(1e-9, 0.5, 45), np.arange(1.0, last, 0.5)])
        t, weight = np.polynomial.legendre.leggauss(12)
        half = 0.5 * np.diff(ends)[:, None]
        return (ends[:-1, None] + half * (1.0 + t)).ravel(), (half * weight).ravel()

    def depth_of(self, waves, load, r):
        k, weight = waves
        spectrum = weight * k * load * self.compliance(k / self.radius)
        return np.array([spectrum @ j0(k * x) for x in r])

    def displacement(self, r):
        k = self.short[0]
        rings = np.concatenate([j0(np.outer(part, self.r)) @ self.rings for part in np.array_split(k, 20)])
        far = self.long[0]
        return self.depth_of(self.short, rings, r) + self.depth_of(self.long, self.line * j0(far) + self.end * j1(far) / far, r)

    def displacement_by_couple(self, r):
        """Of a ring couple of one unit of moment a length."""
        k = self.long[0]
        return self.depth_of(self.long, k * j1(k), r) / self.radius**2


OUTSIDE = np.array([1.0 + 1e-9, 1.01, 1.1, 1.5, 3.0])
TENSION_LIMITS = np.array([1e-7, 5e-8, 1e-8, 1e-9, 5e-10])
"""Under tension the waves of the pressure fall slowly, and the integral ends before they do."""


@pytest.mark.parametrize(
    ("medium", "a", "allowed"),
    [
        (mdr.Homogeneous(GEL, surface=TENSE), 1.0, TENSION_LIMITS),
        (mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE), 1.0, TENSION_LIMITS),
        (mdr.Coated(mdr.Elastic(1.0, 0.1), 1.0, mdr.RIGID, surface=mdr.Surface(0.5, 0.0, 1.0)), 1.0, TENSION_LIMITS),
        (mdr.Coated(mdr.Elastic(1.0, 0.1), 1.0, mdr.RIGID, surface=mdr.Surface(0.3, 0.005, 1.0)), 1.0, 1e-10),
        (mdr.Homogeneous(GEL, surface=mdr.Surface(0.0, 0.5)), 1.0, 1e-10),
        (mdr.Homogeneous(GEL, surface=mdr.Surface(0.0, 0.5)), 0.1, 1e-11),
        (mdr.Coated(GEL, 1.0, mdr.RIGID, surface=mdr.Surface(0.3, 0.005)), 1.0, 1e-10),
    ],
)
def test_displacement_outside_by_hankel_transforms(medium, a, allowed):
    contact = mdr.Contact(BALL, medium)
    state = contact.at_radius(a)
    found = state.displacement(OUTSIDE * a)
    hankel = ByHankel(contact, state)
    assert np.all(np.abs(found - hankel.displacement(OUTSIDE)) < allowed * state.depth)
    if medium.surface.bending == 0.0:
        assert abs(hankel.line) * 2.0 * np.pi * a**2 < 2e-7 * state.force


@pytest.mark.parametrize("tension", [0.0, 0.2])
def test_adhesion_under_a_plate_is_an_edge_couple(tension):
    """What pressure and line force leave of the displacement outside is that of a ring couple, and its moment opens the edge at
    the cost of the adhesion, M^2/(2 B) = gamma."""
    bending, work = 0.05, 1e-3
    contact = mdr.Contact(BALL, mdr.Homogeneous(GEL, surface=mdr.Surface(tension, bending)), work_of_adhesion=work)
    state = contact.at_radius(1.0)
    hankel = ByHankel(contact, state)
    moment = (state.displacement(OUTSIDE) - hankel.displacement(OUTSIDE)) / hankel.displacement_by_couple(OUTSIDE)
    assert moment == pytest.approx(np.sqrt(2.0 * bending * work), rel=1e-7)
    assert np.ptp(moment) < 1e-8 * moment[0]


def test_states_are_found_from_depth_force_and_radius(half_space):
    for medium in (half_space, mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE), mdr.Homogeneous(GEL, surface=mdr.Surface(0.1, 0.1))):
        contact = mdr.Contact(BALL, medium)
        state = contact.at_radius(0.7)
        assert contact.at_depth(state.depth).radius == pytest.approx(0.7, rel=1e-8)
        assert contact.at_force(state.force).radius == pytest.approx(0.7, rel=1e-8)


def test_work_of_the_force_and_the_law(half_space):
    contact = mdr.Contact(BALL, half_space)
    law = mdr.ContactLaw(contact, 0.2)
    for depth in (0.013, 0.11, 0.19):
        assert law.at_depth(depth).force == pytest.approx(contact.at_depth(depth).force, rel=1e-6)


@pytest.mark.parametrize("profile", [mdr.Sphere(3.0), mdr.FlatEndedCone(0.3, 0.1), mdr.FlatEndedParaboloid(0.3, 2.0)])
def test_shapes_without_powers(half_space, profile):
    """dF = k dd along the radius."""
    contact = mdr.Contact(profile, half_space)
    a = 0.8 * (1.0 + 1e-3 * np.array([-1.0, 0.0, 1.0]))
    state = contact.at_radius(a)
    assert np.diff(state.force)[[0, 1]].sum() == pytest.approx(state.stiffness[1] * (state.depth[2] - state.depth[0]), rel=1e-5)


def test_a_sphere_is_a_paraboloid_near_its_axis(half_space):
    sphere, ball = (mdr.Contact(shape, half_space).at_radius(0.05) for shape in (mdr.Sphere(10.0), BALL))
    assert sphere.depth == pytest.approx(ball.depth, rel=2e-5)
    assert sphere.force == pytest.approx(ball.force, rel=2e-5)


def test_wetting_warns():
    contact = mdr.Contact(mdr.Paraboloid(1e3), mdr.Homogeneous(GEL, surface=TENSE), work_of_adhesion=0.03)
    with pytest.warns(mdr.errors.LargeStrainWarning, match="surface tension"):
        contact.at_radius(1.0)


@pytest.mark.slow
def test_wetting_under_a_plate_warns_where_slopes_are_large():
    """Of the surface beside an adhesive edge: u'(r) there against the indenter's slope, 0 of a flat punch under no load."""
    for bending, work in ((0.05, 0.02), (1e-3, 5e-3)):
        medium = mdr.Homogeneous(GEL, surface=mdr.Surface(0.0, bending))
        holds = bending ** (1 / 3) * 0.5 ** (2 / 3)
        steepest = []
        for gamma in (work, 0.04 * holds):
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                contact = mdr.Contact(mdr.Paraboloid(1e3), medium, work_of_adhesion=gamma)
                state = contact.at_radius(2.0)
            r = np.linspace(2.0, 4.0, 17)
            steepest.append(np.abs(np.gradient(state.displacement(r), r)).max())
            assert any("what bends the plate" in str(w.message) for w in said) == (gamma > 0.05 * holds)
        assert 0.3 < steepest[0] / np.sqrt(2.0 * work / holds) < 2.0


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(-0.1)), "wrinkles"),
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(-1.0, 1e-3)), "tau_c = .* k_c = "),
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(0.1, -1e-3)), "bending"),
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(np.nan)), "tension"),
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(1e300, 1e-6)), "between 1e-90 and 1e90"),
        (lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, surface=mdr.Surface(5e-324)), "between 1e-90 and 1e90"),
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(stretching=-1.0)), "stretching"),
        (lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(stretching=np.inf)), "stretching"),
        (lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, surface=mdr.Surface(stretching=1e13)), "factor 1e12"),
        (lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, "gao", surface=mdr.Surface(stretching=1.0)), "exact"),
        (lambda: mdr.Homogeneous(GEL, surface=3.0), "Surface"),
        (lambda: mdr.Homogeneous(mdr.PowerLawRheology(1.0, 1.0, 0.2, 0.5), surface=TENSE), "Elastic"),
        (lambda: mdr.Coated(GEL, 1.0, mdr.Elastic(1.0, 0.3), "gao", surface=TENSE), "exact"),
        (lambda: mdr.Pair(mdr.Homogeneous(GEL, surface=TENSE), mdr.Homogeneous(GEL)), "pair"),
        (lambda: mdr.Pair(mdr.Homogeneous(GEL), mdr.Homogeneous(GEL, surface=TENSE)), "pair"),
    ],
)
def test_refused_bodies(make, words):
    with pytest.raises(mdr.MDRError, match=words):
        make()


@pytest.mark.parametrize("bending", [0.01, 0.05, 0.3, 2.0])
def test_the_critical_tension_of_a_film(bending):
    """min over k of 1/(k^2 C) + B k^2, looked for anew between two wavenumbers."""
    film = mdr.Coated(GEL, 1.0, mdr.RIGID)
    k = np.geomspace(0.1, 20.0, 100_001)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="wrinkles") as refusal:
        film.replace(surface=mdr.Surface(-1e3, bending))
    critical = float(re.search(r"tau_c = (\S+) and", str(refusal.value))[1])
    assert critical == pytest.approx(-np.min(1.0 / (k**2 * film.compliance(k)) + bending * k**2), rel=1e-6)


def test_refused_answers(half_space):
    contact = mdr.Contact(BALL, half_space)
    state = contact.at_radius(0.5)
    for request in (
        lambda: half_space.tangential_modulus(1.0),
        lambda: half_space.torsional_stiffness(1.0),
        lambda: mdr.Friction(contact, 0.3),
        lambda: state.interior(0.1, 0.1),
        lambda: state.gradient(),
        lambda: mdr.Contact(BALL, half_space, work_of_adhesion=0.01, cohesive_stress=0.1),
        lambda: mdr.Contact(BALL, half_space).at_radius(1200.0),
    ):
        with pytest.raises(mdr.MDRError):
            request()


def test_films_narrower_than_a_plate_bends():
    """Many cosines over a short piece of Phi: a film of the base's material is a half-space."""
    plate = mdr.Surface(1.0, 1.0)
    film, half_space = mdr.Coated(GEL, 0.3, GEL, surface=plate), mdr.Homogeneous(GEL, surface=plate)
    assert film.stiffness(0.4) == pytest.approx(half_space.stiffness(0.4), rel=1e-11)
    assert mdr.Coated(GEL, 0.3, mdr.RIGID, surface=plate).stiffness(0.4) > half_space.stiffness(0.4)


def test_adhesion_begins_at_any_radius():
    """A search for pull-off goes down to radii whose waves have no Bessel functions in the range of numbers."""
    film = mdr.Coated(GEL, 6.0, mdr.RIGID, surface=mdr.Surface(0.1))
    assert film.modulus(1e-200) > 0.0


def test_no_tip_under_a_plate_makes_one_disc(half_space):
    """B lap lap f pulls at the apex of a cone, and depth falls while the radius grows; a paraboloid has none of it."""
    plate = mdr.Homogeneous(GEL, surface=mdr.Surface(0.0, 0.5))
    cone = mdr.Contact(mdr.PowerLaw(1.0, 0.1), plate)
    with pytest.warns(mdr.errors.SeparationInsideWarning, match="a plate does not follow a tip"):
        first, second = cone.at_radius([0.1, 0.3]).depth
    assert second < first
    with pytest.raises(mdr.errors.UnreachableError, match=r"at radius 0\.01, where the medium begins, the depth is 2\.5"):
        cone.at_depth(1e-3)
    assert mdr.Contact(BALL, plate).at_radius(0.3).lowest_pressure()[0] == 0.0


def test_a_plate_under_tension_ends_by_its_own_length():
    with pytest.raises(mdr.errors.DomainError, match=r"200 lengths \(B/tau\)\^\(1/2\)"):
        mdr.Homogeneous(GEL, surface=mdr.Surface(1e3, 1e-6)).stiffness(1.0)


def test_fit_of_tension_and_modulus_together(half_space):
    depth = np.linspace(0.01, 0.5, 20)
    data = mdi.ForceDepth(depth, mdr.Contact(BALL, half_space).at_depth(depth).force)
    start = mdr.Homogeneous(mdr.Elastic(0.5, 0.5), surface=mdr.Surface(0.2))
    found = mdi.fit(data, BALL, start, free=["E", "surface.tension"])
    assert found.estimates["E"] == pytest.approx(0.75, rel=1e-6)
    assert found.estimates["surface.tension"] == pytest.approx(0.5, rel=1e-6)


@pytest.mark.parametrize(
    ("body", "free"),
    [
        (mdr.Coated(BONE, 1.0, mdr.Elastic(3.0, 0.4), surface=mdr.Surface(4.0)), ("coating.C33", "surface.tension")),
        (mdr.Coated(GEL, 0.5, mdr.RIGID, surface=mdr.Surface(0.0, 0.05)), ("thickness", "surface.bending")),
        (mdr.Homogeneous(BONE, surface=mdr.Surface(4.0)), ("C44", "surface.tension")),
        (
            mdr.Coated(mdr.Elastic(1.0, 0.2), 0.5, mdr.RIGID, surface=mdr.Surface(stretching=0.3)),
            ("thickness", "surface.stretching"),
        ),
    ],
)
def test_fit_of_a_surface_with_any_constant_of_the_body(body, free):
    depth = np.geomspace(1e-2, 0.1, 6)
    data = mdi.ForceDepth(depth, mdr.Contact(BALL, body).at_depth(depth).force)
    values = body.parameters()
    start = body.with_parameters({name: 1.1 * values[name] for name in free})
    assert start.parameters() == values | {name: 1.1 * values[name] for name in free}
    found = mdi.fit(data, BALL, start, free=list(free))
    for name in free:
        assert found.estimates[name] == pytest.approx(values[name], rel=1e-5)


def test_problem_file(tmp_path):
    path = tmp_path / "gel.toml"
    path.write_text(
        '[indenter]\nshape = "paraboloid"\nradius = "10 um"\n\n[medium]\ntype = "homogeneous"\nsurface_tension = "30 mN/m"\n'
        'surface_bending = "1e-18 N*m"\nsurface_stretching = "2 N/m"\n'
        '\n[medium.material]\nE = "3 kPa"\nnu = 0.5\n\n[compute]\nmax_depth = "1 um"\npoints = 5\n',
        encoding="utf-8",
    )
    medium = load(path).medium
    assert medium.surface == mdr.Surface(0.03, 1e-18, 2.0)
