! SPDX-License-Identifier: GPL-3.0-or-later
!> The coated half-space by the model of the caller's choice, for C.
module mdrcontact_api_coated
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_exact, only: deliver_exact
    use mdrcontact_api_handles, only: deliver_medium
    use mdrcontact_api_medium_options, only: gao_options, medium_options_t, model_bec, model_dimitriadis, model_doerner_nix, &
                                             model_exact, &
                                             model_gao, model_gao_series, model_garcia, model_hay_crawford, &
                                             model_mencik_exponential, model_mencik_reciprocal, model_perriot_barthel, &
                                             model_wave, options_or_defaults, raise_model
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium_bec, only: bec_t, new_bec
    use mdrcontact_medium_bottom_effect, only: bottom_effect_t, dimitriadis_series, garcia_series, new_bottom_effect
    use mdrcontact_medium_doerner_nix, only: doerner_nix_t, new_doerner_nix
    use mdrcontact_medium_gao, only: gao_t, new_gao
    use mdrcontact_medium_hay_crawford, only: hay_crawford_t, new_hay_crawford
    use mdrcontact_medium_mencik, only: mencik_t, new_mencik
    use mdrcontact_medium_perriot_barthel, only: new_perriot_barthel, perriot_barthel_t
    use mdrcontact_medium_wave, only: new_wave, wave_t
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
        if (model == model_exact) then
            status = deliver_exact([coating], [thickness], substrate_e, substrate_nu, options, out, error)
            return
        end if
        if (.not. allocated(error)) then
            if (model == model_dimitriadis .or. model == model_garcia) then
                call check_rigid(error, substrate_e)
            else
                call new_material(substrate, substrate_e, substrate_nu, error, "substrate")
            end if
        end if
        if (allocated(error)) then
            status = status_of(error)
        else
            status = deliver_model(model, coating, thickness, substrate, options, out)
        end if
    end function mdr_medium_coated

    !> Makes the medium of one model from checked materials.
    function deliver_model(model, coating, thickness, substrate, options, out) result(status)
        integer(c_int), intent(in) :: model
        type(material_t), intent(in) :: coating, substrate
        real(c_double), intent(in) :: thickness
        type(medium_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(medium_options_t) :: chosen
        type(error_t), allocatable :: error
        type(gao_t) :: gao
        type(doerner_nix_t) :: doerner_nix
        type(wave_t) :: wave
        type(mencik_t) :: mencik
        type(bec_t) :: bec
        type(perriot_barthel_t) :: perriot_barthel
        type(hay_crawford_t) :: hay_crawford
        type(bottom_effect_t) :: bottom_effect

        chosen = options_or_defaults(options)
        select case (model)
        case (model_gao, model_gao_series)
            call new_gao(gao, coating, thickness, substrate, error, gao_options(model, options))
            status = deliver_medium(gao, out, error)
        case (model_doerner_nix)
            call new_doerner_nix(doerner_nix, coating, thickness, substrate, error, chosen%alpha)
            status = deliver_medium(doerner_nix, out, error)
        case (model_wave)
            call new_wave(wave, coating, thickness, substrate, error, chosen%wave_factor)
            status = deliver_medium(wave, out, error)
        case (model_mencik_exponential, model_mencik_reciprocal)
            call new_mencik(mencik, coating, thickness, substrate, error, model == model_mencik_reciprocal, chosen%alpha)
            status = deliver_medium(mencik, out, error)
        case (model_bec)
            call new_bec(bec, coating, thickness, substrate, error)
            status = deliver_medium(bec, out, error)
        case (model_perriot_barthel)
            call new_perriot_barthel(perriot_barthel, coating, thickness, substrate, error)
            status = deliver_medium(perriot_barthel, out, error)
        case (model_hay_crawford)
            call new_hay_crawford(hay_crawford, coating, thickness, substrate, error)
            status = deliver_medium(hay_crawford, out, error)
        case (model_dimitriadis, model_garcia)
            if (model == model_garcia) then
                call new_bottom_effect(bottom_effect, coating, thickness, garcia_series, error)
            else
                call new_bottom_effect(bottom_effect, coating, thickness, dimitriadis_series, error)
            end if
            status = deliver_medium(bottom_effect, out, error)
        case default
            call raise_model(error, model, "a model of a coating in enum mdr_model")
            status = status_of(error)
        end select
    end function deliver_model

    !> The models of a layer on a rigid base know no other.
    pure subroutine check_rigid(error, substrate_e)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), intent(in) :: substrate_e

        if (.not. ieee_is_finite(substrate_e) .and. substrate_e > 0.0_c_double) return
        call raise(error, error_invalid, "substrate E = "//to_text(substrate_e)//" is not allowed: this model is for a layer "// &
                   "on a rigid base, substrate E = infinity")
    end subroutine check_rigid

end module mdrcontact_api_coated
