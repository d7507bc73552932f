# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that are what their constructor arguments say: printing, comparing, hashing and pickling follow from them."""

from __future__ import annotations

from typing import Any, TypeVar

Self = TypeVar("Self", bound="Described")


def _rebuild(cls: type[Any], arguments: dict[str, Any]) -> Any:
    return cls(**arguments)


class Described:
    """An immutable object, known by the keyword arguments that rebuild it.

    `eval(repr(x))` after `from mdrcontact import *` gives an equal object, unless a user's function is among the arguments.
    """

    _arguments: dict[str, Any]

    def _describe(self, **arguments: Any) -> None:
        object.__setattr__(self, "_arguments", arguments)

    def replace(self: Self, **changes: Any) -> Self:
        """A new object with some constructor arguments changed: `coated.replace(thickness=2e-6)`."""
        return type(self)(**{**self._arguments, **changes})

    def __getattr__(self, name: str) -> Any:
        arguments = self.__dict__.get("_arguments", {})
        if name in arguments:
            return arguments[name]
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} objects never change; .replace({name}=...) makes a new one")

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._arguments})

    def __repr__(self) -> str:
        inside = ", ".join(f"{name}={value!r}" for name, value in self._arguments.items())
        return f"{type(self).__name__}({inside})"

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return self._arguments == other._arguments

    def __hash__(self) -> int:
        return hash((type(self), tuple(self._arguments.items())))

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuild, (type(self), self._arguments)
