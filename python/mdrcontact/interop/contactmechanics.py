# SPDX-License-Identifier: GPL-3.0-or-later
"""Substrates of ContactMechanics with the compliance of a layered body; docs/rough.md."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..errors import InvalidArgumentError, NoConvergenceError
from ..medium.base import Medium
from ._grid import Array, Response, engine, folded, grid_of

__all__ = ["FreeLayeredSubstrate", "LayeredSubstrate"]

_engine = engine("ContactMechanics", __name__)
_Periodic: Any = _engine.PeriodicFFTElasticHalfSpace
_Free: Any = _engine.FreeFFTElasticHalfSpace


class _FirstGuess:
    """What both substrates add to those of the engine."""

    def first_guess(self, topography: Any, offset: float) -> Array:
        """Return forces from which the solvers of the engine converge.

        Parameters
        ----------
        topography : SurfaceTopography.Topography
            The rigid surface, of the grid of the substrate.
        offset : float
            Displacement of the surface into the body [length]. If a force is given to the solver instead, any offset at which
            the undeformed surfaces overlap.

        Returns
        -------
        ndarray
            Forces on the pixels, proportional to the overlap of the undeformed surfaces, for `initial_forces` of `minimize_proxy`
            [modulus length^2].

        Raises
        ------
        InvalidArgumentError
            The undeformed surfaces do not overlap.

        Notes
        -----
        The own first guess of the engine can be a stationary point, from which its solver does not move. These forces minimize the
        energy among all that are proportional to the overlap.
        """
        substrate: Any = self
        heights = np.ma.filled(topography.heights(), -np.inf)
        overlap = np.maximum(heights + offset, 0.0)
        square = float(substrate.pnp.sum(overlap**2))
        if not 0.0 < square < math.inf:
            highest = float(substrate.pnp.max(heights))
            raise InvalidArgumentError(f"offset = {offset!r}: the surfaces do not overlap. Set a finite offset > {-highest:.6g}")
        inside = substrate.local_topography_subdomain_slices
        forces = np.zeros(substrate.nb_subdomain_grid_pts)
        forces[inside] = -overlap
        return forces * (square / float(substrate.pnp.sum(overlap * substrate.evaluate_disp(forces)[inside])))

    def check(self, force: Any = None) -> None:
        """Raise if a solution is the first guess or leaves a free domain.

        Parameters
        ----------
        force : ndarray, optional
            Forces on the pixels; those of the last solution if omitted.

        Raises
        ------
        NoConvergenceError
            The forces on all pixels are equal, which is a solution for a flat surface alone.
        """
        substrate: Any = self
        of_pixels = substrate.force if force is None else force
        lowest, highest = (float(find(of_pixels)) for find in (substrate.pnp.min, substrate.pnp.max))
        if lowest == highest != 0.0:
            raise NoConvergenceError(
                "the solver returned its first guess, equal forces on all pixels. Pass initial_forces=substrate.first_guess(...)"
            )
        super().check(force)  # type: ignore[misc]


class LayeredSubstrate(_FirstGuess, _Periodic):  # type: ignore[misc]
    """Substrate of a periodic cell, or of line contacts, of a layered body.

    Parameters
    ----------
    body : Medium
        Body with a compliance: homogeneous, coated, layered or graded, or a pair of these.
    nb_grid_pts : int or tuple of int
        Points along one direction, for line contacts, or along both.
    physical_sizes : float or tuple of float
        Sizes of the cell [length].
    mean : {"layers", "isolated"} or float, optional
        C(0), the displacement by a uniform pressure. "layers": that of the layers, without the infinite one of a half-space below
        them. "isolated": that at which one contact in the cell has the depth of one without neighbours, up to the third power of
        contact radius over cell. A number [length/modulus]; 0 measures the depth below the mean surface.
    omega : float, optional
        Of a relaxing body: 0 for the relaxed one [1/time].
    drainage : {"surface", "sealed"}, optional
        Of a poroelastic body.
    velocity : float, optional
        Speed along x at which the load moves steadily over a relaxing body [length/time]. The substrate then gives displacements
        by forces and forces by displacements, in the frame of the load. Solvers by minimization raise: there is no energy.
    communicator : communicator of MPI, optional
        Each process computes its own part of the waves.
    fftengine : muGrid.FFTEngine, optional
        As of the substrates of the engine.

    Raises
    ------
    InvalidArgumentError
        The compliance is complex or not known, C(0) < 0, or an argument is outside its range.

    Examples
    --------
    >>> from mdrcontact.interop.contactmechanics import LayeredSubstrate
    >>> film = mdr.Layered([(mdr.Elastic(1e9, 0.3), 3e-4)], mdr.RIGID)
    >>> substrate = LayeredSubstrate(film, (64, 64), (4e-3, 4e-3))
    >>> print(substrate.greens_function.shape)
    (33, 64)
    """

    name = "periodic_layered_substrate"

    def __init__(
        self,
        body: Medium,
        nb_grid_pts: Any,
        physical_sizes: Any,
        *,
        mean: str | float = "layers",
        omega: float | None = None,
        drainage: str | None = None,
        velocity: float | None = None,
        communicator: Any = None,
        fftengine: Any = None,
    ) -> None:
        points, sizes = grid_of(nb_grid_pts, physical_sizes)
        self._response = Response(body, omega, drainage, velocity)
        self._mean = self._response.mean(mean, sizes)
        modulus = self._response.modulus(points, sizes)
        super().__init__(points, modulus, sizes, communicator=communicator, fftengine=fftengine)

    def _compute_greens_function(self) -> Any:
        rows = zip(self.nb_grid_pts, self.fourier_locations, self.nb_fourier_grid_pts, self.physical_sizes, strict=True)
        axes = [2.0 * np.pi / size * folded(n, first, m) for n, first, m, size in rows]
        if self._response.velocity is None:
            return self._response.waves(axes, self._mean)
        moving = self._response.moving_waves(axes, self._mean)
        # the shortest wave of an even number of points has both directions
        both = axes[0] == np.pi * self.nb_grid_pts[0] / self.physical_sizes[0]
        moving[both] = moving[both].real
        return moving

    def evaluate_elastic_energy(self, forces: Array, disp: Array) -> float:
        """Return the elastic energy; raise for a moving load.

        Parameters
        ----------
        forces, disp : ndarray
            Forces and displacements of the pixels.

        Returns
        -------
        float
            The energy [modulus length^3].
        """
        self._check_energy()
        return float(super().evaluate_elastic_energy(forces, disp))

    def evaluate_elastic_energy_k_space(self, kforces: Any, kdisp: Any) -> float:
        """Return the elastic energy by waves; raise for a moving load.

        Parameters
        ----------
        kforces, kdisp : ndarray
            Transforms of forces and displacements.

        Returns
        -------
        float
            The energy [modulus length^3].
        """
        self._check_energy()
        return float(super().evaluate_elastic_energy_k_space(kforces, kdisp))

    def check(self, force: Any = None) -> None:
        """Raise if a solution is the first guess, or was found for a moving load.

        Parameters
        ----------
        force : ndarray, optional
            Forces on the pixels; those of the last solution if omitted.
        """
        self._check_energy()
        super().check(force)

    def _check_energy(self) -> None:
        if self._response.velocity is not None:
            raise InvalidArgumentError(
                f"velocity = {self._response.velocity!r}: a relaxing body under a moving load has no energy that a solver could "
                "minimize. Call evaluate_disp or evaluate_force"
            )


class FreeLayeredSubstrate(_FirstGuess, _Free):  # type: ignore[misc]
    """Substrate of one contact without neighbours on a layered body.

    Parameters
    ----------
    body : Medium
        As of `LayeredSubstrate`.
    nb_grid_pts : tuple of int
        Points along both directions.
    physical_sizes : float or tuple of float
        Sizes of the grid [length]. The contact must be inside it; the displacement outside it is not needed.
    omega : float, optional
        Of a viscoelastic body: 0, for the relaxed one [1/time].
    check_boundaries : bool, optional
        Whether solutions with forces on the outermost pixels raise.
    communicator : communicator of MPI, optional
        Each process computes its own part of the pixels.
    fftengine : muGrid.FFTEngine, optional
        As of the substrates of the engine, of twice the points in each direction.

    Raises
    ------
    InvalidArgumentError
        The displacement by a pixel is not known, or an argument is outside its range.

    Notes
    -----
    The displacement by one pixel is exact for every size of the pixel. `minimize_proxy` needs
    `initial_forces=substrate.first_guess(topography, offset)`.

    Examples
    --------
    >>> from mdrcontact.interop.contactmechanics import FreeLayeredSubstrate
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.30))
    >>> substrate = FreeLayeredSubstrate(film, (64, 64), (4e-6, 4e-6))
    >>> print(substrate.nb_domain_grid_pts)
    (128, 128)
    """

    name = "free_layered_substrate"

    def __init__(
        self,
        body: Medium,
        nb_grid_pts: Any,
        physical_sizes: Any,
        *,
        omega: float | None = None,
        check_boundaries: bool = True,
        communicator: Any = None,
        fftengine: Any = None,
    ) -> None:
        points, sizes = grid_of(nb_grid_pts, physical_sizes)
        if len(points) != 2:
            raise InvalidArgumentError(
                f"nb_grid_pts = {nb_grid_pts!r}: one contact needs two directions. Use LayeredSubstrate for line contacts"
            )
        self._response = Response(body, omega)
        self._comp_nb_grid_pts = tuple(2 * n for n in points)
        super().__init__(
            points,
            self._response.modulus(points, sizes),
            sizes,
            check_boundaries=check_boundaries,
            communicator=communicator,
            fftengine=fftengine,
        )

    def _pixels(self) -> Array:
        """Displacement by unit pressure on one pixel, on the part of the doubled grid that belongs to this process."""
        rows = zip(self.nb_domain_grid_pts, self.subdomain_locations, self.nb_subdomain_grid_pts, self._steps, strict=True)
        return self._response.pixels([step * folded(n, first, m) for n, first, m, step in rows], self._steps)

    def _compute_greens_function(self) -> Array:
        self.real_buffer.p[...] = self._pixels()
        self.fftengine.fft(self.real_buffer, self.fourier_buffer)
        transform: Array = self.fourier_buffer.p.copy()
        return transform

    def spawn_child(self, nb_grid_pts: Any) -> FreeLayeredSubstrate:
        """Return the same body on fewer pixels of the same size.

        Parameters
        ----------
        nb_grid_pts : tuple of int
            Points along both directions.

        Returns
        -------
        FreeLayeredSubstrate
            The substrate, without a check of its boundaries.
        """
        sizes = tuple(step * n for step, n in zip(self._steps, nb_grid_pts, strict=True))
        given = self._response
        return FreeLayeredSubstrate(given.body, tuple(nb_grid_pts), sizes, omega=given.omega, check_boundaries=False)
