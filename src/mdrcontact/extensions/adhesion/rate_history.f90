! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a contact whose work of adhesion depends on the speed of its edge: approach, dwell, retraction, pull-off
!> (theory/adhesion.md (3.3)).
module mdrcontact_adhesion_rate_history
    use mdrcontact_cancel, only: check_cancelled, report_progress
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_error, only: check_finite, check_made, check_not_negative, check_within, error_domain, error_invalid, &
                                error_no_convergence, error_t, error_unreachable, raise, to_text
    use mdrcontact_adhesion_rate_contact, only: edge_t, edge_equation_t, rate_contact_t
    use mdrcontact_adhesion_rate_state, only: account, break_edge, check_state, force_rate, note_force, note_lowest, &
                                              rate_state_t, sign_state
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_stiff_step, only: places, stages, stiff_step
    implicit none (type, external)
    private
    public :: rate_history, columns

    !> Depth, radius, force, speed of the edge, dissipated energy, work.
    integer, parameter :: columns = 6
    real(wp), parameter :: usual_tolerance = 1.0e-9_wp
    integer, parameter :: most_steps = 1000000
    !> A step changes by at most these factors, and aims at this part of what would just do.
    real(wp), parameter :: shortest = 0.2_wp, longest = 5.0_wp, careful = 0.85_wp, after_failure = 0.125_wp
    !> First step, as a fraction of an interval of time.
    real(wp), parameter :: first_part = 1.0e-3_wp
    !> A contact begins at this multiple of the radius at which it ends.
    real(wp), parameter :: seed = 1.1_wp
    !> In search of an equilibrium, or of a closed edge, in ln a.
    real(wp), parameter :: stride = 0.02_wp
    integer, parameter :: halvings = 60

    !> State of the integration.
    type :: progress_t
        !> whether there is a contact, its coordinate and dx/dt
        logical :: touches = .false.
        real(wp) :: x = 0.0_wp, slope = 0.0_wp
        !> the next step [time]
        real(wp) :: step = 0.0_wp
        integer :: steps = 0
    end type progress_t

