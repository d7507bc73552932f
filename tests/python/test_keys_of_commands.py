# SPDX-License-Identifier: GPL-3.0-or-later
"""Keys of problem files that commands once passed over: each is used, or refused with words."""

import re

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.problem import ProblemError

BODY = '[indenter]\nshape = "paraboloid"\nradius = "51 um"\n[compute]\ndepths = ["83 nm"]\n'
ELASTIC = '[medium]\ntype = "homogeneous"\nmaterial = { E = "3 GPa", nu = 0.34 }\n'
RELAXING = """[medium]
type = "homogeneous"
material = { relaxed_shear_modulus = "0.71 GPa", moduli = ["1.9 GPa"], times = ["0.31 s"], nu = 0.37 }
[history]
path = "ramp"
depth = "91 nm"
rise_time = "0.7 s"
fall_time = "5.3 s"
retract_to = "-0.3 um"
points = 12
"""
RATE = '[adhesion]\nwork_of_adhesion = "0.31 J/m^2"\nspeed = "1.3 um/s"\nexponent = 0.43\n'
HEAT = '[medium]\ntype = "homogeneous"\nmaterial = { E = "3 GPa", nu = 0.34, thermal_conductivity = "31 W/(m*K)" }\n'


def _failed(tmp_path, capsys, command, text, *more):
    (tmp_path / "problem.toml").write_text(BODY + text, encoding="utf-8")
    assert main([command, str(tmp_path / "problem.toml"), *more]) == 2
    return capsys.readouterr().err


@pytest.mark.parametrize("command", ["curve", "adhesion", "stress", "law"])
def test_commands_without_time_refuse_a_work_that_depends_on_speed(command, tmp_path, capsys):
    """They took the work of an edge at rest, and in the loop of approach and retraction the closing work for the opening one."""
    more = [str(tmp_path / "found.law")] if command == "law" else []
    assert "Use mdrcontact history" in _failed(tmp_path, capsys, command, ELASTIC + RATE, *more)


@pytest.mark.parametrize(
    ("kind", "key", "right"),
    [
        ("electrical", 'thermal_film = "1e-8 m^2*K/W"', "Write film"),
        ("electrical", 'thermal_interfaces = ["1e-8 m^2*K/W"]', "Write interfaces"),
        ("thermal", 'film = "1e-15 ohm*m^2"', "Write thermal_film"),
        ("thermal", 'interfaces = ["1e-15 ohm*m^2"]', "Write thermal_interfaces"),
    ],
)
def test_resistances_belong_to_what_flows(kind, key, right, tmp_path, capsys):
    assert right in _failed(tmp_path, capsys, "conduction", f'{HEAT}[conduction]\nkind = "{kind}"\n{key}\n')


def test_compare_refuses_a_half_space_under_a_sheet_with_words(tmp_path, capsys):
    assert "has one model" in _failed(tmp_path, capsys, "compare", ELASTIC + 'surface_tension = "30 N/m"\n')


@pytest.mark.parametrize("spring", ["", 'spring_stiffness = "5.3 kN/m"\n'])
def test_history_follows_a_relaxing_body_that_attracts(spring, tmp_path, capsys):
    """The same as from Python, led by depth or by the far end of a spring."""
    adhesion = f'[adhesion]\nwork_of_adhesion = "0.31 J/m^2"\ncohesive_stress = "31 MPa"\n{spring}'
    (tmp_path / "problem.toml").write_text(BODY + RELAXING + adhesion, encoding="utf-8")
    assert main(["history", str(tmp_path / "problem.toml"), "--csv", str(tmp_path / "found.csv")]) == 0
    printed = capsys.readouterr().out
    force = np.loadtxt(tmp_path / "found.csv", delimiter=",", skiprows=1)[:, 3]
    head = (tmp_path / "found.csv").read_text().splitlines()[0]
    unit = {"mN": 1e-3, "uN": 1e-6}[re.search(r"force \[(\w+)\]", head)[1]]
    soft = mdr.Viscoelastic(0.71e9, [(1.9e9, 0.31)], nu=0.37)
    contact = mdr.Contact(mdr.Paraboloid(51e-6), mdr.Homogeneous(soft), 0.31, cohesive_stress=31e6)
    path = mdr.problem.load(tmp_path / "problem.toml").history
    given = {"position": path.values, "spring_stiffness": 5.3e3} if spring else {"depth": path.values}
    expected = mdr.adhesion.adhesive_history(contact, path.time, **given).force
    assert np.allclose(force * unit, expected, rtol=1e-12, atol=1e-18)
    assert "lowest force" in printed and "lost at the edge" not in printed


def test_a_spring_needs_a_contact_that_it_leads(tmp_path, capsys):
    text = RELAXING.replace('"-0.3 um"', '"0 um"') + '[adhesion]\nwork_of_adhesion = "0 J/m^2"\nspring_stiffness = "5.3 kN/m"\n'
    assert "spring_stiffness is of a contact" in _failed(tmp_path, capsys, "history", text)


