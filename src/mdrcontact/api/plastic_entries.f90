! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of plastic that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_plastic_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_plastic_open_handle, only: open_handle
    use mdrcontact_error, only: error_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_plastic_imprint, only: imprint_t, new_imprint
    implicit none (type, external)
    private
    public :: mdr_imprint_two_terms

contains

    function mdr_imprint_two_terms(medium, radius, uniform, hertz, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_two_terms")
        type(c_ptr), value :: medium
        real(c_double), value :: radius, uniform, hertz, depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: medium_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(medium, "medium", medium_inside, error)
        if (.not. allocated(error)) call new_imprint(made, medium_inside, radius, uniform, hertz, depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_two_terms

end module mdrcontact_api_plastic_entries
