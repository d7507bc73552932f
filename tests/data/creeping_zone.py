# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes creeping_zone.csv: the pull-off of a paraboloid from a creeping half-space that it attracts, by an integral equation.

g(x) = x^2, 1/E* = J0 + J1 (1 - exp(-t)) with J0 + J1 = 1, relaxed rest in a contact of radius a = 0.6, then d = d0 - V t. While the
contact shrinks all that happens in it is known in closed form: from J0 q + J1 z = d - g and z' = q - z follows

    z = d0 - g - V [t - J0 (1 - exp(-t/J0))],    q = d0 - g - V t - J1 V (1 - exp(-t/J0))

and so is c of q(a) = -2 sigma sqrt(c^2 - a^2). One unknown is left, a(t), of the gap at the end of the zone

    (2/pi) int_a^c [J0 q + J1 z - (d - g)]/sqrt(c^2 - x^2) dx = gamma/sigma

Here z lives on equal cells of x, linear in each, and is integrated with the root in closed form; c^2 is linear in time in a step,
so that int q dt is a power 3/2; what was printed beside the contact at the start, 2 sigma sqrt(c0^2 - x^2), takes a double
exponential rule. Second order in the cells and in the steps, which are graded towards the start.
"""

import math
from pathlib import Path

import numpy as np

J0, J1, STRESS, WORK, RADIUS = 0.1, 0.9, 0.25, 0.01, 0.6
CASES = {0.1: 2.6, 1.0: 0.08, 10.0: 6.4e-3, 100.0: 6.2e-4}
"""Speeds, and times after pull-off."""

_K = 0.055 * np.arange(-60, 61)
_DECAY = np.exp(-math.pi * np.sinh(_K))
PLACE = 1.0 / (1.0 + 1.0 / _DECAY)
PLACE_WEIGHT = 0.055 * math.pi * np.cosh(_K) / (1.0 + _DECAY) * PLACE


def known_part(a, c, d):
    """int_a^c (J0 q + x^2 - d)/sqrt(c^2 - x^2) dx."""
    angle = math.acos(a / c)
    return -2.0 * STRESS * J0 * (c - a) + 0.5 * (c**2 * angle + a * math.sqrt(c**2 - a**2)) - d * angle


def printed_part(low, c, c0):
    """int -2 sigma sqrt(c0^2 - x^2)/sqrt(c^2 - x^2) dx from low to the smaller of c and c0."""
    high = min(c, c0)
    if low >= high:
        return 0.0
    y = (high - low) * PLACE  # x = high - y
    x = high - y
    ratio = (c0 - high + y) * (c0 + x) / ((c - high + y) * (c + x))
    return -2.0 * STRESS * (high - low) * float(np.sum(PLACE_WEIGHT * np.sqrt(ratio)))


def piecewise_part(x, z, c):
    """int z/sqrt(c^2 - x^2) dx of z linear between the places x, up to c."""
    low, high = np.minimum(x[:-1], c), np.minimum(x[1:], c)
    slope = np.diff(z) / np.diff(x)

    def root(y):
        return np.sqrt((c - y) * (c + y))

    angle = np.arctan2(high, root(high)) - np.arctan2(low, root(low))
    return float(np.sum((z[:-1] - slope * x[:-1]) * angle - slope * (root(high) - root(low))))


def start():
    """d0 and c0 of the relaxed body by bisection."""
    low, high = -2.0, RADIUS**2
    for _ in range(100):
        d = 0.5 * (low + high)
        c = math.hypot(RADIUS, (d - RADIUS**2) / (2.0 * STRESS))
        gap = 2.0 / math.pi * (known_part(RADIUS, c, d) + J1 * printed_part(RADIUS, c, c))
        low, high = (d, high) if gap > WORK / STRESS else (low, d)
    return d, c


def root_integral(before, after):
    """int_0^1 sqrt(max(0, before + (after - before) s)) ds."""
    r0, r1 = np.sqrt(np.maximum(before, 0.0)), np.sqrt(np.maximum(after, 0.0))
    both = (before > 0.0) & (after > 0.0)
    total = np.where(both, before + r0 * r1 + after, 0.0) / np.where(both, r0 + r1, 1.0)
    one = (before > 0.0) != (after > 0.0)
    return (2.0 / 3.0) * np.where(one, (r0**3 + r1**3) / np.where(one, abs(after - before), 1.0), total)


class March:
    """Steps of time; `z` is the memory at the cells' ends, beyond a0 without what was printed there."""

    def __init__(self, speed, cells):
        self.speed = speed
        self.d0, self.c0 = start()
        self.x = RADIUS / cells * np.arange(int(1.2 * self.c0 / RADIUS * cells))
        self.x[cells] = RADIUS
        self.z = np.zeros_like(self.x)
        self.t, self.a, self.c = 0.0, RADIUS, self.c0

    def load_at_axis(self, t):
        return self.d0 - self.speed * (t + J1 * (1.0 - np.exp(-t / J0)))

    def memory_inside(self, x, t):
        return self.d0 - x**2 - self.speed * (t - J0 * (1.0 - np.exp(-t / J0)))

    def force(self):
        root = math.sqrt(self.c**2 - self.a**2)
        pressed = self.load_at_axis(self.t) * self.a - self.a**3 / 3.0
        return 2.0 * pressed - 2.0 * STRESS * (self.c**2 * math.acos(self.a / self.c) - self.a * root)

    def opening(self, t, a):
        """Of the gap at c less gamma/sigma; c, and the new memories with the first of their places."""
        c = math.hypot(a, (self.load_at_axis(t) - a**2) / (2.0 * STRESS))
        first = int(np.searchsorted(self.x, a, side="right"))
        x = self.x[first : np.searchsorted(self.x, max(c, self.c)) + 2]
        left = x < self.a  # the contact leaves these places in this step
        since = np.where(left, self.t + (t - self.t) * (self.a - x) / (self.a - a), self.t)
        z = np.where(left, self.memory_inside(x, since), self.z[first : first + len(x)])
        before = np.where(left, ((self.load_at_axis(since) - x**2) / (2.0 * STRESS)) ** 2, self.c**2 - x**2)
        length = t - since
        z = np.exp(-length) * z - 2.0 * STRESS * length * np.exp(-0.5 * length) * root_integral(before, c**2 - x**2)
        places, values = np.append(a, x), np.append(self.memory_inside(a, t), z)
        start_of_printed = int(np.searchsorted(places, RADIUS - 1e-12))
        inner = values[: start_of_printed + 1].copy()
        inner[-1] += math.exp(-t) * (self.d0 - RADIUS**2)
        memory = piecewise_part(places[: start_of_printed + 1], inner, c)
        memory += piecewise_part(places[start_of_printed:], values[start_of_printed:], c)
        memory += math.exp(-t) * printed_part(RADIUS, c, self.c0)
        total = known_part(a, c, self.d0 - self.speed * t) + J1 * memory
        return 2.0 / math.pi * total - WORK / STRESS, c, first, z

    def step(self, t, guess):
        """To time t; False where no smaller contact is found."""
        before, here = min(guess * (1.0 + 1e-5), self.a * (1.0 - 1e-12)), guess
        before_value = self.opening(t, before)[0]
        for _ in range(40):
            value, c, first, z = self.opening(t, here)
            if value == before_value or abs(value) < 1e-15:
                break
            there = here - value * (here - before) / (value - before_value)
            if not there > 0.0:
                return False
            before, before_value, here = here, value, min(there, self.a * (1.0 - 1e-13))
        if abs(value) > 1e-12:
            return False
        self.z[first : first + len(z)] = z
        self.t, self.a, self.c = t, here, c
        return True


