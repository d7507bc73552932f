! SPDX-License-Identifier: GPL-3.0-or-later
!> Histories of a body whose materials relax proportionally, from its elastic curve (theory/time.md (3.1), (3.2)): while the contact
!> grows, F(t) = int phi(t - u) dF_el(d(u)) (Lee, Radok, J. Appl. Mech. 27 (1960) 438); after the one maximum of d the contact is as
!> large as it was at the time t1 at which int_t1^t phi(t - u) d'(u) du = 0, and F(t) = int_0^t1 (Ting, J. Appl. Mech. 33 (1966)
!> 845).
!>
!> The depth is linear in time between samples; the cost grows as their number times that of the exponentials in phi.
module mdrcontact_time_follow
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact, only: contact_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_time_curve, only: break_depths, elastic_curve_t
    use mdrcontact_time_path, only: mean_decay, new_path, partial_integrals, path_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_prony, only: prony_t
    implicit none (type, external)
    private
    public :: follow_depth

    !> Rounding of a sum of exponentials, relative to its terms.
    real(wp), parameter :: noise = 1.0e-11_wp
    integer, parameter :: most_steps = 60
    !> exp(-forgotten) is negligible; exp(-few_powers_below) is a sum of so many powers.
    real(wp), parameter :: forgotten = 40.0_wp, few_powers_below = 0.3_wp
    integer, parameter :: powers = 10
    real(wp), parameter :: factorial(powers + 1) = [1.0_wp, 2.0_wp, 6.0_wp, 24.0_wp, 120.0_wp, 720.0_wp, 5040.0_wp, 40320.0_wp, &
                                                    362880.0_wp, 3628800.0_wp, 39916800.0_wp]

    !> Rest of the path at a sample of the shrinking phase.
    type :: unloading_t
        !> index of the panel's end below t1, and where t1 lies in the panel after it, 0 to 1
        integer :: panel = 0
        real(wp) :: fraction = 0.0_wp
        logical :: has_separated = .false.
    end type unloading_t

