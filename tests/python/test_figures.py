# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of objects: the numbers of a figure are those of its object, in the units of its axes."""

import numpy as np
import pytest
from conftest import OXIDE, RUBBER, SILICON

import mdrcontact as mdr
from mdrcontact import instruments as mdi

FILM = mdr.Coated(OXIDE, 500e-9, SILICON)
CONTACT = mdr.Contact(mdr.Paraboloid(10e-6), FILM)
STICKY = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(RUBBER), work_of_adhesion=0.05)
DEPTH = np.linspace(10e-9, 100e-9, 30)
FACTOR = {"nm": 1e-9, "\u00b5m": 1e-6, "\u00b5N": 1e-6, "mN": 1e-3, "kN/m": 1e3, "GPa": 1e9, "MPa": 1e6, "kPa": 1e3, "nN*m": 1e-9}


def si(panel, part=0):
    """x and y of a part of a panel."""
    one = panel.parts[part]
    return FACTOR[panel.x.unit] * one.x, FACTOR[panel.y.unit] * one.y


def test_a_state_shows_pressure_and_surface():
    state = CONTACT.at_depth(50e-9)
    pressure, surface = state.plot().panels
    r, p = si(pressure)
    assert r[-1] == pytest.approx(state.radius, rel=1e-6) and p == pytest.approx(state.pressure(r), rel=1e-9)
    r, u = si(surface)
    assert surface.downward and r[-1] == pytest.approx(2.0 * state.radius)
    assert u == pytest.approx(state.displacement(r), rel=1e-9)
    r, tip = si(surface, 1)
    inside = r < state.radius
    assert tip[inside] == pytest.approx(u[inside], abs=1e-6 * state.depth)


def test_a_cohesive_zone_is_part_of_the_pressure():
    state = mdr.Contact(STICKY.indenter, STICKY.medium, 0.05, cohesive_stress=1e5).at_depth(100e-9)
    r, p = si(state.plot().panels[0])
    assert r[-1] == pytest.approx(state.zone_radius, rel=1e-6) and p[-1] == pytest.approx(-1e5)


def test_a_state_without_contact_has_no_figure():
    with pytest.raises(mdr.errors.InvalidArgumentError, match="radius = 0.0: a state without contact"):
        mdr.State(0.0, 0.0, 0.0, 0.0, contact=CONTACT).plot()
    with pytest.raises(mdr.errors.ArgumentTypeError, match="no contact and no fields"):
        mdr.State(1e-8, 1e-7, 1e-3, 1e5).plot()


def test_states_a_contact_and_a_law_are_curves_over_depth():
    states = CONTACT.at_depth(DEPTH)
    law = mdr.ContactLaw(CONTACT, 100e-9)
    for figure in (states.plot(), CONTACT.plot(100e-9, 20), law.plot(20)):
        for panel, name in zip(figure.panels, ("force", "radius", "stiffness"), strict=True):
            d, values = si(panel)
            if figure.panels[0].parts[0].x[0] > 1e-3:  # the law begins below its smallest depth
                assert values == pytest.approx(getattr(CONTACT.at_depth(d), name), rel=1e-6)
            assert d[-1] >= 100e-9 * (1.0 - 1e-12)


def test_an_adhesive_contact_begins_at_pull_off():
    d, force = si(STICKY.plot(1e-6).panels[0])
    assert d[0] == pytest.approx(STICKY.pull_off("depth").depth, rel=1e-6)
    assert force.min() == pytest.approx(STICKY.pull_off().force, rel=1e-3)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="largest_depth = -1.0: it must be positive"):
        CONTACT.plot(-1.0)


def test_a_loop_is_drawn_between_its_jumps():
    loop = STICKY.loop("depth", 1e-6, 50)
    force, radius = loop.plot().panels
    lines = [part for part in force.parts if getattr(part, "dash", 0) == 0 and hasattr(part, "x")]
    assert [len(line.x) for line in lines if line.name] and sum(len(line.x) for line in lines) == len(loop.force) + 1
    assert FACTOR[force.y.unit] * min(line.y.min() for line in lines) == pytest.approx(loop.force.min())
    assert sum(getattr(part, "dash", 0) == 2 for part in force.parts) == len(loop.jumps) == 2
    spring = STICKY.loop("spring", 1e-6, 50, spring_stiffness=10.0).plot()
    assert spring.panels[0].x.name == "position of the spring's end d + F/K" != force.x.name
    assert radius.y.title == "contact radius a [\u00b5m]"


def test_cycles_of_shift_and_twist():
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(OXIDE)), 0.3)
    state = friction.contact.at_depth(50e-9)
    shifted, twisted = friction.shear(state).loop(4e-9), friction.twist(state).loop(0.01)
    s, force = si(shifted.plot().panels[0])
    assert s == pytest.approx(shifted.shift) and force == pytest.approx(shifted.tangential_force)
    panel = twisted.plot().panels[0]
    assert (panel.x.title, panel.y.name) == ("twist \u03c6 [rad]", "torque M")


@pytest.fixture(scope="module")
def fitted():
    noise = 1.0 + 0.01 * np.random.default_rng(1).standard_normal(len(DEPTH))
    data = mdi.ForceDepth(DEPTH, CONTACT.at_depth(DEPTH).force * noise, relative_sd=0.01)
    return mdi.fit(data, CONTACT.indenter, FILM, ["coating.E"])


