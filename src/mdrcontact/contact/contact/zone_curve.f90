! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact with a cohesive zone, sampled once along their curve: from the first attraction at a distance
!> (x = -1; theory/adhesion.md (2.10)), c growing to touch (x = 0), then a growing as c_0 sinh x, c_0 the zone's radius at touch.
!> The samples show where
!> depth and force turn, begins the search for a state, and does the work of loops; states themselves are solved.
module mdrcontact_contact_zone_curve
    use mdrcontact_cancel, only: report_progress
    use mdrcontact_contact_cohesion, only: zone_guess_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_samples, only: curve_point_t, rows, samples_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_lagrange, only: lagrange
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_sampled_columns, only: new_columns
    use mdrcontact_numerics_sampler, only: column_source_t, sampling_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: zone_curve_t, new_zone_curve, zone_state, coordinate_of, sample_tolerance

    integer, parameter :: columns = 8, of_depth = 1, of_force = 2, of_stiffness = 3, of_length = 4, of_slope = 5, &
                          of_depth_rate = 6, of_force_rate = 7, of_unknowns = 8
    !> Panels are this long at first, and none is halved below the second, or the third where a tolerance is given: a short zone
    !> changes fast as it passes a kink of the indenter.
    real(wp), parameter :: usual_length = 1.0_wp, shortest_length = 1.0e-4_wp, shortest_of_all = 1.0e-7_wp
    !> Relative, of the samples, where no other tolerance is given, and the noise of the states.
    real(wp), parameter :: sample_tolerance = 1.0e-9_wp, largest_noise = 1.0e-8_wp
    !> Where the body's constants vary with depth, as E(z) = E(0) + E'(0) z + ..., depths and forces have terms c^2 ln c from the
    !> first attraction on and a^2 ln a from touch on: panels shrink towards both, and are longer elsewhere.
    real(wp), parameter :: graded_length = 1.5_wp, from_attraction(*) = [1.0_wp/64, 1.0_wp/16, 1.0_wp/4], &
                           from_touch(*) = [1.0_wp/16, 1.0_wp/4, 1.0_wp]
    !> These edges keep so far from others.
    real(wp), parameter :: near_break = 1.0e-2_wp
    !> A break closer to an edge than this is there.
    real(wp), parameter :: no_room = 1.0e-9_wp

    !> The next zone is extrapolated from so many of the last ones, unless it is farther from the nearest than this in ln(c - a) or
    !> in the slope of ln h.
    integer, parameter :: most_before = 6, most_kept = 48
    real(wp), parameter :: farthest = 1.0_wp, slope_change = 0.2_wp

    !> Chebyshev series of d, F, k, ln(c - a), the slopes of ln h, d and F over ln(c - a), and the unknowns of the springs, on
    !> panels of x.
    type, extends(samples_t) :: zone_curve_t
        !> c_0 [length]
        real(wp), private :: touching_zone = 0.0_wp
    contains
        procedure :: point_of
        procedure :: control_of
        procedure :: state_at
        procedure :: guess_at
        procedure :: segments
        procedure :: breaks
    end type zone_curve_t

    !> The columns of the states.
    type, extends(column_source_t) :: zone_source_t
        type(equilibrium_t), pointer :: equilibrium => null()
        !> the zone of the last state
        type(zone_guess_t) :: guess
        !> of the curve, and how much of it is behind the samples
        real(wp) :: last = 0.0_wp, part = 0.0_wp
        !> where the body's constants vary with depth, the last states with contact in turn: how many, x, and columns of the zone
        logical :: is_graded = .false.
        integer :: count = 0
        real(wp) :: places(most_kept) = 0.0_wp, zones(of_length:of_unknowns, most_kept) = 0.0_wp
    contains
        procedure :: sample
        procedure :: radius
    end type zone_source_t

    !> Length of the zone beyond a radius, as a function of the coordinate.
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
        type(equilibrium_t), intent(in), target :: equilibrium
        real(wp), intent(in) :: last
        type(error_t), allocatable, intent(inout) :: error
        !> relative, of depth, force and stiffness
        real(wp), intent(in), optional :: tolerance
        real(wp), allocatable :: edges(:), breaks(:)
        type(sampling_t) :: sampling
        type(zone_source_t) :: source

        sampling = sampling_t(sample_tolerance, largest_noise, usual_length, shortest_length)
        if (present(tolerance)) then
            sampling%tolerance = tolerance
            sampling%shortest_length = shortest_of_all
        end if
        source%is_graded = equilibrium%cohesion%kernel%is_graded()
        if (source%is_graded) then
            sampling%usual_length = graded_length
            source%guess%tolerance = sampling%tolerance
        end if
        self%touching_zone = equilibrium%cohesion%touching_zone
        call first_edges(equilibrium, last, source%is_graded, edges, breaks, error)
        if (allocated(error)) return
        source%columns = columns
        ! what the zone is like is a guess only
        source%counted = of_stiffness
        ! without contact the stiffness is another
        source%continuous = of_force
        source%is_relative = .true.
        source%equilibrium => equilibrium
        source%last = last
        source%guess%length = equilibrium%cohesion%likely_zone
        if (source%is_graded) breaks = [breaks, -1.0_wp, 0.0_wp]
        call new_columns(self, source, edges, breaks, sampling, error)
        if (.not. allocated(error)) call self%prepare(error)
        if (.not. allocated(error)) call report_progress(1.0_wp)
    end subroutine new_zone_curve

    !> The columns at a coordinate.
    subroutine sample(self, x, values, error, slopes)
        class(zone_source_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(out), optional :: slopes(:)
        type(contact_state_t) :: state

        if (present(slopes)) slopes = 0.0_wp
        values = 0.0_wp
        if (self%is_graded .and. x > 0.0_wp .and. self%count > 0) call extrapolate(self, x)
        call zone_state(self%equilibrium, x, state, error, self%guess)
        if (allocated(error)) return
        self%solutions = self%solutions + 1
        self%part = max(self%part, (x + 1.0_wp)/(self%last + 1.0_wp))
        call report_progress(self%part)
        values = [state%depth, state%force, state%stiffness, log(max(self%guess%length, tiny(1.0_wp))), self%guess%slope, &
                  self%guess%depth_rate, self%guess%force_rate, self%guess%unknowns]
        if (.not. (self%is_graded .and. x > 0.0_wp)) return
        self%count = self%count + 1
        associate (kept => modulo(self%count - 1, most_kept) + 1)
            self%places(kept) = x
            self%zones(:, kept) = values(of_length:of_unknowns)
        end associate
    end subroutine sample

    !> The zone at x from the nearest of the last states: its length by the polynomial through more of them than its slopes, which
    !> are measured to fewer digits.
    pure subroutine extrapolate(self, x)
        class(zone_source_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: v(of_length:of_unknowns), distance(most_kept), tolerance
        integer :: nearest(most_before), i, n

        n = min(self%count, most_before)
        distance = abs(self%places - x)
        distance(self%count + 1:) = huge(x)
        do i = 1, n
            nearest(i) = minloc(distance, dim=1)
            distance(nearest(i)) = huge(x)
        end do
        v = self%zones(:, nearest(1))
        if (n == most_before) v(of_length:of_length) = matmul(lagrange(self%places(nearest), [x]), self%zones(of_length, nearest))
        if (n >= 3) then
            v(of_slope:of_force_rate) = matmul(self%zones(of_slope:of_force_rate, nearest(:3)), &
                                               pack(lagrange(self%places(nearest(:3)), [x]), .true.))
        end if
        ! far from them
        if (.not. (abs(v(of_length) - self%zones(of_length, nearest(1))) <= farthest .and. &
                   abs(v(of_slope) - self%zones(of_slope, nearest(1))) <= slope_change)) v = self%zones(:, nearest(1))
        tolerance = self%guess%tolerance
        self%guess = guess_of(v)
        self%guess%tolerance = tolerance
        self%guess%is_close = .false.
    end subroutine extrapolate

    !> The zone of which a state has these columns.
    pure function guess_of(v) result(guess)
        real(wp), intent(in) :: v(of_length:)
        type(zone_guess_t) :: guess

        guess = zone_guess_t(exp(v(of_length)), v(of_slope), v(of_depth_rate), v(of_force_rate), is_close=.true., &
                             unknowns=v(of_unknowns))
    end function guess_of

    pure function radius(self, x)
        class(zone_source_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: radius

        radius = self%equilibrium%cohesion%touching_zone*sinh(max(x, 0.0_wp))
    end function radius

    !> Edges that no panel crosses, and the breaks among them: where the contact ends at a break of the indenter, and where the
    !> zone does.
    subroutine first_edges(equilibrium, last, is_graded, edges, breaks, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: last
        logical, intent(in) :: is_graded
        real(wp), allocatable, intent(out) :: edges(:), breaks(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: radii(:), more(:)
        real(wp) :: x
        integer :: i

        edges = [-1.0_wp]
        allocate (breaks(0))
        call equilibrium%profile%add_breaks(radii, error)
        if (allocated(error)) return
        do i = 1, size(radii)
            call zone_ends_at(equilibrium, radii(i), last, x, error)
            if (allocated(error)) return
            breaks = [breaks, x, coordinate_of(equilibrium, radii(i), 0.0_wp)]
        end do
        breaks = pack(breaks, breaks < last - shortest_length .and. breaks > -1.0_wp)
        allocate (more(0))
        if (is_graded) more = [-1.0_wp + from_attraction, from_touch]
        more = pack(more, [(more(i) < last - near_break .and. .not. any(abs(breaks - more(i)) < near_break), i=1, size(more))])
        do while (edges(size(edges)) < last)
            x = edges(size(edges)) + no_room
            edges = [edges, min(last, minval(breaks, mask=breaks > x), minval(more, mask=more > x), &
                                merge(0.0_wp, last, x < 0.0_wp))]
        end do
    end subroutine first_edges

    !> The coordinate at which the zone ends at a radius, `last` if it does not exist before.
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

    !> About what the zone is at a coordinate.
    pure function guess_at(self, x) result(guess)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        type(zone_guess_t) :: guess
        real(wp) :: v(columns), dv(columns)

        call self%values_at(min(max(x, 0.0_wp), self%edges(size(self%edges))), v, dv)
        guess = guess_of(v(of_length:))
    end function guess_at

    pure function point_of(self, x, v) result(point)
        class(zone_curve_t), intent(in) :: self
        real(wp), intent(in) :: x, v(rows)
        type(curve_point_t) :: point

        point%x = x
        point%depth = v(of_depth)
        point%force = v(of_force)
        if (.not. x > 0.0_wp) return
        point%radius = self%touching_zone*sinh(x)
        point%stiffness = v(of_stiffness)
    end function point_of

    pure subroutine control_of(self, control, v, dv, s, ds)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: v(rows), dv(rows)
        real(wp), intent(out) :: s, ds

        associate (unused => self)
        end associate
        s = control%of(v(of_depth), v(of_force))
        ds = control%of(dv(of_depth), dv(of_force))
    end subroutine control_of

    !> The state of the contact itself at a coordinate.
    subroutine state_at(self, equilibrium, x, state, error)
        class(zone_curve_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(zone_guess_t) :: guess

        guess = self%guess_at(x)
        ! the last significant digits are the contact's own
        guess%is_close = .false.
        call zone_state(equilibrium, x, state, error, guess)
    end subroutine state_at

    !> The segments on which s grows, ascending.
    subroutine segments(self, control, list, error)
        class(zone_curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: x(:), s(:)
        real(wp) :: unused
        integer :: i

        call self%extrema(control, x, error)
        allocate (s(size(x)))
        do i = 1, size(x)
            call self%control_at(control, x(i), s(i), unused)
        end do
        list = [(stable_segment_t(x(i), x(i + 1), s(i), s(i + 1)), i=1, size(x) - 1)]
        list = pack(list, list%highest > list%lowest)
    end subroutine segments

    !> The coordinates at which the curve is not analytic: touch and the breaks of the indenter, ascending.
    pure function breaks(self) result(x)
        class(zone_curve_t), intent(in) :: self
        real(wp), allocatable :: x(:)

        associate (edges => self%edges(:size(self%from_root)))
            x = [0.0_wp, pack(edges, self%from_root .and. edges > edges(1) .and. abs(edges) > 0.0_wp)]
        end associate
    end function breaks

end module mdrcontact_contact_zone_curve
