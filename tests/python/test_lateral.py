# SPDX-License-Identifier: GPL-3.0-or-later
"""Laterally heterogeneous structures from Python: descriptions against each other, maps against points, energy against force."""

import pickle
import re
import sys

import numpy as np
import pytest
from scipy.integrate import trapezoid

import mdrcontact as mdr
from mdrcontact import lateral

MATRIX = mdr.Elastic(3e9, 0.35)
GLASS = mdr.Elastic(70e9, 0.22)
RUBBER = mdr.Elastic(2e6, 0.5)
STIFF_RUBBER = mdr.Elastic(6e6, 0.5)
RADII = np.array([0.4e-6, 1.5e-6, 6e-6])
BALL = lateral.Ball((5e-6, 5e-6, 4e-6), 3e-6, GLASS)
ROUNDING = 1e-12


def composite(n: int = 12, seed: int = 1, **options) -> lateral.Voxels:
    """Random voxels of two phases, not cubes, more columns than rows."""
    labels = np.random.default_rng(seed).integers(0, 2, (6, n, n + 3))
    return lateral.Voxels(labels, [MATRIX, GLASS], (0.3e-6, 0.5e-6, 0.4e-6), **options)


def test_density_integrates_to_the_weight_of_a_plane():
    from scipy.integrate import quad

    for z, nu in ((0.3, 0.5), (1.0, 0.2)):

        def ring(rho, which, z=z, nu=nu):
            return 2.0 * np.pi * rho * lateral.density(rho, z, nu)[which]

        shear = sum(quad(ring, *span, args=(0,), epsabs=1e-12, limit=200)[0] for span in ((0, 1), (1, 5), (5, np.inf)))
        poisson = sum(quad(ring, *span, args=(1,), epsabs=1e-12, limit=200)[0] for span in ((0, 1), (1, 5), (5, np.inf)))
        step = 1e-5
        assert shear == pytest.approx(
            (mdr.weights.weight_i0(z + step, nu) - mdr.weights.weight_i0(z - step, nu)) / (2 * step), rel=1e-8
        )
        assert poisson == pytest.approx((mdr.weights.weight_i1(z + step) - mdr.weights.weight_i1(z - step)) / (2 * step), rel=1e-8)


def test_cells_of_a_slab_make_the_weight_of_the_slab():
    x, y = np.linspace(-3.0, 5.0, 17), np.linspace(-4.0, 2.0, 9)
    shear, poisson = lateral.cell_weights(1.0, x, y, 0.0, 0.5, 0.3)
    assert shear.shape == (8, 16)
    whole = lateral.cell_weights(1.0, [-3.0, 5.0], [-4.0, 2.0], 0.0, 0.5, 0.3)
    assert shear.sum() == pytest.approx(whole[0].item(), rel=1e-6)
    assert poisson.sum() == pytest.approx(whole[1].item(), rel=1e-6)


def test_cells_across_the_edge_of_the_contact_add_up():
    """A cell at a tenth of the contact radius below its edge, and the same cell in 64 parts."""
    for corner, width in (((-0.42, -0.21), (0.42, 0.5)), ((0.58, 0.1), (0.9, 0.7)), ((-1.3, 0.05), (0.6, 0.55))):
        lines = [start + length * np.linspace(0.0, 1.0, 9) for start, length in zip(corner, width, strict=True)]
        whole, parts = (lateral.cell_weights(1.0, x, y, 0.158, 0.266, 0.5) for x, y in ([v[[0, -1]] for v in lines], lines))
        for one, all_ in zip(whole, parts, strict=True):
            assert all_.sum() == pytest.approx(one.item(), rel=5e-7)


MEANS = [("gao", 1.0, {}), ("gao-series", -1.0, {}), ("gao-power", -0.65, {}), ("gao-power", 0.0, {"exponent": 0.0})]
"""Models of a layered body, and the exponent of the mean that they are."""


