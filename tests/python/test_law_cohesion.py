# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws of contacts with a cohesive zone, against the contact itself, its energy and its limits."""

import math
import pickle

import numpy as np
import pytest
from test_cohesion import CONE, FILM, HALF_SPACE, PAIR, PARABOLOID, total_energy

import mdrcontact as mdr

STIFF = mdr.Coated(mdr.Elastic(26.0, 0.3), 1.0, mdr.Elastic(2.6, 0.3), model="exact")
BODIES = {"half-space": HALF_SPACE, "film": FILM, "stiff film": STIFF, "pair": PAIR}
FLAT_END = mdr.FlatEndedParaboloid(0.3, 1.0)
WORK, LARGEST = 0.5, 2.0
TOLERANCE = 1e-9

pytestmark = pytest.mark.filterwarnings("ignore::mdrcontact.errors.LargeStrainWarning")


def contact_with(tip, body, stress):
    return mdr.Contact(tip, body, work_of_adhesion=WORK, cohesive_stress=stress)


def lowest(contact, control, branch):
    if branch == "unloading":
        state = contact.pull_off(control)
        return state.depth if control == "depth" else state.force
    return -WORK / contact.cohesive_stress if control == "depth" else 0.0


@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
@pytest.mark.parametrize("tip", [PARABOLOID, CONE, FLAT_END], ids=["paraboloid", "cone", "flat end"])
@pytest.mark.parametrize("stress", [0.05, 0.3, 3.0, 30.0])
def test_between_its_nodes_the_law_is_the_contact(tip, body, stress):
    contact = contact_with(tip, body, stress)
    if tip is CONE and body is HALF_SPACE and stress == 30.0:
        with pytest.raises(mdr.errors.InvalidArgumentError, match="no state is stable under force"):
            mdr.ContactLaw(contact, LARGEST)
        return
    law = mdr.ContactLaw(contact, LARGEST, tolerance=TOLERANCE)
    assert 0.0 < law.error <= TOLERANCE
    random = np.random.default_rng(36)
    for branch in ("loading", "unloading"):
        start = lowest(contact, "depth", branch)
        d = start + (LARGEST - start) * random.uniform(0.0, 1.0, 60) ** 2
        exact, found = contact.at_depth(d, branch=branch), law.at_depth(d, branch=branch)
        rounding = 1e-14 * abs(exact.force).max()
        assert np.all(abs(found.force - exact.force) <= TOLERANCE * (abs(exact.force) + abs(d * found.slope)) + rounding)
        # no number is better than the depth it belongs to
        nearby = law.at_depth(d + 1e-6 * abs(d) * np.where(d < LARGEST - 1e-3, 1.0, -1.0), branch=branch)
        for name in ("radius", "stiffness"):
            slope = abs(getattr(nearby, name) - getattr(found, name)) / 1e-6
            assert np.all(abs(getattr(found, name) - getattr(exact, name)) <= TOLERANCE * (abs(getattr(exact, name)) + 2.0 * slope))
        start = lowest(contact, "force", branch)
        if law.force_range[1] <= start:
            continue
        force = start + (law.force_range[1] - start) * random.uniform(0.0, 1.0, 60) ** 2
        exact, found = contact.at_force(force, branch=branch), law.at_force(force, branch=branch)
        allowed = TOLERANCE * (abs(exact.depth) + abs(force / found.slope))
        assert np.all(abs(found.depth - exact.depth) <= allowed)


@pytest.mark.parametrize("body", [HALF_SPACE, FILM], ids=["half-space", "film"])
@pytest.mark.parametrize("tip", [PARABOLOID, CONE], ids=["paraboloid", "cone"])
@pytest.mark.parametrize("stress", [0.1, 3.0])
def test_energy_is_that_of_bodies_that_have_met(tip, body, stress):
    """U counts from bodies that are apart: elastic energy and that of the surfaces, from the fields of the states."""
    contact = contact_with(tip, body, stress)
    law = mdr.ContactLaw(contact, LARGEST)
    start = contact.pull_off("depth").depth
    depths = start + (LARGEST - start) * np.array([1e-3, 0.1, 0.3, 0.6, 1.0])
    for d in depths:
        state = contact.at_depth(float(d))
        if state.radius == 0.0:
            state = mdr.State(
                state.depth, 0.0, state.force, 0.0, state.depth, math.sqrt(-state.force / (math.pi * stress)), contact
            )
        assert law.energy(float(d)) == pytest.approx(total_energy(contact, state), rel=1e-7, abs=1e-8)
    steps = np.array([-2.0, -1.0, 1.0, 2.0]) * 1e-3
    slope = np.array([1.0, -8.0, 8.0, -1.0]) @ law.energy(0.5 + steps) / 12e-3
    assert slope == pytest.approx(law.force(0.5), rel=1e-9)


@pytest.mark.parametrize("stress", [0.1, 5.0])
def test_attraction_begins_at_a_distance_and_a_cycle_loses_what_the_loop_does(stress):
    contact = contact_with(PARABOLOID, FILM, stress)
    law = mdr.ContactLaw(contact, 0.5)
    first = -WORK / stress
    assert law.force(first * (1.0 + 1e-12), branch="loading") == 0.0
    assert law.force(first * (1.0 - 1e-12), branch="loading") < 0.0
    assert law.at_depth(first * (1.0 - 1e-12), branch="loading").radius == 0.0 or stress > 1.0
    pull_off = contact.pull_off("depth").depth
    assert law.depth_range[0] == pytest.approx(pull_off, rel=1e-9)
    assert law.force(pull_off * (1.0 + 1e-9)) == 0.0
    jump_in = -law.energy(first * (1.0 - 1e-14), branch="loading")
    separation = law.energy(pull_off * (1.0 - 1e-13))
    assert jump_in + separation == pytest.approx(contact.loop("depth", 0.5, 40).dissipated_energy, rel=1e-5, abs=1e-7)


def test_jkr_is_the_limit_of_a_large_stress():
    jkr = mdr.ContactLaw(mdr.Contact(PARABOLOID, FILM, work_of_adhesion=WORK), LARGEST)
    d = np.linspace(0.0, LARGEST, 7)
    differences = []
    for stress in (100.0, 200.0):
        law = mdr.ContactLaw(contact_with(PARABOLOID, FILM, stress), LARGEST)
        differences.append(abs(law.force(d) - jkr.force(d)).max())
    assert differences[0] / differences[1] == pytest.approx(4.0, rel=1e-2)


def test_files_keep_it(tmp_path):
    law = mdr.ContactLaw(contact_with(PARABOLOID, FILM, 0.3), LARGEST, continue_beyond=True)
    law.save(tmp_path / "zone.mdrlaw")
    again = mdr.ContactLaw.load(tmp_path / "zone.mdrlaw")
    d = np.linspace(-2.0, LARGEST, 101)
    for other in (again, pickle.loads(pickle.dumps(law))):
        assert other == law
        for branch in ("loading", "unloading"):
            assert np.array_equal(other.force(d, branch=branch), law.force(d, branch=branch))
            assert np.array_equal(other.energy(d, branch=branch), law.energy(d, branch=branch))


def test_refusals():
    contact = contact_with(mdr.Sphere(1.0), HALF_SPACE, 3.0)
    with pytest.raises(mdr.errors.DomainError, match=r"^largest_depth"):
        mdr.ContactLaw(contact, 50.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="with adhesion"):
        mdr.ContactLaw(contact_with(PARABOLOID, HALF_SPACE, 0.3), LARGEST).with_radius(2.0)
