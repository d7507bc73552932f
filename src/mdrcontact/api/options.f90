! SPDX-License-Identifier: GPL-3.0-or-later
!> Structures of the caller that grow from version to version. They begin with their size, which the header of the caller sets: the
!> program may have been compiled with fewer members than the library has, or with more.
module mdrcontact_api_options
    use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int8_t, c_ptr, c_size_t, c_associated
    use mdrcontact_api_status, only: check_given
    use mdrcontact_error, only: error_invalid, error_t, raise
    implicit none (type, external)
    private
    public :: check_size, read_options, write_facts

    !> The size itself, what all sizes are multiples of, and more than any structure will have.
    integer(c_size_t), parameter :: smallest = 8_c_size_t, step = 4_c_size_t, largest = 4096_c_size_t

contains

    !> Overwrites the defaults with what the caller gave, which may be nothing. Members unknown to the caller stay 0.
    subroutine read_options(error, name, given, chosen, full)
        type(error_t), allocatable, intent(inout) :: error
        !> the argument's name
        character(len=*), intent(in) :: name
        !> the structure of the caller, or NULL
        type(c_ptr), intent(in) :: given
        !> address of a structure with the defaults
        type(c_ptr), intent(in) :: chosen
        !> its size
        integer(c_size_t), intent(in) :: full
        integer(c_int8_t), pointer :: from(:), to(:)
        integer(c_size_t) :: used

        if (allocated(error) .or. .not. c_associated(given)) return
        call check_size(error, name, given, full, used)
        if (allocated(error)) return
        call c_f_pointer(given, from, [used])
        call c_f_pointer(chosen, to, [used])
        to = from
    end subroutine read_options

    !> Writes to the structure of the caller, which check_size() has let pass, as many members as it has; its size stays.
    subroutine write_facts(given, made, used)
        type(c_ptr), intent(in) :: given
        !> address of the library's structure
        type(c_ptr), intent(in) :: made
        !> of check_size
        integer(c_size_t), intent(in) :: used
        integer(c_int8_t), pointer :: from(:), to(:)

        call c_f_pointer(made, from, [used])
        call c_f_pointer(given, to, [used])
        to(smallest + 1:) = from(smallest + 1:)
    end subroutine write_facts

    !> Size of the part of a structure that both caller and library define. The rest of the caller's must be 0.
    subroutine check_size(error, name, given, full, used)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        type(c_ptr), intent(in) :: given
        !> size of the library's structure
        integer(c_size_t), intent(in) :: full
        integer(c_size_t), intent(out) :: used
        integer(c_size_t), pointer :: size
        integer(c_int8_t), pointer :: bytes(:)
        character(len=20) :: found

        used = 0_c_size_t
        call check_given(error, name, c_associated(given))
        if (allocated(error)) return
        call c_f_pointer(given, size)
        if (size < smallest .or. size > largest .or. mod(size, step) /= 0) then
            write (found, "(i0)") size
            call raise(error, error_invalid, name//"->size = "//trim(found)//": it must be the size of the structure. "// &
                       "Initialize the structure with MDR_SIZED")
            return
        end if
        used = min(size, full)
        call c_f_pointer(given, bytes, [size])
        if (any(bytes(full + 1:) /= 0_c_int8_t)) then
            call raise(error, error_invalid, name//": it has members that are unknown to this library, because the header of "// &
                       "the program is newer. Leave them 0, or use the newer library")
        end if
    end subroutine check_size

end module mdrcontact_api_options
