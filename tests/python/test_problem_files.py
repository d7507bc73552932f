# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files: what they say, units, and every kind of fault in them."""

import itertools
import math
import re
import subprocess
import sys
import time

import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact import _units as units
from mdrcontact._units import (
    ANGLE,
    FORCE,
    FREQUENCY,
    LENGTH,
    MODULUS,
    RATIO,
    SPEED,
    UnitError,
    is_unit,
    parse,
    practical,
    to_si,
)
from mdrcontact.problem import _PARTS, ProblemError, load, read

GOOD = """
[indenter]
shape = "sphere"
radius = "10 um"
[medium]
type = "coated"
model = "gao"
[medium.coating]
E = "72 GPa"
nu = 0.17
thickness = "500 nm"
[medium.substrate]
E = "163 GPa"
nu = 0.22
[compute]
max_depth = "100 nm"
points = 4
"""


def _load(tmp_path, text):
    path = tmp_path / "problem.toml"
    path.write_text(text, encoding="utf-8")
    return load(path)


def test_a_good_file(tmp_path):
    problem = _load(tmp_path, GOOD)
    assert problem.title == "problem"
    assert problem.indenter == mdr.Sphere(1e-5)
    assert problem.medium == mdr.Coated(mdr.Elastic(72e9, 0.17), 5e-7, mdr.Elastic(163e9, 0.22), "gao")
    assert problem.control.name == "depth"
    assert problem.control.values == pytest.approx([25e-9, 50e-9, 75e-9, 100e-9], rel=1e-14)


def test_units_in_the_key_say_the_same(tmp_path):
    other = GOOD.replace('radius = "10 um"', "radius_um = 10").replace('thickness = "500 nm"', "thickness_nm = 500.0")
    other = other.replace('E = "72 GPa"', "E_GPa = 72").replace('max_depth = "100 nm"', "max_depth_um = 0.1")
    one, two = _load(tmp_path, GOOD), _load(tmp_path, other)
    assert two.indenter.radius == pytest.approx(one.indenter.radius, rel=1e-15)
    assert two.medium.thickness == pytest.approx(one.medium.thickness, rel=1e-15)
    assert pytest.approx(one.medium.coating.E, rel=1e-15) == two.medium.coating.E
    assert two.control.values == pytest.approx(one.control.values, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("500 nm", LENGTH, 5e-7),
        ("500nm", LENGTH, 5e-7),
        ("0.5 \N{MICRO SIGN}m", LENGTH, 5e-7),
        ("0.5 \N{GREEK SMALL LETTER MU}m", LENGTH, 5e-7),
        ("5e-4 mm", LENGTH, 5e-7),
        ("12 angstrom", LENGTH, 1.2e-9),
        (" 70 GPa ", MODULUS, 7e10),
        ("70e3 N/mm^2", MODULUS, 7e10),
        ("2 mN", FORCE, 2e-3),
        ("180 deg", ANGLE, math.pi),
        ("0.3 rad", ANGLE, 0.3),
    ],
)
def test_quantities(text, dimension, value):
    assert parse(text, dimension) == pytest.approx(value, rel=1e-14)


def test_usual_units_of_another_dimension_raise_as_pint_does():
    """Between the dimensions of tables no unit is common, so that their usual units need no registry."""
    pint = units._registry()
    for one, other in itertools.permutations(units._USUAL, 2):
        assert pint.Unit(one.si).dimensionality != pint.Unit(other.si).dimensionality
        for name, _ in other.practical:
            assert units.is_unit(name)
            for _ in range(2):
                with pytest.raises(UnitError, match=f"'{re.escape(name)}' is not a unit of {one.name}"):
                    units.to_si(1.0, name, one)


