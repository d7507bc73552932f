! SPDX-License-Identifier: GPL-3.0-or-later
!> A full cycle of approach and retraction under depth control, force control, or through a spring such as an AFM cantilever:
!> jump-in, adhesive contact, pull-off, and the energy that is lost (theory/paper.md (5.1)).
module mdrcontact_contact_loop
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact, only: contact_t, on_loading
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_count_within, check_made, check_memory, check_positive, error_t, error_unreachable, raise, &
                                to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: loop_t, new_loop, spring_control

    !> The path of a cycle. A jump is two neighbouring points with the same position.
    type :: loop_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> what the machine controls: depth [length], force [modulus length^2], or the far end of the spring [length]
        real(wp), allocatable :: position(:)
        !> the states at these positions; radius 0 for separated bodies
        type(contact_state_t), allocatable :: state(:)
        !> index of the last point of the approach
        integer :: turning_point = 0
        !> indices of the points just before each jump
        integer, allocatable :: jumps(:)
        !> energy lost in the cycle, the area of the loop; under a prescribed force up to pull-off, because the distance of the
        !> bodies is unknown afterwards [modulus length^3]
        real(wp) :: dissipated_energy = 0.0_wp
        !> number of points so far
        integer, private :: points = 0
    end type loop_t

    !> Distance before pull-off at which a drawn loop begins, relative to the pull-off position.
    real(wp), parameter :: margin = 1.25_wp
    integer, parameter :: most_points = 1000000

