! SPDX-License-Identifier: GPL-3.0-or-later
!> Forces that are proportional to one modulus: its best value at given other parameters is a division.
module mdrcontact_fit_proportional
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_fit_body, only: fit_body_t
    use mdrcontact_fit_predict, only: predict
    use mdrcontact_fit_problem, only: at_force_offset, at_frame_compliance, at_indenter_modulus, at_work_of_adhesion, &
                                      data_force_depth, data_force_time, fit_data_t, fit_problem_t, values_of
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: proportional_modulus, divide_modulus

contains

    !> Position, among all parameters, of the modulus to which forces less their offset are proportional; 0: not one.
    pure function proportional_modulus(problem) result(position)
        type(fit_problem_t), intent(in) :: problem
        integer :: position

        position = 0
        select case (problem%data_kind)
        case (data_force_time); if (is_one_power_law(problem%body)) position = 1
        case (data_force_depth); if (is_plain(problem)) position = 1
        case default; continue
        end select
        if (position > 0) position = position + problem%body%of_indenter
    end function proportional_modulus

    !> Whether the body is a power law alone or on a rigid base; its first number is its modulus.
    pure function is_one_power_law(body) result(answer)
        type(fit_body_t), intent(in) :: body
        logical :: answer

        answer = .false.
        if (.not. allocated(body%medium%relaxing)) return
        associate (materials => body%medium%relaxing%materials)
            if (size(materials) == 1) answer = materials(1)%is_power_law()
        end associate
    end function is_one_power_law

    !> Whether a rigid indenter without adhesion presses on a homogeneous body, on a frame that does not give.
    pure function is_plain(problem) result(answer)
        type(fit_problem_t), intent(in) :: problem
        logical :: answer

        answer = .false.
        associate (body => problem%body)
            if (body%of_medium /= 2 .or. allocated(body%counterbody)) return
            if (body%parameters(body%of_indenter + 1)%name /= "E") return
        end associate
        associate (instrument => problem%parameters(size(problem%body%parameters) + 1:))
            answer = .not. any(instrument([at_work_of_adhesion, at_frame_compliance, at_indenter_modulus])%is_free) &
                     .and. .not. instrument(at_work_of_adhesion)%value > 0.0_wp &
                     .and. .not. abs(instrument(at_frame_compliance)%value) > 0.0_wp &
                     .and. instrument(at_indenter_modulus)%value > huge(1.0_wp)
        end associate
    end function is_plain

    !> Lets the search begin at the modulus that fits best with everything else at its start value: wherever the guess was, it is
    !> near.
    subroutine divide_modulus(problem, data, error)
        type(fit_problem_t), intent(inout) :: problem
        type(fit_data_t), intent(in) :: data
        type(error_t), allocatable, intent(inout) :: error
        type(error_t), allocatable :: refusal
        real(wp), allocatable :: y(:), weight(:)
        real(wp) :: offset, divided
        integer :: position, stat

        position = proportional_modulus(problem)
        if (position == 0) return
        if (.not. problem%parameters(position)%is_free) return
        allocate (y(size(data%x)), weight(size(data%x)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call predict(problem, values_of(problem%parameters), data, y, refusal)
        if (allocated(refusal)) return
        weight(:) = 1.0_wp
        if (allocated(data%sd)) weight(:) = 1.0_wp/data%sd**2
        offset = problem%parameters(size(problem%body%parameters) + at_force_offset)%value
        y(:) = y - offset
        ! no force where the search begins, or one of the other sign, gives no information
        if (.not. sum(weight*y**2) > 0.0_wp) return
        associate (modulus => problem%parameters(position))
            divided = modulus%value*sum(weight*y*(data%y - offset))/sum(weight*y**2)
            if (divided > max(modulus%lower, 0.0_wp) .and. divided < modulus%upper) modulus%value = divided
        end associate
    end subroutine divide_modulus

end module mdrcontact_fit_proportional
