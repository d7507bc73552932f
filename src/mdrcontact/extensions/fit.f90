! SPDX-License-Identifier: GPL-3.0-or-later
!> The inversion: from measured data to the numbers of indenter, medium and instrument, with their uncertainty.
!>
!> Nonlinear least squares of the forward model that computes contacts, over GSL's trust region. A value known beforehand enters as
!> one more datum, and with it its uncertainty into that of everything else.
module mdrcontact_fit
    use mdrcontact_error, only: check_made, check_memory, error_cancelled, error_invalid, error_t, explain, raise
    use mdrcontact_fit_correlation, only: correlated_spread
    use mdrcontact_fit_least_squares, only: minimize, outcome_t
    use mdrcontact_fit_problem, only: check_data, check_problem, fit_data_t, fit_problem_t, loss_linear
    use mdrcontact_fit_proportional, only: divide_modulus
    use mdrcontact_fit_residuals, only: bend_slope, bent, fit_residuals_t, new_fit_residuals
    use mdrcontact_fit_order, only: median
    use mdrcontact_fit_pattern, only: difference_test, pattern_test
    use mdrcontact_fit_spectrum, only: new_spectrum, products, spectrum_t
    use mdrcontact_fit_variables, only: new_variables, variables_t
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: fit_result_t, solve_fit

    !> Rounds in which unknown noise and estimates are brought into agreement.
    integer, parameter :: most_rounds = 12
    real(wp), parameter :: noise_tolerance = 1.0e-3_wp
    !> Fewer residuals are tested for a pattern with their exact distribution, whose cost grows with the cube of their number.
    integer, parameter :: few_points = 50
    !> Median of |z| of a normal distribution.
    real(wp), parameter :: normal_median = 0.6744897501960817_wp
    integer, parameter :: most_releases = 5
    !> A parameter that moves the readings by less than this, in parts of them where it changes by all of itself, is rounding.
    real(wp), parameter :: least_felt = 1.0e-8_wp
    !> Searches, each around where the one before ended, for a parameter that runs to the end of what is tried around its start.
    integer, parameter :: most_centres = 4
    !> Searches with the errors of readings that enter the model propagated at the point found before.
    integer, parameter :: propagation_rounds = 3
    real(wp), parameter :: wrong_units = 300.0_wp

    !> The result of a fit: estimates, their uncertainty, and what supports them or makes them doubtful.
    type :: fit_result_t
        !> the best point found, all numbers of the problem
        real(wp), allocatable :: values(:)
        !> positions of the free ones
        integer, allocatable :: free(:)
        !> of the free ones; where the data do not determine a combination of them, `weakest` = 0, its variance is not determined:
        !> standard errors of about a thousand times the values
        real(wp), allocatable :: covariance(:, :)
        !> of the free ones: -1 or 1 where the estimate lies at its lower or upper bound, whose covariance is then 0
        integer, allocatable :: at_bound(:)
        !> smallest eigenvalue of the correlation of the derivatives (1: independent; 0: a combination is not determined) and
        !> the relative change of the free numbers that goes with it
        real(wp) :: weakest = 1.0_wp
        !> see `weakest`; one entry for each free number
        real(wp), allocatable :: weakest_direction(:)
        !> the model at the data, and (y - model)/standard deviation
        real(wp), allocatable :: fitted(:), residuals(:)
        !> factor of the standard deviations of the data: 1 if they are known, else estimated
        real(wp) :: noise = 1.0_wp
        !> sum of the squared residuals of the data, and of the priors
        real(wp) :: chi_square = 0.0_wp, prior_chi_square = 0.0_wp
        !> data less the parameters that they determine
        real(wp) :: degrees_of_freedom = 0.0_wp
        !> of the data and the priors at the estimates
        real(wp) :: log_likelihood = 0.0_wp
        !> probability that random residuals follow each other as smoothly along the curve
        real(wp) :: pattern_probability = 1.0_wp
        !> correlation of neighbouring residuals along the curve, and the factor of the standard error of each free number that
        !> allows for it, which the covariance holds already
        real(wp) :: lag_correlation = 0.0_wp
        !> see `lag_correlation`
        real(wp), allocatable :: widening(:)
        !> if not, the numbers are the best point found
        logical :: converged = .false.
        !> steps of the search
        integer :: iterations = 0
        !> how often the forward model was computed at all data
        integer :: evaluations = 0
    end type fit_result_t