contains

    !> Radius and force at samples of a depth that is prescribed. `covered` is false, and they are undefined, where the contact
    !> shrinks and grows again.
    subroutine follow_depth(contact, phi, time, depth, tolerance, radius, force, covered, error)
        !> of the elastic body
        type(contact_t), intent(in), target :: contact
        !> what its modulus is multiplied by, phi(t) [1]
        type(prony_t), intent(in) :: phi
        !> ascending; before the first the bodies are separated and at rest, and if the first depth is positive it is reached in a
        !> jump
        real(wp), intent(in) :: time(:)
        !> d; the bodies are separated before it is positive [length]
        real(wp), intent(in) :: depth(:)
        !> a contact that grows again by less, relative to the largest depth, only shrinks
        real(wp), intent(in) :: tolerance
        !> same size as depth
        real(wp), intent(out) :: radius(:), force(:)
        logical, intent(out) :: covered
        type(error_t), allocatable, intent(out) :: error
        type(elastic_curve_t) :: curve
        type(path_t) :: path
        real(wp), allocatable :: breaks(:), t(:), d(:)
        integer :: first, last, stat

        covered = .true.
        radius = 0.0_wp
        force = 0.0_wp
        do first = 1, size(depth)
            if (depth(first) > 0.0_wp) exit
        end do
        if (first > size(depth)) return
        last = first
        do while (last < size(depth))
            if (depth(last + 1) < depth(last)) exit
            last = last + 1
        end do
        allocate (t(0:last - first + 1), d(0:last - first + 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        t(1:) = time(first:last)
        d(1:) = depth(first:last)
        d(0) = 0.0_wp
        t(0) = t(1)
        if (first > 1) t(0) = time(first) - (time(first) - time(first - 1))*depth(first)/(depth(first) - depth(first - 1))

        curve%contact => contact
        call break_depths(contact, breaks, error)
        if (.not. allocated(error)) call new_path(path, curve, breaks, [phi%rate, 0.0_wp], t, d, error)
        if (.not. allocated(error)) call grow(path, phi, curve, radius(first:last), force(first:last), error)
        if (allocated(error) .or. last == size(depth)) return
        call shrink(path, phi, curve, time(last:), depth(last:), tolerance*depth(last), radius(last:), force(last:), covered, error)
    end subroutine follow_depth

    !> The growing phase, at the given points of the path but the first.
    subroutine grow(path, phi, curve, radius, force, error)
        type(path_t), intent(in) :: path
        type(prony_t), intent(in) :: phi
        type(elastic_curve_t), intent(inout) :: curve
        real(wp), intent(inout) :: radius(:), force(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: depth(:), stiffness(:)
        real(wp) :: length
        integer :: i, n, panel, stat

        n = size(phi%rate)
        allocate (depth(size(radius)), stiffness(size(radius)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(radius)
            depth(i) = path%depth(path%place(i))
        end do
        call curve%at_depths(depth, error, radius=radius, stiffness=stiffness)
        if (allocated(error)) return
        do i = 1, size(force)
            panel = path%place(i)
            force(i) = phi%limit*path%load(n + 1, panel) + sum(phi%weight*path%load(:n, panel))
            length = path%time(panel) - path%time(panel - 1)
            if (phi%viscosity > 0.0_wp .and. length > 0.0_wp) then
                force(i) = force(i) + phi%viscosity*stiffness(i)*(path%depth(panel) - path%depth(panel - 1))/length
            end if
        end do
    end subroutine grow

    !> The shrinking phase, at samples after the last of the growing one, which comes first in the arrays.
    subroutine shrink(path, phi, curve, time, depth, tolerance, radius, force, covered, error)
        type(path_t), intent(in) :: path
        type(prony_t), intent(in) :: phi
        type(elastic_curve_t), intent(inout) :: curve
        real(wp), intent(in) :: time(:), depth(:)
        !> growing again by less, in terms of the depth of the elastic contact, does not count
        real(wp), intent(in) :: tolerance
        real(wp), intent(inout) :: radius(:), force(:)
        logical, intent(out) :: covered
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(size(phi%rate)) :: rise, rise_before, behind, z, decay, mean
        real(wp), dimension(size(phi%rate) + 1) :: load, passed
        real(wp) :: rate, edge, step
        real(wp), allocatable :: depths(:), radii(:)
        type(unloading_t) :: now, before, between
        integer :: i, n, count, stat
        logical :: steady

        n = size(phi%rate)
        covered = .true.
        allocate (depths(size(time)), radii(size(time)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        count = 0
        rise = path%rise(:n, path%count)
        step = -1.0_wp
        before%panel = path%count - 1
        before%fraction = 1.0_wp
        now = before
        do i = 2, size(time)
            call check_cancelled(error)
            if (allocated(error)) return
            rate = (depth(i) - depth(i - 1))/(time(i) - time(i - 1))
            ! grows again immediately, or would have to at the end of the step?
            steady = .true.
            if (i > 2) steady = retreats(phi, behind, rate)
            ! steps are known to the rounding of the times
            if (abs(time(i) - time(i - 1) - step) > 4.0_wp*epsilon(step)*max(abs(time(i)), abs(time(i - 1)))) then
                step = time(i) - time(i - 1)
                z = phi%rate*step
                decay = exp(-min(z, 700.0_wp))
                mean = mean_decay(z)
            end if
            rise_before = rise
            rise = decay*rise + (depth(i) - depth(i - 1))*mean
            call find_edge(path, phi, rise, rate, time(i), depth(i), before, now)
            edge = edge_depth(path, now)
            if (edge > edge_depth(path, before)) then
                covered = edge <= edge_depth(path, before) + tolerance .and. .not. before%has_separated
                if (.not. covered) return
                now = before
                edge = edge_depth(path, now)
            end if
            ! the memory of the spring at the edge, int_t1^t exp(-rate (t - u)) d'(u) du, and the load of those inside
            behind = rise
            if (.not. now%has_separated) then
                call partial_integrals(path, now%panel + 1, now%fraction, load, passed)
                z = exp(-min(phi%rate*(time(i) - edge_time(path, now)), 700.0_wp))
                behind = rise - z*passed(:n)
                force(i) = phi%limit*load(n + 1) + sum(phi%weight*load(:n)*z)
            end if
            if (.not. (steady .and. retreats(phi, behind, rate))) then
                ! the rate in the middle of the step
                z = 0.5_wp*phi%rate*step
                rise_before = exp(-min(z, 700.0_wp))*rise_before + 0.5_wp*(depth(i) - depth(i - 1))*mean_decay(z)
                call find_edge(path, phi, rise_before, rate, 0.5_wp*(time(i) + time(i - 1)), 0.5_wp*(depth(i) + depth(i - 1)), &
                               before, between)
                covered = edge_depth(path, between) >= edge - tolerance .and. &
                          edge_depth(path, between) <= edge_depth(path, before) + tolerance
                if (.not. covered) return
            end if
            before = now
            if (now%has_separated) cycle
            count = count + 1
            depths(count) = edge
        end do
        call curve%at_depths(depths(:count), error, radius=radii(:count))
        if (allocated(error)) return
        ! those not lost come first
        radius(2:count + 1) = radii(:count)
    end subroutine shrink

    !> Depth and time at which the edge of a shrinking contact was passed on the way in.
    pure function edge_depth(path, place) result(depth)
        type(path_t), intent(in) :: path
        type(unloading_t), intent(in) :: place
        real(wp) :: depth

        depth = 0.0_wp
        if (.not. place%has_separated) depth = path%depth(place%panel) &
                                         + place%fraction*(path%depth(place%panel + 1) - path%depth(place%panel))
    end function edge_depth

    pure function edge_time(path, place) result(time)
        type(path_t), intent(in) :: path
        type(unloading_t), intent(in) :: place
        real(wp) :: time

        time = path%time(0)
        if (.not. place%has_separated) time = path%time(place%panel) &
                                        + place%fraction*(path%time(place%panel + 1) - path%time(place%panel))
    end function edge_time

    !> Whether the load of the spring at the edge falls at a rate of the depth: else it, or one that it has left, touches again.
    pure function retreats(phi, behind, rate) result(answer)
        type(prony_t), intent(in) :: phi
        real(wp), intent(in) :: behind(:), rate
        logical :: answer
        real(wp) :: pull, memory

        pull = phi%instant()*rate
        memory = sum(phi%weight*phi%rate*behind)
        answer = pull - memory <= noise*(abs(pull) + sum(abs(phi%weight*phi%rate*behind)))
    end function retreats

    !> Where int_t1^t phi(t - u) d'(u) du = 0, searched for from where it was before.
    pure subroutine find_edge(path, phi, rise, rate, time, depth, before, place)
        type(path_t), intent(in) :: path
        type(prony_t), intent(in) :: phi
        real(wp), intent(in) :: rise(:), rate, time, depth
        type(unloading_t), intent(in) :: before
        type(unloading_t), intent(out) :: place
        real(wp) :: weight(size(rise)), z(size(rise)), rest(size(rise)), start(size(rise)), c(0:powers)
        real(wp) :: now, value, slope, bend, low, high, x, next, step, length, climb
        integer :: i, k, n, p, slow, last

        n = size(rise)
        place%has_separated = .true.
        if (before%has_separated) p = 0
        if (.not. before%has_separated) p = before%panel
        now = sum(phi%weight*rise) + phi%limit*depth + phi%viscosity*rate
        do
            ! what the panel's end sees of itself: weights to its end, integrals from its beginning
            weight = phi%weight*exp(-min(phi%rate*(time - path%time(p + 1)), 700.0_wp))
            value = now - sum(weight*path%rise(:n, p + 1)) - phi%limit*path%depth(p + 1)
            if (value < 0.0_wp .or. p + 1 == path%count) exit
            p = p + 1
        end do
        do
            rest = phi%weight*exp(-min(phi%rate*(time - path%time(p)), 700.0_wp))
            value = now - sum(rest*path%rise(:n, p)) - phi%limit*path%depth(p)
            if (value >= 0.0_wp) exit
            if (p == 0) return
            p = p - 1
            weight = rest
        end do
        if (before%has_separated .and. value <= noise*phi%instant()*path%depth(path%count)) return
        place%has_separated = .false.
        place%panel = p
        length = path%time(p + 1) - path%time(p)
        climb = path%depth(p + 1) - path%depth(p)
        z = phi%rate*length
        last = count(phi%rate*(time - path%time(p + 1)) < forgotten)
        slow = min(count(z <= few_powers_below), last)
        ! of int_0^x sum weight exp(-z (1 - y)) dy = sum c_k (1 - (1 - x)^(k + 1)) for slow rates
        c(0) = phi%limit + sum(weight(:slow))
        rest(:slow) = weight(:slow)
        do k = 1, powers
            rest(:slow) = -rest(:slow)*z(:slow)
            c(k) = sum(rest(:slow))/factorial(k + 1)
        end do
        start(slow + 1:last) = exp(-min(z(slow + 1:last), 700.0_wp))
        low = 0.0_wp
        high = 1.0_wp
        x = min(value/max(climb*(phi%limit + sum(weight)), tiny(x)), 1.0_wp)
        do i = 1, most_steps
            associate (fast => z(slow + 1:last), of => weight(slow + 1:last))
                rest(slow + 1:last) = exp(-min(fast*(1.0_wp - x), 700.0_wp))
                next = value/climb - sum(of*(rest(slow + 1:last) - start(slow + 1:last))/fast)
                slope = sum(of*rest(slow + 1:last))
                bend = sum(of*fast*rest(slow + 1:last))
            end associate
            do k = 0, powers
                next = next - c(k)*(1.0_wp - (1.0_wp - x)**(k + 1))
                slope = slope + c(k)*real(k + 1, wp)*(1.0_wp - x)**k
                if (k > 0) bend = bend - c(k)*real(k*(k + 1), wp)*(1.0_wp - x)**(k - 1)
            end do
            if (next >= 0.0_wp) low = x
            if (next <= 0.0_wp) high = x
            if (.not. slope > 0.0_wp) exit
            ! Halley's step, of third order
            step = next/slope
            step = step/(1.0_wp + max(-0.5_wp, min(0.5_wp*step*bend/slope, 1.0_wp)))
            next = x + step
            if (.not. (next >= low .and. next <= high)) next = 0.5_wp*(low + high)
            step = abs(next - x)
            x = next
            if (step <= 1.0e-6_wp .or. high - low <= 4.0_wp*epsilon(x)) exit
        end do
        place%fraction = x
    end subroutine find_edge

end module mdrcontact_time_follow
