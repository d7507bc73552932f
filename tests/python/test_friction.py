# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with friction: partial slip, tractions, loops, and what is refused."""

import math
import pickle
import warnings
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad, trapezoid
from scipy.special import ellipe, ellipk, zeta

import mdrcontact as mdr

STEEL, HARD = mdr.Elastic(210.0, 0.3), mdr.Elastic(700.0, 0.2)
BALL = mdr.Paraboloid(10.0)
MU = 0.4
STIFF_FILM = mdr.Coated(mdr.Elastic(4.75, 0.3), 0.514, mdr.Elastic(0.818, 0.0))


def friction(medium=None, indenter=BALL):
    return mdr.Friction(mdr.Contact(indenter, medium or mdr.Coated(HARD, 1.0, STEEL)), MU)


def test_cattaneo_mindlin():
    pair = friction(mdr.Homogeneous(STEEL))
    state = pair.contact.at_force(3.0)
    sliding = pair.shear(state).sliding_shift
    found = pair.shear(state).at_shift(np.array([[0.1, 0.5], [-0.9, 1.5]]) * sliding)
    assert found.tangential_force.shape == (2, 2)
    part = np.array([[0.1, 0.5], [0.9, 1.0]])
    np.testing.assert_allclose(np.abs(found.tangential_force), MU * 3.0 * (1.0 - (1.0 - part) ** 1.5), rtol=1e-12)
    np.testing.assert_allclose(found.stick_radius, state.radius * np.sqrt(1.0 - part), rtol=1e-11)
    assert found.sliding.tolist() == [[False, False], [False, True]]
    assert found.tangential_force[1, 0] < 0.0
    ratio = 2.0 * (1.0 - STEEL.nu) / (2.0 - STEEL.nu)
    assert pair.contact.medium.tangential_modulus(0.3) == pytest.approx(ratio * STEEL.contact_modulus, rel=1e-14)
    assert pair.contact.medium.tangential_stiffness([0.3, 0.6])[1] == pytest.approx(1.2 * ratio * STEEL.contact_modulus, rel=1e-14)


def test_numbers_give_numbers():
    pair = friction()
    found = pair.shear(pair.contact.at_force(1.0)).at_force(0.1)
    assert isinstance(found.shift, float) and found.sliding is False
    assert pair.shear(pair.contact.at_radius(0.3)).at_shift(1.0).sliding is True
    assert isinstance(pair.shear(pair.contact.at_radius(0.3)).sliding_shift, float)
    assert isinstance(pair.shear(pair.contact.at_radius(0.3)).cycle_energy(1e-3), float)
    assert pair.shear(pair.contact.at_radius(0.3)).at_shift([]).shift.shape == (0,)


def test_arrays_of_normal_states_broadcast():
    pair = friction()
    forces = np.array([1.0, 2.0, 3.0])
    many = pair.shear(pair.contact.at_force(forces)).at_shift(np.array([[1e-4], [2e-4]]))
    assert many.tangential_force.shape == (2, 3)
    for i, shift in enumerate((1e-4, 2e-4)):
        for j, force in enumerate(forces):
            one = pair.shear(pair.contact.at_force(force)).at_shift(shift)
            assert many[i, j] == one
    np.testing.assert_array_equal(
        pair.shear(pair.contact.at_force(forces)).sliding_shift[1], pair.shear(pair.contact.at_force(2.0)).sliding_shift
    )
    with pytest.raises(mdr.MDRError, match="broadcast"):
        pair.shear(pair.contact.at_force(forces)).at_shift([1e-4, 2e-4])


def test_the_traction_carries_the_force():
    pair = friction()
    state = pair.contact.at_radius(1.3)
    shear = pair.shear(state).at_shift(0.5 * pair.shear(state).sliding_shift)
    c, a = shear.stick_radius, state.radius
    parts = [quad(lambda r: r * pair.shear(state).traction(r, shear), *ends, limit=200)[0] for ends in ((0.0, c), (c, a))]
    assert 2.0 * math.pi * sum(parts) == pytest.approx(shear.tangential_force, rel=1e-7)
    parts = [quad(lambda x: pair.shear(state).line_load(x, shear), *ends)[0] for ends in ((0.0, c), (c, a))]
    assert 2.0 * sum(parts) == pytest.approx(shear.tangential_force, rel=1e-9)
    outside = np.linspace(1.001 * c, a, 5)
    np.testing.assert_allclose(pair.shear(state).traction(outside, shear), MU * state.pressure(outside), rtol=1e-12)


