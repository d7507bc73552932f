! SPDX-License-Identifier: GPL-3.0-or-later
!> The problem of a fit as C describes it, and its translation.
module mdrcontact_api_fit_problem
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_null_ptr, c_ptr, &
                                           c_size_t, c_sizeof
    use mdrcontact_api_arrays, only: check_count, make_room
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_medium_options, only: read_medium_options, read_surface
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_error, only: check_count_from, check_count_within, check_memory, count_text, error_invalid, error_t, raise
    use mdrcontact_fit_body, only: indenter_given
    use mdrcontact_fit_medium_of, only: medium_choice_t, medium_given, medium_none, medium_pattern, set_pattern
    use mdrcontact_fit_problem, only: check_problem, fit_data_t, fit_problem_t, parameter_count
    use mdrcontact_medium, only: medium_t
    use mdrcontact_model, only: models
    use mdrcontact_profile, only: profile_t
    use mdrcontact_tension_surface, only: is_bare, surface_t
    implicit none (type, external)
    private
    public :: read_problem, read_data
    public :: mdr_fit_parameter_count

    !> struct mdr_fit_parameter
    type, bind(C) :: c_fit_parameter_t
        real(c_double) :: value
        real(c_double) :: lower
        real(c_double) :: upper
        real(c_double) :: prior
        real(c_double) :: prior_sd
        integer(c_int) :: is_free
    end type c_fit_parameter_t

    !> struct mdr_fit_problem
    type, bind(C) :: c_fit_problem_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: data_kind = 0_c_int
        integer(c_int) :: indenter = 0_c_int
        type(c_ptr) :: profile = c_null_ptr
        integer(c_int) :: medium = 0_c_int
        type(c_ptr) :: medium_object = c_null_ptr
        integer(c_int) :: model = 0_c_int
        integer(c_int) :: layers = 0_c_int
        type(c_ptr) :: options = c_null_ptr
        integer(c_int) :: adhesion_rule = 0_c_int
        integer(c_int) :: loss = 0_c_int
        real(c_double) :: loss_scale = 0.0_c_double
        integer(c_int) :: sd_is_relative = 0_c_int
        integer(c_int) :: max_iterations = 0_c_int
        integer(c_int) :: any_units = 0_c_int
        integer(c_int) :: parameter_count = 0_c_int
        type(c_ptr) :: parameters = c_null_ptr
        integer(c_int) :: prior_count = 0_c_int
        type(c_ptr) :: prior_weights = c_null_ptr
        type(c_ptr) :: branch = c_null_ptr
        integer(c_int) :: counterbody = 0_c_int
        type(c_ptr) :: counterbody_object = c_null_ptr
        integer(c_int) :: counterbody_model = 0_c_int
        integer(c_int) :: counterbody_layers = 0_c_int
        type(c_ptr) :: counterbody_options = c_null_ptr
        integer(c_int) :: is_elastic = 0_c_int
        integer(c_int) :: model_is_given = 0_c_int
        integer(c_int) :: counterbody_model_is_given = 0_c_int
    end type c_fit_problem_t

    !> More are no layers whose parameters can be counted.
    integer, parameter :: most_layers = 100000