contains

    !> Follows s, linear in time between samples, and keeps the last state.
    subroutine rate_history(contact, control, time, s, state, path, error, tolerance)
        type(rate_contact_t), intent(in), target :: contact
        !> what s is
        type(control_t), intent(in) :: control
        !> ascending [time]
        real(wp), intent(in) :: time(:)
        !> as many; before the first the bodies are as `state` describes
        real(wp), intent(in) :: s(:)
        !> at the first time; receives that of the last. Unchanged after an error
        type(rate_state_t), intent(inout) :: state
        !> (columns, size(time))
        real(wp), intent(out) :: path(:, :)
        type(error_t), allocatable, intent(out) :: error
        !> of ln a in each step, 1e-12 to 1e-3; default or 0: 1e-9
        real(wp), intent(in), optional :: tolerance
        type(progress_t) :: now
        type(rate_state_t) :: next
        real(wp) :: accuracy
        integer :: i

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        accuracy = usual_tolerance
        if (present(tolerance)) then
            if (tolerance /= 0.0_wp) accuracy = tolerance
        end if
        call check_within(error, "tolerance", accuracy, 1.0e-12_wp, 1.0e-3_wp)
        call check_path(time, s, error)
        if (.not. allocated(error)) call check_state(state, contact, error)
        if (allocated(error) .or. size(time) == 0) return
        next = state
        call begin(contact, control, s(1), time(1), next, now, error)
        if (allocated(error)) return
        call record(contact, control, s(1), next, now, path(:, 1))
        do i = 2, size(time)
            call check_cancelled(error)
            call report_progress(real(i - 2, wp)/real(size(time), wp))
            if (.not. allocated(error)) call pass(contact, control, time(i - 1:i), s(i - 1:i), accuracy, next, now, error)
            if (allocated(error)) return
            call record(contact, control, s(i), next, now, path(:, i))
        end do
        call sign_state(next, contact)
        state = next
    end subroutine rate_history

    subroutine check_path(time, s, error)
        real(wp), intent(in) :: time(:), s(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        do i = 1, size(time)
            call check_finite(error, "time", time(i), i)
            call check_finite(error, "in", s(i), i)
            if (allocated(error)) return
        end do
        do i = 2, size(time)
            if (time(i) > time(i - 1)) cycle
            call raise(error, error_invalid, " = "//to_text(time(i))//": times must be strictly ascending, and the previous "// &
                       "one is "//to_text(time(i - 1)), "time", i)
        end do
    end subroutine check_path

    !> The beginning: apart, in equilibrium, or at a given radius.
    subroutine begin(contact, control, s, time, state, now, error)
        type(rate_contact_t), intent(in), target :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s, time
        type(rate_state_t), intent(inout) :: state
        type(progress_t), intent(out) :: now
        type(error_t), allocatable, intent(inout) :: error

        if (state%radius < 0.0_wp) then
            call rest(contact, control, s, now%x, error)
            if (allocated(error)) return
            now%touches = .true.
            state%radius = contact%curve%coordinate%radius(now%x)
            call note_force(state, contact%edge(control, s, now%x), time, 0.0_wp)
        else if (state%radius > 0.0_wp) then
            now%touches = .true.
            now%x = contact%coordinate_of(real(state%radius, wp))
            if (now%x > contact%last .or. now%x < contact%first) then
                call raise(error, error_domain, " = "//to_text(real(state%radius, wp))//": this contact extends from "// &
                           to_text(exp(contact%first))//" to "//to_text(exp(contact%last)), "radius")
                return
            end if
            call start_edge(contact, control, s, state, now, error)
        else if (s >= 0.0_wp) then
            call touch(contact, control, s, state, now, error)
        end if
    end subroutine begin

    !> The bodies meet, and gain the adhesion of the smallest contact immediately; it is dissipated.
    subroutine touch(contact, control, s, state, now, error)
        type(rate_contact_t), intent(in), target :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        type(rate_state_t), intent(inout) :: state
        type(progress_t), intent(inout) :: now
        type(error_t), allocatable, intent(inout) :: error

        now%touches = .true.
        now%x = contact%first + log(seed)
        state%radius = exp(now%x)
        state%dissipated = state%dissipated + contact%law%work*pi*state%radius**2
        call start_edge(contact, control, s, state, now, error)
    end subroutine touch

    !> Where the edge is compressed the contact grows instantly to where it is not. Then the speed of the edge is known.
    subroutine start_edge(contact, control, s, state, now, error)
        type(rate_contact_t), intent(in), target :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        type(rate_state_t), intent(inout) :: state
        type(progress_t), intent(inout) :: now
        type(error_t), allocatable, intent(inout) :: error
        type(edge_equation_t) :: equation
        type(edge_t) :: here
        real(wp) :: before, middle, unused
        integer :: i

        before = now%x
        here = contact%edge(control, s, now%x)
        if (.not. here%opening > 0.0_wp) then
            do while (.not. here%opening > 0.0_wp)
                if (now%x > contact%last) then
                    call refuse_radius(contact, error)
                    return
                end if
                before = now%x
                now%x = now%x + stride
                here = contact%edge(control, s, now%x)
            end do
            do i = 1, halvings
                middle = 0.5_wp*(before + now%x)
                here = contact%edge(control, s, middle)
                if (here%opening > 0.0_wp) then
                    now%x = middle
                else
                    before = middle
                end if
            end do
            state%dissipated = state%dissipated + contact%law%work*pi*(exp(2.0_wp*now%x) - real(state%radius, wp)**2)
        end if
        equation%contact => contact
        equation%control = control
        equation%start = s
        call equation%rate(0.0_wp, now%x, now%slope, unused)
    end subroutine start_edge

    subroutine refuse_radius(contact, error)
        type(rate_contact_t), intent(in) :: contact
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_domain, " = "//to_text(exp(contact%last))//": the contact grows beyond it. Increase it", &
                   "largest_radius")
    end subroutine refuse_radius

    !> The largest stable equilibrium, G = work.
    subroutine rest(contact, control, s, x, error)
        type(rate_contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        real(wp), intent(out) :: x
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: above, middle
        integer :: i

        above = contact%last
        x = contact%last
        if (.not. opens(x)) then
            call refuse_radius(contact, error)
            return
        end if
        do while (opens(x))
            above = x
            x = x - stride
            if (x < contact%first) then
                call raise(error, error_unreachable, " = "//to_text(s)//": there is no stable adhesive state", "in")
                return
            end if
        end do
        do i = 1, halvings
            middle = 0.5_wp*(above + x)
            if (opens(middle)) then
                above = middle
            else
                x = middle
            end if
        end do

    contains

        function opens(x) result(answer)
            real(wp), intent(in) :: x
            logical :: answer
            type(edge_t) :: here

            here = contact%edge(control, s, x)
            answer = here%energy > contact%law%work
        end function opens

    end subroutine rest

    !> From one sample to the next.
    subroutine pass(contact, control, time, s, accuracy, state, now, error)
        type(rate_contact_t), intent(in), target :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: time(2), s(2), accuracy
        type(rate_state_t), intent(inout) :: state
        type(progress_t), intent(inout) :: now
        type(error_t), allocatable, intent(inout) :: error
        type(edge_equation_t) :: equation
        real(wp) :: t, whole

        whole = time(2) - time(1)
        equation%contact => contact
        equation%control = control
        equation%start = s(1)
        equation%speed = (s(2) - s(1))/whole
        equation%lowest = contact%curve%edges(1)
        equation%highest = contact%curve%edges(size(contact%curve%edges))
        t = 0.0_wp
        do while (t < whole)
            if (.not. now%touches) then
                ! where a force is controlled, separated bodies have no distance
                if (.not. (control%depth_weight > 0.0_wp .and. s(1) + equation%speed*t <= 0.0_wp .and. s(2) >= 0.0_wp)) return
                if (equation%speed > 0.0_wp) t = min(max(t, -s(1)/equation%speed), whole)
                call touch(contact, control, 0.0_wp, state, now, error)
                if (allocated(error) .or. .not. t < whole) return
            end if
            call step(equation, time(1), whole, accuracy, t, state, now, error)
            if (allocated(error)) return
        end do
    end subroutine pass

    !> One accepted step, or the end of the contact.
    subroutine step(equation, origin, whole, accuracy, t, state, now, error)
        type(edge_equation_t), intent(in) :: equation
        !> time at t = 0, and t at the end of the interval
        real(wp), intent(in) :: origin, whole, accuracy
        real(wp), intent(inout) :: t
        type(rate_state_t), intent(inout) :: state
        type(progress_t), intent(inout) :: now
        type(error_t), allocatable, intent(inout) :: error
        type(edge_t) :: here
        real(wp) :: reached(stages), slopes(stages), deviation, h, change, falls
        logical :: found, ends

        if (.not. now%step > 0.0_wp) now%step = first_part*whole
        do
            now%steps = now%steps + 1
            if (now%steps > most_steps) then
                call raise(error, error_no_convergence, "the edge cannot be followed beyond time "//to_text(origin + t)// &
                           " in a million steps")
                return
            end if
            h = min(now%step, whole - t)
            ends = .not. now%step < whole - t
            call stiff_step(equation, t, h, now%x, now%slope, reached, slopes, deviation, found)
            if (.not. found) then
                if (now%x > equation%contact%last) call refuse_radius(equation%contact, error)
                if (allocated(error)) return
                now%step = after_failure*h
                cycle
            end if
            change = longest
            if (deviation > 0.0_wp) change = min(longest, max(shortest, careful*(accuracy/deviation)**0.25_wp))
            if (deviation <= accuracy) exit
            now%step = change*h
        end do
        here = equation%contact%edge(equation%control, equation%start + equation%speed*t, now%x)
        falls = force_rate(equation, here, now%slope)
        call account(state, equation, t, h, reached, slopes, places)
        here = equation%contact%edge(equation%control, equation%start + equation%speed*(t + h), reached(stages))
        if (falls < 0.0_wp .and. force_rate(equation, here, slopes(stages)) > 0.0_wp) then
            call note_lowest(state, equation, origin, t, h, now%x, now%slope)
        else
            call note_force(state, here, origin + t + h, -slopes(stages)*exp(reached(stages)))
        end if
        t = merge(whole, t + h, ends)
        ! a step that a sample has cut short does not determine the next one
        now%step = merge(max(now%step, change*h), change*h, ends)
        now%x = reached(stages)
        now%slope = slopes(stages)
        if (now%x > equation%contact%last) call refuse_radius(equation%contact, error)
        if (now%x >= equation%contact%first) return
        call break_edge(state, equation%contact, here, now%x, origin + t)
        now%touches = .false.
    end subroutine step

    !> State at a sample.
    subroutine record(contact, control, s, state, now, row)
        type(rate_contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        type(rate_state_t), intent(inout) :: state
        type(progress_t), intent(in) :: now
        real(wp), intent(out) :: row(columns)
        type(edge_t) :: here
        real(wp) :: speed

        speed = 0.0_wp
        if (now%touches) then
            here = contact%edge(control, s, now%x)
            speed = -now%slope*exp(now%x)
        else
            here%depth = state%rupture_depth
            if (control%depth_weight > 0.0_wp) here%depth = s/control%depth_weight
        end if
        state%radius = here%radius
        state%depth = here%depth
        state%force = here%force
        row = [here%depth, here%radius, here%force, speed, real(state%dissipated, wp), real(state%work, wp)]
    end subroutine record

end module mdrcontact_adhesion_rate_history
