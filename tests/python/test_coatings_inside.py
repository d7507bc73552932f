# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses, displacements and energies inside layers with an axis and at interfaces that give."""

from __future__ import annotations

import numpy as np
import pytest
from test_coatings import GAN, GRAPHITE, body, isotropic, random_material, rows

import mdrcontact as mdr
from mdrcontact.interior import layer_energies

NAMES = ("u_r", "u_z", "s_rr", "s_tt", "s_zz", "s_rz")
R = np.array([0.0, 0.3, 0.8, 1.3, 2.5])
Z = np.array([0.0, 0.05, 0.4, 1.0, 1.7])


def field(contact, state, r, z, **options):
    r, z = np.broadcast_arrays(r, z)
    return np.array(state.interior(r, z, **options))


def stored(contact, state, layers):
    """Energies of the layers and the half-space."""
    return layer_energies(state, "lower", layers)


@pytest.mark.filterwarnings("ignore::mdrcontact.errors.LargeStrainWarning")
def test_fields_are_those_of_another_solver():
    """Displacements and stresses to 1e-12 of the largest of a point: half-spaces with real, far, double and complex roots, films
    on and of them, springs, a sliding sheet, a smooth base; at single points and on a grid."""
    worst = 0.0
    contacts = {}
    for row in rows("coatings_stress.csv"):
        key = row["layers_top_first"], row["base"]
        contact = contacts.setdefault(key, mdr.Contact(mdr.Paraboloid(1.0), body(*key)))
        state = contact.at_radius(float(row["a"]))
        r, z = float(row["r"]), float(row["z"])
        true = np.array([float(row[name]) for name in NAMES])
        unit = np.repeat([abs(true[:2]).max(), abs(true[2:]).max()], [2, 4])
        point = state.interior(r, z, side="above")
        grid = state.interior(np.array([[r], [r + 0.1]]), np.array([[z, 0.9 * z]]), side="above")
        for found in (point, grid):
            found = np.array([np.ravel(getattr(found, name))[0] for name in NAMES])
            worst = max(worst, np.max(abs(found - true) / unit))
    assert len(contacts) > 8
    assert worst < 1e-12


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_isotropic_constants_give_the_field_of_an_isotropic_body(friction):
    """The six-number modes and the isotropic ones share no formula: fields within 1e-11 of the largest stress and displacement."""
    rng = np.random.default_rng(7)
    for _ in range(6):
        (E, nu), (E2, nu2) = ((10.0 ** rng.uniform(-1, 1), rng.uniform(-0.4, 0.5)) for _ in range(2))
        film, twin, base, other_base = (
            mdr.Elastic(E, nu),
            isotropic(E, nu),
            mdr.Elastic(E2, nu2),
            isotropic(E2, nu2),
        )
        for plain, other in (
            (mdr.Homogeneous(film), mdr.Homogeneous(twin)),
            (mdr.Layered([(film, 1.0)], base), mdr.Layered([(twin, 1.0)], other_base)),
            (mdr.Layered([(film, 1.0)], mdr.RIGID), mdr.Layered([(twin, 1.0)], mdr.RIGID)),
        ):
            z = Z[:4] if plain.__class__ is mdr.Layered and plain.substrate is mdr.RIGID else Z
            fields, energies = [], []
            for medium in (plain, other):
                contact = mdr.Contact(mdr.Paraboloid(10.0), medium)
                state = contact.at_radius(1.0)
                options = {"friction": friction, "angle": 0.7} if friction else {}
                fields.append(field(contact, state, R[:, None], z[None, :], side="above", **options))
                energies.append(stored(contact, state, 2))
            for part in (slice(0, 3), slice(3, 9)):
                unit = abs(fields[0][part]).max()
                np.testing.assert_allclose(fields[1][part], fields[0][part], rtol=0, atol=1e-11 * unit)
            np.testing.assert_allclose(energies[1], energies[0], rtol=1e-10, atol=1e-12 * sum(energies[0]))


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_closed_kernels_and_waves_are_one_half_space(friction):
    """A stiff interface in one material is no interface: kernels in closed form against the waves through two layers. K = 1e16
    times the modulus leaves 1e-16."""
    rng = np.random.default_rng(11)
    for material in [
        GAN,
        GRAPHITE,
        mdr.TransverselyIsotropic(100.0, 40.0, 60.0, 100.0, 80.0),
        *(random_material(rng) for _ in range(6)),
    ]:
        stiff = 1e16 * material.C44 if hasattr(material, "C44") else 1e20
        whole = mdr.Homogeneous(material)
        cut = mdr.Layered([mdr.Layer(material, 0.7, interface=mdr.Interface(normal=stiff, tangential=stiff))], material)
        options = {"friction": friction, "angle": 1.1} if friction else {}
        found = []
        for medium in (whole, cut):
            contact = mdr.Contact(mdr.Paraboloid(10.0), medium)
            found.append(field(contact, contact.at_radius(1.0), R[:, None], Z[None, :], **options))
        for part in (slice(0, 3), slice(3, 9)):
            unit = abs(found[0][part]).max()
            np.testing.assert_allclose(found[1][part], found[0][part], rtol=0, atol=1e-10 * unit)


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_equilibrium_and_hookes_law_inside(friction):
    """Divergence of the stress, and stress from the strain, by differences of the fields: to 1e-6, their own error."""
    rng = np.random.default_rng(3)
    for material in [GAN, GRAPHITE, *(random_material(rng) for _ in range(3))]:
        contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Layered([mdr.Layer(material, 1.0)], mdr.Elastic(50.0, 0.3)))
        state = contact.at_radius(1.0)
        r, z, phi, step = 0.8, 0.5, 0.7, 1e-3

        def at(dr=0.0, dz=0.0, dphi=0.0):
            options = {"friction": friction, "angle": phi + dphi} if friction else {}
            return state.interior(r + dr, z + dz, **options)

        def slope(name, axis):
            values = [getattr(at(**{axis: n * step}), name) for n in (-2, -1, 1, 2)]
            return (values[0] - 8.0 * values[1] + 8.0 * values[2] - values[3]) / (12.0 * step)

        here = at()
        unit = max(abs(here.s_zz), abs(here.s_rr))
        balance = [
            slope("s_rr", "dr") + slope("s_rz", "dz") + slope("s_rt", "dphi") / r + (here.s_rr - here.s_tt) / r,
            slope("s_rz", "dr") + slope("s_zz", "dz") + slope("s_tz", "dphi") / r + here.s_rz / r,
            slope("s_rt", "dr") + slope("s_tz", "dz") + slope("s_tt", "dphi") / r + 2.0 * here.s_rt / r,
        ]
        assert np.max(np.abs(balance)) < 1e-6 * unit
        rr, zz = slope("u_r", "dr"), slope("u_z", "dz")
        tt = here.u_r / r + slope("u_t", "dphi") / r
        rt = slope("u_t", "dr") + slope("u_r", "dphi") / r - here.u_t / r
        c = material
        expected = [
            c.C11 * rr + c.C12 * tt + c.C13 * zz,
            c.C12 * rr + c.C11 * tt + c.C13 * zz,
            c.C13 * (rr + tt) + c.C33 * zz,
            c.C44 * (slope("u_r", "dz") + slope("u_z", "dr")),
            0.5 * (c.C11 - c.C12) * rt,
        ]
        found = [here.s_rr, here.s_tt, here.s_zz, here.s_rz, here.s_rt]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * max(unit, np.max(np.abs(expected))))


