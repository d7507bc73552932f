# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of a twist about the normal: Lubkin's first twist, springs for themselves along random paths, energies, refusals."""

import pickle

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

import mdrcontact as mdr

STEEL, MU, R = mdr.Elastic(210e9, 0.3), 0.3, 1e-3
CONTACT = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(STEEL))
FRICTION = mdr.Friction(CONTACT, MU)
STATE = CONTACT.at_depth(2e-6)
LIMIT = FRICTION.twist(STATE).sliding_force
TWIST = FRICTION.twist(STATE).at_force(0.9 * LIMIT).shift


def made(sliders=16, friction=FRICTION):
    return mdr.ContactLaw(CONTACT, 5e-6, friction=friction, sliders=sliders, twist=True)


@pytest.fixture(scope="module")
def law():
    return made()


@pytest.mark.parametrize(
    ("sliders", "largest", "after_a_fall"), [(4, 0.05, 0.1), (8, 0.015, 0.03), (16, 0.003, 0.003), (32, 0.001, 0.001)]
)
def test_first_twist_is_that_of_the_contact(sliders, largest, after_a_fall):
    """Under one force at once, grown in steps, and after it has fallen."""
    law, force = made(sliders), STATE.force
    parts = np.linspace(0.005, 0.999, 50)
    twists = [FRICTION.twist(FRICTION.contact.at_force(force)).at_force(part * LIMIT).shift for part in parts]
    grown = np.linspace(0, force, 50)[1:]
    for history in ([force], grown, [*grown, *(force * np.linspace(1, 1.3, 9)), *(force * np.linspace(1.3, 1, 20))]):
        memory = law.contacts(1)
        for F in history:
            law.advance(memory, [F], [0.0])
        found = [law.attempt(memory, [force], [twist])[0] / LIMIT for twist in twists]
        assert np.abs(found - parts).max() < (after_a_fall if len(history) > len(grown) else largest)
        assert law.attempt(memory, [force], [1e3 * twists[-1]])[0] == pytest.approx(LIMIT, rel=1e-12)
    assert law.first_shear_error < largest
    assert law.twists and law.largest_sliding_shift == 0 and law.path_error is None


def springs(forces, twists, count=1500):
    """Torques of springs for themselves: 16 G x^2 phi dx where they stick, and no more than they bear at the twist phi(x) at which
    they slip, Lubkin's."""
    shear = 210e9 / 2.6
    radius = (np.array(forces) / STATE.force) ** (1 / 3) * STATE.radius
    x = (np.arange(count) + 0.5) / count * radius.max()
    stiffness = 16 * shear * x**2 * (x[1] - x[0])
    q, torque, before = np.zeros(count), [], 0.0
    for F, a, phi in zip(forces, radius, np.cumsum(twists), strict=True):
        with np.errstate(invalid="ignore", divide="ignore"):
            m = np.where(x < a, 1 - (x / a) ** 2, 0.0)
            slips = np.where(x < a, 3 * MU * F / (4 * np.pi * shear * a**2) * (ellipk(m) - ellipe(m)), 0.0)
        q = np.clip(q + stiffness * (phi - before), -stiffness * slips, stiffness * slips)
        torque.append(q.sum())
        before = phi
    return np.array(torque)


def test_random_paths_are_those_of_springs(law):
    """Small steps of force and twist, to and fro: springs that touch or leave are those of the law."""
    random = np.random.default_rng(3)
    turns_of_force, turns = 0.2 + 1.6 * random.random(12), TWIST * random.normal(size=12)
    times = np.linspace(0, 11, 650)
    forces, angles = (np.interp(times, np.arange(12), corners) for corners in (STATE.force * turns_of_force, turns))
    forces, twists = np.concatenate([forces[:1], forces]), np.diff(angles, prepend=[0.0, 0.0])
    truth, memory = springs(forces, twists), law.contacts(1)
    found = np.array([law.advance(memory, [F], [phi])[0] for F, phi in zip(forces, twists, strict=True)])
    largest = MU * 3 * np.pi / 16 * (forces * (forces / STATE.force) ** (1 / 3) * STATE.radius).max()
    assert np.abs(truth).max() > 0.5 * largest
    assert np.abs(found - truth).max() < 0.01 * largest


def test_energy_is_never_won(law):
    """M at the end of a step does at least the work that springs then hold more, whatever the step."""
    random = np.random.default_rng(4)
    memory, before = law.contacts(500), np.zeros(500)
    for _ in range(40):
        twist = TWIST * random.normal(size=500) * 10 ** random.uniform(-2, 0.5, 500)
        force = STATE.force * random.uniform(0, 2, 500) * (random.random(500) > 0.05)
        M = law.advance(memory, force, twist)
        stored, dissipated = law.energies(memory)
        assert np.all(M * twist - (stored - before) >= -1e-15 * LIMIT * np.abs(TWIST))
        assert np.all(np.abs(M) <= MU * force * 3 * np.pi / 16 * (force / STATE.force) ** (1 / 3) * STATE.radius * (1 + 1e-12))
        before = stored
    assert np.all(dissipated > 0)


