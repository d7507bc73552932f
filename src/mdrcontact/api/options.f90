! SPDX-License-Identifier: GPL-3.0-or-later
!> Option structures of the caller. They begin with their size, which their ..._init function sets: a program that was compiled when
!> a structure had fewer members gives fewer, and the rest keep their defaults.
module mdrcontact_api_options
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int8_t, c_ptr, c_size_t
    use mdrcontact_error, only: error_invalid, error_t, raise
    implicit none (type, external)
    private
    public :: read_options

    !> The size itself, and what all sizes are multiples of.
    integer(c_size_t), parameter :: smallest = 8_c_size_t, step = 4_c_size_t

contains

    !> Overwrites the defaults with what the caller gave, which may be nothing.
    subroutine read_options(error, name, given, chosen, full)
        type(error_t), allocatable, intent(inout) :: error
        !> the argument's name
        character(len=*), intent(in) :: name
        !> the caller's structure, or NULL
        type(c_ptr), intent(in) :: given
        !> address of a structure with the defaults
        type(c_ptr), intent(in) :: chosen
        !> its size
        integer(c_size_t), intent(in) :: full
        integer(c_size_t), pointer :: size
        integer(c_int8_t), pointer :: from(:), to(:)
        character(len=20) :: found, most

        if (allocated(error) .or. .not. c_associated(given)) return
        call c_f_pointer(given, size)
        if (size < smallest .or. size > full .or. mod(size, step) /= 0) then
            write (found, "(i0)") size
            write (most, "(i0)") full
            call raise(error, error_invalid, name//"->size = "//trim(found)//" is not allowed: it must be what the structure's "// &
                       "_init function sets, at most "//trim(most))
            return
        end if
        call c_f_pointer(given, from, [size])
        call c_f_pointer(chosen, to, [size])
        to = from
    end subroutine read_options

end module mdrcontact_api_options
