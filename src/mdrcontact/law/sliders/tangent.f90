! SPDX-License-Identifier: GPL-3.0-or-later
!> The derivatives of a step of sliders.
module mdrcontact_law_sliders_tangent
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t, load_beyond, slopes_beyond
    use mdrcontact_law_sliders_motion, only: most, motion_t, slips
    implicit none (type, external)
    private
    public :: tangent_of

contains

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

end module mdrcontact_law_sliders_tangent
