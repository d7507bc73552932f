! SPDX-License-Identifier: GPL-3.0-or-later
!> Flat-ended (truncated or worn) shapes, flat up to b: the cone, f(r) = (r - b) tan(phi), and the paraboloid,
!> f(r) = (r^2 - b^2)/(2R).
module mdrcontact_profile_flat_ended
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_inclination, check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: profile_t, root_after, root_beyond
    implicit none (type, external)
    private
    public :: flat_ended_t, new_flat_cone, new_flat_paraboloid

    !> g(x) = x tan(phi) arccos(b/x) or (x/R) sqrt(x^2 - b^2), x > b. Popov 2014, table after equation (4).
    type, extends(profile_t) :: flat_ended_t
        private
        logical :: is_cone = .false.
        !> phi and tan(phi) of a cone; R of a paraboloid [length]; b is end_radius
        real(wp) :: inclination = 0.0_wp, tangent = 0.0_wp, curvature_radius = 0.0_wp
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
    end type flat_ended_t

contains

    !> A cone with a flat end.
    subroutine new_flat_cone(self, end_radius, inclination, error)
        type(flat_ended_t), intent(out) :: self
        !> b > 0, radius of the flat end [length]
        real(wp), intent(in) :: end_radius
        !> phi, the angle between face and surface, 0 < phi < pi/2 [radian]
        real(wp), intent(in) :: inclination
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "end_radius", end_radius)
        call check_inclination(error, inclination)
        if (allocated(error)) return
        self%is_cone = .true.
        self%end_radius = end_radius
        self%inclination = inclination
        self%tangent = tan(inclination)
        self%is_made = .not. allocated(error)
    end subroutine new_flat_cone

    !> A paraboloid with a flat end.
    subroutine new_flat_paraboloid(self, end_radius, radius, error)
        type(flat_ended_t), intent(out) :: self
        !> b > 0, radius of the flat end [length]
        real(wp), intent(in) :: end_radius
        !> R > 0, radius of curvature of the paraboloid at its (cut off) apex [length]
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "end_radius", end_radius)
        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        self%end_radius = end_radius
        self%curvature_radius = radius
        self%is_made = .not. allocated(error)
    end subroutine new_flat_paraboloid

    pure subroutine parameters(self, list)
        class(flat_ended_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        list = [parameter_t("end_radius", self%end_radius), parameter_t("radius", self%curvature_radius)]
        if (self%is_cone) list(2) = parameter_t("inclination", self%inclination)
    end subroutine parameters

    subroutine set(self, values, error)
        class(flat_ended_t), intent(inout) :: self
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        if (self%is_cone) then
            call new_flat_cone(self, values(1), values(2), error)
        else
            call new_flat_paraboloid(self, values(1), values(2), error)
        end if
    end subroutine set

    elemental function height(self, x) result(y)
        class(flat_ended_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (self%is_cone) then
            y = self%tangent*max(x - self%end_radius, 0.0_wp)
        else
            y = 0.5_wp*max(x - self%end_radius, 0.0_wp)*(x + self%end_radius)/self%curvature_radius
        end if
    end function height

    elemental function slope(self, x) result(y)
        class(flat_ended_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = 0.0_wp
        if (.not. x > self%end_radius) return
        if (self%is_cone) then
            y = self%tangent
        else
            y = x/self%curvature_radius
        end if
    end function slope

    elemental function mdr(self, x) result(y)
        class(flat_ended_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (self%is_cone) then
            y = self%tangent*x*atan2(root_beyond(x, self%end_radius), self%end_radius)
        else
            y = x*root_beyond(x, self%end_radius)/self%curvature_radius
        end if
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(flat_ended_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = 0.0_wp
        if (x > self%end_radius) y = self%mdr_slope_beyond(self%end_radius, x - self%end_radius)
    end function mdr_slope

    elemental function mdr_slope_beyond(self, start, distance) result(y)
        class(flat_ended_t), intent(in) :: self
        real(wp), intent(in) :: start, distance
        real(wp) :: y
        real(wp) :: gap, root

        gap = (start - self%end_radius) + distance
        root = root_after(gap, self%end_radius)
        if (.not. root > 0.0_wp) then
            y = merge(0.0_wp, infinity, gap < 0.0_wp)
        else if (self%is_cone) then
            y = self%tangent*(atan2(root, self%end_radius) + self%end_radius/root)
        else
            y = (root + (self%end_radius + gap)*((self%end_radius + gap)/root))/self%curvature_radius
        end if
    end function mdr_slope_beyond

    elemental function mdr_moment(self, x) result(y)
        class(flat_ended_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root

        root = root_beyond(x, self%end_radius)
        if (self%is_cone) then
            y = 0.5_wp*self%tangent*(x**2*atan2(root, self%end_radius) + self%end_radius*root)
        else
            y = root*(2.0_wp*x**2 + self%end_radius**2)/(3.0_wp*self%curvature_radius)
        end if
    end function mdr_moment

    subroutine linear_pieces(self, radii, slopes, curvatures, base)
        class(flat_ended_t), intent(in), target :: self
        real(wp), allocatable, intent(out) :: radii(:), slopes(:), curvatures(:)
        class(profile_t), pointer, intent(out) :: base

        nullify (base)
        radii = [0.0_wp, self%end_radius]
        slopes = [0.0_wp, self%tangent]
        curvatures = [0.0_wp, 0.0_wp]
        if (.not. self%is_cone) curvatures(2) = 1.0_wp/self%curvature_radius
    end subroutine linear_pieces

end module mdrcontact_profile_flat_ended
