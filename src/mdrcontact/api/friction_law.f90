! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled laws of contacts with friction, for C.
module mdrcontact_api_friction_law
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_arrays, only: check_array, check_count
    use mdrcontact_api_handles, only: hand_over, open_handle
    use mdrcontact_api_law, only: read_law_options
    use mdrcontact_api_options, only: check_size, write_facts
    use mdrcontact_api_status, only: check_given, status_of, wanted_threads
    use mdrcontact_api_text, only: write_text
    use mdrcontact_error, only: error_t, raise_at
    use mdrcontact_history_friction, only: friction_t
    use mdrcontact_law_from_contact, only: law_options_t
    use mdrcontact_law_friction, only: contact_steps_t, default_sliders, friction_law_t
    use mdrcontact_law_friction_from_contact, only: new_friction_law
    implicit none (type, external)
    private
    public :: mdr_friction_law_new, mdr_friction_law_advance, mdr_friction_law_try, mdr_friction_law_energies, &
              mdr_friction_law_turn, mdr_friction_law_info, mdr_friction_law_description

    !> struct mdr_friction_law_facts
    type, bind(C) :: c_friction_law_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: coefficient = 0.0_c_double
        real(c_double) :: highest_force = 0.0_c_double, highest_sliding_shift = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        real(c_double) :: first_shear_error = 0.0_c_double, path_error = 0.0_c_double
        integer(c_int) :: memory_size = 0_c_int, sliders = 0_c_int
        integer(c_int) :: description_length = 0_c_int
        integer(c_int) :: continue_beyond = 0_c_int
    end type c_friction_law_facts_t

