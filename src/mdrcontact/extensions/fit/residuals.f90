! SPDX-License-Identifier: GPL-3.0-or-later
!> The residuals of a fit: data in their standard deviations, bent by the loss, and below them what was known beforehand.
module mdrcontact_fit_residuals
    use mdrcontact_object, only: room
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_fit_least_squares, only: residuals_t
    use mdrcontact_fit_predict, only: predict
    use mdrcontact_fit_proportional, only: proportional_modulus
    use mdrcontact_fit_problem, only: ascending_points, at_force_offset, at_frame_compliance, data_stiffness_depth, &
                                      fit_data_t, fit_problem_t, joint_priors, loss_cauchy, loss_huber, &
                                      loss_linear, values_of
    use mdrcontact_fit_variables, only: variables_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    implicit none (type, external)
    private
    public :: fit_residuals_t, new_fit_residuals, bent, bend_slope

    !> Relative step of a reading for the difference quotient, and the least share of its error that is left in a residual.
    real(wp), parameter :: reading_step = 1.0e-4_wp, smallest_share = 0.1_wp

    !> Last values of the model and their parameters.
    type :: prediction_t
        real(wp), allocatable :: values(:), y(:)
    end type prediction_t

    !> Residuals of the data, then of the priors.
    type, extends(residuals_t) :: fit_residuals_t
        type(fit_problem_t) :: problem
        type(fit_data_t), pointer :: data => null()
        type(variables_t) :: variables
        !> positions, among the free parameters, of those with priors
        integer, allocatable :: known(:)
        !> standard deviations of the data, up to the factor `noise`
        real(wp), allocatable :: sd(:)
        !> the points along the curve, see ascending_points
        integer, allocatable :: order(:)
        real(wp) :: noise = 1.0_wp
        !> one of loss_...
        integer :: loss = loss_linear
        !> what exact media have in common from one trial to the next
        type(kernel_cache_t) :: shared
        !> where forces are proportional to a modulus: its position among the parameters, else 0, and that of the force offset
        integer :: at_modulus = 0, at_offset = 0
        !> the last predictions, as many as a point and its neighbours are, and the one to be overwritten next
        type(prediction_t), allocatable :: recent(:)
        integer :: oldest = 1
    contains
        procedure :: evaluate
        procedure :: neighbours
        procedure :: values_at
        procedure :: fitted
        procedure :: readings_enter_model
        procedure :: propagate_readings
    end type fit_residuals_t

