! SPDX-License-Identifier: GPL-3.0-or-later
!> Record of a contact whose work of adhesion depends on the speed of its edge, and its change in a time step
!> (theory/adhesion.md (3.4)).
module mdrcontact_adhesion_rate_state
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_adhesion_rate_contact, only: edge_t, edge_equation_t, rate_contact_t
    use mdrcontact_crc32, only: coarse, mark_of
    use mdrcontact_error, only: check_finite, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_stiff_step, only: stages, stiff_step, weights
    implicit none (type, external)
    private
    public :: rate_state_t, account, break_edge, check_state, force_rate, note_force, note_lowest, sign_state

    !> C's struct mdr_rate_state: a datum from which a history continues. All zero: apart, and nothing has happened yet.
    type, bind(C) :: rate_state_t
        !> a, 0 for separated bodies; less than 0 at the beginning: in equilibrium with the first value [length]
        real(c_double) :: radius = 0.0_c_double
        !> d [length]
        real(c_double) :: depth = 0.0_c_double
        !> energy lost at the edge, beyond what the surfaces gain, int 2 pi a (G - work) v dt [modulus length^3]
        real(c_double) :: dissipated = 0.0_c_double
        !> int F dd [modulus length^3]
        real(c_double) :: work = 0.0_c_double
        !> the lowest force so far, <= 0, and time, depth, radius and speed of the edge there
        real(c_double) :: lowest_force = 0.0_c_double, lowest_time = 0.0_c_double, lowest_depth = 0.0_c_double, &
                          lowest_radius = 0.0_c_double, lowest_speed = 0.0_c_double
        !> when the contact broke last, and the depth; 0 where it did not
        real(c_double) :: rupture_time = 0.0_c_double, rupture_depth = 0.0_c_double
        !> how often it broke
        real(c_double) :: ruptures = 0.0_c_double
        !> F [modulus length^2]
        real(c_double) :: force = 0.0_c_double
        !> checksum of the other members and of the law of the speed; 0 where no history has left the state
        real(c_double) :: mark = 0.0_c_double
    end type rate_state_t

    !> Relative deviation of forces of one contact, whose samples have other places where its largest radius is another one.
    real(wp), parameter :: same = 1.0e-6_wp

    integer, parameter :: most_steps = 60
    real(wp), parameter :: last_step = 1.0e-13_wp