contains

    function mdr_friction_law_new(f, largest_depth, sliders, options, out) result(status) &
        bind(C, name="mdrcontact_entry_friction_law_new")
        type(c_ptr), value :: f, options
        real(c_double), value :: largest_depth
        integer(c_int), value :: sliders
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_t), pointer :: friction
        type(friction_law_t), allocatable :: law
        class(*), allocatable :: object
        type(law_options_t) :: chosen
        type(error_t), allocatable :: error

        allocate (law)
        call open_handle(f, "f", friction, error)
        call read_law_options(options, chosen, error)
        if (.not. allocated(error)) then
            call new_friction_law(law, friction, largest_depth, error, chosen, &
                                  merge(default_sliders, int(sliders), sliders == 0_c_int))
        end if
        call move_alloc(law, object)
        status = hand_over(object, out, error)
    end function mdr_friction_law_new

    function mdr_friction_law_advance(law, n, force, shift, tangent, memory, traction) result(status) &
        bind(C, name="mdrcontact_entry_friction_law_advance")
        type(c_ptr), value :: law, tangent
        integer(c_int), value :: n
        real(c_double), intent(in), optional, target :: force(n), shift(3, n)
        type(c_ptr), value :: memory
        real(c_double), intent(inout), optional, target :: traction(3, n)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call do_steps(law, n, force, shift, tangent, memory, traction, .false., error)
        status = status_of(error)
    end function mdr_friction_law_advance

    function mdr_friction_law_try(law, n, force, shift, tangent, memory, traction) result(status) &
        bind(C, name="mdrcontact_entry_friction_law_try")
        type(c_ptr), value :: law, tangent
        integer(c_int), value :: n
        real(c_double), intent(in), optional, target :: force(n), shift(3, n)
        type(c_ptr), value :: memory
        real(c_double), intent(inout), optional, target :: traction(3, n)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call do_steps(law, n, force, shift, tangent, memory, traction, .true., error)
        status = status_of(error)
    end function mdr_friction_law_try

    subroutine do_steps(law, n, force, shift, tangent, memory, traction, is_trial, error)
        type(c_ptr), intent(in) :: law, tangent, memory
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional, target :: force(n), shift(3, n)
        real(c_double), intent(inout), optional, target :: traction(3, n)
        logical, intent(in) :: is_trial
        type(error_t), allocatable, intent(inout) :: error
        type(friction_law_t), pointer :: inside
        type(contact_steps_t) :: steps

        call open_handle(law, "law", inside, error)
        call check_count(error, n)
        call check_array(error, "force", n, present(force))
        call check_array(error, "shift", n, present(shift))
        call check_array(error, "memory", n, c_associated(memory))
        call check_array(error, "T", n, present(traction))
        if (allocated(error) .or. n < 1) return
        call c_f_pointer(c_loc(force), steps%force, [int(n)])
        call c_f_pointer(c_loc(shift), steps%shift, [3, int(n)])
        call c_f_pointer(memory, steps%memory, [inside%memory_size(), int(n)])
        call c_f_pointer(c_loc(traction), steps%traction, [3, int(n)])
        if (c_associated(tangent)) call c_f_pointer(tangent, steps%tangent, [4, 3, int(n)])
        steps%is_trial = is_trial
        call inside%steps(steps, wanted_threads(), error)
    end subroutine do_steps

    function mdr_friction_law_energies(law, n, memory, stored, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_friction_law_energies")
        type(c_ptr), value :: law, memory
        integer(c_int), value :: n
        real(c_double), intent(inout), optional :: stored(n), dissipated(n)
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        real(c_double), pointer :: records(:, :)
        real(c_double) :: kept, lost
        type(error_t), allocatable :: error
        integer :: pass, i

        call open_records(law, n, memory, inside, records, error)
        ! all are possible before the first is written
        do pass = 1, 2
            if (allocated(error)) exit
            do i = 1, n
                call inside%energies(records(:, i), kept, lost, error)
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
    end function mdr_friction_law_energies

    function mdr_friction_law_turn(law, n, normal, spin, memory) result(status) bind(C, name="mdrcontact_entry_friction_law_turn")
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
        call check_array(error, "normal", n, present(normal))
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
    end function mdr_friction_law_turn

    !> The records of n contacts.
    subroutine open_records(law, n, memory, inside, records, error)
        type(c_ptr), intent(in) :: law, memory
        integer(c_int), intent(in) :: n
        type(friction_law_t), pointer, intent(out) :: inside
        real(c_double), pointer, intent(out) :: records(:, :)
        type(error_t), allocatable, intent(inout) :: error

        nullify (records)
        call open_handle(law, "law", inside, error)
        call check_count(error, n)
        call check_array(error, "memory", n, c_associated(memory))
        if (.not. allocated(error)) call c_f_pointer(memory, records, [inside%memory_size(), max(int(n), 0)])
    end subroutine open_records

    function mdr_friction_law_info(law, facts) result(status) bind(C, name="mdrcontact_entry_friction_law_info")
        type(c_ptr), value :: law, facts
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        type(c_friction_law_facts_t), target :: made
        integer(c_size_t) :: used
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_size(error, "facts", facts, c_sizeof(made), used)
        status = status_of(error)
        if (allocated(error)) return
        associate (table => inside%law%by_force)
            made = c_friction_law_facts_t(used, inside%coefficient, table%highest, inside%coefficient*inside%law%by_depth%highest, &
                                           inside%law%tolerance, inside%first_shear_error, inside%path_error, &
                                           int(inside%memory_size(), c_int), int(inside%sliders, c_int), &
                                           len(inside%law%description, kind=c_int), merge(1_c_int, 0_c_int, table%continued))
        end associate
        call write_facts(facts, c_loc(made), used)
    end function mdr_friction_law_info

    function mdr_friction_law_description(law, buffer, length) result(status) bind(C)
        type(c_ptr), value :: law, buffer
        integer(c_int), value :: length
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_given(error, "buffer", c_associated(buffer) .or. length < 1)
        status = status_of(error)
        if (allocated(error) .or. length < 1) return
        call write_text(inside%law%description, int(length), buffer)
    end function mdr_friction_law_description

end module mdrcontact_api_friction_law
