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

    !> Radii at first, from this part of the largest one on, which is so many times as thick as all layers by default.
    integer, parameter :: samples = 16
    real(wp), parameter :: first_part = 1.0e-4_wp, widest = 30.0_wp
    !> A body without layers under a flat end is looked into up to so many radii of that.
    real(wp), parameter :: beyond_end = 3.0_wp
    !> On the coarse grid a maximum may be missed by some per cent: the strength may be reached a little before the sample.
    real(wp), parameter :: slack = 1.1_wp
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
        type(maximum_t) :: top
        integer :: i

        n = 0
        if (allocated(error)) return
        call search%contact%at_depth(punch_depth*radius, state, error)
        if (.not. allocated(error)) call look_into(search, state, body, error)
        do i = 1, size(strengths)
            call find_top(body, strengths(i), .false., top, error)
            if (allocated(error)) return
            if (.not. top%value > 0.0_wp .or. is_beside_edge(body, top)) cycle
            n = n + 1
            found(n)%strength = strengths(i)
            found(n)%at = top
            found(n)%at%value = strengths(i)%value
            call search%contact%at_depth(state%depth*strengths(i)%value/top%value, found(n)%state, error)
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
        type(maximum_t) :: top
        logical :: is_reached(size(strengths))
        integer :: i, k

        n = 0
        is_reached = .false.
        do k = 1, size(radii)
            if (.not. allocated(error)) call search%contact%at_radius(radii(k), state, error)
            if (.not. allocated(error)) call look_into(search, state, body, error)
            do i = 1, size(strengths)
                if (is_reached(i)) cycle
                call find_top(body, strengths(i), .true., top, error)
                if (allocated(error)) return
                if (top%value < strengths(i)%value .or. is_beside_edge(body, top)) cycle
                call find_first(search, radii(:k), strengths(i), found(n + 1), is_reached(i), error)
                if (is_reached(i)) n = n + 1
            end do
            call report_progress(real(k, wp)/real(size(radii), wp))
            if (allocated(error) .or. all(is_reached)) return
        end do
    end subroutine find_all

    !> Where a strength is first reached, which it is at the last radius or, on a finer grid, a little before.
    subroutine find_first(search, radii, strength, found, is_reached, error)
        type(search_t), intent(in) :: search
        !> ascending [length]
        real(wp), intent(in) :: radii(:)
        type(strength_t), intent(in) :: strength
        type(failure_load_t), intent(inout) :: found
        !> not where what the last radius has belongs to a singular edge
        logical, intent(out) :: is_reached
        type(error_t), allocatable, intent(inout) :: error
        type(failure_load_t) :: below
        real(wp) :: low, high, excess_low, excess_high
        integer :: k

        k = size(radii)
        high = radii(k)
        call find_excess(search, strength, high, found, excess_high, error)
        is_reached = excess_high >= 0.0_wp
        do while (is_reached .and. k > 1 .and. .not. allocated(error))
            k = k - 1
            low = radii(k)
            if (k == size(radii) - 1) low = max(low/slack, radii(1))
            call find_excess(search, strength, low, below, excess_low, error)
            if (excess_low < 0.0_wp) then
                call close_in(search, strength, low, excess_low, high, excess_high, found, error)
                return
            end if
            high = low
            excess_high = excess_low
            found = below
        end do
    end subroutine find_first

    !> The radius between two at which the stress is the strength, by regula falsi (Illinois) in the logarithms of radii.
    subroutine close_in(search, strength, first_low, first_excess, high, excess_high, found, error)
        type(search_t), intent(in) :: search
        type(strength_t), intent(in) :: strength
        !> below it the strength is not reached, at the other end it is
        real(wp), intent(in) :: first_low, first_excess
        real(wp), intent(inout) :: high, excess_high
        !> that of the upper end
        type(failure_load_t), intent(inout) :: found
        type(error_t), allocatable, intent(inout) :: error
        type(failure_load_t) :: here
        real(wp) :: low, excess_low, middle, excess, part
        integer :: step, side

        low = first_low
        excess_low = first_excess
        side = 0
        do step = 1, most_steps
            if (log(high/low) <= narrowest .or. excess_high <= tolerance) return
            part = excess_high/(excess_high - excess_low)
            middle = high*(low/high)**part
            call find_excess(search, strength, middle, here, excess, error)
            if (allocated(error)) return
            if (abs(excess) <= tolerance) then
                found = here
                return
            else if (excess < 0.0_wp) then
                low = middle
                excess_low = excess
                if (side < 0) excess_high = 0.5_wp*excess_high
                side = -1
            else
                high = middle
                excess_high = excess
                found = here
                if (side > 0) excess_low = 0.5_wp*excess_low
                side = 1
            end if
        end do
    end subroutine close_in

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

        excess = -1.0_wp
        failure%strength = strength
        if (.not. allocated(error)) call search%contact%at_radius(radius, failure%state, error)
        if (.not. allocated(error)) call look_into(search, failure%state, body, error)
        if (allocated(error)) return
        call find_top(body, strength, .false., failure%at, error)
        if (.not. (allocated(error) .or. is_beside_edge(body, failure%at))) excess = failure%at%value/strength%value - 1.0_wp
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

    !> The largest stress that a strength is about; the tension of the first layer includes that of its free surface.
    subroutine find_top(body, strength, is_coarse, top, error)
        type(stressed_t), intent(inout) :: body
        type(strength_t), intent(in) :: strength
        logical, intent(in) :: is_coarse
        type(maximum_t), intent(out) :: top
        type(error_t), allocatable, intent(inout) :: error
        type(maximum_t) :: found(1)

        call largest_of(body, [strength%quantity], strength%place, is_coarse, found, error)
        top = found(1)
        if (strength%quantity /= tension .or. strength%place > 0) return
        call largest_of(body, [free_surface_tension], 0, is_coarse, found, error)
        if (found(1)%value > top%value) top = found(1)
    end subroutine find_top

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
