# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured data of elastic bodies, one class for each kind."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, ClassVar, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ... import _layout
from ..._boundary import number, numbers
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...loop import BRANCHES

Array = NDArray[np.float64]
Self = TypeVar("Self", bound="Data")

_FEWEST_TO_JUDGE = 20
_CLIPPED = 0.04
"""Largest fraction of readings that coarse digits let share the largest value."""
_FINEST = 1e-15
"""Standard deviation over reading: less is less than the rounding of the reading, and leaves intervals that are none."""
REVERSIBLE, _FEWEST_FOR_SLOPE = 0.05, 5
"""Largest deviation from 1 of the rise of the force over the integral of the stiffness, and the fewest points for this test."""
_RETURN = 0.2
"""A curve whose x goes back over this part of its range holds loading and unloading."""


class Data:
    """Points (x, y), checked; `sd` are the standard deviations of y, None if they are unknown and equal."""

    code: ClassVar[int]
    x_name: ClassVar[str]
    y_name: ClassVar[str]
    given_name: ClassVar[str] = ""
    """further known values of each point"""
    contact_points: Mapping[str, float] = MappingProxyType({})
    """depth of initial contact by each estimator that examined the record [length]"""
    pulls: Mapping[str, float] = MappingProxyType({})
    """numbers of the record without a model: forces of "jump-in" and "pull-off", depth of the "last rupture", "energy lost" """
    tests: NDArray[np.intp] | None = None
    """number of the test of each point, if there are several tests"""
    also_free: tuple[str, ...] = ()
    """parameters of the instrument that a fit frees in addition to the given ones"""

    def __init__(
        self, x: ArrayLike, y: ArrayLike, given: ArrayLike | None, sd: ArrayLike | None, relative_sd: float | None, missing: str
    ) -> None:
        if missing not in ("raise", "drop"):
            raise InvalidArgumentError(f"missing = {missing!r}: choose from 'raise', 'drop'")
        if sd is not None and relative_sd is not None:
            raise InvalidArgumentError("sd and relative_sd: both are standard deviations of the data. Give one of them")
        columns = {self.x_name: column_of(self.x_name, x), self.y_name: column_of(self.y_name, y)}
        if given is not None:
            columns[self.given_name] = column_of(self.given_name, given)
        if relative_sd is not None:
            relative = number("relative_sd", relative_sd)
            if not 0.0 < relative < 1.0:
                raise InvalidArgumentError(f"relative_sd = {relative!r}: it must be between 0 and 1")
            sd = relative * np.abs(columns[self.y_name])
            zeros = np.flatnonzero(sd == 0.0)
            if len(zeros):
                raise InvalidArgumentError(
                    f"relative_sd: the {self.y_name} must not be 0, as in entry {zeros[0]}, counted from 0. Omit such readings, or "
                    "give sd"
                )
        if sd is not None:
            errors = numbers("sd", sd)
            columns["sd"] = np.full_like(columns[self.x_name], errors) if errors.ndim == 0 else column_of("sd", errors)
        lengths = {name: len(column) for name, column in columns.items()}
        if len(set(lengths.values())) > 1:
            raise InvalidArgumentError(f"the columns must have the same length; it is {lengths}")
        self.warnings: list[str] = []
        columns = self._without_gaps(columns, missing)
        self.x, self.y = columns[self.x_name], columns[self.y_name]
        self.given, self.sd = columns.get(self.given_name), columns.get("sd")
        self.branch: NDArray[np.int32] | None = None
        # readings of the record that are not fitted, where x and y are its depth and force
        self.unused: tuple[Array, ...] | None = None
        if self.sd is not None:
            fine = np.flatnonzero((self.sd > 0.0) & (self.sd < _FINEST * np.abs(self.y)))
            if len(fine):
                raise InvalidArgumentError(
                    f"entry {fine[0]} of sd = {self.sd[fine[0]]:.3g}, counted from 0,: no reading of "
                    f"{self.y[fine[0]]:.4g} is that fine; check its units"
                )
        self._check_order()
        for name, values in ((self.x_name, self.x), (self.y_name, self.y)):
            ties = int(np.sum(values == values.max(initial=-np.inf)))
            if ties > max(2, _CLIPPED * len(self)):
                self.warnings.append(
                    f"{ties} of {len(self)} readings of the {name} are its largest value {values.max():.4g}: the instrument "
                    "was at the end of its range, or stood still"
                )

    def __len__(self) -> int:
        return len(self.x)

    def __repr__(self) -> str:
        if not len(self):
            return f"<{type(self).__name__}: empty>"
        ranges = f"{self.x_name} {self.x.min():.4g} to {self.x.max():.4g}, {self.y_name} {self.y.min():.4g} to {self.y.max():.4g}"
        return f"<{type(self).__name__}: {len(self)} points, {ranges}>"

    def order(self) -> NDArray[np.intp]:
        """Return the positions of the points along the curve.

        Returns
        -------
        ndarray
            Positions by branch, and within a branch by ascending x.
        """
        branch = np.zeros(len(self)) if self.branch is None else self.branch
        return np.lexsort((self.x, branch))

    def with_y(self: Self, y: Array) -> Self:
        """Return the same points with other values, for simulations.

        Parameters
        ----------
        y : ndarray
            The values.

        Returns
        -------
        Data
            Data of this class.
        """
        copy = object.__new__(type(self))
        copy.__dict__.update(self.__dict__, y=np.asarray(y, dtype=float))
        return copy

    def _without_gaps(self, columns: dict[str, Array], missing: str) -> dict[str, Array]:
        bad = ~np.all([np.isfinite(column) for column in columns.values()], axis=0)
        self._kept = ~bad
        if not bad.any():
            return columns
        places = np.flatnonzero(bad)
        which = ", ".join(str(i) for i in places[:5]) + (", ..." if len(places) > 5 else "")
        rows = "1 row is" if len(places) == 1 else f"{len(places)} rows are"
        words = f"{rows} not finite numbers (counted from 0: {which})"
        if missing == "raise":
            raise InvalidArgumentError(f"{words}: remove them, or let missing='drop' do it")
        self.warnings.append(f"{words}: left out")
        return {name: column[~bad] for name, column in columns.items()}

    def _turn(self) -> int | None:
        """The point at which a curve turns from loading to unloading; None where it does not."""
        top = int(np.argmax(self.x)) if len(self) >= _FEWEST_TO_JUDGE else 0
        if not 0 < top < len(self) - 1:
            return None
        rise = float(np.ptp(self.x))
        both = min(float(self.x[top] - self.x[:top].min()), float(self.x[top] - self.x[top:].min())) > _RETURN * rise
        # points in no order at all do not turn: their neighbours are far apart
        return top if both and np.median(np.abs(np.diff(self.x))) < _RETURN * rise else None

    def _check_order(self) -> None:
        """Raise an error for a curve that reverses. Otherwise the order of the points does not matter."""
        top = self._turn()
        if top is None:
            return
        rise, returns = float(np.ptp(self.x)), float(self.x[top] - self.x[top:].min())
        raise InvalidArgumentError(
            f"{self.x_name} rises to its largest value at point {top} of {len(self)} and falls again by "
            f"{100.0 * returns / rise:.0f} % of its range: these are loading and unloading in one curve; fit one of them, as "
            'by branch = "loading" in [data] of a problem file'
        )


