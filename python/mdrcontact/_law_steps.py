# SPDX-License-Identifier: GPL-3.0-or-later
"""The tangential force of compiled laws with friction, step by step."""

from __future__ import annotations

from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._boundary import call, native, numbers, whole
from ._law_file import LawFile
from .errors import ArgumentTypeError, InvalidArgumentError

Reals = NDArray[np.float64]


class LawSteps(LawFile):
    """A compiled law that has sliders, if it was made with friction."""

    __slots__ = ()

    @property
    def coefficient(self) -> float | None:
        """Of friction [1]; None in a law without it."""
        return float(self._facts["coefficient"]) or None

    @property
    def shear_strength(self) -> float | None:
        """Where it is constant [modulus]; None in other laws."""
        return float(self._facts["shear_strength"]) or None

    @property
    def twists(self) -> bool:
        """Whether the sliders bear a twist about the normal, with its torque, in place of a shift."""
        return bool(self._facts["twists"])

    @property
    def sliders(self) -> int:
        """How many vector sliders stand for the springs of a contact; 0 in a law without friction."""
        return int(self._facts["sliders"])

    @property
    def memory_size(self) -> int:
        """Length of a contact's memory; 0 in a law without friction."""
        return int(self._facts["memory_size"])

    @property
    def largest_sliding_shift(self) -> float:
        """The shift of first shear at which the contact slides under the largest normal force, or with the largest contact radius
        [length]; 0 without friction, and of a twist: the axis sticks at any."""
        return float(self._facts["highest_sliding_shift"])

    @property
    def first_shear_error(self) -> float:
        """The largest error of T found in first shear at constant normal force F or contact radius, relative to T in sliding; 0
        without friction."""
        return float(self._facts["first_shear_error"])

    @property
    def path_error(self) -> float | None:
        """The largest error of T found along cycles of depth and shift against the exact history, relative to the largest
        coefficient F; None on bodies other than homogeneous ones, and in a law without friction."""
        error = float(self._facts["path_error"])
        return error if self.sliders and error >= 0.0 else None

    def contacts(self, count: int) -> Reals:
        """The memory of `count` contacts that have not been loaded: an array of shape (count, `memory_size`) of zeros. To be stored
        and read as numbers; setting a row to 0 forgets that contact, its dissipated energy too."""
        if not self.sliders:
            raise InvalidArgumentError("the law has no friction: it is to be made with friction=Friction(...) or shear_strength")
        return np.zeros((whole("count", count, 0), self.memory_size))

    @overload
    def advance(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[False] = False) -> Reals: ...

    @overload
    def advance(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[True]) -> tuple[Reals, Reals, Reals]: ...

    def advance(
        self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: bool = False
    ) -> Reals | tuple[Reals, Reals, Reals]:
        """One step of all contacts, straight in shift and S = int dF/k_t; changes `memory`.

        memory : as `contacts` makes it
        force : (n) normal forces F >= 0 at the end of the step [modulus length^2]; in a law with a shear strength contact radii
            in their place [length]. 0 parts the bodies
        shift : (n, 2) or (n, 3) by how much the indenter moves in this step, in the tangent plane [length]; in a law that twists
            (n) angles by which it turns about the normal against the medium [1]
        tangent : whether the derivatives are wanted

        Returns the tangential forces T on the medium, in the shape of `shift`; with `tangent` also dT/ds, (n, 2, 2) or (n, 3, 3),
        [modulus length] and dT/dF, in the shape of `shift`, by the shift of the step and F at its end. In a law that twists all
        these are numbers, (n): the torque M [modulus length^3], dM/dphi and dM/dF. A step in which the shift
        turns aside should be no longer than 0.2 of the shift of sliding. After an error all is as before.
        """
        return self._step(False, memory, force, shift, tangent)

    @overload
    def attempt(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[False] = False) -> Reals: ...

    @overload
    def attempt(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[True]) -> tuple[Reals, Reals, Reals]: ...

    def attempt(
        self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: bool = False
    ) -> Reals | tuple[Reals, Reals, Reals]:
        """What `advance` would return; `memory` stays as it is. For Newton's method, and for steps that may be taken back."""
        return self._step(True, memory, force, shift, tangent)

    def _step(
        self, is_trial: bool, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: bool
    ) -> Reals | tuple[Reals, Reals, Reals]:
        n = self._count(memory)
        forces, shifts = numbers("force", force), numbers("shift", shift)
        allowed = ((n,),) if self.twists else ((n, 2), (n, 3))
        if forces.shape != (n,) or shifts.shape not in allowed:
            raise ArgumentTypeError(
                f"force of shape {forces.shape} and shift of shape {shifts.shape} are not allowed: they must be ({n},) "
                f"and {' or '.join(map(str, allowed))}"
            )
        axes: Any = 0 if self.twists else slice(shifts.shape[1])
        in_space, slopes, total = np.zeros((n, 3)), np.zeros((n, 3, 4)), np.zeros((n, 3))
        in_space[:, axes] = shifts
        if n:
            places = slopes if tangent else None, memory
            total = call(native.law_advance, self._handle, forces, in_space, is_trial, *places)
        total = np.array(total[:, axes])
        return (total, np.array(slopes[:, axes, axes]), np.array(slopes[:, axes, 3])) if tangent else total

    def energies(self, memory: Reals) -> tuple[Reals, Reals]:
        """Energies of all contacts [modulus length^3], (n) each: what the springs hold under shear or twist, and what slip has
        taken since the first step. Their sum is the work of T, up to terms of the order of a step squared; along a line under
        constant F they do not depend on the steps. What slip has taken never falls."""
        n = self._count(memory)
        if not n:
            return np.zeros(0), np.zeros(0)
        stored, dissipated = call(native.law_energies, self._handle, n, memory)
        return stored, dissipated

    def turn(self, memory: Reals, normals: ArrayLike, spin: ArrayLike | None = None) -> None:
        """Turns the memories of contacts with their tangent planes, by the least rotation from the old normal to the new one and by
        an angle about it; energies stay. The first turn makes the normal known: contacts whose planes turn are turned before their
        first step too.

        normals : (n, 3) normals of the planes, of length 1
        spin : (n) angles by which the bodies have turned about the normals since the last turn, the mean of both [1]; None: 0
        """
        n, directions = self._count(memory), numbers("normals", normals)
        angles = np.zeros(n) if spin is None else numbers("spin", spin)
        if directions.shape != (n, 3) or angles.shape != (n,):
            raise ArgumentTypeError(
                f"normals of shape {directions.shape} and spin of shape {angles.shape} are not allowed: they must be ({n}, 3) and "
                f"({n},)"
            )
        if n:
            call(native.law_turn, self._handle, directions, angles, memory)

    def _count(self, memory: Reals) -> int:
        if not (self.sliders and isinstance(memory, np.ndarray) and memory.dtype == np.float64 and memory.ndim == 2
                and memory.shape[1] == self.memory_size and memory.flags.c_contiguous and memory.flags.writeable):  # fmt: skip
            raise ArgumentTypeError(
                "memory is not allowed: it must be an array made by ContactLaw.contacts, or some of its rows in a row"
            )
        return len(memory)
