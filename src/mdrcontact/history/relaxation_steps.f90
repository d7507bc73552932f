! SPDX-License-Identifier: GPL-3.0-or-later
!> A history marched with steps that are halved until it does not change any more: second order, extrapolated.
module mdrcontact_history_relaxation_steps
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_cancel, only: report_progress
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_error, only: error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_history_relaxation_march, only: march_t, start_march, step_march
    use mdrcontact_history_relaxation_memory, only: memory_t, new_memory
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_model, only: models, new_medium
    implicit none (type, external)
    private
    public :: march_through

    !> Contacts are expected to be at most this much wider than elastic ones.
    real(wp), parameter :: margin = 1.3_wp
    !> Steps after a kink: in units of the shortest time, after first contact in units of the interval, and how fast they grow.
    real(wp), parameter :: first_step = 0.25_wp, first_touch = 1.0e-3_wp, growth = 1.6_wp
    integer, parameter :: most_levels = 9
    !> What the common times may add to the error of the transform, which is up to 1000 times smaller than that in time.
    real(wp), parameter :: memory_part = 1.0e-3_wp

contains

    !> Depth, radius and force at samples of a prescribed depth or force.
    subroutine march_through(contact, medium, given, time, values, tolerance, depth, radius, force, error)
        type(contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: medium
        !> given_depth or given_force
        integer, intent(in) :: given
        !> relative to the largest depth, radius and force
        real(wp), intent(in) :: time(:), values(:), tolerance
        real(wp), intent(inout) :: depth(:), radius(:), force(:)
        type(error_t), allocatable, intent(out) :: error
        type(memory_t) :: memory
        real(wp), dimension(size(time), 3) :: now, before, best, best_before
        real(wp) :: limit, change
        integer :: level

        if (given /= given_depth .and. given /= given_force) then
            call raise(error, error_invalid, "radius is not allowed: for this body or this path prescribe depth or force")
        else if (contact%equilibrium%profile%end_radius > 0.0_wp) then
            call raise(error, error_invalid, "this history is not offered for indenters with a flat end: see what answers a "// &
                       "step under a flat punch")
        else if (medium%model /= models%exact) then
            call raise(error, error_invalid, "this history needs the model exact: it does not follow from elastic curves")
        end if
        if (.not. allocated(error)) call widest(contact, medium, given, maxval(values), limit, error)
        if (.not. allocated(error)) call new_memory(memory, medium, limit, memory_part*tolerance, error)
        if (allocated(error)) return
        best_before = 0.0_wp
        before = 0.0_wp
        change = huge(1.0_wp)
        do level = 0, most_levels
            call march_once(contact, memory, limit, given, time, values, level, now, error)
            if (allocated(error)) return
            best = (4.0_wp*now - before)/3.0_wp
            if (level == 1) change = largest_change(now, best)
            ! the error of `best` falls at most as fast as the fourth power of the step: what falls faster falls by chance
            if (level > 1) change = max(change/16.0_wp, largest_change(best, best_before))
            if (level > 0 .and. change <= tolerance) then
                depth = merge(now(:, 1), best(:, 1), given == given_depth)
                ! where contact is lost between two steps, or between the levels, there is nothing to extrapolate
                where (now(:, 2) > 0.0_wp .and. before(:, 2) > 0.0_wp)
                    radius = best(:, 2)
                    force = best(:, 3)
                else where
                    radius = now(:, 2)
                    force = now(:, 3)
                end where
                return
            end if
            best_before = best
            before = now
        end do
        call raise(error, error_no_convergence, "the history did not reach the relative tolerance "//to_text(tolerance)// &
                   ": the last halving of the steps changed it by "//to_text(change))
    end subroutine march_through

    pure function largest_change(one, other) result(change)
        real(wp), intent(in) :: one(:, :), other(:, :)
        real(wp) :: change
        integer :: i

        change = 0.0_wp
        do i = 1, size(one, 2)
            change = max(change, maxval(abs(one(:, i) - other(:, i)))/max(maxval(abs(one(:, i))), tiny(1.0_wp)))
        end do
    end function largest_change

    !> A radius that the contact does not exceed: more than that of the glassy and of the relaxed body.
    subroutine widest(contact, medium, given, largest, radius, error)
        type(contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: medium
        integer, intent(in) :: given
        real(wp), intent(in) :: largest
        real(wp), intent(out) :: radius
        type(error_t), allocatable, intent(inout) :: error
        type(material_t) :: relaxed(size(medium%thickness) + 1)
        type(stack_t) :: body
        class(medium_t), allocatable :: elastic
        type(contact_t) :: resting
        type(contact_state_t) :: state
        integer :: i

        radius = 0.0_wp
        if (.not. medium%has_glassy()) then
            call raise(error, error_invalid, "this history is offered for materials with a glassy and a relaxed limit only: no "// &
                       "power laws, no dashpots, no liquids")
            return
        end if
        do i = 1, size(medium%materials)
            call medium%materials(i)%relaxed(relaxed(i), error)
            if (allocated(error)) return
        end do
        call new_stack(body, relaxed(:size(medium%thickness)), medium%thickness, relaxed(size(relaxed)), error, medium%rigid_base)
        if (.not. allocated(error)) call new_medium(elastic, body, models%exact, error)
        do i = 1, 2
            if (allocated(error)) return
            if (i == 1) call new_contact(resting, contact%equilibrium%profile, elastic, error)
            if (i == 2) call new_contact(resting, contact%equilibrium%profile, medium%reference, error)
            if (allocated(error)) return
            if (given == given_depth) call resting%at_depth(largest, state, error)
            if (given == given_force) call resting%at_force(largest, state, error)
            radius = max(radius, margin*state%radius)
        end do
        radius = min(radius, contact%equilibrium%last_radius)
    end subroutine widest

    !> The whole history with each step cut into 2^level.
    subroutine march_once(contact, memory, limit, given, time, values, level, states, error)
        type(contact_t), intent(in) :: contact
        type(memory_t), intent(in) :: memory
        real(wp), intent(in) :: limit, time(:), values(:)
        integer, intent(in) :: given, level
        !> (sample, depth, radius, force)
        real(wp), intent(out) :: states(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(march_t) :: march
        real(wp) :: length, done, h, part, slope
        integer :: i, j, cuts

        call start_march(march, contact%equilibrium%profile, memory, limit)
        cuts = 2**level
        if (values(1) > 0.0_wp) call step_march(march, 0.0_wp, given, values(1), error)
        states(1, :) = [merge(values(1), march%depth, given == given_depth), march%radius, march%force]
        do i = 2, size(time)
            call report_progress(real(level, wp) + real(i - 2, wp)/real(size(time), wp))
            length = time(i) - time(i - 1)
            slope = (values(i) - values(i - 1))/length
            done = 0.0_wp
            h = min(first_step*memory%shortest, length)
            if (.not. march%radius > 0.0_wp .and. values(i) > 0.0_wp) then
                ! up to first contact in one step
                if (values(i - 1) < 0.0_wp) done = -values(i - 1)/slope
                if (done > 0.0_wp) call step_march(march, done, given, 0.0_wp, error)
                h = min(h, first_touch*(length - done))
            end if
            do while (done < length)
                if (length - done < 1.3_wp*h) h = length - done
                do j = 1, cuts
                    part = done + h*real(j, wp)/real(cuts, wp)
                    call step_march(march, h/real(cuts, wp), given, values(i - 1) + slope*part, error)
                    if (allocated(error)) return
                end do
                done = done + h
                h = growth*h
            end do
            if (given == given_depth) march%depth = values(i)
            states(i, :) = [march%depth, march%radius, march%force]
        end do
    end subroutine march_once

end module mdrcontact_history_relaxation_steps
