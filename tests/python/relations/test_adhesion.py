# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with adhesion: states, pull-off, loops, energies."""

import math

import numpy as np
import pytest
from hypothesis import assume
from hypothesis import strategies as st
from scipy import optimize

import mdrcontact as mdr

from . import draws as d
from .harness import grows, near, relation
from .references import panels, reduced
from .rescale import in_units

bodies = st.one_of(d.homogeneous, d.analytic_formulas, d.exact_layers)


def rule_that_holds(medium, rule):
    """The energy rule refuses formulas whose stiffness falls somewhere: those are left out."""
    k = np.asarray(medium.stiffness(np.geomspace(1e-6, 1e4, 400)[100:300]))
    assume(rule != "energy" or np.all(np.diff(k) > 0.0))


@relation(50, tip=d.adhesive_tips, medium=bodies, work=d.works, rule=d.rules, share=d.shares)
def test_states(tip, medium, work, rule, share):
    """Adhesion takes k times the depth it takes from the force; states by depth and force against those by radius."""
    rule_that_holds(medium, rule)
    contact, a = d.adhesive(tip, medium, work, rule), tip.radii(share, 3)
    bare, state = mdr.Contact(tip.profile, medium).at_radius(a), contact.at_radius(a)
    assert np.all(state.depth < bare.depth) and np.all(state.force < bare.force)
    missing = bare.depth - state.depth
    near(bare.force - state.force, state.stiffness * missing, 1e-8, size=state.stiffness * missing + 0.1 * np.max(bare.force))
    for branch in ("loading", "unloading"):
        held = contact.at_depth(bare.depth, branch)
        again = contact.at_radius(held.radius)
        near(again.depth, bare.depth, 1e-7)
        near(again.force, held.force, 1e-7, size=np.abs(held.force) + 1e-2 * np.max(bare.force))
        pressed = contact.at_force(bare.force, branch)
        near(contact.at_radius(pressed.radius).force, bare.force, 1e-7)
        # under given depth the force may fall, between the two pull-offs
        for values in (held.radius, pressed.radius, pressed.depth):
            grows(values)


@relation(25, tip=d.adhesive_tips, medium=bodies, work=d.works, rule=d.rules, unit=d.units)
def test_pull_off(tip, medium, work, rule, unit):
    """Pull-off against states just above and just below it, and against that in other units."""
    rule_that_holds(medium, rule)
    s, t = unit
    small = d.adhesive(tip, medium, work, rule)
    gamma = small.work_of_adhesion * s * t
    large = mdr.Contact(in_units(tip.profile, s), in_units(medium, s, t), work_of_adhesion=gamma, adhesion_rule=rule)
    by_force, by_depth = small.pull_off(), small.pull_off("depth")
    assert by_force.force < 0.0 and by_force.force <= by_depth.force and by_depth.depth <= by_force.depth
    near(small.at_force(by_force.force * (1.0 - 1e-6)).force, by_force.force, 2e-6)
    assert small.at_depth(by_depth.depth + 1e-6 * abs(by_depth.depth)).radius >= by_depth.radius * (1.0 - 1e-6)
    with pytest.raises(mdr.errors.UnreachableError):
        small.at_force(by_force.force * 1.0001)
    with pytest.raises(mdr.errors.UnreachableError):
        small.at_depth(by_depth.depth - 1e-4 * abs(by_depth.depth))
    for control, expected in (("force", by_force), ("depth", by_depth)):
        found = large.pull_off(control)
        near(found.depth, expected.depth * s, 1e-7, size=(abs(expected.depth) + 0.01 * expected.radius) * s)
        near(found.force, expected.force * s**2 * t, 1e-7)
        near(found.radius, expected.radius * s, 1e-4)  # at a flat minimum a radius is worth half the digits


