! SPDX-License-Identifier: GPL-3.0-or-later
!> A compiled law, of a contact or with friction, as a file: a first line that names the format and its version, the problem it was
!> made from in words, the numbers in hexadecimal (every bit, on any machine), and a checksum.
module mdrcontact_law_file
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_error, only: explain, check_memory, count_text, error_file, error_t, raise
    use mdrcontact_file, only: path_length, read_file, write_file
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_crc32, only: crc32_text
    use mdrcontact_law_friction, only: find_levels, friction_law_t
    use mdrcontact_law_levels, only: fewest_sliders, most_sliders, share_index, share_nodes
    use mdrcontact_law_sound, only: is_sound
    use mdrcontact_law_table, only: add_energies, find_direct
    use mdrcontact_law_words, only: put_table, read_table, reader_t, word_count
    implicit none (type, external)
    private
    public :: save_law, load_law, law_to_text, law_from_text

    character(len=*), parameter :: new_line_character = achar(10)
    character(len=*), parameter :: kinds(2) = ["contact ", "friction"]
    integer, parameter :: of_contact = 1, of_friction = 2
    !> Numbers of a law with friction beside its tables and shares.
    integer, parameter :: own_numbers = 5
    !> A coefficient of a share that is larger is none.
    real(wp), parameter :: largest_share = 1.0e3_wp
    character(len=*), parameter :: versions(2) = ["2", "3"]
    character(len=*), parameter :: of_description = " characters of description, then ", of_numbers = " numbers"
    character(len=*), parameter :: checksum_name = "crc32 "
    integer, parameter :: word_length = 17, checksum_line = len(checksum_name) + 8 + 1

    !> Writes a law to a file, which it replaces; when anything goes wrong the file stays as it was.
    interface save_law
        module procedure save_contact_law, save_friction_law
    end interface save_law

    !> Reads a law from a file.
    interface load_law
        module procedure load_contact_law, load_friction_law
    end interface load_law

    !> The content of a law's file.
    interface law_to_text
        module procedure contact_law_to_text, friction_law_to_text
    end interface law_to_text

    !> The law in a file's content.
    interface law_from_text
        module procedure contact_law_from_text, friction_law_from_text
    end interface law_from_text

