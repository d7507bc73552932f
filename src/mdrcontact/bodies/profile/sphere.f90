! SPDX-License-Identifier: GPL-3.0-or-later
!> The sphere of radius R without the parabolic approximation: f(r) = R - sqrt(R^2 - r^2).
module mdrcontact_profile_sphere
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: sphere_t, new_sphere

    !> g(x) = (x/2) ln((R + x)/(R - x)) = x artanh(x/R), 0 <= x < R. Popov 2014, table after equation (4).
    type, extends(profile_t) :: sphere_t
        private
        !> R [length]
        real(wp) :: radius = 0.0_wp
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: is_spherical
        procedure :: parameters
        procedure :: set
    end type sphere_t

contains

    !> A sphere of radius R.
    subroutine new_sphere(self, radius, error)
        type(sphere_t), intent(out) :: self
        !> R > 0 [length]
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        self%radius = radius
        self%largest_radius = radius
        self%singular_radius = radius
        self%is_made = .not. allocated(error)
    end subroutine new_sphere

    pure subroutine parameters(self, list)
        class(sphere_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        list = [parameter_t("radius", self%radius)]
    end subroutine parameters

    subroutine set(self, values, error)
        class(sphere_t), intent(inout) :: self
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        call new_sphere(self, values(1), error)
    end subroutine set

    elemental function height(self, x) result(y)
        class(sphere_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = x**2/(self%radius + sqrt((self%radius - x)*(self%radius + x)))
    end function height

    elemental function slope(self, x) result(y)
        class(sphere_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = x/sqrt((self%radius - x)*(self%radius + x))
    end function slope

    elemental function mdr(self, x) result(y)
        class(sphere_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = x*atanh(x/self%radius)
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(sphere_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = atanh(x/self%radius) + (x/(self%radius - x))*(self%radius/(self%radius + x))
    end function mdr_slope

    elemental function mdr_moment(self, x) result(y)
        class(sphere_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: t, square
        integer :: k

        ! R^2 [(1 + t^2)/2 artanh t - t/2] with t = x/R; its terms cancel for small t, where the series
        ! sum_k 2k/(4k^2 - 1) t^(2k+1) takes over: 16 terms give full precision up to t = 0.3.
        t = x/self%radius
        square = t**2
        if (t > 0.3_wp) then
            y = 0.5_wp*((1.0_wp + square)*atanh(t) - t)
        else
            y = 0.0_wp
            do k = 16, 1, -1
                y = y*square + 2.0_wp*k/(4.0_wp*k**2 - 1.0_wp)
            end do
            y = y*square*t
        end if
        y = y*self%radius**2
    end function mdr_moment

    pure function is_spherical(self) result(answer)
        class(sphere_t), intent(in) :: self
        logical :: answer

        associate (unused => self)
        end associate
        answer = .true.
    end function is_spherical

end module mdrcontact_profile_sphere
