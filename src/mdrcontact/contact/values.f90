! SPDX-License-Identifier: GPL-3.0-or-later
!> Many states of a contact, and its fields at many positions, on one thread or several.
module mdrcontact_contact_values
    use mdrcontact_batch, only: batch_t, check_threads, run_batch, team_size
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: count_text, entry_name, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: states_from_depth, states_from_force, states_from_radius
    public :: pressure_values, displacement_values, line_load_values

    integer, parameter :: by_depth = 1, by_force = 2, by_radius = 3
    integer, parameter :: of_pressure = 1, of_displacement = 2, of_line_load = 3

    type, extends(batch_t) :: states_batch_t
        type(contact_t), pointer :: contact => null()
        integer :: given = by_depth
        integer, allocatable :: branch
        real(wp), pointer :: input(:) => null()
        type(contact_state_t), pointer :: states(:) => null()
    contains
        procedure :: work => solve_states
    end type states_batch_t

    !> Entry i of the batch is every `stride`th position from i on: all threads meet the same mixture of positions, and what a call
    !> solves before its first position is solved once on each.
    type, extends(batch_t) :: field_batch_t
        type(contact_t), pointer :: contact => null()
        type(contact_state_t), pointer :: state => null()
        integer :: field = of_pressure
        integer :: stride = 1
        real(wp), pointer :: positions(:) => null(), values(:) => null()
    contains
        procedure :: work => evaluate_field
    end type field_batch_t

    !> States that a thread takes at a time where each is a formula, and from how many on several threads pay; and those elsewhere.
    integer, parameter :: formula_block = 32, formula_smallest = 512
    integer, parameter :: solved_block = 1, solved_smallest = 2
    !> The same for radii, which cost one solution a state, and for positions of a field.
    integer, parameter :: radius_smallest = 8, field_smallest = 128

contains

    !> contact%at_depth for many depths. Where some fail, the error is that of the first, and `states` is undefined.
    subroutine states_from_depth(contact, depths, states, error, branch, threads)
        type(contact_t), intent(in) :: contact
        !> [length]
        real(wp), intent(in) :: depths(:)
        !> same size as depths
        type(contact_state_t), intent(inout) :: states(:)
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads

        call run(contact, by_depth, depths, states, error, branch, threads)
    end subroutine states_from_depth

    !> contact%at_force for many forces, as states_from_depth.
    subroutine states_from_force(contact, forces, states, error, branch, threads)
        type(contact_t), intent(in) :: contact
        !> [modulus length^2]
        real(wp), intent(in) :: forces(:)
        !> same size as forces
        type(contact_state_t), intent(inout) :: states(:)
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads

        call run(contact, by_force, forces, states, error, branch, threads)
    end subroutine states_from_force

    !> contact%at_radius for many radii, as states_from_depth.
    subroutine states_from_radius(contact, radii, states, error, threads)
        type(contact_t), intent(in) :: contact
        !> [length]
        real(wp), intent(in) :: radii(:)
        !> same size as radii
        type(contact_state_t), intent(inout) :: states(:)
        type(error_t), allocatable, intent(out) :: error
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads

        call run(contact, by_radius, radii, states, error, threads=threads)
    end subroutine states_from_radius

    subroutine run(contact, given, input, states, error, branch, threads)
        type(contact_t), intent(in), target :: contact
        integer, intent(in) :: given
        real(wp), intent(in), target :: input(:)
        type(contact_state_t), intent(inout), target :: states(:)
        type(error_t), allocatable, intent(out) :: error
        integer, intent(in), optional :: branch, threads
        type(states_batch_t) :: batch
        integer :: team, smallest

        team = 1
        if (present(threads)) team = threads
        call check_threads(error, team)
        call check_sizes(error, size(input), size(states))
        if (allocated(error)) return
        batch%contact => contact
        batch%given = given
        if (present(branch)) batch%branch = branch
        batch%input => input
        batch%states => states
        if (contact%is_formula()) then
            call run_batch(batch, size(input), formula_block, formula_smallest, team, error)
        else
            smallest = merge(radius_smallest, solved_smallest, given == by_radius)
            call run_batch(batch, size(input), solved_block, smallest, team, error)
        end if
    end subroutine run

    subroutine solve_states(self, first, last, error)
        class(states_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        do i = first, last
            select case (self%given)
            case (by_depth)
                call self%contact%at_depth(self%input(i), self%states(i), error, self%branch)
            case (by_force)
                call self%contact%at_force(self%input(i), self%states(i), error, self%branch)
            case default
                call self%contact%at_radius(self%input(i), self%states(i), error)
            end select
            if (.not. allocated(error)) cycle
            error%message = "entry "//count_text(i)//": "//error%message
            return
        end do
    end subroutine solve_states

    !> contact%pressure at many positions.
    subroutine pressure_values(contact, state, r, values, error, threads)
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r; undefined after an error
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads

        call run_field(contact, of_pressure, state, r, values, error, threads)
    end subroutine pressure_values

    !> contact%displacement at many positions r >= 0, as pressure_values.
    subroutine displacement_values(contact, state, r, values, error, threads)
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> [length]
        real(wp), intent(in) :: r(:)
        !> same size as r [length]; undefined after an error
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads

        call run_field(contact, of_displacement, state, r, values, error, threads)
    end subroutine displacement_values

    !> contact%line_load at many positions 0 <= x <= a, as pressure_values.
    subroutine line_load_values(contact, state, x, values, error, threads)
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> [length]
        real(wp), intent(in) :: x(:)
        !> same size as x [modulus length]; undefined after an error
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads

        call run_field(contact, of_line_load, state, x, values, error, threads)
    end subroutine line_load_values

    subroutine run_field(contact, field, state, positions, values, error, threads)
        type(contact_t), intent(in), target :: contact
        integer, intent(in) :: field
        type(contact_state_t), intent(in), target :: state
        real(wp), intent(in), target :: positions(:)
        real(wp), intent(inout), target :: values(:)
        type(error_t), allocatable, intent(out) :: error
        integer, intent(in), optional :: threads
        type(field_batch_t) :: batch
        integer :: wanted

        wanted = 1
        if (present(threads)) wanted = threads
        call check_threads(error, wanted)
        call check_sizes(error, size(positions), size(values))
        if (allocated(error)) return
        batch%contact => contact
        batch%field = field
        batch%state => state
        batch%positions => positions
        batch%values => values
        batch%stride = min(team_size(size(positions), field_smallest, wanted), max(size(positions), 1))
        call run_batch(batch, batch%stride, 1, 2, wanted, error)
        if (.not. allocated(error) .or. batch%stride == 1) return
        ! Which position failed first is known to one who takes them in order.
        batch%stride = 1
        deallocate (error)
        call batch%work(1, 1, error)
    end subroutine run_field

    subroutine evaluate_field(self, first, last, error)
        class(field_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        do i = first, last
            associate (r => self%positions(i::self%stride), values => self%values(i::self%stride))
                select case (self%field)
                case (of_pressure)
                    call self%contact%pressure(self%state, r, values, error)
                case (of_displacement)
                    call self%contact%displacement(self%state, r, values, error)
                case default
                    call self%contact%line_load(self%state, r, values, error)
                end select
            end associate
            if (allocated(error)) return
        end do
    end subroutine evaluate_field

    pure subroutine check_sizes(error, given, found)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: given, found

        if (given /= found) then
            call raise(error, error_invalid, "the arrays have "//count_text(given)//" and "//count_text(found)// &
                       " entries: they must have the same number")
        end if
    end subroutine check_sizes

end module mdrcontact_contact_values
