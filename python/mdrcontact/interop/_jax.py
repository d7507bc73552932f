# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws as functions of JAX."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp

from ..errors import InvalidArgumentError
from ..law import ContactLaw
from ._generic import Branch


def function(law: ContactLaw, quantity: str, branch: str) -> Any:
    """See `jax_function`."""
    if not jax.config.jax_enable_x64:
        raise InvalidArgumentError(
            "JAX computes in single precision: call jax.config.update('jax_enable_x64', True) before anything else of JAX"
        )
    evaluate = Branch(law, quantity, branch, jnp, jnp.asarray, jax.lax.stop_gradient)
    return lambda d: evaluate(jnp.asarray(d, dtype=jnp.float64))
