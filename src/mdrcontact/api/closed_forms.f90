! SPDX-License-Identifier: GPL-3.0-or-later
!> The closed forms for an incompressible coating, for C.
module mdrcontact_api_closed_forms
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_each_positive, check_in_out, check_results, make_room
    use mdrcontact_api_status, only: check_given, status_of, wanted_threads
    use mdrcontact_contact_closed_form_values, only: closed_form_values, of_adhesive_depth, of_cone_force, of_paraboloid_force, &
                                                     of_reduced_depth
    use mdrcontact_contact_closed_forms, only: adhesive_depth_scale, adhesive_radius_scale
    use mdrcontact_error, only: check_inclination, check_not_negative, check_positive, error_t
    implicit none (type, external)
    private
    public :: mdr_coated_paraboloid_force, mdr_coated_cone_force, mdr_coated_paraboloid_adhesive_depth
    public :: mdr_adhesive_radius_scale, mdr_adhesive_depth_scale, mdr_reduced_adhesive_depth

contains

    function mdr_coated_paraboloid_force(n, a, radius, coating_shear, substrate_shear, thickness, out) &
        result(status) bind(C, name="mdrcontact_entry_coated_paraboloid_force")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), value :: radius, coating_shear, substrate_shear, thickness
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check_positive(error, "radius", radius)
        call check_body(error, coating_shear, substrate_shear, thickness)
        status = write_form(of_paraboloid_force, n, "a", a, [radius, coating_shear, substrate_shear, thickness], out, error)
    end function mdr_coated_paraboloid_force

    function mdr_coated_cone_force(n, a, inclination, coating_shear, substrate_shear, thickness, out) &
        result(status) bind(C, name="mdrcontact_entry_coated_cone_force")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), value :: inclination, coating_shear, substrate_shear, thickness
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check_inclination(error, inclination)
        call check_body(error, coating_shear, substrate_shear, thickness)
        status = write_form(of_cone_force, n, "a", a, [inclination, coating_shear, substrate_shear, thickness], out, error)
    end function mdr_coated_cone_force

    function mdr_coated_paraboloid_adhesive_depth(n, a, radius, coating_shear, substrate_shear, thickness, work_of_adhesion, out) &
        result(status) bind(C, name="mdrcontact_entry_coated_paraboloid_adhesive_depth")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), value :: radius, coating_shear, substrate_shear, thickness, work_of_adhesion
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check_positive(error, "radius", radius)
        call check_body(error, coating_shear, substrate_shear, thickness)
        call check_not_negative(error, "work_of_adhesion", work_of_adhesion)
        status = write_form(of_adhesive_depth, n, "a", a, &
                            [radius, coating_shear, substrate_shear, thickness, work_of_adhesion], out, error)
    end function mdr_coated_paraboloid_adhesive_depth

    function mdr_adhesive_radius_scale(radius, substrate_shear, work_of_adhesion, out) result(status) &
        bind(C, name="mdrcontact_entry_adhesive_radius_scale")
        real(c_double), value :: radius, substrate_shear, work_of_adhesion
        real(c_double), intent(inout), optional :: out
        integer(c_int) :: status
        real(c_double) :: scale
        type(error_t), allocatable :: error

        call check_scale(error, radius, substrate_shear, work_of_adhesion, present(out))
        if (.not. allocated(error)) then
            scale = adhesive_radius_scale(radius, substrate_shear, work_of_adhesion)
            call check_results(error, [scale])
        end if
        if (.not. allocated(error)) out = scale
        status = status_of(error)
    end function mdr_adhesive_radius_scale

    function mdr_adhesive_depth_scale(radius, substrate_shear, work_of_adhesion, out) result(status) &
        bind(C, name="mdrcontact_entry_adhesive_depth_scale")
        real(c_double), value :: radius, substrate_shear, work_of_adhesion
        real(c_double), intent(inout), optional :: out
        integer(c_int) :: status
        real(c_double) :: scale
        type(error_t), allocatable :: error

        call check_scale(error, radius, substrate_shear, work_of_adhesion, present(out))
        if (.not. allocated(error)) then
            scale = adhesive_depth_scale(radius, substrate_shear, work_of_adhesion)
            call check_results(error, [scale])
        end if
        if (.not. allocated(error)) out = scale
        status = status_of(error)
    end function mdr_adhesive_depth_scale

    function mdr_reduced_adhesive_depth(n, reduced_radius, shear_ratio, reduced_thickness, out) &
        result(status) bind(C, name="mdrcontact_entry_reduced_adhesive_depth")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: reduced_radius(*)
        real(c_double), value :: shear_ratio, reduced_thickness
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check_positive(error, "shear_ratio", shear_ratio)
        call check_positive(error, "reduced_thickness", reduced_thickness)
        status = write_form(of_reduced_depth, n, "reduced_radius", reduced_radius, [shear_ratio, reduced_thickness], out, error)
    end function mdr_reduced_adhesive_depth

    !> One of the closed forms of radii > 0 and numbers that have been checked; nothing is written before all of it is known.
    function write_form(form, n, name, radii, numbers, out, error) result(status)
        integer, intent(in) :: form
        integer(c_int), intent(in) :: n
        character(len=*), intent(in) :: name
        real(c_double), intent(in), optional :: radii(*)
        real(c_double), intent(in) :: numbers(:)
        real(c_double), intent(inout), optional :: out(*)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        real(c_double), allocatable :: values(:)

        call check_in_out(error, n, name, present(radii), present(out))
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, name, radii(:n))
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call closed_form_values(form, radii(:n), numbers, values, wanted_threads())
            call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function write_form

    subroutine check_body(error, coating_shear, substrate_shear, thickness)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), intent(in) :: coating_shear, substrate_shear, thickness

        call check_positive(error, "coating_shear", coating_shear)
        call check_positive(error, "substrate_shear", substrate_shear)
        call check_positive(error, "thickness", thickness)
    end subroutine check_body

    subroutine check_scale(error, radius, substrate_shear, work_of_adhesion, has_out)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), intent(in) :: radius, substrate_shear, work_of_adhesion
        logical, intent(in) :: has_out

        call check_positive(error, "radius", radius)
        call check_positive(error, "substrate_shear", substrate_shear)
        call check_positive(error, "work_of_adhesion", work_of_adhesion)
        call check_given(error, "out", has_out)
    end subroutine check_scale

end module mdrcontact_api_closed_forms
