# SPDX-License-Identifier: GPL-3.0-or-later
"""A body that is sheared along its surface, by finite elements in one harmonic around the axis, condensed to the contact.

u_r = U cos(phi), u_phi = V sin(phi), u_z = W cos(phi); the unknowns are P = U + V, which vanishes on the axis, Q = U - V, twice the
mean of u_x around the axis, and W."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

from .check import Array

Moduli = Callable[[Array], tuple[Array, Array]]


class Sheared:
    """Nodes on r <= a, where a traction along x is put on rings."""

    def __init__(self, moduli: Moduli, r: Array, z: Array, a: float) -> None:
        fem: Any = importlib.import_module("skfem")
        self.mesh, self.a = fem.MeshQuad.init_tensor(r, z), a
        basis = fem.Basis(self.mesh, fem.ElementVector(fem.ElementQuad2(), 3), intorder=5)
        matrix = fem.BilinearForm(_energy(moduli)).assemble(basis).tocsc()
        places, part = basis.doflocs, np.zeros(basis.N, dtype=int)
        for name in ("nodal_dofs", "facet_dofs", "interior_dofs"):
            dofs = np.asarray(getattr(basis, name))
            for i in range(3):
                part[dofs[i::3].ravel()] = i
        held = (places[0] > r[-1] - 1e-9) | (places[1] > z[-1] - 1e-9) | ((places[0] < 1e-12) & (part != 1))
        contact = np.flatnonzero((places[1] < 1e-12) & (places[0] <= a * (1.0 + 1e-9)) & (part == 1))
        contact = contact[np.argsort(places[0][contact])]
        free = np.flatnonzero(~held & ~np.isin(np.arange(basis.N), contact))
        rows = matrix[free]
        solved = importlib.import_module("scipy.sparse.linalg").splu(rows[:, free]).solve(rows[:, contact].toarray())
        condensed = matrix[contact][:, contact].toarray() - matrix[contact][:, free] @ solved
        self.stiffness = 2.0 * (condensed + condensed.T)
        """forces along x on the rings, by mean displacements of them along x"""
        self.radii = places[0][contact]

    def normal_forces(self, pressure: Callable[[Array], Array]) -> Array:
        """Return the load of a pressure on each ring."""
        fem: Any = importlib.import_module("skfem")
        facets = self.mesh.facets_satisfying(lambda x: (x[1] < 1e-12) & (x[0] < self.a))
        top = fem.FacetBasis(self.mesh, fem.ElementQuad2(), facets=facets, intorder=8)

        def load(v: Any, w: Any) -> Any:
            return 2.0 * np.pi * w.x[0] * pressure(w.x[0]) * v

        forces, places = np.asarray(fem.LinearForm(load).assemble(top)), top.doflocs
        on = np.flatnonzero((places[1] < 1e-12) & (places[0] <= self.a * (1.0 + 1e-9)))
        return forces[on[np.argsort(places[0][on])]]

    def tangential_force(self, shift: float, limits: Array) -> float:
        """Of a shift of all rings, of which none supports more than its limit: the smallest energy under these bounds."""
        root = np.linalg.cholesky(np.linalg.inv(self.stiffness))
        wanted = np.linalg.solve(root, np.full(self.radii.size, shift))
        solve: Any = importlib.import_module("scipy.optimize").lsq_linear
        return float(solve(root.T, wanted, (-limits, limits), "bvls", tol=1e-13).x.sum())


def _energy(moduli: Moduli) -> Callable[[Any, Any, Any], Any]:
    def strains(u: Any, r: Any) -> tuple[Any, ...]:
        (p, w), (dp, dq, dw) = (u[0], u[2]), (u.grad[0], u.grad[1], u.grad[2])
        rr, tt, zz = 0.5 * (dp[0] + dq[0]), p / r, dw[1]
        rt, rz, tz = 0.5 * (dp[0] - dq[0]) - p / r, 0.5 * (dp[1] + dq[1]) + dw[0], 0.5 * (dp[1] - dq[1]) - w / r
        return rr, tt, zz, rt, rz, tz

    def form(u: Any, v: Any, w: Any) -> Any:
        r = w.x[0]
        lame, shear = moduli(w.x[1])
        one, other = strains(u, r), strains(v, r)
        along = sum(s * t for s, t in zip(one[:3], other[:3], strict=True))
        across = sum(s * t for s, t in zip(one[3:], other[3:], strict=True))
        return np.pi * r * (lame * sum(one[:3]) * sum(other[:3]) + 2.0 * shear * along + shear * across)

    return form