contains

    !> The far end of a spring that presses the indenter: position = d + F/stiffness.
    subroutine spring_control(control, stiffness, error)
        type(control_t), intent(out) :: control
        !> of the spring, > 0 [modulus length]
        real(wp), intent(in) :: stiffness
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "spring_stiffness", stiffness)
        if (.not. allocated(error)) control = control_t(1.0_wp, 1.0_wp/stiffness)
    end subroutine spring_control

    !> Approaches from afar to `largest` and retracts until the bodies are separated again.
    subroutine new_loop(self, contact, control, largest, count, error)
        type(loop_t), intent(out) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        !> the position where the motion turns back, > 0
        real(wp), intent(in) :: largest
        !> number of points on each way, 2 to 1000000; jumps and their ends come on top
        integer, intent(in) :: count
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_positive(error, "largest", largest)
        call check_count_within(error, "points", count, 2, most_points)
        if (allocated(error)) return
        allocate (self%jumps(0))
        call resize(self, 2*count + 8, error)
        if (allocated(error)) return
        if (contact%is_adhesive()) then
            call adhesive_way(self, contact, control, largest, count, error)
        else
            call elastic_way(self, contact, control, largest, count, error)
        end if
        if (.not. allocated(error)) call resize(self, self%points, error)
        self%is_made = .not. allocated(error)
    end subroutine new_loop

    !> With adhesion: jump-in, contact, pull-off.
    subroutine adhesive_way(self, contact, control, largest, count, error)
        type(loop_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: largest
        integer, intent(in) :: count
        type(error_t), allocatable, intent(out) :: error
        type(stable_segment_t), allocatable :: list(:)
        type(contact_state_t) :: entered
        real(wp) :: start, pull_off, attracted
        integer :: current

        call contact%stable_segments(control, list, error)
        if (allocated(error)) return
        attracted = contact%first_attraction(control)
        current = findloc(list%lowest <= attracted .and. attracted <= list%highest, .true., dim=1)
        if (current == 0) then
            call raise(error, error_unreachable, "the bodies do not adhere on contact: there is no stable state at position "// &
                       to_text(attracted))
            return
        end if
        start = margin*min(minval(list%lowest), attracted, 0.0_wp)
        call add_apart(self, control, start, error)
        if (.not. allocated(error)) call add_apart(self, control, attracted, error)
        if (.not. allocated(error)) call load(self, contact, control, list, current, attracted, largest, count, entered, error)
        if (allocated(error)) return
        self%turning_point = self%points
        call unload(self, contact, control, list, current, largest, count, entered, error)
        if (allocated(error)) return
        call add_jump(self)
        ! not handed over as an element of an array that grows
        pull_off = self%position(self%points)
        call add_apart(self, control, pull_off, error)
        if (.not. allocated(error)) call add_apart(self, control, start, error)
    end subroutine adhesive_way

    subroutine load(self, contact, control, list, current, attracted, largest, count, entered, error)
        type(loop_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: list(:)
        integer, intent(inout) :: current
        !> where the bodies begin to attract each other, and where the motion turns back
        real(wp), intent(in) :: attracted, largest
        integer, intent(in) :: count
        !> the state in which the contact enters the segment where the motion turns back
        type(contact_state_t), intent(out) :: entered
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: left
        real(wp) :: from, to
        integer :: step

        from = attracted
        do
            call add_jump(self)
            to = min(largest, list(current)%highest)
            call follow(self, contact, control, list(current), from, to, share(from, to, largest, count), entered, left, &
                        error)
            if (allocated(error) .or. to >= largest) return
            call add_work(self, contact, control, entered, left)
            from = to
            step = findloc(list(current + 1:)%lowest <= from .and. from <= list(current + 1:)%highest, .true., dim=1)
            if (step == 0) then
                call raise(error, error_unreachable, "largest: the turning point cannot be reached, because the indenter or "// &
                           "the medium ends before it"//trim(contact%equilibrium%why_it_ends()))
                return
            end if
            current = current + step
        end do
    end subroutine load

    subroutine unload(self, contact, control, list, current, largest, count, entered, error)
        type(loop_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: list(:)
        integer, intent(inout) :: current
        real(wp), intent(in) :: largest
        integer, intent(in) :: count
        !> the state in which the contact entered the segment where the motion turns back
        type(contact_state_t), intent(in) :: entered
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: first, left
        real(wp) :: from, to
        integer :: next

        from = largest
        do
            to = list(current)%lowest
            call follow(self, contact, control, list(current), from, to, share(from, to, largest, count), first, left, error)
            if (allocated(error)) return
            ! The way up to `largest` and down again does no work: under a large load it would leave its rounding only.
            if (from >= largest) first = entered
            call add_work(self, contact, control, first, left)
            next = findloc(list(:current - 1)%lowest <= to .and. to <= list(:current - 1)%highest, .true., dim=1, back=.true.)
            if (next == 0) return
            call add_jump(self)
            from = to
            current = next
        end do
    end subroutine unload

    !> Points along one stable segment.
    subroutine follow(self, contact, control, segment, from, to, count, first, state, error)
        type(loop_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: from, to
        integer, intent(in) :: count
        !> the states at `from` and `to`
        type(contact_state_t), intent(out) :: first, state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: s
        integer :: i

        do i = 0, count - 1
            s = from + (to - from)*(real(i, wp)/(count - 1))
            if (i == count - 1) s = to
            call contact%state_on_segment(control, segment, s, state, error)
            if (allocated(error)) return
            if (i == 0) then
                first = state
                ! Under a prescribed force the load does work while the contact jumps.
                if (control%depth_weight == 0.0_wp) self%dissipated_energy = self%dissipated_energy &
                    + self%state(self%points)%force*(state%depth - self%state(self%points)%depth)
            end if
            call add(self, s, state, error)
            if (allocated(error)) return
        end do
    end subroutine follow

    !> The work of contact and spring between two states of one stable segment.
    subroutine add_work(self, contact, control, first, last)
        type(loop_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        type(contact_state_t), intent(in) :: first, last

        self%dissipated_energy = self%dissipated_energy + contact%work_between(first, last)
        if (control%depth_weight > 0.0_wp) self%dissipated_energy = self%dissipated_energy &
            + 0.5_wp*control%force_weight*(last%force**2 - first%force**2)
    end subroutine add_work

    !> Without adhesion the way back is the way in, and nothing is lost.
    subroutine elastic_way(self, contact, control, largest, count, error)
        type(loop_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: largest
        integer, intent(in) :: count
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        integer :: i

        do i = 0, 2*(count - 1)
            associate (s => largest*(real(min(i, 2*(count - 1) - i), wp)/(count - 1)))
                call contact%at_control(control, "position", s, state, error, on_loading)
                if (allocated(error)) return
                call add(self, s, state, error)
                if (allocated(error)) return
            end associate
        end do
        self%turning_point = count
    end subroutine elastic_way

    !> Separated bodies: no force, and the depth that the machine leaves them.
    subroutine add_apart(self, control, position, error)
        type(loop_t), intent(inout) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: position
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: apart

        if (control%depth_weight > 0.0_wp) apart%depth = position/control%depth_weight
        call add(self, position, apart, error)
    end subroutine add_apart

    subroutine add_jump(self)
        type(loop_t), intent(inout) :: self

        self%jumps = [self%jumps, self%points]
    end subroutine add_jump

    subroutine add(self, position, state, error)
        type(loop_t), intent(inout) :: self
        real(wp), intent(in) :: position
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(inout) :: error

        call check_cancelled(error)
        if (self%points == size(self%position)) call resize(self, 2*self%points, error)
        if (allocated(error)) return
        self%points = self%points + 1
        self%position(self%points) = position
        self%state(self%points) = state
    end subroutine add

    !> Room for so many points.
    subroutine resize(self, room, error)
        type(loop_t), intent(inout) :: self
        integer, intent(in) :: room
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: position(:)
        type(contact_state_t), allocatable :: state(:)
        integer :: stat

        allocate (position(room), state(room), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        if (self%points > 0) then
            position(:self%points) = self%position(:self%points)
            state(:self%points) = self%state(:self%points)
        end if
        call move_alloc(position, self%position)
        call move_alloc(state, self%state)
    end subroutine resize

    !> Points for a part of the way, proportionally to its length.
    pure function share(from, to, whole, count) result(points)
        real(wp), intent(in) :: from, to, whole
        integer, intent(in) :: count
        integer :: points

        points = max(2, nint(count*min(abs(to - from)/whole, 1.0_wp)))
    end function share

end module mdrcontact_contact_loop
