! SPDX-License-Identifier: GPL-3.0-or-later
!> Histories under a prescribed force of a body whose materials relax proportionally, from its elastic curve: whenever the contact
!> is as large as it ever was, F_el(t) = int j(t - u) dF(u), j the creep function (Lee, Radok, J. Appl. Mech. 27 (1960) 438), for
!> any previous history: the springs outside carried nothing then, so that the sum of their displacements over the contact is F_el
!> (theory/time.md (3.3), (3.4)).
!>
!> In between, where a force that wavers lets the contact shrink, F_el misses what the springs between a and the largest radius A
!> still remember. They lie above the line of the indenter by at most d(A) - d(a), and of that by what creep adds; a glassy spring
!> leaves the contact R = j(long)/j(short) times sooner than an elastic one. The depth is then wrong by at most
!> (R - 1) (A - a)(d(A) - d(a))/a, of second order, the radius by R (A - a).
module mdrcontact_time_under_force
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, given_force
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_time_path, only: mean_decay
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_prony, only: creep_of, creep_t, prony_t
    implicit none (type, external)
    private
    public :: follow_force

    !> Rounding of a sum of exponentials, relative to its terms.
    real(wp), parameter :: noise = 1.0e-11_wp

contains

    !> Depth and radius under a force that is prescribed. `covered` is false, and they are undefined, where the contact shrinks so
    !> far that the tolerance is not met.
    subroutine follow_force(contact, phi, time, force, tolerance, depth_alone, depth, radius, covered, error)
        !> of the elastic body
        type(contact_t), intent(in) :: contact
        !> what its modulus is multiplied by, phi(t) [1]
        type(prony_t), intent(in) :: phi
        !> ascending; before the first the bodies are separated and at rest, and if the first force is positive it is reached in a
        !> jump
        real(wp), intent(in) :: time(:)
        !> F >= 0 [modulus length^2]
        real(wp), intent(in) :: force(:)
        !> of depth and radius, relative to their largest; of the depth alone where the radius does not matter
        real(wp), intent(in) :: tolerance
        logical, intent(in) :: depth_alone
        !> same size as force
        real(wp), intent(out) :: depth(:), radius(:)
        logical, intent(out) :: covered
        type(error_t), allocatable, intent(out) :: error
        type(creep_t) :: creep
        type(contact_state_t), allocatable :: states(:)
        real(wp), allocatable :: elastic(:), peak(:), depth_error(:), radius_error(:)
        integer :: n, stat

        n = size(force)
        covered = .false.
        allocate (elastic(n), peak(n), states(n), depth_error(n), radius_error(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        creep = creep_of(phi)
        call find_elastic(creep, time, force, elastic, peak, error)
        if (.not. allocated(error)) call contact_states(contact, given_force, elastic, states, error)
        if (allocated(error)) return
        depth = states%depth
        radius = states%radius
        call find_errors(contact, creep_ratio(creep, time), elastic, peak, states, depth_error, radius_error, error)
        if (allocated(error)) return
        covered = all(depth_error <= tolerance*maxval(depth)) .and. &
                  (depth_alone .or. all(radius_error <= tolerance*maxval(radius)))
    end subroutine follow_force

    !> F_el(t) = int j(t - u) dF(u), and the largest value that it has reached.
    subroutine find_elastic(creep, time, force, elastic, peak, error)
        type(creep_t), intent(in) :: creep
        real(wp), intent(in) :: time(:), force(:)
        real(wp), intent(out) :: elastic(:), peak(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: rise(size(creep%rate)), z(size(creep%rate)), impulse, rate, length, at_first, at_last
        integer :: i

        rise = force(1)
        impulse = 0.0_wp
        elastic(1) = creep%instant*force(1)
        peak(1) = elastic(1)
        do i = 2, size(force)
            call check_cancelled(error)
            if (allocated(error)) return
            length = time(i) - time(i - 1)
            rate = (force(i) - force(i - 1))/length
            at_first = growth(creep, rate, force(i - 1), rise)
            z = creep%rate*length
            rise = exp(-min(z, 700.0_wp))*rise + (force(i) - force(i - 1))*mean_decay(z)
            impulse = impulse + 0.5_wp*(force(i) + force(i - 1))*length
            elastic(i) = creep%instant*force(i) + sum(creep%weight*(force(i) - rise)) + creep%fluidity*impulse
            at_last = growth(creep, rate, force(i), rise)
            peak(i) = max(peak(i - 1), elastic(i))
            ! it rises and falls within the step
            if (at_first > 0.0_wp .and. at_last < 0.0_wp) then
                peak(i) = max(peak(i), min(elastic(i - 1) + at_first*length, elastic(i) - at_last*length))
            end if
        end do
    end subroutine find_elastic

    !> dF_el/dt
    pure function growth(creep, rate, force, rise) result(slope)
        type(creep_t), intent(in) :: creep
        real(wp), intent(in) :: rate, force, rise(:)
        real(wp) :: slope

        slope = creep%instant*rate + creep%fluidity*force + sum(creep%weight*creep%rate*rise)
    end function growth

    !> R: the creep of the body between the shortest step and the whole time; huge where a dashpot makes it initially rigid.
    pure function creep_ratio(creep, time) result(ratio)
        type(creep_t), intent(in) :: creep
        real(wp), intent(in) :: time(:)
        real(wp) :: ratio
        integer :: n

        n = size(time)
        ratio = 1.0_wp
        if (n < 2) return
        ratio = creep%at(time(n) - time(1))/max(creep%at(minval(time(2:) - time(:n - 1))), tiny(1.0_wp))
    end function creep_ratio

    !> Bounds of the errors of depth and radius while the contact is smaller than it was.
    subroutine find_errors(contact, ratio, elastic, peak, states, depth_error, radius_error, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: ratio, elastic(:), peak(:)
        type(contact_state_t), intent(in) :: states(:)
        real(wp), intent(out) :: depth_error(:), radius_error(:)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t), allocatable :: largest(:)
        logical, allocatable :: shrunk(:)
        integer, allocatable :: places(:)
        real(wp) :: lost
        integer :: i, j, stat

        depth_error = 0.0_wp
        radius_error = 0.0_wp
        allocate (shrunk(size(elastic)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        shrunk = elastic < peak*(1.0_wp - noise)
        allocate (places(count(shrunk)), largest(count(shrunk)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        places = pack([(i, i=1, size(elastic))], shrunk)
        call contact_states(contact, given_force, peak(places), largest, error)
        if (allocated(error)) return
        do j = 1, size(places)
            i = places(j)
            lost = largest(j)%radius - states(i)%radius
            radius_error(i) = ratio*lost
            depth_error(i) = huge(1.0_wp)
            if (states(i)%radius > 0.0_wp) depth_error(i) = (ratio - 1.0_wp)*(lost/states(i)%radius) &
                                                            *(largest(j)%depth - states(i)%depth)
        end do
    end subroutine find_errors

end module mdrcontact_time_under_force
