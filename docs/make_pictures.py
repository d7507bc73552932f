# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of the guide, all from what the library computes. python docs/make_pictures.py [FOLDER] [--quick]

FOLDER is docs/pictures by default. --quick computes maps on coarse grids. The pictures of fit.md have a script of their
own. The code of the tutorials draws theirs.
"""

from __future__ import annotations

import argparse
import atexit
import functools
import io
import os
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator
from PIL import Image

import mdrcontact as mdr
from mdrcontact import studies
from mdrcontact.conduction import Conduction, Conductor, LayeredConductor
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.panels.matplotlib import draw

BLUE, RED, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#7f7f7f"
COLOURS = (BLUE, RED, GREEN, "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8B4513", "#7f7f7f", "#bcbd22")
EXAMPLES = Path(__file__).resolve().parent.parent / "examples" / "problems"
UM = 1e6

OXIDE, SILICON = mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22)


def indenters(quick: bool) -> Any:
    """f(r) and g(x) of every shape with a name."""
    r = np.linspace(0.0, 2e-6, 21)
    shapes = [
        ("Paraboloid(2e-6)", mdr.Paraboloid(2e-6)),
        ("Sphere(2e-6)", mdr.Sphere(2e-6)),
        ("Cone(0.4)", mdr.Cone(0.4)),
        ("PowerLaw(4.0, 1e17)", mdr.PowerLaw(4.0, 1e17)),
        ("FlatPunch(1e-6)", mdr.FlatPunch(1e-6)),
        ("FlatEndedCone(0.5e-6, 0.4)", mdr.FlatEndedCone(0.5e-6, 0.4)),
        ("FlatEndedParaboloid(0.5e-6, 2e-6)", mdr.FlatEndedParaboloid(0.5e-6, 2e-6)),
        ("RoundedCone(0.5e-6, 0.4)", mdr.RoundedCone(0.5e-6, 0.4)),
        ("Berkovich(), Vickers()", mdr.Berkovich()),
        ("CubeCorner()", mdr.CubeCorner()),
        ("AreaFunction([24.5, 1.5e-6], max_height=1e-6)", mdr.AreaFunction([24.5, 1.5e-6], max_height=1e-6)),
        ("TabulatedProfile(r, f)", mdr.TabulatedProfile(r, 0.04e-6 * (1.0 - np.cos(4e6 * r)) + 0.4 * r)),
    ]
    figure, axes = plt.subplots(4, 3, figsize=(9.0, 8.6), sharex=True, sharey=True, layout="constrained")
    for axis, (name, shape) in zip(axes.flat, shapes, strict=True):
        x = np.linspace(0.0, 1.75e-6, 60 if quick else 400)
        x = x[x <= 1e-6] if isinstance(shape, mdr.FlatPunch) else x
        f, g = shape.height(x), shape.mdr(x)
        if isinstance(shape, mdr.FlatPunch):
            x, f, g = (np.append(array, end) for array, end in ((x, 1e-6), (f, 1.3e-6), (g, 1.3e-6)))
        axis.plot(UM * np.append(-x[::-1], x), UM * np.append(f[::-1], f), color=BLUE, label="f(r)")
        axis.plot(UM * np.append(-x[::-1], x), UM * np.append(g[::-1], g), color=RED, linestyle="--", label="g(x)")
        axis.set_title(name, fontsize=9, family="monospace")
        axis.spines[["top", "right"]].set_visible(False)
    axes[0, 0].set(xlim=(-1.9, 1.9), ylim=(-0.05, 1.3))
    axes[0, 0].legend(frameon=False, loc="upper center")
    for axis in axes[-1]:
        axis.set_xlabel("r, x [µm]")
    for axis in axes[:, 0]:
        axis.set_ylabel("f, g [µm]")
    return figure


def springs(quick: bool) -> Any:
    """The idea: a paraboloid on a half-space, and its g(x) on independent springs."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(0.75, 0.5)))
    state = contact.at_radius(0.5)
    a, d = float(state.radius), float(state.depth)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.0), sharex=True, sharey=True, layout="constrained")
    r = np.linspace(-1.2, 1.2, 61 if quick else 401)
    surface = -np.asarray(contact.at_radius(a).displacement(np.abs(r)))
    left.fill_between(r, surface, -0.85, color="#e3e8ee")
    left.plot(r, surface, color="#1c2430", linewidth=1.0)
    left.plot(r, r**2 / 2.0 - d, color=BLUE)
    left.set(title="three dimensions: $f(r)$ on a half-space", xlabel="$r/R$", ylabel="height$/R$")
    left.set(xlim=(-1.2, 1.2), ylim=(-0.85, 0.45))
    for x in np.linspace(-1.1, 1.1, 23):
        top = min(x**2 - d, 0.0)
        y = np.linspace(-0.62, top, 9)
        right.plot(x + 0.012 * np.array([0, 0, 1, -1, 1, -1, 1, 0, 0]), y, color=GREY, linewidth=0.9)
    right.axhspan(-0.85, -0.62, color="#e3e8ee")
    right.plot(r, np.minimum(r**2 - d, 1.0), color=RED)
    right.axhline(0.0, color="#1c2430", linewidth=0.8, linestyle=":")
    right.set(title="one dimension: $g(x)$ on independent springs", xlabel="$x/R$")
    for axis in (left, right):
        arrow = {"arrowstyle": "<->", "color": "#1c2430", "shrinkA": 0, "shrinkB": 0}
        axis.annotate("", (a, -0.74), (0.0, -0.74), arrowprops=arrow)
        axis.text(a + 0.05, -0.74, "$a$", va="center")
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def media(quick: bool) -> Any:
    """E_eff(a/h) of one coated body under every model, stiff on soft and soft on stiff."""
    ratio = np.geomspace(0.03, 30.0, 20 if quick else 120)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.9), sharex=True, layout="constrained")
    for axis, E0 in zip(axes, (5.0, 0.2), strict=True):
        exact = mdr.Coated(mdr.Elastic(E0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "exact")
        axis.plot(ratio, exact.modulus(ratio) * (1 - 0.3**2), color="#c3ccd6", linewidth=7, label="exact")
        for colour, model in zip(COLOURS, _elastic_models(), strict=True):
            axis.plot(ratio, exact.with_model(model).modulus(ratio) * (1 - 0.3**2), color=colour, linewidth=1.1, label=model)
        axis.set(xscale="log", yscale="log", xlabel="$a/h$", title=f"$E_0/E_1$ = {E0:g}")
        axis.spines[["top", "right"]].set_visible(False)
        ticks = [0.2, 0.3, 0.5, 1.0] if E0 < 1 else [1, 2, 3, 5]
        axis.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
        axis.minorticks_off()
    axes[0].set_ylabel("$E_\\mathrm{eff}/E^*_1$")
    axes[1].legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def accuracy(quick: bool) -> Any:
    """Errors of E_eff and F of every model of a coating on an elastic substrate."""
    models = _elastic_models()
    n = 9 if quick else 33
    result = mdr.accuracy_map(np.geomspace(0.01, 100.0, n), np.geomspace(0.03, 30.0, n), models)
    levels = (-50, -20, -10, -5, -2, 2, 5, 10, 20, 50)
    colours = plt.get_cmap("RdBu_r")(np.linspace(0.02, 0.98, len(levels) + 1))
    figure, axes = plt.subplots(4, 5, figsize=(9.2, 7.8), sharex=True, sharey=True, layout="constrained")
    for i, model in enumerate(models):
        for j, errors in enumerate((result.modulus_error, result.force_error)):
            axis = axes[2 * (i // 5) + j, i % 5]
            percent = 100.0 * errors[i]
            shown = axis.contourf(result.radius_ratio, result.modulus_ratio, percent, levels, colors=colours, extend="both")
            axis.set(xscale="log", yscale="log")
            axis.set_title(f"{model}\n" + ("error of $E_\\mathrm{eff}$", "error of $F$")[j], fontsize=8)
    for axis in axes[-1]:
        axis.set_xlabel("$a/h$")
    for axis in axes[:, 0]:
        axis.set_ylabel("$E_0/E_1$")
    bar = figure.colorbar(shown, ax=axes, ticks=levels, aspect=40, pad=0.01)
    bar.set_label("error against exact [%]; white: within 2 %")
    return figure


def adhesion(quick: bool) -> Any:
    """A loop of an AFM cantilever on a rubber film: branch, jumps, pull-off."""
    film = mdr.Coated(mdr.Elastic(2e6, 0.5), 1e-6, mdr.Elastic(70e9, 0.23), model="exact")
    contact = mdr.Contact(mdr.Paraboloid(2e-6), film, work_of_adhesion=0.05)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for axis, control, largest, words in (
        (axes[0], "depth", 80e-9, "indentation depth prescribed"),
        (axes[1], "spring", 400e-9, "far end of a spring of 1 N/m prescribed"),
    ):
        spring = {"spring_stiffness": 1.0} if control == "spring" else {}
        loop = contact.loop(control, largest=largest, points=40 if quick else 300, **spring)
        turn = loop.turning_point
        axis.plot(1e9 * loop.position[: turn + 1], 1e6 * loop.force[: turn + 1], color=BLUE, label="approach")
        axis.plot(1e9 * loop.position[turn:], 1e6 * loop.force[turn:], color=RED, label="retraction")
        axis.axhline(0.0, color=GREY, linewidth=0.7)
        axis.set(xlabel=("depth" if control == "depth" else "position of the spring's end") + " [nm]", title=words)
        axis.spines[["top", "right"]].set_visible(False)
    axes[0].set_ylabel("force [µN]")
    axes[0].legend(frameon=False)
    return figure


def adhesion_range(quick: bool) -> Any:
    """From JKR to DMT on a film: F(d) with all equilibria, and the pressure around one contact radius."""
    film = mdr.Coated(mdr.Elastic(2e6, 0.5), 1e-6, mdr.Elastic(70e9, 0.23), model="exact")
    tip = mdr.Paraboloid(2e-6)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    count = 30 if quick else 200
    for stress, colour in ((0.1e6, GREEN), (0.4e6, RED), (2e6, BLUE)):
        contact = mdr.Contact(tip, film, work_of_adhesion=0.05, cohesive_stress=stress)
        states = contact.at_radius(np.linspace(0.0, 1.3e-6, count))
        (line,) = axes[0].plot(1e9 * states.depth, 1e6 * states.force, color=colour, label=f"{1e-6 * stress:g} MPa")
        touch = contact.at_radius(0.0)
        depth = np.linspace(contact.pull_off("depth").depth, float(touch.depth), count)
        if contact.pull_off("depth").radius == 0.0:
            apart = contact.at_depth(depth)
            axes[0].plot(1e9 * apart.depth, 1e6 * apart.force, color=line.get_color(), linestyle="--")
        axes[0].plot(1e9 * touch.depth, 1e6 * touch.force, "o", color=colour, markersize=4)
        state = contact.at_radius(1e-6)
        r = np.linspace(0.0, float(state.zone_radius), 400)
        axes[1].plot(1e6 * np.append(r, r[-1]), 1e-3 * np.append(state.pressure(r), 0.0), color=colour)
    states = mdr.Contact(tip, film, work_of_adhesion=0.05).at_radius(np.linspace(0.0, 1.3e-6, count))
    axes[0].plot(1e9 * states.depth, 1e6 * states.force, color=GREY, linewidth=1.0, label="JKR limit")
    axes[0].set(
        xlabel="depth [nm]",
        ylabel="force [µN]",
        title="equilibrium curves",
        xlim=(-550, 250),
        ylim=(-0.8, 0.6),
    )
    axes[0].legend(frameon=False, title="cohesive stress")
    axes[1].set(xlabel="r [µm]", ylabel="pressure [kPa]", title="pressure at $a$ = 1 µm", ylim=(-2200, 1250))
    for axis in axes:
        axis.axhline(0.0, color=GREY, linewidth=0.7)
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def stress(quick: bool) -> Any:
    """Largest principal stress and von Mises stress in a TiN coating on steel under a sliding ball."""
    contact = mdr.Contact(mdr.Paraboloid(1e-3), mdr.Coated(mdr.Elastic(450e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.30)))
    state = contact.at_radius(4e-6)
    x = np.linspace(-8e-6, 8e-6, 41 if quick else 161)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.0), layout="constrained", sharey=True)
    parts = (np.linspace(1e-9, 2e-6 * (1 - 1e-9), 40), np.linspace(2e-6 * (1 + 1e-9), 6e-6, 40))
    # x < 0 lies on the other side of the axis
    fields = [state.interior(abs(x)[:, None], z, friction=0.1, angle=np.where(x < 0, np.pi, 0)[:, None]) for z in parts]
    for axis, name in zip(axes, ("von Mises stress", "largest principal stress"), strict=True):
        values = [f.von_mises if name.startswith("von") else f.principal[..., 0] for f in fields]
        top = 0.05 * np.ceil(max(float(v.max()) for v in values) / 0.05e9)
        levels = np.arange(0.0, top + 0.01, 0.05) if name.startswith("von") else np.arange(-top, top + 0.01, 0.025)
        colours, ends = ("viridis", "neither") if name.startswith("von") else ("RdBu_r", "min")
        for z, value in zip(parts, values, strict=True):
            drawn = axis.contourf(x / 1e-6, z / 1e-6, value.T / 1e9, levels, cmap=colours, extend=ends)
        axis.axhline(2.0, color="white" if levels[0] == 0.0 else "black", linewidth=0.9)
        axis.plot([-4.0, 4.0], [0.0, 0.0], color="black", linewidth=5.0, solid_capstyle="butt", clip_on=False)
        axis.set(xlabel="x [µm]", ylim=(6.0, 0.0), aspect="equal")
        figure.colorbar(drawn, ax=axis, ticks=MaxNLocator(6), shrink=0.62).set_label(f"{name}\n[GPa]")
    axes[0].set(ylabel="depth z [µm]")
    return figure


def gels(quick: bool) -> Any:
    """Relaxation of a flat punch on a gel under the three drainages, with the undrained and the drained limit, and its tails."""
    tau = np.geomspace(1e-4, 1e3, 60 if quick else 300)
    nu = 0.2
    contact = mdr.Contact(mdr.FlatPunch(1.0), mdr.Homogeneous(mdr.poroelastic.Poroelastic(1.0, nu, 1.0)))
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for drainage, colour in zip(("surface", "indenter", "sealed"), (BLUE, RED, GREEN), strict=True):
        force = np.asarray(contact.relaxation(tau, drainage=drainage)) / 8.0
        axes[0].semilogx(tau, force, color=colour, label=f'"{drainage}"')
        axes[1].loglog(tau, (force - 0.5 / (1.0 - nu)) / (1.0 - 0.5 / (1.0 - nu)), color=colour)
    axes[0].axhline(1.0, color=GREY, linestyle="--", linewidth=1.0)
    axes[0].axhline(0.5 / (1.0 - nu), color=GREY, linestyle="--", linewidth=1.0)
    axes[0].text(9e2, 0.99, "undrained, $8Gad$", color=GREY, va="top", ha="right", fontsize=8)
    axes[0].text(1.5e-4, 0.63, "drained, $4Gad/(1-\\nu)$", color=GREY, va="bottom", fontsize=8)
    axes[0].set(xlabel="$Dt/a^2$", ylabel="$F/(8Gad)$", title="flat punch, step of depth, $\\nu$ = 0.2")
    axes[0].legend(frameon=False)
    axes[1].loglog(tau[tau > 3.0], 0.3 * tau[tau > 3.0] ** -0.5, color=GREY, linestyle=":", label="slope -1/2")
    axes[1].set(xlabel="$Dt/a^2$", ylabel="relaxing part of the force", title="decay", ylim=(2e-3, 1.3))
    axes[1].legend(frameon=False)
    for axis in axes:
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def wear(quick: bool) -> Any:
    """A ball that wears on a coating: its profile, the pressure, radius and depth with the distance, and where fretting ends."""
    body = mdr.Coated(mdr.Elastic(0.91, 0.3), 1.0, mdr.Elastic(0.091, 0.3))
    contact = mdr.Contact(mdr.Paraboloid(1.0), body)
    state = contact.at_radius(1.0)
    worn = mdr.wear.Wear(contact, 1.0)
    r = np.linspace(0.0, 2.2, 60 if quick else 300)
    figure, axes = plt.subplots(1, 4, figsize=(13.0, 3.2), layout="constrained")
    history = worn.history(force=state.force, intervals=40 if quick else 80)
    for distance, colour in zip((0.0, 0.3, 3.0), (GREY, BLUE, RED), strict=True):
        if distance:
            history.advance(distance - history.state.sliding, force=state.force)
        lost = history.profile.worn_depth(r) if distance else 0.0 * r
        axes[0].plot(r, contact.indenter.height(r) + lost, color=colour, label=f"{distance:g}")
        axes[1].plot(r, history.pressure(r), color=colour)
    s = np.geomspace(1e-2, 10.0, 8 if quick else 30)
    states, _ = worn.advance(s, force=state.force, intervals=40 if quick else 80)
    axes[2].semilogx(s, states.radius, color=BLUE, label="radius a")
    axes[2].semilogx(s, states.depth, color=RED, label="depth d")
    axes[2].semilogx(s, states.worn_depth, color=GREEN, label="worn depth")
    for c, colour in ((0.8, GREEN), (0.5, BLUE), (0.2, RED)):
        end = worn.limit(state, c)
        axes[3].plot(r, end.profile.height(r), color=colour, label=f"c = {c:g} a")
    axes[3].plot(r, contact.indenter.height(r), color=GREY, linestyle=":")
    axes[0].set(xlabel="$r/h$", ylabel="profile$/h$", ylim=(0.0, 2.0))
    axes[0].legend(title="$k_w E_0^* s/h$", frameon=False)
    axes[1].set(xlabel="$r/h$", ylabel="pressure $p/E_0^*$")
    axes[2].set(xlabel="$k_w E_0^* s/h$", ylabel="length$/h$")
    axes[3].set(xlabel="$r/h$", ylabel="limiting profile$/h$", ylim=(0.0, 2.4))
    for axis in axes[2:]:
        axis.legend(frameon=False)
    for axis in axes:
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def coatings(quick: bool) -> Any:
    """A graphite layer and its isotropic readings; a film on compliant interfaces; a skin under stress: modulus against radius."""
    figure, axes = plt.subplots(1, 3, figsize=(12.0, 3.2), layout="constrained")
    a = np.geomspace(0.03, 30.0, 20 if quick else 80)
    graphite, silicon = mdr.CRYSTALS["graphite"].material, mdr.Elastic(163e9, 0.22)
    E = graphite.contact_modulus * (1.0 - 0.25**2)
    for nu, style in ((0.0, "--"), (0.25, ":"), (0.49, "-.")):
        reading = mdr.Coated(mdr.Elastic(E / (1.0 - 0.25**2) * (1.0 - nu**2), nu), 1.0, silicon)
        axes[0].loglog(a, reading.modulus(a) / 1e9, color=GREY, linestyle=style, label=f"isotropic, nu = {nu:g}")
    axes[0].loglog(a, mdr.Coated(graphite, 1.0, silicon).modulus(a) / 1e9, color=RED, label="graphite")
    film, base = mdr.Elastic(300.0, 0.25), mdr.Elastic(70.0, 0.2)
    for below, label, colour in (
        (None, "bonded", BLUE),
        (mdr.Interface(tangential=3.0), "K_t h = 0.01 E", GREEN),
        (mdr.SLIDING, "sliding", RED),
        (mdr.Interface(normal=30.0, tangential=3.0), "and K_n h = 0.1 E", GREY),
    ):
        body = mdr.Layered([mdr.Layer(film, 1.0, interface=below)], base)
        axes[1].semilogx(a, body.modulus(a) / film.contact_modulus, color=colour, label=label)
    skin, soft = mdr.Elastic(1e3, 0.3), mdr.Elastic(1.0, 0.5)
    wrinkles = mdr.Layered([(skin, 1.0)], soft).wrinkling().stress
    wide = np.geomspace(0.3, 300.0, len(a))
    for part, colour in ((0.7, RED), (0.0, GREY), (-1.0, GREEN), (-10.0, BLUE)):
        body = mdr.Layered([mdr.Layer(skin, 1.0, prestress=part * wrinkles)], soft)
        axes[2].loglog(wide, body.modulus(wide), color=colour, label=f"{-part:g}" if part else "0")
    axes[0].set(xlabel="$a/h$", ylabel="$E_\\mathrm{eff}$ [GPa]", title="graphite on silicon")
    axes[1].set(xlabel="$a/h$", ylabel="$E_\\mathrm{eff}/E_0^*$", title="compliant interface")
    axes[2].set(xlabel="$a/h$", ylabel="$E_\\mathrm{eff}/E_1^*$", title="residual stress")
    for axis, title in zip(axes, (None, None, "stress/|wrinkling stress|"), strict=True):
        axis.legend(title=title, frameon=False, fontsize="small")
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def rate(quick: bool) -> Any:
    """Retract curves of a rubber at three speeds, with what is fitted to all of them; pull-off against speed, with the fit."""
    tip, body = mdr.Paraboloid(20e-6), mdr.Homogeneous(mdr.Elastic(1e6, 0.5))
    contact, random = mdr.Contact(tip, body, adhesion=mdr.adhesion.RateAdhesion(0.05, 1e-6, 0.4)), np.random.default_rng(4)
    curves = []
    for speed in (1e-7, 1e-6, 1e-5):
        time = np.linspace(0.0, 4.6e-6 / speed, 120)
        position = 2e-6 - speed * time
        force = mdr.adhesion.rate_history(contact, time, position=position, spring_stiffness=20.0, start="rest").force
        curves.append(mdr.instruments.RateCurve(time, position, force + 3e-7 * random.standard_normal(120), 20.0))
    fit = mdr.instruments.fit_rate(curves, contact, ["E", "work", "speed", "exponent"])
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for curve, model, colour in zip(curves, fit.fitted, (BLUE, RED, GREEN), strict=True):
        axes[0].plot(1e6 * curve.position, 1e6 * curve.force, ".", color=colour, markersize=3.0)
        axes[0].plot(1e6 * curve.position[: curve.count], 1e6 * model, color=colour, label=f"{1e6 * curve.speed:g} µm/s")
    axes[0].set(xlabel="position of the spring's end [µm]", ylabel="force [µN]", title="retraction, joint fit")
    axes[0].legend(frameon=False)
    panel = fit.plot(points=8 if quick else 40).panels[0]
    for part in panel.parts:
        axes[1].loglog(part.x, part.y, part.marker or "-", label=part.name)
    axes[1].set(xlabel=panel.x.title, ylabel=panel.y.title, title="pull-off")
    axes[1].legend(frameon=False)
    for axis in axes:
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def pyramids(quick: bool) -> Any:
    """Force and modulus of a film under pyramids, over those of the equivalent cone, against a/h."""
    ratio = np.geomspace(0.1, 10.0, 9 if quick else 49)
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for contrast, colour in zip((0.1, 1.0, 3.0, 10.0, 100.0), (BLUE, GREY, GREEN, RED, "#CC79A7"), strict=True):
        body = mdr.Coated(mdr.Elastic(contrast, 0.3), 1.0, mdr.Elastic(1.0, 0.3))
        for tip, style in ((mdr.Berkovich(), "-"), (mdr.Vickers(), "--")):
            found = mdr.instruments.pyramid_correction(tip, body, ratio)
            label = f"$E_0^*/E_1^*$ = {contrast:g}" if style == "-" else None
            axes[0].semilogx(ratio, found.force, style, color=colour, label=label)
            axes[1].loglog(ratio, 1.0 / np.asarray(found.film_modulus), style, color=colour)
    axes[0].set(xlabel="$a/h$", ylabel="$F/F_\\mathrm{cone}$")
    axes[1].set(xlabel="$a/h$", ylabel="$E_0$ fitted as a cone / $E_0$", ylim=(0.8, 5.0))
    axes[1].set_yticks([1.0, 2.0, 5.0], ["1", "2", "5"])
    axes[0].legend(frameon=False, fontsize=8)
    _letter(figure)
    for axis in axes:
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def conduction(quick: bool) -> Any:
    """Temperatures in a section under a ball that frets on a hard carbon coating, and conductance against two rules."""
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.4), layout="constrained")
    film, steel = mdr.Elastic(150e9, 0.2, Conductor(1.0)), mdr.Elastic(210e9, 0.3, Conductor(45.0))
    body = mdr.Coated(film, 2e-6, steel)
    contact = mdr.Contact(mdr.Paraboloid(3e-3), mdr.Pair(body, mdr.Homogeneous(steel)))
    heat = Conduction(contact.medium).friction_heat(contact.at_radius(6e-6), 0.15, 1.0)
    x, z = np.linspace(0.0, 12.0, 25 if quick else 97), np.linspace(0.0, 6.0, 19 if quick else 73)
    half = np.asarray(heat.temperature(1e-6 * x[None, :], 1e-6 * z[:, None]))
    drawn = axes[0].contourf(np.r_[-x[:0:-1], x], z, np.hstack([half[:, :0:-1], half]), levels=20, cmap="inferno")
    axes[0].axhline(2.0, color="white", linewidth=1.0)
    axes[0].text(-11.5, 1.8, "DLC", color="white", fontsize=8)
    axes[0].text(-11.5, 2.8, "steel", color="white", fontsize=8)
    axes[0].plot([-6.0, 6.0], [0.0, 0.0], color=BLUE, linewidth=4.0, clip_on=False)
    axes[0].set(xlabel="x [µm]", ylabel="depth z [µm]", ylim=(6.0, 0.0), title="friction 0.15, speed 1 m/s")
    figure.colorbar(drawn, ax=axes[0], shrink=0.9, ticks=MaxNLocator(6)).set_label("temperature rise [K]")
    a = np.geomspace(0.05, 30.0, 40 if quick else 150)
    coated = LayeredConductor([(Conductor(9.17), 1.0)], Conductor(59.6))
    exact = np.asarray(Conduction(coated).at_radius(a).conductance)
    axes[1].loglog(a, exact, color=BLUE, label="exact")
    axes[1].loglog(a, 4.0 * 59.6 * a, color=RED, linestyle="--", label="substrate alone, $4\\kappa a$")
    axes[1].loglog(
        a,
        1.0 / (1.0 / (np.pi * a**2 * 9.17) + 1.0 / (4.0 * 59.6 * a)),
        color=GREEN,
        linestyle=":",
        label="film and substrate in series",
    )
    axes[1].set(xlabel="$a/h$", ylabel="conductance$/h$ [MS/m]", title="contact on tinned copper")
    axes[1].legend(frameon=False, fontsize=8)
    axes[1].spines[["top", "right"]].set_visible(False)
    return figure


