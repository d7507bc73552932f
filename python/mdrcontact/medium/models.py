# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, codes and options of the models of a coated, layered or graded medium (theory/paper.md (3.1))."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, TypeVar

from numpy.typing import NDArray

from .. import _layout
from .._boundary import Handle, native, not_zero, number, record, words_of
from .._choices import nearest
from ..errors import InvalidArgumentError
from .base import Medium

Self = TypeVar("Self", bound="UnderModel")


class Model(NamedTuple):
    """A row of the library's table of models."""

    code: int
    options: tuple[str, ...]
    constant: str
    """the option that is a number which a fit can vary, or nothing"""
    default_constant: float
    """its default"""
    needs_rigid_base: bool
    allows_rigid_base: bool
    layers: bool
    graded: bool


def _models() -> Iterator[tuple[str, Model]]:
    for code in itertools.count(_layout.MODEL_GAO):
        facts = record(_layout.model_facts)
        if native.model_info(code, facts):
            return
        _, _, base, layers, graded, _, *options, default = facts[0].tolist()
        constant, option = (words.decode() for words in options)
        options = tuple(words for words in (constant, option) if words)
        rigid = base == _layout.BASE_RIGID, base != _layout.BASE_ELASTIC
        (name,) = words_of(code)
        yield name, Model(code, options, constant, default, *rigid, bool(layers), bool(graded))


MODELS: Mapping[str, Model] = dict(sorted(_models(), key=lambda entry: entry[0] == "exact"))
"""Every model by its name, the exact one last."""

OPTIONS: tuple[str, ...] = tuple(sorted({name for model in MODELS.values() for name in model.options}))
"""The options of all models."""

_WEIGHT_NU = words_of(_layout.WEIGHT_NU_SURFACE, _layout.WEIGHT_NU_SUBSTRATE, _layout.WEIGHT_NU_EFFECTIVE)


class Settings(NamedTuple):
    """A model and its options as the library takes them, and the options as the user gave them."""

    record: NDArray[Any]
    given: dict[str, float | str]

    def medium_of(self, body: Handle) -> tuple[int, int]:
        """Return the result of the constructor of the library for a body under the model."""
        created: tuple[int, int] = native.medium_new(body, self.record)
        return created


def settings(model: str, options: Mapping[str, Any], *, layers: bool = False, graded: bool = False) -> Settings:
    """Check the name of a model and its options; the message for a wrong name has the nearest right one."""
    known = {name: row for name, row in MODELS.items() if row.layers >= layers and row.graded >= graded}
    if not isinstance(model, str) or model not in known:
        raise InvalidArgumentError(f"model = {model!r}: {nearest(str(model), known)}")
    values = record(_layout.medium_options, model=known[model].code)
    given: dict[str, float | str] = {}
    for name, value in options.items():
        if name not in known[model].options:
            words = nearest(name, known[model].options)
            raise InvalidArgumentError(f"{name} is not an option of the model {model!r}: {words}")
        if name == "weight_nu" and isinstance(value, str):
            given[name] = value
            values["weight_nu_choice"] = _weight_nu(value)
            continue
        given[name] = number(name, value) if name in ("weight_nu", "exponent") else not_zero(name, value)
        values[name] = given[name]
        if name == "exponent":
            values["exponent_is_given"] = True
        if name == "weight_nu":
            values["weight_nu_choice"] = _layout.WEIGHT_NU_GIVEN
    return Settings(values, given)


def _weight_nu(value: str) -> int:
    if value not in _WEIGHT_NU:
        words = nearest(value, _WEIGHT_NU)
        raise InvalidArgumentError(f"weight_nu = {value!r}: {words}; a number is allowed as well")
    return _WEIGHT_NU[value]


class UnderModel(Medium):
    """Body whose effective modulus follows from one of several models.

    Options that were given are attributes of the object.
    """

    model: str
    options: tuple[tuple[str, float | str], ...]

    def _own_with(self, body: Handle, chosen: Settings, **values: Any) -> None:
        self._own(chosen.medium_of(body), body, **values, **chosen.given, options=tuple(chosen.given.items()))

    def with_model(self: Self, model: str, **options: Any) -> Self:
        """Return the same body under another model.

        Parameters
        ----------
        model : str
            Name of the model, as in `Coated`.
        **options
            Options of the new model. Options of the present model are not copied.

        Returns
        -------
        Coated, Layered or Graded
            A body of this class.

        Raises
        ------
        InvalidArgumentError
            The model or an option is unknown, or the model does not support the body.
        """
        body = {name: value for name, value in self._given().items() if name not in dict(self.options)}
        return type(self)(**{**body, "model": model, **options})

    def _constants(self) -> dict[str, Any]:
        """Constants of the body and of its model; other options select the method of solution."""
        model = MODELS[self.model]
        given = {name: value for name, value in super()._given().items() if name not in ("model", "options")}
        options = dict(self.options)
        return {**given, model.constant: float(options.get(model.constant, model.default_constant))} if model.constant else given

    def _rebuilt(self: Self, constants: dict[str, Any]) -> Self:
        model = MODELS[self.model]
        if model.constant not in dict(self.options) and constants.get(model.constant) == model.default_constant:
            del constants[model.constant]
        return super()._rebuilt(constants)

    def _tolerance(self) -> float:
        return float(dict(self.options).get("tolerance", 0.0))

    def _given(self) -> dict[str, Any]:
        given = super()._given()
        options = given.pop("options")
        return {**given, **dict(options)}
