# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of the C library of this package, for linkers, ctypes and cffi."""

from __future__ import annotations

from pathlib import Path

from .errors import FileError


def get_include() -> str:
    """Return the folder of the C headers, for the option -I of a compiler.

    Returns
    -------
    str
        Folder of `mdrcontact.h`, `mdrcontact_law.h` and `mdrcontact.hpp`.

    Raises
    ------
    FileError
        The package was not installed with its C library, as in a source tree.

    Examples
    --------
    >>> from pathlib import Path
    >>> print(Path(mdr.get_include(), "mdrcontact.h").is_file())
    True
    """
    return _place("include", "mdrcontact.h")


def get_library() -> str:
    """Return the file of the shared library, for a linker, ctypes or cffi.

    Returns
    -------
    str
        Path of the file.

    Raises
    ------
    FileError
        The package was not installed with its C library, as in a source tree.

    Examples
    --------
    >>> import ctypes
    >>> library = ctypes.CDLL(mdr.get_library())
    >>> print(library.mdr_version() > 0)
    True
    """
    library = next(iter(sorted(Path(_place("lib", "")).glob("*mdrcontact*"))), None)
    return str(library) if library else _place("lib", "libmdrcontact")


def get_cmake_dir() -> str:
    """Return the folder for `cmake -Dmdrcontact_DIR=...`.

    `find_package(mdrcontact)` then defines the target mdrcontact::shared.

    Returns
    -------
    str
        Folder of `mdrcontact-config.cmake`.

    Raises
    ------
    FileError
        The package was not installed with its C library, as in a source tree.

    Examples
    --------
    >>> from pathlib import Path
    >>> print(Path(mdr.get_cmake_dir(), "mdrcontact-config.cmake").is_file())
    True
    """
    return _place("cmake", "mdrcontact-config.cmake")


def get_pkgconfig_dir() -> str:
    """Return the folder for PKG_CONFIG_PATH.

    Returns
    -------
    str
        Folder of `mdrcontact.pc`.

    Raises
    ------
    FileError
        The package was not installed with its C library, as in a source tree.

    Examples
    --------
    >>> from pathlib import Path
    >>> print(Path(mdr.get_pkgconfig_dir(), "mdrcontact.pc").is_file())
    True
    """
    return _place("pkgconfig", "mdrcontact.pc")


def _place(folder: str, file: str) -> str:
    place = Path(__file__).parent / folder
    if not (place / file).exists():
        raise FileError(f"{place / file} does not exist: this package came without the C library; pip install mdrcontact brings it")
    return str(place)
