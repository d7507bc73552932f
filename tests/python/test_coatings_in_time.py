# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that relax on interfaces that give, or on a base of quite another stiffness: against elastic bodies and by two ways."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import mdrcontact as mdr
import mdrcontact.instruments as mdi

TIP = mdr.Paraboloid(1.0)
FILM = mdr.Viscoelastic(1.0, [(1.0, 1.0), (0.5, 0.1)], nu=0.3)
BASE = mdr.Elastic(3.0, 0.3)
AT_ONCE, AT_REST = 1e-8, 400.0
"""Times, in units of the film's, and what relaxes up to the first and after the second is less than 1e-8."""


def forces(make, indenter=TIP, depth=0.5):
    """Of a body with the relaxing film at once and at rest, over those of the elastic bodies with its limits."""
    history = mdr.Contact(indenter, make(FILM)).history([0.0, AT_ONCE, AT_REST], depth=[0.0, depth, depth], tolerance=1e-7)
    elastic = [mdr.Contact(indenter, make(limit)).at_depth(depth) for limit in (FILM.glassy, FILM.relaxed)]
    assert history.radius[1:] == pytest.approx([state.radius for state in elastic], rel=1e-7)
    return history.force[1:] / [state.force for state in elastic]


SPRINGS = st.floats(-3.0, 3.0).map(lambda x: 10.0**x)


@given(SPRINGS, st.none() | st.just(0.0) | SPRINGS, st.sampled_from([BASE, mdr.RIGID, mdr.Elastic(1e-3, 0.4)]))
@settings(max_examples=12, deadline=None)
def test_limits_of_films_on_springs(normal, tangential, base):
    interface = mdr.Interface(normal=normal, tangential=tangential)
    assert forces(lambda film: mdr.Layered([mdr.Layer(film, 1.0, interface=interface)], base)) == pytest.approx(1.0, abs=1e-7)


@pytest.mark.parametrize("contrast", [1e-4, 1e-2, 1e1, 1e2, 1e3, 1e4, 1e6])
def test_limits_of_films_of_another_stiffness(contrast):
    """Stiff films bend in waves far longer than they are thick: the march must see them."""
    assert forces(lambda film: mdr.Coated(film, 1.0, mdr.Elastic(2.6 / contrast, 0.3))) == pytest.approx(1.0, abs=1e-7)


@pytest.mark.parametrize("substrate", [BASE, mdr.RIGID, mdr.SMOOTH])
def test_a_punch_steps_alike_in_time_and_by_transforms(substrate):
    """The march with the memory of all layers, and the inverse transform of the stiffness at complex moduli."""
    slides = substrate is mdr.SMOOTH
    between = mdr.Interface(normal=0.7, tangential=0.2)
    layers = [
        mdr.Layer(FILM, 0.5, interface=mdr.SLIDING),
        mdr.Layer(mdr.Elastic(8.0, 0.2), 0.3, interface=None if slides else between),
    ]
    contact = mdr.Contact(mdr.FlatPunch(0.8), mdr.Layered(layers, substrate))
    time = np.array([0.0, 0.01, 0.1, 1.0, 10.0])
    marched = contact.history(time, depth=np.full(5, 0.1), tolerance=1e-7).force[1:]
    stepped = 0.1 * contact.relaxation(time[1:])
    assert marched == pytest.approx(stepped, rel=2e-6)


def test_springs_of_a_thin_interlayer():
    """K = C/t of an elastic interlayer between two that relax: the error falls with its thickness."""
    below = mdr.Viscoelastic(2.0, [(1.0, 5.0)], nu=0.4)
    time, depth = np.array([0.0, 0.5, 2.0, 8.0]), [0.0, 0.4, 0.4, 0.2]
    errors = []
    for t in (1e-2, 1e-3):
        soft = mdr.Elastic(t, 0.3)
        G = soft.E / (2.0 * (1.0 + soft.nu))
        C33 = 2.0 * G * (1.0 - soft.nu) / (1.0 - 2.0 * soft.nu)
        glue = mdr.Interface(normal=C33 / t, tangential=G / t)
        whole = mdr.Layered([(FILM, 1.0), (soft, t)], below)
        sprung = mdr.Layered([mdr.Layer(FILM, 1.0, interface=glue)], below)
        one, other = (mdr.Contact(TIP, body).history(time, depth=depth, tolerance=1e-6).force[1:] for body in (whole, sprung))
        errors.append(np.max(np.abs(one / other - 1.0)))
    assert errors[0] < 5e-2
    assert errors[1] < 0.2 * errors[0]


