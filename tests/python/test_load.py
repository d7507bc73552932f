# SPDX-License-Identifier: GPL-3.0-or-later
"""The load of a state: solved once for all that is read from it, kept with it, and independent of what becomes of the contact."""

import copy
import gc
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import numbers_of

import mdrcontact as mdr
from mdrcontact import _boundary, _layout
from mdrcontact._boundary import native
from mdrcontact.errors import InvalidArgumentError

FILM = mdr.Coated(coating=mdr.Elastic(3.0, 0.3), thickness=1.0, substrate=mdr.Elastic(1.0, 0.4))


def contact():
    return mdr.Contact(mdr.RoundedCone(0.3, 0.2), FILM)


@pytest.fixture
def solved(monkeypatch):
    """The states that loads are made of."""
    found = []
    make = native.contact_load

    def counted(handle, row):
        found.append(tuple(row))
        return make(handle, row)

    monkeypatch.setattr(native, "contact_load", counted)
    return found


def test_is_solved_once_for_all_that_is_read(solved):
    state = contact().at_radius(1.0)  # looked at for whether it is one disc
    state.pressure([0.0, 0.5])
    state.displacement(2.0)
    state.line_load(0.3)
    state.energy()
    state.lowest_pressure()
    state.interior(0.2, 0.3)
    state.critical()
    mdr.Friction(state.contact, 0.3).shear(state).at_shift(1e-3)
    assert solved == [tuple(numbers_of(state))]


def test_is_one_for_all_threads():
    state = contact().at_radius(1.0)
    places = np.linspace(0.0, 0.99, 50)
    alone = contact().at_radius(1.0).pressure(places)
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda _: (state.pressure(places), state._load), range(64)))
    assert all(np.array_equal(pressure, alone) for pressure, _ in found)
    assert len({id(load) for _, load in found}) == 1


def test_outlives_its_contact():
    owner = contact()
    state = owner.at_radius(1.0)
    load, before = state._load, state.pressure(0.5)
    del owner, state
    gc.collect()
    status, pressure = native.load_field(load, _layout.PRESSURE, np.array([0.5]))
    assert (status, pressure[0]) == (0, before)


def test_does_not_travel_with_copies():
    state = contact().at_radius(1.0)
    state.pressure(0.5)
    for other in (copy.copy(state), copy.deepcopy(state), pickle.loads(pickle.dumps(state)), state.replace(zone_radius=0.0)):
        assert other == state
        assert "_kept" not in vars(other)
        assert other.pressure(0.5) == state.pressure(0.5)


def test_several_states_have_one_each(solved):
    states = contact().at_radius([0.5, 1.0, 2.0])
    places = np.array([[0.1, 0.4], [0.1, 0.9], [0.1, 1.9]])
    solved.clear()
    pressure, energy = states.pressure(places), states.energy()
    assert len(solved) == 6
    for i in range(3):
        assert np.array_equal(pressure[i], states[i].pressure(places[i]))
        assert energy[i] == states[i].energy()


def test_a_load_that_fails_is_refused_again():
    """Nothing is kept."""
    state = contact().at_radius(1.0).replace(radius=-1.0)
    for _ in range(2):
        with pytest.raises(InvalidArgumentError, match="contact radius of the state"):
            state.pressure(0.0)
    assert "_kept" not in vars(state)


def test_a_handle_that_could_not_be_made_frees_nothing():
    with pytest.raises(InvalidArgumentError):
        _boundary.Handle(native.contact_load(contact()._handle, [0.0] * 6))
    gc.collect()
