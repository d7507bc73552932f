! SPDX-License-Identifier: GPL-3.0-or-later
!> What correlation of neighbouring residuals does to standard errors.
!>
!> The noise is taken as a first-order autoregression of unknown coefficient rho. Its likelihood is that of the error contrasts
!> only (restricted likelihood), which the fitted parameters do not bias: H. D. Patterson, R. Thompson, Biometrika 58 (1971) 545;
!> D. A. Harville, Biometrika 61 (1974) 383; W.-K. Cheang, G. C. Reinsel, J. Am. Stat. Assoc. 95 (2000) 1173. The covariance of
!> the estimates is averaged over rho with that likelihood as weight: one best rho would make it too small for short records.
module mdrcontact_fit_correlation
    use mdrcontact_fit_spectrum, only: new_spectrum, spectrum_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: correlated_spread

    !> Values of rho: 0, 0.02, ... 0.98.
    integer, parameter :: values = 50
    real(wp), parameter :: spacing = 0.02_wp
    !> Directions with smaller eigenvalues, of the matrix scaled to a unit diagonal, are determined by nothing.
    real(wp), parameter :: smallest_eigenvalue = 1.0e-10_wp
    !> Fewer points and priors above the number of parameters say nothing about rho.
    integer, parameter :: fewest_contrasts = 5
    !> More cannot come out at the largest rho; only rounding in a direction that nothing determines would say so.
    real(wp), parameter :: most_widening = 20.0_wp

contains

    !> The mean rho, and by how much the standard error of each parameter is larger than for independent noise, at least 1.
    subroutine correlated_spread(r, jacobian, prior_r, prior_jacobian, inverse, noise_is_known, rho, widening)
        !> residuals of the data in their standard deviations, in their order along the curve
        real(wp), intent(in) :: r(:)
        !> (residuals, parameters): their derivatives
        real(wp), intent(in) :: jacobian(:, :)
        !> the same of what is known beforehand, whose errors are independent
        real(wp), intent(in) :: prior_r(:), prior_jacobian(:, :)
        !> covariance of the parameters for independent noise, priors included
        real(wp), intent(in) :: inverse(:, :)
        !> whether the residuals would have variance 1
        logical, intent(in) :: noise_is_known
        real(wp), intent(out) :: rho
        !> one for each parameter
        real(wp), intent(out) :: widening(:)
        real(wp) :: likelihood(values), variance(values), weight(values), middle(size(jacobian, 2), size(jacobian, 2))
        real(wp) :: independent(size(jacobian, 2), size(jacobian, 2)), spread(size(jacobian, 2), size(jacobian, 2))
        integer :: i, p, n

        rho = 0.0_wp
        widening = 1.0_wp
        n = size(r)
        p = size(jacobian, 2)
        if (n + size(prior_r) < p + fewest_contrasts .or. .not. sum(r**2) > 0.0_wp) return
        do i = 1, values
            call restricted_likelihood(r, jacobian, prior_r, prior_jacobian, (i - 1)*spacing, noise_is_known, likelihood(i), &
                                       variance(i))
        end do
        weight = exp(likelihood - maxval(likelihood))
        weight = weight/sum(weight)
        middle = 0.0_wp
        do i = 1, values
            if (weight(i) < 1.0e-6_wp) cycle
            rho = rho + weight(i)*(i - 1)*spacing
            middle = middle + weight(i)*variance(i)*matmul(transpose(jacobian), correlated(jacobian, (i - 1)*spacing))
        end do
        ! inverse = (independent + priors)^-1; the priors stay as they are
        independent = matmul(transpose(jacobian), jacobian)
        spread = inverse + matmul(inverse, matmul(middle - independent, inverse))
        do i = 1, p
            if (inverse(i, i) > 0.0_wp) widening(i) = min(sqrt(max(spread(i, i)/inverse(i, i), 1.0_wp)), most_widening)
        end do
    end subroutine correlated_spread

    !> ln of the restricted likelihood but for a constant, and the variance of the noise at that rho. A parameter that is known
    !> beforehand takes no contrast from the data: its prior is one datum more, outside of the autoregression.
    subroutine restricted_likelihood(r, jacobian, prior_r, prior_jacobian, rho, noise_is_known, likelihood, variance)
        real(wp), intent(in) :: r(:), jacobian(:, :), prior_r(:), prior_jacobian(:, :), rho
        logical, intent(in) :: noise_is_known
        real(wp), intent(out) :: likelihood, variance
        type(spectrum_t) :: spectrum
        real(wp) :: z(size(r)), columns(size(r), size(jacobian, 2)), g(size(jacobian, 2)), rest, logarithm
        integer :: j, contrasts
        logical :: determined(size(jacobian, 2))

        z = whitened(r, rho)
        do j = 1, size(jacobian, 2)
            columns(:, j) = whitened(jacobian(:, j), rho)
        end do
        spectrum = new_spectrum(matmul(transpose(columns), columns) + matmul(transpose(prior_jacobian), prior_jacobian))
        determined = spectrum%eigenvalues > smallest_eigenvalue
        g = matmul(transpose(columns), z) + matmul(transpose(prior_jacobian), prior_r)
        g = matmul(transpose(spectrum%vectors), g/spectrum%scale)
        rest = sum(z**2) + sum(prior_r**2) - sum(g**2/max(spectrum%eigenvalues, smallest_eigenvalue), mask=determined)
        rest = max(rest, tiny(1.0_wp))
        contrasts = size(r) + size(prior_r) - count(determined)
        logarithm = sum(log(max(spectrum%eigenvalues, smallest_eigenvalue)), mask=determined) + 2.0_wp*sum(log(spectrum%scale)) &
                    + (size(r) - 1)*log(1.0_wp - rho**2)
        variance = rest/contrasts
        if (noise_is_known) then
            variance = 1.0_wp
            likelihood = -0.5_wp*(logarithm + rest)
        else
            likelihood = -0.5_wp*(logarithm + contrasts*log(rest))
        end if
    end subroutine restricted_likelihood

    !> Independent noise from that of an autoregression.
    pure function whitened(x, rho) result(z)
        real(wp), intent(in) :: x(:), rho
        real(wp) :: z(size(x))

        z(1) = x(1)
        z(2:) = (x(2:) - rho*x(:size(x) - 1))/sqrt(1.0_wp - rho**2)
    end function whitened

    !> R x with R_ij = rho^|i - j|, column by column.
    pure function correlated(x, rho) result(y)
        real(wp), intent(in) :: x(:, :), rho
        real(wp) :: y(size(x, 1), size(x, 2))
        real(wp) :: before(size(x, 2))
        integer :: i

        before = 0.0_wp
        do i = 1, size(x, 1)
            before = x(i, :) + rho*before
            y(i, :) = before
        end do
        before = 0.0_wp
        do i = size(x, 1), 1, -1
            y(i, :) = y(i, :) + rho*before
            before = x(i, :) + rho*before
        end do
    end function correlated

end module mdrcontact_fit_correlation
