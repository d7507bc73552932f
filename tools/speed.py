# SPDX-License-Identifier: GPL-3.0-or-later
"""Times that tools/speed.sh compares: prints a name and microseconds of processor time, one pair a line."""

import time
import warnings

import numpy as np

import mdrcontact as mdr
import mdrcontact.instruments as mdi

ROUNDS = 7
OXIDE, SILICON = mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22)
BALL = mdr.Paraboloid(1e-5)
FILM = mdr.Coated(OXIDE, 5e-7, SILICON)
CONTACT = mdr.Contact(BALL, FILM)


def report(name, work):
    """The least of some rounds, each of some milliseconds."""
    start = time.process_time()
    work()
    calls = 1 + int(5e-3 / (time.process_time() - start + 1e-9))
    spent = []
    for _ in range(ROUNDS):
        start = time.process_time()
        for _ in range(calls):
            work()
        spent.append((time.process_time() - start) / calls)
    print(f"{name}: {1e6 * min(spent):.6g}")


def new_film():
    """With a modulus of its own each time, so that no kernel is found again."""
    global film
    film += 1e-9
    mdr.Coated(mdr.Elastic(72e9 * film, 0.17), 5e-7, SILICON).modulus(1e-6)


film = 1.0
warnings.simplefilter("ignore")
law = mdr.ContactLaw(CONTACT, 1e-7)
deep = np.geomspace(1e-11, 1e-7, 4096)
report("forces of a law in an array", lambda: law.force(deep))
report("new law of a film", lambda: mdr.ContactLaw(CONTACT, 1e-7))
friction = mdr.Friction(CONTACT, 0.4)
sliders = mdr.ContactLaw(CONTACT, 1e-7, friction=friction)
memory, force, shift = sliders.contacts(1000), np.full(1000, 1e-4), np.full((1000, 2), 1e-10)
report("step of a friction law", lambda: sliders.attempt(memory, force, shift, True))
for reach in (0.1, 1.0, 100.0):
    depths = CONTACT.at_radius(reach * FILM.thickness * np.linspace(0.5, 1.0, 200)).depth
    report(f"states of a film, a/h = {reach:g}", lambda d=depths: CONTACT.at_depth(d))
report("a state from Python", lambda: CONTACT.at_depth(5e-8))
report("new film", new_film)
pair = mdr.Contact(BALL, mdr.Pair(FILM, mdr.Layered([(SILICON, 2e-7)], OXIDE)))
report("states of a pair", lambda: pair.at_depth(deep[::20]))
depth = np.linspace(1e-9, 1e-7, 500)
curve = mdi.ForceDepth(depth, CONTACT.at_depth(depth).force)
report("fit of 500 points", lambda: mdi.fit(curve, BALL, FILM.replace(coating=mdr.Elastic(5e10, 0.17)), ["coating.E", "thickness"]))
state = CONTACT.at_depth(5e-8)
r, z = np.linspace(0.0, 2e-6, 30)[:, None], np.linspace(1e-8, 2e-6, 30)
report("grid inside", lambda: state.interior(r, z))
amplitude = 0.5 * friction.shear(state).sliding_shift
report("loop of friction", lambda: friction.shear(state).loop(amplitude))
gel = mdr.Coated(mdr.Viscoelastic(1e6, [(2e6, 0.3)], nu=0.4), 5e-6, mdr.Viscoelastic(2e6, [(1e6, 1.0)], nu=0.3))
relaxing, times = mdr.Contact(BALL, gel), np.linspace(0.1, 5.0, 9)
report("march of a gel", lambda: relaxing.history(times, depth=1e-7 * np.sin(times)))
