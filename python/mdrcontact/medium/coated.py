# SPDX-License-Identifier: GPL-3.0-or-later
"""One coating on a half-space or on a rigid base (theory/paper.md (3.1), theory/exact.md (1.2))."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from .._boundary import number
from .._units import LENGTH
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import RIGID, Material, _Rigid, material
from ..poroelastic import NoElasticStates, Poroelastic, check_body
from .layer import Layer, stack
from .models import MODELS, UnderModel, settings
from .surface import Surface, given_surface
from .viscoelastic import is_elastic


def substrate_material(substrate: object) -> Any:
    """`substrate` if it is a material or RIGID; an exception if it is anything else."""
    if isinstance(substrate, _Rigid):
        return substrate
    if not isinstance(substrate, Material):
        words = "it must be an Elastic, TransverselyIsotropic, Viscoelastic or PowerLawRheology material, RIGID or SMOOTH"
        raise ArgumentTypeError(f"substrate = {substrate!r} is not allowed: {words}")
    return substrate


@dataclass(frozen=True, repr=False)
class Coated(UnderModel):
    """A half-space with one bonded coating; with a stress in it, or an interface that gives, see `Layered`.

    coating : Elastic(E, nu), TransverselyIsotropic(...), Viscoelastic(...) or PowerLawRheology(...); or Poroelastic(...) on a RIGID
        base, model "exact"
    thickness : h > 0 [length]
    substrate : likewise; RIGID for the models "exact", "dimitriadis", "garcia"; SMOOTH for "exact"
    model : how E_eff(a) is found; the default is the exact solution
        "gao" (12)-(15), "gao-series"           options: weight_nu = "surface" (default), "substrate", "effective" or a number
        "gao-power"                             options: exponent = -0.65, of the mean: 1 is "gao", -1 "gao-series"; weight_nu
        "doerner-nix" (11)                      options: alpha = 1
        "wave" (19), (20)                       options: wave_factor = pi/2
        "mencik-exponential", "mencik-reciprocal"   options: alpha = 1
        "bec"                                   Bec et al. 2006
        "perriot-barthel"                       Perriot, Barthel 2004
        "hay-crawford"                          Hay, Crawford 2011
        "dimitriadis", "garcia"                 incompressible layer on a rigid base, a < h, paraboloid or sphere, else refused:
                                                Dimitriadis et al. 2002, Garcia, Garcia 2018
        "exact"                                 options: tolerance = 1e-10, relative, 1e-12 to 1e-2

    surface : Surface(tension, bending) of elastic materials under the model "exact", None for a bare one

    The indenter is rigid; for a deformable one see `Pair`.
    """

    coating: Material | Poroelastic
    thickness: float = field(metadata={"dimension": LENGTH})
    substrate: Material | _Rigid
    model: str
    options: tuple[tuple[str, float | str], ...]
    surface: Surface | None

    def __init__(
        self,
        coating: Material | Poroelastic,
        thickness: float,
        substrate: Material | _Rigid,
        model: str = "exact",
        *,
        surface: Surface | None = None,
        **options: float | str,
    ) -> None:
        surface = given_surface(surface, elastic=is_elastic(coating, substrate))
        thickness, chosen = number("thickness", thickness), settings(model, options)
        if check_body(coating, substrate, model, options, RIGID):
            if not 0.0 < thickness < math.inf:
                raise InvalidArgumentError(f"thickness = {thickness!r} is not allowed: it must be finite and greater than 0")
            self._set(
                _handle=NoElasticStates(),
                coating=coating,
                thickness=thickness,
                substrate=substrate,
                model=model,
                options=(),
                surface=None,
            )
            return
        film = material("coating", coating)
        below = substrate_material(substrate)
        body = stack([Layer(film, thickness)], below, surface)
        self._own_with(body, chosen, coating=film, thickness=thickness, substrate=substrate, model=model, surface=surface)

    def _stack(self) -> tuple[Any, ...]:
        film = self.coating
        return ((film, self.thickness) if isinstance(film, Poroelastic) else Layer(film, self.thickness),)

    def _with_materials(
        self, layer: Callable[[Any], Any], substrate: Callable[[Any], Any], interface: Callable[[Any], Any] | None = None
    ) -> Coated:
        return self.replace(coating=layer(self.coating), substrate=substrate(self.substrate))

    def _with_thinner_coating(self, lost: float) -> Coated:
        return self.replace(thickness=self.thickness - lost)

    @staticmethod
    def models() -> tuple[str, ...]:
        """The names of all models."""
        return tuple(MODELS)
