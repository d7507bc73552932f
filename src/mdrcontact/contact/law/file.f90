! SPDX-License-Identifier: GPL-3.0-or-later
!> A compiled law, with or without friction, as a file: a first line that names the format and its version, the problem it was made
!> from as text, the numbers in hexadecimal (every bit, on any machine), and a checksum.
module mdrcontact_law_file
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_crc32, only: crc32_text
    use mdrcontact_error, only: check_made, check_memory, count_text, error_file, error_t, explain, raise
    use mdrcontact_file, only: path_length, read_file, write_file
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_friction, only: find_levels, friction_law_t
    use mdrcontact_law_interval, only: coefficient_count
    use mdrcontact_law_levels, only: allocate_shares, count_shares, fewest_sliders, most_sliders, share_index, share_nodes
    use mdrcontact_law_validate, only: is_valid
    use mdrcontact_law_table, only: add_energies, find_direct
    use mdrcontact_law_words, only: put_conductance, put_table, read_conductance, read_table, reader_t, word_count
    implicit none (type, external)
    private
    public :: save_law, load_law, law_to_text, law_from_text

    character(len=*), parameter :: new_line_character = achar(10)
    character(len=*), parameter :: title = "mdrcontact compiled contact law, format ", version = "5"
    !> First line of files of former versions, in which laws with friction were separate.
    character(len=*), parameter :: former_title = "mdrcontact compiled friction law, format "
    !> Numbers of a law in addition to its two tables and its friction; those of its friction in addition to tables and shares, and
    !> those in their place where the shear strength is constant.
    integer, parameter :: own_numbers = 5, friction_numbers = 4, radius_numbers = 3
    !> A larger coefficient of a share is not valid.
    real(wp), parameter :: largest_share = 1.0e3_wp
    character(len=*), parameter :: of_description = " characters of description, then ", of_numbers = " numbers"
    character(len=*), parameter :: checksum_name = "crc32 "
    integer, parameter :: word_length = 17, checksum_line = len(checksum_name) + 8 + 1

