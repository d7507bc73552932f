# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces with tension and plates: half-spaces, films and stacks under them."""

import math

import numpy as np
import pytest
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import grows, near, relation
from .references import panels, reduced
from .rescale import in_units

radii = d.between(0.3, 1.0)
numbers = st.one_of(st.floats(), st.sampled_from([0.0, -1.0, 1e-300, 1e300, math.inf, math.nan]))
ON_ALL_DIGITS = 2e-9
"""Of depth, force and stiffness; five times that of cones and their like, whose pressure is infinite at the apex."""


def digits(tip):
    """The relative error of its states."""
    exponent = getattr(tip.profile, "exponent", 2.0 if isinstance(tip.profile, mdr.Paraboloid) else 1.0)
    return ON_ALL_DIGITS if exponent >= 2.0 else 1e-8 if exponent >= 1.0 else 1e-6


TIPS = st.one_of(d.paraboloids, d.cones, st.builds(lambda n, c: d.Tip(mdr.PowerLaw(n, c)), st.floats(1.0, 6.0), d.lengths))
TENSE = st.tuples(st.one_of(d.tense, d.stretched, d.tense_and_stretched), TIPS)
PRESSED = st.one_of(TENSE, st.tuples(d.plated, d.paraboloids))
"""A plate takes the shape of a paraboloid, of no tip or flat one."""


@relation(12, pressed=PRESSED, a=radii)
def test_inverses_and_derivative(pressed, a):
    """Depth and force lead back to the radius; dF/dd by differences against k, which a larger punch has more of."""
    body, tip = pressed
    contact = mdr.Contact(tip.profile, body)
    state = contact.at_radius(a * np.array([0.98, 1.0, 1.02]))
    near(contact.at_depth(state.depth[1]).force, state.force[1], 1e-8)
    near(contact.at_force(state.force[1]).radius, state.radius[1], 1e-7)
    for values in (state.depth, state.force, state.stiffness):
        grows(values)
    step = 2e-3 * state.depth[1]
    force = contact.at_depth(state.depth[1] + step * np.array([-2.0, -1.0, 1.0, 2.0])).force
    near((force[0] - 8.0 * force[1] + 8.0 * force[2] - force[3]) / (12.0 * step), state.stiffness[1], 1e-5)


@relation(12, pressed=PRESSED, a=radii, unit=d.units)
def test_units(pressed, a, unit):
    """The same contact in other units: tension is a modulus times a length, a plate's stiffness times its cube."""
    body, tip = pressed
    s, t = unit
    small = mdr.Contact(tip.profile, body).at_radius(a)
    large = mdr.Contact(in_units(tip.profile, s), in_units(body, s, t)).at_radius(a * s)
    near(large.depth, small.depth * s, digits(tip))
    near(large.force, small.force * s * s * t, digits(tip))
    near(large.stiffness, small.stiffness * s * t, ON_ALL_DIGITS)


@relation(8, body=d.sheeted, first=TIPS, second=TIPS, a=radii)
def test_superposition(body, first, second, a):
    """A sum of indenters at one radius against the sums of depths and forces."""
    both, one, other = (
        mdr.Contact(profile, body).at_radius(a) for profile in (first.profile + second.profile, first.profile, second.profile)
    )
    allowed = max(digits(first), digits(second))
    near(both.depth, one.depth + other.depth, allowed)
    near(both.force, one.force + other.force, allowed)


@relation(8, body=d.bare, surface=d.surfaces, more=d.between(1.01, 3.0), a=radii)
def test_a_surface_makes_a_body_stiffer(body, surface, more, a):
    """k without a surface, with one, and with more of it: energy."""
    stiff = mdr.Surface(more * surface.tension, more * surface.bending)
    grows([body.stiffness(a), body.replace(surface=surface).stiffness(a), body.replace(surface=stiff).stiffness(a)])


