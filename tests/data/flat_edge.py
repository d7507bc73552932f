# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes flat_edge.csv: stresses beside the edge of a flat-ended paraboloid's end, to 18 digits (needs mpmath).

Half-space with E* = 1, f(r) = (r^2 - b^2)/2 beyond b = 1/2, contact radius 1. The pressure is a sum of those of flat punches of
radii x from b to 1, each with -q'(x) dx = g'(x) dx, and so are the stresses: Sneddon's (Int. J. Eng. Sci. 3 (1965) 47) of one
punch, integrated in s = sqrt(x - b).
"""

import mpmath as mp

B, NU = 0.5, "0.3"
OFFSETS = (-1e-3, -1e-6, -1e-12, 0.0, 1e-12, 1e-6, 1e-3)
DEPTHS = (1e-12, 1e-7, 1e-2)


def punch(r, z, beyond):
    """s_rr, s_tt, s_zz, s_rz under the line load q = 1 on [0, x], x = b + beyond; r and z in units of x from here on."""
    x, nu = B + beyond, mp.mpf(NU)
    square = ((r - B) - beyond) * (r + x) / x**2 + (z / x) ** 2  # r^2 - x^2 + z^2 without cancellation
    r, z = r / x, z / x
    root, phi, theta, far = mp.sqrt(mp.hypot(square, 2 * z)), mp.atan2(2 * z, square), mp.atan2(1, z), mp.hypot(1, z)
    j10, j20 = mp.sin(phi / 2) / root, far * mp.sin(3 * phi / 2 - theta) / root**3
    j21, j11 = r * mp.sin(3 * phi / 2) / root**3, far / r * mp.sin(theta - phi / 2) / root
    j01 = (1 - root * mp.sin(phi / 2)) / r
    s_tt = -2 * nu * j10 - ((1 - 2 * nu) * j01 - z * j11) / r
    s_zz = -j10 - z * j20
    return [value / (mp.pi * x) for value in (-2 * (1 + nu) * j10 - s_tt - s_zz, s_tt, s_zz, -z * j21)]


def rise(s):
    """g'(b + s^2) d(b + s^2)/ds."""
    root = mp.sqrt(2 * B + s**2)
    return 2 * s**2 * root + 2 * (B + s**2) ** 2 / root


def ends(r, z):
    """Panels refined towards b and towards x = r."""
    last = mp.sqrt(mp.mpf(1) - B)
    places = {mp.mpf(0), last}
    for centre in {mp.mpf(0), mp.sqrt(max(r - B, 0))}:
        step = mp.mpf("1e-13") * min(1, mp.sqrt(z))
        while step < last:
            places |= {centre - step, centre + step}
            step *= 3
        places.add(centre)
    return sorted(place for place in places if 0 <= place <= last)


def main():
    mp.mp.dps = 30
    print("r,z,s_rr,s_tt,s_zz,s_rz")
    for offset in OFFSETS:
        for depth in DEPTHS:
            r, z = mp.mpf(B * (1.0 + offset)), mp.mpf(depth)
            total = [mp.mpf(0)] * 4
            panels = ends(r, z)
            for i in range(4):
                total[i] = mp.quad(lambda s, i=i, r=r, z=z: rise(s) * punch(r, z, s**2)[i], panels, maxdegree=5)
            print(repr(B * (1.0 + offset)), repr(depth), *(mp.nstr(value, 18) for value in total), sep=",")


if __name__ == "__main__":
    main()
