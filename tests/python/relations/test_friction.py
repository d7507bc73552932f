# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction along the surface and about the axis: states, loops, paths, laws."""

import math
import pickle
import warnings

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from scipy import special

import mdrcontact as mdr

from . import draws as d
from .harness import grows, near, relation, same
from .references import disc, panels, reduced, shear
from .rescale import in_units

frictions = d.between(1e-3, 2.0)
weighted = st.builds(mdr.Coated, d.materials, d.thicknesses, d.materials, d.weights)
soft_films = st.builds(lambda m, h, f: mdr.Coated(m, h, m.replace(E=m.E * f)), d.usual, d.thicknesses, d.between(1.0, 20.0))
"""Exact films softer than their base: slip begins at the edge."""
media = st.one_of(d.homogeneous, weighted, soft_films)
parts = st.floats(0.02, 0.95)
"""Of the shift or force at which the contact slides."""


def pressed(tip, medium, share, mu):
    """The friction and a normal state."""
    friction = mdr.Friction(mdr.Contact(tip.profile, medium), mu)
    return friction, friction.contact.at_radius(float(tip.radii(share)[-1]))


@relation(60, R=d.between(1e-3, 1e3), material=d.extreme, mu=frictions, a=d.between(1e-3, 1e2), part=parts)
def test_cattaneo_and_mindlin(R, material, mu, a, part):
    """Cattaneo and Mindlin's closed form: c, s and the energy of first shear and of a cycle from T."""
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)), mu)
    state = friction.contact.at_radius(a)
    F, modulus = state.force, 4.0 * shear(material) / (2.0 - material.nu)
    T = part * mu * F
    found = friction.shear(state).at_force(T)
    near(found.stick_radius, a * (1.0 - part) ** (1.0 / 3.0), 1e-10)
    sliding = mu * reduced(material) / modulus * a * a / R
    near(found.shift, sliding * -math.expm1(2.0 / 3.0 * math.log1p(-part)), 1e-10)
    near(friction.shear(state).sliding_shift, sliding, 1e-11)
    # Mindlin and Deresiewicz (1953)
    lost = 1.2 * mu * F * sliding * (1.0 - (1.0 - part) ** (5.0 / 3.0) - 5.0 * part / 6.0 * (1.0 + (1.0 - part) ** (2.0 / 3.0)))
    near(friction.shear(state).cycle_energy(T, "force"), 4.0 * found.dissipated_energy, 1e-12)
    # the closed form cancels to the third order of small amplitudes
    near(found.dissipated_energy, lost, 1e-9, size=lost + 1e-5 * mu * F * sliding)


@relation(40, tip=d.simple_tips, material=d.materials, mu=frictions, share=d.shares, inner=st.floats(0.05, 0.95))
def test_partial_slip_is_a_difference_of_two_contacts(tip, material, mu, share, inner):
    """T, s and the traction from c against mu [F(a) - F(c)], mu E*/G_t [d(a) - d(c)] and mu [p_a - p_c] (Ciavarella, Jaeger)."""
    medium = mdr.Homogeneous(material)
    friction, state = pressed(tip, medium, share, mu)
    contact = friction.contact
    smaller = contact.at_radius(inner * state.radius)
    found = friction.shear(state).at_force(mu * (state.force - smaller.force))
    # the smaller the disc of stick, the less of T it makes
    near(found.stick_radius, smaller.radius, 1e-8 + 1e-11 * state.force / smaller.force)
    ratio = reduced(material) / (4.0 * shear(material) / (2.0 - material.nu))
    near(found.shift, mu * ratio * (state.depth - smaller.depth), 1e-9, size=mu * ratio * state.depth)
    r = state.radius * np.array([0.02, 0.5 * inner, 0.5 + 0.5 * inner])
    expected = mu * state.pressure(r)
    expected[:2] -= mu * smaller.pressure(r[:2])
    near(friction.shear(state).traction(r, found), expected, 1e-7, size=mu * state.pressure(r))


@relation(40, tip=d.one_tip, medium=media, mu=frictions, share=d.shares, part=parts)
def test_shift_and_force_are_inverses(tip, medium, mu, share, part):
    """at_force against at_shift; both ways against each other with the sign turned."""
    friction, state = pressed(tip, medium, share, mu)
    s = part * friction.shear(state).sliding_shift
    one = friction.shear(state).at_shift(s)
    other = friction.shear(state).at_force(one.tangential_force)
    for name in ("shift", "stick_radius", "stiffness"):
        near(getattr(other, name), getattr(one, name), 1e-6 if name != "shift" else 1e-8)
    back = friction.shear(state).at_shift(-s)
    same([back.tangential_force, back.stick_radius], [-one.tangential_force, one.stick_radius])
    assert one.tangential_force < mu * state.force


