! SPDX-License-Identifier: GPL-3.0-or-later
!> The exact layered medium, for C: what coatings and layers with MDR_MODEL_EXACT share.
module mdrcontact_api_exact
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: deliver_medium
    use mdrcontact_api_medium_options, only: medium_options_t, options_or_defaults
    use mdrcontact_error, only: error_t
    use mdrcontact_layered_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_material, only: material_t, new_material
    implicit none (type, external)
    private
    public :: deliver_exact

contains

    !> Layers that have been checked, on a substrate or, with an infinite substrate_e, on a rigid base.
    function deliver_exact(layers, thickness, substrate_e, substrate_nu, options, out, error) result(status)
        type(material_t), intent(in) :: layers(:)
        real(c_double), intent(in) :: thickness(:)
        real(c_double), intent(in) :: substrate_e, substrate_nu
        type(medium_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(medium_options_t) :: chosen
        type(material_t) :: substrate
        type(layered_exact_t) :: medium
        logical :: rigid_base

        chosen = options_or_defaults(options)
        rigid_base = .not. ieee_is_finite(substrate_e) .and. substrate_e > 0.0_c_double
        if (.not. (rigid_base .or. allocated(error))) then
            call new_material(substrate, substrate_e, substrate_nu, error, "substrate")
        end if
        if (.not. allocated(error)) then
            call new_layered_exact(medium, layers, thickness, substrate, error, chosen%tolerance, rigid_base)
        end if
        status = deliver_medium(medium, out, error)
    end function deliver_exact

end module mdrcontact_api_exact
