# SPDX-License-Identifier: GPL-3.0-or-later
"""What a surface answers to a wave of load: closed forms, limits, and the depth of a contact from its line load."""

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.special import gamma

import mdrcontact as mdr
from mdrcontact.conduction import Conduction, Conductor

STEEL, POLYMER = mdr.Elastic(210.0, 0.3), mdr.Elastic(3.0, 0.4)
K = np.geomspace(1e-4, 1e4, 17)


def shear(material):
    return material.E / (2.0 + 2.0 * material.nu)


def half_space(material, load):
    nu = material.nu
    return {"normal": 1.0 - nu, "shear": 1.0 - 0.5 * nu, "twist": 1.0, "coupling": 0.5 - nu}[load] / (shear(material) * K)


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


# layered bodies whose surface layer, base or both are compressible
STACKS = (
    mdr.Coated(STEEL, 0.3, POLYMER),
    mdr.Layered([(mdr.Elastic(1.0, 0.1), 0.4), (mdr.Elastic(5.0, 0.45), 0.2)], POLYMER),
    mdr.Layered([(POLYMER, 0.3)], mdr.RIGID),
    mdr.Coated(mdr.TransverselyIsotropic(3.4, 1.2, 1.0, 2.6, 0.8), 0.3, POLYMER),
)


def by_transfer(layers, base, k):
    """Matrix of a stack of isotropic layers by another way: the equations of the plane wave, integrated by matrix exponentials.

    State (u, w, tau, sigma), u and tau as sin kx, w and sigma as cos kx, z into the body. On a half-space it decays.
    """

    def rates(material):
        G, nu = shear(material), material.nu
        M = 2.0 * G * (1.0 - nu) / (1.0 - 2.0 * nu)
        lam = M - 2.0 * G
        # u' = k w + tau/G; w' = (sigma - lam k u)/M; tau' = k sigma_xx-part; sigma' = -k tau
        return np.array(
            [
                [0.0, k, 1.0 / G, 0.0],
                [-lam * k / M, 0.0, 0.0, 1.0 / M],
                [k * k * (M - lam**2 / M), 0.0, 0.0, k * lam / M],
                [0.0, 0.0, -k, 0.0],
            ]
        )

    if base is mdr.RIGID:
        states = np.eye(4)[:, 2:]
    else:
        # the decaying space is the image of (A - k)^2, since the others are eigenvectors of k
        A = rates(base)
        grown = np.linalg.matrix_power(A - k * np.eye(4), 2)
        states = np.linalg.svd(grown)[0][:, :2]
    for material, thickness in reversed(layers):
        states = expm(-thickness * rates(material)) @ states
    flexibility = states[:2] @ np.linalg.inv(states[2:])
    # tractions on the surface are -tau and -sigma: into the body and along the wave
    return -flexibility[::-1, ::-1]


@pytest.mark.parametrize("k", [0.05, 0.7, 3.0, 9.0])
def test_the_matrix_agrees_with_another_integration(k):
    """Real amplitudes W cos kx, U sin kx: W^ = W, U^ = -i U of waves exp(i k x)."""
    turn = np.diag([1.0, -1j])
    for layers, base in (
        ([], POLYMER),
        ([(STEEL, 0.3)], POLYMER),
        ([(mdr.Elastic(1.0, 0.1), 0.4), (mdr.Elastic(5.0, 0.45), 0.2)], POLYMER),
        ([(POLYMER, 0.3)], mdr.RIGID),
    ):
        medium = mdr.Layered(layers, base) if layers else mdr.Homogeneous(base)
        exact = turn @ by_transfer(layers, base, k) @ turn.conj()
        np.testing.assert_allclose(medium.compliance_matrix(k), exact, 0.0, 1e-9 * np.abs(exact).max())


