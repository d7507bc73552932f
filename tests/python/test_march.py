# SPDX-License-Identifier: GPL-3.0-or-later
"""Marched histories: any rheology, flat ends, prescribed radii, against flat punches by the inverse Laplace transform and Ting."""

import math

import numpy as np
import pytest

import mdrcontact as mdr

POLYMER = mdr.Viscoelastic(0.6, [(0.4, 2.0)], nu=0.3)
GEL = mdr.PowerLawRheology(1.0, 1.0, 0.2, nu=0.5)
LIQUID = mdr.Viscoelastic(0.0, [(0.7, 0.5), (0.2, 3.0)], nu=0.5)
KELVIN = mdr.Viscoelastic(1.0, [], nu=0.4, viscosity=0.5)
HARD = mdr.Elastic(10.0, 0.3)
BODIES = {
    "polymers": mdr.Coated(mdr.Viscoelastic(1.0, [(2.0, 0.5)], bulk_modulus=5.0), 1.0, POLYMER),
    "gel on an elastic base": mdr.Coated(GEL, 1.0, HARD),
    "elastic film on a gel": mdr.Coated(HARD, 0.3, GEL),
    "polymer on a gel": mdr.Coated(POLYMER, 1.0, GEL),
    "liquid on a polymer": mdr.Coated(LIQUID, 1.0, POLYMER),
    "film on a liquid": mdr.Coated(HARD, 0.2, LIQUID),
    "dashpot below": mdr.Coated(POLYMER, 0.5, KELVIN),
}
NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
TIMES = np.array([0.0, 0.5, 1.0, 1.2, 1.6])
DEPTHS = np.array([0.0, 0.5, 0.8, 0.68, 0.44])
"""A kink while the contact grows, and one at the largest depth."""


def largest(found, wanted):
    """The largest difference, relative to the largest value."""
    return np.max(np.abs(found - wanted)) / np.max(np.abs(wanted))


@pytest.mark.parametrize("name", BODIES)
def test_a_punch_superposes_its_steps(name):
    """F = int k(t - u) d'(u) du with k by the inverse Laplace transform, and d from F: no marching, no common times."""
    punch = mdr.Contact(mdr.FlatPunch(0.7), BODIES[name])
    time = np.array([0.0, 0.1, 1.0, 3.0])
    path = np.array([0.0, 0.2, 0.5, 0.5])
    slopes = np.diff(path) / np.diff(time)
    for answer, marched in (
        (punch.relaxation, punch.history(time, depth=path, tolerance=1e-4).force),
        (punch.creep, punch.history(time, force=path, tolerance=1e-4).depth),
    ):
        wanted = []
        for t in time:
            # u = t - y^3: a power law's step is singular there
            begun = (time[:-1] < t) & (slopes > 0.0)
            low, high = (np.maximum(t - ends[begun], 0.0) ** (1.0 / 3.0) for ends in (time[1:], time[:-1]))
            y = low + 0.5 * (high - low) * (1.0 + NODES[:, None])
            steps = np.sum(WEIGHTS[:, None] * answer(np.maximum(y, 0.01) ** 3) * 1.5 * y**2, axis=0) * (high - low)
            wanted.append(np.sum(slopes[begun] * steps))
        assert largest(marched, np.array(wanted)) < 1e-4


@pytest.mark.parametrize("thickness", [(0.5, 0.5), (1.0, 0.3), (0.1, 1.0)])
@pytest.mark.parametrize("nu", [0.4, 0.5])
def test_a_punch_above_a_dashpot_begins_on_a_rigid_base(thickness, nu):
    film, base = thickness
    punch = mdr.Contact(mdr.FlatPunch(0.7), mdr.Layered([(POLYMER, film), (KELVIN.replace(nu=nu), base)], HARD))
    at_once = mdr.Coated(POLYMER.glassy, film, mdr.RIGID).stiffness(0.7)
    found = punch.relaxation([1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01])
    # the layer's first bending goes as the third root of the time
    assert (found[0] + (found[0] - found[1]) / (10.0 ** (1.0 / 3.0) - 1.0)) == pytest.approx(at_once, rel=2e-3)
    assert np.all(np.diff(found) < 0.0)


