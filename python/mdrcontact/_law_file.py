# SPDX-License-Identifier: GPL-3.0-or-later
"""Base of compiled laws: the content of their file, by which they are also compared, copied and pickled."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar, TypeVar

import numpy as np

from . import _layout
from ._boundary import Handle, Record, call, not_zero, number, record
from ._files import replace
from .errors import ArgumentTypeError, FileError, InvalidArgumentError

Law = TypeVar("Law", bound="LawFile")


class LawFile:
    """A compiled law with a file, immutable."""

    __slots__ = ("_handle", "_facts")

    _free: ClassVar[Callable[[int], Any]]
    _info: ClassVar[Callable[..., Any]]
    _table: ClassVar[np.dtype[Any]]
    """of what `_info` gives"""
    _write: ClassVar[Callable[..., Any]]
    _read: ClassVar[Callable[..., Any]]

    def _own(self, created: tuple[int, int]) -> None:
        kind = type(self)
        self._handle = Handle(created)
        facts = record(kind._table)
        call(kind._info, self._handle, facts)
        self._facts = facts[0]

    @property
    def tolerance(self) -> float:
        """Relative tolerance of the law [1]."""
        return float(self._facts["tolerance"])

    @property
    def description(self) -> str:
        """Description of the problem from which the law was made."""
        return ctypes.string_at(int(self._facts["description"])).decode()

    def to_bytes(self) -> bytes:
        """Return the content of the file of the law.

        It consists of version, description, numbers and a checksum.

        Returns
        -------
        bytes
            The content.
        """
        length = call(type(self)._write, self._handle, None, 0)
        buffer = np.zeros(length, np.uint8)
        call(type(self)._write, self._handle, buffer, length)
        return bytes(buffer)

    @classmethod
    def from_bytes(cls: type[Law], content: bytes) -> Law:
        """Return the law in the content of a file.

        Parameters
        ----------
        content : bytes
            What `to_bytes` returned.

        Returns
        -------
        ContactLaw
            The law.

        Raises
        ------
        FileError
            The content is damaged or is not a law.
        """
        law = cls.__new__(cls)
        law._own(cls._read(np.frombuffer(content or b"\0", np.uint8), len(content)))
        return law

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the law to a file that Python, C and Fortran read.

        Parameters
        ----------
        path : str or path-like
            The file. If writing fails, an existing file remains unchanged.

        Raises
        ------
        FileError
            The file cannot be written.
        """
        replace(path, self.to_bytes())

    @classmethod
    def load(cls: type[Law], path: str | os.PathLike[str]) -> Law:
        """Read a law that was saved from Python, C or Fortran.

        Parameters
        ----------
        path : str or path-like
            The file.

        Returns
        -------
        ContactLaw
            The law.

        Raises
        ------
        FileError
            The file cannot be read, is damaged or is not a law.
        """
        try:
            return cls.from_bytes(Path(path).read_bytes())
        except FileError as problem:
            raise FileError(f"the file {os.fspath(path)} cannot be used: {problem}") from problem
        except OSError as problem:
            raise FileError(f"the file {os.fspath(path)} cannot be read: {problem.strerror or problem}") from problem

    def __reduce__(self) -> tuple[Callable[[bytes], Any], tuple[bytes]]:
        return type(self).from_bytes, (self.to_bytes(),)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and self.to_bytes() == other.to_bytes()

    def __hash__(self) -> int:
        return hash(self.to_bytes())


def law_options(
    description: str | None, otherwise: str, smallest_depth: float | None, tolerance: float, continue_beyond: bool
) -> Record:
    """Struct mdr_law_options."""
    words = otherwise if description is None else description
    if not isinstance(words, str) or "\0" in words:
        raise ArgumentTypeError(f"description = {description!r}: it must be a text without null characters")
    smallest = 0.0 if smallest_depth is None else number("smallest_depth", smallest_depth)
    if smallest_depth is not None and smallest == 0.0:
        raise InvalidArgumentError("smallest_depth = 0.0: it must be greater than 0")
    text = np.frombuffer(words.encode() + b"\0", np.uint8)
    return record(_layout.law_options, smallest_depth=smallest,
                    tolerance=not_zero("tolerance", tolerance), description=text,
                    continue_beyond=bool(continue_beyond))  # fmt: skip
