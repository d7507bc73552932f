! SPDX-License-Identifier: GPL-3.0-or-later
!> Early response of a gel: a series in powers of sqrt(tau) with logarithms, which come from the edge, where the pressure of the
!> incompressible body is infinite: sqrt(tau) (c1 + c2 ln tau) + tau (c3 + c4 ln tau + c5 ln^2 tau):
!> theory/poroelastic.md (6.3).
module mdrcontact_poroelastic_early
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgels
    implicit none (type, external)
    private
    public :: early_terms, early_part, fit_early

    !> Terms of the beginning.
    integer, parameter :: early_terms = 5

contains

    pure function powers(tau) result(row)
        real(wp), intent(in) :: tau
        real(wp) :: row(early_terms)
        real(wp) :: x

        x = log(tau)
        row(:2) = sqrt(tau)*[1.0_wp, x]
        row(3:) = tau*[1.0_wp, x, x**2]
    end function powers

    !> The sums of all columns at tau > 0.
    pure function early_part(coefficients, tau) result(values)
        !> (early_terms, columns)
        real(wp), intent(in) :: coefficients(:, :), tau
        real(wp) :: values(size(coefficients, 2))
        real(wp) :: row(early_terms)
        integer :: j

        row = powers(tau)
        values = [(sum(row*coefficients(:, j)), j=1, size(values))]
    end function early_part

    !> Coefficients by least squares, of values divided by sqrt(tau).
    subroutine fit_early(tau, values, coefficients, error)
        !> > 0
        real(wp), intent(in) :: tau(:)
        !> (time, column): what changed since the step
        real(wp), intent(in) :: values(:, :)
        !> (early_terms, column)
        real(wp), intent(out) :: coefficients(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: a(size(tau), early_terms), b(size(tau), size(values, 2)), work(64*early_terms)
        integer :: i, info

        coefficients = 0.0_wp
        if (allocated(error)) return
        do i = 1, size(tau)
            a(i, :) = powers(tau(i))/sqrt(tau(i))
            b(i, :) = values(i, :)/sqrt(tau(i))
        end do
        call dgels("N", size(tau), early_terms, size(b, 2), a, size(tau), b, size(tau), work, size(work), info)
        if (info /= 0) call raise(error, error_no_convergence, "the early responses of a gel were not found")
        coefficients = b(:early_terms, :)
    end subroutine fit_early

end module mdrcontact_poroelastic_early
