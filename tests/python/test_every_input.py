# SPDX-License-Identifier: GPL-3.0-or-later
"""Every member of every object of physics changes each answer that it serves, or is refused, or is an exception with a reason."""

from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Iterator

import pytest
from conftest import PHYSICS
from walk.answers import ANSWERS
from walk.exceptions import EXCEPTIONS
from walk.run import walk
from walk.scenes import SLOW, Scene, all_scenes
from walk.tree import ABSENT, Call, Change, changes, label, objects_in, options_of

import mdrcontact as mdr

SCENES = all_scenes()

BASES = {"Medium", "Profile", "lateral.Structure"}
"""Classes that have no objects of their own."""

OTHER_CLASSES = {
    **dict.fromkeys(
        (
            "Spot",
            "FrictionHeat",
            "ShearedContact",
            "FrictionHistory",
            "WearHistory",
            "WornProfile",
            "ImprintProfile",
            "State",
            "States",
            "OverloadState",
            "CapState",
        ),
        "made by an answer, from members that are walked",
    ),
    **dict.fromkeys(("Berkovich", "Vickers", "CubeCorner"), "have no members"),
}
"""Public classes that are not walked, and why; named tuples are results, exceptions and warnings are neither."""

OTHER_METHODS = {
    "replace", "parameters", "contact", "with_parameters", "with_model", "models", "copy", "plot", "rows", "warnings",
    "from_state", "save", "load", "turn", "restored", "saved", "memory_size", "solutions", "error", "path_error",
    "first_shear_error",
    "twists", "sliders", "coefficient", "shear_strength", "tolerance", "largest_sliding_shift", "from_fractions",
    "from_prony_text", "from_shapes", "from_engineering", "from_rheology", "between", "model", "inclination",
    "half_angle_degrees", "table", "response_error",
}  # fmt: skip
"""Methods and properties that answer with what was given, or move it."""


def _public() -> Iterator[tuple[str, type]]:
    for module in PHYSICS:
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isclass(value) and not issubclass(value, BaseException):
                yield f"lateral.{name}" if module is mdr.lateral and name in ("Structure", "Layer") else name, value


def _walked() -> dict[str, type]:
    """Public classes of objects of physics."""
    shapes = {"Ball", "Box", "Fibre", "HalfSpace", "Pillar", "lateral.Layer"}
    return {
        name: value
        for name, value in _public()
        if name not in BASES and name not in OTHER_CLASSES and (not issubclass(value, tuple) or name in shapes)
    }


def _all_changes() -> Iterator[tuple[Scene, Change]]:
    for scene in SCENES:
        for change in changes(scene.object):
            if not scene.only or any(change.place.startswith(place) for place in scene.only):
                yield scene, change


def test_every_class_and_every_member_is_walked():
    found = {(change.owner, change.member.partition("[")[0]) for _, change in _all_changes()}
    # members that are objects, whose members are walked
    found |= {part for scene in SCENES for part in objects_in(scene.object)}
    missing = []
    for name, value in _walked().items():
        parameters = inspect.signature(value).parameters.values()
        named = [p.name for p in parameters if p.kind is not p.VAR_KEYWORD and not p.name.startswith("_")]
        missing += [f"{name}.{member}" for member in named if (name, member) not in found]
    assert not missing
    options = {name for model in mdr.Coated.models() for name in options_of(model)}
    assert {("Coated", name) for name in options} <= found


def test_every_method_is_an_answer():
    covered = {method for answer in ANSWERS.values() for method in answer.covers}
    inherited = {method.partition(".")[2] for method in covered if method.partition(".")[0] in ("Medium", "Profile", "Structure")}
    missing = []
    for name, value in _public():
        results = issubclass(value, tuple) and name != "Interior"
        if results or name in ("Crystal",):
            continue
        fields = {field.name for field in dataclasses.fields(value)} if dataclasses.is_dataclass(value) else set()
        fields |= set(getattr(value, "_fields", ()))
        for method in vars(value):
            known = method.startswith("_") or method in OTHER_METHODS or method in fields or method in inherited
            if not known and f"{name.removeprefix('lateral.')}.{method}" not in covered:
                missing.append(f"{name}.{method}")
    assert not missing


def test_every_answer_is_given():
    assert set(ANSWERS) == {answer for scene in SCENES for answer in scene.answers}
    assert {line.answer for line in EXCEPTIONS} <= set(ANSWERS)
    assert len({(line.member, line.answer, line.where) for line in EXCEPTIONS}) == len(EXCEPTIONS), "a line stands twice"
    assert all(line.reason for line in EXCEPTIONS)
    assert {scene.name for scene in SCENES} >= SLOW and len({scene.name for scene in SCENES}) == len(SCENES)


def test_what_may_be_taken_away_is_once():
    """Each member that may be absent is present in a scene, and absent in one."""
    seen = {(change.key) for _, change in _all_changes()}
    assert {f"{member}=None" for member in ABSENT} <= seen


NEVER = {
    "ContactLaw.table.branch",
    "ContactLaw.tolerance",
    "Field.tolerance",
    "Medium.compliance.omega",
    "Medium.point_response.tolerance",
    "Medium.rectangle_response.tolerance",
    "Medium.response_error.tolerance",
    "Overload.yield_stresses[1]",
    "Shapes.tolerance",
    "TabulatedConduction.largest",
    "TabulatedConduction.smallest",
    "TabulatedConduction.tolerance",
    "lammps.table.branch",
    "overclosure.table.branch",
}
"""Accuracies, ranges beyond which the answer is the same, branches without adhesion, the frequency of an elastic body,
and a yield stress that decides whether a rule holds."""


@pytest.mark.parametrize("scene", [scene for scene in SCENES if scene.quick], ids=lambda scene: scene.name)
def test_members_matter(scene):
    report = walk([scene])
    assert report.cases
    assert not report.findings(), "\n".join(map(str, report.findings()))


@pytest.mark.slow
def test_all_members_matter_to_all_answers():
    """A member that matters to no answer at all is dropped by all, whatever the exceptions say."""
    report = walk(SCENES)
    print(report.summary())
    wrong = [*map(str, report.findings()), *report.wrong_exceptions()]
    assert not wrong, "\n".join(wrong)
    assert {f"{owner}.{member}" for owner, member in report.never()} == NEVER


def test_a_dropped_member_is_found():
    """An object that forgets a member, as the walk would meet it."""

    class Forgetful(mdr.Homogeneous):
        def __post_init__(self):
            object.__setattr__(self, "material", mdr.Elastic(self.material.E, 0.3))
            super().__post_init__()

    scene = Scene("forgetful", Call("made", lambda E, nu: Forgetful(mdr.Elastic(E, nu)), E=1.0, nu=0.3), ("modulus",))
    assert [case.change.key for case in walk([scene]).findings()] == ["made.nu"]
    assert label(scene.object) == "made"
