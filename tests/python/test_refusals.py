# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of problem files as data: the table, the key, the entry and the value as the file has it, of which the message is made."""

import copy
import pickle

import pytest
from test_schema import belonging, places, with_key
from walk_files.measured import read_in
from walk_files.tables import steps_to

import mdrcontact as mdr
from mdrcontact._units import RATIO
from mdrcontact.instruments.files.fit_file import fit_file_of_text
from mdrcontact.problem import ProblemError, read, read_text


def refusal(tables, folder):
    """The error of the reader of tables, if it has one."""
    try:
        if "fit" in tables or "map" in tables:
            read_in(folder, "fit" if "fit" in tables else "map", tables)
        else:
            problem = read(tables, folder=folder)
            if problem.conduction:
                problem.conduction.conduction(problem.medium)
    except mdr.MDRError as problem:
        return problem
    return None


TITLES = {"title", "sheet", "name"}
"""Any text is one; columns are any title."""


def wrong_values(one, old):
    """Values that cannot stand there, with the number of the entry if it is one of a list; 0: the whole value."""
    values = [] if one.table is not None or one.name in TITLES else [({"a": 1}, 0)]
    if one.kind == "quantity":
        values += [(wrong, 0) for wrong in ("five", f"3 {'m' if one.dimension.si != 'm' else 'kg'}", True)] if not one.many else []
    if one.kind in ("number", "whole number", "boolean") and not one.many:
        values.append(("five", 0))
    if one.kind == "choice" and not one.dimension and not isinstance(old, dict):
        values += [("five", 0), (True, 0)]
    if one.kind == "table" and not one.choices and not one.many:
        values += [("five", 0), (True, 0)]
    if one.many and isinstance(old, list) and one.kind == "quantity":
        values += [([*old[:-1], wrong], len(old)) for wrong in ("five", True, -1)]
    return values


def outside(one, old):
    """Values just outside of the range of a key."""
    if one.range is None:
        return
    step = one.step or 1e-6
    for end, closed, outwards in (one.range[0], one.range[2], -step), (one.range[1], one.range[3], step):
        if abs(end) == float("inf"):
            continue
        value = end + outwards * closed
        new = int(value) if one.step else value if one.dimension == RATIO else f"{value!r} {one.dimension.si}"
        if isinstance(old, list):
            yield [new, *old[1:]], 1
        elif not one.many:
            yield new, 0


def value_at(tables, path):
    for step in path:
        tables = tables[step]
    return tables


def test_every_key_with_a_wrong_value_is_pointed_at(tmp_path):
    count, lost = 0, []
    for case, place, found, table in places(tmp_path):
        for one in belonging(table, found):
            if one.name not in found:
                continue
            for value, entry in (*wrong_values(one, found[one.name]), *outside(one, found[one.name])):
                tables = with_key(case, place, one.name, value)
                problem = refusal(tables, tmp_path)
                count += 1
                path = (*steps_to(place), one.name, *([entry - 1] if entry else []))
                if not isinstance(problem, ProblemError):
                    lost.append((case.name, place, one.name, value, problem))
                elif problem.path != path:
                    lost.append((case.name, place, one.name, value, problem.path, str(problem)))
                elif problem.value is not None and problem.value != value_at(tables, path):
                    lost.append((case.name, place, one.name, value, problem.value))
    assert count > 2500 and not lost, "\n".join(map(str, lost))


BODY = '[indenter]\nshape = "sphere"\nradius = "10 um"\n[compute]\nmax_depth = "10 nm"\n[medium]\n'
HALF_SPACE = 'type = "homogeneous"\nmaterial = { E = "1 GPa", nu = 0.3 }\n'
FILM = '[[medium.layer]]\nE = "1 GPa"\nnu = 0.3\nthickness = "1 um"\n'
BASE = '[medium.substrate]\nE = "3 GPa"\nnu = 0.3\n'
OF_THE_LIBRARY = [
    (BODY + 'type = "layered"\n' + FILM + FILM + 'prestress = "-90 GPa"\n' + BASE, ("medium", "layer", 1, "prestress"), "-90 GPa"),
    (BODY + 'type = "coated"\nmodel = "dimitriadis"\nsubstrate = "rigid"\n' + FILM.replace("[[medium.layer]]", "[medium.coating]"),
     ("medium", "coating", "nu"), 0.3),
    (BODY + 'type = "homogeneous"\nmaterial = { C11 = "9 GPa", C12 = "10 GPa", C13 = "2 GPa", C33 = "6 GPa", C44 = "1 GPa" }\n',
     ("medium", "material", "C12"), "10 GPa"),
    (BODY + 'type = "graded"\nz = ["1 nm", "1 um"]\nE = ["1 GPa", "2 GPa"]\nnu = 0.3\n', ("medium", "z", 0), "1 nm"),
    (BODY + 'type = "graded"\nz_um = [0.0, 2.0, 1.0]\nE = ["1 GPa", "2 GPa", "3 GPa"]\nnu = 0.3\n', ("medium", "z", 2), 1.0),
    (BODY + 'type = "graded"\nz = ["0 um", "1 um"]\nE = ["1 GPa"]\nnu = 0.3\n', ("medium", "z"), None),
    (BODY + 'type = "homogeneous"\nmaterial = { relaxed_shear_modulus = "1 GPa", moduli = ["1 GPa"], times = [], nu = 0.3 }\n',
     ("medium", "material", "moduli"), None),
    (BODY + 'type = "layered"\nsurface_stretching = "1e300 N/m"\n' + FILM + BASE, ("medium", "surface_stretching"), "1e300 N/m"),
    (BODY + HALF_SPACE + '[adhesion]\nwork_of_adhesion = "0 J/m^2"\nspeed = "1 m/s"\nexponent = 0.5\n',
     ("adhesion", "work_of_adhesion"), "0 J/m^2"),
    (BODY + HALF_SPACE + '[friction]\ncoefficient = 0.3\npath = "x.csv"\n', ("friction", "path"), "x.csv"),
]  # fmt: skip


