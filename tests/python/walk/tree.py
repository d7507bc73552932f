# SPDX-License-Identifier: GPL-3.0-or-later
"""Members of objects, and how each is changed: a number by 10 %, a choice to each other one, an absent member to a present one."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import is_dataclass
from typing import Any, NamedTuple

import numpy as np

import mdrcontact as mdr
from mdrcontact import lateral
from mdrcontact.conduction import INSULATING, PERFECT, Conductor
from mdrcontact.medium.models import MODELS

Step = str | int


class Call:
    """A function of the package, or a class that is no dataclass, with its arguments: its members."""

    def __init__(self, label: str, function: Callable[..., Any], **arguments: Any) -> None:
        self.label, self.function, self.arguments = label, function, arguments

    def made(self) -> Any:
        """What it returns."""
        return self.function(**{name: made(value) for name, value in self.arguments.items()})

    def replace(self, **changes: Any) -> Call:
        return Call(self.label, self.function, **{**self.arguments, **changes})


class Times:
    """A function of numbers, and a factor that can be changed."""

    def __init__(self, function: Callable[..., Any], factor: float = 1.0) -> None:
        self.function, self.factor = function, factor

    def __call__(self, *x: Any) -> Any:
        found = self.function(*x)
        return tuple(self.factor * value for value in found) if isinstance(found, tuple) else self.factor * found

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Times) and (self.function, self.factor) == (other.function, other.factor)

    def __hash__(self) -> int:
        return hash((self.function, self.factor))


class Change(NamedTuple):
    """Another value of a member."""

    path: tuple[Step, ...]
    owner: str
    """class that has the member"""
    member: str
    """name, with the places in rows"""
    words: str
    """"" for a number, else what it becomes"""
    values: tuple[Any, ...]
    """the first one that the object allows is taken"""
    depth: int
    """steps of the path that lead to the owner"""

    @property
    def key(self) -> str:
        """Class, member and, of a choice, what it becomes."""
        return f"{self.owner}.{self.member}{self.words}"

    @property
    def place(self) -> str:
        """The path in words."""
        return _written(self.path)


_ADHESION = mdr.adhesion.RateAdhesion(0.03, 0.1, 0.5)
_CONDUCTOR = Conductor(0.7, 0.5, 2.0)
_SOFT = mdr.Elastic(0.6, 0.2)
_ENGINEERING = (2.0, 3.0, 0.2, 0.25, 0.9)

PRESENT: dict[str, tuple[Any, ...]] = {
    "AreaFunction.min_height": (0.05,),
    "Conduction.film": (0.3,),
    "Conduction.other": (Conductor(0.5, 0.8, 0.6),),
    "Conduction.sink": (30.0,),
    "Conductor.along": (0.45,),
    "Conductor.capacity": (1.5,),
    "Contact.adhesion": (_ADHESION,),
    "Contact.cohesive_stress": (0.2,),
    "Contact.work_of_adhesion": (0.02,),
    "Contact.zeta": (((0.1, 1.0, 3.0), (0.9, 0.85, 0.8)), "exact"),
    "Elastic.conductor": (_CONDUCTOR,),
    "Interface.normal": (3.0,),
    "Interface.resistance": (0.7,),
    "Interface.tangential": (2.0,),
    "Layer.interface": (mdr.Interface(0.3, 6.0, 5.0),),
    "Layer.prestress": (0.04,),
    "RateAdhesion.closing_exponent": (0.8,),
    "RateAdhesion.closing_speed": (0.3,),
    "RateAdhesion.closing_work": (0.007,),
    "Shapes.reference_nu": (0.1,),
    "Surface.bending": (0.2,),
    "Surface.stretching": (1.5,),
    "Surface.tension": (0.3,),
    "TabulatedConduction.other": (Conductor(0.5, 0.8, 0.6),),
    "TabulatedConduction.sink": (30.0,),
    "TransverselyIsotropic.engineering": (_ENGINEERING,),
    "Viscoelastic.bulk_modulus": (4.0,),
    "Viscoelastic.nu": (0.2,),
    "Viscoelastic.relaxed_shear_modulus": (0.5,),
    "Viscoelastic.viscosity": (0.4,),
    "Wear.body_coefficient": (0.05,),
    **{f"{name}.surface": (mdr.Surface(0.3, 0.1, 0.5),) for name in ("Homogeneous", "Coated", "Layered")},
}
"""What an absent member, None or 0, becomes; of several values each in turn."""

ABSENT = {
    "Conduction.other",
    "Conduction.sink",
    "Conductor.along",
    "Contact.adhesion",
    "Contact.zeta",
    "Coated.surface",
    "Elastic.conductor",
    "Homogeneous.surface",
    "Interface.normal",
    "Interface.tangential",
    "Layer.interface",
    "Layered.surface",
    "RateAdhesion.closing_exponent",
    "RateAdhesion.closing_speed",
    "RateAdhesion.closing_work",
    "Shapes.reference_nu",
}
"""Members that may be taken away."""

RANGES = {"AreaFunction.max_height", "CallableMedium.largest_radius", "CallableProfile.r_max"}
"""Numbers that say how far an object is defined: they are made smaller."""

_WEIGHT_NU = ("surface", "substrate", "effective")
CHOICES: dict[str, tuple[Any, ...]] = {
    "Coated.model": mdr.Coated.models(),
    "Coated.substrate": (mdr.RIGID, mdr.SMOOTH),
    "Coated.weight_nu": _WEIGHT_NU,
    "Contact.adhesion_rule": ("automatic", "paper", "energy"),
    "Contact.zeta": ("exact",),
    "ContactLaw.description": ("another",),
    "Graded.model": ("exact", "gao", "gao-series", "gao-power"),
    "Graded.weight_nu": _WEIGHT_NU,
    "Layered.model": ("exact", "gao", "gao-series", "gao-power"),
    "Layered.substrate": (mdr.RIGID, mdr.SMOOTH),
    "Layered.weight_nu": _WEIGHT_NU,
    "LayeredConductor.substrate": (PERFECT, INSULATING),
    "Pair.lower": (mdr.RIGID,),
    "Pair.upper": (mdr.RIGID,),
    "Voxels.beside": ("periodic", _SOFT),
}
"""All values of members that are choices; of members that are objects, what may stand in their place."""


def know(choices: dict[str, tuple[Any, ...]], present: dict[str, tuple[Any, ...]]) -> None:
    """Takes over what arguments of calls may become."""
    CHOICES.update(choices)
    PRESENT.update(present)


def made(value: Any) -> Any:
    """The object that a call stands for, or the object."""
    return value.made() if isinstance(value, Call) else value


def label(value: Any) -> str:
    """Name of its class."""
    if isinstance(value, Call):
        return value.label
    return f"lateral.{type(value).__name__}" if isinstance(value, lateral.Layer) else type(value).__name__


def is_named_tuple(value: Any) -> bool:
    return isinstance(value, tuple) and hasattr(value, "_fields")


def is_object(value: Any) -> bool:
    """Whether it has members of its own."""
    return isinstance(value, Call) or is_named_tuple(value) or (is_dataclass(value) and not isinstance(value, type))


def members(value: Any) -> dict[str, Any]:
    """Constructor arguments by name, absent ones as well."""
    if isinstance(value, Call):
        return value.arguments
    if is_named_tuple(value):
        return value._asdict()
    given = value._given() if hasattr(value, "_given") else {}
    for name, parameter in inspect.signature(type(value)).parameters.items():
        known = hasattr(value, name) and parameter.kind is not parameter.VAR_KEYWORD
        if known and name not in given and not name.startswith("_") and not isinstance(value, mdr.TransverselyIsotropic):
            given[name] = getattr(value, name)
    return given


def put(value: Any, path: tuple[Step, ...], new: Any) -> Any:
    """The object with another value at a path."""
    if not path:
        return new
    step, *rest = path
    if isinstance(step, int):
        return tuple(put(item, tuple(rest), new) if i == step else item for i, item in enumerate(value))
    changed = put(members(value)[step], tuple(rest), new)
    return value._replace(**{step: changed}) if is_named_tuple(value) else value.replace(**{step: changed})


def get(value: Any, path: tuple[Step, ...]) -> Any:
    """What stands at a path."""
    for step in path:
        value = value[step] if isinstance(step, int) else members(value)[step]
    return value


def changes(value: Any, path: tuple[Step, ...] = ()) -> Iterator[Change]:
    """Every change of every member, of objects inside as well."""
    for name, member in members(value).items():
        yield from _of_member(label(value), name, member, (*path, name), name, len(path))


def only_arguments(call: Call) -> tuple[str, ...]:
    """Arguments that are no objects: those are walked elsewhere."""
    return tuple(name for name, value in call.arguments.items() if not is_object(value))


def objects_in(value: Any) -> Iterator[tuple[str, str]]:
    """Classes and members that hold objects with members of their own, or places without any, such as RIGID."""
    for name, member in members(value).items():
        for item in _items(member):
            if is_object(item):
                yield label(value), name
                yield from objects_in(item)
            elif not isinstance(item, (int, float, str, type(None))):
                yield label(value), name


def _items(member: Any) -> Iterator[Any]:
    if isinstance(member, tuple) and not is_named_tuple(member):
        for item in member:
            yield from _items(item)
    else:
        yield member


def options_of(model: str) -> tuple[str, ...]:
    """Options of a model that are no accuracy."""
    return tuple(name for name in MODELS[model].options if name != "tolerance")


def _of_member(owner: str, name: str, value: Any, path: tuple[Step, ...], member: str, depth: int) -> Iterator[Change]:
    key = f"{owner}.{member}"

    def change(words: str, *values: Any) -> Change:
        return Change(path, owner, member, words, values, depth)

    if key in ABSENT and value is not None:
        yield change("=None", None)
    for choice in CHOICES.get(key, ()):
        if not _same(choice, value):
            yield change(f"={_short(choice)}", choice)
    if value is None or (isinstance(value, (int, float)) and not isinstance(value, bool) and value == 0):
        present = PRESENT.get(key, () if isinstance(value, type(None)) else (0.1,))
        if not present:
            raise LookupError(f"what is {key} where it is present? say it in PRESENT")
        for i, one in enumerate(present):
            yield change(f"=present{i or ''}" if value is None else "", one)
    elif isinstance(value, bool):
        yield change(f"={not value}", not value)
    elif isinstance(value, int):
        yield change("", value + 1, value - 1)
    elif isinstance(value, float):
        yield change("", *((0.9 * value,) if key in RANGES else (1.1 * value, 0.9 * value)))
    elif isinstance(value, Times):
        yield change("", Times(value.function, 1.1 * value.factor))
    elif isinstance(value, np.ndarray):
        yield change("", _another_phase(value)) if value.dtype.kind in "iu" else change("", 1.1 * value, 0.9 * value)
    elif is_object(value) and not (isinstance(value, mdr.State)):
        yield from changes(value, path)
    elif isinstance(value, tuple):
        for i, item in enumerate(value):
            yield from _of_member(owner, name, item, (*path, i), f"{member}[{i}]", depth)
    elif key not in CHOICES and not isinstance(value, type(mdr.RIGID)):
        raise LookupError(f"what may {key} = {value!r} become? say it in CHOICES")


def _another_phase(cells: np.ndarray) -> np.ndarray:
    changed = cells.copy()
    changed.flat[0] = 1 - changed.flat[0]
    return changed


def _same(choice: Any, value: Any) -> bool:
    return type(choice) is type(value) and choice == value


def _short(choice: Any) -> str:
    return choice if isinstance(choice, str) else repr(choice) if not is_object(choice) else label(choice)


def _written(path: tuple[Step, ...]) -> str:
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).lstrip(".")
