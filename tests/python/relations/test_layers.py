# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of crystals, held by springs: in two ways each."""

import numpy as np
import pytest
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation

K = np.geomspace(0.03, 30.0, 7)
solids = st.one_of(d.materials, d.crystals)
held = st.lists(st.builds(mdr.Layer, solids, d.between(0.1, 10.0), interface=d.bonds), min_size=1, max_size=3)
"""Layers, each with what holds it to the next one."""
grounds = st.one_of(solids, st.just(mdr.RIGID))


def cut(layers, share):
    """Each layer in two, bonded to each other, the lower one with the interface; their constants differ in the last digits, so that
    the two are not taken for one."""
    parts = []
    for layer in layers:
        constants = layer.material.parameters()
        name = "E" if "E" in constants else "G_z"
        other = layer.material.with_parameters({name: constants[name] * (1.0 + 1e-14)})
        parts += [mdr.Layer(layer.material, share * layer.thickness),
                  mdr.Layer(other, (1.0 - share) * layer.thickness, interface=layer.interface)]  # fmt: skip
    return parts


@relation(10, layers=held, base=grounds, share=st.floats(0.05, 0.95))
def test_surfaces_of_layers_cut_in_two(layers, base, share):
    """Waves under every load, and the moduli: of layers on springs against those of two layers of each."""
    one, two = mdr.Layered(layers, base), mdr.Layered(cut(layers, share), base)
    for load in ("normal", "shear", "twist"):
        near(two.compliance(K, load), one.compliance(K, load), 1e-9)
    a = np.array([0.1, 1.0, 5.0])
    near(two.modulus(a), one.modulus(a), 1e-8)
    if not any(layer.interface and layer.interface.tangential == 0.0 for layer in layers):
        near(two.tangential_modulus(a), one.tangential_modulus(a), 1e-8)
        near(two.torsional_stiffness(a), one.torsional_stiffness(a), 1e-8)


@relation(4, tip=d.smooth_tips, layers=held, base=grounds, share=st.floats(0.05, 0.95), where=st.lists(
    st.tuples(st.floats(0.05, 3.0), st.floats(0.05, 0.95)), min_size=4, max_size=4))  # fmt: skip
def test_inside_layers_cut_in_two(tip, layers, base, share, where):
    """States, and motions and stresses inside, of layers on springs against those of two layers of each."""
    radius = float(tip.radii(0.8)[-1])
    one, two = (mdr.Contact(tip.profile, mdr.Layered(some, base)).at_radius(radius) for some in (layers, cut(layers, share)))
    near(two.depth, one.depth, 1e-8)
    near(two.force, one.force, 1e-8)
    whole = sum(layer.thickness for layer in layers)
    r, z = np.array([(radius * x, min(whole, 5.0 * radius) * y) for x, y in where]).T
    expected, found = one.interior(r, z), two.interior(r, z)
    for name in ("u_r", "u_z"):
        near(getattr(found, name), getattr(expected, name), 1e-7, size=one.depth)
    mean = one.force / (np.pi * radius**2)
    for name in ("s_rr", "s_tt", "s_zz", "s_rz"):
        size = mean + np.max(np.abs(getattr(expected, name)))
        near(getattr(found, name), getattr(expected, name), 1e-7, size=size)


def springs(medium, a, panels=16):
    """E_eff of a flat punch of radius a, F = 2 a E_eff d, from waves alone: phi + int X phi = 1 on (-a, a), with X(y) by Gauss and
    Legendre over the waves themselves, and E_eff = E0* int_0^a phi/a."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    ends = np.concatenate([[0.0], np.geomspace(1e-5, 1e3, 330)])
    low, high = ends[:-1, None], ends[1:, None]
    k, w = (0.5 * (high - low) * (1.0 + nodes) + low).ravel(), (0.5 * (high - low) * weights).ravel()
    C = medium.compliance(k) * k
    chi = C / C[-1] - 1.0
    edges = np.linspace(0.0, a, panels + 1)
    x = (0.5 * np.diff(edges)[:, None] * (1.0 + nodes) + edges[:-1, None]).ravel()
    v = (0.5 * np.diff(edges)[:, None] * weights).ravel()
    waves = np.cos(np.outer(x, k))
    # X(x - t) + X(x + t) = 2 int chi cos(kx) cos(kt) dk
    kernel = (2.0 / np.pi) * (waves * (w * chi)) @ waves.T
    phi = np.linalg.solve(np.eye(x.size) + kernel * v, np.ones(x.size))
    return 2.0 / C[-1] * float(v @ phi) / a


@relation(4, layers=st.lists(st.tuples(d.crystals, d.between(0.1, 10.0)), min_size=1, max_size=3), base=st.one_of(
    d.crystals, st.just(mdr.RIGID)), a=d.between(0.1, 1.0))  # fmt: skip
def test_crystals_against_their_waves(layers, base, a):
    """E_eff of layers of crystals, however their waves oscillate, against an integral equation made of the waves alone."""
    medium = mdr.Layered(layers, base)
    near(medium.modulus(a), springs(medium, a), 1e-7)


def crystal(*constants):
    """E_t, E_z, nu_t, nu_tz, G_z."""
    return mdr.TransverselyIsotropic.from_engineering(*constants)


@pytest.mark.parametrize(
    ("layers", "base"),
    [
        ([(crystal(8.4, 1.65, 0.54, 1.01, 21.5), 2.6)], crystal(2.8, 23.0, -0.11, 0.066, 9.0)),
        ([(crystal(0.77, 1.8, 0.035, 0.32, 1.02), 0.2), (crystal(0.85, 0.029, -0.45, -2.66, 1.78), 8.9)],
         crystal(0.36, 1.82, -0.028, 0.073, 0.0287)),
    ],
    ids=["waves that oscillate 8 times as fast as they decay", "far longer than the first layer is thick"],
)  # fmt: skip
def test_crystals_that_are_hard_to_tabulate(layers, base):
    """Two of the one in a hundred that were refused, as above."""
    medium = mdr.Layered(layers, base)
    near(medium.modulus(0.7), springs(medium, 0.7), 1e-8)
