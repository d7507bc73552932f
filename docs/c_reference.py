# SPDX-License-Identifier: GPL-3.0-or-later
"""Read the comments of the C headers, and write them as Markdown pages for the site.

A comment `/** ... */` describes the declaration that follows it; `/**< ... */` describes the member before it. The comments use
these tags: `@file`, `@since`, `@par`, `@param`, `@return`, and `@code` to `@endcode` for an example. A line that begins with "- "
is an item of a list.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

INCLUDE = Path(__file__).resolve().parents[1] / "include"
HEADERS = ("mdrcontact.h", *(f"mdrcontact/{name}.h" for name in (
    "base", "profile", "material", "body", "medium", "weights", "contact", "friction", "law", "closed_forms",
    "time", "adhesion", "wear", "conduction", "poroelastic", "plastic", "lateral", "fit")),
    "mdrcontact_law.h", "mdrcontact_plastic_law.h")  # fmt: skip
"""The headers in the order of the site: the core, the extensions, the inline functions."""

_COMMENT = re.compile(r"/\*\*(?!<)(.*?)\*/\s*(.*?)(?=/\*\*(?!<)|/\* |\Z)", re.DOTALL)
_MEMBER = re.compile(r"^ {4}([^/\n][^/;,]*?)[;,]?\s*/\*\*<(.*?)\*/", re.DOTALL | re.MULTILINE)
_DECLARATIONS = {
    "structure": re.compile(r"typedef struct (\w+) \{.*?\n\} \1;", re.DOTALL),
    "handle": re.compile(r"typedef struct (\w+) \1;"),
    "enumeration": re.compile(r"enum (\w+) \{.*?\};", re.DOTALL),
    "callback": re.compile(r"typedef int \(\*(\w+)\)\([^)]*\);"),
    "macro": re.compile(r"(?:#if[^\n]*\n(?:.*\n)*?)?#define (MDR_\w+(?:\([^)]*\))?)[^\n]*"),
    "function": re.compile(r"(?:MDR_INLINE |static inline )?(?:const )?\w+ \*?(mdr_\w+)\([^)]*\)"),
}


@dataclass
class Entity:
    """A function, structure, enumeration, handle, callback or macro of a header, and its description."""

    header: str
    kind: str
    name: str
    declaration: str
    text: str
    parameters: dict[str, str] = field(default_factory=dict)
    returns: str = ""
    example: str = ""
    members: dict[str, str] = field(default_factory=dict)

    @property
    def summary(self) -> str:
        """The first sentence."""
        return re.split(r"(?<=[.:])\s", self.text.strip() + " ")[0].rstrip(".:")


@dataclass
class Header:
    """A header: its description and what it declares."""

    name: str
    title: str
    text: str
    entities: list[Entity]

    @property
    def page(self) -> str:
        """The name of its page."""
        return Path(self.name).stem + ".md"


def read(include: Path = INCLUDE) -> list[Header]:
    """Read all headers."""
    return [_header(name, (include / name).read_text(encoding="utf-8")) for name in HEADERS]


def functions(headers: list[Header]) -> list[Entity]:
    """All functions of the headers, inline functions included."""
    return [entity for header in headers for entity in header.entities if entity.kind == "function"]


def pages(headers: list[Header]) -> dict[str, str]:
    """The Markdown text of each page by its name."""
    targets = {}
    for header in headers:
        for entity in header.entities:
            targets[entity.name] = f"{header.page}#{entity.name.lower()}"
            if entity.kind == "enumeration":
                targets |= dict.fromkeys(entity.members, targets[entity.name])
    return {header.page: _page(header, targets) for header in headers}


def linked(text: str, headers: list[Header], folder: str) -> str:
    """A text whose names of functions in backticks lead to their descriptions."""
    at = {entity.name: f"{folder}{header.page}#{entity.name.lower()}" for header in headers for entity in header.entities}
    return re.sub(r"`(mdr_\w+)\(?\)?`", lambda found: f"[{found[0]}]({at[found[1]]})" if found[1] in at else found[0], text)


def _header(name: str, source: str) -> Header:
    (words, _), *others = _COMMENT.findall(source)
    body = re.sub(r"@file \S+\n|@since \S+", "", _plain(words)).strip()
    title, _, text = body.partition("\n\n")
    entities = [entity for words, code in others if (entity := _entity(name, words, code))]
    return Header(name, title.replace("\n", " "), text, entities)


def _entity(header: str, words: str, code: str) -> Entity | None:
    """The entity that a comment describes; None for one of no interest."""
    matches = ((kind, pattern.match(code)) for kind, pattern in _DECLARATIONS.items())
    kind, found = next(((kind, found) for kind, found in matches if found), ("", None))
    if not found:
        return None
    declaration = found[1] if kind == "macro" else re.sub(r"^(MDR_INLINE|static inline) ", "", found[0].rstrip(";") + ";")
    entity = Entity(header, kind, found[1].partition("(")[0], declaration, "")
    _describe(entity, _plain(words))
    if kind in ("structure", "enumeration"):
        for declared, meaning in _MEMBER.findall(found[0] + "\n"):
            entity.members[declared.split(" = ")[0] if kind == "enumeration" else declared.strip()] = _one_line(meaning)
    return entity


def _describe(entity: Entity, comment: str) -> None:
    """Divide a comment into text, parameters, result and example."""
    example = re.search(r"@code\n(.*?)\n\s*@endcode", comment, re.DOTALL)
    entity.example = example[1] if example else ""
    comment = re.sub(r"@code\n.*?@endcode|@since \S+", "", comment, flags=re.DOTALL)
    text, *tags = re.split(r"^@(?=param|return)", comment, flags=re.MULTILINE)
    entity.text = text.strip()
    for tag in tags:
        name, _, rest = _one_line(tag).partition(" ")
        if name == "param":
            parameter, _, meaning = rest.partition(" ")
            entity.parameters[parameter] = meaning.strip()
        else:
            entity.returns = rest


def _plain(comment: str) -> str:
    """A comment without its stars."""
    return "\n".join(re.sub(r"^\s*\* ? ?", "", line).rstrip() for line in comment.strip().split("\n"))


def _one_line(text: str) -> str:
    return " ".join(text.split())


def _page(header: Header, targets: dict[str, str]) -> str:
    lines = [f"# {header.name}", "", _marked(header.title, targets), "", *_paragraphs(header.text, targets)]
    if header.entities:
        lines += [f"`#include <{header.name}>`", ""]
    for kind, heading in (("function", "Functions"), ("macro", "Macros"), ("handle", "Handles"), ("structure", "Structures"),
                          ("enumeration", "Enumerations"), ("callback", "Callbacks")):  # fmt: skip
        chosen = [entity for entity in header.entities if entity.kind == kind]
        if chosen:
            lines += [f"## {heading}", ""]
        for entity in chosen:
            lines += _entry(entity, targets)
    return "\n".join(lines) + "\n"


def _entry(entity: Entity, targets: dict[str, str]) -> Iterator[str]:
    yield from (f"### {entity.name}", "")
    if entity.kind in ("function", "callback", "macro"):
        yield from ("```c", entity.declaration, "```", "")
    yield from _paragraphs(entity.text, targets)
    if entity.parameters:
        yield from _table(("Parameter", "Meaning"), {f"`{name}`": words for name, words in entity.parameters.items()}, targets)
    if entity.members:
        head = "Constant" if entity.kind == "enumeration" else "Member"
        yield from _table((head, "Meaning"), {f"`{name}`": words for name, words in entity.members.items()}, targets)
    if entity.returns:
        yield from (f"**Returns** {_marked(entity.returns, targets)}", "")
    if entity.example:
        yield from ("```c", entity.example, "```", "")


def _table(heads: tuple[str, str], rows: dict[str, str], targets: dict[str, str]) -> Iterator[str]:
    yield from (f"| {heads[0]} | {heads[1]} |", "|---|---|")
    for name, words in rows.items():
        yield f"| {name} | {_marked(words, targets)} |"
    yield ""


def _paragraphs(text: str, targets: dict[str, str]) -> Iterator[str]:
    for paragraph in re.split(r"\n\s*\n|^(?=@par )", text, flags=re.MULTILINE):
        heading = re.match(r"@par (.*)\n?", paragraph)
        if heading:
            yield from (f"**{heading[1]}**", "")
            paragraph = paragraph[heading.end() :]
        items = re.split(r"^\s*- ", paragraph, flags=re.MULTILINE)
        if items[0].strip():
            yield from (_marked(_one_line(items[0]), targets), "")
        if len(items) > 1:
            yield from (f"- {_marked(_one_line(item), targets)}" for item in items[1:])
            yield ""


def _marked(text: str, targets: dict[str, str]) -> str:
    """A text with its names linked, and signs that mean something to Markdown as they are."""
    made = []
    for i, part in enumerate(re.split(r"(`[^`]*`|\b(?:mdr_\w+(?:\(\))?|MDR_\w+))", _one_line(text))):
        name = part.strip("`()")
        if i % 2 == 0:
            made.append(re.sub(r"([*_\[\]|$^~\\])", r"\\\1", html.escape(part, quote=False)))
        elif name in targets:
            made.append(f"[`{part.strip('`')}`]({targets[name]})")
        else:
            made.append(f"`{part.strip('`')}`".replace("|", "\\|"))
    return "".join(made)
