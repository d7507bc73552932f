! SPDX-License-Identifier: GPL-3.0-or-later
!> A table of a law as a row of 64-bit words and back: numbers keep every bit, on any machine.
module mdrcontact_law_words
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_interval, only: coefficient_count, column_count, interval_t, most_bits, panel_count, row_t
    use mdrcontact_law_table, only: law_table_t, most_roots, table_segment_t
    implicit none (type, external)
    private
    public :: put_conductance, put_table, read_conductance, read_table, reader_t, word_count

    !> Words still to be read, and whether all were valid so far.
    type :: reader_t
        integer(int64), allocatable :: words(:)
        integer :: next = 1
        logical :: valid = .true.
    contains
        procedure :: number
        procedure :: whole
    end type reader_t

    integer, parameter :: most_entries = 10000000
    !> Words of a segment, of an interval, and of the polynomials of a panel.
    !> Numbers that continue it below its range.
    integer, parameter :: end_numbers = 5
    integer, parameter :: segment_words = 5, interval_words = 11, row_words = coefficient_count*column_count
    real(wp), parameter :: largest_y = 1.0e12_wp

contains

    !> Number of words for a table.
    pure function word_count(table) result(count)
        type(law_table_t), intent(in) :: table
        integer :: count

        count = 10 + end_numbers + segment_words*size(table%segments) + interval_words*size(table%intervals) + &
                row_words*size(table%other)
    end function word_count

    !> Write a whole table, word_count(table) of them from `next` on, which moves behind them.
    pure subroutine put_table(table, words, next)
        type(law_table_t), intent(in) :: table
        integer(int64), intent(inout) :: words(:)
        integer, intent(inout) :: next
        integer :: i

        words(next:next + 2) = int([merge(1, 0, table%by_depth), merge(1, 0, table%adhesive), merge(1, 0, table%continued)], int64)
        next = next + 3
        words(next:next + 3 + end_numbers) = [transfer([table%first_attraction, table%end_radius, table%lowest, table%highest, &
                                                        table%end_values, table%powers], [0_int64]), int(table%roots, int64)]
        next = next + 4 + end_numbers
        words(next:next + 2) = int([size(table%segments), size(table%intervals), size(table%other)], int64)
        next = next + 3
        do i = 1, size(table%segments)
            associate (s => table%segments(i))
                words(next:next + 2) = transfer([s%lowest, s%highest, s%energy], [0_int64])
                words(next + 3:next + 4) = int([s%first, s%last], int64)
            end associate
            next = next + segment_words
        end do
        do i = 1, size(table%intervals)
            associate (s => table%intervals(i))
                words(next:next + 7) = transfer([s%lowest, s%highest, s%origin, s%side, s%scale, s%offset, s%last_y, &
                                                 s%smallest_root], [0_int64])
                words(next + 8:next + 10) = int([merge(1, 0, s%root), s%bits, s%first_panel], int64)
            end associate
            next = next + interval_words
        end do
        do i = 1, size(table%other)
            words(next:next + row_words - 1) = transfer([table%other(i)%c, table%contact(i)%radius%c, &
                                                         table%contact(i)%stiffness%c], [0_int64])
            next = next + row_words
        end do
    end subroutine put_table

    !> The next word as a finite number.
    function number(self) result(value)
        class(reader_t), intent(inout) :: self
        real(wp) :: value

        value = 0.0_wp
        self%valid = self%valid .and. self%next <= size(self%words)
        if (.not. self%valid) return
        value = transfer(self%words(self%next), value)
        self%next = self%next + 1
        self%valid = is_finite(value)
        if (.not. self%valid) value = 0.0_wp
    end function number

    !> The next word as a whole number between two limits.
    function whole(self, smallest, largest) result(value)
        class(reader_t), intent(inout) :: self
        integer, intent(in) :: smallest, largest
        integer :: value

        value = smallest
        self%valid = self%valid .and. self%next <= size(self%words)
        if (.not. self%valid) return
        self%valid = self%words(self%next) >= smallest .and. self%words(self%next) <= largest
        if (self%valid) value = int(self%words(self%next))
        self%next = self%next + 1
    end function whole

    !> The inverse of put_table; reader%valid is true if the result is valid.
    subroutine read_table(reader, table, error)
        type(reader_t), intent(inout) :: reader
        type(law_table_t), intent(out) :: table
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, segments, intervals, panels, stat

        table%by_depth = reader%whole(0, 1) == 1
        table%adhesive = reader%whole(0, 1) == 1
        table%continued = reader%whole(0, 1) == 1
        table%first_attraction = reader%number()
        table%end_radius = reader%number()
        table%lowest = reader%number()
        table%highest = reader%number()
        do i = 1, size(table%end_values)
            table%end_values(i) = reader%number()
        end do
        do i = 1, size(table%powers)
            table%powers(i) = reader%number()
        end do
        table%roots = reader%whole(0, most_roots)
        segments = reader%whole(1, most_entries)
        intervals = reader%whole(1, most_entries)
        panels = reader%whole(1, most_entries)
        if (size(reader%words) - reader%next + 1 < segment_words*segments + interval_words*intervals + &
            row_words*panels) reader%valid = .false.
        if (.not. reader%valid) return
        allocate (table%segments(segments), table%intervals(intervals), table%other(panels), table%contact(panels), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, segments
            table%segments(i)%lowest = reader%number()
            table%segments(i)%highest = reader%number()
            table%segments(i)%energy = reader%number()
            table%segments(i)%first = reader%whole(1, intervals)
            table%segments(i)%last = reader%whole(table%segments(i)%first, intervals)
        end do
        do i = 1, intervals
            call read_interval(reader, panels, table%intervals(i))
        end do
        do i = 1, panels
            call read_row(reader, table%other(i))
            call read_row(reader, table%contact(i)%radius)
            call read_row(reader, table%contact(i)%stiffness)
        end do
    end subroutine read_table

    !> G of each panel of a table that has it, from `next` on, which moves behind: nothing of other tables.
    pure subroutine put_conductance(table, words, next)
        type(law_table_t), intent(in) :: table
        integer(int64), intent(inout) :: words(:)
        integer, intent(inout) :: next
        integer :: i

        if (.not. allocated(table%conductance)) return
        do i = 1, size(table%conductance)
            words(next:next + coefficient_count - 1) = transfer(table%conductance(i)%c, [0_int64])
            next = next + coefficient_count
        end do
    end subroutine put_conductance

    !> The inverse, of all words that are left.
    subroutine read_conductance(reader, table, error)
        type(reader_t), intent(inout) :: reader
        type(law_table_t), intent(inout) :: table
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, stat

        if (.not. reader%valid .or. reader%next > size(reader%words)) return
        reader%valid = size(reader%words) - reader%next + 1 == coefficient_count*size(table%other)
        if (.not. reader%valid) return
        allocate (table%conductance(size(table%other)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(table%conductance)
            call read_row(reader, table%conductance(i))
        end do
    end subroutine read_conductance

    subroutine read_row(reader, row)
        type(reader_t), intent(inout) :: reader
        type(row_t), intent(out) :: row
        integer :: i

        do i = 1, coefficient_count
            row%c(i) = reader%number()
        end do
    end subroutine read_row

    subroutine read_interval(reader, panels, interval)
        type(reader_t), intent(inout) :: reader
        integer, intent(in) :: panels
        type(interval_t), intent(out) :: interval

        interval%lowest = reader%number()
        interval%highest = reader%number()
        interval%origin = reader%number()
        interval%side = reader%number()
        interval%scale = reader%number()
        interval%offset = reader%number()
        interval%last_y = reader%number()
        interval%smallest_root = reader%number()
        interval%root = reader%whole(0, 1) == 1
        interval%bits = reader%whole(0, most_bits)
        interval%first_panel = reader%whole(0, panels - 1)
        ! No damage may lead outside the coefficients.
        reader%valid = reader%valid .and. interval%last_y >= 1.0_wp .and. interval%last_y < largest_y
        if (reader%valid) reader%valid = panel_count(interval) <= panels - interval%first_panel
    end subroutine read_interval

end module mdrcontact_law_words
