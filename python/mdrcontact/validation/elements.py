# SPDX-License-Identifier: GPL-3.0-or-later
"""Axisymmetric finite elements, by scikit-fem: the same bodies by a method that shares nothing with the library."""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

from ..contact import Contact, State
from ..friction import Friction
from ..instruments import fitting
from ..material import RIGID, Elastic, TransverselyIsotropic
from ..medium import Coated, Graded, Homogeneous
from ..profile import FlatPunch, Paraboloid
from .check import Array, Check, Comparison, comparison
from .elements_slip import Sheared

_FAR = 60.0
"""Size of the mesh of a half-space, in contact radii."""
_FINEST, _RATIO = 2e-4, 1.35
"""Cells next to the edge of the contact, in contact radii, and how they grow away from it."""


def _lines(points: list[float], finest: float, ratio: float) -> Array:
    """Ascending lines of a mesh between points, finest at the first point."""
    edge, *ends = points
    lines = [edge]
    for end in ends:
        step, x = finest, edge
        while abs(end - x) > 1.5 * step:
            x += np.sign(end - edge) * step
            step *= ratio
            lines.append(x)
        lines.append(end)
    return np.unique(np.array(lines))


Moduli = Callable[[Array], tuple[Array, ...]]


class _Body:
    """A mesh of biquadratic elements over 0 < r < far, 0 < z < depth, the base held."""

    def __init__(self, moduli: Moduli, r: Array, z: Array) -> None:
        fem: Any = importlib.import_module("skfem")
        self.fem = fem
        mesh = fem.MeshQuad.init_tensor(r, z)
        self.basis = fem.Basis(mesh, fem.ElementVector(fem.ElementQuad2()), intorder=6)
        self.matrix = self._stiffness(moduli)
        # the field of degrees of freedom: which component, and where
        self.places = self.basis.doflocs
        self.component = np.zeros(self.basis.N, dtype=int)
        for name in ("nodal_dofs", "facet_dofs", "interior_dofs"):
            dofs = getattr(self.basis, name)
            if len(dofs):
                self.component[np.asarray(dofs)[1::2].ravel()] = 1
        far = (self.places[1] > z[-1] - 1e-12) | ((self.places[0] > r[-1] - 1e-12) & (r[-1] > z[-1]) & (self.component == 0))
        self.held = np.flatnonzero(far | ((self.places[0] < 1e-12) & (self.component == 0)))

    def _stiffness(self, moduli: Moduli) -> Any:
        def form(u: Any, v: Any, w: Any) -> Any:
            r = w.x[0]
            strains, others = _strains(u.grad, u[0] / r), _strains(v.grad, v[0] / r)
            stresses = _stresses(moduli(w.x[1]), strains)
            return 2.0 * np.pi * r * sum(s * e for s, e in zip(stresses, others, strict=True))

        return self.fem.BilinearForm(form).assemble(self.basis)

    def punch(self, a: float) -> float:
        """Stiffness of a flat frictionless punch: twice the energy of a unit depth."""
        under = np.flatnonzero((self.component == 1) & (self.places[1] < 1e-12) & (self.places[0] <= a * (1.0 + 1e-9)))
        u = np.zeros(self.basis.N)
        u[under] = 1.0
        solved = self.fem.solve(*self.fem.condense(self.matrix, x=u, D=np.union1d(under, self.held)))
        return float(solved @ (self.matrix @ solved))

    def loaded(self, pressure: Callable[[Array], Array], a: float) -> Any:
        """Displacements under a pressure on r < a."""
        top = self.fem.FacetBasis(
            self.basis.mesh, self.basis.elem, facets=self.basis.mesh.facets_satisfying(lambda x: (x[1] < 1e-12) & (x[0] < a)),
            intorder=10,
        )  # fmt: skip

        def form(v: Any, w: Any) -> Any:
            return 2.0 * np.pi * w.x[0] * pressure(w.x[0]) * v[1]

        return self.fem.solve(*self.fem.condense(self.matrix, self.fem.LinearForm(form).assemble(top), D=self.held))

    def stresses(self, u: Array, moduli: Moduli) -> tuple[Array, Array, tuple[Array, ...]]:
        """r, z and s_zz, s_rr, s_tt, s_rz at all points of the quadrature."""
        field = self.basis.interpolate(u)
        r, z = np.asarray(self.basis.global_coordinates())
        zz, rr, tt, rz = _stresses(moduli(z), _strains(field.grad, np.asarray(field)[0] / r))
        return r.ravel(), z.ravel(), tuple(np.asarray(s).ravel() for s in (zz, rr, tt, rz))


