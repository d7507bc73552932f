! SPDX-License-Identifier: GPL-3.0-or-later
!> Media described by an effective modulus E_eff(a) (theory/paper.md (3.1), (4.1)-(4.4); Popov 2014, equations (9), (10),
!> (21)-(27)).
!>
!> The rule: contact radius from the shape, stiffness from the radius, force by integrating the stiffness from first contact. Next
!> to a flat end g' is infinite; it is taken at distances from there: the rounding of s would be seen far beyond that of a.
module mdrcontact_medium_effective
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_error, only: error_t
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_slip, only: slip_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: solved_t, solver_t
    use mdrcontact_medium_superposed_slip, only: new_superposed_slip, superposed_slip_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_quadrature, only: graded_rule, smallest_panel_ratio
    implicit none (type, external)
    private
    public :: effective_medium_t, effective_load_t

    !> A medium with an effective contact modulus. Extensions provide E_eff(a) and its slope as elemental functions.
    type, abstract, extends(solver_t) :: effective_medium_t
    contains
        !> E_eff(a) [modulus], a > 0
        procedure(modulus_function), deferred :: effective_modulus
        !> dE_eff/da [modulus/length], a > 0
        procedure(modulus_function), deferred :: effective_modulus_slope
        procedure :: modulus
        procedure :: solve
        !> d [length] and F [modulus length^2] of the non-adhesive contact
        procedure :: depth_and_force
        procedure :: find_series
        procedure :: load => new_load
        procedure :: slip
        !> part of the upper body in a small change of depth at radius a [1]
        procedure :: upper_share
        !> part of the upper body in the depth of the non-adhesive contact [length]
        procedure :: upper_depth
        procedure, non_overridable :: all_breaks
    end type effective_medium_t

    !> q' = -E_eff(x) g'(x), equation (21); an adhesive edge adds the constant E_eff(a) punch_depth.
    type, extends(load_t) :: effective_load_t
        class(effective_medium_t), pointer :: medium => null()
    contains
        procedure :: begin
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
        procedure :: energies
        procedure :: slope
        procedure :: add_breaks => add_load_breaks
    end type effective_load_t

    !> Parts of the force that are left out where they vary, relative.
    real(wp), parameter :: negligible = 1.0e-3_wp*epsilon(1.0_wp)
    real(wp), parameter :: largest_part = 4.0_wp**(-8)

    abstract interface
        elemental function modulus_function(self, a) result(value)
            import :: effective_medium_t, wp
            class(effective_medium_t), intent(in) :: self
            real(wp), intent(in) :: a
            real(wp) :: value
        end function modulus_function
    end interface