@functools.cache
def rough(quick: bool) -> Any:
    """A rough surface on a substrate, and on a coating on it; nothing without the engine."""
    try:
        from mdrcontact.interop.contactmechanics import LayeredSubstrate
    except mdr.MDRError:
        return None
    from SurfaceTopography.Generation import fourier_synthesis

    points, size, load = 64 if quick else 256, 2e-6, 50e6
    np.random.seed(0)
    topography = fourier_synthesis((points, points), (size, size), 0.8, rms_slope=0.1, long_cutoff=0.5e-6, short_cutoff=0.06e-6)
    polymer, hard = mdr.Elastic(2e9, 0.35), mdr.Elastic(10e9, 0.3)
    bodies = mdr.Homogeneous(polymer), mdr.Coated(hard, 50e-9, polymer)
    figure, axes = plt.subplots(1, 3, figsize=(9.0, 3.1), layout="constrained")
    extent = (0.0, UM * size, 0.0, UM * size)
    image = axes[0].imshow(1e9 * topography.heights().T, cmap="gray", origin="lower", extent=extent)
    figure.colorbar(image, ax=axes[0], shrink=0.7, label="height [nm]")
    for axis, body in zip(axes[1:], bodies, strict=True):
        substrate = LayeredSubstrate(body, (points, points), (size, size), mean=0.0)
        guess = substrate.first_guess(topography, 0.0)
        system = topography.make_contact_system(substrate=substrate)
        forces = system.minimize_proxy(external_force=load * size**2, initial_forces=guess, pentol=1e-13)
        pressure = forces.jac / substrate.area_per_pt
        image = axis.imshow(1e-6 * np.where(pressure > 0.0, pressure, np.nan).T, origin="lower", extent=extent)
        figure.colorbar(image, ax=axis, shrink=0.7, label="p [MPa]")
    for axis, letter in zip(axes, "abc", strict=True):
        axis.set(xlabel="x [µm]", ylabel="y [µm]")
        axis.set_title(f"({letter})", loc="left", fontsize=10)
    return figure