def lowest_force(speed, steps, end):
    """F_min/(1.5 pi gamma R) in so many steps to a time after pull-off, by a parabola at the lowest."""
    march = March(speed, 2 * steps)
    times, forces, way = [0.0], [march.force()], 0.0
    for i in range(1, steps + 1):
        t, a = end * (i / steps) ** 2, march.a
        if not march.step(t, a - max(way, 1e-9)):
            break
        way = a - march.a
        times.append(t)
        forces.append(march.force())
    i = int(np.argmin(forces))
    assert i + 1 < len(forces), "the lowest force was not passed"
    bend, slope, value = np.polyfit(np.array(times[i - 1 : i + 2]) - times[i], forces[i - 1 : i + 2], 2)
    return (value - 0.25 * slope**2 / bend) / (1.5 * math.pi * WORK)


def extrapolated(speed, steps, end):
    """From so many steps and twice as many."""
    coarse, fine = (lowest_force(speed, n, end) for n in (steps, 2 * steps))
    return fine + (fine - coarse) / 3.0


def main():
    lines = ["speed,lowest_force,change_by_halving"]
    for speed, end in CASES.items():
        value, coarse = (extrapolated(speed, n, end) for n in (1600, 800))
        lines.append(f"{speed:g},{value:.7f},{abs(value - coarse):.1e}")
    Path(__file__).with_suffix(".csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
