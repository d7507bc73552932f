! SPDX-License-Identifier: GPL-3.0-or-later
!> The version, for C.
module mdrcontact_api_version
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_version, only: version_major, version_minor, version_patch
    implicit none (type, external)
    private
    public :: mdr_version

contains

    pure function mdr_version() result(version) bind(C)
        integer(c_int) :: version

        version = int(10000*version_major + 100*version_minor + version_patch, c_int)
    end function mdr_version

end module mdrcontact_api_version