@pytest.mark.parametrize("control", ["shift", "force"])
def test_loop(control):
    pair = friction()
    state = pair.contact.at_radius(1.0)
    sliding = pair.shear(state).sliding_shift
    amplitude = 0.6 * (sliding if control == "shift" else MU * state.force)
    loop = pair.shear(state).loop(amplitude, control, points=4001)
    assert abs(trapezoid(loop.tangential_force, loop.shift)) == pytest.approx(loop.dissipated_energy, rel=1e-5)
    assert loop.dissipated_energy == pytest.approx(pair.shear(state).cycle_energy(amplitude, control), rel=1e-12)
    assert (loop.shift if control == "shift" else loop.tangential_force)[0] == pytest.approx(amplitude, rel=1e-12)
    np.testing.assert_allclose(loop.tangential_force[::-1][:2000], -loop.tangential_force[:2001][::-1][:2000], rtol=1e-9)
    sliding_loop = pair.shear(state).loop(2.0 * sliding, points=401)
    assert sliding_loop.turn.sliding
    assert np.abs(sliding_loop.tangential_force).max() == pytest.approx(MU * state.force)


@pytest.mark.parametrize("exponent", [0.5, 0.7, 1.0])
def test_sharp_tips_on_films_lose_the_area_of_their_loop(exponent):
    """The energy of a cycle that slides against the loop's area from T(s), by Gauss and Legendre towards both ends."""
    pair = mdr.Friction(mdr.Contact(mdr.PowerLaw(exponent, 0.3), mdr.Coated(STEEL, 1.0, mdr.Elastic(4.2 * STEEL.E, 0.1))), MU)
    state = pair.contact.at_radius(0.7)
    sliding = pair.shear(state).sliding_shift
    x, w = np.polynomial.legendre.leggauss(30)
    halves = 0.5 ** np.arange(1.0, 40.0)
    ends = sliding * np.unique([0.0, 1.0, *halves, *(1.0 - halves)])
    work = sum(
        0.5 * (b - a) * w @ pair.shear(state).at_shift(0.5 * (a + b + (b - a) * x)).tangential_force for a, b in pairwise(ends)
    )
    area = 8.0 * work - 4.0 * MU * state.force * sliding
    assert pair.shear(state).cycle_energy(sliding) == pytest.approx(area, rel=1e-9)


def test_a_model_whose_stiffness_falls_is_refused():
    """Under equivalent moduli of an auxetic film k_t(a) falls for a while: superposed punches then yield energy."""
    film = mdr.Coated(mdr.Elastic(7.5, -0.5), 1.0, mdr.Elastic(0.13, 0.0), "gao-power")
    pair = mdr.Friction(mdr.Contact(mdr.Paraboloid(0.4), film), MU)
    with pytest.raises(mdr.errors.DomainError, match="tangential stiffness of this model falls with the contact radius near"):
        pair.shear(pair.contact.at_radius(1.0)).at_shift(1e-6)
    small = pair.contact.at_radius(0.1)
    assert pair.shear(small).at_shift(0.5 * pair.shear(small).sliding_shift).dissipated_energy > 0.0


def test_small_amplitudes_keep_their_digits():
    pair = friction()
    state = pair.contact.at_radius(1.0)
    energies = pair.shear(state).cycle_energy(pair.shear(state).sliding_shift * np.array([1e-5, 1e-8, 1e-11]))
    np.testing.assert_allclose(energies[1:] / energies[:-1], 1e-9, rtol=2e-5)


def test_weights_of_a_tangential_load():
    xi = np.array([[0.0, 1e-3], [1.0, 1e6]])
    total = mdr.weights.weight_i0_tangential(xi, 0.3) + mdr.weights.weight_j0_tangential(xi, 0.3)
    np.testing.assert_allclose(total, 1.0, rtol=1e-15)
    assert mdr.weights.weight_j0_tangential(1e9, 0.3) > 0.0
    # exact to first order in the contrast of G
    small = 1e-6
    film = mdr.Coated(mdr.Elastic(1.0 + small, 0.3), 1.0, mdr.Elastic(1.0, 0.3))
    rise = film.tangential_modulus(0.7) / mdr.Homogeneous(mdr.Elastic(1.0, 0.3)).tangential_modulus(0.7) - 1.0
    assert rise / small == pytest.approx(mdr.weights.weight_i0_tangential(1.0 / 0.7, 0.3), rel=1e-5)


