# SPDX-License-Identifier: GPL-3.0-or-later
"""Every writer: whole files or none, through links, onto regular files only."""

import contextlib
import os
import resource
import signal
import stat
import sys
import threading

import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact._files import replace
from mdrcontact.cli import main

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links, pipes and limits of POSIX")


@pytest.fixture(scope="module")
def law():
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))), 0.1)


@pytest.fixture(scope="module")
def fitted():
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3)))
    depth = [0.01, 0.02, 0.03, 0.04, 0.05, 0.06]
    data = mdi.ForceDepth(depth, contact.at_depth(depth).force)
    return mdi.fit(data, contact.indenter, contact.medium, ["E"])


@pytest.fixture(params=["law", "json", "plot"])
def writer(request, law, fitted):
    return {"law": law.save, "json": fitted.to_json, "plot": fitted.plot().save}[request.param]


@contextlib.contextmanager
def full_disk():
    """Files may grow to 100 bytes and no further; a log to which pytest itself writes, too, hence only within the block."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


def test_full_disk_leaves_what_was_there(tmp_path, writer):
    path = tmp_path / "result.png"
    path.write_bytes(b"before")
    for place in (path, tmp_path / "new.png"):
        with full_disk(), pytest.raises(mdr.errors.FileError, match="cannot be written"):
            writer(place)
    assert path.read_bytes() == b"before"
    assert os.listdir(tmp_path) == ["result.png"]


def test_links_are_followed(tmp_path, writer):
    target = tmp_path / "target.png"
    target.write_bytes(b"before")
    target.chmod(0o640)
    link = tmp_path / "link.png"
    link.symlink_to("target.png")
    writer(link)
    assert link.is_symlink() and not target.is_symlink()
    assert target.read_bytes() != b"before"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640
    dangling = tmp_path / "dangling.png"
    dangling.symlink_to("later.png")
    writer(dangling)
    assert dangling.is_symlink() and (tmp_path / "later.png").is_file()


def test_only_regular_files_are_written(tmp_path, writer):
    pipe = tmp_path / "pipe.png"
    os.mkfifo(pipe)
    circle = tmp_path / "circle.png"
    circle.symlink_to("circle.png")
    for place in (pipe, circle):
        with pytest.raises(mdr.errors.FileError, match="not a regular file"):
            writer(place)
    with pytest.raises(mdr.errors.FileError, match="is a folder"):
        writer(tmp_path)
    assert stat.S_ISFIFO(pipe.lstat().st_mode)


@pytest.mark.parametrize("option", ["--csv", "--plot"])
def test_overwrite_replaces_no_device(tmp_path, monkeypatch, capsys, option):
    monkeypatch.chdir(tmp_path)
    assert main(["example", "sio2_on_si"]) == 0
    (tmp_path / "problem.toml").write_text(capsys.readouterr().out)
    name = "result.png"
    os.mkfifo(name)
    assert main(["curve", "problem.toml", option, name, "--overwrite"]) == 1
    assert "not a regular file" in capsys.readouterr().err
    assert stat.S_ISFIFO(os.lstat(name).st_mode)
    os.unlink(name)
    os.symlink("target", name)
    assert main(["curve", "problem.toml", option, name]) == 0
    assert os.path.islink(name) and os.path.isfile("target")
    assert main(["curve", "problem.toml", option, name]) == 1
    assert main(["curve", "problem.toml", option, name, "--overwrite"]) == 0
    assert os.path.islink(name)


def test_blanks_in_a_name_count(tmp_path, law):
    law.save(tmp_path / "law")
    replace(tmp_path / "law ", b"other")
    assert mdr.ContactLaw.load(tmp_path / "law") == law


def test_threads_that_save_and_load_one_file(tmp_path, law):
    path = tmp_path / "law"
    law.save(path)
    failures = []

    def work():
        try:
            for _ in range(20):
                law.save(path)
                assert mdr.ContactLaw.load(path) == law
        except (AssertionError, OSError) as problem:
            failures.append(problem)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures
