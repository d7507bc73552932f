# SPDX-License-Identifier: GPL-3.0-or-later
"""Poroelastic gels: units, limits, superposition, creep against relaxation, oscillation against relaxation, pressures."""

import numpy as np
import pytest
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation
from .references import panels

ratios = st.sampled_from([-0.2, 0.0, 0.3, 0.45])
"""Few: each has a table of its own."""
drainages = st.sampled_from(["surface", "sealed", "indenter"])
moduli, diffusivities, radii = d.between(1e-3, 1e6), d.between(1e-9, 1e3), d.between(1e-6, 10.0)


def punch(nu, G=1.0, D=1.0, a=1.0):
    return mdr.Contact(mdr.FlatPunch(a), mdr.Homogeneous(mdr.poroelastic.Poroelastic(G, nu, D)))


@relation(40, nu=ratios, drainage=drainages, G=moduli, D=diffusivities, a=radii, tau=d.between(1e-8, 1e7))
def test_one_curve_for_all_units(nu, drainage, G, D, a, tau):
    """The answers against those of G = D = a = 1 at D t/a^2."""
    own, unit, t = punch(nu, G, D, a), punch(nu), tau * a**2 / D
    near(own.relaxation(t, drainage=drainage), G * a * unit.relaxation(tau, drainage=drainage), 1e-9)
    near(own.creep(t, drainage=drainage), unit.creep(tau, drainage=drainage) / (G * a), 1e-9)
    near(own.dynamic_stiffness(1.0 / t, drainage=drainage), G * a * unit.dynamic_stiffness(1.0 / tau, drainage=drainage), 1e-9)


@relation(40, nu=ratios, drainage=drainages, tau=d.between(1e-12, 1e12), more=d.between(1.01, 100.0))
def test_between_the_limits(nu, drainage, tau, more):
    """Relaxation falls from the incompressible to the drained body; creep stays below its inverse; losses are positive."""
    contact = punch(nu)
    first, second = contact.relaxation([tau, more * tau], drainage=drainage)
    assert 4.0 / (1.0 - nu) <= second * (1.0 + 1e-9) and second <= first * (1.0 + 1e-9) and first <= 8.0 * (1.0 + 1e-9)
    assert contact.creep(tau, drainage=drainage) * first <= 1.0 + 1e-7
    k = contact.dynamic_stiffness(1.0 / tau, drainage=drainage)
    assert k.imag >= -1e-7 * k.real and 4.0 / (1.0 - nu) <= k.real * (1.0 + 1e-7) <= 8.0 * (1.0 + 2e-7)


@relation(30, nu=ratios, tau=d.between(1e-6, 1e5))
def test_order_of_drainages(nu, tau):
    """What drains less relaxes later: the whole surface, all but the indenter, sealed."""
    forces = [punch(nu).relaxation(tau, drainage=name) for name in ("surface", "indenter", "sealed")]
    assert forces[0] <= forces[1] * (1.0 + 1e-7) and forces[1] <= forces[2] * (1.0 + 1e-7)


@relation(25, nu=ratios, drainage=drainages, t=d.between(1e-3, 1e3))
def test_creep_and_relaxation_are_inverses(nu, drainage, t):
    """int_0^t K(t - s) J(s) ds against t, by Gauss and Legendre over powers of s at both ends."""
    contact = punch(nu)

    def half(f):
        """int_0^(t/2) f ds with s = (t/2) v^8: the answers begin as the root of time."""
        return panels(lambda v: f(0.5 * t * v**8) * 4.0 * t * v**7, [0.0, *(2.0 ** np.arange(-6.0, 1.0))])

    def one(first, second):
        return half(lambda s: first(t - s, drainage=drainage) * second(s, drainage=drainage))

    near(one(contact.relaxation, contact.creep) + one(contact.creep, contact.relaxation), t, 2e-7)


@relation(25, nu=ratios, drainage=drainages, omega=d.between(1e-2, 1e2))
def test_oscillation_follows_from_relaxation(nu, drainage, omega):
    """k''/omega against int_0^inf (K(t) - K(inf)) cos(omega t) dt, an alternating series of half waves."""
    contact = punch(nu)
    last = 4.0 / (1.0 - nu)
    # its means converge (Euler)
    ends = (np.arange(0, 24) + 0.5) * np.pi / omega
    edges = [0.0, *ends]

    def wave(t):
        return (contact.relaxation(t, drainage=drainage) - last) * np.cos(omega * t)

    parts = [panels(lambda v: wave(edges[1] * v**4) * 4.0 * edges[1] * v**3, np.linspace(0.0, 1.0, 5))]
    parts += [panels(wave, np.linspace(a, b, 3)) for a, b in zip(edges[1:-1], edges[2:], strict=True)]
    sums = np.cumsum(parts)[6:]
    while len(sums) > 1:
        sums = 0.5 * (sums[1:] + sums[:-1])
    near(contact.dynamic_stiffness(omega, drainage=drainage).imag / omega, float(sums[0]), 1e-5)


