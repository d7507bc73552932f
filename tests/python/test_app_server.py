# SPDX-License-Identifier: GPL-3.0-or-later
"""The server of the page without a browser: who reads it, what it opens, and its work."""

import http.client
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from conftest import ROOT, run

import mdrcontact as mdr
from mdrcontact import cli
from mdrcontact._units import with_micro
from mdrcontact.errors import CancelledError

pytest.importorskip("dash", reason="the extra app is not installed")
from mdrcontact.app import Session, design, make_app, server  # noqa: E402
from mdrcontact.app.jobs import KEPT, BusyError, Jobs  # noqa: E402
from mdrcontact.app.session import cleaned  # noqa: E402

PORT = 8123
HERE = f"http://127.0.0.1:{PORT}"


@pytest.fixture
def session():
    made = Session("title = 'x'\n")
    yield made
    made.close()


@pytest.fixture
def page(session):
    """Requests of a browser that has opened the address."""
    client = make_app(session).server.test_client()
    entrance = client.get(f"/{session.secret}", base_url=HERE).text
    # it asks for nothing else
    assert 'content="0;url=/"' in entrance and 'rel="icon" href="data:,"' in entrance
    return client


def status(client, path, method="GET", **more):
    return client.open(path, method=method, base_url=more.pop("base_url", HERE), **more).status_code


def test_the_address_with_the_secret_opens_the_page(session, page):
    answer = page.get("/", base_url=HERE)
    assert answer.status_code == 200 and '<html lang="en">' in answer.text and session.secret not in answer.text
    assert status(page, "/_dash-layout") == status(page, "/_dash-dependencies") == status(page, "/_favicon.ico") == 200
    cookie = page.get(f"/{session.secret}", base_url=HERE).headers["Set-Cookie"]
    assert {"HttpOnly", "SameSite=Strict"} < set(cookie.split("; ")) and "Domain" not in cookie
    # 192 bits
    assert len(session.secret) == 32 and Session().secret != Session().secret


@pytest.mark.parametrize(
    "path", ["/", "/wrong", "/_dash-layout", "/_dash-update-component", "/assets/x", "/etc/passwd", "/_favicon.ico"]
)
def test_nothing_is_read_without_the_secret(session, path):
    stranger = make_app(session).server.test_client()
    for cookie in ("", "wrong", session.secret[:-1], "é"):
        stranger.set_cookie(f"mdrcontact-{PORT}", cookie, domain="127.0.0.1")
        for method in ("GET", "POST", "PUT", "OPTIONS"):
            answer = stranger.open(path, method=method, base_url=HERE)
            assert answer.status_code == 403 and "the address that mdrcontact app printed" in answer.text


def test_the_address_of_a_started_browser_opens_the_page_once(session):
    first, second = (make_app(session).server.test_client() for _ in range(2))
    once = session.once
    assert status(first, f"/{once}") == 200 == status(first, "/")
    assert status(second, f"/{once}") == 403 == status(second, "/")
    assert status(make_app(session).server.test_client(), "/") == 403


def test_a_new_command_forgets_what_the_browser_kept_of_an_earlier_one(session):
    browser = make_app(session).server.test_client()
    browser.set_cookie(f"mdrcontact-{PORT}", "of an earlier command", domain="127.0.0.1")
    answers = [browser.get(f"/{session.secret}", base_url=HERE) for _ in range(2)]
    assert [one.headers.get("Clear-Site-Data") for one in answers] == ['"storage"', None]


def test_a_secret_of_another_port_is_none(session, page):
    assert status(page, "/", base_url="http://127.0.0.1:8124") == 403


@pytest.mark.parametrize(
    "host", ["evil.example", f"evil.example:{PORT}", "127.0.0.1", "127.0.0.1:80", f"127.0.0.1.evil.example:{PORT}", ""]
)
def test_another_host_is_refused(page, host):
    assert status(page, "/", headers={"Host": host}) in (400, 403)
    assert status(page, "/", headers={"Host": f"127.0.0.1:{PORT}"}) == 200


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1", f"https://127.0.0.1:{PORT}", ""])
def test_another_origin_is_refused(page, origin):
    assert status(page, "/_dash-update-component", "POST", headers={"Origin": origin}, json={}) == 403
    assert status(page, "/_dash-update-component", "POST", headers={"Origin": HERE}, json={}) not in (403, 404)


