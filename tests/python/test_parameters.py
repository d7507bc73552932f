# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects say what their numbers are called, and are made anew with others: one list for fits, problem files and callers."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import OXIDE, RUBBER, SILICON, every_medium, every_profile

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact._units import dimensions
from mdrcontact.instruments.fitting.quantities import dimension_of

GAN = mdr.TransverselyIsotropic(390e9, 145e9, 106e9, 398e9, 105e9)
FIBRES = mdr.TransverselyIsotropic.from_engineering(10e9, 25e9, 0.2, 0.15, 3e9)
GEL = mdr.Viscoelastic(1e5, [(2e5, 0.1), (1e5, 10.0)], bulk_modulus=2e9)
OWN = [
    OXIDE,
    GAN,
    FIBRES,
    GEL,
    mdr.PowerLawRheology(400.0, 1.0, 0.18, 0.5),
    mdr.conduction.Conductor(1e7, 2e7),
    mdr.poroelastic.Poroelastic(2e3, 0.2, 1e-9),
    mdr.Interface(normal=1e15, tangential=1e14),
    mdr.Surface(0.03, 1e-18),
    mdr.Homogeneous(RUBBER, mdr.Surface(0.03)),
    mdr.Coated(RUBBER, 1e-6, mdr.RIGID, surface=mdr.Surface(0.03)),
    mdr.Homogeneous(GAN),
    mdr.Coated(FIBRES, 1e-6, mdr.SMOOTH),
    mdr.Coated(GEL, 1e-6, OXIDE),
    mdr.Layered([mdr.Layer(GAN, 1e-6, 1e8, mdr.Interface(normal=1e15)), mdr.Layer(OXIDE, 1e-7)], FIBRES),
    mdr.Layered([mdr.Layer(OXIDE, 1e-6, interface=mdr.SLIDING)], SILICON),
    mdr.Layered([(GEL, 1e-6), (RUBBER, 1e-6)], mdr.RIGID),
]


@pytest.mark.parametrize("thing", [*every_profile(), *every_medium(), *OWN], ids=lambda thing: type(thing).__name__)
def test_an_object_is_that_of_its_own_parameters(thing):
    found = thing.parameters()
    assert all(isinstance(value, float) for value in found.values())
    assert thing.with_parameters(found) == thing
    assert thing.with_parameters({}) is thing


@pytest.mark.parametrize("thing", [*every_profile(), *every_medium(), *OWN], ids=lambda thing: type(thing).__name__)
def test_each_parameter_changes_what_it_names_and_nothing_else(thing):
    before = thing.parameters()
    for name, value in before.items():
        if not np.isfinite(value):
            continue
        other = 0.99 * value if value else {"resistance": 1e-9, "stretching": 1e-2}.get(name.split(".")[-1], 1e14)
        try:
            changed = thing.with_parameters({name: other})
        except mdr.errors.InvalidArgumentError:
            # what a model fixes, a bulk modulus excludes, or two bodies share
            assert name in ("coating.nu", "z[0]") or name.endswith(("prestress", "viscosity", "exponent"))
        else:
            assert changed.parameters() == {**before, name: other}


def test_names_are_those_of_the_parts():
    stack = mdr.Layered([mdr.Layer(GAN, 1e-6, 1e8, mdr.Interface(normal=1e15, tangential=1e14)), (OXIDE, 1e-7)], FIBRES)
    assert list(mdr.Pair(stack, mdr.Coated(OXIDE, 1e-6, SILICON, "wave")).parameters()) == [
        *(f"layers[0].{name}" for name in ("C11", "C12", "C13", "C33", "C44", "thickness", "prestress")),
        *(f"layers[0].interface.{name}" for name in ("resistance", "normal", "tangential")),
        *(f"layers[1].{name}" for name in ("E", "nu", "thickness", "prestress")),
        *(f"substrate.{name}" for name in ("E_t", "E_z", "nu_t", "nu_tz", "G_z")),
        *(f"upper.{name}" for name in ("coating.E", "coating.nu", "thickness", "substrate.E", "substrate.nu", "wave_factor")),
    ]
    assert list(mdr.Homogeneous(GEL).parameters())[:3] == ["relaxed_shear_modulus", "terms[0].modulus", "terms[0].time"]
    assert list(mdr.AreaFunction([24.5, 1e-7], max_height=1e-6).parameters()) == ["C0", "C1"]


@pytest.mark.parametrize("thing", [*every_profile(), *every_medium(), *OWN], ids=lambda thing: type(thing).__name__)
def test_each_field_that_is_a_number_says_its_dimension(thing):
    """From it come keys and units of problem files, and units in fits; these count in units that depend on another number."""
    without = {"coefficient", "coefficients", "numbers", "smallest_radius", "largest_radius", "r_max", "g", "x"}
    without |= {"sigma", "along", "capacity", "resistance"}
    said = dimensions(type(thing))
    for name, value in thing._given().items():
        if isinstance(value, float) and name in type(thing).__dataclass_fields__:
            assert name in said or name in without, name
    assert dimension_of("layers[0].interface.normal").si == "Pa/m"
    assert dimension_of("coating.terms[1].time").si == "s"


def test_other_numbers_reach_the_library():
    film = mdr.Coated(OXIDE, 5e-7, SILICON)
    stiffer = film.with_parameters({"coating.E": 90e9, "thickness": 4e-7})
    a = np.geomspace(1e-8, 1e-5, 9)
    assert np.array_equal(stiffer.modulus(a), mdr.Coated(mdr.Elastic(90e9, OXIDE.nu), 4e-7, SILICON).modulus(a))
    assert film == mdr.Coated(OXIDE, 5e-7, SILICON)


def test_refusals_say_why():
    film = mdr.Coated(OXIDE, 5e-7, SILICON)
    with pytest.raises(mdr.errors.InvalidArgumentError, match=r"the parameter 'coating\.e': .*coating\.E"):
        film.with_parameters({"coating.e": 1.0})
    with pytest.raises(mdr.errors.InvalidArgumentError, match="nu = 0.7"):
        film.with_parameters({"coating.nu": 0.7})
    with pytest.raises(mdr.errors.InvalidArgumentError, match="C12"):
        GAN.with_parameters({"C12": 400e9})
    with pytest.raises(mdr.errors.ArgumentTypeError, match="must map names"):
        film.with_parameters([1.0])


def test_a_graded_body_under_a_model_with_a_constant_is_fitted():
    tip = mdr.Paraboloid(5e-6)
    body = mdr.Graded([0.0, 1e-6], [1e9, 4e9], [0.3, 0.2], model="gao-power")
    depth = np.linspace(1e-8, 3e-7, 20)
    force = mdr.Contact(tip, body).at_depth(depth).force
    found = mdi.fit(mdi.ForceDepth(depth, force, sd=0.01 * force), tip, body, {"E[1]": 3e9})
    assert found.estimates["E[1]"] == pytest.approx(4e9, rel=1e-6)
    assert found.medium.model == "gao-power"


def test_an_area_function_of_many_terms_is_fitted():
    tip = mdr.AreaFunction([24.5, 2e-7, 1e-12, 1e-14, *5 * [1e-15]], min_height=5e-9, max_height=3e-7)
    body = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    depth = np.linspace(1e-8, 1e-7, 20)
    force = mdr.Contact(tip, body).at_depth(depth).force
    found = mdi.fit(mdi.ForceDepth(depth, force, sd=0.01 * force), tip, body, {"indenter.C1": 3e-7})
    assert found.estimates["indenter.C1"] == pytest.approx(2e-7, rel=1e-6)
    assert found.indenter.coefficients[2:] == tip.coefficients[2:]
