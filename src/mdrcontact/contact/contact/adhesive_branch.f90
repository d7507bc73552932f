! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive equilibria of a contact, for any range of adhesion: the stable segments under a control, and the states
!> on them. All equilibria lie on one curve with a coordinate, and are stable where what the machine controls grows along it.
module mdrcontact_contact_adhesive_branch
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: adhesive_branch_t, search_t, stable_segment_t

    !> A stable segment of the branch: s grows from `lowest` to `highest` as the coordinate goes from `first` to `last`.
    type :: stable_segment_t
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        !> the radius stays at the indenter's vertical wall, the depth changes
        logical :: at_wall = .false.
    end type stable_segment_t

    !> The equilibria from dominant to negligible adhesion.
    type, abstract :: adhesive_branch_t
        !> the gap at which bodies that approach begin to attract each other [length]: 0 where adhesion has no range
        real(wp) :: range = 0.0_wp
        !> stable segments under depth and force control, once they are found
        type(stable_segment_t), allocatable, private :: of_depth(:), of_force(:)
    contains
        procedure(find), deferred :: find_segments
        procedure(begin), deferred :: begin_search
        procedure(state_at_coordinate), deferred :: state_at
        procedure(state_at_radius), deferred :: at_radius
        procedure(work_of), deferred :: work_between
        procedure(smooth_around), deferred :: smooth_range
        procedure :: stable_segments
        procedure :: keep_segments
        procedure :: segments_between
        procedure :: state_on
        procedure :: first_attraction
        procedure :: slope_at
    end type adhesive_branch_t

    !> States from which a slope is taken, and the length in the coordinate over which they are spread: a part of the distance from
    !> the next break, behind which depth and force may follow roots, but more than rounding.
    integer, parameter :: slope_points = 7
    real(wp), parameter :: slope_length = 0.06_wp, part_of_distance = 0.3_wp, shortest_length = 1.0e-4_wp

    !> Where the search for a state begins.
    type :: search_t
        !> a coordinate, its largest distance from that of the state, and the expected slope there
        real(wp) :: x = 0.0_wp, distance = 1.0_wp, slope = 0.0_wp
        !> whether beyond the samples, where s follows a power of the radius: ln s is searched for
        logical :: is_logarithmic = .false.
        !> whether rounding shows between neighbouring coordinates
        logical :: is_rough = .false.
    end type search_t

    !> s - offset of an equilibrium as a function of the coordinate.
    type, extends(scalar_function_t) :: quantity_t
        class(adhesive_branch_t), pointer :: branch => null()
        type(equilibrium_t), pointer :: equilibrium => null()
        type(control_t) :: control
        real(wp) :: offset = 0.0_wp
        !> ln(s/offset) instead of s - offset
        logical :: is_logarithmic = .false.
    contains
        procedure :: value => quantity_at
    end type quantity_t

    abstract interface
        !> In ascending order of the coordinate. The last reaches to the end of the indenter or medium.
        subroutine find(self, equilibrium, control, list, error)
            import :: adhesive_branch_t, control_t, equilibrium_t, error_t, stable_segment_t
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in), target :: equilibrium
            type(control_t), intent(in) :: control
            type(stable_segment_t), allocatable, intent(out) :: list(:)
            type(error_t), allocatable, intent(out) :: error
        end subroutine find

        !> Where to look for s on a segment, from the samples.
        pure subroutine begin(self, equilibrium, control, segment, s, search)
            import :: adhesive_branch_t, control_t, equilibrium_t, search_t, stable_segment_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            type(control_t), intent(in) :: control
            type(stable_segment_t), intent(in) :: segment
            real(wp), intent(in) :: s
            type(search_t), intent(out) :: search
        end subroutine begin

        !> The state at a coordinate.
        subroutine state_at_coordinate(self, equilibrium, x, state, error)
            import :: adhesive_branch_t, contact_state_t, equilibrium_t, error_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            real(wp), intent(in) :: x
            type(contact_state_t), intent(out) :: state
            type(error_t), allocatable, intent(inout) :: error
        end subroutine state_at_coordinate

        !> The state at a radius that the caller has checked.
        subroutine state_at_radius(self, equilibrium, radius, state, error)
            import :: adhesive_branch_t, contact_state_t, equilibrium_t, error_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in), target :: equilibrium
            real(wp), intent(in) :: radius
            type(contact_state_t), intent(out) :: state
            type(error_t), allocatable, intent(out) :: error
        end subroutine state_at_radius

        !> int F dd along the branch between two of its states.
        function work_of(self, equilibrium, from, to) result(work)
            import :: adhesive_branch_t, contact_state_t, equilibrium_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            type(contact_state_t), intent(in) :: from, to
            real(wp) :: work
        end function work_of

        !> The coordinate of a state, and the range around it over which the branch is analytic.
        subroutine smooth_around(self, equilibrium, state, x, low, high, error)
            import :: adhesive_branch_t, contact_state_t, equilibrium_t, error_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            type(contact_state_t), intent(in) :: state
            real(wp), intent(out) :: x, low, high
            type(error_t), allocatable, intent(inout) :: error
        end subroutine smooth_around
    end interface

