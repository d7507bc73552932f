! SPDX-License-Identifier: GPL-3.0-or-later
!> The cone with a rounded tip: a paraboloid up to b that meets the cone as its tangent.
module mdrcontact_profile_rounded_cone
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_inclination, check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_profile, only: profile_t, root_beyond
    implicit none (type, external)
    private
    public :: rounded_cone_t, new_rounded_cone

    !> f(r) = r^2 tan(phi)/(2b), r <= b; (r - b/2) tan(phi), r > b.
    !> g(x) = (x tan(phi)/b) (x - H(x - b) [sqrt(x^2 - b^2) - b arccos(b/x)]). Popov 2014, table after equation (4).
    !> With x - sqrt(x^2 - b^2) = b^2/(x + sqrt(x^2 - b^2)) nothing cancels at x >> b.
    type, extends(profile_t) :: rounded_cone_t
        private
        !> b [length]
        real(wp) :: blend_radius = 0.0_wp
        !> phi and tan(phi)
        real(wp) :: inclination = 0.0_wp, tangent = 0.0_wp
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: add_breaks
        procedure :: linear_pieces
        procedure :: parameters
        procedure :: set
    end type rounded_cone_t

contains

    !> A cone with a rounded tip.
    subroutine new_rounded_cone(self, blend_radius, inclination, error)
        type(rounded_cone_t), intent(out) :: self
        !> b > 0, where the paraboloid passes into the cone; the radius of curvature at the tip is b/tan(phi) [length]
        real(wp), intent(in) :: blend_radius
        !> phi, the angle between face and surface, 0 < phi < pi/2 [radian]
        real(wp), intent(in) :: inclination
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "blend_radius", blend_radius)
        call check_inclination(error, inclination)
        if (allocated(error)) return
        self%blend_radius = blend_radius
        self%inclination = inclination
        self%tangent = tan(inclination)
        self%is_made = .not. allocated(error)
    end subroutine new_rounded_cone

    pure subroutine parameters(self, list)
        class(rounded_cone_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        list = [parameter_t("blend_radius", self%blend_radius), parameter_t("inclination", self%inclination)]
    end subroutine parameters

    subroutine set(self, values, error)
        class(rounded_cone_t), intent(inout) :: self
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        call new_rounded_cone(self, values(1), values(2), error)
    end subroutine set

    elemental function height(self, x) result(y)
        class(rounded_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%blend_radius) then
            y = 0.5_wp*self%tangent*x*(x/self%blend_radius)
        else
            y = self%tangent*(x - 0.5_wp*self%blend_radius)
        end if
    end function height

    elemental function slope(self, x) result(y)
        class(rounded_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%tangent*min(x/self%blend_radius, 1.0_wp)
    end function slope

    elemental function mdr(self, x) result(y)
        class(rounded_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root

        root = root_beyond(x, self%blend_radius)
        if (x <= self%blend_radius) then
            y = self%tangent*x*(x/self%blend_radius)
        else
            y = self%tangent*x*(self%blend_radius/(x + root) + atan2(root, self%blend_radius))
        end if
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(rounded_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root

        root = root_beyond(x, self%blend_radius)
        if (x <= self%blend_radius) then
            y = 2.0_wp*self%tangent*(x/self%blend_radius)
        else
            y = self%tangent*(2.0_wp*self%blend_radius/(x + root) + atan2(root, self%blend_radius))
        end if
    end function mdr_slope

    elemental function mdr_moment(self, x) result(y)
        class(rounded_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root

        root = root_beyond(x, self%blend_radius)
        if (x <= self%blend_radius) then
            y = (2.0_wp/3.0_wp)*self%tangent*x**2*(x/self%blend_radius)
        else
            y = self%tangent*((2.0_wp/3.0_wp)*x**2*(self%blend_radius/(x + root)) + self%blend_radius*root/6.0_wp &
                              + 0.5_wp*x**2*atan2(root, self%blend_radius))
        end if
    end function mdr_moment

    pure subroutine add_breaks(self, radii, error)
        class(rounded_cone_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call merge_breaks(radii, [self%blend_radius], error)
    end subroutine add_breaks

    subroutine linear_pieces(self, radii, slopes, curvatures, base)
        class(rounded_cone_t), intent(in), target :: self
        real(wp), allocatable, intent(out) :: radii(:), slopes(:), curvatures(:)
        class(profile_t), pointer, intent(out) :: base

        nullify (base)
        radii = [0.0_wp, self%blend_radius]
        slopes = [0.0_wp, self%tangent]
        curvatures = [self%tangent/self%blend_radius, 0.0_wp]
    end subroutine linear_pieces

end module mdrcontact_profile_rounded_cone
