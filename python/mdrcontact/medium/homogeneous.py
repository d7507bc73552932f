# SPDX-License-Identifier: GPL-3.0-or-later
"""The homogeneous half-space (theory 2)."""

from __future__ import annotations

from dataclasses import dataclass

from .. import _native
from ..errors import ArgumentTypeError
from ..material import Elastic, Material, material
from .base import Medium
from .viscoelastic import is_elastic, viscoelastic


def elastic(name: str, value: object) -> Elastic:
    """`value` if it is an elastic material; an exception if it is anything else."""
    if not isinstance(value, Elastic):
        raise ArgumentTypeError(f"{name} = {value!r} is not allowed: it must be an Elastic(E, nu)")
    return value


@dataclass(frozen=True)
class Homogeneous(Medium):
    """A homogeneous half-space of one material: Elastic(E, nu), Viscoelastic(...) or PowerLawRheology(...). The indenter is rigid;
    for a deformable one see `Pair`. A contact with a viscoelastic body answers `history` only.
    """

    material: Material

    def __post_init__(self) -> None:
        body = material("material", self.material)
        self._own(_native.medium_homogeneous(body.E, body.nu) if is_elastic(body) else viscoelastic([], [], body))
