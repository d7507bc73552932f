! SPDX-License-Identifier: GPL-3.0-or-later
!> Conductance along the loading of a contact: G at the radius of each state, dG/dd = G'(a)/d'(a) and dG/dF = G'(a)/F'(a)
!> (theory/conduction.md (8.1)).
!>
!> Without adhesion d' is the solver's own and F' = k d'. With it the elongation at the edge is differentiated, of which a central
!> difference of fourth order takes some 1e-9.
module mdrcontact_conduction_along
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_fields, only: conductance_at
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_coordinate, only: coordinate_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: conductance_along

    !> Part of the radius by which neighbours of an adhesive state differ.
    real(wp), parameter :: step = 2.0e-3_wp

contains

    !> G, dG/dF and dG/dd of a state.
    subroutine conductance_along(conduction, contact, state, conductance, by_force, by_depth, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        !> of this contact, a > 0
        type(contact_state_t), intent(in) :: state
        !> [conductance], [conductance/force], [conductance/length]: at a vertical wall the radius stays, and both slopes are 0
        real(wp), intent(out) :: conductance, by_force, by_depth
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: slope, rates(2)

        conductance = 0.0_wp
        by_force = 0.0_wp
        by_depth = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "state: its radius is 0, so that no flux passes")
            return
        end if
        if (state%zone_radius > 0.0_wp) then
            call raise(error, error_invalid, "cohesive_stress: the derivative of the conductance is not available. Use the "// &
                       "conductance at the contact radius")
            return
        end if
        call conductance_at(conduction, state%radius, conductance, slope, error)
        if (allocated(error)) return
        associate (equilibrium => contact%equilibrium)
            if (equilibrium%profile%has_wall .and. state%radius >= equilibrium%profile%largest_radius) return
            if (equilibrium%ends_sharply() .and. state%radius >= equilibrium%last_radius) return
        end associate
        call rates_of(contact, state%radius, rates, error)
        if (allocated(error)) return
        by_depth = slope/rates(1)
        by_force = slope/rates(2)
    end subroutine conductance_along

    !> d'(a) and F'(a) of the contact in equilibrium.
    subroutine rates_of(contact, a, rates, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: a
        real(wp), intent(out) :: rates(2)
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        type(coordinate_t) :: coordinate
        real(wp) :: slopes(3), excess(-2:2), load(-2:2)
        integer :: i

        rates = 0.0_wp
        associate (equilibrium => contact%equilibrium)
            call equilibrium%parts(a, state, error, slopes)
            if (allocated(error)) return
            coordinate = equilibrium%coordinate()
            rates = [state%depth, state%force]*slopes(:2)/coordinate%rate(a)
            if (.not. all(rates > 0.0_wp)) then
                call raise(error, error_invalid, "the depth of this medium has no slope over the contact radius")
                return
            end if
            if (.not. contact%is_adhesive()) return
            do i = -2, 2
                call equilibrium%parts(a*(1.0_wp + i*step), state, error)
                if (allocated(error)) return
                excess(i) = state%punch_depth
                load(i) = state%stiffness*state%punch_depth
            end do
        end associate
        rates(1) = rates(1) + difference(excess)/(a*step)
        rates(2) = rates(2) + difference(load)/(a*step)
    end subroutine rates_of

    pure function difference(y) result(slope)
        real(wp), intent(in) :: y(-2:2)
        real(wp) :: slope

        slope = (8.0_wp*(y(1) - y(-1)) - (y(2) - y(-2)))/12.0_wp
    end function difference

end module mdrcontact_conduction_along
