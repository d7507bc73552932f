# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear: worn profiles, limits and brackets of bodies with interfaces and prestress."""

import numpy as np
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation

nodes, weights = np.polynomial.legendre.leggauss(24)
AXIS = 0.15 ** np.arange(11.0)[::-1]
TIPS = st.one_of(d.paraboloids, d.spheres, st.floats(0.02, 0.6).map(lambda phi: d.Tip(mdr.Cone(phi))), st.builds(
    lambda n, c: d.Tip(mdr.PowerLaw(n, c)), st.floats(1.0, 4.0), d.lengths))  # fmt: skip
interfaces = st.one_of(
    st.none(),
    st.just(mdr.SLIDING),
    st.builds(mdr.Interface, normal=st.one_of(st.none(), d.between(0.3, 30.0)), tangential=d.between(0.03, 30.0)),
)
layer = st.builds(
    lambda E, nu, h, stress, below: mdr.Layer(mdr.Elastic(E, nu), h, prestress=stress * E, interface=below),
    d.between(0.3, 3.0),
    st.floats(0.0, 0.45),
    d.between(0.3, 3.0),
    st.one_of(st.just(0.0), st.floats(0.0, 0.1)),
    interfaces,
)
stacks = st.builds(mdr.Layered, st.lists(layer, min_size=1, max_size=2), st.builds(mdr.Elastic, d.between(0.3, 3.0), st.just(0.3)))


def beside(c, b):
    """Radii between the disc that sticks and the rim, most of them beside it."""
    r = np.r_[c * (1.0 + np.geomspace(1e-12, 1e-2, 13)), c + (b - c) * np.linspace(0.017, 0.998, 17)]
    return r[(r > c) & (r < b)]


@relation(
    20, tip=TIPS, material=d.materials, a=d.between(0.05, 0.6), part=st.floats(0.02, 0.98), held=st.sampled_from(["depth", "force"])
)
def test_worn_profiles_of_half_spaces(tip, material, a, part, held):
    """f = d - (2/pi) int_0^c (d - g)/sqrt(r^2 - x^2) dx by Gauss and Legendre in x = r sin(t)."""
    a = min(a, 0.6 * tip.high)
    contact = mdr.Contact(tip.profile, mdr.Homogeneous(material))
    state, c = contact.at_radius(a), part * a
    try:
        end = mdr.wear.Wear(contact, 1.0).limit(state, c, held)
    except mdr.errors.DomainError as refusal:
        assert "the indenter ends" in str(refusal)
        return
    r = beside(c, end.outer_radius)
    last = np.arctan2(c, np.sqrt((r - c) * (r + c)))
    parts = np.append(0.0, AXIS)
    t = (0.5 * (parts[1:] + parts[:-1])[:, None] + 0.5 * np.diff(parts)[:, None] * nodes).ravel()
    rule = (0.5 * np.diff(parts)[:, None] * weights).ravel()
    inner = end.state.depth - tip.profile.mdr(np.minimum(r[:, None] * np.sin(last[:, None] * t), c))
    near(end.profile.height(r), end.state.depth - 2.0 / np.pi * last * (inner @ rule), 1e-9, size=end.state.depth)
    near(end.profile.worn_depth(r), end.profile.height(r) - tip.profile.height(r), 1e-12, size=end.state.depth)


@relation(10, tip=TIPS, body=stacks, a=d.between(0.05, 0.6), part=st.floats(0.05, 0.95), may_refuse=0.5)
def test_worn_profiles_of_layers(tip, body, a, part):
    """Heights against d - u(r) beside the limit state, the volume against the profile, and the force left against that of the
    contact as wide as the disc, pressed on as a flat punch."""
    a = min(a, 0.6 * tip.high)
    contact = mdr.Contact(tip.profile, body)
    state, inner = contact.at_radius(a), contact.at_radius(part * a)
    end = mdr.wear.Wear(contact, 1.0).limit(state, part * a)
    near(end.state.force, inner.force + inner.stiffness * (state.depth - inner.depth), 1e-9)
    b, c = end.outer_radius, part * a
    r = beside(c, b)
    near(end.profile.height(r), end.state.depth - end.state.displacement(r), 1e-9, size=state.depth)
    t = 0.5 * (1.0 + nodes)
    r = c + (b - c) * t**2
    volume = (b - c) * np.sum(0.5 * weights * 4.0 * np.pi * t * r * end.profile.worn_depth(r))
    near(end.worn_volume, volume, 1e-8)


@relation(
    3, body=stacks, k=d.between(0.01, 0.1), force=d.between(0.05, 0.3), scheme=st.sampled_from(["disc", "rings"]), may_refuse=0.5
)
def test_brackets_are_those_of_the_stack(body, k, force, scheme):
    """Both ends of a bracket against histories on the stack given layer by layer."""
    wear = mdr.wear.Wear(mdr.Contact(mdr.Paraboloid(1.0), body), 1.0, body_coefficient=k)
    first, last = wear.bracket(0.3, force=force, intervals=16, scheme=scheme)
    lost = max(first.body_depth, last.body_depth) * (1.0 + 1e-9)
    for thinner, found in ((0.0, first), (lost, last)):
        top = body.layers[0]
        other = mdr.Layer(top.material, top.thickness - thinner, prestress=top.prestress, interface=top.interface)
        stack = mdr.Layered([other, *body.layers[1:]], body.substrate)
        run = wear.replace(contact=mdr.Contact(mdr.Paraboloid(1.0), stack))
        wanted = run.history(force=force, places="same", intervals=16, scheme=scheme).advance(0.3, force=force)
        for name in ("depth", "radius", "pressure", "worn_depth", "body_depth"):
            near(getattr(found, name), getattr(wanted, name), 1e-8)
