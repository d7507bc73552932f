# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions, one for each status of the library, and warnings."""

from __future__ import annotations

__all__ = [
    "MDRError",
    "InvalidArgumentError",
    "ArgumentTypeError",
    "DomainError",
    "UnreachableError",
    "NoConvergenceError",
    "OutOfMemoryError",
    "CallbackError",
    "FileError",
    "CancelledError",
    "MDRWarning",
    "SeparationInsideWarning",
    "SlipInsideWarning",
    "BeyondRangeWarning",
    "LargeStrainWarning",
    "UnitsWarning",
    "PlasticityWarning",
    "ShortZoneWarning",
    "InteriorAccuracyWarning",
    "AdhesionRateWarning",
    "PathEndsWarning",
]


class MDRError(Exception):
    """Base class of all exceptions of the package.

    Examples
    --------
    >>> try:
    ...     mdr.Sphere(-10e-6)
    ... except mdr.MDRError as problem:
    ...     print(type(problem).__name__)
    InvalidArgumentError
    """


class InvalidArgumentError(MDRError, ValueError):
    """A value that is never valid, as NaN, E <= 0 or an unknown model.

    It is also a `ValueError`.

    Examples
    --------
    >>> mdr.Elastic(72e9, 0.7)
    Traceback (most recent call last):
        ...
    mdrcontact.errors.InvalidArgumentError: nu = 0.7...
    """


class ArgumentTypeError(MDRError, TypeError):
    """An argument of the wrong type, as a text where a real number is needed.

    It is also a `TypeError`.

    Examples
    --------
    >>> mdr.Sphere("10 um")
    Traceback (most recent call last):
        ...
    mdrcontact.errors.ArgumentTypeError: radius = '10 um'...
    """


class DomainError(MDRError, ValueError):
    """A point outside the region where an object is defined.

    Examples are a radius r > a or a value beyond the end of a table. It is also a `ValueError`.

    Examples
    --------
    >>> mdr.Sphere(10e-6).height(20e-6)
    Traceback (most recent call last):
        ...
    mdrcontact.errors.DomainError: r = 2e-05...
    """


class UnreachableError(MDRError, ValueError):
    """No state of the contact has the given depth, force or radius.

    It is also a `ValueError`.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Sphere(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> contact.at_force(-1e-6)
    Traceback (most recent call last):
        ...
    mdrcontact.errors.UnreachableError: force = -1e-06...
    """


class NoConvergenceError(MDRError, ArithmeticError):
    """An iteration or a refinement ended before it reached its tolerance.

    It is also an `ArithmeticError`.

    Examples
    --------
    >>> layered = mdr.lateral.Field(lambda x, y, z: (np.where(z > 3e-7, 1e9, 2e9), 0.3), 0.3, tolerance=1e-8)
    >>> layered.modulus(0.0, 0.0, 1e-6)
    Traceback (most recent call last):
        ...
    mdrcontact.errors.NoConvergenceError: E_eff...
    """


class OutOfMemoryError(MDRError, MemoryError):
    """Memory cannot be allocated, or a given limit is too small.

    It is also a `MemoryError`.

    Examples
    --------
    >>> labels = np.zeros((2, 8, 8), dtype=int)
    >>> cells = mdr.lateral.Voxels(labels, [mdr.Elastic(1e9, 0.3)], 1e-6)
    >>> mdr.lateral.effective_map(cells, 1e-6, memory_limit=1.0)
    Traceback (most recent call last):
        ...
    mdrcontact.errors.OutOfMemoryError: ...
    """


class CallbackError(MDRError, ValueError):
    """A user-defined function returned NaN, infinity or no number.

    An exception that the function raises is passed on unchanged. It is also a `ValueError`.

    Examples
    --------
    >>> mdr.CallableProfile(lambda r: float("nan"), 1e-6)
    Traceback (most recent call last):
        ...
    mdrcontact.errors.CallbackError: ...
    """


class FileError(MDRError, OSError):
    """A file cannot be read or written, or it is damaged.

    It is also an `OSError`.

    Examples
    --------
    >>> mdr.ContactLaw.load("no-such-file.mdrlaw")
    Traceback (most recent call last):
        ...
    mdrcontact.errors.FileError: ...
    """


