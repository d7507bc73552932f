! SPDX-License-Identifier: GPL-3.0-or-later
!> The tangential force of compiled laws with friction, for C.
module mdrcontact_api_law_friction
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_ptr
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: error_invalid, error_t, raise, raise_at
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_friction, only: contact_steps_t, friction_law_t
    implicit none (type, external)
    private
    public :: mdr_law_advance, mdr_law_energies, mdr_law_turn

contains

    function mdr_law_advance(law, n, force, shift, is_trial, tangent, memory, traction) result(status) &
        bind(C, name="mdrcontact_entry_law_advance")
        type(c_ptr), value :: law, tangent, memory
        integer(c_int), value :: n, is_trial
        real(c_double), intent(in), optional, target :: force(n), shift(3, n)
        real(c_double), intent(inout), optional, target :: traction(3, n)
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        type(contact_steps_t) :: steps
        type(error_t), allocatable :: error

        call open_friction(law, inside, error)
        if (.not. allocated(error) .and. n > 0) then
            call c_f_pointer(c_loc(force), steps%force, [int(n)])
            call c_f_pointer(c_loc(shift), steps%shift, [3, int(n)])
            call c_f_pointer(memory, steps%memory, [inside%memory_size(), int(n)])
            call c_f_pointer(c_loc(traction), steps%traction, [3, int(n)])
            if (c_associated(tangent)) call c_f_pointer(tangent, steps%tangent, [4, 3, int(n)])
            steps%is_trial = is_trial /= 0_c_int
            call inside%steps(steps, wanted_threads(), error)
        end if
        status = status_of(error)
    end function mdr_law_advance

    function mdr_law_energies(law, n, memory, stored, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_law_energies")
        type(c_ptr), value :: law, memory
        integer(c_int), value :: n
        real(c_double), intent(inout), optional :: stored(n), dissipated(n)
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        real(c_double), pointer :: records(:, :)
        real(c_double), allocatable :: record(:)
        real(c_double) :: kept, lost
        type(error_t), allocatable :: error
        integer :: pass, i

        call open_records(law, n, memory, inside, records, error)
        ! all are possible before the first is written
        do pass = 1, 2
            if (allocated(error)) exit
            do i = 1, n
                record = records(:, i)
                call inside%energies(record, kept, lost, error)
                if (allocated(error)) then
                    call raise_at(error, i)
                    exit
                end if
                if (pass == 1) cycle
                if (present(stored)) stored(i) = kept
                if (present(dissipated)) dissipated(i) = lost
            end do
        end do
        status = status_of(error)
    end function mdr_law_energies

    function mdr_law_turn(law, n, normal, spin, memory) result(status) bind(C, name="mdrcontact_entry_law_turn")
        type(c_ptr), value :: law, memory
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: normal(3, n), spin(n)
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        real(c_double), pointer :: records(:, :)
        real(c_double), allocatable :: record(:)
        real(c_double) :: angle
        type(error_t), allocatable :: error
        integer :: pass, i

        call open_records(law, n, memory, inside, records, error)
        ! all are possible before the first is turned
        do pass = 1, 2
            if (allocated(error)) exit
            do i = 1, n
                record = records(:, i)
                angle = 0.0_c_double
                if (present(spin)) angle = spin(i)
                call inside%turn(normal(:, i), angle, record, error)
                if (allocated(error)) then
                    call raise_at(error, i)
                    exit
                end if
                if (pass == 2) records(:, i) = record
            end do
        end do
        status = status_of(error)
    end function mdr_law_turn

    !> The records of n contacts.
    subroutine open_records(law, n, memory, inside, records, error)
        type(c_ptr), intent(in) :: law, memory
        integer(c_int), intent(in) :: n
        type(friction_law_t), pointer, intent(out) :: inside
        real(c_double), pointer, intent(out) :: records(:, :)
        type(error_t), allocatable, intent(inout) :: error

        nullify (records)
        call open_friction(law, inside, error)
        if (.not. allocated(error)) call c_f_pointer(memory, records, [inside%memory_size(), max(int(n), 0)])
    end subroutine open_records

    !> The sliders of a law; null after an error.
    subroutine open_friction(law, inside, error)
        type(c_ptr), intent(in) :: law
        type(friction_law_t), pointer, intent(out) :: inside
        type(error_t), allocatable, intent(inout) :: error
        type(contact_law_t), pointer :: whole

        nullify (inside)
        call open_handle(law, "law", whole, error)
        if (allocated(error)) return
        if (allocated(whole%friction)) then
            inside => whole%friction
        else
            call raise(error, error_invalid, ": it has no friction. Create it with options.friction", "law")
        end if
    end subroutine open_friction

end module mdrcontact_api_law_friction
