# SPDX-License-Identifier: GPL-3.0-or-later
"""The order of the guide: every page is in the index, three reading paths, no dead links."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT

DOCS = ROOT / "docs"
PAGES = sorted(DOCS.glob("*.md"))
THEORY = sorted((DOCS / "theory").glob("*.md"))
INDEX = (DOCS / "index.md").read_text()
EXAMPLES = ROOT / "examples" / "README.md"
NOT_IN_THE_SOURCE_PACKAGE = {"benchmarks"}
"""Folders that it leaves out (pyproject.toml): links to them are looked at where they are."""
LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`|\$\$.*?\$\$|\$[^$\n]*\$", re.DOTALL | re.MULTILINE)
"""What holds no links: code and formulas."""


def anchors(text):
    """Of the headings of a page, as GitHub and MkDocs name them, and those that it sets itself."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    named = {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}
    return named | set(re.findall(r'<a id="([\w-]+)">', text))


def dead(path):
    """Links of a page to files or headings that are not there."""
    found = []
    for link in LINK.findall(CODE.sub("", path.read_text())):
        name, _, anchor = link.partition("#")
        if name.startswith(("http:", "https:", "mailto:")):
            continue
        target = (path.parent / name).resolve() if name else path
        if any(target.is_relative_to(ROOT / folder) and not (ROOT / folder).exists() for folder in NOT_IN_THE_SOURCE_PACKAGE):
            continue
        if not target.exists() or (anchor and target.suffix == ".md" and anchor not in anchors(target.read_text())):
            found.append(link)
    return found


@pytest.mark.parametrize(
    "path",
    [*PAGES, *THEORY, EXAMPLES, *sorted(set(ROOT.glob("*.md")) - {ROOT / "ford.md"})],
    ids=lambda path: str(path.relative_to(ROOT)),
)
def test_no_dead_links(path):
    assert not dead(path)


def test_dead_links_are_found(tmp_path):
    page = tmp_path / "page.md"
    page.write_text('# A title\n\n<a id="key"></a> [a](#a-title) [b](other.md) [c](#no) `[d](x)` [e](#key) $[f](y)$\n')
    assert dead(page) == ["other.md", "#no"]


def test_every_page_is_in_the_index():
    linked = {link.partition("#")[0] for link in LINK.findall(INDEX)}
    assert {path.relative_to(DOCS).as_posix() for path in [*PAGES, *THEORY]} - {"index.md"} <= linked


def test_three_paths_of_five_pages_that_end_with_the_reader():
    paths = [line.strip("| ").split(" | ") for line in INDEX.splitlines() if line.startswith("| ") and "(install.md)" in line]
    assert len(paths) == 3
    for _, *steps in paths:
        assert len(steps) <= 5 and all(LINK.search(step) for step in steps)
        name, _, anchor = LINK.findall(steps[-1])[0].partition("#")
        last = (DOCS / name).read_text().rpartition("\n## ")[2]
        assert anchor in anchors(f"## {last}") and anchor.startswith("your-own-")


def without_caption(text):
    """Pictures that no line in italics follows."""
    lines = [line for line in text.splitlines() if line.strip()]
    return [
        a
        for a, b in zip(lines, [*lines[1:], ""], strict=True)
        if a.startswith("![") and not re.search(r"(^|<br>)\*[^ *]", a[2:] + "\n" + b, re.MULTILINE)
    ]


@pytest.mark.parametrize("path", [ROOT / "README.md", *PAGES, *THEORY], ids=lambda path: str(path.relative_to(ROOT)))
def test_every_picture_has_a_caption(path):
    assert not without_caption(path.read_text(encoding="utf-8"))


def test_a_picture_without_a_caption_is_found():
    assert without_caption("![a](a.png)\n\n*What is plotted.*\n\n![b](b.png)\n\n* an item\n\n![c](c.png)<br>*c*\n") == [
        "![b](b.png)"
    ]


def test_examples_are_listed():
    listed = {link for link in LINK.findall(EXAMPLES.read_text(encoding="utf-8")) if not link.startswith("../")}
    examples = {path.relative_to(EXAMPLES.parent) for path in EXAMPLES.parent.glob("*/*")}
    programs = {path.as_posix() for path in examples if path.suffix in (".toml", ".py", ".c", ".f90", ".f")}
    assert len(programs) > 40 and programs <= listed


def test_every_script_is_in_the_gallery():
    page = (DOCS / "gallery.md").read_text(encoding="utf-8")
    for script in (ROOT / "examples" / "python").glob("*.py"):
        assert f"(pictures/gallery_{script.stem}.png)" in page and f"(../examples/python/{script.name})" in page


def named_paths(text):
    """Files and folders that a text names as code: with a folder, or in a block of commands; `<name>` and `*` stand for any."""
    spans = re.findall(r"`([\w.<>*-]+(?:/[\w.<>*-]*)+)`", re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE))
    return {*spans, *re.findall(r"\b(?:tools|docs|tests)/[\w/.]+\.(?:sh|py)\b", text)}


def test_contributing_names_what_there_is():
    """Of a new `<name>` the folder exists, and something of that kind in it; what is built need not be there."""
    named = named_paths((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    assert {"src/mdrcontact/bodies/profile/<name>.f90", "tools/generate.py", "include/mdrcontact/medium.h"} <= named
    missing = [name for name in sorted(named) if not name.startswith("build/") and not any(ROOT.glob(re.sub("<[^>]*>", "*", name)))]
    assert not missing


def test_contributing_has_short_lines():
    lines = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").splitlines()
    assert max(map(len, lines)) <= 132


def test_a_path_that_is_gone_is_found():
    assert named_paths("see `src/a.f90`, `<name>/b`, `word`, 1/2\n```sh\ntools/c.sh keep\n```\n") == {
        "src/a.f90",
        "<name>/b",
        "tools/c.sh",
    }


def tree(text):
    """Paths of a tree drawn by indentation, four columns a level; what each is stands from column 32 on."""
    above = []
    for line in text.splitlines():
        level = (len(line) - len(line.lstrip())) // 4
        for name in line[:32].split() if level < 8 else []:
            if name != "...":
                above[level:] = [name]
                yield "".join(above)


def test_the_tree_of_the_architecture_is_that_of_the_repository():
    text = (DOCS / "architecture.md").read_text(encoding="utf-8").partition("## Folders")[2]
    drawn = set(
        tree(next(block for block in re.findall(r"^```text\n(.*?)^```$", text, re.DOTALL | re.MULTILINE) if "/" in block[:10]))
    )
    rooms = [*(ROOT / "src" / "mdrcontact").iterdir(), *(ROOT / "src" / "mdrcontact" / "extensions").glob("[!R]*/")]
    assert {f"{path.relative_to(ROOT).as_posix()}/" for path in rooms if path.is_dir()} <= drawn
    assert not [
        path for path in sorted(drawn) if not (ROOT / path).exists() and path.split("/")[0] not in NOT_IN_THE_SOURCE_PACKAGE
    ]
