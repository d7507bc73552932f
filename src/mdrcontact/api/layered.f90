! SPDX-License-Identifier: GPL-3.0-or-later
!> Coated, layered and graded half-spaces under a model of the caller's choice, for C.
module mdrcontact_api_layered
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_positive, check_not_empty
    use mdrcontact_api_callback, only: c_function_t, new_c_function
    use mdrcontact_api_handles, only: deliver_solver, hand_over_solver
    use mdrcontact_api_medium_options, only: read_medium_options
    use mdrcontact_body, only: body_t
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body, new_graded_body_from_functions
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: check_memory, count_text, error_invalid, error_t, raise
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t
    use mdrcontact_model, only: model_options_t, new_solver
    implicit none (type, external)
    private
    public :: mdr_medium_coated, mdr_medium_layered, mdr_medium_graded, mdr_medium_graded_callback, mdr_medium_power_graded

contains

    function mdr_medium_coated(coating_e, coating_nu, thickness, substrate_e, substrate_nu, model, options, out) &
        result(status) bind(C, name="mdrcontact_entry_medium_coated")
        real(c_double), value :: coating_e, coating_nu, thickness, substrate_e, substrate_nu
        integer(c_int), value :: model
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(material_t) :: coating
        type(stack_t) :: body
        type(error_t), allocatable :: error

        call new_material(coating, coating_e, coating_nu, error, "coating")
        if (.not. allocated(error)) call new_body(body, [coating], [thickness], substrate_e, substrate_nu, error)
        status = deliver_model(body, model, options, out, error)
    end function mdr_medium_coated

    function mdr_medium_layered(n, e, nu, thickness, substrate_e, substrate_nu, model, options, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_layered")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: e(*), nu(*), thickness(*)
        real(c_double), value :: substrate_e, substrate_nu
        integer(c_int), value :: model
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(material_t), allocatable :: layers(:)
        type(stack_t) :: body
        type(error_t), allocatable :: error

        call check_count(error, n)
        if (n == 0) call raise(error, error_invalid, "n = 0 is not allowed: there must be at least one layer")
        call check_array(error, "E", n, present(e))
        call check_array(error, "nu", n, present(nu))
        call check_array(error, "thickness", n, present(thickness))
        if (.not. allocated(error)) call new_layers(layers, e(:n), nu(:n), error)
        if (.not. allocated(error)) call check_each_positive(error, "thickness", thickness(:n))
        if (.not. allocated(error)) call new_body(body, layers, thickness(:n), substrate_e, substrate_nu, error)
        status = deliver_model(body, model, options, out, error)
    end function mdr_medium_layered

    function mdr_medium_graded(n, z, e, nu, model, options, out) result(status) bind(C, name="mdrcontact_entry_medium_graded")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: z(*), e(*), nu(*)
        integer(c_int), value :: model
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(graded_body_t) :: body
        type(error_t), allocatable :: error

        call check_count(error, n)
        call check_not_empty(error, "z", n, 2)
        call check_array(error, "z", n, present(z))
        call check_array(error, "E", n, present(e))
        call check_array(error, "nu", n, present(nu))
        if (.not. allocated(error)) call new_graded_body(body, z(:n), e(:n), nu(:n), error)
        status = deliver_model(body, model, options, out, error)
    end function mdr_medium_graded

    function mdr_medium_graded_callback(e, nu, context, depth, model, options, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_graded_callback")
        type(c_funptr), value :: e, nu
        type(c_ptr), value :: context
        real(c_double), value :: depth
        integer(c_int), value :: model
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_function_t) :: young, poisson
        type(graded_body_t) :: body
        type(error_t), allocatable :: error

        call new_c_function(young, "E", e, context, error)
        call new_c_function(poisson, "nu", nu, context, error)
        if (.not. allocated(error)) call new_graded_body_from_functions(body, young, poisson, depth, error)
        status = deliver_model(body, model, options, out, error)
    end function mdr_medium_graded_callback

    function mdr_medium_power_graded(e0, z0, exponent, nu, out) result(status) bind(C, name="mdrcontact_entry_medium_power_graded")
        real(c_double), value :: e0, z0, exponent, nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_graded_t) :: medium
        type(error_t), allocatable :: error

        call new_power_graded(medium, e0, z0, exponent, nu, error)
        status = deliver_solver(medium, out, error)
    end function mdr_medium_power_graded

    !> The medium of a body, unless there is an error already.
    function deliver_model(body, model, options, out, error) result(status)
        class(body_t), intent(in) :: body
        integer(c_int), intent(in) :: model
        type(c_ptr), intent(in) :: options
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        class(solver_t), allocatable :: medium
        type(model_options_t) :: chosen

        call read_medium_options(error, options, chosen)
        if (.not. allocated(error)) call new_solver(medium, body, int(model), error, chosen)
        status = hand_over_solver(medium, out, error)
    end function deliver_model

    !> Layers that have been checked, on a substrate or, with an infinite substrate_e, on a rigid base.
    subroutine new_body(body, layers, thickness, substrate_e, substrate_nu, error)
        type(stack_t), intent(out) :: body
        type(material_t), intent(in) :: layers(:)
        real(c_double), intent(in) :: thickness(:), substrate_e, substrate_nu
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: substrate
        logical :: rigid_base

        rigid_base = .not. ieee_is_finite(substrate_e) .and. substrate_e > 0.0_c_double
        if (.not. rigid_base) call new_material(substrate, substrate_e, substrate_nu, error, "substrate")
        if (.not. allocated(error)) call new_stack(body, layers, thickness, substrate, error, rigid_base)
    end subroutine new_body

    subroutine new_layers(layers, e, nu, error)
        type(material_t), allocatable, intent(out) :: layers(:)
        real(c_double), intent(in) :: e(:), nu(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i, stat

        allocate (layers(size(e)), stat=stat)
        call check_memory(error, stat)
        do i = 1, size(e)
            if (allocated(error)) return
            call new_material(layers(i), e(i), nu(i), error, "layer "//count_text(i))
        end do
    end subroutine new_layers

end module mdrcontact_api_layered