def test_history_of_an_oblique_impact():
    pair = friction(mdr.Homogeneous(STEEL))
    history, again = pair.history(), pair.history()
    path = np.concatenate([np.linspace(0.0, 0.1, 30), np.linspace(0.1, 0.0, 40)])
    shift = np.linspace(0.0, 0.03, 70)
    found = history.advance(depth=path, shift=shift)
    assert found.tangential_force.shape == (70,)
    one_by_one = [again.advance(depth=d, shift=s) for d, s in zip(path, shift, strict=True)]
    np.testing.assert_array_equal(found.tangential_force, [step.tangential_force for step in one_by_one])
    assert np.all(np.diff(found.dissipated_energy) >= 0.0)
    assert history.shear.tangential_force == 0.0 and history.state.radius == 0.0
    assert "FrictionHistory" in repr(history)
    # one straight step in place of the whole approach
    once = pair.history().advance(depth=0.1, shift=shift[29])
    assert once.tangential_force == pytest.approx(found.tangential_force[29], rel=1e-12)


@pytest.mark.parametrize("ulps", [1, 2, 5, 1000])
@pytest.mark.parametrize("shift", [1.0, -1.0])
def test_a_depth_that_rises_by_rounding(ulps, shift):
    """Sliding while the depth rises by a few last digits: T = mu F, and what follows is as after sliding at that depth."""
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))), 0.4)
    depth = 0.3 * (1.0 + ulps * np.finfo(float).eps)
    for first in (0.0, 0.02):
        history, held = friction.history(), friction.history()
        found = history.advance(depth=[0.3, depth, 0.4], shift=[first, shift, 0.5 * shift])
        expected = held.advance(depth=[0.3, 0.3, 0.4], shift=[first, shift, 0.5 * shift])
        np.testing.assert_allclose(found.tangential_force, expected.tangential_force, 0.0, 1e-12)
        np.testing.assert_allclose(found.dissipated_energy, expected.dissipated_energy, 1e-12)


def test_history_copies_and_refusals():
    pair = friction(mdr.Homogeneous(STEEL))
    history = pair.history()
    history.advance(force=1.0, shift=0.0)
    copy = history.copy()
    history.advance(force=1.0, tangential_force=0.3)
    assert copy.shear.tangential_force == 0.0
    assert copy.advance(force=1.0, tangential_force=0.3) == history.shear
    with pytest.raises(mdr.errors.UnreachableError, match="slides"):
        history.advance(force=1.0, tangential_force=MU)
    assert history.advance(force=1.0, shift=history.shear.shift).tangential_force == pytest.approx(0.3)
    assert history.advance(force=[], shift=[]).shift.shape == (0,)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="one of depth and force"):
        history.advance(depth=1.0, force=1.0, shift=0.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="one of shift"):
        history.advance(depth=1.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="broadcast"):
        history.advance(depth=[1.0, 2.0], shift=[0.0, 0.1, 0.2])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="one dimension"):
        history.advance(depth=[[1.0]], shift=0.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="largest_depth is missing"):
        friction().history()
    with pytest.raises(mdr.errors.InvalidArgumentError, match="rings = 5:"):
        friction().history(0.1, 5)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="rings need a largest_depth"):
        friction().history(rings=50)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="rings = 20.5"):
        friction().history(0.1, 20.5)


def test_history_on_a_film():
    pair = friction()
    state = pair.contact.at_depth(0.1)
    history = pair.history(0.1, 60)
    history.advance(depth=0.1, shift=0.0)
    loop = pair.shear(state).loop(0.6 * pair.shear(state).sliding_shift, points=9)
    twin = history.copy()
    found = history.advance(depth=0.1, shift=loop.shift)
    np.testing.assert_allclose(found.tangential_force, loop.tangential_force, atol=3e-4 * MU * state.force)
    assert found.stick_radius[0] == pytest.approx(loop.turn.stick_radius, abs=state.radius / 100)
    lost = found.dissipated_energy[-1] - found.dissipated_energy[0]
    assert lost == pytest.approx(loop.dissipated_energy, rel=0.02)
    back = twin.advance(depth=0.1, tangential_force=loop.tangential_force)
    np.testing.assert_allclose(back.shift, loop.shift, atol=1e-3 * loop.shift[0])
    with pytest.raises(mdr.errors.DomainError, match="the rings of this history"):
        history.advance(depth=0.11, shift=0.0)


