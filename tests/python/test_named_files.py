# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that problems name: any regular file from the command line, those given with a text and no other; errors repeat nothing."""

import json
import os
import re
import socket
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.instruments.files.fit_file import fit_file_of_text, load_fit_file
from mdrcontact.problem import ProblemError, load, load_map, read, read_map_text, read_text

BODY = '[indenter]\nshape = "paraboloid"\nradius = "1 um"\n[medium]\ntype = "homogeneous"\nmaterial = { E = "1 GPa", nu = 0.3 }\n'
TIP = "[indenter]\nfile = NAME\n"
FIT = '[medium]\ntype = "homogeneous"\nmaterial = { E = "1 GPa", nu = 0.3 }\n[data]\nkind = "force-depth"\n[fit]\nfree = ["E"]\n'
KEYS = {
    "[friction] path": (BODY + "[friction]\ncoefficient = 0.3\npath = NAME\n", "path.csv"),
    "[history] file": (BODY + '[history]\npath = "file"\nfile = NAME\n', "path.csv"),
    "[indenter] file": (TIP + BODY[BODY.index("[medium]") :] + '[compute]\nmax_depth = "1 nm"\n', "tip.toml"),
    "[indenter] file of a fit": (TIP + FIT, "tip.toml"),
    "[structure] labels": (
        '[structure]\nlabels = NAME\nspacing = ["1 um", "1 um", "1 um"]\n[[structure.phase]]\nE = "3 GPa"\nnu = 0.3\n'
        '[[structure.phase]]\nE = "3 GPa"\nnu = 0.3\n[map]\nradii = ["1 um"]\n',
        "labels.npy",
    ),
}
"""Every key that names a file: a problem, and a good name."""
SOUND = {
    "path.csv": b"time [s],depth [nm],shift [nm]\n0,0,0\n1,5,1\n2,8,2\n",
    "tip.toml": b'[indenter]\nshape = "paraboloid"\nradius = "1 um"\n',
    "labels.npy": b"",
}
SECRET = re.compile("hunter2|root:|13.37|2345|2.345")
SECRETS = {
    "passwd": "root:x:0:0:root,hunter2:/root:/bin/bash\nsync:x:4:65534:sync,hunter2,:/bin:/bin/sync\n",
    "table": "hunter2,hunter2b\n1,2\n3,4\n",
    "table with time": "time [s],hunter2\n1,2\n3,4\n",
    "twice": "hunter2,hunter2,a\n1,2,3\n3,4,5\n",
    "wrong cell": "time [s],depth [nm],force [mN],shift [nm]\n1,2,3,4\n2,13.37.42,3,4\n3,4,5,5\n",
    "words": "hunter2 is the word\nthat none knows\n",
    "toml": "hunter2 = 1\nhunter2 = 2\n",
    "no toml": "[hunter2\n",
    "other toml": '[login]\npassword = "hunter2"\n',
    "other key": "[indenter]\nhunter2 = 1\n",
    "other value": '[indenter]\nshape = "paraboloid"\nradius = "hunter2"\n',
    "quote": 'a,b\n1,"hunter2\n2,3\n4,5\n6,7\n8,9\n',
    "lines": "hunter2\n" * 30,
    "marks": "time [s];depth [nm];force [mN];shift [nm]\n1,5;2.5;hunter2;1\n2,5;3.5;hunter2;1\n",
    "thousands": "hunter2;hunter2b;c;d\n1.234;2.345;3;4\n1.234;2.345;3;4\n",
    "units": "hunter2 [s];b [nm]\nms;nm\n1;2\n2;3\n",
}


def opened(key, text, path=None, files=()):
    """Reads a problem as the command that takes it does: the file, or the text with files."""
    if key == "[indenter] file of a fit":
        return load_fit_file(path) if path else fit_file_of_text(text, files=files)
    if key == "[structure] labels":
        return load_map(path) if path else read_map_text(text, files=files)
    return load(path) if path else read_text(text, files=files)


def naming(key, name):
    """The text of a problem that names a file."""
    return KEYS[key][0].replace("NAME", json.dumps(name))


