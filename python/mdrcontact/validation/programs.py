# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary-element programs of others: the same contacts on a grid in the plane."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

from ..contact import Contact
from ..material import RIGID, Elastic
from ..medium import Homogeneous, Layered
from ..profile import Paraboloid, PowerLaw
from .check import Array, Check, Comparison, comparison

_GRID = 128
"""Points along a side."""
_COARSE = 64
_REPEAT = 256
"""The same where the surface repeats itself, beyond the reach of a layer."""


def _ball(r: Array) -> Array:
    """Height of `Paraboloid(1.0)`."""
    return 0.5 * r**2


def _heights(side: float, points: int, shape: Callable[[Array], Array] = _ball) -> Array:
    """Height of an indenter over the points of a grid, whose middle is its apex."""
    x = (np.arange(points) - points // 2) * side / points
    return shape(np.hypot(x[:, None], x))


def tamaas() -> Comparison:
    """Depth under a force, by conjugate gradients on a half-space that does not repeat itself: a ball and a tip of r^4."""
    module: Any = importlib.import_module("tamaas")
    module.set_log_level(module.LogLevel.error)
    here, there = [], []
    for tip, shape, radii in ((Paraboloid(1.0), _ball, (0.05, 0.1)), (PowerLaw(4.0, 1.0), lambda r: r**4, (0.1, 0.2))):
        contact = Contact(tip, Homogeneous(Elastic(1.0, 0.0)))
        for a in radii:
            state, side = contact.at_radius(a), 2.5 * a
            model = module.ModelFactory.createModel(module.model_type.basic_2d, [side, side], [_GRID, _GRID])
            model.E, model.nu = 1.0, 0.0
            module.ModelFactory.registerNonPeriodic(model, "dcfft")
            surface = -_heights(side, _GRID, shape)
            solver = module.PolonskyKeerRey(model, surface, 1e-9)
            solver.setIntegralOperator("dcfft")
            solver.solve(float(state.force) / side**2)
            u = np.zeros((_GRID, _GRID))
            model.operators["dcfft"](model.traction, u)
            here.append(float(state.depth))
            there.append(float((u - surface)[model.traction > 0].mean()))
    return comparison("ball, ball, r^4, r^4", np.arange(4.0), here, there)


def half_space() -> Comparison:
    """The force at a depth of a ball, on a half-space that does not repeat itself."""
    substrate_of: Any = importlib.import_module("ContactMechanics").FreeFFTElasticHalfSpace
    tip, depths = Paraboloid(1.0), np.array([0.01])
    there = []
    for d in depths:
        side = 4.0 * float(np.sqrt(d))
        there.append(_press(substrate_of((_COARSE, _COARSE), 1.0, (side, side)), -_heights(side, _COARSE), side, d))
    return comparison("d/R", depths, Contact(tip, Homogeneous(Elastic(1.0, 0.0))).at_depth(depths).force, there)


def layer() -> Comparison:
    """The same on a layer on a rigid base: the program's Green's function is replaced by `compliance` of the body."""
    substrate_of: Any = importlib.import_module("ContactMechanics").PeriodicFFTElasticHalfSpace
    body, tip, depths, side = Layered([(Elastic(1.0, 0.3), 0.3)], RIGID), Paraboloid(1.0), np.array([0.05, 0.1]), 4.0
    there = []
    for d in depths:
        substrate = substrate_of((_REPEAT, _REPEAT), 1.0, (side, side))
        k = 2.0 * np.pi * np.fft.fftfreq(_REPEAT, side / _REPEAT)
        k = np.hypot(*np.meshgrid(k[: _REPEAT // 2 + 1], k, indexing="ij"))
        k[0, 0] = 1e-6 * k[1, 0]  # the mean pressure compresses a layer on a rigid base
        substrate.greens_function = np.asfortranarray(body.compliance(k))
        substrate.surface_stiffness = 1.0 / substrate.greens_function
        there.append(_press(substrate, -_heights(side, _REPEAT), side, d))
    return comparison("d/R, h = 0.3 R", depths, Contact(tip, body).at_depth(depths).force, there)


def _press(substrate: Any, surface: Array, side: float, depth: float) -> float:
    """The force at a depth of the apex."""
    topography = importlib.import_module("SurfaceTopography").Topography(surface, (side, side))
    system: Any = importlib.import_module("ContactMechanics.Factory").make_system
    system = system(interaction="hardwall", substrate=substrate, surface=topography)
    system.minimize_proxy(offset=depth, pentol=1e-8)
    return float(system.compute_normal_force())


PROGRAMS = (
    Check("tamaas", "depth under a force, ball and r^4", "boundary elements (tamaas)", 2e-3,
          "grid of 128 x 128 points", tamaas, needs="tamaas"),
    Check("half-space", "force at a depth, ball", "boundary elements (ContactMechanics)", 2e-3,
          "grid of 64 x 64 points", half_space, needs="ContactMechanics"),
    Check("layer", "force at a depth, ball on a bonded layer",
          "boundary elements (ContactMechanics) with the compliance of the library", 1e-3,
          "periodic grid of 256 x 256 points", layer, is_long=True, needs="ContactMechanics"),
)  # fmt: skip