@pytest.mark.parametrize(
    "medium", [mdr.Homogeneous(STEEL), mdr.Coated(mdr.Elastic(40.0, 0.3), 1.0, STEEL)], ids=["half-space", "film"]
)
@pytest.mark.parametrize("indenter", [mdr.FlatEndedCone(0.4, 0.2), mdr.FlatEndedParaboloid(0.4, 5.0), mdr.FlatPunch(0.4)], ids=repr)
def test_rings_under_a_flat_end(indenter, medium):
    """They touch at once. Under a flat punch the error is that of the first order: rings of constant traction are less stiff."""
    pair = friction(medium, indenter)
    state = pair.contact.at_depth(0.1)
    shifts = pair.shear(state).sliding_shift * np.array([0.0, 0.1, 0.5, 1.2])
    exact = pair.shear(state).at_shift(shifts).tangential_force
    errors = []
    for rings in (25, 100):
        found = pair.history(0.1, rings).advance(depth=0.1, shift=shifts).tangential_force
        errors.append(np.abs(found - exact).max() / (MU * state.force))
    assert errors[0] < (4e-3 if isinstance(indenter, mdr.FlatPunch) else 1.5e-3)
    assert errors[1] < 0.5 * errors[0]


def test_flat_ends_along_paths_by_rings():
    depth, shift = [0.1, 0.05, 0.0, 0.0, 0.08, 0.08], [0.03, -0.01, 0.0, 0.02, 0.03, 0.0]
    pair = friction(mdr.Homogeneous(STEEL), mdr.FlatEndedCone(0.4, 0.2))
    exact = pair.history().advance(depth=depth, shift=shift)
    found = pair.history(0.1, 50).advance(depth=depth, shift=shift)
    largest = MU * pair.contact.at_depth(0.1).force
    np.testing.assert_allclose(found.tangential_force, exact.tangential_force, atol=2e-3 * largest)
    np.testing.assert_allclose(found.dissipated_energy, exact.dissipated_energy, atol=0.01 * exact.dissipated_energy[-1])


def test_viscoelastic_bodies_say_why_they_are_refused():
    body = mdr.Homogeneous(mdr.Viscoelastic(500.0, [(300.0, 0.05)], bulk_modulus=5e3))
    for refused in (lambda: friction(body), lambda: body.tangential_stiffness(1.0), lambda: body.torsional_stiffness(1.0)):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="viscoelastic body depend on time.* relaxed material"):
            refused()
    relaxed = mdr.Homogeneous(body.material.relaxed)
    assert relaxed.torsional_stiffness(1.0) == pytest.approx(16.0 / 3.0 * 500.0, rel=1e-12)


