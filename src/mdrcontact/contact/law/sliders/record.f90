! SPDX-License-Identifier: GPL-3.0-or-later
!> The memory of the sliders of a contact: the index of each number, and its meaning together with the levels of the law.
module mdrcontact_law_sliders_record
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    implicit none (type, external)
    private
    public :: record_size, is_record, part, stored_energy
    public :: at_law, at_next, at_used, at_shift, at_top, at_lost, at_normal, head

    !> Places in a record: the mark of its law, 0 before the first step; number of the next level above the sliders, 0 for separated
    !> bodies, and of sliders; S; S, F and k at the upper end of the last slider; energy dissipated so far; normal of the tangent
    !> plane, 0 while it is not known. Behind that the levels at the lower ends of the sliders, of which the first has none, and x,
    !> y and z of the sliders' t.
    integer, parameter :: at_law = 1, at_next = 2, at_used = 3, at_shift = 4, at_top = 5, at_lost = 8, at_normal = 9, head = 11

    !> Larger numbers raise an error.
    real(wp), parameter :: largest = 1.0e150_wp

    interface
        !> Whether a record has begun, and is one that a step of the law left.
        ! allow(assumed-size)
        pure function mdrcontact_record_begun(count, sliders, mark, record) result(begun) bind(C)
            import :: c_double, c_int32_t
            integer(c_int32_t), value :: count, sliders
            real(c_double), value :: mark
            real(c_double), intent(in) :: record(*)
            integer(c_int32_t) :: begun
        end function mdrcontact_record_begun
    end interface

contains

    !> Size of a record of a law with a number of sliders.
    pure function record_size(sliders) result(count)
        integer, intent(in) :: sliders
        integer :: count

        count = head + 4*sliders
    end function record_size

    !> Whether numbers are a record of a law with these levels.
    pure function is_record(levels, record) result(valid)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in), contiguous :: record(:)
        logical :: valid

        valid = mdrcontact_record_begun(levels%count, levels%sliders, levels%mark, record) /= 0
        if (valid) return
        valid = all(record(at_next:at_top + 2) == 0.0_wp) .and. all(record(head + 1:) == 0.0_wp) .and. &
                all(abs(record(at_lost:head)) <= largest) .and. (record(at_law) == levels%mark .or. all(record == 0.0_wp))
    end function is_record

    !> The bodies part: what is still stored is lost.
    pure subroutine part(levels, record)
        type(levels_t), intent(in) :: levels
        real(wp), intent(inout), contiguous :: record(:)

        record(at_law) = levels%mark
        record(at_lost) = record(at_lost) + stored_energy(levels, record)
        record(at_next:at_top + 2) = 0.0_wp
        record(head + 1:) = 0.0_wp
    end subroutine part

    !> U, the sum of |t|^2/(2 K).
    pure function stored_energy(levels, record) result(energy)
        type(levels_t), intent(in) :: levels
        real(wp), intent(in), contiguous :: record(:)
        real(wp) :: energy
        real(wp) :: below, above, squared
        integer :: i, used

        energy = 0.0_wp
        if (record(at_next) < 1.0_wp) return
        used = int(record(at_used))
        below = 0.0_wp
        do i = 0, used - 1
            above = record(at_top + 2)
            if (i < used - 1) above = min(levels%stiffness(int(record(head + 2 + i))), above)
            associate (t => record(head + 1 + levels%sliders + i::levels%sliders))
                squared = t(1)**2 + t(2)**2 + t(3)**2
            end associate
            if (above > below) energy = energy + squared/(2.0_wp*(above - below))
            below = above
        end do
    end function stored_energy

end module mdrcontact_law_sliders_record
