# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiled module that lies under the package."""

import ast
import ctypes
import gc
import re
import shutil
import subprocess
import sys
import weakref
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import _boundary, _layout, _native

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "python" / "src"))
from wrap_header import parts_of, prototypes, without_comments  # noqa: E402

PACKAGE = ROOT / "python" / "mdrcontact"


def test_what_follows_from_the_headers_is_up_to_date(tmp_path):
    """What tools/generate.py writes lies in the repository."""
    program = ROOT / "tools" / "generate.py"
    subprocess.run([sys.executable, program, tmp_path], check=True)
    made = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert len(made) > 5
    for path in made:
        kept = ROOT / path.relative_to(tmp_path)
        assert path.read_text(encoding="utf-8") == kept.read_text(encoding="utf-8"), f"{kept} is out of date: run {program}"


def test_the_umbrella_header_is_the_core():
    """An extension's functions, structures and enumerations need its own header, which all.h includes."""
    include = ROOT / "include"
    core, everything = (parts_of(include / name) for name in ("mdrcontact.h", "mdrcontact/all.h"))
    extensions = [path.stem for path in everything if path not in core][:-1]
    assert extensions == ["time", "adhesion", "wear", "conduction", "poroelastic", "plastic", "lateral", "fit"]
    assert {path.stem for path in (include / "mdrcontact").glob("*.h")} == {path.stem for path in everything} - {"mdrcontact"}
    functions = prototypes(without_comments(include / "mdrcontact.h"))
    assert 75 < len(functions) <= 95
    for name in extensions:
        path = include / "mdrcontact" / f"{name}.h"
        assert f"Option MDRCONTACT_{name.upper()}." in " ".join(path.read_text(encoding="utf-8").replace("\n *", "").split())
        own = {word for _, word, _ in prototypes(re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL))}
        assert own
        assert not own & {word for _, word, _ in functions}
        assert not [word for word in own if re.search(rf"\b{word}\b", (include / "mdrcontact.h").read_text(encoding="utf-8"))]


def test_every_structure_that_grows_is_used_at_every_size():
    """The C test of programs with another header leaves none out."""
    headers = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "include").rglob("*.h"))
    growing = re.findall(r"typedef struct (mdr_\w+) \{\s*size_t size;", headers)
    used = re.findall(r"EVERY_SIZE\(\w+, (mdr_\w+),", (ROOT / "tests" / "c" / "test_sized.c").read_text(encoding="utf-8"))
    assert len(growing) > 10
    assert sorted(used) == sorted(growing)


def test_every_function_of_the_types_exists():
    text = (ROOT / "python" / "mdrcontact" / "_native.pyi").read_text(encoding="utf-8")
    names = [line.split("(")[0].removeprefix("def ") for line in text.splitlines() if line.startswith("def ")]
    assert len(names) > 80
    assert [name for name in names if not callable(getattr(_native, name, None))] == []


@pytest.mark.skipif(sys.platform != "linux" or not shutil.which("nm"), reason="lists the symbols of an ELF file by nm")
def test_only_the_init_function_is_exported():
    words = subprocess.run(["nm", "-D", "--defined-only", _native.__file__], capture_output=True, text=True, check=True).stdout
    assert [line.split()[-1] for line in words.splitlines()] == ["PyInit__native"]


ADDRESSES = {"address", "_address", "data", "data_as", "__array_interface__", "addressof", "byref", "pointer", "cast", "_native"}
"""Names by which Python reaches an address, or a function that takes one."""
ALLOWED = {
    "_boundary.py": ADDRESSES,
    "poroelastic.py": {"_address"},  # of NoElasticStates, which has none
    "__init__.py": {"_native"},  # its version
    "_callback.py": {"POINTER"},
}


