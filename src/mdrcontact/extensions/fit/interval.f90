! SPDX-License-Identifier: GPL-3.0-or-later
!> Profile-likelihood intervals: the range of one parameter, all others refitted, before the sum of squares rises by its quantile.
module mdrcontact_fit_interval
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_object, only: room
    use mdrcontact_nonfinite, only: infinity, is_finite
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_made, check_memory, count_text, error_invalid, error_memory, error_no_convergence, error_t, &
                                raise, to_text
    use mdrcontact_fit, only: fit_result_t, solve_fit
    use mdrcontact_fit_problem, only: ascending_points, fit_data_t, fit_problem_t, joint_priors, values_of
    use mdrcontact_fit_predict, only: predict
    use mdrcontact_fit_residuals, only: bent
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: profile_interval, interval_quantile

    !> Tolerance of the rise of the sum of squares at the threshold, in its square root.
    real(wp), parameter :: tolerance = 1.0e-3_wp
    integer, parameter :: most_steps = 40
    !> So many standard errors away the sum of squares has not risen enough: there is no end on this side.
    real(wp), parameter :: farthest = 1.0e3_wp

    interface
        function gsl_cdf_ugaussian_pinv(p) result(x) bind(C, name="gsl_cdf_ugaussian_Pinv")
            import :: c_double
            real(c_double), value :: p
            real(c_double) :: x
        end function gsl_cdf_ugaussian_pinv

        function gsl_cdf_tdist_pinv(p, nu) result(x) bind(C, name="gsl_cdf_tdist_Pinv")
            import :: c_double
            real(c_double), value :: p, nu
            real(c_double) :: x
        end function gsl_cdf_tdist_pinv
    end interface

