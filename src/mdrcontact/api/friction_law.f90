! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled laws of contacts with friction, for C.
module mdrcontact_api_friction_law
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count
    use mdrcontact_api_handles, only: hand_over, open_handle
    use mdrcontact_api_law, only: read_law_options
    use mdrcontact_api_status, only: check_given, status_of, wanted_threads
    use mdrcontact_api_text, only: write_text
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_history_friction, only: friction_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_from_contact, only: law_options_t
    use mdrcontact_law_friction, only: friction_law_t, friction_memory_t, turn_memory
    use mdrcontact_law_friction_from_contact, only: new_friction_law
    implicit none (type, external)
    private
    public :: mdr_friction_law_new, mdr_friction_law_advance, mdr_friction_law_info, mdr_friction_law_description, &
              mdr_friction_memory_turn

    !> struct mdr_friction_law_facts
    type, bind(C) :: c_friction_law_facts_t
        real(c_double) :: coefficient = 0.0_c_double
        real(c_double) :: highest_force = 0.0_c_double, highest_sliding_shift = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        real(c_double) :: first_shear_error = 0.0_c_double, path_error = 0.0_c_double
        integer(c_int) :: description_length = 0_c_int
        integer(c_int) :: continue_beyond = 0_c_int
    end type c_friction_law_facts_t

    !> How far from 1 the length of a normal may be.
    real(wp), parameter :: loose = 1.0e-6_wp

contains

    function mdr_friction_law_new(f, largest_depth, options, out) result(status) bind(C)
        type(c_ptr), value :: f, options
        real(c_double), value :: largest_depth
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
        if (.not. allocated(error)) call new_friction_law(law, friction, largest_depth, error, chosen)
        call move_alloc(law, object)
        status = hand_over(object, out, error)
    end function mdr_friction_law_new

    function mdr_friction_law_advance(law, n, force, shift, memory) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: n
        real(c_double), intent(in), optional, target :: force(n), shift(3, n)
        type(friction_memory_t), intent(inout), optional, target :: memory(n)
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_count(error, n)
        call check_array(error, "force", n, present(force))
        call check_array(error, "shift", n, present(shift))
        call check_array(error, "memory", n, present(memory))
        if (.not. allocated(error) .and. n > 0) then
            call inside%advance_all(int(n), force, shift, memory, wanted_threads(), error)
        end if
        status = status_of(error)
    end function mdr_friction_law_advance

    function mdr_friction_memory_turn(n, normal, memory) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: normal(3, n)
        type(friction_memory_t), intent(inout), optional :: memory(n)
        integer(c_int) :: status
        type(error_t), allocatable :: error
        integer :: i

        call check_count(error, n)
        call check_array(error, "normal", n, present(normal))
        call check_array(error, "memory", n, present(memory))
        if (.not. allocated(error)) then
            do i = 1, n
                if (.not. abs(norm2(normal(:, i)) - 1.0_wp) <= loose) then
                    call raise(error, error_invalid, " of length "//to_text(norm2(normal(:, i)))//" is not allowed: its length "// &
                               "must be 1", "normal", i)
                    exit
                end if
            end do
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call turn_memory(memory(i), normal(:, i)/norm2(normal(:, i)))
            end do
        end if
        status = status_of(error)
    end function mdr_friction_memory_turn

    function mdr_friction_law_info(law, facts) result(status) bind(C)
        type(c_ptr), value :: law
        type(c_friction_law_facts_t), intent(inout), optional :: facts
        integer(c_int) :: status
        type(friction_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_given(error, "facts", present(facts))
        status = status_of(error)
        if (allocated(error)) return
        associate (table => inside%law%by_force)
            facts = c_friction_law_facts_t(inside%coefficient, table%highest, inside%coefficient*inside%law%by_depth%highest, &
                                           inside%law%tolerance, inside%first_shear_error, inside%path_error, &
                                           len(inside%law%description, kind=c_int), merge(1_c_int, 0_c_int, table%continued))
        end associate
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