@pytest.mark.parametrize("nu", [0.5, 0.2])
@pytest.mark.parametrize(("model", "exponent", "options"), MEANS)
def test_layers_are_gaos_layers(nu, model, exponent, options):
    coating, substrate = mdr.Elastic(5.0, nu), mdr.Elastic(1.0, 0.3)
    a = np.array([0.01, 0.3, 1.0, 20.0])
    expected = mdr.Coated(coating, 0.6, substrate, model, **options).modulus(a)
    shapes = lateral.Shapes(substrate, [lateral.Layer(0.0, 0.6, coating)], reference_nu=nu, exponent=exponent)
    np.testing.assert_allclose(shapes.modulus(0.3, -1.0, a), expected, rtol=1e-6)
    voxels = lateral.Voxels(
        np.zeros((3, 4, 5), int), [coating], (0.2, 0.7, 0.3), below=substrate, reference_nu=nu, exponent=exponent
    )
    np.testing.assert_allclose(voxels.modulus(0.3, -1.0, a), expected, rtol=ROUNDING)
    np.testing.assert_allclose(lateral.effective_map(voxels, a), np.broadcast_to(expected[:, None, None], (4, 4, 5)), rtol=ROUNDING)


def test_a_homogeneous_structure_returns_itself_exactly():
    voxels = lateral.Voxels(np.random.default_rng(0).integers(0, 2, (3, 4, 5)), [MATRIX, MATRIX], 1e-6)
    expected = 2.0 * (0.5 * MATRIX.E / (1.0 + MATRIX.nu)) / (1.0 - MATRIX.nu)
    assert np.all(lateral.effective_map(voxels, RADII) == expected)
    assert np.all(voxels.modulus(1e-6, 0.3e-6, RADII) == expected)
    assert np.all(lateral.Shapes(MATRIX, [BALL._replace(material=MATRIX)]).modulus(0.0, 0.0, RADII) == expected)
    assert np.all(lateral.Shapes(MATRIX).modulus(0.0, 0.0, RADII) == expected)
    assert lateral.indentation_map(voxels, mdr.Sphere(1e-5), 1e-8).apparent_modulus == pytest.approx(expected, rel=ROUNDING)


def test_interface_mean_for_every_radius():
    body = lateral.Shapes(RUBBER, [lateral.HalfSpace((0.0, 0.0, 0.0), (1.0, 2.0, 0.0), STIFF_RUBBER)])
    np.testing.assert_allclose(body.modulus(2.0, -1.0, np.geomspace(1e-4, 1e4, 9)), 4.0 / 0.75 * 1e6, rtol=1e-6)


@pytest.mark.parametrize("contrast", [0.1, 0.2, 5.0, 10.0])
@pytest.mark.parametrize("nu", [0.5, 0.3])
def test_bounds_hold_the_exact_solution(contrast, nu):
    """At one Poisson's ratio; and means of rising exponent rise from one bound to the other."""
    coating, substrate, a = mdr.Elastic(contrast, nu), mdr.Elastic(1.0, nu), np.array([0.03, 0.3, 1.0, 3.0, 30.0])
    exact = mdr.Coated(coating, 1.0, substrate).modulus(a)
    body = lateral.Shapes(substrate, [lateral.Layer(0.0, 1.0, coating)])
    bounds = body.bounds(0.0, 0.0, a)
    assert np.all(bounds.lower < exact) and np.all(exact < bounds.upper)
    between = [body.replace(exponent=p).modulus(0.0, 0.0, a) for p in (-1.0, -0.65, -1e-9, 0.0, 0.5, 1.0)]
    assert np.all(np.diff(between, axis=0) > -1e-8)
    np.testing.assert_array_equal(between[0], bounds.lower)
    np.testing.assert_array_equal(between[-1], bounds.upper)
    assert np.all(body.bounds(0.0, 0.0, a).upper == body.replace(exponent=-1.0).bounds(0.0, 0.0, a).upper)


def test_bounds_of_every_structure_agree():
    """One ball as shapes, voxels and a function."""
    ball = lateral.Ball((0.0, 0.0, 1.2), 0.7, mdr.Elastic(5.0, 0.3))
    shapes = lateral.Shapes(mdr.Elastic(1.0, 0.3), [ball])
    voxels = lateral.Voxels.from_shapes(shapes, 0.1, (20, 20, 20), origin=(-1.0, -1.0), beside=shapes.background)
    smooth = lateral.Field(lambda x, y, z: (3.0 - 2.0 * np.tanh(10.0 * (x**2 + y**2 + (z - 1.2) ** 2 - 0.49)), 0.3), 0.3,
                           tolerance=0.02)  # fmt: skip
    expected = shapes.bounds(0.1, 0.0, 0.8)
    assert expected.upper > 1.02 * expected.lower
    assert voxels.bounds(0.1, 0.0, 0.8) == pytest.approx(expected, rel=0.01)
    assert smooth.bounds(0.1, 0.0, 0.8) == pytest.approx(expected, rel=0.03)


