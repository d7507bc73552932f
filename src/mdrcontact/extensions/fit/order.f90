! SPDX-License-Identifier: GPL-3.0-or-later
!> Values in ascending order.
module mdrcontact_fit_order
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_gsl, only: gsl_sort, gsl_sort_index
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: ascending, median

contains

    !> The positions of the smallest value, the next, ...
    pure subroutine ascending(values, order, error)
        real(wp), contiguous, intent(in) :: values(:)
        integer, allocatable, intent(out) :: order(:)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_size_t), allocatable :: positions(:)
        integer :: i, stat

        allocate (order(size(values)), positions(size(values)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call gsl_sort_index(positions, values, 1_c_size_t, size(values, kind=c_size_t))
        do i = 1, size(order)
            order(i) = int(positions(i)) + 1
        end do
    end subroutine ascending

    !> The value in the middle.
    pure subroutine median(values, middle)
        !> at least one; sorted on return
        real(wp), contiguous, intent(inout) :: values(:)
        real(wp), intent(out) :: middle

        call gsl_sort(values, 1_c_size_t, size(values, kind=c_size_t))
        middle = 0.5_wp*(values((size(values) + 1)/2) + values(size(values)/2 + 1))
    end subroutine median

end module mdrcontact_fit_order