def uses_of_addresses(path):
    """Names of ADDRESSES in a source, as an attribute of anything, a name, or an import; `x.data` alone is no address."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Attribute) and node.attr in ADDRESSES - {"data"}:
            found.add(node.attr)
        if isinstance(node, ast.Attribute) and node.attr == "data" and getattr(node.value, "attr", "") == "ctypes":
            found.add("data")
        if isinstance(node, ast.FunctionDef) and node.name in ADDRESSES:
            found.add(node.name)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ADDRESSES:
            found.add(node.func.id)
        if isinstance(node, ast.ImportFrom):
            found |= {alias.name for alias in node.names} & (ADDRESSES - {"data"}) | ({node.module} & {"_native"})
    return found


def test_only_the_boundary_knows_addresses():
    """An address that something else keeps may be that of an object which Python has freed."""
    sources = sorted(PACKAGE.rglob("*.py"))
    assert len(sources) > 150
    found = {str(path.relative_to(PACKAGE)): uses_of_addresses(path) for path in sources}
    assert {name: uses for name, uses in found.items() if uses - ALLOWED.get(name, set())} == {}
    assert "_address" in found["_boundary.py"]


def test_the_search_for_addresses_finds_them(tmp_path):
    for words in (
        "f(address(record(x)))",
        "f(x._handle.address)",
        "f(x.ctypes.data)",
        "from . import _native",
        "from ._native import f",
    ):
        (tmp_path / "source.py").write_text(words, encoding="utf-8")
        assert uses_of_addresses(tmp_path / "source.py"), words


def test_every_pointer_has_a_place():
    """The types of the functions and the places of their pointers agree."""
    text = (PACKAGE / "_native.pyi").read_text(encoding="utf-8")
    typed = {}
    for name, words in re.findall(r"^def (\w+)\(([^)]*)\)", text, re.MULTILINE):
        arguments = [word for word in words.replace("\n", " ").split(",") if ":" in word]
        typed[name] = tuple(i for i, word in enumerate(arguments) if "Pointer" in word)
    scalars = {name for name in typed if name.endswith("_scalar")}
    assert scalars == {"law_force_scalar", "law_state_scalar"}  # they take the handle in C
    assert {name: places for name, places in typed.items() if places and name not in scalars} == _layout.POINTERS


def temporary():
    """An array that nothing but the call holds, and a weak reference to it."""
    array = np.arange(5.0)
    return array, weakref.ref(array)


def test_what_a_call_reads_lives_until_it_returns():
    """Arrays and handles that the caller does not keep."""
    seen = []

    def function(number, first, second):
        gc.collect()
        others = [np.full(5, -1.0) for _ in range(50)]  # they take the memory of what was freed
        seen.append([alive() is not None for alive in (array, handle)])
        seen.append(list((ctypes.c_double * 5).from_address(first)))
        return number, second, others

    def given():
        nonlocal array, handle
        made, array = temporary()
        owner = _boundary.Handle(_native.profile_paraboloid(1.0))
        handle = weakref.ref(owner)
        return 7, made, owner

    array = handle = None
    assert _boundary._holding(function, (1, 2))(*given())[0] == 7
    gc.collect()
    assert seen == [[True, True], [0.0, 1.0, 2.0, 3.0, 4.0]]
    assert array() is None and handle() is None


def test_a_record_holds_what_it_points_to():
    made, alive = temporary()
    one = _boundary.record(_layout.contact_options, zeta=made)
    many = _boundary.records(_layout.layer, [{"material": _boundary.Handle(_native.profile_cone(0.1))}, {}])
    place = made.ctypes.data
    del made
    later = one.copy()
    del one
    gc.collect()
    assert alive() is not None and int(later["zeta"][0]) == place
    later["zeta"] = None
    gc.collect()
    assert alive() is None and int(later["zeta"][0]) == 0
    assert list(_boundary.record(_layout.structure_options, origin=np.array([1.0, 2.0]))["origin"][0]) == [1.0, 2.0]
    assert many._held["material"][0]._address == many["material"][0] and many["material"][1] == 0


@pytest.mark.parametrize("value", [np.arange(6.0)[::2], 7, "text", 1.5])
def test_what_is_no_pointer_is_refused(value):
    with pytest.raises((TypeError, ValueError, ctypes.ArgumentError)):
        _boundary.native.profile_values(value, _layout.HEIGHT, [1.0])


def half_space(i):
    """F of a half-space whose modulus no other call has, over that modulus."""
    modulus = 1e9 * (1 + i % 97)
    try:
        return mdr.Contact(BALL, mdr.Homogeneous(mdr.Elastic(modulus, 0.17))).at_depth(1e-8).force / modulus
    except mdr.MDRError as problem:
        return str(problem)


BALL = mdr.Sphere(1e-5)


@pytest.mark.parametrize("threads", [2, 8])
def test_threads_make_bodies_of_their_own(threads):
    """Each half-space has the modulus that it was given; of 40,000 made by four threads 207 were refused once."""
    with ThreadPoolExecutor(threads) as pool:
        found = Counter(round(value, 20) if isinstance(value, float) else value for value in pool.map(half_space, range(4000)))
    assert len(found) == 1, found.most_common(3)


@pytest.mark.slow
@pytest.mark.parametrize("threads", [2, 8])
def test_folders_of_curves_lose_none(threads):
    """Fits of sound curves from several threads: none is refused, and all give what one thread gives."""

    def curve(seed):
        noise = np.random.default_rng(seed).standard_normal((2, 300))
        u = np.linspace(1.0, 0.0, 300)
        return mdi.Unloading((300 + 92 * u + 0.05 * noise[0]) * 1e-9, (11.0 * u**1.5 + 5e-6 * noise[1]) * 1e-3)

    tip, tool = mdr.AreaFunction([24.5], max_height=1e-6), mdi.Instrument(indenter=mdr.Elastic(1141e9, 0.07))
    curves, body = [curve(seed) for seed in range(100)], mdr.Homogeneous(mdr.Elastic(100e9, 0.3))
    alone, many = (mdi.fit_many(curves, tip, body, ["E"], instrument=tool, threads=n) for n in (1, threads))
    assert [type(result).__name__ for result in many] == ["FitResult"] * 100
    assert [result.estimates["E"] for result in many] == [result.estimates["E"] for result in alone]
