! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of a rigid indenter with a body that relaxes. Its states depend on time.
module mdrcontact_history_relaxing_contact
    use mdrcontact_contact, only: check_adhesion, contact_options_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t, new_equilibrium
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: relaxing_contact_t, new_relaxing_contact

    !> An indenter on a body that relaxes. It holds copies of both and never changes.
    type :: relaxing_contact_t
        !> the body
        type(viscoelastic_t), allocatable :: medium
        !> of the indenter with the body's elastic reference: how large contacts can be
        type(equilibrium_t) :: equilibrium
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
        !> without adhesion; a zeta for a body under an approximate model
        type(contact_options_t), intent(in), optional :: options
        integer :: stat

        if (present(options)) then
            call check_adhesion(options%work_of_adhesion, options%adhesion_rule, error)
            if (options%work_of_adhesion > 0.0_wp) then
                call raise(error, error_invalid, " = "//to_text(options%work_of_adhesion)//" is not allowed with a "// &
                           "viscoelastic body: how much its edge holds depends on how fast it moves; take its relaxed "// &
                           "moduli and a work of adhesion that depends on speed", "work_of_adhesion")
            else if (options%zeta_is_exact) then
                call raise(error, error_invalid, "the exact zeta is not allowed here: it needs an elastic body")
            end if
            if (allocated(error)) return
            call new_equilibrium(self%equilibrium, profile, medium%reference, error, options%zeta)
        else
            call new_equilibrium(self%equilibrium, profile, medium%reference, error)
        end if
        if (allocated(error)) return
        allocate (self%medium, source=medium, stat=stat)
        call check_memory(error, stat)
    end subroutine new_relaxing_contact

end module mdrcontact_history_relaxing_contact
