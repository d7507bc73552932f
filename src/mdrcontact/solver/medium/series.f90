! SPDX-License-Identifier: GPL-3.0-or-later
!> Two deformable bodies of which one or both are known by an effective modulus: series addition,
!>     1/E_eff(a) = 1/E_eff,1(a) + 1/E_eff,2(a).
!>
!> Exact for two homogeneous bodies, for a -> 0 and a -> infinity, and where the two moduli are proportional; else stiffer than the
!> two bodies, by up to 1 % of E_eff for exact moduli, which is far below the errors of the models themselves.
module mdrcontact_medium_series
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: room
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_material, only: in_series
    use mdrcontact_medium_load, only: load_t, lower_body
    use mdrcontact_medium_solver, only: set_pair, solver_t
    use mdrcontact_medium_effective, only: effective_load_t, effective_medium_t
    use mdrcontact_numerics_quadrature, only: graded_rule, smallest_panel_ratio
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: series_t, new_series

    !> Both bodies by their effective moduli.
    type, extends(effective_medium_t) :: series_t
        private
        class(effective_medium_t), allocatable :: lower, upper
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: add_breaks
        procedure :: bytes
        procedure :: upper_share
        procedure :: upper_depth
        procedure :: load => new_load
        procedure :: for_load
    end type series_t

    !> Its load, of which each body takes a share of its own at each radius.
    type, extends(effective_load_t) :: series_load_t
    contains
        procedure :: displacement_of_body
    end type series_load_t

contains

    !> Two bodies, neither of them a pair.
    subroutine new_series(self, lower, upper, error)
        type(series_t), intent(out) :: self
        class(effective_medium_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(inout) :: error

        call room(lower%bytes() + upper%bytes(), error)
        if (allocated(error)) return
        allocate (self%lower, source=lower)
        allocate (self%upper, source=upper)
        self%largest_radius = min(lower%largest_radius, upper%largest_radius)
        self%why_it_ends = upper%why_it_ends
        if (lower%largest_radius <= upper%largest_radius) self%why_it_ends = lower%why_it_ends
        self%smallest_radius = max(lower%smallest_radius, upper%smallest_radius)
        self%roughness = max(lower%roughness, upper%roughness)
        call set_pair(self, lower, upper, error)
        self%is_made = .not. allocated(error)
    end subroutine new_series

    !> Each of the two holds its body, which is also one of the pair's.
    pure recursive function bytes(self)
        class(series_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 2*(self%lower%bytes() + self%upper%bytes())
    end function bytes

    elemental function effective_modulus(self, a) result(value)
        class(series_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        value = in_series(self%lower%effective_modulus(a), self%upper%effective_modulus(a))
    end function effective_modulus

    !> E' = E^2 (E1'/E1^2 + E2'/E2^2).
    elemental function effective_modulus_slope(self, a) result(value)
        class(series_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: first, second, both

        first = self%lower%effective_modulus(a)
        second = self%upper%effective_modulus(a)
        both = in_series(first, second)
        value = (both/first)**2*self%lower%effective_modulus_slope(a) + (both/second)**2*self%upper%effective_modulus_slope(a)
    end function effective_modulus_slope

    pure subroutine add_breaks(self, radii, error)
        class(series_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%lower%add_breaks(radii, error)
        call self%upper%add_breaks(radii, error)
    end subroutine add_breaks

    !> E_eff/E_eff,2.
    elemental function upper_share(self, a) result(share)
        class(series_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: share

        share = self%effective_modulus(a)/self%upper%effective_modulus(a)
    end function upper_share

    !> int_0^a (share of the upper body) g'(s) ds [length].
    function upper_depth(self, profile, a, error) result(depth)
        class(series_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: depth
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest

        lowest = max(profile%end_radius, smallest_panel_ratio*a)
        depth = 0.0_wp
        if (a <= lowest) return
        call self%all_breaks(profile, breaks, error)
        call graded_rule(lowest, a, breaks, profile%singular_radius, s, ds, error, beyond)
        if (allocated(error)) return
        depth = self%upper_share(lowest)*profile%mdr(lowest) + &
                sum(self%upper_share(s)*profile%mdr_slope_beyond(lowest, beyond)*ds)
    end function upper_depth

    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(series_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error
        type(series_load_t), allocatable :: own

        if (allocated(error)) continue
        allocate (own)
        call own%begin(self, profile, a, punch_depth)
        call move_alloc(own, load)
    end subroutine new_load

    !> Each increment of depth moves each surface as a flat punch on a homogeneous body, by that body's share:
    !> u_2(r) = int_0^a share(s) g'(s) w(s, r) ds + share(a) punch_depth w(a, r), w = 1 for r < s and (2/pi) arcsin(s/r) beyond.
    subroutine displacement_of_body(self, body, r, values, error)
        class(series_load_t), intent(in) :: self
        integer, intent(in) :: body
        real(wp), intent(in) :: r(:)
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: s(:), ds(:), beyond(:), breaks(:)
        real(wp) :: lowest, highest, whole, upper
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            call medium%all_breaks(profile, breaks, error)
            whole = medium%upper_depth(profile, a, error)
            do i = 1, size(r)
                if (r(i) < a) then
                    upper = medium%upper_share(a)*punch_depth + whole - medium%upper_depth(profile, r(i), error)
                else
                    upper = medium%upper_share(a)*punch_depth*asin(a/r(i))/half_pi
                end if
                highest = min(r(i), a)
                lowest = max(profile%end_radius, smallest_panel_ratio*highest)
                if (highest > lowest) then
                    call graded_rule(lowest, highest, breaks, min(profile%singular_radius, r(i)), s, ds, error, beyond)
                    if (allocated(error)) return
                    upper = upper + (medium%upper_share(lowest)*profile%mdr_moment(lowest)/r(i) &
                                     + sum(medium%upper_share(s)*profile%mdr_slope_beyond(lowest, beyond) &
                                           *asin(min(s/r(i), 1.0_wp))*ds))/half_pi
                end if
                values(i) = merge(values(i) - upper, upper, body == lower_body)
            end do
        end associate
    end subroutine displacement_of_body

    !> Both bodies under that load, where it is known of both.
    subroutine for_load(self, load, other, error)
        class(series_t), intent(in) :: self
        integer, intent(in) :: load
        class(solver_t), allocatable, intent(out) :: other
        type(error_t), allocatable, intent(out) :: error
        class(solver_t), allocatable :: lower, upper
        type(series_t), allocatable :: own

        call self%lower%for_load(load, lower, error)
        if (.not. allocated(error)) call self%upper%for_load(load, upper, error)
        if (allocated(error)) return
        select type (lower)
        class is (effective_medium_t)
            select type (upper)
            class is (effective_medium_t)
                allocate (own)
                call new_series(own, lower, upper, error)
                if (.not. allocated(error)) call move_alloc(own, other)
            end select
        end select
    end subroutine for_load

end module mdrcontact_medium_series
