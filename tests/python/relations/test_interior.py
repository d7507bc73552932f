# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses and displacements inside bodies."""

import math

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation
from .references import disc, panels, slopes
from .rescale import in_units
from .test_bodies import parts, split

DIGITS = 1e-8
"""Of the depth and of the largest stress of a state."""
bodies = st.one_of(d.homogeneous, d.single_exact)
STRESSES = ("s_rr", "s_tt", "s_zz", "s_rz", "s_rt", "s_tz")
MOTIONS = ("u_r", "u_t", "u_z")
inside = st.lists(st.tuples(st.floats(0.05, 4.0), st.floats(0.05, 4.0)), min_size=3, max_size=3)
"""(r, z) in contact radii."""


def state_of(tip, medium, share):
    """The contact, one state, its mean pressure and its depth."""
    contact = mdr.Contact(tip.profile, medium)
    state = contact.at_radius(float(tip.radii(share)[-1]))
    return contact, state, state.force / (math.pi * state.radius**2)


def faces(medium):
    """Depths of the interfaces."""
    if isinstance(medium, mdr.Homogeneous):
        return []
    layers = medium.layers if isinstance(medium, mdr.Layered) else [(medium.coating, medium.thickness)]
    return list(np.cumsum([h for _, h in layers]))


def material_at(medium, z):
    """E and nu at a depth."""
    if isinstance(medium, mdr.Homogeneous):
        return medium.material
    layers = medium.layers if isinstance(medium, mdr.Layered) else [(medium.coating, medium.thickness)]
    for (material, _), bottom in zip(layers, faces(medium), strict=True):
        if z < bottom:
            return material
    return medium.substrate


def bottom(medium):
    """Depth of a rigid base."""
    bodies = (medium.lower, medium.upper) if isinstance(medium, mdr.Pair) else (medium,)
    return min(faces(body)[-1] if getattr(body, "substrate", None) is mdr.RIGID else math.inf for body in bodies)


def within(medium, z):
    """Depths, moved up from a rigid base."""
    return np.minimum(z, 0.9 * bottom(medium))


def scattered(medium, state, points):
    """r and z of points given in contact radii."""
    r, z = (np.array(column) * state.radius for column in zip(*points, strict=True))
    return r, within(medium, z)


def largest(contact, state, mean):
    """Of the stresses of a state, about: pressures and what the layers add to them."""
    r, z = state.radius * np.array([0.0, 0.5, 0.9, 1.2]), within(contact.medium, state.radius * np.array([0.05, 0.3, 1.0]))
    field = state.interior(r[:, None], z[None, :])
    return max(mean, *(float(np.max(np.abs(getattr(field, name)))) for name in STRESSES))


@relation(40, tip=d.smooth_tips, medium=bodies, share=d.shares)
def test_surface_of_the_body(tip, medium, share):
    """At z = 0: u_z against the displacement of the contact, s_zz against -p, s_rz against 0, and no traction outside."""
    contact, state, mean = state_of(tip, medium, share)
    r = state.radius * np.array([0.0, 1e-6, 1e-3, 0.3, 0.9, 0.999, 1.001, 1.5, 10.0])
    field = state.interior(r, 0.0)
    p = np.concatenate([state.pressure(r[:6]), np.zeros(3)])
    size = max(mean, float(np.max(p)))
    near(field.u_z, state.displacement(r), DIGITS, size=state.depth, what="u_z")
    near(field.s_zz, -p, DIGITS, size=size, what="s_zz")
    near(field.s_rz, 0.0, DIGITS, size=size, what="s_rz")
    near(field.u_z[0], state.depth, DIGITS, size=state.depth, what="u_z(0, 0)")


def differences(contact, state, r, z, h, **options):
    """The field, its derivatives by r and by z."""
    offsets = np.array([-3, -2, -1, 1, 2, 3]) * h
    weights = np.array([-1.0, 9.0, -45.0, 45.0, -9.0, 1.0]) / (60.0 * h)
    here = state.interior(r, z, **options)
    by_r = state.interior(r + offsets, z, **options)
    by_z = state.interior(r, z + offsets, **options)
    slope = [{name: float(weights @ getattr(field, name)) for name in field._fields} for field in (by_r, by_z)]
    return here, *slope


