# SPDX-License-Identifier: GPL-3.0-or-later
"""Imprint of a plastic contact: the profile that its unloading is an elastic contact of."""

from __future__ import annotations

from dataclasses import dataclass

from .._boundary import Handle, native, number
from .._value import Value
from ..errors import ArgumentTypeError
from ..medium.base import Medium


@dataclass(frozen=True)
class Imprint(Value):
    """Imprint of the pressure `uniform + hertz sqrt(1 - r^2/A^2)`."""

    body: Medium
    radius: float
    uniform: float
    hertz: float
    depth: float = 0.0

    def __init__(self, body: Medium, radius: float, uniform: float, hertz: float, depth: float = 0.0) -> None:
        if not isinstance(body, Medium):
            raise ArgumentTypeError(f"body = {body!r}: it must be a medium")
        self._set(
            body=body,
            radius=number("radius", radius),
            uniform=number("uniform", uniform),
            hertz=number("hertz", hertz),
            depth=number("depth", depth),
        )
        made = native.imprint_two_terms(body._handle, self.radius, self.uniform, self.hertz, self.depth)
        self._set(_handle=Handle(made))