def test_a_traction_pushes_the_surface_down_in_front_of_it():
    """The wave t cos kx sinks where sin kx > 0, as the surface in front of a tangential force (Cerruti)."""
    (_, sunk), (drawn, _) = mdr.Homogeneous(POLYMER).compliance_matrix(1.0)
    assert (sunk * np.exp(0.5j * np.pi)).real > 0.0
    # and a pressure draws the surface towards itself
    assert (drawn * np.exp(0.5j * np.pi)).real < 0.0
    assert mdr.Homogeneous(mdr.Elastic(1.0, 0.5)).compliance(2.0, "coupling") == 0.0


@pytest.mark.parametrize("medium", STACKS)
def test_the_coupling_of_layers(medium):
    """Short waves meet the surface, long ones the base; the matrix is positive definite; equal halves of a pair do not couple."""
    surface = medium.compliance(K[-4:], "normal")
    matrix = medium.compliance_matrix(K)
    assert np.all(np.linalg.eigvalsh(matrix) > 0.0)
    np.testing.assert_allclose(matrix[:, 0, 1], -1j * medium.compliance(K, "coupling"), 1e-15)
    np.testing.assert_allclose(matrix[:, 1, 1], 2.0 * medium.compliance(K, "shear") - medium.compliance(K, "twist"), 1e-15)
    assert np.all(np.abs(medium.compliance(K[-4:], "coupling")) < surface)
    pair = mdr.Pair(medium, mdr.Homogeneous(STEEL))
    expected = medium.compliance(K, "coupling") - half_space(STEEL, "coupling")
    np.testing.assert_allclose(pair.compliance(K, "coupling"), expected, 1e-14, 1e-15 * np.abs(medium.compliance(K)).max())
    np.testing.assert_allclose(mdr.Pair(mdr.RIGID, medium).compliance(K, "coupling"), -medium.compliance(K, "coupling"), 1e-15)
    np.testing.assert_array_equal(mdr.Pair(medium, medium).compliance(K, "coupling"), 0.0)


def test_the_coupling_of_a_gradient_is_that_of_its_layers():
    graded = mdr.Graded([0.0, 1.0], [4.0, 1.0], [0.3, 0.1])
    z = (np.arange(400) + 0.5) / 400
    layers = [(mdr.Elastic(4.0 - 3.0 * depth, 0.3 - 0.2 * depth), 1.0 / 400) for depth in z]
    k = np.geomspace(0.01, 20.0, 9)
    found = mdr.Layered(layers, mdr.Elastic(1.0, 0.1)).compliance(k, "coupling")
    # 400 steps instead of the gradient
    np.testing.assert_allclose(graded.compliance(k, "coupling"), found, 5e-5)


def test_frequencies_of_either_sign_and_in_arrays():
    """A body that slides at the speed v meets omega = k_x v."""
    gel = mdr.Viscoelastic(1e3, [(2e3, 0.1)], nu=0.3)
    medium = mdr.Coated(gel, 0.3, STEEL)
    k, omega = np.geomspace(0.1, 30.0, 7)[:, None], np.array([-7.0, 0.0, 7.0, 20.0, -1.0])
    for load in ("normal", "shear", "twist", "coupling"):
        found = medium.compliance(k, load, omega)
        assert found.shape == (7, 5)
        each = np.array([[medium.compliance(float(q), load, float(w)) for w in omega] for q in k[:, 0]])
        np.testing.assert_array_equal(found, each)
        np.testing.assert_array_equal(found[:, 0], found[:, 2].conj())
        assert np.all(found[:, 1].imag == 0.0)
    assert np.all(medium.compliance(k, omega=7.0).imag < 0.0)
    assert medium.compliance_limits(-7.0).rest == np.conj(medium.compliance_limits(7.0).rest)
    assert medium.compliance_matrix(k, omega).shape == (7, 5, 2, 2)
    pores = mdr.Homogeneous(mdr.poroelastic.Poroelastic(2.0, 0.2, 3.0))
    found = pores.compliance(k, omega=omega, drainage="sealed")
    np.testing.assert_array_equal(found[:, 0], found[:, 2].conj())
    np.testing.assert_allclose(found[:, 3], pores.compliance(k[:, 0], omega=20.0, drainage="sealed"), 1e-15)
    flux = Conduction(Conductor(60.0, None, 2.0))
    np.testing.assert_allclose(flux.compliance(k, omega), 1.0 / (60.0 * np.sqrt(k**2 + 1j * omega / 30.0)), 1e-13)
    assert mdr.Homogeneous(STEEL).compliance(k, omega=omega).shape == (7, 5)


