! SPDX-License-Identifier: GPL-3.0-or-later
!> The flat-ended (truncated) cone: flat up to b, then f(r) = (r - b) tan(phi).
module mdrcontact_profile_flat_cone
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_inclination, check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: profile_t, root_after, root_beyond
    implicit none (type, external)
    private
    public :: flat_cone_t, new_flat_cone

    !> g(x) = x tan(phi) arccos(b/x), x > b. Popov 2014, table after equation (4).
    type, extends(profile_t) :: flat_cone_t
        private
        !> phi and tan(phi); b is end_radius
        real(wp) :: inclination = 0.0_wp, tangent = 0.0_wp
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_slope_beyond
        procedure :: mdr_moment
        procedure :: linear_pieces
        procedure :: parameters
        procedure :: set
    end type flat_cone_t

contains

    !> A cone with a flat end.
    subroutine new_flat_cone(self, end_radius, inclination, error)
        type(flat_cone_t), intent(out) :: self
        !> b > 0, radius of the flat end [length]
        real(wp), intent(in) :: end_radius
        !> phi, the angle between face and surface, 0 < phi < pi/2 [radian]
        real(wp), intent(in) :: inclination
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "end_radius", end_radius)
        call check_inclination(error, inclination)
        if (allocated(error)) return
        self%end_radius = end_radius
        self%inclination = inclination
        self%tangent = tan(inclination)
    end subroutine new_flat_cone

    pure subroutine parameters(self, list)
        class(flat_cone_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        list = [parameter_t("end_radius", self%end_radius), parameter_t("inclination", self%inclination)]
    end subroutine parameters

    subroutine set(self, values, error)
        class(flat_cone_t), intent(inout) :: self
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        call new_flat_cone(self, values(1), values(2), error)
    end subroutine set

    elemental function height(self, x) result(y)
        class(flat_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%tangent*max(x - self%end_radius, 0.0_wp)
    end function height

    elemental function slope(self, x) result(y)
        class(flat_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = merge(self%tangent, 0.0_wp, x > self%end_radius)
    end function slope

    elemental function mdr(self, x) result(y)
        class(flat_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%tangent*x*atan2(root_beyond(x, self%end_radius), self%end_radius)
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(flat_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = 0.0_wp
        if (x > self%end_radius) y = self%mdr_slope_beyond(self%end_radius, x - self%end_radius)
    end function mdr_slope

    elemental function mdr_slope_beyond(self, start, distance) result(y)
        class(flat_cone_t), intent(in) :: self
        real(wp), intent(in) :: start, distance
        real(wp) :: y
        real(wp) :: gap, root

        gap = (start - self%end_radius) + distance
        root = root_after(gap, self%end_radius)
        if (root > 0.0_wp) then
            y = self%tangent*(atan2(root, self%end_radius) + self%end_radius/root)
        else
            y = merge(0.0_wp, infinity, gap < 0.0_wp)
        end if
    end function mdr_slope_beyond

    elemental function mdr_moment(self, x) result(y)
        class(flat_cone_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root

        root = root_beyond(x, self%end_radius)
        y = 0.5_wp*self%tangent*(x**2*atan2(root, self%end_radius) + self%end_radius*root)
    end function mdr_moment

    subroutine linear_pieces(self, radii, slopes, curvatures, base)
        class(flat_cone_t), intent(in), target :: self
        real(wp), allocatable, intent(out) :: radii(:), slopes(:), curvatures(:)
        class(profile_t), pointer, intent(out) :: base

        nullify (base)
        radii = [0.0_wp, self%end_radius]
        slopes = [0.0_wp, self%tangent]
        curvatures = [0.0_wp, 0.0_wp]
    end subroutine linear_pieces

end module mdrcontact_profile_flat_cone
