# SPDX-License-Identifier: GPL-3.0-or-later
"""The homogeneous half-space (theory 2)."""

from __future__ import annotations

from dataclasses import dataclass

from .. import _native
from ..errors import ArgumentTypeError
from ..material import Elastic
from .base import Medium


def elastic(name: str, value: object) -> Elastic:
    """`value` if it is an elastic material; an exception if it is anything else."""
    if not isinstance(value, Elastic):
        raise ArgumentTypeError(f"{name} = {value!r} is not allowed: it must be an Elastic(E, nu)")
    return value


@dataclass(frozen=True)
class Homogeneous(Medium):
    """A homogeneous half-space.

    material : the half-space, Elastic(E, nu)
    indenter : material of the indenter; None for a rigid one. Both bodies then act as one with 1/E* = 1/E*_1 + 1/E*_2, which is
        exact for two homogeneous bodies and for them only: that is why other media do not have this argument
    """

    material: Elastic
    indenter: Elastic | None = None

    def __post_init__(self) -> None:
        material = elastic("material", self.material)
        if self.indenter is None:
            created = _native.medium_homogeneous(material.E, material.nu)
        else:
            stars = material.contact_modulus, elastic("indenter", self.indenter).contact_modulus
            created = _native.medium_contact_modulus(1.0 / (1.0 / stars[0] + 1.0 / stars[1]))
        self._own(created)
