# SPDX-License-Identifier: GPL-3.0-or-later
"""Composites: structures against homogeneous bodies, each other, and themselves moved."""

import math

import numpy as np
from hypothesis import strategies as st

import mdrcontact as mdr
from mdrcontact import lateral

from . import draws as d
from .harness import near, relation
from .references import reduced

exponents = st.sampled_from([1.0, 0.5, 0.0, -0.65, -1.0])
places = st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
sizes = d.between(0.2, 3.0)
radii = np.array([0.1, 0.7, 4.0])
SHAPES = 3e-5
"""Relative: shapes have a tolerance of 1e-5 of G and of 1 - nu."""


def coordinates(low, high):
    return st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0), st.floats(low, high))


shapes = st.one_of(
    st.builds(lateral.Ball, coordinates(0.2, 3.0), sizes, d.usual),
    st.builds(
        lambda x, y, z, u, r, m: lateral.Fibre((x, y, z), (math.cos(u), math.sin(u), 0.0), r, m),
        *[st.floats(-2.0, 2.0)] * 2,
        st.floats(0.2, 3.0),
        d.angles,
        sizes,
        d.usual,
    ),
    st.builds(
        lambda x, y, r, top, h, m: lateral.Pillar(x, y, r, top, top + h, m),
        *[st.floats(-2.0, 2.0)] * 2,
        sizes,
        st.floats(0.0, 1.0),
        sizes,
        d.usual,
    ),
    st.builds(
        lambda x, y, z, a, b, c, m: lateral.Box((x, x + a), (y, y + b), (z, z + c), m),
        *[st.floats(-2.0, 2.0)] * 2,
        st.floats(0.0, 1.0),
        sizes,
        sizes,
        sizes,
        d.usual,
    ),
    st.builds(lambda top, h, m: lateral.Layer(top, top + h, m), st.floats(0.0, 1.0), sizes, d.usual),
)
structures = st.builds(
    lambda base, bodies, p: lateral.Shapes(base, bodies, exponent=p), d.usual, st.lists(shapes, min_size=1, max_size=3), exponents
)
labels = st.lists(st.integers(0, 1), min_size=36, max_size=36).map(lambda v: np.array(v).reshape(3, 3, 4))
voxels = st.builds(
    lambda cells, phases, p, h: lateral.Voxels(cells, phases, (0.3 * h, 0.5 * h, 0.4 * h), exponent=p, images=2),
    labels,
    st.tuples(d.usual, d.usual),
    exponents,
    sizes,
)


def moved(shape, move):
    """A shape whose points (x, y, z) go to move(x, y, z); directions and ranges alike."""
    start = move(0.0, 0.0, 0.0)

    def turned(v):
        return tuple(b - a for a, b in zip(start, move(*v), strict=True))

    match shape:
        case lateral.Ball():
            return shape._replace(centre=move(*shape.centre))
        case lateral.Fibre():
            return shape._replace(point=move(*shape.point), direction=turned(shape.direction))
        case lateral.Pillar():
            x, y, _ = move(shape.x, shape.y, 0.0)
            return shape._replace(x=x, y=y)
        case lateral.Box():
            ends = [move(shape.x[k], shape.y[k], 0.0) for k in (0, 1)]
            x, y = (tuple(sorted(end[i] for end in ends)) for i in (0, 1))
            return shape._replace(x=x, y=y)
    return shape


MOVES = {
    "shifted": lambda x, y, z: (x + 0.7, y - 1.3, z),
    "mirrored": lambda x, y, z: (-x, y, z),
    "turned by a right angle": lambda x, y, z: (-y, x, z),
}


@relation(15, structure=structures, place=places, way=st.sampled_from(sorted(MOVES)), may_refuse=0.3)
def test_shapes_moved(structure, place, way):
    """A structure shifted, mirrored or turned, with the place, against the structure."""
    move = MOVES[way]
    other = structure.replace(shapes=[moved(shape, move) for shape in structure.shapes])
    x, y, _ = move(*place, 0.0)
    near(other.modulus(x, y, radii), structure.modulus(*place, radii), 2.0 * SHAPES)


@relation(30, structure=structures, place=places, s=d.between(1e-9, 1e6), t=d.between(1e-6, 1e12))
def test_units_of_structures(structure, place, s, t):
    """A structure in other units of length and modulus, as a field of a function."""

    def scaled(x, y, z):
        E, nu = structure.materials(np.asarray(x) / s, np.asarray(y) / s, np.asarray(z) / s)
        return np.asarray(E) * t, nu

    nu = structure.background.nu
    one = lateral.Field(structure.materials, nu, tolerance=0.1, exponent=structure.exponent)
    two = lateral.Field(scaled, nu, tolerance=0.1, exponent=structure.exponent)
    x, y = place
    near(two.modulus(x * s, y * s, 0.7 * s), one.modulus(x, y, 0.7) * t, 1e-2)


@relation(15, material=d.extreme, structure=structures, place=places)
def test_uniform_structures_are_homogeneous(material, structure, place):
    """Shapes, voxels and fields of one material against E*."""
    expected = reduced(material)
    same = lateral.Shapes(material, [shape._replace(material=material) for shape in structure.shapes], exponent=structure.exponent)
    near(same.modulus(*place, radii), expected, 1e-9)
    cells = lateral.Voxels(np.zeros((2, 3, 4), int), [material], 0.5, exponent=structure.exponent)
    near(cells.modulus(*place, radii), expected, 1e-11)
    near(lateral.effective_map(cells, radii), expected, 1e-11)
    near(lateral.Field(lambda x, y, z: (material.E, material.nu), material.nu).modulus(*place, radii), expected, 1e-9)


