# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws of contacts with friction: the tangential force of many contacts, step by step (theory 10)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, _native
from ._boundary import address, call, number, numbers, whole
from ._law_file import LawFile, law_options
from .errors import ArgumentTypeError
from .friction import Friction

__all__ = ["FrictionLaw"]


class FrictionLaw(LawFile):
    """The tangential force of contacts in codes that integrate motion: stick, partial slip, sliding, and what earlier slip left
    behind, for the price of two polynomials a step. It never changes, may be shared between threads, and is saved, loaded and
    pickled with all it needs; what the contacts remember is the caller's array.

    friction : the `Friction` to compile
    largest_depth : > 0 [length]
    smallest_depth : from which on the tolerance holds [length]; None: 1e-4 of the largest
    tolerance : relative, of forces and stiffnesses; 1e-12 to 1e-2
    description : the problem in words, kept in files; None: the friction's repr
    continue_beyond : whether forces larger than that at the largest depth are answered along the tangent; else they are refused

    On homogeneous bodies (and with Gao's weights, where punches are superposed) it is exact in first shear, sliding, loops and
    loops inside a loop, with any normal force while the edge slips; an approximation where the contact grows without slip, in a
    third loop inside a second, and where the shift turns aside. See `first_shear_error` and `path_error`.
    """

    __slots__ = ()

    _write, _read, _describe = _native.friction_law_write, _native.friction_law_read, _native.friction_law_description
    _free, _info, _table = _native.friction_law_free, _native.friction_law_info, _layout.friction_law_facts

    def __init__(
        self,
        friction: Friction,
        largest_depth: float,
        *,
        smallest_depth: float | None = None,
        tolerance: float = 1e-9,
        description: str | None = None,
        continue_beyond: bool = False,
    ) -> None:
        if not isinstance(friction, Friction):
            raise ArgumentTypeError(f"friction = {friction!r} is not allowed: it must be a Friction")
        options, text = law_options(description, repr(friction), smallest_depth, tolerance, continue_beyond)
        largest = number("largest_depth", largest_depth)
        self._own(_native.friction_law_new(friction._handle.address, largest, address(options)))
        del text  # the options point to it

    @property
    def coefficient(self) -> float:
        """Of friction [1]."""
        return float(self._facts["coefficient"])

    @property
    def largest_force(self) -> float:
        """The largest normal force of the compiled range [modulus length^2]."""
        return float(self._facts["highest_force"])

    @property
    def largest_sliding_shift(self) -> float:
        """The shift of first shear at which the contact slides under the largest normal force [length]."""
        return float(self._facts["highest_sliding_shift"])

    @property
    def first_shear_error(self) -> float:
        """The largest error of T found in first shear at constant normal force F, relative to coefficient F: near the tolerance on
        homogeneous bodies and with Gao's weights, up to some per cent on exact layered ones."""
        return float(self._facts["first_shear_error"])

    @property
    def path_error(self) -> float | None:
        """The largest error of T found along cycles of depth and shift against the exact history, relative to the largest
        coefficient F; None on bodies other than homogeneous ones."""
        error = float(self._facts["path_error"])
        return None if error < 0.0 else error

    def __repr__(self) -> str:
        return f"<FrictionLaw of {self.description}, forces up to {self.largest_force:.4g}>"

    @staticmethod
    def contacts(count: int) -> NDArray[Any]:
        """The memory of `count` contacts that have not been loaded: a structured array, C's struct mdr_friction_memory, with the
        tangential forces in ["force"]. Setting an entry to 0 forgets that contact."""
        return np.zeros(whole("count", count, 0), _layout.friction_memory)

    def advance(self, contacts: NDArray[Any], force: ArrayLike, shift: ArrayLike) -> NDArray[np.float64]:
        """One step of all contacts, in each of which normal force and shift change in proportion; changes `contacts`.

        contacts : as `contacts` makes them
        force : (n) normal forces F at the end of the step; F <= 0 parts the bodies [modulus length^2]
        shift : (n, 2) or (n, 3) by how much the indenter moves in this step, in the tangent plane [length]

        Returns the tangential forces T on the medium, in the shape of `shift`. After an error all is as before.
        """
        memory = _memory(contacts)
        forces, shifts = numbers("force", force), numbers("shift", shift)
        if forces.shape != memory.shape or shifts.ndim != 2 or len(shifts) != memory.size or shifts.shape[1] not in (2, 3):
            raise ArgumentTypeError(
                f"force of shape {forces.shape} and shift of shape {shifts.shape} are not allowed: they must be ({memory.size},) "
                f"and ({memory.size}, 2) or ({memory.size}, 3)"
            )
        in_space = np.zeros((memory.size, 3))
        in_space[:, : shifts.shape[1]] = shifts
        if memory.size:
            call(_native.friction_law_advance, self._handle.address, forces, in_space, address(memory))
        return np.array(memory["force"][:, : shifts.shape[1]])

    @staticmethod
    def turn(contacts: NDArray[Any], normal: ArrayLike) -> None:
        """Lays the memories of contacts whose tangent planes have turned into the new planes, with the lengths they have.

        normal : (n, 3) normals of the planes, of length 1
        """
        memory, normals = _memory(contacts), numbers("normal", normal)
        if normals.shape != (memory.size, 3):
            raise ArgumentTypeError(f"normal of shape {normals.shape} is not allowed: it must be ({memory.size}, 3)")
        if memory.size:
            call(_native.friction_memory_turn, normals, address(memory))


def _memory(contacts: NDArray[Any]) -> NDArray[Any]:
    if not (isinstance(contacts, np.ndarray) and contacts.dtype == _layout.friction_memory and contacts.ndim == 1
            and contacts.flags.c_contiguous and contacts.flags.writeable):  # fmt: skip
        raise ArgumentTypeError("contacts is not allowed: it must be an array made by FrictionLaw.contacts, or a slice of one")
    return contacts
