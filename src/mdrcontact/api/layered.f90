! SPDX-License-Identifier: GPL-3.0-or-later
!> Layered and graded half-spaces, for C.
module mdrcontact_api_layered
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_not_empty, check_each_positive
    use mdrcontact_api_callback, only: c_function_t, new_c_function
    use mdrcontact_api_exact, only: deliver_exact
    use mdrcontact_api_handles, only: deliver_medium
    use mdrcontact_api_medium_options, only: gao_options, medium_options_t, model_exact, model_gao, &
                                             model_gao_series, options_or_defaults, raise_model
    use mdrcontact_api_status, only: check_memory
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body, new_graded_body_from_functions
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_layered_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium_gao, only: gao_t, new_gao_layered
    use mdrcontact_medium_graded, only: graded_t, new_graded
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t
    implicit none (type, external)
    private
    public :: mdr_medium_layered, mdr_medium_graded, mdr_medium_graded_callback, mdr_medium_power_graded

contains

    function mdr_medium_layered(n, e, nu, thickness, substrate_e, substrate_nu, model, options, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: e(*), nu(*), thickness(*)
        real(c_double), value :: substrate_e, substrate_nu
        integer(c_int), value :: model
        type(medium_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(material_t), allocatable :: layers(:)
        type(material_t) :: substrate
        type(gao_t) :: medium
        type(error_t), allocatable :: error

        call check_count(error, n)
        if (n == 0) call raise(error, error_invalid, "n = 0 is not allowed: there must be at least one layer")
        call check_array(error, "E", n, present(e))
        call check_array(error, "nu", n, present(nu))
        call check_array(error, "thickness", n, present(thickness))
        if (model /= model_exact) call check_model(error, model, "MDR_MODEL_GAO, MDR_MODEL_GAO_SERIES or MDR_MODEL_EXACT")
        if (.not. allocated(error)) call new_layers(layers, e(:n), nu(:n), error)
        if (.not. allocated(error)) call check_each_positive(error, "thickness", thickness(:n))
        if (model == model_exact .and. .not. allocated(error)) then
            status = deliver_exact(layers, thickness(:n), substrate_e, substrate_nu, options, out, error)
            return
        end if
        if (.not. allocated(error)) call new_material(substrate, substrate_e, substrate_nu, error, "substrate")
        if (.not. allocated(error)) then
            call new_gao_layered(medium, layers, thickness(:n), substrate, error, gao_options(model, options))
        end if
        status = deliver_medium(medium, out, error)
    end function mdr_medium_layered

    function mdr_medium_graded(n, z, e, nu, model, options, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: z(*), e(*), nu(*)
        integer(c_int), value :: model
        type(medium_options_t), intent(in), optional :: options
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
        status = deliver_graded(body, model, options, out, error)
    end function mdr_medium_graded

    function mdr_medium_graded_callback(e, nu, context, depth, model, options, out) result(status) bind(C)
        type(c_funptr), value :: e, nu
        type(c_ptr), value :: context
        real(c_double), value :: depth
        integer(c_int), value :: model
        type(medium_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_function_t) :: young, poisson
        type(graded_body_t) :: body
        type(error_t), allocatable :: error

        call new_c_function(young, "E", e, context, error)
        call new_c_function(poisson, "nu", nu, context, error)
        if (.not. allocated(error)) call new_graded_body_from_functions(body, young, poisson, depth, error)
        status = deliver_graded(body, model, options, out, error)
    end function mdr_medium_graded_callback

    function deliver_graded(body, model, options, out, error) result(status)
        type(graded_body_t), intent(in) :: body
        integer(c_int), intent(in) :: model
        type(medium_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(graded_t) :: medium
        type(layered_exact_t) :: exact
        type(medium_options_t) :: chosen

        if (model == model_exact) then
            chosen = options_or_defaults(options)
            if (.not. allocated(error)) call new_layered_exact(exact, body, error, chosen%tolerance)
            status = deliver_medium(exact, out, error)
            return
        end if
        call check_model(error, model, "MDR_MODEL_GAO, MDR_MODEL_GAO_SERIES or MDR_MODEL_EXACT")
        if (.not. allocated(error)) call new_graded(medium, body, error, gao_options(model, options))
        status = deliver_medium(medium, out, error)
    end function deliver_graded

    function mdr_medium_power_graded(e0, z0, exponent, nu, out) result(status) bind(C)
        real(c_double), value :: e0, z0, exponent, nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_graded_t) :: medium
        type(error_t), allocatable :: error

        call new_power_graded(medium, e0, z0, exponent, nu, error)
        status = deliver_medium(medium, out, error)
    end function mdr_medium_power_graded

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

    pure subroutine check_model(error, model, allowed)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: model
        character(len=*), intent(in) :: allowed

        if (model == model_gao .or. model == model_gao_series) return
        call raise_model(error, model, allowed)
    end subroutine check_model

end module mdrcontact_api_layered
