! SPDX-License-Identifier: GPL-3.0-or-later
!> Sliders of a contact that shrinks: those that it leaves, and the core, which is divided again.
module mdrcontact_law_sliders_shrink
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t, load_beyond, share_of
    use mdrcontact_law_sliders_record, only: at_base, at_top, at_used, head
    implicit none (type, external)
    private
    public :: shrink

contains

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

end module mdrcontact_law_sliders_shrink
