! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether residuals along a curve are random: Bartels' rank version of von Neumann's ratio of mean square successive difference
!> to variance. R. Bartels, J. Am. Stat. Assoc. 77 (1982) 40; its beta approximation, section 3.
module mdrcontact_fit_pattern
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_fit_order, only: ascending
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: pattern_test

    !> With fewer points no order of the residuals is improbable.
    integer, parameter :: fewest_points = 8

    interface
        pure function gsl_cdf_beta_p(x, a, b) result(p) bind(C, name="gsl_cdf_beta_P")
            import :: c_double
            real(c_double), value :: x, a, b
            real(c_double) :: p
        end function gsl_cdf_beta_p
    end interface

contains

    !> The probability that random residuals follow each other as smoothly as these; 1 for fewer than 8.
    pure subroutine pattern_test(residuals, probability, error)
        !> in their order along the curve
        real(wp), contiguous, intent(in) :: residuals(:)
        real(wp), intent(out) :: probability
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: rank(:)
        real(wp) :: n, shape, x

        probability = 1.0_wp
        if (size(residuals) < fewest_points .or. maxval(residuals) <= minval(residuals)) return
        n = real(size(residuals), wp)
        call find_ranks(residuals, rank, error)
        if (allocated(error)) return
        x = 0.25_wp*sum((rank(2:) - rank(:size(rank) - 1))**2)/sum((rank - 0.5_wp*(n + 1.0_wp))**2)
        ! x is distributed like beta(shape, shape)
        shape = 2.5_wp*n*(n + 1.0_wp)*(n - 1.0_wp)**2/((n - 2.0_wp)*(5.0_wp*n**2 - 2.0_wp*n - 9.0_wp)) - 0.5_wp
        if ((4.0_wp*x*max(1.0_wp - x, 0.0_wp))**shape > tiny(x)) then
            probability = gsl_cdf_beta_p(x, shape, shape)
        else
            ! GSL would divide by a density of 0
            probability = merge(0.0_wp, 1.0_wp, x < 0.5_wp)
        end if
    end subroutine pattern_test

    !> Ranks from 1; equal values share the mean of theirs.
    pure subroutine find_ranks(values, rank, error)
        real(wp), contiguous, intent(in) :: values(:)
        real(wp), allocatable, intent(out) :: rank(:)
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: order(:)
        integer :: first, last, stat

        allocate (rank(size(values)), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) call ascending(values, order, error)
        if (allocated(error)) return
        first = 1
        do while (first <= size(values))
            last = first
            do while (last < size(values))
                if (values(order(last + 1)) > values(order(first))) exit
                last = last + 1
            end do
            rank(order(first:last)) = 0.5_wp*(first + last)
            first = last + 1
        end do
    end subroutine find_ranks

end module mdrcontact_fit_pattern