@relation(40, tip=d.simple_tips, medium=media, mu=frictions, share=d.shares, part=st.floats(0.05, 0.9))
def test_tangential_stiffness_is_the_derivative(tip, medium, mu, share, part):
    """dT/ds by differences against the stiffness of the state and k_t(c) of the medium."""
    friction, state = pressed(tip, medium, share, mu)
    s = part * friction.shear(state).sliding_shift
    found = friction.shear(state).at_shift(s)
    step = 2e-3 * s
    T = [friction.shear(state).at_shift(s + k * step).tangential_force for k in (-2, -1, 1, 2)]
    if tip.corner is None or abs(found.stick_radius / tip.corner - 1.0) > 0.05:
        near((T[0] - 8.0 * T[1] + 8.0 * T[2] - T[3]) / (12.0 * step), found.stiffness, 1e-5)
    near(medium.tangential_stiffness(found.stick_radius), found.stiffness, 1e-8)


@relation(30, tip=d.closed_tips, medium=media, mu=frictions, share=d.shares, part=st.floats(0.1, 0.9))
def test_tractions_carry_the_force(tip, medium, mu, share, part):
    """T against the integrals of traction and line load by tanh-sinh; traction against mu p in the annulus of slip."""
    friction, state = pressed(tip, medium, share, mu)
    found = friction.shear(state).at_shift(part * friction.shear(state).sliding_shift)
    c, a = found.stick_radius, state.radius
    assume(tip.corner is None)
    near(2.0 * disc(lambda x: friction.shear(state).line_load(x, found), a, c), found.tangential_force, 1e-7)
    near(2.0 * math.pi * disc(lambda r: r * friction.shear(state).traction(r, found), a, c), found.tangential_force, 1e-5)
    r = c + (a - c) * np.array([0.1, 0.5, 0.9])
    near(friction.shear(state).traction(r, found), mu * state.pressure(r), 1e-7)


@relation(10, tip=d.one_tip, medium=media, mu=frictions, share=d.shares, part=st.floats(0.1, 1.5))
def test_loops_lose_their_area(tip, medium, mu, share, part):
    """The energy of a cycle against the area of the loop from first shear by Masing's rule and Gauss and Legendre."""
    friction, state = pressed(tip, medium, share, mu)
    sliding = friction.shear(state).sliding_shift
    s = part * sliding
    with warnings.catch_warnings(record=True) as words:
        warnings.simplefilter("always")
        loop = friction.shear(state).loop(s)
    # where slip would begin inside, the annulus may fold: its shift falls again before the contact slides
    assume(not any(issubclass(word.category, mdr.errors.SlipInsideWarning) for word in words))
    assume(
        s < sliding or friction.shear(state).at_shift((1.0 - 1e-12) * sliding).tangential_force > (1.0 - 1e-9) * mu * state.force
    )
    near(friction.shear(state).cycle_energy(s), loop.dissipated_energy, 1e-10)
    near(loop.tangential_force[:101], -loop.tangential_force[100:], 1e-10, size=mu * state.force)
    # T bends where the edge of stick passes a corner of the tip: short panels, for the place is not known
    parts = np.concatenate([2.0 ** np.arange(-8.0, -3.0), np.arange(2.0, 33.0) / 32.0])
    ends = sorted({*(s * parts), *([sliding] if sliding < s else []), 0.0})
    under = panels(lambda x: friction.shear(state).at_shift(x).tangential_force, ends)
    T = friction.shear(state).at_shift(s).tangential_force
    # the branch 2 T(x/2) over 0..2 s leaves the chord: area = 8 int T dx - 4 T s
    near(loop.dissipated_energy, 8.0 * under - 4.0 * T * s, 1e-8, size=T * s)


@relation(
    30,
    tip=d.simple_tips,
    material=d.materials,
    mu=frictions,
    share=d.shares,
    path=st.lists(st.tuples(st.floats(0.3, 1.0), st.floats(-1.2, 1.2)), min_size=2, max_size=6),
)
def test_one_step_or_many(tip, material, mu, share, path):
    """A path of depth and shift in one step each against the same path in 7 steps each; and against its mirror image."""
    friction, state = pressed(tip, mdr.Homogeneous(material), share, mu)
    unit = friction.shear(state).sliding_shift
    depth, shift = (np.array(column) * size for column, size in zip(zip(*path, strict=True), (state.depth, unit), strict=True))
    one, many, mirror = (friction.history() for _ in range(3))
    first = one.advance(depth=depth, shift=shift)
    corners = np.arange(len(depth) + 1)
    fine = np.linspace(0.0, len(depth), 7 * len(depth) + 1)[1:]
    last = many.advance(depth=np.interp(fine, corners, [0.0, *depth]), shift=np.interp(fine, corners, [0.0, *shift]))
    size = mu * state.force
    near(last.tangential_force[6::7], first.tangential_force, 1e-10, size=size)
    near(last.dissipated_energy[6::7], first.dissipated_energy, 1e-9, size=size * unit)
    turned = mirror.advance(depth=depth, shift=-shift)
    near(turned.tangential_force, -first.tangential_force, 1e-14, size=size)
    assert np.all(np.diff(last.dissipated_energy) >= -1e-13 * size * unit)
    assert np.all(
        np.abs(last.tangential_force)
        <= mu * many.friction.contact.at_depth(np.interp(fine, corners, [0.0, *depth])).force * (1.0 + 1e-10)
    )


