! SPDX-License-Identifier: GPL-3.0-or-later
!> The closed forms for an incompressible coating, for C.
module mdrcontact_api_closed_forms
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_each_positive, check_results, make_room
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_contact_closed_form_values, only: closed_form_values, of_adhesive_depth, of_cone_force, of_depth_scale, &
                                                     of_paraboloid_force, of_radius_scale, of_reduced_depth
    use mdrcontact_error, only: check_code, check_inclination, check_not_negative, check_positive, error_t
    implicit none (type, external)
    private
    public :: mdr_closed_form

    !> The formulas, and how many constants each has.
    integer, parameter :: formulas(*) = [of_paraboloid_force, of_cone_force, of_adhesive_depth, of_reduced_depth, &
                                         of_radius_scale, of_depth_scale]
    integer, parameter :: counts(*) = [4, 4, 5, 2, 2, 2]

contains

    function mdr_closed_form(formula, n, x, constants, out) result(status) bind(C, name="mdrcontact_entry_closed_form")
        integer(c_int), value :: formula, n
        real(c_double), intent(in), optional :: x(*), constants(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        character(len=14) :: name
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error
        integer :: count

        call check_code(error, "formula", int(formula), formulas)
        count = 0
        if (.not. allocated(error)) count = counts(findloc(formulas, int(formula), dim=1))
        name = name_of(int(formula))
        if (.not. allocated(error)) call check_constants(error, int(formula), constants(:count))
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, trim(name), x(:n))
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call closed_form_values(int(formula), x(:n), constants(:count), values, wanted_threads())
            call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_closed_form

    !> What x is.
    pure function name_of(formula) result(name)
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
    end function name_of

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
