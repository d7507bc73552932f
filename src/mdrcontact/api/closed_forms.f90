! SPDX-License-Identifier: GPL-3.0-or-later
!> The constants of the closed forms for an incompressible coating, for C.
module mdrcontact_api_closed_forms
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_contact_closed_form_values, only: of_adhesive_depth, of_cone_force, of_depth_scale, of_paraboloid_force, &
                                                     of_radius_scale, of_reduced_depth
    use mdrcontact_error, only: check_inclination, check_not_negative, check_positive, error_t
    implicit none (type, external)
    private
    public :: check_constants, constant_count, formulas, variable_name

    !> The formulas, and how many constants each has.
    integer, parameter :: formulas(*) = [of_paraboloid_force, of_cone_force, of_adhesive_depth, of_reduced_depth, &
                                         of_radius_scale, of_depth_scale]
    integer, parameter :: counts(*) = [4, 4, 5, 2, 2, 2]

contains

    !> Number of constants of a formula.
    pure function constant_count(formula) result(count)
        integer, intent(in) :: formula
        integer :: count

        count = counts(findloc(formulas, formula, dim=1))
    end function constant_count

    !> Meaning of x.
    pure function variable_name(formula) result(name)
        integer, intent(in) :: formula
        character(len=14) :: name

        select case (formula)
        case (of_reduced_depth)
            name = "reduced_radius"
        case (of_radius_scale, of_depth_scale)
            name = "radius"
        case default
            name = "a"
        end select
    end function variable_name

    pure subroutine check_constants(error, formula, c)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: formula
        real(c_double), intent(in) :: c(:)

        select case (formula)
        case (of_reduced_depth)
            call check_positive(error, "shear_ratio", c(1))
            call check_positive(error, "reduced_thickness", c(2))
        case (of_radius_scale, of_depth_scale)
            call check_positive(error, "substrate_shear", c(1))
            call check_positive(error, "work_of_adhesion", c(2))
        case default
            if (formula == of_cone_force) then
                call check_inclination(error, c(1))
            else
                call check_positive(error, "radius", c(1))
            end if
            call check_positive(error, "coating_shear", c(2))
            call check_positive(error, "substrate_shear", c(3))
            call check_positive(error, "thickness", c(4))
            if (formula == of_adhesive_depth) call check_not_negative(error, "work_of_adhesion", c(5))
        end select
    end subroutine check_constants

end module mdrcontact_api_closed_forms
