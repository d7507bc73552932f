! SPDX-License-Identifier: GPL-3.0-or-later
!> Approach, dwell, retraction and pull-off of an indenter on a viscoelastic half-space whose surface it attracts
!> (theory/adhesion.md (5.1)-(5.4)): the march of adhesion/cohesive_march.f90 with steps that are halved until nothing changes any
!> more; second order, extrapolated.
module mdrcontact_adhesion_cohesive_history
    use mdrcontact_cancel, only: check_cancelled, report_progress
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_error, only: check_made, check_memory, check_table, check_within, error_invalid, error_no_convergence, &
                                error_t, error_unreachable, raise, to_text
    use mdrcontact_adhesion_cohesive_march, only: cohesive_march_t, first_attraction, jump_march, mark_edges, rest_march, &
                                                 start_march, step_apart, step_march
    use mdrcontact_adhesion_rate_state, only: rate_state_t
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_material_prony, only: creep_of, creep_t
    implicit none (type, external)
    private
    public :: cohesive_history, cohesive_columns

    !> Depth, radius of the contact, radius of the zone, force.
    integer, parameter :: cohesive_columns = 4
    integer, parameter :: of_zone = 3, of_force = 4
    real(wp), parameter :: default_tolerance = 1.0e-4_wp, smallest_tolerance = 1.0e-7_wp, largest_tolerance = 1.0e-2_wp
    !> Steps before they are halved: the edge goes by so much of its zone, and what is controlled by so much of its span.
    real(wp), parameter :: part_of_zone = 0.2_wp, part_of_span = 0.01_wp
    !> The first after a kink, of the shortest time of creep, or of the interval; how fast they grow, and what is a kink [steepest].
    real(wp), parameter :: first_of_time = 0.1_wp, first_of_interval = 0.01_wp, growth = 1.5_wp, kink = 0.1_wp
    !> The end of the zone goes by so much of its way to a turn, and next to one by so much of the zone.
    real(wp), parameter :: part_of_way = 0.3_wp, part_beside_turn = 1.0e-4_wp
    integer, parameter :: most_levels = 7
    !> Steps this much shorter find no state either: it jumps, memories as they are [step, and shortest time of creep].
    real(wp), parameter :: shortest = 1.0e-4_wp
    !> A zone shorter than this takes too many steps [contact radius].
    real(wp), parameter :: shortest_zone = 1.0e-3_wp

    !> The way of one round, and what was lowest on it.
    type :: round_t
        type(cohesive_march_t) :: march
        type(rate_state_t) :: state
        !> time and force of the last states that no jump parts
        real(wp) :: times(3) = 0.0_wp, forces(3) = 0.0_wp
        integer :: count = 0
    end type round_t

    !> Results of rounds of one fineness.
    type :: estimate_t
        !> (cohesive_columns, samples): of the round, and extrapolated
        real(wp), allocatable :: path(:, :), best(:, :)
        type(rate_state_t) :: state
        !> the lowest force, extrapolated
        real(wp) :: lowest = 0.0_wp
    end type estimate_t