def places(medium, state, points):
    """(r, z, step) of points in contact radii, moved away from the interfaces."""
    for x, y in points:
        r, z = x * state.radius, y * state.radius
        step = 0.02 * min(r, z, state.radius)
        near_face = [abs(z - face) for face in faces(medium)]
        if near_face and min(near_face) < 4.0 * step:
            continue
        if z < bottom(medium):
            yield r, z, step


@relation(30, tip=d.smooth_tips, medium=bodies, share=d.shares, points=inside)
def test_equilibrium(tip, medium, share, points):
    """Divergence of the stresses by differences of sixth order against 0."""
    contact, state, mean = state_of(tip, medium, share)
    size = largest(contact, state, mean)
    for r, z, step in places(medium, state, points):
        f, by_r, by_z = differences(contact, state, r, z, step)
        room = size / step
        near(by_r["s_rr"] + by_z["s_rz"] + (f.s_rr - f.s_tt) / r, 0.0, 1e-7, size=room, what="radial")
        near(by_r["s_rz"] + by_z["s_zz"] + f.s_rz / r, 0.0, 1e-7, size=room, what="axial")


@relation(30, tip=d.smooth_tips, medium=bodies, share=d.shares, points=inside)
def test_hookes_law(tip, medium, share, points):
    """Strains by differences of the displacements against those of the stresses."""
    contact, state, mean = state_of(tip, medium, share)
    size = largest(contact, state, mean)
    for r, z, step in places(medium, state, points):
        f, by_r, by_z = differences(contact, state, r, z, step)
        m = material_at(medium, z)
        total = m.nu * (f.s_rr + f.s_tt + f.s_zz)
        room = size / m.E + state.depth / step * 1e-3
        for strain, stress in ((by_r["u_r"], f.s_rr), (f.u_r / r, f.s_tt), (by_z["u_z"], f.s_zz)):
            near(strain, ((1.0 + m.nu) * stress - total) / m.E, 1e-6, size=room)
        near(by_z["u_r"] + by_r["u_z"], 2.0 * (1.0 + m.nu) * f.s_rz / m.E, 1e-6, size=room)


@relation(20, tip=d.smooth_tips, medium=bodies, share=d.shares, points=inside, f=st.floats(0.05, 1.0), angle=d.angles)
def test_equilibrium_under_friction(tip, medium, share, points, f, angle):
    """Divergence of the stresses of a sliding contact, with derivatives by the angle from its cosine and sine, against 0."""
    contact, state, mean = state_of(tip, medium, share)
    size = largest(contact, state, mean)
    for r, z, step in places(medium, state, points):
        s, by_r, by_z = differences(contact, state, r, z, step, friction=f, angle=angle)
        turn = 1e-2
        beside = [state.interior(r, z, friction=f, angle=angle + k * turn) for k in (-2, -1, 1, 2)]
        around = {n: (getattr(beside[0], n) - 8.0 * getattr(beside[1], n) + 8.0 * getattr(beside[2], n) - getattr(beside[3], n))
                     / (12.0 * turn) / r for n in STRESSES}  # fmt: skip
        room = size * (1.0 + f) / step
        near(by_r["s_rr"] + by_z["s_rz"] + around["s_rt"] + (s.s_rr - s.s_tt) / r, 0.0, 1e-7, size=room, what="radial")
        near(by_r["s_rz"] + by_z["s_zz"] + around["s_tz"] + s.s_rz / r, 0.0, 1e-7, size=room, what="axial")
        near(by_r["s_rt"] + by_z["s_tz"] + around["s_tt"] + 2.0 * s.s_rt / r, 0.0, 1e-7, size=room, what="around")


