# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds guide and Fortran API into one folder of HTML. python docs/site/build.py OUTPUT

Ends with status 1 if FORD or anything here has a warning: an undocumented public entity, a link that leads nowhere, a page that
FORD cannot read. What it writes needs no network: FORD's links to style sheets and scripts elsewhere are replaced.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

from pages import PageError, ordered, page
from undocumented import undocumented

SITE = Path(__file__).resolve().parent
ROOT = SITE.parents[1]
DOCS, SOURCE = ROOT / "docs", ROOT / "src"
C_LAYER = SOURCE / "mdrcontact" / "api"
"""Its manual is mdrcontact.h."""

_ELSEWHERE = re.compile(
    r"<!-- MathJax -->.*?(?=<!-- Other)|<link[^>]*https://[^>]*>|<script[^>]*https://[^>]*>\s*</script>", re.DOTALL
)
_TROUBLE = re.compile(r"Warning:|Error|Traceback")


def build(output: Path) -> list[str]:
    """Builds everything; returns the warnings."""
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        try:
            _write_pages(work / "pages", work / "copies")
        except PageError as problem:
            return [str(problem)]
        warnings = [f"no docstring: {name}" for name in undocumented(SOURCE, C_LAYER)]
        shutil.rmtree(output, ignore_errors=True)
        warnings += _ford(work, output)
        # FORD would look for pages among them
        shutil.copytree(work / "copies", output / "page", dirs_exist_ok=True)
    for file in output.rglob("*.html"):
        text = _ELSEWHERE.sub("", file.read_text(encoding="utf-8"))
        file.write_text(text, encoding="utf-8")
    return warnings + _broken_links(output)


def _write_pages(folder: Path, copies: Path) -> None:
    folder.mkdir()
    copies.mkdir()

    def copy(file: Path) -> str:
        # a browser shows text and saves what it does not know
        text = Path("files") / file.relative_to(ROOT).with_name(file.name + ".txt")
        inside = Path("pictures") / file.name if file.suffix == ".png" else text
        (copies / inside).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copies / inside)
        return str(inside)

    names = ordered(DOCS)
    for path in names:
        text = page(path, copy)
        if path is names[0]:
            listed = "".join(f"ordered_subpage: {other.name}\n" for other in names[1:])
            text = listed + text
        (folder / path.name).write_text(text, encoding="utf-8")


def _ford(work: Path, output: Path) -> list[str]:
    settings = f"""\
project: mdrcontact
version: {_version()}
summary: Contact of coated, layered and graded bodies, computed in one dimension
license: GPL-3.0-or-later
src_dir: {SOURCE}
exclude_dir: {C_LAYER}
page_dir: {work / "pages"}
output_dir: {output}
css: {SITE / "style.css"}
display: public
preprocess: false
graph: false
search: false
incl_src: false
max_frontpage_items: 0

The [guide](page/index.html) leads to what you need, in Python, C, Fortran and on the command line.

The Fortran interface is described module by module: [all modules](lists/modules.html), [all types](lists/types.html),
[all procedures](lists/procedures.html). A program uses one of them, [`mdrcontact`](module/mdrcontact.html), which exports what is
meant for users. The C interface is described in `mdrcontact.h`.
"""
    (work / "project.md").write_text(settings, encoding="utf-8")
    ford = subprocess.run([sys.executable, "-m", "ford", work / "project.md"], capture_output=True, text=True, check=False)
    lines = (ford.stdout + ford.stderr).splitlines()
    # FORD breaks a warning over lines: show what follows, too
    warnings = [" ".join(lines[i : i + 3]) for i, line in enumerate(lines) if _TROUBLE.search(line)]
    return warnings or ([f"ford ended with status {ford.returncode}", *lines[-5:]] if ford.returncode else [])


def _version() -> str:
    source = (SOURCE / "mdrcontact" / "version.f90").read_text(encoding="utf-8")
    found = re.search(r'version_string = "([0-9.]+)"', source)
    assert found
    return found[1]


class _Links(HTMLParser):
    """The links of a page and the places in it that links can lead to."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if name in ("href", "src") and value:
                self.links.append(value)
            elif name in ("id", "name") and value:
                self.places.add(value)


def _broken_links(output: Path) -> list[str]:
    """Links of the guide's pages that lead nowhere or out of the site."""
    pages = {path: _Links(path.read_text(encoding="utf-8")) for path in sorted((output / "page").glob("*.html"))}
    broken = []
    for path, found in pages.items():
        for link in found.links:
            if link.startswith(("https://github.com/Fortran-FOSS-Programmers", "mailto:")):
                continue
            name, _, anchor = unquote(link).partition("#")
            target = (path.parent / name).resolve() if name else path
            if not target.exists():
                broken.append(f"{path.name}: the link {link!r} leads nowhere")
            elif anchor and target in pages and anchor not in pages[target].places:
                broken.append(f"{path.name}: the link {link!r} leads to no heading")
    return broken


def main(arguments: list[str]) -> int:
    """Builds into the folder named on the command line."""
    if len(arguments) != 1:
        print(__doc__)
        return 2
    output = Path(arguments[0]).resolve()
    if output.exists() and not (output / "modules.json").exists():
        print(f"{output} exists and was not made by this command: name another folder", file=sys.stderr)
        return 2
    warnings = build(output)
    for warning in warnings:
        print(f"warning: {warning}", file=sys.stderr)
    print(f"{len(warnings)} warnings; {output / 'index.html'}")
    return 1 if warnings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
