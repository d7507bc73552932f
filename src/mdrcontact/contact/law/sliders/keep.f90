! SPDX-License-Identifier: GPL-3.0-or-later
!> The memory of a contact after a step, and the energy that slip took in it.
module mdrcontact_law_sliders_keep
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    use mdrcontact_law_sliders_join, only: join_sliders
    use mdrcontact_law_sliders_motion, only: motion_t
    use mdrcontact_law_sliders_record, only: at_law, at_lost, at_next, at_shift, at_top, at_used, head
    use mdrcontact_law_sliders_shrink, only: shrink
    use mdrcontact_law_strengths, only: place_t
    implicit none (type, external)
    private
    public :: keep

contains

    !> The record after the step.
    pure subroutine keep(levels, place, motion, record)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        !> becomes that after the step
        type(motion_t), intent(inout) :: motion
        real(wp), intent(inout), contiguous :: record(:)

        record(at_lost) = record(at_lost) + motion%lost
        if (motion%grows > 0) then
            motion%top = [place%shift, place%force, max(place%stiffness, motion%top(3))]
            if (motion%used > levels%sliders) call join_sliders(levels, motion, record(at_lost))
        else
            call shrink(levels, place, motion)
        end if
        record(at_law) = levels%mark
        record(at_next) = motion%level(motion%used)
        record(at_used) = motion%used
        record(at_shift) = place%shift
        record(at_top:at_top + 2) = motion%top
        call keep_sliders(levels%sliders, motion, record(head + 1:))
    end subroutine keep

    !> Levels and t after the step.
    pure subroutine keep_sliders(sliders, motion, numbers)
        integer, intent(in) :: sliders
        type(motion_t), intent(in) :: motion
        real(wp), intent(inout) :: numbers(0:sliders - 1, 0:3)
        integer :: i

        do i = 1, motion%used - 1
            numbers(i, 0) = motion%level(i)
        end do
        do i = 0, motion%used - 1
            numbers(i, 1) = motion%borne(i, 1)
            numbers(i, 2) = motion%borne(i, 2)
            numbers(i, 3) = motion%borne(i, 3)
        end do
        do i = motion%used, motion%before - 1
            numbers(i, 1:) = 0.0_wp
        end do
    end subroutine keep_sliders

end module mdrcontact_law_sliders_keep
