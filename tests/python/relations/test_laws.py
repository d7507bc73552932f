# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws against the contacts they are made from, and against themselves."""

import copy
import pickle

import numpy as np
import pytest
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation, same
from .references import panels

media = st.one_of(d.homogeneous, d.analytic_formulas, d.exact_films)
works = st.one_of(st.just(0.0), d.works)
tolerances = d.between(1e-10, 1e-4)


def law_of(tip, medium, work, share, tolerance):
    """Contact, law, and depths from first touch to its end, where the tolerance holds."""
    largest = mdr.Contact(tip.profile, medium).at_radius(float(tip.radii(share)[-1])).depth
    contact = d.adhesive(tip, medium, work)
    law = mdr.ContactLaw(contact, float(largest), tolerance=tolerance)
    return contact, law, largest * np.geomspace(1.001e-4, 1.0, 23)


@relation(30, may_refuse=0.2, tip=d.endless_tips, medium=media, work=works, share=d.shares, tolerance=tolerances)
def test_a_law_keeps_its_tolerance(tip, medium, work, share, tolerance):
    """F, a and k of the law between its knots against the contact."""
    contact, law, depth = law_of(tip, medium, work, share, tolerance)
    for branch in ("loading", "unloading"):
        expected, found = contact.at_depth(depth, branch), law.at_depth(depth, branch)
        near(found.force, expected.force, 2.0 * tolerance, size=np.abs(expected.force) + np.abs(depth * found.slope))
        if work == 0.0:
            near(found.radius, expected.radius, 2.0 * tolerance)
            near(found.stiffness, expected.stiffness, 2.0 * tolerance)


stiff = d.between(10.0, 1000.0).map(lambda E: mdr.Elastic(E, 0.3))
stiff_films = st.builds(mdr.Coated, stiff, d.between(0.05, 3.0), st.just(mdr.Elastic(1.0, 0.3)),
                        st.sampled_from(["exact", "doerner-nix", "mencik-exponential", "gao"]))  # fmt: skip
pointed = st.one_of(d.cones, d.rounded_cones, st.builds(lambda n, c: d.Tip(mdr.PowerLaw(n, c)), st.floats(1.0, 1.6), d.lengths))


@relation(3, may_refuse=0.8, tip=pointed, medium=stiff_films, work=d.between(1e-3, 10.0), reach=d.between(0.03, 10.0),
          shares=st.lists(st.floats(0.001, 0.999), min_size=9, max_size=9))  # fmt: skip
def test_branches_of_contacts_that_jump(tip, medium, work, reach, shares):
    """d(a) and F(a) of a point on a stiff film turn more than once: F and a of a law at random depths, and d and a under random
    forces, on both branches against the contact, however far the law is to reach."""
    contact = mdr.Contact(tip.profile, medium, work * medium.modulus(medium.thickness) * medium.thickness)
    law = mdr.ContactLaw(contact, reach * abs(float(contact.pull_off("depth").depth)), tolerance=1e-7)
    shares = np.array(shares)
    for branch in ("loading", "unloading"):
        low, high = law.depth_range
        depth = (max(low, 0.0) if branch == "loading" else low) * (1.0 - shares) + high * shares
        expected, found = contact.at_depth(depth, branch), law.at_depth(depth, branch)
        near(found.force, expected.force, 3e-7, size=np.abs(expected.force) + np.abs(depth * found.slope))
        low, high = law.force_range
        if branch == "loading" and high <= 0.0:
            continue
        force = (max(low, 0.0) if branch == "loading" else low) * (1.0 - shares) + high * shares
        expected, found = contact.at_force(force, branch), law.at_force(force, branch)
        near(found.depth, expected.depth, 3e-7, size=np.abs(expected.depth) + np.abs(force / found.slope))


@relation(2, tip=d.paraboloids, medium=d.plated, share=d.shares)
def test_laws_under_plates(tip, medium, share):
    """A law of bodies under plates, which begin at a radius of their own, against the contact from there on; and it begins at the
    depth at which the contact does."""
    contact = mdr.Contact(tip.profile, medium)
    largest = float(contact.at_radius(float(tip.radii(share)[-1])).depth)
    law = mdr.ContactLaw(contact, largest, tolerance=1e-7)
    first = law.depth_range[0]
    if first > 1.1e-4 * largest:
        with pytest.raises(mdr.MDRError, match="where the medium begins|the lowest force"):
            contact.at_depth(0.99 * first)
    depth = np.geomspace(first * (1.0 + 1e-4), largest, 9)
    expected, found = contact.at_depth(depth), law.at_depth(depth)
    near(found.force, expected.force, 2e-7)
    near(found.radius, expected.radius, 2e-7)


