# SPDX-License-Identifier: GPL-3.0-or-later
"""The server of the page: it listens to this machine alone, and answers only those who have its address with the secret."""

from __future__ import annotations

import hmac
import socket
from pathlib import Path
from typing import Any

from dash import Dash, set_props
from dash.exceptions import DependencyException
from flask import Flask, Response, abort, request
from werkzeug.serving import BaseWSGIServer, WSGIRequestHandler, make_server

from ..errors import MDRError
from ..problem.named import LARGEST_FILE
from .results import words_of
from .session import Session

HOST = "127.0.0.1"
_NAMES = (HOST, "localhost")
_LARGEST = 2 * LARGEST_FILE
"""Largest request [bytes]: a file in base 64."""
_ANY = "/<path:path>"
"""The rule by which Dash has a page at every other path."""
_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}
_POLICY = (
    "default-src 'self'; script-src 'self' {scripts}; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_INDEX = """<!DOCTYPE html>
<html lang="en">
<head>{%metas%}<title>{%title%}</title>{%favicon%}{%css%}</head>
<body>{%app_entry%}{%config%}{%scripts%}{%renderer%}</body>
</html>"""
_ENTRANCE = """<!DOCTYPE html>
<html lang="en"><head><title>mdrcontact</title><link rel="icon" href="data:,">
<meta http-equiv="refresh" content="0;url=/"></head></html>"""
"""Leads to the page from a page of its own: a strict cookie does not follow a redirection from elsewhere."""
_STRANGER = "This page needs the address that mdrcontact app printed. Open that address."


def make_dash() -> Dash:
    """Return a page without contents. Nothing of it comes from the network."""
    return Dash(
        "mdrcontact",
        assets_folder=str(Path(__file__).parent / "assets"),
        index_string=_INDEX,
        title="mdrcontact",
        update_title="",
        serve_locally=True,
        add_log_handler=False,
        enable_mcp=False,
        use_pages=False,
        on_error=_report,
        suppress_callback_exceptions=True,  # some components are there only with their results
    )


def _report(problem: Exception) -> None:
    """Show an error of a callback, which otherwise leaves the page as it is."""
    for name in ("design", "measure"):
        set_props(f"{name}-alert", {"children": words_of(problem)})


def guard(dash: Dash, session: Session) -> None:
    """Let the page answer only requests from this machine that have the secret, and name dropped files without their folder."""
    flask: Flask = dash.server
    flask.config.update(TRUSTED_HOSTS=[*_NAMES], MAX_CONTENT_LENGTH=_LARGEST)
    policy = _POLICY.format(scripts=" ".join(dash.csp_hashes()))

    def check() -> Any:
        port = request.environ["SERVER_PORT"]
        cookie, host = f"mdrcontact-{port}", request.headers.get("Host")
        if host not in [f"{name}:{port}" for name in _NAMES] or request.headers.get("Origin", f"http://{host}") != f"http://{host}":
            abort(403)
        given = request.path.removeprefix("/")
        if _is(given, session.secret) or session.opens(given):
            answer = Response(_ENTRANCE, mimetype="text/html")
            if not _is(request.cookies.get(cookie, ""), session.secret):  # what a page of an earlier command left is of no use
                answer.headers["Clear-Site-Data"] = '"storage"'
            answer.set_cookie(cookie, session.secret, httponly=True, samesite="Strict")
            return answer
        if not _is(request.cookies.get(cookie, ""), session.secret):
            abort(Response(_STRANGER, 403, mimetype="text/plain"))
        if request.url_rule is None or request.url_rule.rule == _ANY:
            abort(404)
        if (request.content_length or 0) > _LARGEST:
            abort(413)
        return None

    def close(answer: Response) -> Response:
        answer.headers.update(_HEADERS)
        answer.headers["Content-Security-Policy"] = policy
        if answer.mimetype == "application/json":
            answer.set_data(session.shortened(answer.get_data(as_text=True)))
        return answer

    # a script that no package has
    flask.register_error_handler(DependencyException, lambda _problem: ("", 404))
    flask.before_request_funcs.setdefault(None, []).insert(0, check)
    flask.after_request(close)


def _is(given: str, secret: str) -> bool:
    return hmac.compare_digest(given.encode(), secret.encode())


class _Silent(WSGIRequestHandler):
    """Writes no line for each request, and does not wait for ever for one."""

    timeout = 60

    def log(self, type: str, message: str, *args: Any) -> None:
        """Write nothing."""


def listen(dash: Dash, port: int = 0) -> BaseWSGIServer:
    """Return the server of a page on a port of this machine; 0: a free one."""
    try:
        with socket.create_server((HOST, port)) as place:
            return make_server(HOST, place.getsockname()[1], dash.server, threaded=True, request_handler=_Silent, fd=place.fileno())
    except OSError as problem:
        raise MDRError(f"port = {port}: it cannot be used: {problem}. Leave it out for a free one.") from problem
