! SPDX-License-Identifier: GPL-3.0-or-later
!> Media whose effective modulus is a table or a user's function, for C.
module mdrcontact_api_medium_data
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_not_empty, check_each_positive
    use mdrcontact_api_callback, only: c_function_t, new_c_function
    use mdrcontact_api_handles, only: hand_over_solver
    use mdrcontact_error, only: check_table, error_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_tabulated, only: new_medium_from_function, new_tabulated_medium, tabulated_medium_t
    implicit none (type, external)
    private
    public :: mdr_medium_table, mdr_medium_function

contains

    function mdr_medium_table(n, a, moduli, out) result(status) bind(C, name="mdrcontact_entry_medium_table")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*), moduli(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(tabulated_medium_t), allocatable :: medium
        class(solver_t), allocatable :: solver
        type(error_t), allocatable :: error

        allocate (medium)
        call check_not_empty(error, "a", n, 3)
        if (.not. allocated(error)) then
            call check_table(error, "a", a(:n), "moduli", moduli(:n), 3)
            call check_each_positive(error, "a", a(:n))
            call check_each_positive(error, "moduli", moduli(:n))
        end if
        if (.not. allocated(error)) call new_tabulated_medium(medium, a(:n), moduli(:n), error)
        call move_alloc(medium, solver)
        status = hand_over_solver(solver, out, error)
    end function mdr_medium_table

    function mdr_medium_function(modulus, context, smallest_radius, largest_radius, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_function")
        type(c_funptr), value :: modulus
        type(c_ptr), value :: context
        real(c_double), value :: smallest_radius, largest_radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_function_t) :: f
        type(tabulated_medium_t), allocatable :: medium
        class(solver_t), allocatable :: solver
        type(error_t), allocatable :: error

        allocate (medium)
        call new_c_function(f, "modulus", modulus, context, error)
        if (.not. allocated(error)) call new_medium_from_function(medium, f, smallest_radius, largest_radius, error)
        call move_alloc(medium, solver)
        status = hand_over_solver(solver, out, error)
    end function mdr_medium_function

end module mdrcontact_api_medium_data
