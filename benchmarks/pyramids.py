# SPDX-License-Identifier: GPL-3.0-or-later
"""Pyramids, ellipsoids and punches on films against axisymmetric indenters of equal sections, by boundary elements.

python benchmarks/pyramids.py [--check N] [--seed K] [--shape NAME ...]

Without --check it computes every entry and writes python/mdrcontact/instruments/fitting/pyramids.csv (sections of pyramids)
and tests/data/pyramids.csv (others, for Poisson's ratios of 0.3): about two hours. --check computes N entries anew, also of
tests/data/pyramids_between.csv, and compares. The engine is ContactMechanics, pip install "mdrcontact[bem]".

An entry is the force at the depth of the axisymmetric indenter, whose contact radius is a. Three grids, each twice as fine as
the one before, give the extrapolated force; its error is the change from the second to the third. Grids are refined until
that is 0.25 % of the force. The axisymmetric indenter is exact, except for punches. Edges of pyramids run through the
centres of pixels.
"""

from __future__ import annotations

import argparse
import csv
import math
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from ContactMechanics.Factory import make_system
from SurfaceTopography import Topography

import mdrcontact as mdr
from mdrcontact.interop.contactmechanics import FreeLayeredSubstrate

ROOT = Path(__file__).resolve().parent.parent
PYRAMIDS = ROOT / "python" / "mdrcontact" / "instruments" / "fitting" / "pyramids.csv"
OTHERS, BETWEEN = ROOT / "tests" / "data" / "pyramids.csv", ROOT / "tests" / "data" / "pyramids_between.csv"
COLUMNS = ("shape", "contrast", "position", "a_over_h", "force", "force_error", "area", "area_error")
CONTRASTS = 10.0 ** np.arange(-2.0, 2.1, 0.5)
POSITIONS = (0.0, 0.25, 0.5, 0.75, 1.0)
RATIOS = 10.0 ** np.array([-1.0, -0.75, -0.5, -0.375, -0.25, -0.125, 0.0, 0.125, 0.25, 0.375, 0.5, 0.75, 1.0])
FEW_CONTRASTS, FEW_RATIOS, NU = (0.01, 0.1, 1.0, 10.0, 100.0), (0.1, 0.3, 1.0, 3.0, 10.0), 0.3
SLOPE = 0.01
"""Of cones, and curvature: the equations are linear, and small strains warn of nothing."""
GRIDS, ENOUGH = (48, 96, 192, 384), 2.5e-3
"""Square roots of the numbers of pixels; change of the force by the last grid that is small enough to omit the next."""
PUNCH_GRIDS = (64, 128, 256)
FINEST = 1e-4
"""Least error that is stated."""
TOLERANCE, ITERATIONS = 1e-7, 5000
Array = np.ndarray


class Shape(NamedTuple):
    """An indenter whose sections have the area of circles of the radius r at the height of `reference`."""

    height: Callable[[Array, Array], Array]
    reference: mdr.Profile
    aspect: float = 1.0
    """height over width of a pixel"""


def superellipse(power: float) -> Callable[[Array, Array], Array]:
    """Radius of the circle of equal area through a point, for sections |x|^p + |y|^p."""
    side = math.sqrt(math.pi / (4.0 * math.gamma(1.0 + 1.0 / power) ** 2 / math.gamma(1.0 + 2.0 / power)))
    return lambda x, y: ((np.abs(x) / side) ** power + (np.abs(y) / side) ** power) ** (1.0 / power)


def square(x: Array, y: Array) -> Array:
    """The same for squares."""
    return np.asarray(np.maximum(np.abs(x), np.abs(y)) * 2.0 / math.sqrt(math.pi))


def triangle(x: Array, y: Array) -> Array:
    """The same for equilateral triangles with a corner on the x axis."""
    inside = math.sqrt(math.pi / (3.0 * math.sqrt(3.0)))
    return np.asarray(np.maximum(0.5 * x + 0.5 * math.sqrt(3.0) * np.abs(y), -x) / inside)


def ellipse(curvatures: float) -> Callable[[Array, Array], Array]:
    """Half the square of that radius for ellipses, by the ratio of the curvatures."""
    root = math.sqrt(curvatures)
    return lambda x, y: 0.5 * (root * x**2 + y**2 / root)


CONE, BALL = mdr.Cone(math.atan(SLOPE)), mdr.Paraboloid(1.0 / SLOPE)
SHAPES = {
    "triangle": Shape(triangle, CONE, math.sqrt(3.0)),
    "square": Shape(square, CONE),
    "rounded square p = 8": Shape(superellipse(8.0), CONE),
    "rounded square p = 4": Shape(superellipse(4.0), CONE),
    "ellipsoid 2:1": Shape(ellipse(2.0), BALL),
    "ellipsoid 4:1": Shape(ellipse(4.0), BALL),
}
PUNCHES = {"square punch": square, "rounded punch p = 8": superellipse(8.0), "rounded punch p = 4": superellipse(4.0)}


