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
"""Of the readings: so many share their largest value by coarse digits only."""
_FINEST = 1e-15
"""Standard deviation over reading: less is less than the rounding of the reading, and leaves intervals that are none."""
REVERSIBLE, _FEWEST_FOR_SLOPE = 0.05, 5
"""How near to 1 the rise of the force over the integral of the stiffness must be, and from how many points on it says something."""
_RETURN = 0.2
"""A curve whose x goes back over this part of its range holds loading and unloading."""


class Data:
    """Points (x, y), checked; `sd` are the standard deviations of y, None if they are unknown and equal."""

    code: ClassVar[int]
    x_name: ClassVar[str]
    y_name: ClassVar[str]
    given_name: ClassVar[str] = ""
    """what else is known of each point"""
    contact_points: Mapping[str, float] = MappingProxyType({})
    """depth of first contact by each estimator that has looked at the record"""
    pulls: Mapping[str, float] = MappingProxyType({})
    """what the record shows without a model: forces of "jump-in" and "pull-off", depth of the "last rupture", "energy lost" """
    tests: NDArray[np.intp] | None = None
    """which test each point belongs to, where there are several"""
    also_free: tuple[str, ...] = ()
    """numbers of the instrument that a fit finds beside those that it names"""

    def __init__(
        self, x: ArrayLike, y: ArrayLike, given: ArrayLike | None, sd: ArrayLike | None, relative_sd: float | None, missing: str
    ) -> None:
        if missing not in ("raise", "drop"):
            raise InvalidArgumentError(f"missing = {missing!r}: choose from 'raise', 'drop'")
        if sd is not None and relative_sd is not None:
            raise InvalidArgumentError("sd and relative_sd say the same thing twice: keep one")
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
        """Positions of the points along the curve: by branch, and within a branch by ascending x."""
        branch = np.zeros(len(self)) if self.branch is None else self.branch
        return np.lexsort((self.x, branch))

    def with_y(self: Self, y: Array) -> Self:
        """The same points with other values, for simulations."""
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
        """Refuses a curve that goes back over itself. Else the order of the points does not matter."""
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
    """Elastic force-depth curve: loading, unloading, or both, baseline and pull-off included.

    depth, force : what the instrument reads [length], [modulus length^2]; n numbers each
    branch : "loading" or "unloading", for all points or one for each; None: a curve whose depth rises and falls again turns where
        it is deepest. Matters with adhesion: on each branch the readings say where contact begins or ends, and the model is held
        against both parts
    sd : standard deviation of the force, a number or n numbers; relative_sd: the same as a part of the force. Without either it is
        estimated from the scatter about the fit, and taken to be the same for all points
    missing : "raise" or "drop" rows with NaN or infinity
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
                raise InvalidArgumentError(f"branch has {len(words)} entries and depth {np.size(depth)}: they must be as many")
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
        """The points of one branch, "loading" or "unloading"; all points of a curve that has one branch only."""
        if branch not in BRANCHES:
            raise InvalidArgumentError(f"branch = {branch!r}: choose from 'loading', 'unloading'")
        if self.branch is None:
            return self
        keep = self.branch == BRANCHES[branch]
        return ForceDepth(self.x[keep], self.y[keep], sd=None if self.sd is None else self.sd[keep], branch=branch)


class UnloadingPoint(NamedTuple):
    """What one unloading curve says: P = B (h - h_f)^m in its upper part, and S = dP/dh where it begins."""

    depth: float
    """at the beginning of unloading, h_max"""
    force: float
    """there, P_max"""
    stiffness: float
    stiffness_error: float
    """standard error, widened for correlated residuals"""
    final_depth: float
    """h_f"""
    exponent: float
    """m"""
    fitted_depth: Array
    fitted_force: Array
    warnings: tuple[str, ...]


class StiffnessDepth(Data):
    """Contact stiffness against depth: dynamic (CSM) nanoindentation. The contact radius of each point is that of the tip at the
    contact depth h - sigma P/S, where sigma P/S is how far the surface sinks in at the edge of the exact contact: plastic contacts
    are fine as long as they do not pile up.

    depth, force, stiffness : h [length], P [modulus length^2], S [modulus length]; n numbers each
    sd, relative_sd : of the stiffness, as in ForceDepth
    elastic : True: nothing has yielded, and the surface sinks in as under the indenter itself; False: it sinks in as under the
        smooth indenter that `Instrument(contact_depth_factor=...)` stands for; None: True where the force rises along the curve as
        the stiffness says, dP/dh = S to 5 %, unless the instrument's contact depth is changed
    """

    code, x_name, y_name, given_name = _layout.FIT_STIFFNESS_DEPTH, "depth", "stiffness", "force"
    unloadings: tuple[UnloadingPoint, ...] = ()
    record: tuple[Array, Array] | None = None
    """depth and force of the whole test, where the stiffness is that of unloading curves"""
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
        self.seems_elastic = abs(self._reversibility() - 1.0) < REVERSIBLE

    def _reversibility(self) -> float:
        """The rise of the force over the integral of the stiffness, 1 where the contact is elastic, whatever body, tip, frame and
        offsets are; 0 where the points are too few to say."""
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
    """Effective contact modulus against contact radius, as instruments export it.

    radius : contact radius a [length]; where the export has a/h, multiply with the thickness entered at the instrument
    modulus : E_eff = k/(2a) [modulus]. If the indenter's own compliance is still in it (reduced modulus), say
        Instrument(indenter=...). A Young's modulus that was printed for an assumed nu: E_eff = E/(1 - nu^2)
    sd, relative_sd : of the modulus, as in ForceDepth
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
    """Contact stiffness against contact radius.

    radius, stiffness : a [length], k = dF/dd at constant a [modulus length]; n numbers each
    sd, relative_sd : of the stiffness, as in ForceDepth
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
