# SPDX-License-Identifier: GPL-3.0-or-later
"""Layered bodies in ContactMechanics, Adhesion and tamaas: own kernels at equal halves, exact contacts, what does not work."""

import csv
import gc
import importlib
import math
import sys
import warnings
from functools import cache

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact.interop._grid import lattice_constant

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")
E, NU = 1.0, 0.3
BASE = mdr.Elastic(E, NU)
HALF_SPACE = mdr.Homogeneous(BASE)
HALVES = mdr.Coated(BASE, 0.7, BASE)
FILM = mdr.Coated(mdr.Elastic(0.1, NU), 1.0, BASE)
STIFF = mdr.Coated(mdr.Elastic(10.0, NU), 1.0, BASE)
BONDED = mdr.Layered([(BASE, 1.0)], mdr.RIGID)


def engine(name):
    """An engine, or a skipped test."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip(name, reason=f"{name} is not installed: the extra bem")


@pytest.fixture
def contact_mechanics():
    engine("ContactMechanics")
    return importlib.import_module("mdrcontact.interop.contactmechanics")


@pytest.fixture
def tamaas():
    engine("tamaas").set_log_level(engine("tamaas").LogLevel.error)
    return importlib.import_module("mdrcontact.interop.tamaas")


def hard(substrate, topography):
    """A contact without adhesion; `make_contact_system` of a topography is another function once Adhesion is imported."""
    return importlib.import_module("ContactMechanics.Systems").NonSmoothContactSystem(substrate, topography)


def largest(found, expected):
    """Difference over the largest entry."""
    return np.max(np.abs(found - expected)) / np.max(np.abs(expected))


@pytest.mark.parametrize("name", ["ContactMechanics", "tamaas"])
def test_without_the_engine_the_extra_is_named(name, monkeypatch):
    monkeypatch.setitem(sys.modules, name, None)
    adapter = f"mdrcontact.interop.{name.lower()}"
    monkeypatch.delitem(sys.modules, adapter, raising=False)
    with pytest.raises(mdr.MDRError, match=rf'{adapter} needs {name}. Install it with pip install "mdrcontact\[bem\]"'):
        importlib.import_module(adapter)


def test_the_constant_of_a_lattice():
    """3.900264920 of a square; a cell divided in four has half the size; the sums converge from a Gaussian window also."""
    assert lattice_constant((1.0, 1.0)) == pytest.approx(3.900264920, abs=1e-9)
    assert lattice_constant((3.0, 5.0)) == pytest.approx(lattice_constant((0.6, 1.0)) / 5.0, rel=1e-13)
    x, y, width = np.arange(-400, 401) * 1.0, np.arange(-250, 251) * 1.6, 60.0
    d = np.hypot(x[:, None], y).ravel()
    d = d[d > 0.0]
    window = np.sum(np.exp(-((d / width) ** 2)) / d) - 2.0 * math.pi / 1.6 * width * math.sqrt(math.pi) / 2.0
    assert lattice_constant((1.0, 1.6)) == pytest.approx(-window, abs=2e-5 * 60.0 / width + 1e-3)


@pytest.mark.parametrize("body", [HALF_SPACE, HALVES], ids=["homogeneous", "halves"])
def test_equal_halves_are_the_own_kernels_of_contactmechanics(contact_mechanics, body):
    own, modulus = engine("ContactMechanics"), E / (1.0 - NU**2)
    for points, sizes in (((24, 18), (2.0, 1.5)), ((15, 13), (2.0, 1.5)), ((24,), (2.0,))):
        found = contact_mechanics.LayeredSubstrate(body, points, sizes).greens_function
        expected = own.PeriodicFFTElasticHalfSpace(points, modulus, sizes, stiffness_q0=1.0).greens_function
        assert largest(found.ravel()[1:], expected.ravel()[1:]) < 1e-14
        assert found.ravel()[0] == pytest.approx(0.0, abs=1e-14)
    found = contact_mechanics.FreeLayeredSubstrate(body, (24, 18), (2.0, 1.5))
    expected = own.FreeFFTElasticHalfSpace((24, 18), modulus, (2.0, 1.5))
    assert largest(found.greens_function, expected.greens_function) < 1e-12
    assert largest(found.surface_stiffness, expected.surface_stiffness) < 1e-11


def test_a_bonded_layer_is_that_of_contactmechanics(contact_mechanics):
    """Carbone and Mangialardi's compliance, with the mean of the cell."""
    expected = engine("ContactMechanics").PeriodicFFTElasticHalfSpace((24, 18), E, (4.0, 3.0), thickness=1.0, poisson=NU)
    found = contact_mechanics.LayeredSubstrate(BONDED, (24, 18), (4.0, 3.0))
    assert largest(found.greens_function, expected.greens_function) < 1e-14
    isolated = contact_mechanics.LayeredSubstrate(BONDED, (24, 18), (4.0, 3.0), mean="isolated")
    assert np.array_equal(isolated.greens_function, found.greens_function)