steps = st.lists(d.between(0.01, 1.0), min_size=3, max_size=6)


@relation(20, nu=ratios, drainage=drainages, start=st.floats(0.0, 1.0), times=steps)
def test_paths_are_superposed(nu, drainage, start, times):
    """A path of depth against the sum of steps by quadrature, and back through the force."""
    contact, t = punch(nu), np.concatenate([[0.0], np.cumsum(times)])
    depth = start + np.concatenate([[0.0], np.cumsum(np.sin(1.0 + 9.0 * np.arange(len(times))))])
    force = mdr.poroelastic.history(contact, t, depth=depth, drainage=drainage).force
    for i in range(1, len(t)):
        total = start * contact.relaxation(t[i], drainage=drainage)
        for j in range(i):
            late, early, rate = t[i] - t[j], t[i] - t[j + 1], (depth[j + 1] - depth[j]) / (t[j + 1] - t[j])

            def slow(v, late=late, early=early):
                s = early + (late - early) * v**4
                return contact.relaxation(s, drainage=drainage) * 4.0 * (late - early) * v**3

            total += rate * panels(slow, np.linspace(0.0, 1.0, 5))
        near(force[i], total, 1e-6, np.abs(force).max())


@pytest.mark.slow
@relation(8, nu=ratios, drainage=drainages, times=steps, factor=st.sampled_from([1e-18, 1e18]))
def test_fast_and_slow_paths_are_elastic(nu, drainage, times, factor):
    """A path far faster or slower than the fluid against the incompressible and the drained elastic contact."""
    contact = punch(nu)
    depth = 0.1 + 0.05 * np.sin(1.0 + 9.0 * np.arange(len(times) + 1))
    t = np.concatenate([[0.0], np.cumsum(times)]) * factor
    elastic = mdr.Elastic(3.0, 0.5) if factor < 1.0 else mdr.Elastic(2.0 * (1.0 + nu), nu)
    wanted = mdr.Contact(mdr.FlatPunch(1.0), mdr.Homogeneous(elastic)).at_depth(depth).force
    # of a jump nothing drains at first
    near(mdr.poroelastic.history(contact, t, depth=depth, drainage=drainage).force[1:], wanted[1:], 1e-6, np.abs(wanted).max())


@relation(20, nu=ratios, drainage=drainages, tau=d.between(1e-2, 1e2), flat=st.booleans())
def test_pressure_bears_the_force(nu, drainage, tau, flat):
    """int p dA against the force; the pore pressure is none where all drains; else it is between 0 and that of the
    undrained body, which it may pass by a little (Mandel)."""
    if flat:
        contact, given = punch(nu), {"depth": 1.0}
        force = contact.relaxation(tau, drainage=drainage)
    else:
        contact = mdr.Contact(mdr.Paraboloid(1.0), punch(nu).medium)
        given = {"radius": 1.0}
        force = mdr.poroelastic.history(contact, [0.0, tau], radius=[1.0, 1.0], drainage=drainage).force[1]

    def ring(v):
        """r = sin v: the edge is infinite as 1/sqrt(1 - r^2)"""
        r = np.minimum(np.sin(v), 1.0 - 1e-15)
        return 2.0 * np.pi * r * contact.pressure_in_time("total_pressure", r, tau, drainage=drainage, **given) * np.cos(v)

    near(panels(ring, np.linspace(0.0, 0.5 * np.pi, 4)), force, 1e-6)
    r = np.array([0.0, 0.4, 0.8])
    pore = contact.pressure_in_time("pore_pressure", r, tau, drainage=drainage, **given)
    if drainage == "surface":
        assert not pore.any()
    else:
        undrained = 4.0 / np.pi / np.sqrt(1.0 - r**2) if flat else 8.0 / np.pi * np.sqrt(1.0 - r**2)
        assert (pore > -1e-6).all() and (pore < 1.3 * undrained).all()
