! SPDX-License-Identifier: GPL-3.0-or-later
!> A fit: the parameters of indenter, medium and instrument, and the measured data.
module mdrcontact_fit_problem
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: infinity, is_finite, is_nan
    use mdrcontact_object, only: object_t, real_bytes
    use mdrcontact_parameter, only: nature_not_negative, nature_signed, parameter_t
    use mdrcontact_codes, only: data_depth_time => fit_depth_time, data_dynamic_stiffness => fit_dynamic_stiffness, &
                                data_force_depth => fit_force_depth, data_force_time => fit_force_time, &
                                data_modulus_radius => fit_modulus_radius, data_stiffness_depth => fit_stiffness_depth, &
                                data_stiffness_radius => fit_stiffness_radius, loss_cauchy => fit_cauchy, loss_huber => fit_huber, &
                                loss_linear => fit_linear, part_loss => loss, part_storage => storage
    use mdrcontact_contact_equilibrium, only: adhesion_automatic
    use mdrcontact_error, only: check_code, check_count_from, check_finite, check_memory, check_not_negative, check_positive, &
                                count_text, error_invalid, error_t, raise, to_text
    use mdrcontact_contact, only: on_loading, on_unloading
    use mdrcontact_fit_order, only: ascending
    use mdrcontact_fit_body, only: fit_body_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: fit_problem_t, fit_parameter_t, fit_data_t, check_problem, check_data, check_points, problem_parameters, &
              start_parameters, joint_priors, ascending_points, values_of
    public :: data_force_depth, data_stiffness_depth, data_modulus_radius, data_stiffness_radius, data_force_time, &
              data_depth_time, data_dynamic_stiffness, part_storage, part_loss
    public :: loss_linear, loss_huber, loss_cauchy
    public :: at_work_of_adhesion, at_depth_offset, at_force_offset, at_frame_compliance, at_indenter_modulus, &
              at_contact_depth_factor, at_stiffness_factor, at_contact_depth_scale, at_area_factor, at_cohesive_stress, &
              instrument_numbers

    !> Positions of the instrument's parameters behind those of indenter and medium: gamma [modulus length]; depth and force at
    !> which the instrument reads first contact [length], [force]; compliance of the frame [length/force]; contact modulus E*_i of
    !> the indenter, infinite for a rigid one [modulus]; epsilon of Oliver and Pharr's contact depth h - epsilon P/S on a
    !> half-space; beta of S = 2 beta a E_r; factor of the contact depth, 1.2 with epsilon = 1 for Loubet's (N. X. Randall et al.,
    !> J. Mater. Res. 24 (2009) 679); true over assumed projected contact area; sigma_0, finite-range adhesion [modulus].
    integer, parameter :: at_work_of_adhesion = 1, at_depth_offset = 2, at_force_offset = 3, at_frame_compliance = 4, &
                          at_indenter_modulus = 5, at_contact_depth_factor = 6, at_stiffness_factor = 7, &
                          at_contact_depth_scale = 8, at_area_factor = 9, at_cohesive_stress = 10, instrument_numbers = 10

    !> The instrument's parameters, of an instrument that reads what is.
    type(parameter_t), parameter :: of_instrument(instrument_numbers) = [ &
        parameter_t("work_of_adhesion", 0.0_wp, nature_not_negative), parameter_t("depth_offset", 0.0_wp, nature_signed), &
        parameter_t("force_offset", 0.0_wp, nature_signed), parameter_t("frame_compliance", 0.0_wp, nature_signed), &
        parameter_t("indenter_modulus", infinity), parameter_t("contact_depth_factor", 0.75_wp, nature_signed), &
        parameter_t("stiffness_factor", 1.0_wp), parameter_t("contact_depth_scale", 1.0_wp), &
        parameter_t("area_factor", 1.0_wp), parameter_t("cohesive_stress", 0.0_wp, nature_not_negative)]

    !> One parameter of the problem: fixed, or free within bounds and known beforehand to a standard deviation.
    type :: fit_parameter_t
        !> the value, or where the search begins
        real(wp) :: value = 0.0_wp
        !> whether the fit may change the value
        logical :: is_free = .false.
        !> bounds of a free parameter
        real(wp) :: lower = -huge(1.0_wp), upper = huge(1.0_wp)
        !> the value known beforehand and its standard deviation; 0: nothing is known
        real(wp) :: prior = 0.0_wp, prior_sd = 0.0_wp
    end type fit_parameter_t

    !> The question of a fit: what the parameters mean, which are free, and how residuals count.
    type :: fit_problem_t
        !> indenter and medium
        type(fit_body_t) :: body
        !> one of data_...
        integer :: data_kind = data_force_depth
        !> in the order of problem_parameters; start_parameters makes them
        type(fit_parameter_t), allocatable :: parameters(:)
        !> (rows, parameters): what is known beforehand of several parameters together: sum_j w_ij (p_j - prior_j) has mean 0 and
        !> variance 1, independent of the other rows. For a covariance C = L L^T the rows are those of L^-1
        real(wp), allocatable :: prior_weights(:, :)
        !> one of adhesion_...
        integer :: adhesion_rule = adhesion_automatic
        !> of data_stiffness_depth: whether nothing has yielded, so that the indenter itself lies in the indent; else one does that
        !> sinks in by epsilon on a half-space
        logical :: is_elastic = .false.
        !> one of loss_...
        integer :: loss = loss_linear
        !> beyond how many standard deviations a residual counts less
        real(wp) :: loss_scale = 1.345_wp
        !> whether the standard deviations of the data are known, or only their ratios
        logical :: sd_is_absolute = .true.
        !> of one search, at least 1
        integer :: max_iterations = 100
        !> raises an error for data that are more than 300 times larger or smaller than the model at the start: they are in other
        !> units
        logical :: check_units = .true.
    end type fit_problem_t

    !> Measured points, in any order.
    type, extends(object_t) :: fit_data_t
        !> d or a [length], time or angular frequency [1/time]
        real(wp), allocatable :: x(:)
        !> F, k, E_eff or d, same size
        real(wp), allocatable :: y(:)
        !> the second known quantity of each point, same size; see data_...
        real(wp), allocatable :: given(:)
        !> standard deviations of y > 0, same size; not allocated: equal and unknown
        real(wp), allocatable :: sd(:)
        !> on_loading or on_unloading, same size; not allocated: all on one branch, down to pull-off. Matters with adhesion; of
        !> data_dynamic_stiffness part_storage or part_loss
        integer, allocatable :: branch(:)
    contains
        procedure :: bytes
    end type fit_data_t

