! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts whose work of adhesion depends on the speed of their edge, for C.
module mdrcontact_api_adhesion_rate
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_loc, c_ptr, c_sizeof
    use mdrcontact_api_adhesion_open_handle, only: open_handle
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_rate_options_t
    use mdrcontact_api_status, only: check_given
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_adhesion_rate_law, only: new_rate_law, new_surface_law, rate_law_t
    use mdrcontact_material_rheology, only: rheology_t
    implicit none (type, external)
    private
    public :: read_law

contains

    !> The law of some options.
    subroutine read_law(options, given, law, error)
        type(c_ptr), intent(in) :: options
        type(c_rate_options_t), target, intent(out) :: given
        type(rate_law_t), intent(out) :: law
        type(error_t), allocatable, intent(inout) :: error
        type(rheology_t), pointer :: material
        real(c_double) :: speeds(5)

        call check_given(error, "options", c_associated(options))
        call read_options(error, "options", options, c_loc(given), c_sizeof(given))
        if (allocated(error)) return
        speeds = [given%speed, given%exponent, given%closing_work, given%closing_speed, given%closing_exponent]
        if (.not. c_associated(given%material) .and. given%cohesive_stress /= 0.0_c_double) then
            call raise(error, error_invalid, ": it needs a material. Give the material, or set cohesive_stress = 0", &
                       "cohesive_stress")
        else if (.not. c_associated(given%material)) then
            call new_rate_law(law, given%work, given%speed, given%exponent, error, given%closing_work, given%closing_speed, &
                              given%closing_exponent)
        else if (any(speeds /= 0.0_c_double)) then
            call raise(error, error_invalid, ": it determines speeds, exponents and closing_work. Set these to 0, or omit the "// &
                       "material", "material")
        else
            call open_handle(given%material, "material", material, error)
            if (.not. allocated(error)) call new_surface_law(law, material, given%work, given%cohesive_stress, error)
        end if
    end subroutine read_law

end module mdrcontact_api_adhesion_rate
