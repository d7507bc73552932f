! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of compiled laws: the tangential force of a contact step by step, for the price of two short polynomials.
!>
!> Theory 10. In units of the coefficient mu, and in terms of S = int dF/k_t (the contact slides at the shift mu S(F)), the load of
!> the springs is taken to be a sum of normal loads of smaller contacts, so that
!>     T/mu = g F(S) - n [m1 F(S1) + m2 F(S2) + m3 F(S3)],    S >= S1 >= S2 >= S3.
!> Outside S1 the springs slip, or slipped last, in the direction g, |g| = 1. Inside they stuck since the load began to move along
!> n from one limit to the other, the chord m1 = 2 g.n away; S2 and S3 are what is left of the slip before the last two turns.
!> While this form holds, a step in which S and the shift change in proportion is exact where springs do not interact: first shear,
!> sliding, loops, small ones about any shift too, with whatever F does while the edge slips. It is an approximation, with T
!> as it is, where the contact grows without slip (the load is then taken to be in proportion to the pressure), where a loop begins
!> inside two others, and where the shift turns aside by more than 6 degrees; a shift across n meets the stiffness of full stick.
module mdrcontact_law_friction
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_contact, only: on_unloading
    use mdrcontact_error, only: error_domain, error_invalid, error_t, raise, raise_at, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_evaluate, only: point_at, run_points, wanted_t
    use mdrcontact_law_interval, only: interval_place, place_t, polynomial_with_slope
    use mdrcontact_law_table, only: law_table_t
    implicit none (type, external)
    private
    public :: friction_law_t, friction_memory_t, turn_memory

    integer, parameter :: levels = 3

    !> What one contact remembers from step to step, C's struct mdr_friction_memory. All 0: it has not been loaded.
    type, bind(C) :: friction_memory_t
        !> T, in the coordinates of the shifts [modulus length^2]
        real(c_double) :: force(3) = 0.0_c_double
        !> n; 0 where the load is in proportion to the pressure
        real(c_double) :: axis(3) = 0.0_c_double
        !> F and S [length] after the last step
        real(c_double) :: normal_force = 0.0_c_double, level = 0.0_c_double
        !> m, S and F(S) of the disc of stick and of what is left of the slip before the last two turns; m = 0: of none
        real(c_double) :: slope(levels) = 0.0_c_double, stick_level(levels) = 0.0_c_double, stick_force(levels) = 0.0_c_double
    end type friction_memory_t

    !> The law of a contact with friction. It never changes.
    type :: friction_law_t
        !> F and k_t over S, and S over F
        type(contact_law_t), allocatable :: law
        !> mu [1]
        real(wp) :: coefficient = 0.0_wp
        !> largest error of T found, relative to mu F: in first shear; along cycles of depth and shift against the exact history,
        !> relative to the largest mu F, -1 where there is none
        real(wp) :: first_shear_error = 0.0_wp, path_error = -1.0_wp
    contains
        procedure :: advance
        procedure :: advance_all
    end type friction_law_t

    !> One step of each of many contacts.
    type, extends(batch_t) :: steps_t
        type(contact_law_t), pointer :: law => null()
        real(wp) :: coefficient = 0.0_wp
        real(wp), pointer, contiguous :: force(:) => null(), shift(:, :) => null()
        type(friction_memory_t), pointer, contiguous :: memory(:) => null()
    contains
        procedure :: work => do_steps
    end type steps_t

    !> Contacts for which the law is asked at a time, and below how many each by itself is quicker; from how many on several threads
    !> pay.
    integer, parameter :: block_size = 256, few = 6, smallest_parallel = 64*block_size

    !> A shift across n that is more than this part of that along it ends n.
    real(wp), parameter :: aside = 0.1_wp
    !> How far from 1 the square of the length of g may come by rounding.
    real(wp), parameter :: drift = 1.0e-13_wp
    !> Forces, shifts and memories of larger size are refused: their squares are no numbers.
    real(wp), parameter :: largest = 1.0e150_wp
    character(len=*), parameter :: must_be_moderate = " must be finite, at most 1e150 in size"