@pytest.mark.parametrize(
    "tip",
    [
        mdr.Paraboloid(1.0),
        mdr.FlatPunch(0.5),
        mdr.FlatEndedCone(0.3, 0.6),
        mdr.FlatEndedParaboloid(0.3, 1.0),
        mdr.RoundedCone(0.2, 0.5),
    ],
    ids=repr,
)
def test_marching_agrees_with_ting(tip):
    """A film that relaxes almost, but not quite, as its base."""
    ting, marched = (
        mdr.Contact(
            tip, mdr.Coated(mdr.Viscoelastic(0.3, [(0.7, 0.5)], nu=0.5), 1.0, mdr.Viscoelastic(0.6, [(1.4, time)], nu=0.3))
        ).history(TIMES, depth=DEPTHS)
        for time in (0.5, 0.5 * (1.0 + 1e-9))
    )
    assert largest(marched.radius, ting.radius) < 1e-5 and largest(marched.force, ting.force) < 1e-5


@pytest.mark.parametrize(
    ("film", "base", "later", "tolerance"),
    [
        (LIQUID, mdr.Viscoelastic(0.0, [(1.4, 0.5), (0.4, 3.0)], nu=0.3), {"terms": [(1.4, 0.5), (0.4, 3.0 * (1.0 + 1e-9))]}, 1e-5),
        (GEL, mdr.PowerLawRheology(2.0, 1.0, 0.2, nu=0.3), {"exponent": 0.2 * (1.0 + 1e-9)}, 1e-4),
        (GEL.replace(exponent=0.6), mdr.PowerLawRheology(2.0, 1.0, 0.6, nu=0.3), {"exponent": 0.6 * (1.0 + 1e-9)}, 1e-3),
    ],
    ids=["liquid", "power law", "steep power law"],
)
def test_materials_without_limits_agree_with_ting(film, base, later, tolerance):
    ting, marched = (
        mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(film, 1.0, below)).history(TIMES, depth=DEPTHS, tolerance=tolerance)
        for below in (base, base.replace(**later))
    )
    assert largest(marched.radius, ting.radius) < 2.0 * tolerance and largest(marched.force, ting.force) < 2.0 * tolerance


OF_ITSELF = {
    "polymer": POLYMER,
    "of a bulk modulus": mdr.Viscoelastic(1.0, [(2.0, 0.5)], bulk_modulus=5.0),
    "liquid": LIQUID,
}


@pytest.mark.parametrize("name", OF_ITSELF)
def test_a_layer_on_its_own_material_is_no_layer(name):
    """Down, up and down again: what its memory holds is rounding. Layers of another modulus differ by a part of that."""
    material = OF_ITSELF[name]
    path = [0.0, 0.5, 1.0, 1.5, 2.0], [0.0, 0.3, 0.2, 0.1, 0.25]
    for tip in (mdr.Cone(math.pi / 4), mdr.FlatPunch(0.3)):
        contact = mdr.Contact(tip, mdr.Homogeneous(material))
        wanted = contact.history(path[0], depth=path[1], tolerance=1e-3)
        for part, allowed in ((0.0, 1e-13), (1e-9, 1e-9)):
            terms = [(g * (1.0 + part), time) for g, time in material.terms]
            bulk = None if material.bulk_modulus is None else material.bulk_modulus * (1.0 + part)
            below = mdr.Viscoelastic(material.relaxed_shear_modulus * (1.0 + part), terms, nu=material.nu, bulk_modulus=bulk)
            found = contact.replace(medium=mdr.Coated(material, 0.4, below)).history(path[0], depth=path[1], tolerance=1e-3)
            assert largest(found.force, wanted.force) < allowed, part
            assert largest(found.radius, wanted.radius) < allowed, part


def test_a_layer_on_its_own_material_shrinks_by_ting():
    """The closed form of a homogeneous body after its largest depth, by the march of a split one."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(OF_ITSELF["of a bulk modulus"]))
    split = contact.replace(medium=mdr.Layered([(OF_ITSELF["of a bulk modulus"], 0.3)] * 2, OF_ITSELF["of a bulk modulus"]))
    wanted, found = (one.history(TIMES, depth=0.5 * DEPTHS, tolerance=1e-5) for one in (contact, split))
    assert largest(found.force, wanted.force) < 1e-5
    assert largest(found.radius, wanted.radius) < 1e-5


def test_a_liquid_below_carries_the_film_as_long_as_it_is_asked():
    """An elastic film on a liquid sinks under a force without end, at the rate of the liquid at last."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(HARD, 0.2, mdr.Viscoelastic(0.0, [(1.0, 0.5)], nu=0.5)))
    history = contact.history([0.0, 1.0, 10.0, 20.0, 30.0], force=[0.0, 0.2, 0.2, 0.2, 0.2])
    assert np.all(np.diff(history.depth) > 0.0) and np.all(history.radius[1:] > 0.0)
    double = contact.history(2.0 * history.time, force=history.force)
    assert np.all(double.depth[1:] > history.depth[1:])