def body_of(contrast: float, position: float) -> mdr.Layered:
    """A film of the thickness 1 on a base of the contact modulus 1; Poisson's ratios give the second Dundurs parameter."""
    aim = position * (1.0 + contrast) - 1.0
    # g = (1 - 2 nu)/(1 - nu) of both is in [0, 1], and contrast g_base - g_film = aim
    low, high = max(0.0, aim / contrast), min(1.0, (1.0 + aim) / contrast)
    base = 0.5 * (low + high)
    film = contrast * base - aim
    nu_film, nu_base = ((1.0 - g) / (2.0 - g) for g in (min(max(film, 0.0), 1.0), base))
    return mdr.Layered([(mdr.Elastic(contrast * (1.0 - nu_film**2), nu_film), 1.0)], mdr.Elastic(1.0 - nu_base**2, nu_base))


def position_of(contrast: float, nu: float) -> float:
    """Of a film and a base with equal Poisson's ratios."""
    g = (1.0 - 2.0 * nu) / (1.0 - nu)
    return (contrast * g - g + 1.0) / (1.0 + contrast)


def pressed(body: mdr.Layered, heights: Array, pixel: tuple[float, float], depth: float) -> tuple[float, Array]:
    """Force, and pixels in contact."""
    sizes = tuple(n * step for n, step in zip(heights.shape, pixel, strict=True))
    substrate = FreeLayeredSubstrate(body, heights.shape, sizes, check_boundaries=False)
    topography = Topography(-heights, sizes)
    system = make_system(interaction="hardwall", substrate=substrate, surface=topography)
    guess = substrate.first_guess(topography, depth)
    found = system.minimize_proxy(offset=depth, initial_forces=guess, pentol=TOLERANCE * depth, maxiter=ITERATIONS)
    assert found.success, found.message
    return float(system.compute_normal_force()), np.asarray(found.jac)[: heights.shape[0], : heights.shape[1]] > 0.0


class Box(NamedTuple):
    """Part of the plane around a contact."""

    left: float
    right: float
    half: float

    def grid(self, count: int, shape: Shape) -> tuple[Array, Array, tuple[float, float]]:
        """Centres of about count^2 pixels along both axes, and their sizes; the axes run through centres."""
        size = math.sqrt((self.left + self.right) * 2.0 * self.half) / count
        dx, dy = size / math.sqrt(shape.aspect), size * math.sqrt(shape.aspect)
        left, right, half = (math.ceil(a / b) for a, b in zip(self, (dx, dx, dy), strict=True))
        return np.arange(-left, right + 1) * dx, np.arange(-half, half + 1) * dy, (dx, dy)

    def around(self, x: Array, y: Array, pixel: tuple[float, float], contact: Array) -> Box:
        """This box, wider where the contact reaches its edge."""
        columns, rows = x[contact.any(1)], y[contact.any(0)]
        free = columns[0] > x[0] and columns[-1] < x[-1] and rows[-1] < y[-1]
        return self if free else Box(*(1.1 * side for side in self))


def settled(body: mdr.Layered, shape: Shape, depth: float, box: Box, count: int) -> tuple[float, float, Box, Any]:
    """Force and area on a grid that the contact fits into."""
    while True:
        x, y, pixel = box.grid(count, shape)
        heights = SLOPE * shape.height(x[:, None], y[None, :])
        force, contact = pressed(body, heights, pixel, depth)
        wider = box.around(x, y, pixel, contact)
        if wider is box:
            return force, float(contact.sum()) * pixel[0] * pixel[1], box, (x[contact.any(1)], y[contact.any(0)], pixel)
        box = wider


def on_three_grids(shape: Shape, body: mdr.Layered, ratio: float) -> list[tuple[float, float]]:
    """Force and area over those of the reference, by the three finest grids."""
    state = mdr.Contact(shape.reference, body).at_radius(ratio)
    wide = 2.0 * ratio
    *_, box, (columns, rows, pixel) = settled(body, shape, float(state.depth), Box(wide, wide, wide), 40)
    box = Box(-columns[0] + 2.0 * pixel[0], columns[-1] + 2.0 * pixel[0], rows[-1] + 2.0 * pixel[1])
    found: list[tuple[float, float]] = []
    for count in GRIDS:
        force, area, box, _ = settled(body, shape, float(state.depth), box, count)
        found.append((force / float(state.force), area / (math.pi * ratio**2)))
        if len(found) > 2 and abs(found[-1][0] - found[-2][0]) <= ENOUGH * found[-1][0]:
            break
    return found[-3:]