@pytest.mark.parametrize(("body", "expected"), [(HALF_SPACE, 9.038068187), (STIFF, 5.695211322)], ids=["equal", "film_10"])
def test_the_mean_of_isolated_contacts(contact_mechanics, body, expected):
    """Rows "mean" of engine_contacts.csv."""
    found = contact_mechanics.LayeredSubstrate(body, (8, 8), 8.0, mean="isolated").greens_function[0, 0]
    assert found == pytest.approx(expected, rel=1e-7)
    assert contact_mechanics.LayeredSubstrate(body, (8, 8), 8.0, mean=0.25).greens_function[0, 0] == 0.25


BODIES = {
    "film_0.01": mdr.Coated(mdr.Elastic(0.01, NU), 1.0, BASE),
    "film_0.1": FILM,
    "film_10": STIFF,
    "film_100": mdr.Coated(mdr.Elastic(100.0, NU), 1.0, BASE),
    "rigid_nu0.3": BONDED,
    "rigid_nu0.49": mdr.Layered([(mdr.Elastic(E, 0.49), 1.0)], mdr.RIGID),
    "graded_4to1": mdr.Graded([0.0, 1.0], [4.0, 1.0], NU),
    "sliding_10": mdr.Layered([mdr.Layer(mdr.Elastic(10.0, NU), 1.0, interface=mdr.SLIDING)], BASE),
}
SIZE = 2.6
"""Of a square grid around a contact of radius 1."""


