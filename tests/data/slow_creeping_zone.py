# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes slow_creeping_zone.csv: the contact of creeping_zone.py, drawn off so slowly that creep is a small part of the history.

The same integral equation for a(t). There z lives on cells of x, and a step must be short against creep. Here q of the last 45
creep times is kept: c^2 is linear in time in a step of any length, so that int exp(-(t - s)) sqrt(c^2(s) - x^2) ds has a closed
form, and the integral over the zone takes Gauss nodes in y, x = c - (c - a) y^2, on panels that shrink towards c.
"""

import math
from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.optimize import brentq
from scipy.special import erfcx

J0, J1, WORK = 0.1, 0.9, 0.01
FORGOTTEN = 45.0
CASES = {
    (0.25, 1e-5): (0.283, 2.0, 0.0),
    (0.25, 1e-4): (0.3, 0.5, 0.0),
    (1.0, 1e-5): (0.36, 2.0, 0.0),
    (1.0, 1e-4): (0.6, 0.5, 2000.0),
}
"""Stress and speed: radius of the relaxed contact at the start, beyond which the lowest force does not depend on it, longest step,
and the time up to which steps are as long as 4."""

_NODE, _WEIGHT = np.polynomial.legendre.leggauss(12)
_PANELS = list(pairwise([0.0, 0.01, 0.03, 0.07, 0.15, 0.3, 0.5, 0.75, 1.0]))
Y = np.concatenate([a + (b - a) * (_NODE + 1.0) / 2.0 for a, b in _PANELS])
Y_WEIGHT = np.concatenate([(b - a) * _WEIGHT / 2.0 for a, b in _PANELS])


def faded_root(first, last, length):
    """int_0^h sqrt(max(0, A + (B - A) u/h)) exp(-u) du, A = first <= B = last."""
    h = np.where(length > 0.0, length, 1.0)
    slope = np.maximum((last - first) / h, 1e-300)
    begin = np.where(first < 0.0, np.minimum(-first / slope, h), 0.0)
    low, high = np.sqrt(np.maximum(first / slope + begin, 0.0)), np.sqrt(np.maximum(first / slope + h, 0.0))
    ends = np.sqrt(np.maximum(first + slope * begin, 0.0)) * np.exp(-begin) - np.sqrt(np.maximum(last, 0.0)) * np.exp(-h)
    inner = 0.5 * math.sqrt(math.pi) * (erfcx(low) * np.exp(-begin) - erfcx(high) * np.exp(-h))
    return np.where((length > 0.0) & (last > 0.0), ends + np.sqrt(slope) * inner, 0.0)


class March:
    """Times, contact radii and squares of the zone's radii."""

    def __init__(self, stress, speed, radius):
        self.stress, self.speed, self.radius = stress, speed, radius
        self.d0 = brentq(self.relaxed_gap, -2.0, radius**2 - 1e-4, xtol=1e-16)
        self.c0 = math.hypot(radius, (self.d0 - radius**2) / (2.0 * stress))
        self.t, self.a, self.c2 = np.zeros(1), np.array([radius]), np.array([self.c0**2])

    def zone(self, a, c):
        """Nodes, sqrt(c^2 - x^2) there, and weights of int ... dx/sqrt(c^2 - x^2)."""
        below = (c - a) * Y**2
        root = np.sqrt(below * (2.0 * c - below))
        return c - below, root, Y_WEIGHT * 2.0 * (c - a) * Y / root

    def relaxed_gap(self, d):
        c = math.hypot(self.radius, (d - self.radius**2) / (2.0 * self.stress))
        x, root, weight = self.zone(self.radius, c)
        return 2.0 / math.pi * np.sum(weight * (-2.0 * self.stress * root + x**2 - d)) - WORK / self.stress

    def load_at_axis(self, t):
        return self.d0 - self.speed * (t + J1 * (1.0 - np.exp(-t / J0)))

    def memory_inside(self, x, t):
        return self.d0 - x**2 - self.speed * (t - J0 * (1.0 - np.exp(-t / J0)))

    def gap(self, t, a):
        """Of the end of the zone, less gamma/sigma, and c^2."""
        c2 = a**2 + ((self.load_at_axis(t) - a**2) / (2.0 * self.stress)) ** 2
        c = math.sqrt(c2)
        x, root, weight = self.zone(a, c)
        first = max(0, int(np.searchsorted(self.t, t - FORGOTTEN)) - 1)
        times, radii = np.append(self.t, t)[first:, None], np.append(self.a, a)[first:, None]
        squares = np.append(self.c2, c2)[first:, None]
        passed = np.clip((radii[:-1] - x) / np.maximum(radii[:-1] - radii[1:], 1e-300), 0.0, 1.0)
        since = times[:-1] + np.diff(times, axis=0) * passed
        leaves = (x < radii[:-1]) & (x >= radii[1:])  # the contact leaves these places in this step
        begin = np.where(leaves, ((self.load_at_axis(since) - x**2) / (2.0 * self.stress)) ** 2, squares[:-1] - x**2)
        part = faded_root(squares[1:] - x**2, begin, times[1:] - since)
        memory = -2.0 * self.stress * np.sum(np.exp(times[1:] - t) * part, axis=0)
        memory += np.sum(np.where(leaves, np.exp(since - t) * self.memory_inside(x, since), 0.0), axis=0)
        printed = np.sqrt(np.maximum(self.c0**2 - x**2, 0.0))
        memory += np.where(x > self.radius, math.exp(-t) * -2.0 * self.stress * printed, 0.0)
        opening = -2.0 * self.stress * J0 * root + J1 * memory + x**2 - (self.d0 - self.speed * t)
        return 2.0 / math.pi * np.sum(weight * opening) - WORK / self.stress, c2

    def step(self, t):
        here = self.a[-1]
        speed = (self.a[-2] - here) / (self.t[-1] - self.t[-2]) if len(self.t) > 1 else self.speed
        way, high = 0.5 * speed * (t - self.t[-1]) + 1e-12, here * (1.0 - 1e-14)
        before = self.gap(t, high)[0]
        while self.gap(t, here - way)[0] * before > 0.0:
            way *= 1.5
        a = brentq(lambda a: self.gap(t, a)[0], here - way, high, xtol=1e-16, rtol=1e-14)
        self.c2 = np.append(self.c2, self.gap(t, a)[1])
        self.t, self.a = np.append(self.t, t), np.append(self.a, a)

    def force(self):
        """F/(1.5 pi gamma R) of the last step."""
        a, c2 = self.a[-1], self.c2[-1]
        zone = c2 * math.acos(a / math.sqrt(c2)) - a * math.sqrt(c2 - a**2)
        return (2.0 * (self.load_at_axis(self.t[-1]) * a - a**3 / 3.0) - 2.0 * self.stress * zone) / (1.5 * math.pi * WORK)


