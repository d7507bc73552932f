# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of coated, layered and graded bodies, computed in one dimension.

    import mdrcontact as mdr

    oxide = mdr.Elastic(72e9, 0.17)                     # E [Pa], nu
    silicon = mdr.Elastic(165e9, 0.22)
    medium = mdr.Coated(oxide, 500e-9, silicon)         # h [m]
    contact = mdr.Contact(mdr.Sphere(10e-6), medium)
    state = contact.at_depth([20e-9, 50e-9, 100e-9])    # States(depth, radius, force, ...)

Further physics: `mdr.adhesion`, `mdr.conduction`, `mdr.lateral`, `mdr.plastic`, `mdr.poroelastic`, `mdr.time`, `mdr.wear`; measured
data: `mdr.instruments`; functions of Popov (2014): `mdr.closed_forms`, `mdr.weights`.

Any consistent units: the descriptions give the unit of each number in brackets: [length], [modulus] (that of pressure),
and forces are in [modulus length^2]; [1] has none. Equation numbers such as (10) are those of Popov (2014); the pages in
docs/theory/ state the equations under numbers such as (3.1). Numbers give floats, arrays give arrays of equal shape. All
objects are immutable, compare and pickle by their constructor arguments, and may be shared between threads. Errors are
`MDRError` and its subclasses in `mdr.errors`.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import medium, profile
from ._c_library import get_cmake_dir, get_include, get_library, get_pkgconfig_dir
from ._law_arrays import LawArrays
from ._native import version as _version
from .accuracy import AccuracyMap, accuracy_map
from .contact import Contact
from .critical import Critical, InterfaceMaxima, LayerMaxima, Maximum
from .crystals import CRYSTALS, Crystal
from .errors import MDRError, MDRWarning
from .failure import Failure
from .friction import Friction, FrictionHistory
from .interior import Interior
from .law import ContactLaw, LawState
from .loop import Loop, PullOff
from .material import RIGID, SMOOTH, Elastic, PowerLawRheology, TransverselyIsotropic, Viscoelastic
from .medium import *  # noqa: F403
from .profile import *  # noqa: F403
from .sheared import FrictionLoop, ShearedContact, ShearState
from .state import State, States
from .threads import set_threads

__all__ = [
    *profile.__all__, *medium.__all__,
    "Elastic", "TransverselyIsotropic", "Viscoelastic", "PowerLawRheology", "RIGID", "SMOOTH", "CRYSTALS", "Crystal",
    "Contact", "State", "States", "Loop", "PullOff", "Interior", "Critical", "InterfaceMaxima", "LayerMaxima", "Maximum", "Failure",
    "Friction", "FrictionHistory", "FrictionLoop", "ShearState", "ShearedContact", "ContactLaw", "LawArrays", "LawState",
    "AccuracyMap", "accuracy_map", "set_threads",
    "MDRError", "MDRWarning", "get_cmake_dir", "get_include", "get_library", "get_pkgconfig_dir",
]  # fmt: skip

__version__ = f"{_version() // 10000}.{_version() // 100 % 100}.{_version() % 100}"

if TYPE_CHECKING:
    from . import adhesion as adhesion
    from . import closed_forms as closed_forms
    from . import conduction as conduction
    from . import errors as errors
    from . import instruments as instruments
    from . import lateral as lateral
    from . import plastic as plastic
    from . import poroelastic as poroelastic
    from . import time as time
    from . import wear as wear
    from . import weights as weights
else:

    def __getattr__(name: str) -> Any:
        """Loads a namespace on first use."""
        if name not in _NAMESPACES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return import_module("." + name, __name__)


_NAMESPACES = {
    "adhesion", "closed_forms", "conduction", "errors", "instruments", "lateral", "plastic", "poroelastic", "time", "wear",
    "weights",
}  # fmt: skip


def __dir__() -> list[str]:
    return sorted({*globals(), *_NAMESPACES})