@pytest.mark.parametrize(
    "path",
    ["/assets/../../../etc/passwd", "/assets/..%2f..%2fetc/passwd", "/etc/passwd", "/..", "//etc/passwd", "/_mcp",
     "/_dash-component-suites/dash/../../x.js", "/_dash-component-suites/os/os.py", "/assets//etc/passwd", "/assets/\0"],
)  # fmt: skip
def test_there_is_nothing_else(page, path):
    assert status(page, path) == 404


def test_answers_have_a_policy(page):
    for path in ("/", "/nothing"):
        headers = page.get(path, base_url=HERE).headers
        policy = dict(one.split(" ", 1) for one in headers["Content-Security-Policy"].split("; "))
        assert policy["default-src"] == "'self'" and policy["frame-ancestors"] == "'none'"
        assert re.fullmatch(r"'self'( 'sha256-[\w+/=]+')+", policy["script-src"])
        assert headers["X-Content-Type-Options"] == "nosniff" and headers["Referrer-Policy"] == "no-referrer"


@pytest.fixture
def served(session):
    listening = server.listen(make_app(session))
    thread = threading.Thread(target=listening.serve_forever, daemon=True)
    thread.start()
    yield listening
    listening.shutdown()
    thread.join()
    listening.server_close()


def asked(listening, session, length, body=b""):
    connection = http.client.HTTPConnection("127.0.0.1", listening.port, timeout=20)
    headers = {"Cookie": f"mdrcontact-{listening.port}={session.secret}", **length}
    connection.request("POST", "/_dash-update-component", body, headers)
    return connection.getresponse().status


def test_too_large_a_request_is_not_read(session, served):
    assert asked(served, session, {"Content-Length": str(10**12)}) == 413
    assert asked(served, session, {"Content-Length": str(server._LARGEST + 1)}) == 413
    assert asked(served, session, {}) not in (403, 413)
    # the page sends no larger drop: names and 4 signs for 3 bytes
    script = (ROOT / "python" / "mdrcontact" / "app" / "assets" / "page.js").read_text("utf-8")
    assert 0.9 < float(re.search(r"MOST = (\w+);", script)[1]) * 4 / 3 / server._LARGEST < 0.99


def test_the_server_listens_to_this_machine_alone(served):
    assert served.socket.getsockname()[0] == "127.0.0.1"
    with pytest.raises(mdr.MDRError, match=rf"port = {served.port}: it cannot be used"):
        server.listen(server.make_dash(), served.port)


@pytest.mark.parametrize(
    ("name", "clean"),
    [
        ("curve 1.csv", "curve 1.csv"),
        ("../../etc/passwd", "passwd"),
        ("C:\\data\\a.txt", "a.txt"),
        ("..", "file"),
        ("", "file"),
        ("/", "file"),
        (".bashrc", "bashrc"),
        ("a\0b\n<script>.csv", "a_b__script_.csv"),
        ("Prüfung µN.xlsx", "Prüfung µN.xlsx"),
        ("x" * 500 + ".csv", "x" * 97 + ".csv"),
        ("a." + "y" * 500, "a." + "y" * 20),
    ],
)
def test_names_of_dropped_files_are_cleaned(session, name, clean):
    assert cleaned(name) == clean and session.add({name: b"1"}) == [clean]
    place = session.files[clean]
    assert place.parent == session._folder and place.read_bytes() == b"1" and len(os.listdir(session._folder)) == 1


def test_files_of_one_drop_stay_apart_and_later_ones_replace(session):
    assert session.add({"a/x.csv": b"1", "b/x.csv": b"2", "c/x": b"3", "d/x": b"4"}) == ["x.csv", "x (2).csv", "x", "x (2)"]
    assert session.add({"x.csv": b"5"}) == ["x.csv"] and session.files["x.csv"].read_bytes() == b"5"


