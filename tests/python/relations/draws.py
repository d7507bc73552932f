# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn: indenters, bodies and numbers, lengths near 1 and moduli near 1, and extreme ones. `rescale.in_units` takes them
to any units."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

import mdrcontact as mdr


class Tip(NamedTuple):
    """An indenter, with radii between which its contacts are looked at."""

    profile: mdr.Profile
    low: float = 0.02
    high: float = 3.0
    flat: bool = False
    corner: float | None = None
    """where f or its curvature has a step"""

    def radii(self, share: float, n: int = 5):
        """n radii that grow by 5 to 50 per cent each."""
        top = self.low * (self.high / self.low) ** share
        if self.flat:
            return np.linspace(self.low, top, n)
        return top * (self.low / self.high) ** (0.1 * np.arange(n)[::-1])


def between(low: float, high: float):
    """Numbers evenly spread in their logarithm."""
    return st.floats(math.log(low), math.log(high)).map(math.exp)


lengths = between(0.2, 20.0)
inclinations = st.floats(0.02, 1.2)
flats = between(0.05, 1.0)
shares = st.floats(0.5, 1.0)
units = st.tuples(between(1e-12, 1e12), between(1e-12, 1e12))
"""Of length and of modulus."""
angles = st.floats(0.0, 2.0 * math.pi)

# ---- indenters ----

paraboloids = lengths.map(lambda R: Tip(mdr.Paraboloid(R)))
spheres = lengths.map(lambda R: Tip(mdr.Sphere(R), low=min(0.02, 0.1 * R), high=min(3.0, 0.95 * R)))
cones = inclinations.map(lambda phi: Tip(mdr.Cone(phi)))
rounded_cones = st.builds(lambda b, phi: Tip(mdr.RoundedCone(b, phi), corner=b), flats, inclinations)
power_laws = st.builds(lambda n, c: Tip(mdr.PowerLaw(n, c)), st.floats(0.5, 6.0), lengths)
area_functions = st.builds(lambda c0, c1: Tip(mdr.AreaFunction([c0, c1], max_height=4.0), high=2.5), st.floats(5.0, 30.0), flats)
pyramids = st.sampled_from([Tip(mdr.Berkovich()), Tip(mdr.CubeCorner()), Tip(mdr.Vickers())])
simple_tips = st.one_of(paraboloids, spheres, cones, power_laws, rounded_cones, pyramids, area_functions)


def _flat_ended(profile: mdr.Profile, end_radius: float) -> Tip:
    return Tip(profile, low=1.05 * end_radius, flat=True, corner=end_radius)


flat_ended_tips = st.one_of(
    st.builds(lambda b, phi: _flat_ended(mdr.FlatEndedCone(b, phi), b), flats, inclinations),
    st.builds(lambda b, R: _flat_ended(mdr.FlatEndedParaboloid(b, R), b), flats, lengths),
)


def sum_of(first: Tip, second: Tip) -> Tip:
    """Contacts reach from the larger flat end to the end of the shorter tip."""
    low, high = max(first.low, second.low), min(first.high, second.high)
    return Tip(first.profile + second.profile, low, high, first.flat, first.corner or second.corner)


def overlap(tip: Tip) -> bool:
    """Whether there is a contact radius at which both parts of a sum are known."""
    return tip.low < 0.8 * tip.high


one_tip = st.one_of(simple_tips, flat_ended_tips)
closed_tips = st.one_of(paraboloids, spheres, cones, power_laws, rounded_cones, pyramids, flat_ended_tips)
"""Whose g(x) is a closed form."""
without_corner = st.one_of(paraboloids, spheres, cones, power_laws, pyramids, area_functions)
sums = st.builds(sum_of, one_tip, without_corner).filter(overlap)
tips = st.one_of(one_tip, sums)
smooth_tips = st.one_of(paraboloids, spheres, rounded_cones)
"""Whose pressure is finite at the axis, and g(x) piecewise analytic there."""
endless_tips = st.one_of(
    paraboloids, cones, rounded_cones, st.builds(lambda n, c: Tip(mdr.PowerLaw(n, c)), st.floats(1.0, 6.0), lengths)
)
adhesive_tips = st.one_of(endless_tips, spheres)

# ---- bodies ----

ratios = st.one_of(st.floats(-0.5, 0.5), st.sampled_from([0.0, 0.5]))
usual_ratios = st.one_of(st.floats(0.0, 0.5), st.sampled_from([0.0, 0.5]))
materials = st.builds(mdr.Elastic, between(0.1, 10.0), ratios)
usual = st.builds(mdr.Elastic, between(0.1, 10.0), usual_ratios)
extreme = st.builds(mdr.Elastic, between(1e-3, 1e3), usual_ratios)
"""Of two the contrast reaches 1e6."""
bases = st.one_of(materials, st.just(mdr.RIGID))


def _crystal(E_t: float, along: float, nu_t: float, share: float, shear: float) -> mdr.TransverselyIsotropic:
    """nu_tz as a part of the largest one at which no strain is free."""
    nu_tz = share * math.sqrt(0.5 * (1.0 - nu_t) / along)
    return mdr.TransverselyIsotropic.from_engineering(E_t, along * E_t, nu_t, nu_tz, shear * E_t)


crystals = st.builds(_crystal, between(0.1, 10.0), between(0.03, 30.0), st.floats(-0.5, 0.95), st.floats(-0.999, 0.999),
                     between(0.03, 10.0))  # fmt: skip
