! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of a rigid indenter with a viscoelastic body. Its states depend on time.
module mdrcontact_contact_relaxing_contact
    use mdrcontact_object, only: room
    use mdrcontact_contact, only: check_adhesion, check_cohesion, contact_options_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t, new_equilibrium
    use mdrcontact_error, only: check_made, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: relaxing_contact_t, new_relaxing_contact, refuse_attraction

    !> An indenter on a viscoelastic body. It holds copies of both and never changes.
    type :: relaxing_contact_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> the body
        type(viscoelastic_t), allocatable :: medium
        !> of the indenter with the body's elastic reference: how large contacts can be
        type(equilibrium_t) :: equilibrium
        !> gamma [modulus length] and sigma_0 [modulus] of an finite-range adhesion; 0: none
        real(wp) :: work_of_adhesion = 0.0_wp, cohesive_stress = 0.0_wp
    end type relaxing_contact_t

contains

    !> A contact of `profile` with `medium`.
    subroutine new_relaxing_contact(self, profile, medium, error, options)
        type(relaxing_contact_t), intent(out) :: self
        !> copied
        class(profile_t), intent(in) :: profile
        !> copied
        type(viscoelastic_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> without adhesion, or with a cohesive stress on a half-space; a zeta for a body under an approximate model
        type(contact_options_t), intent(in), optional :: options

        call check_made(error, "profile", profile%is_made)
        call check_made(error, "medium", medium%is_made)
        if (allocated(error)) return
        if (present(options)) then
            call check_adhesion(options%work_of_adhesion, options%adhesion_rule, error)
            if (options%work_of_adhesion > 0.0_wp .or. options%cohesive_stress /= 0.0_wp) then
                call check_attraction(profile, medium, options, error)
                self%work_of_adhesion = options%work_of_adhesion
                self%cohesive_stress = options%cohesive_stress
            else if (options%zeta_is_exact) then
                call raise(error, error_invalid, "zeta = exact: it needs an elastic body")
            end if
            if (allocated(error)) return
            call new_equilibrium(self%equilibrium, profile, medium%reference, error, options%zeta)
        else
            call new_equilibrium(self%equilibrium, profile, medium%reference, error)
        end if
        if (allocated(error)) return
        call room(medium%bytes(), error)
        if (.not. allocated(error)) allocate (self%medium, source=medium)
        self%is_made = .not. allocated(error)
    end subroutine new_relaxing_contact

    !> Raises where the contact has a cohesive zone, which moves when anything does.
    pure subroutine refuse_attraction(contact, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(error) .or. .not. contact%cohesive_stress > 0.0_wp) return
        call raise(error, error_invalid, "cohesive_stress: a viscoelastic contact with a cohesive zone has an adhesive "// &
                   "history only. Use the adhesive history")
    end subroutine refuse_attraction

    !> Raises unless the adhesion has a range and the body is a half-space that creeps from one modulus to another.
    subroutine check_attraction(profile, medium, options, error)
        class(profile_t), intent(in) :: profile
        type(viscoelastic_t), intent(in) :: medium
        type(contact_options_t), intent(in) :: options
        type(error_t), allocatable, intent(inout) :: error

        call check_cohesion(options, error)
        if (allocated(error)) return
        if (.not. options%cohesive_stress > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(options%work_of_adhesion)//": on a viscoelastic body adhesion "// &
                       "depends on the speed of the edge. Give the cohesive_stress of a half-space, or use the relaxed moduli "// &
                       "with a rate-dependent work of adhesion", "work_of_adhesion")
        else if (size(medium%thickness) > 0) then
            call raise(error, error_invalid, " = "//to_text(options%cohesive_stress)//": a cohesive zone is not available on "// &
                       "viscoelastic layers. Use the relaxed moduli with a rate-dependent work of adhesion", "cohesive_stress")
        else if (profile%has_wall .or. profile%end_radius > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(options%cohesive_stress)//": on a viscoelastic body it needs an "// &
                       "indenter without a flat end or vertical wall, so that the contact edge can move", "cohesive_stress")
        else if (.not. medium%materials(1)%has_glassy() .or. .not. medium%materials(1)%shear%limit > 0.0_wp &
                 .or. medium%materials(1)%is_power_law()) then
            call raise(error, error_invalid, " = "//to_text(options%cohesive_stress)//": it needs a material with a glassy "// &
                       "and a relaxed modulus", "cohesive_stress")
        end if
    end subroutine check_attraction

end module mdrcontact_contact_relaxing_contact