contains

    !> All parameters of a problem: those of indenter, medium, counterbody, and instrument.
    pure function problem_parameters(body) result(list)
        !> of new_fit_body
        type(fit_body_t), intent(in) :: body
        type(parameter_t) :: list(count_of(body) + instrument_numbers)

        list(size(list) - instrument_numbers + 1:) = of_instrument
        if (body%is_made) list(:size(body%parameters)) = body%parameters
    end function problem_parameters

    !> The same, fixed at the values that they have.
    pure function start_parameters(body) result(parameters)
        !> of new_fit_body
        type(fit_body_t), intent(in) :: body
        type(fit_parameter_t) :: parameters(count_of(body) + instrument_numbers)
        type(parameter_t) :: list(size(parameters))

        list = problem_parameters(body)
        parameters%value = list%value
    end function start_parameters

    !> How many parameters a body has.
    pure function count_of(body) result(count)
        type(fit_body_t), intent(in) :: body
        integer :: count

        count = 0
        if (body%is_made) count = size(body%parameters)
    end function count_of

    !> Their values, one after the other.
    pure function values_of(parameters) result(values)
        type(fit_parameter_t), intent(in) :: parameters(:)
        real(wp) :: values(size(parameters))

        values = parameters%value
    end function values_of

    !> The residuals of what is known of several parameters together.
    pure function joint_priors(self, values) result(r)
        type(fit_problem_t), intent(in) :: self
        !> of all parameters
        real(wp), intent(in) :: values(:)
        real(wp), allocatable :: r(:)

        allocate (r(0))
        if (allocated(self%prior_weights)) r = matmul(self%prior_weights, merge(values - self%parameters%prior, 0.0_wp, &
                                                                                any(abs(self%prior_weights) > 0.0_wp, dim=1)))
    end function joint_priors

    !> Positions of the points by branch, and within a branch by ascending x.
    pure subroutine ascending_points(self, order, error)
        type(fit_data_t), intent(in) :: self
        integer, allocatable, intent(out) :: order(:)
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: by_x(:)
        integer :: i, branch, count, stat

        if (allocated(error)) return
        call ascending(self%x, order, error)
        if (allocated(error) .or. .not. allocated(self%branch)) return
        allocate (by_x(size(order)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        by_x(:) = order
        count = 0
        do branch = on_loading, on_unloading
            do i = 1, size(by_x)
                if (self%branch(by_x(i)) /= branch) cycle
                count = count + 1
                order(count) = by_x(i)
            end do
        end do
    end subroutine ascending_points

    !> Upper bound of the size of a copy.
    pure recursive function bytes(self)
        class(fit_data_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 5*real_bytes*size(self%x)
    end function bytes

    !> Raises unless the problem is well-formed.
    subroutine check_problem(self, error)
        type(fit_problem_t), intent(in) :: self
        type(error_t), allocatable, intent(out) :: error
        integer :: i, expected

        expected = instrument_numbers
        if (allocated(self%body%parameters)) expected = expected + size(self%body%parameters)
        if (.not. allocated(self%body%medium)) then
            call raise(error, error_invalid, "body is missing: create it with new_fit_body")
        else if (.not. allocated(self%parameters)) then
            call raise(error, error_invalid, "parameters are missing")
        else if (size(self%parameters) /= expected) then
            call raise(error, error_invalid, "there are "//count_text(size(self%parameters))// &
                       " parameters: indenter, medium and instrument together have "//count_text(expected))
        end if
        call check_code(error, "data_kind", self%data_kind, [data_force_depth, data_stiffness_depth, data_modulus_radius, &
                                                             data_stiffness_radius, data_force_time, data_depth_time, &
                                                             data_dynamic_stiffness])
        call check_code(error, "loss", self%loss, [loss_linear, loss_huber, loss_cauchy])
        call check_positive(error, "loss_scale", self%loss_scale)
        call check_count_from(error, "max_iterations", self%max_iterations, 1)
        if (allocated(self%prior_weights)) then
            if (size(self%prior_weights, 2) /= expected) then
                call raise(error, error_invalid, "prior_weights has "//count_text(size(self%prior_weights, 2))// &
                           " columns: it must have one for each of the "//count_text(expected)//" parameters")
            else if (.not. all(is_finite(self%prior_weights))) then
                call raise(error, error_invalid, "prior_weights: its entries must be finite")
            end if
        end if
        if (allocated(error)) return
        do i = 1, expected
            call check_parameter(self%parameters(i), "parameters", i, error)
        end do
    end subroutine check_problem

    subroutine check_parameter(parameter, name, i, error)
        type(fit_parameter_t), intent(in) :: parameter
        character(len=*), intent(in) :: name
        integer, intent(in) :: i
        type(error_t), allocatable, intent(inout) :: error

        if (is_nan(parameter%value)) call check_finite(error, name, parameter%value, i)
        if (.not. parameter%is_free) return
        call check_finite(error, name//": the value of a free parameter", parameter%value, i)
        call check_not_negative(error, name//": prior_sd", parameter%prior_sd, i)
        if (parameter%prior_sd > 0.0_wp) call check_finite(error, name//": prior", parameter%prior, i)
        if (allocated(error)) return
        if (.not. parameter%lower < parameter%upper) then
            call raise(error, error_invalid, ": lower = "//to_text(parameter%lower)//": it must be less than upper = "// &
                       to_text(parameter%upper), name, i)
        else if (parameter%value < parameter%lower .or. parameter%value > parameter%upper) then
            call raise(error, error_invalid, " = "//to_text(parameter%value)//": the search must begin between the bounds "// &
                       to_text(parameter%lower)//" and "//to_text(parameter%upper), name, i)
        end if
    end subroutine check_parameter

    !> Raises unless the data are numbers, enough of them for a fit, and not all the same.
    subroutine check_data(self, problem, error)
        type(fit_data_t), intent(in) :: self
        type(fit_problem_t), intent(in) :: problem
        type(error_t), allocatable, intent(out) :: error
        integer :: free, priors, fewest
        logical :: known

        call check_points(self, problem, error)
        if (allocated(error)) return
        free = count(problem%parameters%is_free)
        priors = count(problem%parameters%is_free .and. problem%parameters%prior_sd > 0.0_wp)
        if (allocated(problem%prior_weights)) priors = priors + size(problem%prior_weights, 1)
        known = allocated(self%sd) .and. problem%sd_is_absolute
        fewest = max(free - priors, 1)
        ! what the scatter of the points must show needs one more of them
        if (.not. known) fewest = fewest + 1
        if (free == 0) then
            call raise(error, error_invalid, "parameters: none is free. Free at least one")
        else if (size(self%x) < fewest) then
            call raise(error, error_invalid, "too few points: "//count_text(size(self%x))//" for "//count_text(free)// &
                       " free parameters, of which "//count_text(priors)//" have priors; at least "//count_text(fewest)// &
                       " are needed")
        else if (fewest == 1) then
            return
        else if (maxval(self%x) <= minval(self%x) .and. problem%data_kind /= data_dynamic_stiffness) then
            call raise(error, error_invalid, ": it is "//to_text(self%x(1))//" at all points, which do not determine a curve", "x")
        else if (maxval(self%y) <= minval(self%y)) then
            call raise(error, error_invalid, ": it is "//to_text(self%y(1))//" at all points, which do not determine a curve", "y")
        end if
    end subroutine check_data

    !> Raises unless each point is a point.
    subroutine check_points(self, problem, error)
        type(fit_data_t), intent(in) :: self
        type(fit_problem_t), intent(in) :: problem
        type(error_t), allocatable, intent(out) :: error
        integer :: i, allowed(2)

        if (.not. (allocated(self%x) .and. allocated(self%y))) then
            call raise(error, error_invalid, "the data are missing")
            return
        end if
        call check_column(self%y, "y", size(self%x), error)
        if (allocated(self%sd)) call check_column(self%sd, "sd", size(self%x), error)
        if (allocated(self%branch)) then
            call check_column(real(self%branch, wp), "branch", size(self%x), error)
            allowed = merge([part_storage, part_loss], [on_loading, on_unloading], problem%data_kind == data_dynamic_stiffness)
            do i = 1, size(self%branch)
                call check_code(error, "branch", self%branch(i), allowed)
            end do
        end if
        if (needs_given(problem%data_kind)) then
            if (allocated(self%given)) then
                call check_column(self%given, "given", size(self%x), error)
            else
                call raise(error, error_invalid, "given is missing: this kind of data needs a second quantity at each point")
            end if
            if (problem%data_kind == data_dynamic_stiffness .and. .not. allocated(self%branch)) then
                call raise(error, error_invalid, "branch is missing: it must select storage or loss for each point")
            end if
        end if
        if (allocated(error)) return
        if (problem%data_kind == data_force_time .or. problem%data_kind == data_depth_time) then
            do i = 2, size(self%x)
                if (self%x(i) > self%x(i - 1)) cycle
                call raise(error, error_invalid, " = "//to_text(self%x(i))//": times must be strictly ascending", "x", i)
                return
            end do
        end if
        do i = 1, size(self%x)
            if (is_good(self, problem%data_kind, i)) cycle
            call check_finite(error, "x", self%x(i), i)
            call check_finite(error, "y", self%y(i), i)
            if (x_is_positive(problem%data_kind)) call check_positive(error, "x", self%x(i), i)
            if (allocated(self%sd)) call check_positive(error, "sd", self%sd(i), i)
            if (problem%data_kind == data_stiffness_depth) call check_positive(error, "y", self%y(i), i)
            if (problem%data_kind == data_dynamic_stiffness) call check_positive(error, "given", self%given(i), i)
            if (needs_given(problem%data_kind)) call check_finite(error, "given", self%given(i), i)
            if (allocated(error)) return
        end do
    end subroutine check_points

    !> Whether a point passes; names of points are made for those that do not.
    pure function is_good(self, data_kind, i) result(answer)
        type(fit_data_t), intent(in) :: self
        integer, intent(in) :: data_kind, i
        logical :: answer

        answer = all(is_finite([self%x(i), self%y(i)]))
        if (answer .and. x_is_positive(data_kind)) answer = self%x(i) > 0.0_wp
        if (answer .and. allocated(self%sd)) answer = is_finite(self%sd(i)) .and. self%sd(i) > 0.0_wp
        if (answer .and. data_kind == data_stiffness_depth) answer = self%y(i) > 0.0_wp
        if (answer .and. needs_given(data_kind)) answer = is_finite(self%given(i))
        if (answer .and. data_kind == data_dynamic_stiffness) answer = self%given(i) > 0.0_wp
    end function is_good

    !> Whether points have a second known quantity.
    pure function needs_given(data_kind) result(answer)
        integer, intent(in) :: data_kind
        logical :: answer

        answer = any(data_kind == [data_stiffness_depth, data_force_time, data_depth_time, data_dynamic_stiffness])
    end function needs_given

    !> Whether x are radii or frequencies.
    pure function x_is_positive(data_kind) result(answer)
        integer, intent(in) :: data_kind
        logical :: answer

        answer = any(data_kind == [data_modulus_radius, data_stiffness_radius, data_dynamic_stiffness])
    end function x_is_positive

    pure subroutine check_column(values, name, expected, error)
        real(wp), intent(in) :: values(:)
        character(len=*), intent(in) :: name
        integer, intent(in) :: expected
        type(error_t), allocatable, intent(inout) :: error

        if (size(values) /= expected) call raise(error, error_invalid, name//" has "//count_text(size(values))// &
                                                 " entries and x "//count_text(expected)//": they must have equal sizes")
    end subroutine check_column

end module mdrcontact_fit_problem