contains

    subroutine modulus(self, a, values, error, slopes)
        class(effective_medium_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: slopes(:)
        integer :: i

        ! in one statement gfortran would copy, for `values` might be `a`
        do i = 1, size(a)
            values(i) = self%effective_modulus(a(i))
        end do
        if (.not. present(slopes)) return
        do i = 1, size(a)
            slopes(i) = self%effective_modulus_slope(a(i))
        end do
    end subroutine modulus

    !> Where profile or modulus are not analytic.
    pure subroutine all_breaks(self, profile, radii, error)
        class(effective_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        !> others already in it stay
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call profile%add_breaks(radii, error)
        call self%add_breaks(radii, error)
    end subroutine all_breaks

    subroutine solve(self, profile, a, solved, error, adhesive, accuracy, series)
        class(effective_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(solved_t), intent(out) :: solved
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: accuracy
        real(wp), allocatable, intent(out), optional :: series(:, :)

        if (present(adhesive)) continue
        if (present(accuracy)) accuracy = 0.0_wp
        call self%depth_and_force(profile, a, solved%depth, solved%force, error)
        solved%modulus = self%effective_modulus(a)
        solved%stiffness_slope = 2.0_wp*(solved%modulus + a*self%effective_modulus_slope(a))
        if (present(series)) call self%find_series(profile, a, series, error)
    end subroutine solve

    !> Not known.
    subroutine find_series(self, profile, a, series, error)
        class(effective_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        !> as of solve
        real(wp), allocatable, intent(out) :: series(:, :)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => profile, unused_too => a, this_too => series, last => error)
        end associate
    end subroutine find_series

    !> d = g(a), F = int_0^a 2 s E_eff(s) g'(s) ds. Below the lowest panel E_eff is constant to machine precision.
    subroutine depth_and_force(self, profile, a, depth, force, error)
        class(effective_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(out) :: depth, force
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest

        depth = profile%mdr(a)
        force = 0.0_wp
        lowest = max(profile%end_radius, negligible_part(self, profile, a)*a)
        if (a <= lowest) return
        call self%all_breaks(profile, breaks, error)
        call graded_rule(lowest, a, breaks, profile%singular_radius, s, ds, error, beyond)
        if (allocated(error)) return
        force = 2.0_wp*(self%effective_modulus(lowest)*profile%mdr_moment(lowest) &
                        + sum(s*self%effective_modulus(s)*profile%mdr_slope_beyond(lowest, beyond)*ds))
    end subroutine depth_and_force

    !> The share of a below which the modulus may be taken as constant: what lies there is too little of the force for its
    !> variation, even by a factor of a thousand between the radii considered, to show.
    pure function negligible_part(self, profile, a) result(part)
        class(effective_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp) :: part
        real(wp) :: whole, at_axis, at_part, at_edge

        whole = profile%mdr_moment(a)
        at_axis = self%effective_modulus(smallest_panel_ratio*a)
        at_edge = self%effective_modulus(a)
        part = largest_part
        do while (part > smallest_panel_ratio)
            at_part = self%effective_modulus(part*a)
            if (profile%mdr_moment(part*a)*max(at_part, at_axis) &
                <= negligible*whole*min(at_part, at_axis, at_edge)) return
            part = 0.25_wp*part
        end do
        part = smallest_panel_ratio
    end function negligible_part

    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(effective_medium_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error
        type(effective_load_t), allocatable :: own

        if (allocated(error)) continue
        allocate (own)
        call own%begin(self, profile, a, punch_depth)
        call move_alloc(own, load)
    end subroutine new_load

    !> The load of a state; medium and profile must outlive it.
    subroutine begin(self, medium, profile, a, punch_depth)
        class(effective_load_t), intent(inout) :: self
        class(effective_medium_t), intent(in), target :: medium
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth

        self%medium => medium
        self%profile => profile
        self%radius = a
        self%punch_depth = punch_depth
        self%edge = medium%effective_modulus(a)*punch_depth
        self%share_of_upper = medium%share_of_upper
        self%is_complete = .true.
    end subroutine begin

    !> q(x; a) = int_x^a E_eff(s) d'(s) ds, equation (21).
    subroutine line_load(self, r, values, error)
        class(effective_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            call medium%all_breaks(profile, breaks, error)
            do i = 1, size(r)
                values(i) = medium%effective_modulus(a)*punch_depth
                lowest = max(r(i), profile%end_radius, smallest_panel_ratio*a)
                if (a <= lowest) cycle
                call graded_rule(lowest, a, breaks, profile%singular_radius, s, ds, error, beyond)
                if (allocated(error)) return
                values(i) = values(i) + medium%effective_modulus(lowest) &
                            *(profile%mdr(lowest) - profile%mdr(min(r(i), lowest))) &
                            + sum(medium%effective_modulus(s)*profile%mdr_slope_beyond(lowest, beyond)*ds)
            end do
        end associate
    end subroutine line_load

    !> Infinite at the edge of a flat end, where g' is.
    !> p(r) = (1/pi) int_r^a E_eff(s) d'(s)/sqrt(s^2 - r^2) ds + E_eff(a) punch_depth/(pi sqrt(a^2 - r^2)), equation (6).
    subroutine pressure(self, r, values, error)
        class(effective_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest
        logical :: from_axis
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            do i = 1, size(r)
                values(i) = medium%effective_modulus(a)*edge_pressure(a, punch_depth, r(i))
                lowest = max(r(i), profile%end_radius)
                from_axis = lowest <= 0.0_wp
                if (from_axis) lowest = smallest_panel_ratio*a
                if (r(i) < a .and. profile%mdr_slope_beyond(r(i), 0.0_wp) > huge(a)) then
                    values(i) = infinity
                else if (a > lowest) then
                    ! r too: a flat end's edge just beyond it has short panels
                    breaks = [r(i), lowest]
                    call medium%all_breaks(profile, breaks, error)
                    call graded_rule(lowest, a, breaks, profile%singular_radius, s, ds, error, beyond)
                    if (allocated(error)) return
                    values(i) = values(i) + sum(medium%effective_modulus(s)*profile%mdr_slope_beyond(lowest, beyond)*ds &
                                                /(sqrt(beyond + (lowest - r(i)))*sqrt(s + r(i))))
                    if (from_axis) values(i) = values(i) + medium%effective_modulus(lowest)*near_axis(profile, lowest)
                end if
                values(i) = values(i)/pi
            end do
        end associate
    end subroutine pressure

    !> u(r) = (2/pi) int_0^a d'(s) arcsin(s/r) ds + (2/pi) punch_depth arcsin(a/r), r > a: each increment of depth moves the
    !> surface as a flat punch on a homogeneous body.
    subroutine displacement(self, r, values, error)
        class(effective_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            lowest = max(profile%end_radius, smallest_panel_ratio*a)
            call medium%all_breaks(profile, breaks, error)
            do i = 1, size(r)
                values(i) = punch_depth*asin(a/r(i))
                if (a > lowest) then
                    call graded_rule(lowest, a, breaks, min(profile%singular_radius, r(i)), s, ds, error, beyond)
                    if (allocated(error)) return
                    values(i) = values(i) + profile%mdr_moment(lowest)/r(i) &
                                + sum(profile%mdr_slope_beyond(lowest, beyond)*asin(s/r(i))*ds)
                end if
                values(i) = values(i)*(2.0_wp/pi)
            end do
        end associate
    end subroutine displacement

    !> The work of the springs: each increment of depth, shared by the bodies, under the force reached.
    subroutine energies(self, values, error)
        class(effective_load_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest, depth, force, rise, load, work, total, upper
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            call medium%depth_and_force(profile, a, depth, force, error)
            if (allocated(error)) return
            total = (force + a*medium%effective_modulus(a)*punch_depth)*punch_depth
            upper = medium%upper_share(a)*total
            lowest = max(profile%end_radius, smallest_panel_ratio*a)
            if (a > lowest) then
                rise = medium%upper_depth(profile, a, error)
                call medium%all_breaks(profile, breaks, error)
                call graded_rule(lowest, a, breaks, profile%singular_radius, s, ds, error, beyond)
                if (allocated(error)) return
                work = 0.0_wp
                do i = 1, size(s)
                    load = 2.0_wp*s(i)*medium%effective_modulus(s(i))*profile%mdr_slope_beyond(lowest, beyond(i))*ds(i)
                    work = work + (depth - profile%mdr(s(i)))*load
                    upper = upper + (rise - medium%upper_depth(profile, s(i), error))*load
                end do
                total = total + work
            end if
            values = [total - upper, upper]
        end associate
    end subroutine energies

    elemental function upper_share(self, a) result(share)
        class(effective_medium_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: share

        associate (unused => a)
        end associate
        share = self%share_of_upper
    end function upper_share

    function upper_depth(self, profile, a, error) result(depth)
        class(effective_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: depth

        if (allocated(error)) continue
        depth = self%upper_share(a)*profile%mdr(a)
    end function upper_depth

    !> int_0^x d'(s)/s ds where d' is a power of s: infinite pressure at the apex of a cone and of anything sharper.
    pure function near_axis(profile, x) result(integral)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: x
        real(wp) :: integral
        real(wp) :: exponent

        integral = 0.0_wp
        if (profile%mdr_slope(x) <= 0.0_wp) return
        exponent = log(profile%mdr_slope(x)/profile%mdr_slope(0.5_wp*x))/log(2.0_wp)
        if (exponent > 1.0e-6_wp) then
            integral = profile%mdr_slope(x)/exponent
        else
            integral = infinity
        end if
    end function near_axis

    !> punch_depth/sqrt(a^2 - r^2), pi times the pressure under a flat punch of unit modulus; infinite at the edge.
    pure function edge_pressure(a, punch_depth, r) result(values)
        real(wp), intent(in) :: a, punch_depth, r
        real(wp) :: values

        if (punch_depth == 0.0_wp) then
            values = 0.0_wp
        else if (r < a) then
            values = punch_depth/sqrt((a - r)*(a + r))
        else
            values = sign(infinity, punch_depth)
        end if
    end function edge_pressure

    subroutine slip(self, tangential, load, found, error)
        class(effective_medium_t), intent(in) :: self
        class(solver_t), intent(in) :: tangential
        class(load_t), intent(in) :: load
        class(slip_t), allocatable, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(superposed_slip_t), allocatable :: own

        allocate (own)
        call new_superposed_slip(own, self, tangential, load%profile, load%radius, load%punch_depth, error)
        if (.not. allocated(error)) call move_alloc(own, found)
    end subroutine slip

    pure subroutine add_load_breaks(self, radii, error)
        class(effective_load_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%medium%all_breaks(self%profile, radii, error)
    end subroutine add_load_breaks

    pure function slope(self, start, distance) result(y)
        class(effective_load_t), intent(in) :: self
        real(wp), intent(in) :: start, distance(:)
        real(wp) :: y(size(distance))

        y = -self%medium%effective_modulus(start + distance)*self%profile%mdr_slope_beyond(start, distance)
    end function slope

end module mdrcontact_medium_effective
