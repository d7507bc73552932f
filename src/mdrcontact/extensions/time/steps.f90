! SPDX-License-Identifier: GPL-3.0-or-later
!> A history integrated with steps that are halved until it does not change any more: second order, extrapolated.
module mdrcontact_time_steps
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_cancel, only: report_progress
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, given_depth, given_force, given_radius
    use mdrcontact_error, only: error_domain, error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_time_march, only: march_t, mark_kink, start_march, step_march
    use mdrcontact_time_memory, only: memory_t, new_memory
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_model, only: model_options_t, models, new_solver
    implicit none (type, external)
    private
    public :: march_through

    !> Contacts are expected to be at most this much wider than elastic ones; if they are not, they are searched for in twice that,
    !> so many times at most.
    real(wp), parameter :: margin = 1.3_wp
    integer, parameter :: most_widenings = 6
    !> Relative tolerance of elastic contacts that only give a bound.
    real(wp), parameter :: of_bound = 1.0e-3_wp
    !> Steps after a kink: in units of the shortest time, after first contact in units of the interval, and how fast they grow.
    real(wp), parameter :: first_step = 0.25_wp, first_touch = 1.0e-3_wp, growth = 1.6_wp
    !> The same after a kink of a power law in units of the shortest interval, and what is a kink, of the steepest slope.
    real(wp), parameter :: first_part = 1.0e-3_wp, kink = 0.1_wp
    integer, parameter :: most_levels = 9
    !> The change by a halving falls at most by this factor from one halving to the next.
    real(wp), parameter :: fastest = 16.0_wp
    !> Halvings one after the other without any fall, after which none is expected.
    integer, parameter :: most_rises = 2
    !> Contribution of the common times to the error of the transform, which is up to 1000 times smaller than that in time.
    real(wp), parameter :: memory_part = 1.0e-3_wp

