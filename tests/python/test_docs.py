# SPDX-License-Identifier: GPL-3.0-or-later
"""Every code block of the guide and of README.md runs, in the order of its page, and prints what the page says."""

from __future__ import annotations

import re
import warnings

import pytest
from code_blocks import Reader, blocks, same_output
from conftest import ROOT

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


@pytest.mark.slow
@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.relative_to(ROOT).with_suffix("").as_posix())
def test_page(path, installed, tmp_path, tmp_path_factory, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    # fonts are searched for once, not for every page
    monkeypatch.setenv("MPLCONFIGDIR", str(tmp_path_factory.getbasetemp()))
    text = path.read_text(encoding="utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of engines that search for MPI
        for host in ("ContactMechanics", "tamaas"):
            if f"from mdrcontact.interop.{host.lower()} import" in text:
                pytest.importorskip(host, reason=f"{host} is not installed: the extra bem")
    reader = Reader(tmp_path, installed)
    for block in blocks(path):
        reader.run(block)


@pytest.mark.parametrize(
    ("page", "words"),
    [
        ("```\nx\n```\n", "must say its language"),
        ("```ruby\nx\n```\n", "there is no way to run 'ruby'"),
        ("Words:\n\n    x = 1\n", "an indented block of code"),
        ("<pre>x</pre>\n", "<pre>"),
        ("```python\nprint(1)\n```\n```text\n2\n```\n", "prints"),
        ("```python\nundefined\n```\n", "line 1: name 'undefined' is not defined"),
        ("```sh\nfalse\n```\n", "status 1"),
        ('```toml\n[indenter]\nshape = "ball"\n```\n', "'ball': unknown word"),
    ],
)
def test_what_does_not_run_is_found(page, words, tmp_path):
    path = tmp_path / "page.md"
    path.write_text(page, encoding="utf-8")
    with pytest.raises(AssertionError, match=words):
        for block in blocks(path):
            Reader(tmp_path, tmp_path).run(block)


@pytest.mark.parametrize(
    ("said", "printed", "same"),
    [
        ("F = 1.23 mN\n", "F =   1.234 mN\n", True),
        ("F = 1.23 mN\n", "F = 1.25 mN\n", False),
        ("F = 1.23 mN\n", "F = 1.23 N\n", False),
        ("12 points\n", "13 points\n", False),
        ("3e-07\n", "3.4e-07\n", True),
        ("a\n...\nd\n", "a\nb\nc\nd\n", True),
        ("a\n...\nd\n", "a\nb\nd\nc\n", False),
        ("a\n", "a\nb\n", False),
        ("a\nb\n", "a\n", False),
    ],
)
def test_outputs_are_compared(said, printed, same):
    assert same_output(said, printed) is same


def test_the_readme_has_the_speeds_of_the_benchmarks():
    """Another run of them changes the page and needs the README, too."""
    seconds = {"ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1.0}
    readme, page = ((ROOT / name).read_text(encoding="utf-8") for name in ("README.md", "docs/benchmarks.md"))
    for said, measured in (
        (r"compiled law, in C; from Python \| (\S+) (ns)", r"compiled law, in C \| - \| (\S+)"),
        (r"compiled law, in C; from Python \| .*; (\S+) (µs)", r"compiled law, from Python \| - \| (\S+)"),
        (r"contact, from Python \| (\S+) (µs)", r"contact, from Python \| - \| (\S+)"),
        (r"tamaas, .* \| (\S+) (ms)", r"tamaas \| 64 x 64 \| (\S+)"),
        (r"tamaas, .* and (\S+) (s)", r"tamaas \| 512 x 512 \| (\S+)"),
        (r"ContactMechanics, .* \| (\S+) (ms)", r"ContactMechanics \| 64 x 64 \| (\S+)"),
        (r"state of a film takes (\S+) (µs)", r"\| 0.1 \| (\S+)"),
        (r"and (\S+) (µs) at a/h = 100", r"\| 100 \| (\S+)"),
        (r"with the exact medium (\S+) (ms)", r"\| paraboloid \| \d+ ms, .*? \| (\S+) ms"),
    ):
        shown, found = re.search(said, readme), re.search(measured, page)
        assert shown and found, (said, measured)
        factor = 1e-3 if measured.endswith(" ms") else 1.0
        assert float(shown[1]) * seconds[shown[2]] == pytest.approx(float(found[1]) * factor, rel=0.15), said
