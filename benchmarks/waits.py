# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person waits for, against an earlier build: CPU seconds, their ratio, wall seconds, and how much the results differ.

    tools/speed.sh keep build/before                        # before a change
    python benchmarks/waits.py build/before [ROW ...]       # after it; rows whose names contain one of the words
    python benchmarks/waits.py --threads [ROW ...]          # this build with one thread of OpenBLAS, and with nothing set

Each side runs in processes of its own, in turn; the least of some rounds counts. Imports do not count, unless a row is a command.
Numbers are compared relative to the largest of their array; "none" is bitwise identical.
"""

import argparse
import contextlib
import io
import os
import pickle
import resource
import runpy
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
PROBLEMS = ROOT / "examples" / "problems"
Numbers = dict[str, Any]
ROWS: dict[str, Callable[[], Numbers]] = {}


def row(name: str) -> Callable[[Callable[[], Numbers]], Callable[[], Numbers]]:
    """Enters a measurement: a function whose CPU seconds count, or those that it returns as "seconds"."""

    def enter(work: Callable[[], Numbers]) -> Callable[[], Numbers]:
        ROWS[name] = work
        return work

    return enter


def command(*words: str) -> Numbers:
    """Runs a command in this process, as its entry point does; its output as bytes."""
    from mdrcontact.cli import main

    shown = io.StringIO()
    with contextlib.redirect_stdout(shown):
        assert main(list(words)) in (0, None)
    return {"output": shown.getvalue()}


def section_of(name: str) -> Numbers:
    from mdrcontact import problem, studies

    found = studies.conduction(problem.load(PROBLEMS / f"{name}.toml"), section=True)
    assert found.section is not None
    return {"section": found.section.values, "conductance": found.conductance.conductance}


@row("section of temperatures: steel on DLC")
def _dlc() -> Numbers:
    return section_of("dlc_flash_temperature")


@row("section of temperatures: heat through silica")
def _silica() -> Numbers:
    return section_of("heat_through_silica")


@row("section of potentials: TiN on copper")
def _tin() -> Numbers:
    return section_of("tin_on_copper")


def heat_of(tip: Any, radius: float, **motion: Any) -> Numbers:
    """Temperatures of steel under DLC, in um."""
    import mdrcontact as mdr
    from mdrcontact.conduction import Conduction, Conductor

    steel = mdr.Elastic(210e3, 0.3, conductor=Conductor(45e-6, capacity=3.6e-12))
    body = mdr.Coated(mdr.Elastic(150e3, 0.25, conductor=Conductor(1e-6, capacity=2e-12)), 0.1, steel)
    heat = Conduction(body).friction_heat(mdr.Contact(tip, body).at_radius(radius), 0.3, 1e5, **motion)
    found = [heat.total, heat.centre, heat.flux_mean, heat.area_mean, heat.largest]
    return {"heat": [number for number in found if number is not None]}


@row("heat of friction: spinning paraboloid, a/h = 100")
def _spinning() -> Numbers:
    from mdrcontact import Paraboloid

    return heat_of(Paraboloid(1000.0), 10.0, motion="spinning")


@row("heat of friction: spinning cone, a/h = 20")
def _spinning_cone() -> Numbers:
    from mdrcontact import Cone

    return heat_of(Cone(0.1), 2.0, motion="spinning")


@row("heat of friction: moving paraboloid, Peclet number 100")
def _moving_slowly() -> Numbers:
    from mdrcontact import Paraboloid

    return heat_of(Paraboloid(1000.0), 1.0, motion="moving", source_speed=4.9e7)


@row("heat of friction: moving paraboloid, Peclet number 1000")
def _moving() -> Numbers:
    from mdrcontact import Paraboloid

    return heat_of(Paraboloid(1000.0), 1.0, motion="moving", source_speed=4.9e8)


@row("step of flux: potential of the centre, early")
def _centre() -> Numbers:
    from mdrcontact.conduction import Conduction, Conductor, LayeredConductor

    body = LayeredConductor([(Conductor(2.0, None, 1.0), 1.0)], Conductor(1.0, None, 3.0))
    return {"centre": Conduction(body).step([3e-4], 1.0, "centre_potential")}


def fit_of(name: str, **options: Any) -> Numbers:
    from mdrcontact import instruments, studies

    path = ROOT / "examples" / "fit" / f"{name}.csv"
    problem = instruments.load_fit_file(path.with_suffix(".toml"))
    found = studies.fit(problem, problem.read_data(path)[0], **options)
    ends = found.intervals or {"none": (0.0, 0.0)}
    return {"estimates": list(found.fit.values.values()), "intervals": [*ends.values()]}


@row("threads of OpenBLAS not set: gel, film in a contact area, step of conduction")
def _threads() -> Numbers:
    from mdrcontact import Contact, FlatPunch, Homogeneous, conduction, poroelastic

    body = conduction.LayeredConductor([(conduction.Conductor(2.0, None, 1.0), 1.0)], conduction.Conductor(1.0, None, 3.0))
    film = conduction.Conduction(body, film=0.3).at_radius(np.linspace(0.1, 3.0, 30))
    gel = Contact(FlatPunch(1.0), Homogeneous(poroelastic.Poroelastic(1.0, 0.3, 1.0)))
    times = np.geomspace(1e-6, 1e3, 20)
    steps = conduction.Conduction(body).step(np.geomspace(1e-3, 10.0, 20), 1.0)
    return {"film": film.conductance, "step": steps, "gel": gel.relaxation(times, drainage="indenter")}


def worn(scheme: str, intervals: int) -> Numbers:
    from mdrcontact import Coated, Contact, Elastic, Paraboloid, wear

    contact = Contact(Paraboloid(1.0), Coated(Elastic(0.91, 0.3), 1.0, Elastic(0.091, 0.3)))
    force = float(contact.at_radius(1.0).force)
    history = wear.Wear(contact, 1.0).history(force=force, scheme=scheme, intervals=intervals)
    history.advance(3.0, force=force)
    return {"radius": history.state.radius, "depth": history.state.depth}


@row("threads of OpenBLAS not set: wear, disc scheme of 80 intervals")
def _disc() -> Numbers:
    return worn("disc", 80)


@row("threads of OpenBLAS not set: wear, rings scheme of 152 intervals")
def _rings() -> Numbers:
    return worn("rings", 152)


@row("threads of OpenBLAS not set: thin film on a soft base, surface tension")
def _large() -> Numbers:
    from mdrcontact import Coated, Contact, Elastic, Homogeneous, Paraboloid, Surface

    film = Coated(Elastic(1.0, 0.3), 0.01, Elastic(0.01, 0.3))
    tense = Homogeneous(Elastic(1.0, 0.3), surface=Surface(tension=0.5))
    return {
        "film": Contact(Paraboloid(100.0), film).at_radius(np.linspace(0.1, 3.0, 20)).force,
        "tense": Contact(Paraboloid(100.0), tense).at_radius(np.geomspace(0.01, 1.0, 10)).force,
    }


@row("threads of OpenBLAS not set: 300 fits of 40 readings")
def _fits() -> Numbers:
    from mdrcontact import Elastic, Homogeneous, Paraboloid
    from mdrcontact.instruments import ForceDepth, fit

    depth, random = np.linspace(1e-9, 1e-7, 40), np.random.default_rng(0)
    start, estimates = Homogeneous(Elastic(5e10, 0.17)), []
    for _ in range(300):
        force = 2e14 * depth**1.5 * (1.0 + 0.01 * random.standard_normal(40)) * 1e-9
        estimates += list(fit(ForceDepth(depth, force), Paraboloid(1e-5), start, ["E", "depth_offset"]).values.values())
    return {"estimates": estimates}


@row("fit: Monte Carlo intervals of four parameters")
def _monte_carlo() -> Numbers:
    return fit_of("gel_in_time", interval="monte-carlo")


def gel_fit(**options: Any) -> Numbers:
    from mdrcontact import instruments, studies

    path = ROOT / "examples" / "fit" / "punch_on_hydrogel.csv"
    problem = instruments.load_fit_file(path.with_suffix(".toml"))
    found = studies.fit(problem, problem.read_data(path)[0], **options)
    return {f"{fit.drainage} {name}": value for fit in (found.fit, *found.drainages) for name, value in fit.values.items()}


@row("gel: fit of modulus, Poisson's ratio and diffusivity")
def _gel() -> Numbers:
    return gel_fit()


@row("gel: the same under each drainage")
def _drainages() -> Numbers:
    return gel_fit(compare=True)


@row("gel: 200 fits of simulated readings")
def _gels() -> Numbers:
    from mdrcontact import instruments

    path = ROOT / "examples" / "fit" / "punch_on_hydrogel.csv"
    problem = instruments.load_fit_file(path.with_suffix(".toml"))
    data, random = problem.read_data(path)[0], np.random.default_rng(0)
    tip, free = problem.indenter, [*problem.free]
    found = instruments.fit_gel(data, tip, problem.medium, free, drainage="indenter")
    sd = float(np.std(data.y - found.fitted))
    values = []
    for _ in range(200):
        same = instruments.ForceTime(data.x, data.given, found.fitted + sd * random.standard_normal(len(data)))
        values.append([*instruments.fit_gel(same, tip, problem.medium, free, drainage="indenter").values.values()])
    return dict(zip(free, np.transpose(values), strict=True))


@row("gel film: fit of modulus, Poisson's ratio and diffusivity")
def _gel_film() -> Numbers:
    from mdrcontact import RIGID, Coated, Contact, FlatPunch, instruments, poroelastic

    body = Coated(poroelastic.Poroelastic(28e3, 0.28, 3e-8), 1e-3, RIGID)
    time = np.linspace(0.0, 60.0, 50)
    path = poroelastic.history(Contact(FlatPunch(1e-3), body), time, depth=np.full(50, 5e-5), drainage="surface")
    force = path.force * (1.0 + 0.003 * np.random.default_rng(0).standard_normal(50))
    data = instruments.ForceTime(time, path.depth, force)
    found = instruments.fit_gel(data, FlatPunch(1e-3), body, ("shear_modulus", "nu", "diffusivity"), drainage="surface")
    return dict(found.values)


@row("wear: ball on a film, 100 m under a force")
def _wear() -> Numbers:
    from mdrcontact import Coated, Contact, Elastic, Sphere, wear

    body = Coated(Elastic(120e9, 0.25), 2e-6, Elastic(210e9, 0.30))
    now = wear.Wear(Contact(Sphere(3e-3), body), 1e-15).history(force=5.0).advance(100.0, force=5.0)
    return {"radius": now.radius, "depth": now.depth, "worn volume": now.worn_volume}


def zone_on_graded(ratio: float) -> Numbers:
    """A contact with a cohesive zone is made, and its first state under a force."""
    from mdrcontact import Contact, Graded, Paraboloid

    body = Graded([0.0, 1.0], [1.0, ratio], [0.3, 0.3], model="exact")
    contact = Contact(Paraboloid(1.0), body, work_of_adhesion=0.1, cohesive_stress=1.0)
    state = contact.at_force(0.1)
    return {"depth": state.depth, "radius": state.radius, "zone": state.zone_radius, "pull-off": contact.pull_off("force").force}


@row("zone contact on a graded body: E 1 to 4")
def _zone() -> Numbers:
    return zone_on_graded(4.0)


@row("zone contact on a graded body: E 1 to 50")
def _zone_of_contrast() -> Numbers:
    return zone_on_graded(50.0)


@row("command: fit of one curve, its imports included")
def _fit() -> Numbers:
    path = ROOT / "examples" / "fit" / "sphere_on_oxide.csv"
    words = ["fit", str(path), "--problem", str(path.with_suffix(".toml"))]
    return {"output": subprocess.run([sys.executable, "-P", "-m", "mdrcontact", *words], capture_output=True, check=True).stdout}


SPHERE = """
[indenter]
shape = "sphere"
radius = "10 um"
[medium]
type = "homogeneous"
material = { E = "50 GPa", nu = 0.17 }
[data]
kind = "force-depth"
[fit]
free = ["E", "depth_offset"]
"""


def fitted(name: str, *options: str) -> Numbers:
    path = ROOT / "examples" / "fit" / f"{name}.csv"
    return command("fit", str(path), "--problem", str(path.with_suffix(".toml")), *options)


@row("command: fit of a gel under each drainage")
def _each_drainage() -> Numbers:
    return fitted("punch_on_hydrogel", "--compare")


@row("command: profile intervals, viscoelastic fit")
def _profile() -> Numbers:
    return fitted("gel_in_time", "--interval", "profile")


@row("command: validate")
def _validate() -> Numbers:
    return command("validate")


@row("command: fits of a folder of 200 curves")
def _folder() -> Numbers:
    depth, random = np.linspace(1.0, 100.0, 120), np.random.default_rng(0)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("curves").mkdir()
        Path("fit.toml").write_text(SPHERE)
        for i in range(200):
            force = 0.0095 * depth**1.5 * (1.0 + 0.01 * random.standard_normal(120))
            lines = [f"{d:.5g},{f:.5g}" for d, f in zip(depth, force, strict=True)]
            Path(f"curves/{i:03}.csv").write_text("\n".join(["depth [nm],load [mN]", *lines, ""]))
        before = spent()
        found = command("fit", "curves", "--problem", "fit.toml")
        return {"output": found["output"], "seconds": spent() - before}


def sheet_of(number: int, rows: int) -> list[list[Any]]:
    """A test of a spreadsheet of an instrument: loading, hold and unloading of a sphere, eight columns."""
    share = np.interp(np.arange(rows), [0, 0.45 * rows, 0.55 * rows, rows], [0.0, 1.0, 1.0, 0.0])
    depth = (100.0 + 10.0 * number) * share
    begins = {0: "Load", int(0.45 * rows): "Hold", int(0.55 * rows): "Unload From Peak"}
    titles = ["Segment", "Displacement Into Surface", "Load On Sample", "Time On Sample", "Harmonic Contact Stiffness"]
    units = [None, "nm", "mN", "s", "N/m"]
    readings = [
        [begins.get(i, "") and f"{begins[i]} Segment Type", h, 0.0095 * h**1.5, 0.1 * i, 14250.0 * h**0.5, h, 0.0095 * h**1.5, 25.0]
        for i, h in enumerate(depth.tolist())
    ]
    return [[*titles, "Raw Displacement", "Raw Load", "Temperature"], [*units, "nm", "mN", "C"], *readings, ["END"]]


@row("command: fits of a workbook of ten tests of 3,700 readings")
def _workbook() -> Numbers:
    import openpyxl

    book = openpyxl.Workbook(write_only=True)
    for number in range(10):
        sheet = book.create_sheet(f"Test {number + 1:03}")
        for cells in sheet_of(number, 3700):
            sheet.append([None if cell == "" else cell for cell in cells])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        book.save("tests.xlsx")
        Path("fit.toml").write_text(SPHERE)
        before = spent()
        found = command("fit", "tests.xlsx", "--problem", "fit.toml")
        return {"output": found["output"], "seconds": spent() - before}


@row("command: all problems of quickstart.sh (before: a process for each command)")
def _problems() -> Numbers:
    import mdrcontact

    script = str(PROBLEMS / "run.py")
    with tempfile.TemporaryDirectory() as folder:
        if Path(mdrcontact.__file__).is_relative_to(ROOT):
            subprocess.run([sys.executable, "-P", script, folder], stdout=subprocess.DEVNULL, check=True)
        else:
            commands_of = runpy.run_path(script)["commands_of"]
            for problem in sorted(PROBLEMS.glob("*.toml")):
                for words in commands_of(problem, Path(folder)):
                    subprocess.run([sys.executable, "-P", "-m", "mdrcontact", *words], stdout=subprocess.DEVNULL, check=True)
        return {path.name: path.read_bytes() for path in sorted(Path(folder).iterdir())}


def pressed(thickness: float, layers: int = 1) -> Any:
    """A paraboloid on layers of TiN, or of TiN and a softer one in turn, on steel."""
    from mdrcontact import Contact, Elastic, Layer, Layered, Paraboloid

    stack = [Layer(Elastic(450.0, 0.25) if i % 2 == 0 else Elastic(200.0, 0.3), thickness) for i in range(layers)]
    return Contact(Paraboloid(100.0), Layered(stack, Elastic(210.0, 0.3)))


def field_of(field: Any) -> Numbers:
    return {name: getattr(field, name) for name in ("u_r", "u_z", "s_rr", "s_tt", "s_zz", "s_rz")}


def layers_inside(layers: int) -> Numbers:
    state = pressed(2.0 / layers, layers).at_radius(1.0)
    before = spent()
    field = state.interior(np.linspace(0.0, 2.0, 40)[:, None], np.linspace(0.01, 3.0, 60)[None, :])
    return {**field_of(field), "seconds": spent() - before}


@row("interior: grid of 2,400 points, 16 layers")
def _layers_16() -> Numbers:
    return layers_inside(16)


@row("interior: grid of 2,400 points, 64 layers")
def _layers_64() -> Numbers:
    return layers_inside(64)


def scattered(thickness: float) -> Numbers:
    state, random = pressed(thickness).at_radius(1.0), np.random.default_rng(1)
    r, z = 2.0 * random.random(10_000), 0.02 + 2.0 * random.random(10_000)
    before = spent()
    field = state.interior(r, z)
    return {**field_of(field), "seconds": spent() - before}


@row("interior: 10,000 scattered points, film, a/h = 1")
def _scattered() -> Numbers:
    return scattered(1.0)


@row("interior: 10,000 scattered points, thin film, a/h = 10")
def _scattered_thin() -> Numbers:
    return scattered(0.1)


def largest(thickness: float, layers: int = 1, friction: float = 0.0) -> Numbers:
    state = pressed(thickness, layers).at_radius(1.0)
    before = spent()
    found = state.critical(friction=friction)
    seconds = spent() - before
    maxima = [maximum.value for layer in found.layers for maximum in layer[:3]]
    maxima += [maximum.value for interface in found.interfaces for maximum in interface[1:]]
    return {"maxima": [*maxima, found.surface.value], "seconds": seconds}


@row("critical: film, a/h = 1")
def _critical() -> Numbers:
    return largest(1.0)


@row("critical: film, a/h = 10, sliding")
def _critical_sliding() -> Numbers:
    return largest(0.1, friction=0.3)


@row("critical: four layers")
def _critical_layers() -> Numbers:
    return largest(0.1, 4)


@row("critical: thin film, a/h = 100")
def _critical_thin() -> Numbers:
    return largest(0.01)


@row("critical: thin film, a/h = 100, sliding")
def _critical_thin_sliding() -> Numbers:
    return largest(0.01, friction=0.3)


@row("critical: thin film, a/h = 300, sliding")
def _critical_thinnest() -> Numbers:
    return largest(1.0 / 300.0, friction=0.3)


def failures(thickness: float, largest_radius: float, **strengths: Any) -> Numbers:
    contact = pressed(thickness)
    before = spent()
    found = contact.first_failure(strengths, largest_radius=largest_radius)
    seconds = spent() - before
    assert found
    return {"radii": [float(failure.state.radius) for failure in found], "seconds": seconds}


@row("first_failure: film, four strengths, a/h up to 30")
def _failure() -> Numbers:
    return failures(1.0, 30.0, von_mises=[20.0, 10.0], tension=[10.0, None], interface_shear=[4.0])


@row("first_failure: thin film, three strengths, a/h up to 300")
def _failure_thin() -> Numbers:
    return failures(0.01, 3.0, von_mises=[3.0, 2.0], interface_shear=[0.5])


@row("first_failure: thin film, substrate, a/h up to 1000")
def _failure_thinnest() -> Numbers:
    return failures(0.01, 10.0, von_mises=[None, 6.0])


STRESSED = """
[indenter]
shape = "sphere"
radius = "100 um"
[medium]
type = "coated"
coating = { E = "445 GPa", nu = 0.25, thickness = "20 nm" }
substrate = { E = "210 GPa", nu = 0.3 }
[compute]
max_depth = "40 nm"
[strength]
von_mises = ["14 GPa", "2 GPa"]
tension = ["3 GPa", "none"]
interface_shear = ["0.8 GPa"]
"""


@row("command: stress with loads at failure, thin film")
def _stress() -> Numbers:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "stress.toml"
        path.write_text(STRESSED)
        return command("stress", str(path))


def spent() -> float:
    """CPU seconds of this process and of its children."""
    mine, children = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return mine.ru_utime + mine.ru_stime + children.ru_utime + children.ru_stime


def run_one(name: str, path: str) -> None:
    """Runs a row here; CPU seconds of this process and of its children in a file, with the numbers."""
    # not what is measured
    import mdrcontact.instruments
    import mdrcontact.problem
    import mdrcontact.studies  # noqa: F401

    before, clock = spent(), time.perf_counter()
    found = ROWS[name]()
    seconds = found.pop("seconds", None) or spent() - before
    result = seconds, time.perf_counter() - clock, found
    Path(path).write_bytes(pickle.dumps(result))


def measure(name: str, packages: str, one_thread: bool) -> tuple[float, float, Numbers]:
    """CPU and wall seconds of a row with the package in a folder, and its numbers."""
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "result")
        environment = {**os.environ, "PYTHONPATH": packages}
        environment.pop("OPENBLAS_NUM_THREADS", None)
        if one_thread:
            environment["OPENBLAS_NUM_THREADS"] = "1"
        subprocess.run([sys.executable, "-P", __file__, "--one", name, path], env=environment, check=True)
        cpu, wall, found = pickle.loads(Path(path).read_bytes())
    return cpu, wall, found


def difference(old: Numbers, new: Numbers) -> str:
    """The largest relative difference of two results."""
    largest = 0.0
    for name, before in old.items():
        after = new[name]
        if isinstance(before, (str, bytes)):
            if before != after:
                return f"{name} differs"
            continue
        a, b = np.asarray(before, float), np.asarray(after, float)
        if a.shape != b.shape:
            return f"{name}: shapes {a.shape} and {b.shape}"
        if a.tobytes() == b.tobytes():
            continue
        largest = max(largest, float(np.nanmax(np.abs(a - b)) / np.nanmax(np.abs(a))))
    return f"{largest:.0e}" if largest > 0.0 else "none"


def main() -> None:
    """Prints a table of the rows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", nargs="?", help="folder with the earlier package, as tools/speed.sh keep makes it")
    parser.add_argument("words", nargs="*", help="parts of the names of rows; without them all")
    parser.add_argument("--threads", action="store_true", help="compare one thread of OpenBLAS with nothing set, in this build")
    parser.add_argument("--rounds", type=int, default=3, help="measurements of each side (default: 3)")
    arguments = parser.parse_args()
    present = str(ROOT / "python")
    words = [word for word in [arguments.before, *arguments.words] if word] if arguments.threads else arguments.words
    sides = ("of one thread", "nothing set") if arguments.threads else ("before", "now")
    titles = f"CPU seconds {sides[0]} | {sides[1]} | ratio | wall seconds {sides[0]} | {sides[1]} | difference of the results"
    print(f"| what | {titles} |\n|---|---|---|---|---|---|---|")
    for name in ROWS:
        if words and not any(word in name for word in words):
            continue
        old, new, is_set = [], [], not name.startswith("threads")
        for _ in range(arguments.rounds):
            if arguments.threads:
                old.append(measure(name, present, one_thread=True))
                new.append(measure(name, present, one_thread=False))
            else:
                old.append(measure(name, arguments.before, one_thread=is_set))
                new.append(measure(name, present, one_thread=is_set))
        least, walls = ([min(times[i] for times in side) for side in (old, new)] for i in (0, 1))
        differs = difference(old[0][2], new[0][2])
        cells = [*(f"{cpu:.3g}" for cpu in least), f"{least[1] / least[0]:.3f}", *(f"{wall:.3g}" for wall in walls)]
        print("|", " | ".join([name, *cells, differs]), "|", flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        run_one(*sys.argv[2:])
    else:
        main()