contains

    !> Depth, radius and force at samples of a prescribed depth or force.
    subroutine march_through(contact, medium, given, time, values, tolerance, depth, radius, force, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: medium
        !> given_depth, given_force or given_radius
        integer, intent(in) :: given
        !> relative to the largest depth, radius and force
        real(wp), intent(in) :: time(:), values(:), tolerance
        real(wp), intent(inout) :: depth(:), radius(:), force(:)
        type(error_t), allocatable, intent(out) :: error
        type(viscoelastic_t) :: solid
        type(contact_state_t) :: state
        real(wp) :: limit, shortest, span
        integer :: i

        if (medium%model /= models%exact) then
            call raise(error, error_invalid, "model: this history needs the model exact, because it does not follow from "// &
                "elastic curves")
        else if (medium%materials(1)%shear%viscosity > 0.0_wp) then
            call raise(error, error_invalid, "material: this history is not available for a surface with a parallel dashpot, "// &
                       "because the edge pressure of a growing contact is infinite")
        end if
        if (allocated(error)) return
        span = 1.0_wp
        shortest = 1.0_wp
        if (size(time) > 1) then
            span = time(size(time)) - time(1)
            shortest = first_part*minval(time(2:) - time(:size(time) - 1))
        end if
        solid = medium
        do i = 1, size(solid%materials)
            solid%materials(i) = medium%materials(i)%between(shortest, span, memory_part*tolerance)
        end do
        call widest(contact, medium, solid, span, given, maxval(values), limit, error)
        do i = 0, most_widenings
            if (allocated(error)) return
            call refine(contact, solid, limit, shortest, span, given, time, values, tolerance, depth, radius, force, error)
            if (.not. allocated(error) .or. i == most_widenings .or. limit >= contact%equilibrium%last_radius) exit
            if (error%code /= error_domain) return
            deallocate (error)
            limit = min(2.0_wp*limit, contact%equilibrium%last_radius)
        end do
        if (allocated(error)) return
        if (values(1) > 0.0_wp .and. .not. all(medium%materials%has_glassy())) then
            call at_once(contact, medium, given, values(1), state, error)
            depth(1) = state%depth
            radius(1) = state%radius
            force(1) = state%force
        end if
        select case (given)
        case (given_depth)
            depth = values
        case (given_force)
            force = values
        case default
            radius = values
        end select
    end subroutine march_through

    !> The state after a jump onto a body in which power laws and dashpots are rigid at first.
    subroutine at_once(contact, medium, given, value, state, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: medium
        integer, intent(in) :: given
        real(wp), intent(in) :: value
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(material_t) :: material(size(medium%materials))
        integer :: i, n

        n = findloc(medium%materials%has_glassy(), .false., dim=1) - 1
        if (n == 0) return
        do i = 1, n
            call medium%materials(i)%glassy(material(i), error)
        end do
        if (.not. allocated(error)) then
            call find_resting(contact, material(:n), medium%thickness(:n), medium%bonds(:n), material(n), .true., &
                              medium%options, given, value, state, error)
        end if
    end subroutine at_once

    !> The state of an elastic body.
    subroutine find_resting(contact, layers, thickness, bonds, base, is_rigid, options, given, value, state, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(material_t), intent(in) :: layers(:), base
        real(wp), intent(in) :: thickness(:), value
        type(bond_t), intent(in) :: bonds(:)
        logical, intent(in) :: is_rigid
        type(model_options_t), intent(in) :: options
        integer, intent(in) :: given
        type(contact_state_t), intent(inout) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(stack_t) :: body
        class(solver_t), allocatable :: elastic
        type(contact_t) :: resting
        type(contact_state_t) :: states(1)

        call new_stack(body, layers, thickness, base, error, is_rigid, bonds)
        if (.not. allocated(error)) call new_solver(elastic, body, models%exact, error, options)
        if (.not. allocated(error)) call new_contact(resting, contact%equilibrium%profile, elastic, error)
        if (.not. allocated(error)) call contact_states(resting, given, [value], states, error)
        if (.not. allocated(error)) state = states(1)
    end subroutine find_resting

    !> Halves the steps until nothing changes any more.
    subroutine refine(contact, solid, limit, shortest_interval, span, given, time, values, tolerance, depth, radius, force, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: solid
        !> largest radius, shortest time of interest and duration
        real(wp), intent(in) :: limit, shortest_interval, span
        integer, intent(in) :: given
        real(wp), intent(in) :: time(:), values(:), tolerance
        real(wp), intent(inout) :: depth(:), radius(:), force(:)
        type(error_t), allocatable, intent(inout) :: error
        type(memory_t) :: memory
        real(wp), dimension(size(time), 3) :: now, before, best, best_before
        real(wp) :: change, last_change, shortest, gap, nearest
        integer :: level, rises

        call new_memory(memory, solid, limit, span, memory_part*tolerance, error)
        if (allocated(error)) return
        shortest = max(first_step*memory%shortest, shortest_interval)
        best_before = 0.0_wp
        before = 0.0_wp
        change = 0.0_wp
        rises = 0
        do level = 0, most_levels
            last_change = change
            call march_once(contact, memory, limit, shortest, given, time, values, level, now, gap, error)
            if (allocated(error)) return
            best = now + (now - before)/3.0_wp
            if (level == 1) change = largest_change(now, best)
            ! the error of `best` falls at most as fast as the fourth power of the step: what falls faster falls by chance
            if (level > 1) change = max(change/fastest, largest_change(best, best_before))
            ! the previous distance of the indenter has no effect
            nearest = max(tolerance, 1.0e-6_wp, change)*max(maxval(now(:, 1)), 0.0_wp)
            if (level > 0 .and. change <= tolerance) then
                if (gap < -nearest) exit
                depth = best(:, 1)
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
            ! not even the fastest fall over the levels that are left reaches it, or it does not fall
            if (level > 0 .and. .not. change <= tolerance*fastest**(most_levels - level)) exit
            rises = merge(rises + 1, 0, level > 2 .and. change >= last_change)
            if (rises == most_rises) exit
            best_before = best
            before = now
        end do
        if (gap < -nearest) then
            call raise(error, error_invalid, "the free surface touches the indenter outside the contact: the contact is no "// &
                       "longer a single area")
            return
        end if
        call raise(error, error_no_convergence, "the history did not reach the relative tolerance "//to_text(tolerance)// &
                   ": the last halving of the steps changed it by "//to_text(change))
    end subroutine refine

    pure function largest_change(one, other) result(change)
        real(wp), intent(in) :: one(:, :), other(:, :)
        real(wp) :: change
        integer :: i

        change = 0.0_wp
        do i = 1, size(one, 2)
            change = max(change, maxval(abs(one(:, i) - other(:, i)))/max(maxval(abs(one(:, i))), tiny(1.0_wp)))
        end do
    end function largest_change

    !> A radius that the contact hardly exceeds: more than that of the body initially and after a long time.
    subroutine widest(contact, medium, solid, span, given, largest, radius, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: medium
        !> the same with a glassy and a relaxed modulus of each material between the requested times
        type(viscoelastic_t), intent(in) :: solid
        !> duration of the history [time]
        real(wp), intent(in) :: span
        integer, intent(in) :: given
        real(wp), intent(in) :: largest
        real(wp), intent(out) :: radius
        type(error_t), allocatable, intent(inout) :: error
        type(material_t) :: material(size(medium%thickness) + 1)
        type(contact_state_t) :: state
        type(model_options_t) :: options
        integer :: i, last

        options = medium%options
        options%tolerance = max(options%tolerance, of_bound)
        radius = largest
        if (given == given_radius) return
        radius = 0.0_wp
        do last = 0, 1
            do i = 1, size(medium%materials)
                if (last == 0) then
                    call solid%materials(i)%glassy(material(i), error)
                else if (medium%materials(i)%shear%limit > 0.0_wp) then
                    call medium%materials(i)%relaxed(material(i), error)
                else
                    call medium%materials(i)%of_shear(1.0_wp/maxval(medium%materials(i)%creep([span])), material(i), error)
                end if
                if (allocated(error)) return
            end do
            call find_resting(contact, material(:size(medium%thickness)), medium%thickness, medium%bonds, &
                              material(size(material)), medium%rigid_base, options, given, largest, state, error)
            if (allocated(error)) return
            radius = max(radius, margin*state%radius)
        end do
        radius = min(radius, contact%equilibrium%last_radius)
    end subroutine widest

    !> The whole history with each step cut into 2^level.
    subroutine march_once(contact, memory, limit, shortest, given, time, values, level, states, gap, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(memory_t), intent(in) :: memory
        real(wp), intent(in) :: limit
        !> length of the first step after a kink, before it is cut [time]
        real(wp), intent(in) :: shortest
        integer, intent(in) :: given, level
        real(wp), intent(in) :: time(:), values(:)
        !> (sample, depth, radius, force)
        real(wp), intent(out) :: states(:, :)
        !> least gap outside the contact, where the surface has been touched [length]
        real(wp), intent(out) :: gap
        type(error_t), allocatable, intent(inout) :: error
        type(march_t) :: march
        real(wp) :: length, done, end, h, next, part, slope, slope_before, steepest, value
        integer :: i, j, cuts

        gap = 0.0_wp
        call start_march(march, contact%equilibrium%profile, memory, limit, error)
        if (allocated(error)) return
        cuts = 2**level
        if (values(1) > 0.0_wp) call step_march(march, 0.0_wp, given, values(1), error)
        states(1, :) = [merge(values(1), march%depth, given == given_depth), march%radius, march%force]
        steepest = maxval([0.0_wp, abs((values(2:) - values(:size(values) - 1))/(time(2:) - time(:size(time) - 1)))])
        slope_before = huge(1.0_wp)
        next = shortest
        do i = 2, size(time)
            call report_progress(real(level, wp) + real(i - 2, wp)/real(size(time), wp))
            length = time(i) - time(i - 1)
            slope = (values(i) - values(i - 1))/length
            done = 0.0_wp
            if (abs(slope - slope_before) > kink*steepest) then
                next = shortest
                call mark_kink(march)
            end if
            slope_before = slope
            if (.not. march%radius > 0.0_wp .and. values(i) > 0.0_wp) then
                ! up to first contact in one step
                if (values(i - 1) < 0.0_wp) done = -values(i - 1)/slope
                if (done > 0.0_wp) call step_march(march, done, given, 0.0_wp, error)
                next = min(shortest, first_touch*(length - done))
                ! from so far away that no double lies between touch and the sample
                if (.not. done < length) call step_march(march, 0.0_wp, given, values(i), error)
                if (allocated(error)) return
            end if
            do while (done < length)
                h = next
                next = growth*next
                end = done + h
                if (length - done < 1.3_wp*h) then
                    h = length - done
                    end = length
                end if
                do j = 1, cuts
                    part = merge(end, done + h*real(j, wp)/real(cuts, wp), j == cuts)
                    ! from the nearer end of the interval: the other may lie far away
                    value = values(i - 1) + slope*part
                    if (part > 0.5_wp*length) value = values(i) - slope*(length - part)
                    call step_march(march, h/real(cuts, wp), given, value, error)
                    if (allocated(error)) return
                end do
                done = end
            end do
            if (given == given_depth) march%depth = values(i)
            states(i, :) = [march%depth, march%radius, march%force]
        end do
        gap = march%gap
    end subroutine march_once

end module mdrcontact_time_steps
