# SPDX-License-Identifier: GPL-3.0-or-later
"""What MkDocs does not do by itself: formulas as MathML, which needs no network, and links to the repository's files.

A formula stands between single dollar signs, or between double ones when it is displayed. A block of code that is a file,
```` ```c file=main.c ````, gets the file's name as its title.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parent

_BLOCK = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)
_CODE = re.compile(r"(^```.*?^```$|`[^`\n]+`)", re.DOTALL | re.MULTILINE)
_TITLE = re.compile(r"^```(\w+) file=(\S+)$", re.MULTILINE)
_FORMULA = re.compile(r"\$\$(?P<displayed>.+?)\$\$|(?<![\w$\\])\$(?=\S)(?P<inline>[^$]+?)(?<=\S)\$(?!\w)")
_LINK = re.compile(r"\]\((\.\./[^)\s#]+)\)")


def on_files(files: Any, config: Any) -> Any:
    """Adds the files of the repository that pages link to."""
    linked = {link for page in DOCS.glob("*.md") for link in _LINK.findall(_BLOCK.sub("", page.read_text(encoding="utf-8")))}
    for link in sorted(linked):
        path = (DOCS / link).resolve()
        if not path.is_file():
            raise PluginError(f"the link {link!r} leads nowhere")
        files.append(File.generated(config, _copy(link), abs_src_path=str(path)))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Formulas, titles of code blocks and links of one page."""
    pieces = _CODE.split(markdown)
    for i in range(0, len(pieces), 2):
        pieces[i] = _FORMULA.sub(_mathml, pieces[i])
        if "$" in pieces[i]:
            raise PluginError(f"{page.file.src_uri}: a dollar sign that closes no formula: {pieces[i].strip()!r}")
    text = _LINK.sub(lambda found: f"]({_copy(found[1])})", "".join(pieces))
    return _TITLE.sub(r'```\1 title="\2"', text)


def _copy(link: str) -> str:
    """Where a file of the repository lies in the site: as text, for browsers save what they do not know."""
    name = (DOCS / link).resolve().relative_to(ROOT)
    return str(Path("files") / (name if name.suffix in (".png", ".svg") else name.with_name(name.name + ".txt")))


def _mathml(found: re.Match[str]) -> str:
    displayed = found["displayed"]
    # signs that Markdown would read as emphasis or as the border of a table's cell
    formula = convert(displayed or found["inline"], display="block" if displayed else "inline")
    for sign in "*_|":
        formula = formula.replace(sign, f"&#{ord(sign)};")
    formula = re.sub(r"(<m([io])>(?:arc)?(?:cos|sin|tan|ln)</m\2>)(?!<mo)", r'\1<mspace width="0.167em"></mspace>', formula)
    # a prime is a small sign high up already: as a superscript most fonts leave a dot of it
    prime = '<mo lspace="0" rspace="0">&#x02032;</mo>'
    formula = re.sub(r"<msup>(<mi>\w</mi>)<mi>&#x02032;</mi></msup>", rf"\1{prime}", formula)
    formula = re.sub(r"<msubsup>(.*?)<mi>&#x02032;</mi></msubsup>", rf"<msub>\1</msub>{prime}", formula)
    # at the beginning of a line <math> alone would be a paragraph of its own
    return f"\n\n<p>{formula}</p>\n\n" if displayed else f"<span>{formula}</span>"