@relation(30, may_refuse=0.2, tip=d.endless_tips, medium=media, work=works, share=d.shares)
def test_inverse_and_slope(tip, medium, work, share):
    """at_force of the force at a depth against the depth; slope against differences of the force; k without adhesion."""
    _, law, depth = law_of(tip, medium, work, share, 1e-9)
    depth = depth[8:-1]
    state = law.at_depth(depth)
    rising = state.force > np.max([0.0, 1e-3 * float(state.force[-1])])
    near(law.at_force(state.force[rising]).depth, depth[rising], 1e-7)
    step = 1e-4 * depth
    found = (law.force(depth + step) - law.force(depth - step)) / (2.0 * step)
    size = np.abs(state.slope) + np.abs(state.force) / depth
    if tip.corner is None:
        near(found, state.slope, 1e-4, size=size)
    if work == 0.0:
        near(state.slope, state.stiffness, 1e-6)


@relation(30, may_refuse=0.2, tip=d.endless_tips, medium=media, work=works, share=d.shares)
def test_energy_is_the_integral(tip, medium, work, share):
    """U(d) between depths against int F dd by Gauss and Legendre, and against W of the contact."""
    contact, law, depth = law_of(tip, medium, work, share, 1e-9)
    ends = depth[::2]
    near(
        law.energy(ends[-1]) - law.energy(ends[0]),
        panels(law.force, np.interp(np.linspace(0.0, 1.0, 65), np.linspace(0.0, 1.0, len(ends)), ends)),  # a corner, a coating
        1e-6,
        size=law.energy(ends[-1]) - law.energy(law.depth_range[0]),
    )
    if work == 0.0:
        # nearer to first touch than 1e-4 of its range the law is a power of d, whose energy is off by up to 5 % of itself
        found = [contact.at_depth(float(x)).energy() for x in ends]
        touch = contact.at_depth(1e-4 * float(ends[-1])).energy()
        near(law.energy(ends), found, 1e-7, size=np.array(found) + 0.05e7 * touch)


@relation(12, may_refuse=0.2, tip=d.endless_tips, medium=media, work=works, share=d.shares)
def test_saved_and_loaded(tip, medium, work, share):
    """The law from its bytes, pickled and copied against the law: the same bits."""
    _, law, depth = law_of(tip, medium, work, share, 1e-7)
    for other in (mdr.ContactLaw.from_bytes(law.to_bytes()), pickle.loads(pickle.dumps(law)), copy.copy(law)):
        assert other == law and hash(other) == hash(law) and other.description == law.description
        for found, expected in zip(other.at_depth(depth), law.at_depth(depth), strict=True):
            same(found, expected)


@relation(20, may_refuse=0.2, tip=d.endless_tips, medium=media, work=works, share=d.shares)
def test_arrays_and_floats(tip, medium, work, share):
    """A law of an array against the same numbers one by one: the same to rounding."""
    _, law, depth = law_of(tip, medium, work, share, 1e-7)
    for i in (0, 7, 22):
        near([float(v) for v in law.at_depth(float(depth[i]))], [float(v[i]) for v in law.at_depth(depth)], 1e-13,
             size=np.abs([float(v[-1]) for v in law.at_depth(depth)]))  # fmt: skip
        near(law.force(float(depth[i])), law.force(depth)[i], 1e-13, size=abs(law.force(depth)[-1]))


@relation(20, R=d.lengths, factor=d.between(0.1, 10.0), medium=media)
def test_other_radii(R, factor, medium):
    """The law of one paraboloid taken to another radius against the contact with that radius."""
    law = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(R), medium), 0.1, tolerance=1e-8)
    other = law.with_radius(R * factor)
    depth = other.depth_range[1] * np.geomspace(1e-3, 1.0, 9)
    near(other.force(depth), mdr.Contact(mdr.Paraboloid(R * factor), medium).at_depth(depth).force, 1e-7)


@relation(20, tip=d.endless_tips, medium=media, share=d.shares, apart=d.between(1e-3, 1e3))
def test_apart_and_beyond(tip, medium, share, apart):
    """Apart the law is 0; beyond its end it is the tangent there."""
    contact, _, depth = law_of(tip, medium, 0.0, share, 1e-6)
    law = mdr.ContactLaw(contact, float(depth[-1]), tolerance=1e-6, continue_beyond=True)
    assert law.force(-apart * float(depth[-1])) == 0.0
    end = law.at_depth(law.depth_range[1])
    beyond = law.depth_range[1] * (1.0 + apart)
    near(law.force(beyond), end.force + end.slope * apart * law.depth_range[1], 1e-9)


@relation(20, R=d.lengths, material=d.materials, work=d.works, unit=st.tuples(d.between(1e-6, 1e6), d.between(1e-6, 1e6)))
def test_units_of_laws(R, material, work, unit):
    """A law in other units of length and modulus."""
    s, t = unit
    gamma = work * material.E

    def law(m, n):
        medium = mdr.Homogeneous(material.replace(E=material.E * n))
        return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(R * m), medium, gamma * m * n), 0.1 * m)

    x = np.linspace(0.02, 0.1, 7)
    one, two = law(1.0, 1.0).at_depth(x), law(s, t).at_depth(x * s)
    near(two.force, one.force * s * s * t, 1e-8, size=np.abs(one.force) * s * s * t + x * one.slope * s * s * t)
    near(two.radius, one.radius * s, 1e-7)
