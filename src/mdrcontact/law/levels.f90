! SPDX-License-Identifier: GPL-3.0-or-later
!> Material levels of a law with friction: where the springs of a contact are divided among sliders, and how strong they are.
!>
!> Springs are labelled by S, the S' = int dF/k_t at which they touch. The springs beyond level l of a contact under F at S bear,
!> in units of the coefficient of friction,
!>     P_l = max over s of [T(s) - k_l s],
!> T(s) first shear under F. Where springs do not interact that is F - F_l - k_l (S - S_l), 0 for S <= S_l; elsewhere it is that
!> times a share, which tables hold.
module mdrcontact_law_levels
    use mdrcontact_contact, only: on_unloading
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_evaluate, only: point_at
    use mdrcontact_law_table, only: law_table_t
    implicit none (type, external)
    private
    public :: levels_t, new_levels, load_beyond, loads_beyond, slopes_beyond, share_of, share_index
    public :: fewest_sliders, most_sliders, most_levels, share_nodes

    !> Sliders of a law, and levels whatever its range.
    integer, parameter :: fewest_sliders = 4, most_sliders = 64, most_levels = 320
    !> Coefficients of a share between two levels: of powers of (S - S_m)/(S_m+1 - S_m).
    integer, parameter :: share_nodes = 3
    !> S_l+1/S_l is 1 + spread/sliders + least: coarser levels bend first shear too little, finer ones leave too much to the core.
    real(wp), parameter :: spread = 3.0_wp, least = 1.0_wp/32.0_wp

    !> Levels 0, at first touch, to `count`; one more, never reached.
    type :: levels_t
        integer :: count = 0
        !> S_l [length], F_l [modulus length^2] and k_l = dF/dS there [modulus length], (0:count + 1)
        real(wp), allocatable :: shift(:), force(:), stiffness(:)
        !> the shares, (share_index(count, count), share_nodes); not allocated where all are 1
        real(wp), allocatable :: share(:, :)
    end type levels_t