@relation(
    30,
    tip=d.one_tip,
    material=d.materials,
    mu=frictions,
    share=d.shares,
    parts_=st.lists(st.floats(-1.3, 1.3), min_size=2, max_size=5),
)
def test_history_at_constant_force_is_first_shear_and_masing(tip, material, mu, share, parts_):
    """First shear by steps against at_shift, the return against Masing's rule, energy against the work of T on a closed path."""
    friction, state = pressed(tip, mdr.Homogeneous(material), share, mu)
    unit, size = friction.shear(state).sliding_shift, mu * state.force
    history = friction.history()
    history.advance(force=state.force, shift=0.0)
    turn = abs(parts_[0]) * unit + 1e-3 * unit
    near(
        history.advance(force=state.force, shift=turn).tangential_force,
        friction.shear(state).at_shift(turn).tangential_force,
        1e-9,
        size=size,
    )
    back = turn - np.linspace(0.0, 2.0, 9)[1:] * turn
    found = history.advance(force=np.full(8, state.force), shift=back).tangential_force
    top = friction.shear(state).at_shift(turn).tangential_force
    near(found, top - 2.0 * friction.shear(state).at_shift(0.5 * (turn - back)).tangential_force, 1e-9, size=size)
    # after two cycles the loop is closed: what is lost is its area
    fine = np.concatenate([np.linspace(-turn, turn, 400), np.linspace(turn, -turn, 400)[1:]])
    path = history.advance(force=np.full(len(fine), state.force), shift=fine)
    lost = path.dissipated_energy[-1] - path.dissipated_energy[0]
    near(lost, friction.shear(state).cycle_energy(turn), 1e-8, size=size * unit)


@relation(
    30,
    R=d.lengths,
    material=d.materials,
    mu=frictions,
    angle=d.angles,
    steps=st.lists(st.floats(-1.0, 1.0), min_size=2, max_size=6),
)
def test_laws_of_friction_turn_with_the_path(R, material, mu, angle, steps):
    """Forces along a straight path at an angle against those along x, turned; first shear against the contact; the law pickled."""
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)), mu)
    law = mdr.ContactLaw(friction.contact, 0.1 * R, friction=friction, tolerance=1e-8)
    state = friction.contact.at_depth(0.05 * R)
    unit = friction.shear(state).sliding_shift
    memory = [law.contacts(1) for _ in range(3)]
    direction = np.array([[math.cos(angle), math.sin(angle)]])
    for contact in memory:
        law.advance(contact, [state.force], [[0.0, 0.0]])
    copy = pickle.loads(pickle.dumps(law))
    for k, step in enumerate(steps):
        along = law.advance(memory[0], [state.force], [[step * unit, 0.0]])
        aside = law.advance(memory[1], [state.force], step * unit * direction)
        near(aside, along[0, 0] * direction, 1e-11, size=mu * state.force)
        same(copy.advance(memory[2], [state.force], [[step * unit, 0.0]]), along)
        if k == 0:
            first = friction.shear(state).at_shift(step * unit).tangential_force
            # the largest error at 49 places is not quite the largest of all
            near(along[0, 0], first, 1.25 * law.first_shear_error, size=mu * state.force)
    assert abs(along[0, 0]) <= mu * state.force * (1.0 + 1e-9)


@relation(
    40,
    tip=d.one_tip,
    medium=media,
    mu=frictions,
    share=d.shares,
    part=parts,
    unit=st.tuples(d.between(1e-6, 1e6), d.between(1e-6, 1e6)),
)
def test_units_of_friction(tip, medium, mu, share, part, unit):
    """Shear in other units of length and modulus."""
    s, t = unit
    friction, state = pressed(tip, medium, share, mu)
    other = mdr.Friction(mdr.Contact(in_units(tip.profile, s), in_units(medium, s, t)), mu)
    again = other.contact.at_radius(state.radius * s)
    x = part * friction.shear(state).sliding_shift
    one, two = friction.shear(state).at_shift(x), other.shear(again).at_shift(x * s)
    near(two.tangential_force, one.tangential_force * s * s * t, 1e-8)
    near(two.dissipated_energy, one.dissipated_energy * s**3 * t, 1e-6)


