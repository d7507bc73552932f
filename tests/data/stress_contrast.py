# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes stress_contrast.csv: stresses under a paraboloid on one film at contrasts of 1e4 and 1e-4, to 15 digits (needs mpmath).

The line load is that of film_contrast.py. The field of each wavenumber solves six equations - free shear, pressure at the surface,
four continuities at the interface - for six amplitudes, without a sweep; sums over wavenumbers are Gauss rules in octaves.
Film of thickness 1 and shear modulus 1 on a half-space of shear modulus 1/contrast, R = 1.
"""

import sys

import mpmath as mp
from film_contrast import NODES, WEIGHTS, coefficients, spherical_bessel

CASES = [("1e4", "0.3", "0.3", "1"), ("1e-4", "0.3", "0.2", "1")]
POINTS = [("0", "0.5", 0), ("0.5", "0.3", 0), ("1.2", "0.9", 0), ("0.3", "1", 0), ("0.3", "1", 1), ("2", "1.5", 1)]
NAMES = ("u_r", "u_z", "s_rr", "s_tt", "s_zz", "s_rz")


def waves(k, z, layer, media):
    """U, W, S, T and U', W' of the solutions of one layer: two that decay from its upper face, in the film two that grow up to its
    lower one."""
    mu, nu = media[layer]
    kappa, lame = 3 - 4 * nu, 2 * mu * nu / (1 - 2 * nu)
    down = mp.exp(-k * (z - layer))
    found = [(down, down, -k * down, -k * down)]
    found.append((k * z * down, (k * z + kappa) * down, (k - k * k * z) * down, (k - k * (k * z + kappa)) * down))
    if layer == 0:
        up = mp.exp(k * (z - 1))
        found.append((up, -up, k * up, -k * up))
        found.append((-k * z * up, (k * z - kappa) * up, (-k - k * k * z) * up, (k + k * (k * z - kappa)) * up))
    return [(u, w, (lame + 2 * mu) * dw + lame * k * u, mu * (du - k * w), du, dw) for u, w, du, dw in found]


def amplitudes(k, load, media):
    top, above, below = waves(k, mp.mpf(0), 0, media), waves(k, mp.mpf(1), 0, media), waves(k, mp.mpf(1), 1, media)
    matrix, right = mp.matrix(6, 6), mp.matrix(6, 1)
    for j in range(4):
        matrix[0, j], matrix[1, j] = top[j][2] / k, top[j][3] / k
        for i in range(4):  # stresses over k: of the size of displacements
            matrix[2 + i, j] = above[j][i] / (k if i > 1 else 1)
    for j in range(2):
        for i in range(4):
            matrix[2 + i, 4 + j] = -below[j][i] / (k if i > 1 else 1)
    right[0] = -load / k
    return mp.lu_solve(matrix, right)


def fields(contrast, nu0, nu1, a):
    c, v, r, s = coefficients(contrast, nu0, nu1, a)
    contrast, nu0, nu1, a = (mp.mpf(x) for x in (contrast, nu0, nu1, a))
    depth = (a**2 - sum(x * y for x, y in zip(r, v, strict=True))) / (1 - sum(x * y for x, y in zip(r, c, strict=True)))
    loads = [2 / (1 - nu0) * a / mp.pi * (depth * c[j] - v[j]) * s[j] * (-1) ** j for j in range(len(s))]
    media = ((mp.mpf(1), nu0), (1 / contrast, nu1))
    mp.mp.dps = 80  # long waves bend the film as a plate: k^3 is lost
    totals = [[mp.mpf(0)] * 6 for _ in POINTS]
    for octave in range(-45, 8):
        pieces = max(1, int(mp.mpf(2) ** octave / 4))
        for piece in range(pieces):
            for t, w in zip(NODES, WEIGHTS, strict=True):
                k = mp.mpf(2) ** octave * (1 + (piece + t) / pieces)
                weight = w * mp.mpf(2) ** octave / pieces * k
                load = sum(x * y for x, y in zip(loads, spherical_bessel(k * a, len(s)), strict=True))
                amplitude = amplitudes(k, load, media)
                for total, point in zip(totals, POINTS, strict=True):
                    for i, value in enumerate(at(k, point, amplitude, media)):
                        total[i] += weight * value
    mp.mp.dps = 60
    return depth, totals


def at(k, point, amplitude, media):
    r, z, layer = mp.mpf(point[0]), mp.mpf(point[1]), point[2]
    mu, nu = media[layer]
    lame = 2 * mu * nu / (1 - 2 * nu)
    parts = amplitude[4:] if layer else amplitude[:4]
    u, w, s, t, _, dw = (
        sum(x * y for x, y in zip(parts, column, strict=True)) for column in zip(*waves(k, z, layer, media), strict=True)
    )
    j0, j1 = mp.besselj(0, k * r), mp.besselj(1, k * r)
    hoop = 2 * mu * u * (j1 / r if r else k / 2)
    return u * j1, w * j0, ((lame + 2 * mu) * k * u + lame * dw) * j0 - hoop, lame * (k * u + dw) * j0 + hoop, s * j0, t * j1


def main():
    out = open(sys.argv[1], "w") if len(sys.argv) > 1 else sys.stdout
    with out:
        print("contrast,nu_film,nu_base,a,depth,r,z,layer," + ",".join(NAMES), file=out)
        for case in CASES:
            depth, totals = fields(*case)
            for (r, z, layer), total in zip(POINTS, totals, strict=True):
                row = [*case, mp.nstr(depth, 18), r, z, str(layer), *(mp.nstr(x, 18) for x in total)]
                print(",".join(row), file=out, flush=True)


if __name__ == "__main__":
    main()
