! SPDX-License-Identifier: GPL-3.0-or-later
!> Effect of correlated neighbouring residuals on intervals.
!>
!> The noise is taken as a first-order autoregression of unknown coefficient rho. Its likelihood is that of the error contrasts
!> only (restricted likelihood), which the fitted parameters do not bias: H. D. Patterson, R. Thompson, Biometrika 58 (1971) 545;
!> D. A. Harville, Biometrika 61 (1974) 383; W.-K. Cheang, G. C. Reinsel, J. Am. Stat. Assoc. 95 (2000) 1173. One best rho would
!> make intervals too short for few readings. So the distribution of an estimate is the mean over rho of Student's, each with all
!> degrees of freedom and the variance at that rho, under likelihood times prior (A. Zellner, G. C. Tiao, J. Am. Stat. Assoc. 59
!> (1964) 763). Few readings hardly limit rho. The prior is partly flat, partly a normal density about 0: noise is either correlated
!> to an unknown degree, or nearly independent, which the fewer readings support the less.
module mdrcontact_fit_correlation
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_fit_spectrum, only: new_spectrum, spectrum_t
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: correlated_spread

    !> Values of rho: -0.96, -0.94, ... 0.98.
    integer, parameter :: values = 98
    real(wp), parameter :: spacing = 0.02_wp, first = -0.96_wp
    !> Of the prior: the standard deviation of its normal part, the largest share of this part where the size of the noise is
    !> unknown and where it is known, which limits what correlation can do, and from how many contrasts.
    real(wp), parameter :: nearly = 0.25_wp, most_share = 0.7_wp, known_share = 0.2_wp
    integer, parameter :: enough_contrasts = 18
    !> A rho of less probability, relative to the best, is left out.
    real(wp), parameter :: least_weight = 1.0e-6_wp
    !> The interval that is made exact, and how well.
    real(wp), parameter :: level = 0.95_wp, reach_tolerance = 1.0e-6_wp
    integer, parameter :: most_steps = 100
    !> Directions with smaller eigenvalues, of the matrix scaled to a unit diagonal, are determined by nothing.
    real(wp), parameter :: smallest_eigenvalue = 1.0e-10_wp
    !> Fewer points and priors above the number of parameters give no information on rho.
    integer, parameter :: fewest_contrasts = 2
    !> More cannot come out at the largest rho; only rounding in a direction that nothing determines would exceed it.
    real(wp), parameter :: most_widening = 20.0_wp

    !> Sums over neighbours x(i-1), x(i) along a curve, of products of each two columns: of x(1), of the rises x(i) - x(i-1), of
    !> rises with x(i-1), both ways, and of x(i-1). From them come the products of whitened columns for any rho, without loss of
    !> digits where columns are smooth.
    type :: neighbours_t
        real(wp), allocatable :: first(:, :), rises(:, :), mixed(:, :), before(:, :)
    end type neighbours_t

    interface
        function gsl_cdf_ugaussian_q(x) result(q) bind(C, name="gsl_cdf_ugaussian_Q")
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: q
        end function gsl_cdf_ugaussian_q

        function gsl_cdf_ugaussian_qinv(q) result(x) bind(C, name="gsl_cdf_ugaussian_Qinv")
            import :: c_double
            real(c_double), value :: q
            real(c_double) :: x
        end function gsl_cdf_ugaussian_qinv

        function gsl_cdf_tdist_q(x, nu) result(q) bind(C, name="gsl_cdf_tdist_Q")
            import :: c_double
            real(c_double), value :: x, nu
            real(c_double) :: q
        end function gsl_cdf_tdist_q

        function gsl_cdf_tdist_qinv(q, nu) result(x) bind(C, name="gsl_cdf_tdist_Qinv")
            import :: c_double
            real(c_double), value :: q, nu
            real(c_double) :: x
        end function gsl_cdf_tdist_qinv
    end interface