"""Transversely isotropic, as far from isotropic as fibres, foils and mica are."""
bonds = st.one_of(
    st.none(), st.just(mdr.SLIDING), st.builds(mdr.Interface, normal=between(0.1, 100.0), tangential=between(0.1, 100.0))
)

thicknesses = between(0.05, 20.0)
extreme_thicknesses = between(1e-3, 1e4)
"""At a contact radius near 1: a/h from 1e-4 to 1e3."""
FORMULAS = ["gao", "gao-series", "gao-power", "doerner-nix", "wave", "mencik-exponential", "mencik-reciprocal", "bec",
            "perriot-barthel", "hay-crawford"]  # fmt: skip
ALL_BUT_GRADED = [name for name in FORMULAS if name != "hay-crawford"]
WEIGHTS = ["gao", "gao-series", "gao-power"]
weights = st.sampled_from(WEIGHTS)

homogeneous = st.builds(mdr.Homogeneous, materials)
one_coating = st.builds(mdr.Coated, materials, thicknesses, materials, st.sampled_from(ALL_BUT_GRADED))


moduli = between(0.1, 10.0)


def stacks(most: int, layer=materials, thickness=thicknesses):
    """Lists of layers."""
    return st.lists(st.tuples(layer, thickness), min_size=1, max_size=most)


def gradings(model, modulus=moduli, most: int = 5):
    """Tables of E(z) in steps of 0.5."""
    return st.builds(
        lambda E, nu, name: mdr.Graded([0.5 * i for i in range(len(E))], E, nu, name),
        st.lists(modulus, min_size=2, max_size=most),
        usual_ratios,
        model,
    )


analytic_formulas = st.one_of(
    one_coating,
    st.builds(mdr.Pair, one_coating, st.one_of(homogeneous, one_coating)),
    st.builds(mdr.Layered, stacks(3), materials, weights),
    gradings(weights),
)
tabulated = st.lists(between(0.5, 2.0), min_size=3, max_size=6).map(
    lambda moduli: mdr.TabulatedMedium(np.geomspace(1e-3, 10.0, len(moduli)), moduli)
)
formulas = st.one_of(analytic_formulas, tabulated)
power_graded = st.builds(mdr.PowerLawGraded, between(0.1, 10.0), lengths, st.floats(-0.3, 0.6), usual_ratios)
"""Below -0.3 the pressure at a rim is too singular for the quadratures here."""
exact_films = st.one_of(
    st.builds(mdr.Coated, materials, between(0.1, 20.0), materials),
    st.builds(mdr.Coated, materials, between(0.3, 20.0), st.just(mdr.RIGID)),
)
single_exact = st.one_of(exact_films, st.builds(mdr.Layered, stacks(2, thickness=between(0.2, 20.0)), materials))
exact_layers = st.one_of(
    single_exact,
    st.builds(mdr.Pair, single_exact, st.one_of(homogeneous, single_exact)),
    st.builds(mdr.Pair, single_exact, one_coating),
)
exact_gradings = gradings(st.just("exact"), most=3)
extreme_films = st.builds(mdr.Coated, extreme, extreme_thicknesses, st.one_of(extreme, st.just(mdr.RIGID)))
bodies = st.one_of(homogeneous, formulas, power_graded)
uniform_media = st.one_of(homogeneous, st.builds(mdr.Pair, homogeneous, homogeneous))
everything = st.one_of(bodies, exact_layers)

tensions, bendings = between(0.1, 10.0), between(1e-3, 1.0)
plates = st.one_of(st.builds(mdr.Surface, st.just(0.0), bendings), st.builds(mdr.Surface, tensions, bendings))
surfaces = st.one_of(st.builds(mdr.Surface, tensions), plates)
bare = st.one_of(homogeneous, st.builds(mdr.Coated, materials, between(0.3, 20.0), bases))
"""Contact radii from 0.3 to 1 are within what they answer under such surfaces."""
tense = st.builds(lambda body, tension: body.replace(surface=mdr.Surface(tension)), bare, tensions)
plated = st.builds(lambda body, plate: body.replace(surface=plate), bare, plates)
stretchings = between(0.1, 10.0)
stretched = st.builds(lambda body, k: body.replace(surface=mdr.Surface(stretching=k)), bare, stretchings)
tense_and_stretched = st.builds(
    lambda body, tension, k: body.replace(surface=mdr.Surface(tension, 0.0, k)), bare, tensions, stretchings
)
sheeted = st.one_of(tense, plated)

works = between(1e-6, 1e-3)
"""Works of adhesion in units of E_eff at the radius 1."""
rules = st.sampled_from(["automatic", "paper", "energy"])


def is_exact(medium: mdr.Medium) -> bool:
    """Whether the body itself is solved."""
    if isinstance(medium, mdr.Pair):
        return all(body is mdr.RIGID or is_exact(body) for body in (medium.lower, medium.upper))
    return isinstance(medium, mdr.Homogeneous) or getattr(medium, "model", "") == "exact"


def adhesive(tip: Tip, medium: mdr.Medium, work: float, rule: str = "automatic") -> mdr.Contact:
    """A contact with a work of adhesion in the unit of the medium's modulus."""
    return mdr.Contact(tip.profile, medium, work_of_adhesion=work * medium.modulus(1.0), adhesion_rule=rule)


def digits(medium: mdr.Medium) -> float:
    """The relative error that two ways to one number may differ by: a dozen digits within a formula; an exact medium has its
    tolerance of 1e-10 twice, and the differences of two such numbers that it is made from."""
    return 1e-9 if getattr(medium, "model", "") == "exact" else 1e-11