def test_what_slides_relaxes_in_proportion():
    """Without a stiffness of its own an interface has no time: all follows from elastic curves."""
    time, depth = np.array([0.0, 0.1, 1.0, 10.0]), np.full(4, 0.3)
    sliding = mdr.Layered([mdr.Layer(FILM, 1.0)], mdr.SMOOTH)
    nearly = mdr.Layered([mdr.Layer(FILM, 1.0, interface=mdr.Interface(tangential=1e-9))], mdr.RIGID)
    F = mdr.Contact(TIP, sliding).history(time, depth=depth).force
    assert F / F[0] == pytest.approx(FILM.relaxation(time) / FILM.relaxation(0.0), rel=1e-10)
    assert mdr.Contact(TIP, nearly).history(time, depth=depth, tolerance=1e-7).force[1:] == pytest.approx(F[1:], rel=1e-6)
    assert mdr.Layered([mdr.Layer(FILM, 1.0, interface=mdr.SLIDING)], mdr.RIGID).compliance(2.0, omega=3.0) == pytest.approx(
        sliding.compliance(2.0, omega=3.0), rel=1e-14
    )


def test_a_gel_on_springs_oscillates_between_its_limits():
    glue = mdr.Interface(normal=2.0)
    films = [mdr.Layer(material, 1.0, interface=glue) for material in (FILM, FILM.glassy, FILM.relaxed)]
    gel, glassy, relaxed = (mdr.Contact(TIP, mdr.Layered([film], BASE)) for film in films)
    fast, slow = gel.dynamic_stiffness(1e7, radius=0.5), gel.dynamic_stiffness(1e-7, radius=0.5)
    assert fast.real == pytest.approx(glassy.at_radius(0.5).stiffness, rel=1e-6)
    assert slow.real == pytest.approx(relaxed.at_radius(0.5).stiffness, rel=1e-6)
    between = gel.dynamic_stiffness(1.0, radius=0.5)
    assert slow.real < between.real < fast.real
    assert between.imag > 0.0


def test_power_laws_and_dashpots_on_springs():
    """A film of a power law on a glue line: a step of a punch by the march and by transforms."""
    film = mdr.PowerLawRheology(1.0, 1.0, 0.3, nu=0.4)
    glue = mdr.Interface(normal=3.0, tangential=1.0)
    contact = mdr.Contact(mdr.FlatPunch(1.0), mdr.Layered([mdr.Layer(film, 0.6, interface=glue)], BASE))
    time = np.array([0.0, 0.1, 1.0, 10.0])
    held = contact.history(time, force=np.full(4, 0.2), tolerance=1e-5).depth[1:]
    assert held == pytest.approx(0.2 * contact.creep(time[1:]), rel=1e-4)
    kelvin = mdr.Viscoelastic(1.0, [], nu=0.4, viscosity=0.5)
    sprung = mdr.Layered([mdr.Layer(BASE, 0.6, interface=glue)], kelvin)
    assert sprung.compliance(1.0, omega=2.0).imag < 0.0


@pytest.mark.slow
def test_a_fit_finds_the_springs():
    rng = np.random.default_rng(3)

    def body(K):
        return mdr.Layered([mdr.Layer(FILM, 1.0, interface=mdr.Interface(normal=K, tangential=0.3))], BASE)

    time = np.linspace(0.0, 5.0, 100)
    depth = 0.3 * np.minimum(time, 1.0)
    force = mdr.Contact(TIP, body(0.8)).history(time, depth=depth).force
    data = mdi.ForceTime(time, depth, force + 1e-4 * rng.standard_normal(time.size), sd=1e-4)
    free = ["layers[0].interface.normal", "layers[0].terms[0].modulus"]
    result = mdi.fit(data, TIP, body(1.2), free)
    low, high = result.interval(free[0])
    assert low < 0.8 < high
    assert high - low < 0.1


def test_refusals():
    crystal = mdr.TransverselyIsotropic.from_engineering(10.0, 3.0, 0.2, 0.1, 2.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="prestress"):
        mdr.Layer(FILM, 1.0, prestress=0.1)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="prestress of layer 2"):
        mdr.Layered([(FILM, 1.0), mdr.Layer(BASE, 1.0, prestress=0.1)], BASE)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="layer 1: the layers of a viscoelastic body"):
        mdr.Layered([(crystal, 1.0)], FILM)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="not isotropic, bonded"):
        mdr.Layered([mdr.Layer(FILM, 1.0, interface=mdr.SLIDING)], BASE, model="gao")
    assert math.isfinite(mdr.Layered([mdr.Layer(FILM, 1.0, interface=mdr.SLIDING)], BASE).compliance(1.0, omega=1.0).real)


SOFT = mdr.Viscoelastic(0.6, [(0.4, 2.0)], bulk_modulus=9.0)
RELAXING = [
    ([(FILM, 0.4, mdr.Interface(normal=2.0, tangential=0.5)), (SOFT, 0.3, mdr.SLIDING)], SOFT),
    ([(FILM, 0.5, mdr.SLIDING)], BASE),
    ([(BASE, 0.2, mdr.SLIDING), (SOFT, 0.4, mdr.Interface(tangential=0.3))], mdr.RIGID),
    ([(SOFT, 0.1, mdr.Interface(normal=1.0)), (FILM, 0.5, None)], mdr.SMOOTH),
]


