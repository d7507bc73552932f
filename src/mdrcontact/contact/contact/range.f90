! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact radii, as coordinates x = ln(a - end radius), between which a contact must be sampled.
module mdrcontact_contact_range
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: depth_and_force
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_numerics_roots, only: guess_from_below, solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: adhesive_range, coordinate_beyond, coordinate_before, coordinate_below_pull_off, coordinates_between
    public :: smallest_log, first_guess

    !> ln(g/dl), to find where adhesion hands over to elasticity.
    type, extends(scalar_function_t) :: handover_t
        type(equilibrium_t), pointer :: equilibrium => null()
        real(wp) :: ratio = 1.0_wp
    contains
        procedure :: value => handover_at
    end type handover_t

    !> The branch is sampled from this far below the radius where d0 = dl (in ln a) to where dl/d0 has fallen to `adhesion_over`.
    real(wp), parameter :: decades_below = 21.0_wp
    !> An extremum of d or F needs dl/d0 of at least n/4 for a shape r^n, since k dl grows with a^4 at most.
    real(wp), parameter :: adhesion_over = 0.05_wp
    !> Extrema lie less than this far below the radius where d0 = dl (in ln a).
    real(wp), parameter :: room_below = 10.0_wp
    !> The smallest ln a that is considered, and where the search for a radius begins.
    real(wp), parameter :: smallest_log = -200.0_wp, first_guess = -35.0_wp
    !> Closer to a flat end, as a part of its radius, a - b has no digits left.
    real(wp), parameter :: closest = 1.0e-12_wp

    !> The depth found may be this much farther out than the requested one: more costs samples, less costs solutions.
    real(wp), parameter :: margin = 1.03_wp
    integer, parameter :: most_steps = 80
    real(wp), parameter :: widest_step = 4.0_wp
    !> From the last coordinate with a depth too small, when adhesion bends the branch.
    real(wp), parameter :: adhesive_step = 0.25_wp

