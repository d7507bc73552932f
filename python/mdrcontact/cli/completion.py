# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact completion`: commands, options and file names by the Tab key of a shell."""

from __future__ import annotations

import argparse
import importlib
from pathlib import Path

from .files import OutputError

HELP = "print a script with which a shell completes commands, options and file names"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    parser.add_argument("shell", choices=("bash", "zsh"), help="the shell: %(choices)s")


def run(arguments: argparse.Namespace) -> None:
    """Print the script."""
    try:
        shtab = importlib.import_module("shtab")
    except ImportError as problem:
        raise OutputError('the script needs shtab. Install it with pip install "mdrcontact[completion]".') from problem
    parser, commands = importlib.import_module(__package__).make_parser()
    for command in commands.values():
        for action in command._actions:
            if action.type is Path or str(action.metavar).endswith(".toml"):
                vars(action)["complete"] = shtab.FILE
    print(shtab.complete(parser, arguments.shell), end="")