def body_of(layers, substrate, limit=None):
    """The body, or the elastic one with a limit of each material, given layer by layer."""

    def of(material):
        return getattr(material, limit) if limit and isinstance(material, mdr.Viscoelastic) else material

    return mdr.Layered([mdr.Layer(of(m), h, interface=below) for m, h, below in layers], of(substrate))


@pytest.mark.parametrize(("layers", "substrate"), RELAXING)
def test_oscillations_about_a_depth_are_those_at_its_relaxed_radius(layers, substrate):
    """Of the body as it is, interfaces too; slow ones have the relaxed stiffness, fast ones the glassy."""
    contact = mdr.Contact(TIP, body_of(layers, substrate))
    relaxed, glassy = (contact.replace(medium=body_of(layers, substrate, limit)) for limit in ("relaxed", "glassy"))
    for control, value in (("depth", 0.1), ("force", 0.1)):
        state = getattr(relaxed, f"at_{control}")(value)
        wanted = contact.dynamic_stiffness([1e-6, 1.0, 1e9], radius=state.radius)
        found = contact.dynamic_stiffness([1e-6, 1.0, 1e9], **{control: value})
        assert np.abs(found / wanted - 1.0).max() < 1e-10
        assert found.real[[0, 2]] == pytest.approx([state.stiffness, glassy.medium.stiffness(state.radius)], rel=1e-9)


@pytest.mark.parametrize(
    ("interface", "at_last", "base"),
    [
        (mdr.SLIDING, mdr.SLIDING, mdr.RIGID),
        (mdr.Interface(normal=2.0, tangential=0.5), None, mdr.RIGID),
        (mdr.Interface(normal=3.0, tangential=0.0), mdr.SLIDING, mdr.RIGID),
        (None, None, mdr.SMOOTH),
    ],
)
def test_beside_a_power_law_springs_are_rigid_at_last_and_what_slides_slides(interface, at_last, base):
    """The radius at a depth is that of an elastic layer of any modulus that is held in the same way."""
    contact = mdr.Contact(TIP, body_of([(mdr.PowerLawRheology(1.0, 1.0, 0.2, nu=0.45), 0.5, interface)], base))
    held = mdr.Contact(TIP, body_of([(mdr.Elastic(7.0, 0.45), 0.5, at_last)], base)).at_depth(0.05)
    wanted = contact.dynamic_stiffness(1.0, radius=held.radius)
    assert abs(contact.dynamic_stiffness(1.0, depth=0.05) / wanted - 1.0) < 1e-10


def test_bonds_beside_a_power_law_stay_bonds():
    """What is bonded, or hinders no motion along the interface, slides no more for being an `Interface`: its springs are rigid at
    last, and a resistance is none to forces."""
    law, base = mdr.PowerLawRheology(1.0, 1.0, 0.3, 0.45), mdr.PowerLawRheology(2.0, 1.0, 0.3, 0.4)

    def oscillating(interface):
        body = mdr.Layered([mdr.Layer(law, 1.0, interface=interface)], base)
        contact = mdr.Contact(mdr.Sphere(5.0), body)
        return contact.dynamic_stiffness(1.0, depth=0.1)

    bonded = oscillating(None)
    assert oscillating(mdr.Interface()) == oscillating(mdr.Interface(resistance=0.3)) == bonded
    assert oscillating(mdr.Interface(normal=1e9, tangential=1e9)) == pytest.approx(bonded, rel=1e-6)
    assert oscillating(mdr.Interface(normal=1e9)) == pytest.approx(bonded, rel=1e-6)
    assert abs(oscillating(mdr.SLIDING) - bonded) > 0.01 * abs(bonded)


def test_a_rigid_partner_changes_no_relaxing_body():
    """Compliance at a frequency and oscillations about a depth: of a pair with a rigid body those of the other alone."""
    body = mdr.Homogeneous(mdr.Viscoelastic(1.0, [(3.0, 1.0)], nu=0.3))
    pair = mdr.Pair(body, mdr.RIGID)
    assert pair.compliance([0.5, 2.0], omega=1.0) == pytest.approx(body.compliance([0.5, 2.0], omega=1.0), rel=1e-14)
    assert np.imag(pair.compliance(1.0, omega=1.0)) < -0.1
    alone, together = (mdr.Contact(mdr.Sphere(5.0), medium) for medium in (body, pair))
    assert together.dynamic_stiffness(1.0, depth=0.1) == pytest.approx(alone.dynamic_stiffness(1.0, depth=0.1), rel=1e-14)
    assert together.dynamic_stiffness(1.0, force=0.1) == pytest.approx(alone.dynamic_stiffness(1.0, force=0.1), rel=1e-14)
