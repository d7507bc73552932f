# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions, one class for each status of the library; the words are the library's own."""

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
    "ShortZoneWarning",
    "InteriorAccuracyWarning",
    "AdhesionRateWarning",
]


class MDRError(Exception):
    """Anything the library refuses or cannot do; the base of all exceptions below."""


class InvalidArgumentError(MDRError, ValueError):
    """An argument has a value that is never allowed: NaN, E <= 0, a table that does not ascend, an unknown model, ..."""


class ArgumentTypeError(MDRError, TypeError):
    """An argument is of the wrong kind: a text or a complex number where a real number is needed, ..."""


class DomainError(MDRError, ValueError):
    """A point lies outside the region where the object is defined: r > a, beyond the end of a table, ..."""


class UnreachableError(MDRError, ValueError):
    """No contact state has the requested depth, force or radius."""


class NoConvergenceError(MDRError, ArithmeticError):
    """An iteration or a refinement ended before it met its tolerance."""


class OutOfMemoryError(MDRError, MemoryError):
    """Memory could not be allocated."""


class CallbackError(MDRError, ValueError):
    """A user's function returned NaN, infinity or no number. What it raises itself is raised unchanged."""


class FileError(MDRError, OSError):
    """A file could not be read or written, or is damaged."""


class CancelledError(MDRError):
    """Work was ended before it was done: by the `stop` of its `Progress`, or in another thread because the one that waits for it
    was interrupted."""


class MDRWarning(UserWarning):
    """A number that comes with a doubt; the base of all warnings below."""


class SeparationInsideWarning(MDRWarning):
    """The pressure of a contact without adhesion is negative somewhere: on this stiff coating the contact is not one disc. Its
    pressure is not that of the true contact; F(d) is off by at most a few per cent where the coating is up to 200 times stiffer
    than the body, by more beyond. Or the surface beyond the contact would pass through the indenter. Under a plate (`Surface`) F(d)
    is not that of the true contact either."""


class SlipInsideWarning(MDRWarning):
    """Partial slip as an annulus at the edge would need more than coefficient times pressure inside: slip begins there, too, on
    this stiff coating. Forces, energies and tractions are not those of the true contact; by rings, `Friction.history`, they are."""


class BeyondRangeWarning(MDRWarning):
    """A compiled law that continues beyond its range was evaluated there: the numbers are those of its tangent."""


class LargeStrainWarning(MDRWarning):
    """A state beyond linear elasticity, which holds for small slopes and strains: the indenter's slope at the edge of the contact
    is above 1.2, the mean pressure above 0.6 contact moduli, layers are compressed by more than half of their thickness, or the
    work of adhesion is above 0.05 of the surface tension (under a plate of B^(1/3) (E*/2)^(2/3), if that is more), so that the
    surface meets the indenter at an angle that is not small."""


class UnitsWarning(MDRWarning):
    """Young's moduli of one contact are 1e9 apart or more: one of them may be in another unit, as GPa beside Pa."""


class ShortZoneWarning(MDRWarning):
    """The zone of a cohesive stress is too short to change a digit: the states are those of adhesion without a range (JKR)."""


class InteriorAccuracyWarning(MDRWarning):
    """Displacements and stresses inside a body are off by more than 1e-8 of the depth and of the largest pressure, and 10 times the
    tolerance of its medium: by about as much as the text says, s_zz and u_z at the surface differ from the contact's p(r) and
    d - f(r)."""


class AdhesionRateWarning(MDRWarning):
    """A work of adhesion that follows from the rheology of the surface is used where the contact is too fast, v time/a > 0.02, or
    its cohesive zone too long, zone/a > 0.03, for a steady crack in a relaxed body: pull-off is off by more than 2 %."""


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