@pytest.mark.parametrize(
    ("kind", "key"),
    [
        ("force-depth", 'stiffness = "S"'),
        ("force-depth", 'area = "A"'),
        ("force-depth", 'min_radius = "1 um"'),
        ("force-time", "nu = 0.3"),
        ("stiffness-depth", 'modulus = "E"'),
        ("modulus-radius", 'depth = "h"'),
        ("modulus-radius", 'max_depth = "100 nm"'),
        ("stiffness-radius", "nu = 0.3"),
        ("stiffness-radius", 'thickness = "1 um"'),
    ],
)
def test_columns_belong_to_the_kind_of_data(kind, key, tmp_path):
    """A limit of the radius of a curve of forces, say, left all points in."""
    text = f'[indenter]\nshape = "paraboloid"\nradius = "51 um"\n{ELASTIC}[fit]\nfree = ["E"]\n[data]\nkind = "{kind}"\n{key}\n'
    (tmp_path / "problem.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ProblemError, match=key.split()[0]):
        load_fit_file(tmp_path / "problem.toml")


@pytest.mark.parametrize("key", ['drainage = "indenter"', 'contact_weight_rule = "moving"'])
def test_a_fit_refuses_what_it_would_pass_over(key, tmp_path):
    text = (
        f'[indenter]\nshape = "paraboloid"\nradius = "51 um"\n{ELASTIC}[fit]\nfree = ["E"]\n{key}\n[data]\nkind = "force-depth"\n'
    )
    (tmp_path / "problem.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ProblemError, match=key.split()[0]):
        load_fit_file(tmp_path / "problem.toml")


@pytest.mark.parametrize(
    ("kind", "keys", "words"),
    [
        ("modulus-radius", 'radius = "a"\narea = "A"', "radius and area: both are the same quantity"),
        ("stiffness-radius", 'area = "A"\nradius_over_thickness = "x"\nthickness = "1 um"', "area and radius_over_thickness"),
        ("dynamic-stiffness", 'radius = "a"\ncontact_radius = "1 um"', "radius and contact_radius"),
        ("force-depth", 'depth = "h"\nheight = "z"', "depth and height"),
        ("force-depth", 'height = "z"\nforce = "F"\ndeflection = "V"', "force and deflection"),
        ("unloading", 'depth = "h"\ndeflection = "V"', "depth and deflection"),
        ("force-depth", 'time = "t"', "for drift alone"),
    ],
)
def test_columns_that_would_not_be_read(kind, keys, words, tmp_path):
    """Of two names of one thing the second was passed over."""
    text = f'[indenter]\nshape = "paraboloid"\nradius = "51 um"\n{ELASTIC}[fit]\nfree = ["E"]\n[data]\nkind = "{kind}"\n{keys}\n'
    (tmp_path / "problem.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ProblemError, match=words):
        load_fit_file(tmp_path / "problem.toml")


@pytest.mark.parametrize("key", ['spring_constant = "30 N/m"', 'deflection_sensitivity = "50 nm/V"'])
@pytest.mark.parametrize("kind", ["stiffness-depth", "modulus-radius", "stiffness-radius", "dynamic-stiffness"])
def test_a_cantilever_belongs_to_records(kind, key, tmp_path):
    text = f'[indenter]\nshape = "paraboloid"\nradius = "51 um"\n{ELASTIC}[fit]\nfree = ["E"]\n[data]\nkind = "{kind}"\n'
    (tmp_path / "problem.toml").write_text(f"{text}[instrument]\n{key}\n", encoding="utf-8")
    with pytest.raises(ProblemError, match=f"{key.split()[0]}.*no deflection"):
        load_fit_file(tmp_path / "problem.toml")


KNOWN = """
[indenter]
shape = "area-function"
coefficients = [24.5, 190.0]
length_unit = "nm"
max_height = "1 um"
[calibration]
names = ["indenter.C0", "frame_compliance"]
values = [24.5, "0.1 nm/mN"]
sds = [0.2, "0.01 nm/mN"]
"""


@pytest.mark.parametrize(("kind", "is_taken"), [("modulus-radius", False), ("stiffness-radius", True), ("unloading", True)])
def test_a_calibration_goes_into_fits_of_data_that_depend_on_it(kind, is_taken, tmp_path):
    (tmp_path / "tip.toml").write_text(KNOWN, encoding="utf-8")
    text = f'[indenter]\nfile = "tip.toml"\n{ELASTIC}[fit]\nfree = ["E"]\n[data]\nkind = "{kind}"\n'
    (tmp_path / "problem.toml").write_text(text, encoding="utf-8")
    found = load_fit_file(tmp_path / "problem.toml")
    assert ("known" in found.options) == is_taken
    assert (found.instrument.frame_compliance > 0.0) == is_taken
