# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `mdrcontact`."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Sequence
from importlib import resources

from .. import __version__
from .._warn import reported_to
from ..errors import MDRError
from ..problem import ProblemError
from ..threads import all_cores
from . import (
    adhesion,
    app,
    calibrate,
    compare,
    completion,
    conduction,
    curve,
    example,
    fit,
    friction,
    history,
    imprint,
    inspect,
    keys,
    law,
    modulus,
    stress,
    validate,
    wear,
)
from . import map as map_
from .files import OutputError

__all__ = ["main", "make_parser"]

COMMANDS = (
    curve,
    compare,
    adhesion,
    stress,
    friction,
    wear,
    conduction,
    imprint,
    history,
    law,
    inspect,
    fit,
    modulus,
    calibrate,
    example,
    map_,
    validate,
    app,
    completion,
)
"""Each command is a module with its name, HELP, `add_arguments(parser)` and `run(arguments)`, and a text help/<name>.txt."""
_FORMAT = argparse.RawDescriptionHelpFormatter

_DESCRIPTION = """\
Contact of an indenter with a coated, layered or graded body: force, contact radius, stiffness and pressure.

A problem file is a text file that describes the indenter, the medium and what to compute, with units. Start from a ready-made one:

    mdrcontact example sio2_on_si > problem.toml
    mdrcontact curve problem.toml --plot curve.png
    mdrcontact compare problem.toml --plot compare.png
"""


class _Warnings:
    """Prints each warning of a command once, also if several contacts give it."""

    def __init__(self) -> None:
        self._printed: set[str] = set()

    def __call__(self, text: str, _kind: type[Warning]) -> None:
        if text not in self._printed:
            self._printed.add(text)
            print(f"mdrcontact: warning: {text}", file=sys.stderr)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command and return its exit status. An error is one line on the standard error stream."""
    words = sys.argv[1:] if arguments is None else arguments
    chosen = make_parser()[0].parse_args(words)
    chosen.command = shlex.join(["mdrcontact", *words])
    try:
        with reported_to(_Warnings()), all_cores():
            chosen.run(chosen)
        print(end="", flush=True)
    except ProblemError as problem:
        return _fail(problem, 2)
    except (MDRError, OutputError) as problem:
        return _fail(problem, 1)
    except OSError as problem:
        if problem.filename is not None:
            return _fail(f"{problem.filename}: {problem.strerror}", 1)
        # the disk is full, or the reader of the output has closed it (| head), which is no error: discard the rest
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return (
            1
            if isinstance(problem, BrokenPipeError)
            else _fail(f"the output cannot be written: {problem.strerror}. Free space or write elsewhere.", 1)
        )
    except MemoryError:
        return _fail("there is not enough memory. Use fewer points or fewer rows of data.", 1)
    except KeyboardInterrupt:
        return _fail("interrupted; nothing was written", 130)
    return 0


def make_parser() -> tuple[argparse.ArgumentParser, dict[str, keys.Parser]]:
    """Return the parser of the command line, and those of its commands by name."""
    parser = argparse.ArgumentParser(prog="mdrcontact", description=_DESCRIPTION, epilog=keys.EXIT_STATUS, formatter_class=_FORMAT)
    parser.add_argument("--version", action="version", version=f"mdrcontact {__version__}", help="print the version and exit")
    subparsers = parser.add_subparsers(metavar="COMMAND", required=True, parser_class=keys.Parser)
    commands = {}
    for command in COMMANDS:
        name = command.__name__.rpartition(".")[2]
        commands[name] = subparsers.add_parser(name, help=command.HELP, description=_description(name), formatter_class=_FORMAT)
        command.add_arguments(commands[name])
        commands[name].set_defaults(run=command.run)
    return parser, commands


def _description(command: str) -> str:
    """Return the text of `--help` of a command."""
    return (resources.files(__name__) / "help" / f"{command}.txt").read_text(encoding="utf-8")


def _fail(problem: object, status: int) -> int:
    print(end="", flush=True)
    print("mdrcontact: " + " ".join(str(problem).split()), file=sys.stderr)
    return status
