# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip of a homogeneous body by this library and by tamaas, in one run: python tangential.py prints a table."""

import importlib.util
import time

import numpy as np

import mdrcontact as mdr

E, NU, RADIUS, DEPTH, MU, SHARE = 1.0, 0.3, 1.0, 0.01, 0.3, 0.5
BODY = mdr.Homogeneous(mdr.Elastic(E, NU))
CONTACT = mdr.Contact(mdr.Paraboloid(RADIUS), BODY)
STATE = CONTACT.at_depth(DEPTH)
MODULI = float(BODY.modulus(1.0)) / float(BODY.tangential_modulus(1.0))
FORCE, TANGENTIAL_FORCE = STATE.force, SHARE * MU * STATE.force
SHIFT = MU * MODULI * DEPTH * (1.0 - (1.0 - SHARE) ** (2.0 / 3.0))  # Cattaneo and Mindlin


def timed(function):
    """Seconds, the best of three, and the answer."""
    best, answer = np.inf, None
    for _ in range(3):
        start = time.perf_counter()
        answer = function()
        best = min(best, time.perf_counter() - start)
    return best, answer


def ours():
    """Closed springs, and the rings that coated bodies take, here on a half-space; error of the shift."""
    friction = mdr.Friction(CONTACT, MU)
    seconds, state = timed(lambda: friction.shear(STATE).at_force(TANGENTIAL_FORCE))
    yield "mdrcontact, springs", "-", state.shift / SHIFT - 1.0, seconds
    for rings in (25, 50, 100, 200):

        def by_rings(rings=rings):
            history = friction.history(largest_depth=DEPTH, rings=rings)
            history.advance(depth=DEPTH, shift=0.0)
            return history.advance(depth=DEPTH, tangential_force=TANGENTIAL_FORCE)

        seconds, state = timed(by_rings)
        yield "mdrcontact, rings, from touch on", f"{rings} rings", state.shift / SHIFT - 1.0, seconds


def normal_depth(points, force):
    """Polonsky and Keer's conjugate gradients, non-periodic: the depth under a force."""
    import tamaas as tm

    side = 4.0 * np.sqrt(RADIUS * DEPTH)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [side, side], [points, points])
    model.E, model.nu = E, NU
    tm.ModelFactory.registerNonPeriodic(model, "dcfft")
    surface = paraboloid(points, side)
    solver = tm.PolonskyKeerRey(model, surface, 1e-6)
    solver.setIntegralOperator("dcfft")
    solver.solve(force / side**2)
    displacement = np.zeros((points, points))
    model.operators["dcfft"](model.traction, displacement)
    return (displacement - surface)[model.traction > 0.0].mean()


def paraboloid(points, side):
    x = (np.arange(points) + 0.5) * side / points - side / 2.0
    return -(x[:, None] ** 2 + x[None, :] ** 2) / (2.0 * RADIUS)


def theirs():
    """The shift as the difference of two normal contacts (Ciavarella and Jaeger), which tamaas solves."""
    for points in (32, 64, 128):

        def shift(points=points):
            return MU * MODULI * (normal_depth(points, FORCE) - normal_depth(points, FORCE - TANGENTIAL_FORCE / MU))

        start = time.perf_counter()
        found = shift()
        yield "tamaas, two normal contacts", f"{points} x {points}", found / SHIFT - 1.0, time.perf_counter() - start


def condat(points, nu, share):
    """Coulomb's law with all couplings, F and T applied at once, in a periodic box of 5 a: the part of the contact's area in which
    |t| = mu p, and seconds."""
    import tamaas as tm

    side = 5.0 * STATE.radius
    model = tm.ModelFactory.createModel(tm.model_type.surface_2d, [side, side], [points, points])
    model.E, model.nu = float(BODY.modulus(1.0)) * (1.0 - nu**2), nu
    solver = tm.Condat(model, paraboloid(points, side), 1e-9, MU)
    solver.max_iter = 4000
    start = time.perf_counter()
    solver.solve([share * MU * FORCE / side**2, 0.0, FORCE / side**2])
    seconds = time.perf_counter() - start
    traction = np.array(model.traction)
    pressure, shear = traction[..., 2], np.hypot(traction[..., 0], traction[..., 1])
    inside = pressure > 1e-6 * pressure.max()
    return (shear[inside] > 0.999 * MU * pressure[inside]).mean(), seconds


def main():
    """The tables."""
    print("## Partial slip\n")
    print("Paraboloid on a homogeneous body, nu = 0.3, mu = 0.3, T = mu F/2. Error: of the shift against Cattaneo and Mindlin.\n")
    print("| code | points | error | seconds |\n|---|---|---|---|")
    rows = list(ours())
    with_tamaas = importlib.util.find_spec("tamaas") is not None
    if with_tamaas:
        import tamaas as tm

        tm.set_log_level(tm.LogLevel.error)
        rows += theirs()
    for code, points, error, seconds in rows:
        print(f"| {code} | {points} | {abs(error):.0e} | {seconds:.1e} |")
    if not with_tamaas:
        print("\ntamaas is not installed: it is not compared.")
        return
    best = min((row for row in rows if row[0].startswith("tamaas")), key=lambda row: abs(row[2]))
    enough = [row for row in rows if row[0].startswith("mdrcontact, rings") and abs(row[2]) <= abs(best[2])]
    if enough:
        code, points, _, seconds = enough[0]
        print(f"\nAt the error of tamaas' {best[1]} points or less: {points}, {best[3] / seconds:.0f} times as fast.")
    print("\nThe shift of tamaas is put together from normal contacts, as holds for homogeneous bodies only. Its own solver with")
    print("friction, Condat, takes normal and tangential force at once and couples them: the same problem for nu = 1/2 alone. Else")
    print("pressing shears the surface radially too, and the slip is that of both: another problem, with another answer.\n")
    print("| nu | T/(mu F) | part of the area that slips: Cattaneo and Mindlin | mdrcontact | tamaas, 48 x 48 on 5 a | seconds |")
    print("|---|---|---|---|---|---|")
    for nu in (0.5, 0.3):
        for share in (0.1, 0.5):
            own = mdr.Friction(CONTACT, MU).shear(STATE).at_force(share * MU * FORCE)
            part, seconds = condat(48, nu, share)
            exact, slipping = 1.0 - (1.0 - share) ** (2.0 / 3.0), 1.0 - (own.stick_radius / STATE.radius) ** 2
            print(f"| {nu} | {share} | {exact:.4f} | {slipping:.4f} | {part:.2f} | {seconds:.0f} |")


if __name__ == "__main__":
    main()