def test_a_loop_takes_the_energy_of_the_contact(law):
    loop = FRICTION.twist(STATE).loop(TWIST)
    memory = law.contacts(1)
    law.advance(memory, [STATE.force], [0.0])
    law.advance(memory, [STATE.force], [TWIST])
    before = law.energies(memory)[1][0]
    for _ in range(200):
        law.advance(memory, [STATE.force], [-TWIST / 100])
    for _ in range(200):
        law.advance(memory, [STATE.force], [TWIST / 100])
    assert law.energies(memory)[1][0] - before == pytest.approx(loop.dissipated_energy, rel=0.01)


def test_derivatives(law):
    random = np.random.default_rng(5)
    memory = law.contacts(300)
    for _ in range(20):
        law.advance(memory, STATE.force * random.uniform(0, 2, 300), TWIST * random.normal(size=300))
    force, twist = STATE.force * random.uniform(0.01, 1.5, 300), TWIST * random.normal(size=300)
    _, by_twist, by_force = law.attempt(memory, force, twist, tangent=True)
    small = 1e-6 * TWIST
    differences = (law.attempt(memory, force, twist + small) - law.attempt(memory, force, twist - small)) / (2 * small)
    assert np.abs(by_twist - differences).max() < 1e-8 * by_twist.max()
    small = 1e-6 * STATE.force
    differences = (law.attempt(memory, force + small, twist) - law.attempt(memory, force - small, twist)) / (2 * small)
    assert np.abs(by_force - differences).max() < 1e-8 * np.abs(by_force).max()


def test_arrays_files_and_other_radii(law, tmp_path):
    law.save(tmp_path / "spin.law")
    again = mdr.ContactLaw.load(tmp_path / "spin.law")
    assert again == law and again.twists and pickle.loads(pickle.dumps(law)) == law
    random = np.random.default_rng(6)
    force, twist = STATE.force * random.uniform(0.1, 2, 40), TWIST * random.normal(size=40)
    memory, one = law.contacts(40), again.contacts(40)
    M = law.advance(memory, force, twist)
    alone = [again.advance(one[i : i + 1], force[i : i + 1], twist[i : i + 1])[0] for i in range(40)]
    assert M.tolist() == alone and memory.tolist() == one.tolist()
    # at one radius F is proportional to 1/R, the stiffness is the same
    other, memory = law.with_radius(2 * R), law.contacts(1)
    scaled = other.contacts(1)
    for F, phi in zip(force[:10], twist[:10], strict=True):
        assert 0.5 * law.advance(memory, [F], [phi])[0] == pytest.approx(other.advance(scaled, [0.5 * F], [0.5 * phi])[0], rel=1e-9)


def test_refusals(law):
    memory = law.contacts(1)
    law.advance(memory, [STATE.force], [TWIST])
    before = memory.copy()
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 1 of force"):
        law.advance(memory, [-1.0], [0.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="shift"):
        law.advance(memory, [1.0], [np.nan])
    with pytest.raises(mdr.errors.DomainError, match="largest force"):
        law.advance(memory, [1e9], [0.0])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="must be \\(1,\\) and \\(1,\\)"):
        law.advance(memory, [1.0], [[0.0, 0.0]])
    of_shift = mdr.ContactLaw(CONTACT, 5e-6, friction=FRICTION, sliders=16)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="memory"):
        of_shift.advance(memory, [1.0], [[0.0, 0.0]])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="memory"):
        made(friction=mdr.Friction(CONTACT, 2 * MU)).advance(memory, [1.0], [0.0])
    assert memory.tolist() == before.tolist()
    with pytest.raises(mdr.errors.InvalidArgumentError, match=r"options.twist: it needs options.friction"):
        mdr.ContactLaw(CONTACT, 5e-6, twist=True)
    for shape, body in (
        (mdr.Cone(0.1), mdr.Homogeneous(STEEL)),
        (mdr.Paraboloid(R), mdr.Coated(mdr.Elastic(100e9, 0.3), 1e-5, STEEL, "exact")),
    ):
        contact = mdr.Contact(shape, body)
        with pytest.raises(mdr.errors.InvalidArgumentError, match="options.twist: it is available for a paraboloid"):
            mdr.ContactLaw(contact, 1e-6, friction=mdr.Friction(contact, MU), twist=True)
    film = mdr.Contact(mdr.Paraboloid(R), mdr.Coated(mdr.Elastic(100e9, 0.3), 1e-5, STEEL, "exact"))
    assert not mdr.ContactLaw(film, 1e-6, friction=mdr.Friction(film, MU)).twists
