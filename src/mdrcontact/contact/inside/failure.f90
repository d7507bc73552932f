! SPDX-License-Identifier: GPL-3.0-or-later
!> The loads at which the strengths of a body of layers are reached first.
module mdrcontact_inside_failure
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_cancel, only: report_progress
    use mdrcontact_codes, only: free_surface_tension, interface_shear, interface_tension, tension, tresca, von_mises
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, check_memory, check_not_negative, count_text, error_cancelled, error_invalid, &
                                error_memory, error_t, raise, to_text
    use mdrcontact_inside, only: layers_of
    use mdrcontact_inside_critical, only: check_deviation, largest_of, new_stressed
    use mdrcontact_inside_largest, only: maximum_t, stressed_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: failure_load_t, first_failure, strength_t

    !> Strength of a layer or an interface.
    type :: strength_t
        !> a quantity of maximum_t: von_mises, tresca (half the yield stress by Tresca), tension, which of the first
        !> layer includes the free surface; interface_shear, interface_tension; free_surface_tension
        integer :: quantity = 0
        !> which layer or interface, 0 is the first one from the surface
        integer :: place = 0
        !> > 0 [modulus]
        real(wp) :: value = 0.0_wp
    end type strength_t

    !> A strength that is reached.
    type :: failure_load_t
        !> the state at which it is; the smallest one considered where it is at any load, as under a sharp tip
        type(contact_state_t) :: state
        !> the strength itself, as it was given
        type(strength_t) :: strength
        !> where in the body; its value is larger than the strength where that is reached at any load
        type(maximum_t) :: at
    end type failure_load_t

    !> A contact whose states are looked into.
    type :: search_t
        type(contact_t), pointer :: contact => null()
        logical :: upper = .false.
        real(wp) :: friction = 0.0_wp
        integer :: threads = 1
    end type search_t

    !> Logarithms of two radii between which a strength is reached, levels of the excess there, and the end before.
    type :: bracket_t
        real(wp) :: low = 0.0_wp, high = 0.0_wp, before = 0.0_wp
        real(wp) :: below = 0.0_wp, above = 0.0_wp, level_before = 0.0_wp
        logical :: is_known = .false.
        !> how often in turn it was not halved
        integer :: slow = 0
    contains
        procedure :: next
        procedure :: shrink
    end type bracket_t

    !> Radii at first, from this part of the largest one on, which is so many times as thick as all layers by default.
    integer, parameter :: samples = 16
    real(wp), parameter :: first_part = 1.0e-4_wp, widest = 30.0_wp
    !> A body without layers under a flat end is looked into up to so many radii of that.
    real(wp), parameter :: beyond_end = 3.0_wp
    !> On the coarse grid a maximum may be missed by some per cent: the strength may be reached a little before the sample, by this
    !> factor of the radius or this part of the strength.
    real(wp), parameter :: slack = 1.1_wp
    real(wp), parameter :: missed = 0.2_wp
    !> Least stress over strength that a bracket tells from none, and how often in turn it may not be halved.
    real(wp), parameter :: least_part = 1.0e-2_wp
    integer, parameter :: most_slow = 3
    !> Relative tolerance of the stress at the strength, or of the radius.
    real(wp), parameter :: tolerance = 1.0e-9_wp, narrowest = 1.0e-12_wp
    integer, parameter :: most_steps = 100
    !> Where no state is known at the largest radius, it is shortened by this factor, so often at most.
    real(wp), parameter :: shorter = 0.9_wp
    integer, parameter :: most_shorter = 60
    !> A maximum nearer than this belongs to the singular edge, no matter how weak that is [a].
    real(wp), parameter :: beside_edge = 5.0e-3_wp
    !> The depth of a flat punch [radius of the punch]: its stresses grow with it.
    real(wp), parameter :: punch_depth = 1.0e-3_wp

