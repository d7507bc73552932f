# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects whose numbers have names: indenters, materials, layers, bodies and media."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, TypeVar

from ._boundary import number
from ._choices import nearest
from ._value import Value
from .errors import ArgumentTypeError, InvalidArgumentError

Self = TypeVar("Self", bound="WithParameters")

_WITHOUT_NAME = ("material", "lower")
"""Fields whose numbers have the names of the object itself: "E" of a half-space, not "material.E"."""


class WithParameters(Value):
    """An object made of numbers, and of other objects that are."""

    _is_table: ClassVar[bool] = False
    """whether its numbers are a table, a function's range or a place, no constants"""

    def parameters(self) -> dict[str, float]:
        """Return the numbers of the object by name.

        The names are those of free parameters in `mdrcontact.instruments.fit`. Tables, functions and options of a solution have no
        name.

        Returns
        -------
        dict
            Names and values, as {"coating.E": 72e9, "thickness": 5e-7}, in the units of the constructor arguments.
        """
        return {name: value for key, part in self._constants().items() for name, value in _named(key, part)}

    def with_parameters(self: Self, values: Mapping[str, float]) -> Self:
        """Return the same object with other numbers.

        Parameters
        ----------
        values : mapping
            Numbers by the names of `parameters()`, as in `film.with_parameters({"coating.E": 80e9})`. Other numbers stay.

        Returns
        -------
        object
            An object of this class.

        Raises
        ------
        ArgumentTypeError
            `values` is not a mapping.
        InvalidArgumentError
            A name is unknown, or the object does not allow a value.
        """
        if not isinstance(values, Mapping):
            raise ArgumentTypeError(f"values = {values!r}: it must map names of parameters to numbers")
        known = self.parameters()
        for name in values:
            if name not in known:
                raise InvalidArgumentError(f"the parameter {name!r}: {nearest(str(name), known)}")
        given = {name: number(name, value) for name, value in values.items()}
        return self._rebuilt({key: _changed(key, part, given) for key, part in self._constants().items()}) if given else self

    def _constants(self) -> dict[str, Any]:
        """Return the arguments that contain the numbers: those of the constructor, unless the class overrides it."""
        return {} if self._is_table else self._given()

    def _rebuilt(self: Self, constants: dict[str, Any]) -> Self:
        """The object with other constants, all of them."""
        return self.replace(**constants)


def _named(name: str, part: Any) -> Iterator[tuple[str, float]]:
    """Numbers of an argument with their names."""
    if isinstance(part, WithParameters):
        prefix = "" if name in _WITHOUT_NAME else f"{name}."
        yield from ((prefix + key, value) for key, value in part.parameters().items())
    elif isinstance(part, tuple):
        for i, item in enumerate(part):
            yield from _named(f"{name}[{i}]", item)
    elif isinstance(part, float):
        yield name, part


def _changed(name: str, part: Any, values: Mapping[str, float]) -> Any:
    """The argument with other numbers."""
    if isinstance(part, WithParameters):
        prefix = "" if name in _WITHOUT_NAME else f"{name}."
        return part.with_parameters({key: values[prefix + key] for key in part.parameters() if prefix + key in values})
    if isinstance(part, tuple):
        return tuple(_changed(f"{name}[{i}]", item, values) for i, item in enumerate(part))
    return values.get(name, part)
