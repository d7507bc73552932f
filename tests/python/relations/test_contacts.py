# SPDX-License-Identifier: GPL-3.0-or-later
"""States and fields of contacts without adhesion."""

import math
import pickle

import numpy as np
from conftest import numbers_of
from hypothesis import assume
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .draws import digits
from .harness import grows, near, relation, same
from .references import disc, panels, power_law_contact, reduced
from .rescale import in_units

NAMESPACE = {name: getattr(mdr, name) for name in mdr.__all__}


@relation(60, tip=d.tips, medium=d.everything, share=d.shares)
def test_growth(tip, medium, share):
    """F, a, k against each other: positive, growing with d. The stiffness of a formula need not: E_eff may fall faster than 1/a."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(tip.radii(share))
    for values in (state.depth, state.radius, state.force):
        assert np.all(np.asarray(values) > 0.0), values
        grows(values)
    assert np.all(state.stiffness > 0.0)
    if d.is_exact(medium):
        grows(state.stiffness)
    near(state.stiffness, medium.stiffness(state.radius), digits(medium))
    near(state.stiffness, 2.0 * state.radius * medium.modulus(state.radius), digits(medium))


@relation(60, tip=d.tips, medium=d.everything, share=d.shares)
def test_inverses(tip, medium, share):
    """Depth, force and radius lead to the same states."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(tip.radii(share))
    for found in (contact.at_depth(state.depth), contact.at_force(state.force)):
        for value, expected in zip(numbers_of(found), numbers_of(state), strict=True):
            near(value, expected, digits(medium))


@relation(60, tip=d.tips, medium=d.everything, share=d.shares, unit=d.units)
def test_units(tip, medium, share, unit):
    """The same contact in other units: depths times s, forces times s^2 t, stiffnesses times s t."""
    s, t = unit
    small = mdr.Contact(tip.profile, medium).at_radius(tip.radii(share))
    large = mdr.Contact(in_units(tip.profile, s), in_units(medium, s, t)).at_radius(tip.radii(share) * s)
    near(large.depth, small.depth * s, digits(medium))
    near(large.force, small.force * s * s * t, digits(medium))
    near(large.stiffness, small.stiffness * s * t, digits(medium))


@relation(60, tip=d.tips, medium=d.everything, share=d.shares)
def test_stiffness_is_the_derivative(tip, medium, share):
    """dF/dd by differences against k."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(tip.radii(share))
    step = 2e-3 * state.depth
    force = [contact.at_depth(state.depth + i * step).force for i in (-2, -1, 1, 2)]
    found = (force[0] - 8.0 * force[1] + 8.0 * force[2] - force[3]) / (12.0 * step)
    # a difference that reaches across a corner of the tip is not one of fourth order
    smooth = np.abs(state.radius / (tip.corner or math.inf) - 1.0) > 0.05
    near(found[smooth], state.stiffness[smooth], 1e-6)


@relation(40, tip=d.one_tip, medium=d.everything, share=d.shares)
def test_force_is_an_integral(tip, medium, share):
    """F against twice the integral of the line load and the integral of the pressure."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(float(tip.radii(share)[-1]))
    near(2.0 * disc(lambda x: state.line_load(x), state.radius, tip.corner), state.force, 1e-8)
    near(2.0 * math.pi * disc(lambda r: r * state.pressure(r), state.radius, tip.corner), state.force, 1e-7)