contains

    function mdr_fit_parameter_count(problem, count) result(status) bind(C, name="mdrcontact_entry_fit_parameter_count")
        type(c_ptr), value :: problem
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(c_fit_problem_t), target :: given
        type(fit_problem_t) :: chosen
        type(error_t), allocatable :: error
        integer :: found

        call check_given(error, "problem", c_associated(problem))
        call check_given(error, "count", present(count))
        call read_options(error, "problem", problem, c_loc(given), c_sizeof(given))
        call read_kinds(given, chosen, error)
        if (.not. allocated(error)) then
            found = parameter_count(chosen%body)
            if (found < 0) then
                call raise(error, error_invalid, "indenter = "//count_text(int(given%indenter))//", medium = "// &
                           count_text(int(given%medium))//", counterbody = "//count_text(int(given%counterbody))// &
                           " is not allowed: they must be kinds that exist")
            else
                count = int(found, c_int)
            end if
        end if
        status = status_of(error)
    end function mdr_fit_parameter_count

    !> Kinds and choices, without objects and parameters.
    subroutine read_kinds(given, problem, error)
        type(c_fit_problem_t), intent(in) :: given
        type(fit_problem_t), intent(out) :: problem
        type(error_t), allocatable, intent(inout) :: error

        call read_choice(given%medium, given%model, given%model_is_given, "layers", given%layers, given%options, &
                         problem%body%medium, error)
        call read_choice(given%counterbody, given%counterbody_model, given%counterbody_model_is_given, "counterbody_layers", &
                         given%counterbody_layers, given%counterbody_options, problem%body%counterbody, error)
        if (problem%body%counterbody%kind == medium_given .and. .not. c_associated(given%counterbody_object)) then
            problem%body%counterbody%kind = medium_none
        end if
        call take_pattern(given%medium_object, "medium_object", problem%body%medium, error)
        call take_pattern(given%counterbody_object, "counterbody_object", problem%body%counterbody, error)
        if (given%data_kind /= 0) problem%data_kind = int(given%data_kind)
        problem%body%indenter = int(given%indenter)
        problem%adhesion_rule = int(given%adhesion_rule)
        problem%loss = int(given%loss)
        if (given%loss_scale /= 0.0_c_double) problem%loss_scale = given%loss_scale
        problem%sd_is_absolute = given%sd_is_relative == 0
        if (given%max_iterations /= 0) problem%max_iterations = int(given%max_iterations)
        problem%check_units = given%any_units == 0
        problem%is_elastic = given%is_elastic /= 0
    end subroutine read_kinds

    subroutine read_choice(kind, model, model_is_given, name, layers, options, choice, error)
        integer(c_int), intent(in) :: kind, model, model_is_given
        !> of the argument `layers`
        character(len=*), intent(in) :: name
        integer(c_int), intent(in) :: layers
        type(c_ptr), intent(in) :: options
        type(medium_choice_t), intent(out) :: choice
        type(error_t), allocatable, intent(inout) :: error
        type(surface_t) :: surface

        call check_count_within(error, name, merge(1, int(layers), layers == 0), 1, most_layers)
        call read_medium_options(error, options, choice%options)
        call read_surface(error, options, surface)
        choice%has_surface = .not. is_bare(surface)
        choice%kind = int(kind)
        choice%model = int(model)
        if (model == 0 .and. model_is_given == 0) choice%model = models%exact
        choice%layers = max(int(layers), 1)
    end subroutine read_choice

    !> The whole problem, checked.
    subroutine read_problem(structure, problem, branch, error)
        type(c_ptr), intent(in) :: structure
        type(fit_problem_t), intent(out) :: problem
        !> where the branches of the data lie, if any
        type(c_ptr), intent(out) :: branch
        type(error_t), allocatable, intent(out) :: error
        type(c_fit_problem_t), target :: given
        class(profile_t), pointer :: profile
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
        call read_kinds(given, problem, error)
        if (allocated(error)) return
        if (problem%body%indenter == indenter_given) then
            call open_handle(given%profile, "profile", profile, error)
            if (allocated(error)) return
            call profile%copy_to(problem%body%profile, error)
            if (allocated(error)) return
        end if
        call take_object(given%medium_object, "medium_object", problem%body%medium, error)
        call take_object(given%counterbody_object, "counterbody_object", problem%body%counterbody, error)
        if (allocated(error)) return
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

    !> The finished medium of a choice that is one.
    subroutine take_object(handle, name, choice, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(medium_choice_t), intent(inout) :: choice
        type(error_t), allocatable, intent(inout) :: error
        type(medium_t), pointer :: medium

        if (choice%kind /= medium_given .or. allocated(error)) return
        call open_handle(handle, name, medium, error)
        if (allocated(error)) return
        allocate (choice%object)
        call medium%copy_to(choice%object, error)
    end subroutine take_object

    !> The medium that says what the bodies of a choice are like.
    subroutine take_pattern(handle, name, choice, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(medium_choice_t), intent(inout) :: choice
        type(error_t), allocatable, intent(inout) :: error
        type(medium_t), pointer :: medium

        if (choice%kind /= medium_pattern .or. allocated(error)) return
        call open_handle(handle, name, medium, error)
        if (.not. allocated(error)) call set_pattern(choice, medium, error)
    end subroutine take_pattern

    !> The data; given and sd may be absent.
    subroutine read_data(branch, n, x, y, given, sd, data, error)
        type(c_ptr), intent(in) :: branch
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: x(*), y(*), given(*), sd(*)
        type(fit_data_t), intent(out) :: data
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), pointer :: branches(:)

        call check_count(error, n)
        call check_given(error, "x", present(x))
        call check_given(error, "y", present(y))
        if (allocated(error)) return
        call read_column(n, x, data%x, error)
        call read_column(n, y, data%y, error)
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