def _reader_of(page: str) -> tuple[dict[str, Any], Path]:
    """A reader of a page: the variables after its Python blocks, and the folder in which they ran, with the files of the page."""
    text = (Path(__file__).resolve().parent / page).read_text(encoding="utf-8")
    variables: dict[str, Any] = {"__name__": "__main__"}
    before = Path.cwd()
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder)
    os.chdir(folder)
    try:
        for language, file, block in re.findall(r"^```(\w+)(?: file=(\S+))?\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE):
            if file:
                (folder / file).write_text(block, encoding="utf-8")
            if language == "python":
                exec(block, variables)
    finally:
        os.chdir(before)
    return variables, folder


def plastic(quick: bool) -> Any:
    """An indent in a film, as `mdrcontact imprint --plot` draws it."""
    return draw(studies.imprint(mdr.problem.load(EXAMPLES / "aluminium_on_silicon.toml")).figure())


def tutorial_curve(quick: bool) -> Any:
    """Force-depth curves of a film and its materials, and the pressure."""
    figure = _reader_of("tutorial-python.md")[0]["figure"]
    _letter(figure)
    return figure


def tutorial_inside(quick: bool) -> Any:
    """Von Mises stress in a section of the film."""
    return _reader_of("tutorial-python.md")[0]["figure_inside"]


def tutorial_indent(quick: bool) -> Any:
    """The record of an indent and the fit of its unloading curve, as `mdrcontact fit --plot` draws them."""
    _, folder = _reader_of("tutorial-nanoindentation.md")
    problem = load_fit_file(folder / "film.toml")
    data, _ = problem.read_data(folder / "indent.txt")
    return draw(mdr.instruments.fit(data, **problem.arguments).plot())


def tutorial_afm(quick: bool) -> Any:
    """Three fits of a retraction curve on a soft film, and that of a relaxing film."""
    figure = _reader_of("tutorial-afm.md")[0]["figure"]
    _letter(figure)
    return figure


def tutorial_dem(quick: bool) -> Any:
    """Five coated balls collide: their speeds, and the error of the energy for two time steps."""
    ball = mdr.Coated(mdr.Elastic(3e9, 0.35), 20e-6, mdr.Elastic(210e9, 0.3))
    law = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(0.5e-3), mdr.Pair(ball, ball)), 10e-6)
    mass, balls = 7850.0 * 4.18879e-9, 5
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    for step, colour in ((1e-7, BLUE), (0.5e-7, RED)):
        x, v, force = 2e-3 * np.arange(balls), np.zeros(balls), np.zeros(balls + 1)
        v[0] = 0.1
        speeds, errors = [v.copy()], [0.0]
        for _ in range(round(1.2e-4 / step)):
            v += 0.5 * step * -np.diff(force) / mass
            x += step * v
            overlap = 2e-3 - np.diff(x)
            force[1:-1] = law.force(overlap)
            v += 0.5 * step * -np.diff(force) / mass
            speeds.append(v.copy())
            errors.append((np.sum(law.energy(overlap)) + 0.5 * mass * np.sum(v**2)) / (0.5 * mass * 0.01) - 1.0)
        time = 1e6 * step * np.arange(len(speeds))
        right.plot(time, 1e6 * np.array(errors), color=colour, linewidth=1.0, label=f"step {1e6 * step:g} µs")
    for i, colour in zip(range(balls), COLOURS, strict=False):
        left.plot(time, 1e3 * np.array(speeds)[:, i], color=colour, label=f"ball {i + 1}")
    left.set(xlabel="time t [µs]", ylabel="speed v [mm/s]")
    right.set(xlabel="time t [µs]", ylabel="relative error of the energy [$10^{-6}$]")
    left.legend(frameon=False)
    right.legend(frameon=False)
    _letter(figure)
    return figure


