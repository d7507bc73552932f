# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes for conda-forge and Spack need what pyproject.toml and CMakeLists.txt need, in the same versions."""

from __future__ import annotations

import re
import runpy
import sys
from contextlib import contextmanager
from types import ModuleType

import pytest
from conftest import ROOT

yaml = pytest.importorskip("yaml")
tomllib = pytest.importorskip("tomllib")

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
CMAKE = (ROOT / "CMakeLists.txt").read_text()


def numbers(requirements):
    """Names and smallest versions."""
    found = (re.match(r"([\w-]+)\s*>=\s*([\d.]+)", words) for words in requirements)
    return {one[1]: tuple(int(part) for part in one[2].split(".")) for one in found if one}


BUILD, RUN = numbers(PROJECT["build-system"]["requires"]), numbers(PROJECT["project"]["dependencies"])


def test_conda():
    recipe = yaml.safe_load((ROOT / "recipes" / "conda" / "recipe.yaml").read_text())
    needs = recipe["requirements"]
    conditional = [entry["then"] for entry in needs["run"] if isinstance(entry, dict)]
    assert numbers([entry for entry in needs["run"] if isinstance(entry, str)] + conditional) == RUN
    host = numbers(needs["host"])
    assert host.pop("gsl") == (2, 5) and "find_package(GSL 2.5" in CMAKE
    assert host == BUILD and {"libblas", "liblapack"} <= set(needs["host"])
    assert numbers(needs["build"])["cmake"] == (3, 22) and "VERSION 3.22" in CMAKE
    (script,) = PROJECT["project"]["scripts"].items()
    assert recipe["build"]["python"]["entry_points"] == [" = ".join(script)]
    assert recipe["about"]["license"] == PROJECT["project"]["license"]
    assert recipe["about"]["summary"] == PROJECT["project"]["description"]


class Recipe:
    """Stands for Spack: takes down what a recipe declares."""

    def __init__(self):
        self.variants, self.needs = [], {}

    def depends_on(self, need, **_):
        name, _, least = need.partition("@")
        self.needs[name.removeprefix("py-")] = tuple(int(part) for part in least.rstrip(":").split(".")) if least else ()

    def modules(self):
        @contextmanager
        def when(_):
            yield

        package, cmake = ModuleType("spack.package"), ModuleType("spack_repo.builtin.build_systems.cmake")
        cmake.CMakePackage = type("CMakePackage", (), {"define": lambda _, *a: a, "define_from_variant": lambda _, *a: a})
        package.variant = lambda name, **_: self.variants.append(name)
        package.depends_on = package.extends = self.depends_on
        package.license = package.version = lambda *_, **__: None
        package.when, package.run_after = when, lambda _: lambda f: f
        return {module.__name__: module for module in (package, cmake)}


def test_spack(monkeypatch):
    recipe = Recipe()
    for name, module in recipe.modules().items():
        monkeypatch.setitem(sys.modules, name, module)
    made = runpy.run_path(str(ROOT / "recipes" / "spack" / "package.py"))["Mdrcontact"]()
    least = {name.lower(): version for name, version in recipe.needs.items()}
    assert least["cmake"] == (3, 22) and least["gsl"] == (2, 5) and least["python"] == (3, 10)
    for name, version in (RUN | BUILD).items():
        assert least[name][: len(version)] == version[: len(least[name])], name
    for option, _ in made.cmake_args():
        assert f"option({option} " in CMAKE
