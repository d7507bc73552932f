! SPDX-License-Identifier: GPL-3.0-or-later
!> The test of runs (Wald and Wolfowitz): whether residuals along x change their sign as often as random ones.
module mdrcontact_fit_runs
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: runs_test

contains

    !> The two-sided probability of a number of runs as far from its mean as the one found; 1 where there are too few signs.
    pure function runs_test(x, residuals) result(probability)
        !> positions, in any order, and residuals, same size
        real(wp), intent(in) :: x(:), residuals(:)
        real(wp) :: probability
        logical :: is_positive(size(x))
        real(wp) :: above, below, mean, variance
        integer :: runs

        probability = 1.0_wp
        is_positive = residuals(order_of(x)) > 0.0_wp
        above = count(is_positive)
        below = size(is_positive) - above
        if (min(above, below) < 2.0_wp) then
            ! a single sign over many points is no accident
            if (size(is_positive) > 8) probability = 0.5_wp**(size(is_positive) - 3)
            return
        end if
        runs = 1 + count(is_positive(2:) .neqv. is_positive(:size(is_positive) - 1))
        mean = 1.0_wp + 2.0_wp*above*below/(above + below)
        variance = (mean - 1.0_wp)*(mean - 2.0_wp)/(above + below - 1.0_wp)
        probability = erfc(max(abs(runs - mean) - 0.5_wp, 0.0_wp)/sqrt(2.0_wp*variance))
    end function runs_test

    !> Positions in ascending order of x; data come sorted or nearly so, for which insertion is quick.
    pure function order_of(x) result(order)
        real(wp), intent(in) :: x(:)
        integer :: order(size(x))
        integer :: i, j

        do i = 1, size(x)
            do j = i - 1, 1, -1
                if (x(order(j)) <= x(i)) exit
                order(j + 1) = order(j)
            end do
            order(j + 1) = i
        end do
    end function order_of

end module mdrcontact_fit_runs
