! SPDX-License-Identifier: GPL-3.0-or-later
!> What sliders are after a step: which of them become one, and what is lost.
module mdrcontact_law_sliders_keep
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    use mdrcontact_law_sliders_motion, only: motion_t
    use mdrcontact_law_sliders_record, only: at_base, at_law, at_lost, at_shift, at_top, at_used, head, stiffness_of
    use mdrcontact_law_sliders_shrink, only: shrink
    implicit none (type, external)
    private
    public :: keep

    !> No slip takes more energy, and none where there is no stiffness.
    real(wp), parameter :: most_lost = 1.0e150_wp

contains

    !> The record after the step.
    pure subroutine keep(levels, mu, sliders, force, shift, compliance, motion, mark, record)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: mu
        integer, intent(in) :: sliders
        real(wp), intent(in) :: force, shift, compliance
        !> K becomes that after the step
        type(motion_t), intent(inout) :: motion
        real(wp), intent(in) :: mark
        real(wp), intent(inout), contiguous :: record(:)
        real(wp) :: top
        integer :: i, merged

        merged = max(motion%used - sliders, 0)
        top = motion%top(3)
        if (shift > motion%top(1)) top = max(1.0_wp/compliance, top)
        do i = motion%first_newborn, motion%used - 1
            motion%stiffness(i) = stiffness_of(levels, motion%base, i, top)
        end do
        call count_slip(motion, record(at_lost))
        if (merged > 0) call count_merger(merged, motion, record(at_lost))
        call keep_loads(sliders, merged, motion, record(head + 1:))
        record(at_law) = mark
        record(at_base) = motion%base + merged
        record(at_used) = motion%used - merged
        record(at_shift) = shift
        if (shift > motion%top(1)) then
            record(at_top:at_top + 2) = [shift, force, top]
        else
            call shrink(levels, mu, sliders, force, shift, compliance, motion%cell, record)
        end if
    end subroutine keep

    !> t after the step, those of the sliders that the core takes in added to its own.
    pure subroutine keep_loads(sliders, merged, motion, t)
        integer, intent(in) :: sliders, merged
        type(motion_t), intent(in) :: motion
        real(wp), intent(inout) :: t(sliders, 3)
        integer :: i

        do i = merged, motion%used - 1
            t(i + 1 - merged, 1) = motion%borne(i, 1)
            t(i + 1 - merged, 2) = motion%borne(i, 2)
            t(i + 1 - merged, 3) = motion%borne(i, 3)
        end do
        do i = merged - 1, 0, -1
            t(1, :) = t(1, :) + motion%borne(i, :)
        end do
    end subroutine keep_loads

    !> What slip takes in a step: t.(y - t)/K of each slider, and what its load was above its limit before it moved. Along a line
    !> under constant F that is exact, however long the step.
    pure subroutine count_slip(motion, lost)
        !> with K after the step
        type(motion_t), intent(in) :: motion
        !> to which it is added
        real(wp), intent(inout) :: lost
        integer :: i

        associate (k => motion%stiffness, strength => motion%strength)
            !$omp simd simdlen(2) reduction(+:lost)
            do i = 0, motion%used - 1
                lost = lost + min(motion%slipped(i), most_lost*k(i))/max(k(i), tiny(1.0_wp))
            end do
            if (.not. motion%is_weaker) return
            do i = 0, motion%before - 1
                if (k(i) > 0.0_wp) lost = lost + max(sqrt(motion%former(i)) - strength(i), 0.0_wp)**2/(2.0_wp*k(i))
            end do
        end associate
    end subroutine count_slip

    !> What is lost as the core takes in its neighbours, whose displacements are not its own.
    pure subroutine count_merger(merged, motion, lost)
        integer, intent(in) :: merged
        !> with K after the step
        type(motion_t), intent(in) :: motion
        real(wp), intent(inout) :: lost
        real(wp) :: core(3), slider(3), stiffness, own
        integer :: i

        core = motion%borne(0, :)
        stiffness = motion%stiffness(0)
        do i = 1, merged
            slider = motion%borne(i, :)
            own = motion%stiffness(i)
            if (own > 0.0_wp .and. stiffness > 0.0_wp) then
                lost = lost + sum((own*core - stiffness*slider)**2)/(2.0_wp*own*stiffness*(own + stiffness))
            end if
            core = core + slider
            stiffness = stiffness + own
        end do
    end subroutine count_merger

end module mdrcontact_law_sliders_keep
