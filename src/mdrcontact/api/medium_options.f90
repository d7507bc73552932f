! SPDX-License-Identifier: GPL-3.0-or-later
!> The options of a medium, `mdr_medium_options`, and the arguments of models, for C.
module mdrcontact_api_medium_options
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_loc, c_null_char, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_options, only: check_size, read_options, write_facts
    use mdrcontact_api_records, only: c_medium_options_t, c_model_facts_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: code_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_model, only: model_options_t, model_position, model_table, models, option_names, option_values
    implicit none (type, external)
    private
    public :: read_medium_options
    public :: mdr_model_info

contains

    !> Options of the caller, or the defaults for a null pointer.
    subroutine read_medium_options(error, structure, model, options)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr), intent(in) :: structure
        !> one of models%...
        integer, intent(out) :: model
        type(model_options_t), intent(out) :: options
        type(c_medium_options_t), target :: chosen

        call read_options(error, "options", structure, c_loc(chosen), c_sizeof(chosen))
        model = models%exact
        if (chosen%model /= 0_c_int) model = int(chosen%model)
        associate (given => chosen)
            if (given%alpha /= 0.0_wp) options%alpha = given%alpha
            if (given%wave_factor /= 0.0_wp) options%wave_factor = given%wave_factor
            if (given%weight_nu_choice /= 0_c_int) options%weight_nu_choice = given%weight_nu_choice
            options%weight_nu = given%weight_nu
            if (given%tolerance /= 0.0_wp) options%tolerance = given%tolerance
            if (given%exponent /= 0.0_wp .or. given%exponent_is_given /= 0_c_int) options%exponent = given%exponent
        end associate
    end subroutine read_medium_options

    function mdr_model_info(model, facts) result(status) bind(C)
        integer(c_int), value :: model
        type(c_ptr), value :: facts
        integer(c_int) :: status
        type(c_model_facts_t), target :: made
        type(error_t), allocatable :: error
        integer :: position
        integer(c_size_t) :: used

        position = model_position(int(model))
        call check_size(error, "facts", facts, c_sizeof(made), used)
        if (position == 0) call raise(error, error_invalid, "model = "//trim(code_text(int(model)))// &
                                      ": it must be one of enum mdr_model")
        status = status_of(error)
        if (allocated(error)) return
        associate (row => model_table(position))
            made%base = int(row%base, c_int)
            made%takes_layers = merge(1_c_int, 0_c_int, row%layers)
            made%takes_graded = merge(1_c_int, 0_c_int, row%graded)
            made%spherical_only = merge(1_c_int, 0_c_int, row%spherical_only)
            made%largest_ratio = row%largest_ratio
            if (row%largest_ratio >= huge(1.0_wp)) made%largest_ratio = ieee_value(1.0_c_double, ieee_positive_inf)
            call write_name(row%constant, made%constant)
            call write_name(row%option, made%option)
            made%default_constant = sum(option_values(model_options_t()), mask=option_names == row%constant)
        end associate
        call write_facts(facts, c_loc(made), used)
    end function mdr_model_info

    !> A name as C has it.
    pure subroutine write_name(name, characters)
        character(len=*), intent(in) :: name
        character(kind=c_char), intent(inout) :: characters(:)
        integer :: i

        do i = 1, len_trim(name)
            characters(i) = name(i:i)
        end do
        characters(len_trim(name) + 1) = c_null_char
    end subroutine write_name

end module mdrcontact_api_medium_options
