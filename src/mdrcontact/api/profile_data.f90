! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenter profiles from area functions, tables, user functions and other profiles, for C.
module mdrcontact_api_profile_data
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_not_empty
    use mdrcontact_api_callback, only: c_function_t, new_c_function
    use mdrcontact_api_handles, only: hand_over
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_error, only: check_code, check_memory, error_invalid, error_t, raise, raise_at
    use mdrcontact_profile, only: copy, profile_t
    use mdrcontact_profile_area_function, only: area_function_t, new_area_function_profile
    use mdrcontact_profile_sampled, only: sampled_profile_t
    use mdrcontact_profile_sum, only: new_profile_sum, profile_sum_t, profile_term_t
    use mdrcontact_profile_tabulated, only: new_profile_from_function, new_profile_from_mdr, new_tabulated_profile
    use mdrcontact_profile_values, only: of_height, of_mdr
    implicit none (type, external)
    private
    public :: mdr_profile_area_function, mdr_profile_table, mdr_profile_function, mdr_profile_sum

contains

    function mdr_profile_area_function(n, coefficients, min_height, max_height, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_area_function")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: coefficients(*)
        real(c_double), value :: min_height, max_height
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(area_function_t), allocatable :: profile
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (profile)
        if (n == 0) call raise(error, error_invalid, "coefficients is empty: at least C0 is needed")
        if (.not. allocated(error)) call new_area_function_profile(profile, coefficients(:n), min_height, max_height, error)
        call move_alloc(profile, object)
        status = hand_over(object, out, error)
    end function mdr_profile_area_function

    function mdr_profile_table(quantity, n, x, y, out) result(status) bind(C, name="mdrcontact_entry_profile_table")
        integer(c_int), value :: quantity, n
        real(c_double), intent(in), optional :: x(*), y(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(sampled_profile_t), allocatable :: profile
        class(*), allocatable :: object
        type(error_t), allocatable :: error
        logical :: is_height

        allocate (profile)
        is_height = quantity == of_height
        if (.not. is_height .and. quantity /= of_mdr) then
            call check_code(error, "quantity", int(quantity), [of_height, of_mdr])
        end if
        call check_not_empty(error, merge("r", "x", is_height), n, 3)
        if (.not. allocated(error)) then
            if (is_height) then
                call new_tabulated_profile(profile, x(:n), y(:n), error)
            else
                call new_profile_from_mdr(profile, x(:n), y(:n), error)
            end if
        end if
        call move_alloc(profile, object)
        status = hand_over(object, out, error)
    end function mdr_profile_table

    function mdr_profile_function(height, context, largest_radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_function")
        type(c_funptr), value :: height
        type(c_ptr), value :: context
        real(c_double), value :: largest_radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_function_t) :: f
        type(sampled_profile_t), allocatable :: profile
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (profile)
        call new_c_function(f, "height", height, context, error)
        if (.not. allocated(error)) call new_profile_from_function(profile, f, largest_radius, error)
        call move_alloc(profile, object)
        status = hand_over(object, out, error)
    end function mdr_profile_function

    function mdr_profile_sum(n, terms, out) result(status) bind(C, name="mdrcontact_entry_profile_sum")
        integer(c_int), value :: n
        type(c_ptr), intent(in), optional :: terms(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(profile_sum_t), allocatable :: profile
        class(*), allocatable :: object
        type(profile_term_t), allocatable :: copies(:)
        type(error_t), allocatable :: error

        allocate (profile)
        if (n == 0) call raise(error, error_invalid, "terms is empty: at least one is needed")
        call check_array(error, "terms", n, present(terms))
        if (.not. allocated(error)) call copy_terms(terms(:n), copies, error)
        if (.not. allocated(error)) call new_profile_sum(profile, copies, error)
        call move_alloc(profile, object)
        status = hand_over(object, out, error)
    end function mdr_profile_sum

    subroutine copy_terms(terms, copies, error)
        type(c_ptr), intent(in) :: terms(:)
        type(profile_term_t), allocatable, intent(out) :: copies(:)
        type(error_t), allocatable, intent(inout) :: error
        class(profile_t), pointer :: term
        integer :: i, stat

        allocate (copies(size(terms)), stat=stat)
        call check_memory(error, stat)
        do i = 1, size(terms)
            call open_handle(terms(i), "terms", term, error)
            if (allocated(error)) then
                call raise_at(error, i)
                return
            end if
            call copy(term, copies(i)%profile, error)
            if (allocated(error)) return
        end do
    end subroutine copy_terms

end module mdrcontact_api_profile_data
