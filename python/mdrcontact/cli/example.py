# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact example`: ready-made problem files with comments."""

from __future__ import annotations

import argparse
from importlib import resources

from .._choices import suggestion
from ..problem import ProblemError

HELP = "print a ready-made problem file with comments"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("name", nargs="?", metavar="NAME", help="name of the problem file; without it the names are listed")


def run(arguments: argparse.Namespace) -> None:
    """Print the list, or one example."""
    texts = examples()
    if arguments.name is None:
        width = max(map(len, texts)) + 2
        for name, text in texts.items():
            print(f"{name:<{width}}{_title(text)}")
    elif arguments.name not in texts:
        raise ProblemError(f"name = {arguments.name!r}: there is no such example. {suggestion(arguments.name, texts)}")
    else:
        print(texts[arguments.name], end="")


def examples() -> dict[str, str]:
    """Return the problem files of the package by name."""
    folder = resources.files("mdrcontact") / "problems"
    found = {entry.name: entry.read_text(encoding="utf-8") for entry in folder.iterdir() if entry.name.endswith(".toml")}
    return {name.removesuffix(".toml"): found[name] for name in sorted(found)}


def _title(text: str) -> str:
    line = next(line for line in text.splitlines() if line.startswith("title"))
    return line.partition("=")[2].strip().strip('"')
