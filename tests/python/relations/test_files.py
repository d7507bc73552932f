# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files, tables, units and the command line against Python."""

import contextlib
import csv
import io
import math
import tempfile
from pathlib import Path

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

import mdrcontact as mdr
from mdrcontact import _units as units
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.reading.columns import read_table
from mdrcontact.problem import read

from . import draws as d
from .harness import near, relation

PREFIXES = {"n": 1e-9, "u": 1e-6, "m": 1e-3, "": 1.0, "k": 1e3, "M": 1e6, "G": 1e9}
NAMES = {"n": "nano", "u": "micro", "m": "milli", "": "", "k": "kilo", "M": "mega", "G": "giga"}
BASES = {
    units.LENGTH: ("m", "meter"),
    units.MODULUS: ("Pa", "pascal"),
    units.FORCE: ("N", "newton"),
    units.STIFFNESS: ("N/m", "newton/meter"),
    units.WORK_OF_ADHESION: ("J/m^2", "joule/meter^2"),
    units.ENERGY: ("J", "joule"),
    units.TIME: ("s", "second"),
    units.VOLTAGE: ("V", "volt"),
    units.SPEED: ("m/s", "meter/second"),
    units.SENSITIVITY: ("m/V", "meter/volt"),
}
prefixes = st.sampled_from(sorted(PREFIXES))
values = d.between(1e-3, 1e3)


@relation(40, dimension=st.sampled_from(sorted(BASES)), prefix=prefixes, value=values)
def test_prefixes_and_long_names(dimension, prefix, value):
    """A value with a prefix and with the unit's long name against the value times the prefix."""
    short, long = BASES[dimension]
    for text in (f"{value!r} {prefix}{short}", f"{value!r} {NAMES[prefix]}{long}", f"{value!r}{prefix}{short}"):
        near(units.parse(text, dimension), value * PREFIXES[prefix], 1e-14)


@relation(40, dimension=st.sampled_from(sorted(BASES)), value=d.between(1e-12, 1e12))
def test_practical_units(dimension, value):
    """A value written in its practical unit and read again against itself."""
    unit = units.practical(dimension, [value])
    near(units.parse(f"{float(unit.of(value))!r} {unit.name}", dimension), value, 1e-14)


def quantity(value, prefix, base):
    """A value in SI as a text in another unit."""
    return f"{float(value) / PREFIXES[prefix]!r} {prefix}{base}"


def problem_of(R, film, h, base, depth, prefix):
    return {
        "indenter": {"shape": "sphere", "radius": quantity(R, prefix, "m")},
        "medium": {
            "type": "coated",
            "coating": {"E": quantity(film.E, prefix, "Pa"), "nu": film.nu, "thickness": quantity(h, prefix, "m")},
            "substrate": {"E": quantity(base.E, prefix, "Pa"), "nu": base.nu},
        },
        "compute": {"depths": [quantity(depth, prefix, "m")]},
    }


def toml_of(table):
    """The text of a problem."""
    lines = []
    for name in ("indenter", "medium", "compute"):
        lines.append(f"[{name}]")
        inner = {key: value for key, value in table[name].items() if isinstance(value, dict)}
        lines += [f"{key} = {value!r}" for key, value in table[name].items() if key not in inner]
        for key, values in inner.items():
            lines += [f"[{name}.{key}]", *(f"{k} = {v!r}" for k, v in values.items())]
    return "\n".join(lines).replace("'", '"')


coats = {
    "R": d.between(1e-7, 1e-2),
    "film": st.builds(mdr.Elastic, d.between(1e6, 1e12), d.usual_ratios),
    "h": d.between(1e-8, 1e-4),
    "base": st.builds(mdr.Elastic, d.between(1e6, 1e12), d.usual_ratios),
    "share": d.between(1e-4, 1e-2),
    "prefix": prefixes,
}


@relation(20, may_refuse=0.3, **coats)
def test_problem_files(R, film, h, base, share, prefix):
    """The contact of a problem in any units, with the unit in the value or in the key, against the contact of its numbers in SI."""
    contact = mdr.Contact(mdr.Sphere(R), mdr.Coated(film, h, base))
    table = problem_of(R, film, h, base, share * R, prefix)
    expected = contact.at_depth(share * R).force
    near(read(table).contact().at_depth(share * R).force, expected, 1e-9)
    table["indenter"] = {"shape": "sphere", "radius_um": R * 1e6}
    near(read(table).contact().at_depth(share * R).force, expected, 1e-9)
    near(read(table).control.values, share * R, 1e-14)


@relation(8, may_refuse=0.3, **coats)
def test_command_line(R, film, h, base, share, prefix):
    """`mdrcontact curve --csv` against Python."""
    contact = mdr.Contact(mdr.Sphere(R), mdr.Coated(film, h, base))
    expected = contact.at_depth(share * R)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "problem.toml").write_text(toml_of(problem_of(R, film, h, base, share * R, prefix)))
        with contextlib.redirect_stdout(io.StringIO()):
            assert main(["curve", f"{folder}/problem.toml", "--csv", f"{folder}/curve.csv"]) in (0, None)
        titles, row = list(csv.reader((Path(folder) / "curve.csv").read_text().splitlines()))
    found = {}
    for title, cell in zip(titles, row, strict=True):
        name, _, unit = title.partition(" [")
        found[name] = (float(cell), unit.rstrip("]"))
    for name, value, dimension in (("depth", expected.depth, units.LENGTH), ("force", expected.force, units.FORCE)):
        number, unit = found[name]
        near(units.parse(f"{number!r} {unit}", dimension), value, 1e-9)


numbers = st.lists(st.tuples(d.between(1e-3, 999.0), d.between(1e-3, 999.0)), min_size=3, max_size=12)