contains

    !> Residuals of a problem that has been checked.
    subroutine new_fit_residuals(self, problem, data, variables, error)
        type(fit_residuals_t), intent(out) :: self
        type(fit_problem_t), intent(in) :: problem
        !> read as long as the residuals are used
        type(fit_data_t), intent(in), target :: data
        type(variables_t), intent(in) :: variables
        type(error_t), allocatable, intent(out) :: error
        integer :: i, n, stat

        self%problem = problem
        self%data => data
        self%variables = variables
        self%loss = problem%loss
        self%known = pack([(i, i=1, size(variables%free))], problem%parameters(variables%free)%prior_sd > 0.0_wp)
        self%p = size(variables%free)
        n = size(data%x)
        self%n = n + size(self%known) + size(joint_priors(problem, values_of(problem%parameters)))
        call ascending_points(data, self%order, error)
        if (allocated(error)) return
        allocate (self%sd(n), stat=stat)
        allocate (self%recent(self%p + 2))
        do i = 1, size(self%recent)
            if (stat == 0) allocate (self%recent(i)%y(n), stat=stat)
        end do
        call check_memory(error, stat)
        if (.not. allocated(error)) call set_spread(self)
        self%at_offset = size(problem%body%parameters) + at_force_offset
        self%at_modulus = proportional_modulus(problem)
    end subroutine new_fit_residuals

    !> Standard deviations as the data have them.
    pure subroutine set_spread(self)
        type(fit_residuals_t), intent(inout) :: self

        self%sd(:) = 1.0_wp
        if (allocated(self%data%sd)) self%sd(:) = self%data%sd
    end subroutine set_spread

    !> All parameters of the problem at the unknowns u.
    pure function values_at(self, u) result(values)
        class(fit_residuals_t), intent(in) :: self
        real(wp), intent(in) :: u(:)
        real(wp) :: values(size(self%problem%parameters))
        integer :: i

        values = self%problem%parameters%value
        values(self%variables%free) = self%variables%number_at([(i, i=1, size(u))], u)
    end function values_at

    !> The model at the unknowns u.
    subroutine fitted(self, u, y, error)
        class(fit_residuals_t), intent(inout) :: self
        real(wp), intent(in) :: u(:)
        real(wp), intent(out) :: y(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: values(size(self%problem%parameters))
        integer :: i

        values = self%values_at(u)
        do i = 1, size(self%recent)
            if (.not. allocated(self%recent(i)%values)) exit
            if (any(self%recent(i)%values /= values)) cycle
            y = self%recent(i)%y
            return
        end do
        do i = 1, size(self%recent)
            if (.not. allocated(self%recent(i)%values)) exit
            if (.not. is_linear_change(self, self%recent(i)%values, values)) cycle
            y = (self%recent(i)%y - self%recent(i)%values(self%at_offset)) &
                *(values(self%at_modulus)/self%recent(i)%values(self%at_modulus)) + values(self%at_offset)
            return
        end do
        call predict(self%problem, values, self%data, y, error, self%shared, self%order)
        if (allocated(error)) return
        self%recent(self%oldest)%values = values
        self%recent(self%oldest)%y(:) = y
        self%oldest = modulo(self%oldest, size(self%recent)) + 1
    end subroutine fitted

    !> Whether the values of the model at one set of parameters follow linearly from those at the other.
    pure function is_linear_change(self, known, values) result(answer)
        type(fit_residuals_t), intent(in) :: self
        real(wp), intent(in) :: known(:), values(:)
        logical :: answer
        integer :: i

        answer = .false.
        if (self%at_modulus == 0) return
        if (.not. values(self%at_modulus) > 0.0_wp) return
        answer = .not. any(known /= values .and. [(i /= self%at_modulus .and. i /= self%at_offset, i=1, size(values))])
    end function is_linear_change

    !> Whether the model is computed from the readings y too: contact depths from stiffnesses, the give of the frame from forces.
    pure function readings_enter_model(self) result(answer)
        class(fit_residuals_t), intent(in) :: self
        logical :: answer
        integer :: i

        i = size(self%problem%body%parameters) + at_frame_compliance
        answer = self%problem%data_kind == data_stiffness_depth &
                 .or. (self%problem%parameters(i)%is_free .or. self%problem%parameters(i)%value /= 0.0_wp)
    end function readings_enter_model

    !> Standard deviations of y - model where the model is computed from y too: an error e of a reading moves the residual by e (1 -
    !> d model/dy).
    subroutine propagate_readings(self, u, error)
        class(fit_residuals_t), intent(inout) :: self
        real(wp), intent(in) :: u(:)
        type(error_t), allocatable, intent(out) :: error
        type(fit_data_t) :: shifted
        real(wp), allocatable :: below(:), above(:), step(:)
        integer :: n, stat

        call room(self%data%bytes(), error)
        if (allocated(error)) return
        shifted = self%data
        n = size(self%data%x)
        allocate (below(n), above(n), step(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        step = reading_step*maxval(abs(self%data%y))
        if (self%problem%data_kind == data_stiffness_depth) step = reading_step*self%data%y
        shifted%y(:) = self%data%y - step
        call predict(self%problem, self%values_at(u), shifted, below, error, self%shared, self%order)
        if (allocated(error)) return
        shifted%y(:) = self%data%y + step
        call predict(self%problem, self%values_at(u), shifted, above, error, self%shared, self%order)
        if (allocated(error)) return
        call set_spread(self)
        self%sd(:) = self%sd*max(abs(1.0_wp - (above - below)/(2.0_wp*step)), smallest_share)
    end subroutine propagate_readings

    subroutine evaluate(self, u, r)
        class(fit_residuals_t), intent(inout) :: self
        real(wp), intent(in) :: u(:)
        real(wp), intent(out) :: r(:)
        real(wp) :: values(size(self%problem%parameters))
        integer :: i, n

        r = 0.0_wp
        n = size(self%data%x)
        call self%fitted(u, r(:n), self%error)
        if (allocated(self%error)) return
        r(:n) = bent(self%loss, self%problem%loss_scale, (self%data%y - r(:n))/(self%sd*self%noise))
        values = self%values_at(u)
        do i = 1, size(self%known)
            associate (j => self%variables%free(self%known(i)))
                r(n + i) = (values(j) - self%problem%parameters(j)%prior)/self%problem%parameters(j)%prior_sd
            end associate
        end do
        r(n + size(self%known) + 1:) = joint_priors(self%problem, values)
    end subroutine evaluate

    subroutine neighbours(self, u, i, step, below, above)
        class(fit_residuals_t), intent(inout) :: self
        real(wp), intent(in) :: u(:)
        integer, intent(in) :: i
        real(wp), intent(in) :: step
        real(wp), intent(out) :: below, above
        real(wp) :: lowest, highest

        ! the differences must be those of the parameters, which stay at their bounds; beyond a bound nothing moves
        lowest = self%variables%unknown_of(i, max(self%variables%lower(i), self%variables%number_at(i, u(i) - step)))
        highest = self%variables%unknown_of(i, min(self%variables%upper(i), self%variables%number_at(i, u(i) + step)))
        below = min(lowest, highest)
        above = max(lowest, highest)
        if (u(i) < below .or. u(i) > above) then
            below = u(i)
            above = u(i)
        end if
    end subroutine neighbours

    !> The residual whose square is the loss of z.
    elemental function bent(loss, scale, z) result(r)
        integer, intent(in) :: loss
        real(wp), intent(in) :: scale, z
        real(wp) :: r

        r = z
        if (loss == loss_huber .and. abs(z) > scale) r = sign(sqrt(scale*(2.0_wp*abs(z) - scale)), z)
        if (loss == loss_cauchy) r = sign(scale*sqrt(log(1.0_wp + (z/scale)**2)), z)
    end function bent

    !> psi(z), half the derivative of the loss, and psi'(z).
    elemental subroutine bend_slope(loss, scale, z, psi, psi_slope)
        integer, intent(in) :: loss
        real(wp), intent(in) :: scale, z
        real(wp), intent(out) :: psi, psi_slope
        real(wp) :: t

        psi = z
        psi_slope = 1.0_wp
        if (loss == loss_huber .and. abs(z) > scale) then
            psi = sign(scale, z)
            psi_slope = 0.0_wp
        else if (loss == loss_cauchy) then
            t = (z/scale)**2
            psi = z/(1.0_wp + t)
            psi_slope = (1.0_wp - t)/(1.0_wp + t)**2
        end if
    end subroutine bend_slope

end module mdrcontact_fit_residuals