contains

    !> The strengths that are reached, in the order in which they come as the force grows.
    subroutine first_failure(contact, upper, friction, largest_radius, strengths, failures, error, threads)
        type(contact_t), intent(in), target :: contact
        !> whether the upper body is meant, not the lower one
        logical, intent(in) :: upper
        !> f >= 0: see interior
        real(wp), intent(in) :: friction
        !> contact radii are considered up to this one, or where indenter and medium end; 0: 30 times the thickness of all layers
        !> [length]. A flat punch has only one
        real(wp), intent(in) :: largest_radius
        type(strength_t), intent(in) :: strengths(:)
        type(failure_load_t), allocatable, intent(out) :: failures(:)
        type(error_t), allocatable, intent(out) :: error
        !> how many threads may share the work, 0: as many as OpenMP offers; default 1
        integer, intent(in), optional :: threads
        type(search_t) :: search
        type(layers_t) :: layers
        type(failure_load_t), allocatable :: found(:)
        type(contact_load_t) :: load
        real(wp) :: end_radius, smallest, largest, radii(samples)
        real(wp), allocatable :: breaks(:)
        integer :: n, i, stat

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_not_negative(error, "friction", friction)
        call check_not_negative(error, "largest_radius", largest_radius)
        if (.not. allocated(error)) call layers_of(contact%equilibrium, upper, layers, error)
        call check_strengths(layers, strengths, error)
        if (.not. allocated(error)) call contact%radius_range(end_radius, smallest, largest, breaks, error)
        if (allocated(error)) return
        search%contact => contact
        search%upper = upper
        search%friction = friction
        if (present(threads)) search%threads = threads
        allocate (found(size(strengths)), stat=stat)
        call check_memory(error, stat)
        if (largest <= end_radius) then
            call find_under_punch(search, end_radius, strengths, found, n, error)
        else
            call find_radii(search, layers, end_radius, largest, largest_radius, radii, error)
            call find_all(search, radii, strengths, found, n, error)
        end if
        do i = 1, n
            if (.not. allocated(error)) call contact%load(found(i)%state, load, error)
            if (.not. allocated(error)) call check_deviation(load, upper, error)
        end do
        if (allocated(error)) return
        call sort_by_force(found(:n))
        failures = found(:n)
    end subroutine first_failure

    !> A contact of one radius: its stresses grow with the depth, so that one state suffices.
    subroutine find_under_punch(search, radius, strengths, found, n, error)
        type(search_t), intent(in) :: search
        real(wp), intent(in) :: radius
        type(strength_t), intent(in) :: strengths(:)
        type(failure_load_t), intent(out) :: found(:)
        integer, intent(out) :: n
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        type(stressed_t) :: body
        type(maximum_t) :: tops(size(strengths))
        integer :: i

        n = 0
        if (allocated(error)) return
        call search%contact%at_depth(punch_depth*radius, state, error)
        if (.not. allocated(error)) call look_into(search, state, body, error)
        call find_tops(body, strengths, spread(.true., 1, size(strengths)), .false., tops, error)
        do i = 1, size(strengths)
            if (allocated(error)) return
            associate (top => tops(i))
                if (.not. top%value > 0.0_wp .or. is_beside_edge(body, top)) cycle
                n = n + 1
                found(n)%strength = strengths(i)
                found(n)%at = top
                found(n)%at%value = strengths(i)%value
                call search%contact%at_depth(state%depth*strengths(i)%value/top%value, found(n)%state, error)
            end associate
        end do
    end subroutine find_under_punch

    !> The contact radii to look at, ascending, beyond the radius of a flat end.
    subroutine find_radii(search, layers, end_radius, largest, largest_radius, radii, error)
        type(search_t), intent(in) :: search
        type(layers_t), intent(in) :: layers
        !> of the flat end, and up to where the contact is defined [length]
        real(wp), intent(in) :: end_radius, largest
        !> the last one; 0: the default [length]
        real(wp), intent(in) :: largest_radius
        real(wp), intent(out) :: radii(samples)
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        real(wp) :: last
        integer :: i

        if (allocated(error)) return
        last = largest_radius
        if (.not. last > 0.0_wp) last = widest*sum(layers%thickness)
        if (.not. last > 0.0_wp) then
            call raise(error, error_invalid, ": it must be greater than 0 for a body without layers", "largest_radius")
        else if (largest_radius > 0.0_wp .and. last <= end_radius) then
            call raise(error, error_invalid, " = "//to_text(last)//": it must be larger than the flat end, "// &
                       to_text(end_radius), "largest_radius")
        end if
        if (allocated(error)) return
        if (last <= end_radius) last = beyond_end*end_radius
        last = min(last, largest)
        do i = 1, most_shorter
            call search%contact%at_radius(last, state, error)
            if (.not. allocated(error)) exit
            if (error%code == error_cancelled .or. error%code == error_memory) return
            last = end_radius + shorter*(last - end_radius)
        end do
        if (allocated(error)) return
        radii = end_radius + (last - end_radius)*first_part**[(1.0_wp - real(i, wp)/real(samples - 1, wp), i=0, samples - 1)]
    end subroutine find_radii

    !> Every strength that is reached at one of the radii, or between two of them.
    subroutine find_all(search, radii, strengths, found, n, error)
        type(search_t), intent(in) :: search
        real(wp), intent(in) :: radii(:)
        type(strength_t), intent(in) :: strengths(:)
        !> same size as strengths
        type(failure_load_t), intent(inout) :: found(:)
        integer, intent(out) :: n
        type(error_t), allocatable, intent(inout) :: error
        type(stressed_t) :: body
        type(contact_state_t) :: state
        type(maximum_t) :: tops(size(strengths))
        logical :: is_reached(size(strengths))
        real(wp) :: excess(size(strengths), size(radii))
        integer :: i, k

        n = 0
        is_reached = .false.
        excess = -1.0_wp
        do k = 1, size(radii)
            if (.not. allocated(error)) call search%contact%at_radius(radii(k), state, error)
            if (.not. allocated(error)) call look_into(search, state, body, error)
            call find_tops(body, strengths, .not. is_reached, .true., tops, error)
            if (allocated(error)) return
            do i = 1, size(strengths)
                if (is_reached(i)) cycle
                if (.not. is_beside_edge(body, tops(i))) excess(i, k) = tops(i)%value/strengths(i)%value - 1.0_wp
                if (excess(i, k) < 0.0_wp) cycle
                call find_first(search, radii(:k), excess(i, :k), strengths(i), found(n + 1), is_reached(i), error)
                if (allocated(error)) return
                if (is_reached(i)) n = n + 1
            end do
            call report_progress(real(k, wp)/real(size(radii), wp))
            if (all(is_reached)) return
        end do
    end subroutine find_all

    !> Where a strength is first reached, which it is at the last radius or, on a finer grid, a little before.
    subroutine find_first(search, radii, coarse, strength, found, is_reached, error)
        type(search_t), intent(in) :: search
        !> ascending [length]
        real(wp), intent(in) :: radii(:)
        !> excess on the coarse grids there
        real(wp), intent(in) :: coarse(:)
        type(strength_t), intent(in) :: strength
        type(failure_load_t), intent(inout) :: found
        !> not where what the last radius has belongs to a singular edge
        logical, intent(out) :: is_reached
        type(error_t), allocatable, intent(inout) :: error
        type(failure_load_t) :: below
        type(bracket_t) :: bracket
        real(wp) :: low, excess
        integer :: k

        k = size(radii)
        call find_excess(search, strength, radii(k), found, excess, error)
        is_reached = excess >= 0.0_wp
        bracket%high = log(radii(k))
        bracket%above = level(excess)
        do while (is_reached .and. k > 1 .and. .not. allocated(error))
            k = k - 1
            low = radii(k)
            excess = coarse(k)
            if (excess >= -missed) then
                if (k == size(radii) - 1) low = max(low/slack, radii(1))
                call find_excess(search, strength, low, below, excess, error)
            end if
            if (excess < 0.0_wp) then
                bracket%low = log(low)
                bracket%below = level(excess)
                call close_in(search, strength, bracket, found, error)
                return
            end if
            bracket%high = log(low)
            bracket%above = level(excess)
            found = below
        end do
    end subroutine find_first

    !> The excess as a logarithm: stresses are nearly powers of the radius.
    elemental function level(excess)
        real(wp), intent(in) :: excess
        real(wp) :: level

        level = log(max(1.0_wp + excess, least_part))
    end function level

    !> The radius between two at which the stress is the strength, found's to begin with.
    subroutine close_in(search, strength, bracket, found, error)
        type(search_t), intent(in) :: search
        type(strength_t), intent(in) :: strength
        type(bracket_t), intent(inout) :: bracket
        !> that of the upper end
        type(failure_load_t), intent(inout) :: found
        type(error_t), allocatable, intent(inout) :: error
        type(failure_load_t) :: here
        real(wp) :: middle, excess
        integer :: step

        do step = 1, most_steps
            if (bracket%high - bracket%low <= narrowest .or. bracket%above <= tolerance) return
            middle = bracket%next()
            call find_excess(search, strength, exp(middle), here, excess, error)
            if (allocated(error)) return
            if (abs(excess) <= tolerance) then
                found = here
                return
            end if
            if (excess > 0.0_wp) found = here
            call bracket%shrink(middle, level(excess))
        end do
    end subroutine close_in

    !> The next place: the root of the parabola through the ends and the end before, or the middle, if the bracket was not halved
    !> several times in turn or the root lies outside.
    pure function next(self) result(x)
        class(bracket_t), intent(in) :: self
        real(wp) :: x
        real(wp) :: low, high, before

        low = self%below
        high = self%above
        x = self%low - low/(high - low)*(self%high - self%low)
        if (self%is_known) then
            before = self%level_before
            if (before < low .or. before > high) then
                x = self%low*high*before/((low - high)*(low - before)) + self%high*low*before/((high - low)*(high - before)) &
                    + self%before*low*high/((before - low)*(before - high))
            end if
        end if
        if (self%slow >= most_slow .or. .not. (x > self%low .and. x < self%high)) x = 0.5_wp*(self%low + self%high)
    end function next

    !> Replaces the end on the side of a new place.
    pure subroutine shrink(self, x, value)
        class(bracket_t), intent(inout) :: self
        !> log of a radius, and the level there
        real(wp), intent(in) :: x, value
        real(wp) :: width

        width = self%high - self%low
        self%is_known = .true.
        if (value < 0.0_wp) then
            self%before = self%low
            self%level_before = self%below
            self%low = x
            self%below = value
        else
            self%before = self%high
            self%level_before = self%above
            self%high = x
            self%above = value
        end if
        self%slow = merge(0, self%slow + 1, self%high - self%low <= 0.5_wp*width)
    end subroutine shrink

    !> Excess of the largest stress over the strength at a radius, relative to it; -1 next to a singular edge.
    subroutine find_excess(search, strength, radius, failure, excess, error)
        type(search_t), intent(in) :: search
        type(strength_t), intent(in) :: strength
        !> [length]
        real(wp), intent(in) :: radius
        type(failure_load_t), intent(out) :: failure
        real(wp), intent(out) :: excess
        type(error_t), allocatable, intent(inout) :: error
        type(stressed_t) :: body
        type(maximum_t) :: top(1)

        excess = -1.0_wp
        failure%strength = strength
        if (.not. allocated(error)) call search%contact%at_radius(radius, failure%state, error)
        if (.not. allocated(error)) call look_into(search, failure%state, body, error)
        if (allocated(error)) return
        call find_tops(body, [strength], [.true.], .false., top, error)
        if (allocated(error)) return
        failure%at = top(1)
        if (.not. is_beside_edge(body, failure%at)) excess = failure%at%value/strength%value - 1.0_wp
    end subroutine find_excess

    subroutine look_into(search, state, body, error)
        type(search_t), intent(in) :: search
        type(contact_state_t), intent(in) :: state
        type(stressed_t), intent(out) :: body
        type(error_t), allocatable, intent(out) :: error
        type(contact_load_t) :: load

        call search%contact%load(state, load, error)
        if (.not. allocated(error)) call new_stressed(body, load, search%upper, search%friction, error, search%threads)
    end subroutine look_into

    !> The largest stresses that chosen strengths are about, those of one place together; the tension of the first layer includes
    !> that of its free surface.
    subroutine find_tops(body, strengths, chosen, is_coarse, tops, error)
        type(stressed_t), intent(inout) :: body
        type(strength_t), intent(in) :: strengths(:)
        logical, intent(in) :: chosen(:), is_coarse
        !> same size as strengths; those that are not chosen are not defined
        type(maximum_t), intent(out) :: tops(:)
        type(error_t), allocatable, intent(inout) :: error
        type(maximum_t) :: found(1)
        logical :: waiting(size(strengths)), here(size(strengths))
        integer :: i

        waiting = chosen
        do i = 1, size(strengths)
            if (.not. waiting(i)) cycle
            here = waiting .and. strengths%place == strengths(i)%place
            here = here .and. kind_of(strengths%quantity) == kind_of(strengths(i)%quantity)
            call find_together(body, strengths, here, is_coarse, tops, error)
            if (allocated(error)) return
            waiting = waiting .and. .not. here
        end do
        if (.not. any(chosen .and. strengths%quantity == tension .and. strengths%place == 0)) return
        call largest_of(body, [free_surface_tension], 0, is_coarse, found, error)
        do i = 1, size(strengths)
            if (strengths(i)%quantity /= tension .or. strengths(i)%place > 0) cycle
            if (found(1)%value > tops(i)%value) tops(i) = found(1)
        end do
    end subroutine find_tops

    !> The largest stresses of one place.
    subroutine find_together(body, strengths, here, is_coarse, tops, error)
        type(stressed_t), intent(inout) :: body
        type(strength_t), intent(in) :: strengths(:)
        logical, intent(in) :: here(:), is_coarse
        type(maximum_t), intent(inout) :: tops(:)
        type(error_t), allocatable, intent(inout) :: error
        type(maximum_t) :: found(count(here))
        integer :: i, n

        call largest_of(body, pack(strengths%quantity, here), strengths(findloc(here, .true., 1))%place, is_coarse, found, error)
        n = 0
        do i = 1, size(here)
            if (.not. here(i)) cycle
            n = n + 1
            tops(i) = found(n)
        end do
    end subroutine find_together

    !> Of which kind of place a quantity is.
    elemental function kind_of(quantity) result(kind)
        integer, intent(in) :: quantity
        integer :: kind

        kind = free_surface_tension
        if (any(quantity == [von_mises, tresca, tension])) kind = von_mises
        if (any(quantity == [interface_shear, interface_tension])) kind = interface_shear
    end function kind_of

    !> Whether a maximum belongs to the singular edge of a flat punch or of an adhesive contact, no matter how weak that is.
    pure function is_beside_edge(body, top) result(answer)
        type(stressed_t), intent(in) :: body
        type(maximum_t), intent(in) :: top
        logical :: answer

        answer = body%has_singular_edge() .and. hypot(top%r - body%load%radius, top%z) < beside_edge*body%load%radius
    end function is_beside_edge

    !> Raise an error unless each strength belongs to an existing layer or interface.
    subroutine check_strengths(layers, strengths, error)
        type(layers_t), intent(in) :: layers
        type(strength_t), intent(in) :: strengths(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, places
        character(len=:), allocatable :: whose

        if (size(strengths) == 0) call raise(error, error_invalid, "n = 0: there must be at least one strength")
        do i = 1, size(strengths)
            if (allocated(error)) return
            associate (strength => strengths(i))
                call find_places(layers, strength%quantity, places, whose)
                if (places < 0) then
                    call raise(error, error_invalid, ": quantity = "//count_text(strength%quantity)//": it must be from "// &
                               count_text(von_mises)//" to "//count_text(free_surface_tension), "strengths", i)
                else if (strength%place < 0 .or. strength%place >= places) then
                    call raise(error, error_invalid, ": place = "//count_text(strength%place)//": the number of "//whose//" is "// &
                               count_text(places)//", and 0 is the first one from the surface", "strengths", i)
                else if (.not. (is_finite(strength%value) .and. strength%value > 0.0_wp)) then
                    call raise(error, error_invalid, ": value = "//to_text(strength%value)//": it must be finite and greater "// &
                               "than 0", "strengths", i)
                end if
            end associate
        end do
    end subroutine check_strengths

    !> Number of layers, interfaces or free surfaces that have a quantity; -1: none.
    pure subroutine find_places(layers, quantity, places, whose)
        type(layers_t), intent(in) :: layers
        integer, intent(in) :: quantity
        integer, intent(out) :: places
        character(len=:), allocatable, intent(out) :: whose

        select case (quantity)
        case (von_mises, tresca, tension)
            places = layers%bodies()
            whose = "layers"
        case (interface_shear, interface_tension)
            places = size(layers%thickness)
            whose = "interfaces"
        case (free_surface_tension)
            places = 1
            whose = "free surfaces"
        case default
            places = -1
            whose = ""
        end select
    end subroutine find_places

    !> The smallest force comes first.
    !> Keeps the order of strengths that are reached at the same force, as under a sharp tip at any, which GSL's sort does not.
    pure subroutine sort_by_force(failures)
        type(failure_load_t), intent(inout) :: failures(:)
        type(failure_load_t) :: next
        integer :: i, k

        do i = 2, size(failures)
            next = failures(i)
            do k = i - 1, 1, -1
                if (failures(k)%state%force <= next%state%force) exit
                failures(k + 1) = failures(k)
            end do
            failures(k + 1) = next
        end do
    end subroutine sort_by_force

end module mdrcontact_inside_failure
