! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact with a cohesive zone, sampled once along their curve: from the first attraction at a distance
!> (x = -1), c growing to touch (x = 0), then a growing as c_0 sinh x, c_0 the zone's radius at touch. What is sampled says where
!> depth and force turn, begins the search for a state, and does the work of loops; states themselves are solved.
module mdrcontact_contact_zone_curve
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact_cohesion, only: zone_guess_t
    use mdrcontact_contact_control, only: control_t, depth_control
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_samples, only: curve_point_t, samples_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_numerics_chebyshev, only: node, nodes => terms, series_of_values
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: zone_curve_t, new_zone_curve, zone_state, coordinate_of

    integer, parameter :: rows = 7, of_depth = 1, of_force = 2, of_stiffness = 3, of_length = 4, of_slope = 5, of_depth_rate = 6, &
                          of_force_rate = 7
    integer, parameter :: most_panels = 400, probes = 48, work_nodes = 20
    !> Panels are this long at first, and none is halved below the second, or the third where a tolerance is given: a short zone
    !> changes fast as it passes a kink of the indenter.
    real(wp), parameter :: usual_length = 1.0_wp, shortest_length = 1.0e-4_wp, shortest_of_all = 1.0e-7_wp
    !> Relative, of the samples, where no other tolerance is given.
    real(wp), parameter :: usual_tolerance = 1.0e-9_wp
    !> Halving a panel shorter than the first makes its last terms many times smaller: else they are noise of the states, up to the
    !> second.
    real(wp), parameter :: noisy_length = 0.25_wp, largest_noise = 1.0e-8_wp
    !> A break closer to an edge than this is there.
    real(wp), parameter :: no_room = 1.0e-9_wp
    !> Newton's steps; one that is so short leaves less than rounding.
    integer, parameter :: most_steps = 100
    real(wp), parameter :: last_step = 1.0e-9_wp
    !> Rounding may put a root a little beyond the end of a panel.
    real(wp), parameter :: overlap = 1.0e-6_wp
    !> The slope behind a break is taken no closer to it than this.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

    !> Chebyshev series of d, F, k, ln(c - a), and the slopes of ln h, d and F over ln(c - a), on panels of x.
    type, extends(samples_t) :: zone_curve_t
        !> c_0 [length]
        real(wp), private :: touching_zone = 0.0_wp
        !> whether a panel begins at a break of the indenter, and is a series in the root of the distance from it
        logical, allocatable, private :: from_root(:)
        !> (rows, nodes, panels)
        real(wp), allocatable, private :: coefficients(:, :, :)
    contains
        procedure :: guess_at
        procedure :: at
        procedure :: control_at
        procedure :: slope
        procedure :: turns
        procedure :: segments
        procedure :: breaks
        procedure :: find
        procedure :: work_between
        procedure :: state_at
    end type zone_curve_t

    !> How far beyond a radius the zone ends, as a function of the coordinate.
    type, extends(scalar_function_t) :: zone_end_t
        type(equilibrium_t), pointer :: equilibrium => null()
        real(wp) :: radius = 0.0_wp
    contains
        procedure :: value => zone_end_at
    end type zone_end_t