def test_law():
    pair = friction(mdr.Homogeneous(STEEL))
    law = mdr.ContactLaw(pair.contact, 0.1, friction=pair, sliders=16, tolerance=1e-8)
    assert law.first_shear_error < 4e-3
    # the error stated is the largest, of shifts and depths between the levels, too
    for sliders in (4, 8, 16):
        coarse = mdr.ContactLaw(pair.contact, 0.1, friction=pair, sliders=sliders)
        found = []
        for depth in np.linspace(0.035, 0.095, 9):
            place = pair.contact.at_depth(depth)
            for part in (0.1, 0.16, 0.25, 0.4, 0.5, 0.7, 0.8):
                record, shift = coarse.contacts(1), part * pair.shear(place).sliding_shift
                coarse.advance(record, [place.force], [[0.0, 0.0]])
                T = coarse.advance(record, [place.force], [[shift, 0.0]])[0, 0]
                found.append(abs(T - pair.shear(place).at_shift(shift).tangential_force) / (MU * place.force))
        assert max(found) < 1.1 * coarse.first_shear_error
    assert 1e-3 < law.path_error < 0.01
    assert (law.sliders, law.memory_size) == (16, 11 + 4 * 16)
    assert pickle.loads(pickle.dumps(law)) == law
    state = pair.contact.at_depth(0.05)
    sliding = pair.shear(state).sliding_shift
    memory = law.contacts(3)
    force = np.full(3, state.force)
    law.advance(memory, force, np.zeros((3, 2)))
    shift = np.outer([0.3, 0.7, 1.5], [0.6 * sliding, 0.8 * sliding])
    before = memory.copy()
    tried, stiffness, by_force = law.attempt(memory, force, shift, tangent=True)
    np.testing.assert_array_equal(memory, before)
    found = law.advance(memory, force, shift)
    np.testing.assert_array_equal(found, tried)
    exact = pair.shear(state).at_shift(np.array([0.3, 0.7, 1.5]) * sliding).tangential_force
    bound = 0.006 * MU * state.force
    np.testing.assert_allclose(found, np.outer(exact, [0.6, 0.8]), atol=bound)
    for axis in range(2):
        step = 1e-6 * sliding * np.eye(2)[axis]
        change = law.attempt(before, force, shift + step) - law.attempt(before, force, shift - step)
        np.testing.assert_allclose(stiffness[:, :, axis], change / (2e-6 * sliding), atol=1e-6 * np.abs(stiffness).max())
    change = law.attempt(before, force * (1 + 1e-6), shift) - law.attempt(before, force * (1 - 1e-6), shift)
    np.testing.assert_allclose(by_force, change / (2e-6 * state.force), atol=1e-6)
    stored, dissipated = law.energies(memory)
    lost = pair.shear(state).at_shift(np.array([0.3, 0.7, 1.5]) * sliding).dissipated_energy
    np.testing.assert_allclose(dissipated, lost, rtol=0.15)
    assert np.all(stored > 0.0)
    assert np.all(dissipated > 0.0)
    # there and back: the loop of the contact
    loop = pair.shear(state).loop(0.7 * sliding, points=5)
    found = [law.advance(memory[1:2], force[:1], [[0.6 * step, 0.8 * step]])[0] for step in np.diff(loop.shift)]
    np.testing.assert_allclose(found, np.outer(loop.tangential_force[1:], [0.6, 0.8]), atol=2.0 * bound)
    law.turn(memory, np.tile([0.6, 0.0, 0.8], (3, 1)))
    turned = law.advance(memory, force, np.zeros((3, 3)))
    np.testing.assert_allclose(np.linalg.norm(turned[2]), MU * state.force, rtol=1e-14)
    np.testing.assert_allclose(turned @ [0.6, 0.0, 0.8], 0.0, atol=1e-15)
    law.turn(memory, np.tile([0.6, 0.0, 0.8], (3, 1)), spin=np.full(3, np.pi))
    np.testing.assert_allclose(law.advance(memory, force, np.zeros((3, 3))), -turned, atol=1e-15)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="of length 2"):
        law.turn(memory, np.tile([0.0, 0.0, 2.0], (3, 1)))
    assert law.advance(law.contacts(0), [], np.zeros((0, 3))).shape == (0, 3)
    assert law.energies(law.contacts(0))[0].shape == (0,)
    layered = friction()
    layered = mdr.ContactLaw(layered.contact, 0.1, friction=layered)
    assert 1e-3 < layered.first_shear_error < 0.02
    assert layered.path_error is None


def test_law_files(tmp_path):
    pair = friction(mdr.Homogeneous(STEEL))
    law = mdr.ContactLaw(pair.contact, 0.1, friction=pair, tolerance=1e-7)
    assert law.description == repr(pair)
    assert law.coefficient == MU
    assert law.tolerance == 1e-7
    largest = law.force_range[1]
    assert law.largest_sliding_shift == pytest.approx(pair.shear(pair.contact.at_force(largest)).sliding_shift, rel=1e-6)
    path = tmp_path / "ball.mdrlaw"
    law.save(path)
    again = mdr.ContactLaw.load(path)
    assert (again, hash(again), repr(again), again.path_error) == (law, hash(law), repr(law), law.path_error)
    assert again != mdr.ContactLaw(pair.contact, 0.1, friction=pair, tolerance=1e-7, description="other words")
    forces = []
    for each in (law, again):
        contacts = each.contacts(1)
        path_of_shift = [[0.0, 0.0], [1e-3, 1e-3], [-5e-4, 0.0]]
        forces.append([each.advance(contacts, [largest * 0.5], [step]).tolist() for step in path_of_shift])
    assert forces[0] == forces[1]
    for former in (b"friction law, format 3\n", b"contact law, format 2\n"):
        with pytest.raises(mdr.errors.FileError, match="Create it again"):
            mdr.ContactLaw.from_bytes(b"mdrcontact compiled " + former)


