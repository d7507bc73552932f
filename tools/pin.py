#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Some 3,000 numbers of the library, over all indenters and media, against tests/data/pins.txt: tools/pin.py

They say that a change of the code's structure changed no number; whether a number is right is said by the other tests. Each is
compared relative to the largest number between two bars, by 1e-12 or as `ALLOWED` says: other machines, compilers and versions of
LAPACK change last digits. Status 1 if a row deviates or is missing.

    tools/pin.py --exact        # bit for bit, on the machine and by the compiler that made the file
    tools/pin.py --write        # adds rows that the file lacks; a row that may change is deleted from the file first
"""

from __future__ import annotations

import argparse
import math
import sys
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
PINS = ROOT / "tests" / "data" / "pins.txt"
sys.path.insert(0, str(ROOT / "tests" / "python"))

from conftest import OXIDE, RUBBER, SILICON, every_medium, every_profile, numbers_of  # noqa: E402

import mdrcontact as mdr  # noqa: E402
import mdrcontact.instruments as mdi  # noqa: E402
from mdrcontact import lateral  # noqa: E402

Row = tuple[str, Callable[[], Any]]

ALLOWED = {"fit ": 1e-6, "critical places ": 1e-4, "critical ": 1e-10, "failure ": 2e-9}
"""What a row may deviate by, by the beginning of its name; else 1e-12. A least-squares fit ends where steps are below its own
tolerance: other versions of LAPACK move its numbers by up to 9e-9, another start by 4e-7. The search for a largest stress ends
where it is known to 1e-11, which leaves its place uncertain by the root of that, and loads at failure are known to 1e-9. All others
move by 8e-14."""

LENGTH = np.array([3e-8, 2e-7, 1.3e-6])
BALL = mdr.Paraboloid(5e-6)
FILM = mdr.Coated(OXIDE, 5e-7, SILICON)
GLUED = mdr.Layered([mdr.Layer(mdr.CRYSTALS["GaN"].material, 2e-7, interface=mdr.Interface(normal=2e17))], SILICON)


def labelled(objects: list[Any]) -> list[tuple[str, Any]]:
    """Objects by class and model, counted where several have the same."""
    seen: dict[str, int] = {}
    found = []
    for one in objects:
        name = "-".join([type(one).__name__, *([one.model] if hasattr(one, "model") else [])])
        seen[name] = seen.get(name, 0) + 1
        found.append((f"{name}-{seen[name]}" if seen[name] > 1 else name, one))
    return found


def profiles() -> Iterator[Row]:
    for name, profile in labelled(every_profile()):
        for of in ("height", "slope", "mdr", "mdr_slope"):
            yield f"profile {of} {name}", lambda p=profile, of=of: getattr(p, of)([1e-7, 2.7e-7, 8e-7])


def media() -> Iterator[Row]:
    for name, medium in labelled(every_medium()):
        for of in ("modulus", "stiffness", "tangential_modulus", "torsional_stiffness"):
            yield f"medium {of} {name}", lambda m=medium, of=of: getattr(m, of)(LENGTH)


def states() -> Iterator[Row]:
    for profile_name, profile in labelled(every_profile()):
        for name, medium in labelled(every_medium()):
            yield f"state {profile_name} {name}", lambda p=profile, m=medium: numbers_of(mdr.Contact(p, m).at_depth(4e-8))[1:4]


def contacts() -> Iterator[Row]:
    """Adhesion, fields, stresses and shear of a paraboloid on every medium."""
    for name, medium in labelled(every_medium()):
        contact = mdr.Contact(BALL, medium)
        for row, make in {
            "adhesive": lambda m=medium: adhesive(m),
            "force": lambda c=contact: numbers_of(c.at_force(1e-5 * c.medium.modulus(1e-6) * 1e-6))[:4],
            "field": lambda c=contact: fields(c),
            "field of flat end": lambda m=medium: fields(mdr.Contact(mdr.FlatEndedCone(1e-7, 0.3), m)),
            "interior": lambda c=contact: interior(c, "lower", 0.0),
            "interior sliding": lambda c=contact: interior(c, "lower", 0.3),
            "interior upper": lambda c=contact: interior(c, "upper", 0.1),
            "shear": lambda c=contact: sheared(c),
            "twist": lambda c=contact: twisted(c),
        }.items():
            yield f"{row} {name}", make


def fields(contact: mdr.Contact) -> Any:
    state = contact.at_depth(4e-8)
    at = float(state.radius) * np.array([0.2, 0.9])
    yield state.pressure(at), state.line_load(at), state.displacement(3.0 * at)
    yield state.energy(), state.displacement(3.0 * at, body="upper")


def interior(contact: mdr.Contact, body: str, friction: float) -> Any:
    state = contact.at_depth(4e-8)
    r, z = float(state.radius) * np.array([[0.3, 1.1], [0.2, 0.7]])
    return state.interior(r, z, body=body, friction=friction, angle=0.4)


def adhesive(medium: mdr.Medium) -> Any:
    contact = mdr.Contact(BALL, medium, work_of_adhesion=1e-10 * medium.modulus(1e-6))
    yield contact.pull_off("force")[:3], contact.pull_off("depth")[:3]
    yield [contact.at_depth(1e-9, branch).radius for branch in ("loading", "unloading")]


def sheared(contact: mdr.Contact) -> Any:
    state = contact.at_depth(4e-8)
    shear = mdr.Friction(contact, 0.4).shear(state)
    reach = shear.sliding_shift
    found = shear.at_shift(0.6 * reach)
    yield reach, tuple(found)[:5], shear.cycle_energy(0.3 * reach)
    yield shear.traction(np.array([0.3, 0.95]) * state.radius, found)


def twisted(contact: mdr.Contact) -> Any:
    state = contact.at_depth(4e-8)
    twist = mdr.Friction(contact, 0.4).twist(state)
    turned = twist.at_force(0.6 * twist.sliding_force)
    yield twist.sliding_force, tuple(turned)[:5], twist.traction(0.7 * state.radius, turned)


def paths() -> Iterator[Row]:
    """Friction along paths, time, laws."""
    for name, medium in (("half-space", mdr.Homogeneous(OXIDE)), ("film", FILM)):
        contact = mdr.Contact(BALL, medium)
        loaded = mdr.Contact(BALL, medium, work_of_adhesion=1.0)
        yield f"loop {name}", lambda c=loaded: c.loop("force", 1e-3, 9)[:4]
        yield f"loop by a spring {name}", lambda c=loaded: c.loop("spring", 1e-7, 5, spring_stiffness=2e4)[:4]
        yield f"history of friction {name}", lambda c=contact: rubbed(c)
        yield f"law {name}", lambda c=contact: compiled(c)
        yield f"adhesive law {name}", lambda c=loaded: compiled(c)
        yield f"friction law {name}", lambda c=contact: sliders(c)
        yield f"critical {name}", lambda c=contact: [(one.value, one.angle) for one in maxima(c)]
        yield f"critical places {name}", lambda c=contact: [np.array([one.r, one.z]) for one in maxima(c)]
        yield f"failure {name}", lambda c=contact: failures(c)
    gel, polymer = mdr.Viscoelastic(1e6, [(2e6, 0.3), (5e5, 3.0)], nu=0.4), mdr.Viscoelastic(2e6, [(1e6, 1.0)], bulk_modulus=8e6)
    power = mdr.PowerLawRheology(1e6, 1.0, 0.3, 0.5)
    for name, medium in {
        "gel": mdr.Homogeneous(gel),
        "power law": mdr.Homogeneous(power),
        "gel on a rigid base": mdr.Coated(gel, 5e-6, mdr.RIGID),
        "gel on a polymer": mdr.Coated(gel, 5e-6, polymer),
    }.items():
        contact = mdr.Contact(BALL, medium)
        yield f"history {name}", lambda c=contact: c.history([0.1, 0.6, 2.0, 4.0, 5.0], depth=[1e-8, 5e-8, 9e-8, 4e-8, 7e-8])
        yield f"history of force {name}", lambda c=contact: c.history([0.1, 0.6, 2.0, 4.0], force=[1e-8, 5e-8, 9e-8, 9e-8])
        yield f"dynamic {name}", lambda c=contact: c.dynamic_stiffness([0.1, 1.0, 30.0], radius=5e-7)
        yield f"step {name}", lambda c=contact: c.relaxation([0.1, 1.0, 9.0], 5e-7)
        yield f"creep {name}", lambda c=contact: c.creep([0.1, 1.0, 9.0], 5e-7)


def rubbed(contact: mdr.Contact) -> Any:
    history = mdr.Friction(contact, 0.4).history(6e-8, 20)
    return tuple(history.advance(depth=[1e-8, 4e-8, 4e-8, 6e-8, 2e-8], shift=[0.0, 2e-9, 6e-9, 1e-9, -3e-9]))[:5]


def compiled(contact: mdr.Contact) -> Any:
    law = mdr.ContactLaw(contact, 6e-8, tolerance=1e-10)
    depth = np.array([1e-10, 3e-9, 5.5e-8])
    return law.at_depth(depth), law.energy(depth), law.at_force(law.force(depth)).depth


def sliders(contact: mdr.Contact) -> Any:
    law = mdr.ContactLaw(contact, 6e-8, friction=mdr.Friction(contact, 0.4))
    memory = law.contacts(2)
    for step in range(3):
        yield law.advance(memory, np.array([1e-5, 2e-4]) * (1 + step), np.array([[1e-9, 0.0], [5e-10, (1 - step) * 1e-9]]))


def maxima(contact: mdr.Contact) -> list[mdr.Maximum]:
    """The largest stresses of a state that slides."""

    def within(found: Any) -> Iterator[mdr.Maximum]:
        if isinstance(found, mdr.Maximum):
            yield found
        elif isinstance(found, tuple):
            for part in found:
                yield from within(part)

    return [*within(contact.at_depth(4e-8).critical(friction=0.2))]


def failures(contact: mdr.Contact) -> Any:
    count = 1 + (contact.medium is FILM)
    for found in contact.first_failure({"von_mises": [2e9] * count, "tension": [1e9] * count}, largest_radius=3e-6):
        yield found.state.force


def fits() -> Iterator[Row]:
    depth = np.linspace(1e-9, 1e-7, 30)
    wave = 1.0 + 0.01 * np.sin(7.0 * np.arange(depth.size))
    for name, medium, free, instrument in (
        ("film", FILM, ["coating.E", "substrate.E"], {}),
        ("gao", FILM.with_model("gao"), ["coating.E", "thickness"], {}),
        ("layers", mdr.Layered([(OXIDE, 2e-7), (SILICON, 3e-7)], OXIDE), ["layers[0].E", "layers[1].E"], {}),
        ("half-space", mdr.Homogeneous(OXIDE), ["E", "depth_offset"], {}),
        ("power law graded", mdr.PowerLawGraded(7e10, 1e-6, 0.3, 0.2), ["E0", "exponent"], {}),
        ("graded", mdr.Graded([0.0, 1e-6], [72e9, 160e9], 0.2, "gao"), ["E[0]", "E[1]"], {}),
        ("springs", GLUED, ["layers[0].C44", "layers[0].interface.normal"], {}),
        ("stress", GLUED, ["layers[0].prestress"], {}),
        ("frame", FILM, ["coating.E", "frame_compliance"], {"frame_compliance": 1e-7}),
        ("adhesion", mdr.Homogeneous(RUBBER), ["E", "work_of_adhesion"], {"work_of_adhesion": 0.05}),
    ):  # fmt: skip
        yield f"fit {name}", lambda m=medium, f=free, i=instrument: fitted(m, f, i, depth, wave)


def fitted(medium: mdr.Medium, free: list[str], instrument: dict[str, float], depth: Any, wave: Any) -> Any:
    truth = mdr.Contact(BALL, medium, work_of_adhesion=instrument.get("work_of_adhesion", 0.0)).at_depth(depth).force
    found = mdi.fit(
        mdi.ForceDepth(depth, truth * wave, relative_sd=0.01), BALL, medium, free, instrument=mdi.Instrument(**instrument)
    )
    return [found.estimates[name] for name in free], [found.standard_errors[name] for name in free], found.fitted[::7]


def composites() -> Iterator[Row]:
    cells = lateral.Voxels(np.arange(60).reshape(3, 4, 5) % 2, [OXIDE, SILICON], 2e-7)
    bodies = lateral.Shapes(SILICON, [lateral.Ball((0.0, 1e-7, 4e-7), 3e-7, OXIDE), lateral.Layer(0.0, 1e-7, RUBBER)])
    for name, structure in (("voxels", cells), ("shapes", bodies)):
        yield f"composite {name}", lambda s=structure: s.modulus([0.0, 2e-7], 1e-7, LENGTH[:, None])
    yield "density", lambda: lateral.density([0.3, 0.9, 2.0], [0.1, 0.5, 0.2], 0.3)
    yield "weights", lambda: [getattr(mdr.weights, name)([0.1, 1.0, 7.0]) for name in mdr.weights.__all__]
    yield "closed forms", lambda: mdr.closed_forms.coated_paraboloid_force(LENGTH, 5e-6, 3e10, 7e10, 5e-7)
    yield "closed forms of cones", lambda: mdr.closed_forms.coated_cone_force(LENGTH, 0.3, 3e10, 7e10, 5e-7)
    yield (
        "closed forms with adhesion",
        lambda: mdr.closed_forms.coated_paraboloid_adhesive_depth(LENGTH, 5e-6, 3e10, 7e10, 5e-7, 0.1),
    )


def groups(value: Any) -> Iterator[list[complex]]:
    """The arrays of nested values, and the numbers beside them."""
    if isinstance(value, (tuple, list, Iterator)):
        for part in value:
            yield from groups(part)
    else:
        yield np.ravel(value).tolist()


def computed() -> Iterator[tuple[str, str]]:
    """Rows: a name and numbers as text, groups between bars; or the class of the refusal."""
    for rows in (profiles, media, states, contacts, paths, fits, composites):
        for name, make in rows():
            try:
                yield name, " | ".join(" ".join(map(repr, group)) for group in groups(make()))
            except mdr.MDRError as refusal:
                yield name, type(refusal).__name__


def deviation(old: str, new: str) -> float:
    """The largest, each relative to the largest number of its group."""
    if old == new:
        return 0.0
    try:
        pairs = [[np.array(group.split(), dtype=complex) for group in row.split("|")] for row in (old, new)]
        return max(apart(x, y) for x, y in zip(*pairs, strict=True))
    except ValueError:  # a refusal, or another count
        return math.inf


def apart(x: Any, y: Any) -> float:
    if x.shape != y.shape:
        return math.inf
    differ = (x != y) & ~(np.isnan(x) & np.isnan(y))
    if not differ.any():
        return 0.0
    most = float(np.max(np.abs(x - y)[differ]) / np.max(np.abs(x)[np.isfinite(x)]))
    return most if math.isfinite(most) else math.inf


def allowed(name: str) -> float:
    return next((limit for start, limit in ALLOWED.items() if name.startswith(start)), 1e-12)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--exact", action="store_true", help="bit for bit")
    parser.add_argument("--write", action="store_true", help="add rows that the file lacks")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    lines = PINS.read_text().splitlines() if PINS.exists() else []
    pinned = dict(line.split(": ") for line in lines)
    rows = dict(computed())
    faults = [f"{name}: no longer computed" for name in pinned if name not in rows]
    for name, numbers in rows.items():
        if name not in pinned:
            if not given.write:
                faults.append(f"{name}: not in the file")
            continue
        off = deviation(pinned[name], numbers)
        if (given.exact and numbers != pinned[name]) or off > allowed(name):
            faults.append(f"{name}: off by {off:.1e}")
    if given.write:
        PINS.write_text("".join(f"{name}: {pinned.get(name, numbers)}\n" for name, numbers in rows.items()))
    count = sum(len(row.split()) - row.count("|") for row in rows.values())
    print("\n".join([*faults, f"{count} numbers in {len(rows)} rows, {len(faults)} rows at fault"]))
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main())