def _strains(slope: Any, hoop: Any) -> tuple[Any, ...]:
    """e_zz, e_rr, e_tt and 2 e_rz."""
    return slope[1][1], slope[0][0], hoop, slope[0][1] + slope[1][0]


def _stresses(moduli: tuple[Array, ...], strains: tuple[Any, ...]) -> tuple[Any, ...]:
    """s_zz, s_rr, s_tt and s_rz, by lambda and G or by C11, C12, C13, C33, C44."""
    if len(moduli) == 2:
        lame, shear = moduli
        moduli = lame + 2.0 * shear, lame, lame, lame + 2.0 * shear, shear
    c11, c12, c13, c33, c44 = moduli
    zz, rr, tt, rz = strains
    return c33 * zz + c13 * (rr + tt), c11 * rr + c12 * tt + c13 * zz, c12 * rr + c11 * tt + c13 * zz, c44 * rz


def _moduli(layers: list[tuple[float, Elastic]]) -> Callable[[Array], tuple[Array, Array]]:
    """Lame's constants at depths, of layers that end at depths."""

    def at(z: Array) -> tuple[Array, Array]:
        lame, shear = np.zeros_like(z), np.zeros_like(z)
        above = 0.0
        for end, material in layers:
            here = (z >= above) & (z <= end)
            g = material.E / (2.0 * (1.0 + material.nu))
            shear[here], lame[here] = g, 2.0 * g * material.nu / (1.0 - 2.0 * material.nu)
            above = end
        return lame, shear

    return at


def bonded() -> Comparison:
    """A layer on a rigid base under a flat punch, Poisson's ratio 0.3, 0.45."""
    rows = []
    for nu in (0.3, 0.45):
        for a in (0.5, 1.0, 2.0, 4.0):
            film = Elastic(1.0, nu)
            rows.append((a, Coated(film, 1.0, RIGID).stiffness(a), _bonded_punch(film, a)))
    a, here, there = np.array(rows, dtype=float).T
    return comparison("a/h (nu = 0.3, then 0.45)", np.concatenate([a[:4], 5.0 + a[4:]]), here, there)


def with_an_axis() -> Comparison:
    """A layer of graphite, and of a fibre mat, on a rigid base under a flat punch."""
    rows = []
    for film in (TransverselyIsotropic(1060.0, 180.0, 15.0, 36.5, 4.5), TransverselyIsotropic(3.0, 1.0, 1.5, 12.0, 2.0)):

        def moduli(z: Array, film: TransverselyIsotropic = film) -> tuple[Array, ...]:
            return tuple(np.full_like(z, c) for c in (film.C11, film.C12, film.C13, film.C33, film.C44))

        for a in (0.5, 1.0, 2.0, 4.0):
            rows.append((a, Coated(film, 1.0, RIGID).stiffness(a), _punch_on_layer(moduli, a)))
    a, here, there = np.array(rows, dtype=float).T
    return comparison("a/h (graphite, then fibres)", np.concatenate([a[:4], 5.0 + a[4:]]), here, there)


def coated() -> Comparison:
    """Films ten times softer and stiffer than their base. What lies beyond the mesh adds to the compliance what it adds to that of
    the base alone."""
    rows = []
    for contrast in (0.1, 10.0):
        film = Elastic(contrast, 0.25)
        for a in (0.3, 1.0, 3.0):
            far = _FAR * max(a, 1.0)
            there = _on_the_base(_moduli([(1.0, film), (far, _BARE)]), a)
            rows.append((a, float(Coated(film, 1.0, _BARE).stiffness(a)), there))
    a, here, there = np.array(rows, dtype=float).T
    return comparison("a/h (soft, then stiff)", np.concatenate([a[:3], 4.0 + a[3:]]), here, there)


_BARE = Elastic(1.0, 0.3)
"""Base of the coated and graded bodies under punches."""


def _on_the_base(moduli: Moduli, a: float) -> float:
    """Stiffness of a punch on a body with a base, whose part beyond the mesh adds the compliance that the base alone lacks."""
    added = 1.0 / _Body(moduli, *_half_space(a)).punch(a) - 1.0 / _bare_punch(a)
    return 1.0 / (1.0 / float(Homogeneous(_BARE).stiffness(a)) + added)


@functools.cache
def _bare_punch(a: float) -> float:
    """Stiffness of a punch on the meshed part of the base alone."""
    r, z = _half_space(a)
    return _Body(_moduli([(z[-1], _BARE)]), r, z).punch(a)


def _half_space(a: float) -> tuple[Array, Array]:
    """Lines of a mesh with a layer of thickness 1 on top."""
    far = _FAR * max(a, 1.0)
    z = np.concatenate([_lines([0.0, 1.0], _FINEST * a, _RATIO), _lines([1.0, far], 0.05, _RATIO)])
    return _lines([a, 0.0, far], _FINEST * a, _RATIO), np.unique(z)


