! SPDX-License-Identifier: GPL-3.0-or-later
!> From the free parameters of a problem to unknowns of order one, and back.
!>
!> The unknown of a positive parameter is u = 1 + ln(p/p0), that of a parameter of either sign u = 1 + (p - p0)/scale; the work
!> of adhesion, which may be 0 and enters by its square root, as u = sqrt(p/p0). Beyond a bound the parameter stays at the bound.
module mdrcontact_fit_variables
    use mdrcontact_parameter, only: fraction => nature_fraction, not_negative => nature_not_negative, parameter_t, &
                                         poisson => nature_poisson, signed => nature_signed, term => nature_term
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_fit_problem, only: at_depth_offset, at_force_offset, at_frame_compliance, data_depth_time, data_force_depth, &
                                      data_force_time, data_stiffness_depth, fit_data_t, fit_parameter_t, fit_problem_t, &
                                      problem_parameters
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: variables_t, new_variables

    real(wp), parameter :: smallest_poisson = -0.999_wp, largest_poisson = 0.5_wp
    !> Exponents of power laws: between an elastic body and a viscous one.
    real(wp), parameter :: smallest_fraction = 1.0e-4_wp, largest_fraction = 0.999_wp
    !> ln of the largest ratio to the start that is tried
    real(wp), parameter :: widest_logarithm = 9.0_wp
    !> Standard deviations about a prior that are tried: data that would go further contradict it, and models may be slow there
    real(wp), parameter :: widest_prior = 20.0_wp
    !> A parameter this close to a bound, in parts of it, lies at it.
    real(wp), parameter :: rounding = 1.0e-13_wp

    !> The free parameters, and how each is scaled.
    type :: variables_t
        !> positions of the free parameters among all
        integer, allocatable :: free(:)
        !> of the free parameters: start, scale (0: logarithmic, less than 0: square root), bounds
        real(wp), allocatable :: start(:), scale(:), lower(:), upper(:)
    contains
        procedure :: number_at
        procedure :: unknown_of
        procedure :: slope_at
        procedure :: is_outside
        procedure :: ran_off
    end type variables_t