@relation(8, body=d.bare, part=st.floats(0.002, 0.02), a=d.between(0.3, 0.6))
def test_little_tension(body, part, a):
    """k of tension tau and 2 tau against k of the bare body: what it adds goes as x = l/(pi a) (ln(2 a/l) + gamma + 1), the
    waves that it holds being shorter than the film is thick."""
    length = part * a * min(1.0, getattr(body, "thickness", 1.0) / a)
    modulus = body.modulus(1e-9 * a)
    bare, x, added = body.stiffness(a), [], []
    for size in (length, 2.0 * length):
        x.append(size / (math.pi * a) * (math.log(2.0 * a / size) + np.euler_gamma + 1.0))
        added.append(body.replace(surface=mdr.Surface(0.5 * size * modulus)).stiffness(a) / bare - 1.0)
    # a stiff base takes more of it: the edge presses more there than on a half-space
    near(added[1] / added[0], x[1] / x[0], 0.1)


@relation(8, material=d.usual, surface=d.surfaces, a=radii, base=d.usual, h=d.between(0.3, 5.0))
def test_films_and_half_spaces(material, surface, a, base, h):
    """A film of the base's material and one that is very thick against the half-space, one cut in two against itself."""
    half_space = mdr.Homogeneous(material, surface=surface).stiffness(a)
    near(mdr.Coated(material, h, material, surface=surface).stiffness(a), half_space, ON_ALL_DIGITS)
    contrast = max(base.E / material.E, material.E / base.E)
    near(mdr.Coated(material, 1e7 * a, base, surface=surface).stiffness(a), half_space, 1e-6 * contrast)
    whole = mdr.Coated(material, h, base, surface=surface).stiffness(a)
    near(mdr.Layered([(material, 0.4 * h), (material, 0.6 * h)], base, surface=surface).stiffness(a), whole, ON_ALL_DIGITS)


def rings(contact, state):
    """Radii inside a contact, the pressure's share of its force in each, and last the edge with its line force."""
    t, weight = np.polynomial.legendre.leggauss(60)
    angle = 0.25 * math.pi * (1.0 + t)
    r = state.radius * np.sin(angle)
    share = 2.0 * math.pi * state.pressure(r) * r * state.radius * np.cos(angle) * weight * 0.25 * math.pi
    return np.append(r, state.radius), np.append(share, state.force - share.sum())


@relation(4, pressed=st.tuples(d.tense, d.paraboloids), a=radii, more=d.between(1.1, 2.0))
def test_reciprocity(pressed, a, more):
    """Betti: a flat punch's pressure on the shape of another indenter gives that one's force; the pressure of a wide punch on
    the displacement by a narrow one gives the narrow one's force."""
    body, tip = pressed
    punch = mdr.Contact(mdr.FlatPunch(a), body)
    flat, state = punch.at_depth(1.0), mdr.Contact(tip.profile, body).at_radius(a)
    r, share = rings(punch, flat)
    near(state.force, flat.force * state.depth - share @ tip.profile.height(r), 1e-6, size=flat.force * state.depth)
    wide = mdr.Contact(mdr.FlatPunch(more * a), body)
    r, share = rings(wide, wide.at_depth(1.0))
    near(share[r <= a].sum() + share[r > a] @ flat.displacement(r[r > a]), flat.force, 1e-3)


@relation(12, pressed=st.tuples(d.sheeted, d.paraboloids), a=radii, work=d.works)
def test_adhesion(pressed, a, work):
    """dl = sqrt(4 pi a gamma/k') less depth, and k dl less force; k' by differences."""
    body, tip = pressed
    gamma = work * body.modulus(a)
    bare, state = (mdr.Contact(tip.profile, body, **given).at_radius(a) for given in ({}, {"work_of_adhesion": gamma}))
    k = body.stiffness(a * (1.0 + 1e-3 * np.array([-2.0, -1.0, 1.0, 2.0])))
    slope = (k[0] - 8.0 * k[1] + 8.0 * k[2] - k[3]) / (12.0 * 1e-3 * a)
    less = math.sqrt(4.0 * math.pi * a * gamma / slope)
    near(bare.depth - state.depth, less, 1e-6)
    near(bare.force - state.force, bare.stiffness * less, 1e-6)