@relation(30, tip=d.closed_tips, medium=d.single_exact, share=d.shares, f=st.floats(0.0, 1.0), angle=d.angles)
def test_interfaces_are_bonded(tip, medium, share, f, angle):
    """Displacements and tractions above an interface against those below."""
    contact, state, mean = state_of(tip, medium, share)
    r = state.radius * np.array([0.0, 0.4, 1.0, 3.0])
    size = largest(contact, state, mean)
    on_rigid = medium.substrate is mdr.RIGID
    if on_rigid:
        field = state.interior(r, faces(medium)[-1], side="above", friction=f, angle=angle)
        near([field.u_r, field.u_z, field.u_t], 0.0, DIGITS, size=state.depth, what="on a rigid base")
    for z in faces(medium)[: -1 if on_rigid else None]:
        above, below = (state.interior(r, z, side=side, friction=f, angle=angle) for side in ("above", "below"))
        for name in MOTIONS:
            near(getattr(below, name), getattr(above, name), DIGITS, size=state.depth, what=name)
        for name in ("s_zz", "s_rz", "s_tz"):
            near(getattr(below, name), getattr(above, name), DIGITS, size=size, what=name)


@relation(5, tip=d.closed_tips, medium=bodies, share=d.shares, depth=d.between(0.1, 3.0))
def test_every_plane_carries_the_force(tip, medium, share, depth):
    """-2 pi int s_zz r dr at a depth, by Gauss and Legendre, against F."""
    contact, state, _ = state_of(tip, medium, share)
    z = float(within(medium, depth * state.radius))
    size = state.radius + z + (faces(medium)[-1] if faces(medium) else 0.0)
    ends = np.concatenate([np.linspace(0.0, 2.0, 7) * state.radius, np.geomspace(2.0 * state.radius, 600.0 * size, 15)[1:]])
    nodes, weight = np.polynomial.legendre.leggauss(16)
    low, high = ends[:-1, None], ends[1:, None]
    r = 0.5 * (low + high) + 0.5 * (high - low) * nodes
    carried = -2.0 * math.pi * float(np.sum(0.5 * (high - low) * weight * r * state.interior(r, z).s_zz))
    near(carried, state.force, 1e-6)


@relation(30, tip=d.closed_tips, material=d.materials, share=d.shares, depth=d.between(0.02, 30.0))
def test_axis_of_a_half_space(tip, material, share, depth):
    """s_zz, s_rr and u_z on the axis against Boussinesq's point forces under the contact's pressure, by tanh-sinh."""
    contact, state, mean = state_of(tip, mdr.Homogeneous(material), share)
    z, nu = depth * state.radius, material.nu

    def under(kernel):
        return disc(lambda r: state.pressure(r) * r * kernel(np.hypot(r, z)), state.radius, tip.corner)

    field = state.interior(0.0, z)
    near(field.s_zz, -3.0 * z**3 * under(lambda q: q**-5.0), 1e-8, size=mean)
    radial = under(lambda q: (1.0 - 2.0 * nu) * z / q**3 - 3.0 * z * (q * q - z * z) / q**5)
    near(field.s_rr + field.s_tt, radial, 1e-8, size=mean)
    near(field.u_z, (1.0 + nu) / material.E * under(lambda q: z * z / q**3 + 2.0 * (1.0 - nu) / q), 1e-8, size=state.depth)


@relation(30, tip=d.closed_tips, medium=bodies, share=d.shares, points=inside, unit=d.units)
def test_units_of_stresses(tip, medium, share, points, unit):
    """The field in other units of length and modulus."""
    s, t = unit
    contact, state, mean = state_of(tip, medium, share)
    other = mdr.Contact(in_units(tip.profile, s), in_units(medium, s, t))
    again = other.at_radius(state.radius * s)
    r, z = scattered(medium, state, points)
    one, two = state.interior(r, z), again.interior(r * s, z * s)
    for name in ("u_r", "u_z"):
        near(getattr(two, name), getattr(one, name) * s, DIGITS, size=state.depth * s)
    for name in ("s_rr", "s_tt", "s_zz", "s_rz"):
        near(getattr(two, name), getattr(one, name) * t, DIGITS, size=largest(contact, state, mean) * t)


