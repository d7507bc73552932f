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
    !> More cannot come out at the largest rho; only rounding in a direction that nothing determines would exceed it.
    real(wp), parameter :: most_widening = 20.0_wp

    !> Sums over neighbours x(i-1), x(i) along a curve, of products of each two columns: of x(1), of the rises x(i) - x(i-1), of
    !> rises with x(i-1), both ways, and of x(i-1). From them come the products of whitened columns for any rho, without loss of
    !> digits where columns are smooth.
    type :: neighbours_t
        real(wp), allocatable :: first(:, :), rises(:, :), mixed(:, :), before(:, :)
    end type neighbours_t

contains

    !> The mean rho, and the factor by which the standard error of each parameter is larger than for independent noise, at least 1.
    subroutine correlated_spread(r, jacobian, order, prior_r, prior_jacobian, inverse, noise_is_known, rho, widening)
        !> residuals of the data in their standard deviations
        real(wp), intent(in) :: r(:)
        !> (residuals, parameters): their derivatives
        real(wp), intent(in) :: jacobian(:, :)
        !> the data along the curve
        integer, intent(in) :: order(:)
        !> the same of what is known beforehand, whose errors are independent
        real(wp), intent(in) :: prior_r(:), prior_jacobian(:, :)
        !> covariance of the parameters for independent noise, priors included
        real(wp), intent(in) :: inverse(:, :)
        !> whether the residuals would have variance 1
        logical, intent(in) :: noise_is_known
        real(wp), intent(out) :: rho
        !> one for each parameter
        real(wp), intent(out) :: widening(:)
        type(neighbours_t) :: sums
        real(wp) :: likelihood(values), variance(values), weight(values), middle(size(jacobian, 2), size(jacobian, 2))
        real(wp) :: spread(size(jacobian, 2), size(jacobian, 2))
        integer :: i, p, n

        rho = 0.0_wp
        widening = 1.0_wp
        n = size(order)
        p = size(jacobian, 2)
        if (n + size(prior_r) < p + fewest_contrasts .or. .not. sum(r(:n)**2) > 0.0_wp) return
        sums = neighbours_of(r, jacobian, order)
        do i = 1, values
            call restricted_likelihood(sums, n, prior_r, prior_jacobian, (i - 1)*spacing, noise_is_known, likelihood(i), &
                                       variance(i))
        end do
        weight = exp(likelihood - maxval(likelihood))
        weight = weight/sum(weight)
        middle = 0.0_wp
        do i = 1, values
            if (weight(i) < 1.0e-6_wp) cycle
            rho = rho + weight(i)*(i - 1)*spacing
            middle = middle + weight(i)*variance(i)*correlated(jacobian, order, (i - 1)*spacing)
        end do
        ! inverse = (independent + priors)^-1; the priors stay as they are
        spread = inverse + matmul(inverse, matmul(middle - correlated(jacobian, order, 0.0_wp), inverse))
        do i = 1, p
            if (inverse(i, i) > 0.0_wp) widening(i) = min(sqrt(max(spread(i, i)/inverse(i, i), 1.0_wp)), most_widening)
        end do
    end subroutine correlated_spread

    !> The sums for [jacobian, r] along the curve.
    pure function neighbours_of(r, jacobian, order) result(self)
        real(wp), intent(in) :: r(:), jacobian(:, :)
        integer, intent(in) :: order(:)
        type(neighbours_t) :: self
        real(wp) :: before(size(jacobian, 2) + 1), rise(size(jacobian, 2) + 1)
        integer :: i, j, q

        q = size(before)
        allocate (self%first(q, q), self%rises(q, q), self%mixed(q, q), self%before(q, q))
        self%rises = 0.0_wp
        self%mixed = 0.0_wp
        self%before = 0.0_wp
        before = [jacobian(order(1), :), r(order(1))]
        do j = 1, q
            self%first(:, j) = before*before(j)
        end do
        do i = 2, size(order)
            rise = [jacobian(order(i), :), r(order(i))] - before
            do j = 1, q
                self%rises(:, j) = self%rises(:, j) + rise*rise(j)
                self%mixed(:, j) = self%mixed(:, j) + rise*before(j) + before*rise(j)
                self%before(:, j) = self%before(:, j) + before*before(j)
            end do
            before = before + rise
        end do
    end function neighbours_of

    !> ln of the restricted likelihood but for a constant, and the variance of the noise at that rho. A parameter that is known
    !> beforehand takes no contrast from the data: its prior is one datum more, outside of the autoregression.
    subroutine restricted_likelihood(sums, n, prior_r, prior_jacobian, rho, noise_is_known, likelihood, variance)
        type(neighbours_t), intent(in) :: sums
        !> data
        integer, intent(in) :: n
        real(wp), intent(in) :: prior_r(:), prior_jacobian(:, :), rho
        logical, intent(in) :: noise_is_known
        real(wp), intent(out) :: likelihood, variance
        type(spectrum_t) :: spectrum
        real(wp) :: white(size(sums%first, 1), size(sums%first, 1)), g(size(sums%first, 1) - 1), rest, logarithm
        integer :: p, contrasts
        logical :: determined(size(sums%first, 1) - 1)

        p = size(g)
        ! of independent noise z(1) = x(1), z(i) = (x(i) - rho x(i-1))/sqrt(1 - rho^2), x(i) = x(i-1) + rise
        white = sums%first + (sums%rises + (1.0_wp - rho)*sums%mixed + (1.0_wp - rho)**2*sums%before)/(1.0_wp - rho**2)
        spectrum = new_spectrum(white(:p, :p) + matmul(transpose(prior_jacobian), prior_jacobian))
        determined = spectrum%eigenvalues > smallest_eigenvalue
        g = white(:p, p + 1) + matmul(transpose(prior_jacobian), prior_r)
        g = matmul(transpose(spectrum%vectors), g/spectrum%scale)
        rest = white(p + 1, p + 1) + sum(prior_r**2) &
               - sum(g**2/max(spectrum%eigenvalues, smallest_eigenvalue), mask=determined)
        rest = max(rest, tiny(1.0_wp))
        contrasts = n + size(prior_r) - count(determined)
        logarithm = sum(log(max(spectrum%eigenvalues, smallest_eigenvalue)), mask=determined) + 2.0_wp*sum(log(spectrum%scale)) &
                    + (n - 1)*log(1.0_wp - rho**2)
        variance = rest/contrasts
        if (noise_is_known) then
            variance = 1.0_wp
            likelihood = -0.5_wp*(logarithm + rest)
        else
            likelihood = -0.5_wp*(logarithm + contrasts*log(rest))
        end if
    end subroutine restricted_likelihood

    !> J^T R J with R_ij = rho^|i - j|, the data along the curve.
    pure function correlated(jacobian, order, rho) result(matrix)
        real(wp), intent(in) :: jacobian(:, :), rho
        integer, intent(in) :: order(:)
        real(wp) :: matrix(size(jacobian, 2), size(jacobian, 2))
        real(wp) :: here(size(jacobian, 2)), before(size(jacobian, 2)), lower(size(jacobian, 2), size(jacobian, 2))
        integer :: i, j

        matrix = 0.0_wp
        lower = 0.0_wp
        before = 0.0_wp
        do i = 1, size(order)
            here = jacobian(order(i), :)
            before = rho*before
            do j = 1, size(here)
                matrix(:, j) = matrix(:, j) + here*here(j)
                lower(:, j) = lower(:, j) + here*before(j)
            end do
            before = before + here
        end do
        matrix = matrix + lower + transpose(lower)
    end function correlated

end module mdrcontact_fit_correlation
