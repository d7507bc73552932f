! SPDX-License-Identifier: GPL-3.0-or-later
!> One contact under Coulomb's law, or at constant shear strength, as a few vector sliders, each of them the springs between two
!> material levels.
!>
!> A slider bears a vector t, has a stiffness K and a strength mu B, |t| <= mu B. A step to F, S with the shift ds brings
!>     y = t + K ds + A g,    t = y min(1, mu B/|y|),    T = sum of t,
!> A g what springs bear that touched in the step: g = ds/max(S - S_old, |ds|/mu). K of a slider never falls while it bears
!> anything, which is why no cycle of F and shift yields energy: T.ds is at least the growth of the sum of |t|^2/(2 K).
!>
!> A record holds the sliders: 0, the core, with all springs below a level, and one between each two of its levels above, the
!> last of them open.
module mdrcontact_law_sliders_motion
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    use mdrcontact_law_sliders_record, only: at_next, at_shift, at_top, at_used, head
    use mdrcontact_law_strengths, only: growth_beyond, loads_beyond, most, place_t
    implicit none (type, external)
    private
    public :: motion_t, move, slips

    !> A slider that came to its limit in the step before is within it, whatever rounding says: it sticks if the shift turns back.
    real(wp), parameter :: within = 1.0_wp + 16.0_wp*epsilon(1.0_wp), slips = 1.0_wp/within

    !> A step: its sliders, those of levels passed in it included.
    type :: motion_t
        !> sliders, those of the record among them, and the first one with springs that touched in the step
        integer :: used, before, first_newborn
        !> the level below S, where there are shares
        integer :: cell
        !> S, F and k at the upper end of the last slider, before the step
        real(wp) :: top(3)
        !> ds, g, and T after the step
        real(wp) :: shift(3), growth(3), total(3)
        !> whether springs touched without slip, and whether a slider bore more before the step than its strength is now, but for
        !> rounding
        logical :: is_slow, is_weaker
        !> sliders before this one stick
        integer :: first_slipping
        !> the levels at the lower ends of sliders 1 to used - 1, and at `used` the next one above them
        integer :: level(0:most)
        !> K, P of the springs from a slider on, mu B, A
        real(wp), dimension(0:most) :: stiffness, beyond, strength, newborn
        !> y, |y|^2, min(1, mu B/|y|), t = y times that, and |t|^2 before the step
        real(wp) :: load(0:most, 3), squared(0:most), factor(0:most), borne(0:most, 3), former(0:most)
        !> of sliders that may slip: 1/|y|, and t.(y - t)
        real(wp), dimension(0:most) :: inverse, slipped
    end type motion_t

