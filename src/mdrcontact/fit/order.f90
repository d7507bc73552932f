! SPDX-License-Identifier: GPL-3.0-or-later
!> Positions that bring values into ascending order.
module mdrcontact_fit_order
    use, intrinsic :: iso_c_binding, only: c_double, c_size_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: ascending, median

    interface
        pure subroutine gsl_sort_index(positions, values, stride, n) bind(C)
            import :: c_double, c_size_t
            integer(c_size_t), intent(out) :: positions(*)
            real(c_double), intent(in) :: values(*)
            integer(c_size_t), value :: stride, n
        end subroutine gsl_sort_index
    end interface

contains

    !> The positions of the smallest value, the next, ...
    pure function ascending(values) result(order)
        real(wp), intent(in) :: values(:)
        integer :: order(size(values))
        integer(c_size_t) :: positions(size(values))

        call gsl_sort_index(positions, values, 1_c_size_t, size(values, kind=c_size_t))
        order = int(positions) + 1
    end function ascending

    !> The value in the middle.
    pure function median(values) result(middle)
        !> at least one
        real(wp), intent(in) :: values(:)
        real(wp) :: middle
        integer :: order(size(values))

        order = ascending(values)
        middle = 0.5_wp*(values(order((size(values) + 1)/2)) + values(order(size(values)/2 + 1)))
    end function median

end module mdrcontact_fit_order