def written(folder, key, name):
    path = folder / "problem.toml"
    path.write_text(naming(key, str(name)))
    return path


def prepared(folder):
    for name, content in SOUND.items():
        (folder / name).write_bytes(content)
    np.save(folder / "labels.npy", np.zeros((1, 2, 2), np.uint8))


def test_the_walk_has_every_key_that_names_a_file():
    """Each goes through `Section.file`, and nothing of a problem is opened elsewhere."""
    root = Path(mdr.__file__).parent
    paths = [path for room in ("problem", "instruments", "app", "cli") for path in root.glob(f"{room}/**/*.py")]
    sources = {str(path.relative_to(root)): path.read_text(encoding="utf-8") for path in paths}
    keys = {found for text in sources.values() for found in re.findall(r'\.(?:file|table)\(\s*"(\w+)"', text)}
    assert keys == {re.search(r"\] (\w+)", key)[1] for key in KEYS} == {"path", "file", "labels"}
    opening = re.compile(
        r"(?<!os)(?<!webbrowser)\.open\(|(?<![\w.])open\(|read_text\(\)|read_bytes\(|read_text\(enc|np\.load\(|fromfile|memmap\("
    )
    openers = {name for name, text in sources.items() if opening.search(text)}
    # the command line's own files: the problem, the data, the examples and texts of the package, what a report states the origin
    # of; the array that is mapped; and the files that were dropped on the page
    assert openers == {
        *("problem/named.py", "problem/toml.py", "instruments/reading/content.py"),
        *("cli/__init__.py", "cli/example.py", "cli/files.py", "problem/structure.py", "app/measure.py"),
    }


@pytest.mark.parametrize("key", KEYS)
def test_a_file_of_the_user_names_files_beside_it_and_elsewhere(key, tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "here").mkdir()
    prepared(tmp_path / "data")
    prepared(tmp_path / "here")
    good = KEYS[key][1]
    for name in (good, f"../data/{good}", tmp_path / "data" / good):
        assert opened(key, "", written(tmp_path / "here", key, name))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