def test_a_fit_in_usual_units_does_not_load_pint():
    """pint takes half a second to begin."""
    path = ROOT / "examples" / "fit" / "sphere_on_oxide.csv"
    words = ["fit", str(path), "--problem", str(path.with_suffix(".toml"))]
    text = f"import sys; from mdrcontact.cli import main; assert main({words}) == 0; sys.exit('pint' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("text", "dimension", "words"),
    [
        ("500", LENGTH, "no unit.*500 nm"),
        ("500 GPa", LENGTH, "'GPa' is not a unit of a length.*500 nm"),
        ("70 nm", MODULUS, "is not a unit of a modulus.*70 GPa"),
        ("70 Gpa", MODULUS, "no unit 'Gpa': did you mean 'GPa'"),
        ("5 nmm", LENGTH, "did you mean 'nm'"),
        ("five nm", LENGTH, "is not a length"),
        ("", LENGTH, "is not a length"),
        ("nm", LENGTH, "is not a length"),
        ("1 nm 2", LENGTH, "."),
        ("0x10 nm", LENGTH, "."),
        ("1 + 1 nm", LENGTH, "."),
        ("20 nm", ANGLE, "is not a unit of an angle"),
        ("20", ANGLE, "no unit"),
        ("20 percent", ANGLE, "is not a unit of an angle"),
        ("1 __import__('os')", LENGTH, "."),
        ("1 nm**nm", LENGTH, "."),
    ],
)
def test_texts_that_are_no_quantities(text, dimension, words):
    with pytest.raises(UnitError, match=words):
        parse(text, dimension)


CYCLES = {"Hz": 1.0, "hertz": 1.0, "kilohertz": 1e3, "mHz": 1e-3, "cps": 1.0, "counts/s": 1.0, "Bq": 1.0, "kBq": 1e3, "Hz*m/m": 1.0}
TURNS = {"rpm": 1.0 / 60.0, "rps": 1.0, "cycles/s": 1.0, "revolutions/minute": 1.0 / 60.0, "turn/ms": 1e3, "deg/s": 1.0 / 360.0}


@pytest.mark.parametrize(("unit", "cycles"), [*CYCLES.items(), *TURNS.items()])
def test_cycles_per_time_are_times_two_pi(unit, cycles):
    assert to_si(1.0, unit, FREQUENCY) == pytest.approx(2.0 * math.pi * cycles, rel=1e-14)


@pytest.mark.parametrize(("unit", "factor"), [("rad/s", 1.0), ("krad/s", 1e3), ("rad*Hz", 1.0), ("mrad/ms", 1.0)])
def test_radians_per_time_are_taken_as_they_are(unit, factor):
    assert to_si(1.0, unit, FREQUENCY) == pytest.approx(factor, rel=1e-14)


@pytest.mark.parametrize("unit", ["1/s", "s^-1", "1/min", "%/s", "baud", "sr/s", "N"])
def test_what_says_neither_cycles_nor_radians_is_no_frequency(unit):
    with pytest.raises(UnitError, match='write it as in "10 rad/s", or "Hz"'):
        to_si(1.0, unit, FREQUENCY)


@pytest.mark.parametrize(
    ("unit", "dimension"),
    [("nm*turn", LENGTH), ("nm*deg", LENGTH), ("m*rpm", SPEED), ("deg", RATIO), ("count", RATIO), ("%", ANGLE)],
)
def test_turns_and_counts_are_no_plain_numbers(unit, dimension):
    with pytest.raises(UnitError, match="is not a unit of"):
        to_si(1.0, unit, dimension)


@pytest.mark.parametrize("unit", ["m*" * 50000 + "m", "n" * 100000, "(" * 100000, "m" + "**2" * 30000, "m^" + "9" * 100000])
def test_endless_units_are_refused_at_once(unit):
    start = time.process_time()
    assert not is_unit(unit)
    for text in (f"1 {unit}", "1" * 100000):
        with pytest.raises(UnitError, match="characters"):
            parse(text, LENGTH)
    assert time.process_time() - start < 0.5


@pytest.mark.parametrize("dimension", [d for d in vars(units).values() if isinstance(d, units.Dimension) and d is not units.RATIO])
def test_units_mean_the_same_written_and_read(dimension):
    factors = [factor for _, factor in dimension.practical]
    assert [parse(f"1 {name}", dimension) for name, _ in dimension.practical] == pytest.approx(factors, rel=1e-15)
    assert parse(f"1 {dimension.si}", dimension) == 1.0


def test_practical_units():
    assert practical(LENGTH, [1e-9, 9.99e-7]).name == "nm"
    assert practical(LENGTH, [1e-6]).name == "um"
    assert practical(LENGTH, [0.1 + 0.2 - 0.3 + 1e-6]).name == "um"
    assert practical(FORCE, [2e-3]) == ("mN", 1e-3)
    assert practical(MODULUS, [math.inf, 7e10]).name == "GPa"
    assert practical(LENGTH, [0.0]).name == "m"
    assert practical(LENGTH, [1e-30]).name == "pm"


