! SPDX-License-Identifier: GPL-3.0-or-later
!> Material levels of a law with friction: where the springs of a contact may be divided among sliders (theory/friction.md (7.4)).
!>
!> Springs are labelled by the S at which they touch. With F = int k dS, k the stiffness of all springs in contact:
!>     Coulomb's law:            F the normal force, S = int dF/k_t,
!>     constant shear strength:  S = a, the contact radius; F = k_t a/2 (k_t is proportional to a),
!>     twist under a paraboloid: S = a, F = k a/4 (k = (16/3) G a^3, M/phi of the contact).
!> A step is straight in S. Levels are closer than sliders: these are fine where springs have just touched and coarse within,
!> and a contact that grows joins two of its sliders for each level that it passes, mdrcontact_law_sliders_join.
module mdrcontact_law_levels
    use mdrcontact_contact, only: on_unloading
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law_evaluate, only: point_at
    use mdrcontact_law_table, only: law_table_t
    use mdrcontact_law_twist, only: new_twist_loads
    implicit none (type, external)
    private
    public :: levels_t, new_levels, new_radius_levels, allocate_shares, share_index, count_shares, by_shear, by_twist
    public :: fewest_sliders, most_sliders, most_levels, share_nodes

    !> Sliders of a law, and levels for any range.
    integer, parameter :: fewest_sliders = 4, most_sliders = 64, most_levels = 320
    !> Coefficients of a share between two levels: of powers of (S - S_m)/(S_m+1 - S_m).
    integer, parameter :: share_nodes = 3
    !> S_l+1/S_l is 1 + spread/sliders + least of springs that interact, and 1 + spread/sliders^2 + least of those that do not.
    real(wp), parameter :: spread_of_shares = 2.0_wp, least_of_shares = 0.02_wp, spread = 6.0_wp, least = 0.02_wp
    !> The power of the contact radius to which k is proportional: of a shift, of a twist.
    integer, parameter :: by_shear = 1, by_twist = 3
    !> The same where S is the contact radius: the load of springs bends most slowly at the edge.
    real(wp), parameter :: spread_of_radii = 0.1_wp, least_of_radii = 0.008_wp

    !> Levels 0, at initial contact, to `count`; one more, never reached.
    type :: levels_t
        integer :: count = 0
        !> S_l [length], F_l [modulus length^2] and k_l = dF/dS there [modulus length], (0:count + 1)
        real(wp), allocatable :: shift(:), force(:), stiffness(:)
        !> k at initial contact: a flat end touches with all of its springs simultaneously
        real(wp) :: first_stiffness = 0.0_wp
        !> distance below the next level at which the lower ends of sliders best lie, in levels, ascending
        integer, allocatable :: places(:)
        !> the same together, with 1/(S_l+1 - S_l), 0 for the last: (4, 0:count + 1)
        real(wp), allocatable :: row(:, :)
        !> shares of springs that interact, share_nodes coefficients and 0, (4, 0:share_index(count + 1, count)); not allocated
        !> where all are whole
        real(wp), allocatable :: share(:, :)
        !> what distinguishes records of this law from those of another, >= 1
        real(wp) :: mark = 0.0_wp
        !> how many sliders a record has
        integer :: sliders = 0
        !> what times P is the strength of springs: mu [1]; the shear strength where that is constant [modulus]; of a twist
        !> -dphi/dc at the edge in sliding [1/length]
        real(wp) :: strength = 0.0_wp
        !> whether S is the contact radius; if so, k is proportional to this power of S: by_shear or by_twist
        logical :: of_radius = .false.
        integer :: power = 0
        !> of a twist what springs beyond a radius carry, mdrcontact_law_twist
        real(wp), allocatable :: twist_load(:, :)
    end type levels_t

