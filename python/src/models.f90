! SPDX-License-Identifier: GPL-3.0-or-later
! The table of models, flat for f2py.

!> Row `position` of the table, from 1 on; code = -1 beyond its end.
subroutine model_row(position, code, base, takes_layers, takes_graded, has_constant, name, option)
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_model, only: model_table
    implicit none (type, external)
    integer(c_int), intent(in) :: position
    integer(c_int), intent(out) :: code, base, takes_layers, takes_graded, has_constant
    character(len=40), intent(out) :: name, option

    code = -1_c_int
    base = 0_c_int
    takes_layers = 0_c_int
    takes_graded = 0_c_int
    has_constant = 0_c_int
    name = ""
    option = ""
    if (position < 1 .or. position > size(model_table)) return
    associate (row => model_table(position))
        code = int(row%code, c_int)
        base = int(row%base, c_int)
        takes_layers = merge(1_c_int, 0_c_int, row%layers)
        takes_graded = merge(1_c_int, 0_c_int, row%graded)
        has_constant = merge(1_c_int, 0_c_int, row%has_constant)
        name = row%name
        option = row%option
    end associate
end subroutine model_row

!> Name and default of option `position`, from 1 on; an empty name beyond the last.
subroutine model_option(position, default, name)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_model, only: model_options_t, option_names, option_values
    implicit none (type, external)
    integer(c_int), intent(in) :: position
    real(c_double), intent(out) :: default
    character(len=40), intent(out) :: name
    real(c_double) :: defaults(size(option_names))

    default = 0.0_c_double
    name = ""
    if (position < 1 .or. position > size(option_names)) return
    defaults = option_values(model_options_t())
    default = defaults(position)
    name = option_names(position)
end subroutine model_option
