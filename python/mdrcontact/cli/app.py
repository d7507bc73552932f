# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact app`: a page in the browser to compute contacts and fit measurements."""

from __future__ import annotations

import argparse
import signal
import threading
import webbrowser
from contextlib import suppress
from pathlib import Path

from . import files

HELP = "open a page in the browser to compute contacts and fit measurements"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the command to a parser."""
    words = "problem file, or file of measurements, that the page shows first"
    parser.add_argument("file", nargs="?", type=Path, metavar="FILE", help=words)
    parser.add_argument("--port", type=_port, default=0, metavar="N", help="port of this machine (default: a free one)")
    parser.add_argument("--no-browser", action="store_true", help="open no browser; the address is on a line of its own")


def run(arguments: argparse.Namespace) -> None:
    """Serve the page until Ctrl-C."""
    try:
        from ..app import Session, make_app
        from ..app.server import listen
    except ImportError as problem:
        raise files.OutputError(f'the page needs {problem.name}. Install it with pip install "mdrcontact[app]".') from problem
    session = Session(*files.first(arguments.file))
    try:
        server = listen(make_app(session), arguments.port)
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        address = f"http://{server.host}:{server.port}"
        with suppress(KeyboardInterrupt):
            for name in {"SIGTERM", "SIGHUP"} & {*dir(signal)}:
                signal.signal(getattr(signal, name), signal.default_int_handler)
            print(f"{address}/{session.secret}", flush=True)
            if not arguments.no_browser and not webbrowser.open(f"{address}/{session.once}"):
                print("No browser was found. Open this address in one.", flush=True)
            print("Ctrl-C ends the page.", flush=True)
            while thread.is_alive():  # a signal right before an endless wait would not end it
                thread.join(0.5)
    finally:
        session.close()


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"port = {text!r}: it must be a whole number from 0 to 65535")
    return int(text)