def column_of(name: str, values: ArrayLike) -> Array:
    """`values` as an array of one dimension."""
    array = numbers(name, values)
    if array.ndim != 1:
        raise ArgumentTypeError(f"{name}: it must have one dimension, not {array.ndim}")
    return array


class ForceDepth(Data):
    """Measured elastic force-depth curve.

    It may contain loading, unloading or both, with baseline and pull-off.

    Parameters
    ----------
    depth : array_like
        Depth readings [length].
    force : array_like
        Force readings [modulus length^2].
    sd : float or array_like, optional
        Standard deviation of the force [modulus length^2]. Without `sd` and `relative_sd` it is estimated from the scatter about
        the fit and equal for all points.
    relative_sd : float, optional
        Standard deviation of the force relative to the force, 0 < relative_sd < 1 [1].
    missing : {"raise", "drop"}, optional
        What to do with rows that contain NaN or infinity.
    branch : str or sequence of str, optional
        "loading" or "unloading", for all points or for each. None: a curve whose depth rises and falls again turns at its largest
        depth. It matters with adhesion: the readings of each branch show where contact begins or ends.

    Raises
    ------
    InvalidArgumentError
        The columns differ in length, a row is not finite, or both standard deviations are given.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> data = mdr.instruments.ForceDepth(depth, silica.at_depth(depth).force, relative_sd=0.01)
    >>> print(len(data), f"{data.sd[-1]:.2e}")
    20 9.89e-05
    """

    code, x_name, y_name = _layout.FIT_FORCE_DEPTH, "depth", "force"

    def __init__(
        self,
        depth: ArrayLike,
        force: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
        branch: Any = None,
    ) -> None:
        if branch is not None:
            words = [branch] * np.size(depth) if isinstance(branch, str) else list(branch)
            for word in words:
                if word not in BRANCHES:
                    raise InvalidArgumentError(f"branch = {word!r}: choose from 'loading', 'unloading'")
            if len(words) != np.size(depth):
                raise InvalidArgumentError(
                    f"branch has {len(words)} entries and depth {np.size(depth)}: they must have the same length"
                )
            self._given = np.array([BRANCHES[word] for word in words], dtype=np.int32)
        super().__init__(depth, force, None, sd, relative_sd, missing)

    _given: NDArray[np.int32] | None = None

    def _check_order(self) -> None:
        if self._given is not None:
            self.branch = self._given[self._kept]
            return
        top = self._turn()
        if top is None:
            super()._check_order()
            return
        self.branch = np.where(np.arange(len(self)) <= top, BRANCHES["loading"], BRANCHES["unloading"]).astype(np.int32)

    def on(self, branch: str) -> ForceDepth:
        """Return the points of one branch; all points of a curve with one branch.

        Parameters
        ----------
        branch : {"loading", "unloading"}
            The branch.

        Returns
        -------
        ForceDepth
            The points.

        Raises
        ------
        InvalidArgumentError
            The branch is unknown.
        """
        if branch not in BRANCHES:
            raise InvalidArgumentError(f"branch = {branch!r}: choose from 'loading', 'unloading'")
        if self.branch is None:
            return self
        keep = self.branch == BRANCHES[branch]
        part = ForceDepth(self.x[keep], self.y[keep], sd=None if self.sd is None else self.sd[keep], branch=branch)
        part.unused = self.x[~keep], self.y[~keep]
        return part