def test_displacements_jump_at_springs_and_energies_add_up():
    """The jump is the traction over the stiffness; layers, springs and half-space store the work of the force."""
    rng = np.random.default_rng(5)
    for _ in range(4):
        normal, tangential = 10.0 ** rng.uniform(0.5, 3, 2)
        springs = mdr.Interface(normal=normal, tangential=tangential)
        medium = mdr.Layered([mdr.Layer(random_material(rng), 0.6, interface=springs), mdr.Layer(GAN, 0.5)], random_material(rng))
        contact = mdr.Contact(mdr.Paraboloid(10.0), medium)
        state = contact.at_radius(1.0)
        above, below = (state.interior(R, 0.6, side=side) for side in ("above", "below"))
        for name in ("s_zz", "s_rz"):
            np.testing.assert_allclose(getattr(below, name), getattr(above, name), rtol=0, atol=1e-9 * abs(above.s_zz).max())
        # u_z points down: what lies above sinks further
        unit = abs(above.u_z).max()
        np.testing.assert_allclose(below.u_z - above.u_z, above.s_zz / normal, rtol=0, atol=1e-9 * unit)
        np.testing.assert_allclose(below.u_r - above.u_r, above.s_rz / tangential, rtol=0, atol=1e-9 * unit)
        energies = stored(contact, state, 3)
        assert min(energies) > 0.0
        assert sum(energies) == pytest.approx(state.energy(), rel=1e-9)


