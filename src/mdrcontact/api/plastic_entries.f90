! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of plastic that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_plastic_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_plastic_open_handle, only: open_handle
    use mdrcontact_error, only: check_count_from, error_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_plastic_imprint, only: imprint_t, new_imprint, new_imprint_from_pressure, new_imprint_of_two_terms
    use mdrcontact_plastic_law, only: plastic_law_t
    use mdrcontact_plastic_law_new, only: with_radius
    use mdrcontact_plastic_profile, only: imprint_profile_t
    implicit none (type, external)
    private
    public :: mdr_imprint_new
    public :: mdr_imprint_two_terms
    public :: mdr_imprint_from_pressure
    public :: mdr_imprint_profile
    public :: mdr_plastic_law_with_radius

contains

    function mdr_imprint_new(medium, radius, force, residual_depth, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_new")
        type(c_ptr), value :: medium
        real(c_double), value :: radius, force, residual_depth, depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: medium_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(medium, "medium", medium_inside, error)
        if (.not. allocated(error)) call new_imprint(made, medium_inside, radius, force, residual_depth, depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_new

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
        if (.not. allocated(error)) call new_imprint_of_two_terms(made, medium_inside, radius, uniform, hertz, depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_two_terms

    function mdr_imprint_from_pressure(medium, n, r, p, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_from_pressure")
        type(c_ptr), value :: medium
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*), p(*)
        real(c_double), value :: depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: medium_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(medium, "medium", medium_inside, error)
        if (.not. allocated(error)) call check_count_from(error, "n", n, 1)
        if (.not. allocated(error) .and. n > 0) call new_imprint_from_pressure(made, medium_inside, r(:n), p(:n), depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_from_pressure

    function mdr_imprint_profile(i, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_profile")
        type(c_ptr), value :: i
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_profile_t), allocatable :: made
        class(*), allocatable :: object
        type(imprint_t), pointer :: i_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(i, "i", i_inside, error)
        if (.not. allocated(error)) made = i_inside%profile
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_profile

    function mdr_plastic_law_with_radius(law, radius, out) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_with_radius")
        type(c_ptr), value :: law
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(plastic_law_t), allocatable :: made
        class(*), allocatable :: object
        type(plastic_law_t), pointer :: law_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(law, "law", law_inside, error)
        if (.not. allocated(error)) call with_radius(law_inside, radius, made, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_plastic_law_with_radius

end module mdrcontact_api_plastic_entries
