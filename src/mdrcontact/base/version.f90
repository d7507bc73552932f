! SPDX-License-Identifier: GPL-3.0-or-later
!> The version, in the one place where it is written down.
!> CMake and the Python build read the three numbers from this file.
module mdrcontact_version
    implicit none (type, external)
    private
    public :: version_major, version_minor, version_patch, version_string

    !> Changes when programs must be changed.
    integer, parameter :: version_major = 0
    !> Changes with new functions.
    integer, parameter :: version_minor = 1
    !> Changes with repairs.
    integer, parameter :: version_patch = 0
    !> The three numbers as text.
    character(len=*), parameter :: version_string = "0.1.0"

end module mdrcontact_version
