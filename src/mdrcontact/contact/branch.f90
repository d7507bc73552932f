! SPDX-License-Identifier: GPL-3.0-or-later
!> The whole branch of adhesive equilibria d(a), F(a), its extrema, and the stable states on it (theory 5).
!>
!> A machine controls s = depth_weight d + force_weight F: depth (1, 0), force (0, 1), or the far end of a spring of stiffness K
!> (1, 1/K). Equilibria are stable where s grows with the contact radius; a coated body can have several such stretches.
module mdrcontact_contact_branch
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_error, only: error_no_convergence, error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: find_root, guess_from_below, solve_increasing
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: branch_t, control_t, stretch_t, new_branch
    public :: depth_control, force_control

    !> What the machine prescribes: s = depth_weight d + force_weight F.
    type :: control_t
        !> [1], or [modulus length] where s is a force
        real(wp) :: depth_weight = 1.0_wp
        !> [length^-1 modulus^-1], or [1] where s is a force
        real(wp) :: force_weight = 0.0_wp
    contains
        procedure :: of
    end type control_t

    !> The machine prescribes the indentation depth.
    type(control_t), parameter :: depth_control = control_t(1.0_wp, 0.0_wp)
    !> The machine prescribes the normal force.
    type(control_t), parameter :: force_control = control_t(0.0_wp, 1.0_wp)

    !> A stable stretch of the branch: s grows from `lowest` to `highest` as the coordinate goes from `first` to `last`.
    type :: stretch_t
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        !> the radius stays at the indenter's vertical wall, the depth changes
        logical :: at_wall = .false.
    end type stretch_t

    !> d and F sampled over the coordinate x = ln(a - end radius), from where adhesion is all to where it is nothing.
    type :: branch_t
        private
        type(sampled_function_t) :: depth, force
        !> F dd/dx
        type(sampled_function_t) :: power
        !> stable stretches under depth and force control
        type(stretch_t), allocatable :: depth_stretches(:), force_stretches(:)
        !> without a range of radii (flat punch) there are wall states only
        logical :: has_range = .false.
    contains
        procedure :: stretches
        procedure :: state_on
        procedure :: work_between
    end type branch_t

    !> One of d, F, F d' or s of an equilibrium as a function of the coordinate.
    type, extends(scalar_function_t) :: quantity_t
        type(equilibrium_t), pointer :: equilibrium => null()
        type(control_t) :: control
        real(wp) :: offset = 0.0_wp
        !> ln(s/offset) in place of s - offset
        logical :: is_logarithmic = .false.
    contains
        procedure :: value => quantity_at
    end type quantity_t

    type, extends(scalar_function_t) :: power_t
        type(sampled_function_t), pointer :: depth => null(), force => null()
    contains
        procedure :: value => power_at
    end type power_t

    type, extends(scalar_function_t) :: slope_t
        type(sampled_function_t), pointer :: sampled => null()
    contains
        procedure :: value => slope_at
    end type slope_t

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
    real(wp), parameter :: coarse_tolerance = 1.0e-9_wp
    !> Half width of the interval around an extremum on which s is sampled again to find it to full precision.
    real(wp), parameter :: extremum_width = 0.05_wp
    integer, parameter :: probes_per_panel = 24
    !> Extrema lie less than this far below the radius where d0 = dl (in ln a).
    real(wp), parameter :: room_below = 10.0_wp
    real(wp), parameter :: smallest_log = -200.0_wp, first_guess = -35.0_wp