FAULTS = [
    ("[indenter]", "[indentor]", r"unknown key 'indentor'. Did you mean 'indenter'\?"),
    ('shape = "sphere"', 'shape = "spere"', r"\[indenter\]: shape = 'spere': unknown word. Did you mean 'sphere'\?"),
    ('shape = "sphere"', "shape = 3", r"shape = 3: unknown word"),
    ('shape = "sphere"', "", r"\[indenter\]: the key 'shape' is missing. Write it as in shape = \"sphere\""),
    ('radius = "10 um"', "", r"\[indenter\]: the key 'radius' is missing. Write it as in radius = \"500 nm\""),
    ('radius = "10 um"', 'raduis = "10 um"', r"\[indenter\]: unknown key 'raduis'. Did you mean 'radius'\?"),
    ('radius = "10 um"', "radius = 10", r"radius = 10: it has no unit. Write a length as in radius = \"500 nm\""),
    ('radius = "10 um"', 'radius = "10"', r"radius = '10': it has no unit. Write a length as in \"500 nm\""),
    ('radius = "10 um"', 'radius = "10 GPa"', r"radius = '10 GPa': 'GPa' is not a unit of a length. Write it"),
    ('radius = "10 um"', 'radius = "10 umm"', r"there is no unit 'umm'. Did you mean 'um'\?"),
    ('radius = "10 um"', "radius_ux = 10", r"there is no unit 'ux'"),
    ('radius = "10 um"', 'radius_um = "10"', r"The key has the unit already"),
    ('radius = "10 um"', 'radius = "10 um"\nradius_um = 10', r"radius and radius_um give the same quantity twice"),
    ('radius = "10 um"', 'radius = ["10 um"]', r"radius = \['10 um'\]: it must be a length"),
    ('radius = "10 um"', "radius = true", r"radius = True: it must be a length"),
    ('radius = "10 um"', 'radius = "-10 um"', r"\[indenter\]: radius = '-10 um': it must be greater than 0"),
    ('radius = "10 um"', 'radius = "10 um"\ninclination = "20 deg"', r"'inclination' does not belong to the shape 'sphere'"),
    (
        'radius = "10 um"',
        'radius = "10 um"\nmaterial = {E = "1 GPa", nu = 0.3}\nbody = {type = "homogeneous"}',
        r"\[indenter\]: material and body exclude each other",
    ),
    ('radius = "10 um"', 'radius = "10 um"\nbody = {type = "steel"}', r"\[indenter.body\]: type = 'steel': unknown word"),
    (
        'radius = "10 um"',
        'radius = "10 um"\nbody = {type = "power-law-graded", E0 = "1 GPa", z0 = "1 um", exponent = 0.3, nu = 0.3}',
        r"\[indenter\]: upper: a power-law graded body pairs only",
    ),
    ('type = "coated"', 'type = "caoted"', r"Did you mean 'coated'\?"),
    ('type = "coated"', "", r"\[medium\]: the key 'type' is missing"),
    ('type = "coated"', 'type = "homogeneous"', r"does not belong to a medium of type 'homogeneous'"),
    (
        'type = "coated"',
        'type = "coated"\nthickness_um = 1',
        r"thickness is a key of another table. Write it in \[medium.coating\]",
    ),
    ('model = "gao"', 'model = "goa"', r"model = 'goa': unknown word. Did you mean 'gao'\?"),
    ('model = "gao"', 'modl = "gao"', r"unknown key 'modl'. Did you mean 'model'\?"),
    ('model = "gao"', 'model = "gao"\nalpha = 1.0', r"alpha is not an option of the model 'gao'"),
    ('model = "gao"', 'model = "doerner-nix"\nalpha = "1"', r"alpha = '1': it must be a real number"),
    ('model = "gao"', 'model = "garcia"', r"rigid base"),
    ("[medium.coating]", "[medium.caoting]", r"\[medium\]: unknown key 'caoting'. Did you mean 'coating'\?"),
    ("nu = 0.17", "nu = 0.7", r"\[medium.coating\]: nu = 0.7: it must be > -1 and <= 0.5"),
    ("nu = 0.17", "", r"the key 'nu' is missing. Write it as in nu = 0.3"),
    ("nu = 0.17", "nu = 0,17", r"not valid TOML: .*: nu = 0,17. Write numbers with a decimal point"),
    ("nu = 0.17", 'nu = "0.17"', r"\[medium.coating\]: nu = '0.17': it must be a number"),
    ("nu = 0.17", "Nu = 0.17", r"unknown key 'Nu'. Did you mean 'nu'\?"),
    ('E = "72 GPa"', 'E = "72 gpa"', r"there is no unit 'gpa'. Did you mean 'GPa'\?"),
    ('E = "72 GPa"', 'E = "-72 GPa"', r"\[medium.coating\]: E = '-72 GPa': it must be greater than 0"),
    ('E = "72 GPa"', "e_GPa = 72", r"unknown key 'e_GPa'"),
    ('thickness = "500 nm"', 'thickness = "0 nm"', r"\[medium.coating\]: thickness = '0 nm': it must be greater than 0"),
    ("[medium.substrate]", "[medium.substrat]", r"Did you mean 'substrate'\?"),
    ('[medium.substrate]\nE = "163 GPa"\nnu = 0.22', "", r"the table \[medium.substrate\] is missing"),
    ("[compute]", "[computes]", r"Did you mean 'compute'\?"),
    ('thickness = "500 nm"', 'h = "500 nm"', r"unknown key 'h'.*Did you mean 'thickness'\?"),
    ("nu = 0.17", "poisson = 0.17", r"unknown key 'poisson'.*Did you mean 'nu'\?"),
    ("[medium.substrate]", "[medium.base]", r"unknown key 'base'.*Did you mean 'substrate'\?"),
    ("[medium.coating]", "[medium.film]", r"unknown key 'film'.*Did you mean 'coating' or 'layer'\?"),
    ('E = "72 GPa"', 'youngs-modulus = "72 GPa"', r"Did you mean 'E'\?"),
    ('radius = "10 um"', 'diameter = "20 um"', r"unknown key 'diameter'.*Did you mean 'radius'\?"),
    ('[compute]\nmax_depth = "100 nm"\npoints = 4', "", r"the table \[compute\] is missing"),
    ('max_depth = "100 nm"', "", r"exactly one of max_depth, max_force, max_radius"),
    ('max_depth = "100 nm"', 'max_depth = "100 nm"\nmax_force = "1 mN"', r"max_depth and max_force"),
    ('max_depth = "100 nm"', 'max_depht = "100 nm"', r"Did you mean 'max_depth'\?"),
    ('max_depth = "100 nm"', 'max_depth = "-100 nm"', r"max_depth = '-100 nm': .* greater than 0"),
    (
        'max_depth = "100 nm"',
        'max_depth = "100 nm"\nmin_depth = "200 nm"',
        r"min_depth = '200 nm': it must lie between 0 and max_depth = '100 nm'",
    ),
    ('max_depth = "100 nm"', 'max_depth = "100 nm"\nmin_force = "1 mN"', r"'min_force' does not belong to max_depth"),
    (
        'max_depth = "100 nm"\npoints = 4',
        'depths = ["2 nm", "1 nm"]',
        r"entry 2 of depths = '1 nm': .* greater than the one before it",
    ),
    ('max_depth = "100 nm"\npoints = 4', "depths = []", r"depths = \[\]: it needs at least one value"),
    ('max_depth = "100 nm"\npoints = 4', 'depths = "1 nm"', r"depths = '1 nm': it must be a list"),
    ('max_depth = "100 nm"\npoints = 4', "depths = [1, 2]", r"depths = 1: it has no unit"),
    ("points = 4", "points = 0", r"points = 0: .* from 1 to"),
    ("points = 4", "points = 4.5", r"points = 4.5: it must be"),
    ("points = 4", "points = 10_000_000_000", r"points = 10000000000: it must be"),
    ("points = 4", 'spacing = "lin"', r"Did you mean 'linear'\?"),
    ("points = 4", "points = ", r"not valid TOML.*line 17"),
    ("points = 4", "points = 4\npoints = 5", r"not valid TOML"),
    ("points = 4", 'points = 4\n["at line 99999"]\n["at line 99999"]', r"not valid TOML"),
]