def test_a_prescribed_radius_is_the_inverse_of_a_prescribed_depth():
    time = np.linspace(0.0, 1.5, 301)
    contact = mdr.Contact(mdr.Paraboloid(1.0), BODIES["polymers"])
    by_depth = contact.history(time, depth=0.5 * np.minimum(time, 2.0 - time) ** 2, tolerance=1e-6)
    by_radius = contact.history(time, radius=by_depth.radius)
    assert np.array_equal(by_radius.radius, by_depth.radius)
    assert largest(by_radius.depth, by_depth.depth) < 1e-4 and largest(by_radius.force, by_depth.force) < 1e-4


def test_a_wall_holds_the_contact():
    """A punch that is withdrawn until it comes free, and set down again where the surface still is low."""
    contact = mdr.Contact(mdr.FlatPunch(0.5), BODIES["polymers"])
    history = contact.history([0.0, 0.5, 1.0, 1.3, 5.0], depth=[0.0, 0.5, 0.0, 0.3, 0.3])
    assert list(history.radius) == [0.0, 0.5, 0.0, 0.5, 0.5] and history.force[2] == 0.0
    fresh = contact.history([0.0, 0.3, 4.0], depth=[0.0, 0.3, 0.3])
    assert 0.7 * fresh.force[1] < history.force[3] < fresh.force[1]


def test_a_noisy_path_ends():
    """Each sample has a kink: no more panels than are good for something."""
    time = np.linspace(0.0, 1.0, 41)
    depth = 0.5 * np.sin(np.pi * time) + 0.02 * np.random.default_rng(1).standard_normal(time.size)
    contact = mdr.Contact(mdr.Paraboloid(1.0), BODIES["polymers"])
    noisy = contact.history(time, depth=depth, tolerance=1e-2)
    smooth = contact.history(time, depth=0.5 * np.sin(np.pi * time), tolerance=1e-2)
    assert largest(noisy.force, smooth.force) < 0.2


@pytest.mark.parametrize("body", [BODIES["gel on an elastic base"], mdr.Homogeneous(GEL), mdr.Homogeneous(KELVIN)])
def test_jumps_that_take_an_infinite_force_are_refused(body):
    contact = mdr.Contact(mdr.Cone(math.pi / 4), body)
    for given in {"depth": [0.1, 0.1]}, {"radius": [0.1, 0.1]}:
        with pytest.raises(mdr.errors.InvalidArgumentError, match="Begin with 0"):
            contact.history([0.0, 1.0], **given)
    sudden = contact.history([0.0, 1.0], force=[0.1, 0.1])
    assert sudden.depth[0] == sudden.radius[0] == 0.0 < sudden.depth[1]


def test_a_dashpot_at_the_surface_is_refused():
    contact = mdr.Contact(mdr.Cone(math.pi / 4), mdr.Coated(KELVIN, 1.0, HARD))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="parallel dashpot"):
        contact.history([0.0, 1.0], depth=[0.0, 0.1])


@pytest.mark.parametrize(
    ("time", "given", "words"),
    [
        ([0.0, 1.0, 1.0], {"depth": [0.0, 0.1, 0.2]}, "ascending"),  # a jump on the way
        ([0.0, 2.0, 1.0], {"depth": [0.0, 0.1, 0.2]}, "ascending"),
        ([0.0, 1.0, math.inf], {"depth": [0.0, 0.1, 0.2]}, "finite"),
        ([0.0, 1.0, 2.0], {"depth": [0.0, math.nan, 0.2]}, "finite"),
        ([0.0, 1.0, 2.0], {"force": [0.0, -0.1, 0.2]}, "entry 2 of force"),
        ([0.0, 1.0, 2.0], {"radius": [0.0, -0.1, 0.2]}, "entry 2 of radius"),
        ([0.0, 1.0, 2.0], {"depth": [0.0, 0.1, 0.2], "tolerance": 1.0}, "tolerance = 1"),
    ],
)
def test_bad_paths_are_refused(time, given, words):
    contact = mdr.Contact(mdr.Paraboloid(1.0), BODIES["polymers"])
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
        contact.history(time, **given)


