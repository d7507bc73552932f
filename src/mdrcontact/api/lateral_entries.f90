! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of lateral that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_lateral_entries
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_funptr, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_not_negative, make_room
    use mdrcontact_api_handles, only: return_object, return_solver
    use mdrcontact_api_lateral_open_handle, only: open_handle
    use mdrcontact_api_lateral_structure, only: c_field_t, read_structure_options
    use mdrcontact_api_records, only: c_structure_options_t
    use mdrcontact_api_status, only: check_given, status_of, wanted_threads
    use mdrcontact_error, only: check_poisson, error_t
    use mdrcontact_lateral_field, only: field_structure_t, new_field_structure
    use mdrcontact_lateral_medium, only: new_lateral_medium
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_lateral_values, only: density_values, structure_values
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_tabulated, only: tabulated_medium_t
    implicit none (type, external)
    private
    public :: mdr_structure_function
    public :: mdr_structure_modulus
    public :: mdr_structure_medium
    public :: mdr_lateral_density

contains

    function mdr_structure_function(field, context, reference_nu, options, out) result(status) &
        bind(C, name="mdrcontact_entry_structure_function")
        type(c_funptr), value :: field
        type(c_ptr), value :: context, options
        real(c_double), value :: reference_nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(field_structure_t), allocatable :: made
        class(*), allocatable :: object
        type(c_structure_options_t) :: chosen
        type(error_t), allocatable :: error

        allocate (made)
        call read_structure_options(error, options, chosen)
        if (.not. allocated(error)) call check_given(error, "field", c_associated(field))
        if (.not. allocated(error)) then
            call new_field_structure(made, c_field_t(function=field, context=context), reference_nu, error, chosen%tolerance, &
                chosen%exponent)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_structure_function

    function mdr_structure_modulus(s, n, x, y, a, out) result(status) &
        bind(C, name="mdrcontact_entry_structure_modulus")
        type(c_ptr), value :: s
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*), y(*), a(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(structure_t), pointer :: s_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(s, "s", s_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call structure_values(s_inside, x(:n), y(:n), a(:n), out_values, wanted_threads(), error)
        end if
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_structure_modulus

    function mdr_structure_medium(s, x, y, smallest_radius, largest_radius, points, out) result(status) &
        bind(C, name="mdrcontact_entry_structure_medium")
        type(c_ptr), value :: s
        real(c_double), value :: x, y, smallest_radius, largest_radius
        integer(c_int), value :: points
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(tabulated_medium_t), allocatable :: made
        class(solver_t), allocatable :: object
        class(structure_t), pointer :: s_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(s, "s", s_inside, error)
        if (.not. allocated(error)) call new_lateral_medium(made, s_inside, x, y, smallest_radius, largest_radius, error, points)
        call move_alloc(made, object)
        status = return_solver(object, out, error)
    end function mdr_structure_medium

    function mdr_lateral_density(n, rho, z, nu, shear, poisson) result(status) &
        bind(C, name="mdrcontact_entry_lateral_density")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: rho(*), z(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: shear(*), poisson(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check_poisson(error, "nu", nu)
        if (.not. allocated(error) .and. n > 0) call check_each_not_negative(error, "rho", rho(:n))
        if (.not. allocated(error) .and. n > 0) call check_each_not_negative(error, "z", z(:n))
        if (.not. allocated(error) .and. n > 0) call density_values(rho(:n), z(:n), nu, shear(:n), poisson(:n), wanted_threads())
        status = status_of(error)
    end function mdr_lateral_density

end module mdrcontact_api_lateral_entries
