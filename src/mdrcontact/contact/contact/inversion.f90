! SPDX-License-Identifier: GPL-3.0-or-later
!> From a given depth or force to the non-adhesive state: the contact radius that has it, found where every law is nearly straight.
module mdrcontact_contact_inversion
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_coordinate, only: coordinate_t
    use mdrcontact_contact_range, only: first_guess
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_error, only: error_no_convergence, error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: solved_t
    use mdrcontact_numerics_roots, only: cubic_error, inverse_cubic, solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: invert, neighbours_t

    !> ln(s/target), s = d or F or what a spring adds of both, as a function of ln(a - end radius): close to linear for every
    !> shape and medium.
    type, extends(scalar_function_t) :: mismatch_t
        type(equilibrium_t), pointer :: equilibrium => null()
        type(control_t) :: control
        real(wp) :: target_value = 0.0_wp
        !> the last state considered, and dk/da there; not found where only the depth was needed
        type(contact_state_t) :: state
        real(wp) :: stiffness_slope = 0.0_wp
        !> its coordinate and the mismatch there
        real(wp) :: x = 0.0_wp, y = 0.0_wp
        logical :: has_state = .false.
    contains
        procedure :: value => mismatch_value
        procedure :: flat_end
    end type mismatch_t

    !> The two states found last: coordinate, ln s and its slope over the coordinate. The next one is close to the cubic through
    !> them. For media whose states are solved for; empty at first.
    type :: neighbours_t
        private
        integer :: count = 0
        real(wp), dimension(2) :: x = 0.0_wp, log_s = 0.0_wp, slope = 0.0_wp
    contains
        procedure, private :: guess => guess_from_neighbours
        procedure, private :: add => add_neighbour
    end type neighbours_t

    !> ln of the smallest contact radius searched: its cube is still a normal number.
    real(wp), parameter :: smallest_log = -230.0_wp
    !> Up to this relative change of a - end radius states are taken as linear: its square is below rounding.
    real(wp), parameter :: linear = 5.0e-9_wp
    !> The same where a state is solved for, to a tolerance far above the square.
    real(wp), parameter :: linear_where_solved = 1.0e-6_wp
    !> Slopes of ln s over the coordinate.
    real(wp), parameter :: largest_slope = 10.0_wp
    !> Slope of ln s to begin with, where none is known.
    real(wp), parameter :: expected_slope = 2.0_wp
    !> The radius of a homogeneous body is but a guess: found to this part of itself, and in at most so many steps.
    real(wp), parameter :: short_step = 0.01_wp
    integer, parameter :: most_steps = 50
    !> Parts of the medium's largest radius: wider states cost much where they are solved for, and may fail; near the other
    !> one, states are as those of the surface alone.
    real(wp), parameter :: wide = 1.0e-2_wp, narrow = 1.0e-7_wp
    !> A value of s may differ by this part of itself from that at the largest load of an imprint, which has been solved for.
    real(wp), parameter :: largest_rounding = 1.0e-9_wp
    !> So far below the coordinate from which on the depth falls a search begins that would begin beyond it.
    real(wp), parameter :: before_top = 0.5_wp

