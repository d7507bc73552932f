! SPDX-License-Identifier: GPL-3.0-or-later
!> The problem of a fit from the flat arrays in which it comes from Python.
module mdrcontact_flat_fit
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_c_fit, only: fit_parameter_t, fit_problem_t
    use mdrcontact_model, only: options_of
    implicit none (type, external)
    private
    public :: to_parameters, to_problem, optional_column

contains

    !> Rows value, lower, upper, prior, prior_sd, is_free.
    pure function to_parameters(table) result(parameters)
        real(c_double), intent(in) :: table(:, :)
        type(fit_parameter_t) :: parameters(size(table, 2))
        integer :: i

        do i = 1, size(table, 2)
            parameters(i) = fit_parameter_t(table(1, i), table(2, i), table(3, i), table(4, i), table(5, i), &
                                            merge(1_c_int, 0_c_int, table(6, i) > 0.0_c_double))
        end do
    end function to_parameters

    !> codes: data kind, indenter, medium, model, layers, adhesion rule, loss, sd_is_absolute, max_iterations, check_units.
    !> reals: loss_scale, then the options of the model. objects: addresses of profile and medium.
    function to_problem(codes, reals, objects, parameters) result(problem)
        integer(c_int), intent(in) :: codes(10)
        real(c_double), intent(in) :: reals(:)
        integer(c_int64_t), intent(in) :: objects(2)
        type(fit_parameter_t), intent(in), target :: parameters(:)
        type(fit_problem_t) :: problem

        problem = fit_problem_t(codes(1), codes(2), to_pointer(objects(1)), codes(3), to_pointer(objects(2)), codes(4), codes(5), &
                                options_of(reals(2:)), codes(6), codes(7), reals(1), codes(8), codes(9), codes(10), &
                                size(parameters, kind=c_int), c_loc(parameters))
    end function to_problem

    !> The address of a column, null if it does not count.
    function optional_column(has, values) result(pointer)
        integer(c_int), intent(in) :: has
        real(c_double), intent(in), target :: values(:)
        type(c_ptr) :: pointer

        pointer = c_null_ptr
        if (has > 0) pointer = c_loc(values)
    end function optional_column

end module mdrcontact_flat_fit
