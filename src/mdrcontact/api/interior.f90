! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses and displacements inside the bodies of a contact, for C.
module mdrcontact_api_interior
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_results_or_infinity
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: check_given, check_memory, status_of, wanted_threads
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_field_interior, only: components
    implicit none (type, external)
    private
    public :: mdr_contact_interior, mdr_contact_layer_energies

    !> enum mdr_body, enum mdr_side
    integer(c_int), parameter :: lower_body = 1_c_int, upper_body = 2_c_int, side_below = 1_c_int, side_above = 2_c_int

contains

    function mdr_contact_interior(c, body, state, side, friction, n, r, z, angle, out) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: body, side, n
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: friction
        real(c_double), intent(in), optional :: r(*), z(*), angle(*)
        !> rows of struct mdr_interior
        real(c_double), intent(inout), optional :: out(components, *)
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        real(c_double), allocatable :: field(:, :), azimuth(:)
        type(error_t), allocatable :: error
        integer :: stat

        call open_handle(c, "c", contact, error)
        call check_choice(error, "body", body, "1 (lower) or 2 (upper)")
        call check_given(error, "state", present(state))
        call check_choice(error, "side", side, "1 (below) or 2 (above)")
        call check_count(error, n)
        call check_array(error, "r", n, present(r))
        call check_array(error, "z", n, present(z))
        call check_array(error, "out", n, present(out))
        if (.not. allocated(error)) then
            allocate (field(n, components), stat=stat)
            if (stat == 0) allocate (azimuth(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) then
            azimuth = 0.0_c_double
            if (present(angle)) azimuth = angle(:n)
            call contact%interior(state, body == upper_body, r(:n), z(:n), side == side_below, friction, azimuth, field, error, &
                                  wanted_threads())
            if (.not. allocated(error)) call check_results_or_infinity(error, reshape(transpose(field), [size(field)]))
            if (.not. allocated(error)) out(:, :n) = transpose(field)
        end if
        status = status_of(error)
    end function mdr_contact_interior

    function mdr_contact_layer_energies(c, body, state, capacity, out, count) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: body, capacity
        type(contact_state_t), intent(in), optional :: state
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        real(c_double), allocatable :: energies(:)
        type(error_t), allocatable :: error
        integer :: n

        call open_handle(c, "c", contact, error)
        call check_choice(error, "body", body, "1 (lower) or 2 (upper)")
        call check_given(error, "state", present(state))
        if (capacity < 0) call raise(error, error_invalid, "capacity = "//count_text(int(capacity))// &
                                     " is not allowed: it must be at least 0")
        call check_array(error, "out", capacity, present(out))
        call check_given(error, "count", present(count))
        if (.not. allocated(error)) call contact%layer_energy(state, body == upper_body, energies, error)
        status = status_of(error)
        if (allocated(error)) return
        count = size(energies, kind=c_int)
        n = min(size(energies), int(capacity))
        if (present(out)) out(:n) = energies(:n)
    end function mdr_contact_layer_energies

    !> Raises unless a choice is 1 or 2: the values of both enumerations.
    subroutine check_choice(error, name, choice, allowed)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name, allowed
        integer(c_int), intent(in) :: choice

        if (choice == lower_body .or. choice == side_above) return
        call raise(error, error_invalid, name//" = "//count_text(int(choice))//" is not allowed: it must be "//allowed)
    end subroutine check_choice

end module mdrcontact_api_interior
