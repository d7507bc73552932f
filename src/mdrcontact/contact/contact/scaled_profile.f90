! SPDX-License-Identifier: GPL-3.0-or-later
!> An indenter whose depth is corrected, d = zeta(a) g(a), equation (9): zeta g represents g in all that follows from it.
module mdrcontact_contact_scaled_profile
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: quiet_nan
    use mdrcontact_object, only: real_bytes, room
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre, graded_edges, merge_breaks
    use mdrcontact_numerics_radius_law, only: radius_law_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: scaled_profile_t, new_scaled_profile

    integer, parameter :: nodes = 20

    !> f(r) stays as it is.
    type, extends(profile_t) :: scaled_profile_t
        private
        class(profile_t), allocatable :: profile
        type(radius_law_t) :: zeta
        !> the smallest radius of zeta and all breaks above it, and int_0^x s d'(s) ds there
        real(wp), allocatable :: radii(:), moments(:)
        !> Gauss-Legendre nodes and weights on [0, 1]
        real(wp) :: t(nodes) = 0.0_wp, w(nodes) = 0.0_wp
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_slope_beyond
        procedure :: mdr_moment
        procedure :: add_breaks
        procedure :: radius_from_mdr
        procedure :: bytes
    end type scaled_profile_t

contains

    !> The profile with zeta(x) g(x) instead of g(x).
    subroutine new_scaled_profile(self, profile, zeta, error)
        type(scaled_profile_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        type(radius_law_t), intent(in) :: zeta
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: breaks(:)
        integer :: i, stat

        call room(profile%bytes() + zeta%bytes(), error)
        if (allocated(error)) return
        allocate (self%profile, source=profile)
        self%zeta = zeta
        self%largest_radius = profile%largest_radius
        self%singular_radius = profile%singular_radius
        self%end_radius = profile%end_radius
        self%has_wall = profile%has_wall
        self%sharp_radius = profile%sharp_radius
        call gauss_legendre(self%t, self%w, error)
        if (allocated(error)) return
        call self%add_breaks(breaks, error)
        self%radii = [min(zeta%smallest_radius, profile%largest_radius)]
        call merge_breaks(self%radii, breaks(count(breaks <= self%radii(1)) + 1:count(breaks <= profile%largest_radius)), error)
        allocate (self%moments(size(self%radii)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(self%radii)
            if (i == 1) then
                self%moments(1) = scaled_moment(self, self%radii(1))
            else
                self%moments(i) = self%moments(i - 1) + moment_between(self, self%radii(i - 1), self%radii(i))
            end if
        end do
        self%is_made = .not. allocated(error)
    end subroutine new_scaled_profile

    elemental function height(self, x) result(y)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%profile%height(x)
    end function height

    elemental function slope(self, x) result(y)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%profile%slope(x)
    end function slope

    elemental function mdr(self, x) result(y)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%zeta%at(x)*self%profile%mdr(x)
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%zeta%at(x)*self%profile%mdr_slope(x) + self%zeta%slope_at(x)*self%profile%mdr(x)
    end function mdr_slope

    elemental function mdr_slope_beyond(self, start, distance) result(y)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: start, distance
        real(wp) :: y

        associate (x => start + distance)
            y = self%zeta%at(x)*self%profile%mdr_slope_beyond(start, distance) + self%zeta%slope_at(x)*self%profile%mdr(x)
        end associate
    end function mdr_slope_beyond

    elemental function mdr_moment(self, x) result(y)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        i = count(self%radii <= x)
        if (i == 0) then
            y = scaled_moment(self, x)
        else
            y = self%moments(i) + moment_between(self, self%radii(i), x)
        end if
    end function mdr_moment

    !> The moment up to a radius below which zeta is constant.
    pure function scaled_moment(self, x) result(moment)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: moment

        moment = self%zeta%at(x)*self%profile%mdr_moment(x)
    end function scaled_moment

    !> int s d'(s) ds between two radii, the lower one a break, without breaks between them.
    pure function moment_between(self, lower, upper) result(moment)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: lower, upper
        real(wp) :: moment
        real(wp), allocatable :: edges(:)
        type(error_t), allocatable :: error
        real(wp) :: beyond(nodes), ds(nodes), length
        integer :: i

        moment = 0.0_wp
        if (.not. upper > lower) return
        call graded_edges(lower, upper, [lower], self%profile%singular_radius, edges, error)
        if (allocated(error)) then
            ! a moment has no status: the state that it belongs to is rejected as not finite
            moment = quiet_nan
            return
        end if
        do i = 1, size(edges) - 1
            length = edges(i + 1) - edges(i)
            if (i == 1) then
                beyond = length*self%t**2
                ds = 2.0_wp*length*self%t*self%w
            else
                beyond = (edges(i) - lower) + length*self%t
                ds = length*self%w
            end if
            moment = moment + sum((lower + beyond)*self%mdr_slope_beyond(lower, beyond)*ds)
        end do
    end function moment_between

    pure subroutine add_breaks(self, radii, error)
        class(scaled_profile_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%profile%add_breaks(radii, error)
        call self%zeta%add_breaks(radii, error)
    end subroutine add_breaks

    pure recursive function bytes(self)
        class(scaled_profile_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%profile%bytes() + self%zeta%bytes() + 2*real_bytes*size(self%radii)
    end function bytes

    pure function radius_from_mdr(self, depth) result(radius)
        class(scaled_profile_t), intent(in) :: self
        real(wp), intent(in) :: depth
        real(wp) :: radius

        radius = self%profile%radius_from_mdr(depth)
    end function radius_from_mdr

end module mdrcontact_contact_scaled_profile
