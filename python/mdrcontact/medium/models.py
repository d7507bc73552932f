# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, codes and options of the models of a coated, layered or graded medium (theory 3)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, TypeVar

from .. import _native
from .._boundary import number
from .._choices import nearest
from ..errors import InvalidArgumentError
from .base import Medium

Self = TypeVar("Self", bound="UnderModel")


class Model(NamedTuple):
    """One model: its code in the C API and the options it takes."""

    code: int
    options: tuple[str, ...] = ()
    needs_rigid_base: bool = False
    layers: bool = False


MODELS: Mapping[str, Model] = {
    "gao": Model(0, ("weight_nu",), layers=True),
    "gao-series": Model(1, ("weight_nu",), layers=True),
    "doerner-nix": Model(2, ("alpha",)),
    "wave": Model(3, ("wave_factor",)),
    "mencik-exponential": Model(4, ("alpha",)),
    "mencik-reciprocal": Model(5, ("alpha",)),
    "bec": Model(6),
    "perriot-barthel": Model(7),
    "hay-crawford": Model(8),
    "dimitriadis": Model(9, needs_rigid_base=True),
    "garcia": Model(10, needs_rigid_base=True),
    "exact": Model(11, ("tolerance",), layers=True),
}
"""Every model by its name. Layered and graded media take those with `layers`."""

_WEIGHT_NU = {"surface": 0, "substrate": 1, "effective": 2}
_WEIGHT_NU_GIVEN = 3


class Settings(NamedTuple):
    """Model code and options as the library takes them, and the options as the user gave them."""

    native: tuple[int, float, float, int, float, float]
    given: dict[str, float | str]


def settings(model: str, options: Mapping[str, Any], *, layers: bool = False) -> Settings:
    """Checks a model's name and its options; wrong names are answered with the nearest right one."""
    known = {name: entry for name, entry in MODELS.items() if entry.layers or not layers}
    if not isinstance(model, str) or model not in known:
        raise InvalidArgumentError(f"model = {model!r} is not allowed: {nearest(str(model), known)}")
    entry = known[model]
    alpha, wave_factor, choice, weight_nu, tolerance = _native.medium_default_options()
    given: dict[str, float | str] = {}
    for name, value in options.items():
        if name not in entry.options:
            words = nearest(name, entry.options)
            raise InvalidArgumentError(f"{name} is not an option of the model {model!r}: {words}")
        if name == "weight_nu":
            choice, weight_nu, value = _weight_nu(value, weight_nu)
        else:
            value = number(name, value)
        given[name] = value
    alpha, wave_factor = given.get("alpha", alpha), given.get("wave_factor", wave_factor)
    tolerance = given.get("tolerance", tolerance)
    return Settings((entry.code, alpha, wave_factor, choice, weight_nu, tolerance), given)


def _weight_nu(value: Any, unused: float) -> tuple[int, float, float | str]:
    if not isinstance(value, str):
        value = number("weight_nu", value)
        return _WEIGHT_NU_GIVEN, value, value
    if value not in _WEIGHT_NU:
        words = nearest(value, _WEIGHT_NU)
        raise InvalidArgumentError(f"weight_nu = {value!r} is not allowed: {words}; a number is allowed as well")
    return _WEIGHT_NU[value], unused, value


class UnderModel(Medium):
    """A body whose effective modulus is found by one of several models. Options that were given are attributes, too."""

    model: str
    options: tuple[tuple[str, float | str], ...]

    def _own_with(self, created: tuple[int, int], options: Mapping[str, float | str], **values: Any) -> None:
        self._own(created, **values, **options, options=tuple(options.items()))

    def with_model(self: Self, model: str, **options: Any) -> Self:
        """The same body under another model; options of the present model are not carried over."""
        body = {name: value for name, value in self._given().items() if name not in dict(self.options)}
        return type(self)(**{**body, "model": model, **options})

    def _given(self) -> dict[str, Any]:
        given = super()._given()
        options = given.pop("options")
        return {**given, **dict(options)}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._given().items())})"
