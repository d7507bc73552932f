! SPDX-License-Identifier: GPL-3.0-or-later
!> Height, slope and MDR profile of an indenter at many radii, on one thread or several.
module mdrcontact_profile_values
    use mdrcontact_batch, only: map_t, run_map
    use mdrcontact_codes, only: of_height => height, of_mdr => g, of_mdr_slope => g_slope, of_slope => height_slope
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: profile_values
    public :: of_height, of_slope, of_mdr, of_mdr_slope

    type, extends(map_t) :: profile_map_t
        class(profile_t), pointer :: profile => null()
        integer :: quantity = of_height
    contains
        procedure :: values
    end type profile_map_t

contains

    !> One of the four functions at many radii.
    subroutine profile_values(profile, quantity, r, y, threads)
        class(profile_t), intent(in), target :: profile
        !> of_height, of_slope, of_mdr or of_mdr_slope
        integer, intent(in) :: quantity
        !> in [0, largest_radius], not checked [length]
        real(wp), intent(in), contiguous :: r(:)
        !> same size as r
        real(wp), intent(inout), contiguous :: y(:)
        !> at least 1, or 0 for as many as OpenMP offers; few radii stay on one
        integer, intent(in) :: threads
        type(profile_map_t) :: map

        map%profile => profile
        map%quantity = quantity
        call run_map(map, r, y, threads)
    end subroutine profile_values

    pure subroutine values(self, x, y)
        class(profile_map_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: y(:)
        integer :: i

        ! Loops, since an array expression of a type-bound function takes memory of the array's size without a status.
        select case (self%quantity)
        case (of_height)
            do i = 1, size(x)
                y(i) = self%profile%height(x(i))
            end do
        case (of_slope)
            do i = 1, size(x)
                y(i) = self%profile%slope(x(i))
            end do
        case (of_mdr)
            do i = 1, size(x)
                y(i) = self%profile%mdr(x(i))
            end do
        case default
            do i = 1, size(x)
                y(i) = self%profile%mdr_slope(x(i))
            end do
        end select
    end subroutine values

end module mdrcontact_profile_values
