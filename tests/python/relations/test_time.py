# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials that relax: their functions, histories, dynamic stiffness."""

import math

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from scipy import optimize

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation, same
from .references import panels

moduli, times = d.between(0.1, 10.0), d.between(0.05, 20.0)
series = st.lists(st.tuples(moduli, times), min_size=1, max_size=3)
constant = st.builds(lambda g, terms, nu: mdr.Viscoelastic(g, terms, nu=nu), moduli, series, d.usual_ratios)
"""Of a constant Poisson's ratio."""
polymers = st.builds(lambda g, terms, k: mdr.Viscoelastic(g, terms, bulk_modulus=k), moduli, series, d.between(20.0, 200.0))
power_laws = st.builds(mdr.PowerLawRheology, moduli, times, st.floats(0.05, 0.7), d.usual_ratios)
increments = st.lists(st.floats(0.05, 1.0), min_size=3, max_size=6)
growing = st.tuples(increments, increments).map(
    lambda v: (np.cumsum(v[0][: min(map(len, v))]), 0.02 * np.cumsum(v[1][: min(map(len, v))]))
)
"""A path in time that grows: times and depths."""


def relaxing(material, t):
    """G(t) from the arguments, by NumPy."""
    return material.relaxed_shear_modulus + sum(g * np.exp(-t / tau) for g, tau in material.terms)


@relation(40, material=st.one_of(constant, polymers), t=d.between(1e-3, 1e3), omega=d.between(1e-3, 1e3))
def test_series_of_exponentials(material, t, omega):
    """G(t) and G*(omega) against sums by NumPy; the glassy and the relaxed material against G at the ends."""
    near(material.relaxation(t), relaxing(material, t), 1e-13)
    expected = material.relaxed_shear_modulus + sum(g * 1j * omega * tau / (1.0 + 1j * omega * tau) for g, tau in material.terms)
    near(material.complex_modulus(omega), expected, 1e-13)
    for limit, at in ((material.glassy, 0.0), (material.relaxed, 1e30)):
        near(0.5 * limit.E / (1.0 + limit.nu), relaxing(material, at), 1e-12)


@relation(40, material=st.one_of(constant, polymers, power_laws), t=d.between(1e-2, 1e2))
def test_creep_and_relaxation_are_inverses(material, t):
    """int_0^t G(t - s) J(s) ds against t, by Gauss and Legendre over powers of s at both ends."""

    def half(f):
        """int_0^(t/2) f ds with s = (t/2) v^8: f may be infinite as a power"""
        return panels(lambda v: f(0.5 * t * v**8) * 4.0 * t * v**7, [0.0, *(2.0 ** np.arange(-6.0, 1.0))])

    total = half(lambda s: material.relaxation(t - s) * material.creep(s))
    total += half(lambda s: material.relaxation(s) * material.creep(t - s))
    near(total, t, 1e-9)


@relation(40, material=power_laws, t=d.between(1e-3, 1e3), omega=d.between(1e-3, 1e3))
def test_power_law_rheology(material, t, omega):
    """G(t), G*(omega) and J(t) against their closed forms with gamma functions."""
    n, G, tau = material.exponent, material.modulus, material.time
    near(material.relaxation(t), G * (t / tau) ** -n, 1e-12)
    near(material.complex_modulus(omega), G * math.gamma(1.0 - n) * (1j * omega * tau) ** n, 1e-12)
    near(material.creep(t), (t / tau) ** n / (G * math.gamma(1.0 - n) * math.gamma(1.0 + n)), 1e-12)


@relation(40, material=st.one_of(constant, power_laws), b=d.lengths, t=d.between(1e-2, 1e2), omega=d.between(1e-2, 1e2))
def test_flat_punch_on_a_half_space(material, b, t, omega):
    """Step response and dynamic stiffness of a punch against 4 b G/(1 - nu)."""
    contact = mdr.Contact(mdr.FlatPunch(b), mdr.Homogeneous(material))
    unit = 4.0 * b / (1.0 - material.nu)
    near(contact.relaxation(t), unit * material.relaxation(t), 1e-9)
    near(contact.creep(t), material.creep(t) / unit, 1e-9)
    near(contact.dynamic_stiffness(omega), unit * material.complex_modulus(omega), 1e-11)