contains

    !> s of a state.
    elemental function of(self, depth, force) result(s)
        class(control_t), intent(in) :: self
        !> d [length], F [modulus length^2]
        real(wp), intent(in) :: depth, force
        real(wp) :: s

        s = self%depth_weight*depth + self%force_weight*force
    end function of

    !> Samples the branch of an adhesive equilibrium.
    subroutine new_branch(self, equilibrium, error)
        type(branch_t), intent(out) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(error_t), allocatable, intent(out) :: error
        type(quantity_t) :: quantity
        type(power_t) :: power
        type(sampled_function_t), target :: depth, force
        type(stretch_t), allocatable :: of_depth(:), of_force(:)
        real(wp), allocatable :: edges(:)
        logical, allocatable :: plain(:)

        self%has_range = equilibrium%profile%end_radius() < equilibrium%last_radius*(1.0_wp - 1.0e-12_wp)
        if (self%has_range) then
            call coordinate_range(equilibrium, edges, error)
            if (allocated(error)) return
            allocate (plain(size(edges) - 1), source=.false.)
            quantity%equilibrium => equilibrium
            quantity%control = depth_control
            call new_sampled_function(depth, quantity, edges, plain, coarse_tolerance, error)
            if (allocated(error)) return
            quantity%control = force_control
            call new_sampled_function(force, quantity, edges, plain, coarse_tolerance, error)
            if (allocated(error)) return
            power%depth => depth
            power%force => force
            call new_sampled_function(self%power, power, edges, plain, coarse_tolerance, error)
            if (allocated(error)) return
            self%depth = depth
            self%force = force
        end if
        call self%stretches(equilibrium, depth_control, of_depth, error)
        if (.not. allocated(error)) call self%stretches(equilibrium, force_control, of_force, error)
        if (allocated(error)) return
        call move_alloc(of_depth, self%depth_stretches)
        call move_alloc(of_force, self%force_stretches)
    end subroutine new_branch

    !> Panel edges over the coordinates where d or F can have extrema.
    subroutine coordinate_range(equilibrium, edges, error)
        type(equilibrium_t), intent(in), target :: equilibrium
        real(wp), allocatable, intent(out) :: edges(:)
        type(error_t), allocatable, intent(out) :: error
        type(handover_t) :: handover
        real(wp) :: smallest, largest, equal, over, guess, slope
        integer :: i, count
        logical :: found

        handover%equilibrium => equilibrium
        largest = equilibrium%coordinate_of(equilibrium%last_radius)
        smallest = smallest_log
        if (equilibrium%medium%smallest_radius() > equilibrium%profile%end_radius()) then
            smallest = equilibrium%coordinate_of(equilibrium%medium%smallest_radius())
        end if
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
        if (allocated(error)) return
        handover%ratio = 1.0_wp/adhesion_over
        call solve_increasing(handover, equal, slope, smallest, largest, over, found, error)
        if (allocated(error)) return
        smallest = max(smallest, min(equal, over - 1.0_wp) - decades_below)
        over = max(over, min(smallest + 1.0_wp, largest))
        count = max(1, nint(0.5_wp*(over - smallest)))
        edges = [(smallest + (over - smallest)*(real(i, wp)/count), i=0, count)]
        edges(count + 1) = over
    end subroutine coordinate_range

    !> The stable stretches under a control, in ascending order of the contact radius. The last reaches to the end of the
    !> indenter or medium, or climbs its vertical wall without end.
    subroutine stretches(self, equilibrium, control, list, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stretch_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: turns(:), s(:)
        type(contact_state_t) :: end_state
        type(stretch_t) :: wall
        real(wp) :: end_coordinate
        integer :: i, n

        if (allocated(self%depth_stretches) .and. control%force_weight == 0.0_wp) then
            list = self%depth_stretches
            return
        else if (allocated(self%force_stretches) .and. control%depth_weight == 0.0_wp) then
            list = self%force_stretches
            return
        end if
        allocate (list(0))
        if (self%has_range) then
            call turning_points(self, equilibrium, control, turns, s, error)
            if (allocated(error)) return
            n = size(turns)
            do i = 1, n - 1
                if (s(i + 1) > s(i)) list = [list, stretch_t(turns(i), turns(i + 1), s(i), s(i + 1))]
            end do
            end_coordinate = equilibrium%coordinate_of(equilibrium%last_radius)
            if (size(list) > 0) then
                if (list(size(list))%last >= turns(n) .and. end_coordinate > turns(n)) then
                    ! Beyond the samples s goes on to grow, to the end of the indenter or medium if there is one.
                    list(size(list))%last = end_coordinate
                    list(size(list))%highest = huge(1.0_wp)
                end if
            end if
        end if
        if (.not. equilibrium%profile%has_wall()) return
        if (equilibrium%last_radius < equilibrium%profile%largest_radius()*(1.0_wp - 1.0e-12_wp)) return
        wall%at_wall = .true.
        wall%first = equilibrium%coordinate_of(equilibrium%last_radius)
        wall%last = wall%first
        call equilibrium%at(equilibrium%last_radius, end_state, error)
        wall%lowest = control%of(end_state%depth, end_state%force)
        wall%highest = huge(1.0_wp)
        if (size(list) > 0) then
            if (list(size(list))%last >= wall%first) list(size(list))%highest = wall%lowest
        end if
        list = [list, wall]
    end subroutine stretches

    !> Ends and extrema of s along the sampled branch, with s there.
    subroutine turning_points(self, equilibrium, control, turns, s, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), allocatable, intent(out) :: turns(:), s(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: edges(:)
        real(wp) :: x, x_before, slope, slope_before
        integer :: panel, probe

        allocate (edges, source=self%depth%panel_edges())
        turns = [edges(1)]
        x_before = edges(1)
        slope_before = control%of(self%depth%slope(x_before), self%force%slope(x_before))
        do panel = 1, size(edges) - 1
            do probe = 1, probes_per_panel
                x = edges(panel) + (edges(panel + 1) - edges(panel))*(real(probe, wp)/probes_per_panel)
                slope = control%of(self%depth%slope(x), self%force%slope(x))
                if (opposite(slope, slope_before)) then
                    turns = [turns, refined_extremum(equilibrium, control, x_before, x, error)]
                    if (allocated(error)) return
                end if
                x_before = x
                slope_before = slope
            end do
        end do
        turns = [turns, edges(size(edges))]
        ! Behind a flat end s rises with the root of a - b: the branch begins at the rim itself.
        if (equilibrium%profile%end_radius() > 0.0_wp) turns(1) = smallest_log
        allocate (s(size(turns)))
        do panel = 1, size(turns)
            call value_on(equilibrium, control, turns(panel), s(panel), error)
            if (allocated(error)) return
        end do
    end subroutine turning_points

    !> The extremum of s between two coordinates, from s itself and not from the coarse samples.
    function refined_extremum(equilibrium, control, low, high, error) result(x)
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: low, high
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: x
        type(quantity_t) :: quantity
        type(slope_t) :: slope
        type(sampled_function_t), target :: near
        real(wp) :: from, to, top

        x = 0.5_wp*(low + high)
        top = equilibrium%coordinate_of(equilibrium%last_radius)
        from = low - extremum_width
        to = min(high + extremum_width, top)
        quantity%equilibrium => equilibrium
        quantity%control = control
        call new_sampled_function(near, quantity, [from, to], [.false.], coarse_tolerance, error)
        if (allocated(error)) return
        slope%sampled => near
        if (opposite(near%slope(from), near%slope(to))) call find_root(slope, from, to, x, error)
    end function refined_extremum

    !> Whether two numbers have opposite signs; their product may underflow.
    pure function opposite(x, y) result(answer)
        real(wp), intent(in) :: x, y
        logical :: answer

        answer = (x < 0.0_wp .and. y > 0.0_wp) .or. (x > 0.0_wp .and. y < 0.0_wp)
    end function opposite

    subroutine value_on(equilibrium, control, x, s, error)
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp), intent(out) :: s
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state

        call equilibrium%at(equilibrium%radius_of(x), state, error)
        s = control%of(state%depth, state%force)
    end subroutine value_on

    !> The state with a given s on a stretch that contains it.
    subroutine state_on(self, equilibrium, control, stretch, s, state, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stretch_t), intent(in) :: stretch
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(quantity_t) :: quantity
        real(wp) :: x, more
        logical :: found

        if (stretch%at_wall) then
            call equilibrium%at(equilibrium%last_radius, state, error)
            if (allocated(error)) return
            more = (s - stretch%lowest)/control%of(1.0_wp, state%stiffness)
            state%excess = state%excess + more
            state%depth = state%depth + more
            state%force = state%force + state%stiffness*more
            return
        end if
        if (s <= stretch%lowest) then
            x = stretch%first
        else if (s >= stretch%highest) then
            x = stretch%last
        else
            quantity%equilibrium => equilibrium
            quantity%control = control
            quantity%offset = s
            quantity%is_rough = equilibrium%profile%end_radius() > 0.0_wp
            call find_coordinate(self, quantity, control, stretch, x, found, error)
            if (allocated(error)) return
            if (.not. found) then
                call raise(error, error_unreachable, "no state found up to radius = "//to_text(equilibrium%radius_of(x))// &
                           ", where the indenter or the medium ends")
                return
            end if
        end if
        call equilibrium%at(equilibrium%radius_of(x), state, error)
    end subroutine state_on

    !> Brackets the root by the samples where they reach, then solves on the equilibrium itself.
    subroutine find_coordinate(self, quantity, control, stretch, x, found, error)
        class(branch_t), intent(in) :: self
        type(quantity_t), intent(inout) :: quantity
        type(control_t), intent(in) :: control
        type(stretch_t), intent(in) :: stretch
        real(wp), intent(out) :: x
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: low, high, middle, slope, guess, s_high
        integer :: i

        low = max(stretch%first, self%depth%lower())
        high = min(stretch%last, self%depth%upper())
        s_high = control%of(self%depth%value(high), self%force%value(high))
        if (s_high > quantity%offset) then
            do i = 1, 60
                middle = 0.5_wp*(low + high)
                if (control%of(self%depth%value(middle), self%force%value(middle)) < quantity%offset) then
                    low = middle
                else
                    high = middle
                end if
            end do
            guess = 0.5_wp*(low + high)
            slope = control%of(self%depth%slope(guess), self%force%slope(guess))
        else
            guess = high
            slope = control%of(self%depth%slope(high), self%force%slope(high))
            ! Beyond the samples s follows a power of the radius.
            quantity%is_logarithmic = s_high > 0.0_wp
            if (quantity%is_logarithmic) slope = slope/s_high
        end if
        if (.not. slope > 0.0_wp) slope = merge(2.0_wp, tiny(1.0_wp) + abs(quantity%offset), quantity%is_logarithmic)
        call solve_increasing(quantity, guess, slope, stretch%first, stretch%last, x, found, error)
    end subroutine find_coordinate

    !> int F dd from coordinate `from` to coordinate `to`, both clipped to the sampled range: beyond it adhesion is over, and
    !> loading and unloading do the same work.
    pure function work_between(self, from, to) result(work)
        class(branch_t), intent(in) :: self
        real(wp), intent(in) :: from, to
        real(wp) :: work

        work = self%power%integral(min(max(to, self%power%lower()), self%power%upper())) &
               - self%power%integral(min(max(from, self%power%lower()), self%power%upper()))
    end function work_between

    function quantity_at(self, x) result(y)
        class(quantity_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state

        call self%equilibrium%at(self%equilibrium%radius_of(x), state, self%error)
        y = self%control%of(state%depth, state%force)
        if (self%is_logarithmic) then
            y = log(max(y, tiny(y))/self%offset)
        else
            y = y - self%offset
        end if
    end function quantity_at

    function power_at(self, x) result(y)
        class(power_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%force%value(x)*self%depth%slope(x)
    end function power_at

    function slope_at(self, x) result(y)
        class(slope_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%sampled%slope(x)
    end function slope_at

    function handover_at(self, x) result(y)
        class(handover_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state
        real(wp) :: depth

        call self%equilibrium%at(self%equilibrium%radius_of(x), state, self%error)
        depth = state%depth - state%excess
        y = log(max(depth, tiny(depth))) - log(self%ratio) - log(max(-state%excess, tiny(depth)))
    end function handover_at

end module mdrcontact_contact_branch
