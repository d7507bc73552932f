! SPDX-License-Identifier: GPL-3.0-or-later
!> Objects that other objects copy, and whether there is memory for a copy.
!>
!> gfortran copies the components of an object without a status: where there is no memory for one, the program ends. So the memory
!> is tried before.
module mdrcontact_object
    use, intrinsic :: iso_fortran_env, only: int8, int64
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: object_t, room, real_bytes

    !> Size of one real number.
    integer(int64), parameter :: real_bytes = storage_size(1.0_wp)/8

    !> An object that is immutable once created, and is copied by `room(from%bytes(), error)` and `allocate (to, source=from)`.
    type, abstract :: object_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
    contains
        !> what a copy takes for points, layers or cells [byte]; the rest is some MiB at most and is not counted
        procedure :: bytes => none
    end type object_t

contains

    pure recursive function none(self) result(bytes)
        class(object_t), intent(in) :: self
        integer(int64) :: bytes

        associate (unused => self)
        end associate
        bytes = 0
    end function none

    !> Raises unless so much memory can be allocated now. Another thread may still take it.
    subroutine room(bytes, error)
        integer(int64), intent(in) :: bytes
        type(error_t), allocatable, intent(inout) :: error
        ! volatile: gfortran leaves out an array that is not read
        integer(int8), allocatable, volatile :: trial(:)
        integer :: stat

        if (allocated(error) .or. bytes == 0) return
        allocate (trial(bytes), stat=stat)
        call check_memory(error, stat)
    end subroutine room

end module mdrcontact_object