@relation(30, tip=d.closed_tips, medium=d.single_exact, share=d.shares, points=inside, cut=parts)
def test_layers_cut_in_two_inside(tip, medium, share, points, cut):
    """The field in a layer against that in two layers of its material."""
    contact, state, mean = state_of(tip, medium, share)
    other, again, _ = state_of(tip, split(medium, cut), share)
    r, z = scattered(medium, state, points)
    one, two = state.interior(r, z), again.interior(r, z)
    for name in ("u_r", "u_z"):
        near(getattr(two, name), getattr(one, name), DIGITS, size=state.depth)
    for name in ("s_rr", "s_tt", "s_zz", "s_rz"):
        near(getattr(two, name), getattr(one, name), DIGITS, size=largest(contact, state, mean))


@relation(30, tip=d.closed_tips, medium=bodies, share=d.shares, points=inside, f=st.floats(0.05, 2.0), angle=d.angles)
def test_friction_turns_with_the_angle(tip, medium, share, points, f, angle):
    """Sliding at an angle against cosine and sine of sliding at 0 and at a right angle, in proportion to the coefficient."""
    contact, state, mean = state_of(tip, medium, share)
    r, z = scattered(medium, state, points)
    still, ahead, aside, turned = (state.interior(r, z, friction=mu, angle=phi)
                                   for mu, phi in ((0.0, 0.0), (1.0, 0.0), (1.0, 0.5 * math.pi), (f, angle)))  # fmt: skip
    size = largest(contact, state, mean)
    for name in (*MOTIONS, *STRESSES):
        zero = getattr(still, name)
        share_of = f * math.cos(angle), f * math.sin(angle)
        expected = zero + share_of[0] * (getattr(ahead, name) - zero) + share_of[1] * (getattr(aside, name) - zero)
        near(getattr(turned, name), expected, DIGITS, size=(1.0 + f) * (state.depth if name in MOTIONS else size), what=name)


@relation(20, tip=d.closed_tips, lower=bodies, upper=bodies, share=d.shares, points=inside)
def test_bodies_of_a_pair_swapped(tip, lower, upper, share, points):
    """The field in the lower body against that in the upper one of the swapped pair."""
    contact, state, mean = state_of(tip, mdr.Pair(lower, upper), share)
    other, again, _ = state_of(tip, mdr.Pair(upper, lower), share)
    r, z = scattered(contact.medium, state, points)
    one, two = state.interior(r, z, body="lower"), again.interior(r, z, body="upper")
    size = largest(contact, state, mean)
    for name in ("u_r", "u_z", "s_rr", "s_tt", "s_zz", "s_rz"):
        near(getattr(two, name), getattr(one, name), DIGITS, size=state.depth if name[0] == "u" else size, what=name)


@relation(20, tip=d.closed_tips, medium=bodies, share=d.shares, points=inside)
def test_scattered_points_and_grids(tip, medium, share, points):
    """A grid against its points one by one."""
    contact, state, mean = state_of(tip, medium, share)
    r, z = scattered(medium, state, points)
    grid = state.interior(r[:, None], z[None, :])
    size = largest(contact, state, mean)
    for i, j in ((0, 0), (1, 2), (2, 1)):
        one = state.interior(float(r[i]), float(z[j]))
        for name in ("u_r", "u_z", "s_rr", "s_tt", "s_zz", "s_rz"):
            near(getattr(grid, name)[i, j], getattr(one, name), 0.1 * DIGITS, size=state.depth if name[0] == "u" else size)


@relation(5, tip=d.smooth_tips, medium=d.single_exact, share=d.shares)
def test_energies_of_layers_add_up(tip, medium, share):
    """The sum over the layers against the energy of the state."""
    assume(medium.substrate is not mdr.RIGID)
    contact, state, _ = state_of(tip, medium, share)
    energies = [layer.energy for layer in state.critical().layers]
    near(sum(energies), state.energy(), 1e-6)
    assert min(energies) >= 0.0


