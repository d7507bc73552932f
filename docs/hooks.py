# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions that MkDocs lacks: formulas as MathML, which needs no network, links to the repository's files, and notebooks.

A formula stands between single dollar signs, or between double ones when it is displayed. `\\tag{2.1}` at the end of a displayed
formula is its number: it appears at the right, and `#eq-2.1` leads to it. A block of code that is a file,
```` ```c file=main.c ````, gets the file's name as its title.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File
from mkdocs.structure.nav import Link

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS))

import c_reference  # noqa: E402
from make_notebooks import TUTORIALS, notebook  # noqa: E402

HEADERS = c_reference.read()
ROOT = DOCS.parent

_BLOCK = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)
_CODE = re.compile(r"(^```.*?^```$|`[^`\n]+`)", re.DOTALL | re.MULTILINE)
_TITLE = re.compile(r"^```(\w+) file=(\S+)$", re.MULTILINE)
_FORMULA = re.compile(r"\$\$(?P<displayed>(?:[^$\n]|\n(?!\s*\n))+?)\$\$|(?<![\w$\\])\$(?=\S)(?P<inline>[^$]+?)(?<=\S)\$(?!\w)")
_NUMBER = re.compile(r"\\tag\{([^{}]+)\}\s*$")
_LINK = re.compile(r"\]\((\.\./[^)\s#]+)\)")
_REFERENCES = re.compile(r'(?<=<details class="references" open>).*?(?=</details>)', re.DOTALL)
_KEY = re.compile(r"(?<=<p>)([a-z]+)-(\d{4}[a-z]?)|(?<=\n)([a-z]+)-(\d{4}[a-z]?)")


def on_files(files: Any, config: Any) -> Any:
    """Adds the files of the repository that pages link to, and the tutorials as notebooks."""
    linked = set()
    for page in DOCS.rglob("*.md"):
        for link in _LINK.findall(_BLOCK.sub("", page.read_text(encoding="utf-8"))):
            path = (page.parent / link).resolve()
            if not path.is_file():
                raise PluginError(f"{page.relative_to(DOCS)}: the link {link!r} leads nowhere")
            if not path.is_relative_to(DOCS):
                linked.add(path)
    for path in sorted(linked):
        files.append(File.generated(config, str(_copy(path)), abs_src_path=str(path)))
    for page in TUTORIALS:
        files.append(File.generated(config, f"notebooks/{page.stem}.ipynb", content=notebook(page)))
    for name, text in c_reference.pages(HEADERS).items():
        files.append(File.generated(config, f"c-api/{name}", content=text))
    return files


def on_nav(nav: Any, config: Any, **_: Any) -> Any:
    """Adds the pages that FORD makes of the Fortran modules."""
    for section in nav.items:
        if section.title == "Reference":
            section.children.append(Link("Fortran modules", "fortran/index.html"))
    return nav


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Formulas, titles of code blocks and links of one page."""
    name = page.file.src_uri
    if name == "c-api.md":
        markdown = c_reference.linked(markdown, HEADERS, "c-api/")
    if name.startswith("c-api/"):
        return markdown
    pieces = _CODE.split(markdown)
    for i in range(0, len(pieces), 2):
        pieces[i] = _FORMULA.sub(_mathml, pieces[i])
        if "$" in pieces[i]:
            raise PluginError(f"{name}: a dollar sign that closes no formula: {pieces[i].strip()!r}")
        if "\\tag" in pieces[i]:
            raise PluginError(f"{name}: a number that is not at the end of a displayed formula: {pieces[i].strip()!r}")
    text = _LINK.sub(lambda found: f"]({_in_site(found[1], DOCS / name)})", "".join(pieces))
    if DOCS / name in TUTORIALS:
        text = text.replace("\n", f"\n\n[Download this page as a Jupyter notebook.](notebooks/{Path(name).stem}.ipynb)\n", 1)
    return _TITLE.sub(r'```\1 title="\2"', text)


def on_page_content(html: str, page: Any, **_: Any) -> str:
    """The references of docstrings, one a line, with links to the bibliography."""
    return _REFERENCES.sub(lambda found: _KEY.sub(_cited, found[0]), html) if page.file.src_uri.startswith("python-api/") else html


def _cited(found: re.Match[str]) -> str:
    author, year = found[1] or found[3], found[2] or found[4]
    link = f'<a href="../bibliography.html#{author}-{year}">{author.capitalize()} ({year})</a>'
    return link if found[1] else f"<br>{link}"


def _in_site(link: str, page: Path) -> str:
    """A link of a page that leads upwards: to another page as it is, to a file of the repository to its copy."""
    path = (page.parent / link).resolve()
    if path.is_relative_to(DOCS):
        return link
    return "../" * len(page.parent.relative_to(DOCS).parts) + str(_copy(path))


def _copy(path: Path) -> Path:
    """Where a file of the repository lies in the site: as text, for browsers save what they do not know."""
    name = path.relative_to(ROOT)
    return Path("files") / (name if name.suffix in (".png", ".svg") else name.with_name(name.name + ".txt"))


def _mathml(found: re.Match[str]) -> str:
    displayed = found["displayed"]
    number = _NUMBER.search(displayed or "")
    latex = _NUMBER.sub("", displayed) if displayed else found["inline"]
    if "\\tag" in latex:
        return latex
    formula = convert(latex, display="block" if displayed else "inline")
    # signs that Markdown would read as emphasis or as the border of a table's cell
    for sign in "*_|":
        formula = formula.replace(sign, f"&#{ord(sign)};")
    formula = re.sub(r"(<m([io])>(?:arc)?(?:cos|sin|tan|ln)</m\2>)(?!<mo)", r'\1<mspace width="0.167em"></mspace>', formula)
    # a prime is a small sign high up already: as a superscript most fonts leave a dot of it
    prime = '<mo lspace="0" rspace="0">&#x02032;</mo>'
    formula = re.sub(r"<msup>(<mi>\w</mi>)<mi>&#x02032;</mi></msup>", rf"\1{prime}", formula)
    formula = re.sub(r"<msubsup>(.*?)<mi>&#x02032;</mi></msubsup>", rf"<msub>\1</msub>{prime}", formula)
    # at the beginning of a line <math> alone would be a paragraph of its own
    if number:
        return f'\n\n<p class="equation" id="eq-{number[1]}">{formula}<span>({number[1]})</span></p>\n\n'
    return f"\n\n<p>{formula}</p>\n\n" if displayed else f"<span>{formula}</span>"
