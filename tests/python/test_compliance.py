# SPDX-License-Identifier: GPL-3.0-or-later
"""What a surface answers to a wave of load: closed forms, limits, and the depth of a contact from its line load."""

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.conduction import Conduction, Conductor

STEEL, POLYMER = mdr.Elastic(210.0, 0.3), mdr.Elastic(3.0, 0.4)
K = np.geomspace(1e-4, 1e4, 17)


def shear(material):
    return material.E / (2.0 + 2.0 * material.nu)


def half_space(material, load):
    nu = material.nu
    return {"normal": 1.0 - nu, "shear": 1.0 - 0.5 * nu, "twist": 1.0}[load] / (shear(material) * K)


@pytest.mark.parametrize("load", ["normal", "shear", "twist"])
def test_homogeneous_bodies_and_pairs(load):
    one, other = mdr.Homogeneous(STEEL), mdr.Homogeneous(POLYMER)
    np.testing.assert_allclose(one.compliance(K, load), half_space(STEEL, load), 1e-15)
    both = half_space(STEEL, load) + half_space(POLYMER, load)
    np.testing.assert_allclose(mdr.Pair(one, other).compliance(K, load), both, 1e-15)
    film = mdr.Coated(STEEL, 0.3, POLYMER)
    together = film.compliance(K, load) + one.compliance(K, load)
    np.testing.assert_allclose(mdr.Pair(one, film).compliance(K, load), together, 1e-15)


@pytest.mark.parametrize("load", ["normal", "shear", "twist"])
@pytest.mark.parametrize("model", ["exact", "gao", "bec"])
def test_long_waves_see_the_substrate_and_short_ones_the_film(load, model):
    film = mdr.Coated(STEEL, 0.3, POLYMER, model)
    np.testing.assert_allclose(film.compliance(K[-4:], load), half_space(STEEL, load)[-4:], 1e-14)
    np.testing.assert_allclose(film.compliance(1e-9, load) * 1e-9, half_space(POLYMER, load)[0] * K[0], 1e-6)


def test_a_twisted_film_has_its_closed_form():
    """(y + tanh kh)/(1 + y tanh kh)/(G k), y = G/G_substrate; on a rigid base tanh kh."""
    t, y = np.tanh(0.3 * K), shear(STEEL) / shear(POLYMER)
    found = mdr.Coated(STEEL, 0.3, POLYMER).compliance(K, "twist")
    np.testing.assert_allclose(found, (y + t) / (1.0 + y * t) / (shear(STEEL) * K), 1e-13)
    found = mdr.Layered([(STEEL, 0.3)], mdr.RIGID).compliance(K, "twist")
    np.testing.assert_allclose(found, t / (shear(STEEL) * K), 1e-13)


def test_a_viscoelastic_body_at_a_frequency():
    """1/(G k) with the complex modulus of its material; relaxed at 0; loss makes imaginary parts negative."""
    gel = mdr.Viscoelastic(1e3, [(2e3, 0.1)], nu=0.5)
    body, omega = mdr.Homogeneous(gel), 7.0
    G = gel.complex_modulus(omega)
    np.testing.assert_allclose(body.compliance(K, "twist", omega), 1.0 / (G * K), 1e-14)
    np.testing.assert_allclose(body.compliance(K, "twist"), 1.0 / (1e3 * K), 1e-14)
    film = mdr.Coated(gel, 0.3, STEEL).compliance(K, "normal", omega)
    assert np.all(film.imag < 0.0)
    np.testing.assert_allclose(film[-4:], 0.5 / (G * K[-4:]), 1e-14)


def depth_by_waves(contact, state, medium, modulus):
    """d = q(0)/E0* + int (C - 2/(E0* k)) k p(k) dk, p(k) = (1/pi) int_0^a q cos kx dx."""
    a = state.radius
    x, w = np.polynomial.legendre.leggauss(200)
    x, w = 0.5 * a * (x + 1.0), 0.5 * a * w
    q = contact.at_depth(state.depth).line_load(x)
    t, v = np.polynomial.legendre.leggauss(40)
    # k from 0 to where the film is deep: exp(-2 k h) is below rounding
    k, v = (np.arange(80)[:, None] + 0.5 * (t + 1.0)).ravel(), np.tile(0.5 * v, 80)
    p = np.cos(np.outer(k, x)) @ (w * q) / np.pi
    own = 2.0 / (modulus * k)
    return float(contact.at_depth(state.depth).line_load(0.0)) / modulus + float(np.sum(v * (medium.compliance(k) - own) * k * p))