def graded() -> Comparison:
    """A body whose modulus falls from 4 to 1 over the depth h; what lies beyond the mesh as for a coated body."""
    nu = _BARE.nu

    def moduli(z: Array) -> tuple[Array, Array]:
        shear = np.maximum(4.0 - 3.0 * z, 1.0) / (2.0 * (1.0 + nu))
        return 2.0 * shear * nu / (1.0 - 2.0 * nu), shear

    body, radii = Graded([0.0, 1.0], [4.0, 1.0], nu), (0.3, 1.0, 3.0)
    return comparison("a/h", radii, [float(body.stiffness(a)) for a in radii], [_on_the_base(moduli, a) for a in radii])


_WIDER = 1.1
"""Ratio of the radii between which a stiffness is differentiated."""


def sticking() -> Comparison:
    """The tension k sqrt(4 pi a gamma/k') of an adhesive edge on a bonded layer, by stiffnesses k and k' = dk/da of punches."""
    film, gamma, rows = Elastic(1.0, 0.3), 1e-3, []
    body = Coated(film, 1.0, RIGID)
    tip = Paraboloid(10.0)
    for a in (0.5, 1.0, 2.0):
        k = [_bonded_punch(film, a * ratio) for ratio in (1.0 / _WIDER, 1.0, _WIDER)]
        slope = k[1] / a * (np.log(k[2]) - np.log(k[0])) / (2.0 * np.log(_WIDER))
        free, held = Contact(tip, body), Contact(tip, body, work_of_adhesion=gamma)
        tension = float(free.at_radius(a).force) - float(held.at_radius(a).force)
        rows.append((a, tension, k[1] * float(np.sqrt(4.0 * np.pi * a * gamma / slope))))
    return comparison("a/h", *np.array(rows).T)


@functools.cache
def _bonded_punch(film: Elastic, a: float) -> float:
    return _punch_on_layer(_moduli([(1.0, film)]), a)


def _punch_on_layer(moduli: Moduli, a: float) -> float:
    """Stiffness of a punch on a layer of thickness 1 on a rigid base."""
    r = _lines([a, 0.0, a + 12.0], _FINEST * a, _RATIO)
    return _Body(moduli, r, _lines([0.0, 1.0], _FINEST * a, _RATIO)).punch(a)