class UnloadingPoint(NamedTuple):
    """Result of one unloading curve, with P = B (h - h_f)^m in its upper part.

    S = dP/dh is the stiffness at the beginning of unloading.
    `Unloading.unloadings` contains them.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 100e-9, 60), np.linspace(100e-9, 60e-9, 60)])
    >>> force = 1e-3 * np.concatenate([np.linspace(0.0, 1.0, 60) ** 2, np.linspace(1.0, 0.0, 60) ** 1.5])
    >>> point = mdr.instruments.Unloading(depth, force).unloadings[0]
    >>> print(f"{point.stiffness:.4e} {point.exponent:.3f} {point.final_depth * 1e9:.1f}")
    3.7500e+04 1.500 60.0
    """

    depth: float
    """h_max, depth at the beginning of unloading [length]"""
    force: float
    """P_max, force at the beginning of unloading [modulus length^2]"""
    stiffness: float
    """S, stiffness at the beginning of unloading [modulus length]"""
    stiffness_error: float
    """standard error of the stiffness, widened for correlated residuals [modulus length]"""
    final_depth: float
    """h_f [length]"""
    exponent: float
    """m [1]"""
    fitted_depth: Array
    """depths of the fitted part [length]"""
    fitted_force: Array
    """forces of the fitted part [modulus length^2]"""
    warnings: tuple[str, ...]
    """warnings about the stiffness"""