contains

    !> The stable segments under a control, in ascending order of the coordinate.
    subroutine stable_segments(self, equilibrium, control, list, error)
        class(adhesive_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error

        if (allocated(self%of_depth) .and. control%force_weight == 0.0_wp) then
            list = self%of_depth
        else if (allocated(self%of_force) .and. control%depth_weight == 0.0_wp) then
            list = self%of_force
        else
            call self%find_segments(equilibrium, control, list, error)
        end if
    end subroutine stable_segments

    !> Finds the segments under depth and force control once for all.
    subroutine keep_segments(self, equilibrium, error)
        class(adhesive_branch_t), intent(inout) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(error_t), allocatable, intent(inout) :: error
        type(stable_segment_t), allocatable :: of_depth(:), of_force(:)

        call self%find_segments(equilibrium, depth_control, of_depth, error)
        if (.not. allocated(error)) call self%find_segments(equilibrium, force_control, of_force, error)
        if (allocated(error)) return
        call move_alloc(of_depth, self%of_depth)
        call move_alloc(of_force, self%of_force)
    end subroutine keep_segments

    !> The segments between the ends and extrema of the samples on which s grows; beyond the samples s continues to grow, to the end
    !> of the indenter or medium if there is one.
    subroutine segments_between(self, equilibrium, control, turns, end_coordinate, list, error, last)
        class(adhesive_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: turns(:), end_coordinate
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(inout) :: error
        !> s at the end of the samples, for a segment that continues beyond them; default: of the state there
        real(wp), intent(in), optional :: last
        type(contact_state_t) :: state
        real(wp) :: s(size(turns))
        integer :: i, n

        n = size(turns)
        do i = 1, n
            if (i == n .and. present(last) .and. end_coordinate > turns(n)) then
                s(n) = last
                cycle
            end if
            call self%state_at(equilibrium, turns(i), state, error)
            if (allocated(error)) return
            s(i) = control%of(state%depth, state%force)
        end do
        list = [(stable_segment_t(turns(i), turns(i + 1), s(i), s(i + 1)), i=1, n - 1)]
        list = pack(list, list%highest > list%lowest)
        if (size(list) == 0) return
        associate (end => list(size(list)))
            if (end%last < turns(n) .or. end_coordinate <= turns(n)) return
            end%last = end_coordinate
            end%highest = huge(1.0_wp)
        end associate
    end subroutine segments_between

    !> The state with a given s on a segment that contains it: the search begins on the samples where they reach, and solves on the
    !> equilibrium itself.
    subroutine state_on(self, equilibrium, control, segment, s, state, error)
        class(adhesive_branch_t), intent(in), target :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(quantity_t) :: quantity
        type(search_t) :: search
        real(wp) :: x
        logical :: found

        if (segment%at_wall) then
            call self%state_at(equilibrium, segment%last, state, error)
            if (allocated(error)) return
            call extend_at_constant_radius(state, (s - segment%lowest)/control%of(1.0_wp, state%stiffness))
            return
        end if
        if (s <= segment%lowest) then
            x = segment%first
        else if (s >= segment%highest) then
            x = segment%last
        else
            call self%begin_search(equilibrium, control, segment, s, search)
            quantity%branch => self
            quantity%equilibrium => equilibrium
            quantity%control = control
            quantity%offset = s
            quantity%is_rough = search%is_rough
            quantity%is_logarithmic = search%is_logarithmic
            if (.not. search%slope > 0.0_wp) search%slope = merge(2.0_wp, tiny(1.0_wp) + abs(s), search%is_logarithmic)
            call solve_increasing(quantity, search%x, search%slope, segment%first, segment%last, x, found, error, search%distance)
            if (allocated(error)) return
            if (.not. found) then
                call raise(error, error_unreachable, "no state found up to radius = "//to_text(equilibrium%last_radius)// &
                           ", where the indenter or the medium ends")
                return
            end if
        end if
        call self%state_at(equilibrium, x, state, error)
    end subroutine state_on

    !> Goes deeper at the indenter's vertical wall.
    pure subroutine extend_at_constant_radius(state, more)
        type(contact_state_t), intent(inout) :: state
        !> [length]
        real(wp), intent(in) :: more

        state%punch_depth = state%punch_depth + more
        state%depth = state%depth + more
        state%force = state%force + state%stiffness*more
    end subroutine extend_at_constant_radius

    function quantity_at(self, x) result(y)
        class(quantity_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state

        call self%branch%state_at(self%equilibrium, x, state, self%error)
        y = self%control%distance(state%depth, state%force, self%offset, self%is_logarithmic)
    end function quantity_at

    !> s at which bodies that approach begin to attract each other: they touch, or come within the range of adhesion.
    elemental function first_attraction(self, control) result(s)
        class(adhesive_branch_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp) :: s

        s = 0.0_wp
        if (self%range > 0.0_wp) s = control%of(-self%range, 0.0_wp)
    end function first_attraction

    !> dF/dd along the branch at one of its states: that of the polynomial through neighbouring states, which do not reach across a
    !> break of indenter or medium. Infinite where the depth turns.
    subroutine slope_at(self, equilibrium, state, slope, error)
        class(adhesive_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        !> [modulus length]
        real(wp), intent(out) :: slope
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(slope_points) :: depth, force, weight
        real(wp) :: x, low, high, length, first

        slope = 0.0_wp
        call self%smooth_range(equilibrium, state, x, low, high, error)
        if (allocated(error)) return
        length = min(slope_length, max(part_of_distance*min(x - low, high - x), shortest_length))
        first = min(max(x - 0.5_wp*length, low), max(high - length, low))
        call states_from(self, equilibrium, first, length, depth, force, error)
        if (allocated(error)) then
            ! where a cohesive zone would reach beyond the end of the indenter
            first = max(x - length, low)
            deallocate (error)
            call states_from(self, equilibrium, first, length, depth, force, error)
            if (allocated(error)) return
        end if
        weight = slope_weights((x - first)/length*real(slope_points - 1, wp))
        slope = ratio_of(dot_product(weight, force), dot_product(weight, depth))
    end subroutine slope_at

    !> Depths and forces of states evenly spread over a length of the coordinate.
    subroutine states_from(self, equilibrium, first, length, depth, force, error)
        class(adhesive_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: first, length
        real(wp), intent(out) :: depth(:), force(:)
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        integer :: i

        depth = 0.0_wp
        force = 0.0_wp
        do i = 1, slope_points
            call self%state_at(equilibrium, first + length*real(i - 1, wp)/real(slope_points - 1, wp), state, error)
            if (allocated(error)) return
            depth(i) = state%depth
            force(i) = state%force
        end do
    end subroutine states_from

    !> The slopes at a place of the polynomials that are 1 at one of the points 0, 1, ... and 0 at the others.
    pure function slope_weights(place) result(weights)
        real(wp), intent(in) :: place
        real(wp) :: weights(slope_points)
        real(wp) :: product
        integer :: i, j, k

        weights = 0.0_wp
        do i = 0, slope_points - 1
            do j = 0, slope_points - 1
                if (j == i) cycle
                product = 1.0_wp/real(i - j, wp)
                do k = 0, slope_points - 1
                    if (k /= i .and. k /= j) product = product*(place - real(k, wp))/real(i - k, wp)
                end do
                weights(i + 1) = weights(i + 1) + product
            end do
        end do
    end function slope_weights

    !> A ratio, the largest number of its sign where it is beyond all numbers.
    pure function ratio_of(rise, run) result(ratio)
        real(wp), intent(in) :: rise, run
        real(wp) :: ratio

        ratio = huge(ratio)
        if (abs(run) > abs(rise)/huge(ratio)) then
            ratio = rise/run
        else
            ratio = sign(ratio, rise)
        end if
    end function ratio_of

end module mdrcontact_contact_adhesive_branch