@relation(60, R=d.between(1e-3, 1e3), material=d.extreme, reach=d.between(0.3, 100.0), size=d.between(1e-9, 1e-1))
def test_johnson_kendall_roberts(R, material, reach, size):
    """JKR's closed form of F(a), d(a), pull-off under force and depth, and Griffith's edge in W."""
    modulus = reduced(material)
    gamma = size * modulus * R
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material), work_of_adhesion=gamma)
    near(contact.pull_off("force").force, -1.5 * math.pi * gamma * R, 1e-11)
    near(contact.pull_off("depth").force, -5.0 / 6.0 * math.pi * gamma * R, 1e-11)
    a0 = (9.0 * math.pi * gamma * R * R / (8.0 * modulus)) ** (1.0 / 3.0)
    near(contact.pull_off("force").radius, a0, 1e-6)
    a = a0 * reach
    state = contact.at_radius(a)
    hertz, edge = 4.0 * modulus * a**3 / (3.0 * R), math.sqrt(8.0 * math.pi * gamma * modulus * a**3)
    near(state.force, hertz - edge, 1e-12, size=hertz + edge)
    below = math.sqrt(2.0 * math.pi * gamma * a / modulus)
    near(state.depth, a * a / R - below, 1e-12, size=a * a / R + below)
    # W of the pressed sphere drawn up as a punch: cross term F_hertz times the excess
    energy = 8.0 / 15.0 * modulus * a**5 / R**2 - hertz * below + modulus * a * below**2
    near(state.energy(), energy, 1e-11, size=8.0 / 15.0 * modulus * a**5 / R**2 + hertz * below)


@relation(40, phi=d.inclinations, material=d.extreme, size=d.between(1e-6, 1e2))
def test_adhesive_cones(phi, material, size):
    """Pull-off of a cone against the least of F(a) in closed form, by SciPy."""
    modulus, slope = reduced(material), math.tan(phi)
    contact = mdr.Contact(mdr.Cone(phi), mdr.Homogeneous(material), work_of_adhesion=size * modulus)

    def force(a):
        return modulus * (0.5 * math.pi * slope * a * a - math.sqrt(8.0 * math.pi * size * a**3))

    scale = size / slope**2
    least = optimize.minimize_scalar(force, bounds=(1e-3 * scale, 1e3 * scale), method="bounded", options={"xatol": 1e-9 * scale})
    near(contact.pull_off().force, least.fun, 1e-9)
    near(contact.pull_off().force, -54.0 / math.pi * size**2 * modulus / slope**3, 1e-10)


@relation(30, tip=d.endless_tips, medium=st.one_of(d.homogeneous, d.exact_films), work=d.works, share=d.shares)
def test_energy_balance_along_the_branch(tip, medium, work, share):
    """int F dd along the states of equilibrium, by Gauss and Legendre over the radius, against W - pi a^2 gamma."""
    contact = d.adhesive(tip, medium, work, "energy")
    ends = np.array([0.7, 1.0]) * float(tip.radii(share)[-1])
    corners = [tip.corner] if tip.corner and ends[0] < tip.corner < ends[1] else []
    edges = [ends[0], *corners, ends[1]]
    first, last = (contact.at_radius(float(a)) for a in ends)

    def force_by_radius(a):
        step = 1e-3 * a
        depth = [contact.at_radius(a + k * step).depth for k in (-2, -1, 1, 2)]
        return contact.at_radius(a).force * (depth[0] - 8.0 * depth[1] + 8.0 * depth[2] - depth[3]) / (12.0 * step)

    work_done = panels(force_by_radius, edges)
    gained = [s.energy() - math.pi * s.radius**2 * contact.work_of_adhesion for s in (first, last)]
    size = last.energy() + math.pi * last.radius**2 * contact.work_of_adhesion
    near(gained[1] - gained[0], work_done, 1e-5 if corners or tip.corner else 1e-7, size=size)


