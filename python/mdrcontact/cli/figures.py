# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the commands `curve` and `compare`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from .._units import FORCE, LENGTH, MODULUS, STIFFNESS, Dimension, Unit, practical
from ..loop import Loop
from ..problem import Problem
from ..studies.adhesion import AdhesionResult
from ..studies.compare import CompareResult
from ..studies.curve import CurveResult, Pressure
from ..studies.result import Array
from ..studies.states import Curve, crossing, thickness
from .table import spread_text

# Okabe and Ito's colours: distinct to all eyes. Dashes distinguish what colours no longer do.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
DASHES = ("-", (0, (5, 2)), (0, (1, 1.2)))
_EXACT = {"color": "#000000", "linewidth": 2.6, "zorder": 1.5}
_GREY = "#707070"
_STYLE: dict[Any, Any] = {
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e6e6e6",
    "legend.frameon": False,
    "lines.linewidth": 1.6,
}
_LINEAR = 20.0
"""Values that differ by more than this factor are drawn on a logarithmic axis."""
_COMPARABLE = 10.0
"""A reference curve that ends further away than this factor would only squash the others."""
_FEW = 12
"""States that are marked each."""


def _marks(values: Array, marker: str = "o") -> dict[str, Any]:
    """A few states are points, which the line between them only joins; one of them has no line."""
    return {"marker": marker, "markersize": 3.5} if len(values) <= _FEW else {}


def curve_figure(found: CurveResult) -> Any:
    """Force, radius and stiffness against depth, and pressure distributions."""
    problem, curve = found.problem, found.states
    with sheet(problem.title, 2, 2, (8.4, 6.4)) as (figure, axes):
        depth = practical(LENGTH, curve.depth)
        panels: Sequence[tuple[str, Array, Dimension]] = (
            ("force F", curve.force, FORCE),
            ("contact radius a", curve.radius, LENGTH),
            ("contact stiffness k", curve.stiffness, STIFFNESS),
        )
        for axis, (name, values, dimension) in zip(axes.flat[:3], panels, strict=True):
            unit = practical(dimension, values)
            axis.plot(depth.of(curve.depth), unit.of(values), color=COLOURS[0], label=_model_name(problem), **_marks(values))
            if name.startswith("force"):
                _draw_references(axis, found, depth, unit)
            _mark_thickness(axis, problem, curve, depth, unit, values)
            axis.set(xlabel=f"indentation depth d [{depth.symbol}]", ylabel=f"{name} [{unit.symbol}]")
            # an adhesive contact has negative depths and forces too
            # from 0 on, unless an adhesive curve begins far from it and would fill a corner only
            axis.set_xlim(0.0 if 0.0 <= curve.depth[0] < 0.5 * curve.depth[-1] else None, None)
            axis.set_ylim(0.0 if 0.0 <= axis.dataLim.y0 < 0.5 * values.max() else None, None)
        axes.flat[0].legend()
        if found.pressures:
            _draw_pressures(axes.flat[3], found.pressures, curve)
        else:
            axes.flat[3].set_axis_off()
    return figure