contains

    !> The state at a coordinate.
    subroutine zone_state(equilibrium, x, state, error, guess)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(zone_guess_t), intent(inout), optional :: guess

        associate (cohesion => equilibrium%cohesion)
            if (x < 0.0_wp) then
                call cohesion%apart(equilibrium%profile, cohesion%touching_zone*max(1.0_wp + x, 0.0_wp), state, error)
            else
                call cohesion%at_radius(equilibrium%profile, min(cohesion%touching_zone*sinh(x), equilibrium%last_radius), state, &
                                        error, guess)
            end if
        end associate
    end subroutine zone_state

    !> The coordinate of a contact radius, or without contact of a radius of the zone.
    pure function coordinate_of(equilibrium, radius, zone_radius) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: radius, zone_radius
        real(wp) :: x

        if (radius > 0.0_wp) then
            x = asinh(radius/equilibrium%cohesion%touching_zone)
        else
            x = min(zone_radius/equilibrium%cohesion%touching_zone, 1.0_wp) - 1.0_wp
        end if
    end function coordinate_of

    !> Samples the states from the first attraction to coordinate `last`.
    subroutine new_zone_curve(self, equilibrium, last, error, tolerance)
        type(zone_curve_t), intent(out) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: last
        type(error_t), allocatable, intent(inout) :: error
        !> relative, of depth, force and stiffness
        real(wp), intent(in), optional :: tolerance
        real(wp), allocatable :: breaks(:), waiting(:), before(:)
        real(wp) :: panel(rows, nodes), left, right, edges(most_panels + 1), allowed, shortest, tail
        type(zone_guess_t) :: guess
        real(wp), allocatable :: kept(:, :, :)
        logical :: root, roots(most_panels), fits
        integer :: count

        allowed = usual_tolerance
        shortest = shortest_length
        if (present(tolerance)) then
            allowed = tolerance
            shortest = shortest_of_all
        end if
        self%touching_zone = equilibrium%cohesion%touching_zone
        allocate (waiting(1), source=-1.0_wp)
        allocate (breaks(0))
        call first_edges(equilibrium, last, waiting, breaks, error)
        if (allocated(error)) return
        allocate (before(size(waiting) - 1), source=huge(1.0_wp))
        allocate (kept(rows, nodes, most_panels))
        count = 0
        edges(1) = waiting(size(waiting))
        guess%length = equilibrium%cohesion%likely_zone
        do while (size(waiting) > 1)
            call check_cancelled(error)
            if (allocated(error)) return
            left = waiting(size(waiting))
            right = waiting(size(waiting) - 1)
            root = any(abs(breaks - left) <= no_room)
            call sample_panel(equilibrium, left, right, root, panel, tail, guess, error)
            if (allocated(error)) return
            self%solutions = self%solutions + nodes
            associate (last_tail => before(size(before)))
                fits = tail <= allowed .or. right - left <= shortest
                if (right - left < noisy_length .and. tail > 0.5_wp*last_tail) fits = fits .or. tail <= largest_noise
            end associate
            if (.not. fits) then
                waiting = [waiting(:size(waiting) - 1), 0.5_wp*(left + right), left]
                before = [before(:size(before) - 1), tail, tail]
                cycle
            end if
            if (count == most_panels) then
                call raise(error, error_no_convergence, "the states of this contact with its cohesive zone are not smooth on "// &
                           "400 panels")
                return
            end if
            count = count + 1
            kept(:, :, count) = panel
            roots(count) = root
            edges(count + 1) = right
            waiting = waiting(:size(waiting) - 1)
            before = before(:size(before) - 1)
        end do
        self%edges = edges(:count + 1)
        self%from_root = roots(:count)
        self%coefficients = kept(:, :, :count)
    end subroutine new_zone_curve

    !> Edges of the first panels, the leftmost last, and the breaks among them: where the contact ends at a break of the indenter,
    !> and where the zone does.
    subroutine first_edges(equilibrium, last, waiting, breaks, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: last
        real(wp), allocatable, intent(inout) :: waiting(:), breaks(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: radii(:)
        real(wp) :: x, next
        integer :: i

        call equilibrium%profile%add_breaks(radii, error)
        if (allocated(error)) return
        do i = 1, size(radii)
            call zone_ends_at(equilibrium, radii(i), last, x, error)
            if (allocated(error)) return
            breaks = [breaks, x, coordinate_of(equilibrium, radii(i), 0.0_wp)]
        end do
        breaks = pack(breaks, breaks < last - shortest_length .and. breaks > -1.0_wp)
        x = -1.0_wp
        do while (x < last)
            next = min(x + usual_length, last)
            if (x < 0.0_wp) next = 0.0_wp
            next = min(next, minval(breaks, mask=breaks > x + no_room))
            waiting = [next, waiting]
            x = next
        end do
    end subroutine first_edges

    !> The coordinate at which the zone ends at a radius, `last` if there is none before.
    subroutine zone_ends_at(equilibrium, radius, last, x, error)
        type(equilibrium_t), intent(in), target :: equilibrium
        real(wp), intent(in) :: radius, last
        real(wp), intent(out) :: x
        type(error_t), allocatable, intent(inout) :: error
        type(zone_end_t) :: zone_end
        real(wp) :: highest

        x = coordinate_of(equilibrium, 0.0_wp, radius)
        if (radius <= equilibrium%cohesion%touching_zone) return
        zone_end%equilibrium => equilibrium
        zone_end%radius = radius
        highest = min(coordinate_of(equilibrium, radius, 0.0_wp), last)
        x = last
        if (zone_end%value(highest) > 0.0_wp) call find_root(zone_end, 0.0_wp, highest, x, error)
        if (allocated(zone_end%error)) error = zone_end%error
    end subroutine zone_ends_at

    function zone_end_at(self, x) result(y)
        class(zone_end_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state

        call zone_state(self%equilibrium, x, state, self%error)
        y = state%zone_radius - self%radius
    end function zone_end_at

    !> The series of a panel, and how large their last terms are.
    subroutine sample_panel(equilibrium, left, right, root, panel, tail, guess, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root
        real(wp), intent(out) :: panel(rows, nodes)
        !> relative to the largest value
        real(wp), intent(out) :: tail
        !> the zone at the last state
        type(zone_guess_t), intent(inout) :: guess
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        real(wp) :: values(rows, nodes), t, scales(of_stiffness)
        integer :: i

        tail = huge(1.0_wp)
        panel = 0.0_wp
        do i = nodes, 1, -1
            t = 0.5_wp*(1.0_wp + node(i, nodes))
            if (root) t = t**2
            ! without contact there is no search
            call zone_state(equilibrium, left + (right - left)*t, state, error, guess)
            if (allocated(error)) return
            values(:, i) = [state%depth, state%force, state%stiffness, log(max(guess%length, tiny(1.0_wp))), guess%slope, &
                            guess%depth_rate, guess%force_rate]
        end do
        panel = series_of_values(values)
        ! what the zone is like is a guess only
        scales = max(maxval(abs(values(:of_stiffness, :)), dim=2), tiny(1.0_wp))
        tail = maxval(sum(abs(panel(:of_stiffness, nodes - 1:)), dim=2)/scales)
    end subroutine sample_panel

    !> About what the zone is at a coordinate.
    pure function guess_at(self, x) result(guess)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        type(zone_guess_t) :: guess
        real(wp) :: v(rows), dv(rows)

        call evaluate(self, min(max(x, 0.0_wp), self%edges(size(self%edges))), v, dv)
        guess = zone_guess_t(exp(v(of_length)), v(of_slope), v(of_depth_rate), v(of_force_rate), is_close=.true.)
    end function guess_at

    !> s and its slope at a coordinate.
    pure subroutine control_at(self, control, x, s, slope)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp), intent(out) :: s, slope
        real(wp) :: v(rows), dv(rows)

        call evaluate(self, x, v, dv)
        s = control%of(v(of_depth), v(of_force))
        slope = control%of(dv(of_depth), dv(of_force))
    end subroutine control_at

    !> ds/dx at a coordinate.
    pure function slope(self, control, x) result(rate)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp) :: rate
        real(wp) :: s

        call self%control_at(control, x, s, rate)
    end function slope

    !> The equilibrium at a coordinate.
    pure function at(self, x) result(point)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows)

        call evaluate(self, x, v, dv)
        point = point_of(self, x, v)
    end function at

    pure function point_of(self, x, v) result(point)
        type(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x, v(rows)
        type(curve_point_t) :: point

        point%x = x
        point%depth = v(of_depth)
        point%force = v(of_force)
        if (.not. x > 0.0_wp) return
        point%radius = self%touching_zone*sinh(x)
        point%stiffness = v(of_stiffness)
    end function point_of

    !> The state of the contact itself at a coordinate.
    subroutine state_at(self, equilibrium, x, state, error)
        class(zone_curve_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(zone_guess_t) :: guess

        guess = self%guess_at(x)
        ! the last digits are the contact's own
        guess%is_close = .false.
        call zone_state(equilibrium, x, state, error, guess)
    end subroutine state_at

    !> The segments on which s grows, ascending.
    pure function segments(self, control) result(list)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable :: list(:)
        real(wp), allocatable :: x(:), s(:)
        real(wp) :: unused
        integer :: i

        allocate (x(0))
        x = [self%edges(1), self%turns(control), self%edges(size(self%edges))]
        allocate (s(size(x)))
        do i = 1, size(x)
            call self%control_at(control, x(i), s(i), unused)
        end do
        list = [(stable_segment_t(x(i), x(i + 1), s(i), s(i + 1)), i=1, size(x) - 1)]
        list = pack(list, list%highest > list%lowest)
    end function segments

    !> The coordinates at which the curve is not analytic: touch and the breaks of the indenter, ascending.
    pure function breaks(self) result(x)
        class(zone_curve_t), intent(in) :: self
        real(wp), allocatable :: x(:)

        x = [0.0_wp, pack(self%edges(:size(self%from_root)), self%from_root)]
    end function breaks

    !> The rows and their slopes at a coordinate.
    pure subroutine evaluate(self, x, v, dv)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: v(rows), dv(rows)
        real(wp) :: z
        integer :: panel

        panel = interval_of(self%edges, x)
        z = local(self, panel, x)
        call series(self%coefficients(:, :, panel), z, v, dv)
        dv = 2.0_wp*dv/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) dv = dv/max(1.0_wp + z, 2.0_wp*smallest_root)
    end subroutine evaluate

    !> A series and its slope by Clenshaw's recurrence.
    pure subroutine series(c, z, v, dv)
        real(wp), intent(in) :: c(rows, nodes), z
        real(wp), intent(out) :: v(rows), dv(rows)
        real(wp), dimension(rows) :: b, b1, b2, s, s1, s2
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        s1 = 0.0_wp
        s2 = 0.0_wp
        do j = nodes, 2, -1
            s = 2.0_wp*(z*s1 + b1) - s2
            s2 = s1
            s1 = s
            b = 2.0_wp*z*b1 - b2 + c(:, j)
            b2 = b1
            b1 = b
        end do
        v = z*b1 - b2 + c(:, 1)
        dv = z*s1 - s2 + b1
    end subroutine series

    !> The coordinates of the extrema of s, ascending, by bisection of its slope.
    pure function turns(self, control) result(list)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), allocatable :: list(:)
        real(wp) :: x, x_before, s, slope, slope_before
        integer :: panel, probe

        allocate (list(0))
        x_before = 0.0_wp
        slope_before = 0.0_wp
        do panel = 1, size(self%from_root)
            ! denser towards the ends of a panel: extrema lie close to touch where the range is long
            do probe = 1, probes
                x = self%edges(panel) + (self%edges(panel + 1) - self%edges(panel))*sin(half_pi*(probe - 0.5_wp)/probes)**2
                call self%control_at(control, x, s, slope)
                if (slope*slope_before < 0.0_wp) list = [list, turn_between(self, control, x_before, x)]
                x_before = x
                slope_before = slope
            end do
        end do
    end function turns

    pure function turn_between(self, control, from, to) result(x)
        type(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: from, to
        real(wp) :: x
        real(wp) :: low, high, s, slope, first
        integer :: i

        low = from
        high = to
        call self%control_at(control, low, s, first)
        do i = 1, 60
            x = 0.5_wp*(low + high)
            call self%control_at(control, x, s, slope)
            if ((slope < 0.0_wp) .eqv. (first < 0.0_wp)) then
                low = x
            else
                high = x
            end if
        end do
    end function turn_between

    !> The equilibrium between two coordinates at which s, which grows from the first to the last, lies u from its value at one of
    !> them: Newton's method on the root of the distance, in which extrema are smooth, held in a bracket.
    pure function find(self, control, origin, side, root, u, first, last) result(point)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: origin, side
        !> as if true: extremum or not
        logical, intent(in) :: root
        real(wp), intent(in) :: u
        real(wp), intent(in) :: first, last
        type(curve_point_t) :: point
        real(wp) :: low, high, ends(2), z, step, y, dy, v(rows), dv(rows), s
        integer :: panel, last_panel, middle, i
        logical :: is_last

        associate (unused => root)
        end associate
        if (u <= 0.0_wp) then
            point = self%at(merge(first, last, side > 0.0_wp))
            return
        end if
        panel = interval_of(self%edges, first)
        last_panel = interval_of(self%edges, last)
        if (last_panel > panel .and. last <= self%edges(last_panel)) last_panel = last_panel - 1
        do while (last_panel > panel)
            middle = (panel + last_panel + 1)/2
            call series(self%coefficients(:, :, middle), -1.0_wp, v, dv)
            if (side*(control%of(v(of_depth), v(of_force)) - origin) < u .eqv. side > 0.0_wp) then
                panel = middle
            else
                last_panel = middle - 1
            end if
        end do
        low = -1.0_wp
        high = 1.0_wp
        if (first > self%edges(panel)) low = local(self, panel, first)
        if (last < self%edges(panel + 1)) high = local(self, panel, last)
        ends = [low - overlap, high + overlap]
        z = 0.5_wp*(low + high)
        do i = 1, most_steps
            call series(self%coefficients(:, :, panel), z, v, dv)
            s = max(side*(control%of(v(of_depth), v(of_force)) - origin), 0.0_wp)
            y = sqrt(s) - sqrt(u)
            dy = 0.0_wp
            if (s > 0.0_wp) dy = side*control%of(dv(of_depth), dv(of_force))/(2.0_wp*sqrt(s))
            if (y < 0.0_wp .eqv. side > 0.0_wp) then
                low = z
            else
                high = z
            end if
            step = 0.5_wp*(low + high) - z
            is_last = abs(step) <= epsilon(z)
            if (abs(y) < 4.0_wp*abs(dy)) then
                is_last = is_last .or. abs(y) <= last_step*abs(dy)
                if (is_last .or. (z - y/dy > low .and. z - y/dy < high)) step = -y/dy
            end if
            step = min(max(z + step, ends(1)), ends(2)) - z
            z = z + step
            if (is_last) exit
        end do
        point = point_of(self, place(self, panel, z), v + dv*step)
    end function find

    !> The panel's variable, -1 at its left and 1 at its right edge, and its inverse.
    pure function local(self, panel, x) result(z)
        type(zone_curve_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: z

        z = (x - self%edges(panel))/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) z = sqrt(max(z, 0.0_wp))
        z = 2.0_wp*z - 1.0_wp
    end function local

    pure function place(self, panel, z) result(x)
        type(zone_curve_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        real(wp) :: x
        real(wp) :: t

        t = min(max(0.5_wp*(1.0_wp + z), 0.0_wp), 1.0_wp)
        if (self%from_root(panel)) t = t**2
        x = self%edges(panel) + (self%edges(panel + 1) - self%edges(panel))*t
    end function place

    !> int F dd from one coordinate to another, both clipped to the sampled range.
    function work_between(self, from, to) result(work)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: from, to
        real(wp) :: work
        real(wp) :: low, high, v(rows), dv(rows), place(work_nodes), weight(work_nodes), t(2)
        type(error_t), allocatable :: never
        integer :: panel, i

        work = 0.0_wp
        call gauss_legendre(place, weight, never)
        do panel = 1, size(self%from_root)
            low = min(max(min(from, to), self%edges(panel)), self%edges(panel + 1))
            high = min(max(max(from, to), self%edges(panel)), self%edges(panel + 1))
            if (.not. high > low) cycle
            t = ([low, high] - self%edges(panel))/(self%edges(panel + 1) - self%edges(panel))
            if (self%from_root(panel)) t = sqrt(max(t, 0.0_wp))
            t = 2.0_wp*t - 1.0_wp
            do i = 1, work_nodes
                call series(self%coefficients(:, :, panel), t(1) + (t(2) - t(1))*place(i), v, dv)
                work = work + (t(2) - t(1))*weight(i)*v(of_force)*dv(of_depth)
            end do
        end do
        if (to < from) work = -work
    end function work_between

end module mdrcontact_contact_zone_curve
