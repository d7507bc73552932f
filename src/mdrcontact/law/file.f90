! SPDX-License-Identifier: GPL-3.0-or-later
!> A compiled law as a file: a first line that names the format and its version, the problem it was made from in words, the numbers
!> in hexadecimal (every bit, on any machine), and a checksum.
module mdrcontact_law_file
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_error, only: count_text, error_file, error_t, raise
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_crc32, only: crc32_text
    use mdrcontact_law_words, only: read_table, reader_t, table_words
    implicit none (type, external)
    private
    public :: save_law, load_law, law_to_text, law_from_text

    character(len=*), parameter :: new_line_character = achar(10)
    character(len=*), parameter :: title = "mdrcontact compiled contact law, format "
    character(len=*), parameter :: version = "1"
    character(len=*), parameter :: checksum_name = "crc32 "
    integer, parameter :: word_length = 17, checksum_line = len(checksum_name) + 8 + 1

contains

    !> Writes a law to a file, which it replaces.
    subroutine save_law(law, path, error)
        type(contact_law_t), intent(in) :: law
        !> name of the file
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text
        character(len=256) :: reason
        integer :: unit, stat

        call law_to_text(law, text)
        open (newunit=unit, file=path, access="stream", form="unformatted", action="write", status="replace", iostat=stat, &
              iomsg=reason)
        if (stat == 0) then
            write (unit, iostat=stat, iomsg=reason) text
            if (stat == 0) then
                close (unit, iostat=stat, iomsg=reason)
            else
                close (unit)
            end if
        end if
        if (stat /= 0) call raise(error, error_file, "the file "//path//" cannot be written: "//trim(reason))
    end subroutine save_law

    !> Reads a law from a file.
    subroutine load_law(law, path, error)
        type(contact_law_t), intent(out) :: law
        !> name of the file
        character(len=*), intent(in) :: path
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: text
        character(len=256) :: reason
        integer :: unit, stat, length

        open (newunit=unit, file=path, access="stream", form="unformatted", action="read", status="old", iostat=stat, iomsg=reason)
        if (stat == 0) then
            inquire (unit=unit, size=length, iostat=stat, iomsg=reason)
            if (stat == 0) allocate (character(len=max(length, 0)) :: text, stat=stat, errmsg=reason)
            if (stat == 0) read (unit, iostat=stat, iomsg=reason) text
            close (unit)
        end if
        if (stat /= 0) then
            call raise(error, error_file, "the file "//path//" cannot be read: "//trim(reason))
            return
        end if
        call law_from_text(law, text, error)
        if (allocated(error)) error%message = "the file "//path//" is refused: "//error%message
    end subroutine load_law

    !> The content of a law's file.
    pure subroutine law_to_text(law, text)
        type(contact_law_t), intent(in) :: law
        character(len=:), allocatable, intent(out) :: text
        integer(int64), allocatable :: words(:)
        integer :: i, start

        allocate (words, source=[transfer([law%tolerance, law%error], [0_int64]), int(law%solutions, int64), &
                                 table_words(law%by_depth), table_words(law%by_force)])
        text = title//version//new_line_character//count_text(len(law%description))//" characters of description, then "// &
               count_text(size(words))//" numbers"//new_line_character//law%description//new_line_character
        start = len(text)
        text = text//repeat(" ", word_length*size(words))
        do i = 1, size(words)
            write (text(start + 1:start + word_length), "(z16.16, a)") words(i), merge(new_line_character, " ", modulo(i, 8) == 0)
            start = start + word_length
        end do
        text = text//new_line_character
        text = text//checksum_name//crc32_text(text)//new_line_character
    end subroutine law_to_text

    !> The law in a file's content.
    subroutine law_from_text(law, text, error)
        type(contact_law_t), intent(out) :: law
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(out) :: error
        type(reader_t) :: reader
        integer :: start

        call check_frame(text, error)
        if (allocated(error)) return
        call read_words(text, law%description, reader%words, start, error)
        if (allocated(error)) return
        law%tolerance = reader%number()
        law%error = reader%number()
        law%solutions = reader%whole(0, huge(1))
        call read_table(reader, law%by_depth)
        if (reader%sound) call read_table(reader, law%by_force)
        if (.not. reader%sound .or. reader%next /= size(reader%words) + 1) then
            call raise(error, error_file, "its numbers do not describe a contact law")
        end if
    end subroutine law_from_text

    !> Title, version and checksum.
    pure subroutine check_frame(text, error)
        character(len=*), intent(in) :: text
        type(error_t), allocatable, intent(inout) :: error
        integer :: line_end, body

        body = len(text) - checksum_line
        if (index(text, title) /= 1) then
            call raise(error, error_file, "it is not a compiled contact law of mdrcontact")
            return
        end if
        line_end = index(text, new_line_character)
        if (line_end == 0) line_end = len(text) + 1
        if (text(len(title) + 1:line_end - 1) /= version) then
            call raise(error, error_file, "its format has version "//text(len(title) + 1:min(line_end - 1, len(title) + 20))// &
                       ", and this library reads version "//version)
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
        character(len=40) :: filler(4)
        integer :: length, count, i, stat

        start = index(text, new_line_character) + 1
        read (text(start:), *, iostat=stat) length, filler, count
        if (stat == 0) then
            start = start + index(text(start:), new_line_character)
            if (length < 0 .or. count < 1 .or. length > len(text) - start .or. count > len(text)/word_length) stat = 1
        end if
        if (stat == 0) then
            description = text(start:start + length - 1)
            start = start + length + 1
            if (start + word_length*count > len(text)) stat = 1
        end if
        if (stat == 0) allocate (words(count), stat=stat)
        if (stat == 0) then
            do i = 1, count
                read (text(start:start + 15), "(z16)", iostat=stat) words(i)
                if (stat /= 0) exit
                start = start + word_length
            end do
        end if
        if (stat /= 0) call raise(error, error_file, "its numbers cannot be read")
    end subroutine read_words

end module mdrcontact_law_file
