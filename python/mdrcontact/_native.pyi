# SPDX-License-Identifier: GPL-3.0-or-later
# The compiled wrappers of python/src/*.f90: private, reached only through _boundary.py.
from typing import Any

def __getattr__(name: str) -> Any: ...
