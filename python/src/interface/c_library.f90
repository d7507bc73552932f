! SPDX-License-Identifier: GPL-3.0-or-later
!> Version and last error of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_library
    use, intrinsic :: iso_c_binding, only: c_char, c_int
    implicit none (type, external)
    private
    public :: mdr_last_error, mdr_version

    interface

        function mdr_version() result(number) bind(C)
            import :: c_int
            implicit none (type, external)
            integer(c_int) :: number
        end function mdr_version

        function mdr_last_error(buffer, length) result(full_length) bind(C)
            import :: c_char, c_int
            implicit none (type, external)
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int), value :: length
            integer(c_int) :: full_length
        end function mdr_last_error

    end interface

end module mdrcontact_c_library
