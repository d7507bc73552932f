! SPDX-License-Identifier: GPL-3.0-or-later
!> The derivatives of a step of sliders.
module mdrcontact_law_sliders_tangent
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    use mdrcontact_law_sliders_motion, only: motion_t, slips
    use mdrcontact_law_strengths, only: growth_beyond, most, place_t, slopes_beyond
    implicit none (type, external)
    private
    public :: tangent_of

contains

    !> The derivatives of T with respect to ds, (1:3, i), and F (or the contact radius, where that is given), (4, i), of its
    !> component i.
    pure subroutine tangent_of(levels, place, before, motion, tangent)
        type(levels_t), intent(in) :: levels
        type(place_t), intent(in) :: place
        !> S before the step
        real(wp), intent(in) :: before
        type(motion_t), intent(in) :: motion
        real(wp), intent(out) :: tangent(4, 3)
        real(wp) :: slopes(0:most)

        slopes(0) = merge(8.0_wp*atan(1.0_wp)*place%shift, 1.0_wp, levels%is_constant)
        call slopes_beyond(levels, motion%used - 1, motion%level(1:motion%used - 1), motion%cell, place, &
                           slopes(1:motion%used - 1))
        slopes(motion%used) = 0.0_wp
        call old_tangent(levels%strength, slopes, motion, tangent)
        if (motion%first_newborn == motion%used) return
        call add_newborn(levels, place, before, slopes, motion, tangent)
    end subroutine tangent_of

    !> What sliders bring in which no spring touched: the sums of K' I - K' n n^T of those that slip, K' = K mu B/|y|, of K I of
    !> those that stick, and of mu dB/dF n; n = y/|y|.
    pure subroutine old_tangent(mu, slopes, motion, tangent)
        real(wp), intent(in) :: mu
        type(motion_t), intent(in) :: motion
        !> dP/dF of the springs from a slider on
        real(wp), intent(in) :: slopes(0:most)
        real(wp), intent(out) :: tangent(4, 3)
        real(wp) :: all, xx, xy, xz, yy, yz, zz, f(3), n(3), slides, along, sliding
        integer :: i

        all = 0.0_wp
        xx = 0.0_wp
        xy = 0.0_wp
        xz = 0.0_wp
        yy = 0.0_wp
        yz = 0.0_wp
        zz = 0.0_wp
        f = 0.0_wp
        do i = 0, motion%first_newborn - 1
            slides = merge(motion%inverse(i), 0.0_wp, motion%factor(i) < slips)
            n = slides*motion%load(i, :)
            along = motion%factor(i)*motion%stiffness(i)
            sliding = mu*(slopes(i) - slopes(i + 1))
            all = all + along
            xx = xx + (along*n(1))*n(1)
            xy = xy + (along*n(1))*n(2)
            xz = xz + (along*n(1))*n(3)
            yy = yy + (along*n(2))*n(2)
            yz = yz + (along*n(2))*n(3)
            zz = zz + (along*n(3))*n(3)
            f = f + sliding*n
        end do
        tangent(:, 1) = [all - xx, -xy, -xz, f(1)]
        tangent(:, 2) = [-xy, all - yy, -yz, f(2)]
        tangent(:, 3) = [-xz, -yz, all - zz, f(3)]
    end subroutine old_tangent

    !> What sliders bring in which springs touched.
    pure subroutine add_newborn(levels, place, before, slopes, motion, tangent)
        type(levels_t), intent(in) :: levels
        !> as of tangent_of
        type(place_t), intent(in) :: place
        real(wp), intent(in) :: before
        type(motion_t), intent(in) :: motion
        !> dP/dF of the springs from a slider on
        real(wp), intent(in) :: slopes(0:most)
        real(wp), intent(inout) :: tangent(4, 3)
        real(wp) :: growth(3, 3), growth_by_force(3), by_way(3, 3), by_force(3), n(3), from(3), load, born, above
        integer :: i, j

        call growth_slopes(levels%strength, place, before, motion, growth, growth_by_force)
        above = 0.0_wp
        do i = motion%used - 1, motion%first_newborn, -1
            from = motion%top
            associate (l => motion%level(i))
                if (i >= motion%before) from = [levels%shift(l), levels%force(l), levels%stiffness(l)]
            end associate
            call growth_beyond(levels, from, place, load, born)
            by_force = (born - above)*motion%growth + motion%newborn(i)*growth_by_force
            above = born
            by_way = motion%newborn(i)*growth
            do j = 1, 3
                by_way(j, j) = by_way(j, j) + motion%stiffness(i)
            end do
            if (motion%factor(i) < slips) then
                n = motion%load(i, :)*motion%inverse(i)
                by_force = motion%factor(i)*(by_force - dot_product(n, by_force)*n) + &
                           levels%strength*(slopes(i) - slopes(i + 1))*n
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
    pure subroutine growth_slopes(mu, place, before, motion, by_way, by_force)
        real(wp), intent(in) :: mu
        type(place_t), intent(in) :: place
        real(wp), intent(in) :: before
        type(motion_t), intent(in) :: motion
        real(wp), intent(out) :: by_way(3, 3), by_force(3)
        real(wp) :: e(3), length
        integer :: j

        by_way = 0.0_wp
        by_force = 0.0_wp
        if (motion%is_slow) then
            by_force = -place%rate/(place%shift - before)*motion%growth
            do j = 1, 3
                by_way(j, j) = 1.0_wp/(place%shift - before)
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

end module mdrcontact_law_sliders_tangent
