# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled contact laws from Python: values, shapes, pickles, files, threads, refusals."""

import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import OXIDE, ROOT, SILICON

import mdrcontact as mdr
from mdrcontact.cli import main

CONTACT = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Coated(OXIDE, 5e-7, SILICON, "exact"))

SILICON_BODY = mdr.Homogeneous(SILICON)


@pytest.fixture(scope="module")
def law():
    return mdr.ContactLaw(CONTACT, 1e-7)


def test_values_are_the_contacts(law):
    depth = np.geomspace(1e-11, 1e-7, 50)
    exact, state = CONTACT.at_depth(depth), law.at_depth(depth)
    for name in ("force", "radius", "stiffness"):
        np.testing.assert_allclose(getattr(state, name), getattr(exact, name), rtol=1e-9)
    np.testing.assert_allclose(state.slope, exact.stiffness, rtol=1e-7)
    np.testing.assert_allclose(law.at_force(exact.force[1:-1]).depth, depth[1:-1], rtol=1e-9)
    np.testing.assert_allclose(law.at_force(exact.force[1:-1]).slope, exact.stiffness[1:-1], rtol=1e-7)


@pytest.mark.parametrize(
    ("contrast", "thickness", "model", "angle", "work", "largest"),
    [(360.0, 0.2, "mencik-exponential", 0.6, 0.9, 0.2), (50.0, 2.5, "exact", 0.8, 4.0, 0.4)],
    ids=["depth falls", "force falls"],
)
def test_states_beyond_a_jump_at_less_depth(contrast, thickness, model, angle, work, largest):
    """Beyond the largest depth depth or force fall below it: a contact that unloads comes from there, and so does its law."""
    body = mdr.Coated(mdr.Elastic(contrast, 0.3), thickness, mdr.Elastic(1.0, 0.3), model)
    contact = mdr.Contact(mdr.Cone(angle), body, work_of_adhesion=work)
    law = mdr.ContactLaw(contact, largest, tolerance=1e-7)
    depth, force = (np.linspace(low, high, 41)[1:-1] for low, high in (law.depth_range, law.force_range))
    exact, state = contact.at_depth(depth), law.at_depth(depth)
    assert np.abs(exact.force - state.force) == pytest.approx(0.0, abs=1e-7 * np.abs(exact.force).max())
    np.testing.assert_allclose(state.radius, exact.radius, rtol=1e-6)
    exact, state = contact.at_force(force), law.at_force(force)
    assert np.abs(exact.depth - state.depth) == pytest.approx(0.0, abs=1e-7 * np.abs(exact.depth).max())
    np.testing.assert_allclose(state.radius, exact.radius, rtol=1e-6)


