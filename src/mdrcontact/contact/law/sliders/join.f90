! SPDX-License-Identifier: GPL-3.0-or-later
!> Sliders of a contact that grows: levels that it passes bring more than its record has room for (theory/friction.md (7.9)).
!>
!> Two sliders become one by adding their loads: T stays and the stored energy falls. Of two neighbours with K1, B1 (the lower) and
!> K2, B2 the one exceeds first shear by at most e = (B1 K2 - K1 B2)/(K1 + K2), at the shift u = (B1 + B2)/(K1 + K2). Under
!> Coulomb's law those with the least e/u are joined: slip of small amplitude keeps its energy; with few sliders it is those with
!> the least e/sqrt(u), and where S is the contact radius with the least e.
module mdrcontact_law_sliders_join
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    use mdrcontact_law_sliders_motion, only: copy_slider, motion_t
    implicit none (type, external)
    private
    public :: join_sliders

    !> Fewer sliders cannot keep the energy of small amplitudes.
    integer, parameter :: few = 12

contains

    !> As many sliders as the record of a law has.
    pure subroutine join_sliders(levels, motion, lost)
        type(levels_t), intent(in) :: levels
        type(motion_t), intent(inout) :: motion
        !> energy, to which is added what is lost
        real(wp), intent(inout) :: lost
        integer :: i

        if (motion%used > 2*levels%sliders) call thin_out(levels, motion, lost)
        do while (motion%used > levels%sliders)
            i = cheapest(levels, motion)
            call add(motion, i, i + 1, lost)
            motion%used = motion%used - 1
            call close_up(motion, i + 1)
        end do
    end subroutine join_sliders

    !> A long step: of its new sliders those remain that are best placed.
    pure subroutine thin_out(levels, motion, lost)
        type(levels_t), intent(in) :: levels
        type(motion_t), intent(inout) :: motion
        real(wp), intent(inout) :: lost
        integer :: i, last

        last = 0
        do i = 1, motion%used - 1
            if (i < motion%before .or. any(levels%places == motion%level(motion%used) - motion%level(i))) then
                last = last + 1
                call copy_slider(motion, i, last)
            else
                call add(motion, last, i, lost)
            end if
        end do
        motion%level(last + 1) = motion%level(motion%used)
        motion%used = last + 1
    end subroutine thin_out

    !> The lower one of the two that are best joined; the last slider has only begun.
    pure function cheapest(levels, motion) result(place)
        type(levels_t), intent(in) :: levels
        type(motion_t), intent(in) :: motion
        integer :: place
        real(wp) :: least, cost, size
        integer :: i

        place = 0
        least = huge(1.0_wp)
        associate (k => motion%stiffness, b => motion%strength)
            do i = 0, motion%used - 3
                size = merge(k(i) + k(i + 1), b(i) + b(i + 1), levels%of_radius)
                if (levels%sliders < few) size = sqrt(size*(k(i) + k(i + 1)))
                cost = (b(i)*k(i + 1) - k(i)*b(i + 1))/max(size, tiny(1.0_wp))
                if (.not. cost < least) cycle
                least = cost
                place = i
            end do
        end associate
    end function cheapest

    !> Slider j is taken in by slider i, whose displacement is not its own.
    pure subroutine add(motion, i, j, lost)
        type(motion_t), intent(inout) :: motion
        integer, intent(in) :: i, j
        real(wp), intent(inout) :: lost

        associate (k => motion%stiffness, t => motion%borne)
            if (k(i) > 0.0_wp .and. k(j) > 0.0_wp) then
                lost = lost + sum((k(j)*t(i, :) - k(i)*t(j, :))**2)/(2.0_wp*k(i)*k(j)*(k(i) + k(j)))
            end if
            t(i, :) = t(i, :) + t(j, :)
            k(i) = k(i) + k(j)
        end associate
        motion%strength(i) = motion%strength(i) + motion%strength(j)
    end subroutine add

    !> The sliders behind one that is gone.
    pure subroutine close_up(motion, gone)
        type(motion_t), intent(inout) :: motion
        integer, intent(in) :: gone
        integer :: i

        do i = gone, motion%used - 1
            call copy_slider(motion, i + 1, i)
        end do
        motion%level(motion%used) = motion%level(motion%used + 1)
    end subroutine close_up

end module mdrcontact_law_sliders_join
