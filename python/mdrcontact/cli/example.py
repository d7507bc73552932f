# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact example`: ready-made, commented problem files to begin with."""

from __future__ import annotations

import argparse
from importlib import resources

from .._choices import nearest
from ..problem import ProblemError

HELP = "print a commented problem file to begin with"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("name", nargs="?", metavar="NAME", help="which one; without a name they are listed")


def run(arguments: argparse.Namespace) -> None:
    """Prints the list or one example."""
    texts = examples()
    if arguments.name is None:
        width = max(map(len, texts)) + 2
        for name, text in texts.items():
            print(f"{name:<{width}}{_title(text)}")
    elif arguments.name not in texts:
        raise ProblemError(f"there is no example {arguments.name!r}: {nearest(arguments.name, texts)}")
    else:
        print(texts[arguments.name], end="")


def examples() -> dict[str, str]:
    """The problem files that come with the package, by name."""
    folder = resources.files("mdrcontact") / "problems"
    found = {entry.name: entry.read_text(encoding="utf-8") for entry in folder.iterdir() if entry.name.endswith(".toml")}
    return {name.removesuffix(".toml"): found[name] for name in sorted(found)}


def _title(text: str) -> str:
    line = next(line for line in text.splitlines() if line.startswith("title"))
    return line.partition("=")[2].strip().strip('"')
