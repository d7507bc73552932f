! SPDX-License-Identifier: GPL-3.0-or-later
!> Many states of a contact, and its fields at many positions, on one thread or several.
module mdrcontact_contact_values
    use mdrcontact_batch, only: batch_t, check_threads, run_batch, team_size
    use mdrcontact_codes, only: field_displacement => displacement, field_displacement_lower => displacement_lower, &
                                field_displacement_upper => displacement_upper, field_line_load => line_load, &
                                field_pressure => pressure, given_depth => depth, given_force => force, given_radius => radius
    use mdrcontact_contact, only: check_branch, contact_t
    use mdrcontact_contact_inversion, only: neighbours_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_code, check_made, check_same_size, error_t, raise_at
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_load, only: lower_body, upper_body
    implicit none (type, external)
    private
    public :: contact_states, given_depth, given_force, given_radius
    public :: load_field, field_pressure, field_displacement, field_line_load, field_displacement_lower, &
              field_displacement_upper

    type, extends(batch_t) :: states_batch_t
        type(contact_t), pointer :: contact => null()
        integer :: given = given_depth
        !> so many entries in turn begin with what was found for those before them
        integer :: chain = 1
        integer, allocatable :: branch
        real(wp), pointer :: input(:) => null()
        type(contact_state_t), pointer :: states(:) => null()
    contains
        procedure :: work => solve_states
    end type states_batch_t

    !> Entry i of the batch is every `stride`th position from i on: all threads meet the same mixture of positions.
    type, extends(batch_t) :: field_batch_t
        type(contact_load_t), pointer :: load => null()
        integer :: field = field_pressure
        integer :: stride = 1
        real(wp), pointer :: positions(:) => null(), values(:) => null()
    contains
        procedure :: work => evaluate_field
    end type field_batch_t

    !> States that a thread takes at a time where each is a formula, and from how many on several threads pay; and those elsewhere.
    integer, parameter :: formula_block = 32, formula_smallest = 512
    integer, parameter :: solved_block = 1, solved_smallest = 2
    !> Entries to a chain, and how many chains there are before they grow longer than the least.
    integer, parameter :: shortest_chain = 4, longest_chain = 25, chains = 8
    !> The same for radii, which cost one solution a state, and for positions of a field.
    integer, parameter :: radius_smallest = 8, field_smallest = 128

contains

    !> contact%at_depth, at_force or at_radius for many numbers. Where some fail, the error is that of the first, and `states` is
    !> undefined.
    subroutine contact_states(contact, given, input, states, error, branch, threads)
        type(contact_t), intent(in), target :: contact
        !> given_depth, given_force or given_radius
        integer, intent(in) :: given
        !> depths [length], forces [modulus length^2] or radii [length]
        real(wp), intent(in), target :: input(:)
        !> same size as input
        type(contact_state_t), intent(inout), target :: states(:)
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default); a radius has one state
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads
        type(states_batch_t) :: batch
        integer :: team, smallest

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        team = 1
        if (present(threads)) team = threads
        call check_threads(error, team)
        call check_code(error, "given", given, [given_depth, given_force, given_radius])
        if (present(branch) .and. given /= given_radius) call check_branch(error, branch)
        call check_same_size(error, size(input), size(states))
        if (allocated(error)) return
        batch%contact => contact
        batch%given = given
        if (present(branch)) batch%branch = branch
        batch%input => input
        batch%states => states
        if (contact%is_formula()) then
            call run_batch(batch, size(input), formula_block, formula_smallest, team, error)
        else
            smallest = merge(radius_smallest, solved_smallest, given == given_radius)
            if (given /= given_radius .and. .not. contact%is_adhesive()) then
                batch%chain = max(shortest_chain, min(longest_chain, size(input)/chains))
            end if
            call run_batch(batch, size(input), max(solved_block, batch%chain), smallest, team, error)
        end if
    end subroutine contact_states

    subroutine solve_states(self, first, last, error)
        class(states_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        type(neighbours_t) :: neighbours
        integer :: i

        do i = first, last
            ! chains begin at the same entries however many threads there are
            if (modulo(i - 1, self%chain) == 0) neighbours = neighbours_t()
            select case (self%given)
            case (given_depth)
                call self%contact%at_depth(self%input(i), self%states(i), error, self%branch, neighbours)
            case (given_force)
                call self%contact%at_force(self%input(i), self%states(i), error, self%branch, neighbours)
            case default
                call self%contact%at_radius(self%input(i), self%states(i), error)
            end select
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine solve_states

    !> load%pressure, displacement or line_load at many positions. Where some fail, the error is that of the first.
    subroutine load_field(load, field, positions, values, error, threads)
        type(contact_load_t), intent(in), target :: load
        !> one of field_...
        integer, intent(in) :: field
        !> r or x >= 0; at most a but for the displacement [length]
        real(wp), intent(in), target :: positions(:)
        !> same size as positions [modulus], [length] or [modulus length]; undefined after an error
        real(wp), intent(inout), target :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads
        type(field_batch_t) :: batch
        integer :: wanted

        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        wanted = 1
        if (present(threads)) wanted = threads
        call check_threads(error, wanted)
        call check_code(error, "field", field, [field_pressure, field_displacement, field_displacement_lower, &
                                             field_displacement_upper, field_line_load])
        call check_same_size(error, size(positions), size(values))
        if (allocated(error)) return
        batch%load => load
        batch%field = field
        batch%positions => positions
        batch%values => values
        batch%stride = min(team_size(size(positions), field_smallest, wanted), max(size(positions), 1))
        call run_batch(batch, batch%stride, 1, 2, batch%stride, error)
        if (.not. allocated(error) .or. batch%stride == 1) return
        ! Only an evaluation in order finds the first position that fails.
        batch%stride = 1
        deallocate (error)
        call batch%work(1, 1, error)
    end subroutine load_field

    subroutine evaluate_field(self, first, last, error)
        class(field_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        do i = first, last
            associate (r => self%positions(i::self%stride), values => self%values(i::self%stride))
                select case (self%field)
                case (field_pressure)
                    call self%load%pressure(r, values, error)
                case (field_displacement)
                    call self%load%displacement(r, values, error)
                case (field_displacement_lower)
                    call self%load%displacement(r, values, error, lower_body)
                case (field_displacement_upper)
                    call self%load%displacement(r, values, error, upper_body)
                case default
                    call self%load%line_load(r, values, error)
                end select
            end associate
            if (allocated(error)) return
        end do
    end subroutine evaluate_field

end module mdrcontact_contact_values