def test_law_refusals():
    pair = friction(mdr.Homogeneous(STEEL))
    law = mdr.ContactLaw(pair.contact, 0.1, friction=pair)
    contacts = law.contacts(2)
    with pytest.raises(mdr.errors.DomainError, match="largest force"):
        law.advance(contacts, [1e9, 1.0], np.zeros((2, 2)))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="shift must be finite"):
        law.advance(contacts, [1.0, 1.0], [[0.0, 0.0], [np.inf, 0.0]])
    for shape in ((2,), (2, 4), (3, 2)):
        with pytest.raises(mdr.errors.ArgumentTypeError, match="must be"):
            law.advance(contacts, [1.0, 1.0], np.zeros(shape))
    with pytest.raises(mdr.errors.ArgumentTypeError, match="ContactLaw.contacts"):
        law.advance(np.zeros((2, 3)), [1.0, 1.0], np.zeros((2, 2)))
    with pytest.raises(mdr.errors.ArgumentTypeError, match="normals of shape"):
        law.turn(contacts, [0.0, 0.0, 1.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="count"):
        law.contacts(-1)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="smallest_depth"):
        mdr.ContactLaw(pair.contact, 0.1, friction=pair, smallest_depth=0.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="must be a Friction"):
        mdr.ContactLaw(pair.contact, 0.1, friction=0.3)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 1 of force = -1"):
        law.advance(contacts, [-1.0, 1.0], np.zeros((2, 2)))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="sliders = 3:"):
        mdr.ContactLaw(pair.contact, 0.1, friction=pair, sliders=3)
    assert not contacts.any()
    law.advance(contacts, [0.01, 0.01], np.zeros((2, 2)))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 1 of memory"):
        mdr.ContactLaw(pair.contact, 0.2, friction=pair).advance(contacts, [0.01, 0.01], np.zeros((2, 2)))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="friction: it must belong to the contact"):
        mdr.ContactLaw(friction().contact, 0.1, friction=pair)
    plain = mdr.ContactLaw(pair.contact, 0.1)
    assert (plain.coefficient, plain.sliders, plain.memory_size, plain.path_error) == (None, 0, 0, None)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="no friction"):
        plain.contacts(2)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="ContactLaw.contacts"):
        plain.advance(np.zeros((2, 0)), [0.01, 0.01], np.zeros((2, 2)))


def test_torsional_stiffness():
    radii = np.array([[0.1, 1.0], [3.0, 20.0]])
    shear = STEEL.E / (2.0 + 2.0 * STEEL.nu)
    np.testing.assert_allclose(mdr.Homogeneous(STEEL).torsional_stiffness(radii), 16.0 / 3.0 * shear * radii**3, rtol=1e-14)
    film = mdr.Coated(HARD, 1.0, STEEL)
    np.testing.assert_allclose(mdr.Pair(film, film).torsional_stiffness(radii), 0.5 * film.torsional_stiffness(radii), rtol=1e-10)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="torsional stiffness is not available for this medium"):
        mdr.Coated(HARD, 1.0, STEEL, "gao").torsional_stiffness(1.0)


def test_values():
    pair = friction()
    assert pickle.loads(pickle.dumps(pair)) == pair
    assert eval(repr(pair), vars(mdr)) == pair
    assert pair.replace(coefficient=0.1).coefficient == 0.1


def test_refusals():
    pair = friction()
    state = pair.contact.at_radius(1.0)
    sticky = mdr.Contact(BALL, mdr.Homogeneous(STEEL), work_of_adhesion=1e-3)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="not defined under tension"):
        mdr.Friction(sticky, MU)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="coefficient = -1"):
        mdr.Friction(pair.contact, -1.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="must be a Contact"):
        mdr.Friction(BALL, MU)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="tangential stiffness is not available for this medium"):
        friction(mdr.Coated(HARD, 1.0, STEEL, "doerner-nix"))
    with pytest.raises(mdr.errors.ArgumentTypeError, match="it must be a State"):
        pair.shear(1.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="State of the contact with friction"):
        pair.shear(sticky.at_force(1.0))
    with pytest.raises(mdr.errors.UnreachableError, match="slides"):
        pair.shear(state).at_force(1e9)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="control"):
        pair.shear(state).loop(0.1, "depth")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="points = 2"):
        pair.shear(state).loop(0.1, points=2)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="ShearState"):
        pair.shear(state).traction(0.1, 0.2)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="one"):
        pair.shear(pair.contact.at_force([1.0, 2.0])).loop(0.1)
    with pytest.raises(mdr.errors.DomainError, match="at most the contact radius"):
        pair.shear(state).traction(1.1, pair.shear(state).at_shift(1e-3))
    stiff = friction(mdr.Coated(mdr.Elastic(100.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3)), mdr.PowerLaw(4.0, 1.0))
    with pytest.raises(mdr.errors.DomainError, match="not a single area"), pytest.warns(mdr.errors.SeparationInsideWarning):
        stiff.shear(stiff.contact.at_radius(2.0)).at_shift(0.1)