def test_a_contact_that_is_lost_returns():
    """At once to a surface that is still low, and long afterwards as for the first time; a jump finds the glassy body."""
    film, base = mdr.Viscoelastic(1.0, [(2.0, 0.5)], nu=0.5), mdr.Viscoelastic(0.6, [(0.4, 2.0)], nu=0.3)
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(film, 1.0, base))
    path = [0.0, 0.4, -0.1, -0.1, 0.0, 0.4]
    soon = contact.history([0.0, 1.0, 1.2, 1.3, 1.4, 2.4], depth=path)
    late = contact.history([0.0, 1.0, 1.2, 90.0, 91.0, 92.0], depth=path)
    assert soon.radius[2] == late.radius[3] == late.force[4] == 0.0
    assert 0.5 * late.force[5] < soon.force[5] < 0.999 * late.force[5]
    assert late.force[5] == pytest.approx(late.force[1], rel=1e-4) and late.radius[5] == pytest.approx(late.radius[1], rel=1e-4)
    glassy = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(film.glassy, 1.0, base.glassy)).at_depth(0.4)
    jump = contact.history([0.0, 1.0], depth=[0.4, 0.4])
    assert (jump.force[0], jump.radius[0]) == pytest.approx((glassy.force, glassy.radius), rel=1e-10)


@pytest.mark.parametrize("name", ["elastic film on a gel", "dashpot below"])
@pytest.mark.parametrize("tip", [mdr.FlatPunch(0.7), mdr.Cone(0.5)], ids=repr)
def test_a_jump_finds_power_laws_and_dashpots_below_rigid(name, tip):
    body = BODIES[name]
    film = body.coating if isinstance(body.coating, mdr.Elastic) else body.coating.glassy
    at_once = mdr.Contact(tip, mdr.Coated(film, body.thickness, mdr.RIGID)).at_depth(0.1)
    contact = mdr.Contact(tip, body)
    for given in {"depth": 2 * [0.1]}, {"force": 2 * [at_once.force]}:
        history = contact.history([0.0, 0.1], tolerance=1e-2, **given)
        found = history.depth[0], history.radius[0], history.force[0]
        assert found == pytest.approx((0.1, at_once.radius, at_once.force), rel=1e-8)


def test_a_film_that_relaxes_sooner_than_its_base_widens_the_contact():
    """More than either the glassy or the relaxed body does."""
    film, base = mdr.Viscoelastic(5.4, [(32.0, 0.012)], nu=0.27), mdr.Viscoelastic(0.5, [(8.5, 2.0)], nu=0.15)
    contact = mdr.Contact(mdr.Cone(0.5), mdr.Coated(film, 0.17, base))
    history = contact.history([0.0, 2.8, 5.5], depth=[0.047, 0.172, 0.028], tolerance=1e-3)
    bodies = [(film.glassy, base.glassy), (film.relaxed, base.relaxed), (film.relaxed, base.glassy)]
    radii = [contact.replace(medium=mdr.Coated(over, 0.17, below)).at_depth(0.172).radius for over, below in bodies]
    assert 1.2 * max(radii[:2]) < history.radius[1] < radii[2]


@pytest.mark.parametrize(("film", "base"), [(10.0, 1.0), (1.0, 10.0)])
def test_contacts_wider_than_their_film_are_resolved(film, base):
    """A jump finds the glassy body, whatever the thickness."""
    over, below = (
        mdr.Viscoelastic(0.5 * film, [(0.5 * film, 1.0)], nu=0.3),
        mdr.Viscoelastic(0.3 * base, [(0.7 * base, 2.0)], nu=0.3),
    )
    for thickness in 0.1, 0.05:
        contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(over, thickness, below))
        glassy = contact.replace(medium=mdr.Coated(over.glassy, thickness, below.glassy)).at_radius(1.0)
        jump = contact.history([0.0, 1e-6], depth=2 * [glassy.depth], tolerance=1e-2)
        assert (jump.radius[0], jump.force[0]) == pytest.approx((glassy.radius, glassy.force), rel=1e-9)
    with pytest.raises(mdr.errors.NoConvergenceError, match="too wide for a first layer"):
        contact.replace(medium=mdr.Coated(over, 0.002, below)).history([0.0, 1e-6], depth=2 * [1.0])


def test_under_no_force_the_indenter_rests_on_what_is_left():
    """As under hardly any, though the contact has been lost."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(LIQUID))
    time = np.array([0.0, 0.5, 9.0, 9.1])
    none, hardly = (contact.history(time, force=[0.0, 0.1, 0.03, last], tolerance=1e-4).depth for last in (0.0, 1e-12))
    assert none == pytest.approx(hardly, rel=1e-3)


def test_an_indenter_may_come_from_anywhere():
    """The start of its way is neither a length to extrapolate nor one that a gap beside the contact is compared with."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), BODIES["polymers"])
    time = [0.0, 1.0, 1.5, 2.0]
    near, *far = (
        contact.history(time, depth=[start, 0.3, 0.2, 0.4], tolerance=1e-3).force for start in (-1e6, -1e15, -1e17, -1.7e308)
    )
    for found in far:
        np.testing.assert_allclose(found, near, rtol=2e-3)