def test_surface_is_the_contact():
    """s_zz = -p and u_z = d - f under the indenter, on random bodies; the apex of a cone and the edge of a punch are infinite."""
    rng = np.random.default_rng(13)
    for _ in range(4):
        contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Layered([(random_material(rng), 0.8)], random_material(rng)))
        state = contact.at_radius(1.0)
        inside = state.interior(R[:3], 0.0)
        np.testing.assert_allclose(inside.s_zz, -state.pressure(R[:3]), rtol=0, atol=1e-9 * state.force)
        np.testing.assert_allclose(inside.u_z, state.displacement(R[:3]), rtol=0, atol=1e-9 * state.depth)
    punch = mdr.Contact(mdr.FlatPunch(1.0), mdr.Homogeneous(GRAPHITE))
    edge = punch.at_depth(0.01).interior(1.0, 0.0)
    near = punch.at_depth(0.01).interior(1.0, 1e-9)
    for name in ("s_rr", "s_tt", "s_zz"):
        assert np.isinf(getattr(edge, name))
    assert edge.s_zz < 0.0
    assert near.s_zz < 0.0


def test_what_is_refused():
    film = mdr.Contact(mdr.Paraboloid(1.0), mdr.Layered([mdr.Layer(GAN, 1.0, prestress=1.0)], GAN))
    with pytest.raises(ValueError, match="layers with a prestress"):
        film.at_depth(0.01).interior(0.0, 0.5)
    sliding = mdr.Contact(mdr.Paraboloid(1.0), mdr.Layered([mdr.Layer(GAN, 1.0, interface=mdr.SLIDING)], GAN))
    assert sliding.at_depth(0.01).interior(0.0, 0.5).s_zz < 0.0
    with pytest.raises(ValueError, match="it must be 0 on a layer with a sliding"):
        sliding.at_depth(0.01).interior(0.0, 0.5, friction=0.1)


def test_what_decides_in_a_weakly_bonded_film():
    """A stiff film that slides bends: more tension at its underside, no shear at its foot; what yields first is looked for."""
    film, base = GAN, mdr.Elastic(50.0, 0.3)
    found = {}
    for name, below in (("bonded", None), ("weak", mdr.Interface(tangential=1.0)), ("slides", mdr.SLIDING)):
        contact = mdr.Contact(mdr.Paraboloid(10.0), mdr.Layered([mdr.Layer(film, 1.0, interface=below)], base))
        state = contact.at_radius(1.0)
        found[name] = state.critical(), state.interior(0.0, 1.0, side="above").s_rr / state.force
    assert found["bonded"][1] < found["weak"][1] < found["slides"][1]
    assert found["slides"][0].interfaces[0].shear.value < 1e-6 * found["bonded"][0].interfaces[0].shear.value
    smooth = mdr.Contact(mdr.Paraboloid(10.0), mdr.Coated(film, 1.0, mdr.SMOOTH))
    critical = smooth.at_force(1.0).critical()
    assert sum(layer.energy for layer in critical.layers) == pytest.approx(smooth.at_force(1.0).energy(), rel=1e-9)
    assert smooth.first_failure({"von_mises": [3.0]})[0].at.value == pytest.approx(3.0, rel=1e-6)
