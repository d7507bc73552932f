# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that hits a half-space at an angle: does it slide, stick, or come back?

Integrates the motion of a solid ball with the contact's own history of stick and slip, and draws the tangential velocity of
rebound against that of impact in the variables of Maw, Barber, Fawcett, Wear 38 (1976) 101: psi = 2 (1 - nu)/(mu (2 - nu)) v_t/V,
V the normal velocity of impact, chi = (1 - nu)/(2 - nu) (1 + 1/K^2), K^2 = 2/5. They found: below psi = 1 the contact sticks at
first; from psi = 4 chi - 1 on it slides to the end, and psi falls by 4 chi. Writes oblique_impact.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

NU, MU = 0.3, 0.2
RADIUS, DENSITY, SPEED = 5e-3, 7800.0, 0.1
STEPS = 300  # of an impact
SOLID = 1.0 + 5.0 / 2.0  # 1 + 1/K^2: the point of contact is moved by the ball's spin too


def rebound(friction: mdr.Friction, tangential: float) -> float:
    """Tangential velocity of the point of contact after an impact with SPEED and this tangential velocity."""
    mass = 4.0 / 3.0 * np.pi * RADIUS**3 * DENSITY
    history = friction.history()
    # Hertz's greatest depth and time of contact
    deepest = (15.0 / 16.0 * mass * SPEED**2 / float(friction.contact.medium.modulus(RADIUS)) / np.sqrt(RADIUS)) ** 0.4
    step = 2.94 * deepest / SPEED / STEPS
    depth, shift, normal, along, force, shear = 0.0, 0.0, SPEED, tangential, 0.0, 0.0
    while True:
        normal -= 0.5 * step * force / mass
        along -= 0.5 * step * SOLID * shear / mass
        depth += step * normal
        shift += step * along
        if depth <= 0.0:
            return along
        shear = float(history.advance(depth=depth, shift=shift).tangential_force)
        force = float(history.state.force)
        normal -= 0.5 * step * force / mass
        along -= 0.5 * step * SOLID * shear / mass


def main() -> None:
    """Draws the curve and compares its ends with the published ones."""
    friction = mdr.Friction(mdr.Contact(mdr.Paraboloid(RADIUS), mdr.Homogeneous(mdr.Elastic(210e9, NU))), MU)
    scale = 2.0 * (1.0 - NU) / (MU * (2.0 - NU)) / SPEED
    chi = (1.0 - NU) / (2.0 - NU) * SOLID
    before = np.linspace(0.25, 7.0, 28)
    after = np.array([scale * rebound(friction, psi / scale) for psi in before])
    slides = before > 4.0 * chi - 1.0
    fall = np.mean(before[slides] - after[slides])
    print(f"sliding from psi = {4.0 * chi - 1.0:.3f} on: psi falls by {fall:.3f}, 4 chi = {4.0 * chi:.3f}")
    print(f"lowest rebound: psi = {after.min():.3f} after {before[after.argmin()]:.2f}")
    figure, axes = plt.subplots(figsize=(6.0, 4.2), layout="constrained")
    axes.plot(before, after, "o-", markersize=3, label="history of stick and slip")
    axes.plot(before, before - 4.0 * chi, "--", color="0.6", label="sliding throughout")
    axes.axhline(0.0, color="0.6", linewidth=0.8)
    axes.set(xlabel=r"$\psi$ of impact", ylabel=r"$\psi$ of rebound", ylim=(-2.5, 2.5), title=f"solid ball, nu = {NU:g}")
    axes.legend()
    axes.grid(color="0.9")
    figure.savefig("oblique_impact.png", dpi=150)
    print("written: oblique_impact.png")


if __name__ == "__main__":
    main()
