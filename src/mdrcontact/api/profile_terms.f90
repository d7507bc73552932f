! SPDX-License-Identifier: GPL-3.0-or-later
!> The terms of a sum of indenter profiles, for C.
module mdrcontact_api_profile_terms
    use, intrinsic :: iso_c_binding, only: c_ptr
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_error, only: check_memory, error_t, raise_at
    use mdrcontact_profile, only: copy, profile_t
    use mdrcontact_profile_sum, only: profile_term_t
    implicit none (type, external)
    private
    public :: copy_terms

contains

    subroutine copy_terms(terms, copies, error)
        type(c_ptr), intent(in) :: terms(:)
        type(profile_term_t), allocatable, intent(out) :: copies(:)
        type(error_t), allocatable, intent(inout) :: error
        class(profile_t), pointer :: term
        integer :: i, stat

        allocate (copies(size(terms)), stat=stat)
        call check_memory(error, stat)
        do i = 1, size(terms)
            call open_handle(terms(i), "terms", term, error)
            if (allocated(error)) then
                call raise_at(error, i)
                return
            end if
            call copy(term, copies(i)%profile, error)
            if (allocated(error)) return
        end do
    end subroutine copy_terms

end module mdrcontact_api_profile_terms
