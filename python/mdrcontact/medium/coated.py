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
        raise ArgumentTypeError(f"substrate = {substrate!r}: {words}")
    return substrate


@dataclass(frozen=True, repr=False)
class Coated(UnderModel):
    """Half-space with one bonded coating, solved by a chosen model.

    Parameters
    ----------
    coating : Elastic, TransverselyIsotropic, Viscoelastic, PowerLawRheology or Poroelastic
        Material of the coating. A poroelastic coating needs a RIGID base and the model "exact".
    thickness : float
        h, thickness of the coating, > 0 [length].
    substrate : Elastic, TransverselyIsotropic, Viscoelastic, PowerLawRheology, RIGID or SMOOTH
        Material below the coating. RIGID is possible for the models "exact", "dimitriadis" and "garcia", SMOOTH for "exact".
    model : str, optional
        How E_eff(a) is computed; see Notes. The default, "exact", is the exact solution of the layered body.
    surface : Surface, optional
        Tension, plate or membrane on elastic materials under the model "exact". None, the default, is a bare surface.
    **options
        Options of the model; see Notes.

    Raises
    ------
    ArgumentTypeError
        A material or the surface is of another type.
    InvalidArgumentError
        The thickness is not finite and greater than 0, the model or an option is unknown, or the model does not support the
        substrate.

    Notes
    -----
    | model | equations or source | options and defaults |
    |---|---|---|
    | "exact" | exact solution | `tolerance` = 1e-10, relative, 1e-12 to 1e-2 |
    | "gao", "gao-series" | (12)-(15) | `weight_nu` = "surface"; also "substrate", "effective" or a number |
    | "gao-power" | mean with an exponent | `exponent` = -0.65 (1 is "gao", -1 is "gao-series"), `weight_nu` |
    | "doerner-nix" | (11) | `alpha` = 1 |
    | "wave" | (19), (20) | `wave_factor` = pi/2 |
    | "mencik-exponential", "mencik-reciprocal" | Mencik et al. (1997) | `alpha` = 1 |
    | "bec" | Bec et al. (2006) | |
    | "perriot-barthel" | Perriot and Barthel (2004) | |
    | "hay-crawford" | Hay and Crawford (2011) | |
    | "dimitriadis", "garcia" | incompressible layer on a rigid base, paraboloid or sphere, a < h | |

    The indenter is rigid. For a deformable indenter use `Pair`. For a residual stress or an interface with springs use `Layered`.

    References
    ----------
    popov-2014, equations (10)-(20)
    gao-1992
    doerner-1986
    mencik-1997
    bec-2006
    perriot-2004
    hay-2011
    dimitriadis-2002
    garcia-2018

    Examples
    --------
    >>> nitride, steel = mdr.Elastic(445e9, 0.25), mdr.Elastic(210e9, 0.30)
    >>> film = mdr.Coated(nitride, 2e-6, steel)
    >>> print(f"{film.modulus(2e-6):.4e} {film.with_model('gao').modulus(2e-6):.4e}")
    3.0273e+11 3.4297e+11
    >>> rubber = mdr.Coated(mdr.Elastic(2e6, 0.5), 5e-6, mdr.RIGID)
    >>> sliding = mdr.Coated(mdr.Elastic(2e6, 0.5), 5e-6, mdr.SMOOTH)
    >>> print(f"{rubber.modulus(2e-6):.4e} {sliding.modulus(2e-6):.4e}")
    4.4899e+06 3.6936e+06
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
                raise InvalidArgumentError(f"thickness = {thickness!r}: it must be finite and greater than 0")
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
        """Return the names of all models.

        Returns
        -------
        tuple of str
            Names for the argument `model`, "exact" last.
        """
        return tuple(MODELS)