@relation(30, layer=d.usual, base=d.usual, top=st.floats(0.0, 1.0), h=sizes, place=places, p=exponents)
def test_layers_are_those_of_the_weights(layer, base, top, h, place, p):
    """A layer among shapes against the layered medium with Gao's weights."""
    options = {"weight_nu": base.nu, "exponent": p}
    below = [(base, top)] if top > 1e-3 else []
    expected = mdr.Layered([*below, (layer, h)], base, "gao-power", **options).modulus(radii)
    structure = lateral.Shapes(
        base, [lateral.Layer(top if below else 0.0, (top if below else 0.0) + h, layer)], exponent=p, tolerance=1e-8
    )
    near(structure.modulus(*place, radii), expected, 1e-6)


@relation(15, structure=structures, place=places, may_refuse=0.3)
def test_structures_lie_between_their_bounds(structure, place):
    """E_eff between the means in series and in parallel, and these between the softest and the stiffest material."""
    low, high = structure.bounds(*place, radii)
    found = structure.modulus(*place, radii)
    assert np.all((found >= low * (1.0 - SHAPES)) & (found <= high * (1.0 + SHAPES)))
    materials = [structure.background, *(shape.material for shape in structure.shapes)]
    G = [0.5 * m.E / (1.0 + m.nu) for m in materials]
    nu = [m.nu for m in materials]
    assert np.all(low >= 2.0 * min(G) / (1.0 - min(nu)) * (1.0 - SHAPES)) and np.all(
        high <= 2.0 * max(G) / (1.0 - max(nu)) * (1.0 + SHAPES)
    )


@relation(10, structure=voxels, a=d.between(0.1, 3.0))
def test_maps_are_points(structure, a):
    """A map by Fourier transform against the points one by one."""
    x, y = structure.centres()
    near(lateral.effective_map(structure, [a])[0], structure.modulus(x[None, :], y[:, None], a), 1e-7)


@relation(20, structure=voxels, a=d.between(0.1, 3.0), shift=st.tuples(st.integers(0, 2), st.integers(0, 3)))
def test_periodic_maps_shifted_and_mirrored(structure, a, shift):
    """The map of rolled and of mirrored labels against the rolled and mirrored map."""
    found = lateral.effective_map(structure, [a])[0]
    rolled = structure.replace(labels=np.roll(structure.labels, shift, (1, 2)))
    near(lateral.effective_map(rolled, [a])[0], np.roll(found, shift, (0, 1)), 1e-9)
    mirrored = structure.replace(labels=structure.labels[:, :, ::-1])
    near(lateral.effective_map(mirrored, [a])[0], found[:, ::-1], 1e-9)


@relation(15, structure=voxels, beside=d.usual, a=d.between(0.2, 2.0), place=places)
def test_voxels_cut_finer(structure, beside, a, place):
    """Cells against their eighths; not periodic, where the last image ends elsewhere."""
    labels = np.repeat(np.repeat(np.repeat(structure.labels, 2, 0), 2, 1), 2, 2)
    fine = structure.replace(labels=labels, spacing=np.array(structure.spacing) / 2.0, beside=beside, images=1)
    near(fine.modulus(*place, a), structure.replace(beside=beside, images=1).modulus(*place, a), 1e-6)


@relation(20, a=d.between(0.3, 3.0), nu=d.usual_ratios, x=st.floats(-1.0, 1.0), top=d.between(0.05, 1.0), h=sizes)
def test_cells_add_up(a, nu, x, top, h):
    """Weights of cells, split in two each way, against the weights of the whole cell; a plane of cells against I0."""
    whole = lateral.cell_weights(a, [x, x + 1.0], [-0.5, 0.7], top, top + h, nu)
    parts = lateral.cell_weights(a, [x, x + 0.3, x + 1.0], [-0.5, 0.1, 0.7], top, top + h, nu)
    halves = [
        lateral.cell_weights(a, [x, x + 1.0], [-0.5, 0.7], *span, nu) for span in ((top, top + 0.4 * h), (top + 0.4 * h, top + h))
    ]
    for k in (0, 1):
        near(parts[k].sum(), whole[k].sum(), 1e-6)
        near(halves[0][k].sum() + halves[1][k].sum(), whole[k].sum(), 1e-6)


@relation(2, structure=voxels, R=d.lengths, depth=d.between(1e-2, 1e-1), place=places)
def test_a_place_of_a_structure_in_contact(structure, R, depth, place):
    """F on the medium of one place against int 2 a E_eff(a) dd by Gauss and Legendre."""
    radius = math.sqrt(R * depth)
    medium = lateral.LateralMedium(structure, *place, 1e-3 * radius, 1.1 * radius, points=80)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    a = 0.5 * radius * (1.0 + nodes)
    expected = 0.5 * radius * float(np.sum(weights * 2.0 * a * structure.modulus(*place, a) * 2.0 * a / R))
    near(mdr.Contact(mdr.Paraboloid(R), medium).at_depth(depth).force, expected, 1e-3)
