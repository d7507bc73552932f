! SPDX-License-Identifier: GPL-3.0-or-later
!> The words of the last failure: the one function of the C API that the core writes in C.
module mdrcontact_last_error
    use, intrinsic :: iso_c_binding, only: c_char, c_int
    implicit none (type, external)
    private
    public :: mdr_last_error

    interface

        function mdr_last_error(buffer, length) result(full_length) bind(C)
            import :: c_char, c_int
            implicit none (type, external)
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int), value :: length
            integer(c_int) :: full_length
        end function mdr_last_error

    end interface

end module mdrcontact_last_error