class StiffnessDepth(Data):
    """Measured contact stiffness against depth.

    An example is dynamic (CSM) nanoindentation. The contact radius of each point is that of the tip at the contact depth h - sigma
    P/S, where sigma P/S is how deep the surface sinks in at the edge of the exact contact. Plastic contacts are possible if they do
    not pile up.

    Parameters
    ----------
    depth : array_like
        h [length].
    force : array_like
        P [modulus length^2].
    stiffness : array_like
        S [modulus length].
    sd : float or array_like, optional
        Standard deviation of the stiffness, as in `ForceDepth` [modulus length].
    relative_sd : float, optional
        As in `ForceDepth` [1].
    missing : {"raise", "drop"}, optional
        As in `ForceDepth`.
    elastic : bool, optional
        True: nothing has yielded, and the surface sinks in as under the indenter itself. False: as under the smooth indenter of
        `Instrument(contact_depth_factor=...)`. None: True if the force rises along the curve as the stiffness, dP/dh = S to 5 %,
        unless the contact depth of the instrument is changed.

    Raises
    ------
    InvalidArgumentError
        As of `ForceDepth`.
    ArgumentTypeError
        `elastic` is not True, False or None.

    References
    ----------
    oliver-1992
    oliver-2004

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(163e9, 0.22))
    >>> states = mdr.Contact(mdr.Paraboloid(1e-6), film).at_depth(np.linspace(10e-9, 60e-9, 8))
    >>> data = mdr.instruments.StiffnessDepth(states.depth, states.force, states.stiffness, relative_sd=0.01)
    >>> start = film.with_parameters({"coating.E": 90e9})
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(1e-6), start, ["coating.E"])
    >>> print(f"{result.estimates['coating.E'] / 1e9:.2f}")
    72.00
    """

    code, x_name, y_name, given_name = _layout.FIT_STIFFNESS_DEPTH, "depth", "stiffness", "force"
    unloadings: tuple[UnloadingPoint, ...] = ()
    """results of the unloading curves, if the data are of `Unloading`"""
    record: tuple[Array, Array] | None = None
    """depth and force of the whole test, if the data are of `Unloading`"""
    elastic: bool | None = None

    def __init__(
        self,
        depth: ArrayLike,
        force: ArrayLike,
        stiffness: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
        elastic: bool | None = None,
    ) -> None:
        super().__init__(depth, stiffness, force, sd, relative_sd, missing)
        if elastic is not None and not isinstance(elastic, bool):
            raise ArgumentTypeError(f"elastic = {elastic!r}: it must be True, False or None")
        self.elastic = elastic
        self.seems_elastic = abs(self.reversibility() - 1.0) < REVERSIBLE

    def reversibility(self) -> float:
        """Return the rise of the force over the integral of the stiffness.

        It is 1 if the contact is elastic, for any body, tip, frame and offsets.

        Returns
        -------
        float
            The ratio [1]; 0 if there are too few points.
        """
        order = np.argsort(self.x)
        h, s = self.x[order], self.y[order]
        p = np.zeros_like(h) if self.given is None else self.given[order]
        work = float(0.5 * (s[1:] + s[:-1]) @ np.diff(h))
        return float(p[-1] - p[0]) / work if len(h) >= _FEWEST_FOR_SLOPE and work > 0.0 else 0.0

    @property
    def force(self) -> Array | None:
        """P at each point [modulus length^2]."""
        return self.given


class ModulusRadius(Data):
    """Measured effective contact modulus against contact radius.

    Parameters
    ----------
    radius : array_like
        Contact radii a [length]. If the export has a/h, multiply by the thickness entered at the instrument.
    modulus : array_like
        E_eff = k/(2 a) [modulus]. If it is a reduced modulus, which includes the compliance of the indenter, use
        `Instrument(indenter=...)`. Of a Young's modulus for an assumed nu use E/(1 - nu^2).
    sd : float or array_like, optional
        Standard deviation of the modulus, as in `ForceDepth` [modulus].
    relative_sd : float, optional
        As in `ForceDepth` [1].
    missing : {"raise", "drop"}, optional
        As in `ForceDepth`.

    Raises
    ------
    InvalidArgumentError
        As of `ForceDepth`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> radius = np.linspace(50e-9, 500e-9, 10)
    >>> data = mdr.instruments.ModulusRadius(radius, film.modulus(radius), relative_sd=0.01)
    >>> start = film.with_parameters({"coating.E": 90e9})
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), start, ["coating.E"])
    >>> print(f"{result.estimates['coating.E'] / 1e9:.2f}")
    72.00
    """

    code, x_name, y_name = _layout.FIT_MODULUS_RADIUS, "radius", "modulus"

    def __init__(
        self,
        radius: ArrayLike,
        modulus: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
    ) -> None:
        super().__init__(radius, modulus, None, sd, relative_sd, missing)


class StiffnessRadius(Data):
    """Measured contact stiffness against contact radius.

    Parameters
    ----------
    radius : array_like
        Contact radii a [length].
    stiffness : array_like
        k = dF/dd [modulus length].
    sd : float or array_like, optional
        Standard deviation of the stiffness, as in `ForceDepth` [modulus length].
    relative_sd : float, optional
        As in `ForceDepth` [1].
    missing : {"raise", "drop"}, optional
        As in `ForceDepth`.

    Raises
    ------
    InvalidArgumentError
        As of `ForceDepth`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> radius = np.linspace(50e-9, 500e-9, 10)
    >>> data = mdr.instruments.StiffnessRadius(radius, film.stiffness(radius), relative_sd=0.01)
    >>> start = film.with_parameters({"coating.E": 90e9})
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), start, ["coating.E"])
    >>> print(f"{result.estimates['coating.E'] / 1e9:.2f}")
    72.00
    """

    code, x_name, y_name = _layout.FIT_STIFFNESS_RADIUS, "radius", "stiffness"

    def __init__(
        self,
        radius: ArrayLike,
        stiffness: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
    ) -> None:
        super().__init__(radius, stiffness, None, sd, relative_sd, missing)