contains

    !> The mean rho, and the factor by which the interval of each parameter is longer than for independent noise.
    subroutine correlated_spread(r, jacobian, order, prior_r, prior_jacobian, inverse, noise_is_known, freedom, rho, widening)
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
        !> degrees of freedom of the noise
        real(wp), intent(in) :: freedom
        real(wp), intent(out) :: rho
        !> one for each parameter
        real(wp), intent(out) :: widening(:)
        type(neighbours_t) :: sums
        real(wp) :: at(values), weight(values), variance(values), ratio(values, size(widening))
        real(wp) :: change(size(widening), size(widening)), independent(size(widening), size(widening))
        integer :: i, j, p, contrasts

        rho = 0.0_wp
        widening = 1.0_wp
        p = size(jacobian, 2)
        contrasts = size(order) + size(prior_r) - p
        if (contrasts < fewest_contrasts .or. .not. sum(r(:size(order))**2) > 0.0_wp) return
        at = [(first + (i - 1)*spacing, i=1, values)]
        sums = neighbours_of(r, jacobian, order)
        do i = 1, values
            call restricted_likelihood(sums, size(order), prior_r, prior_jacobian, at(i), noise_is_known, weight(i), variance(i))
        end do
        weight = weight + log(prior(at, contrasts, noise_is_known))
        weight = exp(weight - maxval(weight))
        where (weight < least_weight) weight = 0.0_wp
        weight = weight/sum(weight)
        rho = sum(weight*at)
        independent = correlated(jacobian, order, 0.0_wp)
        ratio = 1.0_wp
        do i = 1, values
            if (.not. weight(i) > 0.0_wp) cycle
            ! inverse = (independent + priors)^-1; the priors stay as they are
            change = matmul(inverse, matmul(variance(i)*correlated(jacobian, order, at(i)) - independent, inverse))
            do j = 1, p
                if (inverse(j, j) > 0.0_wp) ratio(i, j) = sqrt(max(1.0_wp + change(j, j)/inverse(j, j), 0.0_wp))
            end do
        end do
        do j = 1, p
            widening(j) = mean_reach(pack(weight, weight > 0.0_wp), pack(ratio(:, j), weight > 0.0_wp), freedom, noise_is_known)
        end do
    end subroutine correlated_spread

    !> The probability of values of rho before the data are seen.
    pure function prior(at, contrasts, noise_is_known) result(density)
        real(wp), intent(in) :: at(:)
        integer, intent(in) :: contrasts
        logical, intent(in) :: noise_is_known
        real(wp) :: density(size(at)), share

        share = merge(known_share, most_share, noise_is_known)*min(real(contrasts, wp)/enough_contrasts, 1.0_wp)
        density = exp(-0.5_wp*(at/nearly)**2)
        density = share*density/sum(density) + (1.0_wp - share)/size(at)
    end function prior

    !> Half the interval of a mean of Student's distributions, over that of one of unit width.
    function mean_reach(weight, width, freedom, noise_is_known) result(reach)
        !> of each distribution, in sum 1, and its width
        real(wp), intent(in) :: weight(:), width(:)
        real(wp), intent(in) :: freedom
        !> whether they are normal
        logical, intent(in) :: noise_is_known
        real(wp) :: reach
        real(wp) :: low, high, quantile, outside
        integer :: i, step

        call disable_gsl_abort()
        if (noise_is_known) then
            quantile = gsl_cdf_ugaussian_qinv(0.5_wp*(1.0_wp - level))
        else
            quantile = gsl_cdf_tdist_qinv(0.5_wp*(1.0_wp - level), freedom)
        end if
        low = minval(width)
        high = min(maxval(width), most_widening)
        low = min(low, high)
        reach = min(max(sum(weight*width), low), high)
        do step = 1, most_steps
            if (high - low <= reach_tolerance*high) exit
            outside = 0.0_wp
            do i = 1, size(weight)
                if (.not. width(i) > 0.0_wp) cycle
                if (noise_is_known) then
                    outside = outside + 2.0_wp*weight(i)*gsl_cdf_ugaussian_q(quantile*reach/width(i))
                else
                    outside = outside + 2.0_wp*weight(i)*gsl_cdf_tdist_q(quantile*reach/width(i), freedom)
                end if
            end do
            if (outside > 1.0_wp - level) then
                low = reach
            else
                high = reach
            end if
            reach = 0.5_wp*(low + high)
        end do
    end function mean_reach

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