contains

    !> Half the width of a confidence interval in standard errors: the quantile of Student's t.
    subroutine interval_quantile(level, degrees_of_freedom, factor, error)
        !> of confidence, 0 < level < 1
        real(wp), intent(in) :: level
        !> > 0; infinite where the standard deviations of the data are known: the normal distribution
        real(wp), intent(in) :: degrees_of_freedom
        !> [1]
        real(wp), intent(out) :: factor
        type(error_t), allocatable, intent(out) :: error

        factor = 0.0_wp
        if (.not. (level > 0.0_wp .and. level < 1.0_wp)) then
            call raise(error, error_invalid, " = "//to_text(level)//": it must be greater than 0 and less than 1", "level")
        else if (.not. degrees_of_freedom > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(degrees_of_freedom)//": it must be greater than 0", &
                       "degrees_of_freedom")
        else if (degrees_of_freedom > huge(1.0_wp)) then
            factor = gsl_cdf_ugaussian_pinv(0.5_wp*(1.0_wp + level))
        else
            call disable_gsl_abort()
            factor = gsl_cdf_tdist_pinv(0.5_wp*(1.0_wp + level), degrees_of_freedom)
        end if
        ! at p = 1/2 and few degrees of freedom GSL's is below 0
        if (.not. (is_finite(factor) .and. factor >= 0.0_wp)) then
            call raise(error, error_no_convergence, "the quantile at level = "//to_text(level)//" for degrees_of_freedom = "// &
                       to_text(degrees_of_freedom)//" is not found or not finite")
        end if
    end subroutine interval_quantile

    !> The interval of one free parameter in which the sum of squares rises by less than the quantile of `level`. An end that lies
    !> beyond a bound is the bound; one that does not exist is infinite.
    subroutine profile_interval(problem, data, fit, position, level, lower, upper, error)
        type(fit_problem_t), intent(in) :: problem
        type(fit_data_t), intent(in) :: data
        !> the result of solve_fit for the same problem and data
        type(fit_result_t), intent(in) :: fit
        !> among all parameters; it must be free
        integer, intent(in) :: position
        !> of confidence, 0 < level < 1
        real(wp), intent(in) :: level
        !> ends of the interval, in the unit of the parameter; infinite if it does not exist
        real(wp), intent(out) :: lower, upper
        type(error_t), allocatable, intent(out) :: error
        type(fit_problem_t) :: fixed
        type(fit_data_t) :: weighted
        real(wp) :: threshold, best, step, freedom
        integer :: i, stat

        lower = 0.0_wp
        upper = 0.0_wp
        call check_made(error, "problem", problem%body%is_made)
        if (allocated(error)) return
        if (.not. any(fit%free == position)) call raise(error, error_invalid, "parameter "//count_text(position)// &
                                                        ": it is not free, so it has no interval. Choose a free parameter")
        if (allocated(error)) return
        i = findloc(fit%free, position, dim=1)
        freedom = fit%degrees_of_freedom
        if (allocated(data%sd) .and. problem%sd_is_absolute) freedom = infinity
        call interval_quantile(level, freedom, threshold, error)
        if (allocated(error)) return
        ! correlated residuals weigh less than as many independent ones
        threshold = threshold*fit%widening(i)
        ! the noise stays that of the best fit
        call room(data%bytes(), error)
        if (allocated(error)) return
        weighted = data
        if (.not. allocated(weighted%sd)) then
            allocate (weighted%sd(size(data%x)), stat=stat)
            call check_memory(error, stat)
            if (allocated(error)) return
            weighted%sd(:) = 1.0_wp
        end if
        weighted%sd(:) = weighted%sd*fit%noise
        fixed = problem
        fixed%sd_is_absolute = .true.
        fixed%check_units = .false.
        fixed%parameters%value = fit%values
        call find_objective(fixed, weighted, position, fit%values(position), best, error)
        fixed%parameters(position)%is_free = .false.
        step = sqrt(fit%covariance(i, i))/fit%widening(i)
        if (.not. step > 0.0_wp) step = 0.01_wp*max(abs(fit%values(position)), tiny(1.0_wp))
        call find_end(fixed, weighted, position, fit%values(position), -step, threshold, best, &
                      problem%parameters(position)%lower, lower, error)
        call find_end(fixed, weighted, position, fit%values(position), step, threshold, best, &
                      problem%parameters(position)%upper, upper, error)
        ! until here a model that was not computed to its end was without a value
        call check_cancelled(error)
    end subroutine profile_interval

    !> One end: secant steps on the root of the rise, which is nearly a straight line, held in a bracket.
    subroutine find_end(problem, data, position, centre, direction, threshold, best, bound, p, error)
        type(fit_problem_t), intent(inout) :: problem
        type(fit_data_t), intent(in) :: data
        integer, intent(in) :: position
        real(wp), intent(in) :: centre, direction, threshold, best, bound
        real(wp), intent(out) :: p
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: inner, outer, t, total, rise, inner_rise, limit
        integer :: i

        limit = farthest*threshold
        if (abs(bound) < huge(1.0_wp)) limit = min(limit, max((bound - centre)/direction, 0.0_wp))
        inner = 0.0_wp
        inner_rise = 0.0_wp
        outer = -1.0_wp
        t = min(threshold, limit)
        p = centre
        do i = 1, most_steps
            p = centre + t*direction
            call find_objective(problem, data, position, p, total, error)
            if (allocated(error)) return
            rise = sqrt(max(total - best, 0.0_wp))
            if (abs(rise - threshold) <= tolerance*threshold) return
            if (rise > threshold) then
                outer = t
            else
                if (t >= limit) exit
                inner = t
                inner_rise = rise
            end if
            if (outer < 0.0_wp) then
                t = min(merge(min(1.1_wp*t*threshold/rise, 3.0_wp*t), 3.0_wp*t, rise > 0.05_wp*threshold), limit)
            else if (rise > threshold .and. rise < 1.0e6_wp .and. mod(i, 3) /= 0) then
                t = inner + (outer - inner)*(threshold - inner_rise)/(rise - inner_rise)
            else
                t = 0.5_wp*(inner + outer)
            end if
            if (outer > 0.0_wp .and. outer - inner <= 1.0e-6_wp*outer) return
        end do
        if (t < limit) return
        if (abs(bound) < huge(1.0_wp) .and. limit < farthest*threshold) then
            p = bound
        else
            p = infinity
            if (direction < 0.0_wp) p = -infinity
        end if
    end subroutine find_end

    !> The lowest sum of squares, priors included, with one parameter held; huge where the model has no value. After an error
    !> nothing.
    subroutine find_objective(problem, data, position, p, total, error)
        type(fit_problem_t), intent(in) :: problem
        type(fit_data_t), intent(in) :: data
        integer, intent(in) :: position
        real(wp), intent(in) :: p
        real(wp), intent(out) :: total
        !> not enough memory
        type(error_t), allocatable, intent(inout) :: error
        type(fit_problem_t) :: held
        type(fit_result_t) :: fit
        type(error_t), allocatable :: failure
        real(wp), allocatable :: y(:)
        integer, allocatable :: order(:)
        integer :: stat

        total = 1.0e12_wp
        if (allocated(error)) return
        held = problem
        held%parameters(position)%value = p
        held%parameters(position)%is_free = .false.
        if (any(held%parameters%is_free)) then
            call solve_fit(held, data, fit, failure)
            if (.not. allocated(failure)) total = sum(bent(held%loss, held%loss_scale, fit%residuals)**2) &
                                                  + fit%prior_chi_square
        else
            allocate (y(size(data%x)), stat=stat)
            call check_memory(failure, stat)
            call ascending_points(data, order, failure)
            if (.not. allocated(failure)) call predict(held, values_of(held%parameters), data, y, failure, order=order)
            if (.not. allocated(failure)) total = sum(bent(held%loss, held%loss_scale, (data%y - y)/data%sd)**2) &
                                                  + sum(joint_priors(held, values_of(held%parameters))**2)
        end if
        if (allocated(failure)) then
            if (failure%code == error_memory) call move_alloc(failure, error)
            return
        end if
        associate (parameter => held%parameters(position))
            if (parameter%prior_sd > 0.0_wp) total = total + ((p - parameter%prior)/parameter%prior_sd)**2
        end associate
    end subroutine find_objective

end module mdrcontact_fit_interval
