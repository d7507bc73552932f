# SPDX-License-Identifier: GPL-3.0-or-later
"""Cohesive zones on bodies whose constants vary from the surface down."""

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.cli import main

PARABOLOID = mdr.Paraboloid(1.0)
WORK = 0.1


def graded(ratio, tolerance=1e-8):
    """E from 1 at the surface to `ratio` at depth 1."""
    return mdr.Graded([0.0, 1.0], [1.0, ratio], [0.3, 0.3], model="exact", tolerance=tolerance)


def ranged(tip, medium, stress):
    return mdr.Contact(tip, medium, work_of_adhesion=WORK, cohesive_stress=stress)


@pytest.fixture(scope="module")
def on_graded():
    """One contact for several tests: a second of work."""
    return ranged(PARABOLOID, graded(4.0), 1.0)


def stack(ratio, count):
    """The same in homogeneous layers that thin towards the surface."""
    ends = np.sinh(8.0 * np.arange(count + 1) / count) / np.sinh(8.0)
    layers = [
        (mdr.Elastic(1.0 + (ratio - 1.0) * 0.5 * (top + bottom), 0.3), bottom - top)
        for top, bottom in zip(ends[:-1], ends[1:], strict=True)
    ]
    return mdr.Layered(layers, mdr.Elastic(ratio, 0.3), model="exact")


@pytest.mark.slow
@pytest.mark.parametrize(("ratio", "stress"), [(4.0, 1.0), (4.0, 0.3), (0.3, 1.0)])
def test_layers_that_thin_towards_the_surface(ratio, stress):
    """Their error falls as the square of their number: two stacks give the graded body."""
    whole = ranged(PARABOLOID, graded(ratio), stress)
    stacks = [ranged(PARABOLOID, stack(ratio, count), stress) for count in (60, 120)]
    for radius in (0.1, 0.5, 2.0):
        state = whole.at_radius(radius)
        coarse, fine = (contact.at_radius(radius) for contact in stacks)
        for name in ("depth", "force", "zone_radius"):
            expected = (4.0 * getattr(fine, name) - getattr(coarse, name)) / 3.0
            assert abs(getattr(fine, name) - expected) > 1e-6 * abs(expected)
            assert getattr(state, name) == pytest.approx(expected, rel=3e-6, abs=3e-7)


@pytest.mark.parametrize("stress", [0.2, 2.0])
@pytest.mark.parametrize("tip", [PARABOLOID, mdr.Cone(0.4), mdr.FlatEndedCone(0.01, 0.3)])
def test_nothing_varies(tip, stress):
    """A gradient too small to show, on all the paths of one that does."""
    of_half_space = ranged(tip, mdr.Homogeneous(mdr.Elastic(1.0, 0.3)), stress)
    of_graded = ranged(tip, graded(1.0 + 1e-9), stress)
    for radius in (0.0, 0.02, 0.3, 3.0):
        state, expected = of_graded.at_radius(radius), of_half_space.at_radius(radius)
        assert state.depth == pytest.approx(expected.depth, rel=3e-9, abs=1e-9)
        assert state.force == pytest.approx(expected.force, rel=3e-9)
        assert state.zone_radius == pytest.approx(expected.zone_radius, rel=3e-9)


@pytest.mark.parametrize("tip", [PARABOLOID, mdr.Cone(0.4)])
@pytest.mark.slow
def test_short_range(tip):
    """The limit of no range, as sigma^-2."""
    limit = mdr.Contact(tip, graded(4.0), work_of_adhesion=WORK).at_radius(0.5)
    missed = [ranged(tip, graded(4.0), stress).at_radius(0.5).force - limit.force for stress in (30.0, 60.0)]
    assert missed[0] / missed[1] == pytest.approx(4.0, rel=0.02)
    assert abs(missed[1]) < 1e-3 * abs(limit.force)