@relation(40, tip=d.tips, medium=st.one_of(d.homogeneous, d.formulas, d.exact_layers), share=d.shares)
def test_surface_has_the_shape_of_the_indenter(tip, medium, share):
    """u = d - f(r) under the indenter; it leaves it without a step; the pressure of a formula pushes."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(float(tip.radii(share)[-1]))
    a, depth = state.radius, state.depth
    r = a * np.linspace(0.01, 0.99, 9)
    near(state.displacement(r), depth - contact.indenter.height(r), 1e-9, size=depth)
    outside = state.displacement(a * np.array([1.0 + 1e-9, 2.0, 5.0]))
    near(outside[0], depth - contact.indenter.height(a), 2e-4, size=depth)
    assert np.all(np.isfinite(outside))
    if not d.is_exact(medium):
        assert np.all(state.pressure(r) > 0.0)


@relation(40, first=d.one_tip, second=d.simple_tips, medium=d.everything, share=d.shares)
def test_superposition(first, second, medium, share):
    """A sum of indenters at one contact radius against the sums of depths, forces and pressures of each."""
    tip = d.sum_of(first, second)
    assume(d.overlap(tip))
    a = tip.radii(share)
    contacts = [mdr.Contact(t.profile, medium) for t in (tip, first, second)]
    both, one, other = (contact.at_radius(a) for contact in contacts)
    near(both.depth, one.depth + other.depth, digits(medium))
    near(both.force, one.force + other.force, digits(medium))
    near(both.stiffness, one.stiffness, digits(medium))
    r = a[-1] * np.linspace(0.05, 0.9, 5)
    whole, *parts = (contact.at_radius(float(a[-1])).pressure(r) for contact in contacts)
    near(whole, parts[0] + parts[1], 10.0 * digits(medium), size=both.force[-1] / a[-1] ** 2)


@relation(40, tip=d.one_tip, medium=st.one_of(d.homogeneous, d.analytic_formulas, d.exact_layers), share=d.shares)
def test_energy_is_the_work(tip, medium, share):
    """W against int F dd by Gauss and Legendre, over octaves of the contact radius or of the depth of a flat end."""
    contact = mdr.Contact(tip.profile, medium)
    top = float(tip.radii(share)[-1])
    state = contact.at_radius(top)
    if tip.flat:
        ends = state.depth * np.geomspace(1e-6, 1.0, 15)
    else:
        corners = {tip.corner} if tip.corner and tip.corner < top else set()
        ends = contact.at_radius(np.array(sorted({*(top * 2.0 ** np.arange(-12.0, 1.0)), *corners}))).depth
    work = panels(lambda depth: contact.at_depth(depth).force, ends)
    near(state.energy() - contact.at_depth(float(ends[0])).energy(), work, 10.0 * digits(medium))


@relation(30, lower=d.exact_layers | d.homogeneous, upper=d.single_exact | d.homogeneous, tip=d.one_tip, share=d.shares)
def test_two_bodies_share_depth_and_energy(lower, upper, tip, share):
    """The parts of both bodies against their sums: u, W; F and d against the contact with the bodies swapped."""
    assume(not isinstance(lower, mdr.Pair) and d.is_exact(lower))
    contact = mdr.Contact(tip.profile, mdr.Pair(lower, upper))
    swapped = mdr.Contact(tip.profile, mdr.Pair(upper, lower))
    state = contact.at_radius(float(tip.radii(share)[-1]))
    other = swapped.at_radius(state.radius)
    near(other, state, digits(contact.medium))
    r = state.radius * np.array([0.0, 0.3, 0.9, 1.5, 4.0])
    parts = [state.displacement(r, body=body) for body in ("lower", "upper")]
    near(parts[0] + parts[1], state.displacement(r), 1e-8, size=state.depth)
    near(other.displacement(r, body="upper"), parts[0], 1e-8, size=state.depth)
    energies = [state.energy(body=body) for body in ("lower", "upper")]
    near(sum(energies), state.energy(), 1e-13)
    near(other.energy(body="upper"), energies[0], 1e-8, size=sum(energies))


@relation(60, n=st.floats(0.3, 12.0), c=d.between(1e-3, 1e3), material=d.extreme, a=d.between(1e-6, 1e6))
def test_power_laws_on_a_half_space(n, c, material, a):
    """Galin's closed form of f = c r^n, by SciPy's gamma functions; Hertz and Sneddon among them."""
    contact = mdr.Contact(mdr.PowerLaw(n, c), mdr.Homogeneous(material))
    state = contact.at_radius(a)
    depth, force = power_law_contact(n, c, reduced(material), a)
    near(state.depth, depth, 1e-12)
    near(state.force, force, 1e-12)
    near(contact.at_depth(depth).radius, a, 1e-11)


@relation(40, R=d.between(1e-6, 1e6), material=d.extreme, share=st.floats(1e-6, 0.99))
def test_hertz_and_the_sphere(R, material, share):
    """Hertz's F, p, u outside and W; the sphere by Segedin's closed form."""
    modulus, a = reduced(material), share * R
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material))
    state = contact.at_radius(a)
    near(state.force, 4.0 / 3.0 * modulus * a**3 / R, 1e-13)
    near(state.energy(), 8.0 / 15.0 * modulus * a**5 / R**2, 1e-12)
    r = a * np.array([0.0, 0.5, 0.99])
    near(state.pressure(r), 2.0 * modulus / (math.pi * R) * np.sqrt(a * a - r * r), 1e-12)
    out = a * np.array([1.01, 2.0, 30.0])
    u = ((2.0 * a * a - out**2) * np.arcsin(a / out) + a * np.sqrt(out**2 - a * a)) / (math.pi * R)
    near(state.displacement(out), u, 1e-12, size=state.depth)
    sphere = mdr.Contact(mdr.Sphere(R), mdr.Homogeneous(material)).at_radius(a)
    near(sphere.depth, a * math.atanh(share), 1e-12)
    # (R^2 + a^2)/2 ln((R + a)/(R - a)) - a R loses the digits of small a
    if share > 0.05:
        near(sphere.force, modulus * ((R * R + a * a) * math.atanh(share) - a * R), 1e-11)


@relation(30, tip=d.simple_tips, medium=st.one_of(d.exact_films, d.homogeneous), share=d.shares)
def test_far_away_the_surface_is_that_of_a_point_force(tip, medium, share):
    """u far beyond a, and beyond h times the contrast, against F/(pi E* r) of the substrate: what differs falls as r^-3."""
    base = medium.material if isinstance(medium, mdr.Homogeneous) else medium.substrate
    assume(base is not mdr.RIGID)
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(float(tip.radii(share)[-1]))
    contrast = medium.coating.E / base.E if isinstance(medium, mdr.Coated) else 1.0
    far = 3e4 * max(state.radius, getattr(medium, "thickness", 0.0)) * max(contrast, 1.0)
    near(state.displacement(far), state.force / (math.pi * reduced(base) * far), 1e-6)


@relation(
    30, R=d.lengths, shears=st.tuples(d.between(1e-2, 1e2), d.between(1e-2, 1e2)), h=d.extreme_thicknesses, phi=d.inclinations
)
def test_closed_forms_of_the_source(R, shears, h, phi):
    """Equations (24), (27), (29) against contacts with the model gao at nu = 1/2."""
    film, base = (mdr.Elastic(3.0 * G, 0.5) for G in shears)
    a = np.geomspace(0.05, 20.0, 4)
    medium = mdr.Coated(film, h, base, "gao")
    near(
        mdr.Contact(mdr.Paraboloid(R), medium).at_radius(a).force, mdr.closed_forms.coated_paraboloid_force(a, R, *shears, h), 1e-11
    )
    near(mdr.Contact(mdr.Cone(phi), medium).at_radius(a).force, mdr.closed_forms.coated_cone_force(a, phi, *shears, h), 1e-11)
    gamma = 1e-3 * shears[0]
    found = mdr.Contact(mdr.Paraboloid(R), medium, gamma, "paper").at_radius(a).depth
    expected = mdr.closed_forms.coated_paraboloid_adhesive_depth(a, R, *shears, h, gamma)
    near(found, expected, 1e-11, size=np.abs(expected) + a * a / R)


@relation(40, tip=d.tips, medium=d.everything, share=d.shares, threads=st.integers(2, 4))
def test_threads_give_the_same_bits(tip, medium, share, threads):
    """An array on several threads against the same array on one, and against the same numbers one by one."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(tip.radii(share))
    depth = np.repeat(state.depth, 20).reshape(2, 2, -1)
    one = contact.at_depth(depth)
    mdr.set_threads(threads)
    try:
        many = contact.at_depth(depth)
    finally:
        mdr.set_threads(1)
    for column, expected in zip(numbers_of(many), numbers_of(one), strict=True):
        same(column, expected)
    first = [np.ravel(np.broadcast_to(column, depth.shape))[0] for column in numbers_of(many)]
    near(contact.at_depth(float(depth[0, 0, 0])), first, 1e-12)