def _letter(figure: Any) -> None:
    """Names the panels (a), (b), ... as captions do."""
    for axis, letter in zip(figure.axes, "abcdef", strict=False):
        axis.set_title(f"({letter})", loc="left", fontsize=10)


def _elastic_models() -> tuple[str, ...]:
    return mdr.accuracy_map([2.0], [1.0]).models


PICTURES = (
    springs,
    indenters,
    media,
    coatings,
    accuracy,
    adhesion,
    adhesion_range,
    stress,
    gels,
    wear,
    rate,
    pyramids,
    conduction,
    rough,
    plastic,
    tutorial_curve,
    tutorial_inside,
    tutorial_indent,
    tutorial_afm,
    tutorial_dem,
)


def save(figure: Any, file: Path) -> None:
    """Writes a PNG of few colours: a third of the size."""
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=110)
    plt.close(figure)
    Image.open(drawn).convert("RGB").quantize(64).save(file, optimize=True)


def main() -> None:
    """Draws all pictures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).resolve().parent / "pictures")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for picture in PICTURES:
        figure = picture(arguments.quick)
        if figure is None:
            print(f"left out: {picture.__name__}.png needs the extra bem")
            continue
        file = arguments.folder / f"{picture.__name__}.png"
        save(figure, file)
        print(f"written: {file.name}, {file.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
