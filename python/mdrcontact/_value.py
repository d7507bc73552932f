# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that are defined by their fields, and hold an object of the compiled library if they have one."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import partial
from typing import Any, TypeVar

from ._boundary import Handle, number

Self = TypeVar("Self", bound="Value")


class Named:
    """The type of objects of which there is one of each name."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __repr__(self) -> str:
        return self._name

    def __reduce__(self) -> str:
        return self._name


# without eq: one that holds arrays and says eq=False would take over an __eq__ that compares no fields at all
@dataclass(frozen=True, eq=False)
class Value:
    """A frozen dataclass: printed, compared and hashed by its fields; copied and pickled by being made anew."""

    _handle: Handle = field(init=False, repr=False, compare=False, default=None)  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._given().items())})"

    def replace(self: Self, **changes: Any) -> Self:
        """Return a new object with some constructor arguments changed.

        Parameters
        ----------
        **changes
            Constructor arguments by name, as in `coated.replace(thickness=2e-6)`.

        Returns
        -------
        object
            An object of this class.
        """
        return type(self)(**{**self._given(), **changes})

    def __reduce__(self) -> tuple[Any, ...]:
        return partial(type(self), **self._given()), ()

    def _given(self) -> dict[str, Any]:
        """The arguments that rebuild the object."""
        return {f.name: getattr(self, f.name) for f in fields(self) if f.init}

    def _numbers(self) -> tuple[float, ...]:
        """The fields, all of which must be numbers, as floats."""
        self._set(**{name: number(name, value) for name, value in self._given().items()})
        return tuple(self._given().values())

    def _set(self, **values: Any) -> None:
        """Only for the constructor: fields as they were understood, and what belongs to the object."""
        for name, value in values.items():
            object.__setattr__(self, name, value)