COSTLY = {
    "graded": mdr.Graded([0.0, 1.0], [4.0, 1.0], [0.3, 0.1]),
    "stiff surface": mdr.Graded([0.0, 0.1, 1.0], [400.0, 1.0, 5.0], [0.3, 0.45, 0.2]),
    "layers": mdr.Layered([(mdr.Elastic(10.0 if i % 2 else 1.0, 0.3), 0.1) for i in range(12)], STEEL),
    "rigid base": mdr.Layered([(mdr.Elastic(10.0 if i % 2 else 1.0, 0.49), 0.1) for i in range(6)], mdr.RIGID),
}


@pytest.mark.parametrize("load", ["normal", "shear", "twist"])
@pytest.mark.parametrize("name", COSTLY)
def test_many_waves_are_interpolated(name, load):
    medium, k = COSTLY[name], np.geomspace(0.01, 1000.0, 3001)
    found = medium.compliance(k, load)
    some = slice(None, None, 23)
    np.testing.assert_allclose(found[some], medium.compliance(k[some], load), 3e-11)
    shuffled = np.random.default_rng(1).permutation(k).reshape(3001, 1)
    np.testing.assert_array_equal(np.sort(medium.compliance(shuffled, load), axis=None), np.sort(found))


def test_an_interpolated_rigid_base_has_its_value_at_zero():
    medium, k = COSTLY["rigid base"], np.linspace(0.0, 100.0, 2500)
    assert medium.compliance(k)[0] == medium.compliance(0.0) == medium.compliance_limits().rest


@pytest.mark.parametrize("m", [-0.6, -0.2, 0.0, 0.3, 0.7])
def test_a_power_law_gradient_has_its_closed_form(m):
    """The pressure of an exact state displaces the axis by the depth."""
    medium = mdr.PowerLawGraded(2.0, 0.7, m, 0.3)
    np.testing.assert_allclose(medium.compliance(2.0 * K) / medium.compliance(K), 2.0 ** (m - 1.0), 1e-13)
    if m == 0.0:
        np.testing.assert_allclose(medium.compliance(K), mdr.Homogeneous(mdr.Elastic(2.0, 0.3)).compliance(K), 1e-13)
    # C(k) -> displacement by a point force at r = 1, by the transform of k^(m - 1)
    point = medium.compliance(1.0) / (2.0 * np.pi) * 2.0**m * gamma(0.5 * (1.0 + m)) / gamma(0.5 * (1.0 - m))
    state = mdr.Contact(mdr.Paraboloid(1.0), medium).at_radius(1.0)
    # r = s^n, where r^(-m) dr is smooth in s
    n = 4.0 / (1.0 - m)
    x, w = np.polynomial.legendre.leggauss(200)
    s, v = 0.5 * (1.0 + x), 0.5 * w
    depth = 2.0 * np.pi * point * np.sum(v * n * s ** (n - 1.0) * s ** (-n * m) * state.pressure(s**n))
    assert depth == pytest.approx(state.depth, rel=1e-4)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="for a pressure only"):
        medium.compliance(1.0, "shear")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="k = 0"):
        medium.compliance(0.0)


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
    with pytest.raises(mdr.errors.InvalidArgumentError, match="omega = infinity"):
        body.compliance(1.0, omega=np.inf)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="only an effective modulus"):
        mdr.TabulatedMedium([0.1, 0.5, 1.0], [1.0, 1.5, 2.0]).compliance(1.0)
    assert body.compliance([]).shape == (0,)
    assert isinstance(body.compliance(1.0), float)