@relation(30, material=constant, R=d.lengths, path=growing)
def test_lee_and_radok(material, R, path):
    """F(t) of a growing depth against 8 sqrt(R)/(3 (1 - nu)) int G(t - s) d(d^1.5), by Gauss and Legendre."""
    t, depth = path
    t, depth = np.concatenate([[0.0], t]), np.concatenate([[0.0], depth])
    found = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)).history(t, depth=depth)
    expected = []
    for now in t[1:]:
        total = 0.0
        for i in range(len(t) - 1):
            if t[i] >= now:
                break
            rate = (depth[i + 1] - depth[i]) / (t[i + 1] - t[i])
            # s = t_i + u^2: the root of the depth at first touch is smooth in u
            ends = np.linspace(0.0, math.sqrt(t[i + 1] - t[i]), 9)
            total += panels(lambda u, i=i, rate=rate, now=now: relaxing(material, now - t[i] - u * u) * 1.5
                            * np.sqrt(np.maximum(depth[i] + rate * u * u, 0.0)) * rate * 2.0 * u, ends)  # fmt: skip
        expected.append(8.0 * math.sqrt(R) / (3.0 * (1.0 - material.nu)) * total)
    near(found.force[1:], expected, 1e-8)
    near(found.radius, np.sqrt(R * depth), 1e-9)


@relation(30, material=constant, R=d.lengths, up=d.between(0.1, 5.0), down=d.between(0.3, 3.0), part=st.floats(0.05, 0.95))
def test_ting(material, R, up, down, part):
    """F while the contact shrinks against Ting's rule: the time of the same radius by SciPy's root, then the integral up to it."""
    top = 0.1
    t = np.array([0.0, up, up + part * down])
    depth = np.array([0.0, top, top * (1.0 - 0.5 * part)])
    found = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)).history(t, depth=depth)
    now, rise, fall = t[-1], top / up, -0.5 * top / down
    terms = [(material.relaxed_shear_modulus, math.inf), *material.terms]

    def held(low, high):
        """int G(now - s) ds"""
        return sum(g * (high - low) if tau == math.inf else g * tau * (math.exp(-(now - high) / tau) - math.exp(-(now - low) / tau))
                   for g, tau in terms)  # fmt: skip

    taken = fall * held(up, now)
    if rise * held(0.0, up) + taken <= 0.0:
        near(found.force[-1], 0.0, 1e-9, size=found.force[1])
        return
    first = optimize.brentq(lambda s: rise * held(s, up) + taken, 0.0, up, xtol=1e-15, rtol=1e-14)
    ends = np.linspace(0.0, math.sqrt(first), 9)
    total = panels(lambda u: relaxing(material, now - u * u) * 1.5 * np.sqrt(rise) * u * rise * 2.0 * u, ends)
    near(found.force[-1], 8.0 * math.sqrt(R) / (3.0 * (1.0 - material.nu)) * total, 1e-7, size=found.force[1] * 1e-3 + abs(total))
    near(found.radius[-1], math.sqrt(R * rise * first), 1e-7, size=found.radius[1])


paths = st.lists(st.floats(-0.3, 1.0), min_size=3, max_size=5).map(lambda v: 0.1 * np.round([0.0, *v], 2))
"""Depths of a path, some of them apart."""


@relation(
    25,
    material=constant,
    R=d.lengths,
    depth=paths,
    may_refuse=0.2,
    shift=st.floats(-100.0, 100.0),
    unit=st.tuples(d.between(1e-3, 1e3), d.between(1e-3, 1e3)),
)
def test_time_and_units(material, R, depth, shift, unit):
    """A path begun later, and in other units of time and modulus, against the path."""
    tau, t_ = unit
    t = np.arange(len(depth)) * 0.5
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material))
    found = contact.history(t, depth=depth)
    size = float(np.max(np.abs(found.force))) + 1e-300
    near(contact.history(t + shift, depth=depth).force, found.force, 2e-5, size=size)
    other = mdr.Viscoelastic(material.relaxed_shear_modulus * t_, [(g * t_, s * tau) for g, s in material.terms], nu=material.nu)
    scaled = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(other)).history(t * tau, depth=depth)
    near(scaled.force, found.force * t_, 2e-5, size=size * t_)


@relation(8, may_refuse=0.2, material=constant, R=d.lengths, depth=paths)
def test_one_line_or_many_points(material, R, depth):
    """A path of straight lines against the same path with 4 points on each."""
    t = np.arange(len(depth)) * 0.5
    fine = np.linspace(0.0, t[-1], 4 * (len(depth) - 1) + 1)
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material))
    one, many = contact.history(t, depth=depth), contact.history(fine, depth=np.interp(fine, t, depth))
    near(many.force[::4], one.force, 2e-5, size=float(np.max(np.abs(one.force))) + 1e-300)
    near(many.radius[::4], one.radius, 5e-3, size=float(np.max(one.radius)) + 1e-300)