contains

    !> One step of a contact, in which normal force and shift change in proportion. After an error the memory is as before.
    pure subroutine advance(self, force, shift, memory, error)
        class(friction_law_t), intent(in) :: self
        !> F at the end of the step; F <= 0 parts the bodies [modulus length^2]
        real(wp), intent(in) :: force
        !> by how much the indenter moves along the surface in this step [length]
        real(wp), intent(in) :: shift(3)
        !> of this contact; its force is T on the medium
        type(friction_memory_t), intent(inout) :: memory
        type(error_t), allocatable, intent(out) :: error

        call check_step(self, force, shift, memory, error)
        if (.not. allocated(error)) call step(self, force, shift, memory)
    end subroutine advance

    !> One step of each of many contacts, on `threads` threads (0: as many as the runtime offers), as advance does it. After an
    !> error all memories are as before, and the error names the first contact that is at fault.
    subroutine advance_all(self, n, force, shift, memory, threads, error)
        class(friction_law_t), intent(in), target :: self
        !> how many contacts, >= 0
        integer, intent(in) :: n
        !> as of advance
        real(wp), intent(in), target :: force(n), shift(3, n)
        !> of each contact
        type(friction_memory_t), intent(inout), target :: memory(n)
        !> at least 1, or 0 for as many as OpenMP offers
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        ! all are possible before the first one is done
        do i = 1, n
            if (is_plain(self, force(i), shift(:, i), memory(i))) cycle
            call check_step(self, force(i), shift(:, i), memory(i), error)
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
        if (n >= few) then
            call run_steps(self, force, shift, memory, threads, error)
        else
            do i = 1, n
                call step(self, force(i), shift(:, i), memory(i))
            end do
        end if
    end subroutine advance_all

    subroutine run_steps(self, force, shift, memory, threads, error)
        class(friction_law_t), intent(in), target :: self
        real(wp), intent(in), target, contiguous :: force(:), shift(:, :)
        type(friction_memory_t), intent(inout), target, contiguous :: memory(:)
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(inout) :: error
        type(steps_t) :: steps

        steps%is_quick = .true.
        steps%law => self%law
        steps%coefficient = self%coefficient
        steps%force => force
        steps%shift => shift
        steps%memory => memory
        call run_batch(steps, size(force), block_size, smallest_parallel, threads, error)
    end subroutine run_steps

    !> Steps of contacts first to last; the law is asked for many points at a time, which is quicker, and gives the same bits.
    subroutine do_steps(self, first, last, error)
        class(steps_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(block_size), target :: level, compliance, stick, at_stick
        integer :: i, n

        n = last - first + 1
        call run_points(self%law%by_force, on_unloading, self%force(first:last), .false., 1, wanted_t(level(:n), compliance(:n)))
        do i = 1, n
            call begin_step(self%coefficient, self%force(first + i - 1), self%shift(:, first + i - 1), level(i), compliance(i), &
                            self%memory(first + i - 1))
            stick(i) = self%memory(first + i - 1)%stick_level(1)
            ! where nothing sticks any other answer is as good, and this one quick
            if (.not. stick(i) > 0.0_wp) stick(i) = self%law%by_depth%direct%lowest
        end do
        call run_points(self%law%by_depth, on_unloading, stick(:n), .false., 1, wanted_t(at_stick(:n)))
        do i = 1, n
            call end_step(self%coefficient, self%force(first + i - 1), at_stick(i), self%memory(first + i - 1))
        end do
    end subroutine do_steps

    !> advance, of a step that is possible: check_step has no error.
    pure subroutine step(self, force, shift, memory)
        class(friction_law_t), intent(in) :: self
        !> F at the end of the step [modulus length^2]
        real(wp), intent(in) :: force
        !> in this step [length]
        real(wp), intent(in) :: shift(3)
        !> of this contact
        type(friction_memory_t), intent(inout) :: memory
        real(wp) :: level, compliance, at_stick, unused

        at_stick = 0.0_wp
        call values_at(self%law%by_force, force, level, compliance)
        call begin_step(self%coefficient, force, shift, level, compliance, memory)
        if (memory%stick_level(1) > 0.0_wp) call values_at(self%law%by_depth, memory%stick_level(1), at_stick, unused)
        call end_step(self%coefficient, force, at_stick, memory)
    end subroutine step

    !> All of a step but for what F(S1) brings: T without the load that is missing in the disc of stick, and that disc.
    pure subroutine begin_step(mu, force, shift, level, compliance, memory)
        real(wp), intent(in) :: mu, force, shift(3)
        !> S after the step, and dS/dF
        real(wp), intent(in) :: level, compliance
        type(friction_memory_t), intent(inout) :: memory
        real(wp) :: rise, way, total
        logical :: has_axis

        if (.not. force > 0.0_wp) then
            memory = friction_memory_t()
            return
        end if
        rise = level - memory%level
        total = squared(shift)
        way = along(shift, memory%axis)
        has_axis = squared(memory%axis) > 0.0_wp
        if (has_axis) then
            has_axis = total <= (1.0_wp + aside**2)*max(way**2, (mu*rise)**2)
        else
            way = sqrt(total)
        end if
        if (rise > 0.0_wp .and. abs(way) <= mu*rise) then
            memory%force = memory%force + (force - memory%normal_force)/rise*shift
            memory%axis = 0.0_wp
        else
            if (.not. has_axis) call choose_axis(mu, shift, rise, memory, has_axis)
            if (has_axis) call slip(mu, force, shift, level, rise, compliance, memory)
        end if
        memory%normal_force = force
        memory%level = level
    end subroutine begin_step

    !> The rest; without an axis nothing is missing.
    pure subroutine end_step(mu, force, at_stick, memory)
        real(wp), intent(in) :: mu, force
        !> F(S1), where S1 > 0
        real(wp), intent(in) :: at_stick
        type(friction_memory_t), intent(inout) :: memory
        real(wp) :: total

        memory%stick_force(1) = 0.0_wp
        if (memory%stick_level(1) > 0.0_wp) memory%stick_force(1) = at_stick
        memory%force = memory%force - mu*along(memory%slope, memory%stick_force)*memory%axis
        total = squared(memory%force)
        if (total > (mu*force)**2) memory%force = mu*force/sqrt(total)*memory%force
    end subroutine end_step

    !> A step in which the edge slips, forward or back.
    pure subroutine slip(mu, force, shift, level, rise, compliance, memory)
        real(wp), intent(in) :: mu, force, shift(3)
        !> S after the step, how much it has grown, and dS/dF
        real(wp), intent(in) :: level, rise, compliance
        type(friction_memory_t), intent(inout) :: memory
        real(wp) :: way, edge(3), share, moved, stiffness

        edge = memory%axis
        if (memory%normal_force > 0.0_wp) then
            edge = (memory%force/mu + along(memory%slope, memory%stick_force)*memory%axis)/memory%normal_force
            share = squared(edge)
            if (.not. share > 0.0_wp) then
                edge = memory%axis
            else if (abs(share - 1.0_wp) > drift) then
                edge = edge/sqrt(share)
            end if
        end if
        share = max(along(edge, memory%axis), 0.0_wp)
        way = along(shift, memory%axis)
        moved = way/mu - share*rise
        if (moved < 0.0_wp) then
            call turn(share, memory, edge)
            way = -way
            moved = way/mu - share*rise
        end if
        call move_stick(moved, level, memory)
        ! the limit is a circle: what slides follows the shift
        if (.not. memory%stick_level(1) > 0.0_wp) way = min(way, 0.0_wp)
        stiffness = 1.0_wp/compliance
        memory%force = mu*force*edge - stiffness*way*memory%axis + stiffness*shift
    end subroutine slip

    !> Whether a step is certainly possible; where not, check_step says what is wrong, if anything is.
    pure function is_plain(self, force, shift, memory) result(plain)
        class(friction_law_t), intent(in) :: self
        real(wp), intent(in) :: force, shift(3)
        type(friction_memory_t), intent(in) :: memory
        logical :: plain

        plain = force <= self%law%by_force%highest &
                .and. abs(force) + (abs(shift(1)) + abs(shift(2)) + abs(shift(3))) + sum_of(memory) <= largest
    end function is_plain

    !> That of the sizes of all numbers: none if any is none.
    pure function sum_of(memory) result(total)
        type(friction_memory_t), intent(in) :: memory
        real(wp) :: total
        real(wp) :: part(3)

        part = ((abs(memory%force) + abs(memory%axis)) + (abs(memory%slope) + abs(memory%stick_level))) + abs(memory%stick_force)
        total = (part(1) + part(2)) + (part(3) + (abs(memory%normal_force) + abs(memory%level)))
    end function sum_of

    !> Whether a step is possible.
    pure subroutine check_step(self, force, shift, memory, error)
        class(friction_law_t), intent(in) :: self
        !> as of advance
        real(wp), intent(in) :: force
        !> see force
        real(wp), intent(in) :: shift(3)
        !> see force
        type(friction_memory_t), intent(in) :: memory
        type(error_t), allocatable, intent(inout) :: error

        if (.not. abs(force) <= largest) call raise(error, error_invalid, must_be_moderate, "force")
        if (.not. all(abs(shift) <= largest)) call raise(error, error_invalid, must_be_moderate, "shift")
        if (.not. sum_of(memory) <= largest) then
            call raise(error, error_invalid, must_be_moderate//", and all 0 before the first step", "memory")
        end if
        if (force > self%law%by_force%highest .and. .not. self%law%by_force%continued) then
            call raise(error, error_domain, " = "//to_text(force)//" is beyond the law's largest force, "// &
                       to_text(self%law%by_force%highest)//": give it a larger largest_depth, or let it continue beyond", "force")
        end if
    end subroutine check_step

    pure function along(a, b) result(product)
        real(wp), intent(in) :: a(3), b(3)
        real(wp) :: product

        product = a(1)*b(1) + a(2)*b(2) + a(3)*b(3)
    end function along

    pure function squared(a) result(square)
        real(wp), intent(in) :: a(3)
        real(wp) :: square

        square = along(a, a)
    end function squared

    !> The other quantity and its slope where the bodies touch.
    pure subroutine values_at(table, s, other, slope)
        type(law_table_t), intent(in) :: table
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope
        type(place_t) :: place
        real(wp) :: radius, stiffness

        if (s >= table%direct%lowest .and. s <= table%direct%highest) then
            place = interval_place(table%direct, s)
            call polynomial_with_slope(table%other(place%panel)%c, place%t, other, slope)
            slope = table%direct%scale*slope
        else
            call point_at(table, on_unloading, s, other, slope, radius, stiffness)
        end if
    end subroutine values_at

    !> The direction in which the edge begins to slip, from a load in proportion to the pressure, and how far its limit is.
    pure subroutine choose_axis(mu, shift, rise, memory, found)
        real(wp), intent(in) :: mu, shift(3), rise
        type(friction_memory_t), intent(inout) :: memory
        !> whether there is one: not without a pull
        logical, intent(out) :: found
        real(wp) :: share(3), pulled(3), c, length

        share = 0.0_wp
        if (memory%normal_force > 0.0_wp) share = memory%force/(mu*memory%normal_force)
        ! a falling limit meets the load
        pulled = shift - mu*min(rise, 0.0_wp)*share
        length = norm2(pulled)
        found = length > 0.0_wp
        memory%axis = 0.0_wp
        if (.not. found) return
        memory%axis = pulled/length
        c = along(share, memory%axis)
        memory%slope = [max(sqrt(max(1.0_wp - squared(share) + c**2, 0.0_wp)) - c, 0.0_wp), 0.0_wp, 0.0_wp]
        memory%stick_level = [memory%level, 0.0_wp, 0.0_wp]
        memory%stick_force = [memory%normal_force, 0.0_wp, 0.0_wp]
    end subroutine choose_axis

    !> The edge slips back: a new chord from the other limit. What is left of the oldest slip is added to that of the next.
    pure subroutine turn(share, memory, edge)
        !> g.n
        real(wp), intent(in) :: share
        type(friction_memory_t), intent(inout) :: memory
        real(wp), intent(inout) :: edge(3)

        if (memory%stick_force(levels) > 0.0_wp) then
            memory%slope(2) = memory%slope(2) + memory%slope(levels)*memory%stick_force(levels)/memory%stick_force(2)
        end if
        memory%slope = [2.0_wp*share, -memory%slope(:2)]
        memory%stick_level = [memory%level, memory%stick_level(:2)]
        memory%stick_force = [memory%normal_force, memory%stick_force(:2)]
        edge = edge - memory%slope(1)*memory%axis
        memory%axis = -memory%axis
    end subroutine turn

    !> The disc of stick shrinks by a shift in units of mu, and takes in what is left of earlier slip when it comes there.
    pure subroutine move_stick(moved, level, memory)
        real(wp), intent(in) :: moved
        !> S after the step
        real(wp), intent(in) :: level
        type(friction_memory_t), intent(inout) :: memory
        real(wp) :: left, there

        left = moved
        do while (memory%stick_level(2) > 0.0_wp)
            there = memory%slope(1)*(memory%stick_level(1) - memory%stick_level(2))
            if (left < there) exit
            left = left - there
            memory%slope = [max(memory%slope(1) + memory%slope(2), 0.0_wp), memory%slope(3:), 0.0_wp]
            memory%stick_level = [memory%stick_level(2:), 0.0_wp]
            memory%stick_force = [memory%stick_force(2:), 0.0_wp]
        end do
        if (left < memory%slope(1)*memory%stick_level(1)) then
            memory%stick_level(1) = min(memory%stick_level(1) - left/memory%slope(1), level)
        else
            memory%stick_level(1) = 0.0_wp
        end if
    end subroutine move_stick

    !> The memory of a contact whose tangent plane has turned: force and axis are laid into the new plane with their lengths.
    pure subroutine turn_memory(memory, normal)
        type(friction_memory_t), intent(inout) :: memory
        !> of the new plane, of length 1
        real(wp), intent(in) :: normal(3)

        call lay(memory%force, normal)
        call lay(memory%axis, normal)
    end subroutine turn_memory

    pure subroutine lay(vector, normal)
        real(wp), intent(inout) :: vector(3)
        real(wp), intent(in) :: normal(3)
        real(wp) :: length, left

        length = norm2(vector)
        vector = vector - along(vector, normal)*normal
        left = norm2(vector)
        if (left > 0.0_wp) vector = length/left*vector
    end subroutine lay

end module mdrcontact_law_friction
