! SPDX-License-Identifier: GPL-3.0-or-later
!> The test of runs (Wald and Wolfowitz): whether residuals along x change their sign as often as random ones.
module mdrcontact_fit_runs
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_order, only: ascending_order
    implicit none (type, external)
    private
    public :: runs_test

contains

    !> The two-sided probability of a number of runs as far from its mean as the one found; 1 where there are too few signs.
    pure subroutine runs_test(x, residuals, probability, error)
        !> positions, in any order, and residuals, same size
        real(wp), intent(in) :: x(:), residuals(:)
        real(wp), intent(out) :: probability
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: order(:)
        real(wp) :: above, below, mean, variance
        integer :: i, runs, stat

        probability = 1.0_wp
        above = count(residuals > 0.0_wp)
        below = size(residuals) - above
        if (min(above, below) < 2.0_wp) then
            ! a single sign over many points is no accident
            if (size(residuals) > 8) probability = 0.5_wp**(size(residuals) - 3)
            return
        end if
        call ascending_order(x, order, stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        runs = 1
        do i = 2, size(order)
            if ((residuals(order(i)) > 0.0_wp) .neqv. (residuals(order(i - 1)) > 0.0_wp)) runs = runs + 1
        end do
        mean = 1.0_wp + 2.0_wp*above*below/(above + below)
        variance = (mean - 1.0_wp)*(mean - 2.0_wp)/(above + below - 1.0_wp)
        probability = erfc(max(abs(runs - mean) - 0.5_wp, 0.0_wp)/sqrt(2.0_wp*variance))
    end subroutine runs_test

end module mdrcontact_fit_runs
