# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes conduction_contrast.csv: conductance of a spot on one film, to 20 digits, at contrasts from 1e-6 to 1e6 (needs mpmath).

Nothing is shared with the library but theory/conduction.md (1.4), (2.1), (2.2): the equation on the line in even Legendre
polynomials is assembled in k space from spherical Bessel functions and the closed compliance of a film, in 32 digits.
Film of thickness 1 and conductivity 1 on a half-space of conductivity 1/contrast.
"""

import mpmath as mp

mp.mp.dps = 32
DIGITS = 20
NODES, WEIGHTS = map(list, mp.gauss_quadrature(24, "legendre01"))


def spherical_bessel(x, count):
    """j_0, j_2, ..., j_(2 count - 2) at x: Miller's recurrence from above, normalised by j_0 or j_1."""
    top = 2 * count + 30 + int(2 * x)
    above, here = mp.mpf(0), mp.mpf(10) ** -100
    values = {}
    for n in range(top, 0, -1):
        above, here = here, (2 * n + 1) / x * here - above
        values[n - 1] = here
    j0, j1 = mp.sin(x) / x, mp.sin(x) / x**2 - mp.cos(x) / x
    scale = j0 / values[0] if abs(j0) > abs(j1) else j1 / values[1]
    return [values[2 * j] * scale for j in range(count)]


def conductance(contrast, a):
    """G = 4 a (first coefficient of (1 + H) c = (1, 0, ...)) in polynomials orthonormal on [0, 1]."""
    contrast, a = mp.mpf(contrast), mp.mpf(a)
    reflection = (contrast - 1) / (contrast + 1)
    n = int(9 * mp.sqrt(a)) + 8
    h = mp.eye(n)
    for octave in range(-60, 7):
        pieces = max(1, int(mp.mpf(2) ** octave * a / 8))
        for piece in range(pieces):
            low = mp.mpf(2) ** octave * (1 + mp.mpf(piece) / pieces)
            length = mp.mpf(2) ** octave / pieces
            for node, weight in zip(NODES, WEIGHTS, strict=True):
                k = low + length * node
                wave = reflection * mp.exp(-2 * k)
                factor = 4 / mp.pi * a * length * weight * wave / (1 - wave)
                if abs(factor) < mp.mpf(10) ** -30:
                    continue
                b = spherical_bessel(k * a, n)
                b = [mp.sqrt(4 * j + 1) * (-1) ** j * value for j, value in enumerate(b)]
                for i in range(n):
                    for j in range(i + 1):
                        h[i, j] += factor * b[i] * b[j]
    # what lies below the lowest octave: chi = chi(0)
    h[0, 0] += 4 / mp.pi * a * mp.mpf(2) ** -60 * reflection / (1 - reflection)
    for i in range(n):
        for j in range(i):
            h[j, i] = h[i, j]
    return 4 * a * mp.lu_solve(h, mp.matrix([1] + [0] * (n - 1)))[0]


def main():
    """Writes the file."""
    print("contrast,a,G")
    for contrast in ("1e-6", "1e-3", "1e3", "1e6"):
        for a in ("0.1", "1", "10"):
            print(f"{contrast},{a},{mp.nstr(conductance(contrast, a), DIGITS)}", flush=True)


if __name__ == "__main__":
    main()