@cache
def forces():
    """Rows "force" of engine_contacts.csv: body, shape, contact radius, depth, force."""
    with (ROOT / "tests" / "data" / "engine_contacts.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    found = {}
    for row in rows:
        if row["kind"] == "force" and row["body"] in BODIES:
            shape, _, rest = row["inputs"].partition(" ")
            depth, radius = float(rest.split("depth=")[1].split()[0]), float(rest.split("a/h=")[1].rstrip(")"))
            found[f"{row['body']} {shape} {radius:g}"] = (row["body"], shape, radius, depth, float(row["value"]))
    return found


def heights(shape, radius, points, size):
    """Of a paraboloid or cone whose axis is at the middle pixel of a grid."""
    x = (np.arange(points) - points // 2) * size / points
    r = np.hypot(x[:, None], x)
    return -0.5 * r**2 if shape == "paraboloid" else -math.tan(1.0) * r


def pressed(adapter, case, points):
    """The error of the force at a depth, relative, by ContactMechanics."""
    name, shape, radius, depth, force = forces()[case]
    size = SIZE * radius
    topography = engine("SurfaceTopography").Topography(heights(shape, radius, points, size), (size, size))
    substrate = adapter.FreeLayeredSubstrate(BODIES[name], (points, points), size)
    system = hard(substrate, topography)
    guess = substrate.first_guess(topography, depth)
    result = system.minimize_proxy(offset=depth, initial_forces=guess, pentol=1e-7 * depth, maxiter=1000)
    assert result.success
    return system.compute_normal_force() / force - 1.0


QUICK = ["film_10 paraboloid 1", "film_0.1 paraboloid 0.1", "rigid_nu0.3 paraboloid 1", "sliding_10 paraboloid 1"]
GRID = {32: 1.2e-3, 64: 2e-4}
"""Largest errors of the force by the points along a side, docs/rough.md."""
INCOMPRESSIBLE = {32: 3.3e-3, 64: 3e-4}
"""On an almost incompressible layer, a/h = 10."""


@pytest.mark.parametrize("case", QUICK)
def test_exact_contacts_on_a_coarse_grid(contact_mechanics, case):
    assert abs(pressed(contact_mechanics, case, 32)) < GRID[32]


@pytest.mark.slow
@pytest.mark.parametrize("case", sorted(forces()))
def test_exact_contacts_converge(contact_mechanics, case):
    """Rows "force" of engine_contacts.csv: the error of the grid, and the order over two halvings of the pixel, at least 1.7."""
    coarse, fine = (abs(pressed(contact_mechanics, case, points)) for points in (32, 64))
    bounds = INCOMPRESSIBLE if "rigid_nu0.49" in case else GRID
    assert coarse < bounds[32] and fine < bounds[64]


@pytest.mark.slow
@pytest.mark.parametrize("case", QUICK)
def test_the_order_of_convergence(contact_mechanics, case):
    coarse, fine = (abs(pressed(contact_mechanics, case, points)) for points in (32, 128))
    assert math.log(coarse / fine) / math.log(4.0) > 1.7


@pytest.mark.slow
def test_a_cell_with_the_mean_of_isolated_contacts(contact_mechanics):
    """The depth under a force is that of one contact, to the third power of contact radius over cell."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE)
    state = contact.at_radius(1.0)
    errors = []
    for cell, points in ((3.0, 96), (6.0, 192)):
        topography = engine("SurfaceTopography").Topography(heights("paraboloid", 1.0, points, cell), (cell, cell), periodic=True)
        substrate = contact_mechanics.LayeredSubstrate(HALF_SPACE, (points, points), cell, mean="isolated")
        guess = substrate.first_guess(topography, 0.5 * state.depth)
        system = hard(substrate, topography)
        result = system.minimize_proxy(external_force=state.force, initial_forces=guess, pentol=1e-7)
        errors.append(result.offset / state.depth - 1.0)
    assert abs(errors[1]) < 6e-3 and 2.7 < math.log2(errors[0] / errors[1]) < 3.3


def test_forces_that_the_solver_did_not_change_raise(contact_mechanics):
    """Where C(0) = 0, the engine reports success after one iteration, with depth 0."""
    layer = mdr.Layered([(mdr.Elastic(E, 0.5), 1.0)], mdr.RIGID)
    topography = engine("SurfaceTopography").Topography(heights("paraboloid", 1.0, 32, 8.0), (8.0, 8.0), periodic=True)
    substrate = contact_mechanics.LayeredSubstrate(layer, (32, 32), 8.0)
    system = hard(substrate, topography)
    with pytest.raises(mdr.errors.NoConvergenceError, match="initial_forces=substrate.first_guess"):
        system.minimize_proxy(external_force=1.0)
    result = system.minimize_proxy(external_force=1.0, initial_forces=substrate.first_guess(topography, 0.1))
    assert result.offset == pytest.approx(mdr.Contact(mdr.Paraboloid(1.0), layer).at_force(1.0).depth, rel=0.01)


def test_a_first_guess_needs_an_overlap(contact_mechanics):
    topography = engine("SurfaceTopography").Topography(heights("paraboloid", 1.0, 16, 2.0), (2.0, 2.0))
    substrate = contact_mechanics.FreeLayeredSubstrate(FILM, (16, 16), 2.0)
    for offset in (0.0, -0.1, math.nan, math.inf):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="the surfaces do not overlap"):
            substrate.first_guess(topography, offset)


def test_a_contact_that_leaves_the_grid_raises(contact_mechanics):
    topography = engine("SurfaceTopography").Topography(heights("paraboloid", 1.0, 16, 1.0), (1.0, 1.0))
    for check, offset in ((True, 1.0), (False, 1.0), (True, 0.02)):
        substrate = contact_mechanics.FreeLayeredSubstrate(FILM, (16, 16), 1.0, check_boundaries=check)
        system = hard(substrate, topography)
        guess = substrate.first_guess(topography, offset)
        if check and offset == 1.0:
            with pytest.raises(substrate.FreeBoundaryError):
                system.minimize_proxy(offset=offset, initial_forces=guess)
        else:
            assert system.minimize_proxy(offset=offset, initial_forces=guess).success


def test_parts_of_a_grid_are_the_parts_of_the_whole(contact_mechanics):
    """Each process of MPI computes its waves and pixels, bitwise those of one process."""

    class Part(contact_mechanics.LayeredSubstrate):
        fourier_locations, nb_fourier_grid_pts = (0, 5), (13, 7)

    class FreePart(contact_mechanics.FreeLayeredSubstrate):
        subdomain_locations, nb_subdomain_grid_pts = (0, 11), (48, 9)

    whole = contact_mechanics.LayeredSubstrate(STIFF, (24, 18), (2.0, 1.5), mean=0.0)
    part = contact_mechanics.LayeredSubstrate(STIFF, (24, 18), (2.0, 1.5), mean=0.0)
    part.__class__ = Part
    assert np.array_equal(part._compute_greens_function(), whole.greens_function[:, 5:12])
    free = contact_mechanics.FreeLayeredSubstrate(STIFF, (24, 18), (2.0, 1.5))
    whole = free._pixels()
    free.__class__ = FreePart
    assert np.array_equal(free._pixels(), whole[:, 11:20])


def test_parts_of_a_graded_body_agree(contact_mechanics):
    """Of many wavenumbers the library makes a table, of few it does not."""
    body = BODIES["graded_4to1"]

    class Part(contact_mechanics.LayeredSubstrate):
        fourier_locations, nb_fourier_grid_pts = (0, 20), (65, 4)

    whole, part = (contact_mechanics.LayeredSubstrate(body, (128, 128), 20.0, mean=0.0) for _ in range(2))
    part.__class__ = Part
    np.testing.assert_allclose(part._compute_greens_function(), whole.greens_function[:, 20:24], 1e-11)


def test_relaxing_bodies(contact_mechanics, tamaas):
    """Relaxed, and immediately, they are elastic; at frequencies between, no energy has a minimum."""
    rubber = mdr.Viscoelastic(1.0, [(2.0, 0.1)], nu=0.5)
    body, layered = mdr.Homogeneous(rubber), contact_mechanics.LayeredSubstrate
    for omega, G in ((0.0, 1.0), (1e300, 3.0)):
        found = layered(body, (8, 8), 1.0, omega=omega).greens_function
        elastic = mdr.Homogeneous(mdr.Elastic(3.0 * G, 0.5))
        np.testing.assert_allclose(found, layered(elastic, (8, 8), 1.0).greens_function, 1e-12)
    relaxed = contact_mechanics.FreeLayeredSubstrate(body, (8, 8), 1.0, omega=0.0).greens_function
    elastic = contact_mechanics.FreeLayeredSubstrate(mdr.Homogeneous(mdr.Elastic(3.0, 0.5)), (8, 8), 1.0).greens_function
    np.testing.assert_allclose(relaxed, elastic, 1e-12)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="omega = 3.0: the compliance is complex"):
        layered(body, (8, 8), 1.0, omega=3.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="omega = 1e\\+300: one contact is known on the relaxed body"):
        contact_mechanics.FreeLayeredSubstrate(body, (8, 8), 1.0, omega=1e300)
    gel = mdr.Homogeneous(mdr.poroelastic.Poroelastic(2.0, 0.2, 3.0))
    drained = mdr.Homogeneous(mdr.Elastic(4.8, 0.2))
    found = layered(gel, (8, 8), 1.0, mean=0.1, omega=0.0, drainage="surface").greens_function
    np.testing.assert_allclose(found, layered(drained, (8, 8), 1.0, mean=0.1).greens_function, 1e-9)


@pytest.mark.parametrize(
    ("body", "given", "words"),
    [
        (BASE, {}, "it must be a medium"),
        (STIFF, {}, r"mean = 'layers': C\(0\) = -3.34286 must be finite and at least 0, and layers that are stiffer"),
        (HALF_SPACE, {"mean": -1.0}, r"mean = -1.0: C\(0\) = -1"),
        (HALF_SPACE, {"mean": math.nan}, "mean = nan"),
        (HALF_SPACE, {"mean": "isolate"}, "did you mean 'isolated'"),
        (HALF_SPACE, {"mean": None}, "mean = None: it must be a real number"),
        (HALF_SPACE, {"nb_grid_pts": 8, "mean": "isolated"}, "line contact without neighbours is infinite"),
        (HALF_SPACE, {"nb_grid_pts": (8, 8, 8)}, "one of one or two directions|each of one or two directions"),
        (HALF_SPACE, {"nb_grid_pts": (8, 1)}, "it must be a whole number, at least 2"),
        (HALF_SPACE, {"nb_grid_pts": (8, 8.0)}, "it must be a whole number"),
        (HALF_SPACE, {"physical_sizes": (1.0, -1.0)}, "each must be finite and greater than 0"),
        (HALF_SPACE, {"physical_sizes": (1.0, math.nan)}, "each must be finite and greater than 0"),
        (HALF_SPACE, {"omega": 0.0}, "this body does not relax. Omit omega"),
        (mdr.Homogeneous(mdr.Viscoelastic(1.0, [(2.0, 0.1)], nu=0.5)), {}, "this body relaxes. Set omega=0"),
        (mdr.TabulatedMedium([0.1, 0.5, 1.0], [1.0, 1.5, 2.0]), {}, "only an effective modulus"),
    ],
)
def test_bad_input_raises(contact_mechanics, body, given, words):
    with pytest.raises(mdr.MDRError, match=words):
        contact_mechanics.LayeredSubstrate(**{"body": body, "nb_grid_pts": (8, 8), "physical_sizes": 8.0} | given)


def test_line_contacts_need_periodic_substrates(contact_mechanics):
    with pytest.raises(mdr.errors.InvalidArgumentError, match="Use LayeredSubstrate for line contacts"):
        contact_mechanics.FreeLayeredSubstrate(FILM, 8, 1.0)


def model_of(tamaas, kind, points, sizes, nu=NU):
    """A model of tamaas with E = 1."""
    own = engine("tamaas")
    model = own.Model(getattr(own.model_type, kind), list(sizes), list(points))
    model.E, model.nu = E, nu
    return model


OWN = "Westergaard::neumann"


@pytest.mark.parametrize("body", [HALF_SPACE, HALVES], ids=["homogeneous", "halves"])
def test_equal_halves_are_the_own_kernels_of_tamaas(tamaas, body):
    """With even numbers of points; the wave of an odd one is another in tamaas (examples/clients/upstream)."""
    for kind, points, sizes in (("1d", (16,), (2.0,)), ("2d", (16, 12), (2.0, 1.5))):
        for family in ("basic", "surface"):
            own, model = (model_of(tamaas, f"{family}_{kind}", points, sizes) for _ in range(2))
            own.solveNeumann()
            if family == "basic":
                found = tamaas.layered_operator(model, body, periodic=True)["influence"]
            else:
                tamaas.set_layered(model, body)
                found = model.operators[OWN]["influence"]
            assert largest(np.array(found), np.array(own.operators[OWN]["influence"])) < 1e-14
    own, model = (model_of(tamaas, "basic_2d", (16, 12), (2.0, 1.5)) for _ in range(2))
    engine("tamaas").ModelFactory.registerNonPeriodic(own, "own")
    found = np.array(tamaas.layered_operator(model, body)["influence"])
    assert largest(found, np.array(own.operators["own"]["influence"])) < 1e-12


def test_the_coupling_of_equal_bodies_cancels(tamaas):
    """Friction between equal bodies does not change their pressure; the other terms double."""
    one, two = (model_of(tamaas, "surface_2d", (8, 8), (2.0, 2.0)) for _ in range(2))
    tamaas.set_layered(one, FILM, mean=0.0)
    tamaas.set_layered(two, mdr.Pair(FILM, FILM), mean=0.0)
    one, two = (np.array(model.operators[OWN]["influence"]) for model in (one, two))
    mixed = [2, 5, 6, 7]
    assert np.max(np.abs(one[..., mixed])) > 0.1 and not np.any(two[..., mixed])
    np.testing.assert_allclose(np.delete(two, mixed, axis=-1), 2.0 * np.delete(one, mixed, axis=-1), 1e-14)


def test_operators_live_as_long_as_the_model(tamaas):
    """Two of them, under names of their own, and a solver that registers those of tamaas again."""
    model = model_of(tamaas, "basic_2d", (16, 16), (4.0, 4.0))
    tamaas.layered_operator(model, BONDED, "bonded", periodic=True)
    tamaas.layered_operator(model, FILM, "film", periodic=True)
    tamaas.layered_operator(model, FILM, "free")
    gc.collect()
    before = {name: np.array(model.operators[name]["influence"]) for name in ("bonded", "film", "free")}
    solver = engine("tamaas").PolonskyKeerRey(model, heights("paraboloid", 1.0, 16, 4.0), 1e-10)
    for name, influence in before.items():
        solver.setIntegralOperator(name)
        solver.solve(0.01)
        assert np.array_equal(influence, model.operators[name]["influence"])
        assert model.operators[name].kind == engine("tamaas").IntegralOperator.neumann
    assert not np.array_equal(before["film"], before["bonded"])


@pytest.mark.parametrize("case", ["film_10 paraboloid 1", "film_0.1 paraboloid 0.1"])
def test_exact_contacts_by_tamaas(tamaas, case):
    """The depth under a force; its error is that of the force over the exponent of the contact."""
    name, shape, radius, depth, force = forces()[case]
    size, points = SIZE * radius, 32
    model = model_of(tamaas, "basic_2d", (points, points), (size, size))
    operator = tamaas.layered_operator(model, BODIES[name])
    surface = heights(shape, radius, points, size)
    solver = engine("tamaas").PolonskyKeerRey(model, surface, 1e-10)
    solver.setIntegralOperator("layered")
    solver.solve(force / size**2)
    displacement = np.zeros_like(surface)
    operator(np.array(model.traction), displacement)
    found = np.mean((displacement - surface)[np.array(model.traction) > 0.0])
    assert abs(found / depth - 1.0) < GRID[32]


def test_other_models_of_tamaas_raise(tamaas):
    basic, surface, line = (model_of(tamaas, kind, (8, 8)[: 2 - i // 2], (1.0, 1.0)[: 2 - i // 2]) for i, kind in enumerate(
        ("basic_2d", "surface_2d", "basic_1d")))  # fmt: skip
    for call, words in (
        (lambda: tamaas.set_layered(basic, FILM), "model = basic_2d: its type must be surface_1d or surface_2d"),
        (lambda: tamaas.layered_operator(surface, FILM), "model = surface_2d: its type must be basic_2d. .*set_layered"),
        (lambda: tamaas.layered_operator(line, FILM), "model = basic_1d: its type must be basic_2d"),
        (lambda: tamaas.layered_operator("model", FILM), "it must be a tamaas.Model"),
        (lambda: tamaas.layered_operator(basic, FILM, mean="isolated"), "Omit it or set periodic=True"),
        (lambda: tamaas.layered_operator(basic, STIFF, periodic=True), "must be finite and at least 0"),
    ):
        with pytest.raises(mdr.MDRError, match=words):
            call()


@pytest.mark.slow
def test_adhesion_by_a_potential(contact_mechanics):
    """Retraction from a soft film: Maugis' states of equal work and largest tension, to 2 % of pull-off."""
    for name in ("Adhesion.System", "Adhesion.Interactions", "SurfaceTopography"):
        engine(name)
    from Adhesion.Interactions import PowerLaw
    from Adhesion.System import BoundedSmoothContactSystem
    from SurfaceTopography import Topography

    work, reach, points, size = 0.01, 0.18, 64, 3.0
    contact = mdr.Contact(mdr.Paraboloid(1.0), FILM, work_of_adhesion=work, cohesive_stress=3.0 * work / reach)
    topography = Topography(heights("paraboloid", 1.0, points, size), (size, size))
    substrate = contact_mechanics.FreeLayeredSubstrate(FILM, (points, points), size, check_boundaries=False)
    system = BoundedSmoothContactSystem(substrate, PowerLaw(work, reach), topography)
    displacements, options = None, {"gtol": 3e-8, "ftol": 1e-20, "maxcor": 10, "maxiter": 3000}
    for depth in (0.3, 0.1, 0.0, -0.1):
        found = system.minimize_proxy(offset=depth, initial_displacements=displacements, lbounds="auto", options=options)
        assert found.success
        displacements = found.x
        error = system.compute_normal_force() - contact.at_depth(depth).force
        assert abs(error) < 0.02 * 1.5 * math.pi * work


def sheared(tamaas, nu, share, coupled):
    """A ball on a layer on a rigid base under a share of the sliding force, by tamaas."""
    own = engine("tamaas")
    layer = mdr.Layered([(mdr.Elastic(E, nu), 0.5)], mdr.RIGID)
    contact, points, size = mdr.Contact(mdr.Paraboloid(1.0), layer), 64, 4.0
    state = contact.at_radius(1.0)
    model = model_of(tamaas, "surface_2d", (points, points), (size, size), nu)
    tamaas.set_layered(model, layer)
    if not coupled:
        model.operators[OWN]["influence"][..., [2, 5, 6, 7]] = 0.0
    solver = own.PolonskyKeerTan(model, heights("paraboloid", 1.0, points, size), 1e-8, 0.3)
    solver.max_iter = 500
    force = share * 0.3 * state.force
    solver.solve([force / size**2, 0.0, state.force / size**2])
    traction, displacement = np.array(model.traction), np.zeros((points, points, 3))
    model.operators[OWN](traction, displacement)
    x = (np.arange(points) - points // 2) * size / points
    return traction, displacement, np.hypot(x[:, None], x), mdr.Friction(contact, 0.3).shear(state), force


@pytest.mark.slow
@pytest.mark.parametrize(
    ("nu", "coupled", "low", "high"),
    [(0.0, False, -1e-3, 1e-3), (-0.3, False, -1e-3, 1e-3), (0.3, False, 0.0, 2.5e-3), (0.3, True, 2.5e-3, 2e-2)],
)
def test_partial_slip_by_tamaas(tamaas, nu, coupled, low, high):
    """T at the shift of the stick zone. `Friction` neglects cos 2 phi, up to 0.25 %, and the coupling, some per cent."""
    traction, displacement, r, friction, force = sheared(tamaas, nu, 0.5, coupled)
    shift = displacement[r < 0.4][:, 0]
    assert np.ptp(shift) < 1e-4 * np.mean(shift) and np.max(np.abs(displacement[r < 0.4][:, 1])) < 1e-4 * np.mean(shift)
    assert low < friction.at_shift(float(np.mean(shift))).tangential_force / force - 1.0 < high
    slips = np.hypot(traction[..., 0], traction[..., 1]) > (0.3 - 1e-3) * traction[..., 2]
    touches = traction[..., 2] > 1e-6 * np.max(traction)
    stick = math.sqrt(np.count_nonzero(touches & ~slips) / math.pi) * 4.0 / 64
    assert stick == pytest.approx(friction.at_force(force).stick_radius, rel=0.015)


@pytest.mark.slow
def test_slip_outside_a_small_stick_zone_by_tamaas(tamaas):
    """At 0.95 of the sliding force of the library the traction is the coefficient times the pressure outside its stick zone."""
    traction, _, r, friction, force = sheared(tamaas, 0.0, 0.95, False)
    assert force == pytest.approx(0.95 * friction.sliding_force)
    assert np.sum(traction[..., 0]) * (4.0 / 64) ** 2 == pytest.approx(force)
    slips = (friction.at_force(force).stick_radius + 0.1 < r) & (r < 0.9)
    assert np.count_nonzero(slips) > 300
    assert np.allclose(np.hypot(traction[slips][:, 0], traction[slips][:, 1]), 0.3 * traction[slips][:, 2], rtol=1e-3)


def test_a_load_that_slides_over_a_relaxing_body(contact_mechanics):
    """One wave of pressure: the displacement lags by the phase of the compliance; forces and displacements are inverse."""
    body, points, size, velocity = mdr.Homogeneous(mdr.Viscoelastic(1.0, [(2.0, 0.1)], nu=0.5)), (32, 8), (2.0, 0.5), 3.0
    substrate = contact_mechanics.LayeredSubstrate(body, points, size, mean=0.2, velocity=velocity)
    k = 2.0 * np.pi * 3 / size[0]
    x = np.arange(points[0])[:, None] * size[0] / points[0] * np.ones(points)
    C = body.compliance(k, omega=k * velocity)
    found = substrate.evaluate_disp(-np.cos(k * x) * substrate.area_per_pt)
    assert C.imag < -0.1 * C.real
    np.testing.assert_allclose(found, abs(C) * np.cos(k * x - np.angle(C)), atol=1e-14)
    np.testing.assert_allclose(substrate.evaluate_force(found), -np.cos(k * x) * substrate.area_per_pt, atol=1e-14)
    back = contact_mechanics.LayeredSubstrate(body, points, size, mean=0.2, velocity=-velocity)
    np.testing.assert_allclose(back.greens_function, substrate.greens_function.conj(), 1e-14)
    line = contact_mechanics.LayeredSubstrate(body, points[0], size[0], mean=0.2, velocity=velocity)
    np.testing.assert_allclose(line.greens_function, substrate.greens_function[:, 0], 1e-14)
    for speed, omega in ((0.0, 0.0), (1e9, 1e300)):
        still = contact_mechanics.LayeredSubstrate(body, points, size, mean=0.2, velocity=speed).greens_function
        expected = contact_mechanics.LayeredSubstrate(body, points, size, mean=0.2, omega=omega).greens_function
        np.testing.assert_allclose(still[1:], expected[1:], 1e-7)
    topography = engine("SurfaceTopography").Topography(heights("paraboloid", 1.0, 16, 2.0), (2.0, 2.0), periodic=True)
    moving = contact_mechanics.LayeredSubstrate(body, (16, 16), 2.0, mean=0.2, velocity=velocity)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="has no energy that a solver could minimize"):
        hard(moving, topography).minimize_proxy(offset=0.1, initial_forces=moving.first_guess(topography, 0.1))
    for given, words in (
        ({"velocity": 1.0, "omega": 0.0}, "Omit omega"),
        ({"velocity": math.nan}, "it must be finite"),
        ({"velocity": 1.0, "body": HALF_SPACE}, "does not relax. Omit velocity"),
    ):
        with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
            contact_mechanics.LayeredSubstrate(**{"body": body, "nb_grid_pts": 8, "physical_sizes": 1.0, "mean": 0.2} | given)