@pytest.mark.parametrize("number", range(len(FAULTS)))
def test_faults_are_found_and_told(tmp_path, number):
    old, new, words = FAULTS[number]
    assert old in GOOD
    with pytest.raises(ProblemError, match=words) as caught:
        _load(tmp_path, GOOD.replace(old, new))
    assert str(caught.value).startswith(str(tmp_path / "problem.toml"))
    assert isinstance(caught.value, (mdr.MDRError, ValueError))


def test_the_examples_of_missing_tables_are_read():
    for part in _PARTS.values():
        assert part.example.split()[0] in part.known


def test_files_that_are_no_problem_files(tmp_path):
    with pytest.raises(ProblemError, match="cannot be read: No such file"):
        load(tmp_path / "nowhere.toml")
    with pytest.raises(ProblemError, match="cannot be read"):
        load(tmp_path)
    path = tmp_path / "binary.toml"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ProblemError, match="not a text file in UTF-8"):
        load(path)
    for text in ("", "indenter = 3\n", "[indenter]\n"):
        with pytest.raises(ProblemError):
            _load(tmp_path, text)


def test_files_of_editors_that_mark_their_encoding(tmp_path):
    path = tmp_path / "problem.toml"
    path.write_bytes(b"\xef\xbb\xbf" + GOOD.replace("\n", "\r\n").encode())
    assert load(path).contact() == _load(tmp_path, GOOD).contact()


