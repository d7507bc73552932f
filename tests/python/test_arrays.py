# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes and types in and out."""

import dataclasses
from fractions import Fraction

import numpy as np
import pytest
from conftest import OXIDE, SILICON, every_medium, every_profile, numbers_of

import mdrcontact as mdr


@pytest.mark.parametrize("shape", [(1,), (7,), (2, 3), (2, 1, 3), (0,), (3, 0)])
def test_any_shape(coated, shape):
    depth = np.full(shape, 1e-8)
    state = coated.at_depth(depth)
    assert all(entry.shape == shape and entry.dtype == np.float64 for entry in numbers_of(state))
    assert coated.medium.modulus(depth).shape == shape
    assert coated.indenter.mdr(depth).shape == shape
    assert coated.at_depth(1e-8).pressure(depth).shape == shape
    assert mdr.weights.weight_i0(depth).shape == shape


@pytest.mark.parametrize("value", [1, 1.0, np.float32(1.0), np.int16(1), np.array(1.0)])
def test_a_number_gives_a_float(value):
    assert type(mdr.weights.weight_phi(value)) is float
    assert type(mdr.Cone(0.2).height(value)) is float
    state = mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(mdr.Elastic(1.0, 0.2))).at_depth(value)
    assert all(type(entry) is float for entry in numbers_of(state))


def test_values_do_not_depend_on_memory_layout(coated):
    depth = np.arange(1.0, 13.0).reshape(3, 4) * 1e-8
    expected = np.array([[coated.at_depth(d).force for d in row] for row in depth])
    strided = np.repeat(depth, 2, axis=1)[:, ::2]
    for same in (depth.tolist(), np.asfortranarray(depth), depth[::-1][::-1], depth.astype(">f8"), strided):
        assert np.array_equal(coated.at_depth(same).force, expected)


def test_input_is_left_alone(coated):
    depth = np.array([1e-8, 2e-8])
    depth.flags.writeable = False
    state = coated.at_depth(depth)
    assert state.depth is not depth
    assert np.array_equal(depth, [1e-8, 2e-8])
    state.force[:] = 0.0
    assert coated.at_depth(depth).force[0] > 0.0


WRONG = ["1e-8", b"1", None, 1e-8 + 0j, [1e-8, None], ["1e-8"], True, [True], Fraction(1, 2), {1: 2}, [[1.0], [1.0, 2.0]]]


@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_not_a_real_number_is_refused(coated, wrong):
    for function in (coated.at_depth, coated.medium.modulus, coated.indenter.height, mdr.weights.weight_i1):
        with pytest.raises(mdr.errors.ArgumentTypeError) as caught:
            function(wrong)
        assert isinstance(caught.value, TypeError)


def test_masked_elements_are_refused(coated):
    with pytest.raises(mdr.errors.ArgumentTypeError, match="masked"):
        coated.at_depth(np.ma.masked_array([1e-8, 2e-8], [False, True]))


def test_a_state_is_a_record(coated):
    state = coated.at_depth(1e-8)
    again = mdr.State(*numbers_of(state), coated)
    assert again == state and hash(again) == hash(state)
    assert again != mdr.State(*numbers_of(state)) and again != state.replace(depth=2e-8)
    assert repr(state) == repr(mdr.State(*numbers_of(state))) and repr(state).startswith("State(depth=1e-08, radius=")
    assert [field.name for field in dataclasses.fields(state)] == [
        "depth",
        "radius",
        "force",
        "stiffness",
        "punch_depth",
        "zone_radius",
    ]
    with pytest.raises(AttributeError):
        state.depth = 0.0


@pytest.mark.parametrize("taken", [len, iter, list, tuple, dict, lambda state: state[0], lambda state: [*state]])
def test_a_state_is_no_sequence(coated, taken):
    state = coated.at_depth(1e-8)
    with pytest.raises(TypeError, match="'State' object is not|of type 'State' has no len|not State"):
        taken(state)


def test_states_are_a_sequence_of_states(coated):
    depths = np.array([1e-8, 2e-8, 5e-8])
    states = coated.at_depth(depths)
    assert isinstance(states, mdr.States) and isinstance(states, mdr.State) and len(states) == 3
    for one, depth in zip(states, depths, strict=True):
        assert type(one) is mdr.State and one == coated.at_depth(depth)
    assert states[-1] == coated.at_depth(5e-8) and states[1:] == coated.at_depth(depths[1:])
    table = coated.at_depth(depths.reshape(3, 1))
    assert len(table) == 3 and [len(row) for row in table] == [1, 1, 1] and table[2, 0] == states[2]
    assert len(coated.at_depth([])) == 0 and list(coated.at_depth([])) == []
    with pytest.raises(TypeError, match="unhashable"):
        hash(states)