@pytest.mark.parametrize("exponent", [1.0, -1.0, -0.65])
@pytest.mark.parametrize("beside", ["periodic", MATRIX])
def test_map_agrees_with_points(beside, exponent):
    for n in (8, 9):
        voxels = composite(n, beside=beside, origin=(-1e-6, 2e-6), exponent=exponent)
        maps = lateral.effective_map(voxels, RADII, threads=2)
        x, y = voxels.centres()
        for j, i in ((0, 0), (3, 5), (n - 1, n + 2)):
            np.testing.assert_allclose(maps[:, j, i], voxels.modulus(x[i], y[j], RADII), rtol=1e-7)


def test_voxels_approach_shapes_at_the_order_of_their_size():
    shapes = lateral.Shapes(MATRIX, [BALL], reference_nu=0.3)
    places = np.array([[5e-6, 5e-6], [6.3e-6, 4.1e-6], [2.9e-6, 5.7e-6], [8.3e-6, 7.1e-6], [4.4e-6, 3.6e-6]])
    errors = []
    for n in (10, 20, 40):
        voxels = lateral.Voxels.from_shapes(shapes, 10e-6 / n, (n, n, n), beside=MATRIX, reference_nu=0.3)
        ratio = [voxels.modulus(*place, RADII) / shapes.modulus(*place, RADII) - 1.0 for place in places]
        errors.append(np.sqrt(np.mean(np.square(ratio))))
    assert errors[1] < 0.6 * errors[0]
    assert errors[2] < 0.6 * errors[1]
    assert errors[2] < 0.02


def test_tiles_make_the_map():
    voxels = composite(10, beside=MATRIX)
    whole = lateral.effective_map(voxels, RADII)
    np.testing.assert_allclose(lateral.tiled_map(voxels, RADII, tile=(4, 5), halo=13), whole, rtol=1e-10)
    periodic = composite(10)
    whole, tiled = lateral.effective_map(periodic, RADII[:1]), lateral.tiled_map(periodic, RADII[:1], tile=5, halo=7)
    # all that a halo of 2.8 um leaves out, times the contrast
    assert np.abs(tiled / whole - 1.0).max() < 25.0 * lateral.weight_beyond(RADII[0], 2.8e-6, 1.8e-6, 0.3)
    assert np.abs(tiled / whole - 1.0).max() < 0.02


def test_dask_tiles_are_the_same():
    import dask.array as dask_array

    voxels = composite(10)
    lazy = voxels.replace(labels=dask_array.from_array(voxels.labels, chunks=(3, 5, 5)))
    result = lateral.tiled_map(lazy, RADII, tile=6, halo=4)
    assert result.shape == (3, 10, 13)
    np.testing.assert_allclose(result.compute(), lateral.tiled_map(voxels, RADII, tile=6, halo=4), rtol=ROUNDING)


def test_memory_is_stated_and_refused_beforehand():
    voxels = composite()
    needed = lateral.map_memory(voxels, RADII)
    for limit in (needed - 1, float("nan")):
        with pytest.raises(mdr.errors.OutOfMemoryError, match="memory_limit"):
            lateral.effective_map(voxels, RADII, memory_limit=limit)
    assert lateral.effective_map(voxels, RADII, memory_limit=needed).shape == (3, 12, 15)


def test_stated_memory_bounds_what_numpy_allocates():
    import tracemalloc

    voxels = lateral.Voxels(np.random.default_rng(2).integers(0, 2, (8, 64, 96)).astype(np.uint8), [MATRIX, GLASS], 1e-6)
    lateral.effective_map(voxels, RADII[:1])
    tracemalloc.start()
    lateral.effective_map(voxels, RADII, threads=2)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < lateral.map_memory(voxels, RADII, threads=2)


def test_field_is_the_layered_medium_for_a_smooth_gradient():
    def rising(x, y, z):
        return 1.0 + z / (1.0 + z), 0.5

    z = np.concatenate([[0.0], np.geomspace(1e-4, 1e5, 4000)])
    graded = mdr.Graded(z, 1.0 + z / (1.0 + z), 0.5, "gao")
    field = lateral.Field(rising, 0.5, tolerance=1e-6)
    a = np.array([0.1, 1.0, 10.0])
    np.testing.assert_allclose(field.modulus(0.0, 0.0, a), graded.modulus(a), rtol=1e-4)