def pressed() -> Comparison:
    """The surface and the axis of a coated body under the pressure of its contact: where the pressure is that of the contact the
    surface has the shape of the indenter."""
    contact, state, body, u = _coated_state()
    a = float(state.radius)
    top = np.flatnonzero((body.component == 1) & (body.places[1] < 1e-12) & (body.places[0] <= 3.0 * a))
    top = top[np.argsort(body.places[0][top])][:: max(len(top) // 40, 1)]
    places = body.places[0][top]
    here = np.asarray(state.displacement(places))
    # the far end of the mesh moves all of the surface alike: differences from the axis
    return comparison("r/a", places / a, here - here[0], u[top] - u[top[0]], float(np.abs(here).max()))


_FILM, _BASE = Elastic(4.0, 0.3), Elastic(1.0, 0.25)
"""Materials of the coated body whose fields and friction are compared, h = 1."""


def _coated_state() -> tuple[Contact, State, Any, Any]:
    """A coated body in contact at a = h, and the elements under its pressure."""
    a = 1.0
    contact = Contact(Paraboloid(100.0), Coated(_FILM, 1.0, _BASE))
    state = contact.at_radius(a)
    far = _FAR * a
    r = _lines([a, 0.0, far], 0.005, 1.2)
    z = np.unique(np.concatenate([_lines([0.0, 1.0], 0.01, 1.2), _lines([1.0, 0.0], 0.02, 1.2), _lines([1.0, far], 0.02, 1.2)]))
    body = _Body(_moduli([(1.0, _FILM), (far, _BASE)]), r, z)
    return contact, state, body, body.loaded(_pressure(contact, state, a), a)


def _pressure(contact: Contact, state: State, a: float) -> Callable[[Array], Array]:
    return lambda at: np.asarray(state.pressure(np.minimum(at.ravel(), a))).reshape(at.shape)


def inside() -> Comparison:
    """s_zz, s_rr, s_tt and s_rz in film and substrate of a coated body, at the Gauss points of elements up to 2 a."""
    contact, state, body, u = _coated_state()
    r, z, elastic = body.stresses(u, _moduli([(1.0, _FILM), (_FAR, _BASE)]))
    near = np.flatnonzero((r < 2.0) & (z < 2.0) & (np.hypot(r - 1.0, z) > 0.1) & (z > 0.02))
    near = near[:: max(near.size // 150, 1)]
    field = state.interior(r[near], z[near])
    here = np.concatenate([np.asarray(s) for s in (field.s_zz, field.s_rr, field.s_tt, field.s_rz)])
    there = np.concatenate([s[near] for s in elastic])
    x = np.concatenate([np.hypot(r[near], z[near]) + 2.9 * i for i in range(4)])
    return comparison("distance/a: s_zz, s_rr, s_tt, s_rz", x, here, there, float(state.pressure(0.0)))


def slipping() -> Comparison:
    """The tangential force at a shift of a coated body with Coulomb's law on every ring of nodes. What lies beyond the mesh adds
    the compliance that Mindlin's stiffness 8 G a/(2 - nu) of the base alone shows to be missing."""
    film, base, a, mu = _FILM, _BASE, 1.0, 0.3
    contact = Contact(Paraboloid(100.0), Coated(film, 1.0, base))
    state = contact.at_radius(a)
    r = np.unique(np.concatenate([a * np.sin(np.linspace(0.0, 0.5 * np.pi, 31)), _lines([a, _FAR * a], 2e-3, 1.5)]))
    z = np.unique(np.concatenate([_lines([0.0, 1.0], 4e-3, 1.5), _lines([1.0, _FAR * a], 0.1, 1.5)]))
    bare = Sheared(_moduli([(_FAR * a, base)]), r, z, a)
    beyond = (2.0 - base.nu) * (1.0 + base.nu) / (4.0 * base.E * a) - 1.0 / bare.stiffness.sum()
    body = Sheared(_moduli([(1.0, film), (_FAR * a, base)]), r, z, a)
    limits = mu * body.normal_forces(_pressure(contact, state, a))
    sheared = Friction(contact, mu).shear(state)
    shift = np.array([0.1, 0.3, 0.5, 0.7, 0.85]) * float(sheared.sliding_shift)
    there = np.array([body.tangential_force(s, limits) for s in shift])
    here = sheared.at_shift(shift + beyond * there).tangential_force
    limit = mu * float(state.force)
    return comparison("T/(mu F)", there / limit, here / limit, there / limit, 1.0)


def fitted() -> Comparison:
    """The modulus of a layer, from stiffnesses that finite elements gave."""
    film, a = Elastic(3.0, 0.3), np.array([0.5, 1.0, 2.0, 4.0])
    there = [_bonded_punch(film, radius) for radius in a]
    data = fitting.StiffnessRadius(a, there, relative_sd=1e-3)
    found = fitting.fit(data, FlatPunch(1.0), Coated(Elastic(1.0, 0.3), 1.0, RIGID), ["coating.E"]).estimates["coating.E"]
    return comparison("modulus of the layer", [0.0], [found], [film.E])


ELEMENTS = (
    Check("elements-bonded", "stiffness, layer on a rigid base", "finite elements (scikit-fem)", 1e-3,
          "elements: singular edge, mesh of 12 thicknesses", bonded, needs="skfem"),
    Check("elements-axis", "stiffness, transversely isotropic layer on a rigid base", "finite elements (scikit-fem)", 1e-3,
          "elements: singular edge, mesh of 12 thicknesses", with_an_axis, needs="skfem"),
    Check("elements-coated", "stiffness, coated half-space", "finite elements (scikit-fem)", 4e-3,
          "elements: end of the mesh at 60 a", coated, is_long=True, needs="skfem"),
    Check("elements-graded", "stiffness, graded half-space", "finite elements (scikit-fem)", 4e-3,
          "elements: end of the mesh at 60 a", graded, is_long=True, needs="skfem"),
    Check("elements-adhesion", "adhesion on a bonded layer", "finite elements (scikit-fem)", 4e-3,
          "elements: stiffness differentiated over 20 % of a", sticking, needs="skfem"),
    Check("elements-pressed", "pressure and surface of a coated body",
          "finite elements (scikit-fem) under the pressure of the library", 2e-3,
          "elements: cells next to the edge, end of the mesh", pressed, is_long=True, needs="skfem"),
    Check("elements-inside", "stresses inside a coated body",
          "finite elements (scikit-fem) under the pressure of the library", 1e-2,
          "elements: derivatives between nodes", inside, is_long=True, needs="skfem"),
    Check("elements-slip", "partial slip of a coated body",
          "finite elements (scikit-fem) under the pressure of the library", 1e-2,
          "elements: limits of slip at nodes, end of the mesh", slipping, is_long=True, needs="skfem"),
    Check("elements-fitted", "fit of a layer's modulus to stiffnesses", "finite elements (scikit-fem)", 1e-3,
          "elements: singular edge, mesh of 12 thicknesses", fitted, needs="skfem"),
)  # fmt: skip