@relation(
    40,
    rows=numbers,
    separator=st.sampled_from(["\t", ";", ",", " "]),
    mark=st.sampled_from([".", ","]),
    digits=st.integers(4, 12),
    crlf=st.booleans(),
)
def test_tables(rows, separator, mark, digits, crlf):
    """Columns of a table, whatever its separator and decimal mark, against the numbers written."""
    assume(separator != "," or mark != ",")
    cells = [[f"{value:.{digits}f}".replace(".", mark) for value in row] for row in rows]
    lines = [separator.join(["depth[nm]", "load[mN]"]), *(separator.join(row) for row in cells)]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "curve.txt"
        path.write_bytes(("\r\n" if crlf else "\n").join(lines).encode())
        table = read_table(path)
        for i, (title, dimension, factor) in enumerate((("depth", units.LENGTH, 1e-9), ("load", units.FORCE, 1e-3))):
            column, _ = table.column(table.find(title, [title], dimension), dimension)
            near(column, [float(row[i].replace(mark, ".")) * factor for row in cells], 1e-14)


@relation(
    20,
    steps=st.lists(d.between(0.1, 10.0), min_size=3, max_size=6),
    size=d.between(1e-9, 1e-3),
    E=d.between(1e6, 1e12),
    n=st.floats(0.5, 4.0),
    prefix=prefixes,
)
def test_indenters_of_files(steps, size, E, n, prefix):
    """Tables, power laws and area functions with units of their own against those in SI."""
    r = size * np.array([0.0, *np.cumsum(steps)])
    compute = {"depths": [quantity(1e-9, prefix, "m")]}
    medium = {"type": "homogeneous", "material": {"E": quantity(E, prefix, "Pa"), "nu": 0.3}}
    table = {"shape": "table", "r": [quantity(x, prefix, "m") for x in r], "f": [quantity(x, prefix, "m") for x in 0.1 * r]}
    found = read({"indenter": table, "medium": medium, "compute": compute}).indenter
    near(found.height(0.5 * r[-1]), mdr.TabulatedProfile(r, 0.1 * r).height(0.5 * r[-1]), 1e-9)
    power = {"shape": "power-law", "exponent": n, "coefficient": 0.3, "length_unit": f"{prefix}m"}
    found = read({"indenter": power, "medium": medium, "compute": compute}).indenter
    near(found.height(1e-6), 0.3 * PREFIXES[prefix] * (1e-6 / PREFIXES[prefix]) ** n, 1e-11)
    area = {"shape": "area-function", "coefficients": [24.5, 300.0], "length_unit": "nm", "max_height": "1 um"}
    found = read({"indenter": area, "medium": medium, "compute": compute}).indenter
    near(found.height(5e-7), mdr.AreaFunction([24.5, 3e-7], max_height=1e-6).height(5e-7), 1e-9)


CYCLES = 2.0 * math.pi
SPELLINGS = {"Hz": CYCLES, "hertz": CYCLES, "cps": CYCLES, "Bq": CYCLES, "kHz": 1e3 * CYCLES, "kilohertz": 1e3 * CYCLES,
             "mHz": 1e-3 * CYCLES, "counts_per_second": CYCLES, "rad/min": 1.0 / 60.0, "rpm": CYCLES / 60.0, "rad/s": 1.0,
             "1/s": 1.0}  # fmt: skip
"""Of angular frequency, in rad/s."""


@relation(30, unit=st.sampled_from(sorted(SPELLINGS)), omega=d.between(0.1, 100.0), may_refuse=0.6)
def test_spellings_of_frequencies(unit, omega):
    """omega in a column of any spelling of hertz against the same column in rad/s."""
    rows = [f"{omega * k!r},{1.0 + 0.1 * k!r},{0.1 * k!r}" for k in range(1, 6)]
    problem = (
        '[indenter]\nshape = "flat-punch"\nradius = "1 um"\n[medium]\ntype = "homogeneous"\n'
        'material = { modulus = "1500 Pa", time = "1 s", exponent = 0.25, nu = 0.5 }\n'
        '[data]\nkind = "dynamic-stiffness"\ncontact_radius = "1 um"\n[fit]\nfree = ["modulus", "exponent"]\n'
    )
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "curve.csv").write_text("\n".join([f"frequency [{unit}],storage [N/m],loss [N/m]", *rows]))
        (Path(folder) / "fit.toml").write_text(problem)
        file = load_fit_file(Path(folder) / "fit.toml")
        data, _ = file.read_data(Path(folder) / "curve.csv")
    near(np.unique(data.x), omega * SPELLINGS[unit] * np.arange(1, 6), 1e-12)


@relation(
    30,
    rows=st.lists(st.tuples(st.integers(900, 99999), d.between(0.1, 999.0)), min_size=3, max_size=8),
    separator=st.sampled_from(["\t", ";"]),
    mark=st.sampled_from([".", ","]),
    may_refuse=1.0,
)
def test_grouped_thousands(rows, separator, mark):
    """Columns with grouped thousands beside a decimal mark against the numbers; refused where it may be both."""
    group = "," if mark == "." else "."
    cells = [(f"{whole:,}".replace(",", group), f"{part:.3f}".replace(".", mark)) for whole, part in rows]
    lines = [separator.join(["depth [nm]", "load [mN]"]), *(separator.join(row) for row in cells)]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "curve.txt"
        path.write_text("\n".join(lines))
        table = read_table(path)
        depth, _ = table.column(table.find("depth", ["depth"], units.LENGTH), units.LENGTH)
        load, _ = table.column(table.find("load", ["load"], units.FORCE), units.FORCE)
    near(depth, [whole * 1e-9 for whole, _ in rows], 1e-14)
    near(load, [float(f"{part:.3f}") * 1e-3 for _, part in rows], 1e-14)
