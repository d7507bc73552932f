! SPDX-License-Identifier: GPL-3.0-or-later
!> Where fretting ends: a disc of radius c sticks permanently, all outside slips and wears until it carries nothing: theory/wear.md
!> (7.1)-(7.3).
!>
!> Inside c the profile is unworn, and the load that of the unworn disc of radius c pressed on as a flat punch,
!>
!>     F = F_0(c) + k(c) (d - d_0(c)),      f(r) = d - u(r), c < r < b,   f_0(b) = d - u(b),
!>
!> and the worn profile f is the free surface. Exact on layered bodies too, for a given stick radius; what stick radius a
!> prescribed shift leads to is known on homogeneous bodies only (that of the first cycle: Popov, Sci. Rep. 4 (2014) 3749).
module mdrcontact_wear_limit
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: check_state, contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_error, only: check_code, check_positive, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_profile_free_surface, only: free_surface_t, new_free_surface, panel_points, panel_radii, series_of
    use mdrcontact_profile_worn, only: new_worn_profile, worn_profile_t
    implicit none (type, external)
    private
    public :: check_carries, check_control, find_limit, wear_limit_t

    !> Nodes of the rule for the worn volume, radii of the worn profile, and radii at which the pressure is considered.
    integer, parameter :: nodes = 48, profile_points = 120, probes = 48
    !> Pressures below minus this part of the mean one are no rounding errors.
    real(wp), parameter :: noticeable = 1.0e-6_wp
    !> The free surface: last terms of a series that need no shorter panels, relative to the depth, panels that are short enough in
    !> any case, relative to where they end and to the radius of the disc that sticks, and how often panels are cut at most.
    real(wp), parameter :: last_terms = 1.0e-12_wp, short = 0.02_wp, shortest = 1.0e-6_wp
    integer, parameter :: most_cuts = 60
    !> Number of times that the search for the edge of the scar is widened.
    integer, parameter :: most_doublings = 60

    !> The state at the end, and the scar.
    type :: wear_limit_t
        !> radius: that of stick; force: what is left of it, or what is held
        type(contact_state_t) :: state
        !> b, up to where the indenter is worn [length]
        real(wp) :: outer_radius = 0.0_wp
        !> of indenter and body together [length^3]
        real(wp) :: worn_volume = 0.0_wp
    end type wear_limit_t

    !> Distance of the unworn surface below the limit: positive where it is worn, divided by the distance from the axis.
    type, extends(scalar_function_t) :: gap_t
        type(contact_load_t) :: load
    contains
        procedure :: value => worn_at
    end type gap_t

