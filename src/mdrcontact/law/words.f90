! SPDX-License-Identifier: GPL-3.0-or-later
!> A table of a law as a row of 64-bit words and back: numbers keep every bit, on any machine.
module mdrcontact_law_words
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_segment, only: coefficient_count, column_count, most_bits, panel_count, segment_t
    use mdrcontact_law_table, only: law_table_t, table_stretch_t
    implicit none (type, external)
    private
    public :: table_words, read_table, reader_t

    !> Words still to be read, and whether all were sound so far.
    type :: reader_t
        integer(int64), allocatable :: words(:)
        integer :: next = 1
        logical :: sound = .true.
    contains
        procedure :: number
        procedure :: whole
    end type reader_t

    integer, parameter :: most_entries = 10000000
    real(wp), parameter :: largest_y = 1.0e12_wp

contains

    !> All of a table.
    pure function table_words(table) result(words)
        type(law_table_t), intent(in) :: table
        integer(int64), allocatable :: words(:)
        integer :: i

        allocate (words(0))
        words = [int([merge(1, 0, table%by_depth), merge(1, 0, table%adhesive)], int64), &
                 of_reals([table%end_radius, table%lowest, table%highest, table%end_values, table%powers]), &
                 int([size(table%stretches), size(table%segments), size(table%coefficients, 3)], int64)]
        do i = 1, size(table%stretches)
            associate (s => table%stretches(i))
                words = [words, of_reals([s%lowest, s%highest]), int([s%first, s%last], int64)]
            end associate
        end do
        do i = 1, size(table%segments)
            associate (s => table%segments(i))
                words = [words, of_reals([s%lowest, s%highest, s%origin, s%side, s%scale, s%offset, s%last_y, s%smallest_root]), &
                         int([merge(1, 0, s%root), s%bits, s%first_panel], int64)]
            end associate
        end do
        words = [words, of_reals(reshape(table%coefficients, [size(table%coefficients)]))]
    end function table_words

    pure function of_reals(values) result(words)
        real(wp), intent(in) :: values(:)
        integer(int64) :: words(size(values))

        words = transfer(values, words)
    end function of_reals

    !> The next word as a finite number.
    function number(self) result(value)
        class(reader_t), intent(inout) :: self
        real(wp) :: value

        value = 0.0_wp
        self%sound = self%sound .and. self%next <= size(self%words)
        if (.not. self%sound) return
        value = transfer(self%words(self%next), value)
        self%next = self%next + 1
        self%sound = ieee_is_finite(value)
        if (.not. self%sound) value = 0.0_wp
    end function number

    !> The next word as a whole number between two limits.
    function whole(self, smallest, largest) result(value)
        class(reader_t), intent(inout) :: self
        integer, intent(in) :: smallest, largest
        integer :: value

        value = smallest
        self%sound = self%sound .and. self%next <= size(self%words)
        if (.not. self%sound) return
        self%sound = self%words(self%next) >= smallest .and. self%words(self%next) <= largest
        if (self%sound) value = int(self%words(self%next))
        self%next = self%next + 1
    end function whole

    !> The inverse of table_words; reader%sound tells whether the result can be used.
    subroutine read_table(reader, table)
        type(reader_t), intent(inout) :: reader
        type(law_table_t), intent(out) :: table
        integer :: i, j, k, stretches, segments, panels

        table%by_depth = reader%whole(0, 1) == 1
        table%adhesive = reader%whole(0, 1) == 1
        table%end_radius = reader%number()
        table%lowest = reader%number()
        table%highest = reader%number()
        do i = 1, column_count
            table%end_values(i) = reader%number()
        end do
        do i = 1, column_count
            table%powers(i) = reader%number()
        end do
        stretches = reader%whole(1, most_entries)
        segments = reader%whole(1, most_entries)
        panels = reader%whole(1, most_entries)
        if (size(reader%words) - reader%next + 1 < 4*stretches + 11*segments + coefficient_count*column_count*panels) then
            reader%sound = .false.
        end if
        if (.not. reader%sound) return
        allocate (table%stretches(stretches), table%segments(segments))
        allocate (table%coefficients(coefficient_count, column_count, panels))
        do i = 1, stretches
            table%stretches(i)%lowest = reader%number()
            table%stretches(i)%highest = reader%number()
            table%stretches(i)%first = reader%whole(1, segments)
            table%stretches(i)%last = reader%whole(table%stretches(i)%first, segments)
        end do
        do i = 1, segments
            call read_segment(reader, panels, table%segments(i))
        end do
        do k = 1, panels
            do j = 1, column_count
                do i = 1, coefficient_count
                    table%coefficients(i, j, k) = reader%number()
                end do
            end do
        end do
    end subroutine read_table

    subroutine read_segment(reader, panels, segment)
        type(reader_t), intent(inout) :: reader
        integer, intent(in) :: panels
        type(segment_t), intent(out) :: segment

        segment%lowest = reader%number()
        segment%highest = reader%number()
        segment%origin = reader%number()
        segment%side = reader%number()
        segment%scale = reader%number()
        segment%offset = reader%number()
        segment%last_y = reader%number()
        segment%smallest_root = reader%number()
        segment%root = reader%whole(0, 1) == 1
        segment%bits = reader%whole(0, most_bits)
        segment%first_panel = reader%whole(0, panels - 1)
        ! No damage may lead outside the coefficients.
        reader%sound = reader%sound .and. segment%last_y >= 1.0_wp .and. segment%last_y < largest_y
        if (reader%sound) reader%sound = panel_count(segment) <= panels - segment%first_panel
    end subroutine read_segment

end module mdrcontact_law_words
