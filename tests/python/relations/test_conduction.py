# SPDX-License-Identifier: GPL-3.0-or-later
"""Current and heat through bodies, and the heat of friction."""

import math
from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

import mdrcontact as mdr
from mdrcontact.conduction import PERFECT, Conduction, Conductor, LayeredConductor

from . import draws as d
from .harness import near, relation

K = np.geomspace(1e-3, 1e2, 6)
"""Wavenumbers."""
A = np.array([0.05, 0.5, 3.0])
"""Radii of spots."""
R = np.array([0.0, 0.4, 1.3, 3.0])
sigmas, thicknesses, resistances = d.between(0.1, 10.0), d.between(0.1, 5.0), st.one_of(st.just(0.0), d.between(0.02, 5.0))


class Stack(NamedTuple):
    """Layers of (sigma, along, thickness, resistance below) on a half-space, or None for a perfect base."""

    layers: list
    base: tuple | None

    def conductor(self) -> LayeredConductor:
        parts = [part for s, along, h, r in self.layers for part in ((Conductor(s, along), h), mdr.Interface(r))]
        return LayeredConductor(parts, PERFECT if self.base is None else Conductor(*self.base))

    def elastic(self, springs: bool = False) -> mdr.Layered:
        """Elastic layers that conduct as these do along the surface as well; springs: G = sigma, and 1/R along each interface."""

        def material(s, along):
            return mdr.Elastic(2.0 * 1.3 * s, 0.3, Conductor(s, s if springs else along))

        layers = [
            mdr.Layer(material(s, along), h, interface=mdr.Interface(r, tangential=1.0 / r if springs and r else None))
            for s, along, h, r in self.layers
        ]
        return mdr.Layered(layers, material(*self.base))


layers = st.lists(st.tuples(sigmas, sigmas, thicknesses, resistances), min_size=1, max_size=4)
half_spaces = st.tuples(sigmas, sigmas)
stacks = st.builds(Stack, layers, half_spaces)
any_base = st.builds(Stack, layers, st.one_of(half_spaces, st.none()))


def depths(thickness):
    """The depth below layers, summed in several orders and units."""
    h = np.asarray(thickness)
    sums = np.cumsum(h)[-1], sum(h), sum(h[::-1]), np.sum(h), math.fsum(h), sum(1e-6 * h) / 1e-6, sum(h * 1e9) * 1e-9
    return np.unique(sums)


@relation(20, stack=stacks)
def test_a_wave_of_flux_is_one_of_torsion(stack):
    """C(k) of a flux against that of a traction across the wave, G in the place of sigma and springs 1/K_t in that of R."""
    body = stack.elastic(springs=True)
    near(body.compliance(K, "flux"), body.compliance(K, "twist"), 1e-11)


@relation(20, stack=stacks)
def test_anisotropic_conductors_are_crystals_in_torsion(stack):
    """C(k) of a flux against that of a traction across the wave with C44 = sigma into the body, C66 = sigma along it."""

    def crystal(s, along):
        return mdr.TransverselyIsotropic(6.0 * along, 4.0 * along, along, 6.0 * along, s)

    films = [
        mdr.Layer(crystal(s, along), h, interface=mdr.Interface(tangential=1.0 / r) if r else None)
        for s, along, h, r in stack.layers
    ]
    body = mdr.Layered(films, crystal(*stack.base))
    near(Conduction(stack.conductor()).compliance(K), body.compliance(K, "twist"), 1e-11)


@relation(15, stack=stacks)
def test_an_elastic_body_conducts_as_its_layers(stack):
    """Spots, waves and heat of an elastic body with interfaces against the stack given layer by layer."""
    body, conduction = stack.elastic(), Conduction(stack.conductor())
    whole = Conduction(body)
    near(whole.at_radius(A).conductance, conduction.at_radius(A).conductance, 1e-12)
    near(body.compliance(K, "flux"), conduction.compliance(K), 1e-13)
    state = mdr.Contact(mdr.Paraboloid(1.0), body).at_radius(1.0)
    heats = [one.friction_heat(state, 0.3, 2.0) for one in (whole, conduction)]
    near(heats[0].flux_mean, heats[1].flux_mean, 1e-12)
    near(heats[0].centre, heats[1].centre, 1e-12)


@relation(6, stack=any_base, share=st.floats(0.1, 0.9), place=st.integers(0, 3), may_refuse=0.2)
def test_layers_cut_in_two_conduct_alike(stack, share, place):
    """A layer against two of its material, with the interface below the second."""
    place %= len(stack.layers)
    s, along, h, r = stack.layers[place]
    cut = [*stack.layers[:place], (s, along, share * h, 0.0), (s, along, (1.0 - share) * h, r), *stack.layers[place + 1 :]]
    whole, parts = (Conduction(one.conductor()) for one in (stack, Stack(cut, stack.base)))
    near(parts.at_radius(A).conductance, whole.at_radius(A).conductance, 1e-11)
    near(parts.compliance(K), whole.compliance(K), 1e-11)
    z = 0.9 * sum(h for _, _, h, _ in stack.layers)
    spots = parts.at_radius(1.0), whole.at_radius(1.0)
    near(*(spot.potential(R, z) for spot in spots), 1e-9, size=1.0)
    near(*(spot.flux_inside(R, z)[0] for spot in spots), 1e-9, size=spots[1].flux_inside(0.0, z)[0])