def punch_on_grid(radius_at: Callable[[Array, Array], Array], body: mdr.Layered, ratio: float, count: int) -> tuple[float, float]:
    """Force over that of the exact circular punch of the area of the pixels, and part of them in contact."""
    side = ratio / float(radius_at(np.array([1.0]), np.array([0.0]))[0])
    step = 2.0 * side / (count - 2)
    x = (np.arange(count) - 0.5 * (count - 1)) * step
    face = radius_at(x[:, None], x[None, :]) < ratio
    force, contact = pressed(body, np.where(face, 0.0, 1e3 * SLOPE), (step, step), SLOPE)
    circle = mdr.FlatPunch(math.sqrt(float(face.sum()) * step**2 / math.pi))
    return force / float(mdr.Contact(circle, body).at_depth(SLOPE).force), float(contact.sum()) / float(face.sum())


def punch_on_three_grids(radius_at: Callable[[Array, Array], Array], body: mdr.Layered, ratio: float) -> list[tuple[float, float]]:
    """The same over a circular punch on the same grid: stiff films lift off from the middle of both."""
    found = []
    for count in PUNCH_GRIDS:
        punch, circle = (punch_on_grid(at, body, ratio, count) for at in (radius_at, np.hypot))
        found.append((punch[0] / circle[0], punch[1] / circle[1]))
    return found


def extrapolated(values: tuple[float, ...]) -> tuple[float, float]:
    """Limit by the order that three grids show, if they show one, and its error."""
    first, second = values[1] - values[0], values[2] - values[1]
    weight = 0.3
    if first * second > 0.0:
        weight = 1.5 if abs(first) <= abs(second) else min(max(second / (first - second), 0.3), 1.5)
    return values[2] + weight * second, max(abs(second), FINEST)


def entry(name: str, contrast: float, position: float, ratio: float) -> dict[str, Any]:
    """One row of a table."""
    body = body_of(contrast, position)
    grids = punch_on_three_grids(PUNCHES[name], body, ratio) if name in PUNCHES else on_three_grids(SHAPES[name], body, ratio)
    forces, areas = zip(*grids, strict=True)
    force, error = extrapolated(forces)
    numbers = (contrast, position, ratio, force, error, areas[2], max(abs(areas[2] - areas[1]), 0.003))
    return {"shape": name, **{key: float(f"{value:.6g}") for key, value in zip(COLUMNS[1:], numbers, strict=True)}}


def entries(path: Path) -> Iterator[tuple[str, float, float, float]]:
    """What a table has entries for."""
    if path == PYRAMIDS:
        yield from ((name, c, s, a) for name in ("square", "triangle") for c in CONTRASTS for s in POSITIONS for a in RATIOS)
    else:
        names = [name for name in (*SHAPES, *PUNCHES) if name not in ("square", "triangle")]
        yield from ((name, c, position_of(c, NU), a) for name in names for c in FEW_CONTRASTS for a in FEW_RATIOS)


def write(path: Path, shapes: list[str]) -> None:
    """Computes a table."""
    chosen = [one for one in entries(path) if not shapes or one[0] in shapes]
    rows = [entry(*one) for one in chosen]
    with path.open("w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def between(row: dict[str, str]) -> dict[str, str]:
    """A row of the table that tests the interpolation, with what its body is in the others."""
    film, base = mdr.Elastic(float(row["ratio"]), float(row["nu"])), mdr.Elastic(1.0, float(row["base_nu"]))
    contrast = film.contact_modulus / base.contact_modulus
    film_g, base_g = ((1.0 - 2.0 * nu) / (1.0 - nu) for nu in (film.nu, base.nu))
    return {**row, "contrast": f"{contrast:.12g}", "position": f"{(contrast * base_g - film_g + 1.0) / (1.0 + contrast):.12g}"}


def check(count: int, seed: int, shapes: list[str]) -> int:
    """Compare random entries; the number of those that differ by more than the sum of the stated errors."""
    kept = [row for path in (PYRAMIDS, OTHERS) for row in csv.DictReader(path.open(encoding="utf-8"))]
    kept += [between(row) for row in csv.DictReader(BETWEEN.open(encoding="utf-8"))]
    chosen = random.Random(seed).sample([row for row in kept if not shapes or row["shape"] in shapes], count)
    wrong = 0
    for row in chosen:
        found = entry(row["shape"], *(float(row[key]) for key in COLUMNS[1:4]))
        words = []
        for key in ("force", "area"):
            difference, error = found[key] - float(row[key]), found[f"{key}_error"] + float(row[f"{key}_error"])
            wrong += abs(difference) > error
            words.append(f"{key} {found[key]:.5f} ({difference:+.5f}, error {error:.5f})")
        print(*(row[key] for key in COLUMNS[:4]), *words, flush=True)
    return wrong


def main() -> int:
    """Writes or checks both tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", type=int, metavar="N", default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shape", nargs="*", default=[])
    arguments = parser.parse_args()
    if arguments.check:
        return int(check(arguments.check, arguments.seed, arguments.shape) > 0)
    for path in (PYRAMIDS, OTHERS):
        write(path, arguments.shape)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