def test_energy_by_rings_does_not_grow_with_the_number_of_steps():
    """A ring in which the contact grows in several steps slips once, not once more in each."""
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))), 0.3)
    corners, depth, shift = np.arange(4), [0.0, 0.01, 0.02, 0.02], [0.0, 0.004, -0.004, 0.0]
    rows = np.linspace(0.0, 3.0, 3 * 120 + 1)[1:]
    steps = {"depth": np.interp(rows, corners, depth), "shift": np.interp(rows, corners, shift)}
    exact = friction.history().advance(**steps).dissipated_energy
    rings = friction.history(0.02, 20).advance(**steps).dissipated_energy
    assert np.all(np.diff(rings) >= 0.0)
    assert np.abs(rings - exact).max() < 0.02 * exact[-1], (rings[119::120], exact[119::120])


@pytest.mark.parametrize("model", ["exact", "gao", "homogeneous"])
@pytest.mark.parametrize("indenter", [mdr.Paraboloid(1.0), mdr.Cone(0.5)])
def test_shifts_as_small_as_rounding_errors(model, indenter):
    medium = mdr.Homogeneous(STEEL) if model == "homogeneous" else mdr.Coated(HARD, 1.0, STEEL, model)
    pair = mdr.Friction(mdr.Contact(indenter, medium), MU)
    state = pair.contact.at_depth(0.3)
    shifts = pair.shear(state).sliding_shift * np.array([1e-12, 1e-15, 1e-17, 1e-20, 1e-60, 1e-100])
    found = pair.shear(state).at_shift(shifts)
    np.testing.assert_allclose(found.tangential_force, medium.tangential_stiffness(state.radius) * shifts, rtol=1e-8)
    # a third power of the shift
    np.testing.assert_allclose(found.dissipated_energy / shifts**3, found.dissipated_energy[0] / shifts[0] ** 3, rtol=1e-8)
    back = pair.shear(state).at_force(found.tangential_force)
    np.testing.assert_allclose(back.shift, shifts, rtol=1e-8)


def test_stick_radius_just_before_sliding():
    pair = mdr.Friction(mdr.Contact(mdr.Cone(0.5), mdr.Homogeneous(STEEL)), MU)
    state = pair.contact.at_depth(0.3)
    parts = np.array([1e-4, 1e-6, 1e-9])
    found = pair.shear(state).at_shift(pair.shear(state).sliding_shift * (1.0 - parts))
    np.testing.assert_allclose(found.stick_radius / state.radius, parts, rtol=1e-6)


def test_rings_touch_where_the_error_is_of_second_order():
    """Oblique growth without slip: the error falls with the square of the rings' width, and only with the right place of touch."""
    pair = mdr.Friction(mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(STEEL)), 2.0)
    exact = pair.history().advance(depth=0.1, shift=0.05).tangential_force
    counts = np.array([20, 40, 80, 160])
    found = [pair.history(largest_depth=0.1, rings=int(n)).advance(depth=0.1, shift=0.05).tangential_force for n in counts]
    errors = np.array(found) / exact - 1.0
    np.testing.assert_allclose(errors * counts**2, errors[-1] * counts[-1] ** 2, rtol=0.1)


def test_place_of_touch():
    """What the library takes for it, by Wiener and Hopf's integral and by how much rings of constant traction lack of a disc."""
    theta, weights = np.polynomial.legendre.leggauss(60)
    theta, weights = 0.5 * np.pi * (1.0 + theta), 0.5 * np.pi * weights
    part = theta / (2.0 * np.pi)
    symbol = 4.0 * np.sin(theta / 2.0) ** 2 * (zeta(3, part) + zeta(3, 1.0 - part)) / (2.0 * np.pi) ** 3
    integrand = np.log(2.0 * np.sin(theta / 2.0) * symbol) / (1.0 - np.cos(theta))
    assert 0.25 - np.sum(weights * integrand) / (2.0 * np.pi) == pytest.approx(0.384948, abs=2e-6)
    lacking = []
    for n in (40, 80, 160):
        r = np.arange(1, n + 1) / n
        large, small = np.maximum.outer(r, r), np.minimum.outer(r, r)
        part = np.minimum((small / large) ** 2, 1.0 - 1e-16)
        discs = np.zeros((n + 1, n + 1))
        discs[1:, 1:] = 8.0 / 3.0 * large * ((large**2 + small**2) * ellipe(part) - (large**2 - small**2) * ellipk(part))
        forces = np.diff(np.diff(discs, axis=0), axis=1)
        areas = np.pi * np.diff(np.append(0.0, r**2))
        stiffness = np.linalg.solve(forces / np.outer(areas, areas), np.ones(n)).sum()
        lacking.append(n * (1.0 - stiffness / 2.0))
    assert 0.5 - (2.0 * lacking[2] - lacking[1]) == pytest.approx(0.384948, abs=2e-6)


