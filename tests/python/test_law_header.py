# SPDX-License-Identifier: GPL-3.0-or-later
"""The inline headers by themselves: every compiler that is here makes of them the bits of the library, or code of a device."""

from __future__ import annotations

import functools
import platform
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, run

import mdrcontact as mdr
from mdrcontact.plastic import PlasticLaw, Yielding

HEADERS = ROOT / "tests" / "headers"
# a*b + c must stay two operations, where the processor has one for them too
STRICT = ["-O3", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{ROOT / 'include'}"]
if platform.machine() == "x86_64":
    STRICT.append("-mfma")
HOSTS = {
    "C99": ["gcc", "-std=c99"],
    "C++11": ["g++", "-std=c++11", "-x", "c++"],
    "C++20": ["g++", "-std=c++20", "-x", "c++"],
    "clang C99": ["clang", "-std=c99"],
    "clang C++17": ["clang++", "-std=c++17", "-x", "c++"],
    "OpenMP": ["gcc", "-std=c11", "-fopenmp"],
}
COAT = mdr.Coated(mdr.Elastic(72e9, 0.17), 1e-6, mdr.Elastic(160e9, 0.25), "exact")
LAWS = {
    "open and closed": {"contact": mdr.Contact(mdr.Paraboloid(1e-5), COAT), "continue_beyond": True},
    "breaks": {"contact": mdr.Contact(mdr.RoundedCone(2e-7, 0.5), COAT), "continue_beyond": True},
    "adhesion": {"contact": mdr.Contact(mdr.Paraboloid(1e-5), COAT, work_of_adhesion=0.5)},
}


def has_fma():
    words = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""
    return platform.machine() != "x86_64" or " fma " in words


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """Compiles a program of tests/headers by a compiler, once for all laws."""
    folder = tmp_path_factory.mktemp("headers")

    @functools.cache
    def program(source, name):
        compiler, *options = HOSTS[name]
        if not shutil.which(compiler) or not has_fma():
            pytest.skip(f"{compiler} is not installed, or the processor has no fused multiplication")
        target = folder / f"{source} {name}"
        run([compiler, *options, *STRICT, HEADERS / f"{source}.c", "-o", target, "-lm"], folder)
        return target

    return program


@pytest.fixture(params=LAWS, scope="module")
def law(request):
    return mdr.ContactLaw(largest_depth=1e-7, **LAWS[request.param])


def depths(law):
    low, high = law.depth_range
    apart = -np.geomspace(1e-14, 3.0 * high, 4000)
    inside = np.r_[np.geomspace(1e-14, high, 4000), low + (high - low) * np.linspace(0, 1, 4000) ** 5, apart]
    beyond = np.linspace(1.0, 1.5, 50) * high if law._facts["continue_beyond"] else []
    return np.r_[inside[(inside <= high)], low, high, 0.0, beyond]


@pytest.mark.filterwarnings("ignore::mdrcontact.errors.BeyondRangeWarning")
@pytest.mark.parametrize("name", HOSTS)
@pytest.mark.parametrize("branch", ["loading", "unloading"])
def test_bits_of_the_library(name, compiled, branch, law, tmp_path):
    program = compiled("law_points", name)
    d = depths(law)
    d.tofile(tmp_path / "depths")
    law.buffer().tofile(tmp_path / "buffer")
    run([program, "buffer", "depths", str({"loading": 301, "unloading": 302}[branch]), "out"], tmp_path)
    found = np.fromfile(tmp_path / "out").reshape(-1, 7)
    state = law.at_depth(d, branch=branch)
    beyond = np.maximum(d - law.depth_range[1], 0.0)
    columns = (d, state.radius, state.force, state.stiffness, state.slope, law.energy(d, branch), beyond)
    assert found.tobytes() == np.stack(columns, axis=1).tobytes()


PLASTIC = {
    "perfect": {"yield_stress": 1e-4},
    "hardening": {"hardening": [(0.0, 1e-4), (1e-4, 1.5e-4)]},
}


@pytest.mark.parametrize("name", HOSTS)
@pytest.mark.parametrize(("metal", "gamma"), [("perfect", 0.0), ("hardening", 0.0), ("perfect", 1e-13)])
def test_bits_of_plastic_laws(name, compiled, metal, gamma, tmp_path):
    program = compiled("plastic_points", name)
    law = PlasticLaw(mdr.Paraboloid(1.0), Yielding(mdr.Elastic(1.0, 0.3), **PLASTIC[metal]), 1e-5, work_of_adhesion=gamma)
    rng = np.random.default_rng(3)
    memory = law.contacts(5000)
    law.advance(memory, law.largest_depth * rng.uniform(-0.1, 1.0, 5000) ** 3)
    d = law.largest_depth * rng.uniform(-0.1, 1.0, 5000) ** 3
    for values, file in ((law.buffer(), "buffer"), (memory, "memories"), (d, "depths")):
        values.tofile(tmp_path / file)
    run([program, "buffer", "memories", "depths", "out"], tmp_path)
    found = np.fromfile(tmp_path / "out").reshape(-1, 7)
    stored, lost = law.energies(memory, d)
    step = law.advance(memory, d)
    second = memory[:, 1] if gamma else np.zeros(5000)
    columns = (step.force, step.stiffness, step.radius, memory[:, 0], second, stored, lost)
    assert found.tobytes() == np.stack(columns, axis=1).tobytes()


def nvcc():
    """NVIDIA's compiler in the path, or as pip installs it."""
    of_pip = [place / "nvidia" for place in map(Path, sys.path) if (place / "nvidia").is_dir()]
    return shutil.which("nvcc") or next((str(path) for place in of_pip for path in place.glob("cu*/bin/nvcc")), None)


KERNELS = (HEADERS / "law_kernel.cu", HEADERS / "plastic_kernel.cu", ROOT / "benchmarks" / "law_device.cu")


@pytest.mark.parametrize("source", KERNELS, ids=lambda path: path.stem)
def test_cuda(source, tmp_path):
    if not nvcc():
        pytest.skip("nvcc is not installed; pip has it as nvidia-cuda-nvcc, nvidia-cuda-runtime, nvidia-nvvm, nvidia-cuda-crt")
    run([nvcc(), "-ptx", "--fmad=false", "-Werror", "all-warnings", f"-I{ROOT / 'include'}", source, "-o", "law.ptx"], tmp_path)
    code = (tmp_path / "law.ptx").read_text()
    assert ".entry" in code and "mul.rn.f64" in code
    assert not re.search(r"fma\.rn\.f64|\.local|call", code), "the kernel contracts, spills, or calls what is not inline"


@pytest.mark.parametrize("name", ["law_kernel", "plastic_kernel"])
def test_words_of_cuda(name, tmp_path):
    """Without a compiler for devices: each function has CUDA's words, and the kernel is C++."""
    if not shutil.which("g++"):
        pytest.skip("g++ is not installed")
    options = ["-x", "c++", "-std=c++11", "-fsyntax-only", *STRICT, "-include", HEADERS / "cuda_words.h"]
    run(["g++", *options, HEADERS / f"{name}.cu"], tmp_path)
    for header in ("mdrcontact_law.h", "mdrcontact_plastic_law.h"):
        text = (ROOT / "include" / header).read_text(encoding="utf-8")
        assert not re.search(r"^(?!MDR_INLINE|typedef|int mdr_law_(check|view_of))\w[^;={]*\)\s*\n?\{", text, re.MULTILINE)


@pytest.mark.parametrize("kernel", ["law_kernel", "plastic_kernel"])
def test_hip(kernel, tmp_path):
    if not shutil.which("clang++"):
        pytest.skip("clang++ is not installed")
    options = ["-x", "hip", "--cuda-device-only", "-nogpulib", "-nogpuinc", "--offload-arch=gfx90a", "-O2", "-ffp-contract=off"]
    run(["clang++", *options, "-include", HEADERS / "hip_words.h", f"-I{ROOT / 'include'}", "-S", "-emit-llvm",
         HEADERS / f"{kernel}.cu", "-o", "law.ll"], tmp_path)  # fmt: skip
    code = (tmp_path / "law.ll").read_text()
    assert "amdgpu_kernel" in code and "fmul double" in code
    assert not re.search(r"llvm\.fma|fmuladd|call (?!.*@(llvm|memcpy|sqrt))", code), (
        "the kernel contracts, or calls what is not inline"
    )