contains

    subroutine save_contact_law(law, path, error)
        type(contact_law_t), intent(in) :: law
        !> name of the file. Trailing blanks do not count, as in Fortran's open; a null character ends a name in which they do
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text

        call law_to_text(law, text, error)
        if (.not. allocated(error)) call write_file(path, text, error)
    end subroutine save_contact_law

    subroutine save_friction_law(law, path, error)
        type(friction_law_t), intent(in) :: law
        !> as above
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text

        call law_to_text(law, text, error)
        if (.not. allocated(error)) call write_file(path, text, error)
    end subroutine save_friction_law

    subroutine load_contact_law(law, path, error)
        type(contact_law_t), intent(out) :: law
        !> name of the file, as in save_law
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text

        call read_file(path, text, error)
        if (allocated(error)) return
        call law_from_text(law, text, error)
        if (allocated(error)) call explain(error, "the file "//path(:path_length(path))//" is refused: ", "")
    end subroutine load_contact_law

    subroutine load_friction_law(law, path, error)
        type(friction_law_t), intent(out) :: law
        !> name of the file, as in save_law
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text

        call read_file(path, text, error)
        if (allocated(error)) return
        call law_from_text(law, text, error)
        if (allocated(error)) call explain(error, "the file "//path(:path_length(path))//" is refused: ", "")
    end subroutine load_friction_law

    pure subroutine contact_law_to_text(law, text, error)
        type(contact_law_t), intent(in) :: law
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error

        call put(law, [real(wp) ::], of_contact, text, error)
    end subroutine contact_law_to_text

    pure subroutine friction_law_to_text(law, text, error)
        type(friction_law_t), intent(in) :: law
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error

        real(wp), allocatable :: more(:)
        integer :: stat, shares

        shares = 0
        if (allocated(law%levels%share)) shares = size(law%levels%share)
        allocate (more(own_numbers + shares), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        more(:own_numbers) = [real(law%sliders, wp), law%coefficient, law%first_shear_error, law%path_error, real(shares, wp)]
        if (shares > 0) more(own_numbers + 1:) = reshape(transpose(law%levels%share), [shares])
        call put(law%law, more, of_friction, text, error)
    end subroutine friction_law_to_text

    subroutine contact_law_from_text(law, text, error)
        type(contact_law_t), intent(out) :: law
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(out) :: error
        type(reader_t) :: reader

        call get(law, reader, of_contact, text, error)
        if (.not. allocated(error)) call close_law(law, reader, error)
    end subroutine contact_law_from_text

    subroutine friction_law_from_text(law, text, error)
        type(friction_law_t), intent(out) :: law
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(out) :: error
        type(reader_t) :: reader
        real(wp), allocatable :: shares(:)

        allocate (law%law)
        call get(law%law, reader, of_friction, text, error)
        if (allocated(error)) return
        law%sliders = read_whole_number(reader, fewest_sliders, most_sliders)
        law%coefficient = reader%number()
        law%first_shear_error = reader%number()
        law%path_error = reader%number()
        call read_shares(reader, shares, error)
        if (allocated(error)) return
        reader%sound = reader%sound .and. law%coefficient > 0.0_wp .and. .not. law%law%by_depth%adhesive
        call close_law(law%law, reader, error)
        if (allocated(error)) return
        call find_levels(law)
        if (size(shares) == 0) return
        associate (count => share_index(law%levels%count, law%levels%count))
            if (size(shares) == share_nodes*count) then
                law%levels%share = reshape(shares, [count, share_nodes], order=[2, 1])
            else
                call raise_unsound(error)
            end if
        end associate
    end subroutine friction_law_from_text

    !> A number between two limits that is whole.
    function read_whole_number(reader, smallest, largest) result(whole)
        type(reader_t), intent(inout) :: reader
        integer, intent(in) :: smallest, largest
        integer :: whole
        real(wp) :: value

        value = reader%number()
        reader%sound = reader%sound .and. value >= smallest .and. value <= largest
        whole = smallest
        if (reader%sound) whole = int(value)
        reader%sound = reader%sound .and. abs(value - whole) < 0.5_wp
    end function read_whole_number

    !> The shares of springs that interact, none of other laws.
    subroutine read_shares(reader, shares, error)
        type(reader_t), intent(inout) :: reader
        real(wp), allocatable, intent(out) :: shares(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, stat

        allocate (shares(read_whole_number(reader, 0, size(reader%words))), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(shares)
            shares(i) = reader%number()
            reader%sound = reader%sound .and. abs(shares(i)) <= largest_share
        end do
    end subroutine read_shares

    !> Tables, and the numbers that a kind of law has beside them.
    pure subroutine put(law, more, kind, text, error)
        type(contact_law_t), intent(in) :: law
        real(wp), intent(in) :: more(:)
        integer, intent(in) :: kind
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        integer(int64), allocatable :: words(:)
        character(len=:), allocatable :: title, first_line
        integer :: i, start, stat, count

        count = 3 + word_count(law%by_depth) + word_count(law%by_force) + size(more)
        if (kind == of_friction .or. law%radius > 0.0_wp) count = count + 1
        allocate (words(count), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        words(:3) = [transfer([law%tolerance, law%error], [0_int64]), int(law%solutions, int64)]
        call put_table(law%by_depth, words(4:))
        call put_table(law%by_force, words(4 + word_count(law%by_depth):))
        if (kind == of_friction .or. law%radius > 0.0_wp) words(count - size(more)) = transfer(law%radius, 0_int64)
        words(count - size(more) + 1:) = transfer(more, [0_int64], size(more))
        call make_title(kind, title)
        first_line = title//versions(kind)//new_line_character//count_text(len(law%description))// &
                     of_description//count_text(size(words))//of_numbers//new_line_character
        start = len(first_line) + len(law%description) + 1
        allocate (character(len=start + word_length*size(words) + 1 + checksum_line) :: text, stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        text(:len(first_line)) = first_line
        text(len(first_line) + 1:start - 1) = law%description
        text(start:start) = new_line_character
        do i = 1, size(words)
            write (text(start + 1:start + word_length), "(z16.16, a)") words(i), merge(new_line_character, " ", modulo(i, 8) == 0)
            start = start + word_length
        end do
        text(start + 1:start + 1) = new_line_character
        text(start + 2:) = checksum_name//crc32_text(text(:start + 1))//new_line_character
    end subroutine put

    !> The inverse of put, up to the numbers that a kind of law has beside its tables.
    subroutine get(law, reader, kind, text, error)
        type(contact_law_t), intent(out) :: law
        type(reader_t), intent(out) :: reader
        integer, intent(in) :: kind
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(out) :: error
        integer :: start

        call check_frame(text, kind, error)
        if (allocated(error)) return
        call read_words(text, law%description, reader%words, start, error)
        if (allocated(error)) return
        law%tolerance = reader%number()
        law%error = reader%number()
        law%solutions = reader%whole(0, huge(1))
        call read_table(reader, law%by_depth, error)
        if (reader%sound .and. .not. allocated(error)) call read_table(reader, law%by_force, error)
        if (allocated(error)) return
        ! a contact's law has the radius for a paraboloid only
        if (.not. reader%sound .or. kind == of_contact .and. reader%next > size(reader%words)) return
        law%radius = reader%number()
        reader%sound = reader%sound .and. (law%radius > 0.0_wp .or. kind == of_friction)
    end subroutine get

    !> A law of which all has been read.
    subroutine close_law(law, reader, error)
        type(contact_law_t), intent(inout) :: law
        type(reader_t), intent(inout) :: reader
        type(error_t), allocatable, intent(inout) :: error

        if (reader%sound) reader%sound = reader%next == size(reader%words) + 1
        if (reader%sound) reader%sound = is_sound(law)
        if (reader%sound) then
            call add_energies(law%by_depth)
            call find_direct(law%by_depth)
            call find_direct(law%by_force)
        else
            call raise_unsound(error)
        end if
    end subroutine close_law

    pure subroutine raise_unsound(error)
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_file, "its numbers do not describe a contact law")
    end subroutine raise_unsound

    pure subroutine make_title(kind, title)
        integer, intent(in) :: kind
        character(len=:), allocatable, intent(out) :: title

        title = "mdrcontact compiled "//trim(kinds(kind))//" law, format "
    end subroutine make_title

    !> Title, version and checksum.
    pure subroutine check_frame(text, kind, error)
        character(len=*), intent(in) :: text
        integer, intent(in) :: kind
        type(error_t), allocatable, intent(inout) :: error
        character(len=:), allocatable :: title, other
        integer :: line_end, body

        body = len(text) - checksum_line
        call make_title(kind, title)
        call make_title(3 - kind, other)
        if (index(text, title) /= 1) then
            if (index(text, other) == 1) then
                call raise(error, error_file, "it holds a "//trim(kinds(3 - kind))//" law where a "//trim(kinds(kind))// &
                           " law is wanted")
            else
                call raise(error, error_file, "it is not a compiled "//trim(kinds(kind))//" law of mdrcontact")
            end if
            return
        end if
        line_end = index(text, new_line_character)
        if (line_end == 0) line_end = len(text) + 1
        if (text(len(title) + 1:line_end - 1) /= versions(kind)) then
            call raise(error, error_file, "its format has version "//text(len(title) + 1:min(line_end - 1, len(title) + 20))// &
                       ", and this library reads version "//versions(kind))
        else if (body < line_end) then
            call raise(error, error_file, "it is cut off")
        else if (text(body + 1:body + len(checksum_name)) /= checksum_name) then
            call raise(error, error_file, "it does not end with its checksum: it is cut off or was changed")
        else if (text(len(text) - 8:len(text) - 1) /= crc32_text(text(:body))) then
            call raise(error, error_file, "its checksum does not match its content: it is damaged")
        end if
    end subroutine check_frame

    !> Description and numbers of a text whose frame is sound.
    subroutine read_words(text, description, words, start, error)
        character(len=*), intent(in) :: text
        character(len=:), allocatable, intent(out) :: description
        integer(int64), allocatable, intent(out) :: words(:)
        integer, intent(out) :: start
        type(error_t), allocatable, intent(inout) :: error
        integer :: length, count, middle, line_end, i, stat

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
