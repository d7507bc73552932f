! SPDX-License-Identifier: GPL-3.0-or-later
!> One contact under Coulomb's law as a few vector sliders, each of them the springs between two material levels.
!>
!> A slider bears a vector t, has a stiffness K and a strength mu B, |t| <= mu B. A step to F, S with the shift ds brings
!>     y = t + K ds + A g,    t = y min(1, mu B/|y|),    T = sum of t,
!> A g what springs bear that touched in the step: g = ds/max(S - S_old, |ds|/mu). K of a slider never falls while it bears
!> anything, which is why no cycle of F and shift yields energy: T.ds is at least the growth of the sum of |t|^2/(2 K).
!>
!> A record remembers the sliders: 0, the core, with all springs below a level, and one between each two levels above, the last of
!> them open. As the contact grows past the last level the core takes in its neighbour; as it shrinks, the core is divided.
module mdrcontact_law_sliders_motion
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t, load_beyond, loads_beyond, most_levels, most_sliders
    use mdrcontact_law_sliders_record, only: at_base, at_shift, at_top, at_used, head
    implicit none (type, external)
    private
    public :: motion_t, move, most, slips

    !> A slider that came to its limit in the step before is within it, whatever rounding says: it sticks if the shift turns back.
    real(wp), parameter :: within = 1.0_wp + 16.0_wp*epsilon(1.0_wp), slips = 1.0_wp/within
    !> Numbers that a step knows of sliders and levels, at most.
    integer, parameter :: most = most_sliders + most_levels + 1

    !> A step: its sliders, those of levels passed in it included.
    type :: motion_t
        integer :: base, used, before
        !> the level below S, and the first slider with springs that touched in the step
        integer :: cell, first_newborn
        !> S, F and k at the upper end of the last slider before the step
        real(wp) :: top(3)
        !> ds, g, and whether springs touched without slip in the step
        real(wp) :: shift(3), growth(3)
        logical :: is_slow
        !> K, P of the springs from a slider on, mu B, A
        real(wp) :: stiffness(0:most), beyond(0:most), strength(0:most), newborn(0:most)
        !> y, 1/|y|, min(1, mu B/|y|), t = y times that, and t.(y - t)
        real(wp) :: load(0:most, 3), inverse(0:most), factor(0:most), borne(0:most, 3), slipped(0:most)
        !> |t|^2 before the step, and T after it
        real(wp) :: former(0:most), total(3)
        !> whether a slider bore more before the step than its strength is now, but for rounding
        logical :: is_weaker
    end type motion_t

