! SPDX-License-Identifier: GPL-3.0-or-later
!> Copies of arrays that say where there is no memory for them. gfortran copies the components of an object without a status: who
!> holds arrays that grow with a caller's data copies them by this.
module mdrcontact_numerics_copy
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: copy_array

    !> An array that is not allocated has such a copy; nothing happens after an error.
    interface copy_array
        module procedure copy_reals, copy_matrix, copy_integers, copy_logicals
    end interface copy_array

contains

    pure subroutine copy_reals(from, to, error)
        real(wp), allocatable, intent(in) :: from(:)
        real(wp), allocatable, intent(out) :: to(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(error) .or. .not. allocated(from)) return
        allocate (to(size(from)), stat=stat)
        call check_memory(error, stat)
        if (stat == 0) to(:) = from
    end subroutine copy_reals

    pure subroutine copy_matrix(from, to, error)
        real(wp), allocatable, intent(in) :: from(:, :)
        real(wp), allocatable, intent(out) :: to(:, :)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(error) .or. .not. allocated(from)) return
        allocate (to(size(from, 1), size(from, 2)), stat=stat)
        call check_memory(error, stat)
        if (stat == 0) to(:, :) = from
    end subroutine copy_matrix

    pure subroutine copy_integers(from, to, error)
        integer, allocatable, intent(in) :: from(:)
        integer, allocatable, intent(out) :: to(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(error) .or. .not. allocated(from)) return
        allocate (to(size(from)), stat=stat)
        call check_memory(error, stat)
        if (stat == 0) to(:) = from
    end subroutine copy_integers

    pure subroutine copy_logicals(from, to, error)
        logical, allocatable, intent(in) :: from(:)
        logical, allocatable, intent(out) :: to(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(error) .or. .not. allocated(from)) return
        allocate (to(size(from)), stat=stat)
        call check_memory(error, stat)
        if (stat == 0) to(:) = from
    end subroutine copy_logicals

end module mdrcontact_numerics_copy
