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
module mdrcontact_law_sliders
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t, load_beyond, loads_beyond, most_levels, most_sliders, share_of, slopes_beyond
    implicit none (type, external)
    private
    public :: motion_t, record_size, is_record, move, tangent_of, keep, part, stored_energy, turn_record
    public :: at_shift, at_lost

    !> Places in a record: the mark of its law, 0 before the first step; number of the level below which all is the core, 0 where
    !> the bodies are apart, and of sliders; S; S, F and k at the upper end of the last slider; energy dissipated so far;
    !> normal of the tangent plane, 0 while it is not known; x, y and z of the sliders' t follow.
    integer, parameter :: at_law = 1, at_base = 2, at_used = 3, at_shift = 4, at_top = 5, at_lost = 8, at_normal = 9, head = 11
    !> A slider that came to its limit in the step before is within it, whatever rounding says: it sticks if the shift turns back.
    real(wp), parameter :: within = 1.0_wp + 16.0_wp*epsilon(1.0_wp), slips = 1.0_wp/within
    !> No slip takes more energy, and none where there is no stiffness.
    real(wp), parameter :: most_lost = 1.0e150_wp
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

    !> How many numbers a record of a law with so many sliders has.
    pure function record_size(sliders) result(count)
        integer, intent(in) :: sliders
        integer :: count

        count = head + 3*sliders
    end function record_size

    !> Whether numbers, none of them NaN or infinite, are a record of a law with these levels.
    pure function is_record(levels, sliders, mark, record) result(sound)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: sliders
        real(wp), intent(in) :: mark
        real(wp), intent(in), contiguous :: record(:)
        logical :: sound
        real(wp) :: last

        last = record(at_base) + record(at_used) - 1.0_wp
        sound = record(at_law) == mark .and. record(at_base) >= 1.0_wp .and. record(at_used) >= 1.0_wp .and. &
                record(at_used) <= sliders .and. last <= levels%count + 1.0_wp .and. aint(last) == last .and. &
                aint(record(at_used)) == record(at_used)
        if (sound) sound = record(at_shift) >= 0.0_wp .and. record(at_top) >= record(at_shift) .and. record(at_top + 2) >= 0.0_wp
        if (.not. sound) sound = all(record(at_base:at_top + 2) == 0.0_wp) .and. all(record(head + 1:) == 0.0_wp) .and. &
                                 (record(at_law) == mark .or. all(record == 0.0_wp))
    end function is_record

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

    !> P_l and its derivative with respect to F.
    pure subroutine strength_beyond(levels, l, cell, force, shift, compliance, load, slope)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: l, cell
        real(wp), intent(in) :: force, shift, compliance
        real(wp), intent(out) :: load, slope
        real(wp) :: share, share_slope

        call load_beyond(levels, l, force, shift, compliance, load, slope)
        if (.not. allocated(levels%share) .or. cell < l) return
        call share_of(levels, l, cell, shift, share, share_slope)
        slope = share*slope + share_slope*compliance*load
        load = share*load
        if (load <= force) return
        load = force
        slope = 1.0_wp
    end subroutine strength_beyond

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

    !> The derivatives of T with respect to ds, (1:3, i), and F, (4, i), of its component i.
    pure subroutine tangent_of(levels, mu, force, shift, compliance, before, motion, tangent)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: mu, force, shift, compliance
        !> S before the step
        real(wp), intent(in) :: before
        type(motion_t), intent(in) :: motion
        real(wp), intent(out) :: tangent(4, 3)
        real(wp) :: slopes(0:most)

        slopes(0) = 1.0_wp
        call slopes_beyond(levels, motion%base, motion%used, motion%cell, force, shift, compliance, slopes(1:motion%used))
        slopes(motion%used) = 0.0_wp
        call old_tangent(mu, slopes, motion, tangent)
        if (motion%first_newborn == motion%used) return
        call add_newborn(levels, mu, force, shift, compliance, before, slopes, motion, tangent)
    end subroutine tangent_of

    !> What sliders bring in which no spring touched.
    pure subroutine old_tangent(mu, slopes, motion, tangent)
        real(wp), intent(in) :: mu
        type(motion_t), intent(in) :: motion
        !> dP/dF of the springs from a slider on
        real(wp), intent(in) :: slopes(0:most)
        real(wp), intent(out) :: tangent(4, 3)
        real(wp), dimension(0:most) :: along, turning, sliding
        real(wp) :: slides
        integer :: i

        ! K min(1, mu B/|y|), the same of those that slip, and their mu dB/dF, without branches
        do i = 0, motion%first_newborn - 1
            slides = merge(1.0_wp, 0.0_wp, motion%strength(i)*motion%inverse(i) < slips)
            along(i) = motion%factor(i)*motion%stiffness(i)
            turning(i) = slides*along(i)
            sliding(i) = (slides*mu)*(slopes(i) - slopes(i + 1))
        end do
        call sum_up(motion%first_newborn, along, turning, sliding, motion%inverse, motion%load, tangent)
    end subroutine old_tangent

    !> The sums of along I - turning n n^T, and of sliding n, n = y/|y|.
    pure subroutine sum_up(count, along, turning, sliding, inverse, load, tangent)
        integer, intent(in) :: count
        real(wp), intent(in), dimension(0:most) :: along, turning, sliding, inverse
        real(wp), intent(in) :: load(0:most, 3)
        real(wp), intent(out) :: tangent(4, 3)
        real(wp) :: all, xx, xy, xz, yy, yz, zz, fx, fy, fz, n1, n2, n3
        integer :: i

        all = 0.0_wp
        xx = 0.0_wp
        xy = 0.0_wp
        xz = 0.0_wp
        yy = 0.0_wp
        yz = 0.0_wp
        zz = 0.0_wp
        fx = 0.0_wp
        fy = 0.0_wp
        fz = 0.0_wp
        !$omp simd simdlen(2) private(n1, n2, n3) reduction(+:all, xx, xy, xz, yy, yz, zz, fx, fy, fz)
        do i = 0, count - 1
            n1 = inverse(i)*load(i, 1)
            n2 = inverse(i)*load(i, 2)
            n3 = inverse(i)*load(i, 3)
            all = all + along(i)
            xx = xx + (turning(i)*n1)*n1
            xy = xy + (turning(i)*n1)*n2
            xz = xz + (turning(i)*n1)*n3
            yy = yy + (turning(i)*n2)*n2
            yz = yz + (turning(i)*n2)*n3
            zz = zz + (turning(i)*n3)*n3
            fx = fx + sliding(i)*n1
            fy = fy + sliding(i)*n2
            fz = fz + sliding(i)*n3
        end do
        tangent(:, 1) = [all - xx, -xy, -xz, fx]
        tangent(:, 2) = [-xy, all - yy, -yz, fy]
        tangent(:, 3) = [-xz, -yz, all - zz, fz]
    end subroutine sum_up

    !> What sliders bring in which springs touched.
    pure subroutine add_newborn(levels, mu, force, shift, compliance, before, slopes, motion, tangent)
        type(levels_t), intent(in) :: levels
        !> as of tangent_of
        real(wp), intent(in) :: mu, force, shift, compliance, before
        type(motion_t), intent(in) :: motion
        !> dP/dF of the springs from a slider on
        real(wp), intent(in) :: slopes(0:most)
        real(wp), intent(inout) :: tangent(4, 3)
        real(wp) :: growth(3, 3), growth_by_force(3), by_way(3, 3), by_force(3), n(3), load, born, above
        integer :: i, j

        call growth_slopes(mu, shift, compliance, before, motion, growth, growth_by_force)
        above = 0.0_wp
        do i = motion%used - 1, motion%first_newborn, -1
            born = 1.0_wp - motion%top(3)*compliance
            if (i >= motion%before) call load_beyond(levels, motion%base + i - 1, force, shift, compliance, load, born)
            by_force = (born - above)*motion%growth + motion%newborn(i)*growth_by_force
            above = born
            by_way = motion%newborn(i)*growth
            do j = 1, 3
                by_way(j, j) = by_way(j, j) + motion%stiffness(i)
            end do
            if (motion%strength(i)*motion%inverse(i) < slips) then
                n = motion%load(i, :)*motion%inverse(i)
                by_force = motion%factor(i)*(by_force - dot_product(n, by_force)*n) + mu*(slopes(i) - slopes(i + 1))*n
                do j = 1, 3
                    by_way(:, j) = motion%factor(i)*(by_way(:, j) - dot_product(n, by_way(:, j))*n)
                end do
            else if (.not. motion%strength(i) > 0.0_wp) then
                cycle
            end if
            tangent(:3, :) = tangent(:3, :) + transpose(by_way)
            tangent(4, :) = tangent(4, :) + by_force
        end do
    end subroutine add_newborn

    !> The derivatives of g.
    pure subroutine growth_slopes(mu, shift, compliance, before, motion, by_way, by_force)
        real(wp), intent(in) :: mu, shift, compliance, before
        type(motion_t), intent(in) :: motion
        real(wp), intent(out) :: by_way(3, 3), by_force(3)
        real(wp) :: e(3), length
        integer :: j

        by_way = 0.0_wp
        by_force = 0.0_wp
        if (.not. shift > motion%top(1)) return
        if (motion%is_slow) then
            by_force = -compliance/(shift - before)*motion%growth
            do j = 1, 3
                by_way(j, j) = 1.0_wp/(shift - before)
            end do
        else
            length = norm2(motion%shift)
            e = motion%shift/length
            do j = 1, 3
                by_way(:, j) = -mu/length*e*e(j)
                by_way(j, j) = by_way(j, j) + mu/length
            end do
        end if
    end subroutine growth_slopes

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

    !> K of a slider where k is `top` at the upper end of the last one.
    pure function stiffness_of(levels, base, i, top) result(stiffness)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: base, i
        real(wp), intent(in) :: top
        real(wp) :: stiffness

        stiffness = min(levels%stiffness(base + i), top)
        if (i > 0) stiffness = stiffness - min(levels%stiffness(base + i - 1), top)
    end function stiffness_of

    !> Sliders that the contact has left are forgotten, and the core is divided while there is room.
    pure subroutine shrink(levels, mu, sliders, force, shift, compliance, cell, record)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: mu
        integer, intent(in) :: sliders
        real(wp), intent(in) :: force, shift, compliance
        integer, intent(in) :: cell
        real(wp), intent(inout), contiguous :: record(:)
        integer :: base, used, last
        logical :: divided

        do
            base = int(record(at_base))
            used = int(record(at_used))
            do while (used > 1)
                last = base + used - 2
                if (shift > levels%shift(last)) exit
                used = used - 1
                record([head + 1 + used, head + 1 + used + sliders, head + 1 + used + 2*sliders]) = 0.0_wp
                record(at_top:at_top + 2) = [levels%shift(last), levels%force(last), levels%stiffness(last)]
            end do
            record(at_used) = used
            if (used == sliders .or. base == 1) exit
            call divide(levels, mu, sliders, force, shift, compliance, cell, record, divided)
            if (.not. divided) exit
        end do
    end subroutine shrink

    !> The core in two at the next level below, with equal displacements, if each part is within its strength: T and the stored
    !> energy stay.
    pure subroutine divide(levels, mu, sliders, force, shift, compliance, cell, record, divided)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: mu
        integer, intent(in) :: sliders
        real(wp), intent(in) :: force, shift, compliance
        integer, intent(in) :: cell
        real(wp), intent(inout), contiguous :: record(:)
        logical, intent(out) :: divided
        real(wp) :: share, length, beyond, above, slope
        integer :: base, used, axis, place

        base = int(record(at_base))
        used = int(record(at_used))
        share = 1.0_wp - levels%stiffness(base - 1)/min(levels%stiffness(base), record(at_top + 2))
        length = norm2(record([head + 1, head + 1 + sliders, head + 1 + 2*sliders]))
        call strength_beyond(levels, base - 1, cell, force, shift, compliance, beyond, slope)
        above = 0.0_wp
        if (used > 1) call strength_beyond(levels, base, cell, force, shift, compliance, above, slope)
        divided = share*length <= mu*(beyond - above) .and. (1.0_wp - share)*length <= mu*(force - beyond)
        if (.not. divided) return
        do axis = 1, 3
            place = head + 1 + (axis - 1)*sliders
            record(place + 1:place + used) = record(place:place + used - 1)
            record(place + 1) = share*record(place)
            record(place) = record(place) - record(place + 1)
        end do
        record(at_base) = base - 1
        record(at_used) = used + 1
    end subroutine divide

    !> The bodies part: what is still stored is lost.
    pure subroutine part(levels, sliders, mark, record)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: sliders
        real(wp), intent(in) :: mark
        real(wp), intent(inout), contiguous :: record(:)

        record(at_law) = mark
        record(at_lost) = record(at_lost) + stored_energy(levels, sliders, record)
        record(at_base:at_top + 2) = 0.0_wp
        record(head + 1:) = 0.0_wp
    end subroutine part

    !> U, the sum of |t|^2/(2 K).
    pure function stored_energy(levels, sliders, record) result(energy)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: sliders
        real(wp), intent(in), contiguous :: record(:)
        real(wp) :: energy
        real(wp) :: stiffness, squared
        integer :: i, base

        energy = 0.0_wp
        base = int(record(at_base))
        if (base < 1) return
        do i = 0, int(record(at_used)) - 1
            stiffness = stiffness_of(levels, base, i, record(at_top + 2))
            squared = record(head + 1 + i)**2 + record(head + 1 + i + sliders)**2 + record(head + 1 + i + 2*sliders)**2
            if (stiffness > 0.0_wp) energy = energy + squared/(2.0_wp*stiffness)
        end do
    end function stored_energy

    !> All t turned with the tangent plane: by the least rotation from its old normal to the new one, and about that by an angle.
    !> Where no old normal is known, each is laid into the plane with the length it has.
    pure subroutine turn_record(sliders, normal, angle, mark, record)
        integer, intent(in) :: sliders
        !> of length 1
        real(wp), intent(in) :: normal(3)
        !> [1]
        real(wp), intent(in) :: angle
        real(wp), intent(in) :: mark
        real(wp), intent(inout), contiguous :: record(:)
        real(wp) :: t(3), axis(3), cosine
        integer :: i
        logical :: known

        associate (old => record(at_normal:at_normal + 2))
            known = any(abs(old) > 0.0_wp)
            axis = cross(old, normal)
            cosine = dot_product(old, normal)
        end associate
        do i = head + 1, head + sliders
            t = [record(i), record(i + sliders), record(i + 2*sliders)]
            if (.not. any(abs(t) > 0.0_wp)) cycle
            if (.not. known) then
                call lay(t, normal)
            else if (cosine > -1.0_wp) then
                t = cosine*t + cross(axis, t) + dot_product(axis, t)/(1.0_wp + cosine)*axis
            end if
            t = cos(angle)*t + sin(angle)*cross(normal, t)
            record(i) = t(1)
            record(i + sliders) = t(2)
            record(i + 2*sliders) = t(3)
        end do
        record(at_law) = mark
        record(at_normal:at_normal + 2) = normal
    end subroutine turn_record

    pure subroutine lay(vector, normal)
        real(wp), intent(inout) :: vector(3)
        real(wp), intent(in) :: normal(3)
        real(wp) :: length, left

        length = norm2(vector)
        vector = vector - dot_product(vector, normal)*normal
        left = norm2(vector)
        if (left > 0.0_wp) vector = length/left*vector
    end subroutine lay

    pure function cross(a, b) result(product)
        real(wp), intent(in) :: a(3), b(3)
        real(wp) :: product(3)

        product = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function cross

end module mdrcontact_law_sliders