def test_files_that_are_refused_or_replaced_take_no_room(session, monkeypatch):
    monkeypatch.setattr("mdrcontact.app.session.LARGEST_FILE", 6)
    monkeypatch.setattr("mdrcontact.app.session.LARGEST_SUM", 8)
    for _ in range(3):
        with pytest.raises(mdr.MDRError, match=r"large\.csv: it has more than"):
            session.add({"y.csv": b"1", "large.csv": b"1234567"})
        session.add({"x.csv": b"12345"})
    # of a drop all files are kept, or none
    assert [*session.files] == os.listdir(session._folder) == ["x.csv"]
    with pytest.raises(mdr.MDRError, match=r"z\.csv: it has .* all files together"):
        session.add({"z.csv": b"1234"})


def test_dropped_files_are_private_and_vanish(session, monkeypatch):
    session.add({"x.csv": b"1"})
    assert session._folder.stat().st_mode & 0o077 == 0
    monkeypatch.setattr("mdrcontact.app.session.LARGEST_FILE", 3)
    with pytest.raises(mdr.MDRError, match=r"y\.csv: it has more than"):
        session.add({"y.csv": b"1234"})
    monkeypatch.setattr("mdrcontact.app.session.MOST_FILES", 1)
    with pytest.raises(mdr.MDRError, match="more than 1"):
        session.add({"y.csv": b"1"})
    session.close()
    assert not session._folder.exists()


PROBLEM = """
indenter = { shape = "sphere", radius = "10 um" }
medium = { type = "homogeneous", material = { E = "72 GPa", nu = 0.17 } }
"""