@relation(20, tip=d.smooth_tips, medium=bodies, share=d.shares, depth=st.floats(0.1, 2.0))
def test_the_axis_is_smooth(tip, medium, share, depth):
    """s_rr against s_tt on the axis, u_r and s_rz against 0, du_r/dr by differences against Hooke's law."""
    contact, state, mean = state_of(tip, medium, share)
    ((_, z, step),) = [*places(medium, state, [(1.0, depth)])] or [(0.0, 0.0, 0.0)]
    assume(step > 0.0)
    f = state.interior(0.0, z)
    size = largest(contact, state, mean)
    near(f.s_rr, f.s_tt, DIGITS, size=size)
    near([f.u_r, f.s_rz], 0.0, DIGITS, size=[state.depth, size])
    m = material_at(medium, z)
    strain = state.interior(1e-3 * step, z).u_r / (1e-3 * step)
    near(strain, ((1.0 - m.nu) * f.s_rr - m.nu * f.s_zz) / m.E, 1e-5, size=size / m.E)
    by_z = slopes(lambda y: state.interior(0.0, y).u_z, z, step)
    near(by_z, (f.s_zz - 2.0 * m.nu * f.s_rr) / m.E, 1e-6, size=size / m.E)


graded = st.builds(
    lambda E, nu, h: mdr.Graded([0.0, h], E, nu),
    st.lists(d.between(0.3, 30.0), min_size=2, max_size=2),
    d.usual_ratios,
    d.between(0.5, 2.0),
)
"""Contrasts to 100."""


@relation(2, tip=d.endless_tips, medium=graded, share=d.shares, may_refuse=0.2)
def test_surface_of_graded_bodies(tip, medium, share):
    """u_z(0, 0) against d, u_z on the surface against the displacement, s_zz against -p."""
    contact, state, mean = state_of(tip, medium, share)
    r = state.radius * np.array([0.0, 0.5, 0.9, 2.0])
    field = state.interior(r, 0.0)
    p = np.concatenate([state.pressure(r[:3]), [0.0]])
    near(field.u_z[0], state.depth, DIGITS, what="u_z(0, 0)")
    near(field.u_z, state.displacement(r), DIGITS, size=state.depth, what="u_z")
    near(field.s_zz, -p, DIGITS, size=max(mean, float(p.max())), what="s_zz")


@relation(4, tip=d.paraboloids, medium=graded, depth=st.floats(0.1, 0.9), share=d.shares)
def test_collinear_knots_inside_graded_bodies(tip, medium, depth, share):
    """Stresses under a graded body's surface against those with a further knot on its straight line."""
    z = medium.z[-1]
    other = mdr.Graded([0.0, depth * z, z], np.interp([0.0, depth * z, z], medium.z, medium.E), medium.nu[0])
    (contact, state, mean), (again, same_state, _) = (state_of(tip, body, share) for body in (medium, other))
    one, two = (s.interior(np.array([0.0, 0.7]) * state.radius, 0.4 * z) for c, s in ((contact, state), (again, same_state)))
    for name in ("s_rr", "s_tt", "s_zz", "s_rz"):
        near(getattr(two, name), getattr(one, name), DIGITS, size=largest_of(one, mean))
    near(two.u_z, one.u_z, DIGITS, size=state.depth)


@relation(2, tip=d.paraboloids, medium=graded, depth=st.floats(0.2, 2.0), share=d.shares)
def test_planes_of_graded_bodies_carry_the_force(tip, medium, depth, share):
    """-2 pi int s_zz r dr at a depth of a graded body against F; far from the axis s_zz falls as r^-5."""
    contact, state, _ = state_of(tip, medium, share)
    a, z = state.radius, depth * state.radius
    far = 150.0 * (a + z + medium.z[-1])
    ends = np.concatenate([np.linspace(0.0, 2.0, 5) * a, np.geomspace(2.0 * a, far, 11)[1:]])
    nodes, weight = np.polynomial.legendre.leggauss(8)
    low, high = ends[:-1, None], ends[1:, None]
    r = 0.5 * (low + high) + 0.5 * (high - low) * nodes
    stress = state.interior(np.append(r, far), z).s_zz
    carried = np.sum(0.5 * (high - low) * weight * r * stress[:-1].reshape(r.shape)) + stress[-1] * far**2 / 3.0
    near(-2.0 * math.pi * carried, state.force, 3e-6)