RADIUS = {"radius": "5 um"}
SHAPES = [
    ({"shape": "paraboloid", **RADIUS}, mdr.Paraboloid(5e-6)),
    ({"shape": "sphere", **RADIUS}, mdr.Sphere(5e-6)),
    ({"shape": "flat-punch", **RADIUS}, mdr.FlatPunch(5e-6)),
    ({"shape": "cone", "inclination": "0.3 rad"}, mdr.Cone(0.3)),
    ({"shape": "cone", "half_angle_deg": 70.3}, mdr.Cone(half_angle=70.3, degrees=True)),
    ({"shape": "power-law", "exponent": 3, "coefficient": 1e-8, "length_unit": "nm"}, mdr.PowerLaw(3.0, 1e10)),
    ({"shape": "flat-ended-cone", "end_radius": "1 um", "inclination": "0.3 rad"}, mdr.FlatEndedCone(1e-6, 0.3)),
    ({"shape": "flat-ended-paraboloid", "end_radius": "1 um", **RADIUS}, mdr.FlatEndedParaboloid(1e-6, 5e-6)),
    ({"shape": "rounded-cone", "blend_radius": "1 um", "inclination": "0.3 rad"}, mdr.RoundedCone(1e-6, 0.3)),
    ({"shape": "berkovich"}, mdr.Berkovich()),
    ({"shape": "vickers"}, mdr.Vickers()),
    ({"shape": "cube-corner"}, mdr.CubeCorner()),
    (
        {"shape": "area-function", "coefficients": [24.5, 200, 3], "length_unit": "nm", "max_height": "1 um"},
        mdr.AreaFunction([24.5, 200e-9, 3 * (1e-9) ** 1.5], max_height=1e-6),
    ),
    ({"shape": "table", "r_um": [0, 1, 2], "f_nm": [0, 100, 400]}, mdr.TabulatedProfile([0, 1e-6, 2e-6], [0, 1e-7, 4e-7])),
]


@pytest.mark.parametrize(("table", "expected"), SHAPES, ids=lambda thing: thing.get("shape") if isinstance(thing, dict) else "")
def test_every_shape(table, expected):
    problem = read({"indenter": table, "medium": MEDIA[0][0], "compute": {"max_depth": "1 nm"}})
    assert type(problem.indenter) is type(expected)
    r = [1e-7, 5e-7]
    assert problem.indenter.height(r) == pytest.approx(expected.height(r), rel=1e-12)


