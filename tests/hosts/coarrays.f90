! SPDX-License-Identifier: GPL-3.0-or-later
!> A host compiled with -fcoarray=single, under which types are larger than in the library: the first call tells so. Compiled
!> without, they are the same.
program coarrays
    use mdrcontact, only: error_t, same_layout
    implicit none (type, external)
    type(error_t), allocatable :: error
    character(len=8) :: expected

    call get_command_argument(1, expected)
    print "(a, i0, a, l1)", "coarrays: error_t of ", storage_size(error), " bits, same layout: ", same_layout(storage_size(error))
    if (same_layout(storage_size(error)) .neqv. expected == "same") error stop "coarrays: another answer was expected"
end program coarrays