def compare_figure(found: CompareResult) -> Any:
    """Response of every model, its effective modulus against a/h, and the deviation from the reference."""
    problem, answers, values, name = found.problem, found.answers, found.values, found.response
    with sheet(problem.title, 1, 3, (12.0, 4.4)) as (figure, axes):
        given = practical(problem.control.dimension, problem.control.values)
        moduli = np.concatenate([a.curve.modulus for a in answers])
        unit, modulus = practical(found.dimension, values.ravel()), practical(MODULUS, moduli)
        h = thickness(problem.medium)
        radius = practical(LENGTH, np.concatenate([a.curve.radius for a in answers]))
        x = given.of(problem.control.values)
        lines = []
        for i, (answer, value) in enumerate(zip(answers, values, strict=True)):
            look: dict[str, Any] = {"color": COLOURS[i % len(COLOURS)], "linestyle": DASHES[i // len(COLOURS) % len(DASHES)]}
            if answer.model == "exact":
                look = _EXACT
            look = {**look, **_marks(value, "os^"[i // len(COLOURS) % 3])}
            lines += axes[0].plot(x, unit.of(value), **look)
            axes[1].plot(answer.curve.radius / h if h else radius.of(answer.curve.radius), modulus.of(answer.curve.modulus), **look)
            axes[2].plot(x, value / found.base, **look)
        along = f"{problem.control.name} [{given.symbol}]"
        axes[0].set(xlabel=along, ylabel=f"{name} [{unit.symbol}]")
        axes[1].set_xlabel("a/h" if h else f"contact radius a [{radius.symbol}]")
        axes[1].set_ylabel(rf"effective modulus $E_\mathrm{{eff}}$ [{modulus.symbol}]")
        _set_log_x(axes[1])
        axes[2].set(xlabel=along, ylabel=f"{name} / {found.basis}")
        axes[2].set_title(f"spread at the end: {spread_text(found.numbers['spread'].value)}")
        if h:
            axes[1].axvline(1.0, color=_GREY, linewidth=0.8, linestyle=":")
            axes[1].annotate("a = h", (1.0, 0.02), xycoords=("data", "axes fraction"), ha="right", color=_GREY)
        for axis, panel in ((axes[0], values[:, -1]), (axes[1], moduli), (axes[2], values / found.base)):
            if panel.max() > _LINEAR * panel.min():
                axis.set_yscale("log")
        figure.legend(lines, [a.model for a in answers], loc="outside lower center", ncols=min(5, len(answers)))
    return figure


def loop_figure(found: AdhesionResult) -> Any:
    """Force and contact radius along a cycle of approach and retraction."""
    loop = found.loop
    with sheet(found.title, 1, 2, (9.6, 4.2)) as (figure, axes):
        spring = loop.control == "spring"
        x = loop.position if spring else loop.depth
        length, force = practical(LENGTH, x), practical(FORCE, loop.force)
        radius = practical(LENGTH, loop.radius)
        shown = loop._replace(position=length.of(loop.position), depth=length.of(loop.depth), force=force.of(loop.force))
        turn = loop.turning_point
        approach = _part(shown, slice(0, turn + 1), loop.jumps[loop.jumps < turn])
        retract = _part(shown, slice(turn, None), loop.jumps[loop.jumps >= turn] - turn)
        for part, colour, name, width in ((approach, COLOURS[1], "approach", 3.2), (retract, COLOURS[0], "retraction", 1.6)):
            part.plot(axes[0], color=colour, label=name, linewidth=width)
            part._replace(force=radius.of(part.radius)).plot(axes[1], color=colour, linewidth=width)
        if not spring:
            for (name, state), marker in zip(found.pull_offs, "os", strict=False):
                axes[0].plot(length.of(state.depth), force.of(state.force), marker, color="#000000", markersize=5, label=name)
        along = "end of the spring d + F/K" if spring else "indentation depth d"
        axes[0].set(xlabel=f"{along} [{length.symbol}]", ylabel=f"force F [{force.symbol}]")
        axes[1].set(xlabel=f"{along} [{length.symbol}]", ylabel=f"contact radius a [{radius.symbol}]", ylim=(0, None))
        axes[0].axhline(0.0, color=_GREY, linewidth=0.8)
        axes[0].legend()
    return figure


def _part(loop: Loop, part: slice, jumps: Any) -> Loop:
    return loop._replace(
        position=loop.position[part], depth=loop.depth[part], radius=loop.radius[part], force=loop.force[part], jumps=jumps
    )


def _model_name(problem: Problem) -> str:
    model = getattr(problem.medium, "model", None)
    kind = type(problem.medium).__name__.lower()
    return f"{kind}, model “{model}”" if model else kind


def _draw_references(axis: Any, found: CurveResult, depth: Unit, force: Unit) -> None:
    curve = found.states
    dashes = {"coating": (0, (1, 1.5), "^"), "substrate": (0, (5, 2), "s")}
    for name, values in found.references:
        if 1.0 / _COMPARABLE < abs(values[-1] / curve.force[-1]) < _COMPARABLE:
            start, lengths, marker = dashes[name]
            look: dict[str, Any] = {"color": _GREY, "linewidth": 1.0, "linestyle": (start, lengths), **_marks(values, marker)}
            axis.plot(depth.of(curve.depth), force.of(values), label=f"{name} alone", **look)


def _mark_thickness(axis: Any, problem: Problem, curve: Curve, depth: Unit, unit: Unit, values: Array) -> None:
    h = thickness(problem.medium)
    at = crossing(curve, h) if h else None
    if at is None:
        return
    point = depth.of(at), unit.of(np.interp(at, curve.depth, values))
    axis.plot(*point, "o", color=COLOURS[1], markersize=5, zorder=5)
    beside = (7, -11) if point[1] > 0.1 * unit.of(values.max()) else (-24, 9)  # not on the axis of abscissae
    axis.annotate("a = h", point, xytext=beside, textcoords="offset points", color=COLOURS[1])


def _draw_pressures(axis: Any, pressures: Sequence[Pressure], curve: Curve) -> None:
    length = practical(LENGTH, curve.radius)
    depth = practical(LENGTH, curve.depth)
    # the pressure half way to the edge is finite under every tip, and with adhesion says more than the mean one
    highest = 4.0 * max(abs(float(np.interp(0.5 * r[-1], r, p))) for _, r, p in pressures)
    unit = practical(MODULUS, [min(highest, max(float(p.max(initial=0.0)) for _, _, p in pressures))])
    for i, (d, r, p) in enumerate(pressures):
        axis.plot(length.of(r), unit.of(p), color=COLOURS[i % len(COLOURS)], label=f"d = {float(depth.of(d)):.3g} {depth.symbol}")
    axis.set(xlabel=f"distance from the axis r [{length.symbol}]", ylabel=f"contact pressure p [{unit.symbol}]")
    axis.set_xlim(0, None)
    lowest = min(float(p.min(initial=0.0)) for _, _, p in pressures)
    axis.set_ylim(unit.of(max(lowest, -highest)), None)
    if unit.factor * axis.get_ylim()[1] > 1.5 * highest:
        # a cone's apex and a punch's edge have infinite pressure: show the rest
        axis.set_ylim(unit.of(max(lowest, -highest)), unit.of(highest))
    axis.legend()


def _set_log_x(axis: Any) -> None:
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

    axis.set_xscale("log")
    axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
    axis.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.xaxis.set_minor_formatter(NullFormatter())


@contextmanager
def sheet(title: str, rows: int, columns: int, size: tuple[float, float]) -> Iterator[tuple[Any, Any]]:
    """A figure and its panels, to be drawn within: all figures of the command line look alike."""
    import matplotlib
    from matplotlib.figure import Figure

    class Sheet(Figure):
        """Ticks are made when a figure is saved: in its style, too."""

        def savefig(self, *where: Any, **options: Any) -> None:
            with matplotlib.rc_context(_STYLE):
                super().savefig(*where, **options)

    with matplotlib.rc_context(_STYLE):
        figure = Sheet(figsize=size, layout="constrained")
        figure.suptitle(title, parse_math=False)
        yield figure, figure.subplots(rows, columns)
