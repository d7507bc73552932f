# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivatives of F with respect to the constants of a contact: against differences, closed forms and what homogeneity says."""

import math

import numpy as np
import pytest
from test_coatings import random_material

import mdrcontact as mdr

pytestmark = [
    pytest.mark.filterwarnings(f"ignore::mdrcontact.errors.{name}Warning") for name in ("LargeStrain", "SeparationInside")
]


def differences(f, x, step):
    """f'(x) to the sixth order."""
    return sum(w * (f(x + i * step) - f(x - i * step)) for i, w in ((1, 0.75), (2, -0.15), (3, 1 / 60))) / step


def coated(E0=3.0, nu0=0.3, h=0.5, E1=1.0, nu1=0.4):
    return mdr.Coated(mdr.Elastic(E0, nu0), h, mdr.Elastic(E1, nu1))


@pytest.mark.parametrize("indenter", [mdr.Paraboloid(1.0), mdr.Cone(0.3), mdr.FlatPunch(0.4), mdr.PowerLaw(1.0, 3.0)])
@pytest.mark.parametrize("values", [{}, {"E0": 0.05}, {"E0": 80.0, "h": 0.1}, {"nu0": 0.1, "h": 2.0}])
def test_coated_against_differences(indenter, values):
    depth = 0.3
    contact = mdr.Contact(indenter, coated(**values))
    found = contact.at_depth(depth).gradient()
    at = {"E0": 3.0, "nu0": 0.3, "h": 0.5, "E1": 1.0, "nu1": 0.4} | values
    names = {"E0": "coating.E", "nu0": "coating.nu", "h": "thickness", "E1": "substrate.E", "nu1": "substrate.nu"}
    size = contact.at_depth(depth).force
    for key, name in names.items():
        step = 3e-3 if key.startswith("nu") else 1e-2 * at[key]
        expected = differences(
            lambda v, key=key: mdr.Contact(indenter, coated(**{**at, key: v})).at_depth(depth).force, at[key], step
        )
        scale = max(abs(expected), size / at[key] * 1e-2)
        assert abs(found[name] - expected) < 1e-8 * scale, name


def test_radius():
    contact = mdr.Contact(mdr.Paraboloid(2.0), coated())
    found = contact.at_depth(0.1).gradient()["radius"]
    assert found == pytest.approx(
        differences(lambda R: mdr.Contact(mdr.Paraboloid(R), coated()).at_depth(0.1).force, 2.0, 2e-2), rel=1e-8)  # fmt: skip


def test_hertz():
    E, nu, R, d = 72e9, 0.17, 1e-5, 1e-7
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(mdr.Elastic(E, nu)))
    found = contact.at_depth(d).gradient()
    F = 4 / 3 * E / (1 - nu**2) * math.sqrt(R) * d**1.5
    expected = {"E": F / E, "nu": 2 * nu / (1 - nu**2) * F, "radius": F / (2 * R)}
    assert found == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("base", [mdr.Elastic(210e9, 0.3), mdr.RIGID])
def test_homogeneity(base):
    """F is of the first degree in all moduli, and of the second in all lengths."""
    layers = [(mdr.Elastic(3e9, 0.4), 2e-6), (mdr.Elastic(70e9, 0.33), 1e-6), (mdr.Elastic(9e9, 0.5), 3e-6)]
    contact = mdr.Contact(mdr.Paraboloid(5e-5), mdr.Layered(layers, base))
    for depth in (1e-8, 3e-7, 1e-6):
        state = contact.at_depth(depth)
        found = state.gradient()
        moduli = {f"layers[{i}].E": layer.E for i, (layer, _) in enumerate(layers)} | (
            {} if base is mdr.RIGID else {"substrate.E": base.E})  # fmt: skip
        assert sum(found[name] * E for name, E in moduli.items()) == pytest.approx(state.force, rel=1e-8)
        lengths = sum(found[f"layers[{i}].thickness"] * h for i, (_, h) in enumerate(layers)) + 5e-5 * found["radius"]
        assert lengths + depth * state.stiffness == pytest.approx(2.0 * state.force, rel=1e-8)


@pytest.mark.parametrize("seed", range(4))
def test_layers_with_an_axis_against_differences(seed):
    """All constants of random layers, interfaces and prestress, by differences of the force; homogeneity of all moduli."""
    rng = np.random.default_rng(seed)
    springs = mdr.Interface(normal=10.0 ** rng.uniform(-1, 2), tangential=10.0 ** rng.uniform(-1, 2))
    medium = mdr.Layered(
        [mdr.Layer(random_material(rng), rng.uniform(0.3, 2.0), prestress=0.01, interface=springs), (mdr.Elastic(2.0, 0.3), 0.7)],
        mdr.TransverselyIsotropic(23.4, 9.06, 9.11, 32.5, 8.71),
        tolerance=1e-12,
    )
    tip = mdr.Paraboloid(2.0)
    contact = mdr.Contact(tip, medium)
    state = contact.at_depth(0.1)
    found = state.gradient()
    constants = medium.parameters()
    assert {name for name, value in constants.items() if value != 0.0 and "resistance" not in name} == set(found) - {"radius"}
    for name, value in constants.items():
        if name not in found:
            continue
        step = 3e-4 if "nu" in name else 2e-3 * abs(value)
        expected = differences(
            lambda v, name=name: mdr.Contact(tip, medium.with_parameters({name: v})).at_depth(0.1).force, value, step
        )
        assert abs(found[name] - expected) < 1e-8 * max(abs(expected), 1e-2 * state.force / abs(value)), name
    scaled = sum(found[name] * value for name, value in constants.items() if name in found and is_modulus(name))
    assert scaled == pytest.approx(state.force, rel=1e-8)


def is_modulus(name):
    return name.rpartition(".")[2] not in ("nu", "nu_t", "nu_tz", "thickness")


@pytest.mark.parametrize(
    ("contact", "words"),
    [
        (lambda: mdr.Contact(mdr.Paraboloid(1.0), coated().with_model("gao")), "model = 'gao':"),
        (lambda: mdr.Contact(mdr.Paraboloid(1.0), coated(), work_of_adhesion=0.01), "work_of_adhesion: "),
        (lambda: mdr.Contact(mdr.Paraboloid(1.0), mdr.PowerLawGraded(1.0, 1.0, 0.2, 0.3)), "PowerLawGraded: "),
        (lambda: mdr.Contact(mdr.Paraboloid(1.0), coated(h=1e-3)), "100 thicknesses of the top layer"),
    ],
)
def test_refusals(contact, words):
    made = contact()
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
        made.at_depth(0.1).gradient()


def test_one_state():
    contact = mdr.Contact(mdr.Paraboloid(1.0), coated())
    with pytest.raises(mdr.errors.InvalidArgumentError, match="one state"):
        contact.at_depth(np.array([0.1, 0.2])).gradient()


def test_kinks_of_the_line_load():
    contact = mdr.Contact(mdr.RoundedCone(0.1, 0.3), coated())
    with pytest.raises(mdr.errors.NoConvergenceError, match="not smooth enough"):
        contact.at_depth(0.2).gradient()