contains

    !> The levels for a number of sliders under Coulomb's law, without shares: down to where the range of the law begins.
    pure subroutine new_levels(self, by_shift, by_force, sliders, shared)
        type(levels_t), intent(out) :: self
        !> with S instead of the depth and k_t instead of the stiffness
        type(law_table_t), intent(in) :: by_shift, by_force
        !> fewest_sliders to most_sliders
        integer, intent(in) :: sliders
        !> whether springs interact: shares are found for each pair of levels
        logical, intent(in) :: shared
        real(wp) :: ratio, shift, compliance, radius, stiffness, unused
        integer :: l

        self%sliders = sliders
        ratio = 1.0_wp + merge(spread_of_shares/sliders + least_of_shares, spread/sliders**2 + least, shared)
        ratio = max(ratio, (by_shift%highest/by_shift%lowest)**(1.0_wp/(most_levels - sliders)))
        call allocate_levels(self, ratio, by_shift%lowest, by_shift%highest)
        shift = by_shift%highest
        do l = self%count, 1, -1
            call point_at(by_shift, on_unloading, shift, self%force(l), unused, radius, stiffness)
            ! both from the table that steps are made with
            call point_at(by_force, on_unloading, self%force(l), self%shift(l), compliance, radius, stiffness)
            self%stiffness(l) = 1.0_wp/compliance
            shift = shift/ratio
        end do
        if (by_force%end_radius > 0.0_wp) self%first_stiffness = self%stiffness(1)
        do l = 1, self%count
            self%stiffness(l) = max(self%stiffness(l), self%stiffness(l - 1))
        end do
        call lay_rows(self)
        call find_places(self, ratio)
    end subroutine new_levels

    !> The levels for a number of sliders of contact radii.
    pure subroutine new_radius_levels(self, lowest, highest, stiffness, power, sliders)
        type(levels_t), intent(out) :: self
        !> of the radius [length]
        real(wp), intent(in) :: lowest, highest
        !> k/a^power
        real(wp), intent(in) :: stiffness
        !> by_shear or by_twist
        integer, intent(in) :: power
        !> as of new_levels
        integer, intent(in) :: sliders
        real(wp) :: ratio
        integer :: l

        self%sliders = sliders
        self%of_radius = .true.
        self%power = power
        if (power == by_twist) call new_twist_loads(self%twist_load)
        ratio = 1.0_wp + spread_of_radii/sliders + least_of_radii
        ratio = max(ratio, (highest/lowest)**(1.0_wp/(most_levels - sliders)))
        call allocate_levels(self, ratio, lowest, highest)
        do l = self%count, 1, -1
            self%shift(l) = highest*ratio**(l - self%count)
            self%stiffness(l) = stiffness*self%shift(l)**power
            self%force(l) = self%stiffness(l)*self%shift(l)/(power + 1)
        end do
        call lay_rows(self)
        call find_places(self, ratio)
    end subroutine new_radius_levels

    !> Room for all levels, with the ends.
    pure subroutine allocate_levels(self, ratio, lowest, highest)
        type(levels_t), intent(inout) :: self
        real(wp), intent(in) :: ratio, lowest, highest
        real(wp) :: shift

        shift = highest
        self%count = self%sliders
        do while (shift > lowest .and. self%count < most_levels)
            shift = shift/ratio
            self%count = self%count + 1
        end do
        allocate (self%shift(0:self%count + 1), self%force(0:self%count + 1), self%stiffness(0:self%count + 1))
        self%shift([0, self%count + 1]) = [0.0_wp, huge(1.0_wp)]
        self%force([0, self%count + 1]) = [0.0_wp, huge(1.0_wp)]
        self%stiffness([0, self%count + 1]) = [0.0_wp, huge(1.0_wp)]
    end subroutine allocate_levels

    !> The data of a level that steps read are contiguous.
    pure subroutine lay_rows(self)
        type(levels_t), intent(inout) :: self

        allocate (self%row(4, 0:self%count + 1), source=0.0_wp)
        self%row(1, :) = self%shift
        self%row(2, :) = self%force
        self%row(3, :) = self%stiffness
        self%row(4, :self%count - 1) = 1.0_wp/(self%shift(1:self%count) - self%shift(:self%count - 1))
    end subroutine lay_rows

    !> Where lower ends of sliders best lie: such that each lacks as much of first shear, T(s) being that of a paraboloid, and
    !> under Coulomb's law relative to the s at which it lacks that. S_l/S = cos^2 x there, c/a = cos x: to be found are equal
    !> parts of the integral of the root of cos x, of sin 2 x at constant shear strength, and of cos x sin^2 x of a twist.
    pure subroutine find_places(self, ratio)
        type(levels_t), intent(inout) :: self
        real(wp), intent(in) :: ratio
        integer, parameter :: parts = 2000
        real(wp) :: total, sum, x
        integer :: i, j, place

        allocate (self%places(self%sliders - 1), source=1)
        total = 0.0_wp
        do i = 1, parts
            total = total + density(0.5_wp*pi*(i - 0.5_wp)/parts)
        end do
        sum = 0.0_wp
        place = 0
        j = 1
        do i = 1, parts - 1
            x = 0.5_wp*pi*i/parts
            sum = sum + density(x - 0.25_wp*pi/parts)
            if (sum < total*j/self%sliders) cycle
            place = max(place + 1, ceiling(-merge(1.0_wp, 2.0_wp, self%of_radius)*log(cos(x))/log(ratio)))
            self%places(j) = place
            if (j == self%sliders - 1) exit
            j = j + 1
        end do

    contains

        pure function density(x) result(value)
            real(wp), intent(in) :: x
            real(wp) :: value

            select case (self%power)
            case (by_shear)
                value = sqrt(sin(2.0_wp*x))
            case (by_twist)
                value = sqrt(cos(x))*sin(x)
            case default
                value = sqrt(cos(x))
            end select
        end function density

    end subroutine find_places

    !> Room for shares, all whole; stat is not 0 if it does not exist.
    pure subroutine allocate_shares(self, stat)
        type(levels_t), intent(inout) :: self
        integer, intent(out) :: stat

        allocate (self%share(4, 0:share_index(self%count + 1, self%count)), source=0.0_wp, stat=stat)
        if (stat == 0) self%share(1, :) = 1.0_wp
    end subroutine allocate_shares

    !> Where the share of the springs beyond level l of a contact between levels m and m + 1 stands,
    !> 0 <= l <= m + 1; it is whole for the first and the last of these.
    pure function share_index(l, m) result(place)
        integer, intent(in) :: l, m
        integer :: place

        place = m*(m + 3)/2 + l
    end function share_index

    !> Number of partial shares.
    pure function count_shares(self) result(count)
        type(levels_t), intent(in) :: self
        integer :: count

        count = self%count*(self%count + 1)/2
    end function count_shares

end module mdrcontact_law_levels
