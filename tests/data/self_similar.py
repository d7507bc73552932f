# SPDX-License-Identifier: GPL-3.0-or-later
"""The self-similar rows of wear.csv (delta, phi, f(0)) by their series in 40 digits, theory/wear.md (3.1)-(3.4); needs mpmath.

f = r^n, a = V s, d = delta s^n, F = phi s^(n + 1) on a homogeneous body, E* = 1: the load Q(u) = sum c_j (1 - u^2)^(mu + j),
mu = 1/2 + arctan(2 V)/pi, solves n Q - u Q' + |D| Q/(2 V) = n delta at points of |u| < 1. It converges as the fourth power of
their number; two numbers of points are extrapolated. Prints each row with its deviation over its accuracy, and ends with status 1
where one is more than 3.
"""

import csv
import sys
from pathlib import Path

import mpmath as mp

mp.mp.dps = 40
HALF = mp.mpf(1) / 2
POINTS = 24


def coefficients(n, v, mu, count):
    """c_j for delta = 1."""
    matrix = mp.matrix(count, count)
    for i in range(count):
        u = mp.sin(mp.pi / 2 * (i + HALF) / count)
        for j in range(count):
            m, w = mu + j, 1 - u**2
            of_power = 2 * mp.gamma(m + 1) / (mp.sqrt(mp.pi) * mp.gamma(m + HALF)) * mp.hyp2f1(1, HALF - m, HALF, u**2)
            matrix[i, j] = n * w**m + 2 * m * u**2 * w ** (m - 1) + of_power / (2 * v)
    return list(mp.lu_solve(matrix, mp.matrix([n] * count)))


def solved(n, v, count):
    """delta, phi, f(0)."""
    mu = HALF + mp.atan(2 * v) / mp.pi
    c = coefficients(n, v, mu, count)
    reached = 1 - sum(c[j] * mp.beta(HALF, mu + j + HALF) for j in range(count)) / mp.pi
    delta = v**n / reached
    phi = delta * v * sum(c[j] * mp.beta(HALF, mu + j + 1) for j in range(count))
    # q(0) = d - g(0), and g(0) = f(0)
    return delta, phi, delta * (1 - sum(c))


def main():
    """How many rows are off."""
    lines = Path(__file__).with_name("wear.csv").read_text(encoding="utf-8").splitlines()
    rows = [row for row in csv.DictReader(line for line in lines if not line.startswith("#")) if row["case"].startswith("self")]
    found, late = {}, 0
    for row in rows:
        n, v = int(row["case"].split("n=")[1][0]), mp.mpf(row["case"].split("V=")[1])
        if (n, v) not in found:
            once, twice = solved(n, v, POINTS), solved(n, v, 2 * POINTS)
            found[n, v] = [b + (b - a) / 15 for a, b in zip(once, twice, strict=True)]
        names = ("delta", "phi", "f(0)")
        if row["quantity"] in names:
            off = abs(found[n, v][names.index(row["quantity"])] / mp.mpf(row["value"]) - 1) / mp.mpf(row["accuracy"])
            late += off > 3
            print(row["case"], row["quantity"], mp.nstr(off, 3))
    return late


if __name__ == "__main__":
    sys.exit(main() > 0)
