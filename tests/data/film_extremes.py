# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes film_extremes.csv: a paraboloid on one or two films at the ends of what is allowed (needs gmpy2, numpy, python-flint).

Drawn log-uniformly: ratios of the shear moduli of neighbours 1e-12 to 1e12, contact radius 1e-8 to 1e4 thicknesses of the
first film, thickness of a second film 1e-6 to 1e6 of them; Poisson's ratios uniformly from -0.99 to 0.5.
The springs' equation is solved in even Legendre polynomials, as in the library. The compliance comes from harmonic potentials in
each film and what the films below reflect, in as many digits as the longest waves lose; the kernel from Legendre series of the
compliance between wave numbers, each term integrated exactly. Each case is solved twice, the first time with fewer unknowns,
nodes and digits: the table keeps the digits on which both agree, 40 at most.
The first film has thickness 1 and shear modulus 1; R = 1.
"""

import random
import sys
from typing import NamedTuple

import gmpy2
import numpy as np
from flint import arb, arb_mat, ctx
from gmpy2 import log10, mpfr, sqrt

#: in the table
DIGITS = 40
#: radius up to which the resolution is for 40 digits; the widest rows take 190 s
WIDE = 23
OCTAVES = range(-110, 7)
cosines, sines, exponentials = (np.frompyfunc(function, 1, 1) for function in (gmpy2.cos, gmpy2.sin, gmpy2.exp))


class Resolution(NamedTuple):
    """Of one solution."""

    bits: int
    #: unknowns per square root of a
    unknowns: int
    #: on each panel of wave numbers
    terms: int
    #: of the compliance, left out
    tiny: str


MORE = Resolution(360, 16, 60, "1e-60"), Resolution(430, 20, 80, "1e-62")
LESS = Resolution(300, 10, 40, "1e-42"), Resolution(340, 12, 48, "1e-45")


def gauss_rule(n):
    """Nodes and weights on [-1, 1]."""
    half = [[mpfr(v.str(120, radius=False)) for v in arb.legendre_p_root(n, k, weight=True)] for k in range((n + 1) // 2)]
    nodes, weights = np.array(half).T
    return np.concatenate([nodes, -nodes[: n // 2]]), np.concatenate([weights, weights[: n // 2]])


def legendre(x, count):
    """P_0, P_1, ..., P_(count - 1) at x, one after the other."""
    below, here = 0 * x, 0 * x + 1
    for n in range(count):
        yield here
        below, here = here, ((2 * n + 1) * x * here - n * below) / (n + 1)


def spherical_bessel(x, count):
    """j_0, j_1, ..., j_(count - 1) at each x > 0: by the recurrence from below, or from far above (Miller) where x < count."""
    j0 = sines(x) / x
    j1 = (j0 - cosines(x)) / x
    values = np.array([j0, j1, *[0 * x] * (count - 2)])
    large = x >= count
    for n in range(2, count):
        values[n, large] = (2 * n - 1) / x[large] * values[n - 1, large] - values[n - 2, large]
    x, j0, j1 = x[~large], j0[~large], j1[~large]
    above, here = 0 * x, 0 * x + 1
    down = values[:, ~large]
    for n in range(count + 20 + 3 * int(max(x, default=0)), 0, -1):
        above, here = here, (2 * n + 1) / x * here - above
        if n <= count:
            down[n - 1] = here
    values[:, ~large] = down * np.where(abs(j0) > abs(j1), j0 / down[0], j1 / down[1])
    return values


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
        e = exponentials(-k * h)
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


def panels(function, low, high, rule, tiny):
    """(middle, half width, Legendre coefficients) of the panels on which the last of these are tiny."""
    middle, half = (low + high) / 2, (high - low) / 2
    nodes, weights = rule
    values = weights * function(middle + half * nodes)
    series = [(j + mpfr(0.5)) * values.dot(p) for j, p in enumerate(legendre(nodes, len(nodes)))]
    least = tiny * max(mpfr("1e-5"), *map(abs, series))
    if max(map(abs, series[-4:])) < least:
        return [(middle, half, [c for j, c in enumerate(series) if j < 2 or max(map(abs, series[j:])) > least / 1000])]
    return panels(function, low, middle, rule, tiny) + panels(function, middle, high, rule, tiny)


def kernel(y, compliance, resolution):
    """Integral of compliance(k) cos(k y) over all k > 0, from Legendre series on panels of k."""
    rule, tiny, two = gauss_rule(resolution.terms), mpfr(resolution.tiny), mpfr(2)
    found = 0 * y + two ** OCTAVES[0] * compliance(two ** OCTAVES[0])
    for octave in OCTAVES:
        for middle, half, series in panels(compliance, two**octave, two ** (octave + 1), rule, tiny):
            bessel = spherical_bessel(half * y, len(series))
            terms = [(-1) ** (j // 2) * c * bessel[j] for j, c in enumerate(series)]
            found = found + 2 * half * (cosines(middle * y) * sum(terms[::2]) - sines(middle * y) * sum(terms[1::2]))
    return found


def moments(edge, n):
    """Integrals M_kl of P_k(x) P_l(t) X(a |x - t|) over the square, by parts: for l = 2j, k = 2j, 2j + 2, ..., 2n - 2.

    They need those of P_k(u) X(a (1 + u)), k < 4n.
    """
    steps = np.concatenate([edge[:1], edge[:-2]]) - edge[1:]
    before = 2 * steps[::2] / np.arange(1, 8 * n, 4)
    here = -(2 * steps[1::2] + before[1:] - before[:-1]) / np.arange(3, 8 * n - 1, 4)
    columns = [before[:n]]
    for degree in range(1, 2 * n - 2):
        above = before[1 : len(here)] + (2 * degree + 1) * (here[:-1] - here[1:]) / (2 * degree + 3 + 4 * np.arange(len(here) - 1))
        before, here = here, above
        if degree % 2:
            columns.append(here[: n - len(columns)])
    return columns


def solve(shear, nu, second, a, resolution):
    """(E_eff/E0*, q_1 at the edge, d, F/E0*)."""
    gmpy2.get_context().precision = ctx.prec = resolution.bits
    shear, nu = [mpfr(g) for g in shear], [mpfr(n) for n in nu]
    thickness, a = [mpfr(1), mpfr(second)][: len(shear) - 1], mpfr(a)
    n = resolution.unknowns + int(resolution.unknowns * sqrt(a))
    u, w = gauss_rule(3 * n)
    w = w * kernel(a * (1 + u), lambda k: chi(k, shear, nu, thickness), resolution)
    edge = np.array([w.dot(p) for p in legendre(u, 4 * n)])
    s = np.array([sqrt(mpfr(4 * j + 1) / 2) for j in range(n)])
    r = a / gmpy2.const_pi() * s * edge[: 2 * n : 2]
    one, g = 0 * s, 0 * s
    one[0] = sqrt(mpfr(2))
    g[0], g[1] = 2 * s[0] * a**2 / 3, 2 * s[1] * a**2 * 2 / 15
    matrix = np.array([[one[0]] * n] * n)
    for j, column in enumerate(moments(edge, n)):
        matrix[j, j:] = matrix[j:, j] = a / gmpy2.const_pi() * s[j] * s[j:] * column
        matrix[j, j] += 1
    c, v = solution(matrix, np.array([one, g]).T).T
    at_edge = 1 - r.dot(c)
    depth = (a**2 - r.dot(v)) / at_edge
    return c[0] / one[0], at_edge, depth, a * one[0] * (depth * c[0] - v[0])


def solution(matrix, right):
    """Of matrix x = right."""

    def exact(v):
        mantissa, exponent = v.as_mantissa_exp()
        return arb((int(mantissa), int(exponent)))

    found = arb_mat(*matrix.shape, map(exact, matrix.flat)).solve(arb_mat(*right.shape, map(exact, right.flat)), algorithm="approx")
    return np.array([mpfr(v.str(120, radius=False)) for v in found.entries()]).reshape(right.shape)


def common_digits(coarse, fine):
    """The digits of fine on which both agree."""
    apart = abs(coarse - fine) / abs(fine)
    return f"{fine:.{DIGITS if apart < mpfr(10) ** -DIGITS else int(-log10(apart))}g}"


def main():
    cases = [
        *draw(20, 200, -8, 1),
        *(case for case in draw(21, 16, 1, 1.6) if float(case[3]) < WIDE),
        # but for one of the widest
        *(case for case in draw(22, 32, 1.36, 4) if float(case[3]) != 5880),
    ]
    out = open(sys.argv[1], "w") if len(sys.argv) > 1 else sys.stdout
    with out:
        print("shear_2,shear_3,nu_1,nu_2,nu_3,thickness_2,a,modulus,edge,depth,force", file=out)
        for shear, nu, second, a in cases:
            coarse, fine = MORE if float(a) < WIDE else LESS
            found = map(common_digits, solve(shear, nu, second, a, coarse), solve(shear, nu, second, a, fine))
            print(",".join([*(shear[1:] + ["0"])[:2], *(nu + ["0"])[:3], second, a, *found]), file=out, flush=True)


if __name__ == "__main__":
    main()