@pytest.mark.parametrize("number", range(len(OF_THE_LIBRARY)))
def test_errors_of_the_library_are_led_back_to_their_keys(number):
    text, path, value = OF_THE_LIBRARY[number]
    with pytest.raises(ProblemError) as problem:
        read_text(text)
    assert problem.value.path == path and problem.value.value == value
    assert value is None or f" = {value!r}: " in str(problem.value)


def test_a_message_is_made_of_its_parts(tmp_path):
    text = BODY.replace('"10 um"', '"-1 um"') + HALF_SPACE
    with pytest.raises(ProblemError) as problem:
        read_text(text)
    found = problem.value
    assert (found.file, found.table, found.key, found.entry, found.value) == ("", "indenter", "radius", 0, "-1 um")
    assert str(found) == f"[indenter]: radius = '-1 um': {found.rule}." and "e-06" not in str(found)
    (tmp_path / "problem.toml").write_text(text)
    with pytest.raises(ProblemError) as problem:
        mdr.problem.load(tmp_path / "problem.toml")
    path = str(tmp_path / "problem.toml")
    assert problem.value.path == found.path and problem.value.file == path and str(problem.value) == f"{path}: {found}"
    with pytest.raises(ProblemError) as problem:
        read_text(text.replace('"-1 um"', '"wide"'))
    found = problem.value
    assert (found.rule, found.remedy) == ("it is not a length", 'Write it as in "500 nm"')
    assert found.advice == 'It is not a length. Write it as in "500 nm".'
    assert str(found) == "[indenter]: radius = 'wide': it is not a length. Write it as in \"500 nm\"."


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))])
def test_errors_are_copied_whole(copied):
    for text in (BODY + "type = 3\n", "a = ", BODY.replace("radius", "raduis")):
        with pytest.raises(ProblemError) as problem:
            read_text(text)
        other = copied(problem.value)
        assert type(other) is type(problem.value) and str(other) == str(problem.value) and vars(other) == vars(problem.value)


def test_too_long_a_text_is_not_read():
    with pytest.raises(ProblemError, match="it has more than 10 MB"):
        read_text("# " + "x" * 10_000_000)


def test_long_values_are_cut():
    with pytest.raises(ProblemError) as problem:
        read_text(BODY + f'type = "{"x" * 9000}"\n')
    assert len(str(problem.value)) < 1000 and problem.value.value == "x" * 9000
    with pytest.raises(ProblemError, match="radius = 1000"):
        read(
            {
                "indenter": {"shape": "sphere", "radius": 10**4000},
                "medium": {"type": "homogeneous"},
                "compute": {"depths": ["1 nm"]},
            }
        )


FIT = BODY.replace("[compute]\nmax_depth", "[data]\nkind").replace('"10 nm"', '"modulus-radius"') + (
    'type = "homogeneous"\nmaterial = { E = "1 GPa", nu = 0.3 }\n[fit]\nfree = ["E"]\n'
)


@pytest.mark.parametrize(
    ("old", "new", "path"),
    [
        ('free = ["E"]', 'free = ["G"]', ("fit", "free")),
        ('free = ["E"]', "free = 3", ("fit", "free")),
        ('free = ["E"]', '[fit.free."E"]\nprior = "1 GPa"', ("fit", "free", "E", "prior_sd")),
        ('free = ["E"]', '[fit.free."E"]\nstart = "1 nm"', ("fit", "free", "E", "start")),
        ('free = ["E"]', 'free = ["E"]\n[[fit.joint_prior]]\nnames = ["E"]\nvalues = ["1 nm"]\nsds = ["1 GPa"]',
         ("fit", "joint_prior", 0, "values", 0)),
        ('kind = "modulus-radius"', 'kind = "modulus-radius"\nnu = -1', ("data", "nu")),
        ('kind = "modulus-radius"', 'kind = "modulus-radius"\nnu = 1e300', ("data", "nu")),
        ('kind = "modulus-radius"', 'kind = "modulus-radius"\nrelative_sd = 1.0', ("data", "relative_sd")),
        ('kind = "modulus-radius"', 'kind = "modulus-radius"\nsd = "a"\nrelative_sd = 0.1', ("data", "relative_sd")),
        ("[fit]", "[fit]\nmax_iterations = 0", ("fit", "max_iterations")),
        ("[fit]", "[adhesion]\n[fit]", ("adhesion",)),
        ("[fit]", "[fitt]", ("fitt",)),
    ],
)  # fmt: skip
def test_errors_of_fits_point_at_their_keys(old, new, path, tmp_path):
    assert old in FIT
    (tmp_path / "data.csv").write_text("radius [um],modulus [GPa]\n1,1\n2,1\n3,2\n")
    with pytest.raises(ProblemError) as problem:
        fit_file_of_text(FIT.replace(old, new)).read_data(tmp_path / "data.csv")
    assert problem.value.path == path