def test_lateral_medium_in_a_contact():
    body = lateral.Shapes(MATRIX, [BALL])
    medium = lateral.LateralMedium(body, 5e-6, 5e-6, 1e-8, 1e-5, points=200)
    contact = mdr.Contact(mdr.Sphere(10e-6), medium)
    state = contact.at_depth(1e-7)
    assert state.stiffness == pytest.approx(2 * state.radius * body.modulus(5e-6, 5e-6, state.radius), rel=1e-4)
    r = np.sin(np.linspace(0.0, np.pi / 2, 2001)) * state.radius * (1 - 1e-12)
    p = contact.at_radius(state.radius).pressure(r)
    assert trapezoid(2 * np.pi * r * p, r) == pytest.approx(state.force, rel=1e-4)
    assert pickle.loads(pickle.dumps(medium)) == medium


@pytest.mark.slow
def test_indentation_map_agrees_with_contacts():
    voxels = composite()
    x, y = voxels.centres()
    medium = lateral.LateralMedium(voxels, x[4], y[7], 1e-8, 3e-6, points=200)
    for indenter in (mdr.Sphere(10e-6), mdr.Cone(0.3), mdr.FlatPunch(1e-6), mdr.FlatEndedCone(3e-7, 0.3)):
        found = lateral.indentation_map(voxels, indenter, 5e-8, nodes=32)
        expected = mdr.Contact(indenter, medium).at_depth(5e-8)
        assert found.force[7, 4] == pytest.approx(expected.force, rel=5e-4)
        assert found.stiffness[7, 4] == pytest.approx(expected.stiffness, rel=1e-4)
        assert found.radius == pytest.approx(expected.radius, rel=1e-9)


def wave(x, y, z):
    """A periodic structure, period 2 pi."""
    return 1.0 + 0.4 * np.cos(x) * np.exp(-2.0 * z) + 0.2 * np.sin(2.0 * x) * np.exp(-z), 0.5


@pytest.mark.slow
@pytest.mark.parametrize("given", [{"depth": 0.05}, {"force": 0.3}])
def test_lateral_force_is_conservative(given):
    """-dU/dx at constant depth, from the stored energy of the two neighbours, must have the same mean: zero."""
    # the lowest orders of the rule: whatever E_eff is, its force must be conservative
    body = lateral.Field(wave, 0.5, tolerance=0.1)
    indenter, x = mdr.Paraboloid(10.0), np.arange(12) * 2.0 * np.pi / 12
    moved = lateral.slide(body, indenter, x, periodic=True, points=8, **given)
    assert abs(moved.lateral_force.mean()) < 1e-12 * np.abs(moved.lateral_force).max()
    step, direct = 0.02, []
    radii = np.geomspace(1e-3, 1.1 * moved.radius.max(), 8)
    for place, depth in zip(x, moved.depth, strict=True):
        energies = [
            lateral.sliding.elastic_energy(mdr.Contact(indenter, mdr.TabulatedMedium(radii, body.modulus(at, 0.0, radii))), depth)
            for at in (place - step, place + step)
        ]
        direct.append((energies[0] - energies[1]) / (2.0 * step))
    direct = np.array(direct)
    assert np.abs(direct - moved.lateral_force).max() < 0.05 * np.abs(direct).max()
    assert abs(direct.mean()) < 0.01 * np.abs(direct).max()


def test_open_line_gives_back_the_difference_of_energies():
    body = lateral.Shapes(RUBBER, [lateral.HalfSpace((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), STIFF_RUBBER)])
    x = np.linspace(-3e-3, 3e-3, 31)
    moved = lateral.slide(body, mdr.Sphere(10e-3), x, depth=1e-4, points=12)
    assert np.all(moved.lateral_force < 0.0)  # pushed back to the softer side
    assert trapezoid(moved.lateral_force, x) == pytest.approx(moved.energy[0] - moved.energy[-1], rel=2e-3)
    assert moved.force[15] == pytest.approx(0.5 * (moved.force[0] + moved.force[-1]), rel=1e-3)


