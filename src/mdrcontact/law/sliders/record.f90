! SPDX-License-Identifier: GPL-3.0-or-later
!> What a contact remembers of its sliders: where each number stands, and what it means together with the levels of the law.
module mdrcontact_law_sliders_record
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    implicit none (type, external)
    private
    public :: record_size, is_record, part, stored_energy, stiffness_of
    public :: at_law, at_base, at_used, at_shift, at_top, at_lost, at_normal, head

    !> Places in a record: the mark of its law, 0 before the first step; number of the level below which all is the core, 0 where
    !> the bodies are apart, and of sliders; S; S, F and k at the upper end of the last slider; energy dissipated so far;
    !> normal of the tangent plane, 0 while it is not known; x, y and z of the sliders' t follow.
    integer, parameter :: at_law = 1, at_base = 2, at_used = 3, at_shift = 4, at_top = 5, at_lost = 8, at_normal = 9, head = 11

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

    !> K of a slider where k is `top` at the upper end of the last one.
    pure function stiffness_of(levels, base, i, top) result(stiffness)
        type(levels_t), intent(in) :: levels
        integer, intent(in) :: base, i
        real(wp), intent(in) :: top
        real(wp) :: stiffness

        stiffness = min(levels%stiffness(base + i), top)
        if (i > 0) stiffness = stiffness - min(levels%stiffness(base + i - 1), top)
    end function stiffness_of

end module mdrcontact_law_sliders_record
