! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact with a cohesive zone, sampled once along their curve: from the first attraction at a distance
!> (x = -1), c growing to touch (x = 0), then a growing as c_0 sinh x, c_0 the zone's radius at touch. What is sampled says where
!> depth and force turn, begins the search for a state, and does the work of loops; states themselves are solved.
module mdrcontact_contact_zone_curve
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact_cohesion, only: zone_guess_t
    use mdrcontact_contact_control, only: control_t, depth_control
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_numerics_chebyshev, only: node, nodes => terms, series_of_values
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: zone_curve_t, new_zone_curve, zone_state, coordinate_of

    integer, parameter :: rows = 6, of_depth = 1, of_force = 2, of_length = 3, of_slope = 4, of_depth_rate = 5, of_force_rate = 6
    integer, parameter :: most_panels = 400, probes = 48, work_nodes = 20
    !> Panels are this long at first, and none is halved below the second.
    real(wp), parameter :: usual_length = 1.0_wp, shortest_length = 1.0e-4_wp
    !> Relative, of the samples.
    real(wp), parameter :: tolerance = 1.0e-9_wp
    !> The slope behind a break is taken no closer to it than this.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

    !> Chebyshev series of d, F, ln(c - a), and the slopes of ln h, d and F over ln(c - a), on panels of x.
    type :: zone_curve_t
        real(wp), allocatable :: edges(:)
        !> whether a panel begins at a break of the indenter, and is a series in the root of the distance from it
        logical, allocatable, private :: from_root(:)
        !> (rows, nodes, panels)
        real(wp), allocatable, private :: coefficients(:, :, :)
    contains
        procedure :: guess_at
        procedure :: control_at
        procedure :: force_at
        procedure :: turns
        procedure :: find
        procedure :: work_between
    end type zone_curve_t

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
    subroutine new_zone_curve(self, equilibrium, last, error)
        type(zone_curve_t), intent(out) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: last
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:), waiting(:)
        real(wp) :: panel(rows, nodes), left, right, edges(most_panels + 1)
        type(zone_guess_t) :: guess
        real(wp), allocatable :: kept(:, :, :)
        logical :: root, roots(most_panels), fits
        integer :: count

        allocate (waiting(1), source=-1.0_wp)
        allocate (breaks(0))
        call first_edges(equilibrium, last, waiting, breaks, error)
        if (allocated(error)) return
        allocate (kept(rows, nodes, most_panels))
        count = 0
        edges(1) = waiting(size(waiting))
        guess%length = equilibrium%cohesion%likely_zone
        do while (size(waiting) > 1)
            call check_cancelled(error)
            if (allocated(error)) return
            left = waiting(size(waiting))
            right = waiting(size(waiting) - 1)
            root = any(abs(breaks - left) <= 4.0_wp*epsilon(left)*max(1.0_wp, abs(left)))
            call sample_panel(equilibrium, left, right, root, panel, fits, guess, error)
            if (allocated(error)) return
            if (.not. fits .and. right - left > shortest_length) then
                waiting = [waiting(:size(waiting) - 1), 0.5_wp*(left + right), left]
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
        end do
        self%edges = edges(:count + 1)
        self%from_root = roots(:count)
        self%coefficients = kept(:, :, :count)
    end subroutine new_zone_curve

    !> Edges of the first panels, the leftmost last, and the breaks among them.
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
        breaks = [(coordinate_of(equilibrium, radii(i), 0.0_wp), i=1, size(radii))]
        breaks = pack(breaks, breaks < last - shortest_length)
        x = -1.0_wp
        do while (x < last)
            next = min(x + usual_length, last)
            if (x < 0.0_wp) next = 0.0_wp
            i = findloc(breaks > x, .true., dim=1)
            if (i > 0) next = min(next, breaks(i))
            waiting = [next, waiting]
            x = next
        end do
    end subroutine first_edges

    !> The series of a panel, and whether their last terms are small.
    subroutine sample_panel(equilibrium, left, right, root, panel, fits, guess, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root
        real(wp), intent(out) :: panel(rows, nodes)
        logical, intent(out) :: fits
        !> the zone at the last state
        type(zone_guess_t), intent(inout) :: guess
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        real(wp) :: values(rows, nodes), t, scales(rows)
        integer :: i

        fits = .false.
        panel = 0.0_wp
        do i = nodes, 1, -1
            t = 0.5_wp*(1.0_wp + node(i, nodes))
            if (root) t = t**2
            ! without contact there is no search
            call zone_state(equilibrium, left + (right - left)*t, state, error, guess)
            if (allocated(error)) return
            values(:, i) = [state%depth, state%force, log(max(guess%length, tiny(1.0_wp))), guess%slope, &
                            guess%depth_rate, guess%force_rate]
        end do
        panel = series_of_values(values)
        scales = maxval(abs(values), dim=2)
        scales(of_depth) = scales(of_depth) + equilibrium%cohesion%range
        ! what the zone is like is a guess only
        scales(of_length:) = huge(1.0_wp)
        fits = all(sum(abs(panel(:, nodes - 1:)), dim=2) <= tolerance*scales)
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

    !> F at a coordinate.
    pure function force_at(self, x) result(force)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: force
        real(wp) :: v(rows), dv(rows)

        call evaluate(self, x, v, dv)
        force = v(of_force)
    end function force_at

    !> The rows and their slopes at a coordinate.
    pure subroutine evaluate(self, x, v, dv)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: v(rows), dv(rows)
        real(wp) :: t, z, rate
        integer :: panel

        panel = interval_of(self%edges, x)
        rate = self%edges(panel + 1) - self%edges(panel)
        t = (x - self%edges(panel))/rate
        rate = 2.0_wp/rate
        if (self%from_root(panel)) then
            t = sqrt(max(t, 0.0_wp))
            rate = 0.5_wp*rate/max(t, smallest_root)
        end if
        z = 2.0_wp*t - 1.0_wp
        call series(self%coefficients(:, :, panel), z, v, dv)
        dv = rate*dv
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

    !> The coordinate between two others at which s, which grows, has a value: by bisection.
    pure function find(self, control, value, from, to) result(x)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: value, from, to
        real(wp) :: x
        real(wp) :: low, high, s, slope
        integer :: i

        low = from
        high = to
        do i = 1, 40
            x = 0.5_wp*(low + high)
            call self%control_at(control, x, s, slope)
            if (s < value) then
                low = x
            else
                high = x
            end if
        end do
    end function find

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