@pytest.mark.slow
def test_tolerance_is_met():
    """States by few unknowns against those by many, over random bodies, tips and stresses."""
    random = np.random.default_rng(20)
    for _ in range(4):
        ratio, stress = 10.0 ** random.uniform(-0.7, 1.5), 10.0 ** random.uniform(-0.5, 0.7)
        tip = [PARABOLOID, mdr.Cone(0.4), mdr.PowerLaw(3.0, 1.0)][random.integers(3)]
        loose, tight = (ranged(tip, graded(ratio, tolerance), stress) for tolerance in (1e-8, 1e-9))
        for radius in 10.0 ** random.uniform(-1.2, 0.3, 3):
            state, expected = loose.at_radius(radius), tight.at_radius(radius)
            parts = abs(expected.depth) + abs(expected.punch_depth)
            assert abs(state.depth - expected.depth) < 1e-8 * parts
            assert abs(state.force - expected.force) < 1e-8 * max(expected.stiffness * parts, abs(expected.force))
            assert state.zone_radius - radius == pytest.approx(expected.zone_radius - radius, rel=3e-8)


def test_branch_begins_without_contact(on_graded):
    """Smoothly: noise of 1e-12 in d(a) made a fold of its own at the touch, with a jump of nothing."""
    touch = on_graded.at_radius(0.0)
    soon = on_graded.at_radius(10.0 ** np.arange(-12.0, -2.0))
    assert soon.depth[:4] == pytest.approx(touch.depth, rel=1e-14)
    assert soon.force[:4] == pytest.approx(touch.force, rel=1e-13)
    rise = (soon.depth - touch.depth)[5:] / soon.radius[5:] ** 2
    assert rise[1:] == pytest.approx(rise[-1], rel=0.03)
    assert on_graded.pull_off("depth").others == ()


@pytest.mark.slow
def test_bodies_in_either_order():
    body, other = graded(4.0), mdr.Homogeneous(mdr.Elastic(3.0, 0.3))
    one, two = (ranged(PARABOLOID, mdr.Pair(*bodies), 1.0).at_radius(0.3) for bodies in ((body, other), (other, body)))
    assert one.depth == pytest.approx(two.depth, rel=1e-8)
    assert one.force == pytest.approx(two.force, rel=1e-8)


def test_law_and_pull_off(on_graded):
    law = mdr.ContactLaw(on_graded, 0.3, tolerance=1e-7)
    for depth in (-0.1, 0.02, 0.25):
        assert law.at_depth(depth).force == pytest.approx(on_graded.at_depth(depth).force, abs=2e-7)
    end = on_graded.pull_off("force")
    assert on_graded.at_radius(1.01 * end.radius).force > end.force < on_graded.at_radius(0.99 * end.radius).force


def test_fields_are_refused(on_graded):
    state = on_graded.at_radius(0.3)
    for field in (lambda: state.pressure([0.1]), lambda: state.displacement([0.5]), state.energy):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="not available on a graded body with a cohesive_stress"):
            field()


@pytest.mark.slow
def test_picture_without_pressures(tmp_path, capsys):
    problem, picture = tmp_path / "film.toml", tmp_path / "film.png"
    problem.write_text(
        '[indenter]\nshape = "paraboloid"\nradius = "5 um"\n'
        '[medium]\ntype = "graded"\nz = ["0 um", "2 um"]\nE = ["1 MPa", "5 MPa"]\nnu = 0.45\ntolerance = 1e-8\n'
        '[adhesion]\nwork_of_adhesion = "50 mJ/m^2"\ncohesive_stress = "0.1 MPa"\n'
        '[compute]\nmax_depth = "1 um"\npoints = 4\n'
    )
    assert main(["curve", str(problem), "--plot", str(picture)]) == 0
    assert "The picture has no pressures: " in capsys.readouterr().out
    assert picture.stat().st_size > 10000
    assert main(["curve", str(problem), "--pressure-csv", str(tmp_path / "p.csv")]) != 0
