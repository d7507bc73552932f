# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest stresses inside bodies, against points that know nothing of the search."""

import numpy as np
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation
from .test_interior import faces, state_of

SAMPLES = 30
"""Radii and depths, each way of spreading them."""
WITHOUT_SINGULARITY = 1e-8
"""By how much a sample may exceed a maximum, of the largest von Mises stress."""
ANGLES = 0.0, np.pi

crystals = st.sampled_from(["GaN", "ZnO"]).map(
    lambda name: mdr.TransverselyIsotropic(
        **{key: 1e-11 * getattr(mdr.CRYSTALS[name].material, key) for key in ("C11", "C12", "C13", "C33", "C44")}
    )
)
stacks = st.builds(
    lambda layers, base: mdr.Layered(layers, base),
    st.lists(st.tuples(st.one_of(d.materials, crystals), d.between(0.2, 5.0)), min_size=1, max_size=3),
    st.one_of(d.materials, crystals, st.just(mdr.RIGID)),
)
frictions = st.one_of(st.just(0.0), st.floats(0.05, 1.0))
seeds = st.integers(0, 2**32 - 1)


def stresses(field):
    """Those of a layer."""
    return {"von_mises": field.von_mises, "tresca": field.tresca, "tension": field.principal[..., 0]}


def inside(medium, state, rng):
    """Radii, and depths of each layer from face to face: scattered, denser at the edge and towards the upper face."""
    tops = [0.0, *faces(medium)]
    bottoms = [*tops[1:], np.inf][: len(tops) - (medium.substrate is mdr.RIGID if tops[1:] else 0)]
    for top, bottom in zip(tops, bottoms, strict=False):
        reach = 3.0 * (state.radius + top)
        depth = min(bottom, top + reach) - top
        width = min(depth, state.radius)
        r = np.concatenate([reach * rng.random(SAMPLES), reach * rng.random(SAMPLES) ** 3])
        r = np.concatenate([r, state.radius + width * rng.uniform(-1.0, 1.0, SAMPLES), [0.0, state.radius]])
        z = np.concatenate([rng.random(SAMPLES), rng.random(SAMPLES) ** 2])
        yield np.clip(r, 0.0, reach), top * (1.0 + 1e-14) + depth * (1.0 - 1e-14) * z


@relation(6, tip=d.smooth_tips, medium=st.one_of(d.homogeneous, stacks), share=d.shares, friction=frictions, seed=seeds)
def test_no_sample_exceeds_a_maximum(tip, medium, share, friction, seed):
    """Many more points than the search has, in layers, at interfaces and on the free surface; each maximum is the stress at its
    place."""
    _, state, _ = state_of(tip, medium, share)
    found = state.critical(friction=friction)
    rng = np.random.default_rng(seed)
    size = max(layer.von_mises.value for layer in found.layers)
    angles = ANGLES if friction else ANGLES[:1]
    spread = list(inside(medium, state, rng))
    assert len(spread) == len(found.layers)
    for (r, z), layer in zip(spread, found.layers, strict=True):
        for angle in angles:
            everywhere = stresses(state.interior(r[:, None], z[None, :], friction=friction, angle=angle))
            for name, values in everywhere.items():
                excess = max(np.max(values) - getattr(layer, name).value, 0.0)
                near(excess, 0.0, WITHOUT_SINGULARITY, size=size, what=name)
        for name in ("von_mises", "tresca", "tension"):
            largest = getattr(layer, name)
            there = state.interior(largest.r, largest.z, friction=friction, angle=largest.angle)
            near(largest.value, stresses(there)[name], 1e-9, size=size, what=f"{name} there")
    for depth, interface in zip(faces(medium), found.interfaces, strict=True):
        near(interface.z, depth, 1e-14)
        reach = 3.0 * (state.radius + depth)
        for angle in angles:
            field = state.interior(reach * rng.random(10 * SAMPLES), depth, side="above", friction=friction, angle=angle)
            for largest, stress in ((interface.shear, np.hypot(field.s_rz, field.s_tz)), (interface.tension, field.s_zz)):
                near(max(np.max(stress) - largest.value, 0.0), 0.0, WITHOUT_SINGULARITY, size=size, what="interface")
    r = state.radius * (1.0 + 2.0 * rng.random(5 * SAMPLES) ** 2)
    for angle in angles:
        tension = state.interior(r, 0.0, friction=friction, angle=angle).principal[..., 0]
        near(max(np.max(tension) - found.surface.value, 0.0), 0.0, WITHOUT_SINGULARITY, size=size, what="free surface")


@relation(
    6, tip=d.smooth_tips, medium=st.one_of(d.homogeneous, stacks), share=d.shares, friction=frictions, part=st.floats(0.3, 0.9)
)
def test_a_strength_is_reached_where_it_is_said_to_be(tip, medium, share, friction, part):
    """A part of the largest stress of a state is reached before it, where the largest stress of the state is the strength."""
    contact, state, _ = state_of(tip, medium, share)
    largest = state.critical(friction=friction).layers
    for place, layer in enumerate(largest):
        strengths = [part * layer.von_mises.value if i == place else None for i in range(len(largest))]
        (failure,) = contact.first_failure({"von_mises": strengths}, friction=friction, largest_radius=state.radius)
        assert failure.place == place and failure.state.radius <= state.radius
        near(failure.at.value, part * layer.von_mises.value, 1e-8)
        near(failure.state.critical(friction=friction).layers[place].von_mises.value, failure.strength, 1e-8)