def largest_of(field, mean):
    """Of the stresses of a field, and the mean pressure."""
    return max(mean, *(float(np.max(np.abs(getattr(field, name)))) for name in ("s_rr", "s_tt", "s_zz", "s_rz")))


sharp = st.one_of(
    st.builds(lambda c0, c1: d.Tip(mdr.AreaFunction([c0, c1], max_height=100.0)), st.floats(5.0, 30.0), d.between(1e-3, 0.3)),
    st.builds(lambda c0, c2: d.Tip(mdr.AreaFunction([c0, 0.0, c2], max_height=100.0)), st.floats(5.0, 30.0), d.between(1e-2, 1.0)),
    st.floats(10.0, 40.0).map(lambda n: d.Tip(mdr.PowerLaw(n, 1.0), low=0.5, high=1.2)),
    st.floats(2.0, 6.0).map(lambda n: d.Tip(mdr.PowerLaw(n, 0.3))),
    st.builds(lambda b, phi: d.Tip(mdr.RoundedCone(b, phi), corner=b), d.between(1e-3, 1e-1), d.inclinations),
)
"""Whose line load varies fast near the axis or near the edge."""


@relation(20, tip=sharp, medium=bodies, share=d.shares)
def test_surface_under_sharp_tips(tip, medium, share):
    """s_zz and u_z at z = 0, on the axis and off it, against -p and the displacement."""
    contact, state, mean = state_of(tip, medium, share)
    r = state.radius * np.array([0.0, 1e-4, 1e-2, 0.3, 0.9])
    field, p = state.interior(r, 0.0), state.pressure(r)
    inside = np.isfinite(p)
    size = max(mean, float(np.max(p[inside])))
    near(field.s_zz[inside], -p[inside], DIGITS, size=size, what="s_zz")
    near(field.u_z, state.displacement(r), DIGITS, size=state.depth, what="u_z")


@relation(20, tip=sharp, material=d.materials, share=d.shares, depth=d.between(1e-3, 30.0))
def test_axis_under_sharp_tips(tip, material, share, depth):
    """s_zz on the axis of a half-space against Boussinesq's point forces under the contact's pressure."""
    contact, state, mean = state_of(tip, mdr.Homogeneous(material), share)
    z = depth * state.radius
    ends = [*(state.radius * 2.0 ** np.arange(-40.0, 0.0)), *([tip.corner] if tip.corner and tip.corner < state.radius else [])]
    angles = sorted({0.0, *(math.asin(r / state.radius) for r in ends), 0.5 * math.pi})

    def load(angle):
        r = state.radius * np.sin(angle)
        return state.pressure(r) * r * np.hypot(r, z) ** -5.0 * state.radius * np.cos(angle)

    near(
        state.interior(0.0, z).s_zz,
        -3.0 * z**3 * panels(load, angles),
        DIGITS,
        size=max(mean, float(state.pressure(1e-3 * state.radius))),
    )


@relation(15, tip=d.closed_tips, film=d.usual, base=d.usual, wide=d.between(30.0, 100.0), share=d.shares)
def test_surface_of_thin_films(tip, film, base, wide, share):
    """s_zz and u_z at z = 0 of films at a/h from 30 to 100 against -p and the displacement."""
    a = float(tip.radii(share)[-1])
    contact, state, mean = state_of(tip, mdr.Coated(film, a / wide, base), share)
    r = state.radius * np.array([1e-3, 0.1, 0.5, 0.9])
    field, p = state.interior(r, 0.0), state.pressure(r)
    near(field.s_zz, -p, DIGITS, size=max(mean, float(np.max(np.abs(p)))), what="s_zz")
    near(field.u_z, state.displacement(r), DIGITS, size=state.depth, what="u_z")
