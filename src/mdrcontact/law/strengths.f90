! SPDX-License-Identifier: GPL-3.0-or-later
!> How much the springs beyond a level can bear, in units of the coefficient of friction or of the shear strength,
!>     P_l = max over s of [T(s) - k_l s],
!> T(s) first shear. Where springs do not interact that is, under Coulomb's law and at constant shear strength,
!>     F - F_l - k_l (S - S_l),    2 (a^2 arccos(c/a) - c sqrt(a^2 - c^2)),
!> 0 for S <= S_l; where they do it is Coulomb's times a share, which tables hold. P_0 is F, and pi a^2.
module mdrcontact_law_strengths
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law_levels, only: levels_t, most_levels, most_sliders, share_index, share_nodes
    implicit none (type, external)
    private
    public :: place_t, new_place, load_beyond, loads_beyond, slopes_beyond, growth_beyond, most

    !> As many levels as a step may meet.
    integer, parameter :: most = most_sliders + most_levels + 1

    !> Where a contact is at the end of a step.
    type :: place_t
        !> F, S, k = dF/dS; and dS/dF, or 1 where S = a is what is given
        real(wp) :: force, shift, stiffness, rate
        !> P_0
        real(wp) :: load
    end type place_t

contains

    !> The place of a contact under F, with S and dS/dF; of a contact of radius a = S where the shear strength is constant.
    pure function new_place(levels, force, shift, compliance) result(place)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: force, shift, compliance
        type(place_t) :: place

        if (levels%is_constant) then
            associate (stiffness => levels%stiffness(levels%count)/levels%shift(levels%count)*shift)
                place = place_t(0.5_wp*stiffness*shift, shift, stiffness, 1.0_wp, pi*shift**2)
            end associate
        else
            place = place_t(force, shift, 1.0_wp/compliance, compliance, force)
        end if
    end function new_place

    !> P of some levels, without branches; S_m < S, S <= S_m+1 (m is needed where there are shares).
    pure subroutine loads_beyond(levels, count, level, m, place, loads)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: count, level(count), m
        type(place_t), intent(in) :: place
        real(wp), intent(out) :: loads(count)
        real(wp) :: width, x

        if (levels%is_constant) then
            call constant_loads(levels, count, level, place, loads)
            return
        end if
        call superposed_loads(count, level, place, levels%count, levels%shift, levels%force, levels%stiffness, loads)
        if (.not. allocated(levels%share)) return
        call place_between(levels, m, place%shift, x, width)
        call share_out(size(levels%share, 2), levels%share, count, level, m, x, place%load, loads)
    end subroutine loads_beyond

    !> The shares of springs that interact.
    pure subroutine share_out(pairs, share, count, level, m, x, largest, loads)
        integer, intent(in) :: pairs, count, level(count), m
        real(wp), intent(in) :: share(share_nodes, pairs), x, largest
        real(wp), intent(inout) :: loads(count)
        integer :: i, l, first

        first = m*(m - 1)/2
        do i = 1, count
            if (level(i) > m) exit
            l = first + level(i)
            loads(i) = min(loads(i)*(share(1, l) + x*(share(2, l) + x*share(3, l))), largest)
        end do
    end subroutine share_out

    !> F - F_l - k_l (S - S_l) of some levels; F <= F_l where S <= S_l.
    pure subroutine superposed_loads(count, level, place, last, shift, force, stiffness, loads)
        integer, intent(in) :: count, level(count)
        type(place_t), intent(in) :: place
        !> of all levels
        integer, intent(in) :: last
        real(wp), intent(in), dimension(0:last + 1) :: shift, force, stiffness
        real(wp), intent(out) :: loads(count)
        integer :: i, l

        do i = 1, count
            l = level(i)
            loads(i) = max((place%force - force(l)) - stiffness(l)*max(place%shift - shift(l), 0.0_wp), 0.0_wp)
        end do
    end subroutine superposed_loads

    !> P at constant shear strength of some levels, and its derivatives by the contact radius.
    pure subroutine constant_loads(levels, count, level, place, loads, slopes)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: count, level(count)
        type(place_t), intent(in) :: place
        real(wp), intent(out) :: loads(count)
        real(wp), intent(out), optional :: slopes(count)
        integer :: i

        associate (a => place%shift)
            do i = 1, count
                associate (c => min(levels%shift(level(i)), a))
                    loads(i) = max(2.0_wp*(a**2*acos(c/a) - c*sqrt((a - c)*(a + c))), 0.0_wp)
                    if (present(slopes)) slopes(i) = 4.0_wp*a*acos(c/a)
                end associate
            end do
        end associate
        call halve_lack(levels, count, level, place, loads, slopes)
    end subroutine constant_loads

    !> Sliders follow tangents of first shear, which they do not fall short of anywhere: P of each level less an eighth of what a
    !> chord over it is above it halves the error; less than an eighth where its neighbours are not as far, so that P goes on to
    !> fall from level to level. Above the last level chords end at the edge, where P is 0.
    pure subroutine halve_lack(levels, count, level, place, loads, slopes)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: count, level(count)
        type(place_t), intent(in) :: place
        real(wp), intent(inout) :: loads(count)
        real(wp), intent(inout), optional :: slopes(count)
        !> of the level below, the level itself, and the one above or the edge: k, P and its derivative
        real(wp) :: k(3), p(3), s(3), part
        integer :: i

        k(2) = 0.0_wp
        p(2) = place%load
        s(2) = 2.0_wp*pi*place%shift
        do i = 1, count
            if (.not. loads(i) > 0.0_wp) exit
            k(1) = k(2)
            p(1) = p(2)
            s(1) = s(2)
            k(2) = levels%stiffness(level(i))
            p(2) = loads(i)
            k(3) = place%stiffness
            p(3) = 0.0_wp
            if (i < count) then
                k(3) = min(levels%stiffness(level(i + 1)), place%stiffness)
                p(3) = loads(i + 1)
            end if
            part = (k(2) - k(1))/(k(3) - k(1))
            loads(i) = p(2) - 0.5_wp*part*(1.0_wp - part)*(p(1) + part*(p(3) - p(1)) - p(2))
            if (.not. present(slopes)) cycle
            s(2) = slopes(i)
            s(3) = 0.0_wp
            if (i < count) s(3) = slopes(i + 1)
            slopes(i) = s(2) - 0.5_wp*part*(1.0_wp - part)*(s(1) + part*(s(3) - s(1)) - s(2))
            ! the edge moves
            if (k(3) < place%stiffness) cycle
            slopes(i) = slopes(i) + 0.5_wp*part/(k(3) - k(1))*place%stiffness/place%shift* &
                        ((1.0_wp - 2.0_wp*part)*(p(1) + part*(p(3) - p(1)) - p(2)) + part*(1.0_wp - part)*(p(3) - p(1)))
        end do
    end subroutine halve_lack

    !> P of one level.
    pure function load_beyond(levels, l, m, place) result(load)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: l, m
        type(place_t), intent(in) :: place
        real(wp) :: load
        real(wp) :: loads(1)

        call loads_beyond(levels, 1, [l], m, place, loads)
        load = loads(1)
    end function load_beyond

    !> The derivatives of P, by F or the contact radius, of some levels.
    pure subroutine slopes_beyond(levels, count, level, m, place, slopes)
        type(levels_t), intent(in) :: levels
        !> as of loads_beyond
        integer, intent(in) :: count, level(count), m
        type(place_t), intent(in) :: place
        real(wp), intent(out) :: slopes(count)
        real(wp) :: loads(most), width, x, share, share_slope
        integer :: i, first

        if (levels%is_constant) then
            call constant_loads(levels, count, level, place, loads, slopes)
            return
        end if
        call superposed_loads(count, level, place, levels%count, levels%shift, levels%force, levels%stiffness, loads)
        do i = 1, count
            slopes(i) = merge(1.0_wp - min(levels%stiffness(level(i)), place%stiffness)*place%rate, 0.0_wp, loads(i) > 0.0_wp)
        end do
        if (.not. allocated(levels%share)) return
        call place_between(levels, m, place%shift, x, width)
        first = share_index(1, m) - 1
        do i = 1, count
            if (level(i) > m) exit
            associate (c => levels%share(:, first + level(i)))
                share = c(1) + x*(c(2) + x*c(3))
                share_slope = (c(2) + 2.0_wp*x*c(3))*(place%rate/width)
            end associate
            slopes(i) = merge(1.0_wp, share*slopes(i) + share_slope*loads(i), share*loads(i) > place%load)
        end do
    end subroutine slopes_beyond

    !> int (k - k_l) dS from S_l, what springs beyond it bear for each unit of shift and S that grow together from there on; and its
    !> derivative.
    pure subroutine growth_beyond(levels, from, place, load, slope)
        type(levels_t), intent(in) :: levels
        !> S_l, F_l and k_l
        real(wp), intent(in) :: from(3)
        type(place_t), intent(in) :: place
        real(wp), intent(out) :: load, slope

        if (levels%is_constant) then
            ! k is proportional to S: exact, however small the growth
            load = 0.5_wp*(place%stiffness - from(3))*(place%shift - from(1))
        else
            load = (place%force - from(2)) - from(3)*(place%shift - from(1))
        end if
        slope = 0.0_wp
        if (load > 0.0_wp) then
            slope = (place%stiffness - from(3))*place%rate
        else
            load = 0.0_wp
        end if
    end subroutine growth_beyond

    !> Where S stands between levels m and m + 1, and how far these are apart; beyond the last level all stays as it is there.
    pure subroutine place_between(levels, m, shift, x, width)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: m
        real(wp), intent(in) :: shift
        real(wp), intent(out) :: x, width

        width = levels%shift(m + 1) - levels%shift(m)
        x = 0.0_wp
        if (m < levels%count) x = (shift - levels%shift(m))/width
    end subroutine place_between

end module mdrcontact_law_strengths
