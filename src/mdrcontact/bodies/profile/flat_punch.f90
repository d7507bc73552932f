! SPDX-License-Identifier: GPL-3.0-or-later
!> The flat-ended cylinder of radius b: the contact radius is b at every depth.
module mdrcontact_profile_flat_punch
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: flat_punch_t, new_flat_punch

    !> f = g = 0 up to the vertical wall at b.
    type, extends(profile_t) :: flat_punch_t
    contains
        procedure :: height => zero
        procedure :: slope => zero
        procedure :: mdr => zero
        procedure :: mdr_slope => zero
        procedure :: mdr_moment => zero
        procedure :: parameters
        procedure :: set
    end type flat_punch_t

contains

    !> A flat punch of radius b.
    subroutine new_flat_punch(self, radius, error)
        type(flat_punch_t), intent(out) :: self
        !> b > 0 [length]
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        self%end_radius = radius
        self%largest_radius = radius
        self%has_wall = .true.
        self%is_made = .not. allocated(error)
    end subroutine new_flat_punch

    pure subroutine parameters(self, list)
        class(flat_punch_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        list = [parameter_t("radius", self%end_radius)]
    end subroutine parameters

    subroutine set(self, values, error)
        class(flat_punch_t), intent(inout) :: self
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        call new_flat_punch(self, values(1), error)
    end subroutine set

    !> Value of all its functions.
    elemental function zero(self, x) result(y)
        class(flat_punch_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        associate (unused => self, also_unused => x)
        end associate
        y = 0.0_wp
    end function zero

end module mdrcontact_profile_flat_punch
