# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes film_extremes.csv: a paraboloid on one or two films at the ends of what is allowed, to 40 digits (needs gmpy2, mpmath).

Drawn log-uniformly: ratios of the shear moduli of neighbours 1e-12 to 1e12, contact radius 1e-8 to 10 thicknesses of the first
film and in some more rows 10 to WIDEST (the time grows as a^2 and more), thickness of a second film 1e-6 to 1e6 of them;
Poisson's ratios uniformly from -0.99 to 0.5. The springs' equation in even
Legendre polynomials is assembled in k space, as in film_contrast.py; the compliance comes from harmonic potentials in each film
and what the films below reflect, in as many digits as the longest waves lose.
The first film has thickness 1 and shear modulus 1; R = 1.
"""

import random
import sys

import gmpy2
import mpmath
from gmpy2 import cos, exp, log, mpfr, sin, sqrt

gmpy2.get_context().precision = 365
DIGITS = 40
PI = gmpy2.const_pi()
COUNT, WIDEST = 200, 23
OCTAVES = range(-110, 8)


with mpmath.workprec(420):
    NODES, WEIGHTS = ([mpfr(str(v)) for v in values] for values in mpmath.gauss_quadrature(40, "legendre01"))


def spherical_bessel(x, count):
    """j_0, j_2, ..., j_(2 count - 2) at x: Miller's recurrence from above, normalised by j_0 or j_1."""
    above, here = mpfr(0), mpfr("1e-200")
    values = {}
    for n in range(2 * count + 60 + int(3 * x), 0, -1):
        above, here = here, (2 * n + 1) / x * here - above
        values[n - 1] = here
    j0, j1 = sin(x) / x, sin(x) / x**2 - cos(x) / x
    scale = j0 / values[0] if abs(j0) > abs(j1) else j1 / values[1]
    return [values[2 * j] * scale for j in range(count)]


def solution(matrix, right):
    """Of a positive definite system, by Gauss's elimination without pivots."""
    n = len(right)
    a = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    for j in range(n):
        for i in range(j + 1, n):
            factor = a[i][j] / a[j][j]
            if factor:
                a[i] = [x - factor * y for x, y in zip(a[i], a[j], strict=True)]
    found = [mpfr(0)] * n
    for i in reversed(range(n)):
        found[i] = (a[i][n] - sum(a[i][j] * found[j] for j in range(i + 1, n))) / a[i][i]
    return found


def draw(seed, count, lowest, highest):
    """(shear moduli, Poisson's ratios, thickness of the second film or 0, 10^lowest < a < 10^highest), the base last, as texts."""
    chance = random.Random(seed)
    cases = []
    for i in range(count):
        films = 1 + i % 2
        shear, nu = ["1"], [f"{chance.uniform(-0.99, 0.5):.3f}" for _ in range(films + 1)]
        for _ in range(films):
            shear.append(f"{float(shear[-1]) * 10 ** chance.uniform(-12, 12):.3e}")
        second = f"{10 ** chance.uniform(-6, 6):.3e}" if films == 2 else "0"
        if chance.random() < 0.2:
            nu[chance.randrange(films + 1)] = chance.choice(["0.5", "-0.99"])
        cases.append((shear, nu, second, f"{10 ** chance.uniform(lowest, highest):.3e}"))
    return cases


def modes(k, shear, nu, z, way):
    """(U, W, S, N) at depth z for the potentials (phi, psi) exp(way k z), 2 G u = 4 (1 - nu) psi e_z - grad(phi + z psi)."""
    kappa = 3 - 4 * nu
    phi = (k / (2 * shear), -way * k / (2 * shear), way * k**2, -(k**2))
    psi = (
        k * z / (2 * shear),
        (kappa - way * z * k) / (2 * shear),
        -(1 - 2 * nu) * k + way * z * k**2,
        2 * (1 - nu) * way * k - z * k**2,
    )
    return phi, psi


def inverse(m):
    (p, q), (r, s) = m
    det = p * s - q * r
    return [[s / det, -q / det], [-r / det, p / det]]


def product(m, n):
    return [[sum(m[i][k] * n[k][j] for k in range(2)) for j in range(2)] for i in range(2)]


def parts(columns, decay=1):
    """Displacements and stresses of two modes as matrices."""
    return [[[decay * columns[j][2 * half + i] for j in range(2)] for i in range(2)] for half in range(2)]


