# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic bodies, and gels whose fluid drains."""

from __future__ import annotations

import math

import numpy as np

from ..contact import Contact
from ..material import PowerLawRheology
from ..medium import Homogeneous
from ..poroelastic import Poroelastic
from ..profile import FlatPunch, Paraboloid
from .bodies import LIBRARY, RADIUS, SHEAR
from .check import Check, Comparison, comparison


def lee_radok() -> Comparison:
    """A power law pressed at a constant rate: F ~ B(3/2, 1 - alpha) t^(3/2 - alpha)."""
    alpha, rate = 0.2, 0.01
    contact = Contact(Paraboloid(RADIUS), Homogeneous(PowerLawRheology(SHEAR, 1.0, alpha, 0.5)))
    time = np.linspace(0.0, 2.0, 41)
    beta = math.gamma(1.5) * math.gamma(1.0 - alpha) / math.gamma(2.5 - alpha)
    there = 16.0 / 3.0 * SHEAR * math.sqrt(RADIUS) * rate**1.5 * 1.5 * beta * time ** (1.5 - alpha)
    return comparison("t", time, contact.history(time, depth=rate * time).force, there, float(there[-1]))


def ting() -> Comparison:
    """The same pulled back from t = 1 on: t_1 = t - 2^(1/(1 - alpha)) (t - 1), and the integral ends there."""
    alpha, rate = 0.2, 0.01
    contact = Contact(Paraboloid(RADIUS), Homogeneous(PowerLawRheology(SHEAR, 1.0, alpha, 0.5)))
    time = np.linspace(1.0, 1.6, 31)
    path = np.concatenate([np.linspace(0.0, 1.0, 21)[:-1], time])
    end = time - 2.0 ** (1.0 / (1.0 - alpha)) * (time - 1.0)
    there = (
        16.0
        / 3.0
        * SHEAR
        * math.sqrt(RADIUS)
        * rate**1.5
        * 1.5
        * np.array([_part(t, e, alpha) for t, e in zip(time, end, strict=True)])
    )
    here = np.asarray(contact.history(path, depth=rate * (1.0 - np.abs(1.0 - path))).force)[20:]
    return comparison("t", time, here, there, float(there[0]))


def _part(time: float, end: float, alpha: float) -> float:
    """int_0^end (t - u)^-alpha sqrt(u) du, by u = v^2 and t - u = w^(1/(1 - alpha)) where it is steep."""
    if end <= 0.0:
        return 0.0
    nodes, weights = np.polynomial.legendre.leggauss(80)
    middle = 0.5 * end
    v = 0.5 * math.sqrt(middle) * (nodes + 1.0)
    first = 0.5 * math.sqrt(middle) * float(weights @ (2.0 * v**2 * (time - v**2) ** -alpha))
    power = 1.0 - alpha
    low, high = (time - end) ** power, (time - middle) ** power
    w = low + 0.5 * (high - low) * (nodes + 1.0)
    return first + float(0.5 * (high - low) / power) * float(weights @ np.sqrt(time - w ** (1.0 / power)))


def oscillation() -> Comparison:
    """k* = 8 a G* of an incompressible body, G* = G Gamma(1 - alpha) (i omega)^alpha."""
    alpha, a = 0.2, 0.1
    contact = Contact(Paraboloid(RADIUS), Homogeneous(PowerLawRheology(SHEAR, 1.0, alpha, 0.5)))
    omega = np.geomspace(1e-3, 1e3, 13)
    there = 8.0 * a * SHEAR * math.gamma(1.0 - alpha) * (1j * omega) ** alpha
    here = np.asarray(contact.dynamic_stiffness(omega, radius=a))
    x = np.concatenate([np.log10(omega), np.log10(omega) + 7.0])
    parts = [np.concatenate([np.real(k), np.imag(k)]) for k in (here, there)]
    return comparison("log10(omega): storage, then loss", x, *parts)


def biot() -> Comparison:
    """An incompressible body initially, its drained skeleton finally: F falls from 8 G a d to 4 G a d/(1 - nu)."""
    nu = np.array([0.0, 0.3])
    early, late = [], []
    for ratio in nu:
        contact = Contact(FlatPunch(1.0), Homogeneous(Poroelastic(1.0, float(ratio), 1.0)))
        for drainage in ("surface", "indenter"):
            early.append(float(contact.relaxation(1e-8, drainage=drainage)))
            late.append(float(contact.relaxation(1e8, drainage=drainage)))
    both = np.repeat(nu, 2)
    x = np.concatenate([both, both + 0.6])
    there = np.concatenate([np.full(both.size, 8.0), 4.0 / (1.0 - both)])
    return comparison("nu: initial, then final", x, np.concatenate([early, late]), there)


def lai_hu() -> Comparison:
    """The part of the force that relaxes, on a drained half-space under an impermeable flat punch, nu = 0."""
    tau = np.geomspace(1e-3, 10.0, 33)
    contact = Contact(FlatPunch(1.0), Homogeneous(Poroelastic(1.0, 0.0, 1.0)))
    root = tau**0.25
    there = 0.242 * np.exp(-3.13 * tau) + 0.536 * np.exp(-1.71 * root**2)
    there += -0.043 * np.exp(-12.8 * np.cbrt(tau)) + 0.266 * np.exp(-0.892 * root)
    # F_0 = 8 G a d, F_inf = F_0/(2 (1 - nu))
    here = (np.asarray(contact.relaxation(tau, drainage="indenter")) - 4.0) / 4.0
    return comparison("D t/a^2", tau, here, there, 1.0)


RELAXING = (
    Check("lee-radok", "viscoelastic contact that grows", "Lee, Radok 1960", 1e-8, LIBRARY, lee_radok),
    Check("ting", "viscoelastic contact that shrinks", "Ting 1966", 1e-7, LIBRARY, ting),
    Check("oscillation", "dynamic stiffness", "Findley, Lai, Onaran 1976", 1e-8, LIBRARY, oscillation),
    Check("biot", "poroelastic gel, first and last force", "Biot 1941", 5e-4,
          "limits: next terms, sqrt(D t)/a and its inverse, at t = 1e-8 and 1e8 a^2/D", biot),
    Check("lai-hu", "poroelastic gel under a flat punch", "Lai, Hu 2017, fit of finite elements", 2e-3,
          "fit with four terms", lai_hu),
)  # fmt: skip