@relation(6, material=d.usual, part=st.floats(0.05, 0.9), bending=d.between(1e-3, 1.0), a=radii)
def test_compressed_plates(material, part, bending, a):
    """Under a part of the compression at which it wrinkles a plate is softer than without, and beyond it refused."""
    wave = (0.25 * reduced(material) / bending) ** (1.0 / 3.0)
    critical = -3.0 * bending * wave**2
    grows([mdr.Homogeneous(material, surface=mdr.Surface(p * critical, bending)).stiffness(a) for p in (part, 0.0)])
    for refused in (mdr.Surface(critical * (1.0 + part), bending), mdr.Surface(part * critical, 0.0)):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="wrinkles"):
            mdr.Homogeneous(material, surface=refused)


@relation(
    8,
    body=d.bare,
    tension=st.one_of(st.just(0.0), d.between(0.05, 0.5)),
    bending=d.between(0.01, 1.0),
    nu=st.floats(0.0, 0.45),
    a=radii,
)
def test_plates_are_thin_layers_that_slide(body, tension, bending, nu, a):
    """A layer that slides, of a plate's stiffness E h^3/(12 (1 - nu^2)) and stressed by tension over h, against the plate: the
    difference falls as the square of its thickness over the wavelength. A paraboloid's force and stiffness at a depth."""
    rows = (
        [(body.material, None)] if isinstance(body, mdr.Homogeneous) else [(body.coating, body.thickness), (body.substrate, None)]
    )
    scale = min(a, (bending / body.modulus(1e-3)) ** (1.0 / 3.0), *(h for _, h in rows if h))

    def layered(h):
        film = mdr.Elastic(12.0 * bending * (1.0 - nu**2) / h**3, nu)
        layers = [mdr.Layer(film, h, prestress=tension / h, interface=mdr.SLIDING), *(mdr.Layer(m, t) for m, t in rows[:-1])]
        return mdr.Layered(layers, rows[-1][0], tolerance=1e-6)

    plate = body.replace(surface=mdr.Surface(tension, bending))
    k = np.array([0.3, 1.0, 2.0]) / scale
    thick, thin = (layered(part * scale).compliance(k) / plate.compliance(k) - 1.0 for part in (0.02, 0.01))
    near(thin, 0.0, 2e-4, size=k * scale)
    near(thin, 0.25 * thick, 0.05, size=np.abs(thick) + 1e-5)
    state = mdr.Contact(mdr.Paraboloid(1.0), plate).at_radius(a)
    found = mdr.Contact(mdr.Paraboloid(1.0), layered(0.05 * scale)).at_depth(state.depth)
    near(found.force, state.force, 2e-3)
    near(found.stiffness, state.stiffness, 2e-3)


@relation(40, body=d.bare, tension=numbers, bending=numbers, stretching=numbers, a=d.between(1e-6, 1e6), may_refuse=1.0)
def test_any_numbers(body, tension, bending, stretching, a):
    """Any numbers are refused with a sentence, or give a stiffness > 0 at any radius, or refuse that with a sentence."""
    assert body.replace(surface=mdr.Surface(tension, bending, stretching)).stiffness(a) > 0.0


@relation(4, pressed=PRESSED, a=radii, far=d.between(1.2, 2.0))
def test_work_is_stored(pressed, a, far):
    """int F dd = int F k^-1 dF over the loading against the sum of F^2/(2 k) and int F^2/(2 k^2) dk, the energy of an elastic
    body whose stiffness grows."""
    body, tip = pressed
    contact = mdr.Contact(tip.profile, body)
    ends = [a, far * a]

    def work(r):
        state = contact.at_radius(np.asarray(r))
        step = 1e-3 * np.asarray(r)
        fore, back = contact.at_radius(r + step).depth, contact.at_radius(r - step).depth
        return state.force * (fore - back) / (2.0 * step)

    def stored(r):
        state = contact.at_radius(np.asarray(r))
        step = 1e-3 * np.asarray(r)
        return (state.force / state.stiffness) ** 2 / 2.0 * (body.stiffness(r + step) - body.stiffness(r - step)) / (2.0 * step)

    low, high = contact.at_radius(a), contact.at_radius(far * a)
    ends_energy = high.force**2 / (2.0 * high.stiffness) - low.force**2 / (2.0 * low.stiffness)
    near(panels(work, ends), ends_energy + panels(stored, ends), 1e-5)