@pytest.mark.parametrize("key", KEYS)
def test_what_is_no_regular_file_is_refused_at_once(key, tmp_path):
    """A pipe without a writer and a device without an end, too."""
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("/dev/zero")
    listening = socket.socket(socket.AF_UNIX)
    listening.bind(str(tmp_path / "socket"))
    missing = ["a\0b", "missing.csv", "x" * 5000]
    names = ["pipe", "link", "socket", "/dev/zero", "/dev/stdin", "/dev/tty", ".", str(tmp_path), "", *missing]
    for name in names:
        with pytest.raises(ProblemError, match="cannot be read") as refusal:
            opened(key, "", written(tmp_path, key, name))
        # there may be no terminal
        assert ("regular file" in str(refusal.value)) == (name not in missing) or name in ("/dev/stdin", "/dev/tty")
    listening.close()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_command_does_not_wait_for_a_pipe(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    path = written(tmp_path, "[friction] path", "pipe")
    command = [sys.executable, "-m", "mdrcontact", "friction", str(path), "--csv", str(tmp_path / "out.csv")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)
    assert done.returncode == 2 and "regular file" in done.stderr


@pytest.mark.parametrize("kind", SECRETS)
@pytest.mark.parametrize("key", KEYS)
def test_errors_repeat_nothing_of_a_named_file(key, kind, tmp_path):
    (tmp_path / "named").write_text(SECRETS[kind])
    refusals = []
    for text in (None, naming(key, "named")):
        with pytest.raises(mdr.MDRError) as refusal:
            opened(key, text, written(tmp_path, key, "named") if text is None else None, {"named": SECRETS[kind].encode()})
        refusals.append(str(refusal.value))
        # nor do the errors before it, which a traceback prints
        cause = refusal.value.__cause__
        while cause is not None:
            refusals.append(str(cause))
            cause = cause.__cause__
    assert not any(SECRET.search(words.replace(str(tmp_path), "")) for words in refusals)


def test_the_command_line_repeats_nothing_either(tmp_path, capsys):
    (tmp_path / "named").write_text(SECRETS["passwd"])
    for key, command in (("[friction] path", "friction"), ("[history] file", "history"), ("[indenter] file", "curve"),
                         ("[structure] labels", "map")):  # fmt: skip
        assert main([command, str(written(tmp_path, key, "named"))]) == 2
        shown = capsys.readouterr()
        assert not SECRET.search(shown.err.replace(str(tmp_path), "")) and "named" in shown.err


def test_errors_still_help_with_a_table_of_measurements(tmp_path):
    """Titles of measurements are named, places of cells too."""
    (tmp_path / "named").write_text("time [s],load [mN],who\n1,2,3\n2,3,4\n")
    with pytest.raises(ProblemError, match=r"no column is the depth.*'time \[s\]', 'load \[mN\]', 1 with other titles"):
        load(written(tmp_path, "[history] file", "named"))
    (tmp_path / "named").write_text(SECRETS["wrong cell"])
    with pytest.raises(ProblemError, match=r"line 3, column 2: it is no number"):
        load(written(tmp_path, "[history] file", "named"))
    (tmp_path / "named").write_text('[indenter]\nshape = "paraboloid\n')
    with pytest.raises(ProblemError, match=r"named: it is not valid TOML \(at line 2, column \d+\)"):
        load(written(tmp_path, "[indenter] file", "named"))


@pytest.mark.parametrize("key", KEYS)
def test_a_text_opens_what_is_given_and_nothing_else(key, tmp_path, monkeypatch):
    prepared(tmp_path)
    monkeypatch.chdir(tmp_path)
    good = KEYS[key][1]
    (tmp_path / "link").symlink_to(good)
    names = ["/etc/passwd", "../x", "link", "/dev/zero", ".", str(tmp_path / good), f"./{good}", good.upper(), ""]
    for files in ({}, {"a.csv": b"", "b.csv": b""}):
        for name in [*names, good]:
            with pytest.raises(ProblemError, match="not among the given files") as refusal:
                opened(key, naming(key, name), None, files)
            assert ("a.csv, b.csv" in str(refusal.value)) == bool(files) and f"= {name!r}" in str(refusal.value)
    for files in ({good: (tmp_path / good).read_bytes()}, {good: tmp_path / good}, [tmp_path / good], [str(tmp_path / good)]):
        assert opened(key, naming(key, good), None, files)
    with pytest.raises(ProblemError, match="regular file"):
        opened(key, naming(key, good), None, {good: tmp_path})


def test_tables_of_a_program_name_nothing_unless_it_says_where(tmp_path, monkeypatch):
    prepared(tmp_path)
    monkeypatch.chdir(tmp_path)
    tables = {
        "indenter": {"file": "tip.toml"},
        "medium": {"type": "homogeneous", "material": {"E": "1 GPa", "nu": 0.3}},
        "history": {"path": "file", "file": "path.csv"},
    }
    with pytest.raises(ProblemError, match="not among the given files. There are none"):
        read(tables)
    assert len(read(tables, folder=tmp_path).history.time) == 3
    assert len(read(tables, files={"path.csv": SOUND["path.csv"], "tip.toml": tmp_path / "tip.toml"}).history.time) == 3


def test_lists_of_files_that_cannot_be():
    for files in ("path.csv", ["a/x.csv", "b/x.csv"]):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="files"):
            read_text(BODY, files=files)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="it must be bytes"):
        read_text(BODY, files={"path.csv": 7})
    assert (
        read_text(KEYS["[history] file"][0].replace("NAME", '"p"'), files={"p": bytearray(SOUND["path.csv"])}).history is not None
    )
    with pytest.raises(ProblemError, match="cannot be read"):
        load("a\0b")


def test_a_tip_names_no_further_file(tmp_path):
    (tmp_path / "tip.toml").write_text('[indenter]\nfile = "other.toml"\n')
    (tmp_path / "other.toml").write_bytes(SOUND["tip.toml"])
    with pytest.raises(ProblemError, match="is not a tip"):
        load(written(tmp_path, "[indenter] file", "tip.toml"))
