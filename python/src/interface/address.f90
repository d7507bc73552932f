! SPDX-License-Identifier: GPL-3.0-or-later
!> Handles and functions travel through Python as addresses: f2py knows no pointers.
module mdrcontact_address
    use, intrinsic :: iso_c_binding, only: c_funptr, c_int64_t, c_null_funptr, c_null_ptr, c_ptr
    implicit none (type, external)
    private
    public :: to_address, to_function, to_pointer

contains

    !> The address a pointer holds.
    pure function to_address(pointer) result(address)
        type(c_ptr), intent(in) :: pointer
        integer(c_int64_t) :: address

        address = transfer(pointer, 0_c_int64_t)
    end function to_address

    !> The pointer of an address.
    elemental function to_pointer(address) result(pointer)
        integer(c_int64_t), intent(in) :: address
        type(c_ptr) :: pointer

        pointer = transfer(address, c_null_ptr)
    end function to_pointer

    !> The function pointer of an address.
    pure function to_function(address) result(pointer)
        integer(c_int64_t), intent(in) :: address
        type(c_funptr) :: pointer

        pointer = transfer(address, c_null_funptr)
    end function to_function

end module mdrcontact_address