contains

    !> Depth, radii and force at samples of what is controlled, linear in time in between.
    subroutine cohesive_history(contact, control, at_rest, time, s, path, state, error, tolerance)
        !> with a cohesive stress
        type(relaxing_contact_t), intent(in) :: contact
        !> what s is: depth, force, or the far end of a spring
        type(control_t), intent(in) :: control
        !> before the first time: in equilibrium with the first value, as large as it is stable; else the bodies are separated
        logical, intent(in) :: at_rest
        !> strictly ascending [time]
        real(wp), intent(in) :: time(:)
        !> as many
        real(wp), intent(in) :: s(:)
        !> (cohesive_columns, size(time)): depth, radius, zone radius, 0 for separated bodies, and force
        real(wp), intent(out) :: path(:, :)
        !> where it ends: lowest force, last rupture, work
        type(rate_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> of the force, relative to its largest, 1e-7 to 1e-2; default or 0: 1e-4
        real(wp), intent(in), optional :: tolerance
        type(estimate_t) :: rounds(2)
        real(wp) :: accuracy, change
        integer :: level, one, other

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        accuracy = default_tolerance
        if (present(tolerance)) then
            if (tolerance /= 0.0_wp) accuracy = tolerance
        end if
        call check_within(error, "tolerance", accuracy, smallest_tolerance, largest_tolerance)
        call check_table(error, "time", time, "in", s, 1)
        if (.not. contact%cohesive_stress > 0.0_wp .and. .not. allocated(error)) then
            call raise(error, error_invalid, " = 0: an adhesive history needs a contact with a cohesive zone", "cohesive_stress")
        end if
        do one = 1, 2
            if (.not. allocated(error)) call make_room(rounds(one), size(time), error)
        end do
        change = huge(1.0_wp)
        do level = 0, most_levels
            if (allocated(error)) return
            one = 1 + mod(level, 2)
            other = 3 - one
            call march_once(contact, control, at_rest, time, s, level, rounds(one)%path, rounds(one)%state, error)
            if (level == 0 .or. allocated(error)) cycle
            call extrapolate(rounds(one), rounds(other), level == 1, change)
            if (change <= accuracy) exit
        end do
        if (.not. change <= accuracy) then
            call raise(error, error_no_convergence, "the history did not reach the relative tolerance "//to_text(accuracy)// &
                       ": the last halving of the steps changed it by "//to_text(change))
            return
        end if
        path = rounds(one)%best
        state = rounds(one)%state
        state%lowest_force = rounds(one)%lowest
    end subroutine cohesive_history

    subroutine make_room(self, count, error)
        type(estimate_t), intent(inout) :: self
        integer, intent(in) :: count
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        allocate (self%path(cohesive_columns, count), self%best(cohesive_columns, count), stat=stat)
        call check_memory(error, stat)
    end subroutine make_room

    !> Limit extrapolated from a round and one with twice its steps, and the change of the force, relative to its largest: from the
    !> round itself where it is the first that has one before, else from what was extrapolated before. Samples at which the bodies
    !> attract each other in one of the rounds alone are taken as they come.
    pure subroutine extrapolate(self, before, is_first, change)
        type(estimate_t), intent(inout) :: self
        type(estimate_t), intent(in) :: before
        logical, intent(in) :: is_first
        real(wp), intent(out) :: change
        real(wp) :: largest
        integer :: i

        self%lowest = beyond(real(self%state%lowest_force, wp), real(before%state%lowest_force, wp))
        change = abs(self%lowest - merge(real(self%state%lowest_force, wp), before%lowest, is_first))
        largest = tiny(1.0_wp)
        do i = 1, size(self%path, 2)
            self%best(:, i) = self%path(:, i)
            largest = max(largest, abs(self%path(of_force, i)))
            if ((self%path(of_zone, i) > 0.0_wp) .neqv. (before%path(of_zone, i) > 0.0_wp)) cycle
            self%best(:, i) = beyond(self%path(:, i), before%path(:, i))
            change = max(change, abs(self%best(of_force, i) - merge(self%path(of_force, i), before%best(of_force, i), is_first)))
        end do
        change = change/largest
    end subroutine extrapolate

    !> The limit of errors that halved steps divide by four.
    elemental function beyond(fine, coarse) result(limit)
        real(wp), intent(in) :: fine, coarse
        real(wp) :: limit

        limit = fine + (fine - coarse)/3.0_wp
    end function beyond

    !> The whole history with each step cut into 2^level.
    subroutine march_once(contact, control, at_rest, time, s, level, path, state, error)
        type(relaxing_contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        logical, intent(in) :: at_rest
        real(wp), intent(in) :: time(:), s(:)
        integer, intent(in) :: level
        real(wp), intent(out) :: path(:, :)
        type(rate_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(round_t) :: round
        type(creep_t) :: creep
        real(wp) :: next, slope, slope_before, steepest, span, shortest_time
        integer :: i

        path = 0.0_wp
        creep = creep_of(contact%medium%materials(1)%contact_series(1.0_wp, 1.0_wp))
        span = max(maxval(s) - minval(s), tiny(1.0_wp))
        call start_march(round%march, contact%equilibrium%profile, creep, contact%cohesive_stress, &
                         contact%work_of_adhesion/contact%cohesive_stress, contact%equilibrium%last_radius, error)
        if (.not. allocated(error)) call begin(round, control, at_rest, s(1), time(1), error)
        if (allocated(error)) return
        shortest_time = first_of_time*time_of_creep(round%march)
        call record(round%march, path(:, 1))
        next = shortest_time
        slope_before = huge(1.0_wp)
        steepest = 0.0_wp
        do i = 2, size(time)
            steepest = max(steepest, abs((s(i) - s(i - 1))/(time(i) - time(i - 1))))
        end do
        do i = 2, size(time)
            call report_progress(real(level, wp) + real(i - 2, wp)/real(size(time), wp))
            slope = (s(i) - s(i - 1))/(time(i) - time(i - 1))
            if (abs(slope - slope_before) > kink*steepest) then
                next = min(shortest_time, first_of_interval*(time(i) - time(i - 1)))
                call mark_edges(round%march)
            end if
            slope_before = slope
            call pass(round, control, time(i - 1:i), s(i - 1:i), 2**level, span, next, error)
            if (allocated(error)) return
            call record(round%march, path(:, i))
        end do
        round%state%radius = path(2, size(time))
        round%state%depth = path(1, size(time))
        round%state%force = path(of_force, size(time))
        state = round%state
    end subroutine march_once

    subroutine begin(round, control, at_rest, s, time, error)
        type(round_t), intent(inout) :: round
        type(control_t), intent(in) :: control
        logical, intent(in) :: at_rest
        real(wp), intent(in) :: s, time
        type(error_t), allocatable, intent(inout) :: error

        associate (march => round%march)
            if (at_rest) then
                call rest_march(march, control, s, error)
                if (march%is_apart .and. .not. allocated(error)) then
                    call raise(error, error_unreachable, " = "//to_text(s)//": there is no stable adhesive state", "in")
                end if
            else if (control%depth_weight > 0.0_wp) then
                march%depth = s
                if (s > first_attraction(march)) call jump_march(march, control, s, 1, error)
            else
                call jump_march(march, control, s, 1, error)
            end if
            if (allocated(error)) return
            associate (zone => march%springs%c(2) - march%springs%a(2))
                if (march%springs%a(2) > 0.0_wp .and. zone < shortest_zone*march%springs%a(2)) then
                    call raise(error, error_invalid, " = "//to_text(0.5_wp*march%springs%stress)// &
                               ": its cohesive zone of length "//to_text(zone)//" is too short to be resolved at a contact "// &
                               "radius of "//to_text(march%springs%a(2))//". Use the relaxed body with the rate-dependent "// &
                               "work of adhesion of the material", "cohesive_stress")
                end if
            end associate
        end associate
        call note(round, time, .true.)
    end subroutine begin

    pure subroutine record(march, row)
        type(cohesive_march_t), intent(in) :: march
        real(wp), intent(out) :: row(:)

        row = [march%depth, march%springs%a(2), march%springs%c(2), march%force]
    end subroutine record

    !> From one sample to the next.
    subroutine pass(round, control, time, s, cuts, span, next, error)
        type(round_t), intent(inout) :: round
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: time(2), s(2)
        integer, intent(in) :: cuts
        !> of what is controlled
        real(wp), intent(in) :: span
        !> the next step before it is cut [time]
        real(wp), intent(inout) :: next
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: done, from, h, length, slope, moved
        integer :: j

        length = time(2) - time(1)
        slope = (s(2) - s(1))/length
        done = 0.0_wp
        do while (done < length)
            call check_cancelled(error)
            if (allocated(error)) return
            h = next
            if (length - done < 1.3_wp*h) h = length - done
            do j = 1, cuts
                from = done + h*real(j - 1, wp)/real(cuts, wp)
                call advance(round, control, time(1) + from, s(1) + slope*from, slope, h/real(cuts, wp), error)
                if (allocated(error)) return
            end do
            done = merge(length, done + h, .not. h < length - done)
            associate (march => round%march)
                moved = abs(march%speed)/max(part_of_zone*(march%springs%c(2) - march%springs%a(2)), tiny(1.0_wp))
                if (march%is_apart) moved = 0.0_wp
                moved = max(moved, abs(slope)/(part_of_span*span))
            end associate
            next = growth*max(next, h)
            if (moved > 0.0_wp) next = min(next, 1.0_wp/moved)
            next = min(next, time_to_turn(round%march))
        end do
        if (control%depth_weight > 0.0_wp .and. round%march%is_apart) round%march%depth = s(2)
    end subroutine pass

    !> The longest step while the end of the zone comes back to a place where an edge has turned: the memory has a kink there, and
    !> as it is passed the speed of the contact jumps, often where the force is lowest.
    pure function time_to_turn(march) result(longest)
        type(cohesive_march_t), intent(in) :: march
        real(wp) :: longest
        real(wp) :: way

        longest = huge(1.0_wp)
        associate (c => march%springs%c, length => march%springs%length)
            if (march%is_apart .or. .not. c(2) < c(1) .or. .not. length > 0.0_wp) return
            if (.not. any(march%turns < c(2))) return
            way = part_of_way*(c(2) - maxval(march%turns, mask=march%turns < c(2)))
            longest = max(way, part_beside_turn*(c(2) - march%springs%a(2)))/(c(1) - c(2))*length
        end associate
    end function time_to_turn

    !> The shortest time of creep.
    pure function time_of_creep(march) result(time)
        type(cohesive_march_t), intent(in) :: march
        real(wp) :: time

        time = 1.0_wp/max(maxval([0.0_wp, march%springs%creep%rate]), tiny(1.0_wp))
    end function time_of_creep

    !> A step of length h, or several shorter ones, jumps included.
    subroutine advance(round, control, time, s, slope, h, error)
        type(round_t), intent(inout) :: round
        type(control_t), intent(in) :: control
        !> at its beginning, and ds/dt
        real(wp), intent(in) :: time, s, slope, h
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: done, part, briefest
        integer :: direction
        logical :: found

        briefest = shortest*min(h, time_of_creep(round%march))
        done = 0.0_wp
        part = h
        do while (done < h)
            part = min(part, h - done)
            if (round%march%is_apart) then
                call wait(round%march, control, s + slope*done, slope, part, error)
            else
                call step_march(round%march, part, control, s + slope*(done + part), found, direction, error)
                if (allocated(error)) return
                if (.not. found .and. part > briefest) then
                    part = 0.25_wp*part
                    cycle
                end if
                if (.not. found) call jump(round, control, time + done, s + slope*(done + part), direction, error)
            end if
            if (allocated(error)) return
            done = merge(h, done + part, .not. part < h - done)
            call note(round, time + done, .false.)
            part = 2.0_wp*part
        end do
    end subroutine advance

    subroutine jump(round, control, time, s, direction, error)
        type(round_t), intent(inout) :: round
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: time, s
        integer, intent(in) :: direction
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: depth

        depth = round%march%depth
        call jump_march(round%march, control, s, direction, error)
        if (round%march%is_apart) then
            round%state%rupture_time = time
            round%state%rupture_depth = depth
            round%state%ruptures = round%state%ruptures + 1.0_wp
        end if
        round%count = 0
    end subroutine jump

    !> Separated bodies, until they attract each other; the part of the step that has passed.
    subroutine wait(march, control, s, slope, part, error)
        type(cohesive_march_t), intent(inout) :: march
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s, slope
        real(wp), intent(inout) :: part
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: left
        logical :: meets

        meets = .false.
        left = first_attraction(march) - s
        if (control%depth_weight > 0.0_wp .and. slope > 0.0_wp .and. left < slope*part) then
            part = max(left/slope, 0.0_wp)
            meets = .true.
        end if
        call step_apart(march, part, error)
        if (control%depth_weight > 0.0_wp) march%depth = s + slope*part
        if (meets .and. .not. allocated(error)) call jump_march(march, control, s + slope*part, 1, error)
    end subroutine wait

    !> Remembers the lowest force, between states by a parabola, and the work.
    subroutine note(round, time, is_first)
        type(round_t), intent(inout) :: round
        real(wp), intent(in) :: time
        logical, intent(in) :: is_first
        real(wp) :: rate(2), bend, at, least

        associate (march => round%march, state => round%state)
            if (.not. is_first) state%work = state%work + 0.5_wp*(march%force + round%forces(3))*(march%depth - state%depth)
            state%depth = march%depth
            round%times = [round%times(2:), time]
            round%forces = [round%forces(2:), march%force]
            round%count = min(round%count + 1, 3)
            if (march%force < state%lowest_force) then
                state%lowest_force = march%force
                state%lowest_time = time
                state%lowest_depth = march%depth
                state%lowest_radius = march%springs%a(2)
                state%lowest_speed = -march%speed
            end if
            if (round%count < 3 .or. .not. round%forces(2) < min(round%forces(1), round%forces(3))) return
            rate = (round%forces(2:) - round%forces(:2))/(round%times(2:) - round%times(:2))
            bend = (rate(2) - rate(1))/(round%times(3) - round%times(1))
            at = 0.5_wp*(round%times(1) + round%times(2) - rate(1)/bend)
            least = round%forces(2) - bend*(round%times(2) - at)**2
            if (least < state%lowest_force) then
                state%lowest_force = least
                state%lowest_time = at
            end if
        end associate
    end subroutine note

end module mdrcontact_adhesion_cohesive_history
