! SPDX-License-Identifier: GPL-3.0-or-later
!> The line load under an indenter on a homogeneous or layered body: q(x) = E0* (d - g(x) - v(x)), with g the indenter's
!> one-dimensional profile and v what the layers below the first do to the springs, a sum of even Legendre polynomials of x/a.
module mdrcontact_medium_profile_load
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_fields, only: line_load_t
    use mdrcontact_line_panels, only: panels_t
    use mdrcontact_line_series, only: even_slope
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: profile_load_t, new_profile_load

    !> q(x) = E0* (d - g(x) - v(x)) and its slope.
    type, extends(load_t) :: profile_load_t
        private
        class(profile_t), allocatable :: profile
        !> E0* [modulus]
        real(wp) :: modulus = 0.0_wp
        !> coefficients of P_2j(x/a), j = 0, 1, ..., in v [length]
        real(wp), allocatable :: v(:)
        !> v where that series falls too slowly
        type(panels_t), allocatable :: pieces
    contains
        procedure :: slope
    end type profile_load_t

contains

    !> The load of a state.
    subroutine new_profile_load(self, profile, modulus, springs, error)
        type(profile_load_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        !> contact modulus of the surface layer [modulus]
        real(wp), intent(in) :: modulus
        type(line_load_t), intent(in) :: springs
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:)

        call copy(profile, self%profile, error)
        self%modulus = modulus
        self%radius = springs%a
        self%edge = modulus*springs%edge
        if (allocated(springs%panels)) then
            self%pieces = springs%panels
        else
            self%v = springs%v
        end if
        call profile%add_breaks(breaks, error)
        call merge_breaks(self%kinks, breaks(:count(breaks < springs%a)), error)
        if (allocated(error)) return
        call self%mark_axis()
    end subroutine new_profile_load

    pure function slope(self, start, distance) result(y)
        class(profile_load_t), intent(in) :: self
        real(wp), intent(in) :: start, distance(:)
        real(wp) :: y(size(distance))
        integer :: i

        if (allocated(self%pieces)) then
            y = [(self%pieces%slope(start + distance(i)), i=1, size(distance))]
        else
            y = even_slope(self%v, (start + distance)/self%radius)/self%radius
        end if
        y = -self%modulus*(self%profile%mdr_slope_beyond(start, distance) + y)
    end function slope

end module mdrcontact_medium_profile_load