SOFT, HARD = {"E": "2 MPa", "nu": 0.5}, {"E_GPa": 70, "nu": 0.2}
_SOFT, _HARD = mdr.Elastic(2e6, 0.5), mdr.Elastic(70e9, 0.2)
MEDIA = [
    ({"type": "homogeneous", "material": SOFT}, mdr.Homogeneous(_SOFT)),
    (
        {"type": "coated", "model": "doerner-nix", "alpha": 0.9, "coating": {**SOFT, "thickness": "1 um"}, "substrate": HARD},
        mdr.Coated(_SOFT, 1e-6, _HARD, "doerner-nix", alpha=0.9),
    ),
    (
        {"type": "coated", "model": "gao", "weight_nu": "effective", "coating": {**SOFT, "thickness": "1 um"}, "substrate": HARD},
        mdr.Coated(_SOFT, 1e-6, _HARD, "gao", weight_nu="effective"),
    ),
    (
        {"type": "coated", "model": "garcia", "coating": {**SOFT, "thickness": "4 um"}, "substrate": "rigid"},
        mdr.Coated(_SOFT, 4e-6, mdr.RIGID, "garcia"),
    ),
    (
        {"type": "layered", "layer": [{**SOFT, "thickness": "1 um"}, {**HARD, "thickness": "2 um"}], "substrate": SOFT},
        mdr.Layered([(_SOFT, 1e-6), (_HARD, 2e-6)], _SOFT),
    ),
    ({"type": "graded", "z_um": [0, 1], "E_GPa": [1, 2], "nu": 0.3}, mdr.Graded([0, 1e-6], [1e9, 2e9], 0.3)),
    ({"type": "graded", "z_um": [0, 1], "E_GPa": [1, 2], "nu": [0.3, 0.2]}, mdr.Graded([0, 1e-6], [1e9, 2e9], [0.3, 0.2])),
    (
        {"type": "power-law-graded", "E0": "1 GPa", "z0": "1 um", "exponent": 0.3, "nu": 0.3},
        mdr.PowerLawGraded(1e9, 1e-6, 0.3, 0.3),
    ),
    ({"type": "table", "a_um": [1, 2, 3], "moduli_GPa": [1, 2, 3]}, mdr.TabulatedMedium([1e-6, 2e-6, 3e-6], [1e9, 2e9, 3e9])),
]


@pytest.mark.parametrize("number", range(len(MEDIA)))
def test_every_medium(number):
    table, expected = MEDIA[number]
    medium = read({"indenter": SHAPES[0][0], "medium": table, "compute": {"max_depth": "1 nm"}}).medium
    assert type(medium) is type(expected)
    assert medium.modulus([1.5e-6, 2e-6]) == pytest.approx(expected.modulus([1.5e-6, 2e-6]), rel=1e-12)
    assert repr(medium)[:20] == repr(expected)[:20]


@pytest.mark.parametrize("number", range(2))
def test_a_deformable_indenter(number):
    table, lower = MEDIA[number]
    for key, upper in ("material", HARD), ("body", MEDIA[1][0]):
        problem = read({"indenter": {**SHAPES[0][0], key: upper}, "medium": table, "compute": {"max_depth": "1 nm"}})
        assert problem.medium == mdr.Pair(lower, _HARD if key == "material" else MEDIA[1][1])


@pytest.mark.parametrize(
    ("table", "name", "values"),
    [
        ({"max_force": "2 mN", "points": 2}, "force", [1e-3, 2e-3]),
        ({"max_radius_um": 3, "points": 3}, "radius", [1e-6, 2e-6, 3e-6]),
        ({"max_depth": "100 nm", "min_depth": "1 nm", "points": 3, "spacing": "log"}, "depth", [1e-9, 1e-8, 1e-7]),
        ({"max_depth": "100 nm", "points": 4, "spacing": "log"}, "depth", [1e-10, 1e-9, 1e-8, 1e-7]),
        ({"max_depth": "100 nm", "points": 1}, "depth", [1e-7]),
        ({"depths": ["1 nm", "1 um"]}, "depth", [1e-9, 1e-6]),
        ({"forces_mN": [1, 3]}, "force", [1e-3, 3e-3]),
        ({"radii_nm": [100, 200]}, "radius", [1e-7, 2e-7]),
    ],
)
def test_every_way_to_say_what_to_compute(table, name, values):
    control = read({"indenter": SHAPES[0][0], "medium": MEDIA[0][0], "compute": table}).control
    assert control.name == name
    assert control.values == pytest.approx(values, rel=1e-12)


@pytest.mark.parametrize("path", sorted((ROOT / "examples" / "problems").glob("*.toml")), ids=lambda p: p.stem)
def test_example_problems_are_good(path):
    problem = load(path)
    assert problem.title != path.stem
    if problem.history is None:
        assert (problem.control.states(problem.contact()).force > 0).all()
    else:
        force = mdr.studies.history(problem).history.force
        assert (force >= 0).all() and force.max() > 0