@relation(40, tip=d.tips, medium=d.everything, share=d.shares)
def test_repr_and_pickle_rebuild(tip, medium, share):
    """eval(repr(.)) and the pickled object against the object: equal, with the same bits."""
    contact = mdr.Contact(tip.profile, medium)
    a = tip.radii(share)
    for copy in (eval(repr(contact), dict(NAMESPACE)), pickle.loads(pickle.dumps(contact))):
        assert copy == contact and hash(copy) == hash(contact)
        for value, expected in zip(numbers_of(copy.at_radius(a)), numbers_of(contact.at_radius(a)), strict=True):
            same(value, expected)


@relation(30, radii=st.tuples(d.lengths, d.lengths), medium=d.everything, a=d.between(0.01, 0.2))
def test_curvatures_add(radii, medium, a):
    """A sum of two paraboloids against the paraboloid between both, and against Paraboloid.between."""
    total = mdr.Paraboloid(1.0 / (1.0 / radii[0] + 1.0 / radii[1]))
    expected = mdr.Contact(total, medium).at_radius(a)
    for gap in (mdr.Paraboloid(radii[0]) + mdr.Paraboloid(radii[1]), mdr.Paraboloid.between(*radii)):
        near(mdr.Contact(gap, medium).at_radius(a), expected, digits(medium))


@relation(30, medium=d.extreme_films, R=d.lengths, a=d.between(0.1, 3.0), may_refuse=0.4)
def test_extreme_films(medium, R, a):
    """Films of contrasts to 1e6 at a/h from 1e-4 to 1e3: dF/dd by differences, inverses, and the scaling in R."""
    contact = mdr.Contact(mdr.Paraboloid(R), medium)
    state = contact.at_radius(a)
    near(contact.at_depth(state.depth), state, 1e-8)
    near(contact.at_force(state.force), state, 1e-8)
    wider = mdr.Contact(mdr.Paraboloid(3.0 * R), medium).at_radius(a)
    near(3.0 * wider.force, state.force, 1e-10)
    near(3.0 * wider.depth, state.depth, 1e-10)
    step = 1e-3 * state.depth
    force = [contact.at_depth(state.depth + i * step).force for i in (-2, -1, 1, 2)]
    near((force[0] - 8.0 * force[1] + 8.0 * force[2] - force[3]) / (12.0 * step), state.stiffness, 1e-5)


@relation(20, medium=st.one_of(d.exact_layers, d.formulas), tip=d.simple_tips, share=d.shares)
def test_exact_zeta_changes_the_radius_alone(medium, tip, share):
    """zeta = 1 given as a table against no zeta: the same states."""
    a = tip.radii(share)
    assume(not d.is_exact(medium))
    table = (np.geomspace(1e-4, 10.0, 5), np.ones(5))
    near(mdr.Contact(tip.profile, medium, zeta=table).at_radius(a).force, mdr.Contact(tip.profile, medium).at_radius(a).force, 1e-9)