@relation(25, material=constant, R=d.lengths, path=growing)
def test_depth_and_force_are_inverses(material, R, path):
    """The depth under the force that a depth gave, at the same points on a fine path, against that depth."""
    t, depth = np.concatenate([[0.0], path[0]]), np.concatenate([[0.0], path[1]])
    fine = np.linspace(0.0, t[-1], 400)
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material))
    pressed = contact.history(fine, depth=np.interp(fine, t, depth))
    assume(np.all(np.diff(pressed.force) > 0.0))
    again = contact.history(fine, force=pressed.force)
    near(again.depth[40:], pressed.depth[40:], 2e-3)
    near(contact.history(fine, radius=pressed.radius).force[40:], pressed.force[40:], 5e-3)


@relation(25, may_refuse=0.2, material=constant, R=d.lengths, depth=paths, factor=st.sampled_from([1e-9, 1e9]))
def test_fast_and_slow_paths_are_elastic(material, R, depth, factor):
    """A path far faster or slower than the relaxation against the glassy or the relaxed contact."""
    t = np.arange(len(depth)) * factor
    elastic = material.glassy if factor < 1.0 else material.relaxed
    found = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)).history(t, depth=depth)
    expected = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(elastic)).at_depth(np.maximum(depth, 0.0)).force
    near(found.force, expected, 1e-5, size=float(np.max(expected)) + 1e-300)


@relation(
    12,
    material=st.one_of(constant, polymers),
    h=d.between(0.3, 3.0),
    b=d.between(0.2, 2.0),
    t=d.between(0.05, 20.0),
    omega=d.between(0.05, 20.0),
)
def test_layers_of_one_relaxing_material(material, h, b, t, omega):
    """A film of its substrate's material against the half-space: step response, dynamic stiffness, a history."""
    film, alone = mdr.Coated(material, h, material), mdr.Homogeneous(material)
    one, two = (mdr.Contact(mdr.FlatPunch(b), medium) for medium in (film, alone))
    near(one.relaxation(t), two.relaxation(t), 1e-7)
    near(one.creep(t), two.creep(t), 1e-7)
    near(one.dynamic_stiffness(omega), two.dynamic_stiffness(omega), 1e-8)


@relation(
    6, material=st.one_of(constant, polymers), h=d.between(0.1, 3.0), depth=paths, part=st.sampled_from([0.0, 1e-9]), may_refuse=0.2
)
def test_paths_on_layers_of_one_relaxing_material(material, h, depth, part):
    """A path down and up on a layer of its substrate's material, or nearly, against the half-space."""
    t = np.arange(len(depth)) * 0.5
    g, terms = material.relaxed_shear_modulus * (1.0 + part), [(g * (1.0 + part), tau) for g, tau in material.terms]
    bulk = None if material.bulk_modulus is None else material.bulk_modulus * (1.0 + part)
    film = mdr.Coated(material, h, mdr.Viscoelastic(g, terms, nu=material.nu, bulk_modulus=bulk))
    found, wanted = (
        mdr.Contact(mdr.Paraboloid(1.0), body).history(t, depth=depth, tolerance=1e-4) for body in (film, mdr.Homogeneous(material))
    )
    near(found.force, wanted.force, 1e-4, size=float(np.max(np.abs(wanted.force))) + 1e-300)


interfaces = st.one_of(
    st.none(),
    st.just(mdr.SLIDING),
    st.builds(mdr.Interface, normal=st.one_of(st.none(), d.between(0.1, 100.0)), tangential=d.between(0.01, 100.0)),
)
held = st.lists(st.tuples(st.one_of(constant, polymers, d.usual), d.between(0.2, 2.0), interfaces), min_size=1, max_size=2)
held_stacks = st.tuples(held, st.one_of(constant, polymers, d.usual, st.just(mdr.RIGID))).filter(
    lambda v: any(isinstance(m, mdr.Viscoelastic) for m in (*(row[0] for row in v[0]), v[1]))
)
"""Layers that relax, held by springs or sliding, given layer by layer."""


def stack(rows, base, limit=None):
    """The body, or the elastic one with a limit of each material."""

    def of(m):
        return getattr(m, limit) if limit and isinstance(m, mdr.Viscoelastic) else m

    return mdr.Layered([mdr.Layer(of(m), h, interface=below) for m, h, below in rows], of(base))


