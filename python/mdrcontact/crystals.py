# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic constants of materials with an axis, from the literature."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, NamedTuple

from .material import TransverselyIsotropic


class Crystal(NamedTuple):
    """Material with its axis along z and the source of its constants.

    Examples
    --------
    >>> crystal = mdr.CRYSTALS["ZnO"]
    >>> print(f"{crystal.material.C33:.4e}", crystal.source)
    2.1090e+11 Bateman 1962, J. Appl. Phys. 33, 3309
    """

    material: TransverselyIsotropic
    """the material, constants in Pa"""
    source: str
    """author, year and journal of the measured constants"""


def _crystal(source: str, *stiffnesses: float) -> Crystal:
    return Crystal(TransverselyIsotropic(*(1e9 * value for value in stiffnesses)), source)


CRYSTALS: Final[Mapping[str, Crystal]] = MappingProxyType(
    {
        "AlN": _crystal("Wright 1997, J. Appl. Phys. 82, 2833", 396.0, 137.0, 108.0, 373.0, 116.0),
        "bone": _crystal("Yoon, Katz 1976, J. Biomech. 9, 459: cortical, z along the bone", 23.4, 9.06, 9.11, 32.5, 8.71),
        "GaN": _crystal("Polian, Grimsditch, Grzegory 1996, J. Appl. Phys. 79, 3343", 390.0, 145.0, 106.0, 398.0, 105.0),
        "graphite": _crystal("Blakslee et al. 1970, J. Appl. Phys. 41, 3373", 1060.0, 180.0, 15.0, 36.5, 4.5),
        "MoS2": _crystal("Feldman 1976, J. Phys. Chem. Solids 37, 1141", 238.0, -54.0, 23.0, 52.0, 19.0),
        "Ti": _crystal("Fisher, Renken 1964, Phys. Rev. 135, A482", 162.4, 92.0, 69.0, 180.7, 46.7),
        "ZnO": _crystal("Bateman 1962, J. Appl. Phys. 33, 3309", 209.7, 121.1, 105.1, 210.9, 42.5),
    }
)
"""Hexagonal crystals with the axis c along z, and bone, by name: `CRYSTALS["GaN"].material`, constants in Pa."""
