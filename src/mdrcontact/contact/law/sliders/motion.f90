! SPDX-License-Identifier: GPL-3.0-or-later
!> One contact under Coulomb's law, at constant shear strength, or twisted, as a few vector sliders, each of them the springs
!> between two material levels (theory/friction.md (7.5)-(7.8)).
!>
!> A slider transmits a vector t, has a stiffness K and a strength mu B, |t| <= mu B. A step to F, S with the shift ds brings
!>     y = t + K ds + A g,    t = y min(1, mu B/|y|),    T = sum of t,
!> A g what springs bear that touched in the step: g = ds/max(S - S_old, |ds|/mu). K of a slider never falls while it is loaded
!> anything, which is why no cycle of F and shift yields energy: T.ds is at least the growth of the sum of |t|^2/(2 K).
!>
!> K and P are differences between neighbours, all is done for two or four sliders at a time: step.c.
!>
!> A record holds the sliders: 0, the core, with all springs below a level, and one between each two of its levels above, the
!> last of them open.
module mdrcontact_law_sliders_motion
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: by_shear, levels_t, most_levels, most_sliders
    use mdrcontact_law_sliders_record, only: at_next, at_shift, at_top, at_used, head
    use mdrcontact_law_strengths, only: growth_beyond, place_t, radius_loads
    implicit none (type, external)
    private
    public :: copy_slider, motion_t, move, mdrcontact_sliders_sound, mdrcontact_sliders_steps

    !> The last of as many sliders as a step may meet, a multiple of four.
    integer, parameter :: most = most_sliders + most_levels + 3

    !> Sliders of a step, including those of the levels that it passes.
    type, bind(C) :: motion_t
        !> sliders, those of the record among them; the level below S, where there are shares, and where these begin
        integer(c_int32_t) :: used, before, cell, first_share
        !> whether S is the contact radius, and P that of it; whether springs respond immediately to the shear; whether S passes the
        !> upper end of the last slider, and whether P is settled
        integer(c_int32_t) :: of_radius, at_once, grows, is_settled
        !> S, F and k at the upper end of the last slider before the step, and S before it
        real(c_double) :: top(3), old
        !> ds, T after the step, and the energy that slip takes in it
        real(c_double) :: shift(3), total(3), lost
        !> the levels at the lower ends of sliders 1 to used - 1, and at `used` the next one above them
        integer(c_int32_t) :: level(0:most)
        !> K after the step, P of the springs from a slider on, mu B, min(1, mu B/|y|)
        real(c_double), dimension(0:most) :: stiffness, beyond, strength, factor
        !> t after the step
        real(c_double) :: borne(0:most, 3)
        !> where S is the contact radius the derivative of P, what springs that touch carry from a slider on, and its derivative
        real(c_double), dimension(0:most) :: slope, newborn, newborn_slope
    end type motion_t

    interface
        !> T, t and what else motion_t has, of levels 0 to count, their rows and shares those of levels_t; the
        !> derivatives of T with respect to ds, (1:3, i), and F (or the contact radius, where that is given), (4, i), of its
        !> component i.
        ! allow(assumed-size)
        pure subroutine mdrcontact_sliders_step(row, share, count, sliders, strength, place, t, motion, tangent) bind(C)
            import :: c_double, c_int32_t, motion_t, place_t
            real(c_double), intent(in) :: row(*)
            real(c_double), intent(in), optional :: share(*)
            integer(c_int32_t), value :: count, sliders
            real(c_double), value :: strength
            type(place_t), intent(in) :: place
            !> before the step, x, y and z of all sliders
            real(c_double), intent(in) :: t(*)
            type(motion_t), intent(inout) :: motion
            real(c_double), intent(inout), optional :: tangent(*)
        end subroutine mdrcontact_sliders_step

        !> Steps of n contacts under Coulomb's law up to the first whose record gets other sliders; how many these are. Arguments
        !> are those of contact_steps_t, with S and dS/dF at the end of each step, and the force that counts as 0.
        ! allow(assumed-size)
        function mdrcontact_sliders_steps(row, share, count, sliders, strength, nothing, n, is_trial, force, level, compliance, &
                                          shift, memory, traction, tangent) result(done) bind(C)
            import :: c_double, c_int32_t
            real(c_double), intent(in) :: row(*)
            real(c_double), intent(in), optional :: share(*)
            integer(c_int32_t), value :: count, sliders, n, is_trial
            real(c_double), value :: strength, nothing
            real(c_double), intent(in) :: force(*), level(*), compliance(*), shift(*)
            real(c_double), intent(inout) :: memory(*), traction(*)
            real(c_double), intent(inout), optional :: tangent(*)
            integer(c_int32_t) :: done
        end function mdrcontact_sliders_steps

        !> Number of the n contacts, from the first one on, whose steps are certainly valid, with F up to the highest.
        ! allow(assumed-size)
        function mdrcontact_sliders_sound(row, count, sliders, mark, highest, n, force, shift, memory) result(valid) bind(C)
            import :: c_double, c_int32_t
            real(c_double), intent(in) :: row(*)
            integer(c_int32_t), value :: count, sliders, n
            real(c_double), value :: mark, highest
            real(c_double), intent(in) :: force(*), shift(*), memory(*)
            integer(c_int32_t) :: valid
        end function mdrcontact_sliders_sound
    end interface