contains

    !> The levels for a number of sliders, without shares: down to where the range of the law begins with all of its sliders.
    pure subroutine new_levels(self, by_shift, by_force, sliders)
        type(levels_t), intent(out) :: self
        !> with S in place of the depth and k_t in place of the stiffness
        type(law_table_t), intent(in) :: by_shift, by_force
        !> fewest_sliders to most_sliders
        integer, intent(in) :: sliders
        real(wp) :: ratio, shift, compliance, radius, stiffness, unused
        integer :: l

        ratio = 1.0_wp + spread/sliders + least
        shift = by_shift%highest
        self%count = sliders
        do while (shift > by_shift%lowest .and. self%count < most_levels)
            shift = shift/ratio
            self%count = self%count + 1
        end do
        allocate (self%shift(0:self%count + 1), self%force(0:self%count + 1), self%stiffness(0:self%count + 1))
        shift = by_shift%highest
        do l = self%count, 1, -1
            call point_at(by_shift, on_unloading, shift, self%force(l), unused, radius, stiffness)
            ! both from the table that steps are made with
            call point_at(by_force, on_unloading, self%force(l), self%shift(l), compliance, radius, stiffness)
            self%stiffness(l) = 1.0_wp/compliance
            shift = shift/ratio
        end do
        ! a flat end touches with all of its springs at once
        self%stiffness(0) = merge(self%stiffness(1), 0.0_wp, by_force%end_radius > 0.0_wp)
        self%shift([0, self%count + 1]) = [0.0_wp, huge(1.0_wp)]
        self%force([0, self%count + 1]) = [0.0_wp, huge(1.0_wp)]
        self%stiffness(self%count + 1) = huge(1.0_wp)
        do l = 1, self%count
            self%stiffness(l) = max(self%stiffness(l), self%stiffness(l - 1))
        end do
    end subroutine new_levels

    !> F - F_l - k_l (S - S_l), 0 at S <= S_l, and its derivative with respect to F.
    pure subroutine load_beyond(self, l, force, shift, compliance, load, slope)
        type(levels_t), intent(in) :: self
        !> 1 to count + 1
        integer, intent(in) :: l
        !> F, S and dS/dF of the contact
        real(wp), intent(in) :: force, shift, compliance
        real(wp), intent(out) :: load, slope

        load = 0.0_wp
        slope = 0.0_wp
        if (shift > self%shift(l)) load = (force - self%force(l)) - self%stiffness(l)*(shift - self%shift(l))
        if (load > 0.0_wp) then
            slope = 1.0_wp - self%stiffness(l)*compliance
        else
            load = 0.0_wp
        end if
    end subroutine load_beyond

    !> P for levels in a row, without branches; S_m < S, S <= S_m+1.
    pure subroutine loads_beyond(self, first, count, m, force, shift, loads)
        type(levels_t), intent(in) :: self
        integer, intent(in) :: first, count, m
        !> F and S of the contact
        real(wp), intent(in) :: force, shift
        real(wp), intent(out) :: loads(count)
        real(wp) :: width, x
        integer :: i, place

        call superposed_loads(count, self%shift(first), self%force(first), self%stiffness(first), force, shift, loads)
        if (.not. allocated(self%share) .or. m < first) return
        call place_between(self, m, shift, x, width)
        place = share_index(first, m) - 1
        associate (c => self%share)
            do i = 1, min(count, m - first + 1)
                loads(i) = min(loads(i)*(c(place + i, 1) + x*(c(place + i, 2) + x*c(place + i, 3))), force)
            end do
        end associate
    end subroutine loads_beyond

    !> load_beyond for levels in a row. F <= F_l where S <= S_l.
    pure subroutine superposed_loads(count, level_shift, level_force, stiffness, force, shift, loads)
        integer, intent(in) :: count
        real(wp), intent(in), dimension(count) :: level_shift, level_force, stiffness
        !> F and S of the contact
        real(wp), intent(in) :: force, shift
        real(wp), intent(out) :: loads(count)
        integer :: i

        do i = 1, count
            loads(i) = max((force - level_force(i)) - stiffness(i)*max(shift - level_shift(i), 0.0_wp), 0.0_wp)
        end do
    end subroutine superposed_loads

    !> The derivatives of P with respect to F for levels in a row, without branches; S_m < S, S <= S_m+1.
    pure subroutine slopes_beyond(self, first, count, m, force, shift, compliance, slopes)
        type(levels_t), intent(in) :: self
        integer, intent(in) :: first, count, m
        !> F, S and dS/dF of the contact
        real(wp), intent(in) :: force, shift, compliance
        real(wp), intent(out) :: slopes(count)
        real(wp) :: loads(most_levels + most_sliders), width, x, share, share_slope
        integer :: i, place

        call superposed_loads(count, self%shift(first), self%force(first), self%stiffness(first), force, shift, loads)
        ! the last level may be the one that is never reached
        associate (k => self%stiffness, highest => 1.0_wp/compliance)
            !$omp simd
            do i = 1, count
                slopes(i) = merge(1.0_wp - min(k(first + i - 1), highest)*compliance, 0.0_wp, loads(i) > 0.0_wp)
            end do
        end associate
        if (.not. allocated(self%share) .or. m < first) return
        call place_between(self, m, shift, x, width)
        place = share_index(first, m) - 1
        associate (c => self%share)
            !$omp simd private(share, share_slope)
            do i = 1, min(count, m - first + 1)
                share = c(place + i, 1) + x*(c(place + i, 2) + x*c(place + i, 3))
                share_slope = (c(place + i, 2) + 2.0_wp*x*c(place + i, 3))*(compliance/width)
                slopes(i) = merge(1.0_wp, share*slopes(i) + share_slope*loads(i), share*loads(i) > force)
            end do
        end associate
    end subroutine slopes_beyond

    !> The factor of that where springs interact, and its derivative with respect to S; S_m < S, S <= S_m+1.
    pure subroutine share_of(self, l, m, shift, share, slope)
        type(levels_t), intent(in) :: self
        integer, intent(in) :: l, m
        !> S of the contact
        real(wp), intent(in) :: shift
        real(wp), intent(out) :: share, slope
        real(wp) :: width, x

        call place_between(self, m, shift, x, width)
        associate (c => self%share(share_index(l, m), :))
            share = c(1) + x*(c(2) + x*c(3))
            slope = (c(2) + 2.0_wp*x*c(3))/width
        end associate
    end subroutine share_of

    !> Where S stands between levels m and m + 1, and how far these are apart; beyond the last level all stays as it is there.
    pure subroutine place_between(self, m, shift, x, width)
        type(levels_t), intent(in) :: self
        integer, intent(in) :: m
        real(wp), intent(in) :: shift
        real(wp), intent(out) :: x, width

        width = self%shift(m + 1) - self%shift(m)
        x = 0.0_wp
        if (m < self%count) x = (shift - self%shift(m))/width
    end subroutine place_between

    !> Where the share of the springs beyond level l of a contact between levels m >= l and m + 1 stands.
    pure function share_index(l, m) result(place)
        integer, intent(in) :: l, m
        integer :: place

        place = m*(m - 1)/2 + l
    end function share_index

end module mdrcontact_law_levels
