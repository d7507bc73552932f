! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure, surface displacement and line load of a contact state, for C.
module mdrcontact_api_fields
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_results_or_infinity
    use mdrcontact_api_handles, only: open_contact
    use mdrcontact_api_status, only: check_memory, status_of
    use mdrcontact_batch, only: check_threads
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_field, field_displacement, field_line_load, field_pressure
    use mdrcontact_error, only: error_t
    implicit none (type, external)
    private
    public :: mdr_contact_pressure, mdr_contact_displacement, mdr_contact_line_load
    public :: mdr_contact_pressure_threads, mdr_contact_displacement_threads, mdr_contact_line_load_threads
    public :: mdr_contact_pressure_at_depth_threads, mdr_contact_displacement_at_depth_threads, &
              mdr_contact_line_load_at_depth_threads
    public :: mdr_contact_pressure_at_depth, mdr_contact_displacement_at_depth, mdr_contact_line_load_at_depth

contains

    function mdr_contact_pressure(c, a, n, r, out) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: a
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_pressure, a, .false., n, "r", r, out, 1_c_int)
    end function mdr_contact_pressure

    function mdr_contact_displacement(c, a, n, r, out) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: a
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_displacement, a, .false., n, "r", r, out, 1_c_int)
    end function mdr_contact_displacement

    function mdr_contact_line_load(c, a, n, x, out) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: a
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_line_load, a, .false., n, "x", x, out, 1_c_int)
    end function mdr_contact_line_load

    function mdr_contact_pressure_at_depth(c, d, n, r, out) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: d
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_pressure, d, .true., n, "r", r, out, 1_c_int)
    end function mdr_contact_pressure_at_depth

    function mdr_contact_displacement_at_depth(c, d, n, r, out) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: d
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_displacement, d, .true., n, "r", r, out, 1_c_int)
    end function mdr_contact_displacement_at_depth

    function mdr_contact_line_load_at_depth(c, d, n, x, out) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: d
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_line_load, d, .true., n, "x", x, out, 1_c_int)
    end function mdr_contact_line_load_at_depth

    function mdr_contact_pressure_threads(c, a, n, r, out, threads) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: a
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_pressure, a, .false., n, "r", r, out, threads)
    end function mdr_contact_pressure_threads

    function mdr_contact_displacement_threads(c, a, n, r, out, threads) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: a
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_displacement, a, .false., n, "r", r, out, threads)
    end function mdr_contact_displacement_threads

    function mdr_contact_line_load_threads(c, a, n, x, out, threads) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: a
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_line_load, a, .false., n, "x", x, out, threads)
    end function mdr_contact_line_load_threads

    function mdr_contact_pressure_at_depth_threads(c, d, n, r, out, threads) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: d
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_pressure, d, .true., n, "r", r, out, threads)
    end function mdr_contact_pressure_at_depth_threads

    function mdr_contact_displacement_at_depth_threads(c, d, n, r, out, threads) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: d
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_displacement, d, .true., n, "r", r, out, threads)
    end function mdr_contact_displacement_at_depth_threads

    function mdr_contact_line_load_at_depth_threads(c, d, n, x, out, threads) result(status) bind(C)
        type(c_ptr), value :: c
        real(c_double), value :: d
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(c, field_line_load, d, .true., n, "x", x, out, threads)
    end function mdr_contact_line_load_at_depth_threads

    !> The field of the state at a radius or a depth; nothing is written before all of it is known.
    function write_field(c, field, given, given_is_depth, n, name, positions, out, threads) result(status)
        type(c_ptr), intent(in) :: c
        integer, intent(in) :: field
        real(c_double), intent(in) :: given
        logical, intent(in) :: given_is_depth
        integer(c_int), intent(in) :: n, threads
        character(len=*), intent(in) :: name
        real(c_double), intent(in), optional :: positions(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(contact_state_t) :: state
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_contact(c, "c", contact, error)
        call check_count(error, n)
        call check_array(error, name, n, present(positions))
        call check_array(error, "out", n, present(out))
        call check_threads(error, int(threads))
        if (.not. allocated(error)) then
            if (given_is_depth) then
                call contact%at_depth(given, state, error)
            else
                call contact%at_radius(given, state, error)
            end if
        end if
        if (.not. allocated(error) .and. n > 0) then
            call evaluate(contact, field, state, positions(:n), values, int(threads), error)
        end if
        if (.not. allocated(error) .and. n > 0) out(:n) = values
        status = status_of(error)
    end function write_field

    subroutine evaluate(contact, field, state, positions, values, threads, error)
        type(contact_t), intent(in) :: contact
        integer, intent(in) :: field, threads
        type(contact_state_t), intent(in) :: state
        real(c_double), intent(in) :: positions(:)
        real(c_double), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: stat

        allocate (values(size(positions)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call contact_field(contact, field, state, positions, values, error, threads)
        if (.not. allocated(error)) call check_results_or_infinity(error, values)
    end subroutine evaluate

end module mdrcontact_api_fields
