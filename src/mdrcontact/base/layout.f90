! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether a program lays out types as the library does. gfortran's -fcoarray adds hidden components to them, which module files do
!> not tell.
module mdrcontact_layout
    use mdrcontact_error, only: error_t
    implicit none (type, external)
    private
    public :: same_layout

contains

    !> Whether types have the size that they have in the library: the first call of a program that may be compiled with other
    !> options, `if (.not. same_layout(storage_size(error))) error stop "compile with -fcoarray=none"`.
    pure function same_layout(bits) result(answer)
        !> storage_size of a variable of type error_t
        integer, intent(in) :: bits
        logical :: answer
        type(error_t) :: own

        answer = bits == storage_size(own)
    end function same_layout

end module mdrcontact_layout
