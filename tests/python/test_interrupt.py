# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C during a long call ends it within a fraction of a second and leaves objects as they were."""

import signal
import subprocess
import sys

import pytest

SCRIPT = """
import os, signal, threading, time
import numpy as np
import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import lateral

signal.signal(signal.SIGINT, signal.default_int_handler)  # Python leaves a signal alone that its parent ignores
graded = mdr.Graded([0.0, 0.5, 2.0], [1.0, 2.0, 5.0], 0.3)
contact = mdr.Contact(mdr.Paraboloid(1.0), graded)
before = contact.at_depth(0.5)
many = np.linspace(0.01, 1.0, 3_000_000)
balls = [lateral.Ball((np.sin(3 * i), np.cos(5 * i), 0.6), 0.5, mdr.Elastic(1.0 + i, 0.3)) for i in range(40)]
structure = lateral.Shapes(mdr.Elastic(1.0, 0.3), balls)
depth = np.linspace(0.01, 1.0, 300)
curve = mdi.ForceDepth(depth, depth**2 * (1 + np.sin(9 * depth)))
relaxing = mdr.Viscoelastic(1.0, [(2.0, 0.5)], nu=0.5)
film = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(relaxing, 1.0, mdr.Viscoelastic(0.6, [(0.4, 2.0)], nu=0.3)))
soft, hard = mdr.Elastic(0.091, 0.3), mdr.Elastic(0.91, 0.3)
wear = mdr.wear.Wear(mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(hard, 1.0, soft)), 1.0)
worn = wear.history(force=0.5, intervals=160, scheme="rings")
time_of_path = np.linspace(0.0, 30.0, 2000)
names = ["E[1]", "E[2]", "nu[1]", "z[1]"]

calls = {CALLS}
for name, call in calls.items():
    pressed = []

    def press():
        pressed.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    threading.Timer(0.3, press).start()
    try:
        call()
    except KeyboardInterrupt:
        print(name, time.monotonic() - pressed[0])
assert contact.at_depth(0.5) == before
assert worn.state.sliding == 0.0 and worn.advance(0.001, force=0.5).sliding == 0.001
"""

CALLS = {
    "states": "lambda: contact.at_force(many)",
    "map": "lambda: structure.modulus(many, many, 0.5)",
    "fit": "lambda: mdi.fit(curve, mdr.FlatEndedCone(0.1, 0.3), graded, names, check_units=False)",
    "history": "lambda: film.history(time_of_path, depth=np.sin(time_of_path) ** 2, tolerance=1e-9)",
    "wear": "lambda: worn.advance(np.full(100_000, 1.0), force=0.5)",
    "fits": "lambda: mdi.fit_many([curve] * 1000, mdr.Cone(0.3), graded, names, check_units=False)",
}


def ignore_interrupts():
    """As a shell starts what runs in the background."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_interrupted_calls_end_soon():
    """Each call would take 15 s or more. It ends within 0.2 s; the bound leaves room for a slow machine with other work."""
    calls = "{" + ", ".join(f'"{name}": {code}' for name, code in CALLS.items()) + "}"
    command = [sys.executable, "-c", SCRIPT.replace("{CALLS}", calls)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=400, check=False, preexec_fn=ignore_interrupts)
    assert not done.stderr
    waited = dict(line.split() for line in done.stdout.splitlines())
    assert set(waited) == set(CALLS)
    assert max(map(float, waited.values())) < 5.0
