# SPDX-License-Identifier: GPL-3.0-or-later
"""JAX: a column of coated balls under its weight; the energy is a function, its gradient the forces, its Hessian Newton's matrix.

Checks: Newton's method with JAX's derivatives ends where each contact carries the weight above it; the stiffness of the column,
by the Hessian, is that of the springs dF/dd in series.
SI units. Balls of 5 mm, 10 g each, painted as in chain_numba.py.
"""

import jax
import jax.numpy as jnp
import numpy as np

import mdrcontact as mdr
from mdrcontact import interop

jax.config.update("jax_enable_x64", True)
RADIUS, WEIGHT, COUNT = 5e-3, 0.01 * 9.81, 20
PAINTED = mdr.Coated(mdr.Elastic(3e9, 0.4), 40e-6, mdr.Elastic(210e9 / 2, 0.3), "exact")
LAW = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(RADIUS / 2), PAINTED), 20e-6)
contact_energy = interop.jax_function(LAW, "energy")


def energy(u):
    """Of the contacts and of the weight, for balls that have gone down by u; the lowest lies on a fixed one."""
    return contact_energy(u - jnp.append(u[1:], 0.0)).sum() - WEIGHT * u.sum()


def main():
    gradient, hessian = jax.jit(jax.grad(energy)), jax.jit(jax.hessian(energy))
    u = jnp.asarray(2e-6 * np.arange(COUNT, 0, -1))
    step, iterations = u, 0
    while jnp.abs(step).max() > 1e-15 and iterations < 30:
        step = jnp.linalg.solve(hessian(u), gradient(u))
        u, iterations = u - step, iterations + 1
    depth = np.asarray(u - jnp.append(u[1:], 0.0))
    carried = WEIGHT * np.arange(1, COUNT + 1)
    error = np.abs(LAW.force(depth) / carried - 1).max()
    compliance = float(jnp.linalg.inv(hessian(u))[0, 0])
    series = (1 / LAW.at_depth(depth).slope).sum()
    print(f"{iterations} iterations, the top has gone down by {float(u[0]) * 1e6:.3f} um")
    print(f"largest relative error of a force {error:.1e}, of the column's compliance {abs(compliance / series - 1):.1e}")
    assert error < 1e-8 and abs(compliance / series - 1) < 1e-5


if __name__ == "__main__":
    main()
