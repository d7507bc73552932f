# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the C library of this package lies, for programs that link it and for ctypes, cffi and the like."""

from __future__ import annotations

from pathlib import Path

from .errors import FileError


def get_include() -> str:
    """The folder of the headers `mdrcontact.h`, `mdrcontact_law.h` and `mdrcontact.hpp`, for -I of a compiler. FileError where the
    package came without them: run from a source tree."""
    return _place("include", "mdrcontact.h")


def get_library() -> str:
    """The file of the shared library, for a linker, ctypes and cffi. Errors as of `get_include`."""
    library = next(iter(sorted(Path(_place("lib", "")).glob("*mdrcontact*"))), None)
    return str(library) if library else _place("lib", "libmdrcontact")


def get_cmake_dir() -> str:
    """The folder for `cmake -Dmdrcontact_DIR=...`, whose find_package(mdrcontact) gives mdrcontact::shared. Errors as of
    `get_include`."""
    return _place("cmake", "mdrcontact-config.cmake")


def get_pkgconfig_dir() -> str:
    """The folder for PKG_CONFIG_PATH. Errors as of `get_include`."""
    return _place("pkgconfig", "mdrcontact.pc")


def _place(folder: str, file: str) -> str:
    place = Path(__file__).parent / folder
    if not (place / file).exists():
        raise FileError(f"{place / file} does not exist: this package came without the C library; pip install mdrcontact brings it")
    return str(place)