@relation(
    8,
    tip=d.adhesive_tips,
    medium=bodies,
    work=d.works,
    control=st.sampled_from(["force", "depth", "spring"]),
    soft=d.between(0.01, 3.0),
)
def test_loops(tip, medium, work, control, soft):
    """The area of a loop by trapezoids of its 800 points, with its jumps, against the energy lost; 800 points against 50."""
    contact = d.adhesive(tip, medium, work)
    top = contact.at_radius(0.9 * tip.high if tip.high < 3.0 else 1.0)
    assume(top.force > 0.0 and top.depth > 0.0)
    spring = {"spring_stiffness": soft * float(top.stiffness)} if control == "spring" else {}
    largest = {"force": top.force, "depth": top.depth, "spring": top.depth + top.force / (soft * top.stiffness)}[control]
    fine, coarse = (contact.loop(control, float(largest), n, **spring) for n in (800, 50))
    near(coarse.dissipated_energy, fine.dissipated_energy, 1e-6, size=fine.dissipated_energy)
    assert fine.dissipated_energy >= 0.0
    # a prescribed force works along the jumps in contact, where the bodies do not bear it; a prescribed depth does not move
    force, y = (fine.position, fine.depth) if control == "force" else (fine.force, fine.position)
    steps = 0.5 * (force[1:] + force[:-1]) * np.diff(y)
    if control == "force":
        steps[fine.jumps[-1]] = 0.0
    near(fine.dissipated_energy, np.sum(steps), 2e-3, size=np.sum(np.abs(steps)))


@relation(30, tip=d.adhesive_tips, medium=bodies, share=d.shares)
def test_no_adhesion_left(tip, medium, share):
    """A work of adhesion of 1e-20 E_eff against none."""
    a = tip.radii(share)
    left, bare = d.adhesive(tip, medium, 1e-20, "paper").at_radius(a), mdr.Contact(tip.profile, medium).at_radius(a)
    near(left.force, bare.force, 1e-8, size=bare.stiffness * a)
    near(left.depth, bare.depth, 1e-8, size=a)


@relation(30, tip=d.adhesive_tips, medium=bodies, work=d.works, share=d.shares)
def test_adhesive_pressure_carries_the_force(tip, medium, work, share):
    """F against twice the integral of the line load by Gauss and Legendre in the angle."""
    contact = d.adhesive(tip, medium, work, "paper")
    state = contact.at_radius(float(tip.radii(share)[-1]))
    corner = [math.asin(tip.corner / state.radius)] if tip.corner and tip.corner < state.radius else []
    graded = [*(0.5 * math.pi * 2.0 ** np.arange(-24.0, 0.0)), 0.5 * math.pi]
    carried = panels(
        lambda x: state.line_load(state.radius * np.sin(x)) * state.radius * np.cos(x), sorted([0.0, *corner, *graded])
    )
    near(2.0 * carried, state.force, 1e-8, size=mdr.Contact(tip.profile, medium).at_radius(state.radius).force)


held_films = st.builds(
    lambda film, h, stress, slides, base: mdr.Layered(
        [mdr.Layer(film, h, prestress=stress * film.E, interface=mdr.SLIDING if slides else mdr.Interface(tangential=1.0))], base
    ),
    d.usual,
    d.between(0.3, 3.0),
    st.floats(0.0, 0.1),
    st.booleans(),
    d.usual,
)


@relation(
    4,
    body=st.one_of(d.homogeneous, held_films),
    work=d.between(1e-4, 1e-2),
    exponent=st.sampled_from([0.5, 0.7, 1.0]),
    may_refuse=0.3,
)
def test_slow_edges_are_in_equilibrium(body, work, exponent):
    """A path far slower than the speed of the law against the states of the adhesive contact, down to half the pull-off depth."""
    gamma = work * body.modulus(1.0)
    rest = mdr.Contact(mdr.Paraboloid(1.0), body, work_of_adhesion=gamma)
    depth = np.array([0.1, 0.15, 0.05, 0.5 * rest.pull_off("depth").depth])
    contact = mdr.Contact(mdr.Paraboloid(1.0), body, adhesion=mdr.adhesion.RateAdhesion(gamma, 1.0, exponent))
    found = mdr.adhesion.rate_history(contact, np.arange(4) * 1e12, depth=depth, start="rest")
    wanted = rest.at_depth(depth)
    near(found.force, wanted.force, 1e-5, size=np.abs(wanted.force).max())
    near(found.radius, wanted.radius, 1e-5)