def chi(k, shear, nu, thickness):
    u, t = parts(modes(k, shear[-1], nu[-1], mpfr(0), -1))
    compliance = product(u, inverse(t))
    for g, n, h in reversed(list(zip(shear[:-1], nu[:-1], thickness, strict=True))):
        e = exp(-k * h)
        down_u, down_t = parts(modes(k, g, n, mpfr(0), -1))
        far_u, far_t = parts(modes(k, g, n, h, -1), e)
        up_u, up_t = parts(modes(k, g, n, mpfr(0), 1))
        # what goes up is 1 in exp(k (z - h))
        deep_u, deep_t = parts(modes(k, g, n, h, 1))
        less = product(compliance, far_t), product(compliance, deep_t)
        near = [[far_u[i][j] - less[0][i][j] for j in range(2)] for i in range(2)]
        deep = [[deep_u[i][j] - less[1][i][j] for j in range(2)] for i in range(2)]
        back = product(inverse(deep), near)
        u, t = product(up_u, back), product(up_t, back)
        u = [[down_u[i][j] - e * u[i][j] for j in range(2)] for i in range(2)]
        t = [[down_t[i][j] - e * t[i][j] for j in range(2)] for i in range(2)]
        compliance = product(u, inverse(t))
    # a pressure is a stress -1
    return -compliance[1][1] * k * shear[0] / (1 - nu[0]) - 1


def solve(shear, nu, second, a):
    shear, nu = [mpfr(g) for g in shear], [mpfr(n) for n in nu]
    thickness = [mpfr(1), mpfr(second)][: len(shear) - 1]
    a = mpfr(a)
    n = int(12 * sqrt(a)) + 18
    s = [sqrt(mpfr(4 * j + 1) / 2) for j in range(n)]
    h = [[mpfr(0)] * n for _ in range(n)]
    r = [mpfr(0)] * n
    tiny = mpfr("1e-60")
    for octave in OCTAVES:
        pieces = max(1, int(mpfr(2) ** octave * a / 8))
        for piece in range(pieces):
            for t, w in zip(NODES, WEIGHTS, strict=True):
                k = mpfr(2) ** octave * (1 + (piece + t) / pieces)
                if k > 75:
                    continue
                weight = w * mpfr(2) ** octave / pieces * chi(k, shear, nu, thickness) * 2 * a / PI
                if abs(weight) < tiny:
                    continue
                # j_2j(x) < x^2j: what is left of it below 1e-60
                few = n
                if k * a < 0.5:
                    few = min(n, 2 + int(log(tiny / abs(weight)) / (2 * log(k * a))))
                bessel = [(-1) ** j * s[j] * v for j, v in enumerate(spherical_bessel(k * a, few))]
                cosine = cos(k * a)
                for i in range(few):
                    scaled = weight * bessel[i]
                    r[i] += scaled * cosine
                    scaled *= 2
                    row = h[i]
                    for j in range(i + 1):
                        row[j] += scaled * bessel[j]
    rest = chi(mpfr(2) ** OCTAVES[0], shear, nu, thickness) * mpfr(2) ** OCTAVES[0] * 2 * a / PI
    h[0][0] += rest
    r[0] += rest * s[0]
    matrix = [[h[max(i, j)][min(i, j)] + (i == j) for j in range(n)] for i in range(n)]
    one, g = [mpfr(0)] * n, [mpfr(0)] * n
    one[0] = sqrt(mpfr(2))
    g[0], g[1] = 2 * s[0] * a**2 / 3, 2 * s[1] * a**2 * 2 / 15
    c, v = solution(matrix, one), solution(matrix, g)
    edge = 1 - sum(r[i] * c[i] for i in range(n))
    depth = (a**2 - sum(r[i] * v[i] for i in range(n))) / edge
    return c[0] / one[0], edge, depth, a * one[0] * (depth * c[0] - v[0])


def main():
    out = open(sys.argv[1], "w") if len(sys.argv) > 1 else sys.stdout
    with out:
        print("shear_2,shear_3,nu_1,nu_2,nu_3,thickness_2,a,modulus,edge,depth,force", file=out)
        for shear, nu, second, a in [*draw(20, COUNT, -8, 1), *(case for case in draw(21, 16, 1, 1.6) if float(case[3]) < WIDEST)]:
            found = [f"{v:.{DIGITS}g}" for v in solve(shear, nu, second, a)]
            print(",".join([*(shear[1:] + ["0"])[:2], *(nu + ["0"])[:3], second, a, *found]), file=out, flush=True)


if __name__ == "__main__":
    main()