@pytest.mark.parametrize("tip", [mdr.Paraboloid(1.0), mdr.Cone(0.3), mdr.FlatPunch(0.7)])
@pytest.mark.parametrize("stack", [[(STEEL, 1.0)], [(POLYMER, 0.6), (STEEL, 0.5)]])
def test_the_line_load_gives_the_depth(tip, stack):
    medium = mdr.Layered(stack, mdr.Elastic(70.0, 0.2))
    contact = mdr.Contact(tip, medium)
    state = contact.at_depth(0.2)
    surface = stack[0][0]
    found = depth_by_waves(contact, state, medium, surface.E / (1.0 - surface.nu**2))
    assert found == pytest.approx(state.depth, rel=1e-9)


@pytest.mark.parametrize("drainage", ["surface", "sealed"])
def test_a_gel_is_stiff_at_once_and_drained_at_last(drainage):
    """The elastic bodies of nu = 1/2 and of the drained nu, of half-space and film; in between both, with loss."""
    gel = mdr.poroelastic.Poroelastic(2.0, 0.2, 3.0)
    fast, slow = mdr.Elastic(6.0, 0.5), mdr.Elastic(4.8, 0.2)
    k = np.geomspace(0.02, 50.0, 9)
    for body, elastic in ((mdr.Homogeneous, mdr.Homogeneous), (_film, _film)):
        of_gel = body(gel).compliance(k, omega=1e14, drainage=drainage)
        np.testing.assert_allclose(of_gel.real, elastic(fast).compliance(k), rtol=3e-3)
        for omega in (0.0, 1e-9):
            of_gel = body(gel).compliance(k, omega=omega, drainage=drainage)
            np.testing.assert_allclose(of_gel.real, elastic(slow).compliance(k), rtol=1e-5)
        middle = body(gel).compliance(k, omega=3.0, drainage=drainage)
        assert np.all(middle.imag < 0.0)
        assert np.all(middle.real <= elastic(slow).compliance(k) * (1.0 + 1e-9))
    # waves much shorter than a film is thick see a half-space, at any frequency
    short = np.geomspace(40.0, 400.0, 5)
    films = _film(gel).compliance(short, omega=3e4, drainage=drainage)
    np.testing.assert_allclose(films, mdr.Homogeneous(gel).compliance(short, omega=3e4, drainage=drainage), rtol=1e-9)


def _film(material):
    return mdr.Coated(material, 0.7, mdr.RIGID)


def test_a_gel_says_what_it_needs():
    body = mdr.Homogeneous(mdr.poroelastic.Poroelastic(2.0, 0.2, 3.0))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="drainage is missing"):
        body.compliance(1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="does not depend on the contact"):
        body.compliance(1.0, drainage="indenter")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="normal load"):
        body.compliance(1.0, "shear", drainage="sealed")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="no pores"):
        mdr.Homogeneous(STEEL).compliance(1.0, drainage="sealed")


def test_a_wave_of_flux_has_its_closed_forms():
    """1/(sqrt(sigma along) k); a film by tanh; of two bodies the sum; at a frequency sqrt(k^2 + i omega c/sigma)."""
    copper, oxide = Conductor(60.0, 15.0, 2.0), Conductor(2.0)
    np.testing.assert_allclose(Conduction(copper).compliance(K), 1.0 / (30.0 * K), 1e-14)
    film = mdr.Elastic(70.0, 0.2, oxide)
    body = mdr.Coated(film, 0.3, mdr.Elastic(120.0, 0.3, copper))
    t, y = np.tanh(0.3 * K), 2.0 / 30.0
    closed = (y + t) / (1.0 + y * t) / (2.0 * K)
    np.testing.assert_allclose(body.compliance(K, "flux"), closed, 1e-13)
    both = mdr.Pair(body, mdr.Homogeneous(mdr.Elastic(120.0, 0.3, copper)))
    np.testing.assert_allclose(both.compliance(K, "flux"), closed + 1.0 / (30.0 * K), 1e-13)
    isotropic = Conductor(60.0, None, 2.0)
    found = Conduction(isotropic).compliance(K, 7.0)
    np.testing.assert_allclose(found, 1.0 / (60.0 * np.sqrt(K**2 + 7.0j * 2.0 / 60.0)), 1e-13)
    with pytest.raises(TypeError, match="no conductivity"):
        mdr.Homogeneous(STEEL).compliance(1.0, "flux")


def test_bad_input_is_refused():
    body = mdr.Homogeneous(STEEL)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean 'normal'"):
        body.compliance(1.0, "norml")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="entry 2 of k = -1"):
        body.compliance([1.0, -1.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="omega = -1"):
        body.compliance(1.0, omega=-1.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="only an effective modulus"):
        mdr.TabulatedMedium([0.1, 0.5, 1.0], [1.0, 1.5, 2.0]).compliance(1.0)
    assert body.compliance([]).shape == (0,)
    assert isinstance(body.compliance(1.0), float)