contains

    !> A step to F > 0, of which S and dS/dF are known.
    pure subroutine move(levels, mu, sliders, force, shift, compliance, way, record, motion)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: mu
        integer, intent(in) :: sliders
        !> F, S and dS/dF at its end
        real(wp), intent(in) :: force, shift, compliance
        !> ds
        real(wp), intent(in) :: way(3)
        real(wp), intent(in), contiguous :: record(:)
        type(motion_t), intent(out) :: motion
        real(wp) :: size_of_way, before

        call begin(levels, shift, record, motion)
        call find_sliders(levels, force, shift, motion)
        motion%shift = way
        motion%growth = 0.0_wp
        motion%first_newborn = motion%used
        if (shift > motion%top(1)) then
            motion%first_newborn = motion%before - 1
            call find_newborn(levels, force, shift, compliance, motion)
            before = record(at_shift)
            ! of shifts whose squares are lost the largest component
            size_of_way = max(sqrt(way(1)**2 + way(2)**2 + way(3)**2), abs(way(1)), abs(way(2)), abs(way(3)))
            motion%is_slow = size_of_way <= mu*(shift - before)
            motion%growth = way/max(shift - before, size_of_way/mu)
        end if
        call load_sliders(sliders, record(head + 1:), motion)
        call find_strengths(mu, motion)
        call limit_sliders(motion)
    end subroutine move

    !> The sliders of a step: those of the record, and those of levels that are passed.
    pure subroutine begin(levels, shift, record, motion)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: shift
        real(wp), intent(in), contiguous :: record(:)
        type(motion_t), intent(inout) :: motion
        integer :: last

        motion%base = max(int(record(at_base)), 1)
        motion%before = max(int(record(at_used)), 1)
        motion%top = record(at_top:at_top + 2)
        if (record(at_base) < 1.0_wp) motion%top = [0.0_wp, 0.0_wp, levels%stiffness(0)]
        last = motion%base + motion%before - 1
        if (shift > motion%top(1)) then
            do while (levels%shift(last) < shift)
                last = last + 1
            end do
        end if
        motion%used = last - motion%base + 1
        motion%cell = last
        do while (motion%cell > 0)
            if (levels%shift(motion%cell) < shift) exit
            motion%cell = motion%cell - 1
        end do
    end subroutine begin

    !> K before the step, and P.
    pure subroutine find_sliders(levels, force, shift, motion)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: force, shift
        type(motion_t), intent(inout) :: motion
        real(wp) :: top
        integer :: i

        top = motion%top(3)
        associate (k => levels%stiffness, base => motion%base)
            do i = 0, motion%used - 1
                motion%stiffness(i) = min(k(base + i), top) - min(k(base + i - 1), top)
            end do
            motion%stiffness(0) = min(k(base), top)
        end associate
        call loads_beyond(levels, motion%base, motion%used, motion%cell, force, shift, motion%beyond(1:motion%used))
        motion%beyond(0) = force
        motion%beyond(motion%used) = 0.0_wp
    end subroutine find_sliders

    !> A: what springs that touched in the step bear for each unit of g.
    pure subroutine find_newborn(levels, force, shift, compliance, motion)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: force, shift, compliance
        type(motion_t), intent(inout) :: motion
        real(wp) :: above, load, slope
        integer :: i

        above = 0.0_wp
        do i = motion%used - 1, motion%before, -1
            call load_beyond(levels, motion%base + i - 1, force, shift, compliance, load, slope)
            motion%newborn(i) = load - above
            above = load
        end do
        load = (force - motion%top(2)) - motion%top(3)*(shift - motion%top(1))
        motion%newborn(motion%before - 1) = max(load - above, 0.0_wp)
    end subroutine find_newborn

    !> y.
    pure subroutine load_sliders(sliders, t, motion)
        integer, intent(in) :: sliders
        !> before the step
        real(wp), intent(in) :: t(sliders, 3)
        type(motion_t), intent(inout) :: motion
        integer :: i, axis

        associate (k => motion%stiffness, way => motion%shift)
            do i = 0, motion%before - 1
                motion%load(i, 1) = t(i + 1, 1) + k(i)*way(1)
                motion%load(i, 2) = t(i + 1, 2) + k(i)*way(2)
                motion%load(i, 3) = t(i + 1, 3) + k(i)*way(3)
                motion%former(i) = t(i + 1, 1)**2 + t(i + 1, 2)**2 + t(i + 1, 3)**2
            end do
        end associate
        do i = motion%first_newborn, motion%used - 1
            if (i >= motion%before) then
                motion%former(i) = 0.0_wp
                motion%load(i, :) = 0.0_wp
            end if
            do axis = 1, 3
                motion%load(i, axis) = motion%load(i, axis) + motion%newborn(i)*motion%growth(axis)
            end do
        end do
    end subroutine load_sliders

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

    !> t and their sum: what of y is within the strengths, without branches.
    pure subroutine limit_sliders(motion)
        type(motion_t), intent(inout) :: motion
        real(wp) :: squared, inverse, factor, excess, x, y, z
        integer :: i

        excess = 0.0_wp
        x = 0.0_wp
        y = 0.0_wp
        z = 0.0_wp
        !$omp simd simdlen(2) private(squared, inverse, factor) reduction(+:x, y, z) reduction(max:excess)
        do i = 0, motion%used - 1
            squared = motion%load(i, 1)**2 + motion%load(i, 2)**2 + motion%load(i, 3)**2
            inverse = 1.0_wp/max(sqrt(squared), tiny(1.0_wp))
            factor = min(motion%strength(i)*inverse, 1.0_wp)
            excess = max(excess, motion%former(i) - (within*motion%strength(i))**2)
            motion%inverse(i) = inverse
            motion%factor(i) = factor
            motion%slipped(i) = (factor*(1.0_wp - factor))*squared
            motion%borne(i, 1) = factor*motion%load(i, 1)
            motion%borne(i, 2) = factor*motion%load(i, 2)
            motion%borne(i, 3) = factor*motion%load(i, 3)
            x = x + motion%borne(i, 1)
            y = y + motion%borne(i, 2)
            z = z + motion%borne(i, 3)
        end do
        motion%total = [x, y, z]
        motion%is_weaker = excess > 0.0_wp
    end subroutine limit_sliders

end module mdrcontact_law_sliders_motion