@relation(8, stack=any_base)
def test_interfaces_have_two_sides(stack):
    """At every interface, whatever the order of summation of its depth: the potential jumps by R j_z, and j_z does not."""
    spot = Conduction(stack.conductor()).at_radius(1.0)
    heights = [h for _, _, h, _ in stack.layers]
    for i, (_, _, _, resistance) in enumerate(stack.layers):
        for z in depths(heights[: i + 1]):
            above, below = (spot.potential(R, z, side=side) for side in ("above", "below"))
            flux = [spot.flux_inside(R, z, side=side)[0] for side in ("above", "below")]
            near(*flux, 1e-9, size=abs(flux[0]).max())
            near(above - below, resistance * flux[0], 1e-9, size=1.0)


@relation(10, films=st.lists(st.tuples(d.materials, thicknesses), min_size=2, max_size=5), base=d.materials)
def test_stresses_have_two_sides(films, base):
    """At every interface, whatever the order of summation of its depth: the values of one side are the same."""
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Layered(films, base)).at_radius(0.5)
    for i in range(len(films)):
        for side in ("above", "below"):
            z = depths([h for _, h in films[: i + 1]])
            found = [state.interior(0.3, float(one), side=side).s_rr for one in z]
            near(found, found[0], 1e-8, size=state.force / state.radius**2)


@relation(8, lower=stacks, upper=st.one_of(st.none(), stacks), tip=d.smooth_tips)
def test_heat_comes_out_as_it_went_in(lower, upper, tip):
    """Far from the contact T = Q/(2 pi S R) of each body's base: its share of mu v F."""
    state = mdr.Contact(tip.profile, mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_radius(float(tip.radii(1.0)[-1]))
    conduction = Conduction(lower.conductor(), None if upper is None else upper.conductor())
    heat = conduction.friction_heat(state, 0.3, 2.0)
    near(heat.total, 0.6 * state.force, 1e-9)
    taken = 0.0
    for name, body in (("lower", lower), ("upper", upper)):
        if body is None:
            continue
        size = max(state.radius, sum(h * max(1.0, (along / s) ** 0.5) for s, along, h, _ in body.layers)) * 10.0
        sigma, along = body.base
        # beside the axis of a conductor that is not isotropic distances into it count sqrt(along/sigma) times
        far = [2.0 * np.pi * along * x * heat.temperature(0.0, x, name) for x in (100.0 * size, 200.0 * size)]
        # what the layers do at their own distance falls as 1/z
        taken += 2.0 * far[1] - far[0]
        share = heat.share if name == "lower" else 1.0 - heat.share
        near(2.0 * far[1] - far[0], share * heat.total, 1e-3, size=heat.total)
    near(taken, heat.total, 1e-3)


@relation(8, body=d.single_exact, tip=d.tips, work=d.works)
def test_heat_warms(body, tip, work):
    """The heat and every temperature are greater than 0 or the state is refused; with adhesion it always is."""
    conduction = Conduction(LayeredConductor([(Conductor(0.3), 0.2), mdr.Interface(0.1)], Conductor(2.0)))
    radius = float(tip.radii(1.0)[-1])
    state = mdr.Contact(tip.profile, body).at_radius(radius)
    try:
        heat = conduction.friction_heat(state, 0.3, 1.0)
    except mdr.MDRError as refusal:
        assert "is not a single area" in str(refusal), refusal
    else:
        assert min(heat.total, heat.share, heat.centre, heat.flux_mean, heat.area_mean) > 0.0
        assert np.all(heat.temperature(radius * R, 0.1 * radius) > 0.0)
    try:
        sticky = mdr.Contact(tip.profile, body, work_of_adhesion=work * body.modulus(1.0))
        conduction.friction_heat(sticky.at_radius(radius), 0.3, 1.0)
    except mdr.MDRError as refusal:
        assert "adhesi" in str(refusal), refusal
    else:
        raise AssertionError("the heat of an adhesive contact is answered")


@relation(10, stack=any_base, body=d.single_exact, tip=d.smooth_tips, parts=st.lists(d.between(1e-14, 1e2), min_size=2, max_size=2))
def test_rough_spots_lie_between_bounds(stack, body, tip, parts):
    """1/G of area resistances kappa/p: at least the smooth spot's and kappa/F in series, at most what a flux as the pressure meets
    (Thomson); smaller for a smaller kappa."""
    conduction = Conduction(stack.conductor())
    state = mdr.Contact(tip.profile, body).at_radius(float(tip.radii(1.0)[-1]))
    try:
        heat = conduction.friction_heat(state, 1.0, 1.0)
    except mdr.MDRError as refusal:
        assert "is not a single area" in str(refusal), refusal
        return
    smooth, meant = 1.0 / conduction.at_radius(state.radius).conductance, heat.flux_mean / heat.total
    found = []
    for part in sorted(parts):
        kappa_over_force = part * smooth
        found.append(1.0 / conduction.rough(state, kappa_over_force * state.force))
        assert smooth + kappa_over_force <= found[-1] * (1.0 + 1e-6)
        assert found[-1] <= (kappa_over_force + meant) * (1.0 + 1e-6)
    assert found[0] <= found[1] * (1.0 + 1e-9)