@pytest.mark.parametrize("name", ["/etc/passwd", "../x.csv", "link.csv", "/proc/self/environ", "x.csv/../x.csv"])
def test_a_text_opens_dropped_files_alone(session, name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link.csv").symlink_to("/etc/passwd")
    session.add({"x.csv": b"time [s],depth [nm],shift [nm]\n0,0,0\n1,5,1\n"})
    text = PROBLEM + f'friction = {{ coefficient = 0.3, path = "{name}" }}\n'
    with pytest.raises(mdr.MDRError, match="not among the given files: x.csv"):
        session.problem(text)
    assert session.problem(text.replace(name, "x.csv")).friction.path is not None


def ended(job):
    job.join(60)
    assert not job.is_alive()
    return job


def test_one_job_at_a_time():
    jobs, go = Jobs(), threading.Event()
    first = jobs.start("a", "a fit", lambda progress: go.wait(30) and 7)
    with pytest.raises(BusyError, match="a map: a fit is running"):
        jobs.start("b", "a map", lambda progress: 8)
    go.set()
    assert ended(first).result == 7 == jobs.find("a") and jobs.find("b") is None
    assert ended(jobs.start("b", "a map", lambda progress: 8)).result == 8 == jobs.find("b")


def test_twenty_results_are_kept():
    jobs = Jobs()
    for i in range(KEPT + 3):
        jobs.now(i, lambda i=i: i)
    assert [jobs.find(i) for i in range(4)] == [None, None, None, 3] and jobs.now(3, lambda: "again") == 3


def test_a_job_reports_and_fails():
    def work(progress):
        progress.step(2, 5, "states")
        raise mdr.errors.DomainError("r = 1: it must be smaller. Give another.")

    job = ended(Jobs().start("a", "a fit", work))
    assert job.done == (2, 5, "states") and job.result is None and isinstance(job.problem, mdr.errors.DomainError)


STRESSES = (ROOT / "examples" / "problems" / "tin_on_steel.toml").read_text("utf-8")


def test_stresses_with_failures_are_cancelled(session):
    """The work ends while it computes."""
    began = threading.Event()
    problem = session.problem(STRESSES)

    def work(progress):
        began.set()
        while True:
            mdr.studies.stress(problem, progress=progress)

    job = session.jobs.start("s", "stresses", work)
    assert began.wait(30)
    time.sleep(0.3)
    start = time.monotonic()
    session.jobs.cancel()
    ended(job)
    print(f"cancelled within {time.monotonic() - start:.2f} s")
    assert isinstance(job.problem, CancelledError)


def test_many_fits_are_cancelled_within_one(session):
    """No fit ends after the cancel, and those that are not begun do not begin."""
    folder = ROOT / "examples" / "fit"
    problem = mdr.instruments.load_fit_file(folder / "modulus_of_oxide.toml")
    curves = problem.curves(folder / "modulus_of_oxide.csv") * 200
    job = session.jobs.start("m", "many fits", lambda progress: mdr.studies.many(problem, curves, progress=progress))
    while job.is_alive() and job.done[0] < 1:
        time.sleep(0.001)
    session.jobs.cancel()
    done = job.done[0]
    ended(job)
    assert isinstance(job.problem, CancelledError) and done <= job.done[0] <= done + 1 < 200


def test_warnings_belong_to_results_and_cross_no_threads(session):
    """Contacts with and without a warning, side by side."""
    steep = PROBLEM.replace('"sphere", radius = "10 um"', '"cone", half_angle = "30 deg"') + 'compute = { depths = ["1 um"] }\n'
    clean = PROBLEM + 'compute = { depths = ["50 nm"] }\n'
    found = {}

    def compute(i):
        text = (steep, clean)[i % 2]
        found[i] = session.jobs.now(i, lambda: mdr.studies.curve(session.problem(text))).warnings

    threads = [threading.Thread(target=compute, args=(i,)) for i in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [len(found[i]) for i in range(16)] == [1, 0] * 8


def listening_of(pid):
    """The addresses on which a process listens, as the system has them."""
    names = []
    for place in os.listdir(f"/proc/{pid}/fd"):
        with suppress(FileNotFoundError):  # the connection of a request that has ended
            names.append(os.readlink(f"/proc/{pid}/fd/{place}"))
    rows = [line.split() for file in ("tcp", "tcp6") for line in Path(f"/proc/net/{file}").read_text().splitlines()[1:]]
    return [row[1] for row in rows if row[3] == "0A" and f"socket:[{row[9]}]" in names]


@contextmanager
def command(*arguments, **more):
    """The process of the command; it ends with the test, also with one that fails."""
    with subprocess.Popen(
        [sys.executable, "-m", "mdrcontact", "app", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT, **more,
    ) as process:  # fmt: skip
        try:
            yield process
        finally:
            process.kill()


@pytest.mark.slow
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_the_command_prints_the_address_and_ends(end, tmp_path):
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    with command("--no-browser", "examples/problems/sio2_on_si.toml", env=environment) as process:
        address = process.stdout.readline().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[\w-]{32}", address)
        assert process.stdout.readline() == "Ctrl-C ends the page.\n"
        host, _, secret = address.removeprefix("http://").partition("/")
        connection = http.client.HTTPConnection(host, timeout=20)
        connection.request("GET", f"/{secret}")
        assert connection.getresponse().status == 200 and len(list(tmp_path.iterdir())) == 1
        if Path("/proc/net/tcp").exists():
            assert listening_of(process.pid) == [f"0100007F:{int(host.partition(':')[2]):04X}"]
        process.send_signal(end)
        assert process.communicate(timeout=30) == ("", "") and process.returncode == 0
    assert not list(tmp_path.iterdir())


def test_a_taken_port_and_a_missing_file_are_errors(capsys):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        assert cli.main(["app", "--no-browser", "--port", port]) == 1
    assert re.search(rf"port = {port}: it cannot be used: .*in use.*Leave it out", capsys.readouterr().err)
    for name in ("missing.toml", "missing.csv"):
        assert cli.main(["app", "--no-browser", name]) == 2
        assert re.match(rf"mdrcontact: {name}: .*o such file", capsys.readouterr().err)
    for port in ("70000", "-1", "x"):
        with pytest.raises(SystemExit):
            cli.main(["app", "--port", port])
        assert f"port = '{port}': it must be a whole number from 0 to 65535" in capsys.readouterr().err


def test_without_a_browser_the_address_is_to_be_opened(monkeypatch, capsys):
    given = []
    monkeypatch.setattr("webbrowser.open", given.append)
    monkeypatch.setattr("threading.Thread.join", lambda self, timeout=None: (_ for _ in ()).throw(KeyboardInterrupt))
    before = {one: signal.getsignal(one) for one in (signal.SIGTERM, signal.SIGHUP)}
    try:
        assert cli.main(["app"]) == 0
    finally:
        for one, handler in before.items():
            signal.signal(one, handler)
    address, said, _ = capsys.readouterr().out.splitlines()
    # what the list of processes shows is not what is printed
    assert said == "No browser was found. Open this address in one." and len(given) == 1 and given[0] != address


def test_without_the_extra_the_command_says_what_to_install():
    code = "import sys; sys.modules['dash'] = None; from mdrcontact.cli import main; sys.exit(main(['app']))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 1 and 'pip install "mdrcontact[app]"' in done.stderr


def test_the_package_loads_neither_the_page_nor_figures():
    loaded = run([sys.executable, "-c", "import sys, mdrcontact, mdrcontact.cli, mdrcontact.problem; print(*sys.modules)"], ROOT)
    assert "mdrcontact.cli.app" in loaded and not {"dash", "plotly", "flask", "tomlkit", "matplotlib"} & set(loaded.split())


def asked_once(client, output, values, changed):
    """The answer of a callback for the values of its inputs and states, as the page asks for it."""
    known = client.get("/_dash-dependencies", base_url=HERE).json
    one = next(one for one in known if one["output"].startswith(f"..{output}."))

    def given(places):
        return [{**each, "value": values.get(f"{each['id']}.{each['property']}")} for each in places]

    outputs = [dict(zip(("id", "property"), each.rsplit(".", 1), strict=True)) for each in one["output"].strip(".").split("...")]
    body = {"output": one["output"], "outputs": outputs, "inputs": given(one["inputs"]), "state": given(one["state"])}
    return client.post("/_dash-update-component", base_url=HERE, json={**body, "changedPropIds": [changed]})


def asked_of(client, output, values, changed):
    """What a callback returns at the end of its work."""
    for _ in range(600):
        answer = asked_once(client, output, values, changed)
        assert answer.status_code == 200
        found = answer.json["response"]
        if found[output.replace("results", "busy")]["hidden"]:
            return found
        changed = changed.partition("-run")[0].partition(".")[0] + "-again.n_intervals"
        time.sleep(0.1)
    raise AssertionError("the work does not end")


def texts(drawn):
    """All words of components."""
    if isinstance(drawn, dict):
        return texts(drawn.get("props", drawn).get("children"))
    return [word for one in drawn for word in texts(one)] if isinstance(drawn, list) else [drawn]


def test_a_design_through_the_callbacks_is_that_of_the_command(page, tmp_path):
    text = cli.example.examples()["sio2_on_si"]
    found = asked_of(page, "design-results", {"design.data": {"text": text}, "design-tab.value": "Curves"}, "design.data")
    expected = mdr.studies.curve(mdr.problem.read_text(text), pressures=True, references=True)
    shown = texts(found["design-results"]["children"])
    assert expected.numbers and {with_micro(str(number)) for number in expected.numbers.values()} < set(shown)
    assert {with_micro(words) for words in expected.notes.values()} < set(shown) and not found["design-alert"]["children"]
    # an error, and the field that it is about
    text = text.replace('radius = "10 um"', 'radius = "-10 um"')
    found = asked_of(page, "design-results", {"design.data": {"text": text}, "design-tab.value": "Curves"}, "design.data")
    words = "[indenter]: radius = '-10 um': it must be greater than 0 and finite."
    at_field = ["indenter/radius", "It must be greater than 0 and finite."]
    assert found["design-alert"]["children"] == words and found["design-where"]["data"] == at_field


def test_a_tick_after_a_cancel_begins_nothing(session, page, monkeypatch):
    """It may have left the browser before the cancel, and come after it."""
    begun = []

    def study(problem, progress):
        begun.append(problem)
        while True:
            progress.step(len(begun), 3, "states")
            time.sleep(0.001)

    monkeypatch.setitem(design.STUDIES, "Stress", design.Shown(study))
    known = page.get("/_dash-dependencies", base_url=HERE).json
    one = next(one for one in known if one["output"].startswith("..design-results."))
    values = {"design.data": {"text": cli.example.examples()["sio2_on_si"]}, "design-tab.value": "Stress"}

    def ask(changed):
        outputs = [
            dict(zip(("id", "property"), each.rsplit(".", 1), strict=True)) for each in one["output"].strip(".").split("...")
        ]
        inputs = [{**each, "value": values.get(f"{each['id']}.{each['property']}")} for each in one["inputs"]]
        body = {"output": one["output"], "outputs": outputs, "inputs": inputs, "state": [], "changedPropIds": [changed]}
        return page.post("/_dash-update-component", base_url=HERE, json=body).json["response"]

    assert not ask("design-tab.value")["design-busy"]["hidden"]
    for changed in ("design-cancel.n_clicks", "design-again.n_intervals"):
        assert ask(changed)["design-alert"]["children"] == "The work was cancelled."
    assert len(begun) == 1
    # the tab computes again
    assert not ask("design-tab.value")["design-busy"]["hidden"] and len(begun) == 2
    session.jobs.cancel()
    ended(session.jobs.latest)


def test_a_fit_through_the_callbacks_is_that_of_the_command(session, page):
    folder = ROOT / "examples" / "fit"
    text = (folder / "modulus_of_oxide.toml").read_text("utf-8")
    session.add({"data.csv": (folder / "modulus_of_oxide.csv").read_bytes()})
    run = {"text": text, "names": ["data.csv"], "out": [], "moves": False, "compare": False, "run": 1}
    values = {"measure-run.data": run, "measure.data": {"text": text}, "measure-names.data": run, "measure-tab.value": "Fit"}
    found = asked_of(page, "measure-results", values, "measure-run.data")
    problem = mdr.instruments.load_fit_file(folder / "modulus_of_oxide.toml")
    expected = mdr.studies.fit(problem, problem.read_data(folder / "modulus_of_oxide.csv")[0]).fit
    shown = texts(found["measure-results"]["children"])
    assert len(expected.names) > 0 and {expected.as_text(name) for name in expected.names} <= set(shown)


def test_a_file_that_is_replaced_is_fitted_anew(session, page):
    """A page that is drawn again counts its clicks from 1."""
    folder = ROOT / "examples" / "fit"
    text, table = (folder / "modulus_of_oxide.toml").read_text("utf-8"), (folder / "modulus_of_oxide.csv").read_text("utf-8")
    run = {"text": text, "names": ["data.csv"], "out": [], "moves": False, "compare": False, "run": 1}
    values = {"measure-run.data": run, "measure.data": {"text": text}, "measure-names.data": run, "measure-tab.value": "Fit"}
    head, *rows = table.splitlines()
    shown = []
    for content in (table, "\n".join([head, *rows[::2]])):
        session.add({"data.csv": content.encode()})
        shown.append(texts(asked_of(page, "measure-results", values, "measure-run.data")["measure-results"]["children"]))
    problem = mdr.instruments.load_fit_file(folder / "modulus_of_oxide.toml")
    data = session.fit_file(text).curves(session.files["data.csv"])[0].read()[0]
    fit = mdr.studies.fit(problem, data).fit
    assert fit.as_text("coating.E") in shown[1] and fit.as_text("coating.E") not in shown[0]


def test_a_bug_is_reported_on_the_page(session, page, monkeypatch):
    def broken(*_given):
        raise ZeroDivisionError("in a callback")

    monkeypatch.setattr("mdrcontact.app.measure.inspected", broken)
    values = {"measure-names.data": {"names": ["data.csv"]}, "measure.data": {"text": ""}, "measure-tab.value": "Data"}
    answer = asked_once(page, "measure-results", values, "measure-tab.value")
    words = "This is a bug of mdrcontact, please report it: ZeroDivisionError('in a callback')"
    assert answer.json["sideUpdate"]["measure-alert"]["children"] == words


def test_a_fit_of_files_that_are_gone_is_no_fault(session, page):
    """The command was started again, and another file was dropped."""
    text = (ROOT / "examples" / "fit" / "modulus_of_oxide.toml").read_text("utf-8")
    run = {"text": text, "names": ["gone.csv"], "out": [], "moves": False, "compare": False, "run": 1}
    values = {"measure-run.data": run, "measure.data": {"text": text}}
    session.add({"other.csv": b"1"})
    for names, tab in ((["other.csv"], "Fit"), (["gone.csv"], "Fit"), (["gone.csv"], "Data")):
        more = {"measure-names.data": {**run, "names": names}, "measure-tab.value": tab}
        found = asked_of(page, "measure-results", {**values, **more}, "measure-run.data")
        assert found["measure-alert"]["children"] == "The files that were dropped are no longer there. Drop them again."
