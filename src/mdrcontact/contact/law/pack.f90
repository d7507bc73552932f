! SPDX-License-Identifier: GPL-3.0-or-later
!> A law as one array of numbers without addresses, which include/mdrcontact_law.h evaluates wherever the array lies.
module mdrcontact_law_pack
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_codes, only: law_format, on_loading, on_unloading
    use mdrcontact_law_evaluate, only: last_open
    use mdrcontact_law_interval, only: coefficient_count, interval_t
    use mdrcontact_law_table, only: law_table_t, table_segment_t
    implicit none (type, external)
    private
    public :: packed_size, pack_table

    !> Numbers of struct mdr_law_head, mdr_law_segment, mdr_law_interval, and of a panel: of F, of a and k, of the energy. F begins
    !> at a multiple of the first.
    integer, parameter :: row = coefficient_count, head_size = 23, segment_size = 4, interval_size = 11

contains

    !> Count of numbers that pack_table writes.
    pure function packed_size(table) result(size_of_all)
        !> by depth
        type(law_table_t), intent(in) :: table
        integer :: size_of_all

        size_of_all = force_place(table) + (3*row + 1)*size(table%other)
        if (allocated(table%conductance)) size_of_all = conductance_place(table) + row*size(table%other)
    end function packed_size

    !> Where those of G begin, behind the energies.
    pure function conductance_place(table) result(place)
        type(law_table_t), intent(in) :: table
        integer :: place

        place = row*((force_place(table) + (3*row + 1)*size(table%other) + row - 1)/row)
    end function conductance_place

    !> Where the polynomials begin, counted from 0.
    pure function force_place(table) result(place)
        type(law_table_t), intent(in) :: table
        integer :: place

        place = row*((head_size + segment_size*size(table%segments) + interval_size*size(table%intervals) + row - 1)/row)
    end function force_place

    !> The table as the header reads it.
    pure subroutine pack_table(table, buffer)
        !> by depth
        type(law_table_t), intent(in) :: table
        !> [packed_size(table)]
        real(c_double), intent(out) :: buffer(:)
        integer :: i, panels, force, contact, energy, intervals, conductance

        panels = size(table%other)
        intervals = head_size + segment_size*size(table%segments)
        force = force_place(table)
        contact = force + row*panels
        energy = contact + 2*row*panels
        buffer = 0.0_c_double
        buffer(:head_size) = [real([law_format, packed_size(table), merge(1, 0, table%adhesive), merge(1, 0, table%continued)], &
                                   c_double), table%end_radius, table%lowest, table%highest, last_open(table, on_loading), &
                              last_open(table, on_unloading), table%end_values, table%powers, &
                              real([table%roots, direct_of(table), size(table%segments), head_size, size(table%intervals), &
                                    intervals, panels, force, contact, energy], c_double)]
        do i = 1, size(table%segments)
            buffer(head_size + segment_size*(i - 1) + 1:head_size + segment_size*i) = numbers_of_segment(table%segments(i))
        end do
        do i = 1, size(table%intervals)
            buffer(intervals + interval_size*(i - 1) + 1:intervals + interval_size*i) = numbers_of_interval(table%intervals(i))
        end do
        do i = 1, panels
            buffer(force + row*(i - 1) + 1:force + row*i) = table%other(i)%c
            buffer(contact + 2*row*(i - 1) + 1:contact + 2*row*i) = [table%contact(i)%radius%c, table%contact(i)%stiffness%c]
        end do
        buffer(energy + 1:energy + panels) = table%energy
        if (.not. allocated(table%conductance)) return
        conductance = conductance_place(table)
        do i = 1, panels
            buffer(conductance + row*(i - 1) + 1:conductance + row*i) = table%conductance(i)%c
        end do
    end subroutine pack_table

    !> Index, from 0, of the interval that needs no root search; -1: none.
    pure function direct_of(table) result(number)
        type(law_table_t), intent(in) :: table
        integer :: number

        number = merge(0, -1, table%direct%lowest <= table%direct%highest)
    end function direct_of

    !> struct mdr_law_segment; intervals are counted from 0.
    pure function numbers_of_segment(segment) result(numbers)
        type(table_segment_t), intent(in) :: segment
        real(c_double) :: numbers(segment_size)

        numbers = [segment%lowest, segment%highest, real([segment%first - 1, segment%last - 1], c_double)]
    end function numbers_of_segment

    !> struct mdr_law_interval
    pure function numbers_of_interval(interval) result(numbers)
        type(interval_t), intent(in) :: interval
        real(c_double) :: numbers(interval_size)

        numbers = [interval%lowest, interval%highest, interval%scale, interval%offset, interval%last_y, &
                   merge(1.0_c_double, 0.0_c_double, interval%root), interval%origin, interval%side, interval%smallest_root, &
                   real([interval%bits, interval%first_panel], c_double)]
    end function numbers_of_interval

end module mdrcontact_law_pack
