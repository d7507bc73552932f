# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws as functions of numba, JAX and PyTorch: F(d) and U(d) inside their kernels, without a call of the library.

Each function below imports its package when it is called; docs/interop.md.
"""

from __future__ import annotations

from typing import Any

from ..law import ContactLaw
from ..plastic import PlasticLaw

__all__ = ["jax_function", "jax_plastic_function", "numba_function", "numba_plastic_function", "torch_function"]


def numba_function(law: ContactLaw, branch: str = "unloading") -> Any:
    """A function of numba that takes one depth d [length] and returns F [modulus length^2] and dF/dd [modulus length], to be called
    from compiled functions; both are NaN where the law raises. It is bitwise identical to the law.

    branch : "loading" or "unloading", as in `ContactLaw.force`
    """
    from ._numba import function

    return function(law, branch)


def jax_function(law: ContactLaw, quantity: str = "force", branch: str = "unloading") -> Any:
    """A function of JAX that takes depths of any shape and returns F [modulus length^2], or U [modulus length^3], to the precision
    of the law; NaN where the law raises. It has derivatives of any order and passes through jit, vmap, grad and hessian.

    quantity : "force" or "energy", whose gradient is F to the tolerance of the law
    branch : as in `numba_function`

    InvalidArgumentError unless JAX computes in double precision, `jax.config.update("jax_enable_x64", True)`.
    """
    from ._jax import function

    return function(law, quantity, branch)


def torch_function(law: ContactLaw, quantity: str = "force", branch: str = "unloading") -> Any:
    """A function of PyTorch for tensors of torch.float64 of any shape, on any device, with derivatives of any order."""
    from ._torch import function

    return function(law, quantity, branch)


def numba_plastic_function(law: PlasticLaw) -> Any:
    """A function of numba that takes one depth d [length] and the largest depth of the contact before it [length], at first 0, and
    returns F [modulus length^2], dF/dd [modulus length] and the largest depth after it; NaN where the law raises. The law is
    without adhesion. It is the law within 1e-11.
    """
    from ._plastic_numba import function

    return function(law)


def jax_plastic_function(law: PlasticLaw) -> Any:
    """A function of JAX that takes depths of any shape and the largest depths of the contacts before them, at first 0, and returns
    F [modulus length^2] and the largest depths after them; NaN where the law raises. The law is without adhesion. It passes through
    jit, vmap and grad.

    InvalidArgumentError unless JAX computes in double precision, `jax.config.update("jax_enable_x64", True)`.
    """
    from ._plastic_jax import function

    return function(law)