class CancelledError(MDRError):
    """Work ended before it was complete.

    The `stop` of its `Progress` returned True, or the thread that waits for the work was interrupted.

    Examples
    --------
    >>> from mdrcontact.progress import Progress
    >>> Progress(stop=lambda: True).step(0, 3, "files")
    Traceback (most recent call last):
        ...
    mdrcontact.errors.CancelledError: ...
    """


class MDRWarning(UserWarning):
    """Base class of all warnings of the package.

    Each kind is issued once for each contact. `State.warnings` returns the texts at any time.

    Examples
    --------
    >>> import warnings
    >>> contact = mdr.Contact(mdr.Cone(half_angle=30.0, degrees=True), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("ignore", mdr.MDRWarning)
    ...     state = contact.at_depth(1e-6)
    >>> print(f"{state.force:.4e}")
    2.7251e-02
    """


class SeparationInsideWarning(MDRWarning):
    """The pressure inside a contact without adhesion is negative.

    On such a stiff coating the contact is not a single contact area, and its pressure is not the true one. The error of F(d) is at
    most a few per cent if the coating is up to 200 times stiffer than the body. The warning is also issued if the surface outside
    the contact would pass through the indenter. Under a plate (`Surface`) F(d) is also not the true one.

    Examples
    --------
    >>> import warnings
    >>> film = mdr.Coated(mdr.Elastic(100e9, 0.25), 1e-6, mdr.Elastic(1e9, 0.3))
    >>> contact = mdr.Contact(mdr.PowerLaw(4.0, 1e16), film)
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     state = contact.at_radius(2e-6)
    >>> print({one.category.__name__ for one in issued})
    {'SeparationInsideWarning'}
    """


class SlipInsideWarning(MDRWarning):
    """Slip begins inside the contact, and not only in an annulus at its edge.

    Forces, energies and tractions are then not the true ones. `Friction.history`, which uses rings, computes them.

    Examples
    --------
    >>> import warnings
    >>> film = mdr.Coated(mdr.Elastic(4.75, 0.3), 0.514, mdr.Elastic(3.5, 0.0))
    >>> friction = mdr.Friction(mdr.Contact(mdr.FlatEndedCone(0.608, 0.191), film), 0.3)
    >>> sheared = friction.shear(friction.contact.at_radius(0.614))
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     state = sheared.at_shift(0.98 * sheared.sliding_shift)
    >>> print({one.category.__name__ for one in issued})
    {'SlipInsideWarning'}
    """


class BeyondRangeWarning(MDRWarning):
    """A compiled law that continues beyond its range was evaluated there.

    The numbers are those of its tangent.

    Examples
    --------
    >>> import warnings
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> law = mdr.ContactLaw(contact, 10e-6, continue_beyond=True)
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     force = law.force(20e-6)
    >>> print(issued[0].category.__name__)
    BeyondRangeWarning
    """


class LargeStrainWarning(MDRWarning):
    """A state outside linear elasticity, which assumes small slopes and strains.

    It is issued in four cases. The slope of the indenter at the contact edge is above 1.2. The mean pressure is above 0.6 contact
    moduli. Layers are compressed by more than half of their thickness. The work of adhesion is above 0.05 of the surface tension
    (under a plate above 0.05 of B^(1/3) (E*/2)^(2/3), if that is larger), so that the angle between surface and indenter is not
    small.

    Examples
    --------
    >>> import warnings
    >>> contact = mdr.Contact(mdr.Cone(half_angle=30.0, degrees=True), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     state = contact.at_depth(1e-6)
    >>> print(issued[0].category.__name__)
    LargeStrainWarning
    """


class UnitsWarning(MDRWarning):
    """Young's moduli of one contact differ by a factor of 1e9 or more.

    One of them is probably in another unit, as GPa next to Pa.

    Examples
    --------
    >>> import warnings
    >>> film = mdr.Coated(mdr.Elastic(72.0, 0.17), 1e-6, mdr.Elastic(165e9, 0.22))
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     state = mdr.Contact(mdr.Sphere(10e-6), film).at_depth(1e-9)
    >>> print({one.category.__name__ for one in issued})
    {'UnitsWarning'}
    """


