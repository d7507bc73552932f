! SPDX-License-Identifier: GPL-3.0-or-later
!> The coated half-space by the model of the caller's choice, for C.
module mdrcontact_api_coated
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: deliver_medium
    use mdrcontact_api_medium_options, only: medium_options_t, model_gao, model_gao_series, options_or_defaults
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium_gao, only: gao_t, new_gao
    implicit none (type, external)
    private
    public :: mdr_medium_coated

contains

    function mdr_medium_coated(coating_e, coating_nu, thickness, substrate_e, substrate_nu, model, options, out) &
        result(status) bind(C)
        real(c_double), value :: coating_e, coating_nu, thickness, substrate_e, substrate_nu
        integer(c_int), value :: model
        type(medium_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(material_t) :: coating, substrate
        type(error_t), allocatable :: error

        call new_material(coating, coating_e, coating_nu, error, "coating")
        if (.not. allocated(error)) call new_material(substrate, substrate_e, substrate_nu, error, "substrate")
        if (allocated(error)) then
            status = status_of(error)
            return
        end if
        select case (model)
        case (model_gao, model_gao_series)
            call deliver_gao()
        case default
            call raise(error, error_invalid, "model = "//count_text(int(model))//" is not allowed: "// &
                       "it must be one of enum mdr_model")
            status = status_of(error)
        end select

    contains

        subroutine deliver_gao()
            type(gao_t) :: medium
            type(medium_options_t) :: chosen

            chosen = options_or_defaults(options)
            call new_gao(medium, coating, thickness, substrate, error, model == model_gao_series, &
                         int(chosen%weight_nu_choice), chosen%weight_nu)
            status = deliver_medium(medium, out, error)
        end subroutine deliver_gao

    end function mdr_medium_coated

end module mdrcontact_api_coated
