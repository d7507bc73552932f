! SPDX-License-Identifier: GPL-3.0-or-later
!> Sorting by merging: equal numbers keep their order, and time grows as n log n whatever the order was.
module mdrcontact_numerics_order
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: ascending_order

contains

    !> The positions of x in ascending order.
    pure subroutine ascending_order(x, order, stat)
        real(wp), intent(in) :: x(:)
        integer, allocatable, intent(out) :: order(:)
        !> not 0 without memory
        integer, intent(out) :: stat
        integer, allocatable :: merged(:)
        integer :: i, width, first, middle, last

        allocate (order(size(x)), stat=stat)
        if (stat == 0) allocate (merged(size(x)), stat=stat)
        if (stat /= 0) return
        do i = 1, size(x)
            order(i) = i
        end do
        width = 1
        do while (width < size(x))
            first = 1
            do while (first <= size(x))
                middle = first + min(width, size(x) - first + 1)
                last = middle + min(width, size(x) - middle + 1) - 1
                call merge_runs(x, order(first:last), middle - first, merged(first:last))
                first = last + 1
            end do
            order(:) = merged
            width = 2*min(width, size(x))
        end do
    end subroutine ascending_order

    !> Merges the first `count` positions, which are in order, with the others, which are too.
    pure subroutine merge_runs(x, runs, count, merged)
        real(wp), intent(in) :: x(:)
        integer, intent(in) :: runs(:), count
        integer, intent(out) :: merged(:)
        integer :: left, right, i

        left = 1
        right = count + 1
        do i = 1, size(runs)
            if (right > size(runs)) then
                merged(i) = runs(left)
                left = left + 1
            else if (left > count) then
                merged(i) = runs(right)
                right = right + 1
            else if (x(runs(left)) <= x(runs(right))) then
                merged(i) = runs(left)
                left = left + 1
            else
                merged(i) = runs(right)
                right = right + 1
            end if
        end do
    end subroutine merge_runs

end module mdrcontact_numerics_order
