# SPDX-License-Identifier: GPL-3.0-or-later
"""The tangential force of compiled laws with friction, step by step."""

from __future__ import annotations

from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._boundary import call, check_memory, native, numbers, whole
from ._law_file import LawFile
from .errors import ArgumentTypeError, InvalidArgumentError

Reals = NDArray[np.float64]


class LawSteps(LawFile):
    """A compiled law that has sliders, if it was made with friction."""

    __slots__ = ()

    @property
    def coefficient(self) -> float | None:
        """Coefficient of friction [1]; None in a law without friction."""
        return float(self._facts["coefficient"]) or None

    @property
    def shear_strength(self) -> float | None:
        """Constant shear strength [modulus]; None in other laws."""
        return float(self._facts["shear_strength"]) or None

    @property
    def twists(self) -> bool:
        """True if the sliders resist a twist about the normal instead of a shift."""
        return bool(self._facts["twists"])

    @property
    def sliders(self) -> int:
        """Number of vector sliders of a contact; 0 without friction."""
        return int(self._facts["sliders"])

    @property
    def memory_size(self) -> int:
        """Length of the memory of one contact; 0 without friction."""
        return int(self._facts["memory_size"])

    @property
    def largest_sliding_shift(self) -> float:
        """Shift of first shear at which the contact slides [length].

        It is that at the end of the range, and 0 without friction and of a twist, whose axis always sticks.
        """
        return float(self._facts["highest_sliding_shift"])

    @property
    def first_shear_error(self) -> float:
        """Largest error of T in first shear, relative to T in sliding [1].

        It is 0 without friction.
        """
        return float(self._facts["first_shear_error"])

    @property
    def path_error(self) -> float | None:
        """Largest error of T along cycles, relative to the largest coefficient F [1].

        The cycles are those of depth and shift, and the reference is the exact history. It is None on bodies other than homogeneous
        ones, and without friction.
        """
        error = float(self._facts["path_error"])
        return error if self.sliders and error >= 0.0 else None

    def contacts(self, count: int) -> Reals:
        """Return the memory of contacts that have not been loaded.

        Parameters
        ----------
        count : int
            Number of contacts, >= 0.

        Returns
        -------
        ndarray
            Zeros of shape (count, `memory_size`). Store and read them as numbers. Set a row to 0 to reset that contact and its
            dissipated energy.

        Raises
        ------
        InvalidArgumentError
            The law has no friction.
        """
        if not self.sliders:
            raise InvalidArgumentError("the law has no friction. Make it with friction=Friction(...) or shear_strength")
        return np.zeros((whole("count", count, 0), self.memory_size))

    @overload
    def advance(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[False] = False) -> Reals: ...

    @overload
    def advance(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[True]) -> tuple[Reals, Reals, Reals]: ...

    def advance(
        self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: bool = False
    ) -> Reals | tuple[Reals, Reals, Reals]:
        """Advance all contacts by one step, and change their memory.

        The step is straight in the shift and in S = int dF/k_t. A step in which the shift changes direction should be at most 0.2
        of the sliding shift.

        Parameters
        ----------
        memory : ndarray
            The memory from `contacts`.
        force : array_like
            (n) normal forces F >= 0 at the end of the step [modulus length^2]; in a law with a shear strength contact radii instead
            [length]. 0 separates the bodies.
        shift : array_like
            (n, 2) or (n, 3) displacements of the indenter in this step, in the tangent plane [length]; in a law that twists (n)
            angles about the normal [radian].
        tangent : bool, optional
            True also returns derivatives.

        Returns
        -------
        ndarray or tuple of ndarray
            Tangential forces T on the medium, in the shape of `shift` [modulus length^2]. With `tangent` also dT/ds, (n, 2, 2) or
            (n, 3, 3) [modulus length], and dT/dF, in the shape of `shift` [1]. In a law that twists they are (n) numbers: the
            torque M [modulus length^3], dM/dphi [modulus length^3] and dM/dF [length].

        Raises
        ------
        ArgumentTypeError
            A shape is wrong, or the memory is not from `contacts`. After an error the memory is unchanged.
        """
        return self._step(False, memory, force, shift, tangent)

    @overload
    def attempt(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[False] = False) -> Reals: ...

    @overload
    def attempt(self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: Literal[True]) -> tuple[Reals, Reals, Reals]: ...

    def attempt(
        self, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: bool = False
    ) -> Reals | tuple[Reals, Reals, Reals]:
        """Return what `advance` would return, without changing the memory.

        Use it for Newton's method and for steps that may be rejected.

        Parameters
        ----------
        memory : ndarray
            As in `advance`.
        force : array_like
            As in `advance`.
        shift : array_like
            As in `advance`.
        tangent : bool, optional
            As in `advance`.

        Returns
        -------
        ndarray or tuple of ndarray
            As of `advance`.

        Raises
        ------
        ArgumentTypeError
            A shape is wrong, or the memory is not from `contacts`.
        """
        return self._step(True, memory, force, shift, tangent)

    def _step(
        self, is_trial: bool, memory: Reals, force: ArrayLike, shift: ArrayLike, tangent: bool
    ) -> Reals | tuple[Reals, Reals, Reals]:
        n = self._count(memory)
        forces, shifts = numbers("force", force), numbers("shift", shift)
        allowed = ((n,),) if self.twists else ((n, 2), (n, 3))
        if forces.shape != (n,) or shifts.shape not in allowed:
            raise ArgumentTypeError(
                f"force of shape {forces.shape} and shift of shape {shifts.shape}: they must be ({n},) "
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
        """Return the stored and the dissipated energy of all contacts.

        Parameters
        ----------
        memory : ndarray
            The memory from `contacts`.

        Returns
        -------
        tuple of ndarray
            (n) energies of the springs under shear or twist, and (n) energies dissipated since the first step [modulus length^3].
            Their sum is the work of T, up to terms of second order in the step. The dissipated energy never decreases.

        Raises
        ------
        ArgumentTypeError
            The memory is not from `contacts`.
        """
        n = self._count(memory)
        if not n:
            return np.zeros(0), np.zeros(0)
        stored, dissipated = call(native.law_energies, self._handle, n, memory)
        return stored, dissipated

    def turn(self, memory: Reals, normals: ArrayLike, spin: ArrayLike | None = None) -> None:
        """Rotate the memories of contacts with their tangent planes.

        The memory rotates by the smallest rotation from the old normal to the new one and by an angle about it; energies do not
        change. Call it before the first step, which sets the normal.

        Parameters
        ----------
        memory : ndarray
            The memory from `contacts`.
        normals : array_like
            (n, 3) unit normals of the planes [1].
        spin : array_like, optional
            (n) angles by which the bodies have rotated about the normals since the last call, the mean of both [radian]. None is 0.

        Raises
        ------
        ArgumentTypeError
            A shape is wrong, or the memory is not from `contacts`.
        """
        n, directions = self._count(memory), numbers("normals", normals)
        angles = np.zeros(n) if spin is None else numbers("spin", spin)
        if directions.shape != (n, 3) or angles.shape != (n,):
            raise ArgumentTypeError(
                f"normals of shape {directions.shape} and spin of shape {angles.shape}: they must be ({n}, 3) and ({n},)"
            )
        if n:
            call(native.law_turn, self._handle, directions, angles, memory)

    def _count(self, memory: Reals) -> int:
        check_memory(memory, self.memory_size, "ContactLaw.contacts")
        return len(memory)