def test_bad_input_is_refused():
    labels = np.zeros((2, 3, 4), int)
    for wrong, word in (
        (lambda: lateral.Voxels(labels + 1, [MATRIX], 1e-6), "labels from 1 to 1"),
        (lambda: lateral.Voxels(labels, [MATRIX], -1e-6), "spacing"),
        (lambda: lateral.Voxels(labels, [MATRIX], [1e-6, 1e-6]), "spacing"),
        (lambda: lateral.density([0.1, 0.2], [0.1, 0.2, 0.3]), r"do not broadcast: rho \(2,\), z \(3,\)"),
        (lambda: lateral.Voxels(labels, [MATRIX], 1e-6, images=0), "images"),
        (lambda: lateral.Voxels(labels, [MATRIX], 1e-6, beside=MATRIX, images=2), "images = 2: .* no periods"),
        (lambda: lateral.Voxels(labels, [], 1e-6), "phases"),
        (lambda: lateral.Voxels(labels, [MATRIX], 1e-6, reference_nu=0.6), "reference_nu"),
        (lambda: lateral.Voxels(labels[0], [MATRIX], 1e-6), "nz, ny, nx"),
        (lambda: lateral.Voxels(labels, [3e9], 1e-6), "material"),
        (lambda: lateral.Shapes(MATRIX, [3]), "shape"),
        (lambda: lateral.Shapes(MATRIX, [lateral.Ball((0, 0), 1.0, GLASS)]), "coordinate"),
        (lambda: lateral.Shapes(MATRIX, [lateral.Ball((0, 0, 0), -1.0, GLASS)]), "radius"),
        (lambda: lateral.Shapes(MATRIX, [BALL]).modulus(0.0, 0.0, -1.0), "a = -1"),
        (lambda: lateral.Field(wave, 0.5, tolerance=0.0), "tolerance"),
        (lambda: lateral.Field(wave, 0.5, exponent=1.5), "exponent = 1.5"),
        (lambda: lateral.Shapes(MATRIX, exponent=-2.0), "exponent = -2.0"),
        (lambda: lateral.Voxels(labels, [MATRIX], 1e-6, exponent=np.nan), "exponent = nan"),
        (lambda: lateral.Field(lambda x, y, z: (-1.0, 0.3), 0.3).modulus(0.0, 0.0, 1.0), "E > 0"),
        (lambda: lateral.effective_map(composite(), [0.0]), "contact radii"),
        (lambda: lateral.effective_map(composite(), 1e-6, threads=-1), "threads"),
        (lambda: lateral.tiled_map(composite(), 1e-6, tile=0, halo=1), "tile"),
        (lambda: lateral.LateralMedium(composite(), 0.0, 0.0, 1e-6, 1e-7), "smallest"),
        (lambda: lateral.slide(composite(), mdr.Sphere(1e-5), [0, 1e-6, 2e-6, 3e-6]), "one of depth and force"),
        (lambda: lateral.indentation_map(composite(), mdr.Sphere(1e-5), -1e-9), "depth"),
        (lambda: lateral.cell_weights(1.0, [0.0], [0.0, 1.0], 0.0, 1.0), "2 lines"),
    ):
        with pytest.raises(mdr.MDRError, match=word):
            wrong()


MAP = """
title = "Two phases"
[structure]
labels = "labels.npy"
spacing = ["1 um", "1 um", "1 um"]
[[structure.phase]]
E = "3 GPa"
nu = 0.35
[[structure.phase]]
E = "70 GPa"
nu = 0.22
[map]
radii = ["1 um", "3 um"]
"""