def test_slope_where_depth_falls_under_a_growing_force():
    body = mdr.Coated(mdr.Elastic(1000.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "doerner-nix")
    contact = mdr.Contact(mdr.RoundedCone(0.84, 0.93), body, work_of_adhesion=body.modulus(1.0))
    law = mdr.ContactLaw(contact, 0.3, tolerance=1e-8)
    force, step = 2.0, 1e-4
    near = law.at_force(np.array([force - step, force + step]), "loading").depth
    assert near[1] < near[0]
    assert law.at_force(force, "loading").slope == pytest.approx(2.0 * step / (near[1] - near[0]), rel=1e-6)


def test_a_medium_that_begins_late():
    """Under a plate contacts begin at a radius of their own: there the law begins, unless a smaller depth is given."""
    plate = mdr.Homogeneous(mdr.Elastic(0.42, 0.3), surface=mdr.Surface(0.7, 0.3))
    contact = mdr.Contact(mdr.Paraboloid(1.0), plate)
    law = mdr.ContactLaw(contact, 2.0, tolerance=1e-8)
    first = law.depth_range[0]
    assert 0.1 < first < 1.0
    depth = np.linspace(first * 1.001, 2.0, 9)
    np.testing.assert_allclose(law.force(depth), contact.at_depth(depth).force, rtol=1e-8)
    assert 0.0 < law.force(0.5 * first) < law.force(first)
    with pytest.raises(mdr.errors.UnreachableError, match=r"smallest_depth = 0.1: .* Omit smallest_depth to begin there"):
        mdr.ContactLaw(contact, 2.0, smallest_depth=0.1)
    with pytest.raises(mdr.errors.UnreachableError, match=r"largest_depth = .* the medium begins at depth .* at least twice that"):
        mdr.ContactLaw(contact, 1.5 * first)


def test_facts(law):
    assert law.solutions <= 200
    assert law.error <= law.tolerance == 1e-9
    assert law.depth_range[0] <= 1e-11
    assert law.depth_range[1] >= 1e-7
    assert law.description == repr(CONTACT)
    assert "Paraboloid" in repr(law)


def test_shapes_and_zeros(law):
    depth = np.array([[-1e-9, 0.0, 1e-9], [5e-8, 1e-7, 1e-12]])
    force = law.force(depth)
    assert force.shape == depth.shape
    assert force[0, 0] == force[0, 1] == 0.0
    assert isinstance(law.force(1e-8), float)
    assert law.force(1e-8) == law.force(np.array([1e-8]))[0]
    assert law.force([]).shape == (0,)


def test_pickle_and_file(law, tmp_path):
    law.save(tmp_path / "law")
    for other in (pickle.loads(pickle.dumps(law)), mdr.ContactLaw.load(tmp_path / "law")):
        assert other == law
        assert hash(other) == hash(law)
        assert other.force(3e-8) == law.force(3e-8)
        assert other.description == law.description


def test_damage_is_refused_with_its_reason(law, tmp_path):
    content = bytearray(law.to_bytes())
    content[len(content) // 3] ^= 1
    (tmp_path / "law").write_bytes(content)
    with pytest.raises(mdr.errors.FileError, match="law cannot be used: its checksum"):
        mdr.ContactLaw.load(tmp_path / "law")
    with pytest.raises(mdr.errors.FileError, match="none cannot be read: No such file"):
        mdr.ContactLaw.load(tmp_path / "none")
    for wrong, reason in [(b"", "not a compiled"), (b"PK\3\4", "not a compiled"), (law.to_bytes()[:-40], "truncated")]:
        with pytest.raises(mdr.errors.FileError, match=reason):
            mdr.ContactLaw.from_bytes(wrong)


def test_threads_agree(law):
    depth = np.geomspace(1e-11, 1e-7, 200_000)
    one = law.force(depth)
    mdr.set_threads(2)
    np.testing.assert_array_equal(law.force(depth), one)
    mdr.set_threads(1)
    with ThreadPoolExecutor(4) as pool:
        for found in pool.map(lambda _: law.force(depth), range(8)):
            np.testing.assert_array_equal(found, one)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda law: law.force(2e-7), "compiled up to"),
        (lambda law: law.force([1e-8, np.nan]), "entry 2 of depth = NaN"),
        (lambda law: law.force(-np.inf), "^depth = "),
        (lambda law: law.force(1e-8, branch="loding"), "branch = 'loding': did you mean 'loading'"),
        (lambda law: law.at_force(-1.0), "the lowest force"),
        (lambda law: mdr.ContactLaw(CONTACT, -1.0), "largest_depth"),
        (lambda law: mdr.ContactLaw(CONTACT, 1e-7, smallest_depth=0.0), "smallest_depth"),
        (lambda law: mdr.ContactLaw(CONTACT, 1e-7, tolerance=0.0), "tolerance"),
    ],
)
def test_refusals(law, call, words):
    with pytest.raises(ValueError, match=words):
        call(law)


@pytest.mark.parametrize("radius", [3e-6, 1e-5, 4.4e-5])
def test_one_law_for_all_radii(radius):
    medium = mdr.Pair(mdr.Coated(OXIDE, 5e-7, SILICON, "exact"), mdr.Coated(SILICON, 3e-7, OXIDE, "exact"))
    made = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), medium), 1e-7, tolerance=1e-10)
    law = pickle.loads(pickle.dumps(made)).with_radius(radius)
    largest = 1e-7 * 1e-5 / radius
    direct = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(radius), medium), largest, tolerance=1e-10)
    np.testing.assert_allclose(law.depth_range, direct.depth_range, rtol=1e-9)
    depth = np.geomspace(1e-4, 0.999, 50) * largest
    found, expected = law.at_depth(depth), direct.at_depth(depth)
    for name in ("force", "radius", "stiffness"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-9)
    np.testing.assert_allclose(law.at_force(expected.force).depth, depth, rtol=1e-9)


def test_other_radius_is_refused_with_the_reason(law):
    cone = mdr.ContactLaw(mdr.Contact(mdr.Cone(0.1), SILICON_BODY), 1e-7)
    sticky = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), SILICON_BODY, work_of_adhesion=0.1), 1e-7)
    for one, radius, words in [(law, 0.0, "radius = 0"), (cone, 1e-5, "not that of a paraboloid"), (sticky, 1e-5, "adhesion")]:
        with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
            one.with_radius(radius)


def test_branches_are_given_as_to_a_contact(law):
    for call in (law.force, law.at_depth, CONTACT.at_depth):
        np.testing.assert_array_equal(call(1e-8, "loading"), call(1e-8, branch="loading"))
    assert law.at_force(1e-6, "loading") == law.at_force(1e-6, branch="loading")


def test_wrong_kinds(law):
    with pytest.raises(TypeError, match="Contact"):
        mdr.ContactLaw("contact", 1.0)