contains

    !> The first and the last coordinate, and the breaks between them that leave room.
    pure subroutine coordinates_between(equilibrium, first, last, coordinates, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: first, last
        real(wp), allocatable, intent(out) :: coordinates(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), parameter :: room = 1.0e-3_wp
        real(wp), allocatable :: x(:)
        integer :: i

        call equilibrium%add_breaks(x, error)
        do i = 1, size(x)
            ! at the edge of a flat end and below, far below all others
            x(i) = equilibrium%coordinate_of(x(i))
        end do
        coordinates = [first, last]
        call merge_breaks(coordinates, x(count(x <= first + room) + 1:count(x < last - room)), error)
    end subroutine coordinates_between

    !> The coordinates between which the depth or the force of an adhesive contact can have extrema.
    subroutine adhesive_range(equilibrium, first, last, error, handover_coordinate)
        type(equilibrium_t), intent(in), target :: equilibrium
        real(wp), intent(out) :: first, last
        type(error_t), allocatable, intent(out) :: error
        !> where d0 = dl
        real(wp), intent(out), optional :: handover_coordinate
        type(handover_t) :: handover
        real(wp) :: smallest, largest, equal, guess, slope
        logical :: found

        first = 0.0_wp
        last = 0.0_wp
        handover%equilibrium => equilibrium
        smallest = first_coordinate(equilibrium, smallest_log)
        largest = equilibrium%coordinate_of(equilibrium%last_radius)
        call guess_from_below(handover, min(max(smallest, first_guess), largest - 1.0_wp), 0.0_wp, guess, slope)
        if (allocated(handover%error)) then
            error = handover%error
            return
        end if
        call solve_increasing(handover, guess, slope, smallest, largest, equal, found, error)
        if (.not. allocated(error) .and. equal < smallest_log + room_below) then
            call raise(error, error_no_convergence, "work_of_adhesion = "//to_text(equilibrium%work_of_adhesion)// &
                       " is too small for this contact: its adhesive radii are beyond the range of floating-point numbers")
        end if
        if (present(handover_coordinate)) handover_coordinate = equal
        if (allocated(error)) return
        handover%ratio = 1.0_wp/adhesion_over
        call solve_increasing(handover, equal, slope, smallest, largest, last, found, error)
        if (allocated(error)) return
        first = max(smallest, min(equal, last - 1.0_wp) - decades_below)
        if (equilibrium%profile%end_radius > 0.0_wp) then
            first = min(max(first, log(closest*equilibrium%profile%end_radius)), equal - 1.0_wp)
        end if
        last = max(last, min(first + 1.0_wp, largest))
    end subroutine adhesive_range

    function handover_at(self, x) result(y)
        class(handover_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state

        call self%equilibrium%parts(self%equilibrium%radius_of(x), state, self%error)
        y = log(max(state%depth, tiny(x))) - log(self%ratio) - log(max(-state%punch_depth, tiny(x)))
    end function handover_at

    !> Coordinate of the smallest radius of the medium, or `otherwise`.
    pure function first_coordinate(equilibrium, otherwise) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: otherwise
        real(wp) :: x

        x = otherwise
        if (equilibrium%medium%smallest_radius > equilibrium%profile%end_radius) then
            x = equilibrium%coordinate_of(equilibrium%medium%smallest_radius) + 8.0_wp*epsilon(1.0_wp)
        end if
    end function first_coordinate

    !> A coordinate at which the depth is at least `depth`, or the last one, and the depth there.
    subroutine coordinate_beyond(equilibrium, depth, scale, x, found, solutions, error)
        type(equilibrium_t), intent(in) :: equilibrium
        !> with adhesion of any sign, else > 0; and the depth > 0 of the non-adhesive state from which on it is searched for
        real(wp), intent(in) :: depth, scale
        real(wp), intent(out) :: x, found
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: last
        integer :: step

        last = equilibrium%coordinate_of(equilibrium%last_radius)
        last = last - 4.0_wp*epsilon(1.0_wp)*max(1.0_wp, abs(last))
        call nonadhesive_coordinate(equilibrium, -700.0_wp, last, scale, scale*margin, x, found, solutions, error)
        if (allocated(error) .or. .not. equilibrium%work_of_adhesion > 0.0_wp) return
        do step = 1, most_steps
            call equilibrium%at(equilibrium%radius_of(x), state, error)
            if (allocated(error)) return
            solutions = solutions + 1
            found = state%depth
            if (found >= depth .or. x >= last) return
            x = min(x + adhesive_step, last)
        end do
    end subroutine coordinate_beyond

    !> A coordinate at which the depth, without adhesion, is at most `depth` > 0, and the depth there.
    subroutine coordinate_before(equilibrium, depth, x, found, solutions, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: depth
        real(wp), intent(out) :: x, found
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error

        call nonadhesive_coordinate(equilibrium, first_coordinate(equilibrium, -700.0_wp), &
                                    equilibrium%coordinate_of(equilibrium%last_radius), depth/margin, depth, x, found, solutions, &
                                    error)
    end subroutine coordinate_before

    !> A coordinate at which the depth of the non-adhesive state lies between low and high, or the end nearest to it: secants of
    !> ln d over x from the contact of a homogeneous body.
    subroutine nonadhesive_coordinate(equilibrium, first, last, low, high, x, found, solutions, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: first, last, low, high
        real(wp), intent(out) :: x, found
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: mismatch, mismatch_before, x_before, slope, next, force
        integer :: step

        slope = 2.0_wp
        x = max(first, min(last, homogeneous_coordinate(equilibrium, sqrt(low*high))))
        do step = 1, most_steps
            if (equilibrium%medium%is_exact) then
                call depth_and_force(equilibrium%medium, equilibrium%profile, equilibrium%radius_of(x), found, force, error)
                if (allocated(error)) return
            else
                found = equilibrium%profile%mdr(equilibrium%radius_of(x))
            end if
            solutions = solutions + 1
            if (found >= low .and. found <= high) return
            mismatch = log(found/sqrt(low*high))
            if (step > 1 .and. x /= x_before) slope = max((mismatch - mismatch_before)/(x - x_before), 0.2_wp)
            mismatch_before = mismatch
            x_before = x
            next = max(first, min(last, x - max(-widest_step, min(widest_step, mismatch/slope))))
            if (next == x) return
            x = next
        end do
        call raise(error, error_no_convergence, "no contact radius found for depth "//to_text(sqrt(low*high)))
    end subroutine nonadhesive_coordinate

    !> Where g(a) = depth: by the inverse of g, or by bisection, as g rises with the radius.
    function homogeneous_coordinate(equilibrium, depth) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: depth
        real(wp) :: x
        real(wp) :: radius, lower, upper
        integer :: i

        radius = equilibrium%profile%radius_from_mdr(depth)
        if (radius > equilibrium%profile%end_radius) then
            x = equilibrium%coordinate_of(radius)
            return
        end if
        lower = log(depth) - 20.0_wp
        upper = min(log(depth) + 20.0_wp, equilibrium%coordinate_of(equilibrium%last_radius))
        do i = 1, 30
            x = 0.5_wp*(lower + upper)
            if (equilibrium%profile%mdr(equilibrium%radius_of(x)) < depth) then
                lower = x
            else
                upper = x
            end if
        end do
    end function homogeneous_coordinate

    !> A coordinate below `from` beyond the depth's uppermost minimum, or one at which the depth is at most `depth`.
    subroutine coordinate_below_pull_off(equilibrium, from, depth, x, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: from, depth
        real(wp), intent(out) :: x
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: before, smallest
        integer :: step

        smallest = first_coordinate(equilibrium, smallest_log)
        x = from
        before = huge(before)
        do step = 1, most_steps
            call equilibrium%at(equilibrium%radius_of(x), state, error)
            if (allocated(error) .or. x <= smallest) return
            if (state%depth <= depth .or. state%depth > before) return
            before = state%depth
            ! For a shape r^n the minimum is where d0/dl = 1/(2n), and d0/dl grows with a^(n - 1/2), n = 2.
            x = max(smallest, x - max(adhesive_step, (log(max(1.0_wp - state%depth/state%punch_depth, 1.0e-3_wp)) + 1.4_wp)/1.5_wp))
        end do
    end subroutine coordinate_below_pull_off

end module mdrcontact_contact_range
