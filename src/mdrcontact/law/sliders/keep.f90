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

    !> No slip takes more energy, and none where there is no stiffness.
    real(wp), parameter :: most_lost = 1.0e150_wp

contains

    !> The record after the step.
    pure subroutine keep(levels, place, motion, record)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        !> becomes that after the step
        type(motion_t), intent(inout) :: motion
        real(wp), intent(inout), contiguous :: record(:)

        if (place%shift > motion%top(1)) then
            motion%top = [place%shift, place%force, max(place%stiffness, motion%top(3))]
            call stiffen(levels, motion)
            call count_slip(motion, record(at_lost))
            if (motion%used > levels%sliders) call join_sliders(levels, motion, record(at_lost))
        else
            call count_slip(motion, record(at_lost))
            call shrink(levels, place, motion)
        end if
        record(at_law) = levels%mark
        record(at_next) = motion%level(motion%used)
        record(at_used) = motion%used
        record(at_shift) = place%shift
        record(at_top:at_top + 2) = motion%top
        call keep_sliders(levels%sliders, motion, record(head + 1:))
    end subroutine keep

    !> K of the sliders in which springs touched.
    pure subroutine stiffen(levels, motion)
        type(levels_t), intent(in) :: levels
        type(motion_t), intent(inout) :: motion
        real(wp) :: above, below
        integer :: i

        above = motion%top(3)
        do i = motion%used - 1, motion%first_newborn, -1
            below = 0.0_wp
            if (i > 0) below = min(levels%stiffness(motion%level(i)), above)
            motion%stiffness(i) = above - below
            above = below
        end do
    end subroutine stiffen

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
            do i = motion%first_slipping, motion%used - 1
                lost = lost + min(motion%slipped(i), most_lost*k(i))/max(k(i), tiny(1.0_wp))
            end do
            if (.not. motion%is_weaker) return
            do i = 0, motion%before - 1
                if (k(i) > 0.0_wp) lost = lost + max(sqrt(motion%former(i)) - strength(i), 0.0_wp)**2/(2.0_wp*k(i))
            end do
        end associate
    end subroutine count_slip

end module mdrcontact_law_sliders_keep