def test_law_of_an_exact_film_is_cheap_and_verified():
    film = mdr.Coated(mdr.Elastic(400e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.3), "exact")
    law = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(100e-6), film), largest_depth=300e-9)
    assert law.at_depth(100e-9).force > 0.0 and law.error < 1e-9 and law.solutions <= 200


def test_scalars_are_the_numbers_of_arrays(law):
    for depth in (-1e-9, 0.0, 3e-12, 4e-8, np.float64(5e-8), 1e-7):
        array = law.at_depth(np.array([depth]))
        assert law.force(depth) == array.force[0]
        assert tuple(law.at_depth(depth)) == tuple(column[0] for column in array)
    assert isinstance(law.at_depth(1e-8), mdr.LawState)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="depth = NaN"):
        law.force(float("nan"))


def test_energy_is_the_integral_of_the_force(law):
    depth = np.linspace(0.0, 1e-7, 2001)
    force = law.force(depth)
    simpson = (force[:-2:2] + 4.0 * force[1::2] + force[2::2]).sum() * 5e-11 / 3.0
    assert law.energy(1e-7) == pytest.approx(simpson, rel=1e-6)
    assert law.energy([-1e-8, 0.0]).tolist() == [0.0, 0.0]


def test_one_hard_collision_does_not_end_a_run():
    law = mdr.ContactLaw(CONTACT, 1e-7, continue_beyond=True)
    end = law.depth_range[1]
    last = law.at_depth(end)
    for other in (law, pickle.loads(pickle.dumps(law))):
        with pytest.warns(mdr.errors.BeyondRangeWarning, match="1 of 2 values of depth lie beyond"):
            force = other.force([1e-8, end + 1e-8])
        assert force[1] == pytest.approx(last.force + 1e-8 * last.slope, rel=1e-12)
        with pytest.warns(mdr.errors.BeyondRangeWarning):
            assert other.force(end + 1e-8) == force[1]
        with pytest.warns(mdr.errors.BeyondRangeWarning) as shown:
            other.at_depth(end + 1e-8), other.energy([end + 1e-8])
        assert [one.filename for one in shown] == [__file__] * 2
        with pytest.warns(mdr.errors.BeyondRangeWarning, match="force"):
            assert other.at_force(float(force[1])).depth == pytest.approx(end + 1e-8, rel=1e-7)


@pytest.mark.parametrize("tolerance", [1e-5, 5e-7, 1e-9])
@pytest.mark.parametrize("indenter", [mdr.Paraboloid(1.0), mdr.Cone(0.3), mdr.PowerLaw(1.0, 3.0)], ids=repr)
def test_adhesive_laws_keep_their_promise(indenter, tolerance):
    """Relative to |F| + |d dF/dd|, and to |d| + |F dd/dF|, everywhere along the branch."""
    film = mdr.Coated(mdr.Elastic(3.0, 0.3), 0.5, mdr.Elastic(1.0, 0.4), "gao")
    contact = mdr.Contact(indenter, film, work_of_adhesion=0.02)
    law = mdr.ContactLaw(contact, 1.0, tolerance=tolerance)
    for name, (low, high) in (("depth", law.depth_range), ("force", law.force_range)):
        given = low + (high - low) * np.linspace(1e-3, 0.999, 700) ** 3
        exact, found = (getattr(one, f"at_{name}")(given) for one in (contact, law))
        swing = np.abs(exact.depth * found.slope) + np.abs(exact.force)
        assert np.all(np.abs(found.force - exact.force) <= tolerance * swing)
        assert np.all(np.abs(found.depth - exact.depth) * found.slope <= tolerance * swing)


def test_command_makes_the_law_of_a_problem(tmp_path, capsys):
    (tmp_path / "problem.toml").write_text((ROOT / "examples" / "problems" / "tin_on_steel.toml").read_text(encoding="utf-8"))
    problem, path = str(tmp_path / "problem.toml"), tmp_path / "film.law"
    assert main(["law", problem, str(path), "--tolerance", "1e-7", "--continue-beyond"]) == 0
    assert "tolerance 1e-07" in capsys.readouterr().out
    law = mdr.ContactLaw.load(path)
    assert 50e-9 <= law.depth_range[1] < 52e-9
    assert "TiN" in law.description
    film = mdr.Coated(mdr.Elastic(445e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.3), "exact")
    assert law.force(30e-9) == pytest.approx(mdr.Contact(mdr.Sphere(100e-6), film).at_depth(30e-9).force, rel=1e-7)
    assert main(["law", problem, str(path)]) == 1
    assert "--overwrite" in capsys.readouterr().err
    assert main(["law", problem, str(path), "--overwrite", "--largest-depth", "200 nm"]) == 0
    assert mdr.ContactLaw.load(path).depth_range[1] >= 200e-9
    assert main(["law", problem, str(path), "--overwrite", "--largest-depth", "200"]) == 2
    assert "--largest-depth: '200' has no unit" in capsys.readouterr().err
