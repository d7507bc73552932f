# SPDX-License-Identifier: GPL-3.0-or-later
"""From the guide's Markdown, as it is read in the repository, to the pages that FORD turns into HTML.

The title goes into the metadata, formulas between dollar signs become MathML, which browsers show without help from the network,
a block that is a file gets its name as a caption, and links to other pages or to files of the repository point to their copies.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from latex2mathml.converter import convert

FENCE = re.compile(r"^```(\w*)(?: file=(\S+))?$")
_CODE = re.compile(r"(`+[^`]*`+)")
_DISPLAYED = re.compile(r"\$\$(.+?)\$\$")
_INLINE = re.compile(r"(?<![\w$\\])\$(?=\S)([^$]+?)(?<=\S)\$(?!\w)")
_PRIME = '<mo lspace="0" rspace="0">&#x02032;</mo>'
_LINK = re.compile(r"\]\(([^)\s]+)\)")


class PageError(ValueError):
    """A page is wrong; the words say where."""


def ordered(docs: Path) -> list[Path]:
    """The pages of the guide: the start page, then the others as it mentions them, then those that it does not."""
    start = docs / "index.md"
    mentioned = [docs / name for name in re.findall(r"\]\((\w+\.md)", start.read_text(encoding="utf-8"))]
    return list(dict.fromkeys([start, *mentioned, *sorted(docs.glob("*.md"))]))


def page(path: Path, copy: Callable[[Path], str]) -> str:
    """The text of a page for FORD. `copy` brings a file of the repository into the site and says where it is from the page."""
    lines = path.read_text(encoding="utf-8").split("\n")
    if not lines[0].startswith("# "):
        raise PageError(f"{path.name}: the first line must be the title, as in '# Title'")
    done = [f"title: {lines[0].removeprefix('# ')}", ""]
    inside = False
    for number, line in enumerate(lines[1:], start=2):
        fence = FENCE.match(line)
        if fence and not inside and fence[2]:
            done += [f'<p class="file">{fence[2]}</p>', ""]
        if line.startswith("```"):
            inside = not inside
            done.append(f"```{fence[1]}" if fence else line)
        elif inside:
            done.append(line)
        else:
            try:
                done.append(_prose(line, path, copy))
            except PageError as problem:
                raise PageError(f"{path.name}, line {number}: {problem}") from problem
    return "\n".join(done)


def _prose(line: str, path: Path, copy: Callable[[Path], str]) -> str:
    pieces = _CODE.split(line)
    for i in range(0, len(pieces), 2):
        pieces[i] = _DISPLAYED.sub(lambda found: _formula(found[1], "block"), pieces[i])
        pieces[i] = _INLINE.sub(lambda found: _formula(found[1], "inline"), pieces[i])
        if "$" in pieces[i]:
            raise PageError(f"a dollar sign that closes no formula: {pieces[i]!r}")
    return _LINK.sub(lambda found: f"]({_target(found[1], path, copy)})", "".join(pieces))


def _formula(text: str, display: str) -> str:
    # signs that Markdown would read as emphasis
    formula = convert(text, display=display).replace("*", "&#42;").replace("_", "&#95;").replace("|", "&#124;")
    formula = re.sub(r"(<m([io])>(?:arc)?(?:cos|sin|tan|ln)</m\2>)(?!<mo)", r'\1<mspace width="0.167em"></mspace>', formula)
    # a prime is a small sign high up already: as a superscript most fonts leave a dot of it
    formula = re.sub(r"<msup>(<mi>\w</mi>)<mi>&#x02032;</mi></msup>", rf"\1{_PRIME}", formula)
    formula = re.sub(r"<msubsup>(.*?)<mi>&#x02032;</mi></msubsup>", rf"<msub>\1</msub>{_PRIME}", formula)
    # at the beginning of a line <math> alone would be a paragraph of its own
    return formula if display == "block" else f"<span>{formula}</span>"


def _target(link: str, path: Path, copy: Callable[[Path], str]) -> str:
    if re.match(r"\w+:", link) or link.startswith("#"):
        return link
    name, _, anchor = link.partition("#")
    target = (path.parent / name).resolve()
    if not target.exists():
        raise PageError(f"the link {link!r} leads nowhere")
    if target.parent == path.parent.resolve() and target.suffix == ".md":
        return str(Path(name).with_suffix(".html")) + (f"#{anchor}" if anchor else "")
    return copy(target)