contains

    !> Chooses the scale of each free parameter; raises an error for a start outside its bounds.
    subroutine new_variables(self, problem, data, error)
        type(variables_t), intent(out) :: self
        type(fit_problem_t), intent(in) :: problem
        type(fit_data_t), intent(in) :: data
        type(error_t), allocatable, intent(out) :: error
        type(parameter_t) :: kinds(size(problem%parameters))
        integer :: i, j, instrument

        kinds = problem_parameters(problem%body)
        self%free = pack([(i, i=1, size(kinds))], [(problem%parameters(i)%is_free, i=1, size(kinds))])
        self%start = problem%parameters(self%free)%value
        self%lower = problem%parameters(self%free)%lower
        self%upper = problem%parameters(self%free)%upper
        allocate (self%scale(size(self%free)))
        self%scale = 0.0_wp
        instrument = size(problem%body%parameters)
        do i = 1, size(self%free)
            j = self%free(i)
            select case (kinds(j)%nature)
            case (poisson)
                self%scale(i) = 1.0_wp
                self%lower(i) = max(self%lower(i), smallest_poisson)
                self%upper(i) = min(self%upper(i), largest_poisson)
                if (self%start(i) < self%lower(i) .or. self%start(i) > self%upper(i)) then
                    call raise(error, error_invalid, " = "//to_text(self%start(i))//": Poisson's ratio must lie in (-1, 0.5]", &
                               "parameters", j)
                end if
            case (fraction)
                self%scale(i) = 1.0_wp
                self%lower(i) = max(self%lower(i), smallest_fraction)
                self%upper(i) = min(self%upper(i), largest_fraction)
            case (signed, term)
                if (j <= problem%body%of_indenter) then
                    call scale_coefficient(self, i, problem%parameters(:problem%body%of_indenter), kinds(j)%nature, &
                                           maxval(abs(data%x)))
                else if (kinds(j)%scale > 0.0_wp) then
                    self%scale(i) = kinds(j)%scale
                else
                    self%scale(i) = typical(j - instrument, problem%parameters(j), problem%data_kind, data)
                end if
            case default
                ! a parameter that runs to the end of what is tried has no optimum: it is at a bound, and marked so
                self%lower(i) = max(self%lower(i), self%start(i)*exp(-widest_logarithm))
                self%upper(i) = min(self%upper(i), self%start(i)*exp(widest_logarithm))
                if (kinds(j)%nature == not_negative) then
                    self%scale(i) = -1.0_wp
                    self%lower(i) = max(problem%parameters(j)%lower, 0.0_wp)
                end if
                if (.not. self%start(i) > 0.0_wp) then
                    call raise(error, error_invalid, " = "//to_text(self%start(i))//": the search for a positive quantity "// &
                               "must begin above 0", "parameters", j)
                end if
            end select
            if (allocated(error)) return
            associate (parameter => problem%parameters(j))
                if (parameter%prior_sd > 0.0_wp) then
                    self%lower(i) = max(self%lower(i), min(parameter%prior - widest_prior*parameter%prior_sd, parameter%value))
                    self%upper(i) = min(self%upper(i), max(parameter%prior + widest_prior*parameter%prior_sd, parameter%value))
                end if
            end associate
        end do
    end subroutine new_variables

    !> Scale and bounds of a coefficient of an area function. The last term is the area next to the apex, which is not negative.
    pure subroutine scale_coefficient(self, i, indenter, nature, deepest)
        type(variables_t), intent(inout) :: self
        !> position among the free parameters
        integer, intent(in) :: i
        !> the coefficients
        type(fit_parameter_t), intent(in) :: indenter(:)
        integer, intent(in) :: nature
        real(wp), intent(in) :: deepest
        integer :: last

        self%scale(i) = typical_coefficient(self%free(i), indenter%value, deepest)
        last = findloc(indenter%is_free .or. abs(indenter%value) > 0.0_wp, .true., 1, back=.true.)
        if (self%free(i) == last .and. nature == term) self%lower(i) = max(self%lower(i), 0.0_wp)
    end subroutine scale_coefficient

    !> The scale of coefficient i of an area function C0 h^2 + C1 h + C2 h^(1/2) + ...: what alone would make the contact area at
    !> the depth h.
    pure function typical_coefficient(i, coefficients, h) result(scale)
        integer, intent(in) :: i
        real(wp), intent(in) :: coefficients(:), h
        real(wp) :: scale
        real(wp) :: powers(size(coefficients)), area
        integer :: j

        powers = [2.0_wp, (0.5_wp**(j - 2), j=2, size(coefficients))]
        area = sum(abs(coefficients)*h**powers)
        if (.not. area > 0.0_wp) area = h**2
        scale = area/h**powers(i)
    end function typical_coefficient

    !> The scale of an instrument's parameter of either sign, and of the exponent of a graded body.
    pure function typical(position, parameter, data_kind, data) result(scale)
        !> among the instrument's parameters; less than 1 for others
        integer, intent(in) :: position
        type(fit_parameter_t), intent(in) :: parameter
        integer, intent(in) :: data_kind
        type(fit_data_t), intent(in) :: data
        real(wp) :: scale

        select case (position)
        case (at_depth_offset)
            scale = maxval(abs(data%x))
            if (data_kind == data_force_time) scale = maxval(abs(data%given))
            if (data_kind == data_depth_time) scale = maxval(abs(data%y))
        case (at_force_offset)
            scale = maxval(abs(data%y))
            if (data_kind == data_stiffness_depth .or. data_kind == data_depth_time) scale = maxval(abs(data%given))
        case (at_frame_compliance)
            ! of the order of the sample's own compliance
            if (data_kind /= data_force_depth) then
                scale = 1.0_wp/maxval(abs(data%y))
            else
                scale = maxval(abs(data%x))/maxval(abs(data%y))
            end if
        case default
            scale = max(1.0_wp, abs(parameter%value), parameter%prior_sd)
        end select
    end function typical

    !> Parameter i at an unknown, held within its bounds.
    elemental function number_at(self, i, u) result(p)
        class(variables_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: u
        real(wp) :: p

        if (self%scale(i) > 0.0_wp) then
            p = self%start(i) + (u - 1.0_wp)*self%scale(i)
        else if (self%scale(i) < 0.0_wp) then
            p = self%start(i)*max(u, 0.0_wp)**2
        else
            p = self%start(i)*exp(max(-widest_logarithm, min(u - 1.0_wp, widest_logarithm)))
        end if
        p = max(self%lower(i), min(p, self%upper(i)))
    end function number_at

    elemental function unknown_of(self, i, p) result(u)
        class(variables_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: p
        real(wp) :: u

        if (self%scale(i) > 0.0_wp) then
            u = 1.0_wp + (p - self%start(i))/self%scale(i)
        else if (self%scale(i) < 0.0_wp) then
            u = sqrt(max(p, 0.0_wp)/self%start(i))
        else
            u = 1.0_wp + log(max(p/self%start(i), tiny(1.0_wp)))
        end if
    end function unknown_of

    !> dp/du inside the bounds.
    elemental function slope_at(self, i, u) result(slope)
        class(variables_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: u
        real(wp) :: slope

        slope = self%scale(i)
        if (slope < 0.0_wp) slope = 2.0_wp*self%start(i)*max(u, 0.0_wp)
        if (.not. abs(self%scale(i)) > 0.0_wp) slope = self%number_at(i, u)
    end function slope_at

    !> -1 at or below the lower bound, 1 at or above the upper one, else 0.
    elemental function is_outside(self, i, u) result(side)
        class(variables_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: u
        integer :: side
        real(wp) :: p

        p = self%number_at(i, u)
        side = 0
        ! a bound that has been through logarithms and roots has lost its last significant digits
        if (abs(self%lower(i)) <= huge(p)) then
            if (p - self%lower(i) <= rounding*max(abs(self%lower(i)), self%scale(i))) side = -1
        end if
        if (abs(self%upper(i)) <= huge(p)) then
            if (self%upper(i) - p <= rounding*max(abs(self%upper(i)), self%scale(i))) side = 1
        end if
    end function is_outside

    !> Whether a parameter lies at the end of what is tried around its start: not at a bound, and not far from a prior.
    elemental function ran_off(self, i, u) result(answer)
        class(variables_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: u
        logical :: answer

        answer = .false.
        if (abs(self%scale(i)) > 0.0_wp) return
        select case (self%is_outside(i, u))
        case (-1); answer = self%lower(i) <= self%start(i)*exp(-widest_logarithm)
        case (1); answer = self%upper(i) >= self%start(i)*exp(widest_logarithm)
        case default; continue
        end select
    end function ran_off

end module mdrcontact_fit_variables