def test_command_map(tmp_path, capsys):
    from mdrcontact.cli import main

    labels = np.random.default_rng(3).integers(0, 2, (4, 10, 12))
    np.save(tmp_path / "labels.npy", labels)
    problem, maps, plot = tmp_path / "map.toml", tmp_path / "maps.npy", tmp_path / "map.png"
    problem.write_text(MAP, encoding="utf-8")
    assert main(["map", str(problem), "--npy", str(maps), "--plot", str(plot)]) == 0
    out = capsys.readouterr().out
    assert "MiB" in out
    voxels = lateral.Voxels(labels, [MATRIX, GLASS], 1e-6, below=MATRIX)
    bounds = [lateral.effective_map(voxels.replace(exponent=p), [1e-6, 3e-6]) for p in (-1.0, 1.0)]
    statistics = [np.array([values.min((1, 2)), values.mean((1, 2)), values.max((1, 2))]).T for values in bounds]
    for line, words, rows in zip(out.splitlines()[4:6], ("in series (lower", "in parallel (upper"), statistics, strict=True):
        assert line.startswith("1 ") and words in line
        assert [float(word) * 1e9 for word in line.split()[-3:]] == pytest.approx(rows[0], rel=1e-4)
    apart = re.search(r"lies between the bounds: here the upper is up to (\S+) times the lower", out)
    assert apart and float(apart[1]) == pytest.approx((statistics[1] / statistics[0]).max(), rel=1e-3)
    np.testing.assert_allclose(np.load(maps), lateral.effective_map(voxels, [1e-6, 3e-6]), rtol=1e-9)
    assert plot.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n" and plot.stat().st_size > 20_000
    assert main(["map", str(problem), "--npy", str(maps)]) == 1
    assert "exists" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ("labels.npy", "other.npy", "other.npy"),
        ('"1 um", "3 um"', '"1 um", "-3 um"', "greater than 0"),
        ('"3 GPa"', "3", "has no unit"),
        ("nu = 0.22", "nu = 0.9", "0.9"),
        ("labels.npy", "empty.npy", "empty.npy"),
        ("labels.npy", "archive.npy", "archive.npy"),
        ("[map]\n", f"x = {'[' * 3000}\n[map]\n", "nested too deeply"),
        ("[map]\n", "[map]\nradius = 1\n", "unknown key"),
        ("[structure]", "[structures]", "structures"),
        ('spacing = ["1 um", "1 um", "1 um"]', 'spacing = ["1 um", "0 um", "1 um"]', "spacing"),
    ],
)
def test_command_map_says_what_is_wrong(tmp_path, capsys, old, new, word):
    from mdrcontact.cli import main

    np.save(tmp_path / "labels.npy", np.ones((2, 3, 4), int))
    (tmp_path / "empty.npy").write_bytes(b"")
    (tmp_path / "archive.npy").write_bytes(b"PK\3\4 of nothing")
    assert old in MAP
    (tmp_path / "map.toml").write_text(MAP.replace(old, new), encoding="utf-8")
    assert main(["map", str(tmp_path / "map.toml")]) == 2
    error = capsys.readouterr().err
    assert word in error and "map.toml" in error


def test_memory_limit_of_the_command(tmp_path, capsys):
    from mdrcontact.cli import main

    np.save(tmp_path / "labels.npy", np.ones((2, 3, 4), int))
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    assert main(["map", str(tmp_path / "map.toml"), "--memory", "1e-6"]) == 1
    assert "memory_limit" in capsys.readouterr().err


def test_without_scipy_the_words_say_what_to_install(monkeypatch):
    matrix, glass = mdr.Elastic(3e9, 0.35), mdr.Elastic(6e9, 0.3)
    voxels = lateral.Voxels(np.eye(4, dtype=int)[None], [matrix, glass], spacing=1e-6)
    padded = lateral.Voxels(np.eye(4, dtype=int)[None], [matrix, glass], spacing=1e-6, beside=matrix)
    monkeypatch.setitem(sys.modules, "scipy", None)
    for call in (
        lambda: lateral.effective_map(voxels, [1e-6]),
        lambda: lateral.effective_map(padded, [1e-6]),
        lambda: lateral.slide(voxels, mdr.Sphere(1e-5), np.linspace(0.0, 1e-6, 5), depth=1e-9),
    ):
        with pytest.raises(mdr.MDRError, match=r"mdrcontact\[map\]"):
            call()


def test_voxels_beside_their_faces_are_those_at_them():
    """A place that rounding puts next to a face, by 1e-17 or by 1e-6 of the contact radius, sees what the face sees."""
    labels = np.random.default_rng(1).integers(0, 2, (4, 6, 6))
    voxels = lateral.Voxels(labels, [mdr.Elastic(1.0, 0.3), mdr.Elastic(5.0, 0.2)], spacing=1.0)
    for x, y in ((3.0, 4.0), (3.5, 4.0), (3.0, 3.3)):
        for a in (0.4, 1e-3):
            there = voxels.modulus(x, y, a)
            for step in (4.4e-16, 1e-13, 1e-10, 1e-8):
                for way in (1.0, -1.0):
                    beside = voxels.modulus(x + way * step, y + 0.7 * way * step, a)
                    # on the other side of a face the images that are summed are others
                    assert beside == pytest.approx(there, rel=2e-4)
