! SPDX-License-Identifier: GPL-3.0-or-later
!> The problem of a fit as C describes it, and its translation.
module mdrcontact_api_fit_problem
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_null_ptr, c_ptr, c_sizeof
    use mdrcontact_api_arrays, only: make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_fit_parameter_t, c_fit_problem_t
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_api_text, only: write_text
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_count_from, check_memory, error_t
    use mdrcontact_fit_body, only: fit_body_t, new_fit_body
    use mdrcontact_fit_problem, only: check_problem, fit_data_t, fit_problem_t, problem_parameters
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: read_problem, read_data
    public :: mdr_fit_parameters

contains

    function mdr_fit_parameters(problem, capacity, out, count) result(status) bind(C, name="mdrcontact_entry_fit_parameters")
        type(c_ptr), value :: problem, out
        integer(c_int), value :: capacity
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(c_fit_problem_t), target :: given
        type(fit_body_t) :: body
        type(error_t), allocatable :: error

        call check_given(error, "problem", c_associated(problem))
        call check_count_from(error, "capacity", int(capacity), 0)
        if (capacity > 0) call check_given(error, "out", c_associated(out))
        call read_options(error, "problem", problem, c_loc(given), c_sizeof(given))
        if (.not. allocated(error)) call read_body(given, body, error)
        status = status_of(error)
        if (allocated(error)) return
        call write_parameters(problem_parameters(body), int(capacity), out)
        count = size(problem_parameters(body), kind=c_int)
    end function mdr_fit_parameters

    !> As many as there is room for.
    subroutine write_parameters(list, capacity, out)
        type(parameter_t), intent(in) :: list(:)
        integer, intent(in) :: capacity
        type(c_ptr), intent(in) :: out
        type(c_fit_parameter_t), pointer :: written(:)
        integer :: i

        if (capacity == 0) return
        call c_f_pointer(out, written, [capacity])
        do i = 1, min(capacity, size(list))
            written(i) = c_fit_parameter_t(value=list(i)%value, lower=-infinity, upper=infinity)
            call write_text(trim(list(i)%name), size(written(i)%name), c_loc(written(i)%name))
        end do
    end subroutine write_parameters

    !> Copies of the objects that trials are like.
    subroutine read_body(given, body, error)
        type(c_fit_problem_t), intent(in) :: given
        type(fit_body_t), intent(out) :: body
        type(error_t), allocatable, intent(inout) :: error
        class(profile_t), pointer :: profile
        type(medium_t), pointer :: medium, counterbody

        call open_handle(given%profile, "profile", profile, error)
        call open_handle(given%medium, "medium", medium, error)
        if (allocated(error)) return
        if (.not. c_associated(given%counterbody)) then
            call new_fit_body(body, profile, medium, error)
            return
        end if
        call open_handle(given%counterbody, "counterbody", counterbody, error)
        if (.not. allocated(error)) call new_fit_body(body, profile, medium, error, counterbody)
    end subroutine read_body

    !> The whole problem, checked.
    subroutine read_problem(structure, problem, branch, error)
        type(c_ptr), intent(in) :: structure
        type(fit_problem_t), intent(out) :: problem
        !> where the branches of the data lie, if any
        type(c_ptr), intent(out) :: branch
        type(error_t), allocatable, intent(out) :: error
        type(c_fit_problem_t), target :: given
        type(c_fit_parameter_t), pointer :: parameters(:)
        real(c_double), pointer :: weights(:, :)
        integer :: stat

        branch = c_null_ptr
        call check_given(error, "problem", c_associated(structure))
        call read_options(error, "problem", structure, c_loc(given), c_sizeof(given))
        if (allocated(error)) return
        branch = given%branch
        call check_count_from(error, "parameter_count", int(given%parameter_count), 0)
        call check_count_from(error, "prior_count", int(given%prior_count), 0)
        call check_given(error, "parameters", c_associated(given%parameters))
        if (.not. allocated(error)) call read_body(given, problem%body, error)
        if (allocated(error)) return
        if (given%data_kind /= 0) problem%data_kind = int(given%data_kind)
        if (given%adhesion_rule /= 0) problem%adhesion_rule = int(given%adhesion_rule)
        if (given%loss /= 0) problem%loss = int(given%loss)
        if (given%loss_scale /= 0.0_c_double) problem%loss_scale = given%loss_scale
        problem%sd_is_absolute = given%sd_is_relative == 0
        if (given%max_iterations /= 0) problem%max_iterations = int(given%max_iterations)
        problem%check_units = given%any_units == 0
        problem%is_elastic = given%is_elastic /= 0
        call c_f_pointer(given%parameters, parameters, [given%parameter_count])
        allocate (problem%parameters(size(parameters)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        problem%parameters%value = parameters%value
        problem%parameters%is_free = parameters%is_free /= 0
        problem%parameters%lower = parameters%lower
        problem%parameters%upper = parameters%upper
        problem%parameters%prior = parameters%prior
        problem%parameters%prior_sd = parameters%prior_sd
        if (given%prior_count > 0) then
            call check_given(error, "prior_weights", c_associated(given%prior_weights))
            if (allocated(error)) return
            call c_f_pointer(given%prior_weights, weights, [given%parameter_count, given%prior_count])
            problem%prior_weights = transpose(weights)
        end if
        call check_problem(problem, error)
    end subroutine read_problem

    !> The data; given and sd may be absent.
    subroutine read_data(branch, n, x, y, given, sd, data, error)
        type(c_ptr), intent(in) :: branch
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: x(*), y(*), given(*), sd(*)
        type(fit_data_t), intent(out) :: data
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), pointer :: branches(:)

        if (allocated(error)) return
        call read_column(n, x, data%x, error)
        call read_column(n, y, data%y, error)
        ! of no points they may be missing
        if (.not. allocated(data%x)) allocate (data%x(0))
        if (.not. allocated(data%y)) allocate (data%y(0))
        call read_column(n, given, data%given, error)
        call read_column(n, sd, data%sd, error)
        if (allocated(error) .or. .not. c_associated(branch)) return
        call c_f_pointer(branch, branches, [n])
        data%branch = int(branches)
    end subroutine read_data

    !> A column that may be absent.
    subroutine read_column(n, given, column, error)
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: given(*)
        real(c_double), allocatable, intent(out) :: column(:)
        type(error_t), allocatable, intent(inout) :: error

        if (.not. present(given)) return
        call make_room(error, n, column)
        if (.not. allocated(error)) column(:) = given(:n)
    end subroutine read_column

end module mdrcontact_api_fit_problem