def test_table_has_named_columns_with_units(coated):
    states = coated.at_depth([[1e-8, 2e-8], [3e-8, 5e-8]])
    table = states.table()
    assert list(table) == list(table.units) == ["depth", "radius", "force", "stiffness", "slope", "punch_depth", "zone_radius"]
    assert {name: column.shape for name, column in table.items()} == dict.fromkeys(table, (4,))
    for name in table:
        np.testing.assert_array_equal(table[name], np.ravel(getattr(states, name)))
    assert table.units["force"] == "modulus length^2"
    assert {name: column.tolist() for name, column in states[0, 1].table().items()}["force"] == [states.force[0, 1]]


def test_data_frames_of_states(coated):
    """What pandas does with them: a frame of named columns, or a clear refusal."""
    pandas = pytest.importorskip("pandas")
    states = coated.at_depth([1e-8, 2e-8])
    assert list(pandas.DataFrame(states)) == [name for name in states.table() if name != "slope"]
    assert pandas.DataFrame(states).force.tolist() == states.force.tolist()
    assert list(pandas.DataFrame(states.table())) == list(states.table())
    with pytest.raises(TypeError, match="read depth, force and the like, or table"):
        pandas.DataFrame(coated.at_depth([[1e-8, 2e-8]]))


def test_states_are_an_array_of_records(coated):
    """As pandas takes them: a row for each, which is a dataclass."""
    states = coated.at_depth([1e-8, 2e-8])
    rows = np.asarray(states)
    assert rows.shape == (2,) and [dataclasses.asdict(row)["force"] for row in rows] == states.force.tolist()
    with pytest.raises(TypeError, match="read depth, force and the like, or table"):
        np.asarray(coated.at_depth([[1e-8, 2e-8]]))


@pytest.mark.parametrize("profile", every_profile(), ids=lambda p: type(p).__name__)
def test_every_profile_has_four_functions(profile):
    x = np.array([0.0, 1e-8, 1e-7])
    for name in ("height", "slope", "mdr", "mdr_slope"):
        values = getattr(profile, name)(x)
        assert values.shape == (3,) and np.all(np.isfinite(values)) and np.all(values >= 0.0)


@pytest.mark.parametrize("medium", every_medium(), ids=lambda m: f"{type(m).__name__}-{getattr(m, 'model', '')}")
def test_every_medium_has_a_modulus(medium):
    a = np.array([1e-7, 1e-6])
    assert np.all(medium.modulus(a) > 0.0)
    assert medium.stiffness(a) == pytest.approx(2 * a * medium.modulus(a), rel=1e-14)


@pytest.mark.parametrize("body", [mdr.Homogeneous(SILICON), mdr.Coated(OXIDE, 5e-7, SILICON, "exact")])
@pytest.mark.parametrize("gamma", [0.0, 0.1])
def test_fields_of_a_state(body, gamma):
    contact = mdr.Contact(mdr.Paraboloid(1e-5), body, work_of_adhesion=gamma)
    states = contact.at_depth([2e-8, 5e-8])
    state, r = states[1], np.linspace(0.0, 0.9, 5) * states.radius[1]
    others, several = contact.at_radius(state.radius), np.stack([0.5 * r, r])
    for name in ("pressure", "displacement", "line_load"):
        field = getattr(state, name)(r)
        np.testing.assert_array_equal(field, getattr(contact.at_depth(5e-8), name)(r))
        np.testing.assert_allclose(field, getattr(others, name)(r), rtol=1e-8)
        np.testing.assert_array_equal(getattr(states, name)(several)[1], field)
        assert getattr(states, name)([0.0, 0.0]).shape == (2,)
    np.testing.assert_array_equal(states.energy(), [one.energy() for one in (states[0], states[1])])
    np.testing.assert_array_equal(states[states.depth > 3e-8].depth, [5e-8])
    # the punch_depth is what the adhesive edge lacks of the non-adhesive depth
    plain = mdr.Contact(mdr.Paraboloid(1e-5), body).at_radius(state.radius)
    assert state.punch_depth == pytest.approx(state.depth - plain.depth, rel=1e-6, abs=1e-18)
    assert (state.punch_depth < 0.0) == (gamma > 0.0)


def test_what_is_no_state_is_refused(coated):
    states = coated.at_depth([1e-8, 2e-8])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="begin with that"):
        states.pressure(0.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match=r"states of shape \(2,\)"):
        states.lowest_pressure()
    with pytest.raises(mdr.errors.ArgumentTypeError, match="has no contact"):
        mdr.State(*numbers_of(states[0])).energy()
    with pytest.raises(mdr.errors.InvalidArgumentError, match="no contact"):
        coated.at_depth(0.0).pressure(0.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="punch_depth"):
        states[0].replace(punch_depth=float("nan")).pressure(0.0)


def test_a_flat_punch_is_all_excess():
    contact = mdr.Contact(mdr.FlatPunch(1e-6), mdr.Homogeneous(SILICON))
    state = contact.at_depth(1e-8)
    assert state.punch_depth == pytest.approx(1e-8)
    assert state.line_load(0.0) == pytest.approx(SILICON.contact_modulus * 1e-8)
