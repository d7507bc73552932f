! SPDX-License-Identifier: GPL-3.0-or-later
!> Error of a compiled law against its contact, at states that were no part of making it.
module mdrcontact_law_verify
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_samples, only: samples_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_table, only: conductance_in, law_table_t, interval_in, values_in
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: add_conductance_error, largest_error

    !> Where in each panel of the samples, away from its nodes, law and contact are compared.
    real(wp), parameter :: probes(3) = [0.027_wp, 0.452_wp, 0.964_wp]

contains

    !> The largest relative error of F, a and k from the depth, and of d, a and k from the force.
    subroutine largest_error(by_depth, by_force, curve, equilibrium, of_depth, of_force, worst, solutions, error)
        type(law_table_t), intent(in) :: by_depth, by_force
        class(samples_t), intent(in) :: curve
        type(equilibrium_t), intent(in) :: equilibrium
        !> the segments the tables were made from, in the same order
        type(stable_segment_t), intent(in) :: of_depth(:), of_force(:)
        real(wp), intent(out) :: worst
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: x
        integer :: panel, probe, depth_segment, force_segment

        worst = 0.0_wp
        do panel = 1, size(curve%edges) - 1
            do probe = 1, size(probes)
                x = curve%edges(panel) + probes(probe)*(curve%edges(panel + 1) - curve%edges(panel))
                depth_segment = findloc(of_depth%first <= x .and. x <= of_depth%last, .true., dim=1)
                force_segment = findloc(of_force%first <= x .and. x <= of_force%last, .true., dim=1)
                if (depth_segment == 0 .and. force_segment == 0) cycle
                call check_cancelled(error)
                if (allocated(error)) return
                call curve%state_at(equilibrium, x, state, error)
                if (allocated(error)) return
                solutions = solutions + 1
                if (depth_segment > 0) worst = max(worst, maxval(relative_errors(by_depth, depth_segment, state)))
                if (force_segment > 0) worst = max(worst, maxval(relative_errors(by_force, force_segment, state)))
            end do
        end do
    end subroutine largest_error

    !> The same of G from the depth: `worst` becomes that where it is larger.
    subroutine add_conductance_error(by_depth, curve, equilibrium, of_depth, conductance, worst, error)
        type(law_table_t), intent(in) :: by_depth
        class(samples_t), intent(in) :: curve
        type(equilibrium_t), intent(in) :: equilibrium
        type(stable_segment_t), intent(in) :: of_depth(:)
        !> G(a)
        class(scalar_function_t), intent(inout) :: conductance
        real(wp), intent(inout) :: worst
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: x, found, slope, exact
        integer :: panel, segment

        do panel = 1, size(curve%edges) - 1
            x = curve%edges(panel) + probes(2)*(curve%edges(panel + 1) - curve%edges(panel))
            segment = findloc(of_depth%first <= x .and. x <= of_depth%last, .true., dim=1)
            if (segment == 0) cycle
            call check_cancelled(error)
            if (.not. allocated(error)) call curve%state_at(equilibrium, x, state, error)
            if (allocated(error)) return
            exact = conductance%value(state%radius)
            if (allocated(conductance%error)) then
                call move_alloc(conductance%error, error)
                return
            end if
            call conductance_in(by_depth, interval_in(by_depth, segment, state%depth), state%depth, found, slope)
            worst = max(worst, abs(found - exact)/(exact + merge(abs(state%depth*slope), 0.0_wp, by_depth%adhesive)))
        end do
    end subroutine add_conductance_error

    !> The errors of F or d, a and k at a state on a segment, relative to the value y of the contact and, with adhesion, to
    !> |y| + |s dy/ds|: y is then zero somewhere, and no number can be better than its argument s.
    pure function relative_errors(table, segment, state) result(errors)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: segment
        type(contact_state_t), intent(in) :: state
        real(wp) :: errors(3)
        real(wp) :: s, exact(3), found(3), slope, shift(3), beyond(3), unused
        real(wp), parameter :: step = 1.0e-6_wp

        s = state%depth
        exact = [state%force, state%radius, state%stiffness]
        if (.not. table%by_depth) then
            s = state%force
            exact(1) = state%depth
        end if
        call values_in(table, interval_in(table, segment, s), s, found(1), slope, found(2), found(3))
        shift = 0.0_wp
        if (table%adhesive) then
            call values_in(table, interval_in(table, segment, s), s + step*abs(s), beyond(1), unused, beyond(2), beyond(3))
            shift = abs(beyond - found)/step
            shift(1) = abs(s*slope)
        end if
        ! without contact a and k are 0
        errors = abs(found - exact)/max(abs(exact) + shift, tiny(1.0_wp))
    end function relative_errors

end module mdrcontact_law_verify
