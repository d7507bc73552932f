! SPDX-License-Identifier: GPL-3.0-or-later
!> Strength of the springs beyond a level, in units of the coefficient of friction or of the shear strength
!> (theory/friction.md (7.4), (7.11), (7.12)),
!>     P_l = max over s of [T(s) - k_l s],
!> T(s) first shear. Where springs do not interact that is, under Coulomb's law and at constant shear strength,
!>     F - F_l - k_l (S - S_l),    2 (a^2 arccos(c/a) - c sqrt(a^2 - c^2)),
!> 0 for S <= S_l; where they do it is Coulomb's times a share, which tables hold. P_0 is F, and pi a^2. Of a twist M and phi stand
!> instead of T and s: mdrcontact_law_twist.
module mdrcontact_law_strengths
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law_levels, only: by_twist, levels_t, share_index
    use mdrcontact_law_twist, only: twist_load
    implicit none (type, external)
    private
    public :: place_t, new_place, load_beyond, radius_loads, growth_beyond

    !> Where a contact is at the end of a step.
    type, bind(C) :: place_t
        !> F, S, k = dF/dS; and dS by what is given: the normal force, or 1 where that is S = a
        real(c_double) :: force, shift, stiffness, rate
        !> P_0
        real(c_double) :: load
    end type place_t

contains

    !> The place of a contact under F, with S and dS/dF; of a contact of radius a = S.
    pure function new_place(levels, force, shift, compliance) result(place)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in) :: force, shift, compliance
        type(place_t) :: place

        if (levels%of_radius) then
            associate (n => levels%power, last => levels%count)
                place%stiffness = levels%stiffness(last)*(shift/levels%shift(last))**n
                place%force = place%stiffness*shift/(n + 1)
                place%shift = shift
                place%rate = compliance
                ! of a twist G a^4 pi/2, which is k a 3 pi/32
                place%load = merge(3.0_wp*pi/32.0_wp*place%stiffness*shift, pi*shift**2, n == by_twist)
            end associate
        else
            place = place_t(force, shift, 1.0_wp/compliance, compliance, force)
        end if
    end function new_place

    !> P of one level; S_m < S, S <= S_m+1 (m is needed where there are shares).
    pure function load_beyond(levels, l, m, place) result(load)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: l, m
        type(place_t), intent(in) :: place
        real(wp) :: load
        real(wp) :: loads(1), x

        if (levels%of_radius) then
            call radius_loads(levels, 1, [l], place, loads)
            load = loads(1)
            return
        end if
        load = max((place%force - levels%force(l)) - levels%stiffness(l)*max(place%shift - levels%shift(l), 0.0_wp), 0.0_wp)
        if (.not. allocated(levels%share) .or. l > m) return
        x = 0.0_wp
        if (m < levels%count) x = (place%shift - levels%shift(m))/(levels%shift(m + 1) - levels%shift(m))
        associate (c => levels%share(:, share_index(l, m)))
            load = min(load*(c(1) + x*(c(2) + x*c(3))), place%load)
        end associate
    end function load_beyond

    !> P of some levels where S is the contact radius, and its derivatives by that.
    pure subroutine radius_loads(levels, count, level, place, loads, slopes)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: count, level(count)
        type(place_t), intent(in) :: place
        real(wp), intent(out) :: loads(count)
        real(wp), intent(out), optional :: slopes(count)
        real(wp) :: load, slope
        integer :: i

        associate (a => place%shift)
            do i = 1, count
                associate (c => min(levels%shift(level(i)), a))
                    if (levels%power == by_twist) then
                        call twist_load(levels%twist_load, c, a, load, slope)
                        load = place%stiffness*a*load
                        slope = place%stiffness*slope
                    else
                        load = max(2.0_wp*(a**2*acos(c/a) - c*sqrt((a - c)*(a + c))), 0.0_wp)
                        slope = 4.0_wp*a*acos(c/a)
                    end if
                end associate
                loads(i) = load
                if (present(slopes)) slopes(i) = slope
            end do
        end associate
        call halve_lack(levels, count, level, place, loads, slopes)
    end subroutine radius_loads

    !> Sliders follow tangents of first shear, which they do not fall short of anywhere: P of each level less an eighth of what a
    !> chord over it is above it halves the error; less than an eighth where its neighbours are not as far, so that P continues to
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
        s(2) = (levels%power + 1)*place%load/place%shift
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
            slopes(i) = slopes(i) + 0.5_wp*part/(k(3) - k(1))*levels%power*place%stiffness/place%shift* &
                        ((1.0_wp - 2.0_wp*part)*(p(1) + part*(p(3) - p(1)) - p(2)) + part*(1.0_wp - part)*(p(3) - p(1)))
        end do
    end subroutine halve_lack

    !> int (k - k_l) dS from S_l, what springs beyond it carry for each unit of shift and S that grow together from there on; and
    !> its derivative.
    pure subroutine growth_beyond(levels, from, place, load, slope)
        type(levels_t), intent(in) :: levels
        !> S_l, F_l and k_l
        real(wp), intent(in) :: from(3)
        type(place_t), intent(in) :: place
        real(wp), intent(out) :: load, slope

        if (levels%power == by_twist) then
            ! k is proportional to S^3: exact, however small the growth
            associate (x => min(from(1)/place%shift, 1.0_wp))
                load = 0.25_wp*place%stiffness*place%shift*(1.0_wp - x)**2*(1.0_wp + 2.0_wp*x + 3.0_wp*x**2)
            end associate
        else if (levels%of_radius) then
            ! k is proportional to S
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

end module mdrcontact_law_strengths