contains

    !> Fits. An error means that there was nothing to fit; a search that did not converge returns its best point with `converged`
    !> false.
    subroutine solve_fit(problem, data, fit, error)
        type(fit_problem_t), intent(in) :: problem
        type(fit_data_t), intent(in), target :: data
        type(fit_result_t), intent(out) :: fit
        type(error_t), allocatable, intent(out) :: error
        type(fit_problem_t) :: centred
        type(variables_t) :: variables
        type(fit_residuals_t) :: residuals
        type(outcome_t) :: outcome
        real(wp), allocatable :: u(:)
        logical, allocatable :: lost(:)
        integer :: round, i

        call check_made(error, "problem", problem%body%is_made)
        if (.not. allocated(error)) call check_problem(problem, error)
        if (.not. allocated(error)) call check_data(data, problem, error)
        if (allocated(error)) return
        centred = problem
        call divide_modulus(centred, data, error)
        if (allocated(error)) return
        allocate (lost(0))
        do round = 1, most_centres
            call new_variables(variables, centred, data, error)
            if (allocated(error)) return
            call new_fit_residuals(residuals, centred, data, variables, error)
            if (allocated(error)) return
            residuals%evaluations = fit%evaluations
            u = spread(1.0_wp, 1, size(variables%free))
            if (problem%check_units .and. round == 1) call check_units_at_start(residuals, u, error)
            if (allocated(error)) return
            call agree_with_noise(residuals, u, outcome, fit, error)
            if (allocated(error)) return
            ! begun too far away: on from where the search ended
            lost = variables%ran_off([(i, i=1, size(u))], u)
            if (.not. any(lost)) exit
            centred%parameters%value = residuals%values_at(u)
        end do
        ! no minimum was found, and the value is only the start of the search
        if (any(lost)) outcome%converged = .false.
        call describe(residuals, u, outcome, fit, error)
    end subroutine solve_fit

    !> Refuses data that no reasonable start is so far away from.
    subroutine check_units_at_start(residuals, u, error)
        type(fit_residuals_t), intent(inout) :: residuals
        real(wp), intent(in) :: u(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: y(:)
        real(wp) :: ratio
        integer :: stat

        allocate (y(size(residuals%data%x)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call residuals%fitted(u, y, error)
        if (allocated(error)) then
            if (error%code == error_cancelled) return
            call explain(error, "the model fails at the start of the search: ", ". Check the units of the data and the "// &
                         "starting values")
            return
        end if
        if (.not. norm2(y) > 0.0_wp) then
            call raise(error, error_invalid, "at the start of the search no point is in contact. Check depth_offset, the "// &
                       "depth at initial contact, and the sign of the depths")
            return
        end if
        ratio = norm2(residuals%data%y)/norm2(y)
        if (ratio <= wrong_units .and. ratio >= 1.0_wp/wrong_units) return
        call raise(error, error_invalid, "the data are "//trim(rounded(ratio))//" times the model at the start of the search. "// &
                   "Check the units of the data and depth_offset, or start closer")
    end subroutine check_units_at_start

    !> A ratio as text, two digits.
    function rounded(value) result(text)
        real(wp), intent(in) :: value
        character(len=12) :: text

        write (text, "(es8.1)") value
        text = adjustl(text)
    end function rounded

    !> Searches; where the noise is unknown and matters for the estimates, again until both agree.
    subroutine agree_with_noise(residuals, u, outcome, fit, error)
        type(fit_residuals_t), intent(inout) :: residuals
        real(wp), intent(inout) :: u(:)
        type(outcome_t), intent(out) :: outcome
        type(fit_result_t), intent(inout) :: fit
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: noise
        logical :: known, propagates
        integer :: round

        known = allocated(residuals%data%sd) .and. residuals%problem%sd_is_absolute
        if (.not. known) residuals%noise = 0.01_wp*norm2(residuals%data%y/residuals%sd)/sqrt(real(size(residuals%sd), wp))
        propagates = residuals%readings_enter_model()
        do round = 1, most_rounds
            if (propagates .and. round <= propagation_rounds) call residuals%propagate_readings(u, error)
            if (allocated(error)) return
            residuals%readings_norm = norm2(residuals%data%y/(residuals%sd*residuals%noise))
            call search(residuals, u, outcome, fit, error)
            if (allocated(error)) return
            if (propagates .and. round < propagation_rounds) cycle
            if (known) return
            call find_noise(residuals, u, outcome, noise, error)
            if (allocated(error)) return
            if (.not. noise > 0.0_wp) return
            if (abs(noise - residuals%noise) <= noise_tolerance*residuals%noise) return
            call rescale(residuals, outcome, residuals%noise/noise)
            residuals%noise = noise
            if (residuals%n == size(residuals%data%x) .and. residuals%loss == loss_linear) return
        end do
    end subroutine agree_with_noise

    !> Data residuals in units of another noise.
    pure subroutine rescale(residuals, outcome, factor)
        type(fit_residuals_t), intent(in) :: residuals
        type(outcome_t), intent(inout) :: outcome
        real(wp), intent(in) :: factor

        associate (n => size(residuals%data%x))
            outcome%r(:n) = outcome%r(:n)*factor
            outcome%jacobian(:n, :) = outcome%jacobian(:n, :)*factor
        end associate
    end subroutine rescale

    !> One search. A parameter that ended at a bound but would move inside is freed again.
    subroutine search(residuals, u, outcome, fit, error)
        type(fit_residuals_t), intent(inout) :: residuals
        real(wp), intent(inout) :: u(:)
        type(outcome_t), intent(out) :: outcome
        type(fit_result_t), intent(inout) :: fit
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: r(:), inside(:)
        real(wp) :: moved(size(u)), step
        integer :: round, i, side, stat
        logical :: released

        allocate (r(residuals%n), inside(residuals%n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do round = 1, most_releases
            call minimize(residuals, u, residuals%problem%max_iterations, outcome, error)
            if (allocated(error)) return
            fit%iterations = fit%iterations + outcome%iterations
            released = .false.
            do i = 1, size(u)
                side = residuals%variables%is_outside(i, u(i))
                if (side == 0) cycle
                u(i) = residuals%variables%unknown_of(i, residuals%variables%number_at(i, u(i)))
                step = 1.0e-4_wp*side
                moved = u
                moved(i) = u(i) - step
                call residuals%evaluate(u, r)
                call residuals%evaluate(moved, inside)
                if (allocated(residuals%error)) cycle
                if (sum(inside**2) < sum(r**2)*(1.0_wp - 1.0e-10_wp)) then
                    u(i) = u(i) - 10.0_wp*step
                    released = .true.
                end if
            end do
            if (.not. released) exit
        end do
        if (released) outcome%converged = .false.
        fit%evaluations = residuals%evaluations
    end subroutine search

    !> The noise that the residuals show: their mean square over the degrees of freedom, or their median under a robust loss.
    subroutine find_noise(residuals, u, outcome, noise, error)
        type(fit_residuals_t), intent(inout) :: residuals
        real(wp), intent(in) :: u(:)
        type(outcome_t), intent(in) :: outcome
        real(wp), intent(out) :: noise
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: z(:)
        integer :: stat

        noise = 0.0_wp
        allocate (z(size(residuals%data%x)), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) call residuals%fitted(u, z, error)
        if (allocated(error)) return
        z(:) = abs(residuals%data%y - z)/residuals%sd
        if (residuals%loss == loss_linear) then
            noise = sqrt(sum(z**2)/degrees_of_freedom(residuals, outcome))
        else
            call median(z, noise)
            noise = noise/normal_median
        end if
    end subroutine find_noise

    !> Data less the parameters that they, and not the priors, determine: n - trace(H_data (H_data + H_prior)^-1).
    function degrees_of_freedom(residuals, outcome) result(dof)
        type(fit_residuals_t), intent(in) :: residuals
        type(outcome_t), intent(in) :: outcome
        real(wp) :: dof
        type(spectrum_t) :: spectrum
        real(wp) :: of_data(residuals%p, residuals%p), shares(residuals%p, residuals%p)
        integer :: i

        associate (n => size(residuals%data%x))
            spectrum = new_spectrum(products(outcome%jacobian))
            of_data = products(outcome%jacobian(:n, :))
            shares = matmul(of_data, spectrum%inverse())
            dof = n - sum([(min(1.0_wp, max(0.0_wp, shares(i, i))), i=1, residuals%p)])
            dof = max(dof, 0.5_wp)
        end associate
    end function degrees_of_freedom

    !> The statistics of the point found.
    subroutine describe(residuals, u, outcome, fit, error)
        type(fit_residuals_t), intent(inout) :: residuals
        real(wp), intent(in) :: u(:)
        type(outcome_t), intent(in) :: outcome
        type(fit_result_t), intent(inout) :: fit
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: data_sd(:), along(:)
        integer, allocatable :: inner(:)
        integer :: i, n, stat

        n = size(residuals%data%x)
        fit%converged = outcome%converged
        fit%free = residuals%variables%free
        fit%values = residuals%values_at(u)
        fit%noise = residuals%noise
        fit%at_bound = residuals%variables%is_outside([(i, i=1, size(u))], u)
        allocate (fit%fitted(n), fit%residuals(n), data_sd(n), along(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call residuals%fitted(u, fit%fitted, error)
        if (allocated(error)) return
        data_sd(:) = residuals%sd*residuals%noise
        fit%residuals(:) = (residuals%data%y - fit%fitted)/data_sd
        fit%chi_square = sum(fit%residuals**2)
        fit%prior_chi_square = sum(outcome%r(n + 1:)**2)
        fit%degrees_of_freedom = degrees_of_freedom(residuals, outcome)
        fit%log_likelihood = -0.5_wp*(sum(bent(residuals%loss, residuals%problem%loss_scale, fit%residuals)**2) &
                                      + fit%prior_chi_square) - sum(log(data_sd)) - 0.5_wp*n*log(2.0_wp*pi)
        do i = 1, n
            along(i) = fit%residuals(residuals%order(i))
        end do
        if (residuals%loss == loss_linear .and. n < few_points) then
            inner = pack([(i, i=1, size(u))], fit%at_bound == 0)
            call difference_test(along, outcome%jacobian(residuals%order, inner), outcome%jacobian(n + 1:, inner), &
                                 fit%pattern_probability)
        else
            call pattern_test(along, fit%pattern_probability, error)
        end if
        if (.not. allocated(error)) call describe_spread(residuals, u, outcome, fit, error)
    end subroutine describe

    !> Covariance and the weakest direction.
    subroutine describe_spread(residuals, u, outcome, fit, error)
        type(fit_residuals_t), intent(in) :: residuals
        real(wp), intent(in) :: u(:)
        type(outcome_t), intent(in) :: outcome
        type(fit_result_t), intent(inout) :: fit
        type(error_t), allocatable, intent(inout) :: error
        type(spectrum_t) :: spectrum
        real(wp), allocatable :: jacobian(:, :), inverse(:, :), undetermined(:, :), slope(:), widening(:)
        integer, allocatable :: inner(:)
        integer :: i, n, stat

        n = size(residuals%data%x)
        call check_felt(residuals, outcome, fit, error)
        if (allocated(error)) return
        inner = pack([(i, i=1, size(u))], fit%at_bound == 0)
        allocate (fit%covariance(size(u), size(u)), fit%weakest_direction(size(u)))
        allocate (fit%widening(size(u)))
        fit%covariance = 0.0_wp
        fit%weakest_direction = 0.0_wp
        fit%widening = 1.0_wp
        if (size(inner) == 0) return
        allocate (jacobian(residuals%n, size(inner)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(inner)
            jacobian(:, i) = outcome%jacobian(:, inner(i))
        end do
        if (residuals%loss == loss_linear) then
            spectrum = new_spectrum(products(jacobian))
            inverse = spectrum%inverse()
        else
            call robust_covariance(residuals%loss, residuals%problem%loss_scale, fit%residuals, jacobian, spectrum, inverse, error)
            if (allocated(error)) return
        end if
        allocate (widening(size(inner)))
        call correlated_spread(outcome%r, jacobian, residuals%order, outcome%r(n + 1:), jacobian(n + 1:, :), inverse, &
                               allocated(residuals%data%sd) .and. residuals%problem%sd_is_absolute, fit%degrees_of_freedom, &
                               fit%lag_correlation, widening)
        fit%widening(inner) = widening
        slope = residuals%variables%slope_at([(i, i=1, size(u))], u)
        undetermined = spectrum%undetermined_spread()
        do i = 1, size(inner)
            fit%covariance(inner, inner(i)) = (inverse(:, i)*widening*widening(i) + undetermined(:, i))*slope(inner)*slope(inner(i))
        end do
        fit%weakest = spectrum%weakest()
        fit%weakest_direction(inner) = spectrum%vectors(:, 1)/spectrum%scale
        fit%weakest_direction = fit%weakest_direction/max(maxval(abs(fit%weakest_direction)), tiny(1.0_wp))
    end subroutine describe_spread

    !> Raises where a parameter without a prior leaves all readings as they are, as C12 does under a normal load: any value of it
    !> would be a result.
    pure subroutine check_felt(residuals, outcome, fit, error)
        type(fit_residuals_t), intent(in) :: residuals
        type(outcome_t), intent(in) :: outcome
        type(fit_result_t), intent(in) :: fit
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: least
        integer :: i, n

        n = size(residuals%data%x)
        least = least_felt*norm2(residuals%data%y/(residuals%sd*residuals%noise))
        do i = 1, size(fit%free)
            if (fit%at_bound(i) /= 0 .or. any(abs(outcome%jacobian(n + 1:, i)) > 0.0_wp)) cycle
            if (norm2(outcome%jacobian(:n, i)) > least) cycle
            call raise(error, error_invalid, ": it must not be free, because the readings do not depend on it. Fix it, or "// &
                       "give it a prior", "parameters", fit%free(i))
        end do
    end subroutine check_felt

    !> Huber's H^-1 V H^-1, and the spectrum of H.
    subroutine robust_covariance(loss, scale, z, jacobian, spectrum, inverse, error)
        integer, intent(in) :: loss
        real(wp), intent(in) :: scale
        !> residuals of the data, not bent
        real(wp), intent(in) :: z(:)
        !> of the bent residuals, those of the data first
        real(wp), intent(in) :: jacobian(:, :)
        type(spectrum_t), intent(out) :: spectrum
        real(wp), allocatable, intent(out) :: inverse(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: scores(:, :), straight(:), psi(:), psi_slope(:)
        real(wp) :: curvature
        integer :: i, n, stat

        n = size(z)
        allocate (scores(size(jacobian, 1), size(jacobian, 2)), straight(n), psi(n), psi_slope(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call bend_slope(loss, scale, z, psi, psi_slope)
        curvature = sqrt(max(sum(psi_slope)/n, 0.01_wp))
        ! the slope of a bent residual is psi/bent
        straight(:) = bent(loss, scale, z)
        do i = 1, n
            if (abs(straight(i)) > tiny(1.0_wp)) then
                straight(i) = straight(i)/psi(i)
            else
                straight(i) = 1.0_wp
            end if
        end do
        scores(:, :) = jacobian
        do i = 1, size(jacobian, 2)
            scores(:n, i) = jacobian(:n, i)*straight*curvature
        end do
        spectrum = new_spectrum(products(scores))
        inverse = spectrum%inverse()
        do i = 1, size(jacobian, 2)
            scores(:n, i) = jacobian(:n, i)*straight*psi
        end do
        ! V is the product of the scores with themselves: so no variance can be less than 0 by rounding
        do i = 1, size(scores, 1)
            scores(i, :) = matmul(scores(i, :), inverse)
        end do
        inverse = products(scores)
    end subroutine robust_covariance

end module mdrcontact_fit