contains

    !> Writes the mark of a state that a history leaves.
    pure subroutine sign_state(state, contact)
        type(rate_state_t), intent(inout) :: state
        type(rate_contact_t), intent(in) :: contact

        state%mark = mark_for(state, contact)
    end subroutine sign_state

    pure function mark_for(state, contact) result(mark)
        type(rate_state_t), intent(in) :: state
        type(rate_contact_t), intent(in) :: contact
        real(wp) :: mark, speed, unused

        associate (law => contact%law)
            call law%speed_at(1.5_wp*law%work, speed, unused)
            mark = mark_of([members(state), &
                            coarse([law%work, law%closing_work, law%speed, law%closing_speed, law%exponent, &
                                    law%closing_exponent, law%crack_scale, law%zone(), speed])])
        end associate
    end function mark_for

    !> All but the mark.
    pure function members(state) result(values)
        type(rate_state_t), intent(in) :: state
        real(wp) :: values(13)

        values = [state%radius, state%depth, state%dissipated, state%work, state%lowest_force, state%lowest_time, &
                  state%lowest_depth, state%lowest_radius, state%lowest_speed, state%rupture_time, state%rupture_depth, &
                  state%ruptures, state%force]
    end function members

    !> Raises unless a state is one that a history of this contact left, or only a radius.
    subroutine check_state(state, contact, error)
        type(rate_state_t), intent(in) :: state
        type(rate_contact_t), intent(in) :: contact
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: values(13)
        integer :: i

        values = members(state)
        call check_finite(error, "radius", values(1))
        if (state%mark == 0.0_wp .and. all(values(2:) == 0.0_wp)) return
        do i = 2, size(values)
            call check_finite(error, "start", values(i))
        end do
        if (allocated(error)) return
        if (.not. abs(state%mark - mark_for(state, contact)) <= 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(real(state%mark, wp))//": the state is not as a history with this "// &
                       "work of adhesion left it. Give such a state unchanged, or a radius only", "mark")
        else if (.not. (is_of(contact, values(1), values(2), values(13)) .and. &
                        is_of(contact, values(8), values(7), values(5)))) then
            call raise(error, error_invalid, " = "//to_text(values(2))//": this contact has another force at this depth and "// &
                       "radius. Give a state of the same contact", "depth")
        end if
    end subroutine check_state

    !> Whether a contact has a force at a radius and a depth; also where the radius is 0, or beyond the samples.
    pure function is_of(contact, radius, depth, force) result(answer)
        type(rate_contact_t), intent(in) :: contact
        real(wp), intent(in) :: radius, depth, force
        logical :: answer
        real(wp) :: x, p(4), dp(4)

        answer = .true.
        if (.not. radius > 0.0_wp) return
        x = contact%coordinate_of(radius)
        if (x < contact%first .or. x > contact%last) return
        call contact%curve%parts(x, p, dp)
        answer = abs(p(2) - p(3)*(p(1) - depth) - force) <= same*(abs(p(2)) + abs(p(3))*(abs(p(1)) + abs(depth)))
    end function is_of

    !> Adds work and loss of a step that begins at time t of the equation.
    pure subroutine account(state, equation, t, h, reached, slopes, places)
        type(rate_state_t), intent(inout) :: state
        type(edge_equation_t), intent(in) :: equation
        real(wp), intent(in) :: t, h
        !> of stiff_step
        real(wp), intent(in) :: reached(stages), slopes(stages), places(stages)
        type(edge_t) :: here
        real(wp) :: v
        integer :: i

        do i = 1, stages
            here = equation%contact%edge(equation%control, equation%start + equation%speed*(t + places(i)*h), reached(i))
            v = -slopes(i)*exp(reached(i))
            state%work = state%work + h*weights(i)*here%force*(here%depth_by_x*slopes(i) + here%depth_by_s*equation%speed)
            state%dissipated = state%dissipated + h*weights(i)*2.0_wp*pi*here%radius*(here%energy - equation%contact%law%work)*v
        end do
    end subroutine account

    !> Remembers a force that is lower than any before.
    pure subroutine note_force(state, here, time, speed)
        type(rate_state_t), intent(inout) :: state
        type(edge_t), intent(in) :: here
        real(wp), intent(in) :: time, speed

        if (.not. here%force < state%lowest_force) return
        state%lowest_force = here%force
        state%lowest_time = time
        state%lowest_depth = here%depth
        state%lowest_radius = here%radius
        state%lowest_speed = speed
    end subroutine note_force

    !> The lowest force within a step, at whose beginning the force falls and at whose end it rises: the step is made shorter until
    !> it ends there.
    pure subroutine note_lowest(state, equation, origin, t, h, y, slope)
        type(rate_state_t), intent(inout) :: state
        type(edge_equation_t), intent(in) :: equation
        !> time at t = 0 of the equation
        real(wp), intent(in) :: origin
        !> beginning and length of the step; coordinate and its rate at the beginning
        real(wp), intent(in) :: t, h, y, slope
        type(edge_t) :: here
        real(wp) :: low, high, part, reached(stages), slopes(stages), unused, s
        logical :: found
        integer :: i

        low = 0.0_wp
        high = h
        do i = 1, most_steps
            part = 0.5_wp*(low + high)
            call stiff_step(equation, t, part, y, slope, reached, slopes, unused, found)
            if (.not. found) return
            s = equation%start + equation%speed*(t + part)
            here = equation%contact%edge(equation%control, s, reached(stages))
            if (force_rate(equation, here, slopes(stages)) < 0.0_wp) then
                low = part
            else
                high = part
            end if
            if (high - low <= last_step*h) exit
        end do
        call note_force(state, here, origin + t + part, -slopes(stages)*exp(reached(stages)))
    end subroutine note_lowest

    !> dF/dt.
    pure function force_rate(equation, here, slope) result(rate)
        type(edge_equation_t), intent(in) :: equation
        type(edge_t), intent(in) :: here
        !> dx/dt
        real(wp), intent(in) :: slope
        real(wp) :: rate

        rate = here%force_by_x*slope + here%force_by_s*equation%speed
    end function force_rate

    !> The bodies separate; what is left of the elastic energy at the smallest radius is lost.
    pure subroutine break_edge(state, contact, here, x, time)
        type(rate_state_t), intent(inout) :: state
        type(rate_contact_t), intent(in) :: contact
        type(edge_t), intent(in) :: here
        real(wp), intent(in) :: x, time
        real(wp) :: p(4), dp(4)

        call contact%curve%parts(x, p, dp)
        ! the edge was drawn out from the state without adhesion, whose energy is far less
        state%dissipated = state%dissipated + (0.5_wp*p(3)*here%opening - p(2))*here%opening - contact%law%work*pi*here%radius**2
        state%radius = 0.0_wp
        state%rupture_time = time
        state%rupture_depth = here%depth
        state%ruptures = state%ruptures + 1.0_wp
    end subroutine break_edge

end module mdrcontact_adhesion_rate_state