@pytest.mark.parametrize("force_first", [False, True])
def test_slip_that_begins_inside_warns(force_first):
    """A flat end on a stiff film presses the middle little: by rings, which obey |tau| <= mu p everywhere, T is 12 % smaller."""
    contact = mdr.Contact(mdr.FlatEndedCone(0.608, 0.191), STIFF_FILM)
    friction, state = mdr.Friction(contact, 0.3), contact.at_radius(0.614)
    slides = friction.shear(state).sliding_shift
    with pytest.warns(mdr.errors.SlipInsideWarning, match="at r = .* the traction would be"):
        if force_first:
            friction.shear(friction.contact.at_force(state.force)).at_force(0.3 * state.force * np.array([0.1, 1.0]))
        else:
            friction.shear(state).at_shift(slides)
    rings = friction.history(largest_depth=1.001 * state.depth)
    rings.advance(depth=state.depth, shift=0.0)
    assert rings.advance(depth=state.depth, shift=slides).tangential_force < 0.95 * 0.3 * state.force


@pytest.mark.parametrize("attempt", [
    lambda friction, state: friction.shear(state).at_shift(0.4),
    lambda friction, state: friction.shear(state).at_force(0.29 * state.force),
    lambda friction, state: friction.shear(state).at_force([0.29 * state.force]),
    lambda friction, state: friction.shear(state).loop(0.4),
    lambda friction, state: friction.shear(state).cycle_energy(0.4),
])  # fmt: skip
def test_slip_inside_is_warned_of_at_the_line_of_the_call(attempt):
    friction = mdr.Friction(mdr.Contact(mdr.FlatEndedCone(0.608, 0.191), STIFF_FILM), 0.3)
    state = friction.contact.at_radius(0.614)
    with pytest.warns(mdr.errors.SlipInsideWarning) as shown:
        attempt(friction, state)
    assert [(Path(one.filename), one.lineno) for one in shown] == [(Path(__file__), attempt.__code__.co_firstlineno)]


def test_states_are_answered_where_the_pressure_is_refused(monkeypatch):
    """Whether slip would begin inside is then unknown; the states are good all the same."""
    friction = mdr.Friction(mdr.Contact(mdr.FlatEndedCone(0.608, 0.191), STIFF_FILM), 0.3)
    state = friction.contact.at_radius(0.614)

    def refuse(*_, **__):
        raise mdr.errors.NoConvergenceError("a field did not reach its tolerance")

    monkeypatch.setattr(mdr.State, "pressure", refuse)
    found = friction.shear(state).at_shift(0.005)
    assert 0.0 < found.tangential_force < 0.3 * state.force
    assert friction.shear(state).loop(0.005, points=3).turn == found
    assert friction.shear(state).cycle_energy(0.005) == pytest.approx(4.0 * found.dissipated_energy)


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_a_thousandth_of_the_mean_pressure_is_noticed(unit):
    """Under the flat end the traction is more than mu p by 1.5e-3 of the mean on the softer base, less by 7e-4 on the stiffer."""
    for base, count in ((3.5, 1), (3.57, 0)):
        film = mdr.Coated(mdr.Elastic(4.75, 0.3), 0.514 * unit, mdr.Elastic(base, 0.0))
        friction = mdr.Friction(mdr.Contact(mdr.FlatEndedCone(0.608 * unit, 0.191), film), 0.3)
        state = friction.contact.at_radius(0.614 * unit)
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            friction.shear(state).at_shift(0.98 * friction.shear(state).sliding_shift)
        assert [warning.category for warning in found] == count * [mdr.errors.SlipInsideWarning]


def test_slip_at_the_edge_does_not_warn():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", mdr.errors.LargeStrainWarning)
        for indenter in (mdr.Paraboloid(1.0), mdr.Cone(0.4)):
            for base in (0.1, 1.0, 30.0):
                film = mdr.Coated(mdr.Elastic(1.0, 0.3), 0.5, mdr.Elastic(base, 0.2))
                friction = mdr.Friction(mdr.Contact(indenter, film), 0.3)
                for radius in (0.05, 0.5, 2.0):
                    force = 0.3 * friction.contact.at_radius(radius).force
                    friction.shear(friction.contact.at_radius(radius)).at_force(force * np.array([0.01, 0.5, 0.999]))