def test_a_fit_shows_its_data_and_residuals(fitted):
    figure = fitted.plot("Oxide")
    above, below = figure.panels
    assert not above.x.title and figure.title.splitlines()[0] == "Oxide" and fitted.as_text("coating.E") in figure.title
    above = above._replace(x=above.x._replace(unit=below.x.unit))
    x, y = si(above)
    assert x == pytest.approx(fitted.data.x) and y == pytest.approx(fitted.data.y)
    assert FACTOR[above.y.unit] * above.parts[0].error == pytest.approx(fitted.data.sd * fitted.noise)
    assert si(above, 1)[1] == pytest.approx(fitted.fitted)
    assert below.parts[-1].y == pytest.approx(fitted.residuals) and below.parts[0].high[0] == 1.96
    assert (above.x.low, above.x.high) == (below.x.low, below.x.high)


def test_warnings_about_estimates_are_of_the_figure():
    """A radius that two numbers share: the estimate is doubted."""
    data = mdi.ForceDepth(DEPTH, 0.2 * CONTACT.at_depth(DEPTH).force)
    found = mdi.fit(data, CONTACT.indenter, FILM, {"coating.E": mdi.Free(lower=40e9, upper=90e9)})
    assert found.at_bound["coating.E"] and found.plot().warnings == tuple(found.doubts("coating.E"))


def test_a_ranking_shows_each_model():
    data = mdi.ForceDepth(DEPTH, CONTACT.at_depth(DEPTH).force, relative_sd=0.01)
    ranking = mdi.compare_models(data, CONTACT.indenter, FILM, ["coating.E"], models=["exact", "gao", "perriot-barthel"])
    (panel,) = ranking.plot().panels
    assert panel.x.names == tuple(entry.model for entry in ranking.models)
    found = {panel.x.names[int(x) - 1]: 1e9 * y for part in panel.parts for x, y in zip(part.x, part.y, strict=True)}
    assert found == pytest.approx({entry.model: entry.result.estimates["coating.E"] for entry in ranking.models})
    wrong = [part for part in panel.parts if part.colour == 1]
    assert len(wrong[0].x if wrong else ()) == sum(entry.is_wrong for entry in ranking.models) > 0


def test_oliver_pharr_is_drawn_over_depth():
    states = mdr.Contact(mdr.Paraboloid(1e-6), FILM).at_depth(DEPTH)
    data = mdi.StiffnessDepth(states.depth, states.force, states.stiffness, relative_sd=0.01)
    found = mdi.oliver_pharr(data, mdr.Paraboloid(1e-6))
    modulus, hardness = found.plot().panels
    assert si(modulus)[1] == pytest.approx(found.reduced_modulus) and si(hardness)[1] == pytest.approx(found.hardness)
    assert 1e9 * modulus.parts[0].error == pytest.approx(1.96 * found.reduced_modulus_error)


def test_a_modulus_over_depth_and_a_gel():
    states = mdr.Contact(mdr.Paraboloid(1e-6), FILM).at_depth(DEPTH)
    data = mdi.StiffnessDepth(states.depth, states.force, states.stiffness, relative_sd=0.01)
    profile = mdi.modulus_at_depths(data, mdr.Paraboloid(1e-6), FILM, ["coating.E"])
    figure = profile.plot("Film")
    parts = {part.name: part for part in figure.panels[0].parts}
    assert 1e9 * parts["film modulus E"].y == pytest.approx(profile.modulus)
    assert figure.title == f"Film\n{profile.summary()}"
    gel = mdr.poroelastic.Poroelastic(shear_modulus=28e3, nu=0.28, diffusivity=3e-8)
    time = np.linspace(0.0, 60.0, 30)
    path = mdr.poroelastic.history(
        mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(gel)), time, depth=np.full(30, 5e-5), drainage="surface"
    )
    data = mdi.ForceTime(time, path.depth, path.force * (1.0 + 1e-3 * np.cos(7.0 * time)))
    found = mdi.fit_gel(data, mdr.FlatPunch(1e-3), mdr.Homogeneous(gel.replace(diffusivity=1e-8)), drainage="surface")
    above, below = found.plot().panels
    assert si(above._replace(x=above.x._replace(unit="nm")))[1] == pytest.approx(data.y)
    assert float(np.std(below.parts[-1].y, ddof=2)) == pytest.approx(1.0, rel=0.2)


def test_inspections_draw_records_alone(tmp_path):
    rows = "".join(f"{10 * i},{i**1.5:.4f}\n" for i in range(40))
    (tmp_path / "ball.csv").write_text("depth [nm],load [uN]\n" + rows)
    figure = mdi.inspect_file(tmp_path / "ball.csv").plot("Ball")
    assert figure.title == "Ball" and si(figure.panels[0])[0][-1] == pytest.approx(390e-9)
    (tmp_path / "modulus.csv").write_text("radius [nm],modulus [GPa]\n" + "".join(f"{10 + i},{70 + i}\n" for i in range(20)))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="only records of instruments"):
        mdi.inspect_file(tmp_path / "modulus.csv").plot()
