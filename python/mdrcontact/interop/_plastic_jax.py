# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic laws as functions of JAX."""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp

from ..errors import InvalidArgumentError
from ..plastic import PlasticLaw
from ._plastic import Steps


def function(law: PlasticLaw) -> Any:
    """See `jax_plastic_function`."""
    if not jax.config.jax_enable_x64:
        raise InvalidArgumentError(
            "JAX computes in single precision: call jax.config.update('jax_enable_x64', True) before anything else of JAX"
        )
    steps = Steps(law, jnp, jnp.asarray, jax.lax.stop_gradient)
    return lambda depth, deepest: steps(jnp.asarray(depth, dtype=jnp.float64), jnp.asarray(deepest, dtype=jnp.float64))