contains

    !> The non-adhesive state with a given s, which grows with the contact radius.
    subroutine invert(equilibrium, control, name, s, state, error, neighbours)
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> states found for values of s close by
        type(neighbours_t), intent(inout), optional :: neighbours
        type(mismatch_t) :: mismatch
        real(wp) :: closest, missing
        logical :: found

        if (s <= 0.0_wp) then
            call equilibrium%at(equilibrium%profile%end_radius, state, error)
            return
        end if
        if (equilibrium%profile%has_wall .and. equilibrium%last_radius >= equilibrium%profile%largest_radius) then
            call equilibrium%at(equilibrium%last_radius, state, error)
            if (allocated(error)) return
            if (s >= control%of(state%depth, state%force)) then
                call extend_at_constant_radius(state, control, s, state%punch_depth)
                return
            end if
        end if
        if (equilibrium%ends_sharply()) then
            ! the state of the largest load itself
            state = equilibrium%sharp_end
            if (abs(s - control%of(state%depth, state%force)) <= largest_rounding*s) return
        end if
        mismatch%equilibrium => equilibrium
        mismatch%control = control
        mismatch%target_value = s
        if (.not. equilibrium%medium%is_modulus_formula) then
            mismatch%near_enough = linear_where_solved
        else
            ! Behind a flat end the radius has lost digits of its distance from it, and with them the integrals.
            mismatch%is_rough = equilibrium%profile%end_radius > 0.0_wp
        end if
        call find_radius(mismatch, closest, found, error, neighbours)
        if (allocated(error)) return
        if (present(neighbours)) call neighbours%add(mismatch)
        if (found .and. is_close(mismatch, closest)) then
            call shift(mismatch, closest, state)
            return
        end if
        call equilibrium%at(closest, state, error)
        if (allocated(error)) return
        if (found) then
            if (.not. equilibrium%profile%end_radius > 0.0_wp) return
            ! just after touch the radius of a flat end has lost the digits that depth and force need; even the double next to the
            ! end may be far too wide
            if (control%of(state%depth, state%force) > 2.0_wp*s) call equilibrium%at(equilibrium%profile%end_radius, state, error)
            if (.not. allocated(error)) call extend_at_constant_radius(state, control, s, missing)
            return
        end if
        if (control%of(state%depth, state%force) > s) then
            call raise(error, error_unreachable, " = "//to_text(s)//": at radius "//to_text(state%radius)// &
                       ", where the medium begins, the "//name//" is "//to_text(control%of(state%depth, state%force)), name)
        else
            call raise(error, error_unreachable, " = "//to_text(s)//": at radius "//to_text(state%radius)// &
                       ", where the indenter or the medium ends, the "//name//" is "//to_text(control%of(state%depth, &
                       state%force))//trim(equilibrium%why_it_ends()), name)
        end if
    end subroutine invert

    !> As a flat punch of the radius reached, with dF = k dd.
    pure subroutine extend_at_constant_radius(state, control, s, missing)
        type(contact_state_t), intent(inout) :: state
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        !> depth minus that of the state reached [length]
        real(wp), intent(out) :: missing

        missing = (s - control%of(state%depth, state%force))/control%of(1.0_wp, state%stiffness)
        state%depth = state%depth + missing
        state%force = state%force + state%stiffness*missing
    end subroutine extend_at_constant_radius

    !> Whether the last state considered differs from that at `radius` by so little that squares do not show.
    pure function is_close(mismatch, radius) result(answer)
        type(mismatch_t), intent(in) :: mismatch
        real(wp), intent(in) :: radius
        logical :: answer

        real(wp) :: part

        part = max(linear, mismatch%near_enough)
        associate (state => mismatch%state)
            answer = mismatch%has_state .and. .not. mismatch%is_rough &
                     .and. abs(radius - state%radius) <= part*(radius - mismatch%flat_end()) &
                     .and. abs(mismatch%y) <= largest_slope*part
        end associate
    end function is_close

    !> The state at `radius` from the last one considered: dk = k' da, and by property B (theory/exact.md (1.7)) dF = k dd, k
    !> halfway.
    pure subroutine shift(mismatch, radius, state)
        type(mismatch_t), intent(in) :: mismatch
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        real(wp) :: missing, more, halfway

        state = mismatch%state
        more = mismatch%stiffness_slope*(radius - state%radius)
        halfway = state%stiffness + 0.5_wp*more
        missing = mismatch%target_value - mismatch%control%of(state%depth, state%force)
        missing = missing/mismatch%control%of(1.0_wp, halfway)
        state%depth = state%depth + missing
        state%force = state%force + halfway*missing
        state%stiffness = state%stiffness + more
        state%radius = radius
    end subroutine shift

    !> The smallest contact radius that has s: the one to which the contact has grown from initial contact. Where depth and force
    !> fall larger radii have it too, and pressures below 0.
    subroutine find_radius(mismatch, radius, found, error, neighbours)
        type(mismatch_t), intent(inout) :: mismatch
        real(wp), intent(out) :: radius
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(neighbours_t), intent(in), optional :: neighbours
        real(wp) :: smallest, first, last
        integer :: i

        associate (equilibrium => mismatch%equilibrium, ranges => mismatch%equilibrium%unstable_ranges)
            smallest = smallest_log
            if (equilibrium%medium%smallest_radius > equilibrium%profile%end_radius) then
                smallest = equilibrium%coordinate_of(equilibrium%medium%smallest_radius)
            end if
            first = smallest
            do i = 1, size(ranges)
                if (mismatch%target_value <= mismatch%control%of(ranges(i)%top%depth, ranges(i)%top%force)) then
                    call find_between(mismatch, first, ranges(i)%first, radius, found, error, neighbours)
                    if (found .or. allocated(error)) return
                end if
                first = ranges(i)%last
            end do
            last = equilibrium%coordinate_of(equilibrium%last_radius)
            call find_between(mismatch, first, last, radius, found, error, neighbours)
            ! where a range is not known as well as the states
            if (.not. (found .or. allocated(error)) .and. radius <= equilibrium%radius_of(first) .and. size(ranges) > 0) then
                call find_between(mismatch, smallest, last, radius, found, error)
            end if
        end associate
    end subroutine find_radius

    !> The contact radius between two coordinates.
    subroutine find_between(mismatch, first, last, radius, found, error, neighbours)
        type(mismatch_t), intent(inout) :: mismatch
        real(wp), intent(in) :: first, last
        real(wp), intent(out) :: radius
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(neighbours_t), intent(in), optional :: neighbours
        real(wp) :: guess, root, distance, widest
        logical :: guessed

        associate (equilibrium => mismatch%equilibrium)
            widest = last
            if (mismatch%near_enough > 0.0_wp) then
                widest = min(last, log(max(wide*equilibrium%medium%largest_radius, tiny(1.0_wp))))
            end if
            guessed = .false.
            distance = 1.0_wp
            if (present(neighbours)) call neighbours%guess(mismatch, guess, distance, guessed)
            if (.not. guessed) then
                distance = 1.0_wp
                call guess_of_surface(mismatch, first, last, guess, error)
                if (allocated(error)) then
                    found = .false.
                    return
                end if
                ! A stiff film bends and sinks by more than it would as a half-space: the contact is smaller.
                if (guess > last) then
                    guess = last - before_top
                else if (guess > widest) then
                    guess = narrow_coordinate(equilibrium)
                end if
            end if
            if (guess > widest) widest = last
            call solve_increasing(mismatch, guess, expected_slope, first, widest, root, found, error, distance)
            if (.not. (allocated(error) .or. found) .and. root >= widest .and. widest < last) then
                call solve_increasing(mismatch, widest, expected_slope, first, last, root, found, error)
            end if
            if (allocated(error) .and. mismatch%near_enough > 0.0_wp) then
                if (error%code == error_no_convergence) then
                    ! That a state farther out is refused gives no information on those further in.
                    deallocate (error)
                    if (allocated(mismatch%error)) deallocate (mismatch%error)
                    call solve_increasing(mismatch, narrow_coordinate(equilibrium), expected_slope, first, last, root, found, error)
                end if
            end if
            radius = equilibrium%radius_of(root)
        end associate
    end subroutine find_between

    !> Coordinate of a contact small enough to start an upward search, in steps of bounded length.
    pure function narrow_coordinate(equilibrium) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp) :: x

        x = log(max(narrow*min(equilibrium%medium%largest_radius, equilibrium%last_radius/wide), tiny(1.0_wp)))
    end function narrow_coordinate

    !> Where a half-space of the surface's material would have s.
    subroutine guess_of_surface(mismatch, first, last, guess, error)
        type(mismatch_t), intent(in) :: mismatch
        real(wp), intent(in) :: first, last
        real(wp), intent(out) :: guess
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: radius

        radius = -1.0_wp
        associate (equilibrium => mismatch%equilibrium, control => mismatch%control)
            if (control%depth_weight > 0.0_wp) then
                radius = equilibrium%profile%radius_from_mdr(mismatch%target_value/control%depth_weight)
            end if
            if (radius > equilibrium%profile%end_radius) then
                guess = equilibrium%coordinate_of(radius)
            else
                call guess_of_homogeneous(mismatch, first, last, guess, error)
            end if
        end associate
    end subroutine guess_of_surface

    !> Guess of the next state, and its largest distance.
    pure subroutine guess_from_neighbours(self, mismatch, guess, distance, guessed)
        class(neighbours_t), intent(in) :: self
        type(mismatch_t), intent(in) :: mismatch
        real(wp), intent(out) :: guess, distance
        !> whether there is a state close enough
        logical, intent(out) :: guessed
        real(wp) :: y(2), straight
        integer :: first, last

        guess = 0.0_wp
        distance = 1.0_wp
        guessed = self%count > 0 .and. mismatch%near_enough > 0.0_wp
        if (.not. guessed) return
        y = self%log_s - log(mismatch%target_value)
        last = 2
        if (self%count > 1) last = minloc(abs(y), dim=1)
        first = 3 - last
        straight = self%x(last) - y(last)/self%slope(last)
        guess = straight
        if (self%count > 1) guess = inverse_cubic(self%x([first, last]), y([first, last]), self%slope([first, last]), straight, &
                                                      0.0_wp)
        if (guess /= straight) then
            distance = cubic_error(guess, self%x)
        else
            distance = (straight - self%x(last))**2
        end if
        guessed = distance < 1.0_wp
    end subroutine guess_from_neighbours

    !> Keeps the state considered last, instead of the older of two.
    pure subroutine add_neighbour(self, mismatch)
        class(neighbours_t), intent(inout) :: self
        type(mismatch_t), intent(in) :: mismatch

        if (.not. (mismatch%has_state .and. mismatch%known_slope > 0.0_wp)) return
        self%x = [self%x(2), mismatch%x]
        self%log_s = [self%log_s(2), mismatch%y + log(mismatch%target_value)]
        self%slope = [self%slope(2), mismatch%known_slope]
        self%count = min(self%count + 1, 2)
    end subroutine add_neighbour

    !> Where a homogeneous body of the surface's modulus would have s, by the indenter's law, which costs no solution: Newton's
    !> method in the coordinates in which it is nearly straight.
    subroutine guess_of_homogeneous(mismatch, first, last, guess, error)
        type(mismatch_t), intent(in) :: mismatch
        real(wp), intent(in) :: first, last
        real(wp), intent(out) :: guess
        type(error_t), allocatable, intent(out) :: error
        type(coordinate_t) :: coordinate
        real(wp) :: low, high, radius, modulus(1), s, rate, step
        integer :: i

        low = first
        high = last
        guess = min(max(first, first_guess), last - 1.0_wp)
        coordinate = mismatch%equilibrium%coordinate()
        associate (equilibrium => mismatch%equilibrium, profile => mismatch%equilibrium%profile, control => mismatch%control)
            call equilibrium%medium%modulus([equilibrium%radius_of(guess)], modulus, error)
            if (allocated(error)) return
            do i = 1, most_steps
                radius = equilibrium%radius_of(guess)
                s = max(control%of(profile%mdr(radius), 2.0_wp*modulus(1)*profile%mdr_moment(radius)), tiny(s))
                rate = coordinate%rate(radius)*profile%mdr_slope(radius)*control%of(1.0_wp, 2.0_wp*radius*modulus(1))/s
                step = -log(s/mismatch%target_value)
                if (step > 0.0_wp) then
                    low = guess
                else
                    high = guess
                end if
                if (rate > 0.0_wp .and. rate <= huge(rate) .and. s > tiny(s)) then
                    step = step/rate
                else
                    step = 0.5_wp*(low + high) - guess
                end if
                if (.not. (guess + step >= low .and. guess + step <= high)) step = 0.5_wp*(low + high) - guess
                guess = guess + step
                ! where a state is a formula too it is as cheap to continue with it
                if (abs(step) < short_step .or. equilibrium%is_formula) exit
            end do
        end associate
    end subroutine guess_of_homogeneous

    pure function flat_end(self) result(radius)
        class(mismatch_t), intent(in) :: self
        real(wp) :: radius

        radius = self%equilibrium%profile%end_radius
    end function flat_end

    function mismatch_value(self, x) result(y)
        class(mismatch_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(solved_t) :: solved
        type(coordinate_t) :: coordinate
        real(wp) :: radius, formula, s

        y = 0.0_wp
        radius = self%equilibrium%radius_of(x)
        coordinate = self%equilibrium%coordinate()
        formula = -1.0_wp
        if (.not. self%equilibrium%medium%is_exact) formula = self%equilibrium%profile%mdr_slope(radius)
        ! Where the depth is a formula the force, an integral, is not computed.
        self%has_state = self%control%force_weight > 0.0_wp .or. formula < 0.0_wp
        if (self%has_state) then
            call self%equilibrium%medium%solve(self%equilibrium%profile, radius, solved, self%error, accuracy=self%accuracy)
        else
            solved%depth = self%equilibrium%profile%mdr(radius)
        end if
        if (.not. self%equilibrium%medium%is_exact) solved%depth_slope = formula
        if (allocated(self%error)) return
        if (self%has_state) then
            self%state%radius = radius
            self%state%depth = solved%depth
            self%state%force = solved%force
            self%state%stiffness = 2.0_wp*radius*solved%modulus
            self%stiffness_slope = solved%stiffness_slope
        end if
        s = max(self%control%of(solved%depth, solved%force), tiny(s))
        y = log(s/self%target_value)
        self%known_slope = coordinate%rate(radius)*solved%depth_slope*self%control%of(1.0_wp, 2.0_wp*radius*solved%modulus)/s
        ! Unknown to both formula and solution; or infinite, as d' at the edge of a flat end.
        if (solved%depth_slope < 0.0_wp .and. solved%depth_slope == formula) self%known_slope = 0.0_wp
        ! And that of ln s says nothing where rounding has left nothing of s, next to a flat end.
        if (.not. abs(self%known_slope) <= huge(s) .or. s <= tiny(s)) self%known_slope = 0.0_wp
        ! The radius closest to x is not exactly there, least so next to a flat end.
        if (radius < self%equilibrium%last_radius) y = y + self%known_slope*(x - self%equilibrium%coordinate_of(radius))
        self%x = x
        self%y = y
    end function mismatch_value

end module mdrcontact_contact_inversion