def lowest_force(stress, speed, radius, longest, coarse_until):
    """F_min/(1.5 pi gamma R), by a polynomial through 21 steps around the lowest."""
    march = March(stress, speed, radius)
    forces, t, step = [march.force()], 0.0, longest / 4.0
    while len(forces) < 60 or t < 40.0 or min(forces[-25:]) < min(forces[:-25]):
        t += step
        march.step(t)
        forces.append(march.force())
        step = min(1.2 * step, longest if t > coarse_until else max(longest, 4.0))
    i = int(np.argmin(forces))
    around = slice(max(i - 10, 0), i + 11)
    polynomial = np.polyfit(march.t[around] - march.t[i], np.array(forces)[around], 4)
    return float(np.polyval(polynomial, np.linspace(-10.0 * longest, 10.0 * longest, 2001)).min())


def main():
    lines = ["stress,speed,lowest_force,change_by_halving"]
    for (stress, speed), (radius, longest, coarse_until) in CASES.items():
        coarse, fine = (lowest_force(stress, speed, radius, part * longest, coarse_until) for part in (2.0, 1.0))
        lines.append(f"{stress:g},{speed:g},{fine + (fine - coarse) / 3.0:.7f},{abs(fine - coarse):.1e}")
    Path(__file__).with_suffix(".csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
