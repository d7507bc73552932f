# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of constant shear strength: the closed form, adhesion, files, the command, refusals."""

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.cli import main

TAU = 2e4
GLASS = mdr.Elastic(1e6, 0.49)


@pytest.fixture(scope="module")
def contact():
    return mdr.Contact(mdr.Paraboloid(1e-3), mdr.Homogeneous(GLASS), work_of_adhesion=0.05)


@pytest.fixture(scope="module")
def law(contact):
    return mdr.ContactLaw(contact, 2e-5, shear_strength=TAU, sliders=16, tolerance=1e-7)


def test_facts(law):
    assert (law.shear_strength, law.coefficient, law.sliders, law.path_error) == (TAU, None, 16, None)
    assert law.memory_size == 11 + 4 * 16
    assert 1e-5 < law.first_shear_error < 1e-3


def test_first_shear_is_the_closed_form(law):
    state = law.at_depth(np.array([2e-5, 5e-6, -1e-6]))
    assert state.force[2] < 0  # under tension
    memory = law.contacts(3)
    law.advance(memory, state.radius, np.zeros((3, 2)))
    G_t = 4 * 1e6 / (2 * 1.49) / (2 - 0.49)
    limit = np.pi * state.radius**2 * TAU
    unit = 2 * TAU * state.radius / G_t
    assert law.largest_sliding_shift == pytest.approx(unit[0], rel=0.2)
    for y in np.linspace(0.02, 1, 50):
        T = law.advance(memory, state.radius, np.outer(0.02 * unit, [0.6, 0.8]))
        exact = 2 / np.pi * (y * np.sqrt(max(1 - y**2, 0)) + np.arcsin(min(y, 1)))
        np.testing.assert_allclose(T, np.outer(limit * exact, [0.6, 0.8]), atol=1e-3 * limit.max())
        np.testing.assert_allclose(np.hypot(*T.T) / limit, exact, atol=1e-3)
    np.testing.assert_allclose(np.hypot(*T.T), limit, rtol=1e-12)


def test_the_derivative_by_the_radius(law):
    memory = law.contacts(1)
    law.advance(memory, [1e-4], [[0.0, 0.0]])
    radius, shift = 1.01e-4, [[4e-7, 3e-7]]
    T, stiffness, by_radius = law.attempt(memory, [radius], shift, tangent=True)
    up, down = (law.attempt(memory, [radius * (1 + step)], shift) for step in (1e-6, -1e-6))
    np.testing.assert_allclose(by_radius, (up - down) / (2e-6 * radius), rtol=1e-6)
    assert stiffness.shape == (1, 2, 2) and np.hypot(*T[0]) < np.pi * radius**2 * TAU


def test_file_and_copy(law, tmp_path):
    path = tmp_path / "glass.law"
    law.save(path)
    again = mdr.ContactLaw.load(path)
    assert again == law and again.shear_strength == TAU
    memory, other = law.contacts(1), again.contacts(1)
    for shift in ([3e-7, 0.0], [-5e-7, 1e-7]):
        assert law.advance(memory, [1e-4], [shift]).tolist() == again.advance(other, [1e-4], [shift]).tolist()
    assert memory.tolist() == other.tolist()


def test_refusals(contact, law):
    memory = law.contacts(1)
    law.advance(memory, [1e-4], [[1e-7, 0.0]])
    before = memory.copy()
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 1 of force"):
        law.advance(memory, [-1e-4], [[0.0, 0.0]])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="shift"):
        law.advance(memory, [1e-4], [[np.nan, 0.0]])
    with pytest.raises(mdr.errors.DomainError, match="largest contact radius"):
        law.advance(memory, [1.0], [[0.0, 0.0]])
    other = mdr.ContactLaw(contact, 2e-5, shear_strength=2 * TAU, sliders=16, tolerance=1e-7)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="memory"):
        other.advance(memory, [1e-4], [[0.0, 0.0]])
    assert memory.tolist() == before.tolist()
    for wrong in (0.0, -1.0, np.nan):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="shear_strength"):
            mdr.ContactLaw(contact, 2e-5, shear_strength=wrong)
    free = mdr.Contact(mdr.Paraboloid(1e-3), mdr.Homogeneous(GLASS))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="it excludes options.friction"):
        mdr.ContactLaw(free, 2e-5, friction=mdr.Friction(free, 0.3), shear_strength=TAU)
    film = mdr.Contact(mdr.Paraboloid(1e-3), mdr.Coated(mdr.Elastic(2e6, 0.3), 1e-5, GLASS, "gao"))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="shear_strength = 20000: it is available on homogeneous"):
        mdr.ContactLaw(film, 2e-6, shear_strength=TAU)


def test_command(tmp_path, capsys):
    problem = tmp_path / "glass.toml"
    problem.write_text(
        'title = "glass on rubber"\n[indenter]\nshape = "paraboloid"\nradius = "1 mm"\n'
        '[medium]\ntype = "homogeneous"\n[medium.material]\nE = "1 MPa"\nnu = 0.49\n'
        '[adhesion]\nwork_of_adhesion = "50 mJ/m^2"\n[compute]\nmax_depth = "20 um"\n'
    )
    path = tmp_path / "glass.law"
    assert main(["law", str(problem), str(path), "--shear-strength", "20 kPa", "--sliders", "16", "--tolerance", "1e-6"]) == 0
    assert "16, 75 numbers a contact" in capsys.readouterr().out
    assert mdr.ContactLaw.load(path).shear_strength == pytest.approx(TAU)
