# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of coated, layered and graded bodies, computed in one dimension.

    import mdrcontact as mdr

    oxide = mdr.Elastic(72e9, 0.17)                     # E [Pa], nu
    silicon = mdr.Elastic(165e9, 0.22)
    medium = mdr.Coated(oxide, 500e-9, silicon)         # h [m]
    contact = mdr.Contact(mdr.Sphere(10e-6), medium)
    state = contact.at_depth([20e-9, 50e-9, 100e-9])    # State(depth, radius, force, ...)

Any consistent units: in the descriptions the unit of each number stands in brackets, [length], [modulus] (that of pressure),
and forces are in [modulus length^2]; [1] has none. Equation numbers such as (10) are those of Popov (2014); the pages in
docs/theory/ state the equations under numbers such as (3.1). Numbers give floats, arrays give arrays of the same shape. All
objects are immutable, compare and pickle by their constructor arguments, and may be shared between threads. Errors are
`MDRError` and its subclasses.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import (
    _c_library,
    accuracy,
    adhesion,
    closed_forms,
    conduction,
    conductor,
    contact,
    critical,
    crystals,
    errors,
    failure,
    friction,
    history,
    interior,
    law,
    material,
    medium,
    poroelastic,
    profile,
    rate_adhesion,
    sheared,
    threads,
    wear,
    weights,
)
from ._c_library import *  # noqa: F403
from ._native import version as _version
from .accuracy import *  # noqa: F403
from .adhesion import *  # noqa: F403
from .closed_forms import *  # noqa: F403
from .conduction import *  # noqa: F403
from .conductor import *  # noqa: F403
from .contact import *  # noqa: F403
from .critical import *  # noqa: F403
from .crystals import *  # noqa: F403
from .errors import *  # noqa: F403
from .failure import *  # noqa: F403
from .friction import *  # noqa: F403
from .history import *  # noqa: F403
from .interior import *  # noqa: F403
from .law import *  # noqa: F403
from .material import *  # noqa: F403
from .medium import *  # noqa: F403
from .poroelastic import *  # noqa: F403
from .profile import *  # noqa: F403
from .rate_adhesion import *  # noqa: F403
from .sheared import *  # noqa: F403
from .threads import *  # noqa: F403
from .wear import *  # noqa: F403
from .weights import *  # noqa: F403

if TYPE_CHECKING:
    from . import instruments as instruments

__all__ = [
    *_c_library.__all__,
    *accuracy.__all__,
    *adhesion.__all__,
    *closed_forms.__all__,
    *conduction.__all__,
    *conductor.__all__,
    *contact.__all__,
    *critical.__all__,
    *crystals.__all__,
    *errors.__all__,
    *failure.__all__,
    *friction.__all__,
    *history.__all__,
    *interior.__all__,
    *law.__all__,
    *material.__all__,
    *medium.__all__,
    *poroelastic.__all__,
    *profile.__all__,
    *rate_adhesion.__all__,
    *sheared.__all__,
    *threads.__all__,
    *wear.__all__,
    *weights.__all__,
]

__version__ = f"{_version() // 10000}.{_version() // 100 % 100}.{_version() % 100}"


def __getattr__(name: str) -> Any:
    """Loads `instruments` on first use."""
    if name != "instruments":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return import_module("." + name, __name__)


def __dir__() -> list[str]:
    return [*globals(), "instruments"]