@relation(12, body=held_stacks, omega=d.between(1e-2, 1e2), control=st.sampled_from(["depth", "force"]), value=d.between(0.01, 0.1))
def test_oscillations_about_a_relaxed_state(body, omega, control, value):
    """k* about a depth or force against that at the radius of the elastic contact, and against its stiffness and the glassy one
    far from all relaxation."""
    contact, relaxed, glassy = (mdr.Contact(mdr.Paraboloid(1.0), stack(*body, limit)) for limit in (None, "relaxed", "glassy"))
    state = getattr(relaxed, f"at_{control}")(value)
    found = contact.dynamic_stiffness([1e-7, omega, 1e9], **{control: value})
    near(found[1], contact.dynamic_stiffness(omega, radius=state.radius), 1e-9)
    near(found[0].real, state.stiffness, 1e-7)
    near(found[2].real, glassy.medium.stiffness(state.radius), 1e-7)


@relation(6, body=held_stacks, depth=paths, factor=st.sampled_from([1e-9, 1e9]), may_refuse=0.3)
def test_fast_and_slow_paths_on_layers_are_elastic(body, depth, factor):
    """A path far faster or slower than all relaxation against glassy or relaxed contacts with the same interfaces."""
    t = np.arange(len(depth)) * factor
    found = mdr.Contact(mdr.Paraboloid(1.0), stack(*body)).history(t, depth=depth, tolerance=1e-4)
    limit = "glassy" if factor < 1.0 else "relaxed"
    expected = mdr.Contact(mdr.Paraboloid(1.0), stack(*body, limit)).at_depth(np.maximum(depth, 0.0)).force
    near(found.force, expected, 2e-4, size=float(np.max(expected)) + 1e-300)


@relation(12, film=st.one_of(constant, polymers), h=d.between(0.3, 3.0), base=d.usual, a=d.between(0.1, 2.0))
def test_dynamic_stiffness_between_its_limits(film, h, base, a):
    """k*(omega) of a relaxing film at both ends against the elastic media; storage and loss are positive."""
    contact = mdr.Contact(mdr.FlatPunch(a), mdr.Coated(film, h, base))
    for omega, limit in ((1e-9, film.relaxed), (1e9, film.glassy)):
        k = contact.dynamic_stiffness(omega)
        near(k.real, mdr.Coated(limit, h, base).stiffness(a), 1e-6)
    k = contact.dynamic_stiffness(np.geomspace(1e-2, 1e2, 5))
    assert np.all(k.real > 0.0) and np.all(k.imag > 0.0)
    assert np.all(np.diff(k.real) > 0.0)


slow = st.builds(
    lambda g, terms, nu: mdr.Viscoelastic(g, terms, nu=nu),
    moduli,
    st.lists(st.tuples(moduli, d.between(0.5, 5.0)), min_size=1, max_size=2),
    d.usual_ratios,
)


@relation(4, film=slow, h=d.between(0.3, 3.0), base=d.usual, t=d.between(0.3, 3.0), b=d.between(0.3, 2.0))
def test_creep_and_relaxation_of_films_are_inverses(film, h, base, t, b):
    """int K(t - s) C(s) ds of a punch on a relaxing film against t, by Gauss and Legendre."""
    contact = mdr.Contact(mdr.FlatPunch(b), mdr.Coated(film, h, base))
    nodes, weights = np.polynomial.legendre.leggauss(12)
    s = 0.5 * t * (1.0 + nodes)
    near(0.5 * t * weights @ (contact.relaxation(t - s) * contact.creep(s)), t, 1e-6)


@relation(
    20, instant=d.between(0.1, 10.0), fractions=st.lists(st.floats(0.01, 0.3), min_size=1, max_size=3), nu=st.floats(0.0, 0.49)
)
def test_tables_of_finite_element_programs(instant, fractions, nu):
    """A Prony table as text against the rows, and the instant modulus against G(0)."""
    rows = [(g, 10.0**k) for k, g in enumerate(fractions)]
    text = "".join(f"{g!r}, {tau!r}\n" for g, tau in rows)
    one, two = mdr.Viscoelastic.from_fractions(instant, rows, nu), mdr.Viscoelastic.from_prony_text(text, instant, nu)
    t = np.array([0.0, 0.3, 30.0])
    same(one.relaxation(t), two.relaxation(t))
    near(one.glassy.E, instant, 1e-12)
    near(one.glassy.nu, nu, 1e-12, size=1.0)
