! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a function is lowest: searched for at given places, then by golden section between the neighbours of the lowest of them.
module mdrcontact_numerics_lowest
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: find_lowest, in_six_digits

    !> The smaller part of the golden section; how near the place is found: beyond it f has no information.
    real(wp), parameter :: part = 0.3819660112501051_wp, accuracy = 1.0e-8_wp

contains

    !> The lowest value and its place.
    subroutine find_lowest(f, places, x, least)
        !> without failures
        class(scalar_function_t), intent(inout) :: f
        !> ascending, at least 2, so near to each other that f has one minimum between three of them
        real(wp), intent(in) :: places(:)
        real(wp), intent(out) :: x, least
        real(wp) :: values(size(places)), low, high, inner, outer, at_inner, at_outer
        integer :: i

        do i = 1, size(places)
            values(i) = f%value(places(i))
        end do
        i = minloc(values, dim=1)
        low = places(max(1, i - 1))
        high = places(min(size(places), i + 1))
        inner = low + part*(high - low)
        outer = high - part*(high - low)
        at_inner = f%value(inner)
        at_outer = f%value(outer)
        do while (high - low > accuracy*max(1.0_wp, abs(high)))
            if (at_inner < at_outer) then
                high = outer
                outer = inner
                at_outer = at_inner
                inner = low + part*(high - low)
                at_inner = f%value(inner)
            else
                low = inner
                inner = outer
                at_inner = at_outer
                outer = high - part*(high - low)
                at_outer = f%value(outer)
            end if
        end do
        x = inner
        least = at_inner
        if (least <= values(i)) return
        x = places(i)
        least = values(i)
    end subroutine find_lowest

    !> A place as far as rounding lets it be known, for messages: f hardly changes around its lowest value.
    elemental function in_six_digits(x) result(rounded)
        !> > 0
        real(wp), intent(in) :: x
        real(wp) :: rounded
        real(wp) :: unit

        unit = 10.0_wp**(floor(log10(x)) - 5)
        rounded = anint(x/unit)*unit
    end function in_six_digits

end module mdrcontact_numerics_lowest