@relation(30, tip=d.one_tip, material=d.usual, mu=frictions, share=d.shares, part=parts, h=d.thicknesses)
def test_film_of_the_substrates_material_under_shear(tip, material, mu, share, part, h):
    """A film of its substrate's material against the half-space, exact and with Gao's weights."""
    friction, state = pressed(tip, mdr.Homogeneous(material), share, mu)
    s = part * friction.shear(state).sliding_shift
    expected = friction.shear(state).at_shift(s)
    for model in ("exact", "gao"):
        other, again = pressed(tip, mdr.Coated(material, h, material, model), share, mu)
        found = other.shear(again).at_shift(s)
        near(found.tangential_force, expected.tangential_force, 1e-7)
        near(found.dissipated_energy, expected.dissipated_energy, 1e-5, size=mu * state.force * s)


@relation(60, R=d.lengths, material=d.usual, mu=frictions, a=d.between(0.01, 1.0), inner=st.floats(0.01, 0.98))
def test_lubkin(R, material, mu, a, inner):
    """Twist and stick radius against Lubkin's closed form by SciPy's elliptic integrals; small twists against 16 G a^3/3."""
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)), mu)
    state, G = friction.contact.at_radius(a), shear(material)
    unit = 3.0 * mu * state.force / (4.0 * math.pi * G * a * a)
    twist = unit * (special.ellipkm1(inner**2) - special.ellipe(1.0 - inner**2))
    found = friction.twist(state).at_shift(twist)
    near(found.stick_radius, inner * a, 1e-8)
    near(friction.twist(state).at_shift(1e-7 * unit).tangential_force, 16.0 / 3.0 * G * a**3 * 1e-7 * unit, 1e-4)
    near(friction.twist(state).sliding_force, 3.0 * math.pi / 16.0 * mu * state.force * a, 1e-11)
    near(found.stiffness, 16.0 / 3.0 * G * (inner * a) ** 3, 1e-7)


@relation(8, tip=d.closed_tips, material=d.usual, mu=frictions, share=d.shares, part=d.between(0.01, 0.9))
def test_torsion(tip, material, mu, share, part):
    """M against integrals of traction and line load and at_shift, dM/dphi by differences, a loop against its area."""
    friction, state = pressed(tip, mdr.Homogeneous(material), share, mu)
    twist, a = friction.twist(state), state.radius
    found = twist.at_force(part * twist.sliding_force)
    again = twist.at_shift(found.shift)
    near(again.tangential_force, found.tangential_force, 1e-9)
    assume(tip.corner is None)
    c = found.stick_radius
    near(2.0 * math.pi * disc(lambda r: r * r * twist.traction(r, found), a, c), found.tangential_force, 1e-6)
    near(4.0 * disc(lambda x: x * twist.line_load(x, found), a, c), found.tangential_force, 1e-6)
    step = 1e-3 * found.shift
    M = [twist.at_shift(found.shift + k * step).tangential_force for k in (-2, -1, 1, 2)]
    near((M[0] - 8.0 * M[1] + 8.0 * M[2] - M[3]) / (12.0 * step), found.stiffness, 1e-5, size=found.tangential_force / found.shift)
    under = panels(lambda x: twist.at_shift(x).tangential_force, found.shift * np.concatenate([[0.0], 2.0 ** np.arange(-5.0, 1.0)]))
    lost = twist.loop(found.shift).dissipated_energy
    near(lost, 8.0 * under - 4.0 * found.tangential_force * found.shift, 1e-6, size=found.tangential_force * found.shift)


@relation(20, tip=d.simple_tips, medium=media, mu=frictions, share=d.shares)
def test_shear_grows_to_sliding(tip, medium, mu, share):
    """T(s) against itself: grows, with falling stiffness and stick radius, to mu F at the sliding shift."""
    friction, state = pressed(tip, medium, share, mu)
    s = friction.shear(state).sliding_shift * np.array([1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0 - 1e-9])
    found = friction.shear(state).at_shift(s)
    grows(found.tangential_force)
    grows(found.dissipated_energy)
    grows(-found.stick_radius)
    near(friction.shear(state).at_shift(1.5 * s[-1]).tangential_force, mu * state.force, 1e-12)
    near(found.tangential_force[0], float(medium.tangential_stiffness(state.radius)) * s[0], 0.02)
