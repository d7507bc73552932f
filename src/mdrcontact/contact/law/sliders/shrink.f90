! SPDX-License-Identifier: GPL-3.0-or-later
!> Sliders of a contact that shrinks: those that it leaves are forgotten, and others are divided while there is room.
!>
!> A slider is divided with equal displacements, if each part is within its strength: T and the stored energy stay. One place is
!> left free, for the level that is passed next if F only swings.
module mdrcontact_law_sliders_shrink
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: by_shear, by_twist, levels_t
    use mdrcontact_law_sliders_motion, only: copy_slider, motion_t
    use mdrcontact_law_strengths, only: load_beyond, place_t
    implicit none (type, external)
    private
    public :: shrink

    !> A slider that lacks more than this times what those of the best places do is divided before the core is.
    real(wp), parameter :: enough = 1.6_wp

contains

    !> The sliders after a step in which the contact has not grown beyond the last of them.
    pure subroutine shrink(levels, place, motion)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        type(motion_t), intent(inout) :: motion
        integer :: i, level
        logical :: divided

        do while (motion%used > 1)
            associate (l => motion%level(motion%used - 1))
                if (place%shift > levels%shift(l)) exit
                motion%top = [levels%shift(l), levels%force(l), levels%stiffness(l)]
            end associate
            motion%used = motion%used - 1
        end do
        do while (motion%used < levels%sliders - 1)
            call choose(levels, motion, i, level)
            if (i < 0) exit
            call divide(levels, place, i, level, motion, divided)
            if (.not. divided) exit
        end do
    end subroutine shrink

    !> The slider to be divided, -1 if it does not exist, and at which level: among those that stick the one that lacks most; else
    !> the core.
    pure subroutine choose(levels, motion, place, level)
        type(levels_t), intent(in) :: levels
        type(motion_t), intent(in) :: motion
        integer, intent(out) :: place, level
        real(wp) :: typical, worst, found
        integer :: i, width

        associate (p => levels%places, n => levels%sliders - 1)
            if (levels%of_radius) then
                typical = lack(levels, p(n/2 + 1) - p(n/2), p(n/2 + 1))
            else
                typical = 4.0_wp*p(n)/real(n, wp)**2
            end if
        end associate
        worst = enough*typical
        place = -1
        associate (l => motion%level, last => motion%used)
            do i = 1, last - 1
                width = l(i + 1) - l(i)
                found = lack(levels, width, max(l(last) - l(i) - 1, 1))
                if (width < 2 .or. .not. found > worst .or. motion%factor(i) < 1.0_wp) cycle
                worst = found
                place = i
                level = l(i) + (width + 1)/2
            end do
            if (place > 0) return
            level = l(1) - max(1, nint(sqrt(typical/lack(levels, 1, max(l(last) - l(1), 1)))))
            if (level > 0 .and. motion%factor(0) >= 1.0_wp) place = 0
        end associate
    end subroutine choose

    !> Deficit of a slider of a given width and distance from the edge, both in levels: of first shear that of the square of
    !> its width times the second derivative of T, and relative to its shift under Coulomb's law; of a twist c^3 in first order.
    pure function lack(levels, width, distance) result(lacking)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: width, distance
        real(wp) :: lacking

        lacking = real(width, wp)**2
        select case (levels%power)
        case (by_twist)
            lacking = lacking*(levels%shift(1)/levels%shift(2))**(3*distance)
        case (by_shear)
            lacking = lacking/sqrt(real(distance, wp))
        case default
            lacking = lacking/distance
        end select
    end function lack

    !> Slider i in two at a level.
    pure subroutine divide(levels, place, i, level, motion, divided)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        integer, intent(in) :: i, level
        type(motion_t), intent(inout) :: motion
        logical, intent(out) :: divided
        real(wp) :: upper, load, strengths(2), parts(2)
        integer :: j

        divided = .false.
        if (.not. motion%stiffness(i) > 0.0_wp) return
        upper = motion%top(3)
        if (i < motion%used - 1) upper = min(levels%stiffness(motion%level(i + 1)), upper)
        parts(2) = min(max((upper - levels%stiffness(level))/motion%stiffness(i), 0.0_wp), 1.0_wp)
        parts(1) = 1.0_wp - parts(2)
        load = load_beyond(levels, level, motion%cell, place)
        strengths = levels%strength*[motion%beyond(i) - load, load - motion%beyond(i + 1)]
        divided = all(parts*norm2(motion%borne(i, :)) <= strengths) .and. all(parts > 0.0_wp)
        if (.not. divided) return
        do j = motion%used, i + 1, -1
            call copy_slider(motion, j, j + 1)
        end do
        motion%used = motion%used + 1
        call copy_slider(motion, i, i + 1)
        motion%level(i + 1) = level
        motion%beyond(i + 1) = load
        motion%strength(i:i + 1) = strengths
        motion%stiffness(i + 1) = parts(2)*motion%stiffness(i)
        motion%borne(i + 1, :) = parts(2)*motion%borne(i, :)
        motion%stiffness(i) = motion%stiffness(i) - motion%stiffness(i + 1)
        motion%borne(i, :) = motion%borne(i, :) - motion%borne(i + 1, :)
    end subroutine divide

end module mdrcontact_law_sliders_shrink
