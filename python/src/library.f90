! SPDX-License-Identifier: GPL-3.0-or-later
! Version and last error, flat for f2py.

!> 10000 major + 100 minor + patch. See mdr_version.
subroutine version(number)
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_api_version, only: mdr_version
    implicit none (type, external)
    integer(c_int), intent(out) :: number

    number = mdr_version()
end subroutine version

!> The words of the last failure in this thread, ended by a null character. See mdr_last_error.
subroutine last_error(text)
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_last_error, only: mdr_last_error
    implicit none (type, external)
    character(len=2000), intent(out) :: text
    integer(c_int) :: full_length

    text = ""
    full_length = mdr_last_error(text, int(len(text), c_int))
    if (full_length < len(text)) text(full_length + 1:) = ""
end subroutine last_error
