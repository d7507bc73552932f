# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes film_contrast.csv: a paraboloid on one film, to 40 digits, at contrasts from 1e-12 to 1e12 (needs mpmath).

Nothing is shared with the library but the theory: the springs' equation in even Legendre polynomials is assembled in k space from
spherical Bessel functions and the closed compliance of a film (Perriot, Barthel, J. Mater. Res. 19 (2004) 600), in 60 digits.
Film of thickness 1 and shear modulus 1 on a half-space of shear modulus 1/contrast, or rigid (contrast 0); R = 1.
"""

import sys

import mpmath as mp

mp.mp.dps = 60
DIGITS = 25
CASES = [
    *[(c, nu0, nu1, a) for c in ("1e6", "1e9", "1e12") for nu0, nu1, a in (("-0.99", "0.5", "0.3"), ("0.3", "0.3", "1"))],
    *[(c, "0.3", "0.3", a) for c in ("1e3", "1e6") for a in ("0.1", "10")],
    ("1e4", "0.3", "0.3", "10"),
    ("1e12", "0.5", "0", "3"),
    *[(c, nu, "0.2", a) for c in ("1e-2", "1e-6", "1e-12") for nu in ("0.3", "0.5") for a in ("1", "10")],
    ("0", "0.5", "0.3", "1"),
    ("0", "0.5", "0.3", "10"),
    ("0", "0.3", "0.3", "10"),
]


def chi(k, contrast, nu0, nu1):
    g0, g1 = 3 - 4 * nu0, 3 - 4 * nu1
    c = (contrast * g1 - g0) / (1 + contrast * g1)
    b = (contrast - 1) / (contrast + g0)
    e = mp.exp(-2 * k)
    return (1 + 4 * b * k * e - c * b * e**2) / (1 - (c + b + 4 * b * k**2) * e + c * b * e**2) - 1


def spherical_bessel(x, count):
    """j_0, j_2, ..., j_(2 count - 2) at x: Miller's recurrence from above, normalised by j_0 or j_1."""
    top = 2 * count + 60 + int(3 * x)
    above, here = mp.mpf(0), mp.mpf(10) ** -200
    values = {}
    for n in range(top, 0, -1):
        above, here = here, (2 * n + 1) / x * here - above
        values[n - 1] = here
    j0, j1 = mp.sin(x) / x, mp.sin(x) / x**2 - mp.cos(x) / x
    scale = j0 / values[0] if abs(j0) > abs(j1) else j1 / values[1]
    return [values[2 * j] * scale for j in range(count)]


NODES, WEIGHTS = map(list, mp.gauss_quadrature(56, "legendre01"))


def coefficients(contrast, nu0, nu1, a):
    """c and v, the line loads per E0* of depth 1 and of the profile in s_j P_2j(x/a), with r and g of the edge."""
    contrast, nu0, nu1, a = (mp.mpf(v) for v in (contrast, nu0, nu1, a))
    n = int(12 * mp.sqrt(a)) + 18
    s = [mp.sqrt(mp.mpf(4 * j + 1) / 2) for j in range(n)]
    h = [[mp.mpf(0)] * n for _ in range(n)]
    r = [mp.mpf(0)] * n
    for octave in range(-60, 8):
        pieces = max(1, int(mp.mpf(2) ** octave * a / 8))
        for piece in range(pieces):
            for t, w in zip(NODES, WEIGHTS, strict=True):
                k = mp.mpf(2) ** octave * (1 + (piece + t) / pieces)
                weight = w * mp.mpf(2) ** octave / pieces * chi(k, contrast, nu0, nu1) * 2 * a / mp.pi
                if abs(weight) < mp.mpf(10) ** -70:
                    continue
                bessel = [(-1) ** j * s[j] * v for j, v in enumerate(spherical_bessel(k * a, n))]
                cosine = mp.cos(k * a)
                for i in range(n):
                    scaled = weight * bessel[i]
                    r[i] += scaled * cosine
                    for j in range(i + 1):
                        h[i][j] += 2 * scaled * bessel[j]
    # what lies below the lowest octave: chi = chi(0), j_0 = 1
    rest = chi(mp.mpf(2) ** -60, contrast, nu0, nu1) * mp.mpf(2) ** -60 * 2 * a / mp.pi
    h[0][0] += rest
    r[0] += rest * s[0]
    matrix = mp.matrix(n, n)
    for i in range(n):
        for j in range(i + 1):
            matrix[i, j] = matrix[j, i] = h[i][j] + (1 if i == j else 0)
    one, g = mp.matrix(n, 1), mp.matrix(n, 1)
    one[0] = mp.sqrt(2)
    g[0], g[1] = 2 * s[0] * a**2 / 3, 2 * s[1] * a**2 * 2 / 15
    return mp.lu_solve(matrix, one), mp.lu_solve(matrix, g), r, s


def solve(contrast, nu0, nu1, a):
    c, v, r, _ = coefficients(contrast, nu0, nu1, a)
    a, n = mp.mpf(a), len(r)
    edge = 1 - sum(r[i] * c[i] for i in range(n))
    depth = (a**2 - sum(r[i] * v[i] for i in range(n))) / edge
    return c[0] / mp.sqrt(2), edge, depth, a * mp.sqrt(2) * (depth * c[0] - v[0])


def main():
    out = open(sys.argv[1], "w") if len(sys.argv) > 1 else sys.stdout
    with out:
        print("contrast,nu_film,nu_base,a,modulus,edge,depth,force", file=out)
        for case in CASES:
            print(",".join([*case, *(mp.nstr(v, DIGITS) for v in solve(*case))]), file=out, flush=True)


if __name__ == "__main__":
    main()