contains

    !> A step to a place where F > 0.
    pure subroutine move(levels, place, way, record, motion, tangent)
        type(levels_t), intent(in) :: levels
        !> at its end
        type(place_t), intent(in) :: place
        !> ds
        real(wp), intent(in) :: way(3)
        real(wp), intent(in), contiguous :: record(:)
        type(motion_t), intent(out) :: motion
        !> dT_i/ds_j, (j, i), and dT_i/dF or dT_i/da, (4, i)
        real(wp), intent(inout), optional :: tangent(4, 3)

        motion%shift = way
        call begin(levels, place%shift, record, motion)
        if (levels%of_radius) call find_loads(levels, place, motion)
        call mdrcontact_sliders_step(levels%row, levels%share, levels%count, levels%sliders, levels%strength, place, &
                                     record(head + 1 + levels%sliders:), motion, tangent)
        ! the open end of the last slider
        motion%beyond(motion%used) = 0.0_wp
    end subroutine move

    !> The sliders of a step: those of the record, and those of levels that are passed.
    pure subroutine begin(levels, shift, record, motion)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: shift
        real(wp), intent(in), contiguous :: record(:)
        type(motion_t), intent(inout) :: motion
        integer :: i, next

        motion%before = max(int(record(at_used)), 1)
        do i = 0, motion%before - 1
            motion%level(i) = int(record(head + 1 + i))
        end do
        next = max(int(record(at_next)), 1)
        motion%old = record(at_shift)
        motion%top = record(at_top:at_top + 2)
        if (record(at_next) < 1.0_wp) motion%top = [0.0_wp, 0.0_wp, levels%first_stiffness]
        motion%grows = merge(1, 0, shift > motion%top(1))
        motion%of_radius = merge(1, 0, levels%of_radius)
        motion%at_once = merge(1, 0, levels%power == by_shear)
        motion%is_settled = 0
        motion%used = motion%before
        if (motion%grows > 0) then
            do while (levels%shift(next) < shift)
                motion%level(motion%used) = next
                motion%used = motion%used + 1
                next = next + 1
            end do
        end if
        motion%level(motion%used) = next
        motion%cell = next
    end subroutine begin

    !> P and what springs that touch carry where S is the contact radius.
    pure subroutine find_loads(levels, place, motion)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        type(motion_t), intent(inout) :: motion
        real(wp) :: from(3)
        integer :: i, last

        last = (motion%used/4 + 1)*4 - 1
        motion%beyond(motion%used:last) = 0.0_wp
        motion%slope(motion%used:last) = 0.0_wp
        motion%newborn(motion%used:last) = 0.0_wp
        motion%newborn_slope(motion%used:last) = 0.0_wp
        motion%beyond(0) = place%load
        motion%slope(0) = (levels%power + 1)*place%load/place%shift
        associate (n => motion%used - 1)
            call radius_loads(levels, n, motion%level(1:n), place, motion%beyond(1:n), motion%slope(1:n))
        end associate
        motion%slope(:motion%used - 1) = place%rate*motion%slope(:motion%used - 1)
        do i = 0, motion%used - 1
            from = motion%top
            associate (l => motion%level(i))
                if (levels%shift(l) > motion%top(1)) from = [levels%shift(l), levels%force(l), levels%stiffness(l)]
            end associate
            call growth_beyond(levels, from, place, motion%newborn(i), motion%newborn_slope(i))
        end do
    end subroutine find_loads

    !> Puts one slider instead of another.
    pure subroutine copy_slider(motion, from, to)
        type(motion_t), intent(inout) :: motion
        integer, intent(in) :: from, to

        motion%level(to) = motion%level(from)
        motion%beyond(to) = motion%beyond(from)
        motion%strength(to) = motion%strength(from)
        motion%stiffness(to) = motion%stiffness(from)
        motion%borne(to, :) = motion%borne(from, :)
        motion%factor(to) = motion%factor(from)
    end subroutine copy_slider

end module mdrcontact_law_sliders_motion