contains

    !> A step to a place where F > 0.
    pure subroutine move(levels, place, way, record, motion)
        type(levels_t), intent(in) :: levels
        !> at its end
        type(place_t), intent(in) :: place
        !> ds
        real(wp), intent(in) :: way(3)
        real(wp), intent(in), contiguous :: record(:)
        type(motion_t), intent(out) :: motion

        call begin(levels, place%shift, record, motion)
        call find_stiffnesses(levels, motion)
        call loads_beyond(levels, motion%used - 1, motion%level(1:), motion%cell, place, motion%beyond(1:))
        motion%beyond(0) = place%load
        motion%beyond(motion%used) = 0.0_wp
        motion%shift = way
        motion%first_newborn = motion%used
        call load_sliders(levels%sliders, record(head + 1 + levels%sliders:), motion)
        if (place%shift > motion%top(1)) then
            call find_newborn(levels, place, record(at_shift), motion)
            call load_newborn(motion)
        end if
        call find_strengths(levels%strength, motion)
        call limit_sliders(motion)
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
        motion%top = record(at_top:at_top + 2)
        if (record(at_next) < 1.0_wp) motion%top = [0.0_wp, 0.0_wp, levels%stiffness(0)]
        motion%used = motion%before
        if (shift > motion%top(1)) then
            do while (levels%shift(next) < shift)
                motion%level(motion%used) = next
                motion%used = motion%used + 1
                next = next + 1
            end do
        end if
        motion%level(motion%used) = next
        motion%cell = next
        if (.not. allocated(levels%share)) return
        do while (motion%cell > 0)
            if (levels%shift(motion%cell) < shift) exit
            motion%cell = motion%cell - 1
        end do
    end subroutine begin

    !> K before the step.
    pure subroutine find_stiffnesses(levels, motion)
        type(levels_t), intent(in) :: levels
        type(motion_t), intent(inout) :: motion
        real(wp) :: below, above
        integer :: i

        below = 0.0_wp
        do i = 0, motion%before - 2
            above = min(levels%stiffness(motion%level(i + 1)), motion%top(3))
            motion%stiffness(i) = above - below
            below = above
        end do
        motion%stiffness(motion%before - 1) = motion%top(3) - below
    end subroutine find_stiffnesses

    !> y without springs that touch in the step.
    pure subroutine load_sliders(sliders, t, motion)
        integer, intent(in) :: sliders
        !> before the step
        real(wp), intent(in) :: t(0:sliders - 1, 3)
        type(motion_t), intent(inout) :: motion
        integer :: i

        associate (k => motion%stiffness, way => motion%shift)
            !$omp simd simdlen(2)
            do i = 0, motion%before - 1
                motion%load(i, 1) = t(i, 1) + k(i)*way(1)
                motion%load(i, 2) = t(i, 2) + k(i)*way(2)
                motion%load(i, 3) = t(i, 3) + k(i)*way(3)
                motion%former(i) = t(i, 1)**2 + t(i, 2)**2 + t(i, 3)**2
                motion%squared(i) = motion%load(i, 1)**2 + motion%load(i, 2)**2 + motion%load(i, 3)**2
            end do
        end associate
    end subroutine load_sliders

    !> What springs that touched in the step bear beside.
    pure subroutine load_newborn(motion)
        type(motion_t), intent(inout) :: motion
        integer :: i, axis

        do i = motion%before, motion%used - 1
            motion%stiffness(i) = 0.0_wp
            motion%former(i) = 0.0_wp
            motion%load(i, :) = 0.0_wp
        end do
        do i = motion%first_newborn, motion%used - 1
            do axis = 1, 3
                motion%load(i, axis) = motion%load(i, axis) + motion%newborn(i)*motion%growth(axis)
            end do
            motion%squared(i) = motion%load(i, 1)**2 + motion%load(i, 2)**2 + motion%load(i, 3)**2
        end do
    end subroutine load_newborn

    !> t and their sum: what of y is within the strengths. Roots and quotients are taken from the first slider on that slips.
    pure subroutine limit_sliders(motion)
        type(motion_t), intent(inout) :: motion
        real(wp) :: excess, inverse, factor, x, y, z
        integer :: i, first

        excess = 0.0_wp
        !$omp simd simdlen(2) reduction(max:excess)
        do i = 0, motion%used - 1
            excess = max(excess, motion%former(i) - (within*motion%strength(i))**2)
        end do
        motion%is_weaker = excess > 0.0_wp
        x = 0.0_wp
        y = 0.0_wp
        z = 0.0_wp
        do first = 0, motion%used - 1
            if (motion%squared(first) > motion%strength(first)**2) exit
        end do
        !$omp simd simdlen(2) reduction(+:x, y, z)
        do i = 0, first - 1
            motion%factor(i) = 1.0_wp
            motion%borne(i, 1) = motion%load(i, 1)
            motion%borne(i, 2) = motion%load(i, 2)
            motion%borne(i, 3) = motion%load(i, 3)
            x = x + motion%load(i, 1)
            y = y + motion%load(i, 2)
            z = z + motion%load(i, 3)
        end do
        motion%first_slipping = first
        !$omp simd simdlen(2) private(inverse, factor) reduction(+:x, y, z)
        do i = first, motion%used - 1
            inverse = 1.0_wp/max(sqrt(motion%squared(i)), tiny(1.0_wp))
            factor = min(motion%strength(i)*inverse, 1.0_wp)
            motion%inverse(i) = inverse
            motion%factor(i) = factor
            motion%slipped(i) = (factor*(1.0_wp - factor))*motion%squared(i)
            motion%borne(i, 1) = factor*motion%load(i, 1)
            motion%borne(i, 2) = factor*motion%load(i, 2)
            motion%borne(i, 3) = factor*motion%load(i, 3)
            x = x + motion%borne(i, 1)
            y = y + motion%borne(i, 2)
            z = z + motion%borne(i, 3)
        end do
        motion%total = [x, y, z]
    end subroutine limit_sliders

    !> g. Springs that touch at constant shear strength bear at once what they are sheared by.
    pure subroutine find_growth(levels, growth, motion)
        type(levels_t), intent(in) :: levels
        !> of S in the step
        real(wp), intent(in) :: growth
        type(motion_t), intent(inout) :: motion
        real(wp) :: length

        motion%is_slow = levels%is_constant
        length = 0.0_wp
        if (.not. levels%is_constant) then
            associate (way => motion%shift)
                ! of shifts whose squares are lost the largest component
                length = max(sqrt(way(1)**2 + way(2)**2 + way(3)**2), abs(way(1)), abs(way(2)), abs(way(3)))
            end associate
            motion%is_slow = length <= levels%strength*growth
        end if
        motion%growth = motion%shift/merge(growth, max(growth, length/levels%strength), motion%is_slow)
    end subroutine find_growth

    !> g and A: what springs that touched in the step bear for each unit of it.
    pure subroutine find_newborn(levels, place, before, motion)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        !> S before the step
        real(wp), intent(in) :: before
        type(motion_t), intent(inout) :: motion
        real(wp) :: above, load, slope
        integer :: i

        call find_growth(levels, place%shift - before, motion)
        motion%first_newborn = motion%before - 1
        above = 0.0_wp
        do i = motion%used - 1, motion%before, -1
            associate (l => motion%level(i))
                call growth_beyond(levels, [levels%shift(l), levels%force(l), levels%stiffness(l)], place, load, slope)
            end associate
            motion%newborn(i) = load - above
            above = load
        end do
        call growth_beyond(levels, motion%top, place, load, slope)
        motion%newborn(motion%before - 1) = max(load - above, 0.0_wp)
    end subroutine find_newborn

    !> mu B. Later than P, which a processor reads across what it has just written only after a while.
    pure subroutine find_strengths(mu, motion)
        real(wp), intent(in) :: mu
        type(motion_t), intent(inout) :: motion
        real(wp) :: drop
        integer :: i

        drop = 0.0_wp
        do i = 0, motion%used - 1
            motion%strength(i) = mu*max(motion%beyond(i) - motion%beyond(i + 1), 0.0_wp)
            drop = min(drop, motion%beyond(i) - motion%beyond(i + 1))
        end do
        if (drop < 0.0_wp) call settle(mu, motion)
    end subroutine find_strengths

    !> What is left of no springs at a flat end is rounding, and shares have errors of their own: T <= mu F does not.
    pure subroutine settle(mu, motion)
        real(wp), intent(in) :: mu
        type(motion_t), intent(inout) :: motion
        integer :: i

        do i = motion%used - 1, 1, -1
            motion%beyond(i) = min(max(motion%beyond(i), motion%beyond(i + 1)), motion%beyond(0))
        end do
        do i = 0, motion%used - 1
            motion%strength(i) = mu*max(motion%beyond(i) - motion%beyond(i + 1), 0.0_wp)
        end do
    end subroutine settle

end module mdrcontact_law_sliders_motion
