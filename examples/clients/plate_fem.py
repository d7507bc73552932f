# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit finite elements: coated bumps press on a steel plate, each a contact element with the law's force and tangent.

The plate (scikit-fem, Kirchhoff, Bogner-Fox-Schmit elements, simply supported, 40 mm x 40 mm x 1 mm) bends under a stamp with five
bumps, steel balls of 2 mm radius in 20 um of polymer. Each bump is one element: its depth d = stamp - height - w is what the stamp
has approached since first touch less the plate's deflection; its force F(d) pushes the plate, and dF/dd goes into the tangent.
A plate theory knows bending only, so nothing is counted twice: the law holds all of the local indentation. (A solid mesh has an
indentation of its own under a nodal force, which depends on the mesh: there, spread the force over more than the contact and take
the depth from the surface away from it.)

Checks: Newton's iterations are quadratic; the forces agree with those from Navier's series for the plate.
SI units. Steel E = 210 GPa, nu = 0.3, polymer E = 4 GPa, nu = 0.35 (handbook values).
"""

import numpy as np
from scipy.optimize import root
from scipy.sparse import coo_matrix
from skfem import Basis, BilinearForm, ElementQuadBFS, MeshQuad, condense, solve
from skfem.helpers import dd, ddot, eye, trace

import mdrcontact as mdr

SIDE, THICKNESS = 40e-3, 1e-3
STEEL, POLYMER = mdr.Elastic(210e9, 0.3), mdr.Elastic(4e9, 0.35)
STIFFNESS = STEEL.E * THICKNESS**3 / (12 * (1 - STEEL.nu**2))  # bending, N m
PLACES = SIDE * np.array([[0.5, 0.375, 0.625, 0.375, 0.625], [0.5, 0.375, 0.375, 0.625, 0.625]])
HEIGHTS = np.array([0.0, 2e-6, 2e-6, 3e-6, 3e-6])  # by which the stamp must approach before the bump touches
ROUNDING = 1e-11  # of a residual


def coated_bump():
    """The law of one bump: a steel ball and its coating are one body, the plate's surface the other."""
    bump = mdr.Pair(mdr.Homogeneous(STEEL), mdr.Coated(POLYMER, 20e-6, STEEL))
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(2e-3), bump), largest_depth=20e-6)


def plate(cells):
    """Stiffness matrix, the unknowns that are 0 on the supports, and those under the bumps: the deflections of the nodes there."""
    line = np.linspace(0.0, SIDE, cells + 1)
    mesh = MeshQuad.init_tensor(line, line)
    basis = Basis(mesh, ElementQuadBFS())

    @BilinearForm
    def bending(w, v, _):
        curvature, nu = dd(w), STEEL.nu
        return STIFFNESS * ddot((1 - nu) * curvature + nu * eye(trace(curvature), 2), dd(v))

    nodes = [int(np.argmin(np.hypot(*(mesh.p - place[:, None])))) for place in PLACES.T]
    assert np.allclose(mesh.p[:, nodes], PLACES)
    deflection, slope_x, slope_y, _ = basis.nodal_dofs
    x, y = mesh.p / SIDE
    on_x, on_y = (x == 0) | (x == 1), (y == 0) | (y == 1)
    supported = np.concatenate([deflection[on_x | on_y], slope_y[on_x], slope_x[on_y]])
    return bending.assemble(basis), supported, deflection[nodes]


def newton(w, stamp, law, K, supported, dofs):
    """Equilibrium K w = F(stamp - height - w): w, F, and the residual's norm after each iteration."""
    free = np.setdiff1d(np.arange(len(w)), supported)
    norms = []
    for _ in range(20):
        state = law.at_depth(stamp - HEIGHTS - w[dofs])  # 0 where a bump does not touch
        residual = K @ w
        residual[dofs] -= state.force
        norms.append(np.linalg.norm(residual[free]) / max(np.linalg.norm(state.force), 1e-30))
        if norms[-1] < ROUNDING:
            return w, state.force, norms
        tangent = K + coo_matrix((state.slope, (dofs, dofs)), K.shape).tocsr()
        w = w - solve(*condense(tangent, residual, D=supported))
    raise RuntimeError(f"Newton's method did not converge: {norms}")


def navier(places, terms=400):
    """Deflection at each place under a unit force at each other one, Navier's series (Timoshenko, Theory of Plates, eq. 133)."""
    m = np.arange(1, terms + 1)
    x, y = (np.sin(np.pi * np.outer(coordinate / SIDE, m)) for coordinate in places)
    factor = 4 * SIDE**2 / (np.pi**4 * STIFFNESS * (m[:, None] ** 2 + m**2) ** 2)
    return np.einsum("im,in,jm,jn,mn->ij", x, y, x, y, factor, optimize=True)


def main():
    """See the top of this file."""
    law = coated_bump()
    K, supported, dofs = plate(cells=32)
    compliance = navier(PLACES)
    w, difference, growth = np.zeros(K.shape[0]), 0.0, 0.0
    print(f"{len(w)} unknowns\n\nstamp [um]   forces of the bumps [N]                   residual after each iteration")
    for stamp in np.array([2, 4, 8, 12, 16]) * 1e-6:
        w, force, norms = newton(w, stamp, law, K, supported, dofs)
        print(f"{stamp * 1e6:8.1f}    {' '.join(f'{F:7.3f}' for F in force)}   {' '.join(f'{norm:.0e}' for norm in norms)}")
        expected = root(lambda F, s=stamp: F - law.force(s - HEIGHTS - compliance @ F), force, tol=1e-12).x
        difference = max(difference, np.max(np.abs(force - expected)) / np.max(expected))
        near, after = np.array(norms[:-1]), np.array(norms[1:]) - ROUNDING
        growth = max(growth, np.max((after / near**2)[near < 0.1]))
    print(f"\nlargest residual over the square of the one before: {growth:.2f}")
    print(f"largest difference to the forces by Navier's series: {difference:.1e} of the largest force")
    assert growth < 2.0, "Newton's iterations are not quadratic"
    assert difference < 1e-3, "the forces are not those of the plate"


if __name__ == "__main__":
    main()
