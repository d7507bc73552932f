# SPDX-License-Identifier: GPL-3.0-or-later
"""Each member of each structure that goes into the compiled library, changed there, changes an answer or is refused with words.

Python fills the structures; between it and the library one member is changed in memory, for the time of one call."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact import _layout
from mdrcontact._boundary import native

from .commands import difference, numbers_of

SEEN = 1e-7
FILM, BASE = mdr.Elastic(9.1e9, 0.27), mdr.Elastic(3.05e9, 0.34)
AXIS = mdr.TransverselyIsotropic(9.3e9, 3.1e9, 2.7e9, 6.2e9, 1.9e9)
NAMED = mdr.TransverselyIsotropic.from_engineering(9.3e9, 5.9e9, 0.21, 0.23, 1.9e9)
SOFT = mdr.Viscoelastic(0.71e9, [(1.9e9, 0.31)], nu=0.37)
TIP = mdr.Paraboloid(5.1e-5)
RADII = np.array([0.9e-6, 2.1e-6])


class Scene(NamedTuple):
    """A call that takes a structure, and what is requested of its object."""

    structure: str
    """its name in _layout"""
    function: str
    """of the compiled module"""
    place: int
    """of the structure, or array of rows, among the arguments"""
    name: str
    request: Callable[[], Any]
    values: dict[str, list[Any]]
    """by member: what else may stand there; others take 10 % more, or 1 where they are 0"""


def _moduli(*layers: Any, base: Any = BASE, surface: Any = None) -> Callable[[], Any]:
    def request() -> Any:
        body = mdr.Layered(list(layers), base, surface=surface)
        return [body.modulus(RADII), body.tangential_modulus(RADII) if surface is None else 0.0]

    return request


def _relaxing() -> Any:
    body = mdr.Coated(SOFT, 2.1e-6, BASE)
    return mdr.Contact(TIP, body).dynamic_stiffness([0.3, 3.0], radius=2.1e-6)


def _coated(model: str, **options: Any) -> Callable[[], Any]:
    return lambda: mdr.Coated(FILM, 2.1e-6, BASE, model, **options).modulus(RADII)


def _sticky(model: str = "exact", **options: Any) -> Callable[[], Any]:
    return lambda: mdr.Contact(TIP, mdr.Coated(FILM, 2.1e-6, BASE, model), **options).at_depth([3e-8, 1.6e-7])


def _rate() -> Any:
    law = mdr.adhesion.RateAdhesion(0.31, 1.3e-6, 0.43, 0.19, 0.9e-6, 0.61)
    found = mdr.adhesion.rate_history(
        mdr.Contact(TIP, mdr.Homogeneous(BASE), adhesion=law), [0.0, 0.7, 2.0], depth=[0.0, 9e-8, -6e-8]
    )
    return [law.at_speed([-1e-6, 1e-6]), found]


def _rheology() -> Any:
    return mdr.adhesion.RheologicalAdhesion(SOFT, 0.31, 5e6).at_speed([-1e-7, 0.0, 1e-7])


def _worn() -> Any:
    contact = mdr.Contact(TIP, mdr.Homogeneous(BASE))
    return mdr.wear.Wear(contact, 1e-15).advance([0.1], depth=9e-8, intervals=16)[0]


def _law() -> Any:
    contact = mdr.Contact(TIP, mdr.Homogeneous(BASE))
    law = mdr.ContactLaw(
        contact,
        1.6e-7,
        friction=mdr.Friction(contact, 0.3),
        smallest_depth=1e-9,
        continue_beyond=True,
        tolerance=1e-8,
        description="walk",
    )
    return [law.depth_range, law.force_range, law.tolerance, law.sliders, law.description, law.at_depth([9e-8, 2e-7])]


def _strong() -> Any:
    law = mdr.ContactLaw(mdr.Contact(TIP, mdr.Homogeneous(BASE)), 1.6e-7, shear_strength=2e7)
    return [law.shear_strength, law.at_depth(9e-8)]


def _voxels() -> Any:
    labels = np.zeros((3, 4, 4), dtype=np.uint8)
    labels[0, :2], labels[1, 1:3, 1:] = 1, 1
    voxels = mdr.lateral.Voxels(
        labels,
        [BASE, FILM],
        [1.1e-6, 0.9e-6, 1.3e-6],
        below=BASE,
        beside=mdr.Elastic(5e9, 0.31),
        exponent=0.7,
        origin=(0.2e-6, 0.3e-6),
        reference_nu=0.29,
    )
    return voxels.effective(np.array([1.2e-6]), np.array([0.8e-6]), 1.7e-6)


def _yielding() -> Any:
    metal, rest = mdr.plastic.Yielding(mdr.Elastic(2.1e11, 0.29), 1.1e9), mdr.Elastic(3.4e11, 0.23)
    law = mdr.plastic.PlasticLaw(mdr.Paraboloid(1.1e-3), metal, 3e-6, other=rest, work_of_adhesion=0.3, tolerance=1e-8)
    return [law.tolerance, law.work_of_adhesion, law.loading(np.array([9e-7, 2.1e-6])).force]


MODELS = [getattr(_layout, name) for name in dir(_layout) if name.startswith("MODEL_")]
SCENES = [
    Scene(
        "layer",
        "body_layered",
        1,
        "elastic",
        _moduli(mdr.Layer(FILM, 2.1e-6, 0.2e9, mdr.Interface(normal=4.1e15, tangential=2.3e15))),
        {},
    ),
    Scene("layer", "body_layered", 1, "axis", _moduli(mdr.Layer(AXIS, 2.1e-6)), {}),
    Scene("layer", "body_layered", 1, "named axis", _moduli(mdr.Layer(NAMED, 2.1e-6)), {}),
    Scene("layer", "body_layered", 2, "base", _moduli(mdr.Layer(FILM, 2.1e-6)), {}),
    Scene("surface", "body_layered", 3, "sheet", _moduli(mdr.Layer(FILM, 2.1e-6), surface=mdr.Surface(910.0, 1.7e-9, 2.3e3)), {}),
    Scene("medium_options", "medium_new", 1, "gao", _coated("gao", weight_nu=0.29), {"model": MODELS}),
    Scene("medium_options", "medium_new", 1, "doerner-nix", _coated("doerner-nix", alpha=0.91), {"model": MODELS}),
    Scene("medium_options", "medium_new", 1, "wave", _coated("wave", wave_factor=2.3), {"model": MODELS}),
    Scene(
        "medium_options",
        "medium_new",
        1,
        "gao-power",
        _coated("gao-power", exponent=-0.41, weight_nu=0.29),
        {"model": MODELS, "exponent_is_given": [0]},
    ),
    Scene("medium_options", "medium_new", 1, "exact", _coated("exact", tolerance=3e-9), {"model": MODELS}),
    Scene("contact_options", "contact_new", 2, "cohesive", _sticky(work_of_adhesion=0.9, cohesive_stress=3e7), {}),
    Scene(
        "contact_options",
        "contact_new",
        2,
        "zeta",
        _sticky("gao", work_of_adhesion=0.9, zeta=([1e-8, 1e-6, 9e-6], [1.0, 1.1, 1.3])),
        {"zeta_count": [2]},
    ),
    Scene("rate_options", "rate_work", 0, "speed", _rate, {}),
    Scene("rate_options", "rate_new", 1, "history", _rate, {}),
    Scene("rate_options", "rate_work", 0, "rheology", _rheology, {}),
    Scene("wear_options", "wear_history_new", 3, "wear", _worn, {"intervals": [20], "scheme": [_layout.WEAR_RINGS]}),
    Scene("law_options", "law_new", 2, "friction", _law, {"sliders": [12], "twist": [1]}),
    Scene("law_options", "law_new", 2, "strength", _strong, {}),
    Scene("plastic_law_options", "plastic_law_new", 3, "ball", _yielding, {}),
]


_OTHER = "of another model: one structure serves all, and Python refuses the option"
_BASE = "the header: not looked at in a substrate"
EXCEPTIONS = {
    ("layer", "axis", "prestress", 1.0): "of 1 Pa against 2e9 Pa nothing is to be seen; the elastic layer has a real one",
    ("layer", "base", "prestress", 1.0): "of 1 Pa against 2e9 Pa nothing is to be seen; the elastic layer has a real one",
    ("layer", "base", "thickness", 1.0): _BASE,
    ("layer", "base", "normal_compliance", 1.0): _BASE,
    ("layer", "base", "tangential_compliance", 1.0): _BASE,
    ("medium_options", "gao", "alpha", 1.0): _OTHER,
    ("medium_options", "gao", "wave_factor", 1.0): _OTHER,
    ("medium_options", "gao", "tolerance", 1.0): _OTHER,
    ("medium_options", "gao", "exponent", 1.0): _OTHER,
    ("medium_options", "gao", "exponent_is_given", 1): _OTHER,
    ("medium_options", "doerner-nix", "wave_factor", 1.0): _OTHER,
    ("medium_options", "doerner-nix", "weight_nu_choice", 1): _OTHER,
    ("medium_options", "doerner-nix", "weight_nu", 1.0): _OTHER,
    ("medium_options", "doerner-nix", "tolerance", 1.0): _OTHER,
    ("medium_options", "doerner-nix", "exponent", 1.0): _OTHER,
    ("medium_options", "doerner-nix", "exponent_is_given", 1): _OTHER,
    ("medium_options", "wave", "alpha", 1.0): _OTHER,
    ("medium_options", "wave", "weight_nu_choice", 1): _OTHER,
    ("medium_options", "wave", "weight_nu", 1.0): _OTHER,
    ("medium_options", "wave", "tolerance", 1.0): _OTHER,
    ("medium_options", "wave", "exponent", 1.0): _OTHER,
    ("medium_options", "wave", "exponent_is_given", 1): _OTHER,
    ("medium_options", "gao-power", "alpha", 1.0): _OTHER,
    ("medium_options", "gao-power", "wave_factor", 1.0): _OTHER,
    ("medium_options", "gao-power", "tolerance", 1.0): _OTHER,
    ("medium_options", "gao-power", "exponent_is_given", 0): "an exponent that is not 0 is given by itself",
    ("medium_options", "exact", "alpha", 1.0): _OTHER,
    ("medium_options", "exact", "wave_factor", 1.0): _OTHER,
    ("medium_options", "exact", "weight_nu_choice", 1): _OTHER,
    ("medium_options", "exact", "weight_nu", 1.0): _OTHER,
    ("medium_options", "exact", "tolerance", 1.1 * 3e-9): "it bounds the error of a solution that is far better",
    ("medium_options", "exact", "exponent", 1.0): _OTHER,
    ("medium_options", "exact", "exponent_is_given", 1): _OTHER,
    ("layer", "named axis", "prestress", 1.0): "of 1 Pa against 2e9 Pa nothing is to be seen; the elastic layer has a real one",
    ("contact_options", "zeta", "adhesion_rule", _layout.ADHESION_PAPER): "what automatic takes for this model",
    ("contact_options", "cohesive", "zeta_radius", 0): "of a table without rows",
    ("contact_options", "cohesive", "zeta", 0): "of a table without rows",
    ("rate_options", "speed", "largest_radius", 1.0): "G(v) takes no radius; the history does",
    ("rate_options", "speed", "smallest_radius", 1.0): "G(v) takes no radius; the history does",
    ("rate_options", "rheology", "largest_radius", 1.0): "G(v) takes no radius; the history does",
    ("rate_options", "rheology", "smallest_radius", 1.0): "G(v) takes no radius; the history does",
    ("law_options", "friction", "twist", 1): "the normal states know of no twist; tests of laws that twist lead one",
    ("law_options", "strength", "tolerance", 1.1 * 1e-9): "the law is far better than that; the one with friction shows it",
    ("law_options", "strength", "description", 0): "words for the reader; the law with friction shows them",
    ("law_options", "strength", "continue_beyond", 1): "no point lies beyond; the law with friction has one",
    ("law_options", "strength", "sliders", 9): "of laws with friction: this one has a shear strength in its place",
}
"""By structure, scene, member and value: why nothing changes."""
MUTE = {
    ("layer", "material"),
    ("law_options", "conduction"),
    ("law_options", "continue_beyond"),
    ("law_options", "twist"),
    ("medium_options", "exponent_is_given"),
    ("medium_options", "tolerance"),
    ("medium_options", "weight_nu_choice"),
    ("contact_options", "adhesion_rule"),
    ("contact_options", "zeta"),
    ("contact_options", "zeta_count"),
    ("contact_options", "zeta_is_exact"),
    ("contact_options", "zeta_radius"),
    ("rate_options", "material"),
    ("rate_options", "smallest_radius"),
    ("wear_options", "places"),
}
"""Members that these scenes change into something refused, or into an exception, and never into another answer."""
_MADE_ELSEWHERE = {
    "model_facts",
    "failure",
    "parameter",
    "state",
    "interior",
    "maximum",
    "failure_load",
    "loop_point",
    "loop_facts",
    "rate_state",
    "shear_state",
    "shear_facts",
    "wear_state",
    "friction_heat",
    "law_point",
    "law_facts",
    "law_head",
    "law_segment",
    "law_interval",
    "fit_summary",
    "imprint_facts",
    "plastic_law_facts",
    "overload_state",
    "cap_state",
}
"""Structures that the library fills."""
_WALKED_BY_ARGUMENTS = {"conductor", "strength", "structure_options", "fit_parameter", "fit_problem"}
"""Structures whose members are arguments of Python, one by one: tests of fits and of objects change them there."""


def _members(scene: Scene, before: np.ndarray) -> Iterator[tuple[str, Any]]:
    for member in before.dtype.names or ():
        kind = before.dtype[member]
        value = before[member]
        if member in scene.values:
            yield from ((member, other) for other in scene.values[member] if other != value)
        elif member == "size":
            yield member, 0
        elif kind == np.uintp:
            if value:
                yield member, 0
        elif kind == np.intc:
            yield member, int(not value) if value in (0, 1) else int(value) + 1
        else:
            yield member, 1.1 * value if np.any(value) else 1.0


def _asked(scene: Scene, member: str = "", value: Any = None) -> tuple[dict[str, Any], np.ndarray | None]:
    """What the scene says, with a member changed in each call; and the structure of the first call as it was."""
    seen: list[np.ndarray] = []
    given = getattr(native, scene.function)

    def between(*arguments: Any) -> Any:
        if arguments[scene.place] is None:
            return given(*arguments)
        row = arguments[scene.place].view(np.ndarray)[:1]
        kept = row.copy()
        seen.append(kept)
        if member:
            row[member] = value
        try:
            return given(*arguments)
        finally:
            row[:] = kept

    setattr(native, scene.function, between)
    try:
        return numbers_of(scene.request()), seen[0][0] if seen else None
    finally:
        setattr(native, scene.function, given)


def _effects(scene: Scene) -> Iterator[tuple[str, Any, float]]:
    answer, row = _asked(scene)
    assert row is not None, f"{scene.name}: {scene.function} was not called with a structure"
    for member, value in _members(scene, row):
        try:
            yield member, value, difference(answer, _asked(scene, member, value)[0])
        except mdr.MDRError as refusal:
            assert len(str(refusal)) > 10
            yield member, value, math.nan


def test_structures_are_known():
    """A new structure is walked, or the library fills it."""
    made = {name for name, value in vars(_layout).items() if isinstance(value, np.dtype)}
    assert made == {scene.structure for scene in SCENES} | _MADE_ELSEWHERE | _WALKED_BY_ARGUMENTS


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_each_member_changes_an_answer():
    found, used, shown = 0, set(), set()
    for scene in SCENES:
        for member, value, size in _effects(scene):
            key = scene.structure, scene.name, member, value
            found += 1
            lost = size <= SEEN
            assert not lost or key in EXCEPTIONS, f"{key} changes the answer by {size:.1g}"
            used |= {key} if lost else set()
            shown |= set() if lost or math.isnan(size) else {(scene.structure, member)}
    print(f"{found} changes of members, {len(EXCEPTIONS)} exceptions")
    assert used == set(EXCEPTIONS), set(EXCEPTIONS) - used
    mute = {(scene.structure, name) for scene in SCENES for name in getattr(_layout, scene.structure).names} - shown
    assert {place for place in mute if place[1] != "size"} == MUTE, mute