class PlasticityWarning(MDRWarning):
    """A plastic result at the end of the range in which it holds.

    Unloading yields again (`Imprint.reverse_yield`), or measured numbers contradict the pressure by a little.

    Examples
    --------
    >>> import warnings
    >>> imprint = mdr.plastic.Imprint.from_two_terms(mdr.Homogeneous(mdr.Elastic(200e9, 0.3)), 1e-5, 2.5e9, 1.2e9)
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     ratio, layer = imprint.reverse_yield(1e9)
    >>> print(issued[0].category.__name__)
    PlasticityWarning
    """


class ShortZoneWarning(MDRWarning):
    """The cohesive zone is too short to affect the result.

    It is neglected; the states are those of the JKR limit.

    Examples
    --------
    >>> import warnings
    >>> rubber = mdr.Homogeneous(mdr.Elastic(1e6, 0.5))
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     contact = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05, cohesive_stress=1e14)
    ...     state = contact.at_depth(1e-6)
    >>> print({one.category.__name__ for one in issued})
    {'ShortZoneWarning'}
    """


class InteriorAccuracyWarning(MDRWarning):
    """Displacements and stresses inside a body have a noticeable error.

    The deviation at the surface exceeds 1e-8 of the depth or of the largest pressure, and 10 times the tolerance of the medium. The
    text states it: s_zz and u_z at the surface are compared with p(r) and d - f(r) of the contact.

    Examples
    --------
    >>> import warnings
    >>> contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(210.0, 0.3)))
    >>> right = contact.at_radius(1.0)
    >>> wrong = mdr.State(1.000001 * right.depth, right.radius, right.force, right.stiffness, contact=contact)
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     field = wrong.interior(np.linspace(0.0, 2.0, 1000), 0.1)
    >>> print({one.category.__name__ for one in issued})
    {'InteriorAccuracyWarning'}
    """


class AdhesionRateWarning(MDRWarning):
    """A work of adhesion from rheology is used outside its range.

    The contact is too fast for a relaxed body, v time/a > 0.02, or the cohesive zone is too long for a steady crack, zone/a > 0.03.
    The error of pull-off exceeds 2 %.

    Examples
    --------
    >>> import warnings
    >>> rubber = mdr.Viscoelastic(1e6, [(9e6, 1e-3)], nu=0.5)
    >>> law = mdr.adhesion.RheologicalAdhesion(rubber, work=0.05, cohesive_stress=1e6)
    >>> contact = mdr.Contact(mdr.Paraboloid(1e-3), mdr.Homogeneous(rubber.relaxed), adhesion=law)
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     path = mdr.adhesion.rate_history(contact, [0.0, 1.0, 1.1], depth=[1e-6, 1e-6, -20e-6], start="rest")
    >>> print({one.category.__name__ for one in issued})
    {'AdhesionRateWarning'}
    """


class PathEndsWarning(MDRWarning):
    """A path of wear ends before its last part.

    An example is a contact that would grow beyond the end of the indenter. The states are those of the parts before, and the
    history remains at the last of them.

    Examples
    --------
    >>> import warnings
    >>> wear = mdr.wear.Wear(mdr.Contact(mdr.Sphere(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))), 1.0)
    >>> history = wear.history(force=0.1, intervals=16, scheme="rings")
    >>> with warnings.catch_warnings(record=True) as issued:
    ...     warnings.simplefilter("always")
    ...     states = history.advance([0.1, 60.0], force=[0.1, 0.1])
    >>> print({one.category.__name__ for one in issued})
    {'PathEndsWarning'}
    """


_BY_STATUS: dict[int, type[MDRError]] = {
    1: InvalidArgumentError,  # MDR_ENULL
    2: InvalidArgumentError,  # MDR_EINVALID
    3: DomainError,
    4: UnreachableError,
    5: NoConvergenceError,
    6: OutOfMemoryError,
    7: CallbackError,
    8: FileError,
    9: CancelledError,
}


def error_class(status: int) -> type[MDRError]:
    """The exception class of a status code of mdrcontact.h."""
    return _BY_STATUS.get(status, MDRError)
