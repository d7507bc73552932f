! SPDX-License-Identifier: GPL-3.0-or-later
!> Lagrange's polynomials of any places.
module mdrcontact_numerics_lagrange
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: lagrange

contains

    !> The polynomials that are 1 at one of the places and 0 at the others, at x: (x, place).
    pure function lagrange(places, x) result(values)
        !> distinct
        real(wp), intent(in) :: places(:)
        real(wp), intent(in) :: x(:)
        real(wp) :: values(size(x), size(places))
        integer :: i, j

        values = 1.0_wp
        do i = 1, size(places)
            do j = 1, size(places)
                if (j /= i) values(:, i) = values(:, i)*((x - places(j))/(places(i) - places(j)))
            end do
        end do
    end function lagrange

end module mdrcontact_numerics_lagrange