contains

    !> Writes a law to a file, which it replaces; when anything goes wrong the file stays as it was.
    subroutine save_law(law, path, error)
        type(contact_law_t), intent(in) :: law
        !> name of the file. Trailing blanks do not count, as in Fortran's open; a null character ends a name in which they do
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text

        call check_made(error, "law", law%is_made)
        if (allocated(error)) return
        call law_to_text(law, text, error)
        if (.not. allocated(error)) call write_file(path, text, error)
    end subroutine save_law

    !> Reads a law from a file.
    subroutine load_law(law, path, error)
        type(contact_law_t), intent(out) :: law
        !> name of the file, as in save_law
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text

        call read_file(path, text, error)
        if (allocated(error)) return
        call law_from_text(law, text, error)
        if (allocated(error)) call explain(error, "", " (the file "//path(:path_length(path))//")")
    end subroutine load_law

    !> The content of a law's file.
    pure subroutine law_to_text(law, text, error)
        type(contact_law_t), intent(in) :: law
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        integer(int64), allocatable :: words(:)
        integer :: count, next, stat

        count = own_numbers + word_count(law%by_depth) + word_count(law%by_force)
        if (allocated(law%friction)) count = count + friction_count(law%friction)
        next = count + 1
        if (allocated(law%by_depth%conductance)) count = count + coefficient_count*size(law%by_depth%conductance)
        allocate (words(count), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call put_conductance(law%by_depth, words, next)
        words(:3) = [transfer([law%tolerance, law%error], [0_int64]), int(law%solutions, int64)]
        next = 4
        call put_table(law%by_depth, words, next)
        call put_table(law%by_force, words, next)
        words(next:next + 1) = [transfer(law%radius, 0_int64), 0_int64]
        if (allocated(law%friction)) call put_friction(law%friction, words, next + 1)
        call frame(words, law%description, text, error)
    end subroutine law_to_text

    !> Number of words for the friction of a law; the first of them, the number of sliders, is 0 if it does not exist, and negative
    !> where they are twisted.
    pure function friction_count(friction) result(count)
        type(friction_law_t), intent(in) :: friction
        integer :: count

        count = friction_numbers + radius_numbers
        if (friction%levels%of_radius) return
        count = friction_numbers + 1 + word_count(friction%by_shift) + word_count(friction%by_force)
        if (allocated(friction%levels%share)) count = count + share_nodes*count_shares(friction%levels)
    end function friction_count

    pure subroutine put_friction(friction, words, first)
        type(friction_law_t), intent(in) :: friction
        integer(int64), intent(inout) :: words(:)
        integer, intent(in) :: first
        integer :: next, m, l

        words(first) = int(merge(-friction%sliders, friction%sliders, friction%cubic > 0.0_wp), int64)
        words(first + 1:first + 4) = transfer([friction%coefficient, max(friction%shear_strength, friction%cubic), &
                                               friction%first_shear_error, friction%path_error], [0_int64])
        next = first + 1 + friction_numbers
        if (friction%levels%of_radius) then
            words(next:next + radius_numbers - 1) = transfer([friction%modulus, friction%radii], [0_int64])
            return
        end if
        call put_table(friction%by_shift, words, next)
        call put_table(friction%by_force, words, next)
        words(next) = 0_int64
        if (.not. allocated(friction%levels%share)) return
        words(next) = int(share_nodes*count_shares(friction%levels), int64)
        next = next + 1
        do m = 1, friction%levels%count
            do l = share_index(1, m), share_index(m, m)
                words(next:next + share_nodes - 1) = transfer(friction%levels%share(:share_nodes, l), [0_int64])
                next = next + share_nodes
            end do
        end do
    end subroutine put_friction

    !> The law in a file's content.
    subroutine law_from_text(law, text, error)
        type(contact_law_t), intent(out) :: law
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(out) :: error
        type(reader_t) :: reader
        real(wp), allocatable :: shares(:)

        call check_frame(text, error)
        if (allocated(error)) return
        call read_words(text, law%description, reader%words, error)
        if (allocated(error)) return
        law%tolerance = reader%number()
        law%error = reader%number()
        law%solutions = reader%whole(0, huge(1))
        call read_table(reader, law%by_depth, error)
        if (reader%valid .and. .not. allocated(error)) call read_table(reader, law%by_force, error)
        if (allocated(error)) return
        law%radius = reader%number()
        call read_friction(reader, law%friction, shares, error)
        if (.not. allocated(error)) call read_conductance(reader, law%by_depth, error)
        if (allocated(error)) return
        reader%valid = reader%valid .and. law%radius >= 0.0_wp .and. reader%next == size(reader%words) + 1
        if (reader%valid) reader%valid = is_valid(law)
        if (.not. reader%valid) then
            call raise_invalid_law(error)
            return
        end if
        call add_energies(law%by_depth)
        call find_direct(law%by_depth)
        call find_direct(law%by_force)
        if (allocated(law%friction)) then
            law%friction%continued = law%by_depth%continued
            call close_friction(law%friction, shares, error)
        end if
        law%is_made = .not. allocated(error)
    end subroutine law_from_text

    !> The friction of a law, not allocated if it has none, but for its levels; and the shares of springs that interact, none of
    !> other laws.
    subroutine read_friction(reader, friction, shares, error)
        type(reader_t), intent(inout) :: reader
        type(friction_law_t), allocatable, intent(out) :: friction
        real(wp), allocatable, intent(out) :: shares(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: sliders, i, stat

        allocate (shares(0))
        sliders = reader%whole(-most_sliders, most_sliders)
        if (.not. reader%valid .or. sliders == 0) return
        allocate (friction)
        reader%valid = abs(sliders) >= fewest_sliders
        friction%sliders = abs(sliders)
        friction%coefficient = reader%number()
        if (sliders < 0) then
            friction%cubic = reader%number()
            reader%valid = reader%valid .and. friction%cubic > 0.0_wp
        else
            friction%shear_strength = reader%number()
        end if
        friction%first_shear_error = reader%number()
        friction%path_error = reader%number()
        if (max(friction%shear_strength, friction%cubic) > 0.0_wp) then
            friction%modulus = reader%number()
            friction%radii(1) = reader%number()
            friction%radii(2) = reader%number()
            return
        end if
        if (reader%valid) call read_table(reader, friction%by_shift, error)
        if (reader%valid .and. .not. allocated(error)) call read_table(reader, friction%by_force, error)
        if (allocated(error)) return
        deallocate (shares)
        allocate (shares(reader%whole(0, size(reader%words))), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(shares)
            shares(i) = reader%number()
            reader%valid = reader%valid .and. abs(shares(i)) <= largest_share
        end do
    end subroutine read_friction

    !> Quantities derived from the numbers of a law's friction.
    subroutine close_friction(friction, shares, error)
        type(friction_law_t), intent(inout) :: friction
        real(wp), intent(in) :: shares(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat, next, m

        if (.not. max(friction%shear_strength, friction%cubic) > 0.0_wp) then
            call find_direct(friction%by_shift)
            call find_direct(friction%by_force)
        end if
        call find_levels(friction, size(shares) > 0)
        friction%is_made = size(shares) == 0
        if (friction%is_made) return
        if (size(shares) /= share_nodes*count_shares(friction%levels)) then
            call raise_invalid_law(error)
            return
        end if
        call allocate_shares(friction%levels, stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        next = 1
        do m = 1, friction%levels%count
            friction%levels%share(:share_nodes, share_index(1, m):share_index(m, m)) = &
                reshape(shares(next:next + share_nodes*m - 1), [share_nodes, m])
            next = next + share_nodes*m
        end do
        friction%is_made = .true.
    end subroutine close_friction

    pure subroutine raise_invalid_law(error)
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_file, "its numbers do not describe a contact law")
    end subroutine raise_invalid_law

    !> First line, description, numbers and checksum.
    pure subroutine frame(words, description, text, error)
        integer(int64), intent(in) :: words(:)
        character(len=*), intent(in) :: description
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        character(len=:), allocatable :: first_line
        integer :: i, start, stat

        first_line = title//version//new_line_character//count_text(len(description))// &
                     of_description//count_text(size(words))//of_numbers//new_line_character
        start = len(first_line) + len(description) + 1
        allocate (character(len=start + word_length*size(words) + 1 + checksum_line) :: text, stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        text(:len(first_line)) = first_line
        text(len(first_line) + 1:start - 1) = description
        text(start:start) = new_line_character
        do i = 1, size(words)
            write (text(start + 1:start + word_length), "(z16.16, a)") words(i), merge(new_line_character, " ", modulo(i, 8) == 0)
            start = start + word_length
        end do
        text(start + 1:start + 1) = new_line_character
        text(start + 2:) = checksum_name//crc32_text(text(:start + 1))//new_line_character
    end subroutine frame

    !> Title, version and checksum.
    pure subroutine check_frame(text, error)
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(inout) :: error
        integer :: line_end, body

        body = len(text) - checksum_line
        line_end = index(text, new_line_character)
        if (line_end == 0) line_end = len(text) + 1
        if (index(text, former_title) == 1) then
            call raise(error, error_file, "it contains a law with friction of an earlier version of the library. Create it again")
        else if (index(text, title) /= 1) then
            call raise(error, error_file, "it is not a compiled contact law of mdrcontact")
        else if (text(len(title) + 1:line_end - 1) /= version) then
            call raise(error, error_file, "its format has version "//text(len(title) + 1:min(line_end - 1, len(title) + 20))// &
                       ", and this library reads version "//version//". Create it again")
        else if (body < line_end) then
            call raise(error, error_file, "it is truncated")
        else if (text(body + 1:body + len(checksum_name)) /= checksum_name .or. text(len(text):) /= new_line_character) then
            call raise(error, error_file, "its checksum is missing, so it is truncated or modified")
        else if (text(len(text) - 8:len(text) - 1) /= crc32_text(text(:body))) then
            call raise(error, error_file, "its checksum does not match its content: it is damaged")
        end if
    end subroutine check_frame

    !> Description and numbers of a text whose frame is valid.
    subroutine read_words(text, description, words, error)
        character(len=*), intent(in) :: text
        character(len=:), allocatable, intent(out) :: description
        integer(int64), allocatable, intent(out) :: words(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: start, length, count, middle, line_end, i, stat

        start = index(text, new_line_character) + 1
        line_end = start + index(text(start:), new_line_character) - 1
        middle = start + index(text(start:line_end), of_description) - 1
        stat = 1
        if (middle > start) call read_count(text(start:middle - 1), length, stat)
        if (stat == 0) then
            start = middle + len(of_description)
            middle = line_end - len(of_numbers)
            call read_count(text(start:middle - 1), count, stat)
            if (text(middle:line_end - 1) /= of_numbers) stat = 1
        end if
        if (stat == 0) then
            start = line_end + 1
            if (length < 0 .or. count < 1 .or. length > len(text) - start .or. count > len(text)/word_length) stat = 1
        end if
        if (stat == 0) then
            if (start + length + 1 + word_length*count > len(text)) stat = 1
        end if
        if (stat == 0) then
            allocate (character(len=length) :: description, stat=stat)
            if (stat == 0) allocate (words(count), stat=stat)
            call check_memory(error, stat)
            if (allocated(error)) return
            description = text(start:start + length - 1)
            start = start + length + 1
            do i = 1, count
                read (text(start:start + 15), "(z16)", iostat=stat) words(i)
                if (stat /= 0) exit
                start = start + word_length
            end do
        end if
        if (stat /= 0) call raise(error, error_file, "its numbers cannot be read")
    end subroutine read_words

    !> A whole number of digits alone: a list-directed read takes more than these, and gfortran's leaks memory where it fails.
    pure subroutine read_count(digits, count, stat)
        character(len=*), intent(in) :: digits
        integer, intent(out) :: count, stat

        count = 0
        stat = 1
        if (len(digits) == 0 .or. len(digits) > 9 .or. verify(digits, "0123456789") > 0) return
        read (digits, "(i9)", iostat=stat) count
        if (stat /= 0) count = 0
    end subroutine read_count

end module mdrcontact_law_file