contains

    !> The limit of a state.
    subroutine find_limit(contact, state, stick_radius, control, limit, error, profile)
        !> without adhesion
        type(contact_t), intent(in), target :: contact
        !> of the unworn contact
        type(contact_state_t), intent(in) :: state
        !> c, 0 < c <= a: of the disc that sticks as long as wear continues [length]
        real(wp), intent(in) :: stick_radius
        !> given_depth or given_force
        integer, intent(in) :: control
        type(wear_limit_t), intent(out) :: limit
        type(error_t), allocatable, intent(out) :: error
        !> the worn indenter: wear of both bodies, as if it were that of the indenter
        type(worn_profile_t), allocatable, intent(out), optional :: profile
        type(gap_t), target :: gap

        call check_input(contact, state, stick_radius, control, error)
        if (.not. allocated(error)) call contact%at_radius(stick_radius, limit%state, error)
        if (allocated(error)) return
        call press_on(limit%state, state, control)
        call contact%load(limit%state, gap%load, error)
        if (.not. allocated(error)) call check_carries(gap%load, error)
        if (allocated(error)) return
        call find_rim(gap, state%radius, limit%outer_radius, error)
        if (.not. allocated(error)) call find_volume(gap, limit, error)
        if (.not. allocated(error) .and. present(profile)) call make_profile(gap, limit, profile, error)
    end subroutine find_limit

    !> Raises unless what is held or led is the depth or the force.
    pure subroutine check_control(error, control)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: control

        call check_code(error, "control", control, [given_depth, given_force])
    end subroutine check_control

    !> Raises unless a limit exists for these arguments.
    subroutine check_input(contact, state, stick_radius, control, error)
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: stick_radius
        integer, intent(in) :: control
        type(error_t), allocatable, intent(out) :: error

        call check_control(error, control)
        call check_positive(error, "stick_radius", stick_radius)
        if (.not. allocated(error) .and. contact%is_adhesive()) then
            call raise(error, error_invalid, "wear: it is not available with adhesion, because Archard's law is not defined "// &
                "under tension. Set work_of_adhesion = 0")
        end if
        if (.not. allocated(error)) call check_state(contact%equilibrium, state, error)
        if (allocated(error)) return
        if (stick_radius > state%radius) then
            call raise(error, error_domain, "stick_radius = "//to_text(stick_radius)//": it must be at most the contact "// &
                       "radius, "//to_text(state%radius))
        end if
    end subroutine check_input

    !> The state at the stick radius, pressed on as a flat punch to the depth or force of another one.
    pure subroutine press_on(state, unworn, control)
        type(contact_state_t), intent(inout) :: state
        type(contact_state_t), intent(in) :: unworn
        integer, intent(in) :: control
        real(wp) :: further

        further = unworn%depth - state%depth
        if (control == given_force) further = (unworn%force - state%force)/state%stiffness
        state%force = state%force + state%stiffness*further
        state%depth = state%depth + further
        state%punch_depth = state%punch_depth + further
    end subroutine press_on

    !> Raises where a state would have to pull.
    subroutine check_carries(load, error)
        type(contact_load_t), intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: r(probes), pressure(probes)
        integer :: i, lowest

        r = load%state%radius*[(sin(half_pi*(real(i, wp) - 0.5_wp)/real(probes, wp)), i=1, probes)]
        call load%pressure(r, pressure, error)
        if (allocated(error)) return
        lowest = minloc(pressure, dim=1)
        if (pressure(lowest) >= -noticeable*load%state%force/(pi*load%state%radius**2)) return
        call raise(error, error_domain, "this contact is not a single area: without adhesion its pressure would be "// &
                   to_text(pressure(lowest))//" at r = "//to_text(r(lowest))//" (contact radius "//to_text(load%state%radius)// &
                   "). Wear needs a pressure that is nowhere negative")
    end subroutine check_carries

    !> W(r)/r outside the disc that sticks.
    function worn_at(self, x) result(y)
        class(gap_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: depth(1)

        y = 0.0_wp
        if (x <= self%load%state%radius) return
        call depths_at(self, [x], depth, self%error)
        y = depth(1)/x
    end function worn_at

    !> W = d - u - f_0.
    subroutine depths_at(gap, r, depths, error)
        class(gap_t), intent(in) :: gap
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: heights(size(r))

        depths = 0.0_wp
        call heights_at(gap, r, heights, error)
        if (.not. allocated(error)) depths = heights - gap%load%equilibrium%profile%height(r)
    end subroutine depths_at

    !> d - u, the height of the surface above the apex.
    subroutine heights_at(gap, r, heights, error)
        class(gap_t), intent(in) :: gap
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: heights(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: displacement(size(r))

        heights = 0.0_wp
        call gap%load%displacement(r, displacement, error)
        if (.not. allocated(error)) heights = gap%load%state%depth - displacement
    end subroutine heights_at

    !> b, where the limit meets the unworn profile: beyond the radius of the unworn contact, and there alone W changes its sign.
    subroutine find_rim(gap, radius, rim, error)
        type(gap_t), intent(inout), target :: gap
        !> of the unworn contact [length]
        real(wp), intent(in) :: radius
        real(wp), intent(out) :: rim
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: from, to, last, worn
        integer :: i

        rim = radius
        if (.not. gap%load%state%radius < radius) return
        last = gap%load%equilibrium%profile%largest_radius
        from = radius
        to = radius
        worn = gap%value(to)
        do i = 1, most_doublings
            if (worn <= 0.0_wp .or. allocated(gap%error)) exit
            if (to >= last) then
                call raise(error, error_domain, "the indenter ends at radius "//to_text(last)// &
                           ", inside the worn area. Give a larger profile")
                return
            end if
            from = to
            to = min(1.5_wp*to, last)
            worn = gap%value(to)
        end do
        if (allocated(gap%error)) then
            error = gap%error
        else if (to > radius) then
            call find_root(gap, from, to, rim, error)
        end if
    end subroutine find_rim

    !> int W 2 pi r dr; W rises as the root of the distance from the disc that sticks, and has kinks where the indenter has.
    subroutine find_volume(gap, limit, error)
        type(gap_t), intent(in) :: gap
        type(wear_limit_t), intent(inout) :: limit
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: edges(:)
        real(wp) :: t(nodes), weights(nodes), r(nodes), depths(nodes), width
        integer :: i

        if (.not. limit%outer_radius > limit%state%radius) return
        call gauss_legendre(t, weights, error)
        if (.not. allocated(error)) call gap%load%equilibrium%profile%add_breaks(edges, error)
        if (allocated(error)) return
        edges = [limit%state%radius, pack(edges, edges > limit%state%radius .and. edges < limit%outer_radius), limit%outer_radius]
        limit%worn_volume = 0.0_wp
        do i = 1, size(edges) - 1
            width = edges(i + 1) - edges(i)
            r = edges(i) + width*t**2
            call depths_at(gap, r, depths, error)
            if (allocated(error)) return
            limit%worn_volume = limit%worn_volume + 4.0_wp*pi*width*sum(weights*t*r*depths)
        end do
    end subroutine find_volume

    !> The worn indenter: its height as it is, and for g parabolas through W at radii that are dense where it rises steeply; slopes
    !> in the root of the distance by differences of fourth order.
    subroutine make_profile(gap, limit, profile, error)
        type(gap_t), intent(in) :: gap
        type(wear_limit_t), intent(in) :: limit
        type(worn_profile_t), allocatable, intent(out) :: profile
        type(error_t), allocatable, intent(inout) :: error
        type(free_surface_t) :: surface
        real(wp), dimension(0:profile_points) :: t, r, depths, slopes
        real(wp) :: width
        integer :: i

        allocate (profile)
        width = limit%outer_radius - limit%state%radius
        if (.not. width > 0.0_wp) then
            call new_worn_profile(profile, gap%load%equilibrium%profile, limit%outer_radius*[0.5_wp, 1.0_wp], &
                                  [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], error)
            return
        end if
        t = [(real(i, wp)/real(profile_points, wp), i=0, profile_points)]
        r = limit%state%radius + width*t**2
        call depths_at(gap, r, depths, error)
        if (.not. allocated(error)) call find_surface(gap, limit, surface, error)
        call check_cancelled(error)
        if (allocated(error)) return
        depths(0) = 0.0_wp
        depths(profile_points) = 0.0_wp
        call differentiate(depths, slopes)
        slopes(1:) = slopes(1:)*real(profile_points, wp)/(2.0_wp*width*t(1:))
        slopes(0) = infinity
        call new_worn_profile(profile, gap%load%equilibrium%profile, r, depths, slopes, error, surface)
    end subroutine make_profile

    !> The free surface from the disc that sticks to the edge of the scar, panels cut until their series end. Short ones are needed
    !> where something singular is near, as the axis, or a radius within the disc at which the indenter has a kink.
    subroutine find_surface(gap, limit, surface, error)
        type(gap_t), intent(in) :: gap
        type(wear_limit_t), intent(in) :: limit
        type(free_surface_t), intent(out) :: surface
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ends(:), series(:, :)
        real(wp) :: heights(panel_points), found(panel_points), middle, small
        integer :: i, cuts

        associate (c => limit%state%radius, b => limit%outer_radius)
            ends = [0.0_wp, sqrt((b - c)*(b + c))]
            allocate (series(panel_points, 0))
            i = 1
            cuts = 0
            do while (i < size(ends) .and. .not. allocated(error))
                call heights_at(gap, panel_radii(c, ends(i), ends(i + 1)), heights, error)
                call check_cancelled(error)
                found = series_of(heights)
                ! near the disc the rounding of radii is one of s, and so of heights
                small = last_terms
                if (i > 1) small = max(small, 4.0_wp*epsilon(small)*c/ends(i))
                if (maxval(abs(found(panel_points - 2:))) <= small*gap%load%state%depth .or. cuts >= most_cuts &
                    .or. ends(i + 1) - ends(i) <= max(short*ends(i + 1), shortest*c)) then
                    series = reshape([series, found], [panel_points, i])
                    i = i + 1
                else
                    cuts = cuts + 1
                    ! next to the disc the distance from what is singular there counts
                    middle = 0.5_wp*(ends(i) + ends(i + 1))
                    if (i == 1) middle = 0.25_wp*ends(2)
                    ends = [ends(:i), middle, ends(i + 1:)]
                end if
            end do
            if (.not. allocated(error)) call new_free_surface(surface, c, b, ends, series, error)
        end associate
    end subroutine find_surface

    !> Slopes per step of values at equal steps.
    pure subroutine differentiate(values, slopes)
        real(wp), intent(in) :: values(0:)
        real(wp), intent(out) :: slopes(0:)
        integer :: i, n

        n = ubound(values, 1)
        slopes(0) = (-25.0_wp*values(0) + 48.0_wp*values(1) - 36.0_wp*values(2) + 16.0_wp*values(3) - 3.0_wp*values(4))/12.0_wp
        slopes(1) = (-3.0_wp*values(0) - 10.0_wp*values(1) + 18.0_wp*values(2) - 6.0_wp*values(3) + values(4))/12.0_wp
        do i = 2, n - 2
            slopes(i) = (values(i - 2) - 8.0_wp*values(i - 1) + 8.0_wp*values(i + 1) - values(i + 2))/12.0_wp
        end do
        slopes(n - 1) = (3.0_wp*values(n) + 10.0_wp*values(n - 1) - 18.0_wp*values(n - 2) + 6.0_wp*values(n - 3) &
                         - values(n - 4))/12.0_wp
        slopes(n) = (25.0_wp*values(n) - 48.0_wp*values(n - 1) + 36.0_wp*values(n - 2) - 16.0_wp*values(n - 3) &
                     + 3.0_wp*values(n - 4))/12.0_wp
    end subroutine differentiate

end module mdrcontact_wear_limit
